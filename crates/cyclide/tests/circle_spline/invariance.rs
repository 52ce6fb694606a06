//! What the curve does not depend on: direction, place, size, rotation, and where it is cut.

use crate::data::{self, p, reach, rounding_of, sharpest_turn, spline};
use cyclide::{
    Point3, Quat, Vec3,
    conformal::Mobius,
    curve::{CircleSpline, ParamCurve},
};
use proptest::prelude::*;

/// The two curves agree at equal parameters within 64 roundings of each segment.
fn agree(points: &[Point3], a: &CircleSpline, b: &CircleSpline) -> Result<(), TestCaseError> {
    for ((i, s), rounding) in a.segments().iter().enumerate().zip(rounding_of(points, a)) {
        // Where rounding decides between the two ways the curve is not determined by the data.
        if s.opposite_circles() || b.segments()[i].opposite_circles() || s.long_way() != b.segments()[i].long_way() {
            continue;
        }
        for j in 0..=8 {
            let l = f64::from(j) / 8.0;
            let distance = s.point(l).distance(b.segments()[i].point(l));
            prop_assert!(distance <= 64.0 * rounding, "segment {i} at {l}: {distance:e} {rounding:e}");
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn reversed_data_give_the_reversed_curve(points in data::points(), options in data::options()) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        prop_assume!(sharpest_turn(&points, options.closed) > 1e-6);
        let mut back: Vec<Point3> = points.iter().rev().copied().collect();
        if options.closed {
            // Start at the same node.
            back.rotate_right(1);
        }
        let Some(from_data) = spline(&back, &options) else { return Ok(()) };
        let reversed = s.reversed();
        agree(&back, &from_data, &reversed)?;
        prop_assert_eq!(reversed.kinks(), from_data.kinks());
    }

    #[test]
    fn reversing_keeps_the_points(points in data::points(), options in data::options()) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        let r = s.reversed();
        let n = s.piece_count();
        for (piece, rounding) in rounding_of(&points, &s).into_iter().enumerate() {
            prop_assert_eq!(r.piece_point(n - 1 - piece, 1.0), s.piece_point(piece, 0.0));
            for j in 0..=8 {
                let l = f64::from(j) / 8.0;
                let distance = r.piece_point(n - 1 - piece, 1.0 - l).distance(s.piece_point(piece, l));
                prop_assert!(distance <= 16.0 * rounding, "{distance:e} {rounding:e}");
            }
        }
        let twice = r.reversed();
        prop_assert_eq!(twice.warnings().len(), s.warnings().len());
        for (a, b) in twice.warnings().iter().zip(s.warnings()) {
            prop_assert_eq!(a.index(), b.index());
        }
    }

    #[test]
    fn commutes_with_similarities(
        points in data::points(), options in data::options(),
        q in (-1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0), shift in (-2.0..2.0, -2.0..2.0, -2.0..2.0),
        factor in data::scale(), mirrored in any::<bool>()
    ) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        prop_assume!(sharpest_turn(&points, options.closed) > 1e-6);
        let rotation = Quat::new(q.0, q.1, q.2, q.3);
        prop_assume!(rotation.norm() > 1e-3);
        let size = reach(&points) * factor;
        let map = Mobius::similarity(rotation, factor, Vec3::new(shift.0, shift.1, shift.2) * size).unwrap();
        let map = if mirrored {
            map.after(&Mobius::reflection(points[0], Vec3::new(1.0, 2.0, -0.5)).unwrap())
        } else {
            map
        };
        let moved: Vec<Point3> = points.iter().map(|p| map.map_point(*p).unwrap()).collect();
        // Tiny steps may fall below the rounding of the moved coordinates.
        let (Some(from_data), Ok(image)) = (spline(&moved, &options), s.similar(&map)) else { return Ok(()) };
        prop_assume!(sharpest_turn(&moved, options.closed) > 1e-6);
        agree(&moved, &from_data, &image)?;
        prop_assert_eq!(image.kinks(), s.kinks());
    }

    #[test]
    fn cutting_keeps_every_point(points in data::points(), options in data::options(), a in 0.0..1.0, b in 0.0..1.0) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        let (t0, t1) = if a < b { (a, b) } else { (b, a) };
        prop_assume!(t1 - t0 > 1e-6);
        let part = s.restricted(t0, t1).unwrap();
        prop_assert_eq!(part.point(0.0), s.point(t0));
        prop_assert_eq!(part.point(1.0), s.point(t1));
        prop_assert!(!part.is_closed());
        // Every point of the part at the parameter of the whole that its piece says.
        let first = s.locate(t0).0;
        for (i, segment) in part.segments().iter().enumerate() {
            let [l0, l1] = segment.range();
            for j in 0..=4 {
                let x = f64::from(j) / 4.0;
                let (there, here) = (s.piece_jet(first + i, l0 * (1.0 - x) + l1 * x), segment.jet(x));
                prop_assert_eq!(there.point, here.point);
                prop_assert!((there.d1 * (l1 - l0) - here.d1).length() <= 1e-14 * here.d1.length());
            }
        }
        if t0 > 0.0 {
            let (left, right) = s.split(t0).unwrap();
            prop_assert_eq!(left.point(1.0), right.point(0.0));
            prop_assert_eq!(left.point(0.0), s.point(0.0));
        }
    }
}

#[test]
fn other_moebius_maps_are_refused() {
    let points = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(0.0, 1.0, 1.0)];
    let s = CircleSpline::from_points(&points, &Default::default()).unwrap();
    let inversion = Mobius::inversion(p(5.0, 5.0, 5.0), 1.0).unwrap();
    assert_eq!(s.similar(&inversion).unwrap_err().reason(), "not-a-similarity");
    for (t0, t1) in [(0.5, 0.5), (0.7, 0.2), (-0.1, 0.5), (0.5, 1.1), (f64::NAN, 0.5)] {
        assert_eq!(s.restricted(t0, t1).unwrap_err().reason(), "parameter-out-of-range");
    }
    let joint = 1.0_f64 / 3.0;
    assert_eq!(s.restricted(joint, joint.next_up()).unwrap_err().reason(), "parameter-out-of-range");
    // Cut at a joint: whole segments.
    let (left, right) = s.split(1.0 / 3.0).unwrap();
    assert_eq!((left.piece_count(), right.piece_count()), (1, 2));
}
