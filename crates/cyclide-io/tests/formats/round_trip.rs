//! Every format with geometry: written, read back, compared.

use crate::models::{Map, bulges, flat, mixed, model, open_chain, slot, space_chain, splines, tilted};
use cyclide::{
    Point3, Vec3,
    curve::{Arc, ArcPath, BlendVariant, Circle, CircleSpline, CircleSplineOptions, ParamCurve, bounds},
    model::{CurveObject, Model},
};
use cyclide_io::{
    ExportOptions, Format,
    check::ReadError,
    export::Exported,
    formats::{export, file_deviation, read_back},
};

const FORMATS: [Format; 5] = [Format::Step, Format::Dxf, Format::Svg, Format::Csv, Format::Json];

fn all_models() -> Vec<(&'static str, Model)> {
    let space = model(vec![("space", vec![CurveObject::ArcPath(space_chain())])]);
    let mut models = vec![("flat", mixed(flat)), ("tilted", mixed(tilted)), ("space", space)];
    models.extend(splines());
    models
}

#[test]
fn files_keep_their_promise() {
    for (name, m) in all_models() {
        for format in FORMATS {
            let file = export(&m, format, &ExportOptions::default()).unwrap();
            assert_eq!(file.exact, file.bound == 0.0);
            let d = file_deviation(&m, format, &file).unwrap();
            // Rounding: half ulps of the largest radius, 7.4e5, and of coordinates up to 60.
            assert!(d <= file.bound + 3e-16 * 7.4e5, "{name} {format:?}: {d:e} of {:e}", file.bound);
        }
    }
}

#[test]
fn bytes_are_reproducible() {
    for (name, m) in all_models() {
        for format in FORMATS {
            let bytes = || export(&m, format, &ExportOptions::default()).unwrap().bytes;
            assert_eq!(bytes(), bytes(), "{name} {format:?}");
        }
    }
}

#[test]
fn size_and_place_do_not_matter() {
    let tiny: Map = |x, y| Point3::new(1e-6 * x, 1e-6 * y, 0.0);
    let far: Map = |x, y| Point3::new(1e6 + x, 3.0 - 2e6 + y, 5e5);
    let huge: Map = |x, y| Point3::new(1e40 * x, 0.0, 1e40 * y);
    for (map, size, largest) in [(tiny, 5e-5, 5e-5), (far, 50.0, 2e6), (huge, 5e41, 5e41)] {
        let m = model(vec![("slot", vec![CurveObject::ArcPath(slot(map))])]);
        for format in FORMATS {
            // Nothing is left of a vertical plane seen from above but a line; the plan is not the curve.
            if format == Format::Svg && size > 1e40 {
                continue;
            }
            let file = export(&m, format, &ExportOptions::default()).unwrap();
            let d = file_deviation(&m, format, &file).unwrap();
            // Some ulps of the coordinates.
            assert!(d <= file.bound + 1e-15 * largest, "{format:?} at {size:e}: {d:e}");
        }
    }
}

#[test]
fn coordinates_are_the_same_doubles() {
    let m = model(vec![("c", vec![CurveObject::ArcPath(open_chain(tilted))])]);
    for format in [Format::Csv, Format::Json] {
        let bytes = export(&m, format, &ExportOptions::default()).unwrap().bytes;
        let chains = read_back(format, &bytes).unwrap().curves;
        let curve = m.items[0].curves()[0].as_curve();
        let (start, end) = (curve.point(0.0), curve.point(1.0));
        assert_eq!((chains[0].point(0.0), chains[0].point(1.0)), (start, end), "{format:?}");
    }
}

#[test]
fn a_wrong_file_is_found_out() {
    let m = model(vec![("slot", vec![CurveObject::ArcPath(slot(flat))])]);
    let whole = export(&m, Format::Step, &ExportOptions::default()).unwrap();
    let text = String::from_utf8(whole.bytes.clone()).unwrap();
    let measured = |text: String| {
        let mut file: Exported = whole.clone();
        file.bytes = text.into_bytes();
        file_deviation(&m, Format::Step, &file)
    };
    let list = text.split_once("COMPOSITE_CURVE('slot',(").unwrap().1.split_once(')').unwrap().0;
    let segments: Vec<&str> = list.split(',').collect();
    let wrong = |order: &[usize]| {
        let order: Vec<&str> = order.iter().map(|i| segments[*i]).collect();
        measured(text.replace(list, &order.join(",")))
    };
    assert!(wrong(&[0, 1, 2, 3]).unwrap() < 1e-13);
    // Swapped, doubled and missing pieces, though every point is near the curve; a file that starts elsewhere was not
    // written by us.
    assert!(wrong(&[2, 3, 0, 1]).unwrap() > 5.0);
    assert!(matches!(wrong(&[0, 3, 2, 1]), Err(ReadError::Geometry { .. })));
    let doubled = wrong(&[0, 1, 2, 3, 0, 1, 2, 3]).unwrap_err();
    assert_eq!(doubled, ReadError::PieceCount { curve: 0, found: 8, expected: 4 });
    assert!(matches!(wrong(&[0, 1, 2]), Err(ReadError::Geometry { .. })));
    let error = measured(text.replace(".CONTINUOUS.", ".DISCONTINUOUS.")).unwrap_err();
    assert_eq!(error, ReadError::Closedness { curve: 0, found: false });
    let error = measured(text.replace("GEOMETRIC_CURVE_SET", "GEOMETRIC_SET")).unwrap_err();
    assert_eq!(error, ReadError::CurveCount { found: 0, expected: 1 });
}

