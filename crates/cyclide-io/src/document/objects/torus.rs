//! Curves on a torus: splines, knots, circles, and curves laid flat.

use cyclide::{
    ArcPath, Body, Circle, CircleFamily, CurveObject, Error as E, ErrorItem as I, Lower as _, Point2, QuarticType,
    ShortNumber, SurfaceObject, Torus, TorusMap, TorusSeam, TorusSpline, TorusSplineOptions, TorusTangent,
    TorusWinding, UnrollOptions,
};

use super::Builder;
use super::curves::{Origin, Points};
use super::nets::frame_of_axes;
use super::refuse::Blame;
use super::transform::map_of;
use crate::document::angle::Angle;
use crate::document::construct::{Contour, ContourFacts, Made};
use crate::document::coordinates::Coordinates;
use crate::document::locate::Step;
use crate::document::spec::{
    CyclideSpec, FreeOr, ObjectSpec, OffsetSpec, TorusCircleSpec, TorusKnotSpec, TorusMethod, TorusQuarticSpec,
    TorusSeamSpec, TorusSource, TorusSplineSpec, UnrolledSpec, WindingSpec,
};
use crate::error::{Error, Result};
use crate::input::points::PointList;

/// Distance within which points must be near the torus where nothing is said, as part of its major radius: more than the rounding
/// of coordinates with six digits after the point, less than anybody sees.
const NEAR: f64 = 1e-6;

/// Distance within which arcs stand for a curve that is laid flat where nothing is said, as part of the width of the plane.
const FLAT: f64 = 1e-5;

/// Distance within which the edges of a seam follow its curve where nothing is said, as part of its width.
const SEAM: f64 = 1e-3;

/// What became of a curve of a torus when it was laid flat, over all its contours.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [1, 1]}, "u": {"type": "unrolled", "of": "k"}}}"#.parse()?;
/// let built = document.build()?;
/// let plane = built[1].unrolled.expect("it is laid flat");
/// assert!((plane.size[1] - 30.0 * std::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnrolledPlane {
    /// The map.
    pub map: TorusMap,
    /// Width and height of the plane of the whole torus.
    pub size: [f64; 2],
    /// How often the curve was cut.
    pub cuts: usize,
    /// The least and the largest factor by which the map multiplies lengths round the axis, on the curve.
    pub stretch: [f64; 2],
    /// Length of the curve on the torus, and of all lines in the plane.
    pub lengths: [f64; 2],
    /// Distance within which arcs stand for the curve in the plane.
    pub tolerance: f64,
}

