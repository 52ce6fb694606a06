//! How evenly curves bend: counts and variation against closed forms and against the figures of
//! `docs/math/fair-splines.md#figures`.

#![allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]

use cyclide::{
    CurveJet, Point3, Vec3,
    construct::{ArcSplineOptions, FairSplineOptions},
    curve::{Arc, ArcPath, Circle, CircleSpline, CircleSplineOptions, Fairness, ParamCurve, fairness, wavering},
};
use std::f64::consts::TAU;

/// An ellipse in a tilted plane: its curvature is `ab/(a² sin² + b² cos²)^(3/2)`.
#[derive(Debug)]
struct Ellipse {
    a: f64,
    b: f64,
    axes: [Vec3; 2],
    pieces: usize,
}

impl ParamCurve for Ellipse {
    /// It is never flattened: nothing is claimed.
    fn piece_hull(&self, _piece: usize, _tolerance: f64) -> cyclide::Result<cyclide::curve::PieceHull> {
        Ok(cyclide::curve::PieceHull::closed_form())
    }
    fn piece_count(&self) -> usize {
        self.pieces
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        let step = TAU / self.pieces as f64;
        let (sin, cos) = (step * (piece as f64 + s)).sin_cos();
        let [x, y] = [self.axes[0] * self.a, self.axes[1] * self.b];
        let jet = CurveJet {
            point: Point3::ORIGIN + x * cos + y * sin,
            d1: y * cos - x * sin,
            d2: -(x * cos) - y * sin,
            d3: x * sin - y * cos,
        };
        jet.scaled(step)
    }
    fn is_closed(&self) -> bool {
        true
    }
}

/// A sine wave over some periods.
#[derive(Debug)]
struct Wave {
    height: f64,
    periods: f64,
}

impl ParamCurve for Wave {
    /// It is never flattened: nothing is claimed.
    fn piece_hull(&self, _piece: usize, _tolerance: f64) -> cyclide::Result<cyclide::curve::PieceHull> {
        Ok(cyclide::curve::PieceHull::closed_form())
    }
    fn piece_count(&self) -> usize {
        1
    }
    fn piece_jet(&self, _: usize, s: f64) -> CurveJet {
        let w = TAU * self.periods;
        let (sin, cos) = (w * s).sin_cos();
        let h = self.height;
        CurveJet {
            point: Point3::new(w * s, h * sin, 0.0),
            d1: Vec3::new(w, h * w * cos, 0.0),
            d2: Vec3::new(0.0, -h * w * w * sin, 0.0),
            d3: Vec3::new(0.0, -h * w * w * w * cos, 0.0),
        }
    }
    fn is_closed(&self) -> bool {
        false
    }
}

fn track() -> Vec<Point3> {
    points(include_str!("../../../examples/track.csv"))
}

fn points(text: &str) -> Vec<Point3> {
    let row = |line: &str| {
        let mut fields = line.split(',').map(|f| f.trim().parse::<f64>());
        Some(Point3::new(fields.next()?.ok()?, fields.next()?.ok()?, 0.0))
    };
    text.lines().filter_map(row).collect()
}

fn spline(points: &[Point3], closed: bool) -> CircleSpline {
    CircleSpline::from_points(points, &CircleSplineOptions { closed, ..Default::default() }).unwrap()
}

fn close(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a} {b}");
}

/// `∫ k'² ds` and the length of an ellipse by the trapezoidal rule, which is exact to rounding for periodic functions;
/// with `g = a² sin² + b² cos²` is `k = ab g^(-3/2)` and `dk/dt = -3 ab (a²-b²) sin cos g^(-5/2)`.
fn ellipse_variation(a: f64, b: f64) -> f64 {
    let n = 20_000;
    let (mut sum, mut length) = (0.0, 0.0);
    for i in 0..n {
        let (sin, cos) = (TAU * f64::from(i) / f64::from(n)).sin_cos();
        let g = a * a * sin * sin + b * b * cos * cos;
        let slope = -3.0 * a * b * (a * a - b * b) * sin * cos * g.powf(-2.5);
        sum += slope * slope / g.sqrt();
        length += g.sqrt();
    }
    let step = TAU / f64::from(n);
    (sum * step) * (length * step).powi(3)
}

#[test]
fn an_ellipse_has_four_extrema_and_its_variation() {
    let x = Vec3::new(2.0, 1.0, 2.0).unit().unwrap();
    let axes = [x, x.any_perpendicular()];
    for (a, b, pieces) in
        [(2.0, 1.0, 1), (2.0, 1.0, 7), (30.0, 1.0, 3), (1.0001, 1.0, 5), (2e100, 1e100, 4), (2e-90, 1e-90, 4)]
    {
        let f = fairness(&Ellipse { a, b, axes, pieces });
        assert_eq!((f.sign_changes, f.extrema, f.jumps, f.corners), (Some(0), 4, 0, 0), "{a} {b}");
        // The rule stops at a disagreement of 1e-4 of the whole.
        let unit = b.max(1e-300);
        close(f.variation.unwrap(), ellipse_variation(a / unit, b / unit), 2e-4);
        // Four times from b/a² to a/b².
        close(f.total_variation, 4.0 * (a / b / b - b / a / a), 1e-3);
    }
}

