//! Phrases of messages that depend on what was measured.

use super::ErrorItem;
use crate::short_number::ShortNumber;

/// In words, that a value is outside its interval, and whether the ends of that are excluded: they are where the value is one of
/// them, and of what can never be as small or as large.
pub(super) fn outside(name: ErrorItem, value: f64, [min, max]: [f64; 2]) -> String {
    let is = |end: f64| (value - end).abs() <= 0.0;
    let open = matches!(name, ErrorItem::Duration | ErrorItem::Height | ErrorItem::Wall);
    let (low, high) = (ShortNumber(min), ShortNumber(max));
    if max >= f64::MAX {
        // A limit next to nothing says no more than that there is one.
        return match (open || is(min), value <= 0.0 && min > 0.0 && min <= SMALLEST) {
            (_, true) => "out of range: more than 0".to_owned(),
            (true, _) => format!("out of range: more than {low:#}"),
            (false, _) => format!("out of range: at least {low:#}"),
        };
    }
    let excluded = match (open, is(min), is(max)) {
        (true, ..) => ", the ends excluded".to_owned(),
        (_, true, _) => format!(", {low:#} excluded"),
        (_, _, true) => format!(", {high:#} excluded"),
        _ => String::new(),
    };
    format!("outside {low:#} to {high:#}{excluded}")
}

/// Limits up to here are there for the sake of the arithmetic.
const SMALLEST: f64 = 1e-150;

/// What it means if all edges of a polyhedron are reflex.
pub(super) fn clockwise(reflex: usize, edges: usize) -> &'static str {
    if reflex == edges { "; are the faces clockwise, seen from outside?" } else { "" }
}

/// A place round something, as degrees of one turn: noise below a millionth of one is none.
pub(super) fn turn(angle: f64) -> String {
    let degrees = 1e-4 * (1e4 * angle.to_degrees()).round();
    format!("{} degrees", ShortNumber(degrees.rem_euclid(360.0)))
}

/// A size next to its place; where all its points round to the same numbers nothing is left of it.
pub(super) fn size_in_place(size: f64) -> String {
    if size > 0.0 { format!("{} large", ShortNumber(size)) } else { "one single point".to_owned() }
}

/// The number of a segment, where there is one.
pub(super) fn numbered(segment: Option<usize>) -> String {
    segment.map_or(String::new(), |segment| format!(" {segment}"))
}

/// A count in words; one that was given up is infinite.
pub(super) fn at_least(needed: f64) -> String {
    if needed.is_finite() { ShortNumber(needed).to_string() } else { "ever more".to_owned() }
}

/// The first of some points and how many more there are.
pub(super) fn points_in_words(points: &[usize]) -> String {
    let shown: Vec<String> = points.iter().take(8).map(usize::to_string).collect();
    let more = points.len().saturating_sub(shown.len());
    let and = if more > 0 { format!(" and {more} more") } else { String::new() };
    format!("point(s) {}{and}", shown.join(", "))
}

/// The line of a net that is to blame: rows run along s, columns along t.
pub(super) fn along_pinned(direction: usize, line: Option<usize>) -> String {
    let name = if direction == 0 { "row" } else { "column" };
    line.map_or(String::new(), |line| format!(" along pinned {name} {line}"))
}

/// The ratio of speeds `1 + stretch` in words, where it is worth any.
pub(super) fn speed_ratio(stretch: f64, limit: f64) -> String {
    if stretch.abs() <= limit {
        return String::new();
    }
    let sign = if stretch < 0.0 { '-' } else { '+' };
    format!(" and the speed of the lines across by the factor 1 {sign} {}", ShortNumber(stretch.abs()))
}

/// What it means that a tangent points away from the chord: straight away, where the angle is rounding, or nearly so.
pub(super) fn opposed(index: usize, angle: f64, limit: f64) -> String {
    let away = format!("tangent {index} points away from the chord");
    if limit <= ROUNDING_OF_ANGLES {
        return format!("{away}: the arc would pass through infinity");
    }
    let (angle, limit) = (ShortNumber(angle), ShortNumber(limit));
    format!("{away} but for {angle} radians, where {limit} are needed: the arcs there would run out nearly to infinity")
}

/// Limits up to here are the rounding of an angle, about which nothing else can be said.
const ROUNDING_OF_ANGLES: f64 = 64.0 * f64::EPSILON;

/// A place in words.
pub(super) fn place(p: [f64; 3]) -> String {
    let [x, y, z] = p.map(|x| ShortNumber(x).to_string());
    format!("({x}, {y}, {z})")
}

/// The index of a place that lines turn round, by the half turns they make.
pub(crate) fn index_of_halves(halves: i32) -> String {
    let sign = if halves < 0 { "-" } else { "+" };
    let size = halves.unsigned_abs();
    if size.is_multiple_of(2) { format!("{sign}{}", size / 2) } else { format!("{sign}{size}/2") }
}

/// What goes to infinity, or near it.
pub(super) fn at_infinity(what: ErrorItem, distance: f64, limit: f64) -> String {
    if limit <= 0.0 {
        return "a point is at infinity: it lies on the line through the ends outside the segment, or maps there"
            .to_owned();
    }
    let (distance, limit) = (ShortNumber(distance), ShortNumber(limit));
    format!(
        "the {what} comes within {distance} of the point that goes to infinity, where its image loses its digits (at least {limit} \
         is needed there); move that point, the centre of an inversion, away from the {what}"
    )
}

/// How a blend runs out to infinity, or nearly so.
pub(super) fn through_infinity(segment: usize, reach: f64, limit: f64) -> String {
    if !reach.is_finite() {
        return format!("segment {segment}: a start tangent opposes the chord, the blend would pass through infinity");
    }
    let (reach, limit) = (ShortNumber(reach), ShortNumber(limit));
    format!(
        "segment {segment}: the curve runs out to {reach} times the distance of its two points and loses its digits there (at most \
         {limit} times is written); make the turn there less sharp, or add a point"
    )
}

/// Two counts that should be one.
pub(super) fn count_differs(what: ErrorItem, given: usize, needed: usize) -> String {
    match what {
        ErrorItem::Radius => format!("{given} radii given for {needed} points"),
        ErrorItem::Knot => format!("{given} knots given, {needed} needed"),
        ErrorItem::Weight => format!("{given} weights given for {needed} control points"),
        ErrorItem::Normal => format!("{given} normals given, one for each of {needed} vertices needed"),
        _ => format!("{given} {what}s given for {needed} points"),
    }
}

/// An axis or normal of which nothing is left.
pub(super) fn zero_axis(what: ErrorItem, length: f64, limit: f64) -> String {
    if limit <= 0.0 {
        return format!("the {what} is zero");
    }
    let (length, limit) = (ShortNumber(length), ShortNumber(limit));
    format!("the {what} runs along the chord: {length} of it is across, limit {limit}")
}

/// A limit as it is shown, rounded towards zero unless it is as short as that: what is read can be taken.
pub(super) fn nearer(limit: f64) -> f64 {
    let shown = |x: f64| ShortNumber(x).to_string().parse::<f64>().map_or(x.abs(), f64::abs);
    let parts = [0.0, 1e-4, 1e-3, 1e-2].into_iter().map(|part| limit * (1.0 - part));
    // What is off by less is rounding of the limit itself.
    parts.into_iter().find(|x| shown(*x) <= limit.abs() * (1.0 + 1e-9)).unwrap_or(limit)
}
