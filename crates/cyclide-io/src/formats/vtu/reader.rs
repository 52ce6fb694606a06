//! Our own VTU back from the bytes.

use super::arrays::{Number, appended as appended_at};
use super::order::{KIND, ORDER, nodes};
use super::quality::{NAMES, Quality};
use super::{KINDS, spline_of};
use crate::check::bodies::FileVolume;
use crate::check::file_content::FileContent;
use crate::check::labels::{FileLabels, FileName};
use crate::check::rational_cells::{add_bodies, add_curves};
use crate::check::read_error::ReadError;
use crate::export::rational_cells::{Degrees, RationalCell, Tags};
use crate::text::xml::attribute;
use cyclide::{
    model::Units,
    rational::{RationalBezier, RationalBezierVolume},
};
use std::collections::HashMap;

/// Names of the arrays.
pub(super) const UNITS: &str = "units";
pub(super) const OBJECTS: &str = "objects";
pub(super) const WEIGHTS: &str = "RationalWeights";
pub(super) const DEGREES: &str = "HigherOrderDegrees";
pub(super) const POINTS: &str = "Points";
pub(super) const CONNECTIVITY: &str = "connectivity";
pub(super) const OFFSETS: &str = "offsets";
pub(super) const TYPES: &str = "types";
/// What stands before the arrays that are appended.
const APPENDED: &str = "<AppendedData encoding=\"base64\">";
pub(super) const OBJECT: &str = "object";
pub(super) const PART: &str = "part";
/// A name with what it is said of a cell.
type Tag = (&'static str, fn(&Tags) -> usize);
/// What is said of each cell.
pub(super) const TAGS: [Tag; 4] =
    [(OBJECT, |tags| tags.object), (PART, |tags| tags.part), ("shell", |tags| tags.shell), ("flag", |tags| tags.flag)];

/// Largest degree: far above ours, far below what overflows.
const MOST_DEGREE: usize = 1000;

/// What the cells of a file say besides their geometry.
pub(super) enum Cells {
    /// The qualities of blocks.
    Bezier(Vec<Quality>),
    Plain(Plain),
}

/// Plain hexahedra.
pub(super) struct Plain {
    /// Their nodes in VTK's order.
    pub(super) connectivity: Vec<usize>,
    pub(super) qualities: Vec<Quality>,
    /// Object and block of each.
    pub(super) tags: Vec<[usize; 2]>,
}

/// Reads curves, patches and volumes, and what their cells say.
pub(super) fn read(bytes: &[u8]) -> Result<(FileContent, Cells), ReadError> {
    let text =
        std::str::from_utf8(bytes).map_err(|e| ReadError::syntax(format!("byte {}", e.valid_up_to()), "not text"))?;
    let expected = |place: &str, attribute: &str| {
        let missing = || ReadError::syntax(place, format!("expected {attribute}"));
        if text.contains(attribute) { Ok(()) } else { Err(missing()) }
    };
    expected("VTKFile", "version=\"2.2\"")?;
    let arrays = arrays(text)?;
    let names = strings(&arrays, OBJECTS)?;
    let unit = match strings(&arrays, UNITS)?.as_slice() {
        [symbol] => Units::from_symbol(symbol)
            .ok_or_else(|| ReadError::unsupported(format!("the unit {symbol}"), UNITS))?
            .in_millimetres(),
        _ => return Err(ReadError::syntax(UNITS, "expected one unit")),
    };
    let labels =
        FileLabels { unit: Some(unit), names: names.into_iter().map(|name| FileName::new(OBJECTS, name, 1)).collect() };
    let kinds = whole(&arrays, TYPES)?;
    if !kinds.is_empty() && kinds.iter().all(|kind| *kind == usize::from(KIND)) {
        return plain(&arrays, labels);
    }
    expected("PointData", "RationalWeights=\"RationalWeights\"")?;
    let cells = cells(&arrays)?;
    let of_blocks = qualities(&arrays, &cells)?;
    let mut content = FileContent { labels, ..FileContent::default() };
    let (mut curves, mut bodies) = (Vec::new(), Vec::new());
    for (number, cell) in cells.into_iter().enumerate() {
        let place = format!("cell {number}");
        if cell.dimension() == 1 {
            let span = RationalBezier::new(cell.rows()).and_then(spline_of);
            curves.push((cell.tags, span.map_err(|source| ReadError::Geometry { place, source })?));
        } else {
            bodies.push((place, cell));
        }
    }
    add_curves(&mut content, curves)?;
    add_bodies(&mut content, bodies)?;
    Ok((content, Cells::Bezier(of_blocks)))
}

/// Reads plain hexahedra, as volumes of degree 1.
fn plain(arrays: &HashMap<&str, Vec<f64>>, labels: FileLabels) -> Result<(FileContent, Cells), ReadError> {
    let connectivity = whole(arrays, CONNECTIVITY)?;
    let (points, ends) = (array(arrays, POINTS)?, whole(arrays, OFFSETS)?);
    let (objects, parts) = (whole(arrays, OBJECT)?, whole(arrays, PART)?);
    let columns = NAMES.into_iter().map(|name| array(arrays, name)).collect::<Result<Vec<_>, _>>();
    let columns = columns.map_err(|_| ReadError::syntax("CellData", "expected the quality of the cells"))?;
    let count = ends.len();
    let mut lengths =
        [objects.len(), parts.len(), connectivity.len() / 8].into_iter().chain(columns.iter().map(|own| own.len()));
    if lengths.any(|own| own != count) || !ends.iter().enumerate().all(|(k, end)| *end == 8 * (k + 1)) {
        return Err(ReadError::syntax(TYPES, "the cell arrays differ in length"));
    }
    let mut content = FileContent { labels, ..FileContent::default() };
    let mut met: Vec<[usize; 2]> = Vec::new();
    let tags: Vec<[usize; 2]> = objects.into_iter().zip(parts).map(|(object, part)| [object, part]).collect();
    for (number, (corners, tag)) in connectivity.chunks_exact(8).zip(&tags).enumerate() {
        let place = || format!("cell {number}");
        let mut rows = vec![[0.0; 4]; 8];
        for (corner, node) in ORDER.into_iter().zip(corners) {
            let own = points
                .get(3 * node..3 * node + 3)
                .ok_or_else(|| ReadError::syntax(place(), "the node does not exist"))?;
            // The first parameter is the fastest of corners, the last of rows.
            rows[(corner & 1) << 2 | (corner & 2) | corner >> 2] = [own[0], own[1], own[2], 1.0];
        }
        let volume = RationalBezierVolume::new([1; 3], rows);
        let volume = volume.map_err(|source| ReadError::Geometry { place: place(), source })?;
        if met.last() != Some(tag) {
            met.push(*tag);
        }
        content.volumes.push(FileVolume { body: met.len() - 1, volume });
    }
    let qualities = (0..count).map(|k| std::array::from_fn(|column| columns[column][k])).collect();
    Ok((content, Cells::Plain(Plain { connectivity, qualities, tags })))
}

/// The qualities of the hexahedra; those of other cells are 0.
fn qualities(arrays: &HashMap<&str, Vec<f64>>, cells: &[RationalCell]) -> Result<Vec<Quality>, ReadError> {
    let blocks = cells.iter().filter(|cell| cell.dimension() == 3).count();
    let mut qualities = vec![Quality::default(); blocks];
    for (k, name) in NAMES.into_iter().enumerate().filter(|_| blocks > 0) {
        let values = array(arrays, name)?;
        if values.len() != cells.len() {
            return Err(ReadError::syntax(name, "expected one value for each cell"));
        }
        let mut own = qualities.iter_mut();
        for (cell, value) in cells.iter().zip(values) {
            match (cell.dimension() == 3).then(|| own.next()).flatten() {
                Some(quality) => quality[k] = *value,
                None if value.abs() <= 0.0 => {}
                None => return Err(ReadError::syntax(name, "a cell that is not a block has a quality")),
            }
        }
    }
    Ok(qualities)
}

/// The arrays of the file by their names.
fn arrays(text: &str) -> Result<HashMap<&str, Vec<f64>>, ReadError> {
    let mut arrays = HashMap::new();
    let (text, appended) = match text.split_once(APPENDED) {
        Some((text, rest)) => (text, rest.trim_start().strip_prefix('_')),
        None => (text, None),
    };
    for (number, part) in text.split("<DataArray ").skip(1).enumerate() {
        let place = || format!("array {number}");
        let wrong = |detail: &str| ReadError::syntax(place(), detail);
        let (head, rest) = part.split_once('>').ok_or_else(|| wrong("its tag is not closed"))?;
        let name = attribute(head, "Name").ok_or_else(|| wrong("it has no name"))?;
        let numbers = match attribute(head, "format") {
            Some("ascii") => {
                let (values, _) = rest.split_once("</DataArray>").ok_or_else(|| wrong("it is not closed"))?;
                let numbers = values.split_ascii_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>();
                numbers.map_err(|_| wrong("a value is not a number"))?
            }
            Some("appended") => {
                let offset = attribute(head, "offset").and_then(|offset| offset.parse::<usize>().ok());
                let kind = attribute(head, "type").and_then(Number::of_word);
                let own = appended.zip(offset).and_then(|(all, offset)| appended_at(all.get(offset..)?));
                let numbers = kind.zip(own).and_then(|(kind, bytes)| kind.values(&bytes));
                numbers.ok_or_else(|| wrong("its appended data are not a list of its numbers"))?
            }
            _ => return Err(ReadError::unsupported("an encoding other than ASCII and appended", place())),
        };
        if numbers.iter().any(|v| !v.is_finite()) || arrays.insert(name, numbers).is_some() {
            return Err(wrong("a value is not finite, or its name occurs twice"));
        }
    }
    Ok(arrays)
}

fn array<'a>(arrays: &'a HashMap<&str, Vec<f64>>, name: &str) -> Result<&'a [f64], ReadError> {
    arrays.get(name).map(Vec::as_slice).ok_or_else(|| ReadError::syntax(name, "the array is missing"))
}

