//! Curves on a torus, field by field.

use std::fmt;

use cyclide::{CircleFamily, TorusMap};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};

use super::TypeWord;
use super::comment::Comment;
use super::torus_numbers::{AnglePairs, FreeOr, RatePairs};
use crate::document::angle::Angle;
use crate::document::coordinates::{Coordinates, PointSource};
use crate::document::locate::Step;

/// A smooth curve on a torus through points near it, or through places given by two angles: rational quartics that lie exactly on the
/// torus, C1 in their knots. There always is one: where directions turn back it makes a detour.
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
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The torus that it lies on: here, or the name of a `cyclide` that is one (`c` = 0) or of a `transform` of one that moves, turns, scales or mirrors it.
    pub torus: TorusSource,
    /// Points on or near the torus. Each is moved to the nearest point of the torus.
    pub points: Option<PointSource>,
    /// Longitude and meridian angle of each point.
    pub angles: Option<AnglePairs>,
    /// Distance within which points must be near the torus. Default: a millionth of its major radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
    /// Velocities in space, one for each point, by the knots: their length counts. What they have across the torus is left out;
    /// `"free"` leaves a point its own.
    pub tangents: Option<Vec<FreeOr<Coordinates>>>,
    /// Velocities as rates of longitude and meridian angle, one for each point, by the knots; `"free"` leaves a
    /// point its own.
    pub rates: Option<RatePairs>,
    /// The parameter at each point, increasing, and of a closed curve at its end. Default: 0, 1, 2, ….
    pub knots: Option<Vec<f64>>,
    /// The last point joins the first.
    #[serde(default)]
    pub closed: bool,
    /// Turns round the axis and round the tube of a closed curve; or a list of turns added to the shortest way, one pair for each
    /// step. Default: the shortest way from point to point.
    pub winding: Option<WindingSpec>,
    /// Equal neighbouring points get a loop between them; else they are one point.
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
/// let cyclide_io::ObjectSpec::TorusSpline(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// assert_eq!(spec.method, cyclide_io::TorusMethod::General);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TorusMethod {
    /// By pieces of one type between two points where that will do, else by more. It always succeeds.
    #[default]
    General,
    /// By two pieces of two types from each point to the next, so that directions may be along parallels and meridians in turn: closed,
    /// with a direction at every point. Not all data have such a curve.
    TwoTypes,
}

/// A torus knot: the closed curve that runs evenly round the axis and round the tube of a torus.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [2, 3]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].item.curves()[0].as_curve().is_closed());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct TorusKnotSpec {
    /// The word `torus-knot`.
    #[schemars(with = "String", extend("const" = "torus-knot"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The torus that it lies on: here, or the name of a `cyclide` that is one (`c` = 0) or of a `transform` of one that moves, turns, scales or mirrors it.
    pub torus: TorusSource,
    /// Turns round the axis and turns round the tube, without a common divisor; negative ones run the other way.
    pub turns: [i32; 2],
    /// Longitude and meridian angle of its start. Default `[0, 0]`.
    pub start: Option<[Angle; 2]>,
}

/// A closed quartic of a torus of one of its six types: it runs once round two families of circles, along both at once.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "torus-quartic", "torus": {"major_radius": 40, "minor_radius": 15}, "families": ["parallel", "meridian"], "ratio": 3}}}"#.parse()?;
/// let built = document.build()?;
/// let curve = built[0].item.curves()[0].as_curve();
/// // From the outer side of the tube, and back to it.
/// assert!(curve.is_closed() && (curve.point(0.0).to_vec().length() - 55.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TorusQuarticSpec {
    /// The word `torus-quartic`.
    #[schemars(with = "String", extend("const" = "torus-quartic"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The torus that it lies on: here, or the name of a `cyclide` that is one (`c` = 0) or of a `transform` of one that moves, turns, scales or mirrors it.
    pub torus: TorusSource,
    /// Two different families of circles: the type.
    pub families: [FamilySpec; 2],
    /// How fast it runs along the second family at its start, for its speed along the first; negative ones run back. From 1/32 to 32.
    pub ratio: f64,
    /// Longitude and meridian angle of its start. Default `[0, 0]`.
    pub start: Option<[Angle; 2]>,
}

