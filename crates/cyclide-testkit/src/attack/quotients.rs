//! Curves of quaternion pairs: few points through which one curve of lowest degree goes, on lines, circles and spheres or nearly, with
//! parameters and derivatives of all sizes; Möbius splines with knots and tangents; and these inverted.

use super::points::Points;
use super::{Objects, Random};
use serde_json::{Value, json};

pub(super) fn curve(random: &mut Random) -> Objects {
    let base = Objects::curve(if random.chance(0.5) { interpolation(random) } else { spline(random) });
    if random.chance(0.6) {
        return base;
    }
    // A center anywhere, now and then on a point.
    let center = match random.chance(0.2) {
        true => base.objects[0].1["points"][0].clone(),
        false => json!(random.vector().map(|v| v * random.decades(-1.0, 2.0))),
    };
    let step = json!({"inversion": {"center": center, "radius": random.decades(-2.0, 2.0)}});
    Objects::derived(base, "b", json!({"type": "transform", "of": "a", "steps": [step]}), false)
}

fn interpolation(random: &mut Random) -> Value {
    let n = 1 + 2 * random.below(5);
    let points = few(random, n);
    let mut object = json!({"type": "qb-interpolation", "points": points});
    match random.below(4) {
        0 => object["parameters"] = json!(random.pick(&["auto", "chord", "centripetal", "uniform"])),
        1 => object["parameters"] = json!(increasing(random, n, true)),
        _ => {}
    }
    if random.chance(0.3) {
        let size = random.decades(-2.0, 2.0);
        // An even number of derivatives keeps the count odd.
        let mut list: Vec<Value> = points.iter().map(|_| json!([])).collect();
        let last = list.len() - 1;
        for k in [0, last] {
            list[k] = json!([random.vector().map(|v| v * size)]);
        }
        object["derivatives"] = json!(list);
    }
    object
}

fn spline(random: &mut Random) -> Value {
    let n = 2 + random.below(9);
    let points = few(random, n);
    let closed = random.chance(0.4);
    let mut object = json!({"type": "moebius-spline", "points": points, "closed": closed});
    if random.chance(0.3) {
        object["continuity"] = json!("g1");
        return object;
    }
    if random.chance(0.3) {
        object["knots"] = json!(increasing(random, n + usize::from(closed), false));
    }
    if random.chance(0.3) {
        let one = |random: &mut Random| match random.chance(0.5) {
            true => json!("free"),
            false => json!(random.vector().map(|v| v * random.decades(-2.0, 2.0))),
        };
        object["tangents"] = json!((0..n).map(|_| one(random)).collect::<Vec<_>>());
    }
    if random.chance(0.2) {
        object["corner_angle"] = json!(random.pick(&[0.5, 1.5, 3.0]));
    }
    object
}

/// Points in space, in a plane, on a line, a circle or a sphere, some of them a little off.
fn few(random: &mut Random, n: usize) -> Points {
    let (kind, size) = (random.below(5), random.decades(-2.0, 3.0));
    let off = if random.chance(0.5) { 0.0 } else { random.decades(-12.0, -1.0) };
    let one = |k: usize, random: &mut Random| {
        let [x, y, z] = random.vector();
        let turn = 5.0 * (k as f64 + 0.3 * x) / n as f64;
        let p = match kind {
            0 => [x, y, z],
            1 => [x, y, 0.0],
            2 => [k as f64 + 0.4 * x, 0.0, 0.0],
            3 => [turn.cos(), turn.sin(), 0.0],
            _ => {
                let length = (x * x + y * y + z * z).sqrt().max(1e-3);
                [x / length, y / length, z / length]
            }
        };
        let [dx, dy, dz] = random.vector();
        [(p[0] + off * dx) * size, (p[1] + off * dy) * size, if kind == 1 { 0.0 } else { (p[2] + off * dz) * size }]
    };
    (0..n).map(|k| one(k, random)).collect()
}

/// Numbers that increase, from 0 to 1 if so wanted.
fn increasing(random: &mut Random, n: usize, to_one: bool) -> Vec<f64> {
    let mut sum = 0.0;
    let mut all = vec![0.0];
    for _ in 1..n {
        sum += random.decades(-2.0, 0.0);
        all.push(sum);
    }
    if to_one && sum > 0.0 {
        all.iter_mut().for_each(|t| *t = (*t / sum).min(1.0));
    }
    all
}
