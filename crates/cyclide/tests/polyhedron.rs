//! Convex polyhedra and their smooth offsets: hulls, faces made one, Steiner's formulas, closed solids that are G1.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal as _, Mobius},
    construct::{ConvexPolyhedron, SphericalPolygon},
    mesh::tessellate,
    surface::PatchKind,
    topology::{Body, FaceGeometry as _, FaceSurface, surface_joints},
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Reproducible numbers in [-1, 1] (xorshift).
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn in_cube(&mut self) -> Point3 {
        Point3::new(self.number(), self.number(), self.number())
    }

    fn on_sphere(&mut self) -> Point3 {
        loop {
            let v = self.in_cube().to_vec();
            if (0.01..=1.0).contains(&v.length_squared()) {
                return Point3::ORIGIN + v / v.length();
            }
        }
    }
}

fn cube() -> Vec<Point3> {
    (0..8).map(|k| Point3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2))).collect()
}

fn dodecahedron() -> Vec<Point3> {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut points: Vec<Point3> = cube().iter().map(|p| *p + (*p - Point3::new(1.0, 1.0, 1.0))).collect();
    for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let (x, y) = (a / golden, b * golden);
        points.extend([Point3::new(0.0, x, y), Point3::new(x, y, 0.0), Point3::new(y, 0.0, x)]);
    }
    points
}

/// What holds for every offset.
fn check(polyhedron: &ConvexPolyhedron, radius: f64) -> Body {
    let body = polyhedron.offset(radius).unwrap();
    assert!(body.is_solid());
    // Euler's formula, and the solid angles of the vertices cover the sphere once (Gauss-Bonnet).
    let corners = polyhedron.corner_count();
    assert_eq!(corners + polyhedron.faces().len(), polyhedron.edges().count() + 2);
    let cones = (0..polyhedron.vertices().len()).filter_map(|v| polyhedron.normal_cone(v));
    let solid: f64 = cones.map(SphericalPolygon::solid_angle).sum();
    // Twice would be far off; the normals of a body a millionth as thick as wide are known to 1e-10.
    assert!((solid / (4.0 * PI) - 1.0).abs() < 1e-9, "{solid}");
    // Steiner's formulas against quadrature over all faces, which agrees to 1e-12 with itself.
    let (volume, area) = (body.outer.known_volume().unwrap(), body.outer.known_area().unwrap());
    assert!((volume / polyhedron.offset_volume(radius) - 1.0).abs() < 1e-10, "{volume}");
    assert!((area / polyhedron.offset_area(radius) - 1.0).abs() < 1e-10, "{area}");
    let size = polyhedron.vertices().iter().map(|p| p.distance(polyhedron.vertices()[0])).fold(radius, f64::max);
    let place = polyhedron.vertices().iter().map(|p| p.to_vec().max_abs()).fold(size, f64::max);
    for joint in surface_joints(&body.outer) {
        // Roundings of coordinates; normals lose what the smaller of radius and edges is less than these.
        assert!(joint.gap <= 64.0 * f64::EPSILON * place, "{joint:?}");
        if joint.angle > 1e-7 {
            // Joints inside planes far from the origin, of thin triangles, are known less well.
            let planar = joint.faces.iter().all(|&f| body.outer.faces()[f].surface.to_rational().degrees() == [1, 1]);
            assert!(planar && joint.angle < 1e-5, "{joint:?}");
        }
    }
    body
}

/// How many faces are planes, cylinders and parts of spheres.
fn kinds(body: &Body) -> [usize; 3] {
    let mut kinds = [0; 3];
    for face in body.outer.faces() {
        let kind = match &face.surface {
            FaceSurface::Cyclide(patch) => {
                assert!(matches!(patch.recognize(), PatchKind::Cylinder { outward: true, .. }));
                1
            }
            FaceSurface::Rational(surface) => usize::from(surface.degrees() == [2, 4]) * 2,
        };
        kinds[kind] += 1;
        assert!(face.surface.to_rational().has_positive_weights());
    }
    kinds
}

