//! Bodies, their shells, and the faces and edges of these: what files, meshes and pictures are made of.
//!
//! | topic | names |
//! |---|---|
//! | volumes | [`BlockShell`], [`BlockFace`] |
//! | bodies made from curves | [`Body::ruled`], [`Body::circular`] |
//! | topology | [`Body`], [`Shell`], [`ShellFace`], [`ShellEdge`], [`FaceEdge`], [`Side`], [`CutShell`], [`FacePart`], [`FaceSurface`], [`FaceGeometry`], [`CellDistances`], [`LineBends`], [`EdgeCurve`], [`surface_joints`], [`SurfaceJoint`] |

mod bilinear;
mod block_faces;
mod bounds;
mod check;
mod cut_shell;
mod edge_curve;
mod face_geometry;
mod face_part;
mod face_surface;
mod joints;
mod measure;
mod outer_side;
mod parts;
mod sew;
mod sewing;
mod side;
mod split;
mod thick;
mod transform;
mod volume;

pub use block_faces::BlockFace;
pub(crate) use check::has_ratio;
pub use cut_shell::CutShell;
pub use edge_curve::EdgeCurve;
pub use face_geometry::{CellDistances, FaceGeometry, LineBends};
pub use face_part::FacePart;
pub use face_surface::FaceSurface;
pub use joints::{SurfaceJoint, surface_joints};
pub(crate) use sewing::Sewing;
pub use side::Side;
pub use volume::BlockShell;

use crate::base::vector::Point3;
use crate::error::Result;

/// An edge of a shell: a curve between two vertices, with the parameter that every face along it has.
///
/// ```
/// use cyclide::surface::DupinCyclide;
/// let shell = DupinCyclide::new(3.0, 0.0, 1.0)?.to_shell()?;
/// assert!(shell.edges().iter().all(|edge| edge.curve.start() == shell.vertices()[edge.start]));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ShellEdge {
    /// Vertex at parameter 0.
    pub start: usize,
    /// Vertex at parameter 1.
    pub end: usize,
    /// The curve; its ends are the vertices, bit for bit.
    pub curve: EdgeCurve,
}

/// A side of a face on an edge of the shell.
///
/// ```
/// use cyclide::surface::DupinCyclide;
/// let shell = DupinCyclide::new(3.0, 0.0, 1.0)?.to_shell()?;
/// let sides = shell.faces()[0].sides;
/// assert!(sides.into_iter().flatten().all(|side| side.edge < shell.edges().len()));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FaceEdge {
    /// Index of the edge.
    pub edge: usize,
    /// True if the face's parameter grows with that of the edge.
    pub forward: bool,
}

/// A face: a four-sided surface in its shell. A side may be one point.
///
/// ```
/// use cyclide::{surface::DupinCyclide, topology::Side};
/// let shell = DupinCyclide::new(3.0, 0.0, 1.0)?.to_shell()?;
/// assert!(shell.faces()[0].same_sense && shell.faces()[0].side(Side::Bottom).is_some());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ShellFace {
    /// The surface.
    pub surface: FaceSurface,
    /// The sides t=0, t=1 (along s), s=0, s=1 (along t); `None` for a side that is one point.
    pub sides: [Option<FaceEdge>; 4],
    /// True if the shell's outer side is that of `f_s × f_t`.
    pub same_sense: bool,
}

/// Faces that share edges, edges that share vertices; connected, and closed if every edge has two faces.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::CyclidePatch, topology::Shell};
/// let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [2.0, 1.0, 0.0]].map(Point3::from);
/// let shell = Shell::from_surface(CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y)?)?;
/// assert!(!shell.is_closed() && (shell.area() - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Shell {
    pub(crate) vertices: Vec<Point3>,
    pub(crate) edges: Vec<ShellEdge>,
    pub(crate) faces: Vec<ShellFace>,
}

