//! Biarcs on the projective line, quartic biarcs of one type and of two.

use crate::data::{places, reach, tori};
use cyclide::{
    Point2, Vec2,
    construct::{ProjectiveBiarc, TwoTypeBiarc},
    curve::ParamCurve,
    surface::{CircleFamily, QuarticType, TorusSpline},
};
use cyclide_testkit::attack::Random;
use cyclide_testkit::torus_splines::{faults, off_torus};

/// `m0 m h0² = sin² x`, `m m1 h1² = sin² (D - x)`: the condition that each piece is one linear function.
#[test]
fn both_pieces_are_linear() {
    let (mut r, mut sharp) = (Random::new(30, 7), 0);
    for case in 0..500 {
        let sign = r.pick(&[-1.0, 1.0]);
        let step = sign * if case % 5 == 0 { r.decades(-12.0, -1.0) } else { r.between(0.01, 3.1) };
        let [m0, m1] = [0; 2].map(|_| sign * r.decades(-3.0, 3.0));
        let [h0, h1] = [0; 2].map(|_| r.decades(-2.0, 2.0));
        let biarc = ProjectiveBiarc::new(r.between(-9.0, 9.0), step, [m0, m1], [h0, h1]).unwrap();
        let (x, m) = (biarc.mid_offset(), biarc.mid_slope());
        assert!(x * sign > 0.0 && (step - x) * sign > 0.0 && m * sign > 0.0, "{step} {x}");
        // Next to pi the sine loses the digits that the angle has lost.
        let close = |a: f64, b: f64, d: f64| (a - b).abs() <= 1e-11 * b + 1e-15 / d.sin().abs() * b;
        assert!(close(m0 * m * h0 * h0, x.sin().powi(2), x), "{case}");
        let rest = step - x;
        let rounding = 4.0 * f64::EPSILON * step.abs() / rest.sin().abs();
        assert!((m * m1 * h1 * h1 / rest.sin().powi(2) - 1.0).abs() <= 1e-11 + 4.0 * rounding, "{case}");
        // The sum of the lengths is rounded, which counts by the slope there.
        let rounding = 4.0 * f64::EPSILON * (step.abs() + (h0 + h1) * m1.abs());
        assert!((biarc.offset(h0 + h1) - step).abs() <= rounding, "{case}");
        assert_eq!((biarc.offset(-1.0), biarc.offset(h0)), (0.0, x));
        // Slopes as difference quotients of the angle, one-sided, second order.
        let slope = |u: f64, h: f64| {
            let at = |k: f64| biarc.offset(u + k * h);
            (-3.0 * at(0.0) + 4.0 * at(1.0) - at(2.0)) / (2.0 * h)
        };
        let (e0, e1) = (1e-5 * h0.min(x.sin().abs() / m0.abs()), 1e-5 * h1.min(rest.sin().abs() / m1.abs()));
        for (u, e, m) in [(0.0, e0, m0), (h0 + h1, -e1, m1)] {
            // The rounding of the parameter and of the angle, over the step.
            let rounding = 8.0 * f64::EPSILON * ((h0 + h1) / e.abs() + (step / (m * e)).abs());
            let quotient = slope(u, e) / m;
            assert!((quotient - 1.0).abs() < 1e-4 + rounding, "{case} {quotient} {rounding}");
            sharp += usize::from(rounding < 1e-2);
        }
    }
    assert!(sharp > 800, "{sharp} of 1000 slopes were looked at");
}

#[test]
fn a_coordinate_may_stand_still() {
    let biarc = ProjectiveBiarc::new(0.3, 0.0, [0.0, 0.0], [1.0, 2.0]).unwrap();
    assert_eq!((biarc.offset(1.7), biarc.mid_slope(), biarc.start()), (0.0, 0.0, 0.3));
}

