//! Curves in the parameters of rational faces, for edges that are circles and lines in space.
//!
//! A reader compares an edge with its faces at equal parameters: a circle's is its angle, a line's its length, the
//! face's is that of the patch. At the fraction `x` of its angle `a` an arc whose end weights stand to each other as
//! `m = |w|` is at the patch's parameter ([`Arc::parameter_at_length`])
//!
//! ```text
//! t(x) = sin(x a/2) / (sin(x a/2) + m sin((1 - x) a/2)) = y / (y + m (1 - y)),
//! y(x) = (1 + tan((2x - 1) a/4) / tan(a/4)) / 2
//! ```
//!
//! Left alone, OpenCASCADE interpolates `t` at 23 points and misses its own tolerance, after which booleans widen the
//! tolerances and fillets fail. On a line `y = x`, and `t` is rational of degree 1. On a circle `y` is replaced by a
//! polynomial, which `m` keeps rational of the same degree: its Chebyshev series, cut where what is left out is below
//! [`LARGEST_ERROR`], in Bernstein form by Clenshaw's recurrence (`T_{k+1} = 2z T_k - T_{k-1}`, where a factor `z`
//! raises the degree by one). The poles of `y` are at `2x - 1 = ±2π/a`: the degree is 9 to 15 for usual arcs and below
//! 25, which is the most that readers take, for all arcs up to half a turn, with any weights. In space the edge's point
//! and the face's are apart by the error of `y` times the arc's length at most, to first order and a factor near 1.

use super::data::{Data, push_list, push_reference};
use crate::text::number::push_step;
use cyclide::{
    curve::Arc,
    topology::{FaceEdge, Side},
};
use std::fmt::Write as _;
use std::sync::LazyLock;

/// Part of an edge's length by which its point in space and that in the parameters may be apart; readers' tolerance is
/// 1e-7, which leaves room for edges of a hundred meters in millimeters.
const LARGEST_ERROR: f64 = 1e-13;
/// Terms of the series; those above the degree measure the error.
const TERMS: usize = 32;
/// What readers take.
pub(super) const LARGEST_DEGREE: usize = 25;

/// The patch's parameter along an edge as a rational Bézier curve over the edge's own parameter.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ParameterCurve {
    /// Control values from 0 to 1.
    values: Vec<f64>,
    /// Their weights; `None` where they are equal.
    weights: Option<Vec<f64>>,
}

impl ParameterCurve {
    /// Along a rational edge, which has the patch's parameter.
    pub(super) fn proportional() -> Self {
        Self { values: vec![0.0, 1.0], weights: None }
    }

    /// Along a line; `None` where the parameters are proportional, which readers find themselves.
    pub(super) fn along_line(arc: &Arc) -> Option<Self> {
        Self::weighted(arc, vec![0.0, 1.0])
    }

    /// Along a circle; `None` where the parameters are proportional.
    pub(super) fn along_circle(arc: &Arc) -> Option<Self> {
        let quarter = 0.25 * arc.angle();
        let terms = series(|x| 0.5 + 0.5 * ((2.0 * x - 1.0) * quarter).tan() / quarter.tan());
        let mut values = bernstein(&terms[..=degree(&terms, LARGEST_ERROR).min(LARGEST_DEGREE)]);
        let last = values.len() - 1;
        (values[0], values[last]) = (0.0, 1.0);
        Self::weighted(arc, values)
    }

    /// The parameter `y / (y + m (1 - y))` from the Bernstein form of `y`.
    fn weighted(arc: &Arc, values: Vec<f64>) -> Option<Self> {
        let m = arc.weight_ratio().norm();
        if (m - 1.0).abs() <= LARGEST_ERROR {
            return (values.len() > 2).then_some(Self { values, weights: None });
        }
        let weights: Vec<f64> = values.iter().map(|y| y + m * (1.0 - y)).collect();
        let values = values.iter().zip(&weights).map(|(y, w)| y / w).collect();
        Some(Self { values, weights: Some(weights) })
    }

