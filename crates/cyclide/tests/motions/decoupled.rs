//! Motions whose place and turn go apart: straight lines and slerp, blends, curves, smoothed noise.

use crate::data::{apart, pose, timed};
use cyclide::{
    Point3, Quat, Vec3, Warning,
    construct::FairSplineOptions,
    curve::CircleSpline,
    motion::{DecoupledMotion, Motion, MotionTolerance, Pose, PoseLimit, RationalMotion, TimedPose},
    warning::{MotionWarning, PoseFitWarning},
};
use proptest::prelude::*;

fn at(time: f64, place: [f64; 3], turn: f64) -> TimedPose {
    TimedPose { time, pose: Pose::new(Quat::from_axis_angle(Vec3::Z, turn), Vec3::from(place)).unwrap() }
}

fn changed(poses: &[TimedPose], change: impl Fn(Pose) -> Pose) -> Vec<TimedPose> {
    poses.iter().map(|p| TimedPose { time: p.time, pose: change(p.pose) }).collect()
}

fn on_fair(poses: &[TimedPose], closing: Option<f64>) -> DecoupledMotion {
    let closed = closing.is_some();
    let points = DecoupledMotion::places_of_curve(poses, closed);
    let curve = CircleSpline::fair(&points, &FairSplineOptions { closed, ..Default::default() }).unwrap();
    DecoupledMotion::on_curve(poses, closing, curve).unwrap()
}

