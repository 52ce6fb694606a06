//! Pictures of surfaces: shaded, with their parameter circles, curves among them, and a shadow on the ground.
//!
//! Eight samples in a pixel say which facet of a fine mesh is seen; each facet seen is shaded once in a pixel, at the
//! middle of its samples, with the patch's own normal at the parameters of that place. Parameter circles are found
//! there too, as places where a parameter is near a multiple of its step, so they lie on the surface by construction.
//! Light is averaged before it is made a colour of the screen.

mod camera;
mod facets;
mod ground;
mod light;
mod raster;
mod surface;
#[cfg(test)]
mod tests;

use super::{FLATNESS, UP, curves, picture};
use crate::drawing::Combs;
use crate::export_error::ExportError;
use crate::exported::{Exported, Promise};
use crate::job::Job;
use crate::palette::to_linear;
use crate::png::canvas::{Canvas, PAPER};
use crate::png::sheet::{Caption, Sheet};
use crate::png::{axes, view};
use camera::Camera;
use cyclide::{Aabb, Exactness, Point3};
use facets::{Facets, Paint};
use ground::Ground;
use light::{Lights, Rgb, screen};
use raster::{Band, NOTHING, SAMPLE_COUNT, sample_place};
use surface::{Surface, surfaces};

/// The meshes are this close to the surfaces, pixels.
const MESH: f64 = 0.25;

/// Draws a model with surfaces.
pub(super) fn write(job: &Job<'_>, sheet: Sheet) -> Result<Exported, ExportError> {
    let rough = facets::rough(job);
    let mut points: Vec<Point3> = rough.iter().flatten().copied().collect();
    points.extend(curves(job, 1e-3 * job.size())?.iter().flat_map(|c| c.points.iter().copied()));
    let bounds = Aabb::of_points(points.iter().copied()).ok_or(ExportError::Empty)?;
    let heights = bounds.max.z - bounds.min.z > 1e-6 * bounds.diagonal();
    let axes = match job.options.camera {
        Some(camera) => camera.axes(),
        None if heights => view::from_side(&points, STEEPNESS),
        None => view::from_above(),
    };
    let flat = job.options.camera.is_some_and(crate::Camera::is_along_axis);
    let caption = Caption::new(job, &Combs::default());
    let height = sheet.tallest();
    let (header, footer) = caption.as_ref().map_or((0.0, 0.0), |c| (c.header(sheet), c.footer(sheet)));
    let room = (sheet.width, height - header - footer);
    let camera = Camera::new(&points, axes, flat, room).below(header);
    let lights = Lights::new(camera.axes());
    let ground = (heights && axes[2].z > 0.0).then(|| Ground::new(&rough, bounds, &lights));

    let mut drawn = Vec::new();
    let mut facets = Facets::default();
    for body in job.bodies {
        let first = drawn.len();
        for shell in body.body.shells() {
            drawn.extend(surfaces(shell, body.item, camera.unit(), sheet.scale));
        }
        let added = facets.add_body(&body.body, first, &camera, MESH * camera.unit());
        added.map_err(|source| body.unfit(source))?;
    }
    for curve in curves(job, FLATNESS * camera.unit())? {
        facets.add_curve(&curve, &camera, sheet.scale);
    }
    let scene = Scene { camera, lights, ground, drawn, facets, paper: to_linear(PAPER) };
    let mut canvas = scene.draw((sheet.width as usize, height as usize))?;
    if let Some(caption) = caption {
        let unit = scene.camera.unit_at(bounds.min.midpoint(bounds.max));
        let note = if flat || !heights { "" } else { " at mid-depth" };
        caption.draw(&mut canvas, sheet, height, unit, note);
        if job.options.png_axes {
            axes::arrows(&mut canvas, axes, sheet, height - footer);
        }
    }
    let bytes = canvas.encode().map_err(|e| picture(&e))?;
    let mut promise = Promise::EXACT;
    promise.add(Exactness::Proved(0.5 * scene.camera.unit()));
    Ok(promise.exported(bytes, Vec::new(), Vec::new()))
}

/// Height of the eye over its horizontal distance is this over 0.94.
const STEEPNESS: f64 = 0.5;

/// How much of each primary a shadow takes.
const SHADOW: Rgb = [1.03, 1.0, 0.95];

struct Scene<'a> {
    camera: Camera,
    lights: Lights,
    ground: Option<Ground>,
    drawn: Vec<Surface<'a>>,
    facets: Facets,
    paper: Rgb,
}

impl Scene<'_> {
    fn draw(&self, (width, height): (usize, usize)) -> Result<Canvas, ExportError> {
        let mut canvas = Canvas::new(width as u32, height as u32).ok_or_else(|| picture("it has no size"))?;
        let table = Screen::new();
        raster::bands(&self.facets.corners, (width, height), |band| {
            for row in 0..band.rows {
                for x in 0..width {
                    let colour = self.pixel(band, x, row);
                    canvas.set(x, band.top + row, colour.map(|c| table.byte(c)));
                }
            }
        });
        Ok(canvas)
    }

    /// The mean light of a pixel.
    fn pixel(&self, band: &Band, x: usize, row: usize) -> Rgb {
        let seen = band.seen(x, row);
        let y = band.top + row;
        let mut sum = [0.0; 3];
        let mut done = [false; SAMPLE_COUNT];
        for first in 0..SAMPLE_COUNT {
            if done[first] {
                continue;
            }
            let (mut count, mut px, mut py) = (0.0, 0.0, 0.0);
            for k in first..SAMPLE_COUNT {
                if seen[k] == seen[first] {
                    done[k] = true;
                    let (sx, sy) = sample_place(k, x, y);
                    (count, px, py) = (count + 1.0, px + sx, py + sy);
                }
            }
            let light = self.light(seen[first], px / count, py / count);
            for (s, l) in sum.iter_mut().zip(light) {
                *s += l * count / SAMPLE_COUNT as f64;
            }
        }
        sum
    }

    /// What is seen at a place of the picture where the facet is in front.
    fn light(&self, facet: u32, x: f64, y: f64) -> Rgb {
        if facet == NOTHING {
            let kept = self.ground.as_ref().map_or(1.0, |g| g.light(self.camera.eye(), self.camera.ray(x, y)));
            // The shadow is a little cool, like the sky that still lights it.
            return std::array::from_fn(|k| self.paper[k] * (1.0 - (1.0 - kept) * SHADOW[k]));
        }
        match &self.facets.paints[facet as usize] {
            Paint::Ink(ink) => *ink,
            Paint::Surface { surface, at } => {
                let (surface, ray) = (&self.drawn[*surface], self.camera.ray(x, y));
                let rough = facets::parameters(&self.facets.corners[facet as usize], at, x, y);
                let (at, slope) = surface.settle(rough, at, ray, &self.camera);
                surface.colour(at, slope, -ray, &self.lights)
            }
        }
    }
}

/// A table from linear light to bytes, finer than a step of the screen.
struct Screen {
    bytes: Vec<u8>,
}

impl Screen {
    const STEPS: f64 = 16383.0;

    fn new() -> Self {
        let byte = |i: u32| (255.0 * screen(f64::from(i) / Self::STEPS)).round() as u8;
        Self { bytes: (0..=Self::STEPS as u32).map(byte).collect() }
    }

    fn byte(&self, light: f64) -> u8 {
        self.bytes[(light.clamp(0.0, 1.0) * Self::STEPS).round() as usize]
    }
}
