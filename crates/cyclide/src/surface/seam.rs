//! Seams: opposite borders of an open grid that lie on each other, as where a tube was cut open.

use super::net::CyclidicNet;
use super::param_surface::ParamSurface as _;
use super::patch::CyclidePatch;
use super::quad_grid::QuadGrid;
use crate::base::vector::Vec3;
use crate::curve::Arc;

/// Samples along each edge of a seam, both ends included.
const SAMPLES: usize = 9;
/// A direction of fewer quads cannot bend back on itself.
const FEWEST_QUADS: usize = 3;
/// A border shorter than this part of the lines that end there is one point.
const POINT: f64 = 1e-9;

/// Two opposite borders of an open grid that nearly coincide: the first and the last vertices of an open direction.
///
/// ```
/// use cyclide::surface::{CyclidicNet, DupinCyclide, NetFrame, QuadGrid};
/// let ring = DupinCyclide::new(4.0, 1.0, 2.0)?.nets([8, 8])?.remove(0);
/// // Cut open along s: the first column once more at the end.
/// let points = (0..9 * 8).map(|k| ring.grid().point(k % 9, k / 9)).collect();
/// let [v1, v2, _] = ring.frame();
/// let open = CyclidicNet::new(QuadGrid::new(points, [9, 8], [false, true])?, NetFrame::First(v1, v2))?;
/// assert_eq!(open.grid().seams()[0].direction, 0);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Seam {
    /// The open direction across the seam: 0 if it joins the first column (s = 0) and the last, 1 if the first row (t = 0)
    /// and the last.
    pub direction: usize,
    /// True if the borders run in opposite directions, as in a Möbius strip.
    pub reversed: bool,
}

/// What was measured along a seam.
///
/// ```
/// use cyclide::surface::{CyclidicNet, DupinCyclide, NetFrame, QuadGrid};
/// let ring = DupinCyclide::new(4.0, 1.0, 2.0)?.nets([8, 8])?.remove(0);
/// let points = (0..9 * 8).map(|k| ring.grid().point(k % 9, k / 9)).collect();
/// let [v1, v2, _] = ring.frame();
/// let open = CyclidicNet::new(QuadGrid::new(points, [9, 8], [false, true])?, NetFrame::First(v1, v2))?;
/// let measure = open.measure_seam(open.grid().seams()[0]).expect("its borders are beside each other");
/// assert!(measure.gap < 1e-12 && measure.angle < 1e-6); // it could be closed
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SeamMeasure {
    /// Largest distance of a point of one border from the other one.
    pub gap: f64,
    /// Largest angle between the normals there, radians; that of a Möbius strip to the normal turned round.
    pub angle: f64,
}

impl QuadGrid {
    /// Opposite borders at most an edge apart: at every vertex the distance to the one opposite is not longer than the mean of
    /// the two edges that lead to them along the direction across. Three quads at least are between them.
    #[must_use]
    pub fn seams(&self) -> Vec<Seam> {
        let both = [false, true].map(|reversed| [0, 1].map(|direction| Seam { direction, reversed }));
        let [straight, reversed] = both;
        let mut found: Vec<Seam> = straight.into_iter().filter(|seam| self.has_seam(*seam)).collect();
        for seam in reversed {
            if found.iter().all(|other| other.direction != seam.direction) && self.has_seam(seam) {
                found.push(seam);
            }
        }
        found
    }

    fn has_seam(&self, seam: Seam) -> bool {
        let (d, across) = (seam.direction, 1 - seam.direction);
        let (last, lines) = (self.size()[d] - 1, self.size()[across]);
        if !self.is_whole()
            || self.closed()[d]
            || self.quads()[d] < FEWEST_QUADS
            || (seam.reversed && self.closed()[across])
        {
            return false;
        }
        let at = |k: usize, line: usize| if d == 0 { self.point(k, line) } else { self.point(line, k) };
        // A border that is one point, the node of a cyclide, is none.
        let border: f64 = (1..lines).map(|line| at(0, line - 1).distance(at(0, line))).sum();
        let line: f64 = (0..last).map(|k| at(k, 0).distance(at(k + 1, 0))).sum();
        let is_line = border > POINT * line;
        is_line
            && (0..lines).all(|line| {
                let opposite = if seam.reversed { lines - 1 - line } else { line };
                let edges = at(0, line).distance(at(1, line)) + at(last, opposite).distance(at(last - 1, opposite));
                at(0, line).distance(at(last, opposite)) <= 0.5 * edges
            })
    }
}

impl CyclidicNet {
    /// How far the borders of a seam are apart and at which angle the surface meets itself there. `None` if the net has no
    /// such borders.
    #[must_use]
    pub fn measure_seam(&self, seam: Seam) -> Option<SeamMeasure> {
        let (d, across) = (seam.direction, 1 - seam.direction);
        let (last, lines) = (self.size().get(d)?.checked_sub(1)?, self.size()[across]);
        if self.grid().closed()[d] || !self.grid().is_whole() {
            return None;
        }
        let patch = |k: usize, line: usize| if d == 0 { self.patch(k, line) } else { self.patch(line, k) };
        let mut measure = SeamMeasure { gap: 0.0, angle: 0.0 };
        for line in 0..lines {
            let opposite = if seam.reversed { lines - 1 - line } else { line };
            let sides =
                [Side { patch: patch(0, line), d, end: 0.0 }, Side { patch: patch(last, opposite), d, end: 1.0 }];
            for (from, to) in [(&sides[0], &sides[1]), (&sides[1], &sides[0])] {
                let Some((gap, angle)) = from.apart(to, seam.reversed) else { continue };
                measure.gap = measure.gap.max(gap);
                measure.angle = measure.angle.max(angle);
            }
        }
        Some(measure)
    }
}

/// A side of a patch on the seam: `end` of the direction across.
struct Side {
    patch: CyclidePatch,
    d: usize,
    end: f64,
}

impl Side {
    /// Largest distance from the other side and angle to the normals there. `None` if that is one point.
    fn apart(&self, other: &Self, reversed: bool) -> Option<(f64, f64)> {
        let arc = other.arc()?;
        let (mut gap, mut angle) = (0.0_f64, 0.0_f64);
        for i in 0..SAMPLES {
            let x = i as f64 / (SAMPLES - 1) as f64;
            let (s, t) = self.place(x);
            let nearest = arc.closest_point(self.patch.point(s, t));
            gap = gap.max(nearest.distance);
            let normal = other.normal(nearest.t);
            angle = angle.max(self.normal(x).angle(if reversed { -normal } else { normal }));
        }
        Some((gap, angle))
    }

    fn place(&self, x: f64) -> (f64, f64) {
        if self.d == 0 { (self.end, x) } else { (x, self.end) }
    }

    fn normal(&self, x: f64) -> Vec3 {
        let (s, t) = self.place(x);
        self.patch.normal(s, t).unwrap_or_default()
    }

    fn arc(&self) -> Option<Arc> {
        if self.d == 0 { self.patch.t_line(self.end).ok() } else { self.patch.s_line(self.end).ok() }
    }
}
