//! Curves under similarities: turned, mirrored, moved far away, scaled.

use super::points::{self, list};
use super::{Objects, Random, objects};
use serde_json::{Value, json};

pub(super) fn curve(random: &mut Random) -> Objects {
    let base = if random.chance(0.3) { objects::single(random) } else { points::object(random) };
    let steps: Vec<Value> = (0..1 + random.below(3)).map(|_| step(random)).collect();
    Objects::derived(base, "b", json!({"type": "transform", "of": "a", "steps": steps}), false)
}

pub(super) fn step(random: &mut Random) -> Value {
    match random.below(4) {
        0 => {
            let far = random.decades(-3.0, 9.0);
            json!({"translation": random.vector().map(|v| far * v)})
        }
        1 => {
            json!({"rotation": {"angle": random.between(-7.0, 7.0), "axis": random.vector(), "center": random.vector()}})
        }
        2 => json!({"scale": {"factor": random.decades(-6.0, 6.0), "center": random.vector()}}),
        _ => json!({"mirror": {"normal": random.vector(), "origin": random.vector()}}),
    }
}

/// Chains of arcs, which every map keeps.
pub(super) fn arcs(random: &mut Random) -> Objects {
    let count = 3 + random.below(8);
    let points = list(random, count);
    let word = random.pick(&["arc-spline", "arc-fit"]);
    Objects::curve(objects::of_type(random, word, points))
}
