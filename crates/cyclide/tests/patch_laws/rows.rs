//! Rows agree with the scalar path within the bound that they state.

use cyclide::surface::ParamSurface;
use cyclide_testkit::patches::patch;
use proptest::prelude::*;

proptest! {
    #[test]
    fn rows_are_the_points_and_normals_of_the_patch(case in patch(), t in 0.0..=1.0, count in 0usize..600) {
        let patch = &case.patch;
        let s: Vec<f64> = (0..count).map(|i| i as f64 / (count as f64 - 1.0).max(1.0)).collect();
        let mut lanes = vec![f64::NAN; 9 * count];
        let mut lane = lanes.chunks_mut(count.max(1));
        let mut three = || -> [&mut [f64]; 3] { std::array::from_fn(|_| lane.next().unwrap_or_default()) };
        let (mut alone, mut points, mut normals) = (three(), three(), three());
        let row = patch.row(t);
        row.points(&s, alone.each_mut().map(|l| &mut **l));
        row.points_and_normals(&s, points.each_mut().map(|l| &mut **l), normals.each_mut().map(|l| &mut **l));
        let squares = |f: fn(f64, f64) -> f64, start: f64| {
            s.iter().map(|s| patch.denominator(*s, t).norm_squared()).fold(start, f)
        };
        // Half of what is promised: roundings do cancel.
        let magnified = 16.0 * f64::EPSILON * squares(f64::max, 0.0) / squares(f64::min, f64::INFINITY);
        // The denominator is wrong by a part of itself, and with it all that is added to the first corner.
        let reach = s.iter().map(|s| patch.point(*s, t).distance(patch.corners()[0])).fold(patch.size(), f64::max);
        for (i, s) in s.iter().enumerate() {
            let (p, n) = (patch.point(*s, t), patch.unit_normal(*s, t));
            let far = p.to_vec().max_abs().max(patch.corners()[0].to_vec().max_abs());
            // The scalar path is rounded in the same way.
            let bound = magnified * reach + 2.0 * f64::EPSILON * far;
            for (k, (p, n)) in p.to_array().into_iter().zip(n.to_array()).enumerate() {
                prop_assert!((points[k][i] - p).abs() <= bound, "{:e} of {bound:e}", points[k][i] - p);
                prop_assert!((normals[k][i] - n).abs() <= magnified, "{:e} of {magnified:e}", normals[k][i] - n);
                prop_assert_eq!(points[k][i].to_bits(), alone[k][i].to_bits());
            }
        }
    }
}
