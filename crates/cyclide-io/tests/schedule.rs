//! Schedules of nets: what the tables say against the kernel and against each other.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::{HashMap, HashSet};

use cyclide::{model::SurfaceObject, surface::CyclidicNet};
use cyclide_io::{
    Document,
    document::BuiltObject,
    report::{GeometryReport, ObjectReport},
    schedule::{ScheduleOptions, WorkshopSchedule},
};

/// A row by the names of its columns.
type Row = HashMap<String, String>;

struct Made {
    built: Vec<BuiltObject>,
    schedule: WorkshopSchedule,
    files: HashMap<String, Vec<u8>>,
}

impl Made {
    fn of(text: &str, options: &ScheduleOptions) -> Self {
        let document: Document = text.parse().unwrap();
        let built = document.build().unwrap();
        let schedule = WorkshopSchedule::new(document.units, &built, options).unwrap();
        let files = schedule.files().unwrap().into_iter().collect();
        Self { built, schedule, files }
    }

    fn text(&self, file: &str) -> &str {
        std::str::from_utf8(&self.files[file]).unwrap()
    }

    /// The rows of a table without quotes.
    fn table(&self, file: &str) -> Vec<Row> {
        let mut lines = self.text(file).lines();
        let names: Vec<&str> = lines.next().unwrap().split(',').collect();
        let row = |line: &str| {
            let fields: Vec<&str> = line.split(',').collect();
            assert_eq!(fields.len(), names.len());
            names.iter().zip(fields).map(|(name, field)| ((*name).to_owned(), field.to_owned())).collect()
        };
        lines.map(row).collect()
    }

    fn net(&self, index: usize) -> &CyclidicNet {
        self.built[index].item.surfaces().iter().find_map(SurfaceObject::as_net).unwrap()
    }
}

fn number(row: &Row, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name}: {:?}", row[name]))
}

fn canopy() -> &'static str {
    include_str!("../../../examples/canopy.json")
}

#[test]
fn totals_are_those_of_the_report() {
    let made = Made::of(canopy(), &ScheduleOptions::default());
    let json: serde_json::Value = serde_json::from_str(made.text("schedule.json")).unwrap();
    let GeometryReport::Surface(report) = ObjectReport::new(&made.built[0], None).geometry else {
        panic!("it is a surface")
    };
    let area = json["totals"]["area"].as_f64().unwrap();
    assert!((area / report.total_area - 1.0).abs() < 1e-12, "both are known to 1e-12");
    assert_eq!(json["totals"]["panels"].as_u64(), Some(report.patches as u64));
    assert_eq!(json["totals"]["border"]["count"].as_u64(), Some(report.free_edges as u64));
    let arcs = made.net(0).support_arcs().unwrap();
    let length: f64 = arcs.iter().map(cyclide::curve::Arc::length).sum();
    assert!((json["totals"]["edge_length"].as_f64().unwrap() / length - 1.0).abs() < 1e-14);
    // Of the solid the upper skin is a part by itself.
    let GeometryReport::Surface(solid) = ObjectReport::new(&made.built[1], None).geometry else {
        panic!("it is a surface")
    };
    let other = json["totals"]["offset_area"].as_f64().unwrap();
    assert!(solid.parts.iter().any(|part| (part.area / other - 1.0).abs() < 1e-11), "{other}");
    assert!(made.schedule.text().contains("skin: 6 rows of 8 panels"));
    let panels = made.table("panels.csv");
    let sum: f64 = panels.iter().map(|row| number(row, "area_m2")).sum();
    assert!((sum / area - 1.0).abs() < 1e-15 * panels.len() as f64);
}

