//! Constructions that run on lists of points, from the fields of a document to the kernel's options.

use cyclide::{
    Arc, ArcFit, ArcFitOptions, ArcPath, ArcSplineOptions, CircleSpline, CircleSplineOptions, CurveObject, CurvePlace,
    ErrorItem, FairEnd, FairFit, FairFitCertificate, FairFitOptions, FairSplineOptions, FitCertificate, FitTarget,
    Heights, Noise, ParamCurve, Point3, SplineEnds, Torus, Vec3, Warning, corners_by_angle, flatten_within,
};

use super::angle::Angle;
use super::coordinates::Coordinates;
use super::interpolate::InterpolationFacts;
use super::spec::{
    ArcFitSpec, ArcSplineSpec, CircleSplineSpec, EndsSpec, FairEndPair, FairEndSpec, FairEndWord, FairEndsSpec,
    FairFitSpec, FairSplineSpec, FairTolerance, PolylineSpec, RadiiSpec, StraightWord,
};
use crate::input::points::PointList;

/// What is known about a contour besides its curve.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "points": [[1, 0], [0, 1], [-1, 0], [0, -1]], "closed": true}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!((built[0].contours[0].points, built[0].contours[0].fit), (4, None));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContourFacts {
    /// Points it was made from, after merging; 0 if it was not made from a list.
    pub points: usize,
    /// The certificate of a fit.
    pub fit: Option<Fitted>,
    /// The largest distance by which points were moved onto the torus that the curve lies on.
    pub moved: Option<f64>,
    /// The torus whose normals go with it, of a curve parallel to one of a torus: that on which it lies.
    pub torus: Option<Torus>,
    /// What is known of a curve of lowest degree through points.
    pub interpolation: Option<InterpolationFacts>,
}

/// What is proved about a fitted contour.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"f": {"type": "arc-fit", "tolerance": 0.1, "points": [[0, 0], [1, 0.05], [2, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let Some(cyclide_io::Fitted::Arcs(certificate)) = built[0].contours[0].fit else { unreachable!("by its type") };
/// assert!(certificate.deviation <= 0.1);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fitted {
    /// By arcs and lines.
    Arcs(FitCertificate),
    /// By a fair spline.
    Fair(FairFitCertificate),
}

/// A contour's points after merging.
pub(super) struct Contour<'a> {
    pub(super) index: usize,
    pub(super) list: &'a PointList,
    /// The index, in the list as given, of each point.
    pub(super) kept: &'a [usize],
}

/// A curve, what is known about it, and what its construction remarked.
pub(super) type Made = cyclide::Result<(CurveObject, ContourFacts, Vec<Warning>)>;

pub(super) fn polyline(spec: &PolylineSpec, at: &Contour<'_>) -> Made {
    let radii = match &spec.radius {
        RadiiSpec::All(radius) => vec![*radius; at.kept.len()],
        RadiiSpec::Each(given) => {
            // Of the points as given, those that were merged away included; a point that repeats the first one may have its own.
            let needed = at.kept.last().map_or(0, |last| last + 1);
            if given.len() != needed && !(spec.closed && given.len() == needed + 1) {
                return Err(cyclide::Error::CountDiffers { what: ErrorItem::Radius, given: given.len(), needed });
            }
            at.kept.iter().filter_map(|&i| given.get(i).copied()).collect()
        }
    };
    let path = ArcPath::rounded_polyline(&at.list.points, spec.closed, &radii)?;
    Ok((CurveObject::ArcPath(path), at.facts(None), Vec::new()))
}

