//! Nets of grids: frames, joints, errors.

use crate::data::{PLACES, cyclide_grid, gap, generic_grid, kink, nets};
use cyclide::{
    Point3, Vec3,
    surface::{CyclidicNet, NetFrame, ParamSurface, QuadGrid},
};

#[test]
fn neighbors_agree_pointwise_with_a_common_normal() {
    for (name, net) in nets() {
        let size = net.patches().map(|p| p.size()).fold(0.0, f64::max);
        assert!(gap(&net) <= 1e-13 * size, "{name}: {:e}", gap(&net));
        assert!(kink(&net) <= 1e-12, "{name}: {:e}", kink(&net));
    }
}

#[test]
fn patches_stay_in_space_and_interpolate() {
    for (name, net) in nets() {
        for patch in net.patches() {
            for (s, t) in PLACES.iter().flat_map(|&s| PLACES.map(|t| (s, t))) {
                let off = patch.real_residual(s, t);
                assert!(off <= 1e-12 * patch.size(), "{name}: {off:e}");
            }
            let [a0, a1, a2, a3] = patch.corners();
            for (p, s, t) in [(a0, 0.0, 0.0), (a1, 1.0, 0.0), (a2, 0.0, 1.0), (a3, 1.0, 1.0)] {
                // The quotient of two quaternions: some ten roundings.
                let off = patch.point(s, t).distance(p);
                assert!(off <= 4e-15 * (patch.size() + p.to_vec().length()), "{name}: {off:e}");
            }
            // The frame runs with the parameters: q1 and q2 are positive on the sides.
            assert!([patch.q1()[0], patch.q1()[2], patch.q2()[0], patch.q2()[2]].iter().all(|q| *q > 0.0), "{name}");
        }
    }
}

#[test]
fn the_frame_comes_back_round_every_quad() {
    for (name, net) in nets() {
        let ([m, n], v) = (net.size(), net.frame());
        for (i, j) in (0..n).flat_map(|j| (0..m).map(move |i| (i, j))) {
            let p = |i, j| net.grid().point(i, j);
            let reflect = |x: Vec3, a: Point3, b: Point3| {
                let d = (b - a).unit().unwrap();
                x - d * (2.0 * d.dot(x))
            };
            let round = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1), (i, j)];
            for x in v {
                let back = round.windows(2).fold(x, |x, e| reflect(x, p(e[0].0, e[0].1), p(e[1].0, e[1].1)));
                // Four reflections of chords known to rounding relative to their length.
                assert!((back - x).length() < 1e-11, "{name}: {:e}", (back - x).length());
            }
        }
    }
}

#[test]
fn a_given_frame_is_kept() {
    let grid = generic_grid([6, 5]);
    let (v1, v2) = (Vec3::new(0.6, 0.0, 0.8), Vec3::new(0.0, 1.0, 0.0));
    let net = CyclidicNet::new(grid, NetFrame::First(v1, v2)).unwrap();
    let [e1, e2, e3] = net.vertex_frame(0, 0);
    assert!((e1 - v1).length() < 1e-15 && (e2 - v2).length() < 1e-15 && (e3 - v1.cross(v2)).length() < 1e-15);
}

/// The grid is in lines of curvature: the automatic net is the cyclide itself, whatever the counts and the lengths of the edges.
#[test]
fn on_a_cyclide_the_automatic_frame_is_that_of_its_lines_of_curvature() {
    let [a, c, mu] = [2.0_f64, 0.7, 1.1];
    let b2 = a * a - c * c;
    for (size, closed) in [
        ([8, 8], [false; 2]),
        ([4, 6], [false; 2]),
        ([3, 5], [false; 2]),
        ([8, 4], [true, false]),
        ([6, 9], [true, false]),
        ([32, 31], [false; 2]),
    ] {
        let net = CyclidicNet::new(cyclide_grid([a, c, mu], size, closed), NetFrame::Auto).unwrap();
        let off = |p: Point3| {
            let (q, x) = (p.to_vec().length_squared() + b2 - mu * mu, a * p.x - c * mu);
            let gradient = p.to_vec() * (4.0 * q) - Vec3::new(8.0 * a * x, 8.0 * b2 * p.y, 0.0);
            (q * q - 4.0 * x * x - 4.0 * b2 * p.y * p.y).abs() / gradient.length()
        };
        let far = net.patches().flat_map(|patch| PLACES.map(|s| off(patch.point(s, 0.5)))).fold(0.0, f64::max);
        // Rounding of tangents of edges a thirtieth of the size, and of the sum over all vertices.
        assert!(far < 1e-13, "{size:?}: {far}");
    }
}

#[test]
fn bad_grids_are_refused_with_the_quad() {
    let size = [6, 5];
    let good = generic_grid(size);
    let changed = |index: usize, p: Point3| {
        let mut points = good.points().to_vec();
        points[index] = p;
        CyclidicNet::new(QuadGrid::new(points, size, [false; 2]).unwrap(), NetFrame::Auto).unwrap_err()
    };
    // Vertex (5, 4) is a corner of the last quad only.
    let corner = good.points()[29];
    let error = changed(29, corner + Vec3::new(0.0, 0.0, 1e-3));
    assert_eq!((error.reason(), error.index()), ("not-concircular", Some(19)), "{error}");
    // On the circle, but between its neighbor and the first corner.
    let [a0, a1, a2] = [good.points()[22], good.points()[23], good.points()[28]];
    let inverse = |p: Point3| (p - a0) / -(p - a0).length_squared();
    let b = inverse(a1) + (inverse(a2) - inverse(a1)) * 1.5;
    let error = changed(29, a0 + b * (-1.0 / b.length_squared()));
    assert_eq!((error.reason(), error.index()), ("crossing-quad", Some(19)), "{error}");
    let error = changed(29, good.points()[28]);
    assert_eq!((error.reason(), error.index()), ("coincident-points", Some(19)), "{error}");
    let frame = NetFrame::First(Vec3::X, Vec3::new(0.1, 1.0, 0.0));
    assert_eq!(CyclidicNet::new(good, frame).unwrap_err().reason(), "frame-not-orthonormal");
}

#[test]
fn a_generic_closed_net_does_not_close() {
    // A ring of points and its inverse: every quad of a strip between them is circular, but the points lie on no
    // circle, and the frame comes back turned.
    let ring = (0..8).map(|k| {
        let phi = std::f64::consts::TAU * f64::from(k) / 8.0;
        Vec3::new(phi.cos(), phi.sin(), 0.3 * (2.0 * phi).sin() + 0.2 * phi.cos())
    });
    let inverse = ring.clone().map(|v| v * (4.0 / v.length_squared()));
    let points = ring.chain(inverse).map(|v| Point3::ORIGIN + v).collect();
    let grid = QuadGrid::new(points, [8, 2], [true, false]).unwrap();
    let error = CyclidicNet::new(grid, NetFrame::Auto).unwrap_err();
    assert_eq!(error.reason(), "net-does-not-close", "{error}");
}
