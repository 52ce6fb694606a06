//! Where a piece crosses a parallel or a meridian: the roots of a quadratic.
//!
//! The direction of `A` is `z0 z1 z2`, that of `B` is `z1 conj(z2) z3`, of which two factors are linear in the parameter at most and the
//! others rest. So `Im(exp(-iA*) z0 z1 z2) = 0`, which says `A = A*` modulo pi, has degree 2.

use super::piece::TorusPiece;
use crate::base::complex::Complex;

/// An angle of a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PlaceAngle {
    /// `A`, half the longitude.
    Around,
    /// `B`, round the tube.
    Tube,
}

impl TorusPiece {
    /// The parameters between 0 and 1, increasing, at which an angle is `value` modulo pi; none where it is all along.
    pub(crate) fn crossings(&self, angle: PlaceAngle, value: f64) -> Vec<f64> {
        let back = Complex::at_angle(-value);
        let height = |s: f64| {
            let pair = self.direction_polynomials(s);
            let along = match angle {
                PlaceAngle::Around => pair.a,
                PlaceAngle::Tube => pair.b,
            };
            (back * along).im
        };
        let [first, middle, last] = [0.0, 0.5, 1.0].map(height);
        // Bernstein coefficients of the quadratic through three of its values.
        bernstein_roots([first, 2.0 * middle - 0.5 * (first + last), last])
    }
}

/// The roots between 0 and 1 of `b0 (1-s)² + 2 b1 s (1-s) + b2 s²`, increasing.
fn bernstein_roots([b0, b1, b2]: [f64; 3]) -> Vec<f64> {
    let discriminant = b1 * b1 - b0 * b2;
    if discriminant < 0.0 {
        return Vec::new();
    }
    let mut roots: Vec<f64> = crate::base::roots::projective_quadratic(b0, b1, b2, discriminant.sqrt())
        .into_iter()
        .flatten()
        .filter(|s| *s > 0.0 && *s < 1.0)
        .collect();
    roots.sort_by(f64::total_cmp);
    roots.dedup();
    roots
}

#[cfg(test)]
mod tests {
    use super::bernstein_roots;

    #[test]
    fn roots_inside_are_found_in_order() {
        // (s - 1/4)(s - 3/4): values 3/16, 3/16 at the ends.
        let [b0, b2] = [3.0 / 16.0; 2];
        let middle = -1.0 / 16.0;
        let roots = bernstein_roots([b0, 2.0 * middle - 0.5 * (b0 + b2), b2]);
        assert!(roots.len() == 2 && (roots[0] - 0.25).abs() < 1e-15 && (roots[1] - 0.75).abs() < 1e-15, "{roots:?}");
        assert_eq!(bernstein_roots([1.0, 0.0, -1.0]), [0.5]);
        assert!(bernstein_roots([1.0, 1.0, 1.0]).is_empty() && bernstein_roots([0.0, 0.0, 0.0]).is_empty());
        assert!(bernstein_roots([0.0, 0.5, 1.0]).is_empty(), "a root at the start is none between");
    }
}
