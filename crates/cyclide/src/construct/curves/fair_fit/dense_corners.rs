//! Corners among points that are no farther apart than their noise is wide: no point there is the corner, nor are two of them beside it.
//! It lies where the straight lines through many points on either side cross, if two curves that meet there explain the points
//! round about better than one does (`docs/math/fair-fits.md#noise`).

use super::FairFitOptions;
use super::edged::{Edged, in_plan};
use super::measured::reading;
use super::meeting_sides::{Meeting, Meetings, Place, Sharp};
use super::noise::{Denoised, Reading, Run, denoised};
use super::sides::{self, NOISE};
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::input::Distinct;

/// The lines on either side of a corner are so many deviations of the noise long,
const LENGTH: f64 = 12.0;
/// and go through so many points, at least and at most.
const COUNT: [usize; 2] = [8, 400];
/// A corner is compared with a smooth curve through the points of so many such lines on either side.
const ROUND_ABOUT: usize = 8;
/// A corner takes as many degrees of freedom: its place, and where in the list it is.
const COST: f64 = 2.0;
/// One corner may explain the points worse by this, by chance, where all together explain them better.
const CHANCE: f64 = 4.0;
/// All corners together better the logarithm of cross-validation by this, and take so many times the freedom at most: on arcs they take more.
const GAIN: f64 = 14.0;
const FREEDOM: f64 = 1.3;

/// Where two lines cross: between a point of a run and the next.
#[derive(Clone, Copy)]
struct Crossing {
    at: usize,
    corner: Point3,
    /// How far the points are off both lines, as a root of squares.
    misfit: f64,
}

/// A corner of a run.
#[derive(Clone, Copy)]
struct Break {
    /// Twice the position of a point that is the corner; one more where it lies behind that.
    key: usize,
    corner: Option<Point3>,
    is_forced: bool,
}

/// The reading with corners where lines through dense points cross, or as it was.
pub(super) fn with_dense_corners(distinct: &Distinct, options: &FairFitOptions, sharp: Sharp) -> Sharp {
    let all = sharp.inserted.as_ref().unwrap_or(distinct);
    let rows = rows(all, options, &sharp);
    match with_corners(all, options, &sharp, &rows) {
        Some(next) => next.or_inserted(sharp.inserted),
        None => sharp,
    }
}

/// The reading with the corners of rows, if it explains the points well enough.
fn with_corners(all: &Distinct, options: &FairFitOptions, sharp: &Sharp, rows: &[Row]) -> Option<Sharp> {
    let (mut replaced, mut added) = (Vec::new(), Vec::new());
    for row in rows {
        let breaks = row.with_corners();
        let is_left = |b: &&Break| breaks.binary_search_by_key(&b.key, |other| other.key).is_ok();
        replaced.extend(row.breaks.iter().filter(|b| !is_left(b)).map(|b| row.numbers[b.key / 2]));
        added.extend(breaks.iter().filter_map(|b| Some(Meeting::between(row.numbers[b.key / 2], b.corner?))));
    }
    replaced.sort_unstable();
    added.sort_by_key(|meeting: &Meeting| meeting.at);
    let Edged { corners, straight } = &sharp.edged;
    let left = corners.iter().copied().filter(|i| replaced.binary_search(i).is_err()).collect();
    let edged = Edged { corners: left, straight: straight.clone() };
    let next = Meetings::new(all, options, &edged, &sharp.found, Place::Between).with(&added)?;
    let count = all.points.len() as f64;
    let score = |found: &Denoised, freedom: f64| count * (found.deviation.powi(2) / (1.0 - freedom)).ln();
    let freedoms = [sharp.found.freedom(), next.found.freedom() + COST * added.len() as f64 / count];
    let scores = [score(&sharp.found, freedoms[0]), score(&next.found, freedoms[1])];
    let outliers = [&sharp.found, &next.found].map(|found| found.outliers.len());
    let is_better = scores[1] < scores[0] - GAIN && freedoms[1] < FREEDOM * freedoms[0] && outliers[1] == outliers[0];
    is_better.then_some(next)
}

/// The runs in which lines cross.
fn rows(all: &Distinct, options: &FairFitOptions, sharp: &Sharp) -> Vec<Row> {
    let noise = sharp.found.deviation;
    let plan = in_plan(&all.points, options);
    let forced: Vec<usize> = options.corners.iter().map(|c| all.position(*c)).collect();
    // One that was inserted between two points is as sure.
    let is_sure = |i: usize| forced.contains(&i) || (i > 0 && all.source[i] == all.source[i - 1]);
    let Edged { corners, straight } = &sharp.edged;
    let sure = Edged { corners: corners.iter().copied().filter(|i| is_sure(*i)).collect(), straight: straight.clone() };
    let row = |run: Run| {
        let count = count_for(&run, &sharp.found, noise)?;
        let points: Vec<Point3> = run.numbers.iter().map(|i| plan[*i]).collect();
        let mut found = crossings(&points, run.closed, count, options, noise);
        if plan[..] != all.points[..] {
            // In plan a corner has the height of the smooth curve there.
            found.iter_mut().for_each(|crossing| crossing.corner.z = height(run.numbers[crossing.at], &sharp.found));
        }
        let own = (0..points.len()).filter(|at| corners.binary_search(&run.numbers[*at]).is_ok());
        let breaks = own.map(|at| Break { key: 2 * at, corner: None, is_forced: is_sure(run.numbers[at]) }).collect();
        let data = run.numbers.iter().map(|i| all.points[*i]).collect();
        let reading = Reading { common: Some(noise), ..reading(options) };
        Some(Row { data, numbers: run.numbers, closed: run.closed, count, breaks, found, reading, noise })
    };
    sure.runs(options).into_iter().filter_map(row).filter(|row| !row.found.is_empty()).collect()
}

