//! Triangles over the polygons of chords: holes are joined to the outer contour, ears are cut off, and diagonals turned until no angle
//! grows by it (Delaunay, so far as the chords allow).

use super::contours::{meet, next_of, turn};
use crate::base::planar::Point2;
use std::collections::BTreeMap;

/// Diagonals are turned if it makes the sine of the sum of the angles across them larger by more than this.
const GAIN: f64 = 1e-9;
/// Passes over all diagonals.
const PASSES: usize = 100;

/// The triangles of the area between rings of vertices, counter-clockwise, the area to the left of all rings; `None` if the rings are
/// no polygons that lie in each other so.
pub(super) fn triangulate(places: &[Point2], rings: &[Vec<usize>]) -> Option<Vec<[usize; 3]>> {
    let ring = joined(places, rings)?;
    let mut triangles = ears(places, ring)?;
    turn_diagonals(places, rings, &mut triangles);
    Some(triangles)
}

/// One ring that runs along all others, and twice along lines between them.
fn joined(places: &[Point2], rings: &[Vec<usize>]) -> Option<Vec<usize>> {
    let area = |ring: &[usize]| -> f64 {
        (0..ring.len()).map(|k| turn(places[ring[0]], places[ring[k]], places[ring[(k + 1) % ring.len()]])).sum()
    };
    let next = next_of(rings, places.len());
    let mut ring = rings.iter().find(|ring| area(ring) > 0.0)?.clone();
    let mut holes: Vec<Vec<usize>> = rings.iter().filter(|ring| area(ring) <= 0.0).cloned().collect();
    // From the vertex farthest to the right.
    for hole in &mut holes {
        let first = (0..hole.len()).max_by(|&a, &b| places[hole[a]].x.total_cmp(&places[hole[b]].x))?;
        hole.rotate_left(first);
    }
    holes.sort_by(|a, b| places[b[0]].x.total_cmp(&places[a[0]].x));
    for hole in holes {
        let from = hole[0];
        let sees = |k: usize| {
            let to = ring[k];
            let around = [ring[(k + ring.len() - 1) % ring.len()], to, ring[(k + 1) % ring.len()]];
            let at_hole = [hole[hole.len() - 1], from, hole[1]];
            is_between(around.map(|v| places[v]), places[from])
                && is_between(at_hole.map(|v| places[v]), places[to])
                && (0..places.len()).all(|a| {
                    let b = next[a];
                    let apart = ![from, to].contains(&a) && ![from, to].contains(&b);
                    !apart || !meet([places[a], places[b]], [places[from], places[to]])
                })
        };
        let mut nearest: Vec<usize> = (0..ring.len()).collect();
        let distance = |k: usize| places[ring[k]].distance(places[from]);
        nearest.sort_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        let k = nearest.into_iter().find(|&k| sees(k))?;
        let bridge: Vec<usize> = hole.iter().copied().chain([from, ring[k]]).collect();
        ring.splice(k + 1..k + 1, bridge);
    }
    Some(ring)
}

/// Whether a point is seen from the middle one of three vertices, with the area to the left.
fn is_between([before, at, after]: [Point2; 3], p: Point2) -> bool {
    let [left_of_first, left_of_second] = [turn(before, at, p) > 0.0, turn(at, after, p) > 0.0];
    if turn(before, at, after) > 0.0 { left_of_first && left_of_second } else { left_of_first || left_of_second }
}

/// The triangles cut off a ring, one by one.
fn ears(places: &[Point2], mut ring: Vec<usize>) -> Option<Vec<[usize; 3]>> {
    let mut triangles = Vec::with_capacity(ring.len());
    let (mut k, mut tried) = (0, 0);
    while ring.len() > 3 {
        let count = ring.len();
        if tried > count {
            return None;
        }
        let ear = [(k + count - 1) % count, k % count, (k + 1) % count].map(|i| ring[i]);
        if is_ear(places, &ring, ear) {
            triangles.push(ear);
            ring.remove(k % count);
            tried = 0;
        } else {
            tried += 1;
        }
        // Every other one: else all triangles would lie about one vertex.
        k = (k + 1) % ring.len();
    }
    let [a, b, c] = ring[..] else { return None };
    (turn(places[a], places[b], places[c]) > 0.0).then(|| triangles.push([a, b, c]))?;
    Some(triangles)
}

fn is_ear(places: &[Point2], ring: &[usize], ear: [usize; 3]) -> bool {
    let [a, b, c] = ear.map(|v| places[v]);
    let inside = |p: Point2| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
    turn(a, b, c) > 0.0 && !ring.iter().any(|v| !ear.contains(v) && inside(places[*v]))
}

/// Turns diagonals as long as that makes triangles less narrow.
fn turn_diagonals(places: &[Point2], rings: &[Vec<usize>], triangles: &mut [[usize; 3]]) {
    let next = next_of(rings, places.len());
    let mut of_edge: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    for (number, &[a, b, c]) in triangles.iter().enumerate() {
        of_edge.extend([([a, b], number), ([b, c], number), ([c, a], number)]);
    }
    for _ in 0..PASSES {
        let mut turned = false;
        for edge in of_edge.keys().copied().collect::<Vec<_>>() {
            let [a, b] = edge;
            if a > b || next[a] == b || next[b] == a {
                continue;
            }
            let (Some(&left), Some(&right)) = (of_edge.get(&[a, b]), of_edge.get(&[b, a])) else { continue };
            let [Some(c), Some(d)] = [left, right].map(|t| triangles[t].into_iter().find(|v| ![a, b].contains(v)))
            else {
                continue;
            };
            if !gains([a, b, c, d].map(|v| places[v])) {
                continue;
            }
            for old in [[a, b], [b, a]] {
                of_edge.remove(&old);
            }
            for (number, triangle) in [(left, [a, d, c]), (right, [d, b, c])] {
                triangles[number] = triangle;
                let [u, v, w] = triangle;
                of_edge.extend([([u, v], number), ([v, w], number), ([w, u], number)]);
            }
            turned = true;
        }
        if !turned {
            break;
        }
    }
}

/// Whether the line from c to d is the better diagonal of the quadrilateral a d b c, in which that from a to b is one.
fn gains([a, b, c, d]: [Point2; 4]) -> bool {
    if !(turn(a, d, c) > 0.0 && turn(d, b, c) > 0.0) {
        return false;
    }
    // The sine of the sum of the angles at c and d: negative beyond half a turn.
    let across = |p: Point2| ((b - p).cross(a - p), (a - p).dot(b - p));
    let ((sin_c, cos_c), (sin_d, cos_d)) = (across(c), across(d));
    let (sin_c, sin_d) = (-sin_c, sin_d);
    let sum = sin_c * cos_d + cos_c * sin_d;
    sum < -GAIN * (sin_c.hypot(cos_c) * sin_d.hypot(cos_d))
}
