//! What the user can ask of a fair fit.

use crate::error::{ErrorItem, NumberError, Result, check_tolerance};
use std::f64::consts::PI;

/// Largest weight of the data's middle: beyond it the fit is one of least squares.
const MAX_CENTRE: f64 = 1e6;
/// Largest growth of the variation that removal may cost: beyond it only the tolerance counts.
const MAX_BUDGET: f64 = 1e3;
/// Most places on an edge that the tolerance binds.
const MAX_EDGE_POINTS: usize = 100;

/// How large the errors of measured points are.
///
/// ```
/// use cyclide::construct::{FairFitOptions, Noise};
/// assert_eq!(FairFitOptions::by_noise(Noise::Known(1.5)).noise, Some(Noise::Known(1.5)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum Noise {
    /// As the points themselves say.
    #[default]
    Estimated,
    /// The standard deviation across the curve, in the unit of the points; positive.
    Known(f64),
}

/// What happens to outliers, which are points that do not agree with the others.
///
/// ```
/// assert_eq!(cyclide::construct::Outliers::default(), cyclide::construct::Outliers::Keep);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Outliers {
    /// They are named and count like all others; where smoothing follows the noise, their influence is bounded.
    #[default]
    Keep,
    /// They are named and left out.
    Drop,
}

/// Tolerance of the heights, apart from that across.
///
/// ```
/// use cyclide::construct::{FairFitOptions, Heights};
/// let options = FairFitOptions { heights: Heights::Within(0.3), ..FairFitOptions::new(0.1) };
/// assert_eq!(options.heights, Heights::Within(0.3));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum Heights {
    /// One for all directions.
    #[default]
    AsAll,
    /// The z of the curve is within this of the z of each point, which must be more than the tolerance.
    Within(f64),
    /// The strength in z follows the noise in z. Needs a strength that follows the noise.
    ByNoise,
}

/// Options of [`FairFit::new`](super::FairFit::new).
///
/// ```
/// use cyclide::construct::FairFitOptions;
/// let options = FairFitOptions { fix_ends: true, ..FairFitOptions::new(0.05) };
/// assert!(options.tolerance == 0.05 && !options.closed);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FairFitOptions {
    /// The last point joins the first.
    pub closed: bool,
    /// Largest distance of a point from the curve, in the unit of the points; positive. Infinite: none, with
    /// [`noise`](Self::noise).
    pub tolerance: f64,
    /// The strength follows the noise of the points: the root mean square of the distances is its standard deviation, less
    /// what the curve takes of it by chance. `None`: the tolerance alone decides. With it `centre` has no effect.
    pub noise: Option<Noise>,
    /// What becomes of outliers.
    pub outliers: Outliers,
    /// Tolerance in z.
    pub heights: Heights,
    /// Turns above this angle (radians, in `(0, pi]`) that stand out from their neighbors, and that a line eight
    /// tolerances long on either side confirms, stay corners. `None`: only the [`corners`](Self::corners) given.
    pub corner_angle: Option<f64>,
    /// Indices of points that are corners in any case. The curve passes through corners exactly.
    pub corners: Vec<usize>,
    /// An open curve starts and ends exactly at the first and last point; else they are bound by the tolerance only,
    /// as all others. Without effect on a closed curve, which a warning says.
    pub fix_ends: bool,
    /// How much the curve keeps to the middle of the data, 0 to 1e6. 0: the fairest curve in the tolerance, which leans
    /// on its bounds; 1 keeps as close to noisy points as their noise allows; 10 and more approach least squares.
    pub centre: f64,
    /// Fits spent on taking nodes out; 0 keeps those of the first fit, in about a fifth of the time.
    pub max_fits: usize,
    /// Nodes of a smooth piece at which removal stops, at least 2. A warning says where it ends elsewhere, and why.
    pub nodes: Option<usize>,
    /// How much of its fairness the curve may lose for fewer nodes, 0 to 1000: 0.1 is a tenth of the variation.
    pub budget: f64,
    /// Places between two points, 0 to 100, equally spaced on the straight edge, that the tolerance binds as it binds
    /// the points. 0: the points are samples of a smooth curve. More: the polyline itself is meant.
    pub edge_points: usize,
}

impl FairFitOptions {
    /// Open with free ends, no corners, the fairest curve, sixteen fits.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        Self {
            closed: false,
            tolerance,
            noise: None,
            outliers: Outliers::Keep,
            heights: Heights::AsAll,
            corner_angle: None,
            corners: Vec::new(),
            fix_ends: false,
            centre: 0.0,
            max_fits: 16,
            nodes: None,
            budget: 0.1,
            edge_points: 0,
        }
    }

    /// Open with free ends, no corners, as strong as the noise of the points asks.
    #[must_use]
    pub fn by_noise(noise: Noise) -> Self {
        Self { noise: Some(noise), ..Self::new(f64::INFINITY) }
    }

    /// # Errors
    /// `tolerance-not-positive`, `not-finite`, `parameter-out-of-range`.
    pub(super) fn check(&self, points: usize) -> Result<()> {
        if !(self.noise.is_some() && self.tolerance == f64::INFINITY) {
            check_tolerance(self.tolerance)?;
        }
        if let Some(Noise::Known(noise)) = self.noise {
            check_tolerance(noise)?;
        }
        let within = |name, value: f64, [min, max]: [f64; 2]| {
            if value >= min && value <= max {
                Ok(())
            } else {
                Err(NumberError::ParameterOutOfRange { name, value, min, max }.into())
            }
        };
        // An angle of 0 would make every point a corner.
        if let Some(angle) = self.corner_angle {
            within(ErrorItem::CornerAngle, angle, [f64::MIN_POSITIVE, PI])?;
        }
        within(ErrorItem::CentreWeight, self.centre, [0.0, MAX_CENTRE])?;
        within(ErrorItem::Budget, self.budget, [0.0, MAX_BUDGET])?;
        within(ErrorItem::EdgePoints, self.edge_points as f64, [0.0, MAX_EDGE_POINTS as f64])?;
        if let Some(nodes) = self.nodes {
            within(ErrorItem::Nodes, nodes as f64, [2.0, f64::MAX])?;
        }
        match self.corners.iter().find(|c| **c >= points) {
            Some(corner) => within(ErrorItem::Corner, *corner as f64, [0.0, points.saturating_sub(1) as f64]),
            None => Ok(()),
        }
    }
}
