//! The camera: perspective, fitted to the model.

use cyclide::{Point3, Vec3};

/// Half the angle of view over the picture's height is 21.5 degrees; its tangent.
const HALF_HEIGHT: f64 = 0.393_910_475_614_942;
/// The lens of views along an axis, which are drawings: so long that parallel lines stay so to a pixel or two.
const LONG: f64 = 200.0;
/// Part of the picture's half width and half height that the model may fill.
const FILLED: f64 = 0.92;
/// The nearest point of the model is at least this far before the eye, relative to the model's size.
const NEAREST: f64 = 0.05;

/// A point in the picture: pixels to the right and down, and the inverse of its depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Projected {
    pub(super) x: f64,
    pub(super) y: f64,
    /// One over the distance before the eye along the view, in units of the model's size: greater is nearer, and it is
    /// linear in the picture.
    pub(super) near: f64,
}

/// A perspective view of points, exact to the picture's margin.
#[derive(Debug, Clone)]
pub(super) struct Camera {
    right: Vec3,
    up: Vec3,
    toward: Vec3,
    eye: Point3,
    /// Size of the model: the unit of depth.
    size: f64,
    /// Pixels per unit of slope.
    focal: f64,
    middle: (f64, f64),
    /// How much longer than usual the lens is.
    lens: f64,
    /// Greatest inverse depth.
    nearest: f64,
}

impl Camera {
    /// The view along the axes (right, up, toward the eye) in which the points fill a picture of so many pixels, without
    /// perspective if `flat`.
    ///
    /// A point `(x, y, z)` in the axes right, up, toward is in the picture of an eye at `(a, b, c)` where
    /// `|x - a| <= h (c - z)` and the same for y. So the least `c` that width asks for is
    /// `(max(x + h z) + max(h z - x))/(2h)`, with `a` half the difference of these maxima; the height alike.
    pub(super) fn new(
        points: &[Point3],
        [right, up, toward]: [Vec3; 3],
        flat: bool,
        (width, height): (f64, f64),
    ) -> Self {
        let lens = if flat { LONG } else { 1.0 };
        let half_height = HALF_HEIGHT / lens;
        let origin = points.first().copied().unwrap_or(Point3::ORIGIN);
        let (v, h) = (FILLED * half_height, FILLED * half_height * width / height);
        let mut most = [f64::NEG_INFINITY; 4];
        let (mut front, mut reach) = (f64::NEG_INFINITY, 0.0f64);
        for p in points {
            let d = *p - origin;
            let (x, y, z) = (d.dot(right), d.dot(up), d.dot(toward));
            for (m, value) in most.iter_mut().zip([h * z + x, h * z - x, v * z + y, v * z - y]) {
                *m = m.max(value);
            }
            front = front.max(z);
            reach = reach.max(d.max_abs());
        }
        let size = if reach > 0.0 { reach } else { 1.0 };
        if points.is_empty() {
            (most, front) = ([0.0; 4], 0.0);
        }
        let distance = ((most[0] + most[1]) / (2.0 * h)).max((most[2] + most[3]) / (2.0 * v));
        let distance = distance.max(front + NEAREST * size);
        let aside = right * (0.5 * (most[0] - most[1])) + up * (0.5 * (most[2] - most[3]));
        Self {
            right,
            up,
            toward,
            eye: origin + aside + toward * distance,
            size,
            focal: 0.5 * height / half_height,
            middle: (0.5 * width, 0.5 * height),
            lens,
            nearest: size / (distance - front),
        }
    }

    /// The same view on a larger picture, whose upper left corner is so far to the left of the old one and above it.
    pub(super) fn moved(self, right: f64, down: f64) -> Self {
        Self { middle: (self.middle.0 + right, self.middle.1 + down), ..self }
    }

    /// The part of its distance by which something drawn on a surface is lifted off it.
    pub(super) fn lift(&self, part: f64) -> f64 {
        part / self.lens
    }

    /// Model units per pixel as far away as a point.
    pub(super) fn unit_at(&self, p: Point3) -> f64 {
        self.size / (self.project(p).near * self.focal)
    }

    /// Model units per pixel at the nearest point.
    pub(super) fn unit(&self) -> f64 {
        self.size / (self.nearest * self.focal)
    }

    pub(super) fn project(&self, p: Point3) -> Projected {
        let d = (p - self.eye) / self.size;
        let near = -1.0 / d.dot(self.toward);
        let scale = self.focal * near;
        Projected { x: self.middle.0 + scale * d.dot(self.right), y: self.middle.1 - scale * d.dot(self.up), near }
    }

    /// The unit direction from the eye through a place in the picture.
    pub(super) fn ray(&self, x: f64, y: f64) -> Vec3 {
        let ray = self.right * (x - self.middle.0) - self.up * (y - self.middle.1) - self.toward * self.focal;
        ray.unit().unwrap_or(-self.toward)
    }

    /// How far a point so far from the eye moves from pixel to pixel, to the right and up.
    pub(super) fn steps(&self, from_eye: Vec3) -> [Vec3; 2] {
        let step = -from_eye.dot(self.toward) / self.focal;
        [self.right * step, self.up * step]
    }

    pub(super) fn eye(&self) -> Point3 {
        self.eye
    }

    /// Right, up and toward the eye: unit vectors.
    pub(super) fn axes(&self) -> [Vec3; 3] {
        [self.right, self.up, self.toward]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_model_fills_the_picture() {
        let corner = |k: u32| Point3::new(f64::from(k & 1), f64::from(k >> 1 & 1) * 3.0, f64::from(k >> 2) * 0.5);
        let points: Vec<Point3> = (0..8).map(corner).collect();
        let toward = Vec3::new(0.5, -0.8, 0.5).unit().unwrap();
        let right = Vec3::Z.cross(toward).unit().unwrap();
        let camera = Camera::new(&points, [right, toward.cross(right), toward], false, (1600.0, 1200.0));
        let seen: Vec<Projected> = points.iter().map(|p| camera.project(*p)).collect();
        let range =
            |f: fn(&Projected) -> f64| seen.iter().map(f).fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(v), b.max(v)));
        let ((left, right), (top, bottom)) = (range(|p| p.x), range(|p| p.y));
        let (width, height) = (FILLED * 1600.0, FILLED * 1200.0);
        // One direction is filled, both are centered, to rounding.
        assert!((right - left - width).abs() < 1e-6 || (bottom - top - height).abs() < 1e-6);
        assert!(right - left < width + 1e-6 && bottom - top < height + 1e-6);
        assert!(left > 0.0 && top > 0.0 && right < 1600.0 && bottom < 1200.0);
        for (p, q) in points.iter().zip(&seen) {
            let along = (*p - camera.eye()).unit().unwrap();
            assert!(along.cross(camera.ray(q.x, q.y)).length() < 1e-12);
        }
    }
}
