//! Curves, faces and blocks as rational Bézier cells with positive weights: what formats of exact cells and patches hold.

use crate::export::error::ExportError;
use crate::export::exported::{Promise, Written};
use crate::export::face_plan::ShellPlan;
use crate::export::job::Job;
use crate::export::parts::BodyOf;
use crate::export::scaled_weights::scaled_weights;
use cyclide::{
    error::{NumberError, VolumeError},
    model::{Item, Model},
    rational::{RationalBezier, RationalBezierSurface, RationalBezierVolume},
    topology::{CutShell, FaceGeometry as _, Shell},
    volume::CyclideVolume,
};

/// A cell's degrees along its parameters; the third is 0 of a face, the last two of a curve.
pub(crate) type Degrees = [usize; 3];

/// A control point and its weight.
pub(crate) type Node = ([f64; 3], f64);

/// Parts of all blocks of an object at most, where all are cut alike: some two kilobytes of text each.
const MOST_PARTS: usize = 1 << 17;

/// Largest number among the tags of a file that is read: sums and small multiples of it do not overflow.
pub(crate) const MOST_TAG: usize = 1 << 24;

/// What a cell belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Tags {
    /// The object, from 0, in the model's order.
    pub(crate) object: usize,
    /// Which of its contours or bodies.
    pub(crate) part: usize,
    /// Of a face, which shell of the body.
    pub(crate) shell: usize,
    /// Of a curve 1 if its contour is closed; of a face 1 if the outer side is that of `f_s × f_t`; of a block 1.
    pub(crate) flag: usize,
}

/// A net of control points with weights over one, two or three parameters, and what it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RationalCell {
    /// Control points less one along each parameter.
    pub(crate) degrees: Degrees,
    /// The control points, the last parameter fastest.
    pub(crate) nodes: Vec<Node>,
    pub(crate) tags: Tags,
}

impl RationalCell {
    /// The cell of homogeneous rows with positive weights.
    pub(crate) fn of_rows(degrees: Degrees, rows: &[[f64; 4]], tags: Tags) -> Self {
        Self { degrees, nodes: rows.iter().map(|[x, y, z, w]| ([x / w, y / w, z / w], *w)).collect(), tags }
    }

    pub(crate) fn of_curve(span: &RationalBezier, tags: Tags) -> Self {
        Self::of_rows([span.degree(), 0, 0], span.rows(), tags)
    }

    fn of_surface(surface: &RationalBezierSurface, tags: Tags) -> Self {
        let [p, q] = surface.degrees();
        Self::of_rows([p, q, 0], surface.rows(), tags)
    }

    fn of_volume(volume: &RationalBezierVolume, tags: Tags) -> Self {
        Self::of_rows(volume.degrees(), volume.rows(), tags)
    }

    /// The same points with weights of which the largest is in [1, 2).
    pub(crate) fn with_scaled_weights(mut self) -> Self {
        let weights: Vec<f64> = self.nodes.iter().map(|(_, w)| *w).collect();
        self.nodes.iter_mut().zip(scaled_weights(&weights)).for_each(|((_, w), scaled)| *w = scaled);
        self
    }

    /// How many parameters it has.
    pub(crate) fn dimension(&self) -> usize {
        self.degrees.iter().filter(|degree| **degree > 0).count()
    }

    /// The control point of these indices.
    pub(crate) fn node(&self, at: [usize; 3]) -> Node {
        self.nodes[self.index(at)]
    }

    /// The place of these indices in the list of nodes.
    pub(crate) fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        let [_, q, r] = self.degrees;
        (i * (q + 1) + j) * (r + 1) + k
    }

    /// The homogeneous rows, the last parameter fastest.
    pub(crate) fn rows(&self) -> Vec<[f64; 4]> {
        self.nodes.iter().map(|([x, y, z], w)| [x * w, y * w, z * w, *w]).collect()
    }

    /// The indices of all control points, the first parameter fastest.
    pub(crate) fn first_fastest(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [p, q, r] = self.degrees;
        (0..=r).flat_map(move |k| (0..=q).flat_map(move |j| (0..=p).map(move |i| [i, j, k])))
    }
}

/// How blocks are cut that have no positive weights as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Halving {
    /// Each as often as it needs.
    WhereNeeded,
    /// All blocks of an object alike, through all of them, so that their parts share whole faces.
    Evenly,
}

/// The block whose body it is, if it is one's.
pub(crate) fn block_of<'a>(model: &'a Model, body: &BodyOf<'_>) -> Option<&'a CyclideVolume> {
    model.items.get(body.item)?.volumes().get(body.surface)
}

/// Adds the faces and blocks of a model, or only those of a dimension, and notes what they stand for.
///
/// # Errors
/// [`ExportError::Surface`].
pub(crate) fn push_bodies(
    job: &Job<'_>,
    only: Option<usize>,
    halving: Halving,
    cells: &mut Vec<RationalCell>,
    written: &mut Written,
) -> Result<(), ExportError> {
    let cuts = match halving {
        Halving::WhereNeeded => Vec::new(),
        Halving::Evenly => job.model.items.iter().map(even_cuts).collect::<Result<Vec<_>, _>>()?,
    };
    for body in job.bodies {
        let (mut shells, mut volumes) = (Vec::new(), Vec::new());
        match block_of(job.model, body) {
            Some(block) if only.is_none_or(|d| d == 3) => {
                let ends = match halving {
                    Halving::WhereNeeded => cells_of(job, body),
                    Halving::Evenly => cuts.get(body.item).cloned(),
                };
                let pushed = push_block(cells, body, block, ends.unwrap_or(WHOLE.map(Vec::from)));
                volumes = pushed.map_err(|source| body.unfit(source))?;
            }
            None if only.is_none_or(|d| d == 2) => {
                shells = push_faces(cells, body).map_err(|source| body.unfit(source))?;
            }
            _ => {}
        }
        written.shells.push(shells);
        written.volumes.push(volumes);
        written.bodies.push(Promise::EXACT);
    }
    Ok(())
}

