//! Bodies as a file holds them.

use cyclide::{
    Point3,
    curve::Circle,
    model::ChainPiece,
    rational::{NurbsCurve, RationalBezierSurface, RationalBezierVolume},
    surface::PatchKind,
};

/// A rational patch of a file of surfaces.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let file = export(&model, Format::Json, &ExportOptions::default())?;
/// let content = read_back(Format::Json, &file.bytes)?;
/// assert!(content.patches.len() >= 16 && content.patches.iter().all(|patch| patch.body == 0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FilePatch {
    /// The body to which it belongs, numbered from 0 through all objects.
    pub body: usize,
    /// The shell of the body.
    pub shell: usize,
    /// True if the outer side is that of `f_s × f_t`.
    pub outward: bool,
    /// The patch, over [0, 1] in both parameters.
    pub surface: RationalBezierSurface,
}

/// A rational volume of a file.
///
/// ```
/// use cyclide::{Point3, Vec3, model::Model, volume::{CyclideVolume, SphericalCube, VolumeFrame}};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z])?;
/// let model = Model::default().with_volume("block", CyclideVolume::new(&cube, VolumeFrame::Auto)?);
/// let content = read_back(Format::Vtu, &export(&model, Format::Vtu, &ExportOptions::default())?.bytes)?;
/// assert!(content.volumes.len() == 1 && content.patches.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FileVolume {
    /// The body to which it belongs, numbered from 0 through all objects.
    pub body: usize,
    /// The volume, over [0, 1] in its three parameters.
    pub volume: RationalBezierVolume,
}

/// A body of a file: a solid, or one or more shells.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let file = export(&model, Format::Step, &ExportOptions::default())?;
/// let content = read_back(Format::Step, &file.bytes)?;
/// assert!(content.bodies[0].solid && content.bodies[0].shells.len() == 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FileBody {
    /// True for solids.
    pub solid: bool,
    /// The shells; for a solid the outer one first, then the boundaries of its voids.
    pub shells: Vec<FileShell>,
}

/// A shell of a file.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let file = export(&model, Format::Step, &ExportOptions::default())?;
/// let content = read_back(Format::Step, &file.bytes)?;
/// assert!(content.bodies[0].shells[0].closed);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FileShell {
    /// True if the file calls it closed.
    pub closed: bool,
    /// False if the body uses the other sides of the faces.
    pub forward: bool,
    /// Its faces.
    pub faces: Vec<FileFace>,
}

/// A face of a file.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let file = export(&model, Format::Step, &ExportOptions::default())?;
/// let content = read_back(Format::Step, &file.bytes)?;
/// let faces = &content.bodies[0].shells[0].faces;
/// // A whole torus: both of its seams, each there and back.
/// assert!(faces.len() == 1 && faces[0].edges.len() == 4 && faces[0].holes.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FileFace {
    /// The surface.
    pub surface: FileSurface,
    /// True if the face's normal is that of its surface.
    pub same_sense: bool,
    /// The outer loop, counter-clockwise against the face's normal.
    pub edges: Vec<FileEdge>,
    /// The loops around its holes, clockwise.
    pub holes: Vec<Vec<FileEdge>>,
}

impl FileFace {
    /// All loops, the outer one first.
    pub fn loops(&self) -> impl Iterator<Item = &[FileEdge]> {
        std::iter::once(self.edges.as_slice()).chain(self.holes.iter().map(Vec::as_slice))
    }
}

/// The surface of a face of a file.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let file = export(&model, Format::Step, &ExportOptions::default())?;
/// let content = read_back(Format::Step, &file.bytes)?;
/// let faces = &content.bodies[0].shells[0].faces;
/// assert!(faces.iter().all(|face| matches!(face.surface, cyclide_io::check::FileSurface::Analytic(_))));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FileSurface {
    /// A rational Bézier surface.
    Rational(RationalBezierSurface),
    /// A plane, sphere, cylinder, cone or torus; its own normal points outward.
    Analytic(PatchKind),
}

/// An edge as a loop uses it.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let file = export(&model, Format::Step, &ExportOptions::default())?;
/// let content = read_back(Format::Step, &file.bytes)?;
/// let edges = &content.bodies[0].shells[0].faces[0].edges;
/// // Whole circles from their only vertex.
/// assert!(edges.iter().all(|edge| edge.vertices[0] == edge.vertices[1]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FileEdge {
    /// Number of the edge in the file.
    pub edge: u64,
    /// Numbers of its vertices, start and end.
    pub vertices: [u64; 2],
    /// Points of its vertices.
    pub ends: [Point3; 2],
    /// True if the loop runs along the edge, false if against it.
    pub forward: bool,
    /// The curve from start to end.
    pub curve: FileCurve,
    /// The same in the parameters of the surface of the face (with third coordinate 0), over the angle of a circle or
    /// the length of a line; `None` if the file does not contain it.
    pub parameter_curve: Option<NurbsCurve>,
}

/// The curve of an edge of a file.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, check::FileCurve, formats::{export, read_back}};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let file = export(&model, Format::Step, &ExportOptions::default())?;
/// let content = read_back(Format::Step, &file.bytes)?;
/// let edges = &content.bodies[0].shells[0].faces[0].edges;
/// assert!(edges.iter().all(|edge| matches!(edge.curve, FileCurve::Circle(_))));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FileCurve {
    /// A line, an arc or a spline.
    Piece(ChainPiece),
    /// A full circle, from its only vertex.
    Circle(Circle),
}

impl FileEdge {
    /// Vertices in the direction of the loop.
    pub(crate) fn oriented(&self) -> [u64; 2] {
        let [start, end] = self.vertices;
        if self.forward { [start, end] } else { [end, start] }
    }
}
