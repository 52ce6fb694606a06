//! What only DXF has: polylines in any plane, versions, layers, flags.

use crate::models::{circle_spline, coil, flat, mixed, model, slot, space_chain, splines, tilted, wave};
use cyclide::{
    curve::BlendVariant,
    model::{CurveObject, Model, Units},
};
use cyclide_io::{
    ExportOptions, Format,
    export::DxfVersion,
    formats::{export, file_deviation, read_back},
};

fn with(m: &Model, options: &ExportOptions) -> Vec<(u16, String)> {
    let text = String::from_utf8(export(m, Format::Dxf, options).unwrap().bytes).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    lines.chunks(2).map(|pair| (pair[0].trim().parse().unwrap(), pair[1].to_owned())).collect()
}

fn tags(m: &Model) -> Vec<(u16, String)> {
    with(m, &ExportOptions::default())
}

fn count(tags: &[(u16, String)], entity: &str) -> usize {
    tags.iter().filter(|(code, value)| *code == 0 && value == entity).count()
}

/// Group codes and values of the first entity of a type.
fn entity<'a>(tags: &'a [(u16, String)], name: &str) -> &'a [(u16, String)] {
    let start = tags.iter().position(|(c, v)| *c == 0 && v == name).unwrap();
    let length = tags[start + 1..].iter().position(|(c, _)| *c == 0).unwrap();
    &tags[start + 1..start + 1 + length]
}

fn values(entity: &[(u16, String)], code: u16) -> Vec<f64> {
    entity.iter().filter(|(c, _)| *c == code).map(|(_, v)| v.parse().unwrap()).collect()
}

#[test]
fn a_planar_curve_is_one_closed_polyline() {
    let m = model(vec![("slot", vec![CurveObject::ArcPath(slot(flat))])]);
    let tags = tags(&m);
    let polyline = entity(&tags, "LWPOLYLINE");
    assert_eq!(values(polyline, 90), [4.0]);
    assert_eq!(values(polyline, 70), [1.0]);
    assert_eq!(values(polyline, 10), [0.0, 40.0, 40.0, 0.0]);
    assert_eq!(values(polyline, 20), [0.0, 0.0, 12.0, 12.0]);
    assert_eq!(values(polyline, 42), [0.0, 1.0, 0.0, 1.0]);
    assert!(values(polyline, 210).is_empty(), "the plane is horizontal");
}

#[test]
fn polylines_have_no_arc_above_half_a_turn_and_no_repeated_vertex() {
    for m in [mixed(flat), mixed(tilted)].into_iter().chain(splines().into_iter().map(|(_, m)| m)) {
        let tags = tags(&m);
        let mut rest = &tags[..];
        while let Some(start) = rest.iter().position(|(c, v)| *c == 0 && v == "LWPOLYLINE") {
            let polyline = entity(&rest[start..], "LWPOLYLINE");
            assert!(values(polyline, 42).iter().all(|b| b.abs() <= 1.0 + 1e-9));
            let (x, y) = (values(polyline, 10), values(polyline, 20));
            let n = x.len();
            let closed = values(polyline, 70) == [1.0];
            for i in 0..if closed { n } else { n - 1 } {
                assert!(x[i].to_bits() != x[(i + 1) % n].to_bits() || y[i].to_bits() != y[(i + 1) % n].to_bits());
            }
            rest = &rest[start + 1..];
        }
    }
}

#[test]
fn curves_in_space_are_grouped_arcs_and_lines() {
    let space = CurveObject::ArcPath(space_chain());
    // The second contour starts where the first one ends: only the groups tell them apart.
    let next = cyclide::curve::Arc::segment(space.as_curve().point(1.0), cyclide::Point3::new(0.0, 0.0, 50.0)).unwrap();
    let m = model(vec![("s", vec![space, CurveObject::Arc(next)])]);
    let tags = tags(&m);
    assert_eq!((count(&tags, "ARC"), count(&tags, "LINE"), count(&tags, "GROUP")), (3, 2, 1));
    let bytes = export(&m, Format::Dxf, &ExportOptions::default()).unwrap().bytes;
    assert_eq!(read_back(Format::Dxf, &bytes).unwrap().curves.len(), 2);
}

