//! Blended tees: closed, exact, tangent to both partners, the blend the envelope of its balls.

use cyclide::{Branch, Error, PipeManifold, PipeTee, PipeTeeBody, Shell, surface_joints};
use std::f64::consts::PI;

const MADE: PipeTeeBody = PipeTeeBody { reach: [5.0, 6.0], height: 5.0, wall: None };

/// Radii, offset, stations of tees that differ: meeting and skew axes, a thin and a wide branch, constant and variable radius.
fn tees() -> Vec<(PipeTee, [f64; 2], f64)> {
    let constant = |radii, offset, radius| (radii, offset, vec![[0.0, radius]]);
    [
        constant([2.0, 1.0], 0.0, 0.4),
        constant([2.0, 1.1], 0.3, 0.4),
        constant([2.0, 0.05], 0.0, 0.01),
        constant([1.0, 0.9], 0.0, 0.3),
        ([2.0, 0.5], -1.2, vec![[0.0, 0.2], [2.0, 0.4], [4.0, 0.3]]),
        ([2.0, 1.4], 0.1, vec![[0.0, 0.2], [PI, 0.5]]),
    ]
    .into_iter()
    .map(|(radii, offset, stations)| (PipeTee::new(radii, offset, &stations, 2e-3).unwrap(), radii, offset))
    .collect()
}

/// Largest gap of neighbouring faces, and largest angle of their normals but for the edges of the ends.
fn joints(shell: &Shell) -> (f64, f64) {
    let all = surface_joints(shell);
    let gap = all.iter().map(|joint| joint.gap).fold(0.0, f64::max);
    // The ends meet the pipes at right angles.
    let smooth = all.iter().filter(|joint| (joint.angle - 0.5 * PI).abs() > 1e-6);
    (gap, smooth.map(|joint| joint.angle).fold(0.0, f64::max))
}

#[test]
fn solid_tees_are_closed_and_smooth() {
    for (tee, [r1, r2], offset) in tees() {
        let body = tee.body(&MADE).unwrap();
        assert!(body.is_solid());
        let (gap, angle) = joints(&body.outer);
        // Roundings of coordinates of some units; normals of patches of degree 18 magnify them.
        assert!(gap < 1e-13 && angle < 1e-11, "{r1} {r2} {offset}: {gap:e} {angle:e}");
        // More than both cylinders, less than with a box about the blend.
        let least = 11.0 * PI * r1 * r1 + PI * r2 * r2 * (5.0 - r1);
        let wide = r2 + tee.radius_range()[1];
        let volume = body.outer.volume();
        assert!(
            volume > least && volume < least + 4.0 * wide * wide * (r1 + tee.radius_range()[1]),
            "{volume} {least}"
        );
    }
}

#[test]
fn blends_touch_both_cylinders_and_are_envelopes() {
    for (tee, [r1, r2], offset) in tees() {
        let h = -0.5 * offset;
        let [low, high] = tee.radius_range();
        for patch in tee.patches() {
            for k in 0..=6 {
                let s = f64::from(k) / 6.0;
                let ((m, r), circle) = (patch.ball(s), patch.characteristic_circle(s));
                assert!(low <= r && r <= high);
                assert!((m.y.hypot(m.z + h) - (r1 + r)).abs() < 1e-14 * (r1 + r) * 10.0);
                assert!((m.x.hypot(m.z - h) - (r2 + r)).abs() < 1e-14 * (r1 + r) * 10.0);
                for t in [0.0, 0.2, 0.5, 1.0] {
                    let p = patch.point(s, t);
                    let off = (p.distance(circle.center) - circle.radius)
                        .abs()
                        .max((p - circle.center).dot(circle.axis).abs());
                    assert!(off < 1e-13 * (1.0 + r1), "{off:e}");
                }
                let [a, b] = [0.0, 1.0].map(|t| patch.point(s, t));
                assert!((a.y.hypot(a.z + h) - r1).abs().max((b.x.hypot(b.z - h) - r2).abs()) < 1e-13 * r1);
            }
        }
    }
}

#[test]
fn radii_keep_to_their_law() {
    let stations = [[0.3, 0.2], [1.5, 0.45], [3.0, 0.3], [5.0, 0.35]];
    for tolerance in [1e-2, 1e-3, 1e-4] {
        let tee = PipeTee::new([2.0, 1.0], 0.2, &stations, tolerance).unwrap();
        assert!(tee.deviation() <= tolerance);
        let [low, high] = tee.radius_range();
        assert!(low > 0.2 - 2.0 * tolerance && high < 0.45 + 2.0 * tolerance);
        // Each station is a knot: the ball there has its radius.
        for [angle, radius] in stations {
            let near = tee.patches().any(|patch| {
                let (m, r) = patch.ball(0.0);
                // The axis of the branch is at z = -0.1 there, and y of the tee is -z.
                let at = (-0.1 - m.z).atan2(m.x).rem_euclid(2.0 * PI);
                (at - angle).abs() < 1e-9 && (r - radius).abs() < 1e-12
            });
            assert!(near, "{angle}");
        }
    }
}

