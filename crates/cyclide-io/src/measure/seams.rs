//! Borders of open nets that nearly coincide.

use cyclide::surface::{CyclidicNet, Seam, SeamMeasure};

/// The seams of a net, those of the grid it was made from among them, measured on the net.
pub(crate) fn measured_seams(net: &CyclidicNet, given: &[Seam]) -> Vec<(Seam, SeamMeasure)> {
    let own = net.grid().seams().into_iter().filter(|seam| given.iter().all(|g| g.direction != seam.direction));
    let all = given.iter().copied().chain(own);
    all.filter_map(|seam| Some((seam, net.measure_seam(seam)?))).collect()
}
