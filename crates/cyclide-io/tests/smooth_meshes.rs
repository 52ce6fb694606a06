//! Smooth surfaces over triangles in documents: every source of a mesh, their files and the check of these, the report, what is
//! remarked and what is refused.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fmt::Write as _;
use std::path::Path;

use cyclide::{
    Point3,
    model::{Model, SurfaceObject, Units},
    surface::TriangleSurface,
};
use cyclide_io::{
    Document, ExportOptions, Exporter, Format, ModelBuilder, Report,
    document::BuiltObject,
    formats::read_back,
    report::{FileReport, GeometryReport, SmoothReport},
};
use cyclide_testkit::mutate::{Form, Mutator};
use cyclide_testkit::scan::scan;

type Files<'a> = &'a [(&'a str, Vec<u8>)];

/// Builds the last object of a document; `files` are those that it may read.
fn build_all(objects: &str, files: Files<'_>) -> Result<BuiltObject, String> {
    let text = format!("{{\"cyclide\": 1, \"units\": \"m\", \"objects\": {{\n{objects}\n}} }}");
    let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
    let read = |path: &Path| {
        let found = files.iter().find(|(name, _)| path == Path::new(name));
        found.map(|(_, bytes)| bytes.clone()).ok_or_else(|| std::io::ErrorKind::NotFound.into())
    };
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).map_err(|e| e.to_string())?;
    builder.build(document.objects.len() - 1, &mut |_| {}).map_err(|e| e.to_string())
}

fn build_with(fields: &str, files: Files<'_>) -> Result<BuiltObject, String> {
    build_all(&format!("\"p\": {{\"type\": \"smooth-mesh\", {fields}}}"), files)
}

fn surface(built: &BuiltObject) -> &TriangleSurface {
    built.item.surfaces()[0].as_triangles().unwrap()
}

fn report(built: &BuiltObject) -> SmoothReport {
    let report = Report::new(Units::Metre, std::slice::from_ref(built), None);
    match &report.objects[built.item.name.as_str()].geometry {
        GeometryReport::Smooth(report) => report.clone(),
        _ => panic!("a smooth surface"),
    }
}

fn reasons(built: &BuiltObject) -> Vec<&'static str> {
    built.remarks.iter().map(|remark| remark.reason).collect()
}

/// An octahedron of small numbers, which single precision holds.
const POINTS: [[f64; 3]; 6] =
    [[4.0, 0.0, 0.0], [-4.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, -3.0, 0.0], [0.0, 0.0, 2.5], [0.5, 0.0, -2.0]];
const TRIANGLES: [[usize; 3]; 8] =
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];

fn inline(triangles: &[[usize; 3]]) -> String {
    format!("\"vertices\": {POINTS:?}, \"triangles\": {triangles:?}")
}

fn obj() -> String {
    let mut text = String::new();
    POINTS.iter().for_each(|[x, y, z]| writeln!(text, "v {x} {y} {z}").unwrap());
    TRIANGLES.iter().for_each(|[a, b, c]| writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap());
    text
}

