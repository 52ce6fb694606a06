//! Motions of bodies, paths of their points, and what their curves run over.

use cyclide::{
    BodyMesh, CubicMotions, CurveObject, Motion, MovingBody, Point3, Pose, PoseTimes, Quat, RationalMotion,
    ScrewMotion, ShortNumber, SurfaceObject, SweptSurface, TimeLaw, TimedPose, Vec3, bounds,
};

use super::{Builder, NO_EFFECT};
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::locate::Step;
use crate::document::spec::{
    MotionKind, MotionSpec, ObjectSpec, PoseSource, PoseSpec, StartSpec, SweepEnds, SweptSurfaceSpec, TrajectorySpec,
};
use crate::error::{Error, Result};
use crate::input::points::{SIX_DECIMALS, read_poses, whole_turns};
use std::f64::consts::TAU;

/// Matrices that are off a rotation by this much are written with three decimals: the nearest one is taken, and said.
const FEW_DECIMALS: f64 = 2e-3;

/// Roundings of the largest coordinate within which the path of a point is one point: of the products with the rotation and their sums.
const AT_REST: f64 = 64.0 * f64::EPSILON;

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
    /// The moving body of an object that is one.
    pub(super) fn moving_body(&mut self) -> Result<Option<MovingBody>> {
        match self.spec {
            ObjectSpec::Motion(spec) => self.motion(spec).map(Some),
            _ => Ok(None),
        }
    }

    fn motion(&mut self, spec: &MotionSpec) -> Result<MovingBody> {
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
        let (poses, timed) = self.poses(spec, source)?;
        let motion = match kind {
            MotionKind::Spline => RationalMotion::spline(&poses).map(Motion::from),
            MotionKind::Sclerp => ScrewMotion::new(&poses).map(Motion::from),
            MotionKind::Conic => RationalMotion::conic(&poses).map(Motion::from),
            MotionKind::Quartic => RationalMotion::quartic(&poses).map(Motion::from),
            MotionKind::Cubic => return self.cubic(spec, &poses, timed),
        };
        let motion = motion.map_err(|e| self.pose_refused(&e))?;
        let [first, last] = motion.domain();
        self.body(spec, motion, last - first)
    }

    /// The motion that a curve carries.
    fn along(&mut self, spec: &MotionSpec, curve: &str) -> Result<MovingBody> {
        if spec.kind.is_some() {
            return Err(self.unfit("`kind` is how a body goes from pose to pose: `along` a curve there is one way"));
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

    /// The poses, and whether times were given for them.
    fn poses(&mut self, spec: &MotionSpec, source: &PoseSource) -> Result<(Vec<TimedPose>, bool)> {
        let made: Vec<(Option<f64>, Pose)> = match source {
            PoseSource::Inline(list) => {
                self.remark_wide_angles(list);
                let made = list.iter().enumerate().map(|(i, pose)| self.pose(i, pose).map(|made| (pose.time, made)));
                let made: Vec<(Option<f64>, (Pose, f64))> = made.collect::<Result<_>>()?;
                let off = made.iter().enumerate().filter(|(_, (_, (_, off)))| *off > SIX_DECIMALS);
                if let Some((first, (_, (_, most)))) = off.clone().max_by(|a, b| a.1.1.1.total_cmp(&b.1.1.1)) {
                    let place = self.place_of(["poses".into(), first.into()]);
                    self.remark_rounded_matrices(off.count(), *most, place);
                }
                made.into_iter().map(|(time, (pose, _))| (time, pose)).collect()
            }
            PoseSource::File(file) => {
                let (name, bytes) = self.file(&file.csv, ["poses", "csv"])?;
                let rising = matches!(spec.kind.unwrap_or_default(), MotionKind::Spline | MotionKind::Sclerp);
                let table = read_poses(&name, &bytes, rising, FEW_DECIMALS).map_err(Error::Input)?;
                if let Some(message) = table.taken_as_zero {
                    self.remark("taken-as-zero", None, None, Some(name.clone()), message);
                }
                if let Some((count, line, off)) = table.rounded_matrices {
                    self.remark_rounded_matrices(count, off, Some(format!("{name}:{line}")));
                }
                self.remark_units(&name, &table.unit_hints);
                if let Some(message) = table.unit_not_applied {
                    self.remark("unit-not-applied", None, None, Some(name.clone()), message);
                }
                if let Some((line, angle)) = table.more_than_a_turn {
                    self.ask_about_turns(
                        angle,
                        Some(format!("{name}:{line}")),
                        "name the columns roll_deg, pitch_deg, yaw_deg",
                    );
                } else if let Some((line, change)) = table.whole_turns {
                    self.remark_whole_turns(change, Some(format!("{name}:{line}")));
                }
                table.poses.into_iter().map(|row| (row.time, row.pose)).collect()
            }
        };
        let given = made.iter().filter(|(time, _)| time.is_some()).count();
        if given != 0 && given != made.len() {
            let index = made.iter().position(|(time, _)| time.is_none()).unwrap_or(0);
            let message = "this pose has no `time`: give one to all, or to none (then they are 0, 1, 2, …)";
            return Err(Error::Input(self.diagnostic(["poses".into(), index.into()], message)));
        }
        if given > 0 && spec.times.is_some() {
            return Err(self.unfit("`times` are for poses without a `time`: leave one of both out"));
        }
        let (times, only): (Vec<Option<f64>>, Vec<Pose>) = made.into_iter().unzip();
        let mut poses = match (spec.tool.unwrap_or_default().point(), spec.arm.unwrap_or(0.0)) {
            // Without times by the way the tool and the arm are looked at where they matter.
            (tool, arm) if spec.times.is_some() => spec.times.unwrap_or_default().of(&only, tool, arm),
            _ => PoseTimes::Uniform.of(&only, Point3::ORIGIN, 0.0),
        }
        .map_err(|e| self.pose_refused(&e))?;
        poses.iter_mut().zip(times).for_each(|(pose, time)| pose.time = time.unwrap_or(pose.time));
        Ok((poses, given > 0))
    }

    /// Asks about angles of the document of more than a turn: whether degrees are meant, and whether turns that no pose can say.
    fn remark_wide_angles(&mut self, list: &[PoseSpec]) {
        let angles = || list.iter().enumerate().filter_map(|(i, pose)| pose.rpy.map(|angles| (i, angles)));
        let wide = angles().flat_map(|(i, angles)| (0..3).map(move |k| (i, k, angles[k]))).find_map(|at| match at {
            (i, k, Angle::Radians(angle)) if angle.abs() > TAU => Some((i, k, angle)),
            _ => None,
        });
        let place = |i: usize, k: usize| ["poses".into(), i.into(), "rpy".into(), k.into()];
        if let Some((i, k, angle)) = wide {
            let place = self.place_of(place(i, k));
            return self.ask_about_turns(angle, place, &format!("write `{{\"degrees\": {angle}}}`"));
        }
        let mut before: Option<[f64; 3]> = None;
        for (i, pose) in list.iter().enumerate() {
            let turned = pose.quaternion.is_some() || pose.matrix.is_some();
            // Without a rotation it is not turned.
            let angles = (!turned).then(|| pose.rpy.map_or([0.0; 3], |angles| angles.map(Angle::radians)));
            if let Some((k, change)) = before.zip(angles).and_then(|(before, angles)| whole_turns(before, angles)) {
                let place = self.place_of(place(i, k));
                return self.remark_whole_turns(change, place);
            }
            before = angles;
        }
    }

    /// Says that matrices are none of displacements but for the digits they are written with.
    fn remark_rounded_matrices(&mut self, count: usize, off: f64, place: Option<String>) {
        let message = format!(
            "{count} matrices are off those of rotations, this one by {}, as with few decimals: the nearest rotations are taken (more than {} is refused)",
            ShortNumber(off),
            ShortNumber(FEW_DECIMALS)
        );
        self.remark("matrices-rounded", None, None, place, message);
    }

    /// Says that an angle differs by a turn or more from that of the pose before.
    fn remark_whole_turns(&mut self, change: f64, place: Option<String>) {
        let message = format!(
            "the angle differs by {} degrees from that of the pose before: a pose says how the body is turned and not how often it came round, so it goes the shorter way; \
             give poses in between, less than half a turn apart",
            ShortNumber(change.to_degrees())
        );
        self.remark("whole-turns", None, None, place, message);
    }

    /// One pose of the document, and by how much its matrix is off.
    fn pose(&self, index: usize, spec: &PoseSpec) -> Result<(Pose, f64)> {
        let steps = || [Step::from("poses"), Step::from(index)];
        let position = spec.position.unwrap_or_default();
        let exact = |made: cyclide::Result<Pose>| made.map(|pose| (pose, 0.0));
        let made = match (&spec.matrix, spec.quaternion, spec.rpy) {
            (Some(rows), None, None) if spec.position.is_none() => {
                let mut matrix = [[0.0, 0.0, 0.0, 1.0]; 4];
                if !(3..=4).contains(&rows.len()) {
                    let message = format!("a matrix has three rows, or four, not {}", rows.len());
                    return Err(Error::Input(self.diagnostic(steps().into_iter().chain(["matrix".into()]), &message)));
                }
                matrix.iter_mut().zip(rows).for_each(|(to, row)| *to = *row);
                let transposed = std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i]));
                match Pose::nearest_to_matrix(matrix, FEW_DECIMALS) {
                    Err(_) if rows.len() == 4 && Pose::nearest_to_matrix(transposed, FEW_DECIMALS).is_ok() => {
                        let message = "the matrix stands column by column: write its rows, those of the rotation with the position behind them and `0, 0, 0, 1` last";
                        return Err(Error::Input(
                            self.diagnostic(steps().into_iter().chain(["matrix".into()]), message),
                        ));
                    }
                    made => made,
                }
            }
            (None, Some(quaternion), None) => exact(Pose::new(Quat::from(quaternion), position.vector())),
            (None, None, Some(angles)) => {
                exact(Pose::from_roll_pitch_yaw(position.vector(), angles.map(Angle::radians)))
            }
            (None, None, None) if spec.position.is_some() => exact(Pose::new(Quat::ONE, position.vector())),
            _ => {
                let message =
                    "a pose is a `position` with a `quaternion` or `rpy` (or not turned), or a `matrix` alone";
                return Err(Error::Input(self.diagnostic(steps(), message)));
            }
        };
        made.map_err(|e| {
            // The kernel sees one pose at a time.
            let e =
                if let cyclide::Error::ZeroRotation { .. } = e { cyclide::Error::ZeroRotation { index } } else { e };
            self.refused_at(steps(), &e)
        })
    }

    /// What the kernel refused of the poses, at the one it is about.
    fn pose_refused(&self, error: &cyclide::Error) -> Error {
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
    pub(super) fn trajectory(&self, spec: &TrajectorySpec) -> Result<CurveObject> {
        let body = self.motion_source()?;
        let point = spec.point.map_or(body.tool(), Coordinates::point);
        let made = body.motion().rational().and_then(|motion| motion.trajectory(point));
        let path = made.map_err(|e| self.refused_at(["of".into()], &e))?;
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
        Ok(CurveObject::Nurbs(path))
    }

    /// What the contours of a curve run over.
    pub(super) fn swept_surface(&mut self, spec: &SweptSurfaceSpec) -> Result<Vec<SurfaceObject>> {
        let motion = self.motion_source()?.motion().clone();
        let contours = self.sources[1].item.curves().to_vec();
        if contours.is_empty() {
            let message = format!("`{}` has no curve: a profile is a curve", spec.profile);
            return Err(Error::Input(self.diagnostic(["profile".into()], &message)));
        }
        let motion = motion.rational().map_err(|e| self.refused_at(["of".into()], &e))?;
        let mut made = Vec::with_capacity(contours.len());
        for (contour, curve) in contours.iter().enumerate() {
            let lean = lean_of_section(curve, motion);
            let make = if spec.ends == SweepEnds::Flat { SweptSurface::solid } else { SweptSurface::new };
            let swept = curve.exact_pieces().and_then(|(pieces, closed)| make(&pieces, closed, motion));
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
        }
        Ok(made)
    }
}