/// Numbers that count something.
fn whole(arrays: &HashMap<&str, Vec<f64>>, name: &str) -> Result<Vec<usize>, ReadError> {
    let count = |v: &f64| (*v >= 0.0 && *v <= 1e15 && v.fract().abs() <= 0.0).then_some(*v as usize);
    let counts = array(arrays, name)?.iter().map(count).collect::<Option<Vec<_>>>();
    counts.ok_or_else(|| ReadError::syntax(name, "a value is not a non-negative integer"))
}

fn strings(arrays: &HashMap<&str, Vec<f64>>, name: &str) -> Result<Vec<String>, ReadError> {
    let bytes = whole(arrays, name)?;
    let bytes = bytes.into_iter().map(u8::try_from).collect::<Result<Vec<u8>, _>>();
    let bytes = bytes.map_err(|_| ReadError::syntax(name, "a value is not a byte"))?;
    let Some((0, bytes)) = bytes.split_last() else {
        return if bytes.is_empty() {
            Ok(Vec::new())
        } else {
            Err(ReadError::syntax(name, "the last one is not terminated"))
        };
    };
    let string = |part: &[u8]| String::from_utf8(part.to_vec()).map_err(|_| ReadError::syntax(name, "not text"));
    bytes.split(|byte| *byte == 0).map(string).collect()
}

