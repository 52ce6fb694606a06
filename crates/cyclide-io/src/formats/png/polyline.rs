//! The curves of a model as polylines, which pictures draw.

use crate::export::error::ExportError;
use crate::export::job::Job;
use crate::export::parts::Contour;
use cyclide::Point3;

/// Flattening, pixels: well below what anti-aliasing shows.
pub(super) const FLATNESS: f64 = 0.05;
/// Width of a curve in a picture of the usual width.
pub(super) const CURVE: f64 = 3.4;

/// A flattened contour.
pub(super) struct Polyline {
    pub(super) object: usize,
    pub(super) points: Vec<Point3>,
    pub(super) closed: bool,
}

pub(super) fn curves(job: &Job<'_>, tolerance: f64) -> Result<Vec<Polyline>, ExportError> {
    let one = |contour: Contour<'_>| {
        let curve = contour.curve.as_curve();
        let vertices = contour.lowered(job.pieces.flatten(curve, tolerance))?;
        let points = vertices.into_iter().map(|(_, p)| p).collect();
        Ok(Polyline { object: contour.item, points, closed: curve.is_closed() })
    };
    job.contours().map(one).collect()
}
