//! The same points in a table scaled, backwards and from another one on have the same figures by `curve` and `compare`, and a net scaled
//! by `schedule`.

use serde_json::{Value, json};

use super::common::Folder;
use super::invariance::{AGREEMENT, Random};

/// A table of points, and how many times as large it is as the first.
struct Twin {
    name: &'static str,
    points: Vec<[f64; 3]>,
    factor: f64,
}

/// A table of points without a pattern, then its twins.
fn twins(random: &mut Random, member: usize) -> Vec<Twin> {
    let (closed, in_space) = (member % 2 == 1, member % 4 > 1);
    let points = random.points([7, 12, 30][member % 3], closed, in_space);
    let times = |factor: f64| points.iter().map(|p| p.map(|c| c * factor)).collect();
    let powers = [2_f64.powi(-30), 2_f64.powi(40)];
    let mut all = vec![
        Twin { name: "itself", points: points.clone(), factor: 1.0 },
        Twin { name: "reversed", points: points.iter().rev().copied().collect(), factor: 1.0 },
        Twin { name: "small", points: times(powers[0]), factor: powers[0] },
        Twin { name: "large", points: times(powers[1]), factor: powers[1] },
    ];
    if closed {
        let mut turned = points.clone();
        turned.rotate_left(3);
        all.push(Twin { name: "from another point on", points: turned, factor: 1.0 });
    }
    all
}

/// A folder with a twin in a table.
fn folder_of(twin: &Twin) -> Folder {
    let line = |p: &[f64; 3]| format!("{},{},{}\n", p[0], p[1], p[2]);
    Folder::with(&[("p.csv", &twin.points.iter().map(line).collect::<String>())])
}

/// All figures of this name have the same value in all, a length for its scale.
fn check(member: usize, command: &str, twins: &[Twin], lengths: &[Vec<f64>]) {
    for (twin, found) in twins.iter().zip(lengths) {
        assert!(!found.is_empty() && found.len() == lengths[0].len(), "{command}, {member} {}", twin.name);
        for (own, first) in found.iter().zip(&lengths[0]) {
            let own = own / twin.factor;
            assert!((own - first).abs() <= AGREEMENT * first, "{command}, {member} {}: {own} and {first}", twin.name);
        }
    }
}

fn closing(member: usize) -> &'static str {
    if member % 2 == 1 { " --closed" } else { "" }
}

#[test]
fn curves_of_tables_are_the_same_scaled_reversed_and_turned() {
    let mut random = Random(61);
    for member in 0..12 {
        let twins = twins(&mut random, member);
        let folders: Vec<Folder> = twins.iter().map(folder_of).collect();
        let by = |options: &dyn Fn(f64) -> String| {
            let of = |(twin, folder): (&Twin, &Folder)| {
                let options = options(twin.factor);
                let found = folder.json(&format!("curve p.csv{} {options} -o o.json --json", closing(member)));
                let objects = found["objects"].as_object().unwrap().values();
                objects.map(|object| object["length"].as_f64().unwrap()).collect()
            };
            let lengths: Vec<Vec<f64>> = twins.iter().zip(&folders).map(of).collect();
            check(member, &format!("curve {}", options(1.0)), &twins, &lengths);
        };
        by(&|_| String::new());
        by(&|factor| format!("--kind arc-fit --tolerance {}", 0.5 * factor));
        by(&|factor| format!("--smooth {}", 0.5 * factor));
        let kind = ["circle-spline", "moebius-spline", "arc-spline", "fair-spline"][member % 4];
        by(&|_| format!("--kind {kind}"));
    }
}

#[test]
fn comparisons_are_the_same_scaled_reversed_and_turned() {
    let mut random = Random(67);
    for member in 0..4 {
        let twins = twins(&mut random, member);
        let of = |twin: &Twin| {
            let folder = folder_of(twin);
            let tolerance = 0.5 * twin.factor;
            folder.ok(&format!("compare p.csv{} --tolerance {tolerance} -o c.json", closing(member)));
            let found: Value = serde_json::from_slice(&folder.read("c.json")).unwrap();
            let kinds = found["kinds"].as_array().unwrap().iter();
            kinds.filter_map(|kind| kind["measures"]["length"].as_f64()).collect()
        };
        let lengths: Vec<Vec<f64>> = twins.iter().map(of).collect();
        assert!(lengths[0].len() > 5, "{lengths:?}");
        check(member, "compare", &twins, &lengths);
    }
}

