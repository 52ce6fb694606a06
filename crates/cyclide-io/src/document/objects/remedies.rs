//! Remedies that are tried before they are named.

use cyclide::{
    CurveObject, EdgeCurve, FairFit, FairFitOptions, Lower as _, Pipe, Point3, RailSurface, ShortNumber, SphericalCube,
};

use super::Builder;
use super::rail_sense::Rulings;
use super::swept::rotated;

/// Points of a run, and pieces of a rail, that are tried at most.
const MOST_TRIED: usize = 400;
/// Tolerances of a fit that are tried, in radii of the pipe; and the part of them that the arcs along it may take.
const TOLERANCES: [f64; 5] = [0.125, 0.25, 0.5, 1.0, 2.0];
const ARCS: f64 = 0.25;

impl Builder<'_> {
    /// How a pipe along a run of measured points is made: a fit within a tolerance, of those that work the least.
    pub(in crate::document) fn fit_for_pipe(&self, curve: &CurveObject, pipe: &Pipe, radius: f64) -> Option<String> {
        let CurveObject::ArcPath(path) = curve else { return None };
        let arcs = path.arcs();
        if arcs.len() > MOST_TRIED || !arcs.iter().all(cyclide::Arc::is_straight) {
            return None;
        }
        let closed = curve.as_curve().is_closed();
        let mut points: Vec<Point3> = arcs.iter().map(cyclide::Arc::start).collect();
        points.extend(arcs.last().filter(|_| !closed).map(cyclide::Arc::end));
        let name = &self.sources.first()?.item.name;
        TOLERANCES.into_iter().find_map(|part| {
            let tolerance = rounded_down(part * radius);
            let options = FairFitOptions { closed, ..FairFitOptions::new(tolerance) };
            let fit = FairFit::new(&points, &options).ok()?.into_spline();
            let arcs = rounded_down(ARCS * tolerance);
            let spine = fit.lower_to_arcs(arcs).ok()?.form;
            pipe.body(&spine).ok()?;
            Some(format!(
                "; if its points are measured, a smooth curve near them bears the pipe: make `{name}` a `\"type\": \"fair-fit\", \"tolerance\": {}`, and give the pipe the `\"tolerance\": {}`",
                ShortNumber(tolerance),
                ShortNumber(arcs)
            ))
        })
    }

    /// Where the second of two closed rails is to start, if that makes the surface between them.
    pub(in crate::document) fn start_of_rail(&self, rails: [&[EdgeCurve]; 2], shift: usize) -> Option<String> {
        let [first, second] = rails;
        let n = second.len();
        if first.len() != n || n > MOST_TRIED {
            return None;
        }
        let reversed: Vec<EdgeCurve> = second.iter().rev().map(EdgeCurve::reversed).collect();
        // What it starts with already is left out for the shift that would be written.
        let far =
            |other: &[EdgeCurve]| first.iter().zip(other).map(|(a, b)| a.start().distance(b.start())).sum::<f64>();
        let best = |curves: &[EdgeCurve]| {
            let mut all: Vec<(usize, Vec<EdgeCurve>)> = (0..n).map(|by| (by, rotated(curves, by))).collect();
            all.sort_by(|a, b| far(&a.1).total_cmp(&far(&b.1)));
            // The nearest ones only: each is made.
            let is_good = |other: &[EdgeCurve]| {
                RailSurface::ruled([first, other], true).is_ok() && !Rulings::of([first, other], true).cross()
            };
            all.into_iter().take(8).find(|(_, other)| is_good(other))
        };
        let as_drawn = if Rulings::of(rails, true).opposite() { None } else { best(second) };
        if let Some((by, other)) = as_drawn {
            let [x, y, z] = other[0].start().to_array().map(ShortNumber);
            let total = (by + shift) % n;
            return Some(format!(
                "the second curve begins at another corner: it should begin {by} of its {n} pieces later, at ({x}, {y}, {z}); write `\"shift\": {total}`"
            ));
        }
        let (by, other) = best(&reversed)?;
        let [x, y, z] = other[0].start().to_array().map(ShortNumber);
        // Reversed, it starts at the corner it was drawn from, before its pieces are shifted.
        let total = (by + n - shift % n) % n;
        let start = match total {
            0 if shift > 0 => ", and leave out `shift`".to_owned(),
            0 => String::new(),
            total => format!(", and write `\"shift\": {total}`"),
        };
        Some(format!(
            "the second curve runs the other way: take a `transform` of it with the steps `[\"reverse\"]`{start}, so that it begins at ({x}, {y}, {z})"
        ))
    }

    /// What is to be done with a rail that runs against the other one, if the surface between them goes through itself and does not the other way round.
    pub(in crate::document) fn rail_to_reverse(&self, rails: [&[EdgeCurve]; 2], shift: usize) -> Option<String> {
        let rulings = Rulings::of(rails, true);
        if !rulings.opposite() || !rulings.cross() { None } else { self.start_of_rail(rails, shift) }
    }

    /// An order of the corners of a block of which the first coincides with another, in which it is made.
    pub(in crate::document) fn order_of_corners(corners: &[Point3]) -> Option<String> {
        // Turns about the third direction, about the first, and about the second.
        const TURNS: [[usize; 8]; 6] = [
            [1, 3, 0, 2, 5, 7, 4, 6],
            [3, 2, 1, 0, 7, 6, 5, 4],
            [4, 5, 0, 1, 6, 7, 2, 3],
            [6, 7, 4, 5, 2, 3, 0, 1],
            [4, 0, 6, 2, 5, 1, 7, 3],
            [5, 4, 7, 6, 1, 0, 3, 2],
        ];
        let corners: [Point3; 8] = corners.try_into().ok()?;
        let builds = |turn: &[usize; 8]| {
            let [a, b, c, d, e, f, g, _] = turn.map(|k| corners[k]);
            SphericalCube::new([a, b, c, d, e, f, g]).is_ok()
        };
        let turn = TURNS.iter().find(|turn| builds(turn))?;
        let order = turn.map(|k| k.to_string()).join(", ");
        Some(format!(
            "; corners on the axis of a wedge are given twice, and the first of all is not one of them: give the corners in the order {order}"
        ))
    }
}

/// A number of two digits below a positive one.
fn rounded_down(x: f64) -> f64 {
    let unit = 10_f64.powf(x.log10().floor() - 1.0);
    format!("{:.1e}", (x / unit).floor() * unit).parse().unwrap_or(x)
}
