//! Panels that one mould makes.

use std::cell::RefCell;
use std::collections::HashMap;

use super::bent_plane::Bend;
use super::mould_shape::MouldShape;
use super::nearest::{NearSurface, PanelFit, PanelPoints};
use crate::error::{Result, check_tolerance};
use crate::surface::CyclidePatch;

/// Trials by which the range of curvatures of a panel is found, to each side.
const TRIALS: usize = 10;
/// Steps of the ladder of tolerances for kinds.
const RUNGS: usize = 4;
/// Differences of bulges, in tolerances, beyond which no placing helps, times eight.
const FAR: f64 = 64.0;
/// What is within this part of the tolerance at the points of a fit is within all of it between them too, as a rule.
const INSIDE: f64 = 0.98;

/// A panel of a mould.
///
/// ```
/// let patch = cyclide::DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// let moulds = cyclide::Moulds::new(&[patch], 1e-9)?;
/// let member = moulds.moulds[0].members[0];
/// assert!(member.panel == 0 && member.near.max_distance < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MouldMember {
    /// Its number among the panels given.
    pub panel: usize,
    /// The mould, placed as near to it as can be, with the largest distance of the panel from it.
    pub near: NearSurface,
}

/// A mould with the panels that it makes.
///
/// ```
/// let patch = cyclide::DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// let moulds = cyclide::Moulds::new(&[patch, patch], 1e-9)?;
/// assert_eq!((moulds.moulds.len(), moulds.moulds[0].members.len()), (1, 2));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mould {
    /// Its form.
    pub shape: MouldShape,
    /// The panels, by their numbers. All are within the tolerance of it.
    pub members: Vec<MouldMember>,
}

/// Panels in groups that are made on one mould each.
///
/// A panel is made on a mould of the simplest kind that is within the tolerance of it ([`NearSurface::simplest`]): plane, cylinder, cone,
/// sphere, torus. Of a kind, panels share a mould if it can be placed within the tolerance of each: radii are
/// compared by what their difference does over the panel, so that a small panel goes with a wide range of radii. Either side of a sheet may be the
/// outer one: a panel and one that is turned over, or mirrored, may share a mould.
///
/// Cylinders and spheres have one radius: of the ranges of curvatures that are good for each panel, as few are taken as meet all ranges,
/// which is the least number (ranges are found by fits and are as good as these). Cones and tori are led: the first panel in the order of
/// radii takes all that its own mould makes.
///
/// With a larger tolerance the same panels need no more moulds of cylinders and spheres. But kinds change: a panel that becomes simpler may need a mould
/// of that kind, when the one it had is still needed by others. So the kinds of smaller tolerances are tried too, in steps that hang on the
/// size of the panels, and the fewest moulds are taken; a panel may then be on a mould that is less simple than it could be. Fewer moulds at a larger
/// tolerance are the rule by that, and not proved: cones and tori are led, and steps are four.
///
/// ```
/// use cyclide::{CyclidePatch, Moulds, Point3, Vec3};
/// let octant = |r: f64| {
///     let corners = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::Z].map(|v| Point3::ORIGIN + v * r);
///     CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)
/// };
/// let panels = [octant(1.0)?, octant(1.001)?, octant(2.0)?];
/// assert_eq!(Moulds::new(&panels, 1e-2)?.count(), 2);
/// assert_eq!(Moulds::new(&panels, 1e-6)?.count(), 3);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Moulds {
    /// The moulds by kind and radius; a flat sheet is one of them.
    pub moulds: Vec<Mould>,
    /// The panels that are on no simple surface within the tolerance, by their numbers: each needs a mould of its own, or one for each
    /// class of those that are [congruent](super::Congruences).
    pub free: Vec<usize>,
}

