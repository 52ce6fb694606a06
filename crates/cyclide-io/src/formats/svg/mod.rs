//! SVG: drawings for browsers, laser cutters and print.
//!
//! One user unit is one model unit, the second axis points up (coordinates are negated, there is no transform), and
//! `width` and `height` are in millimeters: true size for models in mm, cm and inches; models in meters and feet are
//! drawn to the scale 1:1, 1:2, 1:5, 1:10, … at which they fit on 420 mm, named in `desc`. Arcs are true `A`
//! commands, those above 150 degrees cut in equal parts (near half circles readers find the center badly). One
//! `path` per connected curve, closed ones end in `Z`; one group per object with its name as `title`.
//!
//! A curve in space is drawn as seen along the third axis: its arcs become ellipses there, so it is written as a
//! polyline within the tolerance. Surfaces are drawn as the edges of their patches and some of their parameter circles,
//! in finer lines under the curves.

mod path;
mod plan;
mod reader;

use crate::check::deviation::{Deviations, View, lines_deviation};
use crate::check::labels::{FileLabels, FileName, Named};
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::drawing;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Promise, Written, WrittenCurve};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::parts::Contour;
use crate::formats::entry::{Entry, Reading};
use crate::text::number::push_plain;
use crate::text::xml::escaped;
use cyclide::{
    Aabb, Point3, Vec3,
    curve::{Arc, Correspondence, CurvePlace},
    model::{Lowered, Units},
};
use path::Path;
use plan::Plan;
use reader::{DESCRIPTION, TITLE};
use std::collections::HashSet;

use reader::read;

/// Smallest drawing relative to its coordinates: its margins, and thousandths of it, are still told apart.
const SMALLEST_IN_PLACE: f64 = 8192.0 * f64::EPSILON;
/// Margin round the drawing, relative to its larger side.
const MARGIN: f64 = 0.04;
/// Width of the curve, relative to the larger side.
const STROKE: f64 = 0.0025;
/// Largest side of a drawing that is scaled, millimeters.
const PAPER: f64 = 420.0;
/// Most curves left out that a note names.
const NAMED_POINTS: usize = 8;
/// An arc is level, and stays an arc in the drawing, if its normal is this close to the third axis.
const LEVEL: f64 = 1e-12;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "svg",
    title: "SVG",
    suffixes: &["svg"],
    lacks: None,
    animates: false,
    holds_exact_only: true,
    forms: |_| Forms::ARCS,
    write,
    reading: Some(Reading { read, compare, rounds_by_model: false }),
};

/// Writes the model as SVG.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let mut notes = Vec::new();
    let mut paths: Vec<(Contour<'_>, Path)> = Vec::new();
    let mut points: Vec<Contour<'_>> = Vec::new();
    let mut written = Written::default();
    for contour in job.contours() {
        let (path, curve) = draw(job, &contour)?;
        written.curves.push(curve);
        if path.is_point() {
            points.push(contour);
        } else {
            paths.push((contour, path));
        }
    }
    let plan = Plan::new(job)?;
    let drawn = paths.iter().map(|(_, p)| p.bounds()).chain(plan.bounds());
    let Some(mut bounds) = drawn.reduce(Aabb::union) else {
        let Some(first) = points.first() else { return Err(ExportError::Empty) };
        let (object, detail) = (first.object.to_owned(), "in the view along the z axis it is a point");
        return Err(ExportError::NotInFormat { object, format: "SVG", detail });
    };
    notes.extend(points_note(&points));
    if job.bounds.max.z - job.bounds.min.z > LEVEL * job.size() {
        notes.push("heights are ignored: the drawing is the view along the z axis".to_owned());
    }
    let size = larger_side(bounds);
    let combs =
        if job.options.svg_comb { drawing::combs(job, size, [Vec3::X, Vec3::Y]) } else { drawing::Combs::default() };
    bounds = combs.tips().fold(bounds, |b, tip| b.including(Point3::new(tip.x, -tip.y, 0.0)));
    if !combs.have_one_scale() {
        notes.push("the combs are drawn at different scales".to_owned());
    }
    notes.extend(combs.left_out_note(|index| job.model.items.get(index).map_or("", |item| &item.name)));

    if !(size > SMALLEST_IN_PLACE * bounds.max_abs()) {
        let object = paths.first().map(|(contour, _)| contour.object.to_owned()).unwrap_or_default();
        let detail = "the drawing is smaller than the rounding of its coordinates: move it to the origin";
        return Err(ExportError::NotInFormat { object, format: "SVG", detail });
    }
    let page = Page::new(job.units(), bounds);
    if let Some(scale) = page.scale_note() {
        notes.push(scale);
    }
    let mut out = page.opening(job);
    written.lines = plan.push(&mut out, STROKE * size);
    push_combs(&mut out, &combs, STROKE * size);
    if !paths.is_empty() {
        push_curves(&mut out, paths, STROKE * size);
    }
    if job.options.svg_points {
        push_joints(&mut out, &drawing::joints(job), size);
    }
    out.push_str("</svg>\n");
    Ok(written.exported(out.into_bytes(), notes))
}

