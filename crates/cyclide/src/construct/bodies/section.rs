//! Plane sections that are swept: contours round areas, the faces that cover these, and the contours cut as those need it.

use super::bands::rows_of;
use super::planar_area::{Cover, Plane};
use super::rails::rail_pieces;
use crate::base::planar::Point2;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ProfileError, Result};
use crate::topology::EdgeCurve;

/// Places of a curve that stand for it where contours are nested and crossings looked for.
const PLACES: usize = 12;
/// A section is plane if its control points leave the plane by less than this part of its size.
const PLANE: f64 = 1e-9;
/// A contour goes round an area if that is more than this part of the square of its size.
const NO_AREA: f64 = 1e-12;

/// Contours that are swept together: the first one round all others, the area to the left of all; or one that bounds none.
pub(super) struct Section {
    pub(super) contours: Vec<Vec<EdgeCurve>>,
    /// False for an open curve.
    pub(super) closed: bool,
    /// Faces over the area, with the contours as their borders.
    pub(super) cover: Option<Cover>,
}

impl Plane {
    /// The plane of a closed plane curve, if it is in one; the normal is the side from which it runs counter-clockwise.
    pub(super) fn of_contour(curves: &[EdgeCurve]) -> Option<Self> {
        let points = sampled(curves);
        let origin = *points.first()?;
        let area = points.windows(2).fold(Vec3::ZERO, |sum, pair| sum + (pair[0] - origin).cross(pair[1] - origin));
        let normal = area.unit()?;
        let x = normal.any_perpendicular();
        let plane = Self { origin, axes: [x, normal.cross(x)] };
        let size = points.iter().map(|p| p.distance(origin)).fold(0.0, f64::max);
        let flat = 0.5 * area.length() > NO_AREA * size * size && off(&plane, curves) <= PLANE * size;
        flat.then_some(plane)
    }

    pub(super) fn normal(&self) -> Vec3 {
        self.axes[0].cross(self.axes[1])
    }
}

/// Sections of contours of the plane z = 0: those of areas with their holes, and open curves, each on its own. `covered` if areas are to be covered by faces.
///
/// # Errors
/// `section-not-plane`, `section-meets-itself`, as [`rail_pieces`].
pub(super) fn sections(contours: &[(Vec<EdgeCurve>, bool)], covered: bool) -> Result<Vec<Section>> {
    let plane = Plane { origin: Point3::ORIGIN, axes: [Vec3::X, Vec3::Y] };
    let mut loops: Vec<(usize, Vec<EdgeCurve>, Vec<Point2>)> = Vec::new();
    let mut made = Vec::new();
    for (contour, (curves, closed)) in contours.iter().enumerate() {
        let pieces = rail_pieces([curves, curves], *closed)?.into_iter().map(|piece| piece.curves[0].clone());
        let pieces: Vec<EdgeCurve> = pieces.collect();
        let size = pieces.iter().flat_map(|curve| [curve.start(), curve.point(0.5), curve.end()]);
        let size = size.map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let (distance, limit) = (off(&plane, &pieces), PLANE * size);
        if distance > limit {
            return Err(ProfileError::SectionNotPlane { contour, distance, limit }.into());
        }
        if !closed {
            made.push((contour, Section { contours: vec![pieces], closed: false, cover: None }));
            continue;
        }
        let polygon: Vec<Point2> = sampled(&pieces).into_iter().map(|p| Point2::new(p.x, p.y)).collect();
        if area(&polygon).abs() <= NO_AREA * size * size {
            return Err(ProfileError::SectionMeetsItself { contour }.into());
        }
        loops.push((contour, pieces, polygon));
    }
    if let Some(contour) = crossing(&loops) {
        return Err(ProfileError::SectionMeetsItself { contour }.into());
    }
    let around: Vec<Vec<usize>> = (0..loops.len())
        .map(|k| (0..loops.len()).filter(|&j| j != k && is_inside(loops[k].2[0], &loops[j].2)).collect())
        .collect();
    for k in (0..loops.len()).filter(|&k| around[k].len().is_multiple_of(2)) {
        let hole = |&j: &usize| around[j].len() == around[k].len() + 1 && around[j].contains(&k);
        let members = std::iter::once(k).chain((0..loops.len()).filter(hole));
        let oriented = members.map(|j| {
            let (_, curves, polygon) = &loops[j];
            let forward = (area(polygon) > 0.0) == (j == k);
            if forward { curves.clone() } else { curves.iter().rev().map(EdgeCurve::reversed).collect() }
        });
        let mut contours: Vec<Vec<EdgeCurve>> = oriented.collect();
        let cover = match covered {
            true => {
                let cover = Cover::of_contours(&plane, contours.clone())?;
                Some(cover.ok_or(ProfileError::SectionMeetsItself { contour: loops[k].0 })?)
            }
            false => None,
        };
        if let Some(cover) = &cover {
            contours =
                cover.contours.iter().map(|sides| sides.iter().map(|side| side.curve.clone()).collect()).collect();
        }
        made.push((loops[k].0, Section { contours, closed: true, cover }));
    }
    made.sort_by_key(|(contour, _)| *contour);
    Ok(made.into_iter().map(|(_, section)| section).collect())
}

