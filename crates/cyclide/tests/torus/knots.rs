//! Torus knots.

use crate::data::{reach, tori};
use cyclide::{
    Point2,
    curve::{ParamCurve, joints, length},
    surface::{CircleFamily, QuarticType, Torus, TorusSpline},
};
use cyclide_testkit::torus_splines::{faults, winding};

#[test]
fn knots_wind_as_asked_and_are_c1() {
    for torus in tori() {
        for turns in [[2, 3], [3, 2], [-3, 5], [7, -4], [1, 0], [0, -1], [1, 1], [-1, 1], [1, 9]] {
            let knot = TorusSpline::knot(&torus, turns, Point2::new(0.3, -0.2)).unwrap();
            assert_eq!(faults(&knot), Vec::<String>::new(), "{turns:?}");
            assert_eq!(winding(&knot), turns.map(i64::from));
            // All pieces are one piece turned: speeds agree to rounding without any estimate.
            assert!(knot.junctions().iter().all(|j| j.rate_jump.length() < 1e-14 && j.types[0] == j.types[1]));
        }
    }
}

/// `[1, 0]`, `[0, 1]` and `[±1, ±1]` are circles, of degree 2.
#[test]
fn simple_knots_are_circles() {
    let torus = &tori()[1];
    let start = Point2::new(0.4, 1.0);
    let cases = [
        ([1, 0], CircleFamily::Parallel),
        ([0, 1], CircleFamily::Meridian),
        ([1, 1], CircleFamily::Villarceau),
        ([1, -1], CircleFamily::MirrorVillarceau),
    ];
    for (turns, family) in cases {
        let (knot, circle) = (TorusSpline::knot(torus, turns, start).unwrap(), torus.circle(family, start).unwrap());
        assert_eq!(knot.to_nurbs().unwrap().degree(), 2);
        assert!((length(&knot) - length(&circle)).abs() < 1e-12 * length(&circle), "{turns:?}");
        assert!((0..50).all(|k| circle.closest_point(knot.point(f64::from(k) / 50.0)).distance < 1e-13 * reach(torus)));
    }
}

/// Each point moved along the normal, at the same parameter: exact for all types, in degree 4 and two more for each kind of Villarceau circles.
#[test]
fn parallel_curves_are_the_points_moved_along_the_normal() {
    let mut compared = 0;
    for torus in tori() {
        let (a, b) = (torus.major_radius(), torus.minor_radius());
        let room = b.min(a - b);
        for turns in [[2, 3], [-3, 5], [7, -4], [1, 0], [0, -1], [1, 1], [1, 9]] {
            let knot = TorusSpline::knot(&torus, turns, Point2::new(0.3, -0.2)).unwrap();
            for distance in [0.1 * room, -0.4 * b, 0.5 * (a - b)] {
                let parallel = knot.parallel(distance).unwrap();
                assert!(parallel.is_closed() && parallel.degree() <= 8 && parallel.weights().iter().all(|w| *w > 0.0));
                // Where a weight would not be positive a piece is halved, and parameters are others.
                if parallel.piece_count() != knot.piece_count() {
                    let tube = Torus::new(torus.frame(), a, b + distance).unwrap();
                    let off = (0..500).map(|k| tube.distance(parallel.point(f64::from(k) / 500.0)).abs());
                    assert!(off.fold(0.0, f64::max) < 1e-12 * reach(&torus), "{turns:?} {distance}");
                    continue;
                }
                compared += 1;
                for (piece, own) in knot.pieces().iter().enumerate() {
                    for s in [0.0, 0.2, 0.5, 0.9, 1.0] {
                        let expected = knot.piece_point(piece, s) + torus.unit_normal(own.place(s)) * distance;
                        let off = parallel.piece_point(piece, s).distance(expected);
                        assert!(off < 1e-12 * reach(&torus), "{turns:?} {distance} {piece} {s}: {off:e}");
                    }
                }
            }
            let reason = |distance: f64| knot.parallel(distance).unwrap_err().reason();
            assert_eq!([reason(-b), reason(a - b), reason(f64::NAN)], ["parameter-out-of-range"; 3]);
        }
        for kind in QuarticType::ALL {
            let quartic = TorusSpline::closed_quartic(&torus, kind, Point2::new(0.1, 0.4), 2.0).unwrap();
            let villarceau = [CircleFamily::Villarceau, CircleFamily::MirrorVillarceau];
            let more = kind.families().iter().filter(|family| villarceau.contains(family)).count();
            let parallel = quartic.parallel(0.2 * room).unwrap();
            assert_eq!(parallel.degree(), 4 + 2 * more, "{kind:?}");
            let thicker = Torus::new(torus.frame(), a, b + 0.2 * room).unwrap();
            assert!(
                (0..97).all(|k| thicker.distance(parallel.point(f64::from(k) / 97.0)).abs() < 1e-12 * reach(&torus))
            );
        }
    }
    assert!(compared >= 7 * tori().len(), "{compared}");
}

