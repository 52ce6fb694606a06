//! Nodes that neighboring blocks have in common: corners bit for bit, and between common corners the nodes of sides and faces.
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
            if way.is_multiple_of(2) { places.clone() } else { places.iter().rev().map(|x| 1.0 - x).collect() }
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
        let start = index.len();
        index.resize(start + points.len(), u32::MAX);
        let index = &mut index[start..];
        let reach = block.corners().iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let near = SAME * block.size() + ROUNDINGS * f64::EPSILON * reach;
        let own = Own { block, points, corners, size: self.size, near };
        for (k, corner) in corners.into_iter().enumerate() {
            index[own.place(std::array::from_fn(|axis| (k >> axis & 1) * own.last(axis)))] = corner;
        }
        self.add_sides(&own, nodes, index);
        for axis in 0..3 {
            (0..2).for_each(|end| self.add_face(&own, (axis, end), nodes, index));
        }
        for (node, p) in index.iter_mut().zip(points).filter(|(node, _)| **node == u32::MAX) {
            *node = added(nodes, &[*p]);
        }
    }

    fn add_sides(&mut self, own: &Own<'_>, nodes: &mut Vec<Point3>, index: &mut [u32]) {
        // The bits of the two other directions are those of an end.
        let sides = (0..3).flat_map(|axis| (0..8).filter(move |k| k >> axis & 1 == 0).map(move |k| (axis, k)));
        for (axis, k) in sides {
            let ends = [own.corners[k], own.corners[k | 1 << axis]];
            let (last, way) = (own.last(axis), Way { axis, back: ends[0] > ends[1] });
            let inner =
                |x: usize| own.place(std::array::from_fn(|d| if d == axis { x } else { (k >> d & 1) * own.last(d) }));
            let places: Vec<usize> = (1..last).map(inner).collect();
            let inside = own.on_side(axis, k, way.parameter(INSIDE[0]));
            let one = ends[0] == ends[1] && inside.distance(own.block.corners()[k]) <= own.near;
            let met = self.sides.entry([ends[0].min(ends[1]), ends[0].max(ends[1])]).or_default();
            let along = |j: usize| way.index(j, last) - 1;
            let known = found(&self.same_places, met, [way], inside, own.near).unwrap_or_else(|| {
                let run = if one { vec![ends[0]; places.len()] } else { new_run(nodes, own.points, &places) };
                met.push(Met { inside, ways: [way], nodes: (1..last).map(|j| run[along(j)]).collect() });
                met.len() - 1
            });
            for j in 1..last {
                index[places[along(j)]] = met[known].nodes[j - 1];
            }
        }
    }

    /// Adds the face at an end across a direction, of which the sides are there.
    fn add_face(&mut self, own: &Own<'_>, (axis, end): (usize, usize), nodes: &mut Vec<Point3>, index: &mut [u32]) {
        let [i, j] = [[1, 2], [0, 2], [0, 1]][axis];
        let last = [own.last(i), own.last(j)];
        let around = [0, 1 << i, 1 << j, 1 << i | 1 << j].map(|k: usize| own.corners[k | end << axis]);
        let at = |x: usize, y: usize| {
            let mut at = [end * own.last(axis); 3];
            (at[i], at[j]) = (x, y);
            own.place(at)
        };
        let inner = || (1..last[1]).flat_map(|y| (1..last[0]).map(move |x| (x, y)));
        let point = |x: f64, y: f64| {
            let mut at = [end as f64; 3];
            (at[i], at[j]) = (x, y);
            own.block.point(at)
        };
        // A face that is a line has the nodes of its sides along it.
        let inside = point(INSIDE[0], INSIDE[1]);
        let on_side = |along: usize, x: f64| inside.distance(own.on_side(along, end << axis, x)) <= own.near;
        let [a, b, c, d] = around;
        if a == b && c == d && on_side(j, INSIDE[1]) {
            return inner().for_each(|(x, y)| index[at(x, y)] = index[at(0, y)]);
        }
        if a == c && b == d && on_side(i, INSIDE[0]) {
            return inner().for_each(|(x, y)| index[at(x, y)] = index[at(x, 0)]);
        }
        let places: Vec<usize> = inner().map(|(x, y)| at(x, y)).collect();
        let (turn, key) = Turn::of(around);
        let ways = turn.ways([i, j]);
        let [x, y] = turn.exchanged(INSIDE);
        let inside = point(turn.way(0, i).parameter(x), turn.way(1, j).parameter(y));
        // The number of a node inside in the common order among those of the block's own face.
        let number = |common: [usize; 2]| {
            let [x, y] = turn.exchanged(common);
            let [x, y] = [turn.way(0, i).index(x, last[0]), turn.way(1, j).index(y, last[1])];
            x - 1 + (y - 1) * (last[0] - 1)
        };
        let [width, height] = turn.exchanged(last);
        let common = || (1..height).flat_map(|y| (1..width).map(move |x| [x, y]));
        let met = self.faces.entry(key).or_default();
        let known = found(&self.same_places, met, ways, inside, own.near).unwrap_or_else(|| {
            self.faces_apart += usize::from(met.iter().any(|other| other.inside.distance(inside) <= own.near));
            let run = new_run(nodes, own.points, &places);
            met.push(Met { inside, ways, nodes: common().map(|at| run[number(at)]).collect() });
            met.len() - 1
        });
        for (at, node) in common().zip(&met[known].nodes) {
            index[places[number(at)]] = *node;
        }
    }
}

/// A block whose nodes are added.
struct Own<'a> {
    block: &'a CyclideVolume,
    /// Its nodes, s fastest.
    points: &'a [Point3],
    corners: [u32; 8],
    size: [usize; 3],
    /// Within this distance places are one.
    near: f64,
}

impl Own<'_> {
    fn last(&self, axis: usize) -> usize {
        self.size[axis] - 1
    }

    fn place(&self, at: [usize; 3]) -> usize {
        at[0] + self.size[0] * (at[1] + self.size[1] * at[2])
    }

    /// A point of the side along a direction from a corner.
    fn on_side(&self, axis: usize, corner: usize, x: f64) -> Point3 {
        self.block.point(std::array::from_fn(|d| if d == axis { x } else { (corner >> d & 1) as f64 }))
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