/// The motions of each rule through poses.
fn all(poses: &[TimedPose]) -> [DecoupledMotion; 4] {
    [
        DecoupledMotion::linear(poses, None, 0.0).unwrap(),
        DecoupledMotion::linear(poses, None, 0.2).unwrap(),
        DecoupledMotion::polyline(poses, None).unwrap(),
        on_fair(poses, None),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, ..ProptestConfig::default() })]

    /// Straight lines in proportion to the time, and the turns of slerp, worked out from the two poses alone.
    #[test]
    fn linear_motions_are_straight_and_slerp(poses in timed(2..7), part in 0.0..1.0_f64) {
        let motion = DecoupledMotion::linear(&poses, None, 0.0).unwrap();
        for pair in poses.windows(2) {
            let time = pair[0].time + (pair[1].time - pair[0].time) * part;
            let part = (time - pair[0].time) / (pair[1].time - pair[0].time);
            let got = motion.pose(time);
            let [a, b] = [pair[0].pose, pair[1].pose];
            let place = a.translation() * (1.0 - part) + b.translation() * part;
            prop_assert!((got.translation() - place).length() < 1e-12);
            let [p, mut q] = [a.rotation(), b.rotation()];
            if p.dot(q) < 0.0 {
                q = -q;
            }
            let angle = p.dot(q).min(1.0).acos();
            prop_assume!(angle > 1e-3);
            let slerp = p * (((1.0 - part) * angle).sin() / angle.sin()) + q * ((part * angle).sin() / angle.sin());
            prop_assert!(got.angle_to(Pose::new(slerp, Vec3::ZERO).unwrap()) < 1e-9);
            // Neither accelerates on the way.
            let jet = motion.jet(time, Point3::ORIGIN);
            prop_assert!(jet.point.d2.length() <= 0.0 && jet.angular_acceleration.length() <= 0.0);
        }
        prop_assert!(Motion::from(motion).off_chords().unwrap().distance <= 0.0);
    }

    /// The world may be moved and turned, and the axes of the body turned; only its origin is what goes straight. Time runs backwards as forwards.
    #[test]
    fn frames_and_reversal_do_not_matter(poses in timed(2..6), left in pose(), right in pose()) {
        let right = Pose::new(right.rotation(), Vec3::ZERO).unwrap();
        let moved = changed(&poses, |p| left.after(p).after(right));
        let back: Vec<TimedPose> = poses.iter().rev().map(|p| TimedPose { time: -p.time, pose: p.pose }).collect();
        for ((one, other), back) in all(&poses).iter().zip(&all(&moved)).zip(&all(&back)) {
            let [first, last] = [one.times()[0], one.times()[one.times().len() - 1]];
            for k in 0..=20 {
                let time = first + (last - first) * f64::from(k) / 20.0;
                let expected = left.after(one.pose(time)).after(right);
                prop_assert!(apart(other.pose(time), expected) < 1e-9, "{time}");
                prop_assert!(apart(back.pose(-time), one.pose(time)) < 1e-9, "{time}");
            }
        }
    }

    /// Derivatives are those of the places nearby; at joints all but straight lines are C1.
    #[test]
    fn jets_are_derivatives_and_joints_are_smooth(poses in timed(3..6)) {
        let point = Point3::new(0.3, -0.2, 0.5);
        for (kind, motion) in all(&poses).into_iter().enumerate() {
            let (times, motion) = (motion.times().to_vec(), Motion::from(motion));
            for ends in times.windows(2) {
                let (time, h) = (0.4 * ends[0] + 0.6 * ends[1], 1e-5 * (ends[1] - ends[0]));
                let [before, own, after] = [time - h, time, time + h].map(|t| motion.jet(t, point));
                let speed = own.point.d1.length() + own.point.d2.length() + own.point.d3.length() + 1.0;
                prop_assert!(((after.point.point - before.point.point) / (2.0 * h) - own.point.d1).length() < 1e-5 * speed);
                prop_assert!(((after.point.d1 - before.point.d1) / (2.0 * h) - own.point.d2).length() < 1e-4 * speed);
                prop_assert!((motion.pose(time).apply(point) - own.point.point).length() < 1e-12);
            }
            // Beside a joint both are a millionth of a span away.
            let smooth = kind == 1 || kind == 3;
            for triple in times.windows(3).filter(|_| smooth) {
                let h = 1e-7 * (triple[2] - triple[1]).min(triple[1] - triple[0]);
                let [before, after] = [triple[1] - h, triple[1] + h].map(|t| motion.jet(t, Point3::ORIGIN));
                let size = before.point.d1.length() + before.point.d2.length() + 1.0;
                prop_assert!((before.point.d1 - after.point.d1).length() < 1e-4 * size, "{kind}");
                let turning = before.angular_velocity.length() + before.angular_acceleration.length() + 1.0;
                prop_assert!((before.angular_velocity - after.angular_velocity).length() < 1e-4 * turning, "{kind}");
            }
        }
    }

    /// The rational form is within its bound, and C0 where the motion is.
    #[test]
    fn rational_forms_keep_their_bounds(poses in timed(2..5)) {
        for motion in all(&poses) {
            let motion = Motion::from(motion);
            let form = motion.to_rational().unwrap();
            let (point, [first, last]) = (Point3::new(1.0, 2.0, -2.0), motion.domain());
            // Random places turn so sharply that a fair curve is hard to follow.
            prop_assert!(form.bound(3.0) < 1e-5);
            for k in 0..=60 {
                let time = first + (last - first) * f64::from(k) / 60.0;
                let off = form.motion().pose(time).apply(point).distance(motion.pose(time).apply(point));
                prop_assert!(off <= 1.5 * form.bound(3.0) + 1e-11, "{off} {}", form.bound(3.0));
            }
        }
    }

    /// Closed motions go on as they began, whichever way the body came round.
    #[test]
    fn closed_motions_close_c1(poses in timed(3..6), wait in 0.5..2.0_f64) {
        let closing = poses[poses.len() - 1].time + wait;
        let spline = RationalMotion::closed_spline(&poses, closing).map(Motion::from);
        let fair = Ok(Motion::from(on_fair(&poses, Some(closing))));
        let blended = DecoupledMotion::linear(&poses, Some(closing), 0.1).map(Motion::from);
        for motion in [spline, fair, blended].into_iter().flatten() {
            let [first, last] = motion.domain();
            prop_assert!((last - closing).abs() <= 0.0);
            prop_assert!(apart(motion.pose(first), motion.pose(last)) < 1e-9);
            let [start, end] = [first, last].map(|time| motion.jet(time, Point3::new(0.1, 0.2, 0.3)));
            let size = 1.0 + start.point.d1.length();
            prop_assert!((start.point.d1 - end.point.d1).length() < 1e-9 * size);
            prop_assert!((start.angular_velocity - end.angular_velocity).length() < 1e-9 * size);
        }
    }
}