#[test]
fn panels_edges_and_nodes_lead_to_each_other() {
    let made = Made::of(canopy(), &ScheduleOptions::default());
    let tables = ["panels.csv", "edges.csv", "nodes.csv"].map(|file| made.table(file));
    let [panels, edges, nodes] = &tables;
    assert_eq!(nodes.len() + panels.len(), edges.len() + 1, "a disc has the characteristic 1");
    for table in &tables {
        let ids: HashSet<&str> = table.iter().map(|row| row["id"].as_str()).collect();
        assert_eq!(ids.len(), table.len(), "each has a name of its own");
    }
    let by_id =
        |table: &[Row]| -> HashMap<String, Row> { table.iter().map(|row| (row["id"].clone(), row.clone())).collect() };
    let (panel_of, edge_of, node_of) = (by_id(panels), by_id(edges), by_id(nodes));
    assert_eq!(panel_of["skin-r02-c05"]["column"], "5");
    for (id, edge) in &edge_of {
        for name in ["panel_1", "panel_2"] {
            if let Some(panel) = panel_of.get(&edge[name]) {
                let sides = ["bottom", "right", "top", "left"];
                let side = sides.iter().find(|side| panel[&format!("{side}_edge")] == *id).unwrap();
                for measure in ["length_m", "chord_m", "radius_m", "sweep_rad"] {
                    assert_eq!(panel[&format!("{side}_{measure}")], edge[measure]);
                }
            }
        }
        for name in ["start_node", "end_node"] {
            let node = &node_of[&edge[name]];
            let valence: usize = node["valence"].parse().unwrap();
            let beams: Vec<&str> = (1..=valence).map(|k| node[&format!("beam{k}_edge")].as_str()).collect();
            assert!(beams.contains(&id.as_str()));
        }
        assert_eq!(edge["crease_rad"], if edge["panel_2"].is_empty() { "" } else { "0" }, "nets are smooth");
    }
    for node in nodes {
        let valence: usize = node["valence"].parse().unwrap();
        let turns: Vec<f64> = (1..=valence).map(|k| number(node, &format!("beam{k}_to_next_rad"))).collect();
        // Lines of curvature cross at right angles, in the plane across the normal.
        assert!((turns.iter().sum::<f64>() - std::f64::consts::TAU).abs() < 1e-12);
        let right = |turn: &&f64| (**turn - std::f64::consts::FRAC_PI_2).abs() < 1e-9;
        assert!(turns.iter().filter(right).count() >= valence - 1);
        assert!((1..=valence).all(|k| number(node, &format!("beam{k}_tilt_rad")).abs() < 1e-9));
    }
}

#[test]
fn beams_are_as_long_as_the_edges_of_parallel_nets() {
    let options = ScheduleOptions { beam_depth: Some(-0.25), ..ScheduleOptions::default() };
    let made = Made::of(canopy(), &options);
    let lower = made.net(0).offset(-0.25).unwrap().support_arcs().unwrap();
    let beams = made.table("beams.csv");
    assert_eq!(beams.len(), lower.len());
    for ((beam, edge), low) in beams.iter().zip(made.table("edges.csv")).zip(&lower) {
        assert_eq!(beam["id"], edge["id"]);
        // The strip's by curvature and length, the offset's by its own vertices and weights.
        assert!((number(beam, "lower_length_m") - low.length()).abs() < 1e-12);
        assert!((number(beam, "upper_length_m") - number(&edge, "length_m")).abs() < 1e-14);
        assert_eq!((number(beam, "lower_height_m"), number(beam, "upper_height_m")), (-0.25, 0.0));
        if beam["form"] == "cone" {
            // As a cone in space: radius over the sine of half its angle is the radius of the flat ring.
            let flat = number(beam, "upper_bent_radius_m") / number(beam, "cone_half_angle_rad").sin();
            assert!((flat / number(beam, "upper_flat_radius_m") - 1.0).abs() < 1e-9);
            assert!((number(beam, "upper_bent_radius_m") / number(&edge, "radius_m") - 1.0).abs() < 1e-12);
        }
    }
    let dxf = made.text("beams.dxf");
    assert_eq!(dxf.matches("LWPOLYLINE").count(), 2 * beams.len(), "an outline and a mark each");
    assert_eq!(dxf.matches("\nTEXT\n").count(), beams.len());
}

#[test]
fn plans_number_every_panel_once() {
    let made = Made::of(canopy(), &ScheduleOptions::default());
    let plan = made.text("plan.dxf");
    for row in made.table("panels.csv") {
        let number = row["id"].strip_prefix("skin-").unwrap();
        assert_eq!(plan.matches(&format!("\n{number}\n")).count(), 1, "{number}");
    }
    // A closed ring is seen from all sides, and still each panel once.
    let ring = r#"{"cyclide": 1, "units": "m", "objects": {"ring": {"type": "cyclide", "a": 3, "mu": 1, "segments": [8, 6]}}}"#;
    let made = Made::of(ring, &ScheduleOptions::default());
    let plan = made.text("plan.dxf");
    for view in ["plan", "front", "right", "back", "left", "below"] {
        assert!(plan.contains(&format!("ring, {view}, m")), "{view}");
    }
    for row in made.table("panels.csv") {
        let number = row["id"].strip_prefix("ring-").unwrap();
        assert_eq!(plan.matches(&format!("\n{number}\n")).count(), 1, "{number}");
    }
}

