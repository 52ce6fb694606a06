//! How evenly a curve bends: changes of side, extrema and variation of its curvature.
//!
//! Planar curves are measured by their signed curvature in their plane, curves in space by its size, which has no sign
//! to change. With `k` the curvature and `s` the arc length (`docs/math/curve-measures.md#fairness`):
//!
//! - *sign changes*: places where the curve goes from turning left to turning right or back;
//! - *extrema*: places where `k` stops growing or falling, the ends of an open curve not counted;
//! - *variation*: `L³ ∫ k'² ds`, which does not depend on the size of the curve; and the total variation `∫ |k'| ds`.
//!
//! A curve is cut at its corners (tangents that differ by more than [`CORNER_ANGLE`]), and each run between two of
//! them is counted for itself. At the other joints the curvature may jump, as it does where arcs meet: a jump is
//! counted as the change that it is, but no finite variation belongs to it.
//!
//! **Noise.** A swing of the curvature counts if it is larger than `1e-9` of the largest curvature of the curve and
//! than what rounding of the coordinates can make: `64 eps (1 + M/d)/d` on a piece with the chord `d` at coordinates of
//! the size `M` (a node off by `eps M` turns the chords by `eps M/d`). Lines and circles have no extrema therefore, and
//! arcs of one circle in a chain are one bend.
//!
//! Each piece is sampled at nine places or, where its curvature does not look like a cubic between them or Boole's rule
//! for the variation disagrees with Simpson's, at more: twelve halvings at most.

mod bends;
mod piece;
mod plane;
mod swings;
mod wavering;

use super::length::length;
use crate::curve::ParamCurve;
use piece::{Measure, Piece};
use plane::plane_of;
use swings::{Course, Swing, course};

pub use plane::plane_normal;
pub use wavering::{RoundedTurns, Wavering, wavering, wavering_against};

/// Tangents that differ by more than this, in radians, make a joint a corner.
///
/// ```
/// assert!(cyclide::curve::CORNER_ANGLE > 0.0 && cyclide::curve::CORNER_ANGLE < std::f64::consts::PI);
/// ```
pub const CORNER_ANGLE: f64 = 1e-3;
/// Swings of the curvature below this part of the largest one do not count.
const NOISE: f64 = 1e-9;

/// How evenly a curve bends.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Circle, fairness}};
/// let measured = fairness(&Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?);
/// assert_eq!((measured.extrema, measured.corners, measured.jumps), (0, 0, 0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Fairness {
    /// Changes between turning left and turning right; `None` for a curve that leaves every plane.
    pub sign_changes: Option<usize>,
    /// Extrema of the curvature, ends not counted: of its size for a curve in space.
    pub extrema: usize,
    /// `L³ ∫ k'² ds`, to about 1e-4 of itself; `None` where the curvature jumps or has no bound.
    pub variation: Option<f64>,
    /// `∫ |k'| ds`, jumps included, in 1/length; infinite where the curvature has no bound.
    pub total_variation: f64,
    /// Joints, corners excepted, at which the curvature jumps.
    pub jumps: usize,
    /// Joints that turn, or at which the curve is not connected, and cusps.
    pub corners: usize,
    /// Places without a bound on the curvature.
    pub cusps: usize,
}

impl Fairness {
    /// What a curve without extent has.
    const NOTHING: Self = Self {
        sign_changes: Some(0),
        extrema: 0,
        variation: Some(0.0),
        total_variation: 0.0,
        jumps: 0,
        corners: 0,
        cusps: 0,
    };
}

