//! The noise of measured points: how large it is, which points do not belong to the others, where nothing moved, and what
//! is left of the points without it (`docs/math/fair-fits.md#noise`).

mod beside;
mod bursts;
mod chords;
mod directions;
mod jumps;
mod neighbors;
mod outliers;
mod predicted;
mod residuals;
mod rounded;
mod smoother;
mod steps;
mod stops;

pub(super) use bursts::bursts;
pub(super) use rounded::{Rounded, rounded};
pub(super) use stops::{Stop, stops};

use super::working_frame::WorkingFrame;
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::arc_fit::input::diameter;
use crate::warning::{NoiseWarning, Warning};
pub(super) use beside::from_segment;
use directions::directions;
pub(super) use neighbors::most_noise;
use outliers::{Cleaned, cleaned};
use smoother::{Series, Smoothed, smoothed};

/// An outlier that is kept has the share of one this many deviations away in the sum of squares.
const INFLUENCE: f64 = 2.0;
/// Noise this many times as large as the neighbors of the points allow is none,
const TOO_MUCH: f64 = 1.5;
/// (more of few points: by this part for each),
const UNSURE: f64 = 10.0;
/// if that is less than this part of an edge, or the points are few: else lengths along noisy points say nothing.
const OF_EDGE: f64 = 0.1;
/// or this many times as large: noise above the length of the edges has been 2.75 times what the neighbors allow at most.
const FAR_TOO_MUCH: f64 = 3.2;
/// Fewer points than this may all be shape.
pub(super) const FEW_POINTS: usize = 60;
/// Points are dense where noise is above this part of an edge.
const DENSE: f64 = 1.0 / 6.0;
/// A run that says less than this part of the noise of all has less, if the mean cosine of its turns is not below the second.
const UNLIKELY: f64 = 0.3;
const WILD: f64 = 0.5;
/// Noise that is given and this many times as large or as small as what the points say is another.
const UNLIKE: f64 = 1.5;
/// The least is this part of an edge.
const NO_NOISE: f64 = 1e-9;
/// Fewer points than this are not smoothed.
pub(super) const FEWEST: usize = smoother::FEWEST;

/// Lengths of the edges of a list, none of them 0.
pub(super) fn lengths(points: &[Point3], closed: bool) -> Vec<f64> {
    chords::above_shortest(chords::chords(points, closed))
}

/// How far apart neighbors usually are.
pub(super) fn usual_length(points: &[Point3]) -> f64 {
    chords::median(&mut chords::chords(points, false))
}

/// The mean edge of a list.
fn mean_edge(points: &[Point3]) -> f64 {
    let lengths = chords::chords(points, false);
    lengths.iter().sum::<f64>() / lengths.len().max(1) as f64
}

/// One smooth piece of the data: their numbers, whether it is closed, and which ends stay.
pub(super) struct Run {
    pub numbers: Vec<usize>,
    pub closed: bool,
    pub fixed: [bool; 2],
}

impl Run {
    /// Its points, where they are smoothed.
    fn series<'a>(&self, points: &'a [Point3], directions: usize, noises: [Option<f64>; 2]) -> Series<'a> {
        let Self { closed, fixed, .. } = *self;
        let [noise, common] = noises;
        Series { points, closed, fixed, directions, chords: None, noise, common, weights: None }
    }

    /// The point at a position is an end that stays.
    fn is_held(&self, position: usize) -> bool {
        let last = self.numbers.len() - 1;
        !self.closed && ((position == 0 && self.fixed[0]) || (position == last && self.fixed[1]))
    }
}

/// How data are read.
#[derive(Clone, Copy)]
pub(super) struct Reading {
    /// The deviation of their noise, and that of heights, where it is known.
    pub noise: Option<f64>,
    /// What it is as other data say.
    pub common: Option<f64>,
    /// The heights have a noise of their own.
    pub heights: bool,
    /// Outliers are left out.
    pub drop: bool,
}

