//! The curve with its points and its curvature comb, drawn; all kinds at the same scales.

use std::fmt::Write as _;

use cyclide::{
    Aabb, Point3,
    curve::{ArcLength, ParamCurve, bounds, resample},
    mesh::flatten,
    model::CurveObject,
};

use super::Comparison;

/// Width of a drawing.
const WIDTH: f64 = 640.0;
/// Least and largest height: as high as its curves are beside their width.
const HEIGHTS: [f64; 2] = [220.0, 560.0];
/// Margin about it.
const MARGIN: f64 = 14.0;
/// Length of the comb's tooth at the reference curvature.
const TOOTH: f64 = 36.0;
/// Teeth longer than so many reference lengths are cut.
const LONGEST: f64 = 2.0;
/// Places along each kind that the outline of its comb passes, and how many of them have a tooth.
const TEETH: usize = 1401;
const TEETH_STEP: usize = 5;

/// What all drawings share: which two axes are seen, the scale, and the curvature that the combs are measured by.
pub(super) struct Scale {
    axes: [usize; 2],
    centre: Point3,
    factor: f64,
    height: f64,
    /// Length of a tooth by its curvature, in the drawing.
    tooth: f64,
    /// The curvature of a tooth of the reference length.
    pub(super) curvature: f64,
}

impl Scale {
    pub(super) fn new(comparison: &Comparison) -> Self {
        let shown = || comparison.kinds.iter().flat_map(|kind| &kind.curves).chain(&comparison.polygon);
        let all = shown().map(|curve| bounds(curve.as_curve())).reduce(Aabb::union);
        let (size, centre) =
            all.map_or(([0.0; 3], Point3::ORIGIN), |b| ((b.max - b.min).to_array(), b.min.midpoint(b.max)));
        // The axis of the least extent is the one that is looked along.
        let along = (0..3).rev().fold(2, |best, axis| if size[axis] < size[best] { axis } else { best });
        let axes = [[1, 2], [0, 2], [0, 1]][along];
        // The longest tooth has room at each side.
        let room = 2.0 * (MARGIN + LONGEST * TOOTH);
        let [wide, high] = axes.map(|axis| size[axis].max(f64::MIN_POSITIVE));
        let height = ((WIDTH - room) * (high / wide) + room).clamp(HEIGHTS[0], HEIGHTS[1]);
        let factor = ((WIDTH - room) / wide).min((height - room) / high).min(f64::MAX);
        // Corners have no bound, and arcs of a fit next to a corner nearly none: the calmest kind says what is large.
        let smooth = comparison.kinds.iter().filter_map(|kind| kind.measures.as_ref()).map(|m| m.max_curvature);
        let least = smooth.filter(|k| *k > 0.0 && k.is_finite()).fold(f64::INFINITY, f64::min);
        let curvature = if least.is_finite() { least } else { 1.0 };
        Self { axes, centre, factor, height, tooth: TOOTH / curvature, curvature }
    }

    /// Which axes are seen.
    pub(super) fn view(&self) -> &'static str {
        match self.axes {
            [0, 1] => "seen along z",
            [0, 2] => "seen along y",
            _ => "seen along x",
        }
    }

    fn place(&self, p: Point3) -> [f64; 2] {
        let at = |k: usize| (p[self.axes[k]] - self.centre[self.axes[k]]) * self.factor;
        [0.5 * WIDTH + at(0), 0.5 * self.height - at(1)]
    }

    /// The foot and the tip of the tooth at a place.
    fn tooth(&self, curve: &dyn ParamCurve, t: f64) -> Option<[[f64; 2]; 2]> {
        let jet = curve.jet(t);
        let vector = jet.curvature_vector().filter(|k| k.is_finite())?;
        let (foot, longest) = (self.place(jet.point), LONGEST * self.curvature);
        let vector = if vector.length() > longest { vector * (longest / vector.length()) } else { vector };
        let across = |k: usize| vector[self.axes[k]] * self.tooth;
        Some([foot, [foot[0] - across(0), foot[1] + across(1)]])
    }

    /// The drawing of one kind, with the points.
    pub(super) fn draw(&self, comparison: &Comparison, curves: &[CurveObject], title: &str) -> String {
        let mut out = format!(
            "<svg class=\"drawing\" viewBox=\"0 0 {WIDTH} {:.0}\" role=\"img\" aria-label=\"{title}: the curve with its points and its curvature comb\">",
            self.height
        );
        for curve in curves {
            self.draw_comb(&mut out, curve.as_curve());
        }
        for side in &comparison.polygon {
            self.draw_line(&mut out, "polygon", side.as_curve());
        }
        for curve in curves {
            self.draw_line(&mut out, "curve", curve.as_curve());
        }
        self.draw_points(&mut out, comparison);
        out + "</svg>"
    }

    fn draw_comb(&self, out: &mut String, curve: &dyn ParamCurve) {
        let lengths = ArcLength::new(curve);
        let teeth: Vec<_> = lengths.uniform(TEETH).into_iter().filter_map(|t| self.tooth(curve, t)).collect();
        out.push_str("<path class=\"teeth\" d=\"");
        for [foot, tip] in teeth.iter().step_by(TEETH_STEP) {
            let _never_fails = write!(out, "M{:.1} {:.1}L{:.1} {:.1}", foot[0], foot[1], tip[0], tip[1]);
        }
        out.push_str("\"/><path class=\"comb\" d=\"");
        push_path(out, teeth.iter().map(|[_, tip]| *tip));
        out.push_str("\"/>");
    }

    fn draw_line(&self, out: &mut String, class: &str, curve: &dyn ParamCurve) {
        let _never_fails = write!(out, "<path class=\"{class}\" d=\"");
        // A fifth of a pixel; what cannot be flattened to that is sampled.
        let points = flatten(curve, 0.2 / self.factor);
        let points = points.unwrap_or_else(|_| resample(curve, 1001));
        push_path(out, points.into_iter().map(|(_, p)| self.place(p)));
        out.push_str("\"/>");
    }

    fn draw_points(&self, out: &mut String, comparison: &Comparison) {
        // So small that they stay apart; of more than fit the curve tells enough.
        let apart = comparison.polygon_length * self.factor / (comparison.points as f64).max(1.0);
        let radius = (0.3 * apart).min(3.2);
        if radius < 0.6 {
            return;
        }
        for side in comparison.polygon.iter().map(CurveObject::as_curve) {
            let inner = (0..side.piece_count()).map(|piece| side.piece_point(piece, 0.0));
            let last = (!side.is_closed()).then(|| side.piece_point(side.piece_count() - 1, 1.0));
            for [x, y] in inner.chain(last).map(|p| self.place(p)) {
                let _never_fails = write!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\"/>");
            }
        }
    }
}

/// A polyline of a path.
pub(super) fn push_path(out: &mut String, points: impl Iterator<Item = [f64; 2]>) {
    for (i, [x, y]) in points.enumerate() {
        let _never_fails = write!(out, "{}{x:.1} {y:.1}", if i == 0 { 'M' } else { 'L' });
    }
}
