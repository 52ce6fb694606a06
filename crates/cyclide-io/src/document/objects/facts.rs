//! What is known of objects of single kinds besides their geometry.

use cyclide::{
    conformal::Mobius,
    construct::{BallCenters, ConvexPolyhedron, TeeBlendFacts, TorusMap},
    model::{CurveObject, Exactness},
    surface::{QuadGrid, Seam},
    volume::{Grading, GridQuality},
};
use cyclide_grids::{CircularMeshReport, PrincipalGridReport};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Facts about an object from its construction, besides the geometry.
///
/// ```
/// use cyclide_io::{Document, document::Facts};
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "tube", "balls": [[0, 0, 0, 2], [10, 0, 0, 3]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(matches!(&built[0].facts, Facts::Tubes(tubes) if tubes[0].radii == [2.0, 3.0]));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub enum Facts {
    /// Nothing but its geometry.
    #[default]
    None,
    /// Of a net over a grid.
    Net(Box<NetFacts>),
    /// Of grids along lines of curvature: what was found where they were laid.
    PrincipalGrid(Box<PrincipalGridReport>),
    /// Of a tee, a crossing or a contact blend, or of an image of one.
    Blends(BlendFacts),
    /// Of a polyhedron whose edges and corners were rounded.
    RoundedPolyhedron(Box<RoundedPolyhedron>),
    /// Of tubes, one for each body.
    Tubes(Vec<TubeFacts>),
    /// Of a smooth mesh.
    SmoothMesh(SmoothChoice),
    /// For a curve on a torus that was unrolled.
    Unrolled(UnrolledPlane),
    /// Of blocks that are divided.
    Cells(CellFacts),
}

macro_rules! of_variant {
    ($($(#[$about:meta])* $name:ident: $variant:ident => $type:ty;)*) => {
        impl Facts {
            $($(#[$about])*
            #[must_use]
            pub fn $name(&self) -> Option<&$type> {
                match self {
                    Self::$variant(facts) => Some(facts),
                    _ => None,
                }
            })*
        }
    };
}

of_variant! {
    /// What is known of a net.
    net: Net => NetFacts;
    /// What was found where grids were laid along lines of curvature.
    principal_grid: PrincipalGrid => PrincipalGridReport;
    /// What is known of blends.
    blends: Blends => BlendFacts;
    /// The polyhedron that was rounded.
    rounded_polyhedron: RoundedPolyhedron => RoundedPolyhedron;
    /// What is known of tubes.
    tubes: Tubes => [TubeFacts];
    /// What was chosen for a smooth mesh.
    smooth_mesh: SmoothMesh => SmoothChoice;
    /// What became of a curve that was laid flat.
    unrolled: Unrolled => UnrolledPlane;
    /// How blocks are divided.
    cells: Cells => CellFacts;
}

/// What is known of a net over a grid.
///
/// ```
/// use cyclide_io::{Document, document::Facts};
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": [[[0, 0], [1, 0]], [[0, 1], [1, 1]]]}}}"#.parse()?;
/// let built = document.build()?;
/// let Facts::Net(facts) = &built[0].facts else { unreachable!("it is a net") };
/// assert!(facts.seams.is_empty());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct NetFacts {
    /// Where opposite borders of its grid nearly coincide, as given.
    pub seams: Vec<Seam>,
    /// What it took to make its grid circular.
    pub circular: Option<CircularMeshReport>,
}

impl NetFacts {
    /// Of a grid that stays as it is.
    pub(in crate::document) fn as_given(seams: Vec<Seam>) -> Self {
        Self { seams, circular: None }
    }
}

/// What is known of the blends of a tee, a crossing or a contact blend.
///
/// ```
/// use cyclide_io::{Document, document::BlendFacts};
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// assert_eq!(document.build()?[0].facts.blends(), None::<&BlendFacts>);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BlendFacts {
    /// Each of them.
    pub blends: Vec<TeeBlendFacts>,
    /// The centers of the balls; an image has none of its own.
    pub centers: Option<Box<BallCenters>>,
}

/// How blocks are divided into cells.
///
/// ```
/// use cyclide_io::{Document, document::CellFacts};
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// assert_eq!(document.build()?[0].facts.cells(), None::<&CellFacts>);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CellFacts {
    /// The laws by which they are divided along s, t and u, with the parameter found for a first cell.
    pub laws: [Grading; 3],
    /// The quality of the cells.
    pub quality: GridQuality,
}

/// What is known of a curve of lowest degree through points.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "qb-interpolation", "points": [[0, 0], [1, 2], [3, 2], [5, 1], [6, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let found = built[0].contours[0].interpolation.as_ref().expect("by its type");
/// assert!(found.reach < 3.0 && found.parameters[4] == 1.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct InterpolationFacts {
    /// Degree of its quaternion polynomials; half of that of its rational form.
    pub degree: usize,
    /// The parameters of its points.
    pub parameters: Vec<f64>,
    /// Largest distance from the middle of the points, relative to theirs.
    pub reach: f64,
    /// The least that is left of the curve's weight at a point, of 1.
    pub attainability: f64,
}

