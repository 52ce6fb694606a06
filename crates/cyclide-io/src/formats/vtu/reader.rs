//! Our own VTU back from the bytes.

use super::cells::{CURVE, Cell, HEXAHEDRON, QUADRILATERAL, Tags};
use super::order::Degrees;
use super::spline_of;
use crate::check::bodies::{FilePatch, FileVolume};
use crate::check::file_content::{FileContent, ReadError};
use crate::check::labels::{FileLabels, FileName};
use cyclide::{ChainPiece, CurveChain, RationalBezier, RationalBezierSurface, RationalBezierVolume, Units};
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
/// A name with what it is said of a cell.
type Tag = (&'static str, fn(&Tags) -> usize);
/// What is said of each cell.
pub(super) const TAGS: [Tag; 4] = [
    ("object", |tags| tags.object),
    ("part", |tags| tags.part),
    ("shell", |tags| tags.shell),
    ("flag", |tags| tags.flag),
];

/// Gap allowed between the pieces of a contour, relative to its largest coordinate: they share their end points.
const GAP: f64 = 1e-12;
/// Largest degree: far above ours, far below what overflows.
const MOST_DEGREE: usize = 1000;

/// Reads curves, patches and volumes.
pub(super) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let text =
        std::str::from_utf8(bytes).map_err(|e| ReadError::syntax(format!("byte {}", e.valid_up_to()), "not text"))?;
    for (place, attribute) in [("VTKFile", "version=\"2.2\""), ("PointData", "RationalWeights=\"RationalWeights\"")] {
        if !text.contains(attribute) {
            return Err(ReadError::syntax(place, format!("expected {attribute}")));
        }
    }
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
    let cells = cells(&arrays)?;
    let mut content = FileContent { labels, ..FileContent::default() };
    let mut contours: Vec<(Tags, Vec<ChainPiece>)> = Vec::new();
    let mut bodies: Vec<(usize, usize)> = Vec::new();
    let mut blocks: Vec<(usize, usize)> = Vec::new();
    for (number, cell) in cells.into_iter().enumerate() {
        let place = format!("cell {number}");
        let geometry = |source| ReadError::Geometry { place: place.clone(), source };
        let [p, q, _] = cell.degrees;
        let key = (cell.tags.object, cell.tags.part);
        match cell.kind {
            CURVE => {
                let span = RationalBezier::new(cell.rows()).and_then(spline_of).map_err(geometry)?;
                match contours.last_mut() {
                    Some((tags, pieces)) if *tags == cell.tags => pieces.push(ChainPiece::Spline(span)),
                    _ => contours.push((cell.tags, vec![ChainPiece::Spline(span)])),
                }
            }
            QUADRILATERAL => {
                let surface = RationalBezierSurface::new([p, q], cell.rows()).map_err(geometry)?;
                let body = number_of(&mut bodies, key);
                content.patches.push(FilePatch { body, shell: cell.tags.shell, outward: cell.tags.flag == 1, surface });
            }
            _ => {
                let volume = RationalBezierVolume::new(cell.degrees, cell.rows()).map_err(geometry)?;
                content.volumes.push(FileVolume { body: number_of(&mut blocks, key), volume });
            }
        }
    }
    for (number, (tags, pieces)) in contours.into_iter().enumerate() {
        let ends = pieces.iter().flat_map(|piece| [piece.start(), piece.end()]);
        let size = ends.map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let chain = CurveChain::new(pieces, tags.flag == 1, GAP * size);
        content.curves.push(chain.map_err(|source| ReadError::Geometry { place: format!("curve {number}"), source })?);
    }
    Ok(content)
}

/// The number of a key among those that were met, in their order.
fn number_of(met: &mut Vec<(usize, usize)>, key: (usize, usize)) -> usize {
    match met.last() {
        Some(last) if *last == key => met.len() - 1,
        _ => {
            met.push(key);
            met.len() - 1
        }
    }
}

/// The arrays of the file by their names.
fn arrays(text: &str) -> Result<HashMap<&str, Vec<f64>>, ReadError> {
    let mut arrays = HashMap::new();
    for (number, part) in text.split("<DataArray ").skip(1).enumerate() {
        let place = || format!("array {number}");
        let wrong = |detail: &str| ReadError::syntax(place(), detail);
        let (head, rest) = part.split_once('>').ok_or_else(|| wrong("its tag has no end"))?;
        let (values, _) = rest.split_once("</DataArray>").ok_or_else(|| wrong("it has no end"))?;
        let name = head.split_once("Name=\"").and_then(|(_, name)| name.split_once('"'));
        let (name, _) = name.ok_or_else(|| wrong("it has no name"))?;
        if !head.contains("format=\"ascii\"") {
            return Err(ReadError::unsupported("an encoding other than ascii", place()));
        }
        let numbers = values.split_ascii_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>();
        let numbers = numbers.map_err(|_| wrong("a value is no number"))?;
        if numbers.iter().any(|v| !v.is_finite()) || arrays.insert(name, numbers).is_some() {
            return Err(wrong("a value is not finite, or its name is there twice"));
        }
    }
    Ok(arrays)
}

