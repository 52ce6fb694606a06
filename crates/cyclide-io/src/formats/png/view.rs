//! From model coordinates to pixels.

use super::axes::Rulers;
use super::canvas::Pixel;
use super::caption::Caption;
use super::eye::UP;
use super::sheet::Sheet;
use super::ticks::{multiples, round_step};
use cyclide::{Aabb, Point3, Vec3};

/// Room round the drawing, pixels of a picture of the usual width.
const MARGIN: f64 = 52.0;
/// The flattest drawing: height over width.
const SLIMMEST: f64 = 0.22;
/// The floor lies this far below the model and reaches this far beyond it, relative to its larger side.
const FLOOR_GAP: f64 = 0.04;
const FLOOR_RIM: f64 = 0.06;
/// Lines across the floor, about.
const FLOOR_LINES: f64 = 8.0;
/// From lower than this the floor is not drawn: it would be a line, or hide the model.
const FLOOR_SINE: f64 = 0.15;

/// A parallel projection fitted to the picture.
pub(super) struct View {
    axes: [Vec3; 3],
    /// Model units per pixel.
    unit: f64,
    /// Projected coordinates of the picture's upper left corner.
    corner: (f64, f64),
    pixels: (u32, u32),
    /// Nearest and farthest depth of the model.
    depths: (f64, f64),
    floor: Option<Floor>,
    /// What is shown, in projected coordinates.
    area: Aabb,
    /// The box round the model, down to the floor.
    frame: Aabb,
}

/// A rectangle below the model.
#[derive(Clone, Copy)]
pub(super) struct Floor {
    bounds: Aabb,
}

impl View {
    /// The view that shows the points on a sheet between the bands of its caption.
    pub(super) fn new(
        points: &[Point3],
        [right, up, toward]: [Vec3; 3],
        heights: bool,
        sheet: Sheet,
        caption: Option<&Caption>,
        rulers: Rulers,
    ) -> Self {
        let bounds = Aabb::of_points(points.iter().copied()).unwrap_or(Aabb::of_point(Point3::ORIGIN));
        let floor = (heights && toward.z > FLOOR_SINE && toward != UP).then(|| Floor::below_model(bounds));
        let frame = floor.map_or(bounds, |floor| {
            let (min, max) = (floor.bounds.min, floor.bounds.max);
            Aabb { min, max: Point3::new(max.x, max.y, bounds.max.z) }
        });
        let shown = match rulers {
            Rulers::Edges => corners(frame).to_vec(),
            Rulers::None | Rulers::Sides => floor.map_or(Vec::new(), |floor| floor.outline().to_vec()),
        };
        let flat = |p: &Point3| Point3::new(p.to_vec().dot(right), p.to_vec().dot(up), p.to_vec().dot(toward));
        let area = Aabb::of_points(points.iter().chain(&shown).map(flat)).unwrap_or(bounds);
        let depths = Aabb::of_points(points.iter().map(flat)).map_or((0.0, 0.0), |b| (b.min.z, b.max.z));

        let margin = MARGIN * sheet.scale;
        let [before, behind, under] = rulers.room().map(|room| room * sheet.scale);
        let (header, footer) = caption.map_or((0.0, 0.0), |c| (c.header(sheet), c.footer(sheet)));
        // The bands of the caption have room of their own towards the drawing.
        let (above, below) = if caption.is_some() { (0.35 * margin, 0.35 * margin) } else { (margin, margin) };
        let wide = sheet.width - 2.0 * margin - before - behind;
        let most = (wide, sheet.tallest() - header - footer - above - below - under);
        let (width, height) = (area.max.x - area.min.x, area.max.y - area.min.y);
        let unit = (width / most.0).max(height / most.1);
        let unit = if unit > 0.0 { unit } else { 1.0 / most.0 };
        let tall = if sheet.fixed { most.1 } else { (height / unit).max(SLIMMEST * most.0).min(most.1) };
        let pixels = (sheet.width as u32, (header + above + tall + under + below + footer).round() as u32);
        let middle = area.min.midpoint(area.max);
        let centre = (margin + before + 0.5 * most.0, header + above + 0.5 * tall);
        let corner = (middle.x - centre.0 * unit, middle.y + centre.1 * unit);
        Self { axes: [right, up, toward], unit, corner, pixels, depths, floor, area, frame }
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

    pub(super) fn floor(&self) -> Option<Floor> {
        self.floor
    }

    pub(super) fn axes(&self) -> [Vec3; 3] {
        self.axes
    }

    /// What is shown, in projected coordinates: right and up.
    pub(super) fn area(&self) -> Aabb {
        self.area
    }

    /// The box round the model, down to the floor.
    pub(super) fn frame(&self) -> Aabb {
        self.frame
    }

    /// The pixel of a point.
    pub(super) fn at(&self, p: Point3) -> Pixel {
        let v = p.to_vec();
        let (x, y) = self.flat_at(v.dot(self.axes[0]), v.dot(self.axes[1]));
        (x as f32, y as f32)
    }

    /// The pixel of projected coordinates.
    pub(super) fn flat_at(&self, x: f64, y: f64) -> (f64, f64) {
        ((x - self.corner.0) / self.unit, (self.corner.1 - y) / self.unit)
    }

    /// 0 for the farthest part of the model, 1 for the nearest.
    pub(super) fn depth(&self, p: Point3) -> f64 {
        let (far, near) = self.depths;
        if near > far { ((p.to_vec().dot(self.axes[2]) - far) / (near - far)).clamp(0.0, 1.0) } else { 1.0 }
    }
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
        let step = round_step((b.x - a.x).max(b.y - a.y) / FLOOR_LINES);
        let across = multiples(a.x, b.x, step).map(|x| [Point3::new(x, a.y, a.z), Point3::new(x, b.y, a.z)]);
        let along = multiples(a.y, b.y, step).map(|y| [Point3::new(a.x, y, a.z), Point3::new(b.x, y, a.z)]);
        across.chain(along).collect()
    }
}

/// The corners of a box.
pub(super) fn corners(frame: Aabb) -> [Point3; 8] {
    let (a, b) = (frame.min, frame.max);
    let pick = |upper: bool, low: f64, high: f64| if upper { high } else { low };
    std::array::from_fn(|k| {
        Point3::new(pick(k & 1 == 1, a.x, b.x), pick(k & 2 == 2, a.y, b.y), pick(k & 4 == 4, a.z, b.z))
    })
}