/// A body that comes round once has the other quaternion at the end, and goes on all the same.
#[test]
fn a_whole_turn_closes_smoothly() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let poses: Vec<TimedPose> = [[50.0, 0.0, 0.0], [0.0, 50.0, 10.0], [-50.0, 0.0, 0.0], [0.0, -50.0, 10.0]]
        .into_iter()
        .zip(0..)
        .map(|(place, k)| at(f64::from(k), place, quarter * f64::from(k)))
        .collect();
    let kinds = [
        Motion::from(RationalMotion::closed_spline(&poses, 4.0).unwrap()),
        on_fair(&poses, Some(4.0)).into(),
        DecoupledMotion::linear(&poses, Some(4.0), 5.0).unwrap().into(),
    ];
    for motion in kinds {
        assert!((motion.turn() - 4.0 * quarter).abs() < 1e-9, "all round");
        let [start, end] = [0.0, 4.0].map(|time| motion.jet(time, Point3::new(10.0, 0.0, 0.0)));
        assert!((start.point.d1 - end.point.d1).length() < 1e-9 && start.point.d1.length() > 10.0);
        assert!((start.angular_velocity - end.angular_velocity).length() < 1e-12);
    }
}

/// A blend leaves the line at the radius and passes the pose at a quarter of the change of velocity times half its time, with constant acceleration.
#[test]
fn blends_are_parabolas_within_the_radius() {
    let poses = [at(0.0, [0.0; 3], 0.0), at(1.0, [100.0, 0.0, 0.0], 0.0), at(2.0, [100.0, 100.0, 0.0], 1.0)];
    let motion = DecoupledMotion::linear(&poses, None, 10.0).unwrap();
    // At 100 per second the radius is left 0.1 seconds before and after.
    assert_eq!(motion.times(), [0.0, 0.9, 1.0, 1.1, 2.0]);
    assert!((motion.pose(0.9).translation() - Vec3::new(90.0, 0.0, 0.0)).length() < 1e-12);
    assert!((motion.pose(1.1).translation() - Vec3::new(100.0, 10.0, 0.0)).length() < 1e-12);
    // The middle of the parabola: (90 + 2·100 + 100)/4 along x.
    assert!((motion.pose(1.0).translation() - Vec3::new(97.5, 2.5, 0.0)).length() < 1e-12);
    for time in [0.92, 0.99, 1.05] {
        let jet = motion.jet(time, Point3::ORIGIN);
        assert!((jet.point.d2 - Vec3::new(-500.0, 500.0, 0.0)).length() < 1e-9);
    }
    assert_eq!(motion.warnings(), []);
    // Beside the blends it is the motion without.
    let straight = DecoupledMotion::linear(&poses, None, 0.0).unwrap();
    for time in [0.3, 0.85, 1.2, 1.7] {
        assert!(apart(motion.pose(time), straight.pose(time)) < 1e-12);
    }
    // What does not fit takes half of the way, and is said.
    let wide = DecoupledMotion::linear(&poses, None, 80.0).unwrap();
    let [Warning::Motion(MotionWarning::BlendsShortened { pose: 1, count: 1, radius, asked })] = wide.warnings()[..]
    else {
        panic!("{wide:?}")
    };
    assert!((radius - 50.0).abs() < 1e-12 && (asked - 80.0).abs() <= 0.0);
    let error = DecoupledMotion::linear(&poses, None, -1.0).unwrap_err();
    assert_eq!(error.reason(), "parameter-out-of-range");
}

