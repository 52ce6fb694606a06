//! Triangles that are one piece of a surface with a border: half edges, fans of vertices, loops of the border.

use std::collections::HashMap;

use cyclide::{Point3, Vec3};
use cyclide::{
    Result,
    error::{MeshError, PrincipalGridError, SurfaceFault},
};

/// No half edge: the border.
pub(super) const NONE: usize = usize::MAX;

/// Triangles with their neighbors. Half edge `3 f + k` runs from corner `k` of triangle `f` to the next.
#[derive(Debug, Clone)]
pub(super) struct MeshTable {
    pub(super) points: Vec<Point3>,
    pub(super) triangles: Vec<[usize; 3]>,
    /// The half edge that runs the other way.
    twin: Vec<usize>,
    /// Of each vertex a half edge that leaves it; on the border the one along the border.
    leaving: Vec<usize>,
    /// The half edges of each loop of the border, with the surface on their left.
    pub(super) borders: Vec<Vec<usize>>,
    /// Normals of length 1 and areas of the triangles.
    pub(super) normals: Vec<Vec3>,
    pub(super) areas: Vec<f64>,
}

impl MeshTable {
    /// Points that no triangle uses are left out.
    ///
    /// # Errors
    /// `no-triangles`, `no-such-vertex`, `not-a-surface`.
    pub(super) fn new(points: &[Point3], triangles: &[[usize; 3]]) -> Result<Self> {
        if triangles.is_empty() {
            return Err(MeshError::NoTriangles { vertices: points.len(), needed: 1 }.into());
        }
        let count = points.len();
        let mut number = vec![NONE; count];
        for (triangle, corners) in triangles.iter().enumerate() {
            for &vertex in corners {
                *number.get_mut(vertex).ok_or(MeshError::NoSuchVertex { triangle, vertex, count })? = 0;
            }
        }
        let mut used = Vec::new();
        for (v, p) in points.iter().enumerate().filter(|(v, _)| number[*v] != NONE).collect::<Vec<_>>() {
            number[v] = used.len();
            used.push(*p);
        }
        let (points, triangles) = (used, triangles.iter().map(|t| t.map(|v| number[v])).collect::<Vec<_>>());
        let twin = twins(&triangles)?;
        let leaving = leaving(&triangles, &twin, points.len())?;
        let mut table =
            Self { points, triangles, twin, leaving, borders: Vec::new(), normals: Vec::new(), areas: Vec::new() };
        table.check_in_one_piece()?;
        table.find_borders()?;
        for f in 0..table.triangles.len() {
            let [a, b, c] = table.corners(f);
            let double = (b - a).cross(c - a);
            let normal =
                double.unit().ok_or(PrincipalGridError::NotASurface { fault: SurfaceFault::NoArea, index: f })?;
            table.normals.push(normal);
            table.areas.push(0.5 * double.length());
        }
        Ok(table)
    }

    pub(super) fn corners(&self, f: usize) -> [Point3; 3] {
        self.triangles[f].map(|v| self.points[v])
    }

    pub(super) fn centroid(&self, f: usize) -> Point3 {
        let [a, b, c] = self.corners(f);
        a + ((b - a) + (c - a)) / 3.0
    }

    /// Where a half edge starts and ends.
    pub(super) fn ends(&self, half: usize) -> [usize; 2] {
        let corners = self.triangles[half / 3];
        [corners[half % 3], corners[(half + 1) % 3]]
    }

    pub(super) fn vector(&self, half: usize) -> Vec3 {
        let [from, to] = self.ends(half);
        self.points[to] - self.points[from]
    }

    /// The half edge that runs the other way; [`NONE`] on the border.
    pub(super) fn twin(&self, half: usize) -> usize {
        self.twin[half]
    }

