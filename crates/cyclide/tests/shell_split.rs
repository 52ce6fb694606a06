//! Faces cut for export: regular, positive weights, edges and vertices shared bit for bit, the surface unchanged.

#![allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]

use cyclide::{
    Point3, Vec3,
    surface::{CyclidePatch, CyclidicNet, DupinCyclide, NetFrame, ParamSurface as _, QuadGrid},
    topology::{CutShell, FaceGeometry as _, FacePart, Shell},
};
use cyclide_testkit::rational_faces::egg;
use proptest::prelude::*;
use std::f64::consts::PI;

/// Patch of revolution about the third axis over `[u0, u1]`, from its meridian's ends and start direction.
fn revolved(from: [f64; 2], to: [f64; 2], [dr, dz]: [f64; 2], [u0, u1]: [f64; 2]) -> CyclidePatch {
    let at = |[r, z]: [f64; 2], u: f64| Point3::new(r * u.cos(), r * u.sin(), z);
    let n = dr.hypot(dz);
    let (v1, v2) = (Vec3::new(-u0.sin(), u0.cos(), 0.0), Vec3::new(dr * u0.cos() / n, dr * u0.sin() / n, dz / n));
    CyclidePatch::from_corners_and_frame([at(from, u0), at(from, u1), at(to, u0), at(to, u1)], v1, v2).unwrap()
}

/// Everything that a shell of exported faces keeps, and its distance from the patch it came from.
fn check(shell: &Shell, patch: &CyclidePatch) {
    for edge in shell.edges() {
        assert_ne!(edge.start, edge.end);
        assert_eq!(
            (edge.curve.arc().unwrap().start(), edge.curve.arc().unwrap().end()),
            (shell.vertices()[edge.start], shell.vertices()[edge.end])
        );
        assert!(
            edge.curve.arc().unwrap().angle() < 152.0_f64.to_radians(),
            "an edge of {} degrees",
            edge.curve.arc().unwrap().angle().to_degrees()
        );
    }
    assert!(shell.edge_uses().iter().all(|&n| n == 1 || n == 2));
    let ends = [(0, 1), (2, 3), (0, 2), (1, 3)];
    for face in shell.faces() {
        assert!(face.surface.patch().unwrap().is_regular());
        assert!(face.surface.patch().unwrap().real_weights().iter().flatten().all(|&w| w > 0.0));
        let corners = face.surface.patch().unwrap().corners();
        let on = &face.surface;
        let lines = [on.s_line(0.0), on.s_line(1.0), on.t_line(0.0), on.t_line(1.0)];
        for ((side, (from, to)), line) in face.sides.iter().zip(ends).zip(lines) {
            let Some(side) = side else {
                assert_eq!(corners[from], corners[to], "a side without edge is one point");
                continue;
            };
            let edge = &shell.edges()[side.edge];
            let (arc, line) = (if side.forward { edge.curve.clone() } else { edge.curve.reversed() }, line.unwrap());
            assert_eq!((corners[from], corners[to]), (arc.start(), arc.end()));
            // Equal parameters: a few roundings of the coordinates, magnified by the weights (below 1e4 here).
            for t in [0.25, 0.5, 0.75] {
                assert!(arc.point(t).distance(line.point(t)) <= 1e-11 * patch.size().max(arc.length()));
            }
        }
        // Points of the parts are points of the patch: rounding, magnified where the patch comes near infinity.
        for (s, t) in [(0.5, 0.5), (0.1, 0.7)] {
            let p = face.surface.patch().unwrap().point(s, t);
            let far = patch.size().max(p.to_vec().length());
            assert!(patch.locate(p).distance <= 1e-9 * far, "a part is {:e} off", patch.locate(p).distance);
        }
    }
}

/// Area of all faces by the midpoint rule on `n × n` cells.
fn area<'a>(faces: impl Iterator<Item = &'a CyclidePatch>, n: u32) -> f64 {
    let at = |i: u32| (f64::from(i) + 0.5) / f64::from(n);
    faces.map(|p| (0..n * n).map(|k| p.jet(at(k % n), at(k / n)).area_element()).sum::<f64>()).sum::<f64>()
        / f64::from(n * n)
}

