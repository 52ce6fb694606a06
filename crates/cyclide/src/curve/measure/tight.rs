//! The places of a curve that are tighter than a radius.

use super::continuity::joints;
use super::curvature::curvature_and_slope;
use super::cusps::cusps;
use super::fairness::CORNER_ANGLE;
use super::length::ArcLength;
use super::maximum::maximum;
use super::rest::place_of_curvature;
use crate::base::golden_section::GoldenSection;
use crate::base::roots::bracketed;
use crate::base::vector::Point3;
use crate::curve::{ParamCurve, PieceForm};
use crate::error::{ErrorItem, NumberError, Result};

/// Intervals of a piece that are looked at, beside its place of largest curvature.
const INTERVALS: u32 = 64;
/// How much tighter than the radius counts, relative to it: arcs of just that radius have it up to rounding.
const MARGIN: f64 = 1e-9;
/// Width to which the ends of a place are found, by the parameter of the piece.
const WIDTH: f64 = 1e-12;

/// A part of a curve that is tighter than a radius, by its tightest point.
///
/// ```
/// use cyclide::{Point3, curve::{ArcPath, tight_places}};
/// let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
/// let path = ArcPath::rounded_polyline(&corner, false, &[0.0, 0.5, 0.0])?;
/// let places = tight_places(&path, 1.0)?;
/// assert_eq!(places.len(), 1);
/// assert!((places[0].radius - 0.5).abs() < 1e-12 && (places[0].from - 3.5).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct TightPlace {
    /// Smallest radius of curvature of the part; 0 at a corner or cusp.
    pub radius: f64,
    /// Global parameter of the tightest point.
    pub t: f64,
    /// Its station, the arc length from the start.
    pub station: f64,
    /// The point.
    pub point: Point3,
    /// Station where the part begins; of a closed curve larger than where it ends if it passes the start.
    pub from: f64,
    /// Station where it ends.
    pub to: f64,
}

/// A tight part by pieces and their parameters.
#[derive(Clone, Copy)]
struct Part {
    from: (usize, f64),
    to: (usize, f64),
    tightest: (usize, f64),
    curvature: f64,
}

/// The parts of a curve where its radius of curvature is below `radius` (by more than 1e-9 of it), corners and [cusps](crate::curve::cusps) included, where also
/// a straight curve turns back, in their order along it. Arcs and circles are exact; elsewhere each piece is looked at in 64 intervals and at its largest
/// curvature, so that of other spikes narrower than that one may be missed.
///
/// # Errors
/// `not-finite`, `radius-not-positive`.
pub fn tight_places(curve: &dyn ParamCurve, radius: f64) -> Result<Vec<TightPlace>> {
    if !(radius.is_finite() && radius > 0.0) {
        return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index: 0, radius }.into());
    }
    let limit = (1.0 + MARGIN) / radius;
    let mut parts: Vec<Part> = (0..curve.piece_count()).flat_map(|piece| parts_of_piece(curve, piece, limit)).collect();
    for joint in joints(curve).into_iter().filter(|joint| joint.angle > CORNER_ANGLE) {
        let at = if joint.next > joint.piece { (joint.next, 0.0) } else { (joint.piece, 1.0) };
        parts.push(Part { from: at, to: at, tightest: at, curvature: f64::INFINITY });
    }
    for cusp in cusps(curve) {
        let at = curve.locate(cusp.t);
        parts.push(Part { from: at, to: at, tightest: at, curvature: f64::INFINITY });
    }
    let order = |part: &Part| part.from.0 as f64 + part.from.1;
    parts.sort_by(|a, b| order(a).total_cmp(&order(b)).then(a.curvature.total_cmp(&b.curvature)));
    let mut joined: Vec<Part> = Vec::new();
    for part in parts {
        match joined.last_mut() {
            Some(last) if reaches(last.to, part.from) => {
                let to = if last.to > part.to { last.to } else { part.to };
                last.join(&part);
                last.to = to;
            }
            _ => joined.push(part),
        }
    }
    let (start, end) = ((0, 0.0), (curve.piece_count() - 1, 1.0));
    let wraps = curve.is_closed() && joined.len() > 1 && joined[0].from == start && joined[joined.len() - 1].to == end;
    if wraps && let Some(mut last) = joined.pop() {
        last.join(&joined[0]);
        joined[0] = last;
        joined.rotate_left(1);
    }
    let lengths = ArcLength::new(curve);
    Ok(joined.iter().map(|part| part.place(curve, &lengths)).collect())
}

