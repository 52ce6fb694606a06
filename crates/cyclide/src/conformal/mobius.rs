//! Möbius transformations as 2×2 quaternion matrices that keep three-space, between two origins.
//!
//! ```text
//! y -> target + (a x + b)(c x + d)^-1,   x = y - source
//! ```
//! Every Möbius map of three-space has this form, the orientation-reversing ones too, because `x` is purely
//! imaginary: inversion in the sphere of center `o` and radius `R` is `o - R (x/R)^-1 = o + R² x/|x|²` with
//! both origins in `o`, reflection in the plane with unit normal `n` through `o` is `o + (n x)(-n)^-1`.
//!
//! One origin for all maps would lose them: the matrix of an inversion far away, `(o, R² - |o|²; 1, -o)`, holds `R²` as a
//! difference of numbers larger by `|o|²/R²`. Between origins of its own it is `(0, -R; 1/R, 0)` wherever it stands,
//! and images are wrong by rounding of the coordinates only.

use super::hpoint::HPoint;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, PointError, Result};

/// Largest relative distance from three-space that counts as rounding of the matrix.
const DEFECT_LIMIT: f64 = 1e-9;

/// Parts of a determinant, relative to its terms, that are nothing but their rounding.
const SINGULAR_LIMIT: f64 = 8.0 * f64::EPSILON;

/// Part of its terms up to which the entry that takes a place to infinity is their rounding: those of two products of quaternions, one of them
/// with a sum, and of what went into their factors.
const NOT_A_POLE: f64 = 8.0 * f64::EPSILON;

/// A Möbius transformation of three-space and the point at infinity.
///
/// ```
/// use cyclide::{Point3, conformal::Mobius};
/// let inversion = Mobius::inversion(Point3::ORIGIN, 2.0)?;
/// assert_eq!(inversion.map_point(Point3::new(1.0, 0.0, 0.0)), Some(Point3::new(4.0, 0.0, 0.0)));
/// assert_eq!(inversion.map_point(Point3::ORIGIN), None); // it goes to infinity
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mobius {
    source: Point3,
    target: Point3,
    a: Quat,
    b: Quat,
    c: Quat,
    d: Quat,
    /// `Re(~a d + ~c b)`, as a product over the maps composed: from the entries it may cancel.
    determinant: f64,
}

impl Mobius {
    /// The identity.
    pub const IDENTITY: Self = Self {
        source: Point3::ORIGIN,
        target: Point3::ORIGIN,
        a: Quat::ONE,
        b: Quat::ZERO,
        c: Quat::ZERO,
        d: Quat::ONE,
        determinant: 1.0,
    };

