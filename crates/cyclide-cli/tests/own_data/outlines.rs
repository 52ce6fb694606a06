//! Outlines whose points are corners: rectangles, slots, combs, printed layers.

use super::case;
use super::common::Folder;
use serde_json::Value;

/// Report of an arc fit of a closed outline, in a folder with its file.
fn fit(folder: &Folder, name: &str, options: &str) -> Value {
    folder.write(&format!("{name}.csv"), &case(&format!("{name}.csv")));
    folder.json(&format!("curve {name}.csv --kind arc-fit {options} -o {name}.dxf --json"))["objects"][name].clone()
}

fn counts(report: &Value) -> (u64, u64) {
    (report["fit"]["lines"].as_u64().unwrap(), report["fit"]["arcs"].as_u64().unwrap())
}

#[test]
fn an_outline_of_corners_is_lines() {
    let folder = Folder::with(&[]);
    // The perimeters of a rectangle of 60 x 40 and of a U of the same size with a slot of 20 x 20.
    for (name, lines, length) in [("rect", 4, 200.0), ("ushape", 8, 240.0)] {
        let report = fit(&folder, name, "--closed --tolerance 0.02");
        assert_eq!(counts(&report), (lines, 0), "{name}");
        assert!((report["length"].as_f64().unwrap() - length).abs() < 1e-9, "{name}");
        assert_eq!(report["fit"]["polyline_deviation"], 0.0, "{name}");
        let corners: Vec<_> = report["warnings"].as_array().unwrap().iter().collect();
        assert_eq!(corners.len(), 1, "one line for all corners: {corners:?}");
    }
}

/// A last point that was drawn beside the first makes no piece of its own, as one that repeats it does not.
#[test]
fn a_closing_point_near_the_first_leaves_no_hook() {
    let box_of = |last: &str| format!("x,y\n0,0\n40,0\n40,20\n0,20\n{last}\n");
    for (last, said) in [
        ("0,0", "point 4 repeats the first point of the closed curve: merged"),
        ("0.006,0.008", "point 4 repeats the first point of the closed curve (distance 0.01): merged"),
    ] {
        let folder = Folder::with(&[("c.csv", &box_of(last))]);
        let run = folder.run("curve c.csv --kind arc-fit --closed --tolerance 0.02 -o c.dxf");
        assert!(run.code == 0 && run.stderr.contains(said), "{}", run.stderr);
        assert!(run.stdout.contains("0 arcs and 4 lines") && !run.stderr.contains("previous"), "{}", run.stdout);
    }
    // The tolerance tells these apart.
    let folder = Folder::with(&[("c.csv", &box_of("0.3,0.4"))]);
    assert!(folder.ok("curve c.csv --kind arc-fit --closed --tolerance 0.02 -o c.dxf").contains("0 arcs and 5 lines"));
    // An ellipse: the hook would be an arc of a radius of 0.4 in 12.
    let at = |i: u32| (f64::from(i) * std::f64::consts::TAU / 40.0).sin_cos();
    let row = |(sin, cos): (f64, f64)| format!("{:.4},{:.4}\n", 10.0 * cos, 6.0 * sin);
    let text = format!("x,y\n{}10.0060,0.0080\n", (0..40).map(at).map(row).collect::<String>());
    let folder = Folder::with(&[("c.csv", &text)]);
    let run = folder.run("curve c.csv --kind arc-fit --closed --tolerance 0.02 --json -o c.dxf");
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    // The curvature of the ellipse is at most 10/36.
    assert!(report["objects"]["c"]["curvature"]["max"].as_f64().unwrap() < 0.35, "{}", run.stdout);
}

#[test]
fn the_smooth_curve_that_nobody_asked_for_is_said() {
    for name in ["rect.csv", "ushape.csv"] {
        let folder = Folder::with(&[(name, &case(name))]);
        let said = folder.run(&format!("curve {name} --closed -o c.json"));
        assert_eq!(said.code, 0, "{}", said.stderr);
        assert!(said.stderr.contains("[read-as-curve]") && said.stderr.contains("--kind arc-fit"), "{}", said.stderr);
        // It is meant where it is typed.
        let typed = folder.run(&format!("curve {name} --closed --kind fair-spline -o c.json --force"));
        assert!(!typed.stderr.contains("[read-as-curve]"), "{}", typed.stderr);
    }
}

#[test]
fn an_outline_read_without_noise_claims_none() {
    let folder = Folder::with(&[("rect.csv", &case("rect.csv"))]);
    let said = folder.run("curve rect.csv --closed --smooth auto -o c.json");
    assert!(said.code == 0 && said.stdout.contains("deviation 0 mm, 0 mm"), "{}{}", said.stdout, said.stderr);
}

