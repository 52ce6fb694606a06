//! The net of a circular grid and one frame (`docs/math/cyclides-and-nets.md#frames-and-weights-of-a-net`; A. Bobenko
//! and E. Huhnen-Venedey).
//!
//! Along an edge with unit chord `d`, in direction `k`, the weight goes on by `w -> d^-1 w V_k` and with it the frame
//! by reflection in the plane half way, the forward direction kept forward. Round an embedded
//! circular quad this comes back up to a positive real factor, which the lengths take up:
//! `|w3| = |w1| |w2| / |w0| · delta_12/delta_03`.

use super::ways::Way;
use super::{CyclidicNet, NetFrame, frame};
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, PatchError, Result};
use crate::surface::patch::{CyclidePatch, check_quad, orthonormal};
use crate::surface::quad_grid::QuadGrid;

/// Largest angle (radians) and relative stretch by which a closed net may fail to close, beyond the rounding of its
/// vertices.
const CLOSING_LIMIT: f64 = 1e-9;

/// Angle by which rounded ends turn the reflection in an edge, in units of the largest coordinate over its length: each
/// end is off by `√3/2 ε`, and a reflection turns twice as far as its axis.
const EDGE_ROUNDING: f64 = 4.0 * f64::EPSILON;

impl CyclidicNet {
    /// The net over a grid whose quads are embedded and concircular, with the given frame: that of vertex (0, 0), or of the first
    /// one that belongs to a quad, s fastest, where quads are left out. Quads are counted from 0, s
    /// fastest, in the whole rectangle. The limits (1e-9 of a quad's size, 1e-9 radians round a closed direction) are for exact vertices: far
    /// from the origin these are rounded, and to the limits is added what that makes of the shortest edge.
    ///
    /// The weights are those of the whole net: neighboring patches agree pointwise on the edge they share. Their
    /// lengths, of which one row and one column are free, are those nearest to 1 (least squares of the logarithms).
    ///
    /// # Errors
    /// `below-rounding-of-place` (the grid is below 1.5e-11 of its coordinates); `not-finite`, `frame-not-orthonormal`; `coincident-points`, `not-concircular`, `crossing-quad`, `not-in-space`,
    /// `patch-through-infinity` with the quad; `net-does-not-close` if a closed direction does not bring the frame
    /// back (for a generic circular net it does not: see `docs/math/cyclides-and-nets.md#frames-and-weights-of-a-net`);
    /// `ambiguous-frame` if the edges give no frame for [`NetFrame::Auto`].
    pub fn new(grid: QuadGrid, frame: NetFrame) -> Result<Self> {
        grid.check_place()?;
        let kappa = stretches(&grid)?;
        let (v1, v2) = match frame {
            NetFrame::Auto => frame::fitted(&grid)?,
            NetFrame::First(v1, v2) => {
                for (index, v) in [v1, v2].into_iter().enumerate() {
                    if !v.is_finite() {
                        return Err(NumberError::NotFinite { what: ErrorItem::FrameVector, index }.into());
                    }
                }
                orthonormal(v1, v2)?
            }
        };
        let v = [v1, v2];
        let directions = transported(&grid, v);
        let limit = closing_limit(&grid);
        let turn = closing(&grid, v, &directions, limit)?;
        let lengths = lengths(&grid, &kappa, limit)?;
        let weights = directions.iter().zip(&lengths).map(|(w, l)| *w * *l).collect();
        Self { grid, weights, v, turn }.checked()
    }

    /// The net over an open grid with the frame of its first vertex and the logarithms of the lengths of its weights, which suit
    /// its quads.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub(in crate::surface) fn with_lengths(grid: QuadGrid, v: [Vec3; 2], lengths: &[f64]) -> Result<Self> {
        lengths.iter().try_for_each(|u| range::check_weight_ratio(u.exp()))?;
        let weights = transported(&grid, v).iter().zip(lengths).map(|(w, u)| *w * u.exp()).collect();
        Self { grid, weights, v, turn: [1.0; 2] }.checked()
    }

    fn checked(self) -> Result<Self> {
        let (rounding, [v1, v2]) = (rounding(&self.grid), self.v);
        for [i, j] in self.grid.all_quads() {
            let (corners, weights) = self.pairs(i, j);
            CyclidePatch::from_rounded_weights(corners, weights, v1, v2, rounding)
                .map_err(|e| e.in_quad(self.number([i, j])))?;
        }
        Ok(self)
    }
}

/// `ln(delta_12/delta_03)` of every quad, whose corners must be concircular; what is outside asks for nothing.
pub(in crate::surface) fn stretches(grid: &QuadGrid) -> Result<Vec<f64>> {
    let [m, n] = grid.quads();
    let mut kappa = vec![0.0; m * n];
    for [i, j] in grid.all_quads() {
        let (quad, a) = (i + j * m, grid.corners(i, j).map(|k| grid.points()[k]));
        check_quad(&a).map_err(|e| e.in_quad(quad))?;
        kappa[quad] = (a[1].distance(a[2]) / a[0].distance(a[3])).ln();
    }
    Ok(kappa)
}

impl CyclidicNet {
    /// The net of given vertices and weights: valid by construction, patches without poles.
    pub(crate) fn from_weights_unchecked(grid: QuadGrid, weights: Vec<Quat>, v: [Vec3; 2], turn: [f64; 2]) -> Self {
        debug_assert_eq!(weights.len(), grid.points().len());
        Self { grid, weights, v, turn }
    }