pub(super) fn arc_spline(spec: &ArcSplineSpec, at: &Contour<'_>) -> Made {
    let tangents = match &spec.tangents {
        None => None,
        Some(given) => {
            let needed = at.kept.last().map_or(0, |last| last + 1).max(at.kept.len());
            let given = given.lists.get(at.index).map_or(&[][..], Vec::as_slice);
            // Tangents belong to the points as given; those of points that were merged away go with them.
            let tangents: Option<Vec<Vec3>> = at.kept.iter().map(|&i| given.get(i).map(|t| t.vector())).collect();
            Some(tangents.ok_or(cyclide::Error::CountDiffers {
                what: ErrorItem::Tangent,
                given: given.len(),
                needed,
            })?)
        }
    };
    let options = ArcSplineOptions { closed: spec.closed, rule: spec.rule, tangents };
    let path = ArcPath::spline(&at.list.points, &options)?;
    Ok((CurveObject::ArcPath(path), at.facts(None), Vec::new()))
}

/// The part of the tolerance by which a polyline may leave the curve that arcs are fitted to.
const POLYLINE_SHARE: f64 = 0.1;
/// Points of the curve on each edge of the polyline whose distance from the arcs is measured.
const MEASURED: u32 = 4;
/// Vertices of this polyline at most.
pub(super) const MOST_VERTICES: usize = 200_000;

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

/// Arcs of a path meet smoothly where their tangents differ by no more than this angle: rounding, as between two fitted arcs.
const SMOOTH: f64 = 1e-9;

