//! A closed quartic of one type on a torus.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::torus::TorusFields;
use crate::document::objects::torus::blame_on_torus;
use crate::document::spec::TorusQuarticSpec;
use crate::error::Result;
use cyclide::CurveObject;

impl Kind for TorusQuarticSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(CurveObject::TorusSpline(at.torus_quartic(self)?).into())
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.torus.reference()
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        let fields = TorusFields { angles: "start", ..TorusFields::SPLINE };
        Some(match error {
            cyclide::Error::NotCoprime { .. } => Blame::Field("ratio"),
            _ => blame_on_torus(&fields, error),
        })
    }
}
