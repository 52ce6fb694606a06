//! Where to cut: densities from the sagitta in closed form, then as many cuts as the certificate asks for.

use super::density::Density;
use super::strips::{Member, Place, Strip, Strips};
use crate::error::{Error, NumberError, Result};
use crate::topology::{FaceGeometry as _, FaceSurface, LineBends, Shell};

/// Intervals on which densities are sampled.
const SCAN: usize = 16;
/// Times the densities of all strips are adapted to each other.
const SWEEPS: usize = 2;
/// Rounds of the certificate; few are needed, as cells that fail are divided by what they fail by.
const ROUNDS: usize = 200;
/// Cells that are looked at in all rounds together, in units of the cap: a mesh that grows by little from round to round is
/// given up when it has cost as much as a few of the largest, or of this many cells.
const WORK: f64 = 4.0;
const LEAST_WORK: usize = 1_000_000;
/// Largest number of cuts of a part of a strip that is counted as such.
const MOST_CUTS: f64 = 1e9;
/// A little more cuts than a cell fails by, as its neighbors are wider or narrower.
const MARGIN: f64 = 1.002;
/// Largest number of parts of one cell in one round.
const SPLIT: f64 = 8.0;

/// The sample with the given index.
fn at(k: usize) -> f64 {
    k as f64 / SCAN as f64
}

/// How a face bends, on the grid of samples.
struct Samples(Box<LineBends>);

impl Samples {
    /// The samples of a face that one cell does not do for. Others ask for no cuts, and in a net of many small patches
    /// these are all: what is sampled here is larger than what belongs to a face otherwise.
    fn of_bent(surface: &FaceSurface, tolerance: f64) -> Option<Self> {
        let found = surface.cell_distances(&[0.0, 1.0], &[0.0, 1.0], tolerance);
        let one_does = found.distance <= tolerance && found.excess.iter().flatten().all(|&excess| excess <= 1.0);
        let places: [f64; SCAN + 1] = std::array::from_fn(at);
        (!one_does).then(|| Self(Box::new(surface.line_bends(&places))))
    }

    /// Curvature of the sagitta along the direction, that across it, and the cosine of their bulges at a sample: `along`
    /// counts along the direction.
    fn bends(&self, direction: usize, along: usize, across: usize) -> (f64, f64, f64) {
        let (i, j) = if direction == 0 { (along, across) } else { (across, along) };
        let (sagittas, cosine) = self.0.at(i, j).unwrap_or(([f64::NAN; 2], 1.0));
        (sagittas[direction], sagittas[1 - direction], cosine)
    }
}

/// The density of cuts of one strip, with its rounding to whole numbers of cuts.
struct StripDensity {
    values: [f64; SCAN + 1],
    /// Widths of the cells there.
    widths: [f64; SCAN + 1],
    /// Parts between fixed places: the ends, the integral of the density, the number of cells.
    parts: Vec<([f64; 2], f64, usize)>,
}

impl StripDensity {
    fn new(values: [f64; SCAN + 1], fixed: &[f64]) -> Self {
        let parts = fixed.windows(2).map(|w| ([w[0], w[1]], Density(&values).integral([w[0], w[1]])));
        let parts: Vec<([f64; 2], f64, usize)> =
            parts.map(|(ends, integral)| (ends, integral, count(integral))).collect();
        let widths = std::array::from_fn(|k| {
            let part = parts.iter().find(|(ends, ..)| at(k) <= ends[1]);
            part.map_or(1.0, |&([a, b], integral, n)| {
                let width = integral / (n as f64 * values[k]);
                // Nothing bends: the cells are even.
                if width.is_finite() { width.min(b - a) } else { (b - a) / n as f64 }
            })
        });
        Self { values, widths, parts }
    }

    /// All cuts, ends included.
    fn cuts(&self, strip: &Strip) -> Vec<f64> {
        let mut cuts = vec![0.0];
        for &(ends, _, n) in self.parts.iter().filter(|(ends, ..)| !strip.symmetric || ends[0] < 0.5) {
            Density(&self.values).cut(ends, n, &mut cuts, |a, b| strip.apart(a, b));
            cuts.push(ends[1]);
        }
        if strip.symmetric { mirrored(cuts) } else { cuts }
    }
}

