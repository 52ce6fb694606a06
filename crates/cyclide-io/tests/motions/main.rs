//! Motions of documents: every notation of poses, what is refused and where, animations read back.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod animations;
mod extremes;
mod remedies;
mod sources;
mod swept;
mod times;
mod told;

use std::path::Path;

use cyclide::{
    Vec3,
    model::{Model, Units},
    motion::Pose,
};
use cyclide_io::{
    Document, ExportOptions, Exporter, Format, ModelBuilder, Report,
    document::BuiltObject,
    report::{GeometryReport, MotionReport, MotionSamples, SamplePlaces, Spacing, sample},
};

/// Builds all objects; `poses.csv` and `box.obj` are files.
fn build_all(objects: &str, table: &str) -> Result<Vec<BuiltObject>, String> {
    let text = format!("{{\"cyclide\": 1, \"objects\": {{\n{objects}\n}} }}");
    let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
    let read = |path: &Path| match path.to_str() {
        Some("poses.csv") => Ok(table.as_bytes().to_vec()),
        Some("box.obj") => Ok(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n".to_vec()),
        _ => Err(std::io::ErrorKind::NotFound.into()),
    };
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).map_err(|e| e.to_string())?;
    (0..document.objects.len()).map(|k| builder.build(k, &mut |_| {}).map_err(|e| e.to_string())).collect()
}

fn build(objects: &str) -> Result<BuiltObject, String> {
    build_all(objects, "").map(|mut all| all.pop().unwrap())
}

