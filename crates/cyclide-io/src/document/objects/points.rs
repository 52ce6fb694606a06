//! The points of an object: read, merged, and handed to its construction contour by contour.

use cyclide::{
    Warning,
    model::{CurveObject, Units},
    warning::CurveWarning,
};

use crate::document::coordinates::{Coordinates, Lists, PointFile, PointSource};
use crate::document::locate::{Step, path_text};
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, ContourFacts, Made};
use crate::document::objects::idle::{Idle, NO_EFFECT};
use crate::document::objects::remark::Remark;
use crate::error::{Error, Result};
use crate::formats::InputKind;
use crate::input::points::{Merged, PointColumns, PointList, UNITS_ASSUMED, merge_repeated, read_points};
use crate::text::encoding::decode_table;
use crate::text::lines::LineStarts;
use crate::text::place::quoted;

/// The field that most points stand in.
const POINTS: &[&str] = &["points"];

/// The points of an object and the text they stand in.
pub(in crate::document) struct Points {
    pub(in crate::document) lists: Vec<PointList>,
    /// The original index of each point, per contour.
    pub(in crate::document) kept: Vec<Vec<usize>>,
    pub(in crate::document) origin: Origin,
}

pub(in crate::document) enum Origin {
    /// In the document, as a list or (nested) a list of lists, in a field.
    Document { nested: bool, field: &'static [&'static str] },
    /// In a file of its own: its name, its text, and where the lines of it start.
    File { name: String, text: String, lines: LineStarts },
}

impl Points {
    /// The path below the object of a list, or of a point of it.
    pub(in crate::document) fn steps(&self, contour: usize, index: Option<usize>) -> Vec<Step> {
        let (nested, field) = match &self.origin {
            Origin::Document { nested, field } => (*nested, *field),
            Origin::File { .. } => (false, POINTS),
        };
        let contour = nested.then_some(Step::Index(contour));
        field.iter().copied().map(Step::from).chain(contour).chain(index.map(Step::Index)).collect()
    }
}

