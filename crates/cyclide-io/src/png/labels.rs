//! Names of many objects beside them, where they hide the least.

use super::canvas::{Canvas, Ink, Pixel};
use super::lettering;
use super::sheet::Sheet;
use std::collections::HashSet;

/// Cells in which the drawing is remembered, and distances from the object tried, pixels of a usual picture.
const CELL: f64 = 6.0;
const GAPS: [f64; 4] = [16.0, 26.0, 44.0, 70.0];

/// Where a drawing has ink.
pub(super) struct Labels {
    sheet: Sheet,
    cell: f64,
    /// Left, upper and lower end of the room for labels.
    room: [f64; 3],
    taken: HashSet<(i64, i64)>,
}

/// A rectangle in pixels.
#[derive(Debug, Clone, Copy)]
struct Place {
    left: f64,
    top: f64,
    right: f64,
    bottom: f64,
}

impl Labels {
    pub(super) fn new(sheet: Sheet, room: [f64; 3]) -> Self {
        Self { sheet, cell: CELL * sheet.scale, room, taken: HashSet::new() }
    }

    pub(super) fn scale(&self) -> f64 {
        self.sheet.scale
    }

    /// Lines of the drawing.
    pub(super) fn avoid(&mut self, points: &[Pixel]) {
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|(x, y)| (f64::from(x), f64::from(y)));
            let steps = ((b.0 - a.0).hypot(b.1 - a.1) / self.cell).ceil().clamp(1.0, 1e5);
            for i in 0..=steps as usize {
                let part = i as f64 / steps;
                let at = |a: f64, b: f64| ((a + (b - a) * part) / self.cell).floor() as i64;
                self.taken.insert((at(a.0, b.0), at(a.1, b.1)));
            }
        }
    }

    /// Writes a name beside an object whose curves have these pixels.
    pub(super) fn write(&mut self, canvas: &mut Canvas, name: &str, points: &[Pixel], ink: Ink) {
        let size = 0.93 * self.sheet.text_size();
        let text = lettering::fitted(name, size, 0.4 * self.sheet.width);
        let wide = lettering::width(&text, size);
        let first = Place { left: f64::MAX, top: f64::MAX, right: f64::MIN, bottom: f64::MIN };
        let own = points.iter().fold(first, |b, (x, y)| {
            let (x, y) = (f64::from(*x), f64::from(*y));
            Place { left: b.left.min(x), top: b.top.min(y), right: b.right.max(x), bottom: b.bottom.max(y) }
        });
        let (x, y) = (0.5 * (own.left + own.right - wide), 0.5 * (own.top + own.bottom - size));
        let mut best: Option<(usize, Place)> = None;
        for gap in GAPS.map(|gap| gap * self.sheet.scale) {
            let (below, above) = (own.bottom + gap, own.top - gap - size);
            let (before, behind) = (own.left - gap - wide, own.right + gap);
            let corners = [
                (x, below),
                (x, above),
                (behind, y),
                (before, y),
                (own.left, below),
                (own.right - wide, below),
                (own.left, above),
                (own.right - wide, above),
                (x, y),
            ];
            for (left, top) in corners {
                let place = Place { left, top, right: left + wide, bottom: top + size };
                let cost = self.cost(place);
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, place));
                }
            }
        }
        if let Some((_, place)) = best {
            canvas.label(&text, (place.left, place.bottom), size, ink);
            self.cells(place).for_each(|cell| {
                self.taken.insert(cell);
            });
        }
    }

    /// How much a label would hide.
    fn cost(&self, place: Place) -> usize {
        let [left, top, bottom] = self.room;
        let margin = 0.4 * self.sheet.margin();
        let outside =
            place.left < left || place.right > self.sheet.width - margin || place.top < top || place.bottom > bottom;
        self.cells(place).filter(|cell| self.taken.contains(cell)).count() + if outside { 10_000 } else { 0 }
    }

    /// The cells of a place and a rim round it.
    fn cells(&self, place: Place) -> impl Iterator<Item = (i64, i64)> + use<> {
        let rim = self.cell;
        let at = |v: f64| (v / self.cell).floor() as i64;
        let (left, right) = (at(place.left - rim), at(place.right + rim));
        let (top, bottom) = (at(place.top - rim), at(place.bottom + 1.3 * rim));
        (top..=bottom).flat_map(move |y| (left..=right).map(move |x| (x, y)))
    }
}
