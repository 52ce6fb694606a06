//! Where the pieces of a spline on a torus meet.

use super::family::QuarticType;
use super::spline::TorusSpline;
use crate::base::planar::{Point2, Vec2};
use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve as _;

/// A place where two pieces of a spline on a torus meet.
///
/// ```
/// use cyclide::{Frame, surface::{Torus, TorusSpline}};
/// let knot = TorusSpline::knot(&Torus::new(Frame::WORLD, 3.0, 1.0)?, [2, 3], Default::default())?;
/// let junctions = knot.junctions();
/// assert_eq!(junctions.len(), knot.pieces().len());
/// assert!(junctions.iter().all(|j| j.jump.length() < 1e-12 * j.velocity.length()));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorusJunction {
    /// The piece that starts here.
    pub piece: usize,
    /// The knot; of the seam of a closed curve the first one.
    pub knot: f64,
    /// The place, unrolled.
    pub place: Point2,
    /// The point.
    pub point: Point3,
    /// True if a given point is here, false if the construction put the junction between.
    pub is_given: bool,
    /// Types of the piece before and after.
    pub types: [QuarticType; 2],
    /// First derivative by the knot parameter of the piece after.
    pub velocity: Vec3,
    /// That of the piece after less that of the piece before: rounding.
    pub jump: Vec3,
    /// The same in the plane of the torus, radians per unit of the knot parameter.
    pub rate_jump: Vec2,
}

impl TorusSpline {
    /// Where pieces meet, in order of the pieces that start there; of a closed curve first its seam.
    #[must_use]
    pub fn junctions(&self) -> Vec<TorusJunction> {
        let n = self.pieces.len();
        let first = usize::from(!self.closed);
        let mut given = vec![false; n];
        self.segments.iter().filter(|s| s.pieces.start < n).for_each(|s| given[s.pieces.start] = true);
        (first..n).map(|piece| self.junction(piece, (piece + n - 1) % n, given[piece])).collect()
    }

    fn junction(&self, piece: usize, before: usize, is_given: bool) -> TorusJunction {
        let velocity = |piece: usize, s: f64| self.piece_jet(piece, s).d1 / (self.knots[piece + 1] - self.knots[piece]);
        let after = velocity(piece, 0.0);
        TorusJunction {
            piece,
            knot: self.knots[piece],
            place: self.unrolled[piece],
            point: self.joints[piece],
            is_given,
            types: [before, piece].map(|i| self.pieces[i].quartic_type()),
            velocity: after,
            jump: after - velocity(before, 1.0),
            rate_jump: self.unrolled_rate(piece, 0.0) - self.unrolled_rate(before, 1.0),
        }
    }
}
