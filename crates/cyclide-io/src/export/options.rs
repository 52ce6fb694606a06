//! What may be chosen about a file.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::export::camera::Camera;

/// Which DXF.
///
/// ```
/// use cyclide::{Arc, Model, Point3};
/// use cyclide_io::{ExportOptions, Format, DxfVersion, export};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let options = ExportOptions { dxf_version: DxfVersion::R12, ..ExportOptions::default() };
/// let text = String::from_utf8(export(&model, Format::Dxf, &options)?.bytes)?;
/// assert!(text.contains("AC1009"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DxfVersion {
    /// AutoCAD 2000 (AC1015), with LWPOLYLINE, SPLINE and groups: the default.
    #[default]
    R2000,
    /// AutoCAD R12 (AC1009), with POLYLINE, for old machines; no splines.
    R12,
}

/// The curves of the edges between faces in STEP, and with them the faces: both are such that readers find edge and face
/// together at equal parameters, which booleans and fillets need.
///
/// ```
/// use cyclide::{DupinCyclide, Model};
/// use cyclide_io::{ExportOptions, Format, StepEdges, export};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let size = |step_edges| export(&model, Format::Step, &ExportOptions { step_edges, ..Default::default() }).map(|file| file.bytes.len());
/// assert!(size(StepEdges::Circles)? > 0 && size(StepEdges::Rational)? > 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StepEdges {
    /// Circles and lines, with radii and centres; planes, cylinders, cones, spheres and tori are such faces: the default.
    ///
    /// On rational faces these have their curves in the faces' parameters.
    #[default]
    #[serde(rename = "circle")]
    Circles,
    /// Rational B-splines, with which all faces but planes are rational: half as large a file.
    ///
    /// They have the parameter of the faces, and are lines where they are even.
    Rational,
}

/// Which faces bodies have in STEP.
///
/// ```
/// use cyclide::{DupinCyclide, Model};
/// use cyclide_io::{ExportOptions, Format, StepFaces, export};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let faces = |step_faces| {
///     let file = export(&model, Format::Step, &ExportOptions { step_faces, ..Default::default() })?;
///     Ok::<usize, cyclide_io::ExportError>(String::from_utf8_lossy(&file.bytes).matches("ADVANCED_FACE").count())
/// };
/// assert_eq!([StepFaces::Auto, StepFaces::Merged, StepFaces::Split].map(|form| faces(form).ok()), [Some(1), Some(1), Some(16)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StepFaces {
    /// `merged`, except for nets of panels: each panel of a `cyclidic-net` or a `principal-grid` and each `cyclide-patch` stays a face, as do
    /// those of their offsets and images. The default.
    #[default]
    Auto,
    /// One face for each plane, cylinder, cone, sphere and torus of a body where its loops allow.
    ///
    /// Arcs of one circle between two such faces are one edge, and faces that go all the way round have a seam.
    Merged,
    /// A face for each patch.
    Split,
}

/// The products of several objects in STEP.
///
/// ```
/// use cyclide::{Arc, Model, Point3};
/// use cyclide_io::{ExportOptions, Format, StepProducts, export};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let options = ExportOptions { step_products: StepProducts::One, ..ExportOptions::default() };
/// let text = String::from_utf8(export(&model, Format::Step, &options)?.bytes)?;
/// assert_eq!(text.matches("=PRODUCT(").count(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StepProducts {
    /// An assembly, but one product where curves and surfaces stand together: the default.
    ///
    /// FreeCAD 0.20 without its window crashes on such a file otherwise.
    #[default]
    Auto,
    /// One product per object in an assembly, with its name.
    Assembly,
    /// One product of all objects.
    One,
}

/// The cells of VTU.
///
/// ```
/// use cyclide::{CyclideVolume, Grading, Model, Point3, SphericalCube, Vec3, VolumeFrame};
/// use cyclide_io::{ExportOptions, Exporter, Format, Provenance, VtuCells};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z])?;
/// let model = Model::default().with_volume("block", CyclideVolume::new(&cube, VolumeFrame::Auto)?);
/// let halves = Grading::Uniform.places(2)?;
/// let divided = [Provenance { kind: "cyclide-volume", places: Some([halves.clone(), halves.clone(), halves]), ..Provenance::default() }];
/// let options = ExportOptions { vtu_cells: VtuCells::Linear, ..ExportOptions::default() };
/// let file = Exporter::with_provenance(&model, &divided)?.export(Format::Vtu, &options)?;
/// assert!(String::from_utf8(file.bytes)?.contains("NumberOfPoints=\"27\" NumberOfCells=\"8\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum VtuCells {
    /// Exact rational Bézier cells: the default.
    #[default]
    Bezier,
    /// Plain hexahedra with straight sides, of objects with blocks that are divided into cells.
    Linear,
}

