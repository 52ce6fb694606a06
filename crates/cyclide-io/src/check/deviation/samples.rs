//! What tables say beside the points of curves, against the model at the places that the points stand for.

use crate::check::file_sample::FileSample;
use crate::check::read_error::ReadError;
use crate::export::exported::WrittenCurve;
use crate::export::parts::{Contour, contours};
use cyclide::{curve::Correspondence, model::Model};

/// Holds parameter, tangent and curvature of every point against the model's curve, row by row as they are read: a list of
/// them would be a third of the file. Numbers read back are the doubles that were written, and a curve is evaluated to
/// the same ones again: they are equal to the last digit.
pub(crate) struct SampleCheck<'a> {
    curves: Vec<(Contour<'a>, &'a Correspondence)>,
    /// Points read of each curve.
    read: Vec<usize>,
}

impl<'a> SampleCheck<'a> {
    pub(crate) fn new(model: &'a Model, written: &'a [WrittenCurve]) -> Self {
        let curves: Vec<_> = contours(model).zip(written.iter().map(|curve| &curve.parts)).collect();
        Self { read: vec![0; curves.len()], curves }
    }

    /// Takes the next point of a curve. Curves that the model does not have are counted elsewhere.
    ///
    /// # Errors
    /// [`ReadError::PieceCount`], [`ReadError::Sample`].
    pub(crate) fn row(&mut self, curve: usize, sample: &FileSample) -> Result<(), ReadError> {
        let (Some((contour, parts)), Some(point)) = (self.curves.get(curve), self.read.get_mut(curve)) else {
            return Ok(());
        };
        let place = match *point {
            0 => Some(parts.start),
            next => parts.spans.get(next - 1).map(|span| span.end),
        };
        let Some(place) = place else {
            return Err(ReadError::PieceCount { curve, found: *point, expected: parts.spans.len() });
        };
        let expected = FileSample::at(contour.curve.as_curve(), place).columns();
        let differs = |(found, expected): &((_, Option<f64>), (_, Option<f64>))| !same(found.1, expected.1);
        if let Some(((what, found), (_, expected))) = sample.columns().into_iter().zip(expected).find(differs) {
            return Err(ReadError::Sample { curve, point: *point, what, found, expected });
        }
        *point += 1;
        Ok(())
    }

    /// Refuses curves with fewer points than were written.
    ///
    /// # Errors
    /// [`ReadError::PieceCount`].
    pub(crate) fn finish(self) -> Result<(), ReadError> {
        for (curve, ((_, parts), read)) in self.curves.iter().zip(self.read).enumerate() {
            let expected = parts.spans.len();
            if read != expected + 1 {
                return Err(ReadError::PieceCount { curve, found: read.saturating_sub(1), expected });
            }
        }
        Ok(())
    }
}

/// True if both are missing, or the same number but for the sign of zero.
pub(super) fn same(a: Option<f64>, b: Option<f64>) -> bool {
    a.map(|v| (v + 0.0).to_bits()) == b.map(|v| (v + 0.0).to_bits())
}
