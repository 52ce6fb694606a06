//! Grids of quads for the geometry kernel [`cyclide`]: those whose quads are moved until each lies on a circle, as nets of Dupin
//! cyclide patches need them, and those that are laid along the lines of curvature of a triangle mesh. Both solve large sparse
//! systems (faer), which the kernel itself does not need.
//!
//! # By topic
//!
//! | topic | names |
//! |---|---|
//! | quads made circular | [`make_circular`]: [`CircularMesh`], [`CircularMeshOptions`], [`Border`], [`CircularMeshStep`], [`CircularMeshReport`], [`ClosingChange`], [`LineAngles`], [`VertexMoves`]; of meshes with extraordinary vertices [`make_layout_circular`]: [`CircularLayout`], [`RoundChange`]; with progress [`make_circular_watched`], [`make_layout_circular_watched`] |
//! | grids along lines of curvature | [`principal_grids`], [`covering_principal_grids`]: [`PrincipalGrids`], [`FreeLayout`], [`PrincipalGridOptions`], [`UmbilicRule`], [`GridBorder`], [`PrincipalStage`], [`PrincipalField`], [`PrincipalGridReport`], [`GridPiece`], [`Umbilic`]; with progress [`principal_grids_watched`], [`covering_principal_grids_watched`] |
//!
//! Errors and warnings are those of the kernel: [`cyclide::Error`], [`cyclide::Warning`].

mod circular_mesh;
mod principal;
mod principal_rules;
mod sparse_solver;

pub use circular_mesh::{
    Border, CircularLayout, CircularMesh, CircularMeshOptions, CircularMeshReport, CircularMeshStep, ClosingChange,
    LineAngles, RoundChange, VertexMoves, make_circular, make_circular_watched, make_layout_circular,
    make_layout_circular_watched,
};
pub use principal::{
    FreeLayout, GridPiece, PrincipalField, PrincipalGridOptions, PrincipalGridReport, PrincipalGrids, PrincipalStage,
    Umbilic, covering_principal_grids, covering_principal_grids_watched, principal_grids, principal_grids_watched,
};
pub use principal_rules::{GridBorder, UmbilicRule};

/// The example of the package's page is compiled and run with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