fn array<'a>(arrays: &'a HashMap<&str, Vec<f64>>, name: &str) -> Result<&'a [f64], ReadError> {
    arrays.get(name).map(Vec::as_slice).ok_or_else(|| ReadError::syntax(name, "there is no such array"))
}

/// Numbers that count something.
fn whole(arrays: &HashMap<&str, Vec<f64>>, name: &str) -> Result<Vec<usize>, ReadError> {
    let count = |v: &f64| (*v >= 0.0 && *v <= 1e15 && v.fract().abs() <= 0.0).then_some(*v as usize);
    let counts = array(arrays, name)?.iter().map(count).collect::<Option<Vec<_>>>();
    counts.ok_or_else(|| ReadError::syntax(name, "a value is no count"))
}

fn strings(arrays: &HashMap<&str, Vec<f64>>, name: &str) -> Result<Vec<String>, ReadError> {
    let bytes = whole(arrays, name)?;
    let bytes = bytes.into_iter().map(u8::try_from).collect::<Result<Vec<u8>, _>>();
    let bytes = bytes.map_err(|_| ReadError::syntax(name, "a value is no byte"))?;
    let Some((0, bytes)) = bytes.split_last() else {
        return if bytes.is_empty() { Ok(Vec::new()) } else { Err(ReadError::syntax(name, "the last one has no end")) };
    };
    let string = |part: &[u8]| String::from_utf8(part.to_vec()).map_err(|_| ReadError::syntax(name, "not text"));
    bytes.split(|byte| *byte == 0).map(string).collect()
}

fn cells(arrays: &HashMap<&str, Vec<f64>>) -> Result<Vec<Cell>, ReadError> {
    let (kinds, ends, degrees) = (whole(arrays, TYPES)?, whole(arrays, OFFSETS)?, whole(arrays, DEGREES)?);
    let (points, weights) = (array(arrays, POINTS)?, array(arrays, WEIGHTS)?);
    let tags = TAGS.map(|(name, _)| whole(arrays, name));
    let [objects, parts, shells, flags] = tags;
    let (objects, parts, shells, flags) = (objects?, parts?, shells?, flags?);
    let counts = [ends.len(), objects.len(), parts.len(), shells.len(), flags.len()];
    if counts.iter().any(|n| *n != kinds.len()) || degrees.len() != 3 * kinds.len() {
        return Err(ReadError::syntax(TYPES, "arrays of cells differ in length"));
    }
    if points.len() != 3 * weights.len() || !whole(arrays, CONNECTIVITY)?.into_iter().eq(0..weights.len()) {
        return Err(ReadError::syntax(CONNECTIVITY, "nodes are not those of the cells in their order"));
    }
    let mut from = 0;
    let mut cells = Vec::with_capacity(kinds.len());
    for (number, kind) in kinds.into_iter().enumerate() {
        let wrong = |detail: &str| ReadError::syntax(format!("cell {number}"), detail);
        let degrees: Degrees = [degrees[3 * number], degrees[3 * number + 1], degrees[3 * number + 2]];
        let fits = match (u8::try_from(kind), degrees) {
            (Ok(CURVE), [p, 0, 0]) => p > 0,
            (Ok(QUADRILATERAL), [p, q, 0]) => p > 0 && q > 0,
            (Ok(HEXAHEDRON), [p, q, r]) => p > 0 && q > 0 && r > 0,
            _ => false,
        };
        if !fits || degrees.iter().any(|d| *d > MOST_DEGREE) {
            return Err(wrong("its degrees do not fit its type"));
        }
        let to = ends[number];
        let own = weights.get(from..to).ok_or_else(|| wrong("its nodes are not there"))?;
        if own.len() != degrees.iter().map(|d| d + 1).product::<usize>() || own.iter().any(|w| !(*w > 0.0)) {
            return Err(wrong("expected as many nodes as its degrees say, with positive weights"));
        }
        let node = |k: usize| ([points[3 * k], points[3 * k + 1], points[3 * k + 2]], weights[k]);
        let tags = Tags { object: objects[number], part: parts[number], shell: shells[number], flag: flags[number] };
        cells.push(Cell { kind: kind as u8, degrees, nodes: (from..to).map(node).collect(), tags });
        from = to;
    }
    if from == weights.len() { Ok(cells) } else { Err(ReadError::syntax(OFFSETS, "nodes are left over")) }
}
