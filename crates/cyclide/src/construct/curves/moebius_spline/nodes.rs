//! The derivatives of circles at points.
//!
//! With the chords `d0`, `d1` beside a point and the steps `h0`, `h1` of the knots, the circle through the three points at their knots has
//! the direction of the [node tangent](../../../curve/node_tangent) and the speed
//! ```text
//! inside: (h0 + h1)/(h0 h1) |d0||d1|/|d0 + d1|      first: h1/(h0 (h0 + h1)) |d0||d0 + d1|/|d1|
//! ```

use crate::base::vector::{Point3, Vec3};
use crate::curve::{Chord, chords_between, corner_nodes};
use crate::error::{ArcError, Error, ErrorItem, NumberError, PointError, PoseError, Result};

/// The derivative with which a curve arrives at a node, and that with which it leaves: different at corners and cusps only.
#[derive(Debug, Clone, Copy)]
pub(super) struct NodeVelocity {
    pub(super) arriving: Vec3,
    pub(super) leaving: Vec3,
    pub(super) is_cusp: bool,
}

impl NodeVelocity {
    pub(super) fn smooth(v: Vec3) -> Self {
        Self { arriving: v, leaving: v, is_cusp: false }
    }
}

/// Points with their chords, steps of knots, and corners.
#[derive(Debug)]
pub(super) struct Nodes<'a> {
    pub(super) points: &'a [Point3],
    pub(super) chords: Vec<Chord>,
    pub(super) steps: Vec<f64>,
    pub(super) closed: bool,
    /// Rising.
    corners: Vec<usize>,
}

impl<'a> Nodes<'a> {
    /// Of points and knots: one for each point, of a closed curve one more.
    pub(super) fn new(points: &'a [Point3], knots: &[f64], closed: bool, corners: &[usize]) -> Result<Self> {
        let needed = points.len() + usize::from(closed);
        if knots.len() != needed {
            return Err(NumberError::CountDiffers { what: ErrorItem::Knot, given: knots.len(), needed }.into());
        }
        if let Some(index) = knots.iter().position(|k| !k.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Knot, index }.into());
        }
        let steps: Vec<f64> = knots.windows(2).map(|w| w[1] - w[0]).collect();
        let chords = match (chords_between(points, closed), steps.iter().position(|h| !(*h > 0.0))) {
            // Of both faults that of the knots is told first, unless there are no points at all.
            (Ok(_) | Err(Error::Point(PointError::CoincidentPoints { .. })), Some(index)) => {
                return Err(PoseError::ParametersNotIncreasing {
                    index: index + 1,
                    value: knots[index + 1],
                    before: knots[index],
                }
                .into());
            }
            (chords, _) => chords?,
        };
        let corners = corner_nodes(corners, points.len(), closed)?;
        Ok(Self { points, chords, steps, closed, corners })
    }

    /// True of the ends of an open curve and of corners: no circle runs through.
    pub(super) fn is_cut(&self, i: usize) -> bool {
        (!self.closed && (i == 0 || i + 1 == self.points.len())) || self.corners.binary_search(&i).is_ok()
    }

    /// The velocity at a node.
    pub(super) fn velocity(&self, i: usize) -> NodeVelocity {
        let (n, m) = (self.points.len(), self.chords.len());
        let before = (i + n - 1) % n;
        if !self.is_cut(i) {
            return self.inner_velocity(before, i);
        }
        let leaving = self.cut_velocity([i.min(m - 1), (i + 1) % m], (i + 1) % n, false);
        let arriving = self.cut_velocity([before.min(m - 1), (i + n - 2) % n % m], before, true);
        match i {
            0 if !self.closed => NodeVelocity::smooth(leaving),
            i if !self.closed && i + 1 == n => NodeVelocity::smooth(arriving),
            _ => NodeVelocity { arriving, leaving, is_cusp: true },
        }
    }

    /// Where the curve is cut: by the circle through the next two points, or along the chord if that is cut too.
    fn cut_velocity(&self, chords: [usize; 2], neighbor: usize, reversed: bool) -> Vec3 {
        if self.is_cut(neighbor) { self.chord_velocity(chords[0]) } else { self.end_velocity(chords, reversed) }
    }

    fn inner_velocity(&self, before: usize, after: usize) -> NodeVelocity {
        let ([c0, c1], [h0, h1]) =
            ([&self.chords[before], &self.chords[after]], [self.steps[before], self.steps[after]]);
        match c0.tangent_to(c1) {
            Some(tangent) => {
                let speed = (1.0 / h0 + 1.0 / h1) * c0.length * (c1.length / across(c0, c1));
                NodeVelocity::smooth(tangent * speed)
            }
            None => {
                let (arriving, leaving) = (self.chord_velocity(before), self.chord_velocity(after));
                NodeVelocity { arriving, leaving, is_cusp: true }
            }
        }
    }

    /// At an end: by the circle of the first (last) three points; along the chord beside a cusp.
    fn end_velocity(&self, [own, next]: [usize; 2], reversed: bool) -> Vec3 {
        let ([c0, c1], [h0, h1]) = ([&self.chords[own], &self.chords[next]], [self.steps[own], self.steps[next]]);
        let neighbor = if reversed { c1.tangent_to(c0) } else { c0.tangent_to(c1) };
        match neighbor {
            Some(tangent) => {
                let speed = h1 / (h0 * (h0 + h1)) * c0.length * (across(c0, c1) / c1.length);
                tangent.reflect(c0.unit) * speed
            }
            None => self.chord_velocity(own),
        }
    }

    fn chord_velocity(&self, i: usize) -> Vec3 {
        self.chords[i].unit * (self.chords[i].length / self.steps[i])
    }
}

/// Distance from the start of one chord to the end of the next, without overflow.
fn across(a: &Chord, b: &Chord) -> f64 {
    (a.unit * a.length + b.unit * b.length).length()
}

/// At each point the derivative, by the knots, of the circle through it and its neighbors, which it passes at their knots: the
/// Möbius-covariant tangents of a [Möbius spline](crate::curve::QbSpline::through_points). At the ends of an open curve the circle is that of the
/// three points there; of two points it is the segment. A closed curve does not repeat its first point and has one more knot, at
/// which it closes.
///
/// ```
/// use cyclide::{Point3, construct::circle_tangents};
/// let points = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let tangents = circle_tangents(&points, &[0.0, 1.0, 2.0], false)?;
/// assert!(tangents[1].cross(cyclide::Vec3::X).length() < 1e-15 && tangents[1].x < 0.0);
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// `count-differs` (knots), `too-few-points` (2 open, 3 closed), `not-finite`, `parameters-not-increasing` (knots),
/// `coincident-points`, `tangent-undefined` (a point at which the polygon turns right back).
pub fn circle_tangents(points: &[Point3], knots: &[f64], closed: bool) -> Result<Vec<Vec3>> {
    let nodes = Nodes::new(points, knots, closed, &[])?;
    let tangent = |index: usize| {
        let velocity = nodes.velocity(index);
        if velocity.is_cusp {
            let n = points.len();
            let (before, after) = (&nodes.chords[(index + n - 1) % n], &nodes.chords[index]);
            let measured = (before.unit + after.unit).length();
            return Err(ArcError::Cusp { index, measured, limit: Chord::CUSP_LIMIT }.into());
        }
        Ok(velocity.arriving)
    };
    (0..points.len()).map(tangent).collect()
}
