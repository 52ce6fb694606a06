//! The bridge between two concentric ellipses: half circles over their chords, exact
//! (`docs/math/circular-surfaces.md#bridge-of-two-ellipses`; source: `000`, section 7, (32), Fig. 8).
//!
//! The ellipses `q0 = (a cos θ, b sin θ, 0)` and `q1 = (c cos θ, d sin θ, 0)` are joined at each θ by the half circle over the chord,
//! upright. It is tangent to the elliptic cylinders below both. With the chord `q1 - q0 = C/D`, D the denominator of cosine and sine,
//! and arcs that start with the derivative `λ e_z`, the rows over a part of the turn are
//!
//! ```text
//! |C|²/λ² [q0, 1] D,   |C|²/λ² [D λ e_z/2, 0],   D² [q1, 1] D
//! ```
//!
//! of degree 6, or all without the factor `|C|²/λ² = D²`, of degree 2, where the bridge is as wide along both axes. The middle weight is 0: halves in t
//! have positive weights.

use super::bands::{Bands, Ring};
use super::ellipse_ring::{Ellipse, Sector, direction};
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;
use crate::error::{Error, Result};
use crate::rational::{Polynomial, PolynomialRow, RationalBezierSurface};
use crate::topology::{Body, EdgeCurve};
use std::f64::consts::PI;

/// Ellipses whose semi-axes differ by less than this part of them meet.
const SEPARATION: f64 = 1e-12;

/// The bridge between two ellipses about the origin with axes along x and y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipseBridge {
    first: [f64; 2],
    second: [f64; 2],
    /// Length of the derivative at the start of the arcs.
    speed: f64,
}

impl EllipseBridge {
    /// The bridge from the ellipse with the semi-axes `first` along x and y to that with `second`.
    ///
    /// # Errors
    /// `not-finite`; `radius-not-positive`; `coincident-points` (semi-axes of one direction that are equal: the ellipses touch);
    /// `parameter-out-of-range` (beyond 1e150).
    pub fn new(first: [f64; 2], second: [f64; 2]) -> Result<Self> {
        for (index, radius) in [first, second].into_iter().flatten().enumerate() {
            if !radius.is_finite() {
                return Err(Error::NotFinite { what: "radius", index });
            }
            if radius <= 0.0 {
                return Err(Error::RadiusNotPositive { radius });
            }
            range::check_distance(radius)?;
        }
        for d in 0..2 {
            let (distance, limit) = ((second[d] - first[d]).abs(), SEPARATION * first[d].max(second[d]));
            if distance <= limit {
                return Err(Error::CoincidentPoints { first: 0, second: 1, distance, limit });
            }
        }
        let speed = ((second[0] - first[0]).abs() * (second[1] - first[1]).abs()).sqrt();
        Ok(Self { first, second, speed })
    }

    /// The half circle at an angle, from the first ellipse to the second.
    ///
    /// # Errors
    /// As [`Arc::from_start_tangent`], only beyond the range of the kernel's numbers.
    pub fn arc(&self, angle: f64) -> Result<Arc> {
        let [from, to] = [0, 1].map(|k| self.ellipse(k, 0.0).point(direction(angle)));
        Arc::from_start_tangent(from, to, Vec3::Z * self.speed)
    }

    /// The bridge between two angles, less than half a turn apart, exact: of degree (6, 2), or (2, 2) where it is as wide along
    /// both axes; s round the ellipses, t from the first to the second. The weights of its middle rows are 0.
    ///
    /// # Errors
    /// `angle-out-of-range` unless `0 < to - from < π`.
    pub fn surface(&self, from: f64, to: f64) -> Result<RationalBezierSurface> {
        if !(to - from > 0.0 && to - from < PI) {
            return Err(Error::AngleOutOfRange { angle: to - from, min: 0.0, max: PI });
        }
        self.over(&Sector::new(from, to))
    }

