//! Text in pictures, drawn as strokes: the same pixels on every machine, no font file.

mod glyphs;
mod latin;

use glyphs::{GLYPHS, Glyph, MARKED, MARKS, MISSING};
pub(super) use latin::{Drawable, drawable};
use tiny_skia::{Path, PathBuilder};

/// Height of a capital in the units of the drawings.
const CAPITAL: f64 = 14.0;
const SMALL: f64 = 10.0;
/// Space between two letters, and width of a stroke, in the same units.
const SPACE: f64 = 3.0;
const STROKE: f64 = 1.55;
/// Control points of a quarter of an ellipse, relative to its axes.
const QUARTER: f64 = 0.552_284_749_830_793_4;

/// Width of the strokes of letters with capitals of this height.
pub(super) fn stroke_width(size: f64) -> f64 {
    size * STROKE / CAPITAL
}

/// Width of a line of text whose capitals are `size` high.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let letters: Vec<f64> = text.chars().map(|c| Letter::of(c).glyph.1).collect();
    let spaces = SPACE * letters.len().saturating_sub(1) as f64;
    (letters.iter().sum::<f64>() + spaces) * size / CAPITAL
}

/// The text, cut and ended with three dots where it is wider than the room for it.
pub(super) fn fitted(text: &str, size: f64, room: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let mut kept: Vec<char> = text.chars().collect();
    while kept.pop().is_some() {
        let shorter: String = kept.iter().collect::<String>().trim_end().to_owned() + "…";
        if width(&shorter, size) <= room {
            return shorter;
        }
    }
    String::new()
}

/// The strokes of a line of text from the left end of its base line; `None` if there is nothing to draw.
pub(super) fn path(text: &str, (x, y): (f64, f64), size: f64) -> Option<Path> {
    let unit = size / CAPITAL;
    let mut pen = Pen { builder: PathBuilder::new(), x, y, unit, at: (0.0, 0.0) };
    for c in text.chars() {
        let letter = Letter::of(c);
        pen.draw(letter.glyph.2);
        if let Some(mark) = letter.mark {
            let (before, height) = ((pen.x, pen.y), if letter.tall { CAPITAL } else { SMALL });
            pen.x += 0.5 * letter.glyph.1 * unit;
            pen.y -= if matches!(mark.0, '¸' | '˛') { 0.0 } else { height * unit };
            pen.draw(mark.1);
            (pen.x, pen.y) = before;
        }
        pen.x += (letter.glyph.1 + SPACE) * unit;
    }
    pen.builder.finish()
}

/// How a character is drawn.
struct Letter {
    glyph: &'static Glyph,
    mark: Option<&'static (char, &'static str)>,
    tall: bool,
}

impl Letter {
    /// True if there is a drawing of the character.
    fn can_draw(c: char) -> bool {
        Self::of(c).glyph.0 != MISSING.0
    }

    fn of(c: char) -> Self {
        let found = |c: char| GLYPHS.binary_search_by_key(&c, |glyph| glyph.0).ok().map(|i| &GLYPHS[i]);
        if let Some(glyph) = found(c) {
            return Self { glyph, mark: None, tall: false };
        }
        let marked = MARKED.split_whitespace().find_map(|entry| {
            let mut chars = entry.chars();
            let (own, base, mark) = (chars.next()?, chars.next()?, chars.next()?);
            (own == c).then_some((base, mark))
        });
        let drawn = marked.and_then(|(base, mark)| Some((found(base)?, MARKS.iter().find(|m| m.0 == mark)?)));
        match drawn {
            Some((glyph, mark)) => Self { glyph, mark: Some(mark), tall: glyph.0.is_uppercase() },
            None => Self { glyph: &MISSING, mark: None, tall: false },
        }
    }
}

/// Draws the paths of letters.
struct Pen {
    builder: PathBuilder,
    /// Where the letter's base line starts, pixels.
    x: f64,
    y: f64,
    unit: f64,
    at: (f64, f64),
}

