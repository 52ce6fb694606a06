//! What is no patch is refused by name, in a fixed order, and nothing panics.

use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    surface::{CyclidePatch, ParamSurface},
};
use cyclide_testkit::generators::{wild, wild_point, wild_vector};
use proptest::prelude::*;

const SQUARE: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];

fn reason(corners: [[f64; 3]; 4], v1: Vec3, v2: Vec3) -> &'static str {
    CyclidePatch::from_corners_and_frame(corners.map(Point3::from), v1, v2).map_or_else(|e| e.reason(), |_| "none")
}

/// The square with some corners replaced.
fn with(changes: &[(usize, [f64; 3])]) -> [[f64; 3]; 4] {
    let mut corners = SQUARE;
    for (k, p) in changes {
        corners[*k] = *p;
    }
    corners
}

#[test]
fn each_defect_has_its_name() {
    let good = |corners| reason(corners, Vec3::X, Vec3::Y);
    assert_eq!(good(SQUARE), "none");
    assert_eq!(good(with(&[(2, [f64::NAN, 0.0, 0.0])])), "not-finite");
    assert_eq!(good(with(&[(2, [0.0, 1e151, 0.0])])), "parameter-out-of-range");
    for (k, l) in [(1, 0), (2, 0), (3, 0), (2, 1)] {
        assert_eq!(good(with(&[(k, SQUARE[l])])), "coincident-points", "a{k} = a{l}");
    }
    assert_eq!(good(with(&[(3, SQUARE[1])])), "none", "a triangular patch");
    assert_eq!(good(with(&[(3, SQUARE[2])])), "none", "a triangular patch");
    assert_eq!(good(with(&[(3, [1.0, 1.0, 1e-8])])), "not-concircular");
    assert_eq!(good(with(&[(3, [1.0, 1.0, 1e-10])])), "none", "within the limit");
    // The corners in the orders a0 a1 a2 a3 and a0 a2 a3 a1 round the circle.
    assert_eq!(good([SQUARE[0], SQUARE[1], SQUARE[3], SQUARE[2]]), "crossing-quad");
    assert_eq!(good([SQUARE[0], SQUARE[3], SQUARE[2], SQUARE[1]]), "crossing-quad");
    for (v1, v2) in [(Vec3::X, Vec3::X), (Vec3::ZERO, Vec3::Y), (Vec3::X, Vec3::new(1e-8, 1.0, 0.0))] {
        assert_eq!(reason(SQUARE, v1, v2), "frame-not-orthonormal");
    }
    assert_eq!(reason(SQUARE, Vec3::new(f64::INFINITY, 0.0, 0.0), Vec3::Y), "not-finite");
    // A cylinder's ruling through infinity: the frame turned by half a turn sends the sides outwards.
    assert_eq!(reason(SQUARE, -Vec3::X, -Vec3::Y), "patch-through-infinity");
}

#[test]
fn the_lengths_of_a_frame_change_nothing() {
    let patch = |l: f64, m: f64| {
        CyclidePatch::from_corners_and_frame(SQUARE.map(Point3::from), Vec3::X * l, Vec3::new(0.0, m, m)).unwrap()
    };
    for (l, m) in [(2.0, 0.5), (1e-100, 1e100), (3e150, 7e-150)] {
        // A unit vector is rounded in its last place.
        assert!(patch(l, m).point(0.3, 0.6).distance(patch(1.0, 1.0).point(0.3, 0.6)) < 1e-15, "{l} {m}");
    }
}

#[test]
fn the_first_defect_in_the_documented_order_is_named() {
    // Each input has its own defect and all those after it.
    let crossing = [SQUARE[0], SQUARE[1], SQUARE[3], SQUARE[2]];
    let off = |mut corners: [[f64; 3]; 4]| {
        corners[3][2] += 0.1;
        corners
    };
    let bad_frame = (Vec3::X * 2.0, Vec3::X);
    assert_eq!(reason(off(crossing), Vec3::X, Vec3::Y), "not-concircular");
    assert_eq!(reason(off(crossing), bad_frame.0, bad_frame.1), "frame-not-orthonormal");
    let mut coincident = off(crossing);
    coincident[1] = coincident[0];
    assert_eq!(reason(coincident, bad_frame.0, bad_frame.1), "coincident-points");
    coincident[0][0] = f64::NAN;
    assert_eq!(reason(coincident, bad_frame.0, bad_frame.1), "not-finite");
}

