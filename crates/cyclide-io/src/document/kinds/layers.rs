//! Blocks in layers over a net.

use cyclide::{
    model::SurfaceObject,
    surface::CyclidicNet,
    volume::{CyclideGrid, CyclideVolume},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::cells::CellsSpec;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Reference, Shape, of};
use crate::error::Result;

/// Most layers that a number asks for.
const MOST_LAYERS: u32 = 4096;

/// Blocks in layers over a net: the spaces between its offsets. The lines across the layers are normal to all of them.
///
/// ```
/// use cyclide_io::Document;
/// let objects = r#""ring": {"type": "cyclide", "a": 3, "mu": 1}, "wall": {"type": "layers", "of": "ring", "distances": [-0.5, -0.1, 0]}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{objects}}}}}"#).parse::<Document>()?.build()?;
/// assert_eq!(built[1].item.volumes().len(), 32);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct LayersSpec {
    /// The word `layers`.
    #[schemars(with = "String", extend("const" = "layers"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of a patch, net or cyclide.
    pub of: String,
    /// Distances of the surfaces between layers along the normals, increasing; 0 is the surface itself. Alternatively
    /// `first`.
    #[schemars(length(min = 2))]
    pub distances: Option<Vec<f64>>,
    /// Height of the first layer, next to the surface; if negative, the layers are on the other side. Requires `count`.
    pub first: Option<f64>,
    /// Ratio of the height of each layer to that of the one before. Default 1.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub growth: Option<f64>,
    /// Number of layers.
    #[schemars(range(min = 1, max = 4096))]
    pub count: Option<u32>,
    /// How every block is divided into cells, for VTU cells, `report` and `sample`.
    pub cells: Option<CellsSpec>,
}

impl Kind for LayersSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let count = at.blocks_of_layers(self)?;
        at.check_block_count(count, if self.count.is_some() { "count" } else { "distances" })?;
        let volumes = at.layers(self)?;
        at.divided(volumes, self.cells.as_ref(), "of")
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}

impl Builder<'_> {
    /// The blocks of layers over the surfaces of the source. Layers of which there are none are refused.
    pub(in crate::document) fn blocks_of_layers(&self, spec: &LayersSpec) -> Result<f64> {
        let layers = match (&spec.distances, spec.count) {
            (Some(distances), _) => distances.len().saturating_sub(1),
            (None, Some(count)) if !(1..=MOST_LAYERS).contains(&count) => {
                let words = format!("{count} layers: the count must be from 1 to {MOST_LAYERS}");
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

    /// Blocks between the offsets of nets.
    pub(in crate::document) fn layers(&self, spec: &LayersSpec) -> Result<Vec<CyclideVolume>> {
        let distances = match (&spec.distances, spec.first, spec.count) {
            (Some(distances), None, None) if spec.growth.is_none() => distances.clone(),
            (None, Some(first), Some(count)) => {
                let growth = spec.growth.unwrap_or(1.0);
                if !(growth > 0.0 && growth.is_finite()) {
                    return Err(self.unfit("`growth` must be positive"));
                }
                let mut distances = vec![0.0];
                let (mut sum, mut height) = (0.0, first);
                for _ in 0..count {
                    sum += height;
                    height *= growth;
                    distances.push(sum);
                }
                // Layers on the other side, from the farthest to the surface.
                if first < 0.0 {
                    distances.reverse();
                }
                distances
            }
            _ => {
                return Err(
                    self.unfit("either `distances`, or `first` and `count` with an optional `growth`, are required")
                );
            }
        };
        self.check_layers_rise(spec, &distances)?;
        let field = if spec.distances.is_some() { "distances" } else { "first" };
        let source = self.surface_source("only surfaces have layers")?;
        let mut volumes = Vec::new();
        for surface in source.item.surfaces() {
            let grids = match surface {
                SurfaceObject::Patch(patch) => {
                    CyclideGrid::layers(&CyclidicNet::from(*patch), &distances).map(|grid| vec![grid])
                }
                SurfaceObject::Net(net) => CyclideGrid::layers(net, &distances).map(|grid| vec![grid]),
                SurfaceObject::Layout(layout) => CyclideGrid::layers_of_layout(layout, &distances),
                SurfaceObject::Body(_) | SurfaceObject::Triangles(_) => {
                    let solid = matches!(surface, SurfaceObject::Body(_)) && source.provenance.kind == "offset";
                    let remedy = if solid { "; the offset itself has layers without `thick`" } else { "" };
                    return Err(self.wrong_source(&format!(
                        "only a `cyclide-patch`, a `cyclidic-net` or a `cyclide` has layers{remedy}"
                    )));
                }
            };
            let grids = grids.map_err(|e| self.refused_at([Step::from(field)], &e))?;
            volumes.extend(grids.iter().flat_map(CyclideGrid::blocks));
        }
        Ok(volumes)
    }

    /// Refuses layers without a height.
    fn check_layers_rise(&self, spec: &LayersSpec, distances: &[f64]) -> Result<()> {
        let is_finite = distances.iter().all(|h| h.is_finite());
        let Some(k) = (1..distances.len()).find(|&k| is_finite && !(distances[k] > distances[k - 1])) else {
            return Ok(());
        };
        let (here, before) = (distances[k], distances[k - 1]);
        let (place, words) = match spec.first {
            None => (
                vec![Step::from("distances"), Step::from(k)],
                format!(
                    "{here} does not exceed {before}: distances must increase, from the lowest surface to the highest"
                ),
            ),
            Some(0.0) => (vec![Step::from("first")], "the height of a layer must not be 0".to_owned()),
            Some(_) => {
                let number = if here > 0.0 { k - 1 } else { distances.len() - 1 - k };
                (
                    vec![Step::from("growth")],
                    format!("layer {number} is too thin to change the distance {before} in double precision"),
                )
            }
        };
        Err(self.refused_in_words(place, "parameters-not-increasing", words))
    }
}
