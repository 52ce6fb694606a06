//! Panels that one mould makes.

use std::cell::{OnceCell, RefCell};
use std::collections::HashMap;

use super::bent_plane::Bend;
use super::mould_shape::MouldShape;
use super::nearest::{NearSurface, PanelPoints};
use super::panel_fit::PanelFit;
use crate::error::{Result, check_tolerance};
use crate::surface::CyclidePatch;

/// Trials by which the range of curvatures of a panel is found, to each side.
const TRIALS: usize = 10;
/// Steps of the ladder of tolerances for kinds.
const RUNGS: usize = 4;
/// So many moulds are allowed first, free panels apart.
const FIRST_ALLOWED: usize = 4;
/// So many panels are looked at before all, a prime: steps of a net are of other lengths than its rows.
const FEW: usize = 31;
/// Differences of bulges, in tolerances, beyond which no placing helps, times eight.
const FAR: f64 = 64.0;
/// Of the bulges of cones, which are off at the ends of the rulings only, this part counts.
const CONE: f64 = 0.25;
/// What is within this part of the tolerance at the points of a fit is within all of it between them too, as a rule.
const INSIDE: f64 = 0.98;

/// A panel of a mould.
///
/// ```
/// let patch = cyclide::surface::DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// let moulds = cyclide::panel::Moulds::new(&[patch], 1e-9)?;
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
/// let patch = cyclide::surface::DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// let moulds = cyclide::panel::Moulds::new(&[patch, patch], 1e-9)?;
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
/// size of the panels, and the fewest moulds are taken; a panel may then be on a mould that is less simple than it could be.
///
/// A panel that is exactly on a cone is on a cone, not on a cylinder that is within the tolerance, unless that needs fewer moulds: both are
/// rolled from a sheet, and the cone has no deviation. The same holds for tori and spheres. A flat sheet is kept wherever it is within the tolerance.
///
/// Fewer moulds at a larger
/// tolerance are the rule by that, and not proved: cones and tori are led, and steps are four. Where all panels lie on one kind of
/// surface and one mould of it makes them, it does.
///
/// ```
/// use cyclide::{Point3, Vec3, panel::Moulds, surface::CyclidePatch};
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
        let best = workshop.one_mould().or_else(|| workshop.fewest_moulds());
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

/// How panels of a kind are made: cut from a flat sheet, rolled from one, or formed.
const fn making(bend: Bend) -> u8 {
    match bend {
        Bend::Plane => 0,
        Bend::Cylinder | Bend::Cone => 1,
        Bend::Sphere | Bend::Torus => 2,
    }
}

/// What was found of panels on moulds, by the panel and the numbers of the mould.
type KnownMembers = HashMap<(usize, [u64; 3]), Option<MouldMember>>;

/// The panels with their surfaces within the tolerance.
struct Workshop<'a> {
    panels: &'a [CyclidePatch],
    /// By the places of [`KINDS`]; found when they are asked for first.
    fits: Vec<[OnceCell<Option<PanelFit>>; KINDS.len()]>,
    /// The kind of the surface that a panel lies on to rounding.
    exact: Vec<Option<Bend>>,
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

