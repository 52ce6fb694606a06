//! Measured points: noise, outliers, stops.

use super::case;
use super::common::Folder;
use std::f64::consts::TAU;

type Points = Vec<[f64; 2]>;

/// Reads the first two columns after a header line.
fn points(text: &str, [x, y]: [usize; 2]) -> Points {
    let row = |line: &str| -> [f64; 2] {
        let numbers: Vec<&str> = line.split(',').collect();
        [x, y].map(|column| numbers[column].parse().unwrap())
    };
    text.lines().skip(1).filter(|line| !line.is_empty()).map(row).collect()
}

/// The curve of a CSV output.
fn curve(folder: &Folder, name: &str) -> Points {
    points(&String::from_utf8(folder.read(name)).unwrap(), [3, 4])
}

fn distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let ([ex, ey], [vx, vy]) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = ex * ex + ey * ey;
    let t = if square > 0.0 { ((vx * ex + vy * ey) / square).clamp(0.0, 1.0) } else { 0.0 };
    (vx - t * ex).hypot(vy - t * ey)
}

/// Root mean square of the distances of points from a closed polyline.
fn rms(of: &Points, from: &Points) -> f64 {
    let edges = || from.iter().zip(from.iter().cycle().skip(1));
    let nearest = |p: &[f64; 2]| edges().map(|(a, b)| distance(*p, *a, *b)).fold(f64::INFINITY, f64::min);
    (of.iter().map(|p| nearest(p).powi(2)).sum::<f64>() / of.len() as f64).sqrt()
}

/// The rows of the warnings with a reason, as lines of the file.
fn rows(stderr: &str, file: &str, reason: &str) -> Vec<usize> {
    let of = |line: &str| line.split(&format!("{file}:")).nth(1)?.split(':').next()?.parse().ok();
    stderr.lines().filter(|line| line.contains(&format!("[{reason}]"))).filter_map(of).collect()
}

#[test]
fn the_strength_follows_the_noise_of_a_gps_track() {
    let folder = Folder::with(&[("gps.csv", &case("gps_noise.csv"))]);
    let run = folder.run("curve gps.csv --closed --smooth auto -o g.csv --tolerance 0.01");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let truth = points(&case("gps_truth.csv"), [0, 1]);
    // SciPy's splprep with the true deviation: 0.79; the points themselves 1.5.
    let error = rms(&truth, &curve(&folder, "g.csv"));
    assert!(error < 0.5, "{error}");
    let report = folder.json("curve gps.csv --closed --smooth auto -o h.csv --json");
    let fit = &report["objects"]["gps"]["fit"];
    // The deviation of 1.5, from 600 points: 3 % of it by chance.
    let noise = fit["noise"].as_f64().unwrap();
    assert!((noise - 1.5).abs() < 0.15, "{fit}");
    assert!((fit["rms"].as_f64().unwrap() - noise).abs() < 0.1 * noise, "{fit}");
}

#[test]
fn a_weight_of_one_keeps_as_close_as_the_noise_allows() {
    let folder = Folder::with(&[("gps.csv", &case("gps_noise.csv"))]);
    let run = folder.run("curve gps.csv --closed --smooth 5 --centre 1 -o g.csv --tolerance 0.01");
    assert_eq!(run.code, 0, "{}", run.stderr);
    // The fairest curve in the tolerance is 1.60 off, and the points are 1.5.
    let error = rms(&points(&case("gps_truth.csv"), [0, 1]), &curve(&folder, "g.csv"));
    assert!(error < 0.8 && !run.stderr.contains("beyond-noise"), "{error}: {}", run.stderr);
}

#[test]
fn corners_are_no_noise() {
    // Sides of three points each, exact: nothing is noise. And a bracket whose corners have legs of six tolerances.
    let sides = "x,y\n0,0\n20,0\n40,0\n60,0\n60,20\n60,40\n40,40\n20,40\n0,40\n0,20\n";
    let bracket = "x,y\n0,40\n0,34\n17,34\n17,0\n23,0\n23,34\n40,34\n40,40\n";
    for (outline, corners, smooth) in [(sides, 4, "auto"), (bracket, 8, "1"), (bracket, 8, "2"), (bracket, 8, "auto")] {
        let folder = Folder::with(&[("o.csv", outline)]);
        let report = folder.json(&format!("curve o.csv --closed --smooth {smooth} -o o.dxf --json"));
        let object = &report["objects"]["o"];
        assert!(object["fit"]["polyline_deviation"].as_f64().unwrap() < 1e-5, "{smooth}: {object}");
        assert_eq!(object["fit"]["nodes"], corners, "{smooth}: {object}");
    }
}

