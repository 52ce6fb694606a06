//! The list of every implementor of `ParamCurve`, in easy and hard shapes.

use cyclide::{
    Frame, Point2, Point3, Vec2, Vec3,
    construct::{
        FairEnd, FairSplineOptions, MoebiusSplineOptions, NodeParameters, QbInterpolation, TorusSplineOptions,
        TorusTangent,
    },
    curve::{
        Arc, ArcPath, BlendVariant, Circle, CircleSpline, CircleSplineOptions, DEFAULT_PIECE_ANGLE, ParamCurve,
        QbSpline, SplineEnds,
    },
    model::{ChainPiece, CurveChain},
    rational::NurbsCurve,
    surface::{Torus, TorusSpline},
};

/// One curve of the list.
pub struct Case {
    /// Name for messages.
    pub name: String,
    /// The curve.
    pub curve: Box<dyn ParamCurve>,
    /// Its size: about the diagonal of its box.
    pub size: f64,
    /// Its largest absolute coordinate.
    pub reach: f64,
    /// Rounding of one evaluated point: of the coordinates, and of the parameter times the largest speed of a piece
    /// (a nearly full arc runs through its middle 400 times as fast as its size).
    pub rounding: f64,
}

fn case(name: &str, curve: impl ParamCurve + 'static) -> Case {
    let b = cyclide::curve::bounds(&curve);
    let pieces = curve.piece_count();
    let speed = |i: usize| curve.jet(i as f64 / (256 * pieces) as f64).speed() / pieces as f64;
    let fastest = (0..=256 * pieces).map(speed).fold(0.0, f64::max);
    let rounding = 4.0 * f64::EPSILON * (b.max_abs() + fastest);
    Case { name: name.to_owned(), size: b.diagonal(), reach: b.max_abs(), rounding, curve: Box::new(curve) }
}

pub fn point(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

/// Arcs that meet with a tangent: a chain from one start tangent by reflection.
pub fn arc_chain(points: &[Point3], mut tangent: Vec3, closed: bool) -> ArcPath {
    let mut arcs = Vec::new();
    for w in points.windows(2) {
        arcs.push(Arc::from_start_tangent(w[0], w[1], tangent).unwrap());
        tangent = tangent.reflect((w[1] - w[0]).unit().unwrap());
    }
    ArcPath::new(arcs, closed).unwrap()
}

/// A rational cubic with weights and a double knot, scaled.
pub fn rational_cubic(scale: f64) -> NurbsCurve {
    let rows: [[f64; 3]; 7] = [
        [0.0, 0.0, 0.0],
        [1.0, 2.0, 0.5],
        [3.0, 1.5, -0.5],
        [4.0, -1.0, 0.0],
        [6.0, 0.0, 1.0],
        [6.5, 2.0, 1.0],
        [5.0, 3.0, 0.0],
    ];
    let points = rows.iter().map(|r| point(r[0] * scale, r[1] * scale, r[2] * scale)).collect();
    let weights = vec![1.0, 0.7, 1.6, 1.0, 0.9, 1.3, 1.0];
    NurbsCurve::new(3, vec![0.0, 0.0, 0.0, 0.0, 0.3, 0.3, 0.7, 1.0, 1.0, 1.0, 1.0], points, weights).unwrap()
}

/// A track of two straights and two half circles, closed, tilted out of the plane.
pub fn stadium(scale: f64) -> ArcPath {
    let p = |x: f64, y: f64| point(x * scale, y * scale, -0.5 * y * scale);
    let (a, b, c, d) = (p(0.0, 0.0), p(4.0, 0.0), p(4.0, 2.0), p(0.0, 2.0));
    let out = b - a;
    let arcs = vec![
        Arc::segment(a, b).unwrap(),
        Arc::from_start_tangent(b, c, out).unwrap(),
        Arc::segment(c, d).unwrap(),
        Arc::from_start_tangent(d, a, -out).unwrap(),
    ];
    ArcPath::new(arcs, true).unwrap()
}

/// A circle spline in space through unevenly spaced points, two of them on a straight run, one a corner.
pub fn kinked_spline(scale: f64, closed: bool, order: u32, variant: BlendVariant) -> CircleSpline {
    let points =
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.1], [4.0, 0.0, 0.2], [5.0, 3.0, 1.0], [2.5, 4.0, -1.0], [-0.5, 2.0, 0.0]]
            .map(|[x, y, z]| point(x * scale, y * scale, z * scale));
    let ends = SplineEnds::Clamped { start: Some(Vec3::new(1.0, -2.0, 0.5)), end: None };
    let options = CircleSplineOptions { closed, order, variant, ends, corners: vec![4] };
    CircleSpline::from_points(&points, &options).unwrap()
}

