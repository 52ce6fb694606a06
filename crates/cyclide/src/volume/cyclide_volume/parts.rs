//! Coordinate surfaces as patches, parameter lines as arcs, sub-volumes, other orders of the parameters.

use super::{CyclideVolume, corners_at_start, others, trilinear};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;
use crate::error::{ArcError, ErrorItem, NumberError, Result};
use crate::surface::CyclidePatch;

/// A side is one point up to so many roundings of its coordinates.
const POINT: f64 = 64.0;
/// Words for the parameters.
const PARAMETERS: [ErrorItem; 3] = [ErrorItem::S, ErrorItem::T, ErrorItem::U];

impl CyclideVolume {
    /// The coordinate surface at `x` in direction `axis` (0, 1, 2 for s, t, u), with the two other parameters in order: exact, with the same
    /// parameters.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless `x` is from 0 to 1.
    ///
    /// # Panics
    /// If `axis` is above 2.
    pub fn surface(&self, axis: usize, x: f64) -> Result<CyclidePatch> {
        check_range(axis, [x, x])?;
        let [i, j] = others(axis);
        let places: [[f64; 3]; 4] = std::array::from_fn(|k| {
            let mut at = [0.0; 3];
            (at[axis], at[i], at[j]) = (x, (k & 1) as f64, (k >> 1) as f64);
            at
        });
        let (corners, weights) = (places.map(|at| self.corner_point(at)), places.map(|at| self.denominator(at)));
        Ok(CyclidePatch::from_weights_unchecked(corners, weights, self.v[i], self.v[j]))
    }

    /// Refuses a parameter in direction `axis` that is not from 0 to 1.
    pub(crate) fn check_parameter(axis: usize, x: f64) -> Result<()> {
        check_range(axis, [x, x])
    }

    /// The six faces: s = 0, s = 1, t = 0, t = 1, u = 0, u = 1.
    #[must_use]
    pub fn faces(&self) -> [CyclidePatch; 6] {
        std::array::from_fn(|k| {
            let (axis, end) = (k / 2, (k % 2) << (k / 2));
            let [i, j] = others(axis);
            let at = corners_at_start(axis).map(|corner| corner | end);
            CyclidePatch::from_weights_unchecked(
                at.map(|c| self.corners[c]),
                at.map(|c| self.weights[c]),
                self.v[i],
                self.v[j],
            )
        })
    }

    /// The parameter line in direction `axis` through the places `x`, `y` of the two other directions in order, as an arc with the same
    /// parameter.
    ///
    /// # Errors
    /// `parameter-out-of-range`; `coincident-points` where the line is one point.
    ///
    /// # Panics
    /// If `axis` is above 2.
    pub fn line(&self, axis: usize, [x, y]: [f64; 2]) -> Result<Arc> {
        let [i, j] = others(axis);
        check_range(i, [x, x])?;
        check_range(j, [y, y])?;
        let place = |end: f64| {
            let mut at = [end; 3];
            (at[i], at[j]) = (x, y);
            at
        };
        let (from, to) = (place(0.0), place(1.0));
        let inverse = self.denominator(from).inverse().ok_or(ArcError::ZeroWeight { index: 0 })?;
        Arc::from_ratio_across(self.corner_point(from), self.corner_point(to), self.denominator(to) * inverse)
    }

    /// The four sides in a direction, at (0, 0), (1, 0), (0, 1), (1, 1) of the two others: none where the side is one point, up to rounding of its place.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, surface::{CyclidePatch, CyclidicNet}, volume::CyclideGrid};
    /// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
    /// let octant = CyclidicNet::from(CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)?); // its pole at t = 1
    /// let wedge = CyclideGrid::layers(&octant, &[0.0, 1.0])?.block([0, 0, 0]);
    /// assert_eq!(wedge.sides(0).map(|side| side.is_some()), [true, false, true, false]);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Panics
    /// If `axis` is above 2.
    #[must_use]
    pub fn sides(&self, axis: usize) -> [Option<Arc>; 4] {
        let reach = self.corners.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let at = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        at.map(|at| self.line(axis, at).ok().filter(|side| side.length() > POINT * f64::EPSILON * reach))
    }

