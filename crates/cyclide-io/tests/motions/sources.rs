//! What motions are made of, and what is made of them: tables of matrices, curves that carry, a body at rest.

use crate::{build, build_all, end, motion};
use cyclide::{Vec3, motion::Pose};
use cyclide_io::document::BuiltObject;

#[test]
fn tables_of_matrices_are_poses() {
    let of =
        |table: &str| build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), table).map(|mut made| made.pop().unwrap());
    let twelve = "m11,m12,m13,m14,m21,m22,m23,m24,m31,m32,m33,m34";
    let rows = ["1,0,0,0,0,1,0,0,0,0,1,0", "0,-1,0,30,1,0,0,0,0,0,1,10"];
    let expected =
        Pose::from_roll_pitch_yaw(Vec3::new(30.0, 0.0, 10.0), [0.0, 0.0, std::f64::consts::FRAC_PI_2]).unwrap();
    let same = |built: &BuiltObject| {
        let end = end(built);
        end.angle_to(expected) < 1e-14 && (end.translation() - expected.translation()).length() < 1e-13
    };
    assert!(same(&of(&format!("{twelve}\n{}\n{}\n", rows[0], rows[1])).unwrap()));
    assert!(same(&of(&format!("t,{twelve},m41,m42,m43,m44\n0,{},0,0,0,1\n2,{},0,0,0,1\n", rows[0], rows[1])).unwrap()));
    assert!(same(
        &of("x,y,z,m11,m12,m13,m21,m22,m23,m31,m32,m33\n0,0,0,1,0,0,0,1,0,0,0,1\n30,0,10,0,-1,0,1,0,0,0,0,1\n")
            .unwrap()
    ));
    for (table, words) in [
        (format!("x,y,z,{twelve}\n0,0,0,{}\n", rows[0]), "the positions are given twice"),
        (format!("roll,pitch,yaw,{twelve}\n0,0,0,{}\n", rows[0]), "the rotations are given twice"),
        ("m11,m12,m13,m14,m21,m22,m23,m24,m31,m32,m34\n1,0,0,0,0,1,0,0,0,0,0\n".to_owned(), "m33"),
        (format!("{twelve}\n{}\n1,0,0,0,0,1,0,0,0,0,-1,0\n", rows[0]), "[not-a-rotation]"),
        (format!("{twelve},m44\n{},2\n", rows[0]), "[not-a-rotation]"),
    ] {
        let error = of(&table).err().unwrap();
        assert!(error.contains(words), "{table}: {error}");
    }
}

