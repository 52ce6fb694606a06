//! The lengths of the weights of nets that join, so that an edge has one parameter in all of them.
//!
//! With `u = ln|w|` a quad asks for `u3 + u0 - u1 - u2 = ln(delta_12/delta_03)`. The difference along an edge is then that along the opposite
//! one but for a term that is known: strips of quads have one unknown each. Those that make the squares of all differences least are
//! the negative means, but for one condition for each extraordinary vertex: the differences round its ring add up to 0.

use super::QuadLayout;
use super::connections::side;
use std::collections::{HashMap, VecDeque};

/// Conditions whose pivot is below this part of the largest follow from the others.
const DEPENDENT: f64 = 1e-9;

/// The difference along an edge from its smaller end: `sign * strip + term`.
#[derive(Debug, Clone, Copy)]
struct Difference {
    strip: usize,
    sign: f64,
    term: f64,
}

/// The logarithms of the lengths at the vertices of the mesh, with mean 0; `kappa` is what each quad asks for.
pub(super) fn lengths(layout: &QuadLayout, kappa: &[f64]) -> Vec<f64> {
    let quads = layout.quads();
    let differences = differences(&quads, kappa);
    let strips = 1 + differences.values().map(|d| d.strip).max().unwrap_or(0);
    let (mut count, mut sum) = (vec![0.0; strips], vec![0.0; strips]);
    let edges = layout.edges();
    for [a, b] in &edges {
        let d = differences[&side(*a, *b)];
        count[d.strip] += 1.0;
        sum[d.strip] += d.sign * d.term;
    }
    let mut values: Vec<f64> = sum.iter().zip(&count).map(|(sum, count)| -sum / f64::max(*count, 1.0)).collect();
    close_rings(layout, &differences, &count, &mut values);

    let along = |a: usize, b: usize| {
        let d = differences[&side(a, b)];
        let up = d.sign * values[d.strip] + d.term;
        if a < b { up } else { -up }
    };
    let mut next: HashMap<usize, Vec<usize>> = HashMap::new();
    for [a, b] in edges {
        next.entry(a).or_default().push(b);
        next.entry(b).or_default().push(a);
    }
    let mut lengths: Vec<Option<f64>> = vec![None; layout.points().len()];
    lengths[layout.base()] = Some(0.0);
    let mut open = VecDeque::from([(layout.base(), 0.0)]);
    while let Some((a, length)) = open.pop_front() {
        for b in next.get(&a).into_iter().flatten() {
            if lengths[*b].is_none() {
                let at = length + along(a, *b);
                lengths[*b] = Some(at);
                open.push_back((*b, at));
            }
        }
    }
    let known = lengths.iter().flatten();
    let mean = known.clone().sum::<f64>() / known.count().max(1) as f64;
    lengths.into_iter().map(|u| u.map_or(0.0, |u| u - mean)).collect()
}

/// The differences along all edges, strip by strip.
fn differences(quads: &[[usize; 4]], kappa: &[f64]) -> HashMap<[usize; 2], Difference> {
    let mut at_edge: HashMap<[usize; 2], Vec<usize>> = HashMap::new();
    for (quad, [a0, a1, a2, a3]) in quads.iter().enumerate() {
        for [a, b] in [[a0, a1], [a2, a3], [a0, a2], [a1, a3]] {
            at_edge.entry(side(*a, *b)).or_default().push(quad);
        }
    }
    let mut differences: HashMap<[usize; 2], Difference> = HashMap::new();
    let mut strips = 0;
    for [a0, a1, a2, _] in quads {
        for first in [[*a0, *a1], [*a0, *a2]] {
            let first = side(first[0], first[1]);
            if differences.contains_key(&first) {
                continue;
            }
            differences.insert(first, Difference { strip: strips, sign: 1.0, term: 0.0 });
            let mut open = vec![first];
            while let Some([a, b]) = open.pop() {
                let here = differences[&[a, b]];
                for quad in &at_edge[&[a, b]] {
                    let [a0, a1, a2, a3] = quads[*quad];
                    // Each side with the opposite one, and what its difference has more.
                    let pairs = [
                        ([a0, a1], [a2, a3], 1.0),
                        ([a2, a3], [a0, a1], -1.0),
                        ([a0, a2], [a1, a3], 1.0),
                        ([a1, a3], [a0, a2], -1.0),
                    ];
                    for (from, [p, q], more) in pairs {
                        let (same, against) = (from == [a, b], from == [b, a]);
                        if !(same || against) || differences.contains_key(&side(p, q)) {
                            continue;
                        }
                        // From `from[0]` to `from[1]`, then from p to q, then from the smaller end.
                        let turned = if same { 1.0 } else { -1.0 };
                        let back = if p < q { 1.0 } else { -1.0 };
                        let term = back * (turned * here.term + more * kappa[*quad]);
                        differences
                            .insert(side(p, q), Difference { strip: strips, sign: back * turned * here.sign, term });
                        open.push(side(p, q));
                    }
                }
            }
            strips += 1;
        }
    }
    differences
}

/// Adds to the values of the strips what closes the rings, with the least squares of all differences.
fn close_rings(layout: &QuadLayout, differences: &HashMap<[usize; 2], Difference>, count: &[f64], values: &mut [f64]) {
    let rings = layout.round().len();
    let mut parts = vec![HashMap::<usize, f64>::new(); rings];
    let mut rows = vec![vec![0.0; rings + 1]; rings];
    for (k, at) in layout.round().iter().enumerate() {
        for (i, a) in at.ring.iter().enumerate() {
            let b = at.ring[(i + 1) % at.ring.len()];
            let Some(d) = differences.get(&side(*a, b)) else { continue };
            let turned = if *a < b { 1.0 } else { -1.0 };
            *parts[k].entry(d.strip).or_default() += turned * d.sign;
            rows[k][rings] += turned * (d.sign * values[d.strip] + d.term);
        }
    }
    for k in 0..rings {
        for l in 0..rings {
            let mut common: Vec<(usize, f64)> =
                parts[k].iter().filter_map(|(s, x)| Some((*s, x * parts[l].get(s)? / count[*s]))).collect();
            // In the order of strips: the same bits each time.
            common.sort_by_key(|(strip, _)| *strip);
            rows[k][l] = common.into_iter().map(|(_, x)| x).sum();
        }
    }
    for (k, multiplier) in multipliers(rows).into_iter().enumerate() {
        for (strip, part) in &parts[k] {
            values[*strip] -= multiplier * part / count[*strip];
        }
    }
}

/// The solution of a positive semidefinite system `[A | b]`, 0 where a row follows from others.
fn multipliers(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    let largest = (0..n).map(|k| rows[k][k]).fold(0.0, f64::max);
    let (mut solution, mut done) = (vec![0.0; n], vec![false; n]);
    for _ in 0..n {
        let Some(pivot) = (0..n).filter(|k| !done[*k]).max_by(|a, b| rows[*a][*a].total_cmp(&rows[*b][*b])) else {
            break;
        };
        if !(rows[pivot][pivot] > DEPENDENT * largest) {
            break;
        }
        done[pivot] = true;
        let divisor = rows[pivot][pivot];
        let row: Vec<f64> = rows[pivot].iter().map(|x| x / divisor).collect();
        for (_, other) in rows.iter_mut().enumerate().filter(|(k, _)| *k != pivot) {
            let factor = other[pivot];
            other.iter_mut().zip(&row).for_each(|(x, r)| *x -= factor * r);
        }
        rows[pivot] = row;
    }
    for k in (0..n).filter(|k| done[*k]) {
        solution[k] = rows[k][n];
    }
    solution
}
