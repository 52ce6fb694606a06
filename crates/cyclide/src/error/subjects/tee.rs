//! Why a tee of pipes was refused.

use crate::error::ErrorItem;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why a tee of pipes was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::TeeError};
    /// let error: Error = TeeError::HoleFolds { branch: 2, angle: 0.5 }.into();
    /// assert_eq!(error.reason(), "tee-hole-folds");
    /// ```
    pub enum TeeError: Error {
        /// A branch of a tee extends beyond the width of its main pipe, or up to it.
        BranchTooWide {
            /// Which branch, from 0.
            branch: usize,
            /// How far it extends sideways from the axis of the main pipe.
            reach: f64,
            /// The radius of the main pipe.
            limit: f64,
            /// The clearance that is required.
            rest: f64,
            /// Its offset: the distance of its axis from that of the main pipe.
            offset: f64,
        }
        reason "tee-branch-too-wide";
        at *branch;
        entry "branches";
        says "branch {branch} extends {reach} sideways from the axis of the main pipe, whose radius is {limit}: {}",
            room_for_branch(*reach, *limit, *rest, *offset);

        /// The balls of the quartic blend of a tee are infinite at an inner corner.
        BlendTooLarge {
            /// Which branch, from 0.
            branch: usize,
            /// Radius of the ball at the flank.
            radius: f64,
            /// The radius from which that is so; not positive where no radius is possible.
            limit: f64,
        }
        reason "tee-blend-too-large";
        at *branch;
        entry "branches";
        when *limit > 0.0, says "the quartic blend of branch {branch} with radius {radius} at its flank is too \
            large: its inner-corner radius would be infinite; use a radius below {limit}, or one radius for the \
            whole blend";
        says "the quartic blend of branch {branch} with radius {radius} at its flank is impossible: its inner-corner \
            radius would be infinite at any flank radius, since the difference of the pipe radii exceeds the offset \
            by too little; use one radius for the whole blend";

        /// A branch with the same radius as the main pipe has a blend of varying radius.
        LawOnEqualPipes {
            /// Which branch, from 0.
            branch: usize,
            /// Two of its radii.
            radii: [f64; 2],
        }
        reason "tee-law-on-equal-pipes";
        at *branch;
        entry "branches";
        says "branch {branch} is as wide as the main pipe, so its blend must have one radius all round, not {} and \
            {}: give one radius, or make the branch thinner", ShortNumber(radii[0]), ShortNumber(radii[1]);

        /// A pipe of a tee ends within a blend.
        PipeTooShort {
            /// The branch or the main pipe.
            what: ErrorItem,
            /// The branch of the blend, from 0.
            branch: usize,
            /// Where it ends.
            end: f64,
            /// Where it must extend beyond.
            needed: f64,
        }
        reason "tee-pipe-too-short";
        at (*what == ErrorItem::Branch).then_some(*branch);
        entry what.list();
        when *what == ErrorItem::Branch, says "branch {branch} ends within its blend: it ends at {end} along its \
            axis and must extend beyond {needed}";
        says "the {what} ends within the blend of branch {branch}: it ends at {end} and must extend beyond {needed}";

        /// The blend of a tee self-intersects.
        BlendFolds {
            /// Which branch, from 0.
            branch: usize,
            /// Angle round the branch where that is.
            angle: f64,
            /// Its width there, relative to that on a straight path: not positive.
            left: f64,
            /// The wall without which it would not: the balls of the inner side are larger by that.
            wall: Option<f64>,
        }
        reason "tee-blend-folds";
        at *branch;
        entry "branches";
        when wall.is_some(), says "the blend of branch {branch} inside its wall of {wall}, where its balls are \
            larger by the wall, self-intersects at {} round the branch (width factor {left}, must be above 0); use a \
            thinner wall, or a smaller radius there", turn(*angle);
        says "the blend of branch {branch} self-intersects at {} round the branch (width factor {left}, must be \
            above 0); use a smaller radius there, or one that changes less",
            turn(*angle);

        /// The contact curve of a blend with the main pipe of a tee turns back.
        HoleFolds {
            /// Which branch, from 0.
            branch: usize,
            /// Angle round the branch where that is.
            angle: f64,
        }
        reason "tee-hole-folds";
        at *branch;
        entry "branches";
        says "the blend of branch {branch} meets the main pipe in a curve that turns back at {} round the branch: \
            let the radius change less there", turn(*angle);

        /// Two branches of a tee, or their blends, meet, or overlap along the main pipe.
        BranchesMeet {
            /// The first branch, from 0.
            first: usize,
            /// The second.
            second: usize,
            /// Distance between their blends; below 0 if they overlap along the main pipe.
            distance: f64,
            /// The distance that they need.
            needed: f64,
            /// If so, the angle round the main pipe between them; below 0 if they overlap there too.
            round: f64,
        }
        reason "tee-branches-meet";
        at *second;
        entry "branches";
        when *distance < 0.0 && *round < 0.0, says "branches {first} and {second} with their blends overlap by {} \
            along the main pipe and by {} radians round it: move one along the pipe (`at`) until the blends are \
            {needed} apart, or turn one (`azimuth`) until both fit side by side",
            ShortNumber(-*distance),
            ShortNumber(-*round);
        when *distance < 0.0, says "branches {first} and {second} with their blends overlap by {} along the main \
            pipe and are only {} radians apart round it: move one along the pipe (`at`) until the blends are \
            {needed} apart, or turn one (`azimuth`) until both fit side by side",
            ShortNumber(-*distance),
            ShortNumber(round.abs());
        says "branches {first} and {second} or their blends meet: their distance is {distance}, must be above \
            {needed}; move or turn one of them";

        /// Two branches of a tee, or their blends, intersect or come too close, away from the main pipe.
        BranchesTooNear {
            /// The first branch, from 0.
            first: usize,
            /// The second.
            second: usize,
            /// Where that is, in the axes of the tee.
            point: [f64; 3],
            /// The distance that they need.
            needed: f64,
        }
        reason "tee-branches-meet";
        at *second;
        entry "branches";
        says "branches {first} and {second} or their blends meet at {point}, or come closer than {needed} there: \
            shorten, turn or move one of them";

        /// Two branches with the same radius as the main pipe of a tee are at the same position along it, but not opposite.
        EqualBranchesNotOpposite {
            /// The first branch, from 0.
            first: usize,
            /// The second.
            second: usize,
            /// By how much they are off opposite directions, radians.
            angle: f64,
            /// The distance of their positions along the main pipe.
            along: f64,
            /// The distance at which both fit one behind the other.
            needed: f64,
        }
        reason "tee-equal-branches-not-opposite";
        at *second;
        entry "branches";
        when *along > 0.0, says "branches {first} and {second} are as wide as the main pipe and must be exactly \
            opposite each other, but are off by {} degrees and by {along} along the pipe; turn one (`azimuth`, 180 \
            degrees from the other), or move them {needed} apart along the pipe (`at`)",
            ShortNumber(angle.to_degrees());
        says "branches {first} and {second} are as wide as the main pipe and must be exactly opposite each other, \
            but are off by {} degrees; turn one (`azimuth`, 180 degrees from the other), or move them {needed} apart \
            along the pipe (`at`)", ShortNumber(angle.to_degrees());

        /// Two branches of a tee leave no free line along the main pipe to divide it.
        NoFreeLine {
            /// The first branch, from 0.
            first: usize,
            /// The second.
            second: usize,
        }
        reason "tee-no-free-line";
        at *second;
        entry "branches";
        says "no lines along the main pipe divide it beside branches {first} and {second}: such a line must miss all \
            holes and be less than half a turn from the branches next to it; move one along the pipe (`at`) or turn \
            it (`azimuth`)";
    }
}

