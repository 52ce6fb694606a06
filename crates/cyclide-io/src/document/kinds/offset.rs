//! A parallel surface, or the solid between it and the original.

use cyclide::{
    Warning,
    error::NumberError,
    model::{CurveObject, SurfaceObject},
    surface::{CyclidePatch, Torus},
    topology::{Body, Shell, ShellFace},
    warning::NetWarning,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::contours::ContourFacts;
use crate::document::objects::kind::{FieldNames, Kind, OfPanels, Reference, Shape, main_field, of};
use crate::document::objects::{Builder, BuiltObject};
use crate::error::Result;

/// A parallel surface of another object, exact, or the solid between the two. For a curve on a torus it is the parallel
/// curve along the normal of the torus.
///
/// The normal of a whole cyclide is outward, that of other surfaces is along `f_s x f_t`. An offset keeps the normal of
/// its surface, so that distances add up: beyond a focal set the normal is opposite to its own `f_s x f_t`, and the
/// report lists the patch as flipped.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"r": {"type": "cyclide", "a": 3, "mu": 1}, "o": {"type": "offset", "of": "r", "distance": 0.5}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[1].bodies[0].outer.area() - 18.0 * std::f64::consts::PI.powi(2)).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct OffsetSpec {
    /// The word `offset`.
    #[schemars(with = "String", extend("const" = "offset"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the surface, or of a `torus-spline`, `torus-knot`, `torus-quartic` or `torus-circle`.
    pub of: String,
    /// Distance along the normal; negative values are on the other side.
    pub distance: f64,
    /// Makes the solid between the surface and its parallel surface, with a rim along free edges.
    #[serde(default)]
    pub thick: bool,
}

impl Kind for OffsetSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        if at.is_of_curves() {
            at.parallel_curves(self).map(Shape::Curves)
        } else {
            at.offset(self).map(Shape::Surfaces)
        }
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn fields(&self) -> FieldNames {
        main_field("distance")
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        use cyclide::{Error as E, error::ErrorItem as I};
        let is_of_distance = matches!(error, E::Number(NumberError::ParameterOutOfRange { name: I::Distance, .. }));
        (is_of_distance && self.distance == 0.0)
            .then(|| "a solid between a surface and its offset requires a nonzero distance".to_owned())
    }

    fn of_panels(&self) -> Option<OfPanels> {
        Some(OfPanels::OtherSide { of: self.of.clone(), distance: self.distance, solid: self.thick })
    }

    fn skin(&self, source: Option<&BuiltObject>) -> Vec<SurfaceObject> {
        source.filter(|_| self.thick).map_or_else(Vec::new, |source| source.item.surfaces().to_vec())
    }

    fn has_panels(&self, source: Option<&BuiltObject>) -> bool {
        source.is_some_and(|source| source.provenance.panels)
    }

    fn remark_on(&self, at: &mut Builder<'_>, _: &Shape, bodies: &[Body]) {
        at.warn_beyond_focal_set(self, bodies);
    }
}

impl Builder<'_> {
    /// The parallel surfaces, or the solids between.
    pub(in crate::document) fn offset(&self, spec: &OffsetSpec) -> Result<Vec<SurfaceObject>> {
        let source = self.surface_source("only surfaces have an offset")?;
        let other = "only these have an exact offset: `cyclide`, `cyclide-patch`, `cyclidic-net`, and an `offset` or `transform` of one without `thick`; walls of objects made from curves or meshes are defined there: both sides of a profile, the `wall` of a pipe, a larger `radius`";
        let made = source.item.surfaces().iter().map(|surface| {
            let made = if spec.thick { surface.thick(spec.distance) } else { surface.offset(spec.distance) };
            made.ok_or_else(|| self.wrong_source(other))?.map_err(|e| self.refused(&e, None))
        });
        made.collect()
    }

    /// Warns of an offset that goes past centers of curvature: of patches with `k d >= 1` for a principal curvature `k`
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
        self.warn_at(
            "distance",
            None,
            Warning::Net(NetWarning::BeyondFocalSet { distance, radius, first, count: beyond.len() }),
        );
    }

    /// The curves at a distance along the normal of the torus of the source.
    pub(in crate::document) fn parallel_curves(&self, spec: &OffsetSpec) -> Result<Vec<(CurveObject, ContourFacts)>> {
        if spec.thick {
            return Err(
                self.wrong_source_at([Step::from("thick")], "only a surface can be made a solid with its offset")
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
}
