//! Single patches on four points of a circle, with frames of any tilt, tiny and huge, and surfaces parallel to them.

use super::{Objects, Random};
use serde_json::{Value, json};

pub(super) fn object(random: &mut Random) -> Objects {
    Objects::surface(patch(random))
}

pub(super) fn offset(random: &mut Random) -> Objects {
    let base = Objects::surface(patch(random));
    let distance = random.decades(-6.0, 1.0) * random.pick(&[-1.0, 1.0]);
    let object = json!({"type": "offset", "of": "a", "distance": distance, "thick": random.chance(0.5)});
    Objects::derived(base, "b", object, true)
}

fn patch(random: &mut Random) -> Value {
    let scale = if random.chance(0.3) { random.decades(-16.0, 9.0) } else { 1.0 };
    let mut angles = [0.0; 4].map(|_: f64| random.between(0.0, std::f64::consts::TAU));
    if random.chance(0.8) {
        angles.sort_by(f64::total_cmp);
    }
    if random.chance(0.2) {
        angles[1] = angles[0] + random.decades(-12.0, -1.0);
    }
    // Round the circle the corners come as 0, 1, 3, 2.
    let [a, b, d, c] = angles.map(|t| [scale * t.cos(), scale * t.sin(), 0.0]);
    let (u, v) = (random.vector(), random.vector());
    // Made perpendicular to about the last digit.
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let part = dot(&u, &v) / dot(&u, &u);
    let v = [0, 1, 2].map(|i| v[i] - part * u[i]);
    json!({"type": "cyclide-patch", "corners": [a, b, c, d], "frame": [u, v]})
}
