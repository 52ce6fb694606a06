//! Extremes of moving bodies.

use crate::{build, motion, reported};

/// Extremes are those between the places, too: they were the largest of 129 samples of a span.
#[test]
fn extremes_are_refined() {
    // A quartic through five poses, which rushes through a needle: against the largest of a million places about it.
    let poses = r#""kind": "quartic", "poses": [{"position": [5.4, -3.2, 8.9], "quaternion": [0.46, -0.61, 0.55, 0.33]},
        {"position": [-8.3, 1.7, -2.6], "quaternion": [-0.72, 0.11, 0.39, -0.56]}, {"position": [3.9, 6.1, -7.4], "quaternion": [0.18, 0.83, -0.27, 0.45]},
        {"position": [-1.2, -9.5, 4.8], "quaternion": [0.64, -0.22, -0.71, 0.19]}, {"position": [7.7, 2.3, 0.4], "quaternion": [-0.35, 0.58, 0.12, 0.72]}]"#;
    for law in ["as-given", "constant-speed", "eased"] {
        let fields = format!(r#"{poses}, "law": "{law}", "duration": 2"#);
        let (found, _) = reported(&fields);
        let built = build(&motion(&fields)).unwrap();
        let schedule = built.item.motion().unwrap().schedule().unwrap();
        let dense = |measure: &dyn Fn(&cyclide::motion::MotionJet) -> f64| {
            let breaks = schedule.breaks();
            let places =
                breaks.windows(2).flat_map(|w| (0..=2000).map(move |k| w[0] + (w[1] - w[0]) * f64::from(k) / 2000.0));
            places.map(|x| measure(&schedule.jet_in_span(0, x))).filter(|v| v.is_finite()).fold(0.0, f64::max)
        };
        for (name, found, most) in [
            ("speed", found.speed.max, dense(&|jet| jet.point.speed())),
            ("angular", found.angular_speed.max, dense(&|jet| jet.angular_velocity.length())),
            ("acceleration", found.acceleration, dense(&|jet| jet.point.d2.length())),
            ("jerk", found.jerk, dense(&|jet| jet.point.d3.length())),
        ] {
            // Of a peak as wide as a sixteenth of a cell, 2,000 places leave less than 1e-4.
            assert!(found >= most * (1.0 - 1e-9) && found <= most * (1.0 + 1e-4), "{law} {name}: {found} {most}");
        }
    }
    // Known in closed form: of the law x³(10 − 15x + 6x²) over 30 mm in 2 s the acceleration is 30/4 of 10/√3.
    let line = r#""law": "eased", "duration": 2, "poses": [{"position": [0, 0]}, {"position": [30, 0]}]"#;
    let (found, _) = reported(line);
    assert!((found.acceleration / (7.5 * 10.0 / 3.0_f64.sqrt()) - 1.0).abs() < 1e-9, "{found:?}");
    assert!((found.speed.max / (15.0 * 1.875) - 1.0).abs() < 1e-9);
}

/// At constant speed along a way that turns back the acceleration has no bound; the speed has one.
#[test]
fn what_grows_beyond_every_bound_is_said() {
    let cusp = r#""law": "constant-speed", "poses": [{"position": [0, 0]}, {"position": [30, 0]}, {"position": [0, 10]}, {"position": [30, 11]}]"#;
    let (found, text) = reported(cusp);
    assert!(found.speed.max.is_finite() && found.acceleration.is_finite(), "{found:?}");
    assert!(!text.contains("inf") && !text.contains("NaN"), "{text}");
    // There and back on a line at 30 mm/s: the velocity jumps by twice that, though the spline comes to a stand at the pose.
    let back =
        r#""law": "constant-speed", "poses": [{"position": [0, 0]}, {"position": [30, 0]}, {"position": [0, 0]}]"#;
    let (found, _) = reported(back);
    assert!((found.velocity_jump - 60.0).abs() < 1e-2, "{found:?}");
    assert!(found.acceleration < 1e-3, "{found:?}");
    // On (t², t³), from -2 to 2, at constant speed: the curvature of the cusp has no bound, and the acceleration has none.
    let pose = |t: f64| format!(r#"{{"time": {}, "position": [{}, {}]}}"#, t + 2.0, t * t, t * t * t);
    let poses = [-2.0, -1.0, 0.5, 1.0, 2.0].map(pose).join(", ");
    let (found, text) = reported(&format!(r#""kind": "quartic", "law": "constant-speed", "poses": [{poses}]"#));
    assert!(found.acceleration.is_infinite() && text.contains("acceleration without bound"), "{text}");
    assert!(found.speed.max.is_finite(), "{text}");
}