fn motion(fields: &str) -> String {
    format!(r#""m": {{"type": "motion", {fields}}}"#)
}

fn end(built: &BuiltObject) -> Pose {
    built.item.motion().unwrap().schedule().unwrap().pose(1.0)
}

const TWO: &str = r#""poses": [{"position": [0, 0]}, {"position": [30, 0, 10], "rpy": [0, 0, {"degrees": 90}]}]"#;

#[test]
fn poses_in_every_notation_are_one() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let list = |last: &str| motion(&format!(r#""poses": [{{"position": [0, 0]}}, {last}]"#));
    let cases = [
        list(r#"{"position": [30, 0, 10], "rpy": [0, 0, {"degrees": 90}]}"#),
        list(r#"{"position": [30, 0, 10], "rpy": {"degrees": [0, 0, 90]}}"#),
        list(&format!(r#"{{"position": [30, 0, 10], "quaternion": [{half}, 0, 0, {half}]}}"#)),
        list(r#"{"position": [30, 0, 10], "quaternion": [-2, 0, 0, -2]}"#),
        list(r#"{"matrix": [[0, -1, 0, 30], [1, 0, 0, 0], [0, 0, 1, 10]]}"#),
        list(r#"{"matrix": [[0, -1, 0, 30], [1, 0, 0, 0], [0, 0, 1, 10], [0, 0, 0, 1]]}"#),
    ];
    let tables = [
        "t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,30,0,10,1,0,0,1\n",
        "x;y;z;roll_deg;pitch_deg;yaw_deg\n0;0;0;0;0;0\n30;0;10;0;0;90\n",
        "x y z roll pitch yaw\n0 0 0 0 0 0\n30 0 10 0 0 1.5707963267948966\n",
        "time [s],x_mm,y_mm,z_mm,roll [deg],pitch [deg],yaw [deg]\n5,0,0,0,0,0,0\n6,30,0,10,0,0,90\n",
        "t_ms;pos_x;pos_y;pos_z;q_w;q_x;q_y;q_z\n0;0;0;0;1;0;0;0\n1000;30;0;10;1;0;0;1\n",
        "px,py,pz,roll (°),pitch (°),yaw (°)\n0,0,0,0,0,0\n30,0,10,0,0,90\n",
    ];
    let read = |table: &str| build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), table).unwrap().pop().unwrap();
    let all = cases.iter().map(|case| build(case).unwrap()).chain(tables.into_iter().map(read));
    for built in all {
        let pose = end(&built);
        assert!((pose.translation() - Vec3::new(30.0, 0.0, 10.0)).length() < 1e-13);
        assert!((pose.rotation().rotate(Vec3::X) - Vec3::Y).length() < 1e-15);
        assert!((built.item.motion().unwrap().duration() - 1.0).abs() < 1e-15);
    }
}

#[test]
fn refusals_are_at_their_place() {
    let refused = |objects: &str| build(objects).unwrap_err();
    let cases = [
        (motion(r#""poses": [{"position": [0, 0]}]"#), "1 poses given, at least 2 needed"),
        (
            motion(r#""poses": [{"position": [0, 0]}, {"position": [1, 0], "quaternion": [0, 0, 0, 0]}]"#),
            "rotation 1 is zero",
        ),
        (motion(r#""poses": [{"position": [0, 0], "time": 0}, {"position": [1, 0]}]"#), "this pose has no `time`"),
        (motion(r#""poses": [{"position": [0, 0], "time": 1}, {"position": [1, 0], "time": 0}]"#), "do not increase"),
        (
            motion(
                r#""poses": [{"position": [0, 0]}, {"position": [1, 0], "quaternion": [1, 0, 0, 0], "rpy": [0, 0, 0]}]"#,
            ),
            "a pose is a `position`",
        ),
        (
            motion(r#""poses": [{"position": [0, 0]}, {"matrix": [[1, 0, 0, 0], [0, 2, 0, 0], [0, 0, 1, 0]]}]"#),
            "not a displacement",
        ),
        (motion(&format!(r#""kind": "conic", {TWO}"#)), "2 poses given, 3 needed"),
        (motion(&format!(r#""law": "eased", "duration": 0, {TWO}"#)), "duration"),
        (motion(&format!(r#""choice": 1, {TWO}"#)), "requires the kind `cubic`"),
        (
            motion(r#""law": "eased", "poses": [{"position": [0, 0]}, {"position": [0, 0], "rpy": [0, 0, 1]}]"#),
            "name a point that moves",
        ),
        (motion(&format!(r#""kind": "sclerp", {TWO}"#)) + r#", "t": {"type": "trajectory", "of": "m"}"#, "helices"),
        (motion(&format!(r#""start": {{"rpy": [0, 0, 1]}}, {TWO}"#)), "`start` requires `along`"),
        (motion(r#""law": "eased""#), "requires either"),
        (CABLE.to_owned() + &motion(&format!(r#""along": "cable", {TWO}"#)), "requires either"),
        (CABLE.to_owned() + &motion(r#""along": "cable", "kind": "spline""#), "there is only one"),
        (CABLE.to_owned() + &motion(r#""along": "cable", "start": {}"#), "`quaternion` or `rpy`"),
        (CABLE.to_owned() + &motion(r#""along": "cable", "start": {"quaternion": [0, 0, 0, 0]}"#), "is zero"),
        (CABLE.to_owned() + &motion(r#""along": "cabel""#), "did you mean `cable`"),
        (motion(r#""along": "m""#), "refers to itself"),
        (
            r#""f": {"type": "circle-spline", "points": [[0, 0], [4, 1], [5, 4]]}, "#.to_owned()
                + &motion(r#""along": "f""#),
            "does not define a rotation",
        ),
        (
            r#""c": {"type": "circle", "center": [0, 0], "radius": 2}, "r": {"type": "pipe", "of": "c", "radius": 1}, "#
                .to_owned() + &motion(r#""along": "r""#),
            "0 contours",
        ),
        (
            motion(TWO) + r#", "t": {"type": "transform", "of": "m", "steps": [{"translation": [1, 0, 0]}]}"#,
            "positioned by its poses",
        ),
        (
            r#""c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "trajectory", "of": "c"}"#
                .to_owned(),
            "only a `motion`",
        ),
    ];
    for (objects, expected) in cases {
        let message = refused(&objects);
        assert!(message.contains(expected), "{objects}\n{message}");
    }
    for (table, expected) in [
        ("0,0,0\n1,1,1\n", "needs a header line"),
        ("t,x,z\n0,0,0\n1,1,1\n", "no column is named `y`"),
        ("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,0,0,0,0,0\n", "is zero"),
        (
            "x,y,z,force\n0,0,0,1\n1,0,0,1\n",
            "`force` is not a column of poses, which are t, time or timestamp, x, y, z",
        ),
        ("x,y,z,rol\n0,0,0,1\n1,0,0,1\n", "`roll_deg`; did you mean `roll`?"),
        ("x,y,z,time [h]\n0,0,0,1\n1,0,0,1\n", "`time [h]` is not a column of poses"),
        ("x,y,z,t,time\n0,0,0,1,1\n1,0,0,1,1\n", "several columns are the time: t, time"),
        ("x_m,y_mm,z_mm\n0,0,0\n1,0,0\n", "the columns x_m, y_mm, z_mm have different units"),
        ("x,y,z,roll_deg,pitch,yaw\n0,0,0,0,0,0\n1,0,0,0,0,0\n", "roll_deg, pitch, yaw have different units"),
        ("t,x,y\n0,0,0\n2,1,1\n1,2,2\n", "poses.csv:4:1: the times do not increase: 1 seconds, after 2"),
        ("x,y,z,qw,qx,qy,qz,yaw\n0,0,0,1,0,0,0,0\n1,0,0,1,0,0,0,0\n", "twice, as quaternions and as angles"),
        ("x,y,z,m11\n0,0,0,1\n1,0,0,1\n", "no column is named `m12`"),
    ] {
        let message = build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), table).unwrap_err();
        assert!(message.contains(expected), "{message}");
    }
}

const CABLE: &str = r#""cable": {"type": "moebius-spline", "points": [[0, 0, 0], [40, 10, 0], [50, 40, 10], [10, 30, 20]], "construction": true}, "#;

#[test]
fn units_of_columns_are_told_and_not_applied() {
    let remarks = |table: &str| {
        let built = build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), table).unwrap().pop().unwrap();
        assert!((end(&built).translation() - Vec3::new(30.0, 0.0, 10.0)).length() < 1e-13);
        built.remarks.iter().map(|remark| (remark.reason, remark.message.clone())).collect::<Vec<_>>()
    };
    assert!(remarks("x_mm,y_mm,z_mm\n0,0,0\n30,0,10\n").is_empty());
    let [(reason, message)] = &remarks("x_m,y_m,z_m\n0,0,0\n30,0,10\n")[..] else { panic!("one remark") };
    assert!(
        *reason == "units-differ"
            && message.contains("the unit in the columns x_m, y_m, z_m is m, but that of the model is mm"),
        "{message}"
    );
    let [(reason, message)] = &remarks("x_um,y_um,z_um\n0,0,0\n30,0,10\n")[..] else { panic!("one remark") };
    assert!(*reason == "unit-not-applied" && message.contains("it is ignored"), "{message}");
}

#[test]
fn a_curve_carries_a_body() {
    let fields = r#""along": "cable", "start": {"rpy": [0, 0, {"degrees": 90}]}, "duration": 4"#;
    let built = build_all(&(CABLE.to_owned() + &motion(fields)), "").unwrap();
    let body = built[1].item.motion().unwrap();
    let (cable, schedule) = (built[0].item.curves()[0].as_curve(), body.schedule().unwrap());
    assert!((schedule.pose(0.0).rotation().rotate(Vec3::X) - Vec3::Y).length() < 1e-15);
    assert!((body.duration() - 4.0).abs() < 1e-15);
    for k in 0..=20 {
        let pose = schedule.pose(f64::from(k) / 20.0);
        let on = cyclide::curve::closest_point(cable, cyclide::Point3::ORIGIN + pose.translation());
        assert!(on.distance < 1e-12, "{}", on.distance);
    }
    // Arcs, segments and circles carry one as well; what is of another kind is refused.
    for curve in [
        r#"{"type": "polyline", "points": [[0, 0], [40, 0], [40, 30]]}"#,
        r#"{"type": "arc-spline", "points": [[0, 0], [40, 0], [40, 30]]}"#,
        r#"{"type": "circle", "center": [0, 0], "radius": 20}"#,
        r#"{"type": "circle-spline", "order": 1, "variant": "rational", "points": [[0, 0], [40, 0], [40, 30]]}"#,
        r#"{"type": "qb-interpolation", "points": [[0, 0], [40, 0], [40, 30], [20, 60], [0, 50]]}"#,
    ] {
        let built = build_all(&format!(r#""cable": {curve}, {}"#, motion(r#""along": "cable""#)), "").unwrap();
        let length = cyclide::curve::length(built[0].item.curves()[0].as_curve());
        let way = built[1].item.motion().unwrap().schedule().unwrap().way();
        assert!((way - length).abs() < 1e-9 * length, "{curve}: {way} {length}");
        assert!((built[1].item.motion().unwrap().duration() - 1.0).abs() < 1e-15);
    }
}

#[test]
fn what_a_body_on_a_curve_makes_is_exact_in_files() {
    let of_it = r#", "p": {"type": "trajectory", "of": "m", "point": [0, 5, 1]},
        "blade": {"type": "polyline", "points": [[0, -4, 0], [0, 4, 0]], "construction": true},
        "s": {"type": "swept-surface", "of": "m", "profile": "blade"}"#;
    let model = model(&(CABLE.to_owned() + &motion(r#""along": "cable""#) + of_it));
    let exporter = Exporter::new(&model).unwrap();
    for format in [Format::Step, Format::Json, Format::Glb] {
        let file = exporter.export(format, &ExportOptions::default()).unwrap();
        exporter.check("f".as_ref(), format, &file).unwrap();
        assert_eq!(file.exact, format != Format::Glb);
    }
}

fn model(objects: &str) -> Model {
    let built = build_all(objects, "").unwrap();
    let items = built.into_iter().filter(|b| !b.construction).map(|b| b.item).collect();
    Model { units: Units::Millimetre, items }
}

#[test]
fn animations_are_what_they_promise() {
    let poses = r#""poses": [{"position": [0, 0, 9]}, {"position": [30, 0, 10], "rpy": [1, 0, 2]}, {"position": [50, 40, 0], "rpy": [-1, 1, 2]}]"#;
    for kind in ["spline", "sclerp", "conic"] {
        for law in ["as-given", "constant-speed", "eased"] {
            for mesh in ["", r#", "mesh": {"obj": "box.obj"}"#] {
                let model =
                    model(&motion(&format!(r#""kind": "{kind}", "law": "{law}", "duration": 7, {poses}{mesh}"#)));
                let exporter = Exporter::new(&model).unwrap();
                let options = ExportOptions { tolerance: Some(1e-2), ..ExportOptions::default() };
                let file = exporter.export(Format::Glb, &options).unwrap();
                let report = exporter.check("m.glb".as_ref(), Format::Glb, &file).unwrap();
                // What single precision costs at 50 units is far below.
                assert!(report.deviation.unwrap() <= 1.05e-2 && report.proof == "sampled", "{kind} {law}: {report:?}");
            }
        }
    }
}

/// What is reported of a motion, and its lines.
fn reported(fields: &str) -> (MotionReport, String) {
    let report = Report::new(Units::Millimetre, &[build(&motion(fields)).unwrap()], None);
    let GeometryReport::Motion(found) = &report.objects[0].geometry else { panic!("{report:?}") };
    let found = (**found).clone();
    (found, report.to_string())
}

#[test]
fn jumps_at_poses_are_reported() {
    // Straight on for a second, then up at twice the speed.
    let poses = r#""poses": [{"position": [0, 0], "time": 0}, {"position": [30, 0], "time": 1}, {"position": [30, 60], "time": 2}]"#;
    let (found, text) = reported(&format!(r#""kind": "sclerp", {poses}"#));
    assert!((found.velocity_jump - 30.0 * 5.0_f64.sqrt()).abs() < 1e-9);
    assert!(text.contains("jumps") && text.contains("velocity 67.082 mm/s"), "{text}");
    // At constant speed, 45 everywhere, the direction still turns by a right angle.
    let (found, _) = reported(&format!(r#""kind": "sclerp", "law": "constant-speed", "duration": 2, {poses}"#));
    assert!((found.velocity_jump - 45.0 * 2.0_f64.sqrt()).abs() < 1e-6);
    // A spline is C1: its velocity is continuous, its acceleration is not.
    let poses = r#""poses": [{"position": [0, 0]}, {"position": [30, 0]}, {"position": [30, 60]}, {"position": [-20, 70, 9], "rpy": [0, 1, 0]}]"#;
    for law in ["as-given", "constant-speed", "eased"] {
        let (found, text) = reported(&format!(r#""law": "{law}", "duration": 2, {poses}"#));
        assert!(found.velocity_jump < 1e-6 * found.speed.max, "{law}: {found:?}");
        assert!(found.acceleration_jump > 1e-2 * found.acceleration, "{law}: {found:?}");
        assert!(text.contains("between poses"), "{text}");
    }
    // From pose to pose there is nothing to jump at.
    let (found, text) = reported(TWO);
    let jumps = [found.velocity_jump, found.acceleration_jump, found.angular_velocity_jump];
    assert!(jumps.iter().all(|jump| *jump == 0.0), "{jumps:?}");
    assert!(!text.contains("jumps"), "{text}");
}

/// Way and turn are those of the motion whatever its times and its law, and every figure is a number.
#[test]
fn figures_are_of_the_spans_and_not_across_them() {
    // Slowly for a unit, then a hundred in no time, then none at all, at very uneven times; on a straight line.
    let poses = r#""poses": [{"position": [0, 0], "time": 0}, {"position": [1, 0], "time": 10}, {"position": [101, 0], "time": 10.001},
        {"position": [101, 0], "time": 11}, {"position": [102, 0], "time": 12}]"#;
    for law in ["as-given", "constant-speed", "eased"] {
        let (found, text) = reported(&format!(r#""kind": "sclerp", "law": "{law}", "duration": 2, {poses}"#));
        assert!((found.length - 102.0).abs() < 1e-10 && found.turn < 1e-12, "{law}: {found:?}");
        let figures = [found.speed.min, found.speed.max, found.angular_speed.max, found.acceleration, found.jerk];
        let jumps = [found.velocity_jump, found.acceleration_jump, found.angular_velocity_jump];
        assert!(figures.iter().chain(&jumps).all(|v| v.is_finite()), "{law}: {found:?}");
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        match law {
            // One pose after the other on a line, all at one speed; no law makes a jerk of that.
            "constant-speed" => {
                assert!((found.speed.min - 51.0).abs() < 1e-9 && (found.speed.max - 51.0).abs() < 1e-9, "{found:?}");
                assert!(found.jerk < 1e-6 && found.acceleration < 1e-6, "{found:?}");
            }
            // 60 of the way over the duration cubed, at both ends: between, the law has less.
            "eased" => {
                assert!((found.speed.max - 51.0 * 1.875).abs() < 1e-2, "{found:?}");
                assert!((found.jerk - 60.0 * 102.0 / 8.0).abs() < 1e-6, "{found:?}");
            }
            _ => assert!((found.speed.max - 100.0 / 0.001 * 6.0).abs() < 1e-4, "{found:?}"),
        }
    }
}

#[test]
fn closed_curves_report_by_how_much_the_body_does_not_close() {
    let of = |closed: bool| {
        let curve = format!(
            r#""cable": {{"type": "arc-spline", "closed": {closed}, "points": [[40, 0, 0], [20, 30, 20], [-20, 30, -10], [-40, 10, 5], [0, -30, 15]]}}, "#
        );
        let built = build_all(&(curve + &motion(r#""along": "cable""#)), "").unwrap();
        let report = Report::new(Units::Millimetre, &built, None);
        let GeometryReport::Motion(found) = report.objects[1].geometry.clone() else { panic!("{report:?}") };
        (found.closing_turn, report.to_string())
    };
    let (open, text) = of(false);
    assert!(open.is_none() && !text.contains("closes"), "{text}");
    let (closed, text) = of(true);
    assert!(closed.unwrap() > 1e-3 && text.contains("comes back") && text.contains("against its start"), "{text}");
}

#[test]
fn a_damaged_animation_is_found() {
    let model = model(&motion(TWO));
    let exporter = Exporter::new(&model).unwrap();
    let file = exporter.export(Format::Glb, &ExportOptions::default()).unwrap();
    let other =
        self::model(&motion(r#""poses": [{"position": [0, 0]}, {"position": [30, 1, 10], "rpy": [0, 0, 1.5]}]"#));
    assert!(Exporter::new(&other).unwrap().check("m.glb".as_ref(), Format::Glb, &file).is_err());
    let mut named = model.clone();
    named.items[0].name = "n".to_owned();
    assert!(Exporter::new(&named).unwrap().check("m.glb".as_ref(), Format::Glb, &file).is_err());
}

#[test]
fn formats_that_hold_no_motion_say_so() {
    let alone = model(&motion(TWO));
    for format in [Format::Step, Format::Svg, Format::Dxf, Format::Csv, Format::Json, Format::Obj, Format::Stl] {
        let error = Exporter::new(&alone).unwrap().export(format, &ExportOptions::default()).unwrap_err();
        assert!(error.to_string().contains("motions"), "{error}");
    }
    let with_path = model(&(motion(TWO) + r#", "p": {"type": "trajectory", "of": "m", "point": [1, 2, 3]}"#));
    let exporter = Exporter::new(&with_path).unwrap();
    for format in [Format::Step, Format::Json, Format::Dxf, Format::Glb, Format::Csv] {
        let file = exporter.export(format, &ExportOptions::default()).unwrap();
        let note = file.notes.iter().any(|note| note.contains("motions are left out"));
        assert_eq!(note, format != Format::Glb, "{format:?} {:?}", file.notes);
        exporter.check("f".as_ref(), format, &file).unwrap();
    }
    let file = exporter.export(Format::Step, &ExportOptions::default()).unwrap();
    assert!(file.exact);
}

#[test]
fn samples_are_poses_and_matrices() {
    let built = build(&motion(TWO)).unwrap();
    let rows = sample(&built, 5, Spacing::Parameter);
    let last: Vec<f64> = rows.lines().last().unwrap().split(',').map(|f| f.parse().unwrap()).collect();
    assert_eq!((rows.lines().count(), last.len()), (6, 23));
    assert!((last[0] - 1.0).abs() < 1e-15);
    let expected = [0.0, -1.0, 0.0, 30.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 10.0];
    assert!(last[8..20].iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15));
    // What is sampled is read again.
    let places =
        |count: usize| MotionSamples::new(&built, SamplePlaces::Count { count, spacing: Spacing::Parameter }).unwrap();
    let text: serde_json::Value = serde_json::from_str(&places(3).json()).unwrap();
    let again = build(&motion(&format!(r#""poses": {}"#, text["poses"]))).unwrap();
    assert!(end(&again).angle_to(end(&built)) < 1e-14);
    let again = build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), &rows).unwrap().pop().unwrap();
    assert!(end(&again).angle_to(end(&built)) < 1e-14);
}

#[test]
fn a_swept_surface_is_a_shell_in_files() {
    let profile = r#", "c": {"type": "circle", "center": [0, 0], "radius": 3, "construction": true}, "s": {"type": "swept-surface", "of": "m", "profile": "c"}"#;
    let poses = r#""poses": [{"position": [0, 0, 0]}, {"position": [0, 5, 20], "rpy": [0.3, 0, 0]}, {"position": [0, 0, 40], "rpy": [0, 0.4, 1]}], "construction": true"#;
    let model = model(&(motion(poses) + profile));
    let exporter = Exporter::new(&model).unwrap();
    for format in [Format::Step, Format::Json, Format::Glb, Format::Stl, Format::Obj] {
        let file = exporter.export(format, &ExportOptions::default()).unwrap();
        exporter.check("f".as_ref(), format, &file).unwrap();
        assert_eq!(file.exact, matches!(format, Format::Step | Format::Json));
    }
}

/// Degrees written as radians, and a rotation of zero, are said where they are.
#[test]
fn doubtful_rotations_are_named_at_their_pose() {
    let wide = build(&motion(r#""poses": [{"position": [0, 0]}, {"position": [1, 0], "rpy": [0, 0, 90]}]"#)).unwrap();
    let reasons: Vec<_> = wide.remarks.iter().map(|remark| remark.reason).collect();
    assert_eq!(reasons, ["more-than-a-turn", "leaves-chords"]);
    assert_eq!(wide.remarks[0].place.as_deref(), Some("objects.m.poses[1].rpy[2]"));
    assert!(wide.remarks[0].message.contains("write `{\"degrees\": 90}`"), "{}", wide.remarks[0].message);
    let table = |header: &str| {
        let text = format!("x,y,z,{header}\n0,0,0,0,0,0\n1,0,0,0,0,90\n");
        build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), &text).unwrap().pop().unwrap().remarks
    };
    let remarks = table("roll,pitch,yaw");
    assert_eq!((remarks[0].reason, remarks[0].place.as_deref()), ("more-than-a-turn", Some("poses.csv:3")));
    // A quarter turn goes round, and nothing else is said.
    assert!(table("roll_deg,pitch_deg,yaw_deg").iter().all(|remark| remark.reason == "leaves-chords"));
    let zero = r#""poses": [{"position": [0, 0]}, {"position": [1, 0], "quaternion": [0, 0, 0, 0]}]"#;
    let error = build(&motion(zero)).unwrap_err();
    assert!(error.contains("objects.m.poses[1]: rotation 1 is zero"), "{error}");
}

/// A point on the axis of a turn has no path, at the origin and elsewhere.
#[test]
fn a_point_at_rest_has_no_path() {
    let turn = motion(r#""poses": [{"position": [0, 0]}, {"position": [0, 0], "rpy": [0, 0, 1]}]"#);
    for point in ["[0, 0, 0]", "[0, 0, 7]"] {
        let path = format!(r#""t": {{"type": "trajectory", "of": "m", "point": {point}}}"#);
        let error = build(&format!("{turn}, {path}")).unwrap_err();
        assert!(
            error.contains("objects.t.point: the point is at rest") && error.contains("[motion-at-rest]"),
            "{error}"
        );
    }
    assert!(build(&format!(r#"{turn}, "t": {{"type": "trajectory", "of": "m", "point": [1e-9, 0, 7]}}"#)).is_ok());
}

/// A law says when each pose is passed; the times of the poses as given need not be said again.
#[test]
fn the_report_says_when_poses_are_passed() {
    let table = "name,t,x,y,z\nhome,0,0,0,0\npick,1,30,0,0\nplace,4,120,0,0\n";
    let report = |fields: &str| {
        let all = build_all(&motion(&format!(r#""poses": {{"csv": "poses.csv"}}, "kind": "sclerp"{fields}"#)), table);
        match cyclide_io::report::ObjectReport::new(&all.unwrap()[0], None).geometry {
            GeometryReport::Motion(found) => found.pose_times,
            _ => None,
        }
    };
    assert_eq!(report(""), None);
    let steady = report(r#", "law": "constant-speed", "duration": 8"#).unwrap();
    assert!(steady.len() == 3 && (steady[1] - 2.0).abs() < 1e-9 && (steady[2] - 8.0).abs() < 1e-12, "{steady:?}");
    assert_eq!(report(r#", "duration": 8"#).unwrap(), [0.0, 2.0, 8.0]);
}

/// What `cyclide sample --frames` writes of a curve is a table of poses: x along the tangent.
#[test]
fn frames_of_curves_are_poses() {
    let table = "t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,signed_curvature,torsion,normal_x,normal_y,normal_z,binormal_x,binormal_y,binormal_z\n\
                 0,0,0,0,1,0,0,0.1,0,0.1,0,0,1,0,0,0,1\n1,5,6,7,0,1,0,0.1,9,,,-1,0,0,0,0,1\n";
    let built = build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), table).unwrap();
    let pose = end(&built[0]);
    assert!((pose.translation() - Vec3::new(5.0, 6.0, 7.0)).length() < 1e-14);
    assert!((pose.rotation().rotate(Vec3::X) - Vec3::Y).length() < 1e-14);
    // Frames that look at a point have that way for their x axis.
    let table = "t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,signed_curvature,torsion,look_x,look_y,look_z,normal_x,normal_y,normal_z,binormal_x,binormal_y,binormal_z\n\
                 0,0,0,0,1,0,0,0.1,0,0.1,0,0,1,0,-1,0,0,0,0,1\n1,5,6,7,1,0,0,0.1,9,,,0,0,1,1,0,0,0,1,0\n";
    let pose = end(&build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), table).unwrap()[0]);
    assert!((pose.rotation().rotate(Vec3::X) - Vec3::Z).length() < 1e-14);
    let refused = build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), "x,y,z,rx,ry,rz\n0,0,0,0,0,0\n1,0,0,0,0,90\n")
        .unwrap_err();
    assert!(refused.contains("controllers mean different angles by `rx, ry, rz`"), "{refused}");
}

/// The report has the times that a cubic chose; coordinates are bounded as those of curves are.
#[test]
fn times_of_cubics_and_far_poses() {
    let poses = r#"[{"position": [0, 1, 0], "quaternion": [1, 0.3, 0, 0.1]}, {"position": [1, 1, 0.2], "quaternion": [1, 0.3, 0.5, 0.1]},
        {"position": [2.2, 1, 1], "quaternion": [0.8, 0.3, 0.9, 0.1]}, {"position": [3, 1, 1], "quaternion": [0.4, 0.3, 1.2, 0.1]}]"#;
    let built = build(&motion(&format!(r#""kind": "cubic", "poses": {poses}, "duration": 6"#))).unwrap();
    let GeometryReport::Motion(found) = cyclide_io::report::ObjectReport::new(&built, None).geometry else {
        panic!("a motion")
    };
    let times = found.pose_times.unwrap();
    assert!(times.len() == 4 && times[0] == 0.0 && (times[3] - 6.0).abs() < 1e-14);
    let schedule = built.item.motion().unwrap().schedule().unwrap();
    for (time, x) in times.iter().zip([0.0, 1.0, 2.2, 3.0]) {
        assert!((schedule.pose(time / 6.0).translation().x - x).abs() < 1e-12);
    }
    let far = build(&motion(r#""poses": [{"position": [0, 0, 1e200]}, {"position": [1, 0, 0]}]"#)).unwrap_err();
    assert!(far.contains("[parameter-out-of-range]"), "{far}");
    let armed = build(&motion(&format!(r#"{TWO}, "arm": 3"#))).unwrap();
    assert!(armed.remarks.iter().any(|r| r.reason == "no-effect" && r.message.starts_with("`arm` has no effect")));
}
