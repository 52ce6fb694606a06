//! Points and polygons of OBJ text.
//!
//! Read are the lines `v` and `f`, with the corners `a`, `a/b`, `a//n` and `a/b/n`, numbers from 1 or from the end
//! (-1 is the last point so far), `#` comments and lines continued by `\`. All other lines are passed over.

use std::ops::Range;

use cyclide::{Point3, Vec3};

use crate::input::points::MOST_POINTS;
use crate::text::lines::lines;
use crate::text::number::{NEARER_TO_ZERO, vanishes};
use crate::text::place::{Diagnostic, Source, quoted};

/// A polygon: indices of its points, and its place in the text.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Polygon {
    pub(super) corners: Vec<usize>,
    /// Indices of the normals of its corners, where these are read and all of them have one.
    pub(super) normals: Option<Vec<usize>>,
    pub(super) span: Range<usize>,
}

/// The points and polygons of a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Polygons {
    pub(super) points: Vec<Point3>,
    /// Places of the points in the text.
    pub(super) spans: Vec<Range<usize>>,
    pub(super) faces: Vec<Polygon>,
    /// Normals, where they are read.
    pub(super) normals: Vec<Vec3>,
}

/// Whether the normals of a file are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Normals {
    Read,
    PassOver,
}

/// A word and its place.
type Word<'a> = (&'a str, usize);

fn refused(source: Source<'_>, (text, start): Word<'_>, message: impl Into<String>) -> Box<Diagnostic> {
    source.diagnostic(start..start + text.len(), "", message)
}

/// Longest statement that is read, in bytes; a quad has some forty.
const LONGEST_STATEMENT: usize = 65_536;

/// Parses the text.
///
/// # Errors
/// A message with its place: a coordinate or index that is no number, too few of them, an index without a point, a
/// statement that is too long.
pub(super) fn parse(source: Source<'_>, normals: Normals) -> Result<Polygons, Box<Diagnostic>> {
    let mut polygons = Polygons::default();
    for_each_statement(source, |words| {
        let [keyword, data @ ..] = words else { return Ok(()) };
        let last = data.last().unwrap_or(keyword);
        let span = keyword.1..last.1 + last.0.len();
        match keyword.0 {
            "v" => {
                let [x, y, z, ..] = data else {
                    return Err(source.diagnostic(span, "", "a point needs three coordinates"));
                };
                if polygons.points.len() == MOST_POINTS {
                    return Err(source.diagnostic(span, "", format!("the file has more than {MOST_POINTS} points")));
                }
                let [x, y, z] = [coordinate(source, *x)?, coordinate(source, *y)?, coordinate(source, *z)?];
                polygons.points.push(Point3::new(x, y, z));
                polygons.spans.push(span);
            }
            "f" => {
                if data.len() < 3 {
                    return Err(source.diagnostic(span, "", "a face needs at least three corners"));
                }
                let so_far = polygons.points.len();
                let corners = data.iter().map(|word| index(source, *word, so_far)).collect::<Result<_, _>>()?;
                let normals = match normals {
                    Normals::Read => normals_of(source, data, polygons.normals.len())?,
                    Normals::PassOver => None,
                };
                polygons.faces.push(Polygon { corners, normals, span });
            }
            "vn" if normals == Normals::Read => {
                let [x, y, z, ..] = data else {
                    return Err(source.diagnostic(span, "", "a normal needs three coordinates"));
                };
                let [x, y, z] = [coordinate(source, *x)?, coordinate(source, *y)?, coordinate(source, *z)?];
                polygons.normals.push(Vec3::new(x, y, z));
            }
            _ => {}
        }
        Ok(())
    })?;
    // Points may come after the faces that use them.
    let count = polygons.points.len();
    for face in &polygons.faces {
        if let Some(k) = face.corners.iter().position(|corner| *corner >= count) {
            return Err(no_such_point(source, face, k, count));
        }
        let normals = polygons.normals.len();
        if let Some(wrong) = face.normals.iter().flatten().find(|normal| **normal >= normals) {
            let message = format!("there is no normal {}: the file has only {normals}", wrong + 1);
            return Err(source.diagnostic(face.span.clone(), "", message));
        }
    }
    Ok(polygons)
}

