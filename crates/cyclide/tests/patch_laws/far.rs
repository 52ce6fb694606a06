//! Far from the origin: the map of the translated is the translated map, to the rounding of coordinates.

use super::PLACES;
use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    curve::{Arc, ParamCurve},
    surface::{CyclidePatch, ParamSurface},
};

/// Translations, in sizes of the objects; on whole numbers, so that the objects translate without rounding.
const DISTANCES: [f64; 3] = [1.0, 1e3, 1e6];

/// Corners on whole 2^-20: translated by whole numbers up to 2^30 they stay exact. A rectangle is concircular.
fn rectangle(shift: Vec3) -> [Point3; 4] {
    [[0.25, 0.5, 0.0], [1.75, 0.5, 0.0], [0.25, 1.5, 0.0], [1.75, 1.5, 0.0]].map(|p| Point3::from(p) + shift)
}

fn patch(shift: Vec3) -> CyclidePatch {
    let v1 = Vec3::new(0.8, 0.0, 0.6);
    CyclidePatch::from_corners_and_frame(rectangle(shift), v1, Vec3::Y).unwrap()
}

/// A map that inverts at a given center, and the same between translated spaces.
fn inversions(center: Vec3, shift: Vec3) -> Vec<(Mobius, Mobius)> {
    let at = |v: Vec3| Mobius::inversion(Point3::ORIGIN + v, 2.0).unwrap();
    let mirror = |v: Vec3| Mobius::reflection(Point3::ORIGIN + v, Vec3::new(1.0, 2.0, -2.0)).unwrap();
    let (near, far) = (at(center), at(center + shift));
    let half = Vec3::new(0.5, 3.0, 1.0);
    let (turned, turned_far) = (mirror(half).after(&near), mirror(half + shift).after(&far));
    let twice = at(half * 4.0).after(&near);
    let twice_far = at(half * 4.0 + shift).after(&far);
    vec![(near, far), (turned, turned_far), (twice, twice_far)]
}

#[test]
fn patches_and_arcs_map_alike_wherever_they_are() {
    let center = Vec3::new(0.5, -1.5, 1.25);
    for distance in DISTANCES {
        let shift = Vec3::new(distance, -2.0 * distance, distance);
        // Numbers of the size of the distance, rounded some ten times; corners are divided by the size.
        let bound = 64.0 * f64::EPSILON * (distance + 4.0);
        for (near, far) in inversions(center, shift) {
            let (here, there) = (patch(Vec3::ZERO), patch(shift));
            let (image, far_image) = (here.transformed(&near).unwrap(), there.transformed(&far).unwrap());
            for (s, t) in PLACES {
                let error = far_image.point(s, t).distance(image.point(s, t) + shift);
                assert!(error <= bound, "{distance}: {error:e} > {bound:e}");
                assert!((far_image.unit_normal(s, t) - image.unit_normal(s, t)).length() <= bound);
            }
            for (q, p) in image.q1().into_iter().zip(far_image.q1()).chain(image.q2().into_iter().zip(far_image.q2())) {
                assert!((q - p).abs() <= bound);
            }
            let ratio = Quat::new(0.3, 0.0, 0.0, -0.7);
            let arc = |v: Vec3| Arc::from_weight_ratio(rectangle(v)[0], rectangle(v)[1], ratio).unwrap();
            let (image, far_image) =
                (arc(Vec3::ZERO).transformed(&near).unwrap(), arc(shift).transformed(&far).unwrap());
            for i in 0..=8 {
                let t = f64::from(i) / 8.0;
                assert!(far_image.piece_point(0, t).distance(image.piece_point(0, t) + shift) <= bound);
            }
        }
    }
}

#[test]
fn corners_rounded_far_from_the_origin_are_still_on_a_circle() {
    // A quad on a circle, with an edge of a tenth of its size; coordinates are rounded to 1e-8 of that edge at the last.
    let at = |angle: f64| Vec3::new(angle.cos(), 0.6 * angle.sin(), 0.8 * angle.sin());
    let frame = (Vec3::new(0.0, 0.6, 0.8), -Vec3::X);
    for distance in [1.0, 1e4, 1e7] {
        let shift = Point3::ORIGIN + Vec3::new(0.48, -0.6, 0.64) * distance;
        let corners = [0.1, 0.2, 4.0, 1.5].map(|angle| shift + at(angle));
        let patch = CyclidePatch::from_corners_and_frame(corners, frame.0, frame.1).unwrap();
        // The last corner is moved onto the circle of three that are rounded.
        let moved = patch.corners()[3].distance(corners[3]);
        assert!(moved <= 32.0 * f64::EPSILON * (distance + 1.0) * 10.0, "{moved:e}");
        let again = CyclidePatch::from_weights(patch.corners(), patch.weights(), frame.0, frame.1).unwrap();
        assert_eq!(again.point(0.3, 0.6), patch.point(0.3, 0.6));
        // What is no rounding is refused: 1e-5 of the size off the circle.
        let mut off = corners;
        off[3] += Vec3::new(0.0, -0.8, 0.6) * 1e-5;
        let refused = CyclidePatch::from_corners_and_frame(off, frame.0, frame.1).unwrap_err();
        assert_eq!(refused.reason(), "not-concircular");
    }
}
