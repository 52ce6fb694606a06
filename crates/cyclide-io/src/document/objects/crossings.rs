//! Crossings of pipes.

use cyclide::{CrossingPipe, PipeCrossing, SurfaceObject, TeeEnds};

use super::Builder;
use crate::document::angle::Angle;
use crate::document::spec::{CrossingBlendSpec, PipeCrossingSpec};
use crate::error::Result;
use std::f64::consts::{FRAC_PI_2, PI};

impl Builder<'_> {
    /// Two pipes that pass each other.
    pub(in crate::document) fn pipe_crossing(&mut self, spec: &PipeCrossingSpec) -> Result<Vec<SurfaceObject>> {
        if spec.wall.is_some() && spec.ends == TeeEnds::Open {
            return Err(
                self.unfit("a `wall` makes a solid: its ends are `flat`, with rings round the bores, or `closed`")
            );
        }
        let values = self.crossing_radii(spec)?;
        let made = crossing(spec, &values).and_then(|crossing| crossing.made()).map_err(|e| self.refused(&e, None))?;
        self.tee_blends = vec![made.blend];
        self.ball_centers = Some(Box::new(made.centers));
        Ok(vec![SurfaceObject::Body(made.body)])
    }

    /// The radii of the ball at its angles.
    fn crossing_radii(&self, spec: &PipeCrossingSpec) -> Result<Vec<[f64; 2]>> {
        let law = match &spec.blend {
            CrossingBlendSpec::Radius(radius) => return Ok(vec![[0.0, *radius]]),
            CrossingBlendSpec::Law(law) => law,
        };
        let turn = spec.angle.map_or(FRAC_PI_2, Angle::radians);
        match (law.first, law.second, &law.values) {
            (Some(first), Some(second), None) => {
                Ok(vec![[0.0, first], [turn, second], [PI, first], [PI + turn, second]])
            }
            (None, None, Some(values)) => Ok(values.iter().map(|value| [value.angle.turn(), value.radius]).collect()),
            _ => Err(self.unfit("a law of the radius is given by `first` with `second`, or by `values`")),
        }
    }
}

fn crossing(spec: &PipeCrossingSpec, values: &[[f64; 2]]) -> cyclide::Result<PipeCrossing> {
    let pipes = spec.pipes.map(|pipe| CrossingPipe {
        radius: pipe.radius,
        taper: pipe.taper.map_or(0.0, Angle::radians),
        ends: pipe.ends,
    });
    // One radius stands for the law until that is read.
    let first = values.first().map_or(1.0, |[_, radius]| *radius);
    let crossing = PipeCrossing::new(pipes, spec.distance, first)?.with_ends(spec.ends).with_side(spec.side);
    let crossing = match spec.angle {
        Some(angle) => crossing.with_angle(Angle::radians(angle))?,
        None => crossing,
    };
    let crossing = if values.len() != 1 { crossing.with_radii(values)? } else { crossing };
    let crossing = match spec.tolerance {
        Some(tolerance) => crossing.with_tolerance(tolerance)?,
        None => crossing,
    };
    match spec.wall {
        Some(wall) => crossing.with_wall(wall),
        None => Ok(crossing),
    }
}
