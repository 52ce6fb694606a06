//! The plane, cylinder, cone, sphere and torus nearest to a panel.

use super::bent_plane::{Bend, BentPlane, PLACE};
use super::least_maximum::{LEVEL, ROUNDING};
use super::mould_shape::MouldShape;
use super::panel_fit::PanelFit;
use super::peaks::peaks;
use super::unit_patch::UnitPatch;
use crate::base::frame::Frame;
use crate::base::vector::Vec3;
use crate::curve::Circle;
use crate::error::{Result, check_tolerance};
use crate::surface::{CyclidePatch, ParamSurface as _, PatchKind};

/// Points of a fit, along each direction.
const POINTS: u32 = 7;
/// Rounds in which places that are farther than the points are added to them.
const ROUNDS: usize = 5;
/// Radii above this inverse, in units of the size of the panel, are no radii: the bulge of the panel is a ten millionth of its size.
/// Angles of cones below this are those of cylinders.
const FLAT: f64 = 1e-6;

/// A panel lies on a surface within this part of its size, and so many roundings of its place.
pub(super) const EXACT: f64 = 1e-11;
const ROUNDINGS: f64 = 16.0;

/// A simple surface near a panel, and how far the panel is from it.
///
/// ```
/// let patch = cyclide::surface::DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// let near = cyclide::panel::NearSurface::simplest(&patch, 10.0)?.unwrap();
/// assert!(matches!(near.surface, cyclide::surface::PatchKind::Plane { .. }) && near.max_distance > 0.1);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearSurface {
    /// The surface with its placement; never [`PatchKind::Cyclide`].
    pub surface: PatchKind,
    /// Largest distance of the panel from it: measured at a grid of 13 by 13 places, from the largest of which a search goes uphill
    /// until the step is a ten millionth of the panel. No bound is proved.
    pub max_distance: f64,
    /// The parameters of the farthest place.
    pub place: (f64, f64),
}

/// The simple surfaces nearest to a panel: those of the least largest distance, to about half a percent of it. Panels that lie on one
/// are found to lie on it, to rounding.
///
/// The fits start with the surfaces that touch the panel in its middle with its curvatures (tori and cones also with the bend of its
/// parameter lines, so that a panel of a torus starts with that torus), of both families of lines, go on to least squares, and weigh the distances until the largest
/// is least (`docs/math/panels.md#nearest-surfaces`). They end in the valley in which they start: of a panel that is bent by far more than a
/// radian, or of cones whose tip is at the panel, another surface may be nearer. Of a surface that would need a radius of more than a million times the size of the
/// panel there is none: it is one of the simpler ones. All is relative to the panel: moved, turned or scaled, it has the same surfaces.
///
/// ```
/// use cyclide::{panel::NearestSurfaces, surface::{DupinCyclide, PatchKind}};
/// let patch = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// let near = NearestSurfaces::new(&patch);
/// let torus = near.torus.unwrap();
/// assert!(torus.max_distance < 1e-14 && near.plane.max_distance > 0.1);
/// assert!(matches!(near.simplest_within(1e-9).unwrap().surface, PatchKind::Torus { .. }));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearestSurfaces {
    /// The plane.
    pub plane: NearSurface,
    /// The cylinder of revolution.
    pub cylinder: Option<NearSurface>,
    /// The cone of revolution.
    pub cone: Option<NearSurface>,
    /// The sphere.
    pub sphere: Option<NearSurface>,
    /// The torus, also one that crosses itself.
    pub torus: Option<NearSurface>,
}

impl NearestSurfaces {
    /// The surfaces nearest to a patch.
    #[must_use]
    pub fn new(patch: &CyclidePatch) -> Self {
        let panel = PanelPoints::new(patch);
        let near = |bend: Bend| panel.near_surface(&panel.fit(bend, f64::INFINITY)?);
        let plane = near(Bend::Plane).unwrap_or_else(|| panel.corner_plane());
        let [cylinder, cone, sphere, torus] = [Bend::Cylinder, Bend::Cone, Bend::Sphere, Bend::Torus].map(near);
        Self { plane, cylinder, cone, sphere, torus }
    }