#[test]
fn a_cube_gives_planes_cylinders_and_octants() {
    let polyhedron = ConvexPolyhedron::hull(&cube()).unwrap();
    assert_eq!((polyhedron.faces().len(), polyhedron.edges().count()), (6, 12));
    let body = check(&polyhedron, 0.25);
    assert_eq!(kinds(&body), [6, 12, 24]);
    let r: f64 = 0.25;
    let volume = 1.0 + 6.0 * r + 3.0 * PI * r * r + 4.0 / 3.0 * PI * r.powi(3);
    assert!((body.outer.known_volume().unwrap() / volume - 1.0).abs() < 1e-12);
    // Every point of the surface is at the distance from the cube.
    let nearest = |x: f64| x.clamp(0.0, 1.0);
    for face in body.outer.faces() {
        for k in 0..25 {
            let p = face.surface.to_rational().point(f64::from(k % 5) / 4.0, f64::from(k / 5) / 4.0);
            let q = Point3::new(nearest(p.x), nearest(p.y), nearest(p.z));
            assert!((p.distance(q) - r).abs() < 4e-15, "{p:?}");
        }
    }
    assert!(tessellate(&body, 1e-3).unwrap().volume() < volume);
}

#[test]
fn the_hull_finds_sides_whatever_lies_in_them() {
    // A grid of 5³ points: 98 of them on the cube, 90 of these inside its sides and edges.
    let grid: Vec<Point3> =
        (0..125).map(|k| Point3::new(f64::from(k % 5), f64::from(k / 5 % 5), f64::from(k / 25))).collect();
    let polyhedron = ConvexPolyhedron::hull(&grid).unwrap();
    assert_eq!((polyhedron.faces().len(), polyhedron.corner_count()), (6, 8));
    assert!((polyhedron.volume() - 64.0).abs() < 1e-12 && (polyhedron.area() - 96.0).abs() < 1e-12);
    // Turned, the points of a side are in a plane to rounding only.
    let turn = Quat::from_axis_angle(Vec3::new(1.0, 2.0, 3.0).unit().unwrap(), 1.0);
    let turned: Vec<Point3> = grid.iter().map(|p| Point3::ORIGIN + turn.rotate(p.to_vec())).collect();
    let polyhedron = ConvexPolyhedron::hull(&turned).unwrap();
    assert_eq!((polyhedron.faces().len(), polyhedron.edges().count(), polyhedron.corner_count()), (6, 12, 8));
    assert!((polyhedron.volume() / 64.0 - 1.0).abs() < 1e-12);
    check(&polyhedron, 0.5);
    // Regular pentagons.
    let polyhedron = ConvexPolyhedron::hull(&dodecahedron()).unwrap();
    assert!(polyhedron.faces().len() == 12 && polyhedron.faces().iter().all(|face| face.len() == 5));
    let body = check(&polyhedron, 0.4);
    // Each pentagon a quad and a triangle.
    assert_eq!(kinds(&body), [24, 30, 60]);
}

#[test]
fn hulls_of_many_points_are_convex_and_contain_all() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    for count in [5, 20, 200] {
        let points: Vec<Point3> = (0..count).map(|_| random.in_cube()).collect();
        let polyhedron = ConvexPolyhedron::hull(&points).unwrap();
        for (face, normal) in polyhedron.faces().iter().zip(polyhedron.normals()) {
            let height = |p: &Point3| (*p - polyhedron.vertices()[face[0]]).dot(*normal);
            assert!(points.iter().all(|p| height(p) < 1e-15));
        }
        check(&polyhedron, 0.1);
    }
    // All points of a sphere are corners of its hull: Euler gives the triangles.
    let points: Vec<Point3> = (0..1000).map(|_| random.on_sphere()).collect();
    let polyhedron = ConvexPolyhedron::hull(&points).unwrap();
    assert_eq!((polyhedron.corner_count(), polyhedron.faces().len()), (1000, 1996));
    assert!(polyhedron.volume() < 4.0 / 3.0 * PI && polyhedron.volume() > 0.98 * 4.0 / 3.0 * PI);
}

