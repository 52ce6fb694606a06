//! Surfaces in the plan: the edges of their patches and some inner parameter circles, as fine lines.
//!
//! Hidden lines are drawn too: a plan is read like a drawing, not like a picture (that is what PNG is for).

use super::path::Path;
use super::{LEVEL, polyline, reader, three_digits};
use crate::deviation::DrawnArc;
use crate::export_error::ExportError;
use crate::exported::{Promise, WrittenCurve};
use crate::job::BodyOf;
use crate::job::Job;
use crate::number::push_plain;
use crate::parameter_circles::halvings;
use cyclide::{Aabb, Arc, Correspondence, Shell};

/// Names of the groups in the order in which they are drawn: inner circles, edges.
pub(super) const GROUPS: [&str; 2] = ["circles", "edges"];
/// Distance of the inner circles, about, relative to the model's size.
const SPACING: f64 = 0.02;
/// Width of edges and of inner circles, relative to that of a curve.
const EDGE: f64 = 0.45;
const CIRCLE: f64 = 0.2;

/// The lines of all surfaces, each with what it stands for.
pub(super) struct Plan {
    edges: Vec<(DrawnArc, Path)>,
    circles: Vec<(DrawnArc, Path)>,
}

impl Plan {
    pub(super) fn new(job: &Job<'_>) -> Result<Self, ExportError> {
        let mut plan = Self { edges: Vec::new(), circles: Vec::new() };
        for body in job.bodies {
            for shell in body.body.shells() {
                for edge in shell.edges() {
                    plan.edges.extend(draw(job, body, Ok(edge.arc))?);
                }
                plan.add_circles(job, body, shell)?;
            }
        }
        Ok(plan)
    }

    fn add_circles(&mut self, job: &Job<'_>, body: &BodyOf<'_>, shell: &Shell) -> Result<(), ExportError> {
        let inner = |level: u32| {
            let count = 1u32 << level;
            (1..count).map(move |i| f64::from(i) / f64::from(count))
        };
        for (face, [along_s, along_t]) in shell.faces().iter().zip(halvings(shell, SPACING * job.size())) {
            for s in inner(along_s) {
                self.circles.extend(draw(job, body, face.patch.t_line(s))?);
            }
            for t in inner(along_t) {
                self.circles.extend(draw(job, body, face.patch.s_line(t))?);
            }
        }
        Ok(())
    }

    pub(super) fn bounds(&self) -> Option<Aabb> {
        self.edges.iter().chain(&self.circles).map(|(_, path)| path.bounds()).reduce(Aabb::union)
    }

    /// Draws the lines and returns what they stand for, in the same order.
    pub(super) fn push(self, out: &mut String, stroke: f64) -> Vec<DrawnArc> {
        let looks = [("#8a97a8", CIRCLE, self.circles), ("#17202e", EDGE, self.edges)];
        let mut drawn = Vec::new();
        for (id, (colour, width, lines)) in GROUPS.into_iter().zip(looks) {
            if lines.is_empty() {
                continue;
            }
            out.push_str(&format!(
                "{}{id}\" fill=\"none\" stroke=\"{colour}\" stroke-linecap=\"round\" stroke-width=\"",
                reader::GROUP
            ));
            push_plain(out, three_digits(width * stroke));
            out.push_str("\">\n");
            for (arc, path) in lines {
                drawn.push(arc);
                out.push_str(&format!("{}{}\"/>\n", reader::LINE, path.into_data()));
            }
            out.push_str("</g>\n");
        }
        drawn
    }
}

/// An arc in the plan: an arc if it is level, else a polyline; `None` if it is a point there.
fn draw(job: &Job<'_>, body: &BodyOf<'_>, arc: cyclide::Result<Arc>) -> Result<Option<(DrawnArc, Path)>, ExportError> {
    let failed = |source| body.unfit(source);
    let arc = arc.map_err(failed)?;
    let (path, WrittenCurve { parts, promise }) =
        if arc.normal().is_none_or(|n| n.x.abs() <= LEVEL && n.y.abs() <= LEVEL) {
            let mut path = Path::new(arc.start(), false);
            let (lost, drawn) = path.arc(&arc);
            let mut promise = Promise::EXACT;
            promise.add(lost);
            (path, promise.of(Correspondence::one_to_one(1).recounted([drawn])))
        } else {
            let (path, parts) = polyline(&job.pieces.flatten(&arc, job.mesh_tolerance).map_err(failed)?, false);
            (path, Promise::proved(job.mesh_tolerance).of(parts))
        };
    Ok((!path.is_point()).then_some((DrawnArc { arc, parts, promise }, path)))
}
