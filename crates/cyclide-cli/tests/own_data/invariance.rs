//! The same points by other weights, parameters, scales and orders have the same figures, or are refused by name: over all
//! kinds of curves and surfaces and over `report`, `sample` and `build`.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::case;
use super::common::Folder;

/// Lengths and areas of the same points agree to this part of themselves.
pub(super) const AGREEMENT: f64 = 1e-9;

/// Numbers without a pattern.
pub(super) struct Random(pub(super) u64);

impl Random {
    /// In `[from, to)`, with three decimals.
    pub(super) fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let unit = (self.0 >> 11) as f64 / (1u64 << 53) as f64;
        ((from + (to - from) * unit) * 1e3).round() / 1e3
    }

    pub(super) fn index(&mut self, count: usize) -> usize {
        (self.between(0.0, count as f64) as usize).min(count - 1)
    }

    /// Points round a ring or half of one, uneven, in space every other time.
    pub(super) fn points(&mut self, count: usize, closed: bool, in_space: bool) -> Vec<[f64; 3]> {
        let turn = if closed { std::f64::consts::TAU } else { 3.5 };
        let point = |i: usize| {
            let (angle, r) = (turn * i as f64 / count as f64, self.between(35.0, 65.0));
            let z = if in_space { self.between(-10.0, 10.0) } else { 0.0 };
            [r * angle.cos(), r * angle.sin(), z]
        };
        (0..count).map(point).collect()
    }
}

/// A curve, its twin, and how many times as long the twin is.
struct Twins {
    name: String,
    objects: [Value; 2],
    factor: f64,
}

/// The object with one field replaced.
fn with(object: &Value, field: &str, value: impl Into<Value>) -> Value {
    let mut changed = object.clone();
    changed[field] = value.into();
    changed
}

fn scaled(points: &[[f64; 3]], factor: f64) -> Value {
    json!(points.iter().map(|p| p.map(|c| c * factor)).collect::<Vec<_>>())
}

/// Powers of two far from 1, in the range of what files hold.
const POWERS: [i32; 6] = [-390, -200, -60, 60, 200, 390];

/// Curves through points, with the same points scaled, backwards and, of closed ones, from another one on.
fn through_points(random: &mut Random, member: usize) -> Vec<Twins> {
    let (closed, in_space) = (member % 2 == 1, member % 4 > 1);
    let count = [5, 7, 9][random.index(3)];
    let points = random.points(count, closed, in_space);
    let mut twins = Vec::new();
    for kind in ["fair-spline", "circle-spline", "moebius-spline", "arc-spline", "polyline", "qb-interpolation"] {
        if kind == "qb-interpolation" && closed {
            continue;
        }
        let mut object = json!({"type": kind, "points": points});
        if closed {
            object["closed"] = true.into();
        }
        let factor = 2_f64.powi(POWERS[random.index(POWERS.len())]);
        let mut add = |what: &str, twin: Value, factor: f64| {
            let name = format!("{kind} {member} {what}");
            twins.push(Twins { name, objects: [object.clone(), twin], factor });
        };
        add("scaled", with(&object, "points", scaled(&points, factor)), factor);
        add("reversed", with(&object, "points", json!(points.iter().rev().collect::<Vec<_>>())), 1.0);
        if closed {
            let mut turned = points.clone();
            turned.rotate_left(1 + random.index(count - 1));
            add("from another point on", with(&object, "points", json!(turned)), 1.0);
        }
    }
    twins
}

