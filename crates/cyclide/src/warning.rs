//! What a construction did that its user should know: named, with the place, the measure and the limit.

use crate::shape_change::{ShapeChange, degrees};
use crate::short_number::ShortNumber;

/// Points that scatter by more than this part of what counts as leaning are called noisy.
const SCATTER: f64 = 0.15;
/// Neighbouring chords that differ by this factor are no uneven spacing: the shorter one joins a point to itself.
const NEARLY_REPEATED: f64 = 1000.0;

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
    /// A corner of the input was kept as a corner.
    CornerKept {
        /// Index of the point.
        vertex: usize,
        /// Turn at the point, radians.
        angle: f64,
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
    /// An interpolating curve changes between left and right far more often than its data.
    Wavers {
        /// Changes of the curve.
        curve: usize,
        /// Changes of the polygon through its nodes.
        data: usize,
        /// Those and one for each end of a straight run: what the data account for.
        explained: usize,
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
    /// A fair fit swung out between its points, far from their polyline, as it does where a corner is no corner to it.
    SwingsOut {
        /// How far the curve was from the polyline.
        distance: f64,
        /// The tolerance and half the longest edge (of arcs twice the tolerance and the largest sagitta); larger distances
        /// are reported.
        limit: f64,
        /// It was fitted again with places on the edges, and does not swing out any more.
        held: bool,
    },
    /// The feet of some points step back along the curve: distances are bounded one way only.
    FeetNotMonotone {
        /// The first point whose foot is before that of its predecessor.
        point: usize,
        /// How many there are.
        count: usize,
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
    /// Normals of a mesh that point to the back of a face at their vertex: the smooth surface folds over there.
    NormalFacesBackward {
        /// The first triangle with such a corner, from 0.
        triangle: usize,
        /// The vertex of it.
        vertex: usize,
        /// How many corners there are.
        count: usize,
    },
}

impl Warning {
    /// The stable name of the warning, as used in reports.
    #[must_use]
    pub fn reason(&self) -> &'static str {
        match self {
            Self::Cusp { .. } => "cusp",
            Self::SharpTurn { .. } => "sharp-turn",
            Self::SharpTurnCut { .. } => "sharp-turn-cut",
            Self::Relaxed { .. } => "relaxed",
            Self::LongWay { .. } => "long-way",
            Self::OppositeCircles { .. } => "opposite-circles",
            Self::RoundedDirections { .. } => "rounded-directions",
            Self::UnevenSpacing { .. } => "uneven-spacing",
            Self::CornerKept { .. } => "corner-kept",
            Self::SamplesTooCoarse { .. } => "samples-too-coarse",
            Self::ToleranceBelowNoise { .. } => "tolerance-below-noise",
            Self::Wavers { .. } => "wavers",
            Self::CornerNotMarked { .. } => "corner-not-marked",
            Self::DataWaver { .. } => "data-waver",
            Self::TightArc { .. } => "tight-arc",
            Self::TurnsMoreThanData { .. } => "turns-more-than-data",
            Self::ManyNodes { points, changes, .. } if as_noise(*changes, *points) => "tolerance-below-noise",
            Self::ManyNodes { .. } => "many-nodes",
            Self::LeansOnWalls { .. } => "leans-on-walls",
            Self::WideTolerance { .. } => "wide-tolerance",
            Self::ShapeSmoothedAway { .. } => "shape-smoothed-away",
            Self::NodesNotReached { .. } => "nodes-not-reached",
            Self::EndsWithoutEffect => "no-effect",
            Self::SwingsOut { .. } => "swings-out",
            Self::FeetNotMonotone { .. } => "feet-not-monotone",
            Self::PointsMerged { .. } => "points-merged",
            Self::ClosingPointMerged { .. } => "closing-point-merged",
            Self::AcrossCurvatureLines { .. } => "across-curvature-lines",
            Self::ShapeChanged { .. } => "shape-changed",
            Self::MovedFar { .. } => "moved-far",
            Self::LeftSurface { .. } => "left-surface",
            Self::Zigzag { .. } => "zigzag",
            Self::OpenSeam { .. } | Self::LooseBorders { .. } => "open-seam",
            Self::BeyondFocalSet { .. } => "beyond-focal-set",
            Self::FoldedNet { .. } => "folded-net",
            Self::NeckFolds { .. } => "neck-folds",
            Self::FoldsBack { .. } => "folds-back",
            Self::SharpEdgesSmoothed { .. } => "sharp-edges-smoothed",
            Self::FlatnessRaised { .. } => "flatness-raised",
            Self::ShallowEdges { .. } => "shallow-edges",
            Self::EllipsesCross { .. } => "ellipses-cross",
            Self::MovedToAxis { .. } => "moved-to-axis",
            Self::OpenPart { .. } | Self::OpenProfile { .. } => "open-body",
            Self::FlatRevolution => "flat-revolution",
            Self::KinksAtJoints { .. } => "kinks-at-joints",
            Self::NormalFacesBackward { .. } => "normal-faces-backward",
        }
    }

    /// The index of the point or segment, where there is one.
    #[must_use]
    pub fn index(&self) -> Option<usize> {
        match *self {
            Self::Cusp { node }
            | Self::SharpTurn { node, .. }
            | Self::SharpTurnCut { node, .. }
            | Self::CornerNotMarked { node, .. }
            | Self::UnevenSpacing { node, .. } => Some(node),
            Self::Relaxed { ref segments } => segments.first().map(|(segment, _)| *segment),
            Self::LongWay { segment } | Self::OppositeCircles { segment } | Self::RoundedDirections { segment, .. } => {
                Some(segment)
            }
            Self::CornerKept { vertex, .. } | Self::TightArc { vertex, .. } => Some(vertex),
            Self::PointsMerged { first, .. } => Some(first),
            Self::FeetNotMonotone { point, .. } => Some(point),
            Self::ClosingPointMerged { index } => Some(index),
            Self::MovedFar { vertex, .. } | Self::LeftSurface { vertex, .. } => Some(vertex),
            Self::BeyondFocalSet { first, .. } => Some(first),
            Self::FoldedNet { first, .. } => first,
            Self::KinksAtJoints { joint, .. } => Some(joint),
            Self::NormalFacesBackward { triangle, .. } | Self::FoldsBack { triangle, .. } => Some(triangle),
            Self::SamplesTooCoarse { .. }
            | Self::ToleranceBelowNoise { .. }
            | Self::Wavers { .. }
            | Self::DataWaver { .. }
            | Self::TurnsMoreThanData { .. }
            | Self::AcrossCurvatureLines { .. }
            | Self::ShapeChanged { .. }
            | Self::OpenSeam { .. }
            | Self::ManyNodes { .. }
            | Self::LeansOnWalls { .. }
            | Self::WideTolerance { .. }
            | Self::ShapeSmoothedAway { .. }
            | Self::NodesNotReached { .. }
            | Self::EndsWithoutEffect
            | Self::SwingsOut { .. }
            | Self::Zigzag { .. }
            | Self::SharpEdgesSmoothed { .. }
            | Self::LooseBorders { .. }
            | Self::FlatnessRaised { .. }
            | Self::ShallowEdges { .. }
            | Self::NeckFolds { .. }
            | Self::EllipsesCross { .. }
            | Self::MovedToAxis { .. }
            | Self::OpenPart { .. }
            | Self::OpenProfile { .. }
            | Self::FlatRevolution => None,
        }
    }
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Cusp { node } => {
                write!(f, "point {node}: the curve turns back on itself (cusp), joint only connected")
            }
            Self::SharpTurn { node, angle, limit } => {
                write!(
                    f,
                    "point {node}: the points turn back by {:.2} degrees (more than {:.0} is sharp): the circle through it and its neighbours is very large, and the curve swings out; if a corner is meant, mark it",
                    angle.to_degrees(),
                    limit.to_degrees()
                )
            }
            Self::SharpTurnCut { node, angle, limit } => {
                write!(
                    f,
                    "point {node}: the points turn back by {:.2} degrees (more than {:.0} is sharp): a smooth curve would swing out, so the point is made a corner",
                    angle.to_degrees(),
                    limit.to_degrees()
                )
            }
            Self::Relaxed { segments } => write_relaxed(f, segments),
            Self::LongWay { segment } => {
                write!(f, "segment {segment}: the blend takes the long way between its circles")
            }
            Self::OppositeCircles { segment } => {
                write!(
                    f,
                    "segment {segment}: its circles run in opposite directions, small changes move the curve a lot"
                )
            }
            Self::RoundedDirections { segment, count, angle, limit } => write!(
                f,
                "{count} chord(s), the first is segment {segment}, are so short for coordinates this large that rounding turns them by up to {} degrees (above {}): move the points to the origin before they are written, or merge them",
                degrees(*angle),
                degrees(*limit)
            ),
            Self::UnevenSpacing { node, ratio, .. } if *ratio >= NEARLY_REPEATED => {
                write!(
                    f,
                    "point {node}: neighbouring chords differ by a factor {ratio:.0}: two points nearly repeat each other there, and the curve may loop; remove one of them"
                )
            }
            Self::UnevenSpacing { node, ratio, limit } => {
                write!(
                    f,
                    "point {node}: neighbouring chords differ by a factor {ratio:.1} (above {limit}), the curve may bulge"
                )
            }
            Self::CornerKept { vertex, angle } => {
                write!(f, "point {vertex}: corner of {:.1} degrees kept", angle.to_degrees())
            }
            Self::SamplesTooCoarse { sagitta, limit } => write!(
                f,
                "median sagitta of the edges is {}, an arc over two of them allows {}: if the points are samples of a smooth curve, use the target `points`",
                ShortNumber(*sagitta),
                ShortNumber(*limit)
            ),
            Self::ToleranceBelowNoise { fraction } => {
                write!(
                    f,
                    "{:.0} % of the arcs span two edges or fewer: the tolerance is below the noise of the points, or they are too far apart for it",
                    fraction * 100.0
                )
            }
            Self::Wavers { curve, data, explained } => {
                write!(f, "the curve changes {} between left and right, its points {}", times(*curve), times(*data))?;
                if explained > data {
                    write!(f, " ({explained} with the ends of their straight runs)")?;
                }
                f.write_str(": it wavers between them (the comb of a picture shows where); a fair spline, or a fit within a tolerance, bends less to and fro")
            }
            Self::CornerNotMarked { node, count, angle, distance } => write!(
                f,
                "{count} point(s) turn between straight runs, by up to {:.1} degrees, the first is point {node}: the curve goes round and leaves the runs by up to {}; if corners are meant, mark them (a corner angle)",
                angle.to_degrees(),
                ShortNumber(*distance)
            ),
            Self::DataWaver { changes, nodes } => write!(
                f,
                "the points change {changes} times between left and right at {nodes} nodes, as noise does, and the curve passes through all of them: a fit within a tolerance is smoother"
            ),
            Self::TightArc { piece, vertex, radius, data, limit, count } => {
                write!(
                    f,
                    "{count} arc(s) much tighter than the data, the tightest is piece {piece} at point {vertex}: radius {}, the tightest circle of the data there has {} (below {} is tight)",
                    ShortNumber(*radius),
                    ShortNumber(*data),
                    ShortNumber(*limit)
                )
            }
            Self::TurnsMoreThanData { turning, limit } => {
                write!(
                    f,
                    "the fit turns by {turning:.2} radians in all, its data by at most {limit:.2}: smooth the points or raise the tolerance"
                )
            }
            Self::ManyNodes { nodes, points, changes } => {
                write!(f, "{nodes} nodes for {points} points, ")?;
                if as_noise(*changes, *points) {
                    write!(
                        f,
                        "which change between left and right {changes} times, as noise does: the tolerance is below their noise"
                    )
                } else {
                    f.write_str("which are too few, or the tolerance too small, to be described by fewer; corners are followed with few nodes only if they are given (a corner angle)")
                }
            }
            Self::LeansOnWalls { rms, limit, scatter } => {
                write!(
                    f,
                    "the curve leans on the bounds of the tolerance, as the fairest one does: the root mean square of the distances is {} (more than {} is much); ",
                    ShortNumber(*rms),
                    ShortNumber(*limit)
                )?;
                match *scatter {
                    Some(scatter) if scatter > SCATTER * limit => write!(
                        f,
                        "the points scatter by {} from one to the next: for noise, 3 to 4 times that as tolerance with centre 1 comes nearer to what was measured",
                        ShortNumber(scatter)
                    ),
                    Some(scatter) => write!(
                        f,
                        "the points scatter by no more than {} from one to the next: a smaller tolerance, or a centre of 1, comes nearer to them",
                        ShortNumber(scatter)
                    ),
                    None => f.write_str("a smaller tolerance, or a centre of 1, comes nearer to the points"),
                }
            }
            Self::WideTolerance { tolerance, used } if used >= tolerance => write!(
                f,
                "the tolerance {} is wide against the figure: bends and corners smaller than it may be gone",
                ShortNumber(*tolerance)
            ),
            Self::WideTolerance { tolerance, used } => write!(
                f,
                "the tolerance {} is wide against the figure: the curve keeps within {}, where it is fairer or swings out less",
                ShortNumber(*tolerance),
                ShortNumber(*used)
            ),
            Self::ShapeSmoothedAway { curve, data } => write!(
                f,
                "the curve is {} long, its points say {}: bends or loops smaller than the tolerance are gone",
                ShortNumber(*curve),
                ShortNumber(*data)
            ),
            Self::NodesNotReached { asked, reached, why } => write_nodes_not_reached(f, *asked, *reached, why),
            Self::EndsWithoutEffect => f.write_str("a closed curve has no ends: what was asked for them has no effect"),
            Self::SwingsOut { distance, limit, held } => write!(
                f,
                "between the points the curve {} up to {} from their polyline (more than {} is far){}; if the points have corners, give a corner angle",
                if *held { "would swing out" } else { "swings out" },
                ShortNumber(*distance),
                ShortNumber(*limit),
                if *held { ": it is held to places on the edges too" } else { "" }
            ),
            Self::FeetNotMonotone { point, count } => write!(
                f,
                "point {point}: its place on the curve is before that of the point before it ({count} such): the points are denser than their noise, and the distance to their polyline is bounded one way only"
            ),
            Self::PointsMerged { first, count, limit } => {
                let limit = ShortNumber(*limit);
                match count {
                    1 => write!(f, "point {first} repeats the one before it (closer than {limit}): left out"),
                    _ => write!(
                        f,
                        "{count} points repeat those before them (closer than {limit}): left out, the first is point {first}"
                    ),
                }
            }
            Self::ClosingPointMerged { index } => {
                write!(f, "point {index} repeats the first point of the closed curve: merged with it")
            }
            Self::AcrossCurvatureLines { angle, limit } => write!(
                f,
                "the grid lines run {} degrees off the curvature lines of the surface on average (more than {} is across them): quads with circles follow curvature lines",
                degrees(*angle),
                degrees(*limit)
            ),
            Self::ShapeChanged { change } => write!(f, "the shape changed: {}", change.changed()),
            Self::MovedFar { vertex, distance, limit } => {
                write!(
                    f,
                    "vertex {vertex} moved by {} (more than {} is far): align the grid with the curvature lines first",
                    ShortNumber(*distance),
                    ShortNumber(*limit)
                )
            }
            Self::LeftSurface { vertex, distance, limit } => {
                write!(
                    f,
                    "vertex {vertex} is {} off the input surface (more than {} is far)",
                    ShortNumber(*distance),
                    ShortNumber(*limit)
                )
            }
            Self::Zigzag { agreement, turn } => write!(
                f,
                "grid lines zigzag: neighbouring turns of {:.1} degrees on average agree by {agreement:.2}; smooth or refine the grid first",
                turn.to_degrees()
            ),
            Self::NeckFolds { radius, limit } => write!(
                f,
                "the neck runs through itself on the side to which the pipe leans: a ball of radius {} rolls through bends of radius {}; take a smaller ball",
                ShortNumber(*radius),
                ShortNumber(*limit)
            ),
            Self::FoldsBack { vertices: [from, to], triangle, angle, count } => write!(
                f,
                "the surface folds back at {count} edge(s), most of all at that between the vertices {from} and {to}, in triangle {triangle}: its normal turns by {:.0} degrees there; `crease_angle` keeps edges, a finer or smoother mesh has no folds",
                angle.to_degrees()
            ),
            Self::SharpEdgesSmoothed { vertices: [from, to], angle, count, limit } => write!(
                f,
                "{count} edge(s) that bend by more than {:.0} degrees are smoothed away, by up to {:.1} degrees, between the vertices {from} and {to}: `crease_angle` keeps them",
                limit.to_degrees(),
                angle.to_degrees()
            ),
            Self::LooseBorders { vertices: [from, to], count, borders, gap } => write!(
                f,
                "{count} of {borders} border edges lie within {} of another one, the first between the vertices {from} and {to}: points that are meant to be one are apart, weld them; or a vertex is inside an edge of a neighbour, cut this there",
                ShortNumber(*gap)
            ),
            Self::FlatnessRaised { asked, used } => write!(
                f,
                "the points are not in planes within {}, 1e-9 of their diameter: {} is taken, as of rounded points; give the rounding of the points as `flatness`",
                ShortNumber(*asked),
                ShortNumber(*used)
            ),
            Self::ShallowEdges { ends: [first, second], count, angle, limit, off } => write!(
                f,
                "{count} edge(s) bend by less than {} radians, least of all that between the points {first} and {second}, by {}: where their faces are meant to be in one plane, give the rounding of the points as `flatness`; corners are up to {} off the plane beside them",
                ShortNumber(*limit),
                ShortNumber(*angle),
                ShortNumber(*off)
            ),
            Self::EllipsesCross { along_x, along_y } => write!(
                f,
                "the ellipses cross: the second is wider by {} along x and by {} along y, and the bridge runs through itself beside the places where they do; take one inside the other",
                ShortNumber(*along_x),
                ShortNumber(*along_y)
            ),
            Self::MovedToAxis { distance, limit } => write!(
                f,
                "the profile ends up to {} off the axis (up to {} counts as meant to be on it): its ends were moved onto the axis; write more digits, or start farther out for a bore",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            Self::OpenPart { angle } => write!(
                f,
                "the body is open at both ends of its turn by {} degrees: end faces are made of contours in one plane with the axis that meet neither themselves nor each other; a whole turn is a solid",
                degrees(*angle)
            ),
            Self::OpenProfile { start, end } => write_open_profile(f, *start, *end),
            Self::FlatRevolution => f.write_str(
                "the profile lies in a plane across the axis, and what it sweeps is flat; for a body give it heights along the axis (points [r, 0, z] for the axis z), or take an axis in its plane",
            ),
            Self::KinksAtJoints { count, joint, angle, limit } => write!(
                f,
                "the surface has kinks at {count} joint(s) where both curves run smoothly, the largest of {} degrees at joint {joint} (above {}): speeds jump there from piece to piece by different factors; take curves with pieces of like lengths on both sides, or of one piece",
                degrees(*angle),
                degrees(*limit)
            ),
            Self::OpenSeam { border, gap, angle } => write!(
                f,
                "the first and the last {border} of the grid are at most an edge apart and the net is open there: the surface has a gap of up to {} and an angle of up to {} degrees there",
                ShortNumber(*gap),
                degrees(*angle)
            ),
            Self::BeyondFocalSet { distance, radius, first, count } => write!(
                f,
                "the offset by {} goes beyond the focal set on {count} patch(es), the first is patch {first}: the surface bends towards that side with radii down to {}, and beyond them its lines run backwards; offsets by less do not",
                ShortNumber(*distance),
                ShortNumber(rounded_down(*radius))
            ),
            Self::FoldedNet { singular, first, creases, angle } => {
                if let Some(first) = first {
                    write!(f, "{singular} singular patch(es), the first is quad {first}")?;
                }
                let and = if first.is_some() && *creases > 0 { "; " } else { "" };
                if *creases > 0 {
                    write!(f, "{and}{creases} joint(s) with a crease of up to {:.1} degrees", angle.to_degrees())?;
                }
                f.write_str(": the frame does not suit the grid")
            }
            Self::NormalFacesBackward { triangle, vertex, count } => write!(
                f,
                "{count} normal(s) point to the back of a triangle beside them, first that of vertex {vertex} in triangle {triangle}: the surface folds over there; turn the normals or the triangles, or refine the mesh"
            ),
        }
    }
}

