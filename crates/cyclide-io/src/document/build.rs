//! From objects of a document to the kernel's curves; what the kernel refuses is shown at its place.

use std::io;
use std::path::Path;

use cyclide::{Arc, Biarc, Circle, CurveObject, Item, Quat, Vec3, Warning};

use super::Document;
use super::construct::{Contour, ContourFacts, Made, arc_fit, arc_spline, circle_spline};
use super::coordinates::{Coordinates, Lists, PointFile, PointSource};
use super::locate::{Step, path_text, span_of};
use super::spec::{ArcSpec, ObjectSpec};
use crate::error::{Error, Result};
use crate::place::{Source, decode};
use crate::points::{PointColumns, PointList, merge_repeated, read_points};

/// An object made by its construction, with what is known about it besides its curves.
#[derive(Debug, Clone, PartialEq)]
pub struct BuiltObject {
    /// The object for the model.
    pub item: Item,
    /// One entry per contour.
    pub contours: Vec<ContourFacts>,
    /// What the user should know.
    pub remarks: Vec<Remark>,
}

/// A warning with its place in the input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Remark {
    /// Stable kebab-case name.
    pub reason: &'static str,
    /// Which contour, from 0, where it is about one.
    pub contour: Option<usize>,
    /// Which point (or the segment that starts there), from 0, as the input counts them.
    pub index: Option<usize>,
    /// `file:line` or the path in the document, where known.
    pub place: Option<String>,
    /// The sentence.
    pub message: String,
}

/// The points of an object and the text they stand in.
struct Points {
    lists: Vec<PointList>,
    /// The original index of each point, per contour.
    kept: Vec<Vec<usize>>,
    origin: Origin,
}

enum Origin {
    /// In the document, as a list or (nested) a list of lists.
    Document { nested: bool },
    /// In a file of its own: its name and text.
    File { name: String, text: String },
}

/// The value of an object that an error is about.
enum Blame {
    Field(&'static str),
    Entry(&'static str, usize),
    Point(usize),
    Object,
}

impl Document {
    /// Runs the construction of the object with this index. Files of points are looked up relative to `folder` and
    /// read by `read`.
    ///
    /// # Errors
    /// [`Error::Read`]; [`Error::Input`] at the point or field at fault; [`Error::Geometry`] if the document was not
    /// made from a text.
    ///
    /// # Panics
    /// If there is no object with this index.
    pub fn build_object(
        &self,
        index: usize,
        folder: &Path,
        read: &dyn Fn(&Path) -> io::Result<Vec<u8>>,
    ) -> Result<BuiltObject> {
        let (name, spec) = &self.objects[index];
        Builder { document: self, name, spec, folder, read, remarks: Vec::new(), warnings: Vec::new() }.build()
    }

    /// The files of points the document refers to, as it writes them.
    pub fn point_files(&self) -> impl Iterator<Item = &str> {
        self.objects.iter().filter_map(|(_, spec)| match spec.points() {
            Some(PointSource::File(file)) => Some(file.csv.as_str()),
            _ => None,
        })
    }
}

impl ObjectSpec {
    fn points(&self) -> Option<&PointSource> {
        match self {
            Self::ArcSpline(s) => Some(&s.points),
            Self::ArcFit(s) => Some(&s.points),
            Self::CircleSpline(s) => Some(&s.points),
            Self::Arc(_) | Self::Circle(_) | Self::Biarc(_) => None,
        }
    }
}

struct Builder<'a> {
    document: &'a Document,
    name: &'a str,
    spec: &'a ObjectSpec,
    folder: &'a Path,
    read: &'a dyn Fn(&Path) -> io::Result<Vec<u8>>,
    remarks: Vec<Remark>,
    warnings: Vec<(usize, Warning)>,
}

impl Builder<'_> {
    fn build(mut self) -> Result<BuiltObject> {
        let single = |curve: CurveObject| vec![(curve, ContourFacts::default())];
        let normal = |n: &Option<Coordinates>| n.map_or(Vec3::Z, Coordinates::vector);
        let made = match self.spec {
            ObjectSpec::Arc(s) => single(CurveObject::Arc(self.arc(s)?)),
            ObjectSpec::Circle(s) => {
                let circle = Circle::from_radius(s.center.point(), normal(&s.normal), s.radius);
                single(CurveObject::Circle(circle.map_err(|e| self.refused(&e, None))?))
            }
            ObjectSpec::Biarc(s) => {
                let (t0, t1) = (s.from_tangent.vector(), s.to_tangent.vector());
                let biarc = Biarc::new(s.from.point(), t0, s.to.point(), t1, s.rule.into());
                single(CurveObject::ArcPath(biarc.map_err(|e| self.refused(&e, None))?.to_path()))
            }
            ObjectSpec::ArcSpline(s) => self.each_contour(&s.points, s.closed, |at| arc_spline(s, at))?,
            ObjectSpec::ArcFit(s) => self.each_contour(&s.points, s.closed, |at| arc_fit(s, at))?,
            ObjectSpec::CircleSpline(s) => self.each_contour(&s.points, s.closed, |at| circle_spline(s, at))?,
        };
        let tolerance = if let ObjectSpec::ArcFit(s) = self.spec { Some(s.tolerance) } else { None };
        let (curves, contours) = made.into_iter().unzip();
        let (name, kind) = (self.name.to_owned(), self.spec.type_word().to_owned());
        let item = Item { name, kind, contours: curves, surfaces: Vec::new(), warnings: self.warnings, tolerance };
        Ok(BuiltObject { item, contours, remarks: self.remarks })
    }

