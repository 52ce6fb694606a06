//! Documents whose files are right and were once refused, or whose bound was once exceeded without a word.

use cyclide::model::Model;
use cyclide_io::{
    Document, ExportOptions, Exporter, Format, ModelBuilder,
    export::DxfVersion,
    report::{CheckError, FileReport},
};
use serde_json::{Value, json};
use std::path::Path;

const CURVES: [Format; 7] =
    [Format::Step, Format::Dxf, Format::Svg, Format::Csv, Format::Json, Format::Glb, Format::Obj];
const SURFACES: [Format; 6] = [Format::Step, Format::Svg, Format::Json, Format::Glb, Format::Obj, Format::Stl];

/// The model of a document with these objects.
fn model(objects: &Value) -> Model {
    let text = json!({"cyclide": 1, "objects": objects}).to_string();
    let document = Document::parse("m.json", text.as_bytes()).unwrap();
    let read = |_: &Path| Err(std::io::ErrorKind::NotFound.into());
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).unwrap();
    let built = (0..document.objects.len()).map(|index| builder.build(index, &mut |_| {}).unwrap());
    let items = built.filter(|built| !built.construction).map(|built| built.item).collect();
    Model { units: document.units, items }
}

/// The reports on the files of a document: each passes its check, and what was measured is within what is printed.
fn checked(objects: &Value, formats: &[Format], options: &ExportOptions) -> Vec<FileReport> {
    let model = model(objects);
    let exporter = Exporter::new(&model).unwrap();
    let report = |format: &Format| {
        let file = exporter.export(*format, options).unwrap();
        let report = exporter.check(Path::new("o"), *format, &file).map_err(|e| format!("{format:?}: {e}")).unwrap();
        assert!(report.exact || report.deviation.unwrap() <= report.bound, "{format:?}: {report:?}");
        report
    };
    formats.iter().map(report).collect()
}

/// Right in all formats but STEP, whose readers take an edge of it for a point.
fn right_but_in_step(objects: &Value) {
    right(objects, &SURFACES[1..]);
    let error = Exporter::new(&model(objects)).unwrap().export(Format::Step, &ExportOptions::default()).unwrap_err();
    assert_eq!(error.reason(), "edge-too-short");
}

fn right(objects: &Value, formats: &[Format]) -> Vec<FileReport> {
    checked(objects, formats, &ExportOptions::default())
}

#[test]
fn splines_in_space_drawn_in_the_plane() {
    let closed = json!({"type": "circle-spline", "closed": true, "order": 4,
        "points": [[6.2, -0.96, 0.1], [6.23, -1.5, -0.9], [6.2, 0.6, 1.2], [6.2, -0.9, -0.5]]});
    let open = json!({"type": "circle-spline", "order": 3,
        "points": [[20, 500, 0.02], [0.002, 10, 0.001], [-0.04, -0.6, 0.22], [-0.02, 0.0008, -0.0001]]});
    right(&json!({"a": closed}), &CURVES);
    right(&json!({"a": open}), &CURVES);
}

/// Biarcs pass every sample of this hairpin closely, but one ran past its end by a tenth of the tolerance.
#[test]
fn arcs_at_a_hairpin_stay_within_the_tolerance() {
    let points = [
        [0.031_928_321_046_537_31, -0.544_344_800_947_514_7],
        [0.032_851_410_161_867_586, -0.553_755_647_704_478_5],
        [0.035_019_249_366_570_214, -0.227_870_027_051_844_2],
        [0.035_126_631_535_718_676, 1.605_546_364_739_391_7],
        [0.046_021_946_081_293_29, -0.483_201_306_227_25],
    ];
    right(&json!({"a": {"type": "circle-spline", "order": 1, "points": points}}), &CURVES);
}

/// Weights down to 3e-9: its form is made without cancellation, and exact to the last digits all the same.
#[test]
fn a_curve_that_comes_near_infinity_keeps_its_digits() {
    let hairpin = json!({"a": {"type": "circle-spline", "points": [[0, 0], [0, 9], [0.0002, 1], [1, 0]]}});
    assert!(right(&hairpin, &CURVES)[0].exact);
}

#[test]
fn a_bound_includes_the_rounding_of_the_numbers() {
    let options = ExportOptions { tolerance: Some(1e-6), ..ExportOptions::default() };
    let spline = json!({"type": "circle-spline", "order": 4, "variant": "trigonometric",
        "points": [[0.01, 6], [0.32, 2.5], [0.32, -5], [0.3171, 10]]});
    for report in checked(&json!({"a": spline}), &[Format::Json, Format::Step, Format::Dxf], &options) {
        assert!(report.deviation.unwrap() <= report.bound, "{report:?}");
    }
}

