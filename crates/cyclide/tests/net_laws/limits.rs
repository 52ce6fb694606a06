//! Objects below the rounding of their place, and surfaces of too many pieces.

use super::data::cyclide_grid;
use cyclide::{
    Error, Frame, Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    curve::Circle,
    error::{NumberError, PointError},
    mesh::{MOST_PIECES, flatten_within, tessellate, tessellate_within},
    model::SurfaceObject,
    surface::{CyclidePatch, CyclidicNet, DupinCyclide, NetFrame, QuadGrid},
    topology::Shell,
};

fn at(distance: f64) -> Point3 {
    Point3::ORIGIN + Vec3::new(0.48, -0.6, 0.64) * distance
}

fn placed(size: [f64; 3], place: Point3, axis: Vec3) -> cyclide::Result<Vec<CyclidicNet>> {
    DupinCyclide::new(size[0], size[1], size[2])?.placed(Frame::from_normal(place, axis, Vec3::X)?).nets([4, 4])
}

#[test]
fn cyclides_below_the_rounding_of_their_place_have_one_error() {
    let one = Point3::new(1.0, 1.0, 1.0);
    for (size, place) in [
        ([2.0, 0.0, 1.0], Point3::new(1e17, 1e17, 1e17)),
        ([2.0, 0.0, 1.0], Point3::new(1e15, 1e15, 1e15)),
        ([1e-50, 0.0, 1e-50], one),
        ([1e-14, 0.0, 1e-15], one),
        ([2.8e-14, 0.0, 1.5e-14], Point3::new(1.0, -7e-7, -2.0)),
    ] {
        let error = placed(size, place, Vec3::new(1.0, -1.0, -1.0)).unwrap_err();
        assert_eq!(error.reason(), "below-rounding-of-place", "{error}");
        let Error::Point(PointError::BelowRoundingOfPlace { size: measured, limit, place, .. }) = error else {
            panic!("{error}")
        };
        assert!(measured <= limit && (limit - 65536.0 * f64::EPSILON * place).abs() <= 1e-15 * limit);
    }
    // However small, at the origin.
    placed([1e-140, 0.0, 3e-141], Point3::ORIGIN, Vec3::Z).unwrap();
    assert_eq!(DupinCyclide::new(1e-140, 0.0, 1e-140).unwrap().nets([4, 4]).unwrap().len(), 1);
}

/// Far away rounding closes a hole of 3.5e-10, and what was a ring falls apart: refused, but not at the origin, nor a hole of 1e-8.
#[test]
fn holes_and_lobes_narrower_than_the_rounding_of_their_place_are_refused() {
    let (a, c) = (7.360_129_934_716_213, 5.263_444_248_822_929);
    let far = Point3::new(-66_410.093_424_637_79, -29_037.556_475_635_174, 18_271.316_419_779_552);
    let axis = Vec3::new(0.368_996_471_988_903_84, -0.345_939_158_726_164_8, -0.545_503_489_584_237_4);
    for narrow in [-1.76e-10, 1.76e-10] {
        for [a, c, mu] in [[a, c, a + narrow], [a, c, c + narrow]] {
            let error = placed([a, c, mu], far, axis).unwrap_err();
            assert_eq!(error.reason(), "below-rounding-of-place", "{error}");
            assert!(error.to_string().contains("narrowest part"), "{error}");
            placed([a, c, mu], Point3::ORIGIN, axis).unwrap();
            placed([a, c, mu + 50.0 * narrow], far, axis).unwrap();
        }
    }
}

