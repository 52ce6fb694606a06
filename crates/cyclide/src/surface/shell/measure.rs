//! Area and enclosed volume by quadrature over the faces.

use super::{Shell, ShellFace};
use crate::base::quadrature::gauss8;
use crate::surface::ParamSurface as _;
use std::collections::BinaryHeap;

/// The rule on a cell and on its quarters agree to this part of the face's integral of absolute values.
const AGREEMENT: f64 = 1e-12;
/// Quarterings of a face at most. A corner near infinity takes two or three per power of two of its distance; a face whose
/// rounding is above the agreement would be quartered for ever.
const QUARTERINGS: usize = 512;

impl Shell {
    /// Area of all faces, to about 1e-12 of itself. The area element `|q1 q2|/|D|⁴` has a kink where a parameter line
    /// is one point: faces are integrated part by part between such lines.
    #[must_use]
    pub fn area(&self) -> f64 {
        let area = |face: &ShellFace| {
            let element = |s, t| face.patch.jet(s, t).area_element();
            let part = |cell| integral(&element, cell, rule(&element, cell));
            regular_cells(face).map(part).sum::<f64>()
        };
        self.faces.iter().map(area).sum()
    }

    /// Volume enclosed by a closed shell, to about 1e-12 of area times diameter: positive if the outer side is outside.
    /// For an open shell, the volume between its faces and its first vertex.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let volume = |face: &ShellFace| {
            let element = |s, t| self.cone(face, s, t);
            // Signed, it has no kinks; its size has.
            let size: f64 = regular_cells(face).map(|cell| rule(&|s, t| element(s, t).abs(), cell)).sum();
            integral(&element, UNIT, size)
        };
        self.faces.iter().map(volume).sum()
    }

    /// Volume element of the cone over the face from the first vertex: `(f - v)·(f_s × f_t)/3`, signed by the side.
    fn cone(&self, face: &ShellFace, s: f64, t: f64) -> f64 {
        let jet = face.patch.jet(s, t);
        let element = (jet.point - self.vertices[0]).dot(jet.ds.cross(jet.dt)) / 3.0;
        if face.same_sense { element } else { -element }
    }
}

/// A cell: its ends in s, then in t.
type Cell = [[f64; 2]; 2];

/// The whole face.
const UNIT: Cell = [[0.0, 1.0]; 2];

/// The parts of a face between its singular lines.
fn regular_cells(face: &ShellFace) -> impl Iterator<Item = Cell> {
    let ends = |inside: Vec<f64>| [vec![0.0], inside, vec![1.0]].concat();
    let (s, t) = (ends(face.patch.singular_s()), ends(face.patch.singular_t()));
    let parts = |ends: &[f64]| ends.windows(2).map(|w| [w[0], w[1]]).collect::<Vec<_>>();
    let (s, t) = (parts(&s), parts(&t));
    t.into_iter().flat_map(move |t| s.clone().into_iter().map(move |s| [s, t]))
}

/// The 8×8-point rule on a cell.
fn rule(element: &impl Fn(f64, f64) -> f64, [[s0, s1], [t0, t1]]: Cell) -> f64 {
    gauss8(&mut |s| gauss8(&mut |t| element(s, t), t0, t1), s0, s1)
}

/// Integral over a cell of an analytic function; `size` is that of its absolute value, as far as one rule sees it.
///
/// The worst part is quartered first. So a peak that the first rule missed (a corner near infinity has nearly all of the
/// area in a tiny part of its parameters) raises the integral, and with it what counts as good.
fn integral(element: &impl Fn(f64, f64) -> f64, cell: Cell, size: f64) -> f64 {
    let mut parts = BinaryHeap::from([Part::new(element, cell, rule(element, cell))]);
    let mut sum = parts.peek().map_or(0.0, Part::integral);
    for _ in 0..QUARTERINGS {
        let Some(worst) = parts.pop() else { break };
        // Not `<=`: a NaN is not worth quartering either.
        if !(worst.error > AGREEMENT * size.abs().max(sum.abs())) {
            parts.push(worst);
            break;
        }
        sum -= worst.integral();
        for (cell, whole) in quarters(worst.cell).into_iter().zip(worst.quarters) {
            let part = Part::new(element, cell, whole);
            sum += part.integral();
            parts.push(part);
        }
    }
    // Added anew, the small ones first: the running sum has the rounding of peaks that came and went.
    let mut integrals: Vec<f64> = parts.iter().map(Part::integral).collect();
    integrals.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    integrals.iter().sum()
}

/// The four parts of a cell.
fn quarters(cell: Cell) -> [Cell; 4] {
    let [halves_s, halves_t] = cell.map(|[a, b]| {
        let m = 0.5 * (a + b);
        [[a, m], [m, b]]
    });
    [0, 1, 2, 3].map(|k| [halves_s[k & 1], halves_t[k >> 1]])
}

/// A cell with the rule on its quarters, ordered by the disagreement with the rule on the whole.
struct Part {
    cell: Cell,
    quarters: [f64; 4],
    error: f64,
}

impl Part {
    fn new(element: &impl Fn(f64, f64) -> f64, cell: Cell, whole: f64) -> Self {
        let quarters = quarters(cell).map(|cell| rule(element, cell));
        Self { cell, quarters, error: (quarters.iter().sum::<f64>() - whole).abs() }
    }

    fn integral(&self) -> f64 {
        self.quarters.iter().sum()
    }
}

impl Ord for Part {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.error.total_cmp(&other.error)
    }
}
impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Part {}
