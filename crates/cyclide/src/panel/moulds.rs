//! Panels that one mould makes.

use super::bent_plane::Bend;
use super::nearest::{NearSurface, PanelFit, PanelPoints};
use super::placed_mould::MouldShape;
use crate::error::{Result, check_tolerance};
use crate::surface::CyclidePatch;

/// Trials by which the range of curvatures of a panel is found, to each side.
const TRIALS: usize = 10;
/// What is within this part of the tolerance at the points of a fit is within all of it between them too, as a rule.
const INSIDE: f64 = 0.98;

/// A panel of a mould.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MouldMember {
    /// Its number among the panels given.
    pub panel: usize,
    /// The mould, placed as near to it as can be, with the largest distance of the panel from it.
    pub near: NearSurface,
}

/// A mould with the panels that it makes.
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
/// Cylinders and spheres have one radius: of the ranges of curvatures that are good for each panel, as few are taken as meet all ranges, which is
/// the least number (ranges are found by fits and are as good as these). Cones and tori are led: the first panel in the order of radii takes all that its own mould makes. So with a
/// larger tolerance a kind with the same panels has no more moulds of cylinders and spheres; but kinds change: a panel that becomes simpler may
/// need a mould of that kind, when the one it had is still needed by others.
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
        let mut moulds = Vec::new();
        for bend in [Bend::Plane, Bend::Cylinder, Bend::Cone, Bend::Sphere, Bend::Torus] {
            let of_kind: Vec<usize> = workshop.of_kind(bend);
            match bend {
                Bend::Plane | Bend::Cone | Bend::Torus => workshop.led(of_kind, &mut moulds),
                Bend::Cylinder | Bend::Sphere => workshop.met(of_kind, &mut moulds),
            }
        }
        let free = (0..panels.len()).filter(|k| workshop.fits[*k].is_none()).collect();
        for mould in &mut moulds {
            mould.members.sort_by_key(|member| member.panel);
        }
        moulds.sort_by(|a, b| compare(&a.shape.order(), &b.shape.order()));
        Ok(Self { moulds, free })
    }

    /// How many moulds there are, with one for each free panel.
    #[must_use]
    pub fn count(&self) -> usize {
        self.moulds.len() + self.free.len()
    }
}

fn compare(a: &[f64], b: &[f64]) -> std::cmp::Ordering {
    let mut pairs = a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
    pairs.find(|order| order.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
}

/// The panels with the simplest surfaces within the tolerance.
struct Workshop<'a> {
    panels: &'a [CyclidePatch],
    fits: Vec<Option<PanelFit>>,
    tolerance: f64,
}

/// The curvatures that are good for a panel.
struct Range {
    panel: usize,
    own: f64,
    low: f64,
    high: f64,
}

impl<'a> Workshop<'a> {
    fn new(panels: &'a [CyclidePatch], tolerance: f64) -> Self {
        let fits = panels.iter().map(|panel| PanelPoints::new(panel).simplest(tolerance)).collect();
        Self { panels, fits, tolerance }
    }

    /// The panels of a kind.
    fn of_kind(&self, bend: Bend) -> Vec<usize> {
        let is_of = |fit: &Option<PanelFit>| fit.is_some_and(|fit| fit.shape.bend == bend);
        (0..self.panels.len()).filter(|k| is_of(&self.fits[*k])).collect()
    }

    fn own(&self, panel: usize) -> Option<MouldShape> {
        Some(MouldShape::of(self.fits[panel].as_ref()?, self.panels[panel].size()))
    }

    /// A panel on a mould, if it is within the tolerance of it.
    fn member(&self, panel: usize, shape: &MouldShape) -> Option<MouldMember> {
        let (points, fit) = (PanelPoints::new(&self.panels[panel]), self.fits[panel].as_ref()?);
        let (placed, largest) = points.place(fit, shape, [0.0, self.tolerance]);
        if largest > self.tolerance {
            return None;
        }
        let placed = points.measured(placed);
        // On its own mould a panel is as it was fitted.
        let best =
            if self.own(panel) == Some(*shape) && fit.max_distance <= placed.max_distance { *fit } else { placed };
        let near = points.near_surface(&best)?;
        (near.max_distance <= self.tolerance).then_some(MouldMember { panel, near })
    }

