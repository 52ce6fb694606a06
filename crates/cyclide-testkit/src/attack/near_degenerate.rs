//! Whole cyclides, ordinary ones and such that nearly degenerate: tubes that nearly close the hole, nearly no tube,
//! nearly tori, spheres and cones, tiny ones far away.

use super::{Objects, Random};
use serde_json::{Value, json};

pub(super) fn cyclide(random: &mut Random) -> Objects {
    Objects::surface(object(random))
}

/// A ring, a horn or a spindle, well away from everything.
pub(super) fn ordinary(random: &mut Random) -> Objects {
    let (a, c) = (random.between(2.0, 4.0), random.between(0.0, 1.0));
    Objects::surface(json!({"type": "cyclide", "a": a, "c": c, "mu": random.between(1.1, 1.8)}))
}

/// The edges of one as arcs.
pub(super) fn support(random: &mut Random) -> Objects {
    let base = Objects::surface(object(random));
    Objects::derived(base, "b", json!({"type": "support-structure", "of": "a"}), false)
}

fn object(random: &mut Random) -> Value {
    let a = if random.chance(0.5) { random.between(1.0, 10.0) } else { random.decades(-15.0, 9.0) };
    // A little away from the limits between the kinds.
    let near = |random: &mut Random, limit: f64| {
        let e = if random.chance(0.5) { random.decades(-16.0, -3.0) } else { 0.0 };
        limit * (1.0 + random.pick(&[-1.0, 1.0]) * e)
    };
    let c = match random.below(4) {
        0 => 0.0,
        1 => a * random.unit(),
        2 => near(random, a),
        _ => a * random.decades(-16.0, 0.0),
    };
    let mu = match random.below(5) {
        0 => near(random, a),
        1 => near(random, c),
        2 => a * random.decades(-12.0, 1.0),
        3 => 0.0,
        _ => a * random.between(0.0, 1.5),
    };
    let mut object = json!({"type": "cyclide", "a": a, "c": c, "mu": mu});
    if random.chance(0.4) {
        let far = random.decades(-3.0, 6.0);
        object["center"] = json!(random.vector().map(|v| far * v));
        object["axis"] = json!(random.vector());
    }
    if random.chance(0.3) {
        object["segments"] = json!([3 + random.below(10), 3 + random.below(10)]);
    }
    object
}
