//! What is refused, with its reason; wild input never panics.

use crate::data;
use cyclide::{
    Frame, Point2, Point3, Vec2,
    construct::{ProjectiveBiarc, TorusSplineOptions, TorusTangent, TorusWinding, TwoTypeBiarc},
    surface::{CircleFamily, QuarticType, Torus, TorusClasses, TorusSpline},
};
use cyclide_testkit::generators::wild;
use proptest::prelude::*;

fn reason(places: &[[f64; 2]], options: &TorusSplineOptions) -> &'static str {
    let places: Vec<Point2> = places.iter().map(|p| Point2::from(*p)).collect();
    TorusSpline::through_places(&data::tori()[0], &places, options).unwrap_err().reason()
}

#[test]
fn tori() {
    let new = |a, b| Torus::new(Frame::WORLD, a, b).unwrap_err().reason();
    assert_eq!([new(1.0, 1.0), new(1.0, 2.0), new(1.0, 0.0), new(-2.0, 1.0)], ["not-a-ring-torus"; 4]);
    assert_eq!([new(f64::NAN, 1.0), new(1.0, f64::NAN), new(f64::INFINITY, 1.0)], ["not-finite"; 3]);
    assert_eq!([new(1e160, 1.0), new(1e-160, 1e-161)], ["parameter-out-of-range"; 2]);
    let far = Frame::from_normal(Point3::new(1e13, 0.0, 0.0), cyclide::Vec3::Z, cyclide::Vec3::X).unwrap();
    assert_eq!(Torus::new(far, 3.0, 1.0).unwrap_err().reason(), "below-rounding-of-place");
}

#[test]
fn splines() {
    let with = |change: fn(&mut TorusSplineOptions)| {
        let mut options = TorusSplineOptions::default();
        change(&mut options);
        options
    };
    let (two, none) = ([[0.0, 0.0], [1.0, 0.5]], TorusSplineOptions::default());
    assert_eq!(reason(&[], &none), "too-few-points");
    assert_eq!(reason(&[[0.0, 0.0]], &none), "too-few-points");
    assert_eq!(reason(&[[0.0, f64::NAN], [1.0, 0.0]], &none), "not-finite");
    assert_eq!(reason(&[[0.0, 1e7], [1.0, 0.0]], &none), "parameter-out-of-range");
    assert_eq!(reason(&[[0.0, 0.0]], &with(|o| o.closed = true)), "too-few-points");
    assert_eq!(reason(&two, &with(|o| o.tangents = vec![TorusTangent::Free])), "count-differs");
    assert_eq!(reason(&two, &with(|o| o.tangents = vec![TorusTangent::Rate(Vec2::default()); 2])), "zero-tangent");
    let nan = TorusTangent::Velocity(cyclide::Vec3::new(0.0, f64::NAN, 0.0));
    let tangents = TorusSplineOptions { tangents: vec![nan; 2], ..Default::default() };
    assert_eq!(reason(&two, &tangents), "not-finite");
    let fast = TorusSplineOptions { tangents: vec![TorusTangent::Rate(Vec2::new(1e13, 0.0)); 2], ..Default::default() };
    assert_eq!(reason(&two, &fast), "parameter-out-of-range");
    assert_eq!(reason(&two, &with(|o| o.knots = vec![0.0])), "count-differs");
    assert_eq!(reason(&two, &with(|o| o.knots = vec![1.0, 0.0])), "empty-interval");
    assert_eq!(reason(&two, &with(|o| o.knots = vec![1.0, 1.0])), "empty-interval");
    assert_eq!(reason(&two, &with(|o| o.knots = vec![0.0, f64::INFINITY])), "not-finite");
    assert_eq!(reason(&two, &with(|o| o.winding = TorusWinding::PerSegment(vec![]))), "count-differs");
    assert_eq!(
        reason(&two, &with(|o| o.winding = TorusWinding::PerSegment(vec![[i32::MIN, 0]]))),
        "parameter-out-of-range"
    );
    for turns in [[20_000, 0], [0, -2_001]] {
        let closed = TorusSplineOptions { closed: true, winding: TorusWinding::Total(turns), ..Default::default() };
        assert_eq!(reason(&two, &closed), "parameter-out-of-range");
    }
    // One place with a turn is a circle; without, it is none.
    let turn = TorusSplineOptions { closed: true, winding: TorusWinding::Total([1, 0]), ..Default::default() };
    assert!(TorusSpline::through_places(&data::tori()[0], &[Point2::new(0.0, 0.0)], &turn).is_ok());
}

