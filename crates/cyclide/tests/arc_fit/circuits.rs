//! The set of closed curves at every effort: no turning that the data do not have, few pieces, fewer as the tolerance
//! grows.

use super::*;
use cyclide::{
    curve::{Arc, joints},
    warning::FitWarning,
};
use cyclide_testkit::circuits::{Circuit, circuits};

/// Falling: the counts must rise along the list.
const TOLERANCES: [f64; 3] = [0.5, 0.05, 0.01];

/// Sweeps and angles at the joints: measured here, not read off the certificate.
fn turning(fit: &ArcFit) -> f64 {
    fit.path().arcs().iter().map(Arc::angle).sum::<f64>() + joints(fit.path()).iter().map(|j| j.angle).sum::<f64>()
}

/// Counts of one curve at all tolerances, checked on the way.
fn counts(circuit: &Circuit, effort: Effort) -> Vec<usize> {
    let at = |tolerance: &f64| {
        let Circuit { name, points } = circuit;
        let options = ArcFitOptions { effort, ..closed(*tolerance) };
        let fit = ArcFit::new(points, &options);
        assert!(fit.is_ok(), "{name} at {tolerance}: {fit:?}");
        let Ok(fit) = fit else { return 0 };
        let certificate = fit.certificate();
        assert!(certificate.deviation <= *tolerance && certificate.monotone, "{name} at {tolerance}, {effort:?}");
        let turned = turning(&fit);
        // Two sums of up to a thousand angles.
        assert!((turned - certificate.turning).abs() < 1e-9 * turned, "{name}: {turned} {}", certificate.turning);
        assert!(turned <= certificate.turning_limit, "{name} at {tolerance}, {effort:?}: {certificate:?}");
        for warning in fit.warnings() {
            if let Warning::Fit(FitWarning::TightArc { radius, data, .. }) = warning {
                // Noise above the tolerance: arcs that follow it may be tight, but none hides a corner. Turns of up to 30
                // degrees between straight sides are rounded: by 28 tolerances touching both sides, by twice that in the
                // whole tube.
                let rounds = name.starts_with("polygon") && *radius > 28.0 * tolerance;
                assert!(rounds || 8.0 * radius > *data, "{name} at {tolerance}, {effort:?}: {warning}");
            }
        }
        pieces(&fit)
    };
    let counts: Vec<usize> = TOLERANCES.iter().map(at).collect();
    // A turn between straight sides costs a round more or less as the search meets the seam or a corner; pieces are made one
    // greedily, which costs one in forty.
    let more = |count: usize| usize::from(circuit.name.starts_with("polygon")).max(count / 40);
    let falls = counts.windows(2).all(|pair| pair[0] <= pair[1] + more(pair[1]));
    assert!(falls, "{}, {effort:?}: {counts:?} at {TOLERANCES:?}", circuit.name);
    counts
}

#[test]
fn no_corner_is_hidden_and_fast_is_nearly_as_good_as_default() {
    let set = circuits();
    assert!(set.len() >= 30);
    std::thread::scope(|scope| {
        for part in set.chunks(set.len().div_ceil(4)) {
            scope.spawn(move || {
                for (k, circuit) in part.iter().enumerate() {
                    let fast = counts(circuit, Effort::Fast);
                    // The longer search on every fourth one: it takes most of the time.
                    if k % 4 != 0 {
                        continue;
                    }
                    let default = counts(circuit, Effort::Default);
                    for (f, d) in fast.iter().zip(&default) {
                        assert!(*f as f64 <= 1.15 * *d as f64, "{}: {fast:?} {default:?}", circuit.name);
                    }
                }
            });
        }
    });
}