/// Points that change between left and right more often than this many times in three do so as noise does.
fn as_noise(changes: usize, points: usize) -> bool {
    3 * changes > points
}

fn write_nodes_not_reached(
    f: &mut std::fmt::Formatter<'_>,
    asked: usize,
    reached: usize,
    why: &str,
) -> std::fmt::Result {
    let because = match why {
        "tolerance" => "the points need them within the tolerance",
        "budget" => "fewer would cost more fairness than the budget allows: raise it",
        "max-fits" => "the fits for taking nodes out are spent: allow more",
        "first-fit" => "the tolerance is reached with as few",
        _ => "a curve cannot have fewer",
    };
    write!(f, "{asked} nodes were asked for, {reached} it has: {because}")
}

/// Which ends are off the axis, and how to get a solid.
fn write_open_profile(f: &mut std::fmt::Formatter<'_>, start: f64, end: f64) -> std::fmt::Result {
    match (start > 0.0, end > 0.0) {
        (true, true) => write!(
            f,
            "the surface is open: its profile starts {} and ends {} off the axis",
            ShortNumber(start),
            ShortNumber(end)
        ),
        (true, false) => write!(f, "the surface is open: its profile starts {} off the axis", ShortNumber(start)),
        _ => write!(f, "the surface is open: its profile ends {} off the axis", ShortNumber(end)),
    }?;
    f.write_str("; a solid needs a closed profile, or both ends on the axis")
}

