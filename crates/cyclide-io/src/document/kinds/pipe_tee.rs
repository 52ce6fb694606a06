//! A main pipe with branches, joined by rolling-ball fillets.

use std::f64::consts::{FRAC_PI_2, PI};

use cyclide::{
    construct::{PipeTee, TeeBlend, TeeBranch, TeeEnds, TeeMain},
    model::SurfaceObject,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::forms::forms;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::facts::{BlendFacts, Facts};
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::error::Result;

/// A main pipe about the x axis with branches, each joined to it by a rolling-ball fillet; solid, or with a `wall`.
/// Branches are thinner than the main pipe and within its width, or have the same radius and an axis that intersects
/// that of the main pipe.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "pipe-tee", "main": {"radius": 10, "ends": [-40, 40]}, "branches": [{"radius": 5, "length": 30, "blend": 3}]}}}"#.parse()?;
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
pub struct PipeTeeSpec {
    /// The word `pipe-tee`.
    #[schemars(with = "String", extend("const" = "pipe-tee"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The main pipe.
    pub main: TeeMainSpec,
    /// The branches, at least one, behind or beside each other on the main pipe.
    #[schemars(length(min = 1))]
    pub branches: Vec<TeeBranchSpec>,
    /// Wall thickness of all pipes, also in the blends. Default: the tee is filled.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
    /// How the pipes end. `open` leaves a surface, without a wall.
    #[serde(default)]
    pub ends: TeeEnds,
}

/// The main pipe of a tee.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "pipe-tee", "main": {"radius": 10, "ends": [-40, 40]}, "branches": [{"radius": 5, "length": 30, "blend": 3}]}}}"#.parse()?;
/// let built = document.build()?;
/// let bounds = built[0].bodies[0].bounds();
/// assert!((bounds.min.x + 40.0).abs() < 1e-9 && (bounds.max.x - 40.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "TeeMain")]
#[non_exhaustive]
pub struct TeeMainSpec {
    /// Its outer radius; with a `taper`, that at x = 0.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Half the cone angle: positive narrows along x, negative widens. Default 0, a cylinder.
    pub taper: Option<Angle>,
    /// Positions of its ends on the x axis, the lower one first.
    pub ends: [f64; 2],
}

/// A branch of a tee.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "pipe-tee", "main": {"radius": 10, "ends": [-40, 40]}, "branches": [{"radius": 5, "length": 30, "blend": 3}]}}}"#.parse()?;
/// let built = document.build()?;
/// // Up along z by its length.
/// assert!((built[0].bodies[0].bounds().max.z - 30.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "TeeBranch")]
#[non_exhaustive]
pub struct TeeBranchSpec {
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Its outer radius; with a `taper`, that at the point of its axis nearest to the axis of the main pipe.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Half the cone angle, a draft: positive narrows towards its end, negative widens. Default 0, a cylinder.
    pub taper: Option<Angle>,
    /// Distance of its end, along its axis, from the point nearest to the axis of the main pipe.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub length: f64,
    /// Angle between its direction and the x axis. Default: a right angle.
    pub angle: Option<Angle>,
    /// Distance at which its axis passes that of the main pipe: towards +y for a branch that goes up. Less than the
    /// difference of the radii.
    #[serde(default)]
    pub offset: f64,
    /// Position on the x axis to which its axis is nearest. Default 0.
    #[serde(default)]
    pub at: f64,
    /// Its direction around the main pipe, counter-clockwise seen from +x: 0, the default, is up along z, a quarter
    /// turn is -y.
    pub azimuth: Option<Angle>,
    /// The radius of the ball that blends it with the main pipe.
    pub blend: TeeBlendSpec,
}

/// The radius of the ball of a blend, or a law of it.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "pipe-tee", "main": {"radius": 10, "ends": [-40, 40]}, "branches": [{"radius": 5, "length": 30, "blend": 3}]}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::PipeTee(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// assert_eq!(spec.branches[0].blend, cyclide_io::document::kinds::TeeBlendSpec::Radius(3.0));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "TeeBlend")]
#[non_exhaustive]
pub enum TeeBlendSpec {
    /// One radius, kept to a thousandth of it.
    Radius(#[schemars(extend("exclusiveMinimum" = 0))] f64),
    /// One radius with a tolerance, or a law.
    Law(TeeLawSpec),
}

/// A law of the radius of a ball: one of `radius`, `least`, `crotch` with `flank`, and `values`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "pipe-tee", "main": {"radius": 10, "ends": [-40, 40]}, "branches": [{"radius": 5, "length": 30, "blend": {"crotch": 4, "flank": 2}}]}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::PipeTee(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// let cyclide_io::document::kinds::TeeBlendSpec::Law(law) = &spec.branches[0].blend else { unreachable!("it is a law") };
/// assert_eq!((law.crotch, law.flank), (Some(4.0), Some(2.0)));
/// let built = document.build()?;
/// assert!(built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "TeeLaw",
    extend("oneOf" = [{"required": ["radius"]}, {"required": ["least"]}, {"required": ["crotch", "flank"]}, {"required": ["values"]}]),
    extend("dependentRequired" = {"crotch": ["flank"], "flank": ["crotch"]}),
    extend("dependentSchemas" = {"least": {"properties": {"tolerance": false}}})
)]
#[non_exhaustive]
pub struct TeeLawSpec {
    /// One radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Largest deviation from that radius or law, which no rational blend keeps exactly. Default: a thousandth of the
    /// radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
    /// The simplest blend: this radius at the flank, where it is least, and larger ones at the inner corners.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub least: Option<f64>,
    /// The radius at both inner corners, on the sides towards the ends of the main pipe.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub crotch: Option<f64>,
    /// The radius at both flanks.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub flank: Option<f64>,
    /// Radii at angles around the branch.
    #[schemars(length(min = 1))]
    pub values: Option<Vec<TeeRadiusSpec>>,
}