impl Builder<'_> {
    /// The torus that a curve lies on.
    fn torus(&self, source: &TorusSource) -> Result<Torus> {
        let refused = |e: cyclide::Error| self.refused_at([Step::from("torus")], &e);
        match source {
            TorusSource::Here(spec) => frame_of_axes(spec.center, spec.axis, spec.x_direction)
                .and_then(|frame| Torus::new(frame, spec.major_radius, spec.minor_radius))
                .map_err(refused),
            TorusSource::Named(name) => self.named_torus(name),
        }
    }

    /// The torus that an object is: a `cyclide` with `c` = 0, or its image under a `transform` that keeps it a torus.
    fn named_torus(&self, name: &str) -> Result<Torus> {
        let refused = |e: cyclide::Error| self.refused_at([Step::from("torus")], &e);
        let unfit = |message: String| Error::Input(self.diagnostic([Step::from("torus")], &message));
        let named = self.document.objects.iter().find(|(other, _)| other == name).map(|(_, spec)| spec);
        match named {
            Some(ObjectSpec::Cyclide(CyclideSpec { a, c: 0.0, mu, center, axis, x_direction, .. })) => {
                frame_of_axes(*center, *axis, *x_direction)
                    .and_then(|frame| Torus::new(frame, *a, *mu))
                    .map_err(refused)
            }
            Some(ObjectSpec::Cyclide(CyclideSpec { c, .. })) => {
                Err(unfit(format!("`{name}` is a `cyclide` with `c` = {c}: a torus has `c` = 0")))
            }
            Some(ObjectSpec::Transform(spec)) => {
                let mut torus = self.named_torus(&spec.of)?;
                for (index, step) in spec.steps.iter().enumerate() {
                    let map = map_of(step).map_err(refused)?;
                    if !map.is_similarity() {
                        return Err(unfit(format!(
                            "step {index} of the `transform` `{name}` is no similarity: a torus stays one where it is moved, turned, scaled or mirrored"
                        )));
                    }
                    torus = torus.similar(&map).map_err(refused)?;
                }
                Ok(torus)
            }
            other => {
                let kind = other.map_or("", ObjectSpec::type_word);
                Err(unfit(format!(
                    "`{name}` is of type `{kind}`: a torus is a `cyclide` with `c` = 0, or a `transform` of one"
                )))
            }
        }
    }

    /// The curves through points or through places given by angles.
    pub(in crate::document) fn torus_spline(
        &mut self,
        spec: &TorusSplineSpec,
    ) -> Result<Vec<(CurveObject, ContourFacts)>> {
        self.check_fields(spec)?;
        let torus = self.torus(&spec.torus)?;
        let construct = |at: &Contour<'_>| spline(spec, &torus, at);
        let made = match (&spec.points, &spec.angles) {
            (Some(points), None) => self.each_contour(points, spec.closed, construct),
            (None, Some(angles)) => {
                // As points in space repeated ones are found in the same way.
                let points = angles.pairs.iter().map(|[a, b]| torus.point(torus.place_of_angles(*a, *b))).collect();
                let lists = vec![PointList { points, ..PointList::default() }];
                let field: &[&str] = if angles.in_degrees { &["angles", "degrees"] } else { &["angles"] };
                let origin = Origin::Document { nested: false, field };
                self.each_contour_of(Points { kept: vec![Vec::new()], lists, origin }, spec.closed, construct)
            }
            _ => Err(self.unfit("a `torus-spline` is given by `points` or by `angles`")),
        }?;
        let moved = made.iter().filter_map(|(_, facts)| facts.moved).fold(0.0, f64::max);
        self.warn_of_move(moved, &torus, "points");
        Ok(made)
    }

    /// Fields that do not go together.
    fn check_fields(&self, spec: &TorusSplineSpec) -> Result<()> {
        let two_types = spec.method == TorusMethod::TwoTypes;
        let is_directed = spec.tangents.as_ref().is_some_and(|all| all.iter().all(|FreeOr(given)| given.is_some()))
            || spec.rates.as_ref().is_some_and(|all| all.pairs.iter().all(Option::is_some));
        let message = if spec.tangents.is_some() && spec.rates.is_some() {
            "directions are given by `tangents` or by `rates`"
        } else if matches!(spec.winding, Some(WindingSpec::Total(_))) && !spec.closed {
            "a pair of turns is that of a closed curve: set `closed`, or give a list of pairs, one for each step"
        } else if spec.angles.is_some() && spec.tolerance.is_some() {
            "`tolerance` goes with `points`: angles are on the torus"
        } else if two_types && !(spec.closed && is_directed) {
            "the method `two-types` makes closed curves with a direction at every point: set `closed`, and give `tangents` or `rates`"
        } else if two_types && (spec.knots.is_some() || spec.winding.is_some() || spec.loops) {
            "the method `two-types` goes the shortest way with the knots 0, 1, 2, …: leave out `knots`, `winding` and `loops`"
        } else {
            return Ok(());
        };
        Err(self.unfit(message))
    }

    /// A torus knot.
    pub(in crate::document) fn torus_knot(&self, spec: &TorusKnotSpec) -> Result<TorusSpline> {
        let torus = self.torus(&spec.torus)?;
        let start = spec.start.map_or(Point2::default(), |start| place(&torus, start));
        TorusSpline::knot(&torus, spec.turns, start).map_err(|e| self.refused(&e, None))
    }

    /// A closed quartic of one type.
    pub(in crate::document) fn torus_quartic(&self, spec: &TorusQuarticSpec) -> Result<TorusSpline> {
        let torus = self.torus(&spec.torus)?;
        let [one, other] = spec.families.map(CircleFamily::from);
        let Some(kind) = QuarticType::between(one, other) else {
            let message = "a quartic runs along two different families of circles";
            return Err(Error::Input(self.diagnostic([Step::from("families")], message)));
        };
        // The type has its families in their order: the ratio is that of the second one given.
        let ratio = if kind.families() == [one, other] { spec.ratio } else { 1.0 / spec.ratio };
        let start = spec.start.map_or(Point2::default(), |start| place(&torus, start));
        TorusSpline::closed_quartic(&torus, kind, start, ratio).map_err(|e| match e {
            // The range is that of its reciprocal too: said of what was typed.
            E::ParameterOutOfRange { name: I::Ratio, min, max, .. } => {
                self.refused(&E::ParameterOutOfRange { name: I::Ratio, value: spec.ratio, min, max }, None)
            }
            other => self.refused(&other, None),
        })
    }

    /// The place that a circle runs through, and how far its point was moved.
    fn place_of_circle(&self, spec: &TorusCircleSpec, torus: &Torus) -> Result<(Point2, f64)> {
        match (spec.through, spec.at) {
            (Some(through), None) => {
                let tolerance = spec.tolerance.unwrap_or(NEAR * torus.major_radius());
                let at = torus.locate(through.point(), tolerance).map_err(|e| self.refused(&e, None))?;
                Ok((at, torus.distance(through.point()).abs()))
            }
            (None, Some(at)) if spec.tolerance.is_none() => Ok((place(torus, at), 0.0)),
            (None, Some(_)) => Err(self.unfit("`tolerance` goes with `through`: angles are on the torus")),
            _ => Err(self.unfit("a circle of a torus is given by a point: `through` or `at`")),
        }
    }

    /// A circle of a torus.
    pub(in crate::document) fn torus_circle(&mut self, spec: &TorusCircleSpec) -> Result<(CurveObject, ContourFacts)> {
        let torus = self.torus(&spec.torus)?;
        let (at, moved) = self.place_of_circle(spec, &torus)?;
        let circle: Circle = torus.circle(spec.family.into(), at).map_err(|e| self.refused(&e, None))?;
        self.warn_of_move(moved, &torus, "through");
        Ok((CurveObject::Circle(circle), ContourFacts::default()))
    }

    /// Says that points were moved by more than rounding.
    fn warn_of_move(&mut self, moved: f64, torus: &Torus, field: &str) {
        if moved <= NEAR * torus.major_radius() {
            return;
        }
        let place = self.place_of([Step::from(field)]);
        let message = format!(
            "points are up to {} away from the torus: each was moved to the nearest point of it",
            ShortNumber(moved)
        );
        self.remark("moved-onto-torus", None, None, place, message);
    }

    /// The splines that the source consists of, one at least; a circle of a torus as the spline of arcs that it is.
    fn splines_of_source(&self, needed: &str) -> Result<Vec<TorusSpline>> {
        let name = self.sources.first().map(|source| &source.item.name);
        let spec = self.document.objects.iter().find(|(other, _)| Some(other) == name).map(|(_, spec)| spec);
        if let Some(ObjectSpec::TorusCircle(circle)) = spec {
            let torus = self.torus(&circle.torus)?;
            let (at, _) = self.place_of_circle(circle, &torus)?;
            let spline = TorusSpline::circle(&torus, circle.family.into(), at);
            return Ok(vec![spline.map_err(|e| self.refused(&e, None))?]);
        }
        let source = self.sources.first().map_or(&[][..], |source| source.item.curves());
        let on_torus = |curve: &CurveObject| match curve {
            CurveObject::TorusSpline(spline) => Some(spline.clone()),
            _ => None,
        };
        let splines: Vec<TorusSpline> = source.iter().map_while(on_torus).collect();
        if splines.is_empty() || splines.len() < source.len() {
            let message = format!("only a `torus-spline`, `torus-knot`, `torus-quartic` or `torus-circle` {needed}");
            return Err(self.wrong_source(&message));
        }
        Ok(splines)
    }

    /// The curves at a distance along the normal of the torus of the source.
    pub(in crate::document) fn parallel_curves(&self, spec: &OffsetSpec) -> Result<Vec<(CurveObject, ContourFacts)>> {
        if spec.thick {
            return Err(
                self.wrong_source_at([Step::from("thick")], "only surfaces have a solid between them and their offset")
            );
        }
        let splines = self.splines_of_source("has a parallel curve, and only surfaces have an offset")?;
        let parallels = splines.iter().map(|spline| {
            let torus = spline.torus();
            let made = spline.parallel(spec.distance).and_then(|curve| {
                let thicker = Torus::new(torus.frame(), torus.major_radius(), torus.minor_radius() + spec.distance)?;
                Ok((CurveObject::Nurbs(curve), ContourFacts { torus: Some(thicker), ..ContourFacts::default() }))
            });
            made.map_err(|e| self.refused(&e, None))
        });
        parallels.collect()
    }

    /// Raised or sunk seams.
    pub(in crate::document) fn torus_seam(&mut self, spec: &TorusSeamSpec) -> Result<Vec<SurfaceObject>> {
        let splines = self.splines_of_source("has a seam along it")?;
        let tolerance = spec.tolerance.unwrap_or(SEAM * spec.width);
        let refused = |e: cyclide::Error| self.refused(&e, None);
        let seam = TorusSeam::new(spec.width, spec.height).map_err(refused)?;
        let bodies: cyclide::Result<Vec<Body>> = splines.iter().map(|spline| seam.body(spline, tolerance)).collect();
        let bodies = bodies.map_err(refused)?;
        if let Some(([first, second], point)) = seam.first_meeting(&splines, tolerance).map_err(refused)? {
            let [x, y, z] = point.to_array().map(ShortNumber);
            let message = format!(
                "the seams of the contours {first} and {second} run through each other at {x}, {y}, {z}: each is a body of its own, and volume and area count what they share twice; fuse them in CAD"
            );
            let place = self.place_of([Step::from("width")]);
            self.remark("seams-meet", Some(second), None, place, message);
        }
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }

    /// Curves of a torus laid flat.
    pub(in crate::document) fn unrolled(&mut self, spec: &UnrolledSpec) -> Result<Vec<CurveObject>> {
        let splines = self.splines_of_source("is laid flat with its torus")?;
        let torus = *splines[0].torus();
        let size = spec.map.size(&torus);
        let mut options = UnrollOptions::new(spec.tolerance.unwrap_or(FLAT * size[0]));
        options.map = spec.map;
        options.seam = spec.seam.map_or(options.seam, |seam| seam.map(Angle::turn));
        let mut plane = UnrolledPlane {
            map: spec.map,
            size,
            cuts: 0,
            stretch: [f64::INFINITY, 0.0],
            lengths: [0.0; 2],
            tolerance: options.tolerance,
        };
        let mut curves = Vec::new();
        for spline in &splines {
            let flat = spline.unroll(&options).map_err(|e| self.refused(&e, None))?;
            plane.cuts += flat.cuts;
            plane.stretch = [plane.stretch[0].min(flat.stretch[0]), plane.stretch[1].max(flat.stretch[1])];
            plane.lengths = [plane.lengths[0] + flat.lengths[0], plane.lengths[1] + flat.lengths[1]];
            curves.extend(flat.lines.into_iter().map(CurveObject::ArcPath));
        }
        if plane.cuts > 0 {
            let (cuts, lines) = (plane.cuts, curves.len());
            let counted = |count: usize, one: &str, more: &str| {
                if count == 1 { one.to_owned() } else { format!("{count} {more}") }
            };
            let message = format!(
                "the curve crosses the cuts of the torus {} and is {} in the plane: lines end at its border",
                counted(cuts, "once", "times"),
                counted(lines, "one line", "lines")
            );
            self.remark("cut-at-seam", None, None, None, message);
        }
        if spec.border {
            curves.push(CurveObject::ArcPath(border(&torus, &options).map_err(|e| self.refused(&e, None))?));
        }
        self.unrolled = Some(plane);
        Ok(curves)
    }
}

