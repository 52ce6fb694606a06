//! What samples of all kinds have in common: where they lie, and the fields of their rows.

use crate::text::number::push_plain;

/// The spacing of a given number of samples on a curve.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let rows = cyclide_io::report::sample(&built[0], 5, cyclide_io::report::Spacing::Length);
/// assert_eq!(rows.lines().count(), 6);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Spacing {
    /// Equal steps of the parameter.
    #[default]
    Parameter,
    /// Equal steps of arc length.
    Length,
}

/// The locations of the samples of a curve, which include both ends of each contour.
///
/// ```
/// assert!(matches!(cyclide_io::report::SamplePlaces::Step(0.5), cyclide_io::report::SamplePlaces::Step(step) if step > 0.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SamplePlaces {
    /// A number on each contour, at least 2.
    Count {
        /// How many.
        count: usize,
        /// Their spacing.
        spacing: Spacing,
    },
    /// At the stations 0, d, 2 d, … and at the end; the last step is shorter unless the length is a multiple of d.
    Step(f64),
}

impl SamplePlaces {
    /// Samples of a contour of this length.
    #[must_use]
    pub fn count_on(self, length: f64) -> f64 {
        match self {
            Self::Count { count, .. } => count as f64,
            Self::Step(step) => (length / step).ceil() + 1.0,
        }
    }
}

/// A comma and the value, if there is one.
pub(super) fn push_field(out: &mut String, value: Option<f64>) {
    out.push(',');
    if let Some(value) = value {
        push_plain(out, value);
    }
}

/// Fractions 0, 1/(count-1), … 1.
pub(super) fn fractions(count: usize) -> impl Iterator<Item = f64> + Clone {
    (0..count).map(move |i| i as f64 / count.saturating_sub(1).max(1) as f64)
}
