//! Curves parallel to those of a torus, along its normal, in their exact rational form (`docs/math/torus-splines.md#parallel-curves`).
//!
//! With the polynomials of [rows](super::rows), `w = n0 w'`, the direction from the axis is `W²/(n0 n1 n2)`, so that `p + d n` is
//! ```text
//! x + i y = W² ((1 + d/b) c² n1 n2 n3 - (d/b) w'),   z = (1 + d/b) n1 n2 z,   w = n0 n1 n2 w'
//! ```
//! of degree 4, 6 or 8: two more for each kind of Villarceau circles that the type has.

use super::Torus;
use super::family::CircleFamily;
use super::piece::TorusPiece;
use super::rows::{conj, product, square_norm};
use super::spline::TorusSpline;
use crate::base::bernstein::product as real_product;
use crate::base::complex::Complex;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, Result};
use crate::rational::{NurbsCurve, RationalBezier};

/// Halvings of a piece until its weights are positive, which are a sum of squares.
const HALVINGS: u32 = 24;

impl TorusSpline {
    /// The curve at a distance along the outward normal of the torus, negative inwards, exactly: on the torus whose tube is so much thicker, at the same angles.
    ///
    /// ```
    /// use cyclide::{Frame, curve::ParamCurve as _, surface::{Torus, TorusSpline}};
    /// let knot = TorusSpline::knot(&Torus::new(Frame::WORLD, 40.0, 15.0)?, [2, 3], Default::default())?;
    /// let parallel = knot.parallel(2.0)?;
    /// let thicker = Torus::new(Frame::WORLD, 40.0, 17.0)?;
    /// assert!(thicker.distance(parallel.point(0.3)).abs() < 1e-12);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `parameter-out-of-range` (a distance that reaches the middle of the tube or the axis), `weight-not-positive`, `not-a-spline`: as
    /// [`to_nurbs`](Self::to_nurbs).
    pub fn parallel(&self, distance: f64) -> Result<NurbsCurve> {
        let (a, b) = (self.torus.major_radius(), self.torus.minor_radius());
        let (min, max) = (-b, a - b);
        if !(distance > min && distance < max) {
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::Distance, value: distance, min, max }.into()
            );
        }
        range::check_distance(b + distance)?;
        // Of a closed curve the last joint is the first one to the bit, as in the curve itself.
        let end = self.pieces.last().map(|piece| if self.closed { self.pieces[0].start() } else { piece.place(1.0) });
        let places = self.pieces.iter().map(TorusPiece::start).chain(end);
        let joints: Vec<Point3> =
            self.joints.iter().zip(places).map(|(p, at)| *p + self.torus.unit_normal(at) * distance).collect();
        let (mut curves, mut intervals, mut starts) = (Vec::new(), Vec::new(), Vec::new());
        for (i, piece) in self.pieces.iter().enumerate() {
            starts.push(curves.len());
            let parts = self.torus.parallel_parts(piece, distance / b);
            let last = parts.len() - 1;
            for (k, (curve, share)) in parts.into_iter().enumerate() {
                let ends = [(k == 0).then_some(joints[i]), (k == last).then_some(joints[i + 1])];
                curves.push(curve.with_ends(ends[0], ends[1]));
                intervals.push((self.knots[i + 1] - self.knots[i]) * share);
            }
        }
        starts.push(curves.len());
        let degree = curves.iter().map(RationalBezier::degree).max().unwrap_or(0);
        for curve in curves.iter_mut().filter(|curve| curve.degree() < degree) {
            let ends: [Point3; 2] = [0.0, 1.0].map(|s| curve.point(s));
            *curve = curve.multiplied(&vec![1.0; degree - curve.degree() + 1]).with_ends(Some(ends[0]), Some(ends[1]));
        }
        let curve = NurbsCurve::from_beziers(&curves, &intervals)?;
        // A point times its weight and divided by it again is rounded: joints are put in as they are.
        let mut points = curve.control_points().to_vec();
        for (joint, start) in joints.iter().zip(starts) {
            points[start * degree] = *joint;
        }
        NurbsCurve::new(degree, curve.knots().to_vec(), points, curve.weights().to_vec())
    }
}

impl Torus {
    /// Parts with positive weights, and which share of the parameter each has; the distance in parts of the radius of the tube.
    fn parallel_parts(&self, piece: &TorusPiece, distance: f64) -> Vec<(RationalBezier, f64)> {
        let (mut parts, mut ahead) = (Vec::new(), vec![([0.0, 1.0], HALVINGS)]);
        while let Some(([from, to], halvings)) = ahead.pop() {
            let whole = from <= 0.0 && to >= 1.0;
            let curve = self.parallel_piece(&if whole { *piece } else { piece.part(from, to) }, distance);
            if halvings == 0 || curve.has_positive_weights() {
                parts.push((curve, to - from));
            } else {
                let middle = 0.5 * (from + to);
                ahead.extend([([middle, to], halvings - 1), ([from, middle], halvings - 1)]);
            }
        }
        parts
    }

    fn parallel_piece(&self, piece: &TorusPiece, distance: f64) -> RationalBezier {
        let mut z: [Vec<Complex>; 4] = std::array::from_fn(|_| vec![Complex::ONE]);
        for (i, family) in piece.quartic_type().families().into_iter().enumerate() {
            let (unit, course) = piece.course(i);
            z[family.index()] = if course.is_still() { vec![unit] } else { vec![unit, unit * course.ratio] };
        }
        let of = |family: CircleFamily| z[family.index()].as_slice();
        let (z0, z1) = (of(CircleFamily::Parallel), of(CircleFamily::Villarceau));
        let (z2, z3) = (of(CircleFamily::MirrorVillarceau), of(CircleFamily::Meridian));
        let (w, v) = (product(&product(z0, z1), z2), product(&product(z1, &conj(z2)), z3));
        let real = |p: &[Complex]| p.iter().map(|n| n.re).collect::<Vec<f64>>();
        let (re, im): (Vec<f64>, Vec<f64>) = v.iter().map(|v| (v.re, v.im)).unzip();
        let shape = &self.shape;
        let (re2, im2) = (real_product(&re, &re), real_product(&im, &im));
        let weight: Vec<f64> = re2.iter().zip(&im2).map(|(r, i)| shape.thin * r + shape.wide * i).collect();
        let n12 = real(&product(&square_norm(z1), &square_norm(z2)));
        let wider = 1.0 + distance;
        let reach = real_product(&n12, &real(&square_norm(z3)));
        let plane = wider * shape.thin * shape.wide;
        let reach: Vec<Complex> =
            reach.iter().zip(&weight).map(|(r, w)| Complex::new(plane * r - distance * w, 0.0)).collect();
        let xy = product(&product(&w, &w), &reach);
        let n012 = real_product(&real(&square_norm(z0)), &n12);
        let height = real_product(&n012, &real_product(&re, &im));
        let weight = real_product(&n012, &weight);
        let largest = weight.iter().fold(0.0, |m: f64, w| m.max(w.abs()));
        let origin = self.frame().origin().to_vec();
        let rise = 2.0 * wider * shape.tube * shape.root;
        let row = |k: usize| {
            let local = Vec3::new(xy[k].re, xy[k].im, rise * height[k]) / largest;
            let (v, w) = (self.world_vector(local), weight[k] / largest);
            let v = v + origin * w;
            [v.x, v.y, v.z, w]
        };
        RationalBezier::from_rows_unchecked((0..xy.len()).map(row).collect())
    }
}
