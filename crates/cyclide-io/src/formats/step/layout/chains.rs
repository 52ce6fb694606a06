//! Edges that are one in the file: arcs of one circle and parts of one line, between places where something else begins.

use super::regions::limit;
use cyclide::{
    curve::{Arc, Circle},
    topology::EdgeCurve,
};

/// Places at which a rational edge is held against a circle: more than twice its degree in all.
const PLACES: u32 = 24;
/// Rational edges of a higher degree are not looked at.
const LARGEST_DEGREE: usize = 10;
/// An arc that departs from its chord by no more than this part of the model's size is a line.
const STRAIGHT: f64 = 1e-15;
/// The angle of an open chain of arcs is at least this much below a full turn.
const OPENING: f64 = 1e-3;

/// The curve of an edge of the file.
#[derive(Debug, Clone)]
pub(in crate::formats::step) enum ChainCurve {
    /// A line or an arc.
    Arc(Arc),
    /// A whole circle, from the vertex at its start.
    Circle(Circle),
}

/// The circle or line that an edge is part of: rational ones are looked at too.
pub(super) fn as_arc(curve: &EdgeCurve, size: f64) -> Option<Arc> {
    let curve = match curve {
        EdgeCurve::Arc(arc) => return Some(*arc),
        EdgeCurve::Rational(curve) => curve,
    };
    if curve.rows().len() > LARGEST_DEGREE + 1 {
        return None;
    }
    let (start, end) = (curve.point(0.0), curve.point(1.0));
    let limit = limit(size, start.to_vec().max_abs().max(end.to_vec().max_abs()));
    let is_on = |arc: &Arc| {
        let off = (1..PLACES).map(|i| {
            let p = curve.point(f64::from(i) / f64::from(PLACES));
            arc.closest_point(p).distance
        });
        off.fold(0.0_f64, |largest, off| if off > largest || off.is_nan() { off } else { largest }) <= limit
    };
    let found = [Arc::segment(start, end), Arc::from_three_points(start, curve.point(0.5), end)];
    found.into_iter().flatten().find(is_on)
}

/// True of a line.
pub(in crate::formats::step) fn is_straight(arc: &Arc, size: f64) -> bool {
    0.5 * arc.chord().length() * arc.bulge_vector().length() <= STRAIGHT * size
}

/// True if two arcs, the second of which begins where the first ends, are parts of one line or circle and go on in one direction.
pub(super) fn continues(first: &Arc, second: &Arc, size: f64, circles: bool) -> bool {
    let goes_on = || Some(first.end_tangent()?.dot(second.start_tangent()?) > 0.9);
    let [line, other] = [first, second].map(|arc| is_straight(arc, size));
    if line != other || !(line || circles) || goes_on() != Some(true) {
        return false;
    }
    if line {
        return Arc::segment(first.start(), second.end()).is_ok_and(|whole| is_near(&whole, [first, second], size));
    }
    let larger = if first.angle() >= second.angle() { first } else { second };
    let circle = larger.center().zip(larger.normal());
    let circle = circle.and_then(|(center, normal)| Circle::from_center(center, normal, larger.start()).ok());
    circle.is_some_and(|circle| {
        let points = [first, second].into_iter().flat_map(places);
        points
            .into_iter()
            .all(|p| circle.closest_point(p).distance <= limit(size, p.to_vec().max_abs() + circle.radius()))
    })
}

fn places(arc: &Arc) -> [cyclide::Point3; 3] {
    [arc.start(), arc.midpoint(), arc.end()]
}

fn is_near(whole: &Arc, parts: [&Arc; 2], size: f64) -> bool {
    let points = parts.into_iter().flat_map(places);
    points.into_iter().all(|p| whole.closest_point(p).distance <= limit(size, p.to_vec().max_abs()))
}

/// The line, arc or circle of a chain of arcs, each run from its start; `None` if some of them are off it.
pub(super) fn joined(arcs: &[Arc], is_closed: bool, size: f64) -> Option<ChainCurve> {
    let (first, last) = (arcs.first()?, arcs.last()?);
    if let ([one], false) = (arcs, is_closed) {
        return Some(ChainCurve::Arc(*one));
    }
    let points = || arcs.iter().flat_map(places);
    if is_straight(first, size) {
        let whole = Arc::segment(first.start(), last.end()).ok()?;
        let is_on = |p: cyclide::Point3| whole.closest_point(p).distance <= limit(size, p.to_vec().max_abs());
        return points().all(is_on).then_some(ChainCurve::Arc(whole));
    }
    let widest = arcs.iter().max_by(|a, b| a.angle().total_cmp(&b.angle()))?;
    let (center, normal) = (widest.center()?, widest.normal()?);
    let limit = limit(size, first.start().to_vec().max_abs() + widest.radius()?);
    let circle = Circle::from_center(center, normal, first.start()).ok()?;
    let turn: f64 = arcs.iter().map(Arc::angle).sum();
    if !points().all(|p| circle.closest_point(p).distance <= limit) {
        return None;
    }
    if is_closed {
        return ((turn - std::f64::consts::TAU).abs() <= 1e-6).then_some(ChainCurve::Circle(circle));
    }
    if turn > std::f64::consts::TAU - OPENING {
        return None;
    }
    let arc = Arc::from_center(center, normal, first.start(), turn).ok()?;
    (arc.end().distance(last.end()) <= limit).then_some(ChainCurve::Arc(arc))
}
