//! Why umbilics cannot be vertices of one mesh of quads.

/// What prevents one mesh of quads along the lines of curvature round umbilics.
///
/// ```
/// use cyclide::{Error, error::{JoinFault, PrincipalGridError}};
/// let error = Error::PrincipalGrid(PrincipalGridError::UmbilicsNotJoined { at: [1.0, 2.0, 0.5], fault: JoinFault::Crowded });
/// assert!(error.to_string().contains("1, 2, 0.5"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum JoinFault {
    /// Lines of curvature make more than half a turn round it.
    Turns,
    /// There are more than sixty-four umbilics.
    Many,
    /// The surface has a hole, or is a tube.
    Holes,
    /// No path along edges of the surface's mesh leads from it to the border past the paths from the other umbilics.
    Coarse,
    /// It is within a few edges of another one, or of the border.
    Crowded,
    /// The coordinates along the lines of curvature fold.
    Folded,
}

impl JoinFault {
    /// The fault in words, with what helps.
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::Turns => "lines of curvature turn by more than half a turn round it",
            Self::Many => "it is one of more than 64 umbilics: the surface is rough, or flat in parts",
            Self::Holes => "the surface has holes, or is a tube: fill the holes, or cut the tube open",
            Self::Coarse => "the mesh has no separate path from there to the border: refine it",
            Self::Crowded => {
                "it is only a few edges away from another umbilic or from the border: use a shorter edge length"
            }
            Self::Folded => {
                "the coordinates along the lines of curvature fold: the mesh is rough there, or the surface is nearly flat or spherical"
            }
        }
    }
}
