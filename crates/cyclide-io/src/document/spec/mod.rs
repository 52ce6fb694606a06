//! The types of object a document may hold, field by field. Their doc comments are the published schema's text.

mod ball_centers;
mod circular;
mod comment;
mod conics;
mod contact_blends;
mod crossings;
mod curves;
mod derived;
mod fair;
mod grids;
mod interpolated;
mod motions;
mod nets;
mod nurbs;
mod polygon_mesh_file;
mod polyhedra;
mod principal;
mod radii;
mod radius_laws;
mod smooth;
mod surface_sources;
mod surfaces;
mod sweeps;
mod swept;
mod tees;
mod torus;
mod torus_numbers;
mod tubes;
mod volumes;

use std::collections::BTreeMap;

use cyclide::Units;
use schemars::JsonSchema;
use serde::Deserialize;

use super::kinds::Kind;

pub use ball_centers::{BallCentersSpec, CenterSurfaceSpec};
pub use circular::{BorderCurves, BorderSpec, BorderWord, MakeCircularOptions, MakeCircularSpec};
pub use comment::Comment;
pub use conics::{EllipseSpec, Hand, HelixSpec};
pub use contact_blends::{BlendRingSpec, BlendTubeSpec, ContactBlendSpec};
pub use crossings::{CrossingBlendSpec, CrossingLawSpec, CrossingPipeSpec, PipeCrossingSpec};
pub use curves::{
    ArcFitSpec, ArcSpec, ArcSplineSpec, AutoWord, BiarcSpec, CircleSpec, CircleSplineSpec, ClampedEnds, EndsSpec,
    FairFitSpec, FairTolerance, PolylineSpec,
};
pub use derived::{
    CutSpec, OffsetSpec, PipeSpec, PlaneSpec, RevolutionSpec, RotationSpec, ScaleSpec, SphereSpec, StepSpec,
    SupportStructureSpec, TransformSpec,
};
pub use fair::{FairEndPair, FairEndSpec, FairEndWord, FairEndsSpec, FairSplineSpec, StraightWord};
pub use grids::{
    CellLaw, CellsAlongSpec, CellsSpec, CoordinatePlanesSpec, CyclideGridSpec, GradedCellsSpec, WholeCyclideSpec,
};
pub use interpolated::{MoebiusContinuity, MoebiusSplineSpec, ParameterRule, ParametersSpec, QbInterpolationSpec};
pub use motions::{
    MotionKind, MotionSpec, PoseFile, PoseSource, PoseSpec, PoseTolerance, PositionCurve, StartSpec, SweptSurfaceSpec,
    TrajectorySpec,
};
pub use nets::{CyclideSpec, CyclidicNetSpec, FrameSpec, GridSource, LaidGrid, MeshFile};
pub use nurbs::NurbsSpec;
pub use polygon_mesh_file::PolygonMeshFile;
pub use polyhedra::SmoothPolyhedronSpec;
pub use principal::PrincipalGridSpec;
pub use radii::RadiiSpec;
pub use smooth::{NormalsSpec, SmoothMeshSpec, SphereBlendSpec};
pub use surface_sources::{HeightsSpec, NurbsSurfaceSpec};
pub use surfaces::CyclidePatchSpec;
pub use sweeps::{SweepEnds, SweepSpec};
pub use swept::{
    BridgeArcs, CircularSurfaceSpec, DiskSpec, EllipseBridgeSpec, PlateSpec, PlateWithNeckSpec, RuledSpec,
};
pub use tees::{PipeTeeSpec, TeeBlendSpec, TeeBranchSpec, TeeLawSpec, TeeMainSpec, TeeRadiusSpec};
pub use torus::{
    FamilySpec, TorusCircleSpec, TorusKnotSpec, TorusMethod, TorusQuarticSpec, TorusSeamSpec, TorusSource, TorusSpec,
    TorusSplineSpec, UnrolledSpec, WindingSpec,
};
pub use torus_numbers::{AnglePairs, FreeOr, RatePairs};
pub use tubes::{RadiusLawSpec, RadiusOf, TubeSpec};
pub use volumes::{CoordinateSurfacesSpec, CyclideVolumeSpec, LayersSpec};

/// A cyclide model: named curves and surfaces made of circles. Lengths are in the document's units and are never rescaled,
/// angles are in radians or say `degrees`.
#[derive(JsonSchema)]
#[schemars(rename = "cyclide model document", deny_unknown_fields)]
#[expect(dead_code, reason = "the shape of the whole document, for the schema; parsing goes object by object")]
pub(super) struct DocumentShape {
    /// Address of this schema, for editors; not read.
    #[schemars(rename = "$schema")]
    schema: Option<String>,
    /// What the author remarks; read and left aside.
    comment: Option<Comment>,
    /// Version of the document format.
    #[schemars(extend("const" = 1))]
    cyclide: u64,
    /// What one unit of the coordinates is.
    #[schemars(default)]
    units: Units,
    /// The objects by name.
    #[schemars(extend("propertyNames" = { "minLength": 1 }))]
    objects: BTreeMap<String, ObjectSpec>,
}

