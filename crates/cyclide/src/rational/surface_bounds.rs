//! What the hull of the control points proves of a rational surface with positive weights: boxes, and how far a part of it
//! is from the triangles over its corners.
//!
//! **Triangles.** Over a triangle with two sides of length 1 along the parameters, the linear interpolant of a function is
//! off by at most `(M_ss + 2 M_st + M_tt)/8`, the bounds of its second derivatives there (D. Filip, R. Magedson,
//! R. Markot, 1986). Both are taken at the same parameters, so this bounds the distance both ways. With rows `(P, w)` seen
//! from a point `c` of the part, `g = f - c = P/w` and
//!
//! ```text
//! g_s = (P_s - w_s g)/w,   g_ss = (P_ss - 2 w_s g_s - w_ss g)/w,   g_st = (P_st - w_s g_t - w_t g_s - w_st g)/w
//! ```
//! where the derivatives of `P` and `w` lie in the hulls of differences of the rows. A product of a linear function of s and
//! one of t makes the weights of the part even first: the surface is the same, and `w_s`, `w_t`, which go to zero with the
//! part, then do so as its square, like the second derivatives. So the bounds tend to the derivatives themselves.
//!
//! In a long and narrow part `w_ss g` is the change of weights across it times the way along it, far more than it bends. A
//! function that is linear in s and in t has no second derivatives: with the mean plane for `c`, `g` is as small as the part
//! is off that, and the bounds are those of a part as short as it is wide.

use super::bezier_surface::RationalBezierSurface;
use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use std::collections::VecDeque;

/// The box may be larger than the smallest one by this part of its diagonal.
const BOX_EXCESS: f64 = 1e-9;
/// Parts that are looked at for it, at most.
const BOX_PARTS: usize = 4096;
/// Bounds of which the change of weights makes more than this part are made from the mean plane, too.
const LARGE_SHARE: f64 = 0.25;

/// Bounds of the derivatives of a part by its own parameters in `[0, 1]²`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SecondDerivatives {
    pub(crate) ss: f64,
    pub(crate) st: f64,
    pub(crate) tt: f64,
}

impl SecondDerivatives {
    /// No point of the part is farther from the two triangles over its corners at the same parameters, whichever diagonal
    /// they share.
    pub(crate) fn distance_from_triangles(self) -> f64 {
        (self.ss + 2.0 * self.st + self.tt) / 8.0
    }
}

impl RationalBezierSurface {
    /// Bounds of the second derivatives; infinite unless all weights are positive.
    pub(crate) fn second_derivatives(&self) -> SecondDerivatives {
        let local = self.seen_from(self.point(0.5, 0.5)).with_even_weights();
        let ([simple, by_weights], seen) = (local.bounds_of_derivatives(), SecondDerivatives::distance_from_triangles);
        // Not `<=`: what is no number is not small either.
        if seen(by_weights) < LARGE_SHARE * seen(simple) || !seen(simple).is_finite() {
            return simple;
        }
        let [tilted, _] = local.seen_from_plane().bounds_of_derivatives();
        if seen(tilted) < seen(simple) { tilted } else { simple }
    }

    /// Bounds of the second derivatives, and the part of them that comes from the change of weights.
    fn bounds_of_derivatives(&self) -> [SecondDerivatives; 2] {
        let least = self.rows().iter().map(|row| row[3]).fold(f64::INFINITY, f64::min);
        // Not `<=`: what is no number is not positive either.
        if !(least > 0.0) {
            return [SecondDerivatives { ss: f64::INFINITY, st: f64::INFINITY, tt: f64::INFINITY }; 2];
        }
        let size = self.rows().iter().map(|row| vector(row).length() / row[3]).fold(0.0, f64::max);
        let bounds = |orders: [usize; 2]| self.difference_bounds(orders);
        let [first_s, first_t] = [bounds([1, 0]), bounds([0, 1])];
        let slope = |d: Hull| (d.vector + d.weight * size) / least;
        let (gs, gt) = (slope(first_s), slope(first_t));
        let (ss, st, tt) = (bounds([2, 0]), bounds([1, 1]), bounds([0, 2]));
        let by_weights = SecondDerivatives {
            ss: (2.0 * first_s.weight * gs + ss.weight * size) / least,
            st: (first_s.weight * gt + first_t.weight * gs + st.weight * size) / least,
            tt: (2.0 * first_t.weight * gt + tt.weight * size) / least,
        };
        let all = SecondDerivatives {
            ss: ss.vector / least + by_weights.ss,
            st: st.vector / least + by_weights.st,
            tt: tt.vector / least + by_weights.tt,
        };
        [all, by_weights]
    }

