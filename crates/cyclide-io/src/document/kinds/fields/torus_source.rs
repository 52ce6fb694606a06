//! The torus that a curve lies on: given in place, or another object.

use cyclide::{
    Point2, ShortNumber,
    model::CurveObject,
    surface::{Torus, TorusSpline},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::forms::forms;
use crate::document::kinds::fields::frame::frame_of_axes;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::error::{Error, Result};

/// Distance within which points must be near the torus where nothing is said, as part of its major radius: more than the rounding
/// of coordinates with six digits after the point, less than anybody sees.
pub(in crate::document) const NEAR: f64 = 1e-6;

/// A ring torus: a tube about a circle.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "torus-circle", "torus": {"major_radius": 3, "minor_radius": 1, "center": [0, 0, 5]}, "family": "parallel", "at": [0, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// let point = built[0].item.curves()[0].as_curve().point(0.0);
/// assert!((point.x - 4.0).abs() < 1e-12 && (point.z - 5.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Torus")]
#[non_exhaustive]
pub struct TorusSpec {
    /// Radius of the center circle of the tube.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub major_radius: f64,
    /// Radius of the tube, smaller than `major_radius`.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub minor_radius: f64,
    /// Position of the center. Default: the origin.
    pub center: Option<Coordinates>,
    /// Axis of the torus, of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// Direction of the longitude 0, perpendicular to `axis`, of any length. Default `[1, 0, 0]`, or for another `axis`
    /// the direction nearest to it.
    pub x_direction: Option<Coordinates>,
}

/// The torus of a curve.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"ring": {"type": "cyclide", "a": 40, "mu": 15}, "k": {"type": "torus-knot", "torus": "ring", "turns": [2, 3]}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::TorusKnot(spec) = &document.objects[1].1 else { unreachable!("by its type") };
/// assert_eq!(spec.torus, cyclide_io::document::kinds::TorusSource::Named("ring".to_owned()));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "TorusSource")]
pub enum TorusSource {
    /// Its radii and position.
    Here(TorusSpec),
    /// Name of a `cyclide` with `c` = 0, or of a `transform` of one that is a similarity.
    Named(String),
}

impl TorusSource {
    /// The name of an object, if it is one, with its path.
    pub(in crate::document) fn reference(&self) -> Vec<(Vec<Step>, &str)> {
        self.name().map(|name| (vec![Step::from("torus")], name)).into_iter().collect()
    }

    /// The name of the object, if it is one.
    pub(in crate::document) fn name(&self) -> Option<&str> {
        match self {
            Self::Here(_) => None,
            Self::Named(name) => Some(name),
        }
    }
}

forms! {
    TorusSource: "`{\"major_radius\": …, \"minor_radius\": …}` or the name of a `cyclide` or of its `transform`";
    word String => TorusSource::Named;
    object TorusSpec => TorusSource::Here;
}

impl Builder<'_> {
    /// The torus that a curve lies on.
    pub(in crate::document) fn torus(&self, source: &TorusSource) -> Result<Torus> {
        let refused = |e: cyclide::Error| self.refused_at([Step::from("torus")], &e);
        match source {
            TorusSource::Here(spec) => frame_of_axes(spec.center, spec.axis, spec.x_direction)
                .and_then(|frame| Torus::new(frame, spec.major_radius, spec.minor_radius))
                .map_err(refused),
            TorusSource::Named(name) => self.named_torus(name),
        }
    }

    /// The torus that an object is: a `cyclide` with `c` = 0, or its image under a `transform` that keeps it a torus.
    pub(in crate::document) fn named_torus(&self, name: &str) -> Result<Torus> {
        let named = self.document.objects.iter().find(|(other, _)| other == name).map(|(_, spec)| spec);
        named.and_then(|spec| spec.kind().torus(self, name)).unwrap_or_else(|| {
            let word = named.map_or("", |spec| spec.type_word());
            Err(self.no_torus(format!(
                "`{name}` is of type `{word}`: a torus is a `cyclide` with `c` = 0, or a `transform` of one"
            )))
        })
    }

    /// The message about what was named as a torus.
    pub(in crate::document) fn no_torus(&self, message: String) -> Error {
        Error::Input(self.diagnostic([Step::from("torus")], &message))
    }

    /// Says that points were moved by more than rounding.
    pub(in crate::document) fn warn_of_move(&mut self, moved: f64, torus: &Torus, field: &str) {
        if moved <= NEAR * torus.major_radius() {
            return;
        }
        let place = self.place_of([Step::from(field)]);
        let message = format!(
            "points are up to {} away from the torus: each was moved to its nearest point on the torus",
            ShortNumber(moved)
        );
        self.remark("moved-onto-torus", None, None, place, message);
    }

    /// The splines that the source consists of, one at least; a circle of a torus as the spline of arcs that it is.
    pub(in crate::document) fn splines_of_source(&self, needed: &str) -> Result<Vec<TorusSpline>> {
        let name = self.sources.first().map(|source| &source.item.name);
        let spec = self.document.objects.iter().find(|(other, _)| Some(other) == name).map(|(_, spec)| spec);
        if let Some(circle) = spec.and_then(|spec| spec.kind().circle_of_torus(self)) {
            return Ok(vec![circle?]);
        }
        let source = self.sources.first().map_or(&[][..], |source| source.item.curves());
        let on_torus = |curve: &CurveObject| match curve {
            CurveObject::TorusSpline(spline) => Some(spline.clone()),
            _ => None,
        };
        let splines: Vec<TorusSpline> = source.iter().map_while(on_torus).collect();
        if splines.is_empty() || splines.len() < source.len() {
            let message = format!("only a `torus-spline`, `torus-knot`, `torus-quartic` or `torus-circle` {needed}");
            return Err(self.wrong_source(&message));
        }
        Ok(splines)
    }
}

/// The place at a longitude and a meridian angle; whole turns do not matter.
pub(in crate::document) fn place(torus: &Torus, [longitude, meridian]: [Angle; 2]) -> Point2 {
    torus.place_of_angles(longitude.turn(), meridian.turn())
}
