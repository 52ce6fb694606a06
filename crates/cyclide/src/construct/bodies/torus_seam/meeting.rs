//! Whether seams run into themselves or each other: points of the sections along them, looked up by cubes, so that time is linear in
//! the length (`docs/math/torus-splines.md#seams`).

use super::TorusSeam;
use super::moving::Moving;
use crate::base::vector::Point3;
use crate::curve::{ParamCurve as _, length};
use crate::error::{Error, Result};
use crate::surface::TorusSpline;
use std::collections::HashMap;
use std::f64::consts::FRAC_PI_2;

/// Sections along a width of the curve, and how many there are of all curves at most: where there are more they are farther apart.
const SECTIONS: f64 = 8.0;
const MOST_SECTIONS: f64 = 2e5;
/// Points across half a section, on each side of its middle.
const ACROSS: i32 = 4;
/// What a point may be off the plane of a section, in steps from section to section, to be looked at closely.
const NEAR_STEPS: f64 = 0.75;
/// What the frame turns away between sections, as part of the width.
const SLACK: f64 = 0.05;
/// Steps of Newton to the section through a point.
const REFINEMENTS: usize = 4;

/// A section with the way of the curve before it.
struct Place {
    spline: usize,
    piece: usize,
    s: f64,
    /// Of the parameter of its piece, to the next.
    step: f64,
    way: f64,
    moving: Moving,
}

/// A point inside two seams, or inside one at two places of its curve.
pub(super) struct Meeting {
    pub(super) splines: [usize; 2],
    pieces: [usize; 2],
    pub(super) point: Point3,
    /// From curve to curve there.
    distance: f64,
}

/// The region of the sections: as far as points have to be inside it.
struct Inside {
    half: f64,
    heights: [f64; 2],
    margin: f64,
}

/// Refuses a seam of which parts that are no neighbours share space.
///
/// # Errors
/// `seam-meets-itself`, `zero-tangent`.
pub(super) fn check(seam: &TorusSeam, spline: &TorusSpline, tolerance: f64) -> Result<()> {
    let Some(Meeting { pieces: [first, second], point, distance, .. }) = first(seam, &[spline], tolerance, false)?
    else {
        return Ok(());
    };
    Err(Error::SeamMeetsItself {
        first: first.min(second),
        second: first.max(second),
        point: point.to_array(),
        distance,
        width: seam.width,
    })
}

/// The first meeting, of one seam with itself or of different ones.
///
/// # Errors
/// `zero-tangent`.
pub(super) fn first(
    seam: &TorusSeam,
    splines: &[&TorusSpline],
    tolerance: f64,
    different: bool,
) -> Result<Option<Meeting>> {
    let lengths: Vec<f64> = splines.iter().map(|spline| length(*spline)).collect();
    let whole: f64 = lengths.iter().sum();
    let spacing = (seam.width / SECTIONS).max(whole / MOST_SECTIONS);
    let mut places = Vec::new();
    for (number, spline) in splines.iter().enumerate() {
        add_places(spline, number, spacing, &mut places)?;
    }
    let [low, high] = seam.heights;
    let half = 0.5 * seam.width;
    let margin = tolerance.min(0.125 * (high - low)).min(0.25 * half);
    let inside = Inside { half, heights: seam.heights, margin };
    // Sections that share a point are not farther apart than this.
    let reach = 2.0 * half.hypot(low.abs().max(high.abs())) + spacing;
    let cube = |p: Point3| p.to_array().map(|v| (v / reach).floor() as i64);
    let mut cubes: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    for (k, place) in places.iter().enumerate() {
        cubes.entry(cube(place.moving.point)).or_default().push(k);
    }
    for place in &places {
        let [x, y, z] = cube(place.moving.point);
        let near = (0..27).map(|k: i64| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1]);
        let others = near.filter_map(|at| cubes.get(&at)).flatten().map(|&k| &places[k]);
        for other in others.filter(|other| (other.spline != place.spline) == different) {
            let apart = different || !are_neighbours(place, other, &lengths, splines, half, spacing);
            if !apart || place.moving.point.distance(other.moving.point) > reach {
                continue;
            }
            if let Some(found) = meeting(place, other, splines, &inside, spacing)? {
                return Ok(Some(found));
            }
        }
    }
    Ok(None)
}