#[test]
fn offsets_follow_similarities_and_are_good_at_any_size_and_place() {
    let mut random = Random(42);
    let points: Vec<Point3> = (0..14).map(|_| random.on_sphere()).collect();
    let body = check(&ConvexPolyhedron::hull(&points).unwrap(), 0.3);
    for (scale, far) in [(1e-6, 0.0), (1e6, 0.0), (1.0, 1e4), (1e-3, 1.0)] {
        let turn = Quat::from_axis_angle(Vec3::new(0.0, 0.6, 0.8), 2.0);
        let map = Mobius::similarity(turn, scale, Vec3::new(far, -far, 0.5 * far)).unwrap();
        let moved: Vec<Point3> = points
            .iter()
            .map(|p| Point3::ORIGIN + turn.rotate(p.to_vec()) * scale + Vec3::new(far, -far, 0.5 * far))
            .collect();
        let polyhedron = ConvexPolyhedron::hull(&moved).unwrap();
        let made = check(&polyhedron, 0.3 * scale);
        let image = body.transformed(&map).unwrap();
        assert_eq!(made.outer.faces().len(), image.outer.faces().len());
        let volumes = [&made, &image].map(|body| body.outer.known_volume().unwrap());
        // Points are rounded at their place, and a volume by three times that.
        let rounding = 1e-12 + 100.0 * f64::EPSILON * far / scale;
        assert!((volumes[0] / volumes[1] - 1.0).abs() < rounding, "{scale} {far}");
    }
}

#[test]
fn few_digits_give_planes_with_the_flatness_of_these_digits() {
    // As in a binary STL: the corners of a pentagon are in one plane to single precision, and its triangles are reflex or not.
    let single = |p: &Point3| Point3::new(f64::from(p.x as f32), f64::from(p.y as f32), f64::from(p.z as f32));
    let turn = Quat::from_axis_angle(Vec3::new(1.0, 2.0, 3.0).unit().unwrap(), 1.0);
    let exact: Vec<Point3> = dodecahedron().iter().map(|p| Point3::ORIGIN + turn.rotate(p.to_vec())).collect();
    let points: Vec<Point3> = exact.iter().map(single).collect();
    let coarse = ConvexPolyhedron::hull_with_flatness(&points, 3e-9).unwrap();
    assert!(coarse.faces().len() > 12);
    // By itself the hull takes that of the digits, and says so.
    let by_itself = ConvexPolyhedron::hull(&points).unwrap();
    let warnings = by_itself.warnings();
    assert!(by_itself.faces().len() == 12 && warnings.len() == 1 && warnings[0].reason() == "flatness-raised");
    let polyhedron = ConvexPolyhedron::hull_with_flatness(&points, 5e-7).unwrap();
    assert_eq!((polyhedron.faces().len(), polyhedron.corner_count()), (12, 20));
    for (p, q) in polyhedron.vertices().iter().zip(&points) {
        assert!(p.distance(*q) < 5e-7);
    }
    check(&polyhedron, 0.2);
    // The same from its triangles, whichever way they were cut; four faces at a vertex go to common points in many rounds.
    let triangles: Vec<Vec<usize>> = coarse.faces().iter().flat_map(|face| fan(face)).collect();
    let same = ConvexPolyhedron::with_flatness(&points, &triangles, 5e-7).unwrap();
    assert_eq!(same.faces().len(), 12);
    let rhombic: Vec<Point3> = cube()
        .iter()
        .map(|p| *p + (*p - Point3::new(1.0, 1.0, 1.0)))
        .chain([Vec3::X, Vec3::Y, Vec3::Z].iter().flat_map(|v| [Point3::ORIGIN + *v * 2.0, Point3::ORIGIN - *v * 2.0]))
        .map(|p| single(&(Point3::ORIGIN + turn.rotate(p.to_vec()))))
        .collect();
    let polyhedron = ConvexPolyhedron::hull_with_flatness(&rhombic, 1e-6).unwrap();
    assert_eq!((polyhedron.faces().len(), polyhedron.corner_count(), polyhedron.edges().count()), (12, 14, 24));
    check(&polyhedron, 0.2);
}

