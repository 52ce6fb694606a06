//! Angles and heights on planes, cylinders, cones, spheres and tori, as readers have them, and loops developed into these.
//!
//! Parameters are those of ISO 10303-42: angles about the third axis from the first one, heights along it (of cones too), latitudes of spheres
//! and angles round the tube of tori. The normal `f_u × f_v` is the surface's own, outward.

use cyclide::{Frame, Point3, Vec3, surface::PatchKind, topology::EdgeCurve};
use std::f64::consts::{PI, TAU};

/// Points per edge at which a loop is developed, without the last one: edges are below 150 degrees.
const PLACES: u32 = 16;
/// A larger step of an angle between two of them is that of a loop that passes a pole.
const LARGEST_STEP: f64 = 1.5;
/// Nearer to a pole than this part of the surface's radius there is no angle.
const POLE: f64 = 1e-7;
/// An angle at a pole that is less than this from a full turn is one.
const FULL: f64 = 1e-7;

/// The place of a point in the parameters of a surface; `None` of surfaces without.
pub(in crate::formats::step) fn place(kind: &PatchKind, p: Point3) -> Option<[f64; 2]> {
    let round = |frame: &Frame| {
        let (flat, height) = frame.to_local(p);
        (flat.y.atan2(flat.x), flat.x.hypot(flat.y), height)
    };
    Some(match kind {
        PatchKind::Plane { frame } => {
            let (flat, _) = frame.to_local(p);
            [flat.x, flat.y]
        }
        PatchKind::Cylinder { frame, .. } | PatchKind::Cone { frame, .. } => {
            let (angle, _, height) = round(frame);
            [angle, height]
        }
        PatchKind::Sphere { frame, .. } => {
            let (angle, rho, height) = round(frame);
            [angle, height.atan2(rho)]
        }
        PatchKind::Torus { frame, major_radius, .. } => {
            let (angle, rho, height) = round(frame);
            [angle, height.atan2(rho - major_radius)]
        }
        PatchKind::Cyclide => return None,
    })
}

/// Which of the parameters are angles that come back after a turn.
pub(super) fn periodic(kind: &PatchKind) -> [bool; 2] {
    match kind {
        PatchKind::Cylinder { .. } | PatchKind::Cone { .. } | PatchKind::Sphere { .. } => [true, false],
        PatchKind::Torus { .. } => [true, true],
        PatchKind::Plane { .. } | PatchKind::Cyclide => [false, false],
    }
}

/// At a pole, where there is no angle, whether the surface is below it (1) or above it (-1) in its second parameter; `None` elsewhere.
pub(super) fn pole(kind: &PatchKind, p: Point3) -> Option<f64> {
    let (frame, radius) = match kind {
        PatchKind::Cone { frame, radius, .. } | PatchKind::Sphere { frame, radius, .. } => (frame, *radius),
        _ => return None,
    };
    let (flat, height) = frame.to_local(p);
    let above = if matches!(kind, PatchKind::Cone { .. }) { -1.0 } else { height.signum() };
    (flat.x.hypot(flat.y) <= POLE * radius).then_some(above)
}

/// A vector on the side of the surface's own normal.
pub(in crate::formats::step) fn outward(kind: &PatchKind, p: Point3) -> Option<Vec3> {
    let from_axis = |frame: &Frame| {
        let v = p - frame.origin();
        v - frame.z() * v.dot(frame.z())
    };
    match kind {
        PatchKind::Plane { frame } => Some(frame.z()),
        PatchKind::Sphere { frame, .. } => Some(p - frame.origin()),
        PatchKind::Cylinder { frame, .. } | PatchKind::Cone { frame, .. } => Some(from_axis(frame)),
        PatchKind::Torus { frame, major_radius, .. } => {
            Some(p - (frame.origin() + from_axis(frame).unit()? * *major_radius))
        }
        PatchKind::Cyclide => None,
    }
}

/// The difference of two angles, from -π to π.
pub(super) fn angle_between(from: f64, to: f64) -> f64 {
    let turn = (to - from).rem_euclid(TAU);
    if turn > PI { turn - TAU } else { turn }
}

