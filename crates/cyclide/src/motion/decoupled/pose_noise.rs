//! How noisy poses are, and which of them do not belong to the others (`docs/math/motions.md#noisy-poses`).
//!
//! Both are read from what neighbors say of each other at their times, and know nothing of what is smooth: divided differences, and quadratics through the
//! five neighbors on one side. A corner, a rest and a jump are what one side says of them; a wrong pose is off both.

use crate::base::vector::Vec3;

/// So many poses tell their noise.
pub(super) const TELLING: usize = 20;
/// Orders of the differences by which noise is read.
const ORDERS: [usize; 4] = [3, 4, 6, 8];
/// A higher one counts if it says less than this part: differences of noise itself differ by some hundredths.
const LESS: f64 = 0.8;
/// Squares of differences above this many times their median say nothing of the directions of noise.
const TRIMMED: f64 = 9.0;

/// Neighbors of one side that predict a pose, at least and at most.
const SIDE: [usize; 2] = [4, 5];
/// An outlier is off what both sides say by more than so many standard deviations of the noise,
const FAR: f64 = 6.0;
/// and than this part of what it has to be off the others at least: sides alone are less sure,
const SEEN: f64 = 0.2;
/// and so many times what the poses around it are, of so many on either side.
const ALONE: f64 = 4.0;
const AROUND: isize = 10;
/// It is farther from where the others go on than they are from each other, or so many times as far as each of these, at three on either side.
const APART: f64 = 4.0;
const BESIDE: isize = 3;
/// One pose in so many may be an outlier: else the motion is so.
const FEW: usize = 10;
/// Rounds of the search: beside one that is found another may come.
const ROUNDS: usize = 12;

/// Places of poses, or turns, at their times.
pub(super) struct Track<'a> {
    /// Of each, rising.
    pub(super) times: &'a [f64],
    /// How long a closed one takes.
    pub(super) period: Option<f64>,
    /// How far the second is from the first: a way, or a turn as a vector.
    pub(super) between: &'a dyn Fn(usize, usize) -> Vec3,
}

/// Noise of vectors: as large as one of so many directions, each with this deviation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Noise {
    /// Standard deviation along one direction.
    pub(super) sigma: f64,
    /// The number of directions, from 1 to 3: the effective rank of its covariance.
    pub(super) rank: f64,
}

/// A pose that does not belong to the others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stray {
    pub(super) pose: usize,
    /// How far it is from where the poses around it go on.
    pub(super) distance: f64,
}

impl Noise {
    /// The length that one of so many vectors of this noise exceeds on average: `n P(χ_h > x) = 1` by the first term of the tail,
    /// `x^(h−2) e^(−x²/2) / (2^(h/2−1) Γ(h/2))`, solved by substitution.
    pub(super) fn farthest(self, count: usize) -> f64 {
        // The factor is √(π/2) for one direction and for three, and 1 for two.
        let factor = 1.0 + ((std::f64::consts::FRAC_PI_2).sqrt() - 1.0) * (self.rank - 2.0).powi(2);
        let part = count.max(TELLING) as f64 / factor;
        self.sigma * (0..12).fold(3.0, |x: f64, _| (2.0 * (part * x.powf(self.rank - 2.0)).ln()).sqrt())
    }
}

