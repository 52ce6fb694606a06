//! One patch of a Dupin cyclide, bounded by four circular arcs.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::BuiltObject;
use crate::document::objects::refuse::Blame;
use crate::document::objects::refuse::frame_words;
use crate::document::spec::CyclidePatchSpec;
use crate::error::Result;

impl Kind for CyclidePatchSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.patch(self).map(Shape::Surfaces)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::{Error as E, ErrorItem as I};
        match *error {
            E::NotConcircular { .. } | E::CrossingQuad { .. } => Some(Blame::Entry("corners", 3)),
            E::NotFinite { what: I::Point, index } | E::CoincidentPoints { second: index, .. } => {
                Some(Blame::Entry("corners", index))
            }
            _ => None,
        }
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        match error {
            cyclide::Error::FrameNotOrthonormal { .. } => Some(frame_words(self.frame)),
            cyclide::Error::CrossingQuad { .. } => Some(format!(
                "{error}; corners are given row by row, (0,0), (1,0), (0,1), (1,1): are the last two exchanged?"
            )),
            _ => None,
        }
    }

    fn has_panels(&self, _: Option<&BuiltObject>) -> bool {
        true
    }
}