    /// What the surface, seen from its middle, is off the plane `c` through that with its mean slopes, of degrees one higher.
    fn seen_from_plane(&self) -> Self {
        let [p, q] = self.degrees();
        let [a, b, c, d] = self.corners();
        let slopes = [(b - a + (d - c)) * 0.5, (c - a + (d - b)) * 0.5];
        let (even, rising) = ([1.0, 1.0], [-0.5, 0.5]);
        let mut rows = self.times_linear(even, even);
        for (slope, along) in slopes.into_iter().zip([[rising, even], [even, rising]]) {
            for (row, [.., w]) in rows.iter_mut().zip(self.times_linear(along[0], along[1])) {
                for (value, change) in row.iter_mut().zip(slope.to_array()) {
                    *value -= w * change;
                }
            }
        }
        Self::from_rows_unchecked([p + 1, q + 1], rows)
    }

    /// The same surface of degrees one higher, with weights whose means over opposite sides are equal.
    fn with_even_weights(&self) -> Self {
        let [p, q] = self.degrees();
        let at = |i: usize, j: usize| i * (q + 1) + j;
        let mean = |rows: &mut dyn Iterator<Item = usize>| {
            let (sum, count) = rows.fold((0.0, 0.0), |(sum, count), k| (sum + self.rows()[k][3], count + 1.0));
            count / sum
        };
        let along_s = [mean(&mut (0..=q).map(|j| at(0, j))), mean(&mut (0..=q).map(|j| at(p, j)))];
        let along_t = [mean(&mut (0..=p).map(|i| at(i, 0))), mean(&mut (0..=p).map(|i| at(i, q)))];
        Self::from_rows_unchecked([p + 1, q + 1], self.times_linear(along_s, along_t))
    }

    /// The rows times a linear function of s and one of t, given at 0 and 1.
    fn times_linear(&self, along_s: [f64; 2], along_t: [f64; 2]) -> Vec<[f64; 4]> {
        let [p, q] = self.degrees();
        let at = |i: usize, j: usize| i * (q + 1) + j;
        let scaled = |row: [f64; 4], by: f64| row.map(|v| v * by);
        // A Bézier form of degree n times a linear one: out[i] = ((n + 1 - i) l0 c[i] + i l1 c[i-1]) / (n + 1).
        let product = |n: usize, i: usize, [l0, l1]: [f64; 2], row: &dyn Fn(usize) -> [f64; 4]| {
            let (low, high) = ((n + 1 - i) as f64 * l0, i as f64 * l1);
            let a = if i <= n { scaled(row(i), low) } else { [0.0; 4] };
            let b = if i > 0 { scaled(row(i - 1), high) } else { [0.0; 4] };
            std::array::from_fn(|d| (a[d] + b[d]) / (n + 1) as f64)
        };
        let mut rows = Vec::with_capacity((p + 2) * (q + 2));
        for i in 0..=p + 1 {
            let row = |j: usize| product(p, i, along_s, &|i| self.rows()[at(i, j)]);
            rows.extend((0..=q + 1).map(|j| product(q, j, along_t, &row)));
        }
        rows
    }

    /// The largest derivatives of these orders of rows and weights, by the hulls of their differences.
    fn difference_bounds(&self, orders: [usize; 2]) -> Hull {
        let [p, q] = self.degrees();
        if orders[0] > p || orders[1] > q {
            return Hull { vector: 0.0, weight: 0.0 };
        }
        let mut rows = self.rows().to_vec();
        let at = |i: usize, j: usize| i * (q + 1) + j;
        let mut factor = 1.0;
        for k in 0..orders[0] {
            factor *= (p - k) as f64;
            for i in 0..p - k {
                for j in 0..=q {
                    rows[at(i, j)] = minus(&rows[at(i + 1, j)], &rows[at(i, j)]);
                }
            }
        }
        for k in 0..orders[1] {
            factor *= (q - k) as f64;
            for i in 0..=p {
                for j in 0..q - k {
                    rows[at(i, j)] = minus(&rows[at(i, j + 1)], &rows[at(i, j)]);
                }
            }
        }
        let mut hull = Hull { vector: 0.0, weight: 0.0 };
        for i in 0..=p - orders[0] {
            for j in 0..=q - orders[1] {
                let row = &rows[at(i, j)];
                hull.vector = hull.vector.max(factor * vector(row).length());
                hull.weight = hull.weight.max(factor * row[3].abs());
            }
        }
        hull
    }

