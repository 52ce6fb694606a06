//! Surfaces of documents: every type is built, and what is refused is shown at its place.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::Path;

use cyclide::{ParamSurface as _, Point3, SurfaceObject, Vec3};
use cyclide_io::{BuiltObject, Document, Error, GeometryReport, ModelBuilder, Report, Spacing, sample};

/// Builds the last object of a document with these objects, written one per line from line 2.
fn build(objects: &str) -> Result<BuiltObject, String> {
    let text = format!("{{\"cyclide\": 1, \"objects\": {{\n{objects}\n}} }}");
    let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
    let read = |_: &Path| Err(std::io::ErrorKind::NotFound.into());
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).map_err(|e| e.to_string())?;
    builder.build(document.objects.len() - 1, &mut |_| {}).map_err(|e| e.to_string())
}

fn point(built: &BuiltObject, s: f64, t: f64) -> Point3 {
    built.bodies[0].outer.faces()[0].surface.patch().unwrap().point(s, t)
}

/// An eighth of the sphere of radius 2 about (1, 0, 0), with a pole at its last two corners.
const OCTANT: &str =
    r#""o": {"type": "cyclide-patch", "corners": [[3,0,0],[1,2,0],[1,0,2],[1,0,2]], "frame": [[0,3,0],[0,0,1]]}"#;
const CIRCLE: &str = r#""c": {"type": "circle", "center": [5, 0], "radius": 1}"#;

