//! The one error type of the kernel.
//!
//! Every variant says which item is at fault, what was measured and the limit it broke. [`Error::reason`] gives
//! the stable kebab-case name that the reference data, the reports and the documentation use.

use crate::shape_change::ShapeChange;
use crate::short_number::ShortNumber;

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
        "the angle {:#} is outside {:#} to {:#} radians, or none at all",
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
    /// A profile in a plane across its axis that sweeps a part of the plane twice.
    #[error(
        "piece {piece} of the profile turns back at the distance {} from the axis, in a plane across it: what it sweeps is folded; take a profile that goes on, or one with heights",
        ShortNumber(*.distance)
    )]
    FoldedProfile {
        /// Which piece, from 0.
        piece: usize,
        /// Where it turns back.
        distance: f64,
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
    /// One span of a chain failed; the cause says why.
    #[error("span {span}: {cause}")]
    InSpan {
        /// Which span, from 0.
        span: usize,
        /// What went wrong in it.
        cause: Box<Error>,
    },
}

/// In words, that a value is outside its interval.
fn outside(min: f64, max: f64) -> String {
    if max >= f64::MAX {
        return format!("out of range: at least {:#}", ShortNumber(min));
    }
    format!("outside {:#} to {:#}", ShortNumber(min), ShortNumber(max))
}

/// A size next to its place; where all its points round to the same numbers nothing is left of it.
fn size_in_place(size: f64) -> String {
    if size > 0.0 { format!("{} large", ShortNumber(size)) } else { "one single point".to_owned() }
}

/// The number of a segment, where there is one.
fn numbered(segment: Option<usize>) -> String {
    segment.map_or(String::new(), |segment| format!(" {segment}"))
}

/// A count in words; one that was given up is infinite.
fn at_least(needed: f64) -> String {
    if needed.is_finite() { ShortNumber(needed).to_string() } else { "ever more".to_owned() }
}

/// The first of some points and how many more there are.
fn points_in_words(points: &[usize]) -> String {
    let shown: Vec<String> = points.iter().take(8).map(usize::to_string).collect();
    let more = points.len().saturating_sub(shown.len());
    let and = if more > 0 { format!(" and {more} more") } else { String::new() };
    format!("point(s) {}{and}", shown.join(", "))
}