/// The message about a corner of a face: its words are found again.
fn no_such_point(source: Source<'_>, face: &Polygon, corner: usize, count: usize) -> Box<Diagnostic> {
    let text = &source.text[face.span.clone()];
    let mut words = text.split_whitespace().filter(|word| *word != "\\");
    let place = |word: &str| face.span.start + (word.as_ptr() as usize - text.as_ptr() as usize);
    let span = words.nth(corner + 1).map_or(face.span.clone(), |word| place(word)..place(word) + word.len());
    source.diagnostic(span, "", format!("there is no such point: the file has only {count}"))
}

/// Visits the words of each statement: lines without comments, joined where a line ends in `\`.
fn for_each_statement<'a>(
    source: Source<'a>,
    mut visit: impl FnMut(&[Word<'a>]) -> Result<(), Box<Diagnostic>>,
) -> Result<(), Box<Diagnostic>> {
    let mut words: Vec<Word<'a>> = Vec::new();
    let mut begin = None;
    for (start, line) in lines(source.text) {
        let begun = *begin.get_or_insert(start);
        if start + line.len() - begun > LONGEST_STATEMENT {
            let message = format!("the line has more than {LONGEST_STATEMENT} bytes");
            return Err(source.diagnostic(begun..begun + 1, "", message));
        }
        let content = &line[..line.find('#').unwrap_or(line.len())];
        let (content, continued) = content.trim_end().strip_suffix('\\').map_or((content, false), |c| (c, true));
        let place = |word: &str| start + (word.as_ptr() as usize - line.as_ptr() as usize);
        words.extend(content.split_whitespace().map(|word| (word, place(word))));
        if !continued {
            visit(&words)?;
            words.clear();
            begin = None;
        }
    }
    visit(&words)
}

fn coordinate(source: Source<'_>, word: Word<'_>) -> Result<f64, Box<Diagnostic>> {
    match word.0.parse::<f64>() {
        Ok(x) if vanishes(word.0, x) => Err(refused(source, word, format!("`{}` {NEARER_TO_ZERO}", quoted(word.0)))),
        Ok(x) if x.is_finite() => Ok(x),
        Ok(_) => Err(refused(source, word, format!("`{}` is not a finite number", quoted(word.0)))),
        Err(_) => Err(refused(source, word, format!("`{}` is not a number", quoted(word.0)))),
    }
}

/// The normals of the corners of a face, the third number of each; `None` if a corner has none.
fn normals_of(source: Source<'_>, data: &[Word<'_>], so_far: usize) -> Result<Option<Vec<usize>>, Box<Diagnostic>> {
    let third = |word: &Word<'_>| word.0.splitn(3, '/').nth(2).is_some_and(|number| !number.is_empty());
    if !data.iter().all(third) {
        return Ok(None);
    }
    data.iter().map(|word| numbered(source, *word, 2, "normal", so_far)).collect::<Result<_, _>>().map(Some)
}

/// Index from 0 of a corner's point; those past the points so far are checked when all are known.
fn index(source: Source<'_>, word: Word<'_>, so_far: usize) -> Result<usize, Box<Diagnostic>> {
    numbered(source, word, 0, "point", so_far)
}

/// Index from 0 that one of the numbers of a corner stands for.
fn numbered(
    source: Source<'_>,
    word: Word<'_>,
    place: usize,
    what: &str,
    so_far: usize,
) -> Result<usize, Box<Diagnostic>> {
    let number = word.0.split('/').nth(place).unwrap_or_default();
    let Ok(number) = number.parse::<i64>() else {
        let text = quoted(word.0);
        let message = match place {
            0 => format!("`{text}` does not start with a {what} number"),
            _ => format!("`{text}` does not end with a {what} number"),
        };
        return Err(refused(source, word, message));
    };
    let back = usize::try_from(number.unsigned_abs()).unwrap_or(usize::MAX);
    match number {
        1.. => Ok(back - 1),
        0 => Err(refused(source, word, format!("{what}s are numbered from 1"))),
        _ => so_far
            .checked_sub(back)
            .ok_or_else(|| refused(source, word, format!("there is no such {what}: only {so_far} precede this line"))),
    }
}
