//! Keys of animations: within the tolerance, or refused.

use crate::{build, model, motion};
use cyclide::model::{Model, Units};
use cyclide_io::{ExportOptions, Exporter, Format};

/// A conic through poses on both sides of half a turn, of which the middle one is far from the way of the others.
const SPIKE: &str = r#""kind": "conic", "poses": [{"position": [0, 0, 0]}, {"position": [40, 5, 3], "quaternion": [0.002, 1, 0.1, 0.2]}, {"position": [50, -20, 7], "quaternion": [-1, 0.3, -0.2, 0.1]}]"#;

#[test]
fn durations_are_those_that_numbers_tell() {
    let of = |duration: &str| {
        build(&motion(&format!(
            r#""duration": {duration}, "poses": [{{"position": [0, 0]}}, {{"position": [30, 0]}}]"#
        )))
    };
    for duration in ["1e-320", "1e-91", "1e91", "0", "-1"] {
        let error = of(duration).err().unwrap();
        assert!(error.contains("duration") && error.contains("parameter-out-of-range"), "{duration}: {error}");
    }
    for duration in ["1e39", "1e21", "1e-21", "1e-60"] {
        let model = Model { units: Units::Millimetre, items: vec![of(duration).unwrap().item] };
        let error = Exporter::new(&model).unwrap().export(Format::Glb, &ExportOptions::default()).err().unwrap();
        assert_eq!(error.reason(), "duration-out-of-range", "{duration}: {error}");
        assert!(error.to_string().contains("1e-20 to 1e20 seconds"), "{error}");
    }
    for duration in ["1e20", "1e-20"] {
        let model = Model { units: Units::Millimetre, items: vec![of(duration).unwrap().item] };
        let exporter = Exporter::new(&model).unwrap();
        let file = exporter.export(Format::Glb, &ExportOptions::default()).unwrap();
        exporter.check("m.glb".as_ref(), Format::Glb, &file).unwrap();
    }
}

/// Keys are set until the tolerance is kept, also where the body rushes; where they cannot, the file is refused.
#[test]
fn keys_keep_the_tolerance_or_are_refused() {
    let uneven = |step: &str| {
        format!(
            r#""kind": "sclerp", "poses": [{{"position": [0, 0], "time": 0}}, {{"position": [1, 0], "time": 10}}, {{"position": [101, 0], "time": {step}}},
            {{"position": [101, 0], "rpy": [0, 0, 1], "time": 11}}, {{"position": [102, 9], "rpy": [0, 0, 2], "time": 12}}]"#
        )
    };
    for (fields, tolerance) in [(SPIKE.to_owned(), 1e-3), (SPIKE.to_owned(), 1e-5), (uneven("10.001"), 0.1)] {
        let model = model(&motion(&fields));
        let exporter = Exporter::new(&model).unwrap();
        let options = ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() };
        let file = exporter.export(Format::Glb, &options).unwrap();
        let report = exporter.check("m.glb".as_ref(), Format::Glb, &file).unwrap();
        // Single precision costs up to 6e-7 of the 160 units that the body and its axes reach.
        assert!(report.deviation.unwrap() <= tolerance + 1e-4, "{tolerance}: {report:?}");
    }
    // A hundred units within a millisecond, which at 10 seconds has a thousand steps of single precision, and within less than one of them.
    for (step, tolerance) in [("10.001", 1e-3), ("10.0000001", 0.1)] {
        let model = model(&motion(&uneven(step)));
        let options = ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() };
        let error = Exporter::new(&model).unwrap().export(Format::Glb, &options).err().unwrap();
        assert_eq!(error.reason(), "animation-above-tolerance", "{error}");
        assert!(error.to_string().contains(" deviates by ") && error.to_string().contains(" at 10"), "{error}");
    }
}

/// Viewers play one animation: all bodies are in it, each with its own duration, and the file is read back by their names.
#[test]
fn several_bodies_move_in_one_animation() {
    let two = r#""a": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [30, 0]}], "duration": 2},
        "b": {"type": "motion", "kind": "sclerp", "poses": [{"position": [0, 50]}, {"position": [30, 60], "rpy": [0, 1, 0]}], "duration": 5}"#;
    let model = model(two);
    let exporter = Exporter::new(&model).unwrap();
    let file = exporter.export(Format::Glb, &ExportOptions::default()).unwrap();
    exporter.check("m.glb".as_ref(), Format::Glb, &file).unwrap();
    let length = u32::from_le_bytes(file.bytes[12..16].try_into().unwrap()) as usize;
    let document: serde_json::Value = serde_json::from_slice(&file.bytes[20..20 + length]).unwrap();
    let animations = document["animations"].as_array().unwrap();
    let counts = ["samplers", "channels"].map(|list| animations[0][list].as_array().unwrap().len());
    assert!(animations.len() == 1 && animations[0]["name"] == "all motions" && counts == [4, 4], "{animations:?}");
    // Other names, another order, another motion.
    let changes: [fn(&mut Vec<cyclide::model::Item>); 3] =
        [|items| items[1].name = "c".to_owned(), |items| items.swap(0, 1), |items| drop(items.pop())];
    for change in changes {
        let mut other = model.clone();
        change(&mut other.items);
        assert!(Exporter::new(&other).unwrap().check("m.glb".as_ref(), Format::Glb, &file).is_err());
    }
}

/// A straight path there and back is a closed curve of two points, and one line in the file.
#[test]
fn a_straight_way_there_and_back_is_drawn() {
    let poses = r#""poses": [{"position": [0, 0]}, {"position": [10, 0]}, {"position": [0, 0]}], "construction": true"#;
    let model = model(&format!(r#"{}, "t": {{"type": "trajectory", "of": "m"}}"#, motion(poses)));
    let exporter = Exporter::new(&model).unwrap();
    let file = exporter.export(Format::Glb, &ExportOptions::default()).unwrap();
    let report = exporter.check("m.glb".as_ref(), Format::Glb, &file).unwrap();
    assert!(report.deviation.unwrap() < 1e-5, "{report:?}");
}
