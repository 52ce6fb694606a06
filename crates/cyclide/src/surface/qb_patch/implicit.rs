//! The implicit equation: a quartic, the determinant of the four pencils (`docs/math/bilinear-patches.md#which-surface`).

use super::{QbPatch, QbPatchKind};
use crate::base::elimination::null_vector;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::surface::ParamSurface as _;
use crate::surface::patch::{ImplicitForm, sphere_form};

/// The monomials of a [`ImplicitForm::Quartic`].
const TERMS: usize = 14;
/// Coefficients of the highest terms that are this part of the largest are zero.
const DEGREE_LIMIT: f64 = 1e-10;

impl QbPatch {
    /// The implicit equation of the whole surface on which the patch lies, in the coordinates of the model. In general it is the quartic
    /// `det(e0, e1, e2, e3)`, `e_k = (a_k - p) w_k` as columns of four numbers, a Darboux cyclide. Where that vanishes identically the
    /// surface is a sphere or an inverted quadric, whose equation is found from 13 of its points. `None` where these do not determine it.
    ///
    /// Rounding: some units of the last place of the largest coefficient for coordinates of the size of the patch, times
    /// (coordinate/size)⁴ far from the origin.
    #[must_use]
    pub fn implicit_form(&self) -> Option<ImplicitForm> {
        let local = match self.recognize() {
            QbPatchKind::Sphere { center, radius } => return Some(sphere_form(center, radius)),
            QbPatchKind::Plane { normal } => {
                let offset = -normal.dot(self.corners[0].to_vec());
                return Some(ImplicitForm::Sphere([0.0, normal.x, normal.y, normal.z, offset]).normalized());
            }
            QbPatchKind::InvertedQuadric => self.fitted()?,
            QbPatchKind::Dupin | QbPatchKind::Darboux => self.determinant(),
        };
        let largest = local.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
        let vanish = |range: std::ops::Range<usize>| local[range].iter().all(|c| c.abs() <= DEGREE_LIMIT * largest);
        let degree = match (vanish(0..1), vanish(1..4)) {
            (false, _) => 4,
            (true, false) => 3,
            (true, true) => 2,
        };
        let mut coefficients = placed(local, self.corners[0].to_vec(), self.scale);
        coefficients[..[4, 1, 0][degree as usize - 2]].fill(0.0);
        Some(ImplicitForm::Quartic { coefficients, degree }.normalized())
    }

    /// The quartic `det(e0, e1, e2, e3)` at a point, relative to the size of the patch: zero exactly on the whole surface, and everywhere
    /// where the surface is an inverted quadric. Dimensionless; without cancellation far from the origin.
    #[must_use]
    pub fn implicit_at(&self, p: Point3) -> f64 {
        determinant(self.pencils(p))
    }

    /// `e_k = (a_k - p) w_k` in units of the size.
    pub(super) fn pencils(&self, p: Point3) -> [Quat; 4] {
        let x = Quat::from((p - self.corners[0]) / self.scale);
        std::array::from_fn(|k| self.n[k] - x * self.weights[k])
    }

    /// The coefficients of the determinant as a polynomial of `(p - a0)/size`: it is linear in each column, and a column is linear in the
    /// coordinates.
    fn determinant(&self) -> [f64; TERMS] {
        let columns = [0, 1, 2, 3].map(|k| {
            let along = |axis: Vec3| -(Quat::from(axis) * self.weights[k]);
            [self.n[k], along(Vec3::X), along(Vec3::Y), along(Vec3::Z)]
        });
        let mut out = [0.0; TERMS];
        for choice in 0..256_usize {
            let parts = [0, 1, 2, 3].map(|k| choice >> (2 * k) & 3);
            let mut powers = [0; 4];
            parts.iter().for_each(|part| powers[*part] += 1);
            if let Some(term) = term(powers) {
                out[term] += determinant(std::array::from_fn(|k| columns[k][parts[k]]));
            }
        }
        out
    }