    /// The map `y -> (a y + b)(c y + d)^-1`.
    ///
    /// It keeps three-space if `Re(a ~c) = 0`, `Re(b ~d) = 0` and `~a d + ~c b` is real and not zero
    /// (`docs/math/conformal.md#pairs-and-maps`). The defect is the largest of the first two relative to `|a||c|`,
    /// `|b||d|` and of the imaginary part of the third relative to its real part: neither a unit of length nor a
    /// translation changes what it says of the map. Entries that are rounded determine the map to `ε |a||d|` relative
    /// to that determinant only, which far from the origin is `ε |o|²/R²`: compose such maps with
    /// [`after`](Self::after) instead.
    ///
    /// # Errors
    /// `not-finite`; `not-mobius` if it is singular or does not keep three-space (relative defect above 1e-9).
    pub fn from_matrix(a: Quat, b: Quat, c: Quat, d: Quat) -> Result<Self> {
        if let Some(index) = [a, b, c, d].iter().position(|q| !q.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::MatrixEntry, index }.into());
        }
        let (real, mixed) = (a.dot(d) + c.dot(b), (d.conj() * a - c.conj() * b).vector().length());
        let size = |p: Quat, q: Quat| p.norm() * q.norm();
        let part = |p: Quat, q: Quat| if size(p, q) == 0.0 { 0.0 } else { p.dot(q).abs() / size(p, q) };
        let regular = real.is_finite() && real.abs() > SINGULAR_LIMIT * (size(a, d) + size(b, c));
        let defect = if regular { part(a, c).max(part(b, d)).max(mixed / real.abs()) } else { f64::INFINITY };
        if !(defect <= DEFECT_LIMIT) {
            return Err(PointError::NotMobius { defect, limit: DEFECT_LIMIT }.into());
        }
        let map = Self { a, b, c, d, determinant: real, ..Self::IDENTITY };
        Ok(if size(a, d) > 2.0 * real.abs() { map.between_poles().unwrap_or(map) } else { map })
    }

    /// The same map with its origins in the point that goes to infinity and in the image of infinity, where the matrix
    /// is `(0, Λ c/|c|²; c, 0)` with the determinant `Λ`: better where those points are near, against the radius of
    /// the sphere that the map inverts in, and worse where they are far, as for a map next to a similarity.
    fn between_poles(&self) -> Option<Self> {
        let inverse = self.c.inverse()?;
        let (source, target) = (self.source - (inverse * self.d).vector(), self.target + (self.a * inverse).vector());
        let (a, b, d) = (Quat::ZERO, inverse.conj() * self.determinant, Quat::ZERO);
        let found = Self { source, target, a, b, d, ..*self };
        (source.is_finite() && target.is_finite() && b.is_finite()).then_some(found)
    }

    /// The map `y -> target + (a x + b)(c x + d)^-1`, `x = y - source`, with a determinant that is known.
    pub(super) const fn between(source: Point3, target: Point3, [a, b, c, d]: [Quat; 4], determinant: f64) -> Self {
        Self { source, target, a, b, c, d, determinant }
    }

    /// Inversion in the sphere of the given center and radius: `y -> o + R² (y-o)/|y-o|²`.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`.
    pub fn inversion(center: Point3, radius: f64) -> Result<Self> {
        if !center.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Center, index: 0 }.into());
        }
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index: 0, radius }.into());
        }
        // Entries of size R and 1/R: R² would leave the range of doubles early.
        let (b, c) = (Quat::ONE * -radius, Quat::ONE * (1.0 / radius));
        Ok(Self { source: center, target: center, a: Quat::ZERO, b, c, d: Quat::ZERO, determinant: -1.0 })
    }

    /// The similarity `y -> scale · q y q^-1 + shift`.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis` (rotation zero), `scale-not-positive`.
    pub fn similarity(rotation: Quat, scale: f64, shift: Vec3) -> Result<Self> {
        if !(rotation.is_finite() && shift.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Similarity, index: 0 }.into());
        }
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(NumberError::ScaleNotPositive { factor: scale }.into());
        }
        let norm = rotation.norm();
        if norm == 0.0 {
            return Err(Error::zero_axis(ErrorItem::Rotation));
        }
        let q = rotation * (1.0 / norm);
        Ok(Self { target: Point3::ORIGIN + shift, a: q * scale, d: q, determinant: scale, ..Self::IDENTITY })
    }

    /// The rotation about the axis through `origin` along `axis`, which may have any length, right-handed.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis`.
    pub fn rotation(origin: Point3, axis: Vec3, angle: f64) -> Result<Self> {
        if !(origin.is_finite() && axis.is_finite() && angle.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Rotation, index: 0 }.into());
        }
        Self::rotation_about_unit(origin, axis.unit().ok_or(Error::zero_axis(ErrorItem::Axis))?, angle)
    }

    /// As [`rotation`](Self::rotation), about a unit vector, of which no bit changes.
    ///
    /// # Errors
    /// `not-finite`.
    pub(crate) fn rotation_about_unit(origin: Point3, axis: Vec3, angle: f64) -> Result<Self> {
        let (turn, center) = (Quat::from_axis_angle(axis, angle), origin.to_vec());
        Self::similarity(turn, 1.0, center - turn.rotate(center))
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
            return Err(NumberError::NotFinite { what: ErrorItem::Plane, index: 0 }.into());
        }
        let n = Quat::from(normal.unit().ok_or(Error::zero_axis(ErrorItem::Normal))?);
        // (n x)(-n)^-1 = n x n
        Ok(Self { source: origin, target: origin, a: n, d: -n, determinant: -1.0, ..Self::IDENTITY })
    }

    /// This map after another one.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        // From the target of the first to the source of this one.
        let between = Quat::from(first.target - self.source);
        let (b, d) = (self.a * between + self.b, self.c * between + self.d);
        let c = self.c * first.a + d * first.c;
        // What is left of terms that cancel, and of origins that are rounded, is no place that goes to infinity: the map is a similarity.
        let reach = first.target.to_vec().length() + self.source.to_vec().length();
        let terms = self.c.norm() * first.a.norm() + (self.c.norm() * reach + self.d.norm()) * first.c.norm();
        let c = if c.norm() <= NOT_A_POLE * terms { Quat::ZERO } else { c };
        Self {
            source: first.source,
            target: self.target,
            a: self.a * first.a + b * first.c,
            b: self.a * first.b + b * first.d,
            c,
            d: self.c * first.b + d * first.d,
            determinant: self.determinant * first.determinant,
        }
    }

    /// The inverse map, by the conjugates of the entries: `(~d, ~b; ~c, ~a)(a, b; c, d)` is the determinant.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let (a, b, c, d) = (self.d.conj(), self.b.conj(), self.c.conj(), self.a.conj());
        Self { source: self.target, target: self.source, a, b, c, d, determinant: self.determinant }
    }

    /// The determinant `Re(~a d + ~c b)`, a real number that is not zero; the map keeps orientation where it is positive
    /// and reverses it where it is negative (`docs/math/conformal.md#pairs-and-maps`). A real factor of the matrix
    /// enters squared.
    #[must_use]
    pub fn determinant(&self) -> f64 {
        self.determinant
    }

    /// The entries `a, b, c, d`, between the origins.
    #[must_use]
    pub(crate) fn matrix(&self) -> [Quat; 4] {
        [self.a, self.b, self.c, self.d]
    }

    /// The origins before and after the map.
    #[must_use]
    pub(crate) fn origins(&self) -> [Point3; 2] {
        [self.source, self.target]
    }

    /// True if the map keeps the point at infinity: a similarity, orientation-preserving or not.
    #[must_use]
    pub fn is_similarity(&self) -> bool {
        self.c == Quat::ZERO
    }

    /// Refuses a map that is no similarity.
    ///
    /// # Errors
    /// `not-a-similarity`.
    pub(crate) fn check_similarity(&self) -> Result<()> {
        if self.is_similarity() {
            return Ok(());
        }
        Err(PointError::NotASimilarity { measured: self.c.norm(), limit: 0.0 }.into())
    }

    /// The image of a homogeneous point (linear), infinity included.
    #[must_use]
    pub fn map_pair(&self, p: HPoint) -> HPoint {
        let x = p.n - Quat::from(self.source) * p.d;
        let d = self.c * x + self.d * p.d;
        HPoint { n: self.a * x + self.b * p.d + Quat::from(self.target) * d, d }
    }

    /// The image of a point and the factor of the weights there: the pair `(y w, w)` of the point `y` goes to
    /// `(y' f w, f w)` with the factor `f = c x + d`. `None` if it is the point at infinity.
    #[must_use]
    pub fn map_weighted(&self, p: Point3) -> Option<(Point3, Quat)> {
        let x = Quat::from(p - self.source);
        let local = HPoint { n: self.a * x + self.b, d: self.c * x + self.d };
        let image = self.target + local.quotient()?.vector();
        image.is_finite().then_some((image, local.d))
    }

    /// The image of a point; `None` if it is the point at infinity.
    #[must_use]
    pub fn map_point(&self, p: Point3) -> Option<Point3> {
        self.map_weighted(p).map(|(image, _)| image)
    }

    /// The image of a tangent vector at a point: the derivative of the map applied to it, `Λ ~f^-1 v f^-1` with the
    /// [determinant](Self::determinant) `Λ` and the factor `f` of the weights at the point. Points map, vectors are
    /// pushed forward. `None` where the point goes to infinity.
    #[must_use]
    pub fn push_forward(&self, at: Point3, vector: Vec3) -> Option<Vec3> {
        let (_, factor) = self.map_weighted(at)?;
        let length = factor.norm();
        let pushed = (factor * (1.0 / length)).rotate(vector) * (self.determinant / length / length);
        pushed.is_finite().then_some(pushed)
    }
}

