//! Curves in the parameters of cylinders, for rational edges that are neither parallels nor rulings of theirs.
//!
//! Left alone, OpenCASCADE interpolates such a curve at some places and misses its own tolerance between them (8e-7 on a tee of
//! size 240: not valid by its exact check). The angle about the axis is no rational function of the edge's parameter. So angle and
//! height are polynomials: their Chebyshev series over the edge, cut where what is left out is below rounding and 1e-13 of the
//! model's size, a tenth of what the check of the file lets pass. An edge that would take a degree beyond the
//! readers' is not written so, and its face stays rational.

use super::data::Data;
use super::parameter_curves::{LARGEST_DEGREE, bernstein, degree, series, spline};
use cyclide::{Frame, Point3, RationalBezier};
use std::f64::consts::TAU;

/// Part of the model's size by which the curve in the parameters may leave the edge.
const LARGEST_ERROR: f64 = 1e-13;
/// Roundings of a coordinate that are no error of a curve.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Angle about the axis of a cylinder and height along it, over the parameter of an edge.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CylinderCurve {
    /// Bernstein coefficients, of one degree.
    places: Vec<[f64; 2]>,
}

impl CylinderCurve {
    /// The curve of a rational edge on the cylinder about the third axis of a frame, whose first axis is on the other side; `None` if no
    /// polynomial of the readers' degrees is near enough for a model of this size.
    pub(super) fn of(edge: &RationalBezier, (frame, radius): (&Frame, f64), size: f64) -> Option<Self> {
        let place = |x: f64| place_on(frame, edge.point(x));
        let limit = LARGEST_ERROR * size + ROUNDING * (edge.point(0.0).to_vec().max_abs() + radius);
        let curves = [limit / radius, limit].into_iter().enumerate().map(|(k, limit)| (series(|x| place(x)[k]), limit));
        let curves: Vec<(Vec<f64>, f64)> = curves.collect();
        let degree = curves.iter().map(|(terms, limit)| degree(terms, *limit)).max()?;
        if degree > LARGEST_DEGREE {
            return None;
        }
        let [angles, heights] = [0, 1].map(|k: usize| curves.get(k).map(|(terms, _)| bernstein(&terms[..=degree])));
        let mut places: Vec<[f64; 2]> = angles?.into_iter().zip(heights?).map(|(u, v)| [u, v]).collect();
        (places[0], places[degree]) = (place(0.0), place(1.0));
        Some(Self { places })
    }

    /// The curve over `[0, 1]`, the range of rational edges.
    pub(super) fn write(&self, data: &mut Data) -> usize {
        let points = self.places.iter().map(|place| data.parameter_point(*place)).collect();
        spline(data, points, None, 1.0)
    }
}

/// Angle from the first axis of a frame, in `[0, 2π)`, and height.
fn place_on(frame: &Frame, p: Point3) -> [f64; 2] {
    let (flat, height) = frame.to_local(p);
    [flat.y.atan2(flat.x).rem_euclid(TAU), height]
}