fn stl() -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((TRIANGLES.len() as u32).to_le_bytes());
    for triangle in TRIANGLES {
        bytes.extend([0; 12]);
        triangle.iter().flat_map(|v| POINTS[*v]).for_each(|x| bytes.extend((x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn ply(big_endian: bool) -> Vec<u8> {
    let order = if big_endian { "big" } else { "little" };
    let mut bytes = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n\
         element face 8\nproperty list uchar uint vertex_indices\nend_header\n"
    )
    .into_bytes();
    for x in POINTS.as_flattened().iter().map(|x| *x as f32) {
        bytes.extend(if big_endian { x.to_be_bytes() } else { x.to_le_bytes() });
    }
    for triangle in TRIANGLES {
        bytes.push(3);
        for v in triangle.map(|v| v as u32) {
            bytes.extend(if big_endian { v.to_be_bytes() } else { v.to_le_bytes() });
        }
    }
    bytes
}

/// The mesh with the second axis up, as glTF has it.
fn glb() -> Vec<u8> {
    let mut binary: Vec<u8> = Vec::new();
    for [x, y, z] in POINTS {
        [x, z, -y].iter().for_each(|v| binary.extend((*v as f32).to_le_bytes()));
    }
    TRIANGLES.as_flattened().iter().for_each(|v| binary.push(*v as u8));
    let mut text = br#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":96}],
        "bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":24}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"},
        {"bufferView":1,"componentType":5121,"count":24,"type":"SCALAR"}]}"#
        .to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend((12 + 8 + text.len() as u32 + 8 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", text), (b"BIN\0", binary)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

#[test]
fn every_source_gives_the_same_surface() {
    let files = [
        ("a.obj", obj().into_bytes()),
        ("a.stl", stl()),
        ("little.ply", ply(false)),
        ("big.ply", ply(true)),
        ("a.glb", glb()),
    ];
    let expected = build_with(&inline(&TRIANGLES), &[]).unwrap();
    let TriangleSurface::Mesh(expected) = surface(&expected) else { panic!("a mesh") };
    for (name, _) in &files {
        let word = name.split_once('.').unwrap().1;
        let built = build_with(&format!("\"mesh\": {{\"{word}\": \"{name}\"}}"), &files).unwrap();
        assert_eq!(reasons(&built), ["sharp-edges-smoothed"], "{name}");
        let TriangleSurface::Mesh(mesh) = surface(&built) else { panic!("a mesh") };
        // In STL and GLB vertices come in another order; places and normals are the same to the bit.
        for triangle in 0..TRIANGLES.len() {
            let (own, other) = (mesh.triangle(triangle).unwrap(), expected.triangle(triangle).unwrap());
            assert_eq!(own.corners(), other.corners(), "{name}");
            assert_eq!(own.normals(), other.normals(), "{name}");
            // From which end an edge is computed depends on the order of the vertices: rounding.
            let (p, q) = (own.point([1.0, 2.0, 3.0]).unwrap(), other.point([1.0, 2.0, 3.0]).unwrap());
            assert!(p.distance(q) < 1e-14, "{name}");
        }
    }
}

#[test]
fn glb_is_brought_to_the_units_of_the_document() {
    let text = r#"{"cyclide": 1, "units": "mm", "objects": {"p": {"type": "smooth-mesh", "mesh": {"glb": "a.glb"}}}}"#;
    let document = Document::parse("m.json", text.as_bytes()).unwrap();
    let read = |_: &Path| Ok(glb());
    let built = ModelBuilder::new(&document, Path::new(""), &read).unwrap().build(0, &mut |_| {}).unwrap();
    assert_eq!(reasons(&built), ["unit-of-file", "sharp-edges-smoothed"]);
    let patch = surface(&built).patch(0).unwrap();
    assert_eq!(patch.corners()[1], Point3::new(0.0, 3000.0, 0.0));
}

fn model(built: &BuiltObject) -> Model {
    Model { units: Units::Metre, items: vec![built.item.clone()] }
}

fn options(tolerance: f64) -> ExportOptions {
    ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() }
}

/// The volume of the meshes of a file.
fn volume(format: Format, bytes: &[u8]) -> f64 {
    read_back(format, bytes).unwrap().meshes.iter().map(cyclide::mesh::SurfaceMesh::volume).sum()
}

#[test]
fn files_are_watertight_within_their_bound() {
    let built = build_with(&format!("{}, \"normals\": \"sphere\"", inline(&TRIANGLES)), &[]).unwrap();
    let (model, measured) = (model(&built), report(&built));
    let exporter = Exporter::new(&model).unwrap();
    for tolerance in [0.3, 0.02] {
        for format in [Format::Glb, Format::Obj, Format::Stl] {
            let file = exporter.export(format, &options(tolerance)).unwrap();
            assert!(file.sampled && file.bound > 0.3 * tolerance && file.bound <= tolerance * (1.0 + 1e-4));
            let report = exporter.check(Path::new("a"), format, &file).unwrap();
            assert_eq!(report.proof, "sampled");
            let deviation = report.deviation.unwrap();
            // A reserve of a quarter lies between what is sampled and the bound.
            assert!(deviation <= file.bound && deviation > 0.6 * file.bound, "{format:?} {tolerance}: {deviation:e}");
            // That every side is shared is part of the check; the volume is within a layer of the bound.
            let off = (volume(format, &file.bytes) - measured.volume.unwrap()).abs();
            assert!(off < 1.1 * deviation * measured.area, "{format:?} {tolerance}: {off:e}");
        }
    }
}

#[test]
fn formats_of_exact_surfaces_are_refused_by_name() {
    let built = build_with(&inline(&TRIANGLES), &[]).unwrap();
    let model = model(&built);
    let exporter = Exporter::new(&model).unwrap();
    for format in [Format::Step, Format::Json, Format::Svg] {
        let error = exporter.export(format, &ExportOptions::default()).unwrap_err();
        assert_eq!(error.reason(), "no-exact-form");
        assert!(error.to_string().contains("object p") && error.to_string().contains("GLB"), "{error}");
    }
    for format in [Format::Dxf, Format::Csv] {
        assert_eq!(exporter.export(format, &ExportOptions::default()).unwrap_err().reason(), "not-in-format");
    }
}

/// Changes one line of an OBJ file.
fn changed(bytes: &[u8], keyword: &str, number: usize, change: impl Fn(&str) -> String) -> Vec<u8> {
    let text = std::str::from_utf8(bytes).unwrap();
    let mut seen = 0;
    let lines = text.lines().map(|line| {
        let mine = line.split(' ').next() == Some(keyword);
        seen += usize::from(mine);
        if mine && seen == number + 1 { change(line) } else { line.to_owned() }
    });
    let mut text: String = lines.filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n");
    text.push('\n');
    text.into_bytes()
}

#[test]
fn damage_to_a_mesh_is_found() {
    let built = build_with(&inline(&TRIANGLES), &[]).unwrap();
    let model = model(&built);
    let exporter = Exporter::new(&model).unwrap();
    let whole = exporter.export(Format::Obj, &options(0.05)).unwrap();
    let checked = |bytes: Vec<u8>| {
        let mut file = whole.clone();
        file.bytes = bytes;
        FileReport::new(Path::new("a.obj"), Format::Obj, &model, &file).map(|report| report.deviation)
    };
    let same = checked(changed(&whole.bytes, "f", 9, str::to_owned)).unwrap().unwrap();
    assert!(same > 0.0 && same <= whole.bound);
    let corners = |line: &str| line.split(' ').map(str::to_owned).collect::<Vec<_>>();
    let moved = |by: f64| {
        move |line: &str| {
            let mut words = corners(line);
            words[1] = (words[1].parse::<f64>().unwrap() + by).to_string();
            words.join(" ")
        }
    };
    // A vertex inside, moved by more than the bound; less than rounding is no damage.
    let message = |bytes: Vec<u8>| checked(bytes).unwrap_err().to_string();
    assert!(message(changed(&whole.bytes, "v", 40, moved(2.0 * whole.bound))).contains("is displaced"));
    assert!(checked(changed(&whole.bytes, "v", 40, moved(1e-14))).is_ok());
    // A triangle turned over, one in the place of another, one less, and a normal turned by a thousandth.
    let turned = |line: &str| {
        let words = corners(line);
        format!("f {} {} {}", words[2], words[1], words[3])
    };
    assert!(message(changed(&whole.bytes, "f", 17, turned)).contains("has the wrong orientation"));
    let text = String::from_utf8(whole.bytes.clone()).unwrap();
    let faces: Vec<&str> = text.lines().filter(|line| line.starts_with("f ")).collect();
    let other = |_: &str| faces[30].to_owned();
    assert!(checked(changed(&whole.bytes, "f", 3, other)).is_err());
    assert!(message(changed(&whole.bytes, "f", 3, |_| String::new())).contains("polygons"));
    assert!(message(changed(&whole.bytes, "vn", 40, moved(1e-3))).contains("normal"));
    // Torn: a vertex of its own at the same place.
    let torn = |line: &str| {
        let mut words = corners(line);
        let (position, normal) = words[1].split_once("//").unwrap();
        let _ = position;
        words[1] = format!("{}//{normal}", text.lines().filter(|line| line.starts_with("v ")).count());
        words.join(" ")
    };
    assert!(checked(changed(&whole.bytes, "f", 3, torn)).is_err());
}

/// The table of the comparison with PN triangles.
#[test]
fn the_report_compares_with_flat_and_pn_triangles() {
    let t = 0.5 + 1.25_f64.sqrt();
    let points = [
        [-1.0, t, 0.0],
        [1.0, t, 0.0],
        [-1.0, -t, 0.0],
        [1.0, -t, 0.0],
        [0.0, -1.0, t],
        [0.0, 1.0, t],
        [0.0, -1.0, -t],
        [0.0, 1.0, -t],
        [t, 0.0, -1.0],
        [t, 0.0, 1.0],
        [-t, 0.0, -1.0],
        [-t, 0.0, 1.0],
    ];
    let triangles = [
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    let built = build_with(&format!("\"vertices\": {points:?}, \"triangles\": {triangles:?}"), &[]).unwrap();
    let report = report(&built);
    assert!(report.closed && (report.triangles, report.vertices, report.creases) == (20, 12, 0));
    let radius = 1.0_f64.hypot(t);
    // The sphere but for 4.3e-4 of its radius.
    let sphere = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
    assert!(
        (report.volume.unwrap() / sphere - 1.0).abs() < 3.0 * 4.3e-4 && report.volume_error < 1e-4 * sphere,
        "{report:?}"
    );
    let c = report.comparison.unwrap();
    assert!((c.flat_jump.to_degrees() - 41.81).abs() < 0.01 && (c.pn_jump.to_degrees() - 15.8).abs() < 0.1);
    assert!(c.jump < 1e-12, "{:e}", c.jump);
    // The height of the sphere over the middle of a triangle; PN triangles are 5.9e-2 of the radius off it.
    let inradius = t * t / 3.0_f64.sqrt();
    assert!((c.from_flat / (radius - inradius) - 1.0).abs() < 0.01, "{}", c.from_flat);
    assert!(c.from_pn > 0.05 * radius && c.from_pn < 0.07 * radius, "{}", c.from_pn);
    let text = Report::new(Units::Metre, std::slice::from_ref(&built), None).to_string();
    assert!(text.contains("closed, 20 triangles") && text.contains("PN triangles"), "{text}");
}

#[test]
fn open_borders_and_creases_are_reported() {
    // Two squares that meet at a right angle, of two triangles each.
    let fields = r#""vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0],[1,0,1],[1,1,1]],
        "triangles": [[0,1,2],[0,2,3],[1,4,5],[1,5,2]]"#;
    let creased = report(&build_with(&format!("{fields}, \"crease_angle\": {{\"degrees\": 60}}"), &[]).unwrap());
    assert_eq!((creased.creases, creased.free_edges, creased.closed), (1, 6, false));
    assert!(creased.volume.is_none());
    // Flat on both sides, so that it is the two squares.
    assert!((creased.area - 2.0).abs() < 1e-12, "{}", creased.area);
    let smooth = report(&build_with(fields, &[]).unwrap());
    assert!(smooth.creases == 0 && smooth.crease_angle.is_none() && smooth.area > 1.9);
    assert!(smooth.comparison.unwrap().jump < 1e-12);
}

#[test]
fn normals_of_a_file_make_creases_where_a_vertex_has_several() {
    let roof = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 4 0 -2\nv 4 2 -2\nvn 0 0 1\nvn 0.7071 0 0.7071\n";
    let several = format!("{roof}f 1//1 2//1 3//1 4//1\nf 2//2 5//2 6//2 3//2\n");
    let one = format!("{roof}f 1/5/1 2/5/1 3/5/1 4/5/1\nf 2/5/1 5/5/2 6/5/2 3/5/1\n");
    let files =
        [("a.obj", several.into_bytes()), ("b.obj", one.into_bytes()), ("c.obj", roof.replace("vn", "#").into_bytes())];
    let built = |name: &str| build_with(&format!("\"mesh\": {{\"obj\": \"{name}\"}}, \"normals\": \"file\""), &files);
    let creased = built("a.obj").unwrap();
    assert_eq!(reasons(&creased), ["polygons-cut"]);
    let creased = report(&creased);
    assert_eq!((creased.creases, creased.normals, creased.polygons), (1, Some("file"), Some(2)));
    assert!((creased.area - (4.0 + 4.0 * 2.0_f64.sqrt())).abs() < 1e-3, "flat but for the digits: {}", creased.area);
    assert_eq!(report(&built("b.obj").unwrap()).creases, 0);
    // Faces without normals.
    let bare = [("c.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec())];
    let message = build_with(r#""mesh": {"obj": "c.obj"}, "normals": "file""#, &bare).unwrap_err();
    assert!(message.contains("objects.p.normals") && message.contains("\"angle\" or \"sphere\""), "{message}");
    let message = build_with(r#""mesh": {"stl": "a.stl"}, "normals": "file""#, &[("a.stl", stl())]).unwrap_err();
    assert!(message.contains("STL has normals of triangles"), "{message}");
}

#[test]
fn what_is_changed_is_remarked() {
    let with = format!("{}v 9 9 9\nv 4 0 0\nf 1 8 3\nf 1 3 1\n", obj());
    let built = build_with(r#""mesh": {"obj": "a.obj"}"#, &[("a.obj", with.into_bytes())]).unwrap();
    let changes = ["polygons-without-area", "vertices-merged", "vertices-unused", "sharp-edges-smoothed"];
    assert_eq!(reasons(&built), changes);
    assert_eq!(built.remarks[0].index, Some(8));
    assert!(report(&built).closed);
    let turned = TRIANGLES.map(|[a, b, c]| [a, c, b]);
    let inside_out = build_with(&inline(&turned), &[]).unwrap();
    assert_eq!(reasons(&inside_out), ["inside-out", "sharp-edges-smoothed"]);
    let round = build_with(&format!("{}, \"normals\": \"sphere\"", inline(&TRIANGLES)), &[]).unwrap();
    assert!(round.remarks.is_empty(), "{:?}", round.remarks);
    assert!(report(&inside_out).volume.unwrap() < 0.0);
    // A normal that looks away from its triangle.
    let mut normals = POINTS;
    normals[4] = [1.0, 0.0, -0.2];
    let backward = build_with(&format!("{}, \"normals\": {normals:?}", inline(&TRIANGLES)), &[]).unwrap();
    assert_eq!(reasons(&backward)[0], "normal-faces-backward");
}

/// In the numbers of the file: the first polygon is a point twice, and its vertices stand twice.
#[test]
fn warnings_of_the_surface_name_the_polygons_of_the_file() {
    let corners = [[0, 0, 0], [9, 0, 0], [0, 9, 0], [9, 9, 0], [0, 0, 1], [9, 0, 1], [0, 9, 1], [9, 9, 1]];
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut text = "v 0 0 0\n".to_owned();
    corners.iter().for_each(|[x, y, z]| writeln!(text, "v {x} {y} {z}").unwrap());
    text += "f 1 2 1\n";
    quads.iter().for_each(|quad| writeln!(text, "f {}", quad.map(|v| (v + 2).to_string()).join(" ")).unwrap());
    let files = [
        ("plate.obj", text.clone().into_bytes()),
        ("open.obj", text.replace("f 6 7 9 8\n", "f 6 7 9\nv 0.00001 0 1\nf 10 9 8\n").into_bytes()),
    ];
    let plate = build_with(r#""mesh": {"obj": "plate.obj"}"#, &files).unwrap();
    let sharp = plate.remarks.iter().find(|remark| remark.reason == "sharp-edges-smoothed").unwrap();
    assert!(sharp.message.contains("12 edge(s)") && sharp.message.contains("90.0 degrees"), "{}", sharp.message);
    // A corner of the upper side stands a hundred-thousandth beside its place: the side hangs together no more.
    let open = build_with(r#""mesh": {"obj": "open.obj"}, "crease_angle": 0.5"#, &files).unwrap();
    let seam = open.remarks.iter().find(|remark| remark.reason == "open-seam").unwrap();
    assert!(seam.message.contains("weld"), "{}", seam.message);
    let creased = build_with(r#""mesh": {"obj": "plate.obj"}, "crease_angle": 0.5"#, &files).unwrap();
    assert!(reasons(&creased).iter().all(|reason| reason.starts_with("polygons-") || reason.starts_with("vertices-")));
}

#[test]
fn what_cannot_be_made_smooth_is_refused_with_its_place() {
    let message = |fields: &str| build_with(fields, &[]).unwrap_err();
    let third = [TRIANGLES.as_slice(), &[[0, 2, 3]]].concat();
    let mut zero = POINTS;
    zero[2] = [0.0; 3];
    // A triangle that is turned over is mended; a Möbius strip has no sides.
    let strip = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    for (fields, place, reason) in [
        (inline(&third), "objects.p.triangles[", "non-manifold-edge"),
        (inline(&strip), "objects.p.triangles[", "inconsistent-orientation"),
        (inline(&[[0, 1, 0]]), "objects.p.triangles", "no-triangles"),
        (inline(&[[0, 1, 6]]), "objects.p.triangles[0][2]", "no-such-vertex"),
        (
            r#""vertices": [[0,0,0],[1,0,0],[2,0,0],[0,1,0]], "triangles": [[0,1,3],[0,2,1]]"#.to_owned(),
            "objects.p.triangles[1]",
            "degenerate-triangle",
        ),
        (format!("{}, \"crease_angle\": 4", inline(&TRIANGLES)), "objects.p.crease_angle", "angle-out-of-range"),
        (format!("{}, \"normals\": [[0,0,1]]", inline(&TRIANGLES)), "objects.p.normals", "count-differs"),
        (format!("{}, \"normals\": {zero:?}", inline(&TRIANGLES)), "objects.p.normals[2]", "undefined-normal"),
    ] {
        let message = message(&fields);
        assert!(message.contains(place) && message.contains(&format!("[{reason}]")), "{message}");
    }
    for (fields, text) in [
        (format!("{}, \"normals\": \"file\"", inline(&TRIANGLES)), "there is no file"),
        (format!("{}, \"normals\": \"mean\"", inline(&TRIANGLES)), "mean"),
        (format!("{}, \"crease_angle\": 1, \"normals\": {POINTS:?}", inline(&TRIANGLES)), "requires the normals"),
        (r#""vertices": [[0,0,0],[1,0,0],[0,1,0]]"#.to_owned(), "either `mesh`"),
    ] {
        let message = message(&fields);
        assert!(message.contains(text), "{message}");
    }
    // Of a file the message says the polygon and where its points are.
    let with = format!("{}f 1 3 4\n", obj());
    let message = build_with(r#""mesh": {"obj": "a.obj"}"#, &[("a.obj", with.into_bytes())]).unwrap_err();
    assert!(message.contains("of a.obj, at (4, 0, 0)"), "{message}");
    let message = build_with(r#""mesh": {"ply": "a.ply"}"#, &[("a.ply", b"%PDF-1.4".to_vec())]).unwrap_err();
    assert!(message.contains("is a drawing, not a mesh (PLY)"), "{message}");
}

#[test]
fn similar_images_are_made_and_no_others() {
    let base = format!("\"a\": {{\"type\": \"smooth-mesh\", {}}}", inline(&TRIANGLES));
    let image = |steps: &str| {
        build_all(&format!("{base}, \"b\": {{\"type\": \"transform\", \"of\": \"a\", \"steps\": [{steps}]}}"), &[])
    };
    let whole = report(&build_with(&inline(&TRIANGLES), &[]).unwrap());
    let built = image(r#"{"scale": {"factor": 2}}, {"mirror": {"normal": [1, 2, 2]}}"#).unwrap();
    let mirrored = report(&built);
    // Exact but for rounding: the outer side stays outside.
    assert!((mirrored.volume.unwrap() / (8.0 * whole.volume.unwrap()) - 1.0).abs() < 1e-13);
    assert!((mirrored.area / (4.0 * whole.area) - 1.0).abs() < 1e-13 && mirrored.normals.is_none());
    let message = image(r#"{"inversion": {"center": [9, 0, 0], "radius": 5}}"#).unwrap_err();
    assert!(message.contains("[not-a-similarity]"), "{message}");
    for derived in [
        r#""type": "offset", "of": "a", "distance": 1"#,
        r#""type": "offset", "of": "a", "distance": 1, "thick": true"#,
    ] {
        assert!(build_all(&format!("{base}, \"b\": {{{derived}}}"), &[]).unwrap_err().contains("smooth-mesh"));
    }
}

#[test]
fn sphere_blends_of_documents() {
    let blend = |fields: &str| build_all(&format!("\"b\": {{\"type\": \"sphere-blend\", {fields}}}"), &[]);
    // All on the sphere of radius 5 about the origin: the patch is a piece of it.
    let corners = r#""corners": [[3,4,0],[-3,4,0],[0,3,4]]"#;
    let built = blend(&format!(r#"{corners}, "control": [[0,5,0],[1.4,4.8,0],[0,4.8,1.4]]"#)).unwrap();
    let patch = surface(&built).patch(0).unwrap();
    for at in [[1.0, 1.0, 1.0], [3.0, 1.0, 0.0], [1.0, 5.0, 2.0]] {
        let (p, n) = patch.point_and_normal(at).unwrap();
        assert!((p.to_vec().length() - 5.0).abs() < 1e-14 && (n - p.to_vec() / 5.0).length() < 1e-14);
    }
    let model = model(&built);
    let exporter = Exporter::new(&model).unwrap();
    for format in [Format::Glb, Format::Obj, Format::Stl] {
        let file = exporter.export(format, &options(1e-3)).unwrap();
        let report = exporter.check(Path::new("a"), format, &file).unwrap();
        assert!(report.deviation.unwrap() <= file.bound && file.bound <= 1.001e-3);
    }
    assert_eq!(exporter.export(Format::Step, &options(1e-3)).unwrap_err().reason(), "no-exact-form");
    let measured = report(&built);
    assert!(
        measured.comparison.is_none() && measured.free_edges == 3 && measured.area_error < 1e-4 * measured.area,
        "{measured:?}"
    );
    for (fields, place, reason) in [
        (format!(r#"{corners}, "control": [[0,5,0],[3,4,0],[5,0,0]]"#), "control[1]", "control-point-on-circumcircle"),
        // On the same sphere, and on the other side of the plane.
        (format!(r#"{corners}, "control": [[0,5,0],[0,5,0],[5,0,0]]"#), "control", "opposite-spheres"),
        (format!(r#"{corners}, "normals": [[0,1,0],[0,0,0],[0,1,0]]"#), "normals[1]", "undefined-normal"),
        (
            r#""corners": [[0,0,0],[1,0,0],[2,0,0]], "normals": [[0,0,1],[0,0,1],[0,0,1]]"#.to_owned(),
            "corners",
            "degenerate-triangle",
        ),
        (
            r#""corners": [[1,0,0],[-0.5,0.8,0],[-0.5,-0.8,0]], "normals": [[0,0,1],[0,0,-1],[0,0,-1]]"#.to_owned(),
            "normals",
            "opposite-spheres",
        ),
        (
            r#""corners": [[1,0,0],[-0.5,0.8,0],[-0.5,-0.8,0]], "normals": [[0,0,-1],[0,0,-1],[0,0,-1]]"#.to_owned(),
            "normals",
            "patch-through-infinity",
        ),
    ] {
        let message = blend(&fields).unwrap_err();
        assert!(
            message.contains(&format!("objects.b.{place}")) && message.contains(&format!("[{reason}]")),
            "{message}"
        );
    }
    assert!(blend(corners).unwrap_err().contains("exactly one of `control`"));
}

/// A scan of 5,000 triangles with noise, through every format that holds it.
#[test]
fn a_scan_of_five_thousand_triangles_becomes_smooth() {
    let (points, triangles) = scan(2502);
    assert_eq!(triangles.len(), 5000);
    let mesh = cyclide::surface::SmoothMesh::new(&points, &triangles, cyclide::surface::VertexNormals::SphereWeighted)
        .unwrap();
    let flat = mesh.tessellate(1).unwrap();
    let (measure, comparison) = (mesh.measure().unwrap(), mesh.comparison().unwrap());
    let volume = measure.volume.unwrap();
    // The smooth surface bulges out of its triangles where these are convex.
    assert!(volume > flat.volume() && volume < 1.01 * flat.volume(), "{volume} {}", flat.volume());
    assert!(comparison.jump < 1e-9 && comparison.pn_jump > 1e-2, "{comparison:?}");
    let model = Model::new(Units::Millimetre).with_surface("scan", SurfaceObject::from(mesh));
    let exporter = Exporter::new(&model).unwrap();
    let holds_it = |format| {
        let file = exporter.export(format, &options(0.1)).unwrap();
        let report = exporter.check(Path::new("a"), format, &file).unwrap();
        assert!(report.deviation.unwrap() <= file.bound);
        let content = read_back(format, &file.bytes).unwrap();
        let read: f64 = content.meshes.iter().map(cyclide::mesh::SurfaceMesh::volume).sum();
        assert!((read - volume).abs() < 1.1 * file.bound * measure.area, "{format:?}");
    };
    std::thread::scope(|scope| {
        for format in [Format::Glb, Format::Obj, Format::Stl] {
            scope.spawn(move || holds_it(format));
        }
    });
}

/// Files broken at random are read or refused, and never make the program fall.
#[test]
fn broken_files_are_read_or_refused() {
    const WORDS: [&str; 10] =
        ["f 1 2 3\n", "vn 0 0 1\n", "3 0 1 2\n", "list", "uchar", "\"count\":", "null", "[]", "\"mode\":5", "-1"];
    let files = [
        ("a.obj", obj().into_bytes(), Form::Bytes),
        ("a.stl", stl(), Form::Bytes),
        ("a.ply", ply(true), Form::Bytes),
        ("a.glb", glb(), Form::Container),
    ];
    for (name, bytes, form) in files {
        let word = name.split_once('.').unwrap().1;
        let fields = format!("\"mesh\": {{\"{word}\": \"{name}\"}}");
        let mut mutator = Mutator::new(5, &WORDS);
        let mut refused = 0;
        for _ in 0..400 {
            let broken = mutator.copy(&bytes, form);
            refused += usize::from(build_with(&fields, &[(name, broken)]).is_err());
        }
        // Some changes do no harm.
        assert!(refused > 40 && refused < 400, "{name}: {refused}");
    }
}
