//! Rational cells of a file as curves, patches and volumes, and what they stand for.

use crate::check::bodies::{FilePatch, FileVolume};
use crate::check::file_content::FileContent;
use crate::check::made::Made;
use crate::check::rational_patches::patches_deviation;
use crate::check::rational_volumes::volume_deviation;
use crate::check::read_error::ReadError;
use crate::export::rational_cells::{RationalCell, Tags, block_of};
use crate::export::ready::ReadyModel;
use cyclide::{
    model::{ChainPiece, CurveChain},
    rational::{NurbsCurve, RationalBezierSurface, RationalBezierVolume},
};

/// Gap allowed between the pieces of a contour, relative to its largest coordinate: they share their end points.
const GAP: f64 = 1e-12;

/// Adds the faces and blocks of a file, each with its place for messages, to what it holds.
///
/// # Errors
/// [`ReadError::Geometry`], [`ReadError::Syntax`] (a weight is not positive).
pub(crate) fn add_bodies(
    content: &mut FileContent,
    cells: impl IntoIterator<Item = (String, RationalCell)>,
) -> Result<(), ReadError> {
    let (mut bodies, mut blocks) = (Vec::new(), Vec::new());
    for (place, cell) in cells {
        if !cell.nodes.iter().all(|(_, w)| *w > 0.0) {
            return Err(ReadError::syntax(place, "a weight is not positive"));
        }
        let key = (cell.tags.object, cell.tags.part);
        let [p, q, _] = cell.degrees;
        let geometry = |source| ReadError::Geometry { place, source };
        if cell.dimension() == 2 {
            let surface = RationalBezierSurface::new([p, q], cell.rows()).map_err(geometry)?;
            let body = number_of(&mut bodies, key);
            content.patches.push(FilePatch { body, shell: cell.tags.shell, outward: cell.tags.flag == 1, surface });
        } else {
            let volume = RationalBezierVolume::new(cell.degrees, cell.rows()).map_err(geometry)?;
            content.volumes.push(FileVolume { body: number_of(&mut blocks, key), volume });
        }
    }
    Ok(())
}

/// Adds the curves of a file: those that follow each other and belong to one contour are one chain.
///
/// # Errors
/// [`ReadError::Geometry`].
pub(crate) fn add_curves(
    content: &mut FileContent,
    curves: impl IntoIterator<Item = (Tags, NurbsCurve)>,
) -> Result<(), ReadError> {
    let mut contours: Vec<(Tags, Vec<ChainPiece>)> = Vec::new();
    for (tags, curve) in curves {
        match contours.last_mut() {
            Some((of, pieces)) if *of == tags => pieces.push(ChainPiece::Spline(curve)),
            _ => contours.push((tags, vec![ChainPiece::Spline(curve)])),
        }
    }
    for (number, (tags, pieces)) in contours.into_iter().enumerate() {
        let ends = pieces.iter().flat_map(|piece| [piece.start(), piece.end()]);
        let size = ends.map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let chain = CurveChain::new(pieces, tags.flag == 1, GAP * size);
        content.curves.push(chain.map_err(|source| ReadError::Geometry { place: format!("curve {number}"), source })?);
    }
    Ok(())
}

/// The number of a key among those that were met, in their order.
fn number_of(met: &mut Vec<(usize, usize)>, key: (usize, usize)) -> usize {
    if met.last() != Some(&key) {
        met.push(key);
    }
    met.len() - 1
}

/// How far the faces and blocks of a file, or those of the one dimension that it has, are from the bodies of the model.
///
/// # Errors
/// Those of [`patches_deviation`] and [`volume_deviation`].
pub(crate) fn bodies_deviation(
    made: &Made<'_>,
    content: &FileContent,
    only: Option<usize>,
) -> Result<Vec<f64>, ReadError> {
    let ReadyModel { model, bodies, .. } = made.ready;
    let written = &made.file.written;
    let (mut own, mut plans, mut deviations) = (Vec::new(), Vec::new(), vec![0.0; bodies.len()]);
    let mut first = 0;
    for (index, body) in bodies.iter().enumerate() {
        let parts = written.volumes.get(index).map_or(&[][..], Vec::as_slice);
        match block_of(model, body) {
            Some(block) if only.is_none_or(|d| d == 3) => {
                let read = content.volumes.get(first..first + parts.len());
                let read = read.ok_or(ReadError::Volume { volume: first, detail: "it is missing" })?;
                deviations[index] = volume_deviation(&block.right_handed(), parts, read, first)?;
                first += parts.len();
            }
            None if only.is_none_or(|d| d == 2) => {
                own.push(index);
                plans.extend(written.shells.get(index).cloned());
            }
            _ => {}
        }
    }
    if first != content.volumes.len() {
        return Err(ReadError::Volume { volume: first, detail: "the model has no further cells" });
    }
    let faces: Vec<_> = own.iter().map(|index| &bodies[*index]).collect();
    for (index, deviation) in own.iter().zip(patches_deviation(&faces, &plans, &content.patches)?) {
        deviations[*index] = deviation;
    }
    Ok(deviations)
}
