//! A motion of a body, through poses or along a curve.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::spec::MotionSpec;
use crate::document::spec::PoseSource;
use crate::error::Result;

impl Kind for MotionSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.motion(self).map(|body| Shape::Motion(Box::new(body)))
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.along.iter().map(|name| (vec![Step::from("along")], name.as_str())).collect()
    }

    fn files(&self) -> Vec<&str> {
        let poses = match &self.poses {
            Some(PoseSource::File(file)) => Some(file.csv.as_str()),
            _ => None,
        };
        poses.into_iter().chain(self.mesh.as_ref().map(|file| file.path.as_str())).collect()
    }
}
