//! Meshes in files, whatever their format.

use cyclide::{Point3, ShortNumber, model::Units};

use crate::document::kinds::fields::polygon_mesh_file::PolygonMeshFile;
use crate::document::objects::Builder;
use crate::error::{Error, Result};
use crate::formats::{InputKind, MeshFormat, ReadMesh};
use crate::input::polygon_mesh::PolygonMesh;

impl Builder<'_> {
    /// The mesh of a file, in the units of the document, and the file's name.
    pub(in crate::document) fn mesh_of_file(&mut self, file: &PolygonMeshFile) -> Result<(String, PolygonMesh)> {
        let entry = file.format.entry();
        let (name, bytes) = self.file(&file.path, ["mesh", entry.word])?;
        let read = (entry.read)(&name, &bytes).map_err(|message| match InputKind::of_bytes(&bytes) {
            Some(found) if !found.is_mesh() => {
                let text = format!("{name} is {}, not a mesh ({})", found.name(), entry.word.to_uppercase());
                Error::Input(self.diagnostic(["mesh".into(), entry.word.into()], &text))
            }
            _ => Error::Input(message),
        })?;
        let ReadMesh { mesh, remarks, in_metres } = read;
        for (reason, message) in remarks {
            self.remark(reason, None, None, Some(name.clone()), message);
        }
        let mesh = if in_metres { self.in_own_units(&name, file.format, mesh) } else { mesh };
        Ok((name, mesh))
    }

    /// A mesh of a file that counts in meters.
    fn in_own_units(&mut self, file: &str, format: MeshFormat, mut mesh: PolygonMesh) -> PolygonMesh {
        let units = self.document.units;
        if units != Units::Metre {
            let scale = 1000.0 / units.in_millimetres();
            mesh.points.iter_mut().for_each(|p| *p = Point3::ORIGIN + p.to_vec() * scale);
            let (factor, symbol, format) = (ShortNumber(scale), units.symbol(), format.word().to_uppercase());
            let message = format!("{format} is in meters: coordinates are multiplied by {factor} for {symbol}");
            self.remark("unit-of-file", None, None, Some(file.to_owned()), message);
        }
        mesh
    }
}
