//! What holds for every fair spline.

use crate::data::{self, closed, p, reach, samples, spline, with_ends};
use cyclide::{
    Point3, Quat, Vec3, Warning,
    conformal::Mobius,
    construct::{FairEnd, FairSplineOptions},
    curve::{BlendLaw, BlendSegment, BlendVariant, CircleSpline, CircleSplineOptions, ParamCurve},
    model::{Exactness, Lower},
    rational::RationalBezier,
    warning::CurveWarning,
};
use proptest::prelude::*;

fn blend(segment: &BlendSegment) -> f64 {
    if let BlendLaw::Fair { blend } = segment.law() { blend } else { f64::NAN }
}

/// The weight function of a rational curve.
fn weight(bezier: &RationalBezier, l: f64) -> f64 {
    let mut row: Vec<f64> = bezier.rows().iter().map(|r| r[3]).collect();
    while row.len() > 1 {
        row = row.windows(2).map(|w| (1.0 - l) * w[0] + l * w[1]).collect();
    }
    row[0]
}

/// The curvature vectors agree at every joint but kinks, relative to the chords beside it.
fn assert_curvature_is_continuous(spline: &CircleSpline) -> Result<(), TestCaseError> {
    let segments = spline.segments();
    let n = segments.len();
    let reach = segments.iter().map(|s| s.start().to_vec().max_abs()).fold(0.0, f64::max);
    for node in usize::from(!spline.is_closed())..n {
        if spline.kinks().contains(&node) {
            continue;
        }
        let (before, after) = (&segments[(node + n - 1) % n], &segments[node]);
        let scale = 1.0 / before.chord_length() + 1.0 / after.chord_length();
        let jump = (before.end_curvatures()[1] - after.end_curvatures()[0]).length();
        // The equations are solved to 1e-11; beside that, tangents and chords are known to the rounding of coordinates, and
        // near opposite circles, which have the sum of their tangents in a denominator, to that much less.
        let shortest = before.chord_length().min(after.chord_length());
        let apart = [before, after].map(|s| (0.5 * s.theta()).cos().abs()).into_iter().fold(1.0, f64::min);
        let rounding = 64.0 * f64::EPSILON * (1.0 + reach / shortest) / apart.max(1e-12);
        prop_assert!(jump <= (2e-11 + rounding) * scale, "node {node}: {jump:e}, scale {scale:e}");
        let kink = before.end_tangent().angle(after.start_tangent());
        prop_assert!(kink <= 1e-13 + rounding, "node {node}: {kink:e}");
    }
    Ok(())
}

