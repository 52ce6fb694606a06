//! Motions of bodies, and what is made of them, field by field.

use cyclide::{Outliers, PoseTimes, TimeLaw};
use schemars::JsonSchema;
use serde::Deserialize;

use super::comment::Comment;
use super::{PolygonMeshFile, SweepEnds, TypeWord};
use crate::document::angle::{Angle, ThreeAngles, three_angles};
use crate::document::coordinates::Coordinates;
use crate::document::matrix::{MatrixRows, matrix_rows};

/// A motion of a rigid body, through poses or along a curve: where it is at which time. GLB files animate it, the command `sample` gives its poses, and
/// `trajectory` and `swept-surface` are made of it.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "poses": [
///     {"position": [0, 0, 0]}, {"position": [30, 0, 10], "rpy": [0, 0, {"degrees": 90}]}]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].item.motion().expect("it is one").duration(), 1.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MotionSpec {
    /// The word `motion`.
    #[schemars(with = "String", extend("const" = "motion"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// How the body goes from pose to pose. Default `spline`.
    pub kind: Option<MotionKind>,
    /// The poses, or a file of them; or `along` instead.
    pub poses: Option<PoseSource>,
    /// The motion comes back to its first pose and goes on as it began, joined as smoothly as within: of a `spline`, of `linear`, and with `positions` or a
    /// `tolerance`. The last pose may repeat the first; with times it does (with a `tolerance`, within twice that), since its time says when the motion is back. Default false.
    #[serde(default)]
    pub closed: bool,
    /// Of `linear`: how far from a pose the body may be where it leaves the straight line to it, and where it takes the next one, on a parabola between. Both are
    /// equally long in time, before the pose and after it: on the line where it is faster it is so far, on the other one nearer. It then does not stop at the
    /// poses, and passes beside them. Default 0, at the poses.
    #[schemars(extend("minimum" = 0))]
    pub blend_radius: Option<f64>,
    /// Instead of `kind`: the curve through the positions of the poses on which the origin of the body runs, C1 in time, while it turns on a C1 spline
    /// of its own that runs beyond no pose.
    pub positions: Option<PositionCurve>,
    /// Instead of `kind`, for noisy poses: the smoothest motion within these tolerances of them, C2 in time.
    pub tolerance: Option<PoseTolerance>,
    /// With a `tolerance`: what becomes of poses that do not belong to the others. They are named in any case. Default `keep`: the motion keeps within the
    /// tolerance of them too.
    pub outliers: Option<Outliers>,
    /// Name of a curve of one contour on which the origin of the body runs, turned by the quaternions of the curve: arcs, segments,
    /// `moebius-spline`, `qb-interpolation`, a `fair-spline` of tension 0, a `fair-fit`, or a rational `circle-spline` of order 1. On arcs the body keeps its direction to the curve,
    /// on others it turns in its own way. It may be construction geometry.
    pub along: Option<String>,
    /// With `along`: how the body is turned at the start of the curve. Default: not turned.
    pub start: Option<StartSpec>,
    /// How poses without a `time` follow each other. Default `uniform`.
    pub times: Option<PoseTimes>,
    /// How the body runs along the motion.
    #[serde(default)]
    pub law: TimeLaw,
    /// How long the motion takes, in seconds. Default: from the first to the last time of the poses; 1 along a curve.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub duration: Option<f64>,
    /// The point of the body that is measured, and along whose way laws go. Default: its origin.
    pub tool: Option<Coordinates>,
    /// The length by which a turn counts in laws, and in `times`, beside the way of the tool: the distance from it at which the body should not get too fast.
    /// Default 0.
    #[schemars(extend("minimum" = 0))]
    pub arm: Option<f64>,
    /// Of a `cubic` with two motions, which one: that of the smaller (0) or the larger (1) cross-ratio.
    pub choice: Option<usize>,
    /// The shape of the body, for files that animate. Default: the axes of its frame.
    pub mesh: Option<PolygonMeshFile>,
}

