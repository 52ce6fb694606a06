//! Our own MFEM meshes back from the bytes.

use super::topology::Topology;
use super::{ATTRIBUTE, HEAD, KINDS, ORDERS, UNITS};
use crate::check::file_content::FileContent;
use crate::check::labels::{FileLabels, FileName};
use crate::check::read_error::ReadError;
use crate::check::spline_patches::add_patches;
use crate::export::patch_joints::Side;
use crate::export::rational_cells::{MOST_TAG, RationalCell, Tags};
use crate::export::spline_patches::{Knots, SplinePatch};
use cyclide::model::Units;
use std::str::FromStr;

/// What the names are those of.
pub(super) const NAME: &str = "attribute";
/// Largest degree and number of control points along a parameter: far above ours, far below what overflows.
const MOST_DEGREE: usize = 1000;
const MOST_POINTS: usize = 1 << 28;

/// Reads the patches; how they hang together has to be what they say.
pub(super) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let text =
        std::str::from_utf8(bytes).map_err(|e| ReadError::syntax(format!("byte {}", e.valid_up_to()), "not text"))?;
    let mut lines =
        Lines { lines: text.lines().enumerate().collect::<Vec<_>>().into_iter(), comments: Vec::new(), at: 0 };
    if lines.line()? != HEAD {
        return Err(lines.wrong("expected the header of an MFEM NURBS mesh"));
    }
    lines.word("dimension")?;
    let dimension = lines.count()?;
    if !(1..=3).contains(&dimension) {
        return Err(lines.wrong("the dimension is not 1, 2 or 3"));
    }
    let labels = lines.labels()?;
    let elements = lines.elements("elements", dimension)?;
    let boundary = lines.elements("boundary", dimension - 1)?;
    lines.word("edges")?;
    let edges: Vec<[usize; 3]> = lines.rows()?;
    lines.word("vertices")?;
    let vertices = lines.count()?;
    lines.word("patches")?;
    let mut patches = Vec::new();
    for (attribute, _) in &elements {
        let patch = lines.patch(dimension)?;
        if patch.net.tags.object + 1 != *attribute {
            return Err(lines.wrong("the attribute of an element is not the object of its patch"));
        }
        patches.push(patch);
    }
    lines.comments.clear();
    if lines.line().is_ok() {
        return Err(lines.wrong("more patches than elements"));
    }
    let own = Topology::of(&patches);
    let corners = |list: &[(usize, Vec<usize>)]| list.iter().map(|(_, corners)| corners.clone()).collect::<Vec<_>>();
    let attribute = |(side, _): &(Side, Vec<usize>)| 2 * dimension * patches[side.0].net.tags.object + side.1 + 1;
    let same = own.vertices == vertices
        && own.edges == edges
        && own.elements == corners(&elements)
        && own.boundary.iter().map(|(_, corners)| corners.clone()).eq(corners(&boundary))
        && own.boundary.iter().map(attribute).eq(boundary.iter().map(|(attribute, _)| *attribute));
    if !same {
        return Err(ReadError::syntax("elements", "elements, boundary and edges do not match the patches"));
    }
    let mut content = FileContent { labels, ..FileContent::default() };
    add_patches(&mut content, patches)?;
    Ok(content)
}

/// The lines of a file.
struct Lines<'a> {
    lines: std::vec::IntoIter<(usize, &'a str)>,
    /// The comments since they were last asked for.
    comments: Vec<&'a str>,
    at: usize,
}

impl<'a> Lines<'a> {
    fn wrong(&self, detail: &str) -> ReadError {
        ReadError::syntax(format!("line {}", self.at), detail)
    }