/// Rational splines with other weights, knots, scales and directions.
fn nurbs(random: &mut Random, member: usize) -> Vec<Twins> {
    let degree = 1 + random.index(5);
    let count = degree + 1 + [0, 2, 4][random.index(3)];
    let points = random.points(count, false, true);
    let weights: Vec<f64> = (0..count).map(|_| random.between(0.3, 3.0)).collect();
    let mut inner: Vec<f64> = (degree + 1..count).map(|_| random.between(0.05, 0.95)).collect();
    inner.sort_by(f64::total_cmp);
    let end = |u: f64| std::iter::repeat_n(u, degree + 1);
    let knots: Vec<f64> = end(0.0).chain(inner.iter().copied()).chain(end(1.0)).collect();
    let object =
        json!({"type": "nurbs", "degree": degree, "knots": knots, "control_points": points, "weights": weights});
    let mut twins = Vec::new();
    let mut add = |what: String, twin: Value, factor: f64| {
        twins.push(Twins { name: format!("nurbs {member} {what}"), objects: [object.clone(), twin], factor });
    };
    for power in POWERS {
        let factor = 2_f64.powi(power);
        add(format!("times 2^{power}"), with(&object, "control_points", scaled(&points, factor)), factor);
    }
    for factor in [2_f64.powi(-900), 1e-280, 7.3, 1e290] {
        let weights: Vec<f64> = weights.iter().map(|w| w * factor).collect();
        add(format!("weights times {factor:e}"), with(&object, "weights", json!(weights)), 1.0);
    }
    for (factor, start) in [(3.5, 0.0), (1.0, 100.0), (1e-3, -7.0), (1e200, 0.0), (1e-290, 0.0), (1e307, -5e306)] {
        let knots: Vec<f64> = knots.iter().map(|k| factor * k + start).collect();
        add(format!("knots times {factor:e} plus {start}"), with(&object, "knots", json!(knots)), 1.0);
    }
    let mut reversed = with(&object, "control_points", json!(points.iter().rev().collect::<Vec<_>>()));
    reversed["weights"] = json!(weights.iter().rev().collect::<Vec<_>>());
    reversed["knots"] = json!(knots.iter().rev().map(|k| 1.0 - k).collect::<Vec<_>>());
    add("reversed".to_owned(), reversed, 1.0);
    // Other parameters: t becomes u = ct/(1 - t + ct); the blossom of the weights at the knots is divided by 1 - t + ct of each.
    for c in [0.02, 3.0, 400.0] {
        let below = |t: f64| 1.0 - t + c * t;
        let weight = |i: usize| weights[i] / (1..=degree).map(|j| below(knots[i + j])).product::<f64>();
        let mut twin = with(&object, "weights", json!((0..count).map(weight).collect::<Vec<_>>()));
        twin["knots"] = json!(knots.iter().map(|t| c * t / below(*t)).collect::<Vec<_>>());
        add(format!("parameters by {c}"), twin, 1.0);
    }
    twins
}

/// Bézier curves whose weights are multiplied by 1, c, c², …
fn reparametrized(random: &mut Random, member: usize) -> Vec<Twins> {
    let degree = [2, 3, 5][random.index(3)];
    let points = random.points(degree + 1, false, true);
    let weights: Vec<f64> = (0..=degree).map(|_| random.between(0.5, 2.0)).collect();
    let knots: Vec<f64> = [vec![0.0; degree + 1], vec![1.0; degree + 1]].concat();
    let object =
        json!({"type": "nurbs", "degree": degree, "knots": knots, "control_points": points, "weights": weights});
    let twin = |c: f64| {
        let weights: Vec<f64> = weights.iter().enumerate().map(|(i, w)| w * c.powi(i as i32)).collect();
        let name = format!("Bézier {member} weights by {c:e}");
        Twins { name, objects: [object.clone(), with(&object, "weights", json!(weights))], factor: 1.0 }
    };
    [1e-15, 1e-10, 1e-8, 1e-4, 1e-2, 3.0, 1e3, 1e5, 1e7, 1e10, 1e15, 1e28].map(twin).into()
}

/// Curves with one weight far above the others, and the same backwards.
fn peaked(random: &mut Random, member: usize) -> Vec<Twins> {
    let points = random.points(4, false, true);
    let twins = |weight: f64| {
        let object = json!({"type": "nurbs", "degree": 3, "knots": [0, 0, 0, 0, 1, 1, 1, 1], "control_points": points,
            "weights": [1.0, weight, 0.7, 1.3]});
        let mut reversed = with(&object, "control_points", json!(points.iter().rev().collect::<Vec<_>>()));
        reversed["weights"] = json!([1.3, 0.7, weight, 1.0]);
        Twins { name: format!("peak {member} of {weight:e}"), objects: [object, reversed], factor: 1.0 }
    };
    [1e-12, 1e-6, 1e3, 1e6, 1e8, 1e10, 1e15, 1e20, 1e100, 1e308].map(twins).into()
}

fn document(objects: &[(String, Value)]) -> String {
    let mut text = String::from("{\"cyclide\": 1, \"objects\": {");
    for (i, (name, object)) in objects.iter().enumerate() {
        write!(text, "{}\"{name}\": {object}", if i > 0 { ", " } else { "" }).unwrap();
    }
    text + "}}"
}

/// What is said of an object by one command: its length, or the word of the refusal.
type Said = Result<f64, String>;

