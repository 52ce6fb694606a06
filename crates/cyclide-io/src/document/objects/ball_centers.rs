//! The ways of the centres of the balls of blends, and the surface that they run on.

use cyclide::{BallCenters, Body, CurveObject, Shell, SurfaceObject};

use super::Builder;
use crate::document::locate::Step;
use crate::document::spec::CenterSurfaceSpec;
use crate::error::Result;

impl Builder<'_> {
    /// Where the balls are that the source is made with.
    fn centers_of_source(&self) -> Result<&BallCenters> {
        let source = self.sources.first().and_then(|source| source.ball_centers.as_deref());
        source.ok_or_else(|| {
            self.wrong_source(
                "only a `pipe-tee`, a `pipe-crossing` and a `contact-blend` are made with balls (of an image take those of its original, and map these)",
            )
        })
    }

    /// The ways of the centres.
    pub(in crate::document) fn ball_centers(&self) -> Result<Vec<CurveObject>> {
        Ok(self.centers_of_source()?.paths().iter().cloned().map(CurveObject::Nurbs).collect())
    }

    /// The surface of all centres.
    pub(in crate::document) fn center_surface(&self, spec: &CenterSurfaceSpec) -> Result<Vec<SurfaceObject>> {
        let surface = self.centers_of_source()?.surface(spec.margin).map_err(|e| {
            let field = if matches!(e, cyclide::Error::NoCenterSurface) { "of" } else { "margin" };
            self.refused_at([Step::from(field)], &e)
        })?;
        let outer = Shell::from_surface(surface).map_err(|e| self.refused(&e, None))?;
        Ok(vec![SurfaceObject::Body(Body { outer, voids: Vec::new() })])
    }
}
