//! What stands on a picture beside the model: scale bar, title, legend, names, axes; its width and view; its combs.

use crate::models::{circle_spline, model};
use cyclide::{
    Point3, Vec3,
    curve::{Arc, BlendVariant, Circle},
    model::{CurveObject, Model},
};
use cyclide_io::{
    ExportOptions, Exporter, Format,
    export::{Camera, Provenance},
    formats::export,
};
use std::collections::HashMap;
use tiny_skia::Pixmap;

/// Colors of the first objects, of the paper, of text, and of the line over a comb.
const FIRST: [u8; 3] = [0x1B, 0x2A, 0x41];
const SECOND: [u8; 3] = [0x0B, 0x6E, 0x6E];
const PAPER: [u8; 3] = [0xFB, 0xFB, 0xF9];
const TEXT: [u8; 3] = [0x1D, 0x24, 0x2B];

fn picture(model: &Model, options: &ExportOptions) -> Pixmap {
    Pixmap::decode_png(&export(model, Format::Png, options).unwrap().bytes).unwrap()
}

fn options(change: impl FnOnce(&mut ExportOptions)) -> ExportOptions {
    let mut options = ExportOptions::default();
    change(&mut options);
    options
}

/// Columns and rows of the pixels of a color, to a few steps of the screen.
fn places(picture: &Pixmap, colour: [u8; 3]) -> Vec<(usize, usize)> {
    places_near(picture, colour, 4)
}

fn places_near(picture: &Pixmap, [r, g, b]: [u8; 3], steps: u8) -> Vec<(usize, usize)> {
    let width = picture.width() as usize;
    let like = |p: &tiny_skia::PremultipliedColorU8| {
        p.red().abs_diff(r) < steps && p.green().abs_diff(g) < steps && p.blue().abs_diff(b) < steps
    };
    let found = picture.pixels().iter().enumerate().filter(|(_, p)| like(p));
    found.map(|(i, _)| (i % width, i / width)).collect()
}

fn range(values: impl Iterator<Item = usize>) -> (usize, usize) {
    values.fold((usize::MAX, 0), |(a, b), v| (a.min(v), b.max(v)))
}

fn segment(from: [f64; 3], to: [f64; 3]) -> CurveObject {
    CurveObject::Arc(Arc::segment(from.into(), to.into()).unwrap())
}

fn circle(radius: f64) -> CurveObject {
    CurveObject::Circle(Circle::from_radius(Point3::ORIGIN, Vec3::Z, radius).unwrap())
}

/// Points on a flower, so many round it.
fn flower(count: usize) -> Vec<Point3> {
    let at = |i: usize| {
        let a = std::f64::consts::TAU * i as f64 / count as f64;
        let r = 100.0 + 20.0 * (5.0 * a).sin();
        Point3::new(r * a.cos(), r * a.sin(), 0.0)
    };
    (0..count).map(at).collect()
}

fn spline(points: &[Point3]) -> CurveObject {
    circle_spline(points, true, BlendVariant::Rational, vec![])
}

/// The longest row of text color in the lower band.
fn bar(picture: &Pixmap) -> usize {
    let lower = picture.height() as usize * 8 / 10;
    let mut rows: HashMap<usize, Vec<usize>> = HashMap::new();
    for (x, y) in places(picture, TEXT).into_iter().filter(|(_, y)| *y > lower) {
        rows.entry(y).or_default().push(x);
    }
    let longest = |xs: &Vec<usize>| {
        let mut best = 0;
        let mut run = 1;
        for pair in xs.windows(2) {
            run = if pair[1] == pair[0] + 1 { run + 1 } else { 1 };
            best = best.max(run);
        }
        best
    };
    rows.values().map(longest).max().unwrap_or(0)
}

