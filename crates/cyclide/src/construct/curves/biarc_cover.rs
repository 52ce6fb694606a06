//! A smooth curve as G1 arcs within a tolerance: biarcs with its points and tangents, halved until each is near enough, the curve to
//! the arcs and the arcs to the curve. Distances are sampled, not certified, but over parts that are proved not to turn back where the
//! piece has a hull: a loop between two samples would be left out. A cusp within the curve, which no biarc passes, gets a segment about it
//! that is shorter than the tolerance.

use super::biarc::{Biarc, BiarcRule};
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ParamCurve, PieceHull};
use crate::error::{NumberError, Result};

/// Samples on each biarc: four to each of the lobes of its distance from a smooth curve.
const SAMPLES: u32 = 16;

/// The part of the tolerance that sampled distances may use: with four samples to a lobe the largest is missed by 8 % at most.
const SAFETY: f64 = 0.92;

/// Largest turn of the tangent over a biarc, radians.
const TURN: f64 = std::f64::consts::FRAC_PI_2;

/// Steps from the nearest sample to the foot of a point: each squares what is missing but for the part that curvature has.
const FOOT_STEPS: u32 = 3;

/// Most biarcs of a piece, and most halvings: next to infinity or a common zero of its pairs a curve runs most of its way in a tiny
/// range of the parameter.
const MOST_BIARCS: usize = 4096;
const HALVINGS: u32 = 40;

/// A smooth piece of a curve.
pub(super) trait SmoothPiece {
    /// The point at a parameter.
    fn point(&self, s: f64) -> Point3;

    /// Point and velocity, or another vector in the direction of travel where that vanishes at an end of the piece.
    fn moving(&self, s: f64) -> (Point3, Vec3);

    /// What proves that parts do not turn back, if there is anything; within `tolerance` of the piece.
    fn hull(&self, _tolerance: f64) -> Option<PieceHull> {
        None
    }
}

/// A piece of a curve, by its number.
#[derive(Debug)]
pub(super) struct PieceOf<'a>(pub(super) &'a dyn ParamCurve, pub(super) usize);

impl SmoothPiece for PieceOf<'_> {
    fn point(&self, s: f64) -> Point3 {
        self.0.piece_point(self.1, s)
    }

    fn moving(&self, s: f64) -> (Point3, Vec3) {
        let jet = self.0.piece_jet(self.1, s);
        let side = if s < 0.5 { 1.0 } else { -1.0 };
        let moves = jet.d1 != Vec3::ZERO;
        (jet.point, if moves { jet.d1 } else { jet.limit_tangent(side).unwrap_or(Vec3::ZERO) })
    }

    fn hull(&self, tolerance: f64) -> Option<PieceHull> {
        self.0.piece_hull(self.1, tolerance).ok()
    }
}

/// The part of the tolerance that is used where the piece has a cusp: next to it the lobes of distances are uneven, and samples miss more of them
/// (measured: 18 %).
const SAFETY_AT_CUSPS: f64 = 0.5;

/// Appends arcs for the part `[from, to]` of a piece with this number.
///
/// # Errors
/// `too-many-pieces`.
pub(super) fn append_biarcs(
    piece: &dyn SmoothPiece,
    number: usize,
    range: [f64; 2],
    tolerance: f64,
    arcs: &mut Vec<Arc>,
) -> Result<()> {
    let mut cover = biarcs_within(piece, range, SAFETY * tolerance, false);
    if cover.is_none() {
        cover = biarcs_within(piece, range, SAFETY_AT_CUSPS * tolerance, true);
    }
    let cap = MOST_BIARCS;
    let (needed, remedy) = ((cap + 1) as f64, "use a larger tolerance");
    arcs.extend(cover.ok_or(NumberError::TooManyPieces {
        what: "piece",
        segment: Some(number),
        needed,
        cap,
        remedy,
    })?);
    Ok(())
}

