//! How blocks are divided into cells.

use cyclide::{
    error::{ErrorItem, NumberError},
    volume::{CyclideVolume, FineEnd, Grading, GridQuality, StructuredGrid},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::facts::{CellFacts, Facts};
use crate::error::{Error, Result};

/// How blocks are divided into cells: a number for all three directions, or numbers or laws along s, t and u.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let cells = r#"[4, 2, {"count": 10, "first": 0.01, "fine": "end"}]"#;
/// let wall = format!(r#""w": {{"type": "cyclide-grid", "whole": {{"a": 3, "mu": [0.5, 1]}}, "cells": {cells}}}"#);
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{wall}}}}}"#).parse::<Document>()?.build()?;
/// let GeometryReport::Volume(report) = ObjectReport::new(&built[0], None).geometry else { unreachable!("by its type") };
/// let cells = report.cells.ok_or("it has cells")?;
/// assert!(cells.divisions == [4, 2, 10] && (cells.shortest_side - 0.01).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Cells")]
#[non_exhaustive]
pub enum CellsSpec {
    /// This number of equal cells along s, t and u.
    Count(#[schemars(range(min = 1, max = 4096))] u32),
    /// The cells along s, along t and along u.
    Along(Box<[CellsAlongSpec; 3]>),
}

impl<'de> Deserialize<'de> for CellsSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct CellsVisitor;
        impl<'de> serde::de::Visitor<'de> for CellsVisitor {
            type Value = CellsSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number of cells, or three, each a number or `{\"count\": N, …}`")
            }
            fn visit_u64<E: serde::de::Error>(self, count: u64) -> Result<CellsSpec, E> {
                count_of(count).map(CellsSpec::Count)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, _: A) -> Result<CellsSpec, A::Error> {
                Err(serde::de::Error::custom(
                    "a single law: `cells` along s, t and u must be a list of three, as in [8, 8, {\"count\": 20, \"first\": 0.01}]",
                ))
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<CellsSpec, A::Error> {
                let seq = serde::de::value::SeqAccessDeserializer::new(seq);
                <[CellsAlongSpec; 3]>::deserialize(seq).map(|along| CellsSpec::Along(Box::new(along)))
            }
        }
        deserializer.deserialize_any(CellsVisitor)
    }
}

/// The cells along one direction: a number, or a number and a law.
///
/// ```
/// use cyclide_io::Document;
/// let wall = r#""w": {"type": "cyclide-grid", "whole": {"a": 3, "mu": [0.5, 1]}, "cells": [4, 2, {"count": 4, "ratio": 1.5}]}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{wall}}}}}"#).parse::<Document>()?.build()?;
/// let places = built[0].provenance.places.as_ref().ok_or("it has cells")?;
/// assert!((places[2][1] - 1.0 / (1.0 + 1.5 + 2.25 + 3.375)).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "CellsAlong")]
#[non_exhaustive]
pub enum CellsAlongSpec {
    /// This number of equal cells.
    Count(#[schemars(range(min = 1, max = 4096))] u32),
    /// Cells of different lengths.
    Graded(GradedCellsSpec),
}

impl<'de> Deserialize<'de> for CellsAlongSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct AlongVisitor;
        impl<'de> serde::de::Visitor<'de> for AlongVisitor {
            type Value = CellsAlongSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number of cells, or `{\"count\": N, …}`")
            }
            fn visit_u64<E: serde::de::Error>(self, count: u64) -> Result<CellsAlongSpec, E> {
                count_of(count).map(CellsAlongSpec::Count)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<CellsAlongSpec, A::Error> {
                let map = serde::de::value::MapAccessDeserializer::new(map);
                GradedCellsSpec::deserialize(map).map(CellsAlongSpec::Graded)
            }
        }
        deserializer.deserialize_any(AlongVisitor)
    }
}

