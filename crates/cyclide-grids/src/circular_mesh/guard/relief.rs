//! The local number: on how much of the surface less than half of the relief is left.
//!
//! The global numbers do not see ripples on a tube or a hump on a dome: the curved base fills bending, thickness and
//! spread. Relief is what varies in the mean curvature, which constant curvature (spheres, cylinders) has none of and
//! which knows no direction, so that grid lines may slide and turn. At a stride `s` and around each vertex, over a window of
//! `2s` places to all sides,
//!
//! ```text
//! kept = cov(H', M) / cov(H, M),   relief = sqrt(cov(H, M)) (s h)²/2
//! ```
//!
//! with the mean curvature `H` of the input at the feet of the moved vertices, the mean `M` of its values at the four next vertices
//! there, the mean curvature `H'` of the result, and the median edge `h`. `kept` is the slope of the regression of `H'` on
//! `H` with `M` as its instrument: errors of single vertices are in `H` and `H'` alike but not in `M`, so that
//! smoothing noise costs nothing. Where `cov(H, M)` is below a quarter of `var(H)` noise prevails and nothing is said: of noise
//! alone it is 0 on average, a twentieth either way in the smallest window. Ripples of less than four quads change sides from
//! vertex to vertex and have it below zero, which serves as well; at four it vanishes, and they are not seen. `relief` is the
//! height that the variation amounts to over the stride; below a thirtieth of an edge nothing is said either.
//!
//! The number is the part of the vertices whose window has relief and keeps less than half of it, the largest over the
//! strides 2, 4, 8 up to a sixth of the shorter direction. Stencils are moved inside at open borders. Constants
//! searched over 225 grids (8 to 72 quads): along curvature lines, with noise up to a tenth of an edge, at most 0.01, with
//! twice that noise 0.08; tubes that lose their spiral ripples 1, domes that lose two thirds of a hump 0.16 to 0.36.

use super::{Feet, Guard};
use crate::circular_mesh::curvature::Curvature;
use crate::circular_mesh::input_surface::Foot;
use crate::circular_mesh::neighbors::{along, clamped, vertices};
use cyclide::Point3;
use cyclide::surface::QuadGrid;

/// Relief below this part of the median edge does not count: at a fiftieth the steepening of a paraboloid counts, at a
/// twenty-sixth ripples of four hundredths of the radius of a tube do not any more.
const SHALLOW: f64 = 1.0 / 30.0;
/// The part of the variance that neighbors must share, with one sign or the other.
const SHARED: f64 = 0.25;
/// The part of the relief that must be left.
const KEPT: f64 = 0.5;
/// How much the corners of the stencils count: what it takes to tell the direction of the bending.
const CORNERS: f64 = 0.1;
/// The shortest stride, and how many of the longest the shorter direction has at least.
const SHORTEST: usize = 2;
const LONGEST_PARTS: usize = 6;
/// Windows with fewer vertices tell nothing.
const FEW: f64 = 6.0;

/// The part of the surface, 0 to 1, in whose neighborhood less than half of the relief is left.
pub(super) fn lost_relief(guard: &Guard<'_>, feet: &Feet) -> f64 {
    let shorter = guard.grid.size()[0].min(guard.grid.size()[1]);
    // A row of quads has no curvature across.
    if shorter < 3 {
        return 0.0;
    }
    let doubled = std::iter::successors(Some(SHORTEST), |stride| Some(2 * stride));
    let strides = doubled.take_while(|&s| s == SHORTEST || s * LONGEST_PARTS <= shorter);
    strides.map(|stride| at_stride(guard, feet, stride)).fold(0.0, f64::max)
}

fn at_stride(guard: &Guard<'_>, feet: &Feet, stride: usize) -> f64 {
    let grid = guard.grid;
    let strides = super::lowered(grid, stride);
    let (before, after) = (mean_curvatures(grid, guard.before, strides), mean_curvatures(grid, guard.after, strides));
    let means = means_of_neighbors(grid, &before);
    let values = |(foot, after): (&Option<Foot>, &Option<f64>)| {
        let foot = foot.as_ref()?;
        Some([foot.value(&before)?, foot.value(&means)?, (*after)?])
    };
    let used: Vec<Option<[f64; 3]>> = feet.iter().zip(&after).map(values).collect();
    let count = used.iter().flatten().count() as f64;
    if count == 0.0 {
        return 0.0;
    }
    let moments = Moments::new(grid, &used, strides.map(|s| 2 * s));
    let reach = strides[0].max(strides[1]) as f64 * guard.edge;
    let least = SHALLOW * guard.edge / (0.5 * reach * reach);
    let lost = |v: &usize| moments.at(*v).is_some_and(|m| m.is_lost(least));
    (0..used.len()).filter(|v| used[*v].is_some()).filter(lost).count() as f64 / count
}

