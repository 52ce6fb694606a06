//! Cells become polygons.

use super::cuts::Cuts;
use super::strips::{SAME_CUT, Strips, point_lines};
use super::vertices::{BorderVertices, compact};
use crate::base::vector::{Point3, Vec3};
use crate::mesh::surface_mesh::{MeshCorner, MeshFace, MeshSource, SurfaceMesh};
use crate::surface::ParamSurface as _;
use crate::topology::{FaceGeometry as _, FaceSurface, Shell, ShellFace};

/// Appends the cells of a shell to the mesh. Returns how far vertices shared with other faces are off the patches.
pub(super) fn assemble(shell: &Shell, index: usize, strips: &Strips, cuts: &Cuts, mesh: &mut SurfaceMesh) -> f64 {
    let base = mesh.positions.len();
    let mut border = BorderVertices::new(shell, strips, cuts, mesh);
    // Made when they are needed: kept, they would be larger than the mesh of a net of many small patches.
    let grids = || {
        shell.faces().iter().zip(&strips.faces).map(|(face, places)| {
            let [s, t] = places.map(|place| cuts.at(place));
            FaceGrid::new(face, s, t)
        })
    };
    let mut joined = false;
    for grid in grids() {
        joined |= grid.join_points(&mut border);
    }
    let cells: usize =
        strips.faces.iter().map(|places| places.map(|place| cuts.count(place)).iter().product::<usize>()).sum();
    // About one vertex and one normal per cell.
    mesh.positions.reserve(cells);
    mesh.normals.reserve(cells);
    mesh.faces.reserve(cells);
    mesh.sources.reserve(cells);
    let mut gap = 0.0_f64;
    for (f, grid) in grids().enumerate() {
        gap = gap.max(grid.emit(&mut border, [index, f], mesh));
    }
    if joined {
        compact(mesh, base);
    }
    gap
}

/// A face with its cuts.
struct FaceGrid<'a> {
    face: &'a ShellFace,
    s: Vec<f64>,
    t: Vec<f64>,
    /// Whether the t-line at each s, the s-line at each t, is one point.
    points: [Vec<bool>; 2],
}

impl<'a> FaceGrid<'a> {
    fn new(face: &'a ShellFace, s: Vec<f64>, t: Vec<f64>) -> Self {
        let is_point = |direction: usize, cuts: &[f64], sides: [usize; 2]| -> Vec<bool> {
            let lines = point_lines(face, direction);
            let near = |u: f64| lines.iter().any(|&r| (r - u).abs() <= SAME_CUT);
            let mut points: Vec<bool> = cuts.iter().map(|&u| near(u)).collect();
            // A side is one point if it is to the shell.
            for (k, side) in [(0, sides[0]), (cuts.len() - 1, sides[1])] {
                points[k] = face.sides[side].is_none();
            }
            points
        };
        let points = [is_point(0, &s, [2, 3]), is_point(1, &t, [0, 1])];
        Self { face, s, t, points }
    }

    /// The vertex at a grid point of the border, or of an inner line that is one point.
    fn border_vertex(&self, border: &BorderVertices, i: usize, j: usize) -> Option<usize> {
        let (n, m) = (self.s.len() - 1, self.t.len() - 1);
        // A line that is one point is where it starts.
        let (i, j) = (if self.points[1][j] { 0 } else { i }, if self.points[0][i] { 0 } else { j });
        let side = |on: bool, side: usize, k: usize, last: usize| {
            if on { border.on_side(self.face, side, k, last) } else { None }
        };
        side(j == 0, 0, i, n)
            .or_else(|| side(j == m, 1, i, n))
            .or_else(|| side(i == 0, 2, j, m))
            .or_else(|| side(i == n, 3, j, m))
    }

    /// Joins the ends of inner lines that are one point; true if there are any.
    fn join_points(&self, border: &mut BorderVertices) -> bool {
        let (n, m) = (self.s.len() - 1, self.t.len() - 1);
        let mut joined = false;
        for (direction, [first, second], last) in [(0, [0, 1], n), (1, [2, 3], m)] {
            for k in (1..last).filter(|&k| self.points[direction][k]) {
                let ends = [first, second].map(|side| border.on_side(self.face, side, k, last));
                if let [Some(a), Some(b)] = ends {
                    joined |= border.join(a, b);
                }
            }
        }
        joined
    }