/// Cuts of the first half and their mirror images.
fn mirrored(mut cuts: Vec<f64>) -> Vec<f64> {
    let other: Vec<f64> = cuts.iter().rev().skip(1).map(|u| 1.0 - u).collect();
    cuts.extend(other);
    cuts
}

/// New cuts of a strip, `excess[k]` times as many where cell `k` failed. Between fixed places the cells share their
/// excesses equally, so all grow narrower if one fails, and there is one more at least.
fn refined(old: &[f64], excess: &[f64], strip: &Strip) -> Vec<f64> {
    let mut cuts = vec![0.0];
    let last = if strip.symmetric { 0.5 } else { 1.0 };
    let mut first = 0;
    for end in strip.fixed.iter().copied().filter(|&u| u > 0.0 && u <= last) {
        let count = old[first..].iter().position(|&u| u >= end).unwrap_or(old.len() - 1 - first);
        let part = first..first + count;
        let needs = part.clone().map(|k| {
            let mirror = if strip.symmetric { excess[excess.len() - 1 - k] } else { 0.0 };
            let excess = excess[k].max(mirror);
            if excess > 1.0 { (excess * MARGIN).min(SPLIT) } else { 1.0 }
        });
        let needs: Vec<f64> = needs.collect();
        let total: f64 = needs.iter().sum();
        let cells = total.ceil();
        let (mut k, mut before) = (0, 0.0);
        for j in 1..cells as usize {
            let goal = total * j as f64 / cells;
            while k + 1 < needs.len() && before + needs[k] < goal {
                before += needs[k];
                k += 1;
            }
            let (a, b) = (old[first + k], old[first + k + 1]);
            let place = a + (b - a) * ((goal - before) / needs[k]).min(1.0);
            if strip.apart(cuts.last().copied().unwrap_or(0.0), place) && strip.apart(place, end) {
                cuts.push(place);
            }
        }
        cuts.push(end);
        first = part.end;
    }
    if strip.symmetric { mirrored(cuts) } else { cuts }
}

/// Whole number of cells of an integral of a density; it is below the cap where it is used.
fn count(integral: f64) -> usize {
    // Rounding of the integral must not add a cell.
    ((integral * (1.0 - 1e-12)).ceil().clamp(1.0, MOST_CUTS) as usize).max(1)
}

/// The cap on cells of a mesh.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cap {
    /// Largest number of cells.
    pub(super) most: usize,
    /// How many the mesh has already.
    pub(super) before: usize,
}

impl Cap {
    fn refused(self, needed: f64) -> Error {
        Error::Number(NumberError::TooManyPieces {
            what: "the mesh",
            segment: None,
            needed: needed + self.before as f64,
            cap: self.most,
            remedy: "use a larger tolerance or allow more",
        })
    }

    /// Refuses more cells than are left, for the given number of cells along each strip.
    fn check(self, strips: &Strips, count: impl Fn(usize) -> f64) -> Result<f64> {
        let needed: f64 = strips.faces.iter().map(|[s, t]| count(s.strip) * count(t.strip)).sum();
        // Not `>`: what is no number is not allowed either.
        if needed <= self.most.saturating_sub(self.before) as f64 { Ok(needed) } else { Err(self.refused(needed)) }
    }
}

/// The cuts of every strip of a shell, and the certified distance of the mesh.
pub(super) struct Cuts {
    of_strips: Vec<Vec<f64>>,
    /// The certified distance of every cell.
    pub(super) distance: f64,
}

impl Cuts {
    /// The number of cells along a place.
    pub(super) fn count(&self, place: Place) -> usize {
        self.of_strips[place.strip].len() - 1
    }

    /// The cuts at a place, as its own parameter runs.
    pub(super) fn at(&self, place: Place) -> Vec<f64> {
        let cuts = &self.of_strips[place.strip];
        if place.flipped { cuts.iter().rev().map(|u| 1.0 - u).collect() } else { cuts.clone() }
    }

