//! What is refused is shown at its place, whatever the type.

use cyclide::Point3;

use super::{CIRCLE, OCTANT, build, cylinder, point};

#[test]
fn what_is_refused_is_shown_at_its_place() {
    let patch = |corners: &str, frame: &str| {
        format!(r#""a": {{"type": "cyclide-patch", "corners": [{corners}], "frame": [{frame}]}}"#)
    };
    let square = "[0,0],[1,0],[0,1],[1,1]";
    let with = |rest: &str| format!("{OCTANT}, {CIRCLE}, {rest}");
    let transform = |of: &str, step: &str| {
        with(&format!(r#""a": {{"type": "transform", "of": "{of}", "steps": [{{"translation": [1,0]}}, {step}]}}"#))
    };
    for (objects, piece, start) in [
        (
            patch("[0,0],[1,0],[0,1],[1,1.1]", "[1,0],[0,1]"),
            "[1,1.1]",
            "objects.a.corners[3]: the corners do not lie on one circle: relative distance 0.049723, limit 1e-9; with `directions` in place of `frame` they may lie anywhere [",
        ),
        (patch("[0,0],[1,0],[1,1],[0,1]", "[1,0],[0,1]"), "[0,1]", "objects.a.corners[3]: the sides cross"),
        (
            patch("[0,0],[0,0],[1,1],[0,1]", "[1,0],[0,1]"),
            "[0,0]",
            "objects.a.corners[1]: points 0 and 1 are coincident",
        ),
        (patch("[0,0],[1,0],[0,1]", "[1,0],[0,1]"), "[", "objects.a.corners: 3 values are given, 4 are needed"),
        (
            patch("[0,0],[1,0],[0,1], [1,1],[2,2]", "[1,0],[0,1]"),
            "[",
            "objects.a.corners: 5 values are given, 4 are needed",
        ),
        (patch(square, "[1,0],[0,1],[0,0,1]"), "[", "objects.a.frame: 3 values are given, 2 are needed"),
        (
            transform("o", r#"{"scale": {"factor": 2}, "translation": [1,0]}"#),
            "{",
            "objects.a.steps[1]: one name is expected here: put each into its own braces",
        ),
        (
            transform("o", r#"{"matrix": [[[1,0,0,0],[0]],[]]}"#),
            "[",
            "objects.a.steps[1].matrix[0][1]: 1 value is given, 4 are needed",
        ),
        (
            patch(square, "[1,0],[1,1]"),
            "[[1,0],[1,1]]",
            "objects.a.frame: the directions of the frame must be perpendicular",
        ),
        (
            patch(square, "[1,0],[0,0]"),
            "[[1,0],[0,0]]",
            "objects.a.frame: the directions of the frame must not be zero",
        ),
        (
            patch(square, "[1,0],[0,1]").replace("\"frame\"", "\"frame_corner\": 4, \"frame\""),
            "4",
            "objects.a.frame_corner: frame_corner = 4",
        ),
        (with(r#""a": {"type": "offset", "of": "x", "distance": 1}"#), "\"x\"", "objects.a.of: there is no object `x`"),
        (
            with(r#""a": {"type": "offset", "of": "c", "distance": 1}"#),
            "\"c\"",
            "objects.a.of: `c` is of type `circle`: only a `torus-spline`",
        ),
        (with(r#""a": {"type": "offset", "of": "a", "distance": 1}"#), "\"a\"", "objects.a.of: `a` refers to itself"),
        (
            transform("o", r#"{"inversion": {"center": [4,0], "radius": 1}}"#),
            "",
            "objects.a.steps[1]: a point is at infinity",
        ),
        (transform("o", r#"{"inversion": {"center": [3,0], "radius": 0}}"#), "", "objects.a.steps[1]: the radius"),
        (transform("o", r#"{"rotation": {"axis": [0,0], "angle": 1}}"#), "", "objects.a.steps[1]: the axis is zero"),
        (
            transform("o", r#"{"matrix": [[[1,0,0,0],[1,0,0,0]],[[0,0,0,0],[1,0,0,0]]]}"#),
            "",
            "objects.a.steps[1]: the Möbius matrix",
        ),
        (
            transform("c", r#"{"inversion": {"center": [9,0], "radius": 1}}"#),
            "",
            "objects.a.steps[1]: the map is not a similarity",
        ),
        (transform("o", r#"{"shift": [1,0]}"#), "", "objects.a.steps[1]: unknown variant `shift`"),
    ] {
        let message = build(&objects).map(|b| format!("built {:?}", b.item)).unwrap_err();
        let lines: Vec<&str> = message.lines().collect();
        assert!(lines[0].starts_with("m.json:2:") && lines[0].contains(&format!(": {start}")), "{start}\n{message}");
        if !piece.is_empty() {
            let carets = lines[2].find('^').unwrap()..lines[2].len();
            assert_eq!(&lines[1][carets], piece, "{message}");
        }
    }
}

#[test]
fn long_chains_and_circles_of_references() {
    let link = |i: usize, of: usize| format!(r#""{i}": {{"type": "offset", "of": "{of}", "distance": 0.001}}"#);
    let chain: Vec<String> = (1..2000).map(|i| link(i, i - 1)).collect();
    let base = OCTANT.replacen("\"o\"", "\"0\"", 1);
    let built = build(&format!("{base}, {}", chain.join(", "))).unwrap();
    assert!((point(&built, 0.5, 0.5).distance(Point3::new(1.0, 0.0, 0.0)) - 3.999).abs() < 1e-12);
    let circle: Vec<String> = (0..2000).map(|i| link(i, (i + 1) % 2000)).collect();
    let message = build(&circle.join(", ")).unwrap_err();
    assert!(message.contains("refers to itself"), "{message}");
}

#[test]
fn refusals_name_the_factor_the_steps_and_the_curve() {
    for (factor, words) in [("0", "the scale factor 0 is not positive"), ("-2", "the scale factor -2 is not positive")]
    {
        let scaled = format!(
            r#"{CIRCLE}, "b": {{"type": "transform", "of": "c", "steps": [{{"scale": {{"factor": {factor}}}}}]}}"#
        );
        let message = build(&scaled).unwrap_err();
        assert!(message.contains(words) && message.contains("[scale-not-positive]"), "{message}");
    }
    let message = build(&cylinder(r#", "make_circular": {"max_steps": 0}"#)).unwrap_err();
    let words = "objects.n.make_circular.max_steps: max_steps = 0 is out of range: must be at least 1 [";
    assert!(message.contains(words), "{message}");

    // The whole side lies behind one end of the segment.
    let far = r#""far": {"type": "arc-spline", "points": [[-9, 0], [-8, 0]], "construction": true}, "#;
    let on_far = cylinder(r#", "make_circular": {"border": {"first_row": "far"}}"#);
    let message = build(&(far.to_owned() + &on_far)).unwrap_err();
    let words = "objects.n.make_circular.border: vertices 0 and 1 coincide on the curve of their side";
    assert!(message.contains(words) && message.contains("[collapsed-on-curve]"), "{message}");
}
