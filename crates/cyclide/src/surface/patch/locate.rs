//! Parameters of a point, on the surface in closed form and off it by the foot of the perpendicular.

use super::CyclidePatch;
use super::implicit::polar_product;
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::surface::ParamSurface as _;

/// A pair of parameters that leaves this part of the largest term is the point's own.
const OWN: f64 = 1e-6;
/// Candidates whose distances differ by this part of the size are equally near.
const TIE: f64 = 1e-9;
/// Newton steps from each start.
const STEPS: usize = 40;
/// A step that leads away is halved so many times at most.
const HALVINGS: usize = 12;
/// Places along each parameter among which the nearest is a start: on sharply curved patches the others may miss it.
const GRID: u32 = 8;

/// Where a point is on a patch.
///
/// ```
/// use cyclide::surface::{DupinCyclide, ParamSurface};
/// let patch = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?[0].patch(0, 0);
/// let found = patch.locate(patch.point(0.3, 0.6));
/// assert!((found.s - 0.3).abs() < 1e-9 && (found.t - 0.6).abs() < 1e-9 && found.distance < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PatchLocation {
    /// First parameter; outside `[0, 1]` where the foot is on the surface produced beyond the patch.
    pub s: f64,
    /// Second parameter.
    pub t: f64,
    /// The point of the surface at `(s, t)`.
    pub point: Point3,
    /// Its distance from the point asked for.
    pub distance: f64,
}

impl CyclidePatch {
    /// The parameters of a point on the surface, or of the foot of a perpendicular from a point near it.
    ///
    /// On the surface the point's parameters are roots of a quadratic (`docs/math/patches.md#point-location`: also on
    /// planes and spheres, where every other closed form degenerates); of two pairs that both give the point the one
    /// nearer to `[0, 1]²` is taken. Off the surface Newton steps follow, from these roots and from the nearest of a
    /// few places of the patch: the parameter lines are orthogonal and lines of curvature, so a step is two divisions;
    /// it is halved while it leads away. The result is then *a* foot, the nearest that was reached: up to 1e-3 of the
    /// patch's size away practically always the nearest there is, at 0.1 not always. Where a whole parameter line is
    /// the point, any parameter on it is right.
    ///
    /// A point that is not finite has no place: all fields are NaN.
    #[must_use]
    pub fn locate(&self, p: Point3) -> PatchLocation {
        let e = self.pencils(p);
        let largest = e.iter().map(|e| e.norm()).fold(0.0, f64::max);
        let roots = self.roots_of(&e);
        let is_own = |root: &Option<Root>| root.is_some_and(|root| root.rest <= OWN * largest);
        let starts = [roots[0].map(|r| (r.s, r.t)), roots[1].map(|r| (r.s, r.t))];
        if is_own(&roots[0]) || is_own(&roots[1]) {
            let own = [0, 1].map(|i| starts[i].filter(|_| is_own(&roots[i])));
            return self.nearest(p, own);
        }
        self.nearest(p, [starts[0], starts[1], self.sphere_parameters(&e), Some(self.nearest_of_grid(p))])
    }

    /// The best place that Newton steps reach from the starts.
    fn nearest<const N: usize>(&self, p: Point3, starts: [Option<(f64, f64)>; N]) -> PatchLocation {
        let outside = |x: f64| (-x).max(x - 1.0).max(0.0);
        let beyond = |l: &PatchLocation| outside(l.s).max(outside(l.t));
        let mut best: Option<PatchLocation> = None;
        for (s, t) in starts.into_iter().flatten() {
            let found = self.newton(p, s, t);
            let better = best.is_none_or(|best| {
                let (gain, tie) = (best.distance - found.distance, TIE * self.scale);
                gain > tie || (gain >= -tie && beyond(&found) < beyond(&best))
            });
            if better && found.distance.is_finite() {
                best = Some(found);
            }
        }
        best.unwrap_or(PatchLocation {
            s: f64::NAN,
            t: f64::NAN,
            point: Point3::new(f64::NAN, f64::NAN, f64::NAN),
            distance: f64::NAN,
        })
    }

