//! Coordinates in which umbilics lie whole steps apart: the lattice then goes on over the slits, and through every umbilic.

use super::super::coordinates::{Coordinates, Tie, Weights, solved};
use super::super::mesh_table::NONE;
use super::super::passages::{Passage, Passages};
use super::super::sheet::Sheet;
use super::super::unknowns::Unknowns;
use super::slits::Slit;

/// Differences nearer than this to a whole number of steps are rounded together, and so is this part of all at least.
const NEAR: f64 = 0.1;
const AT_ONCE: f64 = 0.25;
/// Coordinates that run more slowly than this against arc length, in the mean, have failed.
const SLOWEST: f64 = 0.05;
/// How often folded triangles are spread, and how much more each time: what spreads more is aligned less.
const UNFOLDED: usize = 2;
const STIFFER: f64 = 2.0;

/// The coordinates, the steps along both, and how they go on over the slits.
pub(super) struct Rounded {
    pub(super) coordinates: Coordinates,
    pub(super) steps: [f64; 2],
    /// Of the umbilic of each slit.
    pub(super) centres: Vec<[f64; 2]>,
    pub(super) passages: Passages,
}

/// The corner after a half edge's start round its triangle.
fn end(half: usize) -> usize {
    half - half % 3 + (half + 1) % 3
}

/// The unknowns: on the left of a slit coordinates are those on the right turned by half a turn about the umbilic. With the unknowns of
/// the umbilics.
fn unknowns(sheet: &Sheet<'_>, slits: &[Slit]) -> (Unknowns, Vec<usize>) {
    let mut unknowns = Unknowns::new(sheet);
    let place = |unknowns: &Unknowns, corner: usize| unknowns.places[corner].place;
    let mut turned: Vec<Option<(usize, usize)>> = vec![None; unknowns.count];
    let mut centres = Vec::new();
    for Slit { way, .. } in slits {
        // The last half edge ends at the umbilic.
        let Some(last) = way.last() else { continue };
        let centre = place(&unknowns, end(*last));
        centres.push(centre);
        for half in way {
            let twin = sheet.table.twin(*half);
            for (left, right) in [(*half, end(twin)), (end(*half), twin)] {
                let [left, right] = [left, right].map(|corner| place(&unknowns, corner));
                if left != centre {
                    turned[left] = Some((right, centre));
                }
            }
        }
    }
    for corner in &mut unknowns.places {
        if let Some((right, centre)) = turned[corner.place] {
            (corner.place, corner.factor, corner.also) = (right, -1.0, Some((centre, 2.0)));
        }
    }
    (unknowns, centres)
}

/// Spreading weighs more where triangles are folded, as round umbilics.
fn unfold(sheet: &Sheet<'_>, weights: &mut Weights, unknowns: &Unknowns, coordinates: &mut Coordinates) -> Option<()> {
    for _ in 0..UNFOLDED {
        for d in 0..2 {
            let values = solved(sheet, weights, unknowns, d, &[])?;
            coordinates.set(sheet, unknowns, d, &values);
        }
        let mut near = vec![false; sheet.active.len()];
        let folded = (0..near.len()).filter(|f| coordinates.is_folded(sheet, *f));
        for v in folded.flat_map(|f| sheet.table.triangles[f]) {
            sheet.table.fan(v).for_each(|half| near[half / 3] = true);
        }
        if !near.contains(&true) {
            break;
        }
        let spreading = weights.spreading.iter_mut().zip(near);
        spreading.filter(|(_, near)| *near).for_each(|(weight, _)| *weight = (STIFFER * *weight).min(1.0));
    }
    Some(())
}

/// `None` if a system of equations has no solution in doubles.
pub(super) fn rounded(sheet: &Sheet<'_>, weights: &[f64], slits: &[Slit], edge: f64, evenness: f64) -> Option<Rounded> {
    let (unknowns, at) = unknowns(sheet, slits);
    let mut weights = Weights::new(weights, evenness);
    let mut coordinates = Coordinates { corners: vec![[[0.0; 2]; 3]; sheet.active.len()], periods: [0.0; 2] };
    unfold(sheet, &mut weights, &unknowns, &mut coordinates)?;
    let mut steps = [edge; 2];
    let mut centres = vec![[0.0; 2]; slits.len()];
    for d in 0..2 {
        let mut values = solved(sheet, &weights, &unknowns, d, &[])?;
        coordinates.set(sheet, &unknowns, d, &values);
        // A coordinate runs more slowly than arc length where its lines spread.
        let speed = coordinates.mean_speed(sheet, d);
        if !(speed > SLOWEST) {
            return None;
        }
        steps[d] = edge * speed;
        let mut ties: Vec<Tie> = Vec::new();
        let mut open: Vec<usize> = at.iter().skip(1).copied().collect();
        while !open.is_empty() {
            let apart = |unknown: usize| (values[unknown] - values[at[0]]) / steps[d];
            let off = |unknown: usize| (apart(unknown) - apart(unknown).round()).abs();
            // Those nearest to a whole number first.
            open.sort_by(|a, b| off(*a).total_cmp(&off(*b)));
            let near = open.iter().take_while(|unknown| off(**unknown) <= NEAR).count();
            let count = near.max((AT_ONCE * open.len() as f64).ceil() as usize);
            let tie = |unknown: usize| Tie { unknown, to: at[0], offset: apart(unknown).round() * steps[d] };
            ties.extend(open.drain(..count).map(tie));
            values = solved(sheet, &weights, &unknowns, d, &ties)?;
        }
        coordinates.set(sheet, &unknowns, d, &values);
        centres.iter_mut().zip(&at).for_each(|(centre, unknown)| centre[d] = values[*unknown]);
    }
    let mut passages = Passages::default();
    for (slit, centre) in slits.iter().zip(&centres) {
        let passage = Passage { turned: true, shift: centre.map(|x| 2.0 * x) };
        for half in slit.way.iter().flat_map(|half| [*half, sheet.table.twin(*half)]).filter(|half| *half != NONE) {
            passages.0.insert(half, passage);
        }
    }
    Some(Rounded { coordinates, steps, centres, passages })
}
