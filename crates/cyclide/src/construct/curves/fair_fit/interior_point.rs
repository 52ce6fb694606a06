//! One step of a fair fit: the smoothest displacement with all data in the tube
//! (`docs/math/fair-fits.md#interior-point`).
//!
//! ```text
//! min  y'Qy/2 + q'y + rho sum xi_i     subject to  f_i = (|r_i|² + along_i - 1)/2 <= xi_i,  xi_i >= 0
//! ```
//! by a primal-dual interior point method with slacks `s_i = xi_i - f_i`, duals `lam_i` in `(0, rho)` and
//! `t_i = rho - lam_i`. Elastic: always solvable, and `xi` shows which data stay outside. Each Newton step costs one
//! banded Cholesky factorization. (The reduced system is derived in `docs/math/fair-fits.md#interior-point`; predictor
//! and corrector are Mehrotra's.)

use super::bordered_band::BorderedBand;
use super::feet::Foot;
use super::linear_model::{DistanceRow, LinearModel, by_segment};

/// Complementarity at which the step is good enough, all data together.
const GAP: f64 = 1e-4;
/// Largest `|f + s - xi|` then.
const INFEASIBILITY: f64 = 1e-7;
/// Newton steps at most.
const MAX_STEPS: usize = 40;
/// Part of the way to the boundary that a step may go.
const TO_BOUNDARY: f64 = 0.99;

/// A convex quadratic objective `y'Qy/2 + q'y`.
pub(super) struct Quadratic<const N: usize> {
    pub matrix: BorderedBand<N>,
    pub linear: Vec<f64>,
}

/// The state of one datum.
#[derive(Debug, Clone, Copy, Default)]
struct Dual {
    xi: f64,
    slack: f64,
    lam: f64,
    f: f64,
    /// Reciprocals: divisions are what these loops would spend their time on.
    inverse: Inverses,
    /// What the current step adds.
    d_xi: f64,
    d_slack: f64,
    d_lam: f64,
    /// What `s lam` and `xi t` are sent to, with the corrections of second order.
    push: [f64; 2],
}

#[derive(Debug, Clone, Copy, Default)]
struct Inverses {
    xi: f64,
    slack: f64,
    lam: f64,
    t: f64,
    /// `a = s/lam + xi/t`.
    a: f64,
}

/// Displacements that solve a step.
pub(super) struct Solved {
    pub y: Vec<f64>,
    /// Sum of the violations that remain.
    pub violation: f64,
}

impl<const R: usize, const N: usize> LinearModel<R, N> {
    /// The squares of the variation over `scale`, plus `centre` times the mean square of the distances
    /// (`docs/math/fair-fits.md#center`) at all `feet`; rows and columns of fixed nodes are those of the identity.
    pub fn objective(&self, scale: f64, centre: f64, feet: &[Foot]) -> Quadratic<N> {
        let size = self.unknowns();
        let mut matrix = BorderedBand::zero(size, self.closed);
        let mut linear = vec![0.0; size];
        for (j, row) in self.variation.iter().enumerate() {
            let Some(row) = row else { continue };
            let mut local = Local::<N>::zero();
            for (c, rest) in row.columns.iter().zip(row.at_rest) {
                local.add(c, 2.0 / scale, 2.0 / scale * rest);
            }
            local.scatter(&self.unknowns_of(j), R, &mut matrix, &mut linear);
        }
        if centre > 0.0 {
            let weight = 2.0 * centre / feet.len() as f64;
            let (first, datum) = by_segment(feet, self.variation.len());
            for j in 0..self.variation.len() {
                let mut local = Local::<N>::zero();
                for i in &datum[first[j]..first[j + 1]] {
                    let row = self.distance_row(&feet[*i]);
                    for (c, rest) in row.columns.iter().zip(row.at_rest) {
                        local.add(c, weight, -weight * rest);
                    }
                }
                local.scatter(&self.unknowns_of(j), R, &mut matrix, &mut linear);
            }
        }
        // A node without data that no third derivative holds, and the columns of fixed nodes, would leave 0 on the
        // diagonal.
        let largest = (0..size).map(|i| *matrix.entry(i, i)).fold(1.0, f64::max);
        for i in 0..size {
            *matrix.entry(i, i) += 1e-13 * largest;
        }
        Quadratic { matrix, linear }
    }

