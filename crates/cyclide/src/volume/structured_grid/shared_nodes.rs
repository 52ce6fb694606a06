//! Nodes that neighbouring blocks have in common: corners bit for bit, and between common corners the nodes of sides and faces.
//!
//! A side is known by its two corners and a face by its four: two blocks that have them run over them with the same parameters, if they are the same at
//! all, or with these exchanged and from the other ends, as [`Turn`] tells. Two arcs may have the same ends (a ring of two blocks), so a place inside is
//! compared as well, within the rounding that blocks differ by. A side that is one point has one node, a face that is a line (of a wedge, as at the pole of
//! a sphere) those of a side.

use super::turn::{Turn, Way};
use crate::base::vector::Point3;
use crate::volume::ParamVolume as _;
use crate::volume::cyclide_volume::CyclideVolume;
use std::collections::HashMap;

/// Where sides and faces are compared: no place that symmetry makes the same, as it does insides.
const INSIDE: [f64; 2] = [0.37, 0.61];
/// Places on what two blocks share are at most so far apart, relative to the larger block, and in roundings of the coordinates.
const SAME: f64 = 1e-9;
const ROUNDINGS: f64 = 64.0;

/// Parameters along two blocks are one if they differ by no more: both are made of the same counts and laws, one seen from its other end.
const SAME_PLACE: f64 = 1e-12;

/// A side or face that was met: by a place inside, the ways along it, and the nodes inside, the first way fastest.
struct Met<const N: usize> {
    inside: Point3,
    ways: [Way; N],
    nodes: Vec<u32>,
}

/// Nodes by the corners between which they are.
pub(super) struct SharedNodes {
    /// Nodes of a block along s, t and u.
    size: [usize; 3],
    /// Whether the nodes of two ways are at the same places.
    same_places: [[bool; 6]; 6],
    corners: HashMap<[u64; 3], u32>,
    sides: HashMap<[u32; 2], Vec<Met<1>>>,
    faces: HashMap<[u32; 4], Vec<Met<2>>>,
    /// Faces that were met before with nodes at other places.
    pub(super) faces_apart: usize,
}

impl SharedNodes {
    pub(super) fn new(places: &[Vec<f64>; 3]) -> Self {
        let along = |way: usize| -> Vec<f64> {
            let places = &places[way / 2];
            if way % 2 == 0 { places.clone() } else { places.iter().rev().map(|x| 1.0 - x).collect() }
        };
        let all: [Vec<f64>; 6] = std::array::from_fn(along);
        let same =
            |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() <= SAME_PLACE);
        Self {
            size: places.each_ref().map(Vec::len),
            same_places: std::array::from_fn(|a| std::array::from_fn(|b| a == b || same(&all[a], &all[b]))),
            corners: HashMap::new(),
            sides: HashMap::new(),
            faces: HashMap::new(),
            faces_apart: 0,
        }
    }

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
                let way = Way { axis, back: ends[0] > ends[1] };
                let inner =
                    |x: usize| place(std::array::from_fn(|d| if d == axis { x } else { (k >> d & 1) * last[d] }));
                let places: Vec<usize> = (1..last[axis]).map(inner).collect();
                let inside = block.point(at_ends(axis, k, way.parameter(INSIDE[0])));
                let one = ends[0] == ends[1] && inside.distance(block.corners()[k]) <= near;
                let met = self.sides.entry([ends[0].min(ends[1]), ends[0].max(ends[1])]).or_default();
                let along = |j: usize| way.index(j, last[axis]) - 1;
                let known = found(&self.same_places, met, [way], inside, near).unwrap_or_else(|| {
                    let own = if one { vec![ends[0]; places.len()] } else { new_run(nodes, points, &places) };
                    met.push(Met { inside, ways: [way], nodes: (1..last[axis]).map(|j| own[along(j)]).collect() });
                    met.len() - 1
                });
                for j in 1..last[axis] {
                    index[start + places[along(j)]] = met[known].nodes[j - 1];
                }
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
                let (turn, key) = Turn::of(around);
                let ways = turn.ways([i, j]);
                let mut inside = [end as f64; 3];
                ways.iter().zip(INSIDE).for_each(|(way, x)| inside[way.axis] = way.parameter(x));
                let inside = block.point(inside);
                let met = self.faces.entry(key).or_default();
                let [width, height] = ways.map(|way| last[way.axis]);
                let canonical = || (1..height).flat_map(|y| (1..width).map(move |x| [x, y]));
                // The number of a node inside among those of the block's own face.
                let own = |at: [usize; 2]| {
                    let mut place = [0; 3];
                    ways.iter().zip(at).for_each(|(way, k)| place[way.axis] = way.index(k, last[way.axis]));
                    place[i] - 1 + (place[j] - 1) * (last[i] - 1)
                };
                let known = found(&self.same_places, met, ways, inside, near).unwrap_or_else(|| {
                    self.faces_apart += usize::from(met.iter().any(|own| own.inside.distance(inside) <= near));
                    let run = new_run(nodes, points, &places);
                    met.push(Met { inside, ways, nodes: canonical().map(|at| run[own(at)]).collect() });
                    met.len() - 1
                });
                for (at, node) in canonical().zip(&met[known].nodes) {
                    index[start + places[own(at)]] = *node;
                }
            }
        }
        for (k, p) in points.iter().enumerate() {
            if index[start + k] == u32::MAX {
                index[start + k] = added(nodes, &[*p]);
            }
        }
    }
}

/// The number of what was met with this place inside, and the same places of nodes.
fn found<const N: usize>(
    same_places: &[[bool; 6]; 6],
    met: &[Met<N>],
    ways: [Way; N],
    inside: Point3,
    near: f64,
) -> Option<usize> {
    let fits = |own: &Met<N>| own.ways.iter().zip(&ways).all(|(a, b)| same_places[a.number()][b.number()]);
    met.iter().position(|own| own.inside.distance(inside) <= near && fits(own))
}

/// Adds the points at these places as nodes.
fn new_run(nodes: &mut Vec<Point3>, points: &[Point3], places: &[usize]) -> Vec<u32> {
    let first = nodes.len() as u32;
    nodes.extend(places.iter().map(|&at| points[at]));
    (first..nodes.len() as u32).collect()
}

/// Adds points; the index of the first.
fn added(nodes: &mut Vec<Point3>, points: &[Point3]) -> u32 {
    let first = nodes.len() as u32;
    nodes.extend_from_slice(points);
    first
}
