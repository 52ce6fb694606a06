//! Bytes that once broke the readers, and random ones, on the stable toolchain.

#![allow(clippy::expect_used, reason = "what is not there fails the test")]
#![allow(clippy::print_stderr, reason = "the figures of a long run")]

#[path = "../../../fuzz/exercise.rs"]
mod exercise;

use std::time::Instant;

use cyclide_io::{
    Document, ExportOptions, Format, ModelBuilder,
    check::ReadError,
    export::{DxfVersion, StepEdges, VtuEncoding},
    formats::{MeshFormat, export, read_back},
};
use cyclide_testkit::mutate::{Form, Mutator};
use proptest::prelude::*;

/// What is done with bytes.
type Exercise = fn(&[u8]);

/// A fuzz target.
struct Target {
    name: &'static str,
    /// The format that is read back, of which right files are written.
    format: Option<Format>,
    exercise: Exercise,
    form: Form,
    /// Words of the format.
    words: &'static [&'static str],
    /// Broken copies that the tests try.
    copies: usize,
}

/// A target that reads files which others have written.
const fn given(
    name: &'static str,
    exercise: Exercise,
    form: Form,
    words: &'static [&'static str],
    copies: usize,
) -> Target {
    Target { name, format: None, exercise, form, words, copies }
}

/// A target that reads files of ours back.
macro_rules! written {
    ($name:literal, $format:ident, $form:ident, $words:expr, $copies:literal) => {
        Target {
            name: $name,
            format: Some(Format::$format),
            exercise: |data| exercise::written(Format::$format, data),
            form: Form::$form,
            words: $words,
            copies: $copies,
        }
    };
}

/// All targets of `fuzz/fuzz_targets`.
const TARGETS: [Target; 22] = [
    given(
        "document",
        exercise::document,
        Form::Lists,
        &["\"type\":", "\"points\":", "null", "[[0,0],[1,0]]", "\"closed\":true,", "\\u0000", "é"],
        1000,
    ),
    given(
        "points_csv",
        exercise::points_csv,
        Form::Bytes,
        &["#", "\"", "x,y", "\r", "\n\n", "1,5", "contour", "corner", "lon,lat", "\t", ";"],
        4000,
    ),
    given("obj", exercise::obj, Form::Bytes, &["f 1 2 3 4\n", "v 0 0 0\n", "\\\n", "//", "-1", "#", "\r"], 4000),
    given(
        "poses",
        exercise::poses,
        Form::Bytes,
        &["t,x,y,z", "qw", "roll_deg", "\u{202e}", "\"", ";", "1,5", "nan"],
        500,
    ),
    given("heights", exercise::heights, Form::Bytes, &["\n", ",", ",,", "nan", "1,5;", "\u{200b}", "\""], 50),
    given(
        "mesh_obj",
        |data| exercise::mesh(MeshFormat::Obj, data),
        Form::Bytes,
        &["f 1 2 3 4\n", "v 0 0 0\n", "\\\n", "1//1", "-1", "o \u{202e}\n", "vn 0 0 0\n"],
        200,
    ),
    given(
        "mesh_stl",
        |data| exercise::mesh(MeshFormat::Stl, data),
        Form::Bytes,
        &[
            "facet normal 0 0 1\n",
            "outer loop\n",
            "vertex 0 0 0\n",
            "endloop\n",
            "endfacet\n",
            "endsolid",
            "solid \u{202e}\n",
        ],
        200,
    ),
    given(
        "mesh_ply",
        |data| exercise::mesh(MeshFormat::Ply, data),
        Form::Bytes,
        &[
            "element face 4\n",
            "property list uchar int x\n",
            "property float nx\n",
            "end_header\n",
            "binary_big_endian",
            "\u{202e}",
        ],
        200,
    ),
    given(
        "mesh_glb",
        |data| exercise::mesh(MeshFormat::Glb, data),
        Form::Container,
        &["\"mesh\":0", "\"count\":", "\"children\":[0]", "null", "[]", "\"mode\":5", "-1", "\"sparse\":{}"],
        200,
    ),
    written!("step", Step, Lists, &["#1", "$", "*", "(())", "'", "CIRCLE", "LINE", "ENDSEC;", ".T.", "=("], 3000),
    written!("glb", Glb, Container, &["\"mesh\":0", "\"count\":", "null", "[]", "{}", "\"mode\":1", "-1"], 3000),
    written!(
        "dxf",
        Dxf,
        Pairs,
        &["0\nSPLINE\n", "0\nARC\n", "90\n", "70\n", "0\nVERTEX\n", "0\nSEQEND\n", "\r\n"],
        4000
    ),
    written!("svg", Svg, Bytes, &["<path d=\"", "/>", "M0,0", "A1 1 0 0 1 2 2", "\"", "<g>", "viewBox", "nan"], 1000),
    written!("csv", Csv, Bytes, &[",", "\n", "contour", "\"", "nan", "x,y"], 1000),
    written!(
        "json",
        Json,
        Lists,
        &["\"knots\":", "\"degree\":", "null", "[]", "{}", "\"weights\":[0]", "\u{202e}"],
        1000
    ),
    written!("written_obj", Obj, Bytes, &["f 1 2 3 4\n", "v 0 0 0\n", "l 1 2\n", "//", "-1", "#", "g x\n"], 1000),
    written!("written_stl", Stl, Bytes, &["\0\0\0\0", "solid", "\u{7f}"], 1000),
    written!("written_ply", Ply, Bytes, &["element face 4\n", "property list uchar int x\n", "end_header\n"], 1000),
    written!(
        "three_mf",
        ThreeMf,
        Bytes,
        &["PK\u{3}\u{4}", "PK\u{1}\u{2}", "3D/3dmodel.model", "<vertex x=\"0\"/>"],
        1000
    ),
    written!(
        "vtu",
        Vtu,
        Bytes,
        &["<DataArray ", "</DataArray>", "Name=\"connectivity\"", "offset", "-1", "79", "nan"],
        3000
    ),
    written!(
        "mfem",
        Mfem,
        Bytes,
        &["dimension\n", "elements\n", "knotvectors\n", "patches\n", "-1", "NURBS3", "0"],
        3000
    ),
    written!(
        "gismo",
        Gismo,
        Bytes,
        &["<KnotVector degree=\"2\">", "<coefs", "<weights>", "-1", "</Geometry>", "nan"],
        3000
    ),
];

