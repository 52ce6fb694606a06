//! The axes that spheres are written about: such that borders are meridians and parallels, else such that the poles are far away.

use super::half_edges::HalfEdge;
use super::parameters::pole;
use super::regions::Region;
use cyclide::{
    Frame, Point3, Vec3,
    curve::Arc,
    surface::{ParamSurface as _, PatchKind},
    topology::Shell,
};

/// Angle up to which circles of a sphere are parallel to, or contain, an axis.
const AXIS_LIMIT: f64 = 1e-10;
/// A face without such an axis is at most so far from its middle, radians, and its border from the equator: poles are a quarter of a turn
/// away from both.
const LARGEST_REACH: f64 = 1.45;
const LARGEST_LATITUDE: f64 = 1.2;
/// Directions nearer than this are one.
const SAME_AXIS: f64 = 1e-6;
/// So many axes are tried.
const MOST_AXES: usize = 12;

/// The placements of a region's surface to try, the best one first: of all but spheres the one that it has.
pub(super) fn framings(
    shell: &Shell,
    region: &Region,
    borders: &[Vec<HalfEdge>],
    arcs: &[Option<Arc>],
) -> Vec<PatchKind> {
    let PatchKind::Sphere { frame, radius, outward } = region.kind else { return vec![region.kind] };
    let center = frame.origin();
    let about = |axis: Vec3| {
        let frame = Frame::from_normal(center, axis, axis.any_perpendicular()).ok()?;
        Some(PatchKind::Sphere { frame, radius, outward })
    };
    let border: Vec<Arc> = borders.iter().flatten().filter_map(|half| arcs[half.edge]).collect();
    if border.len() < borders.iter().map(Vec::len).sum() {
        return Vec::new();
    }
    let mut axes: Vec<Vec3> = Vec::new();
    let mut propose = |axis: Option<Vec3>| {
        if let Some(axis) = axis
            && axes.len() < MOST_AXES
            && axes.iter().all(|other| other.cross(axis).length() > SAME_AXIS)
        {
            axes.push(axis);
        }
    };
    // Where parameter lines of its faces shrink to points, where meridians cross, and across parallels.
    for face in region.faces.iter().map(|&face| &shell.faces()[face]) {
        for side in cyclide::topology::Side::ALL.into_iter().filter(|&side| face.side(side).is_none()) {
            let (s, t) = side.place(0.5);
            propose((face.surface.point(s, t) - center).unit());
        }
    }
    let is_great = |arc: &Arc| arc.normal().is_some_and(|n| (arc.start() - center).dot(n).abs() <= AXIS_LIMIT * radius);
    let great: Vec<Vec3> = border.iter().filter(|arc| is_great(arc)).filter_map(Arc::normal).collect();
    for (i, first) in great.iter().enumerate().take(MOST_AXES) {
        let second = great[i + 1..].iter().find(|n| n.cross(*first).length() > 1e-4);
        propose(second.and_then(|second| second.cross(*first).unit()));
    }
    for arc in border.iter().filter(|arc| !is_great(arc)) {
        propose(arc.normal());
    }
    great.first().into_iter().for_each(|normal| propose(Some(*normal)));
    if border.is_empty() {
        propose(Some(frame.z()));
    }
    let mut found: Vec<PatchKind> = axes.into_iter().filter_map(about).collect();
    // Others carry curves in the parameters: the fewer, the better.
    let others = |kind: &PatchKind| border.iter().filter(|arc| !is_parameter_line(kind, arc)).count();
    // A whole sphere has no border that an axis could suit.
    found.retain(|kind| border.is_empty() || others(kind) < border.len());
    found.sort_by_key(others);
    found.extend(free(shell, region, &border, (center, radius)).and_then(about));
    found
}

/// An axis at right angles to the direction of the middle of a region that is small enough, and to that of its farthest corner.
fn free(shell: &Shell, region: &Region, border: &[Arc], (center, radius): (Point3, f64)) -> Option<Vec3> {
    let directions = region.faces.iter().map(|&face| shell.faces()[face].surface.point(0.5, 0.5) - center);
    let middle = directions.fold(Vec3::ZERO, |sum, v| sum + v).unit()?;
    let border: Vec<Vec3> = border.iter().flat_map(|arc| [arc.start(), arc.midpoint()]).map(|p| p - center).collect();
    let reach = |v: &Vec3| middle.angle(*v);
    let farthest = *border.iter().max_by(|a, b| reach(a).total_cmp(&reach(b)))?;
    let axis = middle.cross(farthest).unit().unwrap_or(middle.any_perpendicular());
    let highest = border.iter().map(|v| v.dot(axis).abs()).fold(0.0, f64::max);
    let fits = reach(&farthest) <= LARGEST_REACH && highest <= LARGEST_LATITUDE.sin() * radius;
    (fits && radius > 0.0).then_some(axis)
}

/// Whether an arc on a sphere is a part of a meridian or a parallel.
pub(in crate::formats::step) fn is_parameter_line(kind: &PatchKind, arc: &Arc) -> bool {
    let PatchKind::Sphere { frame, radius, .. } = kind else { return true };
    let Some(normal) = arc.normal() else { return false };
    let is_parallel = normal.cross(frame.z()).length() <= AXIS_LIMIT;
    let contains_axis = normal.dot(frame.z()).abs() <= AXIS_LIMIT
        && (arc.start() - frame.origin()).dot(normal).abs() <= AXIS_LIMIT * radius;
    // A meridian that goes on beyond a pole is two.
    let passes = || (1..8).any(|i| pole(kind, arc.point(f64::from(i) / 8.0)).is_some());
    is_parallel || (contains_axis && !passes())
}