/// An angle round something, in degrees of one turn, rounded to 1e-4.
fn turn(angle: f64) -> String {
    let degrees = 1e-4 * (1e4 * angle.to_degrees()).round();
    format!("{} degrees", ShortNumber(degrees.rem_euclid(360.0)))
}

/// The limit for the radius of a branch, and other remedies.
fn room_for_branch(reach: f64, limit: f64, rest: f64, offset: f64) -> String {
    if reach < limit {
        // Thinner, but by too little.
        let remedy = match offset {
            0.0 => format!(
                "make its radius at most {}, or equal to that of the main pipe, both cylinders with intersecting axes",
                ShortNumber(limit - 2.0 * rest)
            ),
            _ => "make it thinner, or its offset smaller".to_owned(),
        };
        return format!(
            "the clearance between them is below {}, too small for a blend in double precision; {remedy}",
            ShortNumber(rest)
        );
    }
    let room = limit - (reach - offset.abs());
    let remedy = if offset == 0.0 || room <= 0.0 {
        "make the wider pipe the main one".to_owned()
    } else {
        format!(
            "its offset less than {}; a pipe that passes the other, with an offset above the difference of the radii, is a `pipe-crossing`, at any angle",
            ShortNumber(room)
        )
    };
    format!(
        "a branch needs an offset below the difference of the radii, or an equal radius, both cylinders with intersecting axes; \
         make it thinner, or {remedy}"
    )
}
