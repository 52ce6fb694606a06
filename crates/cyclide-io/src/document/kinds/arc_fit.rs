//! The fewest arcs near points, tangent-continuous.

use cyclide::{
    Point3, ShortNumber, Warning,
    construct::{ArcFit, ArcFitOptions, Effort, FitCertificate, FitTarget},
    curve::{Arc, CurvePlace, ParamCurve},
    error::{FitError, NumberError},
    mesh::flatten_within,
    model::CurveObject,
    warning::{FitWarning, WaverRemedy},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::coordinates::PointSource;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, ContourFacts, Fitted, Made};
use crate::document::objects::kind::{Kind, Reference, Shape, of};
use crate::document::objects::wavers::{WaverData, WaverRule};
use crate::error::Result;

/// The part of the tolerance by which a polyline may leave the curve that arcs are fitted to.
const POLYLINE_SHARE: f64 = 0.1;

/// Points of the curve on each edge of the polyline whose distance from the arcs is measured.
const MEASURED: u32 = 4;

/// Vertices of this polyline at most.
pub(in crate::document) const MOST_VERTICES: usize = 200_000;

/// Arcs of a path meet smoothly where their tangents differ by no more than this angle: rounding, as between two fitted arcs.
const SMOOTH: f64 = 1e-9;

/// Places between the middles of neighbors.
const BETWEEN: u32 = 16;

/// A circle through three places of neighbors is off by up to this many times as much as the nearest one: that through three even places by 2.25 times,
/// where distances go as a cubic.
const OFF_BY: f64 = 4.0;

/// The fewest arcs and segments within a tolerance, tangent-continuous except at corners.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"f": {"type": "arc-fit", "tolerance": 0.1, "points": [[1, 0], [0.92, 0.38], [0.71, 0.71], [0.38, 0.92], [0, 1], [-0.38, 0.92], [-0.71, 0.71]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].item.curves()[0].as_curve().piece_count(), 1);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("oneOf" = [{"required": ["points"]}, {"required": ["of"]}]),
    extend("if" = {"required": ["of"]}),
    extend("then" = {"properties": {"closed": false, "target": false}})
)]
pub struct ArcFitSpec {
    /// The word `arc-fit`.
    #[schemars(with = "String", extend("const" = "arc-fit"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The points.
    pub points: Option<PointSource>,
    /// Name of a curve of any kind, instead of points; it may be construction geometry. The arcs and the curve are
    /// within the tolerance of each other; an arc, a circle, and a chain of tangent arcs that needs no fewer arcs are
    /// returned unchanged (deviation 0).
    pub of: Option<String>,
    /// The last point joins the first.
    #[serde(default)]
    pub closed: bool,
    /// Largest distance between the arcs and the target.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: f64,
    /// What the points represent.
    #[serde(default)]
    pub target: FitTarget,
    /// How hard to search for fewer arcs.
    #[serde(default)]
    pub effort: Effort,
    /// Points that turn by more than this angle are kept as corners, others are not. Default: turns above pi/6 that no
    /// samples of a smooth curve explain.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = std::f64::consts::PI))]
    pub corner_angle: Option<Angle>,
    /// Smallest radius of an arc; a fit that is not possible with it is rejected. Default: no limit.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub min_radius: Option<f64>,
    /// Smallest length of an arc (lines may be shorter), for machines that reject short arcs; a fit that is not
    /// possible with it is rejected. Default: no limit.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub min_arc_length: Option<f64>,
}

impl Kind for ArcFitSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.arc_fit(self).map(Shape::Curves)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.of.as_deref().map(of).unwrap_or_default()
    }

    fn points(&self) -> Option<&PointSource> {
        self.points.as_ref()
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::Fitted, WaverRemedy::Tolerance))
    }

    fn tolerance(&self) -> Option<f64> {
        Some(self.tolerance)
    }
}

