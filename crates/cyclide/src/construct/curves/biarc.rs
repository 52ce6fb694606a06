//! The biarc: two circular arcs that join two points with given directions, tangent-continuous, in space.
//!
//! ```text
//! W = p1 - p0,  v = W/|W|,  s1 = 2<t1,v>v - t1  (the start tangent whose single arc would end in t1),  K = t0 + s1
//! ```
//! The joint `J` may lie anywhere on the circle through `p0` and `p1` with start tangent `K`; the arcs are then
//! `(p0, J, t0)` and `(J, p1, reflect(t0, J - p0))`, and the second ends in `t1` exactly
//! (`docs/math/arc-splines.md#biarc-the-joint-circle`). The rules differ in the choice of `J`. The result is G1;
//! curvature jumps at the joint.
//!
//! Degenerate cases: `p0 = p1` has no biarc (`coincident-points`), nor has `t0 = t1 = -v` (a caller needs three arcs).
//! Straight data (`t0 = t1 = v`) give two collinear segments.
//!
//! The outer tangents are exact; the kink at the joint is rounding, of unit tangents times `d/|W|` (leg over chord) and
//! of coordinates over the shorter chord for equal legs, times `1/|K|` for equal chords: at most about 1e-6 just inside
//! the limits below, 1e-15 in general.

use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ArcPath};
use crate::error::{ArcError, Error, ErrorItem, NumberError, PointError, Result};

/// The longest leg of the control triangles accepted, in chords: beyond it the joint runs away to infinity.
const LEG_LIMIT: f64 = 1e8;

/// The shortest distance from the joint to an end accepted, in chords: below it one arc is a half turn of radius 0.
const JOINT_LIMIT: f64 = 1e-8;

/// Below this length of `K` the circle of joints is not determined by the data.
const JOINT_CIRCLE_LIMIT: f64 = 1e-8;

/// [`BiarcRule::Auto`] turns from equal legs to equal chords where a leg is shorter than this part of the chord.
const AUTO_SHORT_LEG: f64 = 0.01;

/// [`BiarcRule::Auto`] turns from equal legs to equal chords where the result is longer by this factor.
const AUTO_LENGTH_FACTOR: f64 = 2.0;

/// Lengths that differ by less than this relative amount tie.
const LENGTH_TIE: f64 = 1e-12;

/// How the joint of a biarc is chosen.
///
/// Equal legs are the choice of Bolton 1975 and of most practice: both arcs turn by less than a half turn, data on one circle (less
/// than half of it per arc) give that circle. Of the two candidates with equal chords the shorter one is taken. Equal chords are
/// clearly better where equal legs fail, are more than twice as long, or have a leg shorter than a hundredth of the chord.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::{Biarc, BiarcRule}};
/// let (a, b) = (Point3::ORIGIN, Point3::new(2.0, 0.0, 0.0));
/// let length = |rule| Biarc::new(a, Vec3::Y, b, -Vec3::Y, rule).map(|biarc| biarc.length());
/// assert!((length(BiarcRule::EqualD)? - std::f64::consts::PI).abs() < 1e-12); // two quarters of a circle
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Rule", description = "How the joint of a biarc is chosen.")
)]
pub enum BiarcRule {
    /// Equal legs of the two control triangles.
    #[default]
    EqualD,
    /// Equal chords.
    EqualChord,
    /// Equal legs, unless equal chords give a clearly better curve.
    Auto,
}

/// Two arcs from one point and direction to another, tangent-continuous at the joint.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::{Biarc, BiarcRule}};
/// let biarc = Biarc::new(Point3::ORIGIN, Vec3::X, Point3::new(2.0, 1.0, 0.0), Vec3::X, BiarcRule::EqualD)?;
/// assert!(biarc.joint().distance(Point3::new(1.0, 0.5, 0.0)) < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Biarc {
    arcs: [Arc; 2],
    joint_tangent: Vec3,
    rule: BiarcRule,
}

/// Checked data: chord length and unit directions.
struct Data {
    p0: Point3,
    p1: Point3,
    /// Chord length.
    l: f64,
    /// Unit chord.
    v: Vec3,
    t0: Vec3,
    t1: Vec3,
}