#[test]
fn a_short_line_before_a_large_arc_is_one_curve_with_it() {
    // The arc begins where its center and radius say: to the rounding of 2000, not of the line of 1e-6.
    let (from, bend) = (cyclide::Point3::new(0.0, 0.0, -1e-6), cyclide::Point3::new(0.0, 0.0, 0.0));
    let (through, end) = (cyclide::Point3::new(700.0, 500.0, 100.0), cyclide::Point3::new(1700.0, 700.0, 300.0));
    let line = cyclide::curve::Arc::segment(from, bend).unwrap();
    let arc = cyclide::curve::Arc::from_three_points(bend, through, end).unwrap();
    let path = cyclide::curve::ArcPath::new(vec![line, arc], false).unwrap();
    let m = model(vec![("s", vec![CurveObject::ArcPath(path)])]);
    let bytes = export(&m, Format::Dxf, &ExportOptions::default()).unwrap().bytes;
    assert_eq!(read_back(Format::Dxf, &bytes).unwrap().curves.len(), 1);
}

#[test]
fn old_version_has_polylines_and_no_handles() {
    let options = ExportOptions { dxf_version: DxfVersion::R12, ..ExportOptions::default() };
    let tags = with(&mixed(tilted), &options);
    assert!(tags.contains(&(1, "AC1009".to_owned())));
    assert_eq!((count(&tags, "POLYLINE"), count(&tags, "SEQEND"), count(&tags, "LWPOLYLINE")), (4, 4, 0));
    assert!(!tags.iter().any(|(code, _)| [5, 100, 330].contains(code)));
    for m in [mixed(flat), mixed(tilted), model(vec![("s", vec![CurveObject::ArcPath(space_chain())])])] {
        let file = export(&m, Format::Dxf, &options).unwrap();
        let d = file_deviation(&m, Format::Dxf, &file).unwrap();
        // Rounding of coordinates up to 60 and of bulges, which act on chords up to 40.
        assert!(d <= file.bound + 1e-13, "{d:e}");
    }
}

#[test]
fn splines_are_exact_on_request() {
    let options = ExportOptions { dxf_splines: true, ..ExportOptions::default() };
    let wave = circle_spline(&wave(tilted, 40), true, BlendVariant::Rational, vec![]);
    let coil = circle_spline(&coil(30), false, BlendVariant::Rational, vec![]);
    for (curve, closed) in [(wave, 1), (coil, 0)] {
        let m = model(vec![("c", vec![curve])]);
        let file = export(&m, Format::Dxf, &options).unwrap();
        assert!(file.exact);
        let d = file_deviation(&m, Format::Dxf, &file).unwrap();
        assert!(d < 1e-12 * 200.0, "{d:e}");
        let tags = with(&m, &options);
        let spline = entity(&tags, "SPLINE");
        let (knots, weights, points) = (values(spline, 40), values(spline, 41), values(spline, 10));
        assert_eq!(values(spline, 70)[0] as usize & 5, 4 + closed);
        assert_eq!(knots.len(), points.len() + values(spline, 71)[0] as usize + 1);
        assert_eq!([knots.len() as f64, points.len() as f64], [values(spline, 72)[0], values(spline, 73)[0]]);
        assert_eq!(weights.len(), points.len());
        let old = ExportOptions { dxf_version: DxfVersion::R12, ..options.clone() };
        assert_eq!(export(&m, Format::Dxf, &old).unwrap_err().reason(), "not-in-format");
    }
}

#[test]
fn handles_are_unique_and_below_the_seed() {
    let m = model(vec![("s", vec![CurveObject::ArcPath(space_chain()), CurveObject::ArcPath(slot(flat))])]);
    let tags = tags(&m);
    let handle =
        |(code, value): &(u16, String)| [5, 105].contains(code).then(|| usize::from_str_radix(value, 16).unwrap());
    let mut handles: Vec<usize> = tags.iter().filter_map(handle).collect();
    // The first one is the seed of the header.
    let seed = handles.remove(0);
    let count = handles.len();
    handles.sort_unstable();
    handles.dedup();
    assert_eq!(handles.len(), count);
    assert!(handles.iter().all(|h| *h > 0 && *h < seed));
    // Every owner, group member and dictionary entry exists.
    for (code, value) in &tags {
        if [330, 340, 350, 390].contains(code) && value != "0" {
            assert!(handles.contains(&usize::from_str_radix(value, 16).unwrap()), "{code} {value}");
        }
    }
}

#[test]
fn units_are_said() {
    for (units, code, metric) in [
        (Units::Millimetre, 4.0, 1.0),
        (Units::Centimetre, 5.0, 1.0),
        (Units::Metre, 6.0, 1.0),
        (Units::Inch, 1.0, 0.0),
        (Units::Foot, 2.0, 0.0),
        (Units::UsSurveyFoot, 21.0, 0.0),
    ] {
        let tags = tags(&Model { units, ..mixed(flat) });
        let after = |name: &str| {
            let at = tags.iter().position(|(_, v)| v == name).unwrap();
            tags[at + 1].1.parse::<f64>().unwrap()
        };
        assert_eq!([after("$INSUNITS"), after("$MEASUREMENT")], [code, metric]);
    }
}