    /// The part over these ranges of s, t and u as a volume of its own: exact.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless they are rising, within `[0, 1]`.
    pub fn restricted(&self, ranges: [[f64; 2]; 3]) -> Result<Self> {
        for (axis, range) in ranges.into_iter().enumerate() {
            check_range(axis, range)?;
            if !(range[0] < range[1]) {
                return Err(NumberError::ParameterOutOfRange {
                    name: PARAMETERS[axis],
                    value: range[1],
                    min: range[0],
                    max: 1.0,
                }
                .into());
            }
        }
        let places: [[f64; 3]; 8] = std::array::from_fn(|k| std::array::from_fn(|axis| ranges[axis][k >> axis & 1]));
        let weights: [Quat; 8] = places.map(|at| trilinear(&self.weights, at));
        let mut corners = places.map(|at| self.corner_point(at));
        // Ends of lines that are one point are that, bit for bit: forth along all sides, and back.
        let sides = (0..3).flat_map(|axis| corners_at_start(axis).map(|start| (axis, start)));
        let points: Vec<_> = sides.filter(|&(axis, start)| self.standing_lines(places[start])[axis]).collect();
        points.iter().for_each(|(axis, start)| corners[start | 1 << axis] = corners[*start]);
        points.iter().rev().for_each(|(axis, start)| corners[*start] = corners[start | 1 << axis]);
        Ok(Self::from_weights_unchecked(corners, weights, self.v))
    }

    /// The two parts on both sides of `x` in direction `axis`.
    ///
    /// # Errors
    /// As [`restricted`](Self::restricted).
    ///
    /// # Panics
    /// If `axis` is above 2.
    pub fn split(&self, axis: usize, x: f64) -> Result<[Self; 2]> {
        let mut ranges = [[0.0, 1.0]; 3];
        ranges[axis] = [0.0, x];
        let first = self.restricted(ranges)?;
        ranges[axis] = [x, 1.0];
        Ok([first, self.restricted(ranges)?])
    }

    /// The same block with the parameter of direction `axis` running the other way: of the other handedness.
    ///
    /// # Panics
    /// If `axis` is above 2.
    #[must_use]
    pub fn reversed(&self, axis: usize) -> Self {
        let mut v = self.v;
        v[axis] = -v[axis];
        self.rearranged(|k| k ^ (1 << axis), v)
    }

    /// The same block with its directions in another order: the first parameter is that of direction `order[0]` before, and so on. Of the
    /// other handedness after an odd permutation.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the order has each of 0, 1, 2 once.
    pub fn permuted(&self, order: [usize; 3]) -> Result<Self> {
        if let Some(axis) = (0..3).find(|axis| !order.contains(axis)) {
            let value = order.iter().find(|k| **k > 2).copied().unwrap_or(axis) as f64;
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Axis, value, min: 0.0, max: 2.0 }.into());
        }
        let before = |k: usize| (0..3).map(|axis| (k >> axis & 1) << order[axis]).sum();
        Ok(self.rearranged(before, order.map(|axis| self.v[axis])))
    }

    /// The block as a right-handed one: with s and t exchanged where it is left-handed.
    #[must_use]
    pub fn right_handed(&self) -> Self {
        if self.is_right_handed() {
            return *self;
        }
        self.rearranged(|k| (k & 4) | (k & 1) << 1 | (k & 2) >> 1, [self.v[1], self.v[0], self.v[2]])
    }

    /// Corners and weights from their places before.
    fn rearranged(&self, before: impl Fn(usize) -> usize, v: [Vec3; 3]) -> Self {
        let (corners, weights) =
            (std::array::from_fn(|k| self.corners[before(k)]), std::array::from_fn(|k| self.weights[before(k)]));
        Self::from_weights_unchecked(corners, weights, v)
    }

    /// The point, and at a corner the corner itself.
    fn corner_point(&self, at: [f64; 3]) -> Point3 {
        let bit = |x: f64| match x {
            0.0 => Some(0),
            1.0 => Some(1),
            _ => None,
        };
        match at.map(bit) {
            [Some(i), Some(j), Some(k)] => self.corners[i + 2 * j + 4 * k],
            _ => self.quotient(at, self.denominator(at)),
        }
    }
}

fn check_range(axis: usize, ends: [f64; 2]) -> Result<()> {
    match ends.into_iter().find(|x| !(0.0..=1.0).contains(x)) {
        Some(value) => {
            Err(NumberError::ParameterOutOfRange { name: PARAMETERS[axis], value, min: 0.0, max: 1.0 }.into())
        }
        None => Ok(()),
    }
}
