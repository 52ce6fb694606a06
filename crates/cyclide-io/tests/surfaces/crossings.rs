//! Crossings of pipes.

use super::{build, surface};

fn crossing(fields: &str) -> Result<cyclide_io::document::BuiltObject, String> {
    build(&format!(r#""c": {{"type": "pipe-crossing", {fields}}}"#))
}

fn pipes(radii: [f64; 2], rest: &str) -> String {
    let [first, second] = radii.map(|radius| format!(r#"{{"radius": {radius}, "ends": [-60, 70]}}"#));
    format!(r#""pipes": [{first}, {second}], {rest}"#)
}

#[test]
fn crossings_are_solids_with_a_report_on_their_blend() {
    let rest = r#""distance": 24, "blend": 4"#;
    let filled = surface(&crossing(&pipes([15.0, 12.0], rest)).unwrap());
    assert!(filled.closed && filled.bodies == 1);
    let [blend] = &filled.blends[..] else { panic!("one blend: {:?}", filled.blends) };
    assert!(blend.radius.min >= 3.996 && blend.radius.max <= 4.004, "{blend:?}");
    assert!(blend.tightest > 0.0 && blend.tightest < 1.0);
    let hollow = surface(&crossing(&pipes([15.0, 12.0], &format!(r#"{rest}, "wall": 2"#))).unwrap());
    let closed = surface(&crossing(&pipes([15.0, 12.0], &format!(r#"{rest}, "wall": 2, "ends": "closed""#))).unwrap());
    // A disk 2 thick at either end of each bore.
    let disks = std::f64::consts::PI * 2.0 * 2.0 * (169.0 + 100.0);
    let more = closed.volume.unwrap() - hollow.volume.unwrap();
    assert!((more / disks - 1.0).abs() < 1e-9, "{more} {disks}");
    assert!(!surface(&crossing(&pipes([15.0, 12.0], &format!(r#"{rest}, "ends": "open""#))).unwrap()).closed);
}

#[test]
fn crossings_that_are_none_are_refused_in_their_place() {
    for (radii, rest, place, reason) in [
        ([15.0, 12.0], r#""distance": 2, "blend": 4"#, "distance", "[crossing-axes-too-near]"),
        ([15.0, 15.0], r#""distance": 0, "blend": 4"#, "distance", "`pipe-tee`"),
        ([15.0, 12.0], r#""distance": 24, "blend": -5"#, "blend", "[radius-not-positive]"),
        ([15.0, 12.0], r#""distance": 40, "blend": 4"#, "blend", "[radius-too-small]"),
        ([15.0, 12.0], r#""distance": 24, "blend": 60"#, "", "[crossing-folds]"),
        ([40.0, 4.0], r#""distance": 36.05, "blend": 1"#, "pipes[1]", "[crossing-hole-too-wide]"),
        ([58.0, 60.0], r#""distance": 80, "blend": 4"#, "pipes[0]", "[crossing-pipe-too-short]"),
        ([15.0, 12.0], r#""distance": 24, "blend": 4, "wall": 12"#, "wall", "[parameter-out-of-range]"),
        ([15.0, 12.0], r#""distance": 24, "blend": 4, "angle": {"degrees": 180}"#, "angle", "[parameter-out-of-range]"),
        ([15.0, 12.0], r#""distance": 24, "blend": 9, "angle": {"degrees": 40}"#, "blend", "[crossing-folds]"),
        ([15.0, -12.0], r#""distance": 24, "blend": 4"#, "pipes[1]", "[radius-not-positive]"),
        ([15.0, 12.0], r#""distance": 24, "blend": 4, "wall": 1, "ends": "open""#, "", "`wall` makes a solid"),
        ([15.0, 12.0], r#""distance": 24, "blend": {"first": 4}"#, "", "`first` with `second`"),
        ([15.0, 12.0], r#""distance": 24, "blend": {"first": 4, "second": -3}"#, "blend", "[radius-not-positive]"),
        ([15.0, 12.0], r#""distance": 24, "blend": {"values": []}"#, "blend", "[too-few-points]"),
        ([15.0, 12.0], r#""distance": 24, "blend": 1.5, "side": "inside""#, "blend", "[crossing-ball-too-large]"),
        ([15.0, 12.0], r#""distance": 30, "blend": 1, "side": "inside""#, "blend", "do not overlap"),
        ([15.0, 12.0], r#""distance": 30, "blend": 1, "side": "mixed""#, "distance", "[crossing-pipes-apart]"),
        ([15.0, 12.0], r#""distance": 24, "blend": 11, "side": "mixed""#, "blend", "[crossing-ball-too-large]"),
        (
            [15.0, 12.0],
            r#""distance": 24, "blend": 1, "side": "inside", "wall": 1"#,
            "wall",
            "[parameter-out-of-range]",
        ),
    ] {
        let error = crossing(&pipes(radii, rest)).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{reason}: {error}");
    }
}

#[test]
fn pipes_with_a_taper_are_cones() {
    let cones = |first: &str, second: &str, rest: &str| {
        let pipe = |taper: &str| format!(r#"{{"radius": 15, "taper": {taper}, "ends": [-60, 70]}}"#);
        crossing(&format!(r#""pipes": [{}, {}], {rest}"#, pipe(first), pipe(second)))
    };
    let rest = r#""distance": 24, "blend": 0.01, "tolerance": 0.001"#;
    let built = surface(&cones(r#"{"degrees": 5}"#, "-0.06", rest).unwrap());
    assert!(built.closed && built.bodies == 1);
    // Frusta, less what both have in common: over places along both axes the heights of both over each other.
    let tapers = [5_f64.to_radians().tan(), (-0.06_f64).tan()];
    let frusta = tapers.iter().map(|t| {
        let [a, b] = [15.0 + 60.0 * t, 15.0 - 70.0 * t];
        std::f64::consts::PI / 3.0 * 130.0 * (a * a + a * b + b * b)
    });
    let steps = 1000;
    let place = |k: i32| 40.0 * ((f64::from(k) + 0.5) / f64::from(steps) - 0.5);
    let height = |radius: f64, side: f64| (radius * radius - side * side).max(0.0).sqrt();
    let column = |x: f64, y: f64| {
        let [first, second] = [height(15.0 - tapers[0] * x, y), height(15.0 - tapers[1] * y, x)];
        if first > 0.0 && second > 0.0 { (first + second - 24.0).max(0.0) } else { 0.0 }
    };
    let cell = 40.0 / f64::from(steps);
    let common: f64 = (0..steps * steps).map(|k| column(place(k % steps), place(k / steps)) * cell * cell).sum();
    let expected = frusta.sum::<f64>() - common;
    // The rounded edge adds of its square.
    assert!((built.volume.unwrap() / expected - 1.0).abs() < 1e-6, "{:?} {expected}", built.volume);
    for (first, second, rest, place, reason) in [
        (r#"{"degrees": 13}"#, "0", rest, "pipes[0]", "[radius-not-positive]"),
        ("0.1", "0.1", r#""distance": 24, "blend": 4, "wall": 9"#, "pipes[0]", "[radius-not-positive]"),
        (r#"{"degrees": 13}"#, "0", rest, "pipes[0]", "apex at 64."),
        ("0", r#"{"degrees": 100}"#, rest, "pipes[1]", "[radius-not-positive]"),
        ("0.1", "0.1", r#""distance": 24, "blend": 4, "angle": {"degrees": 11}"#, "angle", "[angle-out-of-range]"),
        ("0.1", "0", r#""distance": 24, "blend": 4, "side": "mixed""#, "side", "[crossing-needs-cylinders]"),
        ("0", "0.1", r#""distance": 24, "blend": {"first": 4, "second": 3}"#, "blend", "[crossing-needs-cylinders]"),
        ("0.1", "-0.1", r#""distance": 40, "blend": 4"#, "blend", "[radius-too-small]"),
        ("0.1", "0.1", r#""distance": 24, "blend": -4"#, "blend", "[radius-not-positive]"),
        ("0.05", "0.19", r#""distance": 0.1, "blend": 1"#, "distance", "[crossing-axes-too-near]"),
    ] {
        let error = cones(first, second, rest).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{reason}: {error}");
    }
}

#[test]
fn laws_of_the_radius_are_followed_and_reported() {
    let rest = |blend: &str| format!(r#""distance": 24, "blend": {blend}, "tolerance": 0.01"#);
    let found = surface(&crossing(&pipes([15.0, 12.0], &rest(r#"{"first": 4, "second": 6.5}"#))).unwrap());
    let [blend] = &found.blends[..] else { panic!("one blend: {:?}", found.blends) };
    assert!((blend.radius.min - 4.0).abs() <= 0.01 && (blend.radius.max - 6.5).abs() <= 0.01, "{blend:?}");
    assert!(blend.deviation > 0.0 && blend.deviation <= 0.01);
    // The same as values.
    let values = r#"{"values": [{"angle": {"degrees": 90}, "radius": 6.5}, {"angle": 0, "radius": 4}, {"angle": {"degrees": -90}, "radius": 6.5}, {"angle": {"degrees": 180}, "radius": 4}]}"#;
    let same = surface(&crossing(&pipes([15.0, 12.0], &rest(values))).unwrap());
    assert!((same.volume.unwrap() / found.volume.unwrap() - 1.0).abs() < 1e-9);
}

#[test]
fn inside_is_what_both_pipes_have_in_common() {
    let rest = r#""distance": 20, "blend": 0.01, "side": "inside""#;
    let lens = surface(&crossing(&pipes([15.0, 15.0], rest)).unwrap());
    assert!(lens.closed && lens.bodies == 1);
    // Half of the overlap of 10 is what a ball has room in; below, over the height the product of two chords.
    let chord = |z: f64| 2.0 * (225.0 - z * z).max(0.0).sqrt();
    let steps = 20_000;
    let slices = (0..steps).map(|k| 5.0 + 10.0 * (f64::from(k) + 0.5) / f64::from(steps));
    let both: f64 = slices.map(|z| chord(z) * chord(z - 20.0) * 10.0 / f64::from(steps)).sum();
    assert!((lens.volume.unwrap() / both - 1.0).abs() < 1e-4, "{:?} {both}", lens.volume);
    let hollow =
        surface(&crossing(&pipes([15.0, 15.0], r#""distance": 20, "blend": 2, "side": "inside", "wall": 1"#)).unwrap());
    assert!(hollow.closed);
    // The second pipe less what both have in common.
    let notched = surface(&crossing(&pipes([15.0, 15.0], &rest.replace("inside", "mixed"))).unwrap());
    let less = std::f64::consts::PI * 225.0 * 130.0 - notched.volume.unwrap();
    assert!(notched.closed && (less / both - 1.0).abs() < 1e-4, "{less} {both}");
}

/// Caps of a thin lens are smooth at the point in their middle: what rounding of the axis, 100 away, left of the side there had normals of its own.
#[test]
fn caps_of_thin_lenses_are_smooth() {
    for fields in [
        r#""pipes": [{"radius": 1, "ends": [-2000, 2000]}, {"radius": 100, "ends": [-2000, 2000]}], "distance": 100.5, "blend": 0.05"#,
        r#""pipes": [{"radius": 1, "ends": [-1100, 1100]}, {"radius": 55, "ends": [-1100, 1100]}], "distance": 55.5, "blend": {"values": [{"angle": 0.26, "radius": 0.025}, {"angle": 3.2, "radius": 0.05}]}"#,
    ] {
        let lens = surface(&crossing(&format!(r#"{fields}, "side": "inside""#)).unwrap());
        assert!(lens.closed && lens.joints.creases == 0 && lens.joints.count > 600, "{:?}", lens.joints);
    }
}

/// What is refused names what was given: the angle of axes that are nearly parallel, no wall of solid pipes, and no finer tolerance where the blend that is asked for folds.
#[test]
fn refusals_of_crossings_name_what_helps() {
    let both = r#"[{"radius": 20, "ends": [-2e6, 2e6]}, {"radius": 20, "ends": [-2e6, 2e6]}]"#;
    for angle in ["1e-9", "1e-6", "3.1415926"] {
        let fields = format!(r#""pipes": {both}, "distance": 32, "blend": 8, "angle": {angle}"#);
        let error = crossing(&fields).unwrap_err();
        assert!(error.contains("c.angle") && error.contains("[angle-out-of-range]"), "{angle}: {error}");
    }
    let fields = format!(r#""pipes": {both}, "distance": 32, "blend": 1, "angle": 1e-4"#);
    let error = crossing(&fields).unwrap_err();
    assert!(error.contains("[crossing-folds]") && error.contains("er ball, or move"), "{error}");
    for (wall, said) in [("", "use a smaller ball, or move the axes"), (r#", "wall": 0.5"#, "a thinner wall")] {
        let error = crossing(&pipes([2.0, 2.0], &format!(r#""distance": 3, "blend": 9{wall}"#))).unwrap_err();
        assert!(error.contains("[crossing-folds]") && error.contains(said), "{error}");
    }
}

/// An image has the blends of what it is the image of, with radii as much larger as it is.
#[test]
fn images_have_blends() {
    let pipes = pipes([15.0, 12.0], r#""distance": 16, "blend": {"first": 4, "second": 3}"#);
    let steps = r#"[{"rotation": {"axis": [1, 2, 0], "angle": 0.7}}, {"scale": {"factor": 2.5}}, {"mirror": {"normal": [0, 1, 3]}}]"#;
    let image = format!(
        r#""c": {{"type": "pipe-crossing", {pipes}}}, "i": {{"type": "transform", "of": "c", "steps": {steps}}}"#
    );
    let (own, image) = (surface(&crossing(&pipes).unwrap()), surface(&build(&image).unwrap()));
    let ([own], [image]) = (&own.blends[..], &image.blends[..]) else { panic!("one blend each") };
    for (a, b) in
        [(own.radius.min, image.radius.min), (own.radius.max, image.radius.max), (own.deviation, image.deviation)]
    {
        assert!((2.5 * a - b).abs() < 1e-13 * b, "{a} {b}");
    }
    assert!((own.tightest, own.tightest_at, own.pieces) == (image.tightest, image.tightest_at, image.pieces));
}
