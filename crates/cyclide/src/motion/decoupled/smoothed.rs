//! Noisy poses smoothed within tolerances, in linear time.
//!
//! Places and quaternions are smoothed apart, by natural cubic splines over the times: of those that are within the tolerance at every pose the search
//! keeps the one with the most smoothing. A few poses that are far off by chance do not decide for all: they get larger weights first.

use super::pose_noise::{Noise, Stray, TELLING, Track};
use super::smoothing_spline::{natural_derivatives, smoothed};
use super::span::{PlaceSpan, TurnSpan, rotation_vector, unit};
use super::{DecoupledMotion, Given};
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::error::{Error, ErrorItem, NumberError, PoseError, Result};
use crate::motion::swings::{PartSwings, Run, SAME_PLACE, SAME_TURN, parts};
use crate::motion::timed_pose::TimedPose;
use crate::warning::{PoseFitWarning, Warning};

/// Decimal powers of the strengths that are tried, with times whose average step is 1: from none to waves of a thousand steps.
pub(super) const STRENGTHS: [f64; 2] = [-4.0, 12.0];
/// Halvings of that range.
const HALVINGS: u32 = 8;
/// Rounds in which the weights of values that are too far off grow.
const ROUNDS: u32 = 8;
/// Values farther off than this part of the tolerance get larger weights.
const NEARLY: f64 = 0.9;

/// A tolerance should be this many times the distance of the farthest of all poses from what was measured, as noise makes it.
const ROOM: f64 = 1.15;
/// Outliers that are named one by one, of places and of turns.
const NAMED: usize = 20;
/// A path shorter than this part of that of the poses without their noise has lost shape,
const LENGTH_KEPT: f64 = 0.8;
/// where it is shorter by more than so many times what noise does.
const BY_NOISE: f64 = 4.0;
/// A tolerance is above the noise where the motion is farther from the poses without it than they were, by this factor: they are known to a few hundredths.
const FARTHER: f64 = 1.1;
/// A tolerance of more deviations is meant for something else than noise, such as the rounding of poses.
const MEANT: f64 = 100.0;
/// Tolerances above this part of the extent of the path are wide.
const WIDE: f64 = 0.12;
/// Places that run beyond their poses by so many roundings of their coordinates do not.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;
/// Spans over which a closed spline is begun and goes on: beyond, its slopes do not know where it ended;
const BEYOND: usize = 64;
/// and over which closed values are smoothed before and after: a few times the length over which the strongest smoothing averages.
const MEMORY: usize = 6000;

/// By what poses are smoothed.
///
/// ```
/// use cyclide::motion::PoseLimit;
/// assert_eq!(PoseLimit::from(0.5), PoseLimit::Within(0.5));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PoseLimit {
    /// As much as is possible within this of every pose: a length, or radians.
    Within(f64),
    /// As much as their noise calls for, which is read from the poses: the expected distance from the poses without their noise is least.
    ByNoise,
}

impl From<f64> for PoseLimit {
    fn from(limit: f64) -> Self {
        Self::Within(limit)
    }
}

impl PoseLimit {
    const fn bound(self) -> Option<f64> {
        match self {
            Self::Within(limit) => Some(limit),
            Self::ByNoise => None,
        }
    }
}

/// How far a smoothed motion may be from its poses. What has no limit is interpolated.
///
/// ```
/// use cyclide::motion::{MotionTolerance, PoseLimit};
/// let tolerance = MotionTolerance { place: Some(0.5.into()), angle: Some(PoseLimit::ByNoise) };
/// assert!(tolerance != MotionTolerance::default());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotionTolerance {
    /// Of the origin of the body, a length.
    pub place: Option<PoseLimit>,
    /// Of the turn, radians.
    pub angle: Option<PoseLimit>,
}

