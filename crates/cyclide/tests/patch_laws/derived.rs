//! Offsets, Möbius images, implicit equation and point location of random patches.

use super::PLACES;
use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    surface::{CyclidePatch, ParamSurface},
};
use cyclide_testkit::generators::direction;
use cyclide_testkit::patches::{PatchCase, patch, tame_patch};
use proptest::prelude::*;

/// Places on and beyond the patch.
const BEYOND: [(f64, f64); 8] =
    [(0.0, 0.0), (0.5, 0.5), (0.2, 0.9), (-0.5, 0.3), (1.5, 0.5), (0.7, -2.0), (2.0, 3.0), (-1.0, -1.0)];

/// Bits of the weights and of the constant frame.
fn bits(patch: &CyclidePatch) -> ([[u64; 4]; 4], [[u64; 3]; 3]) {
    let (weights, frame) = (patch.weights(), patch.frame());
    (weights.map(|w| w.to_array().map(f64::to_bits)), frame.map(|v| v.to_array().map(f64::to_bits)))
}

/// A point off the patch, and its distance from it: `far` sizes from the middle in the given direction, or as much
/// farther as it takes to be 0.15 sizes away. The foot of the perpendicular, if it is on the patch, may be nearer than
/// the places tried.
fn off_the_patch(case: &PatchCase, at: Vec3, far: f64) -> (Point3, f64) {
    let (patch, size) = (&case.patch, case.patch.size());
    let distance = |centre: Point3| {
        let places = (0..289).map(|i| patch.point(f64::from(i % 17) / 16.0, f64::from(i / 17) / 16.0).distance(centre));
        let foot = patch.locate(centre);
        let inside = [foot.s, foot.t].iter().all(|x| (0.0..=1.0).contains(x));
        places.fold(if inside { foot.distance } else { f64::INFINITY }, f64::min)
    };
    let centres = (0..1000).map(|k| patch.point(0.5, 0.5) + at * ((far + 0.1 * f64::from(k)) * size));
    centres.map(|centre| (centre, distance(centre))).find(|(_, nearest)| *nearest > 0.15 * size).unwrap()
}

