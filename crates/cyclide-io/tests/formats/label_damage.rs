//! Units, names, layers and knots damaged in the bytes: coordinates are all right, and the check says what is not.

use crate::damage::Damage;
use crate::models::{bent_quad, curve_and_surfaces, flat, mixed, slot, surfaces, torus_part};
use cyclide::{
    Point3,
    model::{Model, Units},
};
use cyclide_io::{
    ExportOptions, Format,
    export::{DxfVersion, StepProducts},
};

/// Two objects with the same curve in other places, in inches.
pub fn twins() -> Model {
    let mut model = mixed(flat);
    model.units = Units::Inch;
    model.items.truncate(1);
    model.with_curve("other", slot(|x, y| Point3::new(x + 100.0, y, 0.0)))
}

/// Two surfaces in inches.
pub fn bodies() -> Model {
    Model { units: Units::Inch, ..surfaces(&[bent_quad(), torus_part(Point3::ORIGIN)]) }
}

/// The words of a message about a unit that is 1 mm in place of an inch.
const UNIT: &str = "the unit of the file is 1 mm, that of the model 25.4 mm";

#[test]
fn step_says_its_unit_and_its_names() {
    let step = Damage::new(twins(), Format::Step);
    let text = String::from_utf8(step.file.bytes.clone()).unwrap();
    let factor = text.lines().find(|line| line.contains("LENGTH_MEASURE(25.4)")).unwrap();
    assert!(step.refused(&[("LENGTH_MEASURE(25.4)", "LENGTH_MEASURE(1.)")]).contains("the unit INCH of 1 mm"));
    // The number of the inch, and the metric unit in its place.
    let metric = factor.rsplit_once(',').unwrap().1.strip_suffix(");").unwrap();
    let (inch, _) =
        text.lines().find(|line| line.contains("CONVERSION_BASED_UNIT('INCH'")).unwrap().split_once('=').unwrap();
    let context = text.split(";\n").find(|instance| instance.contains("GLOBAL_UNIT_ASSIGNED_CONTEXT")).unwrap();
    let metric_context = context.replace(&format!("(({inch},"), &format!("(({metric},"));
    let changed = step.refused(&[(context, &metric_context)]);
    assert_eq!(changed, UNIT);
    assert_eq!(
        step.refused(&[("'slot'", "'other'"), ("'other'", "'slot'")]),
        "curve set 0 is `other` in the file, `slot` in the model"
    );
    assert_eq!(
        step.refused(&[("COMPOSITE_CURVE('slot 0'", "COMPOSITE_CURVE('slot 1'")]),
        "curve 0 is `slot 1` in the file, `slot 0` in the model"
    );
    let layer = ("PRESENTATION_LAYER_ASSIGNMENT('slot'", "PRESENTATION_LAYER_ASSIGNMENT('other'");
    assert_eq!(step.refused(&[layer]), "layer 0 is `other` in the file, `slot` in the model");
    assert_eq!(
        step.refused(&[("PRODUCT('slot','slot'", "PRODUCT('x','x'")]),
        "product 0 is `x` in the file, `slot` in the model"
    );
    assert!(
        step.refused(&[("NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','slot'", "NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','s'")])
            .starts_with("occurrence 0 is `s`")
    );
    let one = ExportOptions { step_products: StepProducts::One, ..ExportOptions::default() };
    let one = Damage::with(twins(), Format::Step, &one);
    assert!(one.refused(&[("PRODUCT('cyclide','cyclide'", "PRODUCT('x','x'")]).contains("product 0 is `x`"));
    let step = Damage::new(bodies(), Format::Step);
    assert!(step.refused(&[("'s0'", "'s1'"), ("'s1'", "'s0'")]).starts_with("body 0 is `s1` in the file, `s0`"));
    assert!(step.refused(&[("RADIAN", "DEGREE")]).contains("angles not in radians"));
}