    /// Solves the step with violations at the price `rho` each; `None` if rounding has made the system indefinite.
    pub fn solve(&self, objective: &Quadratic<N>, rho: f64) -> Option<Solved> {
        let mut state = InteriorPoint::new(self, objective, rho);
        let mut steps = 0;
        while steps < MAX_STEPS && !state.converged() {
            state.step()?;
            steps += 1;
        }
        let violation = state.duals.iter().map(|d| d.f.max(0.0)).sum();
        Some(Solved { y: state.y, violation })
    }
}

/// The sums of one segment: a symmetric matrix over its columns (lower triangle) and a right side.
struct Local<const N: usize> {
    matrix: [[f64; N]; N],
    side: [f64; N],
}

impl<const N: usize> Local<N> {
    fn zero() -> Self {
        Self { matrix: [[0.0; N]; N], side: [0.0; N] }
    }

    /// Adds `weight c c^T` and `side c`.
    fn add(&mut self, c: &[f64; N], weight: f64, side: f64) {
        for (a, row) in self.matrix.iter_mut().enumerate() {
            let w = weight * c[a];
            for (sum, x) in row.iter_mut().zip(&c[..=a]) {
                *sum += w * x;
            }
            self.side[a] += side * c[a];
        }
    }

    fn scatter(&self, first: &[Option<usize>; 4], r: usize, matrix: &mut BorderedBand<N>, side: &mut [f64]) {
        for a in 0..N {
            let Some(i) = first[a / r].map(|k| k + a % r) else { continue };
            side[i] += self.side[a];
            for b in 0..=a {
                let Some(j) = first[b / r].map(|k| k + b % r) else { continue };
                *matrix.entry(i, j) += self.matrix[a][b];
            }
        }
    }
}

struct InteriorPoint<'a, const R: usize, const N: usize> {
    model: &'a LinearModel<R, N>,
    objective: &'a Quadratic<N>,
    rho: f64,
    y: Vec<f64>,
    duals: Vec<Dual>,
    residuals: Vec<[f64; R]>,
    matrix: BorderedBand<N>,
    base: Vec<f64>,
    dy: Vec<f64>,
}

impl<'a, const R: usize, const N: usize> InteriorPoint<'a, R, N> {
    fn new(model: &'a LinearModel<R, N>, objective: &'a Quadratic<N>, rho: f64) -> Self {
        let size = model.unknowns();
        let duals = model.rows.iter().map(|row| {
            let f = distance(&row.at_rest, row.along);
            let xi = f.max(0.0) + 0.05;
            let slack = (xi - f).max(0.05);
            Dual { xi, slack, lam: (0.1 / slack).min(0.5 * rho), f, ..Dual::default() }
        });
        Self {
            duals: duals.collect(),
            residuals: model.rows.iter().map(|row| row.at_rest).collect(),
            y: vec![0.0; size],
            matrix: objective.matrix.clone(),
            base: vec![0.0; size],
            dy: vec![0.0; size],
            model,
            objective,
            rho,
        }
    }

    fn gap(&self) -> f64 {
        self.duals.iter().map(|d| d.slack * d.lam + d.xi * (self.rho - d.lam)).sum()
    }

    fn converged(&self) -> bool {
        self.gap() < GAP && self.duals.iter().all(|d| (d.f + d.slack - d.xi).abs() < INFEASIBILITY)
    }

