//! Warnings about motions that smooth their poses.

use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Warnings about motions that smooth their poses.
    ///
    /// ```
    /// use cyclide::{Warning, warning::PoseFitWarning};
    /// let warning: Warning = PoseFitWarning::SmoothedAway { turning: true, path: 0.5, poses: 0.5 }.into();
    /// assert_eq!(warning.reason(), "shape-smoothed-away");
    /// ```
    pub enum PoseFitWarning {
        /// The tolerance of a smoothed motion is below the noise of its poses, so that single poses pull it back and forth.
        PosesNoisier {
            /// True for rotations, in radians; else for positions.
            turning: bool,
            /// Standard deviation of the noise in one direction.
            sigma: f64,
            /// The tolerance.
            tolerance: f64,
            /// Tolerances from this on are not reported.
            needed: f64,
        }
        reason "tolerance-below-noise";
        says "the {0} tolerance of {tolerance}{1} is too small for the noise of the poses, whose standard deviation \
            is about {sigma}{1} in one direction, and single poses pull the motion back and forth; let the noise decide \
            how much is smoothed, or give {2}{1} or more",
            of(*turning), unit(*turning), ShortNumber::no_less(*needed);

        /// A pose of a smoothed motion is an outlier: it is far from the path of the other poses.
        Outlier {
            /// The pose, from 0.
            pose: usize,
            /// True for its rotation, in radians; else for its position.
            turning: bool,
            /// Its distance from that path.
            distance: f64,
            /// Standard deviation of the noise of the other poses in one direction.
            noise: f64,
            /// True if it was left out, as requested; otherwise it is kept.
            dropped: bool,
            /// How many there are.
            count: usize,
        }
        reason "outlier";
        at *pose;
        when *dropped, says "pose {pose} is an outlier in {0} ({count} in all): it is {distance}{1} from the path of \
            the poses around it, whose noise has a standard deviation of {noise}{1}; left out",
            of(*turning),
            unit(*turning);
        says "pose {pose} is an outlier in {0} ({count} in all): it is {distance}{1} from the path of the poses \
            around it, whose noise has a standard deviation of {noise}{1}; kept: the motion hardly follows it \
            where the noise decides, within the tolerance where there is one, and else passes through it", of(*turning), unit(*turning);

        /// A smoothed motion starts or ends a span much faster than it moves there on average: it overshoots the poses, as where two of
        /// them are close together in time and farther apart than the tolerance.
        Swings {
            /// The span with the largest ratio, by the pose at its start, from 0.
            span: usize,
            /// How many such spans there are.
            count: usize,
            /// True for rotations, in radians; else for positions.
            turning: bool,
            /// How many times as fast; infinite where the two poses are equal.
            ratio: f64,
            /// How far it overshoots the poses there.
            beyond: f64,
        }
        reason "motion-swings";
        at *span;
        says "the smoothed motion overshoots its poses in {0} in {count} span(s), most after pose {span}, by \
            {beyond}{1}: its times do not fit the distances between the poses there; give times that fit the path \
            lengths, leave out a pose that is too close to the next one in time, or use a larger tolerance",
            of(*turning), unit(*turning);

        /// The tolerance of a smoothed motion is so large that its path is less than 0.8 times as long as the poses indicate.
        SmoothedAway {
            /// True for rotations, in radians; else for positions.
            turning: bool,
            /// Length of the path.
            path: f64,
            /// Length of that through the poses without their noise.
            poses: f64,
        }
        reason "shape-smoothed-away";
        says "the path of the motion in {0} is {path}{1} long, but its poses indicate {poses}{1}: details smaller \
            than the tolerance are lost; give a smaller one", of(*turning), unit(*turning);

        /// The tolerance of a smoothed motion is large compared with the path, without noise to justify it.
        WideTolerance {
            /// True for rotations, in radians; else for positions.
            turning: bool,
            /// The tolerance.
            tolerance: f64,
            /// The extent of the poses without their noise, from the first.
            extent: f64,
        }
        reason "wide-tolerance";
        says "the {0} tolerance of {tolerance}{1} is large compared with the path, which extends {extent}{1} from its \
            start: bends smaller than it may be lost", of(*turning), unit(*turning);

        /// The tolerance of a smoothed motion is so far above the noise that the motion is farther from the path than the poses are.
        WiderThanNoise {
            /// True for rotations, in radians; else for positions.
            turning: bool,
            /// The tolerance.
            tolerance: f64,
            /// Root of the mean square of the distances from the poses without their noise.
            off: f64,
            /// The same of what the noise moves the poses by.
            moves: f64,
        }
        reason "wide-tolerance";
        says "the {0} tolerance of {tolerance}{1} is above the noise of the poses, which moves them by {moves}{1} (rms): \
            the motion is about {off}{1} (rms) from the poses without their noise, farther than they are; let the \
            noise decide how much is smoothed, or give a smaller tolerance", of(*turning), unit(*turning);
    }
}

/// What a tolerance of a motion is of.
const fn of(turning: bool) -> &'static str {
    if turning { "angle" } else { "position" }
}

/// The unit of an angle; lengths have none.
const fn unit(turning: bool) -> &'static str {
    if turning { " rad" } else { "" }
}
