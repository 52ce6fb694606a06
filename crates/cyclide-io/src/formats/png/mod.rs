//! PNG: a picture to look at, drawn on the processor, the same bytes every time.
//!
//! Curves of the plane are shown from above with their curvature comb and joints; a model with heights is shown
//! from the side and above (parallel projection), nearer parts darker and in front, with the shadow of each curve on
//! the ground below. A model with surfaces is shown in perspective, shaded, with its parameter circles and with the
//! curves among the surfaces ([`scene`]). The promised bound is half a pixel.
//!
//! Title, unit, scale bar and legend have bands of their own above and below ([`caption`], [`legend`]); objects that are too many
//! for a legend of colors are named where they stand or, where names have no room, numbered ([`labels`]).

mod axes;
mod canvas;
mod caption;
mod colour_bar;
mod eye;
mod labels;
mod legend;
mod lettering;
mod marks;
mod names;
mod polyline;
mod scene;
mod sheet;
mod ticks;
mod view;

use crate::drawing::{self, CombStrip, Combs};
use crate::export::camera::Camera;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Promise, Written};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::options::PictureColour;
use crate::formats::entry::Entry;
use axes::{Plan, Rulers};
use canvas::{Canvas, Ink, Pixel, picture};
use caption::Caption;
use cyclide::{Point3, Vec3};
use eye::UP;
use labels::{Labels, Name};
use legend::{Legend, Naming};
use marks::DATA;
use names::Names;
use polyline::{CURVE, FLATNESS, Polyline, curves};
use sheet::Sheet;
use view::View;

/// Widths in a picture of the usual width: of a comb's teeth, and of the pale rim that lifts a near curve off a far one.
const TOOTH: f64 = 1.0;
const RIM: f64 = 9.0;
/// Teeth are at most this part of their distance wide: a close comb is paler, not solid.
const TOOTH_PART: f64 = 0.4;
/// Length of the dashes of a curve that covers another.
const DASH: f64 = 16.0;
/// Joints closer together than this are not marked: they would hide the curve.
const JOINT_GAP: f64 = 14.0;
/// Length of the parts that a curve in space is cut into for hiding, pixels.
const PART: f64 = 24.0;
/// Names of points that are tried at most.
const MOST_POINT_NAMES: usize = 5000;
/// Depth by which each object is drawn in front of the one before it: two that run side by side must not take turns.
const LAYER: f64 = 0.03;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "png",
    title: "a picture",
    suffixes: &["png"],
    lacks: None,
    animates: false,
    holds_exact_only: false,
    forms: |_| Forms::NONE,
    write,
    reading: None,
};

/// Draws the model.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let sheet = Sheet::new(job)?;
    let mut names = Names::new(job);
    if job.options.png_colour == PictureColour::Field
        && let Some(picture) = scene::field::write(job, sheet, &names)?
    {
        return Ok(picture);
    }
    if !job.bodies.is_empty() {
        return scene::write(job, sheet, names);
    }
    let size = job.size();
    let heights = job.bounds.max.z - job.bounds.min.z > 1e-6 * size;
    let rough: Vec<Point3> = curves(job, 1e-3 * size)?.into_iter().flat_map(|c| c.points).collect();
    let axes = eye::axes(&rough, heights, job.options.camera);
    let combs = if job.options.png_plain { Combs::default() } else { drawing::combs(job, size, [axes[0], axes[1]]) };
    let shown: Vec<Point3> = rough.into_iter().chain(combs.tips()).collect();
    let request = Request { job, sheet, names: &names.drawn, combs: &combs, shown: &shown, axes, heights };
    let several = job.options.png_labels && job.model.items.len() > 1;
    let mut drawing =
        request.drawing(if several || legend::is_crowded(job) { Naming::Names } else { Naming::Colours })?;
    if drawing.naming == Naming::Names && !drawing.place_names() {
        // The legend takes more room then.
        drawing = request.drawing(Naming::Numbers)?;
    }
    let bytes = drawing.draw()?.encode().map_err(|e| picture(&e))?;
    // A picture has no parts that could be told apart.
    let written = Written { bodies: vec![Promise::proved(0.5 * drawing.view.unit())], ..Written::default() };
    names.notes.extend(combs.left_out_note(|index| &names.drawn[index]));
    if drawing.without_room > 0 {
        let without = drawing.without_room;
        names.notes.push(format!("there is no room for the names of {without} points: increase --width"));
    }
    Ok(written.exported(bytes, names.notes))
}