impl Moulds {
    /// The moulds for panels. The groups do not depend on the order of the panels, as long as no two have the same radii but for
    /// rounding and different sizes.
    ///
    /// # Errors
    /// `tolerance-not-positive`.
    pub fn new(panels: &[CyclidePatch], tolerance: f64) -> Result<Self> {
        check_tolerance(tolerance)?;
        let workshop = Workshop::new(panels, tolerance);
        let mut rungs: Vec<Vec<Option<Bend>>> = Vec::new();
        for strict in ladder(panels, tolerance) {
            let kinds = workshop.kinds(strict);
            if !rungs.contains(&kinds) {
                rungs.push(kinds);
            }
        }
        // Those of the fewest kinds first: what they need is the limit for the others.
        let mut order: Vec<usize> = (0..rungs.len()).collect();
        order.sort_by_key(|rung| (fewest(&rungs[*rung]), *rung));
        let mut best: Option<(Self, usize)> = None;
        for rung in order {
            // Of as many moulds the earlier rung has the simpler ones.
            let limit = best.as_ref().map_or(usize::MAX, |(best, at)| best.count() + usize::from(rung < *at));
            if let Some(made) = workshop.moulds(&rungs[rung], limit) {
                best = Some((made, rung));
            }
        }
        let best = best.map(|best| best.0);
        Ok(best.unwrap_or(Self { moulds: Vec::new(), free: Vec::new() }))
    }

    /// How many moulds there are, with one for each free panel.
    #[must_use]
    pub fn count(&self) -> usize {
        self.moulds.len() + self.free.len()
    }
}

/// Tolerances for the kinds: the given one, and steps of a ladder that depends on the panels only, so that what is good at a smaller tolerance is tried
/// at a larger one too.
fn ladder(panels: &[CyclidePatch], tolerance: f64) -> Vec<f64> {
    let size = panels.iter().map(CyclidePatch::size).fold(0.0, f64::max);
    let steps = (0..64).map(|k| size * 8.0_f64.powi(-k)).filter(|step| *step < tolerance);
    std::iter::once(tolerance).chain(steps.take(RUNGS)).collect()
}

/// The moulds that panels of given kinds need at least: one for each kind, and for each free panel.
fn fewest(kinds: &[Option<Bend>]) -> usize {
    let free = kinds.iter().filter(|kind| kind.is_none()).count();
    free + KINDS.iter().filter(|bend| kinds.contains(&Some(**bend))).count()
}

fn compare(a: &[f64], b: &[f64]) -> std::cmp::Ordering {
    let mut pairs = a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
    pairs.find(|order| order.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
}

/// The kinds of moulds, the simplest first.
const KINDS: [Bend; 5] = [Bend::Plane, Bend::Cylinder, Bend::Cone, Bend::Sphere, Bend::Torus];

/// What was found of panels on moulds, by the panel and the numbers of the mould.
type KnownMembers = HashMap<(usize, [u64; 3]), Option<MouldMember>>;

/// The panels with their surfaces within the tolerance.
struct Workshop<'a> {
    panels: &'a [CyclidePatch],
    /// By the places of [`KINDS`].
    fits: Vec<[Option<PanelFit>; KINDS.len()]>,
    tolerance: f64,
    /// What was found already: rungs of the ladder differ in few panels. Members by panel and mould, ranges by panel and kind.
    members: RefCell<KnownMembers>,
    ranges: RefCell<HashMap<(usize, u64), [f64; 3]>>,
}

/// A panel on a mould of some kind.
#[derive(Clone, Copy)]
struct Job<'a> {
    panel: usize,
    fit: &'a PanelFit,
    own: MouldShape,
}

/// The curvatures that are good for a panel.
struct Range<'a> {
    job: Job<'a>,
    own: f64,
    low: f64,
    high: f64,
}

impl Range<'_> {
    /// By the ends; the number of the panel is asked last, for panels that are the same.
    fn order(&self, other: &Self) -> std::cmp::Ordering {
        let numbers = |range: &Self| [range.high, range.low, range.own];
        compare(&numbers(self), &numbers(other)).then(self.job.panel.cmp(&other.job.panel))
    }
}

impl<'a> Workshop<'a> {
    fn new(panels: &'a [CyclidePatch], tolerance: f64) -> Self {
        let strictest = ladder(panels, tolerance).into_iter().fold(tolerance, f64::min);
        let fits = |panel: &CyclidePatch| {
            let points = PanelPoints::new(panel);
            let limit = tolerance / points.unit.size;
            let mut is_found = false;
            KINDS.map(|bend| {
                // Of no use where a simpler one is within every tolerance for kinds.
                let fit = if is_found { None } else { points.fit(bend, limit) };
                is_found |= fit.is_some_and(|fit| fit.max_distance <= strictest);
                fit.filter(|fit| fit.max_distance <= tolerance)
            })
        };
        let fits = panels.iter().map(fits).collect();
        Self { panels, fits, tolerance, members: RefCell::default(), ranges: RefCell::default() }
    }

