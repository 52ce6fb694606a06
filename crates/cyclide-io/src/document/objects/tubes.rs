//! Tubes of changing radius.

use cyclide::{
    Ball, Body, CurveObject, Exactness, Lower as _, PipeEnds, Point3, RadiusLaw, ShortNumber, SurfaceObject,
    TaperedTube, Tube,
};

use super::Builder;
use super::idle::idle_in_tube;
use crate::document::spec::{RadiusOf, TubeSpec};
use crate::error::Result;

/// Part of the least radius that the tolerance is if none is given; and where arcs are followed as they are and circles lie across them, whose error is of fourth order.
const TOLERANCE: f64 = 1e-3;
const TOLERANCE_ON_ARCS: f64 = 1e-5;

/// Parts of the tolerance that arcs in place of a curve are made within, one after the other.
const SHARES: [f64; 5] = [0.4, 0.2, 0.1, 0.03, 0.01];

/// Part of the largest radius below which nobody sees that a rim is not flat.
const RIM: f64 = 1e-6;

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
    /// What has these.
    pub radius_of: RadiusOf,
    /// Pieces that it consists of, arcs of balls or of sections.
    pub arcs: usize,
    /// How far it is from the tube of the law along the curve, and what that rests on.
    pub within: Exactness,
}

/// A tube of either kind.
#[derive(Clone)]
enum Made {
    Balls(Tube),
    Sections(TaperedTube),
}

impl Made {
    fn with_ends(self, ends: PipeEnds) -> Self {
        match self {
            Self::Balls(tube) => Self::Balls(tube.with_ends(ends)),
            Self::Sections(tube) => Self::Sections(tube.with_ends(ends)),
        }
    }

    fn with_wall(self, wall: f64) -> cyclide::Result<Self> {
        Ok(match self {
            Self::Balls(tube) => Self::Balls(tube.with_wall(wall)?),
            Self::Sections(tube) => Self::Sections(tube.with_wall(wall)?),
        })
    }

    fn body(&self) -> cyclide::Result<Body> {
        match self {
            Self::Balls(tube) => tube.body(),
            Self::Sections(tube) => tube.body(),
        }
    }

    fn is_closed(&self) -> bool {
        match self {
            Self::Balls(tube) => tube.is_closed(),
            Self::Sections(tube) => tube.is_closed(),
        }
    }

    fn facts(&self, within: Exactness) -> TubeFacts {
        match self {
            Self::Balls(tube) => {
                TubeFacts { radii: tube.radii(), radius_of: RadiusOf::Balls, arcs: tube.arc_count(), within }
            }
            Self::Sections(tube) => {
                TubeFacts { radii: tube.radii(), radius_of: RadiusOf::Sections, arcs: tube.piece_count(), within }
            }
        }
    }

    /// The first two that run into each other; those of one object are of one kind.
    fn first_meeting(tubes: &[Self]) -> Option<([usize; 2], f64)> {
        let (mut balls, mut sections) = (Vec::new(), Vec::new());
        for tube in tubes {
            match tube {
                Self::Balls(tube) => balls.push(tube.clone()),
                Self::Sections(tube) => sections.push(tube.clone()),
            }
        }
        Tube::first_meeting(&balls).or_else(|| TaperedTube::first_meeting(&sections))
    }
}

