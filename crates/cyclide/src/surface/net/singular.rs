//! Patches of a net that are singular or flipped. How the patches meet is measured on its shell by `surface_joints`.

use super::CyclidicNet;
use crate::surface::patch::CyclidePatch;

/// A patch in which a parameter line shrinks to a point.
///
/// ```
/// use cyclide::surface::DupinCyclide;
/// // Inwards beyond the smallest radius of its tube the ring turns inside out in part.
/// let ring = DupinCyclide::new(2.0, 0.7, 1.1)?.nets([4, 4])?.remove(0);
/// assert!(ring.singular_patches().is_empty() && !ring.offset(-1.0)?.singular_patches().is_empty());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SingularPatch {
    /// The quad, along s and along t.
    pub quad: [usize; 2],
    /// Parameters s of the lines along t that are one point.
    pub singular_s: Vec<f64>,
    /// Parameters t of the lines along s that are one point.
    pub singular_t: Vec<f64>,
}

impl CyclidicNet {
    /// The patches inside which a parameter line shrinks to a point, with these parameters.
    #[must_use]
    pub fn singular_patches(&self) -> Vec<SingularPatch> {
        let singular = |(quad, patch): ([usize; 2], CyclidePatch)| {
            let found = SingularPatch { quad, singular_s: patch.singular_s(), singular_t: patch.singular_t() };
            (!found.singular_s.is_empty() || !found.singular_t.is_empty()).then_some(found)
        };
        self.patches_with_quads().filter_map(singular).collect()
    }

    /// The quads whose `f_s × f_t` is against the normal at a corner: one family of their lines runs against the frame,
    /// as in an offset beyond a center of curvature. None in a net made of a grid, nor in a whole cyclide.
    #[must_use]
    pub fn flipped_patches(&self) -> Vec<[usize; 2]> {
        let against = |patch: &CyclidePatch| {
            let (q1, q2) = (patch.q1(), patch.q2());
            [q1[0] * q2[0], q1[0] * q2[2], q1[2] * q2[0], q1[2] * q2[2]].iter().any(|q| *q < 0.0)
        };
        self.patches_with_quads().filter(|(_, patch)| against(patch)).map(|(quad, _)| quad).collect()
    }
}