/// How the numbers of VTU are written.
///
/// ```
/// use cyclide::{Arc, Model, Point3};
/// use cyclide_io::{ExportOptions, Format, VtuEncoding, export};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let options = ExportOptions { vtu_encoding: VtuEncoding::Base64, ..ExportOptions::default() };
/// let text = String::from_utf8(export(&model, Format::Vtu, &options)?.bytes)?;
/// assert!(text.contains("<AppendedData encoding=\"base64\">"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum VtuEncoding {
    /// Numbers in digits, that every program reads and people too: the default.
    #[default]
    Ascii,
    /// The bytes of the numbers, appended as base64: smaller and read faster.
    Base64,
}

/// What the surfaces of a picture are coloured by.
///
/// Curvatures are signed by the normal of the outer side: of a sphere seen from outside they are negative.
///
/// ```
/// use cyclide::{DupinCyclide, Model};
/// use cyclide_io::{ExportOptions, Format, PictureColour, export};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let picture = |png_colour| export(&model, Format::Png, &ExportOptions { png_colour, ..Default::default() }).map(|file| file.bytes);
/// assert!(picture(PictureColour::Gaussian)? != picture(PictureColour::Object)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PictureColour {
    /// Each object has a colour of its own: the default.
    #[default]
    Object,
    /// Gaussian curvature, the product of the principal ones.
    Gaussian,
    /// Mean curvature, half the sum of the principal ones.
    Mean,
    /// The larger principal curvature.
    K1,
    /// The smaller principal curvature.
    K2,
    /// Distance from the surface that was given: of nets the grid before make_circular, or the mesh of the principal-grid.
    Deviation,
    /// Of a principal-grid: its mesh with the directions of its lines of curvature, umbilics and the grids that were laid.
    Field,
}

/// Most pieces of one file of a small model if nothing else is asked for: about half a gigabyte of memory and a minute.
///
/// ```
/// assert_eq!(cyclide_io::DEFAULT_MOST_PIECES, 1_000_000);
/// ```
pub const DEFAULT_MOST_PIECES: usize = 1_000_000;

/// So many more for each piece of a curve and each patch: a large model is not refused for its size.
pub(crate) const PIECES_OF_EACH: usize = 16;

/// What may be chosen about a file.
///
/// ```
/// use cyclide::{Arc, Model, Point3};
/// use cyclide_io::{ExportOptions, Format, export};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let options = ExportOptions { svg_points: true, ..ExportOptions::default() };
/// assert!(export(&model, Format::Svg, &options)?.bytes.len() > export(&model, Format::Svg, &ExportOptions::default())?.bytes.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ExportOptions {
    /// Largest distance between the file's curve or mesh and the object where the format needs an approximation, in
    /// model units; `None` is 1e-5 of the model's diagonal for curves and 1e-4 for meshes.
    pub tolerance: Option<f64>,
    /// Most pieces of one file: cells of meshes and vertices of polylines together. They take one to two kilobytes each until the file
    /// is written and checked. `None` is [`DEFAULT_MOST_PIECES`] and 16 for each piece of a curve and each patch.
    pub max_pieces: Option<usize>,
    /// Name of the model, for formats that have a place for it; `None` is the name of the only object, or
    /// `cyclide`.
    pub title: Option<String>,
    /// DXF: rational curves as exact SPLINE entities instead of arcs within the tolerance. Many readers that cut
    /// or draw ignore the weights of a SPLINE; CAD systems do not.
    pub dxf_splines: bool,
    /// DXF: the version.
    pub dxf_version: DxfVersion,
    /// GLB: draw the edges of the patches as lines on their mesh.
    pub glb_edges: bool,
    /// STEP: the curves of the edges between faces.
    pub step_edges: StepEdges,
    /// STEP: which faces bodies have.
    pub step_faces: StepFaces,
    /// STEP: the products of several objects.
    pub step_products: StepProducts,
    /// SVG: draw the curvature comb.
    pub svg_comb: bool,
    /// SVG: draw the joints of the curves as dots.
    pub svg_points: bool,
    /// VTU: its cells.
    pub vtu_cells: VtuCells,
    /// VTU: how its numbers are written.
    pub vtu_encoding: VtuEncoding,
    /// PNG: leave out what is not the model: comb, title, unit, scale bar, legend, names and axes.
    pub png_plain: bool,
    /// PNG: width in pixels, 200 to 10000; `None` is 1600.
    pub png_width: Option<u32>,
    /// PNG: height in pixels, 150 to 10000; `None` is at most three quarters of the width.
    pub png_height: Option<u32>,
    /// PNG: draw the axes.
    pub png_axes: bool,
    /// PNG: what surfaces are coloured by.
    pub png_colour: PictureColour,
    /// PNG: names of objects, and numbers of the panels of nets, on them.
    pub png_labels: bool,
    /// PNG: where the model is looked at from; `None` is from above for curves of the plane, else from a side and above.
    pub camera: Option<Camera>,
}