impl Track<'_> {
    /// All of them.
    pub(super) fn all(&self) -> Vec<usize> {
        (0..self.times.len()).collect()
    }

    /// Time and number at a position in a list, which goes round in a closed motion.
    fn at(&self, list: &[usize], position: isize) -> Option<(f64, usize)> {
        let count = list.len() as isize;
        match self.period {
            Some(period) if count > 0 => {
                let pose = list[position.rem_euclid(count) as usize];
                Some((self.times[pose] + period * position.div_euclid(count) as f64, pose))
            }
            _ => usize::try_from(position).ok().and_then(|k| list.get(k)).map(|pose| (self.times[*pose], *pose)),
        }
    }

    /// What a sum of poses with weights is off the first of them, where the weights have the sum 1; or a difference, where that is 0.
    fn sum(&self, from: usize, poses: &[(f64, usize)], weights: &[f64]) -> Vec3 {
        poses.iter().zip(weights).fold(Vec3::ZERO, |sum, ((_, pose), w)| sum + (self.between)(from, *pose) * *w)
    }

    /// The noise of the poses in a list, by divided differences over their times: what is quadratic in time has none of the third order, however uneven these
    /// are, and a smooth motion less with each order, where noise stays what it is. So the least of some orders is taken.
    pub(super) fn noise(&self, list: &[usize]) -> Option<Noise> {
        if list.len() < TELLING {
            return None;
        }
        let noises = ORDERS.map(|order| self.noise_by(list, order));
        noises.into_iter().flatten().reduce(|a, b| if b.sigma < LESS * a.sigma { b } else { a })
    }

    /// By differences of one order. Each is divided by the root of the sum of its squared weights, so that noise of a deviation gives one of the same.
    fn noise_by(&self, list: &[usize], order: usize) -> Option<Noise> {
        let windows = if self.period.is_some() { list.len() } else { list.len() - order };
        let differences = (0..windows as isize).filter_map(|first| {
            let window: Vec<(f64, usize)> = (first..=first + order as isize).filter_map(|k| self.at(list, k)).collect();
            let weights = divided(&window);
            let norm = weights.iter().map(|w| w * w).sum::<f64>().sqrt();
            let difference = self.sum(window.get(1)?.1, &window, &weights) / norm;
            difference.is_finite().then_some(difference)
        });
        let differences: Vec<Vec3> = differences.collect();
        let median = median(differences.iter().map(|d| d.length_squared()).collect());
        // The covariance of those that are no outliers: its trace and that of its square say how many directions there are.
        let mut columns = [Vec3::ZERO; 3];
        for d in differences.iter().filter(|d| d.length_squared() <= TRIMMED * median) {
            columns = [columns[0] + *d * d.x, columns[1] + *d * d.y, columns[2] + *d * d.z];
        }
        let trace = columns[0].x + columns[1].y + columns[2].z;
        let square: f64 = columns.iter().map(|column| column.length_squared()).sum();
        if !(median > 0.0 && square > 0.0) {
            return Some(Noise { sigma: 0.0, rank: 3.0 });
        }
        let rank = (trace * trace / square).clamp(1.0, 3.0);
        // The median of the square of the length, in the approximation of Wilson and Hilferty.
        let expected = rank * (1.0 - 2.0 / (9.0 * rank)).powi(3);
        Some(Noise { sigma: (median / expected).sqrt(), rank })
    }

    /// The poses that do not belong to the others, rising, each farther than `limit` from where they go on.
    pub(super) fn strays(&self, limit: f64) -> Vec<Stray> {
        let mut list = self.all();
        let mut found: Vec<usize> = Vec::new();
        for _ in 0..ROUNDS {
            let Some(noise) = self.noise(&list) else { return Vec::new() };
            let more = self.off_both_sides(&list, (FAR * noise.sigma).max(SEEN * limit));
            if more.is_empty() {
                break;
            }
            found.extend(&more);
            if found.len() * FEW > self.times.len() {
                return Vec::new();
            }
            let mut is_found = vec![false; self.times.len()];
            more.iter().for_each(|pose| is_found[*pose] = true);
            list.retain(|pose| !is_found[*pose]);
        }
        found.sort_unstable();
        found.into_iter().filter_map(|pose| self.confirmed(&list, pose, limit)).collect()
    }

    /// The poses of a list that are off what either side says of them; of neighbors the farthest alone, which may be why the others seem off.
    fn off_both_sides(&self, list: &[usize], least: f64) -> Vec<usize> {
        let count = list.len() as isize;
        let offs: Vec<f64> = (0..count).map(|k| self.off_sides(list, k)).collect();
        let around = |k: isize| match self.period {
            Some(_) => Some(offs[k.rem_euclid(count) as usize]),
            None => usize::try_from(k).ok().and_then(|k| offs.get(k).copied()),
        };
        let stands_out = |k: &usize| {
            let off = offs[*k];
            off > least && {
                let near = (-AROUND..=AROUND).filter(|by| *by != 0).filter_map(|by| around(*k as isize + by));
                off > ALONE * median(near.collect())
            }
        };
        let mut far: Vec<usize> = (0..offs.len()).filter(stands_out).collect();
        far.sort_by(|a, b| offs[*b].total_cmp(&offs[*a]).then(a.cmp(b)));
        let mut is_near = vec![false; offs.len()];
        let mut taken = Vec::new();
        for k in far {
            if is_near[k] {
                continue;
            }
            taken.push(list[k]);
            for by in -(SIDE[1] as isize)..=SIDE[1] as isize {
                is_near[(k as isize + by).rem_euclid(count) as usize] = true;
            }
        }
        taken
    }

    /// How far a pose of a list is off what the nearer of both sides says, in standard deviations of that if those of the noise are 1.
    fn off_sides(&self, list: &[usize], position: isize) -> f64 {
        let Some(own) = self.at(list, position) else { return 0.0 };
        let side = |sign: isize| {
            let beside = (1..=SIDE[1] as isize).map_while(|by| self.at(list, position + sign * by));
            let beside: Vec<(f64, usize)> = beside.collect();
            if beside.len() < SIDE[0] {
                return None;
            }
            let weights = quadratic(&beside, own.0);
            let off = (self.between)(beside[0].1, own.1) - self.sum(beside[0].1, &beside, &weights);
            Some(off.length() / (1.0 + weights.iter().map(|w| w * w).sum::<f64>()).sqrt())
        };
        [side(-1), side(1)].into_iter().flatten().reduce(f64::min).unwrap_or(0.0)
    }

    /// How far a pose is from where the others go on that come before a position and from another on: the cubic through two on either side.
    fn off_others(&self, list: &[usize], [before, after]: [isize; 2], own: (f64, usize)) -> f64 {
        let places = [before - 1, before, after, after + 1];
        let beside: Vec<(f64, usize)> = places.into_iter().filter_map(|k| self.at(list, k)).collect();
        let Some(first) = beside.first() else { return 0.0 };
        let weights = lagrange(&beside, own.0);
        ((self.between)(first.1, own.1) - self.sum(first.1, &beside, &weights)).length()
    }

    /// An outlier, if it is one by the others: those of the list.
    fn confirmed(&self, list: &[usize], pose: usize, limit: f64) -> Option<Stray> {
        let at = list.partition_point(|other| *other < pose) as isize;
        let distance = self.off_others(list, [at - 1, at], (self.times[pose], pose));
        let beside: Vec<(isize, (f64, usize))> =
            (at - BESIDE..at + BESIDE).filter_map(|k| Some((k, self.at(list, k)?))).collect();
        let step = beside.windows(2).map(|w| (self.between)(w[0].1.1, w[1].1.1).length()).fold(0.0, f64::max);
        let others = beside.iter().map(|(k, own)| self.off_others(list, [k - 1, k + 1], *own)).fold(0.0, f64::max);
        let is_apart = distance > step || distance > APART * others;
        (distance > limit && is_apart).then_some(Stray { pose, distance })
    }
}

