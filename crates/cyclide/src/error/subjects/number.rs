//! Why a number of the input was refused.

use crate::error::ErrorItem;
use crate::error::words::at_least;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Why a number of the input was refused.
    ///
    /// ```
    /// use cyclide::{Error, error::NumberError};
    /// let error: Error = NumberError::ToleranceNotPositive { tolerance: 0.5 }.into();
    /// assert_eq!(error.reason(), "tolerance-not-positive");
    /// ```
    pub enum NumberError: Error {
        /// A number of the input is NaN or infinite.
        NotFinite {
            /// The kind of item.
            what: ErrorItem,
            /// Which one, from 0.
            index: usize,
        }
        reason "not-finite";
        at *index;
        entry what.list();
        says "{what} {index} is not a finite number";

        /// A parameter is outside its interval.
        ParameterOutOfRange {
            /// Which parameter.
            name: ErrorItem,
            /// Its value.
            value: f64,
            /// Smallest value accepted.
            min: f64,
            /// Largest value accepted; `f64::MAX` for no upper limit.
            max: f64,
        }
        reason "parameter-out-of-range";
        at name.entry();
        entry name.field();
        says "{name} = {value:#} is {}", outside(*name, *value, [*min, *max]);

        /// A tolerance is zero, negative or not a number.
        ToleranceNotPositive {
            /// The tolerance given.
            tolerance: f64,
        }
        reason "tolerance-not-positive";
        field "tolerance";
        says "the tolerance {tolerance} is not positive";

        /// A radius is zero relative to the position of its center.
        ZeroRadius {
            /// The radius found.
            radius: f64,
            /// Radii up to this are refused.
            limit: f64,
        }
        reason "zero-radius";
        says "the radius {radius} is zero, must be above {limit}";

        /// A radius, length or tolerance that must be positive is not.
        RadiusNotPositive {
            /// The kind of item.
            what: ErrorItem,
            /// Which one, from 0.
            index: usize,
            /// The value given.
            radius: f64,
        }
        reason "radius-not-positive";
        at *index;
        entry what.list();
        says "the radius {radius} is not positive";

        /// The factor of a similarity is zero, negative or not a number.
        ScaleNotPositive {
            /// The factor given.
            factor: f64,
        }
        reason "scale-not-positive";
        says "the scale factor {factor} is not positive";

        /// The blend order is outside what is supported.
        OrderOutOfRange {
            /// The order asked for.
            order: u32,
            /// The largest order supported.
            max: u32,
        }
        reason "order-out-of-range";
        field "order";
        says "blend order {order} is outside 1 to {max}";

        /// A swept angle is outside its range.
        SweepOutOfRange {
            /// The angle given, radians.
            sweep: f64,
            /// Smallest angle accepted.
            min: f64,
            /// Largest angle accepted.
            max: f64,
        }
        reason "sweep-out-of-range";
        says "the swept angle {sweep:#} is outside {min:#} to {max:#} radians, the ends excluded";

        /// An angle of rotation is out of range: more than a full turn, a full turn in one piece, or zero for a body.
        AngleOutOfRange {
            /// Which angle.
            name: ErrorItem,
            /// The angle given, radians.
            angle: f64,
            /// Smallest angle accepted.
            min: f64,
            /// Largest angle accepted.
            max: f64,
        }
        reason "angle-out-of-range";
        field name.word();
        when *angle == 0.0, says "the angle is 0, must be nonzero and at most {max:#} radians ({} degrees)",
            ShortNumber(max.to_degrees());
        says "the angle of {angle:#} radians ({} degrees) is outside {min:#} to {max:#} radians ({} to {} degrees)",
            ShortNumber(angle.to_degrees()),
            ShortNumber(min.to_degrees()),
            ShortNumber(max.to_degrees());

        /// A list does not have one entry for each point or vertex.
        CountDiffers {
            /// What the list holds.
            what: ErrorItem,
            /// How many are given.
            given: usize,
            /// Number of points or vertices.
            needed: usize,
        }
        reason "count-differs";
        field what.list();
        when *what == ErrorItem::Radius, says "{given} radii given for {needed} points";
        when *what == ErrorItem::Knot, says "{given} knots given, {needed} needed";
        when *what == ErrorItem::Weight, says "{given} weights given for {needed} control points";
        when *what == ErrorItem::Normal, says "{given} normals given for {needed} vertices";
        says "{given} {what}s given for {needed} points";

        /// A refinement would need more pieces than its cap on work and memory.
        TooManyPieces {
            /// What would grow.
            what: &'static str,
            /// Which segment or piece of a curve, from 0; `None` for the whole.
            segment: Option<usize>,
            /// Pieces needed, as far as they were counted.
            needed: f64,
            /// Largest number of pieces allowed.
            cap: usize,
            /// The remedy.
            remedy: &'static str,
        }
        reason "too-many-pieces";
        at *segment;
        entry segment.is_none().then_some("tolerance");
        when segment.is_some(), says "{what} {segment} needs {} pieces, the limit is {cap}: {remedy}",
            at_least(*needed);
        says "{what} needs {} pieces, the limit is {cap}: {remedy}", at_least(*needed);
    }
}

/// In words, that a value is outside its interval, and whether the ends of that are excluded: they are where the value is one of
/// them, and of what can never be as small or as large.
fn outside(name: ErrorItem, value: f64, [min, max]: [f64; 2]) -> String {
    let is = |end: f64| (value - end).abs() <= 0.0;
    let open = matches!(name, ErrorItem::Duration | ErrorItem::Height | ErrorItem::Wall);
    let (low, high) = (ShortNumber(min), ShortNumber(max));
    if max >= f64::MAX {
        // Such a tiny limit is only numerical.
        return match (open || is(min), value <= 0.0 && min > 0.0 && min <= SMALLEST) {
            (_, true) => "out of range: must be above 0".to_owned(),
            (true, _) => format!("out of range: must be above {low:#}"),
            (false, _) => format!("out of range: must be at least {low:#}"),
        };
    }
    let excluded = match (open, is(min), is(max)) {
        (true, ..) => ", the ends excluded".to_owned(),
        (_, true, _) => format!(", {low:#} excluded"),
        (_, _, true) => format!(", {high:#} excluded"),
        _ => String::new(),
    };
    format!("outside {low:#} to {high:#}{excluded}")
}

/// Limits up to here are there for the sake of the arithmetic.
const SMALLEST: f64 = 1e-150;
