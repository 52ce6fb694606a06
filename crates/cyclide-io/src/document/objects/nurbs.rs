//! Rational B-splines of documents.

use cyclide::{CurveCusp, CurveObject, NurbsCurve, ParamCurve, Point3, ShortNumber, Warning, cusps};

use super::Builder;
use super::refuse::Blame;
use crate::document::construct::ContourFacts;
use crate::document::coordinates::Coordinates;
use crate::document::locate::Step;
use crate::document::spec::NurbsSpec;
use crate::error::Result;

impl Builder<'_> {
    /// The curve, its ends clamped.
    pub(in crate::document) fn nurbs(&mut self, spec: &NurbsSpec) -> Result<CurveObject> {
        let points: Vec<Point3> = spec.control_points.iter().copied().map(Coordinates::point).collect();
        let weights = spec.weights.clone().unwrap_or_else(|| vec![1.0; points.len()]);
        let curve = NurbsCurve::with_even_weights(spec.degree as usize, spec.knots.clone(), points, weights)
            .map_err(|e| self.refused(&e, None))?;
        if !are_clamped(spec) {
            let (from, to) = curve.domain();
            let message = format!(
                "the knots are not clamped: the curve is the part from {} to {}, clamped by exact knot insertion ({} control points)",
                ShortNumber(from),
                ShortNumber(to),
                curve.control_points().len()
            );
            let place = self.place_of([Step::from("knots")]);
            self.remark("knots-clamped", None, None, place, message);
        }
        Ok(curve.into())
    }

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
            let cusp = Warning::CuspInside { count: found.len(), t, at: point.to_array(), angle };
            self.warn_at(field, contour, cusp);
        }
    }
}

/// True if the knots at both ends are there once more than the degree: such a curve is kept as it is.
fn are_clamped(spec: &NurbsSpec) -> bool {
    let (knots, degree) = (&spec.knots, spec.degree as usize);
    let is_one = |run: &[f64]| run.iter().all(|knot| *knot <= run[0]);
    is_one(&knots[..=degree]) && is_one(&knots[knots.len() - degree - 1..])
}

/// What helps where the count of knots does not fit.
pub(in crate::document) fn knots_words(error: &cyclide::Error) -> Option<String> {
    let is_count = matches!(error, cyclide::Error::CountDiffers { what: cyclide::ErrorItem::Knot, .. });
    is_count.then(|| {
        format!(
            "{error}: as many as control points, degree and 1 together (where programs leave out the first and the last knot, repeat them)"
        )
    })
}

/// Which value of a `nurbs` an error of the kernel is about.
pub(in crate::document) fn blame_nurbs(error: &cyclide::Error) -> Blame {
    use cyclide::{Error as E, ErrorItem as I};
    match *error {
        E::ParameterOutOfRange { name: I::Degree, .. } => Blame::Field("degree"),
        E::WeightNotPositive { index, .. } | E::WeightsUneven { second: index, .. } => Blame::Entry("weights", index),
        E::CountDiffers { what: I::Weight, .. } => Blame::Field("weights"),
        E::KnotsDecrease { index, .. } | E::KnotMultiplicity { index, .. } | E::NotFinite { what: I::Knot, index } => {
            Blame::Entry("knots", index)
        }
        E::CountDiffers { .. } | E::EmptyInterval { .. } | E::NotASpline { .. } => Blame::Field("knots"),
        E::NotFinite { what: I::ControlPoint, index } => Blame::Entry("control_points", index),
        _ => Blame::Field("control_points"),
    }
}