/// Eight points of space.
fn eight_points(scale: f64) -> [Point3; 8] {
    let rows: [[f64; 3]; 8] = [
        [0.0, 0.0, 0.0],
        [2.0, -0.5, 0.3],
        [4.0, 0.5, 0.0],
        [4.5, 2.5, -0.4],
        [3.0, 4.0, 0.0],
        [1.8, 3.2, 0.5],
        [0.5, 3.9, 0.2],
        [-1.0, 2.0, 0.0],
    ];
    rows.map(|r| point(r[0] * scale, r[1] * scale, r[2] * scale))
}

/// A circle spline through eight points of space; closed ones join the last to the first.
pub fn circle_spline(scale: f64, options: &CircleSplineOptions) -> CircleSpline {
    CircleSpline::from_points(&eight_points(scale), options).unwrap()
}

/// Every implementor at one scale.
fn cases_at(s: f64) -> Vec<Case> {
    let p = |x: f64, y: f64, z: f64| point(x * s, y * s, z * s);
    let circle = Circle::from_center(p(1.0, -2.0, 0.5), Vec3::new(0.3, -0.5, 0.8), p(3.0, 0.0, 0.0)).unwrap();
    let chain_points = [p(0.0, 0.0, 0.0), p(1.0, 0.5, 0.2), p(2.0, 0.0, 0.0), p(3.5, 1.0, -0.5), p(3.0, 2.0, 0.0)];
    let arc = Arc::from_three_points(p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.5), p(2.5, 0.0, 1.0)).unwrap();
    let nurbs = rational_cubic(s);
    let mixed = CurveChain::new(
        vec![
            ChainPiece::Arc(Arc::from_bulge(p(-2.0, 1.0, 0.0), p(0.0, 0.0, 0.0), Vec3::Z, 0.7).unwrap()),
            ChainPiece::Spline(nurbs.clone()),
            ChainPiece::Arc(Arc::segment(p(5.0, 3.0, 0.0), p(5.0, 7.0, 2.0)).unwrap()),
        ],
        false,
        0.0,
    )
    .unwrap();
    let mut cases = vec![
        case("arc", arc),
        case("line", Arc::segment(p(1.0, 2.0, 3.0), p(-2.0, 1.0, 0.0)).unwrap()),
        case("half circle", Arc::from_bulge(p(0.0, 0.0, 0.0), p(2.0, 0.0, 1.0), Vec3::Y, 1.0).unwrap()),
        case(
            "nearly full arc",
            Arc::from_center(p(1.0, 1.0, 0.0), Vec3::new(0.2, 0.1, 1.0), p(3.0, 1.0, 0.0), 6.2).unwrap(),
        ),
        case("nearly straight arc", Arc::from_bulge(p(0.0, 0.0, 0.0), p(3.0, 1.0, 0.0), Vec3::Z, 1e-9).unwrap()),
        case(
            "uneven weights",
            Arc::from_start_tangent(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), Vec3::new(2.0, 3.0, 1.0) * s).unwrap(),
        ),
        case("circle", circle),
        case("open arc path", arc_chain(&chain_points, Vec3::new(1.0, 1.0, 0.3), false)),
        case("closed arc path", stadium(s)),
        case("rational cubic", nurbs),
        case("circle as spline", circle.to_nurbs().unwrap()),
        case("arc as spline", arc.to_nurbs(DEFAULT_PIECE_ANGLE).unwrap()),
        case("smooth circle spline", circle.to_nurbs().unwrap().with_c1_knots().unwrap()),
        case("mixed chain", mixed),
    ];
    for order in 1..=4 {
        for variant in [BlendVariant::Rational, BlendVariant::Trigonometric] {
            for closed in [false, true] {
                let options = CircleSplineOptions { order, variant, closed, ..Default::default() };
                let name = format!("circle spline, order {order}, {variant:?}, closed {closed}");
                cases.push(case(&name, circle_spline(s, &options)));
            }
        }
    }
    for closed in [false, true] {
        for tension in [0.0, 0.4] {
            let options = FairSplineOptions { closed, tension, corners: vec![5], ..Default::default() };
            let name = format!("fair spline, tension {tension}, closed {closed}");
            cases.push(case(&name, CircleSpline::fair(&eight_points(s), &options).unwrap()));
        }
    }
    // Segments of different blends: straight legs beside a corner, in a plane.
    let legs = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0], [1.5, 3.0], [0.5, 3.2]];
    let legs = legs.map(|[x, y]| point(x * s, y * s, 0.2 * y * s));
    let options = FairSplineOptions { tight: Some(0.3), ends: [FairEnd::Free, FairEnd::Arc], ..Default::default() };
    cases.push(case("fair spline with straight legs", CircleSpline::fair(&legs, &options).unwrap()));
    let clamped = SplineEnds::Clamped { start: Some(Vec3::Y), end: None };
    let options = CircleSplineOptions { ends: clamped, corners: vec![3], ..Default::default() };
    let spline = circle_spline(s, &options);
    cases.push(case("blend segment", spline.segments()[1]));
    cases.push(case("circle spline with a corner", spline));
    cases.push(case("kinked circle spline", kinked_spline(s, true, 2, BlendVariant::Rational)));
    cases.extend(torus_splines(s));
    cases.extend(qb_curves(s));
    let part = kinked_spline(s, true, 4, BlendVariant::Rational).restricted(0.1, 0.7).unwrap();
    cases.push(case("part of a circle spline", part));
    cases
}

