//! Axis-aligned bounding boxes.

use super::vector::{Point3, Vec3};

/// An axis-aligned box, both corners included.
///
/// ```
/// use cyclide::{Aabb, Point3};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 2.0, 2.0]].map(Point3::from);
/// let bounds = Aabb::of_points(corners).expect("there are points");
/// assert!(bounds.diagonal() == 3.0 && bounds.distance(Point3::new(4.0, 1.0, 1.0)) == 3.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    /// Smallest coordinates.
    pub min: Point3,
    /// Largest coordinates.
    pub max: Point3,
}

impl Aabb {
    /// The box of one point.
    #[must_use]
    #[inline]
    pub fn of_point(p: Point3) -> Self {
        Self { min: p, max: p }
    }

    /// The smallest box of some points; `None` if there are none.
    #[must_use]
    #[inline]
    pub fn of_points<I: IntoIterator<Item = Point3>>(points: I) -> Option<Self> {
        let mut points = points.into_iter();
        let first = Self::of_point(points.next()?);
        Some(points.fold(first, Self::including))
    }

    /// The box grown to include a point.
    #[must_use]
    #[inline]
    pub fn including(self, p: Point3) -> Self {
        Self {
            min: Point3::new(self.min.x.min(p.x), self.min.y.min(p.y), self.min.z.min(p.z)),
            max: Point3::new(self.max.x.max(p.x), self.max.y.max(p.y), self.max.z.max(p.z)),
        }
    }

    /// The smallest box of two boxes.
    #[must_use]
    #[inline]
    pub fn union(self, o: Self) -> Self {
        self.including(o.min).including(o.max)
    }

    /// True if the other box lies inside this one (touching allowed).
    #[must_use]
    #[inline]
    pub fn contains(self, o: Self) -> bool {
        self.union(o) == self
    }

    /// True if the boxes share a point.
    pub(crate) fn meets(self, o: Self) -> bool {
        let meets = |min: f64, max: f64, other_min: f64, other_max: f64| min <= other_max && other_min <= max;
        meets(self.min.x, self.max.x, o.min.x, o.max.x)
            && meets(self.min.y, self.max.y, o.min.y, o.max.y)
            && meets(self.min.z, self.max.z, o.min.z, o.max.z)
    }

    /// The box with this much more on all sides.
    pub(crate) fn grown(self, by: f64) -> Self {
        let out = Vec3::new(by, by, by);
        Self { min: self.min + -out, max: self.max + out }
    }

    /// Distance from a point to the box, 0 inside.
    #[must_use]
    #[inline]
    pub fn distance(self, p: Point3) -> f64 {
        let out = |p: f64, lo: f64, hi: f64| (lo - p).max(p - hi).max(0.0);
        let (x, y, z) =
            (out(p.x, self.min.x, self.max.x), out(p.y, self.min.y, self.max.y), out(p.z, self.min.z, self.max.z));
        Vec3::new(x, y, z).length()
    }

    /// Length of the space diagonal: the size that relative measures refer to.
    #[must_use]
    #[inline]
    pub fn diagonal(self) -> f64 {
        (self.max - self.min).length()
    }

    /// Largest absolute coordinate.
    #[must_use]
    #[inline]
    pub fn max_abs(self) -> f64 {
        self.min.to_vec().max_abs().max(self.max.to_vec().max_abs())
    }
}