    /// One predictor-corrector step; `None` if the matrix is not positive definite.
    fn step(&mut self) -> Option<()> {
        let before = self.gap() / (2 * self.duals.len()) as f64;
        for d in &mut self.duals {
            d.invert(self.rho);
        }
        self.assemble();
        if !self.matrix.factor() {
            return None;
        }
        for d in &mut self.duals {
            d.push = [0.0; 2];
        }
        self.direction();
        let [primal, dual] = self.longest_steps(1.0);
        let rho = self.rho;
        let after: f64 = self
            .duals
            .iter()
            .map(|d| {
                let (lam, xi) = (d.lam + dual * d.d_lam, d.xi + primal * d.d_xi);
                (d.slack + primal * d.d_slack) * lam + xi * (rho - lam)
            })
            .sum::<f64>()
            / (2 * self.duals.len()) as f64;
        let mu = before * (after / before).powi(3);
        for d in &mut self.duals {
            d.push = [mu - d.d_slack * d.d_lam, mu + d.d_xi * d.d_lam];
        }
        self.direction();
        let [primal, dual] = self.longest_steps(TO_BOUNDARY);
        for (y, d) in self.y.iter_mut().zip(&self.dy) {
            *y += primal * d;
        }
        for d in &mut self.duals {
            d.xi += primal * d.d_xi;
            d.slack += primal * d.d_slack;
            d.lam += dual * d.d_lam;
        }
        self.measure();
        Some(())
    }

    /// Distances at the present displacements.
    fn measure(&mut self) {
        for j in 0..self.model.first.len() - 1 {
            let y = self.local(j, &self.y);
            for i in self.model.first[j]..self.model.first[j + 1] {
                let row = &self.model.rows[i];
                let r = std::array::from_fn(|a| row.at_rest[a] - dot(&row.columns[a], &y));
                self.residuals[i] = r;
                self.duals[i].f = distance(&r, row.along);
            }
        }
    }

    /// The values of a vector over the columns of a segment.
    fn local(&self, segment: usize, x: &[f64]) -> [f64; N] {
        let first = self.model.unknowns_of(segment);
        std::array::from_fn(|c| first[c / R].map_or(0.0, |k| x[k + c % R]))
    }

    /// The matrix of the Newton system, and the part of its right side that stays.
    fn assemble(&mut self) {
        self.matrix.copy_from(&self.objective.matrix);
        self.base.copy_from_slice(&self.objective.linear);
        self.objective.matrix.multiply_add(&self.y, &mut self.base);
        for j in 0..self.model.first.len() - 1 {
            let mut local = Local::<N>::zero();
            for i in self.model.first[j]..self.model.first[j + 1] {
                let (row, r, d) = (&self.model.rows[i], &self.residuals[i], &self.duals[i]);
                if R == 1 {
                    local.add(&row.columns[0], d.lam + r[0] * r[0] * d.inverse.a, -d.lam * r[0]);
                } else {
                    for (c, r) in row.columns.iter().zip(r) {
                        local.add(c, d.lam, -d.lam * r);
                    }
                    local.add(&gradient(row, r), d.inverse.a, 0.0);
                }
            }
            local.scatter(&self.model.unknowns_of(j), R, &mut self.matrix, &mut self.base);
        }
    }

    /// Newton's direction for the present `push`.
    fn direction(&mut self) {
        for (d, b) in self.dy.iter_mut().zip(&self.base) {
            *d = -b;
        }
        for j in 0..self.model.first.len() - 1 {
            let mut side = [0.0; N];
            for i in self.model.first[j]..self.model.first[j + 1] {
                let (row, r, d) = (&self.model.rows[i], &self.residuals[i], &self.duals[i]);
                let push = (d.f + d.push[0] * d.inverse.lam - d.push[1] * d.inverse.t) * d.inverse.a;
                for (c, r) in row.columns.iter().zip(r) {
                    for k in 0..N {
                        side[k] += push * r * c[k];
                    }
                }
            }
            let first = self.model.unknowns_of(j);
            for c in 0..N {
                if let Some(k) = first[c / R] {
                    self.dy[k + c % R] += side[c];
                }
            }
        }
        self.matrix.solve(&mut self.dy);
        for j in 0..self.model.first.len() - 1 {
            let dy = self.local(j, &self.dy);
            for i in self.model.first[j]..self.model.first[j + 1] {
                let (row, r) = (&self.model.rows[i], &self.residuals[i]);
                let moved: f64 = (0..R).map(|a| -r[a] * dot(&row.columns[a], &dy)).sum();
                self.duals[i].head_for(moved);
            }
        }
    }