/// Splines on a torus: a knot, and a seam with turned back tangents through points, open and closed.
fn torus_splines(s: f64) -> Vec<Case> {
    let frame = Frame::from_normal(point(s, -0.5 * s, 0.2 * s), Vec3::new(0.2, 0.4, 1.0), Vec3::X).unwrap();
    let torus = Torus::new(frame, 2.0 * s, 0.7 * s).unwrap();
    let places = [[0.0, 0.1], [0.9, 0.8], [1.6, 0.2], [2.2, -0.9]].map(Point2::from);
    let back =
        vec![TorusTangent::Free, TorusTangent::Rate(Vec2::new(-0.5, 0.2)), TorusTangent::Free, TorusTangent::Free];
    let through = |closed: bool, tangents: Vec<TorusTangent>| {
        let options = TorusSplineOptions { closed, tangents, ..Default::default() };
        TorusSpline::through_places(&torus, &places, &options).unwrap()
    };
    vec![
        case("torus knot", TorusSpline::knot(&torus, [2, 3], places[0]).unwrap()),
        case("open seam on a torus", through(false, vec![])),
        case("closed seam on a torus, one tangent turned back", through(true, back)),
    ]
}

/// A QB curve through five points, and Möbius splines of eight.
fn qb_curves(s: f64) -> Vec<Case> {
    let points = eight_points(s);
    let through = QbInterpolation::through_points(&points[..5], &NodeParameters::Chord).unwrap();
    let spline = |closed: bool| {
        let options = MoebiusSplineOptions { closed, ..Default::default() };
        QbSpline::through_points(&points, &options).unwrap()
    };
    let order1 = circle_spline(s, &CircleSplineOptions { order: 1, closed: true, ..Default::default() });
    vec![
        case("QB curve through five points", through.curve().clone()),
        case("open Möbius spline", spline(false)),
        case("closed Möbius spline", spline(true)),
        case("circle spline of order 1 as QB curves", QbSpline::from_circle_spline(&order1).unwrap()),
    ]
}

/// Every implementor at three scales.
pub fn cases() -> Vec<Case> {
    let scales = [1e-6, 1.0, 1e6];
    scales
        .into_iter()
        .flat_map(|s| {
            cases_at(s).into_iter().map(move |mut c| {
                c.name = format!("{} at scale {s:e}", c.name);
                c
            })
        })
        .collect()
}
