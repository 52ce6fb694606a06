//! Our own G+Smo XML back from the bytes.

use super::{MultiPatch, OBJECT, UNITS};
use crate::check::file_content::FileContent;
use crate::check::labels::{FileLabels, FileName};
use crate::check::read_error::ReadError;
use crate::check::spline_patches::add_patches;
use crate::export::rational_cells::{MOST_TAG, RationalCell, Tags};
use crate::export::spline_patches::{Knots, SplinePatch};
use crate::text::xml::attribute;
use cyclide::model::Units;
use std::str::FromStr;

/// What the names are those of.
pub(super) const NAME: &str = "object";
/// Largest degree: far above ours, far below what overflows.
const MOST_DEGREE: usize = 1000;

/// Reads the patches; interfaces and boundary have to be those of them.
pub(super) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let text =
        std::str::from_utf8(bytes).map_err(|e| ReadError::syntax(format!("byte {}", e.valid_up_to()), "not text"))?;
    let (head, body) = text.split_once("<Geometry ").unwrap_or((text, ""));
    if !head.contains("<xml>") {
        return Err(ReadError::syntax("the head", "expected <xml>"));
    }
    let mut patches = Vec::new();
    for (number, element) in body.split("<Geometry ").enumerate().filter(|(_, element)| !element.is_empty()) {
        let place = format!("patch {number}");
        patches.push(patch(element).map_err(|detail| ReadError::syntax(place, detail))?);
    }
    if !patches.windows(2).all(|w| w[0].dimension() >= w[1].dimension()) {
        return Err(ReadError::syntax("Geometry", "patches are not sorted by dimension"));
    }
    let multi =
        multi_patches(head).ok_or_else(|| ReadError::syntax("MultiPatch", "expected ranges and lists of numbers"))?;
    let numbers = |multi: &MultiPatch| {
        (
            multi.dimension,
            multi.range,
            multi.interfaces.iter().map(|i| multi.interface(*i)).collect::<Vec<_>>(),
            multi.boundary.clone(),
        )
    };
    if !MultiPatch::all(&patches).iter().map(numbers).eq(multi) {
        return Err(ReadError::syntax("MultiPatch", "interfaces and boundary do not match the patches"));
    }
    let mut content = FileContent { labels: labels(head), ..FileContent::default() };
    add_patches(&mut content, patches)?;
    Ok(content)
}

/// Unit and names of the comments.
fn labels(head: &str) -> FileLabels {
    let mut labels = FileLabels::default();
    for comment in head.split("<!-- ").skip(1).filter_map(|part| Some(part.split_once("-->")?.0)) {
        if let Some(symbol) = comment.strip_prefix(UNITS) {
            labels.unit = Units::from_symbol(symbol.trim()).map(Units::in_millimetres);
        } else if let Some((_, name)) = comment.strip_prefix(OBJECT).and_then(|rest| rest.split_once(':')) {
            labels.names.push(FileName::new(NAME, name.trim(), 1));
        }
    }
    labels
}

/// Dimension, range, interfaces and boundary.
type Lists = (usize, [usize; 2], Vec<Vec<usize>>, Vec<[usize; 2]>);

fn multi_patches(head: &str) -> Option<Vec<Lists>> {
    let one = |part: &str| {
        let dimension = attribute(part.split_once('>')?.0, "parDim")?.parse().ok()?;
        let range = numbers(inside(part, "patches")?)?.try_into().ok()?;
        let lines =
            |text: &str| text.lines().filter(|line| !line.is_empty()).map(numbers::<usize>).collect::<Option<Vec<_>>>();
        let interfaces = lines(inside(part, "interfaces")?)?;
        let boundary = lines(inside(part, "boundary")?)?.into_iter().map(|side| side.try_into().ok());
        Some((dimension, range, interfaces, boundary.collect::<Option<Vec<_>>>()?))
    };
    head.split("<MultiPatch ").skip(1).map(one).collect()
}

fn patch(element: &str) -> Result<SplinePatch, &'static str> {
    let (tag, rest) = element.split_once('>').ok_or("its tag is not closed")?;
    let number = |name| {
        let tag = attribute(tag, name).and_then(|text| text.parse::<usize>().ok()).filter(|tag| *tag <= MOST_TAG);
        tag.ok_or("it does not name the object to which it belongs")
    };
    let tags =
        Tags { object: number("object")?, part: number("part")?, shell: number("shell")?, flag: number("flag")? };
    let dimension = match attribute(tag, "type") {
        Some("Nurbs") => 1,
        Some("TensorNurbs2") => 2,
        Some("TensorNurbs3") => 3,
        _ => return Err("it has a different type"),
    };
    let (mut knots, mut degrees) = (Vec::new(), [0; 3]);
    for own in rest.split("<KnotVector ").skip(1) {
        let (tag, own) = own.split_once('>').ok_or("a knot vector is not closed")?;
        let degree = attribute(tag, "degree").and_then(|text| text.parse::<usize>().ok());
        let degree = degree.filter(|d| (1..=MOST_DEGREE).contains(d)).ok_or("a knot vector has no degree")?;
        let (values, _) = own.split_once('<').ok_or("a knot vector is not closed")?;
        let values: Vec<f64> = numbers(values).ok_or("a knot is not a number")?;
        let count = values.len().checked_sub(degree + 1).filter(|n| *n > degree).ok_or("a knot vector is too short")?;
        *degrees.get_mut(knots.len()).ok_or("too many knot vectors")? = count - 1;
        knots.push(Knots { degree, knots: values });
    }
    if knots.len() != dimension {
        return Err("the number of knot vectors does not match its type");
    }
    let weights: Vec<f64> = inside(rest, "weights").and_then(numbers).ok_or("weights are not numbers")?;
    let points: Vec<f64> = inside(rest, "coefs").and_then(numbers).ok_or("control points are not numbers")?;
    let count = degrees.iter().try_fold(1_usize, |product, d| product.checked_mul(d + 1));
    if count != Some(weights.len())
        || points.len() != 3 * weights.len()
        || !weights.iter().all(|w| *w > 0.0 && w.is_finite())
        || !points.iter().all(|x| x.is_finite())
    {
        return Err("expected as many control points as the knots require, each with a positive weight");
    }
    let mut net = RationalCell { degrees, nodes: vec![([0.0; 3], 1.0); weights.len()], tags };
    for ((index, point), weight) in net.first_fastest().zip(points.chunks_exact(3)).zip(&weights) {
        let at = net.index(index);
        net.nodes[at] = ([point[0], point[1], point[2]], *weight);
    }
    Ok(SplinePatch { knots, net })
}

/// What stands between the tags of an element.
fn inside<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = text.split_once(&format!("<{name}"))?;
    let (_, rest) = rest.split_once('>')?;
    Some(rest.split_once(&format!("</{name}>"))?.0)
}

/// Numbers between blanks.
fn numbers<T: FromStr>(text: &str) -> Option<Vec<T>> {
    text.split_ascii_whitespace().map(|word| word.parse().ok()).collect()
}
