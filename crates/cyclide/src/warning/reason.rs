//! The stable names of the warnings, and the point, segment or other item that each is about.

use super::Warning;

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
            Self::SpikeNearPoint { .. } => "spike-near-point",
            Self::LargeExcursion { .. } => "large-excursion",
            Self::TurnsBack { .. } => "turns-back",
            Self::SpeedSpike { .. } => "speed-spike",
            Self::TurnsNearlyInPlace { .. } => "turns-nearly-in-place",
            Self::RestsPassedOver { .. } => "rests-passed-over",
            Self::MotionReverses { .. } => "motion-reverses",
            Self::MotionSwings { .. } => "motion-swings",
            Self::LeavesChords { .. } => "leaves-chords",
            Self::PosesNoisier { .. } => "tolerance-below-noise",
            Self::PoseOutlier { .. } => "outlier",
            Self::MotionSmoothedAway { .. } => "shape-smoothed-away",
            Self::WideForMotion { .. } => "wide-tolerance",
            Self::BlendsShortened { .. } => "blends-shortened",
            Self::HalfTurn { .. } => "half-turn",
            Self::PosesRounded { .. } => "poses-rounded",
            Self::CuspInside { .. } => "cusp",
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
            Self::BeyondNoise { .. } => "beyond-noise",
            Self::WideTolerance { .. } => "wide-tolerance",
            Self::ShapeSmoothedAway { .. } => "shape-smoothed-away",
            Self::NodesNotReached { .. } => "nodes-not-reached",
            Self::EndsWithoutEffect => "no-effect",
            Self::SwingsOut { .. } => "swings-out",
            Self::LongEdges { .. } => "long-edges",
            Self::NoiseContradicted { .. } => "noise-contradicted",
            Self::FewForNoise { .. } => "few-for-noise",
            Self::ReadAsCurve { .. } => "read-as-curve",
            Self::FeetNotMonotone { .. } => "feet-not-monotone",
            Self::Outlier { .. } => "outlier",
            Self::StopMerged { .. } => "stop",
            Self::PointsMerged { .. } => "points-merged",
            Self::ClosingPointMerged { .. } => "closing-point-merged",
            Self::UmbilicsSmoothed { .. } => "umbilics-smoothed",
            Self::GridPieces { .. } => "pieces",
            Self::PartlyCovered { .. } => "partly-covered",
            Self::SpiralLines { .. } => "spiral-lines",
            Self::UmbilicsLeftOut { .. } => "umbilics-left-out",
            Self::OffCurvatureLines { .. } => "off-curvature-lines",
            Self::UnevenEdges { .. } => "uneven-edges",
            Self::AcrossCurvatureLines { .. } => "across-curvature-lines",
            Self::ShapeChanged { .. } => "shape-changed",
            Self::MovedFar { .. } => "moved-far",
            Self::LeftSurface { .. } => "left-surface",
            Self::Zigzag { .. } => "zigzag",
            Self::OpenSeam { .. } | Self::LooseBorders { .. } => "open-seam",
            Self::BeyondFocalSet { .. } => "beyond-focal-set",
            Self::FoldedNet { .. } => "folded-net",
            Self::SweptSurfaceFolds { .. } => "swept-surface-folds",
            Self::NeckFolds { .. } => "neck-folds",
            Self::FoldsBack { .. } => "folds-back",
            Self::SharpEdgesSmoothed { .. } => "sharp-edges-smoothed",
            Self::FlatnessRaised { .. } => "flatness-raised",
            Self::FlatnessLowered { .. } => "flatness-lowered",
            Self::ShortEdges { .. } => "short-edges",
            Self::ShallowEdges { .. } => "shallow-edges",
            Self::EllipsesCross { .. } => "ellipses-cross",
            Self::MovedToAxis { .. } => "moved-to-axis",
            Self::OpenPart { .. } | Self::OpenProfile { .. } => "open-body",
            Self::Pinched { .. } => "pinched",
            Self::FlatRevolution => "flat-revolution",
            Self::KinksAtJoints { .. } => "kinks-at-joints",
            Self::NearlyFullArcs { .. } => "nearly-full-arcs",
            Self::SpheresNearlyOpposite { .. } => "spheres-nearly-opposite",
            Self::VolumeFolds { .. } => "volume-folds",
            Self::VolumeFoldUndecided { .. } => "volume-fold-undecided",
            Self::CellsInverted { .. } => "cells-inverted",
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
            Self::SpikeNearPoint { point, .. } => Some(point),
            Self::HalfTurn { pose, .. } | Self::BlendsShortened { pose, .. } | Self::PoseOutlier { pose, .. } => {
                Some(pose)
            }
            Self::CornerKept { vertex, .. } | Self::TightArc { vertex, .. } => Some(vertex),
            Self::PointsMerged { first, .. } => Some(first),
            Self::FeetNotMonotone { point, .. } | Self::Outlier { point, .. } => Some(point),
            Self::StopMerged { first, .. } => Some(first),
            Self::LongEdges { point, .. } => Some(point),
            Self::NearlyFullArcs { piece, .. } => Some(piece),
            Self::ClosingPointMerged { index } => Some(index),
            Self::MovedFar { vertex, .. } | Self::LeftSurface { vertex, .. } => Some(vertex),
            Self::BeyondFocalSet { first, .. } => Some(first),
            Self::FoldedNet { first, .. } => first,
            Self::UnevenEdges { piece, .. } => Some(piece),
            Self::KinksAtJoints { joint, .. } => Some(joint),
            Self::SweptSurfaceFolds { face, .. } => Some(face),
            Self::NormalFacesBackward { triangle, .. } | Self::FoldsBack { triangle, .. } => Some(triangle),
            Self::SpeedSpike { span, .. }
            | Self::MotionSwings { span, .. }
            | Self::LeavesChords { span, .. }
            | Self::TurnsNearlyInPlace { span, .. }
            | Self::RestsPassedOver { span, .. }
            | Self::MotionReverses { span, .. } => Some(span),
            Self::LargeExcursion { .. }
            | Self::PosesNoisier { .. }
            | Self::MotionSmoothedAway { .. }
            | Self::WideForMotion { .. }
            | Self::TurnsBack { .. }
            | Self::PosesRounded { .. }
            | Self::CuspInside { .. }
            | Self::SamplesTooCoarse { .. }
            | Self::ToleranceBelowNoise { .. }
            | Self::Wavers { .. }
            | Self::DataWaver { .. }
            | Self::TurnsMoreThanData { .. }
            | Self::UmbilicsSmoothed { .. }
            | Self::GridPieces { .. }
            | Self::PartlyCovered { .. }
            | Self::UmbilicsLeftOut { .. }
            | Self::OffCurvatureLines { .. }
            | Self::SpiralLines { .. }
            | Self::AcrossCurvatureLines { .. }
            | Self::ShapeChanged { .. }
            | Self::OpenSeam { .. }
            | Self::ManyNodes { .. }
            | Self::LeansOnWalls { .. }
            | Self::BeyondNoise { .. }
            | Self::WideTolerance { .. }
            | Self::ShapeSmoothedAway { .. }
            | Self::NodesNotReached { .. }
            | Self::EndsWithoutEffect
            | Self::SwingsOut { .. }
            | Self::FewForNoise { .. }
            | Self::NoiseContradicted { .. }
            | Self::ReadAsCurve { .. }
            | Self::Zigzag { .. }
            | Self::SharpEdgesSmoothed { .. }
            | Self::LooseBorders { .. }
            | Self::FlatnessRaised { .. }
            | Self::FlatnessLowered { .. }
            | Self::ShortEdges { .. }
            | Self::ShallowEdges { .. }
            | Self::NeckFolds { .. }
            | Self::EllipsesCross { .. }
            | Self::MovedToAxis { .. }
            | Self::OpenPart { .. }
            | Self::OpenProfile { .. }
            | Self::Pinched { .. }
            | Self::SpheresNearlyOpposite { .. }
            | Self::VolumeFolds { .. }
            | Self::VolumeFoldUndecided { .. }
            | Self::CellsInverted { .. }
            | Self::FlatRevolution => None,
        }
    }
}

/// Points that change between left and right more often than this many times in three do so as noise does.
pub(super) fn as_noise(changes: usize, points: usize) -> bool {
    3 * changes > points
}