/// Triangles from the first corner of a loop.
fn fan(face: &[usize]) -> Vec<Vec<usize>> {
    (1..face.len() - 1).map(|k| vec![face[0], face[k], face[k + 1]]).collect()
}

#[test]
fn flat_pyramids_and_needles_have_positive_weights() {
    // The base corners of a flat pyramid have normals behind the middle of their cones; its base edges turn by nearly half a turn.
    for height in [1.0, 0.1, 1e-2, 1e-3, 1e-5] {
        let base = (0..5).map(|k| TAU * f64::from(k) / 5.0).map(|a| Point3::new(a.cos(), a.sin(), 0.0));
        let points: Vec<Point3> = base.chain([Point3::new(0.1, 0.0, height)]).collect();
        let body = check(&ConvexPolyhedron::hull(&points).unwrap(), 0.5);
        let [planes, cylinders, spheres] = kinds(&body);
        assert_eq!(planes, 5 + 2);
        assert!(cylinders >= 10 && spheres == 2 * cylinders, "{cylinders} {spheres}");
    }
    for length in [10.0, 1e3] {
        let points = [
            Point3::new(1.0, 0.0, 0.0),
            Point3::new(-0.5, 0.9, 0.0),
            Point3::new(-0.5, -0.9, 0.0),
            Point3::new(0.0, 0.0, length),
        ];
        kinds(&check(&ConvexPolyhedron::hull(&points).unwrap(), 0.1));
    }
}

#[test]
fn the_support_function_grows_by_the_radius() {
    let mut random = Random(7);
    let points: Vec<Point3> = (0..20).map(|_| random.in_cube()).collect();
    let polyhedron = ConvexPolyhedron::hull(&points).unwrap();
    let body = polyhedron.offset(0.2).unwrap();
    let mesh = tessellate(&body, 1e-4).unwrap();
    for _ in 0..20 {
        let d = random.on_sphere().to_vec();
        let highest = mesh.positions.iter().map(|p| p.to_vec().dot(d)).fold(f64::NEG_INFINITY, f64::max);
        let support = polyhedron.support(d) + 0.2;
        // A mesh of chords is inside, by no more than its tolerance.
        assert!(highest <= support + 1e-14 && highest >= support - 1e-4, "{highest} {support}");
    }
}