/// The radius of a ball at an angle.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"t": {"type": "pipe-tee", "main": {"radius": 10, "ends": [-40, 40]}, "branches": [{"radius": 5, "length": 30, "blend": {"values": [{"angle": 0, "radius": 4}, {"angle": {"degrees": 90}, "radius": 2}]}}]}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::PipeTee(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// let cyclide_io::document::kinds::TeeBlendSpec::Law(law) = &spec.branches[0].blend else { unreachable!("it is a law") };
/// let values = law.values.as_ref().expect("they are given");
/// assert_eq!((values[1].angle.radians(), values[1].radius), (std::f64::consts::FRAC_PI_2, 2.0));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "TeeRadius")]
#[non_exhaustive]
pub struct TeeRadiusSpec {
    /// Angle around a branch, counter-clockwise seen from its end: 0 is the side of the end of the main pipe (+x), 90
    /// degrees that of a positive `offset` (+y for a branch that goes up). For a crossing it is the angle of the ball
    /// about the upward normal, 0 in the direction of the first axis.
    pub angle: Angle,
    /// The radius there.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

forms! {
    TeeBlendSpec: "a radius, or a law such as `{\"crotch\": 8, \"flank\": 5}`";
    number f64 => TeeBlendSpec::Radius;
    object TeeLawSpec => TeeBlendSpec::Law;
}

impl Kind for PipeTeeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.pipe_tee(self).map(Shape::Surfaces)
    }

    fn fields(&self) -> FieldNames {
        vec![("[]", "branches"), ("pipes[]", "main")]
    }
}

impl Builder<'_> {
    /// A main pipe with branches.
    pub(in crate::document) fn pipe_tee(&mut self, spec: &PipeTeeSpec) -> Result<Vec<SurfaceObject>> {
        if spec.wall.is_some() && spec.ends == TeeEnds::Open {
            return Err(
                self.unfit("a `wall` makes a solid, whose ends are `flat`, with rings around the bore, or `closed`")
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
        let centers = Some(Box::new(made.centers));
        self.facts = Facts::Blends(BlendFacts { blends: made.blends, centers });
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
                "a blend requires exactly one of `radius`, `least`, `crotch` with `flank`, and `values`; all except `least` allow a `tolerance`",
            )),
        }
    }
}