/// Cells of different lengths along one direction, by one of `ratio`, `stretch` and `first`.
///
/// ```
/// use cyclide_io::{Document, document::kinds::CellLaw};
/// let law = r#"{"count": 12, "law": "tanh", "first": 0.01, "fine": "both"}"#;
/// let wall = format!(r#""w": {{"type": "cyclide-grid", "whole": {{"a": 3, "mu": [0.5, 1]}}, "cells": [4, 2, {law}]}}"#);
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{wall}}}}}"#).parse::<Document>()?.build()?;
/// let places = built[0].provenance.places.as_ref().ok_or("it has cells")?;
/// assert!((places[2][1] - 0.02).abs() < 1e-9 && (places[2][11] - 0.98).abs() < 1e-9); // of half a unit
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct GradedCellsSpec {
    /// Number of cells.
    #[schemars(range(min = 1, max = 4096))]
    pub count: u32,
    /// Law of their lengths. Default: `geometric` with `ratio` or `first`, `tanh` with `stretch`, `uniform` without any
    /// of these.
    pub law: Option<CellLaw>,
    /// For `geometric`: length of each cell divided by that of the one before, counted from the fine end, from 0.001 to
    /// 1000.
    #[schemars(range(min = 0.001, max = 1000.0))]
    pub ratio: Option<f64>,
    /// For `tanh`: how uneven the cells are, from 0 (equal) to 20.
    #[schemars(range(min = 0.0, max = 20.0))]
    pub stretch: Option<f64>,
    /// Largest length of the cell at the fine end on any side of a block. The ratio or stretch follows from it.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub first: Option<f64>,
    /// The end of the direction at which cells are fine: `start` (default), `end` or `both`.
    #[serde(default)]
    pub fine: FineEnd,
}

/// Laws of the lengths of cells.
///
/// ```
/// use cyclide_io::document::kinds::CellLaw;
/// let law: CellLaw = serde_json::from_str(r#""tanh""#)?;
/// assert_eq!(law, CellLaw::Tanh);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum CellLaw {
    /// Equal cells.
    Uniform,
    /// A constant ratio between neighbors.
    Geometric,
    /// Hyperbolic tangents: the ratio between neighbors changes slowly.
    Tanh,
}