/// How a body goes from pose to pose.
///
/// ```
/// use cyclide_io::MotionKind;
/// assert_eq!(MotionKind::default(), MotionKind::Spline);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum MotionKind {
    /// Smoothly (C1) through any number of poses; points run on rational curves of degree 6.
    #[default]
    Spline,
    /// Straight from each pose to the next, in proportion to the time, turned about one axis at constant speed (slerp), as linear moves of robots are.
    Linear,
    /// By a screw from each pose to the next, with jumps of speed; points run on helices, also the origin of the body where it turns.
    Sclerp,
    /// By the motion of degree 2 through three poses: no freedom.
    Conic,
    /// By the motion of degree 4 through five poses: no freedom, and it may swing.
    Quartic,
    /// By a motion of degree 3 through four poses, where there is one; it sets the times between the first and the last.
    Cubic,
}

/// The curve through the positions of poses.
///
/// ```
/// use cyclide_io::PositionCurve;
/// assert_eq!(serde_json::from_str::<PositionCurve>("\"fair\"")?, PositionCurve::Fair);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum PositionCurve {
    /// Straight lines.
    Polyline,
    /// The fair circle spline.
    Fair,
    /// The circle spline of order 2.
    CircleSpline,
}

/// How far a motion may be from noisy poses. What is left out is interpolated.
///
/// ```
/// use cyclide_io::PoseTolerance;
/// let tolerance: PoseTolerance = serde_json::from_str(r#"{"place": 5, "angle": {"degrees": 1}}"#)?;
/// assert_eq!(tolerance.place, Some(5.0));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseTolerance {
    /// Of the positions, a length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub place: Option<f64>,
    /// Of the turns, up to a right angle.
    pub angle: Option<Angle>,
}

/// Where the poses of a motion come from.
///
/// ```
/// use cyclide_io::PoseSource;
/// let source: PoseSource = serde_json::from_str(r#"[{"position": [1, 2, 3]}]"#)?;
/// assert!(matches!(source, PoseSource::Inline(poses) if poses.len() == 1));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Poses")]
pub enum PoseSource {
    /// In the document.
    Inline(Vec<PoseSpec>),
    /// A table.
    File(PoseFile),
}

/// A file of poses: delimited text with a header line. Columns `x`, `y`, `z`; `qw`, `qx`, `qy`, `qz` or `roll`, `pitch`, `yaw` (radians; in degrees
/// `roll_deg`, `pitch_deg`, `yaw_deg`), or the entries `m11` to `m34` of a matrix, row by row, which may stand for the position as well; `t`, `time` or `timestamp`, if not left out. Names may have units: `x_mm`, `time [s]`, `time_ns`, `yaw (deg)`. A `z` and angles
/// that no column has are 0.
///
/// ```
/// use cyclide_io::{Document, ModelBuilder};
/// use std::path::Path;
/// let text = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "poses": {"csv": "poses.csv"}}}}"#;
/// let document: Document = text.parse()?;
/// let read = |_: &Path| Ok(b"t,x,y,z,roll_deg,pitch_deg,yaw_deg\n0,0,0,0,0,0,0\n2,5,0,0,0,0,90\n".to_vec());
/// let built = ModelBuilder::new(&document, Path::new(""), &read)?.build(0, &mut |_| ())?;
/// assert_eq!(built.item.motion().expect("it is one").duration(), 2.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseFile {
    /// Path of the file, relative to the document.
    pub csv: String,
    /// What each column of the file is, in their order, in the words of a header line; `-` for one that is no part of the pose. It stands in
    /// for a header, and before one that the file has.
    pub columns: Option<Vec<String>>,
}

