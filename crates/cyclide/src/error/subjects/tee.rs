//! Why a tee of pipes was refused.

use crate::error::ErrorItem;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why a tee of pipes was refused.
    ///
    /// ```
    /// use cyclide::{Error, TeeError};
    /// let error: Error = TeeError::HoleFolds { branch: 2, angle: 0.5 }.into();
    /// assert_eq!(error.reason(), "tee-hole-folds");
    /// ```
    pub enum TeeError: Error {
        /// A branch of a tee reaches beyond the breadth of its main pipe, or up to it.
        BranchTooWide {
            /// Which branch, from 0.
            branch: usize,
            /// How far it reaches from the axis of the main pipe, sideways.
            reach: f64,
            /// The radius of the main pipe.
            limit: f64,
            /// What has to be left of it.
            rest: f64,
            /// How far its axis passes beside that of the main pipe.
            offset: f64,
        }
        reason "tee-branch-too-wide";
        says "branch {branch} reaches {reach} sideways from the axis of the main pipe, whose radius is {limit}: {}",
            room_for_branch(*reach, *limit, *rest, *offset);

        /// The balls of the plainest blend of a tee are infinite in a crotch.
        BlendTooLarge {
            /// Which branch, from 0.
            branch: usize,
            /// Radius of the ball at the flank.
            radius: f64,
            /// The radius at which that begins; not positive where no ball will do.
            limit: f64,
        }
        reason "tee-blend-too-large";
        when *limit > 0.0, says "the blend of branch {branch}, of one quartic with the radius {radius} at its \
            flank, has an infinite one in a crotch: its radius must be below {limit}, or give one radius for all \
            of it";
        says "the blend of branch {branch}, of one quartic with the radius {radius} at its flank, has an infinite \
            one in a crotch, as has any where the radii of the pipes differ by so little more than their offset: \
            give one radius for all of it";

        /// A branch as wide as its main pipe has a blend whose radius changes.
        LawOnEqualPipes {
            /// Which branch, from 0.
            branch: usize,
            /// Two of its radii.
            radii: [f64; 2],
        }
        reason "tee-law-on-equal-pipes";
        says "branch {branch} is as wide as the main pipe, and its blend has one radius all round, not {} and {}: \
            give one, or make the branch thinner", ShortNumber(radii[0]), ShortNumber(radii[1]);

        /// A pipe of a tee ends within a blend.
        PipeTooShort {
            /// The branch or the main pipe.
            what: ErrorItem,
            /// Which branch it is about, from 0.
            branch: usize,
            /// Where it ends.
            end: f64,
            /// Where it may end first.
            needed: f64,
        }
        reason "tee-pipe-too-short";
        when *what == ErrorItem::Branch, says "branch {branch} ends within its blend: at {end} along its axis, \
            which must be above {needed}";
        says "the {what} ends within the blend of branch {branch}: at {end}, which must be beyond {needed}";

        /// The blend of a tee runs through itself.
        BlendFolds {
            /// Which branch, from 0.
            branch: usize,
            /// Angle round the branch where that is.
            angle: f64,
            /// Its width there as part of what it would be on a straight way: not positive.
            left: f64,
            /// Of a wall without which it would not: its balls on the inner side are larger by that.
            wall: Option<f64>,
        }
        reason "tee-blend-folds";
        when wall.is_some(), says "the blend of branch {branch} inside its wall of {wall}, where its balls are \
            larger by that, runs through itself at {} round the branch: its width there is {left} of that on a \
            straight way, which must be positive; take a thinner wall, or a smaller radius there", turn(*angle);
        says "the blend of branch {branch} runs through itself at {} round the branch: its width there is {left} of \
            that on a straight way, which must be positive; take a smaller radius there, or one that changes less",
            turn(*angle);

        /// The contact of a blend with the main pipe of a tee turns back and forth.
        HoleFolds {
            /// Which branch, from 0.
            branch: usize,
            /// Angle round the branch where that is.
            angle: f64,
        }
        reason "tee-hole-folds";
        says "the blend of branch {branch} meets the main pipe in a line that turns back at {} round the branch: \
            let the radius change less there", turn(*angle);

        /// Two branches of a tee, or their blends, meet, or stand beside each other along the main pipe.
        BranchesMeet {
            /// The first branch, from 0.
            first: usize,
            /// The second.
            second: usize,
            /// From the blend of one to that of the other; below 0 if both are beside the same part of the main pipe.
            distance: f64,
            /// The distance that they need.
            needed: f64,
            /// If they are, the angle round the main pipe from one to the other, below 0 if they overlap there too.
            round: f64,
        }
        reason "tee-branches-meet";
        when *distance < 0.0 && *round < 0.0, says "branches {first} and {second}, with their blends, overlap by {} \
            along the main pipe and by {} radians round it: one has to be behind the other, by {needed} at least \
            (`at` moves a branch), or both beside each other with room for their blends (`azimuth` turns one)",
            ShortNumber(-*distance),
            ShortNumber(-*round);
        when *distance < 0.0, says "branches {first} and {second}, with their blends, overlap by {} along the main \
            pipe and are only {} radians apart round it: one has to be behind the other, by {needed} at least \
            (`at` moves a branch), or both beside each other with room for their blends (`azimuth` turns one)",
            ShortNumber(-*distance),
            ShortNumber(round.abs());
        says "branches {first} and {second} meet, or their blends do: their distance is {distance}, which must be \
            above {needed}";

        /// Two branches of a tee, or their blends, run into each other or come too near, farther out than where they begin.
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
        says "branches {first} and {second}, or their blends, run into each other at {point}, or come nearer than \
            {needed} there: take shorter ones, or turn or move one";

        /// Two branches as wide as the main pipe of a tee stand beside each other, but not opposite.
        EqualBranchesNotOpposite {
            /// The first branch, from 0.
            first: usize,
            /// The second.
            second: usize,
            /// By how much they are off opposite directions, radians.
            angle: f64,
            /// How far their places are apart along the main pipe.
            along: f64,
            /// How far they have to be to stand one behind the other.
            needed: f64,
        }
        reason "tee-equal-branches-not-opposite";
        when *along > 0.0, says "branches {first} and {second} are as wide as the main pipe: two such stand exactly \
            opposite each other at one place along it, and these are off that by {} degrees and by {along} along \
            it; turn one (`azimuth`, 180 degrees from the other), or move them {needed} apart along the pipe (`at`)",
            ShortNumber(angle.to_degrees());
        says "branches {first} and {second} are as wide as the main pipe: two such stand exactly opposite each \
            other at one place along it, and these are off that by {} degrees; turn one (`azimuth`, 180 degrees \
            from the other), or move them {needed} apart along the pipe (`at`)", ShortNumber(angle.to_degrees());

        /// Two branches of a tee stand so that no lines along the main pipe part what is beside them.
        NoFreeLine {
            /// The first branch, from 0.
            first: usize,
            /// The second.
            second: usize,
        }
        reason "tee-no-free-line";
        says "no lines along the main pipe part it beside branches {first} and {second}: each has to be free of \
            holes, and less than half a turn from the branches next to it; move one along the pipe (`at`) or turn \
            it (`azimuth`)";
    }
}

