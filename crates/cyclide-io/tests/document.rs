//! Documents of every type are built, and what the kernel refuses is shown at its place.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use cyclide::{
    Point3,
    curve::{ParamCurve, joints, length},
    model::{CurveObject, Units},
};
use cyclide_io::{
    Document, Error, ModelBuilder,
    document::{BuiltObject, Fitted},
};
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

/// Builds the object `a` of a document with these fields; the only file is `p.csv` with the given text.
fn build_with(fields: &str, file: &str) -> Result<BuiltObject, String> {
    let text = format!("{{\"cyclide\": 1, \"objects\": {{\n\"a\": {{ {fields} }} }} }}");
    let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
    let read = |path: &Path| {
        if path == Path::new("dir/p.csv") {
            Ok(file.as_bytes().to_vec())
        } else {
            Err(std::io::ErrorKind::NotFound.into())
        }
    };
    let built = ModelBuilder::new(&document, Path::new("dir"), &read).and_then(|mut b| b.build(0, &mut |_| {}));
    built.map_err(|e| e.to_string())
}

fn build(fields: &str) -> Result<BuiltObject, String> {
    build_with(fields, "")
}

fn curve(built: &BuiltObject) -> &dyn ParamCurve {
    built.item.curves()[0].as_curve()
}

fn near(a: Point3, b: [f64; 3]) -> bool {
    a.distance(Point3::from(b)) < 1e-14
}

#[test]
fn arcs_in_every_form_are_the_same_quarter_circle() {
    let s = FRAC_PI_2 / 2.0;
    for form in [
        format!("\"through\": [[1,0],[{},{}],[0,1]]", s.cos(), s.sin()),
        "\"from\": [1,0], \"to\": [0,1], \"tangent\": [0,5]".to_owned(),
        "\"from\": [1,0], \"to\": [0,1], \"end_tangent\": [-0.1,0]".to_owned(),
        // The ratio of the weights turns by half the sweep about the normal.
        format!("\"from\": [1,0], \"to\": [0,1], \"weights\": [[1,0,0,0],[{},0,0,{}]]", s.cos(), s.sin()),
        format!("\"from\": [1,0], \"to\": [0,1], \"bulge\": {}", (s / 2.0).tan()),
        format!("\"from\": [1,0], \"to\": [0,1], \"bulge\": {}, \"normal\": [0,0,-1]", -(s / 2.0).tan()),
    ] {
        let built = build(&format!("\"type\": \"arc\", {form}")).unwrap();
        assert!((length(curve(&built)) - FRAC_PI_2).abs() < 1e-14, "{form}");
        assert!(near(curve(&built).point(0.0), [1.0, 0.0, 0.0]) && near(curve(&built).point(1.0), [0.0, 1.0, 0.0]));
        let middle = curve(&built).point(0.5);
        assert!((middle.distance(Point3::new(0.0, 0.0, 0.0)) - 1.0).abs() < 1e-14, "{form}");
    }
}

#[test]
fn an_arc_needs_one_complete_form() {
    for form in [
        "\"from\": [1,0], \"to\": [0,1]",
        "\"from\": [1,0], \"tangent\": [0,1]",
        "\"through\": [[1,0],[0,1],[-1,0]], \"from\": [1,0]",
        "\"through\": [[1,0],[0,1],[-1,0]], \"bulge\": 1",
        "\"from\": [1,0], \"to\": [0,1], \"tangent\": [0,1], \"bulge\": 1",
    ] {
        let message = build(&format!("\"type\": \"arc\", {form}")).unwrap_err();
        assert!(message.starts_with("m.json:2:6: objects.a: an arc requires `through`"), "{message}");
    }
    let message = build("\"type\": \"arc\", \"from\": [1,0], \"to\": [0,1], \"tangent\": [0,1], \"normal\": [0,0,1]");
    assert!(message.unwrap_err().contains("`normal` requires `bulge`"));
}

#[test]
fn circle_and_biarc() {
    let built = build("\"type\": \"circle\", \"center\": [1,2,3], \"normal\": [0,1,0], \"radius\": 2").unwrap();
    assert!((length(curve(&built)) - 4.0 * PI).abs() < 1e-13);
    assert_eq!(built.provenance.kind, "circle");
    let built = build(
        "\"type\": \"biarc\", \"from\": [0,0], \"from_tangent\": [1,0], \"to\": [2,1], \"to_tangent\": [2,0], \"rule\": \"equal-chord\"",
    )
    .unwrap();
    assert_eq!(curve(&built).piece_count(), 2);
    assert!(near(curve(&built).point(1.0), [2.0, 1.0, 0.0]));
}

