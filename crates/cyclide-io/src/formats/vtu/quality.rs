//! How good the cells of blocks are, as solvers ask: right angles, their Jacobian, and how long they are.

use crate::export::parts::BodyOf;
use crate::export::rational_cells::block_of;
use cyclide::{Vec3, model::Model, volume::CyclideVolume};

/// Names of the numbers.
pub(super) const NAMES: [&str; 5] = ["orthogonality", "scaled_jacobian", "aspect_ratio", "shortest_side", "jacobian"];

/// The numbers of a cell.
pub(super) type Quality = [f64; NAMES.len()];

/// Places along each parameter of a cell, its ends among them.
const PLACES: usize = 3;

/// The quality of all parts of blocks, in file order: the largest cosine between parameter lines, the least Jacobian over the product of the lengths of
/// the three derivatives (1 where lines cross at right angles, negative beyond a fold), the largest ratio of two of these lengths at one place, the length of
/// the shortest side that is no point (0 if all are), and the least Jacobian by the parameters of the block. Places where a line is one point are left out of
/// the second and third, as of plain cells; where all are, they are 0 and 1.
pub(super) fn qualities(model: &Model, bodies: &[BodyOf<'_>], parts: &[Vec<[[f64; 2]; 3]>]) -> Vec<Quality> {
    let of_body = |(body, parts): (&BodyOf<'_>, &Vec<[[f64; 2]; 3]>)| {
        let block = block_of(model, body).map(CyclideVolume::right_handed);
        parts.iter().filter_map(|part| block.map(|block| quality(&block, part))).collect::<Vec<_>>()
    };
    bodies.iter().zip(parts).flat_map(of_body).collect()
}

fn quality(block: &CyclideVolume, part: &[[f64; 2]; 3]) -> Quality {
    let step = |k: usize| k as f64 / (PLACES - 1) as f64;
    let mut found = [0.0_f64, f64::INFINITY, 1.0_f64, shortest_side(block, part), f64::INFINITY];
    for k in 0..PLACES.pow(3) {
        let own = [step(k % PLACES), step(k / PLACES % PLACES), step(k / PLACES / PLACES)];
        let at = std::array::from_fn(|axis| part[axis][0] + (part[axis][1] - part[axis][0]) * own[axis]);
        let metric = block.metric(at);
        found[0] = found[0].max(metric.orthogonality());
        found[4] = found[4].min(metric.determinant());
        if metric.standing.contains(&true) {
            continue;
        }
        let sides: [Vec3; 3] = std::array::from_fn(|axis| metric.first[axis] * (part[axis][1] - part[axis][0]));
        let lengths = sides.map(Vec3::length);
        let (least, most) = lengths.iter().fold((f64::INFINITY, 0.0_f64), |(lo, hi), v| (lo.min(*v), hi.max(*v)));
        let scaled = match sides.map(|side| side.unit()) {
            [Some(a), Some(b), Some(c)] => a.cross(b).dot(c),
            _ => 0.0,
        };
        let ratio = if least > 0.0 { (most / least).min(f64::MAX) } else { f64::MAX };
        (found[1], found[2]) = (found[1].min(scaled), found[2].max(ratio));
    }
    if found[1].is_infinite() {
        found[1] = 0.0;
    }
    // Numbers of a file are finite.
    found.map(|v| if v.is_finite() { v } else { f64::MAX })
}

/// The shortest side of a part of a block that is no point; 0 if all are.
fn shortest_side(block: &CyclideVolume, part: &[[f64; 2]; 3]) -> f64 {
    let ends = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let Ok(part) = block.restricted(*part) else { return 0.0 };
    let sides = (0..3).flat_map(|axis| ends.map(|at| part.line(axis, at)));
    let lengths = sides.filter_map(|side| side.ok().map(|arc| arc.length())).filter(|length| *length > 0.0);
    let shortest = lengths.fold(f64::INFINITY, f64::min);
    if shortest.is_finite() { shortest } else { 0.0 }
}
