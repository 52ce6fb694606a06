//! Whole cyclides and their nodes.

use cyclide::{Point3, surface::ParamSurface as _};
use cyclide_io::Report;

use super::{build, surface};

#[test]
fn whole_cyclides_in_any_place() {
    // A torus: volume 2 pi² R r², area 4 pi² R r. Five segments become six: 0 and pi are always among the joints.
    let placed = r#""center": [1,2,3], "axis": [0,1,0], "segments": [5, 6]"#;
    let built = build(&format!(r#""t": {{"type": "cyclide", "a": 3, "mu": 1, {placed}}}"#)).unwrap();
    let torus = surface(&built);
    assert_eq!((torus.patches, torus.bodies, torus.free_edges, torus.joints.creases), (36, 1, 0, 0));
    let pi2 = std::f64::consts::PI.powi(2);
    assert!((torus.volume.unwrap() / (6.0 * pi2) - 1.0).abs() < 1e-11, "{:?}", torus.volume);
    assert!((torus.area.unwrap() / (12.0 * pi2) - 1.0).abs() < 1e-11);
    assert!(torus.joints.gap < 1e-14 && torus.joints.angle < 1e-13, "{:?}", torus.joints);
    for face in built.bodies[0].outer.faces() {
        let p = face.surface.patch().unwrap().point(0.3, 0.7) - Point3::new(1.0, 2.0, 3.0);
        assert!((((p.x * p.x + p.z * p.z).sqrt() - 3.0).hypot(p.y) - 1.0).abs() < 1e-13);
    }
    // A spindle is more than one closed surface.
    let spindle = surface(&build(r#""s": {"type": "cyclide", "a": 2, "c": 1, "mu": 3}"#).unwrap());
    assert!(spindle.bodies > 1 && spindle.closed && spindle.flipped.is_empty(), "{spindle:?}");
}

#[test]
fn nodes_are_named_and_curvatures_have_no_bounds_there() {
    // The horn 5, 3, 1: th = acos(1/3), nodes at (a mu/c, ±b sqrt(1 - mu²/c²), 0). Two by four patches between them,
    // four by four round the other way.
    let horn = build(r#""h": {"type": "cyclide", "a": 5, "c": 3, "mu": 1}"#).unwrap();
    let report = surface(&horn);
    assert!(report.flipped.is_empty());
    let places: Vec<_> = report.singular.iter().map(|p| (p.place.body, p.place.patch)).collect();
    let outer = [0, 3, 4, 7, 8, 11, 12, 15].map(|patch| (1, patch));
    assert_eq!(places, (0..8).map(|patch| (0, patch)).chain(outer).collect::<Vec<_>>());
    for patch in &report.singular {
        assert!(patch.t.is_empty() && patch.s.len() == 1 && [0.0, 1.0].contains(&patch.s[0]), "{patch:?}");
        let [x, y, z] = patch.points[0];
        let want = 4.0 * (8.0_f64 / 9.0).sqrt();
        assert!((x - 5.0 / 3.0).abs() < 1e-14 && (y.abs() - want).abs() < 1e-14 && z.abs() < 1e-14, "{patch:?}");
    }
    // k2 = -1/|mu - c cos th| is flattest at th = 0 and pi: -1/2, -1/4; k1 = ±1/(a ± mu) and less.
    let [s, t] = [report.curvature_s, report.curvature_t];
    assert!(t.min == f64::NEG_INFINITY && (t.max + 0.25).abs() < 1e-13, "{t:?}");
    assert!((s.min + 0.25).abs() < 1e-13 && (s.max - 0.25).abs() < 1e-13, "{s:?}");
    assert_eq!([s.unbounded, t.unbounded], [None, Some("below: towards the points named in `singular`")]);
    let text = Report::new(cyclide::model::Units::Millimetre, &[horn], None).to_string();
    assert!(
        text.contains("along s -0.25 to 0.25 1/mm; along t -0.25 1/mm and less, unbounded at singular points\n"),
        "{text}"
    );
    assert!(text.contains("\n  singular   16: patch 0 of body 0 at s = 0; "), "{text}");
    assert!(!text.contains("flipped") && !text.contains("infinite"), "{text}");
    // The single node of a spindle with mu = a, a double zero of the speed.
    let one = surface(&build(r#""s": {"type": "cyclide", "a": 5, "c": 1, "mu": 5}"#).unwrap());
    assert!(one.curvature_s.min.abs() < 1.0 && one.curvature_s.max == f64::INFINITY, "{:?}", one.curvature_s);
    assert_eq!(one.curvature_s.unbounded, Some("above: towards the points named in `singular`"));
    assert!(one.curvature_t.min.abs() < 1.0 && one.curvature_t.max.abs() < 1.0, "{:?}", one.curvature_t);
    assert_eq!(one.singular.len(), 8);
}
