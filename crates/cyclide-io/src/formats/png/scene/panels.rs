//! Names of objects, and numbers of the panels of nets, where they are seen.
//!
//! The number of a panel stands at its middle if the middle is seen and the number lies on what is seen of this panel alone; so no two
//! of them overlap. All numbers of a picture have one size and one form: the largest at which most panels in sight have room, in full
//! (`r03-c07`, row and column from 0, as in lists of panels) or short (`3-7`); of nets that join behind the number of the piece
//! (`1-r03-c07`, `1-3-7`). A panel of a solid has its number on both sides.

use super::surface::Surface;
use crate::export::job::Job;
use crate::formats::png::canvas::{Canvas, Ink};
use crate::formats::png::lettering;
use crate::formats::png::sheet::Sheet;
use cyclide::{Point3, model::SurfaceObject, surface::ParamSurface as _};
use std::collections::HashSet;

/// Heights of the capitals of numbers that are tried, pixels of a usual picture, and the least that can be read, pixels.
const SIZES: [f64; 4] = [14.0, 11.5, 9.5, 8.0];
const LEAST: f64 = 6.5;
/// A form and size is taken that leaves out no more than this part.
const MOST: f64 = 0.8;
/// Heights of capitals between a name and what it must not touch.
const AIR: f64 = 0.45;
/// No surface.
const NONE: u32 = u32::MAX;

/// Which surface is seen in the middle of each pixel.
pub(super) struct Seen {
    width: usize,
    surfaces: Vec<u32>,
}

impl Seen {
    pub(super) fn new((width, height): (usize, usize)) -> Self {
        Self { width, surfaces: vec![NONE; width * height] }
    }

    pub(super) fn set(&mut self, x: usize, y: usize, surface: Option<usize>) {
        if let (Some(place), Some(surface)) = (self.surfaces.get_mut(y * self.width + x), surface) {
            *place = surface as u32;
        }
    }

    fn at(&self, (x, y): (f64, f64)) -> u32 {
        if !(x >= 0.0 && y >= 0.0 && x < self.width as f64) {
            return NONE;
        }
        self.surfaces.get(y as usize * self.width + x as usize).copied().unwrap_or(NONE)
    }

    /// True if a rectangle shows this surface alone, as far as rows of samples tell.
    fn shows(&self, surface: u32, [left, top, right, bottom]: [f64; 4]) -> bool {
        let part = |a: f64, b: f64, k: usize, n: usize| a + (b - a) * k as f64 / n as f64;
        (0..=4).all(|j| (0..=8).all(|i| self.at((part(left, right, i, 8), part(top, bottom, j, 4))) == surface))
    }
}

/// The number of a panel: its row and column, and how many digits the rows and columns of its net have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Panel {
    /// One of the picture's panels: the index of its first surface.
    key: u32,
    /// The net, of several that join.
    piece: Option<usize>,
    row: usize,
    column: usize,
    digits: [usize; 2],
}

impl Panel {
    fn words(self, full: bool) -> String {
        let Self { row, column, digits: [of_column, of_row], .. } = self;
        let piece = self.piece.map_or(String::new(), |piece| format!("{piece}-"));
        if full { format!("{piece}r{row:0of_row$}-c{column:0of_column$}") } else { format!("{piece}{row}-{column}") }
    }
}

/// The panels of the faces of an object from the surface `first` on, if they are those of one net, of nets that join, or of the solid over
/// these: with the indices of their surfaces.
pub(super) fn panels(job: &Job<'_>, item: usize, first: usize, faces: usize) -> Vec<(u32, Panel)> {
    // Both skins of a solid come before its rims.
    let (surfaces, skins) = match job.model.items[item].surfaces() {
        [SurfaceObject::Body(_)] => (job.provenances.skin(item), 2),
        surfaces => (surfaces, 1),
    };
    let [surface] = surfaces else { return Vec::new() };
    let mut panels = Vec::new();
    for (piece, net) in surface.nets().iter().enumerate() {
        let piece = (surface.nets().len() > 1).then_some(piece);
        let digits = net.grid().size().map(|count| count.saturating_sub(1).to_string().len().max(2));
        for ([column, row], _) in net.patches_with_quads() {
            panels.push(Panel { key: (first + panels.len()) as u32, piece, row, column, digits });
        }
    }
    // A net that is cut at singular lines has more faces.
    let count = panels.len();
    if skins == 1 && faces != count || faces < skins * count {
        return Vec::new();
    }
    (0..skins * count).map(|face| ((first + face) as u32, panels[face % count])).collect()
}

