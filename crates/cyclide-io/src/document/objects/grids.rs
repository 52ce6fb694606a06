//! Grids of blocks, and the places of their cells.

use cyclide::{CyclideGrid, CyclideVolume, DupinCyclide, ErrorItem, FineEnd, Grading, StructuredGrid};

use super::Builder;
use super::nets::{SEGMENTS, frame_of_axes};
use super::volumes::volume_frame;
use crate::document::coordinates::Coordinates;
use crate::document::locate::Step;
use crate::document::spec::{
    CellLaw, CellsAlongSpec, CellsSpec, CoordinatePlanesSpec, CyclideGridSpec, FrameSpec, GradedCellsSpec,
    WholeCyclideSpec,
};
use crate::error::{Error, Result};

/// With `mu` less below `c` than this part of `a` a cyclide has one node.
const ONE_NODE: f64 = 1e-12;
/// Points of two planes that are one may be so far apart, relative to the size of the grid.
const ONE_POINT: f64 = 1e-9;

impl Builder<'_> {
    /// The blocks of a grid.
    pub(in crate::document) fn cyclide_grid(&self, spec: &CyclideGridSpec) -> Result<Vec<CyclideVolume>> {
        let grid = match (&spec.planes, &spec.whole) {
            (Some(planes), None) => self.grid_of_planes(planes, spec.frame.unwrap_or_default())?,
            (None, Some(whole)) if spec.frame.is_none() => self.grid_of_cyclide(whole)?,
            (None, Some(_)) => return Err(self.unfit("`frame` goes with `planes`: a cyclide has its own")),
            _ => return Err(self.unfit("give either `planes` or `whole`")),
        };
        Ok(grid.blocks().collect())
    }

    fn grid_of_cyclide(&self, spec: &WholeCyclideSpec) -> Result<CyclideGrid> {
        let mu = spec.mu.as_slice();
        let [first, .., outer] = *mu else {
            return Err(self.unfit("`mu` of `whole` has the radii of two tubes at least"));
        };
        let place = |k: usize| [Step::from("whole"), Step::from("mu"), Step::from(k)];
        if let Some(k) = (1..mu.len()).find(|&k| !(mu[k] > mu[k - 1])) {
            let error = cyclide::Error::ParametersNotIncreasing { index: k, value: mu[k], before: mu[k - 1] };
            return Err(self.refused_at(place(k), &error));
        }
        // Outwards the outer part of a horn gets longer: what is common to all is that of the first. That of a spindle gets shorter.
        let of_horn = spec.c - first > ONE_NODE * spec.a;
        let base = if of_horn { first } else { outer };
        let made = || {
            let frame = frame_of_axes(spec.center, spec.axis, spec.x_direction)?;
            let segments = spec.segments.unwrap_or(SEGMENTS).map(|n| n as usize);
            let cyclide = DupinCyclide::new(spec.a, spec.c, base)?.placed(frame);
            let distances: Vec<f64> = mu.iter().map(|mu| mu - base).collect();
            CyclideGrid::of_cyclide(&cyclide, segments, &distances)
        };
        made().map_err(|e| {
            let Some(distance) = folding_offset(&e) else { return self.refused_at([Step::from("whole")], &e) };
            let off = |k: &usize| (mu[*k] - base - distance).abs();
            let k = (0..mu.len()).min_by(|j, k| off(j).total_cmp(&off(k))).unwrap_or_default();
            let words = format!(
                "mu = {}: between it and mu = {base} are centres of curvature, at which blocks would fold; they lie at mu from 0 to c = {} and from a = {} on",
                mu[k], spec.c, spec.a
            );
            self.refused_in_words(place(k), e.reason(), words)
        })
    }

    fn grid_of_planes(&self, planes: &CoordinatePlanesSpec, frame: FrameSpec) -> Result<CyclideGrid> {
        let (st, su, tu) = (&planes.st, &planes.su, &planes.tu);
        let columns = |rows: &[Vec<Coordinates>]| rows.first().map_or(0, Vec::len);
        let [m, n, l] = [columns(st), st.len(), su.len()];
        for (name, rows, wanted) in [("st", st, [m, n]), ("su", su, [m, l]), ("tu", tu, [n, l])] {
            let odd = rows.iter().position(|row| row.len() != wanted[0]);
            if odd.is_some() || rows.len() != wanted[1] {
                let row = odd.unwrap_or(0);
                let message = format!(
                    "the planes have {m} points along s, {n} along t and {l} along u: `{name}` has {} rows, row {row} of {} points",
                    rows.len(),
                    rows.get(row).map_or(0, Vec::len),
                );
                return Err(Error::Input(self.diagnostic(["planes".into(), name.into()], &message)));
            }
        }
        if [m, n, l].contains(&0) {
            return Err(self.unfit("the planes have no points"));
        }
        // Lines that are of two planes.
        let first = st[0][0].point();
        let all = [st, su, tu].into_iter().flatten().flatten();
        let size = all.map(|p| p.point().distance(first)).fold(0.0, f64::max);
        let along_s = st[0].iter().zip(&su[0]).enumerate().map(|(i, (p, q))| ("su", 0, i, p, q, "st"));
        let along_t = st.iter().zip(&tu[0]).enumerate().map(|(j, (row, q))| ("tu", 0, j, &row[0], q, "st"));
        let along_u = su.iter().zip(tu).enumerate().map(|(k, (p, q))| ("tu", k, 0, &p[0], &q[0], "su"));
        for (name, row, column, wanted, given, of) in along_s.chain(along_t).chain(along_u) {
            let distance = given.point().distance(wanted.point());
            if !(distance <= ONE_POINT * size) {
                let message = format!("this point is {distance:.3e} from that of `{of}`, with which it is one");
                let place = ["planes".into(), name.into(), row.into(), column.into()];
                return Err(self.refused_in_words(place, "not-concircular", message));
            }
        }
        let point = |[i, j, k]: [usize; 3]| match [i, j, k] {
            [i, j, 0] => st[j][i].point(),
            [i, 0, k] => su[k][i].point(),
            [_, j, k] => tu[k][j].point(),
        };
        let size = [m, n, l].map(|points| points.saturating_sub(1));
        let made = CyclideGrid::from_coordinate_planes(size, point, volume_frame(frame));
        made.map_err(|e| self.refused_frame(frame, &e).unwrap_or_else(|| self.refused_at([Step::from("planes")], &e)))
    }

    /// The parameters of the cells of blocks whose source divided them.
    pub(in crate::document) fn places_of_source(&mut self, volumes: &[CyclideVolume]) -> Result<Option<[Vec<f64>; 3]>> {
        self.gradings = self.sources.first().and_then(|source| source.gradings);
        let places = self.sources.first().and_then(|source| source.provenance.places.clone());
        if let Some(places) = &places {
            self.check_cells(volumes, places, |_| vec![Step::from("of")])?;
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
        self.gradings = Some(laws);
        self.check_cells(volumes, &places, field)?;
        Ok(Some(places))
    }

    /// Refuses cells that are shorter than rounding, and keeps the quality of the others, with what is to be said of it.
    fn check_cells(
        &mut self,
        volumes: &[CyclideVolume],
        places: &[Vec<f64>; 3],
        field: impl Fn(usize) -> Vec<Step>,
    ) -> Result<()> {
        for (axis, places) in places.iter().enumerate() {
            StructuredGrid::check_lengths(volumes, axis, places).map_err(|e| self.refused_at(field(axis), &e))?;
        }
        let made = StructuredGrid::new(volumes, places.clone());
        let grid = made.map_err(|e| self.refused_at(field(0).into_iter().take(1), &e))?;
        if grid.faces_apart() > 0 {
            let words = "cells along s and t have the same places, seen from both ends, where nets join round extraordinary vertices: the s of one is the t of another".to_owned();
            return Err(self.refused_in_words(field(0).into_iter().take(1), "cells-unfit", words));
        }
        let quality = grid.quality();
        let at = if self.spec.kind().is_image() { "of" } else { "cells" };
        for warning in grid.warnings(&quality) {
            self.warn_at(at, None, warning);
        }
        self.quality = Some(quality);
        Ok(())
    }

    /// The law of the cells along a direction.
    fn law(&self, volumes: &[CyclideVolume], axis: usize, spec: &GradedCellsSpec) -> Result<Grading> {
        let (count, fine) = (spec.count as usize, spec.fine);
        if count == 2 && fine == FineEnd::Both && spec.first.is_some() {
            let message = "two cells that are fine at both ends are equal: leave out `first`, give more cells, or let one end be fine";
            return Err(Error::Input(self.diagnostic(place_of(axis), message)));
        }
        if count == 1 && spec.first.is_some() {
            let message = "one cell is as long as its block: leave out `first`, or give more cells";
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
                let message = "of graded cells give one of `ratio` (law `geometric`), `stretch` (`tanh`) and `first` (either); `uniform` has none";
                Err(Error::Input(self.diagnostic(place_of(axis), message)))
            }
        }
    }
}

/// The distance of an offset that is refused since layers fold there.
fn folding_offset(error: &cyclide::Error) -> Option<f64> {
    match error {
        cyclide::Error::InQuad { cause, .. } => folding_offset(cause),
        cyclide::Error::OffsetNotRegular { distance, .. } => Some(*distance),
        _ => None,
    }
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
        cyclide::Error::ParameterOutOfRange { name: ErrorItem::FirstCell, value, min, max } => {
            let [value, min, max] = [value, min, max].map(|share| share * length);
            cyclide::Error::ParameterOutOfRange { name: ErrorItem::FirstCell, value, min, max }
        }
        other => other,
    }
}

fn place_of(axis: usize) -> [Step; 2] {
    [Step::from("cells"), Step::from(axis)]
}
