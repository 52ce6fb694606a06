//! The image of an object under a chain of maps.

pub(in crate::document) mod steps;

use std::ops::Range;

use cyclide::{
    Point3, Quat, ShortNumber, Vec3,
    conformal::{Conformal as _, HPoint, Mobius},
    construct::TeeBlendFacts,
    curve::{bounds, closest_point},
    error::{ErrorItem, NumberError, PointError, VolumeError},
    model::{CurveObject, SurfaceObject},
    surface::Torus,
    topology::Body,
    volume::CyclideVolume,
};
use schemars::JsonSchema;
use serde::Deserialize;
use steps::map_of;

use crate::document::angle::Angle;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::facts::{BlendFacts, Facts, Unmapped};
use crate::document::objects::kind::{Kind, Reference, Shape, of};
use crate::document::objects::{Builder, BuiltObject};
use crate::error::Result;

pub use steps::*;

/// What other maps than similarities are for.
const OF_CURVES: &str = "circles and curves on tori can only be moved, rotated, scaled and mirrored; arcs, chains of arcs, Möbius splines, QB and NURBS curves also support inversions";

const OF_CIRCLE_SPLINES: &str = "fair and circle splines can only be moved, rotated, scaled and mirrored; a `moebius-spline` or an `arc-spline` through the same points supports exact inversions";

/// What a cut from a place of a circle to the same place would be.
const WHOLE_CIRCLE: &str =
    "the cut would keep the full circle, but an arc must be shorter: remove the cut, or use two cuts";

/// Smallest distance of a curve from the point that goes to infinity, relative to the coordinates of both: they are rounded by
/// 1e-16 of them, and the image of a point next to it by that part of a distance that is so small.
const SMALLEST_DISTANCE: f64 = 5e-11;

/// The image of another object under a chain of maps. Curves can also be reversed and cut between the maps.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": [{"scale": {"factor": 3}}, {"translation": [1, 0, 0]}]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[1].item.curves()[0].as_curve()) - 12.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct TransformSpec {
    /// The word `transform`.
    #[schemars(with = "String", extend("const" = "transform"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the object.
    pub of: String,
    /// The maps in the order in which they are applied, and for curves reversals and cuts.
    #[schemars(length(min = 1))]
    pub steps: Vec<StepSpec>,
}

impl Unmapped {
    /// With a run of maps after it, from these curves if there is none before, or with a run that is the same before and after a map: curves run
    /// backwards, or kept from their start to their end. `None` of other cuts, whose places a map moves, and where a step is no map.
    fn of_run(before: Option<Self>, curves: &[CurveObject], run: &[StepSpec]) -> Option<Self> {
        if !run.iter().all(is_map) {
            let Self { curves, map, inversions } = before?;
            let curves =
                curves.iter().map(|curve| run.iter().try_fold(curve.clone(), unmoved)).collect::<Option<_>>()?;
            return Some(Self { curves, map, inversions });
        }
        let maps: Vec<Mobius> = run.iter().map(|step| map_of(step).ok()).collect::<Option<_>>()?;
        let start = || Self { curves: curves.to_vec(), map: Mobius::IDENTITY, inversions: 0 };
        let Self { curves, map, inversions } = before.unwrap_or_else(start);
        let inversions = inversions + maps.iter().filter(|map| !map.is_similarity()).count();
        Some(Self { curves, map: maps.iter().fold(map, |before, map| map.after(&before)), inversions })
    }
}

impl Kind for TransformSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.image(self)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn torus(&self, at: &Builder<'_>, name: &str) -> Option<Result<Torus>> {
        Some(at.image_of_torus(self, name))
    }

    fn is_image(&self) -> bool {
        true
    }

    fn skin(&self, source: Option<&BuiltObject>) -> Vec<SurfaceObject> {
        source.map_or_else(Vec::new, |source| source.provenance.skin.clone())
    }

    fn has_panels(&self, source: Option<&BuiltObject>) -> bool {
        source.is_some_and(|source| source.provenance.panels)
    }

    fn remark_on(&self, at: &mut Builder<'_>, _: &Shape, _: &[Body]) {
        at.warn_of_many_turns(self);
    }
}

