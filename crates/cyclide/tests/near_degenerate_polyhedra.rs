//! Polyhedra next to degenerate ones: what is flat, how far; edges that are one point; planes that are nearly one.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Error, Point3, Vec3, Warning, construct::ConvexPolyhedron, error::PolyhedronError, warning::PolyhedronWarning,
};

/// A box, and its sides counter-clockwise from outside.
fn boxed(sizes: [f64; 3]) -> (Vec<Point3>, Vec<Vec<usize>>) {
    let corner = |k: usize| Point3::from([0, 1, 2].map(|c| if k >> c & 1 == 1 { sizes[c] } else { 0.0 }));
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    ((0..8).map(corner).collect(), faces.map(Vec::from).to_vec())
}

/// A prism 1e-8 high, its corners to eight digits: thin quads, whose normals need all digits of the cross products of long sides.
#[test]
fn thin_prisms_have_the_planes_of_their_sides() {
    let top = [
        [-0.12580247, -0.71126215, -0.69157783],
        [0.35082692, 0.89826185, -0.26466226],
        [-0.22502445, -0.18699971, 0.95624009],
    ];
    let ups = [[1e-8, 0.0, 0.0], [1e-8, 0.0, 1e-8], [1e-8, 0.0, 0.0]].map(Vec3::from);
    let corners = |scale: f64| {
        let pairs =
            top.into_iter().zip(ups).flat_map(move |(p, up)| [Vec3::from(p) * scale, (Vec3::from(p) + up) * scale]);
        pairs.map(|p| Point3::ORIGIN + p).collect::<Vec<_>>()
    };
    for scale in [1.0, 6.384_316e-5, 7e4] {
        let made = ConvexPolyhedron::hull(&corners(scale)).unwrap();
        assert!(made.flatness() < 4e-9 * scale && made.corner_count() == 6, "{scale}: {:?}", made.warnings());
        // Thickness times the area of the triangle, to the rounding of one of nine digits.
        let height = top.map(Vec3::from);
        let volume =
            0.5 * (height[1] - height[0]).cross(height[2] - height[0]).dot(ups[0] + ups[1] + ups[2]).abs() / 3.0;
        assert!((made.volume() / (volume * scale.powi(3)) - 1.0).abs() < 0.2, "{scale}: {} {volume}", made.volume());
    }
}

/// The thickness is that of the points, the limit that which was asked for, half of it where points are one.
#[test]
fn flat_is_said_with_what_was_measured() {
    let flat = |made: cyclide::Result<ConvexPolyhedron>| match made.unwrap_err() {
        Error::Polyhedron(PolyhedronError::Flat { thickness, limit }) => [thickness, limit],
        other => panic!("{other}"),
    };
    let (points, faces) = boxed([1.0, 2.0, 0.01]);
    let mesh = flat(ConvexPolyhedron::with_flatness(&points, &faces, 0.02));
    let hull = flat(ConvexPolyhedron::hull_with_flatness(&points, 0.015));
    for ([thickness, limit], asked) in [(mesh, 0.02), (hull, 0.015)] {
        // Half the height is the distance from the plane in the middle, but for rounding.
        assert!((thickness - 0.005).abs() < 1e-15 && (limit - asked).abs() < 1e-15, "{thickness} {limit}");
    }
    // In one plane but for rounding, of any size.
    for scale in [1e-3, 1.0, 1e5] {
        let tilted: Vec<Point3> = points.iter().map(|p| Point3::new(p.x, p.y, 0.3 * p.x + 0.7 * p.y)).collect();
        let tilted: Vec<Point3> = tilted.iter().map(|p| Point3::ORIGIN + p.to_vec() * scale).collect();
        let [thickness, limit] = flat(ConvexPolyhedron::hull_with_flatness(&tilted, 0.0));
        assert!(thickness <= limit && limit > 0.0 && limit < 1e-13 * scale, "{thickness} {limit}");
    }
    // Three places, each twice.
    let near = Vec3::new(0.0, 0.0, 3e-4);
    let twice: Vec<Point3> = points[..3].iter().flat_map(|p| [*p, *p + near]).collect();
    let [thickness, limit] = flat(ConvexPolyhedron::hull_with_flatness(&twice, 1e-3));
    assert!((thickness - 3e-4).abs() < 1e-15 && (limit - 5e-4).abs() < 1e-15, "{thickness} {limit}");
}

/// A roof whose ridge is rounding: a mesh keeps it and says so, a hull has one tip.
#[test]
fn short_edges_of_meshes_are_named() {
    let base = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
    let roof = |ridge: f64| -> Vec<Point3> {
        base.into_iter()
            .chain([[1.0 - 0.5 * ridge, 1.0, 1.0], [1.0 + 0.5 * ridge, 1.0, 1.0]])
            .map(Point3::from)
            .collect()
    };
    let faces = [vec![0, 3, 2, 1], vec![0, 1, 5, 4], vec![1, 2, 5], vec![2, 3, 4, 5], vec![3, 0, 4]];
    let made = ConvexPolyhedron::new(&roof(1e-13), &faces).unwrap();
    let warnings = made.warnings();
    let [Warning::Polyhedron(PolyhedronWarning::ShortEdges { ends, count: 1, length, limit })] = &warnings[..] else {
        panic!("{warnings:?}")
    };
    assert!([[4, 5], [5, 4]].contains(ends) && (length / 1e-13 - 1.0).abs() < 0.01 && *limit > 1e-9, "{length}");
    assert_eq!(warnings[0].reason(), "short-edges");
    // Longer than half of what counts as flat: an edge.
    assert!(ConvexPolyhedron::new(&roof(1e-8), &faces).unwrap().warnings().is_empty());
    let hull = ConvexPolyhedron::hull(&roof(1e-13)).unwrap();
    assert!(hull.warnings().is_empty() && hull.corner_count() == 5);
}

/// The first smaller flatness that gives a convex body is taken, and said.
#[test]
fn the_flatness_of_hulls_is_lowered_where_planes_are_nearly_one() {
    let mut generator = 1_u64;
    let mut number = || {
        generator = generator.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (generator >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut lowered = 0;
    for case in 0..200 {
        // Three times as thick as the distance from a plane that counts.
        let flatness = 1e-3 * 4.0_f64.powi(-(case % 4));
        let points: Vec<Point3> = (0..12).map(|_| Point3::new(number(), number(), 3.0 * flatness * number())).collect();
        let made = match ConvexPolyhedron::hull_with_flatness(&points, flatness) {
            Ok(made) => made,
            // What is refused says how far points would be off: a larger flatness takes them.
            Err(Error::Polyhedron(PolyhedronError::PlanesMissPoint { distance, limit, .. })) => {
                assert!(distance > limit && (limit - flatness).abs() < 1e-15);
                continue;
            }
            Err(Error::Polyhedron(PolyhedronError::Flat { thickness, limit })) => {
                assert!(thickness <= limit);
                continue;
            }
            Err(error) => panic!("{error}"),
        };
        assert!(made.deviation() <= flatness && made.edges().all(|edge| edge.angle > 0.0));
        if let Some(Warning::Polyhedron(PolyhedronWarning::FlatnessLowered { asked, used })) =
            made.warnings().iter().find(|warning| warning.reason() == "flatness-lowered")
        {
            assert!(
                (asked - flatness).abs() < 1e-15 && *used < 0.26 * flatness && (used - made.flatness()).abs() < 1e-15
            );
            lowered += 1;
        }
    }
    assert!(lowered > 0, "{lowered}");
}