/// The place at a longitude and a meridian angle; whole turns do not matter.
fn place(torus: &Torus, [longitude, meridian]: [Angle; 2]) -> Point2 {
    torus.place_of_angles(longitude.turn(), meridian.turn())
}

/// The rectangle of the unrolled torus: longitudes from the cut on, meridian angles up to it.
fn border(torus: &Torus, options: &UnrollOptions) -> cyclide::Result<ArcPath> {
    let [width, height] = options.map.size(torus);
    let corner = options.map.point(torus, torus.place_of_angles(options.seam[0], options.seam[1]));
    let corners = [[0.0, -height], [width, -height], [width, 0.0], [0.0, 0.0]];
    let points = corners.map(|[x, y]| cyclide::Point3::new(corner.x + x, corner.y + y, 0.0));
    ArcPath::rounded_polyline(&points, true, &[0.0; 4])
}

/// One contour of a spline.
fn spline(spec: &TorusSplineSpec, torus: &Torus, at: &Contour<'_>) -> Made {
    let mut facts = at.facts(None);
    let places: Vec<Point2> = if let Some(angles) = &spec.angles {
        at.kept.iter().filter_map(|&i| angles.pairs.get(i)).map(|[a, b]| torus.place_of_angles(*a, *b)).collect()
    } else {
        let tolerance = spec.tolerance.unwrap_or(NEAR * torus.major_radius());
        facts.moved = Some(at.list.points.iter().map(|p| torus.distance(*p).abs()).fold(0.0, f64::max));
        torus.locate_all(&at.list.points, tolerance)?
    };
    let tangents = tangents(spec, torus, &places, at)?;
    let made = if spec.method == TorusMethod::TwoTypes {
        let rates: Vec<_> = tangents
            .iter()
            .zip(&places)
            .map(|(tangent, place)| match tangent {
                TorusTangent::Rate(rate) => *rate,
                TorusTangent::Velocity(velocity) => torus.rate(*place, *velocity),
                TorusTangent::Free => cyclide::Vec2::default(),
            })
            .collect();
        TorusSpline::two_type_loop(torus, &places, &rates)?
    } else {
        let winding = match &spec.winding {
            None => TorusWinding::Shortest,
            Some(WindingSpec::Total(turns)) => TorusWinding::Total(*turns),
            Some(WindingSpec::Each(turns)) => TorusWinding::PerSegment(turns.clone()),
        };
        let knots = spec.knots.as_ref().map_or_else(Vec::new, |knots| kept_knots(knots, spec.closed, at));
        let options = TorusSplineOptions { closed: spec.closed, tangents, knots, winding, loops: spec.loops };
        TorusSpline::through_places(torus, &places, &options)?
    };
    // What has no rational form would be in no file.
    made.lower_to_chain(NEAR * torus.major_radius())?;
    Ok((CurveObject::TorusSpline(made), facts, Vec::new()))
}