#[test]
fn weights_that_leave_space_are_refused() {
    let corners = SQUARE.map(Point3::from);
    let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y).unwrap();
    let mut weights = patch.weights();
    weights[3] *= Quat::from_axis_angle(Vec3::X, 1e-3);
    let refused = |w| CyclidePatch::from_weights(corners, w, Vec3::X, Vec3::Y).unwrap_err().reason();
    assert_eq!(refused(weights), "not-in-space");
    weights[3] = Quat::ZERO;
    assert_eq!(refused(weights), "zero-weight");
    weights[3] = Quat::new(f64::NAN, 0.0, 0.0, 0.0);
    assert_eq!(refused(weights), "not-finite");
}

#[test]
fn the_order_round_the_circle_is_judged_in_space() {
    let at = |angle: f64| [angle.cos(), angle.sin(), 0.0];
    let quad = |angles: [f64; 4]| reason(angles.map(at), Vec3::X, Vec3::Z);
    // The side from a0 to a2 is short: seen by the inversion at a0, a3 and a1 nearly coincide beside it.
    assert_eq!(quad([0.0, 1.5, -1e-6, 1.4995]), "crossing-quad", "a3 comes before a1, by 5e-4");
    assert_eq!(quad([0.0, -1e-6, 1.5, 1.4995]), "crossing-quad", "the same with the directions exchanged");
    assert_eq!(quad([0.0, 1.5, -1e-6, 1.5005]), "none");
    assert_eq!(quad([0.0, -1e-6, 1.5, 1.5005]), "none");
    // An overrun by rounding is none: the corner stands on its neighbor.
    let corners = [0.0, 1.5, -0.7, 1.5 - 1e-10].map(|angle| Point3::from(at(angle)));
    let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
    assert_eq!(patch.corners()[3], corners[1]);
    assert_eq!(quad([0.0, 1.5, -0.7, 1.5 - 1e-8]), "crossing-quad");
    let corners = [0.0, 1.5, -0.7, -0.7 + 1e-10].map(|angle| Point3::from(at(angle)));
    let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
    assert_eq!(patch.corners()[3], corners[2]);
}

proptest! {
    #[test]
    fn any_numbers_give_an_error_or_finite_points(
        corners in [wild_point(), wild_point(), wild_point(), wild_point()], v1 in wild_vector(), v2 in wild_vector(), h in wild(),
    ) {
        for frame in [(v1, v2), (Vec3::X, Vec3::Y)] {
            // As they are, and flattened to a rectangle, which is concircular whatever the numbers.
            let [a, b, ..] = corners;
            let box_of = [a, Point3::new(b.x, a.y, a.z), Point3::new(a.x, b.y, a.z), Point3::new(b.x, b.y, a.z)];
            for corners in [corners, box_of] {
                let Ok(patch) = CyclidePatch::from_corners_and_frame(corners, frame.0, frame.1) else { continue };
                prop_assert!(patch.point(0.3, 0.6).is_finite() && patch.unit_normal(0.3, 0.6).is_finite());
                let _ = (patch.recognize(), patch.implicit_form(), patch.s_circle(h), patch.curvature_circles(h, 0.5));
                let _ = (patch.locate(a), patch.offset_is_regular(h), patch.singular_s());
                if let Ok(offset) = patch.offset(h) {
                    prop_assert!(offset.point(0.3, 0.6).is_finite());
                }
                if let Ok(map) = Mobius::inversion(b, 1.0) {
                    let _ = patch.transformed(&map);
                }
            }
        }
    }
}