/// How far a smoothed motion is from its poses, at their times.
///
/// ```
/// use cyclide::motion::MotionDeviation;
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
    /// use cyclide::{Quat, Vec3, motion::{DecoupledMotion, MotionTolerance, Pose, TimedPose}};
    /// let noise = |k: u32| f64::from((k * 7919) % 101) / 50.0 - 1.0;
    /// let poses: Vec<TimedPose> = (0..60)
    ///     .map(|k| TimedPose { time: f64::from(k), pose: Pose::new(Quat::ONE, Vec3::new(f64::from(k), noise(k), 0.0)).unwrap() })
    ///     .collect();
    /// let tolerance = MotionTolerance { place: Some(1.2.into()), angle: None };
    /// let motion = DecoupledMotion::smoothed(&poses, tolerance)?;
    /// assert!(motion.deviation().is_some_and(|off| off.place <= 1.2));
    /// assert!((1..59).all(|k| motion.jet(f64::from(k), cyclide::Point3::ORIGIN).point.d2.length() < 0.1)); // those of the poses are about 2
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `wrong-pose-count` (also fewer than 20 for their noise), `not-finite`, `parameters-not-increasing`, `parameter-out-of-range` (a tolerance that is not
    /// positive, or an angle above a right one).
    pub fn smoothed(poses: &[TimedPose], tolerance: MotionTolerance) -> Result<Self> {
        Self::smoothed_with(poses, None, tolerance, false)
    }

    /// As [`smoothed`](Self::smoothed); with `closing` the time at which it is back at its first pose, C2 there too; and with `drop_outliers` without the poses that
    /// do not belong to the others. These are named in any case, by [`warnings`](Self::warnings).
    ///
    /// ```
    /// use cyclide::{Quat, Vec3, motion::{DecoupledMotion, MotionTolerance, Pose, TimedPose}};
    /// let at = |k: u32| Vec3::new((0.1 * f64::from(k)).cos(), (0.1 * f64::from(k)).sin(), 0.0) * 100.0;
    /// let mut poses: Vec<TimedPose> =
    ///     (0..60).map(|k| TimedPose { time: f64::from(k), pose: Pose::new(Quat::ONE, at(k)).unwrap() }).collect();
    /// poses[20].pose = Pose::IDENTITY;
    /// let tolerance = MotionTolerance { place: Some(1.0.into()), angle: None };
    /// let motion = DecoupledMotion::smoothed_with(&poses, None, tolerance, true)?;
    /// assert!((motion.pose(20.0).translation() - at(20)).length() < 1.5);
    /// assert_eq!(motion.warnings()[0].reason(), "outlier");
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`smoothed`](Self::smoothed).
    pub fn smoothed_with(
        poses: &[TimedPose],
        closing: Option<f64>,
        tolerance: MotionTolerance,
        drop_outliers: bool,
    ) -> Result<Self> {
        let checked = |name, given: Option<PoseLimit>, max: f64| match given {
            Some(PoseLimit::Within(value)) if !(value > 0.0 && value <= max) => {
                Err(Error::Number(NumberError::ParameterOutOfRange { name, value, min: 0.0, max }))
            }
            Some(PoseLimit::ByNoise) if poses.len() < TELLING => {
                Err(Error::Pose(PoseError::WrongPoseCount { given: poses.len(), needed: TELLING, or_more: true }))
            }
            given => Ok(given),
        };
        let place = checked(ErrorItem::Tolerance, tolerance.place, f64::MAX)?;
        let angle = checked(ErrorItem::Angle, tolerance.angle, std::f64::consts::FRAC_PI_2)?;
        let given = Given::new(poses, closing)?;
        let mut read = [Reading::of(&given, false, place), Reading::of(&given, true, angle)];
        let mut warnings: Vec<Warning> = read.iter().flat_map(|reading| reading.outliers(drop_outliers)).collect();
        let mut left = vec![true; poses.len()];
        read.iter().flat_map(|reading| &reading.strays).for_each(|stray| left[stray.pose] = false);
        let numbers: Vec<usize> = (0..poses.len()).filter(|pose| !drop_outliers || left[*pose]).collect();
        let given = if drop_outliers && left.contains(&false) {
            let kept: Vec<TimedPose> =
                poses.iter().zip(&left).filter(|(_, left)| **left).map(|(pose, _)| *pose).collect();
            // A closed one is back at the first of them, as long behind it as before.
            let closing = closing.map(|closing| closing + kept[0].time - poses[0].time);
            read.iter_mut().for_each(|reading| reading.strays.clear());
            Given::new(&kept, closing)?
        } else {
            given
        };
        let (places, turns) = (Values::places(&given), Values::turns(&given));
        let smooth_places = read[0].smoothed(&places);
        let smooth_turns = read[1].smoothed(&turns);
        warnings.extend(read[0].doubts(&places, &smooth_places));
        warnings.extend(read[1].doubts(&turns, &smooth_turns));
        let place_spans = places.cubics(&smooth_places).into_iter();
        let centre = places.centre;
        let place_spans = place_spans.map(|points| {
            PlaceSpan::Polynomial(points.map(|[x, y, z]| [x + centre.x, y + centre.y, z + centre.z]).to_vec())
        });
        let place_spans = place_spans.collect();
        let turn_spans = match angle {
            Some(_) => turns.cubics(&smooth_turns).into_iter().map(TurnSpan::Cubic).collect(),
            None => super::turns::smooth_turns(&given),
        };
        let deviation =
            MotionDeviation { place: places.farthest(&smooth_places), angle: turns.farthest(&smooth_turns) };
        let closed = given.closed;
        let motion = given.into_motion(place_spans, turn_spans);
        let [place_least, turn_least] = [&read[0], &read[1]].map(Reading::least_swing);
        let place_swings = place_least.and_then(|least| motion.place_swings(closed, least));
        let turn_swings = turn_least.and_then(|least| motion.turn_swings(closed, least));
        let swinging = [place_swings.map(|found| (found, false)), turn_swings.map(|found| (found, true))];
        let swinging = swinging.into_iter().flatten();
        warnings.extend(swinging.map(|(PartSwings { span, count, ratio, beyond }, turning)| {
            Warning::PoseFit(PoseFitWarning::Swings { span: numbers[span], count, turning, ratio, beyond })
        }));
        Ok(Self { deviation: Some(deviation), smoothing: warnings, ..motion })
    }
}

