//! The sheet of a picture: how large it is, and what is said on it beside the drawing.
//!
//! Above the drawing the title with the unit; below it the scale bar and the legend of the objects. Both have bands of
//! their own, so that no text lies on a curve.

use super::canvas::{Canvas, Ink, Pixel};
use super::lettering;
use crate::drawing::Combs;
use crate::export_error::ExportError;
use crate::job::Job;
use cyclide::{ShortNumber, Units};

/// Width of a picture, pixels: if none is asked for, and least and most.
const WIDTH: f64 = 1600.0;
const WIDTHS: (u32, u32) = (200, 10_000);
/// Height over width at most.
const TALLEST: f64 = 0.75;
/// Heights of capitals and distances, pixels of a picture of the usual width.
const TITLE: f64 = 21.0;
const TEXT: f64 = 15.0;
const MARGIN: f64 = 44.0;
const HEADER: f64 = 86.0;
const ROW: f64 = 34.0;
const FOOTER: f64 = 40.0;
/// Part of the footer that belongs to the scale bar, and the bar's length at most.
const BAR_ROOM: f64 = 400.0;
const BAR: f64 = 240.0;
const BAR_WITH_NOTE: f64 = 180.0;
/// Objects of a legend. More are named where they stand.
pub(super) const MOST_ENTRIES: usize = 6;

/// Sizes on a picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sheet {
    /// Pixels.
    pub(super) width: f64,
    /// Pixels of this picture for one of the usual width: widths of lines and heights of letters are multiplied by it.
    pub(super) scale: f64,
}

impl Sheet {
    /// # Errors
    /// A width that makes no picture.
    pub(super) fn new(job: &Job<'_>) -> Result<Self, ExportError> {
        let width = job.options.png_width.unwrap_or(WIDTH as u32);
        if width < WIDTHS.0 || width > WIDTHS.1 {
            let detail = format!("a width of {width} pixels ({} to {} are possible)", WIDTHS.0, WIDTHS.1);
            return Err(ExportError::Picture { detail });
        }
        let part = f64::from(width) / WIDTH;
        // Lines and letters of small pictures shrink less, or they could not be read.
        Ok(Self { width: f64::from(width), scale: if part < 1.0 { part.sqrt() } else { part } })
    }

    pub(super) fn text_size(self) -> f64 {
        TEXT * self.scale
    }

    pub(super) fn margin(self) -> f64 {
        MARGIN * self.scale
    }

    /// Height of the tallest picture.
    pub(super) fn tallest(self) -> f64 {
        (TALLEST * self.width).round()
    }
}

/// What is said beside the drawing.
pub(super) struct Caption {
    title: String,
    unit: &'static str,
    symbol: &'static str,
    entries: Vec<Entry>,
}

/// A line of the legend.
struct Entry {
    mark: Mark,
    text: String,
}

/// What stands before the text.
#[derive(Debug, Clone, Copy)]
enum Mark {
    /// A curve.
    Line(Ink),
    /// A surface: its colour and that of its lines.
    Field(Ink, Ink),
    Comb,
}

impl Caption {
    /// The caption of a model with its combs; `None` for a plain picture.
    pub(super) fn new(job: &Job<'_>, combs: &Combs) -> Option<Self> {
        if job.options.png_plain {
            return None;
        }
        let unit = match job.units() {
            Units::Millimetre => "millimetres",
            Units::Centimetre => "centimetres",
            Units::Metre => "metres",
            Units::Inch => "inches",
            Units::Foot => "feet",
        };
        let symbol = job.units().symbol();
        let entries = if is_labelled(job) { crowd(combs) } else { legend(job, combs, symbol) };
        Some(Self { title: job.title().to_owned(), unit, symbol, entries })
    }

    /// Height of the band above the drawing.
    pub(super) fn header(&self, sheet: Sheet) -> f64 {
        (HEADER * sheet.scale).round()
    }

    /// Height of the band below it.
    pub(super) fn footer(&self, sheet: Sheet) -> f64 {
        let rows = self.places(sheet).last().map_or(0.0, |(_, _, row)| *row) + 1.0;
        ((FOOTER + ROW * rows) * sheet.scale).round()
    }

