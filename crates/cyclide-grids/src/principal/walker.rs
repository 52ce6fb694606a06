//! Walks over triangles straight in the coordinates. Where sheets lie over each other in the coordinates, a walk stays on its own.

use super::coordinates::Coordinates;
use super::jets::VertexJet;
use super::passages::Passages;
use super::sheet::Sheet;
use cyclide::{Point3, Vec3};

/// Barycentric coordinates above minus this are inside: rounding of places on edges.
const ON_EDGE: f64 = 1e-9;

/// A place on a triangle, by its coordinates there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub(super) face: usize,
    pub(super) at: [f64; 2],
}

pub(super) struct Walker<'a> {
    pub(super) sheet: &'a Sheet<'a>,
    pub(super) coordinates: &'a Coordinates,
    pub(super) passages: &'a Passages,
    /// Triangles that may be walked on.
    pub(super) open: &'a [bool],
}

impl Walker<'_> {
    /// Barycentric coordinates in the plane of the coordinates.
    fn barycentric(&self, face: usize, at: [f64; 2]) -> [f64; 3] {
        let [a, b, c] = self.coordinates.corners[face];
        let cross =
            |o: [f64; 2], p: [f64; 2], q: [f64; 2]| (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
        let whole = cross(a, b, c);
        let (first, second) = (cross(at, b, c) / whole, cross(at, c, a) / whole);
        [first, second, 1.0 - first - second]
    }

    /// The middle of a triangle.
    pub(super) fn middle(&self, face: usize) -> Place {
        let corners = self.coordinates.corners[face];
        Place { face, at: [0, 1].map(|d| corners.iter().map(|c| c[d]).sum::<f64>() / 3.0) }
    }

    /// Where a straight walk ends that goes by a step; `None` if it comes to a border, a cut or a triangle that is left out.
    pub(super) fn walk(&self, from: Place, step: [f64; 2]) -> Option<Place> {
        self.walk_turning(from, step).map(|(place, _)| place)
    }

    /// The same, and whether the coordinates at the end are turned by half a turn against those at the start.
    pub(super) fn walk_turning(&self, from: Place, step: [f64; 2]) -> Option<(Place, bool)> {
        let mut start = from.at;
        let mut goal = [from.at[0] + step[0], from.at[1] + step[1]];
        let mut face = from.face;
        let mut entered: Option<usize> = None;
        let mut turned = false;
        for _ in 0..=self.open.len() {
            let (p, q) = (self.barycentric(face, start), self.barycentric(face, goal));
            if q.iter().all(|x| *x >= -ON_EDGE) {
                return Some((Place { face, at: goal }, turned));
            }
            // The corner opposite to the edge that is passed first, not that by which the walk came in.
            let time = |k: usize| p[k].max(0.0) / (p[k].max(0.0) - q[k]);
            let out = (0..3).filter(|k| q[*k] < -ON_EDGE && Some(*k) != entered);
            let corner = out.min_by(|a, b| time(*a).total_cmp(&time(*b)))?;
            let half = 3 * face + (corner + 1) % 3;
            let other = self.sheet.across(half)?;
            if !self.open[other / 3] {
                return None;
            }
            if let Some(passage) = self.passages.over(half) {
                (start, goal) = (passage.place(start), passage.place(goal));
                turned ^= passage.turned;
            }
            face = other / 3;
            entered = Some((other + 2) % 3);
        }
        None
    }

    /// The point of the triangle at a place.
    pub(super) fn flat_point(&self, place: Place) -> Point3 {
        let weights = self.barycentric(place.face, place.at);
        let [a, b, c] = self.sheet.table.corners(place.face);
        a + (b - a) * weights[1] + (c - a) * weights[2]
    }

    /// The point of the surface at a place: that of the triangle, moved onto the fits round its corners.
    pub(super) fn point(&self, place: Place, jets: &[VertexJet]) -> Point3 {
        let weights = self.barycentric(place.face, place.at);
        let flat = self.flat_point(place);
        let table = self.sheet.table;
        let corners = table.triangles[place.face];
        let fitted =
            (0..3).try_fold(Vec3::ZERO, |sum, k| jets[corners[k]].above(flat).map(|p| sum + (p - flat) * weights[k]));
        // A fit that leaves the triangle by much knows nothing of it.
        let limit = 0.25 * table.areas[place.face].sqrt();
        fitted.filter(|offset| offset.length() <= limit).map_or(flat, |offset| flat + offset)
    }
}
