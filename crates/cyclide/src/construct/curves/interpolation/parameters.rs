//! At which parameters a curve meets its points.

use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, PointError, Result};

/// The parameters at which a curve meets its points. They matter: the curve through the same points at others is another curve,
/// but for those that differ by a projective map of the line (`docs/math/qb-interpolation.md#parameters`).
///
/// ```
/// use cyclide::{Point3, construct::NodeParameters};
/// let points = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 1.0, 0.0]].map(Point3::from);
/// assert_eq!(NodeParameters::Chord.of(&points)?, [0.0, 0.75, 1.0]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub enum NodeParameters {
    /// By the lengths of chords, of points in one plane by their roots: then the curve swings out the least.
    #[default]
    Automatic,
    /// As far apart as the points are.
    Chord,
    /// By the square roots of their distances.
    Centripetal,
    /// Evenly.
    Uniform,
    /// These, one for each point.
    Given(Vec<f64>),
}

/// Points within this part of their extent are in one plane.
const PLANE: f64 = 1e-9;

impl NodeParameters {
    /// The parameters of points: from 0 to 1, but for those given, which are as they are.
    ///
    /// # Errors
    /// `count-differs` (given ones), `not-finite`, `coincident-points` (neighbors, of parameters by distance).
    pub fn of(&self, points: &[Point3]) -> Result<Vec<f64>> {
        if let Self::Given(given) = self {
            return check_given(given, points.len());
        }
        if let Some(index) = points.iter().position(|p| !p.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Point, index }.into());
        }
        if points.len() == 1 {
            return Ok(vec![0.0]);
        }
        let steps = node_steps(self, points, false)?;
        let total: f64 = steps.iter().sum();
        let mut sum = 0.0;
        let mut out = vec![0.0];
        out.extend(steps.iter().map(|step| {
            sum += step;
            sum / total
        }));
        Ok(out)
    }
}

/// The given parameters, one for each point.
fn check_given(given: &[f64], points: usize) -> Result<Vec<f64>> {
    if given.len() != points {
        return Err(NumberError::CountDiffers { what: ErrorItem::Parameter, given: given.len(), needed: points }.into());
    }
    match given.iter().position(|t| !t.is_finite()) {
        Some(index) => Err(NumberError::NotFinite { what: ErrorItem::Parameter, index }.into()),
        None => Ok(given.to_vec()),
    }
}

/// The steps from each point to the next, of a closed curve to the first one too; none are 0. Given parameters are no steps: even ones.
pub(in crate::construct::curves) fn node_steps(
    parameters: &NodeParameters,
    points: &[Point3],
    closed: bool,
) -> Result<Vec<f64>> {
    let n = points.len();
    let count = if closed { n } else { n.saturating_sub(1) };
    let even = matches!(parameters, NodeParameters::Uniform | NodeParameters::Given(_));
    let by_roots = match parameters {
        NodeParameters::Automatic => is_planar(points),
        other => *other == NodeParameters::Centripetal,
    };
    let step = |first: usize| {
        let second = (first + 1) % n;
        let distance = points[first].distance(points[second]);
        if even {
            Ok(1.0)
        } else if distance > 0.0 {
            Ok(if by_roots { distance.sqrt() } else { distance })
        } else {
            Err(Error::Point(PointError::CoincidentPoints { first, second, distance, limit: 0.0 }))
        }
    };
    let mut steps = Vec::with_capacity(count);
    for first in 0..count {
        steps.push(step(first)?);
    }
    Ok(steps)
}

/// True of points in one plane but not on one line, where chord lengths give the line itself.
fn is_planar(points: &[Point3]) -> bool {
    let Some(bounds) = Aabb::of_points(points.iter().copied()) else { return false };
    let size = bounds.diagonal();
    let Some(&first) = points.first() else { return false };
    let offsets = || points.iter().map(|p| *p - first);
    let farthest = |measure: &dyn Fn(Vec3) -> f64| {
        let measured = offsets().map(|v| (measure(v), v));
        measured.max_by(|a, b| a.0.total_cmp(&b.0)).map_or(Vec3::ZERO, |(_, v)| v)
    };
    let Some(along) = farthest(&|v| v.length()).unit() else { return false };
    let height = |v: Vec3| v.cross(along).length();
    let across = farthest(&height);
    let limit = PLANE * size;
    let Some(normal) = along.cross(across).unit().filter(|_| height(across) > limit) else { return false };
    offsets().all(|v| v.dot(normal).abs() <= limit)
}
