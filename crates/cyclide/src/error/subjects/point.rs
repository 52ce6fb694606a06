//! Why points, directions, or a map of them were refused.

use crate::error::ErrorItem;
use crate::table::table;

table! {
    /// Why points, directions, or a map of them were refused.
    ///
    /// ```
    /// use cyclide::{Error, error::PointError};
    /// let error: Error = PointError::ZeroTangent { index: 1 }.into();
    /// assert_eq!(error.reason(), "zero-tangent");
    /// ```
    pub enum PointError: Error {
        /// Fewer points than the construction needs.
        TooFewPoints {
            /// Number of points given.
            given: usize,
            /// Number of points needed.
            needed: usize,
        }
        reason "too-few-points";
        says "too few points: {given} given, at least {needed} needed";

        /// Two points that must differ are coincident.
        CoincidentPoints {
            /// Index of the first point.
            first: usize,
            /// Index of the second point.
            second: usize,
            /// Their distance.
            distance: f64,
            /// Points up to this far apart are coincident (0: only equal doubles).
            limit: f64,
        }
        reason "coincident-points";
        at *second;
        when *limit <= 0.0, says "points {first} and {second} coincide";
        says "points {first} and {second} are coincident (distance {distance}, tolerance {limit})";

        /// Something is so small and so far from the origin that the rounding of its coordinates destroys its shape.
        BelowRoundingOfPlace {
            /// What it is.
            what: ErrorItem,
            /// Its size: the diagonal of the box of its points, or a radius.
            size: f64,
            /// Its largest coordinate.
            place: f64,
            /// Smallest size accepted there.
            limit: f64,
        }
        reason "below-rounding-of-place";
        field what.list();
        when *what == ErrorItem::Cells, says "cells are as short as {size} at coordinates of up to {place}, minimum \
            {limit}: rounding makes their ends coincident; use fewer cells, or lengths that differ less";
        when *size > 0.0, says "the {what} has size {size} at coordinates of up to {place}, minimum {limit}: \
            rounding destroys its shape; make it larger, or move it to the origin";
        says "the {what} is a single point at coordinates of up to {place}, minimum size {limit}: rounding destroys \
            its shape; make it larger, or move it to the origin";

        /// A tangent or direction vector is zero.
        ZeroTangent {
            /// Which tangent, from 0.
            index: usize,
        }
        reason "zero-tangent";
        at *index;
        entry "tangents";
        says "tangent {index} is zero";

        /// A rotation axis, plane normal or direction is zero (or has no part in the given plane).
        ZeroAxis {
            /// What it is.
            what: ErrorItem,
            /// Which one, from 0.
            index: usize,
            /// Length of its usable part.
            length: f64,
            /// Lengths up to this are refused.
            limit: f64,
        }
        reason "zero-axis";
        at *index;
        field what.word();
        when *limit <= 0.0, says "the {what} is zero";
        says "the {what} runs along the chord: its perpendicular part is {length}, limit {limit}";

        /// Three points on a line that a map is to take elsewhere have no plane, and no normal of it was given.
        CollinearNeedsUp {
            /// Which points.
            what: ErrorItem,
            /// Sine of the angle at the first point.
            measured: f64,
            /// Values up to this are refused.
            limit: f64,
        }
        reason "collinear-needs-up";
        field what.word();
        says "the three points `{what}` are on a line (sine {measured}, limit {limit}), so that they have no plane: give a \
            normal for them";

        /// Two spheres or planes that are to be intersected are one.
        SameSurface {
            /// How far they are apart.
            distance: f64,
            /// Distances up to this are none.
            limit: f64,
        }
        reason "same-surface";
        says "both surfaces are the same (they are {distance} apart, limit {limit}): they share all their points";

        /// A circle or line that is to be intersected with a surface lies on it.
        Contained {
            /// How far they are apart.
            distance: f64,
            /// Distances up to this are none.
            limit: f64,
        }
        reason "contained";
        says "the curve lies on the surface (they are {distance} apart, limit {limit}): they share all its points";

        /// A point is as near to all points of a sphere or circle: no point of it is the nearest.
        NearestUndefined {
            /// Its distance from the center, or from the axis.
            distance: f64,
            /// Distances up to this are none.
            limit: f64,
        }
        reason "nearest-undefined";
        says "no point is the nearest: the given one is the center or on the axis (distance {distance}, limit {limit}), as \
            far from all of them";

        /// Something is mapped to infinity, or so near it that precision is lost: a third point on the line of the other two, outside
        /// the segment; a point that a map takes there.
        AtInfinity {
            /// What is mapped there.
            what: ErrorItem,
            /// Which one, from 0.
            index: usize,
            /// Its distance from the point that is mapped to infinity.
            distance: f64,
            /// Smallest distance accepted (0: only that point itself is refused).
            limit: f64,
        }
        reason "point-at-infinity";
        at *index;
        when *limit <= 0.0, says "a point is at infinity: it lies on the line through the ends outside the segment, \
            or is mapped there";
        says "the {what} comes within {distance} of the point that is mapped to infinity, minimum {limit}, and its \
            image loses precision; move that point (of an inversion its center) away from the {what}";

        /// A matrix of quaternions does not map three-space to itself.
        NotMobius {
            /// Relative defect measured.
            defect: f64,
            /// Largest defect accepted.
            limit: f64,
        }
        reason "not-mobius";
        says "the Möbius matrix does not preserve three-space: defect {defect}, limit {limit}";

        /// A Möbius map is not a similarity, but only similarities preserve this kind of curve.
        NotASimilarity {
            /// Length of the entry `c` of its matrix.
            measured: f64,
            /// Largest one accepted.
            limit: f64,
        }
        reason "not-a-similarity";
        says "the map is not a similarity, which this kind of curve requires: the entry c of its matrix has length \
            {measured}, limit {limit}";
    }
}
