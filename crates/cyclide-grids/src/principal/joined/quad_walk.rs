//! Quads found by walking from point to point, over slits too: each point has four ways, whichever way the coordinates are turned there.

use std::collections::{HashMap, VecDeque};

use super::super::walker::{Place, Walker};
use cyclide::Point3;

/// Points closer than this part of a step are the same.
const SAME: f64 = 1e-6;
/// A point that has the coordinates of an umbilic, to this part of a step, and is nearer to it than this many steps is no other one.
const SAME_COORDINATE: f64 = 1e-3;
const BESIDE: f64 = 2.0;

/// An umbilic, where no point is laid: its place, and its coordinates, which are those of a point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Centre {
    pub(super) point: Point3,
    pub(super) at: [f64; 2],
}

/// A point of the lattice; ways are along the first coordinate, the second, and back along both.
struct Node {
    place: Place,
    /// The point at the end of each way, and its way back.
    next: [Option<(usize, usize)>; 4],
}

pub(super) struct QuadWalk<'a> {
    walker: &'a Walker<'a>,
    steps: [f64; 2],
    centres: &'a [Centre],
    nodes: Vec<Node>,
    at: HashMap<[i64; 3], Vec<usize>>,
}

impl<'a> QuadWalk<'a> {
    /// The points that walks reach from one near the middle of a triangle; `None` if there is none, or more than `most`.
    pub(super) fn new(
        walker: &'a Walker<'a>,
        seed: usize,
        steps: [f64; 2],
        centres: &'a [Centre],
        most: usize,
    ) -> Option<Self> {
        let middle = walker.middle(seed);
        let phase = centres.first().map_or([0.0; 2], |centre| centre.at);
        let number = [0, 1].map(|d| ((middle.at[d] - phase[d]) / steps[d]).floor());
        let mut walk = Self { walker, steps, centres, nodes: Vec::new(), at: HashMap::new() };
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let first = corners.into_iter().find_map(|corner| {
            // Passing a slit would turn the way.
            let way = [0, 1].map(|d| phase[d] + (number[d] + corner[d]) * steps[d] - middle.at[d]);
            walker.walk(middle, way).filter(|place| !walk.is_centre(*place))
        })?;
        walk.add(first);
        walk.spread(most)?;
        Some(walk)
    }

    fn near(&self) -> f64 {
        SAME * self.steps[0].abs().max(self.steps[1].abs())
    }

    /// Whether a place is an umbilic's, or has its coordinates beside it, as where triangles round it are folded.
    fn is_centre(&self, place: Place) -> bool {
        let p = self.walker.flat_point(place);
        let reach = BESIDE * self.steps[0].abs().max(self.steps[1].abs());
        let is = |centre: &Centre| {
            let same = |d: usize| (place.at[d] - centre.at[d]).abs() <= SAME_COORDINATE * self.steps[d].abs();
            centre.point.distance(p) <= reach && same(0) && same(1)
        };
        self.centres.iter().any(is)
    }

    /// The cube of space that a point is in, of the size of a step.
    fn cube(&self, p: Point3) -> [i64; 3] {
        p.to_array().map(|x| (x / self.steps[0].abs()).floor() as i64)
    }

    fn add(&mut self, place: Place) -> usize {
        let index = self.nodes.len();
        self.nodes.push(Node { place, next: [None; 4] });
        self.at.entry(self.cube(self.walker.flat_point(place))).or_default().push(index);
        index
    }

    fn known(&self, p: Point3) -> Option<usize> {
        let corner = |by: f64| self.cube(Point3::from(p.to_array().map(|x| x + by)));
        let (low, high) = (corner(-self.near()), corner(self.near()));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let here = self.at.get(&[x, y, z]).into_iter().flatten();
                    let near = |k: &&usize| self.walker.flat_point(self.nodes[**k].place).distance(p) <= self.near();
                    if let Some(found) = here.into_iter().find(near) {
                        return Some(*found);
                    }
                }
            }
        }
        None
    }

    /// Whether the coordinates of two triangles at one point are turned by half a turn against each other.
    fn are_turned(&self, a: usize, b: usize) -> bool {
        let along = |f: usize| self.walker.coordinates.slopes(self.walker.sheet, f)[0];
        a != b && along(a).dot(along(b)) < 0.0
    }

    fn spread(&mut self, most: usize) -> Option<()> {
        let mut queue = VecDeque::from([0]);
        while let Some(from) = queue.pop_front() {
            for way in 0..4 {
                if self.nodes[from].next[way].is_some() {
                    continue;
                }
                let mut step = [0.0; 2];
                step[way % 2] = if way < 2 { self.steps[way] } else { -self.steps[way - 2] };
                let Some((end, turned)) = self.walker.walk_turning(self.nodes[from].place, step) else { continue };
                if self.is_centre(end) {
                    continue;
                }
                let point = self.walker.flat_point(end);
                let (to, turned) = match self.known(point) {
                    Some(to) => (to, turned ^ self.are_turned(end.face, self.nodes[to].place.face)),
                    None => {
                        if self.nodes.len() >= most {
                            return None;
                        }
                        queue.push_back(self.nodes.len());
                        (self.add(end), turned)
                    }
                };
                // Back along the way that came, which half a turn makes the way that goes on.
                let back = if turned { way } else { (way + 2) % 4 };
                if self.nodes[to].next[back].is_none() && to != from {
                    self.nodes[to].next[back] = Some((from, way));
                    self.nodes[from].next[way] = Some((to, back));
                }
            }
        }
        Some(())
    }

    /// The places of all points, and the quads between them, each by its corners counter-clockwise.
    pub(super) fn quads(&self) -> (Vec<Place>, Vec<[usize; 4]>) {
        let mut quads = Vec::new();
        for start in 0..self.nodes.len() {
            for first in 0..4 {
                let (mut corners, mut at, mut way) = ([start; 4], start, first);
                let mut closes = true;
                for corner in &mut corners {
                    *corner = at;
                    let Some((to, back)) = self.nodes[at].next[way] else {
                        closes = false;
                        break;
                    };
                    // To the left of going on.
                    (at, way) = (to, (back + 3) % 4);
                }
                let distinct = (0..4).all(|i| (0..i).all(|j| corners[i] != corners[j]));
                // Each once, from its first corner.
                if closes && distinct && (at, way) == (start, first) && corners.iter().all(|v| *v >= start) {
                    // From a side along the first coordinate: rows of all grids follow one family of lines.
                    corners.rotate_left(first % 2);
                    quads.push(corners);
                }
            }
        }
        (self.nodes.iter().map(|node| node.place).collect(), quads)
    }
}
