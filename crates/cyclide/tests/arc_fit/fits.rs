//! The fit as a whole.

use super::*;
use cyclide::warning::{FitWarning, PointWarning};

#[test]
fn samples_of_true_arcs_give_exactly_that_many() {
    // Curvatures that differ clearly at every joint, 24 samples an arc as in the reference data.
    let cases: [&[(f64, f64)]; 5] = [
        &[(3.0, 0.5), (2.0, -0.4), (4.0, 0.2)],
        &[(2.0, 1.0), (3.0, -0.3), (1.5, 1.2), (4.0, 0.1)],
        &[(5.0, 0.1), (2.0, -1.0), (3.0, 0.6), (2.0, -0.5), (3.0, 0.3), (1.5, -1.5)],
        &[(3.0, 0.0), (2.0, 0.7), (3.0, 0.0)],
        &[(2.0, -0.6), (2.0, 0.9), (2.0, -0.9), (2.0, 0.6), (3.0, -0.2), (2.0, 0.8), (2.0, -0.7)],
    ];
    for arcs in cases {
        let points = chain(arcs, 24);
        for effort in [Effort::Fast, Effort::Default, Effort::Best] {
            let fit = fitted(&points, &ArcFitOptions { effort, ..ArcFitOptions::new(0.002) });
            assert_eq!(pieces(&fit), arcs.len(), "{effort:?}");
            assert!(fit.certificate().max_kink < 1e-13);
        }
    }
}

#[test]
fn a_closed_curve_is_tangent_continuous_at_its_seam() {
    let at = |i: usize| {
        let a = TAU * i as f64 / 150.0;
        let r = 3.0 + 0.4 * (3.0 * a).cos();
        Point3::new(r * a.cos(), 0.7 * r * a.sin(), 0.0)
    };
    let points: Vec<_> = (0..150).map(at).collect();
    let mut counts = Vec::new();
    for start in [0, 37, 90] {
        let mut moved = points.clone();
        moved.rotate_left(start);
        for reverse in [false, true] {
            if reverse {
                moved.reverse();
            }
            for options in [closed(0.01), ArcFitOptions { target: FitTarget::Polyline, ..closed(0.01) }] {
                let fit = fitted(&moved, &options);
                assert!(fit.path().is_closed());
                // Coordinates of size 3 on arcs of length 1: a few ulp.
                assert!(fit.certificate().max_kink < 1e-13, "{:e}", fit.certificate().max_kink);
                counts.push(pieces(&fit));
            }
        }
    }
    // Near the minimum, and the same wherever it starts and whichever way it runs.
    assert!(counts.chunks(2).all(|pair| pair == &counts[..2]) && counts.iter().all(|c| *c <= 16), "{counts:?}");
}

#[test]
fn the_arcs_do_not_depend_on_the_first_point_nor_on_the_direction_nor_on_the_unit() {
    for (k, circuit) in cyclide_testkit::circuits::circuits().iter().step_by(5).enumerate() {
        let plain = fitted(&circuit.points, &closed(0.05)).path().length();
        let twin = |points: &[Point3], tolerance: f64| fitted(points, &closed(tolerance)).path().length();
        let mut turned = circuit.points.clone();
        turned.rotate_left((7 + 31 * k) % circuit.points.len());
        let scaled = |factor: f64| -> Vec<Point3> {
            circuit.points.iter().map(|p| Point3::ORIGIN + p.to_vec() * factor).collect()
        };
        let [small, large] = [2_f64.powi(-60), 2_f64.powi(60)];
        let mut lengths = vec![twin(&turned, 0.05)];
        turned.reverse();
        lengths.push(twin(&turned, 0.05));
        lengths.extend([small, large].map(|factor| twin(&scaled(factor), 0.05 * factor) / factor));
        for length in lengths {
            // Sums of the same arcs in another order.
            assert!((length / plain - 1.0).abs() < 1e-12, "{}: {plain} {length}", circuit.name);
        }
    }
}

