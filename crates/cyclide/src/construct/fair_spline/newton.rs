//! Newton's method on the equations of a fair spline (`docs/math/fair-splines.md#newtons-method`): tangents with which
//! the curvature vectors agree at every node.
//!
//! The unknowns are small turns of the tangents; the matrix is that of the second derivatives of the energy, but a root
//! is sought and not a minimum: in space the right curve is often a saddle. Where a step fails, a damped one is tried,
//! `y = -(H² + mu)⁻¹ H g`, which is the real part of `-(H + i sqrt(mu))⁻¹ g` and so a system of the same shape.

use super::scalar::{Complex, Scalar};
use super::tridiagonal::{Block, Elimination, Tridiagonal};

/// Residuals up to this are a solution.
const CONVERGED: f64 = 1e-11;
/// A solution is improved down to this, or until a step gains less than the next factor.
const POLISHED: f64 = 1e-15;
const POLISHING_GAIN: f64 = 0.3;
/// No tangent turns by more in one step, radians.
const LARGEST_TURN: f64 = 0.7;
/// A step must make the sum of the squares fall by this part of its length.
const DECREASE: f64 = 1e-3;
/// A failing Newton step is tried this often at a third of the length before.
const SHORTER_STEPS: usize = 4;
/// First and last damping.
const DAMPING: [f64; 2] = [1e-4, 1e9];

/// What a segment adds to the equations of its two nodes.
pub(super) struct SegmentTerms<const R: usize> {
    pub(super) gradient: [[f64; R]; 2],
    pub(super) diagonal: [Block<f64, R>; 2],
    pub(super) coupling: Block<f64, R>,
}

/// The chords of a run, in a plane or in space, with `R` unknowns per node.
pub(super) trait Geometry<const R: usize> {
    /// A unit tangent, with what belongs to it.
    type Node: Copy;
    /// Lengths of the chords, relative to the longest.
    fn lengths(&self) -> &[f64];
    /// The direction of a chord.
    fn chord(&self, i: usize) -> Self::Node;
    /// Tangent of the circle through the ends of two chords that meet (`docs/math/circle-blends.md#node-tangent`).
    fn between(&self, before: usize, after: usize) -> Self::Node;
    /// The tangent at the other end of the arc over a chord.
    fn mirrored(&self, i: usize, t: &Self::Node) -> Self::Node;
    /// The direction halfway from a tangent to the chord; the chord where they are opposite.
    fn toward_chord(&self, i: usize, t: &Self::Node) -> Self::Node;
    /// Cosine of the angle between a chord and a tangent.
    fn cosine(&self, i: usize, t: &Self::Node) -> f64;
    /// Angle between the two arcs of a segment, the short way.
    fn blend_angle(&self, i: usize, from: &Self::Node, to: &Self::Node) -> f64;
    /// The terms of a segment between two nodes.
    fn segment(&self, i: usize, from: &Self::Node, to: &Self::Node, blend: f64) -> SegmentTerms<R>;
    /// Gradient and diagonal of an end segment that is the arc with this tangent at its inner node.
    fn arc_segment(&self, i: usize, t: &Self::Node) -> ([f64; R], f64);
    /// A tangent turned by a step.
    fn turned(&self, t: &Self::Node, step: [f64; R]) -> Self::Node;
}

/// What happens at an end of an open run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum RunEnd<D> {
    /// The end segment is an arc: the tangent follows from its other end.
    Arc,
    /// The curvature vanishes.
    Free,
    /// The tangent is given.
    Clamped(D),
}

/// How far the search goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Search {
    /// Most steps.
    pub(super) steps: usize,
    /// Damped steps where Newton's fail.
    pub(super) damped: bool,
}

/// Size of the residuals.
#[derive(Debug, Clone, Copy)]
struct Residual {
    largest: f64,
    sum: f64,
}

/// The equations of one run: `n` nodes, closed or between two ends.
pub(super) struct Equations<'a, G: Geometry<R>, const R: usize> {
    pub(super) geometry: &'a G,
    pub(super) closed: bool,
    pub(super) ends: [RunEnd<G::Node>; 2],
}

/// The linear system at the present tangents, and room for its solution.
struct Workspace<const R: usize> {
    system: Tridiagonal<f64, R>,
    gradient: Vec<[f64; R]>,
    elimination: Elimination<f64, R>,
}