fn push_faces(cells: &mut Vec<RationalCell>, body: &BodyOf<'_>) -> cyclide::Result<Vec<ShellPlan>> {
    let mut plans = Vec::new();
    for (index, shell) in body.body.shells().enumerate() {
        let cut = CutShell::from(Shell::clone(shell)).with_positive_weights()?;
        for face in cut.shell().faces() {
            let flag = usize::from(face.same_sense);
            let tags = Tags { object: body.item, part: body.index, shell: index, flag };
            cells.push(RationalCell::of_surface(&face.surface.to_rational(), tags));
        }
        plans.push(ShellPlan::of_parts(index, cut.parts()));
    }
    Ok(plans)
}

/// The parameters along s, t and u at which the cells of a block end, as those of the [right-handed](CyclideVolume::right_handed) one: none of a block
/// that is not divided.
pub(crate) fn cells_of(job: &Job<'_>, body: &BodyOf<'_>) -> Option<[Vec<f64>; 3]> {
    let block = block_of(job.model, body)?;
    let [s, t, u] = job.provenances.places(body.item)?.clone();
    Some(if block.is_right_handed() { [s, t, u] } else { [t, s, u] })
}

/// The ends of a block that is not divided.
const WHOLE: [[f64; 2]; 3] = [[0.0, 1.0]; 3];

/// Adds a block, right-handed, between these parameters, in parts with positive weights.
fn push_block(
    cells: &mut Vec<RationalCell>,
    body: &BodyOf<'_>,
    block: &CyclideVolume,
    ends: [Vec<f64>; 3],
) -> cyclide::Result<Vec<[[f64; 2]; 3]>> {
    let tags = Tags { object: body.item, part: body.index, shell: 0, flag: 1 };
    let right_handed = block.right_handed();
    let mut parts = Vec::new();
    for cell in boxes_between(&ends) {
        let in_block = |own: [f64; 3]| std::array::from_fn(|axis| between(cell[axis], own[axis]));
        // Places are told as those of the block as it is.
        let told = |error| match error {
            cyclide::Error::Volume(VolumeError::ThroughInfinity { at }) => {
                let [s, t, u] = in_block(at);
                let at = if block.is_right_handed() { [s, t, u] } else { [t, s, u] };
                cyclide::Error::Volume(VolumeError::ThroughInfinity { at })
            }
            other => other,
        };
        let own_parts = right_handed.restricted(cell).and_then(|part| part.to_rational_parts()).map_err(told)?;
        for (own, part) in own_parts {
            cells.push(RationalCell::of_volume(&part, tags));
            let [from, to] = [0, 1].map(|end| in_block(own.map(|range| range[end])));
            parts.push(std::array::from_fn(|axis| [from[axis], to[axis]]));
        }
    }
    Ok(parts)
}

/// The place of a share of a range: its ends exactly.
fn between([a, b]: [f64; 2], share: f64) -> f64 {
    if share < 1.0 { a + (b - a) * share } else { b }
}

/// The boxes between rising parameters along s, t and u, s fastest.
pub(crate) fn boxes_between(ends: &[Vec<f64>; 3]) -> impl Iterator<Item = [[f64; 2]; 3]> {
    let [m, n, l] = ends.each_ref().map(|ends| ends.len() - 1);
    let range = |axis: usize, k: usize| [ends[axis][k], ends[axis][k + 1]];
    (0..m * n * l).map(move |k| [range(0, k % m), range(1, k / m % n), range(2, k / (m * n))])
}

/// The parameters along s, t and u at which all blocks of an object, as right-handed ones, are cut so that every part has positive weights: in halves, and
/// halves of these, through all of a block and all blocks, wherever one part of one needs it. So parts share whole faces.
///
/// # Errors
/// [`ExportError::Surface`] with `too-many-pieces`.
fn even_cuts(item: &Item) -> Result<[Vec<f64>; 3], ExportError> {
    let blocks = item.volumes();
    let mut cuts = WHOLE.map(Vec::from);
    loop {
        let mut more = [Vec::new(), Vec::new(), Vec::new()];
        for block in blocks {
            let block = block.right_handed();
            for part in boxes_between(&cuts) {
                if !block.restricted(part).is_ok_and(|part| part.to_rational().has_positive_weights()) {
                    more.iter_mut().zip(part).for_each(|(more, [from, to])| more.push(0.5 * (from + to)));
                }
            }
        }
        if more.iter().all(Vec::is_empty) {
            return Ok(cuts);
        }
        for (cuts, more) in cuts.iter_mut().zip(&mut more) {
            cuts.append(more);
            cuts.sort_by(f64::total_cmp);
            cuts.dedup();
        }
        let parts = cuts.iter().map(|cuts| (cuts.len() - 1) as f64).product::<f64>() * blocks.len() as f64;
        if parts > MOST_PARTS as f64 {
            let source = cyclide::Error::Number(NumberError::TooManyPieces {
                what: "the conforming grid of parts with positive weights",
                segment: None,
                needed: parts,
                cap: MOST_PARTS,
                remedy: "move the block farther from infinity, or write VTU or STEP",
            });
            return Err(ExportError::Surface { object: item.name.clone(), surface: 0, source });
        }
    }
}
