//! Axes: a ruled border for drawings seen along an axis, three arrows for the others.

use super::canvas::{Canvas, Ink, Pixel};
use super::lettering;
use super::sheet::Sheet;
use super::view::{View, multiples, round_step};
use cyclide::{ShortNumber, Vec3};

/// Distance of the numbers, pixels of a picture of the usual width, at least.
const STEP: f64 = 130.0;
const GAP: f64 = 16.0;
const ROOM: f64 = 60.0;
const TICK: f64 = 7.0;
const ARROW: f64 = 58.0;
const NAMES: [(&str, Vec3); 3] = [("x", Vec3::X), ("y", Vec3::Y), ("z", Vec3::Z)];

/// Rulers at the left and below with the coordinates of the drawing: for views along an axis of the model.
///
/// The room for labels begins at the returned pixel. Coordinates count along the axis of the model that points to the right (up), or back.
pub(super) fn rulers(canvas: &mut Canvas, view: &View, sheet: Sheet, far: bool) -> f64 {
    let (s, size) = (sheet.scale, 0.87 * sheet.text_size());
    let area = view.area();
    let step = round_step(STEP * s * view.unit());
    let (left, bottom) = view.flat_at(area.min.x, area.min.y);
    let (right, top) = view.flat_at(area.max.x, area.max.y);
    // Names of objects need the room beside the drawing: the ruler stands at the border then.
    let near = left - GAP * s;
    let (x0, y0) = (if far { near.min(sheet.margin() + ROOM * s) } else { near }, bottom + GAP * s);
    let pixel = |x: f64, y: f64| -> Pixel { (x as f32, y as f32) };
    canvas.stroke(&[pixel(left, y0), pixel(right, y0)], false, 1.4 * s, Ink::SOFT);
    canvas.stroke(&[pixel(x0, bottom), pixel(x0, top)], false, 1.4 * s, Ink::SOFT);
    let [along, up, _] = view.axes();
    let sign = |v: Vec3| if v.x + v.y + v.z < 0.0 { -1.0 } else { 1.0 };
    let number = |v: f64, sign: f64| ShortNumber(if v == 0.0 { 0.0 } else { v * sign }).to_string();
    for value in multiples(area.min.x, area.max.x, step) {
        let (x, _) = view.flat_at(value, 0.0);
        canvas.stroke(&[pixel(x, y0), pixel(x, y0 + TICK * s)], false, 1.4 * s, Ink::SOFT);
        let text = number(value, sign(along));
        let start = x - 0.5 * lettering::width(&text, size);
        canvas.text(&text, (start, y0 + (TICK + 7.0) * s + size), size, Ink::SOFT);
    }
    for value in multiples(area.min.y, area.max.y, step) {
        let (_, y) = view.flat_at(0.0, value);
        canvas.stroke(&[pixel(x0, y), pixel(x0 - TICK * s, y)], false, 1.4 * s, Ink::SOFT);
        let text = number(value, sign(up));
        let start = x0 - (TICK + 7.0) * s - lettering::width(&text, size);
        canvas.text(&text, (start, y + 0.5 * size), size, Ink::SOFT);
    }
    let name = |v: Vec3| NAMES.iter().find(|(_, axis)| axis.dot(v).abs() > 0.9).map_or("", |(name, _)| *name);
    canvas.text(name(along), (right + 12.0 * s, y0 + 0.4 * size), size, Ink::TEXT);
    canvas.text(name(up), (x0 - 0.3 * size, top - 12.0 * s), size, Ink::TEXT);
    x0 + 4.0 * s
}

/// The directions of the axes, right above the footer at the right.
pub(super) fn arrows(canvas: &mut Canvas, [right, up, toward]: [Vec3; 3], sheet: Sheet, bottom: f64) {
    let (s, size) = (sheet.scale, sheet.text_size());
    let (x, y) = (sheet.width - sheet.margin() - 1.4 * ARROW * s, bottom - 1.2 * ARROW * s);
    let mut axes = NAMES;
    axes.sort_by(|a, b| a.1.dot(toward).total_cmp(&b.1.dot(toward)));
    for (name, axis) in axes {
        let (dx, dy) = (axis.dot(right), -axis.dot(up));
        let length = dx.hypot(dy);
        // An axis along the view is a point.
        if length < 0.15 {
            continue;
        }
        let at = |along: f64, aside: f64| -> Pixel {
            let (u, v) = (dx / length, dy / length);
            let along = ARROW * s * along;
            ((x + dx * along - v * aside * s) as f32, (y + dy * along + u * aside * s) as f32)
        };
        let head = 0.16 / length;
        canvas.stroke(&[at(0.0, 0.0), at(1.0 - head, 0.0)], false, 2.2 * s, Ink::TEXT);
        canvas.fill(&[at(1.0, 0.0), at(1.0 - head, 4.5), at(1.0 - head, -4.5)], Ink::TEXT);
        let (tx, ty) = at(1.0 + 0.28 / length, 0.0);
        let start = (f64::from(tx) - 0.5 * lettering::width(name, size), f64::from(ty) + 0.36 * size);
        canvas.label(name, start, size, Ink::TEXT);
    }
}
