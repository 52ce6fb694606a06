//! The implicit equation: a quartic, the discriminant of the tangent spheres
//! (`docs/math/patches.md#implicit-equation`).

use super::{CyclidePatch, PatchKind};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};

/// Coefficients of the highest terms that are this part of the largest are zero.
const DEGREE_LIMIT: f64 = 1e-10;

/// The polynomial whose zeros are the surface of a patch.
///
/// ```
/// use cyclide::surface::{DupinCyclide, ParamSurface};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let patch = torus.patch(0, 0);
/// assert!(patch.implicit_form().value(patch.point(0.3, 0.6)).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ImplicitForm {
    /// A plane or sphere, `c0 |p|² + c1 x + c2 y + c3 z + c4 = 0`, with `c0 = 0` for a plane; the largest coefficient
    /// is 1. (The quartic of the construction would be a multiple of its square.)
    Sphere([f64; 5]),
    /// Any other cyclide: a polynomial in `ρ = x² + y² + z²` and the coordinates.
    Quartic {
        /// Coefficients of `ρ², ρx, ρy, ρz, x², xy, xz, y², yz, z², x, y, z, 1`; the one of largest absolute value is 1.
        coefficients: [f64; 14],
        /// 4; 3 where the surface contains the point at infinity; 2 for cylinders and cones.
        degree: u32,
    },
}

impl ImplicitForm {
    /// The value of the polynomial at a point. Far from the origin it is a small difference of large terms:
    /// [`CyclidePatch::implicit_at`] is not.
    #[must_use]
    pub fn value(&self, p: Point3) -> f64 {
        let rho = p.to_vec().length_squared();
        match *self {
            Self::Sphere([a, b, c, d, e]) => a * rho + Vec3::new(b, c, d).dot(p.to_vec()) + e,
            Self::Quartic { coefficients: c, .. } => {
                let cubic = c[0] * rho + c[1] * p.x + c[2] * p.y + c[3] * p.z;
                let square = p.x * (c[4] * p.x + c[5] * p.y + c[6] * p.z) + p.y * (c[7] * p.y + c[8] * p.z);
                rho * cubic + square + c[9] * p.z * p.z + c[10] * p.x + c[11] * p.y + c[12] * p.z + c[13]
            }
        }
    }
}

impl ImplicitForm {
    /// The same equation with a largest coefficient of 1.
    pub(in crate::surface) fn normalized(self) -> Self {
        match self {
            Self::Sphere(c) => Self::Sphere(c.map(|x| x / largest(&c))),
            Self::Quartic { coefficients: c, degree } => {
                Self::Quartic { coefficients: c.map(|x| x / largest(&c)), degree }
            }
        }
    }
}

/// A function `a |p|² + b·p + c`, zero on a sphere or plane.
#[derive(Debug, Clone, Copy)]
struct SphereFunction {
    a: f64,
    b: Vec3,
    c: f64,
}

impl SphereFunction {
    fn sum(self, other: Self) -> Self {
        Self { a: self.a + other.a, b: self.b + other.b, c: self.c + other.c }
    }

    fn scaled(self, k: f64) -> Self {
        Self { a: self.a * k, b: self.b * k, c: self.c * k }
    }

    /// The function of `p` that is `size²` times this one of `(p - origin)/size`.
    fn placed(self, origin: Point3, size: f64) -> Self {
        let o = origin.to_vec();
        let b = self.b * size;
        Self { a: self.a, b: b - o * (2.0 * self.a), c: self.a * o.length_squared() - b.dot(o) + self.c * size * size }
    }

    /// The coefficients of the product of two.
    fn product(self, o: Self) -> [f64; 14] {
        let cubic = o.b * self.a + self.b * o.a;
        let round = self.a * o.c + self.c * o.a;
        let linear = o.b * self.c + self.b * o.c;
        let (p, q) = (self.b, o.b);
        [
            self.a * o.a,
            cubic.x,
            cubic.y,
            cubic.z,
            p.x * q.x + round,
            p.x * q.y + p.y * q.x,
            p.x * q.z + p.z * q.x,
            p.y * q.y + round,
            p.y * q.z + p.z * q.y,
            p.z * q.z + round,
            linear.x,
            linear.y,
            linear.z,
            self.c * o.c,
        ]
    }
}

/// `B² - A C`.
fn discriminant([a, b, c]: [SphereFunction; 3]) -> [f64; 14] {
    let (square, product) = (b.product(b), a.product(c));
    std::array::from_fn(|i| square[i] - product[i])
}

fn largest(c: &[f64]) -> f64 {
    c.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(1.0)
}

impl CyclidePatch {
    /// The implicit equation of the whole surface on which the patch lies, in the coordinates of the model. The spheres
    /// tangent along the s-lines are `A (1-t)² + 2B t(1-t) + C t²` with sphere functions A, B, C of the point; the
    /// surface is where two of them meet, `B² - AC = 0` (`docs/math/patches.md#implicit-equation`).
    ///
    /// Rounding: some units of the last place of the largest coefficient for coordinates of the size of the patch,
    /// times (coordinate/size)⁴ far from the origin.
    #[must_use]
    pub fn implicit_form(&self) -> ImplicitForm {
        match self.recognize() {
            PatchKind::Plane { frame } => {
                let n = frame.z();
                return ImplicitForm::Sphere([0.0, n.x, n.y, n.z, -n.dot(frame.origin().to_vec())]).normalized();
            }
            PatchKind::Sphere { frame, radius, .. } => return sphere_form(frame.origin(), radius),
            _ => {}
        }
        let spheres = self.tangent_spheres();
        // The degree is a matter of the shape: judged in the units of the patch.
        let local = discriminant(spheres);
        let limit = DEGREE_LIMIT * largest(&local).abs();
        let vanish = |range: std::ops::Range<usize>| local[range].iter().all(|c| c.abs() <= limit);
        let degree = match (vanish(0..1), vanish(1..4)) {
            (false, _) => 4,
            (true, false) => 3,
            (true, true) => 2,
        };
        let mut coefficients = discriminant(spheres.map(|f| f.placed(self.corners[0], self.scale)));
        coefficients[..[4, 1, 0][degree as usize - 2]].fill(0.0);
        ImplicitForm::Quartic { coefficients, degree }.normalized()
    }

