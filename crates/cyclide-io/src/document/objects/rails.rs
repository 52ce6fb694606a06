//! Surfaces between two curves.

use cyclide::{
    construct::RailSurface,
    curve::Circle,
    model::{CurveObject, SurfaceObject},
    topology::EdgeCurve,
};

use crate::document::objects::{Builder, BuiltObject};
use crate::error::{Error, Result};

impl Builder<'_> {
    /// A surface between the pieces of two curves, closed round if both are.
    pub(in crate::document) fn between_rails(
        &mut self,
        construct: impl Fn([&[EdgeCurve]; 2], bool) -> cyclide::Result<RailSurface>,
    ) -> Result<Vec<SurfaceObject>> {
        let ([first, second], closed) = self.pieces_of_rails()?;
        let made = construct([&first, &second], closed).map_err(|e| self.refused(&e, None))?;
        Ok(self.between(made))
    }

    pub(in crate::document) fn between(&mut self, made: RailSurface) -> Vec<SurfaceObject> {
        for warning in made.warnings() {
            self.warn_at("rails", None, warning.clone());
        }
        vec![SurfaceObject::Body(made.into_body())]
    }

    /// The pieces of the two curves, and whether both are closed. A whole circle has as many as the other closed curve.
    pub(in crate::document) fn pieces_of_rails(&self) -> Result<([Vec<EdgeCurve>; 2], bool)> {
        let curves = self.rails()?;
        let [first, second] = curves.map(|curve| curve.exact_pieces().map_err(|e| self.refused(&e, None)));
        let ((first, a), (second, b)) = (first?, second?);
        let closed = a && b;
        if !closed || first.len() == second.len() {
            return Ok(([first, second], closed));
        }
        let beside =
            |circle: &Circle, other: &[EdgeCurve]| circle_beside(circle, other).map_err(|e| self.refused(&e, None));
        Ok((
            match curves {
                [CurveObject::Circle(circle), _] => beside(circle, &second)?,
                [_, CurveObject::Circle(circle)] => {
                    let [second, first] = beside(circle, &first)?;
                    [first, second]
                }
                _ => [first, second],
            },
            closed,
        ))
    }

    /// The two curves that an object is spanned between.
    fn rails(&self) -> Result<[&CurveObject; 2]> {
        let rail = |k: usize| match self.sources[k].item.curves() {
            [curve] => Ok(curve),
            contours => {
                let BuiltObject { item, provenance, .. } = self.sources[k];
                let (name, kind, count) = (&item.name, provenance.kind, contours.len());
                let what = if count == 0 { "is not a curve".to_owned() } else { format!("has {count} contours") };
                let message = format!("`{name}` is of type `{kind}` and {what}: a rail must be one curve");
                Err(Error::Input(self.diagnostic(["rails".into(), k.into()], &message)))
            }
        };
        Ok([rail(0)?, rail(1)?])
    }
}

/// The pieces of a whole circle and of the closed curve beside it, which has two at least.
fn circle_beside(circle: &Circle, other: &[EdgeCurve]) -> cyclide::Result<[Vec<EdgeCurve>; 2]> {
    let other = match other {
        [one] => <[EdgeCurve; 2]>::from(one.split(0.5)?).to_vec(),
        _ => other.to_vec(),
    };
    Ok([RailSurface::cut_circle(circle, &other)?, other])
}
