//! The report on smooth surfaces over triangles.

use std::fmt;

use cyclide::surface::{SmoothComparison, SmoothMeasure, TriangleSurface};
use serde::Serialize;

use super::figures::{Line, measure, plural, short};
use crate::document::BuiltObject;

/// The report on a smooth surface over triangles. Largest values are over many samples, not proved.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "vertices": [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Smooth(found) = report.geometry else { unreachable!("by its type") };
/// assert_eq!((found.triangles, found.vertices, found.closed), (8, 6, true));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SmoothReport {
    /// Triangles.
    pub triangles: usize,
    /// Vertices that they use.
    pub vertices: usize,
    /// Polygons of the mesh as given; `None` for an image.
    pub polygons: Option<usize>,
    /// True if no edge is free.
    pub closed: bool,
    /// Edges with only one triangle: the border.
    pub free_edges: usize,
    /// Vertices at which the border has a corner, where it turns by more than 60 degrees.
    pub border_corners: usize,
    /// Edges that are creases.
    pub creases: usize,
    /// Where the normals at the vertices come from: `angle`, `sphere`, `file` or `given`; `None` for an image and for a sphere
    /// blend.
    pub normals: Option<&'static str>,
    /// The angle above which edges are creases, in radians, if given.
    pub crease_angle: Option<f64>,
    /// Area, by quadrature.
    pub area: f64,
    /// Its difference from the result with half as many nodes.
    pub area_error: f64,
    /// Enclosed volume, by quadrature, negative if the triangles are clockwise seen from outside; `None` if the surface is open.
    pub volume: Option<f64>,
    /// Its difference from the result with half as many nodes.
    pub volume_error: f64,
    /// Normals and distances compared with flat and curved PN triangles; `None` for a sphere blend.
    pub comparison: Option<ComparisonReport>,
    /// The basis of the figures and bounds of this surface.
    pub proof: &'static str,
    /// Why an area or the volume is unknown: it is then NaN, in JSON null.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_known: Vec<String>,
}

/// A smooth mesh compared with flat triangles and curved PN triangles over the same vertices and normals.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "vertices": [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Smooth(found) = report.geometry else { unreachable!("by its type") };
/// let comparison = found.comparison.expect("it is a smooth mesh");
/// assert!(comparison.jump < 1e-6 && comparison.flat_jump > 1.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ComparisonReport {
    /// Largest jump of the normal across an edge that is not a crease, in radians: rounding.
    pub jump: f64,
    /// The same for the flat triangles.
    pub flat_jump: f64,
    /// The same for PN triangles.
    pub pn_jump: f64,
    /// Largest distance from the flat triangles.
    pub from_flat: f64,
    /// Largest distance from the PN triangles, at the same parameters.
    pub from_pn: f64,
}

impl From<SmoothComparison> for ComparisonReport {
    fn from(given: SmoothComparison) -> Self {
        let SmoothComparison { jump, flat_jump, pn_jump, from_flat, from_pn, .. } = given;
        Self { jump, flat_jump, pn_jump, from_flat, from_pn }
    }
}

impl SmoothReport {
    /// Measures a surface of an object.
    pub(super) fn new(built: &BuiltObject, surface: &TriangleSurface) -> Self {
        let mut not_known = Vec::new();
        let mut known =
            |made: cyclide::Result<SmoothMeasure>| made.map_err(|error| not_known.push(error.to_string())).ok();
        let choice = built.facts.smooth_mesh();
        let (measure, vertices, border_corners, creases, comparison) = match surface {
            TriangleSurface::Mesh(mesh) => {
                let mut used = vec![false; mesh.positions().len()];
                mesh.triangles().iter().flatten().for_each(|&v| used[v] = true);
                let creases = mesh.edges().iter().filter(|edge| edge.is_sharp()).count();
                let comparison = mesh.comparison().ok().map(ComparisonReport::from);
                let vertices = used.iter().filter(|used| **used).count();
                (known(mesh.measure()), vertices, mesh.boundary_corners(), creases, comparison)
            }
            TriangleSurface::Blend(blend) => (known(blend.measure()), 3, 3, 0, None),
        };
        let [area, area_error] = measure.map_or([f64::NAN; 2], |measure| [measure.area, measure.area_error]);
        let unknown = surface.is_closed().then_some(f64::NAN);
        let (volume, volume_error) = measure.map_or((unknown, f64::NAN), |m| (m.volume, m.volume_error));
        Self {
            triangles: surface.triangle_count(),
            vertices,
            polygons: choice.map(|choice| choice.polygons),
            closed: surface.is_closed(),
            free_edges: surface.free_sides(),
            border_corners,
            creases,
            normals: choice.map(|choice| choice.normals),
            crease_angle: choice.and_then(|choice| choice.crease_angle),
            area,
            area_error,
            volume,
            volume_error,
            comparison,
            proof: "sampled",
            not_known,
        }
    }

    pub(super) fn facts(&self, facts: &mut Vec<String>) {
        facts.push(if self.closed { "closed" } else { "open" }.to_owned());
        facts.push(plural(self.triangles, "triangle"));
    }

    pub(super) fn lines(&self, units: &str, line: Line<'_>) -> fmt::Result {
        let within = |value: f64, error: f64, power: &str| {
            if value.is_nan() {
                return measure(value, units, power);
            }
            format!("{} (to {})", measure(value, units, power), short(error))
        };
        line("area", within(self.area, self.area_error, "²"))?;
        if let Some(volume) = self.volume {
            line("volume", within(volume, self.volume_error, "³"))?;
        }
        for reason in &self.not_known {
            line("not known", reason.clone())?;
        }
        let mut mesh = format!("{} vertices", self.vertices);
        if let Some(normals) = self.normals {
            mesh += &match normals {
                "angle" => ", normals weighted by angles".to_owned(),
                "sphere" => ", normals exact on spheres".to_owned(),
                "file" => ", normals from the file".to_owned(),
                _ => ", normals as given".to_owned(),
            };
        }
        line("mesh", mesh)?;
        if self.free_edges > 0 {
            let corners = plural(self.border_corners, "corner");
            line("border", format!("{}, smooth except for {corners}", plural(self.free_edges, "edge")))?;
        }
        if self.creases > 0 || self.crease_angle.is_some() {
            let above = self.crease_angle.map_or(String::new(), |angle| format!(" above {} rad", short(angle)));
            line("creases", format!("{}{above}", plural(self.creases, "edge")))?;
        }
        if let Some(c) = &self.comparison {
            let [own, flat, pn] = [c.jump, c.flat_jump, c.pn_jump].map(short);
            line("normals", format!("jump by {own} rad across edges; flat triangles {flat}, PN triangles {pn} rad"))?;
            let [flat, pn] = [c.from_flat, c.from_pn].map(short);
            line("distance", format!("{flat} {units} from flat triangles, {pn} {units} from PN triangles"))?;
        }
        line(
            "accuracy",
            "meshes of it are checked by samples: it has no form for which a bound could be proved".to_owned(),
        )
    }
}
