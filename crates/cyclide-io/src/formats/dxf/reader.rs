//! Our own DXF back from the bytes.

use super::plane::Ocs;
use super::skeleton::{GROUPS, unit_codes, version_code};
use super::tags::{Tag, parse};
use super::{GROUP, LAYER, LAYER_OF, labels};
use crate::check::file_content::FileContent;
use crate::check::labels::{FileLabels, FileName, push_counted};
use crate::check::read_error::ReadError;
use crate::export::options::DxfVersion;
use cyclide::{
    Point3, Vec3,
    curve::{Arc, ArcPath, ParamCurve as _},
    model::{ChainPiece, CurveChain, Model, Units},
    rational::NurbsCurve,
};
use std::collections::HashMap;

/// Gap allowed between entities of one curve, relative to its largest coordinate or radius: the rounding of center
/// plus radius.
const GAP: f64 = 1e-9;

/// A file as it is read.
#[derive(Default)]
pub(crate) struct Drawing {
    /// The curves in file order.
    pub(super) curves: Vec<Drawn>,
    /// The table of layers.
    pub(super) layers: Vec<String>,
    /// The groups with the numbers of their entities.
    groups: Vec<FileName>,
    /// Length of a unit, millimeters.
    pub(super) unit: Option<f64>,
    /// The lettering in file order.
    pub(super) letters: Vec<ReadLettering>,
    /// The version, if it is one of ours.
    version: Option<DxfVersion>,
}

/// A line of lettering as it is read.
pub(super) struct ReadLettering {
    pub(super) text: String,
    pub(super) layer: String,
    pub(super) height: f64,
    pub(super) at: Point3,
    place: String,
}

/// A curve as it is read.
#[derive(Clone)]
pub(super) struct Drawn {
    pub(super) chain: CurveChain,
    pub(super) layer: String,
    /// True if it is a polyline, not a number of single entities.
    polyline: bool,
}

/// The OBJECTS section as far as it is about groups.
#[derive(Default)]
struct Groups<'a> {
    /// Names with handles.
    names: Vec<(&'a str, &'a str)>,
    /// Members by handle.
    members: HashMap<&'a str, Vec<&'a str>>,
}

impl<'a> Groups<'a> {
    fn object(&mut self, object: &Entity<'a>) {
        let handle = object.text(5).unwrap_or_default();
        let all = |code: u16| object.tags.iter().filter(move |tag| tag.code == code).map(|tag| tag.value);
        match object.name() {
            "DICTIONARY" if usize::from_str_radix(handle, 16) == Ok(GROUPS) => self.names.extend(all(3).zip(all(350))),
            "GROUP" => drop(self.members.insert(handle, all(340).collect())),
            _ => {}
        }
    }

    /// The names with the numbers of members, which are the entities that say so.
    fn names(&self, said: &HashMap<&str, Vec<&str>>) -> Result<Vec<FileName>, ReadError> {
        if *said != self.members {
            let detail = "the members of the groups differ from the entities that name these groups";
            return Err(ReadError::syntax("the section OBJECTS", detail));
        }
        let members = |handle: &str| self.members.get(handle).map_or(0, Vec::len);
        Ok(self.names.iter().map(|(name, handle)| FileName::new(GROUP, *name, members(handle))).collect())
    }
}

/// Reads the file of a model: unit, layers, groups and the curves of the ENTITIES section.
pub(crate) fn read(bytes: &[u8]) -> Result<Drawing, ReadError> {
    let drawing = parsed(bytes)?;
    match drawing.letters.first() {
        Some(letters) => Err(ReadError::unsupported("TEXT", letters.place.clone())),
        None => Ok(drawing),
    }
}

/// Reads a file of a model or a sheet, with its lettering.
pub(super) fn parsed(bytes: &[u8]) -> Result<Drawing, ReadError> {
    let tags = parse(bytes)?;
    let mut section = None;
    let mut drawing = Drawing::default();
    let mut curves = Curves::default();
    let mut groups = Groups::default();
    let mut at = 0;
    while at < tags.len() {
        let length = 1 + tags[at + 1..].iter().take_while(|t| t.code != 0).count();
        let entity = Entity { tags: &tags[at..at + length] };
        at += length;
        match (tags[at - length].code, entity.name()) {
            (0, "SECTION") => {
                section = entity.text(2);
                if section == Some("HEADER") {
                    drawing.header(&entity)?;
                }
            }
            (0, "ENDSEC") => section = None,
            (0, "LAYER") if section == Some("TABLES") => {
                drawing.layers.push(entity.text(2).unwrap_or_default().to_owned());
            }
            (0, "TEXT") if section == Some("ENTITIES") => drawing.letters.push(ReadLettering {
                text: entity.text(1).unwrap_or_default().to_owned(),
                layer: entity.layer(),
                height: entity.real(40)?,
                at: entity.point(11)?,
                place: entity.place(),
            }),
            (0, _) if section == Some("ENTITIES") => curves.entity(&entity)?,
            (0, _) if section == Some("OBJECTS") => groups.object(&entity),
            _ => {}
        }
    }
    curves.finish()?;
    drawing.groups = groups.names(&curves.members)?;
    drawing.curves = curves.drawn;
    Ok(drawing)
}