    /// The bridge as one body: the surface alone, or down to a base plane at `z = -depth` between the elliptic cylinders, a solid.
    /// Of circles its faces are parts of a torus, cylinders and a plane.
    ///
    /// # Errors
    /// `parameter-out-of-range` for a depth that is not positive; `not-finite`; `ellipses-cross` for a solid between
    /// ellipses that cross; `below-rounding-of-place` where they are nearer to each other than 1.5e-11 of their size.
    pub fn body(&self, depth: Option<f64>) -> Result<Body> {
        if let Some(depth) = depth {
            self.check_solid(depth)?;
        }
        let place = self.first.into_iter().chain(self.second).fold(0.0, f64::max);
        let width = self.widths().map(f64::abs).into_iter().fold(f64::INFINITY, f64::min);
        range::check_size_in_place("the bridge", width, place, range::SMALLEST_IN_PLACE)?;
        let sectors = Sector::turn(4);
        let mut bands = Bands::default();
        let surfaces = sectors.iter().map(|sector| self.over(sector)).collect::<Result<Vec<_>>>()?;
        let rail = |bands: &mut Bands, k: usize, z: f64| -> Result<Ring> {
            Ok(bands.ring(self.ellipse(k, z).curves(&sectors)?, true))
        };
        let first = rail(&mut bands, 0, 0.0)?;
        let crown = match self.crown() {
            Some(ellipse) => ellipse.curves(&sectors)?,
            None => surfaces.iter().map(|surface| surface.s_line(0.5).into()).collect(),
        };
        let crown = bands.ring(crown, true);
        let second = rail(&mut bands, 1, 0.0)?;
        for (rings, t) in [([&first, &crown], [0.0, 0.5]), ([&crown, &second], [0.5, 1.0])] {
            let arc = |i: usize, _| {
                let arc = self.arc(sectors[i].from())?;
                Ok(EdgeCurve::Arc(arc.restricted(t[0], t[1])?))
            };
            bands.band(rings, arc, |_, i| Ok(surfaces[i].part([0.0, 1.0], t)))?;
        }
        if let Some(depth) = depth {
            let (below, under) = (rail(&mut bands, 1, -depth)?, rail(&mut bands, 0, -depth)?);
            for pair in [[&second, &below], [&below, &under], [&under, &first]] {
                bands.ruled(pair)?;
            }
        }
        bands.finish()
    }

    fn check_solid(&self, depth: f64) -> Result<()> {
        if !depth.is_finite() {
            return Err(Error::NotFinite { what: "depth", index: 0 });
        }
        if !(depth >= range::MIN_DISTANCE) {
            let (min, max) = (range::MIN_DISTANCE, f64::MAX);
            return Err(Error::ParameterOutOfRange { name: "depth", value: depth, min, max });
        }
        let [along_x, along_y] = self.widths();
        if along_x * along_y < 0.0 {
            return Err(Error::EllipsesCross { along_x, along_y });
        }
        Ok(())
    }

    /// The ellipse along the middle of the arcs, where the bridge is as wide along both axes.
    fn crown(&self) -> Option<Ellipse> {
        let middle = |d: usize| 0.5 * (self.first[d] + self.second[d]);
        self.is_even().then(|| Ellipse {
            center: Point3::new(0.0, 0.0, 0.5 * self.speed),
            u: Vec3::new(middle(0), 0.0, 0.0),
            v: Vec3::new(0.0, middle(1), 0.0),
        })
    }

    /// True if it is as wide along both axes, up to the rounding of the semi-axes.
    fn is_even(&self) -> bool {
        let size = self.first.into_iter().chain(self.second).fold(0.0, f64::max);
        let [x, y] = self.widths();
        (x.abs() - y.abs()).abs() <= 2.0 * f64::EPSILON * size
    }

    /// By how much the second ellipse reaches beyond the first along x and y.
    fn widths(&self) -> [f64; 2] {
        [0, 1].map(|d| self.second[d] - self.first[d])
    }

    fn ellipse(&self, k: usize, z: f64) -> Ellipse {
        let [x, y] = if k == 0 { self.first } else { self.second };
        Ellipse { center: Point3::new(0.0, 0.0, z), u: Vec3::new(x, 0.0, 0.0), v: Vec3::new(0.0, y, 0.0) }
    }

    /// The exact form over a sector: the rows at the module.
    fn over(&self, sector: &Sector) -> Result<RationalBezierSurface> {
        let [first, second] = [0, 1].map(|k| self.ellipse(k, 0.0).row(sector));
        let one = &sector.one;
        let upright = |length: Polynomial| {
            PolynomialRow::direction([Polynomial::constant(0.0), Polynomial::constant(0.0), length])
        };
        let rows = if self.is_even() {
            [first, upright(one * (0.5 * self.speed)), second]
        } else {
            let [x, y] = self.widths();
            let (dx, dy) = (&sector.cos * (x / self.speed), &sector.sin * (y / self.speed));
            let squared = &(&dx * &dx) + &(&dy * &dy);
            [&first * &squared, upright(&(&squared * one) * (0.5 * self.speed)), &second * &(one * one)]
        };
        RationalBezierSurface::from_polynomial_rows(&rows)
    }
}
