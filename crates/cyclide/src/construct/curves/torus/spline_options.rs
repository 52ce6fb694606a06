//! What a spline through points of a torus is asked for.

use crate::base::planar::Vec2;
use crate::base::vector::Vec3;

/// The tangent of a spline at one of its points.
///
/// ```
/// use cyclide::{Frame, Point2, Vec2, construct::{TorusSplineOptions, TorusTangent}, surface::{Torus, TorusSpline}};
/// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
/// let tangents = vec![TorusTangent::Rate(Vec2::new(1.0, 1.0)), TorusTangent::Free]; // start along a Villarceau circle
/// let options = TorusSplineOptions { tangents, ..Default::default() };
/// let spline = TorusSpline::through_places(&torus, &[Point2::new(0.0, 0.0), Point2::new(0.9, 0.2)], &options)?;
/// assert!((spline.unrolled_rate(0, 0.0) - Vec2::new(1.0, 1.0)).length() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum TorusTangent {
    /// Estimated from the neighbors.
    #[default]
    Free,
    /// Speed of the place in the plane of the torus, radians per unit of the knot parameter.
    Rate(Vec2),
    /// Velocity in space, by the knot parameter; what it has across the torus is left out.
    Velocity(Vec3),
}

/// Which way round a spline runs from point to point: places are given modulo pi.
///
/// ```
/// use cyclide::{Frame, Point2, construct::{TorusSplineOptions, TorusWinding}, surface::{Torus, TorusSpline}};
/// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
/// let places = [[0.0, 0.0], [1.0, 0.5], [2.0, 0.0]].map(Point2::from);
/// let options = TorusSplineOptions { closed: true, winding: TorusWinding::Total([1, -2]), ..Default::default() };
/// assert_eq!(TorusSpline::through_places(&torus, &places, &options)?.winding(), Some([1, -2]));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum TorusWinding {
    /// Each step by the shortest way: each angle by half pi at most.
    #[default]
    Shortest,
    /// A closed curve that runs so many times round the axis and round the tube: half turns are added to the steps that stay
    /// shortest. An open curve takes no notice.
    Total([i32; 2]),
    /// So many times pi added to both angles of the shortest step, for each segment in order.
    PerSegment(Vec<[i32; 2]>),
}

/// How [`TorusSpline::through_places`](crate::surface::TorusSpline::through_places) and
/// [`through_points`](crate::surface::TorusSpline::through_points) make their curve.
///
/// ```
/// use cyclide::{Frame, Point2, construct::TorusSplineOptions, surface::{Torus, TorusSpline}};
/// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
/// let options = TorusSplineOptions { knots: vec![0.0, 2.0, 2.5], ..Default::default() };
/// let spline = TorusSpline::through_places(&torus, &[[0.0, 0.0], [1.0, 0.5], [1.2, 0.7]].map(Point2::from), &options)?;
/// assert!(spline.jet_at_knot(2.0).point.distance(torus.point(Point2::new(1.0, 0.5))) < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TorusSplineOptions {
    /// The last point is joined to the first.
    pub closed: bool,
    /// One for each point; none at all if all are free.
    pub tangents: Vec<TorusTangent>,
    /// The parameter at each point, increasing, and of a closed curve at its end; none at all for 0, 1, 2, ....
    pub knots: Vec<f64>,
    /// Which way round it runs.
    pub winding: TorusWinding,
    /// Equal neighboring points get a loop between them and are no fault.
    pub loops: bool,
}
