//! The legend of a picture: what its colors, numbers and signs stand for.
//!
//! A few objects are named in a row with their colors. More are numbered: each has its number in the drawing, and the
//! names stand in columns below, as many as a third of the picture holds; the last entry says how many are left out.

use super::canvas::{Canvas, Ink};
use super::colour_bar::{self, ColourBar};
use super::lettering;
use super::marks::{Mark, family};
use super::scene::quantity::{self, Coloured};
use super::sheet::{BAR_ROOM, MOST_ENTRIES, ROW, Sheet, TEXT};
use crate::drawing::Combs;
use crate::export::job::Job;
use cyclide::ShortNumber;

/// Width of a mark with the space behind it, and the space between two entries.
const MARK: f64 = 58.0;
const BETWEEN: f64 = 44.0;
/// Part of the tallest picture that the numbered names may take, and the distance of their rows.
const NUMBERED_PART: f64 = 0.34;
const NUMBERED_ROW: f64 = 0.8;
/// Names of grey surfaces in the legend.
const GREY_NAMES: usize = 4;
/// Width of the number before a mark.
const NUMBER: f64 = 40.0;

/// An entry of the legend.
pub(super) struct Entry {
    mark: Mark,
    text: String,
}

/// A legend with the places of its entries.
#[derive(Default)]
pub(super) struct Legend {
    /// The scale of the colors.
    bar: Option<ColourBar>,
    row: Vec<Entry>,
    numbered: Vec<Entry>,
    /// A line below all.
    remark: Option<String>,
}

/// An entry with its place: the text as far as there is room, pixels from the left, the row, and the number.
struct Placed<'a> {
    entry: &'a Entry,
    text: String,
    x: f64,
    row: f64,
    number: Option<usize>,
}

/// How the objects of a picture are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Naming {
    /// By the colors of the legend.
    Colours,
    /// By names beside them.
    Names,
    /// By numbers, with the names in the legend.
    Numbers,
}

impl Legend {
    pub(super) fn new(job: &Job<'_>, combs: &Combs, names: &[String], naming: Naming) -> Self {
        let mut row = match naming {
            Naming::Colours => coloured(job, combs, names),
            Naming::Names | Naming::Numbers => crowd(combs),
        };
        if job.model.items.iter().any(|item| !item.volumes().is_empty()) {
            row.extend(["s", "t", "u"].into_iter().enumerate().map(|(axis, name)| {
                let [field, line] = family(axis);
                Entry { mark: Mark::Field(field, line), text: format!("{name} constant") }
            }));
        }
        if job.provenances.data().next().is_some() {
            row.push(Entry { mark: Mark::Data, text: "data points of a fit; its nodes as rings".to_owned() });
        }
        let numbered = match naming {
            Naming::Numbers => {
                let named = names.iter().enumerate();
                named.map(|(index, name)| Entry { mark: mark(job, index), text: name.clone() }).collect()
            }
            Naming::Colours | Naming::Names => Vec::new(),
        };
        Self { row, numbered, ..Self::default() }
    }

    /// Of surfaces that are colored by a quantity: its scale in place of their colors, and those in grey, which do not have it.
    pub(super) fn with_scale(
        mut self,
        job: &Job<'_>,
        bar: ColourBar,
        names: &[String],
        coloured: &Coloured<'_>,
    ) -> Self {
        let is_surface = |item: usize| !job.model.items[item].surfaces().is_empty();
        let is_drawn = |item: usize| is_surface(item) || !job.model.items[item].volumes().is_empty();
        // A surface has no color of its own any more.
        self.row.retain(|entry| !matches!(entry.mark, Mark::Field(..)));
        let grey: Vec<&str> = names
            .iter()
            .enumerate()
            .filter(|(k, _)| is_drawn(*k) && !coloured.is_shown(*k))
            .map(|(_, name)| name.as_str())
            .collect();
        if !grey.is_empty() {
            let mark = Mark::Field(Ink::of_screen(quantity::WITHOUT), Ink::SOFT);
            let more = grey.len().saturating_sub(GREY_NAMES);
            let mut text =
                format!("{}: {}", quantity::without(job.options.png_colour), grey[..grey.len() - more].join(", "));
            if more > 0 {
                text += &format!(", +{more} more");
            }
            self.row.push(Entry { mark, text });
        }
        if coloured.has_gaps() {
            let mark = Mark::Field(Ink::of_screen(quantity::WITHOUT), Ink::SOFT);
            self.row.push(Entry { mark, text: quantity::gap(job.options.png_colour).to_owned() });
        }
        for entry in &mut self.numbered {
            if let Mark::Field(field, line) = &mut entry.mark {
                (*field, *line) = (Ink::of_screen(quantity::WITHOUT), Ink::TEXT);
            }
        }
        self.bar = Some(bar);
        self
    }

