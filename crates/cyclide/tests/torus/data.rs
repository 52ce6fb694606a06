//! Tori and places for the tests.

use cyclide::{Frame, Point2, Point3, Vec2, Vec3, surface::Torus};
use cyclide_testkit::attack::Random;

/// Thick, thin and nearly closed tori of several sizes, some placed askew.
pub fn tori() -> Vec<Torus> {
    let askew = Frame::from_normal(Point3::new(3.0, -1.0, 2.0), Vec3::new(1.0, 2.0, -0.5), Vec3::X).unwrap();
    let new = |frame, a, b| Torus::new(frame, a, b).unwrap();
    vec![
        new(Frame::WORLD, 3.0, 1.0),
        new(askew, 3.0, 0.2),
        new(askew, 2.0, 1.9),
        new(Frame::WORLD, 1e-4, 3e-5),
        new(Frame::WORLD, 1e5, 9e4),
    ]
}

/// Outer reach of a torus from the origin: what rounding is relative to.
pub fn reach(torus: &Torus) -> f64 {
    torus.major_radius() + torus.minor_radius() + torus.frame().origin().to_vec().length()
}

/// Places all over the plane, the corners of the square of half turns among them.
pub fn places() -> Vec<Point2> {
    let mut r = Random::new(30, 1);
    let half = std::f64::consts::FRAC_PI_2;
    let mut all: Vec<Point2> =
        [[0.0, 0.0], [half, 0.0], [0.0, half], [half, half], [-half, 0.3]].map(Point2::from).to_vec();
    all.extend((0..60).map(|_| Point2::new(r.between(-7.0, 7.0), r.between(-7.0, 7.0))));
    all
}

/// Speeds of several sizes and directions.
pub fn rates() -> Vec<Vec2> {
    let mut r = Random::new(30, 2);
    (0..8).map(|_| Vec2::new(r.normal(), r.normal()) * r.decades(-1.0, 1.0)).collect()
}

/// The difference of two places modulo pi.
pub fn modulo(a: Point2, b: Point2) -> f64 {
    let pi = std::f64::consts::PI;
    let short = |x: f64| x - pi * (x / pi).round();
    let d = a - b;
    short(d.x).hypot(short(d.y))
}