    /// Steps to the foot of the perpendicular; the nearest place on the way.
    fn newton(&self, p: Point3, s: f64, t: f64) -> PatchLocation {
        let place = |s: f64, t: f64| {
            let point = self.point(s, t);
            PatchLocation { s, t, point, distance: point.distance(p) }
        };
        let mut best = place(s, t);
        let rounding = 4.0 * f64::EPSILON * (self.scale + p.to_vec().max_abs());
        for _ in 0..STEPS {
            let jet = self.jet(best.s, best.t);
            let rest = p - jet.point;
            let [e, _, g] = jet.first_form();
            // At the foot the second derivative of half the squared distance is |f_s|² (1 - h k1), and there is no
            // mixed one; before a curvature center, steps that count on it are steps of Newton.
            let height = rest.dot(self.unit_normal(best.s, best.t));
            let stretch = |k: f64| Some(1.0 - height * k).filter(|x| *x > 1e-3).unwrap_or(1.0);
            let step = |along: f64, square: f64, k: f64| {
                let step = along / (square * stretch(k));
                if step.is_finite() { step } else { 0.0 }
            };
            let ds = step(rest.dot(jet.ds), e, self.k1(best.t));
            let dt = step(rest.dot(jet.dt), g, self.k2(best.s));
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
        let mut best = (0.5, 0.5);
        let mut least = f64::INFINITY;
        for k in 0..GRID * GRID {
            let (s, t) = (middle(k % GRID), middle(k / GRID));
            let distance = self.point(s, t).distance(p);
            if distance < least {
                (least, best) = (distance, (s, t));
            }
        }
        best
    }

    /// `f(s, t) = p` where `(1-t) X + t Y = 0` with `X = (1-s) e0 + s e1`, `Y = (1-s) e2 + s e3`: then `V3·Im(~X Y) = 0`,
    /// a quadratic for s; t follows.
    fn roots_of(&self, e: &[Quat; 4]) -> [Option<Root>; 2] {
        let g = |i: usize, j: usize| polar_product(e[i], e[j], self.v[2]);
        let (a, b, c) = (g(0, 2), 0.5 * (g(0, 3) + g(1, 2)), g(1, 3));
        // a u² + 2b us + c s² with u = 1 - s: s : u.
        let q = -(b + (b * b - a * c).max(0.0).sqrt().copysign(b));
        [(q, c), (a, q)].map(|(s, u)| {
            let s = s / (s + u);
            let x = e[0] * (1.0 - s) + e[1] * s;
            let y = e[2] * (1.0 - s) + e[3] * s;
            let (xx, yy, xy) = (x.norm_squared(), y.norm_squared(), x.dot(y));
            let t = if xx >= yy { xx / (xx - xy) } else { -xy / (yy - xy) };
            // The whole t-line is the point.
            let t = if xx == 0.0 && yy == 0.0 { 0.5 } else { t };
            let rest = (x * (1.0 - t) + y * t).norm();
            (s.is_finite() && t.is_finite() && rest.is_finite()).then_some(Root { s, t, rest })
        })
    }

    /// The parameters of the two tangent spheres through a point of the surface
    /// (`docs/math/patches.md#point-location`): a start near it.
    fn sphere_parameters(&self, e: &[Quat; 4]) -> Option<(f64, f64)> {
        let parameter = |[a, b, c]: [f64; 3]| {
            let t = if a.abs() > c.abs() { a / (a - b) } else { b / (b - c) };
            t.is_finite().then_some(t)
        };
        let t = parameter(self.sphere_values(e, self.v[1], [(0, 1), (2, 3), (0, 3), (2, 1)]))?;
        let s = parameter(self.sphere_values(e, self.v[0], [(0, 2), (1, 3), (0, 3), (1, 2)]))?;
        Some((s, t))
    }
}

/// Parameters with what is left of the equation.
#[derive(Debug, Clone, Copy)]
struct Root {
    s: f64,
    t: f64,
    rest: f64,
}