#[test]
fn a_wave_changes_sides_at_its_inflections() {
    for height in [1e-3, 1.0, 40.0] {
        let f = fairness(&Wave { height, periods: 5.0 });
        // Inflections at the zeros inside, the largest bends at the ten crests.
        assert_eq!((f.sign_changes, f.extrema), (Some(9), 10), "height {height}");
        // Crests are those of cubics that miss the samples between by less than 2 %, and them by a sixteenth of it.
        close(f.total_variation, 20.0 * height, 2e-3);
    }
}

#[test]
fn lines_circles_and_arcs_of_one_circle_do_not_swing() {
    let nothing = |f: Fairness, what: &str| {
        assert_eq!((f.sign_changes, f.extrema, f.variation, f.jumps), (Some(0), 0, Some(0.0), 0), "{what}: {f:?}");
    };
    let axis = Vec3::new(1.0, -2.0, 0.5);
    nothing(fairness(&Circle::from_radius(Point3::new(3.0, 1e6, -2.0), axis, 0.3).unwrap()), "circle");
    let on_circle = |n: usize, r: f64, at: Point3| -> Vec<Point3> {
        let x = axis.any_perpendicular();
        let y = axis.cross(x).unit().unwrap();
        // Uneven steps.
        let angle = |i: usize| TAU * (i as f64 + 0.3 * (i as f64).sin()) / n as f64;
        (0..n).map(|i| at + x * (r * angle(i).cos()) + y * (r * angle(i).sin())).collect()
    };
    for n in [3, 5, 100, 3000] {
        for (r, at) in [
            (1.0, Point3::ORIGIN),
            (1e-6, Point3::ORIGIN),
            (1.0, Point3::new(1e6, -3e5, 2e6)),
            (50.0, Point3::new(1e3, 0.0, 0.0)),
        ] {
            nothing(fairness(&spline(&on_circle(n, r, at), true)), &format!("{n} points, radius {r}, at {at:?}"));
        }
    }
    let line: Vec<Point3> =
        (0..50).map(|i| Point3::new(1e4, 7.0, 0.0) + axis * (f64::from(i) + 0.4 * f64::from(i).cos())).collect();
    nothing(fairness(&spline(&line, false)), "line");
    let arcs =
        ArcPath::spline(&on_circle(12, 2.0, Point3::ORIGIN), &ArcSplineOptions { closed: true, ..Default::default() });
    nothing(fairness(&arcs.unwrap()), "arcs of one circle");
}

#[test]
fn jumps_of_arcs_have_no_variation_and_corners_cut() {
    let arc =
        |from: [f64; 3], to: [f64; 3], bulge: f64| Arc::from_bulge(from.into(), to.into(), Vec3::Z, bulge).unwrap();
    // Half circles of radius 1, 2 to the left, then 1 to the right, then straight on: curvatures 1, 1/2, -1, 0.
    let path = ArcPath::new(
        vec![
            arc([0.0; 3], [2.0, 0.0, 0.0], 1.0),
            arc([2.0, 0.0, 0.0], [-2.0, 0.0, 0.0], 1.0),
            arc([-2.0, 0.0, 0.0], [-4.0, 0.0, 0.0], -1.0),
            arc([-4.0, 0.0, 0.0], [-4.0, 9.0, 0.0], 0.0),
        ],
        false,
    )
    .unwrap();
    let f = fairness(&path);
    assert_eq!((f.sign_changes, f.extrema, f.variation, f.jumps), (Some(1), 1, None, 3));
    close(f.total_variation, 0.5 + 1.5 + 1.0, 1e-14);
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
    let options = CircleSplineOptions { closed: true, corners: vec![0, 1, 2, 3], ..Default::default() };
    let f = fairness(&CircleSpline::from_points(&square, &options).unwrap());
    assert_eq!((f.sign_changes, f.extrema, f.variation, f.corners), (Some(0), 0, Some(0.0), 4));
}

/// `docs/math/fair-splines.md#figures`, the row "order 2, rational" of the track.
#[test]
fn the_track_has_the_figures_of_the_paper() {
    let curve = spline(&track(), true);
    let f = fairness(&curve);
    assert_eq!((f.sign_changes, f.extrema, f.jumps), (Some(38), 98, 0));
    close(f.variation.unwrap(), 1.35e7, 0.005);
    close(f.total_variation, 1.57, 0.005);
    // As fair turned round, larger, and elsewhere.
    let moved: Vec<Point3> = track().iter().rev().map(|p| Point3::new(3.0 * p.x - 1e5, 3.0 * p.y, 7.0)).collect();
    let g = fairness(&spline(&moved, true));
    assert_eq!((g.sign_changes, g.extrema), (Some(38), 98));
    close(g.variation.unwrap(), f.variation.unwrap(), 1e-6);
}

