//! A piece of a canal surface between its curves of contact, exact (`docs/math/canal-blends.md#the-canal-patch`).
//!
//! Balls with center `m(s)` and radius `R(s)`, and quaternions `q0(s)`, `q1(s)` that turn the third axis to the normals of the contacts, so that the
//! characteristic circle is a circle in `t`:
//! ```text
//! q = (1-t) q0 + t q1,   x = m - R q k q⁻¹
//! rows in t:  (W m)|q|² - (W R) q k conj q,   weight W |q|²
//! ```

use crate::base::quat::Quat;
use crate::base::roots::projective_quadratic;
use crate::base::vector::{Point3, Vec3};
use crate::error::{NurbsError, Result};
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial, RationalBezierSurface};

/// Halvings of a patch until its weights are positive, along and across.
const HALVINGS: [u32; 2] = [24, 6];

/// A piece of the envelope of a rational family of balls, between the curves along which it touches two surfaces.
///
/// Parameters `(s, t)` in `[0, 1]²`: along s the balls, along t the characteristic circles, from the contact with the first surface to that
/// with the second. It is exactly rational.
///
/// ```
/// use cyclide::{Point2, surface::{CanalPatch, CircleFamily, QuarticType, SkewCylinders}};
/// let pair = SkewCylinders::new([1.0, 1.5], 2.0)?;
/// let kind = QuarticType::between(CircleFamily::Parallel, CircleFamily::Meridian).expect("they differ");
/// let patch = CanalPatch::between_skew_cylinders(&pair, kind, [[[1.0, 0.1], [1.0, 0.3]], [[0.2, 1.0], [-0.2, 1.0]]])?;
/// let on_first = patch.point(0.3, 0.0); // the first cylinder runs along x through (0, 0, -2)
/// assert!((on_first.y.hypot(on_first.z + 2.0) - 1.0).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CanalPatch {
    /// `[W m, W]`.
    pub(super) center: PolynomialRow,
    /// `W R`.
    pub(super) radius: Polynomial,
    /// `q0`, `q1`.
    pub(super) turns: [QuatPolynomial; 2],
}

/// The circle along which a ball touches its envelope.
///
/// ```
/// use cyclide::surface::{CanalPatch, CircleFamily, QuarticType, SkewCylinders};
/// let pair = SkewCylinders::new([1.0, 1.5], 2.0)?;
/// let kind = QuarticType::between(CircleFamily::Parallel, CircleFamily::Meridian).expect("they differ");
/// let patch = CanalPatch::between_skew_cylinders(&pair, kind, [[[1.0, 0.1], [1.0, 0.3]], [[0.2, 1.0], [-0.2, 1.0]]])?;
/// let circle = patch.characteristic_circle(0.5);
/// assert!((circle.contacts[0].distance(circle.center) - circle.radius).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CharacteristicCircle {
    /// Its center.
    pub center: Point3,
    /// Its radius.
    pub radius: f64,
    /// Unit normal of its plane, along the motion of the center of the ball; zero where that stands still.
    pub axis: Vec3,
    /// The contacts with both surfaces, on it.
    pub contacts: [Point3; 2],
    /// The middle of the shorter arc between them.
    pub minor_arc_midpoint: Point3,
}

/// A part of a canal patch in its exact rational form, with positive weights.
///
/// ```
/// use cyclide::surface::{CanalPatch, CircleFamily, QuarticType, SkewCylinders};
/// let pair = SkewCylinders::new([1.0, 1.5], 2.0)?;
/// let kind = QuarticType::between(CircleFamily::Parallel, CircleFamily::Meridian).expect("they differ");
/// let patch = CanalPatch::between_skew_cylinders(&pair, kind, [[[1.0, 0.1], [1.0, 0.3]], [[0.2, 1.0], [-0.2, 1.0]]])?;
/// let parts = patch.rational_parts()?;
/// assert!(parts[0].surface.point(0.0, 0.0).distance(patch.point(parts[0].s[0], parts[0].t[0])) < 1e-13);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CanalPart {
    /// Over `[0, 1]²`.
    pub surface: RationalBezierSurface,
    /// Where it is in the patch along s.
    pub s: [f64; 2],
    /// And along t.
    pub t: [f64; 2],
}

