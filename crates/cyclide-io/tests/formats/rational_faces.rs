//! Rational faces that are no cyclides, through every format that holds surfaces.

use cyclide::{
    model::{Model, SurfaceObject, Units},
    rational::RationalBezierSurface,
    topology::{Body, Shell},
};
use cyclide_io::{ExportOptions, Exporter, Format, export::StepEdges, formats::read_back, report::FileReport};
use cyclide_testkit::rational_faces::{egg, smooth_pair};
use std::path::Path;

const FORMATS: &[Format] = &[
    Format::Step,
    Format::Json,
    Format::Glb,
    Format::Obj,
    Format::Stl,
    Format::Ply,
    Format::Vtu,
    Format::Gismo,
    Format::Svg,
    #[cfg(feature = "png")]
    Format::Png,
];

fn model(name: &str, body: Body) -> Model {
    Model::new(Units::Millimetre).with_surface(name, body)
}

fn models() -> [Model; 2] {
    [model("egg", egg()), model("pair", Body { outer: smooth_pair(), voids: Vec::new() })]
}

fn report(model: &Model, format: Format, options: &ExportOptions) -> (FileReport, Vec<u8>) {
    let exporter = Exporter::new(model).unwrap();
    let file = exporter.export(format, options).unwrap();
    let report = exporter.check(Path::new("o"), format, &file).map_err(|e| format!("{format:?}: {e}")).unwrap();
    (report, file.bytes)
}

#[test]
fn every_format_holds_them_within_its_promise() {
    for model in models() {
        for &format in FORMATS {
            for tolerance in [None, Some(1e-2)] {
                let (report, _) = report(&model, format, &ExportOptions { tolerance, ..ExportOptions::default() });
                let exact = matches!(format, Format::Step | Format::Json | Format::Vtu | Format::Gismo);
                assert_eq!(report.exact, exact, "{format:?}: {report:?}");
                if let Some(deviation) = report.deviation {
                    assert!(deviation <= if exact { 1e-14 } else { report.bound }, "{format:?}: {report:?}");
                }
            }
        }
    }
}

/// A plane face whose lines bend more inside than at its border: its mesh promises what the border is off, and a cell inside lies
/// over the polygons of its neighbors, which is no deviation.
#[test]
fn what_bends_inside_a_plane_face_is_no_deviation() {
    // Across, the lines at both ends are straight and those between bend by up to 0.3.
    let place = |i: u8, j: u8| {
        let aside = if (i, j) == (1, 1) { 1.2 } else { 0.0 };
        [2.0 * f64::from(i) + aside, f64::from(j) + if i == 1 { 0.3 } else { 0.0 }, 0.0, 1.0]
    };
    let rows: Vec<[f64; 4]> = (0..3).flat_map(|i| (0..3).map(move |j| place(i, j))).collect();
    let surface = RationalBezierSurface::new([2, 2], rows).unwrap();
    let plane = model("plane", Body { outer: Shell::from_surface(surface).unwrap(), voids: Vec::new() });
    for format in [Format::Glb, Format::Obj, Format::Stl] {
        for tolerance in [3e-2, 3e-3] {
            let options = ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() };
            let (report, _) = report(&plane, format, &options);
            let deviation = report.deviation.unwrap();
            assert!(deviation <= report.bound && deviation > 0.1 * tolerance, "{format:?}: {report:?}");
        }
    }
}

#[test]
fn step_has_the_rational_surfaces_and_edges_themselves() {
    for model in models() {
        for edges in [StepEdges::Circles, StepEdges::Rational] {
            let options = ExportOptions { step_edges: edges, ..ExportOptions::default() };
            let (_, bytes) = report(&model, Format::Step, &options);
            let text = String::from_utf8(bytes.clone()).unwrap();
            let SurfaceObject::Body(body) = &model.items[0].surfaces()[0] else { unreachable!() };
            // The egg is halved between its poles: readers do not integrate its faces as they are.
            let halved = |shell: &Shell| shell.halved(|_, _| [shell.is_closed(), false], 1).unwrap();
            let shells: Vec<Shell> = body.shells().map(halved).collect();
            let faces: usize = shells.iter().map(|shell| shell.faces().len()).sum();
            assert_eq!(text.matches("B_SPLINE_SURFACE_WITH_KNOTS").count(), faces);
            let edges: usize = shells.iter().map(|shell| shell.edges().len()).sum();
            assert_eq!(text.matches("B_SPLINE_CURVE_WITH_KNOTS").count(), edges, "shared edges are written once");
            let content = read_back(Format::Step, &bytes).unwrap();
            assert_eq!(content.bodies[0].solid, body.shells().all(Shell::is_closed));
        }
    }
}

/// A file of another surface is found out: a control point that was moved by a millionth of the size.
#[test]
fn a_moved_control_point_is_found() {
    let [egg, _] = models();
    let exporter = Exporter::new(&egg).unwrap();
    for (format, height, moved) in
        [(Format::Step, "-0.5186046511627906", "-0.5186076511627906"), (Format::Json, "1.3", "1.300003")]
    {
        let mut file = exporter.export(format, &ExportOptions::default()).unwrap();
        assert!(exporter.deviation(format, &file).unwrap() < 1e-14);
        let text = String::from_utf8(file.bytes.clone()).unwrap();
        assert!(text.contains(height), "the height of a control point");
        file.bytes = text.replacen(height, moved, 1).into_bytes();
        let deviation = exporter.deviation(format, &file);
        assert!(deviation.as_ref().map_or(true, |d| *d > 1e-7), "{format:?}: {deviation:?}");
    }
}
