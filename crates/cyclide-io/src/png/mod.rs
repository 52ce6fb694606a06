//! PNG: a picture to look at, drawn on the processor, the same bytes every time.
//!
//! Curves of the plane are shown from above with their curvature comb and joints; a model with heights is shown
//! from the side and above (parallel projection), nearer parts darker and in front, with the shadow of each curve on
//! the ground below. A model with surfaces is shown in perspective, shaded, with its parameter circles and with the
//! curves among the surfaces ([`scene`]). The promised bound is half a pixel.
//!
//! Title, unit, scale bar and legend have bands of their own above and below ([`sheet`]); objects that are too many for
//! a legend are named where they stand ([`labels`]).

mod axes;
mod canvas;
mod labels;
mod lettering;
mod scene;
mod sheet;
mod view;

use crate::drawing::{self, CombStrip, Combs};
use crate::export_error::ExportError;
use crate::exported::{Exported, Promise};
use crate::job::Job;
use canvas::{Canvas, Ink, Pixel};
use cyclide::{Exactness, Point3, Vec3, flatten};
use labels::Labels;
use sheet::{Caption, Sheet, is_labelled};
use view::View;

/// Flattening, pixels: well below what anti-aliasing shows.
const FLATNESS: f64 = 0.05;
/// Widths in a picture of the usual width: of a curve, of a comb's teeth, and of the pale rim that lifts a near curve off
/// a far one.
const CURVE: f64 = 3.4;
const TOOTH: f64 = 1.0;
const RIM: f64 = 9.0;
/// Teeth are at most this part of their distance wide: a close comb is paler, not solid.
const TOOTH_PART: f64 = 0.4;
/// Joints closer together than this are not marked: they would hide the curve.
const JOINT_GAP: f64 = 14.0;
/// Length of the parts that a curve in space is cut into for hiding, pixels.
const PART: f64 = 24.0;
/// Depth by which each object is drawn in front of the one before it: two that run side by side must not take turns.
const LAYER: f64 = 0.03;

/// Draws the model.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let sheet = Sheet::new(job)?;
    if !job.bodies.is_empty() {
        return scene::write(job, sheet);
    }
    let size = job.size();
    let heights = job.bounds.max.z - job.bounds.min.z > 1e-6 * size;
    let rough: Vec<Point3> = curves(job, 1e-3 * size)?.into_iter().flat_map(|c| c.points).collect();
    let axes = view::axes(&rough, heights, job.options.camera);
    let from_above = axes[2] == UP;
    let combs = if job.options.png_plain { Combs::default() } else { drawing::combs(job, size, [axes[0], axes[1]]) };
    let caption = Caption::new(job, &combs);
    let visible: Vec<Point3> = rough.into_iter().chain(combs.tips()).collect();
    let ruled = job.options.png_axes && caption.is_some() && job.options.camera.map_or(!heights, |c| c.is_along_axis());
    let view = View::new(&visible, axes, heights, sheet, caption.as_ref(), ruled);
    let mut canvas = Canvas::new(view.width(), view.height()).ok_or_else(|| picture("it has no size"))?;
    let curves = curves(job, FLATNESS * view.unit())?;

    ground(&mut canvas, &view, sheet, &curves);
    for strip in combs.drawn.iter().flat_map(|comb| &comb.strips) {
        teeth(&mut canvas, &view, sheet, strip);
    }
    if heights && !from_above {
        curves_in_space(&mut canvas, &view, sheet, &curves);
    } else {
        for curve in &curves {
            let points: Vec<_> = curve.points.iter().map(|p| view.at(*p)).collect();
            canvas.stroke(&points, curve.closed, CURVE * sheet.scale, Ink::object(curve.object));
        }
    }
    joints(&mut canvas, &view, sheet, job);
    if let Some(caption) = &caption {
        let height = f64::from(view.height());
        let left = if ruled { axes::rulers(&mut canvas, &view, sheet, is_labelled(job)) } else { 0.4 * sheet.margin() };
        if is_labelled(job) {
            let room = [left, caption.header(sheet), height - caption.footer(sheet)];
            labels(&mut canvas, &view, Labels::new(sheet, room), job, &curves, &combs);
        }
        if job.options.png_axes && !ruled {
            axes::arrows(&mut canvas, view.axes(), sheet, height - caption.footer(sheet));
        }
        caption.draw(&mut canvas, sheet, height, view.unit(), "");
    }
    let bytes = canvas.encode().map_err(|e| picture(&e))?;
    let mut promise = Promise::EXACT;
    promise.add(Exactness::Proved(0.5 * view.unit()));
    Ok(promise.exported(bytes, Vec::new(), Vec::new()))
}