impl CanalPatch {
    /// From `[W m, W]`, `W R` and the quaternions that turn the third axis to the normals of the contacts.
    pub(crate) fn from_turns(center: PolynomialRow, radius: Polynomial, turns: [QuatPolynomial; 2]) -> Self {
        Self { center, radius, turns }
    }

    /// `q0`, `q1`.
    pub(crate) fn turns(&self) -> &[QuatPolynomial; 2] {
        &self.turns
    }

    /// The same with turns of one length at both ends, so that neighbors share arcs with their parameter: the one of lower degree times a linear
    /// factor.
    pub(crate) fn with_even_ends(mut self) -> Self {
        let degree = |turn: &QuatPolynomial| turn.0.iter().map(Polynomial::degree).max();
        let lower = usize::from(degree(&self.turns[1]) < degree(&self.turns[0]));
        let even = [0.0, 1.0].map(|s| self.turns[1 - lower].value(s).norm() / self.turns[lower].value(s).norm());
        self.turns[lower] = &self.turns[lower] * &Polynomial::new(even.to_vec());
        self
    }

    /// The same from the second contact to the first.
    pub(crate) fn exchanged(mut self) -> Self {
        self.turns.swap(0, 1);
        self
    }

    /// The same elsewhere.
    pub(crate) fn moved(mut self, by: Vec3) -> Self {
        let [x, y, z, w] = self.center.0;
        self.center = PolynomialRow([&x + &(&w * by.x), &y + &(&w * by.y), &z + &(&w * by.z), w]);
        self
    }

    /// The quaternion from the first turn to the second at `s`: the ratio of the weights of the arc between the contacts.
    pub(crate) fn arc_ratio(&self, s: f64) -> Option<Quat> {
        let [a, b] = self.turns.each_ref().map(|turn| turn.value(s));
        a.inverse().map(|inverse| b * inverse)
    }

    /// `W R`.
    pub(crate) fn radius(&self) -> &Polynomial {
        &self.radius
    }

    /// `[W m, W]`.
    pub(crate) fn center(&self) -> &PolynomialRow {
        &self.center
    }

    /// The patch of the concentric balls whose radii are larger by a distance: the offset surface at this distance against the normals.
    #[must_use]
    pub fn offset(&self, distance: f64) -> Self {
        let radius = &self.radius + &(self.center.weight() * distance);
        Self { radius, ..self.clone() }
    }

