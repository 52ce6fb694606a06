//! Necks of pipes of any lean and size, bridges of ellipses of any shape, arcs and lines between two curves of any kind.

use super::points;
use super::{Objects, Random, objects};
use serde_json::{Value, json};

/// Mostly such as somebody would make, some out of all proportion.
pub(super) fn neck(random: &mut Random) -> Objects {
    let scale = if random.chance(0.2) { random.decades(-12.0, 9.0) } else { 1.0 };
    let wild = random.chance(0.25);
    let length = |random: &mut Random, from: f64, to: f64| {
        scale * if wild { random.decades(-8.0, 4.0) } else { random.between(from, to) }
    };
    let pipe = length(random, 2.0, 10.0);
    let inside = random.chance(0.3);
    let mut object = json!({
        "type": "plate-with-neck",
        "pipe_radius": pipe,
        "ball_radius": if wild { length(random, 0.0, 1.0) } else { pipe * random.between(0.01, 1.1) },
        "height": length(random, 10.0, 80.0),
    });
    if random.chance(0.7) {
        let most = if random.chance(0.2) { 1.58 } else { 1.0 };
        object["slope"] = json!(random.between(-most, most));
    }
    if inside {
        object["side"] = json!("inside");
    } else if random.chance(0.5) {
        object["plate"] = json!([length(random, 30.0, 120.0), length(random, 30.0, 120.0)]);
    } else {
        object["plate"] = json!({"radius": length(random, 20.0, 80.0)});
    }
    if random.chance(0.3) {
        object["variant"] = json!("vertical");
    }
    if random.chance(0.7) {
        object["thickness"] = json!(length(random, 0.1, 8.0));
        if random.chance(0.6) {
            object["wall"] = json!(length(random, 0.1, 3.0));
        }
    }
    Objects::surface(object)
}

pub(super) fn bridge(random: &mut Random) -> Objects {
    let scale = if random.chance(0.3) { random.decades(-12.0, 9.0) } else { 1.0 };
    let mut axis = |apart: f64| scale * if apart > 0.9 { random.decades(-6.0, 5.0) } else { random.between(0.5, 20.0) };
    let first = [axis(0.0), axis(0.95)];
    let second = match random.below(4) {
        0 => [first[0] * 2.0, first[1] * 2.0],
        1 => [first[0] * (1.0 + random.decades(-13.0, -1.0)), first[1] * 1.5],
        2 => [first[0] + scale, first[1] + scale],
        _ => [scale * random.between(0.5, 30.0), scale * random.between(0.5, 30.0)],
    };
    let mut object = json!({"type": "ellipse-bridge", "ellipses": [first, second]});
    if random.chance(0.6) {
        object["depth"] = json!(scale * random.decades(-6.0, 3.0));
    }
    // Where they cross or turn over does not depend on the tolerance: with the default one narrow bridges have much to mesh.
    let size = first.into_iter().chain(second).fold(0.0, f64::max);
    Objects { tolerance: random.chance(0.7).then_some(0.02 * size), ..Objects::surface(object) }
}

/// Between a curve and its image, which has as many pieces, or another curve.
pub(super) fn between_rails(random: &mut Random) -> Objects {
    let base = if random.chance(0.3) { objects::single(random) } else { points::object(random) };
    let away = random.decades(-3.0, 3.0);
    let way = random.vector().map(|v| away * v);
    let mut steps = vec![json!({"translation": way})];
    if random.chance(0.4) {
        steps.push(json!({"rotation": {"axis": random.vector(), "angle": random.between(-3.0, 3.0)}}));
    }
    let image = json!({"type": "transform", "of": "a", "steps": steps});
    let other = if random.chance(0.15) {
        json!({"type": "arc", "through": [way, random.vector(), random.vector()]})
    } else {
        image
    };
    let both = Objects::derived(base, "b", other, false);
    let surface = if random.chance(0.5) {
        json!({"type": "ruled", "rails": ["a", "b"]})
    } else {
        let tangent: Value = if random.chance(0.8) {
            json!(random.vector())
        } else {
            json!((0..2 + random.below(3)).map(|_| random.vector()).collect::<Vec<_>>())
        };
        json!({"type": "circular-surface", "rails": ["a", "b"], "tangent": tangent})
    };
    Objects::derived(both, "c", surface, true)
}