/// Sections this near along the curve do not meet: it turns by less than half a turn between, on radii above half the width.
fn are_neighbours(a: &Place, b: &Place, lengths: &[f64], splines: &[&TorusSpline], half: f64, spacing: f64) -> bool {
    let straight = (a.way - b.way).abs();
    let round = lengths[a.spline] - straight;
    let way = if splines[a.spline].is_closed() { straight.min(round) } else { straight };
    way < FRAC_PI_2 * 2.0 * half + 2.0 * spacing
}

/// A point of a section that is inside the seam at another place of the curve.
fn meeting(
    place: &Place,
    other: &Place,
    splines: &[&TorusSpline],
    inside: &Inside,
    spacing: f64,
) -> Result<Option<Meeting>> {
    let [low, high] = inside.heights;
    for height in [low, 0.5 * (low + high), high] {
        for k in -ACROSS..=ACROSS {
            let side = inside.half * f64::from(k) / f64::from(ACROSS);
            let Moving { point, across, normal, .. } = place.moving;
            let point = point + across * side + normal * height;
            if inside.may_hold(point, &other.moving, spacing)
                && let Some(own) = inside.holds(point, other, splines[other.spline])?
            {
                let (splines, pieces) = ([place.spline, other.spline], [place.piece, other.piece]);
                let distance = place.moving.point.distance(own.point);
                return Ok(Some(Meeting { splines, pieces, point, distance }));
            }
        }
    }
    Ok(None)
}

impl Inside {
    /// False where the nearest section cannot hold a point, by the frame of a section near it.
    fn may_hold(&self, point: Point3, moving: &Moving, spacing: f64) -> bool {
        let v = point - moving.point;
        let slack = SLACK * self.half;
        let [low, high] = self.heights;
        let (side, height) = (v.dot(moving.across), v.dot(moving.normal));
        v.dot(moving.tangent).abs() <= NEAR_STEPS * spacing
            && side.abs() <= self.half + slack
            && height >= low - slack
            && height <= high + slack
    }

    /// The frame of the section near a place that holds a point, if one does.
    fn holds(&self, point: Point3, near: &Place, spline: &TorusSpline) -> Result<Option<Moving>> {
        let (mut s, mut moving) = (near.s, near.moving);
        for _ in 0..REFINEMENTS {
            let v = point - moving.point;
            // The plane through the point: its derivative along the curve is the speed, less where the curve bends to the point.
            let bend = moving.normal_rate * v.dot(moving.normal) + moving.across_rate * v.dot(moving.across);
            let speed = (moving.velocity + bend).dot(moving.tangent);
            if !(speed > 0.0) {
                return Ok(None);
            }
            s += v.dot(moving.tangent) / speed;
            if (s - near.s).abs() > 2.0 * near.step || !(0.0..=1.0).contains(&s) {
                return Ok(None);
            }
            moving = Moving::at(spline, near.piece, s)?;
        }
        let v = point - moving.point;
        let (side, height, [low, high]) = (v.dot(moving.across), v.dot(moving.normal), self.heights);
        let held = side.abs() < self.half - self.margin && height > low + self.margin && height < high - self.margin;
        Ok(held.then_some(moving))
    }
}

/// Adds the sections of a spline, at its ends and about a spacing apart.
fn add_places(spline: &TorusSpline, number: usize, spacing: f64, places: &mut Vec<Place>) -> Result<()> {
    let mut way = 0.0;
    for piece in 0..spline.piece_count() {
        let length = spline.piece_length(piece, 0.0, 1.0);
        let count = (length / spacing).ceil().max(1.0);
        let step = 1.0 / count;
        for k in 0..count as usize {
            let s = (k as f64 + 0.5) * step;
            let own = way + length * s;
            places.push(Place { spline: number, piece, s, step, way: own, moving: Moving::at(spline, piece, s)? });
        }
        way += length;
    }
    Ok(())
}
