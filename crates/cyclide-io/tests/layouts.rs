//! Nets round extraordinary vertices in what is made of nets: schedules, pictures, layers.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::{HashMap, HashSet};

use cyclide::{
    curve::Arc,
    model::{Item, Model, SurfaceObject, Units},
    surface::{NetLayout, QuadLayout},
    topology::Shell,
    volume::{CyclideGrid, CyclideVolume, Grading},
};
use cyclide_grids::{CircularMeshOptions, make_layout_circular};
use cyclide_io::{
    Document, ExportOptions, Exporter, Format,
    document::BuiltObject,
    export::{Provenance, VtuCells},
    report::{GeometryReport, ObjectReport},
    schedule::{ScheduleOptions, WorkshopSchedule},
};
use cyclide_testkit::layouts::{ball, cap};

fn net_of(layout: &QuadLayout) -> NetLayout {
    NetLayout::new(make_layout_circular(layout, &CircularMeshOptions::default()).unwrap().layout).unwrap()
}

/// Five sectors of 4 x 4 quads, of which one is open.
fn dome() -> NetLayout {
    net_of(&cap(5, 4, |x, y| -0.3 * (x * x + y * y)))
}

/// Six pieces round eight openings.
fn skin() -> NetLayout {
    net_of(&ball(5, 0.1))
}

/// A document with one object of this name, and what takes its place.
fn built(name: &str, surfaces: Vec<SurfaceObject>) -> (Document, Vec<BuiltObject>) {
    let text = format!(
        r#"{{"cyclide": 1, "units": "m", "objects": {{"{name}": {{"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1]], "frame": [[1, 0, 0], [0, 1, 0]]}}}}}}"#
    );
    let document: Document = text.parse().unwrap();
    let mut built = document.build().unwrap();
    built[0].bodies = surfaces.iter().flat_map(|surface| surface.to_bodies().unwrap()).collect();
    built[0].item = Item::new(name, surfaces);
    (document, built)
}

/// A row by the names of its columns.
type Row = HashMap<String, String>;

fn table(files: &HashMap<String, String>, name: &str) -> Vec<Row> {
    let mut lines = files[name].lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| names.iter().map(|n| (*n).to_owned()).zip(line.split(',').map(str::to_owned)).collect();
    lines.map(row).collect()
}

fn number(row: &Row, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name}: {:?}", row[name]))
}

