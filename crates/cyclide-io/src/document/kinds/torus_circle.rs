//! A circle of a torus.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::torus::TorusFields;
use crate::document::objects::torus::blame_on_torus;
use crate::document::spec::TorusCircleSpec;
use crate::error::Result;

impl Kind for TorusCircleSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.torus_circle(self).map(|made| Shape::Curves(vec![made]))
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.torus.reference()
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::Error as E;
        let angles = if self.at.is_some() { "at" } else { "through" };
        Some(match error {
            E::PointOnAxis { .. } | E::PointOnCoreCircle { .. } | E::PointOffTorus { .. } => Blame::Field(angles),
            _ => blame_on_torus(&TorusFields { angles, ..TorusFields::SPLINE }, error),
        })
    }
}