#[test]
fn a_motion_at_rest_sweeps_nothing() {
    let rest = motion(r#""poses": [{"position": [5, 7]}, {"position": [5, 7]}]"#);
    let swept = r#", "c": {"type": "circle", "center": [0, 0], "radius": 3}, "s": {"type": "swept-surface", "of": "m", "profile": "c"}"#;
    let error = build(&(rest + swept)).unwrap_err();
    assert!(error.contains("objects.s.of: the motion is at rest") && error.contains("[motion-at-rest]"), "{error}");
}

#[test]
fn curves_that_carry_no_body_are_told_which_do() {
    let curve = r#""cable": {"type": "fair-spline", "tension": 1, "points": [[0, 0], [4, 0], [4, 3], [9, 5]]}, "#;
    if let Err(error) = build_all(&(curve.to_owned() + &motion(r#""along": "cable""#)), "") {
        assert!(error.contains("a `fair-spline` of tension 0"), "{error}");
    }
    let spline = r#""cable": {"type": "nurbs", "degree": 2, "knots": [0, 0, 0, 1, 1, 1], "control_points": [[0, 0], [4, 0], [4, 5]]}, "#;
    let error = build_all(&(spline.to_owned() + &motion(r#""along": "cable""#)), "").unwrap_err();
    assert!(error.contains("a `fair-spline` of tension 0"), "{error}");
}

/// Tables of loggers: other units of time, and what no column has is 0, as is said.
#[test]
fn tables_of_loggers_are_read() {
    let read = |table: &str| build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), table).unwrap().pop().unwrap();
    for table in [
        "timestamp,x,y,z\n1700000000,0,0,0\n1700000002,30,0,0\n",
        "#timestamp tx ty tz qx qy qz qw\n0 0 0 0 0 0 0 1\n2 30 0 0 0 0 0 1\n",
        "time_ns,x,y,z\n0,0,0,0\n2000000000,30,0,0\n",
        "time [us],x,y,z\n0,0,0,0\n2000000,30,0,0\n",
        "time [min],x,y,z\n0,0,0,0\n0.033333333333333333,30,0,0\n",
    ] {
        let built = read(table);
        assert!((built.item.motion().unwrap().duration() - 2.0).abs() < 1e-12 && built.remarks.is_empty(), "{table}");
    }
    for (table, absent) in
        [("x,y,yaw_deg\n0,0,0\n30,0,90\n", "z, roll, pitch"), ("x,y,z,yaw_deg\n0,0,0,0\n30,0,0,90\n", "roll, pitch")]
    {
        let built = read(table);
        let pose = built.item.motion().unwrap().schedule().unwrap().pose(1.0);
        assert!((pose.rotation().rotate(Vec3::X) - Vec3::Y).length() < 1e-15);
        assert!((pose.translation() - Vec3::X * 30.0).length() < 1e-15);
        // A quarter turn goes round, which is reported too.
        let [remark, leaves] = &built.remarks[..] else { panic!("{:?}", built.remarks) };
        assert_eq!(leaves.reason, "leaves-chords");
        assert!(remark.reason == "taken-as-zero" && remark.message.contains(absent), "{remark:?}");
    }
}

/// Matrices as one list, by columns, and with few decimals.
#[test]
fn matrices_of_other_programs_are_read_or_told() {
    let with = |matrix: &str| build(&motion(&format!(r#""poses": [{{"position": [0, 0]}}, {{"matrix": {matrix}}}]"#)));
    let end = |matrix: &str| with(matrix).unwrap().item.motion().unwrap().schedule().unwrap().pose(1.0);
    let rows = end("[[0, -1, 0, 30], [1, 0, 0, 2], [0, 0, 1, 10]]");
    for flat in ["[0, -1, 0, 30, 1, 0, 0, 2, 0, 0, 1, 10]", "[0, -1, 0, 30, 1, 0, 0, 2, 0, 0, 1, 10, 0, 0, 0, 1]"] {
        assert!(end(flat).angle_to(rows) < 1e-15 && (end(flat).translation() - rows.translation()).length() < 1e-15);
    }
    for (matrix, says) in [
        ("[0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 30, 2, 10, 1]", "column-major order"),
        ("[[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 1, 0], [30, 2, 10, 1]]", "column-major order"),
        ("[0, -1, 0, 1, 0, 0, 0, 0, 1]", "or 12 or 16 numbers row by row, not 9 numbers"),
        ("[[0, -1, 0, 30], 1, 2]", "not both"),
        ("[[0, -1, 0], [1, 0, 0], [0, 0, 1]]", "3 values are given, 4 are needed"),
        ("[[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]]", "off by 7, limit 0.002"),
    ] {
        let error = with(matrix).unwrap_err();
        assert!(error.contains(says), "{error}");
    }
    // Four decimals of a turn about a slanted axis: the nearest rotation is nearer than the digits.
    let meant = Pose::new(cyclide::Quat::new(0.8, 0.3, -0.4, 0.2), Vec3::ZERO).unwrap();
    let text = |decimals: i32| {
        let unit = 10_f64.powi(decimals);
        let rows = meant.to_matrix().map(|row| row.map(|v| (v * unit).round() / unit));
        serde_json::to_string(&rows[..3]).unwrap()
    };
    for decimals in [3, 4] {
        let built = with(&text(decimals)).unwrap();
        assert!(end(&text(decimals)).angle_to(meant) < 2.0 * 0.1_f64.powi(decimals));
        let [remark] = &built.remarks[..] else { panic!("{:?}", built.remarks) };
        assert_eq!((remark.reason, remark.place.as_deref()), ("matrices-rounded", Some("objects.m.poses[1]")));
    }
    assert!(with(&text(6)).unwrap().remarks.is_empty() && with(&text(2)).is_err());
}