/// Biarcs over a part of a piece, and segments about its cusps if it may have some; `None` if halvings do not do.
fn biarcs_within(piece: &dyn SmoothPiece, range: [f64; 2], limit: f64, cusps: bool) -> Option<Vec<Arc>> {
    let mut hull = piece.hull(limit);
    let (mut arcs, mut ahead) = (Vec::new(), vec![(range, HALVINGS)]);
    while let Some(([from, to], halvings)) = ahead.pop() {
        let biarc = biarc_within(piece, [from, to], limit, hull.as_mut());
        let segment = || if cusps { segment_within(piece, [from, to], limit) } else { None };
        if let Some(biarc) = biarc {
            arcs.extend(biarc.arcs());
        } else if let Some(segment) = segment() {
            arcs.extend(segment);
        } else if halvings > 0 {
            let middle = 0.5 * (from + to);
            ahead.extend([([middle, to], halvings - 1), ([from, middle], halvings - 1)]);
        } else {
            return None;
        }
        if arcs.len() > 2 * MOST_BIARCS {
            return None;
        }
    }
    Some(arcs)
}

/// The segment in place of a part that turns back, as at a cusp, if all of it is near its start: then it is as near to the segment, and the segment to it. No
/// segment where both ends are one point.
fn segment_within(piece: &dyn SmoothPiece, [from, to]: [f64; 2], limit: f64) -> Option<Option<Arc>> {
    // The points that biarcs on both sides start and end with.
    let [start, end] = [from, to].map(|s| piece.moving(s).0);
    let place = |k: u32| piece.point(from + (to - from) * (f64::from(k) / f64::from(SAMPLES)));
    let is_near = (0..=SAMPLES).all(|k| place(k).distance(start) <= limit);
    match is_near {
        true if start == end => Some(None),
        true => Arc::segment(start, end).ok().map(Some),
        false => None,
    }
}

fn biarc_within(
    piece: &dyn SmoothPiece,
    [from, to]: [f64; 2],
    limit: f64,
    hull: Option<&mut PieceHull>,
) -> Option<Biarc> {
    let directed = |s: f64| {
        let (point, velocity) = piece.moving(s);
        Some((point, velocity.unit()?))
    };
    let [start, middle, end] = [from, 0.5 * (from + to), to].map(directed);
    let ((p0, t0), (_, tm), (p1, t1)) = (start?, middle?, end?);
    if t0.angle(tm) + tm.angle(t1) > TURN {
        return None;
    }
    // What is all within the limit of its chord may turn back.
    if hull.is_some_and(|hull| !hull.advances([from, to], p1 - p0) && hull.deviation([from, to], [p0, p1]) > limit) {
        return None;
    }
    let biarc = Biarc::new(p0, t0, p1, t1, BiarcRule::EqualD).ok()?;
    let places: Vec<f64> = (0..=SAMPLES).map(|k| from + (to - from) * (f64::from(k) / f64::from(SAMPLES))).collect();
    let samples: Vec<(f64, Point3)> = places.into_iter().map(|s| (s, piece.point(s))).collect();
    let near_arcs = |p: Point3| biarc.arcs().iter().any(|arc| arc.closest_point(p).distance <= limit);
    let near_curve = |p: Point3| distance_from(piece, &samples, p) <= limit;
    let arcs = biarc.arcs();
    let all_near = samples.iter().all(|(_, p)| near_arcs(*p));
    (all_near
        && arcs
            .iter()
            .all(|arc| (1..SAMPLES / 2).all(|k| near_curve(arc.point(f64::from(2 * k) / f64::from(SAMPLES))))))
    .then_some(biarc)
}

/// Distance of a point from the part of a piece that has these samples: from the nearest one along the velocity to its foot.
fn distance_from(piece: &dyn SmoothPiece, samples: &[(f64, Point3)], p: Point3) -> f64 {
    let nearest = samples.iter().min_by(|(_, a), (_, b)| a.distance(p).total_cmp(&b.distance(p)));
    let (Some((mut s, mut q)), Some((from, _)), Some((to, _))) = (nearest.copied(), samples.first(), samples.last())
    else {
        return f64::INFINITY;
    };
    let mut distance = q.distance(p);
    for _ in 0..FOOT_STEPS {
        let velocity = piece.moving(s).1;
        s = (s + (p - q).dot(velocity) / velocity.dot(velocity).max(f64::MIN_POSITIVE)).clamp(*from, *to);
        q = piece.point(s);
        distance = distance.min(q.distance(p));
    }
    distance
}