    /// The simplest that is within a distance, none if all are farther: a plane before a cylinder before a cone, which are bent from a
    /// flat sheet, before a sphere before a torus, which are not.
    #[must_use]
    pub fn simplest_within(&self, tolerance: f64) -> Option<&NearSurface> {
        let all =
            [Some(&self.plane), self.cylinder.as_ref(), self.cone.as_ref(), self.sphere.as_ref(), self.torus.as_ref()];
        all.into_iter().flatten().find(|near| near.max_distance <= tolerance)
    }
}

impl NearSurface {
    /// As [`NearestSurfaces::simplest_within`], without those that are not needed.
    ///
    /// # Errors
    /// `tolerance-not-positive`.
    pub fn simplest(patch: &CyclidePatch, tolerance: f64) -> Result<Option<Self>> {
        check_tolerance(tolerance)?;
        let panel = PanelPoints::new(patch);
        Ok(panel.simplest(tolerance).and_then(|fit| panel.near_surface(&fit)))
    }
}

/// A panel with the points by which surfaces are fitted.
pub(super) struct PanelPoints {
    pub(super) unit: UnitPatch,
    points: Vec<Vec3>,
    middle: Vec3,
    /// Directions of s and t and the normal in the middle, and the curvatures.
    frame: [Vec3; 3],
    curvatures: [f64; 2],
    /// True if the normal `f_s × f_t` is the third direction.
    upright: bool,
}

impl PanelPoints {
    pub(super) fn new(patch: &CyclidePatch) -> Self {
        let unit = UnitPatch::new(patch);
        let points = unit.grid(POINTS).map(|place| unit.at(place)).collect();
        let frame = unit.patch.moving_frame(0.5, 0.5);
        let curvatures = [unit.patch.k1(0.5), unit.patch.k2(0.5)].map(|k| if k.is_finite() { k } else { 0.0 });
        let upright = unit.patch.normal(0.5, 0.5).is_none_or(|n| n.dot(frame[2]) > 0.0);
        Self { middle: unit.at((0.5, 0.5)), points, frame, curvatures, upright, unit }
    }

    /// The simplest surface within a tolerance.
    pub(super) fn simplest(&self, tolerance: f64) -> Option<PanelFit> {
        let limit = tolerance / self.unit.size;
        let all = [Bend::Plane, Bend::Cylinder, Bend::Cone, Bend::Sphere, Bend::Torus].into_iter();
        all.filter_map(|bend| self.fit(bend, limit)).find(|fit| fit.max_distance <= tolerance)
    }

    /// The distance within which the panel lies on a surface: what rounding of its corners does.
    pub(super) fn rounding(&self) -> f64 {
        EXACT * self.unit.size + self.rounding_of_place()
    }

    /// What of it is due to the place of the panel: the smaller panels are and the farther from the origin, the more of their size.
    pub(super) fn rounding_of_place(&self) -> f64 {
        let far = self.unit.origin.to_array().into_iter().fold(0.0, |far: f64, x| far.max(x.abs()));
        ROUNDINGS * f64::EPSILON * far
    }

    /// The simplest family that has a surface on which the panel lies: fits start with it.
    pub(super) fn exact(&self) -> Option<Bend> {
        let limit = self.rounding() / self.unit.size;
        let is_on = |shape: &BentPlane| self.points.iter().copied().map(shape.distances()).all(|d| d.abs() <= limit);
        let mut all = [Bend::Plane, Bend::Cylinder, Bend::Cone, Bend::Sphere, Bend::Torus].into_iter();
        all.find(|bend| self.starts(*bend).map(BentPlane::tidy).any(|shape| shape.has_radii() && is_on(&shape)))
    }

    /// The nearest surface of a family, if there is one with radii; anything or nothing if it is farther than `limit`.
    pub(super) fn fit(&self, bend: Bend, limit: f64) -> Option<PanelFit> {
        let mut best: Option<(BentPlane, f64)> = None;
        for start in self.starts(bend) {
            // Another start is not better than what is below its mean.
            let limit = best.map_or(limit, |best| best.1.min(limit));
            let found = start.least_maximum(&self.points, bend.free(), [0.0, limit]);
            if best.is_none_or(|best| found.1 < best.1) {
                best = Some(found);
            }
        }
        // Between the points it is no nearer.
        let (shape, largest) = best.filter(|best| best.1 <= limit + ROUNDING)?;
        let sharp = self.sharpened(shape, largest, limit);
        sharp.shape.has_radii().then_some(sharp)
    }

