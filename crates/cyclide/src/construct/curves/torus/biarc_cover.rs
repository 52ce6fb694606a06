//! A smooth curve as G1 arcs within a tolerance: biarcs with its points and tangents, halved until each is near enough. Distances are
//! sampled, not certified.

use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::biarc::{Biarc, BiarcRule};
use crate::curve::Arc;
use crate::error::{Error, Result};

/// Samples on each biarc: four to each of the lobes of its distance from a smooth curve.
const SAMPLES: u32 = 16;

/// The part of the tolerance that sampled distances may use: with four samples to a lobe the largest is missed by 8 % at most.
const SAFETY: f64 = 0.92;

/// Largest turn of the tangent over a biarc, radians.
const TURN: f64 = std::f64::consts::FRAC_PI_2;

/// Most halvings of a piece.
const HALVINGS: u32 = 12;

/// A smooth piece of a curve.
pub(super) trait SmoothPiece {
    /// The point at a parameter.
    fn point(&self, s: f64) -> Point3;

    /// Point and unit tangent; `None` where there is no direction.
    fn directed(&self, s: f64) -> Option<(Point3, Vec3)>;
}

/// Appends arcs for the part `[from, to]` of a piece with this number.
///
/// # Errors
/// `too-many-pieces`.
pub(super) fn append_biarcs(
    piece: &dyn SmoothPiece,
    number: usize,
    [from, to]: [f64; 2],
    tolerance: f64,
    arcs: &mut Vec<Arc>,
) -> Result<()> {
    let mut ahead = vec![([from, to], HALVINGS)];
    while let Some(([from, to], halvings)) = ahead.pop() {
        if let Some(biarc) = biarc_within(piece, [from, to], SAFETY * tolerance) {
            arcs.extend(biarc.arcs());
            continue;
        }
        let Some(halvings) = halvings.checked_sub(1) else {
            let cap = 1_usize << HALVINGS;
            let (needed, remedy) = ((cap + 1) as f64, "use a larger tolerance");
            return Err(Error::TooManyPieces { what: "piece", segment: Some(number), needed, cap, remedy });
        };
        let middle = 0.5 * (from + to);
        ahead.extend([([middle, to], halvings), ([from, middle], halvings)]);
    }
    Ok(())
}

fn biarc_within(piece: &dyn SmoothPiece, [from, to]: [f64; 2], limit: f64) -> Option<Biarc> {
    let [start, middle, end] = [from, 0.5 * (from + to), to].map(|s| piece.directed(s));
    let ((p0, t0), (_, tm), (p1, t1)) = (start?, middle?, end?);
    if t0.angle(tm) + tm.angle(t1) > TURN {
        return None;
    }
    let biarc = Biarc::new(p0, t0, p1, t1, BiarcRule::EqualD).ok()?;
    let near = |k: u32| {
        let p = piece.point(from + (to - from) * (f64::from(k) / f64::from(SAMPLES)));
        biarc.arcs().iter().any(|arc| arc.closest_point(p).distance <= limit)
    };
    (1..SAMPLES).all(near).then_some(biarc)
}
