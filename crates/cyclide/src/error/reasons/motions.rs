//! Errors about displacements and motions.
//!
//! # `zero-rotation`
//! A quaternion of length 0 is not a rotation.
//! ```
//! use cyclide::{Quat, Vec3, motion::Pose};
//! assert_eq!(Pose::new(Quat::ZERO, Vec3::ZERO).unwrap_err().reason(), "zero-rotation");
//! ```
//!
//! # `not-a-rotation`
//! A matrix mirrors.
//! ```
//! use cyclide::motion::Pose;
//! let mirror = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
//! assert_eq!(Pose::from_matrix(mirror).unwrap_err().reason(), "not-a-rotation");
//! ```
//!
//! # `not-on-study-quadric`
//! The parts of a dual quaternion are not perpendicular.
//! ```
//! use cyclide::{Quat, motion::{DualQuat, StudyPoint}};
//! let off = DualQuat { real: Quat::ONE, dual: Quat::new(1.0, 1.0, 0.0, 0.0) };
//! assert_eq!(StudyPoint::new(off).unwrap_err().reason(), "not-on-study-quadric");
//! ```
//!
//! # `wrong-pose-count`
//! A motion of degree 2 needs three poses.
//! ```
//! use cyclide::motion::RationalMotion;
//! assert_eq!(RationalMotion::conic(&[]).unwrap_err().reason(), "wrong-pose-count");
//! ```
//!
//! # `parameters-not-increasing`
//! The times of the poses of a spline, or the knots of a Moebius spline, do not increase. Of other curves an interval is named
//! instead, [`empty-interval`](super::tori#empty-interval); where poses may come in any order, only `repeated-parameter` is an
//! error.
//! ```
//! use cyclide::motion::{Pose, RationalMotion, TimedPose};
//! let poses = [0.0, 2.0, 1.0].map(|time| TimedPose { time, pose: Pose::IDENTITY });
//! assert_eq!(RationalMotion::spline(&poses).unwrap_err().reason(), "parameters-not-increasing");
//! ```
//!
//! # `unattainable-pose`
//! Two poses differ by a translation: a motion of degree 2 then misses the third.
//! ```
//! use cyclide::{Quat, Vec3, motion::{Pose, RationalMotion, TimedPose}};
//! let at = |time: f64, q: [f64; 4], x: [f64; 3]| TimedPose { time, pose: Pose::new(q.into(), x.into()).unwrap() };
//! let still = [1.0, 0.0, 0.0, 0.0];
//! let poses =
//!     [at(0.0, still, [0.0; 3]), at(0.5, still, [1.0, 0.0, 0.0]), at(1.0, [0.6, 0.0, 0.8, 0.0], [1.0, 1.0, 1.0])];
//! let error = RationalMotion::conic(&poses).unwrap_err();
//! assert_eq!(error.index(), Some(2));
//! assert_eq!(error.reason(), "unattainable-pose");
//! ```
//!
//! # `motion-through-exceptional-point`
//! The body turns forth and back about one axis while it slides on: in between it passes through infinity.
//! ```
//! use cyclide::{Quat, Vec3, motion::{Pose, RationalMotion, TimedPose}};
//! let at = |time: f64, q: [f64; 4], z: f64| TimedPose { time, pose: Pose::new(q.into(), Vec3::Z * z).unwrap() };
//! let poses = [at(0.0, [0.8, 0.0, 0.0, 0.6], 0.0), at(0.5, [1.0, 0.0, 0.0, 0.0], 3.0), at(1.0, [0.8, 0.0, 0.0, -0.6], 2.0)];
//! assert_eq!(RationalMotion::conic(&poses).unwrap_err().reason(), "motion-through-exceptional-point");
//! ```
//!
//! # `rotation-too-large`
//! Times are so uneven that the spline swings out: halfway its quaternion vanishes, and the direction is undefined.
//! ```
//! use cyclide::{Quat, Vec3, motion::{Pose, RationalMotion, TimedPose}};
//! let cosine = 40_f64.to_radians().cos();
//! let step = 0.5 * ((1.0 + (1.0 - cosine) / cosine).sqrt() - 1.0); // this time is the worst
//! let at = |time: f64, degrees: f64| TimedPose {
//!     time,
//!     pose: Pose::new(Quat::from_axis_angle(Vec3::Z, degrees.to_radians()), Vec3::ZERO).unwrap(),
//! };
//! let poses = [at(0.0, 0.0), at(step, -80.0), at(1.0 + step, 80.0), at(1.0 + 2.0 * step, 0.0)];
//! let error = RationalMotion::spline(&poses).unwrap_err();
//! assert_eq!(error.reason(), "rotation-too-large");
//! ```
//!
//! # `no-cubic-motion`
//! Motions of degree 3 pass through these poses only at certain cross-ratios of the times; 1/3 is not one of them.
//! ```
//! use cyclide::{Quat, Vec3, motion::{CubicMotions, Pose}};
//! let pose = |w: f64, y: f64, x: f64, z: f64| Pose::new(Quat::new(w, 0.3, y, 0.1), Vec3::new(x, 1.0, z));
//! let poses = [pose(1.0, 0.0, 0.0, 0.0)?, pose(1.0, 0.5, 1.0, 0.2)?, pose(0.8, 0.9, 2.2, 1.0)?, pose(0.4, 1.2, 3.0, 1.0)?];
//! let error = CubicMotions::new(&poses)?.motion(1.0 / 3.0, [0.0, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "no-cubic-motion");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `study-form-vanishes`
//! Poses that differ only by translations do not determine screws.
//! ```
//! use cyclide::{Quat, Vec3, motion::{CubicMotions, Pose}};
//! let poses = [0.0, 1.0, 4.0, 9.0].map(|x| Pose::new(Quat::ONE, Vec3::X * x).unwrap());
//! assert_eq!(CubicMotions::new(&poses).unwrap_err().reason(), "study-form-vanishes");
//! ```
//!
//! # `motion-not-rational`
//! A helix is not a rational curve.
//! ```
//! use cyclide::{Quat, Vec3, motion::{Motion, Pose, ScrewMotion, TimedPose}};
//! let end = Pose::new(Quat::new(1.0, 0.0, 0.0, 1.0), Vec3::Z)?;
//! let screw = ScrewMotion::new(&[TimedPose { time: 0.0, pose: Pose::IDENTITY }, TimedPose { time: 1.0, pose: end }])?;
//! assert_eq!(Motion::from(screw).rational().unwrap_err().reason(), "motion-not-rational");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `motion-at-rest`
//! A body turns about its origin, whose path has no length.
//! ```
//! use cyclide::{Point3, Quat, Vec3, motion::{Motion, Pose, ScrewMotion, TimeLaw, TimedPose, Timing}};
//! let end = Pose::new(Quat::new(1.0, 0.0, 0.0, 1.0), Vec3::ZERO)?;
//! let turn = ScrewMotion::new(&[TimedPose { time: 0.0, pose: Pose::IDENTITY }, TimedPose { time: 1.0, pose: end }])?;
//! let turn = Motion::from(turn);
//! let error = Timing::new(&turn, TimeLaw::ConstantSpeed, Point3::ORIGIN, 0.0).unwrap_err();
//! assert_eq!(error.reason(), "motion-at-rest");
//! assert!(Timing::new(&turn, TimeLaw::ConstantSpeed, Point3::ORIGIN, 1.0).is_ok()); // by the turn
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `span-without-way`
//! A body moves, turns in place, and moves on, at a constant speed of its origin: the turn would take no time.
//! ```
//! use cyclide::{Point3, Quat, Vec3, motion::{Motion, Pose, ScrewMotion, TimeLaw, TimedPose, Timing}};
//! let at = |time: f64, x: f64, turned: f64| TimedPose { time, pose: Pose::new(Quat::new(1.0, 0.0, 0.0, turned), Vec3::X * x).unwrap() };
//! let motion = Motion::from(ScrewMotion::new(&[at(0.0, 0.0, 0.0), at(1.0, 5.0, 0.0), at(2.0, 5.0, 1.0), at(3.0, 9.0, 1.0)])?);
//! let error = Timing::new(&motion, TimeLaw::ConstantSpeed, Point3::ORIGIN, 0.0).unwrap_err();
//! assert_eq!(error.reason(), "span-without-way");
//! assert_eq!(error.index(), Some(1));
//! assert!(Timing::new(&motion, TimeLaw::ConstantSpeed, Point3::ORIGIN, 0.1).is_ok()); // with the turn
//! # Ok::<(), cyclide::Error>(())
//! ```
