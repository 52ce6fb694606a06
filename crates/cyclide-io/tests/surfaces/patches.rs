//! Patches: what their report says, frames, samples, joints.

use cyclide::{Point3, Vec3, model::SurfaceObject};
use cyclide_io::{
    Report,
    report::{GeometryReport, Spacing, sample},
};

use super::{OCTANT, build, point, surface};

#[test]
fn a_patch_and_its_report() {
    let built = build(OCTANT).unwrap();
    assert!(matches!(built.item.surfaces(), [SurfaceObject::Patch(_)]));
    let center = Point3::new(1.0, 0.0, 0.0);
    for (s, t) in [(0.2, 0.1), (0.5, 0.5), (0.9, 0.3), (0.0, 1.0)] {
        assert!((point(&built, s, t).distance(center) - 2.0).abs() < 1e-14);
    }
    let report = Report::new(cyclide::model::Units::Metre, &[built], None);
    let GeometryReport::Surface(surface) = &report.objects["o"].geometry else { panic!("a surface") };
    assert_eq!((surface.patches, surface.bodies, surface.closed, surface.free_edges), (1, 1, false, 3));
    assert_eq!(surface.volume, None);
    // A quarter of pi r², the quadrature's 1e-12.
    assert!((surface.area.unwrap() / (std::f64::consts::PI * 2.0) - 1.0).abs() < 1e-12, "{:?}", surface.area);
    for range in [surface.curvature_s, surface.curvature_t] {
        // Away from the outer side, which is that of f_s x f_t: outside.
        assert!((range.min + 0.5).abs() < 1e-13 && (range.max + 0.5).abs() < 1e-13, "{range:?}");
    }
    assert!(surface.residual.unwrap() < 1e-15 && surface.orthogonality.unwrap() < 1e-14);
    assert!(surface.singular.is_empty() && surface.flipped.is_empty(), "a side of one point is no singular line");
    let text = report.to_string();
    assert!(text.starts_with("o: cyclide-patch, open, 1 patch\n  area       6.2832 m²\n"), "{text}");
}

