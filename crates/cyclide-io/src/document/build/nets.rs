//! Nets and whole cyclides: from grids and parameters to the kernel's surfaces.

use cyclide::{
    Border, CircularMeshOptions, CurveObject, CyclidicNet, DupinCyclide, Error as KernelError, Frame, NetFrame,
    ParamCurve, QuadGrid, SurfaceObject, Vec3, make_circular,
};

use super::Builder;
use super::surfaces::direction;
use crate::document::coordinates::Coordinates;
use crate::document::locate::{Step, path_text, span_of};
use crate::document::spec::{
    BorderSpec, BorderWord, CyclideSpec, CyclidicNetSpec, FrameSpec, GridSource, MakeCircularOptions, MeshFile,
};
use crate::error::{Error, Result};
use crate::obj::read_quad_grid;

/// Patches of a whole cyclide round the hole and round the tube.
const SEGMENTS: [u32; 2] = [4, 4];

/// What a file calls the points of a grid.
pub(super) struct MeshNames {
    /// The file.
    name: String,
    /// The number of each point of the grid.
    numbers: Vec<usize>,
}

impl<'a> Builder<'a> {
    /// A whole cyclide as one closed net, or as several that touch in the nodes.
    pub(super) fn cyclide(&self, spec: &CyclideSpec) -> Result<Vec<SurfaceObject>> {
        let made = || {
            let center = spec.center.unwrap_or_default().point();
            let axis = spec.axis.map_or(Vec3::Z, Coordinates::vector);
            let x = spec.x_direction.map(Coordinates::vector);
            // Where the axis itself is that of x, the ring's long axis is that of y.
            let frame = Frame::from_normal(center, axis, x.unwrap_or(Vec3::X))
                .or_else(|e| if x.is_none() { Frame::from_normal(center, axis, Vec3::Y) } else { Err(e) })?;
            let segments = spec.segments.unwrap_or(SEGMENTS).map(|n| n as usize);
            DupinCyclide::new(spec.a, spec.c, spec.mu)?.placed(frame).nets(segments)
        };
        let nets = made().map_err(|e| self.refused(&e, None))?;
        Ok(nets.into_iter().map(SurfaceObject::Net).collect())
    }

    /// The net over a grid.
    pub(super) fn net(&mut self, spec: &CyclidicNetSpec) -> Result<Vec<SurfaceObject>> {
        let mut grid = self.grid(spec)?;
        if let Some(options) = spec.make_circular.options() {
            grid = self.circular(spec, &options, &grid)?;
        }
        let frame = match spec.frame {
            FrameSpec::Auto => NetFrame::Auto,
            FrameSpec::First(given) => {
                let [v1, v2] = given.map(direction);
                NetFrame::First(v1, v2)
            }
        };
        let net = CyclidicNet::new(grid.clone(), frame).map_err(|e| self.refused_in_grid(&grid, &e))?;
        Ok(vec![SurfaceObject::Net(net)])
    }

    fn grid(&mut self, spec: &CyclidicNetSpec) -> Result<QuadGrid> {
        let rows = match &spec.grid {
            GridSource::Rows(rows) => rows,
            GridSource::File(file) => {
                if spec.closed.is_some() {
                    return Err(
                        self.unfit("`closed` goes with a grid inline: a mesh in a file says itself what is closed")
                    );
                }
                return self.mesh_file(file);
            }
        };
        let columns = rows.first().map_or(0, Vec::len);
        if let Some(row) = rows.iter().position(|row| row.len() != columns) {
            let path = self.path(["grid".into(), row.into()]);
            let span = span_of(&self.document.text, &path).unwrap_or(0..0);
            let message = format!("row {row} has {} points, the first has {columns}", rows[row].len());
            return Err(Error::Input(self.document.source().diagnostic(span, &path_text(&path), message)));
        }
        let points = rows.iter().flatten().map(|p| p.point()).collect();
        let size = [columns, rows.len()];
        QuadGrid::new(points, size, spec.closed.unwrap_or_default())
            .map_err(|e| self.refused_at([Step::from("grid")], &e))
    }

