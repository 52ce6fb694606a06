//! Extremes of the principal curvatures over a patch, in closed form.

use super::CyclidePatch;
use super::singular::{POLE_LIMIT, roots};
use crate::base::quadratic::value as quadratic;

impl CyclidePatch {
    /// Smallest and largest value of the principal curvature along the s-lines, [`k1`](Self::k1), over the patch. Towards
    /// an s-line that is a node or a singular line inside ([`node_t`](Self::node_t), [`singular_t`](Self::singular_t)) the
    /// curvature grows beyond all bounds to one side or to both: that side is `-INFINITY` or `INFINITY`, the
    /// other one is still the extreme of all values.
    #[must_use]
    pub fn k1_range(&self) -> [f64; 2] {
        self.k1_extremes().map(|(k, _)| k)
    }

    /// The same of the principal curvature along the t-lines, [`k2`](Self::k2), with [`node_s`](Self::node_s) and
    /// [`singular_s`](Self::singular_s).
    #[must_use]
    pub fn k2_range(&self) -> [f64; 2] {
        self.k2_extremes().map(|(k, _)| k)
    }

    /// The values of [`k1_range`](Self::k1_range), each with the `t` of the s-line on which it is.
    pub(crate) fn k1_extremes(&self) -> [(f64, f64); 2] {
        Curvature {
            bend: self.polar.m.map(|m| -2.0 * m.dot(self.v[1])),
            size: self.polar.m.map(|m| 2.0 * m.length()),
            speed: self.polar.q1,
            rounding: self.speed_rounding(0.0)[0],
        }
        .extremes(&self.node_t(), &self.singular_t())
    }

    /// The values of [`k2_range`](Self::k2_range), each with the `s` of the t-line on which it is.
    pub(crate) fn k2_extremes(&self) -> [(f64, f64); 2] {
        Curvature {
            bend: self.polar.m_star.map(|m| 2.0 * m.dot(self.v[0])),
            size: self.polar.m_star.map(|m| 2.0 * m.length()),
            speed: self.polar.q2,
            rounding: self.speed_rounding(0.0)[1],
        }
        .extremes(&self.node_s(), &self.singular_s())
    }
}

/// A curvature as a quotient of quadratics in Bernstein form over [0, 1].
struct Curvature {
    bend: [f64; 3],
    /// What the values of `bend` are parts of, for rounding.
    size: [f64; 3],
    speed: [f64; 3],
    rounding: [f64; 3],
}

impl Curvature {
    /// Smallest and largest value, infinite towards poles, with their parameters.
    fn extremes(self, nodes: &[f64], singular: &[f64]) -> [(f64, f64); 2] {
        let [mut low, mut high] = self.finite(nodes);
        let mut poles: Vec<f64> = [nodes, singular].concat();
        poles.sort_by(f64::total_cmp);
        for (k, &pole) in poles.iter().enumerate() {
            let bend = quadratic(&self.bend, pole);
            // A pole of a sphere inside: both vanish, and the curvature is as around it.
            if bend.abs() <= POLE_LIMIT * quadratic(&self.size, pole) {
                continue;
            }
            let before = if k > 0 { poles[k - 1] } else { 0.0 };
            let after = poles.get(k + 1).copied().unwrap_or(1.0);
            for beside in [before, after].into_iter().filter(|end| (end - pole).abs() > 0.0) {
                // The speed keeps its sign up to the next pole.
                if (bend < 0.0) == (quadratic(&self.speed, 0.5 * (pole + beside)) < 0.0) {
                    high = (f64::INFINITY, pole);
                } else {
                    low = (f64::NEG_INFINITY, pole);
                }
            }
        }
        [low, high]
    }

