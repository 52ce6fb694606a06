//! Feet of the data on the curve: the nearest points of the branch each datum belongs to.
//!
//! Newton's iteration on `(x(u) - p).x'(u) = 0`, stepping over nodes. It starts from the last foot and thus stays on its branch,
//! which a search for the nearest point of all would not in a hairpin (`docs/math/fair-fits.md#limits`). A foot need
//! not be the nearest point: the distance at it is a bound whether it is or not (`docs/math/fair-fits.md#certificate`).

use super::tube_curve::TubeCurve;
use crate::base::vector::{Point3, Vec3};

/// Steps for a foot whose curve has changed a little.
pub(super) const WARM: usize = 4;
/// Steps for a foot that was only guessed.
pub(super) const COLD: usize = 30;
/// Longest step, in parameters of a segment.
const LONGEST_STEP: f64 = 0.8;
/// A step this short changes a distance by its square only.
const SHORT_STEP: f64 = 1e-7;

/// A place on the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub segment: usize,
    pub u: f64,
}

/// Where a datum stands over the curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Foot {
    pub place: Place,
    /// Datum minus foot.
    pub error: Vec3,
    /// Unit tangent at the foot.
    pub tangent: Vec3,
}

impl Foot {
    /// The foot of `p` near a place.
    pub fn new(curve: &TubeCurve, p: Point3, near: Place, steps: usize) -> Self {
        let mut place = near;
        let mut at = curve.segments[place.segment].point(place.u);
        for _ in 0..steps {
            let error = p - at.point;
            let speed = at.d1.length_squared();
            // Beyond the center of curvature Newton would run to the farthest point.
            let slope = (speed - error.dot(at.d2)).max(0.1 * speed);
            let step = (error.dot(at.d1) / slope).clamp(-LONGEST_STEP, LONGEST_STEP);
            let next = curve.moved(place, step);
            if next == place {
                break;
            }
            let short = step.abs() <= SHORT_STEP;
            place = next;
            at = curve.segments[place.segment].point(place.u);
            if short {
                break;
            }
        }
        let tangent = at.d1.unit().unwrap_or(curve.tangents[place.segment]);
        Self { place, error: p - at.point, tangent }
    }
}

impl TubeCurve {
    /// A place moved by a step in the parameter of its segment, over nodes with the speed kept; ends stop it.
    fn moved(&self, place: Place, step: f64) -> Place {
        let m = self.segments.len();
        let Place { segment, u } = place;
        let next = u + step;
        let (other, beyond) = if next > 1.0 {
            if !self.closed && segment + 1 == m {
                return Place { segment, u: 1.0 };
            }
            ((segment + 1) % m, next - 1.0)
        } else if next < 0.0 {
            if !self.closed && segment == 0 {
                return Place { segment, u: 0.0 };
            }
            ((segment + m - 1) % m, next)
        } else {
            return Place { segment, u: next };
        };
        // The speed by the parameter is the chord on either side of a node.
        let scaled = beyond * self.segments[segment].chord / self.segments[other].chord;
        Place { segment: other, u: if beyond > 0.0 { scaled.min(1.0) } else { (1.0 + scaled).max(0.0) } }
    }

    /// Feet of all data, from places near them.
    pub fn feet(&self, points: &[Point3], near: impl Iterator<Item = Place>, steps: usize) -> Vec<Foot> {
        points.iter().zip(near).map(|(p, near)| Foot::new(self, *p, near, steps)).collect()
    }
}

/// Largest distance of a datum from its foot.
pub(super) fn farthest(feet: &[Foot]) -> f64 {
    feet.iter().map(|f| f.error.length_squared()).fold(0.0, f64::max).sqrt()
}

/// Sum of the squared distances.
pub(super) fn squares(feet: &[Foot]) -> f64 {
    feet.iter().map(|f| f.error.length_squared()).sum()
}
