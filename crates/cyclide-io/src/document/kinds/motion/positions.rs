//! What is said of the curve through the positions of poses: it has no corners to be marked, no corner angle, and no tolerance of its own.

use cyclide::{
    Warning,
    warning::{CurveWarning, WaverRemedy},
};

const CORNERS: &str = "if the body is to turn sharply there, `\"positions\": \"polyline\"` has a corner at each pose, and the kind `linear` a `blend_radius` for them";

/// The sentence of a warning of the curve, with the advice of a motion.
pub(super) fn words(warning: &Warning, said: &str) -> String {
    let Warning::Curve(warning) = warning else { return said.to_owned() };
    let advice = match warning {
        CurveWarning::SharpTurn { .. } | CurveWarning::Relaxed { .. } | CurveWarning::CornerNotMarked { .. } => CORNERS,
        CurveWarning::Wavers { remedy: WaverRemedy::FairSpline, .. } => {
            "`\"positions\": \"fair\"` has fewer wiggles, a `tolerance` instead of `positions` fewer still"
        }
        CurveWarning::Wavers { remedy: WaverRemedy::Points, .. } | CurveWarning::DataWaver { .. } => {
            "a `tolerance` instead of `positions` smooths measured poses"
        }
        _ => return said.to_owned(),
    };
    // The advice of curves is the last part of their sentences.
    let found = said.rsplit_once("; ").map_or(said, |(found, _)| found);
    format!("{found}; {advice}")
}
