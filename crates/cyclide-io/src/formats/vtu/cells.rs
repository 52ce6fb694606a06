//! Rational Bézier cells with what is said of each.

use super::order::{Degrees, nodes};

/// VTK's numbers for Bézier curves, quadrilaterals and hexahedra.
pub(super) const CURVE: u8 = 75;
pub(super) const QUADRILATERAL: u8 = 77;
pub(super) const HEXAHEDRON: u8 = 79;

/// One cell: its kind, its degrees, its homogeneous rows by index triple, and what it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cell {
    pub(super) kind: u8,
    pub(super) degrees: Degrees,
    /// Points and weights in the order of VTK's nodes.
    pub(super) nodes: Vec<([f64; 3], f64)>,
    pub(super) tags: Tags,
}

/// What a cell says of itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Tags {
    /// The object, from 0, as the names of objects are listed.
    pub(super) object: usize,
    /// Which of its contours or bodies.
    pub(super) part: usize,
    /// Of a face, which shell of the body.
    pub(super) shell: usize,
    /// Of a curve 1 if its contour is closed; of a face 1 if the outer side is that of `f_s × f_t`; of a hexahedron 1.
    pub(super) flag: usize,
}

impl Cell {
    /// The cell of these rows, which have positive weights.
    pub(super) fn new(kind: u8, degrees: Degrees, row: impl Fn([usize; 3]) -> [f64; 4], tags: Tags) -> Self {
        let node = |at| {
            let [x, y, z, w] = row(at);
            ([x / w, y / w, z / w], w)
        };
        Self { kind, degrees, nodes: nodes(degrees).into_iter().map(node).collect(), tags }
    }

    /// The homogeneous rows, the last parameter fastest.
    pub(super) fn rows(&self) -> Vec<[f64; 4]> {
        let [_, q, r] = self.degrees;
        let mut rows = vec![[0.0; 4]; self.nodes.len()];
        for ([i, j, k], ([x, y, z], w)) in nodes(self.degrees).into_iter().zip(&self.nodes) {
            rows[(i * (q + 1) + j) * (r + 1) + k] = [x * w, y * w, z * w, *w];
        }
        rows
    }
}
