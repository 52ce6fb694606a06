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
use crate::error::{BridgeError, ErrorItem, NumberError, PointError, Result};
use crate::rational::{Polynomial, PolynomialRow, RationalBezierSurface};
use crate::topology::{Body, EdgeCurve};
use crate::warning::{BodyWarning, Warning};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Ellipses whose semi-axes differ by less than this part of them meet.
const SEPARATION: f64 = 1e-12;

/// Over a face the square of the chord, which is a weight, grows by no more than this: readers integrate faces of uneven weights badly.
const LARGEST_GROWTH: f64 = 16.0;
/// A quarter turn is halved this often at most, and only beside its narrow place: enough for all widths that are more than rounding of the
/// semi-axes (1.5e-11 of them, `body`), since each halving there makes the square of the chord four times as even.
const MOST_HALVINGS: usize = 40;

/// The bridge between two ellipses about the origin with axes along x and y.
///
/// ```
/// use cyclide::construct::EllipseBridge;
/// let bridge = EllipseBridge::new([3.0, 2.0], [4.0, 2.5])?;
/// assert!((bridge.arc(0.0)?.length() - 0.5 * std::f64::consts::PI).abs() < 1e-12); // a half circle over a gap of 1
/// assert!(bridge.body(Some(1.0))?.is_solid());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipseBridge {
    first: [f64; 2],
    second: [f64; 2],
    /// Length of the derivative at the start of the arcs.
    speed: f64,
}

/// Halves of the circles over the chords: from the first ellipse to the second above them, and back below.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Half {
    Upper,
    Lower,
}

impl EllipseBridge {
    /// The bridge from the ellipse with the semi-axes `first` along x and y to that with `second`.
    ///
    /// # Errors
    /// `not-finite`; `radius-not-positive`; `coincident-points` (semi-axes of one direction that are equal: the ellipses touch);
    /// `parameter-out-of-range` (beyond 1e150).
    pub fn new(first: [f64; 2], second: [f64; 2]) -> Result<Self> {
        for (index, radius) in [first, second].into_iter().flatten().enumerate() {
            range::check_radius(ErrorItem::Ellipse, index / 2, radius)?;
        }
        for d in 0..2 {
            let (distance, limit) = ((second[d] - first[d]).abs(), SEPARATION * first[d].max(second[d]));
            if distance <= limit {
                return Err(PointError::CoincidentPoints { first: 0, second: 1, distance, limit }.into());
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
            return Err(
                NumberError::AngleOutOfRange { name: ErrorItem::Angle, angle: to - from, min: 0.0, max: PI }.into()
            );
        }
        self.over(&Sector::new(from, to))
    }

    /// What should be known of it (`ellipses-cross`): between ellipses that cross the surface runs through itself. A solid of them is refused.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let cross =
            self.crossing().map(|[along_x, along_y]| Warning::Body(BodyWarning::EllipsesCross { along_x, along_y }));
        cross.into_iter().collect()
    }

    /// By how much the second ellipse is wider along both axes, if the ellipses cross.
    fn crossing(&self) -> Option<[f64; 2]> {
        let widths = self.widths();
        (widths[0] * widths[1] < 0.0).then_some(widths)
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
        self.check_widths()?;
        let sectors = self.sectors();
        let mut bands = Bands::default();
        let first = self.rail(&mut bands, &sectors, 0, 0.0)?;
        let second = self.rail(&mut bands, &sectors, 1, 0.0)?;
        self.half_circles(&mut bands, &sectors, [&first, &second], Half::Upper)?;
        if let Some(depth) = depth {
            let below = self.rail(&mut bands, &sectors, 1, -depth)?;
            let under = self.rail(&mut bands, &sectors, 0, -depth)?;
            for pair in [[&second, &below], [&below, &under], [&under, &first]] {
                bands.ruled(pair)?;
            }
        }
        bands.finish()
    }

    /// The whole circles over the chords, above and below: the surface of which the bridge is the upper half, closed, as a solid ring. Of circles its
    /// faces are parts of a torus.
    ///
    /// ```
    /// use cyclide::construct::EllipseBridge;
    /// use std::f64::consts::PI;
    /// let torus = EllipseBridge::new([3.0, 3.0], [5.0, 5.0])?.whole_circles()?;
    /// assert!(torus.is_solid() && (torus.outer.volume() - 8.0 * PI * PI).abs() < 1e-9);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `ellipses-cross`, `below-rounding-of-place` as [`body`](Self::body).
    pub fn whole_circles(&self) -> Result<Body> {
        self.check_uncrossed()?;
        self.check_widths()?;
        let sectors = self.sectors();
        let mut bands = Bands::default();
        let first = self.rail(&mut bands, &sectors, 0, 0.0)?;
        let second = self.rail(&mut bands, &sectors, 1, 0.0)?;
        self.half_circles(&mut bands, &sectors, [&first, &second], Half::Upper)?;
        self.half_circles(&mut bands, &sectors, [&second, &first], Half::Lower)?;
        bands.finish()
    }

    fn rail(&self, bands: &mut Bands, sectors: &[Sector], k: usize, z: f64) -> Result<Ring> {
        Ok(bands.ring(self.ellipse(k, z).curves(sectors)?, true))
    }

