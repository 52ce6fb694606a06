//! The cross-sections of a tube at the stations of its spine: circles, ellipses in miters, as quarters.

use super::frame::Station;
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::curve::Arc;
use crate::error::Result;
use crate::rational::RationalBezier;
use crate::topology::EdgeCurve;
use std::f64::consts::FRAC_1_SQRT_2;

/// The weight ratio of a quarter about the tangent behind a station.
pub(super) fn quarter(station: &Station) -> Quat {
    Quat::from_parts(FRAC_1_SQRT_2, station.ways[1] * FRAC_1_SQRT_2)
}

/// A cross-section: the ends of its quarters, and these.
pub(super) struct Ring {
    pub(super) corners: [Point3; 4],
    pub(super) quarters: [EdgeCurve; 4],
}

impl Ring {
    pub(super) fn new(station: &Station, radius: f64) -> Result<Self> {
        let ways = station.directions();
        let corners = ways.map(|v| station.point + station.slanted(v) * radius);
        let between = |k: usize| -> Result<EdgeCurve> {
            let (start, end) = (corners[k], corners[(k + 1) % 4]);
            if !station.mitred {
                return Ok(Arc::from_ratio_across(start, end, quarter(station))?.into());
            }
            // A slanted view of the circle: its control points are moved, weights stay.
            let middle = station.point + station.slanted(ways[k] + ways[(k + 1) % 4]) * radius;
            let row = |p: Point3, w: f64| [p.x * w, p.y * w, p.z * w, w];
            let rows = vec![row(start, 1.0), row(middle, FRAC_1_SQRT_2), row(end, 1.0)];
            RationalBezier::new(rows).map(EdgeCurve::from)
        };
        Ok(Self { corners, quarters: [between(0)?, between(1)?, between(2)?, between(3)?] })
    }
}
