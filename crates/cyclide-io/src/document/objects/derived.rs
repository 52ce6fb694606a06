//! Objects made from other objects.

use cyclide::{
    Body, Conformal as _, CurveObject, CyclidePatch, ErrorItem, HPoint, Mobius, ParamCurve as _, Pipe, Point3, Quat,
    Revolution, Shell, ShellFace, ShortNumber, SurfaceObject, Vec3, Warning, bounds, closest_point,
};

use super::idle::idle_in_pipe;
use super::{Builder, BuiltObject};
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::locate::Step;
use crate::document::spec::{CutSpec, OffsetSpec, PipeSpec, RevolutionSpec, RotationSpec, StepSpec, TransformSpec};
use crate::error::{Error, Result};

impl Builder<'_> {
    /// The parallel surfaces, or the solids between.
    pub(super) fn offset(&self, spec: &OffsetSpec) -> Result<Vec<SurfaceObject>> {
        let source = self.surface_source("only surfaces have an offset")?;
        let other = "only patches, nets and cyclides that are not thick already have an exact offset; what is made of curves or meshes gets its wall from them: both sides of a profile, the `wall` of a pipe, a larger `radius`";
        let made = source.item.surfaces().iter().map(|surface| {
            let made = if spec.thick { surface.thick(spec.distance) } else { surface.offset(spec.distance) };
            made.ok_or_else(|| self.wrong_source(other))?.map_err(|e| self.refused(&e, None))
        });
        made.collect()
    }

    /// What the curves of another object sweep.
    pub(super) fn revolution(&mut self, spec: &RevolutionSpec) -> Result<Vec<SurfaceObject>> {
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves());
        if curves.is_empty() {
            return Err(self.wrong_source("only curves sweep a surface of revolution"));
        }
        let axis = spec.axis.map_or(Vec3::Z, Coordinates::vector);
        let center = spec.center.unwrap_or_default().point();
        let angle = spec.angle.map_or(std::f64::consts::TAU, Angle::radians);
        let turn = Revolution::new(center, axis, angle).map_err(|e| self.refused(&e, None))?;
        let several = curves.len() > 1;
        let profiles = curves.iter().map(CurveObject::exact_pieces).collect::<cyclide::Result<Vec<_>>>();
        let profiles = profiles.map_err(|e| self.refused(&e, None))?;
        let bodies = turn.bodies(&profiles).map_err(|e| self.refused(&e, None))?;
        for (contour, warning) in turn.warnings(&profiles).map_err(|e| self.refused(&e, None))? {
            self.warn_at("of", several.then_some(contour), warning);
        }
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }

    /// The tubes about the curves of another object.
    pub(super) fn pipe(&mut self, spec: &PipeSpec) -> Result<Vec<SurfaceObject>> {
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves());
        if curves.is_empty() {
            return Err(self.wrong_source("only curves have a pipe about them"));
        }
        let refused = |e: cyclide::Error| self.refused(&e, None);
        let mut pipe = Pipe::new(spec.radius).map_err(refused)?.with_ends(spec.ends);
        if let Some(wall) = spec.wall {
            pipe = pipe.with_wall(wall).map_err(refused)?;
        }
        let spines = curves.iter().map(|curve| curve.spine(spec.tolerance)).collect::<cyclide::Result<Vec<_>>>();
        let spines = spines.map_err(refused)?;
        let bodies =
            spines.iter().map(|spine| pipe.body(spine)).collect::<cyclide::Result<Vec<_>>>().map_err(refused)?;
        let meeting = pipe.first_meeting(&spines).map_err(refused)?;
        let idle = idle_in_pipe(spec, curves, spines.iter().all(|spine| spine.is_closed()));
        if let Some(([first, second], distance)) = meeting {
            let message = format!(
                "the pipes of the contours {first} and {second} run into each other ({} from spine to spine): each is a body of its own, and volume and area count what they share twice; fuse them in CAD",
                ShortNumber(distance)
            );
            self.remark("pipes-meet", Some(second), None, None, message);
        }
        self.remark_on_idle(idle);
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }

    /// The edges of a surface that are arcs, each once; says how many are not.
    pub(super) fn support_structure(&mut self) -> Result<Vec<CurveObject>> {
        let source = self.surface_source("only surfaces have a support structure")?;
        let (mut arcs, mut rational) = (Vec::new(), 0);
        for surface in source.item.surfaces() {
            arcs.extend(surface.edge_arcs().map_err(|e| self.refused(&e, None))?);
            if let SurfaceObject::Body(body) = surface {
                let shells = std::iter::once(&body.outer).chain(&body.voids);
                rational += shells.flat_map(|shell| shell.edges()).filter(|edge| edge.curve.arc().is_none()).count();
            }
        }
        if rational > 0 {
            let all = arcs.len() + rational;
            let message = format!(
                "{rational} of {all} edges are rational curves of a higher degree and are left out: a support structure is of arcs and segments"
            );
            self.remark("rational-edges-left-out", None, None, None, message);
        }
        Ok(arcs.into_iter().map(CurveObject::Arc).collect())
    }

    /// The images of curves.
    pub(super) fn mapped_curves(&self, spec: &TransformSpec) -> Result<Vec<CurveObject>> {
        let curves = self.sources.first().map_or(&[][..], |source| source.item.curves());
        let image = |curve: &CurveObject, step: &StepSpec| match step {
            StepSpec::Reverse => Ok(curve.reversed()),
            StepSpec::Cut(CutSpec::Parameters([from, to])) => curve.restricted(*from, *to),
            StepSpec::Cut(CutSpec::Stations([from, to])) => curve.restricted_to_stations(*from, *to),
            _ => {
                let map = map_of(step)?;
                check_far_from_pole(curve, &map)?;
                curve.transformed(&map)
            }
        };
        let kept = "circles, circle splines and curves on tori are moved, turned, scaled and mirrored only; arcs and chains of arcs take inversions too";
        self.mapped(spec, curves, image, kept)
    }

    /// The images of surfaces.
    pub(super) fn mapped_surfaces(&self, spec: &TransformSpec) -> Result<Vec<SurfaceObject>> {
        if self.sources.first().is_some_and(|source| source.item.motion().is_some()) {
            return Err(self.wrong_source("a motion is placed by its poses, not by a `transform`"));
        }
        let surfaces = self.sources.first().map_or(&[][..], |source| source.item.surfaces());
        let kept = "surfaces with rational faces, as those of tees, seams and profiles that are no arcs, and surfaces over triangles are moved, turned, scaled and mirrored only; patches whose parameter lines are circles take inversions too";
        let of_curves = |step: &StepSpec| matches!(step, StepSpec::Reverse | StepSpec::Cut(_));
        if let Some(index) = spec.steps.iter().position(of_curves).filter(|_| !surfaces.is_empty()) {
            return Err(
                self.wrong_source_at([Step::from("steps"), Step::from(index)], "only curves are run backwards or cut")
            );
        }
        self.mapped(spec, surfaces, |surface, step| surface.transformed(&map_of(step)?), kept)
    }

    /// Applies the steps one by one, so that a message can show the step at fault; `kept` says what other maps are for.
    fn mapped<T: Clone>(
        &self,
        spec: &TransformSpec,
        objects: &[T],
        image: impl Fn(&T, &StepSpec) -> cyclide::Result<T>,
        kept: &str,
    ) -> Result<Vec<T>> {
        let mut objects = objects.to_vec();
        for (index, step) in spec.steps.iter().enumerate() {
            let several = objects.len() > 1;
            for (contour, object) in objects.iter_mut().enumerate() {
                *object = image(object, step).map_err(|e| {
                    let place = [Step::from("steps"), Step::from(index)];
                    match (step, &e) {
                        (_, cyclide::Error::NotASimilarity { .. }) => {
                            self.refused_in_words(place, e.reason(), format!("{e}: {kept}"))
                        }
                        (StepSpec::Cut(cut), cyclide::Error::ParameterOutOfRange { max, .. }) => {
                            // Contours differ in length.
                            let which = if several { format!("contour {contour}: ") } else { String::new() };
                            self.refused_in_words(place, e.reason(), which + &no_part(cut, *max))
                        }
                        _ => self.refused_at(place, &e),
                    }
                })?;
            }
        }
        Ok(objects)
    }

    /// Warns of an offset that goes past centres of curvature: of patches with `k d >= 1` for a principal curvature `k`
    /// and the distance `d`, both signed by the normal along which offsets are made, where the image shows it too (a
    /// surface that was beyond its focal set may come back).
    pub(super) fn warn_beyond_focal_set(&mut self, spec: &OffsetSpec, bodies: &[Body]) {
        let source = self.sources.first().map_or(&[][..], |source| &source.bodies);
        let is_whole =
            |face: &ShellFace| face.surface.patch().is_none_or(|patch| patch.is_regular() && !patch.is_flipped());
        let whole = bodies.iter().flat_map(Body::shells).flat_map(Shell::faces).all(is_whole);
        // Beyond nodes it falls apart into lobes.
        if spec.thick || (whole && bodies.len() <= source.len()) {
            return;
        }
        let patches = source.iter().flat_map(Body::shells).flat_map(Shell::faces);
        let patches = patches.filter_map(|face| face.surface.patch());
        let sharpest = |patch: &CyclidePatch| {
            let bends = [patch.k1_range(), patch.k2_range()].concat();
            bends.into_iter().map(|k| k * spec.distance).fold(0.0, f64::max)
        };
        let beyond: Vec<(usize, f64)> = patches.map(sharpest).enumerate().filter(|(_, bend)| *bend >= 1.0).collect();
        let Some(&(first, _)) = beyond.first() else { return };
        let sharpest = beyond.iter().map(|(_, bend)| *bend).fold(1.0, f64::max);
        let (distance, radius) = (spec.distance, spec.distance.abs() / sharpest);
        self.warn_at("distance", None, Warning::BeyondFocalSet { distance, radius, first, count: beyond.len() });
    }

    /// Warns of rotations by more than a turn whose numbers may be meant as degrees.
    pub(super) fn warn_of_many_turns(&mut self, spec: &TransformSpec) {
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

    /// The source, which must have surfaces.
    pub(super) fn surface_source(&self, needed: &str) -> Result<&BuiltObject> {
        match self.sources.first() {
            Some(source) if !source.item.surfaces().is_empty() => Ok(source),
            _ => Err(self.wrong_source(needed)),
        }
    }

    /// The message that the source is of the wrong kind.
    pub(super) fn wrong_source(&self, needed: &str) -> Error {
        self.wrong_source_at([Step::from("of")], needed)
    }

    /// The same, at what asks for another kind.
    fn wrong_source_at(&self, place: impl IntoIterator<Item = Step>, needed: &str) -> Error {
        let source = self.sources.first().map(|s| format!("`{}` is of type `{}`", s.item.name, s.provenance.kind));
        let message = format!("{}: {needed}", source.unwrap_or_default());
        Error::Input(self.diagnostic(place, &message))
    }
}