/// Measures how evenly a curve bends. Linear in the number of pieces.
///
/// ```
/// use cyclide::{Point3, curve::ArcPath};
/// let bend = [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [9.0, 9.0, 0.0]].map(Point3::from);
/// let path = ArcPath::rounded_polyline(&bend, false, &[0.0, 2.0, 0.0])?;
/// assert_eq!(cyclide::curve::fairness(&path).jumps, 2);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn fairness(curve: &dyn ParamCurve) -> Fairness {
    let total = length(curve);
    if !(total > 0.0 && total.is_finite()) {
        return Fairness::NOTHING;
    }
    let plane = plane_of(curve);
    let measure = Measure { curve, length: total, normal: plane };
    let pieces: Vec<Piece> = (0..curve.piece_count()).filter_map(|i| measure.piece(i)).collect();
    let largest = pieces.iter().map(Piece::largest).fold(0.0, f64::max);
    let (runs, counts) = runs(&pieces, largest, curve.is_closed());
    let mut found = Fairness { sign_changes: plane.map(|_| 0), variation: None, ..counts };
    for run in &runs {
        let Course { sign_changes, extrema, total_variation } = run.course(&pieces, NOISE * largest);
        found.extrema += extrema;
        found.total_variation += total_variation / total;
        found.sign_changes = found.sign_changes.map(|n| n + sign_changes);
    }
    if found.jumps == 0 && found.cusps == 0 {
        found.variation = Some(measure.variation(&pieces, largest));
    }
    if found.cusps > 0 {
        found.total_variation = f64::INFINITY;
    }
    found
}

/// How two pieces meet.
enum Meeting {
    Smooth,
    Jump,
    Corner,
}

/// Pieces between two corners or cusps.
struct Run {
    first: usize,
    count: usize,
    /// True if the end of the last piece is the start of the first.
    closed: bool,
}

impl Run {
    /// How its curvature swings, where swings below `least` do not count.
    fn course(&self, pieces: &[Piece], least: f64) -> Course {
        let walk = |push: &mut dyn FnMut(Swing)| {
            let own = (self.first..self.first + self.count).map(|i| &pieces[i % pieces.len()]);
            own.for_each(|piece| piece.each_swing(least, push));
        };
        course(walk, self.closed)
    }
}

/// The smooth runs of a curve, and the joints between and in them.
fn runs(pieces: &[Piece], largest: f64, closed: bool) -> (Vec<Run>, Fairness) {
    let mut counts = Fairness { sign_changes: None, variation: None, ..Fairness::NOTHING };
    let n = pieces.len();
    let meeting = |i: usize| meeting(&pieces[(i + n - 1) % n], &pieces[i], largest);
    let cut =
        |i: usize| matches!(meeting(i), Meeting::Corner) || pieces[i].is_cusp() || pieces[(i + n - 1) % n].is_cusp();
    // A closed curve is walked from its first corner on; without one it is one run that closes.
    let first = if closed { (0..n).find(|&i| cut(i)) } else { Some(0) };
    let start = first.unwrap_or(0);
    let mut runs: Vec<Run> = Vec::new();
    for step in 0..n {
        let i = (start + step) % n;
        let piece = &pieces[i];
        let joint = step > 0 || closed;
        let cut = joint && cut(i);
        counts.corners += usize::from(cut && !piece.is_cusp());
        counts.cusps += usize::from(piece.is_cusp());
        counts.jumps += usize::from(joint && !cut && matches!(meeting(i), Meeting::Jump));
        if piece.is_cusp() {
            continue;
        }
        if runs.is_empty() || cut {
            runs.push(Run { first: i, count: 0, closed: false });
        }
        if let Some(run) = runs.last_mut() {
            run.count += 1;
        }
    }
    if let (true, None, [only]) = (closed, first, runs.as_mut_slice()) {
        only.closed = true;
    }
    (runs, counts)
}

fn meeting(before: &Piece, after: &Piece, largest: f64) -> Meeting {
    let (a, b) = (before.end(), after.start());
    let floor = before.rounding().max(after.rounding()).max(NOISE * largest).max(a.noise).max(b.noise);
    let gap = a.point.distance(b.point);
    if gap > 1e-9 * before.chord().min(after.chord()) || a.tangent.angle(b.tangent) > CORNER_ANGLE {
        Meeting::Corner
    } else if (a.curvature - b.curvature).length() > floor {
        Meeting::Jump
    } else {
        Meeting::Smooth
    }
}