    /// The quartic `B² - AC` at a point, relative to the size of the patch: zero exactly on the whole surface (for a
    /// plane or sphere it is the square of its equation, up to a factor). Dimensionless; without cancellation far from
    /// the origin, unlike the coefficients of [`implicit_form`](Self::implicit_form).
    #[must_use]
    pub fn implicit_at(&self, p: Point3) -> f64 {
        let [a, b, c] = self.sphere_values(&self.pencils(p), self.v[1], [(0, 1), (2, 3), (0, 3), (2, 1)]);
        b * b - a * c
    }

    /// `e_k = (a_k - p) w_k` in units of the size.
    pub(super) fn pencils(&self, p: Point3) -> [Quat; 4] {
        let x = Quat::from((p - self.corners[0]) / self.scale);
        std::array::from_fn(|k| self.n[k] - x * self.weights[k])
    }

    /// The values `A, B, C` of one family of tangent spheres from the pairs of corners of `A`, of `C` and of `B`.
    pub(super) fn sphere_values(&self, e: &[Quat; 4], v: Vec3, [a, c, b0, b1]: [(usize, usize); 4]) -> [f64; 3] {
        let g = |(i, j): (usize, usize)| polar_product(e[i], e[j], v);
        [g(a), 0.5 * (g(b0) + g(b1)), g(c)]
    }

    /// The spheres tangent along the s-lines as functions of `(p - a0)/size`.
    fn tangent_spheres(&self) -> [SphereFunction; 3] {
        let g = |i: usize, j: usize| {
            // v·Im(~e_i e_j) with e = n - x w, by powers of x: x² = -|x|².
            let (v, n, w) = (self.v[1], &self.n, &self.weights);
            let along = |unit: Vec3| {
                let x = Quat::from(unit);
                -polar_product(x * w[i], n[j], v) - polar_product(n[i], x * w[j], v)
            };
            SphereFunction {
                a: polar_product(w[i], w[j], v),
                b: Vec3::new(along(Vec3::X), along(Vec3::Y), along(Vec3::Z)),
                c: polar_product(n[i], n[j], v),
            }
        };
        [g(0, 1), g(0, 3).sum(g(2, 1)).scaled(0.5), g(2, 3)]
    }
}

/// `v·Im(~p q)`.
pub(super) fn polar_product(p: Quat, q: Quat, v: Vec3) -> f64 {
    v.dot((p.conj() * q).vector())
}

/// The equation of a sphere.
pub(in crate::surface) fn sphere_form(center: Point3, radius: f64) -> ImplicitForm {
    let c = center.to_vec();
    let (far, near) = (c.length() + radius, c.length() - radius);
    ImplicitForm::Sphere([1.0, -2.0 * c.x, -2.0 * c.y, -2.0 * c.z, far * near]).normalized()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equation_of_a_torus() {
        // (ρ + R² - r²)² = 4R²(x² + y²) with R = 2, r = 1.
        let at = |u: f64, v: f64| {
            let rho = 2.0 + v.cos();
            Point3::new(rho * u.cos(), rho * u.sin(), v.sin())
        };
        let corners = [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 2.0), at(1.0, 2.0)];
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
        let ImplicitForm::Quartic { coefficients, degree } = patch.implicit_form() else { panic!("a torus") };
        // ρ² + 6ρ + 9 - 16(x² + y²), over the largest, -10.
        let want = [1.0, 0.0, 0.0, 0.0, -10.0, 0.0, 0.0, -10.0, 0.0, 6.0, 0.0, 0.0, 0.0, 9.0].map(|c| c / -10.0);
        assert_eq!(degree, 4);
        for (got, want) in coefficients.iter().zip(want) {
            assert!((got - want).abs() < 1e-14, "{coefficients:?}");
        }
    }

    #[test]
    fn degrees() {
        // A cone about z: x² + y² = (z - 3)².
        let cone = [(2.0, 0.0, 1.0), (0.0, 2.0, 1.0), (1.0, 0.0, 2.0), (0.0, 1.0, 2.0)];
        let slope = Vec3::new(-1.0, 0.0, 1.0).unit().unwrap();
        let corners = cone.map(|(x, y, z)| Point3::new(x, y, z));
        let cone = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, slope).unwrap();
        let ImplicitForm::Quartic { coefficients, degree } = cone.implicit_form() else { panic!("a cone") };
        assert_eq!(degree, 2);
        let want = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 6.0, -9.0].map(|c| c / -9.0);
        for (got, want) in coefficients.iter().zip(want) {
            assert!((got - want).abs() < 1e-13, "{coefficients:?}");
        }
        // A sphere of radius 2 about (1, 0, 0).
        let sphere = [(3.0, 0.0, 0.0), (1.0, 2.0, 0.0), (1.0, 0.0, 2.0), (1.0, 0.0, 2.0)];
        let corners = sphere.map(|(x, y, z)| Point3::new(x, y, z));
        let sphere = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
        let ImplicitForm::Sphere(c) = sphere.implicit_form() else { panic!("a sphere") };
        for (got, want) in c.iter().zip([1.0, -2.0, 0.0, 0.0, -3.0]) {
            assert!((got * -3.0 - want).abs() < 1e-14, "{c:?}");
        }
    }
}
