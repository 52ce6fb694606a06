//! Möbius transformations as 2×2 quaternion matrices that keep three-space.
//!
//! ```text
//! y -> (a y + b)(c y + d)^-1
//! ```
//! Every Möbius map of three-space has this form, the orientation-reversing ones too, because `y` is purely
//! imaginary: inversion in the sphere of centre `o` and radius `R` is `(o y + |o|² - R²)(y - o)^-1`, reflection in
//! the plane with unit normal `n` through `o` is `(n (y-o))(-n)^-1 + o`.

use super::hpoint::HPoint;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, Result};

/// Largest relative distance from three-space that counts as rounding of the matrix.
const DEFECT_LIMIT: f64 = 1e-9;

/// A Möbius transformation of three-space and the point at infinity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mobius {
    a: Quat,
    b: Quat,
    c: Quat,
    d: Quat,
}

impl Mobius {
    /// The identity.
    pub const IDENTITY: Self = Self { a: Quat::ONE, b: Quat::ZERO, c: Quat::ZERO, d: Quat::ONE };

    /// The map `y -> (a y + b)(c y + d)^-1`.
    ///
    /// # Errors
    /// `not-finite`; `not-mobius` if it is singular or does not keep three-space (relative defect above 1e-9).
    pub fn from_matrix(a: Quat, b: Quat, c: Quat, d: Quat) -> Result<Self> {
        if let Some(index) = [a, b, c, d].iter().position(|q| !q.is_finite()) {
            return Err(Error::NotFinite { what: "matrix entry", index });
        }
        let m = Self { a, b, c, d };
        let defect = m.defect();
        if defect > DEFECT_LIMIT { Err(Error::NotMobius { defect, limit: DEFECT_LIMIT }) } else { Ok(m) }
    }

    /// The image `(a y + b)(c y + d)^-1` is imaginary for all imaginary y if and only if
    /// `Re((a y + b) conj(c y + d)) = 0`: a quadratic polynomial in y, zero when `Re(b d̄) = 0`, `Re(a c̄) = 0` up to
    /// the |y|² term and `Im`-part of `d̄ a - ...` vanish. Measured relative to the entries, with infinity if singular.
    fn defect(&self) -> f64 {
        let scale = |p: Quat, q: Quat| p.norm() * q.norm();
        let (a, b, c, d) = (self.a, self.b, self.c, self.d);
        // Re((a y + b)(ȳ c̄ + d̄)) = |y|² Re(a c̄) + Re(b d̄) + Re(a y d̄) - Re(b y c̄)
        //                        = ... - <y, vec(d̄ a - c̄ b)>
        let size = scale(a, c).max(scale(b, d)).max(scale(a, d)).max(scale(b, c));
        // Dieudonné determinant squared; zero when the map is constant.
        let cross = b.norm_squared() * c.norm_squared() + a.norm_squared() * d.norm_squared()
            - 2.0 * (a.conj() * b * d.conj() * c).w;
        if size == 0.0 || cross <= 1e-24 * size * size {
            return f64::INFINITY;
        }
        let mixed = (d.conj() * a - c.conj() * b).vector().length();
        a.dot(c).abs().max(b.dot(d).abs()).max(mixed) / size
    }

