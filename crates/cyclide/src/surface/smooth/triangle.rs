//! One triangle of a smooth surface.

use super::side::{Side, SpokeArc, blend, tangent_across};
use crate::base::vector::{Point3, Vec3};
use crate::curve::{BlendSegment, Chord};
use crate::error::{Error, ErrorItem, MeshError, NumberError, Result};
use crate::surface::barycentric::Barycentric;
use crate::surface::sphere_blend::check_triangle;

/// Nearer to a corner than this the rounding of derivatives is divided by the distance: its own normal is as good.
const AT_CORNER: f64 = 1e-8;

/// A smooth patch over a triangle with a unit normal at each corner: on every side a circle blend that belongs to its ends
/// alone (and the normal with it), inside the mean of three blends from the corners to the opposite sides
/// (`docs/math/triangle-surfaces.md#smooth-meshes`; G. Nielson's side-vertex scheme with circle blends for its arcs).
///
/// ```
/// use cyclide::{Point3, Vec3, surface::SmoothTriangle};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let octant = SmoothTriangle::new(corners, [Vec3::X, Vec3::Y, Vec3::Z])?;
/// let middle = octant.point([1.0, 1.0, 0.0])?; // the middle of a side
/// assert!((middle.to_vec().length() - 1.0).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothTriangle {
    corners: [Point3; 3],
    normals: [Vec3; 3],
    /// The side opposite to each corner.
    sides: [Side; 3],
    /// Whether the curve of a side runs against the triangle, from the corner after the next to the next.
    against: [bool; 3],
}

/// A point of a patch over a triangle with its derivatives by the first two barycentric coordinates, the third being what is left to 1.
#[derive(Debug, Clone, Copy)]
pub(in crate::surface) struct Jet {
    pub(in crate::surface) point: Point3,
    pub(in crate::surface) derivatives: [Vec3; 2],
}

/// Derivatives of the three coordinates by the first two.
const SEEDS: [[f64; 3]; 2] = [[1.0, 0.0, -1.0], [0.0, 1.0, -1.0]];

impl SmoothTriangle {
    /// The patch over three corners with normals of any length, which should point to the side from which the corners are
    /// seen counter-clockwise.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates above 1e150), `degenerate-triangle`, `undefined-normal` (zero),
    /// `normal-along-edge`, `opposite-normals` (at the ends of a side), `arc-through-infinity`, `ambiguous-half-turn`.
    pub fn new(corners: [Point3; 3], normals: [Vec3; 3]) -> Result<Self> {
        check_triangle(corners)?;
        let mut units = [Vec3::ZERO; 3];
        for (i, normal) in normals.into_iter().enumerate() {
            units[i] = unit_normal(normal, i)?;
        }
        let side = |corner: usize, [from, to]: [usize; 2]| {
            let [a, b] = [from, to].map(|i| units[i]);
            let chord = Chord::new(corners[from], corners[to]);
            let tangents = [tangent_across(chord.unit, a, from)?.0, tangent_across(chord.unit, b, to)?.0];
            let side = Side { curve: blend([corners[from], corners[to]], &chord, tangents)?, normals: [a, b] };
            // Opposite ones cancel half way.
            side.at(0.5, corner).map(|_| side)
        };
        let sides = [side(0, [1, 2])?, side(1, [0, 2])?, side(2, [0, 1])?];
        Ok(Self { corners, normals: units, sides, against: [false, true, false] })
    }

    /// The patch between sides that are known.
    pub(super) fn from_sides(corners: [Point3; 3], normals: [Vec3; 3], sides: [Side; 3], against: [bool; 3]) -> Self {
        Self { corners, normals, sides, against }
    }

    /// Corners.
    #[must_use]
    pub fn corners(&self) -> [Point3; 3] {
        self.corners
    }

    /// Unit normals at the corners.
    #[must_use]
    pub fn normals(&self) -> [Vec3; 3] {
        self.normals
    }

    /// The curves of the sides, each opposite to the corner of its index; their direction is that of their bits, which may be
    /// against the triangle.
    #[must_use]
    pub fn side_curves(&self) -> [&BlendSegment; 3] {
        self.sides.each_ref().map(|side| &side.curve)
    }

    /// The point at barycentric coordinates, not negative, in any scale: only ratios count, and integers
    /// `(i, j, N-i-j)` give the same bits on both sides of a shared edge. Corners come out to the bit.
    ///
    /// # Errors
    /// `parameter-out-of-range` (coordinates not finite, negative or all zero); where the normals at the corners differ
    /// wildly `opposite-normals`, `normal-along-edge`, `arc-through-infinity`, `ambiguous-half-turn`.
    pub fn point(&self, lambda: [f64; 3]) -> Result<Point3> {
        let at = Barycentric::new(lambda)?;
        if let Some(corner) = at.corner() {
            return Ok(self.corners[corner]);
        }
        if let Some(side) = at.side() {
            return Ok(self.sides[side].curve.point(self.along_side(side, &at)));
        }
        self.mean(&at, |spoke, l, _| (spoke.point(l), [Vec3::ZERO; 2])).map(|jet| jet.point)
    }

