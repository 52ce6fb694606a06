//! Random awkward problems: all are solved, and every solution obeys every law.

use cyclide::{
    Frame, Point2, Vec2,
    construct::{TorusSplineOptions, TorusTangent, TorusWinding},
    surface::{SegmentMethod, Torus, TorusSpline},
};
use cyclide_testkit::attack::Random;
use cyclide_testkit::torus_splines::Problem;

/// Solves problems of one seed; returns how many segments each method joined, and the most pieces of a segment.
fn all_solved(seed: u64, count: u64) -> ([usize; 3], usize) {
    let (mut methods, mut most) = ([0; 3], 0);
    for case in 0..count {
        let problem = Problem::awkward(seed, case);
        let solved = problem.solve();
        assert!(solved.is_ok(), "{seed}/{case}: {solved:?} of {problem:?}");
        let spline = solved.unwrap();
        let faults = problem.faults(&spline);
        assert!(faults.is_empty(), "{seed}/{case}: {faults:?}\n{problem:?}");
        for segment in spline.segments() {
            let index = match segment.method {
                SegmentMethod::Direct => 0,
                SegmentMethod::Halved => 1,
                _ => 2,
            };
            methods[index] += 1;
            most = most.max(segment.pieces.len());
            assert!(segment.quality > 0.0 && segment.quality <= 1.0);
        }
    }
    (methods, most)
}

#[test]
fn awkward_problems_are_all_solved() {
    let (methods, most) = all_solved(30, 2_000);
    // Every way to join a segment is taken by many: the problems are what they should be.
    assert!(methods.iter().all(|count| *count > 1_000), "{methods:?}");
    assert!(most < 200, "{most}");
}

/// Data at the limits of what is accepted: tangents nearly still and very fast, tiny steps, very uneven knots. They are solved, joined in
/// place and speed, and have a rational form.
#[test]
fn data_at_the_limits_are_solved() {
    let torus = Torus::new(Frame::WORLD, 3.0, 1.0).unwrap();
    let mut r = Random::new(30, 11);
    for case in 0..2000 {
        let n = 2 + r.below(4);
        let direction = |r: &mut Random| {
            let along = r.pick(&[[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0], [0.3, 0.8], [-0.9, 0.1]]);
            Vec2::new(along[0], along[1]) * r.pick(&[-1.0, 1.0])
        };
        let mut places = vec![Point2::new(r.between(-3.0, 3.0), r.between(-3.0, 3.0))];
        let mut knots = vec![0.0];
        for i in 1..n {
            let step = direction(&mut r) * r.decades(-13.0, 0.0);
            places.push(places[i - 1] + step);
            knots.push(knots[i - 1] + r.decades(-4.0, 4.0));
        }
        // By the span before and after: the way of a tangent is what is limited.
        let spans: Vec<f64> = knots.windows(2).map(|k| k[1] - k[0]).collect();
        let tangent = |(i, r): (usize, &mut Random)| {
            let neighbors = [spans[i.saturating_sub(1)], spans[i.min(spans.len() - 1)]];
            let (short, long) = (neighbors[0].min(neighbors[1]), neighbors[0].max(neighbors[1]));
            let way = [11.8 - long.log10(), -11.8 - short.log10()];
            TorusTangent::Rate(direction(r) * r.decades(way[1], way[0]))
        };
        let tangents = (0..n).map(|i| tangent((i, &mut r))).collect();
        let options = TorusSplineOptions { tangents, knots, ..Default::default() };
        let solved = TorusSpline::through_places(&torus, &places, &options);
        assert!(solved.is_ok(), "{case}: {solved:?} of {places:?} {options:?}");
        let spline = solved.unwrap();
        for junction in spline.junctions() {
            let (before, after) = (&spline.pieces()[junction.piece - 1], &spline.pieces()[junction.piece]);
            let gap = torus.point(before.place(1.0)).distance(torus.point(after.place(0.0)));
            assert!(gap < 1e-13, "{case}: {gap:e}");
            let rate = spline.unrolled_rate(junction.piece, 0.0).length();
            let shortest = [junction.piece - 1, junction.piece].map(|i| spline.knots()[i + 1] - spline.knots()[i]);
            // What a coordinate that stands still may leave out, and rounding.
            let allowed = 1e-10 * rate + 1e-14 / shortest[0].min(shortest[1]);
            assert!(junction.rate_jump.length() <= allowed, "{case}: {junction:?}, allowed {allowed:e}");
        }
        for (place, knot) in places.iter().zip(&options.knots) {
            assert!(spline.jet_at_knot(*knot).point.distance(torus.point(*place)) < 1e-13);
        }
        assert!(spline.to_nurbs().is_ok_and(|nurbs| nurbs.weights().iter().all(|w| *w > 0.0)), "{case}");
    }
}

/// The long run: `cargo test --workspace --locked --test torus -- --ignored`.
#[test]
#[ignore = "minutes"]
fn ten_thousand_awkward_problems_are_all_solved() {
    // The figures of `docs/math/torus-splines.md#the-general-problem`.
    let (methods, most) = all_solved(32, 10_000);
    // Sines that differ in the last digit on another machine may change a choice.
    assert!(
        methods.iter().zip([5228, 19_722, 11_299]).all(|(got, want): (&usize, usize)| got.abs_diff(want) < 50),
        "{methods:?}"
    );
    assert!((40..60).contains(&most));
}

/// Places many turns away are the same places: the laws hold as near the start. Angles are up to the largest accepted ones.
#[test]
fn places_many_turns_away_are_joined_as_well() {
    let mut r = Random::new(30, 12);
    for case in 0..600 {
        let mut problem = Problem::awkward(30, case);
        for place in &mut problem.places {
            let far = |r: &mut Random| std::f64::consts::PI * (r.pick(&[-1.0, 1.0]) * r.decades(0.0, 5.4)).round();
            *place += Vec2::new(far(&mut r), far(&mut r));
        }
        if problem.options.loops {
            // Repeated places are the same to the rounding of angles of this size only: the first of them is met.
            let spline = problem.solve().unwrap();
            let faults = cyclide_testkit::torus_splines::faults(&spline);
            assert!(faults.is_empty(), "{case}: {faults:?}\n{problem:?}");
            continue;
        }
        let spline = problem.solve().unwrap_or_else(|e| panic!("{case}: {e} of {problem:?}"));
        let faults = problem.faults(&spline);
        assert!(faults.is_empty(), "{case}: {faults:?}\n{problem:?}");
    }
}

/// Many half turns between two places: the pieces far along keep their digits.
#[test]
fn long_windings_keep_their_digits() {
    for turns in [[2000, 0], [-1500, 700], [3, 2000]] {
        let torus = Torus::new(Frame::WORLD, 3.0, 1.0).unwrap();
        let places = [[0.1, 0.2], [0.9, -0.4]].map(Point2::from).to_vec();
        let winding = TorusWinding::PerSegment(vec![turns]);
        let problem = Problem { torus, places, options: TorusSplineOptions { winding, ..Default::default() } };
        let faults = problem.faults(&problem.solve().unwrap());
        assert!(faults.is_empty(), "{turns:?}: {faults:?}");
    }
    for turns in [[9_999, 10_000], [1, 7001]] {
        let torus = Torus::new(Frame::WORLD, 3.0, 1.0).unwrap();
        let knot = TorusSpline::knot(&torus, turns, Point2::new(0.1, 1e6)).unwrap();
        let faults = cyclide_testkit::torus_splines::faults(&knot);
        assert!(faults.is_empty(), "{turns:?}: {} faults, {:?}", faults.len(), &faults[..faults.len().min(4)]);
    }
}
