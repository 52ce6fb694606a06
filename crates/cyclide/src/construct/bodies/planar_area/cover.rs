//! Faces over the triangles of the chords.

use super::contours::{Contours, is_bent};
use super::sense::keeps_sense;
use super::triangles::triangulate;
use crate::base::planar::Point2;
use std::collections::BTreeMap;

/// Corners of faces, as those of [`Cover`](super::Cover).
type Corners = [usize; 4];

/// The curves between vertices.
struct Lines<'a> {
    contours: &'a Contours<'a>,
    places: Vec<Point2>,
    /// The sides: the number of each, by its vertices.
    sides: BTreeMap<[usize; 2], usize>,
    rows: Vec<Vec<[f64; 3]>>,
    bent: Vec<bool>,
}

impl<'a> Lines<'a> {
    fn new(contours: &'a Contours<'a>) -> Self {
        let next = super::contours::next_of(&contours.rings(), contours.count());
        let sides = next.into_iter().enumerate().map(|(k, next)| ([k, next], k)).collect();
        let rows = contours.all().map(|curve| contours.plane.rows(curve)).collect();
        let bent = contours.all().map(is_bent).collect();
        Self { contours, places: contours.places(), sides, rows, bent }
    }

    /// The side that bends between two vertices, either way.
    fn bent(&self, a: usize, b: usize) -> Option<usize> {
        let side = self.sides.get(&[a, b]).or_else(|| self.sides.get(&[b, a]))?;
        self.bent[*side].then_some(*side)
    }

    fn rows(&self, from: usize, to: usize) -> Vec<[f64; 3]> {
        if let Some(&side) = self.sides.get(&[from, to]) {
            return self.rows[side].clone();
        }
        if let Some(&side) = self.sides.get(&[to, from]) {
            return self.rows[side].iter().rev().copied().collect();
        }
        [from, to].map(|v| [self.places[v].x, self.places[v].y, 1.0]).to_vec()
    }

    /// Whether the face with these corners is one: rulings along straight sides, its sense kept.
    fn is_face(&self, [a0, a1, b0, b1]: Corners) -> bool {
        if self.bent(a0, b0).is_some() || self.bent(a1, b1).is_some() {
            return false;
        }
        let low = self.rows(a0, a1);
        let high = if b0 == b1 {
            let p = self.places[b0];
            low.iter().map(|&[.., w]| [p.x * w, p.y * w, w]).collect()
        } else {
            self.rows(b0, b1)
        };
        keeps_sense(&low, &high)
    }

    /// The face of a triangle, if it has one.
    fn of_triangle(&self, triangle: [usize; 3]) -> Option<Corners> {
        let turned = |k: usize| [k, k + 1, k + 2].map(|i| triangle[i % 3]);
        let mut bent = (0..3).filter(|&k| self.bent(triangle[k], triangle[(k + 1) % 3]).is_some());
        let [a, b, c] = turned(bent.next().unwrap_or(0));
        // From the side to the opposite corner, or from either of its ends.
        [[a, b, c, c], [a, b, a, c], [a, b, c, b]].into_iter().find(|&corners| self.is_face(corners))
    }

    /// Three faces from a point inside.
    fn about_inside(&mut self, triangle: [usize; 3]) -> Option<(Point2, [Corners; 3])> {
        let middle = |points: [Point2; 3]| {
            let [x, y] = [points.map(|p| p.x), points.map(|p| p.y)].map(|c| c.iter().sum::<f64>() / 3.0);
            Point2::new(x, y)
        };
        let halfway = |k: usize| {
            let [a, b] = [triangle[k], triangle[(k + 1) % 3]];
            let curve = self.bent(a, b).and_then(|side| self.contours.all().nth(side));
            let chord =
                Point2::new(0.5 * (self.places[a].x + self.places[b].x), 0.5 * (self.places[a].y + self.places[b].y));
            curve.map_or(chord, |curve| self.contours.plane.locate(curve.point(0.5)))
        };
        let candidates = [middle(triangle.map(|v| self.places[v])), middle([0, 1, 2].map(halfway))];
        let new = self.places.len();
        for p in candidates {
            self.places.push(p);
            let faces = [0, 1, 2].map(|k: usize| [triangle[k], triangle[(k + 1) % 3], new, new]);
            if faces.iter().all(|&corners| self.is_face(corners)) {
                return Some((p, faces));
            }
            self.places.pop();
        }
        None
    }

    /// The face over two triangles beside each other: of one, and of its neighbor across the edge from its first corner to its second.
    fn of_pair(&self, [u, v, w]: [usize; 3], across: usize) -> Option<Corners> {
        [[u, across, w, v], [across, v, u, w]].into_iter().find(|&corners| self.is_face(corners))
    }
}

/// The points inside and the faces over all triangles, or the sides that are too long for them.
pub(super) fn cover(contours: &Contours<'_>) -> Result<(Vec<Point2>, Vec<Corners>), Vec<usize>> {
    let all = || (0..contours.count()).collect::<Vec<_>>();
    let mut lines = Lines::new(contours);
    let Some(triangles) = triangulate(&lines.places, &contours.rings()) else { return Err(all()) };
    let mut faces: Vec<Option<Corners>> = triangles.iter().map(|&triangle| lines.of_triangle(triangle)).collect();
    let mut free = vec![true; triangles.len()];
    let mut of_edge = BTreeMap::new();
    for (number, &[a, b, c]) in triangles.iter().enumerate() {
        of_edge.extend([([a, b], number), ([b, c], number), ([c, a], number)]);
    }
    let mut found = Vec::with_capacity(triangles.len());
    let (mut inside, mut too_long, mut failed) = (Vec::new(), Vec::new(), false);
    for number in 0..triangles.len() {
        if faces[number].is_some() || !free[number] {
            continue;
        }
        let turned = [0, 1, 2].map(|k: usize| [k, k + 1, k + 2].map(|i| triangles[number][i % 3]));
        let mut pairs: Vec<(usize, [usize; 3], usize)> = turned
            .iter()
            .filter_map(|&[u, v, w]| {
                let neighbor = *of_edge.get(&[v, u])?;
                let across = triangles[neighbor].into_iter().find(|vertex| ![u, v].contains(vertex))?;
                (free[neighbor]).then_some((neighbor, [u, v, w], across))
            })
            .collect();
        // Those that are no faces alone first.
        pairs.sort_by_key(|&(neighbor, ..)| faces[neighbor].is_some());
        let pair = pairs
            .into_iter()
            .find_map(|(neighbor, triangle, across)| Some((neighbor, lines.of_pair(triangle, across)?)));
        if let Some((neighbor, corners)) = pair {
            (free[number], free[neighbor]) = (false, false);
            faces[neighbor] = None;
            found.push(corners);
        } else if let Some((p, corners)) = lines.about_inside(triangles[number]) {
            free[number] = false;
            inside.push(p);
            found.extend(corners);
        } else {
            let [a, b, c] = triangles[number];
            too_long.extend([[a, b], [b, c], [c, a]].into_iter().filter_map(|[from, to]| lines.bent(from, to)));
            free[number] = false;
            failed = true;
        }
    }
    if failed {
        return Err(too_long);
    }
    found.extend(faces.into_iter().zip(free).filter_map(|(face, free)| face.filter(|_| free)));
    Ok((inside, found))
}
