//! Why an arc, a circle, a sphere or a blend of circles was refused.

use crate::table::table;

table! {
    /// Why an arc, a circle, a sphere or a blend of circles was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::ArcError};
    /// let error: Error = ArcError::ZeroWeight { index: 1 }.into();
    /// assert_eq!(error.reason(), "zero-weight");
    /// ```
    pub enum ArcError: Error {
        /// A weight quaternion is zero.
        ZeroWeight {
            /// Which weight, from 0.
            index: usize,
        }
        reason "zero-weight";
        at *index;
        entry "weights";
        says "weight {index} is zero";

        /// The weight ratio is a negative real number: the arc would be the outer part of the chord's line.
        PoleOnSegment {
            /// Real part of the weight ratio.
            real: f64,
            /// Length of its vector part.
            vector: f64,
            /// Lengths up to this are refused.
            limit: f64,
        }
        reason "pole-on-segment";
        field "weights";
        says "the arc passes through infinity: its weight ratio has real part {real} and vector part {vector}, which \
            must be longer than {limit}";

        /// The arc is so close to a full circle that its points would lose precision.
        NearlyFullCircle {
            /// How far it is short of a full turn, radians.
            rest: f64,
            /// The least such angle accepted, radians.
            limit: f64,
        }
        reason "nearly-full-circle";
        says "the arc is {rest} radians short of a full circle, minimum {limit}, so its ends nearly coincide; use a \
            circle or two arcs";

        /// The weight's vector part is not perpendicular to the chord, so the arc would leave three-space.
        NotInImH {
            /// Cosine of the angle between the chord and the weight's vector part.
            cosine: f64,
            /// Largest cosine accepted.
            limit: f64,
        }
        reason "not-in-im-h";
        field "weights";
        says "the weight is not perpendicular to the chord (cosine {cosine}, limit {limit}): the arc would leave \
            three-space";

        /// The tangent points directly away from the other end, or so nearly that the arc would extend far beyond its chord.
        TangentOpposesChord {
            /// Which tangent (or piece of a curve), from 0.
            index: usize,
            /// Its angle with the direction back along the chord, radians.
            angle: f64,
            /// Smallest angle accepted.
            limit: f64,
        }
        reason "tangent-opposes-chord";
        at *index;
        entry "tangents";
        when *limit <= ROUNDING_OF_ANGLES, says "tangent {index} points directly away from the other end: the arc \
            would pass through infinity";
        says "tangent {index} is {angle} radians from pointing directly away from the other end, minimum {limit}: \
            the arc would reach almost to infinity";

        /// Three points on a line have no finite circle.
        DegenerateCircle {
            /// Sine of the angle at the middle point.
            sine: f64,
            /// Smallest sine accepted.
            limit: f64,
        }
        reason "degenerate-circle";
        says "the points lie on a line, so they have no circle: sine of their angle {sine}, limit {limit}";

        /// Four points in a plane have no finite sphere.
        DegenerateSphere {
            /// Volume relative to the product of the three edges.
            volume: f64,
            /// Smallest relative volume accepted.
            limit: f64,
        }
        reason "degenerate-sphere";
        says "the points lie in a plane, so they have no sphere: relative volume {volume}, limit {limit}";

        /// No biarc of finite arcs meets the end conditions.
        NoFiniteBiarc {
            /// What was measured.
            measured: &'static str,
            /// Its value.
            value: f64,
            /// The limit it broke.
            limit: f64,
        }
        reason "no-finite-biarc";
        says "no biarc with finite arcs exists: {measured} is {value}, limit {limit}";

        /// The points turn back on themselves: there is no tangent to estimate.
        Cusp {
            /// The point, from 0.
            index: usize,
            /// Length of the sum of the two unit chords.
            measured: f64,
            /// Sums up to this are a cusp.
            limit: f64,
        }
        reason "tangent-undefined";
        at *index;
        says "the points turn back at point {index} (cusp): the sum of the unit chords has length {measured}, limit \
            {limit}; split the points there";

        /// A circle of a blend passes through infinity, or so near it that its points lose precision.
        ThroughInfinity {
            /// Which segment, from 0.
            segment: usize,
            /// How far the largest circle of the blend extends, in lengths of the chord; infinite where it is a line.
            reach: f64,
            /// Largest extent accepted.
            limit: f64,
        }
        reason "arc-through-infinity";
        at *segment;
        when !reach.is_finite(), says "segment {segment}: a start tangent is opposite to the chord, so the blend \
            would pass through infinity; turn the tangent, or add a point";
        says "segment {segment}: the curve extends to {reach} times the distance between its points, maximum {limit}, \
            and loses precision; make the turn less sharp, or add a point";

        /// Opposite circles whose common tangent is the chord: no half-turn is preferred.
        AmbiguousHalfTurn {
            /// Which segment, from 0.
            segment: usize,
            /// Sine of the angle between the tangent and the chord.
            sine: f64,
            /// Smallest sine accepted.
            limit: f64,
        }
        reason "ambiguous-half-turn";
        at *segment;
        says "segment {segment}: its circles have opposite tangents along the chord (sine of their angle with it \
            {sine}, minimum {limit}), so the half-turn between them is ambiguous; move a point, or add one";
    }
}

/// Limits up to here are the rounding of an angle, about which nothing else can be said.
const ROUNDING_OF_ANGLES: f64 = 64.0 * f64::EPSILON;