/// The weights of a divided difference over all of some times, up to a factor.
fn divided(poses: &[(f64, usize)]) -> Vec<f64> {
    let whole = poses.last().map_or(1.0, |last| last.0 - poses[0].0);
    let weight = |k: usize| {
        let others = poses.iter().enumerate().filter(|(i, _)| *i != k);
        1.0 / others.map(|(_, other)| (poses[k].0 - other.0) / whole).product::<f64>()
    };
    (0..poses.len()).map(weight).collect()
}

/// The weights of the polynomial through all of some values, at a time.
fn lagrange(poses: &[(f64, usize)], time: f64) -> Vec<f64> {
    let weight = |k: usize| {
        let others = poses.iter().enumerate().filter(|(i, _)| *i != k);
        others.map(|(_, other)| (time - other.0) / (poses[k].0 - other.0)).product::<f64>()
    };
    (0..poses.len()).map(weight).collect()
}

/// The weights of the quadratic of least squares through values, at a time, by polynomials that are orthogonal on their times.
fn quadratic(poses: &[(f64, usize)], time: f64) -> Vec<f64> {
    let count = poses.len() as f64;
    let scale = poses.iter().map(|(t, _)| (t - time).abs()).fold(0.0, f64::max);
    let x: Vec<f64> = poses.iter().map(|(t, _)| (t - time) / scale).collect();
    let mean = x.iter().sum::<f64>() / count;
    let first = |x: f64| x - mean;
    let squares: f64 = x.iter().map(|x| first(*x).powi(2)).sum();
    let third: f64 = x.iter().map(|x| first(*x).powi(3)).sum();
    let second = |x: f64| first(x).powi(2) - squares / count - third / squares * first(x);
    let fourth: f64 = x.iter().map(|x| second(*x).powi(2)).sum();
    let weight = |x: &f64| 1.0 / count + first(0.0) * first(*x) / squares + second(0.0) * second(*x) / fourth;
    x.iter().map(weight).collect()
}

