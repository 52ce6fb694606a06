//! A checked request to a writer: the model lowered to contours and bodies, the options with the defaults filled in.

use crate::export::error::ExportError;
use crate::export::lowered::LoweredCurves;
use crate::export::moving::MovingRoom;
use crate::export::options::{DEFAULT_MOST_PIECES, ExportOptions, PIECES_OF_EACH};
use crate::export::parts::{BodyOf, Contour, contours};
use crate::export::pieces::Pieces;
use crate::export::provenance::Provenances;
use crate::export::ready::ReadyModel;
use cyclide::{
    Aabb,
    curve::ArcPath,
    model::{CurveChain, Lowered, Model, Units},
};

/// Tolerance of curves when none is asked for: this part of the model's diagonal.
const DEFAULT_RELATIVE_TOLERANCE: f64 = 1e-5;
/// The same of meshes, whose size grows with its inverse (that of polylines with the root only).
const DEFAULT_MESH_TOLERANCE: f64 = 1e-4;

/// A checked request: the model, the options with the defaults filled in, and the model's size.
pub(crate) struct Job<'a> {
    pub(crate) model: &'a Model,
    /// How its objects came about.
    pub(crate) provenances: Provenances<'a>,
    pub(crate) options: &'a ExportOptions,
    /// Tolerance of curves.
    pub(crate) tolerance: f64,
    /// Tolerance of meshes.
    pub(crate) mesh_tolerance: f64,
    /// How many pieces the file may be made of.
    pub(crate) pieces: Pieces,
    /// The smallest box around all curves and surfaces.
    pub(crate) bounds: Aabb,
    /// The bodies of all surfaces, in the model's order.
    pub(crate) bodies: &'a [BodyOf<'a>],
    /// The rooms of the motions, in the model's order.
    pub(crate) moving: &'a [MovingRoom],
    lowered: &'a LoweredCurves,
}

impl<'a> Job<'a> {
    pub(crate) fn new(ready: &'a ReadyModel<'a>, options: &'a ExportOptions) -> Result<Self, ExportError> {
        let ReadyModel { model, provenances, ref bodies, bounds, ref moving, ref lowered, .. } = *ready;
        let tolerance = options.tolerance.unwrap_or_else(|| default_tolerance(bounds));
        let relative = DEFAULT_MESH_TOLERANCE / DEFAULT_RELATIVE_TOLERANCE;
        let mesh_tolerance = options.tolerance.unwrap_or_else(|| relative * default_tolerance(bounds));
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(ExportError::ToleranceNotPositive { tolerance });
        }
        let pieces = Pieces::new(options.max_pieces.unwrap_or_else(|| most_pieces(model, bodies)));
        Ok(Self { model, provenances, options, tolerance, mesh_tolerance, pieces, bounds, bodies, moving, lowered })
    }

    pub(crate) fn units(&self) -> Units {
        self.model.units
    }

    /// Diagonal of the model, never zero.
    pub(crate) fn size(&self) -> f64 {
        self.bounds.diagonal().max(f64::MIN_POSITIVE)
    }

    /// The model's name: asked for, or that of the only object.
    pub(crate) fn title(&self) -> &str {
        match (&self.options.title, self.model.items.as_slice()) {
            (Some(title), _) => title,
            (None, [only]) => &only.name,
            _ => "cyclide",
        }
    }

    pub(crate) fn contours(&self) -> impl Iterator<Item = Contour<'a>> {
        contours(self.model)
    }

    /// As [`LoweredCurves::chain`].
    pub(crate) fn chain(&self, contour: &Contour<'_>) -> Result<Lowered<CurveChain>, ExportError> {
        self.lowered.chain(contour, self.tolerance)
    }

    /// As [`LoweredCurves::arcs`].
    pub(crate) fn arcs(&self, contour: &Contour<'_>) -> Result<Lowered<ArcPath>, ExportError> {
        self.lowered.arcs(contour, self.tolerance)
    }
}

/// The pieces that a file may have if nothing else is asked for.
fn most_pieces(model: &Model, bodies: &[BodyOf<'_>]) -> usize {
    let of_curves: usize = contours(model).map(|contour| contour.curve.as_curve().piece_count()).sum();
    let faces: usize = bodies.iter().map(|body| body.body.part_count()).sum();
    DEFAULT_MOST_PIECES.saturating_add((of_curves + faces).saturating_mul(PIECES_OF_EACH))
}

/// The tolerance that applies when none is asked for; for a model without extent that of a model of size 1.
pub(crate) fn default_tolerance(bounds: Aabb) -> f64 {
    let size = bounds.diagonal();
    DEFAULT_RELATIVE_TOLERANCE * if size > 0.0 { size } else { 1.0 }
}