    /// Cuts of every strip so that no cell is farther than `tolerance` from its quad.
    ///
    /// Cells cost the least when the deviation is the same everywhere. A cut in one direction costs as much as one in
    /// the other, so both get equal shares of the tolerance at first; then each strip takes what the other leaves at
    /// every place.
    pub(super) fn new(shell: &Shell, strips: &Strips, tolerance: f64, cap: Cap) -> Result<Self> {
        let densities = densities(shell, strips, tolerance);
        cap.check(strips, |strip| densities[strip].parts.iter().map(|&(_, integral, n)| integral.max(n as f64)).sum())?;
        let all = densities.iter().zip(&strips.strips);
        let mut cuts = Self { of_strips: all.map(|(d, strip)| d.cuts(strip)).collect(), distance: 0.0 };
        let mut work = 0.0;
        for _ in 0..ROUNDS {
            let cells = cap.check(strips, |strip| (cuts.of_strips[strip].len() - 1) as f64)?;
            work += cells;
            if work > WORK * cap.most.max(LEAST_WORK) as f64 {
                break;
            }
            let excess = cuts.certify(shell, strips, tolerance);
            let mut done = true;
            for ((cuts, excess), strip) in cuts.of_strips.iter_mut().zip(&excess).zip(&strips.strips) {
                if excess.iter().any(|&e| e > 1.0) {
                    *cuts = refined(cuts, excess, strip);
                    done = false;
                }
            }
            if done {
                return Ok(cuts);
            }
        }
        Err(cap.refused(f64::INFINITY))
    }

    /// Certifies the mesh of these cuts: how many times as many cuts the cells of each strip need.
    fn certify(&mut self, shell: &Shell, strips: &Strips, tolerance: f64) -> Vec<Vec<f64>> {
        let mut excess: Vec<Vec<f64>> = self.of_strips.iter().map(|cuts| vec![0.0; cuts.len() - 1]).collect();
        self.distance = 0.0;
        for (f, face) in shell.faces().iter().enumerate() {
            let [s, t] = strips.faces[f].map(|place| self.at(place));
            let found = face.surface.cell_distances(&s, &t, tolerance);
            self.distance = self.distance.max(found.distance);
            for (place, own) in strips.faces[f].iter().zip(found.excess) {
                let of_strip = &mut excess[place.strip];
                let last = own.len() - 1;
                for (k, e) in own.into_iter().enumerate() {
                    let worst = &mut of_strip[if place.flipped { last - k } else { k }];
                    *worst = worst.max(e);
                }
            }
        }
        excess
    }
}

/// The densities of all strips.
fn densities(shell: &Shell, strips: &Strips, tolerance: f64) -> Vec<StripDensity> {
    let samples: Vec<Option<Samples>> =
        shell.faces().iter().map(|face| Samples::of_bent(&face.surface, tolerance)).collect();
    // Equal shares: a = b with a² + b² + 2abc = tolerance².
    let equal = |_: Member, _: usize, _: f64, c: f64| tolerance / (2.0 + 2.0 * c).sqrt().max(1.0);
    let mut densities: Vec<StripDensity> =
        (0..strips.strips.len()).map(|k| density(strips, k, &samples, equal)).collect();
    for _ in 0..SWEEPS {
        for k in 0..densities.len() {
            // What the cells of the crossing strips leave, and a tenth at least: they give way in their turn.
            let left = |member: Member, across: usize, other: f64, c: f64| {
                let crossing = strips.faces[member.face][1 - member.direction];
                let width = densities[crossing.strip].widths[if crossing.flipped { SCAN - across } else { across }];
                let b = other * width * width;
                let root = (tolerance * tolerance - b * b * (1.0 - c * c)).max(0.0).sqrt();
                (root - b * c).clamp(0.1 * tolerance, tolerance)
            };
            densities[k] = density(strips, k, &samples, left);
        }
    }
    densities
}

