//! The curvature comb: teeth along each curve, as long as its curvature, and the line over their tips.
//!
//! The line over the tips follows the curvature between the teeth too, to a third of a pixel, so that it shows what
//! happens between the points of a dense curve. Each piece of varying curvature has eight teeth or more. A drawing of
//! so many pieces that this would be a solid area (more than [`MOST`] samples) is thinned: of the samples within a
//! cell as large as a pixel, those of the largest and the least curvature stay.
//!
//! Objects that bend alike (within a factor of [`ALIKE`]) share one scale: equal curvatures have equal teeth. Small and
//! large ones have scales of their own, so that the bends of both show, and the drawing says so. Combs are made shorter,
//! all of a scale together, until they leave the other curves and combs alone ([`Room`]); one that cannot is left out, and
//! the drawing names it.

use super::room::{Room, Taken};
use super::{Comb, CombStrip, Combs, Tip, even_parameters};
use crate::export::job::Job;
use crate::export::parts::Contour;
use cyclide::{
    Point3, Vec3,
    curve::{ParamCurve, extreme_curvature, length},
};

/// Distance of the teeth relative to the drawing, and the largest turn between two of them in radians.
const SPACING: f64 = 0.008;
const TURN: f64 = 0.15;
/// Teeth of a piece at least, if its curvature varies.
const LEAST: f64 = 8.0;
/// Samples of one drawing above which combs are thinned.
const MOST: usize = 60_000;
/// The cells of thinning, relative to the drawing.
const CELL: f64 = 1.0 / 1600.0;
/// Length of the tooth at the curvature below which [`COMMON`] of the bent length lies, relative to the drawing and to
/// the object.
const TOOTH: f64 = 0.055;
const OWN_TOOTH: f64 = 0.2;
/// Combs in space are seen at a slant and across each other: shorter ones.
const IN_SPACE: f64 = 0.6;
/// Sharp bends, the rest, must not shrink the whole comb; their teeth are cut at [`LONGEST`] times the common one.
const COMMON: f64 = 0.9;
const LONGEST: f64 = 2.5;
/// What the line over the tips may miss, relative to the drawing, and how often an interval is halved for it.
const FLATNESS: f64 = 0.3 / 1600.0;
const DEPTH: u32 = 6;
/// Objects whose own scales differ by at most this factor share one.
const ALIKE: f64 = 3.0;
/// How much combs may be made shorter to leave room, and the part of their teeth that may still be in the way.
const SHORTER: [f64; 5] = [1.0, 0.7, 0.5, 0.35, 0.25];
const IN_THE_WAY: f64 = 0.03;
/// Pieces of a curve above which the largest curvature is that of the samples.
const MANY: usize = 20_000;

/// The combs of all objects; straight pieces have none. `size` is the extent of the drawing, `right` and `up` its axes.
pub(crate) fn combs(job: &Job<'_>, size: f64, [right, up]: [Vec3; 2]) -> Combs {
    let heights = right.cross(up) != Vec3::Z || job.bounds.max.z - job.bounds.min.z > 1e-6 * size;
    let contours: Vec<Contour<'_>> = job.contours().collect();
    let total: f64 = contours.iter().map(|c| length(c.curve.as_curve())).sum();
    let mut room = Room::new(size, [right, up]);
    let mut sampled: Vec<Vec<Strip>> = Vec::new();
    for (index, contour) in contours.iter().enumerate() {
        let strips = sample(contour.curve.as_curve(), SPACING * size);
        let feet = strips.iter().flatten().map(|tooth| tooth.foot);
        room.add_curve(index, feet);
        sampled.push(strips);
    }
    let count: usize = sampled.iter().flatten().map(Vec::len).sum();
    let thin = (count > MOST).then(|| (CELL * size).max(total / MOST as f64));
    let factor = if heights { IN_SPACE } else { 1.0 };
    let mut bent: Vec<Bent<'_>> = Vec::new();
    let mut first = 0;
    while first < contours.len() {
        let item = contours[first].item;
        let last = first + contours[first..].iter().take_while(|c| c.item == item).count();
        let own = &sampled[first..last];
        if let Some(common) = common_curvature(own) {
            let tooth = (TOOTH * size).min(OWN_TOOTH * extent(own)) * factor;
            let scale = Scale { per_curvature: tooth / common, longest: LONGEST * tooth, flatness: FLATNESS * size };
            bent.push(Bent { item, first, own, scale });
        }
        first = last;
    }
    let mut scales = vec![None; bent.len()];
    for group in alike(&mut bent) {
        for (index, scale) in group.iter().zip(fitted(&group.iter().map(|i| &bent[*i]).collect::<Vec<_>>(), &mut room))
        {
            scales[*index] = scale;
        }
    }
    let mut found = Combs::default();
    for (object, scale) in bent.iter().zip(scales) {
        let own = &contours[object.first..object.first + object.own.len()];
        match scale {
            Some(scale) => found.drawn.push(drawn(object.item, own, object.own, scale, thin)),
            None => found.left_out.push(object.item),
        }
    }
    found
}