/// Where poses turn on the spot or slide without a turn, place and turn stay where they are; a curve runs through the others.
#[test]
fn nothing_rocks() {
    let poses = [
        at(0.0, [0.0; 3], 0.0),
        at(1.0, [0.0, 0.0, 1.0], 0.0),
        at(2.0, [0.0, 0.0, 1.0], 1.5),
        at(3.0, [0.0, 1.0, 0.0], 1.5),
        at(4.0, [3.0, 1.0, 0.0], 1.5),
    ];
    for motion in [on_fair(&poses, None), DecoupledMotion::polyline(&poses, None).unwrap()] {
        for k in 0..=50 {
            let part = f64::from(k) / 50.0;
            assert!(motion.pose(part).angle_to(poses[0].pose) < 1e-14);
            assert!((motion.pose(1.0 + part).translation() - Vec3::Z).length() < 1e-14);
            assert!(motion.pose(2.0 + 2.0 * part).angle_to(poses[2].pose) < 1e-14);
        }
        // It turns one way only.
        let turns = (0..=50).map(|k| motion.pose(1.0 + f64::from(k) / 50.0).angle_to(poses[0].pose));
        assert!(turns.collect::<Vec<_>>().windows(2).all(|pair| pair[1] >= pair[0]));
    }
}

/// Noise of poses on a slow motion is taken away within the tolerances, and what they are on comes out.
#[test]
fn noise_is_smoothed_within_tolerances() {
    let mut state = 1_u64;
    let mut noise = || {
        let mut sum = -6.0;
        for _ in 0..12 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            sum += (state >> 11) as f64 / 9_007_199_254_740_992.0;
        }
        sum
    };
    let truth = |t: f64| (Vec3::new(800.0 * t, 300.0 * (2.0 * t).sin(), 50.0 * t * t), 0.6 * (1.5 * t).sin());
    let poses: Vec<TimedPose> = (0..400)
        .map(|k| {
            let time = f64::from(k) * 0.01;
            let (place, yaw) = truth(time);
            let turn = Quat::from_axis_angle(Vec3::new(noise(), noise(), noise()), 0.003 * noise())
                * Quat::from_axis_angle(Vec3::Z, yaw);
            TimedPose { time, pose: Pose::new(turn, place + Vec3::new(noise(), noise(), noise()) * 2.0).unwrap() }
        })
        .collect();
    let tolerance = MotionTolerance { place: Some(7.0.into()), angle: Some(0.014.into()) };
    let motion = DecoupledMotion::smoothed(&poses, tolerance).unwrap();
    let off = motion.deviation().unwrap();
    assert!(off.place <= 7.0 && off.angle <= 0.014, "{off:?}");
    let measured = poses.iter().map(|p| (motion.pose(p.time).translation() - p.pose.translation()).length());
    assert!((measured.fold(0.0, f64::max) - off.place).abs() < 1e-9);
    for k in 20..380 {
        let time = f64::from(k) * 0.01;
        let jet = motion.jet(time, Point3::ORIGIN);
        let (place, _) = truth(time);
        assert!((jet.point.point.to_vec() - place).length() < 5.0, "{time}");
        // The truth has up to 1200, the noise 2/0.01² = 2e4 times as much as one.
        assert!(jet.point.d2.length() < 3000.0, "{time} {}", jet.point.d2.length());
    }
    let spline = RationalMotion::spline(&poses).unwrap();
    let most = (0..399).map(|k| spline.jet(0.01 * f64::from(k), Point3::ORIGIN).point.d2.length()).fold(0.0, f64::max);
    assert!(most > 3e4, "{most}");
    // What noise makes of the farthest of all poses is said if it is more, with what would do: of 400 poses 3.77 standard deviations, and room.
    assert_eq!(
        DecoupledMotion::smoothed(&poses, MotionTolerance { place: Some(8.7.into()), ..tolerance }).unwrap().warnings(),
        []
    );
    let [Warning::PoseFit(PoseFitWarning::PosesNoisier { turning: false, sigma, needed, .. })] = motion.warnings()[..]
    else {
        panic!("7 of 8")
    };
    assert!((sigma - 2.0).abs() < 0.2 && (4.2..4.5).contains(&(needed / sigma)), "{sigma} {needed}");
    // Where the smoothest motion within a tolerance is farther from the truth than the poses are, that is said, with what would do.
    let rms = |motion: &DecoupledMotion| {
        let off = poses.iter().map(|p| (motion.pose(p.time).translation() - truth(p.time).0).length_squared());
        (off.sum::<f64>() / poses.len() as f64).sqrt()
    };
    let raw = 2.0 * 3.0_f64.sqrt();
    for (place, is_far) in [(8.7, false), (12.0, true), (16.0, true), (60.0, true)] {
        let motion =
            DecoupledMotion::smoothed(&poses, MotionTolerance { place: Some(place.into()), ..tolerance }).unwrap();
        let found = rms(&motion);
        match motion.warnings()[..] {
            [] => assert!(!is_far && found < 1.1 * raw, "{place}: {found}"),
            [Warning::PoseFit(PoseFitWarning::WiderThanNoise { turning: false, off, moves, .. })] => {
                assert!(is_far && found > moves && (0.9..1.1).contains(&(off / found)), "{place}: {off} of {found}");
                assert!((moves / raw - 1.0).abs() < 0.1, "{moves}");
            }
            _ => panic!("{place}: {:?}", motion.warnings()),
        }
    }
    // The noise alone decides better.
    let by_noise = MotionTolerance { place: Some(PoseLimit::ByNoise), angle: Some(PoseLimit::ByNoise) };
    let motion = DecoupledMotion::smoothed(&poses, by_noise).unwrap();
    assert!(rms(&motion) < 0.3 * raw && motion.warnings().is_empty(), "{} {:?}", rms(&motion), motion.warnings());
    let few = DecoupledMotion::smoothed(&poses[..19], by_noise).unwrap_err();
    assert_eq!(few.reason(), "wrong-pose-count");
    for wrong in [0.0, -1.0, f64::NAN] {
        let tolerance = MotionTolerance { place: Some(PoseLimit::Within(wrong)), angle: None };
        assert_eq!(DecoupledMotion::smoothed(&poses, tolerance).unwrap_err().reason(), "parameter-out-of-range");
    }
}

