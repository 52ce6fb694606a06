//! What drawings and pictures show: which lines of a surface, in which colors, and beside the curves their curvature combs
//! and joints.

pub(crate) mod block_directions;
#[cfg(feature = "png")]
pub(crate) mod colour_map;
mod comb;
#[cfg(feature = "png")]
pub(crate) mod cut_away;
#[cfg(feature = "png")]
mod lattice;
pub(crate) mod palette;
pub(crate) mod parameter_circles;
pub(crate) mod patch_edges;
pub(crate) mod plane_regions;
mod room;
#[cfg(feature = "png")]
pub(crate) mod surface_distance;
#[cfg(feature = "png")]
pub(crate) mod value_scale;

use crate::export::job::Job;
use cyclide::{Point3, curve::ParamCurve};

pub(crate) use comb::combs;

/// The combs of a drawing.
#[derive(Debug, Default)]
pub(crate) struct Combs {
    /// One for each object that is bent and has room for it.
    pub(crate) drawn: Vec<Comb>,
    /// Objects, by their index in the model, without room for theirs.
    pub(crate) left_out: Vec<usize>,
}

#[cfg_attr(not(feature = "png"), allow(dead_code, reason = "pictures name the combs; drawings draw them"))]
/// The comb of an object, to one scale.
#[derive(Debug)]
pub(crate) struct Comb {
    /// Index of the object in the model.
    pub(crate) item: usize,
    /// The largest curvature among its teeth.
    pub(crate) largest: f64,
    /// Length of a tooth times radius of curvature.
    pub(crate) scale: f64,
    /// The longest teeth are cut: some bends are much sharper than most.
    pub(crate) is_cut: bool,
    /// One for each smooth piece that is bent, or one for all.
    pub(crate) strips: Vec<CombStrip>,
}

/// Feet and tips along the curve.
#[derive(Debug)]
pub(crate) struct CombStrip {
    pub(crate) tips: Vec<Tip>,
}

/// A place of a comb.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tip {
    /// The place on the curve.
    pub(crate) foot: Point3,
    /// The place on the line over the teeth.
    pub(crate) tip: Point3,
    /// A tooth is drawn here.
    pub(crate) is_tooth: bool,
}

impl Combs {
    /// A note on the objects whose combs are left out, by their names.
    pub(crate) fn left_out_note<'a>(&self, name: impl Fn(usize) -> &'a str) -> Option<String> {
        let names: Vec<&str> = self.left_out.iter().map(|&index| name(index)).collect();
        (!names.is_empty()).then(|| {
            format!(
                "combs that would overlap others are omitted: {} (a picture of one object alone shows its comb)",
                names.join(", ")
            )
        })
    }

    /// True if equal curvatures have equal teeth throughout.
    pub(crate) fn have_one_scale(&self) -> bool {
        self.drawn.windows(2).all(|pair| pair[0].scale.total_cmp(&pair[1].scale).is_eq())
    }

    /// All tips.
    pub(crate) fn tips(&self) -> impl Iterator<Item = Point3> {
        self.drawn.iter().flat_map(|comb| &comb.strips).flat_map(|strip| &strip.tips).map(|t| t.tip)
    }
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

/// Where the smooth pieces of the curves meet, the ends of open curves, and the points in between that they were laid through.
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
    joints.extend(job.provenances.nodes());
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