/// The lengths of all objects by one command, or the reason why one was refused.
fn lengths(command: &str, objects: &[(String, Value)]) -> Vec<Said> {
    let folder = Folder::with(&[("m.json", &document(objects))]);
    let (arguments, one) = match command {
        "report" => ("report m.json --json".to_owned(), false),
        "build" => ("build m.json -o m.out.json --json".to_owned(), false),
        _ => (format!("sample m.json --object {} --count 3 --json", objects[0].0), true),
    };
    let run = folder.run(&arguments);
    if run.code != 0 {
        assert!(run.code == 1 && run.stderr.contains('['), "{arguments}: exit {}\n{}", run.code, run.stderr);
        if objects.len() == 1 {
            let line = run.stderr.lines().next().unwrap_or_default();
            let reason = line.rsplit_once('[').map_or("", |(_, word)| word.trim_end_matches(']'));
            return vec![Err(reason.to_owned())];
        }
        // One of them: each for itself.
        return objects.iter().flat_map(|object| lengths(command, std::slice::from_ref(object))).collect();
    }
    let found: Value = serde_json::from_str(&run.stdout).unwrap();
    let length = |name: &str| {
        let length = if one { &found["contours"][0]["length"] } else { &found["objects"][name]["length"] };
        Ok(length.as_f64().unwrap_or(f64::NAN))
    };
    objects.iter().map(|(name, _)| length(name)).collect()
}

/// Both of each pair have the same length, or one of them is refused by a word that is allowed.
fn check(twins: &[Twins], commands: &[&str], allowed: &[&str]) {
    let objects: Vec<(String, Value)> = twins
        .iter()
        .enumerate()
        .flat_map(|(i, twins)| {
            [("a", &twins.objects[0]), ("b", &twins.objects[1])].map(|(k, o)| (format!("{k}{i}"), o.clone()))
        })
        .collect();
    for command in commands {
        let said: Vec<Said> = if *command == "sample" {
            objects.iter().flat_map(|object| lengths(command, std::slice::from_ref(object))).collect()
        } else {
            lengths(command, &objects)
        };
        for (twins, said) in twins.iter().zip(said.chunks(2)) {
            match (&said[0], &said[1]) {
                (Ok(a), Ok(b)) => {
                    let b = b / twins.factor;
                    assert!((a - b).abs() <= AGREEMENT * a, "{command}, {}: {a} and {b}", twins.name);
                }
                (_, Err(reason)) | (Err(reason), _) => {
                    assert!(allowed.contains(&reason.as_str()), "{command}, {}: {said:?}", twins.name);
                }
            }
        }
    }
}

#[test]
fn curves_through_points_are_the_same_scaled_reversed_and_turned() {
    let mut random = Random(37);
    let twins: Vec<Twins> = (0..24).flat_map(|member| through_points(&mut random, member)).collect();
    check(&twins, &["report"], &[]);
    let few: Vec<Twins> = twins.into_iter().step_by(97).collect();
    check(&few, &["sample", "build"], &[]);
}

#[test]
fn rational_splines_are_the_same_by_other_weights_knots_and_scales() {
    let mut random = Random(41);
    let twins: Vec<Twins> = (0..20).flat_map(|member| nurbs(&mut random, member)).collect();
    check(&twins, &["report"], &[]);
    let few: Vec<Twins> = twins.into_iter().step_by(101).collect();
    check(&few, &["sample", "build"], &[]);
}

#[test]
fn weights_that_only_change_the_parameter_change_no_figure() {
    let mut random = Random(43);
    let twins: Vec<Twins> = (0..30).flat_map(|member| reparametrized(&mut random, member)).collect();
    check(&twins, &["report"], &["weights-uneven"]);
    let few: Vec<Twins> = twins.into_iter().step_by(67).collect();
    check(&few, &["sample", "build"], &["weights-uneven"]);
}

#[test]
fn a_weight_far_above_the_others_is_measured_or_refused() {
    let mut random = Random(47);
    let twins: Vec<Twins> = (0..20).flat_map(|member| peaked(&mut random, member)).collect();
    check(&twins, &["report"], &["weights-uneven"]);
    // Not everything is refused.
    let kept = |twins: &Twins| ["e-12", "e-6", "e3", "e6", "e8"].iter().any(|weight| twins.name.ends_with(weight));
    let kept: Vec<Twins> = twins.into_iter().filter(kept).collect();
    check(&kept, &["report"], &[]);
}

/// The length of the parabola over `[0, 2]` with its vertex at (1, 1/2): sqrt 2 + ln(1 + sqrt 2).
#[test]
fn a_parabola_has_its_length_by_any_weights_or_is_refused() {
    let parabola = std::f64::consts::SQRT_2 + 1.0_f64.asinh();
    let folder = Folder::with(&[("m.json", &case("nurbs-moebius-weights.json"))]);
    let found: Value = serde_json::from_str(&folder.ok("report m.json --json")).unwrap();
    let length = found["objects"]["a"]["length"].as_f64().unwrap();
    assert!((length - parabola).abs() < 1e-12 * parabola, "{length}");
    let samples = folder.ok("sample m.json --object a --count 3 --equal-length");
    let middle: Vec<f64> = samples.lines().nth(2).unwrap().split(',').take(4).map(|v| v.parse().unwrap()).collect();
    assert!((middle[1] - 1.0).abs() < 1e-9 && (middle[2] - 0.5).abs() < 1e-12, "{middle:?}");
    for (file, word) in [
        ("min-nurbs-weight-1e308.json", "weights-uneven"),
        ("nurbs-1e308.json", "parameter-out-of-range"),
        ("nurbs-weight-1e100.json", "weights-uneven"),
    ] {
        let folder = Folder::with(&[("m.json", &case(file))]);
        for command in ["report m.json", "sample m.json --object a --count 9", "build m.json -o m.step"] {
            let run = folder.run(command);
            assert!(run.code == 1 && run.stderr.contains(&format!("[{word}]")), "{file}, {command}: {}", run.stderr);
        }
        assert!(!folder.has("m.step"));
    }
}