fn picture(detail: &str) -> ExportError {
    ExportError::Picture { detail: detail.to_owned() }
}

/// A flattened contour.
struct Polyline {
    object: usize,
    points: Vec<Point3>,
    closed: bool,
}

fn curves(job: &Job<'_>, tolerance: f64) -> Result<Vec<Polyline>, ExportError> {
    let one = |contour: crate::job::Contour<'_>| {
        let curve = contour.curve.as_curve();
        let vertices = contour.lowered(flatten(curve, tolerance))?;
        let points = vertices.into_iter().map(|(_, p)| p).collect();
        Ok(Polyline { object: contour.item, points, closed: curve.is_closed() })
    };
    job.contours().map(one).collect()
}

/// The area of a comb, its teeth, and the line over their tips.
fn teeth(canvas: &mut Canvas, view: &View, sheet: Sheet, strip: &CombStrip) {
    let feet: Vec<Pixel> = strip.tips.iter().map(|t| view.at(t.foot)).collect();
    let tips: Vec<Pixel> = strip.tips.iter().map(|t| view.at(t.tip)).collect();
    for (foot, tip) in feet.windows(2).zip(tips.windows(2)) {
        canvas.fill(&[foot[0], foot[1], tip[1], tip[0]], Ink::COMB_AREA);
    }
    let places = strip.tips.iter().zip(feet.iter().zip(&tips)).filter(|(t, _)| t.is_tooth);
    let teeth: Vec<[Pixel; 2]> = places.map(|(_, (foot, tip))| [*foot, *tip]).collect();
    let distance = |pair: &[[Pixel; 2]]| f64::from((pair[1][0].0 - pair[0][0].0).hypot(pair[1][0].1 - pair[0][0].1));
    let mean = teeth.windows(2).map(distance).sum::<f64>() / teeth.len().saturating_sub(1).max(1) as f64;
    let width = (TOOTH * sheet.scale).min(if teeth.len() > 1 { TOOTH_PART * mean } else { f64::MAX });
    canvas.strokes(teeth.iter().map(<[Pixel; 2]>::as_slice), width, Ink::COMB);
    canvas.stroke(&tips, false, 1.4 * TOOTH * sheet.scale, Ink::COMB_EDGE);
}

/// The floor under a model with heights, and the curves' shadows on it.
fn ground(canvas: &mut Canvas, view: &View, sheet: Sheet, curves: &[Polyline]) {
    let Some(floor) = view.floor() else {
        return;
    };
    canvas.fill(&floor.outline().map(|p| view.at(p)), Ink::FLOOR);
    for [a, b] in floor.lines() {
        canvas.stroke(&[view.at(a), view.at(b)], false, sheet.scale, Ink::FLOOR_LINE);
    }
    for curve in curves {
        let points: Vec<_> = curve.points.iter().map(|p| view.at(floor.below(*p))).collect();
        canvas.stroke(&points, curve.closed, 0.8 * CURVE * sheet.scale, Ink::SHADOW);
    }
}

