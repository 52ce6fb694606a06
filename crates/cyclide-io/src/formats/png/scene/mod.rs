//! Pictures of surfaces: shaded, with their parameter circles, curves among them, and a shadow on the ground.
//!
//! Eight samples in a pixel say which facet of a fine mesh is seen; each facet seen is shaded once in a pixel, at the
//! middle of its samples, with the patch's own normal at the parameters of that place. Parameter circles are found
//! there too, as places where a parameter is near a multiple of its step, so they lie on the surface by construction.
//! Light is averaged before it is made a color of the screen.

mod blocks;
mod camera;
mod crosses;
mod facets;
pub(super) mod field;
mod ground;
mod light;
mod panels;
mod patch;
pub(super) mod quantity;
mod raster;
mod rows;
mod surface;
#[cfg(test)]
mod tests;
mod visible;

use crate::drawing::Combs;
use crate::drawing::palette::to_linear;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Promise, Written};
use crate::export::job::Job;
use crate::export::shape::Shape;
use crate::formats::png::axes::{self, Plan, Rulers};
use crate::formats::png::canvas::{Canvas, Ink, PAPER, picture};
use crate::formats::png::caption::Caption;
use crate::formats::png::colour_bar::ColourBar;
use crate::formats::png::legend::{self, Legend, Naming, balloon};
use crate::formats::png::names::Names;
use crate::formats::png::polyline::{FLATNESS, curves};
use crate::formats::png::sheet::Sheet;
use crate::formats::png::{eye, view};
use camera::Camera;
use cyclide::{Aabb, Point3, Vec3, mesh::SurfaceMesh};
use facets::{Facets, Paint};
use ground::Ground;
use light::{Lights, Rgb, screen};
use panels::{DrawnLabels, ObjectName, Panel, Seen};
use patch::{Patch, patches};
use quantity::Coloured;
use raster::{Band, NOTHING, SAMPLE_COUNT, sample_place};
use rows::side_by_side;
use surface::{Surface, surfaces};
use visible::Visible;

/// The meshes are this close to the surfaces, pixels.
const MESH: f64 = 0.25;

