//! Surfaces in the plan: the edges of their patches and some inner parameter circles, as fine lines.
//!
//! Hidden lines are drawn too: a plan is read like a drawing, not like a picture (that is what PNG is for).

use super::path::Path;
use super::{LEVEL, three_digits};
use crate::export::{ExportError, Job, Promise};
use crate::job::BodyOf;
use crate::number::push_plain;
use crate::parameter_circles::halvings;
use cyclide::{Aabb, Arc, Exactness, Shell, flatten};

/// Distance of the inner circles, about, relative to the model's size.
const SPACING: f64 = 0.02;
/// Width of edges and of inner circles, relative to that of a curve.
const EDGE: f64 = 0.45;
const CIRCLE: f64 = 0.2;

/// The lines of all surfaces: edges, then inner circles.
pub(super) struct Plan {
    edges: Vec<Path>,
    circles: Vec<Path>,
}

impl Plan {
    pub(super) fn new(job: &Job<'_>, promise: &mut Promise) -> Result<Self, ExportError> {
        let mut plan = Self { edges: Vec::new(), circles: Vec::new() };
        for body in &job.bodies {
            for shell in body.body.shells() {
                for edge in shell.edges() {
                    plan.edges.extend(draw(job, body, Ok(edge.arc), promise)?);
                }
                plan.add_circles(job, body, shell, promise)?;
            }
        }
        Ok(plan)
    }

    fn add_circles(
        &mut self,
        job: &Job<'_>,
        body: &BodyOf<'_>,
        shell: &Shell,
        promise: &mut Promise,
    ) -> Result<(), ExportError> {
        let inner = |level: u32| {
            let count = 1u32 << level;
            (1..count).map(move |i| f64::from(i) / f64::from(count))
        };
        for (face, [along_s, along_t]) in shell.faces().iter().zip(halvings(shell, SPACING * job.size())) {
            for s in inner(along_s) {
                self.circles.extend(draw(job, body, face.patch.t_line(s), promise)?);
            }
            for t in inner(along_t) {
                self.circles.extend(draw(job, body, face.patch.s_line(t), promise)?);
            }
        }
        Ok(())
    }

    pub(super) fn bounds(&self) -> Option<Aabb> {
        self.edges.iter().chain(&self.circles).map(Path::bounds).reduce(Aabb::union)
    }

    pub(super) fn push(self, out: &mut String, stroke: f64) {
        let groups = [("circles", "#8a97a8", CIRCLE, self.circles), ("edges", "#17202e", EDGE, self.edges)];
        for (id, colour, width, paths) in groups {
            if paths.is_empty() {
                continue;
            }
            out.push_str(&format!(
                "<g id=\"{id}\" fill=\"none\" stroke=\"{colour}\" stroke-linecap=\"round\" stroke-width=\""
            ));
            push_plain(out, three_digits(width * stroke));
            out.push_str("\">\n");
            for path in paths {
                out.push_str(&format!("<path d=\"{}\"/>\n", path.into_data()));
            }
            out.push_str("</g>\n");
        }
    }
}

/// An arc in the plan: an arc if it is level, else a polyline; `None` if it is a point there.
fn draw(
    job: &Job<'_>,
    body: &BodyOf<'_>,
    arc: cyclide::Result<Arc>,
    promise: &mut Promise,
) -> Result<Option<Path>, ExportError> {
    let failed = |source| ExportError::Lowering { object: body.object.to_owned(), contour: body.index, source };
    let arc = arc.map_err(failed)?;
    let mut path = Path::new(arc.start(), false);
    if arc.normal().is_none_or(|n| n.x.abs() <= LEVEL && n.y.abs() <= LEVEL) {
        promise.add(path.arc(&arc));
    } else {
        for (_, point) in flatten(&arc, job.mesh_tolerance).map_err(failed)?.into_iter().skip(1) {
            path.segment(point);
        }
        promise.add(Exactness::Within(job.mesh_tolerance));
    }
    Ok((!path.is_point()).then_some(path))
}
