//! Runs files of reference cases (`cyclide-reference/1`) through the public API of `cyclide`.
//!
//! A file holds cases `{id, construct, input, expect, rtol, scale?}`. Each construct has a handler that computes from
//! `input` and compares every field of `expect`; a field no handler compared is a failure, and so is an error that
//! was expected and did not occur, or occurred and was not expected. Handlers see the input numbers only as
//! numbers: nothing is recognized by its value.

mod arc;
mod arc_fit;
mod arc_spline;
mod bilinear;
mod blend;
mod canal;
mod case;
mod check;
mod circular;
mod closing;
mod deviation;
mod fair;
mod interpolation;
mod moebius_spline;
mod motion;
mod patch;
mod polyhedron;
mod qb;
mod report;
mod revolution;
mod round;
mod torus;
mod triangle;
mod volume;

pub use case::{Case, Fault};
pub use check::Check;
pub use report::{Failure, Report, Tally};

use serde_json::Value;

/// What a handler does with a case: computes, and compares field by field.
type Handler = fn(&Case, &mut Check) -> Result<(), Fault>;

/// The constructs about curves, whether or not the kernel has them yet: `--curves` of the command.
pub const CURVE_CONSTRUCTS: [&str; 54] = [
    "arc-three-points",
    "arc-point-tangent",
    "arc-weights",
    "arc-weights-4d",
    "arc-complex",
    "arc-angle-parameter",
    "arc-split",
    "arc-reverse",
    "arc-bbox",
    "arc-closest-point",
    "arc-subdivide",
    "arc-nurbs",
    "arc-bulge",
    "circle-nurbs",
    "biarc",
    "arc-spline",
    "fit-arc-spline",
    "circle-through-points",
    "sphere-through-points",
    "blend-angle",
    "circle-blend-curve",
    "rational-circle-blend-curve",
    "circle-blend-derivatives",
    "rational-circle-blend-bezier",
    "circle-blend-hermite",
    "fair-spline",
    "fair-spline-bezier",
    "fair-spline-residual",
    "blend-segment-ends",
    "fair-spline-relaxation",
    "arc-fit-interval",
    "arc-certify",
    "g1-arc-interval",
    "g1-arc-spline",
    "torus-circle",
    "type-switch",
    "rp1-biarc",
    "torus-quartic-biarc",
    "two-type-biarc",
    "torus-spline",
    "qb-evaluate",
    "qb-to-rational-bezier",
    "qb-elevate",
    "qb-subdivide",
    "qb-moebius",
    "pole-report",
    "interpolate-points",
    "interpolate-hermite",
    "hermite-three-points-two-tangents",
    "invariant-span",
    "circle-tangents",
    "circle-tangent-spline",
    "g1-circle-spline",
    "spline-nurbs",
];

/// The constructs about canal surfaces, surfaces of revolution, circular surfaces, offsets of polyhedra, patches over triangles, patches and nets
/// of Dupin cyclides: `--surfaces` of the command.
pub const SURFACE_CONSTRUCTS: [&str; 40] = [
    "revolution",
    "revolution-angle",
    "neck-blend",
    "ellipse-bridge",
    "sphere-polygon",
    "polyhedron-offset",
    "qb-arc",
    "qb-arc-three-points",
    "cyclide-patch",
    "cyclide-offset",
    "cyclide-locate",
    "cyclide-implicit",
    "cyclide-moebius",
    "qb-patch",
    "qb-patch-arcs",
    "qb-patch-implicit",
    "qb-patch-locate",
    "qb-patch-inversion",
    "qb-block",
    "moebius-three-points",
    "surface-intersect",
    "circle-surface-intersect",
    "circle-angle",
    "point-distance",
    "circular-net-frames",
    "ring-closing",
    "strip-closing",
    "closed-circular-net",
    "miquel-point",
    "spherical-cube",
    "cyclide-volume",
    "sphere-blend",
    "blend-patch",
    "torus-eval",
    "torus-inverse",
    "perp-cylinder-sphere",
    "canal-patch",
    "contact-ball",
    "constant-radius-curve",
    "quadric-pair-kind",
];

/// The handler of a construct; `None` if the product does not have it (yet).
fn handler(construct: &str) -> Option<Handler> {
    [
        arc::handler,
        arc_spline::handler,
        blend::handler,
        fair::handler,
        arc_fit::handler,
        patch::handler,
        bilinear::handler,
        round::handler,
        revolution::handler,
        circular::handler,
        closing::handler,
        polyhedron::handler,
        triangle::handler,
        torus::handler,
        canal::handler,
        motion::handler,
        qb::handler,
        interpolation::handler,
        moebius_spline::handler,
        volume::handler,
    ]
    .iter()
    .find_map(|topic| topic(construct))
}

/// Fields of `expect` that are information, not to be compared (`docs/math/reference-cases.md#format`).
const INFORMATION: [&str; 4] = ["straight", "true_segments", "true_arcs", "move_open_max"];

