//! A convex polyhedron with its edges and corners rounded.

use cyclide::{
    Error as KernelError, Point3, ShortNumber,
    construct::ConvexPolyhedron,
    error::{ErrorItem, NumberError, PointError, PolyhedronError},
    model::SurfaceObject,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::{Coordinates, PointSource};
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::polygon_mesh_file::PolygonMeshFile;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::facts::{Facts, RoundedPolyhedron};
use crate::document::objects::kind::{Kind, Shape};
use crate::document::objects::points::inline_points;
use crate::document::objects::remark::Remark;
use crate::error::{Error, Result};
use crate::input::triangle_mesh::distinct;

/// Part of the largest coordinate of an STL file by which a corner may be off its plane: eight roundings to single precision. A point
/// is off by two at most, the fourth corner of a quad off the plane of the other three by up to seven.
const SINGLE: f64 = 4.8e-7;

/// Edges reflex by less than this, radians, and corners off their plane by less than this part of the size, speak of few digits.
const FEW_DIGITS: f64 = 1e-3;

/// A convex polyhedron with all edges and corners rounded: the points within a distance of it. It is a solid of planes,
/// cylinders and parts of spheres. The polyhedron is a mesh in a file (`mesh`), the convex hull of points (`points`),
/// or given by `vertices` and `faces`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "smooth-polyhedron", "radius": 1, "points": [[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0], [0, 0, 2], [2, 0, 2], [0, 2, 2], [2, 2, 2]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[0].bodies[0].outer.volume() - (32.0 + (6.0 + 4.0 / 3.0) * std::f64::consts::PI)).abs() < 1e-10);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["mesh"], "properties": { "points": false, "vertices": false, "faces": false } },
    { "required": ["points"], "properties": { "mesh": false, "vertices": false, "faces": false, "hull": false } },
    { "required": ["vertices", "faces"], "properties": { "mesh": false, "points": false } }
]))]
#[non_exhaustive]
pub struct SmoothPolyhedronSpec {
    /// The word `smooth-polyhedron`.
    #[schemars(with = "String", extend("const" = "smooth-polyhedron"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Radius of the rounding, by which the polyhedron grows; 0 gives the polyhedron itself.
    #[schemars(range(min = 0.0))]
    pub radius: f64,
    /// A closed mesh of planar polygons with any number of corners. Equal points are merged, and so are faces in one
    /// plane.
    pub mesh: Option<PolygonMeshFile>,
    /// Points whose convex hull is the polyhedron.
    pub points: Option<PointSource>,
    /// The vertices.
    #[schemars(length(min = 4))]
    pub vertices: Option<Vec<Coordinates>>,
    /// The faces: lists of vertex numbers from 0, counter-clockwise seen from outside.
    #[schemars(length(min = 4), inner(length(min = 3)))]
    pub faces: Option<Vec<Vec<u32>>>,
    /// Take the convex hull of the vertices instead of the faces, which then need not be convex.
    #[serde(default)]
    pub hull: bool,
    /// Largest distance at which corners count as lying in a plane: faces are planar, and those in one plane become
    /// one. Default: 1e-9 of the diameter; for an STL or GLB file the rounding of its numbers, 5e-7 of the largest
    /// coordinate.
    #[schemars(range(min = 0.0))]
    pub flatness: Option<f64>,
}

/// Points and faces as they are given.
struct Mesh {
    points: Vec<Point3>,
    /// None for the hull.
    faces: Option<Vec<Vec<usize>>>,
    flatness: Option<f64>,
    /// The field that messages are about, and the file.
    field: &'static str,
    file: Option<String>,
}

impl Kind for SmoothPolyhedronSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.smooth_polyhedron(self).map(Shape::Surfaces)
    }

    fn points(&self) -> Option<&PointSource> {
        self.points.as_ref()
    }

    fn files(&self) -> Vec<&str> {
        match (&self.points, &self.mesh) {
            (Some(PointSource::File(file)), _) => vec![file.csv.as_str()],
            (_, Some(file)) => vec![file.path.as_str()],
            _ => Vec::new(),
        }
    }
}

