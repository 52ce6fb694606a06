//! Models that the tests write and read back.

use cyclide::{
    Point3, Vec3,
    construct::FairSplineOptions,
    curve::{Arc, ArcPath, BlendVariant, Circle, CircleSpline, CircleSplineOptions},
    model::{CurveObject, Item, Model, SurfaceObject, Units},
    surface::CyclidePatch,
};

/// A model of one object per contour list.
pub fn model(items: Vec<(&str, Vec<CurveObject>)>) -> Model {
    let items = items.into_iter().map(|(name, contours)| Item::new(name, contours));
    Model { units: Units::Millimetre, items: items.collect() }
}

/// A point in a frame: `map` moves the plane figures below into space.
pub type Map = fn(f64, f64) -> Point3;

/// The plane z = 0.
pub fn flat(x: f64, y: f64) -> Point3 {
    Point3::new(x, y, 0.0)
}

/// A tilted plane far from the origin (two orthonormal axes of rationals).
pub fn tilted(x: f64, y: f64) -> Point3 {
    let (u, v) = (Vec3::new(2.0, 3.0, 6.0) / 7.0, Vec3::new(3.0, -6.0, 2.0) / 7.0);
    Point3::new(11.0, -7.0, 30.0) + u * x + v * y
}

fn normal(map: Map) -> Vec3 {
    let o = map(0.0, 0.0);
    (map(1.0, 0.0) - o).cross(map(0.0, 1.0) - o)
}

/// Chain through plane points with one bulge per edge (the last one closes).
pub fn bulges(map: Map, points: &[(f64, f64)], bulges: &[f64]) -> ArcPath {
    let closed = bulges.len() == points.len();
    let arcs = bulges
        .iter()
        .enumerate()
        .map(|(i, &b)| {
            let (p, q) = (points[i], points[(i + 1) % points.len()]);
            Arc::from_bulge(map(p.0, p.1), map(q.0, q.1), normal(map), b).unwrap()
        })
        .collect();
    ArcPath::new(arcs, closed).unwrap()
}

/// A slot with two half circles: closed, straight and round.
pub fn slot(map: Map) -> ArcPath {
    bulges(map, &[(0.0, 0.0), (40.0, 0.0), (40.0, 12.0), (0.0, 12.0)], &[0.0, 1.0, 0.0, 1.0])
}

/// An open chain with arcs to both sides, a corner, one of more than half a turn and one of nearly a full turn.
pub fn open_chain(map: Map) -> ArcPath {
    bulges(
        map,
        &[(0.0, 0.0), (10.0, 1.0), (14.0, 9.0), (13.0, 9.5), (13.01, 9.5), (30.0, -4.0), (31.0, 20.0)],
        &[0.3, -0.7, 1.8, -40.0, 1e-5, 1e-9],
    )
}

/// A chain of arcs in space, no two in one plane, with a segment and a sharp hairpin.
pub fn space_chain() -> ArcPath {
    let points = [[0.0, 0.0, 0.0], [10.0, 0.0, 2.0], [12.0, 8.0, 5.0], [3.0, 9.0, 9.0], [11.0, 8.5, 5.5]];
    let tangents = [[1.0, 1.0, 0.0], [1.0, 0.5, 1.0], [0.0, 1.0, 1.0]];
    let p = |i: usize| Point3::from(points[i]);
    let mut arcs: Vec<Arc> =
        (0..3).map(|i| Arc::from_start_tangent(p(i), p(i + 1), tangents[i].into()).unwrap()).collect();
    arcs.push(Arc::segment(p(3), p(4)).unwrap());
    ArcPath::new(arcs, false).unwrap()
}

/// Everything at once: several objects, several contours, circles, awkward names.
pub fn mixed(map: Map) -> Model {
    let circle = |x: f64, y: f64, r: f64| Circle::from_center(map(x, y), normal(map), map(x + r, y)).unwrap();
    let arc = Arc::from_bulge(map(-5.0, -5.0), map(-9.0, -2.0), normal(map), 0.5).unwrap();
    model(vec![
        ("slot", vec![CurveObject::ArcPath(slot(map)), CurveObject::Circle(circle(5.0, 6.0, 2.0))]),
        ("it's a \"1\\2\" <&> 5° 円", vec![CurveObject::ArcPath(open_chain(map))]),
        ("arc", vec![CurveObject::Arc(arc)]),
    ])
}