impl Builder<'_> {
    /// The image of the source, which is of its kind.
    pub(in crate::document) fn image(&mut self, spec: &TransformSpec) -> Result<Shape> {
        let curves = self.mapped_curves(spec)?;
        for (contour, curve) in curves.iter().enumerate() {
            self.check_place_of(curve, contour)?;
        }
        let surfaces = self.mapped_surfaces(spec)?;
        if let Some(source) = self.sources.first() {
            self.names.clone_from(&source.provenance.names);
            let blends = self.mapped_blends(spec);
            if !blends.is_empty() {
                self.facts = Facts::Blends(BlendFacts { blends, centers: None });
            }
        }
        let volumes = self.mapped_volumes(spec)?;
        self.warn_of_folded_blocks(&volumes, "of");
        let places = self.places_of_source(&volumes)?;
        Ok(if !volumes.is_empty() {
            Shape::Blocks(volumes, places)
        } else if surfaces.is_empty() {
            Shape::plain(curves)
        } else {
            Shape::Surfaces(surfaces)
        })
    }

    /// The image of a torus under maps that keep it one.
    fn image_of_torus(&self, spec: &TransformSpec, name: &str) -> Result<Torus> {
        let refused = |e: cyclide::Error| self.refused_at([Step::from("torus")], &e);
        let mut torus = self.named_torus(&spec.of)?;
        for (index, step) in spec.steps.iter().enumerate() {
            let map = map_of(step).map_err(refused)?;
            if !map.is_similarity() {
                return Err(self.no_torus(format!(
                    "step {index} of the `transform` `{name}` is not a similarity: a torus remains one only if it is moved, rotated, scaled or mirrored"
                )));
            }
            torus = torus.similar(&map).map_err(refused)?;
        }
        Ok(torus)
    }

    /// The images of curves.
    pub(in crate::document) fn mapped_curves(&mut self, spec: &TransformSpec) -> Result<Vec<CurveObject>> {
        let mut before = self.sources.first().and_then(|source| source.unmapped.clone());
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves());
        let image = |curve: &CurveObject, step: &StepSpec| match step {
            StepSpec::Reverse => Ok(curve.reversed()),
            StepSpec::Cut(CutSpec::Parameters([from, to])) => curve.restricted(*from, *to),
            StepSpec::Cut(CutSpec::Stations([from, to])) => curve.restricted_to_stations(*from, *to),
            _ => image_of_curve(curve, &map_of(step)?),
        };
        let of_circles = curves.iter().any(|curve| matches!(curve, CurveObject::CircleSpline(_)));
        let kept = if of_circles { OF_CIRCLE_SPLINES } else { OF_CURVES };
        let mut curves = curves.to_vec();
        for run in runs(&spec.steps) {
            let steps = &spec.steps[run.clone()];
            before = Unmapped::of_run(before, &curves, steps);
            // Each map that is no similarity doubles the degree of a rational curve, all of them together double it once, or not at all.
            let at_once = before.as_ref().filter(|before| before.inversions > 1 && steps.iter().all(is_map)).and_then(
                |Unmapped { curves, map, .. }| {
                    curves.iter().map(|curve| image_of_curve(curve, map)).collect::<cyclide::Result<Vec<_>>>().ok()
                },
            );
            curves = match at_once {
                Some(images) => images,
                None => self.mapped(spec, run, &curves, image, kept)?,
            };
        }
        // Of moved curves alone nothing is gained.
        self.unmapped = before.filter(|before| before.inversions > 0);
        Ok(curves)
    }

    /// The images of surfaces.
    pub(in crate::document) fn mapped_surfaces(&self, spec: &TransformSpec) -> Result<Vec<SurfaceObject>> {
        if self.sources.first().is_some_and(|source| source.item.motion().is_some()) {
            return Err(self.wrong_source("a motion is positioned by its poses, not by a `transform`"));
        }
        let surfaces = self.sources.first().map_or(&[][..], |source| source.item.surfaces());
        let kept = "surfaces with rational faces (tees, seams, profiles other than arcs) and surfaces over triangles can only be moved, rotated, scaled and mirrored; patches whose parameter lines are circles also support inversions";
        let of_curves = |step: &StepSpec| matches!(step, StepSpec::Reverse | StepSpec::Cut(_));
        if let Some(index) = spec.steps.iter().position(of_curves).filter(|_| !surfaces.is_empty()) {
            return Err(
                self.wrong_source_at([Step::from("steps"), Step::from(index)], "only curves can be reversed or cut")
            );
        }
        self.mapped(spec, 0..spec.steps.len(), surfaces, |surface, step| surface.transformed(&map_of(step)?), kept)
    }

    /// The blends of the source as they are in its image: radii and differences are as much larger as it is. How near they come to folding, where round its
    /// branch, and the pieces stay. None where a step is no similarity: balls of other radii touch there.
    pub(in crate::document) fn mapped_blends(&self, spec: &TransformSpec) -> Vec<TeeBlendFacts> {
        let factor = |step: &StepSpec| {
            let map = map_of(step).ok().filter(Mobius::is_similarity)?;
            map.push_forward(Point3::ORIGIN, Vec3::X).map(Vec3::length)
        };
        let factor: Option<f64> = spec.steps.iter().map(factor).product();
        let known = self.sources.first().and_then(|source| source.facts.blends());
        let blends = known.map_or(&[][..], |known| &known.blends);
        let scaled = |factor: f64| {
            let scaled = move |blend: &TeeBlendFacts| TeeBlendFacts {
                radii: blend.radii.map(|radius| radius * factor),
                deviation: blend.deviation * factor,
                ..*blend
            };
            blends.iter().map(scaled).collect()
        };
        factor.map_or_else(Vec::new, scaled)
    }

    /// Applies some of the steps one by one, so that a message can show the step at fault; `kept` says what other maps are for.
    pub(in crate::document) fn mapped<T: Clone>(
        &self,
        spec: &TransformSpec,
        steps: Range<usize>,
        objects: &[T],
        image: impl Fn(&T, &StepSpec) -> cyclide::Result<T>,
        kept: &str,
    ) -> Result<Vec<T>> {
        let mut objects = objects.to_vec();
        for index in steps {
            let step = &spec.steps[index];
            let several = objects.len() > 1;
            for (contour, object) in objects.iter_mut().enumerate() {
                *object = image(object, step).map_err(|e| {
                    let place = [Step::from("steps"), Step::from(index)];
                    match (step, &e) {
                        // Whichever of its spans was looked at first.
                        _ if e.reason() == "not-a-similarity" => {
                            self.refused_in_words(place, e.reason(), format!("the map is not a similarity: {kept}"))
                        }
                        (StepSpec::Cut(_), cyclide::Error::Number(NumberError::SweepOutOfRange { .. })) => {
                            self.refused_in_words(place, e.reason(), WHOLE_CIRCLE.to_owned())
                        }
                        (StepSpec::Cut(cut), cyclide::Error::Number(NumberError::ParameterOutOfRange { max, .. })) => {
                            // Contours differ in length.
                            let which = if several { format!("contour {contour}: ") } else { String::new() };
                            self.refused_in_words(place, e.reason(), which + &no_part(cut, *max))
                        }
                        (StepSpec::Inversion(_), cyclide::Error::Volume(VolumeError::ThroughInfinity { at })) => {
                            let which = if several { format!("block {contour}: ") } else { String::new() };
                            self.refused_in_words(place, e.reason(), which + &center_in_block(*at))
                        }
                        _ => self.refused_at(place, &e),
                    }
                })?;
            }
        }
        Ok(objects)
    }

    /// Warns of rotations by more than a turn whose numbers may be meant as degrees.
    pub(in crate::document) fn warn_of_many_turns(&mut self, spec: &TransformSpec) {
        for (index, step) in spec.steps.iter().enumerate() {
            let StepSpec::Rotation(RotationSpec { angle: Angle::Radians(angle), .. }) = *step else { continue };
            if angle.abs() <= std::f64::consts::TAU {
                continue;
            }
            let steps = ["steps".into(), index.into(), "rotation".into(), "angle".into()];
            let place = self.place_of(steps);
            let radians = ShortNumber(angle.to_radians());
            self.ask_about_turns(angle, place, &format!("write `{{\"degrees\": {angle}}}` or {radians}"));
        }
    }

    /// The images of blocks.
    pub(in crate::document) fn mapped_volumes(&self, spec: &TransformSpec) -> Result<Vec<CyclideVolume>> {
        let volumes = self.sources.first().map_or(&[][..], |source| source.item.volumes());
        let of_curves = |step: &StepSpec| matches!(step, StepSpec::Reverse | StepSpec::Cut(_));
        if let Some(index) = spec.steps.iter().position(of_curves).filter(|_| !volumes.is_empty()) {
            return Err(
                self.wrong_source_at([Step::from("steps"), Step::from(index)], "only curves can be reversed or cut")
            );
        }
        self.mapped(spec, 0..spec.steps.len(), volumes, |volume, step| volume.transformed(&map_of(step)?), "")
    }
}