    /// The kind of each panel: the simplest within `strict`, or where there is none, the nearest.
    fn kinds(&self, strict: f64) -> Vec<Option<Bend>> {
        let kind = |fits: &[Option<PanelFit>; KINDS.len()]| {
            let within = fits.iter().flatten().find(|fit| fit.max_distance <= strict);
            let nearest = || fits.iter().flatten().min_by(|a, b| a.max_distance.total_cmp(&b.max_distance));
            within.or_else(nearest).map(|fit| fit.shape.bend)
        };
        self.fits.iter().map(kind).collect()
    }

    /// The moulds for panels of given kinds; `None` unless they are fewer than so many, which is seen before all are made.
    fn moulds(&self, kinds: &[Option<Bend>], limit: usize) -> Option<Moulds> {
        let free: Vec<usize> = (0..kinds.len()).filter(|panel| kinds[*panel].is_none()).collect();
        if fewest(kinds) >= limit {
            return None;
        }
        let limit = limit - free.len();
        let mut moulds = Vec::new();
        for (at, bend) in KINDS.into_iter().enumerate() {
            let panels = (0..self.panels.len()).filter(|panel| kinds[*panel] == Some(bend));
            let jobs = panels.filter_map(|panel| {
                let fit = self.fits[panel][at].as_ref()?;
                Some(Job { panel, fit, own: MouldShape::of(fit, self.panels[panel].size()) })
            });
            match bend {
                Bend::Plane | Bend::Cone | Bend::Torus => self.led(jobs.collect(), &mut moulds, limit),
                Bend::Cylinder | Bend::Sphere => {
                    self.met(jobs.map(|job| self.range(job)).collect(), &mut moulds, limit);
                }
            }
            if moulds.len() >= limit {
                return None;
            }
        }
        for mould in &mut moulds {
            mould.members.sort_by_key(|member| member.panel);
        }
        moulds.sort_by(|a, b| compare(&a.shape.order(), &b.shape.order()));
        Some(Moulds { moulds, free })
    }

    /// A panel on a mould, if it is within the tolerance of it.
    fn member(&self, job: &Job<'_>, shape: &MouldShape) -> Option<MouldMember> {
        let key = (job.panel, shape.order().map(f64::to_bits));
        if let Some(known) = self.members.borrow().get(&key) {
            return *known;
        }
        let member = self.placed(job, shape);
        self.members.borrow_mut().insert(key, member);
        member
    }

    fn placed(&self, job: &Job<'_>, shape: &MouldShape) -> Option<MouldMember> {
        let (panel, points) = (job.panel, PanelPoints::new(&self.panels[job.panel]));
        if job.own == *shape {
            return Some(MouldMember { panel, near: points.near_surface(job.fit)? });
        }
        let (placed, largest) = points.place(job.fit, shape, [0.0, self.tolerance]);
        if largest > self.tolerance {
            return None;
        }
        let near = points.near_surface(&points.measured(placed))?;
        (near.max_distance <= self.tolerance).then_some(MouldMember { panel, near })
    }

    /// Groups whose first panel in the order of radii leads, up to a number of moulds.
    fn led(&self, jobs: Vec<Job<'_>>, moulds: &mut Vec<Mould>, limit: usize) {
        let mut waiting = jobs;
        waiting.sort_by(|a, b| compare(&a.own.order(), &b.own.order()).then(a.panel.cmp(&b.panel)));
        while let Some(leader) = waiting.first().copied().filter(|_| moulds.len() < limit) {
            let mut mould = Mould { shape: leader.own, members: Vec::new() };
            let mut left = Vec::new();
            for (place, job) in waiting.into_iter().enumerate() {
                let member = if self.may_be(&job, &leader.own) { self.member(&job, &leader.own) } else { None };
                match member {
                    Some(member) => mould.members.push(member),
                    // The leader is gone in any case, so that there is an end.
                    None if place > 0 => left.push(job),
                    None => {}
                }
            }
            moulds.push(mould);
            waiting = left;
        }
    }

