//! Whether seams run into themselves or each other: points of the sections along them, held against the runs of sections near them
//! (`docs/math/torus-splines.md#seams`).

use super::TorusSeam;
use super::moving::Moving;
use super::runs::Runs;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{ParamCurve as _, length};
use crate::error::{Error, Result};
use crate::surface::TorusSpline;
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
pub(super) struct Place {
    pub(super) spline: usize,
    piece: usize,
    s: f64,
    /// Of the parameter of its piece, to the next.
    step: f64,
    way: f64,
    pub(super) moving: Moving,
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
pub(super) struct Inside {
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
    // A section that holds a point has its middle within this.
    let slack = SLACK * half;
    let reach = (half + slack).hypot(low.abs().max(high.abs()) + slack) + NEAR_STEPS * spacing;
    let runs = Runs::new(&places, reach, spacing);
    let mut near = Vec::new();
    for place in &places {
        runs.gather(place.moving.point, &mut near);
        near.retain(|run| (places[run.sections.start].spline != place.spline) == different);
        for point in inside.points(&place.moving) {
            for run in near.iter().filter(|run| run.may_hold(point)) {
                let mut from = run.sections.start;
                while let Some(k) = run.next_holding(&places, from, point, &inside, spacing) {
                    let other = &places[k];
                    from = k + 1;
                    if !different && are_neighbours(place, other, &lengths, splines, half, spacing) {
                        continue;
                    }
                    if let Some(own) = inside.holds(point, other, splines[other.spline])? {
                        let (splines, pieces) = ([place.spline, other.spline], [place.piece, other.piece]);
                        let distance = place.moving.point.distance(own.point);
                        return Ok(Some(Meeting { splines, pieces, point, distance }));
                    }
                }
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

impl Inside {
    /// The points of a section that are looked at.
    fn points(&self, &Moving { point, across, normal, .. }: &Moving) -> impl Iterator<Item = Point3> {
        let ([low, high], half) = (self.heights, self.half);
        [low, 0.5 * (low + high), high].into_iter().flat_map(move |height| {
            let side = move |k: i32| half * f64::from(k) / f64::from(ACROSS);
            (-ACROSS..=ACROSS).map(move |k| point + across * side(k) + normal * height)
        })
    }

    /// What a way from the middle of a section goes beyond it, by its frame, along the curve, across and along the normal: 0 where it does not go beyond.
    pub(super) fn beyond(&self, v: Vec3, moving: &Moving, spacing: f64) -> [f64; 3] {
        let slack = SLACK * self.half;
        let [low, high] = self.heights;
        let height = v.dot(moving.normal);
        let along = v.dot(moving.tangent).abs() - NEAR_STEPS * spacing;
        let across = v.dot(moving.across).abs() - self.half - slack;
        [along, across, (low - slack - height).max(height - high - slack)].map(|beyond| beyond.max(0.0))
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