impl Drawing {
    /// Version and unit of the header, whose variables stand in one block.
    fn header(&mut self, header: &Entity<'_>) -> Result<(), ReadError> {
        let variable = |name: &str| {
            let at = header.tags.iter().position(|t| t.code == 9 && t.value == name)?;
            header.tags.get(at + 1)
        };
        let code = variable("$ACADVER").map(|t| t.value);
        self.version = [DxfVersion::R2000, DxfVersion::R12].into_iter().find(|v| Some(version_code(*v)) == code);
        if let Some(tag) = variable("$INSUNITS") {
            let codes = [tag.int()?, variable("$MEASUREMENT").map_or(Ok(0), Tag::int)?];
            let unit = Units::ALL.into_iter().find(|unit| unit_codes(*unit) == codes);
            let unit = unit.ok_or_else(|| {
                ReadError::unsupported(format!("$INSUNITS {} with $MEASUREMENT {}", codes[0], codes[1]), tag.place())
            })?;
            self.unit = Some(unit.in_millimetres());
        }
        Ok(())
    }

    /// Single entities as the curves that they were written as. DXF R12 has no groups, and lines and arcs alone none
    /// either: where one curve ends where another one begins, only the numbers of their pieces tell them apart.
    pub(crate) fn regrouped(self, counts: &[usize]) -> Self {
        if self.curves.iter().map(|curve| curve.chain.piece_count()).eq(counts.iter().copied()) {
            return self;
        }
        let pieces_of = |drawn: &'_ Drawn| {
            let Drawn { chain, layer, polyline } = drawn.clone();
            chain.into_pieces().into_iter().map(move |piece| (piece, layer.clone(), polyline))
        };
        let all: Vec<(ChainPiece, String, bool)> = self.curves.iter().flat_map(pieces_of).collect();
        let (mut rest, mut grouped) = (all.as_slice(), Vec::with_capacity(counts.len()));
        for &count in counts {
            let mut found = 0;
            let length = rest.iter().take_while(|(piece, ..)| {
                let more = found < count;
                found += if more { piece.as_curve().piece_count() } else { 0 };
                more
            });
            let (own, after) = rest.split_at(length.count());
            let gap = GAP * own.iter().map(|(piece, ..)| extent(piece)).fold(0.0, f64::max);
            let ends = own.first().zip(own.last()).map(|((first, ..), (last, ..))| last.end().distance(first.start()));
            let pieces = own.iter().map(|(piece, ..)| piece.clone()).collect();
            let polyline = own.iter().any(|(_, _, polyline)| *polyline);
            // All pieces of a curve are on its layer; one that is not is what the curve is said to be on.
            let layer = own.first().map_or("", |(_, first, _)| {
                own.iter().map(|(_, layer, _)| layer.as_str()).find(|layer| layer != first).unwrap_or(first)
            });
            match CurveChain::new(pieces, ends.is_some_and(|apart| apart <= gap), gap) {
                Ok(chain) => grouped.push(Drawn { chain, layer: layer.to_owned(), polyline }),
                // What does not hang together is not what was written.
                Err(_) => return self,
            }
            rest = after;
        }
        if rest.is_empty() { Self { curves: grouped, ..self } } else { self }
    }

    /// The labels that the file of a model has whose curves are drawn as these; `None` in a version that is not one of ours.
    pub(crate) fn labels(&self, model: &Model) -> Option<FileLabels> {
        let single = |curve: &Drawn| if curve.polyline { 1 } else { curve.chain.pieces().len() };
        Some(labels(model, self.version?, self.curves.iter().map(single)))
    }

    /// The curves, and the names: the layers of the table, those that the curves are on, the groups.
    pub(crate) fn into_content(self) -> FileContent {
        let mut names: Vec<FileName> = self.layers.into_iter().map(|name| FileName::new(LAYER, name, 1)).collect();
        let mut curves = Vec::with_capacity(self.curves.len());
        for Drawn { chain, layer, .. } in self.curves {
            push_counted(&mut names, LAYER_OF, &layer);
            curves.push(chain);
        }
        names.extend(self.groups);
        FileContent { curves, labels: FileLabels { unit: self.unit, names }, ..FileContent::default() }
    }
}

/// The pairs of one entity, its type first.
struct Entity<'a> {
    tags: &'a [Tag<'a>],
}