    /// Of the lines of curvature of a surface.
    pub(super) fn of_field(lines: [Ink; 2], has_umbilics: bool) -> Self {
        let [along, across] = lines;
        let mut row = vec![
            Entry { mark: Mark::Cross(along, across), text: "directions of curvature".to_owned() },
            Entry { mark: Mark::Line(along, false), text: "grid along s".to_owned() },
            Entry { mark: Mark::Line(across, false), text: "along t".to_owned() },
        ];
        if has_umbilics {
            row.push(Entry { mark: Mark::Umbilic, text: "umbilic".to_owned() });
        }
        Self { row, ..Self::default() }
    }

    /// Keeps a line below the others free, or fills it.
    pub(super) fn remark(&mut self, text: String) {
        self.remark = Some(text);
    }

    /// Draws a curve's mark in dashes, as the curve itself is where it covers another.
    pub(super) fn dash(&mut self, name: &str) {
        for entry in self.row.iter_mut().chain(&mut self.numbered) {
            if let Mark::Line(_, dashed) = &mut entry.mark
                && (entry.text == name || entry.text.strip_prefix(name).is_some_and(|rest| rest.starts_with(": ")))
            {
                *dashed = true;
            }
        }
    }

    /// Rows of the legend, from the scale bar's.
    pub(super) fn rows(&self, sheet: Sheet) -> f64 {
        // On a narrow picture the bar stands below that of the scale.
        let bar = if self.bar.is_some() { self.bar_row(sheet) + colour_bar::ROWS - 1.0 } else { 0.0 };
        let remark = if self.remark.is_some() { 1.0 } else { 0.0 };
        self.places(sheet).iter().map(|placed| placed.row).fold(bar, f64::max) + 1.0 + remark
    }

    /// How many objects are numbered; the others have no room in the legend.
    pub(super) fn numbers(&self, sheet: Sheet) -> usize {
        self.places(sheet).iter().filter(|placed| placed.number.is_some()).count()
    }

    /// True if there is room beside the scale bar. On a narrow picture the legend starts below it.
    fn is_beside(sheet: Sheet) -> bool {
        sheet.width - 2.0 * sheet.margin() > 2.2 * BAR_ROOM * sheet.scale
    }

    /// The row in which the scale of colors begins.
    fn bar_row(&self, sheet: Sheet) -> f64 {
        if Self::is_beside(sheet) { 0.0 } else { 1.0 }
    }

