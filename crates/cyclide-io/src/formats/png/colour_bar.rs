//! The scale of a picture's colors: a bar with round numbers, the name of the quantity, its least and greatest value.

use super::canvas::{Canvas, Ink, Pixel};
use super::lettering;
use super::sheet::{ROW, Sheet, TEXT};
use crate::drawing::palette::on_screen;
use crate::drawing::value_scale::ValueScale;
use cyclide::ShortNumber;

/// Rows of the legend that the bar takes.
pub(super) const ROWS: f64 = 2.7;
/// Height of the bar, of its ticks, and of the marks at least and greatest value; pixels of a usual picture.
const HEIGHT: f64 = 20.0;
const TICK: f64 = 7.0;
const MARK: f64 = 9.0;
/// Room of a number on the scale.
const BETWEEN: f64 = 110.0;
/// Where the marks of the legend below begin.
const INDENT: f64 = 4.0;
/// Longer bars are no better read.
const LONGEST: f64 = 900.0;
/// Least room between two numbers, heights of capitals.
const APART: f64 = 1.0;

/// A bar with what is said at it.
pub(super) struct ColourBar {
    name: String,
    scale: ValueScale,
}

/// Where things stand on a bar, pixels from its left end.
struct Plan {
    /// Numbers with the place of their tick.
    ticks: Vec<(f64, String)>,
    /// The text over the left and the right end.
    ends: [String; 2],
}

impl ColourBar {
    pub(super) fn new(name: String, scale: ValueScale) -> Self {
        Self { name, scale }
    }

    fn plan(&self, sheet: Sheet, length: f64) -> Plan {
        let [low, high] = self.scale.shown;
        let place = |v: f64| if self.scale.is_one_value() { 0.5 * length } else { (v - low) / (high - low) * length };
        let size = sheet.text_size();
        let mut ticks: Vec<(f64, String)> = Vec::new();
        let mut count = (length / (BETWEEN * sheet.scale)).max(2.0);
        // Long numbers have fewer.
        for _ in 0..4 {
            let values = self.scale.ticks(count);
            let step = values.windows(2).map(|pair| pair[1] - pair[0]).next();
            let largest = values.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            ticks = values.into_iter().map(|v| (place(v), number(v, step, largest))).collect();
            let width = |text: &str| lettering::width(text, size);
            let apart = |a: &(f64, String), b: &(f64, String)| b.0 - a.0 - 0.5 * (width(&a.1) + width(&b.1));
            if ticks.windows(2).all(|pair| apart(&pair[0], &pair[1]) >= APART * size) {
                break;
            }
            count *= 0.6;
        }
        let clipped = self.scale.is_clipped();
        let end = |k: usize, word: &str| match self.scale.all[k] {
            v if !v.is_finite() => format!("{word} without bound, clipped"),
            v if clipped[k] => format!("{word} {}, clipped", ShortNumber(v)),
            v => format!("{word} {}", ShortNumber(v)),
        };
        let ends =
            if self.scale.is_one_value() { [String::new(), String::new()] } else { [end(0, "min"), end(1, "max")] };
        Plan { ticks, ends }
    }

    /// Draws it in the rows below `top`, from `left` to `right` at most.
    pub(super) fn draw(&self, canvas: &mut Canvas, sheet: Sheet, (left, right): (f64, f64), top: f64) {
        let (s, size) = (sheet.scale, sheet.text_size());
        let clipped = self.scale.is_clipped();
        // Room for the points of the bar where values lie beyond its ends.
        let arrow = HEIGHT * s;
        let [before, behind] = clipped.map(|clipped| if clipped { arrow } else { 0.0 });
        // Whole pixels: strips that end inside one would be mixed with what is below.
        let x = (left + INDENT * s + before).round();
        let length = ((right - x).min(LONGEST * s) - behind).floor().max(1.0);
        let plan = self.plan(sheet, length);
        let line = |row: f64| top + (row + 0.5) * ROW * s + 0.5 * TEXT * s;
        let upper = (top + 1.12 * ROW * s).round();
        let lower = upper + (HEIGHT * s).round().max(1.0);
        let [low, high] = self.scale.shown;
        let steps = length.ceil().max(2.0) as usize;
        for k in 0..steps {
            let value = low + (high - low) * (k as f64 + 0.5) / steps as f64;
            let ink = Ink::of_screen(on_screen(self.scale.colour(value)));
            let ends = [k, k + 1].map(|k| (x + length * k as f64 / steps as f64) as f32);
            canvas.fill(&rectangle(ends, [upper as f32, lower as f32]), ink);
        }
        let middle = 0.5 * (upper + lower);
        let outline: Vec<Pixel> = {
            let tip = |k: usize| if clipped[k] { 0.75 * arrow } else { 0.0 };
            let ends = [(x - tip(0), x), (x + length + tip(1), x + length)];
            [
                (ends[0].0, middle),
                (ends[0].1, upper),
                (ends[1].1, upper),
                (ends[1].0, middle),
                (ends[1].1, lower),
                (ends[0].1, lower),
            ]
            .map(|(x, y)| (x as f32, y as f32))
            .to_vec()
        };
        for (k, end, at) in [(0, low, x), (1, high, x + length)] {
            if clipped[k] {
                let tip = if k == 0 { at - 0.75 * arrow } else { at + 0.75 * arrow };
                let points = [(at, upper), (tip, middle), (at, lower)].map(|(x, y)| (x as f32, y as f32));
                canvas.fill(&points, Ink::of_screen(on_screen(self.scale.colour(end))));
            }
        }
        canvas.stroke(&outline, true, 1.2 * s, Ink::SOFT);
        for (at, number) in &plan.ticks {
            let tick = [(x + at, lower), (x + at, lower + TICK * s)].map(|(x, y)| (x as f32, y as f32));
            canvas.stroke(&tick, false, 1.4 * s, Ink::TEXT);
            let start = x + at - 0.5 * lettering::width(number, size);
            canvas.text(number, (start, lower + (TICK + 6.0) * s + size), size, Ink::TEXT);
        }
        self.draw_words(canvas, sheet, &plan, (x, length, line(0.0)));
        if !self.scale.is_one_value() {
            for (at, towards) in [(x, 1.0), (x + length, -1.0)] {
                let mark = [
                    (at, upper - 1.5 * s),
                    (at, upper - 1.5 * s - MARK * s),
                    (at + towards * 0.7 * MARK * s, upper - 1.5 * s - MARK * s),
                ];
                canvas.fill(&mark.map(|(x, y)| (x as f32, y as f32)), Ink::TEXT);
            }
        }
    }