    /// Finite extremes: at the ends, and where the Wronskian of the two quadratics is zero, which is a quadratic again.
    fn finite(&self, nodes: &[f64]) -> [(f64, f64); 2] {
        let (mut p, mut q) = (self.bend, self.speed);
        for (end, at) in [(0, 0.0), (2, 1.0)] {
            if q[end] == 0.0 {
                // A zero of the speed that is double but for rounding is double.
                if q[1].abs() <= self.rounding[1] {
                    q[1] = 0.0;
                }
                // At a pole both quadratics vanish, the first but for rounding.
                if !nodes.contains(&at) {
                    p[end] = 0.0;
                }
            }
        }
        // The value at an end, at a pole the limit: its factor is cancelled.
        let limit = |end: usize| {
            if q[end] != 0.0 {
                Some(p[end] / q[end])
            } else if nodes.contains(&(0.5 * end as f64)) {
                None
            } else {
                Some(if q[1] != 0.0 { p[1] / q[1] } else { p[2 - end] / q[2 - end] })
            }
        };
        let minor = |i: usize, j: usize| p[j] * q[i] - p[i] * q[j];
        let inside = roots([minor(0, 1), 0.5 * minor(0, 2), minor(1, 2)], [0.0; 3]);
        // Between two zeros of the speed that only rounding has parted, a value means nothing.
        let means = |t: &f64| quadratic(&q, *t).abs() > quadratic(&self.rounding, *t);
        let at = |t: f64| (quadratic(&p, t) / quadratic(&q, t), t);
        let ends = [(0, 0.0), (2, 1.0)].into_iter().filter_map(|(end, t)| Some((limit(end)?, t)));
        let values = ends.chain(inside.into_iter().filter(means).map(at)).filter(|(k, _)| k.is_finite());
        values.fold([(f64::INFINITY, 0.0), (f64::NEG_INFINITY, 0.0)], |[low, high], value| {
            [if value.0 < low.0 { value } else { low }, if value.0 > high.0 { value } else { high }]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::{Point3, Vec3};

    #[test]
    fn a_pole_has_the_limit_and_a_node_no_bound() {
        let octant = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::Z].map(|v| Point3::ORIGIN + v);
        let octant = CyclidePatch::from_corners_and_frame(octant, Vec3::Y, Vec3::Z).unwrap();
        assert!(octant.node_t().is_empty() && octant.node_s().is_empty());
        // A cone of slope 1 with its tip at a2 = a3, normal outward: k1 = -1/(r sqrt 2).
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
        let up = Vec3::new(-1.0, 0.0, 1.0).unit().unwrap();
        let cone = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, up).unwrap();
        assert_eq!((cone.node_t(), cone.node_s()), (vec![1.0], vec![]));
        for (range, k) in [(octant.k1_range(), -1.0), (octant.k2_range(), -1.0)] {
            assert!((range[0] - k).abs() < 1e-13 && (range[1] - k).abs() < 1e-13, "{range:?} {k}");
        }
        // Flattest at the base.
        let [low, high] = cone.k1_range();
        assert!(low == f64::NEG_INFINITY && (high + 0.5_f64.sqrt()).abs() < 1e-13, "{low} {high}");
        assert!(cone.k2_range().iter().all(|k| k.abs() < 1e-13)); // straight lines
    }

    /// A range, the parameters of singular lines, the curvature.
    type Family<'a> = ([f64; 2], Vec<f64>, &'a dyn Fn(f64) -> f64);

    /// Parameters dense everywhere and denser, to 1e-9, towards some.
    fn samples(towards: &[f64]) -> Vec<f64> {
        let near = |r: f64| {
            (0..400).flat_map(move |i| [-1.0, 1.0].map(|side| r + side * 10.0_f64.powf(-9.0 + 0.02 * f64::from(i))))
        };
        let all = (0..=2000).map(|i| f64::from(i) / 2000.0).chain(towards.iter().flat_map(|r| near(*r)));
        all.filter(|t| (0.0..=1.0).contains(t) && !towards.contains(t)).collect()
    }