/// Smallest distance of a curve from the point that goes to infinity, relative to the coordinates of both: they are rounded by
/// 1e-16 of them, and the image of a point next to it by that part of a distance that is so small.
const SMALLEST_DISTANCE: f64 = 5e-11;

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
        Err(cyclide::Error::PointAtInfinity { what: ErrorItem::Curve, index: 0, distance, limit })
    } else {
        Ok(())
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
        "there is no part between the {what} {from} and {to}: they are from 0 to {most}, and the second is larger, of a closed curve not the same"
    )
}

/// The map of one step; what is no map moves nothing.
fn map_of(step: &StepSpec) -> cyclide::Result<Mobius> {
    let origin = |given: Option<Coordinates>| given.unwrap_or_default().point();
    match step {
        StepSpec::Inversion(s) => Mobius::inversion(s.center.point(), s.radius),
        StepSpec::Translation(v) => Mobius::translation(v.vector()),
        StepSpec::Rotation(s) => {
            Mobius::rotation(origin(s.center), s.axis.map_or(Vec3::Z, Coordinates::vector), s.angle.turn())
        }
        StepSpec::Scale(s) => {
            let center = origin(s.center).to_vec();
            Mobius::similarity(Quat::ONE, s.factor, center * (1.0 - s.factor))
        }
        StepSpec::Mirror(s) => Mobius::reflection(origin(s.origin), s.normal.vector()),
        StepSpec::Matrix(rows) => {
            let [[a, b], [c, e]] = rows.map(|row| row.map(|[w, x, y, z]| Quat::new(w, x, y, z)));
            Mobius::from_matrix(a, b, c, e)
        }
        StepSpec::Reverse | StepSpec::Cut(_) => Mobius::translation(Vec3::ZERO),
    }
}
