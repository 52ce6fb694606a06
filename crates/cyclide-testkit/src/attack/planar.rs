//! Surfaces of arcs between two curves of one plane, with the area inside their border: whatever folds back over itself has more.

use super::{Objects, Random};
use serde_json::json;

type Place = [f64; 2];

pub(super) fn surface(random: &mut Random) -> Objects {
    let scale = if random.chance(0.2) { random.decades(-3.0, 3.0) } else { 1.0 };
    let parallel = random.chance(0.5);
    let mut place = || [0, 1].map(|_| scale * random.between(-20.0, 20.0));
    let mut ends = [place(), place(), place(), place()];
    if parallel {
        // A strip: the second curve is the first one moved.
        let way = minus(ends[2], ends[0]);
        ends[3] = [ends[1][0] + way[0], ends[1][1] + way[1]];
    }
    let tangents = match random.below(3) {
        0 => [[random.normal(), random.normal()]; 2],
        1 => [[0, 1].map(|_| random.between(-3.0, 3.0).round()); 2],
        _ => [0, 1].map(|_| [random.normal(), random.normal()]),
    };
    // Bulges of up to a third of a turn, which are not cut.
    let bulge = |random: &mut Random| if random.chance(0.5) { 0.0 } else { random.between(-0.57, 0.57) };
    let bulges = [bulge(random), if parallel && random.chance(0.5) { 0.0 } else { bulge(random) }];
    // In the plane z = 0, or a leaning one.
    let [cos, sin] = if random.chance(0.5) { [0.8, 0.6] } else { [1.0, 0.0] };
    let space = |[x, y]: Place| json!([cos * x, y, sin * x]);
    let curve = |k: usize| {
        let [from, to] = [ends[2 * k], ends[2 * k + 1]];
        let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        let [x, y] = minus(to, from);
        let through = [middle[0] + 0.5 * bulges[k] * y, middle[1] - 0.5 * bulges[k] * x];
        if bulges[k] == 0.0 {
            json!({"type": "polyline", "points": ([from, to].map(space)), "construction": true})
        } else {
            json!({"type": "arc", "through": ([from, through, to].map(space)), "construction": true})
        }
    };
    let one = minus(tangents[0], tangents[1]).iter().all(|x| *x == 0.0);
    let tangent = if one { space(tangents[0]) } else { json!(tangents.map(space)) };
    let mut made = Objects::derived(Objects::curve(curve(0)), "b", curve(1), false);
    made =
        Objects::derived(made, "c", json!({"type": "circular-surface", "rails": ["a", "b"], "tangent": tangent}), true);
    Objects { area: Some(border_area(ends, bulges, tangents)), ..made }
}

/// The area inside two curves and the arcs at their ends.
fn border_area(ends: [Place; 4], bulges: [f64; 2], tangents: [Place; 2]) -> f64 {
    let curve = |k: usize| bulge_area(minus(ends[2 * k + 1], ends[2 * k]), bulges[k]);
    let across = |k: usize| arc_area(minus(ends[2 + k], ends[k]), tangents[k]);
    let corners = [ends[0], ends[1], ends[3], ends[2]];
    let twice: f64 = (0..4).map(|k| cross(corners[k], corners[(k + 1) % 4])).sum();
    (0.5 * twice + curve(0) - curve(1) + across(1) - across(0)).abs()
}

fn minus(a: Place, b: Place) -> Place {
    [a[0] - b[0], a[1] - b[1]]
}

fn cross(a: Place, b: Place) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Between an arc and its chord, positive to the right of the chord, by its bulge.
fn bulge_area(chord: Place, bulge: f64) -> f64 {
    sector(chord, 2.0 * bulge.atan())
}

/// The same by the direction at the start.
fn arc_area(chord: Place, tangent: Place) -> f64 {
    sector(chord, cross(tangent, chord).atan2(tangent[0] * chord[0] + tangent[1] * chord[1]))
}

/// The same by half the angle of the turn, counter-clockwise.
fn sector(chord: Place, half: f64) -> f64 {
    let squared = chord[0].powi(2) + chord[1].powi(2);
    // Series where the quotient has no digits.
    let part = if half.abs() < 1e-3 { 2.0 / 3.0 * half } else { (half - half.sin() * half.cos()) / half.sin().powi(2) };
    0.25 * squared * part
}