    /// The texts of the legend, cut to the room they have, with their places: pixels from the left, and rows.
    fn places(&self, sheet: Sheet) -> Vec<(String, f64, f64)> {
        let s = sheet.scale;
        // On a narrow picture the legend starts below the scale bar.
        let beside = sheet.width - 2.0 * sheet.margin() > 2.2 * BAR_ROOM * s;
        let (left, first) = if beside { (sheet.margin() + BAR_ROOM * s, 0.0) } else { (sheet.margin(), 1.0) };
        let right = sheet.width - sheet.margin();
        let mut at = (left, first);
        let mut places = Vec::new();
        for entry in &self.entries {
            let text = lettering::fitted(&entry.text, sheet.text_size(), right - left - MARK * s);
            let width = MARK * s + lettering::width(&text, sheet.text_size());
            if at.0 > left && at.0 + width > right {
                at = (left, at.1 + 1.0);
            }
            places.push((text, at.0, at.1));
            at.0 += width + BETWEEN * s;
        }
        places
    }

    /// Draws the caption on a picture of this height; `unit` is the length of a pixel, `note` is said behind the scale.
    pub(super) fn draw(&self, canvas: &mut Canvas, sheet: Sheet, height: f64, unit: f64, note: &str) {
        let (s, left) = (sheet.scale, sheet.margin());
        let title = lettering::fitted(&self.title, TITLE * s, sheet.width - 2.0 * left - 260.0 * s);
        let base = (38.0 + TITLE) * s;
        canvas.text(&title, (left, base), TITLE * s, Ink::TEXT);
        let behind = left + lettering::width(&title, TITLE * s) + 22.0 * s;
        canvas.text(self.unit, (behind, base), TEXT * s, Ink::SOFT);

        let top = height - self.footer(sheet) + 0.2 * FOOTER * s;
        let bar = ScaleBar::new(unit, if note.is_empty() { BAR } else { BAR_WITH_NOTE } * s);
        bar.draw(
            canvas,
            sheet,
            (left, top + 0.5 * ROW * s),
            &format!("{} {}{note}", ShortNumber(bar.length), self.symbol),
        );
        for (entry, (text, x, row)) in self.entries.iter().zip(self.places(sheet)) {
            let middle = top + (row + 0.5) * ROW * s;
            entry.mark.draw(canvas, (x, middle), s);
            canvas.text(&text, (x + MARK * s, middle + 0.5 * TEXT * s), TEXT * s, Ink::TEXT);
        }
    }
}

/// Width of a mark with the space behind it, and the space between two entries.
const MARK: f64 = 58.0;
const BETWEEN: f64 = 44.0;

/// True if the objects are named where they stand: there are more than a legend and the colours can tell apart.
pub(super) fn is_labelled(job: &Job<'_>) -> bool {
    job.bodies.is_empty() && job.model.items.len() > MOST_ENTRIES
}

/// One entry for all the combs of many objects.
fn crowd(combs: &Combs) -> Vec<Entry> {
    let mut text = "curvature combs, each to a scale of its own".to_owned();
    if !combs.left_out.is_empty() {
        text += &format!("; {} left out where they would lie on others", combs.left_out.len());
    }
    if combs.drawn.is_empty() { Vec::new() } else { vec![Entry { mark: Mark::Comb, text }] }
}

fn legend(job: &Job<'_>, combs: &Combs, symbol: &str) -> Vec<Entry> {
    let mut entries = Vec::new();
    let items = &job.model.items;
    // The title is name enough for one.
    let named = items.len() > 1;
    for (index, item) in items.iter().enumerate() {
        let comb = combs.drawn.iter().find(|comb| comb.item == index);
        let said = comb.map(|comb| {
            let [k, radius] = [comb.largest, 1.0 / comb.largest].map(|v| ShortNumber(three_digits(v)));
            let cut = if comb.is_cut { ", longest teeth cut" } else { "" };
            match comb.largest.is_finite() {
                true => format!("curvature up to {k} 1/{symbol}, radius {radius} {symbol}{cut}"),
                false => "curvature without bound, longest teeth cut".to_owned(),
            }
        });
        let mark = if item.contours.is_empty() {
            Mark::Field(Ink::surface(index), Ink::object(index))
        } else {
            Mark::Line(Ink::object(index))
        };
        let left_out = combs.left_out.contains(&index).then(|| "comb left out: it would lie on another".to_owned());
        match (named, said.or(left_out)) {
            (true, Some(said)) => entries.push(Entry { mark, text: format!("{}: {said}", item.name) }),
            (true, None) => entries.push(Entry { mark, text: item.name.clone() }),
            (false, Some(said)) => entries.push(Entry { mark: Mark::Comb, text: said }),
            (false, None) => {}
        }
    }
    entries
}

