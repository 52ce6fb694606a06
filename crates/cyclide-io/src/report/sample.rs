//! Samples of one object as CSV: points with tangent and curvature [along curves](super::curve_sample), with normal and principal
//! curvatures on surfaces.

use cyclide::{
    Point3,
    model::{Geometry, SurfaceObject},
    surface::{ParamSurface as _, TriangleSurface},
    topology::{Body, FaceGeometry as _, ShellFace},
    volume::{CyclideVolume, StructuredGrid},
};

use super::curve_sample::{CurveSamples, SampleOptions};
use super::motion_sample::MotionSamples;
use super::sampling::{SamplePlaces, Spacing, fractions, push_field};
use crate::document::BuiltObject;
use crate::text::number::push_plain;

/// Samples of an object, ends included: `count` per contour of a curve, `count` by `count` per patch of a surface.
///
/// Curves: as [`CurveSamples::csv`], without frames.
///
/// Surfaces: columns `patch,s,t,x,y,z,normal_x,normal_y,normal_z,curvature_s,curvature_t` with patches from 0, s
/// fastest, the outer unit normal, and principal curvatures that are negative where the surface bends away from it; a
/// column `body` (from 0) in front if there are several. `spacing` is for curves.
///
/// Smooth surfaces over triangles: columns `triangle,a,b,x,y,z,normal_x,normal_y,normal_z` with triangles from 0, the first two
/// barycentric coordinates, `count` places along each side.
///
/// Volumes: columns `s,t,u,x,y,z,jacobian` with s fastest, `count` by `count` by `count` per block; a column `block` (from 0) in front if there
/// are several.
///
/// Motions: as [`MotionSamples::csv`].
///
/// Fields are empty where a tangent, normal or curvature does not exist.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let rows = cyclide_io::report::sample(&built[0], 5, cyclide_io::report::Spacing::Parameter);
/// assert!(rows.starts_with("t,x,y,z,") && rows.lines().count() == 6);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[must_use]
pub fn sample(built: &BuiltObject, count: usize, spacing: Spacing) -> String {
    match &built.item.geometry {
        Geometry::Curves(_) | Geometry::Grids(_) => {
            let places = SamplePlaces::Count { count, spacing };
            // Without frames nothing is refused.
            CurveSamples::new(built, &SampleOptions { places, frames: None })
                .map_or_else(|_| String::new(), |s| s.csv())
        }
        Geometry::Surfaces(made) => match made.iter().find_map(SurfaceObject::as_triangles) {
            Some(surface) => triangles(surface, count),
            None => surfaces(&built.bodies, count),
        },
        Geometry::Volumes(blocks) => {
            let along = || fractions(count).collect();
            volumes(blocks, &[along(), along(), along()])
        }
        Geometry::Motion(body) => {
            MotionSamples::of(body, SamplePlaces::Count { count, spacing }).map_or_else(String::new, |s| s.csv())
        }
    }
}

/// The nodes of the cells into which blocks are divided, in the format of [`sample`] for volumes; `None` for an object without cells.
///
/// ```
/// use cyclide_io::Document;
/// let corners = "[[0,0,0], [2,0,0], [0,3,0], [2,3,0], [0,0,1], [2,0,1], [0,3,1]]";
/// let cells = r#"[1, 1, {"count": 2, "ratio": 3}]"#;
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"b": {{"type": "cyclide-volume", "corners": {corners}, "cells": {cells}}}}}}}"#);
/// let rows = cyclide_io::report::sample_cells(&text.parse::<Document>()?.build()?[0]).ok_or("it has cells")?;
/// assert_eq!(rows.lines().count(), 1 + 2 * 2 * 3);
/// assert!(rows.contains("0,0,0.25,0,0,0.25,6"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn sample_cells(built: &BuiltObject) -> Option<String> {
    let blocks = built.item.volumes();
    let places = built.provenance.places.as_ref().filter(|_| !blocks.is_empty())?;
    let grid = StructuredGrid::new(blocks, places.clone()).ok()?;
    let mut table = VolumeTable::new(blocks.len());
    let [s, t, u] = grid.places();
    for block in 0..blocks.len() {
        let places = u.iter().flat_map(|u| t.iter().flat_map(move |t| s.iter().map(move |s| [*s, *t, *u])));
        let nodes = grid.block_nodes(block).zip(grid.jacobians(block));
        places.zip(nodes).for_each(|(at, (node, jacobian))| table.push(block, at, grid.nodes()[node], *jacobian));
    }
    Some(table.text)
}