impl DecoupledMotion {
    /// Where its places run beyond those of the poses, by more than this.
    fn place_swings(&self, closed: bool, least: f64) -> Option<PartSwings> {
        let place = |span: usize, u: f64| self.places[span].place(u, None);
        let run = |(span, times): (usize, &[f64])| {
            let ends = [0.0, 1.0].map(|u| self.places[span].jet(u, None).d1);
            Run::new(place(span, 1.0) - place(span, 0.0), times[1] - times[0], ends)
        };
        let way = |span: usize| parts().map(|[from, to]| (place(span, to) - place(span, from)).length()).sum();
        let first = self.pose_places[0];
        let extent = self.pose_places.iter().map(|pose| (*pose - first).length()).fold(0.0, f64::max);
        let size = self.pose_places.iter().map(|pose| pose.max_abs()).fold(0.0, f64::max);
        let least = least.max(SAME_PLACE * extent + ROUNDINGS * size);
        PartSwings::of(self.times.windows(2).enumerate().map(run).collect(), closed, least, way)
    }

    /// Where its turns do.
    fn turn_swings(&self, closed: bool, least: f64) -> Option<PartSwings> {
        let turn = |span: usize, [from, to]: [f64; 2]| {
            let [a, b] = [from, to].map(|u| self.turns[span].rotation(u));
            rotation_vector([a, if a.dot(b) < 0.0 { b * -1.0 } else { b }])
        };
        let run = |(span, times): (usize, &[f64])| {
            let ends = [0.0, 1.0].map(|u| self.turns[span].jet(u).angular[0]);
            Run::new(turn(span, [0.0, 1.0]), times[1] - times[0], ends)
        };
        let way = |span: usize| parts().map(|ends| turn(span, ends).length()).sum();
        let runs = self.times.windows(2).enumerate().map(run).collect();
        PartSwings::of(runs, closed, least.max(SAME_TURN), way)
    }
}

