//! Curves, faces and blocks as rational Bézier cells with positive weights: what formats of exact cells and patches hold.

use crate::export::error::ExportError;
use crate::export::exported::{Promise, Written};
use crate::export::face_plan::ShellPlan;
use crate::export::job::Job;
use crate::export::parts::BodyOf;
use cyclide::{
    CutShell, CyclideVolume, FaceGeometry as _, Model, RationalBezier, RationalBezierSurface, RationalBezierVolume,
    Shell,
};

/// A cell's degrees along its parameters; the third is 0 of a face, the last two of a curve.
pub(crate) type Degrees = [usize; 3];

/// A control point and its weight.
pub(crate) type Node = ([f64; 3], f64);

/// Blocks of one object are halved at most this often where all are halved alike.
const MOST_HALVINGS: u32 = 4;

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
    /// All blocks of an object alike, so that their parts share whole faces.
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
    let depths: Vec<Option<u32>> = job.model.items.iter().map(|item| even_depth(item.volumes(), halving)).collect();
    for body in job.bodies {
        let (mut shells, mut volumes) = (Vec::new(), Vec::new());
        match block_of(job.model, body) {
            Some(block) if only.is_none_or(|d| d == 3) => {
                let division = match halving {
                    Halving::WhereNeeded => Division::Cells(cells_of(job, body)),
                    Halving::Evenly => Division::Halves(depths.get(body.item).copied().flatten()),
                };
                let pushed = push_block(cells, body, block, division);
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
        plans.push(ShellPlan { shell: index, faces: cut.parts().to_vec() });
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

/// Into which parts a block goes.
enum Division {
    /// Its cells, if it has some, each with as many halvings as it needs.
    Cells(Option<[Vec<f64>; 3]>),
    /// All of one depth; without one, as many as it needs.
    Halves(Option<u32>),
}

/// Adds a block, right-handed, in parts with positive weights.
fn push_block(
    cells: &mut Vec<RationalCell>,
    body: &BodyOf<'_>,
    block: &CyclideVolume,
    division: Division,
) -> cyclide::Result<Vec<[[f64; 2]; 3]>> {
    let tags = Tags { object: body.item, part: body.index, shell: 0, flag: 1 };
    let block = block.right_handed();
    let mut parts = Vec::new();
    let mut push = |place, part: &RationalBezierVolume| {
        cells.push(RationalCell::of_volume(part, tags));
        parts.push(place);
    };
    match division {
        Division::Halves(Some(depth)) => {
            for place in octants(depth) {
                push(place, &block.restricted(place)?.to_rational());
            }
        }
        Division::Halves(None) | Division::Cells(None) => {
            block.to_rational_parts()?.iter().for_each(|(place, part)| push(*place, part));
        }
        Division::Cells(Some(ends)) => {
            for cell in boxes_between(&ends) {
                for (own, part) in block.restricted(cell)?.to_rational_parts()? {
                    push(std::array::from_fn(|axis| own[axis].map(|x| between(cell[axis], x))), &part);
                }
            }
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

/// How often all blocks are to be halved so that every part has positive weights.
fn even_depth(blocks: &[CyclideVolume], halving: Halving) -> Option<u32> {
    let is_positive = |block: &CyclideVolume, place| {
        block.restricted(place).is_ok_and(|part| part.to_rational().has_positive_weights())
    };
    let suffices = |depth: &u32| blocks.iter().all(|block| octants(*depth).all(|place| is_positive(block, place)));
    (halving == Halving::Evenly && !blocks.is_empty()).then(|| (0..=MOST_HALVINGS).find(suffices)).flatten()
}

/// The places of the parts of a block that was halved so often in all directions, s fastest.
fn octants(depth: u32) -> impl Iterator<Item = [[f64; 2]; 3]> {
    let n = 1_usize << depth;
    let range = move |k: usize| [k as f64 / n as f64, (k + 1) as f64 / n as f64];
    (0..n.pow(3)).map(move |k| [range(k % n), range(k / n % n), range(k / n / n)])
}
