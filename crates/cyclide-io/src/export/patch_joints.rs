//! Sides that patches share: the same control points and weights, in the same order, to rounding.

use crate::export::rational_cells::Node;
use crate::export::spline_patches::SplinePatch;
use std::collections::HashMap;

/// Control points and weights that differ by less than this part of the largest coordinate, and of the weight, are one: they come from the same corners
/// by other ways of rounding.
const SAME: f64 = 1e-12;
/// Width of the cells in which sides are looked up, relative to the largest coordinate: far above [`SAME`], far below any side.
const CELL: f64 = 1e-9;

/// A side of a patch: its number, and the side's (`2 axis + end`).
pub(crate) type Side = (usize, usize);

/// Which sides of patches are shared.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Joints {
    /// Pairs of sides that are one, in the order of the first.
    pub(crate) pairs: Vec<[Side; 2]>,
    /// Sides whose corners are those of another side, and which are not joined: weights or parameters run otherwise there, or more than two meet.
    pub(crate) touching: usize,
}

impl Joints {
    /// Finds them. A side that is a point is none.
    pub(crate) fn of(patches: &[SplinePatch]) -> Self {
        let limit = same_limit(patches);
        let width = CELL / SAME * limit;
        let mut sides: Vec<(Side, [f64; 3])> = Vec::new();
        for (number, patch) in patches.iter().enumerate() {
            for side in 0..2 * patch.dimension() {
                let corners = corners_of_side(patch, side);
                if !is_a_point(&corners, limit) {
                    sides.push(((number, side), middle(&corners)));
                }
            }
        }
        // Those with one middle, which lie in one cell or in cells side by side.
        let mut partners: Vec<Vec<usize>> = vec![Vec::new(); sides.len()];
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
        for (index, ((patch, _), place)) in sides.iter().enumerate() {
            for cell in cells_near(*place, limit, width) {
                for &other in cells.get(&cell).into_iter().flatten() {
                    let (with, _) = sides[other].0;
                    let same = patches[with].dimension() == patches[*patch].dimension();
                    if same && with != *patch && apart(*place, sides[other].1) <= limit {
                        partners[index].push(other);
                        partners[other].push(index);
                    }
                }
            }
            cells.entry(cell_of(*place, width)).or_default().push(index);
        }
        let mut joints = Self::default();
        for (index, own) in partners.iter().enumerate() {
            let (side, _) = sides[index];
            match own.as_slice() {
                [] => {}
                [other] if partners[*other].len() == 1 && are_one(patches, side, sides[*other].0, limit) => {
                    if index < *other {
                        joints.pairs.push([side, sides[*other].0]);
                    }
                }
                _ => joints.touching += 1,
            }
        }
        joints
    }
}

/// The corners of a side, in binary order.
fn corners_of_side(patch: &SplinePatch, side: usize) -> Vec<[f64; 3]> {
    let (axis, end) = (side / 2, side % 2);
    let corners = patch.corners().enumerate().filter(|(corner, _)| corner >> axis & 1 == end);
    corners.map(|(_, (p, _))| p).collect()
}

/// True if all corners are one; the only corner of a side of a curve is a side all the same.
fn is_a_point(corners: &[[f64; 3]], limit: f64) -> bool {
    corners.len() > 1 && corners.iter().all(|p| apart(*p, corners[0]) <= limit)
}

fn middle(corners: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|axis| corners.iter().map(|p| p[axis]).sum::<f64>() / corners.len() as f64)
}

/// The largest difference of two coordinates.
fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| (a[axis] - b[axis]).abs()).fold(0.0, f64::max)
}

fn are_one(patches: &[SplinePatch], a: Side, b: Side, limit: f64) -> bool {
    let side = |(patch, side): Side| patches[patch].side(side);
    same_nodes(&side(a), &side(b), limit)
}

/// True if the lists are the same to rounding.
pub(crate) fn same_nodes(a: &[Node], b: &[Node], limit: f64) -> bool {
    let same = |((p, v), (q, w)): (&Node, &Node)| apart(*p, *q) <= limit && (v - w).abs() <= SAME * v.abs();
    a.len() == b.len() && a.iter().zip(b).all(same)
}

/// The largest distance of nodes that are one, for a list of patches.
pub(crate) fn same_limit(patches: &[SplinePatch]) -> f64 {
    let coordinates = patches.iter().flat_map(|patch| &patch.net.nodes).flat_map(|(p, _)| *p);
    SAME * coordinates.map(f64::abs).fold(f64::MIN_POSITIVE, f64::max)
}

fn cell_of(place: [f64; 3], width: f64) -> [i64; 3] {
    place.map(|x| (x / width).floor() as i64)
}

/// The cells that a place may be in when it is moved by the limit: mostly one.
fn cells_near(place: [f64; 3], limit: f64, width: f64) -> Vec<[i64; 3]> {
    let (low, high) = (cell_of(place.map(|x| x - limit), width), cell_of(place.map(|x| x + limit), width));
    let corner = |k: usize| std::array::from_fn(|axis| if k >> axis & 1 == 0 { low[axis] } else { high[axis] });
    let mut cells: Vec<[i64; 3]> = (0..8).map(corner).collect();
    cells.sort_unstable();
    cells.dedup();
    cells
}