/// One object of a document.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(document.objects[0].1.type_word(), "circle");
/// assert!(built[0].bodies.is_empty());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Object")]
#[non_exhaustive]
pub enum ObjectSpec {
    /// A circular arc or straight segment.
    Arc(ArcSpec),
    /// A full circle.
    Circle(CircleSpec),
    /// An ellipse or an arc of one.
    Ellipse(EllipseSpec),
    /// A helix.
    Helix(HelixSpec),
    /// Two arcs between two points with given directions.
    Biarc(BiarcSpec),
    /// Segments through points, corners rounded by arcs.
    Polyline(PolylineSpec),
    /// Arcs through points, tangent-continuous.
    ArcSpline(ArcSplineSpec),
    /// The fewest arcs near points, tangent-continuous.
    ArcFit(ArcFitSpec),
    /// The fairest smooth curve through points.
    FairSpline(FairSplineSpec),
    /// The fairest smooth curve near points.
    FairFit(FairFitSpec),
    /// A smooth curve through points, blended from circles.
    CircleSpline(CircleSplineSpec),
    /// A rational B-spline curve.
    Nurbs(NurbsSpec),
    /// A local smooth curve through points that Möbius maps keep.
    MoebiusSpline(MoebiusSplineSpec),
    /// A rational curve of lowest degree through points.
    QbInterpolation(QbInterpolationSpec),
    /// A smooth curve on a torus through points.
    TorusSpline(TorusSplineSpec),
    /// A curve that runs evenly round a torus both ways.
    TorusKnot(TorusKnotSpec),
    /// See [`TorusQuarticSpec`].
    TorusQuartic(TorusQuarticSpec),
    /// A circle of a torus.
    TorusCircle(TorusCircleSpec),
    /// A curve of a torus laid flat.
    Unrolled(UnrolledSpec),
    /// A raised or sunk seam along a curve of a torus.
    TorusSeam(TorusSeamSpec),
    /// One patch of a Dupin cyclide, bounded by four circular arcs.
    CyclidePatch(CyclidePatchSpec),
    /// A whole Dupin cyclide.
    Cyclide(CyclideSpec),
    /// A smooth surface of patches over a grid of points.
    CyclidicNet(CyclidicNetSpec),
    /// Regular grids along the lines of curvature of a mesh.
    PrincipalGrid(PrincipalGridSpec),
    /// A block whose coordinate surfaces are cyclides that cross at right angles.
    CyclideVolume(CyclideVolumeSpec),
    /// Blocks in a grid.
    CyclideGrid(CyclideGridSpec),
    /// Blocks in layers over a net.
    Layers(LayersSpec),
    /// Surfaces inside blocks.
    CoordinateSurfaces(CoordinateSurfacesSpec),
    /// A convex polyhedron with its edges and corners rounded.
    SmoothPolyhedron(SmoothPolyhedronSpec),
    /// A smooth surface through the vertices of a triangle mesh.
    SmoothMesh(SmoothMeshSpec),
    /// A smooth patch over one triangle, shaped by three spheres.
    SphereBlend(SphereBlendSpec),
    /// A parallel surface, or the solid between.
    Offset(OffsetSpec),
    /// What a curve sweeps when it turns about an axis.
    Revolution(RevolutionSpec),
    /// The tube about a curve of arcs and segments.
    Pipe(PipeSpec),
    /// The tube of changing radius along a curve, or through balls.
    Tube(TubeSpec),
    /// A plane section along a path.
    Sweep(SweepSpec),
    /// A main pipe with branches, blended by rolling balls.
    PipeTee(PipeTeeSpec),
    /// Two pipes that pass each other, blended by a rolling ball.
    PipeCrossing(PipeCrossingSpec),
    /// A cylinder or cone blended with a sphere or a plate.
    ContactBlend(ContactBlendSpec),
    /// The ways of the centres of the balls of blends.
    BallCenters(BallCentersSpec),
    /// The surface of the centres of the balls between two pipes.
    CenterSurface(CenterSurfaceSpec),
    /// A pipe on a plate with a rounded neck.
    PlateWithNeck(PlateWithNeckSpec),
    /// Half circles between two ellipses.
    EllipseBridge(EllipseBridgeSpec),
    /// Arcs between two curves.
    CircularSurface(CircularSurfaceSpec),
    /// Straight lines between two curves.
    Ruled(RuledSpec),
    /// A motion of a body, through poses or along a curve.
    Motion(MotionSpec),
    /// The path of a point of a moving body.
    Trajectory(TrajectorySpec),
    /// What a curve of a moving body runs over.
    SweptSurface(SweptSurfaceSpec),
    /// An object mapped.
    Transform(TransformSpec),
    /// The edges of a surface as arcs.
    SupportStructure(SupportStructureSpec),
}