/// What is said of curves that are left out since they are points in the drawing.
fn points_note(points: &[Contour<'_>]) -> Option<String> {
    let mut labels: Vec<String> = points.iter().take(NAMED_POINTS).map(Contour::label).collect();
    if points.len() > NAMED_POINTS {
        labels.push(format!("and {} more", points.len() - NAMED_POINTS));
    }
    let labels = labels.join(", ");
    (!points.is_empty()).then(|| {
        format!("curves that are points in the view along the z axis, within their tolerance, are left out: {labels}")
    })
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let written = &made.file.written;
    let curves = made.curves(&content, View::Plan)?;
    let lines = lines_deviation(&made.ready.bodies, &written.lines, &content.lines)?;
    content.labels.check(&labels(made.named(), written))?;
    Ok(Deviations { curves, lines, ..Deviations::default() })
}

/// The labels of a file of the model of which these curves were written.
fn labels(named: Named<'_>, written: &Written) -> FileLabels {
    let mut names = vec![FileName::new(reader::TITLE_OF_ALL, escaped(named.title), 1)];
    let mut ids = HashSet::new();
    let mut curves = written.curves.iter();
    for item in &named.model.items {
        let own = curves.by_ref().take(item.curves().len());
        let count = own.filter(|curve| !curve.is_left_out()).count();
        if count == 0 {
            continue;
        }
        let (title, id) = (escaped(&item.name), unique_id(&item.name, &mut ids));
        names.extend([FileName::new(reader::TITLE_OF, title, 1), FileName::new(reader::ID_OF, id, count)]);
    }
    FileLabels::new(named.model.units, names)
}

/// A contour as a path: its arcs if they are level, else a polyline of its view; with the parts that its pieces stand
/// for.
fn draw(job: &Job<'_>, contour: &Contour<'_>) -> Result<(Path, WrittenCurve), ExportError> {
    let closed = contour.curve.as_curve().is_closed();
    let lowered = job.arcs(contour)?;
    let level = |a: &Arc| a.normal().is_none_or(|n| n.x.abs() <= LEVEL && n.y.abs() <= LEVEL);
    if lowered.form.arcs().iter().all(level) {
        let mut promise = Promise::of_arcs(&lowered);
        let Lowered { form: arcs, correspondence, .. } = lowered;
        let mut path = Path::new(arcs.arcs()[0].start(), closed);
        let mut counts = Vec::with_capacity(arcs.arcs().len());
        for arc in arcs.arcs() {
            let (lost, drawn) = path.arc(arc);
            promise.add(lost);
            counts.push(drawn);
        }
        return Ok((path, promise.of(correspondence.recounted(counts))));
    }
    let vertices = contour.lowered(job.pieces.flatten(contour.curve.as_curve(), job.tolerance))?;
    let (path, parts) = polyline(&vertices, closed);
    Ok((path, Promise::of_polyline(contour.curve.as_curve(), job.tolerance).of(parts)))
}

/// The vertices as a path, without the segments that are points on the page, and the parts between them.
fn polyline(vertices: &[(CurvePlace, Point3)], closed: bool) -> (Path, Correspondence) {
    let mut path = Path::new(vertices[0].1, closed);
    let counts: Vec<usize> = vertices[1..].iter().map(|(_, point)| path.segment(*point)).collect();
    (path, Correspondence::of_vertices(vertices.iter().map(|(place, _)| *place)).recounted(counts))
}

fn larger_side(bounds: Aabb) -> f64 {
    let extent = bounds.max - bounds.min;
    let side = extent.x.max(extent.y);
    // A single point cannot be drawn to any scale; everything else has an extent.
    if side > 0.0 { side } else { 1.0 }
}

/// The visible area and its size on paper.
struct Page {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    units: Units,
    /// Model lengths are this many times as long as on paper.
    scale: f64,
}

impl Page {
    /// Bounds are in the drawing's own axes, the second one down.
    fn new(units: Units, bounds: Aabb) -> Self {
        let side = larger_side(bounds);
        let margin = MARGIN * side;
        // Rounded outwards to a thousandth of the size: short numbers.
        let step = 10_f64.powf((side.log10() - 3.0).ceil());
        let down = |v: f64| ((v - margin) / step).floor() * step;
        let up = |v: f64| ((v + margin) / step).ceil() * step;
        let short = |v: f64| format!("{v:.*}", (-step.log10()).max(0.0) as usize).parse().unwrap_or(v);
        let (left, top) = (short(down(bounds.min.x)), short(down(bounds.min.y)));
        let (width, height) = (short(up(bounds.max.x) - left), short(up(bounds.max.y) - top));
        let scale = match units {
            Units::Millimetre | Units::Centimetre | Units::Inch => 1.0,
            Units::Metre | Units::Foot | Units::UsSurveyFoot => {
                round_scale(width.max(height) * units.in_millimetres() / PAPER)
            }
        };
        Self { left, top, width, height, units, scale }
    }

    fn scale_note(&self) -> Option<String> {
        let scale = self.scale;
        (scale > 1.0).then(|| format!("on paper the drawing is {}{scale}", reader::SCALE))
    }

    fn opening(&self, job: &Job<'_>) -> String {
        let on_paper = |v: f64| {
            let mut text = String::new();
            push_plain(&mut text, v * self.units.in_millimetres() / self.scale);
            text
        };
        let mut area = String::new();
        for (i, v) in [self.left, self.top, self.width, self.height].into_iter().enumerate() {
            if i > 0 {
                area.push(' ');
            }
            push_plain(&mut area, v);
        }
        let (width, height, symbol) = (on_paper(self.width), on_paper(self.height), self.units.symbol());
        let scale = self.scale_note().map_or(String::new(), |note| format!("; {note}"));
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"{area}\">\n\
             {}{}{}\n{}{symbol}{scale}{}\n",
            TITLE.0,
            escaped(job.title()),
            TITLE.1,
            DESCRIPTION.0,
            DESCRIPTION.1
        )
    }
}

