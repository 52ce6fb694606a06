//! Motions of bodies, paths of their points, and what their curves run over.

use cyclide::{
    BodyMesh, CircleSpline, CircleSplineOptions, CubicMotions, CurveObject, DecoupledMotion, ErrorItem,
    FairSplineOptions, Motion, MotionTolerance, MovingBody, Outliers, Point3, Pose, PoseTimes, Quat, RationalMotion,
    ScrewMotion, ShortNumber, SurfaceObject, SweptSurface, TimeLaw, TimedPose, Vec3, bounds,
};

use super::{Builder, NO_EFFECT};
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::locate::Step;
use crate::document::spec::{
    MotionKind, MotionSpec, ObjectSpec, PoseSource, PoseTolerance, PositionCurve, StartSpec, SweepEnds,
    SweptSurfaceSpec, TrajectorySpec,
};
use crate::error::{Error, Result};

/// Roundings of the largest coordinate within which the path of a point is one point: of the products with the rotation and their sums.
pub(in crate::document) const AT_REST: f64 = 64.0 * f64::EPSILON;

/// Planes that are off that across the path of their middle by no more than this are across it, radians: two degrees.
const ACROSS: f64 = 0.035;

/// Places of a motion where that is looked at, and the part of its time between two poses that tell a direction.
const PLACES: u32 = 64;
const STEP: f64 = 1e-5;

/// By how much a closed plane curve of a moving body is off the plane across the path of its middle, at most, and when.
fn lean_of_section(curve: &CurveObject, motion: &RationalMotion) -> Option<(f64, f64)> {
    let (pieces, closed) = curve.exact_pieces().ok()?;
    let points: Vec<Point3> = pieces.iter().flat_map(|piece| [0.0, 0.25, 0.5, 0.75].map(|x| piece.point(x))).collect();
    let first = *points.first().filter(|_| closed)?;
    let middle = first + points.iter().fold(Vec3::ZERO, |sum, p| sum + (*p - first)) / points.len() as f64;
    let pairs = points.iter().zip(points.iter().cycle().skip(1));
    let normal = pairs.fold(Vec3::ZERO, |sum, (a, b)| sum + (*a - middle).cross(*b - middle)).unit()?;
    let size = points.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
    if points.iter().any(|p| (*p - middle).dot(normal).abs() > 1e-9 * size) {
        return None;
    }
    let times = motion.times();
    let [from, to] = [times[0], times[times.len() - 1]];
    let lean = |k: u32| {
        let time = from + (to - from) * f64::from(k) / f64::from(PLACES);
        let step = 0.5 * STEP * (to - from);
        let [before, behind] = [(time - step).max(from), (time + step).min(to)].map(|time| motion.pose(time));
        let way = (behind.apply(middle) - before.apply(middle)).unit()?;
        let normal = motion.pose(time).rotation().rotate(normal);
        Some((way.cross(normal).length().atan2(way.dot(normal).abs()), time))
    };
    (0..=PLACES).filter_map(lean).max_by(|a, b| a.0.total_cmp(&b.0))
}

