//! What no grid is laid on, by name.

use super::surfaces::{self, Mesh};
use super::{edge, laid};
use cyclide::{
    Error, Point3,
    error::{PrincipalGridError, SurfaceFault},
};
use cyclide_grids::{GridBorder, PrincipalGridOptions, UmbilicRule};
use std::f64::consts::TAU;

fn refused(mesh: &Mesh, options: &PrincipalGridOptions) -> Error {
    laid(mesh, options).unwrap_err()
}

#[test]
fn meshes_that_are_no_surface_with_a_border() {
    let hypar = surfaces::hypar(8);
    let fault = |change: &dyn Fn(&mut Mesh)| {
        let mut mesh = hypar.clone();
        change(&mut mesh);
        match refused(&mesh, &edge(1.0)) {
            Error::PrincipalGrid(PrincipalGridError::NotASurface { fault, .. }) => fault,
            other => panic!("{other}"),
        }
    };
    assert_eq!(fault(&|m| m.triangles[5].swap(0, 1)), SurfaceFault::TurnedOver);
    assert_eq!(fault(&|m| m.triangles[5][1] = m.triangles[5][0]), SurfaceFault::NoArea);
    assert_eq!(fault(&|m| m.points[40] = m.points[41]), SurfaceFault::NoArea);
    // On a line, but for rounding.
    let line = |m: &mut Mesh| {
        m.points.truncate(3);
        m.triangles = vec![[0, 1, 2]];
    };
    assert_eq!(fault(&line), SurfaceFault::NoArea);
    let fin = |m: &mut Mesh| {
        m.points.push(Point3::new(0.0, 0.0, 9.0));
        let [a, b, _] = m.triangles[60];
        m.triangles.push([b, a, m.points.len() - 1]);
    };
    assert!(matches!(fault(&fin), SurfaceFault::EdgeOfMany | SurfaceFault::TurnedOver));
    let corner = |m: &mut Mesh| {
        let at = m.points.len();
        m.points.extend([Point3::new(-9.0, -9.0, 0.0), Point3::new(-8.0, -9.0, 0.0)]);
        m.triangles.push([0, at, at + 1]);
    };
    assert_eq!(fault(&corner), SurfaceFault::Pinched);
    let island = |m: &mut Mesh| {
        let at = m.points.len();
        m.points.extend([[20.0, 0.0], [21.0, 0.0], [20.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0)));
        m.triangles.push([at, at + 1, at + 2]);
    };
    assert_eq!(fault(&island), SurfaceFault::Apart);
    let solid = |m: &mut Mesh| {
        *m = Mesh { points: m.points[..4].to_vec(), triangles: vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]] };
        m.points[3] = Point3::new(0.0, 0.0, 5.0);
        m.points[2] = Point3::new(0.0, 9.0, 0.0);
    };
    assert_eq!(fault(&solid), SurfaceFault::NoBorder);
    let ring = |m: &mut Mesh| {
        let point = |k: usize| {
            let ((s, c), (t, d)) = ((TAU * (k % 12) as f64 / 12.0).sin_cos(), (TAU * (k / 12) as f64 / 8.0).sin_cos());
            Point3::new((5.0 + d) * c, (5.0 + d) * s, t)
        };
        m.points = (0..96).map(point).collect();
        let at = |i: usize, j: usize| i % 12 + j % 8 * 12;
        let quads = (0..8).flat_map(|j| (0..12).map(move |i| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
        // One triangle is missing.
        m.triangles = quads.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).skip(1).collect();
    };
    assert_eq!(fault(&ring), SurfaceFault::Handles);
}

fn is_noise(error: &Error) -> bool {
    matches!(error, Error::PrincipalGrid(PrincipalGridError::FlatSurface { noise: Some(_), .. }))
        && error.to_string().contains("smooth the mesh first")
}

#[test]
fn surfaces_without_lines_of_curvature() {
    let plane = Mesh::roof([0.0, 4.0], [0.0, 4.0], [12; 2], |x, y| 0.2 * x - 0.1 * y + 7.0);
    // Rounding is no curvature, however far from the origin.
    assert_eq!(refused(&plane, &edge(0.5)).reason(), "flat-surface");
    // What bends is noise, smoothed away or not; of a hypar it is as much from 0.1 on, with triangles that fold.
    for amplitude in [1e-4, 2e-3, 2e-2] {
        let plane = Mesh::roof([-6.0, 6.0], [-6.0, 6.0], [48; 2], |_, _| 0.0).noisy(amplitude);
        assert!(is_noise(&refused(&plane, &edge(0.5))), "{amplitude}");
    }
    for amplitude in [0.15, 0.2, 0.3] {
        assert!(is_noise(&refused(&surfaces::hypar(48).noisy(amplitude), &edge(0.5))), "{amplitude}");
    }
    let sphere = Mesh::roof([-1.0, 1.0], [-1.0, 1.0], [24; 2], |x, y| (25.0 - x * x - y * y).sqrt());
    assert_eq!(refused(&sphere, &edge(0.2)).reason(), "flat-surface");
}

#[test]
fn options_out_of_range() {
    let hypar = surfaces::hypar(16);
    let reason = |options: PrincipalGridOptions| refused(&hypar, &options).reason();
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9, 100.0] {
        assert_eq!(reason(edge(length)), "parameter-out-of-range", "{length}");
    }
    assert_eq!(reason(PrincipalGridOptions { most_pieces: Some(0), ..edge(1.0) }), "parameter-out-of-range");
    assert_eq!(reason(PrincipalGridOptions { most_pieces: Some(5), ..edge(1.0) }), "parameter-out-of-range");
    assert_eq!(reason(PrincipalGridOptions { columns: Some(2), ..edge(1.0) }), "parameter-out-of-range");
    assert_eq!(reason(edge(5.0)), "no-grid");
}

#[test]
fn one_grid_has_no_room_for_umbilics() {
    // Its lines of curvature go round the top, or through it.
    let dome = Mesh::roof([-2.0, 2.0], [-2.0, 2.0], [24; 2], |x, y| {
        let r = x * x + y * y;
        3.0 - 0.2 * r - 0.02 * r * r
    });
    for options in [
        PrincipalGridOptions { umbilics: UmbilicRule::Smooth, ..edge(0.4) },
        PrincipalGridOptions { border: GridBorder::Cover, ..edge(0.4) },
    ] {
        match refused(&dome, &options) {
            Error::PrincipalGrid(PrincipalGridError::UmbilicsRemain { at, halves, .. }) => {
                assert!(at[0].hypot(at[1]) < 0.6 && halves > 0, "{at:?} {halves}")
            }
            other => panic!("{other}"),
        }
    }
}