impl<'a> Entity<'a> {
    fn name(&self) -> &'a str {
        self.tags[0].value
    }

    fn place(&self) -> String {
        self.tags[0].place()
    }

    fn text(&self, code: u16) -> Option<&'a str> {
        self.tags.iter().find(|t| t.code == code).map(|t| t.value)
    }

    fn layer(&self) -> String {
        self.text(8).unwrap_or_default().to_owned()
    }

    fn real(&self, code: u16) -> Result<f64, ReadError> {
        let tag = self.tags.iter().find(|t| t.code == code);
        tag.ok_or_else(|| ReadError::syntax(self.place(), format!("no value with group code {code}")))?.real()
    }

    fn int(&self, code: u16) -> Result<usize, ReadError> {
        self.tags.iter().find(|t| t.code == code).map_or(Ok(0), Tag::int)
    }

    fn all(&self, code: u16) -> Result<Vec<f64>, ReadError> {
        self.tags.iter().filter(|t| t.code == code).map(Tag::real).collect()
    }

    fn point(&self, code: u16) -> Result<Point3, ReadError> {
        Ok(Point3::new(self.real(code)?, self.real(code + 10)?, self.real(code + 20)?))
    }

    fn ocs(&self) -> Result<Ocs, ReadError> {
        if self.text(210).is_none() {
            return Ok(Ocs::new(Vec3::Z));
        }
        let z = self.point(210)?.to_vec().unit();
        Ok(Ocs::new(z.ok_or_else(|| ReadError::syntax(self.place(), "the extrusion is zero"))?))
    }

    /// The group that the entity belongs to.
    fn group(&self) -> Option<&'a str> {
        let start = self.tags.iter().position(|t| t.code == 102 && t.value == "{ACAD_REACTORS")?;
        self.tags.get(start + 1).filter(|t| t.code == 330).map(|t| t.value)
    }

    fn geometry(&self, source: cyclide::Error) -> ReadError {
        ReadError::Geometry { place: self.place(), source }
    }
}

/// The curves found so far, and those that are still growing.
#[derive(Default)]
struct Curves<'a> {
    drawn: Vec<Drawn>,
    /// The handles of entities by the group that they say they are in.
    members: HashMap<&'a str, Vec<&'a str>>,
    /// LINE, ARC and SPLINE entities of one curve, with their group or layer.
    pieces: Vec<ChainPiece>,
    /// Largest coordinate or radius of these.
    extent: f64,
    key: (Option<&'a str>, Option<&'a str>),
    place: String,
    polyline: Option<Polyline>,
}

struct Polyline {
    ocs: Ocs,
    elevation: f64,
    closed: bool,
    /// First and second coordinate and bulge.
    vertices: Vec<[f64; 3]>,
    layer: String,
}

impl<'a> Curves<'a> {
    fn entity(&mut self, entity: &Entity<'a>) -> Result<(), ReadError> {
        if let Some(group) = entity.group() {
            self.members.entry(group).or_default().push(entity.text(5).unwrap_or_default());
        }
        match entity.name() {
            "LWPOLYLINE" => {
                let (x, y, bulge) = (entity.all(10)?, entity.all(20)?, entity.all(42)?);
                if x.len() != y.len() || x.len() != bulge.len() || x.len() != entity.int(90)? {
                    return Err(ReadError::syntax(entity.place(), "incomplete vertices"));
                }
                let vertices = (0..x.len()).map(|i| [x[i], y[i], bulge[i]]).collect();
                let (ocs, closed) = (entity.ocs()?, entity.int(70)? % 2 == 1);
                self.finish()?;
                self.push(
                    &Polyline { ocs, elevation: entity.real(38)?, closed, vertices, layer: entity.layer() },
                    entity,
                )
            }
            "POLYLINE" => {
                self.finish()?;
                let (ocs, closed) = (entity.ocs()?, entity.int(70)? % 2 == 1);
                let (elevation, layer) = (entity.real(30)?, entity.layer());
                self.polyline = Some(Polyline { ocs, elevation, closed, vertices: Vec::new(), layer });
                Ok(())
            }
            "VERTEX" => {
                let vertex = [entity.real(10)?, entity.real(20)?, entity.real(42)?];
                let polyline = self.polyline.as_mut();
                let polyline =
                    polyline.ok_or_else(|| ReadError::syntax(entity.place(), "a VERTEX outside a POLYLINE"))?;
                if entity.layer() != polyline.layer {
                    return Err(ReadError::syntax(entity.place(), "a VERTEX is on another layer than its POLYLINE"));
                }
                polyline.vertices.push(vertex);
                Ok(())
            }
            "SEQEND" => {
                let polyline = self.polyline.take();
                let polyline =
                    polyline.ok_or_else(|| ReadError::syntax(entity.place(), "a SEQEND outside a POLYLINE"))?;
                self.push(&polyline, entity)
            }
            "LINE" => {
                let arc = Arc::segment(entity.point(10)?, entity.point(11)?);
                self.piece(ChainPiece::Arc(arc.map_err(|e| entity.geometry(e))?), entity)
            }
            "ARC" => self.piece(ChainPiece::Arc(read_arc(entity)?), entity),
            "SPLINE" => self.piece(ChainPiece::Spline(read_spline(entity)?), entity),
            other => Err(ReadError::unsupported(other, entity.place())),
        }
    }

