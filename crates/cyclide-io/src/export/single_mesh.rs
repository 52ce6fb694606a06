//! Bodies as triangles in single precision, as files for printing hold them.

use super::collapsed::{Triangle, is_whole, reach};
use crate::export::error::ExportError;
use crate::export::job::Job;
use crate::export::mesh::{BodyMesh, Single, triangles};
use crate::export::mesh_plan::MeshPlan;
use crate::export::parts::BodyOf;
use cyclide::{Point3, mesh::MeshFace};

/// Why a body is refused that is thinner than the steps of single precision at its place.
const NOTHING_LEFT: &str = "a body vanishes in single precision: write OBJ, or GLB, whose coordinates are relative to the center of each object";
const PART_LEFT_OUT: &str = "a part of a body vanishes in single precision: write OBJ, or GLB, whose coordinates are relative to the center of each object";

/// The triangles of a body with rounded corners; equal places have equal bits.
pub(crate) struct SingleMesh {
    points: Vec<[f32; 3]>,
    pub(crate) triangles: Vec<Triangle>,
    /// How many triangles each face of the mesh has.
    counts: Vec<usize>,
    /// How far rounding moves a vertex.
    rounding: f64,
    /// How far the triangles are from those that were not rounded.
    pub(crate) moved: f64,
}

impl SingleMesh {
    /// Rounds a mesh, with the format's name for messages.
    ///
    /// # Errors
    /// [`ExportError::Rounding`], [`ExportError::NotInFormat`] where a part is thinner than the rounding.
    pub(crate) fn of(job: &Job<'_>, body: &BodyMesh<'_>, format: &'static str) -> Result<Self, ExportError> {
        let mesh = &body.mesh;
        let mut rounding = Single::new(Point3::ORIGIN);
        let points: Vec<[f32; 3]> = mesh.positions.iter().map(|p| rounding.point(*p)).collect();
        check_rounding(job, body.body, rounding.moved, format)?;
        let (mut own, mut collapsed, mut counts) = (Vec::new(), Vec::new(), Vec::with_capacity(mesh.faces.len()));
        for face in &mesh.faces {
            let (before, corners) = (own.len(), face.corners());
            for corners in triangles(face).iter().map(|t| t.map(|i| points[corners[i].position])) {
                if is_whole(&corners) { own.push(corners) } else { collapsed.push(corners) }
            }
            counts.push(own.len() - before);
        }
        let moved = rounding.moved + reach(&own, &collapsed);
        if !(moved <= job.mesh_tolerance) {
            let detail = if own.is_empty() { NOTHING_LEFT } else { PART_LEFT_OUT };
            return Err(ExportError::NotInFormat { object: body.body.object.to_owned(), format, detail });
        }
        Ok(Self { points, triangles: own, counts, rounding: rounding.moved, moved })
    }

    /// Notes what the file is checked against.
    pub(crate) fn plan(&self, body: &BodyMesh<'_>, plan: &mut MeshPlan) {
        let mut counts = self.counts.iter().copied();
        let count = |_: &MeshFace| counts.next().unwrap_or(0);
        body.plan_triangles(&self.points, self.rounding, count, plan);
    }
}

/// Refuses coordinates that single precision rounds by more than the tolerance.
fn check_rounding(job: &Job<'_>, body: &BodyOf<'_>, rounding: f64, format: &'static str) -> Result<(), ExportError> {
    if rounding <= job.mesh_tolerance {
        return Ok(());
    }
    let (bounds, half) = (body.body.bounds(), 0.5 * job.size());
    let largest = bounds.max_abs();
    // About the origin coordinates would not be larger than half the size, and rounded by so much less.
    let hint = if rounding * half <= job.mesh_tolerance * largest {
        "move the model to the origin, or write OBJ, or GLB, whose coordinates are relative to the center of each object"
    } else {
        "use a larger tolerance or write OBJ"
    };
    let object = body.object.to_owned();
    Err(ExportError::Rounding { object, format, largest, rounding, tolerance: job.mesh_tolerance, hint })
}