proptest! {
    #[test]
    fn offsets_are_along_the_normal_and_go_back(case in patch(), part in -0.5..0.5) {
        let h = part * case.patch.size();
        let there = case.patch.offset(h).unwrap();
        let back = there.offset(-h).unwrap();
        for (s, t) in PLACES {
            let p = case.patch.point(s, t);
            let normal = case.patch.unit_normal(s, t);
            prop_assert!(there.point(s, t).distance(p + normal * h) <= case.rounding(256.0));
            prop_assert!((there.unit_normal(s, t) - normal).length() <= 1e-14);
            prop_assert!(back.point(s, t).distance(p) <= case.rounding(256.0));
        }
        for (q, p) in case.patch.q1().into_iter().zip(back.q1()).chain(case.patch.q2().into_iter().zip(back.q2())) {
            // Differences of speeds of the size of the weights.
            prop_assert!((q - p).abs() <= case.rounding(64.0) * case.aspect);
        }
    }

    #[test]
    fn offsets_have_the_same_weights_and_frame(case in patch(), parts in [-3.0..3.0, -3.0..3.0]) {
        let mut patch = case.patch;
        for part in parts {
            let h = part * patch.size();
            let offset = patch.offset(h).unwrap();
            // Bit for bit, whatever the distance, and again for the offset of an offset.
            prop_assert_eq!(bits(&offset), bits(&case.patch));
            // It is another patch: the corners moved by the distance.
            for (p, q) in patch.corners().into_iter().zip(offset.corners()) {
                // Rounding of the turned normal, of some ten operations, and of the coordinates.
                let far = p.to_vec().max_abs().max(h.abs());
                prop_assert!((p.distance(q) - h.abs()).abs() <= 16.0 * f64::EPSILON * far, "{:e} {h:e}", p.distance(q));
            }
            patch = offset;
        }
    }

    #[test]
    fn offsets_are_regular_up_to_the_first_curvature_centre(case in tame_patch(), part in -1.0..1.0) {
        let h = part * case.patch.size();
        // k1 and k2 on a fine grid; the regular range ends at the nearest 1/k on each side.
        let grid = (0..=400).map(|i| f64::from(i) / 400.0);
        let curvatures: Vec<f64> = grid.flat_map(|x| [case.patch.k1(x), case.patch.k2(x)]).collect();
        let margin = curvatures.iter().map(|k| 1.0 - h * k).fold(f64::INFINITY, f64::min);
        if case.patch.is_regular() && margin.abs() > 1e-2 {
            prop_assert_eq!(case.patch.offset_is_regular(h), margin > 0.0);
        }
        if !case.patch.is_regular() {
            prop_assert!(!case.patch.offset_is_regular(h));
        }
    }

    #[test]
    fn moebius_images_are_patches_of_the_image_data(case in tame_patch(), at in direction(), far in 0.2..3.0, mirror in any::<bool>()) {
        let size = case.patch.size();
        let (centre, nearest) = off_the_patch(&case, at, far);
        let inversion = Mobius::inversion(centre, size).unwrap();
        let turn = Mobius::similarity(Quat::new(0.8, 0.1, -0.3, 0.5), 2.0, Vec3::X * size).unwrap();
        let map = if mirror { inversion } else { turn.after(&inversion) };
        // Near the center of inversion everything is magnified by the square of the distance.
        let magnified = (size / nearest).powi(2).max(1.0);
        let image = case.patch.transformed(&map).unwrap();
        // From the data: corners and pushed forward directions.
        let corners = case.data.corners.map(|a| map.map_point(a).unwrap());
        let [v1, v2] = case.data.frame.map(|v| map.push_forward(case.data.corners[0], v).unwrap().unit().unwrap());
        let again = CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap();
        let bound = case.rounding(1e4) * magnified * magnified;
        for (s, t) in PLACES {
            let want = map.map_point(case.patch.point(s, t)).unwrap();
            prop_assert!(image.point(s, t).distance(want) <= bound);
            // The parameters of the new patch run differently, but as a Möbius function of s and of t each.
            let found = again.locate(want);
            prop_assert!(found.distance <= bound, "{} of {}", found.distance, bound);
        }
    }

    #[test]
    fn the_implicit_equation_holds_on_the_whole_surface(case in patch()) {
        let patch = &case.patch;
        let w = patch.weights().iter().map(|w| w.norm()).fold(0.0, f64::max);
        for (s, t) in BEYOND {
            let d = patch.denominator(s, t).norm();
            let p = patch.point(s, t);
            let reach = p.distance(patch.corners()[0]) / patch.size() + 1.0;
            if d < 1e-2 * w || reach > 30.0 {
                continue; // Next to infinity.
            }
            // Products of four e = (a - p) w, each with the rounding of p.
            let place = case.rounding(64.0) / patch.size() * (w / d).powi(2).max(1.0);
            let bound = place * (reach * w).powi(4);
            prop_assert!(patch.implicit_at(p).abs() <= bound, "{} at {s}, {t}", patch.implicit_at(p));
        }
    }

    #[test]
    fn points_of_the_patch_are_located(case in patch()) {
        for (s, t) in PLACES {
            let p = case.patch.point(s, t);
            let found = case.patch.locate(p);
            prop_assert!(found.distance <= case.rounding(64.0), "{found:?} for {s}, {t}");
        }
    }

    #[test]
    fn parameters_come_back(case in tame_patch()) {
        for (s, t) in PLACES {
            let jet = case.patch.jet(s, t);
            let slow = jet.ds.length().min(jet.dt.length());
            let found = case.patch.locate(jet.point);
            // Another place with the same point: the surface crosses itself there.
            let same = (found.s - s).hypot(found.t - t) <= case.rounding(1e3) / slow;
            prop_assert!(same || found.distance <= case.rounding(8.0) && !case.patch.is_regular(), "{found:?} {s} {t}");
        }
    }

    #[test]
    fn feet_of_points_near_the_patch(case in tame_patch(), part in -1e-3..1e-3_f64) {
        let h = part * case.patch.size();
        for (s, t) in PLACES {
            // Near is less than half a radius of curvature: beside a node or on a thin tube other feet are as near.
            let curvature: f64 = f64::max(case.patch.k1(t).abs(), case.patch.k2(s).abs());
            if !(curvature * h.abs() < 0.5) {
                continue;
            }
            let p = case.patch.point(s, t) + case.patch.unit_normal(s, t) * h;
            let found = case.patch.locate(p);
            // (s, t) is a foot at distance |h|; a nearer one is better.
            prop_assert!(found.distance <= h.abs() + case.rounding(1e3), "{found:?} for {s}, {t}, {h}");
        }
    }
}

#[test]
fn what_is_not_finite_has_no_place() {
    let corners = [(0.0, 0.0), (2.0, 0.0), (0.0, 1.0), (2.0, 1.0)].map(|(x, y)| Point3::new(x, y, 7.0));
    let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y).unwrap();
    for bad in [f64::NAN, f64::INFINITY] {
        let found = patch.locate(Point3::new(bad, 0.0, 0.0));
        assert!(found.s.is_nan() && found.distance.is_nan());
    }
    // On a plane the answer is the foot.
    let found = patch.locate(Point3::new(0.5, 0.25, 9.0));
    assert!((found.s - 0.25).abs() < 1e-15 && (found.t - 0.25).abs() < 1e-15 && (found.distance - 2.0).abs() < 1e-15);
}
