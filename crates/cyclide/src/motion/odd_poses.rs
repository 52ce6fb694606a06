//! Motions of least degree through an odd number of poses at given times: a conic through three, a quartic through five, on the
//! quadric.
//!
//! `D(t) = Σ λ_i D_i Π_{k≠i}(t − t_k)` with real λ takes pose i at `t_i`, and is on the quadric iff the antisymmetric matrix
//! `M_ij = B_ij/(t_i − t_j)` of the Study form takes λ to zero: `(M_23, −M_13, M_12)` of three poses, signed Pfaffians of five
//! (`docs/math/motions.md#an-odd-number-of-poses`; A. Gfrerrer 1999).

use super::dual_quat::DualQuat;
use super::rational_motion::{MotionSpan, RationalMotion};
use super::study_form::{ROUNDED, forms, largest, over_times, pfaffian};
use super::timed_pose::{Prepared, TimeOrder, TimedPose};
use crate::base::bernstein;
use crate::error::{MotionError, PoseError, Result};

/// A pose whose factor is below this part of the largest is not taken.
pub(super) const UNATTAINED: f64 = 1e-10;
/// Pfaffians up to this part of the squared entries are zero, or up to what rounded entries make: the matrix has rank 2.
const RANK_TWO: f64 = 1e-12;
/// Products with an entry that is off, of which a Pfaffian is summed: three of two.
const PRODUCTS: f64 = 6.0;
/// Poses are met to this part of the size, and in the coefficients of their rotations.
const MET: f64 = 1e-9;
/// What entries of a form may be off where five poses are on a motion of degree 2 but for their digits. Pfaffians are products, and six decimals do.
const DIGITS: f64 = 1e-8;
/// A motion of degree 2 through three of five poses may miss the others by so many times what the poses are off.
const CARRIED: f64 = 1e3;
/// Triples of five poses, the most even one first.
const TRIPLES: [[usize; 3]; 10] =
    [[0, 2, 4], [0, 1, 4], [0, 3, 4], [0, 1, 3], [1, 2, 4], [0, 2, 3], [1, 3, 4], [0, 1, 2], [1, 2, 3], [2, 3, 4]];

impl RationalMotion {
    /// The motion of degree 2 that takes three poses at given times, in any order: it has no freedom. Points run on curves of degree 4.
    ///
    /// # Errors
    /// `wrong-pose-count`, `not-finite`, `repeated-parameter`, `unattainable-pose`, `motion-through-exceptional-point`.
    pub fn conic(poses: &[TimedPose]) -> Result<Self> {
        let prepared = Prepared::of_count::<3>(poses)?;
        let displacements = array::<_, 3>(&prepared.poses);
        let vanished = prepared.vanished.max(ROUNDED);
        let rows = conic_rows(&displacements, &array(&prepared.places), vanished)?;
        let size = largest(&forms(&displacements));
        // The signs of rotations matter to the motion of Lagrange only.
        let half_turns = prepared.half_turns.filter(|_| size <= vanished);
        Ok(prepared.single(rows)?.leaving_out(prepared.left_out(size)).half_turning(half_turns))
    }

    /// The motion of degree 4 that takes five poses at given times, in any order: it has no freedom, and may swing. Five poses of a motion of
    /// degree 2 give that one. Points run on curves of degree 8.
    ///
    /// # Errors
    /// As [`conic`](Self::conic).
    pub fn quartic(poses: &[TimedPose]) -> Result<Self> {
        let prepared = Prepared::of_count::<5>(poses)?;
        let (displacements, times) = (array(&prepared.poses), array(&prepared.places));
        let all = forms(&displacements);
        let size = largest(&all);
        if size <= prepared.vanished.max(ROUNDED) {
            let motion = prepared.single(lagrange_rows(&displacements, &plain_factors(&times), &times))?;
            return Ok(motion.leaving_out(prepared.left_out(size)).half_turning(prepared.half_turns));
        }
        let m = over_times(&all, &times);
        let factors: [f64; 5] = std::array::from_fn(|i| {
            let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
            sign * pfaffian(&m, others(i))
        });
        let entry = largest(&m);
        let rank_two = (RANK_TWO * entry * entry).max(PRODUCTS * entry * prepared.rounding / least_step(&times));
        if factors.iter().all(|f| f.abs() <= rank_two) {
            let conic = prepared.conic_of_five(&displacements, &times, &m);
            return conic.or_else(|refused| prepared.beside_conic(&displacements, &times).unwrap_or(Err(refused)));
        }
        let rounded = PRODUCTS * entry * DIGITS / least_step(&times);
        if factors.iter().all(|f| f.abs() <= rounded)
            && let Some(motion) = prepared.beside_conic(&displacements, &times)
        {
            return motion;
        }
        check_attained(&factors)?;
        prepared.single(lagrange_rows(&displacements, &factors, &times))
    }
}

