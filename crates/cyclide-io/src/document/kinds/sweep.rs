//! A plane section moved along a path.

use cyclide::{
    ShortNumber,
    construct::{Sweep, SweepFrame, SweepOptions},
    error::{CurveError, NumberError, PipeError, ProfileError, TubeError},
    model::{CurveObject, SurfaceObject},
    topology::EdgeCurve,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::idle::NO_EFFECT;
use crate::document::objects::kind::{Kind, Reference, Shape};
use crate::error::{Error, Result};

/// Part of the size of a section that the tolerance is if none is given.
const TOLERANCE: f64 = 1e-3;

/// Turns about a closed path that are this near to whole ones are these, radians.
const WHOLE: f64 = 1e-6;

/// A plane section moved along a path. Closed contours make a solid, with miters at corners between segments; contours
/// inside others are holes, and open contours make surfaces. The sweep is exact along arcs and segments where the
/// section does not rotate about the path.
///
/// Corners between segments are mitered. A corner beside an arc is rejected (`corner-not-mitred`), and so are segments
/// too short for their miters (`mitre-does-not-fit`) and bends narrower than the section (`tube-folds`).
///
/// If rectangles around the section overlap in distant parts of the path, the warning `sweep-meets-itself` is issued.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "way": {"type": "polyline", "points": [[0, 0], [50, 0], [50, 30]], "construction": true},
///     "bar": {"type": "polyline", "points": [[-2, -3], [2, -3], [2, 3], [-2, 3]], "closed": true, "construction": true},
///     "rail": {"type": "sweep", "of": "way", "section": "bar"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[2].bodies[0].outer.volume() - 24.0 * 80.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct SweepSpec {
    /// The word `sweep`.
    #[schemars(with = "String", extend("const" = "sweep"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the path, which may be construction geometry. Arcs within half the `tolerance` replace a path of another
    /// kind.
    pub of: String,
    /// Name of the section, a curve in the plane z = 0, which may be construction geometry (`section-not-plane`,
    /// `section-meets-itself`). Its origin follows the path, x and y stay across it, and z points along it.
    pub section: String,
    /// The section is drawn in space, across the path at its start, and is used where it lies. Default `false`.
    #[serde(default)]
    pub in_place: bool,
    /// How the section is oriented about the path.
    #[serde(default)]
    pub frame: SweepFrame,
    /// Direction of the y axis of the section at the start; with `"frame": "up"` everywhere, as far as the path allows.
    /// Default `[0, 0, 1]`; if the path starts along it, x of the section is x of space.
    pub up: Option<Coordinates>,
    /// Rotation about the path in proportion to its length, right-handed; on a closed path whole turns. If a closed
    /// path in space returns the section rotated, the missing rotation is added as a twist. Default 0.
    pub twist: Option<Angle>,
    /// How closed sections end on an open path.
    #[serde(default)]
    pub ends: SweepEnds,
    /// Largest distance of arcs from a path of another kind, and of points from the law of rotation. Default: a
    /// thousandth of the size of the section.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// How what a closed curve runs over ends.
///
/// ```
/// use cyclide_io::document::kinds::SweepEnds;
/// assert_eq!(SweepEnds::default(), SweepEnds::Flat);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum SweepEnds {
    /// Planar faces: a solid.
    #[default]
    Flat,
    /// No end faces: the surface only.
    Open,
}

impl Kind for SweepSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.sweep(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        vec![(vec![Step::from("of")], &self.of), (vec![Step::from("section")], &self.section)]
    }
}

