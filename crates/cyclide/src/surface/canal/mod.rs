//! Balls that roll between two surfaces, and the canal surfaces that they envelop (`docs/math/canal-blends.md`).

mod ball;
mod ball_space;
mod center_surface;
mod contact;
mod contact_patch;
mod moved_cylinders;
mod natural_quadric;
mod patch;
mod quadric_pair;
mod skew_cylinders;
mod skew_directions;
mod skew_patch;

pub use ball::RollingBall;
pub(crate) use ball_space::BallVector;
pub use contact::ContactPartner;
pub(crate) use moved_cylinders::{BallLine, MovedCylinders};
pub use natural_quadric::NaturalQuadric;
pub use patch::{CanalPart, CanalPatch, CharacteristicCircle};
pub use quadric_pair::{PairKind, QuadricPair};
pub use skew_cylinders::SkewCylinders;
