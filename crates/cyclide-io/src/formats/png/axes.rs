//! Rulers with the coordinates of the model: below and at the left of views along an axis, else along three edges of the
//! model's box.

use super::canvas::{Canvas, Ink, Pixel};
use super::lettering;
use super::sheet::Sheet;
use super::ticks::{multiples, round_step};
use cyclide::{Aabb, Point3, ShortNumber, Vec3};

/// Distance of the numbers, pixels of a picture of the usual width, at least: below and at the left, and along edges.
const STEP: f64 = 130.0;
const EDGE_STEP: f64 = 84.0;
/// Edges shorter than this in the picture have no numbers.
const SHORTEST: f64 = 60.0;
const GAP: f64 = 16.0;
const ROOM: f64 = 60.0;
const TICK: f64 = 7.0;
const NAMES: [(&str, Vec3); 3] = [("x", Vec3::X), ("y", Vec3::Y), ("z", Vec3::Z)];

/// The rulers of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rulers {
    None,
    /// Below and at the left.
    Sides,
    /// Along edges of the model's box.
    Edges,
}

impl Rulers {
    /// Room that they take, pixels of a picture of the usual width: at the left, at the right, below.
    pub(super) const fn room(self) -> [f64; 3] {
        match self {
            Self::None => [0.0; 3],
            Self::Sides => [76.0, 0.0, 40.0],
            Self::Edges => [84.0, 84.0, 64.0],
        }
    }
}

/// A drawing seen along an axis.
pub(super) struct Plan<'a> {
    /// Right, up and toward the eye.
    pub(super) axes: [Vec3; 3],
    /// What is shown, in projected coordinates: right and up.
    pub(super) area: Aabb,
    /// Model units per pixel.
    pub(super) unit: f64,
    /// The pixel of projected coordinates.
    pub(super) at: &'a dyn Fn(f64, f64) -> (f64, f64),
    pub(super) symbol: &'a str,
}

/// Where the room for names begins at the right of a ruler that leaves them the room beside the drawing.
pub(super) fn far_ruler(sheet: Sheet) -> f64 {
    sheet.margin() + (ROOM + 4.0) * sheet.scale
}

/// Rulers at the left and below with the coordinates of the drawing: for views along an axis of the model.
///
/// Coordinates count along the axis of the model that points to the right (up), or back; `far` leaves room for names.
pub(super) fn rulers(canvas: &mut Canvas, plan: &Plan<'_>, sheet: Sheet, far: bool) {
    let (s, size, area) = (sheet.scale, 0.87 * sheet.text_size(), plan.area);
    let step = round_step(STEP * s * plan.unit);
    let (left, bottom) = (plan.at)(area.min.x, area.min.y);
    let (right, top) = (plan.at)(area.max.x, area.max.y);
    // Names of objects need the room beside the drawing: the ruler stands at the border then.
    let near = left - GAP * s;
    let (x0, y0) = (if far { near.min(sheet.margin() + ROOM * s) } else { near }, bottom + GAP * s);
    let pixel = |x: f64, y: f64| -> Pixel { (x as f32, y as f32) };
    canvas.stroke(&[pixel(left, y0), pixel(right, y0)], false, 1.4 * s, Ink::SOFT);
    canvas.stroke(&[pixel(x0, bottom), pixel(x0, top)], false, 1.4 * s, Ink::SOFT);
    let [along, up, _] = plan.axes;
    let sign = |v: Vec3| if v.x + v.y + v.z < 0.0 { -1.0 } else { 1.0 };
    for value in multiples(area.min.x, area.max.x, step) {
        let (x, _) = (plan.at)(value, area.min.y);
        canvas.stroke(&[pixel(x, y0), pixel(x, y0 + TICK * s)], false, 1.4 * s, Ink::SOFT);
        let text = number(value * sign(along));
        let start = x - 0.5 * lettering::width(&text, size);
        canvas.text(&text, (start, y0 + (TICK + 7.0) * s + size), size, Ink::SOFT);
    }
    for value in multiples(area.min.y, area.max.y, step) {
        let (_, y) = (plan.at)(area.min.x, value);
        canvas.stroke(&[pixel(x0, y), pixel(x0 - TICK * s, y)], false, 1.4 * s, Ink::SOFT);
        let text = number(value * sign(up));
        let start = x0 - (TICK + 7.0) * s - lettering::width(&text, size);
        canvas.text(&text, (start, y + 0.5 * size), size, Ink::SOFT);
    }
    let name = |v: Vec3| NAMES.iter().find(|(_, axis)| axis.dot(v).abs() > 0.9).map_or("", |(name, _)| *name);
    let named = |v: Vec3| format!("{} {}", name(v), plan.symbol);
    let along = named(along);
    // The name of the axis stays on the picture where the drawing reaches its border.
    let behind = (right + 12.0 * s).min(sheet.width - lettering::width(&along, size) - 4.0 * s);
    canvas.text(&along, (behind, y0 + 0.4 * size), size, Ink::TEXT);
    canvas.text(&named(up), (x0 - 0.3 * size, top - 12.0 * s), size, Ink::TEXT);
}

