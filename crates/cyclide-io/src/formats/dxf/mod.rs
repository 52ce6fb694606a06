//! DXF: AutoCAD's exchange format, for laser cutters and 2D CAD.
//!
//! A planar curve becomes one polyline with bulges in its own plane (R2000: LWPOLYLINE, R12: POLYLINE), closed by
//! its flag, the first vertex not repeated; arcs above half a turn are cut in two. Curves that are no arcs are
//! replaced by arcs within the tolerance, or by exact rational SPLINE entities on request. A curve in space becomes
//! LINE and ARC entities in their own planes, in R2000 held together by a GROUP. One layer per object.
//!
//! Arcs that turn by less than 5e-8 radians are written as straight: readers find the circle from chord and bulge
//! and would lose more digits than the sagitta has. The promised bound includes it.

mod layers;
mod plane;
mod reader;
mod sheet;
mod skeleton;
mod tags;

use crate::check::deviation::{Deviations, View};
use crate::check::labels::{FileLabels, FileName};
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Promise, Written, knots_of, straightened};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::options::DxfVersion;
use crate::export::parts::{Contour, contours};
use crate::formats::entry::{Entry, Kind, Reading};
use cyclide::{
    Point3, Vec3,
    curve::{Arc, ArcPath, ParamCurve as _},
    model::{ChainPiece, CurveChain, Lowered, Model},
    rational::NurbsCurve,
};
use plane::{Ocs, plane_of};
use skeleton::{Content, FIRST_FREE, Group, MODEL_SPACE};
use tags::Tags;

use reader::{Drawing, read};
pub(crate) use sheet::{Lettering, Sheet, SheetLine};

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "dxf",
    title: "DXF",
    suffixes: &["dxf"],
    lacks: Some(Kind::Surfaces),
    animates: false,
    holds_exact_only: false,
    forms: |options| if options.dxf_splines { Forms::BOTH } else { Forms::ARCS },
    write,
    reading: Some(Reading { read: |bytes| read(bytes).map(Drawing::into_content), compare, rounds_by_model: true }),
};

/// Writes the model as DXF.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let version = job.options.dxf_version;
    let layers = layers::layer_names(job.model.items.iter().map(|i| i.name.as_str()), version);
    let mut file = Entities {
        tags: Tags::default(),
        version,
        next_handle: FIRST_FREE + layers.len(),
        groups: Vec::new(),
        promise: Promise::EXACT,
        written: Written::default(),
        in_space: false,
        splines: false,
    };
    for contour in job.contours() {
        file.contour(job, &contour, &layers[contour.item])?;
    }
    let Entities { tags: entities, groups, written, next_handle, in_space, splines, .. } = file;
    let (units, bounds) = (job.units(), job.bounds);
    let content = Content { version, units, bounds, layers: &layers, groups: &groups, next_handle };
    let mut tags = Tags::default();
    skeleton::opening(&mut tags, &content);
    tags.append(entities);
    skeleton::closing(&mut tags, &content);
    let mut notes = Vec::new();
    if in_space {
        notes.push(
            "curves in space are written as LINE and ARC entities, which many 2D programs display incorrectly"
                .to_owned(),
        );
    }
    if splines {
        notes.push("rational SPLINE entities: many cutting and drawing programs ignore their weights".to_owned());
    }
    Ok(written.exported(tags.into_bytes(), notes))
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let counts: Vec<usize> = made.file.written.curves.iter().map(|curve| curve.parts.piece_count()).collect();
    let drawing = read(&made.file.bytes)?.regrouped(&counts);
    let labels = drawing.labels(made.ready.model).ok_or_else(|| ReadError::unsupported("this version", "$ACADVER"))?;
    let content = drawing.into_content();
    // In curves of ARC and LINE entities the ends alone tell whether one is closed.
    let curves = made.curves(&content, View::Points)?;
    content.labels.check(&labels)?;
    Ok(Deviations { curves, ..Deviations::default() })
}

/// Rounding of the points of an arc that is given by its center, relative to this and to the radius.
const CENTER_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Arcs that turn by more are written as two.
const NEARLY_FULL: f64 = std::f64::consts::TAU - 1e-6;

/// What the names are those of.
const LAYER: &str = "layer";
const LAYER_OF: &str = "layer with curves";
const GROUP: &str = "group";