/// Draws a model with surfaces.
pub(super) fn write(job: &Job<'_>, sheet: Sheet, names: Names) -> Result<Exported, ExportError> {
    // Blocks are seen with their inside.
    let is_shape = |item: usize| job.model.items[item].volumes().is_empty();
    let mut shapes: Vec<&Shape<'_>> = job.bodies.iter().filter(|b| is_shape(b.item)).map(|b| &b.body).collect();
    let mut rough = facets::rough(&shapes);
    let mut points: Vec<Point3> = rough.iter().flatten().copied().collect();
    points.extend(blocks::points(job)?);
    points.extend(curves(job, 1e-3 * job.size())?.iter().flat_map(|c| c.points.iter().copied()));
    let bounds = Aabb::of_points(points.iter().copied()).ok_or(ExportError::Empty)?;
    let heights = bounds.max.z - bounds.min.z > 1e-6 * bounds.diagonal();
    let axes = match job.options.camera {
        Some(camera) => camera.axes(),
        None if heights => eye::from_side(&points, STEEPNESS),
        None => eye::from_above(),
    };
    let blocks = blocks::blocks(job, axes[2])?;
    if !blocks.is_empty() {
        shapes.extend(blocks.iter().flat_map(|own| &own.shapes));
        rough = facets::rough(&shapes);
    }
    let flat = job.options.camera.map_or(!heights, crate::export::camera::Camera::is_along_axis);
    let labels = job.options.png_labels;
    let naming = match legend::is_crowded(job) {
        true if labels => Naming::Names,
        true => Naming::Numbers,
        false => Naming::Colours,
    };
    let coloured = Coloured::new(job);
    let mut legend = Legend::new(job, &Combs::default(), &names.drawn, naming);
    if let Some(coloured) = &coloured {
        let bar = ColourBar::new(quantity::name(job.options.png_colour, job.units()), coloured.scale.clone());
        legend = legend.with_scale(job, bar, &names.drawn, coloured);
    }
    if labels {
        legend.remark(String::new());
    }
    let mut caption = Caption::new(job, legend);
    sheet.check_room(caption.as_ref())?;
    let rulers = match flat {
        _ if !job.options.png_axes || caption.is_none() => Rulers::None,
        true => Rulers::Sides,
        false => Rulers::Edges,
    };
    if rulers == Rulers::Edges {
        points.extend(view::corners(bounds));
    }
    let height = sheet.tallest();
    let (header, footer) = caption.as_ref().map_or((0.0, 0.0), |c| (c.header(sheet), c.footer(sheet)));
    let [before, behind, under] = rulers.room().map(|room| room * sheet.scale);
    let room = (sheet.width - before - behind, height - header - footer - under);
    let camera = Camera::new(&points, axes, flat, room).moved(before, header);
    let lights = Lights::new(camera.axes());
    let ground = (heights && axes[2].z > 0.0).then(|| Ground::new(&rough, bounds, &lights));

    let (mut drawn, mut patches_drawn) = (Vec::new(), Vec::new());
    let (mut items, mut patch_items) = (Vec::new(), Vec::new());
    let mut numbered: Vec<(u32, Panel)> = Vec::new();
    let mut facets = Facets::default();
    for body in job.bodies.iter().filter(|b| is_shape(b.item)) {
        if let Some(surface) = body.body.triangles() {
            let mesh = mesh_of(job, &body.body, camera.unit()).map_err(|source| body.unfit(source))?;
            facets.add_triangles(&mesh, patches_drawn.len(), &camera);
            patches_drawn.extend(patches(surface, body.item, sheet.scale));
            patch_items.resize(patches_drawn.len(), body.item);
        }
        let Some(faces) = body.body.faces() else { continue };
        let first = drawn.len();
        for shell in faces.shells() {
            drawn.extend(surfaces(shell, body.item, camera.unit(), sheet.scale));
        }
        items.resize(drawn.len(), body.item);
        if labels {
            numbered.extend(panels::panels(job, body.item, first, drawn.len() - first));
        }
        let mesh = mesh_of(job, &body.body, camera.unit()).map_err(|source| body.unfit(source))?;
        facets.add_body(faces, &mesh, first, &camera);
    }
    for own in &blocks {
        for (shell, shape) in own.cut.shells.iter().zip(&own.shapes) {
            let Some(faces) = shape.faces() else { continue };
            let first = drawn.len();
            drawn.extend(own.surfaces(shell, camera.unit(), sheet.scale));
            items.resize(drawn.len(), own.item);
            let mesh = mesh_of(job, shape, camera.unit());
            facets.add_body(faces, &mesh.map_err(|source| own.unfit(job, source))?, first, &camera);
        }
        for arc in &own.cut.taken {
            facets.add_dashes(arc, own.item, &camera, sheet.scale);
        }
    }
    for curve in curves(job, FLATNESS * camera.unit())? {
        facets.add_curve(&curve, &camera, sheet.scale);
    }
    let paper = to_linear(PAPER);
    let scene =
        Scene { camera, lights, ground, drawn, items, patches: patches_drawn, patch_items, facets, paper, coloured };
    let size = (sheet.width as usize, height as usize);
    let mut visible = Visible::new(size, 6.0 * sheet.scale);
    let mut seen = labels.then(|| Seen::new(size));
    let mut canvas = scene.draw(size, &mut visible, seen.as_mut())?;
    let Names { drawn: names, mut notes } = names;
    if let Some(caption) = &mut caption {
        let middle = bounds.min.midpoint(bounds.max);
        let unit = scene.camera.unit_at(middle);
        let note = if flat || !heights { "" } else { " at mid-depth" };
        scene.rulers(&mut canvas, rulers, (bounds, &points), sheet, job.units().symbol());
        notes.extend(visible.hidden_note(&names));
        if naming == Naming::Numbers {
            let places = visible.places(names.len());
            for (index, place) in places.into_iter().enumerate().take(caption.legend.numbers(sheet)) {
                if let Some(place) = place {
                    let ink = if is_shape(index) { Ink::object(index) } else { Ink::TEXT };
                    balloon(&mut canvas, place, index + 1, sheet, ink);
                }
            }
        }
        if let Some(seen) = &seen {
            let drawn = scene.labels(&names, (&visible, seen), &numbered, (sheet, [header, height - footer]));
            drawn.draw(&mut canvas);
            let said = drawn.said.join("; ");
            notes.extend((!said.is_empty()).then(|| said.clone()));
            caption.legend.remark(said);
        }
        caption.draw(&mut canvas, sheet, height, unit, note);
    }
    let bytes = canvas.encode().map_err(|e| picture(&e))?;
    // A picture has no parts that could be told apart.
    let written = Written { bodies: vec![Promise::proved(0.5 * scene.camera.unit())], ..Written::default() };
    Ok(written.exported(bytes, notes))
}