proptest! {
    #[test]
    fn curvature_is_continuous_for_tame_data(points in data::tame(), options in data::options()) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        assert_curvature_is_continuous(&s)?;
    }

    #[test]
    fn curvature_is_continuous_for_wild_data(points in data::wild(), options in data::options()) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        assert_curvature_is_continuous(&s)?;
        for segment in s.segments() {
            prop_assert!((0.0..=1.0 - options.tension).contains(&blend(segment)));
        }
        for sample in samples(&s) {
            prop_assert!(sample.is_finite());
        }
        // What is relaxed is said, segment by segment.
        for warning in s.warnings() {
            if let Warning::Curve(CurveWarning::Relaxed { segments }) = warning {
                prop_assert!(segments.windows(2).all(|w| w[0].0 < w[1].0));
                prop_assert!(options.tight.is_some() || segments.iter().all(|(i, e)| blend(&s.segments()[*i]) == *e));
            }
        }
    }

    #[test]
    fn the_points_are_on_it_to_the_bit(points in data::wild(), options in data::options()) {
        let options = FairSplineOptions { tight: None, ..options };
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        for (segment, point) in s.segments().iter().zip(&points) {
            prop_assert_eq!(segment.start(), *point);
        }
    }

    #[test]
    fn reversed_data_give_the_reversed_curve(points in data::tame(), options in data::options()) {
        let options = FairSplineOptions { ends: [options.ends[0]; 2], ..options };
        let turned = options.ends.map(|end| if let FairEnd::Clamped(t) = end { FairEnd::Clamped(-t) } else { end });
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        let mut back: Vec<Point3> = points.iter().rev().copied().collect();
        if options.closed {
            back.rotate_right(1);
        }
        let Some(from_data) = spline(&back, &FairSplineOptions { ends: turned, ..options }) else { return Ok(()) };
        // A node of relaxed segments has more than one solution near by.
        if !(s.warnings().is_empty() && from_data.warnings().is_empty()) {
            return Ok(());
        }
        let size = reach(&points);
        for (a, b) in samples(&s.reversed()).iter().zip(samples(&from_data)) {
            // Two runs of the search, each to 1e-15 of the tangents.
            prop_assert!(a.distance(b) < 1e-11 * size, "{:e}", a.distance(b));
        }
    }

    #[test]
    fn commutes_with_similarities(
        points in data::tame(), options in data::options(),
        q in (-1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0), factor in -20.0..20.0, mirrored in any::<bool>()
    ) {
        let factor = 10.0_f64.powf(factor);
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        let rotation = Quat::new(q.0, q.1, q.2, q.3);
        if rotation.norm() < 1e-3 || !s.warnings().is_empty() {
            return Ok(());
        }
        let map = Mobius::similarity(rotation, factor, Vec3::new(0.3, -2.0, 1.0) * factor).unwrap();
        let map = if mirrored { map.after(&Mobius::reflection(points[0], Vec3::new(1.0, 2.0, -0.5)).unwrap()) } else { map };
        let moved: Vec<Point3> = points.iter().map(|p| map.map_point(*p).unwrap()).collect();
        let ends = options.ends.map(|end| match end {
            FairEnd::Clamped(t) => FairEnd::Clamped(map.push_forward(points[0], t).unwrap()),
            other => other,
        });
        let Some(from_data) = spline(&moved, &FairSplineOptions { ends, ..options }) else { return Ok(()) };
        if !from_data.warnings().is_empty() {
            return Ok(());
        }
        let image = s.similar(&map).unwrap();
        for (a, b) in samples(&image).iter().zip(samples(&from_data)) {
            // Rounding of the moved points, and of two searches.
            prop_assert!(a.distance(b) < 1e-10 * reach(&moved), "{:e}", a.distance(b));
        }
    }

    #[test]
    fn the_exact_form_is_the_curve(points in data::wild(), options in data::options()) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        let size = reach(&points);
        for segment in s.segments() {
            let bezier = segment.to_bezier().unwrap();
            prop_assert_eq!(bezier.degree(), if blend(segment) == 1.0 { 4 } else { 6 });
            let largest = bezier.rows().iter().flatten().fold(0.0, |m: f64, v| m.max(v.abs()));
            for i in 0..=8 {
                let l = f64::from(i) / 8.0;
                // Coordinates are quotients of sums whose rounding is that of their largest terms; where the curve runs far
                // out, the weight is small beside them.
                let limit = 1e-14 * largest / weight(&bezier, l) + 1e-14 * size;
                let distance = bezier.point(l).distance(segment.point(l));
                let far = segment.point(l).distance(segment.start()) / segment.chord_length();
                prop_assert!(distance <= limit * (1.0 + far), "{distance:e} {limit:e}");
            }
        }
        let Ok((chain, exactness)) = s.to_chain(1e-6 * size) else { return Ok(()) };
        prop_assert_eq!(exactness, Exactness::Exact);
        prop_assert_eq!(chain.is_closed(), s.is_closed());
    }

    #[test]
    fn jets_are_derivatives(points in data::tame(), options in data::options(), l in 0.05..0.95) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        let h = 1e-4;
        for segment in s.segments() {
            let (jet, a, b) = (segment.jet(l), segment.jet(l - h), segment.jet(l + h));
            let size = jet.d1.length() + jet.d2.length() + jet.d3.length();
            // Central differences: the third order term of a function whose derivatives grow by less than 100 each.
            prop_assert!(((b.point - a.point) / (2.0 * h) - jet.d1).length() < 1e-4 * size);
            prop_assert!(((b.d1 - a.d1) / (2.0 * h) - jet.d2).length() < 1e-4 * size);
            prop_assert!(((b.d2 - a.d2) / (2.0 * h) - jet.d3).length() < 1e-4 * size * 1e2);
            prop_assert!((segment.speed(l) - jet.d1.length()).abs() < 1e-12 * size);
        }
    }
}

#[test]
fn the_jump_of_curvature_is_the_gradient_of_the_energy() {
    let points = [p(0.0, 0.0, 0.0), p(1.0, 0.4, 0.2), p(2.1, 0.1, -0.3)];
    let tangents =
        [Vec3::new(1.0, 0.7, 0.1), Vec3::new(1.0, -0.2, 0.3), Vec3::new(0.8, -0.5, -0.4)].map(|t| t.unit().unwrap());
    for blend in [0.0, 0.4, 1.0] {
        let segments = |middle: Vec3| {
            [(0, tangents[0], middle), (1, middle, tangents[2])]
                .map(|(i, a, b)| BlendSegment::fair(points[i], a, points[i + 1], b, blend).unwrap())
        };
        let energy = |middle: Vec3| segments(middle).iter().map(BlendSegment::fair_energy).sum::<f64>();
        let [before, after] = segments(tangents[1]);
        let jump = before.end_curvatures()[1] - after.end_curvatures()[0];
        for direction in [Vec3::X, Vec3::Y, Vec3::Z] {
            let across = direction - tangents[1] * tangents[1].dot(direction);
            let h = 1e-5;
            let at = |h: f64| energy((tangents[1] + across * h).unit().unwrap());
            let slope = (at(h) - at(-h)) / (2.0 * h);
            // Second order differences of a function of size 1.
            assert!((slope - jump.dot(across)).abs() < 1e-9, "{blend}: {slope} {}", jump.dot(across));
        }
    }
}

