//! Bodies as exact rational surfaces with positive weights: patches of degree (2, 2), rational faces of theirs.

use super::push_numbers;
use crate::check::bodies::FilePatch;
use crate::check::deviation::larger;
use crate::check::file_content::ReadError;
use crate::export::error::ExportError;
use crate::export::parts::BodyOf;
use crate::text::number::push_plain;
use cyclide::{FaceGeometry as _, ParamSurface as _, RationalBezierSurface, Shell};

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
            push_surface(out, &face.surface.to_rational());
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

/// The largest distance at equal parameters between the patches read and those of each body.
///
/// # Errors
/// [`ReadError::PatchCount`], [`ReadError::Patch`], `Geometry` where a body has no form of positive weights.
pub(crate) fn deviation(bodies: &[BodyOf<'_>], read: &[FilePatch]) -> Result<Vec<f64>, ReadError> {
    let mut expected = Vec::new();
    for (index, body) in bodies.iter().enumerate() {
        let shells = shells(body).map_err(|source| ReadError::Geometry { place: body.label(), source })?;
        for (shell, faces) in shells.iter().map(Shell::faces).enumerate() {
            expected.extend(faces.iter().map(|face| (index, shell, face.same_sense, face.surface.clone())));
        }
    }
    if expected.len() != read.len() {
        return Err(ReadError::PatchCount { found: read.len(), expected: expected.len() });
    }
    let mut deviations = vec![0.0; bodies.len()];
    for (number, ((body, shell, outward, surface), found)) in expected.into_iter().zip(read).enumerate() {
        let wrong = if (found.body, found.shell) != (body, shell) {
            Some("it belongs to another body or shell")
        } else {
            (found.outward != outward).then_some("its outer side is the other one")
        };
        if let Some(detail) = wrong {
            return Err(ReadError::Patch { patch: number, detail });
        }
        for k in 0..PLACES * PLACES {
            let at = |i: u32| f64::from(i) / f64::from(PLACES - 1);
            let (s, t) = (at(k % PLACES), at(k / PLACES));
            deviations[body] = larger(deviations[body], found.surface.point(s, t).distance(surface.point(s, t)));
        }
    }
    Ok(deviations)
}
