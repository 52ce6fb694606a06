//! Which patches are planes, spheres, cylinders, cones and tori.

use super::CyclidePatch;
use super::circles::LineCircle;
use super::polar::proportion;
use crate::base::frame::Frame;
use crate::base::vector::Point3;
use crate::surface::ParamSurface as _;

/// Curvatures, times the size of the patch, that differ by this are the same; then the surfaces are apart by about this
/// part of the size.
const LIMIT: f64 = 1e-10;

/// Rounding of points and radii, relative to coordinates and radii.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// What surface a patch lies on, with its placement. Frames are right-handed; angles about the third axis count from
/// the first, which points away from the middle of the patch, so that no seam at angle 0 runs through it.
///
/// ```
/// use cyclide::surface::{DupinCyclide, PatchKind};
/// let patch = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?[0].patch(0, 0);
/// assert!(matches!(patch.recognize(), PatchKind::Torus { .. }));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PatchKind {
    /// A plane through the origin of the frame; the third axis is the normal of the patch.
    Plane {
        /// Origin at the first corner, first axis along the s-direction there.
        frame: Frame,
    },
    /// A sphere.
    Sphere {
        /// Origin at the center; the third axis is far from the patch.
        frame: Frame,
        /// Radius.
        radius: f64,
        /// True if the normal `f_s × f_t` points away from the center.
        outward: bool,
    },
    /// A cylinder.
    Cylinder {
        /// Origin and third axis on the axis.
        frame: Frame,
        /// Radius.
        radius: f64,
        /// True if the normal `f_s × f_t` points away from the axis.
        outward: bool,
    },
    /// A cone.
    Cone {
        /// Origin on the axis, third axis along it, away from the apex.
        frame: Frame,
        /// Radius in the plane of the first two axes, positive; the apex is at `-radius/tan(half_angle)` on the axis.
        radius: f64,
        /// Angle between axis and rulings, radians, in (0, pi/2).
        half_angle: f64,
        /// True if the normal `f_s × f_t` points away from the axis.
        outward: bool,
    },
    /// A torus.
    Torus {
        /// Origin at the center, third axis along the axis.
        frame: Frame,
        /// Distance of the tube's center from the axis; below `minor_radius` the torus crosses itself (spindle).
        major_radius: f64,
        /// Radius of the tube.
        minor_radius: f64,
        /// True if the normal `f_s × f_t` points out of the tube.
        outward: bool,
    },
    /// None of these.
    Cyclide,
}

impl PatchKind {
    /// Distance of a point from the whole surface (for a cone, from its ruling in the point's plane through the axis,
    /// produced beyond the apex). `None` for the general cyclide.
    #[must_use]
    pub fn distance(&self, p: Point3) -> Option<f64> {
        // Distance from the axis and height.
        let place = |frame: &Frame| {
            let (flat, height) = frame.to_local(p);
            (flat.x.hypot(flat.y), height)
        };
        Some(match self {
            Self::Plane { frame } => frame.to_local(p).1.abs(),
            Self::Sphere { frame, radius, .. } => (p.distance(frame.origin()) - radius).abs(),
            Self::Cylinder { frame, radius, .. } => (place(frame).0 - radius).abs(),
            Self::Cone { frame, radius, half_angle, .. } => {
                let ((rho, height), (sin, cos)) = (place(frame), half_angle.sin_cos());
                ((rho - radius) * cos - height * sin).abs()
            }
            Self::Torus { frame, major_radius, minor_radius, .. } => {
                let (rho, height) = place(frame);
                let from_tube = |side: f64| ((side - major_radius).hypot(height) - minor_radius).abs();
                // On the inner part of a spindle the tube's center is beyond the axis.
                from_tube(rho).min(from_tube(-rho))
            }
            Self::Cyclide => return None,
        })
    }
}

/// One family of curvature lines: their common principal curvature by least squares, how far it varies, and whether
/// their direction is `V1`.
struct Family {
    curvature: f64,
    spread: f64,
    s_lines: bool,
}

impl CyclidePatch {
    /// The plane, sphere, cylinder, cone or torus on which the patch lies, within about 1e-10 of its size, with its
    /// placement; general cyclides otherwise.
    ///
    /// By the principal curvatures (`docs/math/patches.md#recognition`): all constant and equal, plane or sphere; one
    /// family zero, cylinder (the other constant) or cone; exactly one a nonzero constant, torus. The converse is not
    /// proved, so the result is kept only if a 5×5 grid of the patch's points is on the surface found.
    #[must_use]
    pub fn recognize(&self) -> PatchKind {
        let found = self.by_curvatures().unwrap_or(PatchKind::Cyclide);
        let grid = (0..25).map(|i| self.point(0.25 * f64::from(i % 5), 0.25 * f64::from(i / 5)));
        let on_it = |p: Point3| {
            let far = p.to_vec().max_abs() + found.reach();
            found.distance(p).is_some_and(|d| d <= LIMIT * self.scale + ROUNDING * far)
        };
        if grid.into_iter().all(on_it) { found } else { PatchKind::Cyclide }
    }

