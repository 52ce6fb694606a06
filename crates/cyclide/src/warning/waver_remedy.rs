//! What helps against a curve that wiggles.

/// What helps against a curve that wiggles, by its kind.
///
/// ```
/// use cyclide::{Warning, warning::{CurveWarning, WaverRemedy}};
/// let warning = Warning::Curve(CurveWarning::Wavers { curve: 9, data: 2, explained: 2, remedy: WaverRemedy::Tolerance });
/// assert!(warning.to_string().contains("tolerance"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WaverRemedy {
    /// It interpolates by a local rule: a fairer kind of curve.
    FairSpline,
    /// It is the fairest through its points: other points.
    Points,
    /// It is a fit: more freedom.
    Tolerance,
    /// It is smoothed by the noise of the points.
    Noise,
    /// It came from elsewhere.
    Source,
}

impl WaverRemedy {
    /// The advice in words.
    pub(super) fn advice(self) -> &'static str {
        match self {
            Self::FairSpline => "a fair spline, or a fit within a tolerance, has fewer wiggles",
            Self::Points => {
                "add points there, space them more evenly, or mark intended corners (a corner angle); for measured points use a fit within a tolerance"
            }
            Self::Tolerance => "a larger tolerance gives a smoother curve",
            Self::Noise => {
                "a larger standard deviation of the noise, or a tolerance in its place, gives a smoother curve"
            }
            Self::Source => "smooth it in its source, or sample it and fit the samples within a tolerance",
        }
    }
}
