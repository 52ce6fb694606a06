//! The report on curves of a torus, and on what becomes of them in the plane.

use std::collections::BTreeMap;
use std::fmt;

use cyclide::{
    construct::TorusMap,
    curve::ParamCurve as _,
    model::{CurveObject, Exactness, Lower as _},
    surface::{CircleFamily, QuarticType, SegmentMethod, TorusSpline},
};
use serde::Serialize;

use super::figures::{Line, plural, short};
use crate::document::BuiltObject;
use crate::document::UnrolledPlane;

/// Samples of the distance from the torus on each span of the rational form.
const SAMPLES: usize = 16;

/// How splines run on their torus, over all contours.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [2, 3]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// let torus = found.torus.expect("it lies on one");
/// assert!(torus.winding == [Some([2, 3])] && torus.off < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TorusReport {
    /// Radius of the center circle of the tube.
    pub major_radius: f64,
    /// Radius of the tube.
    pub minor_radius: f64,
    /// Turns around the axis and around the tube of each closed contour; `null` for an open one, and omitted if all are open.
    #[serde(skip_serializing_if = "all_open")]
    pub winding: Vec<Option<[i64; 2]>>,
    /// Largest distance of the rational curves in files from the torus: rounding.
    pub off: f64,
    /// Largest distance by which points were moved onto the torus.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moved: Option<f64>,
    /// The number of pieces of each type, by the families of circles between which they run.
    pub types: BTreeMap<String, usize>,
    /// How the segments between points were joined.
    pub segments: SegmentCounts,
    /// Joints at which the type changes.
    pub type_changes: usize,
    /// Largest jump of the velocity at a joint, by the knots, relative to the velocity: rounding.
    pub velocity_jump: f64,
    /// The least quality of a segment: near 0 the curve nearly stops, 1 is a circular arc at constant speed.
    pub quality: f64,
}

/// How segments between points were joined.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "torus-spline", "torus": {"major_radius": 40, "minor_radius": 15}, "angles": [[0, 0], [1, 1], [2, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// let segments = found.torus.expect("it lies on one").segments;
/// // Two steps between three points.
/// assert_eq!(segments.direct + segments.halved + segments.detour + segments.two_types, 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[non_exhaustive]
pub struct SegmentCounts {
    /// By pieces of one type.
    pub direct: usize,
    /// Halved until each part had a type.
    pub halved: usize,
    /// By a path of arcs and lines in the parameter plane of the torus.
    pub detour: usize,
    /// By two pieces of two types.
    pub two_types: usize,
}

/// Curves that were unrolled with their torus.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [1, 1]}, "u": {"type": "unrolled", "of": "k"}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[1], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// let unrolled = found.unrolled.expect("it is laid flat");
/// assert!(unrolled.map == "belt" && unrolled.cuts == 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct UnrolledReport {
    /// The map: `belt` or `conformal`.
    pub map: &'static str,
    /// Width and height of the plane of the whole torus.
    pub size: [f64; 2],
    /// How often the curve crosses the cuts of the torus.
    pub cuts: usize,
    /// The least and the largest factor by which lengths around the axis are multiplied, along the curve. Around the tube the factor
    /// is 1 on a belt, and the same as around the axis in the conformal map.
    pub stretch: [f64; 2],
    /// Length of the curve on the torus.
    pub length_on_torus: f64,
    /// Length of all its lines in the plane.
    pub length_in_plane: f64,
    /// Distance within which arcs approximate the curve in the plane.
    pub tolerance: f64,
}

fn all_open(winding: &[Option<[i64; 2]>]) -> bool {
    winding.iter().all(Option::is_none)
}

impl TorusReport {
    /// Measures an object whose curves are splines on one torus.
    pub(super) fn new(built: &BuiltObject) -> Option<Self> {
        let splines: Vec<&TorusSpline> = built.item.curves().iter().filter_map(on_torus).collect();
        let torus = splines.first()?.torus();
        let moved = built.contours.iter().filter_map(|facts| facts.moved).reduce(f64::max);
        let mut report = Self {
            major_radius: torus.major_radius(),
            minor_radius: torus.minor_radius(),
            winding: splines.iter().map(|spline| spline.winding()).collect(),
            off: 0.0,
            moved,
            types: BTreeMap::new(),
            segments: SegmentCounts::default(),
            type_changes: 0,
            velocity_jump: 0.0,
            quality: f64::INFINITY,
        };
        splines.into_iter().for_each(|spline| report.add(spline));
        Some(report)
    }

