//! Meshes in files, whatever their format.

use cyclide::{Point3, ShortNumber, Units};

use super::Builder;
use crate::document::spec::PolygonMeshFile;
use crate::error::{Error, Result};
use crate::formats::{InputKind, read_polygons, read_scene, read_triangles};
use crate::input::ply;
use crate::input::polygon_mesh::PolygonMesh;

impl Builder<'_> {
    /// The mesh of a file, in the units of the document, and the file's name.
    pub(super) fn mesh_of_file(&mut self, file: &PolygonMeshFile) -> Result<(String, PolygonMesh)> {
        let (name, bytes) = self.file(file.path(), ["mesh", file.word()])?;
        let read = match file {
            PolygonMeshFile::Obj(_) => read_polygons(&name, &bytes),
            PolygonMeshFile::Ply(_) => ply::read_polygons(&name, &bytes),
            PolygonMeshFile::Stl(_) => read_triangles(&name, &bytes).map(|points| {
                let faces = (0..points.len() / 3).map(|k| vec![3 * k, 3 * k + 1, 3 * k + 2]).collect();
                PolygonMesh { points, faces, ..PolygonMesh::default() }
            }),
            PolygonMeshFile::Glb(_) => read_scene(&name, &bytes).map(|scene| {
                if scene.lines > 0 {
                    let message = format!("{} primitives of points and lines are left out", scene.lines);
                    self.remark("lines-left-out", None, None, Some(name.clone()), message);
                }
                if scene.moves {
                    let message = "skins and morph targets are left aside: the mesh is taken at rest".to_owned();
                    self.remark("pose-left-aside", None, None, Some(name.clone()), message);
                }
                self.in_own_units(&name, scene.mesh)
            }),
        };
        let mesh = read.map_err(|message| match InputKind::of_bytes(&bytes) {
            Some(found) if !found.is_mesh() => {
                let text = format!("{name} is {}, not a mesh ({})", found.name(), file.word().to_uppercase());
                Error::Input(self.diagnostic(["mesh".into(), file.word().into()], &text))
            }
            _ => Error::Input(message),
        })?;
        Ok((name, mesh))
    }

    /// A mesh of a GLB file, which counts in metres.
    fn in_own_units(&mut self, file: &str, mut mesh: PolygonMesh) -> PolygonMesh {
        let units = self.document.units;
        if units != Units::Metre {
            let scale = 1000.0 / units.in_millimetres();
            mesh.points.iter_mut().for_each(|p| *p = Point3::ORIGIN + p.to_vec() * scale);
            let (factor, symbol) = (ShortNumber(scale), units.symbol());
            let message = format!("GLB counts in metres: coordinates are multiplied by {factor} to be in {symbol}");
            self.remark("unit-of-file", None, None, Some(file.to_owned()), message);
        }
        mesh
    }
}