#[test]
fn long_sides_beside_a_small_round_keep_straight() {
    // A bracket with legs of 6 and a round of 6 inside, which a tolerance of 1.5 hardly sees.
    let angle = |k: i32| (f64::from(k) * TAU / 44.0).sin_cos();
    // From below to the left: (12, 6) to (6, 12).
    let round: String = (0..=11)
        .map(|k| (12.0 - 6.0 * angle(k).0, 12.0 - 6.0 * angle(k).1))
        .map(|(x, y)| format!("{x},{y}\n"))
        .collect();
    let bracket = format!("x,y\n0,0\n60,0\n60,6\n{round}6,50\n0,50\n");
    // Without noise nothing moves.
    let folder = Folder::with(&[("o.csv", &bracket)]);
    let report = folder.json("curve o.csv --closed --smooth auto -o o.dxf --json");
    let fit = &report["objects"]["o"]["fit"];
    assert!(fit["noise"].as_f64().unwrap() < 1e-3 && fit["polyline_deviation"].as_f64().unwrap() < 0.05, "{fit}");
    for smooth in [0.5, 1.0, 1.5, 2.0] {
        let folder = Folder::with(&[("o.csv", &bracket)]);
        let report = folder.json(&format!("curve o.csv --closed --smooth {smooth} -o o.dxf --json"));
        let off = report["objects"]["o"]["fit"]["polyline_deviation"].as_f64().unwrap();
        assert!(off <= 1.1 * smooth, "{smooth}: {off}");
    }
}

#[test]
fn a_deviation_that_is_given_is_obeyed() {
    let folder = Folder::with(&[("gps.csv", &case("gps_noise.csv"))]);
    let report = folder.json("curve gps.csv --closed --smooth auto --noise 2.5 -o h.csv --json");
    let rms = report["objects"]["gps"]["fit"]["rms"].as_f64().unwrap();
    assert!((rms - 2.5).abs() < 0.4, "{rms}");
    let said = folder.fails(2, "curve gps.csv --closed --smooth 5 --noise 1 -o h.csv");
    assert!(said.contains("--noise"), "{said}");
}

#[test]
fn outliers_are_named_by_row_and_left_out_on_request() {
    let folder = Folder::with(&[("gps.csv", &case("gps_outliers.csv"))]);
    // Rows that were moved by at least 16 m; one more by 6 m, which is four deviations and may be noise.
    let (given, clean) = (points(&case("gps_outliers.csv"), [0, 1]), points(&case("gps_noise.csv"), [0, 1]));
    let moved = |i: &usize| (given[*i][0] - clean[*i][0]).hypot(given[*i][1] - clean[*i][1]);
    let outliers: Vec<usize> = (0..given.len()).filter(|i| moved(i) > 10.0).map(|i| i + 2).collect();
    assert_eq!(outliers.len(), 5);
    for arguments in ["--smooth auto", "--smooth auto --outliers drop", "--smooth 5 --outliers drop"] {
        let run = folder.run(&format!("curve gps.csv --closed {arguments} -o g.csv --force"));
        assert_eq!(run.code, 0, "{arguments}: {}", run.stderr);
        assert_eq!(rows(&run.stderr, "gps.csv", "outlier"), outliers, "{}", run.stderr);
    }
    let said = folder.fails(1, "curve gps.csv --closed --smooth 5 --centre 1 -o g.csv");
    assert!(said.contains("--outliers drop") && said.contains("[outliers]"), "{said}");
    for row in outliers {
        assert!(said.contains(&format!("point {} (", row - 2)), "{row}: {said}");
    }
    let truth = points(&case("gps_truth.csv"), [0, 1]);
    folder.ok("curve gps.csv --closed --smooth auto --outliers drop -o d.csv --tolerance 0.01");
    assert!(rms(&truth, &curve(&folder, "d.csv")) < 0.6);
    // Kept they have little influence.
    folder.ok("curve gps.csv --closed --smooth auto -o k.csv --tolerance 0.01");
    assert!(rms(&truth, &curve(&folder, "k.csv")) < 0.8);
}

