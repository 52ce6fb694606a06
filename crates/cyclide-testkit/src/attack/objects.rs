//! Objects of every curve type, with random options.

use super::points::Points;
use super::{Objects, Random};
use serde_json::{Value, json};

/// A curve of any type through or near points.
pub(super) fn through(random: &mut Random, points: Points) -> Objects {
    let word = random.pick(&["circle-spline", "circle-spline", "arc-spline", "fair-spline", "fair-fit", "arc-fit"]);
    Objects::curve(of_type(random, word, points))
}

/// A curve of one type.
pub(super) fn of_type(random: &mut Random, word: &str, points: Points) -> Value {
    let spread = |i: usize| points.iter().map(|p| (p[i] - points[0][i]).abs()).fold(0.0, f64::max);
    let size = [0, 1, 2].map(spread).into_iter().fold(0.0, f64::max);
    let size = if size > 0.0 { size } else { 1.0 };
    let planar = points.iter().all(|p| p[2] == 0.0);
    let list: Vec<Value> = points.iter().map(|p| if planar { json!([p[0], p[1]]) } else { json!(p) }).collect();
    let mut object = json!({"type": word, "points": list});
    if random.chance(0.4) {
        object["closed"] = json!(true);
    }
    if random.chance(0.2) && word != "arc-spline" {
        object["corner_angle"] = json!(random.pick(&[0.3, 0.8, 1.5, 3.0]));
    }
    match word {
        "circle-spline" => {
            if random.chance(0.7) {
                object["order"] = json!(1 + random.below(4));
            }
            if random.chance(0.4) {
                object["variant"] = json!("trigonometric");
            }
        }
        "fair-spline" if random.chance(0.3) => {
            object["tension"] = json!(random.pick(&[0.0, 1.0, 0.5, 1e-9]));
        }
        "fair-fit" | "arc-fit" => {
            let power = if random.chance(0.2) { random.between(-12.0, 2.0) } else { random.between(-4.0, -1.0) };
            object["tolerance"] = json!(size * 10.0_f64.powf(power));
            if word == "fair-fit" && random.chance(0.3) {
                object["centre"] = json!(random.pick(&[0.1, 1.0, 10.0]));
            }
        }
        _ => {}
    }
    object
}

/// Curves that are given without a list of points.
pub(super) fn single(random: &mut Random) -> Objects {
    let planar = random.chance(0.5);
    let mut point = || {
        let p = [random.number(), random.number(), random.number()];
        if planar { [p[0], p[1], 0.0] } else { p }
    };
    let (a, b, c) = (point(), point(), point());
    Objects::curve(match random.below(6) {
        0 => json!({"type": "arc", "through": [a, b, c]}),
        1 => {
            let bulge = match random.below(3) {
                0 => random.normal(),
                1 => random.decades(-12.0, 8.0),
                _ => -random.decades(-3.0, 7.0),
            };
            json!({"type": "arc", "from": a, "to": b, "bulge": bulge, "normal": random.vector()})
        }
        2 => json!({"type": "arc", "from": a, "to": b, "tangent": c}),
        3 => json!({"type": "circle", "through": [a, b, c]}),
        4 => {
            let radius = random.decades(-6.0, 6.0);
            json!({"type": "circle", "center": a, "radius": radius, "normal": random.vector()})
        }
        _ => {
            let rule = random.pick(&["auto", "equal-d", "equal-chord"]);
            json!({"type": "biarc", "from": a, "from_tangent": c, "to": b, "to_tangent": random.vector(), "rule": rule})
        }
    })
}
