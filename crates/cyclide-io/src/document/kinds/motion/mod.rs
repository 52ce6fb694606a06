//! A motion of a body, through poses or along a curve.

mod poses;
mod positions;
mod tolerance;

use cyclide::{
    Quat, ShortNumber, Vec3,
    construct::{FairSplineOptions, Outliers},
    curve::{CircleSpline, CircleSplineOptions},
    error::{ErrorItem, InterpolationError, MotionError, NumberError, PoseError},
    motion::{
        BodyMesh, CubicMotions, DecoupledMotion, Motion, MovingBody, Pose, PoseTimes, RationalMotion, ScrewMotion,
        TimeLaw, TimedPose,
    },
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::angle::{Angle, ThreeAngles, three_angles};
use crate::document::coordinates::Coordinates;
use crate::document::forms::forms;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::polygon_mesh_file::PolygonMeshFile;
use crate::document::locate::Step;
use crate::document::matrix::{MatrixRows, matrix_rows};
use crate::document::objects::Builder;
use crate::document::objects::idle::NO_EFFECT;
use crate::document::objects::kind::{Kind, Reference, Shape};
use crate::error::{Error, Result};
pub use tolerance::{AngleTolerance, PoseTolerance, PoseTolerances};

/// Roundings of the largest coordinate within which the path of a point is one point: of the products with the rotation and their sums.
pub(in crate::document) const AT_REST: f64 = 64.0 * f64::EPSILON;

/// A motion of a rigid body, through poses or along a curve. GLB files animate it, the command `sample` gives its poses
/// over time, and `trajectory` and `swept-surface` are made from it.
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
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// How the body moves from pose to pose. Default `spline`.
    pub kind: Option<MotionKind>,
    /// The poses, or a file of them; alternatively `along`.
    pub poses: Option<PoseSource>,
    /// The motion returns to its first pose and continues as it began, joined there as smoothly as elsewhere; for
    /// `spline`, `linear`, `positions` and `tolerance`. The last pose may repeat the first; if poses have times it must
    /// (with a `tolerance`, to within twice that), since its time gives the period. Default false.
    #[serde(default)]
    pub closed: bool,
    /// For `linear`: largest distance from a pose at which the body leaves the straight line for a parabola to the next
    /// line, so that it passes beside the pose without a stop. The parabola takes as much time before the pose as after
    /// it: it begins or ends at this distance on the line where the body is faster, nearer to the pose on the other
    /// one. Default 0: the body passes through the poses.
    #[schemars(extend("minimum" = 0))]
    pub blend_radius: Option<f64>,
    /// Instead of `kind`: the curve through the positions of the poses that the origin of the body follows, C1 in time
    /// (except for `polyline`). The rotation is a separate C1 spline that does not overshoot.
    pub positions: Option<PositionCurve>,
    /// Instead of `kind`, for noisy poses, C2 in time. `"auto"`, right for measured poses: it follows at least 20 poses as
    /// closely as their noise requires, which is estimated from them. With numbers: the smoothest motion within these
    /// tolerances of every pose.
    pub tolerance: Option<PoseTolerance>,
    /// With a `tolerance`: what happens to outliers, which are poses that do not agree with the others; they are named
    /// in any case. Default `keep`: with `auto` they have next to no influence, with a number the motion stays within it
    /// of them too, and it passes through them in place or in angle if no tolerance is given for that.
    pub outliers: Option<Outliers>,
    /// Name of a curve of one contour that the origin of the body follows, turned by the quaternions of the curve:
    /// arcs, segments, `moebius-spline`, `qb-interpolation`, a `fair-spline` of tension 0, a `fair-fit`, or a rational
    /// `circle-spline` of order 1; it may be construction geometry. On arcs the body keeps its orientation relative to
    /// the curve, on other curves it does not.
    pub along: Option<String>,
    /// With `along`: rotation of the body at the start of the curve. Default: not rotated.
    pub start: Option<StartSpec>,
    /// How poses without a `time` are spaced in time. Default `uniform`.
    pub times: Option<PoseTimes>,
    /// How the body moves along its path in time.
    #[serde(default)]
    pub law: TimeLaw,
    /// Duration of the motion in seconds. Default: from the first to the last time of the poses; 1 along a curve.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub duration: Option<f64>,
    /// The point of the body that is measured, and whose path the laws of time use. Default: its origin.
    pub tool: Option<Coordinates>,
    /// Characteristic length that weights rotation against the path of the tool in laws and in `times`: the distance
    /// from the tool at which the body should not get too fast. Default 0.
    #[schemars(extend("minimum" = 0))]
    pub arm: Option<f64>,
    /// For a `cubic` with two solutions, which one: that of the smaller (0) or the larger (1) cross-ratio.
    pub choice: Option<usize>,
    /// Shape of the body in files with animation. Default: the axes of its frame.
    pub mesh: Option<PolygonMeshFile>,
}