/// A loop in the parameters of its surface, run without jumps.
pub(super) struct Developed {
    /// Its points; the last one is the first one again, but for whole turns.
    pub(super) points: Vec<[f64; 2]>,
}

impl Developed {
    /// A loop of edges, each with whether it is run from its start, on a surface; `outward` if its outer side is that of the surface's own
    /// normal. `None` where an edge passes a pole, and on surfaces without parameters.
    pub(super) fn new<'a>(
        kind: &PatchKind,
        edges: impl Iterator<Item = (&'a EdgeCurve, bool)>,
        outward: bool,
    ) -> Option<Self> {
        let mut raw: Vec<([f64; 2], Option<f64>)> = Vec::new();
        for (curve, forward) in edges {
            for i in 0..PLACES {
                let x = f64::from(i) / f64::from(PLACES);
                let p = curve.point(if forward { x } else { 1.0 - x });
                raw.push((place(kind, p)?, pole(kind, p)));
            }
        }
        let first = raw.iter().position(|(_, pole)| pole.is_none())?;
        raw.rotate_left(first);
        raw.push(raw[0]);
        let periodic = periodic(kind);
        let mut points = vec![raw[0].0];
        let mut at_pole: Option<f64> = None;
        for &(to, pole) in &raw[1..] {
            let from = *points.last()?;
            if let Some(side) = pole {
                at_pole = Some(side);
                points.push([from[0], to[1]]);
                continue;
            }
            let mut next = to;
            if let Some(side) = at_pole.take() {
                // Counter-clockwise the angle shrinks along an upper side and grows along a lower one.
                let side = if outward { side } else { -side };
                let turn = (side * (from[0] - to[0])).rem_euclid(TAU);
                let turn = if (FULL..=TAU - FULL).contains(&turn) { turn } else { TAU };
                next[0] = from[0] - side * turn;
                points.push([next[0], from[1]]);
            } else if periodic[0] {
                let step = angle_between(from[0], to[0]);
                next[0] = from[0] + step;
                if step.abs() > LARGEST_STEP {
                    return None;
                }
            }
            if periodic[1] {
                let step = angle_between(from[1], to[1]);
                next[1] = from[1] + step;
                if step.abs() > LARGEST_STEP {
                    return None;
                }
            }
            points.push(next);
        }
        Some(Self { points })
    }

    /// How many turns of each parameter the loop makes; `None` of a loop that does not close.
    pub(super) fn turns(&self) -> Option<[i32; 2]> {
        let (first, last) = (self.points.first()?, self.points.last()?);
        let [u, v] = [0, 1].map(|k| (last[k] - first[k]) / TAU);
        let closes = |turns: f64| (turns - turns.round()).abs() <= 1e-6 && turns.abs() < 100.0;
        (closes(u) && closes(v)).then_some([u.round() as i32, v.round() as i32])
    }

    /// The area that it runs round counter-clockwise, `-∮ v du`: of loops that turn, what lies between such loops is their sum.
    pub(super) fn area(&self) -> f64 {
        let strip = |pair: &[[f64; 2]]| 0.5 * (pair[0][1] + pair[1][1]) * (pair[0][0] - pair[1][0]);
        self.points.windows(2).map(strip).sum()
    }

    /// How often it crosses a value of the angle.
    pub(super) fn crossings(&self, angle: f64) -> usize {
        let turn = |u: f64| ((u - angle) / TAU).floor();
        self.points.windows(2).map(|pair| (turn(pair[1][0]) - turn(pair[0][0])).abs() as usize).sum()
    }

    /// How far an angle is outside the range that the loop has; 0 inside.
    pub(super) fn clearance(&self, angle: f64) -> f64 {
        let [from, to] = self.range(0);
        let at = from + (angle - from).rem_euclid(TAU);
        if at <= to { 0.0 } else { (at - to).min(from + TAU - at) }
    }

    /// The least and the largest value of a parameter.
    pub(super) fn range(&self, parameter: usize) -> [f64; 2] {
        let values = || self.points.iter().map(|p| p[parameter]);
        [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
    }
}
