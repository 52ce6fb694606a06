//! Bytes that once broke the readers, and random ones, on the stable toolchain.

#![allow(clippy::expect_used, reason = "what is not there fails the test")]

#[path = "../../../fuzz/exercise.rs"]
mod exercise;

use proptest::prelude::*;

/// Runs every file kept for a target; gives their number.
fn replay(target: &str, exercise: fn(&[u8])) -> usize {
    let folder = format!("{}/../../fuzz/regressions/{target}", env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(&folder).expect("the regressions are there");
    let files = entries.map(|entry| entry.expect("a file").path());
    files.map(|path| exercise(&std::fs::read(&path).expect("a file"))).count()
}

#[test]
fn kept_inputs_do_not_break_the_readers() {
    assert!(replay("document", exercise::document) > 0);
    assert!(replay("points_csv", exercise::points_csv) > 0);
    assert!(replay("obj", exercise::obj) > 0);
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
