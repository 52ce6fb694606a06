//! Random input for property tests, with the places where geometry goes wrong well represented: points that differ by
//! a few units in the last place, nearly collinear points, nearly straight and nearly full arcs, coordinates far from
//! the origin, tiny and huge scales.

use cyclide::{Point3, Quat, Vec3, curve::Arc};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// Ten to a power from the range.
fn decades(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|e| 10.0_f64.powf(e))
}

/// Sizes: mostly near 1, also so small or large that squares lose or overflow the range of doubles.
pub fn scale() -> impl Strategy<Value = f64> {
    prop_oneof![4 => Just(1.0), 3 => decades(-6.0..6.0), 1 => Just(1e-130), 1 => Just(1e-60), 1 => Just(1e60), 1 => Just(1e130)]
}

/// A unit vector, sometimes along an axis.
pub fn direction() -> impl Strategy<Value = Vec3> {
    let any = (-1.0..1.0, -PI..PI).prop_map(|(z, phi): (f64, f64)| {
        let r = ((1.0 - z) * (1.0 + z)).sqrt();
        Vec3::new(r * phi.cos(), r * phi.sin(), z)
    });
    prop_oneof![6 => any, 1 => Just(Vec3::X), 1 => Just(Vec3::Y), 1 => Just(-Vec3::Z)]
}

/// A point in the cube of half edge 1.
pub fn point() -> impl Strategy<Value = Point3> {
    (-1.0..1.0, -1.0..1.0, -1.0..1.0).prop_map(|(x, y, z)| Point3::new(x, y, z))
}

/// A point near another one: at a random place, nearby, or a few units in the last place away (possibly equal).
pub fn neighbor(of: Point3) -> impl Strategy<Value = Point3> {
    let ulps = (-4_i8..=4, -4_i8..=4, -4_i8..=4).prop_map(move |(i, j, k)| {
        let [x, y, z] = of.to_array();
        Point3::new(stepped(x, i), stepped(y, j), stepped(z, k))
    });
    let near = (direction(), decades(-12.0..-1.0)).prop_map(move |(d, l)| of + d * l);
    prop_oneof![5 => point(), 2 => near, 1 => ulps]
}

/// The double `steps` units in the last place away.
fn stepped(x: f64, steps: i8) -> f64 {
    let step = |x: f64| if steps > 0 { x.next_up() } else { x.next_down() };
    (0..steps.unsigned_abs()).fold(x, |x, _| step(x))
}

/// Three points: general, nearly collinear, or close together; scaled, possibly far from the origin.
pub fn three_points() -> impl Strategy<Value = [Point3; 3]> {
    let general = point().prop_flat_map(|a| (Just(a), neighbor(a), neighbor(a))).prop_map(|(a, b, c)| [a, b, c]);
    let flat = (point(), point(), -1.0..2.0, direction(), decades(-17.0..-2.0)).prop_map(|(a, c, t, d, h)| {
        let b: Point3 = a.lerp(c, t) + d * h;
        [a, b, c]
    });
    let shape = prop_oneof![general, flat];
    (shape, scale(), offset()).prop_map(|(points, s, o)| points.map(|p| Point3::ORIGIN + (p.to_vec() + o) * s))
}

/// A displacement of unit-size data from the origin.
fn offset() -> impl Strategy<Value = Vec3> {
    (direction(), prop_oneof![3 => Just(0.0), 1 => Just(1.0), 1 => decades(1.0..7.0)]).prop_map(|(d, l)| d * l)
}

/// Half a swept angle as (cosine, sine): general, nearly straight, exactly straight, about a half turn, nearly full.
fn half_angle() -> impl Strategy<Value = (f64, f64)> {
    let of = |alpha: f64| (alpha.cos(), alpha.sin());
    prop_oneof![
        6 => (1e-2..PI - 1e-2).prop_map(of),
        2 => decades(-17.0..-2.0).prop_map(of),
        1 => Just((1.0, 0.0)),
        1 => (-1e-12..1e-12).prop_map(move |d| of(FRAC_PI_2 + d)),
        2 => decades(-6.6..-2.0).prop_map(|d| (-d.cos(), d.sin())),
    ]
}

