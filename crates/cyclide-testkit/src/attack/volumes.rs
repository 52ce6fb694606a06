//! Blocks of random corners and frames, their images, and layers over patches and cyclides; mostly such as somebody would make.

use super::{Objects, Random};
use serde_json::{Value, json};

pub(super) fn block(random: &mut Random) -> Objects {
    Objects::surface(cyclide_volume(random))
}

pub(super) fn layers(random: &mut Random) -> Objects {
    let a = random.decades(-2.0, 3.0);
    let (c, mu) = (a * random.between(0.0, 0.9), a * random.between(0.05, 1.1));
    let base =
        json!({"type": "cyclide", "a": a, "c": c, "mu": mu, "segments": [3 + random.below(4), 3 + random.below(4)]});
    let mut object = json!({"type": "layers", "of": "a"});
    if random.chance(0.5) {
        object["first"] = json!(a * random.decades(-5.0, 0.0) * random.pick(&[-1.0, 1.0]));
        object["count"] = json!(1 + random.below(4));
        if random.chance(0.7) {
            object["growth"] = json!(random.between(0.5, 2.0));
        }
    } else {
        let mut distances: Vec<f64> = (0..2 + random.below(3)).map(|_| a * random.normal() * 0.3).collect();
        if random.chance(0.9) {
            distances.sort_by(f64::total_cmp);
        }
        object["distances"] = json!(distances);
    }
    Objects::derived(Objects::surface(base), "b", object, true)
}

/// Surfaces inside a block, and its images.
pub(super) fn derived(random: &mut Random) -> Objects {
    let base = Objects::surface(cyclide_volume(random));
    let mut values = || (0..random.below(3)).map(|_| random.pick(&[0.0, 0.5, 1.0, 0.3])).collect::<Vec<f64>>();
    let object = json!({"type": "coordinate-surfaces", "of": "a", "s": values(), "t": values(), "u": values()});
    if random.chance(0.5) {
        return Objects::derived(base, "b", object, true);
    }
    let centre = [random.number(), random.number(), random.number()];
    let steps = json!([{"inversion": {"center": centre, "radius": random.decades(-2.0, 2.0)}}]);
    Objects::derived(base, "b", json!({"type": "transform", "of": "a", "steps": steps}), true)
}

fn cyclide_volume(random: &mut Random) -> Value {
    let scale = if random.chance(0.3) { random.decades(-9.0, 9.0) } else { 1.0 };
    let noise = random.pick(&[0.0, 0.1, 0.3, 1.0]);
    let place = [random.number(), random.number(), random.number()];
    let mut corner = |at: [f64; 3]| [0, 1, 2].map(|i| scale * (place[i] + at[i] + noise * random.normal()));
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(&mut corner);
    let mut object = json!({"type": "cyclide-volume", "corners": corners});
    if random.chance(0.5) {
        let inside = [0.0; 3].map(|_: f64| random.decades(-3.0, 3.0));
        object["inside"] = json!(inside);
    }
    if random.chance(0.5) {
        object["turn"] = json!(random.pick(&[0.0, 1.0, 0.5, 0.2]));
    }
    if random.chance(0.3) {
        let (u, v) = (random.vector(), random.vector());
        let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let part = dot(&u, &v) / dot(&u, &u);
        let across = [0, 1, 2].map(|i| v[i] - part * u[i]);
        object["frame"] = json!([u, across]);
    }
    object
}
