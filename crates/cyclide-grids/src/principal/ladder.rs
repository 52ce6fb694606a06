//! How much the directions are smoothed: no more than gets rid of umbilics.

use super::cross_field::{CrossField, SingularVertex};
use super::mesh_table::MeshTable;
use super::shape_tensors::ShapeTensors;
use super::{PrincipalStage, no_solution};
use crate::principal_rules::UmbilicRule;
use cyclide::Result;

/// The steps; where pieces are cut, the first three.
const LADDER: [f64; 6] = [1.0, 4.0, 16.0, 64.0, 256.0, 1024.0];
const LADDER_OF_PIECES: usize = 3;

/// The field that was taken.
pub(super) struct Smoothed {
    pub(super) field: CrossField,
    pub(super) singular: Vec<SingularVertex>,
    pub(super) mu: f64,
    /// Umbilics on the first step.
    pub(super) found: usize,
}

/// The least smoothing with the fewest umbilics, or with none; of noisy surfaces not the least of all.
pub(super) fn smoothed(
    table: &MeshTable,
    tensors: &ShapeTensors,
    rule: UmbilicRule,
    noisy: bool,
    progress: &mut dyn FnMut(PrincipalStage),
) -> Result<Smoothed> {
    let ladder = match rule {
        UmbilicRule::Pieces | UmbilicRule::Joined => &LADDER[usize::from(noisy)..LADDER_OF_PIECES],
        UmbilicRule::Smooth => &LADDER[usize::from(noisy)..],
    };
    let mut best: Option<Smoothed> = None;
    for &mu in ladder {
        let field = CrossField::new(table, &tensors.smoothed(table, mu).ok_or_else(no_solution)?);
        let singular = field.singular_vertices(table);
        progress(PrincipalStage::Directions { smoothing: mu, umbilics: singular.len() });
        let found = best.as_ref().map_or(singular.len(), |best| best.found);
        if best.as_ref().is_none_or(|best| singular.len() < best.singular.len()) {
            best = Some(Smoothed { field, singular, mu, found });
        }
        if best.as_ref().is_some_and(|best| best.singular.is_empty()) {
            break;
        }
    }
    best.ok_or_else(no_solution)
}
