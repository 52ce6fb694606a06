//! Patches of B-splines of a file as curves, patches and volumes.

use crate::check::file_content::FileContent;
use crate::check::rational_cells::{add_bodies, add_curves};
use crate::check::read_error::ReadError;
use crate::export::spline_patches::{Knots, SplinePatch};
use cyclide::{Point3, rational::NurbsCurve};

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
        let from_0_to_1 = |own: &Knots| own.knots.first() == Some(&0.0) && own.knots.last() == Some(&1.0);
        if !patch.knots.iter().all(from_0_to_1) {
            return Err(ReadError::syntax(place, "its knots do not range from 0 to 1"));
        }
        let spans = patch.spans().map_err(|source| ReadError::Geometry { place: place.clone(), source })?;
        cells.extend(spans.into_iter().map(|span| (place.clone(), span)));
    }
    add_curves(content, curves)?;
    add_bodies(content, cells)
}