    /// A surface that is nearest to the points, made nearest to the whole panel: places farther than these are added to them.
    fn sharpened(&self, shape: BentPlane, largest: f64, limit: f64) -> PanelFit {
        let (mut points, mut largest) = (self.points.clone(), largest);
        let mut now = self.measured(shape);
        let mut best = now;
        for _ in 0..ROUNDS {
            let distance = now.max_distance / self.unit.size;
            if distance <= ROUNDING || distance <= LEVEL * largest || largest > limit {
                break;
            }
            let distance = now.shape.distances();
            let far = peaks(&self.unit, |place| distance(self.unit.at(place)));
            points.extend(far.into_iter().map(|(_, place)| self.unit.at(place)));
            let (shape, at_points) = now.shape.leveled(&points, shape.bend.free(), [0.0, f64::INFINITY]);
            (now, largest) = (self.measured(shape), at_points);
            if now.max_distance < best.max_distance {
                best = now;
            }
        }
        best
    }

    /// The given mould near a surface fitted to this panel, as near to the panel as can be: largest distance at the points, and all.
    pub(super) fn place(&self, fit: &PanelFit, mould: &MouldShape, [enough, limit]: [f64; 2]) -> (BentPlane, f64) {
        let start = mould.near(&fit.shape, self.unit.size);
        let ends = [enough / self.unit.size, limit / self.unit.size];
        let (shape, largest) = start.placed(&self.points, PLACE, ends);
        (shape, largest * self.unit.size)
    }

    pub(super) fn measured(&self, shape: BentPlane) -> PanelFit {
        let shape = shape.tidy();
        let distance = shape.distances();
        let far = peaks(&self.unit, |place| distance(self.unit.at(place)));
        let (distance, place) = far.first().copied().unwrap_or((0.0, (0.5, 0.5)));
        PanelFit { shape, max_distance: distance * self.unit.size, place: self.unit.place(place) }
    }

    /// The surfaces that touch the panel in its middle.
    fn starts(&self, bend: Bend) -> impl Iterator<Item = BentPlane> + use<'_> {
        let ([e1, e2, n], [k1, k2]) = (self.frame, self.curvatures);
        let along_s = [[e1, e2, n], [-e2, e1, n]];
        let across = [k2, k1];
        let circles = [self.unit.patch.s_circle(0.5), self.unit.patch.t_circle(0.5)];
        let count = if matches!(bend, Bend::Plane | Bend::Sphere) { 1 } else { 2 };
        (0..count).map(move |k| {
            let axes = along_s[k];
            let (along, tilt) = if matches!(bend, Bend::Cone | Bend::Torus) {
                bend_of(circles[k].as_ref(), self.middle, axes)
            } else {
                (0.0, 0.0)
            };
            let across = match bend {
                Bend::Plane | Bend::Cone => 0.0,
                Bend::Sphere => 0.5 * (k1 + k2),
                Bend::Cylinder | Bend::Torus => across[k],
            };
            BentPlane { bend, origin: self.middle, axes, across, along, tilt }
        })
    }

    /// The surface in the place of the given patch.
    pub(super) fn near_surface(&self, fit: &PanelFit) -> Option<NearSurface> {
        let surface = self.kind(&fit.shape)?;
        Some(NearSurface { surface, max_distance: fit.max_distance, place: fit.place })
    }

    /// Its frames are those of [`PatchKind`]: first axes point away from the panel.
    fn kind(&self, shape: &BentPlane) -> Option<PatchKind> {
        let BentPlane { origin, axes: [x, _, z], across, .. } = *shape;
        let size = self.unit.size;
        // A surface may have turned over in the fit, which the normal of the panel has not.
        let along_normal = z.dot(self.frame[2]) > 0.0;
        let normal = if along_normal == self.upright { z } else { -z };
        let frame = |at: Vec3, axis: Vec3, toward: Vec3| Frame::from_normal(self.unit.to_world(at), axis, toward).ok();
        Some(match shape.bend {
            Bend::Plane => PatchKind::Plane { frame: frame(origin, normal, x)? },
            Bend::Sphere => {
                let center = origin + z * (1.0 / across);
                let toward = center - origin;
                let (radius, outward) = (size / across.abs(), normal.dot(toward) < 0.0);
                PatchKind::Sphere { frame: frame(center, x, toward)?, radius, outward }
            }
            Bend::Cylinder => {
                let center = origin + z * (1.0 / across);
                let toward = center - origin;
                let (radius, outward) = (size / across.abs(), normal.dot(toward) < 0.0);
                PatchKind::Cylinder { frame: frame(center, x, toward)?, radius, outward }
            }
            Bend::Cone => {
                let [w, axis, y] = shape.meridian_axes();
                let toward = w * (1.0 / shape.along);
                let (out, rise) = (-y.dot(toward), y.dot(axis));
                let away = if (out > 0.0) == (rise > 0.0) { axis } else { -axis };
                let half_angle = shape.half_angle();
                let (radius, outward) = (size / shape.along.abs(), normal.dot(toward) < 0.0);
                PatchKind::Cone { frame: frame(origin + toward, away, toward)?, radius, half_angle, outward }
            }
            Bend::Torus => {
                let [w, axis, _] = shape.meridian_axes();
                let (tube, on_axis) = (origin + z * (1.0 / across), origin + w * (1.0 / shape.along));
                let center = on_axis + axis * axis.dot(tube - on_axis);
                let [major, minor] = shape.torus_radii();
                let (major_radius, minor_radius) = (major * size, minor * size);
                let outward = normal.dot(tube - origin) < 0.0;
                PatchKind::Torus { frame: frame(center, axis, on_axis - origin)?, major_radius, minor_radius, outward }
            }
        })
    }

    /// The plane through the middle, where nothing else is known.
    fn corner_plane(&self) -> NearSurface {
        let frame = Frame::of_axes(self.unit.to_world(self.middle), self.frame);
        let flat =
            BentPlane { bend: Bend::Plane, origin: self.middle, axes: self.frame, across: 0.0, along: 0.0, tilt: 0.0 };
        let fit = self.measured(flat);
        NearSurface { surface: PatchKind::Plane { frame }, max_distance: fit.max_distance, place: fit.place }
    }
}

