//! Crossings of pipes.

use cyclide::{CrossingPipe, PipeCrossing, SurfaceObject, TeeEnds};

use super::Builder;
use crate::document::angle::Angle;
use crate::document::spec::PipeCrossingSpec;
use crate::error::Result;

impl Builder<'_> {
    /// Two pipes that pass each other.
    pub(super) fn pipe_crossing(&mut self, spec: &PipeCrossingSpec) -> Result<Vec<SurfaceObject>> {
        if spec.wall.is_some() && spec.ends == TeeEnds::Open {
            return Err(
                self.unfit("a `wall` makes a solid: its ends are `flat`, with rings round the bores, or `closed`")
            );
        }
        let made = crossing(spec).and_then(|crossing| crossing.made()).map_err(|e| self.refused(&e, None))?;
        self.tee_blends = vec![made.blend];
        Ok(vec![SurfaceObject::Body(made.body)])
    }
}

fn crossing(spec: &PipeCrossingSpec) -> cyclide::Result<PipeCrossing> {
    let pipes = spec.pipes.map(|pipe| CrossingPipe { radius: pipe.radius, ends: pipe.ends });
    let crossing = PipeCrossing::new(pipes, spec.distance, spec.blend)?.with_ends(spec.ends);
    let crossing = spec.angle.map_or(Ok(crossing), |angle| crossing.with_angle(Angle::radians(angle)))?;
    let crossing = spec.tolerance.map_or(Ok(crossing), |tolerance| crossing.with_tolerance(tolerance))?;
    spec.wall.map_or(Ok(crossing), |wall| crossing.with_wall(wall))
}