/// The labels of a file of the model in a version that has so many entities for each of its curves.
fn labels(model: &Model, version: DxfVersion, entities: impl Iterator<Item = usize>) -> FileLabels {
    let layers = layers::layer_names(model.items.iter().map(|i| i.name.as_str()), version);
    let table = std::iter::once("0").chain(layers.iter().map(String::as_str));
    let mut names: Vec<FileName> = table.map(|name| FileName::new(LAYER, name, 1)).collect();
    let used = layers.iter().zip(&model.items).filter(|(_, item)| !item.curves().is_empty());
    names.extend(used.map(|(layer, item)| FileName::new(LAYER_OF, layer, item.curves().len())));
    let grouped = contours(model).zip(entities).filter(|(_, count)| version == DxfVersion::R2000 && *count > 1);
    let group = |(number, (contour, count)): (usize, (Contour<'_>, usize))| {
        FileName::new(GROUP, layers::group_name(&contour.label(), number), count)
    };
    names.extend(grouped.enumerate().map(group));
    FileLabels::new(model.units, names)
}

/// The ENTITIES section as it grows.
struct Entities {
    tags: Tags,
    version: DxfVersion,
    next_handle: usize,
    groups: Vec<Group>,
    /// What is promised for the curve that is written.
    promise: Promise,
    written: Written,
    /// Some curve did not lie in a plane.
    in_space: bool,
    splines: bool,
}

impl Entities {
    fn contour(&mut self, job: &Job<'_>, contour: &Contour<'_>, layer: &str) -> Result<(), ExportError> {
        if job.options.dxf_splines {
            let lowered = job.chain(contour)?;
            let chain = &lowered.form;
            if chain.pieces().iter().any(|p| matches!(p, ChainPiece::Spline(_))) {
                if self.version == DxfVersion::R12 {
                    let object = contour.object.to_owned();
                    return Err(ExportError::NotInFormat {
                        object,
                        format: "DXF R12",
                        detail: "this version has no SPLINE entity",
                    });
                }
                self.promise = Promise::of_chain(&lowered);
                self.splines = true;
                self.pieces(chain, &contour.label(), layer);
                let mut curve = self.promise.of(lowered.correspondence);
                curve.knots = chain.pieces().iter().flat_map(knots_of).copied().collect();
                self.written.curves.push(curve);
                return Ok(());
            }
        }
        let lowered = job.arcs(contour)?;
        self.promise = Promise::of_arcs(&lowered);
        let Lowered { form: path, correspondence, .. } = lowered;
        if let Some(ocs) = plane_of(path.arcs(), job.size()) {
            let counts = self.polyline(&path, ocs, layer);
            self.written.curves.push(self.promise.of(correspondence.recounted(counts)));
        } else {
            self.in_space = true;
            // By its angles an arc that is nearly a circle cannot be told from nothing.
            let parts = |arc| if Arc::angle(arc) > NEARLY_FULL { at_most_half_turns(arc) } else { vec![*arc] };
            let parts: Vec<Vec<Arc>> = path.arcs().iter().map(parts).collect();
            let counts: Vec<usize> = parts.iter().map(Vec::len).collect();
            let pieces = parts.into_iter().flatten().map(ChainPiece::Arc).collect();
            let chain = contour.lowered(CurveChain::new(pieces, path.is_closed(), f64::INFINITY))?;
            self.pieces(&chain, &contour.label(), layer);
            self.written.curves.push(self.promise.of(correspondence.recounted(counts)));
        }
        Ok(())
    }

    /// Type, handle, owner and layer of an entity; returns its handle.
    fn entity(&mut self, name: &str, group: Option<usize>, layer: &str) -> usize {
        let handle = self.next_handle;
        self.tags.begin(name);
        if self.version == DxfVersion::R2000 {
            self.next_handle += 1;
            self.tags.handle(5, handle);
            if let Some(group) = group {
                self.tags.raw("102 {ACAD_REACTORS").handle(330, group).raw("102 }");
            }
            self.tags.handle(330, MODEL_SPACE).text(100, "AcDbEntity");
        }
        self.tags.text(8, layer);
        handle
    }

    fn class(&mut self, name: &str) {
        if self.version == DxfVersion::R2000 {
            self.tags.text(100, name);
        }
    }

    fn extrusion(&mut self, z: Vec3) {
        if z != Vec3::Z {
            self.tags.point(210, Point3::ORIGIN + z);
        }
    }

    /// A planar path as one polyline with bulges; gives the number of its pieces that each arc has become.
    fn polyline(&mut self, path: &ArcPath, ocs: Ocs, layer: &str) -> Vec<usize> {
        let mut vertices: Vec<(Point3, f64)> = Vec::with_capacity(path.arcs().len() + 1);
        let mut counts = Vec::with_capacity(path.arcs().len());
        for arc in path.arcs() {
            let parts = at_most_half_turns(arc);
            counts.push(parts.len());
            for part in parts {
                let bulge = if self.straightened(&part) { 0.0 } else { part.bulge_vector().dot(ocs.z) };
                vertices.push((ocs.to_local(part.start()), bulge));
            }
        }
        if !path.is_closed() {
            vertices.extend(path.arcs().last().map(|a| (ocs.to_local(a.end()), 0.0)));
        }
        let elevation = vertices[0].0.z;
        let closed = usize::from(path.is_closed());
        match self.version {
            DxfVersion::R2000 => {
                self.entity("LWPOLYLINE", None, layer);
                self.tags.text(100, "AcDbPolyline").int(90, vertices.len()).int(70, closed).real(38, elevation);
                for (p, bulge) in &vertices {
                    self.tags.real(10, p.x).real(20, p.y).real(42, *bulge);
                }
                self.extrusion(ocs.z);
            }
            DxfVersion::R12 => {
                self.entity("POLYLINE", None, layer);
                self.tags.int(66, 1).point(10, Point3::new(0.0, 0.0, elevation)).int(70, closed);
                self.extrusion(ocs.z);
                for (p, bulge) in &vertices {
                    self.entity("VERTEX", None, layer);
                    self.tags.point(10, Point3::new(p.x, p.y, elevation)).real(42, *bulge);
                }
                self.entity("SEQEND", None, layer);
            }
        }
        counts
    }

    /// A chain as separate entities, held together by a group where the version has them.
    fn pieces(&mut self, chain: &CurveChain, label: &str, layer: &str) {
        let grouped = self.version == DxfVersion::R2000 && chain.pieces().len() > 1;
        let group = grouped.then(|| {
            self.next_handle += 1;
            self.next_handle - 1
        });
        let mut members = Vec::with_capacity(chain.pieces().len());
        for piece in chain.pieces() {
            match piece {
                ChainPiece::Spline(curve) => members.push(self.spline(curve, group, layer)),
                ChainPiece::Arc(arc) => members.push(self.arc(arc, group, layer)),
            }
        }
        if let Some(handle) = group {
            let name = layers::group_name(label, self.groups.len());
            self.groups.push(Group { handle, name, members });
        }
    }

    fn arc(&mut self, arc: &Arc, group: Option<usize>, layer: &str) -> usize {
        let circle = arc.center().zip(arc.radius()).zip(arc.normal()).zip(arc.start_tangent());
        let Some((((center, radius), normal), tangent)) = circle.filter(|_| !self.straightened(arc)) else {
            let handle = self.entity("LINE", group, layer);
            self.class("AcDbLine");
            self.tags.point(10, arc.start()).point(11, arc.end());
            return handle;
        };
        let ocs = Ocs::new(normal);
        // From the center to the start, in a direction free of the cancellation of two far points.
        let spoke = tangent.cross(normal);
        let start = spoke.dot(ocs.y).atan2(spoke.dot(ocs.x)).to_degrees();
        let start = if start < 0.0 { start + 360.0 } else { start };
        let end = start + arc.angle().to_degrees();
        let handle = self.entity("ARC", group, layer);
        self.class("AcDbCircle");
        // Readers find the points from a center that may be far away.
        self.promise.add_rounding(CENTER_ROUNDING * (radius + center.to_vec().max_abs()));
        self.tags.point(10, ocs.to_local(center)).real(40, radius);
        self.extrusion(normal);
        self.class("AcDbArc");
        self.tags.real(50, start).real(51, if end >= 360.0 { end - 360.0 } else { end });
        handle
    }

    fn spline(&mut self, curve: &NurbsCurve, group: Option<usize>, layer: &str) -> usize {
        const CLOSED: usize = 1;
        const RATIONAL: usize = 4;
        let points = curve.control_points();
        let flags = RATIONAL + if curve.is_closed() { CLOSED } else { 0 };
        let handle = self.entity("SPLINE", group, layer);
        self.class("AcDbSpline");
        self.tags.int(70, flags).int(71, curve.degree());
        self.tags.int(72, curve.knots().len()).int(73, points.len()).int(74, 0).real(42, 1e-9).real(43, 1e-10);
        self.tags.reals(40, curve.knots()).reals(41, curve.weights());
        for &p in points {
            self.tags.point(10, p);
        }
        handle
    }

    /// True if the arc is written as its chord; the promise then includes what is lost.
    fn straightened(&mut self, arc: &Arc) -> bool {
        let lost = straightened(arc);
        if let Some(lost) = lost {
            self.promise.add(lost);
        }
        lost.is_some()
    }
}

/// The arc, cut in two equal parts if it turns by more than half a turn (plus rounding).
fn at_most_half_turns(arc: &Arc) -> Vec<Arc> {
    if arc.angle() <= std::f64::consts::PI * (1.0 + 1e-9) {
        return vec![*arc];
    }
    let middle = arc.parameter_at_length(0.5);
    arc.split(middle).map_or_else(|_| vec![*arc], |(a, b)| vec![a, b])
}