#[test]
fn a_stop_is_one_point() {
    let folder = Folder::with(&[("gps.csv", &case("gps_stop.csv"))]);
    for strength in ["auto", "5 --centre 1"] {
        let run = folder.run(&format!("curve gps.csv --closed --smooth {strength} -o g.csv --force --json"));
        assert_eq!(run.code, 0, "{}", run.stderr);
        let said = run.stderr.lines().find(|line| line.contains("[stop]")).unwrap();
        // Points 300 to 359, and those within two deviations of the place on the way to it and from it, 3.7 apart.
        let number = |after: &str| -> usize {
            said.split(after).nth(1).unwrap().split_whitespace().next().unwrap().parse().unwrap()
        };
        assert!(number("points ").abs_diff(300) <= 3 && number(" to ").abs_diff(359) <= 3, "{said}");
        let report: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        // The least radius of the figure itself is 40 m.
        let curvature = report["objects"]["gps"]["curvature"]["max"].as_f64().unwrap();
        assert!(curvature < 1.0 / 20.0, "{strength}: {curvature}");
    }
}

#[test]
fn the_fairest_curve_keeps_to_an_outline() {
    let folder = Folder::with(&[
        ("rect.csv", &case("rect.csv")),
        ("u.csv", &case("ushape.csv")),
        ("slot.csv", &case("slot.csv")),
    ]);
    for (name, most) in [("rect", 0.02), ("u", 0.02), ("slot", 0.02)] {
        let run = folder.run(&format!("curve {name}.csv --closed --smooth {most} -o {name}_out.csv --tolerance 0.001"));
        assert_eq!(run.code, 0, "{}", run.stderr);
        let outline = points(&String::from_utf8(folder.read(&format!("{name}.csv"))).unwrap(), [0, 1]);
        let made = curve(&folder, &format!("{name}_out.csv"));
        let from = |p: &[f64; 2]| {
            let edges = outline.iter().zip(outline.iter().cycle().skip(1));
            edges.map(|(a, b)| distance(*p, *a, *b)).fold(f64::INFINITY, f64::min)
        };
        // The half circles of the slot bulge beyond their chords by 0.02 themselves.
        let off = made.iter().map(from).fold(0.0, f64::max);
        assert!(off < 3.0 * most, "{name}: {off}");
    }
}

/// Numbers from a seed: those of Knuth's generator, and normal ones by Box and Muller.
struct Random(u64);

impl Random {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 + 0.5) / 2_f64.powi(53)
    }

    fn normal(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (TAU * self.uniform()).cos()
    }
}

/// A closed smooth curve of some hundred points.
fn figure(random: &mut Random, n: usize, size: f64) -> Points {
    let waves: Vec<[f64; 4]> =
        (2..6).map(|m| [0; 4].map(|_| 0.2 * size / f64::from(m * m) * random.normal())).collect();
    let at = |i: usize| {
        let a = TAU * i as f64 / n as f64;
        let wave = |of: [usize; 2]| -> f64 {
            let term = |(m, w): (f64, &[f64; 4])| w[of[0]] * (m * a).cos() + w[of[1]] * (m * a).sin();
            (2..6).map(f64::from).zip(&waves).map(term).sum()
        };
        [size * a.cos() + wave([0, 1]), size * a.sin() + wave([2, 3])]
    };
    (0..n).map(at).collect()
}

fn csv(points: &Points) -> String {
    let rows: String = points.iter().map(|[x, y]| format!("{x},{y}\n")).collect();
    format!("x,y\n{rows}")
}

