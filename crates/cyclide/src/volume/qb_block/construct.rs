//! The block of seven corners, three directions and three twists (`docs/math/bilinear-patches.md#blocks`).

use super::QbBlock;
use crate::base::elimination::{null_vector, solution};
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, Result, VolumeError};
use crate::surface::{CornerTwist, QbPatch};
use crate::volume::cyclide_volume::check_no_pole;

/// Pairs whose last pivot is below this part of the first are dependent; a null vector of the form, to this part of its length.
const LIMIT: f64 = 1e-12;
/// Largest distance from three-space that counts as rounding, relative to the size.
const SPACE_LIMIT: f64 = 1e-9;

/// Cells looked at for a pole: the denominator of a block may be tiny along a whole curve, and is then 1e-4 of the weights or less.
const CELLS: usize = 1 << 15;

/// Which of the two blocks over three faces.
///
/// ```no_run
/// use cyclide::{Point3, Vec3, surface::CornerTwist, volume::{BlockBranch, QbBlock}};
/// let corners = [
///     [0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [0.0, 1.0, 0.1], [0.9, 1.1, 0.0],
///     [0.1, 0.0, 1.0], [1.0, 0.0, 1.1], [0.0, 1.0, 1.0],
/// ].map(Point3::from);
/// let directions = [Vec3::new(1.0, 0.1, 0.2), Vec3::new(-0.1, 1.0, 0.1), Vec3::new(0.1, 0.0, 1.0)];
/// let made = |branch| QbBlock::new(corners, directions, [CornerTwist::Default; 3], branch);
/// let (one, other) = (made(BlockBranch::Miquel)?, made(BlockBranch::Other)?);
/// assert!(one.corners()[6] == other.corners()[6] && one.corners()[7] != other.corners()[7]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum BlockBranch {
    /// The one whose coordinate surfaces cross at right angles where the faces do: its last corner is then that of A. Miquel's theorem.
    #[default]
    Miquel,
    /// The other one.
    Other,
}

/// A pair (n, D) as eight numbers.
type Pair = [f64; 8];

impl QbBlock {
    /// The block over seven corners, in binary order with the first parameter fastest and without the last, with the directions of growing s,
    /// t and u at the first of them (any length, any angle) and the twists of the faces (s, t), (s, u) and (t, u) there, as
    /// [`QbPatch::from_directions`] takes them. There are exactly two such blocks, in general.
    ///
    /// # Errors
    /// Those of [`QbPatch::from_directions`] for each of the three faces but `patch-through-infinity`; `degenerate-block` (the three faces leave more than two blocks, as those of
    /// a cuboid with directions along its edges do), `volume-through-infinity`, `not-in-space` if rounding destroyed the result.
    pub fn new(
        corners: [Point3; 7],
        directions: [Vec3; 3],
        twists: [CornerTwist; 3],
        branch: BlockBranch,
    ) -> Result<Self> {
        let face = |[i, j]: [usize; 2], twist| {
            let at = [0, 1 << i, 1 << j, 1 << i | 1 << j].map(|k: usize| corners[k]);
            QbPatch::weights_of(&at, [directions[i], directions[j]], twist)
        };
        let sides = [[0, 1], [0, 2], [1, 2]];
        let mut weights = [Quat::ONE; 7];
        for ([i, j], twist) in sides.into_iter().zip(twists) {
            let [_, a, b, last] = face([i, j], twist)?;
            (weights[1 << i], weights[1 << j], weights[1 << i | 1 << j]) = (a, b, last);
        }
        let scale = corners.iter().map(|p| p.distance(corners[0])).fold(0.0, f64::max);
        let pairs: [Pair; 7] = std::array::from_fn(|k| {
            let numerator = Quat::from((corners[k] - corners[0]) / scale) * weights[k];
            joined(numerator, weights[k])
        });
        let last = last_pair(&pairs, branch)?;
        let (numerator, weight) = (Quat::from(first_half(last)), Quat::from(second_half(last)));
        let end = weight.inverse().map(|inverse| (numerator * inverse).vector() * scale);
        let end = end.filter(|end| end.is_finite()).ok_or(VolumeError::ThroughInfinity { at: [1.0; 3] })?;
        let all: [Point3; 8] = std::array::from_fn(|k| corners.get(k).copied().unwrap_or(corners[0] + end));
        range::check_point(7, all[7].to_vec())?;
        let weights: [Quat; 8] = std::array::from_fn(|k| weights.get(k).copied().unwrap_or(weight));
        check_no_pole(&weights, CELLS)?;
        let block = Self::from_weights_unchecked(all, weights);
        block.check_in_space()?;
        Ok(block)
    }

