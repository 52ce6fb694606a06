//! Shortest ways along edges: cuts from singular places to the border, and the seam of a surface that closes.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::mesh_table::{MeshTable, NONE, before};

/// Shortest ways along edges from a set of vertices.
pub(super) struct Ways {
    /// The half edge along which each vertex is reached, from nearer to farther; [`NONE`] where the way starts, or where none leads.
    by: Vec<usize>,
    distance: Vec<f64>,
}

impl Ways {
    /// Ways from the vertices of `sources` that pass through no vertex that is `closed` (they may end there).
    pub(super) fn from(table: &MeshTable, sources: impl Iterator<Item = usize>, closed: &[bool]) -> Self {
        let count = table.points.len();
        let mut ways = Self { by: vec![NONE; count], distance: vec![f64::INFINITY; count] };
        // Distances are not negative: their bits are in their order.
        let mut heap = BinaryHeap::new();
        for v in sources {
            ways.distance[v] = 0.0;
            heap.push(Reverse((0_u64, v)));
        }
        while let Some(Reverse((bits, v))) = heap.pop() {
            if f64::from_bits(bits) > ways.distance[v] || (closed[v] && ways.distance[v] > 0.0) {
                continue;
            }
            for half in table.fan(v) {
                // On the border the last edge of the fan has a half edge towards the vertex only: that way is left out.
                let to = table.ends(half)[1];
                let distance = ways.distance[v] + table.vector(half).length();
                if table.twin(half) != NONE && distance < ways.distance[to] {
                    ways.distance[to] = distance;
                    ways.by[to] = half;
                    heap.push(Reverse((distance.to_bits(), to)));
                }
            }
        }
        ways
    }

    pub(super) fn distance(&self, vertex: usize) -> f64 {
        self.distance[vertex]
    }

    /// The half edges of the way to a vertex, from its start.
    pub(super) fn to(&self, vertex: usize, table: &MeshTable) -> Vec<usize> {
        let mut way = Vec::new();
        let mut at = vertex;
        while self.by[at] != NONE {
            way.push(self.by[at]);
            at = table.ends(self.by[at])[0];
        }
        way.reverse();
        way
    }
}

/// The corners (`3 f + k`) on the left of a way from border to border.
pub(super) fn left_corners(table: &MeshTable, way: &[usize]) -> Vec<bool> {
    let mut left = vec![false; 3 * table.triangles.len()];
    let ahead = way.iter().map(|half| Some(*half)).chain([None]);
    let behind = [None].into_iter().chain(way.iter().map(|half| Some(table.twin(*half))));
    let vertices = way.iter().map(|half| table.ends(*half)[0]).chain(way.last().map(|half| table.ends(*half)[1]));
    for ((ahead, behind), vertex) in ahead.zip(behind).zip(vertices) {
        let fan: Vec<usize> = table.fan(vertex).collect();
        let place = |half: Option<usize>| half.and_then(|half| fan.iter().position(|h| *h == half));
        let start = place(ahead).unwrap_or(0);
        let count = fan.len();
        // Counter-clockwise from the way ahead (or the border) to the way back (or the border).
        for half in (start..start + count).map(|k| fan[k % count]) {
            if Some(half) == behind {
                break;
            }
            left[half] = true;
            if table.twin(before(half)) == NONE {
                break;
            }
        }
    }
    left
}