/// The directions of the points that are left after merging; empty if none is given.
fn tangents(
    spec: &TorusSplineSpec,
    torus: &Torus,
    places: &[Point2],
    at: &Contour<'_>,
) -> cyclide::Result<Vec<TorusTangent>> {
    let velocity = |FreeOr(v): &FreeOr<Coordinates>, _: Point2| v.map(|v| TorusTangent::Velocity(v.vector()));
    let rate = |r: &Option<[f64; 2]>, place| r.map(|r| TorusTangent::Rate(torus.rate_of_angles(place, r)));
    match (&spec.tangents, &spec.rates) {
        (Some(given), _) => of_kept(given, places, at, velocity),
        (None, Some(given)) => of_kept(&given.pairs, places, at, rate),
        (None, None) => Ok(Vec::new()),
    }
}

/// Each point's own of a list for the points as given; what belongs to points that were merged away goes with them.
fn of_kept<T>(
    given: &[T],
    places: &[Point2],
    at: &Contour<'_>,
    tangent: impl Fn(&T, Point2) -> Option<TorusTangent>,
) -> cyclide::Result<Vec<TorusTangent>> {
    let needed = at.kept.last().map_or(0, |last| last + 1).max(at.kept.len());
    // The last point of a closed list may repeat the first.
    if given.len() < needed || given.len() > needed + 1 {
        return Err(E::CountDiffers { what: I::Tangent, given: given.len(), needed });
    }
    let own = at.kept.iter().zip(places).filter_map(|(&i, place)| given.get(i).map(|g| tangent(g, *place)));
    Ok(own.map(Option::unwrap_or_default).collect())
}