/// How a panel of a mould that leads is bent, and what a difference of that does over its width: times eight, a bulge.
#[derive(Clone, Copy)]
struct Bulge {
    bend: f64,
    width: f64,
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
        let fits = panels.iter().map(|_| Default::default()).collect();
        let exact = panels.iter().map(|panel| PanelPoints::new(panel).exact()).collect();
        Self { panels, fits, exact, tolerance, members: RefCell::default(), ranges: RefCell::default() }
    }

    /// The nearest surface of a kind, if it is within the tolerance.
    fn fit(&self, panel: usize, bend: Bend) -> Option<&PanelFit> {
        let find = || {
            let points = PanelPoints::new(&self.panels[panel]);
            let fit = points.fit(bend, self.tolerance / points.unit.size);
            fit.filter(|fit| fit.max_distance <= self.tolerance)
        };
        self.fits[panel][bend as usize].get_or_init(find).as_ref()
    }

    /// The fewest moulds that the kinds of some rung of the ladder need.
    fn fewest_moulds(&self) -> Option<Moulds> {
        let first = self.made_exact(&self.kinds(self.tolerance, usize::MAX)?);
        let free = first.iter().filter(|kind| kind.is_none()).count();
        // Surfaces of other kinds take most of the time. Where the first rung needs few moulds they are asked for only until it is seen
        // that the other rungs need as many.
        let mut best = self.moulds(&first, free + FIRST_ALLOWED).map(|made| (made, 0));
        let enough = best.as_ref().map_or(usize::MAX, |(made, _)| made.count() - free);
        let mut rungs = vec![first];
        for strict in ladder(self.panels, self.tolerance) {
            let Some(simplest) = self.kinds(strict, enough) else { continue };
            // Of as many moulds the earlier rung is taken: that without a deviation.
            for kinds in [self.made_exact(&simplest), simplest] {
                if !rungs.contains(&kinds) {
                    rungs.push(kinds);
                }
            }
        }
        // Those of the fewest kinds first: what they need is the limit for the others.
        let mut order: Vec<usize> = (0..rungs.len()).collect();
        order.sort_by_key(|rung| (fewest(&rungs[*rung]), *rung));
        // All have the same free panels. Of the others a rung may need a mould for each, where another needs one for all: each is led
        // to few moulds first, and to twice as many as long as none is enough, so that none makes many more than the best needs.
        let mut allowed = FIRST_ALLOWED;
        loop {
            let most = if allowed > self.panels.len() { usize::MAX } else { free + allowed };
            for &rung in &order {
                // Of as many moulds the earlier rung has the simpler ones.
                let limit = best.as_ref().map_or(most, |(best, at)| best.count() + usize::from(rung < *at));
                if let Some(made) = self.moulds(&rungs[rung], limit) {
                    best = Some((made, rung));
                }
            }
            if best.is_some() || most == usize::MAX {
                return best.map(|best| best.0);
            }
            allowed *= 2;
        }
    }

    /// The kind of each panel: the simplest within `strict`, or where there is none, the nearest; `None` as soon as there are panels that
    /// are made in `enough` ways, each of which needs a mould.
    fn kinds(&self, strict: f64, enough: usize) -> Option<Vec<Option<Bend>>> {
        let mut is_used = [false; 3];
        let kind = |panel: usize| {
            let kind = self.kind(panel, strict);
            kind.into_iter().for_each(|bend| is_used[usize::from(making(bend))] = true);
            (is_used.iter().filter(|used| **used).count() < enough).then_some(kind)
        };
        (0..self.panels.len()).map(kind).collect()
    }

    /// The simplest kind within `strict` of a panel, or where there is none, the nearest.
    fn kind(&self, panel: usize, strict: f64) -> Option<Bend> {
        let fits = || KINDS.into_iter().filter_map(|bend| self.fit(panel, bend));
        let within = fits().find(|fit| fit.max_distance <= strict);
        let nearest = || fits().min_by(|a, b| a.max_distance.total_cmp(&b.max_distance));
        within.or_else(nearest).map(|fit| fit.shape.bend)
    }

    /// The kind of the surface that a panel lies on, where it is made in the same way as a given kind; else that.
    fn exact_kind(&self, panel: usize, kind: Option<Bend>) -> Option<Bend> {
        match (kind, self.exact[panel]) {
            (Some(kind), Some(exact)) if making(kind) == making(exact) && self.fit(panel, exact).is_some() => {
                Some(exact)
            }
            (kind, _) => kind,
        }
    }

    /// The kinds with that of the surface that a panel lies on, where it is made in the same way.
    fn made_exact(&self, kinds: &[Option<Bend>]) -> Vec<Option<Bend>> {
        kinds.iter().enumerate().map(|(panel, kind)| self.exact_kind(panel, *kind)).collect()
    }

    /// The one mould that makes all panels, if these lie on surfaces of one kind: of that kind, or of one that an earlier rung has.
    ///
    /// The smaller the panels of a net, the more kinds are within the tolerance of each, and to find the nearest of them takes longer than
    /// the surface on which a panel lies. So few panels are asked first, which refute other kinds as a rule.
    fn one_mould(&self) -> Option<Moulds> {
        let own = (*self.exact.first()?)?;
        if self.exact.iter().any(|exact| *exact != Some(own)) {
            return None;
        }
        let all = 0..self.panels.len();
        let of_kind = |kind: Bend| self.moulds(&vec![Some(kind); all.len()], 2);
        for strict in ladder(self.panels, self.tolerance) {
            for exact in [true, false] {
                match self.only_kind(strict, exact, own) {
                    // Later rungs have no simpler kinds.
                    Some(kind) if kind == own => {
                        let is_near = all.clone().all(|panel| self.fit(panel, own).is_some());
                        return if is_near { of_kind(own) } else { None };
                    }
                    Some(kind) => {
                        if let Some(found) = of_kind(kind) {
                            return Some(found);
                        }
                    }
                    None => {}
                }
            }
        }
        None
    }

    /// The kind of all panels at a rung, or `own` where it is that of a few of them; `None` if they have several kinds, or if some need
    /// several moulds.
    fn only_kind(&self, strict: f64, exact: bool, own: Bend) -> Option<Bend> {
        let kind = |panel: usize| {
            let simplest = self.kind(panel, strict);
            if exact { self.exact_kind(panel, simplest) } else { simplest }
        };
        let only = kind(0)?;
        let count = self.panels.len();
        let few: Vec<usize> = (0..count).step_by(count.div_ceil(FEW)).collect();
        if few.iter().any(|panel| kind(*panel) != Some(only)) {
            return None;
        }
        if only == own {
            return Some(own);
        }
        if matches!(only, Bend::Cylinder | Bend::Sphere) {
            let jobs: Vec<Job<'_>> = few.into_iter().filter_map(|panel| self.job(panel, only)).collect();
            if self.apart(&jobs, 2) > 1 {
                return None;
            }
        }
        (0..count).all(|panel| kind(panel) == Some(only)).then_some(only)
    }

    /// A panel on the mould of a kind that is its own.
    fn job(&self, panel: usize, bend: Bend) -> Option<Job<'_>> {
        let fit = self.fit(panel, bend)?;
        Some(Job { panel, fit, own: MouldShape::of(fit, self.panels[panel].size()) })
    }

    /// The moulds for panels of given kinds; `None` unless they are fewer than so many, which is seen before all are made.
    fn moulds(&self, kinds: &[Option<Bend>], limit: usize) -> Option<Moulds> {
        let free: Vec<usize> = (0..kinds.len()).filter(|panel| kinds[*panel].is_none()).collect();
        if fewest(kinds) >= limit {
            return None;
        }
        let limit = limit - free.len();
        let mut moulds = Vec::new();
        for bend in KINDS {
            let panels = (0..self.panels.len()).filter(|panel| kinds[*panel] == Some(bend));
            let jobs = panels.filter_map(|panel| self.job(panel, bend));
            match bend {
                Bend::Plane | Bend::Cone | Bend::Torus => self.led(jobs.collect(), &mut moulds, limit),
                Bend::Cylinder | Bend::Sphere => {
                    let jobs: Vec<Job<'_>> = jobs.collect();
                    if moulds.len() + self.apart(&jobs, limit - moulds.len()) >= limit {
                        return None;
                    }
                    self.met(jobs.into_iter().map(|job| self.range(job)).collect(), &mut moulds, limit);
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
        let enough = points.rounding_of_place();
        let (placed, largest) = points.place(job.fit, shape, [enough, self.tolerance]);
        if largest > self.tolerance {
            return None;
        }
        let near = points.near_surface(&points.measured(placed))?;
        (near.max_distance <= self.tolerance).then_some(MouldMember { panel, near })
    }

    /// Groups whose first panel in the order of radii leads, up to a number of moulds.
    fn led(&self, jobs: Vec<Job<'_>>, moulds: &mut Vec<Mould>, limit: usize) {
        let mut jobs: Vec<(Job<'_>, Bulge)> = jobs.into_iter().map(|job| (job, self.bulge(&job))).collect();
        jobs.sort_by(|(a, _), (b, _)| compare(&a.own.order(), &b.own.order()).then(a.panel.cmp(&b.panel)));
        let least = jobs.iter().map(|(_, bulge)| bulge.width).fold(f64::INFINITY, f64::min);
        let mut taken = vec![false; jobs.len()];
        for first in 0..jobs.len() {
            // The leader is gone in any case, so that there is an end.
            if std::mem::replace(&mut taken[first], true) {
                continue;
            }
            if moulds.len() >= limit {
                return;
            }
            let (leader, bulge) = jobs[first];
            let mut mould = Mould { shape: leader.own, members: Vec::new() };
            mould.members.extend(self.member(&leader, &leader.own));
            for (place, (job, own)) in jobs.iter().enumerate().skip(first + 1) {
                let apart = (own.bend - bulge.bend).abs();
                // They are in the order of what is compared: no later one is nearer.
                if apart * least > FAR * self.tolerance {
                    break;
                }
                if taken[place] || apart * own.width > FAR * self.tolerance {
                    continue;
                }
                if let Some(member) = self.member(job, &leader.own) {
                    mould.members.push(member);
                    taken[place] = true;
                }
            }
            moulds.push(mould);
        }
    }

    /// What a panel that leads, or is led, is compared by first.
    fn bulge(&self, job: &Job<'_>) -> Bulge {
        let [p, q, r, _] = self.panels[job.panel].corners();
        let width = p.distance(q).min(p.distance(r));
        match job.own {
            // Bulges of an eighth of the curvature times the square of the width, off by a tolerance at both ends and in the middle.
            MouldShape::Torus { minor_radius, .. } => Bulge { bend: 1.0 / minor_radius, width: width * width },
            // The curvature k across the rulings changes along them by k² tan α, hence the bulge by that times the width.
            MouldShape::Cone { half_angle } => {
                let shape = &job.fit.shape;
                let bend = shape.along * shape.tilt.cos() / self.panels[job.panel].size();
                Bulge { bend: half_angle.tan(), width: CONE * bend * bend * width.powi(3) }
            }
            _ => Bulge { bend: 0.0, width: 0.0 },
        }
    }

    /// How many of the ranges of curvature of panels are apart, at least, up to a number: so many moulds they need. The ranges of few panels are
    /// found for that, while all take long.
    fn apart(&self, jobs: &[Job<'_>], most: usize) -> usize {
        let curvature = |job: &Job<'_>| job.fit.shape.across.abs() / self.panels[job.panel].size();
        let mut order: Vec<(f64, &Job<'_>)> = jobs.iter().map(|job| (curvature(job), job)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.panel.cmp(&b.1.panel)));
        let Some(first) = order.first() else { return 0 };
        // Where every panel may need a mould all ranges are asked for anyway.
        if most > jobs.len() {
            return 1;
        }
        let (mut count, mut high) = (1, self.range(*first.1).high);
        while count < most {
            // Ranges begin below the curvatures of the panels, in about their order.
            let mut from = order.partition_point(|(own, _)| *own <= high);
            let mut to = order.len() - 1;
            if from > to || self.range(*order[to].1).low <= high {
                break;
            }
            while from < to {
                let middle = (from + to) / 2;
                if self.range(*order[middle].1).low > high { to = middle } else { from = middle + 1 }
            }
            high = self.range(*order[to].1).high;
            count += 1;
        }
        count
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
            curvature > 0.0 && points.place(job.fit, &shape, [enough, enough]).1 <= enough
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::{Point3, Vec3};
    use crate::surface::DupinCyclide;

    /// The panels of a ring torus.
    fn ring(a: f64, mu: f64, segments: [usize; 2]) -> Vec<CyclidePatch> {
        DupinCyclide::new(a, 0.0, mu).unwrap().nets(segments).unwrap()[0].patches().collect()
    }

    /// One torus makes all panels, each of which is near a sphere too: what spheres are good for them takes long, and is not asked for of all.
    #[test]
    fn a_kind_that_needs_more_moulds_is_left_before_all_its_panels_are_looked_at() {
        let panels = ring(3.0, 1.0, [24, 24]);
        let workshop = Workshop::new(&panels, 0.008);
        assert!((0..panels.len()).all(|panel| workshop.fit(panel, Bend::Sphere).is_some()), "spheres");
        assert!(workshop.moulds(&vec![Some(Bend::Sphere); panels.len()], 2).is_none());
        let asked = workshop.ranges.borrow().len();
        assert!(asked > 0 && asked * 4 < panels.len(), "{asked} of {}", panels.len());
        let moulds = workshop.fewest_moulds().unwrap();
        assert_eq!((moulds.count(), moulds.moulds[0].members.len()), (1, panels.len()));
    }

    /// All panels lie on one torus: at any tolerance its mould, or a simpler one that makes all of them, is found by few panels.
    #[test]
    fn one_mould_is_found_without_other_kinds() {
        let panels = ring(3.0, 1.0, [24, 24]);
        for tolerance in [2.0, 0.03, 0.008, 1e-3, 1e-9] {
            let workshop = Workshop::new(&panels, tolerance);
            let found = workshop.one_mould();
            let looked = |bend: Bend| workshop.fits.iter().filter(|fits| fits[bend as usize].get().is_some()).count();
            let kinds = [Bend::Cylinder, Bend::Cone, Bend::Sphere].map(looked);
            assert!(kinds.into_iter().all(|count| count <= FEW), "{tolerance}: {kinds:?}");
            assert_eq!(found, Workshop::new(&panels, tolerance).fewest_moulds(), "{tolerance}");
        }
        let two = [panels, ring(9.0, 1.0, [24, 24])].concat();
        assert_eq!(Workshop::new(&two, 1e-9).one_mould(), None);
    }

    /// What is left early, and kinds that are not looked at, change nothing: the moulds are the fewest of all rungs, the first of these.
    #[test]
    fn the_fewest_moulds_of_all_rungs_are_taken() {
        let panels = [ring(3.0, 1.0, [6, 4]), ring(9.0, 1.0, [20, 8])[..24].to_vec()].concat();
        for tolerance in [2.0, 0.3, 0.05, 1e-3, 1e-9] {
            let workshop = Workshop::new(&panels, tolerance);
            let moulds = workshop.fewest_moulds();
            let tori = workshop.fits.iter().filter(|fits| fits[Bend::Torus as usize].get().is_some()).count();
            if tolerance > 1.0 {
                assert_eq!(tori, 1, "of flat sheets one panel shows that no other kind needs fewer moulds");
            }
            let rungs = ladder(&panels, tolerance).into_iter().filter_map(|strict| workshop.kinds(strict, usize::MAX));
            let rungs = rungs.flat_map(|kinds| [workshop.made_exact(&kinds), kinds]);
            let all = rungs.filter_map(|kinds| workshop.moulds(&kinds, usize::MAX));
            // Of equal ones the first.
            assert_eq!(moulds, all.min_by_key(Moulds::count), "{tolerance}");
        }
    }

    /// Radii of spheres that no sphere is between are counted, up to what is asked for.
    #[test]
    fn ranges_that_are_apart_count() {
        let sphere = |r: f64| {
            let corners = [Point3::new(r, 0.0, 0.0), Point3::new(0.0, r, 0.0)];
            let top = Point3::new(0.0, 0.0, r);
            CyclidePatch::from_corners_and_frame([corners[0], corners[1], top, top], Vec3::Y, Vec3::Z).unwrap()
        };
        let panels: Vec<CyclidePatch> = [1.0, 1.001, 2.0, 2.001, 3.0, 5.0].map(sphere).to_vec();
        let workshop = Workshop::new(&panels, 1e-2);
        let job = |panel: usize| {
            let fit = workshop.fit(panel, Bend::Sphere).unwrap();
            Job { panel, fit, own: MouldShape::of(fit, panels[panel].size()) }
        };
        let jobs: Vec<Job<'_>> = (0..panels.len()).map(job).collect();
        assert_eq!(workshop.apart(&jobs, 6), 4);
        assert_eq!(workshop.apart(&jobs, 3), 3);
    }
}