impl Shell {
    /// A shell from its vertices, edges and faces, all relations checked.
    ///
    /// # Errors
    /// `not-a-shell`, with the kind and the index of the item and what is wrong: an index out of range; an edge whose
    /// ends are not its vertices bit for bit; a side whose edge joins other vertices or has another parameter (weight
    /// ratios that differ by more than 1e-9, points by more than 1e-9 of the side where one of both is not an arc); a
    /// rational surface or curve whose weights are not all positive; a side without edge that is not one point; an edge with more than two
    /// faces, or with two faces that run along it in the same direction; faces that do not hang together through
    /// edges; no face at all.
    pub fn new(vertices: Vec<Point3>, edges: Vec<ShellEdge>, faces: Vec<ShellFace>) -> Result<Self> {
        let mut shell = Self { vertices, edges, faces };
        shell.check()?;
        // Of thousands of blocks what lists grew by would be a good part of all memory.
        shell.vertices.shrink_to_fit();
        shell.edges.shrink_to_fit();
        shell.faces.shrink_to_fit();
        Ok(shell)
    }

    /// The shell of one surface with its (up to four) edges. Corners that are equal are one vertex.
    ///
    /// # Errors
    /// As [`FaceGeometry::s_line`].
    pub fn from_surface(surface: impl Into<FaceSurface>) -> Result<Self> {
        let surface = surface.into();
        let (exact, corners) = (surface.patch().is_some(), surface.corners());
        // A pole repeats a corner: the vertex is the same one.
        let mut vertices: Vec<Point3> = Vec::with_capacity(4);
        let index = corners.map(|p| {
            vertices.iter().position(|v| check::same_point(exact, *v, p)).unwrap_or_else(|| {
                vertices.push(p);
                vertices.len() - 1
            })
        });
        let (mut edges, mut sides) = (Vec::with_capacity(4), [None; 4]);
        for side in Side::ALL {
            let [start, end] = side.corners().map(|corner| index[corner]);
            let curve = side.curve_of(&surface)?;
            if start != end {
                edges.push(ShellEdge { start, end, curve });
                sides[side as usize] = Some(FaceEdge { edge: edges.len() - 1, forward: true });
            }
        }
        Ok(Self { vertices, edges, faces: vec![ShellFace { surface, sides, same_sense: true }] })
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> &[Point3] {
        &self.vertices
    }

    /// The edges.
    #[must_use]
    pub fn edges(&self) -> &[ShellEdge] {
        &self.edges
    }

    /// The faces.
    #[must_use]
    pub fn faces(&self) -> &[ShellFace] {
        &self.faces
    }

    /// How many faces each edge has.
    #[must_use]
    pub fn edge_uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.edges.len()];
        for side in self.faces.iter().flat_map(|f| f.sides.iter().flatten()) {
            uses[side.edge] += 1;
        }
        uses
    }

    /// For each edge the faces along it, with the side.
    #[must_use]
    pub fn faces_along_edges(&self) -> Vec<Vec<(usize, Side)>> {
        let mut along = vec![Vec::new(); self.edges.len()];
        for (index, face) in self.faces.iter().enumerate() {
            for (side, edge) in face.edges() {
                along[edge.edge].push((index, side));
            }
        }
        along
    }

    /// The same faces with the other side outside.
    #[must_use]
    pub fn flipped(mut self) -> Self {
        for face in &mut self.faces {
            face.same_sense = !face.same_sense;
        }
        self
    }

    /// True if every edge has two faces.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.edge_uses().iter().all(|&n| n == 2)
    }
}

/// One body: an open shell, or a solid bounded by a closed outer shell and any number of closed voids inside it.
///
/// ```
/// use cyclide::surface::DupinCyclide;
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.to_bodies([4, 4])?.remove(0);
/// assert!(torus.is_solid() && torus.voids.is_empty());
/// assert!((torus.outer.volume() - 6.0 * std::f64::consts::PI.powi(2)).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// The shell, or the outer shell of a solid.
    pub outer: Shell,
    /// Shells of the hollows of a solid; their outer sides point into the hollow.
    pub voids: Vec<Shell>,
}

impl Body {
    /// True if the body is a solid: every shell is closed.
    #[must_use]
    pub fn is_solid(&self) -> bool {
        self.shells().all(Shell::is_closed)
    }

    /// All shells, the outer one first.
    pub fn shells(&self) -> impl Iterator<Item = &Shell> {
        std::iter::once(&self.outer).chain(&self.voids)
    }
}
