//! The stable names of the reasons, and the item at fault.

use super::{Error, ErrorItem};

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
            Self::PointAtInfinity { .. } => "point-at-infinity",
            Self::NoFiniteBiarc { .. } => "no-finite-biarc",
            Self::Cusp { .. } => "tangent-undefined",
            Self::CountDiffers { .. } => "count-differs",
            Self::NotOfArcs { .. } => "not-of-arcs",
            Self::ZeroAxis { .. } => "zero-axis",
            Self::ZeroRadius { .. } => "zero-radius",
            Self::ScaleNotPositive { .. } => "scale-not-positive",
            Self::RadiusNotPositive { .. } | Self::ConeReachesApex { .. } => "radius-not-positive",
            Self::BallDoesNotFit { .. } => "ball-does-not-fit",
            Self::NeckFolds { .. } => "neck-folds",
            Self::PlateTooSmall { .. } => "plate-too-small",
            Self::TeeBranchTooWide { .. } => "tee-branch-too-wide",
            Self::TeeBlendTooLarge { .. } => "tee-blend-too-large",
            Self::TeeLawOnEqualPipes { .. } => "tee-law-on-equal-pipes",
            Self::TeePipeTooShort { .. } => "tee-pipe-too-short",
            Self::BallsNested { .. } => "balls-nested",
            Self::TubeTurnsBack { .. } => "tube-turns-back",
            Self::TubeRadiusVanishes { .. } => "tube-radius-vanishes",
            Self::TubeFolds { .. } => "tube-folds",
            Self::RadiusGrowsTooFast { .. } => "radius-grows-too-fast",
            Self::RadiusNotClosed { .. } => "radius-not-closed",
            Self::TeeBlendFolds { .. } => "tee-blend-folds",
            Self::TeeHoleFolds { .. } => "tee-hole-folds",
            Self::PipeEndsReversed { .. } => "pipe-ends-reversed",
            Self::CrossingAxesTooNear { .. } => "crossing-axes-too-near",
            Self::CrossingBallTooLarge { .. } => "crossing-ball-too-large",
            Self::CrossingPipesApart { .. } => "crossing-pipes-apart",
            Self::CrossingNeedsCylinders { .. } => "crossing-needs-cylinders",
            Self::NoCenterSurface => "no-center-surface",
            Self::CrossingPipeTooShort { .. } => "crossing-pipe-too-short",
            Self::CrossingHoleTooWide { .. } => "crossing-hole-too-wide",
            Self::CrossingHoleTurnsBack { .. } => "crossing-hole-turns-back",
            Self::CrossingFolds { .. } => "crossing-folds",
            Self::ContactLoopOpen { .. } => "contact-loop-open",
            Self::ContactLoopTurnsBack { .. } => "contact-loop-turns-back",
            Self::ContactBlendFolds { .. } => "contact-blend-folds",
            Self::ContactTubeTooShort { .. } => "contact-tube-too-short",
            Self::TeeBranchesMeet { .. } | Self::TeeBranchesTooNear { .. } => "tee-branches-meet",
            Self::TeeEqualBranchesNotOpposite { .. } => "tee-equal-branches-not-opposite",
            Self::TeeNoFreeLine { .. } => "tee-no-free-line",
            Self::EllipsesCross { .. } => "ellipses-cross",
            Self::PieceCountsDiffer { .. } => "piece-counts-differ",
            Self::RulingsCross { .. } => "rulings-cross",
            Self::ArcsCross { .. } => "arcs-cross",
            Self::OppositeTangents { .. } => "opposite-tangents",
            Self::DegreeTooHigh { .. } => "degree-too-high",
            Self::DegenerateCircle { .. } => "degenerate-circle",
            Self::DegenerateSphere { .. } => "degenerate-sphere",
            Self::OrderOutOfRange { .. } => "order-out-of-range",
            Self::ArcThroughInfinity { .. } => "arc-through-infinity",
            Self::AmbiguousHalfTurn { .. } => "ambiguous-half-turn",
            Self::TooManyPieces { .. } => "too-many-pieces",
            Self::EvenPointCount { .. } => "even-point-count",
            Self::RepeatedParameter { .. } => "repeated-parameter",
            Self::UnattainablePoint { .. } => "unattainable-point",
            Self::CurveThroughInfinity { .. } => "curve-through-infinity",
            Self::OppositeArcs { .. } => "opposite-arcs",
            Self::NotWithinTolerance { .. } => "not-within-tolerance",
            Self::BelowRoundingOfPlace { .. } => "below-rounding-of-place",
            Self::ToleranceNotPositive { .. } => "tolerance-not-positive",
            Self::SweepOutOfRange { .. } => "sweep-out-of-range",
            Self::CrossesAxis { .. } => "crosses-axis",
            Self::ProfileOnAxis { .. } => "profile-on-axis",
            Self::ProfileMeetsItself { .. } => "profile-meets-itself",
            Self::SectionNotPlane { .. } => "section-not-plane",
            Self::SectionMeetsItself { .. } => "section-meets-itself",
            Self::AngleOutOfRange { .. } => "angle-out-of-range",
            Self::FoldedProfile { .. } => "folded-profile",
            Self::NotAFace { .. } => "not-a-face",
            Self::NotClosed { .. } => "not-closed",
            Self::NonPlanarFace { .. } => "non-planar-face",
            Self::PlanesMissPoint { .. } => "planes-miss-point",
            Self::NotConvex { .. } => "not-convex",
            Self::NotInOpenHemisphere { .. } => "not-in-open-hemisphere",
            Self::FlatPolyhedron { .. } => "flat-polyhedron",
            Self::BendDoesNotFit { .. } => "bend-does-not-fit",
            Self::PipeTooWide { .. } => "pipe-too-wide",
            Self::CornerNotMitred { .. } => "corner-not-mitred",
            Self::MitreDoesNotFit { .. } => "mitre-does-not-fit",
            Self::PipeMeetsItself { .. } => "pipe-meets-itself",
            Self::SeamTooWide { .. } => "seam-too-wide",
            Self::SeamMeetsItself { .. } => "seam-meets-itself",
            Self::ParameterOutOfRange { .. } => "parameter-out-of-range",
            Self::NoG1SplineInTube { .. } => "no-g1-spline-in-tube",
            Self::ArcLimitNotKept { .. } => "arc-limit-not-kept",
            Self::ToleranceNotReached { .. } => "tolerance-not-reached",
            Self::OutliersOutside { .. } => "outliers",
            Self::NoiseNotSmoothed { .. } => "noise-not-smoothed",
            Self::Disconnected { .. } => "disconnected",
            Self::NotMobius { .. } => "not-mobius",
            Self::NotASimilarity { .. } => "not-a-similarity",
            Self::NoFrame { .. } => "no-frame",
            Self::KnotsDecrease { .. } => "knots-decrease",
            Self::KnotMultiplicity { .. } => "knot-multiplicity",
            Self::NotASpline { .. } => "not-a-spline",
            Self::WeightNotPositive { .. } => "weight-not-positive",
            Self::WeightsUneven { .. } => "weights-uneven",
            Self::FrameNotOrthonormal { .. } => "frame-not-orthonormal",
            Self::NotConcircular { .. } => "not-concircular",
            Self::CrossingQuad { .. } => "crossing-quad",
            Self::NotInSpace { .. } => "not-in-space",
            Self::PatchThroughInfinity { .. } => "patch-through-infinity",
            Self::NetDoesNotClose { .. } => "net-does-not-close",
            Self::AmbiguousFrame { .. } => "ambiguous-frame",
            Self::CollapsedSide { .. } => "collapsed-side",
            Self::OffsetOnFocalSet { .. } => "offset-on-focal-set",
            Self::OffsetNotRegular { .. } => "offset-not-regular",
            Self::NotAShell { .. } => "not-a-shell",
            Self::ShortEdge { .. } => "short-edge",
            Self::DegenerateTriangle { .. } => "degenerate-triangle",
            Self::ControlPointOnCircumcircle { .. } => "control-point-on-circumcircle",
            Self::OppositeSpheres { .. } => "opposite-spheres",
            Self::NormalAlongEdge { .. } => "normal-along-edge",
            Self::OppositeNormals { .. } => "opposite-normals",
            Self::UndefinedNormal { .. } => "undefined-normal",
            Self::NoTriangles { .. } => "no-triangles",
            Self::NoSuchVertex { .. } => "no-such-vertex",
            Self::NonManifoldEdge { .. } => "non-manifold-edge",
            Self::InconsistentOrientation { .. } => "inconsistent-orientation",
            Self::CellsUnfit { .. } => "cells-unfit",
            Self::NotAQuadLayout { .. } => "not-a-quad-layout",
            Self::RingDoesNotClose { .. } => "ring-does-not-close",
            Self::NotASurface { .. } => "not-a-surface",
            Self::FlatSurface { .. } => "flat-surface",
            Self::UmbilicsRemain { .. } => "umbilics-remain",
            Self::UmbilicsNotJoined { .. } => "umbilics-not-joined",
            Self::FieldNotOrientable { .. } => "field-not-orientable",
            Self::SpiralLines { .. } => "spiral-lines",
            Self::NoGrid { .. } => "no-grid",
            Self::ConcircularCube { .. } => "concircular-cube",
            Self::CrossingFace { .. } => "crossing-face",
            Self::VolumeThroughInfinity { .. } => "volume-through-infinity",
            Self::FoldedVolume { .. } => "folded-volume",
            Self::InQuad { cause, .. }
            | Self::InBlock { cause, .. }
            | Self::InFaceOfVolume { cause, .. }
            | Self::InBranch { cause, .. }
            | Self::InTriangle { cause, .. }
            | Self::InSpan { cause, .. } => cause.reason(),
            Self::CollapsedOnCurve { .. } => "collapsed-on-curve",
            Self::NotConverged { .. } => "not-converged",
            Self::ShapeLost { .. } => "shape-lost",
            Self::BorderCurvesApart { .. } => "border-curves-apart",
            Self::NotARingTorus { .. } => "not-a-ring-torus",
            Self::ZeroCoordinate { .. } => "zero-coordinate",
            Self::PointOnAxis { .. } => "point-on-axis",
            Self::PointOnCoreCircle { .. } => "point-on-core-circle",
            Self::PointOffTorus { .. } => "point-off-torus",
            Self::NotMonotone { .. } => "not-monotone",
            Self::SpanTooLarge { .. } => "span-too-large",
            Self::EmptyInterval { .. } => "empty-interval",
            Self::NoTwoTypeSolution { .. } => "no-two-type-solution",
            Self::NotCoprime { .. } => "not-coprime",
            Self::NotTimelikePair { .. } => "not-timelike-pair",
            Self::DegeneratePair { .. } => "degenerate-pair",
            Self::SphereAtInfinity { .. } => "sphere-at-infinity",
            Self::WrongSide { .. } => "wrong-side",
            Self::NoPositiveRadius { .. } => "no-positive-radius",
            Self::ParallelContact { .. } => "parallel-contact",
            Self::RadiusTooSmall { .. } => "radius-too-small",
            Self::ZeroRotation { .. } => "zero-rotation",
            Self::NotARotation { .. } => "not-a-rotation",
            Self::NotOnStudyQuadric { .. } => "not-on-study-quadric",
            Self::WrongPoseCount { .. } => "wrong-pose-count",
            Self::ParametersNotIncreasing { .. } => "parameters-not-increasing",
            Self::UnattainablePose { .. } => "unattainable-pose",
            Self::MotionThroughExceptionalPoint { .. } => "motion-through-exceptional-point",
            Self::RotationTooLarge { .. } => "rotation-too-large",
            Self::NoCubicMotion { .. } => "no-cubic-motion",
            Self::StudyFormVanishes { .. } => "study-form-vanishes",
            Self::MotionNotRational => "motion-not-rational",
            Self::MotionAtRest { .. } => "motion-at-rest",
            Self::SpanWithoutWay { .. } => "span-without-way",
        }
    }

    /// The index of the input item at fault (a point, tangent, span or segment), where there is one.
    #[must_use]
    pub fn index(&self) -> Option<usize> {
        match *self {
            Self::NotFinite { index, .. }
            | Self::ZeroWeight { index }
            | Self::ZeroTangent { index }
            | Self::TangentOpposesChord { index, .. }
            | Self::PointAtInfinity { index, .. }
            | Self::ZeroAxis { index, .. }
            | Self::Cusp { index, .. }
            | Self::OppositeTangents { first: index, .. }
            | Self::WeightNotPositive { index, .. }
            | Self::WeightsUneven { second: index, .. }
            | Self::ZeroRotation { index }
            | Self::ParametersNotIncreasing { index, .. }
            | Self::UnattainablePose { index, .. } => Some(index),
            Self::RotationTooLarge { span, .. } | Self::SpanWithoutWay { span, .. } => Some(span),
            Self::CoincidentPoints { second, .. } | Self::RepeatedParameter { second, .. } => Some(second),
            Self::ArcThroughInfinity { segment, .. } | Self::AmbiguousHalfTurn { segment, .. } => Some(segment),
            Self::TooManyPieces { segment, .. } => segment,
            Self::NoG1SplineInTube { vertex, .. } | Self::ArcLimitNotKept { vertex, .. } => Some(vertex),
            Self::Disconnected { piece, .. }
            | Self::NotWithinTolerance { piece, .. }
            | Self::CrossesAxis { piece, .. }
            | Self::RulingsCross { piece, .. }
            | Self::ArcsCross { piece, .. }
            | Self::PipeTooWide { piece, .. }
            | Self::MitreDoesNotFit { piece, .. }
            | Self::TubeRadiusVanishes { piece, .. }
            | Self::TubeFolds { piece, .. }
            | Self::RadiusGrowsTooFast { piece, .. }
            | Self::FoldedProfile { piece, .. } => Some(piece),
            Self::NotAFace { face, .. } | Self::NonPlanarFace { face, .. } => Some(face),
            Self::ProfileMeetsItself { second, .. } => Some(second),
            Self::BendDoesNotFit { corner, .. } => Some(corner),
            Self::CornerNotMitred { joint, .. } => Some(joint),
            Self::PipeMeetsItself { second, .. }
            | Self::SeamMeetsItself { second, .. }
            | Self::BallsNested { second, .. } => Some(second),
            Self::TubeTurnsBack { ball } => Some(ball),
            Self::InSpan { span, .. } => Some(span),
            Self::NotAShell { index, .. } => Some(index),
            Self::InQuad { quad, .. } => Some(quad),
            Self::InBlock { block, .. } => Some(block),
            Self::InBranch { branch, .. } => Some(branch),
            Self::InTriangle { triangle, .. }
            | Self::NoSuchVertex { triangle, .. }
            | Self::NonManifoldEdge { triangle, .. }
            | Self::NotASurface { index: triangle, .. } => Some(triangle),
            Self::CellsUnfit { index: quad, .. } => Some(quad),
            Self::NotAQuadLayout { index, .. } | Self::RingDoesNotClose { vertex: index, .. } => Some(index),
            Self::InconsistentOrientation { triangles: [_, second], .. } => Some(second),
            Self::ZeroCoordinate { index }
            | Self::PointOnAxis { index, .. }
            | Self::PointOnCoreCircle { index, .. }
            | Self::PointOffTorus { index, .. }
            | Self::EmptyInterval { index, .. }
            | Self::KnotsDecrease { index, .. }
            | Self::KnotMultiplicity { index, .. } => Some(index),
            Self::NoTwoTypeSolution { segment, .. } => Some(segment),
            Self::WrongSide { surface, .. } => Some(surface),
            Self::UndefinedNormal { vertex, .. } | Self::PlanesMissPoint { vertex, .. } => Some(vertex),
            Self::ToleranceNotReached { ref points, .. }
            | Self::NoiseNotSmoothed { ref points, .. }
            | Self::UnattainablePoint { ref points, .. } => points.first().copied(),
            Self::OutliersOutside { ref points, .. } => points.first().map(|p| p.0),
            _ => None,
        }
    }

    /// Wraps the error as the failure of one quad of a net.
    #[must_use]
    pub fn in_quad(self, quad: usize) -> Self {
        Self::InQuad { quad, cause: Box::new(self) }
    }

    /// Wraps the error as the failure of one block of a grid.
    pub(crate) fn in_block(self, block: usize) -> Self {
        Self::InBlock { block, cause: Box::new(self) }
    }

    /// Wraps the error as the failure of one face of a volume.
    pub(crate) fn in_face_of_volume(self, axis: usize, end: usize) -> Self {
        Self::InFaceOfVolume { axis, end, cause: Box::new(self) }
    }

    /// Wraps the error as the failure of a number of one branch of a tee.
    #[must_use]
    pub fn in_branch(self, branch: usize, what: ErrorItem) -> Self {
        Self::InBranch { branch, what, cause: Box::new(self) }
    }

    /// Wraps the error as the failure of one triangle of a mesh.
    #[must_use]
    pub fn in_triangle(self, triangle: usize) -> Self {
        Self::InTriangle { triangle, cause: Box::new(self) }
    }

    /// Wraps the error as the failure of one span of a chain.
    #[must_use]
    pub fn in_span(self, span: usize) -> Self {
        Self::InSpan { span, cause: Box::new(self) }
    }
}