/// An object that is bent: its contours from `first` on, and the scale its comb would have.
struct Bent<'a> {
    item: usize,
    first: usize,
    own: &'a [Vec<Strip>],
    scale: Scale,
}

/// The objects in groups that bend alike, each in the order of the model, with one scale: the least of theirs.
fn alike(bent: &mut [Bent<'_>]) -> Vec<Vec<usize>> {
    let mut order: Vec<usize> = (0..bent.len()).collect();
    order.sort_by(|a, b| bent[*a].scale.per_curvature.total_cmp(&bent[*b].scale.per_curvature));
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for index in order {
        let per_curvature = bent[index].scale.per_curvature;
        match groups.last_mut() {
            Some(group) if per_curvature <= ALIKE * bent[group[0]].scale.per_curvature => group.push(index),
            _ => groups.push(vec![index]),
        }
    }
    for group in &mut groups {
        let least = bent[group[0]].scale.per_curvature;
        let longest = group.iter().map(|i| bent[*i].scale.longest).fold(0.0, f64::max);
        group.iter().for_each(|i| (bent[*i].scale.per_curvature, bent[*i].scale.longest) = (least, longest));
        group.sort_unstable();
    }
    groups.sort_by_key(|group| group[0]);
    groups
}

/// A tooth before it has a length.
#[derive(Debug, Clone, Copy)]
struct Tooth {
    piece: usize,
    s: f64,
    foot: Point3,
    curvature: Vec3,
    /// The length of curve that it stands for.
    share: f64,
}

/// The teeth of one smooth piece.
type Strip = Vec<Tooth>;

/// From curvature to teeth.
#[derive(Debug, Clone, Copy)]
struct Scale {
    per_curvature: f64,
    longest: f64,
    flatness: f64,
}

impl Scale {
    fn tip(&self, tooth: &Tooth) -> Point3 {
        let length = tooth.curvature.length() * self.per_curvature;
        let cut = if length > self.longest { self.longest / length } else { 1.0 };
        tooth.foot - tooth.curvature * (self.per_curvature * cut)
    }
}

/// The teeth of every piece of a curve, about `spacing` apart, closer where it bends sharply.
fn sample(curve: &dyn ParamCurve, spacing: f64) -> Vec<Strip> {
    let n = curve.piece_count();
    // Many pieces are short ones: what they need is looked at once.
    let dense = n > MOST / 4;
    let piece = |piece: usize| -> Strip {
        let length = curve.piece_length(piece, 0.0, 1.0);
        let turn = length * curve.piece_jet(piece, 0.5).curvature().unwrap_or(0.0);
        let least = if varies(curve, piece) { LEAST } else { 1.0 };
        let wanted = (length / spacing).max((turn / TURN).min(100.0)).max(least);
        let count = wanted.ceil().clamp(1.0, if dense { LEAST } else { 1e4 });
        let parameters = match dense {
            true => (0..=count as usize).map(|i| i as f64 / count).collect(),
            false => even_parameters(curve, piece, count as usize),
        };
        parameters.into_iter().filter_map(|s| tooth(curve, piece, s, length / count)).collect()
    };
    (0..n).map(piece).filter(|strip| !strip.is_empty()).collect()
}

fn tooth(curve: &dyn ParamCurve, piece: usize, s: f64, share: f64) -> Option<Tooth> {
    let jet = curve.piece_jet(piece, s);
    let curvature = jet.curvature_vector().filter(|k| k.is_finite())?;
    Some(Tooth { piece, s, foot: jet.point, curvature, share })
}

/// True if the curvature of a piece is not the same all along, as far as a drawing shows it.
fn varies(curve: &dyn ParamCurve, piece: usize) -> bool {
    let at = |s: f64| curve.piece_jet(piece, s).curvature_vector().map_or(0.0, Vec3::length);
    let middle = at(0.5);
    [0.0, 0.25, 0.75, 1.0].into_iter().any(|s| (at(s) - middle).abs() > 0.01 * middle)
}

/// The curvature below which [`COMMON`] of the bent length lies; `None` if nothing is bent.
fn common_curvature(own: &[Vec<Strip>]) -> Option<f64> {
    let bent = own.iter().flatten().flatten().map(|t| (t.curvature.length(), t.share)).filter(|(k, _)| *k > 0.0);
    let mut bent: Vec<(f64, f64)> = bent.collect();
    bent.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = bent.iter().map(|(_, length)| length).sum();
    let mut sum = 0.0;
    let found = bent.iter().find(|(_, length)| {
        sum += length;
        sum >= COMMON * total
    });
    // What is straight up to rounding has no comb.
    found.or(bent.last()).map(|(k, _)| *k).filter(|k| *k * extent(own) > 1e-6)
}

fn extent(own: &[Vec<Strip>]) -> f64 {
    let feet = own.iter().flatten().flatten().map(|t| t.foot);
    cyclide::Aabb::of_points(feet).map_or(0.0, |b| b.diagonal())
}

impl Scale {
    fn shorter(self, factor: f64) -> Self {
        Self { per_curvature: self.per_curvature * factor, longest: self.longest * factor, ..self }
    }
}

impl Bent<'_> {
    /// The cells that the comb takes at a scale, if it leaves the others alone.
    fn taken(&self, scale: Scale, curves_too: bool, room: &Room) -> Option<Taken> {
        let mut trial = room.trial(curves_too);
        for (k, strips) in self.own.iter().enumerate() {
            for tooth in strips.iter().flatten() {
                trial.add(self.first + k, tooth.foot, scale.tip(tooth));
            }
        }
        let (share, taken) = trial.finish();
        (share <= IN_THE_WAY).then_some(taken)
    }
}