/// Data without their noise.
pub(super) struct Denoised {
    /// Numbers of the data, in order, and where each would be without noise.
    pub kept: Vec<usize>,
    pub places: Vec<Point3>,
    /// Deviation of the noise across the curve, in one direction; of heights, where they have their own.
    pub deviation: f64,
    pub heights: Option<f64>,
    /// Deviation of the places from what was measured.
    pub uncertainty: f64,
    /// Data that do not belong to the others, and how far each is from the curve of these.
    pub outliers: Vec<(usize, f64)>,
    /// Data after which heights with noise of their own step, and by how much.
    pub steps: Vec<(usize, f64)>,
    /// Directions across the curve.
    pub directions: usize,
    /// The deviation that the points say themselves, where another was given that they contradict.
    pub contradicted: Option<f64>,
}

impl Denoised {
    /// Degrees of freedom of the curve, as a part of the number of points.
    pub fn freedom(&self) -> f64 {
        (self.uncertainty / self.deviation).powi(2)
    }

    /// The warning about steps of heights, with the point before the highest.
    pub fn steps_named(&self, source: &[usize]) -> Option<Warning> {
        let (point, height) = self.steps.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(NoiseWarning::HeightStep { point: source[point], height, count: self.steps.len() }.into())
    }
}

/// What the runs say together, in units of the frame.
#[derive(Default)]
struct Sums {
    squares: f64,
    free: f64,
    uncertain: f64,
    count: f64,
    heights: f64,
    heights_free: f64,
    /// Some heights had noise of their own.
    has_heights: bool,
    outliers: Vec<(usize, f64)>,
    steps: Vec<(usize, f64)>,
}

impl Sums {
    fn add(&mut self, of: &Smoothed) {
        let n = of.points.len() as f64;
        self.squares += of.deviation.powi(2) * (n - of.freedom);
        self.free += n - of.freedom;
        self.uncertain += of.deviation.powi(2) * of.freedom;
        self.count += n;
    }

    fn add_heights(&mut self, of: &Smoothed) {
        let n = of.points.len() as f64;
        self.heights += of.deviation.powi(2) * (n - of.freedom);
        self.heights_free += n - of.freedom;
        self.has_heights = true;
    }

    /// Smooths heights that have noise of their own, between steps, over the places of a run in plan: `numbers` are those of its points that are
    /// left, `measured` all of them. What is left of both, in the same order.
    fn smooth_heights(
        &mut self,
        run: &Run,
        measured: &[Point3],
        numbers: &[usize],
        places: &[Point3],
        drop: bool,
    ) -> Option<(Vec<usize>, Vec<Point3>)> {
        let lengths = lengths(places, run.closed);
        let z: Vec<f64> = numbers.iter().map(|i| measured[*i].z).collect();
        let found = steps::steps(&z, &lengths, run.closed);
        self.steps.extend(found.iter().map(|(k, by)| (run.numbers[numbers[*k]], *by)));
        let mut placed: Vec<(usize, f64)> = Vec::new();
        for level in steps::between(&found, z.len(), run.closed) {
            let own: Vec<usize> = level.map(|k| k % z.len()).collect();
            let closed = run.closed && found.is_empty();
            let chords: Vec<f64> = own[..own.len() - usize::from(!closed)].iter().map(|k| lengths[*k]).collect();
            let heights: Vec<Point3> = own.iter().map(|k| Point3::new(0.0, 0.0, z[*k])).collect();
            let heights = Series {
                points: &heights,
                closed,
                fixed: [run.fixed[0] && own[0] == 0, run.fixed[1] && own[own.len() - 1] == z.len() - 1],
                directions: 1,
                chords: Some(&chords),
                noise: None,
                common: None,
                weights: None,
            };
            let protected = |i: usize| run.is_held(numbers[own[i]]);
            // Rounded heights are no better known than that.
            let floor = steps::rounding(&z);
            let found = cleaned(&heights, &protected).and_then(|found| {
                let is_below = found.smoothed.deviation < floor;
                if is_below { cleaned(&Series { noise: Some(floor), ..heights }, &protected) } else { Some(found) }
            });
            let Some(found) = found else {
                // Too few to tell.
                placed.extend(own.iter().map(|k| (*k, z[*k])));
                continue;
            };
            self.outliers.extend(found.outliers.iter().map(|(i, far)| (run.numbers[numbers[own[*i]]], *far)));
            self.add_heights(&found.smoothed);
            let (kept, smooth) = kept_or_held(&heights, found, drop)?;
            placed.extend(kept.iter().zip(&smooth).map(|(i, height)| (own[*i], height.z)));
        }
        placed.sort_by_key(|p| p.0);
        let smoothed = placed.iter().map(|(k, z)| places[*k] + Vec3::new(0.0, 0.0, *z)).collect();
        Some((placed.iter().map(|(k, _)| numbers[*k]).collect(), smoothed))
    }
}

