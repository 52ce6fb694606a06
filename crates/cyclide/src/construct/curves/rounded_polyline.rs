//! Polylines whose corners are rounded by arcs of given radii: runs of pipe, bent wire, profiles of turned parts.
//!
//! An arc of radius `r` that touches both legs of a corner with the turn `θ` leaves them at `r tan(θ/2)` from the corner.

use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ArcPath};
use crate::error::{Error, ErrorItem, NumberError, PipeError, PointError, Result};

/// Corners that turn by less have no arc.
const STRAIGHT: f64 = 1e-9;
/// Arcs may fill a leg up to this part of it too much: rounding of radii that were chosen to fill it.
const LEG_EXCESS: f64 = 1e-12;

impl ArcPath {
    /// The segments through points, with an arc of radius `radii[k]` that touches both neighbors instead of the corner at point `k`
    /// (0: a sharp corner; at the ends of an open polyline it means nothing). The path is G1 where the radii are positive.
    ///
    /// # Errors
    /// `too-few-points` (2, closed 3), `count-differs`, `not-finite`, `parameter-out-of-range`,
    /// `radius-not-positive` (negative), `coincident-points`; `bend-does-not-fit` if the legs of a corner are too short for
    /// its arc beside those of the neighbors, or turn back on each other.
    pub fn rounded_polyline(points: &[Point3], closed: bool, radii: &[f64]) -> Result<Self> {
        let (n, needed) = (points.len(), if closed { 3 } else { 2 });
        if n < needed {
            return Err(PointError::TooFewPoints { given: n, needed }.into());
        }
        if radii.len() != n {
            return Err(NumberError::CountDiffers { what: ErrorItem::Radius, given: radii.len(), needed: n }.into());
        }
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        for (index, &radius) in radii.iter().enumerate() {
            if !radius.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Radius, index }.into());
            }
            if radius < 0.0 {
                return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index, radius }.into());
            }
        }
        let legs = if closed { n } else { n - 1 };
        let ways = (0..legs).map(|k| {
            let way = points[(k + 1) % n] - points[k];
            let (first, second) = (k, (k + 1) % n);
            way.unit().ok_or(Error::Point(PointError::CoincidentPoints { first, second, distance: 0.0, limit: 0.0 }))
        });
        let ways: Vec<Vec3> = ways.collect::<Result<_>>()?;
        let corners = (0..n).map(|k| {
            let inner = closed || (k > 0 && k + 1 < n);
            Corner::new(points[k], inner.then(|| [ways[(k + legs - 1) % legs], ways[k % legs]]), radii[k])
        });
        let corners: Vec<Corner> = corners.collect();
        let mut arcs = Vec::with_capacity(2 * n);
        for leg in 0..legs {
            let next = (leg + 1) % n;
            let (from, to) = (&corners[leg], &corners[next]);
            let (needed, length) = (from.setback + to.setback, points[leg].distance(points[next]));
            if !(needed <= length * (1.0 + LEG_EXCESS)) {
                let corner = if from.setback > to.setback { leg } else { next };
                return Err(PipeError::BendDoesNotFit { corner, radius: radii[corner], needed, length }.into());
            }
            // A leg that its arcs fill has no segment; then both end in one point.
            let filled = needed >= length * (1.0 - LEG_EXCESS);
            if !filled {
                arcs.push(Arc::segment(from.ends[1], to.ends[0])?);
            }
            if let Some(ratio) = to.ratio {
                let start = if filled { from.ends[1] } else { to.ends[0] };
                arcs.push(Arc::from_ratio_across(start, to.ends[1], ratio)?);
            }
        }
        if closed
            && let Some(first) = arcs.first().map(Arc::start)
            && let Some(last) = arcs.last_mut()
        {
            // The first leg may be one that its arcs fill.
            *last = last.with_end(first);
        }
        Self::new(arcs, closed)
    }
}

/// What is left of a corner.
struct Corner {
    /// Where the legs before and behind end.
    ends: [Point3; 2],
    /// How much of each leg the arc takes; infinite where the legs turn back on each other.
    setback: f64,
    /// The weight ratio of the arc, if there is one.
    ratio: Option<Quat>,
}

impl Corner {
    /// The corner at a point between two directions, or an end.
    fn new(point: Point3, ways: Option<[Vec3; 2]>, radius: f64) -> Self {
        let sharp = Self { ends: [point; 2], setback: 0.0, ratio: None };
        let Some([before, behind]) = ways else { return sharp };
        let (turn, cosine) = (before.cross(behind), (before + behind).length() / 2.0);
        let sine = (before - behind).length() / 2.0;
        if radius == 0.0 || 2.0 * sine <= STRAIGHT {
            return sharp;
        }
        let setback = radius * (sine / cosine);
        // Half of the turn: cosine and sine about the normal.
        let axis = turn.unit().unwrap_or_default();
        Self {
            ends: [point - before * setback, point + behind * setback],
            setback: if cosine <= STRAIGHT { f64::INFINITY } else { setback },
            ratio: Some(Quat::from_parts(cosine, axis * sine)),
        }
    }
}
