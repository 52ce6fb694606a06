//! From model coordinates to pixels.

use super::UP;
use cyclide::{Aabb, Point3, Vec3};

/// Margin round the drawing, relative to its larger side.
const MARGIN: f64 = 0.06;
/// Flattest picture: height over width, and the other way round.
const SLIMMEST: f64 = 0.3;
/// Where a model with heights is looked at from, in order of preference: front right, front left, and turned further.
const EYES: [(f64, f64); 6] = [(0.5, -0.8), (-0.5, -0.8), (0.92, -0.2), (-0.92, -0.2), (0.2, -0.92), (-0.2, -0.92)];
/// Height of the eye that goes with these.
const STEEPNESS: f64 = 0.55;
/// A view is left for a later one only if that shows this much more.
const BETTER: f64 = 1.5;
/// The floor lies this far below the model and reaches this far beyond it, relative to its larger side.
const FLOOR_GAP: f64 = 0.04;
const FLOOR_RIM: f64 = 0.06;
/// Lines across the floor, about.
const FLOOR_LINES: f64 = 8.0;

/// A parallel projection fitted to the picture.
pub(super) struct View {
    right: Vec3,
    up: Vec3,
    toward: Vec3,
    /// Model units per pixel.
    unit: f64,
    /// Projected coordinates of the picture's upper left corner.
    corner: (f64, f64),
    pixels: (u32, u32),
    /// Nearest and farthest depth of the model.
    depths: (f64, f64),
    floor: Floor,
}

/// A rectangle below the model.
#[derive(Clone, Copy)]
pub(super) struct Floor {
    bounds: Aabb,
}

impl View {
    /// From above, or from the side and above if there are heights; `largest` is the largest picture.
    pub(super) fn new(points: impl Iterator<Item = Point3>, heights: bool, largest: (f64, f64)) -> Self {
        let points: Vec<Point3> = points.collect();
        let toward = if heights { eye(&points, STEEPNESS) } else { UP };
        let right = if heights { UP.cross(toward).unit().unwrap_or(Vec3::X) } else { Vec3::X };
        let up = toward.cross(right);
        let bounds = Aabb::of_points(points.iter().copied()).unwrap_or(Aabb::of_point(Point3::ORIGIN));
        let floor = Floor::below_model(bounds);
        let shown = if heights { floor.outline().to_vec() } else { Vec::new() };
        let flat = |p: &Point3| Point3::new(p.to_vec().dot(right), p.to_vec().dot(up), p.to_vec().dot(toward));
        let area = Aabb::of_points(points.iter().chain(&shown).map(flat)).unwrap_or(bounds);
        let depths = Aabb::of_points(points.iter().map(flat)).map_or((0.0, 0.0), |b| (b.min.z, b.max.z));

        let (width, height) = (area.max.x - area.min.x, area.max.y - area.min.y);
        let side = if width.max(height) > 0.0 { width.max(height) } else { 1.0 };
        let margin = 2.0 * MARGIN * side;
        let (width, height) = ((width + margin).max(SLIMMEST * (height + margin)), height + margin);
        let height = height.max(SLIMMEST * width);
        let unit = (width / largest.0).max(height / largest.1);
        let middle = area.min.midpoint(area.max);
        Self {
            right,
            up,
            toward,
            unit,
            corner: (middle.x - 0.5 * width, middle.y + 0.5 * height),
            pixels: ((width / unit).round() as u32, (height / unit).round() as u32),
            depths,
            floor,
        }
    }

    /// Width of the picture.
    pub(super) fn width(&self) -> u32 {
        self.pixels.0
    }

    /// Height of the picture.
    pub(super) fn height(&self) -> u32 {
        self.pixels.1
    }

    /// Model units per pixel.
    pub(super) fn unit(&self) -> f64 {
        self.unit
    }

    pub(super) fn floor(&self) -> Floor {
        self.floor
    }

    /// The pixel of a point.
    pub(super) fn at(&self, p: Point3) -> (f32, f32) {
        let v = p.to_vec();
        let (x, y) = (v.dot(self.right) - self.corner.0, self.corner.1 - v.dot(self.up));
        ((x / self.unit) as f32, (y / self.unit) as f32)
    }

    /// 0 for the farthest part of the model, 1 for the nearest.
    pub(super) fn depth(&self, p: Point3) -> f64 {
        let (far, near) = self.depths;
        if near > far { ((p.to_vec().dot(self.toward) - far) / (near - far)).clamp(0.0, 1.0) } else { 1.0 }
    }
}

/// The direction to look from: a curve close to a plane must not be seen edge on.
pub(super) fn eye(points: &[Point3], steepness: f64) -> Vec3 {
    let mut best = (UP, 0.0);
    for eye in EYES.into_iter().filter_map(|(x, y)| Vec3::new(x, y, steepness).unit()) {
        let spread = spread(points, eye);
        if best.0 == UP || spread > BETTER * best.1 {
            best = (eye, spread);
        }
    }
    best.0
}

/// How broad the points look: the smaller axis of their ellipse of inertia in the view.
fn spread(points: &[Point3], toward: Vec3) -> f64 {
    let right = UP.cross(toward).unit().unwrap_or(Vec3::X);
    let up = toward.cross(right);
    let first = points.first().copied().unwrap_or(Point3::ORIGIN);
    let flat = points.iter().map(|p| ((*p - first).dot(right), (*p - first).dot(up)));
    let n = points.len().max(1) as f64;
    let (x, y) = flat.clone().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / n, b + y / n));
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for (u, v) in flat {
        let (u, v) = (u - x, v - y);
        (xx, xy, yy) = (xx + u * u, xy + u * v, yy + v * v);
    }
    let least = 0.5 * (xx + yy - (xx - yy).hypot(2.0 * xy));
    (least.max(0.0) / n).sqrt()
}

impl Floor {
    fn below_model(bounds: Aabb) -> Self {
        let extent = bounds.max - bounds.min;
        let side = extent.max_abs();
        let rim = Vec3::new(FLOOR_RIM * side, FLOOR_RIM * side, 0.0);
        let (mut min, mut max) = (bounds.min - rim, bounds.max + rim);
        let z = bounds.min.z - FLOOR_GAP * side;
        (min.z, max.z) = (z, z);
        Self { bounds: Aabb { min, max } }
    }

    /// The corners in order.
    pub(super) fn outline(&self) -> [Point3; 4] {
        let (a, b) = (self.bounds.min, self.bounds.max);
        [a, Point3::new(b.x, a.y, a.z), b, Point3::new(a.x, b.y, a.z)]
    }

    /// The point of the floor below a point.
    pub(super) fn below(&self, p: Point3) -> Point3 {
        Point3::new(p.x, p.y, self.bounds.min.z)
    }

    /// Lines at round coordinates, along both axes.
    pub(super) fn lines(&self) -> Vec<[Point3; 2]> {
        let (a, b) = (self.bounds.min, self.bounds.max);
        let rough = (b.x - a.x).max(b.y - a.y) / FLOOR_LINES;
        let decade = 10_f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * decade).find(|s| *s >= rough).unwrap_or(rough);
        let between = |low: f64, high: f64| {
            let count = ((high - low) / step) as usize + 1;
            let first = (low / step).ceil() * step;
            (0..count).map(move |i| first + step * i as f64).filter(move |v| *v <= high)
        };
        let across = between(a.x, b.x).map(|x| [Point3::new(x, a.y, a.z), Point3::new(x, b.y, a.z)]);
        let along = between(a.y, b.y).map(|y| [Point3::new(a.x, y, a.z), Point3::new(b.x, y, a.z)]);
        across.chain(along).collect()
    }
}
