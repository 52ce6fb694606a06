//! Curves as STEP entities.

use super::data::{Data, push_list, push_reference, real, string};
use crate::export::exported::{PieceNotes, SMALLEST_RADIUS};
use crate::export::scaled_weights::scaled_weights;
use crate::text::number::push_step;
use cyclide::{
    curve::{Arc, Circle, ParamCurve},
    model::{ChainPiece, CurveChain},
    rational::NurbsCurve,
};
use std::fmt::Write as _;

/// Beyond this radius, relative to the chord, to the model and absolute (readers join ends that are 1e-7 apart), a
/// trimmed circle loses digits: its points are the center plus the radius, rounded to about 4e-16 of the radius.
/// Such an arc, all but straight, is written as the exact rational quadratic instead.
const LARGEST_RADIUS: (f64, f64, f64) = (1e6, 1e5, 2e7);
/// Below this radius, relative to the chord, an arc is visibly curved and always a circle.
const CURVED_RADIUS: f64 = 1e3;

/// A composite curve from the pieces of a chain; `size` is the model's diagonal. Notes what each smooth piece has
/// become.
pub(super) fn composite(data: &mut Data, name: &str, chain: CurveChain, size: f64, pieces: &mut PieceNotes) -> usize {
    let closed = chain.is_closed();
    let curves = chain.into_pieces().into_iter().map(|piece| bounded_curve(data, piece, size, pieces));
    let curves: Vec<usize> = curves.collect();
    composite_of(data, name, &curves, closed)
}

/// A full circle, which needs no trimming.
pub(super) fn full_circle(data: &mut Data, name: &str, circle: &Circle) -> usize {
    let curve = circle_from(data, circle);
    composite_of(data, name, &[curve], true)
}

/// A full circle from its start.
pub(super) fn circle_from(data: &mut Data, circle: &Circle) -> usize {
    let (center, normal) = (circle.center(), circle.normal());
    let spoke = (circle.start() - center).unit().unwrap_or_else(|| normal.any_perpendicular());
    let placement = data.placement(center, normal, spoke);
    data.add(&format!("CIRCLE('',#{placement},{})", real(circle.radius())))
}

fn composite_of(data: &mut Data, name: &str, pieces: &[usize], closed: bool) -> usize {
    let segments: Vec<usize> = pieces
        .iter()
        .enumerate()
        .map(|(i, curve)| {
            let open = i + 1 == pieces.len() && !closed;
            let transition = if open { ".DISCONTINUOUS." } else { ".CONTINUOUS." };
            data.add(&format!("COMPOSITE_CURVE_SEGMENT({transition},.T.,#{curve})"))
        })
        .collect();
    data.write(|out| {
        let _ = write!(out, "COMPOSITE_CURVE({},", string(name));
        push_list(out, segments, push_reference);
        out.push_str(",.F.)");
    })
}

fn bounded_curve(data: &mut Data, piece: ChainPiece, size: f64, pieces: &mut PieceNotes) -> usize {
    match piece {
        ChainPiece::Arc(arc) => bounded_arc(data, &arc, size, pieces),
        ChainPiece::Spline(curve) => {
            pieces.spline(&curve);
            b_spline(data, curve)
        }
    }
}

fn bounded_arc(data: &mut Data, arc: &Arc, size: f64, pieces: &mut PieceNotes) -> usize {
    if let Some(curve) = trimmed_circle(data, arc, size) {
        pieces.counts.push(1);
        return curve;
    }
    match arc.to_nurbs(cyclide::curve::DEFAULT_PIECE_ANGLE) {
        Ok(curve) if !arc.is_straight() => {
            pieces.arc_as_spline(&curve);
            b_spline(data, curve)
        }
        _ => {
            pieces.counts.push(1);
            trimmed_line(data, arc)
        }
    }
}

/// The arc as a circle trimmed from 0 to the swept angle: the reader then gets the length to the last digits. `None`
/// for segments and for radii that would lose digits.
fn trimmed_circle(data: &mut Data, arc: &Arc, size: f64) -> Option<usize> {
    let circle = circle(data, arc, size)?;
    Some(trimmed(data, circle, arc, arc.angle()))
}

