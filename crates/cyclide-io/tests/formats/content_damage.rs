//! What files say beside the points of curves and surfaces, damaged in the bytes: points are all right, and the check says
//! what is not.

use crate::damage::Damage;
use crate::label_damage::{bodies, twins};
use crate::models::{circle_spline, coil, curve_and_surfaces, flat, model, slot, space_chain, wave};
use cyclide::{
    curve::BlendVariant,
    model::{CurveObject, Model},
};
use cyclide_io::{
    ExportOptions, Format,
    export::{DxfVersion, StepEdges},
};
use serde_json::{Value, json};

/// Two curves in space, each of several arcs and segments.
fn in_space() -> Model {
    let chain = || CurveObject::ArcPath(space_chain());
    model(vec![("low", vec![chain()]), ("high", vec![chain(), chain()])])
}

/// A rational spline.
fn spline() -> Model {
    model(vec![("coil", vec![circle_spline(&coil(5), false, BlendVariant::Rational, vec![])])])
}

#[test]
fn dxf_groups_have_their_names_and_members() {
    let dxf = Damage::new(in_space(), Format::Dxf);
    let entry = |name: &str| format!("\n  3\n{name}\n350\n");
    let [low, high] = [entry("low_1"), entry("high 1_3")];
    assert_eq!(dxf.refused(&[(&low, &entry("x"))]), "group 0 is `x` in the file, `low_1` in the model");
    assert_eq!(dxf.refused(&[(&low, &high), (&high, &low)]), "group 0 is `high 1_3` in the file, `low_1` in the model");
    let text = String::from_utf8(dxf.file.bytes.clone()).unwrap();
    let group = text.find("AcDbGroup").unwrap();
    let member = group + text[group..].find("340\n").unwrap();
    let end = member + text[member..].match_indices('\n').nth(1).unwrap().0 + 1;
    let lost = [&text[..member], &text[end..]].concat();
    let message = dxf.bytes(|bytes| *bytes = lost.into_bytes()).unwrap_err().to_string();
    assert!(message.contains("the members of the groups differ from the entities that name these groups"), "{message}");
    // All of it gone: the arcs still hang together.
    let start = text[..group].rfind("  0\nGROUP\n").unwrap();
    let without: Vec<String> = text[..start]
        .split("102\n{ACAD_REACTORS\n")
        .map(|part| match part.split_once("102\n}\n") {
            Some((_, rest)) => rest.to_owned(),
            None => part.to_owned(),
        })
        .collect();
    let without = [&without.concat(), "  0\nENDSEC\n  0\nEOF\n"].concat();
    let without = ["low_1", "high 0_2", "high 1_3"].iter().fold(without, |text, name| {
        let (before, rest) = text.split_once(&entry(name)).unwrap();
        let (_, after) = rest.split_once('\n').unwrap();
        [before, "\n", after].concat()
    });
    let message = dxf.bytes(|bytes| *bytes = without.into_bytes()).unwrap_err().to_string();
    assert_eq!(message, "group 0, `low_1`, is not in the file");
}

/// The text with field `column` of line `line` replaced.
fn with_field(text: &str, line: usize, column: usize, value: &str) -> Vec<u8> {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut fields: Vec<&str> = lines[line].split(',').collect();
    fields[column] = value;
    lines[line] = fields.join(",");
    (lines.join("\n") + "\n").into_bytes()
}

#[test]
fn csv_columns_are_those_of_the_curve() {
    let csv = Damage::new(twins(), Format::Csv);
    let text = String::from_utf8(csv.file.bytes.clone()).unwrap();
    let field = |line: usize, column: usize| text.lines().nth(line).unwrap().split(',').nth(column).unwrap();
    let changed = |line: usize, column: usize, value: &str| {
        csv.bytes(|bytes| *bytes = with_field(&text, line, column, value)).unwrap_err().to_string()
    };
    // Line 0 has the names of the columns, line 1 begins a straight side along the first axis.
    assert_eq!((field(1, 6), field(1, 9)), ("1", "0"));
    assert_eq!(changed(1, 6, "-1"), "curve 0, point 0: the x of the tangent is -1 in the file, 1 in the model");
    assert_eq!(changed(1, 7, "1e-9"), "curve 0, point 0: the y of the tangent is 1e-9 in the file, 0 in the model");
    assert_eq!(changed(1, 9, "0.5"), "curve 0, point 0: the curvature is 0.5 in the file, 0 in the model");
    assert_eq!(changed(1, 9, ""), "curve 0, point 0: the curvature is none in the file, 0 in the model");
    assert_eq!(changed(2, 2, "0.3"), "curve 0, point 1: the parameter is 0.3 in the file, 0.25 in the model");
    assert!(changed(1, 8, "").contains("a component of the tangent is missing"));
}

