//! Two pipes that pass each other, joined by a rolling-ball fillet.

use std::f64::consts::{FRAC_PI_2, PI};

use cyclide::{
    construct::{CrossingPipe, CrossingSide, PipeCrossing, TeeEnds},
    model::SurfaceObject,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::forms::forms;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::pipe_tee::TeeRadiusSpec;
use crate::document::objects::Builder;
use crate::document::objects::facts::{BlendFacts, Facts};
use crate::document::objects::kind::{FieldNames, Kind, Shape, main_field};
use crate::error::Result;

/// Two pipes (cylinders or cones) that pass each other, joined by a rolling-ball fillet. The first pipe is about the x
/// axis, the second `distance` above it, at an `angle` to it; the body is solid, or has a `wall` and one bore. If the
/// pipes do not touch, the blend is a bridge between them.
///
/// With the `side` `inside` the body is the intersection of the pipes, with `mixed` it is the second pipe minus the
/// first; its edge is rounded.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": 4}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("if" = {"properties": {"ends": {"const": "open"}}, "required": ["ends"]}),
    extend("then" = {"properties": {"wall": false}})
)]
#[non_exhaustive]
pub struct PipeCrossingSpec {
    /// The word `pipe-crossing`.
    #[schemars(with = "String", extend("const" = "pipe-crossing"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The pipe about the x axis, and the one above it.
    pub pipes: [CrossingPipeSpec; 2],
    /// Distance between the axes, greater than the difference of the radii.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub distance: f64,
    /// Angle of the second axis from the first, about the upward normal: between 0 and 180 degrees, and farther from
    /// both than the sum of the tapers. Default: a right angle.
    pub angle: Option<Angle>,
    /// Radius of the ball, or for cylinders a law of the radius. If the pipes do not touch, it is more than half the
    /// gap.
    pub blend: CrossingBlendSpec,
    /// The sides of the pipes on which the ball rolls; `mixed` is for cylinders only. Default: outside both.
    #[serde(default)]
    pub side: CrossingSide,
    /// Largest deviation from that radius or law, which no rational blend keeps exactly. Default: a thousandth of the
    /// radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
    /// Wall thickness of both pipes, also in the blend: there is one bore, or a hollow in the intersection (`inside`).
    /// Default: the crossing is filled.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
    /// How the pipes end; the intersection has no ends. `open` leaves a surface, without a wall.
    #[serde(default)]
    pub ends: TeeEnds,
}

/// A pipe of a crossing.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": 4}}}"#.parse()?;
/// let built = document.build()?;
/// let bounds = built[0].bodies[0].bounds();
/// assert!((bounds.max.x - 40.0).abs() < 1e-9 && (bounds.max.y - 35.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "CrossingPipe")]
#[non_exhaustive]
pub struct CrossingPipeSpec {
    /// Its outer radius; with a `taper`, that where the axes are nearest to each other.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Half the cone angle: positive narrows along its axis, negative widens. Default: a cylinder.
    pub taper: Option<Angle>,
    /// Positions of its ends along its axis, measured from the point nearest to the other axis; the lower one first.
    pub ends: [f64; 2],
}

/// The radius of the ball of a crossing, or a law of it.
///
/// ```
/// use cyclide_io::{Document, document::kinds::CrossingBlendSpec};
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": 4}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::PipeCrossing(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// assert_eq!(spec.blend, CrossingBlendSpec::Radius(4.0));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "CrossingBlend")]
#[non_exhaustive]
pub enum CrossingBlendSpec {
    /// One radius.
    Radius(#[schemars(extend("exclusiveMinimum" = 0))] f64),
    /// A law of the radius.
    Law(CrossingLawSpec),
}

/// A law of the radius of the ball of a crossing: `first` with `second`, or `values`. Between the given radii it
/// changes smoothly and does not overshoot.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": {"first": 3, "second": 4.5}}}}"#.parse()?;
/// let built = document.build()?;
/// let [least, most] = built[0].facts.blends().expect("it has one").blends[0].radii;
/// assert!((least - 3.0).abs() < 0.01 && (most - 4.5).abs() < 0.01);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "CrossingLaw",
    extend("oneOf" = [{"required": ["first", "second"]}, {"required": ["values"]}]),
    extend("dependentRequired" = {"first": ["second"], "second": ["first"]})
)]
#[non_exhaustive]
pub struct CrossingLawSpec {
    /// The radius where the ball is in the direction of the first axis, on both sides.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub first: Option<f64>,
    /// The radius where it is in the direction of the second axis, on both sides.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub second: Option<f64>,
    /// Radii at angles of the ball about the upward normal.
    #[schemars(length(min = 1))]
    pub values: Option<Vec<TeeRadiusSpec>>,
}

forms! {
    CrossingBlendSpec: "a radius, or a law such as `{\"first\": 8, \"second\": 5}`";
    number f64 => CrossingBlendSpec::Radius;
    object CrossingLawSpec => CrossingBlendSpec::Law;
}

impl Kind for PipeCrossingSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.pipe_crossing(self).map(Shape::Surfaces)
    }

    fn fields(&self) -> FieldNames {
        main_field("pipes")
    }
}

impl Builder<'_> {
    /// Two pipes that pass each other.
    pub(in crate::document) fn pipe_crossing(&mut self, spec: &PipeCrossingSpec) -> Result<Vec<SurfaceObject>> {
        if spec.wall.is_some() && spec.ends == TeeEnds::Open {
            return Err(
                self.unfit("a `wall` makes a solid, whose ends are `flat`, with rings around the bores, or `closed`")
            );
        }
        let values = self.crossing_radii(spec)?;
        let made = crossing(spec, &values).and_then(|crossing| crossing.made()).map_err(|e| self.refused(&e, None))?;
        let centers = Some(Box::new(made.centers));
        self.facts = Facts::Blends(BlendFacts { blends: vec![made.blend], centers });
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
            _ => Err(self.unfit("a radius law requires `first` with `second`, or `values`")),
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
