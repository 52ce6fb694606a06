//! Flattening is proved: hulls are those of their curves, and no legal curve gets away from its polyline.

use super::{each, segment_distance};
use cyclide::{
    CurveJet, Point3, Result,
    construct::MoebiusSplineOptions,
    curve::{BlendVariant, CircleSpline, CircleSplineOptions, ParamCurve, PieceForm, PieceHull, QbSpline},
    mesh::flatten,
    rational::NurbsCurve,
};
use proptest::prelude::*;

/// Largest distance between the pieces and their hulls over what is promised.
fn beyond_its_hull(curve: &dyn ParamCurve, tolerance: f64) -> f64 {
    let mut worst = f64::NEG_INFINITY;
    for piece in (0..curve.piece_count()).filter(|i| matches!(curve.piece_form(*i), PieceForm::Free)) {
        let hull = curve.piece_hull(piece, tolerance).unwrap();
        for i in 0..=64 {
            let s = f64::from(i) / 64.0;
            let distance = hull.point(s).map_or(f64::INFINITY, |p| p.distance(curve.piece_point(piece, s)));
            worst = worst.max(distance - hull.bound().min(tolerance));
        }
    }
    worst
}

#[test]
fn hulls_are_those_of_their_pieces() {
    each(|case, curve| {
        for relative in [1e-2, 1e-6] {
            let beyond = beyond_its_hull(curve, relative * case.size);
            // Rows are sums of products of coordinates: a few roundings, times the parts they were cut into.
            assert!(beyond <= 64.0 * case.rounding, "{}: {beyond:e}", case.name);
        }
    });
}

/// A curve that claims the hull of another one.
#[derive(Debug)]
struct Liar(NurbsCurve, NurbsCurve);

impl ParamCurve for Liar {
    fn piece_count(&self) -> usize {
        1
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        self.0.piece_jet(piece, s)
    }
    fn piece_hull(&self, piece: usize, tolerance: f64) -> Result<PieceHull> {
        self.1.piece_hull(piece, tolerance)
    }
    fn is_closed(&self) -> bool {
        false
    }
}

/// One span of a rational Bezier curve.
fn bezier(points: &[[f64; 3]], weights: &[f64]) -> NurbsCurve {
    let degree = points.len() - 1;
    let knots = [vec![0.0; degree + 1], vec![1.0; degree + 1]].concat();
    NurbsCurve::new(degree, knots, points.iter().map(|p| Point3::from(*p)).collect(), weights.to_vec()).unwrap()
}

#[test]
fn the_law_of_hulls_can_fail() {
    let true_one = bezier(&[[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]], &[1.0; 3]);
    let flat = bezier(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], &[1.0; 3]);
    assert!(beyond_its_hull(&true_one, 0.01) < 1e-15);
    assert!(beyond_its_hull(&Liar(true_one.clone(), flat), 0.01) > 0.4);
    // A free piece without parts proves nothing, and nothing is taken on trust.
    #[derive(Debug)]
    struct Silent(NurbsCurve);
    impl ParamCurve for Silent {
        fn piece_count(&self) -> usize {
            1
        }
        fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
            self.0.piece_jet(piece, s)
        }
        fn piece_hull(&self, _piece: usize, _tolerance: f64) -> Result<PieceHull> {
            Ok(PieceHull::closed_form())
        }
        fn is_closed(&self) -> bool {
            false
        }
    }
    assert_eq!(flatten(&Silent(true_one), 0.01).unwrap_err().reason(), "not-within-tolerance");
}

/// The point of the Bezier curve of at most ten rows by de Casteljau on its own rows: independent of the kernel.
fn de_casteljau(points: &[[f64; 3]], weights: &[f64], t: f64) -> Point3 {
    let mut rows = [[0.0; 4]; 10];
    for (row, (p, w)) in rows.iter_mut().zip(points.iter().zip(weights)) {
        *row = [p[0] * w, p[1] * w, p[2] * w, *w];
    }
    for last in (1..points.len()).rev() {
        for i in 0..last {
            rows[i] = std::array::from_fn(|d| (1.0 - t) * rows[i][d] + t * rows[i + 1][d]);
        }
    }
    let [x, y, z, w] = rows[0];
    Point3::new(x / w, y / w, z / w)
}

/// Largest distance of dense points of each part from its chord.
fn largest_distance(vertices: &[(f64, Point3)], at: impl Fn(f64) -> Point3) -> f64 {
    let of_chord = |w: &[(f64, Point3)]| {
        let samples = (1..24).map(|j| at(w[0].0 + (w[1].0 - w[0].0) * f64::from(j) / 24.0));
        samples.map(|p| segment_distance(p, w[0].1, w[1].1)).fold(0.0, f64::max)
    };
    vertices.windows(2).map(of_chord).fold(0.0, f64::max)
}

