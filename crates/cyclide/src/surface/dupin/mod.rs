//! Whole Dupin cyclides by their parameters.
//!
//! In its own frame (origin at the center, both planes of symmetry `y = 0` and `z = 0`) the cyclide `a > c >= 0`,
//! `mu >= 0`, `b² = a² - c²` is
//! ```text
//! (|p|² + b² - mu²)² = 4 (a x - c mu)² + 4 b² y²
//! ```
//! (`docs/math/cyclides-and-nets.md#cyclides-by-parameters`). For `c = 0` it is the torus of radii `a` and `mu`.

mod build;
mod transform;

use crate::base::frame::Frame;
use crate::error::{ErrorItem, NumberError, Result};

/// Parameters closer than this part of `a` make the two nodes one.
const NODE_LIMIT: f64 = 1e-12;

/// The three forms of a Dupin cyclide without points at infinity.
///
/// ```
/// use cyclide::surface::{CyclideKind, DupinCyclide};
/// let kind = |c, mu| DupinCyclide::new(4.0, c, mu).map(|cyclide| cyclide.kind());
/// assert_eq!((kind(1.0, 2.0)?, kind(2.0, 1.5)?, kind(2.0, 5.0)?), (CyclideKind::Ring, CyclideKind::Horn, CyclideKind::Spindle));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CyclideKind {
    /// `c < mu < a`: no singular point, one closed surface.
    Ring,
    /// `mu <= c`: two closed surfaces side by side that touch each other in two nodes (for `mu = c`, one surface that
    /// touches itself in one node).
    Horn,
    /// `mu >= a`: a closed surface inside another that touches it in two nodes (for `mu = a`, one surface that touches
    /// itself in one node).
    Spindle,
}

/// A whole Dupin cyclide in space.
///
/// ```
/// use cyclide::surface::DupinCyclide;
/// let ring = DupinCyclide::new(4.0, 1.0, 2.0)?;
/// assert!(ring.to_bodies([6, 6])?[0].is_solid());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DupinCyclide {
    a: f64,
    c: f64,
    mu: f64,
    frame: Frame,
}

impl DupinCyclide {
    /// The cyclide with half axes `a > c >= 0` and `mu >= 0` in the frame of the coordinate axes; `c = mu = 0`, a
    /// circle, is refused. Cyclides through infinity (parabolic ones), planes and spheres have no such parameters.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (`a` outside 1e-150 to 1e150; `c` outside 0 to `a (1 - 1e-12)`; `mu`
    /// outside 0 to `1e6 a`, and for `c = 0` below `1e-6 a`).
    pub fn new(a: f64, c: f64, mu: f64) -> Result<Self> {
        for (index, value) in [a, c, mu].into_iter().enumerate() {
            if !value.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Parameter, index }.into());
            }
        }
        let limits = [
            (ErrorItem::HalfAxisA, a, 1e-150, 1e150),
            (ErrorItem::HalfAxisC, c, 0.0, a * (1.0 - NODE_LIMIT)),
            (ErrorItem::Mu, mu, if c <= 1e-6 * a { 1e-6 * a } else { 0.0 }, 1e6 * a),
        ];
        for (name, value, min, max) in limits {
            if !(min..=max).contains(&value) {
                return Err(NumberError::ParameterOutOfRange { name, value, min, max }.into());
            }
        }
        Ok(Self { a, c, mu, frame: Frame::WORLD })
    }

    /// The same cyclide in another frame: center at the origin, long axis along x, the plane of the axes z = 0.
    #[must_use]
    pub fn placed(mut self, frame: Frame) -> Self {
        self.frame = frame;
        self
    }

    /// The parameters `[a, c, mu]`, lengths.
    #[must_use]
    pub fn parameters(&self) -> [f64; 3] {
        [self.a, self.c, self.mu]
    }

    /// Where the cyclide stands.
    #[must_use]
    pub fn frame(&self) -> Frame {
        self.frame
    }

    /// Ring, horn or spindle.
    #[must_use]
    pub fn kind(&self) -> CyclideKind {
        if self.mu <= self.c + NODE_LIMIT * self.a {
            CyclideKind::Horn
        } else if self.mu >= self.a * (1.0 - NODE_LIMIT) {
            CyclideKind::Spindle
        } else {
            CyclideKind::Ring
        }
    }

    /// The surface at signed distance `h`, which has another `mu` only
    /// (`docs/math/cyclides-and-nets.md#cyclides-by-parameters`). For `h > 0` it is outside a ring, both parts of a
    /// spindle and the larger part of a horn, and inside the smaller part of a horn.
    ///
    /// # Errors
    /// As [`new`](Self::new), if `mu + h` is out of range.
    pub fn offset(&self, h: f64) -> Result<Self> {
        Ok(Self::new(self.a, self.c, self.mu + h)?.placed(self.frame))
    }
}