/// What the poses say of themselves, in place or in angle.
struct Reading {
    turning: bool,
    limit: Option<PoseLimit>,
    noise: Option<Noise>,
    strays: Vec<Stray>,
    count: usize,
}

impl Reading {
    /// Of poses without the first one again. Where nothing is smoothed the motion passes through outliers, which are named all the more.
    fn of(given: &Given, turning: bool, limit: Option<PoseLimit>) -> Self {
        let count = given.places.len() - usize::from(given.closed);
        let places = |a: usize, b: usize| given.places[b] - given.places[a];
        let turns = |a: usize, b: usize| {
            let [a, b] = [given.rotations[a], given.rotations[b]];
            rotation_vector([a, if a.dot(b) < 0.0 { b * -1.0 } else { b }])
        };
        let period = given.closed.then(|| given.times[count] - given.times[0]);
        let between: &dyn Fn(usize, usize) -> Vec3 = if turning { &turns } else { &places };
        let track = Track { times: &given.times[..count], period, between };
        let strays = track.strays(limit.and_then(PoseLimit::bound).unwrap_or(0.0));
        let mut list = track.all();
        list.retain(|pose| strays.binary_search_by_key(pose, |stray| stray.pose).is_err());
        Self { turning, limit, noise: track.noise(&list), strays, count }
    }

    /// The outliers by name.
    fn outliers(&self, dropped: bool) -> Vec<Warning> {
        let (turning, count) = (self.turning, self.strays.len());
        let noise = self.noise.map_or(0.0, |noise| noise.sigma);
        let named = self.strays.iter().take(NAMED);
        let named = named.map(|Stray { pose, distance }| {
            Warning::PoseFit(PoseFitWarning::Outlier {
                pose: *pose,
                turning,
                distance: *distance,
                noise,
                dropped,
                count,
            })
        });
        named.collect()
    }

    /// Swings up to the tolerance and the noise are theirs; `None` where outliers are kept, which are named and throw the motion out.
    fn least_swing(&self) -> Option<f64> {
        let noise = self.noise.map_or(0.0, |noise| ROOM * noise.farthest(self.count));
        let tolerance = self.limit.and_then(PoseLimit::bound);
        self.strays.is_empty().then(|| tolerance.unwrap_or(0.0).max(noise))
    }

    /// The values smoothed by the limit; without one, as they are.
    fn smoothed<const D: usize>(&self, values: &Values<'_, D>) -> Vec<[f64; D]> {
        match (self.limit, self.noise) {
            (Some(PoseLimit::Within(limit)), _) => values.within(Some(limit)),
            (Some(PoseLimit::ByNoise), Some(noise)) => self.by_noise(values, noise),
            (Some(PoseLimit::ByNoise), None) | (None, _) => values.values.clone(),
        }
    }

    fn by_noise<const D: usize>(&self, values: &Values<'_, D>, noise: Noise) -> Vec<[f64; D]> {
        // Without those that were left out.
        let mut counts = vec![true; values.values.len() - usize::from(values.closed)];
        self.strays.iter().for_each(|stray| counts[stray.pose] = false);
        values.by_noise(noise, &counts)
    }