/// The value in the middle; 0 of none.
fn median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of a normal distribution, nearly.
    fn normal(state: &mut u64) -> f64 {
        (0..12).fold(-6.0, |sum, _| {
            *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            sum + (*state >> 11) as f64 / 9_007_199_254_740_992.0
        })
    }

    fn track(times: &[f64], places: &[Vec3], test: impl Fn(&Track<'_>)) {
        test(&Track { times, period: None, between: &|a, b| places[b] - places[a] });
    }

    #[test]
    fn noise_is_known_at_uneven_times_and_in_each_number_of_directions() {
        let mut state = 3;
        let mut time = 0.0;
        let times: Vec<f64> = (0..2000)
            .map(|_| {
                time += 0.02 + normal(&mut state).abs();
                time
            })
            .collect();
        let line = |t: f64| Vec3::new(7.0 * t, -t, 0.01 * t * t);
        let exact: Vec<Vec3> = times.iter().map(|t| line(*t)).collect();
        track(&times, &exact, |track| assert!(track.noise(&track.all()).unwrap().sigma < 1e-8));
        for (directions, rank) in [([0.0, 0.0, 1.0], 1.0), ([1.0, 1.0, 0.0], 2.0), ([1.0, 1.0, 1.0], 3.0)] {
            let mut noise = || Vec3::from(directions.map(|size| size * 0.5 * normal(&mut state)));
            let places: Vec<Vec3> = times.iter().map(|t| line(*t) + noise()).collect();
            track(&times, &places, |track| {
                let found = track.noise(&track.all()).unwrap();
                assert!((found.sigma - 0.5).abs() < 0.05 && (found.rank - rank).abs() < 0.15, "{found:?}");
                // As far as the farthest of so many is, by chance a little more or less.
                let far = found.farthest(2000);
                assert!(far > 0.5 * 3.2 && far < 0.5 * 4.6, "{far}");
            });
        }
    }

    /// One wrong pose, two beside each other and one at an end are found; corners, jumps and rests are none.
    #[test]
    fn wrong_poses_are_found_and_corners_are_none() {
        let mut state = 5;
        let times: Vec<f64> = (0..400).map(|k| f64::from(k) * 0.05).collect();
        let smooth = |t: f64| Vec3::new(40.0 * t, 100.0 * (0.7 * t).sin(), 30.0 * (0.4 * t).cos());
        let corner = |t: f64| if t < 9.0 { Vec3::X * (60.0 * t) } else { Vec3::new(540.0, 60.0 * (t - 9.0), 0.0) };
        let jump = |t: f64| Vec3::new(60.0 * t, if t < 9.0 { 0.0 } else { 200.0 }, 0.0);
        let rest = |t: f64| Vec3::X * (60.0 * (t - 9.0).max(0.0));
        let all: [&dyn Fn(f64) -> Vec3; 4] = [&smooth, &corner, &jump, &rest];
        for (kind, path) in all.iter().enumerate() {
            for noise in [0.0, 1e-3, 0.5] {
                let mut places: Vec<Vec3> = times
                    .iter()
                    .map(|t| path(*t) + Vec3::new(normal(&mut state), normal(&mut state), normal(&mut state)) * noise)
                    .collect();
                track(&times, &places, |track| assert_eq!(track.strays(1e-6 + 4.0 * noise), [], "{kind} {noise}"));
                let wrong = [60, 250, 251, 330, 399];
                wrong.iter().for_each(|k| places[*k] += Vec3::new(3.0, -12.0, 9.0));
                track(&times, &places, |track| {
                    let found = track.strays(1e-6 + 4.0 * noise);
                    let named: Vec<usize> = found.iter().map(|stray| stray.pose).collect();
                    assert_eq!(named, wrong, "{kind} {noise}");
                    let off = (234.0_f64).sqrt();
                    assert!(found.iter().all(|stray| (stray.distance - off).abs() < 8.0 * noise + 1.0), "{found:?}");
                });
            }
        }
    }
}
