//! Arcs and segments as QB curves: an arc has the pairs `(a0, 1)` and `(a1 w, w)` with its weight ratio `w`
//! (`docs/math/arcs.md#the-linear-fraction`).

use super::spline::knots_over;
use super::{QbCurve, QbSpline};
use crate::base::quat::Quat;
use crate::curve::arc::Arc;
use crate::curve::arc_path::ArcPath;
use crate::curve::measure::joints;
use crate::curve::param_curve::ParamCurve as _;

/// Turns of the tangent above this are kinks, radians.
const KINK: f64 = 1e-6;

impl QbSpline {
    /// Arcs and segments as a chain of QB curves of degree 1, over the knots of their lengths.
    ///
    /// ```
    /// use cyclide::{Point3, curve::{ArcPath, ParamCurve, QbSpline}};
    /// let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
    /// let path = ArcPath::rounded_polyline(&corners, false, &[0.0, 1.0, 0.0])?;
    /// let same = QbSpline::from_arcs(&path);
    /// assert_eq!((same.degree(), same.spans().len(), same.kinks().len()), (1, 3, 0));
    /// assert!(same.point(0.5).distance(path.arcs()[1].evened().point(0.5)) < 1e-15);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn from_arcs(path: &ArcPath) -> Self {
        let knots = knots_over(path.arcs().iter().map(Arc::length));
        let kinks = joints(path).into_iter().filter(|joint| joint.angle > KINK).map(|joint| joint.next);
        let mut kinks: Vec<usize> = kinks.collect();
        kinks.sort_unstable();
        Self::from_parts(path.arcs().iter().map(qb_arc).collect(), knots, path.is_closed(), kinks, Vec::new())
    }
}

/// The arc with weights of equal length.
fn qb_arc(arc: &Arc) -> QbCurve {
    let ratio = arc.evened().weight_ratio();
    let pairs = [(Quat::ZERO, Quat::ONE), (Quat::from(arc.chord()) * ratio, ratio)];
    QbCurve::from_local(arc.start(), pairs).with_ends(Some(arc.start()), Some(arc.end()))
}
