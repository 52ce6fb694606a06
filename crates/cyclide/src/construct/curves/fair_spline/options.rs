//! What the user can ask of [`CircleSpline::fair`](crate::curve::CircleSpline::fair).

use crate::base::vector::Vec3;
use crate::error::{ErrorItem, NumberError, Result};

/// How a fair circle spline ends.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::{FairEnd, FairSplineOptions}, curve::CircleSpline};
/// let points = [[0.0, 0.0, 0.0], [1.0, 0.5, 0.0], [2.0, 0.0, 0.0]].map(Point3::from);
/// let options = FairSplineOptions { ends: [FairEnd::Clamped(Vec3::X * 3.0), FairEnd::Circle], ..Default::default() };
/// let spline = CircleSpline::fair(&points, &options)?;
/// assert!((spline.segments()[0].start_tangent() - Vec3::X).length() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum FairEnd {
    /// It leaves along the circle through the first (last) three points. The default: no bulges, circles and spheres are
    /// reproduced.
    #[default]
    Circle,
    /// The end segment is an arc. Fairer than `Circle` on smooth data, bulges after sharp turns.
    Arc,
    /// The curvature vanishes, as at the end of a free ruler.
    Free,
    /// Given tangent, of any length but zero, in the direction of travel.
    Clamped(Vec3),
}

/// How [`CircleSpline::fair`](crate::curve::CircleSpline::fair) makes its curve.
///
/// ```
/// use cyclide::{Point3, construct::FairSplineOptions, curve::{CircleSpline, ParamCurve}};
/// let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [6.0, 5.0, 2.0]].map(Point3::from);
/// let closed = CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() })?;
/// assert!(closed.is_closed());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FairSplineOptions {
    /// Closed curve through all points; the first point is not repeated at the end.
    pub closed: bool,
    /// First and last end of an open curve; without effect on a closed one, which a warning says.
    pub ends: [FairEnd; 2],
    /// From 0, the fairest curve, to 1, the circle spline of order 2, where every node follows its neighbors alone.
    pub tension: f64,
    /// Runs of points on a line beside a corner stay straight: the curve bends at the corner only.
    pub straight_runs: bool,
    /// At corners beside a straight run, further points on both legs at this part of the shorter one, below 0.5: the
    /// curve rounds the corner more tightly. The numbers in warnings stay those of the given points.
    pub tight: Option<f64>,
    /// Indices of points that stay corners: the curve is cut there, and both sides end as open curves do by default. The
    /// ends of an open curve may be listed without effect.
    pub corners: Vec<usize>,
    /// Points with a turn above 175 degrees are cut as cusps where the curve would swing out there. Without it the curve
    /// is relaxed.
    pub cut_sharp_turns: bool,
}

impl Default for FairSplineOptions {
    fn default() -> Self {
        Self {
            closed: false,
            ends: [FairEnd::default(); 2],
            tension: 0.0,
            straight_runs: true,
            tight: None,
            corners: Vec::new(),
            cut_sharp_turns: true,
        }
    }
}

impl FairSplineOptions {
    /// # Errors
    /// `parameter-out-of-range`.
    pub(super) fn check(&self) -> Result<()> {
        let in_range = |name, value: f64, max: f64, inside: bool| {
            if inside { Ok(()) } else { Err(NumberError::ParameterOutOfRange { name, value, min: 0.0, max }.into()) }
        };
        in_range(ErrorItem::Tension, self.tension, 1.0, (0.0..=1.0).contains(&self.tension))?;
        let tight = self.tight.unwrap_or(0.25);
        in_range(ErrorItem::Tight, tight, 0.5, tight > 0.0 && tight < 0.5)
    }
}