#[test]
fn random_figures_with_noise_outliers_and_stops() {
    let folder = Folder::with(&[]);
    for seed in 0..20 {
        let mut random = Random(seed);
        let n = 200 + (300.0 * random.uniform()) as usize;
        let truth = figure(&mut random, n, 300.0);
        let step = 300.0 * TAU / n as f64;
        let noise = step * (0.2 + 0.6 * random.uniform());
        let mut measured: Points = truth.iter().map(|p| p.map(|x| x + noise * random.normal())).collect();
        // Off by 20 to 40 deviations, outward.
        let mut outliers: Vec<usize> =
            (0..4).map(|k| 10 + k * n / 4 + (random.uniform() * n as f64 / 8.0) as usize).collect();
        outliers.sort_unstable();
        for i in &outliers {
            let far = noise * (20.0 + 20.0 * random.uniform());
            let length = truth[*i][0].hypot(truth[*i][1]);
            measured[*i] = [0, 1].map(|k| measured[*i][k] + far * truth[*i][k] / length);
        }
        folder.write("p.csv", &csv(&measured));
        let run = folder.run("curve p.csv --closed --smooth auto --outliers drop -o c.csv --tolerance 0.1 --force");
        assert_eq!(run.code, 0, "{seed}: {}", run.stderr);
        let named = rows(&run.stderr, "p.csv", "outlier");
        assert_eq!(named, outliers.iter().map(|i| i + 2).collect::<Vec<_>>(), "{seed}: {}", run.stderr);
        let error = rms(&truth, &curve(&folder, "c.csv"));
        assert!(error < 0.55 * noise, "{seed}: {error} of {noise}");
    }
}

/// How far a point is from a rectangle about the origin with rounds, by quarters.
fn from_rounded(p: [f64; 2], half: [f64; 2], radii: [f64; 4]) -> f64 {
    let radius = radii[match (p[0] > 0.0, p[1] > 0.0) {
        (true, true) => 0,
        (false, true) => 1,
        (false, false) => 2,
        (true, false) => 3,
    }];
    let [x, y] = [0, 1].map(|k| p[k].abs() - half[k] + radius);
    (x.max(0.0).hypot(y.max(0.0)) + x.max(y).min(0.0) - radius).abs()
}

#[test]
fn measured_outlines_keep_their_sides() {
    // The four rounds are measured and nothing of the sides: noise hides that the edges between them are far longer.
    let mut random = Random(5);
    for (trial, noise) in (0..24).map(|k| (k, [0.0, 0.02, 0.05, 0.2][k % 4])) {
        let half = [30.0 + 45.0 * random.uniform(), 20.0 + 40.0 * random.uniform()];
        // Those of the second dozen differ, and so do their points.
        let radii = [(); 4].map(|()| 4.0 + 8.0 * random.uniform());
        let radii = if trial < 12 { [radii[0]; 4] } else { radii };
        let steps = [0, 3, 1, 5].map(|more| 8 + trial / 3 + if trial < 12 { 0 } else { more });
        let round = |quarter: usize| (0..=steps[quarter]).map(move |k| (quarter, k as f64 / steps[quarter] as f64));
        let at = |(quarter, t): (usize, f64)| {
            let (sin, cos) = ((quarter as f64 + t) * TAU / 4.0).sin_cos();
            let corner = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][quarter];
            let noise = [noise * random.normal(), noise * random.normal()];
            [0, 1].map(|k| corner[k] * (half[k] - radii[quarter]) + radii[quarter] * [cos, sin][k] + noise[k])
        };
        let measured: Points = (0..4).flat_map(round).map(at).collect();
        let folder = Folder::with(&[("o.csv", &csv(&measured))]);
        let run = folder.run("curve o.csv --closed --smooth auto -o c.csv");
        assert_eq!(run.code, 0, "{trial}: {}", run.stderr);
        let far = curve(&folder, "c.csv").into_iter().map(|p| from_rounded(p, half, radii)).fold(0.0, f64::max);
        assert!(far <= 7.0 * noise + 0.02, "{trial}: {far} with noise of {noise}");
    }
}

/// Points on an ellipse with noise.
fn ellipse(n: usize, [a, b]: [f64; 2], noise: f64, random: &mut Random) -> Points {
    let at = |i: usize| {
        let (sin, cos) = (TAU * i as f64 / n as f64).sin_cos();
        [a * cos + noise * random.normal(), b * sin + noise * random.normal()]
    };
    (0..n).map(at).collect()
}

