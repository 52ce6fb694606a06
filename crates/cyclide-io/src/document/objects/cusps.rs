//! Curves that come to a stand by their data.

use cyclide::{
    Warning,
    curve::{CurveCusp, ParamCurve, cusps},
    model::CurveObject,
    warning::CurveWarning,
};

use crate::document::objects::Builder;
use crate::document::objects::contours::ContourFacts;

impl Builder<'_> {
    /// The same of several curves.
    pub(in crate::document) fn warn_of_cusps_in(&mut self, field: &str, made: &[(CurveObject, ContourFacts)]) {
        for (contour, (curve, _)) in made.iter().enumerate() {
            self.warn_of_cusps(field, (made.len() > 1).then_some(contour), curve.as_curve());
        }
    }

    /// Warns where the velocity of a curve vanishes and its direction jumps.
    pub(in crate::document) fn warn_of_cusps(&mut self, field: &str, contour: Option<usize>, curve: &dyn ParamCurve) {
        let found = cusps(curve);
        if let Some(&CurveCusp { t, point, angle, .. }) = found.first() {
            let cusp = Warning::Curve(CurveWarning::CuspInside { count: found.len(), t, at: point.to_array(), angle });
            self.warn_at(field, contour, cusp);
        }
    }
}
