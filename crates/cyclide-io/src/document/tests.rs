use super::*;

fn parse(text: &str) -> Result<Document, String> {
    Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())
}

fn object(fields: &str) -> Result<Document, String> {
    parse(&format!("{{\"cyclide\": 1, \"objects\": {{\n\"a\": {{ {fields} }} }} }}"))
}

#[test]
fn a_document_keeps_order_units_and_fields() {
    let document = parse(
        r#"{"$schema": "cyclide-1.schema.json", "cyclide": 1, "units": "m", "objects": {
            "z": {"type": "circle", "center": [0, 0], "radius": 2},
            "a": {"radius": 2, "type": "circle", "center": [0, 0, 1], "normal": [0, 1, 0]}}}"#,
    )
    .unwrap();
    assert_eq!(document.units, Units::Metre);
    assert_eq!(document.objects.iter().map(|(n, _)| n.as_str()).collect::<Vec<_>>(), ["z", "a"]);
    let ObjectSpec::Circle(circle) = &document.objects[1].1 else { panic!("a circle") };
    assert_eq!(circle.center, Some(Coordinates([0.0, 0.0, 1.0])));
    assert_eq!(parse(r#"{"cyclide":1,"objects":{}}"#).unwrap().units, Units::Millimetre);
}

#[test]
fn what_is_no_document_is_refused() {
    for (text, start) in [
        ("", "m.json:1:1: the file is empty"),
        (" \n\t", "m.json:1:1: the file is empty"),
        ("[]", "m.json:1:1: invalid type: sequence, expected an object"),
        ("{}", "m.json:1:1: not a cyclide document"),
        ("{\"cyclide\": 2}", "m.json:1:13: cyclide: unknown document version 2: this program reads version 1"),
        ("{\"cyclide\": \"1\"}", "m.json:1:13: cyclide: unknown document version \"1\""),
        ("{\"cyclide\": 1}", "m.json:1:1: missing field `objects`"),
        ("{\"cyclide\": 1, \"objects\": {}} x", "m.json:1:31: the document ended before this"),
        ("{\"cyclide\": 1,\n \"objects\": {},\n}", "m.json:3:1: trailing comma before `}`"),
        ("{\"cyclide\": 1, \"objects\": {\"a\": {\"b\": 1, }}}", "m.json:1:42: trailing comma before `}`"),
        ("{\"cyclide\": 1, \"objects\": {\"a\": [1, 2,]}}", "m.json:1:39: trailing comma before `]`"),
        ("{\"cyclide\": 1, \"objects\": {\"a\": [1, 2", "m.json:1:37: the file ends inside a list: a `]` is missing"),
        ("{\"cyclide\": 1, \"objects\": ", "m.json:1:26: the file ends where a value is expected"),
        ("{'cyclide': 1}", "m.json:1:2: names and strings need double quotes"),
        ("{cyclide: 1}", "m.json:1:2: a name in double quotes is expected here"),
        ("{\"cyclide\": 1, // mine\n \"objects\": {}}", "m.json:1:16: JSON has no comments"),
        ("{\"cyclide\": 1, \"objects\": {}, \"unit\": \"mm\"}", "m.json:1:31: unknown field `unit`, expected one of"),
        ("{\"cyclide\": 1, \"objects\": {}, \"units\": \"yd\"}", "m.json:1:40: units: unknown variant `yd`"),
        ("{\"cyclide\": 1, \"objects\": {\"a\": {}, \"a\": {}}}", "m.json:1:37: objects: the name `a` is used twice"),
    ] {
        let message = parse(text).unwrap_err();
        assert!(message.starts_with(start), "{text}: {message}");
    }
}

#[test]
fn fields_are_checked_with_their_place() {
    for (fields, start) in [
        ("", "m.json:2:6: objects.a: missing field `type`: one of `arc`, `circle`"),
        ("\"type\": \"sphere\"", "m.json:2:16: objects.a.type: unknown type `sphere`, expected one of `arc`"),
        ("\"type\": 7", "m.json:2:16: objects.a.type: invalid type: integer `7`, expected a string"),
        ("\"type\": \"offset\", \"distance\": 1", "m.json:2:6: objects.a: missing field `of`"),
        (
            "\"type\": \"circle\", \"center\": [0,0], \"radius\": 1, \"diameter\": 2",
            "m.json:2:56: objects.a: unknown field `diameter`, expected one of",
        ),
        ("\"type\": \"circle\", \"center\": [0,0], \"radius\": \"1\"", "m.json:2:53: objects.a.radius: invalid type"),
        (
            "\"type\": \"arc-spline\", \"points\": [[0,0],[1,null]]",
            "m.json:2:50: objects.a.points[1][1]: invalid type: null, expected a number",
        ),
        (
            "\"type\": \"arc-spline\", \"points\": {\"csv\": \"a\", \"column\": 1}",
            "m.json:2:53: objects.a.points: unknown field `column`",
        ),
        (
            "\"type\": \"circle-spline\", \"points\": [[0,0]], \"ends\": \"free\"",
            "m.json:2:60: objects.a.ends: unknown variant `free`, expected `natural`",
        ),
        (
            "\"type\": \"fair-spline\", \"points\": [[0,0]], \"ends\": \"natural\"",
            "m.json:2:58: objects.a.ends: unknown variant `natural`, expected one of `circle`, `arc`, `free`",
        ),
        (
            "\"type\": \"fair-spline\", \"points\": [[0,0]], \"ends\": {\"start\": 3}",
            "m.json:2:68: objects.a.ends.start: invalid type",
        ),
        ("\"type\": \"arc-fit\", \"points\": [[0,0],[1,1]]", "m.json:2:6: objects.a: missing field `tolerance`"),
        ("\"type\": \"arc\", \"through\": null", "m.json:2:34: objects.a.through: null is not allowed here"),
        ("\"type\": \"arc\", \"type\": \"arc\"", "m.json:2:23: objects.a: the name `type` is used twice"),
    ] {
        let message = object(fields).unwrap_err();
        assert!(message.starts_with(start), "{fields}: {message}");
    }
}

#[test]
fn every_object_and_the_document_take_comments() {
    for kind in ObjectSpec::TYPES {
        let text = ObjectSpec::starter(kind).unwrap();
        let document = parse(text).unwrap();
        assert!(document.objects.iter().any(|(_, spec)| spec.type_word() == *kind), "{text}");
        // Comments change nothing: with them taken out the document is the same.
        let mut bare: serde_json::Value = serde_json::from_str(text).unwrap();
        bare.as_object_mut().unwrap().remove("comment").unwrap();
        for object in bare["objects"].as_object_mut().unwrap().values_mut() {
            object.as_object_mut().unwrap().remove("comment").unwrap();
        }
        assert_eq!(parse(&bare.to_string()).unwrap().objects, document.objects);
    }
    assert_eq!(ObjectSpec::starter("sphere"), None);
    let circle = "\"type\": \"circle\", \"center\": [0,0], \"radius\": 1, \"comment\"";
    assert!(object(&format!("{circle}: \"one, with null in it\"")).is_ok());
    assert!(object(&format!("{circle}: []")).is_ok());
    for (comment, start) in [
        ("7", "m.json:2:67: objects.a.comment: invalid type: integer `7`, expected a string or a list of strings"),
        ("[\"a\", 7]", "m.json:2:73: objects.a.comment[1]: invalid type: integer `7`, expected a string"),
        ("{}", "m.json:2:67: objects.a.comment: invalid type: map, expected a string or a list of strings"),
    ] {
        let message = object(&format!("{circle}: {comment}")).unwrap_err();
        assert!(message.starts_with(start), "{message}");
    }
    assert!(parse("{\"cyclide\": 1, \"comment\": 1, \"objects\": {}}").unwrap_err().contains("comment: invalid type"));
}

#[test]
fn the_word_null_may_stand_in_names() {
    let name = r#"null \"null\\"#;
    let text = format!(r#"{{"cyclide":1,"objects":{{"{name}":{{"type":"circle","center":[0,0],"radius":1}}}}}}"#);
    assert_eq!(parse(&text).unwrap().objects[0].0, "null \"null\\");
}

#[test]
fn the_caret_stands_under_the_value() {
    let message = object("\"type\": \"circle\", \"center\": [0,0], \"radius\": \"big\"").unwrap_err();
    let lines: Vec<&str> = message.lines().collect();
    assert_eq!(lines[1].find("\"big\""), lines[2].find("^^^^^"), "{message}");
}

#[test]
fn messages_cut_what_they_quote() {
    let long = "x".repeat(60_000);
    for (objects, start) in [
        (format!(r#""{long}": {{}}"#), "the name of an object has 60000 bytes, more than 255"),
        (format!(r#""a": {{"type": "{long}"}}"#), "unknown type `xxx"),
        (format!(r#""a": {{"type": "arc", "{long}": 1}}"#), "unknown field `xxx"),
        (format!(r#""a": {{"type": "arc", "bulge": "{long}"}}"#), "invalid type: string \"xxx"),
        (format!(r#""a": {{"type": "biarc", "rule": "{long}"}}"#), "unknown variant `xxx"),
        (format!(r#""a": {{"type": "arc", "{long}": 1, "{long}": 1}}"#), "the name `xxx"),
    ] {
        let text = format!(r#"{{"cyclide": 1, "objects": {{{objects}}}}}"#);
        let error = Document::parse("m.json", text.as_bytes()).unwrap_err();
        assert!(error.message.starts_with(start), "{error}");
        assert!(error.to_string().chars().count() < 1100 && error.message.matches('x').count() < 80, "{error}");
    }
}