#[test]
fn scale_bars_have_the_length_they_say() {
    for length in [1e-6, 0.37, 90.0, 4.2e8] {
        for width in [400, 1600] {
            let m = model(vec![("line", vec![segment([0.0; 3], [length, 0.0, 0.0])])]);
            let picture = picture(&m, &options(|o| o.png_width = Some(width)));
            let upper = picture.height() as usize * 8 / 10;
            let line = places(&picture, FIRST).into_iter().filter(|(_, y)| *y < upper).map(|(x, _)| x);
            let (left, right) = range(line);
            // The line's round ends lie half a width beyond it on both sides: 3.4 pixels at 1600, 1.7 at 400.
            let scale = if width < 1600 { (f64::from(width) / 1600.0).sqrt() } else { 1.0 };
            let unit = length / ((right - left + 1) as f64 - 3.4 * scale);
            let bar = bar(&picture) as f64 * unit;
            let decade = 10f64.powf(bar.log10().round());
            let round = [0.2, 0.5, 1.0, 2.0, 5.0].map(|m| m * decade);
            let off = round.iter().map(|r| (bar - r).abs() / r).fold(f64::MAX, f64::min);
            // Two pixels, for the ends of bar and line.
            assert!(off < 2.0 / (bar / unit), "{length} at {width}: a bar of {bar}");
            assert!(bar / unit > 40.0 * scale);
        }
    }
}

#[test]
fn pictures_are_as_wide_as_asked_for() {
    let curves = model(vec![("tall", vec![segment([0.0; 3], [0.0, 9.0, 0.0])]), ("round", vec![circle(1.0)])]);
    let ring = cyclide::surface::DupinCyclide::new(6.0, 2.0, 3.5).unwrap().nets([4, 4]).unwrap();
    let surfaces: Vec<_> = ring.into_iter().map(cyclide::model::SurfaceObject::Net).collect();
    let item = cyclide::model::Item::new("ring", surfaces);
    let surface = Model { items: vec![item], ..Model::default() };
    for (m, widths) in [(&curves, vec![200, 640, 1600, 3001]), (&surface, vec![200, 640])] {
        for width in widths {
            let picture = picture(m, &options(|o| o.png_width = Some(width)));
            assert_eq!(picture.width(), width);
            assert!(f64::from(picture.height()) <= 0.75 * f64::from(width) + 1.0);
        }
        for width in [0, 199, 10_001] {
            let error = export(m, Format::Png, &options(|o| o.png_width = Some(width))).unwrap_err();
            assert!(error.to_string().contains("200 to 10000"), "{error}");
        }
    }
}

#[test]
fn title_and_legend_stand_outside_of_the_drawing() {
    let m = model(vec![("one", vec![spline(&flower(30))]), ("two", vec![circle(40.0)])]);
    for width in [500, 1600] {
        let decorated = picture(&m, &options(|o| o.png_width = Some(width)));
        let plain = picture(&m, &options(|o| (o.png_width, o.png_plain) = (Some(width), true)));
        let scale = if width < 1600 { (f64::from(width) / 1600.0).sqrt() } else { 1.0 };
        let header = (86.0 * scale) as usize;
        let text = places(&decorated, TEXT);
        assert!(text.iter().any(|(_, y)| *y < header), "a title");
        assert!(places(&plain, TEXT).is_empty(), "a plain picture has no text");
        // The drawing is the upper part of the color, the legend's line the lower one, with paper between them.
        let rows =
            |colour| places(&decorated, colour).into_iter().map(|(_, y)| y).collect::<std::collections::BTreeSet<_>>();
        for colour in [FIRST, SECOND] {
            let rows: Vec<usize> = rows(colour).into_iter().collect();
            let (first, last) = (rows[0], rows[rows.len() - 1]);
            assert!(first > header, "nothing of the drawing in the title's band");
            let gap = rows.windows(2).max_by_key(|w| w[1] - w[0]).unwrap();
            let lowest_text = text.iter().filter(|(_, y)| *y > header).map(|(_, y)| *y).min().unwrap();
            assert!(last > lowest_text && gap[0] < lowest_text, "drawing down to {}, text from {lowest_text}", gap[0]);
        }
    }
}

