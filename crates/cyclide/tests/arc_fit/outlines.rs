//! Outlines whose points are corners, and samples of smooth curves (`docs/math/arc-fitting.md#outlines`): distances are
//! measured here, both ways, and counts come from how the outlines were made.

use super::*;
use cyclide::warning::FitWarning;

const TOLERANCE: f64 = 0.02;

/// Points of a closed outline, and the lines and arcs it was made of.
struct Made {
    name: &'static str,
    points: Vec<[f64; 2]>,
    lines: usize,
    arcs: usize,
}

/// Uniform in `[low, high)`.
fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * (random.next() + 0.5)
}

fn whole(random: &mut Random, low: usize, high: usize) -> usize {
    between(random, low as f64, high as f64) as usize
}

/// The points of an arc, both ends included, with chords whose sagitta is at most half the tolerance.
fn round(center: [f64; 2], radius: f64, from: f64, turn: f64) -> Vec<[f64; 2]> {
    let step = (8.0 * 0.5 * TOLERANCE / radius).sqrt().min(0.4);
    chords(center, radius, from, turn, (turn.abs() / step).ceil().max(4.0) as usize)
}

/// The points of an arc with so many chords.
fn chords(center: [f64; 2], radius: f64, from: f64, turn: f64, n: usize) -> Vec<[f64; 2]> {
    let at = |k: usize| {
        let (s, c) = (from + turn * k as f64 / n as f64).sin_cos();
        [center[0] + radius * c, center[1] + radius * s]
    };
    (0..=n).map(at).collect()
}

fn polygon(name: &'static str, points: Vec<[f64; 2]>) -> Made {
    Made { name, lines: points.len(), arcs: 0, points }
}

fn star(spikes: usize, inner: f64) -> Vec<[f64; 2]> {
    let at = |i: usize| {
        let (s, c) = (PI * i as f64 / spikes as f64).sin_cos();
        let r = if i.is_multiple_of(2) { 40.0 } else { inner };
        [r * c, r * s]
    };
    (0..2 * spikes).map(at).collect()
}

fn comb(random: &mut Random) -> Vec<[f64; 2]> {
    let mut points = vec![[0.0, 0.0]];
    let mut x = 0.0;
    let teeth = whole(random, 2, 8);
    for tooth in 0..teeth {
        let (width, gap, height) = (between(random, 2.0, 8.0), between(random, 2.0, 8.0), between(random, 8.0, 20.0));
        points.extend([[x, height], [x + width, height], [x + width, 4.0], [x + width + gap, 4.0]]);
        x += width + gap;
        if tooth + 1 == teeth {
            points.truncate(points.len() - 2);
            points.push([x - gap, 0.0]);
        }
    }
    points
}

fn rounded_rectangle(random: &mut Random) -> Made {
    let radius = between(random, 2.0, 8.0);
    let (w, h) = (between(random, 30.0, 60.0), between(random, 30.0, 60.0));
    let corners = [[w, -h], [w, h], [-w, h], [-w, -h]];
    let points = (0..4).flat_map(|k| round(corners[k], radius, FRAC_PI_2 * (k as f64 - 1.0), FRAC_PI_2)).collect();
    Made { name: "rounded rectangle", points, lines: 4, arcs: 4 }
}

fn slot(random: &mut Random) -> Made {
    let (radius, half) = (between(random, 2.0, 8.0), between(random, 8.0, 30.0));
    let mut points = round([half, 0.0], radius, -FRAC_PI_2, PI);
    points.extend(round([-half, 0.0], radius, FRAC_PI_2, PI));
    Made { name: "slot", points, lines: 2, arcs: 2 }
}

fn keyhole(random: &mut Random) -> Made {
    let (radius, half) = (between(random, 6.0, 12.0), between(random, 1.5, 3.0));
    let open = (half / radius).asin();
    let mut points = round([0.0, 0.0], radius, open - FRAC_PI_2, TAU - 2.0 * open);
    points.extend([[-half, -30.0], [half, -30.0]]);
    Made { name: "keyhole", points, lines: 3, arcs: 1 }
}