#[test]
fn glb_materials_are_those_of_the_pictures() {
    let glb = Damage::new(curve_and_surfaces(), Format::Glb);
    let factor = |i: usize| format!("/materials/{i}/pbrMetallicRoughness/baseColorFactor/0");
    let set = |path: String, value: Value| move |json: &mut Value| *json.pointer_mut(&path).unwrap() = value;
    assert_eq!(
        glb.refused_glb(set(factor(0), json!(1.0))),
        "material 0 is `slot lines, #FF2A41, unlit` in the file, `slot lines, #1B2A41, unlit` in the model"
    );
    assert_eq!(
        glb.refused_glb(set(factor(1), json!(0.0))),
        "material 1 is `s0, #00DAD4` in the file, `s0, #B4DAD4` in the model"
    );
    assert!(glb.refused_glb(set("/meshes/1/primitives/0/material".to_owned(), json!(2))).contains("is `s1, #"));
    let transparent = set("/materials/1/pbrMetallicRoughness/baseColorFactor/3".to_owned(), json!(0.5));
    assert!(glb.refused_glb(transparent).contains("an unexpected kind of material"));
    assert!(glb.refused_glb(set("/materials/1/doubleSided".to_owned(), json!(false))).contains("unexpected kind"));
    let lit = glb.refused_glb(|json| drop(json["materials"][0].as_object_mut().unwrap().remove("extensions")));
    assert!(lit.contains("unexpected kind"), "{lit}");
    let unsaid = glb.refused_glb(|json| drop(json.as_object_mut().unwrap().remove("extensionsUsed")));
    assert!(unsaid.contains("KHR_materials_unlit is used but not declared"), "{unsaid}");
}