#[test]
fn one_circle_and_one_arc_are_found_whole() {
    let fit = fitted(&circle(50, TAU, 2.0, Point3::new(1e6, -1e6, 3.0)), &closed(1e-3));
    assert_eq!(pieces(&fit), 2);
    for arc in fit.path().arcs() {
        // Coordinates of 1e6 are rounded to 1e-10.
        assert!((arc.radius().unwrap() - 2.0).abs() < 1e-9);
    }
    let fit = fitted(&circle(50, 300_f64.to_radians(), 1.0, Point3::ORIGIN), &ArcFitOptions::new(1e-3));
    assert_eq!(pieces(&fit), 1);
    let line: Vec<_> = (0..20).map(|i| Point3::new(f64::from(i), 2.0 * f64::from(i), -f64::from(i))).collect();
    let fit = fitted(&line, &ArcFitOptions::new(1e-3));
    assert_eq!((pieces(&fit), fit.certificate().lines), (1, 1));
}

#[test]
fn two_turns_of_a_circle_are_not_one() {
    let two = circle(100, 2.0 * TAU, 1.0, Point3::ORIGIN);
    for options in [ArcFitOptions::new(1e-3), closed(1e-3)] {
        let fit = fitted(&two, &options);
        // The points run round twice, and so does the path.
        let length = 4.0 * PI * if options.closed { 1.0 } else { 99.0 / 100.0 };
        assert!((fit.path().length() - length).abs() < 0.01 * length, "{}", fit.path().length());
    }
}

#[test]
fn out_and_back_turns_round_at_the_far_end() {
    let out = (0..20).map(|i| Point3::new(f64::from(i), 0.0, 0.0));
    let exact: Vec<_> = out.clone().chain((0..19).rev().map(|i| Point3::new(f64::from(i), 0.0, 0.0))).collect();
    let fit = fitted(&exact, &ArcFitOptions::new(0.1));
    assert_eq!(fit.certificate().lines, 2);
    assert!(matches!(fit.warnings(), [Warning::Fit(FitWarning::CornerKept { vertex: 19, .. })]));
    let beside: Vec<_> = out.chain((0..20).rev().map(|i| Point3::new(f64::from(i), 0.5, 0.0))).collect();
    let fit = fitted(&beside, &ArcFitOptions::new(0.1));
    assert!(fit.path().length() > 38.0);
}

#[test]
fn a_zigzag_at_the_tolerance_gives_no_rogue_arc() {
    for tolerance in [1.0 - 1e-9, 1.0 + 1e-9] {
        let zigzag: Vec<_> =
            (0..40).map(|i| Point3::new(f64::from(i), if i % 2 == 0 { 1.0 } else { -1.0 }, 0.0)).collect();
        for base in [ArcFitOptions::new(tolerance), polyline(tolerance)] {
            let options = ArcFitOptions { corner_angle: Some(PI), ..base };
            match ArcFit::new(&zigzag, &options) {
                Ok(fit) => check(&zigzag, &options, &fit),
                Err(error) => assert_eq!(error.reason(), "no-g1-spline-in-tube"),
            }
        }
    }
}

/// An L of two legs with a rounded and a sharp corner, dense points.
fn bracket() -> Vec<Point3> {
    let mut points: Vec<_> = (0..30).map(|i| Point3::new(0.1 * f64::from(i), 0.0, 0.0)).collect();
    points.extend((0..30).map(|i| {
        let (s, c) = (-FRAC_PI_2 + FRAC_PI_2 * f64::from(i) / 30.0).sin_cos();
        Point3::new(3.0 + c, 1.0 + s, 0.0)
    }));
    points.extend((0..30).map(|i| Point3::new(4.0, 1.0 + 0.1 * f64::from(i), 0.0)));
    points.extend((0..=30).map(|i| Point3::new(4.0 - 0.1 * f64::from(i), 4.0, 0.0)));
    points
}

