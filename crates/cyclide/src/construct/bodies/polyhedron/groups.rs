//! Which faces are in one plane, where coordinates have few digits (`docs/math/polyhedron-offsets.md#one-plane`).
//!
//! A face joins a plane if its corners are near it *and* its normal agrees: of a wall that is cut into low faces the corners of the
//! highest ones are near the roof too. What is so narrow that its normal is rounding forms planes of its own first, and these join
//! a larger neighbor if all of their corners are near it.

use super::faces::{FaceSide, Faces};
use super::plane::{Plane, area_vector};
use crate::base::vector::{Point3, Vec3};

/// Normals at a larger angle than 30 degrees are of two planes, as a cosine: faces that rounding turns by more are narrower than four
/// times the rounding.
const AGREE: f64 = 0.866;
/// Rounds in which a plane is fitted to the faces found with it: each reaches several times as far as the one before.
const MOST_FITS: usize = 8;

/// The number of the plane of each face, counted in the order of their first faces.
pub(super) fn groups(points: &[Point3], faces: &Faces, within: f64) -> Vec<usize> {
    let mut planar = Planar::new(points, faces, within);
    planar.flood_all();
    planar.absorb_narrow();
    in_order(&planar.group)
}

/// Faces on their way to planes.
struct Planar<'a> {
    points: &'a [Point3],
    faces: &'a Faces,
    areas: Vec<Vec3>,
    within: f64,
    /// The first face of the plane of each face.
    group: Vec<Option<usize>>,
    /// What is known of the plane of each first face.
    found: Vec<Option<Found>>,
}

/// A plane with its faces.
struct Found {
    faces: Vec<usize>,
    /// Of all of them together.
    area: f64,
    /// None where that is nothing.
    plane: Option<Plane>,
}

impl<'a> Planar<'a> {
    fn new(points: &'a [Point3], faces: &'a Faces, within: f64) -> Self {
        let areas: Vec<Vec3> = faces.loops().iter().map(|corners| area_vector(points, corners)).collect();
        let count = areas.len();
        Self { points, faces, areas, within, group: vec![None; count], found: (0..count).map(|_| None).collect() }
    }

    /// Planes from the largest faces on.
    fn flood_all(&mut self) {
        let mut largest_first: Vec<usize> = (0..self.areas.len()).collect();
        let size = |face: &usize| self.areas[*face].length_squared();
        largest_first.sort_by(|a, b| size(b).total_cmp(&size(a)).then(a.cmp(b)));
        for seed in largest_first {
            if self.group[seed].is_some() {
                continue;
            }
            let found = self.around(seed);
            for &face in &found.faces {
                self.group[face] = Some(seed);
            }
            self.found[seed] = Some(found);
        }
    }

    /// The plane of a face, fitted to all that are found with it: that of one triangle is known less well.
    fn around(&self, seed: usize) -> Found {
        let mut found = vec![seed];
        let mut plane = Plane::of_loop(self.points, &self.faces.loops()[seed]);
        for _ in 0..MOST_FITS {
            let Some(old) = plane else { break };
            let next = self.flood(seed, &old);
            let is_settled = next.len() == found.len();
            found = next;
            if found.len() > 1 {
                plane = self.fitted(&found);
            }
            if is_settled {
                break;
            }
        }
        let area = found.iter().fold(Vec3::ZERO, |sum, &face| sum + self.areas[face]).length();
        Found { faces: found, area, plane }
    }

    fn fitted(&self, found: &[usize]) -> Option<Plane> {
        let corners = found.iter().flat_map(|&face| self.faces.loops()[face].iter().map(|&v| self.points[v]));
        let normal = found.iter().fold(Vec3::ZERO, |sum, &face| sum + self.areas[face]);
        Plane::through_middle(corners, normal)
    }

    /// The faces that hang together with one and are in a plane, of those that are in none yet.
    fn flood(&self, seed: usize, plane: &Plane) -> Vec<usize> {
        let belongs = |face: usize| {
            let area = self.areas[face];
            area.dot(plane.normal) > AGREE * area.length() && self.farthest(face, plane) <= self.within
        };
        let mut found = vec![seed];
        let mut seen: std::collections::HashSet<usize> = [seed].into();
        let mut next = 0;
        while let Some(&face) = found.get(next) {
            next += 1;
            for beside in self.beside(face) {
                if self.group[beside].is_none() && belongs(beside) && seen.insert(beside) {
                    found.push(beside);
                }
            }
        }
        found
    }

    fn beside(&self, face: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.faces.loops()[face].len()).map(move |side| self.faces.across(FaceSide { face, side }).face)
    }

    /// The largest distance of a corner of a face from a plane.
    fn farthest(&self, face: usize, plane: &Plane) -> f64 {
        let corners = self.faces.loops()[face].iter();
        corners.map(|&v| plane.distance(self.points[v]).abs()).fold(0.0, f64::max)
    }

    /// Planes whose faces are all near a larger one beside them become part of it, the smallest first.
    fn absorb_narrow(&mut self) {
        loop {
            let size = |group: usize| self.found[group].as_ref().map_or(0.0, |found| found.area);
            let mut smallest_first: Vec<usize> = (0..self.found.len()).filter(|&k| self.found[k].is_some()).collect();
            smallest_first.sort_by(|&a, &b| size(a).total_cmp(&size(b)).then(b.cmp(&a)));
            let before = smallest_first.len();
            let absorbed = smallest_first.into_iter().filter(|&narrow| self.absorb(narrow)).count();
            if absorbed == 0 || absorbed == before {
                return;
            }
        }
    }

    /// Makes a plane part of the nearest one that is larger and near to all of its corners, if there is one.
    fn absorb(&mut self, narrow: usize) -> bool {
        let Some(own) = self.found[narrow].take() else { return false };
        let mut nearest: Option<(f64, usize)> = None;
        let beside = own.faces.iter().flat_map(|&face| self.beside(face)).filter_map(|face| self.group[face]);
        let mut beside: Vec<usize> = beside.filter(|&group| group != narrow).collect();
        beside.sort_unstable();
        beside.dedup();
        for group in beside {
            let Some(other) = &self.found[group] else { continue };
            let Some(plane) = other.plane.filter(|_| (other.area, narrow) > (own.area, group)) else { continue };
            let mut far: f64 = 0.0;
            for &face in &own.faces {
                far = far.max(self.farthest(face, &plane));
                if far > self.within {
                    break;
                }
            }
            if far <= self.within && nearest.is_none_or(|(least, _)| far < least) {
                nearest = Some((far, group));
            }
        }
        let target = nearest.and_then(|(_, group)| Some((group, self.found[group].as_mut()?)));
        let Some((group, larger)) = target else {
            self.found[narrow] = Some(own);
            return false;
        };
        own.faces.iter().for_each(|&face| self.group[face] = Some(group));
        larger.faces.extend(own.faces);
        true
    }
}

/// Numbers from 0 in the order of the first faces.
fn in_order(group: &[Option<usize>]) -> Vec<usize> {
    let mut number: Vec<Option<usize>> = vec![None; group.len()];
    let mut next = 0;
    let numbered = group.iter().enumerate().map(|(face, seed)| {
        *number[seed.unwrap_or(face)].get_or_insert_with(|| {
            next += 1;
            next - 1
        })
    });
    numbered.collect()
}
