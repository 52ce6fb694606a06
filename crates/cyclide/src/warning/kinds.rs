//! The list of warnings: what each is about, what was measured, and above which limit it is said.

use super::{InvertedCause, SpikeRemedy, SwingPart, WaverRemedy};
use crate::shape_change::ShapeChange;

/// A remark on a result that is valid but may not be what was meant.
///
/// ```
/// use cyclide::{CircleSpline, CircleSplineOptions, Point3, Warning};
/// let back = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
/// let spline = CircleSpline::from_points(&back, &CircleSplineOptions::default())?;
/// assert_eq!(spline.warnings()[0], Warning::Cusp { node: 1 });
/// assert_eq!(spline.warnings()[0].reason(), "cusp");
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The curve turns back on itself at a node: one-sided tangents, the joint is only connected (G0).
    Cusp {
        /// Index of the point.
        node: usize,
    },
    /// A turn close to half a turn: the circle through the node is very large.
    SharpTurn {
        /// Index of the point.
        node: usize,
        /// Turn at the point, radians.
        angle: f64,
        /// Turns above this are reported, radians.
        limit: f64,
    },
    /// A turn close to half a turn, where a smooth curve would swing out: cut, both sides end there (G0).
    SharpTurnCut {
        /// Index of the point.
        node: usize,
        /// Turn at the point, radians.
        angle: f64,
        /// Turns above this are cut, radians.
        limit: f64,
    },
    /// Segments of a fair spline that are less fair than asked for, because the fairest curve does not exist or swings out
    /// far there; its curvature is continuous all the same.
    Relaxed {
        /// Segments, from 0, rising, each with its blend: 1 is the fairest, 0 follows its neighbours alone.
        segments: Vec<(usize, f64)>,
    },
    /// The blend takes the long way round between its two circles.
    LongWay {
        /// Segment, from 0; it starts at the point of the same index.
        segment: usize,
    },
    /// The two circles of a segment run in opposite directions: a small change of the data moves the curve a lot.
    OppositeCircles {
        /// Segment, from 0.
        segment: usize,
    },
    /// Chords are so short against their coordinates that these, rounded to doubles, do not tell their directions.
    RoundedDirections {
        /// The first of the segments, from 0.
        segment: usize,
        /// How many there are.
        count: usize,
        /// How well the worst of their directions is known, radians.
        angle: f64,
        /// Values above this are reported, radians.
        limit: f64,
    },
    /// Neighbouring chords differ much in length, which makes interpolating curves bulge.
    UnevenSpacing {
        /// Index of the point between the two chords.
        node: usize,
        /// Longer over shorter chord.
        ratio: f64,
        /// Ratios above this are reported.
        limit: f64,
    },
    /// A curve through a point hardly reaches it: it runs there and back in a needle of the parameter.
    SpikeNearPoint {
        /// Index of the point.
        point: usize,
        /// Width of the needle in parts of the parameter's range.
        width: f64,
        /// Widths below this are reported.
        limit: f64,
    },
    /// A curve through points runs far away from them in between.
    LargeExcursion {
        /// Its largest distance from the middle of the points, in sizes of theirs.
        reach: f64,
        /// The parameter there.
        t: f64,
        /// Values above this are reported.
        limit: f64,
    },
    /// A curve through points turns right back between two of them: they are nearly on a curve of lower degree, along which it runs to and fro.
    TurnsBack {
        /// The parameter of the first place, from 0 to 1.
        t: f64,
        /// How many such places there are.
        count: usize,
        /// How long the curve is on which it turns, at most, in spacings of the points.
        within: f64,
        /// Lengths up to this are reported.
        limit: f64,
    },
    /// The motion gets very fast within a span: a body on a motion of least degree runs near infinity there, or turns over in a moment.
    SpeedSpike {
        /// The span, from 0.
        span: usize,
        /// The time from the start of the motion.
        time: f64,
        /// How many times as fast as on average over the span.
        ratio: f64,
        /// True of the angular speed, false of the speed of the tool.
        turning: bool,
        /// Ratios above this are reported.
        limit: f64,
        /// What helps.
        remedy: SpikeRemedy,
    },
    /// Under a law that goes by the way a body turns on a span with little way, which takes little time.
    TurnsNearlyInPlace {
        /// The span, from 0.
        span: usize,
        /// By how much it turns there, radians.
        turn: f64,
        /// How long that takes.
        seconds: f64,
        /// How many times as fast as on average over the motion.
        ratio: f64,
        /// Ratios above this are reported.
        limit: f64,
    },
    /// Under a law that goes by the way a body does not rest between poses that are the same.
    RestsPassedOver {
        /// The first such span, from 0.
        span: usize,
        /// How many there are.
        count: usize,
    },
    /// Under a law that goes by the way a body runs on at its speed where the way turns back.
    MotionReverses {
        /// The first such span, from 0.
        span: usize,
        /// When, from the start of the motion.
        time: f64,
        /// How many such places there are.
        count: usize,
        /// By how much the velocity of the tool jumps there.
        velocity_jump: f64,
    },
    /// A spline motion starts or ends a span much faster than it goes there on average: it runs beyond the poses and back in between.
    MotionSwings {
        /// The span where it is most so, from 0.
        span: usize,
        /// How many spans there are of which that is true.
        count: usize,
        /// How many times as fast; infinite where the poses are one.
        ratio: f64,
        /// Of which part that is true.
        part: SwingPart,
        /// How far it runs beyond the poses there: a length, or radians of a turn.
        beyond: f64,
        /// Ratios above this are reported.
        limit: f64,
    },
    /// Turns carry the origin of a spline motion away from the straight lines between its poses, as on an arc about the axis of a turn, by more than
    /// its places do by themselves.
    LeavesChords {
        /// The span where it gets farthest away, from 0.
        span: usize,
        /// How many spans there are of which that is true.
        count: usize,
        /// How far from the straight line.
        distance: f64,
        /// How long that is.
        chord: f64,
        /// Parts of the longest chord beside a span above this are reported.
        limit: f64,
    },
    /// The tolerance of a smoothed motion is below the noise of its poses, so that single ones pull it to and fro.
    PosesNoisier {
        /// True of the turns, in radians; else of the places.
        turning: bool,
        /// Standard deviation of the noise in one direction.
        sigma: f64,
        /// The tolerance.
        tolerance: f64,
        /// Tolerances from this on are not reported.
        needed: f64,
    },
    /// A pose of a smoothed motion does not belong to the others: it is far from where these go on.
    PoseOutlier {
        /// The pose, from 0.
        pose: usize,
        /// True if it is so in its turn, in radians; else in its place.
        turning: bool,
        /// How far it is off.
        distance: f64,
        /// Standard deviation of the noise of the others in one direction.
        noise: f64,
        /// It was left out, as asked for; else it counts.
        dropped: bool,
        /// How many there are.
        count: usize,
    },
    /// A tolerance of a smoothed motion so large that its path is gone: it is less than 0.8 times as long as the poses say.
    MotionSmoothedAway {
        /// True of the turns, in radians; else of the places.
        turning: bool,
        /// Length of the path.
        path: f64,
        /// Length of that through the poses without their noise.
        poses: f64,
    },
    /// A tolerance of a smoothed motion that is wide against the path, and not for its noise.
    WideForMotion {
        /// True of the turns, in radians; else of the places.
        turning: bool,
        /// The tolerance.
        tolerance: f64,
        /// How far poses without their noise are from the first.
        extent: f64,
    },
    /// Blends at the poses of a motion are shorter than the radius that was asked for: they take half of the way to the next pose at most.
    BlendsShortened {
        /// The pose where the blend is the shortest, from 0.
        pose: usize,
        /// How many poses there are of which that is true.
        count: usize,
        /// The radius there.
        radius: f64,
        /// The radius that was asked for.
        asked: f64,
    },
    /// A pose is turned by half a turn against the one before, for which both ways round are as short.
    HalfTurn {
        /// The first such pose, from 0.
        pose: usize,
        /// How many there are.
        count: usize,
        /// How much is missing to half a turn there, radians.
        off: f64,
        /// Angles up to this are reported.
        limit: f64,
    },
    /// Poses that are planar, spherical, translated or of one motion of degree 2 but for the digits they are written with were taken for that.
    PosesRounded {
        /// What they are off, in their size.
        off: f64,
        /// Study forms up to this are taken for rounding.
        limit: f64,
    },
    /// The velocity of a curve vanishes within a piece or at a joint, and its direction jumps there.
    CuspInside {
        /// How many such places there are.
        count: usize,
        /// The parameter of the first, from 0 to 1.
        t: f64,
        /// The point there.
        at: [f64; 3],
        /// The turn there, radians: half a turn within a piece.
        angle: f64,
    },
    /// Corners of the input were kept as corners.
    CornerKept {
        /// Index of the first of the points.
        vertex: usize,
        /// How many there are.
        count: usize,
        /// Least turn at one of them, radians.
        least: f64,
        /// Largest turn at one of them, radians.
        most: f64,
    },
    /// The samples are too far apart for the tolerance if the edges themselves are meant.
    SamplesTooCoarse {
        /// Median sagitta of the edges.
        sagitta: f64,
        /// Largest sagitta an arc over two vertices can have.
        limit: f64,
    },
    /// The tolerance is below the noise of the data, or exact data are too coarse for it: nearly every span has two edges
    /// or fewer.
    ToleranceBelowNoise {
        /// Fraction of such spans.
        fraction: f64,
    },
    /// A curve changes between left and right far more often than its data.
    Wavers {
        /// Changes of the curve.
        curve: usize,
        /// Changes of the polygon through its nodes.
        data: usize,
        /// Those and three for each end of a straight run: what the data account for.
        explained: usize,
        /// What helps.
        remedy: WaverRemedy,
    },
    /// The points turn sharply between straight runs, and the curve goes round: a corner that was not marked.
    CornerNotMarked {
        /// Index of the first of these points.
        node: usize,
        /// How many there are.
        count: usize,
        /// The largest turn, radians.
        angle: f64,
        /// How far the curve leaves the edges beside them.
        distance: f64,
    },
    /// The data themselves change between left and right as noise does, and a curve through all of them must.
    DataWaver {
        /// Changes of the polygon through the nodes.
        changes: usize,
        /// Nodes, corners and ends excepted.
        nodes: usize,
    },
    /// Arcs of a fit are much tighter than any circle of the data near them: a corner may be hidden in them.
    TightArc {
        /// The piece that is tightest against its data, from 0.
        piece: usize,
        /// Index of the point at its start.
        vertex: usize,
        /// Its radius.
        radius: f64,
        /// Radius of the tightest circle of the data near it.
        data: f64,
        /// Radii below this are reported.
        limit: f64,
        /// How many arcs are that tight.
        count: usize,
    },
    /// A fit turns more than its data do within the tolerance: it swings to and fro between the points.
    TurnsMoreThanData {
        /// Total turning of the fit, radians.
        turning: f64,
        /// What the data turn within the tolerance at most, radians.
        limit: f64,
    },
    /// A smooth curve within the tolerance needs nearly as many nodes as there are points.
    ManyNodes {
        /// Nodes of the curve.
        nodes: usize,
        /// Points it was fitted to; more than a third as many nodes are reported.
        points: usize,
        /// How often the points change between left and right. More than a third of them do so as noise does.
        changes: usize,
    },
    /// The fairest curve leans on the bounds of the tolerance: nearer to the data is nearer to what noisy data were
    /// measured from.
    LeansOnWalls {
        /// Root mean square of the distances of the points from the curve.
        rms: f64,
        /// Values above this are reported.
        limit: f64,
        /// How far the points scatter from one to the next about any smooth curve: the standard deviation of their noise.
        /// `None` where there are too few points to a node to tell noise from shape.
        scatter: Option<f64>,
    },
    /// A curve within a tolerance leaves out more of its points than their noise.
    BeyondNoise {
        /// Root mean square of the distances of the points from the curve.
        rms: f64,
        /// Standard deviation of the noise across the curve, estimated from the points.
        noise: f64,
    },
    /// A tolerance that is wide against the figure binds little: a narrower one gave a better curve.
    WideTolerance {
        /// The tolerance asked for.
        tolerance: f64,
        /// What the curve keeps to: the tolerance itself for an arc fit.
        used: f64,
    },
    /// A tolerance so large that bends or loops are gone: the curve is less than 0.8 times as long as its points say.
    ShapeSmoothedAway {
        /// Length of the curve.
        curve: f64,
        /// Length of the line through the points after their noise has been smoothed.
        data: f64,
    },
    /// A fair fit has more nodes than were asked for, or fewer.
    NodesNotReached {
        /// Nodes of each smooth piece that were asked for.
        asked: usize,
        /// Nodes of the piece that is farthest from it.
        reached: usize,
        /// What decided: `tolerance`, `budget`, `max-fits`, `fewest` (no curve has fewer) or `first-fit` (the tolerance
        /// was reached with fewer).
        why: &'static str,
    },
    /// Ends were asked for, but a closed curve has none.
    EndsWithoutEffect,
    /// A fit swung out between its points, far from their polyline, as it does where a corner is no corner to it.
    SwingsOut {
        /// How far the curve was from the polyline.
        distance: f64,
        /// The tolerance and 0.146 of the edge (of arcs twice the tolerance and the largest sagitta); larger distances
        /// are reported.
        limit: f64,
        /// It was fitted again with places on the edges, and does not swing out any more.
        held: bool,
        /// It is an arc fit, which can take the edges as they are.
        has_target: bool,
    },
    /// Edges between measured points are far longer than those round them: straight sides of an outline, or gaps in a curve.
    LongEdges {
        /// The point from which the first of them runs.
        point: usize,
        /// How many there are.
        count: usize,
        /// The curve is held to them as straight sides; else it is free there.
        held: bool,
    },
    /// The noise that was given is not that of the points.
    NoiseContradicted {
        /// The standard deviation that was given.
        given: f64,
        /// That of the points.
        found: f64,
    },
    /// Few points were taken for noisy ones, though they may be corners as well.
    FewForNoise {
        /// How many there are.
        points: usize,
        /// The standard deviation of the noise that was read.
        noise: f64,
        /// How far apart neighbours usually are.
        apart: f64,
    },
    /// Points that turn by a lot were read as samples of a smooth curve, though they may be corners as well.
    ReadAsCurve {
        /// How many there are.
        count: usize,
        /// Largest turn at one of them, radians.
        turn: f64,
        /// How far the curve is from their polyline.
        distance: f64,
        /// A fit that has the target `polyline`.
        has_target: bool,
    },
    /// The feet of some points step back along the curve: distances are bounded one way only.
    FeetNotMonotone {
        /// The first point whose foot is before that of its predecessor.
        point: usize,
        /// How many there are.
        count: usize,
    },
    /// A point does not belong to the others: it is far from the curve of these.
    Outlier {
        /// The point.
        point: usize,
        /// How far it is from the curve of the others.
        distance: f64,
        /// Standard deviation of the noise of these.
        noise: f64,
        /// It was left out, as asked for; else it counts.
        dropped: bool,
        /// How many there are.
        count: usize,
    },
    /// Points that were measured while nothing moved are one place, and count as one point.
    StopMerged {
        /// The first of them.
        first: usize,
        /// The last.
        last: usize,
        /// How many there are.
        count: usize,
        /// Their mean.
        at: [f64; 3],
        /// How far the farthest is from it.
        radius: f64,
    },
    /// Points closer than the limit to their neighbour were merged.
    PointsMerged {
        /// Index of the first one dropped.
        first: usize,
        /// How many were dropped.
        count: usize,
        /// Distances up to this count as equal.
        limit: f64,
    },
    /// The last points of a closed curve repeat its first one and were merged with it.
    ClosingPointMerged {
        /// Index of the first one dropped.
        index: usize,
    },
    /// Directions of curvature were smoothed further than usual to be rid of umbilics.
    UmbilicsSmoothed {
        /// How many are gone.
        count: usize,
        /// By how much that turned the directions in the mean, radians.
        turn: f64,
    },
    /// A surface is covered by several grids, or not as far as it could be by one.
    GridPieces {
        /// How many.
        count: usize,
        /// The part of the surface that they cover.
        coverage: f64,
    },
    /// Grids miss some of their surface.
    PartlyCovered {
        /// The part of the surface's area that they cover.
        coverage: f64,
        /// The part below which it is said.
        limit: f64,
        /// Whether each grid is a rectangle, and not all whole cells.
        rectangles: bool,
        /// How many umbilics the surface has.
        umbilics: usize,
    },
    /// One mesh of quads round umbilics goes round some of them only.
    UmbilicsLeftOut {
        /// How many are left out.
        count: usize,
        /// Where the first is.
        at: [f64; 3],
    },
    /// A mesh of quads round umbilics runs across the lines of curvature on a part of its surface.
    OffCurvatureLines {
        /// That part of where the principal curvatures differ clearly.
        part: f64,
        /// Angles above this count, radians.
        angle: f64,
        /// Parts above this are reported.
        limit: f64,
    },
    /// The lines of curvature of a tube are spirals: a grid that is closed along them leaves them.
    SpiralLines {
        /// By how much they come back higher.
        shift: f64,
        /// Length of an edge of the grid.
        edge: f64,
    },
    /// The edges of a grid along lines of curvature are of very different lengths.
    UnevenEdges {
        /// Which grid, from 0.
        piece: usize,
        /// The shortest and the longest.
        edges: [f64; 2],
        /// Largest ratio that is not reported.
        limit: f64,
    },
    /// The lines of a grid to be made circular run across the curvature lines of its surface.
    AcrossCurvatureLines {
        /// Mean angle to the curvature lines, weighted by the difference of the principal curvatures, radians.
        angle: f64,
        /// Angles above this are reported, radians.
        limit: f64,
    },
    /// The shape of a grid changed when it was made circular.
    ShapeChanged {
        /// What was measured.
        change: ShapeChange,
    },
    /// A vertex moved far when its grid was made circular: the grid does not follow the curvature lines of its surface.
    MovedFar {
        /// The vertex, s fastest.
        vertex: usize,
        /// Length of its move.
        distance: f64,
        /// Moves above this are reported: two median edges.
        limit: f64,
    },
    /// A vertex left the surface of its grid when it was made circular.
    LeftSurface {
        /// The vertex, s fastest.
        vertex: usize,
        /// Its distance from the input surface.
        distance: f64,
        /// Distances above this are reported: the median edge.
        limit: f64,
    },
    /// Grid lines turn to and fro from vertex to vertex: a noisy or too coarse grid, better smoothed first.
    Zigzag {
        /// How neighbouring turns agree: 1 for smooth lines, -2/3 for independent errors of the vertices.
        agreement: f64,
        /// Mean turn at a vertex, radians.
        turn: f64,
    },
    /// Opposite borders of an open net nearly coincide, as where a tube was cut open.
    OpenSeam {
        /// What the borders are: `column` (s = 0 and s = 1) or `row` (t = 0 and t = 1).
        border: &'static str,
        /// Largest distance of a point of one border from the other one.
        gap: f64,
        /// Largest angle between the normals there, radians.
        angle: f64,
    },
    /// An offset beyond centres of curvature of its surface: lines run backwards there.
    BeyondFocalSet {
        /// The distance of the offset.
        distance: f64,
        /// The smallest radius of curvature towards that side.
        radius: f64,
        /// The first patch with a smaller radius than the distance.
        first: usize,
        /// How many there are.
        count: usize,
    },
    /// A net whose frame does not suit its grid: lines shrink to a point inside patches, or neighbours fold over.
    FoldedNet {
        /// Patches inside which a parameter line shrinks to a point.
        singular: usize,
        /// The first of them, s fastest.
        first: Option<usize>,
        /// Inner edges at which the normals differ by more than a thousandth of a radian.
        creases: usize,
        /// Largest angle there, radians.
        angle: f64,
    },
    /// A swept surface whose curve comes to move along itself: the surface turns back there, with an edge where it does.
    SweptSurfaceFolds {
        /// Faces in which it does, or at whose border to the one before.
        count: usize,
        /// The first of them.
        face: usize,
        /// How many of them do at their border only.
        borders: usize,
    },
    /// The neck of a ball that is larger than the bends of its way: it runs through itself.
    NeckFolds {
        /// Radius of the ball.
        radius: f64,
        /// Smallest radius of curvature of the way of its centre.
        limit: f64,
    },
    /// A hull of points of which no faces in planes are as near as the default flatness: it was raised until there are some.
    FlatnessRaised {
        /// The default, 1e-9 of the diameter.
        asked: f64,
        /// What was used.
        used: f64,
    },
    /// Edges of a polyhedron at which its faces are nearly in one plane, as where coordinates have few digits.
    ShallowEdges {
        /// Ends of the edge that bends least.
        ends: [usize; 2],
        /// How many there are.
        count: usize,
        /// The least angle between the normals of two faces, radians.
        angle: f64,
        /// Angles below this are reported, radians.
        limit: f64,
        /// How far the corners of one face are off the plane of the other one at most.
        off: f64,
    },
    /// Faces of a hull in planes within the distance asked for made no convex body, and a smaller one was taken: planes that are nearly one
    /// meet far from the points.
    FlatnessLowered {
        /// The distance asked for.
        asked: f64,
        /// The distance taken.
        used: f64,
    },
    /// Edges of a polyhedron so short that their directions are rounding: their ends are one point given twice.
    ShortEdges {
        /// Ends of the shortest one.
        ends: [usize; 2],
        /// How many there are.
        count: usize,
        /// Length of the shortest one.
        length: f64,
        /// Lengths up to this are reported: of a hull points that near are one.
        limit: f64,
    },
    /// Edges of a mesh at which the smooth surface runs backwards: faces are too thin or too long for their normals, or the points noisy.
    FoldsBack {
        /// Ends of the edge at which it turns most.
        vertices: [usize; 2],
        /// A triangle there, from 0.
        triangle: usize,
        /// The angle between the normal of the derivatives and that of the surface there, radians: half a turn where it is folded.
        angle: f64,
        /// How many such edges there are.
        count: usize,
    },
    /// Sharp edges of a mesh that became smooth, since no angle of creases was given.
    SharpEdgesSmoothed {
        /// Ends of the sharpest.
        vertices: [usize; 2],
        /// The angle between its triangles, radians.
        angle: f64,
        /// How many there are.
        count: usize,
        /// Angles above this are reported, radians.
        limit: f64,
    },
    /// Border edges of a mesh that lie on each other without being joined.
    LooseBorders {
        /// Ends of the first one.
        vertices: [usize; 2],
        /// How many there are.
        count: usize,
        /// Border edges of the mesh.
        borders: usize,
        /// The largest distance of the middle of one from the nearest other one; a hundredth of its length at most.
        gap: f64,
    },
    /// A bridge between ellipses that cross: it runs through itself beside the places where they do.
    EllipsesCross {
        /// By how much the second ellipse is wider along x.
        along_x: f64,
        /// The same along y.
        along_y: f64,
    },
    /// The ends of a profile were near the axis that it turns about, and were moved onto it.
    MovedToAxis {
        /// The farthest of them.
        distance: f64,
        /// Ends up to this far are moved.
        limit: f64,
    },
    /// A part of a turn of a profile that goes round an area, but has no end faces.
    OpenPart {
        /// The angle of the turn, radians.
        angle: f64,
    },
    /// A whole turn of a profile that goes round no area: the surface is open where its ends are off the axis.
    OpenProfile {
        /// Distance of its start from the axis.
        start: f64,
        /// Distance of its end.
        end: f64,
    },
    /// A closed profile touches the axis in one point: the solid is pinched there, its inside on both sides of one vertex.
    Pinched {
        /// The height of the point along the axis.
        height: f64,
    },
    /// A profile in a plane across the axis that it turns about: what it sweeps is a part of that plane.
    FlatRevolution,
    /// A surface between two curves bends sharply where pieces of the curves join smoothly.
    KinksAtJoints {
        /// Joints at which its normals differ by more than the limit.
        count: usize,
        /// The joint of the curves with the largest angle, from 0.
        joint: usize,
        /// That angle, radians.
        angle: f64,
        /// Angles above this are reported, radians.
        limit: f64,
    },
    /// Arcs between two curves that start nearly against their chords, so that they are nearly full circles of many chords' radius.
    NearlyFullArcs {
        /// The piece of the curves where that is so most, from 0.
        piece: usize,
        /// The angle between tangent and the way back along the chord there, radians.
        angle: f64,
        /// Angles below this are reported, radians.
        limit: f64,
    },
    /// Spheres at the corners of a triangle nearly oppose each other: between them the patch swings round within a small part of the triangle.
    SpheresNearlyOpposite {
        /// Length of the blended sphere there, 1 where all agree.
        length: f64,
        /// Lengths up to this are reported.
        limit: f64,
    },
    /// Normals of a mesh that point to the back of a face at their vertex: the smooth surface folds over there.
    NormalFacesBackward {
        /// The first triangle with such a corner, from 0.
        triangle: usize,
        /// The vertex of it.
        vertex: usize,
        /// How many corners there are.
        count: usize,
    },
    /// A block folds: the parameter lines of one direction run backwards in a part of it.
    VolumeFolds {
        /// A place in that part: s, t, u.
        at: [f64; 3],
    },
    /// Whether a block folds is not proved: parameter lines of one direction come to a stand near a place, or nearly so.
    VolumeFoldUndecided {
        /// The place: s, t, u.
        at: [f64; 3],
        /// How often squares of parameters about it were quartered.
        depth: u32,
    },
    /// Cells of a grid are inverted: the hexahedra with straight sides, or those of the block itself where it folds.
    CellsInverted {
        /// How many.
        count: usize,
        /// Of so many.
        cells: usize,
        /// The block of the first one, from 0.
        block: usize,
        /// Its place in the block along s, t and u, from 0.
        at: [usize; 3],
        /// Why.
        cause: InvertedCause,
    },
}
