//! Corners that the noise of measured points hides: where two straight runs of points meet in one of them, or between two of them,
//! a smooth curve through them all cuts the corner by more than the noise (`docs/math/fair-fits.md#noise`).

use super::FairFitOptions;
use super::dense_corners::with_dense_corners;
use super::edged::{Edged, in_plan};
use super::measured::read;
use super::noise::{self, Denoised};
use super::sides::{self, SIDE};
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::input::Distinct;
use crate::warning::{NoiseWarning, Warning};
use std::borrow::Cow;
use std::cmp::Ordering;

/// The smooth curve is off the corner by more than this many deviations of the noise with it,
const OFF: f64 = 3.0;
/// and by more than this many of the noise without.
const OFF_BEFORE: f64 = 2.5;
/// A corner that is farther from the points beside it than so many deviations is none of them, whatever they are off its sides.
const CLEAR: f64 = 3.0;
/// What the smooth curve leaves is not the noise where neighbors tell less than this part of it.
const OF_CUTS: f64 = 0.6;
/// A curve that is free enough to bend in each corner is off none of them. All of them together are corners where the curve with them
/// leaves no more noise with this part of that freedom: for false ones it needs as much or more.
const FREEDOM: f64 = 0.7;
/// Rounds in which corners that the others explain are given up.
const ROUNDS: usize = 12;

/// What measured points are read as: corners, sides and noise.
pub(super) struct Sharp {
    /// The points with the corners between them, where there are such.
    pub inserted: Option<Distinct>,
    pub edged: Edged,
    pub found: Denoised,
}

impl Sharp {
    /// The warning about corners between points: an inserted one stands for the same point as the one before it.
    pub fn inserted_corners(&self) -> Option<Warning> {
        let Distinct { points, source, .. } = self.inserted.as_ref()?;
        let n = points.len();
        let is_inserted = |i: &usize| source[*i] == source[*i - 1];
        let first = (1..n).find(is_inserted)?;
        let count = (1..n).filter(is_inserted).count();
        let beyond = |i: usize| noise::from_segment(points[i], points[i - 1], points[(i + 1) % n]);
        let distance = (1..n).filter(is_inserted).map(beyond).fold(0.0, f64::max);
        let (point, at) = (source[first], points[first].to_vec().to_array());
        Some(Warning::Noise(NoiseWarning::CornersInserted { point, at, distance, count }))
    }

    pub fn or_inserted(self, inserted: Option<Distinct>) -> Self {
        Self { inserted: self.inserted.or(inserted), ..self }
    }

    /// What was found, about the points that were given alone.
    pub fn of_own(self, distinct: &Distinct) -> Denoised {
        let Self { inserted, mut found, .. } = self;
        if let Some(inserted) = inserted {
            found.outliers.iter_mut().for_each(|outlier| outlier.0 = distinct.position(inserted.source[outlier.0]));
        }
        found
    }
}

/// The reading with those corners too, or as it was.
pub(super) fn with_meeting_sides(
    distinct: &Distinct,
    options: &FairFitOptions,
    edged: Edged,
    found: Denoised,
) -> Sharp {
    // A corner may have been an outlier of the smooth curve.
    let explains =
        |was: &Denoised, is: &Denoised| is.deviation < was.deviation || is.outliers.len() < was.outliers.len();
    let is_simpler =
        |was: &Denoised, is: &Denoised| is.deviation <= was.deviation && is.freedom() < FREEDOM * was.freedom();
    let mut sharp = Sharp { inserted: None, edged, found };
    for place in [Place::Points, Place::Between] {
        // With corners there is less noise, and others stand out.
        for _ in 0..ROUNDS {
            let all = sharp.inserted.as_ref().unwrap_or(distinct);
            let next = Meetings::new(all, options, &sharp.edged, &sharp.found, place).each();
            match next.filter(|next| explains(&sharp.found, &next.found)) {
                Some(next) => sharp = next.or_inserted(sharp.inserted),
                None => break,
            }
        }
        let all = sharp.inserted.as_ref().unwrap_or(distinct);
        let next = Meetings::new(all, options, &sharp.edged, &sharp.found, place).together();
        if let Some(next) = next.filter(|next| is_simpler(&sharp.found, &next.found)) {
            sharp = next.or_inserted(sharp.inserted);
        }
    }
    with_dense_corners(distinct, options, sharp)
}

/// Where corners are looked for: points are tried first.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Place {
    Points,
    Between,
}

/// A point in which sides meet.
#[derive(Clone, Copy)]
pub(super) struct Meeting {
    /// Its position; of one between points that of the point before it.
    pub at: usize,
    between: Option<Point3>,
    /// It is none of the points beside it.
    is_clear: bool,
    /// How far it is off the lines of both sides, or the points of these are.
    misfit: f64,
    /// How far the smooth curve is off it.
    off: f64,
}

