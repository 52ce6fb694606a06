//! What documents of motions are told of, at its place: turns without a time, reversals, half and whole turns.

use crate::{build, build_all, motion, reported};

fn told(fields: &str) -> Vec<(&'static str, Option<String>)> {
    build(&motion(fields)).unwrap().remarks.into_iter().map(|remark| (remark.reason, remark.place)).collect()
}

#[test]
fn a_turn_on_the_spot_is_refused_at_its_poses() {
    let fields = r#""kind": "sclerp", "law": "constant-speed", "poses": [{"position": [0, 0]}, {"position": [20, 0]},
        {"position": [20, 0], "rpy": {"degrees": [0, 0, 90]}}, {"position": [30, 0], "rpy": {"degrees": [0, 0, 90]}}]"#;
    let error = build(&motion(fields)).unwrap_err();
    let says = ["objects.m.poses[1]: span 1", "rotates by 90 degrees in place", "give an `arm`", "[span-without-way]"];
    assert!(says.iter().all(|part| error.contains(part)), "{error}");
    // With an arm of 10 the turn is 15.7 of the way of 45.7.
    let (found, text) = reported(&format!(r#"{fields}, "arm": 10, "duration": 4"#));
    let turn = 5.0 * std::f64::consts::PI;
    let times = found.pose_times.unwrap();
    assert!((times[2] - times[1] - 4.0 * turn / (30.0 + turn)).abs() < 1e-9, "{text}");
}

/// The velocity turns over within two spans: the report has when, by how much, and no bound for the acceleration.
#[test]
fn a_reversal_within_a_span_is_in_the_report() {
    let fields = r#""law": "constant-speed", "duration": 3,
        "poses": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [10, 0]}, {"position": [11, 0]}]"#;
    let (found, text) = reported(fields);
    assert_eq!(found.reversals.len(), 2, "{text}");
    let speed = found.length / 3.0;
    assert!((found.speed.max - speed).abs() < 1e-9 && (found.velocity_jump - 2.0 * speed).abs() < 1e-6, "{text}");
    assert!(found.acceleration.is_infinite() && text.contains("acceleration without bound"), "{text}");
    assert!(text.contains("turns back"), "{text}");
    assert!(
        told(fields)
            .iter()
            .any(|(reason, place)| *reason == "motion-reverses" && place.as_deref() == Some("objects.m.poses"))
    );
    let json = serde_json::to_value(&found).unwrap();
    assert!(
        json["acceleration"].is_null() && json["reversals"][1]["span"] == 2 && json["acceleration_at"]["span"] == 0,
        "{json}"
    );
}