#[test]
fn corners_are_kept_by_angle_and_by_index() {
    let points = bracket();
    for base in [ArcFitOptions::new(1e-3), polyline(1e-3)] {
        let fit = fitted(&points, &base);
        assert!(fit.path().closest_point(Point3::new(4.0, 4.0, 0.0)).distance == 0.0);
        assert!(
            matches!(fit.warnings(), [Warning::Fit(FitWarning::CornerKept { vertex: 90, count: 1, most, .. })] if (most - FRAC_PI_2).abs() < 1e-9)
        );
        assert!(fit.certificate().max_kink < 1e-13);
        let fit = fitted(&points, &ArcFitOptions { corners: vec![15], ..base });
        assert!(matches!(fit.warnings(), [Warning::Fit(FitWarning::CornerKept { vertex: 15, count: 2, .. })]));
        assert!(fit.path().arcs().iter().any(|a| a.end() == points[15]));
    }
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|p| Point3::new(p[0], p[1], 0.0));
    let fit = fitted(&square, &ArcFitOptions { closed: true, ..polyline(1e-3) });
    assert_eq!((fit.certificate().lines, fit.certificate().arcs), (4, 0));
    // Without corners the polyline can still be followed, rounding by the tolerance.
    let fit = fitted(&square, &ArcFitOptions { closed: true, corner_angle: Some(PI), ..polyline(1e-3) });
    assert!(fit.certificate().max_kink < 1e-12);
}

#[test]
fn a_tolerance_as_wide_as_the_figure_still_has_a_fit() {
    // Points without order: the search in the whole tube dies at the ninth.
    let points = [
        [0.1595712467096746, 0.8527005277574062],
        [0.8138867621310055, 0.7936311149969697],
        [0.8960940479300916, 0.4813811220228672],
        [0.8068309016525745, 0.6460279668681324],
        [0.9237998379394412, 0.6526364600285888],
        [0.05000823736190796, 0.23717439221218228],
        [0.05431232042610645, 0.4463132433593273],
        [0.3676684186793864, 0.4578312742523849],
        [0.8364745290018618, 0.9953548470512033],
        [0.6382710933685303, 0.08920634491369128],
        [0.3306893026456237, 0.08871648786589503],
    ]
    .map(|[x, y]| Point3::new(x, y, 0.0));
    for closed in [false, true] {
        let options = ArcFitOptions { closed, ..ArcFitOptions::new(1.0) };
        check(&points, &options, &fitted(&points, &options));
    }
}

#[test]
fn a_polyline_without_room_is_refused_with_its_place() {
    // Short edges beside long ones, turning by less than a corner: the search finds no way past the sixth point, nor past the
    // sixth from the end, as the other half is the first turned about their middle.
    // (It is a search: data that a better one fits should be replaced by harder data.)
    let points = [
        [0.0, 0.0],
        [0.001396136825860192, 0.0002658291767813673],
        [0.028466842482326168, 0.015432042093839051],
        [0.028596732204657815, 0.015492004942723802],
        [0.05035439623533945, 0.02734672223265036],
        [0.05059622764638955, 0.027542716273130024],
        [0.766314997501115, 0.6359705768777246],
        [1.3390979039628366, 1.1004304063586954],
        [1.5141648363581874, 1.2656619716334785],
    ]
    .map(|[x, y]| Point3::new(x, y, 0.0));
    let middle = points[8] + (points[8] - points[7]) * 0.5;
    let points: Vec<_> = points.iter().copied().chain(points.iter().rev().map(|p| middle + (middle - *p))).collect();
    let died = ArcFit::new(&points, &polyline(1e-4)).unwrap_err();
    assert_eq!(died.reason(), "no-g1-spline-in-tube");
    assert!(matches!(died.index(), Some(5 | 12)), "{died:?}");
}