/// The circle of an arc, started at the arc's start and run in its direction. `None` for segments and for radii that
/// would lose digits.
pub(super) fn circle(data: &mut Data, arc: &Arc, size: f64) -> Option<usize> {
    let (center, radius, normal) = (arc.center()?, arc.radius()?, arc.normal()?);
    let chord = arc.chord().length();
    let place = arc.start().to_vec().max_abs().max(arc.end().to_vec().max_abs());
    if radius <= SMALLEST_RADIUS * place {
        return None;
    }
    let (by_chord, by_size, absolute) = LARGEST_RADIUS;
    let flat = radius > CURVED_RADIUS * chord;
    if flat && (radius > by_chord * chord || radius > by_size * size || radius > absolute) {
        return None;
    }
    // From the chord's direction, not from the difference of two rounded points far away.
    let spoke = normal.cross(arc.start_tangent()?).unit()? * -1.0;
    let placement = data.placement(center, normal, spoke);
    Some(data.write(|out| {
        let _ = write!(out, "CIRCLE('',#{placement},");
        push_step(out, radius);
        out.push(')');
    }))
}

fn trimmed_line(data: &mut Data, arc: &Arc) -> usize {
    let line = line(data, arc);
    trimmed(data, line, arc, arc.chord().length())
}

/// The line from the start of a segment through its end.
pub(super) fn line(data: &mut Data, arc: &Arc) -> usize {
    let vector = data.unit_vector(arc.chord().unit().unwrap_or(cyclide::Vec3::X));
    let start = data.point(arc.start());
    data.add(&format!("LINE('',#{start},#{vector})"))
}

/// Trimmed from the curve's own start to parameter `end`, with the points beside the parameters.
fn trimmed(data: &mut Data, basis: usize, arc: &Arc, end: f64) -> usize {
    let (from, to) = (data.point(arc.start()), data.point(arc.end()));
    data.add(&format!(
        "TRIMMED_CURVE('',#{basis},(#{from},PARAMETER_VALUE(0.)),(#{to},PARAMETER_VALUE({})),.T.,.PARAMETER.)",
        real(end)
    ))
}

/// One rational B-spline, with C1 knots where the curve is C1: readers take the multiplicity for the continuity. It is
/// given away, since of two forms of a long one and its text one is too much.
pub(super) fn b_spline(data: &mut Data, curve: NurbsCurve) -> usize {
    let curve = curve.with_c1_knots().unwrap_or(curve);
    let points: Vec<usize> = curve.control_points().iter().map(|&p| data.point(p)).collect();
    let knots = curve.knot_multiplicities();
    let closed = if curve.is_closed() && same_weight_at_ends(&curve) { ".T." } else { ".F." };
    // One instance may be most of the file: written where it stays.
    data.write(|out| {
        let _ = write!(out, "(BOUNDED_CURVE() B_SPLINE_CURVE({},", curve.degree());
        push_list(out, points, push_reference);
        let _ = write!(out, ",.UNSPECIFIED.,{closed},.F.) B_SPLINE_CURVE_WITH_KNOTS(");
        push_list(out, &knots, |out, (_, multiplicity)| {
            let _ = write!(out, "{multiplicity}");
        });
        out.push(',');
        push_list(out, &knots, |out, (knot, _)| push_step(out, *knot));
        out.push_str(",.UNSPECIFIED.) CURVE() GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_CURVE(");
        push_list(out, scaled_weights(curve.weights()), push_step);
        out.push_str(") REPRESENTATION_ITEM(''))");
    })
}

/// Readers make a curve that is said to be closed periodic: its last control point becomes the first one, weight and all, which bends
/// the last span of a curve whose weights differ there. The flag is for information only (ISO 10303-42), and OpenCASCADE takes unknown for
/// closed: such a curve is not called closed, and its composite curve says that it continues.
fn same_weight_at_ends(curve: &NurbsCurve) -> bool {
    match curve.weights() {
        [first, .., last] => (first - last).abs() <= 4.0 * f64::EPSILON * first.abs(),
        _ => true,
    }
}
