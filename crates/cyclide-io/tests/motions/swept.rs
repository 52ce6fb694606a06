//! Files of what moving curves run over: out and back, and over rests.

use crate::{build_all, model};
use cyclide_io::{
    ExportOptions, Exporter, Format,
    report::{GeometryReport, ObjectReport},
};

const CIRCLE: &str =
    r#"{"type": "circle", "center": [0, 0, 0], "radius": 1, "normal": [1, 0, 0], "construction": true}"#;
const BLADE: &str = r#"{"type": "polyline", "points": [[0, 0, 0], [0, 0, 1]], "construction": true}"#;
const TRIANGLE: &str =
    r#"{"type": "polyline", "points": [[0, 0, 0], [0, 0, 1], [0, 1, 1]], "closed": true, "construction": true}"#;

/// Poses at `[x, y, z]`, turned about the third axis, degrees.
fn objects(poses: &[[f64; 4]], profile: &str) -> String {
    let pose =
        |[x, y, z, a]: &[f64; 4]| format!(r#"{{"position": [{x}, {y}, {z}], "rpy": [0, 0, {{"degrees": {a}}}]}}"#);
    let poses: Vec<String> = poses.iter().map(pose).collect();
    format!(
        r#""m": {{"type": "motion", "construction": true, "poses": [{}]}}, "p": {profile}, "s": {{"type": "swept-surface", "of": "m", "profile": "p"}}"#,
        poses.join(", ")
    )
}

fn is_written(objects: &str) {
    let model = model(objects);
    let exporter = Exporter::new(&model).unwrap();
    for format in [Format::Step, Format::Glb, Format::Stl, Format::Obj] {
        let file = exporter.export(format, &ExportOptions::default()).unwrap_or_else(|e| panic!("{format:?} {e}"));
        exporter.check("s".as_ref(), format, &file).unwrap_or_else(|e| panic!("{format:?} {e} {objects}"));
    }
}

/// A surface that was swept there and back is open and is written, whatever the profile.
#[test]
fn what_goes_out_and_back_is_written() {
    let out = [[0.0; 4], [10.0, 0.0, 0.0, 0.0], [0.0; 4]];
    let bent = [[0.0; 4], [10.0, 1.0, 0.0, 10.0], [0.0; 4]];
    for poses in [&out, &bent] {
        for profile in [CIRCLE, BLADE, TRIANGLE] {
            is_written(&objects(poses, profile));
        }
    }
    // With a rest where it turns, and twice.
    is_written(&objects(&[out[0], out[1], out[1], out[2]], CIRCLE));
    is_written(&objects(&[out[0], out[1], out[2], out[1], out[2]], TRIANGLE));
}

/// Rests have no faces: the area is that of the ways, every face has one, and files hold them.
#[test]
fn rests_are_no_part_of_what_is_swept() {
    let turned = [[0.0; 4], [10.0, 0.0, 2.0, 30.0], [10.0, 0.0, 2.0, 30.0], [18.0, 8.0, 4.0, 70.0]];
    let straight = [[0.0; 4], [10.0, 0.0, 0.0, 0.0], [10.0, 0.0, 0.0, 0.0], [20.0, 0.0, 0.0, 0.0]];
    let triangle = [straight[0], straight[0], [20.0, -20.0, 10.0, 45.0], [10.0, -10.0, 20.0, 90.0]];
    for (poses, profile) in [(&turned, CIRCLE), (&straight, CIRCLE), (&triangle, TRIANGLE)] {
        is_written(&objects(poses, profile));
    }
    for (poses, area) in [(&turned, None), (&straight, Some(40.0 * std::f64::consts::PI))] {
        let open = objects(poses, CIRCLE).replace(r#""profile": "p""#, r#""profile": "p", "ends": "open""#);
        let built = build_all(&open, "").unwrap().pop().unwrap();
        let reasons: Vec<&str> = built.remarks.iter().map(|r| r.reason).collect();
        // The body turns other than its path does.
        assert!(reasons == if area.is_some() { vec![] } else { vec!["section-not-across"] }, "{reasons:?}");
        let outer = &built.bodies[0].outer;
        assert!(outer.faces().len().is_multiple_of(2));
        assert!(area.is_none_or(|area| (outer.area() - area).abs() < 1e-9));
    }
    // Its path is a segment with a stop: straight, as long as it is, and more is made of it.
    let with_path = format!(
        r#"{}, "t": {{"type": "trajectory", "of": "m", "point": [0, 0, 1]}}, "r": {{"type": "revolution", "of": "t", "center": [0, 0, 0], "axis": [1, 0, 0]}}, "a": {{"type": "arc-fit", "of": "t", "tolerance": 0.01}}"#,
        objects(&straight, CIRCLE)
    );
    let all = build_all(&with_path, "").unwrap();
    let GeometryReport::Curves(path) = ObjectReport::new(&all[3], None).geometry else { panic!("a curve") };
    assert!((path.length - 20.0).abs() < 1e-9, "{path:?}");
    assert!(path.curvature.max < 1e-9, "{:?}", path.curvature);
    assert!((all[4].bodies[0].outer.area() - 40.0 * std::f64::consts::PI).abs() < 1e-9);
    assert_eq!(all[5].item.curves()[0].as_curve().piece_count(), 1);
    assert!(all[5].remarks.is_empty());
}

/// Between the paths of two points of a body that stops there is a ruled surface.
#[test]
fn paths_that_stop_are_ruled() {
    let turned = [[0.0; 4], [10.0, 0.0, 2.0, 30.0], [10.0, 0.0, 2.0, 30.0], [18.0, 8.0, 4.0, 70.0]];
    let ruled = format!(
        r#"{}, "t": {{"type": "trajectory", "of": "m", "construction": true}}, "u": {{"type": "trajectory", "of": "m", "point": [0, 0, 1], "construction": true}},
        "r": {{"type": "ruled", "rails": ["t", "u"]}}"#,
        objects(&turned, BLADE)
    );
    let all = build_all(&ruled, "").unwrap();
    // The same as what the blade between the points runs over.
    let [swept, between] = [2, 5].map(|k| all[k].bodies[0].outer.area());
    assert!((swept - between).abs() < 1e-9 * swept, "{swept} {between}");
    is_written(&ruled);
}
