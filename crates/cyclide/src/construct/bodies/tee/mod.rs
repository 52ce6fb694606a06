//! Blended pipe tees: a branch that enters a thicker pipe at a right angle, with the canal surface of a rolling ball between them, exact
//! (`docs/math/canal-blends.md#a-branch-that-enters-a-pipe`).

mod body;
mod cylinder_face;
mod law;
mod manifold;
mod skin;

pub use body::PipeTeeBody;
pub use manifold::{Branch, PipeManifold};

use crate::error::{Error, ErrorItem, Result};
use crate::surface::{CanalPatch, CrossingCylinders, CrossingPiece};
use law::RadiusLaw;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

/// Spans in an eighth of a turn that are tried until the radius is within its tolerance.
const SPANS: [usize; 11] = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48];

/// Places in each piece where the radius is compared with its law, and the canal looked at for folds.
const PLACES: u32 = 8;

/// Two knots nearer than this part of a span to each other are one, unless both are given.
const NEAR_KNOTS: f64 = 0.3;

/// A pipe along x through the origin and a thinner branch along z, its axis moved along y, with a blend that a rolling ball envelops: exact canal
/// patches, tangent to both.
///
/// Angles are those of the contact about the axis of the branch, radians, from x towards y.
///
/// ```
/// use cyclide::{PipeTee, PipeTeeBody};
/// let tee = PipeTee::new([2.0, 1.0], 0.0, &[[0.0, 0.4]], 1e-3)?;
/// let body = tee.body(&PipeTeeBody { reach: [5.0, 5.0], height: 5.0, wall: None })?;
/// assert!(body.is_solid() && tee.deviation() <= 1e-3);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct PipeTee {
    pair: CrossingCylinders,
    pieces: Vec<CrossingPiece>,
    /// The angle where each piece begins, in the axes of the pair.
    angles: Vec<f64>,
    /// How many pieces are in each half of the turn, from the plane of both axes on.
    halves: [usize; 2],
    deviation: f64,
    radius_range: [f64; 2],
}

impl PipeTee {
    /// From the radii of pipe and branch, the way along y from one axis to the other, and the radius of the ball at angles `[angle, radius]`: one for a
    /// radius that is constant within the tolerance, several for a law through them that nowhere leaves the range of neighbours.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`, `no-positive-radius`, `tolerance-not-positive`, `too-few-points`, `coincident-points` (angles, also after a
    /// whole turn), `branch-too-wide`, `parameter-out-of-range`, `too-many-pieces` (a tolerance too small), `blend-folds` (the ball is too large for the
    /// bends of its way).
    pub fn new(radii: [f64; 2], offset: f64, stations: &[[f64; 2]], tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0) {
            return Err(Error::ToleranceNotPositive { tolerance });
        }
        let pair = CrossingCylinders::new(radii, -0.5 * offset)?;
        // The angles of the pair are counted from its z, which is -y here, towards x.
        let stations: Vec<[f64; 2]> = stations.iter().map(|[angle, radius]| [angle + FRAC_PI_2, *radius]).collect();
        let law = RadiusLaw::new(&stations)?;
        let mut least = f64::INFINITY;
        for spans in SPANS {
            let tee = Self::with_spans(pair, &law, spans);
            least = least.min(tee.deviation);
            if tee.deviation <= tolerance {
                tee.check_folds(0.0)?;
                return Ok(tee);
            }
        }
        Err(too_many_pieces(least / tolerance))
    }

    fn with_spans(pair: CrossingCylinders, law: &RadiusLaw, spans: usize) -> Self {
        let knots = knots(law, spans);
        let (mut pieces, mut angles, mut halves) = (Vec::new(), Vec::new(), [0; 2]);
        for ends in knots.windows(2) {
            // The chart wants angles from -pi to 0 or from 0 to pi.
            let turned = if ends[0] + ends[1] > TAU { TAU } else { 0.0 };
            let laws = [law.at(ends[0]), law.at(ends[1])];
            pieces.extend(pair.pieces([ends[0] - turned, ends[1] - turned], laws));
            angles.extend([ends[0], 0.5 * (ends[0] + ends[1])]);
            halves[usize::from(turned > 0.0)] += 2;
        }
        let mut tee = Self { pair, pieces, angles, halves, deviation: 0.0, radius_range: [f64::INFINITY, 0.0] };
        tee.measure(law);
        tee
    }

    fn measure(&mut self, law: &RadiusLaw) {
        for (piece, start) in self.pieces.iter().zip(&self.angles) {
            for k in 0..=PLACES {
                let s = f64::from(k) / f64::from(PLACES);
                let radius = piece.patch.ball(s).1;
                self.deviation = self.deviation.max((radius - law.at(start + piece.turned(s))[0]).abs());
            }
            // Where weights are not positive the digits are lost, and so is the claim.
            let [low, high] = piece.patch.radius_bounds().unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
            self.radius_range = [self.radius_range[0].min(low), self.radius_range[1].max(high)];
        }
    }

    /// Refuses balls, larger by a distance, that are too large for the bends of the way of their centres.
    fn check_folds(&self, larger: f64) -> Result<()> {
        for (piece, start) in self.pieces.iter().zip(&self.angles) {
            let patch = piece.patch.offset(larger);
            for k in 0..=PLACES {
                let s = f64::from(k) / f64::from(PLACES);
                let measured = patch.least_jacobian(s);
                if !(measured > 0.0) {
                    let angle = start + piece.turned(s) - FRAC_PI_2;
                    return Err(Error::BlendFolds { angle, radius: patch.ball(s).1, measured });
                }
            }
        }
        Ok(())
    }

    /// The largest difference of the radius from what was asked for, over nine places of each patch.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.deviation
    }

    /// The radius of the ball is everywhere between these.
    #[must_use]
    pub fn radius_range(&self) -> [f64; 2] {
        self.radius_range
    }

    /// The patches of the blend in order of the angle, from the pipe to the branch, in the axes of [`CrossingCylinders`].
    pub fn patches(&self) -> impl ExactSizeIterator<Item = &CanalPatch> {
        self.pieces.iter().map(|piece| &piece.patch)
    }
}

/// So many times the tolerance was left with the most pieces.
fn too_many_pieces(times: f64) -> Error {
    let cap = 16 * SPANS[SPANS.len() - 1];
    let needed = cap as f64 * times.cbrt();
    Error::TooManyPieces { what: "blend", segment: None, needed, cap, remedy: "use a larger tolerance" }
}

/// Knots over a turn from 0: all eighths, so many spans in each, and the stations.
fn knots(law: &RadiusLaw, spans: usize) -> Vec<f64> {
    let n = 8 * spans;
    let step = FRAC_PI_4 / spans as f64;
    let even = (0..=n).map(|k| (TAU * k as f64 / n as f64, k % spans == 0));
    let is_free = |(angle, corner): &(f64, bool)| {
        *corner || law.angles().all(|station| (station - angle).abs() > NEAR_KNOTS * step)
    };
    let mut all: Vec<(f64, bool)> = even.filter(is_free).collect();
    let apart = |angle: f64| move |(knot, _): &(f64, bool)| (knot - angle).abs() > 1e-9;
    let stations: Vec<f64> = law.angles().filter(|angle| all.iter().all(apart(*angle))).collect();
    all.extend(stations.into_iter().map(|angle| (angle, false)));
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(angle, _)| angle).collect()
}

/// Refuses a number that is not finite.
fn check_finite(what: ErrorItem, value: f64) -> Result<()> {
    if value.is_finite() { Ok(()) } else { Err(Error::NotFinite { what, index: 0 }) }
}
