//! Curves in the parameters of cylinders and cones, for rational edges that are neither parallels nor rulings of theirs, and of spheres, for
//! circles that are neither parallels nor meridians.
//!
//! Left alone, OpenCASCADE interpolates such a curve at some places and misses its own tolerance between them (8e-7 on a tee
//! of size 240: not valid by its exact check). The angle about the axis is no rational function of the edge's parameter. So
//! angle and height are polynomials: their Chebyshev series over the edge, cut where what is left out is below rounding and
//! 1e-13 of the model's size, a tenth of what the check of the file lets pass. An edge that would take a degree beyond the
//! readers' is not written so, and its face stays rational (`docs/math/pipe-tees.md#parts-of-cylinders-in-step`).

use super::data::Data;
use super::layout::place;
use super::parameter_curves::{LARGEST_DEGREE, bernstein, degree, series, spline};
use cyclide::{Frame, Point3, curve::Arc, rational::RationalBezier, surface::PatchKind};
use std::f64::consts::TAU;

/// Part of the model's size by which the curve in the parameters may leave the edge.
const LARGEST_ERROR: f64 = 1e-13;
/// Roundings of a coordinate that are no error of a curve.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// An edge that ends at the seam is no farther beyond it than this.
const AT_SEAM: f64 = 1e-9;

/// Angle about the axis of a cylinder or cone and height along it, over the parameter of an edge.
///
/// The height of a cone is that of STEP, along its axis; readers that count along rulings divide it by a constant.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PolarCurve {
    /// Bernstein coefficients, of one degree.
    places: Vec<[f64; 2]>,
    /// Where the edge's own parameter ends.
    range: f64,
}

impl PolarCurve {
    /// The curve of a rational edge on a cylinder or cone about the third axis of its frame, which it does not cross where the angle is 0;
    /// `None` on other surfaces, and if no polynomial of the readers' degrees is near enough for a model of this size.
    pub(super) fn of(edge: &RationalBezier, kind: &PatchKind, size: f64) -> Option<Self> {
        let (radius, cos) = match kind {
            PatchKind::Cylinder { radius, .. } => (*radius, 1.0),
            PatchKind::Cone { frame, half_angle, .. } => (largest_radius(frame, edge), half_angle.cos()),
            _ => return None,
        };
        let limit = limit(edge.point(0.0), radius, size);
        Self::followed(kind, |x| edge.point(x), [limit / radius, limit * cos], 1.0)
    }

    /// The curve of an arc on a sphere, over its angle; `None` likewise, and where it comes near a pole.
    pub(super) fn of_arc(arc: &Arc, kind: &PatchKind, size: f64) -> Option<Self> {
        let PatchKind::Sphere { radius, .. } = kind else { return None };
        let limit = limit(arc.start(), *radius, size) / radius;
        Self::followed(kind, |x| arc.point_at_length(x), [limit; 2], arc.angle())
    }

    /// The places of the points of an edge as polynomials within limits; their angle is that of the middle, in `[0, 2π)`, and goes on from there.
    fn followed(kind: &PatchKind, point: impl Fn(f64) -> Point3, limits: [f64; 2], range: f64) -> Option<Self> {
        let middle = place(kind, point(0.5))?[0].rem_euclid(TAU);
        let at = |x: f64| {
            let [angle, height] = place(kind, point(x)).unwrap_or([f64::NAN; 2]);
            [angle + TAU * ((middle - angle) / TAU).round(), height]
        };
        let crosses = |x: f64| !(-AT_SEAM..=TAU + AT_SEAM).contains(&at(x)[0]);
        if [0.0, 0.25, 0.75, 1.0].into_iter().any(crosses) {
            return None;
        }
        let curves = limits.into_iter().enumerate().map(|(k, limit)| (series(|x| at(x)[k]), limit));
        let curves: Vec<(Vec<f64>, f64)> = curves.collect();
        let degree = curves.iter().map(|(terms, limit)| degree(terms, *limit)).max()?;
        if degree > LARGEST_DEGREE {
            return None;
        }
        let [angles, heights] = [0, 1].map(|k: usize| curves.get(k).map(|(terms, _)| bernstein(&terms[..=degree])));
        let mut places: Vec<[f64; 2]> = angles?.into_iter().zip(heights?).map(|(u, v)| [u, v]).collect();
        (places[0], places[degree]) = (at(0.0), at(1.0));
        Some(Self { places, range })
    }

