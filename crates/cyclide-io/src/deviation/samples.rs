//! What tables say beside the points of curves, against the model at the places that the points stand for.

use crate::exported::WrittenCurve;
use crate::file_content::{FileSample, ReadError};
use crate::job::contours;
use cyclide::Model;

/// Holds parameter, tangent and curvature of every point against the model's curve. Numbers read back are the doubles that
/// were written, and a curve is evaluated to the same ones again: they are equal to the last digit.
///
/// # Errors
/// [`ReadError::PieceCount`], [`ReadError::Sample`].
pub(crate) fn check_samples(
    model: &Model,
    read: &[Vec<FileSample>],
    written: &[WrittenCurve],
) -> Result<(), ReadError> {
    for (curve, ((contour, samples), WrittenCurve { parts, .. })) in contours(model).zip(read).zip(written).enumerate()
    {
        let places = std::iter::once(parts.start).chain(parts.spans.iter().map(|span| span.end));
        let (found, expected) = (samples.len(), parts.spans.len() + 1);
        if found != expected {
            return Err(ReadError::PieceCount { curve, found: found.saturating_sub(1), expected: expected - 1 });
        }
        for (point, (sample, place)) in samples.iter().zip(places).enumerate() {
            let expected = FileSample::at(contour.curve.as_curve(), place).columns();
            let differs = |(found, expected): &((_, Option<f64>), (_, Option<f64>))| !same(found.1, expected.1);
            if let Some(((what, found), (_, expected))) = sample.columns().into_iter().zip(expected).find(differs) {
                return Err(ReadError::Sample { curve, point, what, found, expected });
            }
        }
    }
    Ok(())
}

/// True if both are missing, or the same number but for the sign of zero.
pub(super) fn same(a: Option<f64>, b: Option<f64>) -> bool {
    a.map(|v| (v + 0.0).to_bits()) == b.map(|v| (v + 0.0).to_bits())
}
