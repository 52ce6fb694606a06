//! Convex polyhedra: their faces, edges and measures, and their smooth offsets.

mod convex;
mod deviation;
mod distinct;
mod faces;
mod groups;
mod hull;
mod merge;
mod of_points;
mod offset;
mod plane;
mod spherical_polygon;

pub use spherical_polygon::SphericalPolygon;

use crate::base::bounds::Aabb;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, PointError, PolyhedronError, Result};
use crate::warning::{PolyhedronWarning, Warning};
use deviation::Surface;
use faces::{FaceSide, Faces};
use plane::area_vector;

/// Corners are in the plane of their face, and faces in one plane, within this part of the diameter.
const PLANAR: f64 = 1e-9;
/// Points within this part of the flatness are one in a hull: what is left of it is for the planes.
const TOGETHER: f64 = 0.5;
/// Edges that bend by less, radians, speak of few digits.
const SHALLOW: f64 = 1e-3;

/// A convex polyhedron: planar faces, each a loop of vertices that is counter-clockwise from outside.
///
/// ```
/// use cyclide::{Point3, construct::ConvexPolyhedron};
/// let cube: Vec<Point3> = (0..8).map(|k| Point3::new((k & 1) as f64, (k >> 1 & 1) as f64, (k >> 2) as f64)).collect();
/// let cube = ConvexPolyhedron::hull(&cube)?;
/// assert!((cube.volume() - 1.0).abs() < 1e-15);
/// assert!((cube.offset(0.2)?.outer.volume() - cube.offset_volume(0.2)).abs() < 1e-12); // Steiner
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ConvexPolyhedron {
    vertices: Vec<Point3>,
    faces: Faces,
    normals: Vec<Vec3>,
    /// The sides that start at each vertex, counter-clockwise from outside.
    fans: Vec<Vec<FaceSide>>,
    /// The normals round each vertex.
    cones: Vec<Option<SphericalPolygon>>,
    /// Within which corners are in one plane.
    flatness: f64,
    deviation: f64,
    /// What was remarked of it when it was made.
    remarked: Option<Warning>,
}

/// An edge of a polyhedron.
///
/// ```
/// use cyclide::{Point3, construct::ConvexPolyhedron};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let tetrahedron = ConvexPolyhedron::hull(&corners)?;
/// assert_eq!(tetrahedron.edges().filter(|edge| edge.length > 1.2).count(), 3);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolyhedronEdge {
    /// Its ends, in the direction in which the first face runs along it.
    pub ends: [usize; 2],
    /// The two faces.
    pub faces: [usize; 2],
    /// Length.
    pub length: f64,
    /// Angle between the outer normals of the faces, radians, in (0, pi).
    pub angle: f64,
}

impl ConvexPolyhedron {
    /// The polyhedron with these faces, loops of vertices counter-clockwise from outside, planar within 1e-9 of the diameter. Faces
    /// in one plane, such as the triangles of a side, become one; vertices move by as much as that takes.
    ///
    /// # Errors
    /// As [`with_flatness`](Self::with_flatness).
    pub fn new(vertices: &[Point3], faces: &[Vec<usize>]) -> Result<Self> {
        let diameter = Aabb::of_points(vertices.iter().copied()).map_or(0.0, Aabb::diagonal);
        Self::with_flatness(vertices, faces, PLANAR * diameter)
    }

    /// As [`new`](Self::new), with the distance within which corners are in one plane: that of the digits of the coordinates where
    /// these are few. No given point is farther from the surface than it, nor a corner of the surface from the given faces. Faces
    /// join a plane only if their normals agree with it, or if they are all that is left between it and another one.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates), `below-rounding-of-place`, `not-a-face`, `not-closed` (an edge
    /// without a face on each side), `not-a-shell` (several parts, or parts that touch in a point), `non-planar-face`,
    /// `planes-miss-point` (the planes leave a point farther than the flatness), `flat-polyhedron`, `not-convex` (an edge is reflex, or faces are clockwise from outside), `not-in-open-hemisphere` (faces
    /// wind round a vertex).
    pub fn with_flatness(vertices: &[Point3], faces: &[Vec<usize>], flatness: f64) -> Result<Self> {
        let made = Self::of_faces(vertices, faces, flatness)?;
        let short = made.short_edges();
        Ok(Self { remarked: made.remarked.or(short), ..made })
    }