#[test]
fn few_points_of_a_bent_shape_are_no_noise() {
    let mut random = Random(1);
    for (n, axes, most) in [(20, [50.0, 12.0], 1.0), (12, [50.0, 30.0], 2.0), (32, [40.0, 25.0], 0.1)] {
        let truth = ellipse(4000, axes, 0.0, &mut random);
        let folder = Folder::with(&[("e.csv", &csv(&ellipse(n, axes, 0.0, &mut random)))]);
        let run = folder.run("curve e.csv --closed --smooth auto -o c.csv");
        assert_eq!(run.code, 0, "{}", run.stderr);
        let far = curve(&folder, "c.csv").iter().map(|p| rms(&vec![*p], &truth)).fold(0.0, f64::max);
        assert!(far < most, "{n}: {far}");
    }
}

#[test]
fn noise_as_large_as_the_steps_is_no_outline() {
    // Steps of 1.25, noise of 1.5: the points turn by all angles, back too.
    let mut random = Random(2);
    let axes = [150.0, 80.0];
    let truth = ellipse(600, axes, 0.0, &mut random);
    for arguments in ["", "--noise 1.5"] {
        let folder = Folder::with(&[("e.csv", &csv(&ellipse(600, axes, 1.5, &mut random)))]);
        let run = folder.run(&format!("curve e.csv --closed --smooth auto {arguments} -o c.csv --tolerance 0.1"));
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert!(!run.stderr.contains("[corner-kept]"), "{}", run.stderr);
        let error = rms(&truth, &curve(&folder, "c.csv"));
        assert!(error < 0.8, "{arguments}: {error}");
    }
}

#[test]
fn a_dense_round_is_no_stop() {
    // Rounds of 25 points each, 0.07 apart, between sides of points 2.4 apart.
    let half = [40.0, 25.0];
    let mut outline = Points::new();
    for quarter in 0..4 {
        let corner = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][quarter];
        for k in 0..=24 {
            let (sin, cos) = ((quarter as f64 + f64::from(k) / 24.0) * TAU / 4.0).sin_cos();
            outline.push([0, 1].map(|i| corner[i] * (half[i] - 1.0) + [cos, sin][i]));
        }
        let [from, next] =
            [quarter, (quarter + 1) % 4].map(|k| [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][k]);
        let axis = usize::from(quarter % 2 == 1);
        let steps = ((half[axis] - 1.0) * 2.0 / 2.4) as usize;
        for k in 1..steps {
            let t = k as f64 / steps as f64;
            let mut p = [0, 1].map(|i| from[i] * half[i]);
            p[axis] = (from[axis] + t * (next[axis] - from[axis])) * (half[axis] - 1.0);
            outline.push(p);
        }
    }
    let folder = Folder::with(&[("r.csv", &csv(&outline))]);
    for arguments in ["--smooth 0.1", "--smooth auto"] {
        let run = folder.run(&format!("curve r.csv --closed {arguments} -o c.csv --force"));
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert!(!run.stderr.contains("[stop]"), "{arguments}: {}", run.stderr);
        let far = curve(&folder, "c.csv").into_iter().map(|p| from_rounded(p, half, [1.0; 4])).fold(0.0, f64::max);
        // Of samples 2.4 apart beside samples 0.07 apart an arc could be 0.35 off.
        assert!(far < 0.35, "{arguments}: {far}");
    }
}

#[test]
fn single_points_far_off_are_outliers_and_no_corners() {
    // A road with two wrong rows, from half a step to four steps off.
    for off in [10.0, 40.0, 80.0] {
        let at = |i: usize| {
            let x = 20.0 * i as f64;
            [x, 40.0 * (x / 300.0).sin() + if i == 20 || i == 55 { off } else { 0.0 }]
        };
        let road: Points = (0..100).map(at).collect();
        let folder = Folder::with(&[("r.csv", &csv(&road))]);
        let run = folder.run("curve r.csv --smooth auto --outliers drop -o c.csv");
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert_eq!(rows(&run.stderr, "r.csv", "outlier"), [22, 57], "{off}: {}", run.stderr);
        let wrong = |p: &[f64; 2]| (p[1] - 40.0 * (p[0] / 300.0).sin()).abs();
        let far = curve(&folder, "c.csv").iter().map(wrong).fold(0.0, f64::max);
        assert!(far < 0.5, "{off}: {far}");
    }
}