/// Arcs within the tolerance of a curve, by way of a polyline that is ten times as near. An arc or a circle is itself, and so are arcs that meet smoothly
/// and are no more than what would be fitted to them.
pub(super) fn arc_fit_of_curve(spec: &ArcFitSpec, curve: &CurveObject) -> Made {
    if !(spec.tolerance > 0.0 && spec.tolerance.is_finite()) {
        return Err(cyclide::Error::ToleranceNotPositive { tolerance: spec.tolerance });
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

/// Places between the middles of neighbours.
const BETWEEN: u32 = 16;
/// A circle through three places of neighbours is off by up to this many times as much as the nearest one: that through three even places by 2.25 times,
/// where distances go as a cubic.
const OFF_BY: f64 = 4.0;

/// Whether one circle may do for two neighbours between their middles, within the tolerance. With fewer arcs than there are, one does somewhere: joints
/// that are fewer than these stretches leave one of them without any.
fn may_be_one([before, after]: [&Arc; 2], tolerance: f64) -> bool {
    let [first, second] = [before, after].map(|arc| 0.5 * arc.piece_length(0, 0.0, 1.0));
    let place = |k: u32| {
        let way = (first + second) * f64::from(k) / f64::from(BETWEEN);
        if way <= first { before.point(0.5 + 0.5 * way / first) } else { after.point(0.5 * (way - first) / second) }
    };
    // Neighbours without an extent to speak of are for the fit.
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

pub(super) fn arc_fit(spec: &ArcFitSpec, at: &Contour<'_>) -> Made {
    let mut options = fit_options(spec);
    options.corners.clone_from(&at.list.corners);
    let fit = ArcFit::new(&at.list.points, &options)?;
    Ok((
        CurveObject::ArcPath(fit.path().clone()),
        at.facts(Some(Fitted::Arcs(*fit.certificate()))),
        fit.warnings().to_vec(),
    ))
}

pub(super) fn fair_fit(spec: &FairFitSpec, at: &Contour<'_>) -> Made {
    let mut options = match spec.tolerance {
        FairTolerance::Within(tolerance) => FairFitOptions::new(tolerance),
        FairTolerance::Auto(_) => FairFitOptions::by_noise(spec.noise.map_or(Noise::Estimated, Noise::Known)),
    };
    options.outliers = spec.outliers;
    options.heights = match spec.tolerance_z {
        None => Heights::AsAll,
        Some(FairTolerance::Within(tolerance)) => Heights::Within(tolerance),
        Some(FairTolerance::Auto(_)) => Heights::ByNoise,
    };
    options.closed = spec.closed;
    options.centre = spec.centre;
    options.fix_ends = spec.fix_ends;
    options.corner_angle = spec.corner_angle.map(Angle::radians);
    options.corners.clone_from(&at.list.corners);
    options.max_fits = spec.max_fits.map_or(options.max_fits, |n| n as usize);
    options.nodes = spec.nodes.map(|n| n as usize);
    options.budget = spec.budget.unwrap_or(options.budget);
    options.edge_points = spec.polyline as usize;
    let fit = FairFit::new(&at.list.points, &options)?;
    fit.spline().check_finite()?;
    let (facts, warnings) = (at.facts(Some(Fitted::Fair(*fit.certificate()))), fit.warnings().to_vec());
    Ok((CurveObject::CircleSpline(fit.into_spline()), facts, warnings))
}

/// The corners marked in the file, and those that turn by more than the angle given.
pub(super) fn corners(at: &Contour<'_>, closed: bool, angle: Option<Angle>) -> cyclide::Result<Vec<usize>> {
    let mut corners = at.list.corners.clone();
    if let Some(angle) = angle.map(Angle::radians) {
        let max = std::f64::consts::PI;
        if !(angle > 0.0 && angle <= max) {
            return Err(cyclide::Error::ParameterOutOfRange {
                name: ErrorItem::CornerAngle,
                value: angle,
                min: 0.0,
                max,
            });
        }
        corners.extend(corners_by_angle(&at.list.points, closed, angle));
        corners.sort_unstable();
        corners.dedup();
    }
    Ok(corners)
}

pub(super) fn fair_spline(spec: &FairSplineSpec, at: &Contour<'_>) -> Made {
    let options = FairSplineOptions {
        closed: spec.closed,
        ends: spec.ends.into(),
        tension: spec.tension,
        straight_runs: spec.straight == StraightWord::Auto,
        tight: spec.tight,
        corners: corners(at, spec.closed, spec.corner_angle)?,
        ..FairSplineOptions::default()
    };
    let spline = CircleSpline::fair(&at.list.points, &options)?;
    spline.check_finite()?;
    let warnings = spline.warnings().to_vec();
    Ok((CurveObject::CircleSpline(spline), at.facts(None), warnings))
}

pub(super) fn circle_spline(spec: &CircleSplineSpec, at: &Contour<'_>) -> Made {
    let points: &[Point3] = &at.list.points;
    let corners = corners(at, spec.closed, spec.corner_angle)?;
    let ends = match spec.ends {
        EndsSpec::Natural => SplineEnds::Natural,
        EndsSpec::Clamped(given) => {
            SplineEnds::Clamped { start: given.start.map(Coordinates::vector), end: given.end.map(Coordinates::vector) }
        }
    };
    let (closed, order, variant) = (spec.closed, spec.order, spec.variant);
    let spline = CircleSpline::from_points(points, &CircleSplineOptions { closed, order, variant, ends, corners })?;
    spline.check_finite()?;
    let warnings = spline.warnings().to_vec();
    Ok((CurveObject::CircleSpline(spline), at.facts(None), warnings))
}

impl Contour<'_> {
    pub(super) fn facts(&self, fit: Option<Fitted>) -> ContourFacts {
        ContourFacts { points: self.list.points.len(), fit, ..ContourFacts::default() }
    }
}

impl From<FairEndsSpec> for [FairEnd; 2] {
    fn from(ends: FairEndsSpec) -> Self {
        match ends {
            FairEndsSpec::Both(word) => [word.into(); 2],
            FairEndsSpec::Each(FairEndPair { start, end }) => {
                [start, end].map(|end| end.map_or(FairEnd::Circle, FairEnd::from))
            }
        }
    }
}

impl From<FairEndSpec> for FairEnd {
    fn from(end: FairEndSpec) -> Self {
        match end {
            FairEndSpec::Word(word) => word.into(),
            FairEndSpec::Direction(direction) => Self::Clamped(direction.vector()),
        }
    }
}

impl From<FairEndWord> for FairEnd {
    fn from(word: FairEndWord) -> Self {
        match word {
            FairEndWord::Circle => Self::Circle,
            FairEndWord::Arc => Self::Arc,
            FairEndWord::Free => Self::Free,
        }
    }
}
