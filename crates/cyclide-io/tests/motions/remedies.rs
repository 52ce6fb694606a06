//! What refusals and warnings of motions advise works when it is written.

use super::{build, motion};

fn poses(places: &[[f64; 3]]) -> String {
    let list: Vec<String> = places.iter().map(|place| format!("{{\"position\": {place:?}}}")).collect();
    format!("\"poses\": [{}]", list.join(", "))
}

/// The reasons and sentences of the warnings of a motion.
fn said(fields: &str) -> Vec<(&'static str, String)> {
    let built = build(&motion(fields)).unwrap();
    built.remarks.into_iter().map(|remark| (remark.reason, remark.message)).collect()
}

/// Of four poses without a motion of degree 3 no cross-ratio helps, which a document does not choose anyway; a spline takes them.
#[test]
fn poses_without_a_cubic_are_those_of_a_spline() {
    let poses = r#""poses": [{"position": [10, 0, 3]}, {"position": [50, 20, 0], "quaternion": [1, 0.3, 0.5, -0.2]},
        {"position": [70, -30, 40], "quaternion": [0.4, -0.8, 0.3, 0.5]}, {"position": [0, 60, 90], "quaternion": [0.2, 0.9, -0.7, 0.1]}]"#;
    let error = build(&motion(&format!(r#""kind": "cubic", {poses}"#))).unwrap_err();
    assert!(error.contains("use a spline [no-cubic-motion]") && !error.contains("use one between"), "{error}");
    assert!(build(&motion(&format!(r#""kind": "spline", {poses}"#))).is_ok());
}

/// Equal poses have no path for a law, and no point or arm gives them one.
#[test]
fn equal_poses_rest_as_given() {
    let equal = poses(&[[1.0, 2.0, 3.0], [1.0, 2.0, 3.0]]);
    for law in ["constant-speed", "eased"] {
        let error = build(&motion(&format!(r#""law": "{law}", {equal}"#))).unwrap_err();
        assert!(error.contains("`as-given`") && !error.contains("`arm`"), "{error}");
    }
    assert!(build(&motion(&format!(r#""law": "as-given", {equal}"#))).is_ok());
    let apart = poses(&[[1.0, 2.0, 3.0], [1.0, 2.0, 4.0]]);
    assert!(build(&motion(&format!(r#""law": "eased", {apart}"#))).is_ok());
    // One that turns in place has an arm.
    let turning = r#""law": "eased", "poses": [{"position": [0, 0]}, {"position": [0, 0], "rpy": [0, 0, 1]}]"#;
    let error = build(&motion(turning)).unwrap_err();
    assert!(error.contains("`arm`"), "{error}");
    assert!(build(&motion(&format!(r#""arm": 10, {turning}"#))).is_ok());
}

/// Times by the path have none for a rest: the poses have times, or there is one of them.
#[test]
fn a_rest_has_times_of_its_own() {
    let places = [[0.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.0, 0.0, 0.0], [9.0, 3.0, 0.0]];
    let error = build(&motion(&format!(r#""times": "chord", {}"#, poses(&places)))).unwrap_err();
    assert!(error.contains("give each pose a time instead, or leave one of the two out"), "{error}");
    let timed: Vec<String> =
        places.iter().enumerate().map(|(k, place)| format!("{{\"time\": {k}, \"position\": {place:?}}}")).collect();
    assert!(build(&motion(&format!(r#""poses": [{}]"#, timed.join(", ")))).is_ok());
    let fewer = [places[0], places[1], places[3]];
    assert!(build(&motion(&format!(r#""times": "chord", {}"#, poses(&fewer)))).is_ok());
}

/// Two poses of a smoothed motion a thousandth of a second apart and 30 mm from each other throw it far out, which is said with what helps.
#[test]
fn smoothed_motions_that_overshoot_say_so() {
    let places: Vec<[f64; 3]> = (0..6).map(|k| [30.0 * f64::from(k), 20.0 * f64::from(k).sin(), 0.0]).collect();
    let with_times = |times: &[f64], place: f64| {
        let list: Vec<String> = places
            .iter()
            .zip(times)
            .map(|(place, time)| format!("{{\"time\": {time}, \"position\": {place:?}}}"))
            .collect();
        format!(r#""tolerance": {{"place": {place}}}, "poses": [{}]"#, list.join(", "))
    };
    let swings = |fields: &str| said(fields).into_iter().find(|(reason, _)| *reason == "motion-swings");
    let near = [0.0, 1.0, 1.001, 2.0, 3.0, 4.0];
    let (_, message) = swings(&with_times(&near, 1.0)).unwrap();
    assert!(message.contains("after pose") && message.contains(r#""times": "chord""#), "{message}");
    assert!(swings(&with_times(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], 1.0)).is_none());
    assert!(swings(&with_times(&near, 20.0)).is_none());
    let chord = format!(r#""tolerance": {{"place": 1}}, "times": "chord", {}"#, poses(&places));
    assert!(swings(&chord).is_none());
    let mut fewer = places.clone();
    fewer.remove(2);
    let list: Vec<String> = fewer
        .iter()
        .zip([0.0, 1.0, 2.0, 3.0, 4.0])
        .map(|(place, time)| format!("{{\"time\": {time}, \"position\": {place:?}}}"))
        .collect();
    assert!(swings(&format!(r#""tolerance": {{"place": 1}}, "poses": [{}]"#, list.join(", "))).is_none());
    // The same of a turn.
    let turned: Vec<String> = near
        .iter()
        .enumerate()
        .map(|(k, time)| format!("{{\"time\": {time}, \"position\": [0, 0], \"rpy\": [0, 0, {}]}}", 0.3 * k as f64))
        .collect();
    let turned = format!(r#""tolerance": {{"angle": 0.01}}, "poses": [{}]"#, turned.join(", "));
    assert!(swings(&turned).is_some_and(|(_, message)| message.contains("in angle")));
}

/// The curve through the positions has no corners to be marked: a polyline has them.
#[test]
fn sharp_turns_of_positions_are_for_a_polyline() {
    let sharp = poses(&[[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [1.0, 1.0, 0.0], [100.0, 3.0, 0.0], [50.0, 50.0, 0.0]]);
    let found = said(&format!(r#""positions": "circle-spline", {sharp}"#));
    let (_, message) = found.iter().find(|(reason, _)| *reason == "sharp-turn").unwrap();
    assert!(message.contains(r#"`"positions": "polyline"`"#) && !message.contains("mark"), "{message}");
    assert!(said(&format!(r#""positions": "polyline", {sharp}"#)).is_empty());
    let folded = poses(&[
        [5.3, 53.3, 0.0],
        [29.5, -75.1, 0.0],
        [-93.0, -25.7, 0.0],
        [-30.6, 39.8, 0.0],
        [-71.4, 37.7, 0.0],
        [-63.1, 16.0, 0.0],
        [92.9, -14.9, 0.0],
        [93.0, -78.4, 0.0],
        [-92.1, 20.2, 0.0],
        [97.2, -28.4, 0.0],
        [30.0, -4.7, 0.0],
        [-52.8, -27.0, 0.0],
    ]);
    let found = said(&format!(r#""positions": "fair", {folded}"#));
    let (_, message) = found.iter().find(|(reason, _)| *reason == "relaxed").unwrap();
    assert!(message.contains(r#"`"positions": "polyline"`"#) && !message.contains("mark"), "{message}");
    assert!(said(&format!(r#""positions": "polyline", {folded}"#)).is_empty());
}
