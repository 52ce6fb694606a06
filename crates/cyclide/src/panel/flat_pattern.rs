//! Flat patterns of panels that are bent from a flat sheet.

use super::bent_plane::Bend;
use super::nearest::{EXACT, NearSurface, PanelPoints};
use crate::base::planar::Point2;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ArcPath};
use crate::error::{Result, check_tolerance};
use crate::surface::{CyclidePatch, ParamSurface as _, PatchKind};
use crate::topology::{Shell, Side};

/// A side is taken as this many arcs at most.
const MOST_ARCS: u32 = 64;
/// Places between the ends of an arc at which it is compared with what is unrolled.
const PLACES: u32 = 8;

/// The outline of the flat sheet from which a panel is bent.
///
/// Panels on planes, cylinders and cones are unrolled without a change of any length. Their sides are lines of curvature, so on a
/// cylinder they become a rectangle and on a cone a sector of a ring: arcs and segments, exactly. A panel that is only near
/// such a surface is laid on it along its normals first, which changes lengths by no more than distance times curvature.
///
/// ```
/// use cyclide::{Point3, Vec3, panel::FlatPattern, surface::CyclidePatch};
/// // A quarter of a cylinder of radius 2 and height 3.
/// let corners = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [2.0, 0.0, 3.0], [0.0, 2.0, 3.0]].map(Point3::from);
/// let panel = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)?;
/// let flat = FlatPattern::new(&panel, 1e-9)?.unwrap();
/// assert!((flat.area - 3.0 * std::f64::consts::PI).abs() < 1e-12);
/// assert!(flat.sides.iter().all(|side| side.arcs().len() == 1 && side.arcs()[0].is_straight()));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FlatPattern {
    /// The plane, cylinder or cone, in the place of the panel.
    pub surface: PatchKind,
    /// Largest distance of the panel from it.
    pub surface_distance: f64,
    /// The sides, by the index of [`Side`], in the plane `z = 0`, seen from the side of `f_s × f_t`: with the parameter of the patch they run round
    /// counter-clockwise in the order of [`Side::LOOP`], `Top` and `Left` backwards. The first corner is at the origin, the last
    /// one of the bottom side on the axis of x. Ends that meet are the same doubles. Sides of one point are arcs of no length.
    pub sides: [ArcPath; 4],
    /// Largest distance of the arcs of `sides` from the unrolled sides, measured between their ends.
    pub deviation: f64,
    /// Area inside the outline.
    pub area: f64,
    /// Area of the outline over that of the panel, less 1.
    pub area_change: f64,
    /// Lengths of the sides of the outline over those of the panel, less 1: the largest, in absolute value.
    pub length_change: f64,
}

impl FlatPattern {
    /// The pattern of a panel within a tolerance of a plane, a cylinder or a cone; `None` if it is near none of them, or
    /// if a side would need more than 64 arcs to be within the tolerance. A panel that lies on one of
    /// them is unrolled from that one, whatever the tolerance; of the others the first that is within the tolerance is taken.
    ///
    /// # Errors
    /// `tolerance-not-positive`; what [`Shell::known_area`] says of panels with corners near infinity.
    pub fn new(patch: &CyclidePatch, tolerance: f64) -> Result<Option<Self>> {
        check_tolerance(tolerance)?;
        let Some(near) = unrolled_from(patch, tolerance) else { return Ok(None) };
        let Some(unrolled) = Unrolled::new(patch, &near.surface) else { return Ok(None) };
        // A panel that is on the surface has sides that are single arcs; then nothing is gained by the tolerance.
        let exact = EXACT * patch.size();
        let limit = if near.max_distance <= exact { exact } else { tolerance };
        let mut deviation: f64 = 0.0;
        let mut sides = Vec::with_capacity(4);
        for side in Side::ALL {
            let Some((path, off)) = unrolled.side(side, limit.min(tolerance)) else { return Ok(None) };
            deviation = deviation.max(off);
            sides.push(path);
        }
        let Ok(sides) = <[ArcPath; 4]>::try_from(sides) else { return Ok(None) };
        let area = enclosed(&sides);
        let of_panel = Shell::from_surface(*patch)?.known_area()?;
        let mut length_change: f64 = 0.0;
        for side in Side::ALL {
            let arc = match side.direction() {
                0 => patch.s_line(side.place(0.0).1)?,
                _ => patch.t_line(side.place(0.0).0)?,
            };
            if arc.length() > 0.0 {
                length_change = length_change.max((sides[side as usize].length() / arc.length() - 1.0).abs());
            }
        }
        Ok(Some(Self {
            surface: near.surface,
            surface_distance: near.max_distance,
            sides,
            deviation,
            area,
            area_change: area / of_panel - 1.0,
            length_change,
        }))
    }
}

