//! A grid over the whole box of a lattice.

use super::continuation::continued;
use super::lattice::Lattice;
use cyclide::{Point3, Result, surface::QuadGrid};

/// Rings of points beyond the outermost points of the surface: it reaches less than one step beyond them.
const RINGS: i64 = 1;
/// Points of a grid at most.
const MOST_POINTS: usize = 1_000_000;

/// The grid over the box; `None` if it is too large, or what is known does not tell the rest.
///
/// # Errors
/// As of `QuadGrid::new`: continued points that are no numbers of the kernel.
pub(super) fn covering(
    lattice: &Lattice<'_>,
    point: &dyn Fn(super::walker::Place) -> Point3,
) -> Option<Result<QuadGrid>> {
    let (size, places) = lattice.boxed(RINGS, MOST_POINTS)?;
    let closed = lattice.is_closed();
    let mut points: Vec<Option<Point3>> = places.iter().map(|place| place.map(point)).collect();
    continued(&mut points, &vec![true; places.len()], size, closed)?;
    Some(QuadGrid::new(points.into_iter().collect::<Option<_>>()?, size, [closed, false]))
}
