//! Errors about patches, nets, their offsets and shells, and of quads that are to be made circular.
//!
//! # `not-concircular`
//! The corners of a quad do not lie on one circle.
//! ```
//! use cyclide::{Point3, Vec3, surface::CyclidePatch};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.2]].map(Point3::from);
//! let error = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y).unwrap_err();
//! assert_eq!(error.reason(), "not-concircular");
//! ```
//!
//! # `crossing-quad`
//! The corners of a quad lie on a circle in the wrong order.
//! ```
//! use cyclide::{Point3, Vec3, surface::CyclidePatch};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let error = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y).unwrap_err();
//! assert_eq!(error.reason(), "crossing-quad");
//! ```
//!
//! # `frame-not-orthonormal`
//! The two directions of a frame are not perpendicular.
//! ```
//! use cyclide::{Point3, Vec3, surface::CyclidePatch};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
//! let error = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::new(0.1, 1.0, 0.0)).unwrap_err();
//! assert_eq!(error.reason(), "frame-not-orthonormal");
//! ```
//!
//! # `not-in-space`
//! The weights of a patch take it out of space.
//! ```
//! use cyclide::{Point3, Quat, Vec3, surface::CyclidePatch};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
//! let mut weights = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y)?.weights();
//! weights[3] = weights[3] * Quat::from_axis_angle(Vec3::X, 0.1);
//! let error = CyclidePatch::from_weights(corners, weights, Vec3::X, Vec3::Y).unwrap_err();
//! assert_eq!(error.reason(), "not-in-space");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `patch-through-infinity`
//! A patch contains the point at infinity.
//! ```
//! use cyclide::{Point3, Vec3, surface::CyclidePatch};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
//! let error = CyclidePatch::from_corners_and_frame(corners, -Vec3::X, -Vec3::Y).unwrap_err();
//! assert_eq!(error.reason(), "patch-through-infinity");
//! ```
//!
//! # `edge-circle-through-corner`
//! The circle of a side of a bilinear patch runs through the opposite corner.
//! ```
//! use cyclide::{Point3, Vec3, surface::{CornerTwist, QbPatch}};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5], [2.0, 0.0, 0.0]].map(Point3::from);
//! let directions = [Vec3::X, Vec3::new(0.0, 1.0, 1.0)];
//! let error = QbPatch::from_directions(corners, directions, CornerTwist::Default).unwrap_err();
//! assert_eq!(error.reason(), "edge-circle-through-corner");
//! ```
//!
//! # `twist-not-unique`
//! Corners and directions of a bilinear patch on one sphere or plane leave more than one number free.
//! ```
//! use cyclide::{Point3, Vec3, surface::{CornerTwist, QbPatch}};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
//! let directions = [Vec3::new(1.0, 0.3, 0.0), Vec3::Y];
//! let error = QbPatch::from_directions(corners, directions, CornerTwist::Twist(0.1)).unwrap_err();
//! assert_eq!(error.reason(), "twist-not-unique");
//! assert!(QbPatch::from_directions(corners, directions, CornerTwist::Corner(Vec3::new(0.5, 0.5, 0.0))).is_ok());
//! ```
//!
//! # `arcs-do-not-close`
//! Four arcs bound no patch of circles: a frame carried along them comes back turned.
//! ```
//! use cyclide::{Point3, Vec3, surface::QbPatch};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
//! let tangents = [Vec3::new(1.0, 0.0, 0.3), Vec3::Y, Vec3::Y, Vec3::X];
//! assert_eq!(QbPatch::from_arcs(corners, tangents).unwrap_err().reason(), "arcs-do-not-close");
//! ```
//!
//! # `arcs-need-complement`
//! Four arcs bound a patch of circles only if one of them runs the other way round.
//! ```
//! use cyclide::{Point3, Vec3, surface::QbPatch};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
//! let tangents = [Vec3::X, Vec3::Y, Vec3::Y, -Vec3::X];
//! assert_eq!(QbPatch::from_arcs(corners, tangents).unwrap_err().reason(), "arcs-need-complement");
//! ```
//!
//! # `undetermined-weight`
//! Four arcs leave a weight of the patch free: here they are straight, on a quadric.
//! ```
//! use cyclide::{Point3, Vec3, surface::QbPatch};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0]].map(Point3::from);
//! let tangents = [Vec3::X, Vec3::Y, Vec3::new(0.0, 1.0, 1.0), Vec3::new(1.0, 0.0, 1.0)];
//! assert_eq!(QbPatch::from_arcs(corners, tangents).unwrap_err().reason(), "undetermined-weight");
//! ```
//!
//! # `net-does-not-close`
//! A frame carried round a closed net does not come back to itself: here round a ring of points and its inverse.
//! ```
//! use cyclide::{Point3, Vec3, surface::{CyclidicNet, NetFrame, QuadGrid}};
//! let ring = (0..8).map(|k| {
//!     let phi = std::f64::consts::TAU * f64::from(k) / 8.0;
//!     Vec3::new(phi.cos(), phi.sin(), 0.3 * (2.0 * phi).sin() + 0.2 * phi.cos())
//! });
//! let inverse = ring.clone().map(|v| v * (4.0 / v.length_squared()));
//! let points = ring.chain(inverse).map(|v| Point3::ORIGIN + v).collect();
//! let grid = QuadGrid::new(points, [8, 2], [true, false])?;
//! assert_eq!(CyclidicNet::new(grid, NetFrame::Auto).unwrap_err().reason(), "net-does-not-close");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `ambiguous-frame`
//! No frame fits the edges of the net better than others: here they all lie on one line.
//! ```
//! use cyclide::{Error, Point3, error::PatchError, surface::{CyclidicNet, NetFrame, QuadGrid}};
//! let line = [0.0, 1.0, 3.0, 2.0].map(|x| Point3::new(x, 0.0, 0.0)).to_vec();
//! let grid = QuadGrid::new(line, [2, 2], [false, false])?;
//! let error = CyclidicNet::new(grid, NetFrame::Auto).unwrap_err();
//! assert_eq!(error.reason(), "ambiguous-frame");
//! assert!(matches!(error, Error::Patch(PatchError::AmbiguousFrame { measured, limit }) if measured <= limit));
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `collapsed-side`
//! A side that a rim should stand on is one point.
//! ```
//! use cyclide::surface::DupinCyclide;
//! let horn = DupinCyclide::new(1.0, 0.5, 0.2)?.nets([4, 4])?;
//! assert_eq!(horn[0].thick(0.01).unwrap_err().reason(), "collapsed-side");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `offset-on-focal-set`
//! An offset shrinks the surface to a curve or a point: here a torus by the radius of its tube.
//! ```
//! use cyclide::{Error, error::PatchError, surface::DupinCyclide};
//! let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?;
//! let error = torus[0].patches().next().unwrap().offset(-1.0).unwrap_err();
//! assert_eq!(error.reason(), "offset-on-focal-set");
//! assert!(matches!(error, Error::Patch(PatchError::OffsetOnFocalSet { measured, limit, .. }) if measured <= limit));
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `offset-not-regular`
//! A solid between a surface and its offset would self-intersect.
//! ```
//! use cyclide::{Error, error::{PartError, PatchError}, surface::DupinCyclide};
//! let net = DupinCyclide::new(2.0, 0.7, 1.1)?.nets([4, 4])?;
//! let error = net[0].thick(-1.0).unwrap_err();
//! assert_eq!(error.reason(), "offset-not-regular");
//! // The tube is between 0.4 and 1.8 thick: inwards the first centre of curvature of the quad is met before the distance asked for.
//! let Error::Part(PartError::InQuad { cause, .. }) = error else { unreachable!() };
//! assert!(matches!(*cause, Error::Patch(PatchError::OffsetNotRegular { distance, limit }) if distance < limit && limit <= -0.4));
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-a-shell`
//! Vertices, edges and faces do not form a shell: here there are none.
//! ```
//! use cyclide::topology::Shell;
//! let error = Shell::new(Vec::new(), Vec::new(), Vec::new()).unwrap_err();
//! assert_eq!(error.reason(), "not-a-shell");
//! ```
//!
//! # `short-edge`
//! An edge of a face is so short that other programs treat it as a point.
//! ```
//! use cyclide::surface::DupinCyclide;
//! let nearly_singular = DupinCyclide::new(5.0, 4.999_999_9, 4.999_999_95)?.to_shell()?;
//! assert_eq!(nearly_singular.with_positive_weights().unwrap_err().reason(), "short-edge");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-converged`
//! Quads cannot be made circular: here the border leaves one vertex free for four of them.
//! ```
//! use cyclide::{Point3, surface::QuadGrid};
//! use cyclide_grids::{Border, CircularMeshOptions, make_circular};
//! let points = (0..9).map(|k| (f64::from(k % 3) - 1.0, f64::from(k / 3) - 1.0));
//! let points = points.map(|(u, v)| Point3::new(u, v + 0.2 * u * u, u * v * v)).collect();
//! let grid = QuadGrid::new(points, [3, 3], [false, false])?;
//! let options = CircularMeshOptions { border: Border::Pinned, ..Default::default() };
//! assert_eq!(make_circular(&grid, &options).unwrap_err().reason(), "not-converged");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `shape-lost`
//! A grid made circular is another surface: here most of the bending of a wave is lost, whose curvature lines run across its
//! grid lines.
//! ```
//! use cyclide::{Point3, surface::QuadGrid};
//! use cyclide_grids::{CircularMeshOptions, make_circular};
//! let places = (0..25 * 17).map(|k| (0.5 * f64::from(k % 25), 0.5 * f64::from(k / 25)));
//! let wave = places.map(|(x, y)| Point3::new(x, y, 0.5 * (0.4 * x).sin() * (0.5 * y).cos())).collect();
//! let grid = QuadGrid::new(wave, [25, 17], [false, false])?;
//! let error = make_circular(&grid, &CircularMeshOptions::default()).unwrap_err();
//! assert_eq!(error.reason(), "shape-lost");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `collapsed-on-curve`
//! Vertices of a side coincide on the curve along which they slide: here all are nearest to its end.
//! ```
//! use cyclide::{Point3, curve::Arc, surface::QuadGrid};
//! use cyclide_grids::{Border, CircularMeshOptions, make_circular};
//! let points = (0..9).map(|k| (f64::from(k % 3), f64::from(k / 3)));
//! let points = points.map(|(u, v)| Point3::new(u, v, 0.1 * u * v)).collect();
//! let grid = QuadGrid::new(points, [3, 3], [false, false])?;
//! let behind = Arc::segment(Point3::new(-9.0, 0.0, 0.0), Point3::new(-8.0, 0.0, 0.0))?;
//! let options = CircularMeshOptions { border: Border::OnCurves([Some(&behind), None, None, None]), ..Default::default() };
//! assert_eq!(make_circular(&grid, &options).unwrap_err().reason(), "collapsed-on-curve");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `border-curves-apart`
//! Two curves do not meet near the corner of the grid that should be on both.
//! ```
//! use cyclide::{Point3, curve::Arc, surface::QuadGrid};
//! use cyclide_grids::{Border, CircularMeshOptions, make_circular};
//! let points = (0..9).map(|k| (f64::from(k % 3), f64::from(k / 3)));
//! let points = points.map(|(u, v)| Point3::new(u, v, 0.1 * u * v)).collect();
//! let grid = QuadGrid::new(points, [3, 3], [false, false])?;
//! let row = Arc::segment(Point3::new(-1.0, 0.0, 0.0), Point3::new(3.0, 0.0, 0.0))?;
//! let column = Arc::segment(Point3::new(0.0, -1.0, 9.0), Point3::new(0.0, 3.0, 9.0))?;
//! let border = Border::OnCurves([Some(&row), None, Some(&column), None]);
//! let error = make_circular(&grid, &CircularMeshOptions { border, ..Default::default() }).unwrap_err();
//! assert_eq!(error.reason(), "border-curves-apart");
//! # Ok::<(), cyclide::Error>(())
//! ```
