//! Fewer nodes: those that the curve misses least are taken out in batches and the rest is fitted again, as long as all
//! data stay in the tube and `J` within a budget of the fairest seen (`docs/math/fair-fits.md#nodes`).

use super::along::{Along, apart};
use super::fit::{Data, Fit, Patience, fewest_nodes};
use super::places::Remap;
use super::tube_curve::TubeCurve;

/// Part of the nodes taken out at once, at first and at least.
const FIRST_BATCH: f64 = 0.3;
const SMALLEST_BATCH: f64 = 0.04;
/// What a failed batch makes of the next.
const SHRINK: f64 = 0.6;
/// Removed nodes this many segments from a datum outside were needed.
const REACH: f64 = 1.6;
/// Segments round a removed node whose `J` is compared.
const NEAR: f64 = 2.0;

/// How far a removal goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct RemovalLimits {
    /// Fits at most.
    pub fits: usize,
    /// Nodes at least, beside the fewest a curve can have.
    pub nodes: usize,
    /// Growth of the objective over the smallest seen.
    pub budget: f64,
}

/// Why no more nodes are taken out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stop {
    /// There are as few as asked for, or as a curve can have.
    Fewest,
    /// The data need them.
    Data,
    /// Fewer would cost more fairness than the budget allows.
    Budget,
    /// The fits are spent.
    Fits,
}

/// Takes out nodes of a feasible fit.
pub(super) fn remove(data: &Data<'_>, dense: Fit, limits: &RemovalLimits) -> (Fit, Stop) {
    let scale = dense.fairness.max(data.floor);
    let mut smallest = dense.objective(data, scale);
    let mut locked = vec![false; dense.curve.nodes.len()];
    let mut batch = FIRST_BATCH;
    let mut fit = dense;
    let least = limits.nodes.max(fewest_nodes(data.closed));
    let mut rest: Vec<usize> = Vec::new();
    let mut needed = Stop::Data;
    for _ in 0..limits.fits {
        let removed = if rest.is_empty() { cheapest(&fit, &locked, batch, least) } else { std::mem::take(&mut rest) };
        if removed.is_empty() {
            return if fit.curve.nodes.len() <= least { (fit, Stop::Fewest) } else { (fit, needed) };
        }
        let kept: Vec<usize> = (0..fit.curve.nodes.len()).filter(|i| removed.binary_search(i).is_err()).collect();
        let trial = with_nodes(data, &fit, &kept);
        let trial = trial.map(|t| t.fairest(data, Patience { steps: 6, change: 2e-3, grow: false }));
        let within = |t: &Fit| t.objective(data, scale) <= (1.0 + limits.budget) * smallest;
        match trial {
            Some(trial) if trial.feasible(data) && within(&trial) => {
                smallest = smallest.min(trial.objective(data, scale));
                locked = kept.iter().map(|i| locked[*i]).collect();
                fit = trial;
            }
            failed => {
                batch = (SHRINK * batch).max(SMALLEST_BATCH);
                let culprits = match &failed {
                    None => removed.clone(),
                    Some(t) if !t.feasible(data) => needed_by_data(data, &fit, t, &removed),
                    Some(t) => needed_by_fairness(&fit, t, &kept, &removed),
                };
                needed = if failed.is_some_and(|t| t.feasible(data)) { Stop::Budget } else { Stop::Data };
                for i in culprits {
                    locked[i] = true;
                }
                rest = removed.into_iter().filter(|i| !locked[*i]).collect();
            }
        }
    }
    let stop = if fit.curve.nodes.len() <= least { Stop::Fewest } else { Stop::Fits };
    (fit, stop)
}

/// The curve through some of the nodes of a fit.
fn with_nodes(data: &Data<'_>, fit: &Fit, kept: &[usize]) -> Option<Fit> {
    let curve = &fit.curve;
    let nodes = kept.iter().map(|i| curve.nodes[*i]).collect();
    let tangents: Vec<_> = kept.iter().map(|i| curve.tangents[*i]).collect();
    let remap = remap(fit, kept);
    let curve = TubeCurve::new(nodes, data.closed, Some(&tangents))?;
    Some(Fit::new(data, curve, fit.feet.iter().map(|f| remap.place(f.place.position())), super::feet::COLD))
}