/// Runs the cases of one file and adds the outcome to `report`. With `only`, cases of other constructs are counted as
/// skipped, those without a handler named as unknown.
///
/// # Errors
/// A sentence if the text is not a reference file.
pub fn run(text: &str, only: Option<&[String]>, report: &mut Report) -> Result<(), String> {
    let file: Value = serde_json::from_str(text).map_err(|e| format!("not JSON: {e}"))?;
    if file["format"] != "cyclide-reference/1" {
        return Err(format!("format is {}, not \"cyclide-reference/1\"", file["format"]));
    }
    let cases = file["cases"].as_array().ok_or("no list `cases`")?;
    for (index, value) in cases.iter().enumerate() {
        let case = Case::new(value).map_err(|e| format!("case {index}: {e}"))?;
        if only.is_some_and(|names| names.iter().all(|n| n != case.construct())) {
            report.skip(case.construct(), handler(case.construct()).is_some());
            continue;
        }
        match handler(case.construct()) {
            Some(handler) => report.add(&case, &judge(&case, handler)),
            None => report.add_unknown(case.construct()),
        }
    }
    Ok(())
}

/// Runs one case; the check holds what was compared and what failed.
fn judge<'a>(case: &Case<'a>, handler: Handler) -> Check<'a> {
    let mut check = Check::new(case);
    let outcome = handler(case, &mut check);
    match (case.expected_error(), outcome) {
        (None, Ok(())) => check.finish(&INFORMATION),
        (Some(want), Err(Fault::Refused(error))) => {
            let words = [patch::reason(case.construct(), &error), interpolation::reason(case.construct(), &error)];
            match words {
                words if words.contains(&want) => check.agree("error"),
                [reason, _] => check.fail("error", format!("refused as {reason} ({error}), expected {want}")),
            }
            if let Some(index) = interpolation::index(case.construct(), &error) {
                check.exact("index", index);
            }
        }
        (Some(want), Ok(())) => check.fail("error", format!("accepted, expected the error {want}")),
        (None, Err(Fault::Refused(error))) => check.fail("error", format!("refused as {}: {error}", error.reason())),
        (_, Err(Fault::Malformed(what))) => check.fail("input", what),
    }
    check
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(cases: &str) -> Report {
        let mut report = Report::default();
        run(&format!(r#"{{"format": "cyclide-reference/1", "cases": [{cases}]}}"#), None, &mut report).unwrap();
        report
    }

    fn three_points(expect: &str) -> Report {
        report(&format!(
            r#"{{"id": "x", "construct": "arc-three-points", "rtol": 1e-12, "scale": 1,
                "input": {{"a0": [1, 0, 0], "b": [0.6, 0.8, 0], "a1": [0, 1, 0]}}, "expect": {expect}}}"#
        ))
    }

    #[test]
    fn compares_every_field() {
        let good = three_points(r#"{"radius": 1, "straight": false, "samples": [[0.5, 0.6, 0.8, 0]]}"#);
        assert_eq!((good.passed(), good.failed()), (1, 0));
        assert!(good.is_success());
    }

    #[test]
    fn a_wrong_value_fails() {
        for expect in [
            r#"{"radius": 1.00000001}"#,
            r#"{"normal": [0, 0, -1]}"#,
            r#"{"samples": [[0.5, 0.6, 0.8, 1e-9]]}"#,
            r#"{"samples": [[0.5, 0.6, 0.8]]}"#,
            r#"{"angle": "NaN"}"#,
        ] {
            let report = three_points(expect);
            assert_eq!((report.passed(), report.failed()), (0, 1), "{expect}");
            assert!(!report.is_success());
        }
    }

    #[test]
    fn an_uncompared_field_fails() {
        assert_eq!(three_points(r#"{"radius": 1, "colour": 3}"#).failed(), 1);
        assert_eq!(three_points(r#"{"straight": false}"#).failed(), 1);
        assert_eq!(three_points("{}").failed(), 1);
    }

    #[test]
    fn errors_are_compared_both_ways() {
        assert_eq!(three_points(r#"{"error": "coincident-points"}"#).failed(), 1);
        let refused = |expect: &str| {
            report(&format!(
                r#"{{"id": "x", "construct": "arc-three-points", "rtol": 1e-12, "scale": 1,
                    "input": {{"a0": [1, 0, 0], "b": [1, 0, 0], "a1": [0, 1, 0]}}, "expect": {expect}}}"#
            ))
        };
        assert_eq!(refused(r#"{"error": "coincident-points"}"#).passed(), 1);
        assert_eq!(refused(r#"{"error": "point-at-infinity"}"#).failed(), 1);
        assert_eq!(refused(r#"{"radius": 1}"#).failed(), 1);
    }

    #[test]
    fn an_unknown_construct_is_no_success() {
        let report = report(r#"{"id": "x", "construct": "hypercube", "rtol": 0, "input": {}, "expect": {}}"#);
        assert_eq!((report.passed(), report.failed()), (0, 0));
        assert!(!report.is_success());
        assert!(report.to_string().contains("hypercube"));
    }

    #[test]
    fn malformed_input_is_a_failure_not_a_panic() {
        let report = report(
            r#"{"id": "x", "construct": "biarc", "rtol": 1e-9, "scale": 1, "input": {"p0": [1]}, "expect": {"J": [1]}}"#,
        );
        assert_eq!(report.failed(), 1);
    }
}