#[test]
fn knots_and_arcs() {
    let torus = &data::tori()[0];
    let knot = |turns| TorusSpline::knot(torus, turns, Point2::default()).unwrap_err().reason();
    assert_eq!([knot([0, 0]), knot([2, 0]), knot([-2, 4]), knot([i32::MIN, 0])][..3], ["not-coprime"; 3]);
    assert_eq!(knot([10_001, 1]), "parameter-out-of-range");
    let arc = |step| torus.arc(CircleFamily::Villarceau, Point2::default(), step).unwrap_err().reason();
    assert_eq!([arc(0.0), arc(4.0), arc(f64::NAN)], ["angle-out-of-range"; 3]);
    let circle = torus.circle(CircleFamily::Parallel, Point2::new(f64::NAN, 0.0));
    assert_eq!(circle.unwrap_err().reason(), "not-finite");
    assert_eq!(torus.locate(Point3::new(4.0, 0.0, 0.0), -1.0).unwrap_err().reason(), "tolerance-not-positive");
    assert_eq!(TorusClasses::new([[f64::NAN, 0.0]; 4]).unwrap_err().reason(), "not-finite");
}

fn wild_pair() -> impl Strategy<Value = [f64; 2]> {
    [wild(), wild()]
}

fn wild_rate() -> impl Strategy<Value = Vec2> {
    wild_pair().prop_map(|[x, y]| Vec2::new(x, y))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Numbers of every kind give a result or an error.
    #[test]
    fn wild_numbers_are_refused_or_taken(
        radii in wild_pair(), places in proptest::collection::vec(wild_pair(), 0..4), rates in proptest::collection::vec(wild_rate(), 4),
        knots in proptest::collection::vec(wild(), 0..5), closed: bool, turns: [i32; 2], loops: bool,
    ) {
        let torus = Torus::new(Frame::WORLD, radii[0], radii[1]).unwrap_or(data::tori()[0]);
        let places: Vec<Point2> = places.into_iter().map(Point2::from).collect();
        let tangents: Vec<TorusTangent> = rates.iter().take(places.len()).map(|r| TorusTangent::Rate(*r)).collect();
        let winding = TorusWinding::Total(turns.map(|t| t % 50));
        for (tangents, knots) in [(vec![], vec![]), (tangents, vec![]), (vec![], knots)] {
            let options = TorusSplineOptions { closed, tangents, knots, winding: winding.clone(), loops };
            if let Ok(spline) = TorusSpline::through_places(&torus, &places, &options) {
                prop_assert!(spline.pieces().len() >= 2);
                prop_assert!(spline.jet_at_knot(spline.knots()[0]).point.is_finite());
            }
        }
        let steps = rates[0];
        if let Ok(biarc) = ProjectiveBiarc::new(steps.x, steps.y, [rates[1].x, rates[1].y], [rates[2].x, rates[2].y]) {
            prop_assert!(biarc.offset(0.5).is_finite() && biarc.mid_slope().is_finite());
        }
        for first in QuarticType::ALL {
            for second in QuarticType::ALL {
                let start = Point2::default();
                if let Ok(all) = TwoTypeBiarc::all([first, second], start, rates[0], [rates[1], rates[2]], [0.5, 0.5]) {
                    prop_assert!(all.len() <= 2);
                }
            }
        }
        let _ = torus.locate(Point3::new(rates[0].x, rates[0].y, rates[1].x), rates[1].y);
        let _ = TorusSpline::two_type_loop(&torus, &places, &rates[..places.len()]);
    }
}