#[test]
fn straight_data_give_true_lines() {
    // A slot of two half circles and two straight sides, closed: no end to hide a nearly straight arc in.
    let side = |from: f64, step: f64, y: f64| (0..40).map(move |i| Point3::new(from + step * f64::from(i), y, 0.0));
    let bend = |x: f64, start: f64| {
        (0..40).map(move |i| {
            let (s, c) = (start + PI * f64::from(i) / 40.0).sin_cos();
            Point3::new(x + c, s, 0.0)
        })
    };
    let slot: Vec<_> = side(-2.0, 0.1, -1.0)
        .chain(bend(2.0, -FRAC_PI_2))
        .chain(side(2.0, -0.1, 1.0))
        .chain(bend(-2.0, FRAC_PI_2))
        .collect();
    for base in [closed(1e-3), ArcFitOptions { target: FitTarget::Polyline, ..closed(1e-3) }] {
        for start in [0, 20, 55] {
            let mut points = slot.clone();
            points.rotate_left(start);
            let certificate = *fitted(&points, &base).certificate();
            assert_eq!(certificate.lines, 2, "{certificate:?}");
            assert!(certificate.arcs <= 4 && certificate.max_kink < 1e-13);
        }
    }
    // Open: line, fillet, line between two fixed ends.
    let points = &bracket()[..91];
    let certificate = *fitted(points, &ArcFitOptions::new(1e-3)).certificate();
    assert_eq!((certificate.arcs, certificate.lines), (1, 2));
}

#[test]
fn scale_and_offset_do_not_matter() {
    let points = bracket();
    let count = pieces(&fitted(&points, &ArcFitOptions::new(1e-3)));
    for scale in [1e-6, 1e6] {
        let scaled: Vec<_> = points.iter().map(|p| Point3::new(p.x * scale, p.y * scale, 0.0)).collect();
        assert_eq!(pieces(&fitted(&scaled, &ArcFitOptions::new(1e-3 * scale))), count);
    }
    let moved: Vec<_> = points.iter().map(|p| Point3::new(p.x + 1e6, p.y - 1e6, 1e6)).collect();
    let fit = fitted(&moved, &ArcFitOptions::new(1e-3));
    assert_eq!(pieces(&fit), count);
    // 1e6 is rounded to 1e-10, on arcs of length 1.
    assert!(fit.certificate().max_kink < 1e-9);
    // Any plane.
    let tilted: Vec<_> = points.iter().map(|p| Point3::new(0.6 * p.x, p.y, 0.8 * p.x + 2.0)).collect();
    assert_eq!(pieces(&fitted(&tilted, &ArcFitOptions::new(1e-3))), count);
}

#[test]
fn noise_is_smoothed_within_the_tolerance_and_reported_below_it() {
    let mut random = Random(11);
    let noisy: Vec<_> = (0..300)
        .map(|i| {
            let (s, c) = (0.01 * f64::from(i)).sin_cos();
            Point3::new(10.0 * c + 0.02 * random.next(), 10.0 * s + 0.02 * random.next(), 0.0)
        })
        .collect();
    let fit = fitted(&noisy, &ArcFitOptions::new(0.03));
    assert!(pieces(&fit) <= 3 && fit.warnings().is_empty());
    let fit = fitted(&noisy, &ArcFitOptions { corner_angle: Some(PI), ..ArcFitOptions::new(0.002) });
    assert!(fit.warnings().iter().any(|w| w.reason() == "tolerance-below-noise"));
}

#[test]
fn coarse_samples_are_reported_where_the_edges_are_meant() {
    let coarse = circle(24, TAU, 1.0, Point3::ORIGIN);
    let fit = fitted(&coarse, &ArcFitOptions { closed: true, ..polyline(1e-3) });
    assert!(fit.warnings().iter().any(|w| w.reason() == "samples-too-coarse"));
    assert!(fitted(&coarse, &closed(1e-3)).warnings().is_empty());
}

