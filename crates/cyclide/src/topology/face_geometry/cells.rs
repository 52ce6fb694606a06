//! What is proved of the cells between parameter lines.

/// How far the cells of a surface, cut along parameter lines, are from the flat polygons over their corners, by
/// [`FaceGeometry::cell_distances`](crate::topology::FaceGeometry::cell_distances).
///
/// ```
/// use cyclide::{Point3, Vec3, surface::CyclidePatch, topology::FaceGeometry};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let octant = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)?;
/// let cells = octant.cell_distances(&[0.0, 0.5, 1.0], &[0.0, 0.5, 1.0], 1e-3);
/// // 45 degrees of a circle have a sagitta of 0.076: nine times as many cuts make it a thousandth.
/// assert!(cells.distance > 0.076 && cells.excess[0][0] > 8.0);
/// // Nothing is proved of what is not cut upwards.
/// assert_eq!(octant.cell_distances(&[1.0, 0.0], &[0.0, 1.0], 1e-3).distance, f64::INFINITY);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CellDistances {
    /// No point of a cell is farther from its polygons, and none of these from the cell. Infinite where nothing is proved.
    pub distance: f64,
    /// The worst cell of each column (between two cuts of s), and of each row: how many times as many cuts it needs. Where none
    /// is above 1 the distance is within the tolerance.
    pub excess: [Vec<f64>; 2],
}

impl CellDistances {
    /// Of cells that are all the same: the distance, and how many times as many cuts they need.
    pub(super) fn even([s, t]: [&[f64]; 2], distance: f64, excess: f64) -> Self {
        let count = |cuts: &[f64]| cuts.len().saturating_sub(1);
        Self { distance, excess: [vec![excess; count(s)], vec![excess; count(t)]] }
    }

    /// Of cuts that do not ascend in `[0, 1]`, or that leave no cell.
    pub(super) fn unknown(cuts: [&[f64]; 2]) -> Self {
        Self::even(cuts, f64::INFINITY, f64::INFINITY)
    }
}

/// True for cuts between which there are cells.
pub(super) fn are_cuts(cuts: &[f64]) -> bool {
    // A number that is none does not compare.
    let inside = |cut: &f64| (0.0..=1.0).contains(cut);
    cuts.len() > 1 && cuts.iter().all(inside) && cuts.windows(2).all(|w| w[0] <= w[1])
}
