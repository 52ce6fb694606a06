//! Folds: where the Jacobian changes its sign (`docs/math/bilinear-patches.md#blocks`).

use super::QbBlock;
use crate::volume::FoldVerdict;

/// Boxes are halved in all directions this often.
const HALVINGS: u32 = 6;
/// Boxes looked at at most.
const BOXES: usize = 512;
/// Rounding of the Jacobian relative to the largest product of the lengths of its vectors.
const ROUNDING: f64 = 4096.0 * f64::EPSILON;

/// From values at 0, 1/4, 1/2, 3/4, 1 to the Bernstein coefficients of degree 4.
const TO_BERNSTEIN: [[f64; 5]; 5] = [
    [1.0, 0.0, 0.0, 0.0, 0.0],
    [-13.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25],
    [13.0 / 18.0, -32.0 / 9.0, 20.0 / 3.0, -32.0 / 9.0, 13.0 / 18.0],
    [-0.25, 4.0 / 3.0, -3.0, 4.0, -13.0 / 12.0],
    [0.0, 0.0, 0.0, 0.0, 1.0],
];

impl QbBlock {
    /// Whether the block folds. Its Jacobian is `K·(L × M)/|D|⁶` times the cube of the size, of degree (4, 4, 4) but for the denominator: the signs of
    /// its Bernstein coefficients prove it, those of smaller boxes where those of the whole do not. Its sign is that of the directions.
    #[must_use]
    pub fn folds(&self) -> FoldVerdict {
        let wanted = 1.0_f64.copysign(self.element([0.0; 3]));
        let lengths = (0..3).map(|axis| {
            let all = self.along[axis].iter().flatten().map(|v| v.iter().map(|x| x * x).sum::<f64>().sqrt());
            all.fold(0.0, f64::max)
        });
        let rounding = ROUNDING * lengths.product::<f64>();
        let (mut open, mut undecided, mut looked_at) = (vec![([0.0; 3], 0)], None, 0);
        while let Some((from, depth)) = open.pop() {
            looked_at += 1;
            let size = 0.5_f64.powi(depth as i32);
            let coefficients = self.bernstein(from, size).map(|c| c * wanted);
            let corner = (0..8).find(|k| coefficients[[0, 4, 20, 24, 100, 104, 120, 124][*k]] < -rounding);
            if let Some(k) = corner {
                return FoldVerdict::Folded {
                    at: std::array::from_fn(|axis| from[axis] + size * (k >> axis & 1) as f64),
                };
            }
            if coefficients.iter().all(|c| *c > rounding) {
                continue;
            }
            let middle = from.map(|x| x + 0.5 * size);
            if depth == HALVINGS || looked_at >= BOXES {
                undecided = undecided.or(Some(FoldVerdict::Undecided { at: middle, depth }));
                continue;
            }
            let octants =
                (0..8_usize).map(|k| std::array::from_fn(|axis| from[axis] + 0.5 * size * (k >> axis & 1) as f64));
            open.extend(octants.map(|at| (at, depth + 1)));
        }
        undecided.unwrap_or(FoldVerdict::Regular)
    }

    /// `K·(L × M)`.
    fn element(&self, at: [f64; 3]) -> f64 {
        let [k, l, m] = [0, 1, 2].map(|axis| self.along(axis, at));
        k.dot(l.cross(m))
    }

    /// Its 125 Bernstein coefficients on a box, the first parameter fastest.
    fn bernstein(&self, from: [f64; 3], size: f64) -> [f64; 125] {
        let mut c: [f64; 125] = std::array::from_fn(|k| {
            let places = [k % 5, k / 5 % 5, k / 25];
            self.element(std::array::from_fn(|axis| from[axis] + 0.25 * size * places[axis] as f64))
        });
        for stride in [1, 5, 25] {
            for start in (0..125).filter(|k| k / stride % 5 == 0) {
                let values: [f64; 5] = std::array::from_fn(|k| c[start + k * stride]);
                for (k, row) in TO_BERNSTEIN.iter().enumerate() {
                    c[start + k * stride] = row.iter().zip(values).map(|(a, v)| a * v).sum();
                }
            }
        }
        c
    }
}
