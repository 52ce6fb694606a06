//! Tees of pipes.

use cyclide::{PipeTee, SurfaceObject, TeeBlend, TeeBranch, TeeEnds, TeeMain};

use super::Builder;
use crate::document::angle::Angle;
use crate::document::spec::{PipeTeeSpec, TeeBlendSpec, TeeBranchSpec, TeeLawSpec, TeeMainSpec};
use crate::error::Result;
use std::f64::consts::{FRAC_PI_2, PI};

impl Builder<'_> {
    /// A main pipe with branches.
    pub(in crate::document) fn pipe_tee(&mut self, spec: &PipeTeeSpec) -> Result<Vec<SurfaceObject>> {
        if spec.wall.is_some() && spec.ends == TeeEnds::Open {
            return Err(
                self.unfit("a `wall` makes a solid: its ends are `flat`, with rings round the bore, or `closed`")
            );
        }
        let TeeMainSpec { radius, taper, ends } = spec.main;
        let main = TeeMain { radius, taper: taper.map_or(0.0, Angle::radians), ends };
        let branches = spec.branches.iter().map(|branch| self.tee_branch(branch)).collect::<Result<Vec<_>>>()?;
        let tee = PipeTee::new(main, branches).map_err(|e| self.refused(&e, None))?.with_ends(spec.ends);
        let tee = match spec.wall {
            Some(wall) => tee.with_wall(wall).map_err(|e| self.refused(&e, None))?,
            None => tee,
        };
        let made = tee.made().map_err(|e| self.refused(&e, None))?;
        self.tee_blends = made.blends;
        self.ball_centers = Some(Box::new(made.centers));
        Ok(vec![SurfaceObject::Body(made.body)])
    }

    fn tee_branch(&self, spec: &TeeBranchSpec) -> Result<TeeBranch> {
        Ok(TeeBranch {
            radius: spec.radius,
            taper: spec.taper.map_or(0.0, Angle::radians),
            length: spec.length,
            angle: spec.angle.map_or(FRAC_PI_2, Angle::radians),
            offset: spec.offset,
            at: spec.at,
            azimuth: spec.azimuth.map_or(0.0, Angle::turn),
            blend: match &spec.blend {
                TeeBlendSpec::Radius(radius) => TeeBlend::Radius { radius: *radius, tolerance: None },
                TeeBlendSpec::Law(law) => self.tee_law(law)?,
            },
        })
    }

    fn tee_law(&self, law: &TeeLawSpec) -> Result<TeeBlend> {
        let TeeLawSpec { radius, tolerance, least, crotch, flank, values } = law;
        match (radius, tolerance, least, crotch, flank, values) {
            (Some(radius), tolerance, None, None, None, None) => {
                Ok(TeeBlend::Radius { radius: *radius, tolerance: *tolerance })
            }
            (None, None, Some(least), None, None, None) => Ok(TeeBlend::Least(*least)),
            (None, tolerance, None, Some(crotch), Some(flank), None) => {
                let quarters = [(0.0, crotch), (FRAC_PI_2, flank), (PI, crotch), (3.0 * FRAC_PI_2, flank)];
                let values = quarters.map(|(angle, &radius)| [angle, radius]).to_vec();
                Ok(TeeBlend::Angles { values, tolerance: *tolerance })
            }
            (None, tolerance, None, None, None, Some(values)) => {
                let values = values.iter().map(|value| [value.angle.turn(), value.radius]).collect();
                Ok(TeeBlend::Angles { values, tolerance: *tolerance })
            }
            _ => Err(self.unfit(
                "a blend is given by one of `radius`, `least`, `crotch` with `flank`, and `values`; all but `least` take a `tolerance`",
            )),
        }
    }
}
