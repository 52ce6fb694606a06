//! Patches of B-splines of a file as curves, patches and volumes.

use crate::check::file_content::{FileContent, ReadError};
use crate::check::rational_cells::{add_bodies, add_curves};
use crate::export::spline_patches::{Knots, SplinePatch};
use cyclide::{NurbsCurve, Point3};

/// Adds what the patches are.
///
/// # Errors
/// [`ReadError::Geometry`], [`ReadError::Syntax`].
pub(crate) fn add_patches(content: &mut FileContent, patches: Vec<SplinePatch>) -> Result<(), ReadError> {
    let (mut curves, mut cells) = (Vec::new(), Vec::new());
    for (number, patch) in patches.into_iter().enumerate() {
        let place = format!("patch {number}");
        if let [Knots { degree, knots }] = patch.knots.as_slice() {
            let points = patch.net.nodes.iter().map(|(p, _)| Point3::from(*p)).collect();
            let weights = patch.net.nodes.iter().map(|(_, w)| *w).collect();
            let curve = NurbsCurve::new(*degree, knots.clone(), points, weights);
            curves.push((patch.net.tags, curve.map_err(|source| ReadError::Geometry { place, source })?));
            continue;
        }
        let spans = patch.net.degrees.iter().zip(&patch.knots);
        if !spans.clone().all(|(degree, knots)| *knots == Knots::of_span(*degree)) {
            return Err(ReadError::syntax(place, "its knots are not those of one Bézier span"));
        }
        cells.push((place, patch.net));
    }
    add_curves(content, curves)?;
    add_bodies(content, cells)
}
