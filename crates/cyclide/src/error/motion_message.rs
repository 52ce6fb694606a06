//! What errors of displacements and motions say.

use super::Error;
use crate::shape_change::degrees;
use crate::short_number::ShortNumber;

/// The sentence of an error about poses and motions; empty for another.
pub(super) fn of_motion(error: &Error) -> String {
    match error {
        Error::ZeroRotation { index } => format!("rotation {index} is zero: it has no direction"),
        Error::NotARotation { off, limit } => format!(
            "the matrix is no displacement: its first three columns have to be orthonormal and right-handed and its last row 0 0 0 1, \
             and they are off by {}, limit {} (with more decimals they are nearer; one that scales or mirrors is none)",
            ShortNumber(*off),
            ShortNumber(*limit)
        ),
        Error::NotOnStudyQuadric { product, limit } => format!(
            "the dual quaternion is no displacement: its parts are not perpendicular, their product over both lengths is {}, limit {}",
            ShortNumber(*product),
            ShortNumber(*limit)
        ),
        Error::WrongPoseCount { given, needed, or_more } => {
            format!("{given} poses given, {needed}{} needed", if *or_more { " or more" } else { "" })
        }
        Error::ParametersNotIncreasing { index, value, before } => format!(
            "the parameters do not rise: number {index} is {} after {}",
            ShortNumber(*value),
            ShortNumber(*before)
        ),
        Error::UnattainablePose { index, share, limit } if share > limit => format!(
            "no motion of this degree takes all poses: pose {index} is missed by {} of the size, limit {}",
            ShortNumber(*share),
            ShortNumber(*limit)
        ),
        Error::UnattainablePose { index, share, limit } => format!(
            "no motion of this degree takes pose {index} with the others: its factor against the largest is {}, limit {}; take a \
             spline, or another time for it",
            ShortNumber(*share),
            ShortNumber(*limit)
        ),
        Error::MotionThroughExceptionalPoint { time, share, remainder: _, limit } if share <= limit => format!(
            "the motion of least degree runs out to infinity at {}: the share of the rotation there is {}, limit {}; take a spline, or \
             other times",
            ShortNumber(*time),
            ShortNumber(*share),
            ShortNumber(*limit)
        ),
        Error::MotionThroughExceptionalPoint { time, share: _, remainder, limit } => format!(
            "the motion of least degree has no pose at {}: its terms cancel there, what is left of them is {} of their squares, limit {}; \
             take a spline, or other times",
            ShortNumber(*time),
            ShortNumber(*remainder),
            ShortNumber(*limit)
        ),
        Error::RotationTooLarge { span, length, limit } => format!(
            "span {span} turns so far that its direction is lost: the quaternion gets as short as {}, limit {}; insert a pose",
            ShortNumber(*length),
            ShortNumber(*limit)
        ),
        Error::NoCubicMotion { discriminant, roots } if roots.is_empty() => format!(
            "no motion of degree 3 takes these four poses, at whatever times: the discriminant of its equation is {}, at least 0 is \
             needed",
            ShortNumber(*discriminant)
        ),
        Error::NoCubicMotion { roots, .. } => {
            let roots: Vec<String> = roots.iter().map(|x| ShortNumber(*x).to_string()).collect();
            format!(
                "no motion of degree 3 takes these four poses one after the other at this cross-ratio of times: there are some at {} \
                 only, and between 0 and 1 is needed",
                roots.join(" and ")
            )
        }
        Error::StudyFormVanishes { measured, limit } => format!(
            "the poses are planar, spherical or moved without a turn against each other (Study form {}, limit {}): motions of degree 3 \
             are not determined by them; take a spline",
            ShortNumber(*measured),
            ShortNumber(*limit)
        ),
        Error::MotionNotRational => {
            "the points of a screw motion run on helices, which no rational curve is; take a spline".to_owned()
        }
        Error::MotionAtRest { length, limit } => format!(
            "the motion is at rest: the way that should be gone is {} long, which must be above {}: name a point that moves, or an arm",
            ShortNumber(*length),
            ShortNumber(*limit)
        ),
        Error::SpanWithoutWay { span, turn, length, limit } => {
            let (does, remedy) = match *turn {
                turn if turn > 0.0 => (
                    format!("turns by {} degrees on the spot", degrees(turn)),
                    "give an `arm`, the length by which a turn counts as way, or name a `tool` that moves",
                ),
                _ => ("rests".to_owned(), "give times"),
            };
            format!(
                "span {span}, from pose {span} to the next, {does}: its way is {} long, which must be above {}, and what goes by the way has no time \
                 for it: {remedy}",
                ShortNumber(*length),
                ShortNumber(*limit)
            )
        }
        _ => String::new(),
    }
}