#[test]
fn a_circle_through_three_points() {
    let built = build("\"type\": \"circle\", \"through\": [[4,0,1],[1,3,1],[-2,0,1]]").unwrap();
    let CurveObject::Circle(circle) = &built.item.curves()[0] else { panic!("a circle") };
    // The circle about (1, 0, 1) with the radius 3, from the first point counter-clockwise: a few roundings of coordinates of 4.
    assert!(circle.center().distance(Point3::new(1.0, 0.0, 1.0)) < 4e-15 && (circle.radius() - 3.0).abs() < 4e-15);
    assert!(near(curve(&built).point(0.0), [4.0, 0.0, 1.0]) && near(curve(&built).point(0.25), [1.0, 3.0, 1.0]));
    let back = build("\"type\": \"circle\", \"through\": [[-2,0],[1,3],[4,0]]").unwrap();
    assert!(near(curve(&back).point(0.25), [1.0, 3.0, 0.0]), "the order of the points is the sense of running");
    for (fields, start) in [
        (
            "\"through\": [[0,0],[1,1],[2,2]]",
            "objects.a.through: the points lie on a line, so they have no circle: sine of their angle 0, ",
        ),
        ("\"through\": [[0,0],[1,1],[1,1]]", "objects.a.through[2]: points 1 and 2 coincide"),
        ("\"through\": [[0,0],[1,1],[0,0]]", "objects.a.through[2]: points 0 and 2 coincide"),
        ("\"through\": [[0,0],[1,1]]", "objects.a.through: 2 values are given, 3 are needed"),
        (
            "\"through\": [[0,0],[1,1],[2,0]], \"radius\": 1",
            "objects.a: a circle requires either `center` and `radius`",
        ),
        ("\"through\": [[0,0],[1,1],[2,0]], \"normal\": [0,0,1]", "objects.a: a circle requires"),
        ("\"center\": [0,0]", "objects.a: a circle requires either `center` and `radius`"),
        ("\"radius\": 1", "objects.a: a circle requires either `center` and `radius`"),
    ] {
        let message = build(&format!("\"type\": \"circle\", {fields}")).map(|b| b.item).unwrap_err();
        assert!(message.contains(&format!(": {start}")), "{fields}: {message}");
    }
}

#[test]
fn splines_and_fits_run_on_every_contour() {
    let square = "[[0,0],[4,0],[4,4],[0,4]]";
    let hole = "[[1,1],[1,2],[2,2],[2,1],[1,1]]";
    let circle: Vec<String> =
        (0..48).map(|i| PI * f64::from(i) / 24.0).map(|a| format!("[{},{}]", 10.0 * a.cos(), 10.0 * a.sin())).collect();
    let circle = format!("[{}]", circle.join(","));
    for (fields, pieces) in [
        ("\"type\": \"fair-spline\", \"tension\": 0.5", 4),
        ("\"type\": \"circle-spline\", \"order\": 3, \"variant\": \"trigonometric\"", 4),
        ("\"type\": \"arc-spline\", \"rule\": \"auto\"", 8),
    ] {
        let built = build(&format!("{fields}, \"closed\": true, \"points\": [{square}, {hole}]")).unwrap();
        assert_eq!(built.item.curves().len(), 2);
        assert!(built.item.curves().iter().all(|c| c.as_curve().piece_count() == pieces && c.as_curve().is_closed()));
        assert_eq!(built.contours.iter().map(|c| c.points).collect::<Vec<_>>(), [4, 4]);
        let remark = &built.remarks[0];
        assert_eq!((remark.reason, remark.contour, remark.index), ("closing-point-merged", Some(1), Some(4)));
        assert_eq!(remark.place.as_deref(), Some("objects.a.points[1][4]"));
        // On circles the tension has no effect, of which the kernel knows nothing.
        for remark in &built.remarks {
            assert_eq!(remark.warning.is_none(), remark.reason == "no-effect", "{remark:?}");
        }
    }
    let fit = format!("\"type\": \"arc-fit\", \"closed\": true, \"tolerance\": 0.01, \"points\": {circle}");
    let built = build(&fit).unwrap();
    let Some(Fitted::Arcs(certificate)) = built.contours[0].fit else { panic!("an arc fit") };
    assert!(certificate.deviation <= 0.01 && built.tolerance == Some(0.01));
    assert!((length(curve(&built)) - 20.0 * PI).abs() < 0.1);
}

