//! Bilinear patches of circles as shells: faces with positive weights, their edges exact arcs.

use super::{FaceEdge, FaceSurface, Shell, ShellEdge, ShellFace};
use crate::curve::Arc;
use crate::error::{ArcError, PatchError, Result};
use crate::surface::QbPatch;

/// Both parameters are halved so often at most until all weights of the parts are positive.
const HALVINGS: u32 = 6;

impl QbPatch {
    /// The patch as a shell: one exact rational face where its real weights are positive, else the parts between equal cuts of both
    /// parameters that have positive ones. Its edges are arcs.
    ///
    /// # Errors
    /// `patch-through-infinity` where parts of a 64th of the range still have weights that are not positive: the patch comes very near to infinity.
    pub fn to_shell(&self) -> Result<Shell> {
        let mut count = 1;
        let parts = loop {
            let parts = self.parts(count)?;
            let is_positive = |part: &Self| part.real_weights().iter().flatten().all(|w| *w > 0.0);
            match parts.iter().position(|part| !is_positive(part)) {
                None => break parts,
                Some(k) if count == 1 << HALVINGS => {
                    let middle = |k: usize| (k as f64 + 0.5) / count as f64;
                    return Err(PatchError::ThroughInfinity { s: middle(k % count), t: middle(k / count) }.into());
                }
                Some(_) => count *= 2,
            }
        };
        self.sewn(&parts, count)
    }

    /// The parts between so many equal cuts of both parameters, s fastest.
    fn parts(&self, count: usize) -> Result<Vec<Self>> {
        let range = |k: usize| [k as f64 / count as f64, (k + 1) as f64 / count as f64];
        (0..count * count).map(|k| self.restricted(range(k % count), range(k / count))).collect()
    }

    /// The shell of a grid of parts, which share vertices and edges. Of a side that is one point all vertices are one.
    fn sewn(&self, parts: &[Self], count: usize) -> Result<Shell> {
        let row = count + 1;
        let corner = |i: usize, j: usize| {
            let (a, b) = (usize::from(i == count), usize::from(j == count));
            parts[(i - a) + (j - b) * count].corners()[a + 2 * b]
        };
        let mut shell = Shell { vertices: Vec::new(), edges: Vec::new(), faces: Vec::new() };
        let mut index = Vec::with_capacity(row * row);
        for k in 0..row * row {
            let p = corner(k % row, k / row);
            // Only neighbors on a side of one point are equal.
            let same = index.iter().rev().take(row).copied().find(|at: &usize| shell.vertices[*at] == p);
            index.push(same.unwrap_or(shell.vertices.len()));
            if same.is_none() {
                shell.vertices.push(p);
            }
        }
        let place = |k: usize| k as f64 / count as f64;
        let mut edge = |from: [usize; 2], to: [usize; 2]| -> Result<Option<FaceEdge>> {
            let [start, end] = [from, to].map(|[i, j]| index[i + j * row]);
            if start == end {
                return Ok(None);
            }
            let [d0, d1] = [from, to].map(|[i, j]| self.denominator(place(i), place(j)));
            let ratio = d1 * d0.inverse().ok_or(ArcError::ZeroWeight { index: 0 })?;
            let curve = Arc::from_ratio_across(shell.vertices[start], shell.vertices[end], ratio)?.into();
            shell.edges.push(ShellEdge { start, end, curve });
            Ok(Some(FaceEdge { edge: shell.edges.len() - 1, forward: true }))
        };
        let (mut along_s, mut along_t) = (Vec::new(), Vec::new());
        for k in 0..row * row {
            let (i, j) = (k % row, k / row);
            along_s.push(if i < count { edge([i, j], [i + 1, j])? } else { None });
            along_t.push(if j < count { edge([i, j], [i, j + 1])? } else { None });
        }
        for (k, part) in parts.iter().enumerate() {
            let at = k % count + k / count * row;
            let sides = [along_s[at], along_s[at + row], along_t[at], along_t[at + 1]];
            let surface = FaceSurface::Rational(part.to_rational().with_corners(part.corners()));
            shell.faces.push(ShellFace { surface, sides, same_sense: true });
        }
        Shell::new(shell.vertices, shell.edges, shell.faces)
    }
}
