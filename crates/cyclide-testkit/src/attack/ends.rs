//! Ends that nearly touch: open curves that come back to their start up to very little, and biarcs between points that
//! are nearly one.

use super::objects::through;
use super::points::list;
use super::{Objects, Random};
use serde_json::json;

pub(super) fn object(random: &mut Random) -> Objects {
    if random.chance(0.3) {
        return biarc(random);
    }
    let count = 3 + random.below(6);
    let mut points = list(random, count);
    let e = match random.below(3) {
        0 => 0.0,
        1 => random.decades(-16.0, -7.0),
        _ => random.decades(-9.0, -2.0),
    };
    let first = points[0];
    points.push(first.map(|v| v + e * random.normal()));
    through(random, points)
}

fn biarc(random: &mut Random) -> Objects {
    let (from, e) = ([random.number(), random.number(), random.number()], random.decades(-12.0, 0.0));
    let toward = random.vector();
    let to = [0, 1, 2].map(|i| from[i] + e * toward[i]);
    let level = random.chance(0.5);
    let mut direction = || {
        let v = random.vector();
        if level { [v[0], v[1], 0.0] } else { v }
    };
    let (a, b) = (direction(), direction());
    Objects::curve(json!({"type": "biarc", "from": from, "from_tangent": a, "to": to, "to_tangent": b}))
}