/// The files kept for a target.
fn kept(target: &str) -> Vec<Vec<u8>> {
    let folder = format!("{}/../../fuzz/regressions/{target}", env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(&folder).expect("the regressions are there");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("a file").path()).collect();
    paths.sort();
    paths.iter().map(|path| std::fs::read(path).expect("a file")).collect()
}

#[test]
fn kept_inputs_do_not_break_the_readers() {
    for Target { name, exercise, .. } in TARGETS {
        let files = kept(name);
        assert!(!files.is_empty(), "{name}");
        files.iter().for_each(|bytes| exercise(bytes));
    }
}

/// The list here is the list there.
#[test]
fn every_target_is_tried() {
    let folder = format!("{}/../../fuzz", env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(format!("{folder}/fuzz_targets")).expect("the targets are there");
    let mut there: Vec<String> =
        entries.map(|entry| entry.expect("a file").file_name().to_string_lossy().replace(".rs", "")).collect();
    there.sort();
    let mut here = TARGETS.map(|target| target.name);
    here.sort_unstable();
    assert_eq!(there, here);
    let manifest = std::fs::read_to_string(format!("{folder}/Cargo.toml")).expect("a file");
    assert!(
        here.iter().all(|name| manifest.contains(&format!("name = \"{name}\"\npath = \"fuzz_targets/{name}.rs\"")))
    );
}

/// Curves, a patch, a solid and a block, small; each format takes those that it holds.
const MODELS: [&str; 5] = [
    r#""arcs": {"type": "arc-spline", "points": [[0, 0], [3, 1], [4, 4]]},
    "round": {"type": "circle", "center": [1, 1], "radius": 2},
    "fair": {"type": "fair-spline", "points": [[0, 0], [1, 2], [3, 3]]},
    "patch": {"type": "cyclide-patch", "corners": [[-40, -30], [40, -30], [-30, 40], [30, 40]],
        "frame": [[8, -1, 4], [-1, 4, 3]]}"#,
    r#""round": {"type": "circle", "center": [1, 1], "radius": 2},
    "fair": {"type": "fair-spline", "points": [[0, 0], [1, 2], [3, 3]]}"#,
    r#""patch": {"type": "cyclide-patch", "corners": [[-40, -30], [40, -30], [-30, 40], [30, 40]],
        "frame": [[8, -1, 4], [-1, 4, 3]]}"#,
    r#""axis": {"type": "polyline", "points": [[0, 0, 0], [9, 0, 0]], "construction": true},
    "rod": {"type": "pipe", "of": "axis", "radius": 1}"#,
    r#""wall": {"type": "cyclide-grid", "whole": {"a": 3, "mu": [0.5, 1]}, "cells": 1}"#,
];

