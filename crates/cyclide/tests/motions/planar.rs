//! Motions of planar poses: any factors put them on the quadric, so the rule decides, and not the list, the place or rounding.

use crate::data::apart;
use cyclide::{
    Quat, Vec3,
    motion::{CubicMotions, Pose, RationalMotion, TimedPose},
};

/// Poses in a plane, at times 0, 1, 2, ..., that turn by up to 100 degrees from one to the next.
fn planar() -> Vec<TimedPose> {
    let rows = [[0.0, 0.0, 0.0], [100.0, 10.0, 3.0], [200.0, 20.0, 0.0], [260.0, 26.0, -4.0], [330.0, 30.0, 1.0]];
    rows.into_iter()
        .enumerate()
        .map(|(k, [yaw, x, y]): (usize, [f64; 3])| {
            let turn = Quat::from_axis_angle(Vec3::Z, yaw.to_radians());
            TimedPose { time: k as f64, pose: Pose::new(turn, Vec3::new(x, y, 0.0)).unwrap() }
        })
        .collect()
}

/// The poses with their plane tilted and put at a place.
fn placed(poses: &[TimedPose], place: Vec3) -> Vec<TimedPose> {
    let frame = Pose::new(Quat::new(0.8, 0.1, 0.3, 0.5), place).unwrap();
    poses.iter().map(|p| TimedPose { pose: frame.after(p.pose), ..*p }).collect()
}

/// The largest distance between two motions over the same times.
fn between(a: &RationalMotion, b: &RationalMotion, shift: Vec3) -> f64 {
    let (first, last) = (a.times()[0], a.times()[a.times().len() - 1]);
    (0..=40)
        .map(|k| {
            let time = first + (last - first) * f64::from(k) / 40.0;
            let back = Pose::new(b.pose(time).rotation(), b.pose(time).translation() - shift).unwrap();
            apart(a.pose(time), back)
        })
        .fold(0.0, f64::max)
}

#[test]
fn the_order_of_the_list_does_not_matter() {
    let poses = planar();
    let taken = |order: &[usize]| order.iter().map(|i| poses[*i]).collect::<Vec<_>>();
    let conic = RationalMotion::conic(&poses[..3]).unwrap();
    for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let other = RationalMotion::conic(&taken(&order)).unwrap();
        assert!(between(&conic, &other, Vec3::ZERO) < 1e-13 * 20.0, "{order:?}");
    }
    let quartic = RationalMotion::quartic(&poses).unwrap();
    for order in [[0, 2, 4, 1, 3], [4, 3, 2, 1, 0], [2, 0, 3, 1, 4]] {
        let other = RationalMotion::quartic(&taken(&order)).unwrap();
        assert!(between(&quartic, &other, Vec3::ZERO) < 1e-12 * 30.0, "{order:?}");
    }
    // It goes on the way of the shorter turns, 200 degrees in all.
    let steps = (0..100).map(|k| conic.pose(0.02 * f64::from(k)).angle_to(conic.pose(0.02 * f64::from(k + 1))));
    assert!((steps.sum::<f64>() - 200_f64.to_radians()).abs() < 1e-12);
}

#[test]
fn the_place_does_not_matter() {
    let place = Vec3::new(1.0e6, -0.7e6, 0.3e6);
    let [near, far] = [Vec3::ZERO, place].map(|place| placed(&planar(), place));
    // Coordinates of a million are rounded to 1e-10.
    for (make, count) in [(RationalMotion::conic as fn(&[TimedPose]) -> _, 3), (RationalMotion::quartic, 5)] {
        let [a, b] = [&near, &far].map(|poses| make(&poses[..count]).unwrap());
        assert!(between(&a, &b, place) < 1e-8, "{count}: {}", between(&a, &b, place));
    }
    for poses in [near, far] {
        let poses: Vec<Pose> = poses[..4].iter().map(|p| p.pose).collect();
        assert_eq!(CubicMotions::new(&poses).unwrap_err().reason(), "study-form-vanishes");
    }
}