    /// # Errors
    /// `not-in-space`.
    fn check_in_space(&self) -> Result<()> {
        let places = [0.0, 0.25, 0.5, 0.75, 1.0];
        let all = (0..125).map(|k| [places[k % 5], places[k / 5 % 5], places[k / 25]]);
        let defect = all.map(|at| self.real_residual(at)).fold(0.0, f64::max) / self.size();
        // Not a number is no defect that is allowed.
        if defect <= SPACE_LIMIT {
            Ok(())
        } else if defect.is_nan() {
            Err(NumberError::NotFinite { what: ErrorItem::Weight, index: 7 }.into())
        } else {
            Err(crate::error::PatchError::NotInSpace { defect, limit: SPACE_LIMIT }.into())
        }
    }
}

/// The last pair: seven linear equations, that the coefficients of the real part vanish, and an eighth for the branch.
///
/// # Errors
/// `degenerate-block`.
fn last_pair(pairs: &[Pair; 7], branch: BlockBranch) -> Result<Pair> {
    // By the directions that their corners are in.
    let [x0, x1, x2, x12, x3, x13, x23] = *pairs;
    let rows = [x0, x1, x2, x3, x12, x13, x23];
    let degenerate = |measured: f64| VolumeError::DegenerateBlock { measured, limit: LIMIT };
    let (across, independence) = null_vector(rows).ok_or(degenerate(0.0))?;
    if independence <= LIMIT {
        return Err(degenerate(independence).into());
    }
    // Orthogonal to all of them in the form: the blocks differ by a multiple of it.
    let null = (2.0 * dot4(first_half(across), second_half(across))).abs() / across.iter().map(|x| x * x).sum::<f64>();
    if null <= LIMIT {
        return Err(degenerate(null).into());
    }
    let z = form(&x0, &x23) * form(&x12, &x13);
    let y = form(&x0, &x13) * form(&x12, &x23);
    let x = form(&x0, &x12) * form(&x13, &x23);
    let [e1, e2, e3] = [form(&x1, &x23), form(&x2, &x13), form(&x3, &x12)];
    let e0 = -(e1 + e2 + e3);
    let s = x * x + y * y + z * z - 2.0 * (x * y + y * z + z * x)
        + e0 * e1 * e2 * e3
        + z * (e0 * e1 + e2 * e3)
        + y * (e0 * e2 + e1 * e3)
        + x * (e0 * e3 + e1 * e2);
    let sign = match branch {
        BlockBranch::Miquel => -1.0,
        BlockBranch::Other => 1.0,
    };
    // The determinant with a last row is that row times a multiple of the vector across all of them.
    let of_across = determinant(std::array::from_fn(|k| rows.get(k).copied().unwrap_or(across)));
    let size = across.iter().map(|x| x * x).sum::<f64>();
    let by_branch = across.map(|x| x * of_across / size);
    let equations: [([f64; 8], f64); 8] = [
        (turned(&x12), 0.0),
        (turned(&x13), 0.0),
        (turned(&x23), 0.0),
        (turned(&x1), -form(&x12, &x13)),
        (turned(&x2), -form(&x12, &x23)),
        (turned(&x3), -form(&x13, &x23)),
        (turned(&x0), e0),
        (by_branch, sign * s),
    ];
    let balanced = equations.map(|(row, value)| {
        let largest = row.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        std::array::from_fn(|k| row.get(k).copied().unwrap_or(value) / largest)
    });
    Ok(solution::<8, 9>(balanced).ok_or(degenerate(0.0))?)
}

fn joined(n: Quat, d: Quat) -> Pair {
    let (n, d) = (n.to_array(), d.to_array());
    std::array::from_fn(|k| if k < 4 { n[k] } else { d[k - 4] })
}

fn first_half(p: Pair) -> [f64; 4] {
    std::array::from_fn(|k| p[k])
}

fn second_half(p: Pair) -> [f64; 4] {
    std::array::from_fn(|k| p[k + 4])
}

fn dot4(a: [f64; 4], b: [f64; 4]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The halves exchanged: its scalar product with a pair is the form.
fn turned(p: &Pair) -> Pair {
    std::array::from_fn(|k| p[(k + 4) % 8])
}

/// `<X, Y> = Re(n ~D' + n' ~D)`.
fn form(a: &Pair, b: &Pair) -> f64 {
    a.iter().zip(turned(b)).map(|(x, y)| x * y).sum()
}

/// By elimination with row pivots.
fn determinant(mut rows: [Pair; 8]) -> f64 {
    let mut product = 1.0;
    for column in 0..8 {
        let largest = (column..8).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()));
        let pivot = largest.unwrap_or(column);
        if pivot != column {
            rows.swap(pivot, column);
            product = -product;
        }
        let head = rows[column];
        product *= head[column];
        if head[column] == 0.0 {
            return 0.0;
        }
        for row in rows.iter_mut().skip(column + 1) {
            let factor = row[column] / head[column];
            row.iter_mut().zip(head).for_each(|(x, h)| *x -= factor * h);
        }
    }
    product
}