    /// False of a panel on a torus whose tube is bent otherwise by far more than the tolerance allows over the panel: it need not be tried.
    fn may_be(&self, job: &Job<'_>, shape: &MouldShape) -> bool {
        let (MouldShape::Torus { minor_radius: a, .. }, MouldShape::Torus { minor_radius: b, .. }) = (job.own, *shape)
        else {
            return true;
        };
        let [p, q, r, _] = self.panels[job.panel].corners();
        let width = p.distance(q).min(p.distance(r));
        // Bulges of an eighth of the curvature times the square of the width, off by a tolerance at both ends and in the middle.
        (1.0 / a - 1.0 / b).abs() * width * width <= FAR * self.tolerance
    }

    /// Groups of panels whose ranges of curvature have one in common, as few as can be, up to a number of moulds.
    fn met(&self, ranges: Vec<Range<'_>>, moulds: &mut Vec<Mould>, limit: usize) {
        let mut waiting = ranges;
        waiting.sort_by(Range::order);
        while let Some(first) = waiting.first().filter(|_| moulds.len() < limit) {
            let (point, leader) = (first.high, first.job);
            let (group, mut left): (Vec<_>, Vec<_>) = waiting.into_iter().partition(|range| range.low <= point);
            let low = group.iter().map(|range| range.low).fold(0.0, f64::max);
            let mut own: Vec<f64> = group.iter().map(|range| range.own).collect();
            own.sort_by(f64::total_cmp);
            let middle = own[own.len() / 2];
            // A panel's own radius if it may be: nothing then is rounded.
            let common = if middle >= low && middle <= point { middle } else { middle.max(low).min(point) };
            let job = group.iter().find(|range| range.own.total_cmp(&common).is_eq()).map(|range| range.job.own);
            let shape = job.unwrap_or_else(|| with_radius(&leader.own, 1.0 / common));
            let mut mould = Mould { shape, members: Vec::new() };
            for range in group {
                match self.member(&range.job, &shape) {
                    Some(member) => mould.members.push(member),
                    None => left.push(range),
                }
            }
            // Ranges are good to the points of the fits only: if all fail by that, the first is on its own.
            if mould.members.is_empty() {
                left.retain(|range| range.job.panel != leader.panel);
                mould.shape = leader.own;
                mould.members.extend(self.member(&leader, &leader.own));
            }
            moulds.push(mould);
            left.sort_by(Range::order);
            waiting = left;
        }
    }

    /// The curvatures that are good for a panel of a cylinder or sphere.
    fn range<'b>(&self, job: Job<'b>) -> Range<'b> {
        let key = (job.panel, job.own.order()[0].to_bits());
        let known = self.ranges.borrow().get(&key).copied();
        let [own, low, high] = known.unwrap_or_else(|| self.good_curvatures(&job));
        self.ranges.borrow_mut().insert(key, [own, low, high]);
        Range { job, own, low, high }
    }

    /// The curvature of a panel's own mould, the least and the largest that are good for it.
    fn good_curvatures(&self, job: &Job<'_>) -> [f64; 3] {
        let points = PanelPoints::new(&self.panels[job.panel]);
        let size = points.unit.size;
        let own = job.fit.shape.across.abs() / size;
        let enough = INSIDE * self.tolerance;
        let is_good = |curvature: f64| {
            let shape = with_radius(&job.own, 1.0 / curvature);
            curvature > 0.0 && points.place(job.fit, &shape, [enough, self.tolerance]).1 <= enough
        };
        let reach = |sign: f64| {
            // The bulge of the panel is an eighth of the curvature times the square of its size.
            let (mut good, mut bad, mut step) = (own, None, sign * 8.0 * self.tolerance / (size * size));
            for _ in 0..TRIALS {
                let trial = bad.map_or(good + step, |bad: f64| 0.5 * (good + bad));
                if is_good(trial) {
                    (good, step) = (trial, 2.0 * step);
                } else {
                    bad = Some(trial);
                }
            }
            good
        };
        [own, reach(-1.0), reach(1.0)]
    }
}

/// A cylinder or sphere with another radius.
fn with_radius(shape: &MouldShape, radius: f64) -> MouldShape {
    match shape {
        MouldShape::Sphere { .. } => MouldShape::Sphere { radius },
        _ => MouldShape::Cylinder { radius },
    }
}