#[test]
fn bad_requests_are_named() {
    let m = mixed(flat);
    let reason = |m: &Model, tolerance| {
        let options = ExportOptions { tolerance, ..ExportOptions::default() };
        export(m, Format::Svg, &options).unwrap_err().reason()
    };
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(reason(&m, Some(tolerance)), "tolerance-not-positive");
    }
    assert_eq!(reason(&model(vec![]), None), "empty-model");
    let huge: Map = |x, y| Point3::new(1e130 * x, 1e130 * y, 0.0);
    let m = model(vec![("slot", vec![CurveObject::ArcPath(slot(huge))])]);
    assert_eq!(reason(&m, None), "coordinate-too-large");
    let tiny: Map = |x, y| Point3::new(1e-135 * x, 1e-135 * y, 0.0);
    let m = model(vec![("slot", vec![CurveObject::ArcPath(slot(tiny))])]);
    assert_eq!(reason(&m, None), "object-too-small");
}

/// Random points, half of them on a grid: hairpins, cusps, loops, curves that run back over themselves. A check that
/// fails here would refuse a good file.
#[test]
fn wild_curves_pass_their_own_check() {
    let mut state = 12_345_u64;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut files = 0;
    for case in 0..120 {
        let (count, space, grid) = (3 + (random() * 12.0) as usize, random() < 0.5, random() < 0.5);
        let mut coordinate = || if grid { (random() * 4.0).round() } else { random() * 10.0 };
        let mut point = || Point3::new(coordinate(), coordinate(), if space { coordinate() } else { 0.0 });
        let points: Vec<Point3> = (0..count).map(|_| point()).collect();
        let variant = if case % 2 == 0 { BlendVariant::Rational } else { BlendVariant::Trigonometric };
        let options = CircleSplineOptions { closed: case % 4 < 2, order: 1 + case % 4, variant, ..Default::default() };
        // Some of these points allow no curve.
        let Ok(spline) = CircleSpline::from_points(&points, &options) else { continue };
        let m = model(vec![("wild", vec![CurveObject::CircleSpline(spline)])]);
        let size = bounds(m.items[0].curves()[0].as_curve()).diagonal();
        for format in FORMATS {
            let file = export(&m, format, &ExportOptions::default()).unwrap();
            let d = file_deviation(&m, format, &file).unwrap();
            assert!(d <= file.bound + 1e-11 * size, "{case} {format:?}: {d:e} of {:e}", file.bound);
            files += 1;
        }
    }
    assert!(files > 400, "{files}");
}

#[test]
fn an_open_curve_may_end_where_it_starts() {
    let loop_of = |map: Map| bulges(map, &[(0.0, 0.0), (9.0, 4.0), (0.0, 0.0)], &[0.5, 0.7]);
    let there_and_back = bulges(flat, &[(0.0, 0.0), (9.0, 4.0), (0.0, 0.0)], &[0.5, -0.5]);
    let mut spatial = space_chain().arcs().to_vec();
    spatial.push(Arc::segment(spatial[3].end(), spatial[0].start()).unwrap());
    for path in [loop_of(flat), loop_of(tilted), there_and_back, ArcPath::new(spatial, false).unwrap()] {
        let m = model(vec![("loop", vec![CurveObject::ArcPath(path)])]);
        for format in FORMATS {
            let file = export(&m, format, &ExportOptions::default()).unwrap();
            let d = file_deviation(&m, format, &file).unwrap();
            // Rounding of coordinates up to 40.
            assert!(d <= file.bound + 1e-13, "{format:?}: {d:e} of {:e}", file.bound);
        }
    }
}

/// The check of a table evaluates curves as its writer does: here what a circle and a chain of arcs are in closed form.
#[test]
fn tables_say_what_circles_are() {
    let (centre, normal, radius) = (Point3::new(3.0, -4.0, 5.0), Vec3::new(1.0, 2.0, 2.0) / 3.0, 7.0);
    let circle = CurveObject::Circle(Circle::from_radius(centre, normal, radius).unwrap());
    let half = |from: f64, to: f64, side: f64| {
        let at = |x| Point3::new(x, 0.0, 1.0);
        Arc::from_bulge(at(from), at(to), Vec3::Z, side).unwrap()
    };
    // Half circles of radius 1 and 2, the first one to the right, the second one to the left.
    let path = CurveObject::ArcPath(ArcPath::new(vec![half(0.0, 2.0, -1.0), half(2.0, 6.0, 1.0)], false).unwrap());
    let m = model(vec![("circle", vec![circle]), ("wave", vec![path])]);
    let file = export(&m, Format::Csv, &ExportOptions::default()).unwrap();
    let text = String::from_utf8(file.bytes).unwrap();
    let mut rows = [0; 2];
    for line in text.lines().skip(1) {
        let (name, numbers) = line.split_once(',').unwrap();
        let v: Vec<f64> = numbers.split(',').map(|field| field.parse().unwrap()).collect();
        let (t, p, tangent, curvature) = (v[1], Point3::new(v[2], v[3], v[4]), Vec3::new(v[5], v[6], v[7]), v[8]);
        let (index, centre, normal, radius) = match (name, t < 0.5) {
            ("circle", _) => (0, centre, normal, radius),
            (_, true) => (1, Point3::new(1.0, 0.0, 1.0), -Vec3::Z, 1.0),
            (_, false) => (1, Point3::new(4.0, 0.0, 1.0), Vec3::Z, 2.0),
        };
        rows[index] += 1;
        let spoke = p - centre;
        assert!((spoke.length() - radius).abs() < 1e-14 * radius, "{line}");
        assert!((tangent - normal.cross(spoke) / radius).length() < 1e-14, "{line}");
        assert!((curvature * radius - 1.0).abs() < 1e-13, "{line}");
    }
    assert!(rows.iter().all(|count| *count > 100), "{rows:?}");
}
