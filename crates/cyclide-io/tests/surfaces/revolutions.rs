//! Surfaces and solids of revolution.

use super::{build, surface};

#[test]
fn revolutions_are_solids_where_the_profile_closes() {
    let profile =
        r#""p": {"type": "arc-spline", "points": [[0, 0, 0], [3, 0, 1], [2, 0, 4], [0, 0, 5]], "construction": true}"#;
    let with = |rest: &str| format!(r#"{profile}, "v": {{"type": "revolution", "of": "p"{rest}}}"#);
    let solid = surface(&build(&with("")).unwrap());
    assert!(solid.closed && solid.bodies == 1 && solid.free_edges == 0, "{solid:?}");
    assert!(solid.volume.unwrap() > 0.0 && solid.joints.gap < 1e-14);
    // A part of a turn has that part of the volume, between two flat ends; the turned part has that part of the area.
    let half = surface(&build(&with(r#", "angle": {"degrees": 180}"#)).unwrap());
    assert!(half.closed && half.parts.len() == 2 && half.bodies == 1, "the ends lie in one plane: {half:?}");
    assert!((half.volume.unwrap() / solid.volume.unwrap() - 0.5).abs() < 1e-11);
    assert!((half.parts[0].area / solid.area.unwrap() - 0.5).abs() < 1e-12);
    let third = surface(&build(&with(r#", "angle": {"degrees": -120}"#)).unwrap());
    assert!((third.volume.unwrap() / solid.volume.unwrap() - 1.0 / 3.0).abs() < 1e-11);
    let [_, one, other] = &third.parts[..] else { panic!("two ends: {third:?}") };
    for end in [one.area, other.area] {
        assert!((end / (0.5 * half.parts[1].area) - 1.0).abs() < 1e-12);
    }
    // About another axis, moved along with it.
    let turned = r#""m": {"type": "transform", "of": "p", "construction": true,
        "steps": [{"rotation": {"angle": {"degrees": -90}, "axis": [0, 1, 0]}}, {"translation": [5, 6, 7]}]}"#;
    let other = format!(
        r#"{profile}, {turned}, "v": {{"type": "revolution", "of": "m", "axis": [-2, 0, 0], "center": [1, 6, 7]}}"#
    );
    let other = surface(&build(&other).unwrap());
    assert!((other.volume.unwrap() / solid.volume.unwrap() - 1.0).abs() < 1e-12);
}

#[test]
fn revolutions_that_are_none_are_refused_in_their_place() {
    let curve =
        |points: &str, kind: &str| format!(r#""p": {{"type": {kind}, "points": {points}, "construction": true}}"#);
    let of = |curve: &str, rest: &str| format!(r#"{curve}, "v": {{"type": "revolution", "of": "p"{rest}}}"#);
    let straight = curve("[[1, 0, 0], [2, 0, 1], [1, 0, 3]]", r#""arc-spline""#);
    for (objects, place, reason) in [
        (of(&curve("[[-1, 0, 0], [2, 0, 1], [1, 0, 3]]", r#""arc-spline""#), ""), "objects.v.of", "[crosses-axis]"),
        (of(&straight, r#", "axis": [0, 0, 0]"#), "objects.v.axis", "[zero-axis]"),
        (of(&straight, r#", "angle": 7"#), "objects.v.angle", "[angle-out-of-range]"),
        (of(&straight, r#", "angle": 0"#), "objects.v.angle", "[angle-out-of-range]"),
        (
            of(
                &curve(
                    "[[1, 0, 0], [2, 0, 1], [1, 0, 3], [2, 1, 4]]",
                    r#""circle-spline", "variant": "trigonometric""#,
                ),
                "",
            ),
            "objects.v.of",
            "[not-a-spline]",
        ),
    ] {
        let error = build(&objects).unwrap_err().to_string();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
    let error =
        build(r#""t": {"type": "cyclide", "a": 3, "mu": 1}, "v": {"type": "revolution", "of": "t"}"#).unwrap_err();
    assert!(error.to_string().contains("a revolution requires a curve"), "{error}");
}

/// A whole turn typed in radians leaves a slit, which is asked about with its width; degrees, parts of a turn and the turn itself are meant.
#[test]
fn turns_that_are_nearly_whole_are_asked_about() {
    let remarks = |angle: &str| {
        let profile = r#""p": {"type": "polyline", "points": [[3, 0, 0], [5, 0, 1], [4, 0, 2]], "construction": true}"#;
        let built =
            build(&format!(r#"{profile}, "v": {{"type": "revolution", "of": "p", "angle": {angle}}}"#)).unwrap();
        let slit = built.remarks.into_iter().find(|remark| remark.reason == "nearly-full-turn");
        slit.map(|remark| (remark.message, remark.place.unwrap_or_default()))
    };
    // At the radius 5 of the profile's farthest corner.
    for (angle, open, wide) in
        [("6.2831853", "7.18e-9", "3.59e-8"), ("-6.2831853", "7.18e-9", "3.59e-8"), ("6.28", "0.0031853", "0.015927")]
    {
        let (message, place) = remarks(angle).unwrap();
        assert!(message.contains(open) && message.contains(wide) && message.contains("remove `angle`"), "{message}");
        assert_eq!(place, "objects.v.angle");
    }
    for angle in ["6.283185307179586", "6.27", "3", r#"{"degrees": 359.9}"#, r#"{"degrees": 360}"#] {
        assert_eq!(remarks(angle), None, "{angle}");
    }
}
