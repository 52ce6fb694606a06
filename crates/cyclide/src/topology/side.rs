//! The four sides of a face, and what is known of each by its name: its corners, its direction, its place in the loop.

use super::{EdgeCurve, FaceEdge, FaceGeometry as _, FaceSurface, ShellFace};
use crate::error::Result;

/// A side of the parameter square `[0, 1]²` of a face; as a number, its index among [`ShellFace::sides`].
///
/// ```
/// use cyclide::topology::Side;
/// assert_eq!((Side::Bottom.opposite(), Side::Left.place(0.25)), (Side::Top, (0.0, 0.25)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// `t = 0`, along s.
    Bottom,
    /// `t = 1`, along s.
    Top,
    /// `s = 0`, along t.
    Left,
    /// `s = 1`, along t.
    Right,
}

impl Side {
    /// All sides, by their index.
    pub const ALL: [Self; 4] = [Self::Bottom, Self::Top, Self::Left, Self::Right];

    /// The boundary, counter-clockwise in (s, t).
    pub const LOOP: [Self; 4] = [Self::Bottom, Self::Right, Self::Top, Self::Left];

    /// The two sides that run along s (`direction` 0) or along t, the one at parameter 0 first.
    pub(crate) const fn along(direction: usize) -> [Self; 2] {
        if direction == 0 { [Self::Bottom, Self::Top] } else { [Self::Left, Self::Right] }
    }

    /// 0 for a side that runs along s, 1 for one along t.
    #[must_use]
    pub const fn direction(self) -> usize {
        match self {
            Self::Bottom | Self::Top => 0,
            Self::Left | Self::Right => 1,
        }
    }

    /// The side on the other end of the face.
    #[must_use]
    pub const fn opposite(self) -> Self {
        match self {
            Self::Bottom => Self::Top,
            Self::Top => Self::Bottom,
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// Its corners (`s + 2 t`) at parameters 0 and 1.
    #[must_use]
    pub const fn corners(self) -> [usize; 2] {
        match self {
            Self::Bottom => [0, 1],
            Self::Top => [2, 3],
            Self::Left => [0, 2],
            Self::Right => [1, 3],
        }
    }

    /// True if the counter-clockwise [loop](Self::LOOP) runs along it with the growing parameter.
    #[must_use]
    pub const fn runs_with_loop(self) -> bool {
        matches!(self, Self::Bottom | Self::Right)
    }

    /// The parameters `(s, t)` of the face at the parameter `x` of the side.
    #[must_use]
    pub const fn place(self, x: f64) -> (f64, f64) {
        match self {
            Self::Bottom => (x, 0.0),
            Self::Top => (x, 1.0),
            Self::Left => (0.0, x),
            Self::Right => (1.0, x),
        }
    }

    /// The side of a surface as a curve with the surface's parameter.
    pub(super) fn curve_of(self, surface: &FaceSurface) -> Result<EdgeCurve> {
        match self {
            Self::Bottom => surface.s_line(0.0),
            Self::Top => surface.s_line(1.0),
            Self::Left => surface.t_line(0.0),
            Self::Right => surface.t_line(1.0),
        }
    }
}

impl FaceEdge {
    /// The parameter of the face's side at the parameter `x` of the edge, and the other way round.
    #[must_use]
    pub fn turned(self, x: f64) -> f64 {
        if self.forward { x } else { 1.0 - x }
    }
}

impl ShellFace {
    /// The edge on a side; `None` for a side that is one point.
    #[must_use]
    pub fn side(&self, side: Side) -> Option<FaceEdge> {
        self.sides[side as usize]
    }

    /// The sides that have an edge, by their index.
    pub fn edges(&self) -> impl Iterator<Item = (Side, FaceEdge)> + '_ {
        Side::ALL.into_iter().filter_map(|side| Some((side, self.side(side)?)))
    }

    /// The edges round the face with the side on which each is, counter-clockwise seen from the side of `f_s × f_t`, or
    /// from the other one; with whether the loop runs along the edge from its start to its end.
    #[must_use]
    pub fn edge_loop(&self, seen_from_normal: bool) -> Vec<(Side, FaceEdge, bool)> {
        let on = |side: Side| {
            let edge = self.side(side)?;
            Some((side, edge, (side.runs_with_loop() == edge.forward) == seen_from_normal))
        };
        let mut round: Vec<_> = Side::LOOP.into_iter().filter_map(on).collect();
        if !seen_from_normal {
            round.reverse();
        }
        round
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_agree_with_the_parameter_square() {
        let corner = |(s, t): (f64, f64)| (s + 2.0 * t) as usize;
        for (k, side) in Side::ALL.into_iter().enumerate() {
            assert_eq!(side as usize, k);
            assert_eq!(side.corners(), [0.0, 1.0].map(|x| corner(side.place(x))));
            assert_eq!(side.opposite().direction(), side.direction());
            assert!(side.opposite() != side && Side::along(side.direction()).contains(&side));
        }
        // The loop runs from corner to corner, and is counter-clockwise: its area is positive.
        let ends = |side: Side| {
            let [from, to] = [0.0, 1.0].map(|x| side.place(x));
            if side.runs_with_loop() { [from, to] } else { [to, from] }
        };
        let mut area = 0.0;
        for (k, side) in Side::LOOP.into_iter().enumerate() {
            let [from, to] = ends(side);
            assert_eq!(to, ends(Side::LOOP[(k + 1) % 4])[0]);
            area += 0.5 * (from.0 * to.1 - from.1 * to.0);
        }
        assert!(area > 0.0);
    }
}
