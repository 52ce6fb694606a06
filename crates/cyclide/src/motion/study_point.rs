//! Points of the Study quadric: displacements, and points of space as quotients.

use super::dual_quat::DualQuat;
use super::pose::Pose;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, PoseError, Result};

/// Part of `|p||r|` that the product `p·r` may have: beyond, the pair is no displacement (`003`, section 2).
const OFF_QUADRIC: f64 = 1e-9;

/// A dual quaternion `p + ε r` with `p ≠ 0` on the Study quadric `p·r = 0`: a displacement, up to a real factor
/// (`docs/math/motions.md#the-study-quadric`).
///
/// ```
/// use cyclide::{Point3, Quat, motion::StudyPoint};
/// // A turn by 90 degrees about z, at the point (2, 0, 0).
/// let p = Quat::new(1.0, 0.0, 0.0, 1.0);
/// let there = StudyPoint::from_quotient(Quat::new(0.0, 2.0, 0.0, 0.0) * p, p)?;
/// assert!(there.quotient().distance(Point3::new(2.0, 0.0, 0.0)) < 1e-15);
/// assert!(there.displace(Point3::new(1.0, 0.0, 0.0)).distance(Point3::new(4.0, 1.0, 0.0)) < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StudyPoint {
    at: DualQuat,
}

impl StudyPoint {
    /// The point of a dual quaternion on the quadric; what is off it by rounding is projected along its fiber.
    ///
    /// # Errors
    /// `not-finite`, `point-at-infinity` (the real part is zero), `not-on-study-quadric`.
    pub fn new(at: DualQuat) -> Result<Self> {
        if !at.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Pose, index: 0 }.into());
        }
        let sizes = [at.real.norm(), at.dual.norm()];
        if sizes[0] == 0.0 {
            return Err(Error::at_infinity(ErrorItem::Pose, 0));
        }
        // Each part by its own length first: their product may under- or overflow.
        let product =
            if sizes[1] > 0.0 { (at.real * (1.0 / sizes[0])).dot(at.dual * (1.0 / sizes[1])).abs() } else { 0.0 };
        if product > OFF_QUADRIC {
            return Err(PoseError::NotOnStudyQuadric { product, limit: OFF_QUADRIC }.into());
        }
        at.fibre_projected().map(|at| Self { at }).ok_or(Error::at_infinity(ErrorItem::Pose, 0))
    }

    /// The point with the quotient `num den⁻¹` as its place: `den + ε num`. A point `a` of weight `w` is `(a w, w)`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_quotient(num: Quat, den: Quat) -> Result<Self> {
        Self::new(DualQuat { real: den, dual: num })
    }

    /// The same point in the convention of the paper (`003`, section 2), where `(p; q)` moves by `x ↦ (p x − 2 q) p⁻¹`: `r = −q`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_paper(p: Quat, q: Quat) -> Result<Self> {
        Self::new(DualQuat { real: p, dual: -q })
    }

    /// The pair `[p, q]` of the paper's convention.
    #[must_use]
    pub fn to_paper(self) -> [Quat; 2] {
        [self.at.real, -self.at.dual]
    }

    /// The dual quaternion, of any length.
    #[must_use]
    pub fn dual_quat(self) -> DualQuat {
        self.at
    }

    /// The point `r p⁻¹` of space; half the translation.
    #[must_use]
    pub fn quotient(self) -> Point3 {
        Point3::ORIGIN + self.translation() * 0.5
    }

    /// The translation `2 r p⁻¹`.
    #[must_use]
    pub fn translation(self) -> Vec3 {
        self.at.translation().unwrap_or_default()
    }

    /// Where the displacement takes a point: `x ↦ (p x + 2 r) p⁻¹`.
    #[must_use]
    pub fn displace(self, point: Point3) -> Point3 {
        self.pose().apply(point)
    }

    /// The displacement as a pose.
    #[must_use]
    pub fn pose(self) -> Pose {
        Pose::of_unit(self.at.real * (1.0 / self.at.real.norm()), self.translation())
    }
}

impl From<Pose> for StudyPoint {
    fn from(pose: Pose) -> Self {
        Self { at: pose.dual_quat() }
    }
}