fn cells(arrays: &HashMap<&str, Vec<f64>>) -> Result<Vec<RationalCell>, ReadError> {
    let (kinds, ends, degrees) = (whole(arrays, TYPES)?, whole(arrays, OFFSETS)?, whole(arrays, DEGREES)?);
    let (points, weights) = (array(arrays, POINTS)?, array(arrays, WEIGHTS)?);
    let tags = TAGS.map(|(name, _)| whole(arrays, name));
    let [objects, parts, shells, flags] = tags;
    let (objects, parts, shells, flags) = (objects?, parts?, shells?, flags?);
    let counts = [ends.len(), objects.len(), parts.len(), shells.len(), flags.len()];
    if counts.iter().any(|n| *n != kinds.len()) || degrees.len() != 3 * kinds.len() {
        return Err(ReadError::syntax(TYPES, "the cell arrays differ in length"));
    }
    if points.len() != 3 * weights.len() || !whole(arrays, CONNECTIVITY)?.into_iter().eq(0..weights.len()) {
        return Err(ReadError::syntax(CONNECTIVITY, "nodes are not those of the cells, in order"));
    }
    let mut from = 0;
    let mut cells = Vec::with_capacity(kinds.len());
    for (number, kind) in kinds.into_iter().enumerate() {
        let wrong = |detail: &str| ReadError::syntax(format!("cell {number}"), detail);
        let degrees: Degrees = [degrees[3 * number], degrees[3 * number + 1], degrees[3 * number + 2]];
        let dimension = KINDS.iter().position(|own| usize::from(*own) == kind).map(|k| k + 1);
        let fits = dimension.is_some_and(|d| (0..3).all(|axis| (degrees[axis] > 0) == (axis < d)));
        if !fits || degrees.iter().any(|d| *d > MOST_DEGREE) {
            return Err(wrong("its degrees do not match its type"));
        }
        let to = ends[number];
        let own = weights.get(from..to).ok_or_else(|| wrong("its nodes are missing"))?;
        if own.len() != degrees.iter().map(|d| d + 1).product::<usize>() || own.iter().any(|w| !(*w > 0.0)) {
            return Err(wrong("expected as many nodes as its degrees require, with positive weights"));
        }
        let tags = Tags { object: objects[number], part: parts[number], shell: shells[number], flag: flags[number] };
        let mut cell = RationalCell { degrees, nodes: vec![([0.0; 3], 1.0); to - from], tags };
        for (k, at) in (from..to).zip(nodes(degrees)) {
            let index = cell.index(at);
            cell.nodes[index] = ([points[3 * k], points[3 * k + 1], points[3 * k + 2]], weights[k]);
        }
        cells.push(cell);
        from = to;
    }
    if from == weights.len() { Ok(cells) } else { Err(ReadError::syntax(OFFSETS, "there are unused nodes")) }
}
