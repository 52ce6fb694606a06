//! What an error says: plain sentences with the item, the measure and the limit.

use super::motion_message::of_motion;
use super::volume_message::of_volume;
use super::words::{
    along_pinned, at_infinity, at_least, clockwise, count_differs, index_of_halves, nearer, numbered, opposed, outside,
    place, points_in_words, size_in_place, speed_ratio, through_infinity, turn, zero_axis,
};
use super::{Error, ErrorItem};
use crate::short_number::ShortNumber;

/// What comes nearer to itself than this part of its width crosses itself.
const CROSSING: f64 = 1e-6;

/// Outliers that are named one by one.
const NAMED_OUTLIERS: usize = 20;

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NotFinite { what, index } => write!(f, "{what} {index} is not a finite number"),
            Self::CoincidentPoints { first, second, limit: ..=0.0, .. } => {
                write!(f, "points {first} and {second} coincide")
            }
            Self::CoincidentPoints { first, second, distance, limit } => write!(
                f,
                "points {first} and {second} coincide (distance {}, at most {} is allowed to be called equal)",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::TooFewPoints { given, needed } => {
                write!(f, "too few points: {given} given, at least {needed} needed")
            }
            Self::ZeroWeight { index } => write!(f, "weight {index} is zero"),
            Self::PoleOnSegment { real, vector, limit } => write!(
                f,
                "the arc passes through infinity: its weight ratio has real part {} and vector part {}, limit {}",
                ShortNumber(*real),
                ShortNumber(*vector),
                ShortNumber(*limit)
            ),
            Self::NearlyFullCircle { rest, limit } => write!(
                f,
                "the arc turns by a full circle less {} radians, limit {}: its ends nearly coincide; take a circle, or two arcs",
                ShortNumber(*rest),
                ShortNumber(*limit)
            ),
            Self::NotInImH { cosine, limit } => write!(
                f,
                "the weight takes the arc out of three-space: cosine {} between chord and weight, limit {}",
                ShortNumber(*cosine),
                ShortNumber(*limit)
            ),
            Self::ZeroTangent { index } => write!(f, "tangent {index} is zero"),
            Self::TangentOpposesChord { index, angle, limit } => f.write_str(&opposed(*index, *angle, *limit)),
            Self::PointAtInfinity { what, distance, limit, .. } => f.write_str(&at_infinity(*what, *distance, *limit)),
            Self::NoFiniteBiarc { measured, value, limit } => {
                write!(f, "no finite biarc: {measured} is {}, limit {}", ShortNumber(*value), ShortNumber(*limit))
            }
            Self::Cusp { index, measured, limit } => write!(
                f,
                "cusp at point {index}: the unit chords sum to {}, limit {}; split the points there",
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::CountDiffers { what, given, needed } => f.write_str(&count_differs(*what, *given, *needed)),
            Self::NotOfArcs { wanted } => write!(
                f,
                "the curve is not made of arcs and segments: give the tolerance within which arcs may replace it, or take a curve of arcs ({wanted})"
            ),
            Self::ZeroAxis { what, length, limit, .. } => f.write_str(&zero_axis(*what, *length, *limit)),
            Self::ZeroRadius { radius, .. } => write!(f, "the radius {} is zero", ShortNumber(*radius)),
            Self::ScaleNotPositive { factor } => write!(f, "the scale factor {} is not positive", ShortNumber(*factor)),
            Self::RadiusNotPositive { radius } => write!(f, "the radius {} is not positive", ShortNumber(*radius)),
            Self::ConeReachesApex { apex, reached } => write!(
                f,
                "the cone, within its wall if it has one, comes to its apex at {} along its axis, and is needed as far as {}; take a smaller taper, a larger radius, or a shorter pipe",
                ShortNumber(*apex),
                ShortNumber(*reached)
            ),
            Self::BallDoesNotFit { radius, limit } => write!(
                f,
                "a ball of radius {} does not fit into the pipe or the hole: its radius must be below {}",
                ShortNumber(*radius),
                ShortNumber(*limit)
            ),
            Self::NeckFolds { radius, limit } => write!(
                f,
                "the neck runs through itself on the side to which the pipe leans and bounds no solid: a ball of radius {} rolls through bends of radius {}; take a smaller ball",
                ShortNumber(*radius),
                ShortNumber(*limit)
            ),
            Self::PlateTooSmall { what, reach, needed } => write!(
                f,
                "the plate is too small: it reaches {} from the axis of the pipe, the {what} {}",
                ShortNumber(*reach),
                ShortNumber(*needed)
            ),
            Self::TeeBranchTooWide { branch, reach, limit, rest, offset } => {
                write!(
                    f,
                    "branch {branch} reaches {} sideways from the axis of the main pipe, whose radius is {}: ",
                    ShortNumber(*reach),
                    ShortNumber(*limit)
                )?;
                let width = reach - offset.abs();
                let room = limit - width;
                if reach < limit {
                    // Thinner, but by too little.
                    write!(
                        f,
                        "less than {} is left between them, in which a blend has no digits; ",
                        ShortNumber(*rest)
                    )?;
                    return if *offset == 0.0 {
                        let thinner = limit - 2.0 * rest;
                        write!(
                            f,
                            "make it {} at most, or of one radius with the main pipe, both cylinders whose axes meet",
                            ShortNumber(thinner)
                        )
                    } else {
                        f.write_str("make it thinner, or its offset smaller")
                    };
                }
                f.write_str("a branch stands within its breadth, thinner and offset by less than the radii differ, or is of one radius with it, a cylinder whose axis meets the other; ")?;
                if *offset == 0.0 || room <= 0.0 {
                    return f.write_str("make it thinner, or let the wider pipe be the main one");
                }
                write!(
                    f,
                    "make it thinner, or its offset less than {}; a pipe that goes on past the other, its axis farther off than the radii differ, is a `pipe-crossing`, at any angle",
                    ShortNumber(room)
                )
            }
            Self::TeeBlendTooLarge { branch, radius, limit } if *limit > 0.0 => write!(
                f,
                "the blend of branch {branch}, of one quartic with the radius {} at its flank, has an infinite one in a crotch: its radius must be below {}, or give one radius for all of it",
                ShortNumber(*radius),
                ShortNumber(*limit)
            ),
            Self::TeeBlendTooLarge { branch, radius, .. } => write!(
                f,
                "the blend of branch {branch}, of one quartic with the radius {} at its flank, has an infinite one in a crotch, as has any where the radii of the pipes differ by so little more than their offset: give one radius for all of it",
                ShortNumber(*radius)
            ),
            Self::TeeLawOnEqualPipes { branch, radii: [first, second] } => write!(
                f,
                "branch {branch} is as wide as the main pipe, and its blend has one radius all round, not {} and {}: give one, or make the branch thinner",
                ShortNumber(*first),
                ShortNumber(*second)
            ),
            Self::TeePipeTooShort { what: ErrorItem::Branch, branch, end, needed } => write!(
                f,
                "branch {branch} ends within its blend: at {} along its axis, which must be above {}",
                ShortNumber(*end),
                ShortNumber(*needed)
            ),
            Self::TeePipeTooShort { what, branch, end, needed } => write!(
                f,
                "the {what} ends within the blend of branch {branch}: at {}, which must be beyond {}",
                ShortNumber(*end),
                ShortNumber(*needed)
            ),
            Self::BallsNested { first, second, distance, limit } => write!(
                f,
                "of the balls {first} and {second} one holds the other: their centres are {} apart, their radii differ by {}; move them apart or take radii that are nearer to each other",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::TubeTurnsBack { ball } => write!(
                f,
                "no smooth tube goes on at ball {ball}: its neighbours lie on one side, or the radii change too fast for the turn; put balls between"
            ),
            Self::TubeRadiusVanishes { piece, radius } => write!(
                f,
                "between ball {piece} and the next one the radius of the tube falls to {}, though both have a positive one: put a ball between them, or let the radii change less",
                ShortNumber(*radius)
            ),
            Self::TubeFolds { piece, at, left } => write!(
                f,
                "the tube folds in piece {piece} at {}, where it bends or its radius swings faster than its width allows: {} of the width is left, it must be above 0; take smaller radii, wider bends or a slower change of the radius",
                ShortNumber(*at),
                ShortNumber(*left)
            ),
            Self::RadiusGrowsTooFast { piece, rate, limit } => write!(
                f,
                "the radius changes by {} for each length of the way in piece {piece}, it must be below {}: the balls would hold each other; spread the change over more of the length",
                ShortNumber(*rate),
                ShortNumber(*limit)
            ),
            Self::RadiusNotClosed { first, last } => write!(
                f,
                "the curve is closed, but the radius begins with {} and ends with {}: make both equal",
                ShortNumber(*first),
                ShortNumber(*last)
            ),
            Self::TeeBlendFolds { branch, angle, left, wall } => {
                let (side, remedy) = match wall {
                    None => (String::new(), "take a smaller radius there, or one that changes less"),
                    Some(wall) => {
                        let inside =
                            format!(" inside its wall of {}, where its balls are larger by that,", ShortNumber(*wall));
                        (inside, "take a thinner wall, or a smaller radius there")
                    }
                };
                write!(
                    f,
                    "the blend of branch {branch}{side} runs through itself at {} round the branch: its width there is {} of that on a straight way, which must be positive; {remedy}",
                    turn(*angle),
                    ShortNumber(*left)
                )
            }
            Self::TeeHoleFolds { branch, angle } => write!(
                f,
                "the blend of branch {branch} meets the main pipe in a line that turns back at {} round the branch: let the radius change less there",
                turn(*angle)
            ),
            Self::PipeEndsReversed { pipe, start, end } => write!(
                f,
                "the ends of pipe {pipe} are at {} and {}: the lower place comes first",
                ShortNumber(*start),
                ShortNumber(*end)
            ),
            Self::CrossingAxesTooNear { distance, limit } => write!(
                f,
                "the axes are {} apart, and pipes pass each other if that is more than their radii differ, by {}: move them apart; a pipe that ends on another, its axis nearer or meeting, is a branch of a `pipe-tee`",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::CrossingBallTooLarge { limit, .. } if *limit <= 0.0 => write!(
                f,
                "the pipes have nothing in common whose edge could be rounded: they are {} apart",
                ShortNumber(-2.0 * *limit)
            ),
            Self::CrossingBallTooLarge { radius, limit } => write!(
                f,
                "a ball of radius {} does not roll along the edge: it must be below {}, half of the room that the pipes leave it",
                ShortNumber(*radius),
                ShortNumber(*limit)
            ),
            Self::CrossingPipesApart { distance, limit } => write!(
                f,
                "the pipes do not meet, or hardly, and neither cuts the other: their axes are {} apart, which must be below the sum of the radii less a thousandth, {}",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::CrossingNeedsCylinders { what, pipe, taper } => write!(
                f,
                "pipe {pipe} has a taper of {} radians, and such pipes are crossed by a ball of one radius outside or inside both: the {} asks for cylinders",
                ShortNumber(*taper),
                what.word()
            ),
            Self::NoCenterSurface => write!(
                f,
                "the centres of these balls have no surface of their own: only pipes that pass each other have one, with balls outside both or inside both"
            ),
            Self::CrossingPipeTooShort { pipe, end, needed } => write!(
                f,
                "pipe {pipe} ends within the blend: at {}, which must be beyond {}",
                ShortNumber(*end),
                ShortNumber(*needed)
            ),
            Self::CrossingHoleTooWide { pipe, angle, limit } => write!(
                f,
                "the blend goes {} radians round pipe {pipe} to either side, and at most {} leave a back to it; take a smaller ball, or move the axes apart",
                ShortNumber(*angle),
                ShortNumber(*limit)
            ),
            Self::CrossingHoleTurnsBack { pipe, along } => write!(
                f,
                "the border of the hole in pipe {pipe} turns back at {} along it; take a smaller ball, move the axes apart, or turn them nearer to a right angle",
                ShortNumber(*along)
            ),
            Self::CrossingFolds { angle, left, remedy, walled } => write!(
                f,
                "the blend runs through itself where its ball is at {} radians from the first axis: its width there is {} of that on a straight way, which must be positive; {}",
                ShortNumber(*angle),
                ShortNumber(*left),
                remedy.advice(*walled)
            ),
            Self::ContactLoopOpen { ring: true, measured, .. } => write!(
                f,
                "no ball of this radius touches both the ring and what it stands on: what must be positive is {}; the ring is too far from it, or within it: change its height, its radius or the ball",
                ShortNumber(*measured)
            ),
            Self::ContactLoopOpen { angle, measured, .. } => write!(
                f,
                "no ball of this radius touches both at {} radians round the tube: what must be positive there is {}; the tube has to meet the plane or the sphere all round, with room for the ball: move its axis nearer to the centre of the sphere, turn it nearer to the normal of the plane, or take a thinner tube",
                ShortNumber(*angle),
                ShortNumber(*measured)
            ),
            Self::ContactLoopTurnsBack { angle } => write!(
                f,
                "the border of the blend on the sphere turns back at {} radians round the cone; take one that widens less towards its end, or whose axis passes nearer to the centre of the sphere",
                ShortNumber(*angle)
            ),
            Self::ContactBlendFolds { angle, left } => write!(
                f,
                "the blend runs through itself at {} radians round the tube: its width there is {} of that on a straight way, which must be positive; take a smaller ball or a thinner wall",
                ShortNumber(*angle),
                ShortNumber(*left)
            ),
            Self::ContactTubeTooShort { end, needed } => write!(
                f,
                "the tube ends within the blend: at {} along its axis, which must be beyond {}",
                ShortNumber(*end),
                ShortNumber(*needed)
            ),
            Self::TeeBranchesMeet { first, second, distance, needed, round } if *distance < 0.0 => write!(
                f,
                "branches {first} and {second}, with their blends, overlap by {} along the main pipe and {} {} radians{} round it: one has to be behind the other, \
                 by {} at least (`at` moves a branch), or both beside each other with room for their blends (`azimuth` turns one)",
                ShortNumber(-*distance),
                if *round < 0.0 { "by" } else { "are only" },
                ShortNumber(round.abs()),
                if *round < 0.0 { "" } else { " apart" },
                ShortNumber(*needed)
            ),
            Self::TeeBranchesTooNear { first, second, point: [x, y, z], needed } => write!(
                f,
                "branches {first} and {second}, or their blends, run into each other at {}, {}, {}, or come nearer than {} there: take shorter ones, or turn or move one",
                ShortNumber(*x),
                ShortNumber(*y),
                ShortNumber(*z),
                ShortNumber(*needed)
            ),
            Self::TeeEqualBranchesNotOpposite { first, second, angle, along, needed } => write!(
                f,
                "branches {first} and {second} are as wide as the main pipe: two such stand exactly opposite each other at one place along it, and these are off that by {} \
                 degrees{}; turn one (`azimuth`, 180 degrees from the other), or move them {} apart along the pipe (`at`)",
                ShortNumber(angle.to_degrees()),
                if *along > 0.0 { format!(" and by {} along it", ShortNumber(*along)) } else { String::new() },
                ShortNumber(*needed)
            ),
            Self::TeeNoFreeLine { first, second } => write!(
                f,
                "no lines along the main pipe part it beside branches {first} and {second}: each has to be free of holes, and less than half a turn from the \
                 branches next to it; move one along the pipe (`at`) or turn it (`azimuth`)"
            ),
            Self::TeeBranchesMeet { first, second, distance, needed, .. } => write!(
                f,
                "branches {first} and {second} meet, or their blends do: their distance is {}, which must be above {}",
                ShortNumber(*distance),
                ShortNumber(*needed)
            ),
            Self::EllipsesCross { along_x, along_y } => write!(
                f,
                "the ellipses cross: the second is wider by {} along x and by {} along y; a solid needs one inside the other",
                ShortNumber(*along_x),
                ShortNumber(*along_y)
            ),
            Self::PieceCountsDiffer { first, second } => write!(
                f,
                "the first curve has {first} piece(s), the second {second}: pieces are joined one by one, in their order"
            ),
            Self::RulingsCross { piece, at, normal, limit } => write!(
                f,
                "the straight lines between piece {piece} of both curves cross, or lie in one line: at {} of the piece and {} of the way between them the surface has no normal (of its length {} is left, limit {}); does the second curve run the other way?",
                ShortNumber(at[0]),
                ShortNumber(at[1]),
                ShortNumber(*normal),
                ShortNumber(*limit)
            ),
            Self::ArcsCross { piece, at } => write!(
                f,
                "the arcs between piece {piece} of both curves cross their neighbours near {} of the piece and {} of the arcs, and the surface runs through itself or folds back; does the second curve run the other way, or the tangent away from it?",
                ShortNumber(at[0]),
                ShortNumber(at[1])
            ),
            Self::OppositeTangents { first, second, length, limit } => write!(
                f,
                "between tangents {first} and {second}, which oppose each other, there is a place without a direction: {} of the longer one is left, limit {}; turn one of them to a side",
                ShortNumber(*length),
                ShortNumber(*limit)
            ),
            Self::DegreeTooHigh { degree, limit } => write!(
                f,
                "the degree would be {degree}, limit {limit}: take fewer points, or curves of lower degrees (segments have 1, arcs 2, fair splines 4)"
            ),
            Self::DegenerateCircle { sine, limit } => write!(
                f,
                "the points lie on a line: sine of their angle {}, limit {}",
                ShortNumber(*sine),
                ShortNumber(*limit)
            ),
            Self::DegenerateSphere { volume, limit } => write!(
                f,
                "the points lie in a plane: relative volume {}, limit {}",
                ShortNumber(*volume),
                ShortNumber(*limit)
            ),
            Self::OrderOutOfRange { order, max } => write!(f, "blend order {order} is outside 1 to {max}"),
            Self::ArcThroughInfinity { segment, reach, limit } => {
                f.write_str(&through_infinity(*segment, *reach, *limit))
            }
            Self::AmbiguousHalfTurn { segment, .. } => write!(
                f,
                "segment {segment}: opposite circles along the chord, the half-turn between them is ambiguous"
            ),
            Self::TooManyPieces { what, segment, needed, cap, remedy } => write!(
                f,
                "{what}{} needs {} pieces, at most {cap} are made: {remedy}",
                numbered(*segment),
                at_least(*needed)
            ),
            Self::BelowRoundingOfPlace { what: ErrorItem::Cells, size, place, limit } => write!(
                f,
                "cells are as short as {} at coordinates of up to {}, which are rounded: below {} their ends are one point; take fewer, or lengths that differ less",
                ShortNumber(*size),
                ShortNumber(*place),
                ShortNumber(*limit)
            ),
            Self::BelowRoundingOfPlace { what, size, place, limit } => write!(
                f,
                "the {what} is {} at coordinates of up to {}, which are rounded: below {} it has no shape of its own; make it larger, or move it to the origin",
                size_in_place(*size),
                ShortNumber(*place),
                ShortNumber(*limit)
            ),
            Self::EvenPointCount { given } => write!(
                f,
                "{given} conditions given: a curve of degree n takes an odd number, 2n + 1; add or leave out a point, or take a Moebius \
                 spline, which takes any number"
            ),
            Self::RepeatedParameter { first, second, value } => {
                write!(f, "parameters {first} and {second} are both {}", ShortNumber(*value))
            }
            Self::UnattainablePoint { points, measured, limit } => write!(
                f,
                "{} cannot be attained: the others lie, at their parameters, on a curve of lower degree that misses them ({}, limit \
                 {}); move a point or change the parameters",
                points_in_words(points),
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::CurveThroughInfinity { t } => write!(
                f,
                "the curve passes through infinity near the parameter {}: change the parameters, move a point, or take a Moebius spline",
                ShortNumber(*t)
            ),
            Self::OppositeArcs { measured, limit } => write!(
                f,
                "the circles along both tangents run in opposite directions ({} of a common one, at least {} needed): turn a tangent, or \
                 put a point between",
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::NotWithinTolerance { piece, bound, tolerance } => write!(
                f,
                "piece {piece}: the curve is not proved to be within {} of a polyline, only within {}; use a larger tolerance",
                ShortNumber(*tolerance),
                ShortNumber(*bound)
            ),
            Self::ToleranceNotPositive { tolerance } => {
                write!(f, "the tolerance {} is not positive", ShortNumber(*tolerance))
            }
            Self::SweepOutOfRange { sweep, min, max } => write!(
                f,
                "the swept angle {:#} is outside {:#} to {:#} radians, the ends excluded",
                ShortNumber(*sweep),
                ShortNumber(*min),
                ShortNumber(*max)
            ),
            Self::AngleOutOfRange { angle: 0.0, max, .. } => write!(
                f,
                "the angle is 0, and must be another one of up to {:#} radians ({} degrees)",
                ShortNumber(*max),
                ShortNumber(max.to_degrees())
            ),
            Self::AngleOutOfRange { angle, min, max } => {
                let [own, from, to] = [*angle, *min, *max].map(|radians| ShortNumber(radians.to_degrees()));
                write!(
                    f,
                    "the angle of {:#} radians ({own} degrees) is outside {:#} to {:#} radians ({from} to {to} degrees); degrees are written {{\"degrees\": 90}}",
                    ShortNumber(*angle),
                    ShortNumber(*min),
                    ShortNumber(*max)
                )
            }
            Self::CrossesAxis { piece, distance, .. } => write!(
                f,
                "piece {piece} of the profile meets the axis, or lies on another side of it than the pieces before (distance {}): cut it there, and turn one half, or each part for itself",
                ShortNumber(*distance)
            ),
            Self::ProfileOnAxis { distance, limit } => write!(
                f,
                "the profile lies along the axis and sweeps nothing: it is {} off it at most, and up to {} are on it",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::ProfileMeetsItself { first, second, radius, height } => write!(
                f,
                "the profile meets itself: pieces {first} and {second} at the distance {} from the axis, height {}; a solid needs a profile that goes round once",
                ShortNumber(*radius),
                ShortNumber(*height)
            ),
            Self::SectionNotPlane { contour, distance, limit } => write!(
                f,
                "contour {contour} of the section is up to {} off the plane of sections, limit {}",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::SectionMeetsItself { contour } => write!(
                f,
                "contour {contour} of the section meets itself or another contour, or encloses no area: a solid needs contours that go once round an area"
            ),
            Self::FoldedProfile { piece, distance } => write!(
                f,
                "piece {piece} of the profile turns back at the distance {} from the axis, in a plane across it: what it sweeps is folded; take an axis in the plane of the profile, or a profile with heights along the axis",
                ShortNumber(*distance)
            ),
            Self::NotAFace { face, detail } => write!(f, "face {face}: {detail}"),
            Self::NotClosed { first, second, forward, back } => {
                write!(
                    f,
                    "the faces do not close: {forward} of them run from point {first} to point {second} and {back} the other way, where one and one should"
                )?;
                // Two faces that share the edge, of which one is clockwise.
                if forward + back == 2 { f.write_str(": one of the two is to be turned over") } else { Ok(()) }
            }
            Self::NonPlanarFace { face, vertex, distance, limit } => write!(
                f,
                "face {face} is not planar: point {vertex} is {} off, limit {}",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::NotConvex { first, second, angle, reflex, edges } => write!(
                f,
                "not convex: {reflex} of {edges} edges are reflex, most of all that between the points {first} and {second}, by {} radians, limit 0{}",
                ShortNumber(-*angle),
                clockwise(*reflex, *edges)
            ),
            Self::NotInOpenHemisphere { side, measured, .. } => write!(
                f,
                "the corners are not in an open half of the sphere, counter-clockwise: {} round the middle by {} radians, {}",
                side.map_or("all sides run".to_owned(), |side| format!("side {side} runs")),
                ShortNumber(*measured),
                side.map_or("not by 2 pi", |_| "not between 0 and pi")
            ),
            Self::FlatPolyhedron { thickness, limit } => write!(
                f,
                "the points bound no body: all are within {} of one plane, and what is within {} of a plane is taken for it",
                ShortNumber(*thickness),
                ShortNumber(*limit)
            ),
            Self::BendDoesNotFit { corner, radius, needed, length } => write!(
                f,
                "the bend at point {corner} does not fit: with the radius {} and that of its neighbour the arcs take {} of a leg of length {}; take smaller radii or move the points apart",
                ShortNumber(*radius),
                at_least(*needed),
                ShortNumber(*length)
            ),
            Self::PipeTooWide { piece, radius, limit } => write!(
                f,
                "the pipe's radius {} is not below that of piece {piece} of its curve, {}: the inner side would fold; take a thinner pipe or wider bends",
                ShortNumber(*radius),
                ShortNumber(*limit)
            ),
            Self::CornerNotMitred { joint, turn, smooth, limit } if limit <= smooth => write!(
                f,
                "the tube's curve has a corner of {} rad before piece {joint}: tubes follow curves whose joints are smooth, up to {} rad; round it (polyline with radius), take a smooth curve, or a pipe, which has mitres",
                ShortNumber(*turn),
                ShortNumber(*smooth)
            ),
            Self::CornerNotMitred { joint, turn, smooth, limit } => write!(
                f,
                "the pipe's curve has a corner of {} rad before piece {joint}: only corners between segments are mitred, up to {} rad, and joints are smooth up to {} rad; round it (polyline with radius), or take a smooth curve",
                ShortNumber(*turn),
                ShortNumber(*limit),
                ShortNumber(*smooth)
            ),
            Self::MitreDoesNotFit { piece, needed, length } => write!(
                f,
                "segment {piece} of the pipe's curve has the length {}, its mitres need more than {}; take a thinner pipe or round the corners",
                ShortNumber(*length),
                ShortNumber(*needed)
            ),
            Self::PipeMeetsItself { first, second, point: [x, y, z], distance, limit } => write!(
                f,
                "the pipe meets itself at {}, {}, {}: parts {first} and {second} of it, of the arcs and segments along it, come as near as {} from center to center, and the sum of their radii is {}; {}",
                ShortNumber(*x),
                ShortNumber(*y),
                ShortNumber(*z),
                ShortNumber(*distance),
                ShortNumber(*limit),
                if *distance > CROSSING * limit {
                    "take a thinner pipe or move the curve apart"
                } else {
                    "they cross: move the curve apart"
                }
            ),
            Self::SeamTooWide { piece, point: [x, y, z], width, limit } => write!(
                f,
                "the seam is {} wide, and folds on the inner side of the bend of its curve at {}, {}, {}, in piece {piece}: it may be {} wide; take a narrower seam, or a curve that bends less along the torus",
                ShortNumber(*width),
                ShortNumber(*x),
                ShortNumber(*y),
                ShortNumber(*z),
                ShortNumber(*limit)
            ),
            Self::SeamMeetsItself { first, second, point: [x, y, z], distance, width } => write!(
                f,
                "the seam runs through itself at {}, {}, {}: pieces {first} and {second} of its curve are {} apart there, and it is {} wide; take a narrower seam, or a curve that keeps away from itself",
                ShortNumber(*x),
                ShortNumber(*y),
                ShortNumber(*z),
                ShortNumber(*distance),
                ShortNumber(*width)
            ),
            Self::ParameterOutOfRange { name, value, min, max } => {
                write!(f, "{name} = {:#} is {}", ShortNumber(*value), outside(*name, *value, [*min, *max]))
            }
            Self::NoG1SplineInTube { vertex, tolerance } => write!(
                f,
                "no G1 arc spline within {} of the polyline near vertex {vertex}: a larger tolerance, the target `polyline` where the edges are meant, a corner angle below the turn there, or smoothing first, where points are closer together than their noise",
                ShortNumber(*tolerance)
            ),
            Self::ArcLimitNotKept { vertex, name, value, limit } => write!(
                f,
                "no arcs within the tolerance keep `{name}` {}: at point {vertex} it takes {}; a larger tolerance, or a smaller limit",
                ShortNumber(*limit),
                ShortNumber::no_more(*value)
            ),
            Self::ToleranceNotReached { points, deviation, tolerance } => write!(
                f,
                "tolerance {} not reached: {} stay outside, up to {} away; a larger tolerance, or corners where the data turn sharply",
                ShortNumber(*tolerance),
                points_in_words(points),
                ShortNumber(*deviation)
            ),
            Self::NoiseNotSmoothed { points, deviation, noise } => write!(
                f,
                "no curve follows the points without their noise, whose standard deviation is about {}: it is up to {} from {}; take fewer points, \
                 farther apart than their noise, or give a tolerance",
                ShortNumber(*noise),
                ShortNumber(*deviation),
                points_in_words(points)
            ),
            Self::OutliersOutside { points, noise, tolerance } => {
                write!(
                    f,
                    "tolerance {} not reached because of {} outlier(s): ",
                    ShortNumber(*tolerance),
                    points.len()
                )?;
                for (k, (point, distance)) in points.iter().take(NAMED_OUTLIERS).enumerate() {
                    let before = if k == 0 { "" } else { ", " };
                    write!(f, "{before}point {point} ({} away)", ShortNumber(*distance))?;
                }
                if points.len() > NAMED_OUTLIERS {
                    write!(f, " and {} more", points.len() - NAMED_OUTLIERS)?;
                }
                write!(
                    f,
                    " from the curve of the other points, whose noise has a standard deviation of {}; leave them out with `--outliers drop` \
                     (in a document `\"outliers\": \"drop\"`), or use a larger tolerance",
                    ShortNumber(*noise)
                )
            }
            Self::Disconnected { piece, next, gap, limit } => write!(
                f,
                "pieces {piece} and {next} do not meet: gap {}, limit {}",
                ShortNumber(*gap),
                ShortNumber(*limit)
            ),
            Self::NotMobius { defect, limit } => write!(
                f,
                "the Möbius matrix does not preserve three-space: defect {}, limit {}",
                ShortNumber(*defect),
                ShortNumber(*limit)
            ),
            Self::NotASimilarity { .. } => f.write_str("the map is not a similarity"),
            Self::NoFrame { what, t, measured, limit } => write!(
                f,
                "there is no frame at the parameter {}: {what} is {}, more than {} is needed",
                ShortNumber(*t),
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::KnotsDecrease { index, knot, before } => {
                write!(f, "knot {index} is {knot}, less than the one before, {before}: knots must not decrease")
            }
            Self::KnotMultiplicity { index, multiplicity, limit } => write!(
                f,
                "the knot at {index} is there {multiplicity} times, {limit} at most: the curve would fall apart there"
            ),
            Self::NotASpline { detail } => write!(f, "not a spline: {detail}"),
            Self::WeightNotPositive { index, weight } => {
                write!(f, "weight {index} is {}: rational weights must be positive here", ShortNumber(*weight))
            }
            Self::WeightsUneven { first, second, ratio, limit } => write!(
                f,
                "weights {first} and {second} differ by a factor of {}, at most {}: double precision cannot resolve the curve between them; reduce \
                 the ratio (weights far above their neighbors pull the curve onto the control polygon: write that as segments)",
                ShortNumber(*ratio),
                ShortNumber(*limit)
            ),
            Self::FrameNotOrthonormal { measured, limit } => write!(
                f,
                "the directions of the frame are not perpendicular: the cosine between them is {}, limit {}",
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::NotConcircular { measured, limit } => write!(
                f,
                "the corners are not on one circle: off by {} of the size, limit {}",
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::CrossingQuad { position } => write!(
                f,
                "the sides cross: the corner opposite to the first is outside the arc between its neighbours (position {}, should be 0 to 1)",
                ShortNumber(*position)
            ),
            Self::NotInSpace { defect, limit } => write!(
                f,
                "the weights leave three-space: defect {} of the size, limit {}",
                ShortNumber(*defect),
                ShortNumber(*limit)
            ),
            Self::PatchThroughInfinity { s, t } => {
                write!(f, "the patch passes through infinity near s = {}, t = {}", ShortNumber(*s), ShortNumber(*t))
            }
            Self::NetDoesNotClose { direction, line, angle, stretch, limit } => write!(
                f,
                "the net does not close along {}: after one turn{} the frame is off by {} radians{}, limit {}",
                if *direction == 0 { 's' } else { 't' },
                along_pinned(*direction, *line),
                ShortNumber(*angle),
                speed_ratio(*stretch, *limit),
                ShortNumber(*limit)
            ),
            Self::AmbiguousFrame { measured, limit } => write!(
                f,
                "the edges of the net determine no frame: give one at the first vertex (their second direction stands out by {} of the first, limit {})",
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::CollapsedSide { side, cannot } => write!(f, "the side {side} of the net is one point: {cannot}"),
            Self::OffsetOnFocalSet { distance, measured, limit } => write!(
                f,
                "the offset at distance {} lies on the focal set: all centres of curvature of one family of lines are at that distance, and the surface shrinks to a curve or a point (lines keep {} of their speed, limit {})",
                ShortNumber(*distance),
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::OffsetNotRegular { distance, limit } if *limit == 0.0 => write!(
                f,
                "a solid between the surface and its offset at distance {} would run through itself: the surface itself is singular or folded there, limit 0",
                ShortNumber(*distance)
            ),
            Self::OffsetNotRegular { distance, limit } => write!(
                f,
                "a solid between the surface and its offset at distance {} would run through itself: a centre of curvature lies between them, or on one of them, limit {} (`report` gives the radii)",
                ShortNumber(*distance),
                ShortNumber(nearer(*limit))
            ),
            Self::NotAShell { item, index, detail } => write!(f, "not a shell: {item} {index}: {detail}"),
            Self::ShortEdge { edge, length, limit } => write!(
                f,
                "edge {edge} of the faces for a file is {} long, shorter than {}: the surface is too close to a singular one; move its points or its radii apart, or leave out the part that is so thin",
                ShortNumber(*length),
                ShortNumber(*limit)
            ),
            Self::InQuad { quad, cause } => write!(f, "quad {quad}: {cause}"),
            Self::CollapsedOnCurve { first, second } => write!(
                f,
                "vertices {first} and {second} fall together on the curve of their side: let it run along the whole side"
            ),
            Self::NotConverged { step, residual, limit } => write!(
                f,
                "not circular after {step} steps: the largest residual is {}, limit {}",
                ShortNumber(*residual),
                ShortNumber(*limit)
            ),
            Self::ShapeLost { change } => write!(f, "the shape is lost: {}", change.lost()),
            Self::BorderCurvesApart { vertex, distance, limit } => write!(
                f,
                "the curves of the two sides at vertex {vertex} do not meet near it: {} apart, limit {}",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::DegenerateTriangle { area, limit } => write!(
                f,
                "the corners of the triangle lie on one line: twice its area is {} of its longest edge squared, limit {}",
                ShortNumber(*area),
                ShortNumber(*limit)
            ),
            Self::ControlPointOnCircumcircle { corner, distance, limit } => write!(
                f,
                "control point {corner} lies on the circle through the corners: it is {} off it, relative to its distance, limit {}",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::OppositeSpheres { at, length, limit } => write!(
                f,
                "the spheres of the corners oppose each other near lambda = {}, {}: their blend has the length {}, limit {}",
                ShortNumber(at[0]),
                ShortNumber(at[1]),
                ShortNumber(*length),
                ShortNumber(*limit)
            ),
            Self::NormalAlongEdge { corner, across, limit } => write!(
                f,
                "the normal at corner {corner} runs along an edge or a line across its triangle: {} of that line is across the normal, limit {}",
                ShortNumber(*across),
                ShortNumber(*limit)
            ),
            Self::OppositeNormals { corner, length, limit } => write!(
                f,
                "the normals at the ends of the side opposite to corner {corner} oppose each other: between them {} is left, limit {}",
                ShortNumber(*length),
                ShortNumber(*limit)
            ),
            Self::UndefinedNormal { vertex, limit, .. } if *limit <= 0.0 => {
                write!(f, "vertex {vertex} has no normal: the one given for it is zero")
            }
            Self::UndefinedNormal { vertex, length, limit } => write!(
                f,
                "vertex {vertex} has no normal: those of its faces cancel, or the one given runs along its circle: the length {} is left, limit {}",
                ShortNumber(*length),
                ShortNumber(*limit)
            ),
            Self::NoTriangles { vertices, needed } => {
                write!(
                    f,
                    "the mesh has no triangles: {vertices} vertices and 0 triangles given, at least {needed} needed"
                )
            }
            Self::NoSuchVertex { triangle, vertex, count } => {
                write!(f, "triangle {triangle} names vertex {vertex}, but there are {count} vertices, counted from 0")
            }
            Self::NonManifoldEdge { vertices, triangle, count } => write!(
                f,
                "{count} triangles, among them triangle {triangle}, share the edge from vertex {} to vertex {}, at most 2 can",
                vertices[0], vertices[1]
            ),
            Self::InconsistentOrientation { vertices, triangles } => write!(
                f,
                "triangles {} and {} both run from vertex {} to vertex {}: one of them must be turned over, or left out if it is there twice",
                triangles[0], triangles[1], vertices[0], vertices[1]
            ),
            Self::CellsUnfit { fault, index } => f.write_str(&fault.words(*index)),
            Self::NotAQuadLayout { fault, index } => f.write_str(&fault.words(*index)),
            Self::RingDoesNotClose { vertex, angle, limit } => write!(
                f,
                "the frame that is carried round extraordinary vertex {vertex} comes back turned by {} rad more than quarter turns (at most {}): the net is not smooth round it",
                ShortNumber(*angle),
                ShortNumber(*limit)
            ),
            Self::NotASurface { fault, index } => {
                write!(f, "the mesh is not one piece of a surface with a border: {}", fault.words(*index))
            }
            Self::FlatSurface { difference, limit, noise: Some(noise) } => write!(
                f,
                "the surface is flat, or a sphere, but for noise of {}: its principal curvatures differ by {} (median), and more than {} is \
                 needed to tell lines of curvature from noise; smooth the mesh first, or take one with longer edges",
                ShortNumber(*noise),
                ShortNumber(*difference),
                ShortNumber(*limit)
            ),
            Self::FlatSurface { difference, limit, noise: None } => write!(
                f,
                "the surface is flat, or a sphere: its principal curvatures differ by {} (median), and more than {} is needed to tell \
                 lines of curvature; any grid of a plane or a sphere has circles as it is",
                ShortNumber(*difference),
                ShortNumber(*limit)
            ),
            Self::UmbilicsRemain { count, at, halves, smoothing } => write!(
                f,
                "{count} umbilic(s) are left after smoothing by {}, the first at {} (index {}): one grid has no room for them: take \"umbilics\": \"pieces\" or \"joined\" with \"border\": \"inside\" or \"staircase\", or cut a hole round them",
                ShortNumber(*smoothing),
                place(*at),
                index_of_halves(*halves)
            ),
            Self::UmbilicsNotJoined { at, fault } => write!(
                f,
                "no mesh of quads goes on through the umbilic at {}: {}; \"umbilics\": \"pieces\" lays grids beside it",
                place(*at),
                fault.words()
            ),
            Self::FieldNotOrientable { at, halves } => write!(
                f,
                "lines of curvature come back turned over after a way round the hole at {} (index {}): take \"umbilics\": \"pieces\"",
                place(*at),
                index_of_halves(*halves)
            ),
            Self::SpiralLines { shift, edge } => write!(
                f,
                "the lines of curvature are spirals, which come back {} higher or lower (an edge is {}): closing them gives the \
                 surface another shape; \"closed\": true closes them all the same, \"closed\": false leaves the grid open",
                ShortNumber(*shift),
                ShortNumber(*edge)
            ),
            Self::NoGrid { edge, least } => write!(
                f,
                "no grid of {least} by {least} cells with edges of {} finds room on the surface: take shorter edges",
                ShortNumber(*edge)
            ),
            Self::InBranch { branch, what, cause } => write!(f, "branch {branch}, {what}: {cause}"),
            Self::InTriangle { triangle, cause } => write!(f, "triangle {triangle}: {cause}"),
            Self::InSpan { span, cause } => write!(f, "span {span}: {cause}"),
            Self::NotARingTorus { major, minor } => write!(
                f,
                "no ring torus: the radius {} of the tube must be above 0 and below the radius {} of its middle",
                ShortNumber(*minor),
                ShortNumber(*major)
            ),
            Self::ZeroCoordinate { index } => write!(f, "complex coordinate {index} of a point of the torus is zero"),
            Self::PointOnAxis { index, distance, limit } => write!(
                f,
                "point {index} is on the axis of the torus, where no longitude is the nearest: distance {}, limit {}",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::PointOnCoreCircle { index, distance, limit } => write!(
                f,
                "point {index} is in the middle of the tube, where no side is the nearest: distance {}, limit {}",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::PointOffTorus { index, distance, limit } => {
                write!(f, "point {index} is {} off the torus, limit {}", ShortNumber(*distance), ShortNumber(*limit))
            }
            Self::NotMonotone { coordinate, step, slopes } => write!(
                f,
                "coordinate {coordinate} would have to turn back or stand still: step {}, slopes {} and {} at its ends",
                ShortNumber(*step),
                ShortNumber(slopes[0]),
                ShortNumber(slopes[1])
            ),
            Self::SpanTooLarge { coordinate, step, limit } => write!(
                f,
                "coordinate {coordinate} goes {} radians in one span, which must be below {}: put a point between",
                ShortNumber(*step),
                ShortNumber(*limit)
            ),
            Self::EmptyInterval { index, length, limit } => write!(
                f,
                "interval {index} of the parameter has the length {}, which must be above {}",
                ShortNumber(*length),
                ShortNumber(*limit)
            ),
            Self::NoTwoTypeSolution { segment, cosine } if cosine.abs() > 1.0 && cosine.is_finite() => write!(
                f,
                "no two pieces of these types join the ends of segment {segment}: the cosine of their middle would be {}, at most 1 is one",
                ShortNumber(*cosine)
            ),
            Self::NoTwoTypeSolution { segment, .. } => write!(
                f,
                "no two pieces of these types join the ends of segment {segment} in the directions given: on the way each coordinate of a type runs in one direction, that of its speeds at both ends"
            ),
            Self::NotCoprime { turns: [p, q], divisor } => write!(
                f,
                "{p} and {q} turns have the greatest common divisor {divisor}, not 1: the curve would run over itself, or not at all"
            ),
            Self::NotTimelikePair { measured, limit } => write!(
                f,
                "the balls that touch both surfaces form no torus: measured {}, limit {}",
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::DegeneratePair { measured, limit } => write!(
                f,
                "the two surfaces have a common tangent ball for an axis, or parallel or equal axes: measured {}, limit {}",
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::SphereAtInfinity { measured, limit } => write!(
                f,
                "the ball at this place is infinite: the product of sines is {}, which must be above {}",
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::WrongSide { surface, measured } => write!(
                f,
                "the ball touches surface {surface} from the wrong side: measured {}, which must be above 0",
                ShortNumber(*measured)
            ),
            Self::NoPositiveRadius { radius } => {
                write!(f, "the ball outside both surfaces would have the radius {}", ShortNumber(*radius))
            }
            Self::ParallelContact { measured, limit } => write!(
                f,
                "the tangent planes are so nearly parallel that no single ball touches both: measured {}, limit {}",
                ShortNumber(*measured),
                ShortNumber(*limit)
            ),
            Self::RadiusTooSmall { radius, limit } => write!(
                f,
                "a ball of radius {} cannot touch both cylinders: it must be above {}",
                ShortNumber(*radius),
                ShortNumber(*limit)
            ),
            Self::PlanesMissPoint { vertex, distance, limit } => write!(
                f,
                "with faces that are near to one plane made one, the surface is {} off at point {vertex}, limit {}",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::ZeroRotation { .. }
            | Self::NotARotation { .. }
            | Self::NotOnStudyQuadric { .. }
            | Self::WrongPoseCount { .. }
            | Self::ParametersNotIncreasing { .. }
            | Self::UnattainablePose { .. }
            | Self::MotionThroughExceptionalPoint { .. }
            | Self::RotationTooLarge { .. }
            | Self::NoCubicMotion { .. }
            | Self::StudyFormVanishes { .. }
            | Self::MotionNotRational
            | Self::MotionAtRest { .. }
            | Self::SpanWithoutWay { .. } => f.write_str(&of_motion(self)),
            Self::ConcircularCube { .. }
            | Self::CrossingFace { .. }
            | Self::VolumeThroughInfinity { .. }
            | Self::FoldedVolume { .. }
            | Self::InBlock { .. }
            | Self::InFaceOfVolume { .. } => f.write_str(&of_volume(self)),
        }
    }
}

/// The sentence and the reason: what a program prints whose `main` returns the error.
impl std::fmt::Debug for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self} [{}]", self.reason())
    }
}