    fn places(&self, sheet: Sheet) -> Vec<Placed<'_>> {
        let s = sheet.scale;
        let beside = Self::is_beside(sheet);
        let (left, first) = if beside { (sheet.margin() + BAR_ROOM * s, 0.0) } else { (sheet.margin(), 1.0) };
        let first = if self.bar.is_some() { first + colour_bar::ROWS } else { first };
        let right = sheet.width - sheet.margin();
        let mut at = (left, first);
        let mut places = Vec::new();
        for entry in &self.row {
            let text = lettering::fitted(&entry.text, sheet.text_size(), right - left - MARK * s);
            let width = MARK * s + lettering::width(&text, sheet.text_size());
            if at.0 > left && at.0 + width > right {
                at = (left, at.1 + 1.0);
            }
            places.push(Placed { entry, text, x: at.0, row: at.1, number: None });
            at.0 += width + BETWEEN * s;
        }
        let used = match (&self.bar, self.row.is_empty()) {
            (Some(_), true) => at.1 - 1.0,
            (None, true) if !beside => 0.0,
            _ => at.1,
        };
        self.columns(sheet, used + 1.0, &mut places);
        places
    }

    /// The numbered names in columns of equal width, read downwards.
    fn columns<'a>(&'a self, sheet: Sheet, first: f64, places: &mut Vec<Placed<'a>>) {
        let (s, size, left) = (sheet.scale, sheet.text_size(), sheet.margin());
        let room = sheet.width - 2.0 * left;
        let before = (NUMBER + MARK) * s;
        let widest = self.numbered.iter().map(|entry| lettering::width(&entry.text, size)).fold(0.0, f64::max);
        let column = (before + widest + BETWEEN * s).min(room + BETWEEN * s);
        let columns = ((room + BETWEEN * s) / column).floor().max(1.0) as usize;
        let most = NUMBERED_PART * sheet.tallest() / (NUMBERED_ROW * ROW * s) - first;
        let rows = self.numbered.len().div_ceil(columns).min(most.max(2.0) as usize).max(1);
        let all = self.numbered.len() <= rows * columns;
        let shown = if all { self.numbered.len() } else { rows * columns - 1 };
        for (index, entry) in self.numbered.iter().take(shown).enumerate() {
            let x = left + (index / rows) as f64 * column;
            // A pixel for the rounding of sums.
            let text = lettering::fitted(&entry.text, size, column - before - BETWEEN * s + 1.0);
            let row = first + NUMBERED_ROW * (index % rows) as f64;
            places.push(Placed { entry, text, x, row, number: Some(index + 1) });
        }
        if !all {
            let x = left + (shown / rows) as f64 * column;
            let text = format!("+{} more", self.numbered.len() - shown);
            let row = first + NUMBERED_ROW * (shown % rows) as f64;
            places.push(Placed { entry: &MORE, text, x, row, number: None });
        }
    }

    /// Draws the legend below the pixel `top`.
    pub(super) fn draw(&self, canvas: &mut Canvas, sheet: Sheet, top: f64) {
        let s = sheet.scale;
        if let Some(bar) = &self.bar {
            let left = sheet.margin() + if Self::is_beside(sheet) { BAR_ROOM * s } else { 0.0 };
            bar.draw(canvas, sheet, (left, sheet.width - sheet.margin()), top + self.bar_row(sheet) * ROW * s);
        }
        if let Some(remark) = &self.remark {
            let base = top + (self.rows(sheet) - 0.5) * ROW * s + 0.5 * TEXT * s;
            let text = lettering::fitted(remark, sheet.text_size(), sheet.width - 2.0 * sheet.margin());
            canvas.text(&text, (sheet.margin(), base), sheet.text_size(), Ink::SOFT);
        }
        for Placed { entry, text, x, row, number } in self.places(sheet) {
            let middle = top + (row + 0.5) * ROW * s;
            let mut x = x;
            if let Some(number) = number {
                balloon(canvas, (x + 0.4 * NUMBER * s, middle), number, sheet, entry.mark.ink());
                x += NUMBER * s;
            }
            entry.mark.draw(canvas, (x, middle), s);
            let start = if matches!(entry.mark, Mark::More) { x } else { x + MARK * s };
            canvas.text(&text, (start, middle + 0.5 * TEXT * s), TEXT * s, Ink::TEXT);
        }
    }
}

static MORE: Entry = Entry { mark: Mark::More, text: String::new() };

/// A number in a circle: the key of an object.
pub(super) fn balloon(canvas: &mut Canvas, (x, y): (f64, f64), number: usize, sheet: Sheet, ink: Ink) {
    let (text, size) = (number.to_string(), BALLOON_TEXT * sheet.text_size());
    let radius = balloon_radius(number, sheet);
    canvas.disc((x as f32, y as f32), radius, 1.5 * sheet.scale, ink);
    canvas.text(&text, (x - 0.5 * lettering::width(&text, size), y + 0.5 * size), size, ink);
}

const BALLOON_TEXT: f64 = 0.72;

pub(super) fn balloon_radius(number: usize, sheet: Sheet) -> f64 {
    let size = BALLOON_TEXT * sheet.text_size();
    (0.5 * lettering::width(&number.to_string(), size) + 0.45 * size).max(size)
}

