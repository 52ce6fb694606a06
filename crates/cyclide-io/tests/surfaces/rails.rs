//! Bridges between ellipses, and surfaces between two curves.

use cyclide::Point3;

use super::{build, surface};

#[test]
fn bridges_are_surfaces_or_solids_and_refused_in_their_place() {
    let bridge = |rest: &str| build(&format!(r#""b": {{"type": "ellipse-bridge", {rest}}}"#));
    let solid = surface(&bridge(r#""ellipses": [[10, 20], [20, 25]], "depth": 3"#).unwrap());
    assert!(solid.closed && solid.patches == 20);
    assert!(!surface(&bridge(r#""ellipses": [[10, 20], [20, 15]]"#).unwrap()).closed);
    // Whole circles: of circles a torus, with the volume 2π²Rr².
    let ring = surface(&bridge(r#""ellipses": [[10, 20], [20, 25]], "arcs": "full""#).unwrap());
    assert!(ring.closed && ring.patches == 16 && ring.joints.creases == 0);
    let torus = surface(&bridge(r#""ellipses": [[10, 10], [20, 20]], "arcs": "full""#).unwrap());
    assert!((torus.volume.unwrap() / (2.0 * std::f64::consts::PI.powi(2) * 15.0 * 25.0) - 1.0).abs() < 1e-12);
    for (fields, place, reason) in [
        (
            r#""ellipses": [[10, 20], [20, 25]], "arcs": "full", "depth": 3"#,
            "objects.b",
            "`depth` requires half circles",
        ),
        (r#""ellipses": [[10, 20], [20, 15]], "arcs": "full""#, "objects.b.ellipses", "[ellipses-cross]"),
        (r#""ellipses": [[10, 20], [10, 25]]"#, "objects.b.ellipses", "[coincident-points]"),
        (r#""ellipses": [[10, 20], [10, 25]]"#, "objects.b.ellipses", "the ellipses touch"),
        (r#""ellipses": [[10, -20], [20, 25]]"#, "objects.b.ellipses", "[radius-not-positive]"),
        (r#""ellipses": [[10, 20], [20, 15]], "depth": 3"#, "objects.b.ellipses", "[ellipses-cross]"),
        (r#""ellipses": [[10, 20], [20, 25]], "depth": -3"#, "objects.b.depth", "[parameter-out-of-range]"),
    ] {
        let error = bridge(fields).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
}

#[test]
fn surfaces_between_two_curves_and_what_refuses_them() {
    let rails = r#""a": {"type": "arc", "through": [[0,0,0],[5,1,0],[10,0,0]], "construction": true},
        "b": {"type": "arc", "through": [[0,6,0],[5,8,1],[10,6,0]], "construction": true},
        "p": {"type": "arc-spline", "points": [[0,0,4],[5,1,5],[10,0,4]], "construction": true},
        "k": {"type": "circle", "center": [0, 0, 0], "radius": 5, "construction": true},
        "m": {"type": "transform", "of": "k", "steps": [{"translation": [0, 0, 7]}], "construction": true},
        "two": {"type": "arc-spline", "points": [[[0,0],[1,1]],[[5,5],[6,6]]], "construction": true},
        "solid": {"type": "cyclide", "a": 3, "mu": 1, "construction": true}"#;
    let made = |object: &str| build(&format!(r#"{rails}, "s": {object}"#));
    let vault = made(r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [0, 0, 1]}"#).unwrap();
    let corner = vault.bodies[0].outer.vertices()[0];
    assert!(corner.distance(Point3::ORIGIN) < 1e-15 && surface(&vault).free_edges > 0);
    let each = r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [[0, 0, 1], [1, 0, 1]]}"#;
    assert!(surface(&made(each).unwrap()).area.unwrap() > surface(&vault).area.unwrap() * 0.5);
    // Round: a cylinder.
    let cylinder = surface(&made(r#"{"type": "ruled", "rails": ["k", "m"]}"#).unwrap());
    assert!((cylinder.area.unwrap() / (std::f64::consts::TAU * 5.0 * 7.0) - 1.0).abs() < 1e-12);
    assert_eq!(cylinder.joints.count, cylinder.patches);
    for (object, place, message) in [
        (r#"{"type": "ruled", "rails": ["a", "p"]}"#, "objects.s.rails", "[piece-counts-differ]"),
        (
            r#"{"type": "ruled", "rails": ["a", "p"]}"#,
            "objects.s.rails",
            "the first curve has 1 piece(s), the second 4",
        ),
        (r#"{"type": "ruled", "rails": ["a", "two"]}"#, "objects.s.rails[1]", "has 2 contours"),
        (r#"{"type": "ruled", "rails": ["solid", "a"]}"#, "objects.s.rails[0]", "is not a curve"),
        (r#"{"type": "ruled", "rails": ["a", "q"]}"#, "objects.s.rails[1]", "there is no object `q`"),
        (r#"{"type": "ruled", "rails": ["a", "a"]}"#, "objects.s.rails", "[coincident-points]"),
        (
            r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [0, 0, 0]}"#,
            "objects.s.tangent",
            "[zero-tangent]",
        ),
        (
            r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [[0, 0, 1], [0, 0, 0]]}"#,
            "objects.s.tangent[1]",
            "[zero-tangent]",
        ),
        (
            r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [[0, 0, 1], [0, 0, 1], [0, 0, 1]]}"#,
            "objects.s.tangent",
            "[count-differs]",
        ),
        (
            r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [[0, 0, 1], [0, 0, -2]]}"#,
            "objects.s.tangent",
            "tangents 0 and 1 are opposite",
        ),
        (
            r#"{"type": "circular-surface", "rails": ["a", "b"], "tangent": [0, -1, 0]}"#,
            "objects.s.tangent",
            "[tangent-opposes-chord]",
        ),
        (
            r#"{"type": "circular-surface", "rails": ["a", "a"], "tangent": [0, 0, 1]}"#,
            "objects.s.rails",
            "[coincident-points]",
        ),
    ] {
        let error = made(object).unwrap_err();
        assert!(error.contains(place) && error.contains(message), "{place} {message}: {error}");
    }
}

#[test]
fn a_circle_has_the_pieces_of_the_closed_curve_beside_it() {
    let made = |fields: &str, rails: &str, more: &str| {
        build(&format!(
            r#""k": {{"type": "circle", "center": [0, 0, 0], "radius": 5, "construction": true}},
            "o": {{{fields}, "construction": true}}, "s": {{"type": "ruled", "rails": {rails}{more}}}"#
        ))
    };
    // As wide as the circle, the ellipse makes a cylinder.
    let round = r#""type": "ellipse", "center": [0, 0, 7], "semi_axes": [5, 5]"#;
    for rails in [r#"["k", "o"]"#, r#"["o", "k"]"#] {
        let duct = surface(&made(round, rails, "").unwrap());
        assert_eq!(duct.patches, 4);
        assert!((duct.area.unwrap() / (std::f64::consts::TAU * 5.0 * 7.0) - 1.0).abs() < 1e-12);
    }
    for (fields, patches) in [
        (r#""type": "ellipse", "center": [1, 0, 7], "semi_axes": [6, 3]"#, 4),
        (r#""type": "polyline", "closed": true, "points": [[-4, -4, 7], [4, -4, 7], [4, 4, 7], [-4, 4, 7]]"#, 4),
        (
            r#""type": "fair-spline", "closed": true, "points": [[6, 0, 7], [4, 4, 7], [-4, 4, 7], [-5, -4, 7], [4, -4, 7]]"#,
            5,
        ),
    ] {
        for rails in [r#"["k", "o"]"#, r#"["o", "k"]"#] {
            assert_eq!(surface(&made(fields, rails, "").unwrap()).patches, patches, "{fields}");
        }
    }
    // The other way round: the remedy is for the curve that is written, and works.
    let clockwise = r#""type": "polyline", "closed": true, "points": [[-4, 4, 7], [4, 4, 7], [4, -4, 7], [-4, -4, 7]]"#;
    let error = made(clockwise, r#"["k", "o"]"#, "").unwrap_err();
    assert!(
        error.contains(r#"use a `transform` of it with the steps `["reverse"]`, so that it begins at (-4, 4, 7)"#),
        "{error}"
    );
    let turned = r#""type": "transform", "of": "p", "steps": ["reverse"]"#;
    let document = format!(
        r#""p": {{{clockwise}, "construction": true}}, "o": {{{turned}, "construction": true}},
        "k": {{"type": "circle", "center": [0, 0, 0], "radius": 5, "construction": true}}, "s": {{"type": "ruled", "rails": ["k", "o"]}}"#
    );
    assert_eq!(surface(&build(&document).unwrap()).patches, 4);
}
