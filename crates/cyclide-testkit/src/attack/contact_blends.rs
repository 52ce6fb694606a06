//! Tubes blended with spheres and plates, of all widths and directions; mostly such as somebody would make.

use super::{Objects, Random};
use serde_json::json;

pub(super) fn surface(random: &mut Random) -> Objects {
    let scale = if random.chance(0.15) { random.decades(-9.0, 6.0) } else { 1.0 };
    let wild = random.chance(0.2);
    let radius = scale * random.between(3.0, 30.0);
    let size = radius * if wild { random.decades(-2.0, 3.0) } else { random.between(2.2, 6.0) };
    let blend = radius * if wild { random.decades(-6.0, 2.0) } else { random.between(0.05, 0.5) };
    let lean = if wild { 3.0 } else { 0.6 };
    let coordinate = |random: &mut Random, most: f64| random.between(-most, most);
    let on_sphere = random.chance(0.5);
    let off = if on_sphere { 0.5 * (size - radius).abs() } else { 0.5 * size };
    let mut tube = json!({"radius": radius, "length": (size + 2.0 * blend + radius) * random.between(if wild { 0.3 } else { 2.0 }, 4.0)});
    if random.chance(0.7) {
        tube["through"] = json!([coordinate(random, off), coordinate(random, off)]);
    }
    if random.chance(0.6) {
        tube["direction"] = json!([coordinate(random, lean), coordinate(random, lean), 1.0]);
    }
    if random.chance(0.5) {
        tube["taper"] = json!(random.between(if wild { -1.6 } else { -0.1 }, if wild { 1.6 } else { 0.05 }));
    }
    let inside = random.chance(0.3);
    let mut object = json!({"type": "contact-blend", "tube": tube, "blend": blend});
    if on_sphere {
        object["sphere"] = json!(size);
    } else if !inside {
        object["plate"] =
            if random.chance(0.5) { json!([6.0 * size, 5.0 * size]) } else { json!({"radius": 4.0 * size}) };
    }
    if inside {
        object["side"] = json!("inside");
    }
    if random.chance(0.4) {
        object["wall"] = json!(radius.min(blend) * random.between(0.01, if wild { 1.1 } else { 0.6 }));
    } else if !on_sphere && !inside && random.chance(0.6) {
        object["thickness"] = json!(radius * random.between(0.1, 1.0));
    }
    if random.chance(0.3) {
        object["tolerance"] = json!(blend * random.decades(-5.0, 0.0));
    }
    if random.chance(0.3) {
        object["ends"] = json!(["flat", "closed", "open"][random.below(3)]);
    }
    let tolerance = Some(radius * random.decades(-3.0, -1.0));
    Objects { tolerance, ..Objects::surface(object) }
}