/// A circle of a torus through a point of it.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "torus-circle", "torus": {"major_radius": 40, "minor_radius": 15}, "at": [0, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// // Villarceau circles are as large as the middle of the tube.
/// let length = cyclide::length(built[0].item.curves()[0].as_curve());
/// assert!((length - 80.0 * std::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["through"], "properties": { "at": false } },
    { "required": ["at"], "properties": { "through": false, "tolerance": false } }
]))]
#[non_exhaustive]
pub struct TorusCircleSpec {
    /// The word `torus-circle`.
    #[schemars(with = "String", extend("const" = "torus-circle"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The torus that it lies on: here, or the name of a `cyclide` that is one (`c` = 0) or of a `transform` of one that moves, turns, scales or mirrors it.
    pub torus: TorusSource,
    /// Which of the four circles through the point.
    #[serde(default)]
    pub family: FamilySpec,
    /// The point, on or near the torus.
    pub through: Option<Coordinates>,
    /// Longitude and meridian angle of the point.
    pub at: Option<[Angle; 2]>,
    /// Distance within which the point must be near the torus. Default: a millionth of its major radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// A family of circles on a torus.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "torus-circle", "torus": {"major_radius": 40, "minor_radius": 15}, "family": "meridian", "at": [0, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// let length = cyclide::length(built[0].item.curves()[0].as_curve());
/// assert!((length - 30.0 * std::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum FamilySpec {
    /// Villarceau circles: longitude and meridian angle rise together.
    #[default]
    Villarceau,
    /// Villarceau circles along which the meridian angle falls as the longitude rises.
    MirrorVillarceau,
    /// Round the axis.
    Parallel,
    /// Round the tube.
    Meridian,
}

impl From<FamilySpec> for CircleFamily {
    fn from(family: FamilySpec) -> Self {
        match family {
            FamilySpec::Villarceau => Self::Villarceau,
            FamilySpec::MirrorVillarceau => Self::MirrorVillarceau,
            FamilySpec::Parallel => Self::Parallel,
            FamilySpec::Meridian => Self::Meridian,
        }
    }
}

/// A curve of a torus laid flat: the torus is cut along a parallel and a meridian and unrolled to a rectangle in the plane z = 0. Lines
/// break where the curve crosses the cuts.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [1, 1]}, "u": {"type": "unrolled", "of": "k"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[1].item.curves()[0].as_curve().point(0.4).z == 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct UnrolledSpec {
    /// The word `unrolled`.
    #[schemars(with = "String", extend("const" = "unrolled"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the `torus-spline`, `torus-knot`, `torus-quartic` or `torus-circle`, which may be construction geometry.
    pub of: String,
    /// How the torus is laid flat.
    #[serde(default)]
    pub map: TorusMap,
    /// Longitude and meridian angle of the cuts. Default: the longitude 0, and the inner side (half a turn).
    pub seam: Option<[Angle; 2]>,
    /// Distance within which arcs stand for the curve in the plane. Default: a hundred-thousandth of the width of the plane.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
    /// Adds the rectangle of the unrolled torus.
    #[serde(default)]
    pub border: bool,
}

