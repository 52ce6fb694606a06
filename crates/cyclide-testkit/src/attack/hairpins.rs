//! Curves that turn back on themselves: legs that nearly coincide, points that nearly repeat, cusps.

use super::objects::through;
use super::points::{Points, list};
use super::{Objects, Random};

pub(super) fn object(random: &mut Random) -> Objects {
    let points = match random.below(4) {
        0 => legs(random),
        1 => spike(random),
        2 => repeated(random),
        _ => cusp(random),
    };
    through(random, points)
}

/// There and back along a line, a tiny distance beside.
fn legs(random: &mut Random) -> Points {
    let (half, e) = (1 + random.below(5), random.decades(-12.0, -1.0));
    let there = (0..=half).map(|i| [i as f64, 0.0, 0.0]);
    there.chain((0..=half).rev().map(|i| [i as f64, e, 0.0])).collect()
}

/// Few points, one far out between two that are close together.
fn spike(random: &mut Random) -> Points {
    let (far, e) = (random.decades(-1.0, 3.0), random.decades(-9.0, -1.0));
    let mut points = vec![[0.0, 0.0, 0.0], [0.0, far, 0.0], [e, random.between(0.0, 0.5) * far, 0.0]];
    points.extend((0..random.below(3)).map(|i| [1.0 + i as f64, random.normal(), 0.0]));
    points
}

/// Points beside each other at distances down to rounding.
fn repeated(random: &mut Random) -> Points {
    let count = 3 + random.below(6);
    let mut points = Points::new();
    for p in list(random, count) {
        points.push(p);
        if random.chance(0.4) {
            let e = random.decades(-16.0, -3.0);
            points.push(p.map(|v| v + e * random.normal()));
        }
    }
    points
}

fn cusp(random: &mut Random) -> Points {
    let (n, power) = (3 + random.below(6) as i32, random.pick(&[0.5, 1.5, 2.0, 3.0]));
    (-n..=n).map(|i| [f64::from(i.abs()).powf(power), f64::from(i), 0.0]).collect()
}