    /// As [`with_flatness`](Self::with_flatness), without a word about short edges: of hulls points that near are one.
    fn of_faces(vertices: &[Point3], faces: &[Vec<usize>], flatness: f64) -> Result<Self> {
        check_points(vertices)?;
        if !(flatness >= 0.0 && flatness.is_finite()) {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::Flatness,
                value: flatness,
                min: 0.0,
                max: f64::MAX,
            }
            .into());
        }
        let given = Faces::new(faces.to_vec(), vertices.len())?;
        let fans = given.fans(vertices.len())?;
        plane::check_planar(vertices, given.loops(), flatness)?;
        let group = groups::groups(vertices, &given, flatness);
        let loops = merge::merged(vertices, &given, &group, flatness)?;
        let made = Self::of_sides(vertices, loops, flatness)?;
        let surface = Surface { points: &made.vertices, faces: &made.faces };
        let (vertex, deviation) =
            deviation::farthest(Surface { points: vertices, faces: &given }, surface, &group, &fans);
        let limit = flatness.max(plane::rounding(vertices));
        if !(deviation <= limit) {
            return Err(PolyhedronError::PlanesMissPoint { vertex, distance: deviation, limit }.into());
        }
        Ok(Self { deviation, ..made })
    }

    /// From loops of which no two are in one plane.
    fn of_sides(vertices: &[Point3], loops: Vec<Vec<usize>>, flatness: f64) -> Result<Self> {
        let faces = Faces::new(loops, vertices.len())?;
        let vertices = plane::made_planar(vertices, faces.loops())?;
        let normal = |(face, corners): (usize, &Vec<usize>)| {
            let normal = area_vector(&vertices, corners).unit();
            normal.ok_or(Error::Polyhedron(PolyhedronError::NotAFace { face, detail: "its corners are on a line" }))
        };
        let normals: Vec<Vec3> = faces.loops().iter().enumerate().map(normal).collect::<Result<_>>()?;
        convex::check_edges(&vertices, &faces, &normals)?;
        convex::check_faces(&vertices, &faces, &normals, flatness)?;
        let fans = faces.fans(vertices.len())?;
        let cones = convex::normal_polygons(&vertices, &faces, &fans, &normals)?;
        Ok(Self { vertices, faces, normals, fans, cones, flatness, deviation: 0.0, remarked: None })
    }

    /// The distance within which corners count as in one plane.
    #[must_use]
    pub fn flatness(&self) -> f64 {
        self.flatness
    }

    /// How far the surface is from what it was made from, at most: points that faces had from it, and its corners from these faces.
    /// Not more than the [flatness](Self::flatness), or rounding.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.deviation
    }

    /// What should be known of it: `flatness-raised`, `flatness-lowered`, `short-edges`, `shallow-edges`.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        self.remarked.iter().cloned().chain(self.shallow_edges()).collect()
    }

    /// Edges at which hardly any angle is left.
    fn shallow_edges(&self) -> Option<Warning> {
        let shallow: Vec<PolyhedronEdge> = self.edges().filter(|edge| edge.angle < SHALLOW).collect();
        let least = shallow.iter().min_by(|a, b| a.angle.total_cmp(&b.angle))?;
        let off = shallow.iter().map(|edge| self.off_neighbor(edge)).fold(0.0, f64::max);
        Some(Warning::Polyhedron(PolyhedronWarning::ShallowEdges {
            ends: least.ends,
            count: shallow.len(),
            angle: least.angle,
            limit: SHALLOW,
            off,
        }))
    }

    /// Edges so short that they are one point of a hull.
    fn short_edges(&self) -> Option<Warning> {
        let limit = (TOGETHER * self.flatness).max(plane::rounding(&self.vertices));
        let short: Vec<PolyhedronEdge> = self.edges().filter(|edge| edge.length <= limit).collect();
        let least = short.iter().min_by(|a, b| a.length.total_cmp(&b.length))?;
        Some(Warning::Polyhedron(PolyhedronWarning::ShortEdges {
            ends: least.ends,
            count: short.len(),
            length: least.length,
            limit,
        }))
    }

    /// How far the corners of the smaller face of an edge are below the plane of the other one: the less of both ways.
    fn off_neighbor(&self, edge: &PolyhedronEdge) -> f64 {
        let [a, b] = edge.faces;
        let start = self.vertices[edge.ends[0]];
        let below = |face: usize, other: usize| {
            let corners = self.faces.loops()[face].iter();
            corners.map(|&v| (self.vertices[v] - start).dot(self.normals[other]).abs()).fold(0.0, f64::max)
        };
        below(a, b).min(below(b, a))
    }

    /// The vertices, in the order of those given.
    #[must_use]
    pub fn vertices(&self) -> &[Point3] {
        &self.vertices
    }

    /// The faces: loops of vertices, counter-clockwise from outside.
    #[must_use]
    pub fn faces(&self) -> &[Vec<usize>] {
        self.faces.loops()
    }

    /// The outer unit normals of the faces.
    #[must_use]
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }

    /// Every edge once.
    pub fn edges(&self) -> impl Iterator<Item = PolyhedronEdge> + '_ {
        self.faces.edges().map(|at| {
            let ends = self.faces.ends(at);
            let faces = [at.face, self.faces.across(at).face];
            let [from, to] = ends.map(|v| self.vertices[v]);
            let angle = convex::edge_angle(&self.vertices, &self.faces, at, faces.map(|face| self.normals[face]));
            PolyhedronEdge { ends, faces, length: from.distance(to), angle }
        })
    }

    /// How many vertices are corners of faces.
    #[must_use]
    pub fn corner_count(&self) -> usize {
        self.cones.iter().flatten().count()
    }

    /// The outer normals of the faces round a vertex as a polygon on the unit sphere, with the middle of its outline as apex; `None`
    /// for a vertex that no face has.
    #[must_use]
    pub fn normal_cone(&self, vertex: usize) -> Option<&SphericalPolygon> {
        self.cones.get(vertex)?.as_ref()
    }

    /// Volume: of the pyramids over the faces from the first vertex.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let Some(&tip) = self.faces.loops().first().and_then(|corners| corners.first()) else { return 0.0 };
        let pyramid = |corners: &Vec<usize>| {
            let height = corners.first().map_or(Vec3::ZERO, |&v| self.vertices[v] - self.vertices[tip]);
            area_vector(&self.vertices, corners).dot(height) / 6.0
        };
        self.faces.loops().iter().map(pyramid).sum()
    }

    /// Surface area.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.faces.loops().iter().map(|corners| 0.5 * area_vector(&self.vertices, corners).length()).sum()
    }

    /// The integral of the mean curvature: half the sum of the lengths of the edges, each times its angle.
    #[must_use]
    pub fn mean_curvature(&self) -> f64 {
        0.5 * self.edges().map(|edge| edge.length * edge.angle).sum::<f64>()
    }

    /// The largest height of a point in a direction, a vector of any length: the support function, times that length.
    #[must_use]
    pub fn support(&self, direction: Vec3) -> f64 {
        let corners = self.vertices.iter().zip(&self.cones).filter(|(_, cone)| cone.is_some());
        corners.map(|(p, _)| p.to_vec().dot(direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Volume of the offset by Steiner's formula: `V + A r + M r² + 4 pi r³/3`.
    #[must_use]
    pub fn offset_volume(&self, radius: f64) -> f64 {
        let ball = 4.0 / 3.0 * std::f64::consts::PI;
        self.volume() + radius * (self.area() + radius * (self.mean_curvature() + radius * ball))
    }

    /// Area of the offset by Steiner's formula: `A + 2 M r + 4 pi r²`.
    #[must_use]
    pub fn offset_area(&self, radius: f64) -> f64 {
        self.area() + radius * (2.0 * self.mean_curvature() + 4.0 * std::f64::consts::PI * radius)
    }
}

/// Refuses points that are not numbers, or too close together for their place.
fn check_points(points: &[Point3]) -> Result<()> {
    if points.len() < 4 {
        return Err(PointError::TooFewPoints { given: points.len(), needed: 4 }.into());
    }
    for (index, p) in points.iter().enumerate() {
        range::check_point(index, p.to_vec())?;
    }
    range::check_place(ErrorItem::Polyhedron, points)
}
