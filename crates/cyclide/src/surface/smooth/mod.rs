//! Smooth surfaces over triangle meshes: closed without a gap, with a continuous tangent plane.
//!
//! Every edge is a circle blend of order 2 ([`BlendSegment`]) that is made from its two vertices and their normals alone, and carries the normal
//! of the surface with it. Inside a triangle each point is the mean of three blends, from the corners to the opposite sides
//! (`docs/math/triangle-surfaces.md#smooth-meshes`; side-vertex scheme of G. Nielson, 1979). Neighbors share edges and
//! their normals to the bit: G1. The sphere blends of `004` ([`SphereBlend`](super::SphereBlend)) cannot be that on
//! general meshes.
//!
//! - Points and normals of a sphere give the sphere but for 4.3e-4 of its radius over an icosahedron, 1.2e-5 over 80 triangles
//!   and 2.1e-7 over 320.
//! - C1 at the vertices; second derivatives have no limit there. Not rational: files get meshes.
//! - Local: a vertex moves the triangles around it and, by the normals, their neighbors.
//! - Similarities map the surface with its data, other Möbius maps do not.

mod comparison;
mod connect;
mod edge_tangents;
mod faults;
mod loose_borders;
mod measure;
mod normals;
mod pn_triangle;
mod side;
mod similar;
mod triangle;

pub use comparison::SmoothComparison;
pub use measure::SmoothMeasure;
pub(super) use triangle::Jet;
pub use triangle::SmoothTriangle;

use crate::base::vector::{Point3, Vec3};
use crate::curve::{BlendLaw, BlendSegment, Chord};
use crate::error::{ErrorItem, NumberError, Result};
use crate::warning::Warning;
use connect::{Connections, EdgeSide, MeshEdge};
use edge_tangents::EdgeTangents;
use side::{Side, blend};

/// All arcs of these surfaces: their circles differ little, and the order 2 makes the joints of arcs across an edge smooth enough for G1.
const SMOOTH_LAW: BlendLaw = BlendLaw::Trigonometric { order: 2 };

/// Where the normals at the vertices of a mesh come from.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::{SmoothMesh, VertexNormals}};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let radial = corners.map(Point3::to_vec);
/// let octant = SmoothMesh::new(&corners, &[[0, 1, 2]], VertexNormals::Given(&radial))?;
/// assert_eq!(octant.normals(), [Vec3::X, Vec3::Y, Vec3::Z]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum VertexNormals<'a> {
    /// The mean of those of the triangles around a vertex, weighted by their angles there: the same however flat faces are cut into
    /// triangles. On a sphere it is exact by symmetry only, on regular meshes.
    #[default]
    AngleWeighted,
    /// The mean with the weights `sin α/(|a| |b|)`, `a` and `b` being the edges of a triangle at the vertex: exact where all
    /// vertices are on a sphere, and better for meshes of smooth surfaces (N. Max, 1999).
    SphereWeighted,
    /// Means, but where neighboring triangles meet at a larger angle than this (radians, between their normals) the edge is
    /// kept as a crease, with a normal on each side.
    Creased {
        /// Edges with larger angles are creases, radians.
        angle: f64,
        /// How the normals of the triangles between creases are weighted.
        weights: NormalWeights,
    },
    /// One for each vertex, of any length.
    Given(&'a [Vec3]),
    /// One for each corner of each triangle, of any length: an edge at whose ends those of its two triangles differ by more than
    /// 1e-3 radians, the last digit of many files, is a crease. Between creases the mean is taken.
    GivenAtCorners(&'a [[Vec3; 3]]),
}

/// How the normals of the triangles around a vertex are weighted in their mean.
///
/// ```
/// use cyclide::{Point3, surface::{NormalWeights, SmoothMesh, VertexNormals}};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
/// let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]];
/// let normals = VertexNormals::Creased { angle: 0.5, weights: NormalWeights::Angle };
/// let mesh = SmoothMesh::new(&corners.map(Point3::from), &triangles, normals)?;
/// assert!(mesh.is_closed());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NormalWeights {
    /// As [`VertexNormals::AngleWeighted`].
    #[default]
    Angle,
    /// As [`VertexNormals::SphereWeighted`].
    Sphere,
}

