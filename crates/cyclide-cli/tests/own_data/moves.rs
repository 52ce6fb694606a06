//! Moves of robots and cameras: straight, closed, noisy.

use crate::case;
use crate::common::Folder;
use serde_json::Value;

/// The report on the motion `m` of a document.
fn report(document: &str) -> (Value, String) {
    let folder = Folder::with(&[("m.json", document)]);
    let run = folder.run("report m.json --json");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let report: Value = serde_json::from_str(&run.stdout).expect("JSON");
    (report["objects"]["m"].clone(), folder.ok("report m.json"))
}

fn reasons(report: &Value) -> Vec<&str> {
    report["warnings"].as_array().into_iter().flatten().filter_map(|w| w["reason"].as_str()).collect()
}

fn off_chords(report: &Value) -> [f64; 2] {
    ["distance", "time"].map(|key| report["off_chords"][key].as_f64().expect("a number"))
}

/// A document of a case with another kind of motion.
fn with_kind(case: &str, kind: &str) -> String {
    let mut document: Value = serde_json::from_str(case).expect("JSON");
    document["objects"]["m"]["kind"] = kind.into();
    document.to_string()
}

/// 100 mm with a turn of 170 degrees run on the arc of a circle: its rise is (100/2)/tan(85°) below its radius. It is said, and linear goes straight.
#[test]
fn a_half_turn_on_the_way_is_said() {
    let (found, text) = report(&case("motion_half_turn.json"));
    let [distance, time] = off_chords(&found);
    // Half the chord times the tangent of a quarter of the turn.
    assert!((distance - 50.0 * 42.5_f64.to_radians().tan()).abs() < 1e-6, "{distance}");
    assert!((time - 0.5).abs() < 1e-6 && reasons(&found) == ["leaves-chords"], "{found}");
    assert!(text.contains("off chords"), "{text}");
    let (found, _) = report(&with_kind(&case("motion_half_turn.json"), "linear"));
    assert!((found["length"].as_f64().unwrap() - 100.0).abs() < 1e-9);
    assert!(off_chords(&found)[0] <= 0.0 && reasons(&found).is_empty(), "{found}");
    // What its origin runs on is the line, exactly.
    let folder = Folder::with(&[("m.json", &with_kind(&case("motion_half_turn.json"), "linear"))]);
    let path = folder.json("report m.json --json")["objects"]["tr"].clone();
    assert!(
        (path["contours"][0]["length"].as_f64().unwrap_or(100.0) - 100.0).abs() < 1e-9 && reasons(&path).is_empty()
    );
}

/// Lift, turn, lower: it must not turn while it lifts, nor rise while it turns. As a spline it does both, and says so.
#[test]
fn rocking_without_a_net_turn_is_said() {
    let (found, _) = report(&case("motion_lift_turn_lower.json"));
    assert_eq!(reasons(&found), ["motion-swings"]);
    let warning = found["warnings"][0]["message"].as_str().unwrap();
    assert!(warning.contains("`linear`"), "{warning}");
    assert!((off_chords(&found)[0] - 0.125).abs() < 1e-3, "{found}");
    let (found, _) = report(&with_kind(&case("motion_lift_turn_lower.json"), "linear"));
    assert!((found["length"].as_f64().unwrap() - 2.0).abs() < 1e-9 && off_chords(&found)[0] <= 0.0);
    assert!((found["turn"].as_f64().unwrap() - std::f64::consts::FRAC_PI_2).abs() < 1e-9);
    assert!(reasons(&found).is_empty());
}

/// Poses on one line are left by as much as the sizes of the case say, also by screws; that is said, with the time.
#[test]
fn straight_poses_say_how_far_they_are_left() {
    let (found, _) = report(&case("motion_straight_poses.json"));
    // 1.02 m aside of the line, and that behind its first pose.
    assert!((1.02..2.0).contains(&off_chords(&found)[0]) && reasons(&found) == ["motion-swings"], "{found}");
    let (found, _) = report(&case("motion_sclerp.json"));
    // A turn by 40 degrees over half a metre: the arc rises by 250 mm times tan 10°.
    assert!((off_chords(&found)[0] - 0.25 * 10.0_f64.to_radians().tan()).abs() < 1e-9, "{found}");
    for name in ["motion_straight_poses.json", "motion_sclerp.json"] {
        let (found, _) = report(&with_kind(&case(name), "linear"));
        let leaves = ["leaves-chords", "motion-swings"];
        assert!(off_chords(&found)[0] <= 0.0 && !reasons(&found).iter().any(|r| leaves.contains(r)), "{name} {found}");
    }
}