impl Builder<'_> {
    /// Reads the points, merges repeated ones and runs a construction on every contour.
    pub(in crate::document) fn each_contour(
        &mut self,
        source: &PointSource,
        closed: bool,
        construct: impl Fn(&Contour<'_>) -> Made,
    ) -> Result<Vec<(CurveObject, ContourFacts)>> {
        let points = match source {
            PointSource::Inline(lists) => inline_points(lists),
            PointSource::File(file) => self.file_points(file)?,
        };
        self.each_contour_of(points, closed, construct)
    }

    /// The same of points that have been read.
    pub(in crate::document) fn each_contour_of(
        &mut self,
        mut points: Points,
        closed: bool,
        construct: impl Fn(&Contour<'_>) -> Made,
    ) -> Result<Vec<(CurveObject, ContourFacts)>> {
        let mut made = Vec::new();
        let mut idle: Option<Vec<Idle>> = None;
        for contour in 0..points.lists.len() {
            let list = &mut points.lists[contour];
            let meet = if closed || self.kind.keeps_repeated_points() {
                None
            } else if list.ends_meet() {
                Some("the last point repeats the first, but the curve is not closed: set `closed` if it should be")
            } else if list.ends_are_neighbors() {
                Some(
                    "the last point is as close to the first as neighboring points are, but the curve is not closed: \
                     set `closed` if it should be",
                )
            } else {
                None
            };
            if let Some(message) = meet {
                let last = list.points.len() - 1;
                let place = self.place(&points, contour, last);
                self.remark("ends-meet", Some(contour), Some(last), Some(place), message.to_owned());
            }
            // Places are looked up in the list as given, so before the merge drops entries.
            let given_offsets = points.lists[contour].offsets.clone();
            let given_labels = points.lists[contour].labels.clone();
            let merged = if self.kind.keeps_repeated_points() {
                Merged::nothing(&points.lists[contour])
            } else {
                merge_repeated(&mut points.lists[contour], closed)
            };
            points.lists[contour].offsets = given_offsets;
            points.lists[contour].labels = given_labels;
            points.kept[contour] = merged.kept;
            for warning in merged.warnings {
                let index = warning.index();
                let place = index.map(|i| self.place(&points, contour, i));
                self.remarks.push(Remark { contour: Some(contour), index, place, ..warning.into() });
            }
            let at = Contour { index: contour, list: &points.lists[contour], kept: &points.kept[contour] };
            let made_of_points = construct(&at).map_err(|e| self.refused(&e, Some((&points, contour))))?;
            let (curve, facts, mut warnings) = made_of_points;
            // A field that one contour needs has an effect.
            let here = self.kind.idle_fields(&at, &curve);
            idle =
                Some(idle.map_or(here.clone(), |all| all.into_iter().filter(|field| here.contains(field)).collect()));
            if let Some(rule) = self.kind.wavers() {
                warnings.extend(rule.warnings(&curve, &at.list.points));
            }
            let marked = at.list.corners.len();
            if let Some(first) = at.list.corners.first().filter(|_| !self.kind.keeps_corners()) {
                let given = points.kept[contour].get(*first).copied();
                let place = given.map(|i| self.place(&points, contour, i));
                let message = format!(
                    "{marked} {} marked as corners, which this kind of curve does not support; `fair-spline`, \
                     `circle-spline`, `moebius-spline`, `arc-fit` and `fair-fit` do",
                    if marked == 1 { "point is" } else { "points are" }
                );
                self.remark(NO_EFFECT, Some(contour), given, place, message);
            }
            // Said once, with the place of the field.
            warnings.retain(|warning| *warning != Warning::Curve(CurveWarning::EndsWithoutEffect));
            for warning in warnings {
                let index = warning.index().and_then(|i| points.kept[contour].get(i).copied());
                let place = index.map(|i| self.place(&points, contour, i));
                self.remarks.push(Remark { contour: Some(contour), index, place, ..warning.into() });
            }
            self.take_point_names(&points, contour);
            if facts.fit.is_some() {
                self.data.extend_from_slice(&points.lists[contour].points);
            }
            made.push((curve, facts));
        }
        self.remark_on_idle(idle.unwrap_or_default());
        Ok(made)
    }

    /// Keeps what the points of a contour are called.
    fn take_point_names(&mut self, points: &Points, contour: usize) {
        let Origin::File { text, .. } = &points.origin else { return };
        let list = &points.lists[contour];
        let name = |given: &usize| list.labels.get(*given).and_then(|range| text.get(range.clone()));
        let named = list.points.iter().zip(&points.kept[contour]).filter_map(|(point, given)| {
            let name = name(given).filter(|name| !name.is_empty())?;
            Some((*point, quoted(name).into_owned()))
        });
        self.point_names.extend(named);
    }

    pub(in crate::document) fn file_points(&mut self, file: &PointFile) -> Result<Points> {
        let (name, bytes) = self.file(&file.csv, ["points", "csv"])?;
        if file.columns.is_none()
            && let Some(found) = InputKind::of_bytes(&bytes).filter(|found| *found != InputKind::Points)
        {
            let place = match found {
                InputKind::Mesh => {
                    ": use it in the field `grid` of a `cyclidic-net`, or `mesh` of a `smooth-mesh` or `smooth-polyhedron`"
                }
                InputKind::PolygonMesh => ": use it in the field `mesh` of a `smooth-mesh` or `smooth-polyhedron`",
                InputKind::PointGrid => {
                    ": a `cyclidic-net` reads it as a mesh (OBJ); select `columns` if it is a curve"
                }
                InputKind::PointsJson => ": write it into the document, as `points`",
                _ => "",
            };
            let message = format!("{name} is {}, not a list of points{place}", found.name());
            return Err(Error::Input(self.diagnostic(["points".into(), "csv".into()], &message)));
        }
        let columns = PointColumns { coordinates: file.columns.clone(), contour: file.contour.clone() };
        let table = read_points(&name, &bytes, &columns)?;
        self.remark_units(&name, &table.unit_hints);
        let assumed = self.document.units_assumed && self.document.units == Units::Millimetre;
        for remark in table.remarks.into_iter().filter(|remark| assumed || remark.reason != UNITS_ASSUMED) {
            self.remark(remark.reason, None, None, Some(name.clone()), remark.message);
        }
        self.note_all(&name, &table.notes);
        let text = decode_table(&name, &bytes)?.text.into_owned();
        let lines = LineStarts::new(&text);
        let kept = vec![Vec::new(); table.contours.len()];
        Ok(Points { lists: table.contours, kept, origin: Origin::File { name, text, lines } })
    }

    /// Where a point stands, by its index in the list as given.
    fn place(&self, points: &Points, contour: usize, index: usize) -> String {
        match &points.origin {
            Origin::Document { .. } => path_text(&self.path(points.steps(contour, Some(index)))),
            Origin::File { name, text, lines } => {
                let list = &points.lists[contour];
                let offset = list.offsets.get(index).copied().unwrap_or_default();
                // As the person calls it.
                let label =
                    list.labels.get(index).and_then(|range| text.get(range.clone())).filter(|label| !label.is_empty());
                let label = label.map(|label| format!(" (`{}`)", quoted(label))).unwrap_or_default();
                format!("{name}:{}{label}", lines.line_of(offset))
            }
        }
    }
}

pub(in crate::document) fn inline_points(source: &Lists) -> Points {
    let list = |points: &Vec<Coordinates>| PointList {
        points: points.iter().map(|p| p.point()).collect(),
        ..PointList::default()
    };
    // An empty list is one contour without points, for the kernel to refuse.
    let lists =
        if source.lists.is_empty() { vec![PointList::default()] } else { source.lists.iter().map(list).collect() };
    let origin = Origin::Document { nested: source.nested, field: POINTS };
    Points { kept: vec![Vec::new(); lists.len()], lists, origin }
}