/// Every type of object with a starter, and its image under scaling by a power of two: lengths, areas and volumes.
#[test]
fn images_of_every_kind_have_its_figures() {
    let folder = Folder::with(&[]);
    let list = folder.ok("new");
    let kinds: Vec<&str> = list.lines().filter_map(|line| line.strip_prefix("  ")?.split_whitespace().next()).collect();
    assert!(kinds.len() > 30, "{list}");
    // Those that take long without optimization are measured by laws of their own.
    let slow =
        ["principal-grid", "smooth-mesh", "layers", "pipe-tee", "pipe-crossing", "ball-centers", "center-surface"];
    let mut compared = 0;
    for kind in kinds.into_iter().filter(|kind| !slow.contains(kind)) {
        let mut document: Value = serde_json::from_str(&folder.ok(&format!("new {kind}"))).unwrap();
        let objects = document["objects"].as_object().unwrap().clone();
        let moved = |object: &Value| ["motion", "trajectory"].iter().any(|kind| object["type"] == **kind);
        let factors = [2_f64.powi(40)];
        for (name, _) in objects.iter().filter(|(_, object)| !moved(object)) {
            for (i, factor) in factors.iter().enumerate() {
                document["objects"][format!("{name}-{i}")] =
                    json!({"type": "transform", "of": name, "steps": [{"scale": {"factor": factor}}]});
            }
        }
        folder.write("k.json", &document.to_string());
        let run = folder.run("report k.json --json");
        // A starter may name a file that is not here.
        if run.code != 0 {
            continue;
        }
        let found: Value = serde_json::from_str(&run.stdout).unwrap();
        for name in objects.keys() {
            for (i, factor) in factors.iter().enumerate() {
                for (figure, power) in [("length", 1), ("area", 2), ("volume", 3)] {
                    let of = |name: &str| found["objects"][name][figure].as_f64();
                    if let (Some(a), Some(b)) = (of(name), of(&format!("{name}-{i}"))) {
                        let b = b / factor.powi(power);
                        assert!((a - b).abs() <= AGREEMENT * a.abs(), "{kind} {name}, {figure}: {a} and {b}");
                        compared += 1;
                    }
                }
            }
        }
    }
    assert!(compared > 25, "{compared}");
}

/// A bend that an inversion makes smaller than the rounding of its place is gone: straight chains included.
#[test]
fn chains_below_the_rounding_of_their_place_are_refused() {
    let folder = Folder::with(&[("m.json", &case("lost-shape-inversion.json"))]);
    for command in ["report m.json", "build m.json -o m.step", "sample m.json --object w --count 5"] {
        let run = folder.run(command);
        assert!(run.code == 1 && run.stderr.contains("[below-rounding-of-place]"), "{command}: {}", run.stderr);
    }
    let mut random = Random(53);
    for member in 0..20 {
        let radius = if member % 2 == 0 { 0.0 } else { 5.0 };
        let place = 1e6 * random.between(1.0, 9.0);
        let chain = json!({"type": "polyline", "points": [[0, 0, 1], [random.between(50.0, 90.0), 0, 0], [60, 80, 0]],
            "radius": radius, "construction": true});
        let steps = json!([{"inversion": {"center": [place, 1, -1], "radius": 1e-3}}]);
        let objects = [
            ("a".to_owned(), chain.clone()),
            ("w".to_owned(), json!({"type": "transform", "of": "a", "steps": steps})),
        ];
        folder.write("m.json", &document(&objects));
        let run = folder.run("report m.json");
        assert!(run.code == 1 && run.stderr.contains("[below-rounding-of-place]"), "{member}: {}", run.stderr);
        // Moved as far, with its size, it is as right as before.
        let steps = json!([{"translation": [place, 1, -1]}]);
        let objects =
            [("a".to_owned(), chain), ("w".to_owned(), json!({"type": "transform", "of": "a", "steps": steps}))];
        folder.write("m.json", &document(&objects));
        folder.ok("report m.json");
    }
}
