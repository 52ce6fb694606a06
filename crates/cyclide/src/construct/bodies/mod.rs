//! Bodies and sheets: revolutions, pipes, necks, bridges, surfaces between two curves, rounded polyhedra.

mod angle_law;
mod ball_centers;
mod bands;
mod carried;
mod center_line;
mod circle_rail;
mod circular_surface;
mod contact_blend;
mod crossing_arcs;
mod ellipse_bridge;
mod ellipse_ring;
mod halving;
mod input_chain;
mod kinks;
mod neck;
mod pierced;
mod pipe;
mod pipe_crossing;
mod planar_area;
mod planar_folds;
mod polyhedron;
mod rail_surface;
mod rails;
mod revolution;
mod ring_blend;
mod rotated_rows;
mod ruled;
mod rulings;
mod section;
mod smooth_joint;
mod sweep;
mod swept;
mod tee;
mod tight_place;
mod torus_seam;
mod tube;
mod turned_patch;

pub use ball_centers::BallCenters;
pub use contact_blend::{BlendBase, BlendTube, ContactBlend, MadeContactBlend};
pub use ellipse_bridge::EllipseBridge;
pub use neck::{NeckBlend, NeckBody, NeckSide, NeckVariant, PlateShape};
pub use pipe::{Pipe, PipeEnds};
pub use pipe_crossing::{CrossingPipe, CrossingSide, MadeCrossing, PipeCrossing};
pub use polyhedron::{ConvexPolyhedron, PolyhedronEdge, SphericalPolygon};
pub use rail_surface::RailSurface;
pub use revolution::Revolution;
pub use ring_blend::{BlendRing, RingBlend};
pub use sweep::{Sweep, SweepFrame, SweepOptions};
pub use swept::SweptSurface;
pub use tee::{MadeTee, PipeTee, TeeBlend, TeeBlendFacts, TeeBranch, TeeEnds, TeeMain};
pub use torus_seam::TorusSeam;
pub use tube::{Ball, RadiusLaw, TaperedTube, Tube};

/// Largest angle of an arc in one face, or in one piece of it: beyond, its weights are far from each other, and from half a turn on not
/// positive.
const LARGEST_ARC: f64 = std::f64::consts::TAU / 3.0;
