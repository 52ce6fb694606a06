//! Bodies as exact rational surfaces of degree (2, 2) with positive weights.

use super::{array, numbers, point, push_numbers};
use crate::export_error::ExportError;
use crate::file_content::ReadError;
use crate::job::BodyOf;
use crate::number::push_plain;
use cyclide::{ExactRational as _, ParamSurface as _, RationalBezierSurface, Shell};
use serde_json::Value;

/// Places per parameter at which surfaces are compared.
const PLACES: u32 = 9;

/// The shells of a body as they are written: patches whose weights are not all positive are cut.
fn shells(body: &BodyOf<'_>) -> cyclide::Result<Vec<Shell>> {
    body.body.shells().map(Shell::with_positive_weights).collect()
}

/// Writes a body as one element of the list `surfaces`.
pub(super) fn push_body(out: &mut String, body: &BodyOf<'_>) -> Result<(), ExportError> {
    let lowered = |source| body.unfit(source);
    out.push_str(&format!("{{\"closed\": {}, \"exact\": true, \"shells\": [", body.body.is_solid()));
    for (i, shell) in shells(body).map_err(lowered)?.iter().enumerate() {
        out.push_str(if i == 0 { "\n{\"patches\": [" } else { ",\n{\"patches\": [" });
        for (j, face) in shell.faces().iter().enumerate() {
            out.push_str(if j == 0 { "\n" } else { ",\n" });
            out.push_str(&format!("{{\"outward\": {}, ", face.same_sense));
            push_surface(out, &face.patch.to_rational());
        }
        out.push_str("]}");
    }
    out.push_str("]}");
    Ok(())
}

fn push_surface(out: &mut String, surface: &RationalBezierSurface) {
    let degrees = surface.degrees();
    out.push_str(&format!("\"degrees\": [{}, {}], \"knots\": [", degrees[0], degrees[1]));
    for (i, degree) in degrees.into_iter().enumerate() {
        out.push_str(if i == 0 { "" } else { ", " });
        push_numbers(out, &[vec![0.0; degree + 1], vec![1.0; degree + 1]].concat());
    }
    out.push_str("], \"control_points\": [");
    for (i, [x, y, z, w]) in surface.rows().iter().enumerate() {
        out.push_str(if i == 0 { "" } else { ", " });
        push_numbers(out, &[x / w, y / w, z / w]);
    }
    out.push_str("], \"weights\": [");
    for (i, row) in surface.rows().iter().enumerate() {
        out.push_str(if i == 0 { "" } else { ", " });
        push_plain(out, row[3]);
    }
    out.push_str("]}");
}

/// Reads the patches of an object's surfaces in file order.
pub(super) fn read(object: &Value, place: &str, patches: &mut Vec<RationalBezierSurface>) -> Result<(), ReadError> {
    if object.get("surfaces").is_none() {
        return Ok(());
    }
    for surface in array(object, "surfaces", place)? {
        for shell in array(surface, "shells", place)? {
            for patch in array(shell, "patches", place)? {
                patches.push(read_patch(patch, place)?);
            }
        }
    }
    Ok(())
}

fn read_patch(patch: &Value, place: &str) -> Result<RationalBezierSurface, ReadError> {
    let points = array(patch, "control_points", place)?.iter().map(|p| point(p, place));
    let points = points.collect::<Result<Vec<_>, _>>()?;
    let weights = numbers(array(patch, "weights", place)?, place)?;
    if weights.len() != points.len() || !weights.iter().all(|w| *w > 0.0) {
        return Err(ReadError::syntax(place, "expected a positive weight for each control point"));
    }
    let rows = points.iter().zip(&weights).map(|(p, w)| [p.x * w, p.y * w, p.z * w, *w]).collect();
    let degree = |d: &Value| d.as_u64().filter(|d| *d < 100).and_then(|d| usize::try_from(d).ok());
    let degrees: Option<Vec<usize>> = array(patch, "degrees", place)?.iter().map(degree).collect();
    let degrees = degrees.and_then(|d| <[usize; 2]>::try_from(d).ok());
    let degrees = degrees.ok_or_else(|| ReadError::syntax(place, "expected two degrees"))?;
    let surface = RationalBezierSurface::new(degrees, rows);
    surface.map_err(|source| ReadError::Geometry { place: place.to_owned(), source })
}

/// The largest distance at equal parameters between patches read and those of the bodies.
///
/// # Errors
/// [`ReadError::PatchCount`], `Geometry` where a body has no form of positive weights.
pub(crate) fn deviation(bodies: &[BodyOf<'_>], read: &[RationalBezierSurface]) -> Result<f64, ReadError> {
    let mut expected = Vec::new();
    for body in bodies {
        let shells = shells(body).map_err(|source| ReadError::Geometry { place: body.label(), source })?;
        expected.extend(shells.iter().flat_map(|shell| shell.faces().iter().map(|face| face.patch)));
    }
    if expected.len() != read.len() {
        return Err(ReadError::PatchCount { found: read.len(), expected: expected.len() });
    }
    let mut largest = 0.0_f64;
    for (patch, surface) in expected.iter().zip(read) {
        for k in 0..PLACES * PLACES {
            let at = |i: u32| f64::from(i) / f64::from(PLACES - 1);
            let (s, t) = (at(k % PLACES), at(k / PLACES));
            largest = largest.max(surface.point(s, t).distance(patch.point(s, t)));
        }
    }
    Ok(largest)
}