impl<G: Geometry<R>, const R: usize> Equations<'_, G, R> {
    fn node_count(&self) -> usize {
        self.geometry.lengths().len() + usize::from(!self.closed)
    }

    /// Three-point tangents at inner nodes, with the ends that belong to them
    /// (`docs/math/fair-splines.md#newtons-method`).
    pub(super) fn start(&self) -> Vec<G::Node> {
        let (n, m) = (self.node_count(), self.geometry.lengths().len());
        let mut nodes = Vec::with_capacity(n);
        for i in 0..n {
            nodes.push(match (self.closed, i) {
                (true, 0) => self.geometry.between(m - 1, 0),
                (false, 0) => self.geometry.chord(0),
                (false, _) if i == n - 1 => self.geometry.chord(m - 1),
                _ => self.geometry.between(i - 1, i),
            });
        }
        if !self.closed && n > 2 {
            // Free ends: halfway between the arc and the chord, exact for small angles.
            nodes[0] = self.geometry.toward_chord(0, &self.geometry.mirrored(0, &nodes[1]));
            nodes[n - 1] = self.geometry.toward_chord(m - 1, &self.geometry.mirrored(m - 1, &nodes[n - 2]));
        }
        self.set_ends(&mut nodes);
        nodes
    }

    /// Gives the ends their given tangents, or those that follow from the other end of their arc.
    pub(super) fn set_ends(&self, nodes: &mut [G::Node]) {
        if self.closed {
            return;
        }
        let (n, m) = (self.node_count(), self.geometry.lengths().len());
        for (end, at) in [(self.ends[0], 0), (self.ends[1], n - 1)] {
            if let RunEnd::Clamped(t) = end {
                nodes[at] = t;
            }
        }
        for (end, at, inner, chord) in [(self.ends[0], 0, 1, 0), (self.ends[1], n - 1, n - 2, m - 1)] {
            if matches!(end, RunEnd::Arc) {
                nodes[at] = self.geometry.mirrored(chord, &nodes[inner]);
            }
        }
    }

    /// Moves the tangents to a solution; false if none was found, and then they are where the search ended.
    pub(super) fn solve(&self, nodes: &mut Vec<G::Node>, blends: &[f64], search: Search) -> bool {
        let n = self.node_count();
        let mut work = Workspace {
            system: Tridiagonal::new(n, self.closed),
            gradient: vec![[0.0; R]; n],
            elimination: Elimination::new(n, self.closed),
        };
        let mut trial = nodes.clone();
        let mut now = self.assemble(nodes, blends, &mut work);
        for _ in 0..search.steps {
            if !now.sum.is_finite() || now.largest <= POLISHED {
                break;
            }
            let solved = now.largest <= CONVERGED;
            let tries = if solved { 0 } else { SHORTER_STEPS };
            let mut next = self.newton_step(nodes, &mut trial, blends, &mut work, now, tries);
            if next.is_none() && !solved && search.damped {
                next = self.damped_step(nodes, &mut trial, blends, &mut work, now);
            }
            let Some(next) = next else { break };
            std::mem::swap(nodes, &mut trial);
            let gain = next.largest / now.largest;
            now = next;
            if solved && gain > POLISHING_GAIN {
                break;
            }
        }
        self.set_ends(nodes);
        now.sum.is_finite() && now.largest <= CONVERGED
    }

    /// The equations and their matrix at the given tangents. A node whose tangent is no unknown gets the equation
    /// `y = 0`.
    fn assemble(&self, nodes: &[G::Node], blends: &[f64], work: &mut Workspace<R>) -> Residual {
        let (n, lengths) = (self.node_count(), self.geometry.lengths());
        let (diagonal, gradient) = (&mut work.system.diagonal, &mut work.gradient);
        diagonal.fill([[0.0; R]; R]);
        gradient.fill([0.0; R]);
        let arcs = if self.closed { [false; 2] } else { self.ends.map(|e| matches!(e, RunEnd::Arc)) };
        for i in 0..lengths.len() {
            let j = if i + 1 == n { 0 } else { i + 1 };
            if (arcs[0] && i == 0) || (arcs[1] && i + 1 == lengths.len()) {
                let inner = if arcs[0] && i == 0 { j } else { i };
                let (g, h) = self.geometry.arc_segment(i, &nodes[inner]);
                add(&mut gradient[inner], &g);
                for (r, row) in diagonal[inner].iter_mut().enumerate() {
                    row[r] += h;
                }
                work.system.coupling[i] = [[0.0; R]; R];
                continue;
            }
            let terms = self.geometry.segment(i, &nodes[i], &nodes[j], blends[i]);
            add(&mut gradient[i], &terms.gradient[0]);
            add(&mut gradient[j], &terms.gradient[1]);
            add_block(&mut diagonal[i], &terms.diagonal[0]);
            add_block(&mut diagonal[j], &terms.diagonal[1]);
            work.system.coupling[i] = terms.coupling;
        }
        if !self.closed {
            for (end, at, coupling) in [(&self.ends[0], 0, 0), (&self.ends[1], n - 1, n - 2)] {
                if !matches!(end, RunEnd::Free) {
                    diagonal[at] = identity();
                    gradient[at] = [0.0; R];
                    work.system.coupling[coupling] = [[0.0; R]; R];
                }
            }
        }
        self.residual(gradient)
    }

    /// Residuals relative to `1/d_before + 1/d_after`.
    fn residual(&self, gradient: &[[f64; R]]) -> Residual {
        let mut residual = Residual { largest: 0.0, sum: 0.0 };
        for (i, g) in gradient.iter().enumerate() {
            let square = g.iter().map(|x| x * x).sum::<f64>() / self.scale(i).powi(2);
            // A NaN stays in the sum.
            residual.sum += square;
            residual.largest = residual.largest.max(square);
        }
        residual.largest = residual.largest.sqrt();
        residual
    }

    fn scale(&self, node: usize) -> f64 {
        let (n, lengths) = (self.node_count(), self.geometry.lengths());
        if self.closed {
            let before = if node == 0 { n - 1 } else { node - 1 };
            1.0 / lengths[before] + 1.0 / lengths[node]
        } else if node == 0 {
            1.0 / lengths[0]
        } else if node == n - 1 {
            1.0 / lengths[n - 2]
        } else {
            1.0 / lengths[node - 1] + 1.0 / lengths[node]
        }
    }

    /// A Newton step into `trial`, shortened up to `shorter` times until the residuals fall.
    fn newton_step(
        &self,
        nodes: &[G::Node],
        trial: &mut [G::Node],
        blends: &[f64],
        work: &mut Workspace<R>,
        now: Residual,
        shorter: usize,
    ) -> Option<Residual> {
        work.elimination.solution.copy_from_slice(&work.gradient);
        work.elimination.solve(&work.system);
        let mut factor = step_factor(&work.elimination.solution)?;
        for _ in 0..=shorter {
            for ((new, old), y) in trial.iter_mut().zip(nodes).zip(&work.elimination.solution) {
                *new = self.geometry.turned(old, y.map(|y| -factor * y));
            }
            let next = self.assemble(trial, blends, work);
            if next.sum < now.sum * (1.0 - DECREASE * factor) {
                return Some(next);
            }
            factor /= 3.0;
        }
        None
    }

    /// A damped step into `trial`, with the least damping of its row that makes the residuals fall.
    fn damped_step(
        &self,
        nodes: &[G::Node],
        trial: &mut [G::Node],
        blends: &[f64],
        work: &mut Workspace<R>,
        now: Residual,
    ) -> Option<Residual> {
        let n = self.node_count();
        let mut system: Tridiagonal<Complex, R> = Tridiagonal::new(n, self.closed);
        let mut elimination: Elimination<Complex, R> = Elimination::new(n, self.closed);
        let [mut damping, last] = DAMPING;
        while damping <= last {
            // The trial before has left its own equations.
            self.assemble(nodes, blends, work);
            for i in 0..n {
                let scale = [self.scale(i), self.scale(if i + 1 == n { 0 } else { i + 1 })];
                let across = (scale[0] * scale[1]).sqrt();
                for r in 0..R {
                    for s in 0..R {
                        let shift = if r == s { damping.sqrt() } else { 0.0 };
                        let re = work.system.diagonal[i][r][s] / scale[0];
                        system.diagonal[i][r][s] = Complex { re, im: shift };
                        system.coupling[i][r][s] = Complex::real(work.system.coupling[i][r][s] / across);
                    }
                }
                elimination.solution[i] = work.gradient[i].map(|g| Complex::real(g / scale[0].sqrt()));
            }
            elimination.solve(&system);
            for (i, y) in work.elimination.solution.iter_mut().enumerate() {
                *y = elimination.solution[i].map(|y| y.real_part() / self.scale(i).sqrt());
            }
            if let Some(factor) = step_factor(&work.elimination.solution) {
                for ((new, old), y) in trial.iter_mut().zip(nodes).zip(&work.elimination.solution) {
                    *new = self.geometry.turned(old, y.map(|y| -factor * y));
                }
                let next = self.assemble(trial, blends, work);
                if next.sum < now.sum {
                    return Some(next);
                }
            }
            damping *= 10.0;
        }
        None
    }
}

/// The factor that keeps the largest turn of a step within its bound; `None` if the step is not finite.
fn step_factor<const R: usize>(step: &[[f64; R]]) -> Option<f64> {
    let mut sum = 0.0;
    let mut largest: f64 = 0.0;
    for y in step {
        let square: f64 = y.iter().map(|y| y * y).sum();
        sum += square;
        largest = largest.max(square);
    }
    sum.is_finite().then(|| (LARGEST_TURN / largest.sqrt()).min(1.0))
}

fn identity<const R: usize>() -> Block<f64, R> {
    std::array::from_fn(|r| std::array::from_fn(|s| if r == s { 1.0 } else { 0.0 }))
}

fn add<const R: usize>(sum: &mut [f64; R], term: &[f64; R]) {
    for (s, t) in sum.iter_mut().zip(term) {
        *s += t;
    }
}

fn add_block<const R: usize>(sum: &mut Block<f64, R>, term: &Block<f64, R>) {
    for (s, t) in sum.iter_mut().zip(term) {
        add(s, t);
    }
}