#[test]
fn what_is_no_convex_polyhedron_is_refused_by_name() {
    let faces = vec![
        vec![0, 2, 3, 1],
        vec![4, 5, 7, 6],
        vec![0, 1, 5, 4],
        vec![2, 6, 7, 3],
        vec![0, 4, 6, 2],
        vec![1, 3, 7, 5],
    ];
    let refused = |points: &[Point3], faces: &[Vec<usize>]| ConvexPolyhedron::new(points, faces).unwrap_err();
    let cube = cube();
    assert_eq!(ConvexPolyhedron::new(&cube, &faces).unwrap().offset(0.0).unwrap_err().reason(), "radius-not-positive");
    assert_eq!(
        ConvexPolyhedron::new(&cube, &faces).unwrap().offset(f64::NAN).unwrap_err().reason(),
        "radius-not-positive"
    );
    assert_eq!(
        ConvexPolyhedron::new(&cube, &faces).unwrap().offset(1e-13).unwrap_err().reason(),
        "below-rounding-of-place"
    );
    assert_eq!(
        ConvexPolyhedron::new(&cube, &faces).unwrap().offset(1e13).unwrap_err().reason(),
        "below-rounding-of-place"
    );
    assert_eq!(refused(&cube, &faces[1..]).reason(), "not-closed");
    assert_eq!(refused(&cube, &[]).reason(), "not-a-shell");
    assert_eq!(refused(&cube[..3], &faces).reason(), "too-few-points");
    let mut wrong = faces.clone();
    wrong[2][3] = 8;
    assert_eq!(refused(&cube, &wrong).reason(), "not-a-face");
    let inverted: Vec<Vec<usize>> = faces.iter().map(|face| face.iter().rev().copied().collect()).collect();
    let error = refused(&cube, &inverted);
    assert!(error.reason() == "not-convex" && error.to_string().contains("12 of 12 edges"), "{error}");
    let mut bent = cube.clone();
    bent[7].z = 1.001;
    assert_eq!(refused(&bent, &faces).reason(), "non-planar-face");
    // A cube with a corner pushed in, then one with a pit in its upper side: a face round a hole.
    let mut dented = cube.clone();
    dented[7] = Point3::new(0.3, 0.3, 0.3);
    let triangles: Vec<Vec<usize>> = faces
        .iter()
        .flat_map(|face| {
            let start = face.iter().position(|&v| v == 7).unwrap_or(0);
            let turned: Vec<usize> = (0..4).map(|k| face[(start + k) % 4]).collect();
            fan(&turned)
        })
        .collect();
    assert_eq!(refused(&dented, &triangles).reason(), "not-convex");
    assert!(ConvexPolyhedron::new(&cube, &triangles).unwrap().faces().len() == 6, "triangles of a cube");
    let mut pit = cube.clone();
    pit.extend([(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)].map(|(x, y)| Point3::new(x, y, 1.0)));
    pit.push(Point3::new(0.5, 0.5, 0.5));
    let mut with_pit = faces.clone();
    with_pit.remove(1);
    with_pit.extend([vec![4, 5, 9, 8], vec![5, 7, 11, 9], vec![7, 6, 10, 11], vec![6, 4, 8, 10]]);
    with_pit.extend([vec![8, 9, 12], vec![9, 11, 12], vec![11, 10, 12], vec![10, 8, 12]]);
    assert_eq!(refused(&pit, &with_pit).reason(), "not-convex");
    // Two cubes apart.
    let two: Vec<Point3> = cube.iter().copied().chain(cube.iter().map(|p| *p + Vec3::X * 5.0)).collect();
    let both: Vec<Vec<usize>> =
        faces.iter().cloned().chain(faces.iter().map(|face| face.iter().map(|v| v + 8).collect())).collect();
    assert_eq!(refused(&two, &both).reason(), "not-a-shell");
    let flat: Vec<Point3> = cube.iter().map(|p| Point3::new(p.x, p.y, p.x - 2.0 * p.y)).collect();
    assert_eq!(ConvexPolyhedron::hull(&flat).unwrap_err().reason(), "flat-polyhedron");
    let thin: Vec<Point3> = cube.iter().map(|p| Point3::new(p.x, p.y, 1e-11 * p.z)).collect();
    assert_eq!(ConvexPolyhedron::hull(&thin).unwrap_err().reason(), "flat-polyhedron");
    let far: Vec<Point3> = cube.iter().map(|p| *p + Vec3::X * 1e12).collect();
    assert_eq!(ConvexPolyhedron::hull(&far).unwrap_err().reason(), "below-rounding-of-place");
    let mut nan = cube;
    nan[3].y = f64::NAN;
    assert_eq!(ConvexPolyhedron::hull(&nan).unwrap_err().reason(), "not-finite");
}

#[test]
fn normals_that_nearly_agree_run_round_once() {
    for [low, lower] in [[5e-7, 1e-6], [5e-8, 1e-7]] {
        let base = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(|(x, y)| Point3::new(x, y, 0.0));
        let others = [Point3::new(5.0, 5.0, 10.0), Point3::new(5.0, 5.0, -lower), Point3::new(2.0, 3.0, -low)];
        let points: Vec<Point3> = base.into_iter().chain(others).collect();
        let polyhedron = ConvexPolyhedron::hull(&points).unwrap();
        assert!((polyhedron.volume() * 3.0 / 1000.0 - 1.0).abs() < 1e-6);
        assert_eq!(polyhedron.corner_count() + polyhedron.faces().len(), polyhedron.edges().count() + 2);
        assert!(polyhedron.offset(1.0).unwrap().is_solid());
    }
}