    /// The name in the middle, least and greatest value at the ends; on a narrow sheet the name is cut.
    fn draw_words(&self, canvas: &mut Canvas, sheet: Sheet, plan: &Plan, (x, length, base): (f64, f64, f64)) {
        let size = sheet.text_size();
        let [first, last] = plan.ends.each_ref().map(|text| lettering::width(text, size));
        canvas.text(&plan.ends[0], (x, base), size, Ink::SOFT);
        canvas.text(&plan.ends[1], (x + length - last, base), size, Ink::SOFT);
        let gap = 1.4 * size;
        let room = length - first - last - 2.0 * gap;
        let name = lettering::fitted(&self.name, size, room.max(0.0));
        let wide = lettering::width(&name, size);
        let start =
            (x + 0.5 * (length - wide)).clamp(x + first + gap, (x + length - last - gap - wide).max(x + first + gap));
        canvas.text(&name, (start, base), size, Ink::TEXT);
    }
}

/// A round number in the digits that its step to the next needs, in the form that goes with the largest beside it.
fn number(v: f64, step: Option<f64>, largest: f64) -> String {
    let Some(step) = step else { return ShortNumber(v).to_string() };
    let decade = |v: f64| v.abs().log10().floor() as i32;
    // Multiples of a step miss it by rounding: 0.30000000000000004, and zero may have a sign.
    let v = if v.abs() < 0.5 * step { 0.0 } else { v };
    let behind = -decade(step * (1.0 + 1e-9));
    match v {
        0.0 => "0".to_owned(),
        _ if (1e-4..1e7).contains(&(largest * (1.0 + 1e-9))) && behind <= 9 => {
            format!("{v:.*}", behind.max(0) as usize)
        }
        _ => format!("{v:.*e}", (decade(v * (1.0 + 1e-9)) + behind).clamp(0, 12) as usize),
    }
}

fn rectangle([left, right]: [f32; 2], [upper, lower]: [f32; 2]) -> [Pixel; 4] {
    [(left, upper), (right, upper), (right, lower), (left, lower)]
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;

    #[test]
    fn numbers_on_a_bar_are_round_and_do_not_overlap() {
        for (width, scale) in [(1600.0, 1.0), (400.0, 0.5), (200.0, (0.125_f64).sqrt())] {
            let sheet = Sheet { width, height: 0.75 * width, fixed: false, scale };
            for range in [[-0.31, 0.52], [-1.234e-9, 5.6e-8], [0.0, 123_456.0], [999.9998, 1000.0002], [-3e12, -1e11]] {
                let values = ValueScale::new(range.iter().map(|v| (*v, 1.0)).collect(), 0.0).unwrap();
                let bar = ColourBar::new("Gaussian curvature, 1/m²".to_owned(), values);
                let length = 0.4 * width;
                let plan = bar.plan(sheet, length);
                assert!(!plan.ticks.is_empty(), "{range:?} at {width}");
                for (k, (place, text)) in plan.ticks.iter().enumerate() {
                    let value: f64 = text.parse().unwrap();
                    // The number says where it stands, to the digits that are written.
                    let there = (value - range[0]) / (range[1] - range[0]) * length;
                    let digits = 2e-5 * value.abs() / (range[1] - range[0]) * length;
                    assert!((there - place).abs() < 0.5 + digits, "{text} at {place}, not {there}");
                    if let Some((next, other)) = plan.ticks.get(k + 1) {
                        let half = 0.5
                            * (lettering::width(text, sheet.text_size()) + lettering::width(other, sheet.text_size()));
                        assert!(next - place > half, "{text} and {other} at {width}");
                    }
                }
            }
        }
    }
}