#[test]
fn a_hollow_tee_is_the_outer_one_less_the_inner_one() {
    let made = PipeTeeBody { wall: Some(0.2), ..MADE };
    for offset in [0.0, 0.4] {
        let tee = PipeTee::new([2.0, 1.1], offset, &[[0.0, 0.4]], 1e-3).unwrap();
        let inner = PipeTee::new([1.8, 0.9], offset, &[[0.0, 0.6]], 1e-3).unwrap();
        let hollow = tee.body(&made).unwrap();
        assert!(hollow.is_solid());
        let (gap, angle) = joints(&hollow.outer);
        assert!(gap < 1e-13 && angle < 1e-11, "{gap:e} {angle:e}");
        let [whole, outer, bore] =
            [&hollow, &tee.body(&MADE).unwrap(), &inner.body(&MADE).unwrap()].map(|body| body.outer.volume());
        assert!((whole - (outer - bore)).abs() < 1e-9 * outer, "{whole} {outer} {bore}");
    }
}

#[test]
fn a_tee_scales_with_its_measures() {
    let volume = |k: f64| {
        let tee = PipeTee::new([2.0 * k, 1.0 * k], 0.3 * k, &[[0.0, 0.4 * k]], 2e-3 * k).unwrap();
        let made = PipeTeeBody { reach: MADE.reach.map(|x| x * k), height: MADE.height * k, wall: None };
        tee.body(&made).unwrap().outer.volume() / k.powi(3)
    };
    let one = volume(1.0);
    for k in [1e-9, 1e-3, 1e6] {
        assert!((volume(k) / one - 1.0).abs() < 1e-11, "{k}");
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    let reason = |made: Result<PipeTee, Error>| made.unwrap_err().reason();
    let new = |radii, offset, radius, tolerance| PipeTee::new(radii, offset, &[[0.0, radius]], tolerance);
    assert_eq!(reason(new([1.0, 1.0], 0.0, 0.2, 1e-3)), "branch-too-wide");
    assert_eq!(reason(new([1.0, 0.5], 0.5, 0.2, 1e-3)), "branch-too-wide");
    assert_eq!(reason(new([1.0, 0.5], 0.0, 0.0, 1e-3)), "no-positive-radius");
    assert_eq!(reason(new([1.0, 0.5], 0.0, 0.2, 0.0)), "tolerance-not-positive");
    assert_eq!(reason(new([1.0, f64::NAN], 0.0, 0.2, 1e-3)), "not-finite");
    assert_eq!(reason(new([1.0, 0.5], 0.0, 0.2, 1e-12)), "too-many-pieces");
    assert_eq!(reason(PipeTee::new([1.0, 0.5], 0.0, &[], 1e-3)), "too-few-points");
    let tee = new([2.0, 1.0], 0.0, 0.4, 1e-3).unwrap();
    let refused = |made: PipeTeeBody| tee.body(&made).unwrap_err().reason();
    assert_eq!(refused(PipeTeeBody { reach: [1.3, 5.0], ..MADE }), "parameter-out-of-range");
    assert_eq!(refused(PipeTeeBody { height: 2.0, ..MADE }), "parameter-out-of-range");
    assert_eq!(refused(PipeTeeBody { wall: Some(1.0), ..MADE }), "parameter-out-of-range");
    assert_eq!(refused(PipeTeeBody { wall: Some(f64::NAN), ..MADE }), "not-finite");
}

#[test]
fn a_manifold_of_three_pipes_is_one_solid() {
    let branch = |position, radius, offset| Branch { position, radius, offset, ball_radius: 0.3, height: 5.0 };
    let manifold = PipeManifold::new(2.0, &[branch(6.0, 1.2, 0.0), branch(0.0, 0.8, 0.3)], 1e-3).unwrap();
    for wall in [None, Some(0.1)] {
        let body = manifold.body([-4.0, 11.0], wall).unwrap();
        assert!(body.is_solid());
        let (gap, angle) = joints(&body.outer);
        assert!(gap < 1e-13 && angle < 1e-11, "{gap:e} {angle:e}");
    }
    // Each branch adds what it adds alone: to the pipe alone.
    let volume = |manifold: &PipeManifold, ends| manifold.body(ends, None).unwrap().outer.volume();
    let alone = |branch| PipeManifold::new(2.0, &[branch], 1e-3).unwrap();
    let pipe = 15.0 * 4.0 * PI;
    let ends = [-4.0, 11.0];
    let [one, other] = [branch(6.0, 1.2, 0.0), branch(0.0, 0.8, 0.3)].map(|b| volume(&alone(b), ends) - pipe);
    // Both alone may have another number of spans, and so another radius within the tolerance.
    assert!((volume(&manifold, ends) - pipe - one - other).abs() < 2e-2);
    let close = PipeManifold::new(2.0, &[branch(2.0, 1.2, 0.0), branch(0.0, 0.8, 0.0)], 1e-3).unwrap();
    assert_eq!(close.body(ends, None).unwrap_err().reason(), "parameter-out-of-range");
}