/// True if a part that ends at one place has another one in it, or goes on there.
fn reaches(end: (usize, f64), start: (usize, f64)) -> bool {
    start <= end || (end.1 >= 1.0 && start == (end.0 + 1, 0.0))
}

impl Part {
    fn join(&mut self, next: &Self) {
        self.to = next.to;
        if next.curvature > self.curvature {
            (self.tightest, self.curvature) = (next.tightest, next.curvature);
        }
    }

    fn place(&self, curve: &dyn ParamCurve, lengths: &ArcLength<'_>) -> TightPlace {
        let t = |(piece, s): (usize, f64)| (piece as f64 + s) / curve.piece_count() as f64;
        let station = |place| lengths.station(t(place));
        TightPlace {
            radius: 1.0 / self.curvature,
            t: t(self.tightest),
            station: station(self.tightest),
            point: curve.piece_point(self.tightest.0, self.tightest.1),
            from: station(self.from),
            to: station(self.to),
        }
    }
}

fn parts_of_piece(curve: &dyn ParamCurve, piece: usize, limit: f64) -> Vec<Part> {
    let whole = |curvature: f64| Part { from: (piece, 0.0), to: (piece, 1.0), tightest: (piece, 0.0), curvature };
    let constant = match curve.piece_form(piece) {
        PieceForm::Arc(arc) => Some(arc.curvature()),
        PieceForm::Circle(circle) => Some(1.0 / circle.radius()),
        PieceForm::Free => None,
    };
    match constant {
        Some(curvature) if curvature > limit => vec![whole(curvature)],
        Some(_) => Vec::new(),
        None => parts_of_free_piece(curve, piece, limit),
    }
}

fn parts_of_free_piece(curve: &dyn ParamCurve, piece: usize, limit: f64) -> Vec<Part> {
    let measured = |s: f64| curvature_and_slope(&curve.piece_jet(piece, place_of_curvature(curve, piece, s)));
    let finite = |(value, slope): (f64, f64)| if value.is_finite() { (value, slope) } else { (f64::MAX.sqrt(), 0.0) };
    let (peak, _) = maximum(&mut |s| finite(measured(s)));
    let mut grid: Vec<f64> = (0..=INTERVALS).map(|i| f64::from(i) / f64::from(INTERVALS)).collect();
    let at = grid.partition_point(|s| *s < peak);
    if grid.get(at).is_some_and(|s| *s > peak) {
        grid.insert(at, peak);
    }
    let values: Vec<f64> = grid.iter().map(|s| measured(*s).0).collect();
    let crossing = |a: f64, b: f64| bracketed(|s| finite(measured(s)).0 - limit, a, b, WIDTH);
    let mut parts: Vec<Part> = Vec::new();
    let mut open: Option<Part> = None;
    for (i, (&s, &value)) in grid.iter().zip(&values).enumerate() {
        let is_tight = value > limit;
        match (&mut open, is_tight) {
            (None, true) => {
                let from = if i == 0 { s } else { crossing(grid[i - 1], s) };
                open = Some(Part { from: (piece, from), to: (piece, s), tightest: (piece, s), curvature: value });
            }
            (Some(part), true) => {
                part.join(&Part { from: (piece, s), to: (piece, s), tightest: (piece, s), curvature: value });
            }
            (Some(part), false) => {
                part.to = (piece, crossing(grid[i - 1], s));
                parts.push(*part);
                open = None;
            }
            (None, false) => {}
        }
    }
    parts.extend(open);
    parts.iter_mut().for_each(|part| refine(part, &grid, &|s| finite(measured(s)).0));
    parts
}

/// Moves the tightest place of a part from the grid to the maximum beside it, by golden sections.
fn refine(part: &mut Part, grid: &[f64], curvature: &dyn Fn(f64) -> f64) {
    if !part.curvature.is_finite() {
        return;
    }
    let at = grid.partition_point(|s| *s < part.tightest.1);
    let ends = [grid[at.saturating_sub(1)], grid[(at + 1).min(grid.len() - 1)]];
    let s = GoldenSection::lowest(|s| -curvature(s), ends, GOLDEN_STEPS);
    let found = curvature(s);
    if found > part.curvature {
        (part.tightest.1, part.curvature) = (s, found);
    }
}

/// Sections of the two intervals beside the largest value: to 1e-9 of the piece.
const GOLDEN_STEPS: u32 = 40;