/// Right files of a target: the kept ones, or those of the models in every form.
fn right_files(target: &Target) -> Vec<Vec<u8>> {
    let Some(format) = target.format else { return kept(target.name) };
    let coarse = Some(0.5);
    let all = [
        ExportOptions { tolerance: coarse, ..ExportOptions::default() },
        ExportOptions { step_edges: StepEdges::Rational, tolerance: coarse, ..ExportOptions::default() },
        ExportOptions { dxf_splines: true, glb_edges: true, tolerance: coarse, ..ExportOptions::default() },
        ExportOptions { dxf_version: DxfVersion::R12, tolerance: Some(0.1), ..ExportOptions::default() },
        ExportOptions { vtu_encoding: VtuEncoding::Base64, tolerance: coarse, ..ExportOptions::default() },
    ];
    let mut files: Vec<Vec<u8>> = Vec::new();
    for objects in MODELS {
        let text = format!(r#"{{"cyclide": 1, "objects": {{{objects}}}}}"#);
        let document = Document::parse("model.json", text.as_bytes()).expect("a right document");
        let read = |_: &std::path::Path| Err(std::io::ErrorKind::NotFound.into());
        let mut builder = ModelBuilder::new(&document, "".as_ref(), &read).expect("a right document");
        let built = (0..document.objects.len()).map(|i| builder.build(i, &mut |_| {}).expect("a right object"));
        let items = built.filter(|built| !built.construction).map(|built| built.item);
        let model = cyclide::model::Model { units: document.units, items: items.collect() };
        for file in all.iter().filter_map(|options| export(&model, format, options).ok()) {
            // Small ones: those that hold meshes at the default tolerance are large.
            if file.bytes.len() < 200_000 && !files.contains(&file.bytes) {
                files.push(file.bytes);
            }
        }
    }
    assert!(!files.is_empty(), "{}", target.name);
    files
}

/// Breaks the files of a target until `enough` says so; gives the number of copies.
fn attack(index: usize, seed: u64, enough: impl Fn(usize) -> bool) -> usize {
    let Target { name: target, exercise, form, words, .. } = TARGETS[index];
    let files = right_files(&TARGETS[index]);
    let mut mutator = Mutator::new(seed, words);
    let mut count = 0;
    while !enough(count) {
        let bytes = &files[count % files.len()];
        let copy = mutator.copy(bytes, form);
        let outcome = std::panic::catch_unwind(|| exercise(&copy));
        if let Err(panic) = outcome {
            let path = std::env::temp_dir().join(format!("cyclide-{target}-{seed}-{count}"));
            std::fs::write(&path, &copy).expect("the input is kept");
            eprintln!("{target}, copy {count} of seed {seed} is kept in {}", path.display());
            std::panic::resume_unwind(panic);
        }
        count += 1;
    }
    count
}

#[test]
fn broken_files_are_refused_or_read() {
    for (index, Target { copies, .. }) in TARGETS.into_iter().enumerate() {
        attack(index, 1, |count| count == copies);
    }
}

/// What is not of the form of its format is refused by the first lines of a reader: of most copies more is tried.
#[test]
fn most_broken_files_get_past_the_tokenizers() {
    for target in TARGETS.into_iter().filter(|target| ["step", "glb", "dxf"].contains(&target.name)) {
        let files = right_files(&target);
        let Target { name: target, format: Some(format), form, words, .. } = target else { continue };
        let mut mutator = Mutator::new(7, words);
        let [mut whole, mut past] = [0, 0];
        for count in 0..1000 {
            let copy = mutator.copy(&files[count % files.len()], form);
            match read_back(format, &copy) {
                Ok(_) => whole += 1,
                Err(ReadError::Syntax { place, detail }) => {
                    let first = ["byte", "the JSON chunk", "the text"].iter().any(|first| place.starts_with(first))
                        || detail == "expected a group code";
                    past += usize::from(!first);
                }
                Err(_) => past += 1,
            }
        }
        eprintln!("{target}: of 1000 copies {whole} are read and {past} refused behind the tokenizer");
        assert!(whole + past > 600 && past > 150, "{target}: {whole}, {past}");
    }
}

/// `CYCLIDE_SECONDS=600 CYCLIDE_SEED=2 cargo test -p cyclide-io --test fuzz --release -- --ignored --nocapture`
#[test]
#[ignore = "as long as one likes; CYCLIDE_SECONDS for each target"]
fn broken_files_for_a_long_time() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let (seconds, seed) = (number("CYCLIDE_SECONDS").unwrap_or(60), number("CYCLIDE_SEED").unwrap_or(2));
    for (index, Target { name: target, .. }) in TARGETS.iter().enumerate() {
        let begin = Instant::now();
        let count = attack(index, seed, |_| begin.elapsed().as_secs() >= seconds);
        eprintln!("{target}: {count} copies in {seconds} s");
    }
}

