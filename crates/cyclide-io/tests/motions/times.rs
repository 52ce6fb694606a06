//! When bodies are sampled, how fast they are then, and times that follow from the poses.

use crate::{build, build_all, motion, reported};
use cyclide_io::report::{MotionSamples, SamplePlaces};

/// Every so many seconds and at the end, with speeds that are those of the poses; what was sampled is a table of poses.
#[test]
fn motions_are_sampled_by_seconds() {
    let fields = r#""tool": [1, 2, 0], "poses": [{"position": [0, 0]}, {"position": [30, 0, 10], "rpy": [0, 0, 1]}, {"position": [40, 20, 0], "rpy": [1, 0, 1]}]"#;
    for law in [
        r#""law": "as-given""#,
        r#""law": "eased", "duration": 2"#,
        r#""law": "constant-speed", "duration": 2, "arm": 3"#,
    ] {
        let built = build(&motion(&format!("{fields}, {law}"))).unwrap();
        let samples = MotionSamples::new(&built, SamplePlaces::Step(0.3)).unwrap();
        let times: Vec<f64> = samples.samples.iter().map(|sample| sample.time).collect();
        assert_eq!(times, [0.0, 0.3, 0.6, 0.3 * 3.0, 1.2, 1.5, 0.3 * 6.0, 2.0]);
        // A multiple has no rest of its own.
        assert_eq!(MotionSamples::new(&built, SamplePlaces::Step(0.1)).unwrap().samples.len(), 21);
        assert_eq!(MotionSamples::new(&built, SamplePlaces::Step(9.0)).unwrap().samples.len(), 2);
        let fine = MotionSamples::new(&built, SamplePlaces::Step(1e-4)).unwrap().samples;
        let tool = built.item.motion().unwrap().tool();
        for k in [2_000, 7_000, 13_000] {
            let [before, at, after] = [k - 1, k, k + 1].map(|k| fine[k].pose);
            let place = |pose: cyclide::motion::Pose| pose.apply(tool).to_vec();
            // Differences of second order.
            let speed = (place(after) - place(before)).length() / 2e-4;
            let acceleration = ((place(after) - place(at)) - (place(at) - place(before))).length() / 1e-8;
            let turning = before.angle_to(after) / 2e-4;
            let found = fine[k];
            assert!((found.speed.unwrap() / speed - 1.0).abs() < 1e-6, "{law}");
            assert!((found.angular_speed.unwrap() / turning - 1.0).abs() < 1e-6, "{law}");
            assert!((found.acceleration.unwrap() - acceleration).abs() < 1e-4 * (1.0 + acceleration), "{law}");
        }
        let text = samples.csv();
        assert!(text.lines().all(|line| line.split(',').count() == 23), "{text}");
        let again = build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), &text).unwrap().pop().unwrap();
        assert!((again.item.motion().unwrap().duration() - 2.0).abs() < 1e-15);
        let json: serde_json::Value = serde_json::from_str(&samples.json()).unwrap();
        assert!((json["speeds"][2].as_f64().unwrap() - samples.samples[2].speed.unwrap()).abs() < 1e-12);
        assert!(build(&motion(&format!(r#""poses": {}"#, json["poses"]))).is_ok());
    }
}

/// Uneven poses with times by the chords are passed at an even speed, with turns counted by the arm.
#[test]
fn times_follow_from_chords() {
    let poses =
        r#""poses": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [10, 0]}, {"position": [11, 0]}]"#;
    let (found, text) = reported(&format!(r#""times": "chord", {poses}"#));
    assert!((found.speed.max - 11.0 / 3.0).abs() < 1e-9 && (found.speed.min - 11.0 / 3.0).abs() < 1e-9, "{text}");
    assert!(reported(poses).0.speed.max > 10.0);
    // A right angle at an arm of 4 is 2π of a way of 3 and itself; by the roots it takes less.
    let turn = r#""poses": [{"position": [0, 0]}, {"position": [3, 0]}, {"position": [3, 0], "rpy": {"degrees": [0, 0, 90]}}], "kind": "sclerp", "arm": 4"#;
    let tau = std::f64::consts::TAU;
    for (times, expected) in
        [("chord", 3.0 / (3.0 + tau)), ("centripetal", 3.0_f64.sqrt() / (3.0_f64.sqrt() + tau.sqrt()))]
    {
        let built = build(&motion(&format!(r#"{turn}, "times": "{times}""#))).unwrap();
        assert!((built.item.motion().unwrap().motion().times()[1] - 2.0 * expected).abs() < 1e-12);
        assert!(built.remarks.is_empty(), "{:?}", built.remarks);
    }
    for (fields, says) in [
        (format!(r#""times": "chord", {}"#, turn.replace(r#""arm": 4"#, r#""arm": 0"#)), "objects.m.poses[1]: span 1"),
        (
            r#""times": "chord", "poses": [{"position": [0, 0]}, {"position": [0, 0]}, {"position": [1, 0]}]"#
                .to_owned(),
            "is at rest",
        ),
        (
            r#""times": "chord", "poses": [{"position": [0, 0], "time": 0}, {"position": [1, 0], "time": 1}]"#
                .to_owned(),
            "remove one of the two",
        ),
        (r#""times": "chord", "kind": "cubic", "poses": []"#.to_owned(), "remove `times`"),
    ] {
        let error = build(&motion(&fields)).unwrap_err();
        assert!(error.contains(says), "{error}");
    }
}

/// When poses are passed is said wherever their times were not given: by chords, not of uniform steps.
#[test]
fn times_that_follow_are_reported() {
    let poses =
        r#""poses": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [10, 0]}, {"position": [11, 0]}]"#;
    let (found, text) = reported(&format!(r#""times": "chord", {poses}"#));
    let times = found.pose_times.unwrap();
    for (time, way) in times.iter().zip([0.0, 1.0, 10.0, 11.0]) {
        assert!((time - way * 3.0 / 11.0).abs() < 1e-12, "{times:?}");
    }
    assert!(text.contains("passed at 0, 0.27273, 2.7273, 3 s"), "{text}");
    let roots = reported(&format!(r#""times": "centripetal", {poses}"#)).0.pose_times.unwrap();
    assert!((roots[1] - 3.0 / 5.0).abs() < 1e-12, "{roots:?}");
    assert_eq!(reported(poses).0.pose_times, None);
}

/// Places that are too fast are parts of the time, over joints and round peaks, told in the report.
#[test]
fn places_faster_than_limits_are_named() {
    // A thousand places a second are on the right side of the limit.
    let fields = r#""tool": [0, 7, 3], "poses": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [4, 0], "rpy": [0, 0, 1]}, {"position": [9, 0], "rpy": [0, 1, 1]}, {"position": [9, 4]}]"#;
    for law in ["as-given", "eased"] {
        let built = build(&motion(&format!(r#"{fields}, "law": "{law}", "arm": 5, "duration": 4"#))).unwrap();
        let schedule = built.item.motion().unwrap().schedule().unwrap();
        for (kind, limit) in [(cyclide::motion::SpeedKind::Tool, 5.0), (cyclide::motion::SpeedKind::Turn, 0.8)] {
            let found = schedule.faster_than(kind, limit);
            assert!(!found.is_empty(), "{law} {kind:?}");
            let inside =
                |time: f64, slack: f64| found.iter().any(|part| time > part.from - slack && time < part.to + slack);
            for k in 0..4000 {
                let time = (f64::from(k) + 0.5) * 1e-3;
                let jet = schedule.jet(time / 4.0);
                let speed = if kind == cyclide::motion::SpeedKind::Tool {
                    jet.point.speed()
                } else {
                    jet.angular_velocity.length()
                };
                assert!(
                    if speed > limit { inside(time, 1e-9) } else { !inside(time, -1e-9) },
                    "{law} {kind:?} {time}: {speed} {found:?}"
                );
            }
            assert!(found.iter().all(|part| part.value > limit && part.time >= part.from && part.time <= part.to));
            assert!(found.windows(2).all(|parts| parts[0].to < parts[1].from), "{found:?}");
        }
    }
    let limits = cyclide_io::report::SpeedLimits { speed: Some(5.0), angular_speed: Some(100.0) };
    let built = [build(&motion(fields)).unwrap()];
    let report =
        cyclide_io::Report::new(cyclide::model::Units::Millimetre, &built, None).with_speed_limits(&built, limits);
    let text = report.to_string();
    assert!(
        text.contains("2 intervals faster than 5 mm/s or 100 rad/s")
            && report.objects["m"].warnings.iter().filter(|w| w.reason == "faster-than-limit").count() == 2,
        "{text}"
    );
}
