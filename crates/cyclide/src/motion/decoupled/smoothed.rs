//! Noisy poses smoothed within tolerances, in linear time.
//!
//! Places and quaternions are smoothed apart, by natural cubic splines over the times: of those that are within the tolerance at every pose the search
//! keeps the one with the most smoothing. A few poses that are far off by chance do not decide for all: they get larger weights first.

use super::smoothing_spline::{natural_derivatives, smoothed};
use super::span::{PlaceSpan, TurnSpan, unit};
use super::turns::smooth_turns;
use super::{DecoupledMotion, Given};
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::error::{Error, ErrorItem, Result};
use crate::motion::timed_pose::TimedPose;
use crate::warning::Warning;

/// Decimal powers of the strengths that are tried, with times whose average step is 1: from none to waves of a thousand steps.
const STRENGTHS: [f64; 2] = [-4.0, 12.0];
/// Halvings of that range.
const HALVINGS: u32 = 8;
/// Rounds in which the weights of values that are too far off grow.
const ROUNDS: u32 = 8;
/// Values farther off than this part of the tolerance get larger weights.
const NEARLY: f64 = 0.9;

/// A tolerance should be this many times the distance of the farthest of all poses from what was measured, as noise makes it.
const ROOM: f64 = 1.15;
/// So many poses tell their noise.
const TELLING: usize = 20;
/// The median of the length of a vector of three Gaussian numbers of variance 1.
const MEDIAN_LENGTH: f64 = 1.538;

/// How far a smoothed motion may be from its poses. What has no tolerance is interpolated.
///
/// ```
/// use cyclide::MotionTolerance;
/// let tolerance = MotionTolerance { place: Some(0.5), angle: Some(0.01) };
/// assert!(tolerance != MotionTolerance::default());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotionTolerance {
    /// Of the origin of the body, a length.
    pub place: Option<f64>,
    /// Of the turn, radians.
    pub angle: Option<f64>,
}

/// How far a smoothed motion is from its poses, at their times.
///
/// ```
/// use cyclide::MotionDeviation;
/// let deviation = MotionDeviation { place: 0.4, angle: 0.009 };
/// assert!(deviation.place < 0.5);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionDeviation {
    /// The largest distance of the origin of the body.
    pub place: f64,
    /// The largest angle, radians.
    pub angle: f64,
}

impl DecoupledMotion {
    /// The smoothest motion, C2 where it is smoothed, within tolerances of poses at rising times: places and quaternions on natural cubic splines over the
    /// times. A tolerance that is left out leaves places, or turns, on the poses.
    ///
    /// ```
    /// use cyclide::{DecoupledMotion, MotionTolerance, Pose, Quat, TimedPose, Vec3};
    /// let noise = |k: u32| f64::from((k * 7919) % 101) / 50.0 - 1.0;
    /// let poses: Vec<TimedPose> = (0..60)
    ///     .map(|k| TimedPose { time: f64::from(k), pose: Pose::new(Quat::ONE, Vec3::new(f64::from(k), noise(k), 0.0)).unwrap() })
    ///     .collect();
    /// let tolerance = MotionTolerance { place: Some(1.2), angle: None };
    /// let motion = DecoupledMotion::smoothed(&poses, tolerance)?;
    /// assert!(motion.deviation().is_some_and(|off| off.place <= 1.2));
    /// assert!((1..59).all(|k| motion.jet(f64::from(k), cyclide::Point3::ORIGIN).point.d2.length() < 0.1)); // those of the poses are about 2
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `wrong-pose-count`, `not-finite`, `parameters-not-increasing`, `parameter-out-of-range` (a tolerance that is not positive, or an angle above a right one).
    pub fn smoothed(poses: &[TimedPose], tolerance: MotionTolerance) -> Result<Self> {
        let positive = |name, given: Option<f64>, max: f64| match given {
            Some(value) if !(value > 0.0 && value <= max) => {
                Err(Error::ParameterOutOfRange { name, value, min: 0.0, max })
            }
            given => Ok(given),
        };
        let place = positive(ErrorItem::Tolerance, tolerance.place, f64::MAX)?;
        let angle = positive(ErrorItem::Angle, tolerance.angle, std::f64::consts::FRAC_PI_2)?;
        let given = Given::new(poses, None)?;
        let average = (given.times[given.spans()] - given.times[0]) / given.spans() as f64;
        let steps: Vec<f64> = given.steps().into_iter().map(|step| step / average).collect();
        let centre = given.places.iter().fold(Vec3::ZERO, |sum, place| sum + *place / given.places.len() as f64);
        let places: Vec<[f64; 3]> = given.places.iter().map(|place| (*place - centre).to_array()).collect();
        let distance = |i: usize, x: &[f64; 3]| (Vec3::from(*x) - Vec3::from(places[i])).length();
        let smooth_places = match place {
            Some(limit) => strongest(&places, &steps, &|i, x| distance(i, x) / limit),
            None => places.clone(),
        };
        let place_spans = cubics(&smooth_places, &steps)
            .into_iter()
            .map(|points| PlaceSpan::Polynomial(points.map(|p| (Vec3::from(p) + centre).to_array()).to_vec()));
        let rotations: Vec<[f64; 4]> = given.rotations.iter().map(|q| q.to_array()).collect();
        let off = |i: usize, x: &[f64; 4]| angle_between(Quat::from(*x), given.rotations[i]);
        let (smooth_rotations, turns) = match angle {
            Some(limit) => {
                let smooth = strongest(&rotations, &steps, &|i, x| off(i, x) / limit);
                let turns = cubics(&smooth, &steps).into_iter().map(TurnSpan::Cubic).collect();
                (smooth, turns)
            }
            None => (rotations.clone(), smooth_turns(&given)),
        };
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let deviation = MotionDeviation {
            place: most(&mut smooth_places.iter().enumerate().map(|(i, x)| distance(i, x))),
            angle: most(&mut smooth_rotations.iter().enumerate().map(|(i, x)| off(i, x))),
        };
        // An angle is twice that of quaternions.
        let noises = [(false, place, noise(&places)), (true, angle, noise(&rotations).map(|sigma| 2.0 * sigma))];
        let below_noise = noises.into_iter().filter_map(|(turning, tolerance, sigma)| {
            let (tolerance, sigma) = (tolerance?, sigma?);
            let needed = ROOM * farthest(given.rotations.len()) * sigma;
            (tolerance < needed).then_some(Warning::PosesNoisier { turning, sigma, tolerance, needed })
        });
        let below_noise = below_noise.collect();
        let places = place_spans.collect();
        let motion = given.into_motion(places, turns);
        Ok(Self { deviation: Some(deviation), below_noise, ..motion })
    }
}