#[test]
fn corners_given_several_times_but_for_rounding_are_one() {
    let mut generator = 1_u64;
    let mut noise = || {
        generator = generator.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((generator >> 11) as f64 / (1_u64 << 53) as f64 - 0.5) * 2e-13
    };
    let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2 & 1].map(|v| v as f64);
    let points: Vec<Point3> = (0..40).map(|k| Point3::from(corner(k).map(|v| v + noise()))).collect();
    let cube = ConvexPolyhedron::hull(&points).unwrap();
    assert_eq!((cube.faces().len(), cube.edges().count()), (6, 12));
    assert!(cube.deviation() > 0.0 && cube.deviation() < 1e-12 && cube.warnings().is_empty());
    let body = cube.offset(0.1).unwrap();
    assert!(surface_joints(&body.outer).iter().all(|joint| joint.angle < 1e-9));
    // Fewer than four that differ, and the same with a flatness given.
    let few: Vec<Point3> = points.iter().enumerate().filter(|(k, _)| k % 8 < 3).map(|(_, p)| *p).collect();
    assert_eq!(ConvexPolyhedron::hull(&few).unwrap_err().reason(), "flat-polyhedron");
    assert_eq!(ConvexPolyhedron::hull_with_flatness(&points, 1e-10).unwrap().faces().len(), 6);
}

#[test]
fn boxes_of_six_digits_have_six_sides() {
    for turn in 0..25 {
        let axis = Vec3::new(1.0, 2.0 - f64::from(turn % 5), 3.0 - f64::from(turn % 7)).unit().unwrap();
        let half = 0.1 + 0.11 * f64::from(turn);
        let rotor = Quat::from_parts(half.cos(), axis * half.sin());
        for digits in [6, 7, 8, 10] {
            let rounded = |v: f64| (v * 10.0_f64.powi(digits)).round() / 10.0_f64.powi(digits);
            let corner = |k: usize| Vec3::new((k & 1) as f64 * 20.0, (k >> 1 & 1) as f64 * 10.0, (k >> 2) as f64 * 5.0);
            let points = (0..8).map(|k| Point3::from(rotor.rotate(corner(k)).to_array().map(rounded)));
            let made = ConvexPolyhedron::hull(&points.collect::<Vec<_>>()).unwrap();
            assert_eq!((made.faces().len(), made.edges().count()), (6, 12), "{turn} {digits}");
            let body = made.offset(1.0).unwrap();
            assert!(surface_joints(&body.outer).iter().all(|joint| joint.angle < 1e-7), "{turn} {digits}");
        }
    }
}

/// Points inside have no part in it, however near to each other.
#[test]
fn equal_points_inside_change_nothing() {
    let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(|v| 10.0 * v as f64);
    let mut points: Vec<Point3> = (0..8).map(|k| Point3::from(corner(k))).collect();
    points.extend([Point3::new(5.0, 5.0, 12.0), Point3::new(5.0, 5.0, 5.0), Point3::new(5.0045, 5.0, 5.0)]);
    let (all, without) =
        [&points[..], &points[..9]].map(|points| ConvexPolyhedron::hull_with_flatness(points, 0.01).unwrap()).into();
    assert_eq!((all.deviation(), all.faces()), (without.deviation(), without.faces()));
    // Outside they count: what is left out is farther than half the flatness from nothing.
    points.push(Point3::new(5.0, 5.0, 12.004));
    let off = ConvexPolyhedron::hull_with_flatness(&points, 0.01).unwrap().deviation();
    assert!((off - 0.004).abs() < 1e-12, "{off}");
}

#[test]
fn the_largest_plane_comes_first() {
    let mut points = cube();
    points[7] = Point3::new(1e5, 1e5, 1e5);
    let body = ConvexPolyhedron::hull(&points).unwrap().offset(1e-3).unwrap();
    let planes = body.outer.faces().iter().map(|face| face.surface.to_rational().degrees() == [1, 1]);
    let planes: Vec<bool> = planes.collect();
    let count = planes.iter().filter(|plane| **plane).count();
    assert!(count > 0 && planes[..count].iter().all(|plane| *plane));
    let size = |k: usize| {
        let surface = body.outer.faces()[k].surface.to_rational();
        let [a, b, c, d] = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(s, t)| surface.point(s, t));
        (d - a).cross(c - b).length()
    };
    assert!((1..count).all(|k| size(k) <= size(0)));
}