/// The density of one strip: at each place the largest of its members, whose share of the tolerance is `share(member,
/// across, bend across, cosine)`.
fn density(
    strips: &Strips,
    strip: usize,
    samples: &[Option<Samples>],
    share: impl Fn(Member, usize, f64, f64) -> f64,
) -> StripDensity {
    let mut values = [0.0_f64; SCAN + 1];
    let strip = &strips.strips[strip];
    for &member in &strip.members {
        let Some(samples) = &samples[member.face] else { continue };
        for (along, value) in values.iter_mut().enumerate() {
            let own = if member.flipped { SCAN - along } else { along };
            for across in 0..=SCAN {
                let (bend, other, c) = samples.bends(member.direction, own, across);
                *value = value.max((bend / share(member, across, other, c)).sqrt());
            }
        }
    }
    if strip.symmetric {
        let mirrored: [f64; SCAN + 1] = std::array::from_fn(|k| values[SCAN - k]);
        values = std::array::from_fn(|k| values[k].max(mirrored[k]));
    }
    StripDensity::new(values, &strip.fixed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::DupinCyclide;

    /// Patches that one cell does for each ask for nothing; of a larger one all that is needed is known.
    #[test]
    fn only_patches_that_bend_are_sampled() {
        let ring = DupinCyclide::new(2.0, 0.5, 1.0).unwrap();
        for (segments, tolerance, sampled) in [(60, 2e-2, false), (60, 1e-6, true)] {
            let shell = ring.to_bodies([segments; 2]).unwrap().remove(0).outer;
            let samples = shell.faces().iter().map(|face| Samples::of_bent(&face.surface, tolerance));
            assert!(samples.into_iter().all(|samples| samples.is_some() == sampled));
            let cap = Cap { most: usize::MAX, before: 0 };
            let strips = Strips::new(&shell);
            let cuts = Cuts::new(&shell, &strips, tolerance, cap).unwrap();
            let counts = strips.faces.iter().flatten().map(|&place| cuts.count(place));
            assert!(counts.into_iter().all(|count| (count == 1) != sampled));
            assert!(cuts.distance <= tolerance);
        }
    }

    /// Of a strip that meets itself the other way round a cell and its mirror image are one: where either fails both are divided.
    #[test]
    fn cells_are_divided_with_their_mirror_images() {
        let old = [0.0, 0.25, 0.5, 0.75, 1.0];
        let strip = Strip { fixed: vec![0.0, 0.5, 1.0], symmetric: true, reversed: true, ..Strip::default() };
        for (excess, [outer, inner]) in [
            ([4.0, 0.0, 0.0, 0.0], [4, 1]),
            ([0.0, 0.0, 0.0, 4.0], [4, 1]),
            ([0.0, 4.0, 0.0, 0.0], [1, 4]),
            ([0.0, 0.0, 4.0, 0.0], [1, 4]),
        ] {
            let cuts = refined(&old, &excess, &strip);
            let cells = |a: f64, b: f64| cuts.windows(2).filter(|w| w[1] > a && w[0] < b).count();
            assert!(cells(0.0, 0.2) >= outer && cells(0.3, 0.5) >= inner, "{excess:?}: {cuts:?}");
            assert!(cells(0.0, 0.5) <= 6, "{excess:?}: no more than needed: {cuts:?}");
            assert!(cuts.iter().zip(cuts.iter().rev()).all(|(a, b)| (a + b - 1.0).abs() < 1e-15), "{cuts:?}");
        }
    }

    #[test]
    fn cuts_stay_apart_from_either_end() {
        // Below the rounding of 1: from the other end both ends of a part of the first cell are 1.
        let old = [0.0, 3e-16, 1.0];
        for reversed in [false, true] {
            let strip = Strip { fixed: vec![0.0, 1.0], reversed, ..Strip::default() };
            let cuts = Cuts { of_strips: vec![refined(&old, &[8.0, 1.0], &strip)], distance: 0.0 };
            for flipped in [false, reversed] {
                let cuts = cuts.at(Place { strip: 0, flipped });
                assert!(cuts.len() > 3 && cuts.windows(2).all(|w| w[0] < w[1]), "{flipped}: {cuts:?}");
            }
        }
    }
}
