//! Why a tube was not blended with a plane or a sphere.

use crate::table::table;

table! {
    /// Why a tube was not blended with a plane or a sphere.
    ///
    /// ```
    /// use cyclide::{Error, error::ContactError};
    /// let error: Error = ContactError::LoopTurnsBack { angle: 0.5 }.into();
    /// assert_eq!(error.reason(), "contact-loop-turns-back");
    /// ```
    pub enum ContactError: Error {
        /// At some angle round a tube no ball of the radius touches it and the plane or sphere that it is blended with; of a ring,
        /// all round.
        LoopOpen {
            /// Whether it is a ring.
            ring: bool,
            /// The angle round the tube.
            angle: f64,
            /// What must be positive there: the rise of the tube's line over the plane, the square of half the distance between
            /// the two such balls on it, or, inside, the distance of the ball's center from the axis on the side of the contact.
            measured: f64,
        }
        reason "contact-loop-open";
        when *ring, says "no ball of this radius touches both the ring and the surface it is blended with: measured \
            {measured}, must be above 0; the ring is too far from the surface or inside it: change its height, its \
            radius or the ball";
        says "no ball of this radius touches both surfaces at {angle} radians round the tube: measured {measured}, \
            must be above 0; the tube must meet the plane or the sphere all round, with room for the ball: move its \
            axis closer to the center of the sphere, turn it closer to the normal of the plane, or use a thinner \
            tube";

        /// The contact of the blend of a cone with a sphere turns back, so that the rest of the sphere would overlap.
        LoopTurnsBack {
            /// The angle round the tube where that is.
            angle: f64,
        }
        reason "contact-loop-turns-back";
        says "the border of the blend on the sphere turns back at {angle} radians round the cone; use a cone that \
            widens less towards its end, or whose axis passes closer to the center of the sphere";

        /// The blend of a tube with a plane or a sphere self-intersects.
        BlendFolds {
            /// The angle round the tube where that is.
            angle: f64,
            /// Its width there, relative to that on a straight path.
            left: f64,
        }
        reason "contact-blend-folds";
        field "blend";
        says "the blend self-intersects at {angle} radians round the tube (width factor {left}, must be above 0); \
            use a smaller ball or a thinner wall";

        /// A tube ends within its blend.
        TubeTooShort {
            /// Its end, as the distance along its axis.
            end: f64,
            /// The distance that it must be beyond.
            needed: f64,
        }
        reason "contact-tube-too-short";
        says "the tube ends within the blend: it ends at {end} along its axis and must extend beyond {needed}";
    }
}