fn number(v: f64) -> String {
    ShortNumber(if v == 0.0 { 0.0 } else { v }).to_string()
}

/// Rulers along one edge of the model's box for each axis: of the edges on its outline the lowest for x and y, the leftmost
/// for z.
pub(super) fn edge_rulers(
    canvas: &mut Canvas,
    frame: Aabb,
    eye: Point3,
    at: &dyn Fn(Point3) -> (f64, f64),
    sheet: Sheet,
    symbol: &str,
) {
    let middle = at(frame.min.midpoint(frame.max));
    for (axis, (name, _)) in NAMES.iter().enumerate() {
        let edges = outline_edges(frame, eye, axis).into_iter().map(|ends| (ends, ends.map(at)));
        let place = |ends: &[(f64, f64); 2]| {
            // To the left for z; for the others down.
            if axis == 2 { -(ends[0].0 + ends[1].0) } else { ends[0].1 + ends[1].1 }
        };
        let Some((ends, seen)) = edges.max_by(|a, b| place(&a.1).total_cmp(&place(&b.1))) else { continue };
        ruler(canvas, ends, seen, axis, middle, at, sheet, &format!("{name} {symbol}"));
    }
}

/// The edges of a box along an axis, from its lower end to its upper one, that are on the outline as seen from the eye: of
/// the two faces that meet there one is seen.
fn outline_edges(frame: Aabb, eye: Point3, axis: usize) -> Vec<[Point3; 2]> {
    let (min, max, eye) = (frame.min.to_array(), frame.max.to_array(), eye.to_array());
    let [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
    let mut edges = Vec::new();
    for (upper_j, upper_k) in [(false, false), (false, true), (true, false), (true, true)] {
        let seen = |upper: bool, axis: usize| if upper { eye[axis] > max[axis] } else { eye[axis] < min[axis] };
        if seen(upper_j, j) == seen(upper_k, k) {
            continue;
        }
        let mut low = min;
        low[j] = if upper_j { max[j] } else { min[j] };
        low[k] = if upper_k { max[k] } else { min[k] };
        let mut high = low;
        high[axis] = max[axis];
        edges.push([low, high].map(Point3::from));
    }
    edges
}

/// One ruler, its numbers on the side away from the middle of the picture.
#[allow(clippy::too_many_arguments, reason = "a drawing in one place")]
fn ruler(
    canvas: &mut Canvas,
    ends: [Point3; 2],
    [a, b]: [(f64, f64); 2],
    axis: usize,
    middle: (f64, f64),
    at: &dyn Fn(Point3) -> (f64, f64),
    sheet: Sheet,
    name: &str,
) {
    let (s, size) = (sheet.scale, 0.87 * sheet.text_size());
    let seen = (b.0 - a.0).hypot(b.1 - a.1);
    let [low, high] = ends.map(|p| p.to_array()[axis]);
    if !(seen > SHORTEST * s && high > low) {
        return;
    }
    let (mut nx, mut ny) = (-(b.1 - a.1) / seen, (b.0 - a.0) / seen);
    if nx * (a.0 - middle.0) + ny * (a.1 - middle.1) < 0.0 {
        (nx, ny) = (-nx, -ny);
    }
    let pixel = |x: f64, y: f64| -> Pixel { (x as f32, y as f32) };
    canvas.stroke(&[pixel(a.0, a.1), pixel(b.0, b.1)], false, 1.4 * s, Ink::SOFT);
    // A text whose box touches the line at a distance, on its outer side.
    let mut beside = |text: &str, (x, y): (f64, f64), distance: f64, ink: Ink| {
        let wide = lettering::width(text, size);
        let reach = distance + 0.5 * (nx.abs() * wide + ny.abs() * size);
        let (x, y) = (x + nx * reach, y + ny * reach);
        canvas.label(text, (x - 0.5 * wide, y + 0.5 * size), size, ink);
        wide
    };
    let step = round_step(EDGE_STEP * s * (high - low) / seen);
    let mut widest: f64 = 0.0;
    let ticks: Vec<(f64, (f64, f64))> = multiples(low, high, step)
        .map(|value| {
            let mut p = ends[0].to_array();
            p[axis] = value;
            (value, at(Point3::from(p)))
        })
        .collect();
    for (value, place) in &ticks {
        widest = widest.max(beside(&number(*value), *place, (TICK + 6.0) * s, Ink::SOFT));
    }
    let beyond = (TICK + 14.0) * s + nx.abs() * widest + ny.abs() * size;
    beside(name, (0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1)), beyond, Ink::TEXT);
    for (_, (x, y)) in ticks {
        canvas.stroke(&[pixel(x, y), pixel(x + nx * TICK * s, y + ny * TICK * s)], false, 1.4 * s, Ink::SOFT);
    }
}
