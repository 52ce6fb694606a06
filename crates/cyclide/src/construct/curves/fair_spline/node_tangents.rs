//! Tangents of a fair spline with all blends 1 through nodes that move: for constructions that solve it again and again.

use super::newton::Search;
use super::options::FairEnd;
use super::run::Run;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Chord;

/// When a solution is refused.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TangentLimits {
    /// Most Newton steps.
    pub(crate) steps: usize,
    /// Smallest cosine between a chord and the tangents at its ends.
    pub(crate) least_cosine: f64,
}

/// The unit tangents at the nodes of the fair spline with `e = 1` and arc ends
/// (`docs/math/fair-splines.md#newtons-method`), by Newton steps from given tangents or from those of the circles
/// through neighbors; one unknown per node if the nodes lie in a plane, two in space. `None` if there are too few
/// nodes, neighbors coincide, the steps do not converge or an angle is out of bounds: there is no fallback.
pub(crate) fn fair_tangents(
    nodes: &[Point3],
    closed: bool,
    warm: Option<&[Vec3]>,
    limits: TangentLimits,
) -> Option<Vec<Vec3>> {
    let n = nodes.len();
    if n < 2 || (closed && n < 3) {
        return None;
    }
    let chord = |i: usize| Chord::new(nodes[i], nodes[if i + 1 == n { 0 } else { i + 1 }]);
    let chords: Vec<Chord> = (0..n - usize::from(!closed)).map(chord).collect();
    if !chords.iter().all(|c| c.length > 0.0 && c.length.is_finite()) {
        return None;
    }
    if n == 2 {
        return Some(vec![chords[0].unit; 2]);
    }
    let run = Run::new(nodes, &chords, closed, [FairEnd::Arc; 2]);
    let search = Search { steps: limits.steps, damped: false };
    let warm = warm.filter(|warm| warm.len() == n);
    let tangents = run.solve(&vec![1.0; chords.len()], warm, search)?;
    (tangents.least_cosine >= limits.least_cosine).then_some(tangents.units)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::construct::FairSplineOptions;
    use crate::curve::CircleSpline;

    const LIMITS: TangentLimits = TangentLimits { steps: 12, least_cosine: -0.8 };

    fn wave(n: usize, height: f64) -> Vec<Point3> {
        let at = |i: usize| {
            let s = 0.3 * i as f64;
            Point3::new(s, s.sin(), height * (0.7 * s).cos())
        };
        (0..n).map(at).collect()
    }

    #[test]
    fn they_are_those_of_the_spline_in_the_plane_and_in_space() {
        for height in [0.0, 0.5] {
            let nodes = wave(30, height);
            let options =
                FairSplineOptions { ends: [FairEnd::Arc; 2], straight_runs: false, ..FairSplineOptions::default() };
            let spline = CircleSpline::fair(&nodes, &options).unwrap();
            let tangents = fair_tangents(&nodes, false, None, LIMITS).unwrap();
            for (segment, t) in spline.segments().iter().zip(&tangents) {
                // Rounding of tangents over chords of 0.4.
                assert!((segment.start_tangent() - *t).length() < 1e-14);
            }
        }
    }

    #[test]
    fn a_start_near_by_needs_few_steps_and_leads_to_the_same() {
        for height in [0.0, 0.5] {
            let nodes = wave(30, height);
            let cold = fair_tangents(&nodes, false, None, LIMITS).unwrap();
            let moved: Vec<Point3> = nodes.iter().map(|p| *p + Vec3::new(0.0, 1e-3 * p.x.cos(), 0.0)).collect();
            let few = TangentLimits { steps: 3, ..LIMITS };
            let warm = fair_tangents(&moved, false, Some(&cold), few).unwrap();
            let fresh = fair_tangents(&moved, false, None, LIMITS).unwrap();
            assert!(warm.iter().zip(&fresh).all(|(a, b)| (*a - *b).length() < 1e-12));
        }
    }

    #[test]
    fn what_has_no_tame_solution_is_refused() {
        let zigzag: Vec<Point3> = (0..12).map(|i| Point3::new(0.1 * f64::from(i), f64::from(i % 2), 0.0)).collect();
        assert!(fair_tangents(&zigzag, false, None, LIMITS).is_none());
        let back = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
        assert!(fair_tangents(&back, false, None, LIMITS).is_none());
        assert!(fair_tangents(&back[..2], true, None, LIMITS).is_none());
        assert!(fair_tangents(&[back[0]; 3], false, None, LIMITS).is_none());
    }
}