/// Data points of a wavy closed curve.
pub fn wave(map: Map, n: usize) -> Vec<Point3> {
    let at = |i: usize| {
        let a = std::f64::consts::TAU * i as f64 / n as f64;
        let r = 50.0 + 9.0 * (3.0 * a).sin() + 4.0 * (7.0 * a).cos();
        map(1.6 * r * a.cos(), r * a.sin())
    };
    (0..n).map(at).collect()
}

/// Data points of a rising coil.
pub fn coil(n: usize) -> Vec<Point3> {
    let at = |i: usize| {
        let a = 4.0 * std::f64::consts::PI * i as f64 / n as f64;
        Point3::new(30.0 * a.cos(), 24.0 * a.sin(), 3.0 * a + 2.0 * (2.0 * a).sin())
    };
    (0..=n).map(at).collect()
}

/// A circle spline through points.
pub fn circle_spline(points: &[Point3], closed: bool, variant: BlendVariant, corners: Vec<usize>) -> CurveObject {
    let options = CircleSplineOptions { closed, variant, corners, ..CircleSplineOptions::default() };
    CurveObject::CircleSpline(CircleSpline::from_points(points, &options).unwrap())
}

/// A closed fair spline, of degree 4 without tension and 6 with it.
pub fn fair_spline(points: &[Point3], tension: f64, corners: Vec<usize>) -> CurveObject {
    let options = FairSplineOptions { closed: true, tension, corners, ..FairSplineOptions::default() };
    CurveObject::CircleSpline(CircleSpline::fair(points, &options).unwrap())
}

/// Models whose curves are circle splines.
pub fn splines() -> Vec<(&'static str, Model)> {
    use BlendVariant::{Rational, Trigonometric};
    let flat_points = wave(flat, 40);
    vec![
        ("rational", model(vec![("wave", vec![circle_spline(&flat_points, true, Rational, vec![])])])),
        ("tilted", model(vec![("wave", vec![circle_spline(&wave(tilted, 40), true, Rational, vec![])])])),
        ("corners", model(vec![("wave", vec![circle_spline(&flat_points, true, Rational, vec![5, 20])])])),
        ("trigonometric", model(vec![("wave", vec![circle_spline(&flat_points, true, Trigonometric, vec![])])])),
        ("coil", model(vec![("coil", vec![circle_spline(&coil(30), false, Rational, vec![])])])),
        ("fair", model(vec![("wave", vec![fair_spline(&flat_points, 0.0, vec![5, 20])])])),
        ("tense", model(vec![("coil", vec![fair_spline(&coil(30), 0.3, vec![])])])),
    ]
}

/// A model of one object per patch: s0, s1, ….
pub fn surfaces(patches: &[CyclidePatch]) -> Model {
    let items =
        patches.iter().enumerate().map(|(i, patch)| Item::new(format!("s{i}"), vec![SurfaceObject::Patch(*patch)]));
    Model { units: Units::Millimetre, items: items.collect() }
}

/// One eighth of the unit sphere, with a pole.
pub fn octant() -> CyclidePatch {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
    CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap()
}

/// The upper half of a plane ring of radii 1 and 2.
pub fn annulus() -> CyclidePatch {
    let corners = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [-2.0, 0.0, 0.0]].map(Point3::from);
    CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::X).unwrap()
}

/// A part of a torus of radii 2 and 0.5 about a center: 100 degrees round the axis, 120 round the tube.
pub fn torus_part(center: Point3) -> CyclidePatch {
    let at = |u: f64, v: f64| {
        let r = 2.0 + 0.5 * v.cos();
        center + Vec3::new(r * u.cos(), r * u.sin(), 0.5 * v.sin())
    };
    let (u, v) = (100_f64.to_radians(), 120_f64.to_radians());
    let corners = [at(0.0, 0.0), at(u, 0.0), at(0.0, v), at(u, v)];
    CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap()
}

/// A patch of no special kind on the corners of a rectangle.
pub fn bent_quad() -> CyclidePatch {
    let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [2.0, 1.0, 0.0]].map(Point3::from);
    let (v1, v2) = (Vec3::new(2.0, 3.0, 6.0) / 7.0, Vec3::new(-6.0, -2.0, 3.0) / 7.0);
    CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap()
}

/// A closed curve and two surfaces.
pub fn curve_and_surfaces() -> Model {
    let mut m = model(vec![("slot", vec![CurveObject::ArcPath(slot(flat))])]);
    m.items.extend(surfaces(&[torus_part(Point3::new(10.0, 5.0, 4.0)), octant()]).items);
    m
}
