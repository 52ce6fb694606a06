//! Meshes of triangles made of the polygons of a file, with what was changed on the way.

use std::collections::HashMap;

use cyclide::{Point3, Vec3};

use crate::input::exported_faces::{Counted, Doubled, turned_over};
use crate::input::polygon_mesh::PolygonMesh;

/// Polygons with more corners are not cut: the work grows with the cube of their number.
const MOST_CORNERS: usize = 256;

/// A mesh of triangles, and how it came of polygons.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct TriangleMesh {
    /// Points that triangles use, no two of them equal.
    pub(crate) points: Vec<Point3>,
    /// The number in the file of each of these, or of the first of several that are equal.
    pub(crate) vertices: Vec<usize>,
    pub(crate) triangles: Vec<[usize; 3]>,
    /// Normals of the corners, if the file has them.
    pub(crate) normals: Option<Vec<[Vec3; 3]>>,
    /// The polygon of each triangle, by its number in the file.
    pub(crate) polygons: Vec<usize>,
    /// Points that were equal to others, or that no polygon uses.
    pub(crate) merged: usize,
    pub(crate) unused: usize,
    /// Polygons that were cut, and those of which two corners at most are different, with the first of each.
    pub(crate) cut: Counted,
    pub(crate) collapsed: Counted,
    /// Polygons that were turned over, to agree with most of their neighbors.
    pub(crate) turned: Counted,
}

/// Polygons that do not make a mesh of triangles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BadPolygons {
    /// One that cannot be cut into triangles.
    Uncut { polygon: usize, corners: usize },
    /// Some with the same vertices as others.
    Doubled(Doubled),
}

impl TriangleMesh {
    /// Cuts polygons into triangles, makes equal points one, and leaves out what has no area for want of different corners.
    ///
    /// # Errors
    /// A polygon that crosses itself, or has more than 256 corners; one that is there twice.
    pub(crate) fn new(given: &PolygonMesh) -> Result<Self, BadPolygons> {
        let (points, same) = distinct(&given.points);
        let mut mesh = Self { merged: given.points.len() - points.len(), ..Self::default() };
        let with_normals = given.corner_normals.len() == given.faces.len() && !given.normals.is_empty();
        let mut normals = Vec::new();
        let mut triangles: Vec<[usize; 3]> = Vec::new();
        let mut loops = Vec::with_capacity(given.faces.len());
        for (index, face) in given.faces.iter().enumerate() {
            // Corners by their place in the polygon, without those at the same point as the one before.
            let mut loop_of: Vec<usize> = (0..face.len()).collect();
            loop_of.dedup_by_key(|k| same[face[*k]]);
            while loop_of.len() > 1 && same[face[loop_of[0]]] == same[face[loop_of[loop_of.len() - 1]]] {
                loop_of.pop();
            }
            if loop_of.len() < 3 {
                mesh.collapsed.add(index);
            } else {
                loops.push((index, loop_of));
            }
        }
        let corners_of =
            |(index, loop_of): &(usize, Vec<usize>)| loop_of.iter().map(|k| same[given.faces[*index][*k]]).collect();
        let corners: Vec<Vec<usize>> = loops.iter().map(corners_of).collect();
        if let Some(found) = Doubled::among(&corners) {
            return Err(BadPolygons::Doubled(Doubled { faces: found.faces.map(|k| loops[k].0), ..found }));
        }
        for ((index, mut loop_of), turned) in loops.into_iter().zip(turned_over(&corners)) {
            let face = &given.faces[index];
            if turned {
                loop_of.reverse();
                mesh.turned.add(index);
            }
            if loop_of.len() > 3 {
                mesh.cut.add(index);
            }
            let place = |k: usize| points[same[face[loop_of[k]]]];
            let uncut = BadPolygons::Uncut { polygon: index, corners: loop_of.len() };
            for ear in cut(&(0..loop_of.len()).map(place).collect::<Vec<_>>()).ok_or(uncut)? {
                let corners = ear.map(|k| loop_of[k]);
                triangles.push(corners.map(|k| same[face[k]]));
                mesh.polygons.push(index);
                if with_normals {
                    normals.push(corners.map(|k| given.normals[given.corner_normals[index][k]]));
                }
            }
        }
        mesh.normals = with_normals.then_some(normals);
        mesh.keep_used(&points, &same, triangles);
        Ok(mesh)
    }

