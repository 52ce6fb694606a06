//! Curves on tori of all shapes and places: splines through near and far points with wild directions, knots and turns; torus knots; circles; these
//! laid flat, and seams along them.

use super::{Objects, Random};
use serde_json::{Value, json};
use std::f64::consts::PI;

pub(super) fn curve(random: &mut Random) -> Objects {
    let base = Objects::curve(on_torus(random));
    if random.chance(0.7) {
        return base;
    }
    let mut object = json!({"type": "unrolled", "of": "a", "border": random.chance(0.3)});
    if random.chance(0.5) {
        object["map"] = json!("conformal");
    }
    if random.chance(0.5) {
        object["seam"] = json!([random.between(-4.0, 4.0), random.pick(&[0.0, PI, 1.0, -2.5])]);
    }
    if random.chance(0.3) {
        object["tolerance"] = json!(random.decades(-5.0, 1.0));
    }
    Objects::derived(base, "b", object, false)
}

pub(super) fn seam(random: &mut Random) -> Objects {
    let base = Objects::curve(on_torus(random));
    let height = random.decades(-3.0, 0.5);
    let mut object = json!({
        "type": "torus-seam",
        "of": "a",
        "width": random.decades(-2.0, 1.0),
        "height": [-height * random.between(0.0, 1.0), height],
    });
    if random.chance(0.7) {
        object["tolerance"] = json!(random.decades(-3.0, 0.0));
    }
    Objects::derived(base, "b", object, true)
}

fn on_torus(random: &mut Random) -> Value {
    match random.below(6) {
        0 => knot(random),
        1 => circle(random),
        2 => quartic(random),
        _ => spline(random),
    }
}

/// A torus of any size and thickness, a horn now and then.
fn torus(random: &mut Random) -> Value {
    let major = random.decades(-1.0, 2.0);
    let part = random.pick(&[0.5, 0.1, 0.001, 0.9, 0.999, 1.0]) * random.between(0.8, 1.0);
    let mut torus = json!({"major_radius": major, "minor_radius": major * part});
    if random.chance(0.5) {
        torus["center"] = json!(random.vector().map(|v| v * random.decades(-1.0, 3.0)));
    }
    if random.chance(0.5) {
        torus["axis"] = json!(random.vector());
    }
    torus
}

fn knot(random: &mut Random) -> Value {
    let turns = [0, 1].map(|_| random.below(9) as i32 - 4);
    json!({"type": "torus-knot", "torus": torus(random), "turns": turns, "start": angles(random)})
}

const FAMILIES: [&str; 4] = ["villarceau", "mirror-villarceau", "parallel", "meridian"];

fn quartic(random: &mut Random) -> Value {
    let families = [0, 1].map(|_| random.pick(&FAMILIES));
    let ratio = random.pick(&[1.0, -1.0]) * random.decades(-1.7, 1.7);
    json!({"type": "torus-quartic", "torus": torus(random), "families": families, "ratio": ratio, "start": angles(random)})
}

fn circle(random: &mut Random) -> Value {
    let family = random.pick(&FAMILIES);
    json!({"type": "torus-circle", "torus": torus(random), "family": family, "at": angles(random)})
}

/// Angles, the special ones among them.
fn angles(random: &mut Random) -> [f64; 2] {
    [0, 1].map(|_| if random.chance(0.3) { random.pick(&[0.0, PI, -PI, 0.5 * PI]) } else { random.between(-7.0, 7.0) })
}

fn spline(random: &mut Random) -> Value {
    let (count, closed) = (2 + random.below(6), random.chance(0.6));
    let torus = torus(random);
    let mut object = json!({"type": "torus-spline", "torus": torus, "closed": closed});
    if random.chance(0.2) {
        // Near it, or anywhere: the tolerance decides.
        let size = torus["major_radius"].as_f64().unwrap_or(1.0);
        let points: Vec<[f64; 3]> = (0..count).map(|_| random.vector().map(|v| 1.5 * size * v)).collect();
        object["points"] = json!(points);
        object["tolerance"] = json!(random.pick(&[0.1, 10.0]) * size);
    } else {
        let mut pairs: Vec<[f64; 2]> = (0..count).map(|_| angles(random)).collect();
        if random.chance(0.2) {
            pairs[count - 1] = pairs[0];
        }
        object["angles"] = json!(pairs);
        object["loops"] = json!(random.chance(0.3));
    }
    directions(random, &mut object, count);
    let segments = if closed { count } else { count - 1 };
    if random.chance(0.2) {
        let mut knots = vec![random.between(-2.0, 2.0)];
        (0..segments).for_each(|k| knots.push(knots[k] + random.decades(-3.0, 2.0)));
        object["knots"] = json!(knots);
    }
    match random.below(4) {
        0 if closed => object["winding"] = json!([0, 1].map(|_| random.below(7) as i32 - 3)),
        1 => {
            let turns: Vec<[i32; 2]> = (0..segments).map(|_| [0, 1].map(|_| random.below(3) as i32 - 1)).collect();
            object["winding"] = json!(turns);
        }
        _ => {}
    }
    object
}

/// Velocities of all sizes, some left free.
fn directions(random: &mut Random, object: &mut Value, count: usize) {
    let speed = random.decades(-3.0, 2.0);
    match random.below(3) {
        0 => {
            let one = |random: &mut Random| {
                if random.chance(0.3) { json!("free") } else { json!(random.vector().map(|v| speed * v)) }
            };
            object["tangents"] = json!((0..count).map(|_| one(random)).collect::<Vec<_>>());
        }
        1 => {
            let one = |random: &mut Random| {
                if random.chance(0.3) { json!("free") } else { json!(angles(random).map(|v| speed * v)) }
            };
            object["rates"] = json!((0..count).map(|_| one(random)).collect::<Vec<_>>());
        }
        _ => {}
    }
}
