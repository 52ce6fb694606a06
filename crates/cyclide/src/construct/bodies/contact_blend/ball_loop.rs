//! The loop of contacts round a tube: exact on a plane, on a sphere refined until the radius of the balls is within its tolerance
//! (`docs/math/contact-blends.md#the-loop`).

use super::piece::{Heights, Piece};
use super::setup::{Base, Setup};
use crate::base::vector::Vec3;
use crate::construct::bodies::halving::Halving;
use crate::error::{NurbsError, Result};
use crate::rational::Polynomial;

/// Pieces of a loop at most, and the least turn of a span that is halved, in radians.
const HALVING: Halving = Halving { what: "the blend", cap: 2048, least: 1e-6, remedy: "use a larger tolerance" };
/// An arc of a circle in one face turns by no more than this, in radians; beyond half a turn its weights are not positive.
const LARGEST_ARC: f64 = super::super::LARGEST_ARC;
/// Bands of a blend side by side at most.
const MOST_BANDS: usize = 4;

/// The loop, once round the tube.
pub(super) struct BallLoop {
    pub(super) pieces: Vec<Piece>,
    /// For each of the angles that were asked for the piece that starts there.
    pub(super) starts: Vec<usize>,
    /// The least and the largest radius, proved.
    pub(super) radii: [f64; 2],
    /// Into how many bands the arcs of the blend are cut.
    pub(super) bands: usize,
}

impl BallLoop {
    /// The loop with nodes at these angles, rising and within one turn, and others between.
    ///
    /// # Errors
    /// `contact-loop-open`, `too-many-pieces`.
    pub(super) fn new(setup: &Setup, angles: &[f64], tolerance: f64) -> Result<Self> {
        let mut made =
            Self { pieces: Vec::new(), starts: Vec::new(), radii: [f64::INFINITY, f64::NEG_INFINITY], bands: 1 };
        let turn = angles.first().map(|first| first + std::f64::consts::TAU);
        for ends in angles.iter().copied().chain(turn).collect::<Vec<_>>().windows(2) {
            made.starts.push(made.pieces.len());
            HALVING.extend(&mut made.pieces, [ends[0], ends[1]], |part| {
                let pieces = span(setup, part)?;
                let Some([low, high]) = radii_within(setup, &pieces, tolerance) else { return Ok(None) };
                made.radii = [made.radii[0].min(low), made.radii[1].max(high)];
                Ok(Some(pieces))
            })?;
        }
        made.take_shorter_arcs();
        made.bands = made.bands_needed()?;
        Ok(made)
    }

    /// The arcs are the shorter ones on most of the loop; which of both keeps on round it.
    fn take_shorter_arcs(&mut self) {
        let shorter = |piece: &&Piece| {
            let [a, b] = piece.canal.turns().each_ref().map(|turn| turn.value(0.5));
            a.dot(b) > 0.0
        };
        if 2 * self.pieces.iter().filter(shorter).count() < self.pieces.len() {
            for piece in &mut self.pieces {
                piece.canal = piece.canal.clone().with_other_arcs();
            }
        }
    }

    /// # Errors
    /// `weight-not-positive`.
    fn bands_needed(&self) -> Result<usize> {
        let angle =
            |piece: &Piece, s: f64| piece.canal.arc_ratio(s).map_or(0.0, |q| 2.0 * q.vector().length().atan2(q.w));
        let widest = self.pieces.iter().flat_map(|piece| [0.0, 0.5].map(|s| angle(piece, s))).fold(0.0, f64::max);
        let mut bands = (widest / LARGEST_ARC).ceil().max(1.0) as usize;
        for (index, piece) in self.pieces.iter().enumerate() {
            let whole = piece.canal.to_rational()?;
            let positive =
                |bands: usize| (0..bands).all(|k| whole.part([0.0, 1.0], part(k, bands)).has_positive_weights());
            while !positive(bands) {
                bands += 1;
                if bands > MOST_BANDS {
                    let weight = whole.rows().iter().map(|row| row[3]).fold(f64::INFINITY, f64::min);
                    return Err(NurbsError::WeightNotPositive { index, weight }.into());
                }
            }
        }
        Ok(bands)
    }

    /// The mean of the second normals, a direction.
    pub(super) fn mean_normal(&self) -> Vec3 {
        let sum = self.pieces.iter().fold(Vec3::ZERO, |sum, piece| {
            sum + (piece.second_normal(0.0) + piece.second_normal(0.5)) * (piece.ends[1] - piece.ends[0])
        });
        sum.unit().unwrap_or(Vec3::Z)
    }
}

/// Part k of the arcs.
pub(super) fn part(k: usize, count: usize) -> [f64; 2] {
    [k as f64 / count as f64, (k + 1) as f64 / count as f64]
}

/// The pieces between two angles: one where contacts are exact, two with one tangent where they are those of the ball at both ends.
fn span(setup: &Setup, [from, to]: [f64; 2]) -> Result<Vec<Piece>> {
    let [[z0, d0], [z1, d1]] = [setup.height(from)?, setup.height(to)?];
    if setup.is_level() {
        return Ok(vec![Piece::new(setup, [from, to], Heights::Level(z0))]);
    }
    match setup.base {
        Base::Plane(normal) => Ok(vec![Piece::new(setup, [from, to], on_plane(setup, normal, [from, to]))]),
        Base::Sphere { e, r } => {
            let middle = 0.5 * (from + to);
            let (sin, cos) = (0.5 * (middle - from)).sin_cos();
            let (first, last) = (z0 * cos + d0 * sin, z1 * cos - d1 * sin);
            let between = (first + last) / (2.0 * cos);
            let piece = |ends: [f64; 2], z: [f64; 3]| {
                Piece::new(setup, ends, Heights::Turning { z: Polynomial::new(z.to_vec()), sphere: [e, r] })
            };
            Ok(vec![piece([from, middle], [z0, first, between]), piece([middle, to], [between, last, z1])])
        }
    }
}

/// The contacts of one ball that rolls over a plane.
fn on_plane(setup: &Setup, [n0, n1]: [f64; 2], [from, to]: [f64; 2]) -> Heights {
    let (from_axis, down) = (setup.center_at_origin(), setup.ball * setup.sigma * setup.sin);
    let middle = 0.5 * (from + to);
    let half = (0.5 * (to - from)).cos();
    // Cosines over the piece, with the weights 1, half, 1.
    let row = |one: f64, cosine: f64| {
        Polynomial::new(vec![one + cosine * from.cos(), one * half + cosine * middle.cos(), one + cosine * to.cos()])
    };
    let z = row(setup.ball + n1 * down, -n0 * from_axis);
    Heights::Quotient { z, d: row(n1, n0 * setup.tan), normal: [n0, n1] }
}

/// The bounds of the radius of the balls, if they are within the tolerance, and if weights along the contacts are positive.
fn radii_within(setup: &Setup, pieces: &[Piece], tolerance: f64) -> Option<[f64; 2]> {
    let mut radii = [f64::INFINITY, f64::NEG_INFINITY];
    for piece in pieces {
        let [low, high] = piece.canal.radius_bounds()?;
        let [a, b] = piece.canal.turns();
        let weight = piece.canal.center().weight();
        let contacts = [a.dot(a), b.dot(b)];
        let positive = contacts.iter().all(|norm| (norm * weight).coefficients().iter().all(|w| *w > 0.0));
        if !(positive && low >= setup.ball - tolerance && high <= setup.ball + tolerance) {
            return None;
        }
        radii = [radii[0].min(low), radii[1].max(high)];
    }
    Some(radii)
}
