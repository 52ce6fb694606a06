//! Pipes about chains of arcs and segments: closed forms of their volume and area, joints, miters, closed runs, and what is refused.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Point3, Vec3,
    construct::{ArcSplineOptions, Pipe, PipeEnds},
    curve::{Arc, ArcPath},
    mesh::tessellate,
    surface::{ParamSurface as _, PatchKind},
    topology::{Body, FaceSurface, Shell, surface_joints},
};
use std::f64::consts::PI;

fn at(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

/// A run with eight bends in all directions.
fn run(scale: f64, place: Vec3) -> ArcPath {
    let points = [
        [0.0, 0.0, 0.0],
        [90.0, 0.0, 0.0],
        [90.0, 60.0, 0.0],
        [90.0, 60.0, 80.0],
        [30.0, 110.0, 80.0],
        [30.0, 170.0, 40.0],
        [-40.0, 170.0, 40.0],
        [-40.0, 100.0, 10.0],
        [-100.0, 100.0, 10.0],
        [-100.0, 40.0, 60.0],
    ];
    let points = points.map(|[x, y, z]| at(x, y, z)).map(|p| Point3::ORIGIN + p.to_vec() * scale + place);
    ArcPath::rounded_polyline(&points, false, &[15.0 * scale; 10]).unwrap()
}

/// The largest distance of points of the outer faces from the tube about a spine.
fn off_tube(shell: &Shell, spine: &ArcPath, radius: f64) -> f64 {
    let places = || [0.0, 0.23, 0.5, 0.81, 1.0];
    let faces = shell
        .faces()
        .iter()
        .flat_map(|face| places().into_iter().flat_map(move |s| places().map(move |t| face.surface.point(s, t))));
    faces.map(|p| (spine.closest_point(p).distance - radius).abs()).fold(0.0, f64::max)
}

/// The largest angle between the normals of neighbors.
fn kink(body: &Body) -> f64 {
    body.shells().flat_map(surface_joints).map(|joint| joint.angle).fold(0.0, f64::max)
}

#[test]
fn a_run_has_the_measures_of_pappus() {
    for (scale, place) in [(1.0, Vec3::ZERO), (1e-6, Vec3::ZERO), (1e5, Vec3::new(3e6, -1e6, 2e6))] {
        let spine = run(scale, place);
        let (radius, wall) = (6.0 * scale, 1.5 * scale);
        let length = spine.length();
        let solid = Pipe::new(radius).unwrap().body(&spine).unwrap();
        assert!(solid.is_solid());
        let (area, volume) = (solid.outer.area(), solid.outer.volume());
        assert!((volume / (PI * radius * radius * length) - 1.0).abs() < 1e-11, "{scale}: {volume}");
        assert!((area / (2.0 * PI * radius * (length + radius)) - 1.0).abs() < 1e-11, "{scale}: {area}");
        let bored = Pipe::new(radius).unwrap().with_wall(wall).unwrap().body(&spine).unwrap();
        assert!(bored.is_solid() && bored.voids.is_empty());
        let ring = PI * (radius * radius - (radius - wall).powi(2));
        assert!((bored.outer.volume() / (ring * length) - 1.0).abs() < 1e-11);
        let round = Pipe::new(radius).unwrap().with_ends(PipeEnds::Round).body(&spine).unwrap();
        let want = PI * radius * radius * (length + 4.0 / 3.0 * radius);
        assert!(round.is_solid() && (round.outer.volume() / want - 1.0).abs() < 1e-11);
        assert!(kink(&round) < 1e-9, "{}", kink(&round));
        // Of a round pipe every point is at the radius from the spine, its caps included.
        assert!(off_tube(&round.outer, &spine, radius) < 1e-10 * length);
        let open = Pipe::new(radius).unwrap().with_ends(PipeEnds::Open).body(&spine).unwrap();
        assert!(!open.is_solid() && open.outer.faces().len() + 8 == round.outer.faces().len());
    }
}

#[test]
fn faces_are_tori_cylinders_planes_and_spheres() {
    let kind = |face: &cyclide::topology::ShellFace| match &face.surface {
        FaceSurface::Cyclide(patch) => match patch.recognize() {
            PatchKind::Torus { major_radius, minor_radius, .. } => {
                assert!((major_radius - 15.0).abs() < 1e-9 && (minor_radius - 6.0).abs() < 1e-9);
                "torus"
            }
            PatchKind::Cylinder { radius, .. } => {
                assert!((radius - 6.0).abs() < 1e-9);
                "cylinder"
            }
            PatchKind::Sphere { .. } => "sphere",
            PatchKind::Plane { .. } => "plane",
            other => panic!("{other:?}"),
        },
        FaceSurface::Rational(_) => panic!("a rational face"),
    };
    let count = |ends: PipeEnds| {
        let body = Pipe::new(6.0).unwrap().with_ends(ends).body(&run(1.0, Vec3::ZERO)).unwrap();
        let kinds: Vec<&str> = body.outer.faces().iter().map(kind).collect();
        ["torus", "cylinder", "sphere", "plane"].map(|name| kinds.iter().filter(|kind| **kind == name).count())
    };
    assert_eq!(count(PipeEnds::Flat), [32, 36, 0, 8]);
    assert_eq!(count(PipeEnds::Round), [32, 36, 8, 0]);
}

#[test]
fn corners_of_segments_are_mitred() {
    let points =
        [at(0.0, 0.0, 0.0), at(50.0, 0.0, 0.0), at(50.0, 40.0, 0.0), at(20.0, 70.0, 30.0), at(20.0, 70.0, 90.0)];
    let spine = ArcPath::rounded_polyline(&points, false, &[0.0; 5]).unwrap();
    let body = Pipe::new(5.0).unwrap().body(&spine).unwrap();
    // What a miter cuts off on the inner side it adds on the outer one.
    assert!(body.is_solid());
    assert!((body.outer.volume() / (PI * 25.0 * spine.length()) - 1.0).abs() < 1e-12);
    // Each face is on the cylinder of its segment.
    let mut found = 0.0_f64;
    for face in body.outer.faces().iter().filter(|face| matches!(face.surface, FaceSurface::Rational(_))) {
        let p = face.surface.point(0.4, 0.5);
        let on = spine.arcs().iter().map(|arc| {
            let way = (arc.end() - arc.start()).unit().unwrap();
            let off = |p: Point3| ((p - arc.start()).cross(way).length() - 5.0).abs();
            off(p).max(off(face.surface.point(0.7, 0.0))).max(off(face.surface.point(0.1, 1.0)))
        });
        found = found.max(on.fold(f64::INFINITY, f64::min));
    }
    assert!(found < 1e-13, "{found:e}");
    let refused = |points: &[Point3], radius: f64| {
        let spine = ArcPath::rounded_polyline(points, false, &vec![0.0; points.len()]).unwrap();
        Pipe::new(radius).unwrap().body(&spine).unwrap_err()
    };
    // A step that is shorter than the pipe is wide: the miters cross.
    let step = [at(0.0, 0.0, 0.0), at(50.0, 0.0, 0.0), at(50.0, 9.0, 0.0), at(0.0, 9.0, 0.0)];
    assert_eq!(refused(&step, 5.0).reason(), "mitre-does-not-fit");
    assert_eq!(refused(&[at(0.0, 0.0, 0.0), at(50.0, 0.0, 0.0), at(0.0, 1.0, 0.0)], 5.0).reason(), "corner-not-mitred");
    let arc = Arc::from_three_points(at(50.0, 0.0, 0.0), at(60.0, 10.0, 0.0), at(50.0, 20.0, 0.0)).unwrap();
    let mixed = ArcPath::new(vec![Arc::segment(at(0.0, 5.0, 9.0), at(50.0, 0.0, 0.0)).unwrap(), arc], false).unwrap();
    assert_eq!(Pipe::new(2.0).unwrap().body(&mixed).unwrap_err().reason(), "corner-not-mitred");
}

#[test]
fn closed_runs_close() {
    let radius = 4.0;
    let check = |spine: &ArcPath, rational: usize| {
        let body = Pipe::new(radius).unwrap().with_wall(1.0).unwrap().body(spine).unwrap();
        assert!(body.is_solid() && body.voids.len() == 1);
        let volume: f64 = body.shells().map(Shell::volume).sum();
        assert!((volume / (PI * 7.0 * spine.length()) - 1.0).abs() < 1e-11, "{volume}");
        assert!(kink(&body) < 1e-9 && off_tube(&body.outer, spine, radius) < 1e-11 * spine.length());
        let faces = body.outer.faces().iter();
        assert_eq!(faces.filter(|face| matches!(face.surface, FaceSurface::Rational(_))).count(), rational);
        let mesh = tessellate(&body, 0.05).unwrap();
        assert!(mesh.bound <= 0.05);
    };
    // In a plane, rounded: all analytic.
    let plane = [at(0.0, 0.0, 5.0), at(60.0, 0.0, 5.0), at(70.0, 50.0, 5.0), at(-10.0, 40.0, 5.0)];
    check(&ArcPath::rounded_polyline(&plane, true, &[12.0; 4]).unwrap(), 0);
    // In space the circle has turned when it comes back: four faces are twisted, on a cylinder here.
    let space = [at(0.0, 0.0, 0.0), at(60.0, 0.0, 10.0), at(70.0, 50.0, -20.0), at(-10.0, 40.0, 30.0)];
    check(&ArcPath::rounded_polyline(&space, true, &[12.0; 4]).unwrap(), 4);
    // And on a torus of arcs alone.
    let points: Vec<Point3> = (0..9)
        .map(|k| f64::from(k) * 2.0 * PI / 9.0)
        .map(|u| at(40.0 * u.cos(), 40.0 * u.sin(), 9.0 * (2.0 * u).sin()))
        .collect();
    check(&ArcPath::spline(&points, &ArcSplineOptions { closed: true, ..ArcSplineOptions::default() }).unwrap(), 4);
}

#[test]
fn mitred_closed_frames_close() {
    // A crooked quadrilateral of four segments: every section is a miter, one segment is twisted.
    let points = [at(0.0, 0.0, 0.0), at(60.0, 0.0, 10.0), at(70.0, 50.0, -20.0), at(-10.0, 40.0, 30.0)];
    let spine = ArcPath::rounded_polyline(&points, true, &[0.0; 4]).unwrap();
    let body = Pipe::new(4.0).unwrap().body(&spine).unwrap();
    assert!(body.is_solid() && body.outer.faces().len() == 16);
    assert!((body.outer.volume() / (PI * 16.0 * spine.length()) - 1.0).abs() < 1e-11);
}

#[test]
fn pipes_that_meet_themselves_are_refused() {
    let bend = |turns: f64, pitch: f64| {
        let points: Vec<Point3> = (0..=(24.0 * turns) as u32)
            .map(|k| f64::from(k) * PI / 12.0)
            .map(|u| at(20.0 * u.cos(), 20.0 * u.sin(), pitch * u / (2.0 * PI)))
            .collect();
        ArcPath::spline(&points, &ArcSplineOptions::default()).unwrap()
    };
    let reason = |spine: &ArcPath, radius: f64, ends: PipeEnds| {
        Pipe::new(radius).unwrap().with_ends(ends).body(spine).err().map(|e| e.reason())
    };
    let coil = bend(4.0, 10.0);
    assert_eq!(reason(&coil, 4.9, PipeEnds::Flat), None);
    assert_eq!(reason(&coil, 5.1, PipeEnds::Flat), Some("pipe-meets-itself"));
    assert_eq!(reason(&coil, 20.5, PipeEnds::Flat), Some("pipe-too-wide"));
    // A ring with a gap: flat ends may face each other, round ones need room.
    let ring = Arc::from_three_points(at(20.0, 1.0, 0.0), at(-20.0, 0.0, 0.0), at(20.0, -1.0, 0.0)).unwrap();
    let ring = ArcPath::new(vec![ring], false).unwrap();
    assert_eq!(reason(&ring, 5.0, PipeEnds::Flat), None);
    assert_eq!(reason(&ring, 5.0, PipeEnds::Round), Some("pipe-meets-itself"));
    // An end before the side of the run: at more than a radius for flat ends, two for round ones.
    for (gap, ends, want) in [
        (7.0, PipeEnds::Flat, None),
        (4.0, PipeEnds::Flat, Some("pipe-meets-itself")),
        (7.0, PipeEnds::Round, Some("pipe-meets-itself")),
        (11.0, PipeEnds::Round, None),
    ] {
        let points =
            [at(0.0, 0.0, 0.0), at(90.0, 0.0, 0.0), at(90.0, 60.0, 0.0), at(40.0, 60.0, 0.0), at(40.0, gap, 0.0)];
        let spine = ArcPath::rounded_polyline(&points, false, &[12.0; 5]).unwrap();
        assert_eq!(reason(&spine, 5.0, ends), want, "{gap} {ends:?}");
    }
}

#[test]
fn bends_fit_or_are_refused() {
    let points = [at(0.0, 0.0, 0.0), at(30.0, 0.0, 0.0), at(30.0, 30.0, 0.0), at(60.0, 30.0, 0.0)];
    let path = |radius: f64| ArcPath::rounded_polyline(&points, false, &[radius; 4]);
    // Both arcs fill the leg between: no segment there.
    let filled = path(15.0).unwrap();
    assert_eq!(filled.arcs().len(), 4);
    assert!((filled.length() - (30.0 + 15.0 * PI)).abs() < 1e-12);
    assert_eq!(path(15.1).unwrap_err().reason(), "bend-does-not-fit");
    assert_eq!(path(-1.0).unwrap_err().reason(), "radius-not-positive");
    assert_eq!(path(f64::NAN).unwrap_err().reason(), "not-finite");
    let back = [at(0.0, 0.0, 0.0), at(30.0, 0.0, 0.0), at(0.0, 0.0, 0.0)];
    assert_eq!(ArcPath::rounded_polyline(&back, false, &[1.0; 3]).unwrap_err().reason(), "bend-does-not-fit");
    // A closed square whose arcs fill all legs is a circle.
    let square = [at(1.0, 1.0, 0.0), at(-1.0, 1.0, 0.0), at(-1.0, -1.0, 0.0), at(1.0, -1.0, 0.0)];
    let circle = ArcPath::rounded_polyline(&square, true, &[1.0; 4]).unwrap();
    assert!(circle.arcs().len() == 4 && (circle.length() - 2.0 * PI).abs() < 1e-14);
}

/// The spike of a sharp miter reaches far beyond the balls about the spine, the rim of a slanted end half as far.
#[test]
fn spikes_and_rims_that_run_into_the_pipe_are_found() {
    let body = |points: &[[f64; 3]], bend: f64, radius: f64| {
        let points: Vec<Point3> = points.iter().map(|p| Point3::from(*p)).collect();
        let spine = ArcPath::rounded_polyline(&points, false, &vec![bend; points.len()]).unwrap();
        Pipe::new(radius).unwrap().body(&spine).map_err(|e| e.reason()).map(|body| body.outer.volume())
    };
    let spike = |x: f64, y: f64| {
        [[-40.0, 0.0, 0.0], [0.0, 0.0, 0.0], [-38.0, 14.0, 0.0], [-38.0, 14.0, 20.0], [x, y, 20.0], [x, y, -20.0]]
    };
    assert_eq!(body(&spike(3.94, -0.69), 0.0, 1.0), Err("pipe-meets-itself"));
    assert!(body(&spike(13.94, -2.4), 0.0, 1.0).is_ok());
    let slanted =
        |y: f64| [[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [60.0, 40.0, 0.0], [35.0, y + 25.980_762_1, 0.0], [20.0, y, 0.0]];
    assert_eq!(body(&slanted(2.35), 4.0, 2.0), Err("pipe-meets-itself"));
    assert!(body(&slanted(3.2), 4.0, 2.0).is_ok());
}

/// No thinner pipe helps where the spine crosses itself, at however acute an angle: that is said, and moving the curve apart helps.
#[test]
fn a_spine_that_crosses_itself_is_to_be_moved_apart() {
    let path = |up: f64| {
        let points = [
            [10.5, -49.7, 0.0],
            [-37.3, 23.4, 0.0],
            [-60.8, -14.9, 0.0],
            [69.2, 3.3, up],
            [-2.7, 41.8, up],
            [-82.7, 62.7, up],
            [37.9, -77.9, up],
        ];
        ArcPath::rounded_polyline(&points.map(Point3::from), false, &[0.0, 3.0, 3.0, 3.0, 3.0, 3.0, 0.0]).unwrap()
    };
    for radius in [2.0, 0.36, 1e-3] {
        let error = Pipe::new(radius).and_then(|pipe| pipe.body(&path(0.0))).unwrap_err().to_string();
        assert!(error.contains("they cross: move the curve apart") && !error.contains("thinner"), "{error}");
    }
    assert!(Pipe::new(2.0).and_then(|pipe| pipe.body(&path(20.0))).is_ok());
    // Without a crossing a thinner pipe helps.
    let near = path(3.0);
    let error = Pipe::new(2.0).and_then(|pipe| pipe.body(&near)).unwrap_err().to_string();
    assert!(error.contains("thinner"), "{error}");
    assert!(Pipe::new(0.2).and_then(|pipe| pipe.body(&near)).is_ok());
}
