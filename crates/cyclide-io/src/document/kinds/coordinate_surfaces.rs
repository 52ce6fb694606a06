//! Surfaces inside blocks.

use cyclide::{model::SurfaceObject, topology::Body, volume::CyclideVolume};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::idle::NO_EFFECT;
use crate::document::objects::kind::{Kind, Reference, Shape, of};
use crate::error::Result;

/// Surfaces inside blocks on which one parameter is constant, as patches; or the outer boundary of all blocks as a
/// solid.
///
/// ```
/// use cyclide_io::Document;
/// let block = r#""b": {"type": "cyclide-volume", "corners": [[0,0,0], [1,0.2,-0.1], [-0.2,1,0.1], [0.1,-0.1,0.9]]}"#;
/// let middle = r#""m": {"type": "coordinate-surfaces", "of": "b", "s": [0.5], "u": [0, 0.5]}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{block}, {middle}}}}}"#).parse::<Document>()?.build()?;
/// assert_eq!(built[1].item.surfaces().len(), 3);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CoordinateSurfacesSpec {
    /// The word `coordinate-surfaces`.
    #[schemars(with = "String", extend("const" = "coordinate-surfaces"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of an object that consists of blocks.
    pub of: String,
    /// Values of s, from 0 to 1 in each block.
    #[serde(default)]
    #[schemars(inner(range(min = 0.0, max = 1.0)))]
    pub s: Vec<f64>,
    /// Values of t.
    #[serde(default)]
    #[schemars(inner(range(min = 0.0, max = 1.0)))]
    pub t: Vec<f64>,
    /// Values of u.
    #[serde(default)]
    #[schemars(inner(range(min = 0.0, max = 1.0)))]
    pub u: Vec<f64>,
    /// Makes the outer boundary of all blocks instead: the faces that belong to one block only, sewn into solids.
    #[serde(default)]
    pub outer: bool,
}

impl Kind for CoordinateSurfacesSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.check_surfaces_differ(self)?;
        at.coordinate_surfaces(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}

impl Builder<'_> {
    /// Refuses values of a parameter that are given twice: two surfaces would be one.
    pub(in crate::document) fn check_surfaces_differ(&self, spec: &CoordinateSurfacesSpec) -> Result<()> {
        for (field, values) in [("s", &spec.s), ("t", &spec.t), ("u", &spec.u)] {
            let again = |k: usize| values[..k].iter().position(|x| x.total_cmp(&values[k]).is_eq());
            if let Some((k, before)) = (0..values.len()).find_map(|k| Some((k, again(k)?))) {
                let words =
                    format!("{field}[{k}] = {} equals {field}[{before}]: the surfaces would coincide", values[k]);
                let place = [Step::from(field), Step::from(k)];
                return Err(self.refused_in_words(place, "parameters-not-increasing", words));
            }
        }
        Ok(())
    }

    /// Surfaces inside blocks on which one parameter is constant.
    pub(in crate::document) fn coordinate_surfaces(
        &mut self,
        spec: &CoordinateSurfacesSpec,
    ) -> Result<Vec<SurfaceObject>> {
        let volumes = self.sources.first().map_or(&[][..], |source| source.item.volumes());
        if volumes.is_empty() {
            return Err(self.wrong_source(
                "only a `cyclide-volume`, a `cyclide-grid`, `layers` and their images have coordinate surfaces",
            ));
        }
        if spec.outer {
            if ![&spec.s, &spec.t, &spec.u].into_iter().all(Vec::is_empty) {
                return Err(self.unfit("`outer` is the boundary of all blocks: remove `s`, `t` and `u`"));
            }
            let bodies = CyclideVolume::outer_bodies(volumes).map_err(|e| self.refused(&e, None))?;
            return Ok(bodies.into_iter().map(SurfaceObject::Body).collect());
        }
        let lists = [("s", &spec.s), ("t", &spec.t), ("u", &spec.u)];
        if lists.iter().all(|(_, values)| values.is_empty()) {
            return Err(
                self.unfit("either `s`, `t` or `u` for surfaces inside, or `outer` for the boundary is required")
            );
        }
        let (mut surfaces, mut names) = (Vec::new(), Vec::new());
        for (axis, (field, values)) in lists.iter().enumerate().filter(|(_, (_, values))| !values.is_empty()) {
            for (index, x) in values.iter().enumerate().filter(|(_, x)| !(0.0..=1.0).contains(*x)) {
                let error = volumes[0].surface(axis, *x).err();
                let refused = |e| self.refused_at([Step::from(*field), Step::from(index)], &e);
                error.map_or(Ok(()), |e| Err(refused(e)))?;
            }
            let made = CyclideVolume::coordinate_bodies(volumes, axis, values);
            // Of lines there are no bodies; where all surfaces are lines the kernel has none at all.
            let has_body = |x: f64| {
                made.as_ref().is_ok_and(|made| made.iter().any(|(value, _)| value.total_cmp(&(x + 0.0)).is_eq()))
            };
            let no_surface = |x: f64| !has_body(x) && volumes.iter().all(|volume| is_line(volume, axis, x));
            let lines: Vec<usize> = (0..values.len()).filter(|k| no_surface(values[*k])).collect();
            for index in &lines {
                let x = values[*index];
                let words = format!(
                    "{field} = {x} is not a surface but a line or a point of every block, at an axis or a pole"
                );
                let place = [Step::from(*field), Step::from(*index)];
                if lines.len() == values.len() {
                    return Err(self.refused_in_words(place, "collapsed-side", words));
                }
                let place = self.place_of(place);
                self.remark(NO_EFFECT, None, None, place, words);
            }
            let made = made.map_err(|e| self.refused_at([Step::from(*field)], &e))?;
            for (number, (value, body)) in made.iter().enumerate() {
                let same = |(other, _): &&(f64, Body)| other.total_cmp(value).is_eq();
                let name = format!("{field}={value}");
                names.push(match made.iter().filter(same).count() {
                    1 => name,
                    _ => format!("{name} {}", made[..number].iter().filter(same).count()),
                });
                surfaces.push(surface_of(body.clone()));
            }
        }
        self.names = names;
        Ok(surfaces)
    }
}

/// Whether opposite sides of the surface on which a parameter is constant are one point each.
fn is_line(volume: &CyclideVolume, axis: usize, x: f64) -> bool {
    volume.surface(axis, x).is_ok_and(|face| {
        let [a, b, c, d] = face.corners();
        (a == b && c == d) || (a == c && b == d)
    })
}

/// A body as a surface: a single patch is one, which has offsets and layers.
fn surface_of(body: Body) -> SurfaceObject {
    match body.outer.faces() {
        [only] => only.surface.patch().map(|patch| SurfaceObject::Patch(*patch)),
        _ => None,
    }
    .unwrap_or(SurfaceObject::Body(body))
}