impl Builder<'_> {
    /// The moving body.
    pub(in crate::document) fn motion(&mut self, spec: &MotionSpec) -> Result<MovingBody> {
        let kind = spec.kind.unwrap_or_default();
        if spec.choice.is_some() && kind != MotionKind::Cubic {
            return Err(self.unfit("only a `cubic` has a `choice`: other motions are one"));
        }
        let source = match (&spec.poses, &spec.along) {
            (Some(source), None) => source,
            (None, Some(curve)) => return self.along(spec, curve),
            _ => return Err(self.unfit("a motion has `poses`, or a curve that it runs `along`: one of both")),
        };
        if spec.start.is_some() {
            return Err(self.unfit("`start` goes with `along`: poses say how the body is turned"));
        }
        if spec.times.is_some() && kind == MotionKind::Cubic {
            return Err(self.unfit("a `cubic` sets the times of its poses itself: leave `times` out"));
        }
        self.check_motion_fields(spec, kind)?;
        let (mut poses, timed) = self.poses(spec, source)?;
        // The first pose again.
        let closing = if spec.closed { poses.pop().map(|pose| pose.time) } else { None };
        let motion = match (spec.positions, spec.tolerance) {
            (Some(curve), _) => return self.on_positions(spec, curve, &poses, closing),
            (None, Some(PoseTolerance { place, angle })) => {
                let tolerance = MotionTolerance { place, angle: angle.map(Angle::radians) };
                let drop = spec.outliers == Some(Outliers::Drop);
                DecoupledMotion::smoothed_with(&poses, closing, tolerance, drop).map(Motion::from)
            }
            (None, None) => match (kind, closing) {
                (MotionKind::Spline, Some(closing)) => RationalMotion::closed_spline(&poses, closing).map(Motion::from),
                (MotionKind::Spline, None) => RationalMotion::spline(&poses).map(Motion::from),
                (MotionKind::Linear, closing) => {
                    DecoupledMotion::linear(&poses, closing, spec.blend_radius.unwrap_or(0.0)).map(Motion::from)
                }
                (MotionKind::Sclerp, _) => ScrewMotion::new(&poses).map(Motion::from),
                (MotionKind::Conic, _) => RationalMotion::conic(&poses).map(Motion::from),
                (MotionKind::Quartic, _) => RationalMotion::quartic(&poses).map(Motion::from),
                (MotionKind::Cubic, _) => return self.cubic(spec, &poses, timed),
            },
        };
        let motion = motion.map_err(|e| match e {
            cyclide::Error::ParameterOutOfRange { name: ErrorItem::Radius, .. } => {
                self.refused_at(["blend_radius".into()], &e)
            }
            cyclide::Error::ParameterOutOfRange { name: ErrorItem::Tolerance | ErrorItem::Angle, .. } => {
                self.refused_at(["tolerance".into()], &e)
            }
            e => self.pose_refused(&e),
        })?;
        self.through_poses(spec, motion)
    }

    /// The body that goes from pose to pose.
    fn through_poses(&mut self, spec: &MotionSpec, motion: Motion) -> Result<MovingBody> {
        let [first, last] = motion.domain();
        self.body(spec, motion, last - first)
    }

    /// Refuses fields that say nothing about a motion of this kind.
    fn check_motion_fields(&self, spec: &MotionSpec, kind: MotionKind) -> Result<()> {
        let apart = spec.positions.is_some() || spec.tolerance.is_some();
        if spec.kind.is_some() && apart {
            return Err(self.unfit(
                "`kind` says how place and turn go together: with `positions` or `tolerance` they go apart, leave one of both out",
            ));
        }
        if spec.positions.is_some() && spec.tolerance.is_some() {
            return Err(
                self.unfit("`positions` go through the poses, a `tolerance` beside them: leave one of both out")
            );
        }
        if spec.closed && spec.tolerance.is_none() && !matches!(kind, MotionKind::Spline | MotionKind::Linear) {
            return Err(
                self.unfit("a `closed` motion is a `spline`, `linear`, or one with `positions` or a `tolerance`")
            );
        }
        if spec.outliers.is_some() && spec.tolerance.is_none() {
            return Err(self.unfit(
                "`outliers` are looked for where poses are noisy: give a `tolerance`, or leave `outliers` out; other motions take every pose",
            ));
        }
        if spec.blend_radius.is_some() && (apart || kind != MotionKind::Linear) {
            return Err(
                self.unfit("a `blend_radius` is of the kind `linear`: other motions do not stop at their poses")
            );
        }
        Ok(())
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
                }
                DecoupledMotion::on_curve(poses, closing, curve)
            }
        };
        let motion = motion.map_err(|e| self.pose_refused(&e))?;
        self.through_poses(spec, motion.into())
    }

    /// The motion that a curve carries.
    fn along(&mut self, spec: &MotionSpec, curve: &str) -> Result<MovingBody> {
        if spec.kind.is_some() {
            return Err(self.unfit("`kind` is how a body goes from pose to pose: `along` a curve there is one way"));
        }
        let through = spec.closed || spec.blend_radius.is_some() || spec.positions.is_some();
        if through || spec.tolerance.is_some() || spec.outliers.is_some() {
            return Err(self.unfit(
                "`closed`, `blend_radius`, `positions`, `tolerance` and `outliers` are of motions through poses: `along` a curve there are none",
            ));
        }
        if spec.times.is_some() {
            return Err(
                self.unfit("`times` go from pose to pose: `along` a curve there are none; a `law` goes by its way")
            );
        }
        let contours = self.sources.first().map_or(&[][..], |source| source.item.curves());
        let [contour] = contours else {
            let message = format!("`{curve}` has {} contours: a motion runs along a curve of one", contours.len());
            return Err(Error::Input(self.diagnostic(["along".into()], &message)));
        };
        let Some(chain) = contour.to_qb_spline() else {
            let message = format!(
                "`{curve}` does not turn a body: a motion runs along arcs and segments, a `moebius-spline`, a `qb-interpolation`, a `fair-spline` of tension 0 without straight parts (`\"straight\": \"off\"`) that was not relaxed, a `fair-fit` without corners, or a rational `circle-spline` of order 1"
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
                let message = "`start` is a `quaternion` or `rpy`: one of both";
                return Err(Error::Input(self.diagnostic(["start".into()], message)));
            }
        };
        let motion = RationalMotion::along(&chain, start).map_err(|e| match e {
            cyclide::Error::ZeroRotation { .. } => self.refused_at(["start".into()], &e),
            _ => self.refused_at(["along".into()], &e),
        })?;
        self.body(spec, motion.into(), 1.0)
    }

    /// The motion of degree 3, at its own times between the first and the last.
    fn cubic(&mut self, spec: &MotionSpec, poses: &[TimedPose], timed: bool) -> Result<MovingBody> {
        let only: Vec<Pose> = poses.iter().map(|timed| timed.pose).collect();
        let cubics = CubicMotions::new(&only).map_err(|e| self.pose_refused(&e))?;
        let admissible = cubics.admissible();
        let choice = spec.choice.unwrap_or(0);
        // A cross-ratio that is none is refused with those that there are.
        let cross_ratio = admissible.get(choice).copied().unwrap_or(f64::NAN);
        if spec.choice.is_some() && choice >= admissible.len() && !admissible.is_empty() {
            let message = format!("there is no motion {choice}: the poses have {}, from 0", admissible.len());
            return Err(Error::Input(self.diagnostic(["choice".into()], &message)));
        }
        let ends = [poses[0].time, poses[3].time];
        let motion = cubics.motion(cross_ratio, ends).map_err(|e| self.pose_refused(&e))?;
        if spec.choice.is_none() && admissible.len() > 1 {
            let message = "two motions of degree 3 take these poses: the one of the smaller cross-ratio is taken; `choice` says which";
            self.remark("cubic-chosen", None, None, self.place_of([Step::from("kind")]), message.to_owned());
        }
        if timed {
            let message = "a cubic sets the times of the two poses in the middle, which the report has: those given for them are left aside";
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
            cyclide::Error::SpanWithoutWay { .. } if spec.along.is_none() => self.pose_refused(&e),
            _ => self.refused(&e, None),
        })?;
        let counts = spec.law != TimeLaw::AsGiven || spec.times.is_some_and(|times| times != PoseTimes::Uniform);
        if spec.arm.is_some_and(|arm| arm > 0.0) && !counts {
            let message =
                "`arm` has no effect: without a `law`, or `times`, that go by the way the times are those of the poses";
            self.remark(NO_EFFECT, None, None, self.place_of([Step::from("arm")]), message.to_owned());
        }
        for warning in made.warnings() {
            self.warn_at(if spec.along.is_some() { "along" } else { "poses" }, None, warning);
        }
        let Some(file) = &spec.mesh else { return Ok(made) };
        let (name, mesh) = self.mesh_of_file(file)?;
        if mesh.faces.iter().any(|face| face.len() > 4) {
            let message = "faces of more than four corners are cut into triangles from their first corner";
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
    pub(in crate::document) fn pose_refused(&self, error: &cyclide::Error) -> Error {
        let inline = matches!(self.spec, ObjectSpec::Motion(MotionSpec { poses: Some(PoseSource::Inline(_)), .. }));
        let steps: Vec<Step> = match error.index().filter(|_| inline) {
            Some(index) => vec!["poses".into(), index.into()],
            None => vec!["poses".into()],
        };
        let words = match error {
            cyclide::Error::ParametersNotIncreasing { index, value, before } => {
                format!("the times do not rise: that of pose {index} is {value}, after {before}")
            }
            cyclide::Error::RepeatedParameter { first, second, value } => {
                format!("the poses {first} and {second} have one time, {value}")
            }
            _ => return self.refused_at(steps, error),
        };
        self.refused_in_words(steps, error.reason(), words)
    }

    /// The motion that an object is made from.
    fn motion_source(&self) -> Result<&MovingBody> {
        let source = self.sources.first().and_then(|source| source.item.motion());
        source.ok_or_else(|| self.wrong_source("only a `motion` has trajectories and swept surfaces"))
    }

    /// The path of a point.
    pub(in crate::document) fn trajectory(&mut self, spec: &TrajectorySpec) -> Result<CurveObject> {
        let body = self.motion_source()?;
        let point = spec.point.map_or(body.tool(), Coordinates::point);
        let form = body.motion().to_rational().map_err(|e| self.refused_at(["of".into()], &e))?;
        let path = form.motion().trajectory(point).map_err(|e| self.refused_at(["of".into()], &e))?;
        let bound = form.bound(point.to_vec().length());
        drop(form);
        let range = bounds(&path);
        let (length, limit) = (range.diagonal(), AT_REST * range.max_abs());
        if length <= limit {
            let error = cyclide::Error::MotionAtRest { length, limit };
            let place = if spec.point.is_some() { "point" } else { "of" };
            return Err(self.refused_in_words(
                [place.into()],
                error.reason(),
                format!(
                    "the point rests: its path is {} long, which must be above {}",
                    ShortNumber(length),
                    ShortNumber(limit)
                ),
            ));
        }
        self.remark_bound(bound);
        Ok(CurveObject::Nurbs(path))
    }

    /// Says within which bound the rational form of a motion is.
    fn remark_bound(&mut self, bound: f64) {
        if bound > 0.0 {
            let message = format!(
                "points of this motion run on no rational curves, as it turns by slerp or runs on a curve by time: the form made is within {} {} of it",
                ShortNumber(bound),
                self.document.units.symbol()
            );
            self.remark("rational-within", None, None, self.place_of([Step::from("of")]), message);
        }
    }

    /// What the contours of a curve run over.
    pub(in crate::document) fn swept_surface(&mut self, spec: &SweptSurfaceSpec) -> Result<Vec<SurfaceObject>> {
        let motion = self.motion_source()?.motion().clone();
        let contours = self.sources[1].item.curves().to_vec();
        if contours.is_empty() {
            let message = format!("`{}` has no curve: a profile is a curve", spec.profile);
            return Err(Error::Input(self.diagnostic(["profile".into()], &message)));
        }
        let form = motion.to_rational().map_err(|e| self.refused_at(["of".into()], &e))?;
        let mut reach = 0.0_f64;
        let mut made = Vec::with_capacity(contours.len());
        for (contour, curve) in contours.iter().enumerate() {
            let lean = lean_of_section(curve, form.motion());
            let make = if spec.ends == SweepEnds::Flat { SweptSurface::solid } else { SweptSurface::new };
            let swept = curve.exact_pieces().and_then(|(pieces, closed)| make(&pieces, closed, form.motion()));
            let swept = swept.map_err(|e| match e {
                cyclide::Error::MotionAtRest { length, limit } => {
                    let words = format!(
                        "the motion is at rest: the profile moves by {}, which must be above {}, and runs over no surface",
                        ShortNumber(length),
                        ShortNumber(limit)
                    );
                    self.refused_in_words(["of".into()], e.reason(), words)
                }
                e => self.refused_at(["profile".into()], &e),
            })?;
            if let Some((lean, time)) = lean.filter(|(lean, _)| *lean > ACROSS) {
                let message = format!(
                    "the profile lies {} degrees off the plane across its path at the time {}: it is swept as it is turned by the motion; a section that stays across its path is a `sweep`",
                    ShortNumber(lean.to_degrees()),
                    ShortNumber(time)
                );
                let place = self.place_of([Step::from("profile")]);
                self.remark("section-not-across", (contours.len() > 1).then_some(contour), None, place, message);
            }
            for warning in swept.warnings() {
                self.warn_at("profile", (contours.len() > 1).then_some(contour), warning.clone());
            }
            made.push(SurfaceObject::Body(swept.into_body()));
            let range = bounds(curve.as_curve());
            reach = [range.min, range.max].into_iter().map(|corner| corner.to_vec().length()).fold(reach, f64::max);
        }
        self.remark_bound(form.bound(reach));
        Ok(made)
    }
}
