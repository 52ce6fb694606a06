//! PNG: a picture to look at, drawn on the processor, the same bytes every time.
//!
//! Curves of the plane are shown from above with their curvature comb and joints; a model with heights is shown
//! from the side and above (parallel projection), nearer parts darker and in front, with the shadow of each curve on
//! the ground below. A model with surfaces is shown in perspective, shaded, with its parameter circles and with the
//! curves among the surfaces ([`scene`]). The promised bound is half a pixel.

mod canvas;
mod scene;
mod view;

use crate::drawing;
use crate::export_error::ExportError;
use crate::exported::{Exported, Promise};
use crate::job::Job;
use canvas::{Canvas, Ink};
use cyclide::{Exactness, Point3, Vec3, flatten};
use view::View;

/// Largest picture, pixels.
const WIDTH: f64 = 1600.0;
const HEIGHT: f64 = 1200.0;
/// Flattening, pixels: well below what anti-aliasing shows.
const FLATNESS: f64 = 0.05;
/// Width of a curve, of a comb's teeth, and of the pale rim that lifts a near curve off a far one.
const CURVE: f64 = 3.4;
const TOOTH: f64 = 1.0;
const RIM: f64 = 9.0;
/// Joints closer together than this are not marked: they would hide the curve.
const JOINT_GAP: f64 = 14.0;
/// Length of the parts that a curve in space is cut into for hiding, pixels.
const PART: f64 = 24.0;
/// Depth by which each object is drawn in front of the one before it: two that run side by side must not take turns.
const LAYER: f64 = 0.03;

/// Draws the model.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    if !job.bodies.is_empty() {
        return scene::write(job);
    }
    let size = job.size();
    let combs = if job.options.png_plain { Vec::new() } else { drawing::combs(job, size) };
    let heights = job.bounds.max.z - job.bounds.min.z > 1e-6 * size;
    let rough = curves(job, 1e-3 * size)?;
    let visible = rough.iter().flat_map(|c| c.points.iter().copied());
    let tips = combs.iter().flatten().map(|(_, tip)| *tip);
    let view = View::new(visible.chain(tips), heights, (WIDTH, HEIGHT));
    let mut canvas = Canvas::new(view.width(), view.height()).ok_or_else(|| picture("it has no size"))?;
    let curves = curves(job, FLATNESS * view.unit())?;

    if heights {
        ground(&mut canvas, &view, &curves);
    }
    for comb in &combs {
        teeth(&mut canvas, &view, comb);
    }
    if heights {
        curves_in_space(&mut canvas, &view, &curves);
    } else {
        for curve in &curves {
            let points: Vec<_> = curve.points.iter().map(|p| view.at(*p)).collect();
            canvas.stroke(&points, curve.closed, CURVE, Ink::object(curve.object));
        }
    }
    joints(&mut canvas, &view, job);
    let bytes = canvas.encode().map_err(|e| picture(&e))?;
    let mut promise = Promise::EXACT;
    promise.add(Exactness::Within(0.5 * view.unit()));
    Ok(promise.exported(bytes, Vec::new()))
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

fn teeth(canvas: &mut Canvas, view: &View, comb: &[(Point3, Point3)]) {
    let feet: Vec<_> = comb.iter().map(|(foot, _)| view.at(*foot)).collect();
    let tips: Vec<_> = comb.iter().map(|(_, tip)| view.at(*tip)).collect();
    let area: Vec<_> = feet.iter().chain(tips.iter().rev()).copied().collect();
    canvas.fill(&area, Ink::COMB_AREA);
    for (foot, tip) in feet.iter().zip(&tips) {
        canvas.stroke(&[*foot, *tip], false, TOOTH, Ink::COMB);
    }
    canvas.stroke(&tips, false, 1.3 * TOOTH, Ink::COMB_EDGE);
}

/// The floor under a model with heights, and the curves' shadows on it.
fn ground(canvas: &mut Canvas, view: &View, curves: &[Polyline]) {
    let floor = view.floor();
    canvas.fill(&floor.outline().map(|p| view.at(p)), Ink::FLOOR);
    for [a, b] in floor.lines() {
        canvas.stroke(&[view.at(a), view.at(b)], false, 1.0, Ink::FLOOR_LINE);
    }
    for curve in curves {
        let points: Vec<_> = curve.points.iter().map(|p| view.at(floor.below(*p))).collect();
        canvas.stroke(&points, curve.closed, 0.8 * CURVE, Ink::SHADOW);
    }
}

/// Parts of the curves from far to near, each with a rim that covers what is behind it.
fn curves_in_space(canvas: &mut Canvas, view: &View, curves: &[Polyline]) {
    let mut parts: Vec<(f64, usize, Vec<Point3>)> = Vec::new();
    for curve in curves {
        for part in cut(&curve.points, PART * view.unit()) {
            let depth = part.iter().map(|p| view.depth(*p)).sum::<f64>() / part.len() as f64;
            parts.push((depth, curve.object, part));
        }
    }
    let order = |part: &(f64, usize, Vec<Point3>)| part.0 + LAYER * part.1 as f64;
    parts.sort_by(|a, b| order(a).total_cmp(&order(b)));
    for (depth, object, part) in parts {
        let points: Vec<_> = part.iter().map(|p| view.at(*p)).collect();
        canvas.rim(&points, RIM);
        canvas.stroke(&points, false, CURVE * (0.8 + 0.4 * depth), Ink::object(object).faded(1.0 - depth));
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

fn joints(canvas: &mut Canvas, view: &View, job: &Job<'_>) {
    let joints = drawing::joints(job);
    let radius = drawing::dot_radius(&joints, view.unit() * f64::from(view.width())) / view.unit();
    if drawing::typical_gap(&joints).is_some_and(|gap| gap < JOINT_GAP * view.unit()) {
        return;
    }
    for p in joints {
        canvas.dot(view.at(p), radius.clamp(2.3, 4.2));
    }
}

/// Up in the world.
const UP: Vec3 = Vec3::Z;
