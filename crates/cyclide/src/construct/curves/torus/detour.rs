//! Ways of arcs and lines in the plane of the torus, for data that no type joins: the shortest of four Dubins paths
//! (`docs/math/torus-splines.md#detours`).
//!
//! Nodes are so dense that all directions of a span are within 45 degrees, which some type covers. Turns and lines too short to
//! matter are left out; what the path then misses is shared among its nodes.

use super::spline_span::Hermite;
use crate::base::planar::Vec2;
use crate::surface::within_a_turn;
use std::f64::consts::{FRAC_PI_6, TAU};

/// Radius of the arcs as part of the step, and at most, radians of the plane.
const RADIUS: [f64; 2] = [0.25, 0.4];

/// Radius where the step is none.
const LOOP_RADIUS: f64 = 0.25;

/// Turns this near none or a whole one, and lines of so few radii, are left out.
const LEFT_OUT: f64 = 1e-3;

/// Paths within this part of their length tie.
const TIE: f64 = 1e-9;

/// Longest line between nodes, radians of the plane.
const LONGEST_LINE: f64 = 1.0;

/// One of the three parts of a path: an arc of a signed turn, or a line of a length.
#[derive(Debug, Clone, Copy)]
enum Part {
    Arc(f64),
    Line(f64),
}

/// A path between two nodes: its chord, length, and direction at its end.
#[derive(Debug, Clone, Copy)]
struct Leg {
    chord: Vec2,
    length: f64,
    direction: Vec2,
}

/// The spans of a detour and their ends as parts of the segment, with the speeds given at both ends and even speed between.
pub(super) fn detour(data: &Hermite) -> Vec<(Hermite, f64)> {
    let [v0, v1] = data.rates;
    let distance = data.step.length();
    let radius = if distance > 0.0 { (RADIUS[0] * distance).min(RADIUS[1]) } else { LOOP_RADIUS };
    let start = v0.y.atan2(v0.x);
    let legs = legs(start, v1.y.atan2(v1.x), data.step, radius);
    let whole: f64 = legs.iter().map(|leg| leg.length).sum();
    let reached = legs.iter().fold(Vec2::default(), |sum, leg| sum + leg.chord);
    let missing = (data.step - reached) * (1.0 / whole);
    let (mut spans, mut place, mut gone) = (Vec::with_capacity(legs.len()), data.start, 0.0);
    let mut rate_per_length = v0 * (1.0 / whole);
    for (k, leg) in legs.iter().enumerate() {
        let step = leg.chord + missing * leg.length;
        let next = if k + 1 == legs.len() { v1 * (1.0 / whole) } else { leg.direction };
        spans.push((Hermite { start: place, step, rates: [rate_per_length * leg.length, next * leg.length] }, {
            gone += leg.length;
            if k + 1 == legs.len() { 1.0 } else { gone / whole }
        }));
        (place, rate_per_length) = (within_a_turn(place + step), next);
    }
    spans
}

/// The legs of the shortest path from the direction `start` to the direction `end` by a step.
fn legs(start: f64, end: f64, step: Vec2, radius: f64) -> Vec<Leg> {
    let parts = shortest(start, end, step, radius);
    let (mut legs, mut heading) = (Vec::new(), start);
    for part in parts {
        match part {
            Part::Arc(turn) if is_left_out(turn) => heading += turn,
            Part::Arc(turn) => append_arc(&mut legs, &mut heading, turn, radius),
            Part::Line(length) if length < LEFT_OUT => {}
            Part::Line(length) => append_line(&mut legs, heading, length * radius),
        }
    }
    // Where both arcs are left out, the line between their ends comes back to its start: there is no step, but there is a loop.
    let turns = parts.iter().any(|part| matches!(part, Part::Arc(turn) if !is_left_out(*turn)));
    if legs.is_empty() || (step.length() == 0.0 && !turns) {
        legs.clear();
        heading = start;
        append_arc(&mut legs, &mut heading, TAU, radius);
    }
    legs
}

