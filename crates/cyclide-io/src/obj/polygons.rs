//! Points and polygons of OBJ text.
//!
//! Read are the lines `v` and `f`, with the corners `a`, `a/b`, `a//n` and `a/b/n`, numbers from 1 or from the end
//! (-1 is the last point so far), `#` comments and lines continued by `\`. All other lines are passed over.

use std::ops::Range;

use cyclide::Point3;

use crate::place::{Diagnostic, Source};

/// A polygon: indices of its points, and its place in the text.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Polygon {
    pub(super) corners: Vec<usize>,
    pub(super) span: Range<usize>,
}

/// The points and polygons of a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Polygons {
    pub(super) points: Vec<Point3>,
    /// Places of the points in the text.
    pub(super) spans: Vec<Range<usize>>,
    pub(super) faces: Vec<Polygon>,
}

/// A word and its place.
type Word<'a> = (&'a str, usize);

fn refused(source: Source<'_>, (text, start): Word<'_>, message: impl Into<String>) -> Box<Diagnostic> {
    source.diagnostic(start..start + text.len(), "", message)
}

/// Parses the text.
///
/// # Errors
/// A message with its place: a coordinate or index that is no number, too few of them, an index without a point.
pub(super) fn parse(source: Source<'_>) -> Result<Polygons, Box<Diagnostic>> {
    let mut polygons = Polygons::default();
    // Points may come after the faces that use them.
    let mut words_of_corners = Vec::new();
    for words in statements(source.text) {
        let [keyword, data @ ..] = words.as_slice() else { continue };
        let last = data.last().unwrap_or(keyword);
        let span = keyword.1..last.1 + last.0.len();
        match keyword.0 {
            "v" => {
                let [x, y, z, ..] = data else {
                    return Err(source.diagnostic(span, "", "a point needs three coordinates"));
                };
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
                words_of_corners.push(data.to_vec());
                polygons.faces.push(Polygon { corners, span });
            }
            _ => {}
        }
    }
    let count = polygons.points.len();
    for (face, words) in polygons.faces.iter().zip(&words_of_corners) {
        if let Some(k) = face.corners.iter().position(|corner| *corner >= count) {
            return Err(refused(source, words[k], format!("there is no such point: the file has {count}")));
        }
    }
    Ok(polygons)
}

/// The words of each statement: lines without comments, joined where a line ends in `\`.
fn statements(text: &str) -> Vec<Vec<Word<'_>>> {
    let mut statements = Vec::new();
    let mut words: Vec<Word<'_>> = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let content = line.trim_end_matches(['\n', '\r']);
        let content = &content[..content.find('#').unwrap_or(content.len())];
        let (content, continued) = content.trim_end().strip_suffix('\\').map_or((content, false), |c| (c, true));
        let place = |word: &str| start + (word.as_ptr() as usize - line.as_ptr() as usize);
        words.extend(content.split_whitespace().map(|word| (word, place(word))));
        if !continued {
            statements.push(std::mem::take(&mut words));
        }
        start += line.len();
    }
    statements.push(words);
    statements
}

fn coordinate(source: Source<'_>, word: Word<'_>) -> Result<f64, Box<Diagnostic>> {
    match word.0.parse::<f64>() {
        Ok(x) if x.is_finite() => Ok(x),
        Ok(_) => Err(refused(source, word, format!("`{}` is not a finite number", word.0))),
        Err(_) => Err(refused(source, word, format!("`{}` is not a number", word.0))),
    }
}

/// Index from 0 of a corner's point; those past the points so far are checked when all are known.
fn index(source: Source<'_>, word: Word<'_>, so_far: usize) -> Result<usize, Box<Diagnostic>> {
    let number = word.0.split('/').next().unwrap_or_default();
    let Ok(number) = number.parse::<i64>() else {
        return Err(refused(source, word, format!("`{}` does not start with the number of a point", word.0)));
    };
    let back = usize::try_from(number.unsigned_abs()).unwrap_or(usize::MAX);
    match number {
        1.. => Ok(back - 1),
        0 => Err(refused(source, word, "points are numbered from 1")),
        _ => so_far
            .checked_sub(back)
            .ok_or_else(|| refused(source, word, format!("there is no such point: {so_far} stand before this line"))),
    }
}
