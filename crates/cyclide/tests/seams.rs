//! Borders of open grids that nearly coincide: which are named, and what is measured along them.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use cyclide::{
    Point3,
    surface::{CyclidicNet, DupinCyclide, NetFrame, ParamSurface as _, QuadGrid, Seam},
};
use cyclide_grids::{CircularMeshOptions, make_circular};
use std::f64::consts::{PI, TAU};

/// An open grid of `quads` of a surface over `[0, 1]²`.
fn grid(surface: &dyn Fn(f64, f64) -> [f64; 3], [m, n]: [usize; 2]) -> QuadGrid {
    let point = |k: usize| Point3::from(surface((k % (m + 1)) as f64 / m as f64, (k / (m + 1)) as f64 / n as f64));
    QuadGrid::new((0..(m + 1) * (n + 1)).map(point).collect(), [m + 1, n + 1], [false; 2]).unwrap()
}

/// A tower whose ellipse turns and shrinks with the height.
fn tower(u: f64, v: f64) -> [f64; 3] {
    let r = 1.0 - v / 4.0;
    let (x, y) = (22.0 * r * (TAU * u).cos(), 18.0 * r * (TAU * u).sin());
    let (sine, cosine) = (PI / 6.0 * v).sin_cos();
    [x * cosine - y * sine, x * sine + y * cosine, 120.0 * v]
}

fn moebius(u: f64, v: f64) -> [f64; 3] {
    let (a, w) = (TAU * u, 2.0 * v - 1.0);
    let r = 5.0 + w * (0.5 * a).cos();
    [r * a.cos(), r * a.sin(), w * (0.5 * a).sin()]
}

const COLUMNS: Seam = Seam { direction: 0, reversed: false };

#[test]
fn borders_within_an_edge_are_seams_and_others_are_not() {
    assert_eq!(grid(&tower, [24, 20]).seams(), [COLUMNS]);
    let across = grid(&|u, v| tower(v, u), [20, 24]);
    assert_eq!(across.seams(), [Seam { direction: 1, reversed: false }]);
    assert_eq!(grid(&moebius, [40, 4]).seams(), [Seam { direction: 0, reversed: true }]);
    // Both directions of a ring.
    let ring = |u: f64, v: f64| {
        let r = 5.0 + (TAU * v).cos();
        [r * (TAU * u).cos(), r * (TAU * u).sin(), (TAU * v).sin()]
    };
    assert_eq!(grid(&ring, [24, 12]).seams().len(), 2);
    // A tube with a slit of part of an edge, 24 edges on what is left.
    let slit = |part: f64| grid(&move |u, v| tower(u * 24.0 / (24.0 + part), v), [24, 20]);
    assert_eq!((slit(0.9).seams(), slit(1.2).seams()), (vec![COLUMNS], vec![]));
    // Slim strips have near borders and no seam; nor has a roof, nor a vault that comes down to the ground.
    for slim in [[1, 12], [2, 12], [3, 12], [4, 40]] {
        assert_eq!(grid(&|u, v| [0.01 * u, v, 0.1 * v * v], slim).seams(), []);
    }
    let vault = |u: f64, v: f64| [8.0 * (PI * u).cos(), 20.0 * v, 5.0 * (PI * u).sin()];
    assert_eq!(grid(&vault, [20, 20]).seams(), []);
}

#[test]
fn nodes_and_closed_directions_have_no_seam() {
    for parameters in [(5.0, 1.0, 5.0), (5.0, 3.0, 1.0), (4.0, 0.0, 1.0), (5.0, 1.0, 6.0)] {
        let (a, c, mu) = parameters;
        for net in DupinCyclide::new(a, c, mu).unwrap().nets([6, 6]).unwrap() {
            assert_eq!(net.grid().seams(), [], "{parameters:?}");
        }
    }
}

#[test]
fn a_surface_that_closes_has_neither_gap_nor_angle_at_its_seam() {
    let cone = grid(&|u, v| [(3.0 - v) * (TAU * u).cos(), (3.0 - v) * (TAU * u).sin(), 2.0 * v], [12, 5]);
    let net = CyclidicNet::new(cone, NetFrame::Auto).unwrap();
    let measure = net.measure_seam(COLUMNS).unwrap();
    // Rounding of points of size 3, carried round by twelve weights.
    assert!(measure.gap < 1e-13 && measure.angle < 1e-12, "{measure:?}");
    // It has no borders across.
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([4, 4]).unwrap();
    assert!(ring.iter().all(|net| net.measure_seam(COLUMNS).is_none()));
}

#[test]
fn gaps_and_angles_are_those_of_dense_samples() {
    let before = grid(&tower, [24, 20]);
    let mesh = make_circular(&before, &CircularMeshOptions::default()).unwrap();
    let net = CyclidicNet::new(mesh.grid, NetFrame::Auto).unwrap();
    let measure = net.measure_seam(before.seams()[0]).unwrap();
    // Cut open, the sides of the seam go their own ways: by about half a meter of 120.
    assert!(measure.gap > 0.1, "{measure:?}");
    let border = |column: usize, s: f64| -> Vec<(Point3, cyclide::Vec3)> {
        let rows = (0..net.size()[1]).map(|row| net.patch(column, row));
        let at = |k: i32| f64::from(k) / 200.0;
        rows.flat_map(|p| (0..=200).map(move |k| (p.point(s, at(k)), p.unit_normal(s, at(k))))).collect()
    };
    let (first, last) = (border(0, 0.0), border(23, 1.0));
    let (mut gap, mut angle) = (0.0_f64, 0.0_f64);
    for (one, other) in [(&first, &last), (&last, &first)] {
        for (p, n) in one {
            let (q, m) = other.iter().min_by(|a, b| a.0.distance(*p).total_cmp(&b.0.distance(*p))).unwrap();
            gap = gap.max(p.distance(*q));
            angle = angle.max(n.angle(*m));
        }
    }
    // Nine samples of the arcs, which may end beside each other, against two hundred of the whole borders.
    assert!((measure.gap / gap - 1.0).abs() < 0.05, "{measure:?} {gap}");
    assert!((measure.angle / angle - 1.0).abs() < 0.05, "{measure:?} {angle}");
}