/// A place round something, as degrees of one turn: noise below a millionth of one is none.
fn turn(angle: f64) -> String {
    let degrees = 1e-4 * (1e4 * angle.to_degrees()).round();
    format!("{} degrees", ShortNumber(degrees.rem_euclid(360.0)))
}

/// How narrow a branch has to be to stand on its main pipe, and what else will do.
fn room_for_branch(reach: f64, limit: f64, rest: f64, offset: f64) -> String {
    if reach < limit {
        // Thinner, but by too little.
        let remedy = match offset {
            0.0 => format!(
                "make it {} at most, or of one radius with the main pipe, both cylinders whose axes meet",
                ShortNumber(limit - 2.0 * rest)
            ),
            _ => "make it thinner, or its offset smaller".to_owned(),
        };
        return format!(
            "less than {} is left between them, in which a blend has no digits; {remedy}",
            ShortNumber(rest)
        );
    }
    let room = limit - (reach - offset.abs());
    let remedy = if offset == 0.0 || room <= 0.0 {
        "let the wider pipe be the main one".to_owned()
    } else {
        format!(
            "its offset less than {}; a pipe that goes on past the other, its axis farther off than the radii differ, is a `pipe-crossing`, at any angle",
            ShortNumber(room)
        )
    };
    format!(
        "a branch stands within its breadth, thinner and offset by less than the radii differ, or is of one radius with it, a cylinder whose axis meets the other; \
         make it thinner, or {remedy}"
    )
}