/// True if there are more objects than a legend of colors can tell apart: all blocks have the same ones.
pub(super) fn is_crowded(job: &Job<'_>) -> bool {
    let of_blocks = job.model.items.iter().filter(|item| !item.volumes().is_empty()).count();
    job.model.items.len() > MOST_ENTRIES || of_blocks > 1
}

fn mark(job: &Job<'_>, index: usize) -> Mark {
    if !job.model.items[index].volumes().is_empty() {
        Mark::Families
    } else if job.model.items[index].curves().is_empty() {
        Mark::Field(Ink::surface(index), Ink::object(index))
    } else {
        Mark::Line(Ink::object(index), false)
    }
}

/// One entry for all the combs of many objects.
fn crowd(combs: &Combs) -> Vec<Entry> {
    let mut text = scale_words(combs).to_owned();
    if !combs.left_out.is_empty() {
        text += &format!("; {} omitted because they would overlap others", combs.left_out.len());
    }
    if combs.drawn.is_empty() { Vec::new() } else { vec![Entry { mark: Mark::Comb, text }] }
}

fn scale_words(combs: &Combs) -> &'static str {
    match combs.drawn.len() {
        1 => "curvature comb",
        _ if combs.have_one_scale() => "curvature combs, at one scale",
        _ => "curvature combs, at different scales",
    }
}

fn coloured(job: &Job<'_>, combs: &Combs, names: &[String]) -> Vec<Entry> {
    let symbol = job.units().symbol();
    let mut entries = Vec::new();
    // The title is name enough for one.
    let named = names.len() > 1;
    for (index, name) in names.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
        let comb = combs.drawn.iter().find(|comb| comb.item == index);
        let said = comb.map(|comb| {
            let [k, radius] = [comb.largest, 1.0 / comb.largest].map(|v| ShortNumber(three_digits(v)));
            let cut = if comb.is_cut { ", longest teeth cut" } else { "" };
            match comb.largest.is_finite() {
                true => format!("curvature up to {k} 1/{symbol}, radius {radius} {symbol}{cut}"),
                false => "curvature without bound, longest teeth cut".to_owned(),
            }
        });
        let left_out = combs.left_out.contains(&index).then(|| "comb omitted: it would overlap another".to_owned());
        let mark = mark(job, index);
        match (named, said.or(left_out)) {
            (true, Some(said)) => entries.push(Entry { mark, text: format!("{name}: {said}") }),
            (true, None) => entries.push(Entry { mark, text: name.clone() }),
            (false, Some(said)) => entries.push(Entry { mark: Mark::Comb, text: said }),
            (false, None) => {}
        }
    }
    if named && !combs.drawn.is_empty() {
        entries.push(Entry { mark: Mark::Comb, text: scale_words(combs).to_owned() });
    }
    entries
}

fn three_digits(v: f64) -> f64 {
    format!("{v:.2e}").parse().unwrap_or(v)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn legend(count: usize) -> Legend {
        let entry =
            |i: usize| Entry { mark: Mark::Line(Ink::object(i), false), text: format!("a rail with number {i}") };
        Legend { numbered: (0..count).map(entry).collect(), ..Legend::default() }
    }

    #[test]
    fn numbered_names_take_a_third_of_the_picture_at_most() {
        for (width, scale) in [(1600.0, 1.0), (500.0, (500.0_f64 / 1600.0).sqrt())] {
            let sheet = Sheet { width, height: 0.75 * width, fixed: false, scale };
            for count in [7, 20, 61, 400] {
                let legend = legend(count);
                let shown = legend.numbers(sheet);
                let places = legend.places(sheet);
                let last = places.last().map_or("", |placed| &placed.text);
                match count - shown {
                    0 => assert_eq!(last, format!("a rail with number {}", count - 1)),
                    left => assert_eq!(last, format!("+{left} more")),
                }
                assert!(legend.rows(sheet) * ROW * scale < 0.4 * sheet.tallest(), "{count}");
                let wide = |placed: &Placed<'_>| {
                    placed.x + (NUMBER + MARK) * scale + lettering::width(&placed.text, sheet.text_size())
                };
                assert!(places.iter().all(|placed| wide(placed) < width), "{count} at {width}");
                assert!(count > 20 || width < 1600.0 || shown == count, "{shown} of {count}");
            }
        }
    }
}