/// Every face of a cut shell is that part of a face of the uncut one that it is said to be, and the parts of a face tile it.
fn check_parts(uncut: &Shell, cut: &CutShell) {
    assert_eq!(cut.parts().len(), cut.shell().faces().len());
    for (face, part) in cut.shell().faces().iter().zip(cut.parts()) {
        let whole = &uncut.faces()[part.face];
        assert_eq!(face.same_sense, whole.same_sense);
        let corners = whole.surface.corners();
        let size = corners.iter().map(|p| p.distance(corners[0])).fold(0.0, f64::max);
        for (x, y) in (0..25_u32).map(|k| (f64::from(k % 5) / 4.0, f64::from(k / 5) / 4.0)) {
            let (s, t) = part.place(x, y);
            let (p, q) = (face.surface.point(x, y), whole.surface.point(s, t));
            // Rounding, magnified by the weights (below 1e4 here) and where the surface comes near infinity.
            assert!(p.distance(q) <= 1e-11 * size.max(q.to_vec().length()), "{part:?} is {:e} off", p.distance(q));
        }
    }
    for face in 0..uncut.faces().len() {
        let own: Vec<&FacePart> = cut.parts().iter().filter(|part| part.face == face).collect();
        // Areas are sums of products of differences of numbers up to 1, some hundreds at most.
        let area: f64 = own.iter().map(|part| (part.s[1] - part.s[0]) * (part.t[1] - part.t[0])).sum();
        assert!((area - 1.0).abs() <= 1e-13, "the parts of face {face} have an area of {area}");
        let common = |a: [f64; 2], b: [f64; 2]| (a[1].min(b[1]) - a[0].max(b[0])).max(0.0);
        for (i, a) in own.iter().enumerate() {
            assert!([a.s, a.t].iter().all(|[from, to]| 0.0 <= *from && from < to && *to <= 1.0), "{a:?}");
            for b in &own[..i] {
                assert!(common(a.s, b.s) * common(a.t, b.t) <= 1e-15, "{a:?} and {b:?} overlap");
            }
        }
    }
}

/// Cut for files, as the writers do it.
fn cut_for_files(shell: &Shell) -> CutShell {
    let cut = CutShell::from(shell.clone()).with_regular_faces().unwrap().with_positive_weights().unwrap();
    check_parts(shell, &cut);
    cut
}

fn exported(patch: CyclidePatch) -> Shell {
    let cut = cut_for_files(&Shell::from_surface(patch).unwrap());
    check(cut.shell(), &patch);
    cut.into_shell()
}

#[test]
fn a_patch_that_is_good_stays_one_face() {
    let shell = exported(revolved([2.0, -1.0], [1.0, 2.0], [-1.0, 3.0], [0.3, 2.0]));
    assert_eq!((shell.faces().len(), shell.edges().len(), shell.vertices().len()), (1, 4, 4));
}

#[test]
fn wide_arcs_are_halved_at_their_middle() {
    // 300 degrees: two halves of 150 would be on the limit, so four of 75.
    let shell = exported(revolved([1.0, 0.0], [2.0, 0.0], [1.0, 0.0], [0.0, 2.0 * PI - 0.9]));
    let angles: Vec<f64> = shell.edges().iter().map(|e| e.curve.arc().unwrap().angle()).filter(|a| *a > 1e-9).collect();
    assert!(angles.iter().all(|a| (a - angles[0]).abs() < 1e-12), "{angles:?}");
    let expected = 1.5 * (2.0 * PI - 0.9);
    assert!((area(shell.faces().iter().map(|f| f.surface.patch().unwrap()), 200) / expected - 1.0).abs() < 1e-5);
}

#[test]
fn a_collapsed_side_stays_one_vertex() {
    // Half of a sphere's upper half: the side at the pole is halved with the equator, its parts stay the pole.
    let shell = exported(revolved([2.0, 0.0], [0.0, 2.0], [0.0, 1.0], [0.0, PI]));
    let pole = Point3::new(0.0, 0.0, 2.0);
    assert_eq!(shell.faces().len(), 2);
    assert_eq!((shell.edges().len(), shell.vertices().len()), (5, 4));
    let at_pole = shell.vertices().iter().filter(|v| v.distance(pole) < 1e-9).count();
    assert_eq!(at_pole, 1);
    assert!(shell.faces().iter().all(|f| f.sides.iter().flatten().count() == 3));
}