/// How a body goes from pose to pose.
///
/// ```
/// use cyclide_io::document::kinds::MotionKind;
/// assert_eq!(MotionKind::default(), MotionKind::Spline);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum MotionKind {
    /// Smooth (C1) through any number of poses; points move on rational curves of degree 6.
    #[default]
    Spline,
    /// Straight from each pose to the next, in proportion to time, turned about one axis at constant speed (slerp),
    /// like the linear moves of robots.
    Linear,
    /// A screw motion from each pose to the next, with jumps of speed; points move on helices, and so does the origin
    /// of the body where it turns.
    Sclerp,
    /// The motion of degree 2 through three poses; no freedom is left.
    Conic,
    /// The motion of degree 4 through five poses; no freedom is left, and it may swing.
    Quartic,
    /// A motion of degree 3 through four poses, if one exists; it determines the times between the first and the last.
    Cubic,
}

/// The curve through the positions of poses.
///
/// ```
/// use cyclide_io::document::kinds::PositionCurve;
/// assert_eq!(serde_json::from_str::<PositionCurve>("\"fair\"")?, PositionCurve::Fair);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
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

/// Where the poses of a motion come from.
///
/// ```
/// use cyclide_io::document::kinds::PoseSource;
/// let source: PoseSource = serde_json::from_str(r#"[{"position": [1, 2, 3]}]"#)?;
/// assert!(matches!(source, PoseSource::Inline(poses) if poses.len() == 1));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Poses")]
pub enum PoseSource {
    /// A list in the document.
    Inline(Vec<PoseSpec>),
    /// A table in a file.
    File(PoseFile),
}

/// A file of poses: delimited text with a header line. Columns are `x`, `y`, `z`; `qw`, `qx`, `qy`, `qz` or `roll`,
/// `pitch`, `yaw` (radians; in degrees `roll_deg`, `pitch_deg`, `yaw_deg`), or the entries `m11` to `m34` of a matrix,
/// row by row, which may replace the position as well; `t`, `time` or `timestamp`, if there are times. Names may carry
/// units: `x_mm`, `time [s]`, `time_ns`, `yaw (deg)`. A `z` and angles without a column are 0. Beside positions with
/// other names (`px`, `py`, `pz`), the columns `x`, `y`, `z`, `w` are a quaternion.
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
    /// What each column of the file is, in order, in the words of a header line; `-` marks a column that is not part of
    /// the pose. The list replaces a missing header, and takes precedence over an existing one.
    pub columns: Option<Vec<String>>,
}