/// Reads the noise of data in runs; `None` where no run has enough points.
pub(super) fn denoised(data: &[Point3], runs: &[Run], reading: Reading) -> Option<Denoised> {
    let mut found = with_reading(data, runs, reading)?;
    if let Some(noise) = reading.noise.filter(|_| data.len() >= FEW_POINTS) {
        let own = with_reading(data, runs, Reading { noise: None, ..reading })?.deviation;
        found.contradicted = Some(own).filter(|own| *own > UNLIKE * noise || *own * UNLIKE < noise);
    }
    Some(found)
}

fn with_reading(data: &[Point3], runs: &[Run], reading: Reading) -> Option<Denoised> {
    let frame = if reading.heights { WorkingFrame::in_axes(data) } else { WorkingFrame::new(data, diameter(data)) };
    let unit = frame.length(1.0);
    let across = if frame.planar() || reading.heights { 1 } else { directions(data, runs) };
    let flat = |p: Point3| if reading.heights { Point3::new(p.x, p.y, 0.0) } else { p };
    let locals: Vec<Vec<Point3>> =
        runs.iter().map(|r| r.numbers.iter().map(|i| frame.to_local(data[*i])).collect()).collect();
    let levels: Vec<Vec<Point3>> = locals.iter().map(|points| points.iter().copied().map(flat).collect()).collect();
    let noises = [reading.noise, reading.common].map(|noise| noise.map(|noise| frame.length(noise)));
    let mut pieces: Vec<_> = runs.iter().zip(&levels).map(|(run, points)| run.series(points, across, noises)).collect();
    let mut founds: Vec<_> = runs.iter().zip(&mut pieces).map(|(run, piece)| cleaned_run(run, piece)).collect();
    if reading.noise.or(reading.common).is_none() && runs.len() > 1 {
        with_common_noise(runs, &mut pieces, &mut founds);
    }
    let mut sums = Sums::default();
    let mut kept: Vec<(usize, Point3)> = Vec::new();
    for (((run, points), series), found) in runs.iter().zip(&locals).zip(&pieces).zip(founds) {
        let Some(found) = found else {
            kept.extend(run.numbers.iter().map(|i| (*i, data[*i])));
            continue;
        };
        sums.outliers.extend(found.outliers.iter().map(|(i, far)| (run.numbers[*i], *far)));
        sums.add(&found.smoothed);
        let (mut numbers, mut places) = kept_or_held(series, found, reading.drop)?;
        if reading.heights {
            (numbers, places) = sums.smooth_heights(run, points, &numbers, &places, reading.drop)?;
        }
        let ends = [numbers.first().copied(), numbers.last().copied()];
        for (i, place) in numbers.into_iter().zip(places) {
            let fixed = !run.closed && ((run.fixed[0] && ends[0] == Some(i)) || (run.fixed[1] && ends[1] == Some(i)));
            kept.push((run.numbers[i], if fixed { data[run.numbers[i]] } else { frame.to_world(place) }));
        }
    }
    if sums.count == 0.0 {
        return None;
    }
    // Corners end one run and begin the next.
    kept.sort_by_key(|k| k.0);
    kept.dedup_by_key(|k| k.0);
    // One may be one across and in its height.
    let to_world = |list: Vec<(usize, f64)>| list.into_iter().map(|(i, far)| (i, far / unit));
    let mut outliers: Vec<(usize, f64)> = to_world(sums.outliers).collect();
    outliers.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)));
    outliers.dedup_by_key(|o| o.0);
    let (kept, places) = kept.into_iter().unzip();
    Some(Denoised {
        kept,
        places,
        deviation: (sums.squares / sums.free).sqrt() / unit,
        heights: sums.has_heights.then(|| (sums.heights / sums.heights_free).sqrt() / unit),
        uncertainty: (sums.uncertain / sums.count).sqrt() / unit,
        outliers,
        steps: to_world(sums.steps).collect(),
        directions: across,
        contradicted: None,
    })
}