    /// The curve along an edge on a side of a face, over `[0, range]`.
    pub(super) fn write(&self, data: &mut Data, side: Side, edge: FaceEdge, range: f64) -> usize {
        let place = |x: &f64| side.place(edge.turned(*x)).into();
        let points: Vec<usize> = self.values.iter().map(|x| data.parameter_point(place(x))).collect();
        spline(data, points, self.weights.as_deref(), range)
    }
}

/// One Bézier span over `[0, range]` with these points of the parameters.
pub(super) fn spline(data: &mut Data, points: Vec<usize>, weights: Option<&[f64]>, range: f64) -> usize {
    let (degree, ends) = (points.len() - 1, points.len());
    data.write(|out| {
        // Writing to a string cannot fail.
        let rational = weights.is_some();
        out.push_str(if rational { "(BOUNDED_CURVE() B_SPLINE_CURVE(" } else { "B_SPLINE_CURVE_WITH_KNOTS(''," });
        let _ = write!(out, "{degree},");
        push_list(out, points, push_reference);
        out.push_str(",.UNSPECIFIED.,.F.,.F.");
        out.push_str(if rational { ") B_SPLINE_CURVE_WITH_KNOTS(" } else { "," });
        let _ = write!(out, "({ends},{ends}),");
        push_list(out, [0.0, range], push_step);
        out.push_str(",.UNSPECIFIED.)");
        if let Some(weights) = weights {
            out.push_str(" CURVE() GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_CURVE(");
            push_list(out, weights, |out, &w| push_step(out, w));
            out.push_str(") REPRESENTATION_ITEM(''))");
        }
    })
}

/// The polynomials at the zeros of the next one: each edge asks for all of them.
static COSINES: LazyLock<[[f64; TERMS]; TERMS]> = LazyLock::new(|| {
    let angle = |i: usize| std::f64::consts::PI * (i as f64 + 0.5) / TERMS as f64;
    std::array::from_fn(|k| std::array::from_fn(|i| (k as f64 * angle(i)).cos()))
});

/// The Chebyshev series of a function on `[0, 1]`, from its values at the zeros of the next polynomial.
pub(super) fn series(f: impl Fn(f64) -> f64) -> Vec<f64> {
    let cosines = &*COSINES;
    let values: Vec<f64> = (0..TERMS).map(|i| f(0.5 + 0.5 * cosines[1][i])).collect();
    let term = |k: usize| {
        let sum: f64 = values.iter().zip(&cosines[k]).map(|(v, cosine)| v * cosine).sum();
        sum * if k == 0 { 1.0 } else { 2.0 } / TERMS as f64
    };
    (0..TERMS).map(term).collect()
}

/// The lowest degree that leaves out no more than a limit.
pub(super) fn degree(terms: &[f64], limit: f64) -> usize {
    let mut left_out = 0.0;
    let over = |k: &usize| {
        left_out += terms[*k].abs();
        left_out > limit
    };
    (1..terms.len()).rev().find(over).unwrap_or(1)
}

/// A Chebyshev series on `[0, 1]` in Bernstein form: Clenshaw's `b_k = c_k + 2z b_{k+1} - b_{k+2}` with `z = 2x - 1`, each
/// a degree above the one before.
pub(super) fn bernstein(terms: &[f64]) -> Vec<f64> {
    let (mut next, mut after) = (Vec::new(), Vec::new());
    for (k, &c) in terms.iter().enumerate().rev() {
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let (times, mut raised) = (product(&next, [-1.0, 1.0]), after);
        while raised.len() < times.len() {
            raised = product(&raised, [1.0, 1.0]);
        }
        let own = times.iter().zip(&raised).map(|(t, r)| c + factor * t - r).collect();
        (after, next) = (next, own);
    }
    next
}