impl Builder<'_> {
    /// Tubes along the curves of another object, or one through balls.
    pub(in crate::document) fn tube(&mut self, spec: &TubeSpec) -> Result<Vec<SurfaceObject>> {
        let made = match (&spec.of, &spec.radius, &spec.balls) {
            (Some(_), Some(_), None) if spec.closed.is_none() => self.tubes_along(spec)?,
            (None, None, Some(balls)) if spec.tolerance.is_none() && spec.radius_of.is_none() => {
                let balls: Vec<Ball> = balls.iter().map(|&[x, y, z, r]| Ball::new(Point3::new(x, y, z), r)).collect();
                let tube = Tube::through(&balls, spec.closed == Some(true)).map_err(|e| self.refused(&e, None))?;
                vec![(Made::Balls(tube), Exactness::Exact)]
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
            if let Made::Balls(tube) = &tube {
                self.remark_on_rims(spec, tube);
            }
            self.tubes.push(tube.facts(within));
            tubes.push(tube);
        }
        let bodies = tubes.iter().map(Made::body).collect::<cyclide::Result<Vec<_>>>();
        let bodies = bodies.map_err(|e| self.refused(&e, None))?;
        if let Some(([first, second], distance)) = Made::first_meeting(&tubes) {
            let message = format!(
                "the tubes of the contours {first} and {second} run into each other ({} from centre to centre): each is a body of its own, and volume and area count what they share twice; fuse them in CAD",
                ShortNumber(distance)
            );
            self.remark("pipes-meet", Some(second), None, None, message);
        }
        self.remark_on_idle(idle_in_tube(spec, tubes.iter().all(Made::is_closed)));
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }

    /// Says where a wall along the normals of balls has rims that are no planes.
    fn remark_on_rims(&mut self, spec: &TubeSpec, tube: &Tube) {
        if spec.ends == PipeEnds::Flat && tube.rim_depth() > RIM * tube.radii()[1] {
            let message = format!(
                "the rims of the wall are along its normals, and as the radius changes at an end they are parts of cones, {} deep: cut them in CAD, or let the radius stay before the end",
                ShortNumber(tube.rim_depth())
            );
            self.remark("rims-not-flat", None, None, None, message);
        }
    }

    /// The tubes along the curves of the source, with what their distance from the law rests on.
    fn tubes_along(&self, spec: &TubeSpec) -> Result<Vec<(Made, Exactness)>> {
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves());
        if curves.is_empty() {
            return Err(self.wrong_source("only curves have a tube along them"));
        }
        let refused = |e: cyclide::Error| self.refused(&e, None);
        let values = spec.radius.as_ref().map_or(&[][..], |law| &law.values);
        let law = RadiusLaw::new(values).map_err(refused)?;
        let least = values.iter().map(|value| value[1]).fold(f64::INFINITY, f64::min);
        // Balls and sections of one radius are the same tube, whose lines of curvature the balls know.
        let radius_of = if law.is_constant() { RadiusOf::Balls } else { spec.radius_of.unwrap_or_default() };
        let made = curves.iter().map(|curve| {
            let fine = curve.is_of_arcs() && radius_of == RadiusOf::Sections;
            let part = if fine { TOLERANCE_ON_ARCS } else { TOLERANCE };
            along(curve, &law, spec.tolerance.unwrap_or(part * least), radius_of)
        });
        let made = made.collect::<cyclide::Result<_>>();
        made.map_err(refused)
    }
}

/// The tube along a curve. Arcs in place of one that is not made of arcs are made nearer until the tube is known to be within the tolerance.
fn along(
    curve: &CurveObject,
    law: &RadiusLaw,
    tolerance: f64,
    radius_of: RadiusOf,
) -> cyclide::Result<(Made, Exactness)> {
    if curve.is_of_arcs() {
        let arcs = curve.lower_to_arcs(tolerance)?.form;
        let (made, bound) = match radius_of {
            RadiusOf::Balls => {
                let tube = Tube::along(&arcs, law, tolerance)?;
                let bound = tube.bound();
                (Made::Balls(tube), bound)
            }
            RadiusOf::Sections => {
                let tube = TaperedTube::along(&arcs, law, tolerance)?;
                let bound = tube.bound();
                (Made::Sections(tube), bound)
            }
        };
        return Ok((made, if bound == 0.0 { Exactness::Exact } else { Exactness::Proved(bound) }));
    }
    let mut shares = SHARES.into_iter();
    loop {
        let share = shares.next().unwrap_or(0.0) * tolerance;
        let arcs = curve.lower_to_arcs(share)?;
        let arcs = (&arcs.form, &arcs.correspondence);
        let made = match radius_of {
            RadiusOf::Balls => Tube::along_curve(curve.as_curve(), arcs, law, tolerance).map(|tube| {
                let within = Exactness::Proved(tube.bound());
                (Made::Balls(tube), within)
            }),
            RadiusOf::Sections => TaperedTube::along_curve(curve.as_curve(), arcs, law, tolerance).map(|tube| {
                let bound = tube.bound();
                let within = if tube.is_proved() { Exactness::Proved(bound) } else { Exactness::Sampled(bound) };
                (Made::Sections(tube), within)
            }),
        };
        match made {
            Err(cyclide::Error::NotWithinTolerance { .. }) if !shares.as_slice().is_empty() => {}
            made => return made,
        }
    }
}