#[test]
fn faces_run_round_once() {
    let corner = |k: usize| {
        let (sin, cos) = (FRAC_PI_2 + TAU / 5.0 * (k % 5) as f64).sin_cos();
        Point3::new(10.0 * cos, 10.0 * sin, if k < 5 { 0.0 } else { 8.0 })
    };
    let points: Vec<Point3> = (0..10).map(corner).collect();
    // The sides of a star of five points are convex at every edge and vertex, but its ends are wound twice.
    let prism = |step: usize| -> Vec<Vec<usize>> {
        let around = |k: usize| k * step % 5;
        let mut faces = vec![(0..5).map(|k| 5 + around(k)).collect(), (0..5).rev().map(around).collect()];
        faces.extend((0..5).map(|k| vec![around(k), around(k + 1), 5 + around(k + 1), 5 + around(k)]));
        faces
    };
    let error = ConvexPolyhedron::new(&points, &prism(2)).unwrap_err();
    assert!(error.reason() == "not-a-face" && error.to_string().contains("face 0"), "{error}");
    let pentagon = ConvexPolyhedron::new(&points, &prism(1)).unwrap();
    let volume = 8.0 * 250.0 * (TAU / 5.0).sin();
    assert!((pentagon.volume() / volume - 1.0).abs() < 1e-14);
}

#[test]
fn polygons_of_spheres_are_in_an_open_half() {
    let octant = SphericalPolygon::new(&[Vec3::X, Vec3::Y * 3.0, Vec3::Z]).unwrap();
    assert!((octant.solid_angle() - FRAC_PI_2).abs() < 1e-15);
    assert_eq!(octant.fan(Point3::ORIGIN, 1.0, 3).unwrap_err().reason(), "parameter-out-of-range");
    assert_eq!(octant.fan(Point3::ORIGIN, -1.0, 0).unwrap_err().reason(), "radius-not-positive");
    let refused = |corners: &[Vec3]| SphericalPolygon::new(corners).unwrap_err().reason();
    assert_eq!(refused(&[Vec3::X, Vec3::Z, Vec3::Y]), "not-in-open-hemisphere");
    assert_eq!(refused(&[Vec3::X, -Vec3::X, Vec3::Y]), "not-in-open-hemisphere");
    assert_eq!(refused(&[Vec3::X, Vec3::ZERO, Vec3::Y]), "zero-axis");
    assert_eq!(refused(&[Vec3::X, Vec3::Y]), "too-few-points");
    // Five corners of a star run round it twice.
    let star: Vec<Vec3> =
        (0..5).map(|k| 2.0 * TAU * f64::from(k) / 5.0).map(|a| Vec3::new(a.cos(), a.sin(), 1.0)).collect();
    assert_eq!(refused(&star), "not-in-open-hemisphere");
}

/// The box of three edges, each side cut into squares of two triangles, moved by a map; every point once.
fn cut_box(edges: [f64; 3], parts: i32, map: impl Fn(Point3) -> Point3) -> (Vec<Point3>, Vec<Vec<usize>>) {
    let (mut keys, mut points, mut triangles): (Vec<[i32; 3]>, Vec<Point3>, Vec<Vec<usize>>) = Default::default();
    let mut vertex = |key: [i32; 3]| {
        keys.iter().position(|other| *other == key).unwrap_or_else(|| {
            let at = [0, 1, 2].map(|k| edges[k] * f64::from(key[k]) / f64::from(parts));
            points.push(map(Point3::from(at)));
            keys.push(key);
            keys.len() - 1
        })
    };
    for (axis, end) in (0..3).flat_map(|axis| [(axis, 0), (axis, parts)]) {
        for (i, j) in (0..parts).flat_map(|i| (0..parts).map(move |j| (i, j))) {
            let mut corner = |i: i32, j: i32| {
                let mut key = [0; 3];
                (key[axis], key[(axis + 1) % 3], key[(axis + 2) % 3]) = (end, i, j);
                vertex(key)
            };
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            let halves = if end == 0 { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] };
            triangles.extend(halves.map(|half| half.to_vec()));
        }
    }
    (points, triangles)
}

