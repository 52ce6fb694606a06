//! What is said on a sheet beside the drawing: above it the title with the unit, below it the scale bar and the
//! [legend](super::legend). Both have bands of their own, so that no text lies on a curve.

use super::canvas::{Canvas, Ink, Pixel};
use super::legend::Legend;
use super::lettering;
use super::sheet::{ROW, Sheet, TEXT};
use crate::export::error::ExportError;
use crate::export::job::Job;
use cyclide::{ShortNumber, model::Units};

/// The part of a picture of a given height that belongs to the drawing, at least.
const LEAST_DRAWING: f64 = 0.3;
/// Heights of capitals and distances, pixels of a picture of the usual width.
const TITLE: f64 = 21.0;
const HEADER: f64 = 86.0;
const FOOTER: f64 = 40.0;
/// Length of the scale bar at most.
const BAR: f64 = 240.0;
const BAR_WITH_NOTE: f64 = 180.0;

/// What is said beside the drawing.
pub(super) struct Caption {
    title: String,
    unit: &'static str,
    symbol: &'static str,
    /// What the colors and numbers stand for.
    pub(super) legend: Legend,
}

impl Caption {
    /// The caption of a model with its legend; `None` for a plain picture.
    pub(super) fn new(job: &Job<'_>, legend: Legend) -> Option<Self> {
        if job.options.png_plain {
            return None;
        }
        let unit = match job.units() {
            Units::Millimetre => "millimeters",
            Units::Centimetre => "centimeters",
            Units::Metre => "meters",
            Units::Inch => "inches",
            Units::Foot => "feet",
            Units::UsSurveyFoot => "US survey feet",
        };
        // A title that cannot be drawn is left out.
        let title = lettering::drawable(job.title()).map(|title| title.text).unwrap_or_default();
        Some(Self { title, unit, symbol: job.units().symbol(), legend })
    }

    /// Height of the band above the drawing.
    pub(super) fn header(&self, sheet: Sheet) -> f64 {
        (HEADER * sheet.scale).round()
    }

    /// Height of the band below it.
    pub(super) fn footer(&self, sheet: Sheet) -> f64 {
        ((FOOTER + ROW * self.legend.rows(sheet)) * sheet.scale).round()
    }

    /// Draws the caption on a picture of this height; `unit` is the length of a pixel, `note` is said behind the scale.
    pub(super) fn draw(&self, canvas: &mut Canvas, sheet: Sheet, height: f64, unit: f64, note: &str) {
        let (s, left) = (sheet.scale, sheet.margin());
        let title = lettering::fitted(&self.title, TITLE * s, sheet.width - 2.0 * left - 260.0 * s);
        let base = (38.0 + TITLE) * s;
        canvas.text(&title, (left, base), TITLE * s, Ink::TEXT);
        let gap = if title.is_empty() { 0.0 } else { 22.0 * s };
        let behind = left + lettering::width(&title, TITLE * s) + gap;
        canvas.text(self.unit, (behind, base), TEXT * s, Ink::SOFT);

        let top = height - self.footer(sheet) + 0.2 * FOOTER * s;
        let bar = ScaleBar::new(unit, if note.is_empty() { BAR } else { BAR_WITH_NOTE } * s);
        let text = format!("{} {}{note}", ShortNumber(bar.length), self.symbol);
        bar.draw(canvas, sheet, (left, top + 0.5 * ROW * s), &text);
        self.legend.draw(canvas, sheet, top);
    }
}

impl Sheet {
    /// Refuses a height at which title and legend leave the drawing no room.
    pub(super) fn check_room(self, caption: Option<&Caption>) -> Result<(), ExportError> {
        let bands = caption.map_or(0.0, |c| c.header(self) + c.footer(self));
        let least = (bands / (1.0 - LEAST_DRAWING)).ceil();
        if !self.fixed || self.height >= least {
            return Ok(());
        }
        let (height, width) = (self.height, self.width);
        let detail = format!(
            "a height of {height} pixels leaves no room for the drawing: title and legend take {bands} at a width of \
             {width}; use at least {least}, or omit title and legend with --png-plain"
        );
        Err(ExportError::Picture { detail })
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
