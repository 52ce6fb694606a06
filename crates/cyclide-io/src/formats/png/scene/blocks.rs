//! Blocks as the picture sees them: what is left of them when a part is cut away, each family of coordinate surfaces in its color.

use super::surface::{CIRCLE, CIRCLE_INK, EDGE, EDGE_INK, Lines, PLACE_INK, Surface};
use crate::drawing::block_directions::others;
use crate::drawing::cut_away::CutAway;
use crate::drawing::palette::{family, to_linear};
use crate::drawing::parameter_circles::{Planes, halvings};
use crate::export::error::ExportError;
use crate::export::job::Job;
use crate::export::shape::Shape;
use cyclide::{
    Point3, Vec3,
    topology::{BlockShell, Body},
    volume::StructuredGrid,
};

/// Points of all blocks of an object that the view is fitted to, about, and divisions of a block at most.
const POINTS: f64 = 40_000.0;
const DIVISIONS: f64 = 16.0;
/// Distance of the lines on blocks without cells, about, pixels: three families of them are seen together.
const SPACING: f64 = 48.0;
/// Edges between two families are so much wider than those between blocks.
const SHARP: f64 = 1.4;

/// The blocks of an object.
pub(super) struct Blocks {
    /// Which of the objects.
    pub(super) item: usize,
    /// What is left of them.
    pub(super) cut: CutAway,
    /// The shells of it.
    pub(super) shapes: Vec<Shape<'static>>,
    /// The parameters at which the cells of each block end, if they are divided.
    places: Option<[Vec<f64>; 3]>,
}

/// Points on all blocks of a model.
pub(super) fn points(job: &Job<'_>) -> Result<Vec<Point3>, ExportError> {
    let mut points = Vec::new();
    for item in job.model.items.iter().filter(|item| !item.volumes().is_empty()) {
        let count = (POINTS / item.volumes().len() as f64).cbrt().clamp(1.0, DIVISIONS) as usize;
        let places: Vec<f64> = (0..=count).map(|k| k as f64 / count as f64).collect();
        let grid = StructuredGrid::new(item.volumes(), [places.clone(), places.clone(), places]);
        let unfit = |source| ExportError::Surface { object: item.name.clone(), surface: 0, source };
        points.extend_from_slice(grid.map_err(unfit)?.nodes());
    }
    Ok(points)
}

/// The blocks of all objects, cut away towards the eye.
pub(super) fn blocks(job: &Job<'_>, toward: Vec3) -> Result<Vec<Blocks>, ExportError> {
    let mut all = Vec::new();
    for (index, item) in job.model.items.iter().enumerate().filter(|(_, item)| !item.volumes().is_empty()) {
        let places = job.provenances.places(index);
        let unfit = |source| ExportError::Surface { object: item.name.clone(), surface: 0, source };
        // Blocks that do not fit together as shells are drawn one by one.
        let cut = CutAway::new(item.volumes(), places, toward)
            .or_else(|_| CutAway::of_single_blocks(item.volumes()))
            .map_err(unfit)?;
        let body = |shell: &BlockShell| Body { outer: shell.shell.clone(), voids: Vec::new() };
        let shapes = cut.shells.iter().map(|shell| body(shell).into()).collect();
        all.push(Blocks { item: index, cut, shapes, places: places.cloned() });
    }
    Ok(all)
}

impl Blocks {
    /// What was refused of them.
    pub(super) fn unfit(&self, job: &Job<'_>, source: cyclide::Error) -> ExportError {
        ExportError::Surface { object: job.model.items[self.item].name.clone(), surface: 0, source }
    }

    /// The faces of a shell for the picture, as [`surfaces`](super::surface::surfaces) of others.
    pub(super) fn surfaces<'a>(
        &'a self,
        shell: &'a BlockShell,
        unit: f64,
        scale: f64,
    ) -> impl Iterator<Item = Surface<'a>> {
        let levels = match self.places {
            Some(_) => vec![[0; 2]; shell.faces.len()],
            None => halvings(&shell.shell, SPACING * scale * unit, Planes::Lined),
        };
        let along = shell.shell.faces_along_edges();
        // Where a block is cut its faces have a line as between cells.
        let inner = if self.places.is_some() { PLACE_INK } else { CIRCLE_INK };
        let edge = move |edge: usize| {
            let &[(a, _), (b, _)] = along[edge].as_slice() else { return (SHARP * EDGE * scale, EDGE_INK) };
            let (a, b) = (shell.faces[a], shell.faces[b]);
            match (a.axis == b.axis, a.block == b.block) {
                (false, _) => (SHARP * EDGE * scale, EDGE_INK),
                (true, false) => (EDGE * scale, EDGE_INK),
                (true, true) => (CIRCLE * scale, inner),
            }
        };
        shell.shell.faces().iter().zip(&shell.faces).zip(levels).map(move |((face, at), levels)| {
            let [tint, ink] = family(at.axis).map(to_linear);
            let directions = others(at.axis);
            let lines = [0, 1].map(|k| match &self.places {
                None => Lines::Halvings(levels[k]),
                Some(places) => {
                    let [from, to] = at.ranges[k];
                    let inside = places[directions[k]].iter().filter(|x| from < **x && **x < to);
                    Lines::Places(inside.map(|x| (x - from) / (to - from)).collect())
                }
            });
            Surface {
                surface: &face.surface,
                lines,
                sides: face.sides.map(|side| side.map_or((0.0, 0.0), |side| edge(side.edge))),
                outer: face.outer_sign(),
                bend: face.outer_sign_of_unit_normal(),
                tint,
                inner_tint: tint,
                ink,
                scale,
            }
        })
    }
}
