//! A smooth curve on a torus through points.

use std::fmt;

use cyclide::{
    Point2,
    construct::{TorusSplineOptions, TorusTangent, TorusWinding},
    error::{ErrorItem as I, NumberError, PointError},
    model::{CurveObject, Lower as _},
    surface::{Torus, TorusSpline},
    warning::WaverRemedy,
};
use schemars::JsonSchema;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};

use crate::document::coordinates::{Coordinates, PointSource};
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::torus_numbers::{AnglePairs, FreeOr, RatePairs};
use crate::document::kinds::fields::torus_source::{NEAR, TorusSource};
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, ContourFacts, Made};
use crate::document::objects::idle::{Idle, found};
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape};
use crate::document::objects::points::{Origin, Points};
use crate::document::objects::wavers::{WaverData, WaverRule};
use crate::error::Result;
use crate::input::points::{PointList, merge_repeated};

/// A smooth curve on a torus through points near it, or through positions given by two angles: rational quartics that
/// lie exactly on the torus, C1 at their knots. With the method `general` such a curve always exists: where directions
/// turn back it makes a detour.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "torus-spline", "torus": {"major_radius": 40, "minor_radius": 15}, "angles": [[0, 0], [1, 1], [2, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let curve = built[0].item.curves()[0].as_curve();
/// // From the outer side of the tube.
/// assert!((curve.point(0.0).to_vec().length() - 55.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["points"], "properties": { "angles": false } },
    { "required": ["angles"], "properties": { "points": false, "tolerance": false } }
]))]
#[non_exhaustive]
pub struct TorusSplineSpec {
    /// The word `torus-spline`.
    #[schemars(with = "String", extend("const" = "torus-spline"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The torus on which the curve lies: given here, or the name of a `cyclide` that is a torus (`c` = 0) or of a
    /// `transform` that moves, turns, scales or mirrors one.
    pub torus: TorusSource,
    /// Points on or near the torus. Each is moved to the nearest point of the torus, by `tolerance` at most
    /// (`point-off-torus`); the report gives the distance, and above the default tolerance there is the warning
    /// `moved-onto-torus`.
    pub points: Option<PointSource>,
    /// Longitude and meridian angle of each point.
    pub angles: Option<AnglePairs>,
    /// Largest distance of the points from the torus. Default: a millionth of its major radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
    /// Velocities in space with respect to the knots, one for each point, without regard to their component normal to
    /// the torus; their length matters, and about the distance to the neighbors is suitable. `"free"` gives a point
    /// the velocity of the parabola through it and its neighbors.
    pub tangents: Option<Vec<FreeOr<Coordinates>>>,
    /// Velocities as rates of longitude and meridian angle with respect to the knots, one for each point; `"free"`
    /// leaves the velocity to the program.
    pub rates: Option<RatePairs>,
    /// The parameter at each point, increasing, and for a closed curve also at its end; default: 0, 1, 2, …. Knots or
    /// rates are rejected if they are so uneven that a part of the curve has no parameter interval beyond rounding,
    /// such as a span of 1e-10 of the whole that is to be passed slowly (`empty-interval`, with the segment).
    pub knots: Option<Vec<f64>>,
    /// The last point joins the first.
    #[serde(default)]
    pub closed: bool,
    /// Turns around the axis and around the tube of a closed curve, such as `[1, -2]`; or a list of turns added to the
    /// shortest path, one pair for each step. Default: the shortest path from point to point, at most half a turn of
    /// both angles.
    pub winding: Option<WindingSpec>,
    /// Equal neighboring points get a loop between them; otherwise they are one point.
    #[serde(default)]
    pub loops: bool,
    /// How the points are joined.
    #[serde(default)]
    pub method: TorusMethod,
}

/// How the points of a curve on a torus are joined.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "torus-spline", "torus": {"major_radius": 40, "minor_radius": 15}, "angles": [[0, 0], [1, 1], [2, 0]]}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::TorusSpline(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// assert_eq!(spec.method, cyclide_io::document::kinds::TorusMethod::General);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TorusMethod {
    /// By pieces of one type between two points where that suffices, otherwise by more. It always succeeds.
    #[default]
    General,
    /// By two pieces of two types from each point to the next that share a family of circles; these are fewer pieces
    /// where directions are along parallels and meridians in turn. The curve is closed, with a direction at every
    /// point, and not all data have such a curve (`no-two-type-solution`).
    TwoTypes,
}

/// The turns of a curve on a torus.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "torus-spline", "torus": {"major_radius": 40, "minor_radius": 15}, "angles": [[0, 0], [1, 1], [3, 0]], "closed": true, "winding": [1, 2]}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::TorusSpline(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// assert_eq!(spec.winding, Some(cyclide_io::document::kinds::WindingSpec::Total([1, 2])));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, JsonSchema)]
#[schemars(untagged, rename = "Winding")]
#[non_exhaustive]
pub enum WindingSpec {
    /// Around the axis and around the tube, in total.
    Total([i32; 2]),
    /// Added to the shortest path, for each step.
    Each(Vec<[i32; 2]>),
}

