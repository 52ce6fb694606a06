//! Huge and tiny objects, objects far from the origin, and both.

use super::objects::through;
use super::points::list;
use super::{Objects, Random};

pub(super) fn object(random: &mut Random) -> Objects {
    let count = 3 + random.below(8);
    let mut points = list(random, count);
    let scale = if random.chance(0.4) { random.decades(-150.0, 149.0) } else { random.decades(-9.0, 9.0) };
    let offset = if random.chance(0.5) { random.decades(0.0, 9.0) } else { 0.0 };
    for p in &mut points {
        *p = [(p[0] + offset) * scale, (p[1] - offset) * scale, p[2] * scale];
    }
    if random.chance(0.2) {
        let i = random.below(points.len());
        let factor = random.decades(-8.0, 8.0);
        points[i] = points[i].map(|v| v * factor);
    }
    through(random, points)
}
