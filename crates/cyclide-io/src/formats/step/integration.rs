//! Which rational faces readers integrate well.
//!
//! OpenCASCADE's adaptive integration (`BRepGProp::SurfaceProperties` with an accuracy) divides a rational face in its
//! second parameter only: along the first one it always takes one Gauss-Legendre rule, of 7 nodes for degree 2 at the
//! accuracy 1e-11. The area element `|q1(t) q2(s)|/|D|⁴` (`docs/math/patches.md#speeds-and-moving-frame`) has poles
//! beside the face, the nearer the wider its arcs: for an arc of angle `a` whose ends weigh the same the rule converges
//! as `cot(a/8)` to the power -14 (the ellipse through the poles `±i cot(a/4)` about [-1, 1]). At 150 degrees with
//! uneven weights, 1e-4 of the area is lost, although the face is exact. Faces whose own area element the rule does not
//! integrate are halved. For rational faces of a higher degree the rule has more nodes, and nothing is known of the poles:
//! their area elements are integrated as they are.

use cyclide::{surface::CyclidePatch, topology::FaceSurface};
use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::rc::Rc;

/// Nodes that readers take for the larger degree and one; rounded up, 7 for degree 2.
const NODES_PER_ORDER: f64 = 2.25;
/// Lines along s that are looked at.
const LINES: usize = 5;
/// Part of a face's area by which readers may miss it: half of what they may miss of the whole.
const LARGEST_ERROR: f64 = 5e-9;
/// The same of rational faces, which in a reader's eyes are better whole than exact to the ninth digit.
const LARGEST_RATIONAL_ERROR: f64 = 1e-7;

/// Which surfaces the one rule of readers along s integrates, with the rules for the degrees met so far.
#[derive(Default)]
pub(super) struct Integration {
    rules: RefCell<HashMap<usize, Rc<GaussRule>>>,
}

impl Integration {
    /// True if the rule integrates the area of the face.
    pub(super) fn is_good(&self, surface: &FaceSurface) -> bool {
        let lines = self.rule(LINES);
        match surface {
            FaceSurface::Cyclide(patch) => patch_error_along_s(patch, &self.rule(nodes(2)), &lines) <= LARGEST_ERROR,
            FaceSurface::Rational(surface) => {
                let rule = self.rule(nodes(surface.degrees().into_iter().fold(0, usize::max)));
                let element = |s: f64, t: f64| surface.jet(s, t).area_element();
                error_along_s(element, &rule, &lines) <= LARGEST_RATIONAL_ERROR
            }
        }
    }

    fn rule(&self, nodes: usize) -> Rc<GaussRule> {
        self.rules.borrow_mut().entry(nodes).or_insert_with(|| Rc::new(GaussRule::new(nodes))).clone()
    }
}

/// Nodes of the rule of readers.
fn nodes(degree: usize) -> usize {
    (NODES_PER_ORDER * (degree + 1) as f64).ceil() as usize
}

/// The error of one rule along s, without regard to signs over t, as part of the area: against the rules on both halves, which
/// are better by orders of magnitude.
fn error_along_s(element: impl Fn(f64, f64) -> f64, rule: &GaussRule, lines: &GaussRule) -> f64 {
    let (mut total, mut apart) = (0.0, 0.0);
    for &(x, weight) in &lines.0 {
        let t = 0.5 + 0.5 * x;
        let on_halves = rule.integral(|s| element(s, t), 0.0, 0.5) + rule.integral(|s| element(s, t), 0.5, 1.0);
        total += weight * on_halves;
        apart += weight * (rule.integral(|s| element(s, t), 0.0, 1.0) - on_halves).abs();
    }
    apart / total
}

/// The same of a patch, whose area element is in closed form.
fn patch_error_along_s(patch: &CyclidePatch, rule: &GaussRule, lines: &GaussRule) -> f64 {
    let weights = patch.real_weights();
    let largest = weights.iter().flatten().fold(0.0_f64, |m, w| m.max(w.abs()));
    let (q1, q2) = (patch.q1(), patch.q2());
    let element = |s: f64, t: f64| {
        let weights = weights.map(|row| quadratic(row, t) / largest);
        (quadratic(q1, t) * quadratic(q2, s) / quadratic(weights, s).powi(2)).abs()
    };
    error_along_s(element, rule, lines)
}

/// The rule of Gauss and Legendre: nodes on [-1, 1] with their weights.
struct GaussRule(Vec<(f64, f64)>);

impl GaussRule {
    /// With so many nodes: the zeros of the Legendre polynomial by Newton's method, from their asymptotic places.
    fn new(nodes: usize) -> Self {
        let n = nodes as f64;
        let node = |k: usize| {
            let mut x = (PI * (k as f64 + 0.75) / (n + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..NEWTON_STEPS {
                let (mut before, mut value) = (1.0, x);
                for j in 1..nodes {
                    let j = j as f64;
                    (before, value) = (value, ((2.0 * j + 1.0) * x * value - j * before) / (j + 1.0));
                }
                slope = n * (before - x * value) / (1.0 - x * x);
                x -= value / slope;
            }
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        };
        Self((0..nodes).map(node).collect())
    }

    fn integral(&self, f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
        let (m, h) = (0.5 * (a + b), 0.5 * (b - a));
        h * self.0.iter().map(|&(x, w)| w * f(m + h * x)).sum::<f64>()
    }
}

/// Steps from an asymptotic place to a zero: the error, 1e-2 of the distance of two, is squared by each.
const NEWTON_STEPS: usize = 6;

/// Value of a quadratic from its Bernstein coefficients.
fn quadratic([a, b, c]: [f64; 3], x: f64) -> f64 {
    let y = 1.0 - x;
    y * (y * a + 2.0 * x * b) + x * x * c
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::{Point3, Vec3, surface::ParamSurface as _};

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
        let seven = GaussRule::new(7);
        for angle in [1.5, 2.0, 2.6] {
            let patch = ring(angle);
            let along_t = |s: f64| seven.integral(|t| patch.jet(s, t).area_element(), 0.0, 1.0);
            let area: f64 = (0..8).map(|k| seven.integral(along_t, f64::from(k) / 8.0, f64::from(k + 1) / 8.0)).sum();
            let expected = (seven.integral(along_t, 0.0, 1.0) / area - 1.0).abs();
            let rational = patch.to_rational();
            let of_rational = error_along_s(|s, t| rational.jet(s, t).area_element(), &seven, &seven);
            for error in [patch_error_along_s(&patch, &seven, &seven), of_rational] {
                assert!((error / expected - 1.0).abs() < 0.01, "{angle}: {error:e}, not {expected:e}");
            }
        }
    }

    #[test]
    fn wide_faces_are_not_integrable() {
        let integration = Integration::default();
        for (angle, good) in [(1.8, true), (2.6, false)] {
            let patch = ring(angle);
            assert_eq!(integration.is_good(&patch.to_rational().into()), good);
            assert_eq!(integration.is_good(&patch.into()), good);
        }
    }

    #[test]
    fn rules_are_exact_to_twice_their_nodes() {
        for nodes in [7_usize, 9, 12, 21, 64] {
            let rule = GaussRule::new(nodes);
            let power = 2 * nodes as i32 - 2;
            let integral = rule.integral(|x| x.powi(power), -1.0, 1.0);
            assert!((integral * f64::from(power + 1) / 2.0 - 1.0).abs() < 1e-12, "{nodes}: {integral:e}");
        }
    }
}