/// The surface that a panel is unrolled from: the one that it lies on, else the first within the tolerance.
fn unrolled_from(patch: &CyclidePatch, tolerance: f64) -> Option<NearSurface> {
    let panel = PanelPoints::new(patch);
    // Fits that miss `given_up` are left early; those below it are the same for every larger one.
    let within = |limit: f64, given_up: f64| {
        let fits = [Bend::Plane, Bend::Cylinder, Bend::Cone].into_iter().filter_map(|bend| panel.fit(bend, given_up));
        fits.filter_map(|fit| panel.near_surface(&fit)).find(|near| near.max_distance <= limit)
    };
    let exact = panel.rounding().min(tolerance);
    within(exact, 2.0 * exact / panel.unit.size).or_else(|| within(tolerance, f64::INFINITY))
}

/// The patch with the map of its surface to the plane, made so that the first corner is at the origin.
struct Unrolled<'a> {
    patch: &'a CyclidePatch,
    surface: &'a PatchKind,
    corner: Point2,
    along: [f64; 2],
    /// True if the plane is seen from the other side.
    mirrored: bool,
}

impl<'a> Unrolled<'a> {
    fn new(patch: &'a CyclidePatch, surface: &'a PatchKind) -> Option<Self> {
        let mut new = Self { patch, surface, corner: Point2::new(0.0, 0.0), along: [1.0, 0.0], mirrored: false };
        let corners = patch.corners().map(|p| new.raw(p));
        let [a, b, c, d] = corners;
        // Round the outline: its sense tells the side.
        let doubled = (b - a).cross(d - a) + (d - a).cross(c - a);
        let along = (b - a).unit().or_else(|| (c - a).unit())?;
        (new.corner, new.along, new.mirrored) = (a, [along.x, along.y], doubled < 0.0);
        Some(new)
    }

    /// The place of the plane where the foot of a point is laid.
    fn raw(&self, p: Point3) -> Point2 {
        match *self.surface {
            PatchKind::Plane { frame } => frame.to_local(p).0,
            PatchKind::Cylinder { frame, radius, .. } => {
                let (flat, height) = frame.to_local(p);
                Point2::new(radius * (-flat.y).atan2(-flat.x), height)
            }
            PatchKind::Cone { frame, radius, half_angle, .. } => {
                let (flat, height) = frame.to_local(p);
                let (sin, cos) = half_angle.sin_cos();
                let from_apex = radius / sin + (flat.x.hypot(flat.y) - radius) * sin + height * cos;
                let angle = (-flat.y).atan2(-flat.x) * sin;
                // From the middle of the ring, without the cancellation of a far apex.
                let half = (0.5 * angle).sin();
                Point2::new(from_apex * angle.sin(), from_apex - radius / sin - 2.0 * from_apex * half * half)
            }
            _ => Point2::new(0.0, 0.0),
        }
    }

    fn at(&self, p: Point3) -> Point3 {
        let v = self.raw(p) - self.corner;
        let [x, y] = self.along;
        let (right, up) = (v.x * x + v.y * y, v.y * x - v.x * y);
        Point3::new(right, if self.mirrored { -up } else { up }, 0.0)
    }

