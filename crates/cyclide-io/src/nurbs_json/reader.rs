//! Our own JSON back from the bytes.
//!
//! Numbers go straight into lists of doubles: a tree of JSON values would take several times the memory of the file.

use crate::file_content::{FileContent, ReadError};
use cyclide::{ChainPiece, CurveChain, NurbsCurve, Point3, RationalBezierSurface};
use indexmap::IndexMap;
use serde::Deserialize;

/// Gap allowed between the curves of a contour, relative to its largest coordinate: they share their end points.
const GAP: f64 = 1e-12;
/// Degrees at most: far above ours, far below what overflows.
const DEGREES: usize = 1000;

#[derive(Deserialize)]
struct File {
    objects: IndexMap<String, Object>,
}

#[derive(Deserialize)]
struct Object {
    contours: Vec<Contour>,
    #[serde(default)]
    surfaces: Vec<Body>,
}

#[derive(Deserialize)]
struct Contour {
    closed: bool,
    curves: Vec<Curve>,
}

#[derive(Deserialize)]
struct Curve {
    degree: usize,
    knots: Vec<f64>,
    control_points: Vec<[f64; 3]>,
    weights: Vec<f64>,
}

#[derive(Deserialize)]
struct Body {
    shells: Vec<Shell>,
}

#[derive(Deserialize)]
struct Shell {
    patches: Vec<Patch>,
}

#[derive(Deserialize)]
struct Patch {
    degrees: [usize; 2],
    control_points: Vec<[f64; 3]>,
    weights: Vec<f64>,
}

/// Reads the curves of all contours and the patches of all surfaces.
pub(crate) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let file: File =
        serde_json::from_slice(bytes).map_err(|e| ReadError::syntax(format!("line {}", e.line()), e.to_string()))?;
    let mut content = FileContent::default();
    for (name, object) in file.objects {
        for (i, contour) in object.contours.into_iter().enumerate() {
            content.curves.push(contour.chain(&format!("/objects/{name}/contours/{i}"))?);
        }
        let place = format!("/objects/{name}/surfaces");
        let shells = object.surfaces.into_iter().flat_map(|body| body.shells);
        for patch in shells.flat_map(|shell| shell.patches) {
            content.patches.push(patch.surface(&place)?);
        }
    }
    Ok(content)
}

impl Contour {
    fn chain(self, place: &str) -> Result<CurveChain, ReadError> {
        let geometry = |source| ReadError::Geometry { place: place.to_owned(), source };
        let mut pieces = Vec::with_capacity(self.curves.len());
        for Curve { degree, knots, control_points, weights } in self.curves {
            if degree >= DEGREES {
                return Err(ReadError::syntax(place, "the degree is too large"));
            }
            let points = control_points.into_iter().map(Point3::from).collect();
            pieces.push(ChainPiece::Spline(NurbsCurve::new(degree, knots, points, weights).map_err(geometry)?));
        }
        let ends = pieces.iter().flat_map(|p| [p.start(), p.end()]);
        let size = ends.map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        CurveChain::new(pieces, self.closed, GAP * size).map_err(geometry)
    }
}

impl Patch {
    fn surface(self, place: &str) -> Result<RationalBezierSurface, ReadError> {
        let Self { degrees, control_points, weights } = self;
        if weights.len() != control_points.len() || !weights.iter().all(|w| *w > 0.0) {
            return Err(ReadError::syntax(place, "expected a positive weight for each control point"));
        }
        if degrees.iter().any(|degree| *degree >= DEGREES) {
            return Err(ReadError::syntax(place, "the degrees are too large"));
        }
        let rows = control_points.iter().zip(&weights).map(|([x, y, z], w)| [x * w, y * w, z * w, *w]).collect();
        RationalBezierSurface::new(degrees, rows)
            .map_err(|source| ReadError::Geometry { place: place.to_owned(), source })
    }
}