impl Prepared {
    /// Poses at different times, of which there must be so many.
    ///
    /// # Errors
    /// `wrong-pose-count`, `not-finite`, `repeated-parameter`.
    pub(super) fn of_count<const N: usize>(poses: &[TimedPose]) -> Result<Self> {
        if poses.len() != N {
            return Err(PoseError::WrongPoseCount { given: poses.len(), needed: N, or_more: false }.into());
        }
        Self::new(poses, TimeOrder::Distinct)
    }

    /// The motion of one span, if it takes every pose and comes near the exceptional generator nowhere.
    ///
    /// # Errors
    /// `unattainable-pose`, `motion-through-exceptional-point`.
    pub(super) fn single(&self, rows: Vec<[f64; 8]>) -> Result<RationalMotion> {
        self.taking(rows, MET)
    }

    /// As [`single`](Self::single), of a motion that takes poses within this limit.
    fn taking(&self, rows: Vec<[f64; 8]>, limit: f64) -> Result<RationalMotion> {
        let span = MotionSpan(rows);
        span.check_share(self.domain)?;
        if let Some((index, share)) = first_missed(&span.0, &self.poses, &self.places, limit) {
            return Err(MotionError::UnattainablePose { index, share, limit }.into());
        }
        let [first, last] = self.domain;
        let times = self.places.iter().map(|place| first + (last - first) * place).collect();
        Ok(RationalMotion::of_spans(self.domain.to_vec(), vec![span], self.centre, self.unit).through(times))
    }

    /// The conic motion that five poses are on, with the matrix of rank 2 of their forms: through three of them. What those are off carries
    /// over to the others.
    fn conic_of_five(&self, poses: &[DualQuat; 5], times: &[f64; 5], m: &[[f64; 5]; 5]) -> Result<RationalMotion> {
        let limit = MET.max(CARRIED * self.rounding);
        for triple in TRIPLES {
            let rows = conic_rows(&triple.map(|i| poses[i]), &triple.map(|i| times[i]), self.vanished);
            let Ok(rows) = rows else { continue };
            if first_missed(&rows, poses, times, limit).is_none() {
                return self.taking(rows, limit);
            }
        }
        let (index, share) = vanishing_coordinate(m);
        Err(MotionError::UnattainablePose { index, share, limit: UNATTAINED }.into())
    }

    /// The motion through five poses that are on one of degree 2 but for the digits they are written with, if they are: each pose gets the length that the
    /// dual quaternion of that motion has at its time. It is met, and the motion differs from that of degree 2 by what the poses do.
    fn beside_conic(&self, poses: &[DualQuat; 5], times: &[f64; 5]) -> Option<Result<RationalMotion>> {
        let limit = CARRIED * DIGITS;
        TRIPLES.into_iter().find_map(|triple| {
            let rows = conic_rows(&triple.map(|i| poses[i]), &triple.map(|i| times[i]), ROUNDED).ok()?;
            let missed: [f64; 5] = std::array::from_fn(|i| miss(&rows, poses[i], times[i]));
            let most = missed.into_iter().fold(0.0, f64::max);
            if !missed.iter().all(|miss| *miss <= limit) {
                return None;
            }
            let plain = plain_factors(times);
            let factors: [f64; 5] = std::array::from_fn(|i| length_beside(&rows, poses[i], times[i]) * plain[i]);
            let motion = self.single(lagrange_rows(poses, &factors, times));
            Some(motion.map(|motion| motion.leaving_out(most)))
        })
    }

    /// What is left out where forms of this size were taken for zero: nothing, if they are the rounding of doubles.
    fn left_out(&self, form: f64) -> f64 {
        if form > self.vanished && form <= ROUNDED { form } else { 0.0 }
    }
}

/// The shortest step between two of the times.
fn least_step(times: &[f64]) -> f64 {
    let steps = times.iter().enumerate().flat_map(|(i, a)| times[..i].iter().map(move |b| (a - b).abs()));
    steps.fold(f64::INFINITY, f64::min)
}

/// The first so many of a list.
pub(super) fn array<T: Copy, const N: usize>(list: &[T]) -> [T; N] {
    std::array::from_fn(|i| list[i])
}

/// The indices of five but one.
fn others(left_out: usize) -> [usize; 4] {
    std::array::from_fn(|k| if k < left_out { k } else { k + 1 })
}

