//! What is refused of objects of blocks before any block is made: too many of them, and surfaces that are there twice.

use cyclide::SurfaceObject;

use super::Builder;
use super::nets::SEGMENTS;
use crate::document::locate::Step;
use crate::document::spec::{CoordinateSurfacesSpec, CyclideGridSpec, LayersSpec};
use crate::error::Result;

/// Most blocks of one object: with their faces they take ten kilobytes each, a gigabyte together.
const MOST_BLOCKS: usize = 100_000;
/// Most layers that a number asks for.
const MOST_LAYERS: u32 = 4096;

impl Builder<'_> {
    /// Refuses objects of more blocks than are made, at the field that says how many.
    pub(in crate::document) fn check_block_count(&self, count: f64, field: &str) -> Result<()> {
        if count <= MOST_BLOCKS as f64 {
            return Ok(());
        }
        let error = cyclide::Error::TooManyPieces {
            what: "the grid of blocks",
            segment: None,
            needed: count,
            cap: MOST_BLOCKS,
            remedy: "make fewer and larger blocks, and divide these by `cells`",
        };
        Err(self.refused_at([Step::from(field)], &error))
    }

    /// The blocks of layers over the surfaces of the source. Layers of which there are none are refused.
    pub(in crate::document) fn blocks_of_layers(&self, spec: &LayersSpec) -> Result<f64> {
        let layers = match (&spec.distances, spec.count) {
            (Some(distances), _) => distances.len().saturating_sub(1),
            (None, Some(count)) if !(1..=MOST_LAYERS).contains(&count) => {
                let words = format!("{count} layers: there are 1 to {MOST_LAYERS}");
                return Err(self.refused_in_words([Step::from("count")], "parameter-out-of-range", words));
            }
            (None, Some(count)) => count as usize,
            // What is missing is said where layers are made.
            (None, None) => 0,
        };
        let patches = |surface: &SurfaceObject| {
            let of_nets: usize = surface.nets().iter().map(|net| net.patches_with_quads().count()).sum();
            of_nets.max(1) as f64
        };
        let surfaces = self.sources.first().map_or(&[][..], |source| source.item.surfaces());
        Ok(surfaces.iter().map(patches).sum::<f64>() * layers as f64)
    }

    /// Refuses values of a parameter that are given twice: two surfaces would be one.
    pub(in crate::document) fn check_surfaces_differ(&self, spec: &CoordinateSurfacesSpec) -> Result<()> {
        for (field, values) in [("s", &spec.s), ("t", &spec.t), ("u", &spec.u)] {
            let again = |k: usize| values[..k].iter().position(|x| x.total_cmp(&values[k]).is_eq());
            if let Some((k, before)) = (0..values.len()).find_map(|k| Some((k, again(k)?))) {
                let words = format!(
                    "{field}[{k}] = {} is {field}[{before}] again: the surfaces would lie on each other",
                    values[k]
                );
                let place = [Step::from(field), Step::from(k)];
                return Err(self.refused_in_words(place, "parameters-not-increasing", words));
            }
        }
        Ok(())
    }
}

/// The blocks of a grid, as far as its numbers say; segments are rounded up to even numbers.
pub(in crate::document) fn blocks_of_grid(spec: &CyclideGridSpec) -> f64 {
    if let Some(whole) = &spec.whole {
        let segments = whole.segments.unwrap_or(SEGMENTS).map(|n| f64::from(n) + f64::from(n % 2));
        return segments[0] * segments[1] * whole.mu.len().saturating_sub(1) as f64;
    }
    spec.planes.as_ref().map_or(0.0, |planes| {
        let columns = planes.st.first().map_or(0, Vec::len);
        [columns, planes.st.len(), planes.su.len()].map(|n| n.saturating_sub(1) as f64).into_iter().product()
    })
}