    /// Takes over the points that triangles use.
    fn keep_used(&mut self, points: &[Point3], same: &[usize], triangles: Vec<[usize; 3]>) {
        let mut used = vec![false; points.len()];
        triangles.iter().flatten().for_each(|&v| used[v] = true);
        let mut first = vec![usize::MAX; points.len()];
        same.iter().enumerate().rev().for_each(|(given, &point)| first[point] = given);
        let mut number = vec![0; points.len()];
        for (index, p) in points.iter().enumerate().filter(|(index, _)| used[*index]) {
            number[index] = self.points.len();
            self.points.push(*p);
            self.vertices.push(first[index]);
        }
        self.unused = points.len() - self.points.len();
        self.triangles = triangles.into_iter().map(|t| t.map(|v| number[v])).collect();
    }
}

/// The points without those that are equal to one before, and the number of each given point among them.
pub(crate) fn distinct(points: &[Point3]) -> (Vec<Point3>, Vec<usize>) {
    let mut number: HashMap<[u64; 3], usize> = HashMap::with_capacity(points.len());
    let mut kept: Vec<Point3> = Vec::new();
    // 0 and -0 are the same.
    let same = points.iter().map(|p| {
        *number.entry(p.to_array().map(|x| (x + 0.0).to_bits())).or_insert_with(|| {
            kept.push(*p);
            kept.len() - 1
        })
    });
    let same = same.collect();
    (kept, same)
}

/// Cuts a polygon into triangles, ear by ear: that with the shortest cut first. `None` if it crosses itself or is too long.
fn cut(points: &[Point3]) -> Option<Vec<[usize; 3]>> {
    if points.len() == 3 {
        return Some(vec![[0, 1, 2]]);
    }
    if points.len() > MOST_CORNERS {
        return None;
    }
    // The direction of the vector area: the sense of the whole. Of length 1, or products of areas would be nothing in tiny units.
    let from = |k: usize| points[k] - points[0];
    let area = (1..points.len() - 1).fold(Vec3::ZERO, |sum, k| sum + from(k).cross(from(k + 1))).unit()?;
    let mut rest: Vec<usize> = (0..points.len()).collect();
    let mut ears = Vec::with_capacity(points.len() - 2);
    while rest.len() > 3 {
        let n = rest.len();
        let ear = |k: usize| [rest[(k + n - 1) % n], rest[k], rest[(k + 1) % n]];
        let cuts = (0..n).filter(|&k| is_ear(points, &rest, ear(k), area));
        let length = |k: usize| points[ear(k)[0]].distance(points[ear(k)[2]]);
        let best = cuts.min_by(|a, b| length(*a).total_cmp(&length(*b)))?;
        ears.push(ear(best));
        rest.remove(best);
    }
    ears.push([rest[0], rest[1], rest[2]]);
    Some(ears)
}