fn made(random: &mut Random) -> Made {
    match whole(random, 0, 9) {
        0 => polygon("rectangle", vec![[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [0.0, 40.0]]),
        1 => {
            let (a, b) = (between(random, 15.0, 40.0), between(random, 3.0, 12.0));
            let arm = [[a, -b], [a, b], [b, b]];
            let turned = |k: usize| arm.map(|[x, y]| [[x, y], [-y, x], [-x, -y], [y, -x]][k]);
            polygon("plus", (0..4).flat_map(turned).collect())
        }
        2 => polygon("comb", comb(random)),
        3 => {
            let (spikes, inner) = (whole(random, 4, 12), between(random, 12.0, 24.0));
            polygon("star", star(spikes, inner))
        }
        4 => {
            let sides = whole(random, 3, 12);
            polygon("regular polygon", star(sides, 40.0).into_iter().step_by(2).collect())
        }
        5 => rounded_rectangle(random),
        6 => slot(random),
        7 => keyhole(random),
        _ => polygon(
            "U",
            vec![
                [0.0, 0.0],
                [60.0, 0.0],
                [60.0, 40.0],
                [40.0, 40.0],
                [40.0, 20.0],
                [20.0, 20.0],
                [20.0, 40.0],
                [0.0, 40.0],
            ],
        ),
    }
}

/// Turned, moved, begun elsewhere, and perhaps the other way round.
fn placed(points: &[[f64; 2]], random: &mut Random) -> Vec<Point3> {
    let (s, c) = (TAU * random.next()).sin_cos();
    let (dx, dy) = (300.0 * random.next(), 300.0 * random.next());
    let mut placed: Vec<_> =
        points.iter().map(|[x, y]| Point3::new(c * x - s * y + dx, s * x + c * y + dy, 0.0)).collect();
    placed.rotate_left(whole(random, 0, points.len()));
    if random.next() < 0.0 {
        placed.reverse();
    }
    placed
}

/// Largest distance between the path and a closed polygon, both ways, by sampling.
fn both_ways(path: &cyclide::curve::ArcPath, points: &[Point3]) -> f64 {
    let n = points.len();
    let arcs = path.arcs().iter();
    let of_path = arcs
        .flat_map(|arc| (0..=24).map(|i| arc.point_at_length(f64::from(i) / 24.0)))
        .map(|p| to_polyline(p, points, true))
        .fold(0.0, f64::max);
    let of_polygon = (0..n)
        .flat_map(|i| (0..8).map(move |k| points[i].lerp(points[(i + 1) % n], f64::from(k) / 8.0)))
        .map(|p| path.closest_point(p).distance)
        .fold(0.0, f64::max);
    of_path.max(of_polygon)
}

#[test]
fn outlines_are_kept_both_ways() {
    let mut random = Random(37);
    for member in 0..100 {
        let Made { name, points, lines, arcs } = made(&mut random);
        let points = placed(&points, &mut random);
        let fit = ArcFit::new(&points, &closed(TOLERANCE));
        assert!(fit.is_ok(), "{member}, {name}: {fit:?}");
        let Ok(fit) = fit else { return };
        let distance = both_ways(fit.path(), &points);
        // Coordinates of a few hundred, and sums of a few.
        assert!(distance <= TOLERANCE + 1e-12, "{member}, {name}: {distance}");
        let certificate = fit.certificate();
        assert_eq!((certificate.lines, certificate.arcs), (lines, arcs), "{member}, {name} of {}", points.len());
        let said = fit.warnings().iter().filter(|w| w.reason() == "corner-kept").count();
        assert!(said <= 1, "{member}, {name}: {said} lines about corners");
    }
}

/// A rectangle with chamfers.
fn chamfered(random: &mut Random) -> Vec<[f64; 2]> {
    let (w, h, c) = (between(random, 30.0, 80.0), between(random, 25.0, 50.0), between(random, 2.0, 10.0));
    vec![[c, 0.0], [w - c, 0.0], [w, c], [w, h - c], [w - c, h], [c, h], [0.0, h - c], [0.0, c]]
}

/// Points on every side of a polygon, its corners among them, about a step apart.
fn divided(polygon: &[[f64; 2]], step: f64) -> Vec<[f64; 2]> {
    let side = |k: usize| {
        let (a, b) = (polygon[k], polygon[(k + 1) % polygon.len()]);
        let count = ((b[0] - a[0]).hypot(b[1] - a[1]) / step).round().max(1.0) as usize;
        (0..count).map(move |i| [0, 1].map(|d| a[d] + (b[d] - a[d]) * i as f64 / count as f64))
    };
    (0..polygon.len()).flat_map(side).collect()
}

#[test]
fn turned_outlines_to_hundredths_are_kept_both_ways() {
    let mut random = Random(63);
    let mut kept = 0;
    let hundredths = |p: Point3| Point3::new((100.0 * p.x).round() / 100.0, (100.0 * p.y).round() / 100.0, 0.0);
    for member in 0..100 {
        let figure = match member % 4 {
            0 => chamfered(&mut random),
            1 => comb(&mut random),
            2 => {
                let (spikes, inner) = (whole(&mut random, 4, 10), between(&mut random, 16.0, 24.0));
                star(spikes, inner)
            }
            _ => vec![[0.0, 0.0], [60.0, 0.0], [60.0, 12.0], [12.0, 12.0], [12.0, 40.0], [0.0, 40.0]],
        };
        // Every other one is walked in even steps, which cut its corners; where these are obtuse, a curve explains that.
        let step = between(&mut random, 1.0, 3.0);
        let samples = if member % 8 <= 4 { divided(&figure, step) } else { resampled(&figure, step) };
        let points: Vec<Point3> = placed(&samples, &mut random).into_iter().map(hundredths).collect();
        let fit = fitted(&points, &closed(TOLERANCE));
        let distance = both_ways(fit.path(), &points);
        // Edges of samples may be left by an arc that is within the tolerance of its points.
        if distance <= 2.0 * TOLERANCE {
            kept += 1;
            continue;
        }
        let is_said = fit.warnings().iter().any(|w| matches!(w.reason(), "read-as-curve" | "swings-out"));
        assert!(is_said, "{member}, step {step}: {distance}; {:?}", fit.warnings());
    }
    // The others are narrow teeth with one or two points to a side.
    assert!(kept >= 95, "{kept} of 100");
}

#[test]
fn coarse_bends_are_the_arcs_of_their_points() {
    // Chords with sagittas of up to eight tolerances: the points are kept, and each bend is one arc.
    let mut random = Random(38);
    for member in 0..60 {
        let (radius, n) = (between(&mut random, 2.0, 14.0), whole(&mut random, 7, 20));
        let (w, h) = (between(&mut random, 20.0, 60.0), between(&mut random, 20.0, 60.0));
        let half = n / 2 + 3;
        let (points, lines, arcs) = if member % 2 == 0 {
            let ends = [[w, 0.0], [-w, 0.0]].into_iter().zip([-FRAC_PI_2, FRAC_PI_2]);
            (ends.flat_map(|(center, from)| chords(center, radius, from, PI, n)).collect::<Vec<_>>(), 2, 2)
        } else {
            let corners = [[w, -h], [w, h], [-w, h], [-w, -h]].into_iter().zip([-1.0, 0.0, 1.0, 2.0]);
            let bends = corners.flat_map(|(center, k)| chords(center, radius, FRAC_PI_2 * k, FRAC_PI_2, half));
            (bends.collect(), 4, 4)
        };
        let points = placed(&points, &mut random);
        let certificate = *fitted(&points, &closed(TOLERANCE)).certificate();
        assert_eq!((certificate.lines, certificate.arcs), (lines, arcs), "{member}: radius {radius}, {n}");
        assert!(certificate.vertex_deviation <= TOLERANCE);
    }
}

#[test]
fn gears_whose_flanks_lean_are_polygons() {
    let mut random = Random(39);
    for _ in 0..30 {
        let (teeth, height) = (whole(&mut random, 8, 40), between(&mut random, 1.0, 4.0));
        let radius = between(&mut random, 20.0, 60.0);
        let at = |k: usize| {
            let (tooth, part) = (k / 4, k % 4);
            let (s, c) = (TAU * (tooth as f64 + [0.0, 0.4, 0.5, 0.9][part]) / teeth as f64).sin_cos();
            let r = if part < 2 { radius } else { radius + height };
            [r * c, r * s]
        };
        let points = placed(&(0..4 * teeth).map(at).collect::<Vec<_>>(), &mut random);
        let certificate = *fitted(&points, &closed(TOLERANCE)).certificate();
        assert_eq!((certificate.lines, certificate.arcs), (points.len(), 0), "{teeth} teeth of {height} on {radius}");
    }
}

#[test]
fn polygons_with_random_vertices_are_kept_or_the_doubt_is_said() {
    let mut random = Random(52);
    let mut kept = 0;
    for _ in 0..100 {
        let n = whole(&mut random, 5, 40);
        let spread = between(&mut random, 0.1, 0.8);
        let at = |i: usize, a: f64, r: f64| {
            let (s, c) = (TAU * (i as f64 + 0.6 * a) / n as f64).sin_cos();
            let r = 60.0 * (1.0 - spread * (r + 0.5));
            [r * c, r * s]
        };
        let vertices: Vec<[f64; 2]> = (0..n).map(|i| at(i, random.next(), random.next())).collect();
        let points = placed(&vertices, &mut random);
        let fit = fitted(&points, &closed(TOLERANCE));
        let off = both_ways(fit.path(), &points);
        if off <= 1.05 * TOLERANCE {
            kept += 1;
            continue;
        }
        let said = |w: &Warning| matches!(w.reason(), "read-as-curve" | "swings-out");
        assert!(off < 4.0 * TOLERANCE || fit.warnings().iter().any(said), "{n} points, {off}");
    }
    // The others have few points in nearly even turns, which a curve explains as well.
    assert!(kept >= 70, "{kept} of 100");
}

/// The points of a closed curve that Douglas and Peucker keep within a distance.
fn simplified(points: &[Point3], within: f64) -> Vec<Point3> {
    let half = points.len() / 2;
    let mut kept = vec![false; points.len()];
    let mut ranges = vec![(0, half), (half, points.len())];
    let at = |i: usize| points[i % points.len()];
    while let Some((from, to)) = ranges.pop() {
        kept[from] = true;
        let off = |i: usize| to_polyline(at(i), &[at(from), at(to)], false);
        let farthest = (from + 1..to).max_by(|a, b| off(*a).total_cmp(&off(*b)));
        if let Some(i) = farthest.filter(|i| off(*i) > within) {
            ranges.extend([(from, i), (i, to)]);
        }
    }
    points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(p, _)| *p).collect()
}

