//! Tubes blended with spheres and plates.

use super::{build, surface};

fn blend(fields: &str) -> Result<cyclide_io::document::BuiltObject, String> {
    build(&format!(r#""c": {{"type": "contact-blend", {fields}}}"#))
}

const STRUT: &str = r#""tube": {"through": [0, 12, 0], "radius": 10, "length": 90}"#;
const CONE: &str = r#""tube": {"direction": [1, 0, 3], "radius": 12, "taper": {"degrees": 4}, "length": 80}"#;

#[test]
fn blends_are_solids_with_a_report() {
    let node = surface(&blend(&format!(r#"{STRUT}, "sphere": 40, "blend": 6"#)).unwrap());
    assert!(node.closed && node.bodies == 1);
    let [facts] = &node.blends[..] else { panic!("one blend: {:?}", node.blends) };
    assert!(facts.radius.min >= 5.994 && facts.radius.max <= 6.006, "{facts:?}");
    let hollow = surface(&blend(&format!(r#"{STRUT}, "sphere": 40, "blend": 6, "wall": 2"#)).unwrap());
    let closed =
        surface(&blend(&format!(r#"{STRUT}, "sphere": 40, "blend": 6, "wall": 2, "ends": "closed""#)).unwrap());
    // A disk 2 thick at the end of the bore.
    let disk = std::f64::consts::PI * 2.0 * 64.0;
    assert!(((closed.volume.unwrap() - hollow.volume.unwrap()) / disk - 1.0).abs() < 1e-9);
    let plate = r#""plate": [120, 100], "blend": 5"#;
    let boss = surface(&blend(&format!(r#"{CONE}, {plate}, "thickness": 8"#)).unwrap());
    assert!(
        boss.closed
            && (boss.blends[0].radius.max - 5.0).abs() < 1e-12
            && (boss.blends[0].radius.min - 5.0).abs() < 1e-12
    );
    // The plate alone is 8 thick: half as thick, it has so much less.
    let thin = surface(&blend(&format!(r#"{CONE}, {plate}, "thickness": 4"#)).unwrap());
    assert!((boss.volume.unwrap() - thin.volume.unwrap() - 4.0 * 120.0 * 100.0).abs() < 1e-7);
    assert!(!surface(&blend(&format!("{CONE}, {plate}")).unwrap()).closed);
    let head = r#""tube": {"radius": 20, "length": 30}, "sphere": 40, "blend": 6, "side": "inside""#;
    assert!(surface(&blend(&format!(r#"{head}, "wall": 2"#)).unwrap()).closed);
}

#[test]
fn rings_are_solids_with_a_report() {
    let ring = r#""ring": {"radius": 30, "tube": 8, "height": 2}"#;
    let on = |rest: &str| surface(&blend(&format!("{ring}, {rest}")).unwrap());
    let plate = on(r#""plate": {"radius": 60}, "thickness": 7, "blend": 3"#);
    assert!(plate.closed && plate.bodies == 1 && plate.blends[0].radius.min.to_bits() == 3.0_f64.to_bits());
    let sheet = on(r#""plate": {"radius": 60}, "blend": 3"#);
    assert!(!sheet.closed);
    let thicker = on(r#""plate": {"radius": 60}, "thickness": 8, "blend": 3"#);
    let disk = std::f64::consts::PI * 3600.0;
    assert!((thicker.volume.unwrap() - plate.volume.unwrap() - disk).abs() < 1e-9 * disk);
    assert!(on(r#""sphere": 30, "blend": 3"#).closed);
    for (fields, place, reason) in [
        (
            r#""ring": {"radius": 30, "tube": 8, "height": 20}, "plate": {"radius": 60}, "blend": 3"#,
            "ring",
            "[contact-loop-open]",
        ),
        (r#""ring": {"radius": 8, "tube": 8}, "plate": {"radius": 60}, "blend": 3"#, "ring", "[not-a-ring-torus]"),
        (r#""ring": {"radius": 30, "tube": 8}, "plate": {"radius": 60}, "blend": 90"#, "blend", "[ball-does-not-fit]"),
        (r#""ring": {"radius": 30, "tube": 8}, "plate": {"radius": 40}, "blend": 3"#, "plate", "[plate-too-small]"),
        (r#""ring": {"radius": 30, "tube": 8}, "plate": [90, 90], "blend": 3"#, "", "round `plate`"),
        (r#""ring": {"radius": 30, "tube": 8}, "sphere": 30, "wall": 1, "blend": 3"#, "", "remove `side`"),
        (r#""sphere": 30, "blend": 3"#, "", "a `tube` or a `ring`"),
        (
            r#""tube": {"radius": 10, "length": 90}, "ring": {"radius": 30, "tube": 8}, "sphere": 30, "blend": 3"#,
            "",
            "a `tube` or a `ring`",
        ),
    ] {
        let error = blend(fields).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{reason}: {error}");
    }
}

#[test]
fn blends_that_are_none_are_refused_in_their_place() {
    for (fields, place, reason) in [
        (
            r#""tube": {"through": [0, 35], "radius": 10, "length": 90}, "sphere": 40, "blend": 6"#,
            "tube",
            "[contact-loop-open]",
        ),
        (r#""tube": {"radius": 10, "length": 40}, "sphere": 40, "blend": 6"#, "tube", "[contact-tube-too-short]"),
        (r#""tube": {"radius": 10, "length": 90}, "sphere": 40, "blend": -1"#, ".blend:", "[radius-not-positive]"),
        (r#""tube": {"radius": 10, "length": 90}, "sphere": -40, "blend": 1"#, ".sphere:", "[radius-not-positive]"),
        (r#""tube": {"radius": -10, "length": 90}, "sphere": 40, "blend": 1"#, ".tube:", "[radius-not-positive]"),
        (
            r#""tube": {"radius": 10, "taper": 0.2, "length": 90}, "sphere": 40, "blend": 3"#,
            ".tube:",
            "apex at 49.332 along its axis, but is needed up to 90",
        ),
        (
            r#""tube": {"through": [0, 35], "radius": 10, "length": 90}, "sphere": 40, "blend": 6"#,
            ".tube:",
            "closer to the center of the sphere",
        ),
        (
            r#""tube": {"radius": 10, "direction": [1, 0, 0], "length": 40}, "plate": [90, 90], "blend": 6"#,
            "tube",
            "[parallel-contact]",
        ),
        (
            r#""tube": {"radius": 10, "direction": [2, 0, 1], "length": 400}, "plate": [900, 900], "blend": 60"#,
            "blend",
            "[contact-blend-folds]",
        ),
        (
            r#""tube": {"through": [0.232, 0, -0.296], "radius": 0.763, "taper": -0.65, "length": 9}, "sphere": 1, "blend": 0.01"#,
            "tube",
            "use a cone that widens less towards its end",
        ),
        (r#""tube": {"radius": 10, "length": 40}, "plate": [30, 90], "blend": 6"#, "plate", "[plate-too-small]"),
        (
            r#""tube": {"radius": 10, "length": 40}, "sphere": 40, "blend": 12, "side": "inside""#,
            "blend",
            "[ball-does-not-fit]",
        ),
        (
            r#""tube": {"radius": 10, "length": 40}, "sphere": 40, "blend": 3, "side": "inside", "wall": 3"#,
            "wall",
            "[parameter-out-of-range]",
        ),
        (
            r#""tube": {"radius": 10, "taper": 2, "length": 40}, "sphere": 40, "blend": 3"#,
            "tube",
            "[parameter-out-of-range]",
        ),
        (
            r#""tube": {"radius": 10, "length": 40}, "sphere": 40, "blend": 3, "tolerance": 0"#,
            "tolerance",
            "[tolerance-not-positive]",
        ),
        (r#""tube": {"radius": 10, "length": 40}, "blend": 3"#, "", "requires a `sphere`"),
        (r#""tube": {"radius": 10, "length": 40}, "sphere": 40, "plate": [90, 90], "blend": 3"#, "", "remove one"),
        (
            r#""tube": {"radius": 10, "length": 40}, "plate": [90, 90], "blend": 3, "side": "inside""#,
            "",
            "remove `plate`",
        ),
        (
            r#""tube": {"radius": 10, "length": 40}, "plate": [90, 90], "thickness": 3, "wall": 1, "blend": 3"#,
            "",
            "remove `thickness`",
        ),
        (
            r#""tube": {"radius": 10, "length": 90}, "sphere": 40, "blend": 3, "wall": 1, "ends": "open""#,
            "",
            "`wall` makes a solid",
        ),
    ] {
        let error = blend(fields).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{reason}: {error}");
    }
}

/// Arcs of a millionth beside a plate of 600 do not meet for being near each other, and a ring that is out of reach is told so.
#[test]
fn balls_far_smaller_than_their_plate_are_told_apart() {
    for ball in ["1e-6", "1e-3"] {
        let made = blend(&format!(
            r#""ring": {{"radius": 30, "tube": 8, "height": 5}}, "plate": {{"radius": 600}}, "blend": {ball}"#
        ));
        assert!(made.is_ok(), "{ball}: {made:?}");
    }
    let error =
        blend(r#""ring": {"radius": 30, "tube": 8, "height": 20}, "plate": {"radius": 60}, "blend": 3"#).unwrap_err();
    assert!(
        error.contains("[contact-loop-open]") && error.contains("the ring") && !error.contains("turn it"),
        "{error}"
    );
}
