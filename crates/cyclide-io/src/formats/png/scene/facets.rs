//! The triangles of the picture: meshes of surfaces, and curves as ribbons.

use super::camera::{Camera, Projected};
use super::light::Rgb;
use super::surface::growth;
use crate::drawing::palette;
use crate::export::shape::Shape;
use crate::export::triangle_cells::TriangleCell;
use crate::formats::png::polyline::{CURVE, Polyline};
use cyclide::{
    Point3, Vec3,
    curve::Arc,
    mesh::{MeshSource, SurfaceMesh},
    surface::ParamSurface as _,
    topology::{Body, FaceSurface, Shell},
};

/// Cells of the rough grids of all patches together, about, and those of one patch along a side.
const ROUGH: f64 = 3200.0;
const ROUGH_SIDES: (f64, f64) = (2.0, 24.0);
/// Curves are drawn in front of surfaces that are nearer by this part of the distance.
const LIFT: f64 = 0.004;
/// Length of the dashes of what is taken away, pixels, their half width and color.
const DASH: f64 = 9.0;
const TAKEN_WIDTH: f64 = 0.6;
const TAKEN: u32 = 0x8A94A0;
/// Corners of the dots at the joints of ribbons.
const DOT: usize = 12;

/// What is on a facet.
pub(super) enum Paint {
    /// A part of a face, with the parameters of its corners.
    Surface { surface: usize, at: [[f64; 2]; 3] },
    /// A part of a patch over a triangle, with the barycentric coordinates of its corners.
    Patch { patch: usize, at: [[f64; 3]; 3] },
    /// A triangle with normals at its corners.
    Smooth { object: usize, normals: [Vec3; 3], tint: Rgb },
    /// One color, of a curve of the object.
    Ink { object: usize, light: Rgb },
}

/// The barycentric coordinates of the corners of a triangle.
pub(super) const CORNERS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Triangles in the picture with what is on them.
#[derive(Default)]
pub(super) struct Facets {
    pub(super) corners: Vec<[Projected; 3]>,
    pub(super) paints: Vec<Paint>,
}

