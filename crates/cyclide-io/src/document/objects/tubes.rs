//! Tubes of changing radius.

use cyclide::{Ball, CurveObject, Exactness, Lower as _, Point3, RadiusLaw, ShortNumber, SurfaceObject, Tube};

use super::Builder;
use super::idle::idle_in_tube;
use crate::document::spec::TubeSpec;
use crate::error::Result;

/// Part of the least radius that the tolerance is if none is given.
const TOLERANCE: f64 = 1e-3;

/// What is known of a tube besides its body.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "tube", "balls": [[0, 0, 0, 2], [10, 0, 0, 3], [20, 5, 0, 2]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].tubes[0].within, cyclide::Exactness::Exact);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TubeFacts {
    /// The least and the largest radius.
    pub radii: [f64; 2],
    /// Arcs of balls that it consists of.
    pub arcs: usize,
    /// How far it is from the tube of the law along the curve, and what that rests on.
    pub within: Exactness,
}

impl Builder<'_> {
    /// Tubes along the curves of another object, or one through balls.
    pub(super) fn tube(&mut self, spec: &TubeSpec) -> Result<Vec<SurfaceObject>> {
        let made = match (&spec.of, &spec.radius, &spec.balls) {
            (Some(_), Some(_), None) if spec.closed.is_none() => self.tubes_along(spec)?,
            (None, None, Some(balls)) if spec.tolerance.is_none() => {
                let balls: Vec<Ball> = balls.iter().map(|&[x, y, z, r]| Ball::new(Point3::new(x, y, z), r)).collect();
                let tube = Tube::through(&balls, spec.closed == Some(true)).map_err(|e| self.refused(&e, None))?;
                vec![(tube, Exactness::Exact)]
            }
            _ => {
                return Err(self.unfit(
                    "a tube runs along a curve: `of` and `radius` (within a `tolerance`), or through `balls` (which may be `closed`)",
                ));
            }
        };
        let mut tubes = Vec::new();
        for (tube, within) in made {
            let tube = tube.with_ends(spec.ends);
            let tube = match spec.wall {
                Some(wall) => tube.with_wall(wall).map_err(|e| self.refused(&e, None))?,
                None => tube,
            };
            self.tubes.push(TubeFacts { radii: tube.radii(), arcs: tube.arc_count(), within });
            tubes.push(tube);
        }
        let bodies = tubes.iter().map(Tube::body).collect::<cyclide::Result<Vec<_>>>();
        let bodies = bodies.map_err(|e| self.refused(&e, None))?;
        if let Some(([first, second], distance)) = Tube::first_meeting(&tubes) {
            let message = format!(
                "the tubes of the contours {first} and {second} run into each other ({} from centre to centre): each is a body of its own, and volume and area count what they share twice; fuse them in CAD",
                ShortNumber(distance)
            );
            self.remark("pipes-meet", Some(second), None, None, message);
        }
        self.remark_on_idle(idle_in_tube(spec, &tubes));
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }

    /// The tubes along the curves of the source, with what their distance from the law rests on.
    fn tubes_along(&self, spec: &TubeSpec) -> Result<Vec<(Tube, Exactness)>> {
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves());
        if curves.is_empty() {
            return Err(self.wrong_source("only curves have a tube along them"));
        }
        let refused = |e: cyclide::Error| self.refused(&e, None);
        let values = spec.radius.as_ref().map_or(&[][..], |law| &law.values);
        let law = RadiusLaw::new(values).map_err(refused)?;
        let least = values.iter().map(|value| value[1]).fold(f64::INFINITY, f64::min);
        let tolerance = spec.tolerance.unwrap_or(TOLERANCE * least);
        let made = curves.iter().map(|curve| along(curve, &law, tolerance)).collect::<cyclide::Result<_>>();
        made.map_err(refused)
    }
}

/// The tube along a curve: half the tolerance is for the arcs in place of it, where it is not made of arcs.
fn along(curve: &CurveObject, law: &RadiusLaw, tolerance: f64) -> cyclide::Result<(Tube, Exactness)> {
    let share = if curve.is_of_arcs() { tolerance } else { 0.5 * tolerance };
    let lowered = curve.lower_to_arcs(share)?;
    let tube = Tube::along(&lowered.form, law, share)?;
    let within = lowered.exactness.bound() + tube.bound();
    Ok(match lowered.exactness {
        Exactness::Exact if within == 0.0 => (tube, Exactness::Exact),
        Exactness::Exact | Exactness::Proved(_) => (tube, Exactness::Proved(within)),
        Exactness::Sampled(_) => (tube, Exactness::Sampled(within)),
    })
}
