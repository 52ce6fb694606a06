//! What is refused of tori, and of points and curves on them.
//!
//! # `not-a-ring-torus`
//! The tube is not thinner than the circle that its middle follows.
//! ```
//! use cyclide::{Frame, Torus};
//! assert_eq!(Torus::new(Frame::WORLD, 1.0, 2.0).unwrap_err().reason(), "not-a-ring-torus");
//! ```
//!
//! # `zero-coordinate`
//! A complex coordinate of a point is zero: it has no direction.
//! ```
//! use cyclide::TorusClasses;
//! let error = TorusClasses::new([[1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [1.0, 0.0]]).unwrap_err();
//! assert_eq!(error.reason(), "zero-coordinate");
//! ```
//!
//! # `point-on-axis`
//! No point of the torus is nearest to a point of its axis.
//! ```
//! use cyclide::{Frame, Point3, Torus};
//! let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
//! let error = torus.locate(Point3::new(0.0, 0.0, 0.5), 10.0).unwrap_err();
//! assert_eq!(error.reason(), "point-on-axis");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `point-on-core-circle`
//! No point of the torus is nearest to a point in the middle of the tube.
//! ```
//! use cyclide::{Frame, Point3, Torus};
//! let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
//! let error = torus.locate(Point3::new(3.0, 0.0, 0.0), 10.0).unwrap_err();
//! assert_eq!(error.reason(), "point-on-core-circle");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `point-off-torus`
//! A point is farther from the torus than the tolerance.
//! ```
//! use cyclide::{Frame, Point3, Torus};
//! let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
//! let error = torus.locate(Point3::new(4.5, 0.0, 0.0), 0.1).unwrap_err();
//! assert_eq!(error.reason(), "point-off-torus");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-monotone`
//! A coordinate that runs in one direction only should turn back.
//! ```
//! use cyclide::ProjectiveBiarc;
//! let error = ProjectiveBiarc::new(0.0, 1.0, [1.0, -1.0], [1.0, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "not-monotone");
//! ```
//!
//! # `span-too-large`
//! A coordinate should go half round, or farther, in one span.
//! ```
//! use cyclide::ProjectiveBiarc;
//! let error = ProjectiveBiarc::new(0.0, 3.2, [1.0, 1.0], [1.0, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "span-too-large");
//! ```
//!
//! # `empty-interval`
//! An interval of the parameter has no length.
//! ```
//! use cyclide::ProjectiveBiarc;
//! let error = ProjectiveBiarc::new(0.0, 1.0, [1.0, 1.0], [0.0, 1.0]).unwrap_err();
//! assert_eq!(error.reason(), "empty-interval");
//! ```
//!
//! # `no-two-type-solution`
//! No two pieces of the given types join two places with their speeds: here the types share no coordinate.
//! ```
//! use cyclide::{CircleFamily, Point2, QuarticType, TwoTypeBiarc, Vec2};
//! let [one, other] = [[0, 1], [2, 3]].map(|pair| pair.map(|i: usize| CircleFamily::ALL[i]));
//! let kinds = [one, other].map(|[i, j]| QuarticType::between(i, j).expect("they differ"));
//! let rates = [Vec2::new(1.0, 0.5); 2];
//! let error = TwoTypeBiarc::all(kinds, Point2::new(0.0, 0.0), Vec2::new(0.5, 0.4), rates, [0.5, 0.5]).unwrap_err();
//! assert_eq!(error.reason(), "no-two-type-solution");
//! ```
//!
//! # `not-coprime`
//! A torus knot with turns that have a common divisor would run over itself.
//! ```
//! use cyclide::{Frame, Torus, TorusSpline};
//! let error = TorusSpline::knot(&Torus::new(Frame::WORLD, 3.0, 1.0)?, [2, 4], Default::default()).unwrap_err();
//! assert_eq!(error.reason(), "not-coprime");
//! # Ok::<(), cyclide::Error>(())
//! ```