/// Poses without noise are left as they are, however far apart they are; a wrong pose among them is left out, or has little influence.
#[test]
fn exact_poses_are_no_noise() {
    let by_noise = MotionTolerance { place: Some(PoseLimit::ByNoise), angle: Some(PoseLimit::ByNoise) };
    let round = |v: f64| (v * 1e6).round() / 1e6;
    let truth = |t: f64| [300.0 * t.cos(), 200.0 * t.sin(), 50.0 * (2.0 * t).sin()];
    let pose = |t: f64| at(t, truth(t).map(round), round(0.3 * t.sin()));
    for count in [60, 200, 1000] {
        let times = (0..count).map(|k| 6.0 * f64::from(k) / f64::from(count));
        let mut poses: Vec<TimedPose> = times.map(pose).collect();
        let within = MotionTolerance { place: Some(1e-4.into()), angle: Some(1e-4.into()) };
        assert_eq!(DecoupledMotion::smoothed(&poses, within).unwrap().warnings(), [], "{count}");
        let motion = DecoupledMotion::smoothed(&poses, by_noise).unwrap();
        let off = motion.deviation().unwrap();
        assert!(off.place < 3e-6 && off.angle < 3e-6, "{count}: {off:?}");
        let wrong = poses[31];
        poses[31] = at(wrong.time, (wrong.pose.translation() + Vec3::X * 40.0).to_array(), 0.0);
        for drop in [false, true] {
            let motion = DecoupledMotion::smoothed_with(&poses, None, by_noise, drop).unwrap();
            let off = (motion.pose(wrong.time).translation() - wrong.pose.translation()).length();
            assert!(off < if drop { 1e-2 } else { 1.0 }, "{count} {drop}: {off}");
            assert!(motion.warnings().iter().any(|warning| warning.reason() == "outlier"));
        }
    }
}

