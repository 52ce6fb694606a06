//! `cyclide`: a geometric-modeling kernel whose primitive is the circle.
//!
//! Curves and surfaces are made of circles and are exact: an [`Arc`] is two points and one quaternion, a [`CyclidePatch`]
//! four points and one frame. A circle spline in its rational variant is a rational curve, a patch a rational surface:
//! they leave the kernel as [`NurbsCurve`] and [`RationalBezierSurface`] without any tolerance.
//!
//! Everything is `f64`, lengths are unitless, angles are radians, parameters run over `[0, 1]`. The kernel has no
//! I/O, no clock and no global tolerance; bad input gets an [`Error`] with the item, the measure and the limit. Files (STEP, DXF, SVG, GLB, OBJ, STL, JSON,
//! CSV, PNG) are written by the crate `cyclide-io` from a [`Model`]; small programs to start from are in its folder `examples`.
//!
//! An arc through three points, its measures and its exact rational form:
//! ```
//! use cyclide::{Point3, curve::Arc};
//! let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
//! let arc = Arc::from_three_points(a, b, c)?;
//! assert!((arc.length() - std::f64::consts::PI).abs() < 1e-15);
//! let nurbs = arc.to_nurbs(cyclide::curve::DEFAULT_PIECE_ANGLE)?; // two quadratic pieces, positive weights
//! assert_eq!((nurbs.degree(), nurbs.span_count()), (2, 2));
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! The fairest closed curve through points, with continuous curvature, exact as a B-spline:
//! ```
//! use cyclide::{Point3, construct::FairSplineOptions, curve::{CircleSpline, joints}, model::{Exactness, Lower}};
//! let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [6.0, 5.0, 2.0], [2.0, 6.0, 0.5]].map(Point3::from);
//! let spline = CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() })?;
//! assert!(joints(&spline).iter().all(|joint| joint.curvature_jump < 1e-13));
//! let (_chain, exactness) = spline.to_chain(1e-6)?;
//! assert_eq!(exactness, Exactness::Exact);
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! A patch of a Dupin cyclide from four points on a circle and one frame; its parameter lines are circles, its offset is
//! such a patch again, and so is its exact rational form:
//! ```
//! use cyclide::{Point3, Vec3, surface::{CyclidePatch, ParamSurface}};
//! let corners = [[-4.0, -3.0, 0.0], [4.0, -3.0, 0.0], [-3.0, 4.0, 0.0], [3.0, 4.0, 0.0]].map(Point3::from);
//! let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::new(8.0, -1.0, 4.0), Vec3::new(-1.0, 4.0, 3.0))?;
//! let offset = patch.offset(0.2)?;
//! let (p, normal) = (patch.point(0.3, 0.6), patch.unit_normal(0.3, 0.6));
//! assert!(offset.point(0.3, 0.6).distance(p + normal * 0.2) < 1e-14);
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! The fewest tangent arcs within a tolerance of points, with a certificate:
//! ```
//! use cyclide::{Point3, construct::{ArcFit, ArcFitOptions}};
//! let wave = |i: i32| Point3::new(0.1 * f64::from(i), (0.1 * f64::from(i)).sin(), 0.0);
//! let fit = ArcFit::new(&(0..=60).map(wave).collect::<Vec<_>>(), &ArcFitOptions::new(0.01))?;
//! assert!(fit.certificate().deviation <= 0.01 && fit.path().arcs().len() < 10);
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! A solid: the pipe about a run with a rounded corner, hollow.
//! ```
//! use cyclide::{Point3, construct::Pipe, curve::ArcPath};
//! let run = [[0.0, 0.0, 0.0], [40.0, 0.0, 0.0], [40.0, 30.0, 0.0]].map(Point3::from);
//! let spine = ArcPath::rounded_polyline(&run, false, &[0.0, 8.0, 0.0])?;
//! let pipe = Pipe::new(3.0)?.with_wall(0.5)?.body(&spine)?;
//! let ring = std::f64::consts::PI * (3.0 * 3.0 - 2.5 * 2.5);
//! assert!(pipe.is_solid() && (pipe.outer.volume() - ring * spine.length()).abs() < 1e-9);
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # Modules
//!
//! | module | what is in it |
//! |---|---|
//! | here | points, directions, frames, boxes: [`Point3`], [`Vec3`], [`Point2`], [`Vec2`], [`Quat`], [`Frame`], [`Aabb`]; jets: [`CurveJet`], [`SurfaceJet`], [`VolumeJet`]; [`Error`], [`Result`], [`Warning`] |
//! | [`prelude`] | what most programs begin with |
//! | [`conformal`] | Möbius maps, spheres, what such maps keep |
//! | [`rational`] | rational Bézier and B-spline curves, surfaces and volumes |
//! | [`curve`] | arcs, circles, chains of arcs, circle splines; measures and frames of any curve |
//! | [`motion`] | poses, rational motions, speeds, moving bodies |
//! | [`surface`] | patches of Dupin cyclides, nets, tori, canal surfaces, smooth surfaces over triangles |
//! | [`volume`] | blocks with three orthogonal families of cyclides |
//! | [`topology`] | bodies, their shells, faces and edges |
//! | [`construct`] | what is made of data in several steps: curves through and near points, pipes, tees, blends, polyhedra |
//! | [`panel`] | what a workshop must know of the panels of a net |
//! | [`mesh`] | polylines and triangles within a tolerance |
//! | [`model`] | named objects with units, ready for files |
//! | [`error`], [`warning`] | what is refused and what is remarked, by subject |
//!
//! [`Arc`]: curve::Arc
//! [`CyclidePatch`]: surface::CyclidePatch
//! [`NurbsCurve`]: rational::NurbsCurve
//! [`RationalBezierSurface`]: rational::RationalBezierSurface
//! [`Model`]: model::Model
//!
//! Quads made circular and grids along lines of curvature are in the crate `cyclide-grids`, files in `cyclide-io`.

mod base;
mod batch;
pub mod conformal;
pub mod construct;
pub mod curve;
pub mod error;
pub mod mesh;
pub mod model;
pub mod motion;
pub mod panel;
pub mod rational;
mod shape_change;
mod short_number;
pub mod surface;
mod table;
pub mod topology;
pub mod volume;
pub mod warning;

#[doc(hidden)]
pub mod workspace;

/// What most programs begin with: points, the traits, and the types that others are made of.
///
/// ```
/// use cyclide::prelude::*;
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// assert!(arc.point(0.5).distance(b) < 1e-15);
/// # Ok::<(), Error>(())
/// ```
pub mod prelude {
    pub use crate::conformal::{Conformal, Mobius};
    pub use crate::curve::{Arc, ArcPath, Circle, CircleSpline, ParamCurve};
    pub use crate::model::{Lower, Model, Units};
    pub use crate::surface::{CyclidePatch, CyclidicNet, ParamSurface};
    pub use crate::topology::{Body, FaceGeometry, Shell};
    pub use crate::volume::ParamVolume;
    pub use crate::{Aabb, Error, Frame, Point2, Point3, Quat, Vec2, Vec3, Warning};
}

pub use base::bounds::Aabb;
pub use base::frame::Frame;
pub use base::jet::CurveJet;
pub use base::planar::{Point2, Vec2};
pub use base::quat::Quat;
pub use base::surface_jet::SurfaceJet;
pub use base::vector::{Point3, Vec3};
pub use base::volume_jet::VolumeJet;
pub use error::{Error, Result};
pub use shape_change::ShapeChange;
pub use short_number::ShortNumber;
pub use warning::Warning;

/// The example of the package's page is compiled and run with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