/// All corners of the highest triangles of a wall are nearer to the roof than the flatness: they are of the wall all the same.
#[test]
fn low_triangles_of_a_wall_do_not_join_the_roof() {
    let turn = Quat::from_axis_angle(Vec3::new(1.0, -2.0, 0.5).unit().unwrap(), 0.8);
    for turned in [false, true] {
        let map = |p: Point3| if turned { Point3::ORIGIN + turn.rotate(p.to_vec()) } else { p };
        let (points, triangles) = cut_box([100.0, 60.0, 3.0], 4, map);
        assert_eq!((points.len(), triangles.len()), (98, 192));
        let polyhedron = ConvexPolyhedron::with_flatness(&points, &triangles, 0.76).unwrap();
        assert_eq!((polyhedron.faces().len(), polyhedron.edges().count(), polyhedron.corner_count()), (6, 12, 8));
        assert!((polyhedron.volume() / 18000.0 - 1.0).abs() < 1e-12 && polyhedron.deviation() < 1e-12);
        check(&polyhedron, 2.0);
    }
    // With noise, by which small triangles turn by ten degrees.
    let mut random = Random(99);
    let (mut points, triangles) = cut_box([20.0, 10.0, 6.0], 16, |p| p);
    points.iter_mut().for_each(|p| *p += random.in_cube().to_vec() * 0.02);
    let polyhedron = ConvexPolyhedron::with_flatness(&points, &triangles, 0.24).unwrap();
    assert_eq!((polyhedron.faces().len(), polyhedron.corner_count()), (6, 8));
    // Every point within the noise of a plane, and so of the surface but for the corners.
    assert!(polyhedron.deviation() > 0.01 && polyhedron.deviation() < 0.04, "{}", polyhedron.deviation());
    assert!((polyhedron.volume() / 1200.0 - 1.0).abs() < 2e-3);
}

/// The hull of the points of a box that are rounded to some digits: of any number of them there is one, and what is said of it is true.
#[test]
fn rounded_points_have_a_hull() {
    let turn = Quat::from_axis_angle(Vec3::new(0.3, 0.5, -1.0).unit().unwrap(), 1.1);
    let grid =
        (0..216).map(|k| Vec3::new(f64::from(k % 6) * 20.0, f64::from(k / 6 % 6) * 15.0, f64::from(k / 36) * 9.0));
    let exact: Vec<Point3> = grid.map(|v| Point3::ORIGIN + turn.rotate(v)).collect();
    for digits in 2..=10 {
        let unit = 10.0_f64.powi(digits);
        let round = |x: f64| (x * unit).round() / unit;
        let points: Vec<Point3> = exact.iter().map(|p| Point3::new(round(p.x), round(p.y), round(p.z))).collect();
        let polyhedron = ConvexPolyhedron::hull(&points).unwrap();
        let said: Vec<&str> = polyhedron.warnings().iter().map(cyclide::Warning::reason).collect();
        let box_faces = polyhedron.faces().len() == 6;
        assert!(box_faces || said.contains(&"shallow-edges"), "{digits}: {said:?}");
        assert!(polyhedron.deviation() <= polyhedron.flatness(), "{digits}");
        for (p, q) in polyhedron.vertices().iter().zip(&points) {
            let height = |k: usize| (*q - polyhedron.vertices()[polyhedron.faces()[k][0]]).dot(polyhedron.normals()[k]);
            let out = (0..polyhedron.faces().len()).map(height).fold(f64::NEG_INFINITY, f64::max);
            assert!(out <= polyhedron.deviation() + 1e-13, "{digits}: {p:?} {q:?} {out:e}");
        }
        // With the digits given it is the box, to them.
        let known = ConvexPolyhedron::hull_with_flatness(&points, 2.0 / unit).unwrap();
        assert_eq!((known.faces().len(), known.corner_count()), (6, 8), "{digits}");
        assert!((known.volume() / 337_500.0 - 1.0).abs() < 0.2 / unit);
        assert!(known.warnings().is_empty() && known.deviation() <= 2.0 / unit);
    }
}
