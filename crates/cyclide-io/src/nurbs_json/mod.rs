//! JSON of the exact rational B-splines and surfaces, for programs that compute with them.
//!
//! ```text
//! {"cyclide-nurbs": 1, "units": "mm", "objects": {"NAME": {"type": "arc-spline", "contours": [
//!   {"closed": true, "exact": true, "bound": 0, "curves": [
//!     {"degree": 2, "knots": [...], "control_points": [[x, y, z], ...], "weights": [...]}, ...]}, ...]}}}
//! ```
//! Knots are clamped and of length points + degree + 1; control points are affine (not multiplied by their weight),
//! weights positive. A run of arcs and segments is one curve of degree 2: knot `i` to `i + 1` is its `i`-th arc, in
//! equal parts of at most a quarter turn. A smooth rational spline is one curve. The curves of a contour follow each
//! other end to end. `bound` is the largest distance from the object, 0 if exact.
//!
//! An object with surfaces has the list `surfaces` as well, one element per body:
//! ```text
//! {"closed": true, "exact": true, "shells": [{"patches": [
//!   {"outward": true, "degrees": [2, 2], "knots": [[...], [...]], "control_points": [[x, y, z], ...],
//!    "weights": [...]}, ...]}, ...]}
//! ```
//! The second parameter runs fastest in the lists of points and weights. `outward` is true if the outer side of the
//! body is that of `f_s × f_t`. Patches whose weights are not all positive are cut into patches whose weights are.

mod surfaces;

use crate::export_error::ExportError;

use crate::exported::{Exported, Promise};

use crate::file_content::{FileContent, ReadError};
use crate::job::{Contour, Job};
use crate::number::push_plain;
use cyclide::{Arc, ChainPiece, CurveChain, DEFAULT_PIECE_ANGLE, Exactness, NurbsCurve, Point3};
use serde_json::Value;

pub(crate) use surfaces::deviation as patch_deviation;

/// Gap allowed between the curves of a contour, relative to its largest coordinate: they share their end points.
const GAP: f64 = 1e-12;

/// Writes the model as JSON.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let mut promise = Promise::EXACT;
    let mut out = format!("{{\n\"cyclide-nurbs\": 1,\n\"units\": \"{}\",\n\"objects\": {{", job.units().symbol());
    for (index, item) in job.model.items.iter().enumerate() {
        let (name, kind) = (quoted(&item.name), quoted(&item.kind));
        out.push_str(if index == 0 { "\n" } else { ",\n" });
        out.push_str(&format!("{name}: {{\"type\": {kind}, \"contours\": ["));
        for contour in job.contours().filter(|contour| contour.item == index) {
            let (chain, exactness) = job.chain(&contour)?;
            promise.add(exactness);
            out.push_str(if contour.index == 0 { "\n" } else { ",\n" });
            push_contour(&mut out, &contour, &chain, exactness)?;
        }
        out.push_str(if item.contours.is_empty() { "]" } else { "\n]" });
        for body in job.bodies.iter().filter(|body| body.item == index) {
            out.push_str(if body.index == 0 { ", \"surfaces\": [\n" } else { ",\n" });
            surfaces::push_body(&mut out, body)?;
        }
        out.push_str(if item.surfaces.is_empty() { "}" } else { "\n]}" });
    }
    out.push_str("\n}\n}\n");
    Ok(promise.exported(out.into_bytes(), Vec::new()))
}

fn push_contour(
    out: &mut String,
    contour: &Contour<'_>,
    chain: &CurveChain,
    exactness: Exactness,
) -> Result<(), ExportError> {
    use cyclide::ParamCurve as _;
    out.push_str(&format!(
        "{{\"closed\": {}, \"exact\": {}, \"bound\": ",
        chain.is_closed(),
        exactness == Exactness::Exact
    ));
    push_plain(out, exactness.bound());
    out.push_str(", \"curves\": [");
    for (i, curve) in curves(chain).into_iter().enumerate() {
        let curve = contour.lowered(curve)?;
        out.push_str(if i == 0 { "\n" } else { ",\n" });
        push_curve(out, &curve);
    }
    out.push_str("]}");
    Ok(())
}

fn push_curve(out: &mut String, curve: &NurbsCurve) {
    out.push_str(&format!("{{\"degree\": {}, \"knots\": ", curve.degree()));
    push_numbers(out, curve.knots());
    out.push_str(", \"control_points\": [");
    for (i, p) in curve.control_points().iter().enumerate() {
        if i > 0 {
            out.push_str(", ");
        }
        push_numbers(out, &p.to_array());
    }
    out.push_str("], \"weights\": ");
    push_numbers(out, curve.weights());
    out.push('}');
}

fn push_numbers(out: &mut String, numbers: &[f64]) {
    out.push('[');
    for (i, &v) in numbers.iter().enumerate() {
        if i > 0 {
            out.push_str(", ");
        }
        push_plain(out, v);
    }
    out.push(']');
}

fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

/// The chain as B-splines: runs of arcs joined to one each.
fn curves(chain: &CurveChain) -> Vec<cyclide::Result<NurbsCurve>> {
    let arc = |p: &ChainPiece| matches!(p, ChainPiece::Arc(_));
    let runs = chain.pieces().chunk_by(|a, b| arc(a) && arc(b));
    runs.map(|run| match run {
        [ChainPiece::Spline(curve)] => Ok(curve.with_c1_knots().unwrap_or_else(|| curve.clone())),
        arcs => quadratic(arcs.iter().filter_map(|p| match p {
            ChainPiece::Arc(arc) => Some(arc),
            ChainPiece::Spline(_) => None,
        })),
    })
    .collect()
}

/// Arcs that meet as one rational quadratic: arc `i` over `[i, i+1]`, double knots at every joint.
fn quadratic<'a>(arcs: impl Iterator<Item = &'a Arc>) -> cyclide::Result<NurbsCurve> {
    let (mut points, mut weights, mut knots) = (Vec::new(), Vec::new(), vec![0.0]);
    let mut end = 0.0;
    for arc in arcs {
        let piece = arc.to_nurbs(DEFAULT_PIECE_ANGLE)?;
        // Ends of arcs that meet are the same doubles, with weight 1 on both sides.
        let skip = usize::from(!points.is_empty());
        points.extend_from_slice(&piece.control_points()[skip..]);
        weights.extend_from_slice(&piece.weights()[skip..]);
        for u in &piece.breaks()[..piece.breaks().len() - 1] {
            knots.extend([end + u; 2]);
        }
        end += 1.0;
    }
    knots.extend([end; 3]);
    NurbsCurve::new(2, knots, points, weights)
}

/// Reads the curves of all contours and the patches of all surfaces.
pub(crate) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let text = serde_json::from_slice::<Value>(bytes);
    let file = text.map_err(|e| ReadError::syntax(format!("line {}", e.line()), e.to_string()))?;
    let objects = file.get("objects").and_then(Value::as_object);
    let objects = objects.ok_or_else(|| ReadError::syntax("/", "no object \"objects\""))?;
    let mut content = FileContent::default();
    for (name, object) in objects {
        let place = format!("/objects/{name}/contours");
        for (i, contour) in array(object, "contours", &place)?.iter().enumerate() {
            content.curves.push(read_contour(contour, format!("{place}/{i}"))?);
        }
        surfaces::read(object, &format!("/objects/{name}/surfaces"), &mut content.patches)?;
    }
    Ok(content)
}

fn read_contour(contour: &Value, place: String) -> Result<CurveChain, ReadError> {
    let closed = contour.get("closed").and_then(Value::as_bool);
    let closed = closed.ok_or_else(|| ReadError::syntax(&place, "no boolean \"closed\""))?;
    let mut pieces = Vec::new();
    for curve in array(contour, "curves", &place)? {
        let degree = curve.get("degree").and_then(Value::as_u64).and_then(|d| usize::try_from(d).ok());
        let degree = degree.filter(|d| *d < 1000).ok_or_else(|| ReadError::syntax(&place, "no integer \"degree\""))?;
        let points = array(curve, "control_points", &place)?.iter().map(|p| point(p, &place));
        let points = points.collect::<Result<Vec<_>, _>>()?;
        let knots = numbers(array(curve, "knots", &place)?, &place)?;
        let weights = numbers(array(curve, "weights", &place)?, &place)?;
        let curve = NurbsCurve::new(degree, knots, points, weights);
        pieces.push(ChainPiece::Spline(curve.map_err(|source| ReadError::Geometry { place: place.clone(), source })?));
    }
    let ends = pieces.iter().flat_map(|p| [p.start(), p.end()]);
    let size = ends.map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    CurveChain::new(pieces, closed, GAP * size).map_err(|source| ReadError::Geometry { place, source })
}

fn array<'a>(value: &'a Value, key: &str, place: &str) -> Result<&'a [Value], ReadError> {
    let array = value.get(key).and_then(Value::as_array);
    array.map(Vec::as_slice).ok_or_else(|| ReadError::syntax(place, format!("no array \"{key}\"")))
}

fn numbers(values: &[Value], place: &str) -> Result<Vec<f64>, ReadError> {
    let number = |v: &Value| v.as_f64().ok_or_else(|| ReadError::syntax(place, "expected numbers"));
    values.iter().map(number).collect()
}

fn point(value: &Value, place: &str) -> Result<Point3, ReadError> {
    let numbers = numbers(value.as_array().map_or(&[], Vec::as_slice), place)?;
    let point = <[f64; 3]>::try_from(numbers).map_err(|_| ReadError::syntax(place, "expected three coordinates"))?;
    Ok(point.into())
}