    /// The smallest and the largest radius of the balls can be no smaller or larger than these: the ratios of coefficients. `None` if a weight is not
    /// positive.
    #[must_use]
    pub fn radius_bounds(&self) -> Option<[f64; 2]> {
        let n = self.radius.degree().max(self.center.weight().degree());
        let (radius, weight) = (self.radius.elevated(n), self.center.weight().elevated(n));
        let pairs = radius.coefficients().iter().zip(weight.coefficients());
        pairs.into_iter().try_fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], (r, w)| {
            (*w > 0.0).then(|| [low.min(r / w), high.max(r / w)])
        })
    }

    /// The least [Jacobian](Self::jacobian) over the arc at `s`.
    #[must_use]
    pub fn least_jacobian(&self, s: f64) -> f64 {
        let [a, b] = self.turns.each_ref().map(|turn| turn.value(s));
        let [f, g] = self.jacobian_rows(s, [[a, a], [a, b], [b, b]]);
        // A quotient of quadratics in t: least at an end, or where its derivative, a quadratic over a square, is zero.
        let minor = |i: usize, j: usize| f[j] * g[i] - f[i] * g[j];
        let (start, half, end) = (minor(0, 1), 0.5 * minor(0, 2), minor(1, 2));
        let root = (half * half - start * end).max(0.0).sqrt();
        let inside = projective_quadratic(start, half, end, root).into_iter().flatten().map(|t| {
            let value = |c: [f64; 3]| (c[0] * (1.0 - t) + 2.0 * c[1] * t) * (1.0 - t) + c[2] * t * t;
            value(f) / value(g)
        });
        inside.fold((f[0] / g[0]).min(f[2] / g[2]), f64::min)
    }

    /// The Jacobian of the canal, `|m'|² - R'² - R R'' + R n·m''`, over `|m'|²`: the surface is regular where it is positive, and has turned inside out where it is
    /// negative. 0 where the center stands still.
    #[must_use]
    pub fn jacobian(&self, s: f64, t: f64) -> f64 {
        let [a, b] = self.turns.each_ref().map(|turn| turn.value(s));
        let q = a * (1.0 - t) + b * t;
        let [[f], [g]] = self.jacobian_rows(s, [[q, q]]);
        f / g
    }

    /// Numerators and denominators of the Jacobian, both bilinear in pairs of turns.
    fn jacobian_rows<const N: usize>(&self, s: f64, pairs: [[Quat; 2]; N]) -> [[f64; N]; 2] {
        let h: [[f64; 3]; 4] = self.center.0.each_ref().map(|entry| entry.jet::<3>(s));
        let [w, dw, ddw] = h[3];
        let quotient = |[x, dx, ddx]: [f64; 3]| {
            let v = x / w;
            let dv = (dx - v * dw) / w;
            [v, dv, (ddx - 2.0 * dv * dw - v * ddw) / w]
        };
        let [r, dr, ddr] = quotient(self.radius.jet::<3>(s));
        let [x, y, z] = [h[0], h[1], h[2]].map(quotient);
        let [motion, bend] = [1, 2].map(|k: usize| Vec3::new(x[k], y[k], z[k]));
        let square = motion.length_squared();
        let denominators = pairs.map(|[p, q]| p.dot(q));
        if square == 0.0 {
            return [[0.0; N], denominators];
        }
        let k = Quat::new(0.0, 0.0, 0.0, 1.0);
        let at = |p: Quat, q: Quat| {
            let turned = (p * k * q.conj()).vector();
            ((square - dr * dr - r * ddr) * p.dot(q) + r * turned.dot(bend)) / square
        };
        [pairs.map(|[p, q]| at(p, q)), denominators]
    }

    /// Center and radius of the ball at `s`.
    #[must_use]
    pub fn ball(&self, s: f64) -> (Point3, f64) {
        let [x, y, z, w] = self.center.0.each_ref().map(|entry| entry.value(s));
        (Point3::new(x / w, y / w, z / w), self.radius.value(s) / w)
    }

    /// The point at `(s, t)`.
    #[must_use]
    pub fn point(&self, s: f64, t: f64) -> Point3 {
        let (center, radius) = self.ball(s);
        center - self.unit_normal(s, t) * radius
    }

    /// Unit normal at `(s, t)`, towards the center of the ball where its radius is positive: at `t = 0` and `t = 1` that of the surfaces.
    #[must_use]
    pub fn unit_normal(&self, s: f64, t: f64) -> Vec3 {
        let [q0, q1] = self.turns.each_ref().map(|turn| turn.value(s));
        let q = q0 * (1.0 - t) + q1 * t;
        (q * (1.0 / q.norm())).rotate(Vec3::Z)
    }

    /// The characteristic circle at `s`.
    #[must_use]
    pub fn characteristic_circle(&self, s: f64) -> CharacteristicCircle {
        let ((m, r), [w, dw]) = (self.ball(s), self.center.weight().jet::<2>(s));
        let velocity = |row: &Polynomial, value: f64| (row.jet::<2>(s)[1] - value * dw) / w;
        let [x, y, z, _] = &self.center.0;
        let motion = Vec3::new(velocity(x, m.x), velocity(y, m.y), velocity(z, m.z));
        let (speed, growth) = (motion.length(), velocity(&self.radius, r));
        let axis = motion.unit().unwrap_or_default();
        // (x - m)·m' + R R' = 0.
        let cosine = if speed > 0.0 { growth / speed } else { 0.0 };
        let center = m - axis * (r * cosine);
        let contacts = [0.0, 1.0].map(|t| m - self.unit_normal(s, t) * r);
        let radius = r.abs() * ((1.0 - cosine) * (1.0 + cosine)).max(0.0).sqrt();
        let between = (contacts[0] - center) + (contacts[1] - center);
        let outward = between.unit().unwrap_or_else(|| (contacts[0] - center).cross(axis).unit().unwrap_or_default());
        CharacteristicCircle { center, radius, axis, contacts, minor_arc_midpoint: center + outward * radius }
    }

    /// The exact rational form, degree 2 in t. Weights may be zero or negative where arcs are half circles or more, or pieces
    /// turn far: see [`rational_parts`](Self::rational_parts).
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`].
    pub fn to_rational(&self) -> Result<RationalBezierSurface> {
        let [a, b] = &self.turns;
        let row = |p: &QuatPolynomial, q: &QuatPolynomial| self.row(p, q);
        let rows = [row(a, a), row(a, b), row(b, b)];
        let largest = rows.iter().flat_map(|row| row.weight().coefficients()).fold(0.0, |m: f64, w| m.max(w.abs()));
        // Coordinates of balls are projective: the weights may all be negative.
        let sign = if rows[0].weight().value(0.5) < 0.0 { -1.0 } else { 1.0 };
        RationalBezierSurface::from_polynomial_rows(&rows.map(|row| &row * (sign / largest)))
    }

    /// A row in t: `(W m) p·q - (W R) (p k conj q + q k conj p)/2`, weight `W p·q`.
    fn row(&self, p: &QuatPolynomial, q: &QuatPolynomial) -> PolynomialRow {
        let product = p.dot(q);
        let k = QuatPolynomial::constant(Quat::new(0.0, 0.0, 0.0, 1.0));
        // The vector part of p k conj q is the same both ways round.
        let QuatPolynomial([_, x, y, z]) = &(p * &k) * &q.conj();
        let radius = &self.radius * -1.0;
        let [cx, cy, cz, w] = &self.center.0;
        let entry = |center: &Polynomial, turned: &Polynomial| &(center * &product) + &(&radius * turned);
        PolynomialRow([entry(cx, &x), entry(cy, &y), entry(cz, &z), w * &product])
    }

    /// The rational form in parts with positive weights: halved along s while weights of a curve of contact are not, across t while only those
    /// between are not.
    ///
    /// # Errors
    /// `weight-not-positive` (a weight of the balls themselves is not: they run through infinity), as [`to_rational`](Self::to_rational).
    pub fn rational_parts(&self) -> Result<Vec<CanalPart>> {
        let whole = self.to_rational()?;
        let mut ahead = vec![(whole, [0.0, 1.0], [0.0, 1.0], HALVINGS)];
        let mut parts = Vec::new();
        while let Some((surface, s, t, [along, across])) = ahead.pop() {
            let halves = match first_bad_row(&surface) {
                None => {
                    parts.push(CanalPart { surface, s, t });
                    continue;
                }
                Some((1, _)) if across > 0 => {
                    let middle = 0.5 * (t[0] + t[1]);
                    let left = [along, across - 1];
                    [
                        (surface.part([0.0, 1.0], [0.5, 1.0]), s, [middle, t[1]], left),
                        (surface.part([0.0, 1.0], [0.0, 0.5]), s, [t[0], middle], left),
                    ]
                }
                Some(_) if along > 0 => {
                    let middle = 0.5 * (s[0] + s[1]);
                    let left = [along - 1, across];
                    [
                        (surface.part([0.5, 1.0], [0.0, 1.0]), [middle, s[1]], t, left),
                        (surface.part([0.0, 0.5], [0.0, 1.0]), [s[0], middle], t, left),
                    ]
                }
                Some((_, weight)) => return Err(NurbsError::WeightNotPositive { index: parts.len(), weight }.into()),
            };
            ahead.extend(halves);
        }
        Ok(parts)
    }
}

/// The row in t with a weight that is not positive, those of the curves of contact first, and that weight.
fn first_bad_row(surface: &RationalBezierSurface) -> Option<(usize, f64)> {
    let bad = |j: usize| surface.rows().iter().skip(j).step_by(3).map(|row| row[3]).find(|w| !(*w > 0.0));
    [0, 2, 1].into_iter().find_map(|j| Some((j, bad(j)?)))
}
