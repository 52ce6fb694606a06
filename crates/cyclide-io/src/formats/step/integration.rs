//! Which rational faces readers integrate well.
//!
//! OpenCASCADE's adaptive integration (`BRepGProp::SurfaceProperties` with an accuracy) divides a rational face in its
//! second parameter only: along the first one it always takes one Gauss-Legendre rule, of 7 nodes for degree 2 at the
//! accuracy 1e-11. The area element `|q1(t) q2(s)|/|D|⁴` (`docs/math/patches.md#speeds-and-moving-frame`) has poles
//! beside the face, the nearer the wider its arcs: for an arc of angle `a` whose ends weigh the same the rule converges
//! as `cot(a/8)` to the power -14 (the ellipse through the poles `±i cot(a/4)` about [-1, 1]). At 150 degrees with
//! uneven weights, 1e-4 of the area is lost, although the face is exact. Faces whose own area element the rule does not
//! integrate are halved.

use cyclide::CyclidePatch;

/// Nodes and weights of the 7-point rule on [-1, 1] (positive half, and the middle).
const RULE: [(f64, f64); 7] = [
    (-0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
    (-0.741_531_185_599_394_4, 0.279_705_391_489_276_67),
    (-0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (0.0, 0.417_959_183_673_469_4),
    (0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (0.741_531_185_599_394_4, 0.279_705_391_489_276_67),
    (0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
];
/// Part of a face's area by which readers may miss it: half of what they may miss of the whole.
const LARGEST_ERROR: f64 = 5e-9;

/// True if one 7-point rule along s integrates the area of the face.
pub(super) fn is_integrable(patch: &CyclidePatch) -> bool {
    error_along_s(patch) <= LARGEST_ERROR
}

/// The error of one 7-point rule along s, without regard to signs over t, as part of the area: against the rules on both
/// halves, which are better by orders of magnitude.
fn error_along_s(patch: &CyclidePatch) -> f64 {
    let weights = patch.real_weights();
    let largest = weights.iter().flatten().fold(0.0_f64, |m, w| m.max(w.abs()));
    let (q1, q2) = (patch.q1(), patch.q2());
    let (mut total, mut apart) = (0.0, 0.0);
    for (x, weight) in RULE {
        let t = 0.5 + 0.5 * x;
        let weights = weights.map(|row| quadratic(row, t) / largest);
        let element = |s: f64| (quadratic(q2, s) / quadratic(weights, s).powi(2)).abs();
        let on_halves = integral(&element, 0.0, 0.5) + integral(&element, 0.5, 1.0);
        let speed = weight * quadratic(q1, t).abs();
        total += speed * on_halves;
        apart += speed * (integral(&element, 0.0, 1.0) - on_halves).abs();
    }
    apart / total
}

fn integral(f: &impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let (m, h) = (0.5 * (a + b), 0.5 * (b - a));
    h * RULE.iter().map(|&(x, w)| w * f(m + h * x)).sum::<f64>()
}

/// Value of a quadratic from its Bernstein coefficients.
fn quadratic([a, b, c]: [f64; 3], x: f64) -> f64 {
    let y = 1.0 - x;
    y * (y * a + 2.0 * x * b) + x * x * c
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::{ParamSurface as _, Point3, Vec3};

    /// A patch of a ring about the third axis, turned by an angle along s.
    fn ring(angle: f64) -> CyclidePatch {
        let at = |r: f64, z: f64, u: f64| Point3::new(r * u.cos(), r * u.sin(), z);
        let corners = [at(3.0, 1.0, 0.0), at(3.0, 1.0, angle), at(2.0, 0.0, 0.0), at(2.0, 0.0, angle)];
        #[allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
        CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::new(-1.0, 0.0, 0.0)).unwrap()
    }

    #[test]
    fn the_error_is_that_of_seven_nodes_along_s() {
        // Of the patch's own area element, against cells of an eighth; both know the error to far below a hundredth.
        for angle in [1.5, 2.0, 2.6] {
            let patch = ring(angle);
            let along_t = |s: f64| integral(&|t| patch.jet(s, t).area_element(), 0.0, 1.0);
            let area: f64 = (0..8).map(|k| integral(&along_t, f64::from(k) / 8.0, f64::from(k + 1) / 8.0)).sum();
            let expected = (integral(&along_t, 0.0, 1.0) / area - 1.0).abs();
            let error = error_along_s(&patch);
            assert!((error / expected - 1.0).abs() < 0.01, "{angle}: {error:e}, not {expected:e}");
        }
    }

    #[test]
    fn wide_faces_are_not_integrable() {
        assert!(is_integrable(&ring(1.8)));
        assert!(!is_integrable(&ring(2.6)));
    }
}