/// Arcs within the tolerance of a curve, both ways, and of all its contours; corners stay.
#[test]
fn arcs_are_fitted_to_curves() {
    let of = |source: &str, fields: &str| -> Result<BuiltObject, String> {
        let text = format!(r#"{{"cyclide": 1, "objects": {{"c": {{{source}}}, "f": {{"type": "arc-fit"{fields}}}}}}}"#);
        let document: Document = text.parse().map_err(|e: Error| e.to_string())?;
        document.build().map(|mut all| all.remove(1)).map_err(|e| e.to_string())
    };
    let nurbs = r#""type": "nurbs", "degree": 3, "knots": [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], "control_points": [[0, 0], [20, 40], [60, 50], [90, -30], [130, 10], [150, 60]]"#;
    let fair = r#""type": "fair-spline", "points": [[0, 0, 0], [20, 30, 10], [50, 20, 20], [60, -10, 5], [30, -30, 0]], "closed": true"#;
    let mut counts = Vec::new();
    for source in [nurbs, fair] {
        for tolerance in [1.0, 0.1, 0.01] {
            let fitted = of(source, &format!(r#", "of": "c", "tolerance": {tolerance}"#)).unwrap();
            let Some(Fitted::Arcs(certificate)) = fitted.contours[0].fit else { panic!("an arc fit") };
            assert!(certificate.deviation <= tolerance && fitted.tolerance == Some(tolerance));
            let text = format!(r#"{{"cyclide": 1, "objects": {{"c": {{{source}}}}}}}"#);
            let given = text.parse::<Document>().unwrap().build().unwrap().remove(0);
            let (arcs, given) = (curve(&fitted), given.item.curves()[0].as_curve());
            assert_eq!(arcs.is_closed(), given.is_closed());
            for k in 0..=400 {
                let t = f64::from(k) / 400.0;
                for (from, to) in [(arcs, given), (given, arcs)] {
                    let off = cyclide::curve::closest_point(to, from.point(t)).distance;
                    assert!(off <= tolerance * (1.0 + 1e-9), "{tolerance}: {off}");
                }
            }
            counts.push(arcs.piece_count());
        }
    }
    // Of a cubic arcs are as the third root of the tolerance.
    assert!(counts[2] <= 24 && counts[0] < counts[1] && counts[1] < counts[2], "{counts:?}");
    let square = r#""type": "polyline", "points": [[0, 0], [30, 0], [30, 20], [0, 20]], "closed": true"#;
    let kept = of(square, r#", "of": "c", "tolerance": 0.1"#).unwrap();
    assert_eq!(curve(&kept).piece_count(), 4);
    assert_eq!(kept.remarks.iter().map(|r| r.reason).collect::<Vec<_>>(), ["corner-kept"]);
    assert!(kept.remarks[0].message.starts_with("4 corners"), "{}", kept.remarks[0].message);
    for (fields, words) in [
        (r#", "tolerance": 1"#, "requires either `points` or `of`"),
        (r#", "of": "c", "points": [[0, 0], [1, 1]], "tolerance": 1"#, "requires either `points` or `of`"),
        (r#", "of": "c", "closed": true, "tolerance": 1"#, "require `points`"),
        (r#", "of": "c", "tolerance": 0"#, "tolerance"),
    ] {
        let refused = of(nurbs, fields).unwrap_err();
        assert!(refused.contains(words), "{refused}");
    }
}

#[test]
fn fair_fits_take_their_options_and_keep_their_certificate() {
    // Half a circle of 41 points, each moved by 0.02 in or out.
    let points: Vec<String> = (0..=40)
        .map(|i| {
            let (r, a) = (10.0 + if i % 2 == 0 { 0.02 } else { -0.02 }, PI * f64::from(i) / 40.0);
            format!("[{:.17}, {:.17}]", r * a.cos(), r * a.sin())
        })
        .collect();
    let fit = |fields: &str| {
        let fields = format!("\"type\": \"fair-fit\", \"tolerance\": 0.05{fields}, \"points\": [{}]", points.join(","));
        let built = build(&fields).unwrap();
        let Some(Fitted::Fair(certificate)) = built.contours[0].fit else { panic!("a fair fit") };
        assert!(certificate.deviation <= 0.05 && built.tolerance == Some(0.05));
        (certificate, curve(&built).point(0.0))
    };
    let (free, start) = fit("");
    assert!(free.nodes <= 4 && start.distance(Point3::new(10.02, 0.0, 0.0)) > 1e-6, "free ends");
    let (_, start) = fit(", \"fix_ends\": true");
    assert_eq!(start, Point3::new(10.02, 0.0, 0.0));
    // In the middle of the points: the distances are those of the points from the circle, 0.02.
    let (centered, _) = fit(", \"centre\": 1");
    assert!(centered.rms < free.rms && centered.rms < 0.021);
    let (many, _) = fit(", \"nodes\": 6, \"max_fits\": 3, \"budget\": 0.5, \"polyline\": 2");
    assert!(many.nodes >= free.nodes);
}

#[test]
fn ends_of_closed_curves_are_said_to_have_no_effect() {
    let points = "\"points\": [[0,0],[4,0],[5,3],[2,5],[-1,3]]";
    for kind in [
        "\"type\": \"fair-fit\", \"tolerance\": 0.1, \"fix_ends\": true",
        "\"type\": \"fair-spline\", \"ends\": \"free\"",
        "\"type\": \"circle-spline\", \"ends\": {\"start\": [0,1]}",
    ] {
        let said = |closed: bool| {
            let built = build(&format!("{kind}, \"closed\": {closed}, {points}")).unwrap();
            built.remarks.iter().filter(|r| r.reason == "no-effect" && r.message.contains("no ends")).count()
        };
        assert_eq!([said(true), said(false)], [1, 0], "{kind}");
    }
}

#[test]
fn ends_and_corners_reach_the_spline() {
    let l = "[[0,0],[2,0],[4,0],[4,2],[4,4]]";
    let smooth = build(&format!("\"type\": \"circle-spline\", \"points\": {l}")).unwrap();
    let sharp = build(&format!("\"type\": \"circle-spline\", \"points\": {l}, \"corner_angle\": 1.5")).unwrap();
    let largest = |b: &BuiltObject| joints(curve(b)).iter().fold(0.0, |m: f64, j| m.max(j.angle));
    assert!(largest(&smooth) < 1e-12);
    assert!((largest(&sharp) - FRAC_PI_2).abs() < 1e-12);
    let clamped =
        build(&format!("\"type\": \"circle-spline\", \"points\": {l}, \"ends\": {{\"start\": [0,1]}}")).unwrap();
    let tangent = curve(&clamped).jet(0.0).d1;
    assert!(tangent.x.abs() < 1e-12 * tangent.length() && tangent.y > 0.0);
    // The same corner, from a column of the file.
    let file = "x,y,corner\n0,0,0\n2,0,0\n4,0,1\n4,2,0\n4,4,0\n";
    let marked = build_with("\"type\": \"circle-spline\", \"points\": {\"csv\": \"p.csv\"}", file).unwrap();
    assert_eq!(marked.item.curves(), sharp.item.curves());
}

#[test]
fn files_of_points_are_found_next_to_the_document() {
    let file = "# x_m,y_m\n0,0\n1,0\n1,1\n\n5,5\n6,5\n6,6\n5,5\n";
    let fields = "\"type\": \"arc-spline\", \"points\": {\"csv\": \"p.csv\", \"columns\": [\"y_m\", \"x_m\"]}";
    let built = build_with(fields, file).unwrap();
    assert_eq!(built.item.curves().len(), 2);
    assert!(near(curve(&built).point(1.0), [1.0, 1.0, 0.0]) && near(curve(&built).point(0.5), [0.0, 1.0, 0.0]));
    let reasons: Vec<_> = built.remarks.iter().map(|r| (r.reason, r.place.as_deref())).collect();
    assert_eq!(reasons, [("units-differ", Some("dir/p.csv")), ("ends-meet", Some("dir/p.csv:9"))]);
    let missing = build("\"type\": \"arc-spline\", \"points\": {\"csv\": \"q.csv\"}").unwrap_err();
    assert!(missing.starts_with("m.json:2:48: objects.a.points.csv: cannot read dir/q.csv: "), "{missing}");
}

#[test]
fn what_the_kernel_refuses_is_shown_at_its_place() {
    for (fields, piece, start) in [
        ("\"type\": \"circle\", \"center\": [0,0], \"radius\": -1", "-1", "objects.a.radius: "),
        (
            "\"type\": \"circle\", \"center\": [0,0], \"normal\": [0,0,0], \"radius\": 1",
            "[0,0,0]",
            "objects.a.normal: the normal is zero",
        ),
        ("\"type\": \"arc\", \"through\": [[0,0],[0,0],[1,1]]", "[0,0]", "objects.a.through[1]: points 0 and 1"),
        (
            "\"type\": \"arc\", \"from\": [0,0], \"to\": [1,0], \"tangent\": [0,0]",
            "[0,0]",
            "objects.a.tangent: tangent 0 is zero",
        ),
        (
            "\"type\": \"arc\", \"from\": [0,0], \"to\": [1,0], \"end_tangent\": [-1,0]",
            "[-1,0]",
            "objects.a.end_tangent: tangent 1 points directly away",
        ),
        (
            "\"type\": \"arc\", \"from\": [0,0], \"to\": [1,0], \"weights\": [[1,0,0,0],[0,0,0,0]]",
            "[0,0,0,0]",
            "objects.a.weights[1]: weight 1 is zero",
        ),
        (
            "\"type\": \"biarc\", \"from\": [0,0], \"from_tangent\": [0,0], \"to\": [1,0], \"to_tangent\": [1,0]",
            "[0,0]",
            "objects.a.from_tangent: tangent 0 is zero",
        ),
        ("\"type\": \"circle-spline\", \"points\": []", "[]", "objects.a.points: too few points: 0 given"),
        (
            "\"type\": \"circle-spline\", \"points\": [[0,0],[1,0],[1,1]], \"order\": 7",
            "7",
            "objects.a.order: blend order 7 is outside 1 to 4",
        ),
        (
            "\"type\": \"arc-fit\", \"points\": [[0,0],[1,0],[1,1]], \"tolerance\": 1, \"corner_angle\": 40",
            "40",
            "objects.a.corner_angle: a corner angle of 40 radians exceeds half a turn (3.1416): for degrees, write `{\"degrees\": 40}` or 0.69813",
        ),
        (
            "\"type\": \"fair-spline\", \"points\": [[0,0],[1,0],[1,1]], \"corner_angle\": {\"degrees\": 200}",
            "{\"degrees\": 200}",
            "objects.a.corner_angle: a corner angle of 200 degrees is outside 0 to 180",
        ),
        (
            "\"type\": \"circle-spline\", \"points\": [[0,0],[1,0],[1,1]], \"corner_angle\": 0",
            "0",
            "objects.a.corner_angle: a corner angle of 0 radians is outside 0 to 3.1416",
        ),
        (
            "\"type\": \"circle-spline\", \"points\": [[[0,0],[1,0]],[[5,5]]]",
            "[[5,5]]",
            "objects.a.points[1]: too few points: 1 given, at least 2 needed",
        ),
        ("\"type\": \"arc-fit\", \"points\": [[0,0],[1,0]], \"tolerance\": 0", "0", "objects.a.tolerance: "),
        ("\"type\": \"fair-fit\", \"points\": [[0,0],[1,0]], \"tolerance\": 0", "0", "objects.a.tolerance: "),
        ("\"type\": \"arc-spline\", \"points\": [[0,0],[1,0],[1,0],[0,0]]", "[1,0]", "objects.a.points[1]: "),
        (
            "\"type\": \"arc-spline\", \"points\": [[0,0],[1,0],[1,1]], \"tangents\": [[1,0]]",
            "[[1,0]]",
            "objects.a.tangents: ",
        ),
        (
            "\"type\": \"arc-spline\", \"points\": [[0,0],[1,0],[1,1]], \"tangents\": [[1,0],[0,0],[0,1]]",
            "[0,0]",
            "objects.a.tangents[1]: tangent 1 is zero",
        ),
    ] {
        let message = build(fields).map(|b| format!("built {:?}", b.item)).unwrap_err();
        let lines: Vec<&str> = message.lines().collect();
        assert!(lines[0].starts_with("m.json:2:") && lines[0].contains(&format!(": {start}")), "{fields}\n{message}");
        let carets = lines[2].find('^').unwrap()..lines[2].len();
        assert_eq!(&lines[1][carets], piece, "{message}");
        assert!(message.lines().next().is_some_and(|l| l.ends_with(']')), "the reason is named: {message}");
    }
}

#[test]
fn what_the_kernel_refuses_in_a_file_is_shown_there() {
    let fields = "\"type\": \"arc-spline\", \"points\": {\"csv\": \"p.csv\"}";
    // The repeated point is merged, so the place counts lines of the file, not points left.
    let message = build_with(fields, "x,y\n0,0\n0,0\n1,0\n0,0\n").unwrap_err();
    assert!(message.starts_with("dir/p.csv:4:1: objects.a: "), "{message}");
    assert!(message.contains("[tangent-undefined]") && message.contains("4 | 1,0\n"), "{message}");
    let message = build_with(fields, "0,0\n1,0\n\n7,7\n").unwrap_err();
    assert!(message.starts_with("dir/p.csv:4:1: objects.a: too few points: 1 given"), "{message}");
    let message = build_with(fields, "0,0\n1,x\n").unwrap_err();
    assert!(message.starts_with("dir/p.csv:2:3: `x` is not a number"), "{message}");
}

#[test]
fn documents_made_by_a_program_name_the_object() {
    let text = "{\"cyclide\": 1, \"objects\": {\"a\": {\"type\": \"circle\", \"center\": [0,0], \"radius\": -1}}}";
    let parsed = Document::parse("m.json", text.as_bytes()).unwrap();
    let made = Document::from_objects("made", Units::Inch, parsed.objects);
    let read = |_: &Path| Ok(Vec::new());
    let error = ModelBuilder::new(&made, Path::new(""), &read).unwrap().build(0, &mut |_| {}).unwrap_err();
    assert!(matches!(&error, Error::Geometry { object, .. } if object == "a"), "{error}");
    assert!(error.to_string().ends_with("[radius-not-positive]"));
}

#[test]
fn the_words_of_a_fair_spline_reach_the_kernel() {
    let l = "[[0,0],[2,0],[4,0],[4,2],[4,4]]";
    let fair = |more: &str| build(&format!("\"type\": \"fair-spline\", \"points\": {l}{more}")).unwrap();
    let largest = |b: &BuiltObject| joints(curve(b)).iter().fold(0.0, |m: f64, j| m.max(j.angle));
    let height = |b: &BuiltObject| curve(b).point(0.125).y.abs();
    let plain = fair("");
    // Straight beside the corner, to the bit; with the word off it swings.
    assert!(height(&plain) < 1e-15 && height(&fair(", \"straight\": \"off\"")) > 1e-3);
    assert!(largest(&plain) < 1e-12);
    assert!((largest(&fair(", \"corner_angle\": 1.5")) - FRAC_PI_2).abs() < 1e-12);
    assert!((largest(&fair(", \"corner_angle\": {\"degrees\": 85}")) - FRAC_PI_2).abs() < 1e-12);
    // Two more points round the corner.
    assert_eq!(curve(&fair(", \"tight\": 0.2")).piece_count(), 6);
    let start = |ends: &str| curve(&fair(&format!(", \"ends\": {ends}, \"straight\": \"off\""))).jet(0.0);
    let tangent = start("{\"start\": [0, 1]}").d1;
    assert!(tangent.x.abs() < 1e-12 * tangent.length() && tangent.y > 0.0);
    assert!(start("\"free\"").curvature().unwrap() < 1e-12 && start("\"arc\"").curvature().unwrap() > 1e-3);
    assert!(start("{\"start\": \"free\", \"end\": [1, 0]}").curvature().unwrap() < 1e-12);
    let tense = fair(", \"tension\": 1");
    let CurveObject::CircleSpline(spline) = &tense.item.curves()[0] else { panic!("a circle spline") };
    assert!(spline.segments().iter().all(|s| s.law() == cyclide::curve::BlendLaw::Fair { blend: 0.0 }));
    for (fields, reason) in
        [("\"tension\": 2", "tension"), ("\"tight\": 0.5", "tight"), ("\"ends\": {\"end\": [0,0]}", "ends")]
    {
        let error = build(&format!("\"type\": \"fair-spline\", \"points\": {l}, {fields}")).unwrap_err();
        assert!(error.to_string().contains(&format!("objects.a.{reason}")), "{error}");
    }
}

#[test]
fn a_circle_spline_is_one() {
    let built = build("\"type\": \"circle-spline\", \"points\": [[0,0],[1,0],[1,1]]").unwrap();
    let CurveObject::CircleSpline(spline) = &built.item.curves()[0] else { panic!("a circle spline") };
    assert_eq!(spline.order(), 2);
    assert!(spline.segments().iter().all(|s| s.law() == cyclide::curve::BlendLaw::Rational { order: 2 }));
}

/// Objects made from one another in a row, far more than a stack would hold.
#[test]
fn long_chains_of_objects_are_built() {
    let build = |count: usize| {
        let step = |k: usize| {
            let of = k - 1;
            format!(r#","o{k}":{{"type":"transform","of":"o{of}","steps":[{{"translation":[1,0,0]}}]}}"#)
        };
        let steps: String = (1..count).map(step).collect();
        let text =
            format!(r#"{{"cyclide":1,"objects":{{"o0":{{"type":"circle","center":[0,0],"radius":1}}{steps}}}}}"#);
        let document = Document::parse("m.json", text.as_bytes()).unwrap();
        let read = |_: &Path| Err(std::io::ErrorKind::NotFound.into());
        let mut builder = ModelBuilder::new(&document, Path::new(""), &read).unwrap();
        let last = (0..count).map(|index| builder.build(index, &mut |_| {}).unwrap()).last().unwrap();
        let CurveObject::Circle(circle) = &last.item.curves()[0] else { panic!("a circle") };
        assert!((circle.center().x - (count - 1) as f64).abs() < 1e-9);
    };
    build(40_000);
}

/// A Möbius spline takes its own derivative where none is given.
#[test]
fn a_moebius_spline_has_free_tangents() {
    let spline = |tangents: &str| {
        build(&format!(r#""type": "moebius-spline", "knots": "uniform", "points": [[0,0],[1,0],[1,1]]{tangents}"#))
    };
    let point = |built: &BuiltObject| curve(built).point(0.3);
    let (own, free) = (spline("").unwrap(), spline(r#", "tangents": ["free", "free", "free"]"#).unwrap());
    assert_eq!(point(&own), point(&free));
    let bent = spline(r#", "tangents": [[1, -1], "free", "free"]"#).unwrap();
    assert!(
        (curve(&bent).jet(0.0).d1.unit().unwrap() - cyclide::Vec3::new(0.5_f64.sqrt(), -(0.5_f64.sqrt()), 0.0))
            .length()
            < 1e-15
    );
    assert_eq!(curve(&bent).point(0.75), curve(&own).point(0.75));
    let error = spline(r#", "tangents": [[1, -1], "fre", "free"]"#).unwrap_err();
    assert!(error.contains("objects.a.tangents[1]") && error.contains("did you mean `free`"), "{error}");
}

/// A square whose sides are 1, closed, and a circle of circumference 1.
const TO_CUT: &str = r#""square": {"type": "polyline", "closed": true, "points": [[0,0],[1,0],[1,1],[0,1]]},
    "ring": {"type": "circle", "center": [0,0], "radius": 0.15915494309189535},
    "two": {"type": "polyline", "points": [[[0,0],[1,0]],[[0,0],[3,0]]]},
    "torus": {"type": "cyclide", "a": 3, "mu": 1}"#;

/// The image of an object under steps, or what was refused.
fn stepped(of: &str, steps: &str) -> Result<BuiltObject, String> {
    let text = format!(
        r#"{{"cyclide": 1, "objects": {{ {TO_CUT}, "a": {{"type": "transform", "of": "{of}", "steps": [{steps}]}}}}}}"#
    );
    let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
    document.build().map(|mut built| built.remove(4)).map_err(|e| e.to_string())
}

#[test]
fn curves_are_run_backwards_and_cut() {
    let part = |of: &str, steps: &str| stepped(of, steps).unwrap();
    let back = part("square", "\"reverse\"");
    assert!(curve(&back).is_closed() && near(curve(&back).point(0.25), [0.0, 1.0, 0.0]));
    // Past the start, in the order of the steps: backwards the square goes up first.
    let corner = part("square", r#"{"cut": {"stations": [3.5, 0.5]}}"#);
    assert!(near(curve(&corner).point(0.0), [0.0, 0.5, 0.0]) && near(curve(&corner).point(1.0), [0.5, 0.0, 0.0]));
    assert!((length(curve(&corner)) - 1.0).abs() < 1e-14 && !curve(&corner).is_closed());
    let corner = part("square", r#""reverse", {"cut": {"stations": [3.5, 0.5]}}"#);
    assert!(near(curve(&corner).point(0.0), [0.5, 0.0, 0.0]) && near(curve(&corner).point(1.0), [0.0, 0.5, 0.0]));
    let arc = part("ring", r#"{"cut": {"parameters": [0.9, 0.2]}}, {"scale": {"factor": 10}}"#);
    assert!((length(curve(&arc)) - 3.0).abs() < 1e-13);
    let two = part("two", r#"{"cut": {"parameters": [0.5, 1]}}"#);
    assert_eq!(two.item.curves().iter().map(|c| length(c.as_curve())).collect::<Vec<_>>(), [0.5, 1.5]);
}

/// A spline of degree 3, and its image under steps.
fn mapped_nurbs(steps: &str) -> [BuiltObject; 2] {
    let text = format!(
        r#"{{"cyclide": 1, "objects": {{"s": {{"type": "nurbs", "degree": 3, "knots": [0, 0, 0, 0, 0.4, 1, 1, 1, 1], "weights": [1, 1, 1.6, 1, 0.8],
        "control_points": [[0, 0, 1], [8, 24], [30, 34, 5], [55, 20], [78, 8]]}},
        "t": {{"type": "transform", "of": "s", "steps": [{steps}]}}}}}}"#
    );
    let document = Document::parse("m.json", text.as_bytes()).unwrap();
    document.build().unwrap().try_into().unwrap()
}

#[test]
fn maps_that_follow_each_other_are_one_map() {
    let degree = |built: &BuiltObject| match &built.item.curves()[0] {
        CurveObject::Nurbs(spline) => spline.degree(),
        other => panic!("{other:?}"),
    };
    let sphere = r#"{"inversion": {"center": [30, -20, 10], "radius": 40}}"#;
    // Four times, which one by one is of degree 48 and refused, is nothing.
    for count in [2, 4] {
        let [spline, image] = mapped_nurbs(&vec![sphere; count].join(", "));
        assert_eq!((degree(&spline), degree(&image)), (3, 3));
        // A few roundings of 80.
        for t in [0.0, 0.1, 0.35, 0.7, 1.0] {
            assert!(curve(&image).point(t).distance(curve(&spline).point(t)) < 1e-12);
        }
    }
    let steps = format!(r#"{sphere}, {{"translation": [5, 0, 0]}}, {sphere}"#);
    let [spline, image] = mapped_nurbs(&steps);
    assert_eq!(degree(&image), 6);
    let ends = [curve(&spline).point(0.0), curve(&spline).point(1.0)].map(|p| {
        let center = Point3::new(30.0, -20.0, 10.0);
        let invert = |p: Point3| center + (p - center) * (1600.0 / (p - center).length_squared());
        invert(invert(p) + cyclide::Vec3::X * 5.0)
    });
    assert!(curve(&image).point(0.0).distance(ends[0]) < 1e-12 && curve(&image).point(1.0).distance(ends[1]) < 1e-12);
    // Nor do curves that run backwards, or from start to end, need a second map; the cut of an image is that of another part.
    for between in [
        r#""reverse""#,
        r#"{"cut": {"parameters": [0, 1]}}"#,
        r#""reverse", {"cut": {"parameters": [0, 1]}}, "reverse""#,
    ] {
        let [spline, image] = mapped_nurbs(&format!("{sphere}, {between}, {sphere}"));
        assert_eq!(degree(&image), 3, "{between}");
        let backwards = between == r#""reverse""#;
        for t in [0.0, 0.1, 0.35, 0.7, 1.0] {
            let own = if backwards { 1.0 - t } else { t };
            assert!(curve(&image).point(t).distance(curve(&spline).point(own)) < 1e-12, "{between}");
        }
    }
    let cut = r#"{"cut": {"parameters": [0.1, 1]}}"#;
    assert_eq!(degree(&mapped_nurbs(&format!(r#"{sphere}, {cut}, {sphere}"#))[1]), 12);
    // The same of objects one from another.
    let image = |name: &str, of: &str, step: &str| {
        format!(r#""{name}": {{"type": "transform", "of": "{of}", "steps": [{step}]}}"#)
    };
    let text = format!(
        r#"{{"cyclide": 1, "objects": {{"s": {{"type": "nurbs", "degree": 3, "knots": [0, 0, 0, 0, 1, 1, 1, 1], "control_points": [[0, 0, 1], [8, 24], [30, 34, 5], [55, 20]]}},
        {}, {}, {}}}}}"#,
        image("a", "s", sphere),
        image("b", "a", r#""reverse""#),
        image("c", "b", r#"{"translation": [5, 0, 0]}, {"inversion": {"center": [0, 90, 0], "radius": 20}}"#)
    );
    let built = Document::parse("m.json", text.as_bytes()).unwrap().build().unwrap();
    assert_eq!(built.iter().map(degree).collect::<Vec<_>>(), [3, 6, 6, 6]);
}

#[test]
fn a_step_of_several_maps_is_refused_at_its_place() {
    let sphere = r#"{"inversion": {"center": [5, 5], "radius": 1}}"#;
    for (steps, place) in [
        (format!(r#"{sphere}, {sphere}, {{"inversion": {{"center": [5, 5], "radius": -1}}}}"#), "steps[2]"),
        (format!(r#"{sphere}, {sphere}, {{"inversion": {{"center": [0.5, 0], "radius": 1}}}}"#), "steps[2]"),
    ] {
        let error = stepped("square", &steps).unwrap_err();
        assert!(error.contains(place), "{error}");
    }
}

#[test]
fn what_cannot_be_cut_is_refused_at_its_step() {
    for (of, steps, words) in [
        (
            "two",
            r#"{"cut": {"stations": [0, 2]}}"#,
            "objects.a.steps[0]: contour 0: there is no part between the stations 0 and 2: both must be from 0 to 1,",
        ),
        (
            "square",
            r#""reverse", {"cut": {"stations": [1, 4.5]}}"#,
            "objects.a.steps[1]: there is no part between the stations 1 and 4.5: both must be from 0 to 4,",
        ),
        ("square", r#"{"cut": {"parameters": [0.5, 0.5]}}"#, "[parameter-out-of-range]"),
        ("ring", r#"{"cut": {"parameters": [0, 1]}}"#, "[sweep-out-of-range]"),
        (
            "torus",
            "\"reverse\"",
            "objects.a.steps[0]: `torus` is of type `cyclide`: only curves can be reversed or cut",
        ),
        ("square", r#"{"cut": {"parameters": [0, 0.5], "stations": [0, 1]}}"#, "objects.a.steps[0].cut"),
        ("square", r#"{"cut": [0, 1]}"#, "objects.a.steps[0]: a string, or an object with one name"),
        ("square", r#"{"cut": {"parameter": [0, 1]}}"#, "did you mean `parameters`"),
        ("square", "\"revers\"", "did you mean `reverse`"),
        ("square", r#"{"reverse": true}"#, "objects.a.steps[0]"),
    ] {
        let error = stepped(of, steps).unwrap_err();
        assert!(error.contains(words), "{steps}: {error}");
    }
}

/// Arcs fitted to arcs are these, an arc and a circle to the bit; more effort never takes more of them, and what is refused is said of the tolerance.
#[test]
fn arcs_of_arcs_are_themselves() {
    let of = |curve: &str, fields: &str| {
        let text = format!(
            r#"{{"cyclide": 1, "objects": {{"c": {curve}, "a": {{"type": "arc-fit", "of": "c", {fields}}}}}}}"#
        );
        let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
        let built = document.build().map_err(|e| e.to_string())?;
        Ok::<_, String>(built.into_iter().map(|b| (b.item.curves()[0].clone(), b.contours[0].fit)).collect::<Vec<_>>())
    };
    for curve in [
        r#"{"type": "circle", "center": [1, 2, 3], "radius": 4, "normal": [1, 1, 1]}"#,
        r#"{"type": "arc", "through": [[0, 0], [1, 1], [2, 0.5]]}"#,
        r#"{"type": "biarc", "from": [0, 0], "to": [10, 3], "from_tangent": [1, 1], "to_tangent": [1, -0.3]}"#,
    ] {
        for tolerance in ["0.05", "1e-9"] {
            let made = of(curve, &format!(r#""tolerance": {tolerance}"#));
            let made = made.unwrap();
            assert_eq!(made[0].0, made[1].0, "{tolerance}");
            // It has a sheet like any other fit.
            let Some(Fitted::Arcs(sheet)) = made[1].1 else { panic!("an arc fit") };
            assert_eq!((sheet.deviation, sheet.polyline_deviation, sheet.lines), (0.0, 0.0, 0));
            assert_eq!(sheet.arcs, made[0].0.as_curve().piece_count());
        }
    }
    // Also arcs in space, none of which can be spared; a polyline within a tenth of the tolerance has tens of thousands of edges.
    let point = |k: u32| {
        let (y, x) = (0.7 * f64::from(k)).sin_cos();
        format!("[{}, {}, {}]", 10.0 * x, 10.0 * y + f64::from(7 * k % 3), 11 * k % 7)
    };
    let points = (0..9).map(point).collect::<Vec<_>>().join(", ");
    let spatial = format!(r#"{{"type": "arc-spline", "closed": true, "points": [{points}]}}"#);
    let made = of(&spatial, r#""tolerance": 1e-7"#).unwrap();
    assert_eq!(made[0].0, made[1].0);
    // Neighbors of one circle are still one arc.
    let halves = r#"{"type": "biarc", "from": [1, 0], "to": [-1, 0], "from_tangent": [0, 1], "to_tangent": [0, -1]}"#;
    let one = of(halves, r#""tolerance": 1e-6"#).unwrap();
    assert_eq!(one.iter().map(|(curve, _)| curve.as_curve().piece_count()).collect::<Vec<_>>(), [2, 1]);
    let wave: Vec<String> = (0..11).map(|k| format!("[{}, {}]", 10 * k, 8.0 * f64::from(7 * k % 5 - 2))).collect();
    let wave = format!(r#"{{"type": "fair-spline", "points": [{}]}}"#, wave.join(", "));
    let arcs = |effort: &str| {
        of(&wave, &format!(r#""tolerance": 0.02, "effort": "{effort}""#)).unwrap()[1].0.as_curve().piece_count()
    };
    let [fast, default, best] = ["fast", "default", "best"].map(arcs);
    assert!(best <= default && best <= fast, "{fast} {default} {best}");
    let refused = of(&wave, r#""tolerance": -1"#).unwrap_err();
    assert!(refused.contains("objects.a.tolerance") && refused.contains("-1"), "{refused}");
    assert!(refused.contains("[tolerance-not-positive]") && !refused.contains("0.1"), "{refused}");
    let refused = of(&wave, r#""tolerance": 1e-12"#).unwrap_err();
    assert!(
        refused
            .contains("objects.a.tolerance: the search for arcs needs a polyline within a tenth of 1e-12 of the curve"),
        "{refused}"
    );
    assert!(refused.contains("[too-many-pieces]"), "{refused}");
}

/// The deviation of arcs from a curve is what was reached, measured; that of its polyline has the tenth of the tolerance by which this may be off.
#[test]
fn arcs_of_a_curve_say_what_they_reached() {
    let text = r#"{"cyclide": 1, "objects": {"c": {"type": "fair-spline", "points": [[0, 0], [10, 4], [20, -3], [33, 1], [40, 12]]},
        "a": {"type": "arc-fit", "of": "c", "tolerance": 0.05}}}"#;
    let built = Document::parse("m.json", text.as_bytes()).unwrap().build().unwrap();
    let Some(Fitted::Arcs(certificate)) = built[1].contours[0].fit else { unreachable!("by its type") };
    let (curve, arcs) = (built[0].item.curves()[0].as_curve(), built[1].item.curves()[0].as_curve());
    let off = |k: u32| cyclide::curve::closest_point(arcs, curve.point(f64::from(k) / 4000.0)).distance;
    let reached = (0..=4000).map(off).fold(0.0, f64::max);
    // Measured at four points of each edge, on which the distance is nearly a parabola.
    assert!((certificate.deviation / reached - 1.0).abs() < 0.01, "{} {reached}", certificate.deviation);
    assert!(certificate.polyline_deviation >= reached && certificate.polyline_deviation <= 0.05);
}

/// After an object that cannot be made, those that need it fail with the same error, however often they are asked for, and the others are built.
#[test]
fn building_goes_on_after_an_object_that_failed() {
    let text = r#"{"cyclide": 1, "objects": {
        "bad": {"type": "circle", "center": [0, 0], "radius": -1},
        "moved": {"type": "transform", "of": "bad", "steps": [{"translation": [1, 0, 0]}]},
        "twice": {"type": "transform", "of": "moved", "steps": [{"scale": {"factor": 2}}]},
        "good": {"type": "circle", "center": [0, 0], "radius": 1},
        "copy": {"type": "transform", "of": "good", "steps": [{"translation": [1, 0, 0]}]}}}"#;
    let document: Document = text.parse().unwrap();
    let read = |_: &Path| Err(std::io::ErrorKind::NotFound.into());
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).unwrap();
    let mut built = |index: usize| builder.build(index, &mut |_| {});
    let first = built(0).unwrap_err().to_string();
    for index in [2, 1, 0, 1, 2, 2] {
        assert_eq!(built(index).unwrap_err().to_string(), first, "{index}");
    }
    for index in [4, 3, 4] {
        let curves = built(index).unwrap();
        assert!((length(curves.item.curves()[0].as_curve()) - std::f64::consts::TAU).abs() < 1e-12, "{index}");
    }
}