    /// A side as arcs within a limit of what is unrolled, with the largest distance; as few as halving gives.
    fn side(&self, side: Side, limit: f64) -> Option<(ArcPath, f64)> {
        let corner = side.corners().map(|k| self.patch.corners()[k]);
        let at = |x: f64| {
            let (s, t) = side.place(x);
            let ends = [(0.0, corner[0]), (1.0, corner[1])];
            let end = ends.into_iter().find(|(end, _)| (x - end).abs() <= 0.0);
            self.at(end.map_or_else(|| self.patch.point(s, t), |(_, p)| p))
        };
        if corner[0] == corner[1] {
            return Some((ArcPath::new(vec![Arc::segment(at(0.0), at(0.0)).ok()?], false).ok()?, 0.0));
        }
        let mut count = 1;
        while count <= MOST_ARCS {
            let place = |k: u32| f64::from(k) / f64::from(count);
            let arcs =
                (0..count).map(|k| through(at(place(k)), at(0.5 * (place(k) + place(k + 1))), at(place(k + 1)), limit));
            let arcs: Vec<Arc> = arcs.collect::<Option<_>>()?;
            let off = (0..count).flat_map(|k| {
                let arc = arcs[k as usize];
                (1..PLACES).map(move |j| (arc, (f64::from(k) + f64::from(j) / f64::from(PLACES)) / f64::from(count)))
            });
            let off = off.map(|(arc, x)| arc.closest_point(at(x)).distance).fold(0.0, f64::max);
            if off <= limit {
                return Some((ArcPath::new(arcs, false).ok()?, off));
            }
            count *= 2;
        }
        None
    }
}

/// The arc through three points, or the segment where the middle one is on it within an exact limit.
fn through(a: Point3, b: Point3, c: Point3, limit: f64) -> Option<Arc> {
    let flat = (b - a).cross(c - a).length() <= 1e-13 * (c - a).length() * (c - a).length();
    if flat || limit <= 0.0 { Arc::segment(a, c).ok() } else { Arc::from_three_points(a, b, c).ok() }
}

/// The area within the sides: the polygon of the ends of their arcs, and the segments of circles beside it.
fn enclosed(sides: &[ArcPath; 4]) -> f64 {
    let mut doubled = 0.0;
    for side in Side::LOOP {
        let sign = if side.runs_with_loop() { 1.0 } else { -1.0 };
        for arc in sides[side as usize].arcs() {
            let (a, c) = (arc.start().to_vec(), arc.end().to_vec());
            doubled += sign * (a.x * c.y - a.y * c.x);
            if let (Some(radius), Some(normal)) = (arc.radius(), arc.normal()) {
                let angle = arc.angle();
                doubled += sign * normal.dot(Vec3::Z).signum() * radius * radius * (angle - angle.sin());
            }
        }
    }
    0.5 * doubled
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panel::NearestSurfaces;
    use crate::surface::DupinCyclide;

    /// Fits that are left early choose the surface that whole fits choose, bit by bit.
    #[test]
    fn panels_are_unrolled_from_what_is_nearest() {
        let whole = |patch: &CyclidePatch, tolerance: f64| {
            let near = NearestSurfaces::new(patch);
            let bent = [Some(near.plane), near.cylinder, near.cone];
            let within = |limit: f64| bent.into_iter().flatten().find(|near| near.max_distance <= limit);
            within(PanelPoints::new(patch).rounding().min(tolerance)).or_else(|| within(tolerance))
        };
        let at = |r: f64, angle: f64, z: f64| Point3::new(r * angle.cos(), r * angle.sin(), z);
        // A frustum and a cylinder.
        let revolved = [1.0, 0.7].map(|top| {
            let corners = [at(1.0, 0.1, 0.0), at(1.0, 0.9, 0.0), at(top, 0.1, 0.8), at(top, 0.9, 0.8)];
            let up = corners[2] - corners[0];
            CyclidePatch::from_corners_and_frame(corners, Vec3::new(-0.1_f64.sin(), 0.1_f64.cos(), 0.0), up).unwrap()
        });
        let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([24, 16]).unwrap();
        let panels: Vec<CyclidePatch> = revolved.into_iter().chain(ring[0].patches()).collect();
        let mut kinds = [0; 4];
        for patch in &panels {
            for tolerance in [1e-13, 1e-2, 3e-2, 0.1, 10.0] {
                let found = unrolled_from(patch, tolerance);
                assert_eq!(found, whole(patch, tolerance));
                kinds[match found.map(|near| near.surface) {
                    None => 0,
                    Some(PatchKind::Plane { .. }) => 1,
                    Some(PatchKind::Cylinder { .. }) => 2,
                    _ => 3,
                }] += 1;
            }
        }
        assert!(kinds.iter().all(|count| *count > 0), "{kinds:?}");
    }
}
