//! Surfaces in the plan: the edges of their patches and some inner parameter circles, as fine lines; of blocks that are divided those at which their
//! cells end.
//!
//! Hidden lines are drawn too: a plan is read like a drawing, not like a picture (that is what PNG is for).

use super::path::Path;
use super::{LEVEL, polyline, reader, three_digits};
use crate::drawing::block_directions::others;
use crate::drawing::parameter_circles::{Planes, halvings};
use crate::drawing::plane_regions::drawn_edges;
use crate::export::drawn_line::{LinePlace, ShellLine};
use crate::export::error::ExportError;
use crate::export::exported::{DrawnLine, Promise, WrittenCurve};
use crate::export::job::Job;
use crate::export::parts::BodyOf;
use crate::text::number::push_plain;
use cyclide::{
    Aabb,
    curve::{Arc, Correspondence},
    topology::{EdgeCurve, FaceGeometry as _, Shell, ShellFace},
};
/// Distance of the inner circles, about, relative to the model's size.
const SPACING: f64 = 0.02;
/// Width of edges and of inner circles, relative to that of a curve.
const EDGE: f64 = 0.45;
const CIRCLE: f64 = 0.2;

/// The lines of all surfaces, each with what it stands for; those that are points in the plan have no path.
pub(super) struct Plan {
    edges: Vec<(DrawnLine, Option<Path>)>,
    circles: Vec<(DrawnLine, Option<Path>)>,
}

impl Plan {
    pub(super) fn new(job: &Job<'_>) -> Result<Self, ExportError> {
        let mut plan = Self { edges: Vec::new(), circles: Vec::new() };
        for (index, body) in job.bodies.iter().enumerate() {
            for (number, shell) in body.body.shells().enumerate() {
                let place = |line: ShellLine| LinePlace { body: index, shell: number, line };
                let drawn = drawn_edges(shell);
                for (k, edge) in shell.edges().iter().enumerate().filter(|(k, _)| drawn[*k]) {
                    plan.edges.push(draw(job, body, place(ShellLine::Edge(k)), Ok(edge.curve.clone()))?);
                }
                for (line, curve) in circles(job, body, shell) {
                    plan.circles.push(draw(job, body, place(line), curve)?);
                }
            }
        }
        Ok(plan)
    }

    pub(super) fn bounds(&self) -> Option<Aabb> {
        self.edges
            .iter()
            .chain(&self.circles)
            .filter_map(|(_, path)| path.as_ref().map(Path::bounds))
            .reduce(Aabb::union)
    }

    /// Draws the lines and returns what they stand for, in the same order.
    pub(super) fn push(self, out: &mut String, stroke: f64) -> Vec<DrawnLine> {
        let looks = [("#8a97a8", CIRCLE, self.circles), ("#17202e", EDGE, self.edges)];
        let mut drawn = Vec::new();
        for (id, (colour, width, lines)) in reader::GROUPS.into_iter().zip(looks) {
            if lines.iter().all(|(_, path)| path.is_none()) {
                drawn.extend(lines.into_iter().map(|(line, _)| line));
                continue;
            }
            out.push_str(&format!(
                "{}{id}\" fill=\"none\" stroke=\"{colour}\" stroke-linecap=\"round\" stroke-width=\"",
                reader::GROUP
            ));
            push_plain(out, three_digits(width * stroke));
            out.push_str("\">\n");
            for (line, path) in lines {
                drawn.push(line);
                if let Some(path) = path {
                    out.push_str(&format!("{}{}\"/>\n", reader::LINE, path.into_data()));
                }
            }
            out.push_str("</g>\n");
        }
        drawn
    }
}

/// The inner parameter circles of a shell that are drawn.
fn circles<'a>(
    job: &Job<'_>,
    body: &BodyOf<'_>,
    shell: &'a Shell,
) -> impl Iterator<Item = (ShellLine, cyclide::Result<EdgeCurve>)> + use<'a> {
    let halved = |level: u32| {
        let count = 1u32 << level;
        (1..count).map(|i| f64::from(i) / f64::from(count)).collect::<Vec<f64>>()
    };
    let volume = job.model.items[body.item].volumes().get(body.surface);
    let inner: Vec<[Vec<f64>; 2]> = match volume.zip(job.provenances.places(body.item)) {
        Some((volume, places)) => {
            let faces = volume.faces();
            // Faces that are a line are none of the shell.
            let axis =
                |face: &ShellFace| faces.iter().position(|patch| face.surface.patch() == Some(patch)).map(|k| k / 2);
            let inside = |axis: usize| {
                let places = places[axis].iter().copied();
                places.filter(|x| 0.0 < *x && *x < 1.0).collect::<Vec<f64>>()
            };
            let of_face = |face| axis(face).map_or_else(Default::default, |axis| others(axis).map(inside));
            shell.faces().iter().map(of_face).collect()
        }
        None => {
            let levels = halvings(shell, SPACING * job.size(), Planes::Plain);
            levels.into_iter().map(|levels| levels.map(halved)).collect()
        }
    };
    shell.faces().iter().enumerate().zip(inner).flat_map(|((face, it), [along_s, along_t])| {
        let across = along_s.into_iter().map(move |s| (ShellLine::AlongT { face, s }, it.surface.t_line(s)));
        across.chain(along_t.into_iter().map(move |t| (ShellLine::AlongS { face, t }, it.surface.s_line(t))))
    })
}

/// A line in the plan: an arc if it is level, else a polyline; without a path if it is a point there.
fn draw(
    job: &Job<'_>,
    body: &BodyOf<'_>,
    place: LinePlace,
    curve: cyclide::Result<EdgeCurve>,
) -> Result<(DrawnLine, Option<Path>), ExportError> {
    let failed = |source| body.unfit(source);
    let curve = curve.map_err(failed)?;
    let is_level = |arc: &&Arc| arc.normal().is_none_or(|n| n.x.abs() <= LEVEL && n.y.abs() <= LEVEL);
    let (path, WrittenCurve { parts, promise, .. }) = if let Some(arc) = curve.arc().filter(is_level) {
        let mut path = Path::new(arc.start(), false);
        let (lost, drawn) = path.arc(arc);
        let mut promise = Promise::EXACT;
        promise.add(lost);
        (path, promise.of(Correspondence::one_to_one(1).recounted([drawn])))
    } else {
        let (path, parts) = polyline(&job.pieces.flatten(&curve, job.mesh_tolerance).map_err(failed)?, false);
        (path, Promise::proved(job.mesh_tolerance).of(parts))
    };
    let path = (!path.is_point()).then_some(path);
    Ok((DrawnLine { place, parts, promise }, path))
}