/// A mesh of a shape. Where one that is near enough has too many pieces, because a few of its patches bend sharply or pass near infinity,
/// coarser ones serve: the light is that of the surface all the same.
fn mesh_of(job: &Job<'_>, shape: &Shape<'_>, unit: f64) -> cyclide::Result<SurfaceMesh> {
    let mut made = job.pieces.tessellate(shape, MESH * unit);
    for coarser in [4.0, 16.0, 64.0] {
        if !made.as_ref().is_err_and(|error| error.reason() == "too-many-pieces") {
            break;
        }
        made = job.pieces.tessellate(shape, coarser * MESH * unit);
    }
    made
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
    /// The object of each surface.
    items: Vec<usize>,
    patches: Vec<Patch>,
    /// The object of each patch.
    patch_items: Vec<usize>,
    facets: Facets,
    paper: Rgb,
    /// The quantity that surfaces are colored by.
    coloured: Option<Coloured<'a>>,
}

impl Scene<'_> {
    fn draw(
        &self,
        (width, height): (usize, usize),
        visible: &mut Visible,
        mut seen: Option<&mut Seen>,
    ) -> Result<Canvas, ExportError> {
        let mut canvas = Canvas::new(width as u32, height as u32).ok_or_else(|| picture("its size is zero"))?;
        let table = Screen::new();
        raster::bands(&self.facets.corners, (width, height), |band| {
            let band: &Band = band;
            let shade = |row| (0..width).map(|x| self.pixel(band, x, row).map(|c| table.byte(c))).collect::<Vec<_>>();
            for (row, colours) in side_by_side(band.rows, shade).into_iter().enumerate() {
                for (x, colour) in colours.into_iter().enumerate() {
                    canvas.set(x, band.top + row, colour);
                    visible.add(x, band.top + row, self.object(band.seen(x, row)[0]));
                    if let Some(seen) = &mut seen {
                        seen.set(x, band.top + row, self.surface(band.seen(x, row)[0]));
                    }
                }
            }
        });
        Ok(canvas)
    }

    /// The face that a facet belongs to.
    fn surface(&self, facet: u32) -> Option<usize> {
        match self.facets.paints.get(facet as usize)? {
            Paint::Surface { surface, .. } => Some(*surface),
            _ => None,
        }
    }

    /// Names of objects, if there are several, and numbers of panels.
    fn labels(
        &self,
        names: &[String],
        (visible, seen): (&Visible, &Seen),
        numbered: &[(u32, Panel)],
        (sheet, [top, bottom]): (Sheet, [f64; 2]),
    ) -> DrawnLabels {
        let mut drawn = DrawnLabels::default();
        // Where colors stand for values they are no colors of objects.
        let ink = |k: usize| if self.coloured.is_some() { Ink::TEXT } else { Ink::object(k) };
        let named: Vec<ObjectName<'_>> = names
            .iter()
            .zip(visible.places(names.len()))
            .enumerate()
            .filter(|(_, (name, _))| names.len() > 1 && !name.is_empty())
            .map(|(k, (name, place))| ObjectName { ink: ink(k), name, place })
            .collect();
        let margin = 0.4 * sheet.margin();
        drawn.add_names(sheet, [margin, top, sheet.width - margin, bottom], &named);
        let middle = |(surface, panel): &(u32, Panel)| {
            let at = self.camera.project(panels::middle(&self.drawn[*surface as usize]));
            (*surface, *panel, (at.x, at.y))
        };
        drawn.add_panels(sheet, seen, &numbered.iter().map(middle).collect::<Vec<_>>());
        drawn
    }

    /// The object that a facet belongs to.
    fn object(&self, facet: u32) -> Option<usize> {
        match self.facets.paints.get(facet as usize)? {
            Paint::Ink { object, .. } | Paint::Smooth { object, .. } => Some(*object),
            Paint::Surface { surface, .. } => self.items.get(*surface).copied(),
            Paint::Patch { patch, .. } => self.patch_items.get(*patch).copied(),
        }
    }

    fn rulers(
        &self,
        canvas: &mut Canvas,
        rulers: Rulers,
        (bounds, points): (Aabb, &[Point3]),
        sheet: Sheet,
        symbol: &str,
    ) {
        let pixel = |p: Point3| {
            let seen = self.camera.project(p);
            (seen.x, seen.y)
        };
        let axes = self.camera.axes();
        match rulers {
            Rulers::None => {}
            Rulers::Edges => axes::edge_rulers(canvas, bounds, self.camera.eye(), &pixel, sheet, symbol),
            Rulers::Sides => {
                // The plane of the drawing is at the middle of the model's depth.
                let flat = |p: &Point3| Point3::from(axes.map(|axis| p.to_vec().dot(axis)));
                let area = Aabb::of_points(points.iter().map(flat)).unwrap_or(bounds);
                let depth = 0.5 * (area.min.z + area.max.z);
                let at = |x: f64, y: f64| pixel(Point3::ORIGIN + axes[0] * x + axes[1] * y + axes[2] * depth);
                let unit = self.camera.unit_at(bounds.min.midpoint(bounds.max));
                axes::rulers(canvas, &Plan { axes, area, unit, at: &at, symbol }, sheet, false);
            }
        }
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
            Paint::Ink { light, .. } => *light,
            Paint::Surface { surface, at } => {
                let item = self.items[*surface];
                let (surface, ray) = (&self.drawn[*surface], self.camera.ray(x, y));
                let rough = facets::parameters(&self.facets.corners[facet as usize], at, x, y);
                let (at, slope) = surface.settle(rough, at, ray, &self.camera);
                match &self.coloured {
                    None => surface.colour(at, slope, -ray, &self.lights),
                    Some(coloured) => {
                        let tint = coloured.tint(item, surface, at).unwrap_or_else(|| to_linear(quantity::WITHOUT));
                        surface.tinted((at, slope), -ray, &self.lights, tint)
                    }
                }
            }
            Paint::Smooth { normals, tint, .. } => {
                let ray = self.camera.ray(x, y);
                let (at, _) = facets::parameters(&self.facets.corners[facet as usize], &facets::CORNERS, x, y);
                let normal = normals.iter().zip(at).fold(Vec3::ZERO, |sum, (n, part)| sum + *n * part);
                let normal = normal.unit().unwrap_or(-ray);
                self.lights.shade(*tint, if normal.dot(ray) > 0.0 { -normal } else { normal }, -ray)
            }
            Paint::Patch { patch, at } => {
                let ray = self.camera.ray(x, y);
                let (at, slope) = facets::parameters(&self.facets.corners[facet as usize], at, x, y);
                let grey = self.coloured.as_ref().map(|_| to_linear(quantity::WITHOUT));
                self.patches[*patch].colour((at, slope), -ray, &self.lights, grey)
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