impl<'de> Deserialize<'de> for WindingSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        /// What can stand in the list.
        enum Cell {
            Turns(i32),
            Pair([i32; 2]),
        }
        struct CellVisitor;
        impl CellVisitor {
            const WHAT: &'static str = "a whole number of turns, or a pair of them";
            fn turns<E: serde::de::Error>(turns: Option<i32>) -> Result<Cell, E> {
                turns.map(Cell::Turns).ok_or_else(|| E::custom("too many turns"))
            }
        }
        impl<'de> Visitor<'de> for CellVisitor {
            type Value = Cell;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(Self::WHAT)
            }
            fn visit_i64<E: serde::de::Error>(self, turns: i64) -> Result<Cell, E> {
                Self::turns(i32::try_from(turns).ok())
            }
            fn visit_u64<E: serde::de::Error>(self, turns: u64) -> Result<Cell, E> {
                Self::turns(i32::try_from(turns).ok())
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Cell, A::Error> {
                <[i32; 2]>::deserialize(SeqAccessDeserializer::new(seq)).map(Cell::Pair)
            }
        }
        impl<'de> Deserialize<'de> for Cell {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(CellVisitor)
            }
        }
        let cells = Vec::<Cell>::deserialize(deserializer)?;
        if let [Cell::Turns(round), Cell::Turns(tube)] = cells[..] {
            return Ok(Self::Total([round, tube]));
        }
        let pair = |cell: Cell| match cell {
            Cell::Pair(pair) => Ok(pair),
            Cell::Turns(_) => Err(serde::de::Error::custom(
                "`winding` is a pair of turns `[1, 2]`, or a list of such pairs, one for each step",
            )),
        };
        cells.into_iter().map(pair).collect::<Result<_, _>>().map(Self::Each)
    }
}

impl Kind for TorusSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let made = at.torus_spline(self)?;
        at.warn_of_wavers_in("type", &made);
        Ok(Shape::Curves(made))
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.torus.reference()
    }

    fn points(&self) -> Option<&PointSource> {
        self.points.as_ref()
    }

    fn keeps_repeated_points(&self) -> bool {
        self.loops
    }

    fn keeps_corners(&self) -> bool {
        false
    }

    fn idle_fields(&self, at: &Contour<'_>, _: &CurveObject) -> Vec<Idle> {
        in_torus_spline(self, at)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule { through: false, ..WaverRule::of(WaverData::Nodes, WaverRemedy::Points) })
    }

    fn fields(&self) -> FieldNames {
        let directions = if self.rates.is_some() { "rates" } else { "tangents" };
        let mut fields = vec![("tangents", directions), ("angle", "angles")];
        if self.knots.is_none() {
            fields.push(("knots[]", directions));
        }
        fields
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        match error {
            cyclide::Error::Point(PointError::ZeroTangent { index }) if is_given(self, *index) => {
                Some(format!("tangent {index} is normal to the torus there: it has no tangential component"))
            }
            // Angles a whole turn apart are one place.
            cyclide::Error::Point(PointError::CoincidentPoints { .. })
                if !self.closed && self.winding.is_none() && self.angles.is_some() =>
            {
                Some(format!(
                    "{error}; for a turn that returns to the same point use `winding`, as in `[[1, 0]]`, or `closed`"
                ))
            }
            _ => None,
        }
    }
}

impl Builder<'_> {
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
            _ => Err(self.unfit("a `torus-spline` requires either `points` or `angles`")),
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
            "directions require either `tangents` or `rates`, not both"
        } else if matches!(spec.winding, Some(WindingSpec::Total(_))) && !spec.closed {
            "a single pair of turns requires a closed curve: set `closed`, or use a list of pairs, one for each step"
        } else if spec.angles.is_some() && spec.tolerance.is_some() {
            "`tolerance` requires `points`: angles are always on the torus"
        } else if two_types && !(spec.closed && is_directed) {
            "the method `two-types` requires closed curves with a direction at every point: set `closed`, and `tangents` or `rates`"
        } else if two_types && (spec.knots.is_some() || spec.winding.is_some() || spec.loops) {
            "the method `two-types` takes the shortest path with the knots 0, 1, 2, …: remove `knots`, `winding` and `loops`"
        } else {
            return Ok(());
        };
        Err(self.unfit(message))
    }
}

pub(in crate::document) fn in_torus_spline(spec: &TorusSplineSpec, at: &Contour<'_>) -> Vec<Idle> {
    let none_repeated = || merge_repeated(&mut at.list.clone(), spec.closed).kept.len() == at.kept.len();
    found(&[("loops", spec.loops && none_repeated(), "no point coincides with its neighbor")])
}

/// One contour of a spline.
pub(in crate::document) fn spline(spec: &TorusSplineSpec, torus: &Torus, at: &Contour<'_>) -> Made {
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
        return Err(NumberError::CountDiffers { what: I::Tangent, given: given.len(), needed }.into());
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windings_are_one_pair_or_a_list_of_pairs() {
        let parse = |text: &str| serde_json::from_str::<WindingSpec>(text).map_err(|e| e.to_string());
        assert_eq!(parse("[1,-2]"), Ok(WindingSpec::Total([1, -2])));
        assert_eq!(parse("[[1,-2],[0,3]]"), Ok(WindingSpec::Each(vec![[1, -2], [0, 3]])));
        for (text, message) in [
            ("[1]", "`winding` is a pair of turns"),
            ("[1,2,3]", "`winding` is a pair of turns"),
            ("[1.5,2]", "expected a whole number of turns"),
            ("[3000000000,2]", "too many turns"),
            ("[[1,2,3]]", "trailing characters"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.contains(message), "{text}: {error}");
        }
    }
}
