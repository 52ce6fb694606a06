//! Many points and Jacobians of one s-line at once, into the caller's buffers.

use super::{CyclideVolume, biquadratic_at, line};
use crate::base::quadratic::{self, powers};
use crate::base::quat::Quat;
use crate::batch;

/// Parameters handled together: the lanes of a block with its parameters stay in the first-level cache.
const BLOCK: usize = 256;

/// One s-line of a volume in the form that is fastest for many points: real quadratics over one common denominator.
///
/// Numerator and denominator are linear along the line, as on a [patch](crate::surface::PatchRow), and the Jacobian is
/// `q1(t,u) q2(s,u) q3(s,t)/|D|⁶` (`docs/math/volumes.md#speeds`): a constant and two quadratics over the third power of the denominator.
///
/// # Accuracy
///
/// With `r = max |D|²/min |D|²` over the line, points are within `32 ε r` of the block's size or, where the line bulges farther, of its largest
/// distance from the first corner, plus 2 units of the last place of the coordinates, of [`point`](crate::volume::ParamVolume::point): the proof is that
/// of [`PatchRow`](crate::surface::PatchRow). Jacobians are within `64 ε r` of `|q1| Q2 Q3/|D|⁶` of [`jacobian`](crate::volume::ParamVolume::jacobian), where
/// `Q2` and `Q3` are the largest sizes of the Bernstein coefficients of the two quadratics: each is rounded by `8 ε` of these at most, since its
/// coefficients by powers are up to four times as large, and the denominator by `16 ε r` of itself, three times. The results are the same on every
/// machine.
///
/// ```
/// use cyclide::{Point3, volume::{CyclideVolume, ParamVolume, SphericalCube, VolumeFrame}};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.1], [-0.2, 1.0, 0.1], [0.1, -0.1, 0.9]].map(Point3::from);
/// let block = CyclideVolume::new(&SphericalCube::from_barycentric(corners, [1.0; 3], 0.5)?, VolumeFrame::Auto)?;
/// let (s, [mut x, mut y, mut z, mut j]) = ([0.0, 0.25, 1.0], [[0.0; 3]; 4]);
/// block.row([0.5, 0.8]).points_and_jacobians(&s, [&mut x, &mut y, &mut z], &mut j);
/// assert!((block.point([0.25, 0.5, 0.8]).y - y[1]).abs() < 1e-14);
/// assert!((block.jacobian([0.25, 0.5, 0.8]) - j[1]).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct VolumeRow {
    points: [[f64; 3]; 3],
    denominator: [f64; 3],
    origin: [f64; 3],
    /// `q1` with the handedness, and `q2`, `q3` by powers of s.
    speed: f64,
    across: [[f64; 3]; 2],
}

impl CyclideVolume {
    /// The s-line at `[t, u]`, set up for many points.
    #[must_use]
    pub fn row(&self, [t, u]: [f64; 2]) -> VolumeRow {
        let end = |q: &[Quat; 8], k: usize| line(line(q[k], q[k + 2], t), line(q[k + 4], q[k + 6], t), u);
        let ([n0, n1], [d0, d1]) = ([0, 1].map(|k| end(&self.n, k)), [0, 1].map(|k| end(&self.weights, k)));
        let a = (n0 * d0.conj()).vector() * self.scale;
        let b = (n0 * d1.conj() + n1 * d0.conj()).vector() * self.scale;
        let c = (n1 * d1.conj()).vector() * self.scale;
        // Of q2(s,u) and q3(s,t) the outer index is that of s.
        let along_s = |q: &[[f64; 3]; 3], x: f64| {
            let [a, b, c] = q.map(|row| quadratic::value(&row, x));
            powers(a, 2.0 * b, c)
        };
        VolumeRow {
            points: [powers(a.x, b.x, c.x), powers(a.y, b.y, c.y), powers(a.z, b.z, c.z)],
            denominator: powers(d0.norm_squared(), 2.0 * d0.dot(d1), d1.norm_squared()),
            origin: self.corners[0].to_array(),
            speed: biquadratic_at(&self.speeds[0], t, u) * self.handedness(),
            across: [along_s(&self.speeds[1], u), along_s(&self.speeds[2], t)],
        }
    }
}

impl VolumeRow {
    /// The points at the parameters `s`, coordinate by coordinate. As many as the shortest slice holds; nothing is allocated.
    pub fn points(&self, s: &[f64], out: [&mut [f64]; 3]) {
        batch::points(&self.points, self.denominator, self.origin, s, out);
    }

    /// The points and the Jacobians at the parameters `s`; as [`points`](Self::points).
    pub fn points_and_jacobians(&self, s: &[f64], points: [&mut [f64]; 3], jacobians: &mut [f64]) {
        let mut points = points;
        let n = points.iter().map(|lane| lane.len()).fold(s.len().min(jacobians.len()), usize::min);
        for start in (0..n).step_by(BLOCK) {
            let block = start..n.min(start + BLOCK);
            let lanes = points.each_mut().map(|lane| &mut lane[block.clone()]);
            let factors = (self.speed, self.across);
            let (s, jacobians) = (&s[block.clone()], &mut jacobians[block]);
            batch::points_and_products(&self.points, factors, self.denominator, self.origin, s, lanes, jacobians);
        }
    }
}
