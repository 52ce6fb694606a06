//! The one error type of the kernel.
//!
//! Every variant says which item is at fault, what was measured and the limit it broke. [`Error::reason`] gives
//! the stable kebab-case name that the reference data, the reports and the documentation use.

mod reason;
mod words;

use crate::shape_change::ShapeChange;
use crate::short_number::ShortNumber;
use words::{at_least, clockwise, numbered, outside, points_in_words, size_in_place, speed_ratio};

/// Result of a fallible kernel call.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Why a piece of input was refused.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A number of the input is NaN or infinite.
    #[error("{what} {index} is not a finite number")]
    NotFinite {
        /// The kind of item: `point`, `tangent`, `weight`, …
        what: &'static str,
        /// Which one, from 0.
        index: usize,
    },
    /// Two points that must differ are equal (or closer than the stated limit).
    #[error(
        "points {first} and {second} coincide (distance {}, at most {} is allowed to be called equal)", ShortNumber(*.distance), ShortNumber(*.limit)
    )]
    CoincidentPoints {
        /// Index of the first point.
        first: usize,
        /// Index of the second point.
        second: usize,
        /// Their distance.
        distance: f64,
        /// Distances up to this count as equal (0: only equal doubles).
        limit: f64,
    },
    /// Fewer points than the construction needs.
    #[error("too few points: {given} given, at least {needed} needed")]
    TooFewPoints {
        /// Number of points given.
        given: usize,
        /// Number of points needed.
        needed: usize,
    },
    /// A weight quaternion is zero.
    #[error("weight {index} is zero")]
    ZeroWeight {
        /// Which weight, from 0.
        index: usize,
    },
    /// The weight ratio is a negative real number: the arc would be the outer part of the chord's line.
    #[error("the arc passes through infinity: its weight ratio has real part {} and vector part {}", ShortNumber(*.real), ShortNumber(*.vector))]
    PoleOnSegment {
        /// Real part of the weight ratio.
        real: f64,
        /// Length of its vector part.
        vector: f64,
    },
    /// An arc that turns by so nearly a full circle that its points would lose their digits.
    #[error(
        "the arc turns by a full circle less {} radians, limit {}: its ends nearly coincide; take a circle, or two arcs",
        ShortNumber(*.rest), ShortNumber(*.limit)
    )]
    NearlyFullCircle {
        /// What it leaves of a full turn, radians.
        rest: f64,
        /// What it must leave at least, radians.
        limit: f64,
    },
    /// The weight's vector part is not perpendicular to the chord, so the arc would leave three-space.
    #[error("the weight takes the arc out of three-space: cosine {} between chord and weight, limit {}", ShortNumber(*.cosine), ShortNumber(*.limit))]
    NotInImH {
        /// Cosine of the angle between the chord and the weight's vector part.
        cosine: f64,
        /// Largest cosine accepted.
        limit: f64,
    },
    /// A tangent or direction vector is zero.
    #[error("tangent {index} is zero")]
    ZeroTangent {
        /// Which tangent, from 0.
        index: usize,
    },
    /// The tangent points straight away from the other end: only an infinite line would do.
    #[error("tangent {index} points away from the chord: the arc would pass through infinity")]
    TangentOpposesChord {
        /// Which tangent (or arc of a chain), from 0.
        index: usize,
    },
    /// The tangent points so nearly away from the other end that the arc runs out far beyond its chord.
    #[error(
        "tangent {index} points away from the chord but for {} radians, where {} are needed: the arcs there would run out nearly to infinity",
        ShortNumber(*.angle), ShortNumber(*.limit)
    )]
    TangentNearlyOpposesChord {
        /// Which tangent (or piece of a curve), from 0.
        index: usize,
        /// Its angle with the way back along the chord, radians.
        angle: f64,
        /// Smallest angle accepted.
        limit: f64,
    },
    /// The third point lies on the line of the other two, outside the segment; or a point maps to infinity.
    #[error("a point is at infinity: it lies on the line through the ends outside the segment, or maps there")]
    PointAtInfinity,
    /// A curve comes so near the point that goes to infinity that its image would have lost its digits.
    #[error(
        "the curve comes within {} of the point that goes to infinity, where its image loses its digits (at least {} is needed there); move that point, the centre of an inversion, away from the curve",
        ShortNumber(*.distance), ShortNumber(*.limit)
    )]
    NearPole {
        /// Distance of the curve from that point.
        distance: f64,
        /// Smallest distance accepted.
        limit: f64,
    },
    /// No biarc with finite arcs joins the data.
    #[error("no finite biarc: {measured} is {}, limit {}", ShortNumber(*.value), ShortNumber(*.limit))]
    NoFiniteBiarc {
        /// What was measured.
        measured: &'static str,
        /// Its value.
        value: f64,
        /// The limit it broke.
        limit: f64,
    },
    /// The points turn back on themselves: there is no tangent to estimate.
    #[error("cusp at point {index}: the unit chords sum to {}, limit {}; split the points there", ShortNumber(*.measured), ShortNumber(*.limit))]
    Cusp {
        /// The point, from 0.
        index: usize,
        /// Length of the sum of the two unit chords.
        measured: f64,
        /// Sums up to this are a cusp.
        limit: f64,
    },
    /// There is not one tangent per point.
    #[error("{given} tangents given for {needed} points")]
    TangentCount {
        /// Number of tangents given.
        given: usize,
        /// Number of points.
        needed: usize,
    },
    /// There is not one radius per point.
    #[error("{given} radii given for {needed} points")]
    RadiusCount {
        /// Number of radii given.
        given: usize,
        /// Number of points.
        needed: usize,
    },
    /// What follows arcs and segments was given a curve of another kind.
    #[error(
        "the curve is not made of arcs and segments: give the tolerance within which arcs may replace it, or take a curve of arcs ({wanted})"
    )]
    NotOfArcs {
        /// Kinds of curves that are.
        wanted: &'static str,
    },
    /// A rotation axis or plane normal is zero (or not usable in the plane asked for).
    #[error("the axis is zero")]
    ZeroAxis,
    /// A radius is zero relative to the position of its centre.
    #[error("the radius {} is zero", ShortNumber(*.radius))]
    ZeroRadius {
        /// The radius found.
        radius: f64,
    },
    /// The factor of a similarity is zero, negative or not a number.
    #[error("the scale factor {} is not positive", ShortNumber(*.factor))]
    ScaleNotPositive {
        /// The factor given.
        factor: f64,
    },
    /// A radius, length or tolerance that must be positive is not.
    #[error("the radius {} is not positive", ShortNumber(*.radius))]
    RadiusNotPositive {
        /// The value given.
        radius: f64,
    },
    /// A ball that is to roll inside a pipe is as large as the pipe.
    #[error("a ball of radius {} does not fit into the pipe: its radius must be below {}", ShortNumber(*.radius), ShortNumber(*.limit))]
    BallDoesNotFit {
        /// Radius of the ball.
        radius: f64,
        /// Radius of the pipe.
        limit: f64,
    },
    /// A solid with the neck of a ball larger than the bends of its way: its surface would run through itself.
    #[error(
        "the neck runs through itself on the side to which the pipe leans and bounds no solid: a ball of radius {} rolls through bends of radius {}; take a smaller ball",
        ShortNumber(*.radius), ShortNumber(*.limit)
    )]
    NeckFolds {
        /// Radius of the ball.
        radius: f64,
        /// Smallest radius of curvature of the way of its centre.
        limit: f64,
    },
    /// A plate that ends within what is to stand on it.
    #[error("the plate is too small: it reaches {} from the axis of the pipe, the {what} {}", ShortNumber(*.reach), ShortNumber(*.needed))]
    PlateTooSmall {
        /// What it must reach beyond: `neck` or `bore`.
        what: &'static str,
        /// How far it reaches.
        reach: f64,
        /// How far it must.
        needed: f64,
    },
    /// Two ellipses cross, between which there is no solid.
    #[error(
        "the ellipses cross: the second is wider by {} along x and by {} along y; a solid needs one inside the other",
        ShortNumber(*.along_x), ShortNumber(*.along_y)
    )]
    EllipsesCross {
        /// Difference of the semi-axes along x.
        along_x: f64,
        /// The same along y.
        along_y: f64,
    },
    /// Two curves between which pieces are to be matched one by one do not have as many.
    #[error("the first curve has {first} piece(s), the second {second}: pieces are joined one by one, in their order")]
    PieceCountsDiffer {
        /// Pieces of the first curve.
        first: usize,
        /// Pieces of the second.
        second: usize,
    },
    /// Straight lines between two curves that cross each other, or run along both: the surface has no normal there.
    #[error(
        "the straight lines between piece {piece} of both curves cross, or lie in one line: at {} of the piece and {} of the way between them the surface has no normal (of its length {} is left, limit {}); does the second curve run the other way?",
        ShortNumber(.at[0]), ShortNumber(.at[1]), ShortNumber(*.normal), ShortNumber(*.limit)
    )]
    RulingsCross {
        /// Which piece, from 0.
        piece: usize,
        /// The parameter of the piece, and the part of the way from the first curve to the second.
        at: [f64; 2],
        /// Length of the normal there, relative to what it could have.
        normal: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// A surface of so high a degree that no program would read it.
    #[error(
        "the surface would have the degree {degree}, limit {limit}: take curves of lower degrees (segments have 1, arcs 2, fair splines 4)"
    )]
    DegreeTooHigh {
        /// The degree needed.
        degree: usize,
        /// Largest degree made.
        limit: usize,
    },
    /// Three points on a line have no finite circle.
    #[error("the points lie on a line: sine of their angle {}, limit {}", ShortNumber(*.sine), ShortNumber(*.limit))]
    DegenerateCircle {
        /// Sine of the angle at the middle point.
        sine: f64,
        /// Smallest sine accepted.
        limit: f64,
    },
    /// Four points in a plane have no finite sphere.
    #[error("the points lie in a plane: relative volume {}, limit {}", ShortNumber(*.volume), ShortNumber(*.limit))]
    DegenerateSphere {
        /// Volume relative to the product of the three edges.
        volume: f64,
        /// Smallest relative volume accepted.
        limit: f64,
    },
    /// The blend order is outside what is supported.
    #[error("blend order {order} is outside 1 to {max}")]
    OrderOutOfRange {
        /// The order asked for.
        order: u32,
        /// The largest order supported.
        max: u32,
    },
    /// A circle of a blend is the chord's own line taken through infinity.
    #[error("segment {segment}: a start tangent opposes the chord, the blend would pass through infinity")]
    ArcThroughInfinity {
        /// Which segment, from 0.
        segment: usize,
    },
    /// A blend comes so near infinity that its points have lost their digits: no file can hold it.
    #[error(
        "segment {segment}: the curve runs out to {} times the distance of its two points and loses its digits there (at most {} times is written); make the turn there less sharp, or add a point",
        ShortNumber(*.reach), ShortNumber(*.limit)
    )]
    ArcNearInfinity {
        /// Which segment, from 0.
        segment: usize,
        /// How far the largest circle of the blend runs, in lengths of the chord.
        reach: f64,
        /// How far it may run.
        limit: f64,
    },
    /// Opposite circles whose common tangent is the chord: no half-turn is preferred.
    #[error("segment {segment}: opposite circles along the chord, the half-turn between them is ambiguous")]
    AmbiguousHalfTurn {
        /// Which segment, from 0.
        segment: usize,
    },
    /// A refinement would need more pieces than its cap on work and memory.
    #[error("{what}{} needs {} pieces, at most {cap} are made: {remedy}", numbered(*.segment), at_least(*.needed))]
    TooManyPieces {
        /// What would grow.
        what: &'static str,
        /// Which segment or piece of a curve, from 0; `None` where the whole is meant.
        segment: Option<usize>,
        /// Pieces needed, as far as counted.
        needed: f64,
        /// Largest number of pieces made.
        cap: usize,
        /// What to ask for instead.
        remedy: &'static str,
    },
    /// Something so small and so far from the origin that the rounding of its coordinates is its shape.
    #[error(
        "{what} is {} at coordinates of up to {}, which are rounded: below {} it has no shape of its own; move it to the origin",
        size_in_place(*.size), ShortNumber(*.place), ShortNumber(*.limit)
    )]
    BelowRoundingOfPlace {
        /// The kind of thing.
        what: &'static str,
        /// Its size: the diagonal of the box of its points, or a radius.
        size: f64,
        /// Its largest coordinate.
        place: f64,
        /// Smallest size accepted there.
        limit: f64,
    },
    /// A part of a curve is not proved to be within the tolerance of its chord, however short.
    #[error(
        "piece {piece}: the curve is not proved to be within {} of a polyline, only within {}; use a larger tolerance",
        ShortNumber(*.tolerance), ShortNumber(*.bound)
    )]
    NotWithinTolerance {
        /// Which smooth piece, from 0.
        piece: usize,
        /// What is proved at the shortest chord.
        bound: f64,
        /// The tolerance asked for.
        tolerance: f64,
    },
    /// A tolerance is zero, negative or not a number.
    #[error("the tolerance {} is not positive", ShortNumber(*.tolerance))]
    ToleranceNotPositive {
        /// The tolerance given.
        tolerance: f64,
    },
    /// A swept angle is outside its range.
    #[error(
        "the swept angle {:#} is outside {:#} to {:#} radians",
        ShortNumber(*.sweep), ShortNumber(*.min), ShortNumber(*.max)
    )]
    SweepOutOfRange {
        /// The angle given, radians.
        sweep: f64,
        /// Smallest angle accepted.
        min: f64,
        /// Largest angle accepted.
        max: f64,
    },
    /// A turn beyond what is asked for: more than a whole one, a whole one in one piece, or none where a body is to be made.
    #[error(
        "the angle {:#} is 0 or outside {:#} to {:#} radians; degrees are written {{\"degrees\": 90}}",
        ShortNumber(*.angle), ShortNumber(*.min), ShortNumber(*.max)
    )]
    AngleOutOfRange {
        /// The angle given, radians.
        angle: f64,
        /// Smallest angle accepted.
        min: f64,
        /// Largest angle accepted.
        max: f64,
    },
    /// A profile meets the axis that it is to turn about, other than with its ends.
    #[error(
        "piece {piece} of the profile meets the axis, or lies on another side of it than the pieces before (distance {}): cut it there and turn one half",
        ShortNumber(*.distance)
    )]
    CrossesAxis {
        /// Which piece, from 0.
        piece: usize,
        /// Its distance from the axis where that was found.
        distance: f64,
    },
    /// The meridian of a profile meets itself, and with it what it sweeps.
    #[error(
        "the profile meets itself: pieces {first} and {second} at the distance {} from the axis, height {}; a solid needs a profile that goes round once",
        ShortNumber(*.radius), ShortNumber(*.height)
    )]
    ProfileMeetsItself {
        /// Which piece, from 0.
        first: usize,
        /// The other one; the same if it comes back to itself.
        second: usize,
        /// Distance from the axis near the place.
        radius: f64,
        /// Height along the axis, from its given point.
        height: f64,
    },
    /// A profile in a plane across its axis that sweeps a part of the plane twice.
    #[error(
        "piece {piece} of the profile turns back at the distance {} from the axis, in a plane across it: what it sweeps is folded; take an axis in the plane of the profile, or a profile with heights along the axis",
        ShortNumber(*.distance)
    )]
    FoldedProfile {
        /// Which piece, from 0.
        piece: usize,
        /// Where it turns back.
        distance: f64,
    },
    /// A loop of vertices is no face.
    #[error("face {face}: {detail}")]
    NotAFace {
        /// Which face, from 0.
        face: usize,
        /// What is wrong with it.
        detail: &'static str,
    },
    /// An edge of a polyhedron without one face on each side.
    #[error(
        "the faces do not close: {forward} of them run from point {first} to point {second} and {back} the other way, where one and one should"
    )]
    NotClosed {
        /// Start of the edge.
        first: usize,
        /// Its end.
        second: usize,
        /// Faces along it in this direction.
        forward: usize,
        /// Faces along it in the other direction.
        back: usize,
    },
    /// A corner of a face of a polyhedron is off its plane.
    #[error(
        "face {face} is not planar: point {vertex} is {} off, limit {}", ShortNumber(*.distance), ShortNumber(*.limit)
    )]
    NonPlanarFace {
        /// Which face, from 0.
        face: usize,
        /// The point that is farthest off.
        vertex: usize,
        /// Its distance.
        distance: f64,
        /// Largest distance accepted.
        limit: f64,
    },
    /// A polyhedron with an edge at which its faces turn towards each other.
    #[error(
        "not convex: {reflex} of {edges} edges are reflex, most of all that between the points {first} and {second}, by {} radians, limit 0{}",
        ShortNumber(-*.angle), clockwise(*.reflex, *.edges)
    )]
    NotConvex {
        /// Start of the edge that is reflex most of all.
        first: usize,
        /// Its end.
        second: usize,
        /// The angle between its normals, radians: not positive.
        angle: f64,
        /// How many edges are reflex.
        reflex: usize,
        /// How many there are.
        edges: usize,
    },
    /// Directions that are not the corners of a convex polygon in an open half of the sphere.
    #[error(
        "the corners are not in an open half of the sphere, counter-clockwise: {} round the middle by {} radians, {}",
        .side.map_or("all sides run".to_owned(), |side| format!("side {side} runs")),
        ShortNumber(*.measured),
        .side.map_or("not by 2 pi", |_| "not between 0 and pi")
    )]
    NotInOpenHemisphere {
        /// Which side, from 0; `None` for all together.
        side: Option<usize>,
        /// Its angle about the middle, radians, or that of all together; 0 where there is no middle.
        measured: f64,
    },
    /// Points that bound no body.
    #[error("the points are in one plane, within {}, limit {}", ShortNumber(*.thickness), ShortNumber(*.limit))]
    FlatPolyhedron {
        /// How far they are from it.
        thickness: f64,
        /// Largest distance that counts as being in it.
        limit: f64,
    },
    /// The legs of a corner are too short for its arc beside those of the neighbours, or turn back on each other.
    #[error(
        "the bend at point {corner} does not fit: with the radius {} and that of its neighbour the arcs take {} of a leg of length {}; take smaller radii or move the points apart",
        ShortNumber(*.radius), at_least(*.needed), ShortNumber(*.length)
    )]
    BendDoesNotFit {
        /// Index of the point.
        corner: usize,
        /// Radius asked for.
        radius: f64,
        /// How much of the leg the arcs at both ends take.
        needed: f64,
        /// Length of the leg.
        length: f64,
    },
    /// A pipe is as wide as an arc that it follows.
    #[error(
        "the pipe's radius {} is not below that of piece {piece} of its curve, {}: the inner side would fold; take a thinner pipe or wider bends",
        ShortNumber(*.radius), ShortNumber(*.limit)
    )]
    PipeTooWide {
        /// Which arc of the path, from 0.
        piece: usize,
        /// Radius of the pipe.
        radius: f64,
        /// Radius of the arc.
        limit: f64,
    },
    /// A corner of a pipe that no mitre joins: it is next to an arc, or turns back.
    #[error(
        "the pipe's curve has a corner of {} rad before piece {joint}: only corners between segments are mitred, up to {} rad, and joints are smooth up to {} rad; round it (polyline with radius), or take a smooth curve",
        ShortNumber(*.turn), ShortNumber(*.limit), ShortNumber(*.smooth)
    )]
    CornerNotMitred {
        /// Which piece begins there, from 0.
        joint: usize,
        /// Its turn, radians.
        turn: f64,
        /// Joints up to here are smooth.
        smooth: f64,
        /// Corners of segments up to here are mitred.
        limit: f64,
    },
    /// A segment of a pipe is shorter than its mitres need.
    #[error(
        "segment {piece} of the pipe's curve has the length {}, its mitres need more than {}; take a thinner pipe or round the corners",
        ShortNumber(*.length), ShortNumber(*.needed)
    )]
    MitreDoesNotFit {
        /// Which segment, from 0.
        piece: usize,
        /// Length that the mitres at both ends take.
        needed: f64,
        /// Length of the segment.
        length: f64,
    },
    /// Parts of a pipe that are no neighbours run into each other.
    #[error(
        "the pipe meets itself: pieces {first} and {second} of its curve come as near as {}, twice the radius is {}; take a thinner pipe or move the curve apart",
        ShortNumber(*.distance), ShortNumber(*.limit)
    )]
    PipeMeetsItself {
        /// Which piece, from 0.
        first: usize,
        /// The other one; the same if it is an arc that comes round.
        second: usize,
        /// Distance of both.
        distance: f64,
        /// Twice the radius.
        limit: f64,
    },
    /// A parameter is outside its interval.
    #[error(
        "{name} = {:#} is {}",
        ShortNumber(*.value), outside(*.min, *.max)
    )]
    ParameterOutOfRange {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Smallest value accepted.
        min: f64,
        /// Largest value accepted; `f64::MAX` for no upper limit.
        max: f64,
    },
    /// No tangent-continuous arc spline stays within the tolerance of the polyline near this vertex.
    #[error("no G1 arc spline within {} of the polyline near vertex {vertex}", ShortNumber(*.tolerance))]
    NoG1SplineInTube {
        /// Vertex of the input where the search died.
        vertex: usize,
        /// The tolerance.
        tolerance: f64,
    },
    /// No curve of the kind was found within the tolerance of these points.
    #[error(
        "tolerance {} not reached: {} stay outside, up to {} away; a larger tolerance, or corners where the data turn sharply",
        ShortNumber(*.tolerance), points_in_words(.points), ShortNumber(*.deviation)
    )]
    ToleranceNotReached {
        /// The points outside, in the user's numbering.
        points: Vec<usize>,
        /// Largest distance of one of them.
        deviation: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// Data that must lie in one plane do not.
    #[error("the points are not in one plane: point {index} is {} off, limit {}", ShortNumber(*.distance), ShortNumber(*.limit))]
    NotPlanar {
        /// The point farthest from the plane.
        index: usize,
        /// Its distance from the plane.
        distance: f64,
        /// Largest distance accepted.
        limit: f64,
    },
    /// Consecutive pieces of a path do not meet.
    #[error("pieces {piece} and {next} do not meet: gap {}, limit {}", ShortNumber(*.gap), ShortNumber(*.limit))]
    Disconnected {
        /// The piece that ends.
        piece: usize,
        /// The piece that should start there.
        next: usize,
        /// Distance between the two ends.
        gap: f64,
        /// Largest gap accepted.
        limit: f64,
    },
    /// A matrix of quaternions does not map three-space to itself.
    #[error("the Möbius matrix does not preserve three-space: defect {}, limit {}", ShortNumber(*.defect), ShortNumber(*.limit))]
    NotMobius {
        /// Relative defect measured.
        defect: f64,
        /// Largest defect accepted.
        limit: f64,
    },
    /// A Möbius map that is not a similarity was given where only similarities keep the kind of curve.
    #[error("the map is not a similarity")]
    NotASimilarity,
    /// The knots, weights and points of a spline do not fit together.
    #[error("not a spline: {detail}")]
    NotASpline {
        /// What does not fit.
        detail: &'static str,
    },
    /// A rational weight that must be positive is not.
    #[error("weight {index} is {}: rational weights must be positive here", ShortNumber(*.weight))]
    WeightNotPositive {
        /// Which weight, from 0.
        index: usize,
        /// Its value.
        weight: f64,
    },
    /// A frame that must be orthonormal is not.
    #[error("the frame is not orthonormal: lengths or cosine off by {}, limit {}", ShortNumber(*.measured), ShortNumber(*.limit))]
    FrameNotOrthonormal {
        /// Largest deviation of a length from 1 or of the cosine from 0.
        measured: f64,
        /// Largest deviation accepted.
        limit: f64,
    },
    /// The four corners of a quad are not on one circle (or line).
    #[error("the corners are not on one circle: off by {} of the size, limit {}", ShortNumber(*.measured), ShortNumber(*.limit))]
    NotConcircular {
        /// Distance of the last corner from the circle of the others, relative to the quad's size.
        measured: f64,
        /// Largest distance accepted.
        limit: f64,
    },
    /// The corners of a quad are on a circle but not in the order a0, a1, a3, a2.
    #[error(
        "the sides cross: the corner opposite to the first is outside the arc between its neighbours (position {}, should be 0 to 1)",
        ShortNumber(*.position)
    )]
    CrossingQuad {
        /// Position of the opposite corner on the inverted arc between its neighbours.
        position: f64,
    },
    /// The weights do not put the surface into three-space.
    #[error("the weights leave three-space: defect {} of the size, limit {}", ShortNumber(*.defect), ShortNumber(*.limit))]
    NotInSpace {
        /// Largest real part of the quotient, relative to the size.
        defect: f64,
        /// Largest defect accepted.
        limit: f64,
    },
    /// The patch contains the point at infinity.
    #[error("the patch passes through infinity near s = {}, t = {}", ShortNumber(*.s), ShortNumber(*.t))]
    PatchThroughInfinity {
        /// First parameter.
        s: f64,
        /// Second parameter.
        t: f64,
    },
    /// The frame does not come back when it is carried once round a closed net.
    #[error(
        "the net does not close along {direction}: after one turn the frame is off by {} radians{}, limit {}", ShortNumber(*.angle), speed_ratio(*.stretch, *.limit), ShortNumber(*.limit)
    )]
    NetDoesNotClose {
        /// The closed direction: `s` or `t`.
        direction: &'static str,
        /// Angle of the rotation from the frame that left to the frame that came back, radians.
        angle: f64,
        /// Ratio of the parameter speeds on both sides of the seam, minus 1.
        stretch: f64,
        /// Largest angle and stretch accepted.
        limit: f64,
    },
    /// No frame fits the directions of the edges of a net better than all others.
    #[error("the edges of the net determine no frame: give one at the first vertex")]
    AmbiguousFrame,
    /// A construction needs four real sides and met one that is a single point.
    #[error("the side {side} of the net is one point: {cannot}")]
    CollapsedSide {
        /// The side: `s = 0`, `s = 1`, `t = 0` or `t = 1`.
        side: &'static str,
        /// What cannot be made.
        cannot: &'static str,
    },
    /// An offset that is no surface.
    #[error(
        "the offset at distance {} lies on the focal set: all centres of curvature of one family of lines are at that distance, and the surface shrinks to a curve or a point",
        ShortNumber(*.distance)
    )]
    OffsetOnFocalSet {
        /// Signed distance of the offset.
        distance: f64,
    },
    /// A solid between a surface and its offset would run through itself.
    #[error(
        "a solid between the surface and its offset at distance {} would run through itself: a centre of curvature lies between them, or on one of them (`report` gives the radii)",
        ShortNumber(*.distance)
    )]
    OffsetNotRegular {
        /// Signed distance of the offset.
        distance: f64,
    },
    /// Vertices, edges and faces do not make a shell.
    #[error("not a shell: {item} {index}: {detail}")]
    NotAShell {
        /// The kind of item: `vertex`, `edge`, `face`.
        item: &'static str,
        /// Which one, from 0.
        index: usize,
        /// What is wrong with it.
        detail: &'static str,
    },
    /// An edge that other programs would take for a point.
    #[error(
        "edge {edge} of the faces for a file is {} long, shorter than {}: the surface is too close to a singular one; move its points or its radii apart, or leave out the part that is so thin",
        ShortNumber(*.length), ShortNumber(*.limit)
    )]
    ShortEdge {
        /// Which edge, from 0, after faces were cut.
        edge: usize,
        /// Distance of its ends.
        length: f64,
        /// Shortest length accepted.
        limit: f64,
    },
    /// One quad of a net failed; the cause says why.
    #[error("quad {quad}: {cause}")]
    InQuad {
        /// Which quad, from 0, s fastest.
        quad: usize,
        /// What went wrong in it.
        cause: Box<Error>,
    },
    /// Two neighbouring vertices of a side came to the same point of the curve it shall slide on.
    #[error("vertices {first} and {second} fall together on the curve of their side: let it run along the whole side")]
    CollapsedOnCurve {
        /// The first vertex, s fastest.
        first: usize,
        /// The second vertex.
        second: usize,
    },
    /// The quads of a grid cannot be made circular.
    #[error("not circular after {step} steps: the largest residual is {}, limit {}", ShortNumber(*.residual), ShortNumber(*.limit))]
    NotConverged {
        /// Steps made.
        step: usize,
        /// Largest residual of a quad (dimensionless).
        residual: f64,
        /// Largest residual accepted.
        limit: f64,
    },
    /// A grid made circular is no longer the surface that was given.
    #[error("the shape is lost: {}", .change.lost())]
    ShapeLost {
        /// What was measured.
        change: Box<ShapeChange>,
    },
    /// Two curves on which the sides of a grid slide do not meet at the corner between them.
    #[error("the curves of the two sides at vertex {vertex} do not meet near it: {} apart, limit {}", ShortNumber(*.distance), ShortNumber(*.limit))]
    BorderCurvesApart {
        /// The corner of the grid, s fastest.
        vertex: usize,
        /// Distance of the curves beside the corner.
        distance: f64,
        /// Curves at most this far apart meet.
        limit: f64,
    },
    /// The corners of a triangle lie on one line, or nearly.
    #[error("the corners of the triangle lie on one line: twice its area is {} of its longest edge squared, limit {}", ShortNumber(*.area), ShortNumber(*.limit))]
    DegenerateTriangle {
        /// Twice the area, relative to the square of the longest edge.
        area: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// No sphere is told by a control point on the circle through the corners of its triangle.
    #[error("control point {corner} lies on the circle through the corners: it is {} off it, relative to its distance, limit {}", ShortNumber(*.distance), ShortNumber(*.limit))]
    ControlPointOnCircumcircle {
        /// The corner whose sphere it is, from 0.
        corner: usize,
        /// How far it is off, relative to the circle and its distance.
        distance: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// Spheres that cancel each other where they are blended.
    #[error("the spheres of the corners oppose each other near lambda = {}, {}: their blend has the length {}, limit {}", ShortNumber(.at[0]), ShortNumber(.at[1]), ShortNumber(*.length), ShortNumber(*.limit))]
    OppositeSpheres {
        /// The first two barycentric coordinates of the place.
        at: [f64; 2],
        /// Length of the blended sphere, 1 where all agree.
        length: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// A normal along the edge that shall be perpendicular to it.
    #[error("the normal at corner {corner} runs along an edge or a line across its triangle: {} of that line is across the normal, limit {}", ShortNumber(*.across), ShortNumber(*.limit))]
    NormalAlongEdge {
        /// The corner of the triangle, from 0.
        corner: usize,
        /// The part of the line across the normal, relative to it.
        across: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// The normals at the ends of an edge cancel each other between them.
    #[error("the normals at the ends of the side opposite to corner {corner} oppose each other: between them {} is left, limit {}", ShortNumber(*.length), ShortNumber(*.limit))]
    OppositeNormals {
        /// The corner of the triangle, from 0.
        corner: usize,
        /// Length of the blended normal across the edge.
        length: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// The faces around a vertex lie back to back.
    #[error("vertex {vertex} has no normal: those of its faces cancel to the length {}, limit {}", ShortNumber(*.length), ShortNumber(*.limit))]
    UndefinedNormal {
        /// Which vertex, from 0.
        vertex: usize,
        /// Length of the weighted mean of the normals of its faces, or of the normal given.
        length: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// Not as many normals as vertices.
    #[error("{given} normals given, one for each of {needed} vertices needed")]
    NormalCount {
        /// Number of normals given.
        given: usize,
        /// Number of vertices.
        needed: usize,
    },
    /// A mesh without a triangle.
    #[error("the mesh has no triangles")]
    NoTriangles,
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names vertex {vertex}, but there are {count} vertices, counted from 0")]
    NoSuchVertex {
        /// Which triangle, from 0.
        triangle: usize,
        /// The index it names.
        vertex: usize,
        /// Number of vertices.
        count: usize,
    },
    /// More than two triangles share an edge.
    #[error("{count} triangles, among them triangle {triangle}, share the edge from vertex {} to vertex {}, at most 2 can", .vertices[0], .vertices[1])]
    NonManifoldEdge {
        /// Ends of the edge, the lower index first.
        vertices: [usize; 2],
        /// The first of the triangles, from 0.
        triangle: usize,
        /// How many there are.
        count: usize,
    },
    /// Two neighbouring triangles are seen from different sides.
    #[error("triangles {} and {} both run from vertex {} to vertex {}: one of them must be turned over", .triangles[0], .triangles[1], .vertices[0], .vertices[1])]
    InconsistentOrientation {
        /// Start and end of the edge.
        vertices: [usize; 2],
        /// The triangles, from 0.
        triangles: [usize; 2],
    },
    /// One triangle of a mesh failed; the cause says why.
    #[error("triangle {triangle}: {cause}")]
    InTriangle {
        /// Which triangle, from 0.
        triangle: usize,
        /// What went wrong in it.
        cause: Box<Error>,
    },
    /// One span of a chain failed; the cause says why.
    #[error("span {span}: {cause}")]
    InSpan {
        /// Which span, from 0.
        span: usize,
        /// What went wrong in it.
        cause: Box<Error>,
    },
}

/// Refuses a tolerance that is not a positive number.
///
/// # Errors
/// `tolerance-not-positive` (also for NaN), `not-finite` (infinite).
pub(crate) fn check_tolerance(tolerance: f64) -> Result<()> {
    if tolerance.is_nan() || tolerance <= 0.0 {
        return Err(Error::ToleranceNotPositive { tolerance });
    }
    if tolerance.is_finite() { Ok(()) } else { Err(Error::NotFinite { what: "tolerance", index: 0 }) }
}

/// The sentence and the reason: what a program prints whose `main` returns the error.
impl std::fmt::Debug for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self} [{}]", self.reason())
    }
}
