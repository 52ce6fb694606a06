//! Tees of pipes of all widths, angles and offsets, with blends of every kind; mostly such as somebody would make.

use super::{Objects, Random};
use serde_json::{Value, json};
use std::f64::consts::PI;

pub(super) fn surface(random: &mut Random) -> Objects {
    let scale = if random.chance(0.15) { random.decades(-9.0, 6.0) } else { 1.0 };
    let wild = random.chance(0.2);
    let radius = scale * random.between(5.0, 50.0);
    let count = if random.chance(0.7) { 1 } else { 1 + random.below(3) };
    let branches: Vec<Value> = (0..count).map(|k| branch(random, radius, k, wild)).collect();
    let first = -radius * random.between(3.0, 10.0);
    let last = radius * (random.between(3.0, 10.0) + 8.0 * (count - 1) as f64);
    let mut object =
        json!({"type": "pipe-tee", "main": {"radius": radius, "ends": [first, last]}, "branches": branches});
    if random.chance(0.4) {
        object["wall"] = json!(radius * random.between(0.005, if wild { 1.1 } else { 0.05 }));
    }
    if random.chance(0.3) {
        object["ends"] = json!(["flat", "closed", "open"][random.below(3)]);
    }
    Objects::surface(object)
}

fn branch(random: &mut Random, main: f64, index: usize, wild: bool) -> Value {
    let part = if wild { 1.0 - random.decades(-9.0, 0.0) } else { random.between(0.05, 0.98) };
    let radius = main * part;
    let most = if wild { 1.2 } else { 0.95 };
    let size = if wild { random.decades(-6.0, 1.0) } else { random.between(0.03, 0.4) };
    let blend = match random.below(5) {
        0 => json!({"least": radius * size}),
        1 => json!({"crotch": radius * size * random.between(1.0, 2.0), "flank": radius * size}),
        2 => {
            let values: Vec<Value> = (0..1 + random.below(8))
                .map(|_| json!({"angle": random.between(-PI, PI), "radius": radius * size * random.between(0.8, 1.3)}))
                .collect();
            json!({"values": values})
        }
        3 => json!({"radius": radius * size, "tolerance": radius * size * random.decades(-4.0, 0.0)}),
        _ => json!(radius * size),
    };
    let mut object = json!({"radius": radius, "length": main * random.between(2.0, 8.0), "blend": blend, "at": main * 8.0 * index as f64});
    if random.chance(0.6) {
        object["angle"] = json!(if wild { random.between(-0.1, 3.3) } else { random.between(0.35, 2.8) });
    }
    if random.chance(0.5) {
        object["offset"] = json!((main - radius) * random.between(-most, most));
    }
    if random.chance(0.3) {
        object["taper"] = json!(if wild { random.between(-0.8, 0.8) } else { random.between(-0.2, 0.05) });
    }
    if random.chance(0.4) {
        object["azimuth"] = json!(random.between(-7.0, 7.0));
    }
    object
}