    /// The same weights over a grid whose points differ by rounding.
    pub(in crate::surface) fn over(self, grid: QuadGrid) -> Self {
        Self { grid, ..self }
    }
}

impl From<CyclidePatch> for CyclidicNet {
    /// The patch as a net of one quad: the same corners, weights and frame.
    fn from(patch: CyclidePatch) -> Self {
        let ([v1, v2, _], weights) = (patch.frame(), patch.weights().to_vec());
        Self { grid: QuadGrid::of_corners(patch.corners()), weights, v: [v1, v2], turn: [1.0, 1.0] }
    }
}

/// The unit weight at the other end of an edge with unit chord `d` in the direction of `v`: `d^-1 w v`.
fn step(w: Quat, d: Vec3, v: Vec3) -> Quat {
    let next = Quat::from(-d) * w * Quat::from(v);
    next * (1.0 / next.norm())
}

/// Unit weights of all vertices of the grid.
fn transported(grid: &QuadGrid, v: [Vec3; 2]) -> Vec<Quat> {
    let mut w = vec![Quat::ONE; grid.points().len()];
    for Way { before, to, direction, forward } in Way::all(grid) {
        let chord = grid.points()[to] - grid.points()[before];
        // Backwards both the chord and the direction are turned round.
        let along = if forward { v[direction] } else { -v[direction] };
        w[to] = step(w[before], frame::unit(chord), along);
    }
    w
}

/// The largest angle (radians) and relative stretch by which a closed net over this grid may fail to close.
pub fn closing_limit(grid: &QuadGrid) -> f64 {
    CLOSING_LIMIT + rounding(grid)
}

/// The angle by which the frame may be off after a row and a column, because the vertices are rounded.
fn rounding(grid: &QuadGrid) -> f64 {
    let ([cells, rows], largest) = (grid.quads(), |p: &Point3| p.to_vec().max_abs());
    let sides = |[i, j]: [usize; 2]| {
        let a = grid.corners(i, j).map(|k| grid.points()[k]);
        a[0].distance(a[1]).min(a[0].distance(a[2])).min(a[1].distance(a[3])).min(a[2].distance(a[3]))
    };
    let shortest = grid.all_quads().map(sides).fold(f64::INFINITY, f64::min);
    let far = grid.points().iter().map(largest).fold(0.0, f64::max);
    EDGE_ROUNDING * (cells + rows) as f64 * (far / shortest)
}

/// The signs of the weights after a turn in the closed directions.
fn closing(grid: &QuadGrid, v: [Vec3; 2], w: &[Quat], limit: f64) -> Result<[f64; 2]> {
    let size = grid.size();
    let mut turn = [1.0; 2];
    for d in 0..2 {
        if !grid.closed()[d] {
            continue;
        }
        // Carried round the first row or column, whose weights are a chain of steps.
        let last = if d == 0 { (size[0] - 1, 0) } else { (0, size[1] - 1) };
        let chord = grid.point(0, 0) - grid.point(last.0, last.1);
        let back = step(w[grid.index(last.0, last.1)], frame::unit(chord), v[d]);
        // The start has weight 1: what comes back is the rotation by which the frame is off, as a unit quaternion.
        let angle = 2.0 * back.vector().length().atan2(back.w.abs());
        if !(angle <= limit) {
            return Err(does_not_close(d, angle, 0.0, limit));
        }
        turn[d] = 1.0_f64.copysign(back.w);
    }
    Ok(turn)
}

/// The lengths of the weights: `ln|w3| = ln|w1| + ln|w2| - ln|w0| + kappa` fixes them up to a term per column and a
/// term per row; those that make the squares least are the negative means.
fn lengths(grid: &QuadGrid, kappa: &[f64], limit: f64) -> Result<Vec<f64>> {
    let ([m, n], [cells, rows]) = (grid.size(), grid.quads());
    for d in 0..2 {
        // Round a strip of quads the terms must cancel, or the lines across would come back at another speed.
        let strips = if d == 0 { rows } else { cells };
        for k in 0..strips {
            let sum: f64 = if d == 0 {
                kappa[k * cells..(k + 1) * cells].iter().sum()
            } else {
                (0..rows).map(|j| kappa[k + j * cells]).sum()
            };
            if grid.closed()[d] && !(sum.abs() <= limit) {
                return Err(does_not_close(d, 0.0, sum.exp_m1(), limit));
            }
        }
    }
    let mut u = vec![0.0; m * n];
    for j in 1..n {
        for i in 1..m {
            u[i + j * m] =
                u[i - 1 + j * m] + u[i + (j - 1) * m] - u[i - 1 + (j - 1) * m] + kappa[i - 1 + (j - 1) * cells];
        }
    }
    for i in 0..m {
        let mean = (0..n).map(|j| u[i + j * m]).sum::<f64>() / n as f64;
        (0..n).for_each(|j| u[i + j * m] -= mean);
    }
    for row in u.chunks_mut(m) {
        let mean = row.iter().sum::<f64>() / m as f64;
        row.iter_mut().for_each(|x| *x -= mean);
    }
    for value in &u {
        range::check_weight_ratio(value.exp())?;
    }
    Ok(u.into_iter().map(f64::exp).collect())
}

fn does_not_close(d: usize, angle: f64, stretch: f64, limit: f64) -> Error {
    Error::Patch(PatchError::NetDoesNotClose { direction: d, line: None, angle, stretch, limit })
}