/// Equal pieces are turned into each other by the longitude, and stay near the straight line of the plane.
#[test]
fn knots_are_nearly_straight_in_the_plane() {
    let torus = &tori()[0];
    let knot = TorusSpline::knot(torus, [2, 3], Point2::default()).unwrap();
    let slope = 1.5;
    for piece in 0..knot.pieces().len() {
        for k in 0..=10 {
            let place = knot.unrolled_place(piece, f64::from(k) / 10.0);
            assert!((place.y - slope * place.x).abs() < 2e-3, "{place:?}");
        }
    }
    assert!(joints(&knot).iter().all(|joint| joint.gap == 0.0 && joint.angle < 1e-13));
}

/// All parallels are crossed at one angle, to 4e-3, and curvature is that of the line: on thin tori and fat ones, with few turns and many.
#[test]
fn knots_cross_parallels_at_one_angle() {
    for (minor, turns) in [
        (15.0, [2, 3]),
        (4.0, [1, 9]),
        (39.0, [5, -7]),
        (15.0, [1, 2]),
        (30.0, [-3, 1]),
        (0.5, [1, 200]),
        (39.9, [200, 1]),
        (12.0, [99, 100]),
    ] {
        let torus = Torus::new(cyclide::Frame::WORLD, 40.0, minor).unwrap();
        let knot = TorusSpline::knot(&torus, turns, Point2::default()).unwrap();
        let [p, q] = turns.map(f64::from);
        let expected = (q * minor).atan2(p * ((40.0 - minor) * (40.0 + minor)).sqrt());
        for piece in 0..knot.piece_count().min(60) {
            for k in 0..=8 {
                let jet = knot.piece_jet(piece, f64::from(k) / 8.0);
                let (x, y) = (jet.point.x, jet.point.y);
                let along = (jet.d1.y * x - jet.d1.x * y) / x.hypot(y);
                let across = (jet.d1.length_squared() - along * along).max(0.0).sqrt() * q.signum();
                // The meridian angle rises with q.
                let angle = across.atan2(along);
                assert!((angle - expected).abs() < 4e-3, "{minor} {turns:?}: {angle} for {expected}");
            }
        }
    }
    // Equal steps of both coordinates: exact.
    let torus = Torus::new(cyclide::Frame::WORLD, 40.0, 15.0).unwrap();
    let knot = TorusSpline::knot(&torus, [1, 2], Point2::default()).unwrap();
    assert!(knot.piece_count() <= 7, "{}", knot.piece_count());
    assert!((0..50).all(|k| {
        let place = knot.unrolled_place(k / 10 % 7, f64::from(k as u32 % 10) / 10.0);
        (place.y - 2.0 * place.x).abs() < 1e-14
    }));
}

/// Closed quartics of all types are C1 curves of degree 4 of one type, and wind as their coordinates do: half a turn each.
#[test]
fn closed_quartics_of_all_types() {
    for torus in tori() {
        for kind in QuarticType::ALL {
            for ratio in [2.5, 0.2, -3.0, -0.4] {
                let start = Point2::new(0.3, -0.7);
                let quartic = TorusSpline::closed_quartic(&torus, kind, start, ratio).unwrap();
                assert_eq!(faults(&quartic), Vec::<String>::new(), "{kind:?} {ratio}");
                let way = kind.back([1.0, f64::signum(ratio)]);
                assert_eq!(winding(&quartic), [way.x, way.y].map(|v| v.round() as i64), "{kind:?} {ratio}");
                assert!(quartic.pieces().iter().all(|piece| piece.quartic_type() == kind && piece.degree() == 4));
                // Speeds at the start are as asked for.
                let [first, second] = kind.local(quartic.unrolled_rate(0, 0.0));
                assert!((second / first - ratio).abs() < 1e-12 * ratio.abs());
                // One quartic: its halves are too, and what it is a quarter on the ratio is the other way round.
                let [first, second] = kind.local(quartic.unrolled_rate(8, 0.0));
                assert!((second / first * ratio - 1.0).abs() < 1e-12);
            }
        }
        let villarceau = QuarticType::between(CircleFamily::Villarceau, CircleFamily::MirrorVillarceau).unwrap();
        let refused = |ratio| TorusSpline::closed_quartic(&torus, villarceau, Point2::default(), ratio).unwrap_err();
        assert_eq!([1.0, -1.0, 0.0, 40.0, f64::NAN].map(|ratio| refused(ratio).reason())[..2], ["not-coprime"; 2]);
        assert_eq!([0.0, 40.0, f64::NAN, f64::INFINITY].map(|r| refused(r).reason()), ["parameter-out-of-range"; 4]);
    }
}