#[test]
fn equal_neighbors_are_merged_and_indices_stay_the_users() {
    let mut points = bracket();
    points.insert(10, points[10]);
    points.insert(0, points[0]);
    let fit = fitted(&points, &ArcFitOptions::new(1e-3));
    assert!(matches!(
        fit.warnings(),
        [
            Warning::Point(PointWarning::PointsMerged { first: 1, count: 2, .. }),
            Warning::Fit(FitWarning::CornerKept { vertex: 92, .. })
        ]
    ));
    let mut ring = circle(40, TAU, 1.0, Point3::ORIGIN);
    ring.push(ring[0]);
    let fit = ArcFit::new(&ring, &closed(1e-3)).unwrap();
    assert!(matches!(fit.warnings(), [Warning::Point(PointWarning::ClosingPointMerged { index: 40, .. })]));
}

#[test]
fn points_in_space_are_fitted_by_biarcs() {
    let helix: Vec<_> = (0..200)
        .map(|i| {
            let a = 0.06 * f64::from(i);
            Point3::new(a.cos(), a.sin(), 0.2 * a)
        })
        .collect();
    for options in [ArcFitOptions::new(1e-3), polyline(1e-3)] {
        let fit = fitted(&helix, &options);
        assert!(fit.certificate().max_kink < 1e-12);
        assert!(pieces(&fit) <= 40, "{}", pieces(&fit));
    }
    let knot: Vec<_> = (0..300)
        .map(|i| {
            let a = TAU * f64::from(i) / 300.0;
            let r = 2.0 + (3.0 * a).cos();
            Point3::new(r * (2.0 * a).cos(), r * (2.0 * a).sin(), (3.0 * a).sin())
        })
        .collect();
    let fit = fitted(&knot, &closed(5e-3));
    assert!(fit.path().is_closed() && fit.certificate().max_kink < 1e-12);
}

#[test]
fn bad_input_has_named_errors() {
    let p = |x: f64| Point3::new(x, 0.0, 0.0);
    let reason = |points: &[Point3], options: &ArcFitOptions| ArcFit::new(points, options).unwrap_err().reason();
    let open = ArcFitOptions::new(0.1);
    assert_eq!(reason(&[p(0.0)], &open), "too-few-points");
    assert_eq!(reason(&[], &open), "too-few-points");
    assert_eq!(reason(&[p(0.0), p(1.0)], &closed(0.1)), "too-few-points");
    assert_eq!(reason(&[p(1.0), p(1.0), p(1.0)], &open), "coincident-points");
    assert_eq!(reason(&[p(0.0), p(f64::NAN)], &open), "not-finite");
    assert_eq!(reason(&[p(0.0), p(1.0)], &ArcFitOptions::new(0.0)), "tolerance-not-positive");
    assert_eq!(reason(&[p(0.0), p(1.0)], &ArcFitOptions::new(f64::NAN)), "tolerance-not-positive");
    assert_eq!(
        reason(&[p(0.0), p(1.0)], &ArcFitOptions { corners: vec![2], ..open.clone() }),
        "parameter-out-of-range"
    );
    assert_eq!(reason(&[p(0.0), p(1.0)], &ArcFitOptions { corner_angle: Some(4.0), ..open }), "parameter-out-of-range");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(48) })]

    #[test]
    fn whatever_is_fitted_keeps_its_promises(
        arcs in prop::collection::vec((0.5..4.0_f64, -1.2..1.2_f64), 1..6),
        per_arc in 4_usize..20, noise in 0.0..0.01_f64, tolerance in 0.003..0.05_f64,
        edges: bool, is_closed: bool, seed: u64,
    ) {
        let mut random = Random(seed);
        let points: Vec<_> = chain(&arcs, per_arc)
            .into_iter()
            .map(|p| Point3::new(p.x + noise * random.next(), p.y + noise * random.next(), 0.0))
            .collect();
        let target = if edges { FitTarget::Polyline } else { FitTarget::Points };
        let options = ArcFitOptions { closed: is_closed, target, ..ArcFitOptions::new(tolerance) };
        match ArcFit::new(&points, &options) {
            Ok(fit) => {
                check(&points, &options, &fit);
                prop_assert!(fit.certificate().max_kink < 1e-9);
            }
            Err(error) => prop_assert!(edges && error.reason() == "no-g1-spline-in-tube", "{}", error),
        }
    }

    #[test]
    fn no_input_makes_it_panic(
        raw in prop::collection::vec(prop::array::uniform3(prop_oneof![
            Just(0.0), Just(1.0), Just(1e-300), Just(1e300), Just(f64::MAX), -2.0..2.0_f64,
        ]), 0..12),
        tolerance in prop_oneof![Just(1e-300), Just(1e300), 1e-6..1.0_f64],
        edges: bool, is_closed: bool,
    ) {
        let points: Vec<_> = raw.into_iter().map(Point3::from).collect();
        let target = if edges { FitTarget::Polyline } else { FitTarget::Points };
        let options = ArcFitOptions { closed: is_closed, target, ..ArcFitOptions::new(tolerance) };
        if let Ok(fit) = ArcFit::new(&points, &options) {
            prop_assert!(fit.certificate().deviation <= tolerance);
        }
    }
}