/// Which edges are creases.
#[derive(Debug, Clone, Copy)]
enum SharpEdges<'a> {
    None,
    /// Those with larger angles between their triangles, radians.
    Above(f64),
    /// Those at which the normals given for the corners differ.
    Apart(&'a [[Vec3; 3]]),
    /// Those of a mesh with the same triangles, or with all of them turned over: then the last two corners are exchanged.
    Like(&'a SmoothMesh, bool),
}

/// Normals of one corner that differ by more, radians, are two.
const SAME_NORMAL: f64 = 1e-3;

impl SharpEdges<'_> {
    /// Whether the edge with these two sides is one.
    fn includes(&self, [first, second]: [EdgeSide; 2], flat_normals: &[Vec3]) -> bool {
        match self {
            Self::None => false,
            Self::Above(angle) => flat_normals[first.triangle].angle(flat_normals[second.triangle]) > *angle,
            Self::Apart(normals) => {
                let ([a, b], [c, d]) = (first.ends(), second.ends());
                let apart = |(k, l): (usize, usize)| {
                    normals[first.triangle][k].angle(normals[second.triangle][l]) > SAME_NORMAL
                };
                [(a, d), (b, c)].into_iter().any(apart)
            }
            Self::Like(mesh, turned) => {
                let corner = if *turned { (3 - first.corner) % 3 } else { first.corner };
                mesh.edges[mesh.triangle_edges[first.triangle][corner]].sharp
            }
        }
    }
}

/// An edge of a smooth mesh.
///
/// ```
/// use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
/// let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [0.0, 1.0, 0.2], [1.0, 1.0, -0.1]].map(Point3::from);
/// let smooth = SmoothMesh::new(&points, &[[0, 1, 2], [1, 3, 2]], VertexNormals::AngleWeighted)?;
/// assert_eq!(smooth.edges().iter().filter(|edge| edge.triangles().1.is_some()).count(), 1);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothEdge {
    vertices: [usize; 2],
    curve: BlendSegment,
    first: EdgeSide,
    second: Option<EdgeSide>,
    sharp: bool,
}

impl SmoothEdge {
    /// Indices of its ends, the lower one first: there its curve starts.
    #[must_use]
    pub fn vertices(&self) -> [usize; 2] {
        self.vertices
    }

    /// The curve.
    #[must_use]
    pub fn curve(&self) -> &BlendSegment {
        &self.curve
    }

    /// The triangles that share it: one on the boundary of an open mesh.
    #[must_use]
    pub fn triangles(&self) -> (usize, Option<usize>) {
        (self.first.triangle, self.second.map(|side| side.triangle))
    }

    /// Whether the surface keeps a crease there.
    #[must_use]
    pub fn is_sharp(&self) -> bool {
        self.sharp
    }
}

/// A smooth surface through the vertices of a triangle mesh.
///
/// ```
/// use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
/// let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]].map(Point3::from);
/// let faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
/// let smooth = SmoothMesh::new(&corners, &faces, VertexNormals::AngleWeighted)?;
/// assert!(smooth.is_closed() && smooth.tessellate(4)?.faces.len() == 4 * 16);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SmoothMesh {
    positions: Vec<Point3>,
    triangles: Vec<[usize; 3]>,
    /// One for each fan of corners.
    normals: Vec<Vec3>,
    corner_normals: Vec<[usize; 3]>,
    edges: Vec<SmoothEdge>,
    triangle_edges: Vec<[usize; 3]>,
    boundary_corners: usize,
    backward: Option<Warning>,
    /// The normals are means over all triangles of a vertex, and nothing says that it should be so.
    averaged: bool,
}

impl SmoothMesh {
    /// The surface through the vertices `positions`; triangles are three of their indices, counter-clockwise seen from outside.
    /// Vertices that no triangle names are left alone. Time is that of sorting the edges.
    ///
    /// # Errors
    /// `no-triangles`, `no-such-vertex`, `non-manifold-edge` (more than two triangles at an edge), `inconsistent-orientation`
    /// (two that run along it in one direction), `undefined-normal` (faces back to back, a normal of length 0), `count-differs`,
    /// `angle-out-of-range` (of creases: 0 to π), and with the number of the triangle `not-finite`, `parameter-out-of-range` (coordinates
    /// above 1e150), `degenerate-triangle`, `normal-along-edge`, `opposite-normals`, `arc-through-infinity`, `ambiguous-half-turn`.
    pub fn new(positions: &[Point3], triangles: &[[usize; 3]], normals: VertexNormals) -> Result<Self> {
        Self::with_creases(positions, triangles, &normals, &sharp_edges(&normals, triangles.len())?)
    }

    fn with_creases(
        positions: &[Point3],
        triangles: &[[usize; 3]],
        normals: &VertexNormals,
        sharp: &SharpEdges<'_>,
    ) -> Result<Self> {
        let connections = Connections::new(positions, triangles, sharp)?;
        let averaged = matches!(normals, VertexNormals::AngleWeighted);
        let normals = normals::of_fans(positions, triangles, &connections, normals)?;
        let backward = normals::backward(triangles, &connections, &normals);
        let tangents = EdgeTangents::new(positions, triangles, &connections, &normals);
        let edge = |edge: &MeshEdge| {
            let ends = edge.vertices.map(|v| positions[v]);
            let chord = Chord::new(ends[0], ends[1]);
            let curve = tangents.of(edge, &chord).and_then(|tangents| blend(ends, &chord, tangents));
            let MeshEdge { vertices, first, second, sharp } = *edge;
            let edge =
                SmoothEdge { vertices, curve: curve.map_err(|e| e.in_triangle(first.triangle))?, first, second, sharp };
            Ok(edge)
        };
        let edges = connections.edges.iter().map(edge).collect::<Result<Vec<_>>>()?;
        let boundary_corners = tangents.boundary_corners();
        let mesh = Self {
            positions: positions.to_vec(),
            triangles: triangles.to_vec(),
            normals,
            edges,
            corner_normals: connections.fans,
            boundary_corners,
            triangle_edges: connections.triangle_edges,
            backward,
            averaged,
        };
        mesh.check_sides()?;
        Ok(mesh)
    }