#[test]
fn many_objects_are_named_where_they_stand() {
    let at = |i: usize| [30.0 * (i % 5) as f64, 30.0 * (i / 5) as f64, 0.0];
    let row = |i: usize| {
        let [x, y, _] = at(i);
        segment([x, y, 0.0], [x + 20.0, y, 0.0])
    };
    let names: Vec<String> = (0..10).map(|i| format!("number {i}")).collect();
    let m = model(names.iter().enumerate().map(|(i, n)| (n.as_str(), vec![row(i)])).collect());
    let decorated = picture(&m, &ExportOptions::default());
    let plain = picture(&m, &options(|o| o.png_plain = true));
    // A name has the color of its object: more of it, beside the line, and no pixel of the lines is hidden.
    // Strokes of letters are little wider than a pixel, so seldom of the full color.
    let [more, less] = [&decorated, &plain].map(|p| places_near(p, SECOND, 50));
    let rows = |p: &[(usize, usize)]| range(p.iter().map(|(_, y)| *y));
    assert!(rows(&more).1 - rows(&more).0 > rows(&less).1 - rows(&less).0 + 10, "text above or below the line");
    let widest = |p: &[(usize, usize)]| {
        let mut counts: HashMap<usize, usize> = HashMap::new();
        p.iter().for_each(|(_, y)| *counts.entry(*y).or_default() += 1);
        counts.into_values().max().unwrap()
    };
    let (a, b) = (widest(&more) as f64, widest(&less) as f64);
    assert!((a / b - 1.0).abs() < 0.2, "lines are whole: {a} and {b}");
}

#[test]
fn views_are_those_asked_for() {
    let line = model(vec![("line", vec![segment([0.0; 3], [40.0, 30.0, 0.0])])]);
    let riser = model(vec![("riser", vec![segment([0.0; 3], [10.0, 0.0, 60.0])])]);
    let wrong = |m: &Model, view: &str, across: f64, up: f64| {
        let plain = options(|o| (o.camera, o.png_plain) = (Some(view.parse::<Camera>().unwrap()), true));
        let found = places(&picture(m, &plain), FIRST);
        let (x, y) = (range(found.iter().map(|p| p.0)), range(found.iter().map(|p| p.1)));
        ((y.1 - y.0) as f64 * across - (x.1 - x.0) as f64 * up).abs() / across.max(up)
    };
    // Height times width of each line, to the pixels of the dots at its ends.
    for (m, view, across, up) in [
        (&line, "top", 40.0, 30.0),
        (&line, "front", 40.0, 0.0),
        (&line, "right", 30.0, 0.0),
        (&line, "180,0", 40.0, 0.0),
        (&riser, "front", 10.0, 60.0),
        (&riser, "top", 10.0, 0.0),
        (&riser, "left", 0.0, 60.0),
    ] {
        assert!(wrong(m, view, across, up) < 14.0, "{view}: {} pixels", wrong(m, view, across, up));
    }
    let flat = model(vec![("flower", vec![spline(&flower(12))])]);
    let top = options(|o| o.camera = Some("top".parse().unwrap()));
    let same = |o: &ExportOptions| export(&flat, Format::Png, o).unwrap().bytes;
    assert_eq!(same(&top), same(&ExportOptions::default()), "plane curves are seen from above");
}

#[test]
fn axes_are_drawn_on_request() {
    let m = model(vec![("flower", vec![spline(&flower(12))])]);
    let soft = [0x5D, 0x69, 0x74];
    let count = |axes: bool, view: Option<Camera>| {
        places_near(&picture(&m, &options(|o| (o.png_axes, o.camera) = (axes, view))), soft, 40).len()
    };
    let ruled = count(true, None);
    assert!(ruled > count(false, None) + 1000, "rulers along two sides");
    let iso = Some("iso".parse().unwrap());
    assert!(count(true, iso) > count(false, iso) + 1000, "rulers along edges of the box");
    // The same of surfaces, in drawings and in perspective.
    let ring = cyclide::surface::DupinCyclide::new(6.0, 2.0, 3.5).unwrap().nets([4, 4]).unwrap();
    let surfaces: Vec<_> = ring.into_iter().map(cyclide::model::SurfaceObject::Net).collect();
    let item = cyclide::model::Item::new("ring", surfaces);
    let m = Model { items: vec![item], ..Model::default() };
    for view in ["top", "iso", "-120,-40"] {
        let view = Some(view.parse().unwrap());
        // The names of the axes are the only text between the bands of the caption.
        let text = |axes| {
            let picture = picture(&m, &options(|o| (o.png_axes, o.camera) = (axes, view)));
            places_near(&picture, TEXT, 12).into_iter().filter(|(_, y)| (100..1100).contains(y)).count()
        };
        assert!(text(false) == 0 && text(true) > 20, "{view:?}: {} {}", text(false), text(true));
    }
}