#[test]
fn a_ring_counts_round() {
    let ring = r#"{"cyclide": 1, "units": "m", "objects": {"ring": {"type": "cyclide", "a": 3, "mu": 1, "segments": [8, 6]}}}"#;
    let made = Made::of(ring, &ScheduleOptions::default());
    let edges = made.table("edges.csv");
    assert_eq!((made.table("panels.csv").len(), edges.len(), made.table("nodes.csv").len()), (48, 96, 48));
    assert!(edges.iter().all(|row| !row["panel_2"].is_empty()), "no border");
    let area = 12.0 * std::f64::consts::PI.powi(2);
    let sum: f64 = made.table("panels.csv").iter().map(|row| number(row, "area_m2")).sum();
    assert!((sum - area).abs() < 1e-11 * area, "Pappus");
}

#[test]
fn poles_are_one_node() {
    // An octant of the unit sphere: its upper side is one point.
    let octant = r#"{"cyclide": 1, "objects": {"o": {"type": "cyclide-patch", "corners": [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 1]], "frame": [[0, 1, 0], [0, 0, 1]]}}}"#;
    let made = Made::of(octant, &ScheduleOptions { thickness: Some(0.5), ..ScheduleOptions::default() });
    let (panels, nodes) = (made.table("panels.csv"), made.table("nodes.csv"));
    assert_eq!((made.table("edges.csv").len(), nodes.len()), (3, 3));
    assert_eq!((panels[0]["top_edge"].as_str(), &panels[0]["node_01"]), ("", &panels[0]["node_11"]));
    let octant_area = 0.5 * std::f64::consts::PI;
    assert!((number(&panels[0], "area_mm2") - octant_area).abs() < 1e-12);
    assert!((number(&panels[0], "offset_area_mm2") - 2.25 * octant_area).abs() < 1e-11);
    for beam in made.table("beams.csv") {
        assert_eq!(beam["form"], "flat", "normals along great circles are in their planes");
        assert!((number(&beam, "upper_length_mm") - 1.5 * std::f64::consts::FRAC_PI_2).abs() < 1e-13);
    }
}

#[test]
fn what_is_scheduled_and_what_not() {
    let made = Made::of(canopy(), &ScheduleOptions::default());
    let why: Vec<(&str, &str)> =
        made.schedule.not_scheduled().iter().map(|left| (left.name.as_str(), left.why.as_str())).collect();
    assert_eq!(why.len(), 2);
    assert!(why[0].0 == "glass" && why[0].1.contains("are listed with the panels of `skin`"), "{why:?}");
    assert!(why[1].0 == "ribs" && why[1].1.contains("edges of `skin`"), "{why:?}");
    assert!(made.table("edges.csv").iter().all(|row| number(row, "offset_length_m") > number(row, "length_m")));
    // A skin that is construction geometry is scheduled as the solid that is made of it.
    let solid = canopy().replace("\"make_circular\": true,", "\"make_circular\": true, \"construction\": true,");
    let made = Made::of(&solid, &ScheduleOptions::default());
    assert_eq!(made.table("panels.csv")[0]["id"], "glass-r00-c00");
    assert!(number(&made.table("panels.csv")[0], "offset_area_m2") > 0.0);
    let asked = ScheduleOptions { objects: vec!["skin".to_owned()], ..ScheduleOptions::default() };
    assert_eq!(Made::of(&solid, &asked).table("panels.csv")[0]["id"], "skin-r00-c00");
}

#[test]
fn refusals_say_what_is_wrong() {
    let document: Document = canopy().parse().unwrap();
    let built = document.build().unwrap();
    let refused =
        |options: ScheduleOptions| WorkshopSchedule::new(document.units, &built, &options).unwrap_err().to_string();
    let ribs = refused(ScheduleOptions { objects: vec!["ribs".to_owned()], ..ScheduleOptions::default() });
    assert!(ribs.contains("no net of panels") && ribs.ends_with("[no-net]"), "{ribs}");
    let thick = refused(ScheduleOptions { thickness: Some(-40.0), ..ScheduleOptions::default() });
    assert!(thick.starts_with("skin: ") && thick.ends_with("[offset-not-regular]"), "{thick}");
    let deep = refused(ScheduleOptions { beam_depth: Some(-40.0), ..ScheduleOptions::default() });
    assert!(deep.ends_with("[offset-not-regular]"), "{deep}");
}