#[test]
fn simplified_curves_stay_smooth() {
    let mut random = Random(88);
    for k in 0..40 {
        let curve = wave(&mut random);
        let flat = between(&mut random, 0.4, 1.0);
        let at = |i: u32| {
            let p = curve(TAU * f64::from(i) / 1000.0);
            Point3::new(p.x, flat * p.y, 0.0)
        };
        let within = between(&mut random, 0.05, 0.8);
        let points = simplified(&(0..1000).map(at).collect::<Vec<_>>(), within);
        for tolerance in [0.1 * within, within] {
            let fit = fitted(&points, &closed(tolerance));
            let corners = fit.warnings().iter().any(|w| w.reason() == "corner-kept");
            assert!(!corners, "{k}: {} points within {within}, {tolerance}: {:?}", points.len(), fit.warnings());
        }
    }
}

#[test]
fn open_outlines_keep_their_corners_too() {
    let mut random = Random(5);
    for _ in 0..20 {
        let points = placed(&comb(&mut random), &mut random);
        let fit = fitted(&points, &ArcFitOptions::new(TOLERANCE));
        assert_eq!((fit.certificate().lines, fit.certificate().arcs), (points.len() - 1, 0));
    }
}

/// A smooth closed curve of radius about 50 with waves up to the fifth.
fn wave(random: &mut Random) -> impl Fn(f64) -> Point3 + use<> {
    let waves: Vec<[f64; 3]> =
        (2..=5).map(|n| [f64::from(n), 0.3 / f64::from(n) * random.next(), TAU * random.next()]).collect();
    move |a: f64| {
        let r = 50.0 * waves.iter().fold(1.0, |r, [n, depth, phase]| r + depth * (n * a + phase).cos());
        Point3::new(r * a.cos(), r * a.sin(), 0.0)
    }
}

