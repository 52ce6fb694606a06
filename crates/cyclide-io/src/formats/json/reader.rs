//! Our own JSON back from the bytes.
//!
//! Numbers go straight into lists of doubles: a tree of JSON values would take several times the memory of the file.

use super::{body_kind, promised};
use crate::check::bodies::FilePatch;
use crate::check::file_content::FileContent;
use crate::check::labels::{FileLabels, FileName};
use crate::check::read_error::ReadError;
use cyclide::{
    Point3,
    model::{ChainPiece, CurveChain, Units},
    rational::{NurbsCurve, RationalBezierSurface},
};
use indexmap::IndexMap;
use serde::Deserialize;

/// Gap allowed between the curves of a contour, relative to its largest coordinate: they share their end points.
const GAP: f64 = 1e-12;
/// What the names of the objects are those of.
pub(super) const CURVES_OF: &str = "object with curves";
pub(super) const SURFACES_OF: &str = "object with surfaces";
/// Degrees at most: far above ours, far below what overflows.
const DEGREES: usize = 1000;

#[derive(Deserialize)]
struct File {
    #[serde(default)]
    units: Option<String>,
    objects: IndexMap<String, Object>,
}

#[derive(Deserialize)]
struct Object {
    #[serde(default)]
    r#type: String,
    contours: Vec<Contour>,
    #[serde(default)]
    surfaces: Vec<Body>,
}

#[derive(Deserialize)]
struct Contour {
    closed: bool,
    exact: bool,
    bound: f64,
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
    closed: bool,
    exact: bool,
    shells: Vec<Shell>,
}

#[derive(Deserialize)]
struct Shell {
    patches: Vec<Patch>,
}

#[derive(Deserialize)]
struct Patch {
    outward: bool,
    degrees: [usize; 2],
    knots: [Vec<f64>; 2],
    control_points: Vec<[f64; 3]>,
    weights: Vec<f64>,
}

/// Reads the curves of all contours and the patches of all surfaces.
pub(crate) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let file: File =
        serde_json::from_slice(bytes).map_err(|e| ReadError::syntax(format!("line {}", e.line()), e.to_string()))?;
    let unit = match file.units {
        Some(symbol) => {
            let unit = Units::from_symbol(&symbol);
            Some(unit.ok_or_else(|| ReadError::unsupported(format!("the unit {symbol}"), "/units"))?.in_millimetres())
        }
        None => None,
    };
    let mut content = FileContent { labels: FileLabels { unit, names: Vec::new() }, ..FileContent::default() };
    let mut bodies = 0;
    for (name, object) in file.objects {
        let place = format!("/objects/{name}/surfaces");
        let names = [("type", &object.r#type, 1), (CURVES_OF, &name, object.contours.len())];
        content.labels.names.extend(names.map(|(of, name, count)| FileName::new(of, name, count)));
        content.labels.names.push(FileName::new(SURFACES_OF, &name, object.surfaces.len()));
        content.labels.names.extend(object.contours.iter().map(|contour| promised(contour.exact, contour.bound)));
        content.labels.names.extend(object.surfaces.iter().map(|body| body_kind(body.closed, body.exact)));
        for (i, contour) in object.contours.into_iter().enumerate() {
            content.curves.push(contour.chain(&format!("/objects/{name}/contours/{i}"))?);
        }
        for body in object.surfaces {
            for (shell, Shell { patches }) in body.shells.into_iter().enumerate() {
                for patch in patches {
                    let outward = patch.outward;
                    content.patches.push(FilePatch { body: bodies, shell, outward, surface: patch.surface(&place)? });
                }
            }
            bodies += 1;
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
        let Self { degrees, knots, control_points, weights, .. } = self;
        if weights.len() != control_points.len() || !weights.iter().all(|w| *w > 0.0) {
            return Err(ReadError::syntax(place, "expected a positive weight for each control point"));
        }
        if degrees.iter().any(|degree| *degree >= DEGREES) {
            return Err(ReadError::syntax(place, "the degrees are too large"));
        }
        for (knots, degree) in knots.iter().zip(degrees) {
            let ends = [0.0, 1.0].into_iter().flat_map(|end| std::iter::repeat_n(end, degree + 1));
            if !ends.eq(knots.iter().copied()) {
                let detail = format!(
                    "the knots of a patch of degree {degree} are {knots:?}: expected degree + 1 zeros, then as many ones"
                );
                return Err(ReadError::syntax(place, detail));
            }
        }
        let rows = control_points.iter().zip(&weights).map(|([x, y, z], w)| [x * w, y * w, z * w, *w]).collect();
        RationalBezierSurface::new(degrees, rows)
            .map_err(|source| ReadError::Geometry { place: place.to_owned(), source })
    }
}
