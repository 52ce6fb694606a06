//! What every surface of a face gives: the same as the surface itself, and bounds of cells that hold.

#![allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
#![allow(clippy::float_cmp, reason = "what is handed on is the same double")]

use cyclide::{
    Point3, Vec3,
    surface::{CyclidePatch, DupinCyclide, ParamSurface as _},
    topology::{FaceGeometry, FaceSurface, Shell},
};
use cyclide_testkit::rational_faces::{egg, smooth_pair};

/// An eighth of a sphere, patches of a ring, of a ring offset to a horn (lines that are points inside), faces that are no
/// cyclides, with weights and a pole, and a patch in its rational form.
fn surfaces() -> Vec<FaceSurface> {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
    let octant = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let horn = ring.offset(-1.01).unwrap();
    let patches = [ring, horn].into_iter().flat_map(|net| net.patches().collect::<Vec<_>>());
    let of = |shell: &Shell| shell.faces().iter().map(|face| face.surface.clone()).collect::<Vec<_>>();
    let rational = [octant.to_rational().into()].into_iter().chain(of(&smooth_pair())).chain(of(&egg().outer));
    patches.chain([octant]).map(FaceSurface::from).chain(rational).collect()
}

#[test]
fn the_surface_of_a_face_hands_on_all_that_its_own_surface_gives() {
    let places: Vec<f64> = (0..=4).map(|k| f64::from(k) / 4.0).collect();
    let (mut flat, mut singular, mut plane) = (0, 0, 0);
    let square = [[0.0, 0.0, 0.0, 1.0], [0.0, 2.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0], [1.0, 3.0, 0.0, 1.0]];
    let square = cyclide::rational::RationalBezierSurface::new([1, 1], square.to_vec()).unwrap();
    for face in surfaces().into_iter().chain([square.into()]) {
        let own: &dyn FaceGeometry = match &face {
            FaceSurface::Cyclide(patch) => patch,
            FaceSurface::Rational(surface) => surface,
        };
        assert_eq!(face.corners(), own.corners());
        assert_eq!(face.bounds(), own.bounds());
        assert_eq!(face.to_rational(), own.to_rational());
        assert_eq!(face.cell_distances(&places, &places, 1e-3), own.cell_distances(&places, &places, 1e-3));
        assert_eq!(face.cell_distance([0.2, 0.3], [0.5, 0.7]), own.cell_distance([0.2, 0.3], [0.5, 0.7]));
        assert_eq!(face.line_bends(&places), own.line_bends(&places));
        assert_eq!((face.singular_s(), face.singular_t()), (own.singular_s(), own.singular_t()));
        assert_eq!((face.has_flat_cells(), face.is_plane_quad()), (own.has_flat_cells(), own.is_plane_quad()));
        assert_eq!(face.is_regular(), own.is_regular());
        assert_eq!(face.is_regular(), face.singular_s().is_empty() && face.singular_t().is_empty());
        for (s, t) in [(0.1, 0.2), (0.5, 0.5), (0.9, 0.3)] {
            assert_eq!(face.unit_normal(s, t), own.unit_normal(s, t));
            assert_eq!(face.side_of_normal(s, t), own.side_of_normal(s, t));
            assert_eq!(face.line_curvatures(s, t).map(f64::to_bits), own.line_curvatures(s, t).map(f64::to_bits));
            assert_eq!(face.s_line(t).unwrap().point(s), own.s_line(t).unwrap().point(s));
            assert_eq!(face.t_line(s).unwrap().point(t), own.t_line(s).unwrap().point(t));
        }
        flat += usize::from(face.has_flat_cells());
        singular += usize::from(!face.is_regular());
        plane += usize::from(face.is_plane_quad());
    }
    // Of both answers some.
    assert!(flat > 16 && singular > 0 && plane == 1, "{flat} {singular} {plane}");
}

/// Distance of a point from a triangle.
fn from_triangle(p: Point3, [a, b, c]: [Point3; 3]) -> f64 {
    let from_segment = |a: Point3, b: Point3| {
        let (way, off) = (b - a, p - a);
        let along = if way.max_abs() > 0.0 { (off.dot(way) / way.dot(way)).clamp(0.0, 1.0) } else { 0.0 };
        (off - way * along).length()
    };
    let sides = from_segment(a, b).min(from_segment(b, c)).min(from_segment(c, a));
    let Some(normal) = (b - a).cross(c - a).unit() else { return sides };
    let is_inside = |from: Point3, to: Point3| (to - from).cross(p - from).dot(normal) >= 0.0;
    if is_inside(a, b) && is_inside(b, c) && is_inside(c, a) { (p - a).dot(normal).abs() } else { sides }
}

