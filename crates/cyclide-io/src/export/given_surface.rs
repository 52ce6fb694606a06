//! The surface that an object was made to follow, and the lines of curvature that were found on it: what pictures show.

use cyclide::{
    Point3, Vec3,
    surface::{GridCell, QuadGrid, QuadLayout},
};

/// A surface as given, by its vertices, with which a skin is compared.
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// use cyclide_io::export::GivenSurface;
/// let points = (0..9).map(|k| Point3::new((k % 3) as f64, (k / 3) as f64, 0.0)).collect();
/// let given = GivenSurface::from_grid(&QuadGrid::new(points, [3, 3], [false, false])?);
/// assert_eq!((given.points.len(), given.triangles.len()), (9, 8));
/// assert!(given.normals.iter().all(|n| n.z == 1.0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GivenSurface {
    /// The vertices.
    pub points: Vec<Point3>,
    /// Unit normals at the vertices, on one side; zero if a vertex has no normal.
    pub normals: Vec<Vec3>,
    /// The triangles between them.
    pub triangles: Vec<[usize; 3]>,
}

impl GivenSurface {
    /// The vertices of a grid, each quad in two triangles. The normals are those of parabolas through three vertices along s and along t,
    /// also at the border.
    #[must_use]
    pub fn from_grid(grid: &QuadGrid) -> Self {
        let [m, n] = grid.size();
        let vertices = (0..m * n).map(|k| [k % m, k / m]);
        let normal = |at: [usize; 2]| tangent(grid, at, 0).cross(tangent(grid, at, 1)).unit().unwrap_or_default();
        let normals = vertices.map(normal).collect();
        let [columns, rows] = grid.quads();
        let quads = (0..columns * rows).map(|k| (k % columns, k / columns));
        let quads = quads.filter(|(i, j)| grid.cell(*i, *j) != GridCell::Outside).map(|(i, j)| grid.corners(i, j));
        let triangles = quads.flat_map(|[a, b, c, d]| [[a, b, d], [a, d, c]]).collect();
        Self { points: grid.points().to_vec(), normals, triangles }
    }
}

impl GivenSurface {
    /// The vertices of a mesh, each quad of its grids in two triangles; the normals are the mean directions of the quads around a
    /// vertex.
    #[must_use]
    pub fn from_layout(layout: &QuadLayout) -> Self {
        let (points, quads) = (layout.points(), layout.quads());
        let mut normals = vec![Vec3::ZERO; points.len()];
        for [a, b, c, d] in &quads {
            let across = (points[*d] - points[*a]).cross(points[*c] - points[*b]);
            [a, b, c, d].into_iter().for_each(|v| normals[*v] += across);
        }
        let normals = normals.into_iter().map(|n| n.unit().unwrap_or_default()).collect();
        let triangles = quads.into_iter().flat_map(|[a, b, c, d]| [[a, b, d], [a, d, c]]).collect();
        Self { points: points.to_vec(), normals, triangles }
    }
}

/// The direction of a line of a grid at a vertex: of the parabola through it and its neighbors, of three at an end.
fn tangent(grid: &QuadGrid, at: [usize; 2], direction: usize) -> Vec3 {
    let (k, count, closed) = (at[direction], grid.size()[direction], grid.closed()[direction]);
    let point = |k: usize| {
        let mut place = at;
        place[direction] = k % count;
        grid.point(place[0], place[1])
    };
    if closed {
        return point(k + 1) - point(k + count - 1);
    }
    // The run of edges that quads have, in a grid with a border in steps.
    let has_edge = |k: usize| edge_has_quad(grid, at, direction, k);
    let first = (0..k).rev().take_while(|k| has_edge(*k)).last().unwrap_or(k);
    let last = (k..count - 1).take_while(|k| has_edge(*k)).last().map_or(k, |k| k + 1);
    match (k, last - first) {
        (_, 0) => Vec3::ZERO,
        (_, 1) => point(last) - point(first),
        (k, _) if k == first => (point(k + 1) - point(k)) * 4.0 - (point(k + 2) - point(k)),
        (k, _) if k == last => (point(k) - point(k - 1)) * 4.0 - (point(k) - point(k - 2)),
        (k, _) => point(k + 1) - point(k - 1),
    }
}

/// Whether a quad is beside edge `k` of the line through a vertex.
fn edge_has_quad(grid: &QuadGrid, at: [usize; 2], direction: usize, k: usize) -> bool {
    let (size, across) = (grid.quads(), 1 - direction);
    let beside = [at[across].checked_sub(1), Some(at[across])].into_iter().flatten();
    beside.filter(|line| *line < size[across] && k < size[direction]).any(|line| {
        let [i, j] = if direction == 0 { [k, line] } else { [line, k] };
        grid.cell(i, j) != GridCell::Outside
    })
}

/// The lines of curvature of a surface, and the grids along them.
///
/// ```
/// let field = cyclide_io::export::LaidField::default();
/// assert!(field.along.len() == field.surface.triangles.len() && field.umbilics.is_empty());
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LaidField {
    /// The surface.
    pub surface: GivenSurface,
    /// A unit vector in each triangle along one of its lines of curvature; the other lines are perpendicular.
    pub along: Vec<Vec3>,
    /// Points where the directions are undefined, with the number of half turns of the lines around them.
    pub umbilics: Vec<(Point3, i32)>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_of_a_sphere_are_radial_to_the_second_order() {
        // Angles of 0.1 apart: the parabola's tangent is off by their square over 3 at the ends, and by a sixth inside.
        let at = |k: usize| (0.1 * (k % 7) as f64, 0.1 * (k / 7) as f64 - 0.3);
        let point = |(a, b): (f64, f64)| Point3::new(b.cos() * a.cos(), b.cos() * a.sin(), b.sin());
        let grid = QuadGrid::new((0..49).map(at).map(point).collect(), [7, 7], [false; 2]).unwrap();
        let given = GivenSurface::from_grid(&grid);
        for (p, n) in given.points.iter().zip(&given.normals) {
            assert!((n.dot(p.to_vec()) - 1.0).abs() < 2e-5, "{p:?} {n:?}");
        }
    }
}
