//! What the kernel refused, shown at the point or field it is about.

use cyclide::{
    Point3, ShortNumber, Warning,
    error::{
        ArcError, CurveError, ErrorItem, GridError, InterpolationError, NumberError, PatchError, PipeError, PointError,
    },
    warning::PointWarning,
};

use super::kind::Blame;
use crate::document::angle::Angle;
use crate::document::locate::{Step, path_text, span_of};
use crate::document::objects::Builder;
use crate::document::objects::kind::Kind;
use crate::document::objects::points::{Origin, Points};
use crate::document::objects::remark::Remark;
use crate::error::hints::words_of;
use crate::error::{Error, of_contour};
use crate::text::place::Source;

impl Builder<'_> {
    /// What the kernel said; it counts points after repeated ones were merged, which is said where the number matters.
    fn words(&self, error: &cyclide::Error, contour: usize) -> String {
        let merged = |remark: &Remark| {
            let merges = |w: &Warning| {
                matches!(w, Warning::Point(PointWarning::PointsMerged { .. } | PointWarning::ClosingPointMerged { .. }))
            };
            remark.contour == Some(contour) && remark.warning.as_ref().is_some_and(merges)
        };
        match error {
            cyclide::Error::Point(PointError::TooFewPoints { .. }) if self.remarks.iter().any(merged) => {
                format!("{error} (repeated points count once)")
            }
            cyclide::Error::Number(NumberError::ParameterOutOfRange {
                name: ErrorItem::CornerAngle, value, ..
            }) => {
                let written = self.kind.corner_angle();
                written.map_or_else(|| words_of(error), |angle| corner_angle_words(angle, *value))
            }
            _ => self.kind.words(error).unwrap_or_else(|| words_of(error)),
        }
    }

    /// The message for what the kernel said about the value at a path below the object.
    pub(in crate::document) fn refused_at(
        &self,
        steps: impl IntoIterator<Item = Step>,
        error: &cyclide::Error,
    ) -> Error {
        if self.document.text.is_empty() {
            return Error::Geometry { object: self.name.to_owned(), contour: None, source: error.clone() };
        }
        self.refused_in_words(steps, error.reason(), words_of(error))
    }

    /// As [`refused_at`](Self::refused_at), in other words.
    pub(in crate::document) fn refused_in_words(
        &self,
        steps: impl IntoIterator<Item = Step>,
        reason: &'static str,
        words: String,
    ) -> Error {
        Error::Input(self.diagnostic(steps, &words).with_reason(reason))
    }

    /// The message for what the kernel said, at the point or field it is about.
    pub(in crate::document) fn refused(&self, error: &cyclide::Error, from: Option<(&Points, usize)>) -> Error {
        let blame = match from.and_then(|(points, contour)| too_far_out(error, &points.lists[contour].points)) {
            Some(point) => Blame::Point(point),
            None => blame(self.kind, error),
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

/// Degrees are taken for radians now and then: what was written, and what may be meant.
fn corner_angle_words(angle: Angle, radians: f64) -> String {
    match angle {
        Angle::Degrees(degrees) => format!("a corner angle of {degrees} degrees is outside 0 to 180"),
        Angle::Radians(_) if radians > 180.0 || radians <= 0.0 => format!(
            "a corner angle of {radians} radians is outside 0 to 3.1416 (half a turn; degrees are written `{{\"degrees\": 30}}`)"
        ),
        Angle::Radians(_) => format!(
            "a corner angle of {radians} radians exceeds half a turn (3.1416): for degrees, write `{{\"degrees\": {radians}}}` or {}",
            ShortNumber(radians.to_radians())
        ),
    }
}

/// The point that a refused coordinate belongs to: the one that is farthest out.
fn too_far_out(error: &cyclide::Error, points: &[Point3]) -> Option<usize> {
    let cyclide::Error::Number(NumberError::ParameterOutOfRange { name: ErrorItem::Coordinate, value, .. }) = *error
    else {
        return None;
    };
    points.iter().position(|p| p.to_vec().max_abs() >= value.abs())
}

/// Which value of an object an error of the kernel is about.
pub(in crate::document) fn blame(kind: &dyn Kind, error: &cyclide::Error) -> Blame {
    kind.blame(error).or_else(|| blame_by_word(error)).or_else(|| kind.blame_otherwise()).unwrap_or_else(|| {
        use cyclide::{Error as E, error::ErrorItem as I};
        match *error {
            E::Point(PointError::ZeroAxis { .. }) => Blame::Field("normal"),
            E::Number(NumberError::ParameterOutOfRange { name: I::SegmentsAlongS, .. }) => Blame::Entry("segments", 0),
            E::Number(NumberError::ParameterOutOfRange { name: I::SegmentsAlongT, .. }) => Blame::Entry("segments", 1),
            E::Number(NumberError::OrderOutOfRange { .. }) => Blame::Field("order"),
            E::Number(NumberError::CountDiffers { .. }) => Blame::Field("tangents"),
            E::Number(NumberError::ParameterOutOfRange { name: I::EdgePoints, .. }) => Blame::Field("polyline"),
            E::Number(NumberError::ParameterOutOfRange { name, .. }) => Blame::Field(name.word()),
            _ => error.index().map_or(Blame::Object, Blame::Point),
        }
    })
}

/// The value that an error is about by what it names, whatever the kind.
fn blame_by_word(error: &cyclide::Error) -> Option<Blame> {
    use cyclide::{Error as E, error::ErrorItem as I};
    Some(match *error {
        E::Interpolation(InterpolationError::RepeatedParameter { second, .. }) => Blame::Entry("parameters", second),
        E::Number(NumberError::NotFinite { what: I::Parameter, index }) => Blame::Entry("parameters", index),
        E::Number(NumberError::CountDiffers { what: I::Parameter, .. }) => Blame::Field("parameters"),
        E::Number(NumberError::NotFinite { what: I::Tangent, index })
        | E::Point(PointError::ZeroTangent { index })
        | E::Arc(ArcError::TangentOpposesChord { index, .. }) => Blame::Entry("tangents", index),
        E::Number(NumberError::NotFinite { what: I::Weight, index }) | E::Arc(ArcError::ZeroWeight { index }) => {
            Blame::Entry("weights", index)
        }
        E::Number(NumberError::NotFinite { what: I::FrameVector, index }) => Blame::Entry("frame", index),
        E::Patch(PatchError::FrameNotOrthonormal { .. }) => Blame::Field("frame"),
        E::Number(NumberError::NotFinite { what: I::Tolerance, .. } | NumberError::ToleranceNotPositive { .. }) => {
            Blame::Field("tolerance")
        }
        E::Number(NumberError::NotFinite { what: I::Bulge, .. }) => Blame::Field("bulge"),
        E::Arc(ArcError::NotInImH { .. } | ArcError::PoleOnSegment { .. }) => Blame::Field("weights"),
        E::Number(NumberError::RadiusNotPositive { .. }) => Blame::Field("radius"),
        E::Pipe(PipeError::TooWide { .. } | PipeError::MitreDoesNotFit { .. } | PipeError::MeetsItself { .. }) => {
            Blame::Field("radius")
        }
        E::Number(NumberError::ParameterOutOfRange { name: name @ I::Wall, .. }) => Blame::Field(name.word()),
        E::Curve(CurveError::NotOfArcs { .. }) | E::Grid(GridError::CellsUnfit { .. }) => Blame::Field("of"),
        E::Number(NumberError::CountDiffers { what: I::Radius, .. }) => Blame::Field("radius"),
        _ => return None,
    })
}

/// Sizes that are fields of their own.
pub(in crate::document) fn blame_size(error: &cyclide::Error) -> Option<Blame> {
    use cyclide::{Error as E, error::ErrorItem as I};
    match error {
        E::Number(NumberError::ParameterOutOfRange {
            name: name @ (I::Height | I::Thickness | I::Wall | I::Depth),
            ..
        }) => Some(Blame::Field(name.word())),
        _ => None,
    }
}

/// Directions of a curve with `ends`.
pub(in crate::document) fn blame_ends(error: &cyclide::Error) -> Option<Blame> {
    use cyclide::{Error as E, error::ErrorItem as I};
    let is_tangent = matches!(
        error,
        E::Number(NumberError::NotFinite { what: I::Tangent, .. })
            | E::Point(PointError::ZeroTangent { .. })
            | E::Arc(ArcError::TangentOpposesChord { .. })
    );
    is_tangent.then_some(Blame::Field("ends"))
}
