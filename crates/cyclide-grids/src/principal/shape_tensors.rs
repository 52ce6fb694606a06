//! The traceless part of the second fundamental form as a tensor of space at each vertex, and fields of such tensors smoothed over
//! the mesh: their eigenvectors are the principal directions.

use super::jets::VertexJet;
use super::mesh_table::MeshTable;
use crate::sparse_solver::SymmetricSum;
use cyclide::Vec3;

/// A symmetric tensor: xx, xy, xz, yy, yz, zz.
pub(super) type Tensor = [f64; 6];
/// Weights above this many times the median count no more.
const MOST_WEIGHT: f64 = 4.0;

/// What the vertices say of principal directions.
pub(super) struct ShapeTensors {
    /// Traceless, with eigenvalues 1/2 and -1/2: directions alone.
    directions: Vec<Tensor>,
    /// How much each counts: the difference of the principal curvatures over its median, at most 4.
    pub(super) weights: Vec<f64>,
    /// The medians of the difference of the principal curvatures, and of the larger of them.
    pub(super) median_difference: f64,
    pub(super) median_curvature: f64,
}

impl ShapeTensors {
    pub(super) fn new(jets: &[VertexJet]) -> Self {
        let mut directions = Vec::with_capacity(jets.len());
        let (mut differences, mut curvatures) = (Vec::with_capacity(jets.len()), Vec::with_capacity(jets.len()));
        for jet in jets {
            let [xx, xy, yy] = jet.shape();
            // Half the difference, as the length of (p, q) in p (xx - yy) / 2 + q xy.
            let (p, q) = (0.5 * (xx - yy), xy);
            let half = p.hypot(q);
            differences.push(2.0 * half);
            curvatures.push(0.5 * (xx + yy).abs() + half);
            let [x, y, _] = jet.frame;
            let scale = if half > 0.0 { 0.5 / half } else { 0.0 };
            directions.push(traceless(x, y, p * scale, q * scale));
        }
        let (median_difference, median_curvature) = (median(&differences), median(&curvatures));
        let weight = |a: &f64| if median_difference > 0.0 { (a / median_difference).min(MOST_WEIGHT) } else { 0.0 };
        let weights = differences.iter().map(weight).collect();
        Self { directions, weights, median_difference, median_curvature }
    }

    /// What was measured, not smoothed.
    pub(super) fn directions(&self) -> &[Tensor] {
        &self.directions
    }

    /// The field that is near these where they count, and smooth: `(diag(w) + mu L) S = w U` with the Laplacian of the mesh's graph.
    /// `None` if there is no memory for the factor.
    pub(super) fn smoothed(&self, table: &MeshTable, mu: f64) -> Option<Vec<Tensor>> {
        let n = table.points.len();
        let mut sum = SymmetricSum::new(n);
        // Vertices of no triangle, and where nothing counts: they must have some equation.
        (0..n).for_each(|v| sum.add(v, v, self.weights[v] + 1e-12));
        for half in table.edges() {
            let [u, v] = table.ends(half);
            sum.add_square(&[(u, 1.0), (v, -1.0)], mu);
        }
        let mut right: Vec<f64> =
            (0..6).flat_map(|k| (0..n).map(move |v| self.weights[v] * self.directions[v][k])).collect();
        sum.factor()?.solve(&mut right)?;
        Some((0..n).map(|v| std::array::from_fn(|k| right[k * n + v])).collect())
    }
}

/// `p (xx - yy) + q (xy + yx)` of two perpendicular directions.
fn traceless(x: Vec3, y: Vec3, p: f64, q: f64) -> Tensor {
    let entry = |i: usize, j: usize| p * (x[i] * x[j] - y[i] * y[j]) + q * (x[i] * y[j] + y[i] * x[j]);
    [entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)]
}

/// `a T b`.
pub(super) fn product(t: &Tensor, a: Vec3, b: Vec3) -> f64 {
    let row = |i: [usize; 3]| t[i[0]] * b.x + t[i[1]] * b.y + t[i[2]] * b.z;
    a.x * row([0, 1, 2]) + a.y * row([1, 3, 4]) + a.z * row([2, 4, 5])
}

pub(super) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}