/// An arc with what its rounding depends on.
#[derive(Debug, Clone, Copy)]
pub struct ArcCase {
    /// The arc.
    pub arc: Arc,
    /// Largest coordinate of the ends, or the diameter of the circle where the arc goes round most of it.
    pub size: f64,
    /// Amplification of rounding: near a full circle, 1 over the sine of half the sweep; where the parameter runs very
    /// unevenly, the largest speed over the mean one.
    pub condition: f64,
}

impl ArcCase {
    /// Rounding of a point of the arc in `units` of the last place of its size.
    #[must_use]
    pub fn rounding(&self, units: f64) -> f64 {
        units * f64::EPSILON * self.size * self.condition
    }
}

/// Arcs of every shape, scale, place and parametrisation.
pub fn arc() -> impl Strategy<Value = ArcCase> {
    arc_from(half_angle(), prop_oneof![2 => Just(1.0), 1 => decades(-3.0..3.0)], offset())
}

/// Arcs well away from the full circle and near the origin, of every scale: for laws about derivatives and inversions,
/// whose own bounds grow fast with the condition.
pub fn tame_arc() -> impl Strategy<Value = ArcCase> {
    let half_angle =
        prop_oneof![4 => 1e-2..3.0, 1 => decades(-17.0..-2.0)].prop_map(|alpha: f64| (alpha.cos(), alpha.sin()));
    arc_from(half_angle, 0.2..5.0, direction())
}

/// Arcs with these cosines and sines of half the sweep, lengths of the weight, and displacements from the origin.
fn arc_from(
    half_angle: impl Strategy<Value = (f64, f64)>,
    speed: impl Strategy<Value = f64>,
    offset: impl Strategy<Value = Vec3>,
) -> impl Strategy<Value = ArcCase> {
    let shape = (direction(), direction(), half_angle, speed);
    (shape, scale(), offset).prop_filter_map("no plane", |((d, toward, (r, s), n), scale, offset)| {
        let p0 = Point3::ORIGIN + offset * scale;
        let p1 = p0 + d * scale;
        // Far from the origin the chord is rounded: the weight is made for the chord as it is.
        let c = (p1 - p0).unit()?;
        let normal = d.cross(toward).unit()?;
        let across = (normal - c * normal.dot(c)).unit()?;
        let arc = Arc::from_weight_ratio(p0, p1, Quat::from_parts(r, across * s) * n).ok()?;
        Some(with_rounding(arc))
    })
}

/// The rounding of a given arc.
#[must_use]
pub fn with_rounding(arc: Arc) -> ArcCase {
    let w = arc.weight_ratio();
    let sine = w.vector().length() / w.norm();
    let (reach, condition) =
        if w.w >= 0.0 { (arc.chord().length(), 1.0) } else { (arc.chord().length() / sine, 1.0 / sine) };
    let condition = condition * w.norm().max(1.0 / w.norm());
    let size = arc.start().to_vec().max_abs().max(arc.end().to_vec().max_abs()).max(reach);
    ArcCase { arc, size, condition }
}

/// Any double at all: zeros, subnormals, huge, infinite, not a number.
pub fn wild() -> impl Strategy<Value = f64> {
    prop_oneof![3 => any::<f64>(), 2 => -1.0..1.0, 1 => Just(0.0), 1 => Just(1.0), 1 => Just(-1.0)]
}

/// A vector of any doubles.
pub fn wild_vector() -> impl Strategy<Value = Vec3> {
    (wild(), wild(), wild()).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

/// A point of any doubles.
pub fn wild_point() -> impl Strategy<Value = Point3> {
    wild_vector().prop_map(|v| Point3::ORIGIN + v)
}