fn times(count: usize) -> String {
    if count == 1 { "once".to_owned() } else { format!("{count} times") }
}

/// The relaxed segments by the points they join, with the range of their blends.
fn write_relaxed(f: &mut std::fmt::Formatter<'_>, segments: &[(usize, f64)]) -> std::fmt::Result {
    let least = segments.iter().map(|(_, e)| *e).fold(1.0, f64::min);
    let largest = segments.iter().map(|(_, e)| *e).fold(0.0, f64::max);
    match segments {
        [] => return f.write_str("no segment is relaxed"),
        [(one, _)] => write!(f, "behind point {one} the fairest curve would swing out, so it is less fair there"),
        [(first, _), .., (last, _)] => write!(
            f,
            "on {} segments, behind the points {first} to {last}, the fairest curve would swing out, so it is less fair there",
            segments.len()
        ),
    }?;
    let (least, largest) = (ShortNumber(least), ShortNumber(largest));
    write!(f, " (blend {least}")?;
    if least != largest {
        write!(f, " to {largest}")?;
    }
    f.write_str(" where 1 is the fairest); if the points turn sharply on purpose, mark them as corners")
}

/// Four digits of a positive value, not more than it is: a limit that is kept by what is said.
fn rounded_down(value: f64) -> f64 {
    let unit = 10.0_f64.powf(value.log10().floor() - 3.0);
    let down = (value / unit).floor() * unit;
    if down.is_finite() && down > 0.0 { down } else { value }
}
