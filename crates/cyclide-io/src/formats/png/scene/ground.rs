//! The shadow on the ground below a model: soft, from a broad light and the sky.

use super::light::Lights;
use crate::formats::png::eye::UP;
use cyclide::{Aabb, Point3, Vec3};

/// Cells along the longer side of the shadow's map.
const CELLS: f64 = 360.0;
/// The map reaches this far beyond the model, relative to its size.
const RIM: f64 = 0.55;
/// Part of the map's longer side over which the shadow fades out at its rim.
const FADE: f64 = 0.15;
/// Directions towards the broad light and towards the sky.
const LIGHT_RAYS: usize = 32;
const SKY_RAYS: usize = 40;
/// Sine of the broad light's half angle; of the sky's, low rays left out.
const LIGHT_SPREAD: f64 = 0.2;
const SKY_SPREAD: f64 = 0.9;
/// How much of the ground's brightness each of them takes where it is hidden.
const LIGHT_SHARE: f64 = 0.26;
const SKY_SHARE: f64 = 0.36;
/// Width of the smoothing that hides the single rays, cells to each side, done three times.
const SMOOTHING: usize = 3;

/// A map of the light that the model keeps from the ground.
pub(super) struct Ground {
    height: f64,
    corner: (f64, f64),
    cell: f64,
    columns: usize,
    rows: usize,
    /// Part of the light that is missing, cell by cell.
    dark: Vec<f32>,
}

impl Ground {
    /// The ground at the lowest point of the triangles.
    pub(super) fn new(triangles: &[[Point3; 3]], bounds: Aabb, lights: &Lights) -> Self {
        let (a, b) = (bounds.min, bounds.max);
        let rim = RIM * (b - a).max_abs();
        let (width, depth) = (b.x - a.x + 2.0 * rim, b.y - a.y + 2.0 * rim);
        let cell = width.max(depth) / CELLS;
        let count = |length: f64| (length / cell).ceil().clamp(1.0, CELLS) as usize;
        let (columns, rows) = (count(width), count(depth));
        let corner = (a.x - rim, a.y - rim);
        let mut ground = Self { height: a.z, corner, cell, columns, rows, dark: vec![0.0; columns * rows] };
        let mut hidden = vec![0u32; columns * rows];
        let broad = cone(lights.key, LIGHT_SPREAD, LIGHT_RAYS).map(|d| (d, LIGHT_SHARE / LIGHT_RAYS as f64));
        let sky = cone(UP, SKY_SPREAD, SKY_RAYS).map(|d| (d, SKY_SHARE / SKY_RAYS as f64));
        for (k, (ray, share)) in broad.chain(sky).enumerate() {
            for triangle in triangles {
                ground.hide(triangle, ray, share as f32, k as u32 + 1, &mut hidden);
            }
        }
        ground.smooth();
        ground
    }

    /// Darkens the cells that the triangle hides from a direction; `hidden` tells which it has darkened before.
    fn hide(&mut self, triangle: &[Point3; 3], ray: Vec3, share: f32, mark: u32, hidden: &mut [u32]) {
        let p = triangle.map(|p| {
            let above = (p.z - self.height) / ray.z;
            ((p.x - above * ray.x - self.corner.0) / self.cell, (p.y - above * ray.y - self.corner.1) / self.cell)
        });
        let (top, bottom) = p.iter().fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(v.1), b.max(v.1)));
        let first = (top - 0.5).ceil().max(0.0);
        let last = (bottom - 0.5).floor().min(self.rows as f64 - 1.0);
        if !(first <= last) {
            return;
        }
        for row in first as usize..=last as usize {
            let y = row as f64 + 0.5;
            let (mut from, mut to) = (f64::MAX, f64::MIN);
            for (a, b) in [(p[0], p[1]), (p[1], p[2]), (p[2], p[0])] {
                if (a.1 <= y) != (b.1 <= y) {
                    let x = a.0 + (b.0 - a.0) * ((y - a.1) / (b.1 - a.1));
                    (from, to) = (from.min(x), to.max(x));
                }
            }
            let from = (from - 0.5).ceil().max(0.0);
            let to = (to - 0.5).floor().min(self.columns as f64 - 1.0);
            if !(from <= to) {
                continue;
            }
            let cells = row * self.columns + from as usize..=row * self.columns + to as usize;
            for (mark_of, dark) in hidden[cells.clone()].iter_mut().zip(&mut self.dark[cells]) {
                if *mark_of != mark {
                    *mark_of = mark;
                    *dark += share;
                }
            }
        }
    }

    fn smooth(&mut self) {
        let (columns, rows) = (self.columns, self.rows);
        let mut line = Vec::new();
        for _ in 0..3 {
            for row in 0..rows {
                smooth_line(&mut self.dark, row * columns, 1, columns, &mut line);
            }
            for column in 0..columns {
                smooth_line(&mut self.dark, column, columns, rows, &mut line);
            }
        }
    }

    /// The part of its light that the ground keeps where a ray from the eye meets it; 1 beyond the map.
    pub(super) fn light(&self, eye: Point3, ray: Vec3) -> f64 {
        let distance = (self.height - eye.z) / ray.z;
        if !(ray.z < 0.0 && distance > 0.0) {
            return 1.0;
        }
        let place = |v: f64, corner: f64| (v - corner) / self.cell - 0.5;
        let x = place(eye.x + distance * ray.x, self.corner.0);
        let y = place(eye.y + distance * ray.y, self.corner.1);
        if !(x >= 0.0 && y >= 0.0 && x < (self.columns - 1) as f64 && y < (self.rows - 1) as f64) {
            return 1.0;
        }
        let (i, j) = (x as usize, y as usize);
        let (u, v) = (x - i as f64, y - j as f64);
        let at = |i: usize, j: usize| f64::from(self.dark[j * self.columns + i]);
        let along = |j: usize| at(i, j) * (1.0 - u) + at(i + 1, j) * u;
        // Towards the rim of the map the shadow fades out.
        let inside = |v: f64, count: usize| (v.min(count as f64 - 1.0 - v) / (FADE * CELLS)).min(1.0);
        let kept = inside(x, self.columns) * inside(y, self.rows);
        1.0 - kept * (along(j) * (1.0 - v) + along(j + 1) * v)
    }
}

/// Evenly spread directions about an axis, out to the given sine from it: a golden spiral in the disc.
fn cone(axis: Vec3, spread: f64, count: usize) -> impl Iterator<Item = Vec3> {
    let u = axis.any_perpendicular().unit().unwrap_or(Vec3::X);
    let v = axis.cross(u);
    (0..count).map(move |i| {
        let sine = spread * ((i as f64 + 0.5) / count as f64).sqrt();
        let (b, a) = (i as f64 * 2.399_963_229_728_653).sin_cos();
        u * (sine * a) + v * (sine * b) + axis * (1.0 - sine * sine).sqrt()
    })
}

/// Replaces the values of a line by means over their neighbors; those beyond the ends count as 0.
fn smooth_line(values: &mut [f32], start: usize, step: usize, count: usize, line: &mut Vec<f32>) {
    line.clear();
    line.extend((0..count).map(|i| values[start + i * step]));
    let width = (2 * SMOOTHING + 1) as f32;
    for i in 0..count {
        let near = &line[i.saturating_sub(SMOOTHING)..(i + SMOOTHING + 1).min(count)];
        values[start + i * step] = near.iter().sum::<f32>() / width;
    }
}