/// One pose: a position with a rotation in one of two notations, or a matrix.
///
/// ```
/// use cyclide_io::document::kinds::PoseSpec;
/// let pose: PoseSpec = serde_json::from_str(r#"{"time": 2, "position": [1, 2, 3], "quaternion": [1, 0, 0, 0]}"#)?;
/// assert_eq!(pose.time, Some(2.0));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseSpec {
    /// Time in seconds. Default, if omitted in all poses: as given by `times`, 0, 1, 2, ….
    pub time: Option<f64>,
    /// Position of the origin of the body.
    pub position: Option<Coordinates>,
    /// The rotation as a quaternion `[w, x, y, z]` of any length.
    pub quaternion: Option<[f64; 4]>,
    /// The rotation as roll, pitch and yaw: about the fixed axes x by the first angle, then y, then z (the same as yaw,
    /// pitch and roll about the moved axes z, y', x''), such as `[0, 0, {"degrees": 90}]` or `{"degrees": [0, 0, 90]}`.
    #[serde(default, deserialize_with = "three_angles")]
    #[schemars(with = "Option<ThreeAngles>")]
    pub rpy: Option<[Angle; 3]>,
    /// Rotation and position as the rows of a matrix that multiplies columns of coordinates: three rows, or four with
    /// `[0, 0, 0, 1]`; or its 12 or 16 numbers, row by row.
    #[serde(default, deserialize_with = "matrix_rows")]
    #[schemars(with = "Option<MatrixRows>")]
    pub matrix: Option<Vec<[f64; 4]>>,
}

/// Rotation of a body at the start, in one of two notations.
///
/// ```
/// use cyclide_io::document::kinds::StartSpec;
/// let start: StartSpec = serde_json::from_str(r#"{"rpy": [0, 0, {"degrees": 90}]}"#)?;
/// assert!(start.quaternion.is_none() && start.rpy.is_some());
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartSpec {
    /// The rotation as a quaternion `[w, x, y, z]` of any length.
    pub quaternion: Option<[f64; 4]>,
    /// The rotation as roll, pitch and yaw, as for poses.
    #[serde(default, deserialize_with = "three_angles")]
    #[schemars(with = "Option<ThreeAngles>")]
    pub rpy: Option<[Angle; 3]>,
}

forms! {
    PoseSource: "a list of poses, or `{\"csv\": FILE}`";
    list Vec<PoseSpec> => PoseSource::Inline;
    object PoseFile => PoseSource::File;
}

/// How a body moves from pose to pose: with position and rotation coupled, on a curve through the positions, or within a tolerance.
#[derive(Clone, Copy)]
enum Path {
    Together(MotionKind),
    OnCurve(PositionCurve),
    Near(PoseTolerance),
}

impl Kind for MotionSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.motion(self).map(|body| Shape::Motion(Box::new(body)))
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.along.iter().map(|name| (vec![Step::from("along")], name.as_str())).collect()
    }

    fn files(&self) -> Vec<&str> {
        let poses = match &self.poses {
            Some(PoseSource::File(file)) => Some(file.csv.as_str()),
            _ => None,
        };
        poses.into_iter().chain(self.mesh.as_ref().map(|file| file.path.as_str())).collect()
    }
}

