//! What of measured points is no curve, corners and straight sides, as far as their noise lets one tell
//! (`docs/math/fair-fits.md#noise`).

use super::measured::{NEAREST, OF_NOISE, read};
use super::meeting_sides::{Sharp, with_meeting_sides};
use super::noise::{self, Denoised, Run};
use super::options::{Heights, Noise};
use super::{FairFitOptions, corners};
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::input::{Distinct, diameter};
use crate::construct::curves::outline::decimal_step;
use std::borrow::Cow;
use std::collections::BTreeSet;

/// Points that scatter by up to this many times what they are known within have no noise besides.
const AS_KNOWN: f64 = 1.5;
/// Corners and sides are read with the noise of what is left, so often.
const READINGS: usize = 4;
/// Among exact points one corner or side in this many may be lost to the noise.
const FEW: usize = 10;
/// Of at least so many points,
const MANY_POINTS: usize = 100;
/// this part is too many for corners, if in whole degrees their turns differ more often than this part of them (of so many at most)
const MANY_CORNERS: f64 = 0.2;
const ALL_SORTS: f64 = 0.25;
const MOST_SORTS: usize = 160;
/// and the points without noise are known better than the noise by this factor.
const SMOOTH: f64 = 0.5;

/// The points in which corners and sides are looked for: in plan where heights have noise of their own, since a wrong one would be a
/// corner. Points above each other have no plan.
pub(super) fn in_plan<'a>(points: &'a [Point3], options: &FairFitOptions) -> Cow<'a, [Point3]> {
    let all = Cow::Borrowed(points);
    if options.heights != Heights::ByNoise {
        return all;
    }
    let plan: Vec<Point3> = points.iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect();
    let least = NEAREST * diameter(points);
    let closing = options.closed.then(|| (plan.len() - 1, 0));
    let mut edges = (1..plan.len()).map(|i| (i - 1, i)).chain(closing);
    if edges.any(|(i, j)| plan[i].distance(plan[j]) <= least) { all } else { Cow::Owned(plan) }
}

/// The deviation that the decimals of the coordinates leave, that of a number anywhere between two steps; 0 without any.
pub(super) fn rounding(distinct: &Distinct) -> f64 {
    decimal_step(&distinct.points).map_or(0.0, |step| step / 12.0_f64.sqrt())
}

/// What of the points is no curve: corners, and the edges that are straight sides.
#[derive(Default, PartialEq)]
pub(super) struct Edged {
    /// Positions of the corners, rising.
    pub corners: Vec<usize>,
    /// Whether the edge that begins at each point is a straight side.
    pub straight: Vec<bool>,
}

impl Edged {
    /// What lasts over a tolerance.
    pub fn within(distinct: &Distinct, options: &FairFitOptions, tolerance: f64) -> Self {
        // Exact points have no runs of wrong ones.
        let is_exact = tolerance <= NEAREST * diameter(&in_plan(&distinct.points, options));
        Self::lasting(distinct, options, tolerance, !is_exact)
    }

    /// The same, with runs of points that may be wrong.
    fn lasting(distinct: &Distinct, options: &FairFitOptions, tolerance: f64, has_wrong: bool) -> Self {
        let mut forced: Vec<usize> = options.corners.iter().map(|c| distinct.position(*c)).collect();
        forced.sort_unstable();
        let points = &*in_plan(&distinct.points, options);
        let outline = corners::outline(points, &forced, options, tolerance);
        let bursts = if has_wrong { noise::bursts(points, options.closed) } else { Vec::new() };
        let bursts = corners::without_figures(points, options.closed, bursts, &outline.corners);
        let straight = corners::without_spikes(points, options.closed, &outline.straight, &bursts);
        let spikes = corners::spikes(points, options.closed, &bursts);
        let stays = |i: &usize| forced.binary_search(i).is_ok() || spikes.binary_search(i).is_err();
        let corners = outline.corners.into_iter().map(|c| c.0).filter(stays).collect();
        Self { corners, straight }
    }

    pub fn is_any(&self) -> bool {
        !self.corners.is_empty() || self.straight.contains(&true)
    }

