//! Two cylinders or cones in any position, and the balls that touch both
//! (`docs/math/canal-blends.md#cylinders-and-cones-in-any-position`).
//!
//! Each surface has three linear forms `X`, `Y`, `L` of `(1, center, radius)` with `X² + Y² = L²` for the balls that touch it. The spans of both triples
//! meet in one form `l = a·(X1, Y1, L1) = b·(X2, Y2, L2)`, whose norm `N = aX² + aY² - aL²` is the same for both. Where it is negative, with
//! `E² = -N`, `r² = aX² + aY²`,
//! ```text
//! y0 = l,   y1 = (aL aX X + aL aY Y)/r + r L,   y2 = E (aX Y - aY X)/r
//! ```
//! satisfy `y1² + y2² = y0²`, and so do `y3`, `y4` of the second surface: the balls form a torus.

use super::{NaturalQuadric, RollingBall};
use crate::base::elimination::{inverse, null_vector};
use crate::base::planar::Point2;
use crate::base::vector::Point3;
use crate::error::{Error, ErrorItem, Result};

/// Norm ratios of this size or less are those of a degenerate pair.
const DEGENERATE: f64 = 1e-10;

/// Smallest pivot over the largest below which the spans have more than one form in common.
const MANY_FORMS: f64 = 1e-10;

/// Weights of a ball below this part of its terms are rounding of zero.
const AT_INFINITY: f64 = 1e-14;

/// The kind of a pair of cylinders and cones, by the sign of the norm of their common form.
///
/// ```
/// use cyclide::{NaturalQuadric, PairKind, Point3, QuadricPair, Vec3};
/// let along = |axis: Vec3, height: f64| NaturalQuadric::cylinder(Point3::new(0.0, 0.0, height), axis, 1.0);
/// assert_eq!(QuadricPair::new([along(Vec3::X, 0.0)?, along(Vec3::Y, 3.0)?])?.kind(), PairKind::Timelike);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PairKind {
    /// Negative norm: the balls that touch both are those of a torus.
    Timelike,
    /// Positive norm: one surface runs through the other. The balls are those of the split form.
    Spacelike,
}

/// Two cylinders or cones in any position.
///
/// ```
/// use cyclide::{NaturalQuadric, Point2, Point3, QuadricPair, Vec3};
/// let pipe = NaturalQuadric::cylinder(Point3::new(5.0, 0.0, -1.5), Vec3::X, 0.8)?;
/// let other = NaturalQuadric::cylinder(Point3::new(0.0, -7.0, 1.5), Vec3::Y, 1.3)?;
/// let ball = QuadricPair::new([pipe, other])?.ball(Point2::new(0.2, 1.3))?;
/// let contact = ball.contacts[0];
/// assert!((contact.y.hypot(contact.z + 1.5) - 0.8).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuadricPair {
    surfaces: [NaturalQuadric; 2],
    norm_ratio: f64,
    balls: Option<BallMatrix>,
}

/// From the five numbers of a place to `(1, center, radius)`, in a unit of length about an origin.
#[derive(Debug, Clone, Copy, PartialEq)]
struct BallMatrix {
    origin: Point3,
    unit: f64,
    rows: [[f64; 5]; 5],
}

impl QuadricPair {
    /// The pair, classified.
    ///
    /// # Errors
    /// `degenerate-pair` (the axes meet or are parallel in the space of balls: a common tangent ball for an axis, parallel or equal
    /// axes).
    pub fn new(surfaces: [NaturalQuadric; 2]) -> Result<Self> {
        let [p, q] = surfaces.map(|surface| surface.origin());
        let origin = p.midpoint(q);
        let unit = p.distance(q).max(surfaces[0].radius()).max(surfaces[1].radius()).max(f64::MIN_POSITIVE);
        let forms = surfaces.map(|surface| surface.forms(origin).map(|[c, rest @ ..]| in_unit(c / unit, rest)));
        let column = |j: usize| if j < 3 { forms[0][j] } else { forms[1][j - 3].map(|x| -x) };
        let rows: [[f64; 6]; 5] = std::array::from_fn(|i| std::array::from_fn(|j| column(j)[i]));
        let (v, pivot) = null_vector(rows).unwrap_or(([0.0; 6], 0.0));
        if !(pivot > MANY_FORMS) {
            return Err(Error::DegeneratePair { measured: pivot, limit: MANY_FORMS });
        }
        // Balls of the torus touch the first surface from outside.
        let sign = if v[2] < 0.0 { -1.0 } else { 1.0 };
        let parts = [[v[0], v[1], v[2]], [v[3], v[4], v[5]]].map(|part| part.map(|x| sign * x));
        let gradient: f64 = (1..5).map(|k| combined(&forms[0], parts[0])[k].powi(2)).sum();
        let [x, y, l] = parts[0];
        let norm = x * x + y * y - l * l;
        let norm_ratio = norm / gradient;
        if !(norm_ratio.abs() > DEGENERATE) {
            return Err(Error::DegeneratePair { measured: norm_ratio, limit: DEGENERATE });
        }
        let balls = if norm_ratio < 0.0 {
            let e = (-norm).sqrt();
            let [first, second] = [0, 1].map(|i| torus_forms(&forms[i], parts[i], e));
            let rows = [combined(&forms[0], parts[0]), first[0], first[1], second[0], second[1]];
            let (rows, pivot) = inverse(rows).ok_or(Error::DegeneratePair { measured: 0.0, limit: MANY_FORMS })?;
            if !(pivot > f64::EPSILON) {
                return Err(Error::DegeneratePair { measured: pivot, limit: f64::EPSILON });
            }
            Some(BallMatrix { origin, unit, rows })
        } else {
            None
        };
        Ok(Self { surfaces, norm_ratio, balls })
    }