    fn arc(&self, spec: &ArcSpec) -> Result<Arc> {
        let data = [spec.tangent.is_some(), spec.end_tangent.is_some(), spec.weights.is_some(), spec.bulge.is_some()];
        let given = data.into_iter().filter(|d| *d).count();
        if spec.normal.is_some() && spec.bulge.is_none() {
            return Err(self.unfit("`normal` goes with `bulge` only"));
        }
        let arc = match (spec.through, spec.from, spec.to) {
            (Some([a, b, c]), None, None) if given == 0 => Arc::from_three_points(a.point(), b.point(), c.point()),
            (None, Some(a), Some(b)) if given == 1 => {
                let (a, b) = (a.point(), b.point());
                if let Some(t) = spec.tangent {
                    Arc::from_start_tangent(a, b, t.vector())
                } else if let Some(t) = spec.end_tangent {
                    Arc::from_end_tangent(a, b, t.vector())
                } else if let Some([[w0, x0, y0, z0], [w1, x1, y1, z1]]) = spec.weights {
                    Arc::from_weights(a, b, Quat::new(w0, x0, y0, z0), Quat::new(w1, x1, y1, z1))
                } else {
                    let normal = spec.normal.map_or(Vec3::Z, Coordinates::vector);
                    Arc::from_bulge(a, b, normal, spec.bulge.unwrap_or_default())
                }
            }
            _ => {
                return Err(self.unfit(
                    "an arc is given by `through` (three points), or by `from` and `to` with exactly one of `tangent`, `end_tangent`, `weights`, `bulge`",
                ));
            }
        };
        arc.map_err(|e| self.refused(&e, None))
    }