#[test]
fn schedules_are_the_same_scaled() {
    let mut random = Random(71);
    for member in 0..12 {
        let (a, mu) = (random.between(4.0, 9.0), random.between(0.5, 1.5));
        let c = random.between(0.0, 0.4);
        let sizes = [[8, 6], [12, 9], [5, 16]][member % 3];
        let figures = |factor: f64| {
            let net =
                json!({"type": "cyclide", "a": a * factor, "mu": mu * factor, "c": c * factor, "segments": sizes});
            let folder = Folder::with(&[("m.json", &json!({"cyclide": 1, "objects": {"net": net}}).to_string())]);
            folder.ok(&format!("schedule m.json -o w --thickness {}", 0.05 * factor));
            let found: Value = serde_json::from_slice(&folder.read("w/schedule.json")).unwrap();
            let totals = &found["totals"];
            let counts = ["panels", "moulds", "classes", "nodes", "edges"].map(|name| totals[name].as_u64());
            assert!(counts.iter().all(Option::is_some), "{totals}");
            let [area, edges] = ["area", "edge_length"].map(|name| totals[name].as_f64().unwrap());
            (counts, [area / factor.powi(2), edges / factor])
        };
        let (counts, first) = figures(1.0);
        for factor in [2_f64.powi(-20), 2_f64.powi(30)] {
            let (other, own) = figures(factor);
            assert_eq!(other, counts, "{member}, times {factor}");
            for (own, first) in own.into_iter().zip(first) {
                assert!((own - first).abs() <= AGREEMENT * first, "{member}, times {factor}: {own} and {first}");
            }
        }
    }
}

/// A solid of revolution of a rational curve has the same area and volume by any parameter of the curve.
#[test]
fn revolutions_are_the_same_by_other_parameters() {
    let mut random = Random(73);
    for member in 0..6 {
        let degree = 2 + member % 3;
        // From the axis, outside, and back to it.
        let point = |k: usize, random: &mut Random| {
            let x = if k == 0 || k == degree { 0.0 } else { random.between(15.0, 40.0) };
            [x, 0.0, 10.0 * k as f64]
        };
        let points: Vec<[f64; 3]> = (0..=degree).map(|k| point(k, &mut random)).collect();
        let weights: Vec<f64> = (0..=degree).map(|_| random.between(0.5, 2.0)).collect();
        let knots = [vec![0.0; degree + 1], vec![1.0; degree + 1]].concat();
        let figures = |factor: f64| {
            let weights: Vec<f64> = weights.iter().enumerate().map(|(i, w)| w * factor.powi(i as i32)).collect();
            let curve = json!({"type": "nurbs", "degree": degree, "knots": knots, "control_points": points,
                "weights": weights, "construction": true});
            let objects = json!({"curve": curve, "body": {"type": "revolution", "of": "curve"}});
            let folder = Folder::with(&[("m.json", &json!({"cyclide": 1, "objects": objects}).to_string())]);
            let found = folder.json("report m.json --json");
            ["area", "volume"].map(|figure| found["objects"]["body"][figure].as_f64())
        };
        let first = figures(1.0);
        assert!(first.iter().all(Option::is_some), "{member}: {first:?}");
        for factor in [1e-6, 1e-3, 0.03, 40.0, 1e3, 1e6] {
            for (own, first) in figures(factor).into_iter().zip(first) {
                let (own, first) = (own.unwrap_or(f64::NAN), first.unwrap_or(f64::NAN));
                assert!((own - first).abs() <= 1e-8 * first.abs(), "{member}, by {factor}: {own} and {first}");
            }
        }
    }
}