/// The field `type`: its word has been read before, to tell what the other fields are.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].provenance.kind, "circle");
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TypeWord;

impl<'de> Deserialize<'de> for TypeWord {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        serde::de::IgnoredAny::deserialize(deserializer).map(|_| Self)
    }
}

impl ObjectSpec {
    /// False for types of surfaces that STEP and JSON do not hold: there are meshes of them only.
    #[must_use]
    pub fn has_exact_form(word: &str) -> bool {
        !["smooth-mesh", "sphere-blend"].contains(&word)
    }
}

/// The functions that go through all types of object. A new type needs its line below and its starter.
macro_rules! object_types {
    ($($word:literal => $variant:ident),* $(,)?) => {
        impl ObjectSpec {
            /// The words of the types, in the order of the documentation.
            pub const TYPES: &'static [&'static str] = &[$($word),*];

            /// The word of the object's type.
            #[must_use]
            pub fn type_word(&self) -> &'static str {
                match self {
                    $(Self::$variant(_) => $word,)*
                }
            }

            /// True for construction geometry, which is built and reported but not written to files.
            #[must_use]
            pub fn is_construction(&self) -> bool {
                match self {
                    $(Self::$variant(spec) => spec.construction,)*
                }
            }

            /// What it says of itself.
            pub(super) fn kind(&self) -> &dyn Kind {
                match self {
                    $(Self::$variant(spec) => spec,)*
                }
            }

            /// A commented document with an object of this type, to start from; `None` if there is no such type.
            #[must_use]
            pub fn starter(word: &str) -> Option<&'static str> {
                match word {
                    $($word => Some(include_str!(concat!("../starters/", $word, ".json"))),)*
                    _ => None,
                }
            }

            /// Reads an object of the type `word`; `None` if there is no such type.
            pub(super) fn parse(word: &str, text: &str) -> Option<serde_json::Result<Self>> {
                match word {
                    $($word => Some(serde_json::from_str(text).map(Self::$variant)),)*
                    _ => None,
                }
            }
        }
    };
}

object_types! {
    "arc" => Arc,
    "circle" => Circle,
    "ellipse" => Ellipse,
    "helix" => Helix,
    "biarc" => Biarc,
    "polyline" => Polyline,
    "arc-spline" => ArcSpline,
    "arc-fit" => ArcFit,
    "fair-spline" => FairSpline,
    "fair-fit" => FairFit,
    "circle-spline" => CircleSpline,
    "nurbs" => Nurbs,
    "moebius-spline" => MoebiusSpline,
    "qb-interpolation" => QbInterpolation,
    "torus-spline" => TorusSpline,
    "torus-knot" => TorusKnot,
    "torus-quartic" => TorusQuartic,
    "torus-circle" => TorusCircle,
    "unrolled" => Unrolled,
    "torus-seam" => TorusSeam,
    "cyclide-patch" => CyclidePatch,
    "cyclide" => Cyclide,
    "cyclidic-net" => CyclidicNet,
    "principal-grid" => PrincipalGrid,
    "cyclide-volume" => CyclideVolume,
    "cyclide-grid" => CyclideGrid,
    "layers" => Layers,
    "coordinate-surfaces" => CoordinateSurfaces,
    "smooth-polyhedron" => SmoothPolyhedron,
    "smooth-mesh" => SmoothMesh,
    "sphere-blend" => SphereBlend,
    "offset" => Offset,
    "revolution" => Revolution,
    "pipe" => Pipe,
    "tube" => Tube,
    "sweep" => Sweep,
    "pipe-tee" => PipeTee,
    "pipe-crossing" => PipeCrossing,
    "contact-blend" => ContactBlend,
    "ball-centers" => BallCenters,
    "center-surface" => CenterSurface,
    "plate-with-neck" => PlateWithNeck,
    "ellipse-bridge" => EllipseBridge,
    "circular-surface" => CircularSurface,
    "ruled" => Ruled,
    "motion" => Motion,
    "trajectory" => Trajectory,
    "swept-surface" => SweptSurface,
    "transform" => Transform,
    "support-structure" => SupportStructure,
}
