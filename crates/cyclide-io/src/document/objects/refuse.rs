//! What the kernel refused, shown at the point or field it is about.

use cyclide::{
    Point3, ShortNumber, Warning,
    error::{ErrorItem, FieldPath, NumberError, PointError},
    warning::PointWarning,
};

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
        let at = match from.and_then(|(points, contour)| too_far_out(error, &points.lists[contour].points)) {
            Some(point) => FieldPath { index: Some(point), ..FieldPath::default() },
            None => path_in_document(self.kind, error),
        };
        let original = |k: usize| from.and_then(|(p, c)| p.kept[c].get(k).copied()).unwrap_or(k);
        let path = self.path([]);
        if let Some((points, contour)) = from
            && let Origin::File { name, text, .. } = &points.origin
            && at.field.is_none()
        {
            let index = at.index.map_or(0, original);
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
        let candidates = self.candidates(at, from, original);
        let place = |p: &Vec<Step>| span_of(document, p).map(|span| (p.clone(), span));
        // A value that all contours share does not tell which of them it does not fit.
        let own_entry = at.index.is_some() && candidates.first().is_some_and(|first| place(first).is_some());
        let (path, span) = candidates.iter().find_map(place).unwrap_or_else(|| {
            let start = span_of(document, &path).map_or(0, |s| s.start);
            (path, start..start + 1)
        });
        let words = self.words(error, from.map_or(0, |(_, contour)| contour));
        let words = of_contour(of_several.filter(|_| at.field.is_some() && !own_entry)) + &words;
        let message = self.document.source().diagnostic(span, &path_text(&path), words);
        Error::Input(message.with_reason(error.reason()))
    }

    /// The paths of an error in the document, the most exact one first.
    fn candidates(
        &self,
        at: FieldPath,
        from: Option<(&Points, usize)>,
        original: impl Fn(usize) -> usize,
    ) -> Vec<Vec<Step>> {
        let in_points = |k: Option<usize>| from.map(|(points, contour)| self.path(points.steps(contour, k)));
        let main = || self.kind.fields().into_iter().find(|(path, _)| path.trim_end_matches("[]").is_empty());
        let main = || main().map(|(_, field)| self.path([field.into()]));
        match (at, at.field) {
            (FieldPath { part: Some((list, entry)), .. }, field) => {
                let entry = [list.into(), entry.into()];
                let field = field.map(|field| self.path(entry.iter().cloned().chain([field.into()])));
                field.into_iter().chain([self.path(entry)]).collect()
            }
            (FieldPath { index: Some(k), .. }, Some(field)) => {
                let contour = from.map_or(0, |(_, contour)| contour);
                let one = self.path([field.into(), original(k).into()]);
                let several = self.path([field.into(), contour.into(), original(k).into()]);
                // A list of lists also has an entry at the first path: the deeper one is meant.
                let is_nested = |points: &Points| matches!(points.origin, Origin::Document { nested: true, .. });
                let is_deep = from.is_some_and(|(points, _)| points.lists.len() > 1 || is_nested(points));
                let of_field = if is_deep { [several, one] } else { [one, self.path([field.into()])] };
                of_field.into_iter().chain(main()).collect()
            }
            (_, Some(field)) => [self.path([field.into()])].into_iter().chain(main()).collect(),
            (FieldPath { index: Some(k), .. }, None) => {
                let end = if k == 0 { "from" } else { "to" };
                let fixed = [self.path(["through".into(), k.into()]), self.path([end.into()])];
                in_points(Some(original(k))).into_iter().chain(fixed).collect()
            }
            (_, None) => in_points(None).into_iter().collect(),
        }
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

/// Where in the document of a kind an error of the kernel is, as far as the kernel or the kind knows it.
pub(in crate::document) fn path_in_document(kind: &dyn Kind, error: &cyclide::Error) -> FieldPath {
    let path = error.path();
    if path.part.is_some() {
        return path;
    }
    let names = kind.fields();
    let named = |key: &str| names.iter().find(|(own, _)| *own == key).map(|(_, field)| *field);
    let field = path.field.unwrap_or_default();
    let entry = path.index.and_then(|index| named(&format!("{field}[{index}]")));
    match (entry.or_else(|| named(&format!("{field}[]"))), named(field)) {
        (Some(field), _) => FieldPath { field: Some(field), ..FieldPath::default() },
        (None, Some(field)) => FieldPath { field: Some(field), ..path },
        (None, None) => path,
    }
}