/// The index of a panel's surface, its number, and its middle in the picture.
type Placed = (u32, Panel, (f64, f64));

/// A text with the left end of its base line.
struct Label {
    text: String,
    start: (f64, f64),
    size: f64,
    ink: Ink,
}

/// The name of an object, and the middle of what is seen of it.
pub(super) struct ObjectName<'a> {
    pub(super) ink: Ink,
    pub(super) name: &'a str,
    pub(super) place: Option<(f64, f64)>,
}

/// What is written on the drawing.
#[derive(Default)]
pub(super) struct DrawnLabels {
    labels: Vec<Label>,
    taken: Vec<[f64; 4]>,
    /// What is said of them below the legend.
    pub(super) said: Vec<String>,
}

impl DrawnLabels {
    /// Places for the names of objects: at the middle of what is seen of each, not on each other, and inside the room (left, top, right,
    /// bottom).
    pub(super) fn add_names(&mut self, sheet: Sheet, room: [f64; 4], named: &[ObjectName<'_>]) {
        let size = 1.05 * sheet.text_size();
        let mut placed = 0;
        for ObjectName { ink, name, place } in named {
            let Some((x, y)) = *place else { continue };
            let text = lettering::fitted(name, size, 0.4 * sheet.width);
            let wide = lettering::width(&text, size);
            let [left, top, right, bottom] = room;
            let start = |shift: f64| {
                let x = (x - 0.5 * wide).clamp(left, (right - wide).max(left));
                (x, (y + 0.5 * size + shift * 2.2 * size).clamp(top + size, bottom.max(top + size)))
            };
            let free =
                [0.0, -1.0, 1.0, -2.0, 2.0].into_iter().map(start).find(|at| self.is_free(rectangle(*at, wide, size)));
            if let Some(at) = free {
                self.push(Label { text, start: at, size, ink: *ink }, wide);
                placed += 1;
            }
        }
        if placed < named.len() {
            self.said.push(format!("there is room for the names of {placed} of {} objects", named.len()));
        }
    }

    /// Numbers on panels, of which each has the index of its surface and its middle in the picture.
    pub(super) fn add_panels(&mut self, sheet: Sheet, seen: &Seen, panels: &[Placed]) {
        let in_sight: Vec<_> = panels.iter().filter(|(surface, _, at)| seen.at(*at) == *surface).collect();
        if panels.is_empty() {
            return;
        }
        let fit = |full: bool, size: f64| -> Vec<(Label, f64)> {
            let label = |(surface, panel, (x, y)): &&Placed| {
                let text = panel.words(full);
                let wide = lettering::width(&text, size);
                let start = (x - 0.5 * wide, y + 0.5 * size);
                let place = rectangle(start, wide, size);
                let free = seen.shows(*surface, place) && self.is_free(place);
                free.then_some((Label { text, start, size, ink: Ink::TEXT }, wide))
            };
            in_sight.iter().filter_map(label).collect()
        };
        let sizes = SIZES.map(|size| (size * sheet.scale).max(LEAST));
        let mut best: (bool, Vec<(Label, f64)>) = (true, Vec::new());
        for (full, size) in [true, false].into_iter().flat_map(|full| sizes.map(|size| (full, size))) {
            let found = fit(full, size);
            let enough = found.len() as f64 >= MOST * in_sight.len() as f64;
            if found.len() > best.1.len() {
                best = (full, found);
            }
            if enough {
                break;
            }
        }
        let (full, found) = best;
        let form = match (full, panels.iter().any(|(_, panel, _)| panel.piece.is_some())) {
            (true, false) => "r03-c07 is row 3, column 7",
            (false, false) => "3-7 is row 3, column 7",
            (true, true) => "1-r03-c07 is piece 1, row 3, column 7",
            (false, true) => "1-3-7 is piece 1, row 3, column 7",
        };
        let all = panels.iter().map(|(_, panel, _)| panel.key).collect::<HashSet<_>>().len();
        let (count, sight) = (found.len(), in_sight.len());
        self.said.push(match count {
            0 => format!("no panel is numbered: there is no room on any of the {sight} visible panels"),
            _ => format!("{form}; {count} of {all} panels are numbered, {sight} are visible"),
        });
        found.into_iter().for_each(|(label, wide)| self.push(label, wide));
    }

    fn is_free(&self, [left, top, right, bottom]: [f64; 4]) -> bool {
        self.taken.iter().all(|[a, b, c, d]| right <= *a || *c <= left || bottom <= *b || *d <= top)
    }

    fn push(&mut self, label: Label, wide: f64) {
        self.taken.push(rectangle(label.start, wide, label.size));
        self.labels.push(label);
    }

    pub(super) fn draw(&self, canvas: &mut Canvas) {
        for Label { text, start, size, ink } in &self.labels {
            canvas.label(text, *start, *size, *ink);
        }
    }
}

/// The room of a text with some air, by the left end of its base line.
fn rectangle((x, y): (f64, f64), wide: f64, size: f64) -> [f64; 4] {
    [x - AIR * size, y - size - AIR * size, x + wide + AIR * size, y + AIR * size]
}

/// The middle of a panel.
pub(super) fn middle(surface: &Surface<'_>) -> Point3 {
    surface.surface.point(0.5, 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHEET: Sheet = Sheet { width: 800.0, height: 600.0, fixed: false, scale: 1.0 };

    /// A picture of squares of this size, the last column hidden behind a wall.
    fn squares(size: usize) -> (Seen, Vec<Placed>) {
        let mut seen = Seen::new((800, 600));
        let columns = 800 / size;
        for (x, y) in (0..800 * 600).map(|k| (k % 800, k / 800)) {
            let surface = if x / size + 1 < columns { y / size * columns + x / size } else { 100_000 };
            seen.set(x, y, Some(surface));
        }
        let panel = |k: usize| {
            let (column, row) = (k % columns, k / columns);
            let at = [column, row].map(|v| (v as f64 + 0.5) * size as f64);
            (k as u32, Panel { key: k as u32, piece: None, row, column, digits: [2; 2] }, (at[0], at[1]))
        };
        (seen, (0..columns * (600 / size)).map(panel).collect())
    }

    #[test]
    fn numbers_stand_on_their_own_panel_and_do_not_overlap() {
        for (size, form, said) in
            [(200, "r01-c02", "9 of 12 panels"), (40, "1-2", " of 300 panels"), (10, "", "no panel is numbered")]
        {
            let (seen, panels) = squares(size);
            let mut drawn = DrawnLabels::default();
            drawn.add_panels(SHEET, &seen, &panels);
            assert!(drawn.said[0].contains(said), "{}", drawn.said[0]);
            assert!(form.is_empty() || drawn.labels.iter().any(|label| label.text == form));
            for (k, [left, top, right, bottom]) in drawn.taken.iter().enumerate() {
                let cell = |x: f64| (x / size as f64).floor() as i64;
                let inside = |a: f64, b: f64| cell(a) == cell(b);
                assert!(inside(*left, *right) && inside(*top, *bottom), "{}", drawn.labels[k].text);
                for [a, b, c, d] in &drawn.taken[..k] {
                    assert!(right <= a || c <= left || bottom <= b || d <= top);
                }
            }
        }
    }

    #[test]
    fn names_keep_apart_and_inside() {
        let mut drawn = DrawnLabels::default();
        let place = Some((790.0, 300.0));
        let name = |k: usize| ObjectName { ink: Ink::object(k), name: "a long name", place };
        let named: Vec<_> = (0..7).map(name).collect();
        drawn.add_names(SHEET, [20.0, 80.0, 780.0, 500.0], &named);
        // Five places are tried for each.
        assert_eq!((drawn.labels.len(), drawn.said.len()), (5, 1));
        assert!(drawn.taken.iter().all(|[left, _, right, _]| *left > 10.0 && *right < 790.0));
        assert!(drawn.said[0].ends_with("5 of 7 objects"));
    }
}
