//! A tube of constant radius about a curve of arcs and segments.

use cyclide::{
    Point3, ShortNumber,
    construct::{FairFit, FairFitOptions, Pipe, PipeEnds},
    curve::ParamCurve as _,
    error::PipeError,
    model::{CurveObject, Lower as _, SurfaceObject},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::ruled::remedies::MOST_TRIED;
use crate::document::objects::Builder;
use crate::document::objects::idle::{Idle, NO_ENDS, found};
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape, main_field, of};
use crate::error::Result;

/// Tolerances of a fit that are tried, in radii of the pipe; and the part of them that the arcs along it may take.
const TOLERANCES: [f64; 5] = [0.125, 0.25, 0.5, 1.0, 2.0];

const ARCS: f64 = 0.25;

/// A tube of constant radius about a curve of arcs and segments.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"l": {"type": "polyline", "points": [[0, 0], [10, 0]]}, "p": {"type": "pipe", "of": "l", "radius": 1}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[1].bodies[0].outer.volume() - 10.0 * std::f64::consts::PI).abs() < 1e-10);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct PipeSpec {
    /// The word `pipe`.
    #[schemars(with = "String", extend("const" = "pipe"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the curve, which may be construction geometry.
    pub of: String,
    /// Outer radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Thickness of the wall around a bore. Default: no bore.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
    /// How the pipe ends, if the curve is open.
    #[serde(default)]
    pub ends: PipeEnds,
    /// Distance within which arcs replace a curve that does not consist of arcs and segments. Default: such a curve is
    /// rejected.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

impl Kind for PipeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.pipe(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn fields(&self) -> FieldNames {
        main_field("of")
    }
}

impl Builder<'_> {
    /// The tubes about the curves of another object.
    pub(in crate::document) fn pipe(&mut self, spec: &PipeSpec) -> Result<Vec<SurfaceObject>> {
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves());
        if curves.is_empty() {
            return Err(self.wrong_source("a pipe requires a curve"));
        }
        let refused = |e: cyclide::Error| self.refused(&e, None);
        let mut pipe = Pipe::new(spec.radius).map_err(refused)?.with_ends(spec.ends);
        if let Some(wall) = spec.wall {
            pipe = pipe.with_wall(wall).map_err(refused)?;
        }
        let spines = curves.iter().map(|curve| curve.spine(spec.tolerance)).collect::<cyclide::Result<Vec<_>>>();
        let spines = spines.map_err(refused)?;
        let mut bodies = Vec::with_capacity(spines.len());
        for (curve, spine) in curves.iter().zip(&spines) {
            bodies.push(pipe.body(spine).map_err(|e| match e {
                cyclide::Error::Pipe(PipeError::MitreDoesNotFit { .. } | PipeError::CornerNotMitred { .. }) => {
                    match self.fit_for_pipe(curve, &pipe, spec.radius) {
                        Some(remedy) => self.refused_in_words(["radius".into()], e.reason(), format!("{e}{remedy}")),
                        None => refused(e),
                    }
                }
                e => refused(e),
            })?);
        }
        let meeting = pipe.first_meeting(&spines).map_err(refused)?;
        let idle = idle_in_pipe(spec, curves, spines.iter().all(|spine| spine.is_closed()));
        if let Some(([first, second], distance)) = meeting {
            let message = format!(
                "the pipes of contours {first} and {second} intersect (distance of the spines {}): they are separate bodies, and volume and area count their intersection twice; fuse them in CAD",
                ShortNumber(distance)
            );
            self.remark("pipes-meet", Some(second), None, None, message);
        }
        self.remark_on_idle(idle);
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }

    /// How a pipe along a run of measured points is made: a fit within a tolerance, of those that work the least.
    pub(in crate::document) fn fit_for_pipe(&self, curve: &CurveObject, pipe: &Pipe, radius: f64) -> Option<String> {
        let CurveObject::ArcPath(path) = curve else { return None };
        let arcs = path.arcs();
        if arcs.len() > MOST_TRIED || !arcs.iter().all(cyclide::curve::Arc::is_straight) {
            return None;
        }
        let closed = curve.as_curve().is_closed();
        let mut points: Vec<Point3> = arcs.iter().map(cyclide::curve::Arc::start).collect();
        points.extend(arcs.last().filter(|_| !closed).map(cyclide::curve::Arc::end));
        let name = &self.sources.first()?.item.name;
        TOLERANCES.into_iter().find_map(|part| {
            let tolerance = rounded_down(part * radius);
            let options = FairFitOptions { closed, ..FairFitOptions::new(tolerance) };
            let fit = FairFit::new(&points, &options).ok()?.into_spline();
            let arcs = rounded_down(ARCS * tolerance);
            let spine = fit.lower_to_arcs(arcs).ok()?.form;
            pipe.body(&spine).ok()?;
            Some(format!(
                "; if its points are measured, use a smooth curve near them: make `{name}` a `\"type\": \"fair-fit\", \"tolerance\": {}`, and set `\"tolerance\": {}` for the pipe",
                ShortNumber(tolerance),
                ShortNumber(arcs)
            ))
        })
    }
}

/// The fields of a pipe that make no difference; `closed` if all curves are.
pub(in crate::document) fn idle_in_pipe(spec: &PipeSpec, curves: &[CurveObject], closed: bool) -> Vec<Idle> {
    let of_arcs = curves.iter().all(CurveObject::is_of_arcs);
    found(&[
        ("ends", closed && spec.ends != PipeEnds::Flat, NO_ENDS),
        (
            "ends",
            !closed && spec.ends == PipeEnds::Open && spec.wall.is_some(),
            "a wall ends in rings; without `wall` the tube is open",
        ),
        ("tolerance", of_arcs && spec.tolerance.is_some(), "the curve already consists of arcs and segments"),
    ])
}

/// A number of two digits below a positive one.
fn rounded_down(x: f64) -> f64 {
    let unit = 10_f64.powf(x.log10().floor() - 1.0);
    format!("{:.1e}", (x / unit).floor() * unit).parse().unwrap_or(x)
}
