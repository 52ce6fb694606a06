//! How the patches of a mesh hang together, as MFEM has it: elements with numbered corners, their edges with knot vectors, and the boundary.
//!
//! MFEM knows what is shared by the numbers of corners alone: two patches with the same two corners have one edge there, whatever its control points
//! are. So corners get one number only where whole sides are one, and only where nothing else becomes one by it.

use crate::export::patch_joints::{Joints, Side, same_limit, same_nodes};
use crate::export::rational_cells::Node;
use crate::export::spline_patches::SplinePatch;
use std::collections::{HashMap, HashSet};

/// Elements, boundary and edges.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Topology {
    /// How many corners there are.
    pub(super) vertices: usize,
    /// The corners of each patch, in binary order.
    pub(super) elements: Vec<Vec<usize>>,
    /// Sides that one patch has alone, with their corners: in binary order, round seen from outside in MFEM's order.
    pub(super) boundary: Vec<(Side, Vec<usize>)>,
    /// The knot vector of each edge, and its corners in the direction of the rising parameter.
    pub(super) edges: Vec<[usize; 3]>,
    /// Sides that touch others and are not joined to them.
    pub(super) apart: usize,
}

impl Topology {
    pub(super) fn of(patches: &[SplinePatch]) -> Self {
        let mut joints = Joints::of(patches);
        let (topology, faults) = Self::joined(patches, &joints);
        if faults.is_empty() {
            return topology;
        }
        // What hangs together with such a patch stays apart; nothing else has to do with it.
        let groups = groups(patches.len(), &joints);
        let apart: HashSet<usize> = faults.iter().map(|patch| groups[*patch]).collect();
        let before = joints.pairs.len();
        joints.pairs.retain(|[(first, _), _]| !apart.contains(&groups[*first]));
        joints.touching += 2 * (before - joints.pairs.len());
        Self::joined(patches, &joints).0
    }

    /// The topology of these joints, and patches where they make one of what is not.
    fn joined(patches: &[SplinePatch], joints: &Joints) -> (Self, Vec<usize>) {
        let dimension = patches.first().map_or(1, SplinePatch::dimension);
        let (corners, limit) = (1_usize << dimension, same_limit(patches));
        let mut vertices = Union::new(patches.len() * corners);
        for [(a, side_a), (b, side_b)] in &joints.pairs {
            for (c, d) in corners_of(dimension, *side_a).zip(corners_of(dimension, *side_b)) {
                vertices.join(a * corners + c, b * corners + d);
            }
        }
        let mut topology = Self { apart: joints.touching, ..Self::default() };
        let (mut numbers, mut faults): (HashMap<usize, usize>, _) = (HashMap::new(), Vec::new());
        for patch in 0..patches.len() {
            let of_corner = |corner| {
                let root = vertices.root(patch * corners + corner);
                let next = numbers.len();
                *numbers.entry(root).or_insert(next)
            };
            let element: Vec<usize> = (0..corners).map(of_corner).collect();
            if element.iter().collect::<HashSet<_>>().len() < corners {
                faults.push(patch);
            }
            topology.elements.push(element);
        }
        topology.vertices = numbers.len();
        topology.add_boundary(dimension, joints, &mut faults);
        topology.add_edges(patches, dimension, limit, &mut faults);
        (topology, faults)
    }

    /// Sides with the same corners are one in MFEM: they have to be joints.
    fn add_boundary(&mut self, dimension: usize, joints: &Joints, faults: &mut Vec<usize>) {
        let joined: HashSet<Side> = joints.pairs.iter().flatten().copied().collect();
        let mut seen: HashMap<Vec<usize>, usize> = HashMap::new();
        for (patch, element) in self.elements.iter().enumerate() {
            for side in 0..2 * dimension {
                let own: Vec<usize> = corners_of(dimension, side).map(|corner| element[corner]).collect();
                let mut key = own.clone();
                key.sort_unstable();
                let count = seen.entry(key).or_insert(0);
                *count += 1;
                if *count > if joined.contains(&(patch, side)) { 2 } else { 1 } {
                    faults.push(patch);
                }
                if !joined.contains(&(patch, side)) {
                    self.boundary.push(((patch, side), outward(side, dimension, own)));
                }
            }
        }
    }

    /// Edges with the same corners are one: with the same control points, running the same way.
    fn add_edges(&mut self, patches: &[SplinePatch], dimension: usize, limit: f64, faults: &mut Vec<usize>) {
        let mut seen: HashMap<[usize; 2], (usize, Vec<Node>)> = HashMap::new();
        let mut knots = Union::new(patches.len() * dimension);
        let mut edges: Vec<[usize; 3]> = Vec::new();
        for (patch, element) in self.elements.iter().enumerate() {
            for axis in 0..dimension {
                let class = patch * dimension + axis;
                for from in (0..element.len()).filter(|corner| corner >> axis & 1 == 0) {
                    let ends = [element[from], element[from | 1 << axis]];
                    if dimension > 1 && seen.contains_key(&[ends[1], ends[0]]) {
                        faults.push(patch);
                    }
                    let nodes = edge(&patches[patch], axis, from);
                    match seen.get(&ends) {
                        None => {
                            edges.push([class, ends[0], ends[1]]);
                            seen.insert(ends, (class, nodes));
                        }
                        Some((other, known)) if dimension > 1 && same_nodes(known, &nodes, limit) => {
                            knots.join(class, *other)
                        }
                        Some(_) if dimension == 1 => edges.push([class, ends[0], ends[1]]),
                        Some(_) => faults.push(patch),
                    }
                }
            }
        }
        // Knot vectors of one class are one; the numbers in the order of the edges.
        let mut numbers: HashMap<usize, usize> = HashMap::new();
        for [class, ..] in &mut edges {
            let next = numbers.len();
            *class = *numbers.entry(knots.root(*class)).or_insert(next);
        }
        for class in 0..patches.len() * dimension {
            let root = knots.root(class);
            if patches[class / dimension].knots[class % dimension] != patches[root / dimension].knots[root % dimension]
            {
                faults.push(class / dimension);
            }
        }
        self.edges = edges;
    }
}

