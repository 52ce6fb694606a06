//! The surface or solid swept by a curve that turns about an axis.

use cyclide::{
    ShortNumber, Vec3,
    construct::Revolution,
    model::{CurveObject, SurfaceObject},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape, main_field, of};
use crate::error::Result;

/// An angle in radians that leaves less of a whole turn than this may be one, typed with three digits or more.
const NEARLY_WHOLE: f64 = 5e-3;

/// Places of a curve that are looked at for its distance from the axis, which is only told.
const PLACES: u32 = 256;

/// The surface or solid swept by a curve that turns about an axis.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [3, 0], "radius": 1}, "r": {"type": "revolution", "of": "c", "axis": [0, 1, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[1].bodies[0].outer.volume() - 6.0 * std::f64::consts::PI.powi(2)).abs() < 1e-10);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct RevolutionSpec {
    /// The word `revolution`.
    #[schemars(with = "String", extend("const" = "revolution"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the curve, which may be construction geometry. It may meet the axis only at its ends; if it is closed,
    /// or both ends are on the axis, the result is a solid.
    pub of: String,
    /// Axis about which a positive angle turns counter-clockwise, of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// A point on the axis. Default: the origin.
    pub center: Option<Coordinates>,
    /// Angle of the turn. Default: a whole turn.
    pub angle: Option<Angle>,
}

impl Kind for RevolutionSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.revolution(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn fields(&self) -> FieldNames {
        main_field("of")
    }
}

impl Builder<'_> {
    /// What the curves of another object sweep.
    pub(in crate::document) fn revolution(&mut self, spec: &RevolutionSpec) -> Result<Vec<SurfaceObject>> {
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves());
        if curves.is_empty() {
            return Err(self.wrong_source("a revolution requires a curve"));
        }
        let axis = spec.axis.map_or(Vec3::Z, Coordinates::vector);
        let center = spec.center.unwrap_or_default().point();
        let angle = spec.angle.map_or(std::f64::consts::TAU, Angle::radians);
        let turn = Revolution::new(center, axis, angle).map_err(|e| self.refused(&e, None))?;
        let several = curves.len() > 1;
        let profiles = curves.iter().map(CurveObject::exact_pieces).collect::<cyclide::Result<Vec<_>>>();
        let profiles = profiles.map_err(|e| self.refused(&e, None))?;
        let bodies = turn.bodies(&profiles).map_err(|e| self.refused(&e, None))?;
        if let Some(Angle::Radians(angle)) = spec.angle
            && !turn.is_whole()
        {
            let axis = axis.unit().unwrap_or_default();
            let way = |t: f64, curve: &CurveObject| curve.as_curve().point(t) - center;
            let places =
                curves.iter().flat_map(|curve| (0..=PLACES).map(move |k| way(f64::from(k) / f64::from(PLACES), curve)));
            let radius = places.map(|way| way.cross(axis).length()).fold(0.0, f64::max);
            self.ask_about_slit(angle, radius);
        }
        for (contour, warning) in turn.warnings(&profiles).map_err(|e| self.refused(&e, None))? {
            self.warn_at("of", several.then_some(contour), warning);
        }
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }

    /// Asks whether a whole turn is meant by one that is nearly so, as by 6.2831853 radians.
    fn ask_about_slit(&mut self, angle: f64, radius: f64) {
        let open = std::f64::consts::TAU - angle.abs();
        if open > NEARLY_WHOLE {
            return;
        }
        let message = format!(
            "the angle {angle} differs from a full turn by {} radians, which leaves a slit about {} wide where the curve is farthest from the axis: for a full turn, remove `angle`",
            ShortNumber(open),
            ShortNumber(open * radius)
        );
        let place = self.place_of([Step::from("angle")]);
        self.remark("nearly-full-turn", None, None, place, message);
    }
}