/// What is wrong with the center of an inversion that takes a place of a block to infinity, as far as blocks are looked at.
fn center_in_block(at: [f64; 3]) -> String {
    let [s, t, u] = at.map(ShortNumber);
    format!(
        "the center of the inversion is in the block, or closer to it than 1/65536 of its sides, near s = {s}, t = {t}, u = {u}: the image would pass through infinity"
    )
}

/// Refuses a curve so near the point that goes to infinity that its image has lost its digits.
///
/// # Errors
/// `point-at-infinity`.
fn check_far_from_pole(curve: &CurveObject, map: &Mobius) -> cyclide::Result<()> {
    if map.is_similarity() {
        return Ok(());
    }
    let infinity = HPoint { n: Quat::ONE, d: Quat::ZERO };
    let Some(pole) = map.inverse().map_pair(infinity).quotient().map(|q| Point3::ORIGIN + q.vector()) else {
        return Ok(());
    };
    let curve = curve.as_curve();
    let limit = SMALLEST_DISTANCE * bounds(curve).including(pole).max_abs();
    let distance = closest_point(curve, pole).distance;
    if distance < limit {
        Err(PointError::AtInfinity { what: ErrorItem::Curve, index: 0, distance, limit }.into())
    } else {
        Ok(())
    }
}