#[test]
fn a_bulge_of_a_million_is_nearly_a_full_circle() {
    right(&json!({"a": {"type": "arc", "from": [0, 0], "to": [1, 0], "bulge": 1e6}}), &CURVES);
}

#[test]
fn ends_that_nearly_touch_do_not_close_a_curve() {
    let biarc = json!({"type": "biarc", "from": [0, 3, 1], "from_tangent": [0, 1],
        "to": [0, 3, 1.000_000_001], "to_tangent": [1, 0]});
    right(&json!({"a": biarc}), &CURVES);
    for (a, c, mu) in [(0.8, 0.799_999_834_695_580_3, 0.8), (9.0, 8.999_999_999_925_162, 0.0)] {
        let cyclide = json!({"type": "cyclide", "a": a, "c": c, "mu": mu, "construction": true});
        let edges = json!({"type": "support-structure", "of": "a"});
        right(&json!({"a": cyclide, "b": edges}), &CURVES);
    }
}

#[test]
fn arcs_after_inversions() {
    let points = [[0, 0], [0, 1], [1, 0], [0, 0], [0, -4]];
    let arcs = json!({"type": "arc-spline", "points": points, "construction": true});
    let steps = [json!({"inversion": {"center": [0, 0, 1], "radius": 1}})];
    let image = json!({"a": arcs, "b": {"type": "transform", "of": "a", "steps": steps}});
    right(&image, &CURVES);
    // The curve passes through its start on the way, and R12 has no groups.
    let options = ExportOptions { dxf_version: DxfVersion::R12, ..ExportOptions::default() };
    checked(&image, &[Format::Dxf], &options);
}

/// The image of an arc that passes within 1e-8 of the center: nearly a full circle of radius 2e7 on a chord of 1.
#[test]
fn an_arc_that_comes_near_infinity_is_written_with_what_its_digits_hold() {
    let arc = json!({"type": "arc", "through": [[1, 0], [0, 1], [-0.416_146_836_547_142_4, 0.909_297_426_825_681_7]],
        "construction": true});
    let center = [0.877_582_557_448_272_4, 0.479_425_542_620_239_2, -8.279_595_174_659_527e-9];
    let steps = json!([{"inversion": {"center": center, "radius": 0.733}}]);
    right(&json!({"a": arc, "b": {"type": "transform", "of": "a", "steps": steps}}), &CURVES);
}

/// A circle that is smaller than the last digit of its place has no radius to be read.
#[test]
fn arcs_below_the_rounding_of_their_place() {
    let points = json!([[0, 0], [-2, 0], [51.01, 0], [52, -8], [61, 0], [0, 0]]);
    let fit = json!({"type": "arc-fit", "points": points, "tolerance": 1e-12, "construction": true});
    let steps =
        json!([{"inversion": {"center": [0, -8], "radius": 13}}, {"inversion": {"center": [1, 7.7], "radius": 1}}]);
    right(&json!({"a": fit, "b": {"type": "transform", "of": "a", "steps": steps}}), &CURVES);
}

#[test]
fn a_tiny_patch_and_a_folded_one() {
    let d = 4e-14;
    let tiny = json!({"type": "cyclide-patch", "corners": [[0, 0], [d, 0], [0, d], [d, d]], "frame": [[1, 0, 0.3], [0, 1, 0]]});
    right_but_in_step(&json!({"a": tiny}));
    let folded = json!({"type": "cyclidic-net", "grid": [[[0, 0], [1, 0]], [[0, 1], [1e-9, 1]]], "frame":
        [[-0.007_649_107_754_099_032, -0.181_176_961_603_385_8, 1.103_719_549_477_112],
         [1.530_320_371_117_303_7, 0.369_986_935_882_288_1, 0.071_339_403_501_887_11]]});
    right_but_in_step(&json!({"a": folded}));
    // The last vertex is as near to the one before as corners may be off their circle.
    let row = |y: f64, last: f64| json!([[0, y], [1, y], [2, y], [3, y], [last, y]]);
    let folded = json!({"type": "cyclidic-net", "grid": [row(0.0, 4.0), row(1.0, 4.0), row(2.0, 3.000_000_000_772_683)], "frame":
        [[-0.584_936_588_996_192_3, 0.189_620_990_391_610_32, -0.885_197_112_749_438_8],
         [0.116_017_408_592_496_21, -0.415_561_544_955_695_96, -0.165_682_893_512_727_03]]});
    right_but_in_step(&json!({"a": folded}));
}