/// The height of the smooth curve at a point, or at the one before it that was kept.
fn height(point: usize, found: &Denoised) -> f64 {
    let next = found.kept.partition_point(|i| *i <= point);
    found.places[next.saturating_sub(1)].z
}

/// How many points are long enough for a line, where noise is not small beside their steps.
fn count_for(run: &Run, found: &Denoised, noise: f64) -> Option<usize> {
    let place = |i: &usize| found.kept.binary_search(i).ok().map(|k| found.places[k]);
    let places: Vec<Point3> = run.numbers.iter().filter_map(place).collect();
    let length: f64 = places.windows(2).map(|w| w[0].distance(w[1])).sum();
    let step = length / (places.len().max(2) - 1) as f64;
    let count = (LENGTH * noise / step).ceil();
    let count = if count <= COUNT[1] as f64 { (count as usize).max(COUNT[0]) } else { return None };
    (noise > NOISE * step && run.numbers.len() > 2 * count).then_some(count)
}

/// Where lines cross, the straightest first; of several near each other the straightest.
fn crossings(points: &[Point3], closed: bool, count: usize, options: &FairFitOptions, noise: f64) -> Vec<Crossing> {
    let n = points.len();
    let cross = |at: usize| {
        sides::cross(points, at, closed, count, options, noise).map(|(corner, misfit)| Crossing { at, corner, misfit })
    };
    let mut ranked: Vec<Crossing> = (0..n).filter_map(cross).collect();
    ranked.sort_by(|a, b| a.misfit.total_cmp(&b.misfit));
    let mut is_near = vec![false; n];
    ranked.retain(|crossing| {
        let at = crossing.at;
        if is_near[at] {
            return false;
        }
        let around =
            if closed { at + n - count..at + n + count + 1 } else { at.saturating_sub(count)..(at + count + 1).min(n) };
        around.for_each(|i| is_near[i % n] = true);
        true
    });
    ranked
}

/// The points of a run and its corners.
struct Row {
    data: Vec<Point3>,
    numbers: Vec<usize>,
    closed: bool,
    count: usize,
    breaks: Vec<Break>,
    found: Vec<Crossing>,
    reading: Reading,
    noise: f64,
}

impl Row {
    /// The corners, with those instead of others near them that explain the points round about better than these, or a smooth curve, do.
    fn with_corners(&self) -> Vec<Break> {
        let n = self.data.len();
        let mut breaks = self.breaks.clone();
        for (k, crossing) in self.found.iter().enumerate() {
            let own = Break { key: 2 * crossing.at + 1, corner: Some(crossing.corner), is_forced: false };
            let near = |b: &Break| {
                let apart = b.key.abs_diff(own.key);
                (if self.closed { apart.min(2 * n - apart) } else { apart }) <= self.count
            };
            if breaks.iter().any(|b| b.is_forced && near(b)) {
                continue;
            }
            let mut with: Vec<Break> = breaks.iter().copied().filter(|b| !near(b)).chain([own]).collect();
            with.sort_by_key(|b| b.key);
            let range = self.round_about(k);
            let scores = self.score(range, &breaks).zip(self.score(range, &with));
            if scores.is_some_and(|(before, after)| after.1 <= before.1 && after.0 < before.0 + CHANCE) {
                breaks = with;
            }
        }
        breaks
    }

    /// The points round about one, to others that may be corners: without an end those of a closed run go on.
    fn round_about(&self, k: usize) -> [usize; 2] {
        let (n, at) = (self.data.len(), self.found[k].at);
        let others = self.found.iter().map(|other| other.at).filter(|other| *other != at);
        let reach = ROUND_ABOUT * self.count;
        if !self.closed {
            let ends = [at.saturating_sub(reach), (at + reach).min(n - 1)];
            return others.fold(ends, |[from, to], i| if i < at { [from.max(i + 1), to] } else { [from, to.min(i)] });
        }
        let reach = reach.min((n - 1) / 2);
        let at = at + n;
        others.flat_map(|i| [i, i + n, i + 2 * n]).fold([at - reach, at + reach], |[from, to], i| {
            if i < at { [from.max(i + 1), to] } else { [from, to.min(i)] }
        })
    }

    /// How badly curves with these corners explain a range of points, and how many outliers they leave.
    fn score(&self, [from, to]: [usize; 2], breaks: &[Break]) -> Option<(f64, usize)> {
        let n = self.data.len();
        let (mut points, mut runs, mut own, mut corners) = (Vec::new(), Vec::new(), Vec::new(), 0);
        let mut fixed = false;
        for i in from..=to {
            own.push(points.len());
            points.push(self.data[i % n]);
            let here = |key: usize| breaks.binary_search_by_key(&key, |b| b.key).ok().map(|k| breaks[k]);
            if i < to
                && let Some(corner) = here(2 * (i % n) + 1).and_then(|b| b.corner)
            {
                own.push(points.len());
                points.push(corner);
            } else if !(i > from && i < to && here(2 * (i % n)).is_some()) {
                continue;
            }
            corners += 1;
            let last = points.len() - 1;
            runs.push(Run { numbers: std::mem::replace(&mut own, vec![last]), closed: false, fixed: [fixed, true] });
            fixed = true;
        }
        runs.push(Run { numbers: own, closed: false, fixed: [fixed, false] });
        let found = denoised(&points, &runs, self.reading)?;
        let count = (to - from + 1) as f64;
        let freedom = count * found.freedom() + COST * f64::from(corners);
        let squares = count * (1.0 - found.freedom()) * (found.deviation / self.noise).powi(2);
        Some((squares + 2.0 * freedom, found.outliers.len()))
    }
}
