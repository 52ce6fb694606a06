//! Surfaces of documents: every type is built, and what is refused is shown at its place.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod contact_blends;
mod crossings;
mod cyclides;
mod necks;
mod net_layouts;
mod nets;
mod offsets;
mod patches;
mod pipes;
mod principal_grids;
mod principal_sources;
mod rails;
mod refusals;
mod revolutions;
mod tees;
mod tori;
mod tubes;
mod volumes;

use std::path::Path;

use cyclide::{Point3, surface::ParamSurface as _};
use cyclide_io::{Document, ModelBuilder, Report, document::BuiltObject, report::GeometryReport};

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

fn surface(built: &BuiltObject) -> cyclide_io::report::SurfaceReport {
    let report = Report::new(cyclide::model::Units::Millimetre, std::slice::from_ref(built), None);
    let Some(GeometryReport::Surface(surface)) = report.objects.into_values().next().map(|o| o.geometry) else {
        panic!("a surface")
    };
    surface
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
