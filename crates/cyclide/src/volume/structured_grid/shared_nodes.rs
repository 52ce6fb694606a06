//! Nodes that neighbouring blocks have in common: corners bit for bit, and between common corners the nodes of sides and faces.
//!
//! A side is known by its direction and its two corners, a face by the direction across and its four, in order: two blocks that have them
//! run over them with the same parameters, if they are the same at all. Two arcs may have the same ends (a ring of two blocks), so a place inside is
//! compared as well, within the rounding that blocks differ by. A side that is one point has one node, a face that is a line (of a wedge, as at the pole of
//! a sphere) those of a side.

use crate::base::vector::Point3;
use crate::volume::ParamVolume as _;
use crate::volume::cyclide_volume::CyclideVolume;
use std::collections::HashMap;

/// Where sides and faces are compared: no place that symmetry makes the same, as it does insides.
const INSIDE: [f64; 2] = [0.37, 0.61];
/// Places on what two blocks share are at most so far apart, relative to the larger block, and in roundings of the coordinates.
const SAME: f64 = 1e-9;
const ROUNDINGS: f64 = 64.0;

/// Where the nodes inside a side or a face stand.
#[derive(Clone, Copy)]
enum Run {
    /// One after the other from here.
    From(u32),
    /// All in one: of a side of one point.
    One(u32),
}

impl Run {
    fn node(self, k: usize) -> u32 {
        match self {
            Self::From(first) => first + k as u32,
            Self::One(node) => node,
        }
    }
}

/// A side or face that was met, with a place inside.
type Met<const N: usize> = HashMap<(usize, [u32; N]), Vec<(Point3, Run)>>;

/// Nodes by the corners between which they are.
pub(super) struct SharedNodes {
    /// Nodes of a block along s, t and u.
    size: [usize; 3],
    corners: HashMap<[u64; 3], u32>,
    sides: Met<2>,
    faces: Met<4>,
}

impl SharedNodes {
    pub(super) fn new(size: [usize; 3]) -> Self {
        Self { size, corners: HashMap::new(), sides: HashMap::new(), faces: HashMap::new() }
    }

    /// Adds the nodes of a block that are not there yet, and where all of its nodes stand.
    pub(super) fn add(
        &mut self,
        block: &CyclideVolume,
        points: &[Point3],
        nodes: &mut Vec<Point3>,
        index: &mut Vec<u32>,
    ) {
        let corners = block.corners().map(|p| {
            // The same point, whatever the sign of a zero.
            let key = p.to_array().map(|x| (x + 0.0).to_bits());
            *self.corners.entry(key).or_insert_with(|| added(nodes, &[p]))
        });
        let last = self.size.map(|n| n - 1);
        let place = |at: [usize; 3]| at[0] + self.size[0] * (at[1] + self.size[1] * at[2]);
        let start = index.len();
        index.resize(start + points.len(), u32::MAX);
        for (k, corner) in corners.into_iter().enumerate() {
            index[start + place(std::array::from_fn(|axis| (k >> axis & 1) * last[axis]))] = corner;
        }
        let reach = block.corners().iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let near = SAME * block.size() + ROUNDINGS * f64::EPSILON * reach;
        // Sides: the bits of the two other directions are those of an end.
        let at_ends =
            |axis: usize, k: usize, x: f64| std::array::from_fn(|d| if d == axis { x } else { (k >> d & 1) as f64 });
        for axis in 0..3 {
            for k in (0..8).filter(|k| k >> axis & 1 == 0) {
                let ends = [corners[k], corners[k | 1 << axis]];
                let inner =
                    |x: usize| place(std::array::from_fn(|d| if d == axis { x } else { (k >> d & 1) * last[d] }));
                let places: Vec<usize> = (1..last[axis]).map(inner).collect();
                let inside = block.point(at_ends(axis, k, INSIDE[0]));
                let one = ends[0] == ends[1] && inside.distance(block.corners()[k]) <= near;
                let met = self.sides.entry((axis, ends)).or_default();
                let run = found(met, inside, near).unwrap_or_else(|| {
                    let run = if one { Run::One(ends[0]) } else { new_run(nodes, points, &places) };
                    met.push((inside, run));
                    run
                });
                places.iter().enumerate().for_each(|(k, at)| index[start + at] = run.node(k));
            }
        }
        for axis in 0..3 {
            // Faces across this direction.
            let [i, j] = [[1, 2], [0, 2], [0, 1]][axis];
            for end in 0..2 {
                let around = [0, 1 << i, 1 << j, 1 << i | 1 << j].map(|k: usize| corners[k | end << axis]);
                let at = |x: usize, y: usize| {
                    let mut at = [end * last[axis]; 3];
                    (at[i], at[j]) = (x, y);
                    place(at)
                };
                let inner = || (1..last[j]).flat_map(|y| (1..last[i]).map(move |x| (x, y)));
                let mut inside = [end as f64; 3];
                (inside[i], inside[j]) = (INSIDE[0], INSIDE[1]);
                let inside = block.point(inside);
                // A face that is a line has the nodes of its sides along it.
                let on_side =
                    |along: usize, x: f64| inside.distance(block.point(at_ends(along, end << axis, x))) <= near;
                let [a, b, c, d] = around;
                let of_side = |side: &dyn Fn(usize, usize) -> usize, index: &mut Vec<u32>| {
                    inner().for_each(|(x, y)| index[start + at(x, y)] = index[start + side(x, y)]);
                };
                if a == b && c == d && on_side(j, INSIDE[1]) {
                    of_side(&|_, y| at(0, y), index);
                    continue;
                }
                if a == c && b == d && on_side(i, INSIDE[0]) {
                    of_side(&|x, _| at(x, 0), index);
                    continue;
                }
                let places: Vec<usize> = inner().map(|(x, y)| at(x, y)).collect();
                let met = self.faces.entry((axis, around)).or_default();
                let run = found(met, inside, near).unwrap_or_else(|| {
                    let run = new_run(nodes, points, &places);
                    met.push((inside, run));
                    run
                });
                places.iter().enumerate().for_each(|(k, at)| index[start + at] = run.node(k));
            }
        }
        for (k, p) in points.iter().enumerate() {
            if index[start + k] == u32::MAX {
                index[start + k] = added(nodes, &[*p]);
            }
        }
    }
}

fn found(met: &[(Point3, Run)], inside: Point3, near: f64) -> Option<Run> {
    met.iter().find(|(p, _)| p.distance(inside) <= near).map(|(_, run)| *run)
}

fn new_run(nodes: &mut Vec<Point3>, points: &[Point3], places: &[usize]) -> Run {
    let first = nodes.len() as u32;
    nodes.extend(places.iter().map(|&at| points[at]));
    Run::From(first)
}

/// Adds points; the index of the first.
fn added(nodes: &mut Vec<Point3>, points: &[Point3]) -> u32 {
    let first = nodes.len() as u32;
    nodes.extend_from_slice(points);
    first
}