#[test]
fn no_two_objects_give_one_name() {
    // A horn is two nets, `horn.0` and `horn.1`.
    let model = |name: &str| {
        format!(
            r#"{{"cyclide": 1, "objects": {{"horn": {{"type": "cyclide", "a": 10, "c": 5, "mu": 3, "segments": [6, 4]}},
            "{name}": {{"type": "cyclide", "a": 3, "mu": 1, "segments": [6, 4]}}}}}}"#
        )
    };
    let refused = |name: &str, options: &ScheduleOptions| {
        let document: Document = model(name).parse().unwrap();
        let built = document.build().unwrap();
        WorkshopSchedule::new(document.units, &built, options).err().map(|error| error.to_string())
    };
    let taken = refused("horn.1", &ScheduleOptions::default()).unwrap();
    assert!(taken.contains("`horn` and `horn.1`") && taken.ends_with("[name-taken]"), "{taken}");
    // One alone has no rival.
    let alone = ScheduleOptions { objects: vec!["horn.1".to_owned()], ..ScheduleOptions::default() };
    assert_eq!(refused("horn.1", &alone), None);
    let made = Made::of(&model("ring"), &ScheduleOptions::default());
    for file in ["panels.csv", "edges.csv", "nodes.csv"] {
        let rows = made.table(file);
        let ids: HashSet<&String> = rows.iter().map(|row| &row["id"]).collect();
        assert_eq!(ids.len(), rows.len(), "{file}");
    }
}

#[test]
fn moulds_and_classes_group_the_panels() {
    // All panels of a ring torus come from one mould; each row of them is alike, and a row is the mirror image of another.
    let ring = r#"{"cyclide": 1, "units": "m", "objects": {"ring": {"type": "cyclide", "a": 3, "mu": 1, "segments": [8, 6]}}}"#;
    let made = Made::of(ring, &ScheduleOptions { tolerance: Some(1e-6), ..ScheduleOptions::default() });
    let json: serde_json::Value = serde_json::from_str(made.text("schedule.json")).unwrap();
    let totals = &json["totals"];
    assert_eq!((totals["moulds"].as_u64(), totals["mould_kinds"]["torus"]["panels"].as_u64()), (Some(1), Some(48)));
    assert_eq!(totals["classes"].as_u64(), Some(3), "both halves of the tube have the same three rows, turned over");
    for row in made.table("panels.csv") {
        assert_eq!((row["mould"].as_str(), row["near_kind"].as_str()), ("torus-1", "torus"));
        assert!(number(&row, "near_distance_m") < 1e-12 && row["class_size"] == "16");
        assert!(
            (number(&row, "near_major_radius_m") - 3.0).abs() < 1e-9
                && (number(&row, "near_radius_m") - 1.0).abs() < 1e-9
        );
        assert_eq!(row["pattern_area_m2"], "", "a torus is not flat");
    }
    // Panels of the canopy are near tori and the like within a coarse tolerance, by themselves within a fine one.
    let tolerance = |t: f64| Made::of(canopy(), &ScheduleOptions { tolerance: Some(t), ..ScheduleOptions::default() });
    let (coarse, fine) = (tolerance(0.01), tolerance(1e-7));
    for row in coarse.table("panels.csv") {
        assert!(number(&row, "near_distance_m") <= 0.01);
    }
    assert!(fine.table("panels.csv").iter().all(|row| row["mould"].starts_with("own-") && row["near_kind"].is_empty()));
}

#[test]
fn flat_patterns_of_a_vault() {
    // Half of a cylinder of radius 4: sheets that are rolled, all alike.
    let rows: Vec<Vec<[f64; 3]>> = (0..4)
        .map(|j| {
            (0..9)
                .map(|i| {
                    let angle = std::f64::consts::PI * f64::from(i) / 8.0;
                    [-4.0 * angle.cos(), 2.0 * f64::from(j), 4.0 * angle.sin()]
                })
                .collect()
        })
        .collect();
    let text = format!(
        r#"{{"cyclide": 1, "units": "m", "objects": {{"vault": {{"type": "cyclidic-net", "grid": {rows:?}}}}}}}"#
    );
    let made = Made::of(&text, &ScheduleOptions { thickness: Some(0.1), ..ScheduleOptions::default() });
    let panels = made.table("panels.csv");
    let area = 4.0 * std::f64::consts::FRAC_PI_8 * 2.0;
    for row in &panels {
        assert_eq!((row["kind"].as_str(), row["mould"].as_str()), ("cylinder", "cylinder-1"));
        assert!((number(row, "pattern_area_m2") - area).abs() < 1e-12, "a rectangle of arc by ruling");
        assert!(number(row, "pattern_length_change").abs() < 1e-12);
        assert_eq!(row["class_size"], "24");
    }
    let dxf = made.text("patterns.dxf");
    assert_eq!((dxf.matches("LWPOLYLINE").count(), dxf.matches("\nTEXT\n").count()), (24, 24));
    // Beams along the rulings are flat boards, those along the arcs flat rings.
    for beam in made.table("beams.csv") {
        assert_eq!(beam["form"], "flat");
        let along = beam["id"].contains("-t-");
        assert_eq!(beam["lower_flat_radius_m"].is_empty(), along);
        if !along {
            assert!((number(&beam, "lower_flat_radius_m") - 4.0).abs() < 1e-9);
        }
    }
}
