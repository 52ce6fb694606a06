//! Arcs through points, tangent-continuous.

use cyclide::{
    Vec3,
    construct::{ArcSplineOptions, BiarcRule},
    curve::ArcPath,
    error::{ErrorItem, NumberError},
    model::CurveObject,
    warning::WaverRemedy,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::{Lists, PointSource};
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, Made};
use crate::document::objects::idle::{Idle, found, is_same};
use crate::document::objects::kind::{Kind, Shape};
use crate::document::objects::wavers::{WaverData, WaverRule};
use crate::error::Result;

/// Arcs through points: a biarc from each point to the next, tangent-continuous everywhere.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "arc-spline", "points": [[0, 0], [1, 1], [2, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let curve = built[0].item.curves()[0].as_curve();
/// assert!(cyclide::curve::joints(curve).iter().all(|joint| joint.angle < 1e-12));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArcSplineSpec {
    /// The word `arc-spline`.
    #[schemars(with = "String", extend("const" = "arc-spline"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The points.
    pub points: PointSource,
    /// Directions of travel, one per point, of any length. Default: estimated from the circle through each point and
    /// its neighbors.
    pub tangents: Option<Lists>,
    /// The last point joins the first.
    #[serde(default)]
    pub closed: bool,
    /// How the joint between two points is chosen.
    #[serde(default)]
    pub rule: BiarcRule,
}

impl Kind for ArcSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| arc_spline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn keeps_corners(&self) -> bool {
        false
    }

    fn idle_fields(&self, at: &Contour<'_>, made: &CurveObject) -> Vec<Idle> {
        in_arc_spline(self, at, made)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::Points, WaverRemedy::FairSpline))
    }
}

pub(in crate::document) fn arc_spline(spec: &ArcSplineSpec, at: &Contour<'_>) -> Made {
    let tangents = match &spec.tangents {
        None => None,
        Some(given) => {
            let needed = at.kept.last().map_or(0, |last| last + 1).max(at.kept.len());
            let given = given.lists.get(at.index).map_or(&[][..], Vec::as_slice);
            // Tangents belong to the points as given; those of points that were merged away go with them.
            let tangents: Option<Vec<Vec3>> = at.kept.iter().map(|&i| given.get(i).map(|t| t.vector())).collect();
            Some(tangents.ok_or(NumberError::CountDiffers { what: ErrorItem::Tangent, given: given.len(), needed })?)
        }
    };
    let options = ArcSplineOptions { closed: spec.closed, rule: spec.rule, tangents };
    let path = ArcPath::spline(&at.list.points, &options)?;
    Ok((CurveObject::ArcPath(path), at.facts(None), Vec::new()))
}

pub(in crate::document) fn in_arc_spline(spec: &ArcSplineSpec, at: &Contour<'_>, made: &CurveObject) -> Vec<Idle> {
    let same = || {
        let other = ArcSplineSpec { rule: BiarcRule::EqualD, ..spec.clone() };
        arc_spline(&other, at).is_ok_and(|(curve, ..)| is_same(&curve, made))
    };
    found(&[("rule", spec.rule == BiarcRule::EqualChord && same(), "with `equal-d` the arcs are the same")])
}
