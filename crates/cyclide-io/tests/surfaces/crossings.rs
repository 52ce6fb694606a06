//! Crossings of pipes.

use super::{build, surface};

fn crossing(fields: &str) -> Result<cyclide_io::BuiltObject, String> {
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
    ] {
        let error = crossing(&pipes(radii, rest)).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{reason}: {error}");
    }
}
