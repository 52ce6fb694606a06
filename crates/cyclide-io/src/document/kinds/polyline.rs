//! Segments through points, with corners rounded by arcs.

use cyclide::{
    curve::ArcPath,
    error::{ErrorItem, NumberError},
    model::CurveObject,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::PointSource;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::radii::RadiiSpec;
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, Made};
use crate::document::objects::kind::{Kind, Shape};
use crate::error::Result;

/// Segments through points, with corners rounded by arcs.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": [[0, 0], [10, 0], [10, 10]], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[0].item.curves()[0].as_curve()) - (16.0 + std::f64::consts::PI)).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PolylineSpec {
    /// The word `polyline`.
    #[schemars(with = "String", extend("const" = "polyline"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The points.
    pub points: PointSource,
    /// The last point joins the first.
    #[serde(default)]
    pub closed: bool,
    /// Radius of the arcs that round the corners, or a list with one per point. Both legs of a corner must be long
    /// enough for its arc (`bend-does-not-fit`). Default 0: the corners are sharp.
    #[serde(default)]
    pub radius: RadiiSpec,
}

impl Kind for PolylineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| polyline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }
}

pub(in crate::document) fn polyline(spec: &PolylineSpec, at: &Contour<'_>) -> Made {
    let radii = match &spec.radius {
        RadiiSpec::All(radius) => vec![*radius; at.kept.len()],
        RadiiSpec::Each(given) => {
            // Of the points as given, those that were merged away included; a point that repeats the first one may have its own.
            let needed = at.kept.last().map_or(0, |last| last + 1);
            if given.len() != needed && !(spec.closed && given.len() == needed + 1) {
                return Err(NumberError::CountDiffers { what: ErrorItem::Radius, given: given.len(), needed }.into());
            }
            at.kept.iter().filter_map(|&i| given.get(i).copied()).collect()
        }
    };
    let path = ArcPath::rounded_polyline(&at.list.points, spec.closed, &radii)?;
    Ok((CurveObject::ArcPath(path), at.facts(None), Vec::new()))
}