/// The mean curvatures at the vertices; at open borders that of the nearest vertex with a full stencil.
fn mean_curvatures(grid: &QuadGrid, points: &[Point3], stride: [usize; 2]) -> Vec<Option<f64>> {
    let inside = |at: [usize; 2]| {
        [0, 1].map(|d| if grid.closed()[d] { at[d] } else { at[d].clamp(stride[d], grid.size()[d] - 1 - stride[d]) })
    };
    vertices(grid).map(|at| Some(Curvature::at(points, grid, inside(at), stride, CORNERS)?.mean())).collect()
}

/// The mean of the values at the four next vertices (fewer at the border).
fn means_of_neighbors(grid: &QuadGrid, values: &[Option<f64>]) -> Vec<Option<f64>> {
    let mean = |at: [usize; 2]| {
        let (mut sum, mut count) = (0.0, 0.0);
        for d in 0..2 {
            for next in clamped(grid, at[d], d, 1).into_iter().filter(|k| *k != at[d]) {
                sum += values[along(grid, at, d, next)]?;
                count += 1.0;
            }
        }
        Some(sum / count)
    };
    vertices(grid).map(mean).collect()
}

/// Covariances of one window.
struct Window {
    variance: f64,
    shared: f64,
    kept: f64,
}

impl Window {
    /// True if there is relief, with a root of at least `least`, and less than half of it is left.
    fn is_lost(&self, least: f64) -> bool {
        let shared = self.shared.abs();
        shared > least * least && shared > SHARED * self.variance && self.kept * self.shared.signum() < KEPT * shared
    }
}

/// Sums over the windows around all vertices: count, `H`, `M`, `H'`, `H²`, `H M`, `H' M`.
struct Moments([Vec<f64>; 7]);

impl Moments {
    fn new(grid: &QuadGrid, used: &[Option<[f64; 3]>], half: [usize; 2]) -> Self {
        // About the mean of H, which takes nothing from covariances: rounding stays that of the variation.
        let count = used.iter().flatten().count().max(1) as f64;
        let middle = used.iter().flatten().map(|values| values[0]).sum::<f64>() / count;
        let term = |of: fn([f64; 3]) -> f64| {
            let values = used.iter().map(|v| v.map_or(0.0, |v| of(v.map(|x| x - middle))));
            window_sums(grid, values.collect(), half)
        };
        Self([
            window_sums(grid, used.iter().map(|v| f64::from(u8::from(v.is_some()))).collect(), half),
            term(|[h, _, _]| h),
            term(|[_, m, _]| m),
            term(|[_, _, k]| k),
            term(|[h, _, _]| h * h),
            term(|[h, m, _]| h * m),
            term(|[_, m, k]| k * m),
        ])
    }

    fn at(&self, vertex: usize) -> Option<Window> {
        let [count, h, m, k, hh, hm, km] = [0, 1, 2, 3, 4, 5, 6].map(|i| self.0[i][vertex]);
        (count > FEW).then(|| Window {
            variance: hh / count - (h / count) * (h / count),
            shared: hm / count - (h / count) * (m / count),
            kept: km / count - (k / count) * (m / count),
        })
    }
}

/// Sums over windows of `half` places to both sides along each direction, cut off at open borders and at once round.
fn window_sums(grid: &QuadGrid, values: Vec<f64>, half: [usize; 2]) -> Vec<f64> {
    (0..2).fold(values, |values, d| {
        let count = grid.size()[d];
        let mut sums = vec![0.0; values.len()];
        for line in 0..grid.size()[1 - d] {
            let line = grid.line(d, line);
            // Sums of the first places; in a closed direction of twice round.
            let mut first = vec![0.0];
            for k in 0..if grid.closed()[d] { 2 * count } else { count } {
                first.push(first[k] + values[line[k % count]]);
            }
            for (k, &vertex) in line.iter().enumerate() {
                let (from, to) = if !grid.closed()[d] {
                    (k.saturating_sub(half[d]), (k + half[d] + 1).min(count))
                } else if 2 * half[d] + 1 >= count {
                    (0, count)
                } else {
                    let from = (k + count - half[d]) % count;
                    (from, from + 2 * half[d] + 1)
                };
                sums[vertex] = first[to] - first[from];
            }
        }
        sums
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_are_cut_off_at_borders_and_go_round_once() {
        let points = (0..20).map(|k| Point3::new(f64::from(k % 5), f64::from(k / 5), 0.0)).collect();
        let grid = QuadGrid::new(points, [5, 4], [true, false]).unwrap();
        let ones = window_sums(&grid, vec![1.0; 20], [9, 1]);
        // All five columns once, two rows at the border and three inside.
        assert_eq!(ones, [[10.0; 5], [15.0; 5], [15.0; 5], [10.0; 5]].concat());
        let mut one = vec![0.0; 20];
        one[0] = 1.0;
        let sums = window_sums(&grid, one, [1, 1]);
        let at: Vec<usize> = (0..20).filter(|k| sums[*k] > 0.0).collect();
        assert_eq!(at, [0, 1, 4, 5, 6, 9]);
    }
}