#[test]
fn samples_of_smooth_curves_stay_smooth() {
    let mut random = Random(11);
    for _ in 0..12 {
        let curve = wave(&mut random);
        // Uneven samples: each is moved by up to a third of the mean step.
        let n = whole(&mut random, 120, 200);
        let points: Vec<_> = (0..n).map(|i| curve(TAU * (i as f64 + 0.6 * random.next()) / n as f64)).collect();
        let fit = fitted(&points, &closed(TOLERANCE));
        assert!(fit.warnings().is_empty(), "{:?}", fit.warnings());
        assert!(fit.certificate().max_kink < 1e-9);
        // An arc fit of a smooth curve is off by the cube of its arcs' length: far fewer arcs than points.
        assert!(pieces(&fit) < n / 2, "{} pieces for {n} points", pieces(&fit));
    }
}

#[test]
fn an_angle_that_is_typed_is_obeyed() {
    // A hexagon with an angle above its turns has no corners, a polygon of 24 with one below has 24.
    let hexagon = circle(6, TAU, 10.0, Point3::ORIGIN);
    let fit = fitted(&hexagon, &ArcFitOptions { corner_angle: Some(1.1), ..closed(TOLERANCE) });
    assert!(fit.certificate().max_kink < 1e-9 && fit.certificate().arcs == 2);
    let coarse = circle(24, TAU, 10.0, Point3::ORIGIN);
    let fit = fitted(&coarse, &ArcFitOptions { corner_angle: Some(0.2), ..closed(TOLERANCE) });
    assert_eq!((fit.certificate().lines, fit.certificate().arcs), (24, 0));
    assert!(matches!(fit.warnings(), [Warning::Fit(FitWarning::CornerKept { vertex: 0, count: 24, .. })]));
}

