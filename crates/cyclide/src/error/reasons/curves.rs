//! Errors about arcs, circles, splines and fits.
//!
//! # `pole-on-segment`
//! The weights make an arc that passes through infinity.
//! ```
//! use cyclide::{Point3, Quat, curve::Arc};
//! let error = Arc::from_weights(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Quat::ONE, -Quat::ONE).unwrap_err();
//! assert_eq!(error.reason(), "pole-on-segment");
//! ```
//!
//! # `nearly-full-circle`
//! An arc turns by so nearly a full circle that its points lose precision.
//! ```
//! use cyclide::{Point3, Vec3, curve::Arc};
//! let error = Arc::from_bulge(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Vec3::Z, 1e9).unwrap_err();
//! assert_eq!(error.reason(), "nearly-full-circle");
//! ```
//!
//! # `not-in-im-h`
//! A weight is not perpendicular to the chord: the arc would leave three-space.
//! ```
//! use cyclide::{Point3, Quat, curve::Arc};
//! let along = Quat::new(1.0, 1.0, 0.0, 0.0);
//! let error = Arc::from_weights(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Quat::ONE, along).unwrap_err();
//! assert_eq!(error.reason(), "not-in-im-h");
//! ```
//!
//! # `tangent-opposes-chord`
//! A tangent points straight away from the other end.
//! ```
//! use cyclide::{Point3, Vec3, curve::Arc};
//! let error = Arc::from_start_tangent(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), -Vec3::X).unwrap_err();
//! assert_eq!(error.reason(), "tangent-opposes-chord");
//! ```
//!
//! # `degenerate-circle`
//! Three points on a line have no circle.
//! ```
//! use cyclide::{Point3, curve::Circle};
//! let line = [0.0, 1.0, 3.0].map(|x| Point3::new(x, 0.0, 0.0));
//! assert_eq!(Circle::through_points(line).unwrap_err().reason(), "degenerate-circle");
//! ```
//!
//! # `degenerate-sphere`
//! Four points in a plane have no sphere.
//! ```
//! use cyclide::{Point3, conformal::Sphere};
//! let plane = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [2.0, 2.0, 0.0]].map(Point3::from);
//! assert_eq!(Sphere::through_points(plane).unwrap_err().reason(), "degenerate-sphere");
//! ```
//!
//! # `no-finite-biarc`
//! No two arcs with a common tangent join the data.
//! ```
//! use cyclide::{Point3, Vec3, construct::{Biarc, BiarcRule}};
//! let (a, b) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
//! let error = Biarc::new(a, -Vec3::X, b, -Vec3::X, BiarcRule::Auto).unwrap_err();
//! assert_eq!(error.reason(), "no-finite-biarc");
//! ```
//!
//! # `tangent-undefined`
//! Points turn back on themselves, where no tangent can be estimated.
//! ```
//! use cyclide::{Point3, construct::ArcSplineOptions, curve::ArcPath};
//! let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 0.0]].map(Point3::from);
//! let error = ArcPath::spline(&points, &ArcSplineOptions::default()).unwrap_err();
//! assert_eq!(error.reason(), "tangent-undefined");
//! ```
//!
//! # `arc-through-infinity`
//! A circle of a blend starts opposite to its chord.
//! ```
//! use cyclide::{Point3, Vec3, curve::{BlendSegment, BlendVariant}};
//! let (a, b) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
//! let error = BlendSegment::hermite(a, -Vec3::X, b, Vec3::X, 2, BlendVariant::Rational).unwrap_err();
//! assert_eq!(error.reason(), "arc-through-infinity");
//! ```
//!
//! # `ambiguous-half-turn`
//! Two circles have opposite tangents along the chord, except for rounding: the half-turn between them may go through any plane.
//! ```
//! use cyclide::{Point3, Vec3, curve::{BlendSegment, BlendVariant}};
//! let (a, b) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
//! let (start, end) = (Vec3::new(1.0, 0.9999e-9, 0.0), Vec3::new(-1.0, 1.0001e-9, 0.0));
//! let error = BlendSegment::hermite(a, start, b, end, 2, BlendVariant::Rational).unwrap_err();
//! assert_eq!(error.reason(), "ambiguous-half-turn");
//! ```
//!
//! # `disconnected`
//! A piece of a path does not start where the previous one ends.
//! ```
//! use cyclide::{Point3, curve::{Arc, ArcPath}};
//! let segment = |from: f64, to: f64| Arc::segment(Point3::new(from, 0.0, 0.0), Point3::new(to, 0.0, 0.0));
//! let error = ArcPath::new(vec![segment(0.0, 1.0)?, segment(2.0, 3.0)?], false).unwrap_err();
//! assert_eq!(error.reason(), "disconnected");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `knots-decrease`
//! A knot is less than the previous one.
//! ```
//! use cyclide::{Point3, rational::NurbsCurve};
//! let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from).to_vec();
//! let error = NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 0.9, 1.0], points, vec![1.0; 3]).unwrap_err();
//! assert_eq!(error.reason(), "knots-decrease");
//! assert_eq!(error.index(), Some(4));
//! ```
//!
//! # `knot-multiplicity`
//! A knot has so high a multiplicity that the curve is disconnected there.
//! ```
//! use cyclide::{Point3, rational::NurbsCurve};
//! let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]].map(Point3::from).to_vec();
//! let error = NurbsCurve::new(1, vec![0.0, 0.0, 0.5, 0.5, 1.0, 1.0], points, vec![1.0; 4]).unwrap_err();
//! assert_eq!(error.reason(), "knot-multiplicity");
//! assert_eq!(error.index(), Some(2));
//! ```
//!
//! # `not-a-spline`
//! Knots, weights and points of a spline do not fit together: here the ends are not clamped.
//! ```
//! use cyclide::{Point3, rational::NurbsCurve};
//! let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from).to_vec();
//! let error = NurbsCurve::new(2, vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0], points, vec![1.0; 3]).unwrap_err();
//! assert_eq!(error.reason(), "not-a-spline");
//! ```
//!
//! # `not-within-tolerance`
//! No chord, however short, is proved to be within the tolerance: it is below the rounding of the points.
//! ```
//! use cyclide::{Point3, mesh::flatten, rational::NurbsCurve};
//! let points = [[1e9, 0.0, 0.0], [1e9 + 1.0, 1.0, 0.0], [1e9 + 2.0, 0.0, 0.0]].map(Point3::from).to_vec();
//! let far = NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points, vec![1.0, 2.0, 1.0])?;
//! assert_eq!(flatten(&far, 1e-9).unwrap_err().reason(), "not-within-tolerance");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `no-frame`
//! The direction that defines a frame vanishes: here the curvature of a straight line has no direction.
//! ```
//! use cyclide::{Point3, curve::{Arc, CurveFrames, FrameRule}};
//! let line = Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0))?;
//! let error = CurveFrames::new(&line, &FrameRule::Frenet)?.at(0.5).unwrap_err();
//! assert_eq!(error.reason(), "no-frame");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `no-g1-spline-in-tube`
//! The search for tangent arcs within the tolerance of a polyline does not get past a vertex.
//! ```
//! use cyclide::{Point3, construct::{ArcFit, ArcFitOptions, FitTarget}};
//! let points = [
//!     [0.0, 0.0],
//!     [0.001396136825860192, 0.0002658291767813673],
//!     [0.028466842482326168, 0.015432042093839051],
//!     [0.028596732204657815, 0.015492004942723802],
//!     [0.05035439623533945, 0.02734672223265036],
//!     [0.05059622764638955, 0.027542716273130024],
//!     [0.766314997501115, 0.6359705768777246],
//!     [1.3390979039628366, 1.1004304063586954],
//!     [1.5141648363581874, 1.2656619716334785],
//! ];
//! // From there on the same backwards, turned about the middle: no way from that end either.
//! let half = points.map(|[x, y]| Point3::new(x, y, 0.0));
//! let middle = half[8] + (half[8] - half[7]) * 0.5;
//! let points: Vec<_> = half.into_iter().chain(half.iter().rev().map(|p| middle + (middle - *p))).collect();
//! let error = ArcFit::new(&points, &ArcFitOptions { target: FitTarget::Polyline, ..ArcFitOptions::new(1e-4) }).unwrap_err();
//! assert_eq!(error.reason(), "no-g1-spline-in-tube");
//! ```
//!
//! # `arc-limit-not-kept`
//! A machine takes no arcs below some radius or length, and none other were found within the tolerance: here a half circle
//! of radius 1.
//! ```
//! use cyclide::{Point3, construct::{ArcFit, ArcFitOptions}};
//! let at = |k: i32| (0.1 * f64::from(k)).sin_cos();
//! let half: Vec<Point3> = (0..=31).map(at).map(|(s, c)| Point3::new(c, s, 0.0)).collect();
//! let error = ArcFit::new(&half, &ArcFitOptions { min_radius: Some(2.0), ..ArcFitOptions::new(0.01) }).unwrap_err();
//! assert_eq!(error.reason(), "arc-limit-not-kept");
//! ```
//!
//! # `tolerance-not-reached`
//! No fair curve within the tolerance was found: here points all over the place, none of which may be a corner.
//! ```
//! use cyclide::{Point3, construct::{FairFit, FairFitOptions}};
//! let at = |k: i32| Point3::new(f64::from(7 * k * k).sin(), f64::from(3 * k * k).cos(), 0.0);
//! let cloud: Vec<Point3> = (0..60).map(at).collect();
//! let options = FairFitOptions { corner_angle: Some(3.14), ..FairFitOptions::new(0.01) };
//! let error = FairFit::new(&cloud, &options).unwrap_err();
//! assert_eq!(error.reason(), "tolerance-not-reached");
//! ```
//!
//! # `curve-lost`
//! A fair curve within the tolerance would leave the points between two of them, by far more than these are apart: here at a thin
//! tooth that is not to have corners.
//! ```
//! use cyclide::{Point3, construct::{FairFit, FairFitOptions}};
//! let corners = [[0.0, 0.0], [100.0, 0.0], [100.0, 39.5], [103.0, 40.0], [100.0, 40.5], [100.0, 70.0], [0.0, 70.0_f64]];
//! let side = |k: usize| {
//!     let (a, b) = (corners[k], corners[(k + 1) % 7]);
//!     let n = (b[0] - a[0]).hypot(b[1] - a[1]).floor();
//!     let at = move |t: f64| Point3::new(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0.0);
//!     (0..n as u32).map(move |i| at(f64::from(i) / n))
//! };
//! let plate: Vec<Point3> = (0..7).flat_map(side).collect();
//! let options = FairFitOptions { closed: true, corner_angle: Some(3.0), ..FairFitOptions::new(0.5) };
//! let error = FairFit::new(&plate, &options).unwrap_err();
//! assert_eq!(error.reason(), "curve-lost");
//! ```
//!
//! # `noise-not-smoothed`
//! No curve follows the points without their noise: here waves that are hardly longer than their noise is wide.
//! ```
//! use cyclide::{Point3, construct::{FairFit, FairFitOptions, Noise}};
//! let noise = |k: f64, f: f64| (f * k * k).sin();
//! let wave = |k: f64| 30.0 * (60.0 * (k / 120.0).powi(2)).sin();
//! let at = |k: f64| Point3::new(0.5 * k + noise(k, 9.1), wave(k) + noise(k, 5.3), 0.0);
//! let points: Vec<Point3> = (0..120).map(|k| at(f64::from(k))).collect();
//! let error = FairFit::new(&points, &FairFitOptions::by_noise(Noise::Estimated)).unwrap_err();
//! assert_eq!(error.reason(), "noise-not-smoothed");
//! ```
//!
//! # `outliers`
//! Points far from all other points keep a fair curve from reaching its tolerance.
//! ```
//! use cyclide::{Point3, construct::{FairFit, FairFitOptions}};
//! let at = |k: u32| {
//!     let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 200.0).sin_cos();
//!     let noise = [9.1, 5.3].map(|f| 0.05 * (f * f64::from(k * k)).sin());
//!     Point3::new(10.0 * cos + noise[0], 10.0 * sin + noise[1], 0.0)
//! };
//! let mut points: Vec<Point3> = (0..200).map(at).collect();
//! for (k, x) in [(3, 4.0), (43, -4.0), (83, 4.0), (123, -4.0), (163, 4.0)] {
//!     points[k] = Point3::new(points[k].x + x, points[k].y + 2.0, 0.0);
//! }
//! let error = FairFit::new(&points, &FairFitOptions { closed: true, ..FairFitOptions::new(0.5) }).unwrap_err();
//! assert_eq!(error.reason(), "outliers");
//! assert_eq!(error.index(), Some(3));
//! ```
//!
//! # `even-point-count`
//! A curve of degree n needs 2n + 1 conditions.
//! ```
//! use cyclide::{Point3, construct::{NodeParameters, QbInterpolation}};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]].map(Point3::from);
//! let error = QbInterpolation::through_points(&points, &NodeParameters::Uniform).unwrap_err();
//! assert_eq!(error.reason(), "even-point-count");
//! ```
//!
//! # `repeated-parameter`
//! Two points have the same parameter.
//! ```
//! use cyclide::{Point3, construct::{NodeParameters, QbInterpolation}};
//! let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from);
//! let error = QbInterpolation::through_points(&points, &NodeParameters::Given(vec![0.0, 0.5, 0.5])).unwrap_err();
//! assert_eq!(error.reason(), "repeated-parameter");
//! ```
//!
//! # `unattainable-point`
//! Four points lie evenly on a line, and so does the curve: it misses the fifth.
//! ```
//! use cyclide::{Point3, construct::{NodeParameters, QbInterpolation}};
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 0.0, 0.0], [4.0, 0.0, 0.0]].map(Point3::from);
//! let error = QbInterpolation::through_points(&points, &NodeParameters::Uniform).unwrap_err();
//! assert_eq!(error.index(), Some(2));
//! assert_eq!(error.reason(), "unattainable-point");
//! ```
//!
//! # `curve-through-infinity`
//! The points go there and back on a line, which a circle does through infinity.
//! ```
//! use cyclide::{Point3, construct::{NodeParameters, QbInterpolation}};
//! let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 0.0]].map(Point3::from);
//! let error = QbInterpolation::through_points(&points, &NodeParameters::Uniform).unwrap_err();
//! assert_eq!(error.reason(), "curve-through-infinity");
//! ```
//!
//! # `opposite-arcs`
//! Both tangents are perpendicular to the chord, on the same side.
//! ```
//! use cyclide::{Point3, Vec3, curve::QbCurve};
//! let ends = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]].map(Point3::from);
//! assert_eq!(QbCurve::invariant_span(ends, [Vec3::Y; 2]).unwrap_err().reason(), "opposite-arcs");
//! ```
