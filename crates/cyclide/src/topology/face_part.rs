//! A part of a face: what a face of a cut shell is of the face that it was cut from.

use super::Side;

/// A rectangle in the parameters of a face of a shell: the part of it that a face of a [`CutShell`](super::CutShell) is.
///
/// ```
/// use cyclide::topology::FacePart;
/// let half = FacePart { face: 3, s: [0.0, 0.5], t: [0.0, 1.0] };
/// assert_eq!(half.place(0.5, 0.25), (0.25, 0.25));
/// // The first half of that half.
/// assert_eq!(FacePart { face: 0, ..half }.within(&half), FacePart { face: 3, s: [0.0, 0.25], t: [0.0, 1.0] });
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacePart {
    /// Index of the face in its shell.
    pub face: usize,
    /// Where the part begins and ends along s, from 0 to 1.
    pub s: [f64; 2],
    /// Where the part begins and ends along t, from 0 to 1.
    pub t: [f64; 2],
}

impl FacePart {
    /// All of a face.
    #[must_use]
    pub const fn whole(face: usize) -> Self {
        Self { face, s: [0.0, 1.0], t: [0.0, 1.0] }
    }

    /// The parameters `(s, t)` of the face at the part's own parameters, both from 0 to 1: the ends are met exactly.
    #[must_use]
    pub fn place(&self, x: f64, y: f64) -> (f64, f64) {
        (between(self.s, x), between(self.t, y))
    }

    /// The part of a face whose part `outer` has this part.
    #[must_use]
    pub fn within(&self, outer: &Self) -> Self {
        let [s, t] = [(self.s, outer.s), (self.t, outer.t)].map(|(own, range)| own.map(|x| between(range, x)));
        Self { face: outer.face, s, t }
    }

    /// Where one of its sides lies: the parameter of the face that is the same along it, and the range of the other one.
    #[must_use]
    pub const fn side(&self, side: Side) -> (f64, [f64; 2]) {
        match side {
            Side::Bottom => (self.t[0], self.s),
            Side::Top => (self.t[1], self.s),
            Side::Left => (self.s[0], self.t),
            Side::Right => (self.s[1], self.t),
        }
    }
}

/// The place at a fraction of a range, at its ends the ends themselves.
fn between([from, to]: [f64; 2], x: f64) -> f64 {
    match x {
        0.0 => from,
        1.0 => to,
        _ => from + (to - from) * x,
    }
}
