//! One span between two points with given derivatives at both.

use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Chord, QbCurve, SpanData};
use crate::error::{Error, ErrorItem, InterpolationError, NumberError, PointError, Result};

/// Tangents that add up to less than this oppose each other.
const OPPOSITE: f64 = 1e-12;

impl QbCurve {
    /// The curve of degree 2 from one point to another with these derivatives there, that Möbius maps take to the curve of the same kind
    /// between the mapped data; the arc, where one fits (`docs/math/qb-curves.md#invariant-span`).
    ///
    /// It lies on the sphere through both points along both derivatives, between the arc that leaves the first point and the arc
    /// that arrives at the second. If both derivatives point forward, `v·(a1 - a0) > 0`, it stays in the ball over the chord, and its
    /// real weights are positive.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, curve::QbCurve};
    /// let ends = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from);
    /// let span = QbCurve::invariant_span(ends, [Vec3::new(1.0, 2.0, 0.0), Vec3::new(1.0, 0.0, 1.0)])?;
    /// assert!((span.jet(1.0).d1 - Vec3::new(1.0, 0.0, 1.0)).length() < 1e-15);
    /// assert!(span.to_bezier().has_positive_weights());
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `coincident-points`, `zero-tangent`, `opposite-arcs`, `parameter-out-of-range` (derivatives
    /// beyond 1e30 chords), `curve-through-infinity` (derivatives that point backward).
    pub fn invariant_span(ends: [Point3; 2], velocities: [Vec3; 2]) -> Result<Self> {
        for (index, p) in ends.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        if let Some(index) = velocities.iter().position(|v| !v.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Tangent, index }.into());
        }
        let chord = Chord::new(ends[0], ends[1]);
        if chord.length <= range::MIN_DISTANCE {
            let (distance, limit) = (chord.length, range::MIN_DISTANCE);
            return Err(PointError::CoincidentPoints { first: 0, second: 1, distance, limit }.into());
        }
        let unit = |index: usize| velocities[index].unit().ok_or(Error::Point(PointError::ZeroTangent { index }));
        let (t1, t2) = (unit(0)?, unit(1)?.reflect(chord.unit));
        let speeds = velocities.map(|v| v.length() / chord.length);
        let data = SpanData { ends, unit: chord.unit, length: chord.length, tangent: t1, root: root(t1, t2)?, speeds };
        data.check()?;
        let span = Self::from_span(&data);
        check_finite(&span, &chord, velocities)?;
        Ok(span)
    }
}

/// Cosines between chord and derivatives from which on both point forward.
const FORWARD: f64 = 1e-6;

/// Refuses a span that runs out to infinity. One with derivatives that point forward stays in the ball over its chord: that needs no proof of
/// its own, which takes most of the time.
///
/// # Errors
/// `curve-through-infinity`.
pub(super) fn check_finite(span: &QbCurve, chord: &Chord, velocities: [Vec3; 2]) -> Result<()> {
    if velocities.iter().all(|v| v.dot(chord.unit) > FORWARD * v.length()) { Ok(()) } else { span.check_finite() }
}

/// `(h·t1, -h × t1)` for the unit vector `h` halfway between two unit tangents.
fn root(t1: Vec3, t2: Vec3) -> Result<Quat> {
    let (mut sum, difference) = (t1 + t2, t2 - t1);
    let measured = sum.length();
    if measured < OPPOSITE {
        return Err(InterpolationError::OppositeArcs { measured, limit: OPPOSITE }.into());
    }
    if measured < difference.length() {
        // Rounding of the sum along the difference, which it stands across.
        sum = sum - difference * (sum.dot(difference) / difference.length_squared());
    }
    let half = sum.unit().unwrap_or(t1);
    Ok(Quat::from_parts(half.dot(t1), -half.cross(t1)))
}