fn three_digits(v: f64) -> f64 {
    format!("{v:.2e}").parse().unwrap_or(v)
}

impl Mark {
    /// Draws it from its left end.
    fn draw(self, canvas: &mut Canvas, (x, y): (f64, f64), s: f64) {
        let at = |dx: f64, dy: f64| -> Pixel { ((x + dx * s) as f32, (y + dy * s) as f32) };
        match self {
            Self::Line(ink) => canvas.stroke(&[at(2.0, 0.0), at(42.0, 0.0)], false, 3.4 * s, ink),
            Self::Field(field, line) => {
                let corners = [at(4.0, 8.0), at(40.0, 8.0), at(40.0, -8.0), at(4.0, -8.0)];
                canvas.fill(&corners, field);
                canvas.stroke(&corners, true, 1.5 * s, line);
            }
            Self::Comb => {
                let arch = |i: u32| -0.5 * (f64::from(i) - 4.0).powi(2);
                let tips: Vec<Pixel> = (0..9).map(|i| at(2.0 + 5.0 * f64::from(i), -2.0 + arch(i) - 2.0)).collect();
                let feet: Vec<Pixel> = (0..9).map(|i| at(2.0 + 5.0 * f64::from(i), 8.0)).collect();
                let teeth: Vec<[Pixel; 2]> = feet.iter().zip(&tips).map(|(a, b)| [*a, *b]).collect();
                canvas.strokes(teeth.iter().map(<[_; 2]>::as_slice), s, Ink::COMB);
                canvas.stroke(&tips, false, 1.3 * s, Ink::COMB_EDGE);
                canvas.stroke(&feet, false, 2.4 * s, Ink::object(0));
            }
        }
    }
}

/// A line of a round length.
pub(super) struct ScaleBar {
    length: f64,
    pixels: f64,
}

impl ScaleBar {
    /// The longest of 1, 2, 5, 10, 20, … that is not longer than `most` pixels, `unit` being the length of one.
    fn new(unit: f64, most: f64) -> Self {
        let room = most * unit;
        let decade = 10_f64.powf(room.log10().floor());
        let length = [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|l| *l <= room).unwrap_or(decade);
        // Powers of ten below one are rounded: 0.2 is the decimal, not ten to the -1 twice.
        let length = format!("{length:.0e}").parse().unwrap_or(length);
        Self { length, pixels: length / unit }
    }

    fn draw(&self, canvas: &mut Canvas, sheet: Sheet, (x, y): (f64, f64), text: &str) {
        let s = sheet.scale;
        let at = |dx: f64, dy: f64| -> Pixel { ((x + dx) as f32, (y + dy) as f32) };
        let end = self.pixels;
        let shape =
            [at(0.0, -6.0 * s), at(0.0, 6.0 * s), at(0.0, 0.0), at(end, 0.0), at(end, -6.0 * s), at(end, 6.0 * s)];
        canvas.strokes([shape.as_slice()], 2.0 * s, Ink::TEXT);
        canvas.text(text, (x + end + 16.0 * s, y + 0.5 * TEXT * s), TEXT * s, Ink::TEXT);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scale_bars_are_round_and_fit() {
        for (unit, length) in [(1.0, 200.0), (0.9, 200.0), (0.1, 20.0), (4.2e-10, 1e-7), (3.0e7, 5e9), (0.00417, 1.0)] {
            let bar = ScaleBar::new(unit, 240.0);
            assert!((bar.length - length).abs() <= 1e-12 * length, "{unit}: {}", bar.length);
            assert!((bar.pixels * unit - length).abs() <= 1e-12 * length && bar.pixels <= 240.0 && bar.pixels > 90.0);
        }
    }
}