    #[test]
    fn no_sample_is_outside_and_infinite_sides_are_approached() {
        let mut seen = [0; 3];
        for case in 0..200 {
            // Corners on a circle, every third time with two together; a frame without a pattern.
            let random = |k: usize| (1e4 * (1.0 + (17 * case + 5 * k) as f64 * 0.618_034).sin()).fract();
            let turn = |k: usize| std::f64::consts::TAU * (0.25 * k as f64 + 0.1 * random(k));
            let angles = [turn(0), turn(1), turn(2), if case % 3 == 0 { turn(2) } else { turn(3) }];
            let point = |a: f64| Point3::new(1.5 * a.cos(), 1.5 * a.sin(), 0.2 * case as f64 / 200.0);
            let [p0, p1, p3, p2] = angles.map(point);
            let Some(v1) = Vec3::new(random(4), random(5), random(6)).unit() else { continue };
            let Some(v2) = v1.cross(Vec3::new(random(7), random(8), 0.3)).unit() else { continue };
            let Ok(patch) = CyclidePatch::from_corners_and_frame([p0, p1, p2, p3], v1, v2) else { continue };
            let families: [Family<'_>; 2] = [
                (patch.k1_range(), [patch.singular_t(), patch.node_t()].concat(), &|t| patch.k1(t)),
                (patch.k2_range(), [patch.singular_s(), patch.node_s()].concat(), &|s| patch.k2(s)),
            ];
            for ([low, high], singular, at) in families {
                let values: Vec<f64> = samples(&singular).into_iter().map(at).filter(|k| k.is_finite()).collect();
                let size = [low, high].into_iter().filter(|k| k.is_finite()).fold(1e-3, |a: f64, k| a.max(k.abs()));
                let (least, most) = (
                    values.iter().fold(f64::INFINITY, |a, k| a.min(*k)),
                    values.iter().fold(f64::NEG_INFINITY, |a, k| a.max(*k)),
                );
                // Rounding of quotients near their zeros.
                assert!(
                    least >= low - 1e-7 * size && most <= high + 1e-7 * size,
                    "{case}: {low} {high}: {least} {most}"
                );
                assert!(low.is_finite() || least < -1e3 * size, "{case}: {low} {least} {singular:?}");
                assert!(high.is_finite() || most > 1e3 * size, "{case}: {high} {most} {singular:?}");
                assert_eq!(singular.is_empty(), low.is_finite() && high.is_finite(), "{case}: {singular:?}");
                let infinite = [low, high].into_iter().filter(|k| k.is_infinite()).count();
                seen[infinite] += 1;
            }
        }
        assert!(seen.iter().all(|n| *n >= 10), "{seen:?}");
    }

    #[test]
    fn the_range_holds_every_sample_and_is_reached() {
        let point = |a: f64| Point3::new(2.0 * a.cos(), 2.0 * a.sin(), 0.5);
        let [p0, p1, p3, p2] = [0.1, 1.4, 2.9, 5.0].map(point);
        let v1 = Vec3::new(0.9, -0.3, 0.4).unit().unwrap();
        let v2 = v1.cross(Vec3::new(0.1, 0.4, 0.7)).unit().unwrap();
        let patch = CyclidePatch::from_corners_and_frame([p0, p1, p2, p3], v1, v2).unwrap();
        assert!(patch.is_regular());
        for (range, at) in
            [(patch.k1_range(), &(|t| patch.k1(t)) as &dyn Fn(f64) -> f64), (patch.k2_range(), &|s| patch.k2(s))]
        {
            let sampled: Vec<f64> = (0..=10_000).map(|i| at(f64::from(i) / 10_000.0)).collect();
            let low = sampled.iter().fold(f64::INFINITY, |a, b| a.min(*b));
            let high = sampled.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
            let size = high - low;
            assert!(range[0] <= low && range[1] >= high);
            // Samples miss a smooth extreme by the square of their distance, 1e-8.
            assert!(low - range[0] < 1e-6 * size && range[1] - high < 1e-6 * size, "{range:?} {low} {high}");
        }
    }
}