#[test]
fn noisy_straight_sides_are_lines_not_bows() {
    // A rectangle with errors of 0.02; a tolerance of several times that leaves room for bows of 0.13.
    let mut random = Random(3);
    let corners = [[0.0, 0.0], [100.0, 0.0], [100.0, 60.0], [0.0, 60.0]];
    let mut points = Vec::new();
    for i in 0..4 {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        for k in 0..40 {
            let t = f64::from(k) / 40.0;
            let mut at = |d: usize| a[d] + (b[d] - a[d]) * t + 0.04 * (random.next() - 0.5);
            points.push(Point3::new(at(0), at(1), 0.0));
        }
    }
    for tolerance in [0.1, 0.15, 0.3] {
        let fit = fitted(&points, &closed(tolerance));
        // One arc may be nearer to its data than the line between two noisy corners.
        assert!(fit.certificate().lines >= 3 && pieces(&fit) == 4, "{tolerance}: {:?}", fit.certificate());
        assert!(fit.certificate().deviation < 0.09, "{tolerance}: {}", fit.certificate().deviation);
    }
}

#[test]
fn a_tolerance_of_the_size_of_the_figure_is_named() {
    let ring = circle(60, TAU, 1.0, Point3::ORIGIN);
    let wide = |tolerance: f64| {
        let fit = ArcFit::new(&ring, &closed(tolerance)).unwrap();
        fit.warnings().iter().any(|w| w.reason() == "wide-tolerance")
    };
    assert!(wide(0.5) && !wide(0.1));
}

#[test]
fn a_turn_between_straight_sides_is_rounded_within_the_tolerance() {
    // Forty points on each side; corners below 30 degrees are no corners to the fit. Nothing but the turn itself asks the
    // curve to leave the sides: a spline through the points does, by a meter and a half.
    let corners = [
        [297, 87],
        [159, 249],
        [-75, 429],
        [-287, 406],
        [-285, 398],
        [242, -365],
        [366, -309],
        [445, -221],
        [357, -153],
    ];
    let corners = corners.map(|[x, y]| Point3::new(f64::from(x), f64::from(y), 0.0));
    let side = |i: usize| (0..40).map(move |k| corners[i].lerp(corners[(i + 1) % 9], f64::from(k) / 40.0));
    let points: Vec<Point3> = (0..9).flat_map(side).collect();
    for tolerance in [0.5, 0.05, 0.02, 0.01, 0.005] {
        for effort in [Effort::Fast, Effort::Default, Effort::Best] {
            let fit = ArcFit::new(&points, &ArcFitOptions { closed: true, effort, ..ArcFitOptions::new(tolerance) });
            let fit = fit.unwrap();
            assert!(pieces(&fit) <= 14, "{tolerance}, {effort:?}: {} pieces", pieces(&fit));
            assert!(fit.warnings().iter().all(|w| w.reason() != "swings-out"));
            // Turns that make a tenth of the tolerance are left to it.
            assert!(fit.certificate().polyline_deviation <= 1.1 * tolerance);
        }
    }
}