/// Random monotone data of every type: both ends, both tangents, C1, on the torus, the rational form is the same curve.
#[test]
fn quartic_biarcs_have_their_data() {
    let mut r = Random::new(30, 8);
    for torus in tori() {
        for kind in QuarticType::ALL {
            for start in places().into_iter().take(12) {
                let sign = [0; 2].map(|_| r.pick(&[-1.0, 1.0]));
                let step = kind.back(sign.map(|s| s * r.between(0.05, 1.4)));
                let rates = [0; 2].map(|_| kind.back(sign.map(|s| s * r.between(0.1, 3.0))));
                let lengths = [r.between(0.2, 1.0), r.between(0.2, 1.0)];
                let curve = TorusSpline::quartic_biarc(&torus, kind, start, step, rates, lengths).unwrap();
                assert_eq!(faults(&curve), Vec::<String>::new(), "{torus:?} {kind:?}");
                let end = curve.jet_at_knot(lengths[0] + lengths[1]);
                assert!(end.point.distance(torus.point(start + step)) < 1e-14 * 4.0 * reach(&torus));
                for (u, place, rate) in [(0.0, start, rates[0]), (lengths[0] + lengths[1], start + step, rates[1])] {
                    let want = torus.tangent(place, rate);
                    let error = (curve.jet_at_knot(u).d1 - want).length();
                    assert!(error < 1e-12 * want.length() + 1e-13 * reach(&torus), "{error:e}");
                }
                assert!(curve.pieces().iter().all(|p| p.quartic_type() == kind && p.degree() == 4));
            }
        }
    }
}

/// A coordinate that stands still gives an exact arc of a circle, of degree 2.
#[test]
fn circles_come_out_with_degree_two() {
    for torus in tori() {
        for kind in QuarticType::ALL {
            for i in 0..2 {
                let family = kind.families()[i];
                let along = |x: f64| family.direction() * x;
                let start = Point2::new(0.3, 0.8);
                let rates = [along(0.5), along(1.5)];
                let curve = TorusSpline::quartic_biarc(&torus, kind, start, along(0.9), rates, [0.4, 0.6]).unwrap();
                let circle = torus.circle(family, start).unwrap();
                assert_eq!(curve.to_nurbs().unwrap().degree(), 2, "{kind:?}");
                for k in 0..=20 {
                    let p = curve.point(f64::from(k) / 20.0);
                    assert!(circle.closest_point(p).distance < 1e-13 * reach(&torus));
                }
            }
        }
    }
}

/// Derivatives of every order against finite differences of the next lower one.
#[test]
fn jets_are_derivatives() {
    let torus = &tori()[1];
    for kind in QuarticType::ALL {
        let rates = [kind.back([0.8, 1.1]), kind.back([1.3, 0.4])];
        let curve =
            TorusSpline::quartic_biarc(torus, kind, Point2::new(0.3, -0.9), kind.back([0.9, 0.7]), rates, [0.5; 2]);
        let curve = curve.unwrap();
        for s in [0.1, 0.35, 0.6, 0.9] {
            let (h, jet) = (1e-5, curve.piece_jet(0, s));
            let (before, after) = (curve.piece_jet(0, s - h), curve.piece_jet(0, s + h));
            let quotients = [
                ((after.point - before.point) / (2.0 * h), jet.d1),
                ((after.d1 - before.d1) / (2.0 * h), jet.d2),
                ((after.d2 - before.d2) / (2.0 * h), jet.d3),
            ];
            for (quotient, derivative) in quotients {
                // h² times two orders more, and rounding over h.
                assert!((quotient - derivative).length() < 1e-7 * (1.0 + derivative.length()), "{kind:?} {s}");
            }
            let normal = torus.unit_normal(curve.pieces()[0].place(s));
            assert!((curve.seam_frame(0.5 * s).unwrap().z() - normal).length() < 1e-14);
        }
    }
}

fn between([i, j]: [usize; 2]) -> QuarticType {
    QuarticType::between(CircleFamily::ALL[i], CircleFamily::ALL[j]).unwrap()
}

