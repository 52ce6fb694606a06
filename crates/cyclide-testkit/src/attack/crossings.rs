//! Pipes that pass each other, of all widths and distances; mostly such as somebody would make.

use super::{Objects, Random};
use serde_json::json;

pub(super) fn surface(random: &mut Random) -> Objects {
    let scale = if random.chance(0.15) { random.decades(-9.0, 6.0) } else { 1.0 };
    let wild = random.chance(0.2);
    let first = scale * random.between(5.0, 50.0);
    let second = first * if wild { random.decades(-4.0, 2.0) } else { random.between(0.3, 3.0) };
    let (least, most) = ((first - second).abs(), first + second);
    let distance = least + (most - least) * if wild { random.decades(-9.0, 0.5) } else { random.between(0.15, 1.1) };
    let gap = 0.5 * (distance - most).max(0.0);
    let blend = gap + first.min(second) * if wild { random.decades(-6.0, 1.0) } else { random.between(0.05, 0.5) };
    let ends = |random: &mut Random| {
        let [low, high] =
            [(); 2].map(|()| (first.max(second) + blend) * random.between(if wild { 0.5 } else { 2.0 }, 6.0));
        [-low, high]
    };
    let mut object = json!({
        "type": "pipe-crossing",
        "pipes": [{"radius": first, "ends": ends(random)}, {"radius": second, "ends": ends(random)}],
        "distance": distance,
        "blend": blend,
    });
    if random.chance(0.4) {
        object["wall"] = json!(first.min(second) * random.between(0.01, if wild { 1.1 } else { 0.3 }));
    }
    if random.chance(0.6) {
        object["angle"] =
            json!({"degrees": random.between(if wild { -20.0 } else { 25.0 }, if wild { 200.0 } else { 155.0 })});
    }
    if random.chance(0.3) {
        object["tolerance"] = json!(blend * random.decades(-5.0, 0.0));
    }
    if random.chance(0.3) {
        object["ends"] = json!(["flat", "closed", "open"][random.below(3)]);
    }
    // Cones, most of which reach their ends before their apex.
    if random.chance(0.35) {
        let most = if wild { 1.3 } else { 0.9 };
        for pipe in object["pipes"].as_array_mut().into_iter().flatten() {
            let number = |value: &serde_json::Value| value.as_f64().unwrap_or(0.0);
            let reach = number(&pipe["ends"][1]).max(-number(&pipe["ends"][0]));
            let taper = (number(&pipe["radius"]) / reach).atan() * random.between(-most, most);
            pipe["taper"] = json!(if random.chance(0.3) { 0.0 } else { taper });
        }
    }
    // Finer meshes of long pipes have a million triangles.
    let tolerance = Some(first.max(second) * random.decades(-4.0, -1.0));
    Objects { tolerance, ..Objects::surface(object) }
}