/// Turned by a third of a turn, a pose is an outlier in angle; the others keep their noise, in one direction too.
#[test]
fn poses_turned_wrong_are_named_in_angle() {
    let wave = |k: u32| (0.11 * f64::from(k)).sin() + 0.5 * (1.7 * f64::from(k) * f64::from(k)).sin();
    let pose = |k: u32| {
        at(0.05 * f64::from(k), [3.0 * f64::from(k), 0.0, 0.3 * wave(k)], 0.01 * f64::from(k) + 0.004 * wave(k))
    };
    let mut poses: Vec<TimedPose> = (0..200).map(pose).collect();
    poses[77] = at(poses[77].time, poses[77].pose.translation().to_array(), 0.77 + 2.0);
    let tolerance = MotionTolerance { place: Some(0.5.into()), angle: Some(0.006.into()) };
    for drop in [false, true] {
        let motion = DecoupledMotion::smoothed_with(&poses, None, tolerance, drop).unwrap();
        let mut warnings = motion.warnings();
        warnings.retain(|warning| warning.reason() == "outlier");
        let [Warning::PoseFit(PoseFitWarning::Outlier { pose: 77, turning: true, distance, dropped, count: 1, .. })] =
            warnings[..]
        else {
            panic!("{:?}", motion.warnings())
        };
        assert!((distance - 2.0).abs() < 0.1 && dropped == drop, "{distance}");
        let turn = motion.pose(poses[77].time).angle_to(poses[77].pose);
        assert!(if drop { (turn - 2.0).abs() < 0.1 } else { turn <= 0.006 }, "{turn}");
        assert_eq!(motion.pose_times().len(), if drop { 199 } else { 200 });
    }
}

/// A closed smoothed motion is C2 where it comes back, also round a whole turn, where quaternions change their sign, and is the same wherever
/// it begins, also under a tolerance so wide that it is smoothed over several rounds.
#[test]
fn closed_smoothing_is_smooth_where_it_comes_back() {
    let rough = |k: u32| 0.4 * (1.7 * f64::from(k) * f64::from(k)).sin();
    for (turns, wide) in [0.0, 1.0, 2.0].into_iter().flat_map(|turns| [(turns, 2.0), (turns, 25.0)]) {
        let pose = |k: u32| {
            let angle = std::f64::consts::TAU * f64::from(k) / 90.0;
            let place = [50.0 * angle.cos() + rough(k), 30.0 * angle.sin() - rough(k + 7), rough(k + 3)];
            at(f64::from(k) * 0.1 + 0.01 * rough(k), place, turns * angle + 0.01 * rough(k + 5))
        };
        let poses: Vec<TimedPose> = (0..90).map(pose).collect();
        let tolerance = MotionTolerance { place: Some(wide.into()), angle: Some(0.03.into()) };
        let motion = DecoupledMotion::smoothed_with(&poses, Some(9.0), tolerance, false).unwrap();
        let point = Point3::new(3.0, 1.0, 2.0);
        let [first, last] = [motion.jet(poses[0].time, point), motion.jet(9.0, point)];
        assert!(first.pose.angle_to(last.pose) < 1e-9 && first.point.point.distance(last.point.point) < 1e-9);
        assert!((first.point.d1 - last.point.d1).length() < 1e-8 && (first.point.d2 - last.point.d2).length() < 1e-6);
        let off = motion.deviation().unwrap();
        assert!(off.place <= wide && off.angle <= 0.03 && off.place > 0.2, "{off:?}");
        let mut other: Vec<TimedPose> = (30..90).map(|k| poses[k]).collect();
        other.extend((0..30).map(|k| TimedPose { time: poses[k].time + 9.0 - poses[0].time, ..poses[k] }));
        let closing = other[0].time + 9.0 - poses[0].time;
        let again = DecoupledMotion::smoothed_with(&other, Some(closing), tolerance, false).unwrap();
        for k in 0..60 {
            let time = 3.2 + 0.1 * f64::from(k) - 0.3;
            let time = time.max(other[0].time);
            let apart = (motion.pose(time.min(9.0)).translation() - again.pose(time.min(9.0)).translation()).length();
            // The strongest smoothing averages over some thousands of steps, and is cut off there.
            assert!(apart < 1e-4, "{turns}, {wide}: {apart}");
        }
    }
}
