//! Curves of every kind turned about axes near them and far away, by any angle.

use super::points;
use super::{Objects, Random, objects};
use serde_json::json;
use std::f64::consts::TAU;

pub(super) fn surface(random: &mut Random) -> Objects {
    if random.chance(0.4) { section(random) } else { any_curve(random) }
}

/// A part of a turn of a closed contour in a plane with the axis, round a place beside it: from nearly round to spikes and
/// contours that cross themselves or the axis.
fn section(random: &mut Random) -> Objects {
    let scale = if random.chance(0.3) { random.decades(-9.0, 9.0) } else { 1.0 };
    let count = 3 + random.below(10);
    let from_axis = random.between(0.5, 4.0);
    let spikes = random.decades(-3.0, 0.3);
    let jitter = if random.chance(0.3) { 1.0 } else { 0.0 };
    let points: Vec<[f64; 3]> = (0..count)
        .map(|k| {
            let angle = TAU * (k as f64 + jitter * random.normal()) / count as f64;
            let reach = scale * (1.0 + spikes * random.normal()).abs();
            [scale * from_axis + reach * angle.cos(), 0.0, reach * angle.sin()]
        })
        .collect();
    let word = random.pick(&["polyline", "arc-spline", "circle-spline"]);
    let contour = Objects::curve(json!({"type": word, "points": points, "closed": true}));
    let angle = if random.chance(0.2) { random.decades(-8.0, -1.0) } else { random.between(-6.3, 6.3) };
    let solid = Objects::derived(contour, "b", json!({"type": "revolution", "of": "a", "angle": angle}), true);
    // What end faces are does not depend on the mesh; with the default tolerance wild contours have a million triangles.
    Objects { tolerance: Some(0.02 * scale), ..solid }
}

fn any_curve(random: &mut Random) -> Objects {
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