#[test]
fn a_curve_on_another_leaves_both_colours_to_be_seen() {
    let twice = model(vec![("one", vec![spline(&flower(30))]), ("two", vec![spline(&flower(30))])]);
    let picture = picture(&twice, &ExportOptions::default());
    let upper = picture.height() as usize * 8 / 10;
    let [one, two] = [FIRST, SECOND].map(|c| places(&picture, c).into_iter().filter(|(_, y)| *y < upper).count());
    // Dashes and gaps are equally long; the dots on the joints have the first color.
    assert!(two > 1000 && one > two / 2 && one < 3 * two, "{one} {two}");
}

#[test]
fn fits_show_their_data() {
    let m = model(vec![("fit", vec![spline(&flower(12))])]);
    let colour = [0x9C, 0xC0, 0xE4];
    let none = places(&picture(&m, &ExportOptions::default()), colour).len();
    // Points off the curve, well apart.
    let data = (0..20).map(|i| Point3::new(50.0 - 5.0 * f64::from(i), 20.0, 0.0)).collect();
    let provenance = [Provenance { kind: "fair-fit", data, ..Provenance::default() }];
    let exporter = Exporter::with_provenance(&m, &provenance).unwrap();
    let with_data = |options: &ExportOptions| {
        let bytes = exporter.export(Format::Png, options).unwrap().bytes;
        places(&Pixmap::decode_png(&bytes).unwrap(), colour).len()
    };
    let shown = with_data(&ExportOptions::default());
    // The area of a dot of radius 4.4 is 61 pixels, its rim is mixed with the paper.
    assert!(none == 0 && shown > 20 * 40 && shown < 26 * 61, "{shown}");
    assert_eq!(with_data(&options(|o| o.png_plain = true)), 0);
}

#[test]
fn what_has_no_name_to_be_drawn_is_named_in_a_note() {
    let name = "\u{6771}\u{4eac}";
    let m = model(vec![(name, vec![circle(1.0)]), ("\u{43c}\u{438}\u{440}", vec![circle(2.0)])]);
    let notes = export(&m, Format::Png, &ExportOptions::default()).unwrap().notes;
    assert_eq!(notes, [format!("the font of the picture has no glyphs for '{name}', which is labeled object 1")]);
    assert!(export(&m, Format::Png, &options(|o| o.png_plain = true)).unwrap().notes.is_empty());
}

#[test]
fn many_surfaces_leave_the_picture_its_room() {
    let patch = |i: usize| {
        let (x, y) = (3.0 * (i % 8) as f64, 3.0 * (i / 8) as f64);
        let corners = [[x, y], [x + 2.0, y], [x, y + 2.0], [x + 2.0, y + 2.0]].map(|[x, y]| Point3::new(x, y, 0.0));
        let patch = cyclide::surface::CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y).unwrap();
        let name = format!("a panel with a rather long name, number {i}");
        cyclide::model::Item::new(name, vec![cyclide::model::SurfaceObject::Patch(patch)])
    };
    let m = Model { items: (0..40).map(patch).collect(), ..Model::default() };
    let picture = picture(&m, &options(|o| o.png_width = Some(1000)));
    // The drawing of 40 panels is at least half as high as the picture; the legend's text is below it.
    let (_, rows) = (0, places(&picture, TEXT).into_iter().map(|(_, y)| y).filter(|y| *y > 100));
    let first = rows.min().unwrap();
    assert!(first > picture.height() as usize / 2, "{first} of {}", picture.height());
}

fn svg(m: &Model) -> (String, Vec<String>) {
    let file = export(m, Format::Svg, &options(|o| o.svg_comb = true)).unwrap();
    (String::from_utf8(file.bytes).unwrap(), file.notes)
}

/// The `d` attributes of the combs' paths of a class.
fn comb_paths<'a>(text: &'a str, class: &str) -> Vec<&'a str> {
    let start = format!("<path class=\"{class}\"");
    let paths = text.split(&start).skip(1);
    paths.map(|rest| rest.split_once("d=\"").unwrap().1.split('"').next().unwrap()).collect()
}