impl Biarc {
    /// The biarc from `p0` with direction `t0` to `p1` with direction `t1` (of any length).
    ///
    /// # Errors
    /// `not-finite`, `coincident-points` (equal doubles), `zero-tangent`; `no-finite-biarc` if the rule has none:
    /// a leg above 1e8 chords (`t0 = t1` pointing backwards) or a joint closer than 1e-8 chords to an end for equal
    /// legs, an arc through infinity in every candidate for equal chords, both for `Auto`.
    pub fn new(p0: Point3, t0: Vec3, p1: Point3, t1: Vec3, rule: BiarcRule) -> Result<Self> {
        let data = Data::new(p0, t0, p1, t1)?;
        match rule {
            BiarcRule::EqualD => data.equal_d(),
            BiarcRule::EqualChord => data.equal_chord(),
            BiarcRule::Auto => data.auto(),
        }
    }

    /// The point where the two arcs meet.
    #[must_use]
    pub fn joint(&self) -> Point3 {
        self.arcs[0].end()
    }

    /// Unit tangent at the joint.
    #[must_use]
    pub fn joint_tangent(&self) -> Vec3 {
        self.joint_tangent
    }

    /// The two arcs; the first starts exactly in the given direction, the second ends exactly in it.
    #[must_use]
    pub fn arcs(&self) -> &[Arc; 2] {
        &self.arcs
    }

    /// The rule that chose the joint: never `Auto`, but the one it decided for.
    #[must_use]
    pub fn rule(&self) -> BiarcRule {
        self.rule
    }

    /// Sum of the lengths of the two arcs.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.arcs[0].length() + self.arcs[1].length()
    }

    /// The biarc as an open path of two arcs.
    #[must_use]
    pub fn to_path(&self) -> ArcPath {
        ArcPath::from_joined(self.arcs.to_vec(), false)
    }
}

impl Data {
    fn new(p0: Point3, t0: Vec3, p1: Point3, t1: Vec3) -> Result<Self> {
        for (index, p) in [p0, p1].into_iter().enumerate() {
            if !p.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Point, index }.into());
            }
        }
        let unit = |t: Vec3, index| {
            if t.is_finite() {
                t.unit().ok_or(Error::Point(PointError::ZeroTangent { index }))
            } else {
                Err(NumberError::NotFinite { what: ErrorItem::Tangent, index }.into())
            }
        };
        let (t0, t1) = (unit(t0, 0)?, unit(t1, 1)?);
        let l = p0.distance(p1);
        if l == 0.0 {
            return Err(PointError::CoincidentPoints { first: 0, second: 1, distance: l, limit: 0.0 }.into());
        }
        let v = (p1 - p0).unit().ok_or(NumberError::NotFinite { what: ErrorItem::Chord, index: 0 })?;
        Ok(Self { p0, p1, l, v, t0, t1 })
    }

    /// The biarc with joint `j` and joint tangent `tj`: the arcs are tied to the outer tangents, so that the joints
    /// *between* biarcs of a spline are exact and the rounding of a short leg stays at the joint.
    fn biarc(&self, j: Point3, tj: Vec3, rule: BiarcRule) -> Result<Biarc> {
        let arcs = [starting(self.p0, self.t0, j)?, ending(j, self.p1, self.t1)?];
        Ok(Biarc { arcs, joint_tangent: tj, rule })
    }

    /// Equal legs `d`:
    ///
    /// ```text
    /// B = <v, t0+t1>,  A = |t0-t1|²,  S = sqrt(B² + A),  d = |W|/(B+S) if B >= 0, else |W| (S-B)/A
    /// J = (p0+p1)/2 + (d/2)(t0-t1),  tJ = (W/d - t0 - t1)/2
    /// ```
    fn equal_d(&self) -> Result<Biarc> {
        let (sum, difference) = (self.t0 + self.t1, self.t0 - self.t1);
        let (b, a) = (self.v.dot(sum), difference.length_squared());
        let s = b.hypot(a.sqrt());
        // In chords. 0/0 (equal tangents across the chord or backwards) is infinite too.
        let d = if b >= 0.0 { 1.0 / (b + s) } else { (s - b) / a };
        if !(d <= LEG_LIMIT) {
            return Err(ArcError::NoFiniteBiarc { measured: "leg over chord", value: d, limit: LEG_LIMIT }.into());
        }
        let j = self.p0.midpoint(self.p1) + difference * (0.5 * d * self.l);
        for end in [self.p0, self.p1] {
            let value = j.distance(end) / self.l;
            if !(value >= JOINT_LIMIT) {
                let measured = "distance of the joint from an end over chord";
                return Err(ArcError::NoFiniteBiarc { measured, value, limit: JOINT_LIMIT }.into());
            }
        }
        // A unit vector to rounding, even when a leg is tiny.
        let tj = (self.v / d - sum) * 0.5;
        self.biarc(j, tj.unit().unwrap_or(self.v), BiarcRule::EqualD)
    }

    /// Equal chords: `J` is the middle by length of the arc with start tangent `+K` or `-K`.
    fn equal_chord(&self) -> Result<Biarc> {
        let k = self.t0 + self.t1.reflect(self.v);
        let k = if k.length() >= JOINT_CIRCLE_LIMIT { k } else { self.planar_limit() };
        let candidates = [k, -k].map(|k| {
            let w = Arc::from_start_tangent(self.p0, self.p1, k * self.l)?;
            let j = w.midpoint();
            let u = (j - self.p0).unit().ok_or(Error::at_infinity(ErrorItem::Point, 0))?;
            self.biarc(j, self.t0.reflect(u), BiarcRule::EqualChord)
        });
        match candidates {
            [Ok(plus), Ok(minus)] => {
                let shorter = minus.length() < plus.length() * (1.0 - LENGTH_TIE);
                Ok(if shorter { minus } else { plus })
            }
            [Ok(one), Err(_)] | [Err(_), Ok(one)] => Ok(one),
            [Err(_), Err(_)] => {
                let measured = "number of candidates for the joint";
                Err(ArcError::NoFiniteBiarc { measured, value: 0.0, limit: 1.0 }.into())
            }
        }
    }

    /// The limit of `K` where `t1` is the mirror image of `t0` (`K = 0`): across `t0` in the plane of `v` and `t0`.
    /// Where `t0 = ±v` that plane is arbitrary too, and the one across the z axis (across x for a chord along z) is
    /// taken.
    fn planar_limit(&self) -> Vec3 {
        let across = self.v - self.t0 * self.v.dot(self.t0);
        if across.length() >= JOINT_CIRCLE_LIMIT {
            return across;
        }
        let by_z = self.v.cross(Vec3::Z);
        if by_z.length() >= JOINT_CIRCLE_LIMIT { by_z } else { self.v.cross(Vec3::X) }
    }

    fn auto(&self) -> Result<Biarc> {
        let equal_d = self.equal_d();
        let equal_chord = self.equal_chord();
        match (equal_d, equal_chord) {
            (Ok(legs), Ok(chords)) => {
                let [a, b] = legs.arcs().map(|arc| arc.chord().length());
                let short = a.min(b) < AUTO_SHORT_LEG * self.l;
                let long = legs.length() > AUTO_LENGTH_FACTOR * chords.length();
                Ok(if short || long { chords } else { legs })
            }
            (Ok(one), Err(_)) | (Err(_), Ok(one)) => Ok(one),
            (Err(error), Err(_)) => Err(error),
        }
    }
}