    fn add(&mut self, spline: &TorusSpline) {
        for piece in spline.pieces() {
            *self.types.entry(type_word(piece.quartic_type())).or_default() += 1;
        }
        for segment in spline.segments() {
            *match segment.method {
                SegmentMethod::Direct => &mut self.segments.direct,
                SegmentMethod::Halved => &mut self.segments.halved,
                SegmentMethod::Detour => &mut self.segments.detour,
                SegmentMethod::TwoTypes => &mut self.segments.two_types,
            } += 1;
            self.quality = self.quality.min(segment.quality);
        }
        for joint in spline.junctions() {
            self.type_changes += usize::from(joint.types[0] != joint.types[1]);
            self.velocity_jump = self.velocity_jump.max(joint.jump.length() / joint.velocity.length());
        }
        self.off = self.off.max(off_torus(spline).unwrap_or(f64::NAN));
    }

    /// The lines of the text.
    pub(super) fn lines(&self, units: &str, line: Line<'_>) -> fmt::Result {
        let (major, minor, off) = (short(self.major_radius), short(self.minor_radius), short(self.off));
        let mut text = format!("radii {major} {units} and {minor} {units}, deviation of the curve {off} {units}");
        if let Some(moved) = self.moved.filter(|moved| *moved > 0.0) {
            text += &format!(", of its points {} {units}", short(moved));
        }
        line("torus", text)?;
        if let [Some([axis, tube])] = self.winding[..] {
            line("winding", format!("{} around the axis, {} around the tube", turns(axis), turns(tube)))?;
        }
        let types: Vec<String> = self.types.iter().map(|(word, count)| format!("{count} {word}")).collect();
        let changes = plural(self.type_changes, "change");
        line("types", format!("{}; {changes} of type, velocity jump {}", types.join(", "), short(self.velocity_jump)))?;
        line("segments", format!("{}; least quality {}", self.segments.text(), short(self.quality)))
    }
}

impl SegmentCounts {
    fn text(self) -> String {
        let all = [
            (self.direct, "direct"),
            (self.halved, "halved"),
            (self.detour, "by detours"),
            (self.two_types, "of two types"),
        ];
        let some = all.into_iter().filter(|(count, _)| *count > 0);
        some.map(|(count, how)| format!("{count} {how}")).collect::<Vec<_>>().join(", ")
    }
}

impl UnrolledReport {
    /// The lines of the text.
    pub(super) fn lines(&self, units: &str, line: Line<'_>) -> fmt::Result {
        let [width, height] = self.size.map(short);
        let (cuts, within) = (plural(self.cuts, "cut"), short(self.tolerance));
        line("unrolled", format!("{} of {width} by {height} {units}, {cuts}, within {within} {units}", self.map))?;
        let [least, most] = self.stretch.map(short);
        let (on_torus, in_plane) = (short(self.length_on_torus), short(self.length_in_plane));
        let lengths = format!("length {on_torus} {units} on the torus, {in_plane} {units} in the plane");
        line("stretch", format!("{least} to {most} around the axis; {lengths}"))
    }
}

impl From<&UnrolledPlane> for UnrolledReport {
    fn from(plane: &UnrolledPlane) -> Self {
        Self {
            map: match plane.map {
                TorusMap::Belt => "belt",
                TorusMap::Conformal => "conformal",
            },
            size: plane.size,
            cuts: plane.cuts,
            stretch: plane.stretch,
            length_on_torus: plane.lengths[0],
            length_in_plane: plane.lengths[1],
            tolerance: plane.tolerance,
        }
    }
}

fn turns(count: i64) -> String {
    format!("{count} turn{}", if count.abs() == 1 { "" } else { "s" })
}

fn on_torus(curve: &CurveObject) -> Option<&TorusSpline> {
    match curve {
        CurveObject::TorusSpline(spline) => Some(spline),
        _ => None,
    }
}

/// How far the rational form of a spline is from its torus, which the spline itself is on by its construction.
fn off_torus(spline: &TorusSpline) -> Option<f64> {
    let (chain, exactness) = spline.to_chain(1.0).ok()?;
    let at =
        |piece: usize, k: usize| spline.torus().distance(chain.piece_point(piece, k as f64 / SAMPLES as f64)).abs();
    let all = (0..chain.piece_count()).flat_map(|piece| (0..SAMPLES).map(move |k| (piece, k)));
    let largest = all.map(|(piece, k)| at(piece, k)).fold(0.0, f64::max);
    (exactness == Exactness::Exact).then_some(largest)
}

/// The two families of circles of a type.
fn type_word(kind: QuarticType) -> String {
    let word = |family| match family {
        CircleFamily::Parallel => "parallel",
        CircleFamily::Villarceau => "villarceau",
        CircleFamily::MirrorVillarceau => "mirror-villarceau",
        CircleFamily::Meridian => "meridian",
    };
    kind.families().map(word).join("+")
}
