//! The runner of reference files can fail: every expected number, flag and word, changed by itself, makes its case fail.
#![allow(clippy::expect_used, reason = "a helper of tests fails by panicking")]

use cyclide_testkit::reference::{Report, run};
use serde_json::{Value, json};

const FILES: [&str; 4] = [
    include_str!("../../cyclide/tests/reference/10-arcs.json"),
    include_str!("../../cyclide/tests/reference/20-cyclides.json"),
    include_str!("../../cyclide/tests/reference/50-blending.json"),
    include_str!("../../cyclide/tests/reference/60-arc-fitting.json"),
];

/// Places of all values below `value` that are neither lists nor objects.
fn leaves(value: &Value, place: &str, found: &mut Vec<String>) {
    match value {
        Value::Array(list) => {
            for (i, inner) in list.iter().enumerate() {
                leaves(inner, &format!("{place}/{i}"), found);
            }
        }
        Value::Object(members) => {
            for (name, inner) in members {
                leaves(inner, &format!("{place}/{name}"), found);
            }
        }
        _ => found.push(place.to_owned()),
    }
}

/// Largest number of a case's input, in absolute value.
fn size(input: &Value) -> f64 {
    let mut places = Vec::new();
    leaves(input, "", &mut places);
    places.iter().filter_map(|p| input.pointer(p)?.as_f64()).fold(1.0, |m: f64, x| m.max(x.abs()))
}

/// The leaf changed far beyond any tolerance; `None` where it is not to be compared: null, information, and the
/// parameters that say where a sample is taken.
fn changed(place: &str, leaf: &Value, size: f64, parameters: usize) -> Option<Value> {
    let parts: Vec<&str> = place.split('/').collect();
    let last = parts.last().copied();
    let listed = matches!(parts[1], "samples" | "t") || parameters > 1 && matches!(parts[1], "normals" | "curvatures");
    let leads = last.and_then(|last| last.parse::<usize>().ok()).is_some_and(|at| at < parameters);
    let parameter = parts.len() == 4 && listed && leads;
    if parameter || parts.last() == Some(&"lambda") || matches!(parts[1], "straight" | "true_segments" | "true_arcs") {
        return None;
    }
    match leaf {
        // A limit instead of a value: made too small.
        Value::Number(x) if parts[1].starts_with("max_") => Some(json!(x.as_f64()? * 1e-12)),
        Value::Number(x) if x.is_u64() => Some(json!(x.as_f64()? + 1.0 + size)),
        Value::Number(x) => Some(json!(x.as_f64()? + 0.1 * (x.as_f64()?.abs() + size))),
        Value::Bool(flag) => Some(json!(!flag)),
        Value::String(word) => Some(json!(format!("not-{word}"))),
        _ => None,
    }
}

fn failed(case: &Value) -> usize {
    let mut report = Report::default();
    let text = json!({"format": "cyclide-reference/1", "cases": [case]}).to_string();
    assert_eq!(run(&text, None, &mut report), Ok(()));
    assert_eq!(report.passed() + report.failed(), 1, "{report}");
    report.failed()
}

/// How many numbers at the start of a sample say where it is taken.
fn parameters_of(construct: &str) -> usize {
    match construct {
        "sphere-polygon" => 3,
        "revolution" | "neck-blend" | "ellipse-bridge" | "sphere-blend" | "blend-patch" => 2,
        name if name.starts_with("cyclide-") => 2,
        _ => 1,
    }
}

#[test]
fn every_expected_value_is_compared() {
    let mut changes = 0;
    for file in FILES {
        let file: Value = serde_json::from_str(file).expect("the copies are JSON");
        for case in file["cases"].as_array().expect("a list of cases") {
            let size = size(&case["input"]);
            let parameters = parameters_of(case["construct"].as_str().unwrap_or_default());
            let mut places = Vec::new();
            leaves(&case["expect"], "", &mut places);
            // Long lists of samples are alike: up to twelve places, spread over all.
            let step = places.len().div_ceil(12).max(1);
            for place in places.iter().step_by(step).chain(places.last()) {
                let leaf = case["expect"].pointer(place).unwrap_or(&Value::Null);
                let Some(new) = changed(place, leaf, size, parameters) else {
                    continue;
                };
                let mut case = case.clone();
                *case["expect"].pointer_mut(place).expect("the place was found above") = new;
                assert_eq!(failed(&case), 1, "{} passes with expect{place} changed", case["id"]);
                changes += 1;
            }
        }
    }
    assert!(changes > 2000, "only {changes} changes tried");
}