    /// The longest primal and dual step, times `part` and at most 1.
    fn longest_steps(&self, part: f64) -> [f64; 2] {
        let (mut primal, mut dual) = (0.0_f64, 0.0_f64);
        for d in &self.duals {
            primal = primal.max(-d.d_xi * d.inverse.xi).max(-d.d_slack * d.inverse.slack);
            dual = dual.max(-d.d_lam * d.inverse.lam).max(d.d_lam * d.inverse.t);
        }
        [primal, dual].map(|p| if p > part { part / p } else { 1.0 })
    }
}

impl Dual {
    fn invert(&mut self, rho: f64) {
        let (lam, t) = (1.0 / self.lam, 1.0 / (rho - self.lam));
        let a = 1.0 / (self.slack * lam + self.xi * t);
        self.inverse = Inverses { xi: 1.0 / self.xi, slack: 1.0 / self.slack, lam, t, a };
    }

    /// The step of a datum whose `f` changes by `moved` to first order.
    fn head_for(&mut self, moved: f64) {
        let inverse = &self.inverse;
        let (pl, pt) = (self.push[0] * inverse.lam, self.push[1] * inverse.t);
        self.d_lam = (self.f + pl - pt + moved) * inverse.a;
        self.d_xi = pt - self.xi + self.xi * inverse.t * self.d_lam;
        self.d_slack = pl - self.slack - self.slack * inverse.lam * self.d_lam;
    }
}

/// `df/dy` of a datum: `-C^T r`.
fn gradient<const R: usize, const N: usize>(row: &DistanceRow<R, N>, r: &[f64; R]) -> [f64; N] {
    std::array::from_fn(|c| -(0..R).map(|a| row.columns[a][c] * r[a]).sum::<f64>())
}

