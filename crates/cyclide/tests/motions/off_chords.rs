//! How far motions of lowest degree leave the straight lines between their poses: their peaks may be narrow.

use cyclide::{
    Quat, Vec3,
    motion::{DecoupledMotion, Motion, Pose, RationalMotion, TimedPose},
};

/// Numbers from -1 to 1, always the same.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn poses(&mut self, count: u32) -> Vec<TimedPose> {
        let mut pose = |k: u32| {
            let rotation = Quat::new(self.next(), self.next(), self.next(), self.next());
            let place = Vec3::new(self.next(), self.next(), self.next()) * 300.0;
            TimedPose { time: f64::from(k), pose: Pose::new(rotation, place).unwrap() }
        };
        (0..count).map(&mut pose).collect()
    }
}

/// The distance at a time from the nearest line: of the span between poses, or beside it.
fn distance(motion: &Motion, poses: &[TimedPose], time: f64) -> f64 {
    let at = motion.pose(time).translation();
    let span = (time.floor() as usize).min(poses.len() - 2);
    let lines = span.saturating_sub(1)..(span + 2).min(poses.len() - 1);
    let from = |k: usize| {
        let [a, b] = [poses[k], poses[k + 1]].map(|timed| timed.pose.translation());
        let part = ((at - a).dot(b - a) / (b - a).dot(b - a)).clamp(0.0, 1.0);
        (at - a - (b - a) * part).length()
    };
    lines.map(from).fold(f64::INFINITY, f64::min)
}

/// The farthest place is as far as it is said to be, and no sample is farther.
fn is_farthest(motion: &Motion, poses: &[TimedPose], samples: u32) {
    let found = motion.off_chords().unwrap();
    let there = distance(motion, poses, found.time);
    assert!((there - found.distance).abs() <= 1e-9 * there, "{found:?} {there}");
    let last = (poses.len() - 1) as f64;
    for k in 0..=samples {
        let time = last * f64::from(k) / f64::from(samples);
        let off = distance(motion, poses, time);
        assert!(off <= found.distance * (1.0 + 1e-7), "{found:?}: {off} at {time}");
    }
}

#[test]
fn narrow_peaks_of_conics_and_quartics_are_found() {
    let mut random = Random(7);
    let mut made = [0; 2];
    while made.iter().min() < Some(&12) {
        for (kind, count) in [(0, 3), (1, 5)] {
            let poses = random.poses(count);
            let motion = if kind == 0 { RationalMotion::conic(&poses) } else { RationalMotion::quartic(&poses) };
            if let Ok(motion) = motion {
                is_farthest(&motion.into(), &poses, 4000);
                made[kind] += 1;
            }
        }
    }
}

/// The peak is about a thousandth of a span wide, and twice as high as what lies beside it.
#[test]
fn a_peak_between_even_places_is_found() {
    let at = |time: f64, place: [f64; 3], [w, x, y, z]: [f64; 4]| TimedPose {
        time,
        pose: Pose::new(Quat::new(w, x, y, z), Vec3::from(place)).unwrap(),
    };
    let poses = [
        at(0.0, [-143.0, -120.9, 188.5], [-2.441, 1.8, 1.144, -0.325]),
        at(1.0, [-266.9, -135.0, 94.5], [0.978, -0.311, -0.329, -0.792]),
        at(2.0, [-46.3, 79.9, 280.5], [-0.607, 0.127, -0.892, 0.841]),
    ];
    let motion = Motion::from(RationalMotion::conic(&poses).unwrap());
    is_farthest(&motion, &poses, 20_000);
    assert!((motion.off_chords().unwrap().distance - 151.0).abs() < 1.0, "{:?}", motion.off_chords());
}

/// Short blends between a fast span and a slow one are farthest beside the pose.
#[test]
fn short_blends_between_unequal_speeds_are_searched() {
    let at = |time: f64, x: f64, y: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::new(x, y, 0.0)).unwrap() };
    for (slow, blend) in [(5.0, 2.0), (1.0, 2.0), (20.0, 0.1), (3.0, 300.0)] {
        let poses = [at(0.0, 0.0, 0.0), at(1.0, 1000.0, 0.0), at(1.0 + slow, 1000.0, 1000.0)];
        let motion = Motion::from(DecoupledMotion::linear(&poses, None, blend).unwrap());
        let found = motion.off_chords().unwrap();
        let off = |time: f64| {
            let place = motion.pose(time).translation();
            // From the line along x, and from the one along y.
            place.y.abs().min((place.x - 1000.0).abs())
        };
        let window = 2.0 * blend / 1000.0;
        let most = (0..=200_000).map(|k| off(1.0 - window + window * f64::from(k) / 1e5)).fold(0.0, f64::max);
        // It is where both lines are as far: a sample may be half a step beside that.
        let beside = found.distance - most;
        assert!(beside > -1e-9 * most && beside < 1e-4 * most, "{slow} {blend}: {found:?}, {most}");
    }
}
