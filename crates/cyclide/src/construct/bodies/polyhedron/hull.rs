//! The convex hull of points: triangles by quickhull (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, *The quickhull algorithm for
//! convex hulls*, 1996). On which side of a triangle a point is, is decided exactly (J. R. Shewchuk, *Adaptive precision
//! floating-point arithmetic and fast robust geometric predicates*, 1997), so that nothing is found by tolerance: points in
//! the plane of a triangle are not outside it, and the triangles of a flat side are made one afterwards.

use super::faces::FaceSide;
use super::plane::{flat, rounding};
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use robust::{Coord3D, orient3d};

/// The triangles of the hull, counter-clockwise from outside.
///
/// # Errors
/// `flat-polyhedron`.
pub(super) fn triangles(points: &[Point3]) -> Result<Vec<Vec<usize>>> {
    let largest = points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    // Times a power of two, which is exact: products of four coordinates stay in range.
    let scale = if largest > 0.0 { (-largest.log2().floor()).exp2() } else { 1.0 };
    let scaled: Vec<Point3> = points.iter().map(|p| Point3::ORIGIN + p.to_vec() * scale).collect();
    let four = four_apart(&scaled).map_err(|normal| flat(points.iter().copied(), normal, rounding(points)))?;
    let mut hull = Hull::around_four(&scaled, four);
    while let Some(triangle) = hull.open.pop() {
        if hull.triangles[triangle].is_kept {
            hull.add_farthest(triangle);
        }
    }
    Ok(hull
        .triangles
        .into_iter()
        .filter(|triangle| triangle.is_kept)
        .map(|triangle| triangle.corners.to_vec())
        .collect())
}

struct Triangle {
    corners: [usize; 3],
    /// The neighbors across its sides, from each corner to the next one.
    across: [FaceSide; 3],
    /// Points outside that no other triangle has, the farthest one last.
    outside: Vec<usize>,
    is_kept: bool,
    /// The point from which it was last seen.
    seen_from: Option<usize>,
}

struct Hull<'a> {
    points: &'a [Point3],
    triangles: Vec<Triangle>,
    /// Triangles that may have points outside.
    open: Vec<usize>,
}

impl<'a> Hull<'a> {
    /// Of four points that are far apart.
    fn around_four(points: &'a [Point3], corners: [usize; 4]) -> Self {
        let mut hull = Self { points, triangles: Vec::new(), open: Vec::new() };
        let [a, b, c, d] = corners;
        for (corners, across) in [
            ([a, b, c], [(1, 0), (2, 0), (3, 0)]),
            ([b, a, d], [(0, 0), (3, 2), (2, 1)]),
            ([c, b, d], [(0, 1), (1, 2), (3, 1)]),
            ([a, c, d], [(0, 2), (2, 2), (1, 1)]),
        ] {
            hull.push(corners, across.map(|(face, side)| FaceSide { face, side }));
        }
        let rest = (0..points.len()).filter(|k| !corners.contains(k)).collect();
        hull.hand_out(rest, 0);
        hull
    }

    fn push(&mut self, corners: [usize; 3], across: [FaceSide; 3]) {
        self.open.push(self.triangles.len());
        self.triangles.push(Triangle { corners, across, outside: Vec::new(), is_kept: true, seen_from: None });
    }

    fn is_outside(&self, triangle: usize, point: usize) -> bool {
        let [a, b, c] = self.triangles[triangle].corners.map(|k| self.points[k]);
        side(a, b, c, self.points[point]) > 0.0
    }

    /// Gives each point to a triangle, of those with this number or a larger one, outside which it is; points inside are forgotten.
    fn hand_out(&mut self, points: Vec<usize>, from: usize) {
        for point in points {
            if let Some(triangle) = (from..self.triangles.len()).find(|&triangle| self.is_outside(triangle, point)) {
                self.triangles[triangle].outside.push(point);
            }
        }
        for triangle in &mut self.triangles[from..] {
            let height = |k: usize| height(self.points, triangle.corners, k);
            let farthest = (0..triangle.outside.len())
                .max_by(|&i, &j| height(triangle.outside[i]).total_cmp(&height(triangle.outside[j])));
            if let Some(farthest) = farthest {
                let last = triangle.outside.len() - 1;
                triangle.outside.swap(farthest, last);
            }
        }
    }