/// The ratio of speeds `1 + stretch` in words, where it is worth any.
fn speed_ratio(stretch: f64, limit: f64) -> String {
    if stretch.abs() <= limit {
        return String::new();
    }
    let sign = if stretch < 0.0 { '-' } else { '+' };
    format!(" and the speed of the lines across by the factor 1 {sign} {}", ShortNumber(stretch.abs()))
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

impl Error {
    /// The stable name of the reason, as used in reference data and reports.
    ///
    /// ```
    /// let error = cyclide::Error::ZeroWeight { index: 1 };
    /// assert_eq!(error.reason(), "zero-weight");
    /// ```
    #[must_use]
    pub fn reason(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "not-finite",
            Self::CoincidentPoints { .. } => "coincident-points",
            Self::TooFewPoints { .. } => "too-few-points",
            Self::ZeroWeight { .. } => "zero-weight",
            Self::PoleOnSegment { .. } => "pole-on-segment",
            Self::NearlyFullCircle { .. } => "nearly-full-circle",
            Self::NotInImH { .. } => "not-in-im-h",
            Self::ZeroTangent { .. } => "zero-tangent",
            Self::TangentOpposesChord { .. } => "tangent-opposes-chord",
            Self::PointAtInfinity | Self::NearPole { .. } => "point-at-infinity",
            Self::NoFiniteBiarc { .. } => "no-finite-biarc",
            Self::Cusp { .. } => "cusp",
            Self::TangentCount { .. } => "tangent-count",
            Self::ZeroAxis => "zero-axis",
            Self::ZeroRadius { .. } => "zero-radius",
            Self::ScaleNotPositive { .. } => "scale-not-positive",
            Self::RadiusNotPositive { .. } => "radius-not-positive",
            Self::DegenerateCircle { .. } => "degenerate-circle",
            Self::DegenerateSphere { .. } => "degenerate-sphere",
            Self::OrderOutOfRange { .. } => "order-out-of-range",
            Self::ArcThroughInfinity { .. } | Self::ArcNearInfinity { .. } => "arc-through-infinity",
            Self::AmbiguousHalfTurn { .. } => "ambiguous-half-turn",
            Self::TooManyPieces { .. } => "too-many-pieces",
            Self::NotWithinTolerance { .. } => "not-within-tolerance",
            Self::BelowRoundingOfPlace { .. } => "below-rounding-of-place",
            Self::ToleranceNotPositive { .. } => "tolerance-not-positive",
            Self::SweepOutOfRange { .. } => "sweep-out-of-range",
            Self::CrossesAxis { .. } => "crosses-axis",
            Self::AngleOutOfRange { .. } => "angle-out-of-range",
            Self::FoldedProfile { .. } => "folded-profile",
            Self::ParameterOutOfRange { .. } => "parameter-out-of-range",
            Self::NoG1SplineInTube { .. } => "no-g1-spline-in-tube",
            Self::ToleranceNotReached { .. } => "tolerance-not-reached",
            Self::NotPlanar { .. } => "not-planar",
            Self::Disconnected { .. } => "disconnected",
            Self::NotMobius { .. } => "not-mobius",
            Self::NotASimilarity => "not-a-similarity",
            Self::NotASpline { .. } => "not-a-spline",
            Self::WeightNotPositive { .. } => "weight-not-positive",
            Self::FrameNotOrthonormal { .. } => "frame-not-orthonormal",
            Self::NotConcircular { .. } => "not-concircular",
            Self::CrossingQuad { .. } => "crossing-quad",
            Self::NotInSpace { .. } => "not-in-space",
            Self::PatchThroughInfinity { .. } => "patch-through-infinity",
            Self::NetDoesNotClose { .. } => "net-does-not-close",
            Self::AmbiguousFrame => "ambiguous-frame",
            Self::CollapsedSide { .. } => "collapsed-side",
            Self::OffsetOnFocalSet { .. } => "offset-on-focal-set",
            Self::OffsetNotRegular { .. } => "offset-not-regular",
            Self::NotAShell { .. } => "not-a-shell",
            Self::ShortEdge { .. } => "short-edge",
            Self::InQuad { cause, .. } | Self::InSpan { cause, .. } => cause.reason(),
            Self::CollapsedOnCurve { .. } => "collapsed-on-curve",
            Self::NotConverged { .. } => "not-converged",
            Self::ShapeLost { .. } => "shape-lost",
            Self::BorderCurvesApart { .. } => "border-curves-apart",
        }
    }

    /// The index of the input item at fault (a point, tangent, span or segment), where there is one.
    #[must_use]
    pub fn index(&self) -> Option<usize> {
        match *self {
            Self::NotFinite { index, .. }
            | Self::ZeroWeight { index }
            | Self::ZeroTangent { index }
            | Self::TangentOpposesChord { index }
            | Self::Cusp { index, .. }
            | Self::WeightNotPositive { index, .. }
            | Self::NotPlanar { index, .. } => Some(index),
            Self::CoincidentPoints { second, .. } => Some(second),
            Self::ArcThroughInfinity { segment }
            | Self::ArcNearInfinity { segment, .. }
            | Self::AmbiguousHalfTurn { segment } => Some(segment),
            Self::TooManyPieces { segment, .. } => segment,
            Self::NoG1SplineInTube { vertex, .. } => Some(vertex),
            Self::Disconnected { piece, .. }
            | Self::NotWithinTolerance { piece, .. }
            | Self::CrossesAxis { piece, .. }
            | Self::FoldedProfile { piece, .. } => Some(piece),
            Self::InSpan { span, .. } => Some(span),
            Self::NotAShell { index, .. } => Some(index),
            Self::InQuad { quad, .. } => Some(quad),
            Self::ToleranceNotReached { ref points, .. } => points.first().copied(),
            _ => None,
        }
    }

    /// Wraps the error as the failure of one quad of a net.
    #[must_use]
    pub fn in_quad(self, quad: usize) -> Self {
        Self::InQuad { quad, cause: Box::new(self) }
    }

    /// Wraps the error as the failure of one span of a chain.
    #[must_use]
    pub fn in_span(self, span: usize) -> Self {
        Self::InSpan { span, cause: Box::new(self) }
    }
}