    /// The coefficients as a polynomial of `(p - a0)/size` from points of the surface; `None` unless they are the only ones.
    fn fitted(&self) -> Option<[f64; TERMS]> {
        // No two of them on one parameter line.
        let rows: [[f64; TERMS]; TERMS - 1] = std::array::from_fn(|k| {
            let (s, t) = ((k as f64 + 0.5) / 13.0, ((5 * k) as f64 % 13.0 + 0.5) / 13.0);
            let q = (self.point(s, t) - self.corners[0]) / self.scale;
            let rho = q.length_squared();
            let square = [q.x * q.x, q.x * q.y, q.x * q.z, q.y * q.y, q.y * q.z, q.z * q.z];
            let [xx, xy, xz, yy, yz, zz] = square;
            [rho * rho, rho * q.x, rho * q.y, rho * q.z, xx, xy, xz, yy, yz, zz, q.x, q.y, q.z, 1.0]
        });
        let (coefficients, ratio) = null_vector(rows)?;
        (ratio > DEGREE_LIMIT).then_some(coefficients)
    }
}

/// The term that a monomial belongs to, from how often 1, x, y, z are factors: of those of degree 3 and 4, which come as multiples of
/// `x² + y² + z²`, one each; `None` for the others.
fn term([ones, x, y, z]: [usize; 4]) -> Option<usize> {
    Some(match (4 - ones, x, y, z) {
        (4, 4, 0, 0) => 0,
        (3, 3, 0, 0) => 1,
        (3, 0, 3, 0) => 2,
        (3, 0, 0, 3) => 3,
        (2, 2, 0, 0) => 4,
        (2, 1, 1, 0) => 5,
        (2, 1, 0, 1) => 6,
        (2, 0, 2, 0) => 7,
        (2, 0, 1, 1) => 8,
        (2, 0, 0, 2) => 9,
        (1, 1, 0, 0) => 10,
        (1, 0, 1, 0) => 11,
        (1, 0, 0, 1) => 12,
        (0, ..) => 13,
        _ => return None,
    })
}

/// Four columns of four numbers.
fn determinant(e: [Quat; 4]) -> f64 {
    let [a, b, c, d] = e.map(Quat::to_array);
    let minor = |p: &[f64; 4], q: &[f64; 4], i: usize, j: usize| p[i] * q[j] - p[j] * q[i];
    // By pairs of rows, of the first two columns and of the last two.
    let product = |i, j, k, l| minor(&a, &b, i, j) * minor(&c, &d, k, l);
    product(0, 1, 2, 3) - product(0, 2, 1, 3) + product(0, 3, 1, 2) + product(1, 2, 0, 3) - product(1, 3, 0, 2)
        + product(2, 3, 0, 1)
}

/// The polynomial of `p` that is this one of `(p - origin)/size`.
fn placed(c: [f64; TERMS], origin: Vec3, size: f64) -> [f64; TERMS] {
    let (h, o) = (1.0 / size, origin);
    let oo = o.length_squared();
    let (quartic, cubic) = (c[0] * h.powi(4), Vec3::new(c[1], c[2], c[3]) * h.powi(3));
    let half = [c[5], c[6], c[8]].map(|x| 0.5 * x);
    // The symmetric matrix of the quadratic terms.
    let rows =
        [Vec3::new(c[4], half[0], half[1]), Vec3::new(half[0], c[7], half[2]), Vec3::new(half[1], half[2], c[9])];
    let rows = rows.map(|row| row * (h * h));
    let linear = Vec3::new(c[10], c[11], c[12]) * h;
    let (along, turned) = (cubic.dot(o), Vec3::new(rows[0].dot(o), rows[1].dot(o), rows[2].dot(o)));
    let of_rho = cubic - o * (4.0 * quartic);
    // Twice |o|² of the quartic term, less b·o of the cubic one, times the unit matrix.
    let round = 2.0 * quartic * oo - along;
    let square = |i: usize, j: usize| {
        let (p, b) = (o.to_array(), cubic.to_array());
        let entry = rows[i].to_array()[j] + 4.0 * quartic * p[i] * p[j] - p[i] * b[j] - p[j] * b[i];
        if i == j { entry + round } else { 2.0 * entry }
    };
    let line = o * (-4.0 * quartic * oo) + o * (2.0 * along) + cubic * oo - turned * 2.0 + linear;
    let rest = quartic * oo * oo - along * oo + o.dot(turned) - linear.dot(o) + c[13];
    [
        quartic,
        of_rho.x,
        of_rho.y,
        of_rho.z,
        square(0, 0),
        square(0, 1),
        square(0, 2),
        square(1, 1),
        square(1, 2),
        square(2, 2),
        line.x,
        line.y,
        line.z,
        rest,
    ]
}
