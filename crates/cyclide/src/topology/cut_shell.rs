//! Shells in smaller faces, as files need them: regular, with positive weights, or halved where others ask for it; with what
//! each face is of the shell that was cut.

use super::split::Cuts;
use super::{FaceGeometry as _, FacePart, FaceSurface, Shell, ShellEdge, ShellFace, Side};
use crate::base::bounds::Aabb;
use crate::error::{Error, NumberError, PatchError, Result, ShellError};

/// Smallest cosine of half an edge's angle: edges stay below 150 degrees.
const SMALLEST_COSINE: f64 = 0.25;
/// Smallest weight of the middle of a patch, relative to the geometric mean of its corners' weights.
const SMALLEST_MIDDLE: f64 = 0.0625;
/// A strip is halved this often at most: sixteen halvings leave 3e-5 of an edge.
const MOST_PASSES: usize = 16;
/// Faces of a cut shell at most, or so many times those given: they take two kilobytes each with what belongs to them.
const MOST_FACES: usize = 500_000;
const MOST_GROWTH: usize = 8;
/// So many faces are few, whatever they were cut from.
const FEW_FACES: usize = 512;
/// Shortest edge that other programs tell from a point, relative to the box of the vertices.
const SHORTEST_EDGE: f64 = 1e-13;

/// A shell that may have been cut, and which part of which face of the uncut one each of its faces is. The parts of a face
/// tile it; the surface of each is that of the face, with parameters that grow in proportion.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::CyclidePatch, topology::{CutShell, Shell}};
/// // A ring of 315 degrees: its edges are halved twice.
/// let at = |r: f64, u: f64| Point3::new(r * u.cos(), r * u.sin(), 0.0);
/// let end = 315.0_f64.to_radians();
/// let corners = [at(1.0, 0.0), at(1.0, end), at(2.0, 0.0), at(2.0, end)];
/// let ring = Shell::from_surface(CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::X)?)?;
/// let cut = CutShell::from(ring).with_positive_weights()?;
/// assert_eq!(cut.shell().faces().len(), 4);
/// let last = cut.parts()[3];
/// assert_eq!((last.face, last.s[1], last.t), (0, 1.0, [0.0, 1.0]));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CutShell {
    shell: Shell,
    parts: Vec<FacePart>,
}

impl From<Shell> for CutShell {
    /// The shell as it is: every face is all of itself.
    fn from(shell: Shell) -> Self {
        let parts = (0..shell.faces.len()).map(FacePart::whole).collect();
        Self { shell, parts }
    }
}

impl CutShell {
    /// The shell in its faces so far.
    #[must_use]
    pub fn shell(&self) -> &Shell {
        &self.shell
    }

    /// Which part of which face of the uncut shell each face is.
    #[must_use]
    pub fn parts(&self) -> &[FacePart] {
        &self.parts
    }

    /// The shell in its faces so far, without what they were cut from.
    #[must_use]
    pub fn into_shell(self) -> Shell {
        self.shell
    }

    /// The same surface in faces without a parameter line of one point inside: strips of faces are cut there, and the
    /// parts of a singular face meet in that point, which is a side of each. Neighbors of a singular face are cut
    /// with it.
    ///
    /// # Errors
    /// As [`halved`](Self::halved).
    pub fn with_regular_faces(mut self) -> Result<Self> {
        let most = self.most_faces();
        // Every pass cuts each strip once; a patch has two such lines at most in each direction.
        for _ in 0..MOST_PASSES {
            let shell = &self.shell;
            let (mut cuts, along) = (Cuts::none(shell), shell.faces_along_edges());
            for (index, face) in shell.faces.iter().enumerate() {
                for (direction, places) in [face.surface.singular_s(), face.surface.singular_t()].iter().enumerate() {
                    if let Some(&at) = places.first() {
                        shell.mark(&along, &mut cuts, index, direction, at);
                    }
                }
            }
            if cuts.is_empty() {
                break;
            }
            self = self.cut(&cuts, most)?;
        }
        Ok(self)
    }

    /// The same surface in faces whose nine real weights are all positive and whose edges are below 150 degrees:
    /// strips of faces are halved until all are. Edges and vertices stay shared bit for bit, sides of one point stay so.
    ///
    /// # Errors
    /// `patch-through-infinity` where sixteen halvings do not suffice; `too-many-pieces` (faces); `short-edge` if an edge is shorter than 1e-13 of
    /// the shell, as in cyclides that are nearly singular.
    pub fn with_positive_weights(self) -> Result<Self> {
        let cut = self.halved(|_, face| too_wide(&face.surface), MOST_PASSES)?;
        if !cut.shell.faces.iter().all(|face| too_wide(&face.surface) == [false, false]) {
            return Err(PatchError::ThroughInfinity { s: 0.5, t: 0.5 }.into());
        }
        check_long_edges(&cut.shell)?;
        Ok(cut)
    }

    /// The same surface with strips of faces halved, at the middle of their widest side, until `wide` names no direction
    /// (s, t) of a face of the shell so far that is to be halved, `most` times at most. Edges and vertices stay shared bit for bit, sides of
    /// one point stay so.
    ///
    /// # Errors
    /// `parameter-out-of-range` beyond the range of the kernel's numbers; `too-many-pieces` beyond half a million faces and
    /// eight times those given; `short-edge` where a part of a face would be a point.
    pub fn halved(self, wide: impl Fn(&Shell, &ShellFace) -> [bool; 2], most: usize) -> Result<Self> {
        let cap = self.most_faces();
        self.halved_below(wide, most, (cap, false))
    }