#[test]
fn a_singular_patch_is_cut_at_its_singular_points() {
    // A spindle torus: the meridian's arc crosses the axis at heights +-sqrt(3), so the middle part is a lune.
    let (u, m) = ([0.2, 1.4], 2.0_f64 / 3.0 * PI);
    let meridian = |a: f64| [1.0 + 2.0 * a.cos(), 2.0 * a.sin()];
    let (a, b) = (m - 0.5, 2.0 * PI - m + 0.5);
    let patch = revolved(meridian(a), meridian(b), [-a.sin(), a.cos()], u);
    assert_eq!(patch.singular_t().len(), 2);
    let shell = exported(patch);
    let node = |z: f64| shell.vertices().iter().filter(|v| v.distance(Point3::new(0.0, 0.0, z)) < 1e-9).count();
    assert_eq!((node(3.0_f64.sqrt()), node(-(3.0_f64.sqrt()))), (1, 1));
    let lunes = shell.faces().iter().filter(|f| f.sides.iter().flatten().count() == 2).count();
    assert_eq!(lunes, 1);
    // Pappus per part: |rho| integrated along the meridian times the angle.
    let n = 200_000;
    let step = (b - a) / f64::from(n);
    let length: f64 = (0..n).map(|k| meridian(a + step * (f64::from(k) + 0.5))[0].abs() * 2.0 * step).sum();
    let expected = length * (u[1] - u[0]);
    assert!((area(shell.faces().iter().map(|f| f.surface.patch().unwrap()), 400) / expected - 1.0).abs() < 1e-5);
}

#[test]
fn neighbors_are_cut_together() {
    // A torus of radii 5 and 2 over arcs of 166 and 63 degrees: both faces of the wide column are halved.
    let (th, ps) = ([0.0_f64, 2.9, 4.0], [0.2_f64, 1.0, 2.0]);
    let at = |th: f64, ps: f64| {
        let rho = 5.0 + 2.0 * ps.cos();
        Point3::new(rho * th.cos(), rho * th.sin(), 2.0 * ps.sin())
    };
    let points = ps.iter().flat_map(|&ps| th.map(|th| at(th, ps))).collect();
    let grid = QuadGrid::new(points, [3, 3], [false, false]).unwrap();
    let frame = NetFrame::First(Vec3::Y, Vec3::new(-ps[0].sin(), 0.0, ps[0].cos()));
    let net = CyclidicNet::new(grid, frame).unwrap();
    let shell = cut_for_files(&net.to_shell().unwrap()).into_shell();
    assert_eq!((shell.faces().len(), shell.edges().len(), shell.vertices().len()), (6, 17, 12));
    let expected = 4.0 * (5.0 * 2.0 * (ps[2] - ps[0]) + 4.0 * (ps[2].sin() - ps[0].sin()));
    assert!((shell.area() / expected - 1.0).abs() < 1e-12);
    // All relations of a shell still hold.
    Shell::new(shell.vertices().to_vec(), shell.edges().to_vec(), shell.faces().to_vec()).unwrap();
}

#[test]
fn strips_of_named_faces_are_halved_as_often_as_asked() {
    let ring = DupinCyclide::new(6.0, 2.0, 3.5).unwrap().to_shell().unwrap();
    let first = ring.faces()[0].surface.patch().unwrap().corners()[0];
    let at_first = |face: &cyclide::topology::ShellFace| face.surface.patch().unwrap().corners()[0] == first;
    // The strips round the ring along t through the first face, and then through the part of it that keeps its corner.
    for (most, faces) in [(0, 16), (1, 20), (2, 24)] {
        let shell = ring.halved(|_, face| [at_first(face), false], most).unwrap();
        assert_eq!(shell.faces().len(), faces);
        assert!(shell.is_closed());
        assert!((shell.area() / ring.area() - 1.0).abs() < 1e-12);
        Shell::new(shell.vertices().to_vec(), shell.edges().to_vec(), shell.faces().to_vec()).unwrap();
    }
}

