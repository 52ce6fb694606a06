//! Oriented spheres and planes in linear coordinates, and their images under Möbius maps.

use super::mobius::Mobius;
use crate::base::quat::Quat;
use crate::base::vector::Vec3;

/// The oriented sphere or plane `w |x|² - 2 v·x + k = 0` with `h² = |v|² - w k`: center `v/w` and signed radius `h/w`, a
/// plane if `w = 0`. A common factor changes nothing, and all is linear: sums need not be spheres themselves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LieSphere {
    pub(crate) w: f64,
    pub(crate) v: Vec3,
    pub(crate) k: f64,
    pub(crate) h: f64,
}

impl LieSphere {
    /// The sphere moved by a vector.
    #[must_use]
    pub(crate) fn translated(&self, by: Vec3) -> Self {
        let k = self.k + 2.0 * self.v.dot(by) + self.w * by.length_squared();
        Self { v: self.v + by * self.w, k, ..*self }
    }

    /// The image under a map, up to a factor that is the same for all spheres; the orientation is pushed forward. The
    /// sphere is given relative to the source of the map, its image relative to the target.
    ///
    /// The sphere is `(x, 1)^* H (x, 1) = 0` with the Hermitian matrix `H = (w, -v; v, k)` of quaternions; its image is
    /// that of `M^-1^* H M^-1`, with the inverse matrix of [`Mobius::inverse`].
    #[must_use]
    pub(crate) fn mapped(&self, map: &Mobius) -> Self {
        let ([a, b, c, d], Self { w, v, k, h }) = (map.matrix(), *self);
        let v = Quat::from(v);
        let form = |p: Quat, q: Quat| w * p.norm_squared() - 2.0 * (p * v * q.conj()).w + k * q.norm_squared();
        let image = d * v * a.conj() - c * v * b.conj() - d * b.conj() * w - c * a.conj() * k;
        Self { w: form(d, c), v: image.vector(), k: form(b, a), h: h * map.determinant().abs() }
    }
}
