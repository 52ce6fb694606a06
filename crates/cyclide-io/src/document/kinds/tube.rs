//! A tube of changing radius along a curve or through balls.

use std::fmt;

use cyclide::{
    Point3, ShortNumber,
    construct::{Ball, PipeEnds, RadiusLaw, TaperedTube, Tube},
    error::CurveError,
    model::{CurveObject, Exactness, Lower as _, SurfaceObject},
    topology::Body,
};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, SeqAccess, Visitor};

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::facts::{Facts, TubeFacts};
use crate::document::objects::idle::{Idle, NO_ENDS, found};
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape, main_field, of};
use crate::error::Result;

pub use crate::document::objects::facts::RadiusOf;

/// Part of the least radius that the tolerance is if none is given; and where arcs are followed as they are and circles lie across them, whose error is of fourth order.
const TOLERANCE: f64 = 1e-3;

const TOLERANCE_ON_ARCS: f64 = 1e-5;

/// Parts of the tolerance that arcs in place of a curve are made within, one after the other.
const SHARES: [f64; 5] = [0.4, 0.2, 0.1, 0.03, 0.01];

/// Part of the largest radius below which nobody sees that a rim is not flat.
const RIM: f64 = 1e-6;

/// A tube of changing radius along a curve (`of`, `radius`) or through balls (`balls`), solid or with a `wall`. Along a
/// curve the section across each point is a circle with the radius there, so the tube begins and ends where the curve
/// does. Through balls the tube is their envelope.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"cone": {"type": "tube", "balls": [[0, 0, 0, 2], [10, 0, 0, 1]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("oneOf" = [{"required": ["of", "radius"]}, {"required": ["balls"]}]),
    extend("if" = {"required": ["balls"]}),
    extend("then" = {"properties": {"radius": false, "radius_of": false, "tolerance": false}}),
    extend("else" = {"properties": {"closed": false}})
)]
#[non_exhaustive]
pub struct TubeSpec {
    /// The word `tube`.
    #[schemars(with = "String", extend("const" = "tube"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the curve along which it runs, which may be construction geometry.
    pub of: Option<String>,
    /// The radius along the curve: one; a list of radii, evenly spaced over the length; or a list of `{"at": 0.3,
    /// "radius": 2}`, at fractions of the length. Between given radii it varies smoothly and never beyond them.
    pub radius: Option<RadiusLawSpec>,
    /// What has the radius along a curve. Default `sections`.
    pub radius_of: Option<RadiusOf>,
    /// Balls `[x, y, z, radius]` that the tube touches all round, in this order. The tube is exact.
    #[schemars(length(min = 2))]
    pub balls: Option<Vec<[f64; 4]>>,
    /// Whether the tube through balls returns to the first one. Default `false`.
    pub closed: Option<bool>,
    /// Thickness of the wall around a bore; default: no bore. Along a curve it is measured across the curve, so that
    /// the bore has the radius less the wall; for balls it is measured along the normals of the envelope.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
    /// How an open tube ends. A round end is a part of a ball: for sections the ball that continues the tube with its
    /// slope, for balls the rest of the ball.
    #[serde(default)]
    pub ends: PipeEnds,
    /// Largest distance from the tube with the given law of radii; it is 0 along segments, and along arcs where the
    /// radius is constant. Default: a thousandth of the least radius; a hundred-thousandth along arcs with a radius of
    /// sections.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// The radius along a curve, as fractions of its length and radii there.
///
/// ```
/// use cyclide_io::document::kinds::RadiusLawSpec;
/// let law: RadiusLawSpec = serde_json::from_str("[2, 3, 2]")?;
/// assert_eq!(law.values, [[0.0, 2.0], [0.5, 3.0], [1.0, 2.0]]);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RadiusLawSpec {
    /// Fractions of the length, and radii.
    pub values: Vec<[f64; 2]>,
}

/// The radius at a place.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "RadiusAt")]
struct RadiusAt {
    /// Fraction of the length.
    #[schemars(range(min = 0, max = 1))]
    at: f64,
    /// The radius there.
    #[schemars(extend("exclusiveMinimum" = 0))]
    radius: f64,
}

/// An entry of a list.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a radius, or an object such as {\"at\": 0.3, \"radius\": 2}")]
#[schemars(inline)]
enum Entry {
    Radius(#[schemars(extend("exclusiveMinimum" = 0))] f64),
    At(RadiusAt),
}

/// The radius along a curve: one, a list of evenly spaced ones, or a list of `{"at": 0.3, "radius": 2}`.
#[derive(JsonSchema)]
#[schemars(untagged, rename = "RadiusLaw")]
#[expect(dead_code, reason = "it stands for the schema")]
enum Form {
    /// One radius.
    One(#[schemars(extend("exclusiveMinimum" = 0))] f64),
    /// Evenly spaced radii.
    Even(#[schemars(length(min = 1))] Vec<f64>),
    /// Radii at fractions of the length, which increase.
    At(#[schemars(length(min = 1))] Vec<RadiusAt>),
}

impl JsonSchema for RadiusLawSpec {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        Form::schema_name()
    }
    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        Form::json_schema(generator)
    }
}

impl<'de> Deserialize<'de> for RadiusLawSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(LawVisitor)
    }
}

struct LawVisitor;