    fn by_curvatures(&self) -> Option<PatchKind> {
        let limit = LIMIT / self.scale;
        let family = |bend: [f64; 3], speed: [f64; 3], s_lines: bool| {
            let (curvature, spread) = proportion(bend.map(|b| -2.0 * b), speed);
            Family { curvature, spread, s_lines }
        };
        let one = family(self.polar.bend1(self.v[1]), self.polar.q1, true);
        let two = family(self.polar.bend2(self.v[0]), self.polar.q2, false);
        let is_constant = |f: &Family| f.spread <= limit;
        let is_zero = |f: &Family| is_constant(f) && f.curvature.abs() <= limit;
        if is_constant(&one) && is_constant(&two) && (one.curvature - two.curvature).abs() <= limit {
            return self.plane_or_sphere(0.5 * (one.curvature + two.curvature), limit);
        }
        match (is_zero(&one), is_zero(&two), is_constant(&one), is_constant(&two)) {
            (true, _, _, round) => self.cylinder_or_cone(&one, round),
            (_, true, round, _) => self.cylinder_or_cone(&two, round),
            (_, _, true, false) => self.torus(&one),
            (_, _, false, true) => self.torus(&two),
            _ => None,
        }
    }

    fn plane_or_sphere(&self, k: f64, limit: f64) -> Option<PatchKind> {
        let [e1, e2, n] = self.moving_frame(0.5, 0.5);
        let middle = self.point(0.5, 0.5);
        let normal = self.normal(0.5, 0.5)?;
        if k.abs() <= limit {
            let frame = Frame::from_normal(self.corners[0], normal, e1).ok()?;
            return Some(PatchKind::Plane { frame });
        }
        let center = middle + n * (1.0 / k);
        let frame = Frame::from_normal(center, e2, center - middle).ok()?;
        Some(PatchKind::Sphere { frame, radius: 1.0 / k.abs(), outward: normal.dot(middle - center) > 0.0 })
    }

    /// The surface with straight meridians of the given family.
    fn cylinder_or_cone(&self, meridians: &Family, round: bool) -> Option<PatchKind> {
        let (parallel, at, (s, t)) = self.parallel(meridians)?;
        let radial = (at - parallel.center).unit()?;
        let outward = self.normal(s, t)?.dot(radial) > 0.0;
        let (axis, radius) = (parallel.normal, parallel.radius);
        if round {
            let frame = Frame::from_normal(parallel.center, axis, -radial).ok()?;
            return Some(PatchKind::Cylinder { frame, radius, outward });
        }
        let [e1, e2, _] = self.moving_frame(s, t);
        let ruling = if meridians.s_lines { e1 } else { e2 };
        let (out, along) = (ruling.dot(radial), ruling.dot(axis));
        let away = if (out > 0.0) == (along > 0.0) { axis } else { -axis };
        let frame = Frame::from_normal(parallel.center, away, -radial).ok()?;
        Some(PatchKind::Cone { frame, radius, half_angle: out.abs().atan2(along.abs()), outward })
    }

    /// The torus with meridian circles of the given family.
    fn torus(&self, meridians: &Family) -> Option<PatchKind> {
        let (parallel, at, (s, t)) = self.parallel(meridians)?;
        let tube = at + self.unit_normal(s, t) * (1.0 / meridians.curvature);
        let center = parallel.center + parallel.normal * (tube - parallel.center).dot(parallel.normal);
        let frame = Frame::from_normal(center, parallel.normal, parallel.center - at).ok()?;
        Some(PatchKind::Torus {
            frame,
            major_radius: tube.distance(center),
            minor_radius: 1.0 / meridians.curvature.abs(),
            outward: self.normal(s, t)?.dot(at - tube) > 0.0,
        })
    }

    /// A line across the meridians, a circle about the axis: the largest of the first, middle and last one, with the
    /// point in the middle of its arc (where both ends weigh the same) and that point's parameters.
    fn parallel(&self, meridians: &Family) -> Option<(LineCircle, Point3, (f64, f64))> {
        let circle = |x: f64| if meridians.s_lines { self.t_line_circle(x) } else { self.s_line_circle(x) };
        let found = [0.0, 0.5, 1.0].into_iter().filter_map(|x| Some((circle(x)?, x)));
        let (circle, x) = found.max_by(|(a, _), (b, _)| a.radius.total_cmp(&b.radius))?;
        let place = |y: f64| if meridians.s_lines { (x, y) } else { (y, x) };
        let weight = |y: f64| self.denominator(place(y).0, place(y).1).norm();
        let middle = place(weight(0.0) / (weight(0.0) + weight(1.0)));
        Some((circle, self.point(middle.0, middle.1), middle))
    }
}

impl PatchKind {
    /// Size of the numbers of which it is made: their rounding moves the surface.
    fn reach(&self) -> f64 {
        let of = |frame: &Frame, radius: f64| frame.origin().to_vec().max_abs() + radius;
        match self {
            Self::Plane { frame } => of(frame, 0.0),
            Self::Sphere { frame, radius, .. }
            | Self::Cylinder { frame, radius, .. }
            | Self::Cone { frame, radius, .. } => of(frame, *radius),
            Self::Torus { frame, major_radius, minor_radius, .. } => of(frame, major_radius + minor_radius),
            Self::Cyclide => 0.0,
        }
    }
}