/// The image of a curve under one map.
fn image_of_curve(curve: &CurveObject, map: &Mobius) -> cyclide::Result<CurveObject> {
    check_far_from_pole(curve, map)?;
    curve.transformed(map)
}

/// The steps in runs of maps, and of what else is done to curves.
fn runs(steps: &[StepSpec]) -> Vec<Range<usize>> {
    let mut end = 0;
    let of_length = |run: &[StepSpec]| {
        let start = end;
        end += run.len();
        start..end
    };
    steps.chunk_by(|a, b| is_map(a) == is_map(b)).map(of_length).collect()
}

fn is_map(step: &StepSpec) -> bool {
    !matches!(step, StepSpec::Reverse | StepSpec::Cut(_))
}

/// A curve after a step that is the same before and after a map, if it is one.
fn unmoved(curve: CurveObject, step: &StepSpec) -> Option<CurveObject> {
    match step {
        StepSpec::Reverse => Some(curve.reversed()),
        StepSpec::Cut(CutSpec::Parameters([from, to])) if *from <= 0.0 && *to >= 1.0 => {
            curve.restricted(*from, *to).ok()
        }
        _ => None,
    }
}

/// What is wrong with the places of a cut, of which stations are `length` at most.
fn no_part(cut: &CutSpec, length: f64) -> String {
    let (what, [from, to], most) = match cut {
        CutSpec::Parameters(ends) => ("parameters", ends, 1.0),
        CutSpec::Stations(ends) => ("stations", ends, length),
    };
    let most = ShortNumber(most);
    format!(
        "there is no part between the {what} {from} and {to}: both must be from 0 to {most}, and the second must be larger (on a closed curve, different)"
    )
}
