//! How parameter lines bend, sampled on a grid.

use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::Vec3;

/// How the parameter lines of a surface bend at the places of a grid, by
/// [`FaceGeometry::line_bends`](crate::topology::FaceGeometry::line_bends).
///
/// ```
/// use cyclide::{Point3, Vec3, surface::{CyclidePatch, ParamSurface}, topology::FaceGeometry};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let octant = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)?;
/// let bends = octant.line_bends(&[0.0, 0.5, 1.0]);
/// // The equator of the unit sphere: the sagitta of a short arc is an eighth of the square of its length.
/// let speed = octant.jet(0.5, 0.0).ds.length();
/// assert!((bends.at(1, 0).unwrap().0[0] - speed * speed / 8.0).abs() < 1e-14);
/// // The last row is the pole, and the grid has no fourth.
/// assert!(bends.at(1, 2).unwrap().0[0] < 1e-14 && bends.at(1, 3).is_none());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LineBends {
    /// Places of the grid along one parameter.
    count: usize,
    form: Form,
}

#[derive(Debug, Clone, PartialEq)]
enum Form {
    /// All places of a line share two numbers, which is half of what the places would need.
    Lines {
        /// A factor of each place, s fastest.
        scale: Vec<f64>,
        /// What each of the s-lines, then of the t-lines has; times the factor, a sagitta.
        own: [Vec<f64>; 2],
        /// Component along the normal of the direction in which it bends.
        normal: [Vec<f64>; 2],
    },
    /// Sagittas along s and along t of each place, s fastest.
    Places([Vec<f64>; 2]),
}

impl LineBends {
    /// From the second derivatives at the places of a grid.
    pub(super) fn of_places(places: &[f64], jet: impl Fn(f64, f64) -> SurfaceJet) -> Self {
        let jets: Vec<SurfaceJet> =
            places.iter().flat_map(|&t| places.iter().map(move |&s| (s, t))).map(|(s, t)| jet(s, t)).collect();
        let of = |second: fn(&SurfaceJet) -> Vec3| jets.iter().map(|jet| 0.125 * second(jet).length()).collect();
        Self { count: places.len(), form: Form::Places([of(|jet| jet.dss), of(|jet| jet.dtt)]) }
    }

    /// From factors of the places, s fastest, and what each of the s-lines and of the t-lines has.
    pub(super) fn of_lines(scale: Vec<f64>, own: [Vec<f64>; 2], normal: [Vec<f64>; 2]) -> Self {
        Self { count: own[0].len(), form: Form::Lines { scale, own, normal } }
    }

    /// At the place `i` along s and `j` along t: the sagittas of the s-line and of the t-line over a width of 1 (they go with its
    /// square; lengths), and the cosine between the directions in which they bulge, 1 where it is not known. `None` outside the grid.
    #[must_use]
    pub fn at(&self, i: usize, j: usize) -> Option<([f64; 2], f64)> {
        (i < self.count && j < self.count).then(|| {
            let k = i + j * self.count;
            match &self.form {
                Form::Lines { scale, own, normal } => {
                    ([own[0][j] * scale[k], own[1][i] * scale[k]], normal[0][j] * normal[1][i])
                }
                Form::Places([along_s, along_t]) => ([along_s[k], along_t[k]], 1.0),
            }
        })
    }
}