impl Pen {
    fn draw(&mut self, path: &str) {
        let mut numbers: Vec<f64> = Vec::new();
        let mut command = ' ';
        for token in path.split(' ').filter(|t| !t.is_empty()) {
            let (first, rest) = token.split_at(usize::from(token.starts_with(char::is_alphabetic)));
            if let Some(c) = first.chars().next() {
                command = c;
            }
            numbers.extend(rest.parse::<f64>().ok());
            self.step(command, &mut numbers);
        }
    }

    /// Draws a command as soon as it has its numbers.
    fn step(&mut self, command: char, numbers: &mut Vec<f64>) {
        let &[.., x, y] = numbers.as_slice() else {
            return;
        };
        let (a, b) = (self.at, (x, y));
        match (command, numbers.len()) {
            ('M', 2) => {
                let (x, y) = self.place(b);
                self.builder.move_to(x, y);
            }
            ('L', 2) => {
                let (x, y) = self.place(b);
                self.builder.line_to(x, y);
            }
            ('Q', 4) => {
                let ((cx, cy), (x, y)) = (self.place((numbers[0], numbers[1])), self.place(b));
                self.builder.quad_to(cx, cy, x, y);
            }
            ('H', 2) => self.quarter((a.0 + QUARTER * (b.0 - a.0), a.1), (b.0, b.1 + QUARTER * (a.1 - b.1)), b),
            ('V', 2) => self.quarter((a.0, a.1 + QUARTER * (b.1 - a.1)), (b.0 + QUARTER * (a.0 - b.0), b.1), b),
            _ => return,
        }
        self.at = b;
        numbers.clear();
    }

    fn quarter(&mut self, c: (f64, f64), d: (f64, f64), end: (f64, f64)) {
        let ((cx, cy), (dx, dy), (x, y)) = (self.place(c), self.place(d), self.place(end));
        self.builder.cubic_to(cx, cy, dx, dy, x, y);
    }

    fn place(&self, (x, y): (f64, f64)) -> (f32, f32) {
        ((self.x + x * self.unit) as f32, (self.y - y * self.unit) as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_has_a_path_within_its_box() {
        assert!(GLYPHS.windows(2).all(|w| w[0].0 < w[1].0), "sorted, each once");
        for glyph in GLYPHS.iter().filter(|g| g.0 != ' ') {
            // All commands are complete: as many numbers as they take.
            let mut pen = Pen { builder: PathBuilder::new(), x: 0.0, y: 0.0, unit: 1.0, at: (0.0, 0.0) };
            pen.draw(glyph.2);
            let bounds = pen.builder.finish().unwrap().bounds();
            let (left, right) = (f64::from(bounds.left()), f64::from(bounds.right()));
            assert!(left >= -0.6 && right <= glyph.1 + 0.7, "{:?}: {left} to {right}", glyph.0);
            assert!(bounds.top() >= -16.3 && bounds.bottom() <= 4.3, "{:?}", glyph.0);
        }
        let marked = MARKED.split_whitespace().filter_map(|entry| entry.chars().next());
        for c in (' '..='~').chain("éÄöñçšß²³°×·…ŁłØ".chars()).chain(marked) {
            assert!(Letter::can_draw(c), "{c}");
        }
        assert!(!Letter::can_draw('円'));
    }

    #[test]
    fn texts_are_cut_to_the_room_they_have() {
        let room = width("centre line", 14.0);
        assert_eq!(fitted("centre line", 14.0, room), "centre line");
        let cut = fitted("centre line of the track", 14.0, room);
        assert!(cut.ends_with('…') && width(&cut, 14.0) <= room && cut.len() > 6, "{cut}");
        assert_eq!(fitted("abc", 14.0, 1.0), "");
        assert!((width("HH", 28.0) - 2.0 * (9.0 + 3.0 + 9.0)).abs() < 1e-12);
    }
}