/// The distance that is proved holds. Of patches it is that of the points within the factor 4 at most by which both bulges may add
/// up where they are not both largest; that of rational surfaces counts how the parameter runs, too. Both fall with the square of the
/// width.
#[test]
fn no_point_of_a_cell_is_farther_from_its_polygons_than_proved() {
    let mut checked = 0;
    for face in surfaces() {
        for (s0, t0) in [(0.0, 0.0), (0.35, 0.6), (0.9, 0.85)] {
            let (s, t) = ([s0, s0 + 0.1], [t0, t0 + 0.1]);
            let proved = face.cell_distance(s, t);
            let corner = |i: usize, j: usize| face.point(s[i], t[j]);
            let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            if face.singular_s().iter().any(|&at| s[0] < at && at < s[1])
                || face.singular_t().iter().any(|&at| t[0] < at && at < t[1])
            {
                // Two lobes under one polygon.
                assert_eq!(proved, f64::INFINITY);
                continue;
            }
            let mut found = 0.0_f64;
            for k in 0..21 * 21 {
                let [u, v] = [k % 21, k / 21].map(|k| f64::from(k) / 20.0);
                let p = face.point(s[0] + 0.1 * u, t[0] + 0.1 * v);
                let halves = |pair: [[Point3; 3]; 2]| {
                    pair.map(|half| from_triangle(p, half)).into_iter().fold(f64::INFINITY, f64::min)
                };
                found = found.max(halves([[a, b, c], [a, c, d]]).max(halves([[a, b, d], [b, c, d]])));
            }
            let rounding = 1e-14 * face.bounds().max_abs();
            assert!(found <= proved + rounding, "{found:e} of {proved:e}: {face:?}");
            if face.has_flat_cells() {
                assert!(proved <= 4.0 * found + rounding, "{found:e} of {proved:e}: {face:?}");
            }
            let half = face.cell_distance([s0, s0 + 0.05], [t0, t0 + 0.05]);
            assert!(half <= 0.4 * proved + rounding, "{half:e} of {proved:e}: {face:?}");
            checked += usize::from(found > rounding);
        }
    }
    assert!(checked > 60, "{checked}");
}

#[test]
fn cells_ask_for_as_many_cuts_as_they_need() {
    for face in surfaces().into_iter().filter(FaceGeometry::is_regular) {
        let tolerance = 1e-3 * face.bounds().diagonal();
        let mut n = 1.0;
        // Each round as many times as many cuts as the worst cell asks for.
        let within = (0..20).any(|_| {
            let cuts: Vec<f64> = (0..=n as usize).map(|k| k as f64 / n).collect();
            let found = face.cell_distances(&cuts, &cuts, tolerance);
            assert_eq!(found.excess.each_ref().map(Vec::len), [cuts.len() - 1; 2]);
            let worst = found.excess.iter().flatten().fold(0.0_f64, |most, &excess| most.max(excess));
            assert_eq!(worst <= 1.0, found.distance <= tolerance, "{worst} {:e} of {tolerance:e}", found.distance);
            n = (n * worst.clamp(1.1, 8.0)).ceil();
            worst <= 1.0
        });
        assert!(within, "{n} {face:?}");
    }
}

#[test]
fn nothing_is_proved_of_what_are_no_cuts() {
    for face in surfaces() {
        for cuts in [&[][..], &[0.5], &[0.5, 0.2], &[-0.1, 1.0], &[0.0, 1.1], &[0.0, f64::NAN, 1.0]] {
            for found in [face.cell_distances(cuts, &[0.0, 1.0], 1.0), face.cell_distances(&[0.0, 1.0], cuts, 1.0)] {
                assert_eq!(found.distance, f64::INFINITY, "{cuts:?}");
                assert!(found.excess.iter().flatten().all(|&excess| excess == f64::INFINITY));
            }
        }
        assert!(face.line_bends(&[]).at(0, 0).is_none() && face.line_bends(&[0.5]).at(0, 0).is_some());
    }
}
