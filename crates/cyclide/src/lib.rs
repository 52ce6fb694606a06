//! `cyclide`: a geometric-modeling kernel whose primitive is the circle.
//!
//! Curves and surfaces are made of circles and are exact: an [`Arc`] is two points and one quaternion, a [`CyclidePatch`]
//! four points and one frame. A circle spline in its rational variant is a rational curve, a patch a rational surface:
//! they leave the kernel as [`NurbsCurve`] and [`RationalBezierSurface`] without any tolerance.
//!
//! Everything is `f64`, lengths are unitless, angles are radians, parameters run over `[0, 1]`. The kernel has no
//! I/O, no clock and no global tolerance; bad input gets an [`Error`] with the item, the measure and the limit. Files (STEP, DXF, SVG, GLB, OBJ, STL, JSON,
//! CSV, PNG) are written by the crate `cyclide-io` from a [`Model`]; small programs to start from are in its folder `examples`.
//!
//! An arc through three points, its measures and its exact rational form:
//! ```
//! use cyclide::{Arc, Point3};
//! let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
//! let arc = Arc::from_three_points(a, b, c)?;
//! assert!((arc.length() - std::f64::consts::PI).abs() < 1e-15);
//! let nurbs = arc.to_nurbs(cyclide::DEFAULT_PIECE_ANGLE)?; // two quadratic pieces, positive weights
//! assert_eq!((nurbs.degree(), nurbs.span_count()), (2, 2));
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! The fairest closed curve through points, with continuous curvature, exact as a B-spline:
//! ```
//! use cyclide::{CircleSpline, Exactness, FairSplineOptions, Lower, Point3, joints};
//! let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [6.0, 5.0, 2.0], [2.0, 6.0, 0.5]].map(Point3::from);
//! let spline = CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() })?;
//! assert!(joints(&spline).iter().all(|joint| joint.curvature_jump < 1e-13));
//! let (_chain, exactness) = spline.to_chain(1e-6)?;
//! assert_eq!(exactness, Exactness::Exact);
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! A patch of a Dupin cyclide from four points on a circle and one frame; its parameter lines are circles, its offset is
//! such a patch again, and so is its exact rational form:
//! ```
//! use cyclide::{CyclidePatch, ParamSurface, Point3, Vec3};
//! let corners = [[-4.0, -3.0, 0.0], [4.0, -3.0, 0.0], [-3.0, 4.0, 0.0], [3.0, 4.0, 0.0]].map(Point3::from);
//! let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::new(8.0, -1.0, 4.0), Vec3::new(-1.0, 4.0, 3.0))?;
//! let offset = patch.offset(0.2)?;
//! let (p, normal) = (patch.point(0.3, 0.6), patch.unit_normal(0.3, 0.6));
//! assert!(offset.point(0.3, 0.6).distance(p + normal * 0.2) < 1e-14);
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! The fewest tangent arcs within a tolerance of points, with a certificate:
//! ```
//! use cyclide::{ArcFit, ArcFitOptions, Point3};
//! let wave = |i: i32| Point3::new(0.1 * f64::from(i), (0.1 * f64::from(i)).sin(), 0.0);
//! let fit = ArcFit::new(&(0..=60).map(wave).collect::<Vec<_>>(), &ArcFitOptions::new(0.01))?;
//! assert!(fit.certificate().deviation <= 0.01 && fit.path().arcs().len() < 10);
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! A solid: the pipe about a run with a rounded corner, hollow.
//! ```
//! use cyclide::{ArcPath, Pipe, Point3};
//! let run = [[0.0, 0.0, 0.0], [40.0, 0.0, 0.0], [40.0, 30.0, 0.0]].map(Point3::from);
//! let spine = ArcPath::rounded_polyline(&run, false, &[0.0, 8.0, 0.0])?;
//! let pipe = Pipe::new(3.0)?.with_wall(0.5)?.body(&spine)?;
//! let ring = std::f64::consts::PI * (3.0 * 3.0 - 2.5 * 2.5);
//! assert!(pipe.is_solid() && (pipe.outer.volume() - ring * spine.length()).abs() < 1e-9);
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # By topic
//!
//! Types of documents go by these names here: `polyline` [`ArcPath::rounded_polyline`], `arc-spline` [`ArcPath::spline`], `fair-spline` [`CircleSpline::fair`], `smooth-polyhedron` [`ConvexPolyhedron`],
//! `plate-with-neck` [`NeckBlend`], `transform` [`Mobius`], `offset` [`SurfaceObject::offset`], `support-structure` [`SurfaceObject::edge_arcs`].
//!
//! | topic | where it is |
//! |---|---|
//! | points, directions, frames, boxes | [`Point3`], [`Vec3`], [`Point2`], [`Vec2`], [`Quat`], [`Frame`], [`Aabb`] |
//! | maps | [`Mobius`] (inversions, similarities), [`Conformal`] (what they keep), [`HPoint`], [`Sphere`] |
//! | circles and arcs | [`Circle`], [`Ellipse`], [`Helix`], [`Arc`], [`Arc4`], [`Biarc`] ([`BiarcRule`]), [`ArcPath`], [`DEFAULT_PIECE_ANGLE`] |
//! | curves through points | [`CircleSpline::fair`] ([`FairSplineOptions`], [`FairEnd`], [`blends_by_turn`]), [`CircleSpline::from_points`] ([`CircleSplineOptions`], [`SplineEnds`]), [`ArcPath::spline`] ([`ArcSplineOptions`], [`estimate_tangents`]), [`ArcPath::rounded_polyline`], [`QbSpline::through_points`] ([`MoebiusSplineOptions`], [`circle_tangents`]), [`QbInterpolation`] ([`NodeParameters`], [`QbNode`]), [`BlendSegment`] ([`BlendVariant`], [`BlendLaw`]), [`corners_by_angle`] |
//! | quotients of quaternion polynomials | [`QbCurve`] ([`QbReach`]), [`QbSpline`] |
//! | what points are | [`outline_corners`] |
//! | curves near points | [`ArcFit`] (fewest arcs: [`ArcFitOptions`], [`FitTarget`], [`Effort`], [`FitCertificate`]), [`FairFit`] (fairest curve: [`FairFitOptions`], [`Noise`], [`Outliers`], [`Heights`], [`FairFitCertificate`]), [`certify_arc`] ([`ArcCertificate`]), [`feasible_bulges`] ([`BulgeIntervals`]), [`curvature_intervals`] |
//! | evaluation | [`ParamCurve::point`], [`ParamCurve::jet`], [`ParamSurface::point`], [`ParamSurface::jet`], [`CurveJet`], [`SurfaceJet`]; what a piece is: [`PieceForm`], [`PieceHull`] |
//! | measures of curves | [`length()`], [`resample`], [`ArcLength`], [`closest_point`] ([`ClosestPoint`]), [`CurveIndex`], [`farthest_point`] ([`FarthestPoint`]), [`bounds()`] |
//! | frames along curves | [`CurveFrames`] ([`FrameRule`], [`ClosedTwist`], [`CurveFrame`]) |
//! | continuity and fairness | [`joints`] ([`Joint`]), [`extreme_curvature`] ([`ExtremeCurvature`]), [`bending_energy`], [`tight_places`] ([`TightPlace`]), [`cusps`] ([`CurveCusp`]), [`plane_normal`], [`curvature_comb`], [`fairness()`] ([`Fairness`]), [`wavering()`], [`wavering_against()`] ([`Wavering`], [`RoundedTurns`], [`CORNER_ANGLE`]) |
//! | exact rational forms | [`NurbsCurve`], [`RationalBezier`], [`RationalBezierSurface`], [`RationalBezierVolume`], [`RationalRun`] |
//! | patches, nets, whole cyclides | [`CyclidePatch`] ([`PatchKind`], [`ImplicitForm`], [`PatchRow`], [`PatchLocation`]), [`CyclidicNet`] ([`NetFrame`], [`SingularPatch`]), [`DupinCyclide`] ([`CyclideKind`]), [`QuadGrid`] ([`GridCell`], [`GridClosing`], [`RingClosing`], [`StripClosing`]), nets round extraordinary vertices [`NetLayout`], [`QuadLayout`] ([`LayoutPiece`], [`RoundVertex`]), [`Seam`] ([`SeamMeasure`]), strips along edges [`NormalStrip`] ([`StripForm`]) |
//! | volumes | [`CyclideGrid`], [`CyclideVolume`] ([`VolumeFrame`], [`FoldVerdict`], [`VolumeLocation`], [`VolumeMeasure`], [`VolumeMetric`], [`VolumeRow`], parts [`BlockShell`], [`BlockFace`]), [`StructuredGrid`] ([`Grading`], [`FineEnd`], [`CellQuality`], [`GridQuality`], [`MOST_CELLS`]), [`SphericalCube`], [`miquel_point`], [`ParamVolume`], [`VolumeJet`] |
//! | quads made circular, grids along lines of curvature | the crate `cyclide-grids` |
//! | tori and curves on them | [`Torus`], [`TorusSpline`] (through points, torus knots, closed quartics, circles: [`TorusSplineOptions`], [`TorusTangent`], [`TorusWinding`]), laid flat ([`TorusMap`], [`UnrollOptions`], [`UnrolledSpline`]), [`TorusSeam`], [`TorusPiece`], [`TorusSegment`], [`TorusJunction`], [`TorusClasses`], [`CircleFamily`], [`QuarticType`], [`SegmentMethod`], [`ProjectiveBiarc`], [`TwoTypeBiarc`] |
//! | rolling balls, canal surfaces | [`SkewCylinders`], [`NaturalQuadric`], [`QuadricPair`] ([`PairKind`]), [`RollingBall`] ([`ContactPartner`]), [`CanalPatch`] ([`CanalPart`], [`CharacteristicCircle`]) |
//! | surfaces over triangles | [`SmoothMesh`] ([`VertexNormals`], [`NormalWeights`], [`SmoothEdge`], [`SmoothMeasure`], [`SmoothComparison`]), [`SmoothTriangle`], [`SphereBlend`], [`TriangleSurface`], [`TrianglePatch`], [`SideLine`] |
//! | bodies made from curves | [`Revolution`], [`Pipe`] ([`PipeEnds`]), [`Sweep`] ([`SweepOptions`], [`SweepFrame`]), [`TaperedTube`] ([`RadiusLaw`]), [`Tube`] ([`Ball`]), [`NeckBlend`] ([`NeckBody`], [`NeckSide`], [`NeckVariant`], [`PlateShape`]), [`PipeTee`] ([`TeeMain`], [`TeeBranch`], [`TeeBlend`], [`TeeEnds`], [`MadeTee`], [`TeeBlendFacts`]), [`PipeCrossing`] ([`CrossingPipe`], [`CrossingSide`], [`MadeCrossing`]), [`ContactBlend`] ([`BlendTube`], [`BlendBase`], [`MadeContactBlend`]), [`RingBlend`] ([`BlendRing`]), [`BallCenters`], [`EllipseBridge`], [`Body::ruled`], [`Body::circular`], [`RailSurface`] |
//! | motions | [`Motion`], [`RationalMotion`], [`CubicMotions`], [`ScrewMotion`], [`DecoupledMotion`] ([`MotionTolerance`], [`MotionDeviation`]), [`RationalForm`], [`TimedPose`] ([`PoseTimes`]), [`Pose`], [`DualQuat`], [`StudyPoint`], [`MotionJet`], [`MotionExtremes`] ([`MotionPlace`], [`SpeedPeak`], [`MotionReversal`], [`OffChords`], [`FastPlace`], [`SpeedKind`]), [`Timing`] ([`TimeLaw`]), [`MovingBody`] ([`Schedule`], [`BodyMesh`]), [`SweptSurface`] |
//! | bodies made from solids | [`ConvexPolyhedron`] ([`PolyhedronEdge`]), [`SphericalPolygon`] |
//! | topology | [`Body`], [`Shell`], [`ShellFace`], [`ShellEdge`], [`FaceEdge`], [`Side`], [`CutShell`], [`FacePart`], [`FaceSurface`], [`FaceGeometry`] ([`CellDistances`], [`LineBends`]), [`EdgeCurve`], [`surface_joints`] ([`SurfaceJoint`]) |
//! | panels for a workshop | [`PanelMeasures`] ([`PanelSide`], [`PanelSideForm`], [`CurvatureExtreme`]), [`NearestSurfaces`] ([`NearSurface`]), [`Moulds`] ([`Mould`], [`MouldMember`], [`MouldShape`]), [`Congruences`] ([`CongruenceClass`], [`CongruentPanel`]), [`FlatPattern`] |
//! | polylines and meshes | [`flatten`], [`flatten_into`], [`flatten_places`], [`flatten_within`], [`tessellate`], [`tessellate_all`], [`tessellate_within`], [`SurfaceMesh`] ([`MeshFace`], [`MeshCorner`], [`MeshSource`]), [`SmoothTessellation`], [`parameter_lines`] ([`ParameterLine`], [`LineKind`]), [`MOST_PIECES`] |
//! | models for files | [`Model`], [`Item`], [`Geometry`], [`CurveObject`], [`GridObject`], [`SurfaceObject`], [`Lower`] ([`Lowered`], [`Exactness`], [`Correspondence`], [`CurvePlace`], [`Span`]), [`CurveChain`], [`ChainPiece`], [`Units`] |
//! | what is refused, what is remarked | [`Error`] (by subject: [`NumberError`], [`PointError`], [`ArcError`], [`CurveError`], [`InterpolationError`], [`NurbsError`], [`FitError`], [`PatchError`], [`GridError`], [`PrincipalGridError`], [`ShellError`], [`ProfileError`], [`PipeError`], [`TubeError`], [`TeeError`], [`CrossingError`], [`ContactError`], [`BallError`], [`BridgeError`], [`PolyhedronError`], [`TriangleError`], [`MeshError`], [`TorusError`], [`PoseError`], [`MotionError`], [`VolumeError`], [`PartError`]), [`ErrorItem`], [`FoldRemedy`], [`SurfaceFault`], [`GridCellFault`], [`JoinFault`], [`LayoutFault`], [`Result`], [`reasons`], [`Warning`] (by subject: [`PointWarning`], [`CurveWarning`], [`FitWarning`], [`NoiseWarning`], [`MotionWarning`], [`PoseFitWarning`], [`PrincipalGridWarning`], [`CircularWarning`], [`NetWarning`], [`MeshWarning`], [`PolyhedronWarning`], [`BodyWarning`], [`VolumeWarning`]; [`SpikeRemedy`], [`SwingPart`], [`WaverRemedy`], [`InvertedCause`]), [`ShapeChange`], [`ShortNumber`] |

