//! Quad grids made circular: the mesh families of the theory, what the result promises, and what is refused.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "what must not move or must be reported as it is, is compared exactly")]

use cyclide::{
    Error, Point3, Quat, Vec3,
    curve::Circle,
    error::{GridError, PointError},
    surface::QuadGrid,
};
use cyclide_grids::{Border, CircularMesh, CircularMeshOptions, make_circular, make_circular_watched};
use std::f64::consts::TAU;

/// A surface over `[-1, 1]²`.
type Surface = fn(f64, f64) -> [f64; 3];

fn saddle(u: f64, v: f64) -> [f64; 3] {
    [u, v, 0.4 * (u * u - v * v)]
}

fn canopy(u: f64, v: f64) -> [f64; 3] {
    [u + 0.1 * v * v, v + 0.1 * u * u * v, 0.5 * (1.0 - u * u) * (1.0 - 0.5 * v * v) + 0.15 * v]
}

const FAMILIES: [(&str, Surface, f64); 6] = [
    ("saddle", saddle, 0.0),
    ("bump", |u, v| [u, v, 0.8 * (-2.0 * (u * u + v * v)).exp()], 0.0),
    ("waves", |u, v| [u, v, 0.2 * (2.5 * u).sin() + 0.15 * (3.0 * v + 0.5).cos()], 0.0),
    ("canopy", canopy, 0.0),
    ("noisy canopy", canopy, 0.004),
    (
        "sheared ellipsoid",
        |u, v| {
            let (a, b) = (0.9 * u + 0.3 * v, 0.9 * v);
            [1.5 * a.sin() * b.cos(), b.sin(), 0.8 * a.cos() * b.cos()]
        },
        0.0,
    ),
];

