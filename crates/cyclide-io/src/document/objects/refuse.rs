//! What the kernel refused, shown at the point or field it is about.

use cyclide::{ErrorItem, Point3, ShortNumber, Warning};

use super::curves::{Origin, Points};
use super::nurbs::{blame_nurbs, knots_words};
use super::torus::blame_torus;
use super::{Builder, Remark};
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::locate::{Step, path_text, span_of};
use crate::document::spec::{
    ArcSpec, ContactBlendSpec, FreeOr, ObjectSpec, PipeCrossingSpec, TorusSplineSpec, TubeSpec,
};
use crate::error::{Error, of_contour};
use crate::text::place::Source;

/// The value of an object that an error is about.
pub(super) enum Blame {
    Field(&'static str),
    Entry(&'static str, usize),
    /// A field of an entry.
    FieldOfEntry(&'static str, usize, &'static str),
    Point(usize),
    Object,
}

impl Builder<'_> {
    /// What the kernel said; it counts points after repeated ones were merged, which is said where the number matters.
    fn words(&self, error: &cyclide::Error, contour: usize) -> String {
        let merged = |remark: &Remark| {
            let merges = |w: &Warning| matches!(w, Warning::PointsMerged { .. } | Warning::ClosingPointMerged { .. });
            remark.contour == Some(contour) && remark.warning.as_ref().is_some_and(merges)
        };
        match (error, self.spec) {
            (cyclide::Error::TooFewPoints { .. }, _) if self.remarks.iter().any(merged) => {
                format!("{error} (repeated points count once)")
            }
            (cyclide::Error::ParameterOutOfRange { name: ErrorItem::Distance, .. }, ObjectSpec::Offset(spec))
                if spec.distance == 0.0 =>
            {
                "a solid between a surface and its offset needs a distance other than 0".to_owned()
            }
            (cyclide::Error::ParameterOutOfRange { name: ErrorItem::CornerAngle, value, .. }, spec) => {
                let written = spec.corner_angle();
                written.map_or_else(|| error.to_string(), |angle| corner_angle_words(angle, *value))
            }
            (_, ObjectSpec::Nurbs(_)) if let Some(words) = knots_words(error) => words,
            (cyclide::Error::FrameNotOrthonormal { .. }, ObjectSpec::CyclidePatch(spec)) => frame_words(spec.frame),
            (cyclide::Error::ZeroTangent { index }, ObjectSpec::TorusSpline(spec)) if is_given(spec, *index) => {
                format!("tangent {index} is normal to the torus there: nothing of it runs along the torus")
            }
            // Angles a whole turn apart are one place.
            (cyclide::Error::CoincidentPoints { .. }, ObjectSpec::TorusSpline(spec))
                if !spec.closed && spec.winding.is_none() && spec.angles.is_some() =>
            {
                format!(
                    "{error}; from a place once round to the same place leads a `winding`, as `[[1, 0]]`, or `closed`"
                )
            }
            // What is the normal of a frame to the kernel.
            (cyclide::Error::ZeroAxis { .. }, ObjectSpec::Cyclide(_)) => "the axis is zero".to_owned(),
            (cyclide::Error::CoincidentPoints { distance, limit, .. }, ObjectSpec::EllipseBridge(_)) => format!(
                "the ellipses touch: their semi-axes of one direction differ by {}, more than {} is needed",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            (cyclide::Error::CoincidentPoints { distance, limit, .. }, ObjectSpec::Ruled(_)) => format!(
                "a piece of one curve is that of the other, {} apart at most: there is no surface between what is no more than {} apart",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            (cyclide::Error::CoincidentPoints { distance, limit, .. }, ObjectSpec::CircularSurface(_)) => format!(
                "the curves meet, or are {} apart in one place, and an arc joins points that are more than {} apart",
                ShortNumber(*distance),
                ShortNumber(*limit)
            ),
            (cyclide::Error::CrossingQuad { .. }, ObjectSpec::CyclidePatch(_)) => {
                format!(
                    "{error}; corners are given row by row, (0,0), (1,0), (0,1), (1,1): are the last two exchanged?"
                )
            }
            _ => error.to_string(),
        }
    }

    /// The message for what the kernel said about the value at a path below the object.
    pub(super) fn refused_at(&self, steps: impl IntoIterator<Item = Step>, error: &cyclide::Error) -> Error {
        if self.document.text.is_empty() {
            return Error::Geometry { object: self.name.to_owned(), contour: None, source: error.clone() };
        }
        self.refused_in_words(steps, error.reason(), error.to_string())
    }

    /// As [`refused_at`](Self::refused_at), in other words.
    pub(super) fn refused_in_words(
        &self,
        steps: impl IntoIterator<Item = Step>,
        reason: &'static str,
        words: String,
    ) -> Error {
        Error::Input(self.diagnostic(steps, &words).with_reason(reason))
    }

    /// The message for what the kernel said, at the point or field it is about.
    pub(super) fn refused(&self, error: &cyclide::Error, from: Option<(&Points, usize)>) -> Error {
        let blame = match from.and_then(|(points, contour)| too_far_out(error, &points.lists[contour].points)) {
            Some(point) => Blame::Point(point),
            None => blame(self.spec, error),
        };
        let original = |k: usize| from.and_then(|(p, c)| p.kept[c].get(k).copied()).unwrap_or(k);
        let path = self.path([]);
        if let Some((points, contour)) = from
            && let Origin::File { name, text, .. } = &points.origin
            && matches!(blame, Blame::Point(_) | Blame::Object)
        {
            let index = if let Blame::Point(k) = blame { original(k) } else { 0 };
            let start = points.lists[contour].offsets.get(index).copied().unwrap_or_default();
            let width = text[start..].find(['\n', '\r', '#']).unwrap_or(text.len() - start);
            let width = text[start..start + width].trim_end().len();
            let source = Source { name, text };
            let message = source.diagnostic(start..start + width, &path_text(&path), self.words(error, contour));
            return Error::Input(message.with_reason(error.reason()));
        }
        let of_several = from.and_then(|(points, contour)| (points.lists.len() > 1).then_some(contour));
        let document = &self.document.text;
        if document.is_empty() {
            return Error::Geometry { object: self.name.to_owned(), contour: of_several, source: error.clone() };
        }
        let nested = |points: &Points| matches!(points.origin, Origin::Document { nested: true, .. });
        let in_points = |k: Option<usize>| from.map(|(p, c)| self.path(p.steps(c, k)));
        // A value that all contours share does not tell which of them it does not fit.
        let shared = matches!(blame, Blame::Field(_) | Blame::Entry(..));
        let candidates = match blame {
            Blame::Field(field) => vec![self.path([field.into()])],
            Blame::FieldOfEntry(list, k, field) => {
                let entry = [list.into(), k.into()];
                vec![self.path(entry.iter().cloned().chain([field.into()])), self.path(entry)]
            }
            Blame::Entry(field, k) => {
                let contour = from.map_or(0, |(_, c)| c);
                let one = self.path([field.into(), original(k).into()]);
                let several = self.path([field.into(), contour.into(), original(k).into()]);
                // A list of lists also has an entry at the first path: the deeper one is meant.
                let nested = from.is_some_and(|(p, _)| p.lists.len() > 1 || nested(p));
                if nested { vec![several, one] } else { vec![one, self.path([field.into()])] }
            }
            Blame::Point(k) => {
                let end = if k == 0 { "from" } else { "to" };
                let fixed = [self.path(["through".into(), k.into()]), self.path([end.into()])];
                in_points(Some(original(k))).into_iter().chain(fixed).collect()
            }
            Blame::Object => in_points(None).into_iter().collect(),
        };
        let place = |p: &Vec<Step>| span_of(document, p).map(|span| (p.clone(), span));
        let own_entry =
            matches!(blame, Blame::Entry(..)) && candidates.first().is_some_and(|first| place(first).is_some());
        let (path, span) = candidates.iter().find_map(place).unwrap_or_else(|| {
            let start = span_of(document, &path).map_or(0, |s| s.start);
            (path, start..start + 1)
        });
        let words = self.words(error, from.map_or(0, |(_, contour)| contour));
        let words = of_contour(of_several.filter(|_| shared && !own_entry)) + &words;
        let message = self.document.source().diagnostic(span, &path_text(&path), words);
        Error::Input(message.with_reason(error.reason()))
    }
}

/// True if a curve on a torus was given a direction there that is not zero.
fn is_given(spec: &TorusSplineSpec, index: usize) -> bool {
    let given = spec.tangents.as_ref().and_then(|all| all.get(index)).and_then(|FreeOr(given)| *given);
    given.is_some_and(|given| given.vector().length() > 0.0)
}

/// Degrees are taken for radians now and then: what was written, and what may be meant.
fn corner_angle_words(angle: Angle, radians: f64) -> String {
    match angle {
        Angle::Degrees(degrees) => format!("a corner angle of {degrees} degrees is outside 0 to 180"),
        Angle::Radians(_) if radians > 180.0 || radians <= 0.0 => format!(
            "a corner angle of {radians} radians is outside 0 to 3.1416 (half a turn; degrees are written `{{\"degrees\": 30}}`)"
        ),
        Angle::Radians(_) => format!(
            "a corner angle of {radians} radians is more than half a turn (3.1416): if degrees are meant, write `{{\"degrees\": {radians}}}` or {}",
            ShortNumber(radians.to_radians())
        ),
    }
}

/// The directions of a frame may have any length; only the angle between them can be wrong.
pub(super) fn frame_words(frame: [Coordinates; 2]) -> String {
    let [a, b] = frame.map(|direction| direction.vector().unit());
    match (a, b) {
        (Some(a), Some(b)) => {
            let off = (90.0 - a.dot(b).clamp(-1.0, 1.0).acos().to_degrees()).abs();
            format!("the directions of the frame must be perpendicular: they are {} degrees off", ShortNumber(off))
        }
        _ => "the directions of the frame must not be zero".to_owned(),
    }
}

/// The point that a refused coordinate belongs to: the one that is farthest out.
fn too_far_out(error: &cyclide::Error, points: &[Point3]) -> Option<usize> {
    let cyclide::Error::ParameterOutOfRange { name: ErrorItem::Coordinate, value, .. } = *error else { return None };
    points.iter().position(|p| p.to_vec().max_abs() >= value.abs())
}

/// Which value of an object an error of the kernel is about.
fn blame(spec: &ObjectSpec, error: &cyclide::Error) -> Blame {
    use cyclide::{Error as E, ErrorItem as I};
    let tangent = |index: usize| match (spec, index) {
        (ObjectSpec::Arc(s), _) => Blame::Field(if s.tangent.is_some() { "tangent" } else { "end_tangent" }),
        (ObjectSpec::Biarc(_), 0) => Blame::Field("from_tangent"),
        (ObjectSpec::Biarc(_), _) => Blame::Field("to_tangent"),
        (ObjectSpec::CircleSpline(_) | ObjectSpec::FairSpline(_), _) => Blame::Field("ends"),
        _ => Blame::Entry("tangents", index),
    };
    let is_moebius = matches!(spec, ObjectSpec::MoebiusSpline(_));
    let is_qb = matches!(spec, ObjectSpec::QbInterpolation(_));
    let is_patch = matches!(spec, ObjectSpec::CyclidePatch(_));
    match *error {
        E::ParameterOutOfRange { name: I::Distance, .. } if matches!(spec, ObjectSpec::Offset(_)) => {
            Blame::Field(I::Distance.word())
        }
        _ if matches!(spec, ObjectSpec::Offset(_)) && is_of_distance(error) => Blame::Field("distance"),
        _ if matches!(
            spec,
            ObjectSpec::PlateWithNeck(_)
                | ObjectSpec::EllipseBridge(_)
                | ObjectSpec::CircularSurface(_)
                | ObjectSpec::Ruled(_)
        ) =>
        {
            blame_swept(spec, error)
        }
        _ if matches!(spec, ObjectSpec::Nurbs(_)) => blame_nurbs(error),
        E::RepeatedParameter { second, .. } => Blame::Entry("parameters", second),
        E::ParametersNotIncreasing { index, .. } if is_moebius => Blame::Entry("knots", index),
        E::NotFinite { what: I::Knot, index } if is_moebius => Blame::Entry("knots", index),
        E::NotFinite { what: I::Parameter, index } => Blame::Entry("parameters", index),
        E::CountDiffers { what: I::Knot, .. } if is_moebius => Blame::Field("knots"),
        E::CountDiffers { what: I::Parameter, .. } => Blame::Field(if is_moebius { "knots" } else { "parameters" }),
        E::CountDiffers { .. } | E::NotFinite { what: I::Tangent, .. } if is_qb => Blame::Field("derivatives"),
        E::ParameterOutOfRange { name: I::Parameter, .. } if is_qb => Blame::Field("parameters"),
        _ if spec.is_on_torus() => blame_torus(spec, error),
        _ if matches!(spec, ObjectSpec::PipeTee(_)) => blame_tee(error),
        _ if let ObjectSpec::PipeCrossing(spec) = spec => blame_crossing(spec, error),
        _ if let ObjectSpec::ContactBlend(spec) = spec => blame_contact(spec, error),
        _ if matches!(spec, ObjectSpec::Tube(_)) => blame_tube(spec, error),
        E::NotFinite { what: I::Tangent, index } | E::ZeroTangent { index } | E::TangentOpposesChord { index, .. } => {
            tangent(index)
        }
        E::NotFinite { what: I::Weight, index } | E::ZeroWeight { index } => Blame::Entry("weights", index),
        E::NotFinite { what: I::FrameVector, index } => Blame::Entry("frame", index),
        E::FrameNotOrthonormal { .. } => Blame::Field("frame"),
        E::NotConcircular { .. } | E::CrossingQuad { .. } if is_patch => Blame::Entry("corners", 3),
        E::NotFinite { what: I::Point, index } | E::CoincidentPoints { second: index, .. } if is_patch => {
            Blame::Entry("corners", index)
        }
        E::NotFinite { what: I::Tolerance, .. } | E::ToleranceNotPositive { .. } => Blame::Field("tolerance"),
        E::NotFinite { what: I::Bulge, .. } => Blame::Field("bulge"),
        E::NotInImH { .. } | E::PoleOnSegment { .. } => {
            Blame::Field(if matches!(spec, ObjectSpec::Arc(ArcSpec { bulge: Some(_), .. })) {
                "bulge"
            } else {
                "weights"
            })
        }
        E::RadiusNotPositive { .. } => Blame::Field("radius"),
        E::DegenerateCircle { .. } if matches!(spec, ObjectSpec::Circle(_)) => Blame::Field("through"),
        E::ZeroAxis { .. } if matches!(spec, ObjectSpec::Cyclide(_) | ObjectSpec::Revolution(_)) => {
            Blame::Field("axis")
        }
        E::AngleOutOfRange { .. } if matches!(spec, ObjectSpec::Revolution(_)) => Blame::Field("angle"),
        E::PipeTooWide { .. } | E::MitreDoesNotFit { .. } | E::PipeMeetsItself { .. } => Blame::Field("radius"),
        E::ParameterOutOfRange { name: name @ I::Wall, .. } => Blame::Field(name.word()),
        E::NotOfArcs { .. } | E::CellsUnfit { .. } => Blame::Field("of"),
        E::CountDiffers { what: I::Radius, .. } => Blame::Field("radius"),
        _ if matches!(spec, ObjectSpec::Revolution(_) | ObjectSpec::Pipe(_)) => Blame::Field("of"),
        E::ZeroAxis { .. } => Blame::Field("normal"),
        E::ParameterOutOfRange { name: I::SegmentsAlongS, .. } => Blame::Entry("segments", 0),
        E::ParameterOutOfRange { name: I::SegmentsAlongT, .. } => Blame::Entry("segments", 1),
        E::OrderOutOfRange { .. } => Blame::Field("order"),
        E::CountDiffers { .. } => Blame::Field("tangents"),
        E::ParameterOutOfRange { name: I::EdgePoints, .. } => Blame::Field("polyline"),
        E::ParameterOutOfRange { name, .. } => Blame::Field(name.word()),
        _ => error.index().map_or(Blame::Object, Blame::Point),
    }
}

/// As [`blame`], of tees.
fn blame_tee(error: &cyclide::Error) -> Blame {
    use cyclide::{Error as E, ErrorItem as I};
    match error {
        E::TeeBranchTooWide { branch, .. }
        | E::TeeBlendTooLarge { branch, .. }
        | E::TeeLawOnEqualPipes { branch, .. }
        | E::TeeBlendFolds { branch, .. }
        | E::TeeHoleFolds { branch, .. }
        | E::TeePipeTooShort { what: I::Branch, branch, .. } => Blame::Entry("branches", *branch),
        E::InBranch { branch, what, .. } => Blame::FieldOfEntry("branches", *branch, what.word()),
        E::TeePipeTooShort { .. }
        | E::PipeEndsReversed { .. }
        | E::RadiusNotPositive { .. }
        | E::ConeReachesApex { .. }
        | E::ParameterOutOfRange { name: I::Taper, .. }
        | E::NotFinite { what: I::Radius | I::Taper, .. } => Blame::Field("main"),
        E::TeeBranchesMeet { second, .. }
        | E::TeeBranchesTooNear { second, .. }
        | E::TeeEqualBranchesNotOpposite { second, .. }
        | E::TeeNoFreeLine { second, .. } => Blame::Entry("branches", *second),
        E::NotFinite { index, .. } => Blame::Entry("branches", *index),
        E::ParameterOutOfRange { name: name @ I::Wall, .. } => Blame::Field(name.word()),
        _ => Blame::Field("branches"),
    }
}

/// As [`blame`], of crossings of pipes.
fn blame_crossing(spec: &PipeCrossingSpec, error: &cyclide::Error) -> Blame {
    use cyclide::{Error as E, ErrorItem as I};
    match error {
        E::PipeEndsReversed { pipe, .. }
        | E::CrossingPipeTooShort { pipe, .. }
        | E::CrossingHoleTooWide { pipe, .. }
        | E::CrossingHoleTurnsBack { pipe, .. } => Blame::Entry("pipes", *pipe),
        E::NotFinite { what: I::Radius, index } if *index < 2 => Blame::Entry("pipes", *index),
        E::NotFinite { what: I::Taper, index } => Blame::Entry("pipes", *index),
        E::CrossingNeedsCylinders { what, .. } => Blame::Field(what.word()),
        E::AngleOutOfRange { .. } if spec.angle.is_some() => Blame::Field(I::Angle.word()),
        E::RadiusTooSmall { .. }
        | E::CrossingBallTooLarge { .. }
        | E::CoincidentPoints { .. }
        | E::TooFewPoints { .. }
        | E::BelowRoundingOfPlace { .. }
        | E::CrossingFolds { .. }
        | E::NotFinite { what: I::Radius, .. } => Blame::Field("blend"),
        E::RadiusNotPositive { .. } | E::ConeReachesApex { .. } => {
            match spec.pipes.iter().position(|pipe| !pipe.is_round_throughout(spec.wall)) {
                Some(pipe) => Blame::Entry("pipes", pipe),
                None => Blame::Field("blend"),
            }
        }
        E::CrossingAxesTooNear { .. }
        | E::CrossingPipesApart { .. }
        | E::NotTimelikePair { .. }
        | E::NotFinite { what: I::Distance, .. } => Blame::Field("distance"),
        E::ToleranceNotPositive { .. } | E::TooManyPieces { .. } => Blame::Field("tolerance"),
        E::ParameterOutOfRange { name: name @ (I::Wall | I::Angle), .. } => Blame::Field(name.word()),
        _ => Blame::Field("pipes"),
    }
}

/// As [`blame`], of blends of a tube or a ring with a sphere or a plate.
fn blame_contact(spec: &ContactBlendSpec, error: &cyclide::Error) -> Blame {
    use cyclide::{Error as E, ErrorItem as I};
    match error {
        E::NotFinite { what: I::Radius, index: 1 } | E::ContactBlendFolds { .. } | E::BallDoesNotFit { .. } => {
            Blame::Field("blend")
        }
        E::RadiusNotPositive { .. } if spec.tube.as_ref().is_none_or(|tube| tube.radius > 0.0) && spec.blend <= 0.0 => {
            Blame::Field("blend")
        }
        E::RadiusNotPositive { .. }
            if spec.tube.as_ref().is_none_or(|tube| tube.radius > 0.0)
                && spec.sphere.is_some_and(|sphere| sphere <= 0.0) =>
        {
            Blame::Field("sphere")
        }
        E::PlateTooSmall { .. } | E::RulingsCross { .. } => Blame::Field("plate"),
        E::ToleranceNotPositive { .. } | E::TooManyPieces { .. } => Blame::Field("tolerance"),
        E::ParameterOutOfRange { name: name @ (I::Wall | I::Thickness), .. } => Blame::Field(name.word()),
        _ => Blame::Field(if spec.ring.is_some() { "ring" } else { "tube" }),
    }
}

/// As [`blame`], of tubes.
fn blame_tube(spec: &ObjectSpec, error: &cyclide::Error) -> Blame {
    use cyclide::{Error as E, ErrorItem as I};
    let through = matches!(spec, ObjectSpec::Tube(TubeSpec { balls: Some(_), .. }));
    match error {
        E::ParameterOutOfRange { name: name @ (I::Wall | I::Tolerance), .. } => Blame::Field(name.word()),
        E::CornerNotMitred { .. } | E::ArcThroughInfinity { .. } => Blame::Field("of"),
        E::TubeRadiusVanishes { piece, .. } | E::TubeFolds { piece, .. } if through => Blame::Entry("balls", *piece),
        E::NotFinite { index, .. } if through => Blame::Entry("balls", *index),
        _ if through => error.index().map_or(Blame::Field("balls"), |index| Blame::Entry("balls", index)),
        _ => Blame::Field("radius"),
    }
}

/// Whether the distance of an offset is at fault, in the whole of it or in one of its quads.
fn is_of_distance(error: &cyclide::Error) -> bool {
    use cyclide::Error as E;
    match error {
        E::InQuad { cause, .. } => is_of_distance(cause),
        E::OffsetOnFocalSet { .. } | E::OffsetNotRegular { .. } | E::NotAShell { .. } => true,
        _ => false,
    }
}

/// As [`blame`], of necks, bridges and surfaces between two curves.
fn blame_swept(spec: &ObjectSpec, error: &cyclide::Error) -> Blame {
    use cyclide::{Error as E, ErrorItem as I};
    match (spec, error) {
        (_, E::ParameterOutOfRange { name: name @ (I::Height | I::Thickness | I::Wall | I::Depth), .. }) => {
            Blame::Field(name.word())
        }
        (ObjectSpec::PlateWithNeck(s), E::RadiusNotPositive { .. }) if s.pipe_radius <= 0.0 => {
            Blame::Field("pipe_radius")
        }
        (
            ObjectSpec::PlateWithNeck(_),
            E::RadiusNotPositive { .. } | E::BallDoesNotFit { .. } | E::NeckFolds { .. },
        ) => Blame::Field("ball_radius"),
        (ObjectSpec::PlateWithNeck(_), E::AngleOutOfRange { .. }) => Blame::Field("slope"),
        (ObjectSpec::PlateWithNeck(_), E::PlateTooSmall { .. }) => Blame::Field("plate"),
        (ObjectSpec::EllipseBridge(_), _) => Blame::Field("ellipses"),
        (ObjectSpec::CircularSurface(s), E::ZeroTangent { index }) if s.tangent.0.len() > 1 => {
            Blame::Entry("tangent", *index)
        }
        (
            ObjectSpec::CircularSurface(_),
            E::ZeroTangent { .. } | E::OppositeTangents { .. } | E::TangentOpposesChord { .. } | E::CountDiffers { .. },
        ) => Blame::Field("tangent"),
        (ObjectSpec::CircularSurface(_) | ObjectSpec::Ruled(_), _) => Blame::Field("rails"),
        _ => Blame::Object,
    }
}