#[test]
fn schedules_list_once_what_pieces_share() {
    for (net, openings) in [(dome(), 1), (skin(), 8)] {
        let (document, built) = built("dome", vec![net.clone().into()]);
        let options = ScheduleOptions { thickness: Some(0.02), beam_depth: Some(-0.05), ..ScheduleOptions::default() };
        let schedule = WorkshopSchedule::new(document.units, &built, &options).unwrap();
        let files =
            schedule.files().unwrap().into_iter().map(|(name, bytes)| (name, String::from_utf8(bytes).unwrap()));
        let files: HashMap<String, String> = files.collect();
        let tables = ["panels.csv", "edges.csv", "nodes.csv", "beams.csv"].map(|name| table(&files, name));
        let [panels, edges, nodes, beams] = &tables;
        let shell = net.to_shell().unwrap();
        assert_eq!(
            (panels.len(), edges.len(), nodes.len(), beams.len()),
            (shell.faces().len(), shell.edges().len(), shell.vertices().len(), shell.edges().len())
        );
        for table in &tables {
            let ids: HashSet<&str> = table.iter().map(|row| row["id"].as_str()).collect();
            assert_eq!(ids.len(), table.len(), "each has a name of its own");
        }
        // Sums of a hundred figures that are known to 1e-12.
        let same = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-11, "{a} {b}");
        let sum = |table: &[Row], name: &str| table.iter().map(|row| number(row, name)).sum::<f64>();
        let length = |shell: &Shell| shell.edges().iter().map(|e| e.curve.arc().map_or(0.0, Arc::length)).sum::<f64>();
        let json: serde_json::Value = serde_json::from_str(&files["schedule.json"]).unwrap();
        assert_eq!(json["nets"].as_array().unwrap().len(), 1);
        assert_eq!((json["nets"][0]["object"].as_str(), &json["format"]), (Some("dome"), &"cyclide-schedule/1".into()));
        assert_eq!(json["nets"][0]["pieces"].as_array().unwrap().len(), net.nets().len());
        for totals in [&json["totals"], &json["nets"][0]] {
            let figure = |name: &str| totals[name].as_f64().unwrap();
            same(figure("area"), shell.known_area().unwrap());
            same(figure("edge_length"), length(&shell));
            same(figure("offset_area"), net.offset(0.02).unwrap().to_shell().unwrap().known_area().unwrap());
            let counts = ["panels", "edges", "nodes"].map(|name| totals[name].as_u64().unwrap() as usize);
            assert_eq!(counts, [panels.len(), edges.len(), nodes.len()]);
            let of_beams: f64 =
                totals["beam_forms"].as_object().unwrap().values().map(|form| form["area"].as_f64().unwrap()).sum();
            same(of_beams, sum(beams, "area_m2"));
            assert_eq!(totals["creases"].as_u64(), Some(0));
        }
        same(sum(panels, "area_m2"), shell.known_area().unwrap());
        let lower = net.offset(-0.05).unwrap().to_shell().unwrap();
        same(sum(beams, "lower_length_m"), length(&lower));
        let GeometryReport::Surface(report) = ObjectReport::new(&built[0], None).geometry else {
            panic!("it is a surface")
        };
        same(report.total_area, json["totals"]["area"].as_f64().unwrap());
        assert_eq!(json["totals"]["border"]["count"].as_u64(), Some(report.free_edges as u64));
        assert_eq!(schedule.text().lines().next(), Some(format!("dome: {} connected nets", net.nets().len()).as_str()));
        // Where they join: both panels, one strip, no crease.
        let piece = |id: &str| id.split('-').next().unwrap_or_default().to_owned();
        let shared: Vec<&Row> = edges.iter().filter(|e| !e["panel_2"].is_empty()).collect();
        let shared: Vec<&Row> = shared.into_iter().filter(|e| piece(&e["panel_1"]) != piece(&e["panel_2"])).collect();
        // A sector joins two others along three edges each; a face of the cube four along three.
        assert_eq!(shared.len(), if openings == 1 { 5 * 3 } else { 12 * 3 });
        assert!(shared.iter().all(|edge| edge["crease_rad"] == "0"));
        let by_id: HashMap<&str, &Row> = panels.iter().chain(nodes).map(|row| (row["id"].as_str(), row)).collect();
        for edge in edges {
            for panel in ["panel_1", "panel_2"].into_iter().filter_map(|name| by_id.get(edge[name].as_str())) {
                let sides = ["bottom", "right", "top", "left"];
                let side = sides.iter().find(|side| panel[&format!("{side}_edge")] == edge["id"]).unwrap();
                for measure in ["length_m", "chord_m", "radius_m", "sweep_rad"] {
                    assert_eq!(panel[&format!("{side}_{measure}")], edge[measure]);
                }
            }
        }
        for node in nodes {
            let valence: usize = node["valence"].parse().unwrap();
            let users = edges.iter().filter(|e| [&e["start_node"], &e["end_node"]].contains(&&node["id"])).count();
            assert_eq!(valence, users);
            let quarter = std::f64::consts::FRAC_PI_2;
            for k in 1..=valence {
                let turns = number(node, &format!("beam{k}_to_next_rad")) / quarter;
                // Edges of all pieces cross at right angles in one plane; the frames meet to 1e-11.
                assert!((turns - turns.round()).abs() < 1e-9, "{turns}");
                assert!(number(node, &format!("beam{k}_tilt_rad")).abs() < 1e-9);
            }
        }
        let plan = &files["plan.dxf"];
        for row in panels {
            let number = row["id"].strip_prefix("dome.").unwrap();
            assert_eq!(plan.matches(&format!("\n{number}\n")).count(), 1, "{number}");
        }
        assert_eq!(files["beams.dxf"].matches("LWPOLYLINE").count(), 2 * edges.len());
    }
}