impl Builder<'_> {
    /// What a section makes along each contour of a path.
    pub(in crate::document) fn sweep(&mut self, spec: &SweepSpec) -> Result<Vec<SurfaceObject>> {
        let paths = self.sources[0].item.curves().to_vec();
        if paths.is_empty() {
            return Err(self.wrong_source("a path must be a curve"));
        }
        let contours = self.sources[1].item.curves().to_vec();
        if contours.is_empty() {
            let message = format!("`{}` has no curve: a section must be a curve", spec.section);
            return Err(Error::Input(self.diagnostic(["section".into()], &message)));
        }
        let section = contours.iter().map(CurveObject::exact_pieces).collect::<cyclide::Result<Vec<_>>>();
        let section = section.map_err(|e| self.refused_at(["section".into()], &e))?;
        let closed = paths.iter().any(|path| path.as_curve().is_closed());
        let twist = spec.twist.map_or(0.0, Angle::radians);
        let turns = twist / std::f64::consts::TAU;
        if closed && (turns - turns.round()).abs() > WHOLE {
            let message =
                format!("the path is closed, but the section returns rotated by {turns} of a turn: use whole turns");
            return Err(Error::Input(self.diagnostic(["twist".into()], &message)));
        }
        let tolerance = spec.tolerance.unwrap_or_else(|| TOLERANCE * size(&section));
        let defaults = SweepOptions::default();
        let options = SweepOptions {
            frame: spec.frame,
            up: spec.up.map_or(defaults.up, Coordinates::vector),
            twist,
            capped: spec.ends == SweepEnds::Flat,
            tolerance,
        };
        let (mut made, mut bound) = (Vec::new(), 0.0_f64);
        for (contour, path) in paths.iter().enumerate() {
            let exact = path.is_of_arcs();
            let arcs = path.spine(Some(if exact { tolerance } else { 0.5 * tolerance }));
            let arcs = arcs.map_err(|e| self.refused_at(["of".into()], &e))?;
            let placed = match spec.in_place {
                true => Sweep::section_in_place(&section, &arcs, &options),
                false => Ok(section.clone()),
            };
            let options = SweepOptions { tolerance: if exact { tolerance } else { 0.5 * tolerance }, ..options };
            let sweep = placed.and_then(|placed| Sweep::new(&placed, &arcs, &options));
            let sweep = sweep.map_err(|e| self.refused_sweep(spec, &e))?;
            if let Some((lengths, point)) = sweep.meeting() {
                let ([from, to], [x, y, z]) = (lengths.map(ShortNumber), point.to_array().map(ShortNumber));
                let message = format!(
                    "the sweep may intersect itself near ({x}, {y}, {z}), at {from} and {to} along the path: volume and area count the intersection twice; use a smaller section, or increase the distance between these parts of the path"
                );
                self.remark("sweep-meets-itself", (paths.len() > 1).then_some(contour), None, None, message);
            }
            bound = bound.max(sweep.bound() + if exact { 0.0 } else { 0.5 * tolerance });
            made.extend(sweep.into_bodies().into_iter().map(SurfaceObject::Body));
        }
        if bound > 0.0 {
            self.bound = Some(tolerance);
        }
        let open = section.iter().all(|(_, closed)| !closed);
        if spec.ends == SweepEnds::Open && (closed || open) {
            let why = if closed { "a closed path has no ends" } else { "an open section makes a surface" };
            let place = self.place_of([Step::from("ends")]);
            self.remark(NO_EFFECT, None, None, place, format!("`ends` has no effect: {why}"));
        }
        Ok(made)
    }

    /// What the kernel refused, in the words of sections.
    fn refused_sweep(&self, spec: &SweepSpec, error: &cyclide::Error) -> Error {
        use cyclide::Error as E;
        let (field, words) = match error {
            E::Profile(ProfileError::SectionNotPlane { .. }) if spec.in_place => (
                "section",
                format!(
                    "{error}: with `in_place` the section must be perpendicular to the path at its start; rotate it there, or draw it in the plane z = 0 without `in_place`"
                ),
            ),
            E::Profile(ProfileError::SectionNotPlane { .. }) => (
                "section",
                format!(
                    "{error}: a section is drawn in the plane z = 0, with its origin on the path; with `\"in_place\": true`, in its position at the start of the path"
                ),
            ),
            E::Profile(ProfileError::SectionMeetsItself { .. }) => ("section", error.to_string()),
            E::Tube(TubeError::Folds { piece, .. }) => (
                "of",
                format!(
                    "the bend in piece {piece} of the path is tighter than the extent of the section on its inner side: use wider bends, or move or rotate the section"
                ),
            ),
            E::Pipe(PipeError::MitreDoesNotFit { piece, needed, length }) => (
                "of",
                format!(
                    "segment {piece} of the path has the length {length}, but the mitres at its ends require more than {needed}: use a smaller section or longer segments"
                ),
            ),
            E::Pipe(PipeError::CornerNotMitred { joint, turn, limit, .. }) => (
                "of",
                format!(
                    "the path has a corner of {turn} rad before piece {joint}: only corners between segments can be mitred, up to {limit} rad; round it (polyline with radius)"
                ),
            ),
            E::Curve(CurveError::NoFrame { .. }) => {
                ("frame", format!("{error}; use the frame `rotation-minimizing`, or another `up`"))
            }
            E::Number(NumberError::ParameterOutOfRange { .. } | NumberError::TooManyPieces { .. }) => {
                ("tolerance", error.to_string())
            }
            _ => ("section", error.to_string()),
        };
        self.refused_in_words([field.into()], error.reason(), words)
    }
}

/// The largest distance of a section from its first point.
fn size(section: &[(Vec<EdgeCurve>, bool)]) -> f64 {
    let places =
        section.iter().flat_map(|(curves, _)| curves).flat_map(|c| [0.0, 0.25, 0.5, 0.75, 1.0].map(|x| c.point(x)));
    let mut places = places.peekable();
    let Some(first) = places.peek().copied() else { return 0.0 };
    places.map(|p| p.distance(first)).fold(0.0, f64::max)
}
