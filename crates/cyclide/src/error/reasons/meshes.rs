//! Errors about triangles and of meshes of them.
//!
//! # `degenerate-triangle`
//! The corners of a triangle lie on a line.
//! ```
//! use cyclide::{Point3, surface::SphereBlend};
//! let line = [0.0, 1.0, 3.0].map(|x| Point3::new(x, 0.0, 0.0));
//! let error = SphereBlend::from_control_points(line, [Point3::new(0.0, 1.0, 1.0); 3]).unwrap_err();
//! assert_eq!(error.reason(), "degenerate-triangle");
//! ```
//!
//! # `control-point-on-circumcircle`
//! A control point lies on the circle through the corners, which all spheres through them share.
//! ```
//! use cyclide::{Point3, surface::SphereBlend};
//! let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
//! let control = [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
//! let error = SphereBlend::from_control_points(corners, control).unwrap_err();
//! assert_eq!(error.reason(), "control-point-on-circumcircle");
//! ```
//!
//! # `opposite-spheres`
//! The spheres of two corners cancel halfway between them.
//! ```
//! use cyclide::{Point3, surface::SphereBlend};
//! let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
//! let poles = [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]].map(Point3::from);
//! assert_eq!(SphereBlend::from_control_points(corners, poles)?.whole().unwrap_err().reason(), "opposite-spheres");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `normal-along-edge`
//! A normal runs along an edge to which it should be perpendicular.
//! ```
//! use cyclide::{Point3, Vec3, surface::SmoothTriangle};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let error = SmoothTriangle::new(corners, [Vec3::X, Vec3::Z, Vec3::Z]).unwrap_err();
//! assert_eq!(error.reason(), "normal-along-edge");
//! ```
//!
//! # `opposite-normals`
//! The normals at the ends of an edge cancel between them.
//! ```
//! use cyclide::{Point3, Vec3, surface::SmoothTriangle};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let error = SmoothTriangle::new(corners, [-Vec3::Z, Vec3::Z, Vec3::Z]).unwrap_err();
//! assert_eq!(error.reason(), "opposite-normals");
//! ```
//!
//! # `undefined-normal`
//! A normal has no length, or the normals of the faces round a vertex cancel.
//! ```
//! use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let error = SmoothMesh::new(&points, &[[0, 1, 2], [0, 2, 1]], VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "undefined-normal");
//! ```
//!
//! # `no-triangles`
//! A mesh has no triangle.
//! ```
//! use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
//! let error = SmoothMesh::new(&[Point3::ORIGIN], &[], VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "no-triangles");
//! ```
//!
//! # `no-such-vertex`
//! A triangle refers to a vertex that does not exist.
//! ```
//! use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let error = SmoothMesh::new(&points, &[[0, 1, 3]], VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "no-such-vertex");
//! ```
//!
//! # `non-manifold-edge`
//! Three triangles share an edge.
//! ```
//! use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
//! let fins = [[0, 1, 2], [1, 0, 3], [0, 1, 4]];
//! let error = SmoothMesh::new(&points, &fins, VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "non-manifold-edge");
//! ```
//!
//! # `inconsistent-orientation`
//! Two neighboring triangles have opposite orientations.
//! ```
//! use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]].map(Point3::from);
//! let error = SmoothMesh::new(&points, &[[0, 1, 2], [0, 1, 3]], VertexNormals::AngleWeighted).unwrap_err();
//! assert_eq!(error.reason(), "inconsistent-orientation");
//! ```
//!
//! # `cells-unfit`
//! The quads of a grid go all round one that is outside.
//! ```
//! use cyclide::{Point3, surface::{GridCell, QuadGrid}};
//! let points = (0..16).map(|k| Point3::new(f64::from(k % 4), f64::from(k / 4), 0.0)).collect();
//! let hole = |i, j| if (i, j) == (1, 1) { GridCell::Outside } else { GridCell::Patch };
//! let error = QuadGrid::new(points, [4, 4], [false; 2])?.with_cells(hole).unwrap_err();
//! assert_eq!(error.reason(), "cells-unfit");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-a-quad-layout`
//! The quads round an extraordinary vertex reach the border.
//! ```
//! use cyclide::{Point3, surface::QuadLayout};
//! let points = (0..7).map(|k| Point3::new(f64::from(k), f64::from(k * k), 0.0)).collect();
//! let error = QuadLayout::new(points, &[[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]]).unwrap_err();
//! assert_eq!(error.reason(), "not-a-quad-layout");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `ring-does-not-close`
//! Quads of a cube round its corner have circles, but the three sides are not one smooth surface.
//! ```
//! use cyclide::{Point3, surface::{NetLayout, QuadLayout}};
//! let (mut points, mut quads) = (Vec::<[i32; 3]>::new(), Vec::new());
//! for k in 0..27 {
//!     let (i, a, b) = (k / 9, (k % 3) as i32, (k / 3 % 3) as i32);
//!     quads.push([(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)].map(|(a, b)| {
//!         let mut p = [3; 3];
//!         (p[i], p[(i + 1) % 3]) = (3 - a, 3 - b);
//!         points.iter().position(|q| *q == p).unwrap_or_else(|| { points.push(p); points.len() - 1 })
//!     }));
//! }
//! let points = points.iter().map(|p| Point3::from(p.map(f64::from))).collect();
//! let error = NetLayout::new(QuadLayout::new(points, &quads)?).unwrap_err();
//! assert_eq!(error.reason(), "ring-does-not-close");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-a-surface`
//! Triangles for a grid along lines of curvature meet in a vertex alone.
//! ```
//! use cyclide::Point3;
//! use cyclide_grids::{PrincipalGridOptions, principal_grids};
//! let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
//! let options = PrincipalGridOptions::new(0.1);
//! let error = principal_grids(&points, &[[0, 1, 2], [0, 3, 4]], &options).unwrap_err();
//! assert_eq!(error.reason(), "not-a-surface");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `flat-surface`
//! A plane has no lines of curvature.
//! ```
//! use cyclide::Point3;
//! use cyclide_grids::{PrincipalGridOptions, principal_grids};
//! let roof = |height: fn(f64, f64) -> f64| {
//!     let at = |k: usize| (0.25 * (k % 17) as f64 - 2.0, 0.25 * (k / 17) as f64 - 2.0);
//!     (0..289).map(at).map(|(x, y)| Point3::new(x, y, height(x, y))).collect::<Vec<_>>()
//! };
//! let quads = (0..16).flat_map(|j| (0..16).map(move |i| 17 * j + i));
//! let triangles: Vec<[usize; 3]> = quads.flat_map(|a| [[a, a + 1, a + 18], [a, a + 18, a + 17]]).collect();
//! let plane = roof(|x, y| 0.1 * x + 0.2 * y);
//! let error = principal_grids(&plane, &triangles, &PrincipalGridOptions::new(0.4)).unwrap_err();
//! assert_eq!(error.reason(), "flat-surface");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `umbilics-remain`
//! One grid is asked for on a round dome, whose lines of curvature all meet in its top.
//! ```
//! use cyclide::Point3;
//! use cyclide_grids::{PrincipalGridOptions, principal_grids};
//! let roof = |height: fn(f64, f64) -> f64| {
//!     let at = |k: usize| (0.25 * (k % 17) as f64 - 2.0, 0.25 * (k / 17) as f64 - 2.0);
//!     (0..289).map(at).map(|(x, y)| Point3::new(x, y, height(x, y))).collect::<Vec<_>>()
//! };
//! let quads = (0..16).flat_map(|j| (0..16).map(move |i| 17 * j + i));
//! let triangles: Vec<[usize; 3]> = quads.flat_map(|a| [[a, a + 1, a + 18], [a, a + 18, a + 17]]).collect();
//! let dome = roof(|x, y| (16.0 - x * x - y * y + 0.1 * (x * x + y * y).powi(2)).sqrt());
//! let mut options = PrincipalGridOptions::new(0.4);
//! options.umbilics = cyclide_grids::UmbilicRule::Smooth;
//! let error = principal_grids(&dome, &triangles, &options).unwrap_err();
//! assert_eq!(error.reason(), "umbilics-remain");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `spiral-lines`
//! The lines of curvature of a twisted tube come back higher than an edge.
//! ```
//! use cyclide::Point3;
//! use cyclide_grids::{PrincipalGridOptions, principal_grids};
//! use std::f64::consts::TAU;
//! let at = |k: usize| (TAU / 48.0 * (k % 48) as f64, (k / 48) as f64 / 24.0);
//! let tube = (0..48 * 25).map(at).map(|(u, v)| {
//!     let (x, y, (sine, cosine)) = (3.0 * u.cos(), 2.0 * u.sin(), (1.2 * v).sin_cos());
//!     Point3::new(x * cosine - y * sine, x * sine + y * cosine, 6.0 * v)
//! });
//! let quads = (0..24 * 48).map(|k| [k, k / 48 * 48 + (k + 1) % 48]);
//! let triangles: Vec<[usize; 3]> = quads.flat_map(|[a, b]| [[a, b, b + 48], [a, b + 48, a + 48]]).collect();
//! let tube: Vec<Point3> = tube.collect();
//! let error = principal_grids(&tube, &triangles, &PrincipalGridOptions::new(0.3)).unwrap_err();
//! assert_eq!(error.reason(), "spiral-lines");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `no-grid`
//! Three by three cells are larger than the surface.
//! ```
//! use cyclide::Point3;
//! use cyclide_grids::{PrincipalGridOptions, principal_grids};
//! let roof = |height: fn(f64, f64) -> f64| {
//!     let at = |k: usize| (0.25 * (k % 17) as f64 - 2.0, 0.25 * (k / 17) as f64 - 2.0);
//!     (0..289).map(at).map(|(x, y)| Point3::new(x, y, height(x, y))).collect::<Vec<_>>()
//! };
//! let quads = (0..16).flat_map(|j| (0..16).map(move |i| 17 * j + i));
//! let triangles: Vec<[usize; 3]> = quads.flat_map(|a| [[a, a + 1, a + 18], [a, a + 18, a + 17]]).collect();
//! let saddle = roof(|x, y| 0.1 * (x * x - y * y));
//! let error = principal_grids(&saddle, &triangles, &PrincipalGridOptions::new(1.5)).unwrap_err();
//! assert_eq!(error.reason(), "no-grid");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `umbilics-not-joined`
//! One mesh of quads shall go on through umbilics, which the surface, or its mesh, is not made for: here it has a hole beside one.
//! ```
//! use cyclide::Point3;
//! use cyclide_grids::{PrincipalGridOptions, UmbilicRule, principal_grids};
//! let at = |k: usize| (0.25 * (k % 17) as f64 - 2.0, 0.25 * (k / 17) as f64 - 2.0);
//! let monkey = |(x, y): (f64, f64)| Point3::new(x, y, 0.05 * (x * x * x - 3.0 * x * y * y));
//! let points: Vec<Point3> = (0..289).map(at).map(monkey).collect();
//! let quads = (0..16).flat_map(|j| (0..16).map(move |i| 17 * j + i)).filter(|a| *a != 3 * 17 + 3);
//! let triangles: Vec<[usize; 3]> = quads.flat_map(|a| [[a, a + 1, a + 18], [a, a + 18, a + 17]]).collect();
//! let options = PrincipalGridOptions { umbilics: UmbilicRule::Joined, ..PrincipalGridOptions::new(0.4) };
//! let error = principal_grids(&points, &triangles, &options).unwrap_err();
//! assert_eq!(error.reason(), "umbilics-not-joined");
//! ```
//! # `field-not-orientable`
//! One grid is asked for round a hole in which the lines of curvature make half a turn: those of a monkey saddle do so round its middle.
//! ```
//! use cyclide::Point3;
//! use cyclide_grids::{PrincipalGridOptions, principal_grids};
//! let roof = |height: fn(f64, f64) -> f64| {
//!     let at = |k: usize| (0.25 * (k % 17) as f64 - 2.0, 0.25 * (k / 17) as f64 - 2.0);
//!     (0..289).map(at).map(|(x, y)| Point3::new(x, y, height(x, y))).collect::<Vec<_>>()
//! };
//! let quads = (0..16).flat_map(|j| (0..16).map(move |i| 17 * j + i));
//! let triangles: Vec<[usize; 3]> = quads.flat_map(|a| [[a, a + 1, a + 18], [a, a + 18, a + 17]]).collect();
//! let monkey = roof(|x, y| 0.05 * (x * x * x - 3.0 * x * y * y) + 0.1 * (x * x - y * y));
//! // An umbilic lies where the second derivatives vanish: at x = -2/3.
//! let triangles: Vec<[usize; 3]> = triangles.into_iter().filter(|t| {
//!     t.iter().any(|v| (monkey[*v].x + 0.67).hypot(monkey[*v].y) > 0.8)
//! }).collect();
//! let mut options = PrincipalGridOptions::new(0.4);
//! options.umbilics = cyclide_grids::UmbilicRule::Smooth;
//! let error = principal_grids(&monkey, &triangles, &options).unwrap_err();
//! assert_eq!(error.reason(), "field-not-orientable");
//! # Ok::<(), cyclide::Error>(())
//! ```
