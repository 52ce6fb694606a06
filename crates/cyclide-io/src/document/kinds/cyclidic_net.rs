//! A smooth surface of patches over a grid of points.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::BuiltObject;
use crate::document::spec::BorderCurves;
use crate::document::spec::CyclidicNetSpec;
use crate::document::spec::GridSource;
use crate::error::Result;
use cyclide::Body;

impl Kind for CyclidicNetSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.net(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        let sides = self.make_circular.border_curves().map(BorderCurves::sides).into_iter().flatten();
        let path = |field| vec![Step::from("make_circular"), Step::from("border"), Step::from(field)];
        let sides = sides.filter_map(|(field, name)| name.map(|name| (path(field), name)));
        // After the curves of the sides, which are counted.
        let grid = match &self.grid {
            GridSource::Laid(laid) => Some((vec![Step::from("grid"), Step::from("of")], laid.of.as_str())),
            _ => None,
        };
        sides.chain(grid).collect()
    }

    fn files(&self) -> Vec<&str> {
        if let GridSource::File(file) = &self.grid { vec![file.obj.as_str()] } else { Vec::new() }
    }

    fn has_panels(&self, _: Option<&BuiltObject>) -> bool {
        true
    }

    fn remark_on(&self, at: &mut Builder<'_>, shape: &Shape, bodies: &[Body]) {
        if let Shape::Surfaces(surfaces) = shape {
            at.warn_of_folds(self, surfaces, bodies);
            at.warn_of_seams(surfaces);
        }
    }
}