fn remap(fit: &Fit, kept: &[usize]) -> Remap {
    let positions: Vec<f64> = kept.iter().map(|i| *i as f64).collect();
    Remap::new(fit.curve.segments.iter().map(|s| s.chord), fit.curve.closed, &positions)
}

/// The unlocked nodes whose jumps in the derivative of curvature mean least, as displacements of the curve; never
/// two neighbors, never the ends. Rising.
fn cheapest(fit: &Fit, locked: &[bool], batch: f64, least: usize) -> Vec<usize> {
    let curve = &fit.curve;
    let (n, m) = (curve.nodes.len(), curve.segments.len());
    let most = ((batch * n as f64) as usize).max(1).min(n.saturating_sub(least));
    let inner = |i: usize| curve.closed || (i > 0 && i + 1 < n);
    let jumps = curve.jumps();
    let price = |i: usize| {
        let product = curve.segments[(i + m - 1) % m].chord * curve.segments[i % m].chord;
        jumps[i] * product * product.sqrt()
    };
    let mut candidates: Vec<(f64, usize)> =
        (0..n).filter(|i| inner(*i) && !locked[*i]).map(|i| (price(i), i)).collect();
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut taken = vec![false; n];
    let mut removed = Vec::new();
    for (_, i) in candidates {
        if removed.len() == most {
            break;
        }
        if !taken[(i + n - 1) % n] && !taken[(i + 1) % n] {
            taken[i] = true;
            removed.push(i);
        }
    }
    removed.sort_unstable();
    removed
}

/// The removed nodes near data that are outside now; at least the one nearest to the farthest datum.
fn needed_by_data(data: &Data<'_>, fit: &Fit, trial: &Fit, removed: &[usize]) -> Vec<usize> {
    let ring = data.closed.then_some(fit.curve.nodes.len());
    let outside = Along::new(trial.outside(data).map(|(i, _)| (fit.feet[i].place.position(), ())), ring);
    let near = |k: &&usize| outside.near(**k as f64, REACH).next().is_some();
    let needed: Vec<usize> = removed.iter().filter(near).copied().collect();
    if !needed.is_empty() {
        return needed;
    }
    let error = |i: usize| trial.feet[i].error.length_squared();
    let worst = (0..trial.feet.len()).max_by(|a, b| error(*a).total_cmp(&error(*b))).unwrap_or(0);
    let place = fit.feet[worst].place.position();
    let distance = |k: usize| apart(k as f64, place, ring);
    removed.iter().copied().min_by(|a, b| distance(*a).total_cmp(&distance(*b))).into_iter().collect()
}

/// The third of the removed nodes with the largest growth of `J` near them.
fn needed_by_fairness(fit: &Fit, trial: &Fit, kept: &[usize], removed: &[usize]) -> Vec<usize> {
    let n = fit.curve.nodes.len();
    let ring = fit.curve.closed.then_some(n);
    // The middle of each new segment as a position on the old curve.
    let middle = |j: usize| {
        let (a, b) = (kept[j], kept.get(j + 1).copied().unwrap_or(kept[0] + n));
        (0.5 * (a + b) as f64) % n as f64
    };
    let along = |curve: &TubeCurve, at: &dyn Fn(usize) -> f64| {
        let variation = curve.segments.iter().map(|s| s.chord * s.variation[0].length_squared());
        Along::new(variation.enumerate().map(|(j, variation)| (at(j), variation)), ring)
    };
    let (new, old) = (along(&trial.curve, &middle), along(&fit.curve, &|j| j as f64 + 0.5));
    let near = |along: &Along<f64>, k: usize| along.near(k as f64, NEAR).sum::<f64>();
    let growth = |k: usize| near(&new, k) - near(&old, k);
    let mut grown: Vec<(f64, usize)> = removed.iter().map(|k| (growth(*k), *k)).collect();
    grown.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    grown.truncate(removed.len().div_ceil(3));
    grown.into_iter().map(|g| g.1).collect()
}