/// Triangles on a few points of each of these surfaces: for the camera and the shadow.
pub(super) fn rough(shapes: &[&Shape<'_>]) -> Vec<[Point3; 3]> {
    let count: usize = shapes.iter().map(|shape| shape.part_count()).sum();
    let cells = (ROUGH / count.max(1) as f64).sqrt().clamp(ROUGH_SIDES.0, ROUGH_SIDES.1) as usize;
    let mut triangles = Vec::new();
    for face in shapes.iter().flat_map(|shape| shape.shells()).flat_map(Shell::faces) {
        let at = |i: usize, j: usize| face.surface.point(i as f64 / cells as f64, j as f64 / cells as f64);
        for (i, j) in (0..cells * cells).map(|k| (k % cells, k / cells)) {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
            triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    for surface in shapes.iter().filter_map(|shape| shape.triangles()) {
        // Half as many divisions as for a face: a triangle is as large as half of it.
        let source = |i: usize, j: usize| {
            let range = |k: usize| [k, k + 1].map(|v| v as f64 * 2.0 / cells as f64);
            MeshSource { shell: 0, face: 0, s: range(i), t: range(j) }
        };
        for patch in (0..surface.triangle_count()).filter_map(|triangle| surface.patch(triangle)) {
            let n = cells / 2;
            let parts = (0..n).flat_map(|i| (0..n - i).map(move |j| (i, j)));
            let parts = parts.flat_map(|(i, j)| TriangleCell::of(&source(i, j)).parts());
            triangles.extend(
                parts.filter_map(|[a, b, c]| Some([patch.point(a).ok()?, patch.point(b).ok()?, patch.point(c).ok()?])),
            );
        }
    }
    triangles
}

impl Facets {
    /// The mesh of a body; `first` is the index of its first face's surface.
    pub(super) fn add_body(&mut self, body: &Body, mesh: &SurfaceMesh, first: usize, camera: &Camera) {
        let positions: Vec<Projected> = mesh.positions.iter().map(|p| camera.project(*p)).collect();
        // Index of the first surface of each shell.
        let mut starts = vec![first];
        for shell in body.shells() {
            starts.push(starts[starts.len() - 1] + shell.faces().len());
        }
        let shells: Vec<&Shell> = body.shells().collect();
        for (face, source) in mesh.faces.iter().zip(&mesh.sources) {
            let on = &shells[source.shell].faces()[source.face].surface;
            let corners: Vec<usize> = face.corners().iter().map(|c| c.position).collect();
            let at = corner_parameters(on, source, &corners, mesh);
            let surface = starts[source.shell] + source.face;
            for k in 1..corners.len() - 1 {
                let pick = [0, k, k + 1];
                self.corners.push(pick.map(|i| positions[corners[i]]));
                self.paints.push(Paint::Surface { surface, at: pick.map(|i| at[i]) });
            }
        }
    }

    /// The mesh of a surface over triangles; `first` is the index of its first patch.
    pub(super) fn add_triangles(&mut self, mesh: &SurfaceMesh, first: usize, camera: &Camera) {
        let positions: Vec<Projected> = mesh.positions.iter().map(|p| camera.project(*p)).collect();
        let mut faces = mesh.faces.iter();
        for own in mesh.sources.chunk_by(|a, b| a == b) {
            let cell = TriangleCell::of(&own[0]);
            for (part, face) in cell.parts().zip(faces.by_ref().take(own.len())) {
                let Some(corners) = face.corners().first_chunk::<3>() else { continue };
                self.corners.push(corners.map(|c| positions[c.position]));
                let at = part.map(|at| at.map(|v| v / cell.divisions as f64));
                self.paints.push(Paint::Patch { patch: first + own[0].face, at });
            }
        }
    }

    /// A curve as a ribbon of constant width in the picture.
    pub(super) fn add_curve(&mut self, curve: &Polyline, camera: &Camera, scale: f64) {
        self.add_ribbon(curve, 0.5 * CURVE * scale, palette::linear(curve.object), camera);
    }

    /// A curve in any width and color.
    pub(super) fn add_ribbon(&mut self, curve: &Polyline, radius: f64, light: Rgb, camera: &Camera) {
        let object = curve.object;
        let points: Vec<Projected> = curve.points.iter().map(|p| lifted(*p, camera)).collect();
        let last = if curve.closed { points.first() } else { None };
        let ends = points.iter().skip(1).chain(last);
        for (a, b) in points.iter().zip(ends) {
            self.add_segment([a, b], radius, object, light);
        }
        // Dots round the corners between segments and the ends.
        for p in &points {
            let at = |k: usize| {
                let (y, x) = (std::f64::consts::TAU * k as f64 / DOT as f64).sin_cos();
                Projected { x: p.x + radius * x, y: p.y + radius * y, near: p.near }
            };
            for k in 1..DOT - 1 {
                self.corners.push([at(0), at(k), at(k + 1)]);
                self.paints.push(Paint::Ink { object, light });
            }
        }
    }

    /// A short line on a surface, below curves on it.
    pub(super) fn add_stroke(&mut self, ends: [Point3; 2], object: usize, radius: f64, light: Rgb, camera: &Camera) {
        let [a, b] = ends.map(|p| {
            let p = camera.project(p);
            Projected { near: p.near * (1.0 + camera.lift(0.5 * LIFT)), ..p }
        });
        self.add_segment([&a, &b], radius, object, light);
    }

    /// A round mark on a surface, over all lines on it.
    pub(super) fn add_mark(&mut self, p: Point3, object: usize, radius: f64, light: Rgb, camera: &Camera, over: f64) {
        let middle = camera.project(p);
        let near = middle.near * (1.0 + camera.lift(over * LIFT));
        let at = |k: usize| {
            let (y, x) = (std::f64::consts::TAU * k as f64 / (2 * DOT) as f64).sin_cos();
            Projected { x: middle.x + radius * x, y: middle.y + radius * y, near }
        };
        for k in 1..2 * DOT - 1 {
            self.corners.push([at(0), at(k), at(k + 1)]);
            self.paints.push(Paint::Ink { object, light });
        }
    }

    /// An arc in dashes, of something that is taken away.
    pub(super) fn add_dashes(&mut self, arc: &Arc, object: usize, camera: &Camera, scale: f64) {
        let ends = [0.0, 0.5, 1.0].map(|x| camera.project(arc.point(x)));
        let length: f64 = ends.windows(2).map(|pair| (pair[1].x - pair[0].x).hypot(pair[1].y - pair[0].y)).sum();
        // An odd number of dashes and gaps: both ends are drawn.
        let count = 2.0 * (0.5 * length / (DASH * scale)).round().min(1e4) + 1.0;
        let light = palette::to_linear(TAKEN);
        for k in (0..count as usize).step_by(2) {
            // As many segments of a dash as make it round.
            for part in [[0.0, 0.5], [0.5, 1.0]] {
                let [a, b] = part.map(|x| lifted(arc.point((k as f64 + x) / count), camera));
                self.add_segment([&a, &b], TAKEN_WIDTH * scale, object, light);
            }
        }
    }

    fn add_segment(&mut self, [a, b]: [&Projected; 2], radius: f64, object: usize, light: Rgb) {
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        let length = dx.hypot(dy);
        if length > 0.0 {
            let (x, y) = (-dy / length * radius, dx / length * radius);
            let at = |p: &Projected, side: f64| Projected { x: p.x + side * x, y: p.y + side * y, near: p.near };
            for corners in [[at(a, 1.0), at(a, -1.0), at(b, 1.0)], [at(b, 1.0), at(a, -1.0), at(b, -1.0)]] {
                self.corners.push(corners);
                self.paints.push(Paint::Ink { object, light });
            }
        }
    }
}

/// A place of a curve in the picture, in front of the surface that it lies on.
fn lifted(p: Point3, camera: &Camera) -> Projected {
    let p = camera.project(p);
    Projected { near: p.near * (1.0 + camera.lift(LIFT)), ..p }
}

/// The parameters of a cell at its polygon's corners; where two of them share a corner (a pole), their middle.
fn corner_parameters(on: &FaceSurface, cell: &MeshSource, corners: &[usize], mesh: &SurfaceMesh) -> [[f64; 2]; 4] {
    let mut sums = [[0.0; 3]; 4];
    for (i, j) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
        let [s, t] = [cell.s[i], cell.t[j]];
        let point = on.point(s, t);
        let distance = |k: &usize| mesh.positions[corners[*k]].distance(point);
        let nearest = (0..corners.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        if let Some(k) = nearest {
            sums[k] = [sums[k][0] + s, sums[k][1] + t, sums[k][2] + 1.0];
        }
    }
    sums.map(|[s, t, count]| if count > 0.0 { [s / count, t / count] } else { [cell.s[0], cell.t[0]] })
}

/// Parameters at a place of the picture, and how much each of them changes from pixel to pixel.
///
/// In perspective `near` and `near` times a parameter are linear in the picture, their quotient is the parameter.
pub(super) fn parameters<const N: usize>(
    corners: &[Projected; 3],
    at: &[[f64; N]; 3],
    x: f64,
    y: f64,
) -> ([f64; N], [f64; N]) {
    let [a, b, c] = corners;
    let (x1, y1, x2, y2) = (b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
    let area = x1 * y2 - x2 * y1;
    let area = if area == 0.0 { 1.0 } else { area };
    // Value and slopes of the linear function with these values at the corners.
    let linear = |v: [f64; 3]| {
        let (v1, v2) = (v[1] - v[0], v[2] - v[0]);
        let (dx, dy) = ((v1 * y2 - v2 * y1) / area, (v2 * x1 - v1 * x2) / area);
        (v[0] + dx * (x - a.x) + dy * (y - a.y), dx, dy)
    };
    let (near, near_x, near_y) = linear([a.near, b.near, c.near]);
    let parameter = |k: usize| {
        let (v, v_x, v_y) = linear([at[0][k] * a.near, at[1][k] * b.near, at[2][k] * c.near]);
        let value = v / near;
        let slope = growth((v_x - value * near_x) / near, (v_y - value * near_y) / near);
        (value.clamp(0.0, 1.0), slope)
    };
    let all: [(f64, f64); N] = std::array::from_fn(parameter);
    (all.map(|(value, _)| value), all.map(|(_, slope)| slope))
}