/// Parts of the curves from far to near, each with a rim that covers what is behind it.
fn curves_in_space(canvas: &mut Canvas, view: &View, sheet: Sheet, curves: &[Polyline]) {
    let mut parts: Vec<(f64, usize, Vec<Point3>)> = Vec::new();
    for curve in curves {
        for part in cut(&curve.points, PART * sheet.scale * view.unit()) {
            let depth = part.iter().map(|p| view.depth(*p)).sum::<f64>() / part.len() as f64;
            parts.push((depth, curve.object, part));
        }
    }
    let order = |part: &(f64, usize, Vec<Point3>)| part.0 + LAYER * part.1 as f64;
    parts.sort_by(|a, b| order(a).total_cmp(&order(b)));
    for (depth, object, part) in parts {
        let points: Vec<_> = part.iter().map(|p| view.at(*p)).collect();
        let width = CURVE * sheet.scale * (0.8 + 0.4 * depth);
        canvas.rim(&points, RIM * sheet.scale);
        canvas.stroke(&points, false, width, Ink::object(object).faded(1.0 - depth));
    }
}

/// Cuts a polyline into parts of about the given length, ends shared; long segments are divided.
fn cut(points: &[Point3], length: f64) -> Vec<Vec<Point3>> {
    let mut parts = Vec::new();
    let mut part: Vec<Point3> = Vec::new();
    let mut sum = 0.0;
    for pair in points.windows(2) {
        let chord = pair[0].distance(pair[1]);
        let steps = (chord / length).ceil().max(1.0);
        for i in 0..steps as usize {
            let (a, b) = (pair[0].lerp(pair[1], i as f64 / steps), pair[0].lerp(pair[1], (i + 1) as f64 / steps));
            if part.is_empty() {
                part.push(a);
            }
            part.push(b);
            sum += chord / steps;
            if sum >= length {
                parts.push(std::mem::take(&mut part));
                sum = 0.0;
            }
        }
    }
    if part.len() > 1 {
        parts.push(part);
    }
    parts
}

fn joints(canvas: &mut Canvas, view: &View, sheet: Sheet, job: &Job<'_>) {
    let joints = drawing::joints(job);
    let s = sheet.scale;
    let radius = drawing::dot_radius(&joints, view.unit() * f64::from(view.width())) / view.unit();
    if drawing::typical_gap(&joints).is_some_and(|gap| gap < JOINT_GAP * s * view.unit()) {
        return;
    }
    for p in joints {
        canvas.dot(view.at(p), radius.clamp(2.3 * s, 4.2 * s));
    }
}

/// The names of the objects beside them.
fn labels(canvas: &mut Canvas, view: &View, mut labels: Labels, job: &Job<'_>, curves: &[Polyline], combs: &Combs) {
    let pixels = |points: &[Point3]| -> Vec<Pixel> { points.iter().map(|p| view.at(*p)).collect() };
    let own: Vec<(usize, Vec<Pixel>)> = curves.iter().map(|curve| (curve.object, pixels(&curve.points))).collect();
    own.iter().for_each(|(_, points)| labels.avoid(points));
    for (x, y) in drawing::joints(job).into_iter().map(|p| view.at(p)) {
        let radius = 4.0 * labels.scale() as f32;
        labels.avoid(&[(x - radius, y - radius), (x + radius, y + radius)]);
    }
    for strip in combs.drawn.iter().flat_map(|comb| &comb.strips) {
        labels.avoid(&strip.tips.iter().map(|t| view.at(t.tip)).collect::<Vec<_>>());
        for tooth in &strip.tips {
            labels.avoid(&[view.at(tooth.foot), view.at(tooth.tip)]);
        }
    }
    for (index, item) in job.model.items.iter().enumerate() {
        let points: Vec<Pixel> =
            own.iter().filter(|(object, _)| *object == index).flat_map(|(_, p)| p.clone()).collect();
        if !points.is_empty() {
            labels.write(canvas, &item.name, &points, Ink::object(index));
        }
    }
}

/// Up in the world.
const UP: Vec3 = Vec3::Z;
