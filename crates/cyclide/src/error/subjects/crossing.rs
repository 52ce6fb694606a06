//! Why a crossing of two pipes was refused.

use crate::error::{ErrorItem, FoldRemedy};
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why a crossing of two pipes was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::CrossingError};
    /// let error: Error = CrossingError::AxesTooNear { distance: 1e-12, limit: 1e-9 }.into();
    /// assert_eq!(error.reason(), "crossing-axes-too-near");
    /// ```
    pub enum CrossingError: Error {
        /// The axes of a crossing are too near to each other.
        AxesTooNear {
            /// Their distance.
            distance: f64,
            /// The difference of the radii, of cones where they are nearest: the distance must be above this.
            limit: f64,
        }
        reason "crossing-axes-too-near";
        field "distance";
        says "the axes are {distance} apart; pipes that pass each other need more than the difference of the radii, \
            {limit}: move the axes apart, or use a branch of a `pipe-tee` if one pipe ends on the other";

        /// A ball is too large for the edge of a crossing: of the intersection of the pipes, or of their difference.
        BallTooLarge {
            /// Its radius.
            radius: f64,
            /// Half of the overlap of the pipes along the common normal of their axes: the radius must be below this.
            limit: f64,
            /// A radius with which the body is made, where that was looked for and one was found.
            works: Option<f64>,
        }
        reason "crossing-ball-too-large";
        field "blend";
        when *limit <= 0.0, says "the pipes do not overlap, so there is no edge to round: they are {} apart",
            ShortNumber(-2.0 * *limit);
        when works.is_some(), says "a ball of radius {radius} cannot roll along the edge: the radius must be below \
            {limit}, half of the overlap of the pipes, and may have to be smaller for its hole; {} works",
            ShortNumber::no_more(works.unwrap_or_default());
        says "a ball of radius {radius} cannot roll along the edge: the radius must be below {limit}, half of the \
            overlap of the pipes";

        /// A ball is beyond its bound, and none within it works either.
        NoBallWorks {
            /// Its radius.
            radius: f64,
            /// The bound: half of the gap between the pipes, or half of their overlap.
            limit: f64,
        }
        reason "crossing-no-ball";
        field "blend";
        says "a ball of radius {radius} does not fit, its bound is {limit}, and no radius within the bound works: the \
            blend self-intersects, or its hole reaches too far round a pipe; turn the axes closer to a right angle, \
            move them, or use a thinner wall";

        /// One pipe is to be cut by the other, but they do not intersect, or only barely.
        PipesApart {
            /// The distance of their axes.
            distance: f64,
            /// The sum of their radii less a thousandth of it: the distance must be below this.
            limit: f64,
        }
        reason "crossing-pipes-apart";
        field "distance";
        says "the pipes do not intersect, or only barely, so neither cuts the other: their axes are {distance} apart, \
            must be below {limit}, the sum of the radii less 0.1 %";

        /// A pipe has a taper, but the crossing requires cylinders.
        NeedsCylinders {
            /// What requires them: the side of the ball, or the law of its radius.
            what: ErrorItem,
            /// Which pipe has a taper, from 0.
            pipe: usize,
            /// The taper, in radians.
            taper: f64,
        }
        reason "crossing-needs-cylinders";
        field what.word();
        says "pipe {pipe} has a taper of {taper} radians, but the requested {} requires cylinders: tapered pipes \
            need a ball of constant radius, outside or inside both", what.word();

        /// The balls of a blend have no surface of centers: only those of pipes that pass each other have one, outside both
        /// or inside both.
        NoCenterSurface
        reason "no-center-surface";
        says "these balls have no surface of centers: it exists only for pipes that pass each other, with balls \
            outside both or inside both";

        /// A pipe of a crossing ends within the blend.
        PipeTooShort {
            /// Which pipe, from 0.
            pipe: usize,
            /// The end, as a position along the axis.
            end: f64,
            /// The position that it must extend beyond.
            needed: f64,
        }
        reason "crossing-pipe-too-short";
        at *pipe;
        entry "pipes";
        says "pipe {pipe} ends within the blend: it ends at {end} and must extend beyond {needed}";

        /// The hole of a crossing extends too far round a pipe.
        HoleTooWide {
            /// Which pipe, from 0.
            pipe: usize,
            /// How far it extends to either side, in radians.
            angle: f64,
            /// The largest such angle.
            limit: f64,
        }
        reason "crossing-hole-too-wide";
        at *pipe;
        entry "pipes";
        says "the hole in pipe {pipe} spans +-{angle} radians, maximum +-{limit}; use a smaller ball, or move the \
            axes apart";

        /// The border of the hole of a crossing turns back, so that parts of its pipe would overlap.
        HoleTurnsBack {
            /// Which pipe, from 0.
            pipe: usize,
            /// Where, as a position along its axis.
            along: f64,
        }
        reason "crossing-hole-turns-back";
        at *pipe;
        entry "pipes";
        says "the border of the hole in pipe {pipe} turns back at {along} along its axis; use a smaller ball, move \
            the axes apart, or turn them closer to a right angle";

        /// The blend of a crossing self-intersects.
        Folds {
            /// Where its ball is, as an angle about the common normal of the axes, from the first axis.
            angle: f64,
            /// Its width there, relative to that on a straight path.
            left: f64,
            /// What helps.
            remedy: FoldRemedy,
            /// True for the blend of an inner skin, below a wall.
            walled: bool,
        }
        reason "crossing-folds";
        field "blend";
        says "the blend self-intersects where its ball is at {angle} radians from the first axis (width factor \
            {left}, must be above 0); {}", remedy.advice(*walled);
    }
}