#[test]
fn end_curvatures_and_variations_are_those_of_the_jets() {
    let (a, b) = (p(0.0, 0.0, 0.0), p(2.0, 1.0, 0.5));
    for blend in [0.0, 0.3, 1.0] {
        let s = BlendSegment::fair(a, Vec3::new(1.0, -0.5, 0.3), b, Vec3::new(0.2, 1.0, 0.4), blend).unwrap();
        for (l, k, v) in
            [(0.0, s.end_curvatures()[0], s.end_variations()[0]), (1.0, s.end_curvatures()[1], s.end_variations()[1])]
        {
            let jet = s.jet(l);
            let speed = jet.d1.length();
            let t = jet.d1 / speed;
            let normal = |w: Vec3| w - t * w.dot(t);
            let curvature = normal(jet.d2) / (speed * speed);
            assert!((curvature - k).length() < 1e-13);
            // The derivative of the curvature vector by arc length, its normal part: (d3 - 3 (d2.t) k speed) / speed³.
            let variation = normal(jet.d3 - curvature * (3.0 * jet.d2.dot(t) * speed)) / speed.powi(3);
            assert!((variation - v).length() < 1e-12, "{blend} {l}");
        }
    }
}

#[test]
fn with_full_tension_it_is_the_circle_spline_of_order_2() {
    let points =
        [[0.0, 0.0, 0.0], [2.0, -0.5, 0.3], [4.0, 0.5, 0.0], [4.5, 2.5, -0.4], [3.0, 4.0, 0.0], [1.8, 3.2, 0.5]];
    let points = points.map(Point3::from);
    for is_closed in [false, true] {
        // A closed curve has no ends to ask for.
        let ends = if is_closed { FairSplineOptions::default().ends } else { [FairEnd::Arc; 2] };
        let fair = FairSplineOptions { closed: is_closed, tension: 1.0, ..with_ends(ends) };
        let order2 = CircleSplineOptions { closed: is_closed, variant: BlendVariant::Rational, ..Default::default() };
        let a = CircleSpline::fair(&points, &fair).unwrap();
        let b = CircleSpline::from_points(&points, &order2).unwrap();
        assert!(a.warnings().is_empty());
        for (x, y) in samples(&a).iter().zip(samples(&b)) {
            // Rounding of coordinates up to 4.
            assert!(x.distance(y) < 4e-15, "{:e}", x.distance(y));
        }
    }
}

#[test]
fn a_node_moves_the_curve_ever_less_with_the_distance() {
    let n = 120;
    let at = |i: usize| {
        let a = std::f64::consts::TAU * i as f64 / n as f64;
        let r = 100.0 + 10.0 * (5.0 * a).sin();
        p(r * a.cos(), r * a.sin(), 6.0 * (3.0 * a).cos())
    };
    let points: Vec<Point3> = (0..n).map(at).collect();
    let mut moved = points.clone();
    moved[0] += Vec3::new(0.6, 0.5, 0.6);
    let (a, b) = (CircleSpline::fair(&points, &closed()).unwrap(), CircleSpline::fair(&moved, &closed()).unwrap());
    let change = |i: usize| (a.segments()[i].start_tangent() - b.segments()[i].start_tangent()).length();
    assert!(change(1) > 1e-3);
    for i in 1..n - 1 {
        let steps = i.min(n - i);
        // By 0.268 from node to node; beyond 30 nodes nothing is left but rounding.
        assert!(change(i) < 2.0 * 0.3_f64.powi(steps as i32) + 1e-13, "{i}: {:e}", change(i));
    }
}

#[test]
fn cuts_and_reversal_keep_what_is_known_of_the_segments() {
    // A zigzag of turns near 160 degrees is relaxed.
    let points: Vec<Point3> = (0..9).map(|i| p(0.2 * f64::from(i), f64::from(i % 2), 0.0)).collect();
    let options = FairSplineOptions { ends: [FairEnd::Arc; 2], ..Default::default() };
    let s = CircleSpline::fair(&points, &options).unwrap();
    let relaxed = |s: &CircleSpline| {
        s.warnings().iter().find_map(|w| {
            if let Warning::Curve(CurveWarning::Relaxed { segments }) = w { Some(segments.clone()) } else { None }
        })
    };
    let all = relaxed(&s).unwrap();
    let back: Vec<(usize, f64)> = all.iter().rev().map(|(i, e)| (7 - i, *e)).collect();
    assert_eq!(relaxed(&s.reversed()).unwrap(), back);
    let part = s.restricted(2.0 / 8.0, 4.0 / 8.0).unwrap();
    let kept: Vec<(usize, f64)> = all.iter().filter(|(i, _)| (2..4).contains(i)).map(|(i, e)| (i - 2, *e)).collect();
    assert_eq!(relaxed(&part).unwrap_or_default(), kept);
    assert_eq!(part.segments()[0].law(), s.segments()[2].law());
}
