//! The segment between two nodes: its two circles, the angle between them and the way from one to the other.

use super::angle_law::{AngleLaw, BlendLaw, BlendVariant, MAX_ORDER};
use crate::base::bounds::Aabb;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::curve::arc::Arc;
use crate::curve::node_tangent::Chord;
use crate::curve::qb::SpanData;
use crate::error::{ArcError, Error, ErrorItem, NumberError, PointError, Result};

/// Neighbors closer than this part of the bounding box's diagonal coincide: the tangent has no limit there.
const COINCIDENT_LIMIT: f64 = 1e-12;
/// A start tangent this close to the reversed chord has its circle through infinity.
const INFINITY_LIMIT: f64 = 1e-9;
/// A segment whose tangents come this close to the reversed chord has no form for files: its points are as many chords
/// away, and known to as many roundings of that.
const NEAR_INFINITY: f64 = 5e-7;
/// Below this the sum of the two tangents is zero for tangents given by the user.
const OPPOSITE_LIMIT: f64 = 1e-12;
/// Rounding of the points widens that limit up to here: directions that are known worse oppose each other by chance.
const OPPOSITE_BY_ROUNDING: f64 = 1e-6;

/// A blend of two circular arcs over one chord, parameter `l` in `[0, 1]`.
///
/// It starts like the first arc and ends like the second, touching each to the blend order. Made by
/// [`CircleSpline`](crate::curve::CircleSpline) from points, or on its own from four points or from ends and tangents.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{BlendSegment, BlendVariant}};
/// let (a, b) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
/// let segment = BlendSegment::hermite(a, Vec3::Y, b, Vec3::Z, 2, BlendVariant::Rational)?;
/// assert!((segment.start_tangent() - Vec3::Y).length() < 1e-15 && (segment.end_tangent() - Vec3::Z).length() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlendSegment {
    pub(super) x1: Point3,
    pub(super) x2: Point3,
    /// Unit chord.
    pub(super) u: Vec3,
    /// Chord length.
    pub(super) length: f64,
    /// Start tangent of the first arc, unit.
    pub(super) t1: Vec3,
    /// Unit vector across `t1`: the tangents run along the great circle `cos(phi) t1 + sin(phi) b`.
    pub(super) b: Vec3,
    pub(super) law: AngleLaw,
    /// The part of the whole segment that this one covers; `[0, 1]` unless it was cut.
    pub(super) range: [f64; 2],
    long_way: bool,
    opposite: bool,
}

/// The two start tangents at `x1` of a blend, and what their rounding is relative to.
pub(crate) struct BlendTangents {
    /// Start tangent of the first arc, unit.
    pub(crate) start: Vec3,
    /// Start tangent **at `x1`** of the second arc, unit: the reflection of its tangent at `x2`.
    pub(crate) end: Vec3,
    /// Largest coordinate over shortest chord of the points behind the tangents; 0 for tangents given as such.
    pub(crate) magnification: f64,
}

impl BlendSegment {
    /// The segment between two points with given tangents at both of them (any length but zero;
    /// `docs/math/circle-blends.md#segment`).
    ///
    /// # Errors
    /// `not-finite`, `coincident-points` (equal), `zero-tangent`, `order-out-of-range`, `arc-through-infinity` (a
    /// tangent within 1e-9 of the reversed chord), `ambiguous-half-turn`.
    pub fn hermite(
        start: Point3,
        start_tangent: Vec3,
        end: Point3,
        end_tangent: Vec3,
        order: u32,
        variant: BlendVariant,
    ) -> Result<Self> {
        check_order(order)?;
        Self::between([start, end], [start_tangent, end_tangent], BlendLaw::of(variant, order))
    }

