//! Convex hulls of points that are nearly flat, nearly in lines, nearly equal, far away, and their rounding.

use super::{Objects, Random};
use serde_json::json;

pub(super) fn surface(random: &mut Random) -> Objects {
    let count = 4 + random.below(20);
    let size = random.decades(-6.0, 6.0);
    let place = if random.chance(0.3) { random.vector().map(|x| x * size * 1e4) } else { [0.0; 3] };
    // Thin in one direction or in two.
    let thin = [1.0, if random.chance(0.2) { random.decades(-8.0, 0.0) } else { 1.0 }];
    let thin = [1.0, thin[1], if random.chance(0.3) { random.decades(-12.0, 0.0) } else { 1.0 }];
    let on_grid = random.chance(0.3);
    let mut points: Vec<[f64; 3]> = Vec::with_capacity(count);
    for _ in 0..count {
        let near = random.chance(0.1).then(|| points.get(random.below(points.len().max(1))).copied()).flatten();
        let point = match near {
            Some(p) => p.map(|x| x + size * random.normal() * random.decades(-16.0, -3.0)),
            None => {
                let of = |random: &mut Random| if on_grid { random.below(4) as f64 } else { random.normal() };
                [0, 1, 2].map(|k| place[k] + size * thin[k] * of(random))
            }
        };
        points.push(point);
    }
    let radius = size * random.decades(-5.0, 3.0);
    let mut object = json!({"type": "smooth-polyhedron", "radius": radius, "points": points});
    if random.chance(0.2) {
        object["flatness"] = json!(size * random.decades(-9.0, -1.0));
    }
    Objects::surface(object)
}