/// The row "fair (e = 1)" of the same table; and it does not waver against its points.
#[test]
fn the_fair_spline_has_its_figures_and_does_not_waver() {
    let curve = CircleSpline::fair(&track(), &FairSplineOptions { closed: true, ..Default::default() }).unwrap();
    let f = fairness(&curve);
    assert_eq!((f.sign_changes, f.extrema, f.jumps), (Some(8), 16, 0));
    close(f.variation.unwrap(), 5.39e5, 0.005);
    close(f.total_variation, 0.352, 0.005);
    let w = wavering(&curve);
    assert!(!w.curve_wavers && !w.data_waver && (w.curve, w.data) == (8, 8), "{w:?}");
}

#[test]
fn curves_in_space_have_no_sides() {
    let helix: Vec<Point3> =
        (0..40).map(|i| f64::from(i) * 0.3).map(|a| Point3::new(a.cos(), a.sin(), 0.2 * a)).collect();
    let f = fairness(&spline(&helix, false));
    assert_eq!((f.sign_changes, f.jumps), (None, 0));
    assert!(f.variation.unwrap() > 0.0);
}

#[test]
fn a_curve_that_wavers_is_told_from_data_that_waver() {
    let told = |points: &[Point3], closed: bool| {
        let curve = spline(points, closed);
        let w = wavering(&curve);
        (w.curve_wavers, w.data_waver, w)
    };
    let (curve, data, w) = told(&track(), true);
    // Of its 38 changes of sign those by bends too small to see are left out.
    assert!(curve && !data && w.curve > 20 && w.curve < 38 && w.data == 8, "{w:?}");
    // On a slim ellipse the blends of three-point circles bend to the other side, on a broad one they do not.
    let ellipse = |a: f64| -> Vec<Point3> {
        (0..24).map(|i| f64::from(i) / 24.0 * TAU).map(|t| Point3::new(a * t.cos(), t.sin(), 0.0)).collect()
    };
    let (curve, data, w) = told(&ellipse(3.0), true);
    assert!(curve && !data && w.data == 0 && w.curve >= 4, "{w:?}");
    // An L of unit steps.
    let wave: Vec<Point3> = (0..60).map(|i| f64::from(i) * 0.25).map(|x| Point3::new(x, x.sin(), 0.0)).collect();
    let l: Vec<Point3> =
        (0..12).map(|i| if i < 6 { [f64::from(i), 0.0, 0.0] } else { [5.0, f64::from(i - 5), 0.0] }.into()).collect();
    for (points, closed) in [(ellipse(1.2), true), (l, false)] {
        let (curve, data, w) = told(&points, closed);
        assert!(!curve && !data, "{w:?}");
    }
    // The wave with an error of alternating sign, a tenth of a step.
    let noisy: Vec<Point3> = wave
        .iter()
        .enumerate()
        .map(|(i, p)| Point3::new(p.x, p.y + if i % 2 == 0 { 0.03 } else { -0.03 }, 0.0))
        .collect();
    let (_, data, w) = told(&noisy, false);
    assert!(data, "{w:?}");
}

#[test]
fn a_node_on_an_inflection_is_no_straight_run() {
    // Every seventh node of a wave is on the line between its halves: it explains no swing of the curve.
    let wave: Vec<Point3> = (0..27).map(|i| f64::from(i) * TAU / 12.0).map(|x| Point3::new(x, x.sin(), 0.0)).collect();
    let curve = spline(&wave, false);
    let w = wavering(&curve);
    assert!(w.curve_wavers && w.explained == w.data && w.data == 4 && w.curve > 12, "{w:?}");
    let curve = CircleSpline::fair(&wave, &FairSplineOptions::default()).unwrap();
    let w = wavering(&curve);
    assert!(!w.curve_wavers, "{w:?}");
}