impl Meeting {
    /// One behind a point, that is none of the points.
    pub fn between(at: usize, corner: Point3) -> Self {
        Self { at, between: Some(corner), is_clear: true, misfit: 0.0, off: 0.0 }
    }
}

/// Points in which sides may meet.
pub(super) struct Meetings<'a> {
    distinct: &'a Distinct,
    options: &'a FairFitOptions,
    edged: &'a Edged,
    points: Cow<'a, [Point3]>,
    /// How far the smooth curve is off each point.
    offs: Vec<f64>,
    /// Where the smooth curve has each point.
    places: Vec<Point3>,
    /// What the noise may be.
    noises: [f64; 2],
    /// Corners that were asked for, rising.
    forced: Vec<usize>,
    place: Place,
}

impl<'a> Meetings<'a> {
    pub fn new(
        distinct: &'a Distinct,
        options: &'a FairFitOptions,
        edged: &'a Edged,
        found: &Denoised,
        place: Place,
    ) -> Self {
        // Most points lie on sides, where their neighbors tell their noise: a curve that cuts corners everywhere takes the cuts for some.
        let most = noise::most_noise(&distinct.points, options.closed, found.directions).unwrap_or(found.deviation);
        let noises = [most.min(found.deviation), if most < OF_CUTS * found.deviation { most } else { found.deviation }];
        let points = in_plan(&distinct.points, options);
        let offs = offs(&distinct.points, &points, found);
        let mut places = points.to_vec();
        let is_plan = points[..] != distinct.points[..];
        for (i, place) in found.kept.iter().zip(&found.places) {
            places[*i] = if is_plan { Point3::new(place.x, place.y, 0.0) } else { *place };
        }
        let mut forced: Vec<usize> = options.corners.iter().map(|c| distinct.position(*c)).collect();
        forced.sort_unstable();
        Self { distinct, options, edged, points, offs, places, noises, forced, place }
    }

    /// The reading with the corners that the smooth curve cuts, each by more than the noise.
    fn each(&self) -> Option<Sharp> {
        let mut added = self.alone(OFF_BEFORE, |meeting| -meeting.off);
        for _ in 0..ROUNDS {
            let sharp = self.with(&added)?;
            let count = added.len();
            added.retain(|meeting| meeting.off > OFF * sharp.found.deviation);
            if added.len() == count {
                return Some(sharp);
            }
        }
        None
    }

    /// The reading with all of them.
    fn together(&self) -> Option<Sharp> {
        self.with(&self.alone(0.0, |meeting| meeting.misfit))
    }

    pub fn with(&self, added: &[Meeting]) -> Option<Sharp> {
        if added.is_empty() {
            return None;
        }
        let Edged { corners, straight } = self.edged;
        if added.iter().all(|meeting| meeting.between.is_none()) {
            let mut corners: Vec<usize> = corners.iter().copied().chain(added.iter().map(|m| m.at)).collect();
            corners.sort_unstable();
            let edged = Edged { corners, straight: straight.clone() };
            let found = read(self.distinct, self.options, &edged)?;
            return Some(Sharp { inserted: None, edged, found });
        }
        let n = self.points.len();
        let mut own = vec![false; n];
        corners.iter().for_each(|i| own[*i] = true);
        // The points beside a corner that is none of them were taken for it.
        for meeting in added.iter().filter(|meeting| meeting.between.is_some()) {
            let beside = (0..SIDE[0]).flat_map(|k| [meeting.at + n - k, meeting.at + 1 + k]).map(|i| i % n);
            beside.filter(|i| self.forced.binary_search(i).is_err()).for_each(|i| own[i] = false);
        }
        added.iter().filter(|meeting| meeting.between.is_none()).for_each(|meeting| own[meeting.at] = true);
        let mut between = added.iter().filter_map(|meeting| Some((meeting.at, meeting.between?))).peekable();
        let (mut points, mut source, mut edged) = (Vec::new(), Vec::new(), Edged::default());
        for i in 0..n {
            if own[i] {
                edged.corners.push(points.len());
            }
            points.push(self.distinct.points[i]);
            source.push(self.distinct.source[i]);
            edged.straight.push(straight[i]);
            while let Some((_, corner)) = between.next_if(|next| next.0 == i) {
                edged.corners.push(points.len());
                points.push(corner);
                source.push(self.distinct.source[i]);
                edged.straight.push(straight[i]);
            }
        }
        let mut distinct = Distinct::of(points, source, self.distinct.warnings.clone());
        distinct.moved = self.distinct.moved;
        let found = read(&distinct, self.options, &edged)?;
        Some(Sharp { inserted: Some(distinct), edged, found })
    }