    /// Inversion in the sphere of the given centre and radius: `y -> o + R² (y-o)/|y-o|²`.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`.
    pub fn inversion(center: Point3, radius: f64) -> Result<Self> {
        if !center.is_finite() {
            return Err(Error::NotFinite { what: "center", index: 0 });
        }
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(Error::RadiusNotPositive { radius });
        }
        let o = Quat::from(center);
        let l = center.to_vec().length();
        // All entries over the radius: products of two lengths would leave the range of doubles early.
        let s = 1.0 / radius;
        Ok(Self { a: o * s, b: Quat::ONE * ((l - radius) * ((l + radius) * s)), c: Quat::ONE * s, d: o * -s })
    }

    /// The similarity `y -> scale · q y q^-1 + shift`.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis` (rotation zero), `radius-not-positive` (scale).
    pub fn similarity(rotation: Quat, scale: f64, shift: Vec3) -> Result<Self> {
        if !(rotation.is_finite() && shift.is_finite()) {
            return Err(Error::NotFinite { what: "similarity", index: 0 });
        }
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(Error::RadiusNotPositive { radius: scale });
        }
        let norm = rotation.norm();
        if norm == 0.0 {
            return Err(Error::ZeroAxis);
        }
        let q = rotation * (1.0 / norm);
        Ok(Self { a: q * scale, b: Quat::from(shift) * q, c: Quat::ZERO, d: q })
    }

    /// The translation by a vector.
    ///
    /// # Errors
    /// `not-finite`.
    pub fn translation(shift: Vec3) -> Result<Self> {
        Self::similarity(Quat::ONE, 1.0, shift)
    }

    /// Reflection in the plane through `origin` with the given normal.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis`.
    pub fn reflection(origin: Point3, normal: Vec3) -> Result<Self> {
        if !(origin.is_finite() && normal.is_finite()) {
            return Err(Error::NotFinite { what: "plane", index: 0 });
        }
        let unit = normal.unit().ok_or(Error::ZeroAxis)?;
        let n = Quat::from(unit);
        // y -> n (y - o) n + o = n y n + 2 <n,o> n; with d = -n, d^-1 = n: b = 2 <n,o> n d = 2<n,o>
        Ok(Self { a: n, b: Quat::ONE * (2.0 * unit.dot(origin.to_vec())), c: Quat::ZERO, d: -n })
    }

    /// This map after another one.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        Self {
            a: self.a * first.a + self.b * first.c,
            b: self.a * first.b + self.b * first.d,
            c: self.c * first.a + self.d * first.c,
            d: self.c * first.b + self.d * first.d,
        }
    }

    /// The determinant `Re(~a d + ~c b)`, a real number that is not zero; the map keeps orientation where it is positive
    /// and reverses it where it is negative (`20`, section 3). A real factor of the matrix enters squared.
    #[must_use]
    pub fn determinant(&self) -> f64 {
        self.a.dot(self.d) + self.c.dot(self.b)
    }

    /// True if the map keeps the point at infinity: a similarity, orientation-preserving or not.
    #[must_use]
    pub fn is_similarity(&self) -> bool {
        self.c == Quat::ZERO
    }

    /// The image of a homogeneous point (linear).
    #[must_use]
    pub fn map_pair(&self, p: HPoint) -> HPoint {
        HPoint { n: self.a * p.n + self.b * p.d, d: self.c * p.n + self.d * p.d }
    }

    /// The image of a point; `None` if it is the point at infinity.
    #[must_use]
    pub fn map_point(&self, p: Point3) -> Option<Point3> {
        self.map_pair(HPoint::weighted(p, Quat::ONE)).quotient().map(Quat::to_point)
    }
}

impl Mobius {
    /// The image of a tangent vector at a point: the derivative of the map applied to it,
    /// `(a - y' c) v (c y + d)^-1` with `y'` the image of `y`. Points map, vectors are pushed forward.
    /// `None` where the point goes to infinity.
    #[must_use]
    pub fn push_forward(&self, at: Point3, vector: Vec3) -> Option<Vec3> {
        let pair = self.map_pair(HPoint::weighted(at, Quat::ONE));
        let inverse = pair.d.inverse()?;
        let image = pair.n * inverse;
        let pushed = ((self.a - image * self.c) * Quat::from(vector) * inverse).vector();
        pushed.is_finite().then_some(pushed)
    }
}

