//! Where the sides of parts of faces lie in the uncut model: on its edges, or on lines inside its faces along which these
//! were cut. Two parts share a border where both have the same line over the same range.

use crate::check::tiles::same_place;
use cyclide::topology::{FacePart, Shell, Side};

/// What a border is a part of.
#[derive(Debug, Clone, Copy)]
pub(super) enum Line {
    /// An edge of the model.
    Edge(usize),
    /// A parameter line inside a face: along s (`direction` 0) or t, where the other parameter is `at`.
    Inside { face: usize, direction: usize, at: f64 },
}

/// A side of a part of a face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Border {
    pub(super) line: Line,
    /// The part of the line, in the line's parameter.
    range: [f64; 2],
    /// True if the side's parameter grows with that of the line, in whose direction edges are written.
    forward: bool,
}

impl Border {
    /// The side of a part of a face of this shell; `None` for a side of one point, as the model has it.
    pub(super) fn of(shell: &Shell, part: &FacePart, side: Side) -> Option<Self> {
        let (at, range) = part.side(side);
        let is_inside = if matches!(side, Side::Bottom | Side::Left) { at > 0.0 } else { at < 1.0 };
        if is_inside {
            let line = Line::Inside { face: part.face, direction: side.direction(), at };
            return Some(Self { line, range, forward: true });
        }
        let edge = shell.faces().get(part.face)?.side(side)?;
        let [from, to] = range.map(|x| edge.turned(x));
        let range = if edge.forward { [from, to] } else { [to, from] };
        Some(Self { line: Line::Edge(edge.edge), range, forward: edge.forward })
    }

    /// The parameter of the side at the parameter of the file's edge, both from 0 to 1, and the other way round.
    pub(super) fn turned(&self, x: f64) -> f64 {
        if self.forward { x } else { 1.0 - x }
    }

    /// True if the loop round a face, seen from the side of `f_s × f_t` or from the other one, runs along the edge from its
    /// start to its end.
    pub(super) fn runs_forward(&self, side: Side, seen_from_normal: bool) -> bool {
        (side.runs_with_loop() == self.forward) == seen_from_normal
    }

    /// What borders that may be the same have in common.
    pub(super) fn key(&self) -> (usize, usize) {
        match self.line {
            Line::Edge(edge) => (edge, 2),
            Line::Inside { face, direction, .. } => (face, direction),
        }
    }

    /// True if both are the same part of the same line.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        let line = match (self.line, other.line) {
            (Line::Edge(a), Line::Edge(b)) => a == b,
            (Line::Inside { face, direction, at }, Line::Inside { face: f, direction: d, at: x }) => {
                (face, direction) == (f, d) && same_place(at, x)
            }
            _ => false,
        };
        line && self.range.iter().zip(other.range).all(|(a, b)| same_place(*a, b))
    }
}