    /// The segment of a fair circle spline between two points with given tangents (any length but zero) and blend `e`
    /// in `[0, 1]` (`docs/math/fair-splines.md#law-and-end-curvature`).
    ///
    /// # Errors
    /// As [`hermite`](Self::hermite), and `parameter-out-of-range` (blend).
    pub fn fair(start: Point3, start_tangent: Vec3, end: Point3, end_tangent: Vec3, blend: f64) -> Result<Self> {
        if !(0.0..=1.0).contains(&blend) {
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::Blend, value: blend, min: 0.0, max: 1.0 }.into()
            );
        }
        Self::between([start, end], [start_tangent, end_tangent], BlendLaw::Fair { blend })
    }

    fn between([start, end]: [Point3; 2], [start_tangent, end_tangent]: [Vec3; 2], law: BlendLaw) -> Result<Self> {
        let limit = check_points(&[start, end])?;
        let chord = Chord::new(start, end);
        if chord.length <= limit {
            return Err(PointError::CoincidentPoints { first: 0, second: 1, distance: chord.length, limit }.into());
        }
        let (t1, te) = (unit_tangent(start_tangent, 0)?, unit_tangent(end_tangent, 1)?);
        let tangents = BlendTangents { start: t1, end: te.reflect(chord.unit), magnification: 0.0 };
        Self::from_tangents([start, end], &chord, &tangents, law, 0)
    }

    /// Blend angle, direction of turning and orientation test (`docs/math/circle-blends.md#long-way`), for checked
    /// data.
    pub(crate) fn from_tangents(
        [x1, x2]: [Point3; 2],
        chord: &Chord,
        tangents: &BlendTangents,
        law: BlendLaw,
        segment: usize,
    ) -> Result<Self> {
        let (u, t1, t2) = (chord.unit, tangents.start, tangents.end);
        let (from_pole1, from_pole2) = (u + t1, u + t2);
        let smallest = from_pole1.length_squared().min(from_pole2.length_squared());
        if smallest <= INFINITY_LIMIT * INFINITY_LIMIT {
            return Err(ArcError::ThroughInfinity { segment, reach: f64::INFINITY, limit: 1.0 / INFINITY_LIMIT }.into());
        }
        let (mut a, g) = (t1 + t2, t2 - t1);
        let gn = g.length_squared().sqrt();
        let mut an = a.length_squared().sqrt();
        let rounding = OPPOSITE_LIMIT.max((16.0 * f64::EPSILON * tangents.magnification).min(OPPOSITE_BY_ROUNDING));
        let opposite = an <= rounding;
        let mut long_way = false;
        let (half, b) = if opposite {
            // The half turn goes through the plane of t1 and the chord (`004`, (50)).
            let across = u - t1 * u.dot(t1);
            let sine = across.length();
            let ambiguous = Error::Arc(ArcError::AmbiguousHalfTurn { segment, sine, limit: INFINITY_LIMIT });
            if across.length_squared() <= INFINITY_LIMIT * INFINITY_LIMIT {
                return Err(ambiguous);
            }
            ([0.0, 1.0], across.unit().ok_or(ambiguous)?)
        } else {
            if an < gn {
                // Rounding of a along g would be divided by |a|.
                a = a - g * (a.dot(g) / g.length_squared());
                an = a.length_squared().sqrt();
            }
            let size = an.hypot(gn);
            let (c, s) = (an / size, gn / size);
            let across = if gn > 0.0 { g * (c / gn) + a * (s / an) } else { Vec3::ZERO };
            // The product form of the orientation test (C): its expansion loses the sign near t = -u.
            long_way = from_pole1.dot(from_pole2) < 0.0;
            if long_way { ([-c, s], -across) } else { ([c, s], across) }
        };
        let theta = 2.0 * half[1].atan2(half[0]);
        let law = AngleLaw { law, theta, half };
        Ok(Self { x1, x2, u, length: chord.length, t1, b, law, range: [0.0, 1.0], long_way, opposite })
    }

    /// Start point.
    #[must_use]
    pub fn start(&self) -> Point3 {
        self.point(0.0)
    }

    /// End point.
    #[must_use]
    pub fn end(&self) -> Point3 {
        self.point(1.0)
    }

    /// Unit tangent at the start.
    #[must_use]
    pub fn start_tangent(&self) -> Vec3 {
        // The derivative never vanishes: |x'| = |d| at the ends of a whole segment.
        self.jet(0.0).tangent().unwrap_or(self.t1)
    }

    /// Unit tangent at the end.
    #[must_use]
    pub fn end_tangent(&self) -> Vec3 {
        self.jet(1.0).tangent().unwrap_or(self.u)
    }

    /// Length of the chord of the whole segment.
    #[must_use]
    pub fn chord_length(&self) -> f64 {
        self.length
    }

    /// The angle law.
    #[must_use]
    pub fn law(&self) -> BlendLaw {
        self.law.law
    }

    /// Blend angle between the two circles in the direction the blend takes, in `[0, 2 pi)`, radians.
    #[must_use]
    pub fn theta(&self) -> f64 {
        self.law.theta
    }

    /// True if the blend turns by more than half a turn, because the short way would pass through infinity.
    #[must_use]
    pub fn long_way(&self) -> bool {
        self.long_way
    }

    /// True if the circles run in opposite directions: the half turn between them was chosen to contain the chord,
    /// and a small change of the data moves the curve a lot.
    #[must_use]
    pub fn opposite_circles(&self) -> bool {
        self.opposite
    }

    /// True if the segment is one circular arc or straight segment, up to the rounding of its ends: the angle moves
    /// no point by more than 16 roundings of the largest coordinate.
    #[must_use]
    pub fn is_arc(&self) -> bool {
        let size = self.x1.to_vec().max_abs().max(self.x2.to_vec().max_abs());
        self.law.theta * self.length <= 16.0 * f64::EPSILON * size.max(self.length)
    }

    /// The segment as one circular arc or straight segment with the same parameter, where it [is one](Self::is_arc).
    #[must_use]
    pub fn to_arc(&self) -> Option<Arc> {
        if !self.is_arc() {
            return None;
        }
        let whole = Arc::from_start_tangent(self.x1, self.x2, self.t1 * self.length).ok()?.settled();
        let [a, b] = self.range;
        whole.restricted(a, b).ok()
    }

    /// The part `[a, b]` of the whole segment's parameter that this segment covers: `[0, 1]` unless it was cut.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Parameter of the whole segment that belongs to `l`; exact at both ends.
    pub(super) fn whole_parameter(&self, l: f64) -> f64 {
        let [a, b] = self.range;
        a * (1.0 - l) + b * l
    }

    /// The part between two parameters, `0 <= l0 < l1 <= 1`; same points, parameter stretched.
    ///
    /// # Errors
    /// `parameter-out-of-range` (also when the two ends fall on one double).
    pub fn restricted(&self, l0: f64, l1: f64) -> Result<Self> {
        if !(l0 < l1 && l0 >= 0.0 && l1 <= 1.0) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::L1, value: l1, min: l0, max: 1.0 }.into());
        }
        let range = [self.whole_parameter(l0), self.whole_parameter(l1)];
        if range[0] < range[1] {
            Ok(Self { range, ..*self })
        } else {
            Err(NumberError::ParameterOutOfRange { name: ErrorItem::L1, value: range[1], min: range[0], max: 1.0 }
                .into())
        }
    }

    /// The same points run backwards: `x(1 - l)`.
    #[must_use]
    pub fn reversed(&self) -> Self {
        // Mirroring across the plane perpendicular to the chord takes a start tangent at x1 to the start tangent at
        // x2 of the reversed arc; the great circle is run from its end.
        let mirror = |t: Vec3| t - self.u * (2.0 * self.u.dot(t));
        let [c, s] = self.law.full();
        let [a, b] = self.range;
        Self {
            x1: self.x2,
            x2: self.x1,
            u: -self.u,
            t1: mirror(self.t1 * c + self.b * s),
            b: mirror(self.t1 * s - self.b * c),
            range: [1.0 - b, 1.0 - a],
            ..*self
        }
    }

    /// The image under a similarity (or reflection), which maps blends to blends; other Möbius maps do not.
    ///
    /// # Errors
    /// `not-a-similarity`, `not-finite`, `coincident-points` if the image is too small for its coordinates.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        map.check_similarity()?;
        let point = |p: Point3, index: usize| {
            map.map_point(p)
                .filter(|p| p.is_finite())
                .ok_or(Error::Number(NumberError::NotFinite { what: ErrorItem::Point, index }))
        };
        let (x1, x2) = (point(self.x1, 0)?, point(self.x2, 1)?);
        let chord = Chord::new(x1, x2);
        if !(chord.length > 0.0 && chord.length.is_finite()) {
            return Err(PointError::CoincidentPoints { first: 0, second: 1, distance: chord.length, limit: 0.0 }.into());
        }
        // The linear part times a positive number: directions.
        let direction = |v: Vec3| map.push_forward(self.x1, v).and_then(Vec3::unit).unwrap_or(Vec3::ZERO);
        // b is zero where theta is, and not quite unit where theta is rounding: keep its length.
        let b = direction(self.b) * self.b.length();
        Ok(Self { x1, x2, u: chord.unit, length: chord.length, t1: direction(self.t1), b, ..*self })
    }

    /// Smallest `|u + t|²` over the tangents of the whole segment: how near its circles come to infinity
    /// (`docs/math/circle-blends.md#rational-form`).
    pub(crate) fn distance_from_infinity_squared(&self) -> f64 {
        let [c, s] = self.law.full();
        let t2 = self.t1 * c + self.b * s;
        let ends = (self.u + self.t1).length_squared().min((self.u + t2).length_squared());
        let (x, y) = (self.u.dot(self.t1), self.u.dot(self.b));
        let opposed = (y.atan2(x) + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU);
        if opposed > 0.0 && opposed < self.law.theta {
            let height = self.u.dot(self.t1.cross(self.b));
            // No tangent is farther from both ends than half the angle between them, which tells more where that is
            // so small that its plane is rounding.
            let from_ends = (ends.sqrt() - 0.5 * self.law.theta).max(0.0);
            ends.min((2.0 * height * height / (1.0 + x.hypot(y))).max(from_ends * from_ends))
        } else {
            ends
        }
    }

    /// The whole segment of order 1 as a span between two points with these end speeds, in chords.
    pub(crate) fn span_data(&self, speeds: [f64; 2]) -> SpanData {
        let [c, s] = self.law.half;
        // h = c t1 + s b halfway, and b is across t1.
        let root = Quat::from_parts(c, self.t1.cross(self.b) * s);
        SpanData { ends: [self.x1, self.x2], unit: self.u, length: self.length, tangent: self.t1, root, speeds }
    }

    /// Refuses a segment that is not written for how near it comes to infinity.
    ///
    /// # Errors
    /// `arc-through-infinity`.
    pub(crate) fn check_finite(&self, segment: usize) -> Result<()> {
        // A circle over the chord that leaves it within `w` of the reversed direction has the diameter 1/w, in chords.
        let nearness = self.distance_from_infinity_squared().sqrt();
        if nearness < NEAR_INFINITY {
            return Err(ArcError::ThroughInfinity { segment, reach: 1.0 / nearness, limit: 1.0 / NEAR_INFINITY }.into());
        }
        Ok(())
    }

    /// A box around the segment, the smallest one if it is an arc: every point lies on an arc over the chord that leaves it at an angle `alpha` with
    /// `|u + t| = 2 cos(alpha/2)`, hence within its sagitta of the chord (or, above a half circle, of its middle).
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        if let Some(arc) = self.to_arc() {
            return arc.bounds();
        }
        let w2 = self.distance_from_infinity_squared();
        let sagitta = 0.5 * self.length * ((4.0 - w2).max(0.0) / w2).sqrt();
        let rounding = 8.0 * f64::EPSILON * (self.x1.to_vec().max_abs().max(self.x2.to_vec().max_abs()) + sagitta);
        let r = sagitta + rounding;
        if w2 >= 2.0 {
            let across = |c: f64| r * (1.0 - c * c).max(0.0).sqrt() + rounding;
            let e = Vec3::new(across(self.u.x), across(self.u.y), across(self.u.z));
            let chord = Aabb::of_point(self.x1).including(self.x2);
            Aabb { min: chord.min - e, max: chord.max + e }
        } else {
            let (m, e) = (self.x1.midpoint(self.x2), Vec3::new(r, r, r));
            Aabb { min: m - e, max: m + e }
        }
    }
}

/// Refuses orders outside 1 to 4.
pub(crate) fn check_order(order: u32) -> Result<()> {
    if (1..=MAX_ORDER).contains(&order) {
        Ok(())
    } else {
        Err(NumberError::OrderOutOfRange { order, max: MAX_ORDER }.into())
    }
}

/// Refuses points that are not finite or too far out; returns the length up to which neighbors coincide.
pub(crate) fn check_points(points: &[Point3]) -> Result<f64> {
    for (index, p) in points.iter().enumerate() {
        range::check_point(index, p.to_vec())?;
    }
    let diagonal = Aabb::of_points(points.iter().copied()).map_or(0.0, Aabb::diagonal);
    // Neighbors that differ are then no closer than distances may be.
    Ok((COINCIDENT_LIMIT * diagonal).max(range::MIN_DISTANCE))
}

/// A tangent given by the user, normalized.
pub(crate) fn unit_tangent(v: Vec3, index: usize) -> Result<Vec3> {
    if !v.is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::Tangent, index }.into());
    }
    v.unit().ok_or(Error::Point(PointError::ZeroTangent { index }))
}
