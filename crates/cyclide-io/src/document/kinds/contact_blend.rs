//! A cylinder or cone blended with a sphere or a plate.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::refuse::blame_contact;
use crate::document::spec::ContactBlendSpec;
use crate::error::Result;

impl Kind for ContactBlendSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.contact_blend(self).map(Shape::Surfaces)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        Some(blame_contact(self, error))
    }
}
