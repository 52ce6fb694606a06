//! A curve that runs evenly round a torus both ways.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::torus::TorusFields;
use crate::document::objects::torus::blame_on_torus;
use crate::document::spec::TorusKnotSpec;
use crate::error::Result;
use cyclide::CurveObject;

impl Kind for TorusKnotSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(CurveObject::TorusSpline(at.torus_knot(self)?).into())
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.torus.reference()
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        Some(blame_on_torus(&TorusFields { angles: "start", turns: "turns", ..TorusFields::SPLINE }, error))
    }
}
