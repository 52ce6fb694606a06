//! Errors about tori, and of points and curves on them.
//!
//! # `not-a-ring-torus`
//! The radius of the tube is not below that of its center circle.
//! ```
//! use cyclide::{Frame, surface::Torus};
//! assert_eq!(Torus::new(Frame::WORLD, 1.0, 2.0).unwrap_err().reason(), "not-a-ring-torus");
//! ```
//!
//! # `zero-coordinate`
//! A complex coordinate of a point is zero: it has no direction.
//! ```
//! use cyclide::surface::TorusClasses;
//! let error = TorusClasses::new([[1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [1.0, 0.0]]).unwrap_err();
//! assert_eq!(error.reason(), "zero-coordinate");
//! ```
//!
//! # `point-on-axis`
//! The longitude of a point on the axis of the torus is undefined.
//! ```
//! use cyclide::{Frame, Point3, surface::Torus};
//! let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
//! let error = torus.locate(Point3::new(0.0, 0.0, 0.5), 10.0).unwrap_err();
//! assert_eq!(error.reason(), "point-on-axis");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `point-on-core-circle`
//! The angle round the tube is undefined for a point on its center circle.
//! ```
//! use cyclide::{Frame, Point3, surface::Torus};
//! let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
//! let error = torus.locate(Point3::new(3.0, 0.0, 0.0), 10.0).unwrap_err();
//! assert_eq!(error.reason(), "point-on-core-circle");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `point-off-torus`
//! A point is farther from the torus than the tolerance.
//! ```
//! use cyclide::{Frame, Point3, surface::Torus};
//! let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
//! let error = torus.locate(Point3::new(4.5, 0.0, 0.0), 0.1).unwrap_err();
//! assert_eq!(error.reason(), "point-off-torus");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-monotone`
//! A coordinate that runs in one direction only would have to turn back.
//! ```
//! use cyclide::construct::ProjectiveBiarc;
//! let error = ProjectiveBiarc::new(0.0, 1.0, [1.0, -1.0], [1.0, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "not-monotone");
//! ```
//!
//! # `span-too-large`
//! A coordinate would change by half a turn or more in one span.
//! ```
//! use cyclide::construct::ProjectiveBiarc;
//! let error = ProjectiveBiarc::new(0.0, 3.2, [1.0, 1.0], [1.0, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "span-too-large");
//! ```
//!
//! # `empty-interval`
//! An interval of a curve's parameter has no length, or one lost in rounding: a given length is not positive, or knots or
//! parameters repeat or decrease. The index counts intervals; for poses, which are counted themselves, see
//! [`parameters-not-increasing`](super::motions#parameters-not-increasing).
//! ```
//! use cyclide::construct::ProjectiveBiarc;
//! let error = ProjectiveBiarc::new(0.0, 1.0, [1.0, 1.0], [0.0, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "empty-interval");
//! ```
//!
//! # `no-two-type-solution`
//! No two pieces of the given types join two points with their speeds: here the types share no coordinate.
//! ```
//! use cyclide::{Point2, Vec2, construct::TwoTypeBiarc, surface::{CircleFamily, QuarticType}};
//! let [one, other] = [[0, 1], [2, 3]].map(|pair| pair.map(|i: usize| CircleFamily::ALL[i]));
//! let kinds = [one, other].map(|[i, j]| QuarticType::between(i, j).expect("they differ"));
//! let rates = [Vec2::new(1.0, 0.5); 2];
//! let error = TwoTypeBiarc::all(kinds, Point2::new(0.0, 0.0), Vec2::new(0.5, 0.4), rates, [0.5, 0.5]).unwrap_err();
//! assert_eq!(error.reason(), "no-two-type-solution");
//! ```
//!
//! # `not-coprime`
//! A torus knot whose turns have a common divisor would retrace itself.
//! ```
//! use cyclide::{Frame, surface::{Torus, TorusSpline}};
//! let error = TorusSpline::knot(&Torus::new(Frame::WORLD, 3.0, 1.0)?, [2, 4], Default::default()).unwrap_err();
//! assert_eq!(error.reason(), "not-coprime");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-timelike-pair`
//! The balls between two skew cylinders form a torus only if one axis stays outside the offset of the other cylinder.
//! ```
//! use cyclide::surface::SkewCylinders;
//! assert_eq!(SkewCylinders::new([1.0, 3.0], 1.0).unwrap_err().reason(), "not-timelike-pair");
//! ```
//!
//! # `degenerate-pair`
//! Two surfaces have a common axis.
//! ```
//! use cyclide::{Point3, Vec3, surface::{NaturalQuadric, QuadricPair}};
//! let pipe = NaturalQuadric::cylinder(Point3::ORIGIN, Vec3::Z, 1.0)?;
//! assert_eq!(QuadricPair::new([pipe, pipe]).unwrap_err().reason(), "degenerate-pair");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `sphere-at-infinity`
//! On the border of the region of balls the ball is a plane.
//! ```
//! use cyclide::{Point2, surface::SkewCylinders};
//! let error = SkewCylinders::new([1.0, 1.0], 2.0)?.ball(Point2::new(0.5, 0.5)).unwrap_err();
//! assert_eq!(error.reason(), "sphere-at-infinity");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `wrong-side`
//! Beyond that border balls touch from the other side.
//! ```
//! use cyclide::{Point2, surface::SkewCylinders};
//! let error = SkewCylinders::new([1.0, 1.0], 2.0)?.ball(Point2::new(1.0, 0.5)).unwrap_err();
//! assert_eq!(error.reason(), "wrong-side");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `no-positive-radius`
//! No ball outside touches a surface at a point and a sphere that is behind it.
//! ```
//! use cyclide::{Point3, Vec3, surface::{ContactPartner, RollingBall}};
//! let sphere = ContactPartner::Sphere { center: Point3::new(-3.0, 0.0, 0.0), radius: 1.0 };
//! let error = RollingBall::at_contact(Point3::new(1.0, 0.0, 0.0), Vec3::X, sphere).unwrap_err();
//! assert_eq!(error.reason(), "no-positive-radius");
//! ```
//!
//! # `parallel-contact`
//! At this point the tangent plane is parallel to the plane that the ball should touch.
//! ```
//! use cyclide::{Point3, Vec3, surface::{ContactPartner, RollingBall}};
//! let plane = ContactPartner::Plane { normal: Vec3::Z, offset: 0.0 };
//! let error = RollingBall::at_contact(Point3::new(0.0, 0.0, 1.0), Vec3::Z, plane).unwrap_err();
//! assert_eq!(error.reason(), "parallel-contact");
//! ```
//!
//! # `radius-too-small`
//! A ball is smaller than half the gap between two cylinders.
//! ```
//! use cyclide::surface::SkewCylinders;
//! let error = SkewCylinders::new([1.0, 1.0], 2.0)?.place_of_radius(0.5, 0.0).unwrap_err();
//! assert_eq!(error.reason(), "radius-too-small");
//! # Ok::<(), cyclide::Error>(())
//! ```
