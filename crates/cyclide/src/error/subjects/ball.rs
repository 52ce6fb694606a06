//! Why no ball rolls between two surfaces.

use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why no ball rolls between two surfaces.
    ///
    /// ```
    /// use cyclide::{Error, error::BallError};
    /// let error: Error = BallError::NoPositiveRadius { radius: -2.0 }.into();
    /// assert_eq!(error.reason(), "no-positive-radius");
    /// ```
    pub enum BallError: Error {
        /// The common tangent balls of two cylinders or cones do not form a torus: the pair is spacelike or lightlike.
        NotTimelikePair {
            /// Of two skew cylinders the distance of the axes, of a general pair the norm ratio of its common form.
            measured: f64,
            /// The distance must be above this, the ratio below it.
            limit: f64,
        }
        reason "not-timelike-pair";
        field "distance";
        says "the balls tangent to both surfaces do not form a torus: the distance of skew axes, or the norm ratio of \
            the pair, is {measured}, limit {limit}";

        /// Two surfaces whose axes meet or are parallel in the space of balls: their tangent balls form no single surface.
        DegeneratePair {
            /// Norm ratio of the common form, or the smallest pivot of the forms where there are several.
            measured: f64,
            /// Values of this size or below are refused.
            limit: f64,
        }
        reason "degenerate-pair";
        says "the axes of the two surfaces are equal or parallel, or share a tangent ball: measured {measured}, \
            limit {limit}";

        /// A location at the end of the family of balls between two cylinders, where they are infinite.
        SphereAtInfinity {
            /// The product of sines that vanishes there.
            measured: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "sphere-at-infinity";
        says "the ball at this location is infinite: the product of sines is {measured}, must be above {limit}";

        /// A ball that touches a surface from the wrong side, or its other nappe.
        WrongSide {
            /// Which surface, from 0; 0 where it is both.
            surface: usize,
            /// What must be positive: the product of sines at a location, or the distance from the axis.
            measured: f64,
        }
        reason "wrong-side";
        at *surface;
        says "the ball touches surface {surface} from the wrong side: measured {measured}, must be above 0";

        /// A ball outside both surfaces would have a radius that is not positive.
        NoPositiveRadius {
            /// The radius found.
            radius: f64,
        }
        reason "no-positive-radius";
        says "the ball outside both surfaces would have radius {radius}, must be above 0";

        /// The tangent planes at a contact are parallel, so no single ball touches both.
        ParallelContact {
            /// What vanishes there: 1 minus the cosine between the normals, or the distance by which the radius is divided.
            measured: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "parallel-contact";
        says "the tangent planes are nearly parallel, so no single ball touches both: measured {measured}, limit \
            {limit}";

        /// A ball too small to touch both cylinders.
        RadiusTooSmall {
            /// The radius given.
            radius: f64,
            /// It must be above this.
            limit: f64,
            /// A radius with which the body is made, where that was looked for and one was found.
            works: Option<f64>,
        }
        reason "radius-too-small";
        field "blend";
        when works.is_some(), says "a ball of radius {radius} cannot touch both cylinders: the radius must be above \
            {limit}, and larger still for a blend without self-intersections; {} works",
            ShortNumber::no_less(works.unwrap_or_default());
        says "a ball of radius {radius} cannot touch both cylinders: the radius must be above {limit}";
    }
}