mod base;
mod batch;
mod conformal;
mod construct;
mod curve;
mod error;
mod mesh;
mod model;
mod motion;
mod panel;
mod rational;
mod shape_change;
mod short_number;
mod surface;
mod table;
mod topology;
mod volume;
mod warning;

#[doc(hidden)]
pub mod workspace;

pub use base::bounds::Aabb;
pub use base::frame::Frame;
pub use base::jet::CurveJet;
pub use base::planar::{Point2, Vec2};
pub use base::quat::Quat;
pub use base::surface_jet::SurfaceJet;
pub use base::vector::{Point3, Vec3};
pub use base::volume_jet::VolumeJet;
pub use conformal::hpoint::HPoint;
pub use conformal::mobius::{Conformal, Mobius};
pub use conformal::sphere::Sphere;
pub use construct::{
    ArcCertificate, ArcFit, ArcFitOptions, ArcSplineOptions, Biarc, BiarcRule, BulgeIntervals, Effort, FairEnd,
    FairSplineOptions, FitCertificate, FitTarget, blends_by_turn, certify_arc, curvature_intervals, estimate_tangents,
    feasible_bulges,
};
pub use construct::{Ball, RadiusLaw, TaperedTube, Tube};
pub use construct::{BallCenters, BlendBase, BlendRing, BlendTube, ContactBlend, MadeContactBlend, RingBlend};
pub use construct::{ConvexPolyhedron, PolyhedronEdge, SphericalPolygon};
pub use construct::{CrossingPipe, CrossingSide, MadeCrossing, PipeCrossing};
pub use construct::{Ellipse, Helix, Sweep, SweepFrame, SweepOptions, outline_corners};
pub use construct::{EllipseBridge, NeckBlend, NeckBody, NeckSide, NeckVariant, PlateShape};
pub use construct::{FairFit, FairFitCertificate, FairFitOptions, Heights, Noise, Outliers};
pub use construct::{MadeTee, PipeTee, TeeBlend, TeeBlendFacts, TeeBranch, TeeEnds, TeeMain};
pub use construct::{MoebiusSplineOptions, NodeParameters, QbInterpolation, QbNode, circle_tangents};
pub use construct::{Pipe, PipeEnds, RailSurface, RationalRun, Revolution, SweptSurface, TorusSeam};
pub use construct::{
    ProjectiveBiarc, TorusMap, TorusSplineOptions, TorusTangent, TorusWinding, TwoTypeBiarc, UnrollOptions,
    UnrolledSpline,
};
pub use curve::{Arc, Arc4, ArcPath, Circle, ClosestPoint, DEFAULT_PIECE_ANGLE, ParamCurve, PieceForm, PieceHull};
pub use curve::{ArcLength, CurveIndex, ExtremeCurvature, Joint};
pub use curve::{
    BlendLaw, BlendSegment, BlendVariant, CircleSpline, CircleSplineOptions, SplineEnds, corners_by_angle,
};
pub use curve::{CORNER_ANGLE, Fairness, RoundedTurns, Wavering, fairness, plane_normal, wavering, wavering_against};
pub use curve::{
    ClosedTwist, CurveCusp, CurveFrame, CurveFrames, FrameRule, TightPlace, bending_energy, cusps, tight_places,
};
pub use curve::{Correspondence, CurvePlace, Span};
pub use curve::{FarthestPoint, farthest_point};
pub use curve::{QbCurve, QbReach, QbSpline};
pub use curve::{bounds, closest_point, curvature_comb, extreme_curvature, joints, length, resample};
pub use error::{
    ArcError, BallError, BridgeError, ContactError, CrossingError, CurveError, FitError, GridError, InterpolationError,
    MeshError, MotionError, NumberError, NurbsError, PartError, PatchError, PipeError, PointError, PolyhedronError,
    PoseError, PrincipalGridError, ProfileError, ShellError, TeeError, TorusError, TriangleError, TubeError,
    VolumeError,
};
pub use error::{Error, ErrorItem, FoldRemedy, GridCellFault, JoinFault, LayoutFault, Result, SurfaceFault, reasons};
pub use mesh::{LineKind, ParameterLine, parameter_lines};
pub use mesh::{
    MOST_PIECES, MeshCorner, MeshFace, MeshSource, SmoothTessellation, SurfaceMesh, flatten, flatten_into,
    flatten_places, flatten_within, tessellate, tessellate_all, tessellate_within,
};
pub use model::{
    ChainPiece, CurveChain, CurveObject, Exactness, Geometry, GridObject, Item, Lower, Lowered, Model, SurfaceObject,
    Units,
};
pub use motion::{
    BodyMesh, CubicMotions, DecoupledMotion, DualQuat, FastPlace, Motion, MotionDeviation, MotionExtremes, MotionJet,
    MotionPlace, MotionReversal, MotionTolerance, MovingBody, OffChords, Pose, PoseTimes, RationalForm, RationalMotion,
    Schedule, ScrewMotion, SpeedKind, SpeedPeak, StudyPoint, TimeLaw, TimedPose, Timing,
};
pub use panel::{CongruenceClass, Congruences, CongruentPanel};
pub use panel::{CurvatureExtreme, FlatPattern, PanelMeasures, PanelSide, PanelSideForm};
pub use panel::{Mould, MouldMember, MouldShape, Moulds, NearSurface, NearestSurfaces};
pub use rational::{NurbsCurve, RationalBezier, RationalBezierSurface, RationalBezierVolume};
pub use shape_change::ShapeChange;
pub use short_number::ShortNumber;
pub use surface::{CanalPart, CanalPatch, CharacteristicCircle, ContactPartner, RollingBall, SkewCylinders};
pub use surface::{
    CircleFamily, QuarticType, SegmentMethod, Torus, TorusClasses, TorusJunction, TorusPiece, TorusSegment, TorusSpline,
};
pub use surface::{CyclideKind, CyclidicNet, DupinCyclide, NetFrame, SingularPatch};
pub use surface::{CyclidePatch, PatchKind};
pub use surface::{GridCell, GridClosing, ParamSurface, QuadGrid, RingClosing, StripClosing};
pub use surface::{ImplicitForm, PatchLocation, PatchRow};
pub use surface::{LayoutPiece, NetLayout, QuadLayout, RoundVertex};
pub use surface::{NaturalQuadric, PairKind, QuadricPair};
pub use surface::{NormalStrip, StripForm};
pub use surface::{
    NormalWeights, SmoothComparison, SmoothEdge, SmoothMeasure, SmoothMesh, SmoothTriangle, SphereBlend, VertexNormals,
};
pub use surface::{Seam, SeamMeasure};
pub use surface::{SideLine, TrianglePatch, TriangleSurface};
pub use topology::{
    BlockFace, BlockShell, Body, CellDistances, CutShell, EdgeCurve, FaceEdge, FaceGeometry, FacePart, FaceSurface,
    LineBends, Shell, ShellEdge, ShellFace, Side,
};
pub use topology::{SurfaceJoint, surface_joints};
pub use volume::{
    CellQuality, CyclideGrid, CyclideVolume, FineEnd, FoldVerdict, Grading, GridQuality, MOST_CELLS, ParamVolume,
    SphericalCube, StructuredGrid, VolumeFrame, VolumeLocation, VolumeMeasure, VolumeMetric, VolumeRow, miquel_point,
};
pub use warning::{
    BodyWarning, CircularWarning, CurveWarning, FitWarning, MeshWarning, MotionWarning, NetWarning, NoiseWarning,
    PointWarning, PolyhedronWarning, PoseFitWarning, PrincipalGridWarning, VolumeWarning,
};
pub use warning::{InvertedCause, SpikeRemedy, SwingPart, Warning, WaverRemedy};

/// The example of the package's page is compiled and run with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