/// A polynomial in Bernstein form times a linear one, a degree higher; of no values 0.
fn product(values: &[f64], [a, b]: [f64; 2]) -> Vec<f64> {
    let n = values.len();
    let at = |j: usize| values.get(j).copied().unwrap_or(0.0);
    let value = |j: usize| {
        let below = if j > 0 { j as f64 * b * at(j - 1) } else { 0.0 };
        (below + (n - j) as f64 * a * at(j)) / n.max(1) as f64
    };
    (0..=n).map(value).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
mod tests {
    use super::*;
    use cyclide::{Point3, Quat, rational::NurbsCurve};

    /// An arc that turns by an angle, with uneven weights.
    fn arc(angle: f64, m: f64) -> Arc {
        let ratio = Quat::new((0.5 * angle).cos(), 0.0, 0.0, (0.5 * angle).sin()) * m;
        Arc::from_weight_ratio(Point3::ORIGIN, Point3::new(2.0, 0.0, 0.0), ratio).unwrap()
    }

    /// Largest distance, as part of the length, between the arc's point at a fraction of the angle and that at the parameter
    /// which the curve, evaluated by the kernel, has there.
    fn largest_error(curve: &ParameterCurve, arc: &Arc) -> f64 {
        let n = curve.values.len();
        let knots = [vec![0.0; n], vec![1.0; n]].concat();
        let points = curve.values.iter().map(|&x| Point3::new(x, 0.0, 0.0)).collect();
        let spline = NurbsCurve::new(n - 1, knots, points, curve.weights.clone().unwrap_or(vec![1.0; n])).unwrap();
        let error = |k: u32| {
            let x = f64::from(k) / 1000.0;
            arc.point(spline.point_at_knot(x).x).distance(arc.point_at_length(x)) / arc.length()
        };
        (0..=1000).map(error).fold(0.0, f64::max)
    }

    #[test]
    fn circles_are_followed_to_the_limit_with_any_weights() {
        for angle in [1e-6, 1e-3, 0.2, 1.0, 2.0, 2.7, 3.1] {
            for m in [1e-6, 0.1, 0.5, 1.0, 3.0, 40.0, 1e6] {
                let arc = arc(angle, m);
                let Some(curve) = ParameterCurve::along_circle(&arc) else {
                    assert!((m - 1.0).abs() < f64::EPSILON && angle <= 1e-6, "{angle} {m}");
                    continue;
                };
                // The limit, roundings of some tens of sums, and that of a parameter where little of it is much of the arc.
                let error = largest_error(&curve, &arc);
                let limit = 3.0 * LARGEST_ERROR + 4.0 * f64::EPSILON * m.max(1.0 / m);
                assert!(error <= limit, "{angle} {m}: {error:e}");
                assert_eq!((curve.values[0], *curve.values.last().unwrap()), (0.0, 1.0));
            }
        }
    }

    #[test]
    fn the_degree_depends_on_the_angle_only() {
        for (angle, degree) in [(0.4, 9), (0.8, 11), (1.5, 15), (2.6, 21), (3.1, 25)] {
            for m in [0.01, 1.0, 2.0] {
                let curve = ParameterCurve::along_circle(&arc(angle, m)).unwrap();
                assert!(curve.values.len() <= degree + 1, "{angle} {m}: {}", curve.values.len());
            }
        }
    }

    #[test]
    fn lines_are_exact_and_left_to_readers_where_even() {
        let segment = |m: f64| {
            let end = Point3::new(2.0, 0.0, 0.0);
            Arc::from_weight_ratio(Point3::ORIGIN, end, Quat::new(m, 0.0, 0.0, 0.0)).unwrap()
        };
        assert_eq!(ParameterCurve::along_line(&segment(1.0)), None);
        for m in [0.2, 7.0] {
            let curve = ParameterCurve::along_line(&segment(m)).unwrap();
            assert!(largest_error(&curve, &segment(m)) < 1e-15, "{m}");
        }
    }
}
