//! Rational B-splines of other programs: all degrees, knots clamped or not, repeated and crowded, wild weights, control points that
//! coincide; mapped now and then.

use super::points::list;
use super::{Objects, Random, inversions, maps};
use serde_json::{Value, json};

pub(super) fn curve(random: &mut Random) -> Objects {
    let base = Objects::curve(spline(random));
    if random.chance(0.5) {
        return base;
    }
    let steps = if random.chance(0.5) {
        inversions::steps(random, &base)
    } else {
        (0..=random.below(2)).map(|_| maps::step(random)).collect()
    };
    Objects::derived(base, "b", json!({"type": "transform", "of": "a", "steps": steps}), false)
}

fn spline(random: &mut Random) -> Value {
    let degree = if random.chance(0.1) { 1 + random.below(25) } else { 1 + random.below(4) };
    let count = degree + 1 + random.below(8);
    let mut points = list(random, count);
    if random.chance(0.2) {
        // A corner, a cusp, or a span without extent.
        let at = random.below(count);
        let repeated = points[at];
        points.iter_mut().skip(at).take(1 + random.below(degree + 1)).for_each(|p| *p = repeated);
    }
    if random.chance(0.2) {
        points[count - 1] = points[0];
    }
    let mut object =
        json!({"type": "nurbs", "degree": degree, "knots": knots(random, degree, count), "control_points": points});
    if random.chance(0.5) {
        let spread = random.pick(&[0.1, 1.0, 6.0]);
        object["weights"] = json!((0..count).map(|_| random.decades(-spread, spread)).collect::<Vec<_>>());
    }
    object
}

/// Knots, valid nearly always.
fn knots(random: &mut Random, degree: usize, count: usize) -> Vec<f64> {
    let step = |random: &mut Random| match random.below(10) {
        0..3 => 0.0,
        3..8 => 1.0,
        _ => random.decades(-9.0, 3.0),
    };
    let mut steps: Vec<f64> = (0..count + degree + 1).map(|_| step(random)).collect();
    if random.chance(0.8) {
        steps[..=degree].fill(0.0);
        steps[count + 1..].fill(0.0);
    }
    let start = if random.chance(0.5) { 0.0 } else { random.number() };
    let mut at = start;
    let mut knots: Vec<f64> = steps
        .into_iter()
        .map(|step| {
            at += step;
            at
        })
        .collect();
    if random.chance(0.02) {
        knots.swap(0, count);
    }
    knots
}