/// Line, quarter, three quarters back, quarter, line, as the end of a street with room to turn, rounded to centimeters.
fn turning_place() -> Vec<Point3> {
    let mut points: Vec<_> = (0..16).map(|i| Point3::new(4.0 * f64::from(i), 3.5, 0.0)).collect();
    let bends = chain_from(Point3::new(62.7, 3.5, 0.0), &[(7.5, 0.9), (13.0, -4.94), (7.5, 0.9)]);
    points.extend(bends);
    points
}

/// Points a meter apart along arcs of these radii and turns (positive to the left), from a place eastward.
fn chain_from(start: Point3, arcs: &[(f64, f64)]) -> Vec<Point3> {
    let (mut at, mut angle) = (start, 0.0_f64);
    let mut points = vec![start];
    for (radius, turn) in arcs {
        let n = (radius * turn.abs()).round();
        for _ in 0..n as usize {
            let half = 0.5 * turn / n;
            let chord = 2.0 * radius * half.abs().sin();
            at = Point3::new(at.x + chord * (angle + half).cos(), at.y + chord * (angle + half).sin(), 0.0);
            angle += 2.0 * half;
            points.push(at);
        }
    }
    let cents = |x: f64| (100.0 * x).round() / 100.0;
    points.iter().map(|p| Point3::new(cents(p.x), cents(p.y), 0.0)).collect()
}

#[test]
fn the_deviation_is_least_once_the_count_is() {
    let points = turning_place();
    for tolerance in [0.5, 0.1] {
        let fit = fitted(&points, &ArcFitOptions::new(tolerance));
        let radii: Vec<f64> = fit.path().arcs().iter().filter_map(cyclide::curve::Arc::radius).collect();
        assert_eq!(radii.len(), 3, "{radii:?}");
        // Points rounded to a centimeter, on arcs of 7 m: the sagitta is 0.7 m, so a radius is off by less than a tenth.
        for (radius, right) in radii.iter().zip([7.5, 13.0, 7.5]) {
            assert!((radius - right).abs() < 0.1, "{radii:?} at {tolerance}");
        }
        assert!(fit.certificate().deviation < 0.02, "{} at {tolerance}", fit.certificate().deviation);
    }
}

