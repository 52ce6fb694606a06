//! Nets round the extraordinary vertices of a mesh: from quads in a file to the kernel's surface.

use cyclide::{
    Error as KernelError,
    error::{GridError, PartError, PatchError, PointError},
    model::SurfaceObject,
    surface::{NetLayout, QuadLayout},
};

use crate::document::kinds::cyclidic_net::CyclidicNetSpec;
use crate::document::kinds::fields::frame::FrameSpec;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::error::{Error, Result};
use crate::export::given_surface::GivenSurface;

/// Largest angle (radians, rms) of the normals of a net to those of its mesh. Measured: 0.1 to 3 degrees on domes and balls of 4 to 32 quads a sector, 4.4, 5.9
/// and 13 on balls of 5, 4 and 3 quads a side; 36 to 66 where flat faces make nets that bulge.
const MOST_TILT: f64 = 0.35;

/// From here on it is told: flat faces of slopes from 0.2 on, and meshes of five quads a sector or fewer.
const TOLD_TILT: f64 = 0.07;

/// From here on it is no bulge any more.
const FOLDED: f64 = 1.2;

/// Vertices that a message names, at most.
const MOST_NAMED: usize = 6;

impl Builder<'_> {
    /// The nets over the grids of a mesh.
    pub(in crate::document) fn net_layout(
        &mut self,
        spec: &CyclidicNetSpec,
        given: QuadLayout,
    ) -> Result<Vec<SurfaceObject>> {
        if !spec.openings.is_empty() {
            return Err(self.unfit(
                "`openings` are columns and rows of a single grid: a mesh with extraordinary vertices has several grids, and openings only around these vertices",
            ));
        }
        if let FrameSpec::First(_) = spec.frame {
            return Err(self.unfit("a mesh with extraordinary vertices determines its frames itself: remove `frame`"));
        }
        if spec.make_circular.border_curves().is_some() {
            let words = "a mesh with extraordinary vertices does not have four sides for curves: make its border `free` or `pinned`";
            let place = ["make_circular".into(), "border".into()];
            return Err(self.refused_in_words(place, "cells-unfit", words.to_owned()));
        }
        let layout = match spec.make_circular.options() {
            Some(options) => self.circular_layout(spec, &options, &given)?,
            None => given.clone(),
        };
        self.given = match self.followed(spec) {
            Some(surface) => Some(surface),
            None => spec.make_circular.options().map(|_| GivenSurface::from_layout(&given)),
        };
        let net = NetLayout::new(layout).map_err(|e| self.refused_in_layout(spec, &given, &e))?;
        let allowed = spec.make_circular.options().is_some_and(|options| options.allow_shape_change);
        let tilt = net.tilt();
        if !(tilt <= MOST_TILT || allowed) {
            let bulges = if tilt > FOLDED { "is folded" } else { "bulges" };
            let words = format!(
                "the net {bulges}: its normals deviate by {:.0} degrees (rms) from those of the mesh (at most {:.0}); \
                 around an extraordinary vertex the mesh must be smooth, so round the edges of a box first, or use a \
                 separate net for each side; `\"allow_shape_change\": true` in `make_circular` accepts the net as it \
                 is",
                tilt.to_degrees(),
                MOST_TILT.to_degrees()
            );
            return Err(self.refused_in_words([Step::from("grid")], "shape-lost", words));
        }
        if tilt > TOLD_TILT {
            let message = format!(
                "the net bulges between its vertices: its normals deviate by {:.0} degrees (rms) from those of the mesh; inspect it, and use more quads, or round edges of the mesh first",
                tilt.to_degrees()
            );
            let place = self.place_of([Step::from("grid")]);
            self.remark("shape-changed", None, None, place, message);
        }
        self.remark_openings(&given);
        Ok(vec![SurfaceObject::Layout(net)])
    }

    /// Says that quads of the mesh have no patch.
    fn remark_openings(&mut self, layout: &QuadLayout) {
        let round = layout.round();
        let vertices: Vec<usize> = round.iter().take(MOST_NAMED).map(|at| at.vertex).collect();
        let quads: usize = round.iter().map(|at| at.quads.len()).sum();
        let vertices = match (round.len(), &self.laid_of) {
            (1, _) => format!("{} is an extraordinary vertex: its", self.named_points(layout, &vertices)),
            (count, Some(of)) => format!("{count} umbilics are extraordinary vertices of `{of}`: their"),
            (count, None) => {
                let named: Vec<String> = vertices.iter().map(|v| (v + 1).to_string()).collect();
                let (named, more) = (named.join(", "), if count > MOST_NAMED { ", …" } else { "" });
                format!("{count} points of {} are extraordinary vertices ({named}{more}): their", self.mesh_name())
            }
        };
        let grids = layout.pieces().len();
        let message =
            format!("{vertices} {quads} quads stay open, and the net of {grids} grids continues around each opening");
        let place = self.place_of([Step::from("grid")]);
        self.remark("extraordinary-vertices", None, Some(round[0].vertex), place, message);
    }

    /// What the kernel said of a mesh, or of what became of it.
    pub(in crate::document) fn refused_in_layout(
        &self,
        spec: &CyclidicNetSpec,
        given: &QuadLayout,
        error: &KernelError,
    ) -> Error {
        let moves = spec.make_circular.options().is_some();
        let points = |vertices: &[usize]| format!(" ({})", self.named_points(given, vertices));
        let words = match error {
            KernelError::Point(PointError::CoincidentPoints { first, second, .. }) => {
                format!("{error}{}", points(&[*first, *second]))
            }
            KernelError::Part(PartError::InQuad { quad, cause }) => {
                let corners = given.corners(*quad).map(|corners| points(&corners)).unwrap_or_default();
                let hint = match **cause {
                    KernelError::Patch(PatchError::NotConcircular { .. }) if !moves => {
                        "; use `make_circular`, which moves the vertices until they do"
                    }
                    _ => "",
                };
                format!("{error}{hint}{corners}")
            }
            KernelError::Grid(GridError::RingDoesNotClose { vertex, .. }) => {
                let hint = if moves {
                    "; if it is the corner of a box, round its edges in the mesh first, or use a separate net for each side"
                } else {
                    "; use `make_circular`, which moves the vertices of a smooth mesh until it closes"
                };
                format!("{error}{hint}{}", points(&[*vertex]))
            }
            // What concerns the whole, as of a single grid.
            _ => return self.refused_in_grid(spec, &given.pieces()[0].grid, error),
        };
        self.refused_in_words([Step::from("grid")], error.reason(), words)
    }
}
