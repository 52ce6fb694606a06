//! Options of a file.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::export::camera::Camera;

/// The DXF version.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, export::DxfVersion, formats::export};
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

/// The form of the edges between faces in STEP, and of the faces with them. In both forms, edge and face agree at equal parameters, as
/// booleans and fillets require.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, export::StepEdges, formats::export};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let size = |step_edges| export(&model, Format::Step, &ExportOptions { step_edges, ..Default::default() }).map(|file| file.bytes.len());
/// assert!(size(StepEdges::Circles)? > 0 && size(StepEdges::Rational)? > 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StepEdges {
    /// Circles and lines, with radii and centers; planes, cylinders, cones, spheres and tori are faces of that type: the
    /// default.
    ///
    /// On rational faces, the edges also have curves in the parameters of the faces.
    #[default]
    #[serde(rename = "circle")]
    Circles,
    /// Rational B-splines, where all faces except planes are rational: half the file size.
    ///
    /// They have the parameter of the faces, and are lines where the parameter is uniform.
    Rational,
}

/// How bodies are divided into faces in STEP.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, export::StepFaces, formats::export};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let faces = |step_faces| {
///     let file = export(&model, Format::Step, &ExportOptions { step_faces, ..Default::default() })?;
///     Ok::<usize, cyclide_io::export::ExportError>(String::from_utf8_lossy(&file.bytes).matches("ADVANCED_FACE").count())
/// };
/// assert_eq!([StepFaces::Auto, StepFaces::Merged, StepFaces::Split].map(|form| faces(form).ok()), [Some(1), Some(1), Some(16)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StepFaces {
    /// `merged`, except for nets of panels: each panel of a `cyclidic-net` or a `principal-grid` and each `cyclide-patch` remains a face,
    /// also in their offsets and images. The default.
    #[default]
    Auto,
    /// One face for each plane, cylinder, cone, sphere and torus of a body, if its loops allow it.
    ///
    /// Arcs of one circle between two such faces are one edge, and closed faces have a seam.
    Merged,
    /// One face for each patch.
    Split,
}

/// How several objects become products in STEP.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, export::StepProducts, formats::export};
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
    /// An assembly, but one product if there are both curves and surfaces: the default.
    ///
    /// Otherwise FreeCAD 0.20 crashes on such a file when it runs without a window.
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
/// use cyclide::{Point3, Vec3, model::Model, volume::{CyclideVolume, Grading, SphericalCube, VolumeFrame}};
/// use cyclide_io::{ExportOptions, Exporter, Format, export::{Provenance, VtuCells}};
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
    /// Linear hexahedra with straight sides, for objects with blocks that are divided into cells.
    Linear,
}

/// How numbers are written in VTU.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, export::VtuEncoding, formats::export};
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
    /// Decimal text, which every program and people can read: the default.
    #[default]
    Ascii,
    /// Binary numbers, appended as base64: smaller and faster to read.
    Base64,
}

/// The quantity that colors the surfaces of a picture.
///
/// The sign of curvatures refers to the outer normal: on a sphere seen from outside they are negative.
///
/// ```
/// use cyclide::{model::Model, surface::DupinCyclide};
/// use cyclide_io::{ExportOptions, Format, export::PictureColour, formats::export};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::default().with_surface("ring", ring);
/// let picture = |png_colour| export(&model, Format::Png, &ExportOptions { png_colour, ..Default::default() }).map(|file| file.bytes);
/// assert!(picture(PictureColour::Gaussian)? != picture(PictureColour::Object)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PictureColour {
    /// Each object has its own color: the default.
    #[default]
    Object,
    /// Gaussian curvature, the product of the principal curvatures.
    Gaussian,
    /// Mean curvature, half the sum of the principal curvatures.
    Mean,
    /// The larger principal curvature.
    K1,
    /// The smaller principal curvature.
    K2,
    /// Distance from the given surface: for nets the grid before make_circular, or the mesh of the principal-grid.
    Deviation,
    /// For a principal-grid: its mesh with the directions of its lines of curvature, umbilics and grids.
    Field,
}

/// Default limit of the pieces in a file of a small model: about a quarter of a gigabyte of memory and some seconds.
///
/// ```
/// assert_eq!(cyclide_io::export::DEFAULT_MOST_PIECES, 1_000_000);
/// ```
pub const DEFAULT_MOST_PIECES: usize = 1_000_000;

/// So many more for each piece of a curve and each patch: a large model is not refused for its size.
pub(crate) const PIECES_OF_EACH: usize = 16;

/// Options of a file.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, formats::export};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let options = ExportOptions { svg_points: true, ..ExportOptions::default() };
/// assert!(export(&model, Format::Svg, &options)?.bytes.len() > export(&model, Format::Svg, &ExportOptions::default())?.bytes.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ExportOptions {
    /// Largest distance between the object and its curve or mesh in the file, if the format requires an
    /// approximation, in model units; `None` is 1e-5 of the diagonal of the model for curves and 1e-4 for meshes.
    pub tolerance: Option<f64>,
    /// Largest number of pieces in a file, mesh cells and polyline vertices together. Each takes one to two kilobytes until the file
    /// is written and checked. `None` is [`DEFAULT_MOST_PIECES`] plus 16 for each curve piece and each patch.
    pub max_pieces: Option<usize>,
    /// Title of the model, for formats that contain one; `None` is the name of the only object, or `cyclide`.
    pub title: Option<String>,
    /// DXF: rational curves as exact SPLINE entities instead of arcs within the tolerance. Many cutting and drawing
    /// programs ignore the weights of a SPLINE; CAD systems do not.
    pub dxf_splines: bool,
    /// DXF: the version.
    pub dxf_version: DxfVersion,
    /// GLB: draw the edges of the patches as lines on their mesh.
    pub glb_edges: bool,
    /// STEP: the form of the edges between faces.
    pub step_edges: StepEdges,
    /// STEP: how bodies are divided into faces.
    pub step_faces: StepFaces,
    /// STEP: how several objects become products.
    pub step_products: StepProducts,
    /// SVG: draw the curvature comb.
    pub svg_comb: bool,
    /// SVG: draw the joints of the curves as dots.
    pub svg_points: bool,
    /// VTU: the kind of cells.
    pub vtu_cells: VtuCells,
    /// VTU: how numbers are written.
    pub vtu_encoding: VtuEncoding,
    /// PNG: only the model, without comb, title, unit, scale bar, legend, names and axes.
    pub png_plain: bool,
    /// PNG: width in pixels, 200 to 10000; `None` is 1600.
    pub png_width: Option<u32>,
    /// PNG: height in pixels, 150 to 10000; `None` is at most three quarters of the width.
    pub png_height: Option<u32>,
    /// PNG: draw the axes.
    pub png_axes: bool,
    /// PNG: the quantity that colors surfaces.
    pub png_colour: PictureColour,
    /// PNG: labels with names of objects and numbers of the panels of nets.
    pub png_labels: bool,
    /// PNG: the direction of view; `None` is from above for plane curves, otherwise from a side and above.
    pub camera: Option<Camera>,
}