/// Objects that Möbius maps take to objects of the same kind.
///
/// ```
/// use cyclide::{Point3, conformal::{Conformal, Mobius}, curve::Arc};
/// let segment = Arc::segment(Point3::new(1.0, -1.0, 0.0), Point3::new(1.0, 1.0, 0.0))?;
/// let image = segment.transformed(&Mobius::inversion(Point3::ORIGIN, 1.0)?)?;
/// assert!((image.radius().expect("a circle") - 0.5).abs() < 1e-15); // lines become circles
/// # Ok::<(), cyclide::Error>(())
/// ```
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
    fn images_far_from_the_origin_are_wrong_by_the_rounding_of_coordinates() {
        let turn = Mobius::similarity(Quat::new(1.0, 2.0, -1.0, 0.5), 0.3, Vec3::X).unwrap();
        for distance in [1e3, 1e6, 1e9] {
            let o = Point3::ORIGIN + Vec3::new(0.48, -0.6, 0.64) * distance;
            let inversion = Mobius::inversion(o, 2.0).unwrap();
            let [there, back] = [o.to_vec(), -o.to_vec()].map(|v| Mobius::translation(v).unwrap());
            let at_the_origin = Mobius::inversion(Point3::ORIGIN, 2.0).unwrap();
            let conjugated = there.after(&at_the_origin).after(&back);
            // A few operations on numbers of the size of the distance; what lies near the center is magnified by
            // the square of 2 over its distance, here at most 4.
            let rounding = 16.0 * f64::EPSILON * distance;
            for v in [Vec3::new(0.6, -1.2, 2.0), Vec3::new(-1.0, 0.5, 0.25), Vec3::new(0.1, 1.0, -0.3)] {
                let p = o + v;
                let v = p - o;
                let image = o + v * (4.0 / v.length_squared());
                close(inversion.map_point(p).unwrap(), image, rounding);
                close(conjugated.map_point(p).unwrap(), image, rounding);
                close(inversion.inverse().map_point(image).unwrap(), p, 4.0 * rounding);
                let both = turn.after(&inversion);
                close(both.map_point(p).unwrap(), turn.map_point(image).unwrap(), rounding);
                close(both.inverse().map_point(both.map_point(p).unwrap()).unwrap(), p, 8.0 * rounding);
                // v - 2 <v,x> x/|x|², the mirror image, times R²/|x|²: of numbers of the size of 1.
                let u = Vec3::new(0.3, 0.7, -0.2);
                let want = (u - v * (2.0 * u.dot(v) / v.length_squared())) * (4.0 / v.length_squared());
                assert!((inversion.push_forward(p, u).unwrap() - want).length() < 1e-14);
            }
            assert_eq!((inversion.determinant(), conjugated.determinant()), (-1.0, -1.0));
            assert!((turn.after(&inversion).determinant() + 0.3).abs() < 1e-16);
            assert!(inversion.after(&inversion).is_similarity());
        }
    }

    #[test]
    fn inverses_undo_maps_on_both_sides() {
        let inversion = Mobius::inversion(Point3::new(1.0, -2.0, 0.5), 3.0).unwrap();
        let turn = Mobius::similarity(Quat::new(1.0, 2.0, -1.0, 0.5), 0.3, Vec3::X).unwrap();
        let mirror = Mobius::reflection(Point3::new(1.0, 2.0, 3.0), Vec3::new(1.0, 2.0, -2.0)).unwrap();
        for map in [inversion, turn, mirror, turn.after(&inversion), mirror.after(&inversion).after(&turn)] {
            for p in samples() {
                close(map.inverse().after(&map).map_point(p).unwrap(), p, 1e-12);
                close(map.after(&map.inverse()).map_point(p).unwrap(), p, 1e-12);
                close(map.inverse().map_point(map.map_point(p).unwrap()).unwrap(), p, 1e-12);
                // Pairs map as points and weights do.
                let pair = map.map_pair(HPoint::weighted(p, Quat::new(0.5, -1.0, 2.0, 0.25)));
                close(pair.quotient().unwrap().to_point(), map.map_point(p).unwrap(), 1e-13);
            }
        }
        // Infinity goes to the center.
        let infinity = HPoint { n: Quat::ONE, d: Quat::ZERO };
        close(inversion.map_pair(infinity).quotient().unwrap().to_point(), Point3::new(1.0, -2.0, 0.5), 1e-15);
    }

    /// The matrix `(o, R² - |o|²; 1, -o)` of the inversion with center `o` on the x-axis, and `R = 1`.
    fn matrix(o: f64) -> [Quat; 4] {
        let x = Quat::new(0.0, o, 0.0, 0.0);
        [x, Quat::ONE * (o * o - 1.0), Quat::ONE, -x]
    }

    #[test]
    fn matrices_are_judged_alike_wherever_their_spheres_stand() {
        for o in [0.0, 1.0, 1024.0, 1_048_576.0, 1_000_003.0] {
            // Exact in doubles: so is the map.
            let [a, b, c, d] = matrix(o);
            let map = Mobius::from_matrix(a, b, c, d).unwrap();
            for v in [Vec3::new(0.5, 0.0, 0.0), Vec3::new(-1.0, 0.5, 2.0)] {
                let o = Point3::new(o, 0.0, 0.0);
                close(map.map_point(o + v).unwrap(), o + v / v.length_squared(), 4.0 * f64::EPSILON * (1.0 + o.x));
            }
            // Of points whose products with the entries are rounded the map is as good: relative to their place.
            for v in [Vec3::new(0.3, 0.1, -0.7), Vec3::new(-1.1, 0.6, 0.2)] {
                let o = Point3::new(o, 0.0, 0.0);
                let p = o + v;
                let v = p - o;
                close(map.map_point(p).unwrap(), o + v / v.length_squared(), 16.0 * f64::EPSILON * (1.0 + o.x));
            }
            // The same part of the sphere's size off three-space is refused everywhere, against the determinant 1: the
            // imaginary part of ~a d + ~c b.
            let off = Quat::new(0.0, 0.0, 1e-6, 0.0);
            let refused = Mobius::from_matrix(a, b + off, c, d).unwrap_err();
            assert_eq!(refused.reason(), "not-mobius", "{o}");
        }
        // A unit of length changes nothing: (a, L b; c/L, d).
        for unit in [1e-20, 1.0, 1e20] {
            let [a, b, c, d] = matrix(2.0);
            let scaled = |off: f64| Mobius::from_matrix(a, (b + Quat::ONE * off) * unit, c * (1.0 / unit), d);
            assert!(scaled(0.0).is_ok());
            let tilted = a + Quat::ONE * 1e-6;
            assert!(Mobius::from_matrix(tilted, b * unit, c * (1.0 / unit), d).is_err(), "{unit:e}");
        }
        // Rounding of a similarity leaves a pole far away, which must not become the origin.
        let turn = Quat::from_axis_angle(Vec3::Z, 0.7);
        let c = Quat::new(0.0, 0.0, 0.0, 1e-17) * turn;
        let nearly = Mobius::from_matrix(turn, Quat::ZERO, c, turn).unwrap();
        close(
            nearly.map_point(Point3::new(1.0, 2.0, 3.0)).unwrap(),
            Point3::ORIGIN + turn.rotate(Vec3::new(1.0, 2.0, 3.0)),
            1e-14,
        );
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