/// The faces over a closed plane contour of any plane, with its plane; none where it is in no plane or meets itself.
pub(super) fn covered(curves: &[EdgeCurve]) -> Result<Option<(Plane, Cover)>> {
    let Some(plane) = Plane::of_contour(curves) else { return Ok(None) };
    let polygon: Vec<Point2> = sampled(curves).into_iter().map(|p| plane.locate(p)).collect();
    if crossing(&[(0, curves.to_vec(), polygon)]).is_some() {
        return Ok(None);
    }
    Ok(Cover::of_contours(&plane, vec![curves.to_vec()])?.map(|cover| (plane, cover)))
}

/// Points of curves that follow each other, the last one behind the last curve.
fn sampled(curves: &[EdgeCurve]) -> Vec<Point3> {
    let count = |curve: &EdgeCurve| if curve.arc().is_some_and(crate::curve::Arc::is_straight) { 1 } else { PLACES };
    let of =
        |curve: &EdgeCurve| (0..count(curve)).map(|k| curve.point(k as f64 / count(curve) as f64)).collect::<Vec<_>>();
    curves.iter().flat_map(of).chain(curves.last().map(EdgeCurve::end)).collect()
}

/// The largest distance of a control point from a plane.
fn off(plane: &Plane, curves: &[EdgeCurve]) -> f64 {
    let normal = plane.normal();
    let rows = curves.iter().flat_map(rows_of);
    rows.map(|[x, y, z, w]| ((Vec3::new(x, y, z) / w) - plane.origin.to_vec()).dot(normal).abs()).fold(0.0, f64::max)
}

fn area(polygon: &[Point2]) -> f64 {
    polygon.windows(2).map(|pair| 0.5 * (pair[0].x * pair[1].y - pair[1].x * pair[0].y)).sum()
}

fn is_inside(p: Point2, polygon: &[Point2]) -> bool {
    let crosses = |pair: &&[Point2]| {
        let [a, b] = [pair[0], pair[1]];
        (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)
    };
    !polygon.windows(2).filter(crosses).count().is_multiple_of(2)
}

/// The first contour whose polygon crosses itself or one after it.
fn crossing(loops: &[(usize, Vec<EdgeCurve>, Vec<Point2>)]) -> Option<usize> {
    let chords: Vec<(usize, [Point2; 2])> = loops
        .iter()
        .flat_map(|(contour, _, polygon)| polygon.windows(2).map(move |pair| (*contour, [pair[0], pair[1]])))
        .collect();
    let side = |[a, b]: [Point2; 2], p: Point2| (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    chords.iter().enumerate().find_map(|(k, (contour, first))| {
        let cross = |(_, second): &&(usize, [Point2; 2])| {
            side(*first, second[0]) * side(*first, second[1]) < 0.0
                && side(*second, first[0]) * side(*second, first[1]) < 0.0
        };
        chords[k + 1..].iter().find(cross).map(|_| *contour)
    })
}