/// The knots of the points that are left after merging, and that at the end of a closed curve.
fn kept_knots(knots: &[f64], closed: bool, at: &Contour<'_>) -> Vec<f64> {
    let needed = at.kept.last().map_or(0, |last| last + 1);
    if at.kept.len() == needed {
        return knots.to_vec();
    }
    let own = at.kept.iter().filter_map(|&i| knots.get(i).copied());
    let end = knots.last().copied().filter(|_| closed && knots.len() > needed);
    own.chain(end).collect()
}

/// True if a curve on a torus was given a direction there that is not zero.
pub(in crate::document) fn is_given(spec: &TorusSplineSpec, index: usize) -> bool {
    let given = spec.tangents.as_ref().and_then(|all| all.get(index)).and_then(|FreeOr(given)| *given);
    given.is_some_and(|given| given.vector().length() > 0.0)
}

/// What the values of a curve on a torus are called.
pub(in crate::document) struct TorusFields {
    /// Its directions, and its places as angles.
    pub directions: &'static str,
    pub angles: &'static str,
    /// Numbers of turns.
    pub turns: &'static str,
    /// It was given knots.
    pub knots: bool,
}

impl TorusFields {
    /// Those of a spline.
    pub const SPLINE: Self = Self { directions: "tangents", angles: "angles", turns: "winding", knots: false };
}