/// A solid along a curve of a torus with a rectangular section: a raised seam to be fused to the torus, a sunk one to be cut from it.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [1, 1]}, "s": {"type": "torus-seam", "of": "k", "width": 3, "height": [-1, 1], "tolerance": 0.1}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[1].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct TorusSeamSpec {
    /// The word `torus-seam`.
    #[schemars(with = "String", extend("const" = "torus-seam"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the `torus-spline`, `torus-knot`, `torus-quartic` or `torus-circle`, which may be construction geometry.
    pub of: String,
    /// Width across the curve.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub width: f64,
    /// From where to where it reaches, along the outward normal of the torus: negative below the surface.
    pub height: [f64; 2],
    /// Distance within which the edges follow the curve. Default: a thousandth of the width.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// A ring torus: a tube about a circle.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "torus-circle", "torus": {"major_radius": 3, "minor_radius": 1, "center": [0, 0, 5]}, "family": "parallel", "at": [0, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// let point = built[0].item.curves()[0].as_curve().point(0.0);
/// assert!((point.x - 4.0).abs() < 1e-12 && (point.z - 5.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Torus")]
#[non_exhaustive]
pub struct TorusSpec {
    /// Radius of the circle that the middle of the tube follows.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub major_radius: f64,
    /// Radius of the tube, less than that.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub minor_radius: f64,
    /// Where the centre is. Default: the origin.
    pub center: Option<Coordinates>,
    /// Axis of the torus, of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// Direction of the longitude 0, perpendicular to `axis`, of any length. Default `[1, 0, 0]`, or for another axis the direction nearest
    /// to it.
    pub x_direction: Option<Coordinates>,
}

/// The torus of a curve.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"ring": {"type": "cyclide", "a": 40, "mu": 15}, "k": {"type": "torus-knot", "torus": "ring", "turns": [2, 3]}}}"#.parse()?;
/// let cyclide_io::ObjectSpec::TorusKnot(spec) = &document.objects[1].1 else { unreachable!("by its type") };
/// assert_eq!(spec.torus, cyclide_io::TorusSource::Named("ring".to_owned()));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "TorusSource")]
pub enum TorusSource {
    /// Its radii and its place.
    Here(TorusSpec),
    /// Name of a `cyclide` with `c` = 0, or of a `transform` of one that is a similarity.
    Named(String),
}

impl TorusSource {
    /// The name of an object, if it is one, with its path.
    pub(in crate::document) fn reference(&self) -> Vec<(Vec<Step>, &str)> {
        self.name().map(|name| (vec![Step::from("torus")], name)).into_iter().collect()
    }

    /// The name of the object, if it is one.
    pub(in crate::document) fn name(&self) -> Option<&str> {
        match self {
            Self::Here(_) => None,
            Self::Named(name) => Some(name),
        }
    }
}

impl<'de> Deserialize<'de> for TorusSource {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct TorusVisitor;
        impl<'de> Visitor<'de> for TorusVisitor {
            type Value = TorusSource;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(
                    "`{\"major_radius\": …, \"minor_radius\": …}` or the name of a `cyclide` or of its `transform`",
                )
            }
            fn visit_str<E>(self, name: &str) -> Result<TorusSource, E> {
                Ok(TorusSource::Named(name.to_owned()))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<TorusSource, A::Error> {
                TorusSpec::deserialize(MapAccessDeserializer::new(map)).map(TorusSource::Here)
            }
        }
        deserializer.deserialize_any(TorusVisitor)
    }
}

/// The turns of a curve on a torus.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "torus-spline", "torus": {"major_radius": 40, "minor_radius": 15}, "angles": [[0, 0], [1, 1], [3, 0]], "closed": true, "winding": [1, 2]}}}"#.parse()?;
/// let cyclide_io::ObjectSpec::TorusSpline(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// assert_eq!(spec.winding, Some(cyclide_io::WindingSpec::Total([1, 2])));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, JsonSchema)]
#[schemars(untagged, rename = "Winding")]
#[non_exhaustive]
pub enum WindingSpec {
    /// Round the axis and round the tube, in all.
    Total([i32; 2]),
    /// Added to the shortest way, for each step.
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
                turns.map(Cell::Turns).ok_or_else(|| E::custom("more turns than anybody winds"))
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
            ("[3000000000,2]", "more turns"),
            ("[[1,2,3]]", "trailing characters"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.contains(message), "{text}: {error}");
        }
    }
}