impl Builder<'_> {
    /// Arcs near points, or near the curves of another object.
    pub(in crate::document) fn arc_fit(&mut self, spec: &ArcFitSpec) -> Result<Vec<(CurveObject, ContourFacts)>> {
        match (&spec.points, &spec.of) {
            (Some(points), None) => self.each_contour(points, spec.closed, |at| arc_fit(spec, at)),
            (None, Some(of)) => self.arc_fit_of(spec, of),
            _ => Err(self.unfit("an arc-fit requires either `points` or `of` (a curve)")),
        }
    }

    /// Arcs near the contours of another object.
    fn arc_fit_of(&mut self, spec: &ArcFitSpec, of: &str) -> Result<Vec<(CurveObject, ContourFacts)>> {
        if spec.closed || spec.target != FitTarget::default() {
            return Err(self.unfit(
                "`closed` and `target` require `points`: with `of`, the curve itself is open or closed, and the arcs follow all of it",
            ));
        }
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves()).to_vec();
        if curves.is_empty() {
            return Err(self.wrong_source(&format!("`{of}` has no curve: arcs are fitted to points or to a curve")));
        }
        let several = curves.len() > 1;
        let mut made = Vec::with_capacity(curves.len());
        for (contour, curve) in curves.iter().enumerate() {
            let (path, facts, warnings) = arc_fit_of_curve(spec, curve).map_err(|e| match e {
                // The places of its own polyline say nothing to anybody.
                cyclide::Error::Fit(FitError::NoG1SplineInTube { .. }) => {
                    let words = format!(
                        "no smoothly joined arcs were found within {} of the curve: use a larger tolerance, or write \
                         the curve itself with `-o FILE.dxf`, which approximates it with arcs by bisection",
                        ShortNumber(spec.tolerance)
                    );
                    self.refused_in_words(["tolerance".into()], e.reason(), words)
                }
                cyclide::Error::Number(NumberError::TooManyPieces { .. }) => {
                    let words = format!(
                        "the search for arcs needs a polyline within a tenth of {} of the curve, which has more than {MOST_VERTICES} vertices: use a larger tolerance",
                        ShortNumber(spec.tolerance)
                    );
                    self.refused_in_words(["tolerance".into()], e.reason(), words)
                }
                cyclide::Error::Number(NumberError::ToleranceNotPositive { .. }) => self.refused_at(["tolerance".into()], &e),
                e => self.refused_at(["of".into()], &e),
            })?;
            let of_contour = several.then_some(contour);
            // Numbers of vertices are of a polyline that nobody has seen.
            let (corners, others): (Vec<_>, Vec<_>) = warnings
                .into_iter()
                .partition(|warning| matches!(warning, Warning::Fit(FitWarning::CornerKept { .. })));
            let count = |warning: &Warning| {
                if let Warning::Fit(FitWarning::CornerKept { count, .. }) = warning { *count } else { 0 }
            };
            if let Some(first) = corners.first() {
                let message = match corners.iter().map(count).sum() {
                    1_usize => "a corner of the curve is preserved".to_owned(),
                    count => format!("{count} corners of the curve are preserved"),
                };
                let place = self.place_of([Step::from("of")]);
                self.remark(first.reason(), of_contour, None, place, message);
            }
            // Its long edges are where the curve is straight.
            let others = others
                .into_iter()
                .filter(|warning| !matches!(warning, Warning::Fit(FitWarning::SamplesTooCoarse { .. })));
            for warning in others {
                self.warn_at("of", of_contour, warning);
            }
            made.push((path, facts));
        }
        Ok(made)
    }
}

fn fit_options(spec: &ArcFitSpec) -> ArcFitOptions {
    let mut options = ArcFitOptions::new(spec.tolerance);
    options.closed = spec.closed;
    options.target = spec.target;
    options.effort = spec.effort;
    options.corner_angle = spec.corner_angle.map(Angle::radians);
    options.min_radius = spec.min_radius;
    options.min_arc_length = spec.min_arc_length;
    options
}

/// Arcs within the tolerance of a curve, by way of a polyline that is ten times as near. An arc or a circle is itself, and so are arcs that meet smoothly
/// and are no more than what would be fitted to them.
pub(in crate::document) fn arc_fit_of_curve(spec: &ArcFitSpec, curve: &CurveObject) -> Made {
    if !(spec.tolerance > 0.0 && spec.tolerance.is_finite()) {
        return Err(NumberError::ToleranceNotPositive { tolerance: spec.tolerance }.into());
    }
    let itself = || -> Made {
        let fit = FitCertificate::of_itself(curve.as_curve()).map(Fitted::Arcs);
        Ok((curve.clone(), ContourFacts { fit, ..ContourFacts::default() }, Vec::new()))
    };
    let own = match curve {
        CurveObject::Arc(_) | CurveObject::Circle(_) => return itself(),
        CurveObject::ArcPath(path) => path.arcs(),
        _ => return arcs_near(spec, curve),
    };
    let closing = curve.as_curve().is_closed().then(|| [&own[own.len() - 1], &own[0]]);
    let pairs = || own.windows(2).map(|pair| [&pair[0], &pair[1]]).chain(closing);
    let smooth = |[before, after]: [&Arc; 2]| match (before.end_tangent(), after.start_tangent()) {
        (Some(before), Some(after)) => before.angle(after) <= SMOOTH,
        _ => false,
    };
    if !pairs().all(smooth) {
        return arcs_near(spec, curve);
    }
    if !pairs().any(|pair| may_be_one(pair, spec.tolerance)) {
        return itself();
    }
    let made = arcs_near(spec, curve);
    let fewer = matches!(&made, Ok((CurveObject::ArcPath(fitted), ..)) if fitted.arcs().len() < own.len());
    if fewer { made } else { itself() }
}