#[test]
fn a_heavy_middle_is_not_missed() {
    // The curve runs to its middle point within a thousandth of its parameter and stays there: speeds at any few places
    // are next to nothing.
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 3.55, 0.0], [3.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
    std::thread::scope(|scope| {
        for weight in [1e2, 1e5, 1e8, 1e11] {
            scope.spawn(move || {
                let weights = [1.0, 1.0, weight, 1.0, 1.0];
                let curve = bezier(&points, &weights);
                for tolerance in [0.1, 0.01, 1e-4] {
                    let vertices = flatten(&curve, tolerance).unwrap();
                    let got = largest_distance(&vertices, |t| de_casteljau(&points, &weights, t));
                    assert!(got <= tolerance * (1.0 + 1e-9), "{weight:e} at {tolerance}: {got}");
                    assert!(vertices.iter().any(|(_, p)| p.y > 3.4));
                }
            });
        }
    });
}

/// A Möbius spline through points that turn back by half a turn but for a billionth: it swings far out, and bends most in a tiny part of an
/// interval between two samples of its density, which asked for 8e8 vertices.
#[test]
fn a_sharp_bend_does_not_flood_its_piece() {
    let points = [[0.0, 0.0, 0.0], [2.0, 0.02, 0.0], [0.0, -1e-9, -1e-9], [2.3, 1.6e-3, -1.6e-9]].map(Point3::from);
    let spline = QbSpline::through_points(&points, &MoebiusSplineOptions::default()).unwrap();
    let size = cyclide::curve::bounds(&spline).diagonal();
    for relative in [1e-3, 1e-5, 1e-7] {
        let vertices = flatten(&spline, relative * size).unwrap();
        // What even chords of a circle of that size would be, for two swings, and what the sharp bends take besides.
        let circle = std::f64::consts::PI / (2.0 * relative).sqrt();
        assert!((vertices.len() as f64) < 3.0 * circle + 200.0, "{relative:e}: {}", vertices.len());
        for (t, p) in (0..=4000).map(|k| f64::from(k) / 4000.0).map(|t| (t, spline.point(t))) {
            let after = vertices.partition_point(|(at, _)| *at <= t).clamp(1, vertices.len() - 1);
            let distance = segment_distance(p, vertices[after - 1].1, vertices[after].1);
            assert!(distance <= relative * size * (1.0 + 1e-9), "{relative:e} at {t}: {distance:e}");
        }
    }
}

#[test]
fn tolerances_below_the_rounding_of_the_numbers_are_refused() {
    let far = bezier(&[[1e9, 0.0, 0.0], [1e9 + 1.0, 1.0, 0.0], [1e9 + 2.0, 0.0, 0.0]], &[1.0, 2.0, 1.0]);
    assert_eq!(flatten(&far, 1e-9).unwrap_err().reason(), "not-within-tolerance");
    assert!(flatten(&far, 1e-5).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(96) })]

    #[test]
    fn wild_rational_curves_stay_within_the_tolerance(
        rows in prop::collection::vec((prop::array::uniform3(-1.0..1.0_f64), -3.0..3.0_f64), 2..10),
        exponent in -9.0..-1.0_f64,
    ) {
        let tolerance = 10.0_f64.powf(exponent);
        let points: Vec<[f64; 3]> = rows.iter().map(|r| r.0).collect();
        let weights: Vec<f64> = rows.iter().map(|r| 10.0_f64.powf(r.1)).collect();
        let vertices = flatten(&bezier(&points, &weights), tolerance).unwrap();
        let got = largest_distance(&vertices, |t| de_casteljau(&points, &weights, t));
        // Coordinates of size 1, weights that differ by 1e6: the vertices themselves are rounded to 1e-14.
        prop_assert!(got <= tolerance + 1e-13, "{} vertices: {got:e} > {tolerance:e}", vertices.len());
    }

    #[test]
    fn wild_splines_stay_within_the_tolerance(
        points in prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), 3..9),
        order in 1_u32..=4, trigonometric: bool, closed: bool, exponent in -7.0..-1.0_f64,
    ) {
        let tolerance = 10.0_f64.powf(exponent);
        let variant = if trigonometric { BlendVariant::Trigonometric } else { BlendVariant::Rational };
        let points: Vec<Point3> = points.into_iter().map(Point3::from).collect();
        let options = CircleSplineOptions { order, variant, closed, ..Default::default() };
        let Ok(spline) = CircleSpline::from_points(&points, &options) else { return Ok(()) };
        // Circles next to infinity ask for more pieces than the cap: a named refusal.
        match flatten(&spline, tolerance) {
            Ok(vertices) => {
                let size = cyclide::curve::bounds(&spline).max_abs();
                let got = largest_distance(&vertices, |t| spline.point(t));
                prop_assert!(got <= tolerance + 1e-12 * size, "{got:e} > {tolerance:e}");
            }
            Err(error) => prop_assert!(
                ["too-many-pieces", "not-within-tolerance"].contains(&error.reason()), "{}", error
            ),
        }
    }
}