#[test]
fn a_patch_and_its_report() {
    let built = build(OCTANT).unwrap();
    assert!(matches!(built.item.surfaces(), [SurfaceObject::Patch(_)]));
    let center = Point3::new(1.0, 0.0, 0.0);
    for (s, t) in [(0.2, 0.1), (0.5, 0.5), (0.9, 0.3), (0.0, 1.0)] {
        assert!((point(&built, s, t).distance(center) - 2.0).abs() < 1e-14);
    }
    let report = Report::new(cyclide::Units::Metre, &[built], None);
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
fn offsets_and_images() {
    let grown = build(&format!(r#"{OCTANT}, "b": {{"type": "offset", "of": "o", "distance": 0.5}}"#)).unwrap();
    assert!((point(&grown, 0.3, 0.6).distance(Point3::new(1.0, 0.0, 0.0)) - 2.5).abs() < 1e-14);
    let steps = r#"[{"scale": {"factor": 2, "center": [1,0]}}, {"translation": [0,0,1]},
        {"rotation": {"angle": 1.5707963267948966, "center": [1,0]}}, {"mirror": {"normal": [0,0,2]}},
        {"matrix": [[[1,0,0,0],[0,1,0,0]],[[0,0,0,0],[1,0,0,0]]]}]"#;
    let moved = build(&format!(r#"{OCTANT}, "b": {{"type": "transform", "of": "o", "steps": {steps}}}"#)).unwrap();
    assert!((point(&moved, 0.3, 0.6).distance(Point3::new(2.0, 0.0, -1.0)) - 4.0).abs() < 1e-13);
    // The start (3,0,0) by hand: (5,0,0), (5,0,1), (1,4,1), (1,4,-1), (2,4,-1).
    assert!(point(&moved, 0.0, 0.0).distance(Point3::new(2.0, 4.0, -1.0)) < 1e-14);
    // Inversion in the unit sphere about (1,0,0) keeps the centre and takes the radius 2 to 1/2.
    let inverted = build(&format!(
        r#"{OCTANT}, "b": {{"type": "transform", "of": "o", "steps": [{{"inversion": {{"center": [1,0], "radius": 1}}}}]}}"#
    ))
    .unwrap();
    assert!((point(&inverted, 0.3, 0.6).distance(Point3::new(1.0, 0.0, 0.0)) - 0.5).abs() < 1e-14);
    // Curves too, and in any order of the document.
    let text = format!(
        r#"{{"cyclide": 1, "objects": {{"b": {{"type": "transform", "of": "c", "steps": [{{"translation": [0,7]}}]}}, {CIRCLE}}}}}"#
    );
    let document = Document::parse("m.json", text.as_bytes()).unwrap();
    let read = |_: &Path| Ok(Vec::new());
    let built = ModelBuilder::new(&document, Path::new(""), &read).unwrap().build(0, &mut |_| {}).unwrap();
    assert!(built.item.curves()[0].as_curve().point(0.25).distance(Point3::new(5.0, 8.0, 0.0)) < 1e-14);
}

#[test]
fn construction_geometry_is_marked() {
    let built = build(&OCTANT.replace("\"corners\"", "\"construction\": true, \"corners\"")).unwrap();
    assert!(built.construction);
    let text = Report::new(cyclide::Units::Metre, &[built], None).to_string();
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
fn what_is_refused_is_shown_at_its_place() {
    let patch = |corners: &str, frame: &str| {
        format!(r#""a": {{"type": "cyclide-patch", "corners": [{corners}], "frame": [{frame}]}}"#)
    };
    let square = "[0,0],[1,0],[0,1],[1,1]";
    let with = |rest: &str| format!("{OCTANT}, {CIRCLE}, {rest}");
    let transform = |of: &str, step: &str| {
        with(&format!(r#""a": {{"type": "transform", "of": "{of}", "steps": [{{"translation": [1,0]}}, {step}]}}"#))
    };
    for (objects, piece, start) in [
        (
            patch("[0,0],[1,0],[0,1],[1,1.1]", "[1,0],[0,1]"),
            "[1,1.1]",
            "objects.a.corners[3]: the corners are not on one circle: off by 0.049723 of the size, limit 1e-9 [",
        ),
        (patch("[0,0],[1,0],[1,1],[0,1]", "[1,0],[0,1]"), "[0,1]", "objects.a.corners[3]: the sides cross"),
        (patch("[0,0],[0,0],[1,1],[0,1]", "[1,0],[0,1]"), "[0,0]", "objects.a.corners[1]: points 0 and 1 coincide"),
        (patch("[0,0],[1,0],[0,1]", "[1,0],[0,1]"), "[", "objects.a.corners: 3 values are given, 4 are needed"),
        (
            patch("[0,0],[1,0],[0,1], [1,1],[2,2]", "[1,0],[0,1]"),
            "[",
            "objects.a.corners: 5 values are given, 4 are needed",
        ),
        (patch(square, "[1,0],[0,1],[0,0,1]"), "[", "objects.a.frame: 3 values are given, 2 are needed"),
        (
            transform("o", r#"{"scale": {"factor": 2}, "translation": [1,0]}"#),
            "{",
            "objects.a.steps[1]: one name is needed here: give each its own braces",
        ),
        (
            transform("o", r#"{"matrix": [[[1,0,0,0],[0]],[]]}"#),
            "[",
            "objects.a.steps[1].matrix[0][1]: 1 value is given, 4 are needed",
        ),
        (
            patch(square, "[1,0],[1,1]"),
            "[[1,0],[1,1]]",
            "objects.a.frame: the directions of the frame must be perpendicular",
        ),
        (
            patch(square, "[1,0],[0,0]"),
            "[[1,0],[0,0]]",
            "objects.a.frame: the directions of the frame must not be zero",
        ),
        (
            patch(square, "[1,0],[0,1]").replace("\"frame\"", "\"frame_corner\": 4, \"frame\""),
            "4",
            "objects.a.frame_corner: frame_corner = 4",
        ),
        (with(r#""a": {"type": "offset", "of": "x", "distance": 1}"#), "\"x\"", "objects.a.of: there is no object `x`"),
        (
            with(r#""a": {"type": "offset", "of": "c", "distance": 1}"#),
            "\"c\"",
            "objects.a.of: `c` is of type `circle`: only surfaces",
        ),
        (
            with(r#""a": {"type": "offset", "of": "a", "distance": 1}"#),
            "\"a\"",
            "objects.a.of: `a` is made from itself",
        ),
        (
            transform("o", r#"{"inversion": {"center": [4,0], "radius": 1}}"#),
            "",
            "objects.a.steps[1]: a point is at infinity",
        ),
        (transform("o", r#"{"inversion": {"center": [3,0], "radius": 0}}"#), "", "objects.a.steps[1]: the radius"),
        (transform("o", r#"{"rotation": {"axis": [0,0], "angle": 1}}"#), "", "objects.a.steps[1]: the axis is zero"),
        (
            transform("o", r#"{"matrix": [[[1,0,0,0],[1,0,0,0]],[[0,0,0,0],[1,0,0,0]]]}"#),
            "",
            "objects.a.steps[1]: the Möbius matrix",
        ),
        (
            transform("c", r#"{"inversion": {"center": [9,0], "radius": 1}}"#),
            "",
            "objects.a.steps[1]: the map is not a similarity",
        ),
        (transform("o", r#"{"shift": [1,0]}"#), "", "objects.a.steps[1]: unknown variant `shift`"),
    ] {
        let message = build(&objects).map(|b| format!("built {:?}", b.item)).unwrap_err();
        let lines: Vec<&str> = message.lines().collect();
        assert!(lines[0].starts_with("m.json:2:") && lines[0].contains(&format!(": {start}")), "{start}\n{message}");
        if !piece.is_empty() {
            let carets = lines[2].find('^').unwrap()..lines[2].len();
            assert_eq!(&lines[1][carets], piece, "{message}");
        }
    }
}

#[test]
fn long_chains_and_circles_of_references() {
    let link = |i: usize, of: usize| format!(r#""{i}": {{"type": "offset", "of": "{of}", "distance": 0.001}}"#);
    let chain: Vec<String> = (1..2000).map(|i| link(i, i - 1)).collect();
    let base = OCTANT.replacen("\"o\"", "\"0\"", 1);
    let built = build(&format!("{base}, {}", chain.join(", "))).unwrap();
    assert!((point(&built, 0.5, 0.5).distance(Point3::new(1.0, 0.0, 0.0)) - 3.999).abs() < 1e-12);
    let circle: Vec<String> = (0..2000).map(|i| link(i, (i + 1) % 2000)).collect();
    let message = build(&circle.join(", ")).unwrap_err();
    assert!(message.contains("is made from itself"), "{message}");
}

#[test]
fn quads_that_no_patch_fits_into_are_named_by_index() {
    // All corners are on one circle, so that no vertex moves; the sides of both outer quads cross.
    let at = |degrees: f64| format!("[{},{}]", degrees.to_radians().cos(), degrees.to_radians().sin());
    let row = |angles: [f64; 4]| format!("[{}]", angles.map(at).join(","));
    let net =
        |rows: &str| build(&format!(r#""n": {{"type": "cyclidic-net", "grid": [{rows}], "make_circular": true}}"#));
    let message = net(&[row([0.0, 20.0, 40.0, 60.0]), row([110.0, 170.0, 130.0, 150.0])].join(",")).unwrap_err();
    let words = "objects.n.grid[0][0]: quads 0, 2: sides cross or have no length, no patch fits in; \
        no vertex was moved; points are given row by row, all rows in the same direction [crossing-quad]";
    assert!(message.contains(words), "{message}");
    // A quad that crosses itself and has no circle: its corners are moved onto one, and it crosses itself still.
    let message = net("[[0,0,0],[1,0,0.1]],[[1,1,0],[0,1,0]]").unwrap_err();
    let words = "objects.n.grid[0][0]: quad 0: sides cross or have no length, no patch fits in; vertices were moved by up to 0.";
    assert!(message.contains(words) && message.contains(" steps; points are given row by row"), "{message}");
    assert!(!message.contains("NaN"), "{message}");
    // Of objects made by a program, the same without a place.
    let object =
        r#""n": {"type": "cyclidic-net", "grid": [[[0,0,0],[1,0,0.1]],[[1,1,0],[0,1,0]]], "make_circular": true}"#;
    let text = format!(r#"{{"cyclide": 1, "objects": {{{object}}}}}"#);
    let Document { units, objects, .. } = Document::parse("m.json", text.as_bytes()).unwrap();
    let document = Document::from_objects("program", units, objects);
    let read = |_: &Path| Ok(Vec::new());
    let error = ModelBuilder::new(&document, Path::new(""), &read).unwrap().build(0, &mut |_| {}).unwrap_err();
    assert!(error.to_string().starts_with("n: quad 0: sides cross or have no length"), "{error}");
    let Error::RejectedQuads { quads, steps, moved, .. } = error else { panic!("{error}") };
    assert!(quads == [0] && steps > 0 && moved > 0.0 && moved < 1.0, "{quads:?} {steps} {moved}");
    // What was built has no such quad, and says so.
    let report = surface(&net(&[row([0.0, 20.0, 40.0, 60.0]), row([170.0, 150.0, 130.0, 110.0])].join(",")).unwrap());
    assert!(report.circular.unwrap().rejected_quads.is_empty());
}

#[test]
fn joints_are_told_from_creases() {
    // A box of one patch: twelve creases and no smooth joint.
    let thick = r#""a": {"type": "cyclide-patch", "corners": [[0,0],[1,0],[0,1],[1,1]], "frame": [[1,0],[0,1]]},
        "b": {"type": "offset", "of": "a", "distance": 1, "thick": true}"#;
    let text = Report::new(cyclide::Units::Metre, &[build(thick).unwrap()], None).to_string();
    assert!(text.contains("\n  creases    12: gap ") && text.contains(" m, angle up to 1.5708 rad\n"), "{text}");
    assert!(!text.contains("smooth"), "{text}");
}

fn surface(built: &BuiltObject) -> cyclide_io::SurfaceReport {
    let report = Report::new(cyclide::Units::Millimetre, std::slice::from_ref(built), None);
    let Some(GeometryReport::Surface(surface)) = report.objects.into_values().next().map(|o| o.geometry) else {
        panic!("a surface")
    };
    surface
}

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
fn an_offset_with_nodes_is_the_solids_of_its_lobes() {
    // Rings offset inwards to horns: with the nodes inside patches, and on their edges.
    for ([a, c, mu], distance, patches) in [([50, 20, 32], -20, 24), ([4, 1, 2], -2, 16)] {
        let whole = format!(r#"{{"type": "cyclide", "a": {a}, "c": {c}, "mu""#);
        let built =
            build(&format!(r#""r": {whole}: {mu}}}, "o": {{"type": "offset", "of": "r", "distance": {distance}}}"#));
        let offset = surface(&built.unwrap());
        let horn = surface(&build(&format!(r#""h": {whole}: {}}}"#, mu + distance)).unwrap());
        assert_eq!((offset.bodies, offset.patches, offset.free_edges), (2, patches, 0), "{offset:?}");
        // Two lobes have two areas, and no sum; the horn is as many parts.
        assert!(offset.area.is_none() && offset.parts.len() == 2, "{offset:?}");
        let [lobes, parts] = [&offset, &horn].map(|report| report.parts.iter().map(|part| part.area).sum::<f64>());
        assert!((lobes / parts - 1.0).abs() < 1e-11, "{lobes} {parts}");
        assert!((offset.volume.unwrap() / horn.volume.unwrap() - 1.0).abs() < 1e-11);
    }
    // The net is kept: an offset back is the ring again.
    let back = build(
        r#""r": {"type": "cyclide", "a": 4, "c": 1, "mu": 2}, "o": {"type": "offset", "of": "r", "distance": -2},
        "b": {"type": "offset", "of": "o", "distance": 2}"#,
    );
    let ring = surface(&build(r#""r": {"type": "cyclide", "a": 4, "c": 1, "mu": 2}"#).unwrap());
    let back = surface(&back.unwrap());
    assert_eq!((back.bodies, back.patches), (1, 16));
    assert!((back.volume.unwrap() / ring.volume.unwrap() - 1.0).abs() < 1e-12);
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
    let text = Report::new(cyclide::Units::Millimetre, &[horn], None).to_string();
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

#[test]
fn offsets_beyond_the_focal_set_and_on_it() {
    let torus = r#""r": {"type": "cyclide", "a": 4, "mu": 1}"#;
    let offset = |of: &str, name: &str, distance: f64, thick: bool| {
        format!(r#", "{name}": {{"type": "offset", "of": "{of}", "distance": {distance:?}, "thick": {thick}}}"#)
    };
    // Offsets go along the normal of the torus, and back; between, they say that they are flipped.
    let beyond = format!("{torus}{}", offset("r", "o", -2.5, false));
    let report = surface(&build(&beyond).unwrap());
    assert_eq!((report.flipped.len(), report.singular.len()), (16, 0));
    let back = surface(&build(&format!("{beyond}{}", offset("o", "b", 2.5, false))).unwrap());
    assert!(
        back.flipped.is_empty() && (back.area.unwrap() / (16.0 * std::f64::consts::PI.powi(2)) - 1.0).abs() < 1e-12
    );
    let solid = surface(&build(&format!("{beyond}{}", offset("o", "k", 0.2, true))).unwrap());
    let volume = 8.0 * std::f64::consts::PI.powi(2) * (1.5 * 1.5 - 1.3 * 1.3);
    assert!((solid.volume.unwrap() / volume - 1.0).abs() < 1e-11 && solid.flipped.is_empty(), "{:?}", solid.volume);
    // Whole horns grow outwards as a whole.
    let horn = r#""r": {"type": "cyclide", "a": 5, "c": 3, "mu": 1}"#;
    let (small, large) = (surface(&build(horn).unwrap()), format!("{horn}{}", offset("r", "o", 0.1, false)));
    let large = surface(&build(&large).unwrap());
    assert!(large.parts[0].area > small.parts[0].area);
    for (distance, thick, words) in [
        (-1.0, false, "quad 0: the offset at distance -1 lies on the focal set"),
        (
            -1.5,
            true,
            "quad 0: a solid between the surface and its offset at distance -1.5 would run through itself: a centre",
        ),
        (0.0, true, "a solid between a surface and its offset needs a distance other than 0"),
    ] {
        let message = build(&format!("{torus}{}", offset("r", "k", distance, thick))).unwrap_err();
        assert!(message.contains(&format!(": objects.k.distance: {words}")), "{message}");
    }
}

/// A net of two by one quads on a cylinder about the x axis.
const NET: &str = r#""n": {"type": "cyclidic-net", "grid": [[[0,1,0],[1,1,0],[3,1,0]],[[0,0,1],[1,0,1],[3,0,1]]]}"#;

#[test]
fn nets_with_their_skins_and_edges() {
    let net = surface(&build(NET).unwrap());
    assert_eq!((net.patches, net.joints.count, net.free_edges), (2, 1, 6));
    let quarter = std::f64::consts::FRAC_PI_2;
    // The frame follows the edges: the straight ones lie on the cylinder, the chords of its circles are turned equally.
    assert!(net.joints.gap < 1e-15 && net.joints.angle < 1e-14 && net.singular.is_empty());
    let framed = NET.replace("]]]}", r#"]]], "frame": [[1,0,0],[0,0,5]]}"#);
    let cylinder = surface(&build(&framed).unwrap());
    assert!((cylinder.area.unwrap() / (3.0 * quarter) - 1.0).abs() < 1e-12, "{:?}", cylinder.area);
    let thick = |distance: f64| {
        format!(r#"{framed}, "t": {{"type": "offset", "of": "n", "distance": {distance}, "thick": true}}"#)
    };
    for distance in [0.5, -0.5] {
        let solid = build(&thick(distance)).unwrap();
        let report = surface(&solid);
        // Between the radii 1 and 1 + distance or 1 - distance: the normal f_s x f_t points inward here.
        let other = 1.0 - distance;
        let volume = 3.0 * quarter / 2.0 * (1.0 - other * other).abs();
        assert!((report.volume.unwrap() / volume - 1.0).abs() < 1e-11, "{:?} {volume}", report.volume);
        assert_eq!((report.free_edges, report.closed), (0, true));
        assert!(report.joints.creases > 0);
        // Two quarters of a cylinder and four rims, each with its own area; nobody is told the sum for one skin's.
        let skins = [1.0_f64.max(other), 1.0_f64.min(other)].map(|radius| 3.0 * quarter * radius);
        assert_eq!((report.parts.len(), report.parts[0].patches, report.parts[1].patches), (6, 2, 2));
        for (part, skin) in report.parts.iter().zip(skins) {
            assert!((part.area / skin - 1.0).abs() < 1e-12, "{part:?} {skin}");
        }
        assert_eq!(report.area, None);
        let text = Report::new(cyclide::Units::Metre, std::slice::from_ref(&solid), None).to_string();
        let areas = text.lines().find(|line| line.starts_with("  areas ")).unwrap();
        assert!(areas.contains("  6: ") && areas.contains("; 3 more; together "), "{text}");
        // Thick shells are mapped as wholes, and have no offset of their own.
        let moved = format!(
            r#"{}, "m": {{"type": "transform", "of": "t", "steps": [{{"mirror": {{"normal": [1,1,0]}}}}]}}"#,
            thick(distance)
        );
        assert!((surface(&build(&moved).unwrap()).volume.unwrap() / volume - 1.0).abs() < 1e-11);
        let again = format!(r#"{}, "m": {{"type": "offset", "of": "t", "distance": 1}}"#, thick(distance));
        let error = build(&again).unwrap_err();
        assert!(
            error.contains("`t` is of type `offset`: only patches, nets and cyclides that are not thick"),
            "{error}"
        );
    }
    let edges = build(&format!(r#"{framed}, "e": {{"type": "support-structure", "of": "n"}}"#)).unwrap();
    assert_eq!(edges.item.curves().len(), 7);
    let length: f64 = edges.item.curves().iter().map(|c| cyclide::length(c.as_curve())).sum();
    assert!((length - (6.0 + 3.0 * quarter)).abs() < 1e-13);
}

#[test]
fn refused_nets_and_cyclides() {
    for (object, piece, start) in [
        (
            NET.replace("[3,0,1]", "[3,0,1.1]"),
            "[1,1,0]",
            "objects.n.grid[0][1]: quad 1: the corners are not on one circle",
        ),
        (NET.replace(",[3,0,1]", ""), "[[0,0,1],[1,0,1]]", "objects.n.grid[1]: row 1 has 2 points, the first has 3"),
        (
            NET.replace("]]]}", r#"]]], "frame": [[1,0],[1,1]]}"#),
            "[[1,0],[1,1]]",
            "objects.n.frame: the directions of the frame must be perpendicular",
        ),
        (NET.replace("]]]}", r#"]]], "frame": "best"}"#), "\"best\"", "objects.n.frame: unknown variant `best`"),
        (
            NET.replace("]]]}", r#"]]], "closed": [false, true]}"#),
            "[[[0,1,0],[1,1,0],[3,1,0]],[[0,0,1],[1,0,1],[3,0,1]]]",
            "objects.n.grid: too few points",
        ),
        (r#""c": {"type": "cyclide", "a": 1, "c": 2, "mu": 1}"#.to_owned(), "2", "objects.c.c: c = 2 is outside"),
        (r#""c": {"type": "cyclide", "a": 1, "mu": 0}"#.to_owned(), "0", "objects.c.mu: mu = 0 is outside"),
        (
            r#""c": {"type": "cyclide", "a": 2, "mu": 1, "segments": [4, 2]}"#.to_owned(),
            "2",
            "objects.c.segments[1]: segments along t = 2",
        ),
        (
            r#""c": {"type": "cyclide", "a": 2, "mu": 1, "axis": [0,0]}"#.to_owned(),
            "[0,0]",
            "objects.c.axis: the axis is zero",
        ),
    ] {
        let message = build(&object).map(|b| format!("built {:?}", b.item)).unwrap_err();
        let lines: Vec<&str> = message.lines().collect();
        assert!(lines[0].starts_with("m.json:2:") && lines[0].contains(&format!(": {start}")), "{start}\n{message}");
        let carets = lines[2].find('^').unwrap()..lines[2].len();
        assert!(piece.starts_with(&lines[1][carets.clone()]), "{message}");
    }
}

/// Three by three points of a quarter of a cylinder about the x axis, as a net with a field more.
fn cylinder(field: &str) -> String {
    let row = |angle: f64| {
        let place = |x: f64| format!("[{x}, {}, {}]", angle.cos(), angle.sin());
        format!("[{}]", [0.0, 1.0, 2.0].map(place).join(","))
    };
    let rows = [0.0, 0.8, 1.6].map(row).join(",");
    format!(r#""n": {{"type": "cyclidic-net", "grid": [{rows}]{field}}}"#)
}

#[test]
fn a_frame_that_folds_its_net_is_warned_of() {
    let suits = build(&cylinder(r#", "frame": [[1, 0, 0], [0, 0, 1]]"#)).unwrap();
    assert!(suits.remarks.is_empty(), "{:?}", suits.remarks);
    assert!(build(&cylinder("")).unwrap().remarks.is_empty());

    // The directions of s and t exchanged.
    let folded = build(&cylinder(r#", "frame": [[0, 0, 1], [1, 0, 0]]"#)).unwrap();
    let report = Report::new(cyclide::Units::Metre, std::slice::from_ref(&folded), None);
    let GeometryReport::Surface(surface) = &report.objects["n"].geometry else { panic!("a surface") };
    let [remark] = &folded.remarks[..] else { panic!("one remark: {:?}", folded.remarks) };
    assert_eq!((remark.reason, remark.index), ("folded-net", Some(surface.singular[0].place.patch)));
    assert!(
        remark.message.starts_with(&format!("{} singular patch(es)", surface.singular.len())),
        "{}",
        remark.message
    );
    assert!(remark.message.ends_with("use the frame \"auto\" or another one"), "{}", remark.message);
    // Offsets and whole cyclides with nodes are no such nets.
    let horn = build(r#""c": {"type": "cyclide", "a": 4, "c": 2, "mu": 1.5}"#).unwrap();
    assert!(horn.remarks.is_empty(), "{:?}", horn.remarks);
}

#[test]
fn refusals_name_the_factor_the_steps_and_the_curve() {
    for (factor, words) in [("0", "the scale factor 0 is not positive"), ("-2", "the scale factor -2 is not positive")]
    {
        let scaled = format!(
            r#"{CIRCLE}, "b": {{"type": "transform", "of": "c", "steps": [{{"scale": {{"factor": {factor}}}}}]}}"#
        );
        let message = build(&scaled).unwrap_err();
        assert!(message.contains(words) && message.contains("[scale-not-positive]"), "{message}");
    }
    let message = build(&cylinder(r#", "make_circular": {"max_steps": 0}"#)).unwrap_err();
    let words = "objects.n.make_circular.max_steps: max_steps = 0 is out of range: at least 1 [";
    assert!(message.contains(words), "{message}");

    // The whole side lies behind one end of the segment.
    let far = r#""far": {"type": "arc-spline", "points": [[-9, 0], [-8, 0]], "construction": true}, "#;
    let on_far = cylinder(r#", "make_circular": {"border": {"first_row": "far"}}"#);
    let message = build(&(far.to_owned() + &on_far)).unwrap_err();
    let words = "objects.n.make_circular.border: vertices 0 and 1 fall together on the curve of their side";
    assert!(message.contains(words) && message.contains("[collapsed-on-curve]"), "{message}");
}

#[test]
fn seams_that_do_not_close_name_the_ratio_only_where_there_is_one() {
    let message =
        |stretch| cyclide::Error::NetDoesNotClose { direction: 0, angle: 0.25, stretch, limit: 1e-9 }.to_string();
    assert!(message(0.0).ends_with("the frame is off by 0.25 radians, limit 1e-9"), "{}", message(0.0));
    let slower = message(-1.91e-6);
    assert!(slower.ends_with("of the lines across by the factor 1 - 1.91e-6, limit 1e-9"), "{slower}");
}

#[test]
fn revolutions_are_solids_where_the_profile_closes() {
    let profile =
        r#""p": {"type": "arc-spline", "points": [[0, 0, 0], [3, 0, 1], [2, 0, 4], [0, 0, 5]], "construction": true}"#;
    let with = |rest: &str| format!(r#"{profile}, "v": {{"type": "revolution", "of": "p"{rest}}}"#);
    let solid = surface(&build(&with("")).unwrap());
    assert!(solid.closed && solid.bodies == 1 && solid.free_edges == 0, "{solid:?}");
    assert!(solid.volume.unwrap() > 0.0 && solid.joints.gap < 1e-14);
    // A part of a turn has that part of the volume, between two flat ends; the turned part has that part of the area.
    let half = surface(&build(&with(r#", "angle": {"degrees": 180}"#)).unwrap());
    assert!(half.closed && half.parts.len() == 2 && half.bodies == 1, "the ends lie in one plane: {half:?}");
    assert!((half.volume.unwrap() / solid.volume.unwrap() - 0.5).abs() < 1e-11);
    assert!((half.parts[0].area / solid.area.unwrap() - 0.5).abs() < 1e-12);
    let third = surface(&build(&with(r#", "angle": {"degrees": -120}"#)).unwrap());
    assert!((third.volume.unwrap() / solid.volume.unwrap() - 1.0 / 3.0).abs() < 1e-11);
    let [_, one, other] = &third.parts[..] else { panic!("two ends: {third:?}") };
    for end in [one.area, other.area] {
        assert!((end / (0.5 * half.parts[1].area) - 1.0).abs() < 1e-12);
    }
    // About another axis, moved along with it.
    let turned = r#""m": {"type": "transform", "of": "p", "construction": true,
        "steps": [{"rotation": {"angle": {"degrees": -90}, "axis": [0, 1, 0]}}, {"translation": [5, 6, 7]}]}"#;
    let other = format!(
        r#"{profile}, {turned}, "v": {{"type": "revolution", "of": "m", "axis": [-2, 0, 0], "center": [1, 6, 7]}}"#
    );
    let other = surface(&build(&other).unwrap());
    assert!((other.volume.unwrap() / solid.volume.unwrap() - 1.0).abs() < 1e-12);
}

#[test]
fn pipes_follow_arcs_and_segments() {
    let run = r#""run": {"type": "polyline", "points": [[0, 0, 0], [30, 0, 0], [30, 20, 0], [30, 20, 25]],
        "radius": [0, 6, 8, 0], "construction": true}"#;
    let with = |rest: &str| format!(r#"{run}, "pipe": {{"type": "pipe", "of": "run"{rest}}}"#);
    let length = 75.0 - (6.0 + 8.0) * (2.0 - std::f64::consts::FRAC_PI_2);
    let pipe = surface(&build(&with(r#", "radius": 3, "wall": 1"#)).unwrap());
    assert!(pipe.closed && pipe.bodies == 1 && pipe.free_edges == 0);
    assert!((pipe.volume.unwrap() / (std::f64::consts::PI * 5.0 * length) - 1.0).abs() < 1e-12);
    let open = surface(&build(&with(r#", "radius": 3, "ends": "open""#)).unwrap());
    assert!(!open.closed && open.free_edges == 8);
    assert!((open.area.unwrap() / (std::f64::consts::TAU * 3.0 * length) - 1.0).abs() < 1e-12);
    let spline = r#""s": {"type": "circle-spline", "points": [[0, 0, 0], [30, 0, 0], [30, 20, 10], [30, 20, 25]], "construction": true}"#;
    let about = |rest: &str| format!(r#"{spline}, "pipe": {{"type": "pipe", "of": "s", "radius": 1{rest}}}"#);
    assert!(surface(&build(&about(r#", "tolerance": 0.01"#)).unwrap()).closed);
    for (objects, place, reason) in [
        (about(""), "objects.pipe.of", "[not-of-arcs]"),
        (about(r#", "tolerance": -1"#), "objects.pipe.tolerance", "[tolerance-not-positive]"),
        (with(r#", "radius": 0"#), "objects.pipe.radius", "[radius-not-positive]"),
        (with(r#", "radius": 6"#), "objects.pipe.radius", "[pipe-too-wide]"),
        (with(r#", "radius": 3, "wall": 3"#), "objects.pipe.wall", "[parameter-out-of-range]"),
        (
            r#""p": {"type": "polyline", "points": [[0, 0], [9, 0], [9, 9]], "radius": 10}"#.to_owned(),
            "objects.p.points[1]",
            "[bend-does-not-fit]",
        ),
        (
            r#""p": {"type": "polyline", "points": [[0, 0], [9, 0], [9, 9]], "radius": [0, 1]}"#.to_owned(),
            "objects.p.radius",
            "[count-differs]",
        ),
    ] {
        let error = build(&objects).unwrap_err().to_string();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
    let error = build(r#""t": {"type": "cyclide", "a": 3, "mu": 1}, "v": {"type": "pipe", "of": "t", "radius": 1}"#);
    assert!(error.unwrap_err().to_string().contains("only curves have a pipe about them"));
}

#[test]
fn pipes_that_run_into_each_other_are_warned_of() {
    let rods = |second: &str, pipe: &str| {
        build(&format!(
            r#""r": {{"type": "polyline", "points": [[[-40, 0, 0], [40, 0, 0]], {second}], "construction": true}},
            "p": {{"type": "pipe", "of": "r", {pipe}}}"#
        ))
        .unwrap()
    };
    let reasons = |built: &BuiltObject| built.remarks.iter().map(|remark| remark.reason).collect::<Vec<_>>();
    // Across, touching with plane ends, beside, and end to end: only what has a part in common is warned of.
    for (second, pipe, found) in [
        ("[[0, -40, 30], [0, 40, 30]]", r#""radius": 20"#, &["pipes-meet"][..]),
        ("[[0, -40, 40], [0, 40, 40]]", r#""radius": 20"#, &[]),
        ("[[-40, 41, 0], [40, 41, 0]]", r#""radius": 20"#, &[]),
        ("[[40, 0, 0], [80, 0, 0]]", r#""radius": 20"#, &[]),
        ("[[40, 0, 0], [80, 0, 0]]", r#""radius": 20, "ends": "round""#, &["pipes-meet"]),
        ("[[0, 0, 0], [0, 40, 0]]", r#""radius": 5"#, &["pipes-meet"]),
    ] {
        let built = rods(second, pipe);
        assert_eq!(reasons(&built), found, "{second} {pipe}");
        assert_eq!(built.bodies.len(), 2);
    }
    let crossing = rods("[[0, -40, 30], [0, 40, 30]]", r#""radius": 20"#);
    assert_eq!(crossing.remarks[0].contour, Some(1));
    assert!(crossing.remarks[0].message.contains("(30 from spine to spine)"), "{}", crossing.remarks[0].message);
}

#[test]
fn fields_of_pipes_without_effect_are_named() {
    let pipe = |closed: bool, rest: &str| {
        let built = build(&format!(
            r#""r": {{"type": "polyline", "points": [[0, 0], [50, 0], [50, 50], [0, 50]], "radius": 9, "closed": {closed}, "construction": true}},
            "p": {{"type": "pipe", "of": "r", "radius": 2, {rest}}}"#
        ))
        .unwrap();
        built.remarks.iter().map(|remark| (remark.reason, remark.place.clone().unwrap())).collect::<Vec<_>>()
    };
    let named = |field: &str| vec![("no-effect", format!("objects.p.{field}"))];
    assert_eq!(pipe(true, r#""ends": "round""#), named("ends"));
    assert_eq!(pipe(false, r#""ends": "round""#), []);
    assert_eq!(pipe(false, r#""ends": "open", "wall": 1"#), named("ends"));
    assert_eq!(pipe(false, r#""tolerance": 0.1"#), named("tolerance"));
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

#[test]
fn revolutions_that_are_none_are_refused_in_their_place() {
    let curve =
        |points: &str, kind: &str| format!(r#""p": {{"type": {kind}, "points": {points}, "construction": true}}"#);
    let of = |curve: &str, rest: &str| format!(r#"{curve}, "v": {{"type": "revolution", "of": "p"{rest}}}"#);
    let straight = curve("[[1, 0, 0], [2, 0, 1], [1, 0, 3]]", r#""arc-spline""#);
    for (objects, place, reason) in [
        (of(&curve("[[-1, 0, 0], [2, 0, 1], [1, 0, 3]]", r#""arc-spline""#), ""), "objects.v.of", "[crosses-axis]"),
        (of(&straight, r#", "axis": [0, 0, 0]"#), "objects.v.axis", "[zero-axis]"),
        (of(&straight, r#", "angle": 7"#), "objects.v.angle", "[angle-out-of-range]"),
        (of(&straight, r#", "angle": 0"#), "objects.v.angle", "[angle-out-of-range]"),
        (
            of(
                &curve(
                    "[[1, 0, 0], [2, 0, 1], [1, 0, 3], [2, 1, 4]]",
                    r#""circle-spline", "variant": "trigonometric""#,
                ),
                "",
            ),
            "objects.v.of",
            "[not-a-spline]",
        ),
    ] {
        let error = build(&objects).unwrap_err().to_string();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
    let error =
        build(r#""t": {"type": "cyclide", "a": 3, "mu": 1}, "v": {"type": "revolution", "of": "t"}"#).unwrap_err();
    assert!(error.to_string().contains("only curves sweep a surface of revolution"), "{error}");
}

#[test]
fn necks_are_surfaces_or_solids() {
    let neck = |rest: &str| {
        build(&format!(
            r#""n": {{"type": "plate-with-neck", "pipe_radius": 10, "ball_radius": 4, "height": 40{rest}}}"#
        ))
    };
    let open = surface(&neck(r#", "plate": [60, 50]"#).unwrap());
    assert!(!open.closed && open.volume.is_none() && open.free_edges == 16, "{open:?}");
    let filled = surface(&neck(r#", "plate": [60, 50], "thickness": 2"#).unwrap());
    assert!(filled.closed && filled.bodies == 1);
    let bored = surface(&neck(r#", "plate": [60, 50], "thickness": 2, "wall": 3"#).unwrap());
    let bore = filled.volume.unwrap() - bored.volume.unwrap();
    assert!((bore / (std::f64::consts::PI * 49.0 * 42.0) - 1.0).abs() < 1e-10, "{bore}");
    // As many degrees as radians, and the same the other way round.
    let lean = |slope: &str| surface(&neck(&format!(r#", "plate": {{"radius": 40}}, "slope": {slope}"#)).unwrap());
    let (degrees, back) = (lean(r#"{"degrees": 30}"#), lean("-0.5235987755982988"));
    assert!((degrees.area.unwrap() / back.area.unwrap() - 1.0).abs() < 1e-10);
    assert!(surface(&neck(r#", "side": "inside", "thickness": 1.5"#).unwrap()).closed);
    // A large ball of a pipe that leans far.
    let folded = build(
        r#""n": {"type": "plate-with-neck", "pipe_radius": 5, "ball_radius": 9, "height": 70, "slope": {"degrees": 60}, "plate": [99, 150]}"#,
    );
    let folded = folded.unwrap();
    let [remark] = &folded.remarks[..] else { panic!("one remark: {:?}", folded.remarks) };
    assert_eq!((remark.reason, remark.place.as_deref()), ("neck-folds", Some("objects.n.ball_radius")));
    let solid = build(
        r#""n": {"type": "plate-with-neck", "pipe_radius": 5, "ball_radius": 9, "height": 70, "slope": {"degrees": 60}, "plate": [99, 150], "thickness": 3}"#,
    );
    let error = solid.unwrap_err();
    assert!(error.contains("objects.n.ball_radius") && error.contains("[neck-folds]"), "{error}");
}

#[test]
fn necks_that_are_none_are_refused_in_their_place() {
    let plate = r#""plate": [60, 50]"#;
    for (fields, place, reason) in [
        (
            format!(r#""pipe_radius": 0, "ball_radius": 4, "height": 40, {plate}"#),
            "pipe_radius",
            "[radius-not-positive]",
        ),
        (
            format!(r#""pipe_radius": 9, "ball_radius": -4, "height": 40, {plate}"#),
            "ball_radius",
            "[radius-not-positive]",
        ),
        (
            r#""pipe_radius": 9, "ball_radius": 9, "height": 40, "side": "inside""#.to_owned(),
            "ball_radius",
            "[ball-does-not-fit]",
        ),
        (
            format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "slope": {{"degrees": 90}}"#),
            "slope",
            "[angle-out-of-range]",
        ),
        (format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 4, {plate}"#), "height", "[parameter-out-of-range]"),
        (
            r#""pipe_radius": 9, "ball_radius": 4, "height": 40, "plate": {"radius": 13}"#.to_owned(),
            "plate",
            "[plate-too-small]",
        ),
        (
            format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "thickness": 0"#),
            "thickness",
            "[parameter-out-of-range]",
        ),
        (
            format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "thickness": 1, "wall": 9"#),
            "wall",
            "[parameter-out-of-range]",
        ),
        (r#""pipe_radius": 9, "ball_radius": 4, "height": 40"#.to_owned(), "n", "needs a `plate`"),
        (format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "wall": 1"#), "n", "`wall` goes with"),
        (
            format!(r#""pipe_radius": 9, "ball_radius": 4, "height": 40, {plate}, "side": "inside""#),
            "n",
            "leave out `plate`",
        ),
        (r#""pipe_radius": 9, "ball_radius": 4, "height": 40, "plate": 7"#.to_owned(), "n.plate", "expected two sides"),
    ] {
        let error = build(&format!(r#""n": {{"type": "plate-with-neck", {fields}}}"#)).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
}

#[test]
fn bridges_are_surfaces_or_solids_and_refused_in_their_place() {
    let bridge = |rest: &str| build(&format!(r#""b": {{"type": "ellipse-bridge", {rest}}}"#));
    let solid = surface(&bridge(r#""ellipses": [[10, 20], [20, 25]], "depth": 3"#).unwrap());
    assert!(solid.closed && solid.patches == 20);
    assert!(!surface(&bridge(r#""ellipses": [[10, 20], [20, 15]]"#).unwrap()).closed);
    for (fields, place, reason) in [
        (r#""ellipses": [[10, 20], [10, 25]]"#, "objects.b.ellipses", "[coincident-points]"),
        (r#""ellipses": [[10, 20], [10, 25]]"#, "objects.b.ellipses", "the ellipses touch"),
        (r#""ellipses": [[10, -20], [20, 25]]"#, "objects.b.ellipses", "[radius-not-positive]"),
        (r#""ellipses": [[10, 20], [20, 15]], "depth": 3"#, "objects.b.ellipses", "[ellipses-cross]"),
        (r#""ellipses": [[10, 20], [20, 25]], "depth": -3"#, "objects.b.depth", "[parameter-out-of-range]"),
    ] {
        let error = bridge(fields).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
}

#[test]
fn surfaces_between_two_curves_and_what_refuses_them() {
    let rails = r#""a": {"type": "arc", "through": [[0,0,0],[5,1,0],[10,0,0]], "construction": true},
        "b": {"type": "arc", "through": [[0,6,0],[5,8,1],[10,6,0]], "construction": true},
        "p": {"type": "arc-spline", "points": [[0,0,4],[5,1,5],[10,0,4]], "construction": true},
        "k": {"type": "circle", "center": [0, 0, 0], "radius": 5, "construction": true},
        "m": {"type": "transform", "of": "k", "steps": [{"translation": [0, 0, 7]}], "construction": true},
        "two": {"type": "arc-spline", "points": [[[0,0],[1,1]],[[5,5],[6,6]]], "construction": true},
        "solid": {"type": "cyclide", "a": 3, "mu": 1, "construction": true}"#;
    let made = |object: &str| build(&format!(r#"{rails}, "s": {object}"#));
    let vault = made(r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [0, 0, 1]}"#).unwrap();
    let corner = vault.bodies[0].outer.vertices()[0];
    assert!(corner.distance(Point3::ORIGIN) < 1e-15 && surface(&vault).free_edges > 0);
    let each = r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [[0, 0, 1], [1, 0, 1]]}"#;
    assert!(surface(&made(each).unwrap()).area.unwrap() > surface(&vault).area.unwrap() * 0.5);
    // Round: a cylinder.
    let cylinder = surface(&made(r#"{"type": "ruled", "rails": ["k", "m"]}"#).unwrap());
    assert!((cylinder.area.unwrap() / (std::f64::consts::TAU * 5.0 * 7.0) - 1.0).abs() < 1e-12);
    assert_eq!(cylinder.joints.count, cylinder.patches);
    for (object, place, message) in [
        (r#"{"type": "ruled", "rails": ["a", "p"]}"#, "objects.s.rails", "[piece-counts-differ]"),
        (
            r#"{"type": "ruled", "rails": ["a", "p"]}"#,
            "objects.s.rails",
            "the first curve has 1 piece(s), the second 4",
        ),
        (r#"{"type": "ruled", "rails": ["a", "two"]}"#, "objects.s.rails[1]", "has 2 contours"),
        (r#"{"type": "ruled", "rails": ["solid", "a"]}"#, "objects.s.rails[0]", "is no curve"),
        (r#"{"type": "ruled", "rails": ["a", "q"]}"#, "objects.s.rails[1]", "there is no object `q`"),
        (r#"{"type": "ruled", "rails": ["a", "a"]}"#, "objects.s.rails", "[coincident-points]"),
        (
            r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [0, 0, 0]}"#,
            "objects.s.tangent",
            "[zero-tangent]",
        ),
        (
            r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [[0, 0, 1], [0, 0, 0]]}"#,
            "objects.s.tangent[1]",
            "[zero-tangent]",
        ),
        (
            r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [[0, 0, 1], [0, 0, 1], [0, 0, 1]]}"#,
            "objects.s.tangent",
            "[count-differs]",
        ),
        (
            r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [0, -1, 0]}"#,
            "objects.s.tangent",
            "[tangent-opposes-chord]",
        ),
        (
            r#"{"type": "circular-surface", "rails": ["a", "a"], "tangent": [0, 0, 1]}"#,
            "objects.s.rails",
            "[coincident-points]",
        ),
    ] {
        let error = made(object).unwrap_err();
        assert!(error.contains(place) && error.contains(message), "{place} {message}: {error}");
    }
}
