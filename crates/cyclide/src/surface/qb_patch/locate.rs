//! Parameters of a point: on the surface in closed form, off it by the foot of the perpendicular.

use super::QbPatch;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::surface::{ParamSurface as _, PatchLocation};

/// Newton steps from each start.
const STEPS: usize = 40;
/// A step that leads away is halved so many times at most.
const HALVINGS: usize = 12;
/// Places along each parameter among which the nearest is a start.
const GRID: u32 = 8;

impl QbPatch {
    /// The parameters of a point on the surface, or of the foot of a perpendicular from a point near it.
    ///
    /// Where `f(s, t) = p`, the four pencils `e_k = (a_k - p) w_k` are dependent, with the factors `B_k(s, t)`: they are a cofactor vector, in
    /// closed form (`docs/math/bilinear-patches.md#which-surface`). Newton steps follow, from there and from the nearest of 64 places of the patch,
    /// halved while they lead away. Off the surface the result is *a* foot, the nearest that was reached. A point that is not finite has no
    /// place: all fields are NaN.
    #[must_use]
    pub fn locate(&self, p: Point3) -> PatchLocation {
        let own = parameters_of(&self.pencils(p));
        let found = [own, Some(self.nearest_of_grid(p))].into_iter().flatten().map(|start| self.newton(p, start));
        let nothing = Point3::new(f64::NAN, f64::NAN, f64::NAN);
        let none = PatchLocation { s: f64::NAN, t: f64::NAN, point: nothing, distance: f64::NAN };
        found
            .filter(|place| place.distance.is_finite())
            .min_by(|a, b| a.distance.total_cmp(&b.distance))
            .unwrap_or(none)
    }

    /// Steps to the foot of the perpendicular; the nearest place on the way.
    fn newton(&self, p: Point3, (s, t): (f64, f64)) -> PatchLocation {
        let place = |s: f64, t: f64| {
            let point = self.point(s, t);
            PatchLocation { s, t, point, distance: point.distance(p) }
        };
        let mut best = place(s, t);
        let rounding = 4.0 * f64::EPSILON * (self.scale + p.to_vec().max_abs());
        for _ in 0..STEPS {
            let jet = self.jet(best.s, best.t);
            let rest = p - jet.point;
            let [e, f, g] = jet.first_form();
            let (along_s, along_t) = (rest.dot(jet.ds), rest.dot(jet.dt));
            // The second derivatives of half the squared distance; before a center of curvature only.
            let second = [e - rest.dot(jet.dss), f - rest.dot(jet.dst), g - rest.dot(jet.dtt)];
            let step = solved(second, along_s, along_t).or_else(|| solved([e, f, g], along_s, along_t));
            let Some((ds, dt)) = step else { break };
            let mut parts = (0..=HALVINGS).map(|k| 0.5_f64.powi(k as i32));
            let nearer = parts.find_map(|part| {
                let found = place(best.s + part * ds, best.t + part * dt);
                (found.distance < best.distance).then_some(found)
            });
            let Some(found) = nearer else { break };
            best = found;
            if !(ds.abs() * e.sqrt() + dt.abs() * g.sqrt() > rounding) {
                break;
            }
        }
        best
    }

    /// The nearest of the places in the middles of equal parts of the parameters.
    fn nearest_of_grid(&self, p: Point3) -> (f64, f64) {
        let middle = |k: u32| (f64::from(k) + 0.5) / f64::from(GRID);
        let places = (0..GRID * GRID).map(|k| (middle(k % GRID), middle(k / GRID)));
        let distance = |(s, t): (f64, f64)| self.point(s, t).distance(p);
        places.min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap_or((0.5, 0.5))
    }
}

/// The solution of a symmetric system that is positive definite.
fn solved([e, f, g]: [f64; 3], a: f64, b: f64) -> Option<(f64, f64)> {
    let determinant = e * g - f * f;
    if !(e > 0.0 && determinant > f64::EPSILON * e * g) {
        return None;
    }
    let step = ((g * a - f * b) / determinant, (e * b - f * a) / determinant);
    (step.0.is_finite() && step.1.is_finite()).then_some(step)
}

/// The parameters whose bilinear functions are the factors of the dependent pencils: the longest of their four cofactor vectors, and of each
/// two ratios the one with the larger terms.
fn parameters_of(e: &[Quat; 4]) -> Option<(f64, f64)> {
    let columns = e.map(Quat::to_array);
    let vectors = [0, 1, 2, 3].map(|row| {
        let rows: [usize; 3] = std::array::from_fn(|k| k + usize::from(k >= row));
        let column = |k: usize| Vec3::from(rows.map(|row| columns[k][row]));
        // Without the k-th column, with alternating signs.
        let minor = |i, j, k| column(i).dot(column(j).cross(column(k)));
        [minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)]
    });
    let size = |v: &[f64; 4]| v.iter().map(|x| x * x).sum::<f64>();
    let [v0, v1, v2, v3] = vectors.into_iter().max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let parameter = |[low, high]: [f64; 2], [low2, high2]: [f64; 2]| {
        let (sum, other) = (low + high, low2 + high2);
        if sum.abs() >= other.abs() { high / sum } else { high2 / other }
    };
    let (s, t) = (parameter([v0, v1], [v2, v3]), parameter([v0, v2], [v1, v3]));
    (s.is_finite() && t.is_finite()).then_some((s, t))
}