/// The last corner lies 5e-11 beside the one before: the singular line is beside that side, and its cells are folded there.
#[test]
fn a_net_that_folds_within_its_last_cells() {
    let x = 1.000_000_000_046_588_3;
    let grid = [
        [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]],
        [[0.0, 1.0], [1.0, 1.0], [2.0, 1.0]],
        [[0.0, 2.0], [1.0, 2.0], [x, 2.0]],
    ];
    let frame = [
        [0.307_495_885_218_439_96, 1.003_530_332_833_152_8, 0.147_871_516_662_398_42],
        [0.665_573_963_020_318_2, -0.443_951_956_211_628_5, 1.628_832_954_974_037],
    ];
    right_but_in_step(&json!({"a": {"type": "cyclidic-net", "grid": grid, "frame": frame}}));
}

/// Two corners 1e-4 apart lie beside a singular line: its points are one vertex of the mesh, with the normal of their middle.
#[test]
fn a_side_that_is_nearly_a_point_is_one_in_meshes() {
    let corners = [
        [-0.737_393_715_541_245, 0.675_463_180_551_151],
        [-0.737_461_258_172_22, 0.675_389_437_802_404],
        [0.775_565_878_510_25, -0.631_266_637_872_322],
        [-0.725_932_304_200_14, -0.687_766_159_183_974],
    ];
    let frame = [
        [0.758_858_712_109_825_9, -0.404_520_160_974_248_4, 0.372_396_724_640_389_25],
        [-0.642_011_353_452_640_8, -1.408_580_435_196_164_6, -0.221_815_257_987_403_87],
    ];
    let patch = json!({"type": "cyclide-patch", "corners": corners, "frame": frame});
    right(&json!({"a": patch}), &[Format::Obj, Format::Stl, Format::Glb]);
}

/// The inner lobe of this spindle is 2e-9 thick: STL, in single precision, cannot hold it, and says so. The tube of the
/// second ring is up to 1e-4 thick and so holds here and there only.
#[test]
fn a_body_that_single_precision_swallows_is_refused_by_name() {
    let spindle = json!({"type": "cyclide", "a": 3, "c": 0, "mu": 3.000_000_001, "center": [11, 3, 2]});
    let thin = json!({"type": "cyclide", "a": 8.427_978_978_381_96, "c": 5.772_069_795_024_742_5e-5,
        "mu": 2.565_579_062_553_178e-6, "center": [821.306_924_887_634_8, -1_407.285_969_194_662, -890.466_744_019_394_7],
        "axis": [-1.081_183_257_769_668_7, 1.019_775_529_414_729_5, -0.027_303_565_685_922_463]});
    for (object, words) in
        [(spindle, "a body vanishes in single precision"), (thin, "a part of a body vanishes in single precision")]
    {
        let model = model(&json!({"a": object}));
        let refused = Exporter::new(&model).unwrap().export(Format::Stl, &ExportOptions::default());
        let message = refused.err().unwrap().to_string();
        assert!(message.contains(words), "{message}");
    }
}

/// Half of the way of these images is within some 1e-8 of the parameter: its numbers tell places to 1e-9 of the length only.
#[test]
fn arcs_that_pass_near_infinity_are_compared_as_finely_as_their_parameters_are() {
    let spline = json!({"type": "arc-spline", "points": [[0, 0, 0], [1.295_465_187_612_693_5, 1, 0], [2.590_930_375_225_387, 0, 0.3]],
        "construction": true});
    let center = [2.590_930_472_637_581_7, 4.564_671_214_536_575_5e-8, 0.300_000_035_471_163_2];
    let inverted = json!({"type": "transform", "of": "a", "steps": [{"inversion": {"center": center, "radius": 8.360_933_091_955_22}}]});
    let options = ExportOptions { tolerance: Some(3.907_819_152_065_528e-3), ..ExportOptions::default() };
    checked(&json!({"a": spline, "b": inverted}), &CURVES, &options);
}