fn distance<const R: usize>(r: &[f64; R], along: f64) -> f64 {
    0.5 * (r.iter().map(|x| x * x).sum::<f64>() + along - 1.0)
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
#[allow(clippy::needless_range_loop, reason = "matrices are read as in books")]
mod tests {
    use super::super::feet::COLD;
    use super::super::places::Remap;
    use super::super::tube_curve::TubeCurve;
    use super::*;
    use crate::base::vector::Point3;

    /// Data at heights over a straight curve with equally spaced nodes: a tube round a polyline, with one unknown a node.
    fn toy(nodes: usize, heights: &[f64]) -> (LinearModel<1, 4>, Vec<Foot>) {
        let line = (0..nodes).map(|i| Point3::new(i as f64, 0.0, 0.0)).collect();
        let curve = TubeCurve::new(line, false, None).unwrap();
        let last = (nodes - 1) as f64;
        let x = |i: usize| last * (i as f64 + 0.5) / heights.len() as f64;
        let data: Vec<Point3> = heights.iter().enumerate().map(|(i, h)| Point3::new(x(i), *h, 0.0)).collect();
        let places = Remap::new((1..nodes).map(|_| 1.0), false, &(0..nodes).map(|i| i as f64).collect::<Vec<_>>());
        let feet = curve.feet(&data, (0..data.len()).map(|i| places.place(x(i))), COLD);
        (LinearModel::new(&curve, &feet, [false; 2], 1.0), feet)
    }

    /// Rows of all data over all unknowns.
    fn dense(model: &LinearModel<1, 4>) -> Vec<(Vec<f64>, f64)> {
        let mut rows = Vec::new();
        for j in 0..model.first.len() - 1 {
            for row in &model.rows[model.first[j]..model.first[j + 1]] {
                let mut full = vec![0.0; model.unknowns()];
                for (slot, k) in model.unknowns_of(j).into_iter().enumerate() {
                    if let Some(k) = k {
                        full[k] = row.columns[0][slot];
                    }
                }
                rows.push((full, row.at_rest[0]));
            }
        }
        rows
    }

    /// Gaussian elimination with pivots; `None` if singular.
    fn eliminated(mut a: Vec<Vec<f64>>) -> Option<Vec<f64>> {
        let n = a.len();
        for c in 0..n {
            let pivot = (c..n).max_by(|i, j| a[*i][c].abs().total_cmp(&a[*j][c].abs()))?;
            a.swap(c, pivot);
            if a[c][c].abs() < 1e-11 {
                return None;
            }
            for r in 0..n {
                if r != c {
                    let f = a[r][c] / a[c][c];
                    for k in c..=n {
                        let v = a[c][k];
                        a[r][k] -= f * v;
                    }
                }
            }
        }
        Some((0..n).map(|i| a[i][n] / a[i][i]).collect())
    }

    fn value(q: &Quadratic<4>, y: &[f64]) -> f64 {
        let mut qy = vec![0.0; y.len()];
        q.matrix.multiply_add(y, &mut qy);
        (0..y.len()).map(|i| y[i] * (0.5 * qy[i] + q.linear[i])).sum()
    }

    /// The least objective over all sets of data on a bound of the tube, each on one side: every active set.
    fn best_active_set(model: &LinearModel<1, 4>, q: &Quadratic<4>) -> f64 {
        let (rows, n) = (dense(model), model.unknowns());
        let mut best = f64::INFINITY;
        for code in 0..3_usize.pow(rows.len() as u32) {
            let side = |i: usize| ((code / 3_usize.pow(i as u32)) % 3) as f64 - 1.0;
            let active: Vec<usize> = (0..rows.len()).filter(|i| side(*i) != 0.0).collect();
            if active.len() > n {
                continue;
            }
            // Stationary with the data held at +1 or -1.
            let size = n + active.len();
            let mut a = vec![vec![0.0; size + 1]; size];
            for c in 0..n {
                let mut unit = vec![0.0; n];
                unit[c] = 1.0;
                let mut column = vec![0.0; n];
                q.matrix.multiply_add(&unit, &mut column);
                for r in 0..n {
                    a[r][c] = column[r];
                }
                a[c][size] = -q.linear[c];
            }
            for (k, i) in active.iter().enumerate() {
                for c in 0..n {
                    a[n + k][c] = rows[*i].0[c];
                    a[c][n + k] = rows[*i].0[c];
                }
                a[n + k][size] = rows[*i].1 - side(*i);
            }
            let Some(y) = eliminated(a) else { continue };
            let inside = |(c, rest): &(Vec<f64>, f64)| {
                (rest - c.iter().zip(&y).map(|(c, y)| c * y).sum::<f64>()).abs() <= 1.0 + 1e-9
            };
            if rows.iter().all(inside) {
                best = best.min(value(q, &y[..n]));
            }
        }
        best
    }

    #[test]
    fn the_smoothest_line_in_a_tube_is_that_of_the_best_active_set() {
        for heights in
            [[2.0, -2.0, 2.0, 1.5, -1.0, 0.0], [0.0, 3.0, 0.0, -3.0, 0.0, 3.0], [1.0, 1.0, 1.0, 1.0, 1.0, 4.0]]
        {
            let (model, feet) = toy(7, &heights);
            // A little least squares makes the optimum unique.
            let q = model.objective(1.0, 1e-3, &feet);
            let solved = model.solve(&q, 1e3).unwrap();
            let (found, best) = (value(&q, &solved.y), best_active_set(&model, &q));
            // The gap at which the method stops is 1e-4; the objectives are of size 1 to 1000.
            assert!((found - best).abs() < 2e-4, "{heights:?}: {found} {best}");
            assert!(solved.violation < 1e-5);
        }
    }

    #[test]
    fn an_impossible_tube_shows_where() {
        // Two data over one place, five radii apart: at least 2 * ((2.5² - 1)/2) of violation, wherever the line is.
        let (mut model, feet) = toy(4, &[0.0, 0.0, 0.0, 0.0]);
        let row = model.rows[1];
        model.rows[1].at_rest[0] = 5.0;
        model.rows[2] = row;
        let solved = model.solve(&model.objective(1.0, 0.0, &feet), 5.0).unwrap();
        assert!((solved.violation - 5.25).abs() < 1e-2, "{}", solved.violation);
    }
}
