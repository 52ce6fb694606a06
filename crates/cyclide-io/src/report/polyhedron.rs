//! The report on a polyhedron whose edges and corners were rounded.

use cyclide::ShortNumber;
use serde::Serialize;

use crate::document::RoundedPolyhedron;

/// A polyhedron, and the measures of its offset by Steiner's formulas: volume `V + A r + M r² + 4 pi r³/3` and area
/// `A + 2 M r + 4 pi r²`, `M` half the sum of the lengths of the edges times their angles.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "smooth-polyhedron", "radius": 1, "points": [[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0], [0, 0, 2], [2, 0, 2], [0, 2, 2], [2, 2, 2]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// let polyhedron = found.polyhedron.expect("it is one");
/// assert_eq!((polyhedron.faces, polyhedron.edges, polyhedron.vertices), (6, 12, 8));
/// assert!((polyhedron.volume - (32.0 + (6.0 + 4.0 / 3.0) * std::f64::consts::PI)).abs() < 1e-10);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PolyhedronReport {
    /// Faces of the polyhedron: planes of the body.
    pub faces: usize,
    /// Edges: cylinders.
    pub edges: usize,
    /// Corners: parts of spheres.
    pub vertices: usize,
    /// The radius.
    pub radius: f64,
    /// Volume of the offset by the formula.
    pub volume: f64,
    /// Area of the offset by the formula.
    pub area: f64,
    /// Largest distance of the polyhedron from the given points and faces.
    pub moved: f64,
}

impl From<&RoundedPolyhedron> for PolyhedronReport {
    fn from(RoundedPolyhedron { polyhedron, radius, moved }: &RoundedPolyhedron) -> Self {
        Self {
            faces: polyhedron.faces().len(),
            edges: polyhedron.edges().count(),
            vertices: polyhedron.corner_count(),
            radius: *radius,
            volume: polyhedron.offset_volume(*radius),
            area: polyhedron.offset_area(*radius),
            moved: *moved,
        }
    }
}

impl PolyhedronReport {
    /// What the text says of it.
    pub(super) fn text(&self, units: &str) -> String {
        let Self { faces, edges, vertices, .. } = self;
        let [radius, area, volume, moved] =
            [self.radius, self.area, self.volume, self.moved].map(|x| ShortNumber(x).to_string());
        let mut text = format!(
            "{faces} faces, {edges} edges, {vertices} vertices, radius {radius} {units}; by Steiner's formulas area {area} {units}², volume {volume} {units}³"
        );
        if self.moved > 0.0 {
            text += &format!("; within {moved} {units} of the given points");
        }
        text
    }
}
