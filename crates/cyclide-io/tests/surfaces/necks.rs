//! Necks of pipes on plates.

use super::{build, surface};

#[test]
fn necks_are_surfaces_or_solids() {
    let neck = |rest: &str| {
        build(&format!(
            r#""n": {{"type": "plate-with-neck", "pipe_radius": 10, "ball_radius": 4, "height": 40{rest}}}"#
        ))
    };
    let open = surface(&neck(r#", "plate": [60, 50]"#).unwrap());
    assert!(!open.closed && open.volume.is_none() && open.free_edges == 16, "{open:?}");
    let filled = surface(&neck(r#", "plate": [60, 50], "thickness": 2"#).unwrap());
    assert!(filled.closed && filled.bodies == 1);
    let bored = surface(&neck(r#", "plate": [60, 50], "thickness": 2, "wall": 3"#).unwrap());
    let bore = filled.volume.unwrap() - bored.volume.unwrap();
    assert!((bore / (std::f64::consts::PI * 49.0 * 42.0) - 1.0).abs() < 1e-10, "{bore}");
    // As many degrees as radians, and the same the other way round.
    let lean = |slope: &str| surface(&neck(&format!(r#", "plate": {{"radius": 40}}, "slope": {slope}"#)).unwrap());
    let (degrees, back) = (lean(r#"{"degrees": 30}"#), lean("-0.5235987755982988"));
    assert!((degrees.area.unwrap() / back.area.unwrap() - 1.0).abs() < 1e-10);
    assert!(surface(&neck(r#", "side": "inside", "thickness": 1.5"#).unwrap()).closed);
    // A large ball of a pipe that leans far.
    let folded = build(
        r#""n": {"type": "plate-with-neck", "pipe_radius": 5, "ball_radius": 9, "height": 70, "slope": {"degrees": 60}, "plate": [99, 150]}"#,
    );
    let folded = folded.unwrap();
    let [remark] = &folded.remarks[..] else { panic!("one remark: {:?}", folded.remarks) };
    assert_eq!((remark.reason, remark.place.as_deref()), ("neck-folds", Some("objects.n.ball_radius")));
    let solid = build(
        r#""n": {"type": "plate-with-neck", "pipe_radius": 5, "ball_radius": 9, "height": 70, "slope": {"degrees": 60}, "plate": [99, 150], "thickness": 3}"#,
    );
    let error = solid.unwrap_err();
    assert!(error.contains("objects.n.ball_radius") && error.contains("[neck-folds]"), "{error}");
}

#[test]
fn necks_that_are_none_are_refused_in_their_place() {
    let plate = r#""plate": [60, 50]"#;
    for (fields, place, reason) in [
        (
            format!(r#""pipe_radius": 0, "ball_radius": 4, "height": 40, {plate}"#),
            "pipe_radius",
            "[radius-not-positive]",
        ),
        (
            format!(r#""pipe_radius": 9, "ball_radius": -4, "height": 40, {plate}"#),
            "ball_radius",
            "[radius-not-positive]",
        ),
        (
            r#""pipe_radius": 9, "ball_radius": 9, "height": 40, "side": "inside""#.to_owned(),
            "ball_radius",
            "[ball-does-not-fit]",
        ),
        (
            format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "slope": {{"degrees": 90}}"#),
            "slope",
            "[angle-out-of-range]",
        ),
        (format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 4, {plate}"#), "height", "[parameter-out-of-range]"),
        (
            r#""pipe_radius": 9, "ball_radius": 4, "height": 40, "plate": {"radius": 13}"#.to_owned(),
            "plate",
            "[plate-too-small]",
        ),
        (
            format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "thickness": 0"#),
            "thickness",
            "[parameter-out-of-range]",
        ),
        (
            format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "thickness": 1, "wall": 9"#),
            "wall",
            "[parameter-out-of-range]",
        ),
        (r#""pipe_radius": 9, "ball_radius": 4, "height": 40"#.to_owned(), "n", "requires a `plate`"),
        (format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "wall": 1"#), "n", "`wall` requires"),
        (
            format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "side": "inside""#),
            "n",
            "remove `plate`",
        ),
        (r#""pipe_radius": 9, "ball_radius": 4, "height": 40, "plate": 7"#.to_owned(), "n.plate", "expected two sides"),
    ] {
        let error = build(&format!(r#""n": {{"type": "plate-with-neck", {fields}}}"#)).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
}
