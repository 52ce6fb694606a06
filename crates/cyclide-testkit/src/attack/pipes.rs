//! Pipes of all widths about polylines with bends of all radii, and about curves of every kind.

use super::points;
use super::{Objects, Random, objects};
use serde_json::{Value, json};

pub(super) fn surface(random: &mut Random) -> Objects {
    let base = match random.below(4) {
        0 => objects::single(random),
        1 => points::object(random),
        _ => Objects::curve(polyline(random)),
    };
    let mut object = json!({"type": "pipe", "of": "a", "radius": random.decades(-3.0, 0.5)});
    if random.chance(0.3) {
        object["wall"] = json!(random.decades(-4.0, 0.0));
    }
    if random.chance(0.5) {
        object["ends"] = json!(["flat", "round", "open"][random.below(3)]);
    }
    if random.chance(0.5) {
        object["tolerance"] = json!(random.decades(-4.0, 0.0));
    }
    Objects::derived(base, "b", object, true)
}

/// Segments with corners of all angles.
fn polyline(random: &mut Random) -> Value {
    let count = 2 + random.below(9);
    let size = random.decades(-3.0, 3.0);
    let flat = random.chance(0.3);
    let points: Vec<[f64; 3]> = (0..count)
        .map(|_| random.vector())
        .map(|[x, y, z]| [x, y, if flat { 0.0 } else { z }].map(|v| 3.0 * size * v))
        .collect();
    let radius = if random.chance(0.3) { 0.0 } else { size * random.decades(-2.0, 0.3) };
    json!({"type": "polyline", "points": points, "closed": random.chance(0.4), "radius": radius})
}
