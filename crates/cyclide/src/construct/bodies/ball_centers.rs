//! The way of the center of the ball that makes a blend, an exact rational curve, and the surface of all centers that it runs on
//! (`docs/math/canal-blends.md#the-surface-of-centers`; source: `002`, section 4 and Fig. 4).

use crate::base::planar::Point2;
use crate::error::{CrossingError, ErrorItem, NumberError, NurbsError, Result};
use crate::rational::{NurbsCurve, Polynomial, PolynomialRow, RationalBezier, RationalBezierSurface};
use crate::surface::{MovedCylinders, SkewCylinders};
use std::f64::consts::PI;

/// Halvings of a piece whose weights are not all positive.
const HALVINGS: u32 = 12;

/// Where the centers of the balls of a blend are.
///
/// ```
/// use cyclide::construct::{CrossingPipe, PipeCrossing};
/// let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-9.0, 9.0] };
/// let made = PipeCrossing::new([pipe, pipe], 3.0, 0.5)?.made()?;
/// let path = &made.centers.paths()[0];
/// assert!(path.to_beziers().iter().all(|piece| piece.degree() == 4));
/// // The ball touches the first pipe, about the x axis.
/// let m = path.point_at_knot(0.3);
/// assert!((m.y.hypot(m.z) - 2.5).abs() < 1e-3);
/// let surface = made.centers.surface(0.25)?;
/// assert_eq!(surface.degrees(), [2, 2]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BallCenters {
    paths: Vec<NurbsCurve>,
    torus: Option<CenterTorus>,
}

/// The balls that touch two pipes, where they are those of a torus, and how far the path goes on it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CenterTorus {
    pub(super) pair: CenterPair,
    /// The least and the largest `B - A` and `B + A` of its places.
    pub(super) reach: [[f64; 2]; 2],
    /// How far up its coordinates are counted from.
    pub(super) height: f64,
}

/// Two cylinders, or cones, one at least.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum CenterPair {
    Cylinders(SkewCylinders),
    Cones(Box<MovedCylinders>),
}

impl BallCenters {
    pub(super) fn new(paths: Vec<NurbsCurve>, torus: Option<CenterTorus>) -> Self {
        Self { paths, torus }
    }

    /// The closed ways of the centers, one for each blend: exact, with positive weights, C1. Of the balls of a torus they have the degree 4.
    #[must_use]
    pub fn paths(&self) -> &[NurbsCurve] {
        &self.paths
    }

    /// The surface of the centers of all balls that touch both pipes, of [all radii](SkewCylinders::center_surface), round the path: as far as it goes, and of what is
    /// left to the balls without end this part more to every side. Exact, of degree (2, 2), with positive weights; the path lies on it. Its four sides and all its parameter
    /// lines are conics.
    ///
    /// # Errors
    /// `no-center-surface` (unless the blend is one of two pipes that pass each other, outside or inside both), `parameter-out-of-range` (a margin that is not from 0 up to below 1).
    pub fn surface(&self, margin: f64) -> Result<RationalBezierSurface> {
        let torus = self.torus.as_ref().ok_or(CrossingError::NoCenterSurface)?;
        if !(0.0..1.0).contains(&margin) {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::Margin,
                value: margin,
                min: 0.0,
                max: 1.0,
            }
            .into());
        }
        let [u, v] = torus.reach.map(|[from, to]| [from * (1.0 - margin), PI - (PI - to) * (1.0 - margin)]);
        let surface = match &torus.pair {
            CenterPair::Cylinders(pair) => pair.center_surface(u, v),
            CenterPair::Cones(pair) => pair.center_surface(u, v),
        }?;
        let up = |[x, y, z, w]: [f64; 4]| [x, y, z + w * torus.height, w];
        RationalBezierSurface::new(surface.degrees(), surface.rows().iter().copied().map(up).collect())
    }
}

/// The least and the largest `B - A` and `B + A` of places.
pub(super) fn reach_of_places(places: impl Iterator<Item = Point2>) -> [[f64; 2]; 2] {
    places.fold([[f64::INFINITY, f64::NEG_INFINITY]; 2], |reach, place| {
        let both = [place.y - place.x, place.y + place.x];
        [0, 1].map(|k: usize| [reach[k][0].min(both[k]), reach[k][1].max(both[k])])
    })
}

/// The closed curve of pieces that follow each other, tangent: C1, at the nodes with the speed 1. A piece with the speeds a and b at its ends has that over an interval
/// of the length `sqrt(ab)`, in the parameter that the factors `(b/a)^(i/2)` of its rows give it.
///
/// # Errors
/// `weight-not-positive`, `disconnected`, as [`NurbsCurve::from_beziers`].
pub(super) fn closed_path<'a>(pieces: impl Iterator<Item = &'a PolynomialRow>) -> Result<NurbsCurve> {
    let rows: Vec<&PolynomialRow> = pieces.collect();
    let degree = rows.iter().flat_map(|row| &row.0).map(Polynomial::degree).max().unwrap_or(1);
    let mut curves = Vec::with_capacity(rows.len());
    for row in rows {
        let elevated = PolynomialRow(row.0.each_ref().map(|entry| entry.elevated(degree)));
        push_positive(&mut curves, RationalBezier::from_polynomial_row(&elevated), HALVINGS)?;
    }
    let mut intervals = Vec::with_capacity(curves.len());
    for curve in &mut curves {
        let [a, b] = [0.0, 1.0].map(|s| curve.jet(s).d1.length().sqrt());
        if !(a > 0.0 && b > 0.0) {
            // The center stands still at an end.
            intervals.push(curve.point(0.0).distance(curve.point(1.0)));
            continue;
        }
        intervals.push(a * b);
        let mut factor = 1.0;
        let scaled = curve.rows().iter().map(|row| {
            let scaled = row.map(|x| x * factor);
            factor *= b / a;
            scaled
        });
        *curve = RationalBezier::new(scaled.collect())?;
    }
    Ok(NurbsCurve::from_beziers(&curves, &intervals)?.closed_by_rounding())
}

/// A curve in parts with positive weights; they may all be negative.
fn push_positive(curves: &mut Vec<RationalBezier>, curve: RationalBezier, halvings: u32) -> Result<()> {
    if curve.has_positive_weights() {
        curves.push(curve);
        return Ok(());
    }
    let rows = curve.rows();
    if rows.iter().all(|row| row[3] < 0.0) {
        curves.push(curve.multiplied(&[-1.0]));
        return Ok(());
    }
    if halvings == 0 {
        let weight = rows.iter().map(|row| row[3]).fold(f64::INFINITY, f64::min);
        return Err(NurbsError::WeightNotPositive { index: curves.len(), weight }.into());
    }
    let (first, second) = curve.split(0.5)?;
    push_positive(curves, first, halvings - 1)?;
    push_positive(curves, second, halvings - 1)
}
