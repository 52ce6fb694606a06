//! Ellipses and helices.

use cyclide::{CurveObject, Ellipse, Helix, Point3, Vec3};

use super::Builder;
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::spec::{EllipseSpec, Hand, HelixSpec};
use crate::error::{Error, Result};

/// Part of the radius that the tolerance of a helix is if none is given.
const TOLERANCE: f64 = 1e-6;

impl Builder<'_> {
    /// The ellipse, or an arc of it.
    pub(in crate::document) fn ellipse(&self, spec: &EllipseSpec) -> Result<CurveObject> {
        let normal = spec.normal.map_or(Vec3::Z, Coordinates::vector);
        let x = spec.x_direction.map(Coordinates::vector);
        let ellipse = Ellipse::new(spec.center.point(), normal, x, spec.semi_axes);
        let ellipse = ellipse.map_err(|e| self.refused_conic("semi_axes", "normal", &e))?;
        let sweep = spec.sweep.map_or(std::f64::consts::TAU, Angle::radians);
        let curve = ellipse.to_nurbs(spec.start.map_or(0.0, Angle::radians), sweep);
        curve.map(CurveObject::Nurbs).map_err(|e| self.refused_at(["sweep".into()], &e))
    }

    /// The rational curve that stands for a helix.
    pub(in crate::document) fn helix(&mut self, spec: &HelixSpec) -> Result<CurveObject> {
        let (pitch, turns) = match (spec.pitch, spec.height, spec.turns) {
            (Some(pitch), None, Some(turns)) => (pitch, turns),
            (None, Some(height), Some(turns)) => (height / turns, turns),
            (Some(pitch), Some(height), None) if pitch != 0.0 => (pitch, height / pitch),
            _ => return Err(self.unfit("a helix has two of `pitch`, `height` and `turns`, and a pitch that is not 0 where the turns follow from it")),
        };
        if !(turns > 0.0 && turns.is_finite()) {
            let field = if spec.turns.is_some() { "turns" } else { "height" };
            let message = format!(
                "a helix turns by {turns}: more than 0 turns are needed; left-handed ones have `\"hand\": \"left\"`"
            );
            return Err(Error::Input(self.diagnostic([field.into()], &message)));
        }
        let turns = if spec.hand == Hand::Left { -turns } else { turns };
        let center = spec.center.map_or(Point3::ORIGIN, Coordinates::point);
        let (axis, x) = (spec.axis.map_or(Vec3::Z, Coordinates::vector), spec.x_direction.map(Coordinates::vector));
        let helix = Helix::new(center, axis, x, spec.radius, pitch, turns);
        let helix = helix.map_err(|e| self.refused_conic("radius", "axis", &e))?;
        let tolerance = spec.tolerance.unwrap_or(TOLERANCE * spec.radius);
        let (curve, bound) = helix.to_nurbs(tolerance).map_err(|e| self.refused_at(["tolerance".into()], &e))?;
        // Far from the origin coordinates are rounded by more.
        self.bound = Some(tolerance.max(bound));
        Ok(CurveObject::Nurbs(curve))
    }

    /// What the kernel refused, at the field it is about.
    fn refused_conic(&self, size: &'static str, axis: &'static str, error: &cyclide::Error) -> Error {
        let field = match error {
            cyclide::Error::RadiusNotPositive { .. } | cyclide::Error::NotFinite { .. } => size,
            cyclide::Error::ZeroAxis { index: 1, .. } => "x_direction",
            cyclide::Error::ZeroAxis { .. } => axis,
            _ => "center",
        };
        self.refused_at([field.into()], error)
    }
}