/// What is to be drawn.
#[derive(Clone, Copy)]
struct Request<'a> {
    job: &'a Job<'a>,
    sheet: Sheet,
    names: &'a [String],
    combs: &'a Combs,
    /// Points of all that the picture must show.
    shown: &'a [Point3],
    axes: [Vec3; 3],
    heights: bool,
}

/// A drawing of curves with its layout.
struct Drawing<'a> {
    of: Request<'a>,
    naming: Naming,
    rulers: Rulers,
    caption: Option<Caption>,
    view: View,
    curves: Vec<Polyline>,
    labels: Labels,
    placed: Vec<Name>,
    /// Points whose names have no room.
    without_room: usize,
}

impl<'a> Request<'a> {
    fn drawing(self, naming: Naming) -> Result<Drawing<'a>, ExportError> {
        let Self { job, sheet, .. } = self;
        let caption = Caption::new(job, Legend::new(job, self.combs, self.names, naming));
        sheet.check_room(caption.as_ref())?;
        let rulers = match job.options.camera.map_or(!self.heights, Camera::is_along_axis) {
            _ if !job.options.png_axes || caption.is_none() => Rulers::None,
            true => Rulers::Sides,
            false => Rulers::Edges,
        };
        let view = View::new(self.shown, self.axes, self.heights, sheet, caption.as_ref(), rulers);
        let curves = curves(job, FLATNESS * view.unit())?;
        let mut labels =
            Labels::new(sheet, room(sheet, &view, caption.as_ref(), (rulers, naming)), job.model.items.len());
        for curve in &curves {
            let points: Vec<Pixel> = curve.points.iter().map(|p| view.at(*p)).collect();
            labels.add(curve.object, &points);
        }
        for (x, y) in drawing::joints(job).into_iter().map(|p| view.at(p)) {
            let radius = 4.0 * sheet.scale as f32;
            labels.add_joint(&[(x - radius, y - radius), (x + radius, y + radius)]);
        }
        for strip in self.combs.drawn.iter().flat_map(|comb| &comb.strips) {
            labels.avoid(&strip.tips.iter().map(|t| view.at(t.tip)).collect::<Vec<_>>());
            for tooth in &strip.tips {
                labels.avoid(&[view.at(tooth.foot), view.at(tooth.tip)]);
            }
        }
        let placed = Vec::new();
        Ok(Drawing { of: self, naming, rulers, caption, view, curves, labels, placed, without_room: 0 })
    }
}

/// The left, upper and lower end of the room for names and numbers.
fn room(sheet: Sheet, view: &View, caption: Option<&Caption>, (rulers, naming): (Rulers, Naming)) -> [f64; 3] {
    let height = f64::from(view.height());
    let (header, footer) = caption.map_or((0.0, 0.0), |c| (c.header(sheet), c.footer(sheet)));
    let left = match (rulers, naming) {
        (Rulers::Sides, Naming::Numbers) => view.flat_at(view.area().min.x, 0.0).0,
        (Rulers::Sides, _) => axes::far_ruler(sheet),
        (Rulers::None | Rulers::Edges, _) => 0.4 * sheet.margin(),
    };
    [left, header, height - footer]
}