    /// Appends vertices, normals and polygons; returns how far shared vertices are off the patch.
    fn emit(&self, border: &mut BorderVertices, [shell, face]: [usize; 2], mesh: &mut SurfaceMesh) -> f64 {
        let (surface, n, m) = (&self.face.surface, self.s.len() - 1, self.t.len() - 1);
        let outer = self.face.outer_sign();
        let normals = Normals::new(surface, &self.s, &self.t);
        let mut gap = 0.0_f64;
        let mut corners = Vec::with_capacity((n + 1) * (m + 1));
        for (j, &t) in self.t.iter().enumerate() {
            for (i, &s) in self.s.iter().enumerate() {
                let point = surface.point(s, t);
                let upward = normals.at_cut(i, j) * outer;
                let inside = i > 0 && i < n && j > 0 && j < m && !self.points[0][i] && !self.points[1][j];
                let vertex = if inside { None } else { self.border_vertex(border, i, j) };
                corners.push(if let Some(position) = vertex {
                    gap = gap.max(mesh.positions[position].distance(point));
                    // Normals at points of lines belong to their cells.
                    let single = self.points[0][i] || self.points[1][j];
                    let normal = if single { 0 } else { border.normal(position, upward, &mut mesh.normals) };
                    MeshCorner { position, normal }
                } else {
                    mesh.positions.push(point);
                    mesh.normals.push(upward);
                    MeshCorner { position: mesh.positions.len() - 1, normal: mesh.normals.len() - 1 }
                });
            }
        }
        for j in 0..m {
            for i in 0..n {
                let grid = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                let mut cell = grid.map(|(i, j)| corners[i + j * (n + 1)]);
                for (corner, (gi, gj)) in cell.iter_mut().zip(grid) {
                    if self.points[0][gi] || self.points[1][gj] {
                        // In the middle of the line, as seen from the cell.
                        let middle = |cuts: &[f64], on: bool, k: usize, cell: usize| {
                            if on { cuts[k] } else { 0.5 * (cuts[cell] + cuts[cell + 1]) }
                        };
                        let s = middle(&self.s, self.points[0][gi], gi, i);
                        let t = middle(&self.t, self.points[1][gj], gj, j);
                        let n = normals.in_cell(s, t, i, j) * outer;
                        corner.normal = border.normal(corner.position, n, &mut mesh.normals);
                    }
                }
                if !self.face.same_sense {
                    cell.reverse();
                }
                let (s, t) = ([self.s[i], self.s[i + 1]], [self.t[j], self.t[j + 1]]);
                let source = MeshSource { shell, face, s, t };
                if let Some(polygon) = polygon(cell) {
                    match polygon {
                        MeshFace::Quad(cell) if !surface.has_flat_cells() => {
                            mesh.faces.extend(in_two(cell, &mesh.positions));
                            mesh.sources.extend([source; 2]);
                        }
                        _ => {
                            mesh.faces.push(polygon);
                            mesh.sources.push(source);
                        }
                    }
                } else {
                    mesh.lost.push(source);
                    // Two points that are one but for rounding: of what is between, the second is the farthest.
                    let [a, b, c, d] = cell.map(|corner| mesh.positions[corner.position]);
                    gap = gap.max(a.distance(c)).max(b.distance(d));
                }
            }
        }
        gap
    }
}

/// A quad cut along its shorter diagonal.
fn in_two([a, b, c, d]: [MeshCorner; 4], positions: &[Point3]) -> [MeshFace; 2] {
    let length = |a: MeshCorner, b: MeshCorner| positions[a.position].distance(positions[b.position]);
    let halves = if length(a, c) <= length(b, d) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
    halves.map(MeshFace::Triangle)
}

/// The unit normals of a face in the direction of `f_s × f_t`, at its cuts and in its cells.
struct Normals<'a> {
    surface: &'a FaceSurface,
    s: &'a [f64],
    t: &'a [f64],
    /// On which side of the surface's own normal that is: in each cell, s fastest, or once where it is the same in all.
    sides: Vec<f64>,
}

impl<'a> Normals<'a> {
    fn new(surface: &'a FaceSurface, s: &'a [f64], t: &'a [f64]) -> Self {
        let sides = if surface.is_regular() {
            vec![surface.side_of_normal(0.5, 0.5)]
        } else {
            let middle = |w: &[f64]| 0.5 * (w[0] + w[1]);
            let of_row = |t: f64| s.windows(2).map(move |w| surface.side_of_normal(middle(w), t));
            t.windows(2).map(middle).flat_map(of_row).collect()
        };
        Self { surface, s, t, sides }
    }

    fn side(&self, i: usize, j: usize) -> f64 {
        if let [side] = self.sides[..] { side } else { self.sides[i + j * (self.s.len() - 1)] }
    }

    /// At cuts, as the cell after them has it.
    fn at_cut(&self, i: usize, j: usize) -> Vec3 {
        let last = |cuts: &[f64]| cuts.len() - 2;
        self.in_cell(self.s[i], self.t[j], i.min(last(self.s)), j.min(last(self.t)))
    }

    /// At a place of a cell, its border included.
    fn in_cell(&self, s: f64, t: f64, i: usize, j: usize) -> Vec3 {
        self.surface.unit_normal(s, t) * self.side(i, j)
    }
}

/// The polygon of four corners of which neighbors may be one; `None` if two remain.
fn polygon(cell: [MeshCorner; 4]) -> Option<MeshFace> {
    let same = |k: usize| cell[k].position == cell[(k + 1) % 4].position;
    let doubled: usize = (0..4).filter(|&k| same(k)).count();
    match (doubled, (0..4).find(|&k| same(k))) {
        (0, _) => Some(MeshFace::Quad(cell)),
        (1, Some(k)) => Some(MeshFace::Triangle([cell[(k + 1) % 4], cell[(k + 2) % 4], cell[(k + 3) % 4]])),
        _ => None,
    }
}
