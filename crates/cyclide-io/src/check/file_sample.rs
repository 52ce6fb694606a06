//! What a table says beside a point of a curve, as read from a file and as the model has it.

use cyclide::{
    CurveJet,
    curve::{CurvePlace, ParamCurve},
};

/// The further columns of a point of a curve in a table.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, formats::{export, read_back}};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let content = read_back(Format::Csv, &export(&model, Format::Csv, &ExportOptions::default())?.bytes)?;
/// assert!(content.samples[0].iter().all(|sample| sample.curvature == Some(0.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FileSample {
    /// The global parameter.
    pub t: f64,
    /// The unit tangent, if it exists.
    pub tangent: Option<[f64; 3]>,
    /// The curvature, if it exists.
    pub curvature: Option<f64>,
}

impl FileSample {
    /// What there is to say of a place with this parameter.
    pub(crate) fn new(t: f64, jet: &CurveJet) -> Self {
        let curvature = jet.curvature().filter(|k| k.is_finite());
        Self { t, tangent: jet.tangent().map(cyclide::Vec3::to_array), curvature }
    }

    /// At a joint the tangent is that of the piece that starts there.
    pub(crate) fn at(curve: &dyn ParamCurve, place: CurvePlace) -> Self {
        let n = curve.piece_count();
        let place = if place.s >= 1.0 && place.piece + 1 < n { CurvePlace::after(place.piece) } else { place };
        Self::new((place.piece as f64 + place.s) / n as f64, &curve.piece_jet(place.piece, place.s))
    }

    /// The numbers with their columns.
    pub(crate) fn columns(&self) -> [(&'static str, Option<f64>); 5] {
        let tangent = |i: usize| self.tangent.map(|tangent| tangent[i]);
        let parts =
            [("x of the tangent", tangent(0)), ("y of the tangent", tangent(1)), ("z of the tangent", tangent(2))];
        [("parameter", Some(self.t)), parts[0], parts[1], parts[2], ("curvature", self.curvature)]
    }
}