#[test]
fn a_frame_at_any_corner_and_of_any_length() {
    let patch = |rest: &str| {
        build(&format!(r#""p": {{"type": "cyclide-patch", "corners": [[-40,-30],[40,-30],[-30,40],[30,40]], {rest}}}"#))
            .unwrap()
    };
    let first = patch(r#""frame": [[8,-1,4],[-1,4,3]]"#);
    let longer = patch(r#""frame": [[0.8,-0.1,0.4],[-5,20,15]], "frame_corner": 0"#);
    let frame = first.bodies[0].outer.faces()[0].surface.patch().unwrap().moving_frame(1.0, 0.0);
    let numbers = |v: Vec3| format!("[{},{},{}]", v.x, v.y, v.z);
    let second = patch(&format!(r#""frame": [{}, {}], "frame_corner": 1"#, numbers(frame[0]), numbers(frame[1])));
    for other in [longer, second] {
        // Rounding of unit vectors, times the size 80.
        assert!(point(&first, 0.3, 0.8).distance(point(&other, 0.3, 0.8)) < 1e-12);
    }
}

#[test]
fn construction_geometry_is_marked() {
    let built = build(&OCTANT.replace("\"corners\"", "\"construction\": true, \"corners\"")).unwrap();
    assert!(built.construction);
    let text = Report::new(cyclide::model::Units::Metre, &[built], None).to_string();
    assert!(text.starts_with("o: cyclide-patch, open, 1 patch, construction\n"), "{text}");
}

#[test]
fn samples_lie_on_a_grid_of_every_patch() {
    let text = sample(&build(OCTANT).unwrap(), 3, Spacing::Parameter);
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("patch,s,t,x,y,z,normal_x,normal_y,normal_z,curvature_s,curvature_t"));
    let rows: Vec<Vec<f64>> = lines.map(|l| l.split(',').map(|v| v.parse().unwrap_or(f64::NAN)).collect()).collect();
    assert_eq!(rows.len(), 9);
    assert_eq!(rows[0][..6], [0.0, 0.0, 0.0, 3.0, 0.0, 0.0]);
    assert_eq!(rows[1][1..3], [0.5, 0.0]);
    for row in &rows {
        for i in 0..3 {
            let center = [1.0, 0.0, 0.0];
            assert!((row[3 + i] - center[i] - 2.0 * row[6 + i]).abs() < 1e-14, "{row:?}");
        }
        // At the pole an s-line is one point: no curvature along it.
        assert!((row[9] + 0.5).abs() < 1e-13 || row[2] > 0.75 && row[9].is_nan(), "{row:?}");
        assert!((row[10] + 0.5).abs() < 1e-13, "{row:?}");
    }
}

#[test]
fn joints_are_told_from_creases() {
    // A box of one patch: twelve creases and no smooth joint.
    let thick = r#""a": {"type": "cyclide-patch", "corners": [[0,0],[1,0],[0,1],[1,1]], "frame": [[1,0],[0,1]]},
        "b": {"type": "offset", "of": "a", "distance": 1, "thick": true}"#;
    let text = Report::new(cyclide::model::Units::Metre, &[build(thick).unwrap()], None).to_string();
    assert!(text.contains("\n  creases    12: gap ") && text.contains(" m, angle up to 1.5708 rad\n"), "{text}");
    assert!(!text.contains("smooth"), "{text}");
}

#[test]
fn accuracy_is_said_of_patches_of_cyclides_only() {
    let lines = r#""a": {"type": "polyline", "points": [[0, 0, 0], [10, 0, 0]], "construction": true},
        "b": {"type": "polyline", "points": [[10, 10, 0], [20, 10, 5]], "construction": true},"#;
    let ruled = surface(&build(&format!(r#"{lines} "r": {{"type": "ruled", "rails": ["a", "b"]}}"#)).unwrap());
    assert_eq!((ruled.residual, ruled.orthogonality), (None, None));
    let tube = surface(&build(&format!(r#"{lines} "p": {{"type": "pipe", "of": "a", "radius": 2}}"#)).unwrap());
    assert!(tube.orthogonality.unwrap() < 1e-14);
    // The tube and both disks, parts that creases divide.
    let whole = std::f64::consts::TAU * 2.0 * (10.0 + 2.0);
    assert!((tube.total_area / whole - 1.0).abs() < 1e-12 && tube.area.is_none() && tube.parts.len() == 3);
}

/// Any four corners and directions: exact faces whose edges are arcs, also where one face would have weights that are not positive.
#[test]
fn a_general_patch_and_its_files() {
    let patch = |rest: &str| {
        let corners = "[[-40,-30,0],[40,-30,10],[-30,40,0],[45,45,-15]]";
        build(&format!(
            r#""p": {{"type": "cyclide-patch", "corners": {corners}, "directions": [[8,-1,5],[-1,4,3]]{rest}}}"#
        ))
        .unwrap()
    };
    for (rest, faces) in [("", 1), (r#", "twist": 1"#, 1), (r#", "twist": 50"#, 64)] {
        let built = patch(rest);
        let shell = &built.bodies[0].outer;
        assert_eq!(shell.faces().len(), faces, "{rest}");
        assert!(shell.edges().iter().all(|edge| edge.curve.arc().is_some()));
        assert!(cyclide::topology::surface_joints(shell).iter().all(|joint| joint.angle < 1e-9), "{rest}");
        let report = Report::new(cyclide::model::Units::Metre, &[built], None);
        let GeometryReport::Surface(surface) = &report.objects["p"].geometry else { panic!("a surface") };
        assert_eq!((surface.bodies, surface.closed, surface.patches), (1, false, faces), "{rest}");
        let border = if faces == 1 { 4 } else { 32 };
        assert_eq!(surface.free_edges, border, "{rest}");
    }
}

/// Corners on a circle, perpendicular directions: the patch of a Dupin cyclide, with its offsets.
#[test]
fn a_general_patch_that_is_one_of_a_dupin_cyclide() {
    let corners = "[[-40,-30],[40,-30],[-30,40],[30,40]]";
    let made = |field: &str| {
        let frame = "[[8,-1,4],[-1,4,3]]";
        build(&format!(r#""p": {{"type": "cyclide-patch", "corners": {corners}, "{field}": {frame}}}"#)).unwrap()
    };
    let (frame, directions) = (made("frame"), made("directions"));
    assert!(matches!(directions.item.surfaces(), [SurfaceObject::Patch(_)]));
    for (s, t) in [(0.2, 0.1), (0.9, 0.6)] {
        // Rounding of numbers of the size 80.
        assert!(point(&frame, s, t).distance(point(&directions, s, t)) < 1e-12);
    }
}

#[test]
fn what_no_patch_of_circles_has_is_refused_with_the_way_out() {
    let message = |rest: &str| {
        build(&format!(r#""p": {{"type": "cyclide-patch", "corners": [[0,0],[1,0],[0,1],[1,1,0.5]], {rest}}}"#))
            .unwrap_err()
            .to_string()
    };
    assert!(
        message(r#""frame": [[1,0],[0,1]]"#).contains("with `directions` in place of `frame` they may lie anywhere")
    );
    assert!(message(r#""arcs": [[1,0,0.3],[0,1],[0,1],[1,0]]"#).contains("[arcs-do-not-close]"));
    assert!(message(r#""directions": [[0,0],[0,1]]"#).contains("objects.p.directions[0]"));
    assert!(message(r#""directions": [[1,0],[0,1]], "frame": [[1,0],[0,1]]"#).contains("one of `frame`"));
    assert!(message(r#""twist": 1"#).contains("one of `frame`"));
    assert!(message(r#""directions": [[1,0.1],[0,1]], "twist": "more""#).contains("a number, or a vector"));
}