/// Pieces of documents, so that random texts get past the first brace.
fn document_text() -> impl Strategy<Value = String> {
    let word = prop_oneof![
        Just("\"cyclide\":1,"),
        Just("\"objects\":{"),
        Just("\"a\":{"),
        Just("\"type\":"),
        Just("\"arc\","),
        Just("\"circle\","),
        Just("\"biarc\","),
        Just("\"arc-spline\","),
        Just("\"arc-fit\","),
        Just("\"circle-spline\","),
        Just("\"fair-spline\","),
        Just("\"tension\":0.5,"),
        Just("\"tight\":0.2,"),
        Just("\"points\":"),
        Just("[[0,0],[1,0],[1,1]],"),
        Just("[[0,0],[0,0]],"),
        Just("{\"csv\":\"p\"},"),
        Just("\"closed\":true,"),
        Just("\"tolerance\":0.1,"),
        Just("\"order\":3,"),
        Just("\"ends\":{\"start\":[0,1]},"),
        Just("\"through\":[[0,0],[1,0],[2,0]]"),
        Just("\"radius\":1e300,"),
        Just("\"center\":[0,0],"),
        Just("}"),
        Just("]"),
        Just(","),
        Just("\n"),
        Just("null"),
        Just("é"),
        Just("1e308"),
        Just("-0"),
        Just("\""),
        Just("\\"),
    ];
    let frame = prop_oneof![Just(""), Just("{\"cyclide\":1,\"objects\":{\"a\":{\"type\":")];
    (frame, prop::collection::vec(word, 0..24)).prop_map(|(frame, words)| frame.to_owned() + &words.concat())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_do_not_break_the_readers(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        exercise::document(&bytes);
        exercise::points_csv(&bytes);
        exercise::obj(&bytes);
    }

    #[test]
    fn random_faces_do_not_break_the_grid(text in "(v 0 0 0\n|v 1 2 3\n){4,12}(f( -?[0-9]){4}\n|f 1 2 4 3\n|f 3 4 6 5\n){0,8}") {
        exercise::obj(text.as_bytes());
    }

    #[test]
    fn random_words_do_not_break_the_document(text in document_text()) {
        exercise::document(text.as_bytes());
    }

    #[test]
    fn random_tables_do_not_break_the_points(text in "([-0-9.,;\\t xyznaife#\"\\r\\n]|contour|corner|é){0,120}") {
        exercise::points_csv(text.as_bytes());
    }

    #[test]
    fn any_list_of_numbers_is_refused_or_built(
        numbers in prop::collection::vec((any::<f64>(), prop::num::f64::NORMAL, -4i32..5), 0..12),
        closed in any::<bool>(),
        kind in 0..4usize,
    ) {
        let point = |(x, y, z): &(f64, f64, i32)| match z {
            // Whole numbers, so that points repeat and line up; now and then any double at all.
            0 if x.is_finite() => format!("[{x:e},{y:e}]"),
            z => format!("[{},{}]", z, (*z * *z) % 3),
        };
        let points: Vec<String> = numbers.iter().map(point).collect();
        let kind = ["\"circle-spline\"", "\"fair-spline\"", "\"arc-spline\"", "\"arc-fit\",\"tolerance\":0.01"][kind];
        let text = format!(
            "{{\"cyclide\":1,\"objects\":{{\"a\":{{\"type\":{kind},\"closed\":{closed},\"points\":[{}]}}}}}}",
            points.join(",")
        );
        exercise::document(text.as_bytes());
    }
}
