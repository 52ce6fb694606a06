//! A parallel surface, or the solid between.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::objects::BuiltObject;
use crate::document::objects::refuse::Blame;
use crate::document::objects::refuse::is_of_distance;
use crate::document::spec::OffsetSpec;
use crate::error::Result;
use cyclide::Body;
use cyclide::SurfaceObject;

impl Kind for OffsetSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        if at.is_of_curves() {
            at.parallel_curves(self).map(Shape::Curves)
        } else {
            at.offset(self).map(Shape::Surfaces)
        }
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::{Error as E, ErrorItem as I};
        let is_of_distance = matches!(error, E::ParameterOutOfRange { name: I::Distance, .. }) || is_of_distance(error);
        is_of_distance.then_some(Blame::Field("distance"))
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        use cyclide::{Error as E, ErrorItem as I};
        let is_of_distance = matches!(error, E::ParameterOutOfRange { name: I::Distance, .. });
        (is_of_distance && self.distance == 0.0)
            .then(|| "a solid between a surface and its offset needs a distance other than 0".to_owned())
    }

    fn skin(&self, source: Option<&BuiltObject>) -> Vec<SurfaceObject> {
        source.filter(|_| self.thick).map_or_else(Vec::new, |source| source.item.surfaces().to_vec())
    }

    fn has_panels(&self, source: Option<&BuiltObject>) -> bool {
        source.is_some_and(|source| source.provenance.panels)
    }

    fn remark_on(&self, at: &mut Builder<'_>, _: &Shape, bodies: &[Body]) {
        at.warn_beyond_focal_set(self, bodies);
    }
}
