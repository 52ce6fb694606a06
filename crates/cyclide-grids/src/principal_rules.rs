//! What becomes of umbilics and of the border where grids are laid along lines of curvature; documents read these words also where
//! nothing lays grids.

/// What becomes of umbilics, the places where a surface bends alike in all directions and lines of curvature part.
///
/// ```
/// assert_eq!(cyclide_grids::UmbilicRule::default(), cyclide_grids::UmbilicRule::Pieces);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "UmbilicRule", description = "What happens at umbilics.")
)]
pub enum UmbilicRule {
    /// The surface is cut from each umbilic to the border, and several grids are laid beside them, with gaps between the
    /// grids.
    #[default]
    Pieces,
    /// Umbilics are extraordinary vertices, with six quads or with two, of one mesh of quads, which consists of several grids
    /// that share their borders. The border runs in steps.
    Joined,
    /// The directions are smoothed until no umbilic is left: one grid, which departs from the lines of curvature.
    Smooth,
}

/// How far a grid along lines of curvature goes.
///
/// ```
/// assert_eq!(cyclide_grids::GridBorder::default(), cyclide_grids::GridBorder::Inside);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "GridBorder", description = "How far a grid along lines of curvature extends.")
)]
pub enum GridBorder {
    /// The largest rectangle of whole cells on the surface.
    #[default]
    Inside,
    /// All connected whole cells on the surface: the border runs in steps along that of the surface, and holes are openings. A
    /// closed grid is the largest closed band.
    Staircase,
    /// The whole surface and more: where the rectangle of the grid is larger than the surface, the grid is continued smoothly,
    /// and the net is to be trimmed.
    Cover,
}