#[test]
fn marked_corners_are_kept_or_it_is_said() {
    let table = "x,y,corner\n0,0,1\n30,0,0\n60,0,1\n60,40,1\n30,50,0\n0,40,1\n";
    let folder = Folder::with(&[("c.csv", table)]);
    for kind in ["fair-spline", "circle-spline", "moebius-spline", "arc-fit --tolerance 0.1", "arc-spline"] {
        let said = folder.run(&format!("curve c.csv --closed --kind {kind} -o c.json --force"));
        assert_eq!(said.code, 0, "{}", said.stderr);
        let is_said = said.stderr.contains("4 points are marked as corners") && said.stderr.contains("[no-effect]");
        assert_eq!(is_said, kind == "arc-spline", "{kind}: {}", said.stderr);
    }
}

#[test]
fn a_slot_is_two_lines_and_two_half_circles() {
    let report = fit(&Folder::with(&[]), "slot", "--closed --tolerance 0.02");
    assert_eq!(counts(&report), (2, 2));
    assert!(report["fit"]["polyline_deviation"].as_f64().unwrap() <= 0.02);
    // Two sides of 22 and a circle of radius 4, whose points are rounded to a thousandth.
    let length = 2.0 * 22.0 + 8.0 * std::f64::consts::PI;
    assert!((report["length"].as_f64().unwrap() - length).abs() < 0.02);
    assert!((report["curvature"]["max"].as_f64().unwrap() - 0.25).abs() < 1e-3);
}

#[test]
fn a_cul_de_sac_is_symmetric_at_any_tolerance() {
    for tolerance in ["0.5", "0.1", "0.02"] {
        let folder = Folder::with(&[]);
        let report = fit(&folder, "culdesac", &format!("--tolerance {tolerance}"));
        assert_eq!(counts(&report), (2, 3), "{tolerance}");
        // The points are rounded to centimeters.
        assert!(report["fit"]["deviation"].as_f64().unwrap() < 0.02, "{tolerance}");
        let tightest = 1.0 / report["curvature"]["max"].as_f64().unwrap();
        assert!((tightest - 7.5).abs() < 0.05, "radius {tightest} at {tolerance}");
    }
}

#[test]
fn a_typed_angle_is_obeyed_and_the_remedy_works() {
    let folder = Folder::with(&[]);
    // Above the turns nothing is a corner: the circle through four points, which is said with what mends it.
    let report = fit(&folder, "rect", "--closed --tolerance 0.02 --corner-angle-deg 100");
    assert_eq!(counts(&report), (0, 2));
    let said: Vec<&str> = report["warnings"].as_array().unwrap().iter().filter_map(|w| w["message"].as_str()).collect();
    assert!(said.iter().any(|message| message.contains("target `polyline`")), "{said:?}");
    let report = fit(&folder, "rect", "--closed --tolerance 0.02 --corner-angle-deg 100 --target polyline");
    assert!(report["fit"]["polyline_deviation"].as_f64().unwrap() <= 0.02);
    let report = fit(&folder, "ushape", "--closed --tolerance 0.02 --corner-angle-deg 30");
    assert_eq!(counts(&report), (8, 0));
}

#[test]
fn limits_of_a_machine_are_kept_or_refused_with_the_place() {
    let folder = Folder::with(&[]);
    let kept = fit(&folder, "culdesac", "--tolerance 0.02 --min-arc-length 6 --min-radius 7");
    assert_eq!(counts(&kept), (2, 3));
    for (limit, word) in [("--min-radius 9", "`min_radius` 9"), ("--min-arc-length 9", "`min_arc_length` 9")] {
        let message = folder.fails(1, &format!("curve culdesac.csv --kind arc-fit --tolerance 0.02 {limit} -o c.dxf"));
        assert!(message.contains(word) && message.contains("arc-limit-not-kept"), "{message}");
        assert!(!folder.has("c.dxf"));
        // What the message names is kept.
        let works = message.split("tolerance, or `").nth(1).and_then(|rest| rest.split('`').nth(1)).unwrap();
        let works = works.split(" [").next().unwrap().trim();
        let option = limit.split(' ').next().unwrap();
        let kept = fit(&folder, "culdesac", &format!("--tolerance 0.02 {option} {works}"));
        assert_eq!(counts(&kept), (2, 3), "{message}");
    }
    // Both limits that are missed are named.
    let both = "--tolerance 0.02 --min-radius 9 --min-arc-length 40";
    let message = folder.fails(1, &format!("curve culdesac.csv --kind arc-fit {both} -o c.dxf"));
    let numbers = |word: &str| {
        let rest = message.split("or both ").nth(1)?.split(&format!("`{word}` ")).nth(1)?;
        rest.split([' ', '[']).next().map(str::to_owned)
    };
    let [radius, length] = ["min_radius", "min_arc_length"].map(|word| numbers(word).unwrap());
    let kept = fit(&folder, "culdesac", &format!("--tolerance 0.02 --min-radius {radius} --min-arc-length {length}"));
    assert_eq!(counts(&kept), (2, 3), "{message}");
    let message = folder.fails(2, "curve culdesac.csv --kind fair-spline --min-arc-length 9 -o c.dxf");
    assert!(message.contains("--min-arc-length requires --kind arc-fit"), "{message}");
}