    /// A panel on its own mould.
    fn alone(&self, panel: usize) -> Option<Mould> {
        let (points, fit) = (PanelPoints::new(&self.panels[panel]), self.fits[panel].as_ref()?);
        let near = points.near_surface(fit)?;
        Some(Mould { shape: self.own(panel)?, members: vec![MouldMember { panel, near }] })
    }

    /// Groups whose first panel in the order of radii leads.
    fn led(&self, panels: Vec<usize>, moulds: &mut Vec<Mould>) {
        let mut waiting: Vec<(usize, MouldShape)> =
            panels.into_iter().filter_map(|panel| Some((panel, self.own(panel)?))).collect();
        waiting.sort_by(|a, b| compare(&a.1.order(), &b.1.order()).then(a.0.cmp(&b.0)));
        while let Some((leader, shape)) = waiting.first().copied() {
            let Some(mut mould) = self.alone(leader) else { return };
            let mut left = Vec::new();
            for other in waiting.drain(..).skip(1) {
                match self.member(other.0, &shape) {
                    Some(member) => mould.members.push(member),
                    None => left.push(other),
                }
            }
            moulds.push(mould);
            waiting = left;
        }
    }

    /// Groups of panels whose ranges of curvature have one in common, as few as can be.
    fn met(&self, panels: Vec<usize>, moulds: &mut Vec<Mould>) {
        let mut waiting: Vec<Range> = panels.into_iter().filter_map(|panel| self.range(panel)).collect();
        waiting.sort_by(|a, b| compare(&[a.high, a.low, a.own], &[b.high, b.low, b.own]).then(a.panel.cmp(&b.panel)));
        while let Some(first) = waiting.first() {
            let (point, leader) = (first.high, first.panel);
            let (group, mut left): (Vec<Range>, Vec<Range>) = waiting.into_iter().partition(|range| range.low <= point);
            let low = group.iter().map(|range| range.low).fold(0.0, f64::max);
            let mut own: Vec<f64> = group.iter().map(|range| range.own).collect();
            own.sort_by(f64::total_cmp);
            let middle = own[own.len() / 2].max(low).min(point);
            let radius = 1.0 / middle;
            let is_sphere = self.fits[leader].is_some_and(|fit| fit.shape.bend == Bend::Sphere);
            let shape = if is_sphere { MouldShape::Sphere { radius } } else { MouldShape::Cylinder { radius } };
            let mut mould = Mould { shape, members: Vec::new() };
            for range in group {
                match self.member(range.panel, &shape) {
                    Some(member) => mould.members.push(member),
                    None => left.push(range),
                }
            }
            // Ranges are good to the points of the fits only: one that fails by that is on its own.
            if mould.members.is_empty() {
                left.retain(|range| range.panel != leader);
                mould.members.clear();
                moulds.extend(self.alone(leader));
            } else {
                moulds.push(mould);
            }
            left.sort_by(|a, b| compare(&[a.high, a.low, a.own], &[b.high, b.low, b.own]).then(a.panel.cmp(&b.panel)));
            waiting = left;
        }
    }

    /// The curvatures that are good for a panel of a cylinder or sphere.
    fn range(&self, panel: usize) -> Option<Range> {
        let (points, fit) = (PanelPoints::new(&self.panels[panel]), self.fits[panel].as_ref()?);
        let size = points.unit.size;
        let own = fit.shape.across.abs() / size;
        let sphere = fit.shape.bend == Bend::Sphere;
        let is_good = |curvature: f64| {
            let radius = 1.0 / curvature;
            let shape = if sphere { MouldShape::Sphere { radius } } else { MouldShape::Cylinder { radius } };
            let enough = INSIDE * self.tolerance;
            curvature > 0.0 && points.place(fit, &shape, [enough, self.tolerance]).1 <= enough
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
        Some(Range { panel, own, low: reach(-1.0), high: reach(1.0) })
    }
}
