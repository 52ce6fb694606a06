//! Rounded polyhedra of documents: from points, meshes in files, and lists of faces; their report; what is refused.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::f64::consts::PI;
use std::path::Path;

use cyclide_io::{
    Document, ExportOptions, Exporter, Format, ModelBuilder, Report, document::BuiltObject, report::GeometryReport,
};

/// Builds a rounded polyhedron with these fields; `files` are those that it may read.
fn build_with(fields: &str, files: &[(&str, Vec<u8>)]) -> Result<BuiltObject, String> {
    let text =
        format!("{{\"cyclide\": 1, \"objects\": {{\n\"p\": {{\"type\": \"smooth-polyhedron\", {fields}}}\n}} }}");
    let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
    let read = |path: &Path| {
        let found = files.iter().find(|(name, _)| path == Path::new(name));
        found.map(|(_, bytes)| bytes.clone()).ok_or_else(|| std::io::ErrorKind::NotFound.into())
    };
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).map_err(|e| e.to_string())?;
    builder.build(0, &mut |_| {}).map_err(|e| e.to_string())
}

fn build(fields: &str) -> Result<BuiltObject, String> {
    build_with(fields, &[])
}

const CUBE: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [2.0, 0.0, 0.0],
    [0.0, 2.0, 0.0],
    [2.0, 2.0, 0.0],
    [0.0, 0.0, 2.0],
    [2.0, 0.0, 2.0],
    [0.0, 2.0, 2.0],
    [2.0, 2.0, 2.0],
];
const FACES: [[usize; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/// The volume of the cube with the radius 0.5 round it.
fn volume() -> f64 {
    8.0 + 24.0 * 0.5 + 2.0 * PI * 3.0 * 0.25 + 4.0 / 3.0 * PI * 0.125
}

/// The triangles of the cube as binary and as text STL, and as OBJ with points of its own for every face.
fn files() -> Vec<(&'static str, Vec<u8>)> {
    let triangles: Vec<[usize; 3]> = FACES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let mut binary = vec![b' '; 80];
    binary.extend((triangles.len() as u32).to_le_bytes());
    let mut text = "solid cube\n".to_owned();
    for triangle in &triangles {
        binary.extend([0; 12]);
        text += "facet normal 0 0 0\nouter loop\n";
        for k in triangle {
            CUBE[*k].iter().for_each(|x| binary.extend((*x as f32).to_le_bytes()));
            text += &format!("vertex {} {} {}\n", CUBE[*k][0], CUBE[*k][1], CUBE[*k][2]);
        }
        binary.extend([0; 2]);
        text += "endloop\nendfacet\n";
    }
    text += "endsolid cube\n";
    let mut obj = String::new();
    for (k, face) in FACES.iter().enumerate() {
        face.iter().for_each(|v| obj += &format!("v {} {} {}\n", CUBE[*v][0], CUBE[*v][1], CUBE[*v][2]));
        obj += &format!("f {} {} {} {}\n", 4 * k + 1, 4 * k + 2, 4 * k + 3, 4 * k + 4);
    }
    vec![("cube.stl", binary), ("text.stl", text.into_bytes()), ("cube.obj", obj.into_bytes())]
}

#[test]
fn every_source_gives_the_same_body() {
    let points = format!("\"points\": {CUBE:?}");
    let inline = format!("\"vertices\": {CUBE:?}, \"faces\": {FACES:?}");
    let sources = [points.as_str(), &inline, r#""mesh": {"obj": "cube.obj"}"#, r#""mesh": {"stl": "cube.stl"}"#]
        .into_iter()
        .chain([r#""mesh": {"stl": "text.stl"}"#, r#""mesh": {"stl": "cube.stl"}, "hull": true"#]);
    for source in sources {
        let built = build_with(&format!("{source}, \"radius\": 0.5"), &files()).unwrap();
        let report = Report::new(cyclide::model::Units::Millimetre, std::slice::from_ref(&built), None);
        let GeometryReport::Surface(surface) = &report.objects["p"].geometry else { panic!("a surface") };
        assert!(surface.closed && surface.bodies == 1 && surface.joints.creases == 0, "{source}");
        let polyhedron = surface.polyhedron.as_deref().unwrap();
        assert_eq!((polyhedron.faces, polyhedron.edges, polyhedron.vertices), (6, 12, 8), "{source}");
        // Measured on the faces, by the formula, and known.
        let [measured, formula] = [surface.volume.unwrap(), polyhedron.volume];
        assert!((measured / volume() - 1.0).abs() < 1e-11 && (formula / volume() - 1.0).abs() < 1e-13, "{source}");
        assert!((surface.area.unwrap() / polyhedron.area - 1.0).abs() < 1e-11);
        assert!(surface.orthogonality.unwrap() < 1e-14 && surface.curvature_s.min > -2.0 - 1e-12);
        assert!(report.to_string().contains("6 faces, 12 edges, 8 vertices, radius 0.5 mm; by Steiner"), "{report}");
    }
}

/// With the radius 0: planes alone, in every source.
#[test]
fn the_polyhedron_itself_is_a_solid_of_planes() {
    let pyramid = "\"points\": [[5,0,0],[1.5,4.8,0],[-4,3,0],[-4,-3,0],[1.5,-4.8,0],[0,0,4],[0,0,1],[0.2,0.1,0]]";
    for (source, faces, patches) in [
        (format!("\"points\": {CUBE:?}"), 6, 6),
        (r#""mesh": {"stl": "cube.stl"}"#.to_owned(), 6, 6),
        (pyramid.to_owned(), 6, 7),
    ] {
        let built = build_with(&format!("{source}, \"radius\": 0"), &files()).unwrap();
        let report = Report::new(cyclide::model::Units::Millimetre, std::slice::from_ref(&built), None);
        let GeometryReport::Surface(surface) = &report.objects["p"].geometry else { panic!("a surface") };
        let polyhedron = surface.polyhedron.as_deref().unwrap();
        assert!(surface.closed && surface.bodies == 1 && polyhedron.faces == faces && surface.patches == patches);
        let [measured, formula] = [surface.volume.unwrap(), polyhedron.volume];
        assert!((measured / formula - 1.0).abs() < 1e-13, "{source}: {measured} {formula}");
        assert!((built.bodies[0].outer.area() / polyhedron.area - 1.0).abs() < 1e-13, "{source}");
    }
}

/// OpenCASCADE takes an edge below 1e-7 mm for a point, whatever the units of the file; other formats hold it.
#[test]
fn edges_that_readers_take_for_points_are_refused_in_step() {
    let made = |radius: f64, units: cyclide::model::Units| {
        let built = build(&format!("\"points\": {CUBE:?}, \"radius\": {radius:e}")).unwrap();
        let model = cyclide::model::Model { units, items: vec![built.item.clone()] };
        let exporter = Exporter::new(&model).unwrap();
        let step = exporter.export(Format::Step, &ExportOptions::default());
        assert!(exporter.export(Format::Json, &ExportOptions::default()).is_ok());
        step
    };
    let (mm, inch) = (cyclide::model::Units::Millimetre, cyclide::model::Units::Inch);
    let error = made(5e-8, mm).unwrap_err();
    assert_eq!(error.reason(), "edge-too-short");
    assert!(error.to_string().contains("closer than 1e-7 mm"), "{error}");
    // At once: faces beside such an edge would be cut for a minute.
    assert_eq!(made(1e-9, mm).unwrap_err().reason(), "edge-too-short");
    // Half of a quarter of a turn of this radius is longer.
    assert!(!made(2e-7, mm).unwrap().notes.is_empty() && made(1e-5, mm).unwrap().notes.is_empty());
    assert!(made(5e-8, inch).is_ok());
}

#[test]
fn planes_are_planes_in_step_and_cylinders_cylinders() {
    let fields = format!("\"points\": {CUBE:?}, \"radius\": 0.5");
    let built = build(&fields).unwrap();
    let model = cyclide::model::Model { units: cyclide::model::Units::Millimetre, items: vec![built.item.clone()] };
    let exporter = Exporter::new(&model).unwrap();
    let exported = exporter.export(Format::Step, &ExportOptions::default()).unwrap();
    let text = String::from_utf8(exported.bytes.clone()).unwrap();
    let count = |word: &str| text.matches(&format!("={word}(")).count();
    assert_eq!((count("PLANE"), count("CYLINDRICAL_SURFACE"), count("ADVANCED_FACE")), (6, 12, 6 + 12 + 8));
}

#[test]
fn what_is_no_polyhedron_is_refused_at_its_place() {
    let inline = |faces: &[[usize; 4]]| format!("\"vertices\": {CUBE:?}, \"faces\": {faces:?}");
    let inverted = FACES.map(|[a, b, c, d]| [d, c, b, a]);
    let mut wrong = FACES;
    wrong[2][1] = 9;
    let points = format!("\"points\": {CUBE:?}");
    let flat = r#""points": [[0,0], [1,0], [1,1], [0,1], [0.2, 0.7]]"#;
    for (fields, place, reason) in [
        (format!("{points}, \"radius\": -1"), "objects.p.radius", "[radius-not-positive]"),
        (format!("{points}, \"radius\": 1e-12"), "objects.p.radius", "[below-rounding-of-place]"),
        (format!("{points}, \"radius\": 1, \"flatness\": -1"), "objects.p.flatness", "[parameter-out-of-range]"),
        (format!("{}, \"radius\": 1", inline(&FACES[1..])), "objects.p.faces", "[not-closed]"),
        (format!("{}, \"radius\": 1", inline(&inverted)), "objects.p.faces", "[not-convex]"),
        (format!("{}, \"radius\": 1", inline(&wrong)), "objects.p.faces[2][1]", "[not-a-face]"),
        (format!("{flat}, \"radius\": 1"), "objects.p.points", "[flat-polyhedron]"),
        (r#""points": [[0,0], [1,0], [0,1]], "radius": 1"#.to_owned(), "objects.p.points", "[too-few-points]"),
    ] {
        let error = build(&fields).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
    for fields in [
        format!("{points}, \"hull\": true, \"radius\": 1"),
        format!("{points}, \"mesh\": {{\"obj\": \"cube.obj\"}}, \"radius\": 1"),
        format!("\"vertices\": {CUBE:?}, \"radius\": 1"),
        "\"radius\": 1".to_owned(),
    ] {
        assert!(build(&fields).is_err(), "{fields}");
    }
    // A mesh that is not convex, and its hull; the edge is named with its place.
    let tip = "v 1 1 0.5\n";
    let mut obj: String = CUBE.iter().map(|p| format!("v {} {} {}\n", p[0], p[1], p[2])).collect();
    obj += tip;
    for face in [FACES[0], FACES[2], FACES[3], FACES[4], FACES[5]] {
        obj += &format!("f {}\n", face.map(|v| (v + 1).to_string()).join(" "));
    }
    obj += "f 5 6 9\nf 6 8 9\nf 8 7 9\nf 7 5 9\n";
    let files = [("pit.obj", obj.into_bytes()), ("cut.stl", b"solid\nfacet\nvertex 0 0\n".to_vec())];
    let error = build_with(r#""mesh": {"obj": "pit.obj"}, "radius": 1"#, &files).unwrap_err();
    assert!(error.contains("4 of 16 edges are reflex") && error.contains("(1, 1, 0.5)"), "{error}");
    assert!(error.contains("`\"hull\": true`") && error.contains("[not-convex]"), "{error}");
    let hull = build_with(r#""mesh": {"obj": "pit.obj"}, "hull": true, "radius": 0.5"#, &files).unwrap();
    assert!((hull.bodies[0].outer.known_volume().unwrap() / volume() - 1.0).abs() < 1e-11);
    let error = build_with(r#""mesh": {"stl": "cut.stl"}, "radius": 1"#, &files).unwrap_err();
    assert!(error.contains("cut.stl:3:1: a vertex needs three coordinates"), "{error}");
}

#[test]
fn single_precision_is_taken_for_what_it_is() {
    // A turned box, whose triangles are reflex or not by their rounding.
    let (sin, cos) = 0.7_f64.sin_cos();
    let turned = CUBE.map(|[x, y, z]| [x * cos - y * sin, x * sin + y * cos, 100.0 + z * cos + x * sin]);
    let mut binary = vec![b' '; 80];
    let triangles: Vec<[usize; 3]> = FACES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    binary.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        binary.extend([0; 12]);
        triangle.iter().flat_map(|k| turned[*k]).for_each(|x| binary.extend((x as f32).to_le_bytes()));
        binary.extend([0; 2]);
    }
    let built = build_with(r#""mesh": {"stl": "box.stl"}, "radius": 0.1"#, &[("box.stl", binary)]).unwrap();
    let rounded = built.facts.rounded_polyhedron().unwrap();
    assert_eq!((rounded.polyhedron.faces().len(), rounded.polyhedron.corner_count()), (6, 8));
    // By no more than single precision at 100.
    assert!(rounded.moved > 0.0 && rounded.moved < 2e-5, "{}", rounded.moved);
}

/// A building in meters of a map, in an STL file: single precision has steps of 3 cm there, and the walls are cut into faces lower than what
/// counts as flat.
#[test]
fn walls_in_low_triangles_far_from_the_origin_stay_walls() {
    let (east, parts) = (500_000.0, 16);
    let mut binary = vec![b' '; 80];
    let mut triangles: Vec<[[f64; 3]; 3]> = Vec::new();
    let sizes = [20.0, 10.0, 6.0];
    for (axis, end) in (0..3).flat_map(|axis| [(axis, 0), (axis, parts)]) {
        for (i, j) in (0..parts).flat_map(|i| (0..parts).map(move |j| (i, j))) {
            let at = |i: i32, j: i32| {
                let mut key = [0; 3];
                (key[axis], key[(axis + 1) % 3], key[(axis + 2) % 3]) = (end, i, j);
                let [x, y, z] = [0, 1, 2].map(|k| sizes[k] * f64::from(key[k]) / f64::from(parts));
                [east + 0.9 * x - 0.4 * y, 0.4 * x + 0.9 * y, z]
            };
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            triangles.extend(if end == 0 { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] });
        }
    }
    binary.extend((triangles.len() as u32).to_le_bytes());
    for triangle in &triangles {
        binary.extend([0; 12]);
        triangle.as_flattened().iter().for_each(|x| binary.extend((*x as f32).to_le_bytes()));
        binary.extend([0; 2]);
    }
    let built = build_with(r#""mesh": {"stl": "b.stl"}, "radius": 0.5"#, &[("b.stl", binary)]).unwrap();
    let rounded = built.facts.rounded_polyhedron().unwrap();
    assert_eq!((rounded.polyhedron.faces().len(), rounded.polyhedron.corner_count()), (6, 8));
    // To a step of the coordinates over the size.
    let volume = 1200.0 * (0.9 * 0.9 + 0.4 * 0.4);
    assert!((rounded.polyhedron.volume() / volume - 1.0).abs() < 4e-3, "{}", rounded.polyhedron.volume());
    assert!(rounded.moved > 0.0 && rounded.moved < 0.0625, "{}", rounded.moved);
}

#[test]
fn points_of_few_digits_are_told_what_to_give() {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut points: Vec<[f64; 3]> = CUBE.map(|p| p.map(|x| 20.0 * (x - 1.0))).to_vec();
    for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let [x, y] = [a / golden, b * golden].map(|x| (20_000.0 * x).round() / 1000.0);
        points.extend([[0.0, x, y], [x, y, 0.0], [y, 0.0, x]]);
    }
    let fields = format!("\"points\": {points:?}, \"radius\": 4");
    let built = build(&fields).unwrap();
    let [remark] = &built.remarks[..] else { panic!("{:?}", built.remarks) };
    assert!(remark.reason == "shallow-edges" && remark.message.contains("`flatness`"), "{remark:?}");
    assert_eq!(remark.place.as_deref(), Some("objects.p.points"));
    // The flatness that it names does.
    let named = remark.message.split("`flatness`, about ").nth(1).and_then(|rest| rest.split(';').next()).unwrap();
    let built = build(&format!("{fields}, \"flatness\": {named}")).unwrap();
    assert!(
        built.remarks.is_empty() && built.facts.rounded_polyhedron().unwrap().polyhedron.faces().len() == 12,
        "{named}"
    );
    let built = build(&format!("{fields}, \"flatness\": 0.001")).unwrap();
    assert!(built.remarks.is_empty() && built.facts.rounded_polyhedron().unwrap().polyhedron.faces().len() == 12);
    // Four planes of a sharp tip that meet outside it by more than the flatness: refused, with the distance.
    let tip = "\"points\": [[0,0,10],[1,0,0],[0,1,0],[-1,0,0],[0,-1,0],[0.76,0.76,-5],[-0.75,0.75,-5],[-0.76,-0.76,-5],[0.75,-0.75,-5]]";
    let error = build(&format!("{tip}, \"radius\": 0.5, \"flatness\": 0.02")).unwrap_err();
    assert!(error.contains("0.0333") && error.contains("limit 0.02"), "{error}");
    assert!(error.contains("[planes-miss-point]"), "{error}");
}
