//! More conditions than a curve of the largest degree takes.
//!
//! A curve of degree `n` is known by `2n + 1` of its conditions: as many as the largest degree takes, spread over all, make the
//! only curve there can be, and the others are met or not. So the work grows with the number of points, not with its
//! cube, and no reason is read off the rank of a matrix that is all rounding
//! (`docs/math/qb-interpolation.md#more-points-than-the-largest-degree-takes`; own derivation).

use super::finish::MOST_DEGREE;
use crate::curve::QbCurve;
use crate::error::{Error, InterpolationError, NurbsError, Result};

/// Conditions that a curve of the largest degree takes.
pub(super) const MOST_CONDITIONS: usize = 2 * MOST_DEGREE + 1;

/// The curve that meets all conditions. `owners` are the nodes that they belong to, in the order of parameters. `through` makes the curve through
/// nodes with as many of their conditions as it is told, and names those it cannot attain by their place in that list; `check` looks
/// at all nodes.
///
/// # Errors
/// `unattainable-point` where all but a few nodes lie on a curve of lower degree, `degree-too-high` else.
pub(super) fn from_some(
    owners: &[usize],
    through: impl Fn(&[(usize, usize)]) -> Result<QbCurve>,
    check: impl Fn(&QbCurve) -> Result<()>,
) -> Result<QbCurve> {
    let degree = owners.len() / 2;
    let too_high = Error::Nurbs(NurbsError::DegreeTooHigh { degree, limit: MOST_DEGREE });
    let mut aside: Vec<usize> = Vec::new();
    loop {
        let open: Vec<usize> = owners.iter().copied().filter(|node| !aside.contains(node)).collect();
        if open.len() < MOST_CONDITIONS {
            return Err(too_high);
        }
        let chosen = spread(&open);
        match through(&chosen) {
            Ok(curve) => {
                // A polynomial factor that vanishes at the nodes missed lifts the curve to a solution of the whole system:
                // up to its degree no other curve solves it.
                let conditions = |missed: &[usize]| owners.iter().filter(|node| missed.contains(node)).count();
                return match check(&curve) {
                    Ok(()) => Ok(curve),
                    Err(Error::Interpolation(InterpolationError::UnattainablePoint { points, measured, limit }))
                        if curve.degree() + conditions(&points) <= degree =>
                    {
                        Err(InterpolationError::UnattainablePoint { points, measured, limit }.into())
                    }
                    Err(_) => Err(too_high),
                };
            }
            // The other ones decide.
            Err(Error::Interpolation(InterpolationError::UnattainablePoint { points, .. }))
                if aside.len() + points.len() <= MOST_DEGREE =>
            {
                aside.extend(points.iter().map(|place| chosen[*place].0));
            }
            Err(_) => return Err(too_high),
        }
    }
}

/// As many conditions as there may be, spread over those given: the nodes, and how many each.
fn spread(open: &[usize]) -> Vec<(usize, usize)> {
    let mut chosen: Vec<(usize, usize)> = Vec::with_capacity(MOST_CONDITIONS);
    for k in 0..MOST_CONDITIONS {
        let node = open[k * (open.len() - 1) / (MOST_CONDITIONS - 1)];
        match chosen.last_mut() {
            Some((last, count)) if *last == node => *count += 1,
            _ => chosen.push((node, 1)),
        }
    }
    chosen
}