impl Builder<'_> {
    /// The polyhedron with its edges and corners rounded.
    pub(in crate::document) fn smooth_polyhedron(&mut self, spec: &SmoothPolyhedronSpec) -> Result<Vec<SurfaceObject>> {
        let mut mesh = self.polyhedron_mesh(spec)?;
        if spec.hull {
            mesh.faces = None;
        }
        let (points, flatness) = (&mesh.points, spec.flatness.or(mesh.flatness));
        let polyhedron = match (&mesh.faces, flatness) {
            (Some(faces), None) => ConvexPolyhedron::new(points, faces),
            (Some(faces), Some(flatness)) => ConvexPolyhedron::with_flatness(points, faces, flatness),
            (None, None) => ConvexPolyhedron::hull(points),
            (None, Some(flatness)) => ConvexPolyhedron::hull_with_flatness(points, flatness),
        };
        let polyhedron = polyhedron.map_err(|e| self.refused_mesh(&mesh, &e))?;
        let body = if spec.radius == 0.0 { polyhedron.body() } else { polyhedron.offset(spec.radius) };
        let body = body.map_err(|e| self.refused_mesh(&mesh, &e))?;
        let place = mesh.file.clone().or_else(|| self.place_of([Step::from(mesh.field)]));
        let warnings = polyhedron.warnings().into_iter();
        self.remarks.extend(warnings.map(|warning| Remark { place: place.clone(), ..warning.into() }));
        let moved = polyhedron.deviation();
        let rounded = RoundedPolyhedron { polyhedron, radius: spec.radius, moved };
        self.facts = Facts::RoundedPolyhedron(Box::new(rounded));
        Ok(vec![SurfaceObject::Body(body)])
    }

    fn polyhedron_mesh(&mut self, spec: &SmoothPolyhedronSpec) -> Result<Mesh> {
        match (&spec.mesh, &spec.points, &spec.vertices, &spec.faces) {
            (Some(file), None, None, None) => self.polyhedron_file(file),
            (None, Some(source), None, None) => {
                if spec.hull {
                    return Err(self.unfit("`hull` requires `mesh`, or `vertices` and `faces`: for `points` the hull is always used"));
                }
                let points = match source {
                    PointSource::Inline(lists) => inline_points(lists),
                    PointSource::File(file) => self.file_points(file)?,
                };
                let points = points.lists.into_iter().flat_map(|list| list.points).collect();
                Ok(Mesh { points, faces: None, flatness: None, field: "points", file: None })
            }
            (None, None, Some(vertices), Some(faces)) => {
                let count = vertices.len();
                for (index, corners) in faces.iter().enumerate() {
                    if let Some(place) = corners.iter().position(|v| *v as usize >= count) {
                        let words = format!(
                            "face {index} refers to vertex {}, but there are {count} vertices, numbered from 0",
                            corners[place]
                        );
                        let steps: [Step; 3] = ["faces".into(), index.into(), place.into()];
                        return Err(self.refused_in_words(steps, "not-a-face", words));
                    }
                }
                let face = |corners: &Vec<u32>| corners.iter().map(|&v| v as usize).collect();
                let points = vertices.iter().map(|p| p.point()).collect();
                let faces = Some(faces.iter().map(face).collect());
                Ok(Mesh { points, faces, flatness: None, field: "faces", file: None })
            }
            _ => Err(self.unfit(
                "a polyhedron requires exactly one of `mesh` (a file), `points` (their convex hull), or `vertices` with `faces`",
            )),
        }
    }

    /// The mesh of a file; corners at the same place are one, and triangles without area left out.
    fn polyhedron_file(&mut self, file: &PolygonMeshFile) -> Result<Mesh> {
        let (name, given) = self.mesh_of_file(file)?;
        let (points, faces) = welded(&given.points, &given.faces);
        let largest = points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        // Formats whose numbers have single precision.
        let single = file.format.entry().is_single;
        let flatness = single.then_some(SINGLE * largest);
        Ok(Mesh { points, faces: Some(faces), flatness, field: "mesh", file: Some(name) })
    }

    /// The message for what the kernel said about the polyhedron.
    fn refused_mesh(&self, mesh: &Mesh, error: &KernelError) -> Error {
        let few_digits = match *error {
            KernelError::Polyhedron(PolyhedronError::NotConvex { angle, .. }) => angle > -FEW_DIGITS,
            KernelError::Polyhedron(
                PolyhedronError::NonPlanarFace { distance, .. } | PolyhedronError::PlanesMissPoint { distance, .. },
            ) => {
                let size = cyclide::Aabb::of_points(mesh.points.iter().copied()).map_or(0.0, |b| b.diagonal());
                distance < FEW_DIGITS * size
            }
            _ => false,
        };
        let mut words = error.to_string();
        if let (
            Some(file),
            &KernelError::Polyhedron(
                PolyhedronError::NotConvex { first, second, .. } | PolyhedronError::NotClosed { first, second, .. },
            ),
        ) = (&mesh.file, error)
        {
            let at = |k: usize| {
                let p = mesh.points.get(k).map(|p| p.to_array().map(|x| ShortNumber(x).to_string()).join(", "));
                format!("({})", p.unwrap_or_default())
            };
            words += &format!(" (of {file}: {} and {})", at(first), at(second));
        }
        let is_shape = matches!(
            error,
            KernelError::Polyhedron(
                PolyhedronError::NotConvex { .. }
                    | PolyhedronError::NotAFace { .. }
                    | PolyhedronError::NonPlanarFace { .. }
                    | PolyhedronError::PlanesMissPoint { .. }
            )
        );
        if mesh.faces.is_none() && is_shape {
            words += "; the hull of the points has no plane faces within this `flatness`: set it to the rounding of the points";
        } else if few_digits {
            words += "; if the coordinates have few digits, set `flatness` to their rounding";
        } else if matches!(error, KernelError::Polyhedron(PolyhedronError::NotConvex { .. })) {
            words += "; or use `\"hull\": true` for the convex hull";
        }
        let steps: Vec<Step> = match *error {
            KernelError::Number(
                NumberError::RadiusNotPositive { .. }
                | NumberError::ParameterOutOfRange { name: ErrorItem::Radius, .. },
            )
            | KernelError::Point(PointError::BelowRoundingOfPlace { what: ErrorItem::Radius, .. }) => {
                vec!["radius".into()]
            }
            KernelError::Number(NumberError::ParameterOutOfRange { name: ErrorItem::Flatness, .. }) => {
                vec!["flatness".into()]
            }
            KernelError::Polyhedron(PolyhedronError::NotAFace { face, .. }) if mesh.field == "faces" => {
                vec!["faces".into(), face.into()]
            }
            _ => vec![mesh.field.into()],
        };
        if self.document.text.is_empty() {
            return self.refused_at(steps, error);
        }
        self.refused_in_words(steps, error.reason(), words)
    }
}

/// The mesh with one point for all that are equal, and without corners that repeat the one before.
fn welded(points: &[Point3], faces: &[Vec<usize>]) -> (Vec<Point3>, Vec<Vec<usize>>) {
    let (kept, same) = distinct(points);
    let face = |corners: &Vec<usize>| {
        let mut corners: Vec<usize> = corners.iter().map(|&v| same[v]).collect();
        corners.dedup();
        while corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        corners
    };
    let faces = faces.iter().map(face).filter(|corners| corners.len() > 2).collect();
    (kept, faces)
}