#[test]
fn limits_of_machines_are_kept_or_refused_with_the_place() {
    let points = turning_place();
    let fit = |min_radius: Option<f64>, min_arc_length: Option<f64>| {
        ArcFit::new(&points, &ArcFitOptions { min_radius, min_arc_length, ..ArcFitOptions::new(0.02) })
    };
    let kept = fit(Some(7.0), Some(6.0)).unwrap();
    check(&points, &ArcFitOptions::new(0.02), &kept);
    for arc in kept.path().arcs().iter().filter(|arc| !arc.is_straight()) {
        assert!(arc.radius().unwrap() >= 7.0 && arc.length() >= 6.0);
    }
    // The bends of 7.5 are 6.75 long, the first at points 16 to 23, the other at the end.
    let refused = fit(Some(9.0), None).unwrap_err();
    let at_a_bend = |error: &Error| error.index().is_some_and(|i| (15..=24).contains(&i) || i >= points.len() - 9);
    assert!(refused.reason() == "arc-limit-not-kept" && at_a_bend(&refused), "{refused}");
    let refused = fit(None, Some(9.0)).unwrap_err();
    assert!(refused.reason() == "arc-limit-not-kept" && at_a_bend(&refused), "{refused}");
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(fit(Some(bad), None).unwrap_err().reason(), "parameter-out-of-range");
        assert_eq!(fit(None, Some(bad)).unwrap_err().reason(), "parameter-out-of-range");
    }
}

#[test]
fn straight_runs_stay_straight_in_noise() {
    // A line, an arc and a line, measured with a normal noise of a quarter of the tolerance.
    let mut random = Random(71);
    let mut kept = 0;
    for member in 0..40 {
        let (radius, turn) = ([8.0, 20.0, 50.0][member % 3], [0.9, 1.57, 2.5][member / 3 % 3]);
        let (before, after) = (between(&mut random, 20.0, 80.0), between(&mut random, 20.0, 80.0));
        let (step, noise) = ([0.5, 1.0][member % 2], [0.02, 0.05, 0.1][member / 2 % 3]);
        let (sin, cos) = f64::sin_cos(turn);
        let end = [before + radius * sin, radius * (1.0 - cos)];
        let at = |s: f64| match s - before {
            t if t <= 0.0 => [s, 0.0],
            t if t <= radius * turn => [before + radius * (t / radius).sin(), radius * (1.0 - (t / radius).cos())],
            t => [end[0] + (t - radius * turn) * cos, end[1] + (t - radius * turn) * sin],
        };
        let length = before + radius * turn + after;
        let count = (length / step).round();
        let mut normal = || (0..12).map(|_| random.next()).sum::<f64>() * noise;
        let points: Vec<Point3> = (0..=count as usize)
            .map(|k| at(length * k as f64 / count))
            .map(|[x, y]| Point3::new(x + normal(), y + normal(), 0.0))
            .collect();
        let fit = fitted(&points, &ArcFitOptions::new(4.0 * noise));
        let lines: Vec<bool> = fit.path().arcs().iter().map(cyclide::curve::Arc::is_straight).collect();
        kept += usize::from(lines == [true, false, true]);
    }
    // A first or last point that is three deviations off bends what meets it.
    assert!(kept >= 34, "{kept} of 40");
}

#[test]
fn narrow_fillets_are_widened_to_what_a_machine_can_do() {
    // Fillets of 1, to thousandths; a radius of 2 leaves their points by 0.41 where the sides stay, less where they give way.
    let ends = [[59.0, 1.0], [59.0, 39.0], [1.0, 39.0], [1.0, 1.0]].into_iter().zip([-1.0, 0.0, 1.0, 2.0]);
    let fillets = ends.flat_map(|(center, quarter)| chords(center, 1.0, quarter * FRAC_PI_2, FRAC_PI_2, 8));
    let thousandths = |x: f64| (1000.0 * x).round() / 1000.0;
    let points: Vec<Point3> = fillets.map(|[x, y]| Point3::new(thousandths(x), thousandths(y), 0.0)).collect();
    for radius in [0.9, 1.2, 1.5, 2.0, 2.1] {
        let fit = fitted(&points, &ArcFitOptions { min_radius: Some(radius), ..closed(0.5) });
        let certificate = fit.certificate();
        assert_eq!((certificate.lines, certificate.arcs), (4, 4), "radius {radius}");
        assert!(fit.path().arcs().iter().all(|arc| arc.curvature() * radius <= 1.0 + 1e-9), "radius {radius}");
        assert!(certificate.deviation < 0.42, "radius {radius}: {}", certificate.deviation);
    }
    let wider = ArcFit::new(&points, &ArcFitOptions { min_radius: Some(5.0), ..closed(0.5) });
    assert!(wider.is_err_and(|e| e.reason() == "arc-limit-not-kept"));
}

