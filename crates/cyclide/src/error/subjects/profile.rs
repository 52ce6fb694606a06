//! Why a profile was not revolved about an axis, or a section not swept.

use crate::table::table;

table! {
    /// Why a profile was not revolved about an axis, or a section not swept.
    ///
    /// ```
    /// use cyclide::{Error, error::ProfileError};
    /// let error: Error = ProfileError::SectionMeetsItself { contour: 2 }.into();
    /// assert_eq!(error.reason(), "section-meets-itself");
    /// ```
    pub enum ProfileError: Error {
        /// A profile meets the axis of revolution other than with its ends.
        CrossesAxis {
            /// Which piece, from 0.
            piece: usize,
            /// Its distance from the axis where that was found.
            distance: f64,
            /// Distances up to this are refused; a larger one is on the other side of the axis.
            limit: f64,
        }
        reason "crosses-axis";
        at *piece;
        says "piece {piece} of the profile meets the axis, or lies on the other side of it from the pieces before \
            (distance {distance}): cut it there, and turn one half, or each part separately";

        /// The whole profile lies on the axis of revolution and sweeps nothing.
        OnAxis {
            /// The largest distance from the axis.
            distance: f64,
            /// Distances up to this are on the axis.
            limit: f64,
        }
        reason "profile-on-axis";
        says "the profile lies on the axis and sweeps nothing: its largest distance from the axis is {distance}, \
            must be above {limit}";

        /// The meridian of a profile self-intersects, and so does the swept surface.
        MeetsItself {
            /// Which piece, from 0.
            first: usize,
            /// The other one; the same if it intersects itself.
            second: usize,
            /// Distance from the axis near the intersection.
            radius: f64,
            /// Height along the axis, from its given point.
            height: f64,
        }
        reason "profile-meets-itself";
        at *second;
        says "the profile intersects itself: pieces {first} and {second} at distance {radius} from the axis, height \
            {height}; a solid needs a profile that encloses its area once";

        /// A profile in a plane perpendicular to the axis sweeps a part of the plane twice.
        Folded {
            /// Which piece, from 0.
            piece: usize,
            /// Where it turns back.
            distance: f64,
        }
        reason "folded-profile";
        at *piece;
        says "piece {piece} of the profile turns back at distance {distance} from the axis, in a plane perpendicular \
            to it, so the surface folds; use an axis in the plane of the profile, or a profile with heights along \
            the axis";

        /// A section is not in the section plane.
        SectionNotPlane {
            /// Which contour, from 0.
            contour: usize,
            /// Largest distance of a control point from the plane.
            distance: f64,
            /// Distances up to this are rounding.
            limit: f64,
        }
        reason "section-not-plane";
        says "contour {contour} of the section is up to {distance} off the section plane, limit {limit}";

        /// The contours of a section intersect themselves or each other, or enclose no area.
        SectionMeetsItself {
            /// Which contour, from 0.
            contour: usize,
        }
        reason "section-meets-itself";
        says "contour {contour} of the section intersects itself or another contour, or encloses no area: a solid \
            needs contours that enclose an area once";
    }
}