    /// Takes the farthest point outside a triangle in.
    fn add_farthest(&mut self, triangle: usize) {
        let Some(point) = self.triangles[triangle].outside.pop() else { return };
        let (seen, horizon) = self.seen_from(point, triangle);
        let first = self.triangles.len();
        let count = horizon.len();
        for (k, &beyond) in horizon.iter().enumerate() {
            // The side as the triangle that stays has it, which the new one runs along the other way.
            let corners = &self.triangles[beyond.face].corners;
            let (from, to) = (corners[(beyond.side + 1) % 3], corners[beyond.side]);
            let next = FaceSide { face: first + (k + 1) % count, side: 2 };
            let before = FaceSide { face: first + (k + count - 1) % count, side: 1 };
            self.push([from, to, point], [beyond, next, before]);
            self.triangles[beyond.face].across[beyond.side] = FaceSide { face: first + k, side: 0 };
        }
        let mut orphans = Vec::new();
        for triangle in seen {
            self.triangles[triangle].is_kept = false;
            orphans.append(&mut self.triangles[triangle].outside);
        }
        self.hand_out(orphans, first);
    }

    /// The triangles outside which a point is, and the sides beyond them, counter-clockwise, as those have them that stay.
    fn seen_from(&mut self, point: usize, triangle: usize) -> (Vec<usize>, Vec<FaceSide>) {
        self.triangles[triangle].seen_from = Some(point);
        let (mut seen, mut horizon) = (vec![triangle], Vec::new());
        // Sides still to be looked across, the next one last: depth first, their order is that round the horizon.
        let sides = |hull: &Self, triangle: usize, from: usize| {
            [2, 1, 0].map(|k| hull.triangles[triangle].across[(from + k) % 3])
        };
        let mut open = sides(self, triangle, 0).to_vec();
        while let Some(beyond) = open.pop() {
            if self.triangles[beyond.face].seen_from == Some(point) {
                continue;
            }
            if self.is_outside(beyond.face, point) {
                self.triangles[beyond.face].seen_from = Some(point);
                seen.push(beyond.face);
                open.extend(&sides(self, beyond.face, beyond.side + 1)[1..]);
            } else {
                horizon.push(beyond);
            }
        }
        (seen, horizon)
    }
}

/// Positive where `p` is on the side from which `a, b, c` are counter-clockwise; the sign is exact.
fn side(a: Point3, b: Point3, c: Point3, p: Point3) -> f64 {
    let [a, b, c, p] = [a, b, c, p].map(|p| Coord3D { x: p.x, y: p.y, z: p.z });
    -orient3d(a, b, c, p)
}

/// Height above a triangle times twice its area, to choose by.
fn height(points: &[Point3], corners: [usize; 3], k: usize) -> f64 {
    let [a, b, c] = corners.map(|corner| points[corner]);
    (b - a).cross(c - a).dot(points[k] - a)
}

/// Four points that are not in one plane, far apart, of which the first three are clockwise from the fourth; the normal of the plane that
/// all are in, if there are none.
fn four_apart(points: &[Point3]) -> std::result::Result<[usize; 4], Vec3> {
    let farthest = |measure: &dyn Fn(Point3) -> f64| {
        (0..points.len()).max_by(|&i, &j| measure(points[i]).total_cmp(&measure(points[j]))).unwrap_or(0)
    };
    let a = farthest(&|p| -p.x);
    let b = farthest(&|p| p.distance(points[a]));
    let chord = points[b] - points[a];
    let c = farthest(&|p| (p - points[a]).cross(chord).length());
    let normal: Vec3 = chord.cross(points[c] - points[a]);
    let d = farthest(&|p| (p - points[a]).dot(normal).abs());
    let sign = side(points[a], points[b], points[c], points[d]);
    match sign {
        s if s < 0.0 => Ok([a, b, c, d]),
        s if s > 0.0 => Ok([b, a, c, d]),
        _ => Err(normal),
    }
}
