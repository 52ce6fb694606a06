//! Surfaces: the trait, principal patches of Dupin cyclides, nets of them; smooth surfaces over triangles.
//!
//! | topic | names |
//! |---|---|
//! | evaluation | [`ParamSurface::point`], [`ParamSurface::jet`] |
//! | patches, nets, whole cyclides | [`CyclidePatch`], [`PatchKind`], [`ImplicitForm`], [`PatchRow`], [`PatchLocation`], [`QbPatch`], [`QbPatchKind`], [`CornerTwist`], [`CyclidicNet`], [`NetFrame`], [`SingularPatch`], [`DupinCyclide`], [`CyclideKind`], [`QuadGrid`], [`GridCell`], [`GridClosing`], [`RingClosing`], [`StripClosing`], [`NetLayout`], [`QuadLayout`], [`LayoutPiece`], [`RoundVertex`], [`Seam`], [`SeamMeasure`], [`NormalStrip`], [`StripForm`] |
//! | tori and curves on them | [`Torus`], [`TorusSpline`], [`TorusPiece`], [`TorusSegment`], [`TorusJunction`], [`TorusClasses`], [`CircleFamily`], [`QuarticType`], [`SegmentMethod`] |
//! | rolling balls, canal surfaces | [`SkewCylinders`], [`NaturalQuadric`], [`QuadricPair`], [`PairKind`], [`RollingBall`], [`ContactPartner`], [`CanalPatch`], [`CanalPart`], [`CharacteristicCircle`] |
//! | surfaces over triangles | [`SmoothMesh`], [`VertexNormals`], [`NormalWeights`], [`SmoothEdge`], [`SmoothMeasure`], [`SmoothComparison`], [`SmoothTriangle`], [`SphereBlend`], [`TriangleSurface`], [`TrianglePatch`], [`SideLine`] |

mod barycentric;
mod bounds;
mod canal;
mod dupin;
pub(crate) mod grid_cells;
pub(crate) mod layout;
pub(crate) mod net;
mod normal_strip;
mod param_surface;
mod patch;
mod qb_patch;
mod quad_grid;
mod rational_cone;
mod rational_kind;
mod seam;
mod smooth;
mod sphere_blend;
mod torus;
mod triangle_surface;

pub(crate) use canal::{BallLine, BallVector, MovedCylinders};
pub use canal::{CanalPart, CanalPatch, CharacteristicCircle, ContactPartner, RollingBall, SkewCylinders};
pub use canal::{NaturalQuadric, PairKind, QuadricPair};
pub use dupin::{CyclideKind, DupinCyclide};
pub use grid_cells::GridCell;
pub use layout::{LayoutPiece, NetLayout, QuadLayout, RoundVertex};
pub(crate) use net::SameVertices;
pub use net::{CyclidicNet, GridClosing, NetFrame, RingClosing, SingularPatch, StripClosing};
pub use normal_strip::{NormalStrip, StripForm};
pub use param_surface::ParamSurface;
pub use patch::{CyclidePatch, ImplicitForm, PatchKind, PatchLocation, PatchRow};
pub(crate) use patch::{check_following_quad, on_corner_circle, orthonormal};
pub use qb_patch::{CornerTwist, QbPatch, QbPatchKind};
pub use quad_grid::QuadGrid;
pub use seam::{Seam, SeamMeasure};
pub use smooth::{
    NormalWeights, SmoothComparison, SmoothEdge, SmoothMeasure, SmoothMesh, SmoothTriangle, VertexNormals,
};
pub use sphere_blend::SphereBlend;
pub use torus::{
    CircleFamily, QuarticType, SegmentMethod, Torus, TorusClasses, TorusJunction, TorusPiece, TorusSegment, TorusSpline,
};
pub(crate) use torus::{Course, PlaceAngle, Spans, TorusChain, within_a_turn};
pub use triangle_surface::{SideLine, TrianglePatch, TriangleSurface};
