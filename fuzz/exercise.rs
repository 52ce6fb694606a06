//! What the fuzz targets do with their bytes, and what the tests do with the crashes that were kept.

#![allow(dead_code, reason = "each target uses its part")]

use std::path::Path;

use cyclide_io::{
    Document, Format, ModelBuilder, Report,
    formats::{MeshFormat, read_back, read_quad_grid},
    input::{PointColumns, read_points},
    text::escaped_lines,
};

/// The points that any file a document refers to holds.
const FILE: &[u8] =
    b"contour,x,y,z,corner\na,0,0,0,1\na,1,0,0,0\na,1,1,0.5,0\na,0,1,0,0\na,0,0,0,0\nb,5,5,5,0\nb,6,5,5,0\nb,7,7,5,0\n";

/// Parses a document, builds its objects, measures them, and formats whatever comes out.
pub fn document(data: &[u8]) {
    let document = match Document::parse("fuzz.json", data) {
        Ok(document) => document,
        Err(message) => return check_message(&message.to_string()),
    };
    let mut objects = Vec::new();
    let read = |_: &Path| Ok(FILE.to_vec());
    let mut builder = match ModelBuilder::new(&document, Path::new("folder"), &read) {
        Ok(builder) => builder,
        Err(error) => return check_message(&error.to_string()),
    };
    for index in 0..document.objects.len() {
        match builder.build(index, &mut |_| {}) {
            Ok(built) => objects.push(built),
            Err(error) => check_message(&error.to_string()),
        }
    }
    let report = Report::new(document.units, &objects, None).to_string();
    assert!(objects.is_empty() || report.contains("length") || report.contains("area"));
}

/// Reads a list of points with and without columns asked for.
pub fn points_csv(data: &[u8]) {
    let named = |names: &[&str]| Some(names.iter().map(|&name| name.to_owned()).collect());
    for columns in
        [PointColumns::default(), PointColumns { coordinates: named(&["x", "2"]), contour: Some("3".to_owned()) }]
    {
        match read_points("fuzz.csv", data, &columns) {
            Ok(table) => {
                assert!(!table.contours.is_empty());
                for list in &table.contours {
                    assert!(!list.points.is_empty() && list.points.len() == list.offsets.len());
                    assert!(list.points.iter().all(|p| p.is_finite()));
                    assert!(list.corners.iter().all(|&c| c < list.points.len()));
                }
            }
            Err(message) => check_message(&message.to_string()),
        }
    }
}

/// Reads a grid of quads and checks that it is one.
pub fn obj(data: &[u8]) {
    match read_quad_grid("fuzz.obj", data) {
        Ok(read) => {
            let quads = read.grid.quads();
            assert!(quads[0] >= 1 && quads[1] >= 1);
            assert_eq!(read.numbers.len(), read.grid.points().len());
            assert!(!read.grid.is_whole() || !read.numbers.contains(&0), "only a border in steps leaves points out");
            let mut numbers: Vec<usize> = read.numbers.iter().copied().filter(|n| *n != 0).collect();
            numbers.extend(&read.unused);
            numbers.sort_unstable();
            assert!(numbers.windows(2).all(|pair| pair[0] < pair[1]), "every point once");
            // Points that were merged with others at their places have no number.
            let missing = numbers.last().map_or(0, |last| last - numbers.len());
            assert!(numbers[0] >= 1 && missing <= read.mended.merged, "{missing} of {}", read.mended.merged);
        }
        Err(message) => check_message(&message.to_string()),
    }
}

/// Reads a mesh of any program, and makes it smooth.
pub fn mesh(format: MeshFormat, data: &[u8]) {
    let word = format.word();
    with_file(&format!(r#"{{"type": "smooth-mesh", "mesh": {{"{word}": "fuzz.{word}"}}}}"#), data);
}

/// Reads a table of poses, and moves through them.
pub fn poses(data: &[u8]) {
    for kind in ["spline", "sclerp"] {
        with_file(&format!(r#"{{"type": "motion", "kind": "{kind}", "poses": {{"csv": "fuzz.csv"}}}}"#), data);
    }
}

/// Reads a grid of heights, and lays a grid on the surface.
pub fn heights(data: &[u8]) {
    with_file(
        r#"{"type": "principal-grid", "edge_length": 0.5, "heights": {"csv": "fuzz.csv", "spacing": [1, 1]}}"#,
        data,
    );
}

/// Builds an object that reads a file. Its measures are left aside: they take a second of awkward surfaces.
fn with_file(object: &str, data: &[u8]) {
    let text = format!(r#"{{"cyclide": 1, "objects": {{"a": {object}}}}}"#);
    let document = Document::parse("fuzz.json", text.as_bytes()).unwrap_or_else(|error| unreachable!("{error}"));
    let read = |_: &Path| Ok(data.to_vec());
    let built = ModelBuilder::new(&document, Path::new("folder"), &read).and_then(|mut b| b.build(0, &mut |_| {}));
    match built {
        Ok(built) => assert_eq!(built.item.name, "a"),
        Err(error) => check_message(&error.to_string()),
    }
}

/// Reads a file as if it were one of ours.
pub fn written(format: Format, data: &[u8]) {
    match read_back(format, data) {
        Ok(content) => {
            // No reader makes more of a file than stands in it.
            let vertices: usize = content.meshes.iter().map(|mesh| mesh.positions.len()).sum();
            assert!(vertices <= data.len(), "{vertices} vertices of {} bytes", data.len());
            assert!(content.curves.len() <= data.len() && content.bodies.len() <= data.len());
        }
        // The checker alone shows it, and escapes what it prints.
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Messages are for terminals: nothing that these act on or do not show, except for the line ends.
fn check_message(message: &str) {
    assert_eq!(escaped_lines(message), message);
    assert!(!message.is_empty());
    assert!(message.lines().count() <= 3 || message.contains("\\n"), "{message:?}");
}