    /// The grid of a mesh in a file of its own.
    fn mesh_file(&mut self, file: &MeshFile) -> Result<QuadGrid> {
        let path = self.folder.join(&file.obj);
        let bytes = (self.read)(&path).map_err(|source| Error::Read { path: path.clone(), source })?;
        let name = path.display().to_string();
        let mesh = read_quad_grid(&name, &bytes)?;
        if let Some(first) = mesh.unused.first() {
            let message =
                format!("{} point(s) that no face uses are left out, the first is number {first}", mesh.unused.len());
            self.remark("points-unused", None, None, Some(name.clone()), message);
        }
        self.mesh = Some(MeshNames { name, numbers: mesh.numbers });
        Ok(mesh.grid)
    }

    /// Moves the vertices so that every quad has a circle.
    fn circular(&mut self, spec: &CyclidicNetSpec, given: &MakeCircularOptions, grid: &QuadGrid) -> Result<QuadGrid> {
        let curves = self.border_curves(spec)?;
        let border = match &given.border {
            BorderSpec::Word(BorderWord::Free) => Border::Free,
            BorderSpec::Word(BorderWord::Pinned) => Border::Pinned,
            BorderSpec::Curves(_) => Border::OnCurves(curves),
        };
        let usual = CircularMeshOptions::default();
        let max_steps = given.max_steps.map_or(usual.max_steps, |n| n as usize);
        let progress = &mut *self.progress;
        let mesh = make_circular(grid, &CircularMeshOptions { border, max_steps }, &mut |step| {
            progress(format!("circular quads: step {}, residual {:.1e}", step.step, step.residual));
        });
        let mesh = mesh.map_err(|e| self.refused_in_grid(grid, &e))?;
        for warning in mesh.warnings {
            let (index, message) = (warning.index(), warning.to_string());
            self.remark(warning.reason(), None, index, None, message);
            self.warnings.push((0, warning));
        }
        if let Some(&quad) = mesh.report.rejected_quads.first() {
            return Err(self.refused_in_grid(grid, &KernelError::CrossingQuad { quad, position: f64::NAN }));
        }
        self.circular = Some(mesh.report);
        Ok(mesh.grid)
    }

    /// The curves of the sides, in the kernel's order.
    fn border_curves(&self, spec: &CyclidicNetSpec) -> Result<[Option<&'a dyn ParamCurve>; 4]> {
        let mut curves = [None; 4];
        let Some(given) = spec.make_circular.border_curves() else { return Ok(curves) };
        let named = given.sides().into_iter().enumerate().filter(|(_, (_, name))| name.is_some());
        for ((side, (field, _)), source) in named.zip(&self.sources) {
            let [curve] = source.item.contours.as_slice() else {
                let path = self.path(["make_circular".into(), "border".into(), field.into()]);
                let span = span_of(&self.document.text, &path).unwrap_or(0..0);
                let message = format!("`{}` is not one connected curve", source.item.name);
                return Err(Error::Input(self.document.source().diagnostic(span, &path_text(&path), message)));
            };
            curves[side] = Some(CurveObject::as_curve(curve));
        }
        Ok(curves)
    }

    /// The message for what the kernel said about a quad, a vertex or the frame of a net.
    fn refused_in_grid(&self, grid: &QuadGrid, error: &KernelError) -> Error {
        if matches!(
            error,
            KernelError::FrameNotOrthonormal { .. } | KernelError::NotFinite { what: "frame vector", .. }
        ) {
            return self.refused_at([Step::from("frame")], error);
        }
        if let KernelError::NotConverged { .. } = error {
            return self.refused_at([Step::from("make_circular")], error);
        }
        let (vertices, first, columns) = match (error, error.index()) {
            (KernelError::CoincidentPoints { first, second, .. }, _) => {
                (vec![*first, *second], *second, grid.size()[0])
            }
            (_, Some(quad)) => {
                let columns = grid.quads()[0];
                (grid.corners(quad % columns, quad / columns).to_vec(), quad, columns)
            }
            (_, None) => return self.refused_at([Step::from("grid")], error),
        };
        let Some(mesh) = &self.mesh else {
            return self.refused_at(["grid".into(), (first / columns).into(), (first % columns).into()], error);
        };
        let numbers: Vec<String> = vertices.iter().map(|&v| mesh.numbers[v].to_string()).collect();
        let words = format!("{error} (points {} of {})", numbers.join(", "), mesh.name);
        self.refused_in_words([Step::from("grid")], error, words)
    }
}
