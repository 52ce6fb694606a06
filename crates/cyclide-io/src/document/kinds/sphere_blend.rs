//! A smooth patch over one triangle, shaped by three spheres.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::spec::SphereBlendSpec;
use crate::error::Result;

impl Kind for SphereBlendSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.sphere_blend(self).map(Shape::Surfaces)
    }
}
