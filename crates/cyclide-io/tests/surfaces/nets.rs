//! Nets over grids: skins, edges, frames that fold them, quads that no patch fits into.

use cyclide::error::PatchError;
use std::path::Path;

use cyclide_io::{Document, Error, ModelBuilder, Report, report::GeometryReport};

use super::{build, cylinder, surface};

#[test]
fn quads_that_no_patch_fits_into_are_named_by_index() {
    // All corners are on one circle, so that no vertex moves; the sides of both outer quads cross.
    let at = |degrees: f64| format!("[{},{}]", degrees.to_radians().cos(), degrees.to_radians().sin());
    let row = |angles: [f64; 4]| format!("[{}]", angles.map(at).join(","));
    let net =
        |rows: &str| build(&format!(r#""n": {{"type": "cyclidic-net", "grid": [{rows}], "make_circular": true}}"#));
    let message = net(&[row([0.0, 20.0, 40.0, 60.0]), row([110.0, 170.0, 130.0, 150.0])].join(",")).unwrap_err();
    let words = "objects.n.grid[0][0]: quads 0, 2: sides cross or have no length, so no patch fits; no vertex was moved; points must be listed row by row, with all rows in the same direction [crossing-quad]";
    assert!(message.contains(words), "{message}");
    // A quad that crosses itself and has no circle: its corners are moved onto one, and it crosses itself still.
    let message = net("[[0,0,0],[1,0,0.1]],[[1,1,0],[0,1,0]]").unwrap_err();
    let words = "objects.n.grid[0][0]: quad 0: sides cross or have no length, so no patch fits; vertices were moved by up to 0.";
    assert!(message.contains(words) && message.contains(" steps; points must be listed row by row"), "{message}");
    assert!(!message.contains("NaN"), "{message}");
    // Of objects made by a program, the same without a place.
    let object =
        r#""n": {"type": "cyclidic-net", "grid": [[[0,0,0],[1,0,0.1]],[[1,1,0],[0,1,0]]], "make_circular": true}"#;
    let text = format!(r#"{{"cyclide": 1, "objects": {{{object}}}}}"#);
    let Document { units, objects, .. } = Document::parse("m.json", text.as_bytes()).unwrap();
    let document = Document::from_objects("program", units, objects);
    let read = |_: &Path| Ok(Vec::new());
    let error = ModelBuilder::new(&document, Path::new(""), &read).unwrap().build(0, &mut |_| {}).unwrap_err();
    assert!(error.to_string().starts_with("n: quad 0: sides cross or have no length"), "{error}");
    let Error::RejectedQuads { quads, steps, moved, .. } = error else { panic!("{error}") };
    assert!(quads == [0] && steps > 0 && moved > 0.0 && moved < 1.0, "{quads:?} {steps} {moved}");
    // What was built has no such quad, and says so.
    let report = surface(&net(&[row([0.0, 20.0, 40.0, 60.0]), row([170.0, 150.0, 130.0, 110.0])].join(",")).unwrap());
    assert!(report.circular.unwrap().rejected_quads.is_empty());
}

/// A net of two by one quads on a cylinder about the x axis.
const NET: &str = r#""n": {"type": "cyclidic-net", "grid": [[[0,1,0],[1,1,0],[3,1,0]],[[0,0,1],[1,0,1],[3,0,1]]]}"#;

#[test]
fn nets_with_their_skins_and_edges() {
    let net = surface(&build(NET).unwrap());
    assert_eq!((net.patches, net.joints.count, net.free_edges), (2, 1, 6));
    let quarter = std::f64::consts::FRAC_PI_2;
    // The frame follows the edges: the straight ones lie on the cylinder, the chords of its circles are turned equally.
    assert!(net.joints.gap < 1e-15 && net.joints.angle < 1e-14 && net.singular.is_empty());
    let framed = NET.replace("]]]}", r#"]]], "frame": [[1,0,0],[0,0,5]]}"#);
    let cylinder = surface(&build(&framed).unwrap());
    assert!((cylinder.area.unwrap() / (3.0 * quarter) - 1.0).abs() < 1e-12, "{:?}", cylinder.area);
    let thick = |distance: f64| {
        format!(r#"{framed}, "t": {{"type": "offset", "of": "n", "distance": {distance}, "thick": true}}"#)
    };
    for distance in [0.5, -0.5] {
        let solid = build(&thick(distance)).unwrap();
        let report = surface(&solid);
        // Between the radii 1 and 1 + distance or 1 - distance: the normal f_s x f_t points inward here.
        let other = 1.0 - distance;
        let volume = 3.0 * quarter / 2.0 * (1.0 - other * other).abs();
        assert!((report.volume.unwrap() / volume - 1.0).abs() < 1e-11, "{:?} {volume}", report.volume);
        assert_eq!((report.free_edges, report.closed), (0, true));
        assert!(report.joints.creases > 0);
        // Two quarters of a cylinder and four rims, each with its own area; nobody is told the sum for one skin's.
        let skins = [1.0_f64.max(other), 1.0_f64.min(other)].map(|radius| 3.0 * quarter * radius);
        assert_eq!((report.parts.len(), report.parts[0].patches, report.parts[1].patches), (6, 2, 2));
        for (part, skin) in report.parts.iter().zip(skins) {
            assert!((part.area / skin - 1.0).abs() < 1e-12, "{part:?} {skin}");
        }
        assert_eq!(report.area, None);
        let text = Report::new(cyclide::model::Units::Metre, std::slice::from_ref(&solid), None).to_string();
        let areas = text.lines().find(|line| line.starts_with("  areas ")).unwrap();
        assert!(areas.contains("  6: ") && areas.contains("; 3 more; together "), "{text}");
        // Thick shells are mapped as wholes, and have no offset of their own.
        let moved = format!(
            r#"{}, "m": {{"type": "transform", "of": "t", "steps": [{{"mirror": {{"normal": [1,1,0]}}}}]}}"#,
            thick(distance)
        );
        assert!((surface(&build(&moved).unwrap()).volume.unwrap() / volume - 1.0).abs() < 1e-11);
        let again = format!(r#"{}, "m": {{"type": "offset", "of": "t", "distance": 1}}"#, thick(distance));
        let error = build(&again).unwrap_err();
        assert!(
            error.contains("`t` is of type `offset`: only these have an exact offset")
                && error.contains("without `thick`"),
            "{error}"
        );
    }
    let edges = build(&format!(r#"{framed}, "e": {{"type": "support-structure", "of": "n"}}"#)).unwrap();
    assert_eq!(edges.item.curves().len(), 7);
    let length: f64 = edges.item.curves().iter().map(|c| cyclide::curve::length(c.as_curve())).sum();
    assert!((length - (6.0 + 3.0 * quarter)).abs() < 1e-13);
}

/// What has rational edges says how many are left out, and what has rational faces why an inversion does not take it.
#[test]
fn rational_edges_and_faces_are_named() {
    let tee = r#""t": {"type": "pipe-tee", "main": {"radius": 30, "ends": [-80, 80]}, "branches": [{"radius": 18, "length": 75, "blend": 6}]}"#;
    let edges = build(&format!(r#"{tee}, "e": {{"type": "support-structure", "of": "t"}}"#)).unwrap();
    let [remark] = &edges.remarks[..] else { panic!("{:?}", edges.remarks) };
    let arcs = edges.item.curves().len();
    let told: Vec<usize> = remark.message.split(' ').filter_map(|word| word.parse().ok()).collect();
    assert_eq!((remark.reason, told[1] - told[0], told[0] > 0), ("rational-edges-left-out", arcs, true));
    let inversion =
        r#""i": {"type": "transform", "of": "t", "steps": [{"inversion": {"center": [0, 0, 300], "radius": 100}}]}"#;
    let error = build(&format!("{tee}, {inversion}")).unwrap_err();
    assert!(error.contains("[not-a-similarity]") && error.contains("surfaces with rational faces"), "{error}");
}

#[test]
fn refused_nets_and_cyclides() {
    for (object, piece, start) in [
        (
            NET.replace("[3,0,1]", "[3,0,1.1]"),
            "[1,1,0]",
            "objects.n.grid[0][1]: quad 1: the corners do not lie on one circle",
        ),
        (NET.replace(",[3,0,1]", ""), "[[0,0,1],[1,0,1]]", "objects.n.grid[1]: row 1 has 2 points, the first has 3"),
        (
            NET.replace("]]]}", r#"]]], "frame": [[1,0],[1,1]]}"#),
            "[[1,0],[1,1]]",
            "objects.n.frame: the directions of the frame must be perpendicular",
        ),
        (NET.replace("]]]}", r#"]]], "frame": "best"}"#), "\"best\"", "objects.n.frame: unknown variant `best`"),
        (
            NET.replace("]]]}", r#"]]], "closed": [false, true]}"#),
            "[[[0,1,0],[1,1,0],[3,1,0]],[[0,0,1],[1,0,1],[3,0,1]]]",
            "objects.n.grid: too few points",
        ),
        (r#""c": {"type": "cyclide", "a": 1, "c": 2, "mu": 1}"#.to_owned(), "2", "objects.c.c: c = 2 is outside"),
        (r#""c": {"type": "cyclide", "a": 1, "mu": 0}"#.to_owned(), "0", "objects.c.mu: mu = 0 is outside"),
        (
            r#""c": {"type": "cyclide", "a": 2, "mu": 1, "segments": [4, 2]}"#.to_owned(),
            "2",
            "objects.c.segments[1]: segments along t = 2",
        ),
        (
            r#""c": {"type": "cyclide", "a": 2, "mu": 1, "axis": [0,0]}"#.to_owned(),
            "[0,0]",
            "objects.c.axis: the axis is zero",
        ),
    ] {
        let message = build(&object).map(|b| format!("built {:?}", b.item)).unwrap_err();
        let lines: Vec<&str> = message.lines().collect();
        assert!(lines[0].starts_with("m.json:2:") && lines[0].contains(&format!(": {start}")), "{start}\n{message}");
        let carets = lines[2].find('^').unwrap()..lines[2].len();
        assert!(piece.starts_with(&lines[1][carets.clone()]), "{message}");
    }
}

#[test]
fn a_frame_that_folds_its_net_is_warned_of() {
    let suits = build(&cylinder(r#", "frame": [[1, 0, 0], [0, 0, 1]]"#)).unwrap();
    assert!(suits.remarks.is_empty(), "{:?}", suits.remarks);
    assert!(build(&cylinder("")).unwrap().remarks.is_empty());

    // The directions of s and t exchanged.
    let folded = build(&cylinder(r#", "frame": [[0, 0, 1], [1, 0, 0]]"#)).unwrap();
    let report = Report::new(cyclide::model::Units::Metre, std::slice::from_ref(&folded), None);
    let GeometryReport::Surface(surface) = &report.objects["n"].geometry else { panic!("a surface") };
    let [remark] = &folded.remarks[..] else { panic!("one remark: {:?}", folded.remarks) };
    assert_eq!((remark.reason, remark.index), ("folded-net", Some(surface.singular[0].place.patch)));
    assert!(
        remark.message.starts_with(&format!("{} singular patch(es)", surface.singular.len())),
        "{}",
        remark.message
    );
    assert!(remark.message.ends_with("use the frame \"auto\" or another one"), "{}", remark.message);
    // Offsets and whole cyclides with nodes are no such nets.
    let horn = build(r#""c": {"type": "cyclide", "a": 4, "c": 2, "mu": 1.5}"#).unwrap();
    assert!(horn.remarks.is_empty(), "{:?}", horn.remarks);
}

#[test]
fn seams_that_do_not_close_name_the_ratio_only_where_there_is_one() {
    let message = |stretch| {
        cyclide::Error::Patch(PatchError::NetDoesNotClose {
            direction: 0,
            line: None,
            angle: 0.25,
            stretch,
            limit: 1e-9,
        })
        .to_string()
    };
    assert!(message(0.0).ends_with("the frame is off by 0.25 radians, limit 1e-9"), "{}", message(0.0));
    let slower = message(-1.91e-6);
    assert!(slower.ends_with("of the transversal lines by the factor 1 - 1.91e-6, limit 1e-9"), "{slower}");
}