    /// As [`halved`](Self::halved), but left as it is so far where the next halving would make more than this many faces of one: where halving does not help.
    ///
    /// # Errors
    /// `parameter-out-of-range`, `short-edge`.
    pub fn halved_while_few(
        self,
        wide: impl Fn(&Shell, &ShellFace) -> [bool; 2],
        most: usize,
        of_one: usize,
    ) -> Result<Self> {
        let cap = self.most_faces().min(of_one.saturating_mul(self.shell.faces.len()).max(FEW_FACES));
        self.halved_below(wide, most, (cap, true))
    }

    fn halved_below(
        mut self,
        wide: impl Fn(&Shell, &ShellFace) -> [bool; 2],
        most: usize,
        (cap, stops_there): (usize, bool),
    ) -> Result<Self> {
        for _ in 0..most {
            let shell = &self.shell;
            let mut found: Vec<(usize, usize, WidestSide)> = Vec::new();
            for (index, face) in shell.faces.iter().enumerate() {
                let wide = wide(shell, face);
                if wide != [false, false] {
                    let sides = widest_sides(&face.surface);
                    found.extend([0, 1].into_iter().filter(|&d| wide[d]).map(|d| (index, d, sides[d])));
                }
            }
            if found.is_empty() {
                break;
            }
            // The widest side decides where its strip is cut.
            found.sort_by(|a, b| a.2.cosine.total_cmp(&b.2.cosine));
            let (mut cuts, along) = (Cuts::none(shell), shell.faces_along_edges());
            for (face, direction, side) in found {
                shell.mark(&along, &mut cuts, face, direction, side.middle);
            }
            match self.cut(&cuts, cap) {
                Err(Error::Number(NumberError::TooManyPieces { .. })) if stops_there => break,
                cut => self = cut?,
            }
        }
        Ok(self)
    }

    /// One cut more, into `most` faces at most.
    fn cut(&self, cuts: &Cuts, most: usize) -> Result<Self> {
        let (shell, parts) = self.shell.cut(cuts, most)?;
        let parts = parts.iter().map(|part| part.within(&self.parts[part.face])).collect();
        Ok(Self { shell, parts })
    }

    /// How many faces a shell may have that is cut from this one.
    fn most_faces(&self) -> usize {
        MOST_FACES.max(MOST_GROWTH.saturating_mul(self.shell.faces.len()))
    }
}

impl Shell {
    /// The shell of [`CutShell::with_regular_faces`].
    ///
    /// # Errors
    /// As [`CutShell::with_regular_faces`].
    pub fn with_regular_faces(&self) -> Result<Self> {
        CutShell::from(self.clone()).with_regular_faces().map(CutShell::into_shell)
    }

    /// The shell of [`CutShell::with_positive_weights`].
    ///
    /// # Errors
    /// As [`CutShell::with_positive_weights`].
    pub fn with_positive_weights(&self) -> Result<Self> {
        CutShell::from(self.clone()).with_positive_weights().map(CutShell::into_shell)
    }

    /// The shell of [`CutShell::halved`].
    ///
    /// # Errors
    /// As [`CutShell::halved`].
    pub fn halved(&self, wide: impl Fn(&Self, &ShellFace) -> [bool; 2], most: usize) -> Result<Self> {
        CutShell::from(self.clone()).halved(wide, most).map(CutShell::into_shell)
    }
}

/// Refuses edges that are points for other programs.
fn check_long_edges(shell: &Shell) -> Result<()> {
    let limit = SHORTEST_EDGE * Aabb::of_points(shell.vertices.iter().copied()).map_or(0.0, Aabb::diagonal);
    for (edge, ShellEdge { curve, .. }) in shell.edges.iter().enumerate() {
        let length = curve.start().distance(curve.end());
        if length < limit {
            return Err(ShellError::ShortEdge { edge, length, limit }.into());
        }
    }
    Ok(())
}

/// The widest of the two sides of a patch in a direction.
#[derive(Debug, Clone, Copy)]
struct WidestSide {
    /// Cosine of half its angle; for a side of one point, of its weights.
    cosine: f64,
    /// The face's parameter in its middle.
    middle: f64,
}

/// The widest sides of a surface along s and along t; rational ones are halved where others ask for it only, in the middle.
fn widest_sides(surface: &FaceSurface) -> [WidestSide; 2] {
    let Some(patch) = surface.patch() else { return [WidestSide { cosine: 1.0, middle: 0.5 }; 2] };
    let w = patch.real_weights();
    let corner = |k: usize| w[2 * (k & 1)][k & 2].sqrt();
    let side = |side: Side| {
        let [a, b] = side.corners().map(corner);
        let middle = match side {
            Side::Bottom => w[1][0],
            Side::Top => w[1][2],
            Side::Left => w[0][1],
            Side::Right => w[2][1],
        };
        // Where both ends weigh the same is the middle of the arc.
        WidestSide { cosine: middle / (a * b), middle: a / (a + b) }
    };
    [0, 1].map(|direction| {
        let [k, l] = Side::along(direction).map(side);
        if k.cosine <= l.cosine { k } else { l }
    })
}

/// The directions in which a surface has to be halved for positive weights, which rational ones have.
fn too_wide(surface: &FaceSurface) -> [bool; 2] {
    let Some(patch) = surface.patch() else { return [false; 2] };
    let widest = widest_sides(surface);
    let wide = widest.map(|side| !(side.cosine >= SMALLEST_COSINE));
    let w = patch.real_weights();
    let middle = w[1][1] / (w[0][0] * w[2][0] * w[0][2] * w[2][2]).powf(0.25);
    if wide == [false, false] && !(middle >= SMALLEST_MIDDLE) {
        let wider = usize::from(widest[1].cosine < widest[0].cosine);
        return [0, 1].map(|direction| direction == wider);
    }
    wide
}