    /// The half edges that leave a vertex, counter-clockwise; on the border from the border on.
    pub(super) fn fan(&self, vertex: usize) -> impl Iterator<Item = usize> + '_ {
        let first = self.leaving[vertex];
        let mut next = Some(first);
        std::iter::from_fn(move || {
            let half = next?;
            next = Some(self.twin[before(half)]).filter(|next| *next != NONE && *next != first);
            Some(half)
        })
    }

    pub(super) fn is_on_border(&self, vertex: usize) -> bool {
        self.twin[self.leaving[vertex]] == NONE
    }

    /// The angle of a triangle at the start of a half edge.
    pub(super) fn angle(&self, half: usize) -> f64 {
        self.vector(half).angle(-self.vector(before(half)))
    }

    /// Each edge inside once, by its lower half edge.
    pub(super) fn inner_edges(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.twin.len()).filter(|&half| self.twin[half] != NONE && half < self.twin[half])
    }

    /// Each edge once, by a half edge.
    pub(super) fn edges(&self) -> impl Iterator<Item = usize> + '_ {
        // On the border the twin is larger than all.
        (0..self.twin.len()).filter(|&half| half < self.twin[half])
    }

    /// Normals of the vertices: those of the triangles, weighted by area.
    pub(super) fn vertex_normals(&self) -> Vec<Vec3> {
        let mut sums = vec![Vec3::ZERO; self.points.len()];
        for (f, corners) in self.triangles.iter().enumerate() {
            corners.iter().for_each(|&v| sums[v] += self.normals[f] * self.areas[f]);
        }
        let fallback = |v: usize| self.normals[self.leaving[v] / 3];
        sums.iter().enumerate().map(|(v, sum)| sum.unit().unwrap_or_else(|| fallback(v))).collect()
    }

    /// The same triangles over moved vertices.
    ///
    /// # Errors
    /// `not-a-surface`: a triangle has lost its area.
    pub(super) fn moved(&self, points: &[Point3]) -> Result<Self> {
        Self::new(points, &self.triangles)
    }

    fn check_in_one_piece(&self) -> Result<()> {
        let mut seen = vec![false; self.triangles.len()];
        let mut stack = vec![0];
        seen[0] = true;
        while let Some(f) = stack.pop() {
            for half in 3 * f..3 * f + 3 {
                let other = self.twin[half];
                if other != NONE && !seen[other / 3] {
                    seen[other / 3] = true;
                    stack.push(other / 3);
                }
            }
        }
        match seen.iter().position(|seen| !seen) {
            Some(index) => Err(PrincipalGridError::NotASurface { fault: SurfaceFault::Apart, index }.into()),
            None => Ok(()),
        }
    }

    fn find_borders(&mut self) -> Result<()> {
        let mut seen = vec![false; self.twin.len()];
        for start in 0..self.twin.len() {
            if self.twin[start] != NONE || seen[start] {
                continue;
            }
            let mut border = Vec::new();
            let mut half = start;
            while !seen[half] {
                seen[half] = true;
                border.push(half);
                half = self.leaving[self.ends(half)[1]];
            }
            self.borders.push(border);
        }
        if self.borders.is_empty() {
            return Err(PrincipalGridError::NotASurface { fault: SurfaceFault::NoBorder, index: 0 }.into());
        }
        // V - E + F = 2 - 2 handles - borders.
        let euler = (self.points.len() + self.triangles.len()) as i64 - self.edges().count() as i64;
        if euler + self.borders.len() as i64 != 2 {
            return Err(PrincipalGridError::NotASurface { fault: SurfaceFault::Handles, index: 0 }.into());
        }
        Ok(())
    }
}

/// The half edge of the same triangle that ends where this one starts.
pub(super) fn before(half: usize) -> usize {
    half - half % 3 + (half + 2) % 3
}

fn twins(triangles: &[[usize; 3]]) -> Result<Vec<usize>> {
    let ends = |half: usize| {
        let corners: [usize; 3] = triangles[half / 3];
        (corners[half % 3], corners[(half + 1) % 3])
    };
    let mut by_ends = HashMap::with_capacity(3 * triangles.len());
    for half in 0..3 * triangles.len() {
        let (from, to) = ends(half);
        if from == to {
            return Err(PrincipalGridError::NotASurface { fault: SurfaceFault::NoArea, index: half / 3 }.into());
        }
        if let Some(first) = by_ends.insert((from, to), half) {
            // Twice the same way: turned over, or one of more than two.
            let opposite = (0..3 * triangles.len()).filter(|&h| ends(h) == (to, from)).count();
            let same = (0..3 * triangles.len()).filter(|&h| ends(h) == (from, to)).count();
            let fault = if same + opposite == 2 { SurfaceFault::TurnedOver } else { SurfaceFault::EdgeOfMany };
            return Err(PrincipalGridError::NotASurface { fault, index: half.max(first) / 3 }.into());
        }
    }
    let twin = |half: usize| {
        let (from, to) = ends(half);
        by_ends.get(&(to, from)).copied().unwrap_or(NONE)
    };
    Ok((0..3 * triangles.len()).map(twin).collect())
}

/// A half edge that leaves each vertex; the triangles round it must be one fan.
fn leaving(triangles: &[[usize; 3]], twin: &[usize], count: usize) -> Result<Vec<usize>> {
    let mut leaving = vec![NONE; count];
    let mut uses = vec![0; count];
    for half in 0..3 * triangles.len() {
        let vertex = triangles[half / 3][half % 3];
        uses[vertex] += 1;
        if leaving[vertex] == NONE || twin[half] == NONE {
            leaving[vertex] = half;
        }
    }
    for vertex in 0..count {
        let first = leaving[vertex];
        let (mut half, mut round) = (first, 1);
        loop {
            half = twin[before(half)];
            if half == NONE || half == first || round > uses[vertex] {
                break;
            }
            round += 1;
        }
        if round != uses[vertex] {
            return Err(PrincipalGridError::NotASurface { fault: SurfaceFault::Pinched, index: first / 3 }.into());
        }
    }
    Ok(leaving)
}