/// Whether three corners that follow each other are a triangle of the polygon: they turn with the whole, and none of the others is in it.
fn is_ear(points: &[Point3], rest: &[usize], ear: [usize; 3], area: Vec3) -> bool {
    let [a, b, c] = ear.map(|k| points[k]);
    let turns = |a: Point3, b: Point3, c: Point3| (b - a).cross(c - a).dot(area);
    if !(turns(a, b, c) > 0.0) {
        return false;
    }
    let inside = |p: Point3| turns(a, b, p) >= 0.0 && turns(b, c, p) >= 0.0 && turns(c, a, p) >= 0.0;
    !rest.iter().any(|k| !ear.contains(k) && inside(points[*k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane(points: &[[f64; 2]]) -> Vec<Point3> {
        points.iter().map(|[x, y]| Point3::new(*x, *y, 0.5)).collect()
    }

    /// Area of the triangles in the direction of the third axis.
    fn area(points: &[Point3], triangles: &[[usize; 3]]) -> f64 {
        triangles.iter().map(|t| t.map(|k| points[k])).map(|[a, b, c]| 0.5 * (b - a).cross(c - a).z).sum()
    }

    #[test]
    fn polygons_are_cut_along_short_lines_inside() {
        // A long quad; an arrow whose long diagonal is outside; an L.
        let quad = plane(&[[0.0, 0.0], [4.0, -1.0], [5.0, 0.0], [1.0, 1.0]]);
        let cuts = cut(&quad).unwrap();
        assert!(cuts.iter().all(|t| !(t.contains(&0) && t.contains(&2))), "{cuts:?}");
        let arrow = plane(&[[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [1.0, 2.0]]);
        let l = plane(&[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]]);
        for (points, whole) in [(quad, 5.0), (arrow, 6.0), (l, 5.0)] {
            let cuts = cut(&points).unwrap();
            assert_eq!(cuts.len(), points.len() - 2);
            let single = cuts.iter().map(|t| area(&points, &[*t]));
            assert!(single.clone().all(|part| part > 0.0), "{cuts:?}");
            assert!((single.sum::<f64>() - whole).abs() < 1e-12);
        }
        assert_eq!(cut(&plane(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]])), None, "crossing itself");
        // The unit changes nothing, however tiny or huge.
        let quad = [[0.0, 0.0], [4.0, -1.0], [5.0, 0.0], [1.0, 1.0]];
        for unit in [1e-150, 1e150] {
            assert_eq!(cut(&quad.map(|[x, y]| Point3::new(x * unit, y * unit, 0.0))), cut(&plane(&quad)), "{unit}");
        }
    }

    #[test]
    fn what_was_changed_is_counted() {
        let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [-0.0, 0.0], [9.0, 9.0]];
        let faces = vec![vec![0, 1, 2, 3], vec![0, 4, 1], vec![4, 3, 0], vec![4, 0, 3, 2]];
        let given = PolygonMesh { points: plane(&points), faces, ..PolygonMesh::default() };
        let mesh = TriangleMesh::new(&given).unwrap();
        assert_eq!((mesh.points.len(), mesh.merged, mesh.unused), (4, 1, 1));
        assert_eq!(mesh.polygons, [0, 0, 3]);
        assert_eq!(mesh.vertices, [0, 1, 2, 3]);
        assert_eq!(mesh.cut, Counted { first: 0, count: 1 });
        assert_eq!(mesh.collapsed, Counted { first: 1, count: 2 });
        assert_eq!(mesh.triangles[2], [0, 3, 2]);
        assert!(mesh.normals.is_none());
    }

    #[test]
    fn normals_stay_with_their_corners() {
        let points = plane(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]);
        let normals = [1.0, 2.0, 3.0].map(|z| Vec3::new(0.0, 0.0, z)).to_vec();
        let (faces, corner_normals) = (vec![vec![0, 3, 1, 2]], vec![vec![0, 1, 2, 1]]);
        let mesh =
            TriangleMesh::new(&PolygonMesh { points, faces, normals, corner_normals, lines: Vec::new() }).unwrap();
        let at = |t: [usize; 3], n: [Vec3; 3]| t.into_iter().zip(n.map(|n| n.z as usize)).collect::<Vec<_>>();
        let mut corners = at(mesh.triangles[0], mesh.normals.unwrap()[0]);
        corners.sort_unstable();
        assert_eq!(corners, [(0, 1), (1, 3), (2, 2)]);
    }
}