/// A polyhedron and the radius of its rounding.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "smooth-polyhedron", "radius": 1, "points": [[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0], [0, 0, 2], [2, 0, 2], [0, 2, 2], [2, 2, 2]]}}}"#.parse()?;
/// let built = document.build()?;
/// let rounded = built[0].facts.rounded_polyhedron().expect("it is one");
/// assert_eq!((rounded.polyhedron.faces().len(), rounded.radius), (6, 1.0));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RoundedPolyhedron {
    /// The polyhedron.
    pub polyhedron: ConvexPolyhedron,
    /// The radius.
    pub radius: f64,
    /// How far its surface is from the points and faces given, at most.
    pub moved: f64,
}

/// What was chosen for a smooth mesh.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "normals": "sphere", "vertices": [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]]}}}"#.parse()?;
/// let built = document.build()?;
/// let choice = built[0].facts.smooth_mesh().expect("it is a smooth mesh");
/// assert_eq!((choice.normals, choice.polygons), ("sphere", 8));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothChoice {
    /// Where the normals at the vertices come from: `angle`, `sphere`, `file` or `given`.
    pub normals: &'static str,
    /// The angle above which edges are creases, radians.
    pub crease_angle: Option<f64>,
    /// Polygons of the mesh as given.
    pub polygons: usize,
}

/// What is known of a tube besides its body.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "tube", "balls": [[0, 0, 0, 2], [10, 0, 0, 3], [20, 5, 0, 2]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].facts.tubes().expect("it is one")[0].within, cyclide::model::Exactness::Exact);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TubeFacts {
    /// The least and the largest radius.
    pub radii: [f64; 2],
    /// What has these.
    pub radius_of: RadiusOf,
    /// Pieces that it consists of, arcs of balls or of sections.
    pub arcs: usize,
    /// How far it is from the tube of the law along the curve, and what that rests on.
    pub within: Exactness,
}

/// A curve on a torus that was unrolled, over all its contours.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [1, 1]}, "u": {"type": "unrolled", "of": "k"}}}"#.parse()?;
/// let built = document.build()?;
/// let plane = built[1].facts.unrolled().expect("it is laid flat");
/// assert!((plane.size[1] - 30.0 * std::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnrolledPlane {
    /// The map.
    pub map: TorusMap,
    /// Width and height of the plane of the whole torus.
    pub size: [f64; 2],
    /// How often the curve was cut.
    pub cuts: usize,
    /// The least and the largest factor by which the map multiplies lengths around the axis, on the curve.
    pub stretch: [f64; 2],
    /// Length of the curve on the torus, and of all lines in the plane.
    pub lengths: [f64; 2],
    /// Distance within which arcs approximate the curve in the plane.
    pub tolerance: f64,
}

/// What the curves of an image are images of, by one map: two of them make one, which doubles the degree of a rational curve once.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Unmapped {
    pub(in crate::document) curves: Vec<CurveObject>,
    pub(in crate::document) map: Mobius,
    /// Maps in it that are no similarities.
    pub(in crate::document) inversions: usize,
}

/// A grid of a file, and what the file calls its points.
pub(in crate::document) struct MeshNames {
    /// The file.
    pub name: String,
    pub grid: QuadGrid,
    /// The number of each point of the grid.
    pub numbers: Vec<usize>,
}

/// What has the radius of a tube along a curve.
///
/// ```
/// use cyclide_io::document::kinds::RadiusOf;
/// let word: RadiusOf = serde_json::from_str("\"balls\"")?;
/// assert_eq!((word, RadiusOf::default()), (RadiusOf::Balls, RadiusOf::Sections));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum RadiusOf {
    /// The circles in which planes perpendicular to the curve cut the tube.
    #[default]
    Sections,
    /// Balls that roll along the curve: the tube is their envelope. Where the radius changes, the circles of contact
    /// lie beside their centers, and the tube does not end where the curve does.
    Balls,
}