    /// The curve over its range: `[0, 1]` of rational edges.
    pub(super) fn write(&self, data: &mut Data) -> usize {
        let points = self.places.iter().map(|place| data.parameter_point(*place)).collect();
        spline(data, points, None, self.range)
    }
}

/// How far the curve may leave the edge.
fn limit(start: Point3, radius: f64, size: f64) -> f64 {
    LARGEST_ERROR * size + ROUNDING * (start.to_vec().max_abs() + radius)
}

/// The distance from the third axis of a frame that no point of the edge, whose weights are positive, exceeds.
fn largest_radius(frame: &Frame, edge: &RationalBezier) -> f64 {
    let from_axis = |[x, y, z, w]: &[f64; 4]| {
        let (flat, _) = frame.to_local(Point3::new(x / w, y / w, z / w));
        flat.x.hypot(flat.y)
    };
    edge.rows().iter().map(from_axis).fold(0.0, f64::max)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
mod tests {
    use super::*;
    use cyclide::{Vec3, rational::NurbsCurve};

    const RADIUS: f64 = 2.0;

    fn cylinder(frame: Frame) -> PatchKind {
        PatchKind::Cylinder { frame, radius: RADIUS, outward: true }
    }

    /// Where a plane that leans by a slope cuts the cylinder, over an angle about the middle of the face's side.
    fn cut(angle: f64, slope: f64) -> RationalBezier {
        let row = |u: f64, w: f64| [-RADIUS * u.cos(), RADIUS * u.sin(), -RADIUS * slope * u.cos() + 7.0 * w, w];
        let half = 0.5 * angle;
        // The tangents at the ends meet in the middle, at the distance radius / cos.
        let middle = [-RADIUS, 0.0, -RADIUS * slope + 7.0 * half.cos(), half.cos()];
        RationalBezier::new(vec![row(-half, 1.0), middle, row(half, 1.0)]).unwrap()
    }

    #[test]
    fn edges_are_followed_to_the_limit_and_end_where_they_end() {
        for size in [1.0, 100.0] {
            for (angle, slope) in [(0.3, 0.0), (1.0, 0.5), (1.6, 3.0), (2.0, -1.0)] {
                let edge = cut(angle, slope);
                let curve = PolarCurve::of(&edge, &cylinder(Frame::WORLD), size).unwrap();
                let n = curve.places.len();
                let points = curve.places.iter().map(|&[u, v]| Point3::new(u, v, 0.0)).collect();
                let knots = [vec![0.0; n], vec![1.0; n]].concat();
                let spline = NurbsCurve::new(n - 1, knots, points, vec![1.0; n]).unwrap();
                for k in 0..=1000 {
                    let x = f64::from(k) / 1000.0;
                    let at = spline.point_at_knot(x);
                    let p = Point3::new(RADIUS * at.x.cos(), RADIUS * at.x.sin(), at.y);
                    // Two curves within their limits, and rounding of numbers below 20.
                    let limit = 2.0 * LARGEST_ERROR * size + 1e-13;
                    assert!(p.distance(edge.point(x)) <= limit, "{angle} {slope}: {:e}", p.distance(edge.point(x)));
                }
                assert_eq!(
                    [curve.places[0], curve.places[n - 1]],
                    [0.0, 1.0].map(|x| {
                        let [u, v] = place(&cylinder(Frame::WORLD), edge.point(x)).unwrap();
                        [u.rem_euclid(TAU), v]
                    })
                );
            }
        }
    }

    #[test]
    fn edges_through_the_seam_have_none() {
        let seam = Frame::from_normal(Point3::ORIGIN, Vec3::Z, -Vec3::X).unwrap();
        assert_eq!(PolarCurve::of(&cut(1.0, 0.5), &cylinder(seam), 1.0), None);
    }
}