#[test]
fn dxf_says_its_unit_and_its_layers() {
    for version in [DxfVersion::R2000, DxfVersion::R12] {
        let options = ExportOptions { dxf_version: version, ..ExportOptions::default() };
        let dxf = Damage::with(twins(), Format::Dxf, &options);
        let metric =
            ("$INSUNITS\n 70\n1\n  9\n$MEASUREMENT\n 70\n0\n", "$INSUNITS\n 70\n4\n  9\n$MEASUREMENT\n 70\n1\n");
        assert_eq!(dxf.refused(&[metric]), UNIT);
        let half = ("$INSUNITS\n 70\n1\n", "$INSUNITS\n 70\n4\n");
        assert!(dxf.refused(&[half]).contains("$INSUNITS 4 with $MEASUREMENT 0"));
        let [slot, other] = if version == DxfVersion::R12 { ["SLOT", "OTHER"] } else { ["slot", "other"] };
        let on = |name: &str| format!("\n  8\n{name}\n");
        let moved = dxf.refused(&[(&on(slot), &on(other))]);
        assert_eq!(moved, format!("layer with curves 0 is `{other}` in the file, `{slot}` in the model"));
        let exchanged = dxf.refused(&[(&on(slot), &on(other)), (&on(other), &on(slot))]);
        assert_eq!(exchanged, moved);
        let table = dxf.refused(&[(&format!("\n  2\n{slot}\n"), "\n  2\nx\n")]);
        assert_eq!(table, format!("layer 1 is `x` in the file, `{slot}` in the model"));
    }
    // One curve of two on the layer of the next object.
    let dxf = Damage::new(twins(), Format::Dxf);
    let text = String::from_utf8(dxf.file.bytes.clone()).unwrap();
    let second = text.match_indices("\n  8\nslot\n").nth(1).unwrap().0;
    let moved = dxf.bytes(|bytes| {
        *bytes = [&text[..second], "\n  8\nother\n", &text[second + "\n  8\nslot\n".len()..]].concat().into_bytes()
    });
    assert_eq!(moved.unwrap_err().to_string(), "layer with curves `slot` has 1 parts in the file, 2 in the model");
}

#[test]
fn svg_says_its_unit_and_its_groups() {
    let svg = Damage::new(twins(), Format::Svg);
    let text = String::from_utf8(svg.file.bytes.clone()).unwrap();
    let width = text.split_once(" width=\"").unwrap().1.split_once("mm\"").unwrap().0;
    let shrunk = format!("{}mm", width.parse::<f64>().unwrap() / 25.4);
    let message = svg.refused(&[(&format!("{width}mm"), &shrunk)]);
    assert!(message.contains("a user unit is 1 mm by width and height, but 25.4 mm by the description"), "{message}");
    assert!(svg.refused(&[("user unit = 1 in", "user unit = 1 mm")]).contains("but 1 mm by the description"));
    assert_eq!(svg.refused(&[("<g id=\"slot\"", "<g id=\"sl\"")]), "group 0 is `sl` in the file, `slot` in the model");
    let titles = [("<title>slot<", "<title>other<"), ("<title>other<", "<title>slot<")];
    assert_eq!(svg.refused(&titles), "title of group 0 is `other` in the file, `slot` in the model");
    assert!(svg.refused(&[("<title>cyclide<", "<title>x<")]).starts_with("title of the drawing 0 is `x`"));
    // A drawing that is to scale says which, and is held to it.
    let far = Damage::new(Model { units: Units::Metre, ..twins() }, Format::Svg);
    assert!(
        far.refused(&[("scale 1:500", "scale 1:50")])
            .contains("a user unit is 100 mm by width and height, but 1000 mm by the description")
    );
}

#[test]
fn json_says_its_unit_names_and_knots() {
    let json = Damage::new(twins(), Format::Json);
    assert_eq!(json.refused(&[("\"units\": \"in\"", "\"units\": \"mm\"")]), UNIT);
    assert_eq!(
        json.refused(&[("\"units\": \"in\",", "")]),
        "the file does not state its unit; that of the model is 25.4 mm"
    );
    let names = [("\"slot\"", "\"other\""), ("\"other\"", "\"slot\"")];
    assert_eq!(json.refused(&names), "object with curves 0 is `other` in the file, `slot` in the model");
    assert!(json.refused(&[("\"arc-spline\"", "\"arc\"")]).starts_with("type 0 is `arc` in the file"));
    let json = Damage::new(bodies(), Format::Json);
    let text = String::from_utf8(json.file.bytes.clone()).unwrap();
    let knots = "\"knots\": [[0, 0, 0, 1, 1, 1]";
    let at = text.find(knots).unwrap();
    for wrong in ["[[0, 0, 0, 2, 2, 2]", "[[0, 0, 1, 1]", "[[0, 0, 0.5, 1, 1, 1]"] {
        let changed = json.bytes(|bytes| {
            *bytes = [&text[..at], "\"knots\": ", wrong, &text[at + knots.len()..]].concat().into_bytes();
        });
        assert!(changed.unwrap_err().to_string().contains("the knots of a patch of degree 2 are"), "{wrong}");
    }
    assert_eq!(json.refused(&[("\"outward\": true", "\"outward\": false")]), "patch 0: its outer side is reversed");
}