#[test]
fn millimetres_at_five_thousand_kilometres_are_right() {
    // Meters in a national grid: rounding is 1e-9, so that a ring of a millimeter is known to 1e-6 of itself.
    let place = Point3::new(4_512_345.678, 5_412_345.678, 312.5);
    for size in [1.0, 1e-2, 1e-3] {
        let here = placed([2.0 * size, 0.5 * size, size], Point3::ORIGIN, Vec3::Z).unwrap().remove(0);
        let there = placed([2.0 * size, 0.5 * size, size], place, Vec3::Z).unwrap().remove(0);
        let (here, there) = (here.to_shell().unwrap(), there.to_shell().unwrap());
        // Volumes are integrals over vertices rounded by 1e-9.
        let bound = 64.0 * 1e-9 / size;
        assert!((there.volume() / here.volume() - 1.0).abs() <= bound, "{size}");
        there.with_regular_faces().unwrap().with_positive_weights().unwrap();
    }
    let grid = |size: f64, v: Vec3| {
        let grid = cyclide_grid([2.0, 0.7, 1.1], [9, 7], [false; 2]);
        let points = grid.points().iter().map(|p| Point3::ORIGIN + p.to_vec() * size + v).collect();
        QuadGrid::new(points, grid.size(), grid.closed()).unwrap()
    };
    CyclidicNet::new(grid(1e-2, place.to_vec()), NetFrame::Auto).unwrap();
    Circle::from_radius(place, Vec3::Z, 1e-3).unwrap();
}

#[test]
fn patches_nets_circles_and_images_have_the_same_error() {
    let square = |size: f64, place: Point3| {
        [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|[x, y]| place + Vec3::new(x, y, 0.0) * size)
    };
    let reason = |size: f64, place: Point3| {
        let corners = square(size, place);
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y).map(|_| ());
        let weighted = CyclidePatch::from_weights(corners, [Quat::ONE; 4], Vec3::X, Vec3::Y).map(|_| ());
        let grid = QuadGrid::new(corners.to_vec(), [2, 2], [false; 2]).unwrap();
        let net = CyclidicNet::new(grid, NetFrame::First(Vec3::X, Vec3::Y)).map(|_| ());
        let circle = Circle::from_radius(place, Vec3::Z, 1e-5 * size).map(|_| ());
        [patch, weighted, net, circle].map(|made| made.map_or_else(|e| e.reason(), |()| "made"))
    };
    for distance in [3e11, 1e13, 1e15] {
        let surface = ["below-rounding-of-place"; 3];
        assert_eq!(reason(1.0, at(distance))[..3], surface, "{distance:e}");
    }
    // The circle is kept by its center and radius.
    assert_eq!(reason(1.0, at(1e13))[3], "below-rounding-of-place");
    assert_eq!(reason(1.0, at(1e9))[3], "made");
    // Images: moved away, and near the point to which infinity goes.
    let patch = CyclidePatch::from_corners_and_frame(square(1.0, Point3::ORIGIN), Vec3::X, Vec3::Y).unwrap();
    let shell = Shell::from_surface(patch).unwrap();
    let away = Mobius::similarity(Quat::ONE, 1.0, Vec3::new(1e13, 0.0, 0.0)).unwrap();
    let small = Mobius::inversion(Point3::new(3e6, 0.0, 0.0), 1.0).unwrap();
    for map in [away, small] {
        assert_eq!(patch.transformed(&map).unwrap_err().reason(), "below-rounding-of-place");
        assert_eq!(CyclidicNet::from(patch).transformed(&map).unwrap_err().reason(), "below-rounding-of-place");
        assert_eq!(shell.transformed(&map).unwrap_err().reason(), "below-rounding-of-place");
    }
}

#[test]
fn small_parts_of_a_large_surface_are_right_where_they_are() {
    // Quads of 1e-4 at coordinates of 1e8: below what a surface of its own would need, but the net is large.
    let grid = |n: usize, step: f64, place: Vec3| {
        let points = (0..n * n).map(|k| Point3::new((k % n) as f64 * step, (k / n) as f64 * step, 0.0) + place);
        QuadGrid::new(points.collect(), [n, n], [false; 2]).unwrap()
    };
    let frame = NetFrame::First(Vec3::X, Vec3::Y);
    let net = CyclidicNet::new(grid(40, 1.0 / 8192.0, Vec3::new(1e8, 0.0, 0.0)), frame).unwrap();
    let shell = net.to_shell().unwrap();
    let moved = Mobius::similarity(Quat::ONE, 1.0, Vec3::new(0.0, 1.0, 0.0)).unwrap();
    assert_eq!(shell.transformed(&moved).unwrap().faces().len(), 39 * 39);
    net.transformed(&moved).unwrap();
}

