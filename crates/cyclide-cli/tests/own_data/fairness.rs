//! Runs that waver, and those that do not; frames that turn over.

use serde_json::{Value, json};

use super::case;
use super::common::{Folder, project};

/// The warnings of the only object of a document, `a`, with these reasons.
fn warnings(folder: &Folder, object: &Value, reasons: &[&str]) -> Vec<String> {
    folder.write("m.json", &json!({"cyclide": 1, "objects": {"a": object}}).to_string());
    let found: Value = serde_json::from_str(&folder.ok("report m.json --json")).unwrap();
    let all = found["objects"]["a"]["warnings"].as_array().unwrap().clone();
    let said = |w: &Value| format!("{}: {}", w["reason"].as_str().unwrap(), w["message"].as_str().unwrap());
    all.iter().map(said).filter(|text| reasons.iter().any(|reason| text.starts_with(&format!("{reason}: ")))).collect()
}

const WAVERING: [&str; 2] = ["wavers", "data-waver"];

/// A closed curve of two straight runs and two half circles, so many samples at equal distances from a start.
fn stadium(straight: f64, radius: f64, count: usize, start: f64) -> Vec<[f64; 2]> {
    let (half, total) = (std::f64::consts::PI * radius, 2.0 * (straight + std::f64::consts::PI * radius));
    let at = |s: f64| {
        let (side, s) = if s < straight + half { (1.0, s) } else { (-1.0, s - straight - half) };
        let angle = (s - straight).max(0.0) / radius;
        let x = s.min(straight) + radius * angle.sin() - 0.5 * straight;
        [side * x, side * -radius * angle.cos()]
    };
    (0..count).map(|i| at((start + total * i as f64 / count as f64) % total)).collect()
}

/// Points of a plane curve whose direction is given along its length, at steps of 1.
fn drawn(direction: impl Fn(f64) -> f64, count: usize) -> Vec<[f64; 2]> {
    let (mut at, mut points) = ([0.0, 0.0], Vec::new());
    for i in 0..count {
        points.push(at);
        for k in 0..100 {
            let angle = direction(i as f64 + (f64::from(k) + 0.5) / 100.0);
            at = [at[0] + 0.01 * angle.cos(), at[1] + 0.01 * angle.sin()];
        }
    }
    points
}

/// An exact line, arc, line: a fair spline through it bends to the other side by amounts that nothing shows.
#[test]
fn a_line_an_arc_and_a_line_do_not_waver() {
    let folder = Folder::with(&[("line_arc_line.csv", &case("line_arc_line.csv"))]);
    let run = folder.run("curve line_arc_line.csv -o l.svg");
    assert!(run.code == 0 && !run.stderr.contains("waver"), "{}", run.stderr);
    for member in 0..100 {
        let (radius, count) = (12.0 + 3.0 * f64::from(member), 40 + 3 * member as usize);
        let points = stadium(150.0 + 2.0 * f64::from(member), radius, count, 7.3 * f64::from(member));
        let object = json!({"type": "fair-spline", "points": points, "closed": true});
        let said = warnings(&folder, &object, &WAVERING);
        assert!(said.is_empty(), "radius {radius}, {count} points: {said:?}");
    }
}

/// A spline that is laid by a local rule wavers on the same samples of a track on which the fair one does not; each is told
/// what helps its kind.
#[test]
fn every_kind_is_told_when_it_wavers() {
    let folder = Folder::with(&[]);
    let track = std::fs::read_to_string(project("examples/track.csv")).unwrap();
    let points: Vec<Vec<f64>> =
        track.lines().filter_map(|line| line.split(',').take(2).map(|v| v.trim().parse().ok()).collect()).collect();
    assert_eq!(points.len(), 44);
    let object = |kind: &str| json!({"type": kind, "points": points, "closed": true});
    for kind in ["circle-spline", "moebius-spline"] {
        let said = warnings(&folder, &object(kind), &WAVERING);
        assert!(
            said.len() == 1 && said[0].starts_with("wavers") && said[0].contains("a fair spline"),
            "{kind}: {said:?}"
        );
    }
    assert!(warnings(&folder, &object("fair-spline"), &WAVERING).is_empty());
    // Corners that are not marked: a fair spline swings round them, and is not told to be a fair spline.
    let stairs = drawn(|s| if (s / 3.0) as i32 % 2 == 0 { 0.0 } else { 1.2 }, 40);
    let said = warnings(&folder, &json!({"type": "fair-spline", "points": stairs, "straight": "off"}), &["wavers"]);
    assert!(said.iter().all(|text| text.contains("add points") && !text.contains("a fair spline")), "{said:?}");
}

