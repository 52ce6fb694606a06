//! Tubes of changing radius along curves of every kind, and through balls of all sizes, nested, touching, turning back.

use super::points;
use super::{Objects, Random, objects};
use serde_json::{Value, json};

pub(super) fn surface(random: &mut Random) -> Objects {
    let mut object = json!({"type": "tube"});
    if random.chance(0.3) {
        object["wall"] = json!(random.decades(-4.0, 0.0));
    }
    if random.chance(0.5) {
        object["ends"] = json!(["flat", "round", "open"][random.below(3)]);
    }
    if random.chance(0.4) {
        object["balls"] = balls(random);
        if random.chance(0.4) {
            object["closed"] = json!(true);
        }
        return Objects::surface(object);
    }
    let base = match random.below(3) {
        0 => points::object(random),
        _ => objects::single(random),
    };
    object["of"] = json!("a");
    let size = random.decades(-3.0, 0.0);
    object["radius"] = match random.below(3) {
        0 => json!(size),
        1 => json!((0..1 + random.below(5)).map(|_| size * random.between(0.5, 2.0)).collect::<Vec<f64>>()),
        _ => {
            let count = 1 + random.below(5);
            let at = |k: usize| (k as f64 + random.between(0.0, 0.9)) / count as f64;
            let places: Vec<f64> = (0..count).map(at).collect();
            json!(
                places
                    .into_iter()
                    .map(|at| json!({"at": at, "radius": size * random.between(0.5, 2.0)}))
                    .collect::<Vec<Value>>()
            )
        }
    };
    object["tolerance"] = json!(size * random.decades(-3.0, 0.0));
    Objects::derived(base, "b", object, true)
}

/// A walk with steps and radii of one size or of many.
fn balls(random: &mut Random) -> Value {
    let (wild, scale) = (random.chance(0.3), if random.chance(0.2) { random.decades(-9.0, 9.0) } else { 1.0 });
    let mut at = [0.0; 3];
    let count = 2 + random.below(8);
    let mut made = Vec::new();
    for _ in 0..count {
        let radius = if wild { random.decades(-6.0, 1.0) } else { random.between(0.5, 1.5) };
        made.push([at[0], at[1], at[2], radius].map(|v| v * scale));
        let step = random.vector();
        let ahead = if wild { 0.0 } else { 4.0 };
        at = [at[0] + ahead + 2.0 * step[0], at[1] + 2.0 * step[1], at[2] + 2.0 * step[2]];
    }
    json!(made)
}