    fn push(&mut self, polyline: &Polyline, entity: &Entity<'_>) -> Result<(), ReadError> {
        let Polyline { ocs, elevation, closed, vertices, layer } = polyline;
        let n = vertices.len();
        let point = |i: usize| ocs.to_world(Point3::new(vertices[i % n][0], vertices[i % n][1], *elevation));
        let edges = if *closed { n } else { n.saturating_sub(1) };
        let arcs = (0..edges).map(|i| Arc::from_bulge(point(i), point(i + 1), ocs.z, vertices[i][2]));
        let path = arcs.collect::<cyclide::Result<Vec<_>>>().and_then(|arcs| ArcPath::new(arcs, *closed));
        let path = path.map_err(|e| entity.geometry(e))?;
        self.drawn.push(Drawn { chain: path.into(), layer: layer.clone(), polyline: true });
        Ok(())
    }

    /// Adds a piece to the curve that is growing, or starts another one: a new group, or, where there are none, a
    /// new layer, a gap, or a curve that has just closed.
    fn piece(&mut self, piece: ChainPiece, entity: &Entity<'a>) -> Result<(), ReadError> {
        let key = (entity.group(), entity.text(8));
        let follows = self.pieces.last().is_some_and(|last| {
            // The digits of the piece that begins count as those of the pieces before.
            let gap = GAP * self.extent.max(extent(&piece));
            let meets = last.end().distance(piece.start()) <= gap;
            key == self.key && meets && (key.0.is_some() || !self.is_closed())
        });
        if !follows {
            self.finish()?;
            self.key = key;
            self.place = entity.place();
        }
        self.extent = self.extent.max(extent(&piece));
        self.pieces.push(piece);
        Ok(())
    }

    fn gap(&self) -> f64 {
        GAP * self.extent
    }

    fn is_closed(&self) -> bool {
        match (self.pieces.first(), self.pieces.last()) {
            (Some(first), Some(last)) => last.end().distance(first.start()) <= self.gap(),
            _ => false,
        }
    }

    fn finish(&mut self) -> Result<(), ReadError> {
        if self.pieces.is_empty() {
            return Ok(());
        }
        let (closed, gap) = (self.is_closed(), self.gap());
        self.extent = 0.0;
        let chain = CurveChain::new(std::mem::take(&mut self.pieces), closed, gap);
        let place = std::mem::take(&mut self.place);
        let layer = self.key.1.unwrap_or_default().to_owned();
        let chain = chain.map_err(|source| ReadError::Geometry { place, source })?;
        self.drawn.push(Drawn { chain, layer, polyline: false });
        Ok(())
    }
}

/// Largest coordinate or radius of a piece.
fn extent(piece: &ChainPiece) -> f64 {
    let ends = piece.start().to_vec().max_abs().max(piece.end().to_vec().max_abs());
    match piece {
        ChainPiece::Arc(arc) => ends.max(arc.radius().unwrap_or(0.0)),
        ChainPiece::Spline(_) => ends,
    }
}

fn read_arc(entity: &Entity<'_>) -> Result<Arc, ReadError> {
    let ocs = entity.ocs()?;
    let (center, radius) = (ocs.to_world(entity.point(10)?), entity.real(40)?);
    let (start, end) = (entity.real(50)?, entity.real(51)?);
    let sweep = if end > start { end - start } else { end - start + 360.0 };
    let (sin, cos) = start.to_radians().sin_cos();
    let arc = Arc::from_center(center, ocs.z, center + (ocs.x * cos + ocs.y * sin) * radius, sweep.to_radians());
    arc.map_err(|e| entity.geometry(e))
}

fn read_spline(entity: &Entity<'_>) -> Result<NurbsCurve, ReadError> {
    let (x, y, z) = (entity.all(10)?, entity.all(20)?, entity.all(30)?);
    if x.len() != y.len() || x.len() != z.len() {
        return Err(ReadError::syntax(entity.place(), "incomplete control points"));
    }
    let points = (0..x.len()).map(|i| Point3::new(x[i], y[i], z[i])).collect();
    let degree = entity.int(71)?;
    if degree > x.len() {
        return Err(ReadError::syntax(entity.place(), "the degree exceeds the number of control points"));
    }
    NurbsCurve::new(degree, entity.all(40)?, points, entity.all(41)?).map_err(|e| entity.geometry(e))
}
