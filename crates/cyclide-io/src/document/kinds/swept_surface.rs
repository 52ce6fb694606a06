//! The surface swept by a curve of a moving body.

use cyclide::{
    Point3, ShortNumber, Vec3,
    construct::SweptSurface,
    curve::bounds,
    error::MotionError,
    model::{CurveObject, SurfaceObject},
    motion::RationalMotion,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::sweep::SweepEnds;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Reference, Shape};
use crate::error::{Error, Result};

/// Planes that are off that across the path of their middle by no more than this are across it, radians: two degrees.
const ACROSS: f64 = 0.035;
/// Places of a motion where that is looked at, and the part of its time between two poses that tell a direction.
const PLACES: u32 = 64;
const STEP: f64 = 1e-5;

/// The surface swept by a curve of a moving body: an exact rational surface.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [30, 0]}]},
///     "blade": {"type": "polyline", "points": [[0, 0], [0, 5]], "construction": true},
///     "s": {"type": "swept-surface", "of": "m", "profile": "blade"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[2].bodies[0].outer.area() - 150.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SweptSurfaceSpec {
    /// The word `swept-surface`.
    #[schemars(with = "String", extend("const" = "swept-surface"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the motion, of any kind except `sclerp`; it may be construction geometry.
    pub of: String,
    /// Name of the curve, in the frame of the body; each of its contours makes a surface. It may be construction geometry.
    pub profile: String,
    /// How the surface of a closed plane curve ends, if the motion does not return to its start.
    #[serde(default)]
    pub ends: SweepEnds,
}

impl Kind for SweptSurfaceSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.swept_surface(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        vec![(vec![Step::from("of")], &self.of), (vec![Step::from("profile")], &self.profile)]
    }
}

impl Builder<'_> {
    /// What the contours of a curve run over.
    pub(in crate::document) fn swept_surface(&mut self, spec: &SweptSurfaceSpec) -> Result<Vec<SurfaceObject>> {
        let motion = self.motion_source()?.motion().clone();
        let contours = self.sources[1].item.curves().to_vec();
        if contours.is_empty() {
            let message = format!("`{}` has no curve: a profile must be a curve", spec.profile);
            return Err(Error::Input(self.diagnostic(["profile".into()], &message)));
        }
        let form = motion.to_rational().map_err(|e| self.refused_at(["of".into()], &e))?;
        let mut reach = 0.0_f64;
        let mut made = Vec::with_capacity(contours.len());
        for (contour, curve) in contours.iter().enumerate() {
            let lean = lean_of_section(curve, form.motion());
            let make = if spec.ends == SweepEnds::Flat { SweptSurface::solid } else { SweptSurface::new };
            let swept = curve.exact_pieces().and_then(|(pieces, closed)| make(&pieces, closed, form.motion()));
            let swept = swept.map_err(|e| match e {
                cyclide::Error::Motion(MotionError::AtRest { length, limit, .. }) => {
                    let words = format!(
                        "the motion is at rest: the profile moves by {}, which must exceed {} to sweep a surface",
                        ShortNumber(length),
                        ShortNumber(limit)
                    );
                    self.refused_in_words(["of".into()], e.reason(), words)
                }
                e => self.refused_at(["profile".into()], &e),
            })?;
            if let Some((lean, time)) = lean.filter(|(lean, _)| *lean > ACROSS) {
                let message = format!(
                    "the profile deviates by {} degrees from the plane normal to its path at the time {}: the motion alone determines its orientation; for a section that stays normal to its path use a `sweep`",
                    ShortNumber(lean.to_degrees()),
                    ShortNumber(time)
                );
                let place = self.place_of([Step::from("profile")]);
                self.remark("section-not-across", (contours.len() > 1).then_some(contour), None, place, message);
            }
            for warning in swept.warnings() {
                self.warn_at("profile", (contours.len() > 1).then_some(contour), warning.clone());
            }
            made.push(SurfaceObject::Body(swept.into_body()));
            let range = bounds(curve.as_curve());
            reach = [range.min, range.max].into_iter().map(|corner| corner.to_vec().length()).fold(reach, f64::max);
        }
        self.remark_bound(form.bound(reach));
        Ok(made)
    }
}

/// By how much a closed plane curve of a moving body is off the plane across the path of its middle, at most, and when.
fn lean_of_section(curve: &CurveObject, motion: &RationalMotion) -> Option<(f64, f64)> {
    let (pieces, closed) = curve.exact_pieces().ok()?;
    let points: Vec<Point3> = pieces.iter().flat_map(|piece| [0.0, 0.25, 0.5, 0.75].map(|x| piece.point(x))).collect();
    let first = *points.first().filter(|_| closed)?;
    let middle = first + points.iter().fold(Vec3::ZERO, |sum, p| sum + (*p - first)) / points.len() as f64;
    let pairs = points.iter().zip(points.iter().cycle().skip(1));
    let normal = pairs.fold(Vec3::ZERO, |sum, (a, b)| sum + (*a - middle).cross(*b - middle)).unit()?;
    let size = points.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
    if points.iter().any(|p| (*p - middle).dot(normal).abs() > 1e-9 * size) {
        return None;
    }
    let times = motion.times();
    let [from, to] = [times[0], times[times.len() - 1]];
    let lean = |k: u32| {
        let time = from + (to - from) * f64::from(k) / f64::from(PLACES);
        let step = 0.5 * STEP * (to - from);
        let [before, behind] = [(time - step).max(from), (time + step).min(to)].map(|time| motion.pose(time));
        let way = (behind.apply(middle) - before.apply(middle)).unit()?;
        let normal = motion.pose(time).rotation().rotate(normal);
        Some((way.cross(normal).length().atan2(way.dot(normal).abs()), time))
    };
    (0..=PLACES).filter_map(lean).max_by(|a, b| a.0.total_cmp(&b.0))
}