fn is_left_out(turn: f64) -> bool {
    turn.abs() < LEFT_OUT || turn.abs() > TAU - LEFT_OUT
}

fn append_arc(legs: &mut Vec<Leg>, heading: &mut f64, turn: f64, radius: f64) {
    let count = (turn.abs() / FRAC_PI_6).ceil().max(1.0);
    let each = turn / count;
    for _ in 0..count as usize {
        let chord = direction(*heading + 0.5 * each) * (2.0 * radius * (0.5 * each.abs()).sin());
        *heading += each;
        legs.push(Leg { chord, length: radius * each.abs(), direction: direction(*heading) });
    }
}

fn append_line(legs: &mut Vec<Leg>, heading: f64, length: f64) {
    let count = (length / LONGEST_LINE).ceil().max(1.0);
    let (each, along) = (length / count, direction(heading));
    legs.extend((0..count as usize).map(|_| Leg { chord: along * each, length: each, direction: along }));
}

fn direction(angle: f64) -> Vec2 {
    let (sin, cos) = angle.sin_cos();
    Vec2::new(cos, sin)
}

/// The shortest of the paths left-line-left, right-line-right, left-line-right, right-line-left, its line in radii (L. E. Dubins, *On
/// curves of minimal length*, 1957).
fn shortest(start: f64, end: f64, step: Vec2, radius: f64) -> [Part; 3] {
    let chord = if step.length() > 0.0 { step.y.atan2(step.x) } else { 0.0 };
    let (d, a, b) = (step.length() / radius, start - chord, end - chord);
    let ((sa, ca), (sb, cb), cab) = (a.sin_cos(), b.sin_cos(), (a - b).cos());
    let turn = |x: f64| x.rem_euclid(TAU);
    let mut all = Vec::with_capacity(4);
    let lsl = (cb - ca).atan2(d + sa - sb);
    let length = |square: f64| square.max(0.0).sqrt();
    all.push([
        Part::Arc(turn(lsl - a)),
        Part::Line(length(2.0 + d * d - 2.0 * cab + 2.0 * d * (sa - sb))),
        Part::Arc(turn(b - lsl)),
    ]);
    let rsr = (ca - cb).atan2(d - sa + sb);
    all.push([
        Part::Arc(-turn(a - rsr)),
        Part::Line(length(2.0 + d * d - 2.0 * cab + 2.0 * d * (sb - sa))),
        Part::Arc(-turn(rsr - b)),
    ]);
    let square = d * d - 2.0 + 2.0 * cab + 2.0 * d * (sa + sb);
    if square >= 0.0 {
        let p = square.sqrt();
        let lsr = (-ca - cb).atan2(d + sa + sb) - (-2.0_f64).atan2(p);
        all.push([Part::Arc(turn(lsr - a)), Part::Line(p), Part::Arc(-turn(lsr - b))]);
    }
    let square = d * d - 2.0 + 2.0 * cab - 2.0 * d * (sa + sb);
    if square >= 0.0 {
        let p = square.sqrt();
        let rsl = (ca + cb).atan2(d - sa - sb) - 2.0_f64.atan2(p);
        all.push([Part::Arc(-turn(a - rsl)), Part::Line(p), Part::Arc(turn(b - rsl))]);
    }
    let size = |parts: &[Part; 3]| -> f64 {
        let of = |part: &Part| match *part {
            Part::Arc(turn) if is_left_out(turn) => 0.0,
            Part::Arc(turn) => turn.abs(),
            Part::Line(length) => length,
        };
        parts.iter().map(of).sum()
    };
    let none = [Part::Arc(TAU), Part::Line(0.0), Part::Arc(0.0)];
    // Of paths that differ by rounding only the first.
    all.into_iter()
        .reduce(|best, next| if size(&next) < (1.0 - TIE) * size(&best) { next } else { best })
        .unwrap_or(none)
}
