//! A spline on a torus as G1 arcs within a tolerance, for formats that know arcs only.
//!
//! Pieces that are arcs of circles stay as they are. The others are covered by biarcs with the points and tangents of the curve, halved
//! until each is within the tolerance; distances are sampled, not certified.

use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::biarc::{Biarc, BiarcRule};
use crate::curve::{Arc, Correspondence, CurvePlace, ParamCurve as _, Span};
use crate::error::{Error, Result};
use crate::surface::TorusSpline;

/// Samples on each biarc: four to each of the lobes of its distance from a smooth curve.
const SAMPLES: u32 = 16;

/// The part of the tolerance that sampled distances may use: with four samples to a lobe the largest is missed by 8 % at most.
const SAFETY: f64 = 0.92;

/// Largest turn of the tangent over a biarc, radians.
const TURN: f64 = std::f64::consts::FRAC_PI_2;

/// Most halvings of a piece.
const HALVINGS: u32 = 12;

/// The part of a piece that a biarc is to cover.
#[derive(Clone, Copy)]
struct Stretch {
    piece: usize,
    from: f64,
    to: f64,
    halvings: u32,
}

impl TorusSpline {
    /// The curve as arcs, G1 where it is, within `tolerance` of it (sampled); true if all its pieces are arcs: then they are exact.
    pub(crate) fn g1_arcs(&self, tolerance: f64) -> Result<(Vec<Arc>, bool, Correspondence)> {
        let (mut arcs, mut exact) = (Vec::new(), true);
        let mut parts = Correspondence::from_start(Vec::new());
        for piece in 0..self.pieces().len() {
            let before = arcs.len();
            if self.pieces()[piece].degree() == 2 {
                let (start, end) = (self.piece_jet(piece, 0.0), self.piece_point(piece, 1.0));
                arcs.push(Arc::from_start_tangent(start.point, end, start.d1)?);
            } else {
                exact = false;
                self.append_biarcs(piece, tolerance, &mut arcs)?;
            }
            parts.spans.push(Span { pieces: arcs.len() - before, end: CurvePlace::after(piece) });
        }
        Ok((arcs, exact, parts))
    }

    fn append_biarcs(&self, piece: usize, tolerance: f64, arcs: &mut Vec<Arc>) -> Result<()> {
        let mut ahead = vec![Stretch { piece, from: 0.0, to: 1.0, halvings: HALVINGS }];
        while let Some(stretch) = ahead.pop() {
            if let Some(biarc) = self.biarc_within(stretch, SAFETY * tolerance) {
                arcs.extend(biarc.arcs());
                continue;
            }
            let Some(halvings) = stretch.halvings.checked_sub(1) else {
                let cap = 1_usize << HALVINGS;
                return Err(Error::TooManyPieces {
                    what: "piece",
                    segment: Some(piece),
                    needed: (cap + 1) as f64,
                    cap,
                    remedy: "use a larger tolerance",
                });
            };
            let middle = 0.5 * (stretch.from + stretch.to);
            ahead.push(Stretch { from: middle, halvings, ..stretch });
            ahead.push(Stretch { to: middle, halvings, ..stretch });
        }
        Ok(())
    }

    fn biarc_within(&self, stretch: Stretch, limit: f64) -> Option<Biarc> {
        let Stretch { piece, from, to, .. } = stretch;
        let end = |s: f64| -> Option<(Point3, Vec3)> {
            let jet = self.piece_jet(piece, s);
            Some((jet.point, jet.tangent()?))
        };
        let ((p0, t0), (_, tm), (p1, t1)) = (end(from)?, end(0.5 * (from + to))?, end(to)?);
        if t0.angle(tm) + tm.angle(t1) > TURN {
            return None;
        }
        let biarc = Biarc::new(p0, t0, p1, t1, BiarcRule::EqualD).ok()?;
        let near = |k: u32| {
            let p = self.piece_point(piece, from + (to - from) * (f64::from(k) / f64::from(SAMPLES)));
            biarc.arcs().iter().any(|arc| arc.closest_point(p).distance <= limit)
        };
        (1..SAMPLES).all(near).then_some(biarc)
    }
}