    /// The other has the same corners and sides, except a few that are missing.
    fn is_nearly(&self, other: &Self) -> bool {
        let (n, count) = (self.straight.len(), self.corners.len());
        let is_own = |i: &usize| self.corners.binary_search(i).is_ok();
        let sides = self.straight.iter().filter(|side| **side).count();
        let changed = (0..n).filter(|i| self.straight[*i] != other.straight[*i]).count();
        other.corners.iter().all(is_own)
            && (count - other.corners.len()) * FEW <= count
            && changed * FEW <= sides.max(count)
    }

    /// The runs of points that one smooth curve explains: they end at corners, which they share, and at straight sides, beside
    /// which the curvature jumps.
    pub fn runs(&self, options: &FairFitOptions) -> Vec<Run> {
        let n = self.straight.len();
        let is_corner = |i: usize| self.corners.binary_search(&(i % n)).is_ok();
        let begins = |i: usize| is_corner(i) || self.straight[(i + n - 1) % n];
        let first = if options.closed { (0..n).find(|i| begins(*i)) } else { Some(0) };
        let Some(first) = first else {
            return vec![Run { numbers: (0..n).collect(), closed: true, fixed: [false; 2] }];
        };
        let last = if options.closed { first + n } else { n - 1 };
        let fixed = |i: usize| options.fix_ends || is_corner(i);
        let mut runs = Vec::new();
        let mut from = first;
        for i in first..=last {
            let side = i < last && self.straight[i % n];
            if i == last || side || (i > from && is_corner(i)) {
                let numbers = (from..=i).map(|i| i % n).collect();
                runs.push(Run { numbers, closed: false, fixed: [fixed(from), fixed(i)] });
                from = if side { i + 1 } else { i };
            }
        }
        runs
    }

    /// The corners and straight sides that last over more than the noise, and what the points say about that with them, if they are
    /// enough.
    pub fn in_noise(distinct: &Distinct, options: &FairFitOptions, size: f64) -> Result<Sharp, Self> {
        if let Some((edged, found)) = Self::of_exact(distinct, options, size) {
            // Points that scatter no more than their decimals are the outline itself: nothing is cut between them.
            let exact_within = (NEAREST * size).max(AS_KNOWN * rounding(distinct));
            return match found {
                Some(found) if found.deviation > exact_within => {
                    Ok(with_meeting_sides(distinct, options, edged, found))
                }
                Some(found) => Ok(Sharp { inserted: None, edged, found }),
                None => Err(edged),
            };
        }
        let automatic = FairFitOptions { corner_angle: None, ..options.clone() };
        let forced = Self::within(distinct, &automatic, f64::INFINITY);
        let gaps = Self::gaps(distinct, options);
        if let Some((edged, found)) =
            Self::by_places(distinct, options, Self { corners: forced.corners.clone(), straight: gaps })
        {
            return Ok(with_meeting_sides(distinct, options, edged, found));
        }
        // Else those that last over the noise that the points have without any.
        let mut found = read(distinct, options, &forced);
        let noise = found.as_ref().map_or(0.0, |found| OF_NOISE * found.deviation);
        let edged = Self::within(distinct, options, noise);
        if edged != forced {
            found = read(distinct, options, &edged);
        }
        match found {
            Some(found) => Ok(with_meeting_sides(distinct, options, edged, found)),
            None => Err(edged),
        }
    }

    /// All corners and sides of exact points, or of those that are only rounded to some decimals, if they are some with the noise of the runs
    /// between them too: else they are taken for noise, and there is none of this.
    pub fn of_exact(distinct: &Distinct, options: &FairFitOptions, size: f64) -> Option<(Self, Option<Denoised>)> {
        if let Some(Noise::Known(noise)) = options.noise {
            return Self::known_within(distinct, options, OF_NOISE * noise);
        }
        Self::known_within(distinct, options, NEAREST * size).or_else(|| {
            let rounded = rounding(distinct);
            (rounded > 0.0).then(|| Self::known_within(distinct, options, OF_NOISE * rounded))?
        })
    }