fn numbers(data: &str) -> Vec<(f64, f64)> {
    let points = data.split(['M', 'L']).filter(|p| !p.is_empty());
    points.map(|p| p.split_once(' ').unwrap()).map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap())).collect()
}

#[test]
fn combs_have_eight_teeth_a_piece_and_show_what_is_between() {
    for count in [12, 44, 1102] {
        let (text, _) = svg(&model(vec![("flower", vec![spline(&flower(count))])]));
        let [teeth] = comb_paths(&text, "teeth")[..] else { panic!("one comb") };
        assert!(teeth.matches('M').count() >= 8 * count, "{} teeth on {count} pieces", teeth.matches('M').count());
        // The line over the tips has no corner that the curvature has not: it turns little from part to part.
        let [tips] = comb_paths(&text, "tips")[..] else { panic!("one comb") };
        assert!(numbers(tips).len() >= 8 * count);
    }
}

#[test]
fn combs_of_many_pieces_are_bounded_and_keep_their_extremes() {
    // A circle with one bump, half a thousandth of the points wide.
    let count = 30_000;
    let at = |i: usize| {
        let a = std::f64::consts::TAU * i as f64 / count as f64;
        let r = 100.0 + 0.004 * (-((a - 1.0) / 2e-3).powi(2)).exp();
        Point3::new(r * a.cos(), r * a.sin(), 0.0)
    };
    let points: Vec<Point3> = (0..count).map(at).collect();
    let (text, _) = svg(&model(vec![("wheel", vec![spline(&points)])]));
    let [tips] = comb_paths(&text, "tips")[..] else { panic!("one comb") };
    let tips = numbers(tips);
    assert!(tips.len() < 60_000, "{}", tips.len());
    let radius: Vec<f64> = tips.iter().map(|(x, y)| x.hypot(*y)).collect();
    let mut sorted = radius.clone();
    sorted.sort_by(f64::total_cmp);
    let common = sorted[sorted.len() / 2] - 100.0;
    // The bump bends by 0.004 · 2/(2e-3)² /100² = 0.2 more than the circle's 0.01: cut at 2.5 times the common tooth.
    assert!(sorted[sorted.len() - 1] - 100.0 > 2.4 * common, "the bump stays");
    assert!(sorted[0] < 100.0 - common, "and the hollows beside it");
}

#[test]
fn combs_do_not_lie_on_each_other() {
    let near: Vec<Point3> = flower(44).iter().map(|p| Point3::new(1.002 * p.x, 1.002 * p.y, 0.0)).collect();
    let both = model(vec![("one", vec![spline(&flower(44))]), ("two", vec![spline(&near)])]);
    let (text, notes) = svg(&both);
    assert_eq!(comb_paths(&text, "teeth").len(), 1);
    assert!(notes.iter().any(|note| note.contains("omitted: two")), "{notes:?}");
    // Side by side: both, and no tooth of one crosses the other's curve or comb.
    let arcs = |y: f64, bulge: f64| {
        CurveObject::Arc(Arc::from_bulge([0.0, y, 0.0].into(), [100.0, y, 0.0].into(), Vec3::Z, bulge).unwrap())
    };
    let (text, notes) = svg(&model(vec![("upper", vec![arcs(50.0, 0.3)]), ("lower", vec![arcs(0.0, -0.3)])]));
    assert!(notes.iter().all(|note| !note.contains("omitted")), "{notes:?}");
    let combs: Vec<Vec<(f64, f64)>> = comb_paths(&text, "tips").into_iter().map(numbers).collect();
    let lowest = |comb: &[(f64, f64)]| comb.iter().map(|p| p.1).fold(f64::MIN, f64::max);
    let highest = |comb: &[(f64, f64)]| comb.iter().map(|p| p.1).fold(f64::MAX, f64::min);
    // The page's second axis points down: the upper comb ends above the lower one.
    assert!(lowest(&combs[0]) < highest(&combs[1]), "{} {}", lowest(&combs[0]), highest(&combs[1]));
}

#[test]
fn corners_of_a_picture_are_paper() {
    let m = model(vec![("one", vec![circle(1.0)])]);
    let picture = picture(&m, &ExportOptions::default());
    let corner = picture.pixels()[0];
    assert_eq!([corner.red(), corner.green(), corner.blue()], PAPER);
}
