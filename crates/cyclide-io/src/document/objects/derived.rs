//! Objects made from other objects.

use cyclide::{
    Body, CurveObject, CyclidePatch, ParamCurve as _, Pipe, Revolution, Shell, ShellFace, ShortNumber, SurfaceObject,
    Vec3, Warning,
};

use super::idle::idle_in_pipe;
use super::{Builder, BuiltObject};
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::locate::Step;
use crate::document::spec::{OffsetSpec, PipeSpec, RevolutionSpec};
use crate::error::{Error, Result};

/// An angle in radians that leaves less of a whole turn than this may be one, typed with three digits or more.
const NEARLY_WHOLE: f64 = 5e-3;
/// Places of a curve that are looked at for its distance from the axis, which is only told.
const PLACES: u32 = 256;

impl Builder<'_> {
    /// The parallel surfaces, or the solids between.
    pub(in crate::document) fn offset(&self, spec: &OffsetSpec) -> Result<Vec<SurfaceObject>> {
        let source = self.surface_source("only surfaces have an offset")?;
        let other = "only these have an exact offset: `cyclide`, `cyclide-patch`, `cyclidic-net`, and an `offset` or `transform` of one that is not `thick`; what is made of curves or meshes gets its wall from them: both sides of a profile, the `wall` of a pipe, a larger `radius`";
        let made = source.item.surfaces().iter().map(|surface| {
            let made = if spec.thick { surface.thick(spec.distance) } else { surface.offset(spec.distance) };
            made.ok_or_else(|| self.wrong_source(other))?.map_err(|e| self.refused(&e, None))
        });
        made.collect()
    }

    /// What the curves of another object sweep.
    pub(in crate::document) fn revolution(&mut self, spec: &RevolutionSpec) -> Result<Vec<SurfaceObject>> {
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
        if let Some(Angle::Radians(angle)) = spec.angle
            && !turn.is_whole()
        {
            let axis = axis.unit().unwrap_or_default();
            let way = |t: f64, curve: &CurveObject| curve.as_curve().point(t) - center;
            let places =
                curves.iter().flat_map(|curve| (0..=PLACES).map(move |k| way(f64::from(k) / f64::from(PLACES), curve)));
            let radius = places.map(|way| way.cross(axis).length()).fold(0.0, f64::max);
            self.ask_about_slit(angle, radius);
        }
        for (contour, warning) in turn.warnings(&profiles).map_err(|e| self.refused(&e, None))? {
            self.warn_at("of", several.then_some(contour), warning);
        }
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }

    /// Asks whether a whole turn is meant by one that is nearly so, as by 6.2831853 radians.
    fn ask_about_slit(&mut self, angle: f64, radius: f64) {
        let open = std::f64::consts::TAU - angle.abs();
        if open > NEARLY_WHOLE {
            return;
        }
        let message = format!(
            "the angle {angle} is a whole turn but for {} radians, and leaves a slit about {} wide where the curve is farthest from the axis: if a whole turn is meant, leave `angle` out",
            ShortNumber(open),
            ShortNumber(open * radius)
        );
        let place = self.place_of([Step::from("angle")]);
        self.remark("nearly-full-turn", None, None, place, message);
    }

    /// The tubes about the curves of another object.
    pub(in crate::document) fn pipe(&mut self, spec: &PipeSpec) -> Result<Vec<SurfaceObject>> {
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
        let mut bodies = Vec::with_capacity(spines.len());
        for (curve, spine) in curves.iter().zip(&spines) {
            bodies.push(pipe.body(spine).map_err(|e| match e {
                cyclide::Error::MitreDoesNotFit { .. } | cyclide::Error::CornerNotMitred { .. } => {
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
                "the pipes of the contours {first} and {second} run into each other ({} from spine to spine): each is a body of its own, and volume and area count what they share twice; fuse them in CAD",
                ShortNumber(distance)
            );
            self.remark("pipes-meet", Some(second), None, None, message);
        }
        self.remark_on_idle(idle);
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }

    /// The edges of a surface that are arcs, each once; says how many are not.
    pub(in crate::document) fn support_structure(&mut self) -> Result<Vec<CurveObject>> {
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

    /// Warns of an offset that goes past centres of curvature: of patches with `k d >= 1` for a principal curvature `k`
    /// and the distance `d`, both signed by the normal along which offsets are made, where the image shows it too (a
    /// surface that was beyond its focal set may come back).
    pub(in crate::document) fn warn_beyond_focal_set(&mut self, spec: &OffsetSpec, bodies: &[Body]) {
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

    /// The source, which must have surfaces.
    pub(in crate::document) fn surface_source(&self, needed: &str) -> Result<&BuiltObject> {
        match self.sources.first() {
            Some(source) if !source.item.surfaces().is_empty() => Ok(source),
            _ => Err(self.wrong_source(needed)),
        }
    }

    /// Whether what it is made from is curves.
    pub(in crate::document) fn is_of_curves(&self) -> bool {
        self.sources.first().is_some_and(|source| !source.item.curves().is_empty())
    }

    /// The message that the source is of the wrong kind.
    pub(in crate::document) fn wrong_source(&self, needed: &str) -> Error {
        self.wrong_source_at([Step::from("of")], needed)
    }

    /// The same, at what asks for another kind.
    pub(in crate::document) fn wrong_source_at(&self, place: impl IntoIterator<Item = Step>, needed: &str) -> Error {
        let source = self.sources.first().map(|s| format!("`{}` is of type `{}`", s.item.name, s.provenance.kind));
        let message = format!("{}: {needed}", source.unwrap_or_default());
        Error::Input(self.diagnostic(place, &message))
    }
}
