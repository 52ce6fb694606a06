//! Where a volume folds: signs of its three speeds, proved by their Bernstein coefficients and by halving.

use crate::base::bernstein::split;

/// Squares are quartered this often.
const QUARTERINGS: u32 = 12;
/// Squares looked at for one speed at most: along a curve of zeros they double with each quartering.
const SQUARES: usize = 16384;

/// What is known of a volume's folds.
///
/// ```
/// use cyclide::{Point3, Vec3, volume::{CyclideVolume, FoldVerdict, SphericalCube, VolumeFrame}};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X * 2.0, Vec3::Y * 3.0, Vec3::Z])?;
/// let block = |v: [f64; 3], w: [f64; 3]| CyclideVolume::new(&cube, VolumeFrame::First(v.into(), w.into()));
/// assert_eq!(block([1.0, 0.2, 0.0], [-0.2, 1.0, 0.0])?.folds(), FoldVerdict::Regular);
/// // With a frame far from the sides its arcs bend through each other.
/// assert!(matches!(block([0.0, 0.1, 1.0], [0.0, -1.0, 0.1])?.folds(), FoldVerdict::Folded { .. }));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FoldVerdict {
    /// The Jacobian has one sign, proved.
    Regular,
    /// The lines of one direction run backwards at this place, or stand still.
    Folded {
        /// The place s, t, u.
        at: [f64; 3],
    },
    /// Neither is proved: near this place a speed is too near to zero for the depth of the search.
    Undecided {
        /// The place s, t, u.
        at: [f64; 3],
        /// How often squares about it were quartered.
        depth: u32,
    },
}

/// What is known of the sign of one biquadratic on the unit square, with the place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Sign {
    /// Positive, but for corners or sides on which it is exactly zero.
    Positive,
    /// Not above the rounding there.
    NotPositive([f64; 2]),
    Undecided([f64; 2], u32),
}

/// The sign of a biquadratic whose values are known up to `rounding`.
pub(super) fn sign(q: &[[f64; 3]; 3], rounding: f64) -> Sign {
    let mut open = vec![(*q, [0.0; 2], 0)];
    let mut undecided = None;
    let mut looked_at = 0;
    while let Some((q, from, depth)) = open.pop() {
        looked_at += 1;
        let size = 0.5_f64.powi(depth as i32);
        let negative = [[0, 0], [0, 2], [2, 0], [2, 2]].into_iter().find(|&[i, j]| q[i][j] < -rounding);
        if let Some([i, j]) = negative {
            return Sign::NotPositive([from[0] + 0.5 * size * i as f64, from[1] + 0.5 * size * j as f64]);
        }
        // Sides of one point have the speed zero exactly.
        let all = || q.iter().flatten();
        if all().all(|&c| c > rounding || c == 0.0) && all().any(|&c| c > 0.0) {
            continue;
        }
        if depth == QUARTERINGS || looked_at >= SQUARES {
            undecided = undecided.or(Some(Sign::Undecided([from[0] + 0.5 * size, from[1] + 0.5 * size], depth)));
            continue;
        }
        let parts = |q: &[[f64; 3]; 3]| <[_; 2]>::from(split(q, 0.5)).map(|half| transposed(&half));
        for (i, half) in parts(&q).iter().enumerate() {
            for (j, quarter) in parts(half).into_iter().enumerate() {
                open.push((quarter, [from[0] + 0.5 * size * i as f64, from[1] + 0.5 * size * j as f64], depth + 1));
            }
        }
    }
    undecided.unwrap_or(Sign::Positive)
}

/// Three rows as columns.
fn transposed(rows: &[[f64; 3]]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| rows[j][i]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The Bernstein coefficients of `(x - p)² + (y - p)² + c`.
    fn bowl(p: f64, c: f64) -> [[f64; 3]; 3] {
        let square = [p * p, p * (p - 1.0), (1.0 - p) * (1.0 - p)];
        std::array::from_fn(|i| std::array::from_fn(|j| square[i] + square[j] + c))
    }

    #[test]
    fn signs_are_proved() {
        assert_eq!(sign(&bowl(0.3, 1e-6), 0.0), Sign::Positive);
        assert!(matches!(sign(&bowl(0.3, -1e-3), 0.0), Sign::NotPositive([x, y]) if (x - 0.3).hypot(y - 0.3) < 0.04));
        assert!(matches!(sign(&bowl(0.3, 0.0), 1e-16), Sign::Undecided([x, y], _) if (x - 0.3).hypot(y - 0.3) < 1e-3));
        // A side of one point is no fold.
        assert_eq!(sign(&[[0.0; 3], [1.0; 3], [2.0; 3]], 1e-16), Sign::Positive);
    }
}
