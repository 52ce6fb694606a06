//! What drawings show beside the curves: curvature combs and joints.

use crate::job::Job;
use cyclide::{CurveJet, ParamCurve, Point3, Vec3, length};

/// Distance of the comb's teeth relative to the drawing, and the largest turn between two of them in radians.
const SPACING: f64 = 0.008;
const TURN: f64 = 0.15;
/// Teeth of one drawing, about, if that spacing would give more.
const TEETH: f64 = 3000.0;
/// Length of the comb's tooth at the curvature below which [`COMMON`] of the bent length lies, relative to the
/// drawing.
const TOOTH: f64 = 0.055;
/// Sharp bends, the rest, must not shrink the whole comb; their teeth are cut at [`LONGEST`].
const COMMON: f64 = 0.9;
const LONGEST: f64 = 2.0;
/// Teeth of a piece of a curve of varying curvature at least, unless they would be closer than [`CLOSEST`].
const VARYING: f64 = 16.0;
const CLOSEST: f64 = 0.002;

/// The comb of one smooth piece: feet on the curve and tips, in order.
pub(crate) type Comb = Vec<(Point3, Point3)>;

/// The combs of all curves to one scale, piece by piece; straight pieces have none. `size` is the extent of the
/// drawing.
pub(crate) fn combs(job: &Job<'_>, size: f64) -> Vec<Comb> {
    let total: f64 = job.contours().map(|c| length(c.curve.as_curve())).sum();
    let spacing = (SPACING * size).max(total / TEETH);
    let mut pieces: Vec<Vec<Tooth>> = Vec::new();
    for contour in job.contours() {
        let curve = contour.curve.as_curve();
        // One piece that needs close teeth gives them to all of its curve: an arc among blends is no hole in the comb.
        let varying = (0..curve.piece_count()).any(|piece| varies(curve, piece));
        pieces.extend((0..curve.piece_count()).map(|piece| piece_teeth(curve, piece, spacing, varying)));
    }
    let Some(common) = common_curvature(&pieces) else {
        return Vec::new();
    };
    let scale = TOOTH * size / common;
    let longest = LONGEST * TOOTH * size;
    let tip = |p: Point3, k: Vec3| {
        let length = k.length() * scale;
        p - k * (scale * if length > longest { longest / length } else { 1.0 })
    };
    let visible = |comb: &Comb| comb.iter().any(|(foot, tip)| foot.distance(*tip) > 1e-3 * size);
    let piece = |teeth: Vec<Tooth>| teeth.into_iter().map(|(p, k, _)| (p, tip(p, k))).collect();
    pieces.into_iter().map(piece).filter(visible).collect()
}

/// The curvature below which [`COMMON`] of the bent length lies; `None` if nothing is bent.
fn common_curvature(pieces: &[Vec<Tooth>]) -> Option<f64> {
    let bent = pieces.iter().flatten().map(|(_, k, length)| (k.length(), *length)).filter(|(k, _)| *k > 0.0);
    let mut bent: Vec<(f64, f64)> = bent.collect();
    bent.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = bent.iter().map(|(_, length)| length).sum();
    let mut sum = 0.0;
    let found = bent.iter().find(|(_, length)| {
        sum += length;
        sum >= COMMON * total
    });
    found.or(bent.last()).map(|(k, _)| *k)
}

/// A tooth before it has a length: foot, curvature vector, and the length of curve that it stands for.
type Tooth = (Point3, Vec3, f64);

/// The teeth of a piece, evenly about `spacing` apart or closer where it bends sharply.
fn piece_teeth(curve: &dyn ParamCurve, piece: usize, spacing: f64, varying: bool) -> Vec<Tooth> {
    let length = curve.piece_length(piece, 0.0, 1.0);
    let turn = length * curve.piece_jet(piece, 0.5).curvature().unwrap_or(0.0);
    let least = if varying { VARYING.min(length * SPACING / (spacing * CLOSEST)) } else { 1.0 };
    let count = (length / spacing).max((turn / TURN).min(100.0)).max(least).round().clamp(1.0, TEETH);
    let jets = even_parameters(curve, piece, count as usize).into_iter().map(|s| curve.piece_jet(piece, s));
    let tooth = |j: CurveJet| j.curvature_vector().filter(|k| k.is_finite()).map(|k| (j.point, k, length / count));
    jets.filter_map(tooth).collect()
}

/// True if the curvature of a piece is not the same all along, as far as a drawing shows it.
fn varies(curve: &dyn ParamCurve, piece: usize) -> bool {
    let at = |s: f64| curve.piece_jet(piece, s).curvature_vector().map_or(0.0, Vec3::length);
    let middle = at(0.5);
    [0.0, 0.25, 0.75, 1.0].into_iter().any(|s| (at(s) - middle).abs() > 0.01 * middle)
}

/// Parameters of a piece that cut it into `count` parts of about equal length (by chords: a drawing needs no more).
fn even_parameters(curve: &dyn ParamCurve, piece: usize, count: usize) -> Vec<f64> {
    let n = 4 * count.max(4);
    let at = |i: usize| curve.piece_point(piece, i as f64 / n as f64);
    let mut sums = vec![0.0; n + 1];
    let mut last = at(0);
    for i in 1..=n {
        let next = at(i);
        sums[i] = sums[i - 1] + last.distance(next);
        last = next;
    }
    let parameter = |k: usize| {
        let wanted = sums[n] * k as f64 / count as f64;
        let i = sums.partition_point(|l| *l < wanted).clamp(1, n);
        let part = sums[i] - sums[i - 1];
        let inside = if part > 0.0 { ((wanted - sums[i - 1]) / part).clamp(0.0, 1.0) } else { 0.0 };
        ((i - 1) as f64 + inside) / n as f64
    };
    (0..=count).map(parameter).collect()
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
    (0.3 * typical_gap(joints).unwrap_or(size)).clamp(0.0014 * size, 0.003 * size)
}

/// The middle one of the distances between consecutive joints.
pub(crate) fn typical_gap(joints: &[Point3]) -> Option<f64> {
    let mut gaps: Vec<f64> = joints.windows(2).map(|w| w[0].distance(w[1])).filter(|g| *g > 0.0).collect();
    gaps.sort_by(f64::total_cmp);
    gaps.get(gaps.len() / 2).copied()
}
