//! What drawings show beside the curves: curvature combs and joints.

use crate::export::Job;
use cyclide::{ParamCurve, Point3, Vec3, length};

/// Distance of the comb's teeth relative to the drawing, and the largest turn between two of them in radians.
const SPACING: f64 = 0.008;
const TURN: f64 = 0.15;
/// Teeth of one drawing, about, if that spacing would give more.
const TEETH: f64 = 3000.0;
/// Length of the comb's tooth at the curvature below which [`COMMON`] of the teeth lie, relative to the drawing.
const TOOTH: f64 = 0.06;
/// Sharp bends, the rest, must not shrink the whole comb; their teeth are cut at [`LONGEST`].
const COMMON: f64 = 0.9;
const LONGEST: f64 = 2.5;

/// The comb of one smooth piece: feet on the curve and tips, in order.
pub(crate) type Comb = Vec<(Point3, Point3)>;

/// The combs of all curves to one scale, piece by piece; straight pieces have none. `size` is the extent of the
/// drawing.
pub(crate) fn combs(job: &Job<'_>, size: f64) -> Vec<Comb> {
    let total: f64 = job.contours().map(|c| length(c.curve.as_curve())).sum();
    let spacing = (SPACING * size).max(total / TEETH);
    let mut feet: Vec<Vec<(Point3, Vec3)>> = Vec::new();
    for contour in job.contours() {
        let curve = contour.curve.as_curve();
        feet.extend((0..curve.piece_count()).map(|piece| piece_feet(curve, piece, spacing)));
    }
    let mut all: Vec<f64> = feet.iter().flatten().map(|(_, k)| k.length()).filter(|k| *k > 0.0).collect();
    all.sort_by(f64::total_cmp);
    let Some(common) = all.get(((all.len() as f64 - 1.0) * COMMON) as usize) else {
        return Vec::new();
    };
    let scale = TOOTH * size / common;
    let longest = LONGEST * TOOTH * size;
    let tip = |p: Point3, k: Vec3| {
        let length = k.length() * scale;
        p - k * (scale * if length > longest { longest / length } else { 1.0 })
    };
    let visible = |comb: &Comb| comb.iter().any(|(foot, tip)| foot.distance(*tip) > 1e-3 * size);
    let piece = |feet: Vec<(Point3, Vec3)>| feet.into_iter().map(|(p, k)| (p, tip(p, k))).collect();
    feet.into_iter().map(piece).filter(visible).collect()
}

/// Points of a piece with their curvature vectors, about `spacing` apart.
fn piece_feet(curve: &dyn ParamCurve, piece: usize, spacing: f64) -> Vec<(Point3, Vec3)> {
    let length = curve.piece_length(piece, 0.0, 1.0);
    let turn = length * curve.piece_jet(piece, 0.5).curvature().unwrap_or(0.0);
    let teeth = (length / spacing).max((turn / TURN).min(100.0)).round().clamp(1.0, TEETH);
    let jets = (0..=teeth as usize).map(|i| curve.piece_jet(piece, i as f64 / teeth));
    jets.filter_map(|j| j.curvature_vector().filter(|k| k.is_finite()).map(|k| (j.point, k))).collect()
}

/// Where the smooth pieces of the curves meet, and the ends of open curves.
pub(crate) fn joints(job: &Job<'_>) -> Vec<Point3> {
    let mut joints = Vec::new();
    for contour in job.contours() {
        let curve = contour.curve.as_curve();
        let n = curve.piece_count();
        if n == 1 && curve.is_closed() {
            continue;
        }
        joints.extend((0..n).map(|i| curve.piece_point(i, 0.0)));
        if !curve.is_closed() {
            joints.push(curve.piece_point(n - 1, 1.0));
        }
    }
    joints
}

/// Radius of the dots on joints: a part of the drawing's size, smaller where the joints stand close.
pub(crate) fn dot_radius(joints: &[Point3], size: f64) -> f64 {
    (0.3 * typical_gap(joints).unwrap_or(size)).clamp(0.0015 * size, 0.004 * size)
}

/// The middle one of the distances between consecutive joints.
pub(crate) fn typical_gap(joints: &[Point3]) -> Option<f64> {
    let mut gaps: Vec<f64> = joints.windows(2).map(|w| w[0].distance(w[1])).filter(|g| *g > 0.0).collect();
    gaps.sort_by(f64::total_cmp);
    gaps.get(gaps.len() / 2).copied()
}