/// Without `closed` the corner where a motion comes back is said; with it, it is none, and the turn goes on.
#[test]
fn closed_motions_close() {
    let open = case("motion_closed.json");
    let (found, text) = report(&open);
    assert!(
        found["closing"]["angular_velocity_jump"].as_f64().unwrap() + found["closing"]["corner"].as_f64().unwrap()
            > 0.1
    );
    assert!(text.contains("closes") && text.contains("with a "), "{text}");
    let mut closed: Value = serde_json::from_str(&open).expect("JSON");
    closed["objects"]["m"]["closed"] = true.into();
    let (found, text) = report(&closed.to_string());
    assert!(found["closing"]["corner"].as_f64().unwrap() < 1e-9, "{found}");
    assert!(found["closing"]["velocity_jump"].as_f64().unwrap() < 1e-9, "{found}");
    assert!(
        (found["turn"].as_f64().unwrap() - std::f64::consts::TAU).abs() < 1e-6 && text.contains("as it began\n"),
        "{text}"
    );
    assert_eq!(text.matches("corners").count(), 0, "{text}");
    // The first pose need not be repeated.
    closed["objects"]["m"]["poses"].as_array_mut().unwrap().pop();
    let (other, _) = report(&closed.to_string());
    assert!((other["length"].as_f64().unwrap() - found["length"].as_f64().unwrap()).abs() < 1e-9);
    // Linear moves come back, too, with a corner, and without one where they blend.
    closed["objects"]["m"]["kind"] = "linear".into();
    let (found, _) = report(&closed.to_string());
    assert!((found["length"].as_f64().unwrap() - 4.0 * 5100.0_f64.sqrt()).abs() < 1e-6, "{found}");
    assert!(found["closing"]["corner"].as_f64().unwrap() > 1.0);
    closed["objects"]["m"]["blend_radius"] = 8.into();
    let (found, _) = report(&closed.to_string());
    assert!(found["closing"]["corner"].as_f64().unwrap() < 1e-6, "{found}");
    assert!(found["velocity_jump"].as_f64().unwrap() < 1e-9, "{found}");
}

/// Samples, and poses in an animation, are those of a straight line and of slerp.
#[test]
fn samples_and_animations_go_straight() {
    let folder = Folder::with(&[("m.json", &with_kind(&case("motion_half_turn.json"), "linear"))]);
    let samples = folder.ok("sample m.json --object m --count 11");
    let mut lines = samples.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| header.iter().position(|word| *word == name).unwrap_or_else(|| panic!("{header:?}"));
    let [x, y, qw, qz] = ["x", "y", "qw", "qz"].map(column);
    for (k, line) in lines.enumerate() {
        let values: Vec<f64> = line.split(',').map(|value| value.parse().unwrap_or(f64::NAN)).collect();
        let part = k as f64 / 10.0;
        assert!((values[x] - 100.0 * part).abs() < 1e-9 && values[y].abs() < 1e-9, "{line}");
        let half = 85.0_f64.to_radians() * part;
        assert!(
            (values[qw].abs() - half.cos().abs()).abs() < 1e-9 && (values[qz].abs() - half.sin().abs()).abs() < 1e-9
        );
    }
    // The file is read back and held against the motion.
    folder.ok("build m.json -o m.glb");
    let document =
        with_kind(&case("motion_half_turn.json"), "linear").replace(r#""of":"m""#, r#""of":"m","point":[20,0,0]"#);
    folder.write("p.json", &document);
    let run = folder.run("build p.json -o p.step");
    assert!(run.code == 0 && (run.stdout + &run.stderr).contains("within"), "the bound of the path is said");
}

/// The fields that go together, and those that do not.
#[test]
fn fields_that_do_not_fit_are_refused() {
    let document = |fields: &str| {
        format!(
            r#"{{"cyclide": 1, "objects": {{"m": {{"type": "motion", {fields}, "poses": [
                {{"position": [0, 0, 0]}}, {{"position": [10, 0, 0], "rpy": {{"degrees": [0, 0, 40]}}}},
                {{"position": [10, 10, 0], "rpy": {{"degrees": [0, 0, 40]}}}}, {{"position": [0, 10, 5]}}]}}}}}}"#
        )
    };
    for fields in [
        r#""positions": "fair""#,
        r#""positions": "polyline", "closed": true"#,
        r#""positions": "circle-spline", "closed": true"#,
        r#""kind": "linear", "blend_radius": 2"#,
        r#""tolerance": {"place": 1}"#,
        r#""tolerance": {"place": 1, "angle": {"degrees": 2}}"#,
    ] {
        let (found, _) = report(&document(fields));
        assert!(found["off_chords"]["distance"].is_number(), "{fields} {found}");
        if fields.contains("positions") {
            assert!(found["velocity_jump"].as_f64().unwrap() < 1e-9 || fields.contains("polyline"), "{fields} {found}");
            assert!(found["angular_velocity_jump"].as_f64().unwrap() < 1e-9, "{fields} {found}");
        }
    }
    for (fields, words) in [
        (r#""kind": "linear", "positions": "fair""#, "`kind`"),
        (r#""kind": "conic", "closed": true"#, "`closed`"),
        (r#""blend_radius": 2"#, "`blend_radius`"),
        (r#""kind": "linear", "blend_radius": -2"#, "blend_radius"),
        (r#""tolerance": {"place": 0}"#, "tolerance"),
        (r#""tolerance": {"place": 1}, "closed": true"#, "`closed`"),
    ] {
        let folder = Folder::with(&[("m.json", &document(fields))]);
        let run = folder.run("report m.json");
        assert!(run.code != 0 && run.stderr.contains(words), "{fields}\n{}", run.stderr);
    }
}
