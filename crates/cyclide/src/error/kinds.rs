//! The reasons for which input is refused, in the order of the pages with their examples ([`reasons`](super::reasons)).

use super::{ErrorItem, FoldRemedy, GridCellFault, JoinFault, LayoutFault, SurfaceFault};
use crate::shape_change::ShapeChange;

/// Why a piece of input was refused: the item at fault, what was measured of it, and the limit that it broke.
///
/// A variant without a field for the limit names it in its sentence, where it could be no other: finite, positive, not zero,
/// not the same point. Or nothing is measured, because what is wrong is how things hang together (a loop that is no face, a side
/// that is one point, a curve that comes back to itself): the fields say where.
///
/// ```
/// use cyclide::{Arc, Error, Point3, Vec3};
/// let error = Arc::from_start_tangent(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Vec3::ZERO).unwrap_err();
/// assert_eq!((error.reason(), error.index()), ("zero-tangent", Some(0)));
/// assert_eq!(error, Error::ZeroTangent { index: 0 });
/// ```
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum Error {
    // Numbers, points, directions and lists as such; maps.
    /// A number of the input is NaN or infinite.
    NotFinite {
        /// The kind of item.
        what: ErrorItem,
        /// Which one, from 0.
        index: usize,
    },
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
    },
    /// Something so small and so far from the origin that the rounding of its coordinates is its shape.
    BelowRoundingOfPlace {
        /// The kind of thing.
        what: ErrorItem,
        /// Its size: the diagonal of the box of its points, or a radius.
        size: f64,
        /// Its largest coordinate.
        place: f64,
        /// Smallest size accepted there.
        limit: f64,
    },
    /// A tolerance is zero, negative or not a number.
    ToleranceNotPositive {
        /// The tolerance given.
        tolerance: f64,
    },
    /// Fewer points than the construction needs.
    TooFewPoints {
        /// Number of points given.
        given: usize,
        /// Number of points needed.
        needed: usize,
    },
    /// Two points that must differ are equal (or closer than the stated limit).
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
    /// There is not one of a list for each point or vertex.
    CountDiffers {
        /// What the list holds.
        what: ErrorItem,
        /// How many are given.
        given: usize,
        /// Number of points or vertices.
        needed: usize,
    },
    /// A tangent or direction vector is zero.
    ZeroTangent {
        /// Which tangent, from 0.
        index: usize,
    },
    /// A rotation axis, plane normal or direction is zero (or not usable in the plane asked for).
    ZeroAxis {
        /// What it is.
        what: ErrorItem,
        /// Which one, from 0.
        index: usize,
        /// Length of what is usable of it.
        length: f64,
        /// Lengths up to this are refused.
        limit: f64,
    },
    /// A weight quaternion is zero.
    ZeroWeight {
        /// Which weight, from 0.
        index: usize,
    },
    /// A rational weight that must be positive is not.
    WeightNotPositive {
        /// Which weight, from 0.
        index: usize,
        /// Its value.
        weight: f64,
    },
    /// Weights of a rational curve differ so much that its points cannot be distinguished by their parameters.
    WeightsUneven {
        /// One of the two weights, from 0.
        first: usize,
        /// The other one.
        second: usize,
        /// The larger over the smaller one.
        ratio: f64,
        /// The largest ratio accepted: 1e9 from one to the next, 1e18 over two steps, and 1e150 of any two.
        limit: f64,
    },
    /// A radius is zero relative to the position of its centre.
    ZeroRadius {
        /// The radius found.
        radius: f64,
        /// Radii up to this are refused.
        limit: f64,
    },
    /// A radius, length or tolerance that must be positive is not.
    RadiusNotPositive {
        /// The value given.
        radius: f64,
    },
    /// A cone has its apex before the last place where something of it is needed: its radius there would not be positive.
    ConeReachesApex {
        /// Where the apex is along its axis; within a wall, that of the bore.
        apex: f64,
        /// The place along its axis that it is needed as far as.
        reached: f64,
    },
    /// The factor of a similarity is zero, negative or not a number.
    ScaleNotPositive {
        /// The factor given.
        factor: f64,
    },
    /// The blend order is outside what is supported.
    OrderOutOfRange {
        /// The order asked for.
        order: u32,
        /// The largest order supported.
        max: u32,
    },
    /// A swept angle is outside its range.
    SweepOutOfRange {
        /// The angle given, radians.
        sweep: f64,
        /// Smallest angle accepted.
        min: f64,
        /// Largest angle accepted.
        max: f64,
    },
    /// A turn beyond what is asked for: more than a whole one, a whole one in one piece, or none where a body is to be made.
    AngleOutOfRange {
        /// The angle given, radians.
        angle: f64,
        /// Smallest angle accepted.
        min: f64,
        /// Largest angle accepted.
        max: f64,
    },
    /// A refinement would need more pieces than its cap on work and memory.
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
    /// Something goes to infinity, or so near it that its digits are lost: a third point on the line of the other two, outside the
    /// segment; a point that a map takes there.
    PointAtInfinity {
        /// What goes there.
        what: ErrorItem,
        /// Which one, from 0.
        index: usize,
        /// Its distance from the place that goes to infinity.
        distance: f64,
        /// Smallest distance accepted (0: only that place itself).
        limit: f64,
    },
    /// A matrix of quaternions does not map three-space to itself.
    NotMobius {
        /// Relative defect measured.
        defect: f64,
        /// Largest defect accepted.
        limit: f64,
    },
    /// A Möbius map that is not a similarity was given where only similarities keep the kind of curve.
    NotASimilarity {
        /// Length of the entry `c` of its matrix.
        measured: f64,
        /// Largest one accepted.
        limit: f64,
    },

    // Arcs, circles, splines and fits.
    /// The weight ratio is a negative real number: the arc would be the outer part of the chord's line.
    PoleOnSegment {
        /// Real part of the weight ratio.
        real: f64,
        /// Length of its vector part.
        vector: f64,
        /// Lengths up to this are refused.
        limit: f64,
    },
    /// An arc that turns by so nearly a full circle that its points would lose their digits.
    NearlyFullCircle {
        /// What it leaves of a full turn, radians.
        rest: f64,
        /// What it must leave at least, radians.
        limit: f64,
    },
    /// The weight's vector part is not perpendicular to the chord, so the arc would leave three-space.
    NotInImH {
        /// Cosine of the angle between the chord and the weight's vector part.
        cosine: f64,
        /// Largest cosine accepted.
        limit: f64,
    },
    /// The tangent points straight away from the other end, where only an infinite line would do, or so nearly that the arc
    /// runs out far beyond its chord.
    TangentOpposesChord {
        /// Which tangent (or piece of a curve), from 0.
        index: usize,
        /// Its angle with the way back along the chord, radians.
        angle: f64,
        /// Smallest angle accepted.
        limit: f64,
    },
    /// Three points on a line have no finite circle.
    DegenerateCircle {
        /// Sine of the angle at the middle point.
        sine: f64,
        /// Smallest sine accepted.
        limit: f64,
    },
    /// Four points in a plane have no finite sphere.
    DegenerateSphere {
        /// Volume relative to the product of the three edges.
        volume: f64,
        /// Smallest relative volume accepted.
        limit: f64,
    },
    /// No biarc with finite arcs joins the data.
    NoFiniteBiarc {
        /// What was measured.
        measured: &'static str,
        /// Its value.
        value: f64,
        /// The limit it broke.
        limit: f64,
    },
    /// The points turn back on themselves: there is no tangent to estimate.
    Cusp {
        /// The point, from 0.
        index: usize,
        /// Length of the sum of the two unit chords.
        measured: f64,
        /// Sums up to this are a cusp.
        limit: f64,
    },
    /// A circle of a blend is the chord's own line taken through infinity, or comes so near infinity that its points have lost
    /// their digits.
    ArcThroughInfinity {
        /// Which segment, from 0.
        segment: usize,
        /// How far the largest circle of the blend runs, in lengths of the chord; infinite where it is a line.
        reach: f64,
        /// How far it may run.
        limit: f64,
    },
    /// Opposite circles whose common tangent is the chord: no half-turn is preferred.
    AmbiguousHalfTurn {
        /// Which segment, from 0.
        segment: usize,
        /// Sine of the angle between the tangent and the chord.
        sine: f64,
        /// Smallest sine accepted.
        limit: f64,
    },
    /// Consecutive pieces of a path do not meet.
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
    /// A knot is less than the one before.
    KnotsDecrease {
        /// Which knot, from 0.
        index: usize,
        /// Its value.
        knot: f64,
        /// The knot before, which it must not be below.
        before: f64,
    },
    /// A knot is repeated so often that the curve falls apart there, or a control point counts for nothing.
    KnotMultiplicity {
        /// The first knot of that value, from 0.
        index: usize,
        /// How often it is there.
        multiplicity: usize,
        /// How often it may be there.
        limit: usize,
    },
    /// The knots, weights and points of a spline do not fit together.
    NotASpline {
        /// What does not fit.
        detail: &'static str,
    },
    /// A curve of degree n takes an odd number of conditions, `2n + 1`.
    EvenPointCount {
        /// Number of conditions given: points, and derivatives at them.
        given: usize,
    },
    /// Two points, or two poses, are asked for at one parameter.
    RepeatedParameter {
        /// Which of them, from 0.
        first: usize,
        /// The other one.
        second: usize,
        /// The parameter of the second; of the first too, or so near that it is the same on the scale of all.
        value: f64,
    },
    /// The only curve of the degree that fits the other points, at their parameters, misses these.
    UnattainablePoint {
        /// Which points, from 0, rising.
        points: Vec<usize>,
        /// What is left of the weight of the first one, relative to all, or its distance from the curve in sizes of the data.
        measured: f64,
        /// The weight must be above this, the distance below it.
        limit: f64,
    },
    /// A curve passes through infinity, or runs so far out that doubles do not tell.
    CurveThroughInfinity {
        /// Near which parameter.
        t: f64,
    },
    /// The circular arcs that leave two points along their tangents run in opposite directions: no direction is halfway.
    OppositeArcs {
        /// Length of the sum of their unit tangents at the start.
        measured: f64,
        /// Lengths below this are refused.
        limit: f64,
    },
    /// A part of a curve is not proved to be within the tolerance of its chord, however short.
    NotWithinTolerance {
        /// Which smooth piece, from 0.
        piece: usize,
        /// What is proved at the shortest chord.
        bound: f64,
        /// The tolerance asked for.
        tolerance: f64,
    },
    /// A frame does not exist at a place of a curve: what it would be made from vanishes there.
    NoFrame {
        /// What vanishes.
        what: &'static str,
        /// The place, a global parameter in `[0, 1]`.
        t: f64,
        /// Its size.
        measured: f64,
        /// Sizes up to this are refused.
        limit: f64,
    },
    /// No tangent-continuous arc spline stays within the tolerance of the polyline near this vertex.
    NoG1SplineInTube {
        /// Vertex of the input where the search died.
        vertex: usize,
        /// The tolerance.
        tolerance: f64,
    },
    /// Arcs within the tolerance were found, but none that keep a limit of the machine.
    ArcLimitNotKept {
        /// Point of the input where the arc is that misses the limit by most.
        vertex: usize,
        /// The limit: `min_radius` or `min_arc_length`.
        name: ErrorItem,
        /// What that arc has.
        value: f64,
        /// The limit's value.
        limit: f64,
    },
    /// No curve of the kind was found within the tolerance of these points.
    ToleranceNotReached {
        /// The points outside, in the user's numbering.
        points: Vec<usize>,
        /// Largest distance of one of them.
        deviation: f64,
        /// The tolerance.
        tolerance: f64,
    },

    /// A tolerance is not reached because of points that do not belong to the others.
    OutliersOutside {
        /// Each of them, in the user's numbering, and how far it is from the curve of the others.
        points: Vec<(usize, f64)>,
        /// Standard deviation of the noise of the others.
        noise: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// No curve follows the points without their noise.
    NoiseNotSmoothed {
        /// The points it leaves by too much, in the user's numbering.
        points: Vec<usize>,
        /// Largest distance of one of them, without its noise, from the curve.
        deviation: f64,
        /// Standard deviation of the noise.
        noise: f64,
    },

    // Patches, nets, their offsets and shells; quads made circular.
    /// The four corners of a quad are not on one circle (or line).
    NotConcircular {
        /// Distance of the last corner from the circle of the others, relative to the quad's size.
        measured: f64,
        /// Largest distance accepted.
        limit: f64,
    },
    /// The corners of a quad are on a circle but not in the order a0, a1, a3, a2.
    CrossingQuad {
        /// Position of the opposite corner on the inverted arc between its neighbours, outside `[0, 1]`.
        position: f64,
    },
    /// The directions of a frame, which may have any length but zero, are not perpendicular.
    FrameNotOrthonormal {
        /// Cosine of the angle between them; 1 where one of them is zero.
        measured: f64,
        /// Largest cosine accepted.
        limit: f64,
    },
    /// The weights do not put the surface into three-space.
    NotInSpace {
        /// Largest real part of the quotient, relative to the size.
        defect: f64,
        /// Largest defect accepted.
        limit: f64,
    },
    /// The patch contains the point at infinity.
    PatchThroughInfinity {
        /// First parameter.
        s: f64,
        /// Second parameter.
        t: f64,
    },
    /// The frame does not come back when it is carried once round a closed net.
    NetDoesNotClose {
        /// The closed direction: 0 for s, 1 for t.
        direction: usize,
        /// The row or column along it that is to blame, from 0, where it is one: it is pinned.
        line: Option<usize>,
        /// Angle of the rotation from the frame that left to the frame that came back, radians.
        angle: f64,
        /// Ratio of the parameter speeds on both sides of the seam, minus 1.
        stretch: f64,
        /// Largest angle and stretch accepted.
        limit: f64,
    },
    /// No frame fits the directions of the edges of a net better than all others.
    AmbiguousFrame {
        /// How much the second direction that the edges agree on stands out, relative to the first: 0 where there is one only.
        measured: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// A construction needs four real sides and met one that is a single point.
    CollapsedSide {
        /// The side: `s = 0`, `s = 1`, `t = 0` or `t = 1`.
        side: &'static str,
        /// What cannot be made.
        cannot: &'static str,
    },
    /// An offset that is no surface.
    OffsetOnFocalSet {
        /// Signed distance of the offset.
        distance: f64,
        /// Largest speed of a line of the family that shrinks, relative to what it is made of.
        measured: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// A solid between a surface and its offset would run through itself.
    OffsetNotRegular {
        /// Signed distance of the offset.
        distance: f64,
        /// Signed distance of the first centre of curvature on that side: less is accepted. 0 where the surface itself runs against
        /// its normal, or through a singular point.
        limit: f64,
    },
    /// Vertices, edges and faces do not make a shell.
    NotAShell {
        /// The kind of item: vertex, edge or face.
        item: ErrorItem,
        /// Which one, from 0.
        index: usize,
        /// What is wrong with it.
        detail: &'static str,
    },
    /// An edge that other programs would take for a point.
    ShortEdge {
        /// Which edge, from 0, after faces were cut.
        edge: usize,
        /// Distance of its ends.
        length: f64,
        /// Shortest length accepted.
        limit: f64,
    },
    /// The quads of a grid cannot be made circular.
    NotConverged {
        /// Steps made.
        step: usize,
        /// Largest residual of a quad (dimensionless).
        residual: f64,
        /// Largest residual accepted.
        limit: f64,
    },
    /// A grid made circular is no longer the surface that was given.
    ShapeLost {
        /// What was measured.
        change: Box<ShapeChange>,
    },
    /// Two neighbouring vertices of a side came to the same point of the curve it shall slide on.
    CollapsedOnCurve {
        /// The first vertex, s fastest.
        first: usize,
        /// The second vertex.
        second: usize,
    },
    /// Two curves on which the sides of a grid slide do not meet at the corner between them.
    BorderCurvesApart {
        /// The corner of the grid, s fastest.
        vertex: usize,
        /// Distance of the curves beside the corner.
        distance: f64,
        /// Curves at most this far apart meet.
        limit: f64,
    },

    // Revolutions, pipes, necks, bridges, surfaces between two curves, polyhedra.
    /// A profile meets the axis that it is to turn about, other than with its ends.
    CrossesAxis {
        /// Which piece, from 0.
        piece: usize,
        /// Its distance from the axis where that was found.
        distance: f64,
        /// Distances up to this are refused; a larger one is on another side of the axis.
        limit: f64,
    },
    /// All of a profile lies along the axis that it is to turn about, and sweeps nothing.
    ProfileOnAxis {
        /// The largest distance from the axis.
        distance: f64,
        /// Distances up to this are on the axis.
        limit: f64,
    },
    /// The meridian of a profile meets itself, and with it what it sweeps.
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
    /// A section leaves the plane that it should be in.
    SectionNotPlane {
        /// Which contour, from 0.
        contour: usize,
        /// Largest distance of a control point from the plane.
        distance: f64,
        /// Distances up to this are rounding.
        limit: f64,
    },
    /// The contours of a section meet themselves or each other, or go round no area.
    SectionMeetsItself {
        /// Which contour, from 0.
        contour: usize,
    },
    /// A profile in a plane across its axis that sweeps a part of the plane twice.
    FoldedProfile {
        /// Which piece, from 0.
        piece: usize,
        /// Where it turns back.
        distance: f64,
    },
    /// The legs of a corner are too short for its arc beside those of the neighbours, or turn back on each other.
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
    PipeTooWide {
        /// Which arc of the path, from 0.
        piece: usize,
        /// Radius of the pipe.
        radius: f64,
        /// Radius of the arc.
        limit: f64,
    },
    /// A corner of a pipe that no mitre joins: it is next to an arc, or turns back.
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
    MitreDoesNotFit {
        /// Which segment, from 0.
        piece: usize,
        /// Length that the mitres at both ends take.
        needed: f64,
        /// Length of the segment.
        length: f64,
    },
    /// Parts of a pipe that are no neighbours run into each other.
    PipeMeetsItself {
        /// Which piece of the arcs and segments along it, or which ball, from 0.
        first: usize,
        /// The other one; the same if it is an arc that comes round.
        second: usize,
        /// In the middle between both.
        point: [f64; 3],
        /// Distance of both.
        distance: f64,
        /// Twice the radius.
        limit: f64,
    },
    /// A seam along a curve of a torus is wider than a bend of the curve allows.
    SeamTooWide {
        /// Which piece of the curve, from 0.
        piece: usize,
        /// The place on it.
        point: [f64; 3],
        /// Width of the seam.
        width: f64,
        /// The largest that fits everywhere.
        limit: f64,
    },
    /// Parts of a seam along a curve of a torus that are no neighbours share space.
    SeamMeetsItself {
        /// Which piece of the curve, from 0.
        first: usize,
        /// The other one; the same if it comes round.
        second: usize,
        /// A point that both parts hold.
        point: [f64; 3],
        /// Distance of the curve from itself there.
        distance: f64,
        /// Width of the seam.
        width: f64,
    },
    /// What follows arcs and segments was given a curve of another kind.
    NotOfArcs {
        /// Kinds of curves that are.
        wanted: &'static str,
    },
    /// A ball that is to roll inside a pipe is as large as the pipe.
    BallDoesNotFit {
        /// Radius of the ball.
        radius: f64,
        /// The radius of the ball that touches the pipe all round: those that fit are smaller.
        limit: f64,
    },
    /// A solid with the neck of a ball larger than the bends of its way: its surface would run through itself.
    NeckFolds {
        /// Radius of the ball.
        radius: f64,
        /// Smallest radius of curvature of the way of its centre.
        limit: f64,
    },
    /// A plate that ends within what is to stand on it.
    PlateTooSmall {
        /// What it must reach beyond: neck or bore.
        what: ErrorItem,
        /// How far it reaches.
        reach: f64,
        /// How far it must.
        needed: f64,
    },
    /// One of two neighbouring balls of a tube holds the other.
    BallsNested {
        /// Which ball, from 0.
        first: usize,
        /// Its neighbour.
        second: usize,
        /// Distance of their centres.
        distance: f64,
        /// Difference of their radii.
        limit: f64,
    },
    /// No smooth tube goes on from a ball to its neighbours.
    TubeTurnsBack {
        /// Which ball, from 0.
        ball: usize,
    },
    /// Between two balls with positive radii that of a tube is none.
    TubeRadiusVanishes {
        /// Which piece, or ball from which it goes, from 0.
        piece: usize,
        /// The least radius.
        radius: f64,
    },
    /// A tube is wider than the bends of its way, or than the swings of its radius, allow.
    TubeFolds {
        /// Which piece of its spine, or which pair of balls, from 0.
        piece: usize,
        /// Where in it or in one of its arcs, 0 to 1.
        at: f64,
        /// Its width there on the inner side of the bend as part of what it would be on a straight way: not positive.
        left: f64,
    },
    /// The radius of a tube changes as fast as the way goes on: its balls hold each other.
    RadiusGrowsTooFast {
        /// Which piece of its spine, from 0.
        piece: usize,
        /// Change of the radius by the length of the way.
        rate: f64,
        /// It has to be below.
        limit: f64,
    },
    /// A closed tube begins with another radius than it ends with.
    RadiusNotClosed {
        /// Radius at the start.
        first: f64,
        /// Radius at the end.
        last: f64,
    },
    /// A branch of a tee reaches beyond the breadth of its main pipe, or up to it.
    TeeBranchTooWide {
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
    },
    /// The balls of the plainest blend of a tee are infinite in a crotch.
    TeeBlendTooLarge {
        /// Which branch, from 0.
        branch: usize,
        /// Radius of the ball at the flank.
        radius: f64,
        /// The radius at which that begins; not positive where no ball will do.
        limit: f64,
    },
    /// A branch as wide as its main pipe has a blend whose radius changes.
    TeeLawOnEqualPipes {
        /// Which branch, from 0.
        branch: usize,
        /// Two of its radii.
        radii: [f64; 2],
    },
    /// A pipe of a tee ends within a blend.
    TeePipeTooShort {
        /// The branch or the main pipe.
        what: ErrorItem,
        /// Which branch it is about, from 0.
        branch: usize,
        /// Where it ends.
        end: f64,
        /// Where it may end first.
        needed: f64,
    },
    /// The blend of a tee runs through itself.
    TeeBlendFolds {
        /// Which branch, from 0.
        branch: usize,
        /// Angle round the branch where that is.
        angle: f64,
        /// Its width there as part of what it would be on a straight way: not positive.
        left: f64,
        /// Of a wall without which it would not: its balls on the inner side are larger by that.
        wall: Option<f64>,
    },
    /// The contact of a blend with the main pipe of a tee turns back and forth.
    TeeHoleFolds {
        /// Which branch, from 0.
        branch: usize,
        /// Angle round the branch where that is.
        angle: f64,
    },
    /// The ends of a pipe are not in order.
    PipeEndsReversed {
        /// Which pipe, from 0; of a tee the main pipe.
        pipe: usize,
        /// The first end.
        start: f64,
        /// The second, which must be above it.
        end: f64,
    },
    /// The axes of a crossing are too near to each other.
    CrossingAxesTooNear {
        /// Their distance.
        distance: f64,
        /// What the radii differ, of cones where they are nearest: it must be above this.
        limit: f64,
    },
    /// A ball is too large for the edge of a crossing: of what both pipes have in common, or of one less the other.
    CrossingBallTooLarge {
        /// Its radius.
        radius: f64,
        /// Half of the room between the pipes where the common normal of their axes goes through: it must be below this.
        limit: f64,
    },
    /// Pipes of which one is to be cut by the other do not meet, or hardly.
    CrossingPipesApart {
        /// The distance of their axes.
        distance: f64,
        /// The sum of their radii less a thousandth of it: it must be below this.
        limit: f64,
    },
    /// A crossing of a pipe with a taper that is made of cylinders only.
    CrossingNeedsCylinders {
        /// What needs them: the side of the ball, or the law of its radius.
        what: ErrorItem,
        /// Which pipe has a taper, from 0.
        pipe: usize,
        /// The taper, in radians.
        taper: f64,
    },
    /// The centres of the balls of a blend are on no surface with a patch of its own: two pipes that pass each other have one, balls outside both or inside both.
    NoCenterSurface,
    /// A pipe of a crossing ends within the blend.
    CrossingPipeTooShort {
        /// Which pipe, from 0.
        pipe: usize,
        /// The end, as its place along the axis.
        end: f64,
        /// The place that it must be beyond.
        needed: f64,
    },
    /// The hole of a crossing goes too far round a pipe.
    CrossingHoleTooWide {
        /// Which pipe, from 0.
        pipe: usize,
        /// How far it goes to either side, in radians.
        angle: f64,
        /// The largest such angle.
        limit: f64,
    },
    /// The border of the hole of a crossing turns back, so that parts of its pipe would overlap.
    CrossingHoleTurnsBack {
        /// Which pipe, from 0.
        pipe: usize,
        /// Where, as a place along its axis.
        along: f64,
    },
    /// The blend of a crossing runs through itself.
    CrossingFolds {
        /// Where its ball is then, as an angle about the common normal of the axes from the first one.
        angle: f64,
        /// What is left of its width there, in parts of that on a straight way.
        left: f64,
        /// What helps.
        remedy: FoldRemedy,
        /// Whether it is that of an inner skin, below a wall.
        walled: bool,
    },
    /// At some angle round a tube no ball of the radius touches it and the plane or sphere that it is blended with; of a ring, all round.
    ContactLoopOpen {
        /// Whether it is a ring.
        ring: bool,
        /// The angle round the tube.
        angle: f64,
        /// What must be positive there: the rise of the tube's line over the plane, the square of half the distance between both such balls on it, or, inside, how far from the axis the centre of the ball is on the side of the contact.
        measured: f64,
    },
    /// The contact of the blend of a cone with a sphere turns back, so that the rest of the sphere would overlap.
    ContactLoopTurnsBack {
        /// The angle round the tube where that is.
        angle: f64,
    },
    /// The blend of a tube with a plane or a sphere runs through itself.
    ContactBlendFolds {
        /// The angle round the tube where that is.
        angle: f64,
        /// What is left of its width there, in parts of that on a straight way.
        left: f64,
    },
    /// A tube ends within its blend.
    ContactTubeTooShort {
        /// Its end, as the distance along its axis.
        end: f64,
        /// The distance that it must be beyond.
        needed: f64,
    },
    /// Two branches of a tee, or their blends, meet, or stand beside each other along the main pipe.
    TeeBranchesMeet {
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
    },
    /// Two branches of a tee, or their blends, run into each other or come too near, farther out than where they begin.
    TeeBranchesTooNear {
        /// The first branch, from 0.
        first: usize,
        /// The second.
        second: usize,
        /// Where that is, in the axes of the tee.
        point: [f64; 3],
        /// The distance that they need.
        needed: f64,
    },
    /// Two branches as wide as the main pipe of a tee stand beside each other, but not opposite.
    TeeEqualBranchesNotOpposite {
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
    },
    /// Two branches of a tee stand so that no lines along the main pipe part what is beside them.
    TeeNoFreeLine {
        /// The first branch, from 0.
        first: usize,
        /// The second.
        second: usize,
    },
    /// Two ellipses cross, between which there is no solid.
    EllipsesCross {
        /// Difference of the semi-axes along x, of the other sign than that along y.
        along_x: f64,
        /// Difference of the semi-axes along y.
        along_y: f64,
    },
    /// Two curves between which pieces are to be matched one by one do not have as many.
    PieceCountsDiffer {
        /// Pieces of the first curve.
        first: usize,
        /// Pieces of the second.
        second: usize,
    },
    /// Straight lines between two curves that cross each other, or run along both: the surface has no normal there.
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
    DegreeTooHigh {
        /// The degree needed.
        degree: usize,
        /// Largest degree made.
        limit: usize,
    },
    /// A loop of vertices is no face.
    NotAFace {
        /// Which face, from 0.
        face: usize,
        /// What is wrong with it.
        detail: &'static str,
    },
    /// An edge of a polyhedron without one face on each side.
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
    /// Points in one plane, which bound no body.
    FlatPolyhedron {
        /// How far they are from it, at most.
        thickness: f64,
        /// Largest distance that counts as being in it: the flatness, half of it where points that near are one, or rounding.
        limit: f64,
    },
    /// Directions that are not the corners of a convex polygon in an open half of the sphere.
    NotInOpenHemisphere {
        /// Which side, from 0; `None` for all together.
        side: Option<usize>,
        /// Its angle about the middle, radians, or that of all together; 0 where there is no middle.
        measured: f64,
        /// What the angle of one side must be above, and that of all together at most.
        limit: f64,
    },

    /// The planes of the sides of a polyhedron leave a given point, or have a corner that is far from the given faces.
    PlanesMissPoint {
        /// The point, or the given one that became the corner.
        vertex: usize,
        /// Its distance from the other surface.
        distance: f64,
        /// Largest distance accepted.
        limit: f64,
    },
    /// The arcs between two curves cross their neighbours: the surface has no normal there, and runs through itself beside it.
    ArcsCross {
        /// Which piece of the curves, from 0.
        piece: usize,
        /// Near which part of the piece, and of the arcs.
        at: [f64; 2],
    },
    /// The directions of arcs at neighbouring joints of a curve oppose each other: halfway between them there is none.
    OppositeTangents {
        /// The first one, from 0.
        first: usize,
        /// The next one; of closed curves the first of all again.
        second: usize,
        /// What is left of the longer one between them.
        length: f64,
        /// Parts up to this are refused.
        limit: f64,
    },
    // Triangles and meshes of them.
    /// The corners of a triangle lie on one line, or nearly.
    DegenerateTriangle {
        /// Twice the area, relative to the square of the longest edge.
        area: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// No sphere is told by a control point on the circle through the corners of its triangle.
    ControlPointOnCircumcircle {
        /// The corner whose sphere it is, from 0.
        corner: usize,
        /// How far it is off, relative to the circle and its distance.
        distance: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// Spheres that cancel each other where they are blended.
    OppositeSpheres {
        /// The first two barycentric coordinates of the place.
        at: [f64; 2],
        /// Length of the blended sphere, 1 where all agree.
        length: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// A normal along the edge that shall be perpendicular to it.
    NormalAlongEdge {
        /// The corner of the triangle, from 0.
        corner: usize,
        /// The part of the line across the normal, relative to it.
        across: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// The normals at the ends of an edge cancel each other between them.
    OppositeNormals {
        /// The corner of the triangle, from 0.
        corner: usize,
        /// Length of the blended normal across the edge.
        length: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// The faces around a vertex lie back to back.
    UndefinedNormal {
        /// Which vertex, from 0.
        vertex: usize,
        /// Length of the weighted mean of the normals of its faces, or of the normal given.
        length: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// A mesh without a triangle.
    NoTriangles {
        /// Number of vertices, of which none has a face.
        vertices: usize,
        /// Number of triangles needed.
        needed: usize,
    },
    /// A triangle names a vertex that does not exist.
    NoSuchVertex {
        /// Which triangle, from 0.
        triangle: usize,
        /// The index it names.
        vertex: usize,
        /// Number of vertices.
        count: usize,
    },
    /// More than two triangles share an edge.
    NonManifoldEdge {
        /// Ends of the edge, the lower index first.
        vertices: [usize; 2],
        /// The first of the triangles, from 0.
        triangle: usize,
        /// How many there are.
        count: usize,
    },
    /// Two neighbouring triangles are seen from different sides.
    InconsistentOrientation {
        /// Start and end of the edge.
        vertices: [usize; 2],
        /// The triangles, from 0.
        triangles: [usize; 2],
    },
    /// The cells of a grid are no part of it that can be made, or something needs all of them.
    CellsUnfit {
        /// What is wrong.
        fault: GridCellFault,
        /// A quad where it is, s fastest, from 0.
        index: usize,
    },
    /// The quads of a mesh make no regular grids that join round its extraordinary vertices.
    NotAQuadLayout {
        /// What is wrong.
        fault: LayoutFault,
        /// The quad or vertex where it is, from 0.
        index: usize,
    },
    /// A frame that is carried round an extraordinary vertex comes back turned by more than quarter turns.
    RingDoesNotClose {
        /// The vertex of the mesh.
        vertex: usize,
        /// By so much more, radians.
        angle: f64,
        /// The largest angle that is accepted.
        limit: f64,
    },
    /// Triangles are not one piece of a surface with a border.
    NotASurface {
        /// What is wrong.
        fault: SurfaceFault,
        /// A triangle where it is, from 0.
        index: usize,
    },
    /// A surface has no lines of curvature: it is a plane or a sphere.
    FlatSurface {
        /// Median difference of the principal curvatures.
        difference: f64,
        /// Least difference that shows directions.
        limit: f64,
        /// The distance of the vertices from a smooth surface, where noise alone makes that difference.
        noise: Option<f64>,
    },
    /// However much the directions are smoothed, umbilics are left.
    UmbilicsRemain {
        /// How many.
        count: usize,
        /// Where the first is.
        at: [f64; 3],
        /// How many half turns the lines of curvature make round it.
        halves: i32,
        /// The smoothing that was tried last with so few left.
        smoothing: f64,
    },
    /// One mesh of quads does not go through an umbilic.
    UmbilicsNotJoined {
        /// Where it is.
        at: [f64; 3],
        /// What stands against it.
        fault: JoinFault,
    },
    /// Lines of curvature come back turned over after a way round a hole: no coordinates follow them all round.
    FieldNotOrientable {
        /// A place on the border of the hole.
        at: [f64; 3],
        /// How many half turns the lines make round in the hole.
        halves: i32,
    },
    /// The lines of curvature of a tube come back so much higher that closing them would be a shape of its own.
    SpiralLines {
        /// By how much they come back higher.
        shift: f64,
        /// Length of an edge of the grid, the limit.
        edge: f64,
    },
    /// No grid finds room on a surface.
    NoGrid {
        /// Length of its edges.
        edge: f64,
        /// Cells along each side at least.
        least: usize,
    },

    // Tori and curves on them.
    /// A torus whose tube is not thinner than the circle that its middle follows.
    NotARingTorus {
        /// Radius of the middle of the tube.
        major: f64,
        /// Radius of the tube: must be above 0 and below the other.
        minor: f64,
    },
    /// A complex coordinate of a point of a torus is zero.
    ZeroCoordinate {
        /// Which of the four, from 0.
        index: usize,
    },
    /// A point on the axis of a torus: every longitude is equally near.
    PointOnAxis {
        /// Which point, from 0.
        index: usize,
        /// Its distance from the axis.
        distance: f64,
        /// Distances up to this are refused.
        limit: f64,
    },
    /// A point on the circle along the middle of the tube of a torus: its whole meridian is equally near.
    PointOnCoreCircle {
        /// Which point, from 0.
        index: usize,
        /// Its distance from the circle.
        distance: f64,
        /// Distances up to this are refused.
        limit: f64,
    },
    /// A point that should lie on a torus does not.
    PointOffTorus {
        /// Which point, from 0.
        index: usize,
        /// Its distance from the torus.
        distance: f64,
        /// Largest distance accepted.
        limit: f64,
    },
    /// A coordinate that can run in one direction only is asked to turn back, or to stand still at an end of a step.
    NotMonotone {
        /// Which of the two coordinates, from 0.
        coordinate: usize,
        /// The step over the span, radians.
        step: f64,
        /// The slopes at its ends, by the parameter of the curve.
        slopes: [f64; 2],
    },
    /// A coordinate is asked to go farther than half round within one span.
    SpanTooLarge {
        /// Which of the two coordinates, from 0.
        coordinate: usize,
        /// The step, radians.
        step: f64,
        /// Steps must be below this.
        limit: f64,
    },
    /// An interval of a curve's parameter without length, or with one that is lost beside the whole: knots that repeat or go back.
    EmptyInterval {
        /// Which interval, from 0.
        index: usize,
        /// Its length.
        length: f64,
        /// It must be above this.
        limit: f64,
    },
    /// No two pieces of the given types join the ends of a segment.
    NoTwoTypeSolution {
        /// Which segment, from 0.
        segment: usize,
        /// The number whose arc cosine the middle needs; within 1, or infinite, where no solution runs in the directions given.
        cosine: f64,
    },
    /// Turns about the axis and about the middle of the tube that have a common divisor: the curve would cover itself.
    NotCoprime {
        /// The turns.
        turns: [i32; 2],
        /// Their greatest common divisor; 0 if both are 0.
        divisor: u32,
    },
    // Rolling balls and canal surfaces.
    /// Two cylinders or cones whose common tangent balls have no torus: their pair is spacelike, or on the border.
    NotTimelikePair {
        /// Of two skew cylinders the distance of the axes, of a general pair the norm ratio of its common form.
        measured: f64,
        /// The distance must be above this, the ratio below it.
        limit: f64,
    },
    /// Two surfaces whose axes meet or are parallel in the space of balls: their tangent balls form no single surface.
    DegeneratePair {
        /// Norm ratio of the common form, or the smallest pivot of the forms where there are several.
        measured: f64,
        /// Values of this size or below are refused.
        limit: f64,
    },
    /// A place on the border of the balls between two cylinders, where they are infinite.
    SphereAtInfinity {
        /// The product of sines that vanishes there.
        measured: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// A ball that touches a surface from the wrong side, or its other nappe.
    WrongSide {
        /// Which surface, from 0; 0 where it is both.
        surface: usize,
        /// What must be positive: the product of sines of a place, or the distance from the axis.
        measured: f64,
    },
    /// A ball whose radius is not positive where one outside is asked for.
    NoPositiveRadius {
        /// The radius found.
        radius: f64,
    },
    /// A contact whose ball lies between parallel planes, so that none or any touches both.
    ParallelContact {
        /// What vanishes there: 1 less the cosine between the normals, or the distance that the radius is divided by.
        measured: f64,
        /// Values up to this are refused.
        limit: f64,
    },
    /// A ball too small to touch both cylinders.
    RadiusTooSmall {
        /// The radius given.
        radius: f64,
        /// It must be above this.
        limit: f64,
    },
    // Displacements and motions.
    /// A rotation quaternion is zero.
    ZeroRotation {
        /// Which rotation, from 0.
        index: usize,
    },
    /// A matrix that should be a displacement is none: its columns are not orthonormal and right-handed, or its last row is not `0 0 0 1`.
    NotARotation {
        /// Largest deviation of a length, a scalar product, the determinant or an entry of the last row.
        off: f64,
        /// Deviations above this are refused.
        limit: f64,
    },
    /// A dual quaternion is no displacement: its parts are not perpendicular.
    NotOnStudyQuadric {
        /// `|p·r| / (|p| |r|)`.
        product: f64,
        /// Products above this are refused.
        limit: f64,
    },
    /// A motion needs another number of poses.
    WrongPoseCount {
        /// Number of poses given.
        given: usize,
        /// Number of poses needed.
        needed: usize,
        /// True if more will do.
        or_more: bool,
    },
    /// A pose is not after the one before it in time.
    ParametersNotIncreasing {
        /// Which parameter, from 0.
        index: usize,
        /// Its value.
        value: f64,
        /// The value before it.
        before: f64,
    },
    /// No motion of this kind takes a pose at its time together with the others.
    UnattainablePose {
        /// Which pose, from 0.
        index: usize,
        /// The factor of the pose against the largest, below the limit; or by how much the pose is missed, above it.
        share: f64,
        /// The limit.
        limit: f64,
    },
    /// On its way a motion comes to where a dual quaternion is no displacement: the body would go through infinity.
    MotionThroughExceptionalPoint {
        /// When.
        time: f64,
        /// The share `|p|²/(|p|² + |r|²)` there, with lengths in units of the size of the poses.
        share: f64,
        /// What is left of the dual quaternion there, squared, against the sum of the lengths of what it is summed of: 0 where both of its parts
        /// vanish.
        remainder: f64,
        /// Shares and remainders up to this are refused.
        limit: f64,
    },
    /// Between two poses the rotation is so large that its direction is lost.
    RotationTooLarge {
        /// Which span, from 0.
        span: usize,
        /// Smallest length of the quaternion on the way.
        length: f64,
        /// Lengths up to this are refused.
        limit: f64,
    },
    /// No motion of degree 3 takes the four poses one after the other (at the cross-ratio asked for).
    NoCubicMotion {
        /// Discriminant of the equation of the cross-ratio; negative: there is none.
        discriminant: f64,
        /// The cross-ratios at which there are motions; those between 0 and 1 take the poses one after the other.
        roots: Vec<f64>,
    },
    /// Poses are planar, spherical or translated against each other: what should follow from how they screw is not determined.
    StudyFormVanishes {
        /// Largest value of the Study form between two poses, over their size.
        measured: f64,
        /// Values up to this are zero.
        limit: f64,
    },
    /// What needs a rational motion is asked of one that is not: the points of a screw motion run on helices.
    MotionNotRational,
    /// A time law by the way of a point is asked of a motion that does not move it.
    MotionAtRest {
        /// Length of the whole way.
        length: f64,
        /// Lengths up to this are refused.
        limit: f64,
    },
    /// A time law by the way of a point, or times by it, have no time for a span on which the body turns on the spot, or rests.
    SpanWithoutWay {
        /// Which span, from 0.
        span: usize,
        /// By how much the body turns there, radians.
        turn: f64,
        /// Length of the way.
        length: f64,
        /// Lengths up to this are refused.
        limit: f64,
    },
    // Volumes.
    /// The first corner of a spherical cube and its three neighbours are on one circle: the eighth corner is not determined.
    ConcircularCube {
        /// Twice the area of the triangle of the neighbours, inverted at the first corner.
        measured: f64,
        /// Areas up to this are zero.
        limit: f64,
    },
    /// A face of a volume crosses itself: one of its sides runs backwards.
    CrossingFace {
        /// Direction of the side: 0, 1, 2 for s, t, u.
        axis: usize,
        /// Where it is: its places in the two other directions, in order, each 0 or 1.
        at: [f64; 2],
        /// Speed of the side, a length.
        speed: f64,
        /// Speeds are above this.
        limit: f64,
    },
    /// A volume contains the point at infinity.
    VolumeThroughInfinity {
        /// Where: s, t, u.
        at: [f64; 3],
    },
    /// Lines of a volume run backwards in a part of it, where that is asked for which must not.
    FoldedVolume {
        /// Where: s, t, u.
        at: [f64; 3],
    },
    // What failed in a part of the input.
    /// One block of a grid failed; the cause says why.
    InBlock {
        /// Which block, from 0, s fastest, then t.
        block: usize,
        /// What went wrong in it.
        cause: Box<Error>,
    },
    /// One face of a volume failed; the cause says why.
    InFaceOfVolume {
        /// The direction across the face: 0, 1, 2 for s, t, u.
        axis: usize,
        /// Its place in this direction: 0 or 1.
        end: usize,
        /// What went wrong in it.
        cause: Box<Error>,
    },
    /// One quad of a net failed; the cause says why.
    InQuad {
        /// Which quad, from 0, s fastest.
        quad: usize,
        /// What went wrong in it.
        cause: Box<Error>,
    },
    /// A number of one branch of a tee failed; the cause says why.
    InBranch {
        /// Which branch, from 0.
        branch: usize,
        /// Which of its numbers.
        what: ErrorItem,
        /// What went wrong with it.
        cause: Box<Error>,
    },
    /// One triangle of a mesh failed; the cause says why.
    InTriangle {
        /// Which triangle, from 0.
        triangle: usize,
        /// What went wrong in it.
        cause: Box<Error>,
    },
    /// One span of a chain failed; the cause says why.
    InSpan {
        /// Which span, from 0.
        span: usize,
        /// What went wrong in it.
        cause: Box<Error>,
    },
}
