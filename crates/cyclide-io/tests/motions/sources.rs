//! What motions are made of, and what is made of them: tables of matrices, curves that carry, a body at rest.

use crate::{build, build_all, end, motion};
use cyclide::{Pose, Vec3};
use cyclide_io::BuiltObject;

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
        (format!("x,y,z,{twelve}\n0,0,0,{}\n", rows[0]), "the positions are there twice"),
        (format!("roll,pitch,yaw,{twelve}\n0,0,0,{}\n", rows[0]), "the rotations are there twice"),
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