    /// The same of points that are known within a distance.
    fn known_within(
        distinct: &Distinct,
        options: &FairFitOptions,
        exact_within: f64,
    ) -> Option<(Self, Option<Denoised>)> {
        let automatic = FairFitOptions { corner_angle: None, ..options.clone() };
        let is_given = matches!(options.noise, Some(Noise::Known(_)));
        // Exact points have no runs of wrong ones.
        let has_wrong = |tolerance: f64| is_given || tolerance > AS_KNOWN * exact_within;
        let within = |tolerance: f64| Self::lasting(distinct, &automatic, tolerance, has_wrong(tolerance));
        let (sharp, forced) = (within(exact_within), within(f64::INFINITY));
        let gaps = Self::gaps(distinct, options);
        let is_corner = |i: usize| sharp.corners.binary_search(&(i % gaps.len())).is_ok();
        let is_side = |i: usize| sharp.straight[i] || (is_corner(i) && is_corner(i + 1));
        let is_all = (0..gaps.len()).all(|i| !gaps[i] || is_side(i));
        let is_asked = options.corner_angle.is_none() && sharp != forced && is_all;
        if !is_asked || Self::are_of_noise(distinct, &automatic, &sharp, &forced) {
            return None;
        }
        let mut edged = Self { corners: sharp.corners.clone(), straight: sharp.straight.clone() };
        for _ in 0..READINGS {
            let Some(found) = read(distinct, options, &edged) else { return Some((edged, None)) };
            let seen = within(if is_given { exact_within } else { exact_within.max(OF_NOISE * found.deviation) });
            if seen == edged {
                return Some((edged, Some(found)));
            }
            if !sharp.is_nearly(&seen) {
                break;
            }
            edged = seen;
        }
        None
    }

    /// The edges that are far longer than those round them, without those to wrong points.
    fn gaps(distinct: &Distinct, options: &FairFitOptions) -> Vec<bool> {
        let points = &*in_plan(&distinct.points, options);
        let gaps = corners::gaps(points, options.closed);
        let bursts = noise::bursts(points, options.closed);
        corners::without_spikes(points, options.closed, &gaps, &bursts)
    }

    /// Corners that are a large part of many points and turn by all sorts of angles are noise, where a smooth curve explains the points.
    fn are_of_noise(distinct: &Distinct, options: &FairFitOptions, sharp: &Self, forced: &Self) -> bool {
        let (n, count) = (distinct.points.len(), sharp.corners.len());
        if n < MANY_POINTS || (count as f64) < MANY_CORNERS * n as f64 {
            return false;
        }
        let at = |i: usize| distinct.points[i % n];
        let turn = |i: &usize| (at(*i) - at(i + n - 1)).angle(at(i + 1) - at(*i)).to_degrees().round() as u32;
        let sorts: BTreeSet<u32> = sharp.corners.iter().map(turn).collect();
        let is_smooth = |found: Denoised| found.uncertainty < SMOOTH * found.deviation;
        sorts.len() as f64 > ALL_SORTS * count.min(MOST_SORTS) as f64
            && read(distinct, options, forced).is_some_and(is_smooth)
    }

    /// Noise hides what the samples beside a corner or a side turn by. So from those that are `edged` at first, corners and sides are
    /// those that the points without the noise of the runs between them have, until these are the same. `None` if there are none,
    /// or no end.
    fn by_places(distinct: &Distinct, options: &FairFitOptions, mut edged: Self) -> Option<(Self, Denoised)> {
        let gaps = edged.straight.clone();
        for _ in 0..READINGS {
            if !edged.is_any() {
                return None;
            }
            let found = read(distinct, options, &edged)?;
            let mut places = distinct.points.clone();
            found.kept.iter().zip(&found.places).for_each(|(i, place)| places[*i] = *place);
            let places = Distinct::of(places, distinct.source.clone(), Vec::new());
            let mut seen = Self::within(&places, options, OF_NOISE * found.deviation);
            // Of a figure with one side, edges that are as long are others.
            if seen.straight.contains(&true) {
                seen.straight.iter_mut().zip(&gaps).for_each(|(straight, gap)| *straight |= gap);
            }
            if seen == edged {
                return Some((edged, found));
            }
            edged = seen;
        }
        None
    }
}