/// The corners of a side, in binary order.
fn corners_of(dimension: usize, side: usize) -> impl Iterator<Item = usize> {
    (0..1_usize << dimension).filter(move |corner| corner >> (side / 2) & 1 == side % 2)
}

/// The control points of an edge along a parameter from a corner.
fn edge(patch: &SplinePatch, axis: usize, from: usize) -> Vec<Node> {
    let degrees = patch.net.degrees;
    let mut at: [usize; 3] = std::array::from_fn(|other| degrees[other] * (from >> other & 1));
    let along = (0..=degrees[axis]).map(|k| {
        at[axis] = k;
        patch.net.node(at)
    });
    along.collect()
}

/// The corners of a side so that it is counter-clockwise seen from outside, in the binary order from which elements are written.
fn outward(side: usize, dimension: usize, corners: Vec<usize>) -> Vec<usize> {
    let (axis, end) = (side / 2, side % 2);
    // The other parameters in order are right-handed with the axis but for the middle one of three, and for the second of two.
    let along = match dimension {
        3 => axis != 1,
        2 => axis == 0,
        _ => return corners,
    };
    if along == (end == 1) {
        return corners;
    }
    match *corners.as_slice() {
        [a, b, c, d] => vec![a, c, b, d],
        [a, b] => vec![b, a],
        _ => corners,
    }
}

/// For each patch a number that those have in common that hang together.
fn groups(patches: usize, joints: &Joints) -> Vec<usize> {
    let mut union = Union::new(patches);
    joints.pairs.iter().for_each(|[(a, _), (b, _)]| union.join(*a, *b));
    (0..patches).map(|patch| union.root(patch)).collect()
}

/// Sets that are joined.
struct Union(Vec<usize>);

impl Union {
    fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    fn root(&mut self, mut k: usize) -> usize {
        while self.0[k] != k {
            self.0[k] = self.0[self.0[k]];
            k = self.0[k];
        }
        k
    }

    /// The root is the lower number.
    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::rational_cells::{RationalCell, Tags};

    /// A box of degrees 1 from a corner with sides.
    fn cell([x, y, z]: [f64; 3], [a, b, c]: [f64; 3]) -> SplinePatch {
        let place = |k: usize| [x + a * (k >> 2) as f64, y + b * (k >> 1 & 1) as f64, z + c * (k & 1) as f64];
        let nodes = (0..8).map(|k| (place(k), 1.0)).collect();
        RationalCell { degrees: [1; 3], nodes, tags: Tags::default() }.into()
    }

    #[test]
    fn boxes_side_by_side_share_a_face_and_those_that_differ_do_not() {
        let first = cell([0.0; 3], [1.0; 3]);
        let topology = Topology::of(&[first.clone(), cell([1.0, 0.0, 0.0], [2.0, 1.0, 1.0])]);
        assert_eq!((topology.vertices, topology.boundary.len(), topology.edges.len(), topology.apart), (12, 10, 20, 0));
        // Four knot vectors: s of each, t and u of both.
        assert_eq!(topology.edges.iter().map(|edge| edge[0]).max(), Some(3));
        // The same with other weights there, and with t the other way.
        let mut heavy = cell([1.0, 0.0, 0.0], [2.0, 1.0, 1.0]);
        heavy.net.nodes.iter_mut().for_each(|(_, w)| *w *= 1.7);
        let turned = cell([1.0, 1.0, 0.0], [2.0, -1.0, 1.0]);
        for other in [heavy, turned] {
            let topology = Topology::of(&[first.clone(), other]);
            assert_eq!((topology.vertices, topology.boundary.len(), topology.apart), (16, 12, 2));
        }
    }

    #[test]
    fn sides_of_the_boundary_look_outward() {
        let patch = cell([0.0; 3], [1.0; 3]);
        let topology = Topology::of(std::slice::from_ref(&patch));
        let corners: Vec<[f64; 3]> = patch.corners().map(|(p, _)| p).collect();
        for ((_, side), own) in &topology.boundary {
            let of = |k: usize| {
                cyclide::Point3::from(corners[topology.elements[0].iter().position(|v| *v == own[k]).unwrap_or(9)])
            };
            let normal = (of(1) - of(0)).cross(of(2) - of(0)).to_array();
            let expected = if side % 2 == 1 { 1.0 } else { -1.0 };
            assert!((normal[side / 2] - expected).abs() < 1e-15, "side {side}: {normal:?}");
        }
    }

    /// Two patches round a ring would have two edges each between the same corners: they stay apart, with all four sides of each where the other's are.
    #[test]
    fn what_corners_alone_cannot_tell_stays_apart() {
        let sheet = |points: [[f64; 3]; 4]| -> SplinePatch {
            let nodes = points.map(|p| (p, 1.0)).to_vec();
            RationalCell { degrees: [1, 1, 0], nodes, tags: Tags::default() }.into()
        };
        let [a, b] = [[1.0, 0.0, 0.0], [1.0, 0.0, 1.0]];
        let [c, d] = [[-1.0, 0.0, 0.0], [-1.0, 0.0, 1.0]];
        let topology = Topology::of(&[sheet([a, b, c, d]), sheet([c, d, a, b])]);
        assert_eq!((topology.vertices, topology.boundary.len(), topology.apart), (8, 8, 8));
    }
}