/// The amplitude counts: the same wave is silent where it turns by less than 5e-4 radians, and named where it
/// turns by more, whichever kind passes through it.
#[test]
fn waves_count_by_their_amplitude() {
    let folder = Folder::with(&[]);
    for kind in ["fair-spline", "circle-spline", "moebius-spline"] {
        for (amplitude, is_said) in [(1e-7, false), (1e-4, false), (0.03, true), (0.1, true)] {
            // Every other point is to the left of a line.
            let noisy = drawn(|s| amplitude * (std::f64::consts::PI * s).sin(), 60);
            let said = warnings(&folder, &json!({"type": kind, "points": noisy}), &WAVERING);
            assert_eq!(!said.is_empty(), is_said, "{kind}, {amplitude}: {said:?}");
        }
    }
}

/// A camera that passes its target turns over at once; the place is between the samples, above the target.
#[test]
fn frames_that_turn_over_are_named_with_their_place() {
    let folder = Folder::with(&[("m.json", &case("look_at_over.json"))]);
    let run = folder.run("sample m.json --object dolly --count 200 --frames look-at --toward 0,0,0 -o s.csv");
    assert!(run.code == 0 && run.stderr.contains("[frame-jumps]"), "{}", run.stderr);
    assert!(run.stderr.contains("station 10 ") && run.stderr.contains("180 degrees"), "{}", run.stderr);
    // Halfway along 20 meters at a height of 5, whatever the samples are.
    for count in [2, 3, 8, 57, 1000] {
        let text =
            folder.ok(&format!("sample m.json --object dolly --count {count} --frames look-at --toward 0,0,0 --json"));
        let found: Value = serde_json::from_str(&text).unwrap();
        let turns = found["contours"][0]["frame_turns"].as_array().unwrap();
        let number = |key: &str| turns[0][key].as_f64().unwrap();
        assert!(turns.len() == 1 && turns[0]["jump"] == true, "{count}: {turns:?}");
        assert!((number("station") - 10.0).abs() < 1e-6 && (number("t") - 0.5).abs() < 1e-6, "{count}: {turns:?}");
        assert!((number("angle") - std::f64::consts::PI).abs() < 1e-6, "{count}: {turns:?}");
    }
}

/// Each rule where its direction passes the tangent, the point or the curvature, and the same curve where none does.
#[test]
fn frames_of_every_rule_are_held_against_their_neighbors() {
    let wave: Vec<[f64; 2]> = (0..25).map(|i| f64::from(i) * 0.5).map(|x| [x, x.sin()]).collect();
    let folder = Folder::with(&[]);
    let turns = |object: &Value, frames: &str, count: usize| {
        folder.write("m.json", &json!({"cyclide": 1, "objects": {"a": object}}).to_string());
        let run = folder.run(&format!("sample m.json --object a --count {count} --frames {frames} --json"));
        assert_eq!(run.code, 0, "{}", run.stderr);
        let found: Value = serde_json::from_str(&run.stdout).unwrap();
        let turns = found["contours"][0]["frame_turns"].as_array().cloned().unwrap_or_default();
        assert_eq!(run.stderr.contains("[frame-jumps]"), !turns.is_empty(), "{}", run.stderr);
        turns
    };
    let wave = json!({"type": "fair-spline", "points": wave});
    // Three inflections of a sine inside of [0, 12], at multiples of pi.
    let found = turns(&wave, "frenet", 400);
    assert!(found.len() == 3 && found.iter().all(|turn| turn["jump"] == true), "{found:?}");
    assert!(turns(&wave, "up", 400).is_empty() && turns(&wave, "rotation-minimizing", 400).is_empty());
    // The point lies on the curve's side until the curve has passed round it.
    let circle = json!({"type": "circle", "center": [0, 0], "radius": 2});
    assert!(turns(&circle, "toward --toward 0,0,0", 100).is_empty());
    // From one sample to the next a third of a circle: they are too far apart, and nothing jumps.
    let far = turns(&circle, "up", 4);
    assert!(far.len() == 3 && far.iter().all(|turn| turn["jump"] == false), "{far:?}");
    // A half circle upright: up is along its tangent at both ends only.
    let upright = json!({"type": "arc", "through": [[0, 0, -1], [1, 0, 0], [0, 0, 1]]});
    assert!(turns(&upright, "rotation-minimizing", 50).is_empty());
    // Over the top the way up turns over.
    let over = json!({"type": "circle", "center": [0, 0], "radius": 2, "normal": [0, 1, 0]});
    let found = turns(&over, "up", 100);
    assert!(found.len() == 2 && found.iter().all(|turn| turn["jump"] == true), "{found:?}");
}