/// The arc from `a` with unit tangent `t` to `b`, weights of equal length.
pub(super) fn starting(a: Point3, t: Vec3, b: Point3) -> Result<Arc> {
    let l = a.distance(b);
    Ok(Arc::from_start_tangent(a, b, t * l)?.settled())
}

/// As [`starting`], with the unit tangent at the end.
fn ending(a: Point3, b: Point3, t: Vec3) -> Result<Arc> {
    let l = a.distance(b);
    Ok(Arc::from_end_tangent(a, b, t * l)?.settled())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    /// Largest angle between the tangents asked for and those of the arcs, and across the joint.
    fn kink(b: &Biarc, t0: Vec3, t1: Vec3) -> f64 {
        let [first, second] = b.arcs();
        let angle = |u: Option<Vec3>, v: Option<Vec3>| {
            let (u, v) = (u.unwrap(), v.unwrap());
            u.cross(v).length().atan2(u.dot(v))
        };
        angle(first.start_tangent(), t0.unit())
            .max(angle(first.end_tangent(), second.start_tangent()))
            .max(angle(first.end_tangent(), Some(b.joint_tangent())))
            .max(angle(second.end_tangent(), t1.unit()))
    }

    #[test]
    fn is_g1_and_interpolates_in_space() {
        let (t0, t1) = (Vec3::new(1.0, 2.0, -0.5), Vec3::new(-0.3, 1.0, 2.0));
        for rule in [BiarcRule::EqualD, BiarcRule::EqualChord, BiarcRule::Auto] {
            let b = Biarc::new(p(1.0, 0.5, 0.0), t0, p(3.0, -1.0, 2.0), t1, rule).unwrap();
            assert!(kink(&b, t0, t1) < 1e-14, "{rule:?}: {:e}", kink(&b, t0, t1));
            assert_eq!(b.to_path().arcs().len(), 2);
            assert_ne!(b.rule(), BiarcRule::Auto);
        }
    }

    #[test]
    fn equal_rules_keep_their_names() {
        let (a, b) = (p(0.0, 0.0, 0.0), p(2.0, 1.0, 0.5));
        let (t0, t1) = (Vec3::new(1.0, 1.0, 0.0), Vec3::new(1.0, -0.5, 1.0));
        let c = Biarc::new(a, t0, b, t1, BiarcRule::EqualChord).unwrap();
        assert!((c.joint().distance(a) - c.joint().distance(b)).abs() < 1e-15);
        // Legs of the control triangles: |chord|/(2 cos alpha) with alpha half the turn.
        let d = Biarc::new(a, t0, b, t1, BiarcRule::EqualD).unwrap();
        let [l0, l1] = d.arcs().map(|arc| 0.5 * arc.chord().length() / (0.5 * arc.angle()).cos());
        assert!((l0 - l1).abs() < 1e-15 * l0 * 8.0);
    }

    #[test]
    fn straight_data_give_segments_far_from_the_origin() {
        let (a, c) = (p(1.0e6, 2.0e6, 0.1), Vec3::new(0.3, 0.1, -0.7));
        for rule in [BiarcRule::EqualD, BiarcRule::EqualChord] {
            let b = Biarc::new(a, c, a + c, c, rule).unwrap();
            assert!(b.arcs().iter().all(Arc::is_straight));
        }
    }

    #[test]
    fn refuses_by_name() {
        let (o, e) = (p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0));
        let reason = |t0: Vec3, b: Point3, t1: Vec3, rule| Biarc::new(o, t0, b, t1, rule).unwrap_err().reason();
        use BiarcRule::{Auto, EqualChord, EqualD};
        assert_eq!(reason(Vec3::X, o, Vec3::X, EqualD), "coincident-points");
        assert_eq!(reason(Vec3::ZERO, e, Vec3::X, EqualD), "zero-tangent");
        assert_eq!(reason(Vec3::new(f64::NAN, 0.0, 0.0), e, Vec3::X, EqualD), "not-finite");
        for rule in [EqualD, EqualChord, Auto] {
            assert_eq!(reason(-Vec3::X, e, -Vec3::X, rule), "no-finite-biarc", "{rule:?}");
        }
        // K = 0 in the plane: the joint of equal legs is an end; equal chords and auto have an answer.
        let (t0, t1) = (Vec3::new(1.0, 2.0, 0.0), Vec3::new(-1.0, 2.0, 0.0));
        assert_eq!(reason(t0, e, t1, EqualD), "no-finite-biarc");
        for rule in [EqualChord, Auto] {
            let b = Biarc::new(o, t0, e, t1, rule).unwrap();
            assert_eq!(b.rule(), EqualChord);
            assert!(kink(&b, t0, t1) < 1e-14);
        }
        // K = 0 with every plane possible: a chosen one.
        for chord in [Vec3::X, Vec3::Z] {
            let b = Biarc::new(o, chord, o + chord, -chord, EqualChord).unwrap();
            assert!(kink(&b, chord, -chord) < 1e-14, "{:e} {b:?}", kink(&b, chord, -chord));
        }
    }

    #[test]
    fn auto_leaves_equal_legs_where_they_are_bad() {
        let (o, e) = (p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0));
        // Close to the K = 0 of the plane: a leg below a hundredth of the chord.
        let (t0, t1) = (Vec3::new(1.0, 2.0, 0.0), Vec3::new(-1.0, 2.002, 0.0));
        let legs = Biarc::new(o, t0, e, t1, BiarcRule::EqualD).unwrap();
        assert!(legs.arcs().iter().any(|a| a.chord().length() < 0.01));
        assert_eq!(Biarc::new(o, t0, e, t1, BiarcRule::Auto).unwrap().rule(), BiarcRule::EqualChord);
        // Nearly equal tangents pointing backwards: equal legs run away.
        let (t0, t1) = (Vec3::new(-1.0, 1.0, 0.0), Vec3::new(-1.0, 1.01, 0.0));
        assert!(Biarc::new(o, t0, e, t1, BiarcRule::EqualD).unwrap().length() > 100.0);
        assert_eq!(Biarc::new(o, t0, e, t1, BiarcRule::Auto).unwrap().rule(), BiarcRule::EqualChord);
        // And stays with them elsewhere.
        let b = Biarc::new(o, Vec3::new(1.0, 1.0, 0.0), e, Vec3::new(1.0, -1.0, 0.0), BiarcRule::Auto).unwrap();
        assert_eq!(b.rule(), BiarcRule::EqualD);
    }
}