/// One pose: a position with a rotation in one of two notations, or a matrix.
///
/// ```
/// use cyclide_io::PoseSpec;
/// let pose: PoseSpec = serde_json::from_str(r#"{"time": 2, "position": [1, 2, 3], "quaternion": [1, 0, 0, 0]}"#)?;
/// assert_eq!(pose.time, Some(2.0));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseSpec {
    /// When, in seconds. Default, if left out of all poses: as `times` says, 0, 1, 2, ….
    pub time: Option<f64>,
    /// Where the origin of the body is.
    pub position: Option<Coordinates>,
    /// The rotation as a quaternion `[w, x, y, z]` of any length.
    pub quaternion: Option<[f64; 4]>,
    /// The rotation as roll, pitch and yaw: about the fixed axes x by the first angle, then y, then z (the same as yaw, pitch and roll about the
    /// moved axes z, y', x''): `[0, 0, {"degrees": 90}]`, or `{"degrees": [0, 0, 90]}`.
    #[serde(default, deserialize_with = "three_angles")]
    #[schemars(with = "Option<ThreeAngles>")]
    pub rpy: Option<[Angle; 3]>,
    /// Rotation and position as the rows of a matrix that is multiplied by columns of points: three, or four with `[0, 0, 0, 1]`; or its 12 or 16
    /// numbers, row by row.
    #[serde(default, deserialize_with = "matrix_rows")]
    #[schemars(with = "Option<MatrixRows>")]
    pub matrix: Option<Vec<[f64; 4]>>,
}

/// How a body is turned at the start, in one of two notations.
///
/// ```
/// use cyclide_io::StartSpec;
/// let start: StartSpec = serde_json::from_str(r#"{"rpy": [0, 0, {"degrees": 90}]}"#)?;
/// assert!(start.quaternion.is_none() && start.rpy.is_some());
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartSpec {
    /// The rotation as a quaternion `[w, x, y, z]` of any length.
    pub quaternion: Option<[f64; 4]>,
    /// The rotation as roll, pitch and yaw, as those of poses.
    #[serde(default, deserialize_with = "three_angles")]
    #[schemars(with = "Option<ThreeAngles>")]
    pub rpy: Option<[Angle; 3]>,
}

/// The path of a point of a moving body: an exact rational curve.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [30, 0], "rpy": [0, 0, {"degrees": 90}]}]},
///     "p": {"type": "trajectory", "of": "m", "point": [0, 5]}}}"#.parse()?;
/// let built = document.build()?;
/// let path = built[1].item.curves()[0].as_curve();
/// assert!(path.point(1.0).distance(cyclide::Point3::new(25.0, 0.0, 0.0)) < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TrajectorySpec {
    /// The word `trajectory`.
    #[schemars(with = "String", extend("const" = "trajectory"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the motion, of any kind but `sclerp`; it may be construction geometry.
    pub of: String,
    /// The point of the body. Default: the tool of the motion.
    pub point: Option<Coordinates>,
}

/// What a curve of a moving body runs over: an exact rational surface.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [30, 0]}]},
///     "blade": {"type": "polyline", "points": [[0, 0], [0, 5]], "construction": true},
///     "s": {"type": "swept-surface", "of": "m", "profile": "blade"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[2].bodies[0].outer.area() - 150.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SweptSurfaceSpec {
    /// The word `swept-surface`.
    #[schemars(with = "String", extend("const" = "swept-surface"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the motion, of any kind but `sclerp`; it may be construction geometry.
    pub of: String,
    /// Name of the curve, in the frame of the body; each of its contours makes a surface. It may be construction geometry.
    pub profile: String,
    /// How what a closed plane curve runs over ends, where the motion does not come back.
    #[serde(default)]
    pub ends: SweepEnds,
}

impl<'de> Deserialize<'de> for PoseSource {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PoseVisitor;
        impl<'de> serde::de::Visitor<'de> for PoseVisitor {
            type Value = PoseSource;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a list of poses, or `{\"csv\": FILE}`")
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<PoseSource, A::Error> {
                let seq = serde::de::value::SeqAccessDeserializer::new(seq);
                Vec::<PoseSpec>::deserialize(seq).map(PoseSource::Inline)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<PoseSource, A::Error> {
                PoseFile::deserialize(serde::de::value::MapAccessDeserializer::new(map)).map(PoseSource::File)
            }
        }
        deserializer.deserialize_any(PoseVisitor)
    }
}
