//! The pieces of a tube of circles across its spine: arcs and segments with the radius as a polynomial of their parameter
//! (`docs/math/tubes.md#circles-across-a-spine`).

use super::super::LEAST_LEFT;
use super::super::along::{self, LINEAR, MOST_HALVINGS, Part};
use super::super::radius_law::RadiusLaw;
use crate::curve::{Arc, ArcPath};
use crate::error::{Result, TubeError};
use crate::rational::Polynomial;

/// Places at which a radius is compared with its law, at first and at most.
const PLACES: [usize; 2] = [16, 1024];

/// A piece of a spine with the radius along it.
#[derive(Debug, Clone, PartialEq)]
pub(in super::super) struct Piece {
    /// With weights of equal length, at most a third of a turn.
    pub(super) arc: Arc,
    /// Over the parameter of the arc; as few coefficients as it needs.
    pub(super) radius: Polynomial,
    /// Slopes of the law by the length, at both ends.
    pub(super) slopes: [f64; 2],
    /// The larger of the radii at its ends: the law is monotone between.
    pub(super) most: f64,
    /// Which arc of the path it is of.
    pub(super) source: usize,
}

/// The pieces along a path, no radius of which is farther than the tolerance from the law, with the largest difference.
///
/// # Errors
/// `corner-not-mitred`, `tube-folds`, `too-many-pieces`.
pub(super) fn pieces(path: &ArcPath, law: &RadiusLaw, tolerance: f64) -> Result<(Vec<Piece>, f64)> {
    let cap = along::most_arcs(path);
    let (mut made, mut bound) = (Vec::new(), 0.0_f64);
    let mut waiting: Vec<(Part<'_>, u32)> = along::parts(path, law)?.into_iter().rev().map(|part| (part, 0)).collect();
    while let Some((part, halvings)) = waiting.pop() {
        if made.len() >= cap {
            return Err(along::too_many(part.source, cap));
        }
        let (piece, off) = of_part(&part)?;
        if off <= tolerance {
            bound = bound.max(off);
            made.push(piece);
            continue;
        }
        let middle = 0.5 * (part.at[0] + part.at[1]);
        if halvings == MOST_HALVINGS || !(part.at[0] < middle && middle < part.at[1]) {
            return Err(along::too_many(part.source, cap));
        }
        let [first, second] = part.split_at(middle)?;
        waiting.extend([(second, halvings + 1), (first, halvings + 1)]);
    }
    Ok((made, bound))
}

/// The piece over a part, and a proved bound of how far its radius is from the law: 0 on segments, and where the radius stays.
fn of_part(part: &Part<'_>) -> Result<(Piece, f64)> {
    let [[r0, m0, c0], [r1, m1, c1]] = [part.radius(part.at[0], false), part.radius(part.at[1], true)];
    let (arc, length) = (part.arc, part.length());
    let most = r0.max(r1);
    let left = 1.0 - arc.curvature() * most;
    if !(left > LEAST_LEFT) {
        let at = if r0 > r1 { 0.0 } else { 1.0 };
        return Err(TubeError::Folds { piece: part.source, at, left }.into());
    }
    let slope = (r1 - r0) / length;
    let linear = (m0 - slope).abs().max((m1 - slope).abs()) <= LINEAR;
    let constant = linear && r0.total_cmp(&r1).is_eq();
    // Hermite data by the parameter: the law is a cubic of the length, which on a segment is the parameter.
    let speeds = [arc.start_derivative(), arc.end_derivative()].map(|v| v.length());
    let cubic = || vec![r0, r0 + m0 * speeds[0] / 3.0, r1 - m1 * speeds[1] / 3.0, r1];
    let radius = Polynomial::new(match () {
        () if constant => vec![r0],
        () if linear && arc.is_straight() => vec![r0, r1],
        () => cubic(),
    });
    let piece = Piece { arc, radius, slopes: [m0, m1], most, source: part.source };
    let off = if constant || arc.is_straight() {
        0.0
    } else {
        difference(part, &piece, [c0.abs().max(c1.abs()), m0.abs().max(m1.abs())])
    };
    Ok((piece, off))
}

/// The largest difference of the radius of a piece from its law `R` over the length `s(t)`: at places, and between two of them at most the eighth
/// of the square of their distance times the bound of the second derivative, `p'' - R'' s'^2 - R' s''`.
///
/// On an arc that turns by `a` with the radius `b` the parameter has the speed `s' = 2 b sin(a/2)/|q|^2`, with
/// `|q|^2 = 1 - 2 t (1 - t) (1 - cos(a/2))`, from `cos(a/4)^2` to 1.
fn difference(part: &Part<'_>, piece: &Piece, [bend, steepest]: [f64; 2]) -> f64 {
    let (arc, length) = (&piece.arc, part.length());
    let (half, quarter) = ((0.5 * arc.angle()).sin_cos(), (0.25 * arc.angle()).cos());
    let speed = 2.0 * half.0 / (arc.curvature() * quarter * quarter);
    let change = speed * 2.0 * (1.0 - half.1) / (quarter * quarter);
    let second =
        piece.radius.coefficients().windows(3).map(|c| 6.0 * (c[2] - 2.0 * c[1] + c[0]).abs()).fold(0.0, f64::max);
    let second = second + bend * speed * speed + (steepest + bend * length) * change;
    let at = |t: f64| {
        let [radius, ..] = part.radius(part.at[0] + (part.at[1] - part.at[0]) * arc.length_to(t) / length, true);
        (piece.radius.value(t) - radius).abs()
    };
    let mut places = PLACES[0];
    loop {
        let h = 1.0 / places as f64;
        let measured = (1..places).map(|k| at(k as f64 * h)).fold(0.0, f64::max);
        let between = second * h * h / 8.0;
        if between <= 0.25 * measured || places >= PLACES[1] {
            return measured + between;
        }
        places *= 2;
    }
}
