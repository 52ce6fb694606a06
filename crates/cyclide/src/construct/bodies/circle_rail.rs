//! A whole circle as a rail beside a closed curve: cut where the joints of that curve are.
//!
//! A circle has no joints of its own. Each joint of the other curve has a direction from the middle of that curve, seen along the axis of the circle;
//! the circle is cut in these directions from its center (`docs/math/circular-surfaces.md#lines-between-rails`). So the lines to the corners of a
//! square have no twist, and a circle beside an ellipse that starts in the same direction keeps its start.

use std::f64::consts::TAU;

use super::rail_surface::RailSurface;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, Circle};
use crate::error::{PointError, Result};
use crate::topology::EdgeCurve;

/// Places of each piece by which the middle of a curve is found.
const PLACES: u32 = 16;
/// Directions nearer than this, radians, are that of the start of the circle: rounding.
const SAME: f64 = 1e-12;
/// The circle is not cut into narrower arcs than this, radians.
const NARROWEST: f64 = 1e-9;

impl RailSurface {
    /// A whole circle in as many arcs as another closed curve has pieces, as a rail beside it.
    ///
    /// It is cut where the joints of the other curve are, seen from the middle of that curve along the axis of the circle; the first arc starts in
    /// the direction of the start of the other curve. Where the joints do not follow each other once round, it is cut into equal arcs from its own start.
    /// A curve that runs the other way gets the same joints in the order of the circle.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, construct::{Ellipse, RailSurface}, curve::Circle, topology::EdgeCurve};
    /// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 20.0)?;
    /// let oval = Ellipse::new(Point3::new(0.0, 0.0, 40.0), Vec3::Z, None, [25.0, 12.0])?.to_nurbs(0.0, std::f64::consts::TAU)?;
    /// let oval: Vec<EdgeCurve> = oval.to_beziers().into_iter().map(EdgeCurve::from).collect();
    /// let cut = RailSurface::cut_circle(&circle, &oval)?;
    /// assert_eq!(cut.len(), oval.len());
    /// let duct = RailSurface::ruled([&cut, &oval], true)?;
    /// assert_eq!(duct.body().outer.faces().len(), 4);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `too-few-points` (fewer than two pieces).
    pub fn cut_circle(circle: &Circle, other: &[EdgeCurve]) -> Result<Vec<EdgeCurve>> {
        if other.len() < 2 {
            return Err(PointError::TooFewPoints { given: other.len(), needed: 2 }.into());
        }
        let equal = || (0..other.len()).map(|k| TAU * k as f64 / other.len() as f64).collect();
        let angles: Vec<f64> = joint_angles(circle, other).unwrap_or_else(equal);
        let points: Vec<Point3> = angles.iter().map(|angle| at(circle, *angle)).collect();
        let next = points.iter().cycle().skip(1);
        let arcs = points.iter().zip(next).map(|(start, end)| {
            let tangent = circle.normal().cross(*start - circle.center());
            Arc::from_start_tangent(*start, *end, tangent).map(EdgeCurve::from)
        });
        arcs.collect()
    }
}

/// The point of a circle at an angle from its start; the start itself to the bit.
fn at(circle: &Circle, angle: f64) -> Point3 {
    if angle.abs() <= SAME {
        return circle.start();
    }
    let spoke = circle.start() - circle.center();
    let (sin, cos) = angle.sin_cos();
    circle.center() + spoke * cos + circle.normal().cross(spoke) * sin
}

/// The angles of the joints of a curve seen from its middle, in the sense of the circle; `None` unless they go round once.
fn joint_angles(circle: &Circle, other: &[EdgeCurve]) -> Option<Vec<f64>> {
    let outline: Vec<Point3> =
        other.iter().flat_map(|piece| (0..PLACES).map(|k| piece.point(f64::from(k) / f64::from(PLACES)))).collect();
    let middle = middle(&outline)?;
    let spoke = (circle.start() - circle.center()).unit()?;
    let side = circle.normal().cross(spoke);
    let angle = |p: Point3| {
        let v = p - middle;
        v.dot(side).atan2(v.dot(spoke))
    };
    let mut angles: Vec<f64> = other.iter().map(|piece| angle(piece.start())).collect();
    if area(&outline, middle).dot(circle.normal()) < 0.0 {
        angles[1..].reverse();
    }
    let steps = || angles.iter().zip(angles.iter().cycle().skip(1)).map(|(from, to)| (to - from).rem_euclid(TAU));
    let once = (steps().sum::<f64>() - TAU).abs() < 1.0;
    (once && steps().all(|step| step >= NARROWEST)).then_some(angles)
}

/// The middle of a closed polygon, each side by its length.
fn middle(outline: &[Point3]) -> Option<Point3> {
    let first = *outline.first()?;
    let sides = outline.iter().zip(outline.iter().cycle().skip(1));
    let (sum, length) = sides.fold((Vec3::ZERO, 0.0), |(sum, length), (a, b)| {
        let own = a.distance(*b);
        (sum + ((*a - first) + (*b - first)) * (0.5 * own), length + own)
    });
    (length > 0.0).then(|| first + sum * (1.0 / length))
}

/// Twice the area that a closed polygon goes round, as a vector.
fn area(outline: &[Point3], middle: Point3) -> Vec3 {
    let sides = outline.iter().zip(outline.iter().cycle().skip(1));
    sides.fold(Vec3::ZERO, |sum, (a, b)| sum + (*a - middle).cross(*b - middle))
}
