//! Offsets: parallel surfaces and solids between, lobes, the focal set.

use std::path::Path;

use cyclide::Point3;
use cyclide_io::{Document, ModelBuilder};

use super::{CIRCLE, OCTANT, build, point, surface};

#[test]
fn offsets_and_images() {
    let grown = build(&format!(r#"{OCTANT}, "b": {{"type": "offset", "of": "o", "distance": 0.5}}"#)).unwrap();
    assert!((point(&grown, 0.3, 0.6).distance(Point3::new(1.0, 0.0, 0.0)) - 2.5).abs() < 1e-14);
    let steps = r#"[{"scale": {"factor": 2, "center": [1,0]}}, {"translation": [0,0,1]},
        {"rotation": {"angle": 1.5707963267948966, "center": [1,0]}}, {"mirror": {"normal": [0,0,2]}},
        {"matrix": [[[1,0,0,0],[0,1,0,0]],[[0,0,0,0],[1,0,0,0]]]}]"#;
    let moved = build(&format!(r#"{OCTANT}, "b": {{"type": "transform", "of": "o", "steps": {steps}}}"#)).unwrap();
    assert!((point(&moved, 0.3, 0.6).distance(Point3::new(2.0, 0.0, -1.0)) - 4.0).abs() < 1e-13);
    // The start (3,0,0) by hand: (5,0,0), (5,0,1), (1,4,1), (1,4,-1), (2,4,-1).
    assert!(point(&moved, 0.0, 0.0).distance(Point3::new(2.0, 4.0, -1.0)) < 1e-14);
    // Inversion in the unit sphere about (1,0,0) keeps the center and takes the radius 2 to 1/2.
    let inverted = build(&format!(
        r#"{OCTANT}, "b": {{"type": "transform", "of": "o", "steps": [{{"inversion": {{"center": [1,0], "radius": 1}}}}]}}"#
    ))
    .unwrap();
    assert!((point(&inverted, 0.3, 0.6).distance(Point3::new(1.0, 0.0, 0.0)) - 0.5).abs() < 1e-14);
    // Curves too, and in any order of the document.
    let text = format!(
        r#"{{"cyclide": 1, "objects": {{"b": {{"type": "transform", "of": "c", "steps": [{{"translation": [0,7]}}]}}, {CIRCLE}}}}}"#
    );
    let document = Document::parse("m.json", text.as_bytes()).unwrap();
    let read = |_: &Path| Ok(Vec::new());
    let built = ModelBuilder::new(&document, Path::new(""), &read).unwrap().build(0, &mut |_| {}).unwrap();
    assert!(built.item.curves()[0].as_curve().point(0.25).distance(Point3::new(5.0, 8.0, 0.0)) < 1e-14);
}

#[test]
fn an_offset_with_nodes_is_the_solids_of_its_lobes() {
    // Rings offset inwards to horns: with the nodes inside patches, and on their edges.
    for ([a, c, mu], distance, patches) in [([50, 20, 32], -20, 24), ([4, 1, 2], -2, 16)] {
        let whole = format!(r#"{{"type": "cyclide", "a": {a}, "c": {c}, "mu""#);
        let built =
            build(&format!(r#""r": {whole}: {mu}}}, "o": {{"type": "offset", "of": "r", "distance": {distance}}}"#));
        let offset = surface(&built.unwrap());
        let horn = surface(&build(&format!(r#""h": {whole}: {}}}"#, mu + distance)).unwrap());
        assert_eq!((offset.bodies, offset.patches, offset.free_edges), (2, patches, 0), "{offset:?}");
        // Two lobes have two areas, and no sum; the horn is as many parts.
        assert!(offset.area.is_none() && offset.parts.len() == 2, "{offset:?}");
        let [lobes, parts] = [&offset, &horn].map(|report| report.parts.iter().map(|part| part.area).sum::<f64>());
        assert!((lobes / parts - 1.0).abs() < 1e-11, "{lobes} {parts}");
        assert!((offset.volume.unwrap() / horn.volume.unwrap() - 1.0).abs() < 1e-11);
    }
    // The net is kept: an offset back is the ring again.
    let back = build(
        r#""r": {"type": "cyclide", "a": 4, "c": 1, "mu": 2}, "o": {"type": "offset", "of": "r", "distance": -2},
        "b": {"type": "offset", "of": "o", "distance": 2}"#,
    );
    let ring = surface(&build(r#""r": {"type": "cyclide", "a": 4, "c": 1, "mu": 2}"#).unwrap());
    let back = surface(&back.unwrap());
    assert_eq!((back.bodies, back.patches), (1, 16));
    assert!((back.volume.unwrap() / ring.volume.unwrap() - 1.0).abs() < 1e-12);
}

#[test]
fn offsets_beyond_the_focal_set_and_on_it() {
    let torus = r#""r": {"type": "cyclide", "a": 4, "mu": 1}"#;
    let offset = |of: &str, name: &str, distance: f64, thick: bool| {
        format!(r#", "{name}": {{"type": "offset", "of": "{of}", "distance": {distance:?}, "thick": {thick}}}"#)
    };
    // Offsets go along the normal of the torus, and back; between, they say that they are flipped.
    let beyond = format!("{torus}{}", offset("r", "o", -2.5, false));
    let report = surface(&build(&beyond).unwrap());
    assert_eq!((report.flipped.len(), report.singular.len()), (16, 0));
    let back = surface(&build(&format!("{beyond}{}", offset("o", "b", 2.5, false))).unwrap());
    assert!(
        back.flipped.is_empty() && (back.area.unwrap() / (16.0 * std::f64::consts::PI.powi(2)) - 1.0).abs() < 1e-12
    );
    let solid = surface(&build(&format!("{beyond}{}", offset("o", "k", 0.2, true))).unwrap());
    let volume = 8.0 * std::f64::consts::PI.powi(2) * (1.5 * 1.5 - 1.3 * 1.3);
    assert!((solid.volume.unwrap() / volume - 1.0).abs() < 1e-11 && solid.flipped.is_empty(), "{:?}", solid.volume);
    // Whole horns grow outwards as a whole.
    let horn = r#""r": {"type": "cyclide", "a": 5, "c": 3, "mu": 1}"#;
    let (small, large) = (surface(&build(horn).unwrap()), format!("{horn}{}", offset("r", "o", 0.1, false)));
    let large = surface(&build(&large).unwrap());
    assert!(large.parts[0].area > small.parts[0].area);
    for (distance, thick, words) in [
        (-1.0, false, "quad 0: the offset at distance -1 lies on the focal set"),
        (
            -1.5,
            true,
            "quad 0: a solid between the surface and its offset at distance -1.5 would self-intersect: a center",
        ),
        (0.0, true, "a solid between a surface and its offset requires a nonzero distance"),
    ] {
        let message = build(&format!("{torus}{}", offset("r", "k", distance, thick))).unwrap_err();
        assert!(message.contains(&format!(": objects.k.distance: {words}")), "{message}");
    }
}

/// What takes offsets is named, and what was given.
#[test]
fn offsets_of_other_surfaces_say_which_have_one() {
    let line = r#""p": {"type": "polyline", "points": [[3, 0, 0], [5, 0, 1]], "construction": true}"#;
    for other in [r#"{"type": "revolution", "of": "p"}"#, r#"{"type": "pipe", "of": "p", "radius": 1}"#] {
        let error = build(&format!(
            "{line}, \"s\": {other}, \"o\": {{\"type\": \"offset\", \"of\": \"s\", \"distance\": 0.1}}"
        ));
        let error = error.unwrap_err();
        assert!(error.contains("objects.o.of") && error.contains("`s` is of type `"), "{error}");
        for word in ["`cyclide`", "`cyclide-patch`", "`cyclidic-net`", "`offset`", "`transform`"] {
            assert!(error.contains(word), "{word}: {error}");
        }
    }
}
