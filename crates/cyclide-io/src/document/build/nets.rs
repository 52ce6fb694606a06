//! Nets and whole cyclides: from grids and parameters to the kernel's surfaces.

use cyclide::{CyclidicNet, DupinCyclide, Error as KernelError, Frame, NetFrame, QuadGrid, SurfaceObject, Vec3};

use super::Builder;
use super::surfaces::direction;
use crate::document::coordinates::Coordinates;
use crate::document::locate::{Step, path_text, span_of};
use crate::document::spec::{CyclideSpec, CyclidicNetSpec, FrameSpec};
use crate::error::{Error, Result};

/// Patches of a whole cyclide round the hole and round the tube.
const SEGMENTS: [u32; 2] = [4, 4];

impl Builder<'_> {
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
    pub(super) fn net(&self, spec: &CyclidicNetSpec) -> Result<Vec<SurfaceObject>> {
        let grid = self.grid(spec)?;
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

    fn grid(&self, spec: &CyclidicNetSpec) -> Result<QuadGrid> {
        let rows = &spec.grid;
        let columns = rows.first().map_or(0, Vec::len);
        if let Some(row) = rows.iter().position(|row| row.len() != columns) {
            let path = self.path(["grid".into(), row.into()]);
            let span = span_of(&self.document.text, &path).unwrap_or(0..0);
            let message = format!("row {row} has {} points, the first has {columns}", rows[row].len());
            return Err(Error::Input(self.document.source().diagnostic(span, &path_text(&path), message)));
        }
        let points = rows.iter().flatten().map(|p| p.point()).collect();
        QuadGrid::new(points, [columns, rows.len()], spec.closed).map_err(|e| self.refused_at([Step::from("grid")], &e))
    }

    /// The message for what the kernel said about a quad, a vertex or the frame of a net.
    fn refused_in_grid(&self, grid: &QuadGrid, error: &KernelError) -> Error {
        let place =
            |index: usize, columns: usize| vec!["grid".into(), (index / columns).into(), (index % columns).into()];
        let path: Vec<Step> = match error {
            KernelError::FrameNotOrthonormal { .. } | KernelError::NotFinite { what: "frame vector", .. } => {
                vec!["frame".into()]
            }
            KernelError::CoincidentPoints { second, .. } => place(*second, grid.size()[0]),
            _ => error.index().map_or_else(|| vec!["grid".into()], |quad| place(quad, grid.quads()[0])),
        };
        self.refused_at(path, error)
    }
}