    /// What a tolerance does that is below the noise, or far above.
    fn doubts<const D: usize>(&self, values: &Values<'_, D>, smooth: &[[f64; D]]) -> Option<Warning> {
        let (turning, tolerance, noise) = (self.turning, self.limit?.bound()?, self.noise?);
        let needed = ROOM * noise.farthest(self.count);
        if tolerance < needed {
            return Some(Warning::PoseFit(PoseFitWarning::PosesNoisier {
                turning,
                sigma: noise.sigma,
                tolerance,
                needed,
            }));
        }
        // The poses without their noise; those that are off by more have no part in it.
        let all = self.by_noise(values, noise);
        let belongs = |i: &usize| self.strays.binary_search_by_key(i, |stray| stray.pose).is_err();
        let belonging: Vec<usize> = (0..all.len()).filter(belongs).collect();
        let denoised: Vec<[f64; D]> = belonging.iter().map(|i| all[*i]).collect();
        let length = |path: &[[f64; D]]| path.windows(2).map(|w| (values.apart)(&w[0], &w[1])).sum::<f64>();
        let [poses, path] = [length(&denoised), length(smooth)];
        if path < LENGTH_KEPT * poses && poses - path > BY_NOISE * needed {
            return Some(Warning::PoseFit(PoseFitWarning::SmoothedAway { turning, path, poses }));
        }
        let extent = denoised.iter().map(|value| (values.apart)(&denoised[0], value)).fold(0.0, f64::max);
        let is_wide = tolerance > WIDE * extent && tolerance > BY_NOISE * needed && extent > BY_NOISE * needed;
        if is_wide {
            return Some(Warning::PoseFit(PoseFitWarning::WideTolerance { turning, tolerance, extent }));
        }
        let squares = belonging.iter().map(|i| (values.apart)(&all[*i], &smooth[*i]).powi(2)).sum::<f64>();
        let off = (squares / belonging.len() as f64).sqrt();
        let moves = noise.sigma * noise.rank.sqrt();
        // Outliers that are kept pull the motion, and are named.
        let is_worse = self.strays.is_empty() && off > FARTHER * moves && tolerance < MEANT * noise.sigma;
        is_worse.then_some(Warning::PoseFit(PoseFitWarning::WiderThanNoise { turning, tolerance, off, moves }))
    }
}

/// What is smoothed: places or quaternions, the first of a closed motion again at the end, there perhaps with the other sign.
pub(super) struct Values<'a, const D: usize> {
    pub(super) values: Vec<[f64; D]>,
    pub(super) steps: Vec<f64>,
    pub(super) closed: bool,
    /// By which the first one is multiplied where it comes again.
    sign: f64,
    pub(super) apart: &'a dyn Fn(&[f64; D], &[f64; D]) -> f64,
    /// What was subtracted.
    centre: Vec3,
}

/// Closed values several times round.
pub(super) struct Rounds<const D: usize> {
    pub(super) values: Vec<[f64; D]>,
    pub(super) steps: Vec<f64>,
    /// The round that counts.
    pub(super) middle: std::ops::Range<usize>,
}

/// Steps of time whose average is 1.
fn even_steps(given: &Given) -> Vec<f64> {
    let average = (given.times[given.spans()] - given.times[0]) / given.spans() as f64;
    given.steps().into_iter().map(|step| step / average).collect()
}

impl Values<'_, 3> {
    fn places(given: &Given) -> Self {
        let centre = given.places.iter().fold(Vec3::ZERO, |sum, place| sum + *place / given.places.len() as f64);
        let values = given.places.iter().map(|place| (*place - centre).to_array()).collect();
        let apart = &|a: &[f64; 3], b: &[f64; 3]| (Vec3::from(*a) - Vec3::from(*b)).length();
        Self { values, steps: even_steps(given), closed: given.closed, sign: 1.0, apart, centre }
    }
}

impl Values<'_, 4> {
    fn turns(given: &Given) -> Self {
        let [first, last] = [given.rotations[0], given.rotations[given.spans()]];
        let sign = if given.closed && first.dot(last) < 0.0 { -1.0 } else { 1.0 };
        let values = given.rotations.iter().map(|q| q.to_array()).collect();
        let apart = &|a: &[f64; 4], b: &[f64; 4]| angle_between(Quat::from(*a), unit(Quat::from(*b)));
        Self { values, steps: even_steps(given), closed: given.closed, sign, apart, centre: Vec3::ZERO }
    }
}