/// Steps of the coordinates' last digit: a quad may be that narrow in one direction, or in both where its diagonal is more than the rounding of its
/// place, but not less.
#[test]
fn parts_of_a_surface_are_more_than_a_point_of_their_place() {
    let shell = |place: f64, [first, second]: [f64; 2]| {
        let (x, y) = ([place, place + first, place + 2.0], [place, place + second, place + 2.0]);
        let points = (0..9).map(|k| Point3::new(x[k % 3], y[k / 3], 0.0)).collect();
        let grid = QuadGrid::new(points, [3, 3], [false; 2]).unwrap();
        CyclidicNet::new(grid, NetFrame::First(Vec3::X, Vec3::Y)).unwrap().to_shell()
    };
    // Between 2^26 and 2^27 the last digit is 2^-26, and the rounding of a place nearly as much as 2^-25.
    let (high, low, digit) = (1.9 * 2.0_f64.powi(26), 2.0_f64.powi(26), 2.0_f64.powi(-26));
    let error = shell(high, [digit; 2]).unwrap_err();
    assert_eq!((error.reason(), error.index()), ("below-rounding-of-place", Some(0)), "{error}");
    for (place, steps) in [(low, [digit; 2]), (high, [digit, 1.0]), (high, [1.0, digit])] {
        assert_eq!(shell(place, steps).unwrap().faces().len(), 4, "{place} {steps:?}");
    }
}

#[test]
fn refinements_have_a_cap_that_is_told_before_memory_is_taken() {
    let ring = DupinCyclide::new(2.0, 1.0, 1.5).unwrap();
    let error = ring.nets([4096, 4096]).unwrap_err();
    assert_eq!(error.to_string(), "the cyclide needs 1.68e7 pieces, the limit is 500000: use fewer segments");
    assert_eq!(error.reason(), "too-many-pieces");
    let body = ring.to_bodies([4, 4]).unwrap().remove(0);
    let error = tessellate(&body, 1e-9).unwrap_err();
    assert!(
        matches!(error, Error::Number(NumberError::TooManyPieces { needed, cap: MOST_PIECES, .. }) if needed > 1e9),
        "{error}"
    );
    // The cap counts all bodies, and is the caller's.
    let one = tessellate(&body, 1e-2).unwrap().faces.len();
    assert_eq!(tessellate_within([&body, &body], 1e-2, 2 * one).unwrap().faces.len(), 2 * one);
    assert_eq!(tessellate_within([&body, &body], 1e-2, 2 * one - 1).unwrap_err().reason(), "too-many-pieces");
    let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0).unwrap();
    let n = flatten_within(&circle, 1e-3, 1000).unwrap().len();
    assert!(flatten_within(&circle, 1e-3, n).is_ok());
    assert_eq!(flatten_within(&circle, 1e-3, n - 2).unwrap_err().reason(), "too-many-pieces");
    assert_eq!(flatten_within(&circle, 1e-16, n).unwrap_err().reason(), "too-many-pieces");
}

#[test]
fn nearly_degenerate_rings_are_meshed_or_refused_by_the_cap() {
    // The tube is 4e-12 thin where it is thinnest.
    let ring = DupinCyclide::new(2.0, 1.999_999_999_996_280_5, 2.0).unwrap();
    for net in ring.nets([4, 4]).unwrap() {
        for body in SurfaceObject::Net(net).to_bodies().unwrap() {
            match tessellate_within([&body], 1e-3, 100_000) {
                Ok(mesh) => assert!(mesh.bound <= 1e-3),
                Err(error) => assert_eq!(error.reason(), "too-many-pieces", "{error}"),
            }
        }
    }
}