/// Quarters that start along a parallel and end along a meridian, clockwise: every one has a solution, C1 and on its data.
#[test]
fn two_type_quarters_have_their_data() {
    let mut r = Random::new(30, 9);
    let kinds = [between([1, 3]), between([0, 1])];
    for _ in 0..300 {
        let (w, h) = (r.between(0.1, 0.9), r.between(0.1, 0.9));
        let (start, step) = (Point2::new(r.between(-3.0, 3.0), r.between(-3.0, 3.0)), Vec2::new(w, -h));
        let rates = [Vec2::new(w * r.decades(-0.9, 0.9), 0.0), Vec2::new(0.0, -h * r.decades(-0.9, 0.9))];
        for biarc in TwoTypeBiarc::all(kinds, start, step, rates, [0.5, 0.5]).unwrap() {
            let [first, second] = biarc.pieces();
            let (middle, speed) = biarc.middle();
            assert!(
                (first.place(1.0) - middle).length() < 1e-13 && (second.place(1.0) - (start + step)).length() < 1e-12
            );
            let close = |a: Vec2, b: Vec2| (a - b).length() < 1e-9 * (1.0 + b.length());
            assert!(close(first.rate(0.0) * 2.0, rates[0]) && close(second.rate(1.0) * 2.0, rates[1]));
            assert!(close(first.rate(1.0) * 2.0, speed) && close(second.rate(0.0) * 2.0, speed));
        }
    }
}

/// The loop of four points on the side of the torus, in both senses: closed, C1, eight quartics of two types each quarter.
#[test]
fn four_point_loops_close() {
    for torus in tori() {
        for turn in [1.0, -1.0] {
            let places =
                [[0.0, 0.4], [0.5, 0.0], [0.0, -0.4], [-0.5, 0.0]].map(|[a, b]| Point2::new(0.3 + turn * a, 0.8 + b));
            let rates = [[0.7, 0.0], [0.0, -0.6], [-0.8, 0.0], [0.0, 0.5]].map(|[a, b]| Vec2::new(turn * a, b));
            let ring = TorusSpline::two_type_loop(&torus, &places, &rates).unwrap();
            assert_eq!(faults(&ring), Vec::<String>::new());
            assert!(ring.is_closed() && ring.winding() == Some([0, 0]) && ring.pieces().len() == 8);
            for (i, (place, rate)) in places.into_iter().zip(rates).enumerate() {
                let jet = ring.jet_at_knot(i as f64);
                assert_eq!(jet.point, torus.point(place));
                let want = torus.tangent(place, rate);
                assert!((jet.d1 - want).length() < 1e-12 * want.length());
                let [before, after] = ring.junctions()[2 * i].types;
                assert!(before != after && ring.junctions()[2 * i].is_given);
            }
            assert!((0..100).all(|k| off_torus(&torus, ring.point(f64::from(k) / 100.0)) < 2e-14 * reach(&torus)));
        }
    }
}

/// Small loops are C1 to rounding as large ones are.
#[test]
fn small_loops_keep_their_directions() {
    let torus = tori()[0];
    for size in [1.0, 1e-2, 1e-4, 1e-7, 1e-12] {
        let places = [[0.0, 0.4], [0.4, 0.0], [0.0, -0.4], [-0.4, 0.0]].map(|[a, b]| Point2::new(size * a, size * b));
        let rates = [[1.0, 0.0], [0.0, -1.0], [-1.0, 0.0], [0.0, 1.0]];
        let rates = rates.map(|[a, b]| Vec2::new(0.4 * size * a, 0.4 * size * b));
        let ring = TorusSpline::two_type_loop(&torus, &places, &rates).unwrap();
        let pieces = ring.pieces();
        for (i, piece) in pieces.iter().enumerate() {
            let (rate, next) = (piece.rate(1.0), pieces[(i + 1) % pieces.len()].rate(0.0));
            assert!((rate - next).length() < 1e-13 * rate.length(), "{size}: {rate:?} {next:?}");
        }
    }
    // Directions that no quarter has are told as such, without a number that is none.
    let places = [[0.0, 0.4], [0.4, 0.0], [0.0, -0.4], [-0.4, 0.0]].map(Point2::from);
    for rate in [[-1.0, 0.0], [0.0, 1.0], [-1.0, -1.0], [1e-300, 0.0]] {
        let rates = [Vec2::new(rate[0], rate[1]), Vec2::new(0.0, -1.0), Vec2::new(-1.0, 0.0), Vec2::new(0.0, 1.0)];
        let Err(error) = TorusSpline::two_type_loop(&torus, &places, &rates) else { continue };
        let text = error.to_string();
        assert!(error.reason() == "no-two-type-solution" && !text.contains("not a number"), "{text}");
        assert!(!text.contains("infinite"), "{text}");
    }
}