#[test]
fn a_closed_slot_has_the_radii_of_its_samples() {
    let mut random = Random(3);
    for _ in 0..10 {
        let made = slot(&mut random);
        let radius = made.points[0][1].abs();
        let points = placed(&made.points, &mut random);
        let fit = fitted(&points, &closed(TOLERANCE));
        for arc in fit.path().arcs().iter().filter(|arc| !arc.is_straight()) {
            // The samples are exact; steps of least squares end where they gain a hundred-thousandth.
            assert!((arc.radius().unwrap() - radius).abs() < 1e-3, "{:?} for {radius}", arc.radius());
        }
    }
}

/// Polygons of irregular stars: radii and steps of the angle at random.
fn irregular(random: &mut Random) -> Vec<Point3> {
    let n = whole(random, 12, 28);
    let at = |k: usize, random: &mut Random| {
        let angle = TAU * (k as f64 + between(random, -0.3, 0.3)) / n as f64;
        let radius = between(random, 8.0, 40.0);
        Point3::new(radius * angle.cos(), radius * angle.sin(), 0.0)
    };
    (0..n).map(|k| at(k, random)).collect()
}

#[test]
fn limits_of_machines_do_not_bend_the_sides_of_an_outline() {
    let mut random = Random(77);
    let mut kept = 0;
    for _ in 0..60 {
        let points = irregular(&mut random);
        let free = closed(0.05);
        let Ok(plain) = ArcFit::new(&points, &free) else { continue };
        if plain.certificate().polyline_deviation > 0.05 {
            continue;
        }
        let limit = between(&mut random, 0.3, 3.0);
        for limited in [
            ArcFitOptions { min_arc_length: Some(limit), ..free.clone() },
            ArcFitOptions { min_radius: Some(limit), ..free.clone() },
        ] {
            match ArcFit::new(&points, &limited) {
                // A little more than without the limit, which may cost half the tolerance.
                Ok(fit) => {
                    assert!(fit.certificate().polyline_deviation <= 0.075, "{}", fit.certificate().polyline_deviation);
                    kept += 1;
                }
                Err(error) => assert_eq!(error.reason(), "arc-limit-not-kept"),
            }
        }
    }
    assert!(kept >= 10, "{kept}");
}

#[test]
fn a_fit_that_swings_out_between_noisy_points_says_so() {
    let mut random = Random(5);
    let (mut far, mut all) = (0, 0);
    for _ in 0..60 {
        // A plate with round corners, in steps of 1, with noise of a deviation up to two fifths of that.
        let (width, height, radius) =
            (between(&mut random, 40.0, 90.0), between(&mut random, 25.0, 60.0), between(&mut random, 6.0, 11.0));
        let corner = |x: f64, y: f64, from: f64| round([x, y], radius, from, 0.5 * PI);
        let [x, y] = [width - radius, height - radius];
        let quarter = 0.5 * PI;
        let plate = [
            corner(x, radius, -quarter),
            corner(x, y, 0.0),
            corner(radius, y, quarter),
            corner(radius, radius, 2.0 * quarter),
        ]
        .concat();
        let noise = between(&mut random, 0.6, 1.4);
        let dense = resampled(&plate, 1.0);
        let points: Vec<Point3> = dense
            .iter()
            .map(|p| Point3::new(p[0] + noise * random.next(), p[1] + noise * random.next(), 0.0))
            .collect();
        let tolerance = 1.45 * noise;
        let Ok(fit) = ArcFit::new(&points, &closed(tolerance)) else { continue };
        all += 1;
        // By more than the sagitta of an edge of 1 or 2 between samples.
        if fit.certificate().polyline_deviation > 1.3 * tolerance {
            far += 1;
            assert!(fit.warnings().iter().any(|w| w.reason() == "swings-out"), "{:?}", fit.warnings());
        }
    }
    assert!(all >= 12 && far >= 1, "{far} of {all}");
}

/// Places on a closed polygon, a step apart.
fn resampled(points: &[[f64; 2]], step: f64) -> Vec<[f64; 2]> {
    let n = points.len();
    let mut places = Vec::new();
    let mut left = 0.0;
    for i in 0..n {
        let (a, b) = (points[i], points[(i + 1) % n]);
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        while left < length {
            places.push([0, 1].map(|d| a[d] + (b[d] - a[d]) * left / length));
            left += step;
        }
        left -= length;
    }
    places
}
