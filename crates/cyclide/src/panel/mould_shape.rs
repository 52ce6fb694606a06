//! The form of a mould, without its place.

use super::bent_plane::{Bend, BentPlane};
use super::panel_fit::PanelFit;

/// The surface of a mould, wherever it stands.
///
/// ```
/// use cyclide::{panel::{MouldShape, Moulds}, surface::DupinCyclide};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?;
/// let panels: Vec<_> = ring[0].patches().collect();
/// let moulds = Moulds::new(&panels, 1e-6)?;
/// // Eight rows of eight panels, all made on one torus.
/// assert_eq!((moulds.moulds.len(), moulds.free.len()), (1, 0));
/// assert!(matches!(moulds.moulds[0].shape, MouldShape::Torus { .. }));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MouldShape {
    /// A flat sheet: no mould at all.
    Plane,
    /// A cylinder: sheets are rolled.
    Cylinder {
        /// Radius.
        radius: f64,
    },
    /// A cone: sheets are rolled. Panels may lie anywhere along it.
    Cone {
        /// Angle between axis and rulings, radians.
        half_angle: f64,
    },
    /// A sphere.
    Sphere {
        /// Radius.
        radius: f64,
    },
    /// A torus; panels may lie on its outer or inner part.
    Torus {
        /// Distance of the middle of the tube from the axis.
        major_radius: f64,
        /// Radius of the tube.
        minor_radius: f64,
    },
}

impl MouldShape {
    /// The form of a surface fitted to a panel of the given size.
    pub(super) fn of(fit: &PanelFit, size: f64) -> Self {
        let shape = &fit.shape;
        match shape.bend {
            Bend::Plane => Self::Plane,
            Bend::Cylinder => Self::Cylinder { radius: size / shape.across.abs() },
            Bend::Cone => Self::Cone { half_angle: shape.half_angle() },
            Bend::Sphere => Self::Sphere { radius: size / shape.across.abs() },
            Bend::Torus => {
                let [major, minor] = shape.signed_torus_radii();
                Self::Torus { major_radius: major.abs() * size, minor_radius: minor * size }
            }
        }
    }

    /// The numbers by which moulds of one family are put in order.
    pub(super) fn order(&self) -> [f64; 3] {
        match *self {
            Self::Plane => [0.0, 0.0, 0.0],
            Self::Cylinder { radius } => [1.0, radius, 0.0],
            Self::Cone { half_angle } => [2.0, half_angle, 0.0],
            Self::Sphere { radius } => [3.0, radius, 0.0],
            Self::Torus { major_radius, minor_radius } => [4.0, minor_radius, major_radius],
        }
    }

    /// The surface of this form that touches a fitted one where that touches its panel.
    pub(super) fn near(&self, fitted: &BentPlane, size: f64) -> BentPlane {
        let mut shape = *fitted;
        match *self {
            Self::Plane => {}
            Self::Cylinder { radius } | Self::Sphere { radius } => {
                shape.across = (size / radius).copysign(fitted.across)
            }
            Self::Cone { half_angle } => shape.tilt = half_angle.copysign(fitted.tilt),
            Self::Torus { major_radius, minor_radius } => {
                let [major, _] = fitted.signed_torus_radii();
                shape.across = (size / minor_radius).copysign(fitted.across);
                shape.along = 1.0 / ((major_radius / size).copysign(major) + fitted.tilt.cos() / shape.across);
            }
        }
        shape
    }
}