/// The plane of an arc with a sagitta of 2.5e-7, which is tilted: DXF keeps it, with its bulge.
#[test]
fn a_nearly_straight_arc_lies_in_its_plane() {
    let arc = json!({"type": "arc", "from": [-6, 8, 3.79], "to": [0.004_213_094_461_798_297, -1.410_936_743_575_756_7, -7],
        "bulge": 3.271_642_715_259_416e-8,
        "normal": [2.039_963_112_795_606_4, -1.266_247_231_718_024_7, -0.496_932_854_862_242_15]});
    let reports = right(&json!({"a": arc}), &[Format::Dxf, Format::Step, Format::Json]);
    assert!(reports.iter().all(|report| report.exact), "{reports:?}");
}

/// Mesh of a ring that is nearly two spheres: the foot of a point of a cell in which the weights differ by 1e6 takes more
/// than three steps.
#[test]
fn a_ring_within_rounding_of_a_horn_is_as_near_as_proved() {
    let ring = json!({"type": "cyclide", "a": 0.004_418_332_686_136_951, "c": 0.004_418_332_686_131_583,
        "mu": 0.000_180_764_138_514_548_52});
    let options = ExportOptions { tolerance: Some(4.830_849_465_396_18e-2), ..ExportOptions::default() };
    checked(&json!({"a": ring}), &[Format::Obj], &options);
}

/// What no digits can hold is refused by name, and is no fault of the writer: arcs of two kilometers that are nearly straight,
/// within 2e-9.
#[test]
fn too_few_digits_are_told_from_wrong_files() {
    let points = json!([
        [0.0, 0.026_718_772_647_817_947, -0.008_652_213_773_029_05],
        [215_948.849_953_774_2, 0.016_083_714_406_460_625, -0.013_486_253_292_092_61],
        [431_897.699_907_548_4, -0.000_440_909_378_394_250_4, 0.007_477_563_850_029_479_5],
        [647_846.549_861_322_6, 0.032_426_407_188_778_046, -0.020_359_480_465_027_176],
        [863_795.399_815_096_8, 0.012_646_241_968_762_41, 0.004_882_512_356_829_666],
        [1_079_744.249_768_870_9, 0.006_201_229_332_773_655, 0.017_794_867_972_772_813],
        [1_295_693.099_722_645_2, 0.008_193_834_514_613_59, 0.014_611_751_882_835_498],
        [1_511_641.949_676_419_4, 0.008_312_598_413_680_155, -0.008_342_036_263_279_791],
        [1_727_590.799_630_193_5, -0.015_771_946_631_936_165, -0.000_604_657_662_318_534_1],
        [1_943_539.649_583_967_6, 0.010_776_431_559_548_653, 0.023_777_679_548_106_962]
    ]);
    let spline = json!({"type": "circle-spline", "points": points, "order": 2, "variant": "trigonometric"});
    let model = model(&json!({"a": spline}));
    let exporter = Exporter::new(&model).unwrap();
    let options = ExportOptions { tolerance: Some(1.991_998_469_815_534e-9), ..ExportOptions::default() };
    let file = exporter.export(Format::Dxf, &options).unwrap();
    let error = exporter.check(Path::new("o"), Format::Dxf, &file).err().unwrap();
    assert!(matches!(error, CheckError::TooFewDigits { .. }), "{error}");
}

/// A drawing below the rounding of its place has no margins and no unit.
#[test]
fn drawings_below_the_rounding_of_their_place_are_refused() {
    for points in [json!([[0, 1e5], [1e-10, 1e5]]), json!([[0, 1e9], [1e-6, 1e9]])] {
        let model = model(&json!({"a": {"type": "arc-spline", "points": points}}));
        let refused = Exporter::new(&model).unwrap().export(Format::Svg, &ExportOptions::default());
        let message = refused.err().unwrap().to_string();
        assert!(message.contains("rounding of its coordinates"), "{message}");
    }
    right(
        &json!({"a": {"type": "arc-spline", "points": [[0, 1e5], [1e-5, 1e5], [1e-5, 100_000.000_02]]}}),
        &[Format::Svg],
    );
}

