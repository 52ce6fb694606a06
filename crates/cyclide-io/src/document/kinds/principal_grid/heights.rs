//! Grids of heights of documents: a quad for each cell whose four corners are given.

use cyclide::Point3;

use crate::document::kinds::principal_grid::surface_sources::HeightsSpec;
use crate::document::kinds::smooth_mesh::Given;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::error::{Error, Result};
use crate::input::points::read_heights;
use crate::input::polygon_mesh::PolygonMesh;

impl Builder<'_> {
    /// The mesh over a grid of heights.
    pub(in crate::document) fn mesh_of_heights(&mut self, spec: &HeightsSpec) -> Result<Given> {
        let within = |field: &str| [Step::from("heights"), Step::from(field)];
        if let Some(k) = spec.spacing.iter().position(|step| *step == 0.0) {
            let place = within("spacing").into_iter().chain([k.into()]);
            return Err(self.refused_in_words(place, "parameter-out-of-range", "the spacing is 0".to_owned()));
        }
        let mut file = None;
        let read;
        let rows = match (&spec.csv, &spec.z) {
            (Some(path), None) => {
                let (name, bytes) = self.file(path, ["heights", "csv"])?;
                let table = read_heights(&name, &bytes).map_err(Error::Input)?;
                if table.decimal_commas {
                    let message = "the numbers are read with decimal commas".to_owned();
                    self.remark("decimal-commas", None, None, Some(name.clone()), message);
                }
                file = Some(name);
                read = table.rows;
                &read
            }
            (None, Some(rows)) => rows,
            _ => {
                let words = "heights require exactly one of `csv` (a file) and `z` (rows)";
                return Err(Error::Input(self.diagnostic(["heights".into()], words)));
            }
        };
        let columns = rows.first().map_or(0, Vec::len);
        if let Some(j) = rows.iter().position(|row| row.len() != columns) {
            let words = format!("the row has {} heights, the first one has {columns}: holes are `null`", rows[j].len());
            return Err(self.refused_in_words(within("z").into_iter().chain([j.into()]), "count-differs", words));
        }
        let mesh = mesh_over(rows, columns, spec);
        if mesh.faces.is_empty() {
            let of = file.map_or(String::new(), |name| format!(" (of {name})"));
            let words = format!(
                "{} rows of {columns} heights have no cell with four corners: at least two rows of two without holes are required{of}",
                rows.len()
            );
            return Err(self.refused_in_words(["heights".into()], "too-few-points", words));
        }
        Ok(Given { mesh, file, field: "heights", shared: true, lists_normals: false })
    }
}

/// Vertices where heights are given, and quads, counter-clockwise from above.
fn mesh_over(rows: &[Vec<Option<f64>>], columns: usize, spec: &HeightsSpec) -> PolygonMesh {
    let ([dx, dy], [x, y]) = (spec.spacing, spec.origin);
    let mut mesh = PolygonMesh::default();
    let mut numbers: Vec<Option<usize>> = Vec::with_capacity(rows.len() * columns);
    for (j, row) in rows.iter().enumerate() {
        for (i, height) in row.iter().enumerate() {
            numbers.push(height.map(|z| {
                mesh.points.push(Point3::new(x + i as f64 * dx, y + j as f64 * dy, z));
                mesh.points.len() - 1
            }));
        }
    }
    let turned = (dx < 0.0) != (dy < 0.0);
    for j in 1..rows.len() {
        for i in 1..columns {
            let corners = [(i - 1, j - 1), (i, j - 1), (i, j), (i - 1, j)].map(|(i, j)| numbers[j * columns + i]);
            if let [Some(a), Some(b), Some(c), Some(d)] = corners {
                mesh.faces.push(if turned { vec![a, d, c, b] } else { vec![a, b, c, d] });
            }
        }
    }
    mesh
}
