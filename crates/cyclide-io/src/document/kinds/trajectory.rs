//! The path of a point of a moving body.

use cyclide::{ShortNumber, curve::bounds, error::MotionError, model::CurveObject};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::motion::AT_REST;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Reference, Shape, of};
use crate::error::Result;

/// The path of a point of a moving body: an exact rational curve.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [30, 0], "rpy": [0, 0, {"degrees": 90}]}]},
///     "p": {"type": "trajectory", "of": "m", "point": [0, 5]}}}"#.parse()?;
/// let built = document.build()?;
/// let path = built[1].item.curves()[0].as_curve();
/// assert!(path.point(1.0).distance(cyclide::Point3::new(25.0, 0.0, 0.0)) < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TrajectorySpec {
    /// The word `trajectory`.
    #[schemars(with = "String", extend("const" = "trajectory"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the motion, of any kind except `sclerp`; it may be construction geometry.
    pub of: String,
    /// The point of the body. Default: the tool of the motion.
    pub point: Option<Coordinates>,
}

impl Kind for TrajectorySpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let path = at.trajectory(self)?;
        at.warn_of_cusps("of", None, path.as_curve());
        Ok(path.into())
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}

impl Builder<'_> {
    /// The path of a point.
    pub(in crate::document) fn trajectory(&mut self, spec: &TrajectorySpec) -> Result<CurveObject> {
        let body = self.motion_source()?;
        let point = spec.point.map_or(body.tool(), Coordinates::point);
        let form = body.motion().to_rational().map_err(|e| self.refused_at(["of".into()], &e))?;
        let path = form.motion().trajectory(point).map_err(|e| self.refused_at(["of".into()], &e))?;
        let bound = form.bound(point.to_vec().length());
        drop(form);
        let range = bounds(&path);
        let (length, limit) = (range.diagonal(), AT_REST * range.max_abs());
        if length <= limit {
            let error = cyclide::Error::Motion(MotionError::AtRest { length, limit, still: false });
            let place = if spec.point.is_some() { "point" } else { "of" };
            return Err(self.refused_in_words(
                [place.into()],
                error.reason(),
                format!(
                    "the point is at rest: the length of its path is {}, which must exceed {}",
                    ShortNumber(length),
                    ShortNumber(limit)
                ),
            ));
        }
        self.remark_bound(bound);
        Ok(CurveObject::Nurbs(path))
    }
}