/// The conic of poses whose Study forms up to `vanished` are zero.
fn conic_rows(poses: &[DualQuat; 3], times: &[f64; 3], vanished: f64) -> Result<Vec<[f64; 8]>> {
    let all = forms(poses);
    if largest(&all) <= vanished {
        return Ok(lagrange_rows(poses, &plain_factors(times), times));
    }
    let m = over_times(&all, times);
    let factors = [m[1][2], -m[0][2], m[0][1]];
    check_attained(&factors)?;
    Ok(lagrange_rows(poses, &factors, times))
}

/// The coordinate that vanishes on the kernel of a matrix of rank 2 (that is in the plane of its rows), and how much of it is left.
fn vanishing_coordinate(m: &[[f64; 5]; 5]) -> (usize, f64) {
    let norm = |v: &[f64; 5]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let first = m.iter().max_by(|a, b| norm(a).total_cmp(&norm(b))).copied().unwrap_or_default();
    let first = first.map(|x| x / norm(&first));
    let across = |row: &[f64; 5]| -> [f64; 5] {
        let part: f64 = row.iter().zip(&first).map(|(a, b)| a * b).sum();
        std::array::from_fn(|i| row[i] - part * first[i])
    };
    let second = m.iter().map(across).max_by(|a, b| norm(a).total_cmp(&norm(b))).unwrap_or_default();
    let second = second.map(|x| x / norm(&second));
    let left = |i: usize| (1.0 - first[i] * first[i] - second[i] * second[i]).max(0.0).sqrt();
    (0..5).map(|i| (i, left(i))).min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default()
}

/// Refuses a factor that vanishes against the largest: its pose is not taken.
///
/// # Errors
/// `unattainable-pose`.
pub(super) fn check_attained(factors: &[f64]) -> Result<()> {
    let most = factors.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    match factors.iter().position(|f| f.abs() <= UNATTAINED * most) {
        Some(index) => {
            Err(MotionError::UnattainablePose { index, share: factors[index].abs() / most, limit: UNATTAINED }.into())
        }
        None => Ok(()),
    }
}

/// `1/Π(t_i − t_k)`: the factors with which every dual quaternion itself is taken.
pub(super) fn plain_factors<const N: usize>(times: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| (0..N).filter(|k| *k != i).fold(1.0, |product, k| product / (times[i] - times[k])))
}

/// The Bernstein coefficients of `Σ λ_i D_i Π_{k≠i}(t − t_k)`, the largest coefficient of a real part 1.
pub(super) fn lagrange_rows<const N: usize>(
    poses: &[DualQuat; N],
    factors: &[f64; N],
    times: &[f64; N],
) -> Vec<[f64; 8]> {
    let mut rows = vec![[0.0; 8]; N];
    for (i, (pose, factor)) in poses.iter().zip(factors).enumerate() {
        let basis = (0..N)
            .filter(|k| *k != i)
            .fold(vec![1.0], |product, k| bernstein::product(&product, &[-times[k], 1.0 - times[k]]));
        for (row, value) in rows.iter_mut().zip(basis) {
            let add = (*pose * (factor * value)).to_array();
            *row = std::array::from_fn(|d| row[d] + add[d]);
        }
    }
    let most = rows.iter().flat_map(|row| &row[..4]).fold(0.0, |m: f64, v| m.max(v.abs()));
    rows.into_iter().map(|row| row.map(|v| v / most)).collect()
}

/// The first pose that a span does not take at its time, and by how much it misses it.
fn first_missed(rows: &[[f64; 8]], poses: &[DualQuat], times: &[f64], limit: f64) -> Option<(usize, f64)> {
    poses.iter().zip(times).enumerate().find_map(|(i, (pose, t))| {
        let miss = miss(rows, *pose, *t);
        (miss.is_nan() || miss > limit).then_some((i, miss))
    })
}

/// By how much a span misses a pose at a time.
fn miss(rows: &[[f64; 8]], pose: DualQuat, t: f64) -> f64 {
    let at = DualQuat::from_array(bernstein::eval(rows, t));
    let at = at * (1.0 / length_beside(rows, pose, t));
    let off = (at.real - pose.real).norm();
    let apart = (at.translation().unwrap_or_default() - pose.translation().unwrap_or_default()).length();
    if off.is_nan() { off } else { off.max(apart) }
}

/// The length of the real part of a span at a time, negative if it is on the other side than that of a pose.
fn length_beside(rows: &[[f64; 8]], pose: DualQuat, t: f64) -> f64 {
    let at = DualQuat::from_array(bernstein::eval(rows, t));
    at.real.norm() * at.real.dot(pose.real).signum()
}