impl<const D: usize> Values<'_, D> {
    /// The values smoothed as much as a tolerance allows; without one, as they are.
    fn within(&self, tolerance: Option<f64>) -> Vec<[f64; D]> {
        let Some(limit) = tolerance else { return self.values.clone() };
        let off = |i: usize, x: &[f64; D]| (self.apart)(x, &self.values[i]) / limit;
        if !self.closed {
            return strongest(&self.values, &self.steps, &off, 0..self.values.len());
        }
        let Rounds { values, steps, middle } = self.several_rounds();
        let count = self.steps.len();
        self.closed_round(&strongest(&values, &steps, &|i, x| off(i % count, x), middle.clone())[middle])
    }

    /// Several times round: the middle one does not know where the first begins. The spline through its values is closed however that is.
    pub(super) fn several_rounds(&self) -> Rounds<D> {
        let count = self.steps.len();
        let beyond = MEMORY.div_ceil(count) * count;
        let (values, steps) = self.rounds(&self.values, beyond);
        Rounds { values, steps, middle: beyond..beyond + count }
    }

    /// One round with its first value again.
    pub(super) fn closed_round(&self, values: &[[f64; D]]) -> Vec<[f64; D]> {
        values.iter().copied().chain([values[0].map(|x| x * self.sign)]).collect()
    }

    /// Closed values with so many of them before and behind, and the steps between. Every other round has the other sign.
    fn rounds(&self, values: &[[f64; D]], beyond: usize) -> (Vec<[f64; D]>, Vec<f64>) {
        let count = self.steps.len();
        let first = beyond.div_ceil(count);
        let around = |k: usize| {
            let (round, i) = (k / count, k % count);
            values[i].map(|x| if round.abs_diff(first) % 2 == 0 { x } else { x * self.sign })
        };
        let numbers = first * count - beyond..(first + 1) * count + beyond;
        let steps = numbers.clone().map(|k| self.steps[k % count]).take(count + 2 * beyond - 1).collect();
        (numbers.map(around).collect(), steps)
    }

    /// The Bézier points of the cubic spline through smooth values, span by span: natural, or closed.
    fn cubics(&self, values: &[[f64; D]]) -> Vec<[[f64; D]; 4]> {
        let steps = &self.steps;
        let slopes = if self.closed {
            let beyond = BEYOND.min(steps.len());
            let (around, between) = self.rounds(values, beyond);
            let mut slopes = natural_derivatives(&around, &between)[beyond..beyond + steps.len()].to_vec();
            slopes.push(slopes[0].map(|d| d * self.sign));
            slopes
        } else {
            natural_derivatives(values, steps)
        };
        let towards =
            |i: usize, by: f64| -> [f64; D] { std::array::from_fn(|k| values[i][k] + slopes[i][k] * by / 3.0) };
        (0..steps.len()).map(|i| [values[i], towards(i, steps[i]), towards(i + 1, -steps[i]), values[i + 1]]).collect()
    }

    /// How far the farthest is off.
    fn farthest(&self, smooth: &[[f64; D]]) -> f64 {
        smooth.iter().zip(&self.values).map(|(x, value)| (self.apart)(x, value)).fold(0.0, f64::max)
    }
}

/// The angle between two rotations, the first of any length.
fn angle_between(a: Quat, b: Quat) -> f64 {
    let between = unit(a) * b.conj();
    2.0 * between.vector().length().atan2(between.w.abs())
}

/// The values smoothed as much as leaves all that count off by 1 at most; `off` says how far one is. Values before and after are those again.
fn strongest<const D: usize>(
    values: &[[f64; D]],
    steps: &[f64],
    off: &dyn Fn(usize, &[f64; D]) -> f64,
    counted: std::ops::Range<usize>,
) -> Vec<[f64; D]> {
    if values.len() < 3 {
        return values.to_vec();
    }
    let within = |power: f64| {
        let mut weights = vec![1.0; values.len()];
        for _ in 0..ROUNDS {
            let smooth = smoothed(values, steps, &weights, 10.0_f64.powf(power));
            let offs: Vec<f64> = counted.clone().map(|i| off(i, &smooth[i])).collect();
            if offs.iter().all(|off| *off <= 1.0) {
                return Some(smooth);
            }
            // Those that count are as many rounds of closed values from the first: all rounds get the same weights.
            for (weight, off) in weights.iter_mut().zip(offs.iter().cycle()).filter(|(_, off)| **off > NEARLY) {
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
