//! Lines of curvature of graphs, from their derivatives: grids run along them.

use super::{laid, surfaces};
use cyclide::{Point3, Vec3, surface::QuadGrid};
use cyclide_grids::PrincipalGridOptions;
use surfaces::Mesh;

/// Derivatives of a height: x, y, xx, xy, yy.
type Derivatives = fn(f64, f64) -> [f64; 5];

/// Unit vectors along both lines of curvature through a place, and the difference of the principal curvatures.
pub fn principal([p, q, xx, xy, yy]: [f64; 5]) -> ([Vec3; 2], f64) {
    // Directions (a, b) of the plane with det(I (a, b), II (a, b)) = 0: A a^2 + B a b + C b^2.
    let (e, f, g) = (1.0 + p * p, p * q, 1.0 + q * q);
    let (a, b, c) = (e * xy - f * xx, e * yy - g * xx, f * yy - g * xy);
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    // The slope b/a from the larger of both roots' forms: no cancellation.
    let m = -0.5 * (b + root.copysign(b));
    let directions = [[c, m], [m, a]].map(|[x, y]| {
        let v = Vec3::new(x, y, x * p + y * q);
        v.unit().unwrap_or(Vec3::X)
    });
    let w = (1.0 + p * p + q * q).sqrt();
    let curvature = |d: Vec3| (xx * d.x * d.x + 2.0 * xy * d.x * d.y + yy * d.y * d.y) / w;
    (directions, (curvature(directions[0]) - curvature(directions[1])).abs())
}

/// The angle of a vector to the nearer of two directions, degrees.
fn angle_to(v: Vec3, directions: [Vec3; 2]) -> f64 {
    directions.into_iter().map(|d| v.angle(d).min(v.angle(-d))).fold(f64::INFINITY, f64::min).to_degrees()
}

/// Angles of all edges to the lines of curvature, ascending.
fn angles(grid: &QuadGrid, at: Derivatives) -> Vec<f64> {
    let [columns, rows] = grid.quads();
    let mut angles = Vec::new();
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        let [a, b, c, _] = grid.corners(i, j).map(|k| grid.points()[k]);
        for end in [b, c] {
            let middle = a.midpoint(end);
            angles.push(angle_to(end - a, principal(at(middle.x, middle.y)).0));
        }
    }
    angles.sort_by(f64::total_cmp);
    angles
}

const HYPAR: Derivatives = |x, y| [0.05 * y, 0.05 * x, 0.0, 0.05, 0.0];
const SHEAR: Derivatives = |x, y| [0.08 * x + 0.035 * y, -0.04 * y + 0.035 * x, 0.08, 0.035, -0.04];
const PARABOLOID: Derivatives = |x, y| [-0.12 * x, -0.06 * y, -0.12, 0.0, -0.06];
const SADDLE: Derivatives = |x, y| {
    let ((s, c), (t, k)) = ((0.4 * x).sin_cos(), (0.5 * y).sin_cos());
    [0.72 * c * k, -0.9 * s * t, -0.288 * s * k, -0.36 * c * t, -0.45 * s * k]
};

fn cases() -> [(&'static str, Mesh, Derivatives, f64); 4] {
    [
        ("hypar", surfaces::hypar(32), HYPAR, 0.1),
        ("shear", surfaces::shear(32), SHEAR, 0.5),
        ("paraboloid", surfaces::paraboloid(32), PARABOLOID, 2.5),
        ("saddle", surfaces::saddle(), SADDLE, 2.0),
    ]
}

/// Chords of an edge length differ from the lines by a second-order angle; the spreading term takes the rest: up to two degrees at the
/// border, where the distances of the lines change, tenths of one elsewhere.
#[test]
fn edges_run_along_the_lines_of_curvature() {
    for (name, mesh, at, most) in cases() {
        let grid = &laid(&mesh, &PrincipalGridOptions::new(0.6)).unwrap().grids[0];
        let angles = angles(grid, at);
        let (median, largest) = (angles[angles.len() / 2], angles[angles.len() - 1]);
        assert!(median < 0.1 * most && largest < most, "{name}: median {median}, largest {largest} degrees");
    }
}

/// A line traced with small steps through the exact field from the end of a row ends where the row does.
#[test]
fn rows_end_where_traced_lines_do() {
    for (name, mesh, at, _) in cases() {
        let grid = &laid(&mesh, &PrincipalGridOptions::new(0.6)).unwrap().grids[0];
        let [columns, rows] = grid.size();
        for row in [0, rows / 2, rows - 1] {
            let (start, end) = (grid.point(0, row), grid.point(columns - 1, row));
            let traced = trace(start, grid.point(1, row) - start, end, at);
            // A degree over the length of a row of ten edges is a sixth of an edge.
            let distance = traced.distance(end);
            assert!(distance < 0.1 * 0.6, "{name}, row {row}: {distance} apart");
        }
    }
}

/// The point nearest to a goal on the line through a start that sets out in a direction (Runge and Kutta, order 4).
fn trace(start: Point3, ahead: Vec3, goal: Point3, at: Derivatives) -> Point3 {
    const STEP: f64 = 0.01;
    let direction = |p: Point3, ahead: Vec3| {
        let directions = principal(at(p.x, p.y)).0;
        let [a, b] = directions.map(|d| if d.dot(ahead) < 0.0 { -d } else { d });
        if a.dot(ahead) >= b.dot(ahead) { a } else { b }
    };
    let (mut p, mut ahead, mut best) = (start, ahead, start);
    for _ in 0..3000 {
        let k1 = direction(p, ahead);
        let k2 = direction(p + k1 * (0.5 * STEP), k1);
        let k3 = direction(p + k2 * (0.5 * STEP), k1);
        let k4 = direction(p + k3 * STEP, k1);
        let next = p + (k1 + (k2 + k3) * 2.0 + k4) * (STEP / 6.0);
        (ahead, p) = (next - p, next);
        if p.distance(goal) < best.distance(goal) {
            best = p;
        } else if best != start {
            break;
        }
    }
    best
}
