//! The report on closed directions of nets made circular, and on what is round extraordinary vertices.

use serde::Serialize;

/// How far a closed direction of a grid was from closing as a net, and is (see `GridClosing` of the kernel).
///
/// ```
/// let place = |i: i32, j: i32| (f64::from(i) * std::f64::consts::FRAC_PI_4, f64::from(j));
/// let point = |(a, z): (f64, f64)| [3.0 * a.cos(), 2.0 * a.sin(), z];
/// let grid: Vec<Vec<[f64; 3]>> = (0..4).map(|j| (0..8).map(|i| point(place(i, j))).collect()).collect();
/// let object = format!(r#"{{"type": "cyclidic-net", "closed": [true, false], "make_circular": true, "grid": {grid:?}}}"#);
/// let document: cyclide_io::Document = format!(r#"{{"cyclide": 1, "objects": {{"tube": {object}}}}}"#).parse()?;
/// let report = cyclide_io::report::ObjectReport::new(&document.build()?[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// let [closing] = found.circular.expect("it was asked for").closing[..] else { unreachable!("one direction is closed") };
/// assert!(closing.direction == "s" && closing.angle_before > 1e-3 && closing.angle_after < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ClosingReport {
    /// `s` or `t`.
    pub direction: &'static str,
    /// Largest angle by which a frame is rotated after one turn along the grid as given, in radians.
    pub angle_before: f64,
    /// The same as made.
    pub angle_after: f64,
    /// Largest difference from 1 of the ratio of speeds after and before a turn, as given; meaningless if quads were
    /// not circular.
    pub stretch_before: f64,
    /// The same as made.
    pub stretch_after: f64,
}

impl ClosingReport {
    /// Those of the closed directions.
    pub(super) fn all(changes: &[Option<cyclide_grids::ClosingChange>; 2]) -> Vec<Self> {
        let report = |(direction, change): (&'static str, &Option<cyclide_grids::ClosingChange>)| {
            change.map(|c| Self {
                direction,
                angle_before: c.angle_before,
                angle_after: c.angle_after,
                stretch_before: c.stretch_before,
                stretch_after: c.stretch_after,
            })
        };
        ["s", "t"].into_iter().zip(changes).filter_map(report).collect()
    }
}

/// How far a mesh was, and is, from closing around its extraordinary vertices.
///
/// ```
/// let plane = r#"{"type": "cyclidic-net", "make_circular": true, "grid": [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0]]]}"#;
/// let document: cyclide_io::Document = format!(r#"{{"cyclide": 1, "objects": {{"n": {plane}}}}}"#).parse()?;
/// let report = cyclide_io::report::ObjectReport::new(&document.build()?[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.circular.expect("it was asked for").round.is_none()); // a single grid
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RoundReport {
    /// The number of these vertices, each with an opening.
    pub vertices: usize,
    /// Largest angle, apart from quarter turns, by which a frame is rotated after one turn as given, in radians.
    pub angle_before: f64,
    /// The same as made.
    pub angle_after: f64,
}

impl From<&cyclide_grids::RoundChange> for RoundReport {
    fn from(change: &cyclide_grids::RoundChange) -> Self {
        Self { vertices: change.vertices, angle_before: change.angle_before, angle_after: change.angle_after }
    }
}
