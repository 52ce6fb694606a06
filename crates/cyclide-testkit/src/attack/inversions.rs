//! Inversions whose sphere passes close to the object, so that parts of it run out towards infinity.

use super::{Objects, Random, maps, near_degenerate, nets, patches};
use serde_json::{Value, json};

pub(super) fn curve(random: &mut Random) -> Objects {
    let base = maps::arcs(random);
    let steps = steps(random, &base);
    Objects::derived(base, "b", json!({"type": "transform", "of": "a", "steps": steps}), false)
}

pub(super) fn surface(random: &mut Random) -> Objects {
    let base = match random.below(3) {
        0 => near_degenerate::ordinary(random),
        1 => patches::object(random),
        _ => nets::object(random),
    };
    let steps = steps(random, &base);
    Objects::derived(base, "b", json!({"type": "transform", "of": "a", "steps": steps}), true)
}

/// One or two inversions, the first about a place near a point of the object where it has points.
pub(super) fn steps(random: &mut Random, base: &Objects) -> Vec<Value> {
    let points = base
        .objects
        .last()
        .and_then(|(_, object)| object.get("points").or(object.get("control_points")))
        .and_then(Value::as_array);
    let near = points.map(|points| points[random.below(points.len())].clone());
    let near = near.and_then(|p| p.as_array().map(|p| p.iter().filter_map(Value::as_f64).collect::<Vec<_>>()));
    let near = near.unwrap_or_else(|| vec![random.normal(), random.normal()]);
    let away = if random.chance(0.3) { random.decades(-9.0, -1.0) } else { random.decades(-1.0, 1.0) };
    let at = |i: usize| near.get(i).copied().unwrap_or(0.0);
    let toward = random.vector();
    let center = [0, 1, 2].map(|i| at(i) + away * toward[i]);
    let mut steps = vec![json!({"inversion": {"center": center, "radius": random.decades(-1.0, 2.0)}})];
    if random.chance(0.3) {
        let center = random.vector().map(|v| 10.0 * v);
        steps.push(json!({"inversion": {"center": center, "radius": random.decades(-1.0, 2.0)}}));
    }
    steps
}