#[test]
fn glb_edges_are_those_of_the_patches() {
    let options = ExportOptions { glb_edges: true, tolerance: Some(0.1), ..ExportOptions::default() };
    let glb = Damage::with(bodies(), Format::Glb, &options);
    let json = {
        let length = u32::from_le_bytes(glb.file.bytes[12..16].try_into().unwrap()) as usize;
        serde_json::from_slice::<Value>(&glb.file.bytes[20..20 + length]).unwrap()
    };
    let lines = &json["meshes"][1]["primitives"][1];
    assert_eq!(lines["mode"], 1);
    let accessor = lines["indices"].as_u64().unwrap() as usize;
    let count = json["accessors"][accessor]["count"].as_u64().unwrap() as usize;
    // They end the file: the last line becomes the one before it, then one through the inside.
    let words = |bytes: &mut [u8], change: &dyn Fn(&mut [u32])| {
        let start = bytes.len() - 4 * count;
        let mut indices: Vec<u32> =
            bytes[start..].chunks_exact(4).map(|b| u32::from_le_bytes(b.try_into().unwrap())).collect();
        change(&mut indices);
        let new: Vec<u8> = indices.iter().flat_map(|i| i.to_le_bytes()).collect();
        bytes[start..].copy_from_slice(&new);
    };
    let wrong = "1 lines on the mesh of s1 are not edges of its patches, and 1 edges have no line";
    for change in [
        &(|i: &mut [u32]| i.copy_within(count - 4..count - 2, count - 2)) as &dyn Fn(&mut [u32]),
        &|i: &mut [u32]| i[count - 1] = i[0],
    ] {
        assert_eq!(glb.bytes(|bytes| words(bytes, change)).unwrap_err().to_string(), wrong);
    }
    let all = format!("0 lines on the mesh of s1 are not edges of its patches, and {} edges have no line", count / 2);
    let none = |json: &mut Value| drop(json["meshes"][1]["primitives"].as_array_mut().unwrap().pop());
    assert_eq!(glb.refused_glb(none), all);
    // Edges that nobody asked for.
    let plain = Damage::new(bodies(), Format::Glb);
    let more = plain.refused_glb(|json| {
        let position = json["meshes"][1]["primitives"][0]["attributes"]["POSITION"].clone();
        let material = json["materials"].as_array().unwrap().len();
        let unlit = json!({"name": "s1 lines", "extensions": {"KHR_materials_unlit": {}},
            "pbrMetallicRoughness": {"baseColorFactor": [0.0, 0.0, 0.0, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.45}});
        json["materials"].as_array_mut().unwrap().push(unlit);
        json["extensionsUsed"] = json!(["KHR_materials_unlit"]);
        let indices = json["meshes"][1]["primitives"][0]["indices"].clone();
        // Six indices or more, an even number.
        let lines = json!({"attributes": {"POSITION": position}, "indices": indices, "material": material, "mode": 1});
        json["meshes"][1]["primitives"].as_array_mut().unwrap().push(lines);
    });
    assert!(more.ends_with("are not edges of its patches, and 0 edges have no line"), "{more}");
}

#[test]
fn json_says_how_exact_it_is() {
    let closed = CurveObject::ArcPath(slot(flat));
    let wavy = circle_spline(&wave(flat, 12), true, BlendVariant::Trigonometric, vec![]);
    let options = ExportOptions { tolerance: Some(0.0625), ..ExportOptions::default() };
    let json = Damage::with(model(vec![("a", vec![closed]), ("b", vec![wavy])]), Format::Json, &options);
    let message = json.refused_json(|json| json["objects"]["a"]["contours"][0]["exact"] = json!(false));
    assert_eq!(message, "bound of curve 0 is `0` in the file, `exact, 0` in the model");
    let message = json.refused_json(|json| json["objects"]["a"]["contours"][0]["bound"] = json!(0.5));
    assert_eq!(message, "bound of curve 0 is `exact, 0.5` in the file, `exact, 0` in the model");
    let message = json.refused_json(|json| json["objects"]["b"]["contours"][0]["bound"] = json!(0));
    assert!(message.starts_with("bound of curve 1 is `0` in the file, `0.0"), "{message}");
    let json = Damage::new(bodies(), Format::Json);
    let message = json.refused_json(|json| json["objects"]["s0"]["surfaces"][0]["closed"] = json!(true));
    assert_eq!(message, "body 0 is `closed` in the file, `open` in the model");
    let message = json.refused_json(|json| json["objects"]["s1"]["surfaces"][0]["exact"] = json!(false));
    assert_eq!(message, "body 1 is `open, not exact` in the file, `open` in the model");
}

/// Twice all knots: the same points.
#[test]
fn knots_are_those_that_were_made() {
    let doubled = |knots: &mut Value| {
        for knot in knots.as_array_mut().unwrap() {
            *knot = json!(2.0 * knot.as_f64().unwrap());
        }
    };
    for m in [spline(), twins()] {
        let json = Damage::new(m, Format::Json);
        let message = json.refused_json(|json| {
            let object = json["objects"].as_object_mut().unwrap().values_mut().next().unwrap();
            doubled(&mut object["contours"][0]["curves"][0]["knots"]);
        });
        assert!(message.starts_with("a knot of curve 0 is "), "{message}");
    }
    // The middle of an arc of half a turn is where its two quarters meet.
    let json = Damage::new(twins(), Format::Json);
    let half = |json: &mut Value| {
        for knot in json["objects"]["slot"]["contours"][0]["curves"][0]["knots"].as_array_mut().unwrap() {
            if *knot == 1.5 {
                *knot = json!(1.25);
            }
        }
    };
    assert_eq!(json.refused_json(half), "a knot of curve 0 is 1.25 in the file, 1.5 was made");
    let rational = ExportOptions { step_edges: StepEdges::Rational, ..ExportOptions::default() };
    let step = Damage::with(spline(), Format::Step, &rational);
    let text = String::from_utf8(step.file.bytes.clone()).unwrap();
    let (before, rest) = text.split_once("B_SPLINE_CURVE_WITH_KNOTS((").unwrap();
    let (multiplicities, rest) = rest.split_once("),(").unwrap();
    let (knots, after) = rest.split_once(')').unwrap();
    let twice: Vec<String> =
        knots.split(',').map(|knot| format!("{:?}", 2.0 * knot.trim().parse::<f64>().unwrap())).collect();
    let changed = [before, "B_SPLINE_CURVE_WITH_KNOTS((", multiplicities, "),(", &twice.join(","), ")", after].concat();
    let message = step.bytes(|bytes| *bytes = changed.into_bytes()).unwrap_err().to_string();
    assert!(message.starts_with("a knot of curve 0 is "), "{message}");
    let splines = ExportOptions { dxf_splines: true, dxf_version: DxfVersion::R2000, ..ExportOptions::default() };
    let dxf = Damage::with(spline(), Format::Dxf, &splines);
    let text = String::from_utf8(dxf.file.bytes.clone()).unwrap();
    let (before, spline) = text.split_once("AcDbSpline").unwrap();
    let mut lines: Vec<String> = spline.lines().map(str::to_owned).collect();
    for i in 1..lines.len() {
        if lines[i - 1].trim() == "40" && i % 2 == 0 {
            lines[i] = format!("{:?}", 2.0 * lines[i].parse::<f64>().unwrap());
        }
        if lines[i].trim() == "ENDSEC" {
            break;
        }
    }
    let changed = [before, "AcDbSpline", &lines.join("\n"), "\n"].concat();
    let message = dxf.bytes(|bytes| *bytes = changed.into_bytes()).unwrap_err().to_string();
    assert!(message.starts_with("a knot of curve 0 is "), "{message}");
}