    /// The surfaces.
    #[must_use]
    pub fn surfaces(&self) -> &[NaturalQuadric; 2] {
        &self.surfaces
    }

    /// The kind.
    #[must_use]
    pub fn kind(&self) -> PairKind {
        if self.norm_ratio < 0.0 { PairKind::Timelike } else { PairKind::Spacelike }
    }

    /// Norm of the common form over the square of the length of its gradient by centre and radius: negative for timelike pairs,
    /// between -1 and 1.
    #[must_use]
    pub fn norm_ratio(&self) -> f64 {
        self.norm_ratio
    }

    /// The ball of a place `(A, B)` of the plane of a torus, radians, each modulo pi. Its radius may be negative: a ball inside both.
    ///
    /// # Errors
    /// `not-finite`; `not-timelike-pair`; `sphere-at-infinity`; `wrong-side` (it touches one surface from the other side, or the other
    /// nappe of a cone).
    pub fn ball(&self, place: Point2) -> Result<RollingBall> {
        if !place.is_finite() {
            return Err(Error::NotFinite { what: ErrorItem::Angle, index: 0 });
        }
        let Some(BallMatrix { origin, unit, rows }) = self.balls else {
            return Err(Error::NotTimelikePair { measured: self.norm_ratio, limit: 0.0 });
        };
        let ((s1, c1), (s2, c2)) = ((2.0 * place.x).sin_cos(), (2.0 * place.y).sin_cos());
        let y = [1.0, c1, s1, c2, s2];
        let [w, mx, my, mz, radius] = rows.map(|row| row.iter().zip(y).map(|(a, b)| a * b).sum::<f64>());
        let terms: f64 = rows[0].iter().zip(y).map(|(a, b)| (a * b).abs()).sum();
        if w.abs() <= AT_INFINITY * terms {
            return Err(Error::SphereAtInfinity { measured: w.abs(), limit: AT_INFINITY * terms });
        }
        let center = origin + Point3::new(mx, my, mz).to_vec() * (unit / w);
        self.touching(center, radius * unit / w)
    }

    /// The ball with its contacts, if it touches both surfaces from their outer sides.
    fn touching(&self, center: Point3, radius: f64) -> Result<RollingBall> {
        let mut normals = [center.to_vec(); 2];
        for (surface, normal) in normals.iter_mut().enumerate() {
            let [x, y, distance] = self.surfaces[surface].forms(center).map(|form| form[0] + form[4] * radius);
            if !(distance > 0.0) {
                return Err(Error::WrongSide { surface, measured: distance });
            }
            // The length of (x, y) and the distance are equal up to rounding.
            let length = x.hypot(y);
            *normal = self.surfaces[surface].normal([x / length, y / length]);
        }
        Ok(RollingBall { center, radius, contacts: normals.map(|n| center - n * radius), normals })
    }
}

fn in_unit(first: f64, [a, b, c, d]: [f64; 4]) -> [f64; 5] {
    [first, a, b, c, d]
}

/// The sum of forms with factors.
fn combined(forms: &[[f64; 5]; 3], factors: [f64; 3]) -> [f64; 5] {
    std::array::from_fn(|k| (0..3).map(|i| factors[i] * forms[i][k]).sum())
}

/// `y1`, `y2` of one surface.
fn torus_forms(forms: &[[f64; 5]; 3], [x, y, l]: [f64; 3], e: f64) -> [[f64; 5]; 2] {
    let r = x.hypot(y);
    if r == 0.0 {
        return [combined(forms, [l, 0.0, 0.0]), combined(forms, [0.0, e, 0.0])];
    }
    [combined(forms, [l * x / r, l * y / r, r]), combined(forms, [-e * y / r, e * x / r, 0.0])]
}
