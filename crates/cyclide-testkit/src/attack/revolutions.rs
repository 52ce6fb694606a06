//! Curves of every kind turned about axes near them and far away, by any angle.

use super::points;
use super::{Objects, Random, objects};
use serde_json::json;

pub(super) fn surface(random: &mut Random) -> Objects {
    let base = if random.chance(0.4) { objects::single(random) } else { points::object(random) };
    let mut object = json!({"type": "revolution", "of": "a"});
    if random.chance(0.6) {
        let far = random.decades(-3.0, 4.0);
        object["center"] = json!(random.vector().map(|v| far * v));
    }
    if random.chance(0.6) {
        object["axis"] = json!(random.vector());
    }
    if random.chance(0.4) {
        object["angle"] = json!(random.between(-6.5, 6.5));
    }
    Objects::derived(base, "b", object, true)
}