    /// Reads the points, merges repeated ones and runs a construction on every contour.
    fn each_contour(
        &mut self,
        source: &PointSource,
        closed: bool,
        construct: impl Fn(&Contour<'_>) -> Made,
    ) -> Result<Vec<(CurveObject, ContourFacts)>> {
        let mut points = match source {
            PointSource::Inline(lists) => inline_points(lists),
            PointSource::File(file) => self.file_points(file)?,
        };
        let mut made = Vec::new();
        for contour in 0..points.lists.len() {
            let list = &mut points.lists[contour];
            if !closed && list.ends_meet() {
                let message =
                    "the last point repeats the first, but the curve is not closed: set `closed` if it is meant to be";
                let last = list.points.len() - 1;
                let place = self.place(&points, contour, last);
                self.remark("ends-meet", Some(contour), Some(last), Some(place), message.to_owned());
            }
            // Places are looked up in the list as given, so before the merge drops entries.
            let given_offsets = points.lists[contour].offsets.clone();
            let merged = merge_repeated(&mut points.lists[contour], closed);
            points.lists[contour].offsets = given_offsets;
            points.kept[contour] = merged.kept;
            for warning in merged.warnings {
                let index = warning.index();
                let place = index.map(|i| self.place(&points, contour, i));
                self.remark(warning.reason(), Some(contour), index, place, warning.to_string());
                self.warnings.push((contour, warning));
            }
            let at = Contour { index: contour, list: &points.lists[contour], kept: &points.kept[contour] };
            let (curve, facts, warnings) = construct(&at).map_err(|e| self.refused(&e, Some((&points, contour))))?;
            for warning in warnings {
                let index = warning.index().and_then(|i| points.kept[contour].get(i).copied());
                let place = index.map(|i| self.place(&points, contour, i));
                self.remark(warning.reason(), Some(contour), index, place, warning.to_string());
                self.warnings.push((contour, warning));
            }
            made.push((curve, facts));
        }
        Ok(made)
    }

    fn file_points(&mut self, file: &PointFile) -> Result<Points> {
        let path = self.folder.join(&file.csv);
        let bytes = (self.read)(&path).map_err(|source| Error::Read { path: path.clone(), source })?;
        let name = path.display().to_string();
        let columns = PointColumns { coordinates: file.columns.clone(), contour: file.contour.clone() };
        let table = read_points(&name, &bytes, &columns)?;
        let units = self.document.units;
        let mut other = table.unit_hints.iter().filter(|(_, hint)| *hint != units);
        let names: Vec<&str> = other.clone().map(|(name, _)| name.as_str()).collect();
        if let Some((_, hint)) = other.next() {
            let message = format!(
                "the columns {} speak of {}, the model says {}; coordinates are taken as they are",
                names.join(", "),
                hint.symbol(),
                units.symbol()
            );
            self.remark("units-differ", None, None, Some(name.clone()), message);
        }
        let text = decode(&name, &bytes)?.to_owned();
        let kept = vec![Vec::new(); table.contours.len()];
        Ok(Points { lists: table.contours, kept, origin: Origin::File { name, text } })
    }

    fn remark(
        &mut self,
        reason: &'static str,
        contour: Option<usize>,
        index: Option<usize>,
        place: Option<String>,
        message: String,
    ) {
        self.remarks.push(Remark { reason, contour, index, place, message });
    }

    /// Path of this object, or of a value in it.
    fn path(&self, steps: impl IntoIterator<Item = Step>) -> Vec<Step> {
        [Step::from("objects"), Step::from(self.name)].into_iter().chain(steps).collect()
    }

    /// Where a point stands, by its index in the list as given.
    fn place(&self, points: &Points, contour: usize, index: usize) -> String {
        match &points.origin {
            Origin::Document { nested } => path_text(&self.path(point_steps(*nested, contour, Some(index)))),
            Origin::File { name, text } => {
                let offset = points.lists[contour].offsets.get(index).copied().unwrap_or_default();
                format!("{name}:{}", Source { name, text }.line_of(offset))
            }
        }
    }

    /// The message that the object's fields do not fit together.
    fn unfit(&self, message: &str) -> Error {
        let path = self.path([]);
        let span = span_of(&self.document.text, &path).map_or(0..0, |s| s.start..s.start + 1);
        Error::Input(self.document.source().diagnostic(span, &path_text(&path), message))
    }

    /// What the kernel said; it counts points after repeated ones were merged, which is said where the number matters.
    fn words(&self, error: &cyclide::Error, contour: usize) -> String {
        let merged = |(c, w): &(usize, Warning)| {
            *c == contour && matches!(w, Warning::PointsMerged { .. } | Warning::ClosingPointMerged { .. })
        };
        match error {
            cyclide::Error::TooFewPoints { .. } if self.warnings.iter().any(merged) => {
                format!("{error} (repeated points count once)")
            }
            _ => error.to_string(),
        }
    }

    /// The message for what the kernel said, at the point or field it is about.
    fn refused(&self, error: &cyclide::Error, from: Option<(&Points, usize)>) -> Error {
        let blame = blame(self.spec, error);
        let original = |k: usize| from.and_then(|(p, c)| p.kept[c].get(k).copied()).unwrap_or(k);
        let path = self.path([]);
        if let Some((points, contour)) = from
            && let Origin::File { name, text } = &points.origin
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
        let document = &self.document.text;
        if document.is_empty() {
            return Error::Geometry { object: self.name.to_owned(), source: error.clone() };
        }
        let nested = |points: &Points| matches!(points.origin, Origin::Document { nested: true });
        let in_points = |k: Option<usize>| from.map(|(p, c)| self.path(point_steps(nested(p), c, k)));
        let candidates = match blame {
            Blame::Field(field) => vec![self.path([field.into()])],
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
        let (path, span) = candidates.iter().find_map(place).unwrap_or_else(|| {
            let start = span_of(document, &path).map_or(0, |s| s.start);
            (path, start..start + 1)
        });
        let words = self.words(error, from.map_or(0, |(_, contour)| contour));
        let message = self.document.source().diagnostic(span, &path_text(&path), words);
        Error::Input(message.with_reason(error.reason()))
    }
}

/// The path of a point below its object.
fn point_steps(nested: bool, contour: usize, index: Option<usize>) -> Vec<Step> {
    let contour = nested.then_some(Step::Index(contour));
    [Step::from("points")].into_iter().chain(contour).chain(index.map(Step::Index)).collect()
}

fn inline_points(source: &Lists) -> Points {
    let list = |points: &Vec<Coordinates>| PointList {
        points: points.iter().map(|p| p.point()).collect(),
        ..PointList::default()
    };
    // An empty list is one contour without points, for the kernel to refuse.
    let lists =
        if source.lists.is_empty() { vec![PointList::default()] } else { source.lists.iter().map(list).collect() };
    Points { kept: vec![Vec::new(); lists.len()], lists, origin: Origin::Document { nested: source.nested } }
}

/// Which value of an object an error of the kernel is about.
fn blame(spec: &ObjectSpec, error: &cyclide::Error) -> Blame {
    use cyclide::Error as E;
    let tangent = |index: usize| match (spec, index) {
        (ObjectSpec::Arc(s), _) => Blame::Field(if s.tangent.is_some() { "tangent" } else { "end_tangent" }),
        (ObjectSpec::Biarc(_), 0) => Blame::Field("from_tangent"),
        (ObjectSpec::Biarc(_), _) => Blame::Field("to_tangent"),
        (ObjectSpec::CircleSpline(_), 0) => Blame::Field("ends"),
        (ObjectSpec::CircleSpline(_), _) => Blame::Field("ends"),
        _ => Blame::Entry("tangents", index),
    };
    match *error {
        E::NotFinite { what: "tangent", index } | E::ZeroTangent { index } | E::TangentOpposesChord { index } => {
            tangent(index)
        }
        E::NotFinite { what: "weight", index } | E::ZeroWeight { index } => Blame::Entry("weights", index),
        E::NotFinite { what: "tolerance", .. } | E::ToleranceNotPositive { .. } => Blame::Field("tolerance"),
        E::NotFinite { what: "bulge", .. } => Blame::Field("bulge"),
        E::NotInImH { .. } | E::PoleOnSegment { .. } => {
            Blame::Field(if matches!(spec, ObjectSpec::Arc(ArcSpec { bulge: Some(_), .. })) {
                "bulge"
            } else {
                "weights"
            })
        }
        E::RadiusNotPositive { .. } => Blame::Field("radius"),
        E::ZeroAxis => Blame::Field("normal"),
        E::OrderOutOfRange { .. } => Blame::Field("order"),
        E::TangentCount { .. } => Blame::Field("tangents"),
        E::ParameterOutOfRange { name, .. } => Blame::Field(name),
        _ => error.index().map_or(Blame::Object, Blame::Point),
    }
}
