//! Poses of motions: from documents and from tables, with their times.

use std::f64::consts::TAU;

use cyclide::{
    Point3, Quat, ShortNumber,
    error::PoseError,
    motion::{Pose, PoseLimit, PoseTimes, TimedPose},
};

use crate::document::angle::Angle;
use crate::document::kinds::motion::{AT_REST, MotionKind, MotionSpec, PoseSource, PoseSpec, PoseTolerance};
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::error::{Error, Result};
use crate::input::points::{SIX_DECIMALS, UNITS_ASSUMED, read_poses, whole_turns};

/// Matrices that are off a rotation by this much are written with three decimals: the nearest one is taken, and said.
const FEW_DECIMALS: f64 = 2e-3;

/// A last pose that is off the first by this part of the extent of all, and by as many radians, is the first: so many digits are written.
const SAME_POSE: f64 = 1e-6;

impl Builder<'_> {
    /// The poses, and whether times were given for them.
    pub(in crate::document) fn poses(
        &mut self,
        spec: &MotionSpec,
        source: &PoseSource,
    ) -> Result<(Vec<TimedPose>, bool)> {
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
                let rising = matches!(
                    spec.kind.unwrap_or_default(),
                    MotionKind::Spline | MotionKind::Linear | MotionKind::Sclerp
                );
                let table =
                    read_poses(&name, &bytes, file.columns.as_deref(), rising, FEW_DECIMALS).map_err(Error::Input)?;
                self.note_all(&name, &table.notes);
                if let Some(message) = table.taken_as_zero {
                    self.remark("taken-as-zero", None, None, Some(name.clone()), message);
                }
                if let Some(message) = table.columns_taken {
                    self.remark("columns-taken", None, None, Some(name.clone()), message);
                }
                if let Some(message) = table.seconds_assumed {
                    self.remark(UNITS_ASSUMED, None, None, Some(name.clone()), message);
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
                        "name the columns with _deg, as roll_deg or rotvec_x_deg",
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
            let message = "this pose has no `time`: set it for all poses or for none (the times are then 0, 1, 2, …)";
            return Err(Error::Input(self.diagnostic(["poses".into(), index.into()], message)));
        }
        if given > 0 && spec.times.is_some() {
            return Err(self.unfit("`times` are for poses without a `time`: remove one of the two"));
        }
        let (mut times, mut only): (Vec<Option<f64>>, Vec<Pose>) = made.into_iter().unzip();
        if spec.closed {
            self.close(spec, &mut times, &mut only)?;
        }
        let mut poses = match (spec.tool.unwrap_or_default().point(), spec.arm.unwrap_or(0.0)) {
            // Without times by the way the tool and the arm are looked at where they matter.
            (tool, arm) if spec.times.is_some() => spec.times.unwrap_or_default().of(&only, tool, arm),
            _ => PoseTimes::Uniform.of(&only, Point3::ORIGIN, 0.0),
        }
        .map_err(|e| self.pose_refused(spec, &e))?;
        poses.iter_mut().zip(times).for_each(|(pose, time)| pose.time = time.unwrap_or(pose.time));
        Ok((poses, given > 0))
    }

    /// Repeats the first pose at the end if it is missing there; an end that differs from it by rounding, or by noise, becomes equal to it.
    fn close(&self, spec: &MotionSpec, times: &mut Vec<Option<f64>>, poses: &mut Vec<Pose>) -> Result<()> {
        let [Some(first), Some(last)] = [poses.first().copied(), poses.last().copied()] else { return Ok(()) };
        let extent = poses.iter().map(|pose| (pose.translation() - first.translation()).length()).fold(0.0, f64::max);
        let size = poses.iter().map(|pose| pose.translation().max_abs()).fold(0.0, f64::max);
        let apart = (last.translation() - first.translation()).length();
        let is_first = apart <= (SAME_POSE * extent).max(AT_REST * size) && last.angle_to(first) <= SAME_POSE;
        let timed = times.iter().any(Option::is_some);
        let is_near = timed
            && spec.tolerance.map(PoseTolerance::limits).is_some_and(|tolerance| {
                // Both are off by the noise.
                let within = |limit: Option<PoseLimit>| match limit {
                    Some(PoseLimit::Within(limit)) => limit,
                    _ => 0.0,
                };
                let turned = last.angle_to(first);
                apart <= 2.0 * within(tolerance.place).max(SAME_POSE * extent)
                    && turned <= 2.0 * within(tolerance.angle).max(SAME_POSE)
            });
        if (is_first || is_near) && poses.len() > 2 {
            poses.pop();
        } else if timed {
            let message = format!(
                "a `closed` motion with times must repeat its first pose at the end, with the time of its return; the last pose is {} and {} rad from the first",
                ShortNumber(apart),
                ShortNumber(last.angle_to(first))
            );
            return Err(Error::Input(self.diagnostic(["poses".into()], &message)));
        } else {
            times.push(None);
        }
        poses.push(first);
        Ok(())
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
            "{count} matrices are not exact rotations (this one deviates by {}), as with few decimals: the nearest rotations are used (the limit is {})",
            ShortNumber(off),
            ShortNumber(FEW_DECIMALS)
        );
        self.remark("matrices-rounded", None, None, place, message);
    }

    /// Says that an angle differs by a turn or more from that of the pose before.
    fn remark_whole_turns(&mut self, change: f64, place: Option<String>) {
        let message = format!(
            "the angle differs by {} degrees from that of the previous pose: a pose is a rotation without a count of \
             turns, so the motion takes the shorter path; add poses in between, less than half a turn apart",
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
                        let message = "the matrix is in column-major order: write its rows, each a row of the rotation followed by a coordinate of the position, with `0, 0, 0, 1` last";
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
                let message = "a pose is a `position`, optionally with a `quaternion` or `rpy`, or only a `matrix`";
                return Err(Error::Input(self.diagnostic(steps(), message)));
            }
        };
        made.map_err(|e| {
            // The kernel sees one pose at a time.
            let e = if let cyclide::Error::Pose(PoseError::ZeroRotation { .. }) = e {
                cyclide::Error::Pose(PoseError::ZeroRotation { index })
            } else {
                e
            };
            self.refused_at(steps(), &e)
        })
    }
}
