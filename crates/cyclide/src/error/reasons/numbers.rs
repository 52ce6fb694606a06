//! Errors about numbers, points, directions and lists, and of maps.
//!
//! # `not-finite`
//! A number is NaN or infinite.
//! ```
//! use cyclide::{Point3, curve::Arc};
//! let error = Arc::segment(Point3::ORIGIN, Point3::new(f64::NAN, 0.0, 0.0)).unwrap_err();
//! assert_eq!(error.reason(), "not-finite");
//! ```
//!
//! # `parameter-out-of-range`
//! A number is outside its interval, which the message names.
//! ```
//! use cyclide::{Point3, curve::Arc};
//! let arc = Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0))?;
//! assert_eq!(arc.split(1.5).unwrap_err().reason(), "parameter-out-of-range");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `below-rounding-of-place`
//! Something is so small at its location that the rounding of its coordinates destroys its shape.
//! ```
//! use cyclide::{Point3, Vec3, curve::Circle};
//! let error = Circle::from_radius(Point3::new(1e9, 0.0, 0.0), Vec3::Z, 1e-9).unwrap_err();
//! assert_eq!(error.reason(), "below-rounding-of-place");
//! ```
//!
//! # `tolerance-not-positive`
//! A tolerance is zero, negative or NaN.
//! ```
//! use cyclide::{Point3, curve::Arc, mesh::flatten};
//! let arc = Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0))?;
//! assert_eq!(flatten(&arc, 0.0).unwrap_err().reason(), "tolerance-not-positive");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `too-few-points`
//! A list has too few points for the construction.
//! ```
//! use cyclide::{Point3, curve::{CircleSpline, CircleSplineOptions}};
//! let error = CircleSpline::from_points(&[Point3::ORIGIN], &CircleSplineOptions::default()).unwrap_err();
//! assert_eq!(error.reason(), "too-few-points");
//! ```
//!
//! # `coincident-points`
//! Two points that must differ are coincident.
//! ```
//! use cyclide::{Point3, Vec3, curve::Arc};
//! let error = Arc::from_start_tangent(Point3::ORIGIN, Point3::ORIGIN, Vec3::X).unwrap_err();
//! assert_eq!(error.reason(), "coincident-points");
//! ```
//!
//! # `count-differs`
//! A list does not have one entry for each point or vertex.
//! ```
//! use cyclide::{Point3, curve::ArcPath};
//! let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
//! let error = ArcPath::rounded_polyline(&corner, false, &[0.0, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "count-differs");
//! ```
//!
//! # `zero-tangent`
//! A tangent or direction has no length.
//! ```
//! use cyclide::{Point3, Vec3, curve::Arc};
//! let error = Arc::from_start_tangent(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Vec3::ZERO).unwrap_err();
//! assert_eq!(error.reason(), "zero-tangent");
//! ```
//!
//! # `zero-axis`
//! An axis or a normal has no length, or no part perpendicular to the chord.
//! ```
//! use cyclide::{Point3, Vec3, curve::Circle};
//! let error = Circle::from_radius(Point3::ORIGIN, Vec3::ZERO, 1.0).unwrap_err();
//! assert_eq!(error.reason(), "zero-axis");
//! ```
//!
//! # `zero-weight`
//! A weight is the zero quaternion.
//! ```
//! use cyclide::{Point3, Quat, curve::Arc};
//! let error = Arc::from_weights(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Quat::ONE, Quat::ZERO).unwrap_err();
//! assert_eq!(error.reason(), "zero-weight");
//! ```
//!
//! # `weight-not-positive`
//! A weight of a rational curve or surface that must be positive is not.
//! ```
//! use cyclide::{Point3, rational::NurbsCurve};
//! let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from).to_vec();
//! let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
//! let error = NurbsCurve::new(2, knots, points, vec![1.0, -1.0, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "weight-not-positive");
//! ```
//!
//! # `weights-uneven`
//! Weights of a rational curve differ so much that its points cannot be distinguished by their parameters.
//! ```
//! use cyclide::{Point3, rational::NurbsCurve};
//! let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from).to_vec();
//! let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
//! let error = NurbsCurve::new(2, knots, points, vec![1.0, 1e100, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "weights-uneven");
//! ```
//!
//! # `zero-radius`
//! The first point of a circle lies on its axis.
//! ```
//! use cyclide::{Point3, Vec3, curve::Circle};
//! let error = Circle::from_center(Point3::ORIGIN, Vec3::Z, Point3::new(0.0, 0.0, 3.0)).unwrap_err();
//! assert_eq!(error.reason(), "zero-radius");
//! ```
//!
//! # `radius-not-positive`
//! A radius is zero, negative or NaN.
//! ```
//! use cyclide::{Point3, Vec3, curve::Circle};
//! let error = Circle::from_radius(Point3::ORIGIN, Vec3::Z, -1.0).unwrap_err();
//! assert_eq!(error.reason(), "radius-not-positive");
//! ```
//!
//! # `scale-not-positive`
//! A similarity scales by zero or less.
//! ```
//! use cyclide::{Quat, Vec3, conformal::Mobius};
//! assert_eq!(Mobius::similarity(Quat::ONE, 0.0, Vec3::ZERO).unwrap_err().reason(), "scale-not-positive");
//! ```
//!
//! # `order-out-of-range`
//! The order of a blend is not supported.
//! ```
//! use cyclide::{Point3, curve::{CircleSpline, CircleSplineOptions}};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
//! let error = CircleSpline::from_points(&points, &CircleSplineOptions { order: 9, ..Default::default() }).unwrap_err();
//! assert_eq!(error.reason(), "order-out-of-range");
//! ```
//!
//! # `sweep-out-of-range`
//! An arc is to turn by a full circle or more.
//! ```
//! use cyclide::{Point3, Vec3, curve::Arc};
//! let error = Arc::from_center(Point3::ORIGIN, Vec3::Z, Point3::new(1.0, 0.0, 0.0), 7.0).unwrap_err();
//! assert_eq!(error.reason(), "sweep-out-of-range");
//! ```
//!
//! # `angle-out-of-range`
//! A turn or a slope is outside the range of the construction.
//! ```
//! use cyclide::{Point3, Vec3, construct::Revolution};
//! assert_eq!(Revolution::new(Point3::ORIGIN, Vec3::Z, 7.0).unwrap_err().reason(), "angle-out-of-range");
//! ```
//!
//! # `too-many-pieces`
//! A refinement would need more pieces than its limit on work and memory.
//! ```
//! use cyclide::{Point3, Vec3, curve::Circle, mesh::flatten_within};
//! let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?;
//! assert_eq!(flatten_within(&circle, 1e-3, 10).unwrap_err().reason(), "too-many-pieces");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `same-surface`
//! Two spheres or planes that are to be intersected are one.
//! ```
//! use cyclide::{Point3, conformal::Sphere, curve::SphereOrPlane};
//! let ball = SphereOrPlane::Sphere(Sphere::new(Point3::ORIGIN, 1.0)?);
//! assert_eq!(ball.meet(&ball).unwrap_err().reason(), "same-surface");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `contained`
//! A circle or line lies on the sphere or plane with which it is to be intersected.
//! ```
//! use cyclide::{Point3, Vec3, conformal::{Line, Plane}, curve::{CircleOrLine, SphereOrPlane}};
//! let line = CircleOrLine::Line(Line::new(Point3::ORIGIN, Vec3::X)?);
//! let plane = SphereOrPlane::Plane(Plane::new(Point3::new(3.0, 4.0, 0.0), Vec3::Z)?);
//! assert_eq!(line.meet(&plane).unwrap_err().reason(), "contained");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `nearest-undefined`
//! A point is the center of a sphere, or on the axis of a circle: no point of it is the nearest.
//! ```
//! use cyclide::{Point3, conformal::Sphere, curve::SphereOrPlane};
//! let ball = SphereOrPlane::Sphere(Sphere::new(Point3::ORIGIN, 1.0)?);
//! assert_eq!(ball.nearest(Point3::ORIGIN).unwrap_err().reason(), "nearest-undefined");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `collinear-needs-up`
//! Three points on a line are to be mapped, and no normal of their plane is given.
//! ```
//! use cyclide::{Point3, Vec3, conformal::Mobius};
//! let from = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from);
//! let to = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
//! let error = Mobius::from_three_points(from, to, 0.0, [None, None]).unwrap_err();
//! assert_eq!(error.reason(), "collinear-needs-up");
//! assert!(Mobius::from_three_points(from, to, 0.0, [Some(Vec3::Z), None]).is_ok());
//! ```
//!
//! # `point-at-infinity`
//! A point lies where it would go to infinity, or a map takes it there.
//! ```
//! use cyclide::{Point3, conformal::{Conformal, Mobius}, curve::Arc};
//! let arc = Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0))?;
//! let inversion = Mobius::inversion(Point3::ORIGIN, 1.0)?;
//! assert_eq!(arc.transformed(&inversion).unwrap_err().reason(), "point-at-infinity");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-mobius`
//! A matrix of quaternions is singular or takes points out of space.
//! ```
//! use cyclide::{Quat, conformal::Mobius};
//! let error = Mobius::from_matrix(Quat::ONE, Quat::ONE, Quat::ONE, Quat::ONE).unwrap_err();
//! assert_eq!(error.reason(), "not-mobius");
//! ```
//!
//! # `not-a-similarity`
//! A map that is not a similarity would change the kind of the curve or surface.
//! ```
//! use cyclide::{Point3, Vec3, conformal::Mobius, curve::Circle};
//! let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?;
//! let inversion = Mobius::inversion(Point3::new(5.0, 0.0, 0.0), 1.0)?;
//! assert_eq!(circle.similar(&inversion).unwrap_err().reason(), "not-a-similarity");
//! # Ok::<(), cyclide::Error>(())
//! ```
