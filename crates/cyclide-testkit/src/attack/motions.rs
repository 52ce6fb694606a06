//! Motions through poses of all sizes, turns and times, and what is made of them: paths, and what curves run over.

use super::points;
use super::{Objects, Random, objects};
use serde_json::{Value, json};

/// The path of a point.
pub(super) fn trajectory(random: &mut Random) -> Objects {
    let moving = random.chance(0.3);
    let object = json!({"type": "trajectory", "of": "m", "point": vector(random, 1.0)});
    with_motion(random, Objects::curve(json!(null)), object, moving)
}

/// What a curve runs over.
pub(super) fn swept(random: &mut Random) -> Objects {
    let profile = if random.chance(0.5) { objects::single(random) } else { points::object(random) };
    let object = json!({"type": "swept-surface", "of": "m", "profile": "a"});
    let mut made = with_motion(random, profile, object, false);
    made.has_surfaces = true;
    // Surfaces of spans that turn far are large for their tolerance.
    made.tolerance = Some(random.decades(-3.0, -1.0));
    made
}

/// The object behind a motion `m` and, where it has one, its profile `a`; the motion is written too, or construction geometry.
fn with_motion(random: &mut Random, base: Objects, object: Value, written: bool) -> Objects {
    let mut motion = motion(random);
    motion["construction"] = json!(!written);
    let mut named: Vec<(&'static str, Value)> =
        base.objects.into_iter().filter(|(_, value)| !value.is_null()).collect();
    named.iter_mut().for_each(|(_, value)| value["construction"] = json!(true));
    named.push(("m", motion));
    named.push(("o", object));
    Objects { objects: named, has_surfaces: false, area: None, tolerance: base.tolerance }
}

fn motion(random: &mut Random) -> Value {
    let kind = ["spline", "spline", "spline", "conic", "quartic", "cubic", "sclerp"][random.below(7)];
    let count = match kind {
        "conic" => 3,
        "cubic" => 4,
        "quartic" => 5,
        _ => 2 + random.below(6),
    };
    let size = random.decades(-3.0, 3.0);
    let timed = random.chance(0.5);
    let poses: Vec<Value> = (0..count)
        .map(|k| {
            let mut pose = json!({"position": vector(random, size)});
            match random.below(4) {
                0 => {}
                1 => pose["rpy"] = vector(random, 6.0),
                _ => pose["quaternion"] = json!((0..4).map(|_| random.between(-1.0, 1.0)).collect::<Vec<f64>>()),
            }
            if timed {
                pose["time"] = json!(k as f64 + random.between(-0.4, 0.4));
            }
            pose
        })
        .collect();
    let mut object = json!({"type": "motion", "kind": kind, "poses": poses});
    if random.chance(0.4) {
        object["law"] = json!(["constant-speed", "eased"][random.below(2)]);
        object["arm"] = json!(random.decades(-2.0, 2.0));
    }
    if random.chance(0.3) {
        object["duration"] = json!(random.decades(-2.0, 3.0));
    }
    object
}

fn vector(random: &mut Random, size: f64) -> Value {
    json!([random.between(-size, size), random.between(-size, size), random.between(-size, size)])
}