/// Inverted at a distance of 6e-10, some of these arcs are nearly circles of 1e13: DXF has two arcs for each, which can be read.
#[test]
fn nearly_full_arcs_in_space_are_written_as_two() {
    let points: Vec<[f64; 2]> = (0..8).map(|i| [1.870_327_303_536_819 * f64::from(i), f64::from(i % 2)]).collect();
    let fit =
        json!({"type": "arc-fit", "points": points, "tolerance": 3.144_050_211_219_083_4e-6, "construction": true});
    let center = [3.740_654_609_193_804, 9.439_335_688_577_371e-11, 5.523_396_815_118_282e-10];
    let steps = json!([{"inversion": {"center": center, "radius": 66.019_655_871_918_64}}]);
    let model = model(&json!({"a": fit, "b": {"type": "transform", "of": "a", "steps": steps}}));
    let exporter = Exporter::new(&model).unwrap();
    let options = ExportOptions { tolerance: Some(0.567), ..ExportOptions::default() };
    let file = exporter.export(Format::Dxf, &options).unwrap();
    let error = exporter.check(Path::new("o"), Format::Dxf, &file).err();
    assert!(error.as_ref().is_none_or(|e| matches!(e, CheckError::TooFewDigits { .. })), "{error:?}");
}

/// Supports of a net stand on its normals: one of them may be upright.
#[test]
fn curves_that_are_points_in_a_drawing_are_left_out_of_it() {
    let (post, beam) = (json!([[1, 1, 0], [1, 1, 3], [1, 1, 5]]), json!([[1, 1, 0], [4, 1, 0]]));
    let objects = json!({
        "posts": {"type": "arc-spline", "points": [post, [[2, 1, 0], [2, 1, 3]]]},
        "both": {"type": "arc-spline", "points": [beam, post, beam]},
    });
    let model = model(&objects);
    let exporter = Exporter::new(&model).unwrap();
    let mut file = exporter.export(Format::Svg, &ExportOptions::default()).unwrap();
    let note = "curves that are points in the view along the z axis, within their tolerance, are left out: posts 0, posts 1, both 1";
    assert!(file.notes.iter().any(|n| n == note), "{:?}", file.notes);
    let text = String::from_utf8(file.bytes.clone()).unwrap();
    assert_eq!((text.matches("class=\"contour\"").count(), text.contains("posts")), (2, false));
    assert!(exporter.check(Path::new("o"), Format::Svg, &file).unwrap().exact);
    // An S round a post, within the tolerance of its start, though its box is not.
    let leaning = json!({"type": "circle-spline", "order": 1, "points": [[0, 0, 0], [0, 0, 10], [0, 0, 20]],
        "ends": {"start": [0.1, 0, 1], "end": [0.1, 0, 1]}});
    let options = ExportOptions { tolerance: Some(0.27), ..ExportOptions::default() };
    checked(&json!({"a": leaning, "b": {"type": "arc-spline", "points": [[0, 0], [20, 0]]}}), &CURVES, &options);
    // A curve that is no point may not be missing.
    file.bytes = text.replacen("<path class=\"contour\"", "<path class=\"other\"", 1).into_bytes();
    assert!(exporter.check(Path::new("o"), Format::Svg, &file).is_err());
    right(&objects, &CURVES);
}

/// Whose tolerance is far above the distance of its ends: a biarc between these is a millionth of the curve.
#[test]
fn a_loop_whose_ends_nearly_touch_becomes_arcs_within_any_tolerance() {
    let points = [
        [0.169_356_014_012_998_57, -0.748_542_415_612_107_4, 0.0],
        [-0.522_704_117_222_895_2, 0.095_846_720_922_338_23, 0.0],
        [-2.374_604_980_661_597_4, -0.815_364_723_445_25, 0.0],
        [-1.165_707_243_474_837_5, -0.844_667_323_609_046, 0.0],
        [0.169_356_056_212_050_58, -0.748_542_385_520_032, 4.092_467_029_875_905_4e-8],
    ];
    for tolerance in [2.4, 0.5, 0.01] {
        let options = ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() };
        let reports = checked(&json!({"a": {"type": "fair-spline", "points": points}}), &CURVES, &options);
        assert!(reports.iter().all(|report| report.bytes < 100_000), "no more arcs than it takes");
    }
}

#[test]
fn a_tolerance_that_ruins_the_shape_is_named() {
    let circle = json!({"a": {"type": "circle", "center": [0, 0], "radius": 10}});
    for (tolerance, named) in [(4.0, true), (1e300, true), (0.1, false)] {
        let options = ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() };
        let notes = &checked(&circle, &[Format::Csv], &options)[0].notes;
        let says =
            |note: &String| note.starts_with("the file deviates by") && note.ends_with("use a smaller tolerance");
        assert_eq!(notes.iter().any(says), named, "{tolerance:e}: {notes:?}");
    }
}

