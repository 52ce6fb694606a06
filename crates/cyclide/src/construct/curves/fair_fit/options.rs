//! What the user can ask of a fair fit.

use crate::error::{Error, ErrorItem, Result, check_tolerance};
use std::f64::consts::PI;

/// Largest weight of the data's middle: beyond it the fit is one of least squares.
const MAX_CENTRE: f64 = 1e6;
/// Largest growth of the variation that removal may cost: beyond it only the tolerance counts.
const MAX_BUDGET: f64 = 1e3;
/// Most places on an edge that the tolerance binds.
const MAX_EDGE_POINTS: usize = 100;

/// Options of [`FairFit::new`](super::FairFit::new).
///
/// ```
/// use cyclide::FairFitOptions;
/// let options = FairFitOptions { fix_ends: true, ..FairFitOptions::new(0.05) };
/// assert!(options.tolerance == 0.05 && !options.closed);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FairFitOptions {
    /// The last point joins the first.
    pub closed: bool,
    /// Largest distance of a point from the curve, in the unit of the points; positive.
    pub tolerance: f64,
    /// Turns above this angle (radians, in `(0, pi]`) that stand out from their neighbours, and that a line eight
    /// tolerances long on either side confirms, stay corners. `None`: only the [`corners`](Self::corners) given.
    pub corner_angle: Option<f64>,
    /// Indices of points that are corners in any case. The curve passes through corners exactly.
    pub corners: Vec<usize>,
    /// An open curve starts and ends exactly at the first and last point; else they are bound by the tolerance only,
    /// as all others. Without effect on a closed curve, which a warning says.
    pub fix_ends: bool,
    /// How much the curve keeps to the middle of the data, 0 to 1e6. 0: the fairest curve in the tolerance, which leans
    /// on its bounds; 1 halves the distance to what noisy points were measured from for a few per cent of fairness
    /// (with a tolerance of 3 to 4 standard deviations); 10 and more approach least squares.
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

    /// # Errors
    /// `tolerance-not-positive`, `not-finite`, `parameter-out-of-range`.
    pub(super) fn check(&self, points: usize) -> Result<()> {
        check_tolerance(self.tolerance)?;
        let within = |name, value: f64, [min, max]: [f64; 2]| {
            if value >= min && value <= max {
                Ok(())
            } else {
                Err(Error::ParameterOutOfRange { name, value, min, max })
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