/// The length, in standard deviations along one axis, that one of so many vectors of Gaussian noise in space exceeds on average:
/// `n sqrt(2/π) x e^(-x²/2) = 1`, solved by substitution.
fn farthest(count: usize) -> f64 {
    let part = (2.0 / std::f64::consts::PI).sqrt() * count.max(TELLING) as f64;
    (0..8).fold(3.0, |x: f64, _| (2.0 * (part * x).ln()).sqrt())
}

/// The standard deviation along one axis of the noise of values, by the median of their third differences, which know nothing of what is smooth.
fn noise<const D: usize>(values: &[[f64; D]]) -> Option<f64> {
    if values.len() < TELLING {
        return None;
    }
    let third = |w: &[[f64; D]]| (0..D).map(|k| (w[3][k] - 3.0 * (w[2][k] - w[1][k]) - w[0][k]).powi(2)).sum::<f64>();
    let mut squares: Vec<f64> = values.windows(4).map(third).collect();
    squares.sort_by(f64::total_cmp);
    // Of weights 1, 3, 3, 1.
    Some((squares[squares.len() / 2] / 20.0).sqrt() / MEDIAN_LENGTH)
}

/// The angle between two rotations, the first of any length.
fn angle_between(a: Quat, b: Quat) -> f64 {
    let between = unit(a) * b.conj();
    2.0 * between.vector().length().atan2(between.w.abs())
}

/// The Bézier points of the natural cubic spline through values, span by span.
fn cubics<const D: usize>(values: &[[f64; D]], steps: &[f64]) -> Vec<[[f64; D]; 4]> {
    let slopes = natural_derivatives(values, steps);
    let towards = |i: usize, by: f64| -> [f64; D] { std::array::from_fn(|k| values[i][k] + slopes[i][k] * by / 3.0) };
    (0..steps.len()).map(|i| [values[i], towards(i, steps[i]), towards(i + 1, -steps[i]), values[i + 1]]).collect()
}

/// The values smoothed as much as leaves all of them off by 1 at most; `off` says how far one is.
fn strongest<const D: usize>(
    values: &[[f64; D]],
    steps: &[f64],
    off: &dyn Fn(usize, &[f64; D]) -> f64,
) -> Vec<[f64; D]> {
    if values.len() < 3 {
        return values.to_vec();
    }
    let within = |power: f64| {
        let mut weights = vec![1.0; values.len()];
        for _ in 0..ROUNDS {
            let smooth = smoothed(values, steps, &weights, 10.0_f64.powf(power));
            let offs: Vec<f64> = smooth.iter().enumerate().map(|(i, x)| off(i, x)).collect();
            if offs.iter().all(|off| *off <= 1.0) {
                return Some(smooth);
            }
            for (weight, off) in weights.iter_mut().zip(offs).filter(|(_, off)| *off > NEARLY) {
                *weight *= (off / NEARLY).powi(2).min(1e3);
            }
        }
        None
    };
    let [mut weak, mut strong] = STRENGTHS;
    if let Some(found) = within(strong) {
        return found;
    }
    let Some(mut found) = within(weak) else { return values.to_vec() };
    for _ in 0..HALVINGS {
        let middle = 0.5 * (weak + strong);
        match within(middle) {
            Some(smooth) => (found, weak) = (smooth, middle),
            None => strong = middle,
        }
    }
    found
}