/// Which value of a curve on a torus an error of the kernel is about.
pub(in crate::document) fn blame_on_torus(fields: &TorusFields, error: &cyclide::Error) -> Blame {
    let TorusFields { directions, angles, turns, knots } = *fields;
    match error {
        E::ZeroTangent { index } | E::NotFinite { what: I::Tangent, index } => Blame::Entry(directions, *index),
        E::CountDiffers { what: I::Tangent, .. } => Blame::Field(directions),
        E::CountDiffers { what: I::Knot, .. } => Blame::Field("knots"),
        E::NotFinite { what: I::Knot, index } => Blame::Entry("knots", *index),
        E::EmptyInterval { index, .. } if knots => Blame::Entry("knots", index + 1),
        E::EmptyInterval { .. } => Blame::Field(directions),
        E::Disconnected { .. } | E::WeightNotPositive { .. } => Blame::Field("torus"),
        E::NotCoprime { .. } => Blame::Field("turns"),
        E::ParameterOutOfRange { name: name @ (I::Width | I::Height | I::Ratio), .. } => Blame::Field(name.word()),
        E::RadiusNotPositive { .. } | E::SeamMeetsItself { .. } | E::SeamTooWide { .. } => Blame::Field("width"),
        E::NoTwoTypeSolution { .. } => Blame::Field("method"),
        E::ToleranceNotPositive { .. } => Blame::Field("tolerance"),
        E::CountDiffers { what: I::Winding, .. } => Blame::Field("winding"),
        E::ParameterOutOfRange { name: I::Winding, .. } | E::TooManyPieces { .. } => Blame::Field(turns),
        E::ParameterOutOfRange { name: I::TangentOverSpan, .. } => {
            Blame::Field(if knots { "knots" } else { directions })
        }
        E::ParameterOutOfRange { name: I::Angle, .. } | E::NotFinite { what: I::Angle, .. } => Blame::Field(angles),
        _ => error.index().map_or(Blame::Object, Blame::Point),
    }
}

/// Which value of a seam an error is about: what is not said of its fields is about its curve.
pub(in crate::document) fn blame_seam(error: &cyclide::Error) -> Blame {
    let fields = TorusFields { turns: "tolerance", ..TorusFields::SPLINE };
    match error {
        E::ZeroTangent { .. }
        | E::NotFinite { what: I::Tangent | I::Knot, .. }
        | E::CountDiffers { what: I::Tangent | I::Knot, .. }
        | E::EmptyInterval { .. }
        | E::Disconnected { .. }
        | E::WeightNotPositive { .. }
        | E::NotCoprime { .. }
        | E::ParameterOutOfRange { name: I::Width | I::Height | I::Ratio, .. }
        | E::RadiusNotPositive { .. }
        | E::SeamMeetsItself { .. }
        | E::SeamTooWide { .. }
        | E::ToleranceNotPositive { .. }
        | E::TooManyPieces { .. } => blame_on_torus(&fields, error),
        _ => Blame::Field("of"),
    }
}
