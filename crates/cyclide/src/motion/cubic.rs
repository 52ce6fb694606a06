//! Motions of degree 3 through four poses: they exist at certain cross-ratios of the times only.
//!
//! `D(t) = Σ λ_i D_i Π_{k≠i}(t − t_k)` is on the quadric iff `Mλ = 0`, and the antisymmetric 4 × 4 matrix M has a kernel iff its Pfaffian
//! vanishes. With the cross-ratio `x = (t_0−t_1)(t_2−t_3)/((t_0−t_2)(t_1−t_3))` and `A = B_01 B_23`, `B = B_02 B_13`, `C = B_03 B_12`
//! that is `B x² + (C − A − B) x + A = 0`; times rise iff `0 < x < 1`. Then the kernel is a plane: a family of motions of one parameter
//! (`docs/math/motions.md#four-poses`; G. Hegedüs, J. Schicho, H.-P. Schröcker 2015).

use super::odd_poses::{array, check_attained, lagrange_rows, plain_factors};
use super::pose::Pose;
use super::rational_motion::RationalMotion;
use super::study_form::{forms, largest, over_times};
use super::timed_pose::{Prepared, TimedPose};
use crate::error::{MotionError, PoseError, Result};

/// Cross-ratios as near as this to 0 and 1, where two times are one, are there.
const COINCIDENT: f64 = 1e-12;

/// The cross-ratios of the times at which motions of degree 3 take four poses, and these motions.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{CubicMotions, Pose}};
/// let pose = |w: f64, y: f64, x: f64, z: f64| Pose::new(Quat::new(w, 0.3, y, 0.1), Vec3::new(x, 1.0, z));
/// let poses = [pose(1.0, 0.0, 0.0, 0.0)?, pose(1.0, 0.5, 1.0, 0.2)?, pose(0.8, 0.9, 2.2, 1.0)?, pose(0.4, 1.2, 3.0, 1.0)?];
/// let cubics = CubicMotions::new(&poses)?;
/// for x in cubics.admissible() {
///     let motion = cubics.motion(x, [0.0, 1.0])?;
///     assert!((motion.pose(1.0).translation() - poses[3].translation()).length() < 1e-12);
/// }
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CubicMotions {
    poses: [Pose; 4],
    roots: Vec<f64>,
    discriminant: f64,
}

impl CubicMotions {
    /// Finds the cross-ratios of four poses: none, one or two.
    ///
    /// # Errors
    /// `wrong-pose-count`, `not-finite`; `study-form-vanishes`: all poses are planar, spherical or translated against each other, and every
    /// cross-ratio will do; or so many of them are that no cross-ratio is told from another.
    pub fn new(poses: &[Pose]) -> Result<Self> {
        let timed: Vec<TimedPose> =
            poses.iter().enumerate().map(|(i, pose)| TimedPose { time: i as f64, pose: *pose }).collect();
        let prepared = Prepared::of_count::<4>(&timed)?;
        let (b, limit) = (forms(&array::<_, 4>(&prepared.poses)), prepared.vanished);
        let size = largest(&b);
        if size <= limit {
            return Err(MotionError::StudyFormVanishes { measured: size, limit }.into());
        }
        // What is zero but for rounding would make roots of rounding.
        let b = b.map(|row| row.map(|v| if v.abs() <= limit { 0.0 } else { v / size }));
        let [p, q, r] = [b[0][1] * b[2][3], b[0][2] * b[1][3], b[0][3] * b[1][2]];
        let products = p.abs().max(q.abs()).max(r.abs());
        if products <= 0.0 {
            return Err(MotionError::StudyFormVanishes { measured: products, limit }.into());
        }
        let (roots, discriminant) = quadratic(q, r - p - q, p);
        Ok(Self { poses: array(poses), roots, discriminant })
    }

    /// Every cross-ratio at which there are motions, rising.
    #[must_use]
    pub fn cross_ratios(&self) -> &[f64] {
        &self.roots
    }