/// The root stands behind the nodes of both objects.
const ROOT: usize = 2;

#[test]
fn glb_says_its_unit_and_its_nodes() {
    for model in [twins(), bodies()] {
        let [first, second] = [model.items[0].name.clone(), model.items[1].name.clone()];
        let glb = Damage::new(model, Format::Glb);
        let scale =
            |v: f64| move |json: &mut serde_json::Value| json["nodes"][ROOT]["scale"] = serde_json::json!([v, v, v]);
        assert_eq!(glb.refused_glb(scale(0.001)), UNIT);
        assert_eq!(glb.refused_glb(scale(1.0)), "the unit of the file is 1000 mm, that of the model 25.4 mm");
        let turned = glb.refused_glb(|json| json["nodes"][ROOT]["rotation"][0] = serde_json::json!(0.5));
        assert!(turned.contains("a root that does more than turn"), "{turned}");
        let names = glb.refused_glb(|json| {
            json["nodes"][0]["name"] = serde_json::json!(second);
            json["nodes"][1]["name"] = serde_json::json!(first);
        });
        assert_eq!(names, format!("node 0 is `{second}` in the file, `{first}` in the model"));
        let lost = glb.refused_glb(|json| json["nodes"][ROOT]["children"] = serde_json::json!([0]));
        assert!(lost.contains("children"), "{lost}");
    }
}

#[test]
fn meshes_and_tables_say_what_they_can() {
    let obj = Damage::new(bodies(), Format::Obj);
    assert_eq!(obj.refused(&[("# cyclide, units in", "# cyclide, units mm")]), UNIT);
    assert_eq!(
        obj.refused(&[("\ng s0\n", "\ng s1\n"), ("\ng s1\n", "\ng s0\n")]),
        "group 0 is `s1` in the file, `s0` in the model"
    );
    assert_eq!(obj.refused(&[("\no s0\n", "\no s1\n")]), "object 0 is `s1` in the file, `s0` in the model");
    let stl = Damage::new(bodies(), Format::Stl);
    let changed = stl.bytes(|bytes| bytes[15..17].copy_from_slice(b"mm"));
    assert_eq!(changed.unwrap_err().to_string(), UNIT);
    let changed = stl.bytes(|bytes| bytes[19] = b'x');
    assert!(changed.unwrap_err().to_string().starts_with("title 0 is `xyclide`"));
    let csv = Damage::new(twins(), Format::Csv);
    let names = [("\nslot,", "\nother,"), ("\nother,", "\nslot,")];
    assert_eq!(csv.refused(&names), "object 0 is `other` in the file, `slot` in the model");
    assert_eq!(csv.refused(&[("\nslot,1,", "\nslot,2,")]), "contour 1 is `2` in the file, `1` in the model");
}

/// Awkward names are as right as others, whatever a format makes of them.
#[test]
fn names_of_any_letters_are_right() {
    let long = "name ".repeat(60);
    let names = [
        "",
        " ",
        "a ",
        " b",
        "\"q\"",
        "x,y",
        "# z",
        "it's \\ <&>",
        "円\u{1F600}",
        "\u{FFFE}\u{85}\n",
        "HULL",
        "hull",
        &long,
    ];
    let mut curves = mixed(flat);
    let item = curves.items[0].clone();
    curves.items = names.iter().map(|name| cyclide::model::Item { name: (*name).to_owned(), ..item.clone() }).collect();
    let mut meshes = curve_and_surfaces();
    let copies = meshes.items.clone();
    meshes.items = names
        .iter()
        .flat_map(|name| copies.iter().map(|item| cyclide::model::Item { name: (*name).to_owned(), ..item.clone() }))
        .collect();
    let ring = cyclide::surface::DupinCyclide::new(3.0, 0.0, 1.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let solids = names.iter().fold(Model::default(), |model, name| model.with_surface(*name, ring.clone()));
    for title in [None, Some("円, \"t\" ".to_owned()), Some(long.clone())] {
        let options = ExportOptions { tolerance: Some(0.3), title, ..ExportOptions::default() };
        for format in Format::ALL.iter().copied().filter(|format| format.has_geometry()) {
            // In JSON objects are told apart by their names.
            let model = match format {
                Format::Dxf | Format::Csv | Format::Json => &curves,
                Format::ThreeMf => &solids,
                _ => &meshes,
            };
            let _ = Damage::with(model.clone(), format, &options);
        }
        let r12 = ExportOptions { dxf_version: DxfVersion::R12, ..options.clone() };
        let _ = Damage::with(curves.clone(), Format::Dxf, &r12);
    }
}
