//! curvo and truck-geometry on the grid of `benches/compare_surfaces.py`: prints JSON, one line per kind.
//!
//! The quarter by quarter torus with radii 2 and 1/2 as a rational biquadratic, 1000 by 1000 points; normals on a tenth of
//! the rows, scaled up, for they are slow.

use std::hint::black_box;
use std::time::Instant;

/// Parameters in each direction.
const COUNT: usize = 1000;
/// Repetitions; the smallest time is printed.
const REPETITIONS: usize = 5;

/// Homogeneous control points `[i][j]`, i about the axis.
fn control_points() -> [[[f64; 4]; 3]; 3] {
    let half = 0.5f64.sqrt();
    let turn = [(1.0, 0.0, 1.0), (1.0, 1.0, half), (0.0, 1.0, 1.0)];
    let profile = [(2.5, 0.0, 1.0), (2.5, 0.5, half), (2.0, 0.5, 1.0)];
    turn.map(|(cx, cy, u)| profile.map(|(r, z, v)| [r * cx * u * v, r * cy * u * v, z * u * v, u * v]))
}

fn report(name: &str, kind: &str, buffer: &str, share: f64, mut run: impl FnMut()) {
    let mut least = f64::INFINITY;
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        run();
        least = least.min(start.elapsed().as_secs_f64());
    }
    let seconds = least / share;
    println!(r#"{{"name": "{name}", "kind": "{kind}", "buffer": "{buffer}", "seconds": {seconds:e}}}"#);
}

fn check(x: f64, y: f64, z: f64) {
    let off = (x.hypot(y) - 2.0).hypot(z) - 0.5;
    assert!(off.abs() < 1e-14, "{off:e} off the torus");
}

fn main() {
    let g: Vec<f64> = (0..COUNT).map(|i| i as f64 / (COUNT - 1) as f64).collect();
    let tenth = &g[..COUNT / 10];
    let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    {
        use curvo::prelude::*;
        use nalgebra::{Point3, Point4};
        let points = control_points().map(|row| row.map(|[x, y, z, w]| Point4::new(x, y, z, w)).to_vec()).to_vec();
        let surface: NurbsSurface3D<f64> = NurbsSurface::new(2, 2, knots.clone(), knots, points);
        let p = surface.point_at(0.3, 0.7);
        check(p.x, p.y, p.z);
        let mut out = vec![Point3::origin(); COUNT * COUNT];
        report("curvo 0.3.3", "points", "kept", 1.0, || {
            for (row, u) in out.chunks_mut(COUNT).zip(&g) {
                for (p, v) in row.iter_mut().zip(&g) {
                    *p = surface.point_at(*u, *v);
                }
            }
        });
        report("curvo 0.3.3, regular_sample_points", "points", "fresh", 1.0, || {
            black_box(surface.regular_sample_points(COUNT - 1, COUNT - 1));
        });
        report("curvo 0.3.3", "normals", "kept", 0.1, || {
            for (row, u) in out.chunks_mut(COUNT).zip(tenth) {
                for (p, v) in row.iter_mut().zip(&g) {
                    *p = surface.point_at(*u, *v);
                    black_box(surface.normal_at(*u, *v));
                }
            }
        });
    }
    {
        use truck_geometry::prelude::*;
        let knots = KnotVec::bezier_knot(2);
        let points = control_points().map(|row| row.map(|[x, y, z, w]| Vector4::new(x, y, z, w)).to_vec()).to_vec();
        let surface = NurbsSurface::new(BSplineSurface::new((knots.clone(), knots), points));
        let p = surface.subs(0.3, 0.7);
        check(p.x, p.y, p.z);
        let mut out = vec![Point3::new(0.0, 0.0, 0.0); COUNT * COUNT];
        report("truck-geometry 0.5.0", "points", "kept", 1.0, || {
            for (row, u) in out.chunks_mut(COUNT).zip(&g) {
                for (p, v) in row.iter_mut().zip(&g) {
                    *p = surface.subs(*u, *v);
                }
            }
        });
        report("truck-geometry 0.5.0", "normals", "kept", 0.1, || {
            for (row, u) in out.chunks_mut(COUNT).zip(tenth) {
                for (p, v) in row.iter_mut().zip(&g) {
                    *p = surface.subs(*u, *v);
                    black_box(surface.normal(*u, *v));
                }
            }
        });
    }
}