impl BentPlane {
    /// The same surface with a tilt of at most a right angle, so that its parallel circle bends with the normal.
    fn tidy(self) -> Self {
        let (sin, cos) = self.tilt.sin_cos();
        if cos < 0.0 {
            Self { along: -self.along, tilt: (-sin).atan2(-cos), ..self }
        } else {
            Self { tilt: sin.atan2(cos), ..self }
        }
    }

    /// True if it is of its family and of none that is simpler, as far as a panel of size 1 can tell.
    fn has_radii(&self) -> bool {
        let bent = |c: f64| c.is_finite() && c.abs() > FLAT;
        match self.bend {
            Bend::Plane => true,
            Bend::Sphere | Bend::Cylinder => bent(self.across),
            Bend::Cone => {
                let angle = self.half_angle();
                bent(self.along) && angle > FLAT && angle < std::f64::consts::FRAC_PI_2 - FLAT
            }
            Bend::Torus => bent(self.across) && bent(self.along),
        }
    }

    /// The normal of the parallel circle through the origin that points to the axis or away from it, the direction of the axis, and that
    /// of the meridian.
    fn meridian_axes(&self) -> [Vec3; 3] {
        let ([_, y, z], (sin, cos)) = (self.axes, self.tilt.sin_cos());
        [z * cos - y * sin, z * sin + y * cos, y]
    }

    /// Angle between axis and ruling.
    pub(super) fn half_angle(&self) -> f64 {
        let (sin, cos) = self.tilt.sin_cos();
        sin.abs().atan2(cos.abs())
    }

    /// How far the axis is from the middle of the tube, with a sign, and the radius of the tube.
    pub(super) fn signed_torus_radii(&self) -> [f64; 2] {
        [1.0 / self.along - self.tilt.cos() / self.across, 1.0 / self.across.abs()]
    }

    fn torus_radii(&self) -> [f64; 2] {
        self.signed_torus_radii().map(f64::abs)
    }
}

/// The curvature of a parallel circle through a point and the angle by which its plane is tilted against the normal.
fn bend_of(circle: Option<&Circle>, at: Vec3, [_, y, z]: [Vec3; 3]) -> (f64, f64) {
    let Some(circle) = circle else { return (0.0, 0.0) };
    let way = circle.center().to_vec() - at;
    let (up, side) = (way.dot(z), way.dot(y));
    let sign = 1.0_f64.copysign(up);
    (sign / circle.radius(), (-side * sign).atan2(up * sign))
}