/// A run without its noise.
fn cleaned_run(run: &Run, series: &mut Series<'_>) -> Option<Cleaned> {
    let protected = |i: usize| run.is_held(i);
    let found = cleaned(series, &protected)?;
    // Few points of a shape that bends a lot: what the smoother leaves is no noise.
    let (points, closed) = (series.points, run.closed);
    let most =
        if series.noise.or(series.common).is_none() { most_noise(points, closed, series.directions) } else { None };
    let edge = mean_edge(points);
    let too_much = TOO_MUCH * (1.0 + UNSURE / points.len() as f64);
    let is_sure = |most: f64| most < OF_EDGE * edge || points.len() < FEW_POINTS;
    let is_less = |most: &f64| found.smoothed.deviation > if is_sure(*most) { too_much } else { FAR_TOO_MUCH } * most;
    if let Some(most) = most.filter(is_less) {
        series.noise = Some(most.max(NO_NOISE * edge));
        return Some(cleaned(series, &protected).unwrap_or(found));
    }
    Some(found)
}

/// Runs of few points follow their noise by chance: those that say less noise than all say together have as much.
fn with_common_noise(runs: &[Run], pieces: &mut [Series<'_>], founds: &mut [Option<Cleaned>]) {
    let mut sums = Sums::default();
    founds.iter().flatten().for_each(|found| sums.add(&found.smoothed));
    let common = (sums.squares / sums.free).sqrt();
    for ((run, piece), found) in runs.iter().zip(pieces).zip(founds) {
        let Some(own) = found else { continue };
        let is_dense = common > DENSE * mean_edge(piece.points);
        let least = if is_wild(piece.points) { 0.0 } else { UNLIKELY * common };
        if is_dense && (least..common).contains(&own.smoothed.deviation) {
            (piece.noise, piece.common) = (None, Some(common));
            // A curve that is freer finds a wrong point among few, which a stiff one leaves to the noise.
            let again = cleaned(piece, &|i| run.is_held(i));
            if let Some(again) = again.filter(|again| again.outliers.len() >= own.outliers.len()) {
                *own = again;
            }
        }
    }
}

/// The edges go to and fro, as they do among points that are noisier than they are apart.
fn is_wild(points: &[Point3]) -> bool {
    let edges = || points.windows(2).filter_map(|w| (w[1] - w[0]).unit());
    let cosines: f64 = edges().zip(edges().skip(1)).map(|(a, b)| a.dot(b)).sum();
    cosines < WILD * (points.len() - 2) as f64
}

/// Where the points of a run are without their noise, by their numbers in it: without its outliers, or with them as far as they
/// may pull the curve.
fn kept_or_held(series: &Series<'_>, found: Cleaned, drop: bool) -> Option<(Vec<usize>, Vec<Point3>)> {
    if drop || found.outliers.is_empty() {
        return Some((found.kept, found.smoothed.points));
    }
    let count = series.points.len();
    let mut weights = vec![1.0; count];
    // Each of them adds the square of its influence.
    let share = found.outliers.len() as f64 / count as f64;
    let noise = found.smoothed.deviation * (1.0 + INFLUENCE * INFLUENCE * share).sqrt();
    for (i, far) in &found.outliers {
        weights[*i] = (INFLUENCE * found.smoothed.deviation / far).min(1.0).powi(2);
    }
    let all = smoothed(&Series { weights: Some(&weights), noise: Some(noise), ..*series })?;
    Some(((0..count).collect(), all.points))
}
