//! Errors about revolutions, pipes, tees, necks, bridges, surfaces between two curves, and polyhedra.
//!
//! # `crosses-axis`
//! A profile crosses the axis about which it is turned.
//! ```
//! use cyclide::{Point3, Vec3, construct::Revolution, curve::Arc};
//! let turn = Revolution::new(Point3::ORIGIN, Vec3::Z, std::f64::consts::TAU)?;
//! let profile = Arc::segment(Point3::new(-1.0, 0.0, 0.0), Point3::new(2.0, 0.0, 1.0))?;
//! assert_eq!(turn.body(&[profile.into()], false).unwrap_err().reason(), "crosses-axis");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `profile-on-axis`
//! All of a profile lies along the axis.
//! ```
//! use cyclide::{Point3, Vec3, construct::Revolution, curve::Arc};
//! let turn = Revolution::new(Point3::ORIGIN, Vec3::Z, std::f64::consts::TAU)?;
//! let profile = Arc::segment(Point3::ORIGIN, Point3::new(0.0, 0.0, 2.0))?;
//! assert_eq!(turn.body(&[profile.into()], false).unwrap_err().reason(), "profile-on-axis");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `profile-meets-itself`
//! A closed profile intersects itself, and so would the solid.
//! ```
//! use cyclide::{Point3, Vec3, construct::Revolution, curve::Arc, topology::EdgeCurve};
//! let eight = [[10.0, 0.0, 0.0], [30.0, 0.0, 30.0], [30.0, 0.0, 0.0], [10.0, 0.0, 30.0]].map(Point3::from);
//! let side = |k: usize| Arc::segment(eight[k], eight[(k + 1) % 4]).map(EdgeCurve::from);
//! let profile = [side(0)?, side(1)?, side(2)?, side(3)?];
//! let turn = Revolution::new(Point3::ORIGIN, Vec3::Z, std::f64::consts::TAU)?;
//! assert_eq!(turn.body(&profile, true).unwrap_err().reason(), "profile-meets-itself");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `section-not-plane`
//! A section that is to be swept leaves its plane.
//! ```
//! use cyclide::{Point3, construct::{Sweep, SweepOptions}, curve::{Arc, ArcPath}};
//! let path = ArcPath::rounded_polyline(&[Point3::ORIGIN, Point3::new(0.0, 0.0, 9.0)], false, &[0.0; 2])?;
//! let section = [Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.1))?.into()];
//! let error = Sweep::new(&[(section.to_vec(), false)], &path, &SweepOptions::default()).unwrap_err();
//! assert_eq!(error.reason(), "section-not-plane");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `section-meets-itself`
//! A closed section that is to be swept to a solid runs through itself.
//! ```
//! use cyclide::{Point3, construct::{Sweep, SweepOptions}, curve::{Arc, ArcPath}, topology::EdgeCurve};
//! let path = ArcPath::rounded_polyline(&[Point3::ORIGIN, Point3::new(0.0, 0.0, 9.0)], false, &[0.0; 2])?;
//! let eight = [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(Point3::from);
//! let side = |k: usize| Arc::segment(eight[k], eight[(k + 1) % 4]).map(EdgeCurve::from);
//! let section = vec![side(0)?, side(1)?, side(2)?, side(3)?];
//! let error = Sweep::new(&[(section, true)], &path, &SweepOptions::default()).unwrap_err();
//! assert_eq!(error.reason(), "section-meets-itself");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `folded-profile`
//! A profile in a plane perpendicular to the axis goes out and comes back.
//! ```
//! use cyclide::{Point3, Vec3, construct::Revolution, curve::Arc};
//! let turn = Revolution::new(Point3::ORIGIN, Vec3::Z, std::f64::consts::TAU)?;
//! let at = |x: f64| Point3::new(x, 0.0, 2.0);
//! let profile = [Arc::segment(at(1.0), at(3.0))?.into(), Arc::segment(at(3.0), at(2.0))?.into()];
//! assert_eq!(turn.body(&profile, false).unwrap_err().reason(), "folded-profile");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `bend-does-not-fit`
//! The arc of a corner needs more of its legs than they have.
//! ```
//! use cyclide::{Point3, curve::ArcPath};
//! let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
//! let error = ArcPath::rounded_polyline(&corner, false, &[0.0, 5.0, 0.0]).unwrap_err();
//! assert_eq!(error.reason(), "bend-does-not-fit");
//! ```
//!
//! # `pipe-too-wide`
//! A pipe is as wide as an arc that it follows.
//! ```
//! use cyclide::{Point3, construct::Pipe, curve::{Arc, ArcPath}};
//! let half = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
//! let spine = ArcPath::new(vec![Arc::from_three_points(half[0], half[1], half[2])?], false)?;
//! assert_eq!(Pipe::new(1.5)?.body(&spine).unwrap_err().reason(), "pipe-too-wide");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `corner-not-mitred`
//! A corner of a pipe turns back so far that no miter joins its sides.
//! ```
//! use cyclide::{Point3, construct::Pipe, curve::ArcPath};
//! let back = [[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
//! let spine = ArcPath::rounded_polyline(&back, false, &[0.0; 3])?;
//! assert_eq!(Pipe::new(5.0)?.body(&spine).unwrap_err().reason(), "corner-not-mitred");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `mitre-does-not-fit`
//! A segment of a pipe is shorter than the miters at its ends.
//! ```
//! use cyclide::{Point3, construct::Pipe, curve::ArcPath};
//! let step = [[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [50.0, 9.0, 0.0], [0.0, 9.0, 0.0]].map(Point3::from);
//! let spine = ArcPath::rounded_polyline(&step, false, &[0.0; 4])?;
//! assert_eq!(Pipe::new(5.0)?.body(&spine).unwrap_err().reason(), "mitre-does-not-fit");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `pipe-meets-itself`
//! Parts of a pipe that are not neighbors intersect.
//! ```
//! use cyclide::{Point3, construct::Pipe, curve::ArcPath};
//! let hairpin = [[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [50.0, 30.0, 0.0], [40.0, 30.0, 0.0], [40.0, -20.0, 0.0]];
//! let spine = ArcPath::rounded_polyline(&hairpin.map(Point3::from), false, &[0.0; 5])?;
//! assert_eq!(Pipe::new(3.0)?.body(&spine).unwrap_err().reason(), "pipe-meets-itself");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `seam-too-wide`
//! A seam along a curve of a torus is wider than a bend of the curve allows.
//! ```
//! use cyclide::{Frame, Point2, construct::{TorusSeam, TorusSplineOptions}, surface::{Torus, TorusSpline}};
//! let places = [[0.3, 0.1], [0.36, 0.0], [0.3, -0.1], [0.24, 0.0]].map(Point2::from);
//! let options = TorusSplineOptions { closed: true, ..Default::default() };
//! let ring = TorusSpline::through_places(&Torus::new(Frame::WORLD, 40.0, 15.0)?, &places, &options)?;
//! assert_eq!(TorusSeam::new(60.0, [-0.5, 0.5])?.body(&ring, 0.05).unwrap_err().reason(), "seam-too-wide");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `seam-meets-itself`
//! Parts of a seam along a curve of a torus that are not neighbors share space.
//! ```
//! use cyclide::{Frame, construct::TorusSeam, surface::{Torus, TorusSpline}};
//! let turns = TorusSpline::knot(&Torus::new(Frame::WORLD, 40.0, 15.0)?, [9, 2], Default::default())?;
//! let error = TorusSeam::new(12.0, [-0.5, 0.5])?.body(&turns, 0.05).unwrap_err();
//! assert_eq!(error.reason(), "seam-meets-itself");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `balls-nested`
//! One of two neighboring balls of a tube contains the other.
//! ```
//! use cyclide::{Point3, construct::{Ball, Tube}};
//! let balls = [Ball::new(Point3::ORIGIN, 3.0), Ball::new(Point3::new(1.0, 0.0, 0.0), 1.0)];
//! assert_eq!(Tube::through(&balls, false).unwrap_err().reason(), "balls-nested");
//! ```
//!
//! # `tube-turns-back`
//! No smooth tube continues from a ball to its neighbors.
//! ```
//! use cyclide::{Point3, construct::{Ball, Tube}};
//! let balls = [0.0, 3.0, 1.0].map(|x| Ball::new(Point3::new(x, 0.0, 0.0), 0.5));
//! assert_eq!(Tube::through(&balls, false).unwrap_err().reason(), "tube-turns-back");
//! ```
//!
//! # `tube-radius-vanishes`
//! The radius of a tube through balls falls below zero between two of them.
//! ```
//! use cyclide::{Point3, construct::{Ball, Tube}};
//! let balls = [[-3.0, 3.0, 0.2], [-1.0, 3.0, 2.0], [4.0, 3.0, 0.1], [3.0, -6.0, 2.0]].map(|[x, y, r]| Ball::new(Point3::new(x, y, 0.0), r));
//! assert_eq!(Tube::through(&balls, false)?.body().unwrap_err().reason(), "tube-radius-vanishes");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tube-folds`
//! A tube is too wide for the bends of its path.
//! ```
//! use cyclide::{Point3, construct::{Ball, Tube}};
//! let balls = [[0.0, 0.0], [2.0, 2.0], [4.0, 0.0]].map(|[x, y]| Ball::new(Point3::new(x, y, 0.0), 3.0));
//! assert_eq!(Tube::through(&balls, false)?.body().unwrap_err().reason(), "tube-folds");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `radius-grows-too-fast`
//! The radius of a tube changes as fast as the path length or faster.
//! ```
//! use cyclide::{Point3, construct::{RadiusLaw, Tube}, curve::ArcPath};
//! let spine = ArcPath::rounded_polyline(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]].map(Point3::from), false, &[0.0; 2])?;
//! let law = RadiusLaw::new(&[[0.0, 1.0], [1.0, 6.0]])?;
//! assert_eq!(Tube::along(&spine, &law, 1e-3).unwrap_err().reason(), "radius-grows-too-fast");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `radius-not-closed`
//! A closed tube starts with another radius than it ends with.
//! ```
//! use cyclide::{Point3, Vec3, construct::{RadiusLaw, Tube}, curve::{ArcPath, Circle}};
//! let ring = ArcPath::new(Circle::from_radius(Point3::ORIGIN, Vec3::Z, 9.0)?.to_arcs().to_vec(), true)?;
//! let law = RadiusLaw::new(&[[0.0, 1.0], [1.0, 2.0]])?;
//! assert_eq!(Tube::along(&ring, &law, 1e-3).unwrap_err().reason(), "radius-not-closed");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-of-arcs`
//! A construction along arcs was given a curve of another kind, and no tolerance for replacing it by arcs.
//! ```
//! use cyclide::{Point3, construct::Pipe, curve::{CircleSpline, CircleSplineOptions}, model::CurveObject};
//! let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 1.0], [0.0, 5.0, 1.0]].map(Point3::from);
//! let spline = CurveObject::CircleSpline(CircleSpline::from_points(&points, &CircleSplineOptions::default())?);
//! assert_eq!(spline.piped(&Pipe::new(0.1)?, None).unwrap_err().reason(), "not-of-arcs");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `ball-does-not-fit`
//! A ball that is to roll inside a pipe is as large as the pipe.
//! ```
//! use cyclide::construct::{NeckBlend, NeckSide, NeckVariant};
//! let error = NeckBlend::new(1.0, 1.0, 0.0, NeckSide::Inside, NeckVariant::Pipe).unwrap_err();
//! assert_eq!(error.reason(), "ball-does-not-fit");
//! ```
//!
//! # `neck-folds`
//! The neck of a solid self-intersects: its ball is larger than the bends of its path.
//! ```
//! use cyclide::construct::{NeckBlend, NeckBody, NeckSide, NeckVariant, PlateShape};
//! let neck = NeckBlend::new(1.0, 5.0, 1.0, NeckSide::Outside, NeckVariant::Pipe)?;
//! let solid = NeckBody::new(30.0).with_plate(PlateShape::Rectangle([100.0, 100.0])).with_thickness(1.0);
//! assert_eq!(neck.body(&solid).unwrap_err().reason(), "neck-folds");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `plate-too-small`
//! A plate ends within the neck that rises from it.
//! ```
//! use cyclide::construct::{NeckBlend, NeckBody, NeckSide, NeckVariant, PlateShape};
//! let neck = NeckBlend::new(3.0, 0.8, 0.5, NeckSide::Outside, NeckVariant::Pipe)?;
//! let body = NeckBody::new(8.0).with_plate(PlateShape::Disk(2.0));
//! assert_eq!(neck.body(&body).unwrap_err().reason(), "plate-too-small");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tee-branch-too-wide`
//! A branch of a tee extends beyond the width of its main pipe.
//! ```
//! use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
//! let beside = TeeBranch { offset: 1.5, ..TeeBranch::upright(2.0, 10.0, 0.5) };
//! assert_eq!(PipeTee::new(main, vec![beside])?.made().unwrap_err().reason(), "tee-branch-too-wide");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tee-blend-too-large`
//! The quartic blend of a wide branch would have an infinite radius at its inner corners.
//! ```
//! use cyclide::construct::{PipeTee, TeeBlend, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
//! let wide = TeeBranch { blend: TeeBlend::Least(0.5), ..TeeBranch::upright(2.8, 10.0, 0.5) };
//! assert_eq!(PipeTee::new(main, vec![wide])?.made().unwrap_err().reason(), "tee-blend-too-large");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tee-law-on-equal-pipes`
//! A branch of a tee is as wide as its main pipe, and the radius of its blend changes.
//! ```
//! use cyclide::construct::{PipeTee, TeeBlend, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
//! let blend = TeeBlend::Angles { values: vec![[0.0, 0.5], [1.0, 0.7]], tolerance: None };
//! let equal = TeeBranch { blend, ..TeeBranch::upright(3.0, 10.0, 0.5) };
//! assert_eq!(PipeTee::new(main, vec![equal])?.made().unwrap_err().reason(), "tee-law-on-equal-pipes");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tee-pipe-too-short`
//! A pipe of a tee ends within its blend.
//! ```
//! use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 2.1] };
//! assert_eq!(PipeTee::new(main, vec![TeeBranch::upright(2.0, 10.0, 0.5)])?.made().unwrap_err().reason(), "tee-pipe-too-short");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tee-blend-folds`
//! A blend of a tee self-intersects: its ball is too large for the sharp inner corner of a strongly inclined branch.
//! ```
//! use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-40.0, 40.0] };
//! let leaning = TeeBranch { angle: 0.4, ..TeeBranch::upright(1.5, 40.0, 1.0) };
//! assert_eq!(PipeTee::new(main, vec![leaning])?.made().unwrap_err().reason(), "tee-blend-folds");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tee-hole-folds`
//! The radius of a blend changes so much that its contact curve on the main pipe turns back and forth.
//! ```
//! use cyclide::construct::{PipeTee, TeeBlend, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
//! let angle = |k: usize| std::f64::consts::TAU * k as f64 / 12.0;
//! let wave = (0..12).map(|k| [angle(k), if k % 2 == 0 { 0.7 } else { 0.3 }]).collect();
//! let branch = TeeBranch { blend: TeeBlend::Angles { values: wave, tolerance: None }, ..TeeBranch::upright(1.5, 10.0, 0.5) };
//! assert_eq!(PipeTee::new(main, vec![branch])?.made().unwrap_err().reason(), "tee-hole-folds");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `pipe-ends-reversed`
//! The ends of a pipe, positions along its axis, are not in order.
//! ```
//! use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [12.0, -12.0] };
//! let tee = PipeTee::new(main, vec![TeeBranch::upright(2.0, 10.0, 0.5)]);
//! assert_eq!(tee.unwrap_err().reason(), "pipe-ends-reversed");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `crossing-axes-too-near`
//! The axes of two pipes that are to pass each other are no farther apart than their radii differ.
//! ```
//! use cyclide::construct::{CrossingPipe, PipeCrossing};
//! let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-9.0, 9.0] };
//! assert_eq!(PipeCrossing::new([pipe, pipe], 0.0, 0.5).unwrap_err().reason(), "crossing-axes-too-near");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `crossing-ball-too-large`
//! A ball that is to round the edge of the common part of two pipes is larger than half of their overlap.
//! ```
//! use cyclide::construct::{CrossingPipe, CrossingSide, PipeCrossing};
//! let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-9.0, 9.0] };
//! let crossing = PipeCrossing::new([pipe, pipe], 3.0, 0.5)?.with_side(CrossingSide::Inside);
//! assert_eq!(crossing.made().unwrap_err().reason(), "crossing-ball-too-large");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `crossing-no-ball`
//! Two pipes with a gap of 2.31 between them pass each other at 29 degrees: small balls fold the blend on one side of the bridge, large
//! ones on the other.
//! ```
//! use cyclide::construct::{CrossingPipe, PipeCrossing};
//! let pipe = |radius| CrossingPipe { radius, taper: 0.0, ends: [-600.0, 600.0] };
//! let crossing = PipeCrossing::new([pipe(10.9), pipe(7.6)], 20.81, 0.1)?;
//! let leaning = crossing.clone().with_angle(29.3_f64.to_radians())?;
//! assert_eq!(leaning.made().unwrap_err().reason(), "crossing-no-ball");
//! assert_ne!(crossing.made().unwrap_err().reason(), leaning.made().unwrap_err().reason()); // at right angles larger balls work
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `crossing-pipes-apart`
//! One of two pipes is to be cut by the other, but they do not meet.
//! ```
//! use cyclide::construct::{CrossingPipe, CrossingSide, PipeCrossing};
//! let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-9.0, 9.0] };
//! let crossing = PipeCrossing::new([pipe, pipe], 4.5, 0.5)?.with_side(CrossingSide::Mixed);
//! assert_eq!(crossing.made().unwrap_err().reason(), "crossing-pipes-apart");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `crossing-needs-cylinders`
//! Tapered pipes can be crossed only with a ball of constant radius, outside or inside both.
//! ```
//! use cyclide::construct::{CrossingPipe, CrossingSide, PipeCrossing};
//! let pipe = CrossingPipe { radius: 2.0, taper: 0.1, ends: [-9.0, 9.0] };
//! let crossing = PipeCrossing::new([pipe, pipe], 3.0, 0.5)?.with_side(CrossingSide::Mixed);
//! assert_eq!(crossing.made().unwrap_err().reason(), "crossing-needs-cylinders");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `no-center-surface`
//! A surface of ball centers exists only for pipes that pass each other, with balls outside both or inside both.
//! ```
//! use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
//! let made = PipeTee::new(main, vec![TeeBranch::upright(2.0, 10.0, 0.5)])?.made()?;
//! assert_eq!(made.centers.surface(0.25).unwrap_err().reason(), "no-center-surface");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `crossing-pipe-too-short`
//! A pipe of a crossing ends within the blend.
//! ```
//! use cyclide::construct::{CrossingPipe, PipeCrossing};
//! let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-2.2, 9.0] };
//! let crossing = PipeCrossing::new([pipe, pipe], 3.0, 0.5)?;
//! assert_eq!(crossing.made().unwrap_err().reason(), "crossing-pipe-too-short");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `crossing-hole-too-wide`
//! A thin pipe lies so deep in a thick one that the blend runs nearly all round it.
//! ```
//! use cyclide::construct::{CrossingPipe, PipeCrossing};
//! let pipes = [6.0, 1.0].map(|radius| CrossingPipe { radius, taper: 0.0, ends: [-12.0, 12.0] });
//! assert_eq!(PipeCrossing::new(pipes, 5.02, 0.3)?.made().unwrap_err().reason(), "crossing-hole-too-wide");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `crossing-hole-turns-back`
//! The blend of two skew pipes with a large ball meets a pipe in a curve that turns back along it.
//! ```
//! use cyclide::construct::{CrossingPipe, PipeCrossing};
//! let pipes = [1.0, 0.92].map(|radius| CrossingPipe { radius, taper: 0.0, ends: [-12.0, 12.0] });
//! let crossing = PipeCrossing::new(pipes, 0.65, 1.95)?.with_angle(59_f64.to_radians())?;
//! assert_eq!(crossing.made().unwrap_err().reason(), "crossing-hole-turns-back");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `crossing-folds`
//! The ball of a crossing is too large to roll between its pipes, and the blend self-intersects.
//! ```
//! use cyclide::construct::{CrossingPipe, PipeCrossing};
//! let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-12.0, 12.0] };
//! assert_eq!(PipeCrossing::new([pipe, pipe], 3.0, 9.0)?.made().unwrap_err().reason(), "crossing-folds");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `contact-loop-open`
//! A tube passes beside the sphere that it should meet.
//! ```
//! use cyclide::{Point3, Vec3, construct::{BlendBase, BlendTube, ContactBlend}};
//! let tube = BlendTube { through: Point3::new(0.0, 5.5, 0.0), direction: Vec3::Z, radius: 1.0, taper: 0.0, length: 9.0 };
//! let blend = ContactBlend::new(tube, BlendBase::Sphere { radius: 4.0 }, 0.5)?;
//! assert_eq!(blend.made().unwrap_err().reason(), "contact-loop-open");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `contact-loop-turns-back`
//! A widening cone nearly fills its sphere on one side: where both come close, great circles from the far pole meet the contact
//! twice.
//! ```
//! use cyclide::{Point3, Vec3, construct::{BlendBase, BlendTube, ContactBlend}};
//! let through = Point3::new(0.232, 0.0, -0.296);
//! let cone = BlendTube { through, direction: Vec3::Z, radius: 0.763, taper: -0.65, length: 9.0 };
//! let blend = ContactBlend::new(cone, BlendBase::Sphere { radius: 1.0 }, 0.01)?;
//! assert_eq!(blend.made().unwrap_err().reason(), "contact-loop-turns-back");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `contact-blend-folds`
//! The ball is too large to roll in the narrow corner of an inclined tube.
//! ```
//! use cyclide::{Point3, Vec3, construct::{BlendBase, BlendTube, ContactBlend, PlateShape}};
//! let direction = Vec3::new(0.0, 1.2, 1.0);
//! let tube = BlendTube { through: Point3::ORIGIN, direction, radius: 1.0, taper: 0.0, length: 90.0 };
//! let blend = ContactBlend::new(tube, BlendBase::Plane(PlateShape::Disk(90.0)), 4.0)?;
//! assert_eq!(blend.made().unwrap_err().reason(), "contact-blend-folds");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `contact-tube-too-short`
//! A strut on a sphere ends within its blend.
//! ```
//! use cyclide::{Point3, Vec3, construct::{BlendBase, BlendTube, ContactBlend}};
//! let tube = BlendTube { through: Point3::ORIGIN, direction: Vec3::Z, radius: 1.0, taper: 0.0, length: 4.2 };
//! let blend = ContactBlend::new(tube, BlendBase::Sphere { radius: 4.0 }, 0.5)?;
//! assert_eq!(blend.made().unwrap_err().reason(), "contact-tube-too-short");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tee-branches-meet`
//! Two branches of a tee are closer to each other than their blends allow.
//! ```
//! use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
//! let branch = |at| TeeBranch { at, ..TeeBranch::upright(2.0, 10.0, 0.5) };
//! assert_eq!(PipeTee::new(main, vec![branch(-2.0), branch(2.0)])?.made().unwrap_err().reason(), "tee-branches-meet");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tee-equal-branches-not-opposite`
//! Two branches as wide as the main pipe of a tee are beside each other, but not exactly opposite, or not at one position.
//! ```
//! use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
//! let branch = |azimuth| TeeBranch { azimuth, ..TeeBranch::upright(3.0, 10.0, 0.5) };
//! assert_eq!(PipeTee::new(main, vec![branch(0.0), branch(3.14)])?.made().unwrap_err().reason(), "tee-equal-branches-not-opposite");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `tee-no-free-line`
//! Two branches of a tee do not overlap, but others between them leave no free line along the main pipe.
//! ```
//! use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
//! let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
//! let branch = |radius, at, azimuth| TeeBranch { at, azimuth, ..TeeBranch::upright(radius, 10.0, 0.3) };
//! // The third reaches across all that is between the first two; the fourth is beside all of them.
//! let branches = vec![branch(1.5, 0.0, 0.0), branch(1.5, 0.0, 2.1), branch(1.5, 5.0, 1.0), branch(2.2, 2.5, 4.2)];
//! assert_eq!(PipeTee::new(main, branches)?.made().unwrap_err().reason(), "tee-no-free-line");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `ellipses-cross`
//! There is no solid between two ellipses that cross.
//! ```
//! use cyclide::construct::EllipseBridge;
//! let bridge = EllipseBridge::new([1.0, 3.0], [2.0, 2.0])?;
//! assert_eq!(bridge.body(Some(1.0)).unwrap_err().reason(), "ellipses-cross");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `piece-counts-differ`
//! Two curves whose pieces are to be joined one by one have different numbers of pieces.
//! ```
//! use cyclide::{Point3, curve::Arc, topology::{Body, EdgeCurve}};
//! let segment = |x: f64, y: f64| Arc::segment(Point3::new(x, y, 0.0), Point3::new(x + 1.0, y, 0.0)).map(EdgeCurve::from);
//! let error = Body::ruled([&[segment(0.0, 0.0)?, segment(1.0, 0.0)?], &[segment(0.0, 1.0)?]], false).unwrap_err();
//! assert_eq!(error.reason(), "piece-counts-differ");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `rulings-cross`
//! The straight lines between two curves cross, most often because one of the curves runs the other way.
//! ```
//! use cyclide::{Point3, curve::Arc, topology::Body};
//! let there = Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0))?;
//! let back = Arc::segment(Point3::new(1.0, 1.0, 0.0), Point3::new(0.0, 1.0, 0.0))?;
//! assert_eq!(Body::ruled([&[there.into()], &[back.into()]], false).unwrap_err().reason(), "rulings-cross");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `arcs-cross`
//! The arcs between two curves cross their neighbors, most often because one of the curves runs the other way.
//! ```
//! use cyclide::{Point3, Vec3, curve::Arc, topology::Body};
//! let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
//! let there = Arc::from_three_points(at(-1.0, 0.0), at(0.0, 0.1), at(1.0, 0.0))?;
//! let back = Arc::from_three_points(at(1.0, 0.5), at(0.0, 0.4), at(-1.0, 0.5))?;
//! let error = Body::circular([&[there.into()], &[back.into()]], &[Vec3::Z], false).unwrap_err();
//! assert_eq!(error.reason(), "arcs-cross");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `opposite-tangents`
//! The directions of arcs at two joints are opposite, so that none is defined between them.
//! ```
//! use cyclide::{Point3, Vec3, curve::Arc, topology::Body};
//! let rail = |y: f64| Arc::segment(Point3::new(0.0, y, 0.0), Point3::new(1.0, y, 0.0));
//! let error = Body::circular([&[rail(0.0)?.into()], &[rail(1.0)?.into()]], &[Vec3::Z, Vec3::Z * -3.0], false).unwrap_err();
//! assert_eq!(error.reason(), "opposite-tangents");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `degree-too-high`
//! A surface between curves would have a degree that no program reads.
//! ```
//! use cyclide::{Point3, Vec3, curve::Arc, rational::RationalBezier, topology::Body};
//! let low = Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0))?;
//! let high = RationalBezier::new((0..=12).map(|k| [f64::from(k), 1.0, 0.0, 1.0 + 0.1 * f64::from(k % 3)]).collect())?;
//! let error = Body::circular([&[low.into()], &[high.into()]], &[Vec3::Z], false).unwrap_err();
//! assert_eq!(error.reason(), "degree-too-high");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-a-face`
//! A loop of vertices is not a face: here one of its points does not exist.
//! ```
//! use cyclide::{Point3, construct::ConvexPolyhedron};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
//! let faces = [vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3], vec![0, 3, 4]];
//! assert_eq!(ConvexPolyhedron::new(&corners, &faces).unwrap_err().reason(), "not-a-face");
//! ```
//!
//! # `not-closed`
//! An edge of a polyhedron does not have one face on each side.
//! ```
//! use cyclide::{Point3, construct::ConvexPolyhedron};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
//! let three_of_four = [vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3]];
//! assert_eq!(ConvexPolyhedron::new(&corners, &three_of_four).unwrap_err().reason(), "not-closed");
//! ```
//!
//! # `non-planar-face`
//! A corner of a face is off its plane.
//! ```
//! use cyclide::{Point3, construct::ConvexPolyhedron};
//! let mut cube: Vec<Point3> = (0..8).map(|k| Point3::new((k & 1) as f64, (k >> 1 & 1) as f64, (k >> 2) as f64)).collect();
//! cube[7].z = 1.1;
//! let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]].map(|f| f.to_vec());
//! assert_eq!(ConvexPolyhedron::new(&cube, &faces).unwrap_err().reason(), "non-planar-face");
//! ```
//!
//! # `planes-miss-point`
//! The four planes of a sharp tip are tilted outwards by points beside its base, and meet farther from the tip than the
//! flatness.
//! ```
//! use cyclide::{Point3, construct::ConvexPolyhedron};
//! let ring = [[0.0, 0.0, 10.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
//! let base = [[0.76, 0.76, -5.0], [-0.75, 0.75, -5.0], [-0.76, -0.76, -5.0], [0.75, -0.75, -5.0]];
//! let points: Vec<Point3> = ring.into_iter().chain(base).map(Point3::from).collect();
//! assert_eq!(ConvexPolyhedron::hull_with_flatness(&points, 0.02).unwrap_err().reason(), "planes-miss-point");
//! assert!(ConvexPolyhedron::hull_with_flatness(&points, 0.04)?.deviation() > 0.03);
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `not-convex`
//! Faces form a reflex angle at an edge: here all of them, being clockwise.
//! ```
//! use cyclide::{Point3, construct::ConvexPolyhedron};
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
//! let clockwise = [vec![0, 1, 2], vec![0, 3, 1], vec![1, 3, 2], vec![0, 2, 3]];
//! assert_eq!(ConvexPolyhedron::new(&corners, &clockwise).unwrap_err().reason(), "not-convex");
//! ```
//!
//! # `flat-polyhedron`
//! Points in one plane, or within the flatness of one, bound no body.
//! ```
//! use cyclide::{Error, Point3, construct::ConvexPolyhedron, error::PolyhedronError};
//! let flat = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.5]].map(Point3::from);
//! let error = ConvexPolyhedron::hull_with_flatness(&flat, 0.6).unwrap_err();
//! assert_eq!(error.reason(), "flat-polyhedron");
//! assert!(matches!(error, Error::Polyhedron(PolyhedronError::Flat { thickness, limit }) if thickness <= 0.25 && limit == 0.6));
//! ```
//!
//! # `not-in-open-hemisphere`
//! Directions are not the corners of a convex polygon on one half of the sphere.
//! ```
//! use cyclide::{Vec3, construct::SphericalPolygon};
//! let clockwise = [Vec3::X, Vec3::Z, Vec3::Y];
//! assert_eq!(SphericalPolygon::new(&clockwise).unwrap_err().reason(), "not-in-open-hemisphere");
//! ```
