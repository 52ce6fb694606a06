//! Writes OBJ: one `o` per object, one `g` per surface or curve.
//!
//! Vertices and normals in full doubles, faces `f vertex//normal …` counted from 1, quads kept. A curve is a
//! polyline `l` within the tolerance; a closed one ends with its first vertex. The unit stands in a comment: the
//! format has none.

use crate::deviation::MeshPlan;
use crate::export_error::ExportError;
use crate::exported::{Exported, Promise};
use crate::job::Job;
use crate::mesh::{BodyMesh, body_meshes, polyline, promised};
use crate::number::push_plain;
use cyclide::{Exactness, SurfaceMesh};
use std::fmt::Write as _;

/// Writes the model as OBJ.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let mut promise = Promise::EXACT;
    let mut plan = MeshPlan::default();
    let mut file = File { text: format!("# cyclide, units {}\n", job.units().symbol()), positions: 0, normals: 0 };
    let meshes = body_meshes(job)?;
    for (index, item) in job.model.items.iter().enumerate() {
        file.name("o", &item.name);
        for body in meshes.iter().filter(|mesh| mesh.body.item == index) {
            let BodyMesh { mesh, .. } = body;
            file.name("g", &body.body.label());
            file.mesh(mesh);
            body.plan_whole(&mut plan);
            promised(&mut promise, mesh.bound);
        }
        for contour in job.contours().filter(|contour| contour.item == index) {
            file.name("g", &contour.label());
            file.polyline(&polyline(job, &contour)?, contour.curve.as_curve().is_closed());
            promise.add(Exactness::Proved(job.tolerance));
        }
    }
    Ok(promise.exported_mesh(file.text.into_bytes(), Vec::new(), plan))
}

/// The text with the numbers of vertices and normals so far.
struct File {
    text: String,
    positions: usize,
    normals: usize,
}

impl File {
    /// A line with a name; it ends at the end of the line.
    fn name(&mut self, keyword: &str, name: &str) {
        let name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let _ = writeln!(self.text, "{keyword} {}", name.trim());
    }

    fn numbers(&mut self, keyword: &str, numbers: [f64; 3]) {
        self.text.push_str(keyword);
        for v in numbers {
            self.text.push(' ');
            push_plain(&mut self.text, v);
        }
        self.text.push('\n');
    }

    fn mesh(&mut self, mesh: &SurfaceMesh) {
        for p in &mesh.positions {
            self.numbers("v", p.to_array());
        }
        for n in &mesh.normals {
            self.numbers("vn", n.to_array());
        }
        for face in &mesh.faces {
            self.text.push('f');
            for corner in face.corners() {
                let (position, normal) = (self.positions + corner.position + 1, self.normals + corner.normal + 1);
                let _ = write!(self.text, " {position}//{normal}");
            }
            self.text.push('\n');
        }
        self.positions += mesh.positions.len();
        self.normals += mesh.normals.len();
    }

    fn polyline(&mut self, points: &[cyclide::Point3], closed: bool) {
        for p in points {
            self.numbers("v", p.to_array());
        }
        self.text.push('l');
        for i in (0..points.len()).chain(closed.then_some(0)) {
            let _ = write!(self.text, " {}", self.positions + i + 1);
        }
        self.text.push('\n');
        self.positions += points.len();
    }
}