/// A number in `[-1, 1]` that depends on its index without a pattern.
fn noise(index: usize) -> f64 {
    let x = (index as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let x = (x ^ (x >> 31)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    ((x ^ (x >> 29)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

/// `faces` times `faces` quads of a surface, every coordinate displaced by up to `noisy`.
fn grid(surface: Surface, faces: usize, noisy: f64) -> QuadGrid {
    let m = faces + 1;
    let at = |k: usize| 2.0 * k as f64 / faces as f64 - 1.0;
    let point = |k: usize| {
        let p = surface(at(k % m), at(k / m));
        Point3::from(std::array::from_fn(|c| p[c] + noisy * noise(3 * k + c)))
    };
    QuadGrid::new((0..m * m).map(point).collect(), [m, m], [false; 2]).unwrap()
}

/// Whatever becomes of the shape: `shape_guard.rs` is about that.
fn circular(grid: &QuadGrid, border: Border<'_>) -> cyclide::Result<CircularMesh> {
    let options = CircularMeshOptions { border, allow_shape_change: true, ..Default::default() };
    make_circular(grid, &options)
}

fn edges(grid: &QuadGrid) -> Vec<f64> {
    let [m, n] = grid.size();
    let mut lengths = Vec::new();
    for j in 0..n {
        for i in 0..m {
            if i + 1 < m || grid.closed()[0] {
                lengths.push(grid.point(i, j).distance(grid.point(i + 1, j)));
            }
            if j + 1 < n || grid.closed()[1] {
                lengths.push(grid.point(i, j).distance(grid.point(i, j + 1)));
            }
        }
    }
    lengths.sort_by(f64::total_cmp);
    lengths
}

/// Largest distance of a quad's last corner from the circle of the others, relative to the quad's size. Another measure
/// than that of the search: the circle is made from three corners.
fn off_circle(grid: &QuadGrid) -> f64 {
    let mut worst: f64 = 0.0;
    for j in 0..grid.quads()[1] {
        for i in 0..grid.quads()[0] {
            let [a, b, c, d] = grid.corners(i, j).map(|k| grid.points()[k]);
            let Ok(circle) = Circle::through_points([a, b, c]) else { continue };
            let radial = d - circle.center();
            let off = radial.dot(circle.normal()).hypot(radial.length() - circle.radius());
            worst = worst.max(off / a.distance(d));
        }
    }
    worst
}

/// The promises of the theory for a converged mesh (`docs/math/circular-meshes.md#search`).
fn check(name: &str, before: &QuadGrid, mesh: &CircularMesh) {
    let report = &mesh.report;
    assert!(report.residual_after < 1e-12, "{name}: {report:?}");
    // Rounding of the circle through three corners of a quad that is no sliver: 1e-12 with a margin of ten.
    assert!(off_circle(&mesh.grid) < 1e-11, "{name}: {:e}", off_circle(&mesh.grid));
    assert_eq!(report.rejected_quads, [0usize; 0], "{name}");
    let lengths = edges(&mesh.grid);
    let ratio = lengths[0] / lengths[lengths.len() / 2];
    assert!(ratio >= 0.30, "{name}: shortest edge {ratio} of the median");
    assert_eq!((mesh.grid.size(), mesh.grid.closed()), (before.size(), before.closed()));
    assert_eq!(farthest(before, mesh), report.moves.max, "{name}");
}

/// The longest move of a vertex.
fn farthest(before: &QuadGrid, mesh: &CircularMesh) -> f64 {
    before.points().iter().zip(mesh.grid.points()).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max)
}

/// Bits of the coordinates of all border vertices.
fn border_bits(grid: &QuadGrid) -> Vec<[u64; 3]> {
    let [m, n] = grid.size();
    let places = (0..n).flat_map(|j| (0..m).map(move |i| (i, j)));
    let border = places.filter(|(i, j)| [0, m - 1].contains(i) || [0, n - 1].contains(j));
    border.map(|(i, j)| grid.point(i, j).to_array().map(f64::to_bits)).collect()
}

#[test]
fn families_of_8_and_20_faces_become_circular() {
    for (name, surface, noisy) in FAMILIES {
        for (faces, most_steps) in [(8, 30), (20, 60)] {
            let before = grid(surface, faces, noisy);
            let mesh = circular(&before, Border::Free).unwrap();
            check(name, &before, &mesh);
            assert!(mesh.report.residual_before > 0.1, "{name} is not circular as given");
            assert!(mesh.report.steps <= most_steps, "{name} {faces}: {} steps", mesh.report.steps);
        }
    }
}

#[test]
fn forty_by_forty_faces_stay_near_the_surface() {
    for (name, surface, noisy) in [FAMILIES[2], FAMILIES[3]] {
        let before = grid(surface, 40, noisy);
        let mesh = circular(&before, Border::Free).unwrap();
        check(name, &before, &mesh);
        // The bound observed in the theory for domains of width 2.
        assert!(mesh.report.moves.max_off_surface <= 0.08, "{name}: {:?}", mesh.report.moves);
        assert!(mesh.report.moves.max <= 0.45, "{name}: {:?}", mesh.report.moves);
    }
}

#[test]
fn grids_along_curvature_lines_move_little_and_grids_across_them_are_warned_of() {
    let along = circular(&grid(saddle, 20, 0.0), Border::Free).unwrap();
    let across = circular(&grid(|u, v| [u, v, 0.6 * u * v], 20, 0.0), Border::Free).unwrap();
    let median = |mesh: &CircularMesh| mesh.report.angle_before.unwrap().median.to_degrees();
    assert!(median(&along) < 5.0 && median(&across) > 40.0, "{} {}", median(&along), median(&across));
    assert!(along.report.angle_after.unwrap().median < along.report.angle_before.unwrap().median);
    assert!(along.warnings().is_empty(), "{:?}", along.warnings());
    assert!(along.report.moves.mean < 0.05 && across.report.moves.mean > 0.2);
    let reasons: Vec<&str> = across.warnings().iter().map(cyclide::Warning::reason).collect();
    assert!(reasons.contains(&"moved-far"), "{reasons:?}");
}

#[test]
fn noise_is_named_as_zigzag() {
    let reasons = |noisy| {
        let mesh = circular(&grid(canopy, 20, noisy), Border::Free).unwrap();
        mesh.warnings().iter().map(cyclide::Warning::reason).collect::<Vec<_>>()
    };
    assert!(!reasons(0.0).contains(&"zigzag"));
    assert!(reasons(0.02).contains(&"zigzag"));
}

#[test]
fn every_step_is_reported_and_ends_below_the_target() {
    let mut steps = Vec::new();
    let mesh =
        make_circular_watched(&grid(saddle, 8, 0.0), &CircularMeshOptions::default(), &mut |s| steps.push(*s)).unwrap();
    assert_eq!(steps.len(), mesh.report.steps);
    assert!(steps.iter().enumerate().all(|(k, s)| s.step == k + 1));
    let last = steps.last().unwrap();
    assert!(last.accepted && last.residual < last.target);
}

#[test]
fn scale_by_a_power_of_two_changes_no_bit_and_other_similarities_little() {
    let before = grid(canopy, 8, 0.0);
    let mesh = circular(&before, Border::Free).unwrap();
    let mapped = |grid: &QuadGrid, map: &dyn Fn(Point3) -> Point3| {
        QuadGrid::new(grid.points().iter().map(|p| map(*p)).collect(), grid.size(), grid.closed()).unwrap()
    };
    for exponent in [-100, -8, 5, 100] {
        let scaled = |p: Point3| Point3::ORIGIN + p.to_vec() * 2.0_f64.powi(exponent);
        let result = circular(&mapped(&before, &scaled), Border::Free).unwrap();
        assert_eq!(result.grid, mapped(&mesh.grid, &scaled), "2^{exponent}");
    }
    let turn = Quat::from_axis_angle(Vec3::new(2.0, -1.0, 2.0) / 3.0, 0.8);
    let similar = |p: Point3| Point3::new(3.0, -1.0, 2.0) + turn.rotate(p.to_vec()) * 1.7;
    let result = circular(&mapped(&before, &similar), Border::Free).unwrap();
    assert_eq!(result.report.steps, mesh.report.steps);
    let expected = mapped(&mesh.grid, &similar);
    let worst = expected.points().iter().zip(result.grid.points()).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
    // Rounding of the input (1e-15) amplified by the steps, whose equations have conditions up to 1e5.
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn what_is_circular_does_not_move() {
    let plane = grid(|u, v| [u, 2.0 * v, 0.5 * u], 6, 0.0);
    let torus = |k: usize| {
        let (a, b) = (TAU * (k % 12) as f64 / 12.0, TAU * (k / 12) as f64 / 10.0);
        let r = 3.0 + b.cos();
        Point3::new(r * a.cos(), r * a.sin(), b.sin())
    };
    let torus = QuadGrid::new((0..120).map(torus).collect(), [12, 10], [true; 2]).unwrap();
    for before in [plane, torus] {
        let mesh = circular(&before, Border::Free).unwrap();
        assert_eq!(mesh.grid, before);
        assert_eq!((mesh.report.steps, mesh.report.moves.max), (0, 0.0));
        assert!(mesh.warnings().is_empty());
    }
}

#[test]
fn a_planar_grid_stays_in_its_plane() {
    let before = grid(|u, v| [u + 0.1 * v * v, v + 0.15 * u * v, 0.0], 8, 0.0);
    let mesh = circular(&before, Border::Free).unwrap();
    check("plane", &before, &mesh);
    assert!(mesh.grid.points().iter().all(|p| p.z == 0.0));
}

#[test]
fn closed_grids_stay_closed() {
    let tube = |[m, n]: [usize; 2], closed_t: bool| {
        let point = |k: usize| {
            let a = TAU * (k % m) as f64 / m as f64;
            let b = TAU * (k / m) as f64 / if closed_t { n as f64 } else { 3.0 * n as f64 };
            let r = 1.0 + 0.15 * (2.0 * b).sin() + 0.1 * (a + b).cos();
            let radius = 4.0 + r * a.cos();
            Point3::new(radius * b.cos(), 1.2 * radius * b.sin(), r * a.sin() + 0.2 * (2.0 * b).cos())
        };
        QuadGrid::new((0..m * n).map(point).collect(), [m, n], [true, closed_t]).unwrap()
    };
    for before in [tube([12, 14], false), tube([12, 24], true), tube([3, 3], false)] {
        let mesh = circular(&before, Border::Free).unwrap();
        check("tube", &before, &mesh);
        assert!(mesh.report.steps > 0);
    }
}

#[test]
fn a_pinned_border_stays_bit_for_bit() {
    // A circular grid whose inner vertices are displaced: its border is known to allow a solution.
    let round = circular(&grid(saddle, 12, 0.0), Border::Free).unwrap().grid;
    let mut points = round.points().to_vec();
    for k in (1..12).flat_map(|j| (1..12).map(move |i| i + 13 * j)) {
        points[k] += Vec3::new(noise(3 * k), noise(3 * k + 1), noise(3 * k + 2)) * 0.01;
    }
    let before = QuadGrid::new(points, [13, 13], [false; 2]).unwrap();
    let mesh = circular(&before, Border::Pinned).unwrap();
    assert!(mesh.report.residual_after < 1e-12 && mesh.report.rejected_quads.is_empty());
    assert_eq!(border_bits(&mesh.grid), border_bits(&before));
    assert!(mesh.report.moves.max > 1e-3);
}

#[test]
fn a_pinned_border_of_a_grid_that_is_not_circular() {
    // Nothing was made circular before: of the families, the borders of this one allow it.
    let (name, waves, _) = FAMILIES[2];
    for faces in [8, 12] {
        let before = grid(waves, faces, 0.0);
        let mesh = circular(&before, Border::Pinned).unwrap();
        check(name, &before, &mesh);
        assert!(mesh.report.residual_before > 0.1 && mesh.report.steps > 0, "{name} is not circular as given");
        assert_eq!(border_bits(&mesh.grid).len(), 4 * faces);
        assert_eq!(border_bits(&mesh.grid), border_bits(&before));
        // Inner vertices moved, and by less than half an edge.
        let moved = mesh.report.moves.max;
        assert!(moved > 0.01 && moved < 0.5 * mesh.report.median_edge, "{moved}");
    }
}

#[test]
fn border_vertices_slide_on_their_curves() {
    // A dome over a circle's arc: the sides s=0 and s=1 slide on two circles, the others are free.
    let before = grid(|u, v| [2.0 * (0.7 * u).sin(), v + 0.1 * u * v, 2.0 * (0.7 * u).cos() - 0.2 * v * v], 12, 0.0);
    let side = |u: f64| {
        let p = |v: f64| Point3::new(2.0 * (0.7 * u).sin(), v + 0.1 * u * v, 2.0 * (0.7 * u).cos() - 0.2 * v * v);
        Circle::through_points([p(-1.0), p(0.0), p(1.0)]).unwrap()
    };
    let curves = [side(-1.0), side(1.0)];
    let mesh = circular(&before, Border::OnCurves([None, None, Some(&curves[0]), Some(&curves[1])])).unwrap();
    check("slide", &before, &mesh);
    let mut slid: f64 = 0.0;
    for j in 0..=12 {
        for (i, circle) in [(0, &curves[0]), (12, &curves[1])] {
            let p = mesh.grid.point(i, j);
            assert!(circle.closest_point(p).distance < 1e-14, "vertex ({i}, {j})"); // rounding of a point of size 2
            slid = slid.max(p.distance(before.point(i, j)));
        }
    }
    assert!(slid > 1e-3);
}

#[test]
fn corners_between_two_curves_stay() {
    let before = grid(|u, v| [u, v, 0.3 * (1.0 - u * u) * (1.0 - v * v)], 10, 0.0);
    let line = |a: [f64; 3], b: [f64; 3]| cyclide::curve::Arc::segment(Point3::from(a), Point3::from(b)).unwrap();
    let (a, b, c, d) = ([-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0], [1.0, 1.0, 0.0]);
    let sides = [line(a, b), line(c, d), line(a, c), line(b, d)];
    let [s0, s1, s2, s3] = &sides;
    let mesh = circular(&before, Border::OnCurves([Some(s0), Some(s1), Some(s2), Some(s3)])).unwrap();
    assert!(mesh.report.residual_after < 1e-12 && mesh.report.rejected_quads.is_empty());
    for (i, j, corner) in [(0, 0, a), (10, 0, b), (0, 10, c), (10, 10, d)] {
        assert_eq!(mesh.grid.point(i, j), Point3::from(corner));
    }
    assert!((0..=10).all(|k| mesh.grid.point(k, 0).y.abs() == 1.0 && mesh.grid.point(k, 0).z == 0.0));
}

/// Part of a torus with radii 5 and 2, as a function of the two angles.
fn torus(u: f64, v: f64) -> Point3 {
    let r = 5.0 + 2.0 * v.cos();
    Point3::new(r * u.cos(), r * u.sin(), 2.0 * v.sin())
}

/// A noisy grid on the torus over `[0, 2] × [-1, 1]`, and its four border circles, each longer by `beyond` at both ends.
fn noisy_torus(noisy: f64, beyond: f64) -> (QuadGrid, [cyclide::curve::Arc; 4]) {
    let place = |k: usize| ((k % 13) as f64 / 6.0, (k / 13) as f64 / 5.0 - 1.0);
    let shaken = |k: usize| {
        let (u, v) = place(k);
        torus(u, v) + Vec3::new(noise(3 * k), noise(3 * k + 1), noise(3 * k + 2)) * noisy
    };
    let before = QuadGrid::new((0..13 * 11).map(shaken).collect(), [13, 11], [false; 2]).unwrap();
    let through = |at: &dyn Fn(f64) -> Point3, [a, b]: [f64; 2]| {
        cyclide::curve::Arc::from_three_points(at(a - beyond), at(0.5 * (a + b)), at(b + beyond)).unwrap()
    };
    let rows = [-1.0, 1.0].map(|v| through(&|u| torus(u, v), [0.0, 2.0]));
    let columns = [0.0, 2.0].map(|u| through(&|v| torus(u, v), [-1.0, 1.0]));
    let [a, b] = rows;
    let [c, d] = columns;
    (before, [a, b, c, d])
}

#[test]
fn sides_slide_on_curves_that_end_at_the_corners() {
    // As quickly as on curves that run past the corners: vertices at the ends are held there.
    for used in [[true, false, false, false], [true, true, false, false], [true, false, true, false], [true; 4]] {
        let (before, curves) = noisy_torus(1e-3, 0.0);
        let sides: [Option<&dyn cyclide::curve::ParamCurve>; 4] =
            std::array::from_fn(|k| used[k].then_some(&curves[k] as &dyn cyclide::curve::ParamCurve));
        let mesh = circular(&before, Border::OnCurves(sides)).unwrap();
        assert!(mesh.report.steps <= 15, "{used:?}: {} steps", mesh.report.steps);
        // The exact grid is within the noise.
        assert!(mesh.report.moves.max < 0.02, "{used:?}: {:e}", mesh.report.moves.max);
        let side = |k: usize, i: usize| if k < 2 { (i, 10 * k) } else { (12 * (k - 2), i) };
        for k in (0..4).filter(|&k| used[k]) {
            for i in 0..if k < 2 { 13 } else { 11 } {
                let (i, j) = side(k, i);
                // Rounding of points of size 7.
                assert!(curves[k].closest_point(mesh.grid.point(i, j)).distance < 1e-14, "{used:?}: ({i}, {j})");
            }
        }
    }
}

#[test]
fn a_corner_between_two_curves_is_where_they_meet() {
    let (before, curves) = noisy_torus(1e-2, 0.1);
    let [a, _, c, _] = &curves;
    let mesh = circular(&before, Border::OnCurves([Some(a), None, Some(c), None])).unwrap();
    let corner = mesh.grid.point(0, 0);
    // A billionth of the edges, which are about 1 long.
    assert!(corner.distance(torus(0.0, -1.0)) < 1e-9 && corner.distance(before.point(0, 0)) > 1e-3);
    let away = cyclide::curve::Arc::segment(Point3::new(9.0, -1.0, 3.0), Point3::new(9.0, 6.0, 3.0)).unwrap();
    let apart = circular(&before, Border::OnCurves([Some(a), None, Some(&away), None])).unwrap_err();
    assert_eq!(apart.reason(), "border-curves-apart");
}

#[test]
fn a_search_that_gets_no_further_is_accepted_below_what_patches_accept() {
    // A needle a million times as high as its cells are wide: rounding stops the search at some 1e-11.
    let needle: Surface = |u, v| [u, v, 1e6 * (-20.0 * ((u - 0.01).powi(2) + v * v)).exp()];
    let mesh = circular(&grid(needle, 8, 0.0), Border::Free).unwrap();
    assert!((1e-12..1e-10).contains(&mesh.report.residual_after), "{:e}", mesh.report.residual_after);
}

#[test]
fn crossing_quads_are_named() {
    // A square's corners in the wrong order lie on a circle: the search has nothing to do.
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from).to_vec();
    let mesh = circular(&QuadGrid::new(points, [2, 2], [false; 2]).unwrap(), Border::Free).unwrap();
    assert_eq!(mesh.report.rejected_quads, [0]);
}

#[test]
fn quads_that_still_cross_after_the_search_are_named() {
    // A vertex exchanged with the next one of its row: the quads beside their edge cross themselves. They get circles
    // like all others, on which their corners are in the wrong order still.
    for (vertex, quads) in [(0, vec![0]), (10, vec![1, 9]), (40, vec![28, 36])] {
        let mut points = grid(saddle, 8, 0.0).points().to_vec();
        points.swap(vertex, vertex + 1);
        let before = QuadGrid::new(points, [9, 9], [false; 2]).unwrap();
        let mut steps = 0;
        let mesh = make_circular_watched(&before, &CircularMeshOptions::default(), &mut |_| steps += 1).unwrap();
        let report = &mesh.report;
        assert_eq!(report.rejected_quads, quads);
        assert!(report.steps > 0 && report.steps == steps, "{} {steps}", report.steps);
        // The vertices exchanged, an edge apart, moved, and far less than the grid is wide.
        let moves = &report.moves;
        assert!(moves.max == farthest(&before, &mesh) && moves.max > 0.1 && moves.max < 1.0, "{moves:?}");
        let [p, q] = [&before, &mesh.grid].map(|grid| grid.points()[moves.farthest_vertex]);
        assert_eq!(p.distance(q), moves.max);
        assert!(report.residual_before > 0.1 && report.residual_after < 1e-12, "{report:?}");
    }
}

#[test]
fn wrong_input_is_refused_by_name() {
    let mut points = grid(saddle, 8, 0.0).points().to_vec();
    points[40] = points[41];
    let repeated = QuadGrid::new(points.clone(), [9, 9], [false; 2]).unwrap();
    let error = circular(&repeated, Border::Free).unwrap_err();
    assert!(matches!(error, Error::Point(PointError::CoincidentPoints { first: 40, second: 41, .. })), "{error}");
    points[40] = Point3::new(f64::NAN, 0.0, 0.0);
    assert_eq!(QuadGrid::new(points, [9, 9], [false; 2]).unwrap_err().reason(), "not-finite");

    // Nine conditions for the three freedoms of the one inner vertex.
    let tight = circular(&grid(|u, v| [u, v + 0.2 * u * u, u * v * v], 2, 0.0), Border::Pinned).unwrap_err();
    assert!(
        matches!(tight, Error::Grid(GridError::NotConverged { step: 1.., residual, .. }) if residual > 1e-3),
        "{tight}"
    );

    let options = CircularMeshOptions { max_steps: 2, ..Default::default() };
    let early = make_circular(&grid(canopy, 8, 0.0), &options).unwrap_err();
    assert!(matches!(early, Error::Grid(GridError::NotConverged { step: 2, .. })), "{early}");
    let options = CircularMeshOptions { max_steps: 0, ..Default::default() };
    let none = make_circular(&grid(canopy, 8, 0.0), &options).unwrap_err();
    assert_eq!(none.reason(), "parameter-out-of-range");

    let ring = (0..8).map(|k| {
        let a = TAU * (k % 4) as f64 / 4.0;
        Point3::new(a.cos(), a.sin(), (k / 4) as f64)
    });
    let ring = QuadGrid::new(ring.collect(), [4, 2], [true, false]).unwrap();
    let curve = cyclide::curve::Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)).unwrap();
    let closed = circular(&ring, Border::OnCurves([None, None, Some(&curve), None])).unwrap_err();
    assert_eq!(closed.reason(), "parameter-out-of-range");
}