impl Drawing<'_> {
    /// Finds places for all names; false if one has none.
    fn place_names(&mut self) -> bool {
        match self.labels.names(self.of.names) {
            Some(placed) => self.placed = placed,
            None => return false,
        }
        true
    }

    fn draw(&mut self) -> Result<Canvas, ExportError> {
        let Request { job, sheet, combs, names, heights, .. } = self.of;
        let mut canvas =
            Canvas::new(self.view.width(), self.view.height()).ok_or_else(|| picture("its size is zero"))?;
        let view = &self.view;
        ground(&mut canvas, view, sheet, &self.curves);
        for strip in combs.drawn.iter().flat_map(|comb| &comb.strips) {
            teeth(&mut canvas, view, sheet, strip);
        }
        // Below the curves: they stay whole.
        data(&mut canvas, view, sheet, job);
        // A curve that covers another leaves every second dash of it to be seen.
        let covering = self.labels.covering();
        if let Some(caption) = &mut self.caption {
            covering.iter().for_each(|&object| caption.legend.dash(&names[object]));
        }
        if heights && view.axes()[2] != UP {
            curves_in_space(&mut canvas, view, sheet, &self.curves, &covering);
        } else {
            for curve in &self.curves {
                let points: Vec<_> = curve.points.iter().map(|p| view.at(*p)).collect();
                let (width, ink) = (CURVE * sheet.scale, Ink::object(curve.object));
                if covering.contains(&curve.object) {
                    canvas.dashes(&points, curve.closed, width, DASH * sheet.scale, ink);
                } else {
                    canvas.stroke(&points, curve.closed, width, ink);
                }
            }
        }
        joints(&mut canvas, view, sheet, job);
        if job.options.png_labels {
            let named = job.provenances.point_names().take(MOST_POINT_NAMES);
            let named: Vec<(Pixel, String)> = named.map(|(point, name)| (view.at(point), name.to_owned())).collect();
            let placed = self.labels.point_names(&named);
            self.without_room = named.len() - placed.len();
            for (text, start) in placed {
                canvas.label(&text, start, labels::POINT_NAME * sheet.text_size(), Ink::TEXT);
            }
        }
        let Some(caption) = &self.caption else {
            return Ok(canvas);
        };
        match self.rulers {
            Rulers::None => {}
            Rulers::Sides => {
                let at = |x, y| view.flat_at(x, y);
                let (axes, area, symbol) = (view.axes(), view.area(), job.units().symbol());
                let plan = Plan { axes, area, unit: view.unit(), at: &at, symbol };
                axes::rulers(&mut canvas, &plan, sheet, self.naming == Naming::Names);
            }
            Rulers::Edges => {
                let at = |p| {
                    let (x, y) = view.at(p);
                    (f64::from(x), f64::from(y))
                };
                // Of a parallel projection the eye is far away.
                let frame = view.frame();
                let eye = frame.min.midpoint(frame.max) + view.axes()[2] * (1e6 * frame.diagonal());
                axes::edge_rulers(&mut canvas, frame, eye, &at, sheet, job.units().symbol());
            }
        }
        match self.naming {
            Naming::Colours => {}
            Naming::Names => self.labels.draw(&mut canvas, &self.placed),
            Naming::Numbers => self.labels.draw_numbers(&mut canvas, caption.legend.numbers(sheet)),
        }
        caption.draw(&mut canvas, sheet, f64::from(view.height()), view.unit(), "");
        Ok(canvas)
    }
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
fn curves_in_space(canvas: &mut Canvas, view: &View, sheet: Sheet, curves: &[Polyline], covering: &[usize]) {
    let mut parts: Vec<(f64, usize, Vec<Point3>)> = Vec::new();
    for curve in curves {
        let step = if covering.contains(&curve.object) { 2 } else { 1 };
        for part in cut(&curve.points, PART * sheet.scale * view.unit()).into_iter().step_by(step) {
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

/// The data points of fits; of many in one place one is drawn.
fn data(canvas: &mut Canvas, view: &View, sheet: Sheet, job: &Job<'_>) {
    if job.options.png_plain {
        return;
    }
    let radius = DATA * sheet.scale;
    let mut drawn = std::collections::HashSet::new();
    for p in job.provenances.data() {
        let (x, y) = view.at(p);
        if drawn.insert(((x / radius as f32).round() as i64, (y / radius as f32).round() as i64)) {
            canvas.spot((x, y), radius);
        }
    }
}
