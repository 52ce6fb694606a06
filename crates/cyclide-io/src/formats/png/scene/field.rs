//! Pictures of the lines of curvature of a surface: the mesh that was given, a cross along the two directions here and there, umbilics,
//! and the grids that were laid.

use super::camera::Camera;
use super::crosses::{crosses, middle};
use super::facets::{Facets, Paint};
use super::ground::Ground;
use super::light::Lights;
use super::visible::Visible;
use super::{STEEPNESS, Scene};
use crate::drawing::palette::to_linear;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Promise, Written};
use crate::export::given_surface::LaidField;
use crate::export::job::Job;
use crate::formats::png::axes::Rulers;
use crate::formats::png::canvas::{Ink, PAPER, picture};
use crate::formats::png::caption::Caption;
use crate::formats::png::legend::Legend;
use crate::formats::png::names::Names;
use crate::formats::png::polyline::Polyline;
use crate::formats::png::sheet::Sheet;
use crate::formats::png::{eye, view};
use cyclide::{Aabb, Point3, surface::QuadGrid};

/// The surface; lines along s and across; umbilics.
const SURFACE: u32 = 0xE4E6E3;
const LINES: [u32; 2] = [0x1F5FA6, 0xB24A1C];
const UMBILIC: u32 = 0xC62A6B;
/// Widths in pixels of a usual picture: half of lines and of strokes of crosses, the arm of a cross, and the distance of crosses, arms.
const LINE: f64 = 1.15;
const STROKE: f64 = 0.75;
const ARM: f64 = 9.5;
const APART: f64 = 3.0;
/// Radius of an umbilic and of the ring round it.
const MARK: f64 = 6.0;
const RING: f64 = 9.0;
/// A direction is that of lines along s if it is as near to them.
const HALF_RIGHT: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Draws the fields of a model; `None` if it has none.
pub(in crate::formats::png) fn write(
    job: &Job<'_>,
    sheet: Sheet,
    names: &Names,
) -> Result<Option<Exported>, ExportError> {
    let items = 0..job.model.items.len();
    let laid = |k: usize| Some((k, job.model.items[k].grids()?.grids(), job.provenances.field(k)?));
    let fields: Vec<(usize, &[QuadGrid], &LaidField)> = items.filter_map(laid).collect();
    let points: Vec<Point3> = fields.iter().flat_map(|(_, _, field)| field.surface.points.iter().copied()).collect();
    let Some(bounds) = Aabb::of_points(points.iter().copied()) else { return Ok(None) };
    let heights = bounds.max.z - bounds.min.z > 1e-6 * bounds.diagonal();
    let axes = match job.options.camera {
        Some(camera) => camera.axes(),
        None if heights => eye::from_side(&points, STEEPNESS),
        None => eye::from_above(),
    };
    let flat = job.options.camera.map_or(!heights, crate::export::camera::Camera::is_along_axis);
    let has_umbilics = fields.iter().any(|(_, _, field)| !field.umbilics.is_empty());
    let caption = Caption::new(job, Legend::of_field(LINES.map(Ink::of_screen), has_umbilics));
    sheet.check_room(caption.as_ref())?;
    let rulers = match flat {
        _ if !job.options.png_axes || caption.is_none() => Rulers::None,
        true => Rulers::Sides,
        false => Rulers::Edges,
    };
    let mut shown = points.clone();
    if rulers == Rulers::Edges {
        shown.extend(view::corners(bounds));
    }
    let height = sheet.tallest();
    let (header, footer) = caption.as_ref().map_or((0.0, 0.0), |c| (c.header(sheet), c.footer(sheet)));
    let [before, behind, under] = rulers.room().map(|room| room * sheet.scale);
    let room = (sheet.width - before - behind, height - header - footer - under);
    let camera = Camera::new(&shown, axes, flat, room).moved(before, header);
    let lights = Lights::new(camera.axes());
    let triangles: Vec<[Point3; 3]> = fields
        .iter()
        .flat_map(|(_, _, field)| field.surface.triangles.iter().map(|t| t.map(|v| field.surface.points[v])))
        .collect();
    let ground = (heights && axes[2].z > 0.0).then(|| Ground::new(&triangles, bounds, &lights));
    let mut facets = Facets::default();
    for (item, grids, field) in &fields {
        facets.add_field(*item, (grids, field), &camera, sheet.scale);
    }
    let scene = Scene {
        camera,
        lights,
        ground,
        drawn: Vec::new(),
        items: Vec::new(),
        patches: Vec::new(),
        patch_items: Vec::new(),
        facets,
        paper: to_linear(PAPER),
        coloured: None,
    };
    let size = (sheet.width as usize, height as usize);
    let mut canvas = scene.draw(size, &mut Visible::new(size, 6.0 * sheet.scale), None)?;
    if let Some(caption) = &caption {
        scene.rulers(&mut canvas, rulers, (bounds, &shown), sheet, job.units().symbol());
        let note = if flat || !heights { "" } else { " at mid-depth" };
        caption.draw(&mut canvas, sheet, height, scene.camera.unit_at(bounds.min.midpoint(bounds.max)), note);
    }
    let bytes = canvas.encode().map_err(|e| picture(&e))?;
    let mut notes = names.notes.clone();
    let others: Vec<&str> = (0..job.model.items.len())
        .filter(|k| fields.iter().all(|(item, ..)| item != k))
        .map(|k| job.model.items[k].name.as_str())
        .collect();
    if !others.is_empty() {
        notes.push(format!("omitted from the picture of the lines of curvature: {}", others.join(", ")));
    }
    let written = Written { bodies: vec![Promise::proved(0.5 * scene.camera.unit())], ..Written::default() };
    Ok(Some(written.exported(bytes, notes)))
}