/// Rows of points of blocks, with the number of the block where there are several.
struct VolumeTable {
    text: String,
    several: bool,
}

impl VolumeTable {
    fn new(blocks: usize) -> Self {
        let several = blocks > 1;
        Self { text: format!("{}s,t,u,x,y,z,jacobian\n", if several { "block," } else { "" }), several }
    }

    fn push(&mut self, block: usize, [s, t, u]: [f64; 3], p: Point3, jacobian: f64) {
        if self.several {
            self.text += &format!("{block},");
        }
        push_plain(&mut self.text, s);
        for value in [t, u, p.x, p.y, p.z, jacobian] {
            push_field(&mut self.text, Some(value));
        }
        self.text.push('\n');
    }
}

/// The points of blocks at these parameters, row by row.
fn volumes(blocks: &[CyclideVolume], [s, t, u]: &[Vec<f64>; 3]) -> String {
    let mut table = VolumeTable::new(blocks.len());
    let [mut x, mut y, mut z, mut jacobians] = [(); 4].map(|()| vec![0.0; s.len()]);
    for (index, block) in blocks.iter().enumerate() {
        for &u in u {
            for &t in t {
                block.row([t, u]).points_and_jacobians(s, [&mut x, &mut y, &mut z], &mut jacobians);
                for (k, s) in s.iter().enumerate() {
                    table.push(index, [*s, t, u], Point3::new(x[k], y[k], z[k]), jacobians[k]);
                }
            }
        }
    }
    table.text
}

fn triangles(surface: &TriangleSurface, count: usize) -> String {
    let mut out = "triangle,a,b,x,y,z,normal_x,normal_y,normal_z\n".to_owned();
    let steps = count.saturating_sub(1).max(1);
    for triangle in 0..surface.triangle_count() {
        let Some(patch) = surface.patch(triangle) else { continue };
        for a in 0..=steps {
            for b in 0..=steps - a {
                let place = patch.point_and_normal([a, b, steps - a - b].map(|v| v as f64)).ok();
                let vectors = place.map(|(p, normal)| [p.to_array(), normal.to_array()]);
                out += &triangle.to_string();
                for value in [a, b].map(|v| Some(v as f64 / steps as f64)) {
                    push_field(&mut out, value);
                }
                for k in 0..6 {
                    push_field(&mut out, vectors.map(|v| v[k / 3][k % 3]));
                }
                out.push('\n');
            }
        }
    }
    out
}

fn surfaces(bodies: &[Body], count: usize) -> String {
    let several = bodies.len() > 1;
    let columns = "patch,s,t,x,y,z,normal_x,normal_y,normal_z,curvature_s,curvature_t";
    let mut out = format!("{}{columns}\n", if several { "body," } else { "" });
    for (index, body) in bodies.iter().enumerate() {
        for (patch, face) in body.shells().flat_map(cyclide::topology::Shell::faces).enumerate() {
            let name = if several { format!("{index},{patch}") } else { patch.to_string() };
            for t in fractions(count) {
                for s in fractions(count) {
                    out += &name;
                    push_surface_sample(&mut out, face, s, t);
                }
            }
        }
    }
    out
}

/// The fields of a place on a patch behind its number, and the end of the line.
fn push_surface_sample(out: &mut String, face: &ShellFace, s: f64, t: f64) {
    let surface = &face.surface;
    // Curvatures of patches are against D V3 D^-1, which turns to the other side nowhere, as the report has it.
    let side = face.outer_sign_of_unit_normal();
    let point = surface.point(s, t).to_array().map(Some);
    let normal = (surface.unit_normal(s, t) * side).to_array().map(Some);
    let curvatures = surface.line_curvatures(s, t).map(|k| Some(side * k).filter(|k| k.is_finite()));
    for value in [s, t].map(Some).into_iter().chain(point).chain(normal).chain(curvatures) {
        push_field(out, value);
    }
    out.push('\n');
}