impl<'de> Visitor<'de> for LawVisitor {
    type Value = RadiusLawSpec;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a radius, a list of radii, or a list of entries such as `{\"at\": 0.3, \"radius\": 2}`")
    }

    fn visit_f64<E>(self, radius: f64) -> Result<RadiusLawSpec, E> {
        Ok(RadiusLawSpec { values: vec![[0.0, radius]] })
    }

    fn visit_u64<E>(self, radius: u64) -> Result<RadiusLawSpec, E> {
        Ok(RadiusLawSpec { values: vec![[0.0, radius as f64]] })
    }

    fn visit_i64<E>(self, radius: i64) -> Result<RadiusLawSpec, E> {
        Ok(RadiusLawSpec { values: vec![[0.0, radius as f64]] })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<RadiusLawSpec, A::Error> {
        let (mut even, mut at) = (Vec::new(), Vec::new());
        while let Some(entry) = list.next_element::<Entry>()? {
            match entry {
                Entry::Radius(radius) => even.push(radius),
                Entry::At(RadiusAt { at: place, radius }) => at.push([place, radius]),
            }
        }
        if !even.is_empty() && !at.is_empty() {
            return Err(serde::de::Error::custom(
                "either all radii or none must have a position `at`; without it they are evenly spaced",
            ));
        }
        let steps = even.len().saturating_sub(1).max(1) as f64;
        let spaced = even.into_iter().enumerate().map(|(k, radius)| [k as f64 / steps, radius]);
        Ok(RadiusLawSpec { values: if at.is_empty() { spaced.collect() } else { at } })
    }
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

impl Kind for TubeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.tube(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.of.as_deref().map(of).unwrap_or_default()
    }

    fn fields(&self) -> FieldNames {
        if self.balls.is_some() { vec![("", "balls")] } else { main_field("radius") }
    }
}

impl Builder<'_> {
    /// Tubes along the curves of another object, or one through balls.
    pub(in crate::document) fn tube(&mut self, spec: &TubeSpec) -> Result<Vec<SurfaceObject>> {
        let made = match (&spec.of, &spec.radius, &spec.balls) {
            (Some(_), Some(law), None) if spec.closed.is_none() => self.tubes_along(spec, &law.values)?,
            (None, None, Some(balls)) if spec.tolerance.is_none() && spec.radius_of.is_none() => {
                let balls: Vec<Ball> = balls.iter().map(|&[x, y, z, r]| Ball::new(Point3::new(x, y, z), r)).collect();
                let tube = Tube::through(&balls, spec.closed == Some(true)).map_err(|e| self.refused(&e, None))?;
                vec![(Made::Balls(tube), Exactness::Exact)]
            }
            _ => {
                return Err(self.unfit(
                    "a tube requires either a curve `of` with a `radius` (and optionally a `tolerance`), or `balls` (optionally `closed`)",
                ));
            }
        };
        let (mut tubes, mut known) = (Vec::new(), Vec::new());
        for (tube, within) in made {
            let tube = tube.with_ends(spec.ends);
            let tube = match spec.wall {
                Some(wall) => tube.with_wall(wall).map_err(|e| self.refused(&e, None))?,
                None => tube,
            };
            if let Made::Balls(tube) = &tube {
                self.remark_on_rims(spec, tube);
            }
            known.push(tube.facts(within));
            tubes.push(tube);
        }
        self.facts = Facts::Tubes(known);
        let bodies = tubes.iter().map(Made::body).collect::<cyclide::Result<Vec<_>>>();
        let bodies = bodies.map_err(|e| self.refused(&e, None))?;
        if let Some(([first, second], distance)) = Made::first_meeting(&tubes) {
            let message = format!(
                "the tubes of contours {first} and {second} intersect (distance of the centers {}): they are separate bodies, and volume and area count their intersection twice; fuse them in CAD",
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
                "the rims of the wall are along its normals, so a radius that changes at an end makes them conical, {} deep: cut them in CAD, or keep the radius constant near the end",
                ShortNumber(tube.rim_depth())
            );
            self.remark("rims-not-flat", None, None, None, message);
        }
    }

    /// The tubes along the curves of the source, with what their distance from the law rests on.
    fn tubes_along(&self, spec: &TubeSpec, values: &[[f64; 2]]) -> Result<Vec<(Made, Exactness)>> {
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves());
        if curves.is_empty() {
            return Err(self.wrong_source("a tube requires a curve"));
        }
        let refused = |e: cyclide::Error| self.refused(&e, None);
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

/// What a tube does not look at; `closed` if all are.
pub(in crate::document) fn idle_in_tube(spec: &TubeSpec, closed: bool) -> Vec<Idle> {
    let equal = |pair: &[[f64; 2]]| pair[0][1].total_cmp(&pair[1][1]).is_eq();
    let constant = spec.radius.as_ref().is_some_and(|law| law.values.windows(2).all(equal));
    found(&[
        (
            "radius_of",
            constant && spec.radius_of.is_some(),
            "with a constant radius, sections and balls give the same tube",
        ),
        ("ends", closed && spec.ends != PipeEnds::Flat, NO_ENDS),
        (
            "ends",
            !closed && spec.ends == PipeEnds::Open && spec.wall.is_some(),
            "a wall ends in rings; without `wall` the tube is open",
        ),
    ])
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
            Err(cyclide::Error::Curve(CurveError::NotWithinTolerance { .. })) if !shares.as_slice().is_empty() => {}
            made => return made,
        }
    }
}