#[test]
fn cuts_of_cuts_tell_the_parts_of_the_first_faces() {
    // The horn whose nodes are inside of patches, then halved: regular, positive, and in quarters.
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let horn = ring.offset(-1.3).unwrap().to_shell().unwrap();
    assert!(horn.faces().iter().any(|face| !face.surface.is_regular()));
    // Rational faces, two of their sides poles.
    for (shell, least) in [(horn, 20), (egg().outer, 4)] {
        let cut = cut_for_files(&shell);
        assert!(cut.shell().faces().len() >= least);
        let quarters = cut.clone().halved(|_, _| [true, true], 2).unwrap();
        assert_eq!(quarters.shell().faces().len(), 16 * cut.shell().faces().len());
        check_parts(&shell, &quarters);
    }
}

#[test]
fn the_parts_of_cuts_follow_the_faces() {
    let halves = CutShell::from(Shell::from_surface(bent()).unwrap()).halved(|_, _| [true, false], 1).unwrap();
    let [a, b] = halves.parts() else { panic!("{:?}", halves.parts()) };
    assert_eq!((a.s[0], a.s[1], b.s[1], a.t, b.t), (0.0, b.s[0], 1.0, [0.0, 1.0], [0.0, 1.0]));
    // The second half alone is halved along t, and its neighbor with it.
    let corner = halves.shell().faces()[1].surface.corners()[1];
    let quarters = halves.clone().halved(|_, face| [false, face.surface.corners()[1] == corner], 1).unwrap();
    let places: Vec<([f64; 2], f64)> = quarters.parts().iter().map(|part| (part.s, part.t[0])).collect();
    let at = quarters.parts()[0].t[1];
    assert_eq!(places, [(a.s, 0.0), (a.s, at), (b.s, 0.0), (b.s, at)]);
}

/// A patch of no special kind on the corners of a rectangle.
fn bent() -> CyclidePatch {
    let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [2.0, 1.0, 0.0]].map(Point3::from);
    let (v1, v2) = (Vec3::new(2.0, 3.0, 6.0) / 7.0, Vec3::new(-6.0, -2.0, 3.0) / 7.0);
    CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap()
}

#[test]
fn good_shells_stay_as_they_are() {
    let ring = DupinCyclide::new(6.0, 2.0, 3.5).unwrap().to_shell().unwrap();
    assert_eq!(ring.with_regular_faces().unwrap().with_positive_weights().unwrap(), ring);
}

proptest! {
    // The same cases in every run.
    #![proptest_config(ProptestConfig { rng_seed: proptest::test_runner::RngSeed::Fixed(1), ..ProptestConfig::default() })]
    #[test]
    fn random_patches_are_cut_into_good_faces(
        angles in prop::array::uniform4(0.0..2.0 * PI),
        frame in prop::array::uniform6(-1.0..1.0_f64),
    ) {
        let mut angles = angles;
        angles.sort_by(f64::total_cmp);
        let gap = |k: usize| (angles[(k + 1) % 4] - angles[k]).rem_euclid(2.0 * PI);
        prop_assume!((0..4).all(|k| gap(k) > 0.1));
        let at = |k: usize| Point3::new(angles[k].cos(), angles[k].sin(), 0.0);
        let (v, w) = (Vec3::from([frame[0], frame[1], frame[2]]), Vec3::from([frame[3], frame[4], frame[5]]));
        prop_assume!(v.length() > 0.1);
        let v1 = v.unit().unwrap();
        let across = w - v1 * w.dot(v1);
        prop_assume!(across.length() > 0.1);
        let corners = [at(0), at(1), at(3), at(2)];
        let patch = CyclidePatch::from_corners_and_frame(corners, v1, across.unit().unwrap());
        // Patches through infinity are refused; those near it have weights that magnify rounding beyond the test's.
        prop_assume!(patch.is_ok());
        let patch = patch.unwrap();
        // The box is exact: places between others would miss a peak that is narrow.
        prop_assume!(patch.bounds().max_abs() < 30.0);
        exported(patch);
    }
}