    /// Unit normal; at the corners and on the sides that which neighbors share.
    ///
    /// # Errors
    /// As [`point`](Self::point).
    pub fn normal(&self, lambda: [f64; 3]) -> Result<Vec3> {
        let at = Barycentric::new(lambda)?;
        match self.known_normal(&at)? {
            Some(normal) => Ok(normal),
            None => Ok(self.normal_of(&self.jet(&at)?, &at)),
        }
    }

    /// Point and unit normal, for less than both of them.
    ///
    /// # Errors
    /// As [`point`](Self::point).
    pub fn point_and_normal(&self, lambda: [f64; 3]) -> Result<(Point3, Vec3)> {
        let at = Barycentric::new(lambda)?;
        if let Some(normal) = self.known_normal(&at)? {
            return Ok((self.point(lambda)?, normal));
        }
        let jet = self.jet(&at)?;
        Ok((jet.point, self.normal_of(&jet, &at)))
    }

    /// The point and the two derivatives at a place that is no corner.
    pub(super) fn jet(&self, at: &Barycentric) -> Result<Jet> {
        let p = at.coordinates();
        self.mean(at, |spoke, l, corner| {
            let [by_l, by_mu] = spoke.derivatives(l);
            let [from, to] = self.ends_of_side(corner);
            let rest = p[from] + p[to];
            let derivatives = SEEDS.map(|seed| {
                let mu = (seed[to] * p[from] - seed[from] * p[to]) / (rest * rest);
                by_mu * mu - by_l * seed[corner]
            });
            (spoke.point(l), derivatives)
        })
    }

    /// The mean of the three arcs through a place with the weights `1/λ_i²`, of which that of the smallest coordinate is set
    /// to 1; on a side it is its own arc alone.
    fn mean(&self, at: &Barycentric, place: impl Fn(&SpokeArc, f64, usize) -> (Point3, [Vec3; 2])) -> Result<Jet> {
        let p = at.coordinates();
        let arc = |i: usize| {
            let to = self.sides[i].at(self.along_side(i, at), i)?;
            let spoke = SpokeArc::new(i, self.corners[i], self.normals[i], &to)?;
            Ok::<_, Error>(place(&spoke, at.off_corner(i), i))
        };
        let nearest = at.smallest();
        let (origin, along) = arc(nearest)?;
        let (mut weight, mut weight_change) = (1.0, [0.0; 2]);
        let (mut sum, mut sum_change) = (Vec3::ZERO, [Vec3::ZERO; 2]);
        for i in [(nearest + 1) % 3, (nearest + 2) % 3] {
            let ratio = p[nearest] / p[i];
            if ratio == 0.0 {
                continue;
            }
            let (point, derivatives) = arc(i)?;
            let (beta, offset) = (ratio * ratio, point - origin);
            weight += beta;
            sum += offset * beta;
            for k in 0..2 {
                let change = 2.0 * ratio * (SEEDS[k][nearest] - ratio * SEEDS[k][i]) / p[i];
                weight_change[k] += change;
                sum_change[k] += offset * change + (derivatives[k] - along[k]) * beta;
            }
        }
        let mean = sum / weight;
        let derivatives = [0, 1].map(|k| along[k] + (sum_change[k] - mean * weight_change[k]) / weight);
        Ok(Jet { point: origin + mean, derivatives })
    }

    /// The normal where neighbors share it.
    fn known_normal(&self, at: &Barycentric) -> Result<Option<Vec3>> {
        let nearest = at.largest();
        if at.off_corner(nearest) <= AT_CORNER {
            return Ok(Some(self.normals[nearest]));
        }
        match at.side() {
            Some(side) => Ok(Some(self.sides[side].at(self.along_side(side, at), side)?.normal)),
            None => Ok(None),
        }
    }

    /// The normal of a jet; where the derivatives have one direction, the mean of those at the corners.
    fn normal_of(&self, jet: &Jet, at: &Barycentric) -> Vec3 {
        let [d1, d2] = jet.derivatives;
        let p = at.coordinates();
        let mean = || (0..3).fold(Vec3::ZERO, |sum, i| sum + self.normals[i] * p[i]).unit();
        let normal = d1.unit().zip(d2.unit()).and_then(|(a, b)| a.cross(b).unit());
        normal.or_else(mean).unwrap_or(self.normals[at.largest()])
    }

    /// The corners between which the curve of a side runs.
    fn ends_of_side(&self, side: usize) -> [usize; 2] {
        let [next, last] = [(side + 1) % 3, (side + 2) % 3];
        if self.against[side] { [last, next] } else { [next, last] }
    }

    fn along_side(&self, side: usize, at: &Barycentric) -> f64 {
        let [from, to] = self.ends_of_side(side);
        at.between(from, to)
    }
}

/// A normal of any length made a unit vector.
///
/// # Errors
/// `not-finite`, `undefined-normal`.
pub(super) fn unit_normal(normal: Vec3, vertex: usize) -> Result<Vec3> {
    if !normal.is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::Normal, index: vertex }.into());
    }
    normal.unit().ok_or(Error::Mesh(MeshError::UndefinedNormal { vertex, length: 0.0, limit: 0.0 }))
}