    /// Those between 0 and 1, at which the poses are taken one after the other.
    #[must_use]
    pub fn admissible(&self) -> Vec<f64> {
        self.roots.iter().copied().filter(|x| x.min(1.0 - x) > COINCIDENT).collect()
    }

    /// The motion of degree 3 over the times `[first, last]` at an admissible cross-ratio: it takes the poses at the parts 0, a,
    /// 1 − a and 1 of them with `a = √x/(1 + √x)`. Of the family, the one whose dual quaternions there are nearest to length 1.
    ///
    /// # Errors
    /// `no-cubic-motion` (the cross-ratio is not one of the [admissible](Self::admissible)), `unattainable-pose`,
    /// `motion-through-exceptional-point`, `not-finite`, `parameters-not-increasing`.
    pub fn motion(&self, cross_ratio: f64, [first, last]: [f64; 2]) -> Result<RationalMotion> {
        if !self.admissible().contains(&cross_ratio) {
            return Err(
                MotionError::NoCubicMotion { discriminant: self.discriminant, roots: self.roots.clone() }.into()
            );
        }
        if !(last > first) {
            return Err(PoseError::ParametersNotIncreasing { index: 3, value: last, before: first }.into());
        }
        let a = cross_ratio.sqrt() / (1.0 + cross_ratio.sqrt());
        let parts = [0.0, a, 1.0 - a, 1.0];
        let timed: Vec<TimedPose> = self
            .poses
            .iter()
            .zip(parts)
            .map(|(pose, part)| TimedPose { time: first + (last - first) * part, pose: *pose })
            .collect();
        let prepared = Prepared::of_count::<4>(&timed)?;
        let poses = array::<_, 4>(&prepared.poses);
        let m = over_times(&forms(&poses), &parts);
        let plain = plain_factors(&parts);
        // In the lengths of the dual quaternions at the poses, which are λ over the plain factors.
        let m = m.map(|row| std::array::from_fn(|j| row[j] * plain[j]));
        let lengths = nearest_in_kernel(&m);
        check_attained(&lengths)?;
        let factors: [f64; 4] = std::array::from_fn(|i| lengths[i] * plain[i]);
        let prepared = Prepared { places: parts.to_vec(), ..prepared };
        let motion = prepared.single(lagrange_rows(&poses, &factors, &parts))?;
        Ok(motion.half_turning(prepared.half_turns))
    }
}

/// The real roots of `a x² + b x + c`, rising, and the discriminant over the squared coefficients. A root that is there twice up to rounding is
/// one.
fn quadratic(a: f64, b: f64, c: f64) -> (Vec<f64>, f64) {
    let size = a.abs().max(b.abs()).max(c.abs());
    let discriminant = (b * b - 4.0 * a * c) / (size * size);
    if !(discriminant >= 0.0) {
        return (Vec::new(), discriminant);
    }
    let root = discriminant.sqrt() * size;
    let q = -0.5 * (b + if b < 0.0 { -root } else { root });
    let mut roots: Vec<f64> = [q / a, c / q].into_iter().filter(|x| x.is_finite()).collect();
    roots.sort_by(f64::total_cmp);
    roots.dedup();
    (roots, discriminant)
}

/// The vector of the kernel of a matrix of rank 2 that is nearest to `(1, 1, 1, 1)`: what is left of that across two of the rows.
fn nearest_in_kernel(m: &[[f64; 4]; 4]) -> [f64; 4] {
    let dot = |a: &[f64; 4], b: &[f64; 4]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let unit = |v: [f64; 4]| v.map(|x| x / dot(&v, &v).sqrt());
    let across = |v: &[f64; 4], u: &[f64; 4]| -> [f64; 4] {
        let part = dot(v, u);
        std::array::from_fn(|i| v[i] - part * u[i])
    };
    let longest =
        |rows: [[f64; 4]; 4]| rows.into_iter().max_by(|a, b| dot(a, a).total_cmp(&dot(b, b))).unwrap_or_default();
    let first = unit(longest(*m));
    let second = unit(longest(m.map(|row| across(&row, &first))));
    across(&across(&[1.0; 4], &first), &second)
}