/// Whether one circle may do for two neighbors between their middles, within the tolerance. With fewer arcs than there are, one does somewhere: joints
/// that are fewer than these stretches leave one of them without any.
fn may_be_one([before, after]: [&Arc; 2], tolerance: f64) -> bool {
    let [first, second] = [before, after].map(|arc| 0.5 * arc.piece_length(0, 0.0, 1.0));
    let place = |k: u32| {
        let way = (first + second) * f64::from(k) / f64::from(BETWEEN);
        if way <= first { before.point(0.5 + 0.5 * way / first) } else { after.point(0.5 * (way - first) / second) }
    };
    // Neighbors without an extent to speak of are for the fit.
    let Ok(one) = Arc::from_three_points(place(0), place(BETWEEN / 2), place(BETWEEN)) else { return true };
    let off = (0..=BETWEEN).map(|k| one.closest_point(place(k)).distance).fold(0.0, f64::max);
    !(off > OFF_BY * tolerance)
}

fn arcs_near(spec: &ArcFitSpec, curve: &CurveObject) -> Made {
    let within = POLYLINE_SHARE * spec.tolerance;
    let mut options = fit_options(spec);
    options.closed = curve.as_curve().is_closed();
    options.target = FitTarget::Polyline;
    options.tolerance -= within;
    let places = flatten_within(curve.as_curve(), within, MOST_VERTICES)?;
    let mut points: Vec<Point3> = places.iter().map(|(_, point)| *point).collect();
    if options.closed {
        points.pop();
    }
    let fit = ArcFit::new(&points, &options)?;
    let mut certificate = *fit.certificate();
    for deviation in
        [&mut certificate.deviation, &mut certificate.vertex_deviation, &mut certificate.polyline_deviation]
    {
        *deviation += within;
    }
    // What is proved is of the polyline, with the tenth besides; what was reached is measured.
    certificate.deviation = certificate.deviation.min(measured(curve.as_curve(), &places, fit.path().arcs()));
    let facts = ContourFacts { fit: Some(Fitted::Arcs(certificate)), ..ContourFacts::default() };
    Ok((CurveObject::ArcPath(fit.path().clone()), facts, fit.warnings().to_vec()))
}

/// The largest distance of points of a curve, the vertices of its polyline and some between them, from the arcs, which run with it.
fn measured(curve: &dyn ParamCurve, places: &[(CurvePlace, Point3)], arcs: &[Arc]) -> f64 {
    let between = places.windows(2).flat_map(|pair| {
        let [(from, _), (to, _)] = [pair[0], pair[1]];
        // The end of a piece may be told as the start of the next one.
        let end = if to.piece == from.piece { to.s } else { 1.0 };
        (0..MEASURED).map(move |k| {
            let part = f64::from(k) / f64::from(MEASURED);
            curve.piece_point(from.piece, from.s + (end - from.s) * part)
        })
    });
    let distance = |arc: usize, p: Point3| arcs[arc % arcs.len()].closest_point(p).distance;
    // A closed path may have its seam elsewhere.
    let first = places.first().map_or(Point3::ORIGIN, |(_, point)| *point);
    let mut at = (0..arcs.len()).min_by(|a, b| distance(*a, first).total_cmp(&distance(*b, first))).unwrap_or(0);
    let mut largest = 0.0_f64;
    for p in between.chain(places.last().map(|(_, point)| *point)) {
        let mut nearest = distance(at, p);
        loop {
            let next = distance(at + 1, p);
            if !(next < nearest) {
                break;
            }
            (at, nearest) = (at + 1, next);
        }
        largest = largest.max(nearest);
    }
    largest
}

pub(in crate::document) fn arc_fit(spec: &ArcFitSpec, at: &Contour<'_>) -> Made {
    let mut options = fit_options(spec);
    options.corners.clone_from(&at.list.corners);
    let fit = ArcFit::new(&at.list.points, &options)?;
    Ok((
        CurveObject::ArcPath(fit.path().clone()),
        at.facts(Some(Fitted::Arcs(*fit.certificate()))),
        fit.warnings().to_vec(),
    ))
}