/// The ways to make room: first clear of all curves; where those are too near, at least clear of the other combs.
fn ways() -> impl Iterator<Item = (bool, f64)> {
    [true, false].into_iter().flat_map(|curves_too| SHORTER.into_iter().map(move |factor| (curves_too, factor)))
}

/// The largest scale at which the most combs of a group leave the others and each other alone, `None` for those that do
/// not; the combs are then taken into account for what follows.
fn fitted(group: &[&Bent<'_>], room: &mut Room) -> Vec<Option<Scale>> {
    let mut best: (usize, Vec<Option<Scale>>, Room) = (0, vec![None; group.len()], room.clone());
    for (curves_too, factor) in ways() {
        let mut trial = room.clone();
        let fits = |object: &&Bent<'_>| {
            let scale = object.scale.shorter(factor);
            let taken = object.taken(scale, curves_too, &trial)?;
            trial.keep(taken);
            Some(scale)
        };
        let scales: Vec<Option<Scale>> = group.iter().map(fits).collect();
        let count = scales.iter().flatten().count();
        if count > best.0 {
            best = (count, scales, trial);
        }
        if count == group.len() {
            break;
        }
    }
    *room = best.2;
    best.1
}

fn drawn(item: usize, contours: &[Contour<'_>], own: &[Vec<Strip>], scale: Scale, thin: Option<f64>) -> Comb {
    let mut strips = Vec::new();
    for (contour, own) in contours.iter().zip(own) {
        match thin {
            Some(cell) => strips.extend(thinned(own, scale, cell)),
            None => strips.extend(own.iter().map(|strip| refined(contour.curve.as_curve(), strip, scale))),
        }
    }
    let visible = |strip: &CombStrip| strip.tips.iter().any(|t| t.foot.distance(t.tip) > 2.0 * scale.flatness);
    strips.retain(visible);
    let pieces: usize = contours.iter().map(|c| c.curve.as_curve().piece_count()).sum();
    let largest = if pieces > MANY {
        own.iter().flatten().flatten().map(|t| t.curvature.length()).fold(0.0, f64::max)
    } else {
        contours.iter().map(|c| extreme_curvature(c.curve.as_curve()).max).fold(0.0, f64::max)
    };
    Comb { item, largest, scale: scale.per_curvature, is_cut: largest * scale.per_curvature > scale.longest, strips }
}

/// The teeth of a piece, and tips between them wherever the line over them would miss some.
fn refined(curve: &dyn ParamCurve, strip: &[Tooth], scale: Scale) -> CombStrip {
    let mut tips = Vec::with_capacity(strip.len());
    let as_tip = |t: &Tooth, is_tooth: bool| Tip { foot: t.foot, tip: scale.tip(t), is_tooth };
    tips.extend(strip.first().map(|t| as_tip(t, true)));
    for pair in strip.windows(2) {
        let mut open = vec![(pair[0], pair[1], DEPTH)];
        while let Some((a, b, depth)) = open.pop() {
            let middle = tooth(curve, a.piece, 0.5 * (a.s + b.s), 0.0);
            let missed = |m: &Tooth| scale.tip(m).distance(scale.tip(&a).midpoint(scale.tip(&b))) > scale.flatness;
            match middle.filter(|m| depth > 0 && missed(m)) {
                Some(m) => open.extend([(m, b, depth - 1), (a, m, depth - 1)]),
                None => tips.push(as_tip(&b, b.share > 0.0)),
            }
        }
    }
    CombStrip { tips }
}

/// One strip for all pieces of a curve: in each cell the first sample and those of the largest and the least tooth on
/// either side of the curve.
fn thinned(own: &[Strip], scale: Scale, cell: f64) -> Option<CombStrip> {
    let mut tips: Vec<Tip> = Vec::new();
    let mut group: Vec<&Tooth> = Vec::new();
    let mut flush = |group: &mut Vec<&Tooth>| {
        let Some(first) = group.first() else {
            return;
        };
        let side = |t: &Tooth| t.curvature.dot(first.curvature).signum() * t.curvature.length();
        let by_side = |a: &usize, b: &usize| side(group[*a]).total_cmp(&side(group[*b]));
        let least = (0..group.len()).min_by(by_side).unwrap_or(0);
        let most = (0..group.len()).max_by(by_side).unwrap_or(0);
        let mut kept = [0, least, most];
        kept.sort_unstable();
        for (i, index) in kept.into_iter().enumerate() {
            if i == 0 || kept[i - 1] != index {
                let t = group[index];
                tips.push(Tip { foot: t.foot, tip: scale.tip(t), is_tooth: index == most });
            }
        }
        group.clear();
    };
    for tooth in own.iter().flatten() {
        if group.first().is_some_and(|first| first.foot.distance(tooth.foot) > cell) {
            flush(&mut group);
        }
        group.push(tooth);
    }
    flush(&mut group);
    (!tips.is_empty()).then_some(CombStrip { tips })
}