impl Facets {
    fn add_field(&mut self, object: usize, (grids, field): (&[QuadGrid], &LaidField), camera: &Camera, scale: f64) {
        let (surface, tint) = (&field.surface, to_linear(SURFACE));
        for triangle in &surface.triangles {
            self.corners.push(triangle.map(|v| camera.project(surface.points[v])));
            let normals = triangle.map(|v| surface.normals.get(v).copied().unwrap_or_default());
            self.paints.push(Paint::Smooth { object, normals, tint });
        }
        let lights = LINES.map(to_linear);
        let lines = lines_along_s(grids);
        for triangle in crosses(surface, camera, ARM * scale, APART) {
            let middle = middle(surface, triangle);
            let [a, b, c] = surface.triangles[triangle].map(|v| surface.points[v]);
            let Some(normal) = (b - a).cross(c - a).unit() else { continue };
            let Some(along) = field.along.get(triangle).and_then(|d| d.unit()) else { continue };
            let across = normal.cross(along);
            // In the color of the lines that it goes with.
            let near = lines.iter().min_by(|a, b| a.0.distance(middle).total_cmp(&b.0.distance(middle)));
            let first = usize::from(near.is_some_and(|(_, s)| along.dot(*s).abs() < HALF_RIGHT));
            let arm = ARM * scale * camera.unit_at(middle);
            for (direction, light) in [(along, lights[first]), (across, lights[1 - first])] {
                self.add_stroke(
                    [middle - direction * arm, middle + direction * arm],
                    object,
                    STROKE * scale,
                    light,
                    camera,
                );
            }
        }
        for grid in grids {
            for (vertices, closed) in grid.lines() {
                // Lines along s go from a vertex to the next one.
                let light = lights[usize::from(vertices[1] != vertices[0] + 1)];
                let points = vertices.into_iter().map(|v| grid.points()[v]).collect();
                self.add_ribbon(&Polyline { object, points, closed }, LINE * scale, light, camera);
            }
        }
        for (p, _) in &field.umbilics {
            self.add_mark(*p, object, RING * scale, to_linear(PAPER), camera, 3.0);
            self.add_mark(*p, object, MARK * scale, to_linear(UMBILIC), camera, 4.0);
        }
    }
}

/// Middles of the edges along s with their directions, of some of each grid.
fn lines_along_s(grids: &[QuadGrid]) -> Vec<(Point3, cyclide::Vec3)> {
    let of_grid = |grid: &QuadGrid| {
        let ([m, n], [columns, _]) = (grid.size(), grid.quads());
        let step = (m * n / 400).max(1);
        let edges = (0..columns * n).step_by(step).map(|k| (k % columns, k / columns));
        let edge = |(i, j): (usize, usize)| {
            let (a, b) = (grid.point(i, j), grid.point(i + 1, j));
            Some((a.midpoint(b), (b - a).unit()?))
        };
        edges.filter_map(edge).collect::<Vec<_>>()
    };
    grids.iter().flat_map(of_grid).collect()
}