/// A curve that comes next to the center of an inversion has an image that no numbers hold; a little farther away it has.
#[test]
fn images_of_curves_next_to_the_centre_are_refused_where_the_map_stands() {
    let arc = json!({"type": "arc", "through": [[-1, 0], [0, 1], [1, 0]], "construction": true});
    let toward = json!({"type": "arc", "from": [0, 0.03, 5.27], "to": [0, 0, 0], "end_tangent": [1, 0, 0],
        "construction": true});
    let biarc = json!({"type": "biarc", "from": [0, 0.03, 5.27], "from_tangent": [2, 0, 4.4], "to": [0, 0, 0],
        "to_tangent": [1, 0, 0], "construction": true});
    for (curve, center, radius, refused) in [
        (&arc, [0.0, 1.000_000_000_01, 0.0], 1.0, true),
        (&arc, [0.0, 1.000_000_01, 0.0], 1.0, false),
        (&arc, [0.0, 1.0 + 3e-9, 0.0], 1.0, false),
        (&toward, [-2.4e-7, 0.0, 0.0], 20.0, true),
        (&biarc, [-2.4e-6, 0.0, 0.0], 20.0, true),
    ] {
        let steps = json!([{"inversion": {"center": center, "radius": radius}}]);
        let objects = json!({"b": curve, "a": {"type": "transform", "of": "b", "steps": steps}});
        if refused {
            let text = json!({"cyclide": 1, "objects": objects}).to_string();
            let document = Document::parse("m.json", text.as_bytes()).unwrap();
            let read = |_: &Path| Err(std::io::ErrorKind::NotFound.into());
            let mut builder = ModelBuilder::new(&document, Path::new(""), &read).unwrap();
            let error = builder.build(1, &mut |_| {}).unwrap_err().to_string();
            assert!(error.contains("objects.a.steps[0]") && error.contains("[point-at-infinity]"), "{error}");
            assert!(error.contains("minimum") && error.contains("away from the curve"), "{error}");
        } else {
            right(&objects, &CURVES);
        }
    }
}

/// Next to a node the speeds are rounding, and the check reads them as the mesh does.
#[test]
fn a_ring_next_to_a_node_far_from_the_origin_has_its_normals() {
    let (a, c, mu) = (1e-14, 9.999_999_998_206_383e-15, 9.999_999_998_403_767e-15);
    let center = [1.258_791_479_428_369_8e-13, 1.737_154_487_345_205_8e-15, 3.385_172_538_686_34e-13];
    let ring = json!({"a": {"type": "cyclide", "a": a, "c": c, "mu": mu, "center": center}});
    let options = ExportOptions { tolerance: Some(9.462_01e-16), ..ExportOptions::default() };
    checked(&ring, &[Format::Glb, Format::Obj], &options);
}

/// What rounding adds to a tolerance is said.
#[test]
fn a_tolerance_that_rounding_exceeds_is_named() {
    let net = json!({"type": "cyclidic-net", "grid": [[[0, 0, 0], [10, 0, 0]], [[0, 10, 0], [10, 10, 0]]],
        "frame": [[1, 0, 0.4], [0, 1, 0]]});
    for (tolerance, named) in [(1e-9, true), (1e-3, false)] {
        let options = ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() };
        let notes = &checked(&json!({"a": net}), &[Format::Glb], &options)[0].notes;
        let says = |note: &String| note.starts_with("the tolerance") && note.contains("is not met");
        assert_eq!(notes.iter().any(says), named, "{tolerance:e}: {notes:?}");
    }
}

/// A profile that runs round its axis sweeps cells whose two parameter lines are nearly one: the sample nearest to a point of
/// a triangle lies far from its foot.
#[test]
fn parameter_lines_that_are_nearly_one() {
    // A figure of Lissajous.
    let points: Vec<[f64; 2]> =
        (0..8).map(|k| f64::from(k) * std::f64::consts::FRAC_PI_4).map(|u| [u.sin(), (2.0 * u).sin()]).collect();
    let profile = json!({"type": "fair-fit", "points": points, "tolerance": 8e-4, "centre": 1.0, "construction": true});
    let turned = json!({"type": "revolution", "of": "a", "center": [-0.612_084_499_575_929_1, -0.578_642_273_719_951_3, -0.079_740_605_788_095_8],
        "axis": [-0.951_027_705_402_560_7, -0.747_310_664_179_462_8, -0.621_809_440_428_399_3]});
    let options = ExportOptions { tolerance: Some(2e-3), ..ExportOptions::default() };
    checked(&json!({"a": profile, "b": turned}), &[Format::Obj, Format::Stl], &options);
}