    /// Adds the faces of half circles between two rings, in quarters.
    fn half_circles(&self, bands: &mut Bands, sectors: &[Sector], [from, to]: [&Ring; 2], half: Half) -> Result<()> {
        let surface = |sector| {
            let [first, middle, second] = self.even_rows(sector);
            RationalBezierSurface::from_polynomial_rows(&match half {
                Half::Upper => [first, middle, second],
                Half::Lower => [second, &middle * -1.0, first],
            })
        };
        let surfaces = sectors.iter().map(surface).collect::<Result<Vec<_>>>()?;
        let crown = match self.crown(half) {
            Some(ellipse) => ellipse.curves(sectors)?,
            None => surfaces.iter().map(|surface| surface.s_line(0.5).into()).collect(),
        };
        let crown = bands.ring(crown, true);
        let (ends, up) = match half {
            Half::Upper => ([0, 1], Vec3::Z),
            Half::Lower => ([1, 0], -Vec3::Z),
        };
        for (rings, t) in [([from, &crown], [0.0, 0.5]), ([&crown, to], [0.5, 1.0])] {
            let arc = |i: usize, _| {
                let [from, to] = ends.map(|k| self.ellipse(k, 0.0).point(sectors[i].start));
                let arc = Arc::from_start_tangent(from, to, up * from.distance(to))?;
                Ok(EdgeCurve::Arc(arc.restricted(t[0], t[1])?))
            };
            bands.band(rings, arc, |_, i| Ok(surfaces[i].part([0.0, 1.0], t)))?;
        }
        Ok(())
    }

    /// Refuses ellipses that are too near to each other for their place.
    fn check_widths(&self) -> Result<()> {
        let place = self.first.into_iter().chain(self.second).fold(0.0, f64::max);
        let width = self.widths().map(f64::abs).into_iter().fold(f64::INFINITY, f64::min);
        range::check_size_in_place(ErrorItem::Bridge, width, place, range::SMALLEST_IN_PLACE)
    }

    fn check_solid(&self, depth: f64) -> Result<()> {
        if !depth.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Depth, index: 0 }.into());
        }
        if !(depth >= range::MIN_DISTANCE) {
            let (min, max) = (range::MIN_DISTANCE, f64::MAX);
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Depth, value: depth, min, max }.into());
        }
        self.check_uncrossed()
    }

    fn check_uncrossed(&self) -> Result<()> {
        match self.crossing() {
            Some([along_x, along_y]) => Err(BridgeError::EllipsesCross { along_x, along_y }.into()),
            None => Ok(()),
        }
    }

    /// Parts of the turn, four or more, over which the chords are of about one length.
    fn sectors(&self) -> Vec<Sector> {
        let [x, y] = self.widths();
        let square = |angle: f64| {
            let [cos, sin] = direction(angle);
            (x * cos).powi(2) + (y * sin).powi(2)
        };
        let mut places: Vec<f64> = (0..4)
            .flat_map(|quarter| {
                // Along a quarter the square rises or falls throughout: its ends tell by how much.
                let turn = |part: f64| FRAC_PI_2 * (f64::from(quarter) + part);
                let grows = |a: f64, b: f64| {
                    let (a, b) = (square(turn(a)), square(turn(b)));
                    a.max(b) > LARGEST_GROWTH * a.min(b)
                };
                let mut parts = vec![0.0];
                let mut ahead = vec![1.0];
                while let Some(&to) = ahead.last() {
                    let from = parts[parts.len() - 1];
                    if ahead.len() <= MOST_HALVINGS && grows(from, to) {
                        ahead.push(0.5 * (from + to));
                    } else {
                        parts.push(to);
                        ahead.pop();
                    }
                }
                parts.pop();
                parts.into_iter().map(turn).collect::<Vec<_>>()
            })
            .collect();
        places.push(TAU);
        places.windows(2).map(|pair| Sector::new(pair[0], pair[1])).collect()
    }

    /// The ellipse along the middle of the arcs, where the bridge is as wide along both axes.
    fn crown(&self, half: Half) -> Option<Ellipse> {
        let middle = |d: usize| 0.5 * (self.first[d] + self.second[d]);
        let height = if half == Half::Upper { 0.5 } else { -0.5 } * self.speed;
        self.is_even().then(|| Ellipse {
            center: Point3::new(0.0, 0.0, height),
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
        RationalBezierSurface::from_polynomial_rows(&self.rows(sector))
    }

    /// The rows of the same surface with even arcs at both ends of the sector, so that half of an arc is half of its parameter: times 1, ρ and
    /// ρ², a change of the parameter t, where ρ is linear between the lengths of the chords over λ. Its degree
    /// is (8, 2); where the bridge is as wide along both axes its arcs are even as they are.
    fn even_rows(&self, sector: &Sector) -> [PolynomialRow; 3] {
        let rows = self.rows(sector);
        if self.is_even() {
            return rows;
        }
        let [x, y] = self.widths();
        let ends = [sector.start, sector.end].map(|[cos, sin]| (x * cos).hypot(y * sin) / self.speed);
        let (ratio, one) = (Polynomial::new(ends.to_vec()), Polynomial::new(vec![1.0; 2]));
        let [first, middle, last] = rows;
        [&first * &(&one * &one), &middle * &(&one * &ratio), &last * &(&ratio * &ratio)]
    }

    fn rows(&self, sector: &Sector) -> [PolynomialRow; 3] {
        let [first, second] = [0, 1].map(|k| self.ellipse(k, 0.0).row(sector));
        let one = &sector.one;
        let upright = |length: Polynomial| {
            PolynomialRow::direction([Polynomial::constant(0.0), Polynomial::constant(0.0), length])
        };
        if self.is_even() {
            return [first, upright(one * (0.5 * self.speed)), second];
        }
        let [x, y] = self.widths();
        let (dx, dy) = (&sector.cos * (x / self.speed), &sector.sin * (y / self.speed));
        let squared = &(&dx * &dx) + &(&dy * &dy);
        [&first * &squared, upright(&(&squared * one) * (0.5 * self.speed)), &second * &(one * one)]
    }
}