    /// Normals that oppose each other at the ends of a side cancel half way.
    fn check_sides(&self) -> Result<()> {
        for edge in &self.edges {
            for side in [Some(edge.first), edge.second].into_iter().flatten() {
                let at = self.side(side).at(0.5, side.corner);
                at.map_err(|e| e.in_triangle(side.triangle))?;
            }
        }
        Ok(())
    }

    /// Vertices.
    #[must_use]
    pub fn positions(&self) -> &[Point3] {
        &self.positions
    }

    /// Triangles as indices of their vertices.
    #[must_use]
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }

    /// Unit normals at vertices, one for each fan of triangles between creases.
    #[must_use]
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }

    /// Triangles as indices of the normals at their corners.
    #[must_use]
    pub fn corner_normals(&self) -> &[[usize; 3]] {
        &self.corner_normals
    }

    /// Edges, by the indices of their vertices.
    #[must_use]
    pub fn edges(&self) -> &[SmoothEdge] {
        &self.edges
    }

    /// Indices of the edges of each triangle, each opposite to the corner of its place.
    #[must_use]
    pub fn triangle_edges(&self) -> &[[usize; 3]] {
        &self.triangle_edges
    }

    /// Whether every edge has two triangles.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.edges.iter().all(|edge| edge.second.is_some())
    }

    /// Vertices at which the boundary turns by more than 60 degrees: it keeps a corner there, and is smooth everywhere else.
    #[must_use]
    pub fn boundary_corners(&self) -> usize {
        self.boundary_corners
    }

    /// The patch over a triangle; `None` beyond the last one. Patches of neighbors agree in the points and normals of their
    /// common edge to the bit, if these are asked for with integers as barycentric coordinates.
    #[must_use]
    pub fn triangle(&self, index: usize) -> Option<SmoothTriangle> {
        (index < self.triangles.len()).then(|| self.patch(index))
    }

    /// The patch over a triangle that there is.
    pub(super) fn patch(&self, index: usize) -> SmoothTriangle {
        let vertices = self.triangles[index];
        let sides = [0, 1, 2].map(|corner| self.side(EdgeSide { triangle: index, corner }));
        let against = [0, 1, 2].map(|corner| vertices[(corner + 1) % 3] > vertices[(corner + 2) % 3]);
        let normals = self.corner_normals[index].map(|n| self.normals[n]);
        SmoothTriangle::from_sides(vertices.map(|v| self.positions[v]), normals, sides, against)
    }

    /// A side of a triangle, its curve from the lower vertex with the normals of that triangle.
    fn side(&self, side: EdgeSide) -> Side {
        let EdgeSide { triangle, corner } = side;
        let edge = &self.edges[self.triangle_edges[triangle][corner]];
        let vertices = self.triangles[triangle];
        let [from, to] = side.ends();
        let ends = if vertices[from] < vertices[to] { [from, to] } else { [to, from] };
        Side { curve: edge.curve, normals: ends.map(|k| self.normals[self.corner_normals[triangle][k]]) }
    }
}

/// # Errors
/// `angle-out-of-range`, `count-differs`, `not-finite`.
fn sharp_edges<'a>(normals: &VertexNormals<'a>, triangles: usize) -> Result<SharpEdges<'a>> {
    match *normals {
        VertexNormals::Creased { angle, .. } => {
            let max = std::f64::consts::PI;
            if !(0.0..=max).contains(&angle) {
                return Err(NumberError::AngleOutOfRange { name: ErrorItem::CreaseAngle, angle, min: 0.0, max }.into());
            }
            Ok(SharpEdges::Above(angle))
        }
        VertexNormals::GivenAtCorners(given) => {
            if given.len() != triangles {
                return Err(NumberError::CountDiffers {
                    what: ErrorItem::Normal,
                    given: 3 * given.len(),
                    needed: 3 * triangles,
                }
                .into());
            }
            match given.as_flattened().iter().position(|normal| !normal.is_finite()) {
                Some(index) => Err(NumberError::NotFinite { what: ErrorItem::Normal, index }.into()),
                None => Ok(SharpEdges::Apart(given)),
            }
        }
        VertexNormals::AngleWeighted | VertexNormals::SphereWeighted | VertexNormals::Given(_) => Ok(SharpEdges::None),
    }
}