#[cfg(feature = "png")]
#[test]
fn pictures_number_the_panels_of_all_pieces() {
    let net = dome();
    let panels = net.to_shell().unwrap().faces().len();
    let (skin, solid) = (SurfaceObject::Layout(net.clone()), SurfaceObject::Body(net.thick(0.05).unwrap()));
    for (object, skin) in [(skin.clone(), vec![]), (solid, vec![skin])] {
        let model = Model::new(Units::Metre).with_surface("dome", object);
        let given = [Provenance { kind: "offset", skin, ..Provenance::default() }];
        for camera in ["top", "bottom"] {
            let options = ExportOptions {
                png_labels: true,
                png_width: Some(2400),
                png_height: Some(2000),
                camera: camera.parse().ok(),
                ..ExportOptions::default()
            };
            let exporter = Exporter::with_provenance(&model, &given).unwrap();
            let file = exporter.export(Format::Png, &options).unwrap();
            let said = file.notes.join("\n");
            let count = said.strip_prefix("1-r03-c07 is piece 1, row 3, column 7; ").unwrap();
            let count = count.strip_suffix(&format!(" of {panels} panels are numbered, {panels} are visible")).unwrap();
            // Most have room at this size.
            assert!(count.parse::<usize>().unwrap() * 10 >= panels * 8, "{said}");
        }
    }
}

#[test]
fn solids_and_their_images_know_their_skin() {
    let text = include_str!("../../../examples/canopy.json");
    let image = r#""turned": {"type": "transform", "of": "glass", "steps": [{"translation": [50, 0, 0]}]}, "ribs": {"#;
    let document: Document = text.replace("\"ribs\": {", image).parse().unwrap();
    let built = document.build().unwrap();
    let skin = |name: &str| &built.iter().find(|built| built.item.name == name).unwrap().provenance.skin;
    let net = built.iter().find(|built| built.item.name == "skin").unwrap();
    assert_eq!((skin("glass").as_slice(), skin("turned").as_slice()), (net.item.surfaces(), net.item.surfaces()));
    assert!(skin("skin").is_empty() && skin("ribs").is_empty());
}

#[test]
fn blocks_of_all_pieces_are_read_back() {
    let grids = CyclideGrid::layers_of_layout(&dome(), &[0.0, 0.05, 0.08]).unwrap();
    let blocks: Vec<CyclideVolume> = grids.iter().flat_map(CyclideGrid::blocks).collect();
    let item = Item::new("wall", blocks);
    let model = Model { items: vec![item], units: Units::Metre };
    let even = || Grading::Uniform.places(2).unwrap();
    let given = [Provenance { kind: "layers", places: Some([even(), even(), even()]), ..Provenance::default() }];
    let exporter = Exporter::with_provenance(&model, &given).unwrap();
    let shell = dome().to_shell().unwrap();
    for (format, vtu_cells) in [
        (Format::Vtu, VtuCells::Linear),
        (Format::Vtu, VtuCells::Bezier),
        (Format::Mfem, VtuCells::Bezier),
        (Format::Gismo, VtuCells::Bezier),
        (Format::Step, VtuCells::Bezier),
        (Format::Glb, VtuCells::Bezier),
    ] {
        // Written files are read back, held against the blocks, and refused if they differ.
        let file = exporter.export(format, &ExportOptions { vtu_cells, ..ExportOptions::default() }).unwrap();
        if vtu_cells == VtuCells::Linear {
            // Two cells along each edge of two layers.
            let nodes = 5 * (shell.vertices().len() + shell.edges().len() + shell.faces().len());
            let text = String::from_utf8(file.bytes).unwrap();
            assert!(text.contains(&format!("NumberOfPoints=\"{nodes}\"")), "{}", &text[..400]);
        }
    }
}