    /// The box of the control points; weights are positive.
    pub(crate) fn hull_box(&self) -> Aabb {
        let corner = Aabb::of_point(self.corners()[0]);
        let point = |row: &[f64; 4]| Point3::new(row[0] / row[3], row[1] / row[3], row[2] / row[3]);
        self.rows().iter().filter(|row| row[3] > 0.0).fold(corner, |bounds, row| bounds.including(point(row)))
    }

    /// A box around the surface, whose weights are positive, larger than the smallest one by 1e-9 of its diagonal at most
    /// (more only where 4096 parts do not suffice).
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        self.bounds_with(Aabb::of_point(self.corners()[0]))
    }

    /// The box around the surface and what is known already, as near. What is inside that costs nothing.
    pub(crate) fn bounds_with(&self, known: Aabb) -> Aabb {
        let mut inner = self.corners().into_iter().fold(known.including(self.point(0.5, 0.5)), Aabb::including);
        let mut outer = inner;
        // Level by level: what the corners of all parts show makes most of the hulls superfluous.
        let mut waiting = VecDeque::from([self.clone()]);
        let mut looked_at = 0;
        while let Some(part) = waiting.pop_front() {
            inner = part.corners().into_iter().fold(inner, Aabb::including);
            let own = part.hull_box();
            looked_at += 1;
            let excess = inner.union(own).diagonal() - inner.diagonal();
            if excess <= BOX_EXCESS * inner.diagonal() || looked_at > BOX_PARTS {
                outer = outer.union(own);
                continue;
            }
            for s in [[0.0, 0.5], [0.5, 1.0]] {
                for t in [[0.0, 0.5], [0.5, 1.0]] {
                    waiting.push_back(part.part(s, t));
                }
            }
        }
        outer.union(inner)
    }

    /// The least weight of a part relative to its largest: how much its points crowd together.
    pub(crate) fn evenness(&self, s: [f64; 2], t: [f64; 2]) -> f64 {
        let part = self.part(s, t);
        let (lo, hi) =
            part.rows().iter().fold((f64::INFINITY, 0.0_f64), |(lo, hi), row| (lo.min(row[3]), hi.max(row[3])));
        lo / hi
    }
}

/// Bounds of vectors and weights of rows.
#[derive(Debug, Clone, Copy)]
struct Hull {
    vector: f64,
    weight: f64,
}

fn vector(row: &[f64; 4]) -> Vec3 {
    Vec3::new(row[0], row[1], row[2])
}

