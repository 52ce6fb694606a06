//! Objects made from other objects.

use cyclide::{Conformal as _, CurveObject, Mobius, Quat, SurfaceObject, Vec3};

use super::{Builder, BuiltObject};
use crate::document::coordinates::Coordinates;
use crate::document::locate::Step;
use crate::document::spec::{OffsetSpec, StepSpec, TransformSpec};
use crate::error::{Error, Result};

impl Builder<'_> {
    /// The parallel surfaces, or the solids between.
    pub(super) fn offset(&self, spec: &OffsetSpec) -> Result<Vec<SurfaceObject>> {
        let needed = "only surfaces that are not thick already have an offset";
        let source = self.surface_source(needed)?;
        let made = source.item.surfaces.iter().map(|surface| {
            let made = if spec.thick { surface.thick(spec.distance) } else { surface.offset(spec.distance) };
            made.ok_or_else(|| self.wrong_source(needed))?.map_err(|e| self.refused(&e, None))
        });
        made.collect()
    }

    /// The edges of a surface, each once.
    pub(super) fn support_structure(&self) -> Result<Vec<CurveObject>> {
        let source = self.surface_source("only surfaces have a support structure")?;
        let mut arcs = Vec::new();
        for surface in &source.item.surfaces {
            arcs.extend(surface.edge_arcs().map_err(|e| self.refused(&e, None))?);
        }
        Ok(arcs.into_iter().map(CurveObject::Arc).collect())
    }

    /// The images of curves.
    pub(super) fn mapped_curves(&self, spec: &TransformSpec) -> Result<Vec<CurveObject>> {
        let curves = self.sources.first().map_or(&[][..], |source| &source.item.contours);
        self.mapped(spec, curves, |curve, map| curve.transformed(map))
    }

    /// The images of surfaces.
    pub(super) fn mapped_surfaces(&self, spec: &TransformSpec) -> Result<Vec<SurfaceObject>> {
        let surfaces = self.sources.first().map_or(&[][..], |source| &source.item.surfaces);
        self.mapped(spec, surfaces, |surface, map| surface.transformed(map))
    }

    /// Applies the steps one by one, so that a message can show the step at fault.
    fn mapped<T: Clone>(
        &self,
        spec: &TransformSpec,
        objects: &[T],
        image: impl Fn(&T, &Mobius) -> cyclide::Result<T>,
    ) -> Result<Vec<T>> {
        let mut objects = objects.to_vec();
        for (index, step) in spec.steps.iter().enumerate() {
            let refused = |e: &cyclide::Error| self.refused_at([Step::from("steps"), Step::from(index)], e);
            let map = map_of(step).map_err(|e| refused(&e))?;
            for object in &mut objects {
                *object = image(object, &map).map_err(|e| refused(&e))?;
            }
        }
        Ok(objects)
    }

    /// The source, which must have surfaces.
    pub(super) fn surface_source(&self, needed: &str) -> Result<&BuiltObject> {
        match self.sources.first() {
            Some(source) if !source.item.surfaces.is_empty() => Ok(source),
            _ => Err(self.wrong_source(needed)),
        }
    }

    /// The message that the source is of the wrong kind.
    fn wrong_source(&self, needed: &str) -> Error {
        let source = self.sources.first().map(|s| format!("`{}` is of type `{}`", s.item.name, s.item.kind));
        let message = format!("{}: {needed}", source.unwrap_or_default());
        Error::Input(self.diagnostic([Step::from("of")], &message))
    }
}

/// The map of one step.
fn map_of(step: &StepSpec) -> cyclide::Result<Mobius> {
    let origin = |given: Option<Coordinates>| given.unwrap_or_default().point();
    match step {
        StepSpec::Inversion(s) => Mobius::inversion(s.center.point(), s.radius),
        StepSpec::Translation(v) => Mobius::translation(v.vector()),
        StepSpec::Rotation(s) => {
            let axis = s.axis.map_or(Vec3::Z, Coordinates::vector).unit().ok_or(cyclide::Error::ZeroAxis)?;
            let (turn, center) = (Quat::from_axis_angle(axis, s.angle), origin(s.center).to_vec());
            Mobius::similarity(turn, 1.0, center - turn.rotate(center))
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
    }
}