/// Objects that Möbius maps take to objects of the same kind.
pub trait Conformal: Sized {
    /// The image under the map.
    ///
    /// # Errors
    /// If a part of the image would be at infinity; the variant says which.
    fn transformed(&self, map: &Mobius) -> Result<Self>;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: Point3, b: Point3, tol: f64) {
        assert!(a.distance(b) <= tol, "{a:?} {b:?}");
    }

    fn samples() -> Vec<Point3> {
        vec![Point3::new(0.3, -1.2, 2.0), Point3::new(-4.0, 0.5, 0.25), Point3::new(10.0, 7.0, -3.0)]
    }

    #[test]
    fn inversion_is_the_classical_one_and_an_involution() {
        let (o, r) = (Point3::new(1.0, -2.0, 0.5), 1.75);
        let m = Mobius::inversion(o, r).unwrap();
        for p in samples() {
            let v = p - o;
            let image = m.map_point(p).unwrap();
            close(image, o + v * (r * r / v.length_squared()), 1e-14);
            close(m.map_point(image).unwrap(), p, 1e-13);
            close(m.after(&m).map_point(p).unwrap(), p, 1e-13);
        }
        assert!(m.map_point(o).is_none(), "the centre goes to infinity");
    }

    #[test]
    fn reflection_and_similarity_are_the_classical_ones() {
        let (o, n) = (Point3::new(1.0, 2.0, 3.0), Vec3::new(1.0, 2.0, -2.0) / 3.0);
        let mirror = Mobius::reflection(o, n * 7.0).unwrap();
        let (q, s, v) = (Quat::from_axis_angle(n, 0.7), 2.5, Vec3::new(-1.0, 4.0, 0.25));
        let turn = Mobius::similarity(q * 3.0, s, v).unwrap();
        for p in samples() {
            close(mirror.map_point(p).unwrap(), p - n * (2.0 * n.dot(p - o)), 1e-14);
            close(turn.map_point(p).unwrap(), Point3::ORIGIN + q.rotate(p.to_vec()) * s + v, 1e-13);
            close(
                turn.after(&mirror).map_point(p).unwrap(),
                turn.map_point(mirror.map_point(p).unwrap()).unwrap(),
                1e-13,
            );
        }
    }

    #[test]
    fn vectors_are_pushed_forward_by_the_derivative() {
        let m = Mobius::inversion(Point3::new(1.0, -2.0, 0.5), 3.0).unwrap();
        let m = m.after(&Mobius::similarity(Quat::new(1.0, 2.0, -1.0, 0.5), 0.3, Vec3::X).unwrap());
        for p in samples() {
            let (v, h) = (Vec3::new(0.5, -1.0, 2.0), 1e-5);
            let difference = (m.map_point(p + v * h).unwrap() - m.map_point(p - v * h).unwrap()) / (2.0 * h);
            let pushed = m.push_forward(p, v).unwrap();
            // Central difference: h² = 1e-10 relative, rounding 1e-16/h.
            assert!((difference - pushed).length() < 1e-8 * pushed.length());
        }
    }

    #[test]
    fn only_matrices_that_keep_space_are_accepted() {
        let m = Mobius::inversion(Point3::new(1.0, -2.0, 0.5), 3.0).unwrap();
        let m = m.after(&Mobius::similarity(Quat::new(1.0, 2.0, -1.0, 0.5), 0.3, Vec3::X).unwrap());
        // A common real or quaternionic gauge factor on the left of all entries is also a Möbius matrix only if the
        // image stays imaginary: real factors do.
        let s = 1e3;
        assert!(Mobius::from_matrix(m.a * s, m.b * s, m.c * s, m.d * s).is_ok());
        let q = Quat::new(0.5, -1.0, 2.0, 0.25);
        let wrong = Mobius::from_matrix(q, Quat::ONE, Quat::new(0.0, 1.0, 0.0, 0.0), q);
        assert_eq!(wrong.unwrap_err().reason(), "not-mobius");
        let constant = Mobius::from_matrix(Quat::ONE, Quat::ONE, Quat::ONE, Quat::ONE);
        assert_eq!(constant.unwrap_err().reason(), "not-mobius");
        assert!(Mobius::from_matrix(Quat::new(f64::NAN, 0.0, 0.0, 0.0), Quat::ONE, Quat::ONE, Quat::ONE).is_err());
    }
}