fn minus(a: &[f64; 4], b: &[f64; 4]) -> [f64; 4] {
    std::array::from_fn(|d| a[d] - b[d])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bidegree (3, 2), weights from 0.5 to 3, far from the origin.
    fn bumpy() -> RationalBezierSurface {
        let weights = [1.0, 2.0, 0.7, 1.5, 0.5, 1.0, 3.0, 1.0, 0.8, 1.0, 2.0, 1.0];
        let rows = (0..12).map(|k| {
            let (i, j, w) = ((k / 3) as f64, (k % 3) as f64, weights[k]);
            let z = if (k / 3 + k % 3) % 2 == 0 { 0.4 } else { -0.3 };
            [(100.0 + i) * w, (j - 50.0) * w, z * w, w]
        });
        RationalBezierSurface::new([3, 2], rows.collect()).unwrap()
    }

    #[test]
    fn the_bounds_hold_and_tend_to_the_derivatives() {
        let surface = bumpy();
        for (size, excess) in [(1.0, 60.0), (0.1, 2.0), (0.01, 1.1)] {
            let (s, t) = ([0.3, 0.3 + 0.7 * size], [0.2, 0.2 + 0.8 * size]);
            let part = surface.part(s, t);
            let bounds = part.second_derivatives();
            let mut largest = [0.0_f64; 3];
            for (i, j) in (0..=20).flat_map(|i| (0..=20).map(move |j| (i, j))) {
                let jet = part.jet(f64::from(i) / 20.0, f64::from(j) / 20.0);
                for (most, d) in largest.iter_mut().zip([jet.dss, jet.dst, jet.dtt]) {
                    *most = most.max(d.length());
                }
            }
            let pairs = [bounds.ss, bounds.st, bounds.tt].into_iter().zip(largest);
            assert!(pairs.clone().all(|(bound, found)| bound >= found), "{size}: {bounds:?} {largest:?}");
            let sum = |v: [f64; 3]| v[0] + 2.0 * v[1] + v[2];
            assert!(sum([bounds.ss, bounds.st, bounds.tt]) <= excess * sum(largest), "{size}: {bounds:?} {largest:?}");
        }
        // A bilinear part of a plane has none.
        let flat: Vec<[f64; 4]> =
            [[0.0, 0.0], [0.0, 1.0], [2.0, 0.0], [2.0, 1.0]].map(|[x, y]| [x, y, 5.0, 1.0]).to_vec();
        let none = RationalBezierSurface::new([1, 1], flat).unwrap().second_derivatives();
        assert!(none.distance_from_triangles() < 1e-15);
    }

    /// A strip 0.003 wide and round across, whose weights change, along a parabola: what it bends counts, and not its length.
    #[test]
    fn long_and_narrow_parts_have_bounds_of_their_bends() {
        let (radius, half) = (0.003, std::f64::consts::FRAC_PI_8);
        let across = [[-half.sin(), half.cos(), 1.0], [0.0, 1.0, half.cos()], [half.sin(), half.cos(), 1.0]];
        let rows = across.into_iter().flat_map(|[x, y, w]| {
            let place = move |z: f64, bend: f64| [radius * x, radius * y + w * bend, w * z, w];
            [place(0.0, 0.0), place(50.0, 0.0), place(100.0, 20.0)]
        });
        let strip = RationalBezierSurface::new([2, 2], rows.collect()).unwrap();
        for length in [1.0, 0.1, 0.01] {
            let part = strip.part([0.0, 1.0], [0.4, 0.4 + length * 0.6]);
            let mut largest = [0.0_f64; 3];
            for (i, j) in (0..=20).flat_map(|i| (0..=20).map(move |j| (i, j))) {
                let jet = part.jet(f64::from(i) / 20.0, f64::from(j) / 20.0);
                for (most, d) in largest.iter_mut().zip([jet.dss, jet.dst, jet.dtt]) {
                    *most = most.max(d.length());
                }
            }
            let found = SecondDerivatives { ss: largest[0], st: largest[1], tt: largest[2] }.distance_from_triangles();
            let bound = part.second_derivatives().distance_from_triangles();
            assert!(found <= bound && bound <= 2.0 * found, "{length}: {found:e} {bound:e}");
        }
    }

    #[test]
    fn no_point_is_farther_from_the_triangles_than_proved() {
        let surface = bumpy();
        for (size, excess) in [(0.5, 40.0), (0.1, 4.0)] {
            let part = surface.part([0.1, 0.1 + size], [0.4, 0.4 + size]);
            let bound = part.second_derivatives().distance_from_triangles();
            let [a, b, c, d] = part.corners();
            let mut found = 0.0_f64;
            for (i, j) in (0..=30).flat_map(|i| (0..=30).map(move |j| (i, j))) {
                let (s, t) = (f64::from(i) / 30.0, f64::from(j) / 30.0);
                let linear = if s + t <= 1.0 {
                    a + (b - a) * s + (c - a) * t
                } else {
                    d + (c - d) * (1.0 - s) + (b - d) * (1.0 - t)
                };
                found = found.max(linear.distance(part.point(s, t)));
            }
            assert!(found <= bound && bound <= excess * found, "{size}: {found} {bound}");
        }
    }

    #[test]
    fn boxes_are_tight_and_hold_the_surface() {
        let surface = bumpy();
        let bounds = surface.bounds();
        let mut seen = Aabb::of_point(surface.point(0.0, 0.0));
        for (i, j) in (0..=200).flat_map(|i| (0..=200).map(move |j| (i, j))) {
            seen = seen.including(surface.point(f64::from(i) / 200.0, f64::from(j) / 200.0));
        }
        // Points are rounded by 1e-14 at these coordinates.
        let slack = Vec3::new(1e-13, 1e-13, 1e-13);
        assert!(Aabb { min: bounds.min - slack, max: bounds.max + slack }.contains(seen));
        // A grid misses a summit by the square of its step.
        assert!(bounds.diagonal() - seen.diagonal() < 1e-4, "{bounds:?} {seen:?}");
    }
}