    /// Places that the smooth curve is off by that many deviations of the noise: of those next to each other the one between points
    /// whose sides are straightest, and else the point that is least in rank; where points may be corners themselves these come first.
    fn alone(&self, off: f64, rank: impl Fn(&Meeting) -> f64) -> Vec<Meeting> {
        let n = self.points.len();
        let find = |i: usize| self.noises.iter().find_map(|noise| self.at(i, *noise, off));
        let all: Vec<Meeting> = (0..n).filter_map(find).collect();
        let closed = self.options.closed;
        let apart = |i: usize, j: usize| if closed { i.abs_diff(j).min(n - i.abs_diff(j)) } else { i.abs_diff(j) };
        // They rise: those beside one are next to it in the list.
        let count = all.len();
        let class = |meeting: &Meeting| if meeting.between.is_none() { 1 } else { 2 * u8::from(!meeting.is_clear) };
        let comes_first = |a: &Meeting, b: &Meeting| match class(a).cmp(&class(b)) {
            Ordering::Equal if a.between.is_some() => a.misfit < b.misfit,
            Ordering::Equal => rank(a) < rank(b),
            order => order.is_lt(),
        };
        let is_first = |(k, meeting): &(usize, &Meeting)| {
            let beside = (1..=SIDE[0]).flat_map(|step| [k + step, k + SIDE[0] * count - step]);
            let others = beside.map(|other| &all[other % count]);
            let mut others = others.filter(|other| other.at != meeting.at && apart(other.at, meeting.at) <= SIDE[0]);
            others.all(|other| comes_first(meeting, other))
        };
        all.iter().enumerate().filter(is_first).map(|(_, meeting)| *meeting).collect()
    }

    /// Whether sides meet at a point, or between it and the next.
    fn at(&self, i: usize, noise: f64, off: f64) -> Option<Meeting> {
        let (n, source) = (self.points.len(), &self.distinct.source);
        let mut beside = (0..=2 * SIDE[0]).map(|k| (i + n + k - SIDE[0]) % n);
        if beside.any(|k| k > 0 && source[k] == source[k - 1]) {
            // That corner was inserted.
            return None;
        }
        let between = if self.place == Place::Between { self.between(i, noise, off) } else { None };
        if between.is_some_and(|meeting| meeting.is_clear) {
            return between;
        }
        let is_corner = self.edged.corners.binary_search(&i).is_ok();
        let is_cut = !is_corner && self.offs[i] >= off * noise;
        let misfit = sides::meet(&self.points, i, self.options, noise).filter(|_| is_cut);
        let own = misfit.map(|misfit| Meeting { at: i, between: None, is_clear: true, misfit, off: self.offs[i] });
        own.or(between)
    }

    fn between(&self, i: usize, noise: f64, off: f64) -> Option<Meeting> {
        let (points, given) = (&self.points, &self.distinct.points);
        let (corner, misfit) = sides::meet_between(points, i, self.options, noise)?;
        let next = (i + 1) % points.len();
        let is_free = |i: usize| self.forced.binary_search(&i).is_err();
        let far = noise::from_segment(corner, self.places[i], self.places[next]);
        if !(is_free(i) && is_free(next) && far >= off.max(OFF) * noise) {
            return None;
        }
        let [from, to] = [i, next].map(|i| corner.distance(points[i]));
        let is_clear = from.min(to) > CLEAR * noise;
        // In plan it has the height that the edge has there.
        let is_plan = points[i] != given[i] || points[next] != given[next];
        let height = given[i].lerp(given[next], from / (from + to)).z;
        let corner = if is_plan { Point3::new(corner.x, corner.y, height) } else { corner };
        Some(Meeting { at: i, between: Some(corner), is_clear, misfit, off: far })
    }
}

/// How far the smooth curve is off each point, in plan if that is where they are.
fn offs(points: &[Point3], plan: &[Point3], found: &Denoised) -> Vec<f64> {
    let is_plan = points != plan;
    let flat = |p: Point3| if is_plan { Point3::new(p.x, p.y, 0.0) } else { p };
    let mut offs = vec![0.0; plan.len()];
    for (i, place) in found.kept.iter().zip(&found.places) {
        offs[*i] = plan[*i].distance(flat(*place));
    }
    for (i, distance) in &found.outliers {
        if !is_plan {
            offs[*i] = *distance;
        } else if found.kept.binary_search(i).is_err() {
            // It may be off by its height alone.
            offs[*i] = beside_places(plan[*i], *i, found, flat);
        }
    }
    offs
}

/// How far a point is from the smoothed ones beside it.
fn beside_places(point: Point3, at: usize, found: &Denoised, flat: impl Fn(Point3) -> Point3) -> f64 {
    let after = found.kept.partition_point(|i| *i < at);
    let places = |k: usize| found.places.get(k).copied().map(&flat);
    match (after.checked_sub(1).and_then(&places), places(after)) {
        (Some(a), Some(b)) => noise::from_segment(point, a, b),
        (Some(only), None) | (None, Some(only)) => point.distance(only),
        (None, None) => 0.0,
    }
}