/// The smallest of 1, 2, 5, 10, 20, 50, … that is not below `least`.
fn round_scale(least: f64) -> f64 {
    if !(least > 1.0) {
        return 1.0;
    }
    let decade = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0].into_iter().map(|m| m * decade).find(|s| *s >= least).unwrap_or(10.0 * decade).round()
}

fn push_curves(out: &mut String, paths: Vec<(Contour<'_>, Path)>, stroke: f64) {
    out.push_str(
        "<g fill=\"none\" stroke=\"#17202e\" stroke-linecap=\"round\" stroke-linejoin=\"round\" stroke-width=\"",
    );
    push_plain(out, three_digits(stroke));
    out.push_str("\">\n");
    let mut ids = HashSet::new();
    let mut group = None;
    for (contour, path) in paths {
        if group != Some(contour.item) {
            let (id, title) = (unique_id(contour.object, &mut ids), escaped(contour.object));
            out.push_str(if group.is_some() { "</g>\n" } else { "" });
            out.push_str(&format!("{}{id}\">{}{title}{}\n", reader::GROUP, TITLE.0, TITLE.1));
            group = Some(contour.item);
        }
        out.push_str(&format!("{}{}\"/>\n", reader::CONTOUR, path.into_data()));
    }
    out.push_str("</g>\n</g>\n");
}

fn push_combs(out: &mut String, combs: &drawing::Combs, stroke: f64) {
    if combs.drawn.is_empty() {
        return;
    }
    out.push_str("<g id=\"comb\" fill=\"none\" stroke=\"#e0793a\" stroke-width=\"");
    push_plain(out, three_digits(0.3 * stroke));
    out.push_str("\">\n");
    for comb in &combs.drawn {
        let (mut teeth, mut tips) = (String::new(), String::new());
        for strip in &comb.strips {
            for t in strip.tips.iter().filter(|t| t.is_tooth) {
                push_line(&mut teeth, &[t.foot, t.tip]);
            }
            push_line(&mut tips, &strip.tips.iter().map(|t| t.tip).collect::<Vec<_>>());
        }
        out.push_str(&format!("<path class=\"teeth\" stroke-opacity=\"0.5\" d=\"{teeth}\"/>\n"));
        out.push_str(&format!("<path class=\"tips\" stroke-opacity=\"0.9\" d=\"{tips}\"/>\n"));
    }
    out.push_str("</g>\n");
}

/// An open polyline.
fn push_line(data: &mut String, points: &[Point3]) {
    for (i, p) in points.iter().enumerate() {
        data.push(if i == 0 { 'M' } else { 'L' });
        push_plain(data, p.x);
        data.push(' ');
        push_plain(data, -p.y);
    }
}

fn push_joints(out: &mut String, joints: &[Point3], size: f64) {
    out.push_str("<g id=\"joints\" fill=\"#1f6feb\">\n");
    let radius = three_digits(drawing::dot_radius(joints, size));
    for p in joints {
        out.push_str("<circle cx=\"");
        push_plain(out, p.x);
        out.push_str("\" cy=\"");
        push_plain(out, -p.y);
        out.push_str("\" r=\"");
        push_plain(out, radius);
        out.push_str("\"/>\n");
    }
    out.push_str("</g>\n");
}

fn three_digits(v: f64) -> f64 {
    format!("{v:.2e}").parse().unwrap_or(v)
}

/// Names of the groups that the drawing itself has.
const GROUPS: [&str; 4] = ["comb", "joints", "edges", "circles"];

/// An XML name for the object, different from all before (and from the groups that the drawing itself has).
fn unique_id(name: &str, taken: &mut HashSet<String>) -> String {
    let mut id: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() || "-_.".contains(c) { c } else { '_' }).collect();
    if !id.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        id.insert(0, '_');
    }
    let mut candidate = id.clone();
    let mut number = 2;
    while GROUPS.contains(&candidate.as_str()) || !taken.insert(candidate.clone()) {
        candidate = format!("{id}_{number}");
        number += 1;
    }
    candidate
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_are_round() {
        let cases = [(0.3, 1.0), (1.0, 1.0), (1.01, 2.0), (3.0, 5.0), (7.0, 10.0), (4321.0, 5000.0), (5001.0, 10000.0)];
        for (least, scale) in cases {
            assert!((round_scale(least) - scale).abs() < 1e-9 * scale, "{least}");
        }
    }

    #[test]
    fn names_become_ids_and_titles() {
        let mut taken = HashSet::new();
        assert_eq!(unique_id("a b", &mut taken), "a_b");
        assert_eq!(unique_id("a_b", &mut taken), "a_b_2");
        assert_eq!(unique_id("5°", &mut taken), "_5_");
        assert_eq!(unique_id("comb", &mut taken), "comb_2");
    }
}