    /// The next line that is neither blank nor a comment.
    fn line(&mut self) -> Result<&'a str, ReadError> {
        for (number, line) in self.lines.by_ref() {
            self.at = number + 1;
            match line.trim() {
                "" => {}
                comment if comment.starts_with('#') => self.comments.push(line),
                own => return Ok(own),
            }
        }
        Err(self.wrong("the file ends before its last patch"))
    }

    fn word(&mut self, word: &str) -> Result<(), ReadError> {
        if self.line()? == word { Ok(()) } else { Err(self.wrong(&format!("expected {word}"))) }
    }

    fn count(&mut self) -> Result<usize, ReadError> {
        let line = self.line()?;
        line.parse().map_err(|_| self.wrong("expected a count"))
    }

    fn numbers<T: FromStr>(&mut self) -> Result<Vec<T>, ReadError> {
        let words = self.line()?.split_ascii_whitespace().map(str::parse).collect::<Result<Vec<T>, _>>();
        words.map_err(|_| self.wrong("expected numbers"))
    }

    /// As many rows as a count says.
    fn rows<const N: usize>(&mut self) -> Result<Vec<[usize; N]>, ReadError> {
        let count = self.count()?;
        let mut rows = Vec::new();
        for _ in 0..count {
            rows.push(self.numbers()?.try_into().map_err(|_| self.wrong("unexpected number of values"))?);
        }
        Ok(rows)
    }

    /// Attributes with corners in binary order.
    fn elements(&mut self, word: &str, dimension: usize) -> Result<Vec<(usize, Vec<usize>)>, ReadError> {
        self.word(word)?;
        let count = self.count()?;
        let order = if dimension == 0 { &[0][..] } else { ORDERS[dimension - 1] };
        let mut elements = Vec::new();
        for _ in 0..count {
            let row: Vec<usize> = self.numbers()?;
            match row.as_slice() {
                [attribute, kind, own @ ..] if *kind == KINDS[dimension] && own.len() == order.len() => {
                    let mut corners = vec![0; own.len()];
                    order.iter().zip(own).for_each(|(place, corner)| corners[*place] = *corner);
                    elements.push((*attribute, corners));
                }
                _ => return Err(self.wrong("an unexpected kind of element")),
            }
        }
        Ok(elements)
    }

    /// Unit and names.
    fn labels(&mut self) -> Result<FileLabels, ReadError> {
        let mut labels = FileLabels::default();
        for comment in std::mem::take(&mut self.comments) {
            if let Some(symbol) = comment.strip_prefix(UNITS) {
                labels.unit = Units::from_symbol(symbol).map(Units::in_millimetres);
            } else if let Some((number, name)) = comment.strip_prefix(ATTRIBUTE).and_then(|rest| rest.split_once(':')) {
                if number.parse() != Ok(labels.names.len() + 1) {
                    return Err(self.wrong("attributes are not counted from 1"));
                }
                labels.names.push(FileName::new(NAME, name.strip_prefix(' ').unwrap_or(name), 1));
            }
        }
        Ok(labels)
    }

    fn patch(&mut self, dimension: usize) -> Result<SplinePatch, ReadError> {
        self.word("knotvectors")?;
        let tags = self
            .comments
            .pop()
            .and_then(tags_of)
            .ok_or_else(|| self.wrong("no comment names the object to which the patch belongs"))?;
        self.comments.clear();
        if self.count()? != dimension {
            return Err(self.wrong("unexpected number of knot vectors"));
        }
        let (mut knots, mut degrees) = (Vec::new(), [0; 3]);
        for own in degrees.iter_mut().take(dimension) {
            let row: Vec<f64> = self.numbers()?;
            let whole =
                |v: f64, most: usize| (v >= 1.0 && v <= most as f64 && v.fract().abs() <= 0.0).then_some(v as usize);
            let (degree, count) = match row.as_slice() {
                [degree, count, ..] => (whole(*degree, MOST_DEGREE), whole(*count, MOST_POINTS)),
                _ => (None, None),
            };
            let (Some(degree), Some(count)) = (degree, count) else {
                return Err(self.wrong("degree and count are missing"));
            };
            if row.len() != count + degree + 3 || count <= degree {
                return Err(self.wrong("unexpected number of knots"));
            }
            *own = count - 1;
            knots.push(Knots { degree, knots: row[2..].to_vec() });
        }
        self.word("dimension")?;
        if self.count()? != 3 {
            return Err(self.wrong("control points are not three-dimensional"));
        }
        self.word("controlpoints_cartesian")?;
        let count = degrees.iter().try_fold(1_usize, |product, d| product.checked_mul(d + 1));
        let count = count.filter(|count| *count <= MOST_POINTS).ok_or_else(|| self.wrong("too many control points"))?;
        let mut rows = Vec::new();
        for _ in 0..count {
            let row: Vec<f64> = self.numbers()?;
            match *row.as_slice() {
                [x, y, z, w] if row.iter().all(|v| v.is_finite()) && w > 0.0 => rows.push(([x, y, z], w)),
                _ => return Err(self.wrong("expected three coordinates and a positive weight")),
            }
        }
        let mut net = RationalCell { degrees, nodes: vec![([0.0; 3], 1.0); count], tags };
        for (index, node) in net.first_fastest().zip(rows) {
            let at = net.index(index);
            net.nodes[at] = node;
        }
        Ok(SplinePatch { knots, net })
    }
}

/// What a patch belongs to.
fn tags_of(comment: &str) -> Option<Tags> {
    let mut numbers = comment.strip_prefix("# ")?.split(", ").zip(["object ", "part ", "shell ", "flag "]);
    let mut next =
        || numbers.next().and_then(|(text, word)| text.strip_prefix(word)?.parse().ok()).filter(|tag| *tag <= MOST_TAG);
    Some(Tags { object: next()?, part: next()?, shell: next()?, flag: next()? })
}