impl Builder<'_> {
    /// The moving body.
    pub(in crate::document) fn motion(&mut self, spec: &MotionSpec) -> Result<MovingBody> {
        let kind = spec.kind.unwrap_or_default();
        if spec.choice.is_some() && kind != MotionKind::Cubic {
            return Err(self.unfit("`choice` requires the kind `cubic`: other motions are unique"));
        }
        let source = match (&spec.poses, &spec.along) {
            (Some(source), None) => source,
            (None, Some(curve)) => return self.along(spec, curve),
            _ => return Err(self.unfit("a motion requires either `poses` or `along` (a curve)")),
        };
        if spec.start.is_some() {
            return Err(self.unfit("`start` requires `along`: poses contain the rotation of the body"));
        }
        if spec.times.is_some() && kind == MotionKind::Cubic {
            return Err(self.unfit("a `cubic` determines the times of its poses itself: remove `times`"));
        }
        let path = self.path_of(spec)?;
        let (mut poses, timed) = self.poses(spec, source)?;
        // The first pose again.
        let closing = if spec.closed { poses.pop().map(|pose| pose.time) } else { None };
        let motion = match path {
            Path::OnCurve(curve) => return self.on_positions(spec, curve, &poses, closing),
            Path::Near(tolerance) => {
                let drop = spec.outliers == Some(Outliers::Drop);
                DecoupledMotion::smoothed_with(&poses, closing, tolerance.limits(), drop).map(Motion::from)
            }
            Path::Together(MotionKind::Spline) => match closing {
                Some(closing) => RationalMotion::closed_spline(&poses, closing).map(Motion::from),
                None => RationalMotion::spline(&poses).map(Motion::from),
            },
            Path::Together(MotionKind::Linear) => {
                DecoupledMotion::linear(&poses, closing, spec.blend_radius.unwrap_or(0.0)).map(Motion::from)
            }
            Path::Together(MotionKind::Sclerp) => ScrewMotion::new(&poses).map(Motion::from),
            Path::Together(MotionKind::Conic) => RationalMotion::conic(&poses).map(Motion::from),
            Path::Together(MotionKind::Quartic) => RationalMotion::quartic(&poses).map(Motion::from),
            Path::Together(MotionKind::Cubic) => return self.cubic(spec, &poses, timed),
        };
        let motion = motion.map_err(|e| match e {
            cyclide::Error::Number(NumberError::ParameterOutOfRange { name: ErrorItem::Radius, .. }) => {
                self.refused_at(["blend_radius".into()], &e)
            }
            cyclide::Error::Number(NumberError::ParameterOutOfRange {
                name: ErrorItem::Tolerance | ErrorItem::Angle,
                ..
            }) => self.refused_at(["tolerance".into()], &e),
            e => self.pose_refused(spec, &e),
        })?;
        self.through_poses(spec, motion)
    }

    /// The body that goes from pose to pose.
    fn through_poses(&mut self, spec: &MotionSpec, motion: Motion) -> Result<MovingBody> {
        let [first, last] = motion.domain();
        self.body(spec, motion, last - first)
    }

    /// How the body moves; fields without effect on that are refused.
    fn path_of(&self, spec: &MotionSpec) -> Result<Path> {
        let path = match (spec.kind, spec.positions, spec.tolerance) {
            (kind, None, None) => Path::Together(kind.unwrap_or_default()),
            (None, Some(curve), None) => Path::OnCurve(curve),
            (None, None, Some(tolerance)) => Path::Near(tolerance),
            (Some(_), ..) => {
                return Err(self.unfit(
                    "`kind` couples position and rotation, while `positions` and `tolerance` separate them: remove one of the two",
                ));
            }
            (None, Some(_), Some(_)) => {
                return Err(
                    self.unfit("`positions` pass through the poses, a `tolerance` near them: remove one of the two")
                );
            }
        };
        let refusal = match path {
            Path::Together(kind) if spec.closed && !matches!(kind, MotionKind::Spline | MotionKind::Linear) => {
                "`closed` requires the kind `spline` or `linear`, `positions`, or a `tolerance`"
            }
            Path::Together(_) | Path::OnCurve(_) if spec.outliers.is_some() => {
                "`outliers` requires a `tolerance`: other motions pass through every pose"
            }
            Path::Together(MotionKind::Linear) => return Ok(path),
            _ if spec.blend_radius.is_some() => {
                "`blend_radius` requires the kind `linear`: other motions do not stop at their poses"
            }
            _ => return Ok(path),
        };
        Err(self.unfit(refusal))
    }

    /// The motion on a curve through the positions.
    fn on_positions(
        &mut self,
        spec: &MotionSpec,
        curve: PositionCurve,
        poses: &[TimedPose],
        closing: Option<f64>,
    ) -> Result<MovingBody> {
        let closed = closing.is_some();
        let points = DecoupledMotion::places_of_curve(poses, closed);
        let curve = match curve {
            _ if points.len() < 2 => None,
            PositionCurve::Polyline => None,
            PositionCurve::Fair => {
                Some(CircleSpline::fair(&points, &FairSplineOptions { closed, ..Default::default() }))
            }
            PositionCurve::CircleSpline => {
                Some(CircleSpline::from_points(&points, &CircleSplineOptions { closed, ..Default::default() }))
            }
        };
        let motion = match curve.transpose().map_err(|e| self.refused_at(["positions".into()], &e))? {
            None => DecoupledMotion::polyline(poses, closing),
            Some(curve) => {
                // They count the positions, which are fewer than the poses where the body stays.
                for warning in curve.warnings() {
                    self.warn_at("positions", None, warning.clone());
                    if let Some(remark) = self.remarks.last_mut() {
                        remark.message = positions::words(warning, &remark.message);
                    }
                }
                DecoupledMotion::on_curve(poses, closing, curve)
            }
        };
        let motion = motion.map_err(|e| self.pose_refused(spec, &e))?;
        self.through_poses(spec, motion.into())
    }

    /// The motion that a curve carries.
    fn along(&mut self, spec: &MotionSpec, curve: &str) -> Result<MovingBody> {
        if spec.kind.is_some() {
            return Err(self.unfit("`kind` is the path from pose to pose: `along` a curve there is only one"));
        }
        let through = spec.closed || spec.blend_radius.is_some() || spec.positions.is_some();
        if through || spec.tolerance.is_some() || spec.outliers.is_some() {
            return Err(self.unfit(
                "`closed`, `blend_radius`, `positions`, `tolerance` and `outliers` require motions through poses: `along` a curve there are none",
            ));
        }
        if spec.times.is_some() {
            return Err(self.unfit("`times` require poses: `along` a curve there are none; use a `law` by path length"));
        }
        let contours = self.sources.first().map_or(&[][..], |source| source.item.curves());
        let [contour] = contours else {
            let message = format!("`{curve}` has {} contours: a motion along a curve requires one", contours.len());
            return Err(Error::Input(self.diagnostic(["along".into()], &message)));
        };
        let Some(chain) = contour.to_qb_spline() else {
            let message = format!(
                "`{curve}` does not define a rotation: a motion can follow arcs and segments, a `moebius-spline`, a `qb-interpolation`, a `fair-spline` of tension 0 without straight parts (`\"straight\": \"off\"`) that was not relaxed, a `fair-fit` without corners, or a rational `circle-spline` of order 1"
            );
            return Err(Error::Input(self.diagnostic(["along".into()], &message)));
        };
        let start = match spec.start {
            None => Quat::ONE,
            Some(StartSpec { quaternion: Some(quaternion), rpy: None }) => Quat::from(quaternion),
            Some(StartSpec { quaternion: None, rpy: Some(angles) }) => {
                let turned = Pose::from_roll_pitch_yaw(Vec3::ZERO, angles.map(Angle::radians));
                turned.map_err(|e| self.refused_at(["start".into()], &e))?.rotation()
            }
            Some(_) => {
                let message = "`start` requires either `quaternion` or `rpy`";
                return Err(Error::Input(self.diagnostic(["start".into()], message)));
            }
        };
        let motion = RationalMotion::along(&chain, start).map_err(|e| match e {
            cyclide::Error::Pose(PoseError::ZeroRotation { .. }) => self.refused_at(["start".into()], &e),
            _ => self.refused_at(["along".into()], &e),
        })?;
        self.body(spec, motion.into(), 1.0)
    }

    /// The motion of degree 3, at its own times between the first and the last.
    fn cubic(&mut self, spec: &MotionSpec, poses: &[TimedPose], timed: bool) -> Result<MovingBody> {
        let only: Vec<Pose> = poses.iter().map(|timed| timed.pose).collect();
        let cubics = CubicMotions::new(&only).map_err(|e| self.pose_refused(spec, &e))?;
        let admissible = cubics.admissible();
        let choice = spec.choice.unwrap_or(0);
        // A cross-ratio that is none is refused with those that there are.
        let cross_ratio = admissible.get(choice).copied().unwrap_or(f64::NAN);
        if spec.choice.is_some() && choice >= admissible.len() && !admissible.is_empty() {
            let message = format!("there is no motion {choice}: the poses have {}, numbered from 0", admissible.len());
            return Err(Error::Input(self.diagnostic(["choice".into()], &message)));
        }
        let ends = [poses[0].time, poses[3].time];
        let motion = cubics.motion(cross_ratio, ends).map_err(|e| self.pose_refused(spec, &e))?;
        if spec.choice.is_none() && admissible.len() > 1 {
            let message = "two motions of degree 3 pass through these poses: the one with the smaller cross-ratio is used; select one with `choice`";
            self.remark("cubic-chosen", None, None, self.place_of([Step::from("kind")]), message.to_owned());
        }
        if timed {
            let message =
                "a cubic determines the times of the two middle poses (see the report): the given times are ignored";
            self.remark("times-not-taken", None, None, self.place_of([Step::from("poses")]), message.to_owned());
        }
        self.body(spec, motion.into(), ends[1] - ends[0])
    }

    /// The body with its tool, law and shape; it takes so long if the document does not say.
    fn body(&mut self, spec: &MotionSpec, motion: Motion, duration: f64) -> Result<MovingBody> {
        let tool = spec.tool.unwrap_or_default().point();
        let pose_times = spec.times.unwrap_or_default();
        let made = MovingBody::new(motion).with_pose_times(pose_times).with_tool(tool, spec.arm.unwrap_or(0.0));
        let made = made.and_then(|body| body.with_law(spec.law, spec.duration.unwrap_or(duration)));
        let made = made.map_err(|e| match e {
            cyclide::Error::Motion(MotionError::SpanWithoutWay { .. }) if spec.along.is_none() => {
                self.pose_refused(spec, &e)
            }
            _ => self.refused(&e, None),
        })?;
        let counts = spec.law != TimeLaw::AsGiven || spec.times.is_some_and(|times| times != PoseTimes::Uniform);
        if spec.arm.is_some_and(|arm| arm > 0.0) && !counts {
            let message =
                "`arm` has no effect: without a `law` or `times` by path length, the times are those of the poses";
            self.remark(NO_EFFECT, None, None, self.place_of([Step::from("arm")]), message.to_owned());
        }
        for warning in made.warnings() {
            self.warn_at(if spec.along.is_some() { "along" } else { "poses" }, None, warning);
        }
        let Some(file) = &spec.mesh else { return Ok(made) };
        let (name, mesh) = self.mesh_of_file(file)?;
        if mesh.faces.iter().any(|face| face.len() > 4) {
            let message = "faces with more than four corners are divided into triangles from their first corner";
            self.remark("polygons-cut", None, None, Some(name), message.to_owned());
        }
        let fan = |face: &Vec<usize>| -> Vec<[usize; 3]> {
            (2..face.len()).map(|k| [face[0], face[k - 1], face[k]]).collect()
        };
        let triangles = mesh.faces.iter().flat_map(fan).collect();
        let shape = BodyMesh::new(mesh.points, triangles).map_err(|e| self.refused(&e, None))?;
        Ok(made.with_mesh(shape))
    }

    /// What the kernel refused of the poses, at the one it is about.
    pub(in crate::document) fn pose_refused(&self, spec: &MotionSpec, error: &cyclide::Error) -> Error {
        let inline = matches!(spec.poses, Some(PoseSource::Inline(_)));
        let steps: Vec<Step> = match error.index().filter(|_| inline) {
            Some(index) => vec!["poses".into(), index.into()],
            None => vec!["poses".into()],
        };
        let words = match error {
            cyclide::Error::Pose(PoseError::ParametersNotIncreasing { index, value, before }) => {
                format!("the times do not increase: pose {index} has the time {value}, after {before}")
            }
            cyclide::Error::Interpolation(InterpolationError::RepeatedParameter { first, second, value }) => {
                format!("poses {first} and {second} have the same time {value}")
            }
            _ => return self.refused_at(steps, error),
        };
        self.refused_in_words(steps, error.reason(), words)
    }

    /// The motion that an object is made from.
    pub(in crate::document) fn motion_source(&self) -> Result<&MovingBody> {
        let source = self.sources.first().and_then(|source| source.item.motion());
        source.ok_or_else(|| self.wrong_source("only a `motion` has trajectories and swept surfaces"))
    }

    /// Says within which bound the rational form of a motion is.
    pub(in crate::document) fn remark_bound(&mut self, bound: f64) {
        if bound > 0.0 {
            let message = format!(
                "points of this motion do not follow rational curves, since it rotates by slerp or follows a curve by time: the approximation is within {} {}",
                ShortNumber(bound),
                self.document.units.symbol()
            );
            self.remark("rational-within", None, None, self.place_of([Step::from("of")]), message);
        }
    }
}
