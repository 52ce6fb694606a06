//! The point from which the whole of a profile is seen in its half plane, for end faces that all go to it: ruled from there to the pieces,
//! with three sides, and none of these cut.
//!
//! A point `c` sees the whole of a closed curve, strictly, if it is on the inner side of all its tangents; the rulings to it cross the curve nowhere else
//! then and follow each other round.

use super::profile::Profile;
use super::{PLACES, Revolution};
use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve as _;

/// The point is farther from all tangents than this part of the size: nearer to them faces would be needles.
const INSIDE: f64 = 1e-3;
/// Steps in which it is looked for, and by what part each is shorter than the one before.
const STEPS: u32 = 1000;
const SHORTER: f64 = 0.99;

/// A place of a profile in its half plane (distance from the axis, height) and the direction there.
struct Place {
    at: [f64; 2],
    along: [f64; 2],
}

impl Place {
    /// How far a point is to the left of the tangent.
    fn left(&self, c: [f64; 2]) -> f64 {
        self.along[0] * (c[1] - self.at[1]) - self.along[1] * (c[0] - self.at[0])
    }
}

/// The point in the half plane `outwards` of a profile that goes round an area, from which the whole of it is seen, if there is one.
pub(super) fn of(turn: &Revolution, profile: &Profile, outwards: Vec3) -> Option<Point3> {
    let places = places(turn, profile, outwards)?;
    let next = |k: usize| places[(k + 1) % places.len()].at;
    let area: f64 = (0..places.len()).map(|k| places[k].at[0] * next(k)[1] - places[k].at[1] * next(k)[0]).sum();
    let sign = if area > 0.0 { 1.0 } else { -1.0 };
    let count = places.len() as f64;
    let mut c = [0, 1].map(|d: usize| places.iter().map(|place| place.at[d]).sum::<f64>() / count);
    let mut best = (f64::NEG_INFINITY, c);
    let mut step = 0.5 * profile.size;
    for _ in 0..STEPS {
        // Away from the tangent that is nearest, or that it is farthest outside of.
        let worst = places.iter().min_by(|a, b| (sign * a.left(c)).total_cmp(&(sign * b.left(c))))?;
        let inside = sign * worst.left(c);
        if inside > best.0 {
            best = (inside, c);
        }
        c = [c[0] - sign * step * worst.along[1], c[1] + sign * step * worst.along[0]];
        step *= SHORTER;
    }
    let (inside, [distance, height]) = best;
    (inside > INSIDE * profile.size).then(|| turn.origin + outwards * distance + turn.axis * height)
}

/// Places all along a profile, the side along the axis among them.
fn places(turn: &Revolution, profile: &Profile, outwards: Vec3) -> Option<Vec<Place>> {
    let mut places = Vec::new();
    for piece in &profile.pieces {
        for k in 0..=PLACES {
            let jet = piece.curve.piece_jet(0, f64::from(k) / f64::from(PLACES));
            let way = turn.way_off_axis(jet.point);
            let at = [way.dot(outwards), turn.height(jet.point)];
            let Some(along) = jet.d1.unit() else { continue };
            places.push(Place { at, along: [along.dot(outwards), along.dot(turn.axis)] });
        }
    }
    if !profile.closed {
        let [from, to] = [places.last()?.at, places.first()?.at];
        let along = [0.0, if to[1] > from[1] { 1.0 } else { -1.0 }];
        places.extend([from, to].map(|at| Place { at, along }));
    }
    Some(places)
}