#[test]
fn half_and_whole_turns_are_told() {
    // Turns on the spot, which leave no straight line.
    let to = |rotation: &str| format!(r#""poses": [{{"position": [1, 0]}}, {{"position": [1, 0], {rotation}}}]"#);
    for rotation in [r#""rpy": {"degrees": [0, 0, 180]}"#, r#""quaternion": [0, 0, 0, -1]"#] {
        assert_eq!(told(&to(rotation)), [("half-turn", Some("objects.m.poses".to_owned()))]);
    }
    let matrix = r#""poses": [{"position": [1, 0]}, {"matrix": [[-1, 0, 0, 1], [0, -1, 0, 0], [0, 0, 1, 0]]}]"#;
    assert_eq!(told(matrix)[0].0, "half-turn");
    assert!(told(&to(r#""rpy": {"degrees": [0, 0, 179.99]}"#)).is_empty());
    // Turns that are lost, and headings that come round.
    let place = Some("objects.m.poses[1].rpy[2]".to_owned());
    assert_eq!(told(&to(r#""rpy": {"degrees": [0, 0, 720]}"#)), [("whole-turns", place)]);
    let round = r#""poses": [{"position": [0, 0], "rpy": {"degrees": [0, 0, -180]}}, {"position": [1, 0], "rpy": {"degrees": [0, 0, 180]}},
        {"position": [2, 0], "rpy": {"degrees": [0, 0, -180]}}]"#;
    assert!(told(round).is_empty(), "{:?}", told(round));
    let table = |angles: [f64; 2]| {
        let text = format!("x,y,z,roll_deg,pitch_deg,yaw_deg\n0,0,0,0,0,{}\n1,0,0,0,0,{}\n", angles[0], angles[1]);
        let built = build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), &text).unwrap().pop().unwrap();
        built.remarks.into_iter().map(|remark| (remark.reason, remark.place)).collect::<Vec<_>>()
    };
    assert_eq!(table([0.0, 360.0]), [("whole-turns", Some("poses.csv:3".to_owned()))]);
    assert!(table([350.0, 10.0]).is_empty());
    // A whole turn of six digits is one, in either notation; a millionth more than what digits leave unknown is not.
    let six = |angle: &str| told(&to(&format!(r#""rpy": [0, 0, {angle}]"#)));
    assert_eq!(six("6.283185").iter().map(|(reason, _)| *reason).collect::<Vec<_>>(), ["whole-turns"]);
    assert!(six("6.28318").is_empty());
    assert_eq!(table([-179.99995, 180.0]), []);
    assert_eq!(table([0.0, 359.9999]).len(), 1);
}

/// Motions whose times begin apart play together, and that is said; poses of a curve without frames are told how to get them.
#[test]
fn clocks_and_frames_are_told() {
    let notes_of = |starts: [u32; 2]| {
        let body = |name: &str, from: u32| {
            let [a, b] = [from, from + 5].map(|time| format!(r#"{{"position": [{time}, 0], "time": {time}}}"#));
            format!(r#""{name}": {{"type": "motion", "poses": [{a}, {b}]}}"#)
        };
        let model = crate::model(&format!("{}, {}", body("a", starts[0]), body("b", starts[1])));
        let exporter = cyclide_io::Exporter::new(&model).unwrap();
        exporter.export(cyclide_io::Format::Glb, &cyclide_io::ExportOptions::default()).unwrap().notes
    };
    let notes = |start: u32| notes_of([0, start]);
    assert!(notes(0).is_empty());
    // Seconds since 1970 have the digits that differ.
    let [note] = &notes_of([1_700_000_000, 1_700_000_001])[..] else { panic!("one") };
    assert!(note.contains("a begin at 1700000000 and those of b at 1700000001"), "{note}");
    let [note] = &notes(5)[..] else { panic!("one") };
    assert!(
        note.contains("the times of a begin at 0 and those of b at 5") && note.contains("[clocks-differ]"),
        "{note}"
    );
    let table = "t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,signed_curvature,torsion\n0,0,0,0,1,0,0,0,0,,\n1,5,0,0,1,0,0,0,5,,\n";
    let error = build_all(&motion(r#""poses": {"csv": "poses.csv"}"#), table).unwrap_err();
    assert!(error.contains("`cyclide sample --frames KIND`"), "{error}");
}

/// What is too fast for its keys is told what helps: an arm, where a law goes by the way already.
#[test]
fn animations_that_are_too_fast_say_what_helps() {
    let near = r#""poses": [{"position": [0, 0]}, {"position": [40, 0]}, {"position": [40.000000001, 0], "rpy": [0, 0, 1.5]}, {"position": [80, 0], "rpy": [0, 0, 1.5]}]"#;
    for (law, advice) in [("constant-speed", "set or increase `arm`"), ("as-given", "")] {
        let fields = format!(r#""kind": "sclerp", "law": "{law}", {near}"#);
        let file = cyclide_io::Exporter::new(&crate::model(&motion(&fields)))
            .unwrap()
            .export(cyclide_io::Format::Glb, &cyclide_io::ExportOptions::default());
        match file {
            Ok(_) => assert!(advice.is_empty(), "{law}"),
            Err(error) => assert!(!advice.is_empty() && error.to_string().contains(advice), "{error}"),
        }
    }
}

/// What is advised against a spike helps there: a spline for a motion of least degree, an arm under a law by the way of a tool that hardly moves.
#[test]
fn spikes_are_told_with_what_helps() {
    let spike = r#""kind": "conic", "poses": [{"position": [-5.8, 1.4, -1.3], "quaternion": [0.4, -0.3, -0.9, -0.6]},
        {"position": [-6.4, 4.2, 3.4], "quaternion": [0.1, -0.4, 0.5, -0.1]}, {"position": [-0.1, -5.5, 8.9], "quaternion": [-0.1, -0.1, -0.6, -0.1]}]"#;
    let advice = |fields: &str| {
        let told = build(&motion(fields)).unwrap().remarks.into_iter().find(|remark| remark.reason == "speed-spike");
        told.map(|remark| remark.message)
    };
    let message = advice(spike).unwrap();
    assert!(message.contains("rotates 103.13 times") && message.contains("use a spline"), "{message}");
    assert_eq!(advice(&spike.replace("conic", "spline")), None);
    if let Some(message) = advice(&format!(r#"{spike}, "law": "constant-speed""#)) {
        assert!(message.contains("set or increase `arm`"), "{message}");
    }
    assert_eq!(advice(&format!(r#"{spike}, "law": "constant-speed", "arm": 50"#)), None);
}
