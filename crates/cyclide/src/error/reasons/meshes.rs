//! What is refused of triangles and of meshes of them.
//!
//! # `degenerate-triangle`
//! The corners of a triangle are on a line.
//! ```
//! use cyclide::{Point3, SphereBlend};
//! let line = [0.0, 1.0, 3.0].map(|x| Point3::new(x, 0.0, 0.0));
//! let error = SphereBlend::from_control_points(line, [Point3::new(0.0, 1.0, 1.0); 3]).unwrap_err();
//! assert_eq!(error.reason(), "degenerate-triangle");
//! ```
//!
//! # `control-point-on-circumcircle`
//! A control point lies on the circle through the corners, which all spheres through them share.
//! ```
//! use cyclide::{Point3, SphereBlend};
//! let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
//! let control = [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
//! let error = SphereBlend::from_control_points(corners, control).unwrap_err();
//! assert_eq!(error.reason(), "control-point-on-circumcircle");
//! ```
//!
//! # `opposite-spheres`
//! The spheres of two corners cancel each other half way between them.
//! ```
//! use cyclide::{Point3, SphereBlend};
//! let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
//! let poles = [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]].map(Point3::from);
//! assert_eq!(SphereBlend::from_control_points(corners, poles)?.whole().unwrap_err().reason(), "opposite-spheres");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `normal-along-edge`
//! A normal runs along an edge that it should be across.
//! ```
//! use cyclide::{Point3, SmoothTriangle, Vec3};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let error = SmoothTriangle::new(corners, [Vec3::X, Vec3::Z, Vec3::Z]).unwrap_err();
//! assert_eq!(error.reason(), "normal-along-edge");
//! ```
//!
//! # `opposite-normals`
//! The normals at the ends of an edge cancel each other between them.
//! ```
//! use cyclide::{Point3, SmoothTriangle, Vec3};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let error = SmoothTriangle::new(corners, [-Vec3::Z, Vec3::Z, Vec3::Z]).unwrap_err();
//! assert_eq!(error.reason(), "opposite-normals");
//! ```
//!
//! # `undefined-normal`
//! A normal has no length, or the faces round a vertex lie back to back.
//! ```
//! use cyclide::{Point3, SmoothMesh, VertexNormals};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let error = SmoothMesh::new(&points, &[[0, 1, 2], [0, 2, 1]], VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "undefined-normal");
//! ```
//!
//! # `no-triangles`
//! A mesh has no triangle.
//! ```
//! use cyclide::{Point3, SmoothMesh, VertexNormals};
//! let error = SmoothMesh::new(&[Point3::ORIGIN], &[], VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "no-triangles");
//! ```
//!
//! # `no-such-vertex`
//! A triangle names a vertex that is not there.
//! ```
//! use cyclide::{Point3, SmoothMesh, VertexNormals};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let error = SmoothMesh::new(&points, &[[0, 1, 3]], VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "no-such-vertex");
//! ```
//!
//! # `non-manifold-edge`
//! Three triangles share an edge.
//! ```
//! use cyclide::{Point3, SmoothMesh, VertexNormals};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
//! let fins = [[0, 1, 2], [1, 0, 3], [0, 1, 4]];
//! let error = SmoothMesh::new(&points, &fins, VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "non-manifold-edge");
//! ```
//!
//! # `inconsistent-orientation`
//! Two neighbouring triangles are seen from different sides.
//! ```
//! use cyclide::{Point3, SmoothMesh, VertexNormals};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]].map(Point3::from);
//! let error = SmoothMesh::new(&points, &[[0, 1, 2], [0, 1, 3]], VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "inconsistent-orientation");
//! ```