#[test]
fn curves_in_space_waver_too() {
    // The track over hills, and a knot that turns over nowhere.
    let hills = |p: &Point3| Point3::new(p.x, p.y, 0.05 * p.x + 20.0 * (p.y / 150.0).sin());
    let track: Vec<Point3> = track().iter().map(hills).collect();
    let knot: Vec<Point3> = (0..30)
        .map(|i| f64::from(i) * TAU / 30.0)
        .map(|t| Point3::new(t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin()))
        .collect();
    for (points, plain_wavers) in [(&track, true), (&knot, false)] {
        let plain = spline(points, true);
        let w = wavering(&plain);
        assert_eq!(w.curve_wavers, plain_wavers, "{w:?}");
        let fair = CircleSpline::fair(points, &FairSplineOptions { closed: true, ..Default::default() }).unwrap();
        let measured = fairness(&fair);
        let w = wavering(&fair);
        assert!(measured.sign_changes.is_none() && !w.curve_wavers && w.curve <= w.data + 1, "{w:?}");
    }
    // A helix winds its axis slowly; straight on and back to the right, a line in space has none.
    let helix: Vec<Point3> =
        (0..40).map(|i| f64::from(i) * 0.3).map(|a| Point3::new(a.cos(), a.sin(), 0.2 * a)).collect();
    let curve = spline(&helix, false);
    let w = wavering(&curve);
    assert_eq!((w.curve, w.data, w.data_waver), (0, 0, false));
}

#[test]
fn corners_that_were_not_marked_are_named() {
    let side = |from: [f64; 2], to: [f64; 2], n: usize| {
        (0..n).map(move |k| {
            let t = k as f64 / n as f64;
            Point3::new(from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t, 0.0)
        })
    };
    let points: Vec<Point3> = side([0.0, 0.0], [100.0, 0.0], 50)
        .chain(side([100.0, 0.0], [100.0, 60.0], 30))
        .chain(side([100.0, 60.0], [0.0, 60.0], 50))
        .chain(side([0.0, 60.0], [0.0, 0.0], 30))
        .collect();
    let rounded = |options: &FairSplineOptions| {
        let curve = CircleSpline::fair(&points, options).unwrap();
        wavering(&curve).rounded
    };
    let closed = FairSplineOptions { closed: true, ..Default::default() };
    let found = rounded(&closed).unwrap();
    assert_eq!((found.count, found.first), (4, 0));
    assert!((found.angle - TAU / 4.0).abs() < 1e-12 && found.distance > 0.2 && found.distance < 0.4, "{found:?}");
    assert_eq!(rounded(&FairSplineOptions { corners: vec![0, 50, 80, 130], ..closed }), None);
    // A wave has none.
    let wave: Vec<Point3> = (0..60).map(|i| f64::from(i) * 0.25).map(|x| Point3::new(x, x.sin(), 0.0)).collect();
    let curve = spline(&wave, false);
    assert_eq!(wavering(&curve).rounded, None);
}

#[test]
fn stairs_are_no_noise() {
    // Two chords to a tread: every other node is straight on, and the turns are right angles to both sides in turn.
    let mut points = vec![Point3::ORIGIN];
    let mut at = points[0];
    for k in 0..48 {
        at += if (k / 2) % 2 == 0 { Vec3::X * 0.15 } else { Vec3::Y * 0.09 };
        points.push(at);
    }
    for tight in [None, Some(0.2), Some(0.45)] {
        let curve = CircleSpline::fair(&points, &FairSplineOptions { tight, ..Default::default() }).unwrap();
        let w = wavering(&curve);
        assert!(!w.data_waver && !w.curve_wavers && w.data == 22 && w.nodes >= 47, "{tight:?}: {w:?}");
    }
}

/// Lines and arcs: what a fair spline through samples of them rings is what any curve without a jump of curvature does, and a
/// smaller wave than shows is none.
#[test]
fn what_counts_is_the_amplitude() {
    // Two straight runs of 100 and half circles of radius 20 between them.
    let (straight, radius) = (100.0, 20.0);
    let (half, total) = (TAU / 2.0 * radius, 2.0 * (straight + TAU / 2.0 * radius));
    let at = |s: f64| {
        let (side, s) = if s < straight + half { (1.0, s) } else { (-1.0, s - straight - half) };
        let angle = (s - straight).max(0.0) / radius;
        Point3::new(side * (s.min(straight) + radius * angle.sin() - 0.5 * straight), -side * radius * angle.cos(), 0.0)
    };
    for count in (30..130).chain([400, 1000]) {
        let points: Vec<Point3> = (0..count).map(|i| at(total * f64::from(i) / f64::from(count))).collect();
        let curve = CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() }).unwrap();
        let w = wavering(&curve);
        assert!(!w.curve_wavers && !w.data_waver, "{count}: {w:?}");
    }
    // Every other point beside a line, by so much of the step that the line turns by four times that.
    for (off, is_said) in [(1e-6, false), (1e-4, false), (1e-3, true), (0.1, true)] {
        let points: Vec<Point3> =
            (0..40).map(|i| Point3::new(f64::from(i), if i % 2 == 0 { off } else { 0.0 }, 0.0)).collect();
        for curve in [spline(&points, false), CircleSpline::fair(&points, &FairSplineOptions::default()).unwrap()] {
            let w = wavering(&curve);
            assert_eq!(w.curve_wavers || w.data_waver, is_said, "{off}: {w:?}");
        }
    }
}