impl Builder<'_> {
    /// The parameters of the cells of blocks whose source divided them.
    pub(in crate::document) fn places_of_source(&mut self, volumes: &[CyclideVolume]) -> Result<Option<[Vec<f64>; 3]>> {
        let source = self.sources.first();
        let places = source.and_then(|source| source.provenance.places.clone());
        let laws = source.and_then(|source| Some(source.facts.cells()?.laws));
        if let Some((places, laws)) = places.as_ref().zip(laws) {
            let quality = self.check_cells(volumes, places, |_| vec![Step::from("of")])?;
            self.facts = Facts::Cells(CellFacts { laws, quality });
        }
        Ok(places)
    }

    /// The parameters of the cells of blocks, of an object that divides them.
    pub(in crate::document) fn places(
        &mut self,
        volumes: &[CyclideVolume],
        cells: Option<&CellsSpec>,
    ) -> Result<Option<[Vec<f64>; 3]>> {
        let along = match cells {
            None => return Ok(None),
            Some(CellsSpec::Count(count)) => [CellsAlongSpec::Count(*count); 3],
            Some(CellsSpec::Along(along)) => **along,
        };
        let mut places = [Vec::new(), Vec::new(), Vec::new()];
        let mut laws = [Grading::Uniform; 3];
        // One number for all directions stands alone.
        let alone = matches!(cells, Some(CellsSpec::Count(_)));
        let field = |axis: usize| place_of(axis).into_iter().take(if alone { 1 } else { 2 }).collect::<Vec<_>>();
        for (axis, (spec, places)) in along.iter().zip(&mut places).enumerate() {
            let (count, law) = match spec {
                CellsAlongSpec::Count(count) => (*count, Grading::Uniform),
                CellsAlongSpec::Graded(spec) => (spec.count, self.law(volumes, axis, spec)?),
            };
            laws[axis] = law;
            *places = law.places(count as usize).map_err(|e| self.refused_at(field(axis), &e))?;
        }
        StructuredGrid::check_size(volumes.len(), &places).map_err(|e| self.refused_at([Step::from("cells")], &e))?;
        let quality = self.check_cells(volumes, &places, field)?;
        self.facts = Facts::Cells(CellFacts { laws, quality });
        Ok(Some(places))
    }

    /// Refuses cells that are shorter than rounding, and gives the quality of the others, with what is to be said of it.
    fn check_cells(
        &mut self,
        volumes: &[CyclideVolume],
        places: &[Vec<f64>; 3],
        field: impl Fn(usize) -> Vec<Step>,
    ) -> Result<GridQuality> {
        for (axis, places) in places.iter().enumerate() {
            StructuredGrid::check_lengths(volumes, axis, places).map_err(|e| self.refused_at(field(axis), &e))?;
        }
        let made = StructuredGrid::new(volumes, places.clone());
        let grid = made.map_err(|e| self.refused_at(field(0).into_iter().take(1), &e))?;
        if grid.faces_apart() > 0 {
            let words = "cells along s and t must match and be symmetric where nets join around extraordinary vertices, since the s of one net is the t of another".to_owned();
            return Err(self.refused_in_words(field(0).into_iter().take(1), "cells-unfit", words));
        }
        let quality = grid.quality();
        let at = if self.kind.is_image() { "of" } else { "cells" };
        for warning in grid.warnings(&quality) {
            self.warn_at(at, None, warning);
        }
        Ok(quality)
    }

    /// The law of the cells along a direction.
    fn law(&self, volumes: &[CyclideVolume], axis: usize, spec: &GradedCellsSpec) -> Result<Grading> {
        let (count, fine) = (spec.count as usize, spec.fine);
        if count == 2 && fine == FineEnd::Both && spec.first.is_some() {
            let message =
                "two cells refined at both ends are equal: remove `first`, use more cells, or refine at one end";
            return Err(Error::Input(self.diagnostic(place_of(axis), message)));
        }
        if count == 1 && spec.first.is_some() {
            let message = "a single cell is as long as its block: remove `first`, or use more cells";
            return Err(Error::Input(self.diagnostic(place_of(axis), message)));
        }
        let refused = |e: cyclide::Error| self.refused_at(place_of(axis), &e);
        let by = |first: f64, law: fn(f64, usize, FineEnd) -> cyclide::Result<Grading>| {
            let share = share(volumes, axis, first, fine)?;
            // What is said of shares is meant of lengths.
            law(share, count, fine).map_err(|e| in_lengths(e, first / share))
        };
        match (spec.law, spec.ratio, spec.stretch, spec.first) {
            (None | Some(CellLaw::Uniform), None, None, None) => Ok(Grading::Uniform),
            (None | Some(CellLaw::Geometric), Some(ratio), None, None) => Ok(Grading::Geometric { ratio, fine }),
            (None | Some(CellLaw::Tanh), None, Some(stretch), None) => Ok(Grading::Tanh { stretch, fine }),
            (None | Some(CellLaw::Geometric), None, None, Some(first)) => {
                by(first, Grading::geometric_from_first).map_err(refused)
            }
            (Some(CellLaw::Tanh), None, None, Some(first)) => by(first, Grading::tanh_from_first).map_err(refused),
            _ => {
                let message = "graded cells require exactly one of `ratio` (law `geometric`), `stretch` (`tanh`) and `first` (either law); `uniform` allows none";
                Err(Error::Input(self.diagnostic(place_of(axis), message)))
            }
        }
    }
}

fn count_of<E: serde::de::Error>(count: u64) -> Result<u32, E> {
    u32::try_from(count).map_err(|_| E::custom(format!("{count} cells are too many")))
}

/// The share of a direction that a cell of this length has at the fine end, where sides are shortest at both.
fn share(volumes: &[CyclideVolume], axis: usize, first: f64, fine: FineEnd) -> cyclide::Result<f64> {
    let of = |at_end: bool| StructuredGrid::share_of_height(volumes, axis, at_end, first);
    match fine {
        FineEnd::Start => of(false),
        FineEnd::End => of(true),
        FineEnd::Both => Ok(of(false)?.min(of(true)?)),
    }
}

/// An error about the share of a first cell in units of length.
fn in_lengths(error: cyclide::Error, length: f64) -> cyclide::Error {
    match error {
        cyclide::Error::Number(NumberError::ParameterOutOfRange { name: ErrorItem::FirstCell, value, min, max }) => {
            let [value, min, max] = [value, min, max].map(|share| share * length);
            cyclide::Error::Number(NumberError::ParameterOutOfRange { name: ErrorItem::FirstCell, value, min, max })
        }
        other => other,
    }
}

fn place_of(axis: usize) -> [Step; 2] {
    [Step::from("cells"), Step::from(axis)]
}
