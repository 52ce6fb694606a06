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
    // A turn by 40 degrees over half a meter: the arc rises by 250 mm times tan 10°.
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
        (found["turn"].as_f64().unwrap() - std::f64::consts::TAU).abs() < 1e-6
            && text.contains("in its initial rotation\n"),
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
        r#""tolerance": {"place": 1, "angle": {"degrees": 2}}, "closed": true"#,
        r#""tolerance": {"place": 1}, "outliers": "drop""#,
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
        (r#""outliers": "drop""#, "`outliers`"),
    ] {
        let folder = Folder::with(&[("m.json", &document(fields))]);
        let run = folder.run("report m.json");
        assert!(run.code != 0 && run.stderr.contains(words), "{fields}\n{}", run.stderr);
    }
}

/// Poses on a ring, noisy, with the times of a motion that comes back, one of them lost.
fn noisy_ring(lost: bool) -> String {
    let mut state = 7_u64;
    let mut noise = || {
        (0..12).fold(-6.0, |sum, _| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            sum + (state >> 11) as f64 / 9_007_199_254_740_992.0
        })
    };
    let pose = |k: u32| {
        let angle = std::f64::consts::TAU * f64::from(k) / 120.0;
        let [x, y, z] = [100.0 * angle.cos(), 60.0 * angle.sin(), 5.0 * (2.0 * angle).sin()].map(|v| v + 0.5 * noise());
        let place = if lost && k == 40 { "0, 0, 0".to_owned() } else { format!("{x}, {y}, {z}") };
        format!(
            r#"{{"time": {}, "position": [{place}], "rpy": [0, 0, {}]}}"#,
            0.1 * f64::from(k),
            angle + 0.002 * noise()
        )
    };
    (0..=120).map(pose).collect::<Vec<_>>().join(", ")
}

/// A motion within a tolerance comes back as it began, and says which pose is lost.
#[test]
fn noisy_motions_close_and_name_lost_poses() {
    let document = |fields: &str, lost: bool| {
        let poses = noisy_ring(lost);
        format!(
            r#"{{"cyclide": 1, "units": "mm", "objects": {{"m": {{"type": "motion", "tolerance": {{"place": 2.2, "angle": {{"degrees": 0.4}}}},
                {fields} "poses": [{poses}]}}}}}}"#
        )
    };
    let gap = |found: &Value| {
        let each =
            ["gap", "velocity_jump", "angular_velocity_jump"].map(|key| found["closing"][key].as_f64().unwrap_or(0.0));
        each.into_iter().fold(0.0, f64::max)
    };
    let (found, text) = report(&document(r#""closed": true,"#, false));
    assert!(gap(&found) < 1e-9 && found["acceleration_jump"].as_f64().unwrap_or(0.0) < 1e-6, "{found}");
    assert!(text.contains("in its initial rotation\n") && reasons(&found).is_empty(), "{text}");
    assert!((found["length"].as_f64().unwrap() - 510.5).abs() < 6.0, "{found}");
    assert!(found["deviation"]["place"].as_f64().unwrap() <= 2.2);
    // Kept, it pulls the motion; left out, it does not.
    for (fields, dropped) in
        [("", false), (r#""outliers": "keep","#, false), (r#""outliers": "drop", "closed": true,"#, true)]
    {
        let (found, _) = report(&document(fields, true));
        assert_eq!(reasons(&found), ["outlier"], "{found}");
        let text = found["warnings"][0]["message"].as_str().unwrap();
        assert!(text.contains("pose 40 is an outlier in position (1 in all)"), "{text}");
        assert_eq!(text.contains("left out"), dropped, "{text}");
        assert_eq!(found["length"].as_f64().unwrap() < 520.0, dropped, "{found}");
    }
}

/// Tolerances far above the noise say that they take bends of the path, or all of it.
#[test]
fn wide_tolerances_of_motions_are_said() {
    let line = (0..60).map(|k| format!(r#"{{"position": [{}, 0, 0]}}"#, 2 * k)).collect::<Vec<_>>().join(", ");
    let ring = noisy_ring(false);
    let document = |poses: &str, place: f64| {
        format!(
            r#"{{"cyclide": 1, "units": "mm", "objects": {{"m": {{"type": "motion", "tolerance": {{"place": {place}}}, "poses": [{poses}]}}}}}}"#
        )
    };
    for (poses, place, expected) in [
        // The poses are .86 (rms) from the path, and these motions .91 and 1.16.
        (&ring, 2.2, None),
        (&ring, 2.5, Some("wide-tolerance")),
        (&ring, 40.0, Some("shape-smoothed-away")),
        (&ring, 400.0, Some("shape-smoothed-away")),
        (&line, 2.5, None),
        (&line, 40.0, Some("wide-tolerance")),
    ] {
        let (found, _) = report(&document(poses, place));
        assert_eq!(reasons(&found), expected.into_iter().collect::<Vec<_>>(), "{place} {found}");
    }
}

/// Which pose of a closed motion comes first is of no matter for how far it is off its chords.
#[test]
fn off_chords_of_closed_motions_do_not_know_the_first_pose() {
    let poses = ["40, -25, 44", "-54, 46, -1", "-62, -16, 3", "14, -49, -55", "10, -23, 12"];
    for fields in [r#""kind": "linear", "blend_radius": 1000"#, r#""kind": "spline""#] {
        let found: Vec<f64> = (0..poses.len())
            .map(|first| {
                let poses =
                    (0..poses.len()).map(|k| format!(r#"{{"position": [{}]}}"#, poses[(first + k) % poses.len()]));
                let poses = poses.collect::<Vec<_>>().join(", ");
                let fields = format!(r#"{fields}, "closed": true, "poses": [{poses}]"#);
                let text = format!(r#"{{"cyclide": 1, "objects": {{"m": {{"type": "motion", {fields}}}}}}}"#);
                off_chords(&report(&text).0)[0]
            })
            .collect();
        assert!(found.iter().all(|off| (off - found[0]).abs() < 1e-6 * found[0]), "{fields} {found:?}");
    }
}
