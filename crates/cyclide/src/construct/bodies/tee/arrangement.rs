//! How branches stand on their main pipe: one behind the other, or beside each other in rows between which lines along the pipe are free of holes
//! (`docs/math/pipe-tees.md#branches-beside-each-other`).

use super::Placed;
use crate::error::{Error, Result, TeeError};
use std::f64::consts::{PI, TAU};

/// A part of a pipe beyond a blend is longer than this part of its radius.
pub(super) const LEAST_REST: f64 = 1e-3;
/// The largest angle from the middle of a hole to a line beside it: arcs of nearly half a turn have weights near zero.
const FARTHEST_LINE: f64 = 0.9 * PI;
/// Two branches are opposite each other if they are off that by no more than this, in radians and in parts of the radius.
const OPPOSITE: f64 = 1e-12;

/// Branches beside the same part of the main pipe, by their numbers among all in the order of their places.
pub(super) struct Group {
    pub(super) stand: Stand,
    /// The places along the main pipe between which their blends are.
    pub(super) reach: [f64; 2],
}

/// How they stand.
pub(super) enum Stand {
    Alone(usize),
    /// In rows, in the order of their angles.
    Rows(Vec<Row>),
    /// Two as wide as the main pipe, opposite each other: their blends meet at the flanks, and leave nothing of the main pipe between them.
    Halves([usize; 2]),
}

/// Branches one behind the other. Angles are those in the axes of the first branch of its group.
pub(super) struct Row {
    /// With the angles by which they are turned.
    pub(super) members: Vec<(usize, f64)>,
    /// The lines beside the row, high and low.
    pub(super) lines: [f64; 2],
}

/// The angles of a hole round the main pipe.
#[derive(Debug, Clone, Copy)]
struct Breadth {
    turn: f64,
    middle: f64,
    half: f64,
}

impl Breadth {
    fn new(placed: &Placed, reference: &Placed) -> Self {
        let turn = reference.crossing.main_pipe(0.0).angle_of(placed.crossing.up);
        let [low, high] = placed.breadth;
        Self { turn, middle: turn + 0.5 * (low + high), half: 0.5 * (high - low) }
    }

    /// As near to an angle as whole turns allow.
    fn near(self, angle: f64) -> Self {
        let turns = TAU * ((angle - self.middle) / TAU).round();
        Self { turn: self.turn + turns, middle: self.middle + turns, ..self }
    }

    /// The angle between two holes, negative if they overlap.
    fn gap(self, other: Self) -> f64 {
        (self.middle - other.near(self.middle).middle).abs() - self.half - other.half
    }
}

/// The places between two holes, negative if they overlap.
fn gap_along(a: &Placed, b: &Placed) -> f64 {
    (b.reach[0] - a.reach[1]).max(a.reach[0] - b.reach[1])
}

/// Whether two branches are as wide as the main pipe and opposite each other: each has its half of the space, with both flanks on its border.
pub(super) fn are_halves(a: &Placed, b: &Placed) -> bool {
    let [first, second] = [&a.crossing, &b.crossing];
    let off = (first.at - second.at).abs() / first.radii[1];
    first.equal && second.equal && off <= OPPOSITE && (first.up + second.up).length() <= OPPOSITE
}

/// The groups of branches in the order of their places, for a least rest of the main pipe between them.
///
/// # Errors
/// `tee-branches-meet`, `tee-equal-branches-not-opposite`, `tee-no-free-line`.
pub(super) fn groups(placed: &[Placed], rest: f64) -> Result<Vec<Group>> {
    let needed = 3.0 * rest;
    let mut members: Vec<(Vec<usize>, [f64; 2])> = Vec::new();
    for (k, branch) in placed.iter().enumerate() {
        match members.last_mut() {
            Some((group, reach)) if !(branch.reach[0] - reach[1] > needed) => {
                group.push(k);
                reach[1] = reach[1].max(branch.reach[1]);
            }
            _ => members.push((vec![k], branch.reach)),
        }
    }
    let stands = members.into_iter().map(|(group, reach)| Ok(Group { stand: stand(placed, &group, needed)?, reach }));
    stands.collect()
}

fn stand(placed: &[Placed], group: &[usize], needed: f64) -> Result<Stand> {
    if let [alone] = *group {
        return Ok(Stand::Alone(alone));
    }
    let breadths: Vec<Breadth> = group.iter().map(|&k| Breadth::new(&placed[k], &placed[group[0]])).collect();
    let of = |k: usize| &placed[group[k]];
    let numbers = |a: usize, b: usize| {
        let [a, b] = [a, b].map(|k| of(k).crossing.branch);
        [a.min(b), a.max(b)]
    };
    let none_free = |a: usize, b: usize| {
        let [first, second] = numbers(a, b);
        Error::Tee(TeeError::NoFreeLine { first, second })
    };
    let needed_round = 3.0 * LEAST_REST;
    let along = |a: usize, b: usize| gap_along(of(a), of(b));
    let pairs = || (1..group.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
    for (a, b) in pairs() {
        let (distance, round) = (along(a, b), breadths[a].gap(breadths[b]));
        if distance > needed || round > needed_round {
            continue;
        }
        if are_halves(of(a), of(b)) {
            if group.len() == 2 {
                return Ok(Stand::Halves([group[a], group[b]]));
            }
            let beside = |&k: &usize| k != a && k != b && !(along(a, k).min(along(b, k)) > needed);
            let other = (0..group.len()).find(beside).unwrap_or(a);
            return Err(none_free(if along(a, other) > needed { b } else { a }, other));
        }
        let [first, second] = numbers(a, b);
        if of(a).crossing.equal && of(b).crossing.equal {
            let [a, b] = [&of(a).crossing, &of(b).crossing];
            let (angle, along) = (a.up.angle(-b.up), (a.at - b.at).abs());
            return Err(TeeError::EqualBranchesNotOpposite {
                first,
                second,
                angle,
                along,
                needed: along + needed - distance,
            }
            .into());
        }
        return Err(TeeError::BranchesMeet { first, second, distance, needed, round }.into());
    }
    let mut rows = parted(&breadths, needed_round);
    for row in &mut rows {
        for (k, &(a, _)) in row.iter().enumerate() {
            if let Some(&(b, _)) = row[..k].iter().find(|(b, _)| !(along(a, *b) > needed)) {
                return Err(none_free(a, b));
            }
        }
        row.sort_by(|(a, _), (b, _)| of(*a).reach[0].total_cmp(&of(*b).reach[0]));
    }
    let bounds: Vec<[f64; 2]> = rows.iter().map(|row| bounds(row)).collect();
    let count = rows.len();
    let rows = rows.into_iter().enumerate().map(|(k, row)| {
        let [low, high] = bounds[k];
        // A third of the way to the next row on both sides.
        let next = bounds[(k + 1) % count][0] + if k + 1 == count { TAU } else { 0.0 };
        let before = bounds[(k + count - 1) % count][1] - if k == 0 { TAU } else { 0.0 };
        let lines = [high + (next - high) / 3.0, low - (low - before) / 3.0];
        for (a, breadth) in &row {
            let [above, below] = [lines[0] - breadth.middle, breadth.middle - lines[1]];
            if above.max(below) > FARTHEST_LINE {
                let farthest = |b: &Breadth| if above > below { b.middle + b.half } else { b.half - b.middle };
                let other = row.iter().max_by(|(_, b), (_, c)| farthest(b).total_cmp(&farthest(c)));
                return Err(none_free(*a, other.map_or(*a, |(b, _)| *b)));
            }
        }
        Ok(Row { members: row.into_iter().map(|(a, breadth)| (group[a], breadth.turn)).collect(), lines })
    });
    Ok(Stand::Rows(rows.collect::<Result<_>>()?))
}

/// Holes that are not apart round the pipe, or by way of others, in one row each, in the order of their angles.
fn parted(breadths: &[Breadth], needed: f64) -> Vec<Vec<(usize, Breadth)>> {
    let mut free: Vec<usize> = (0..breadths.len()).rev().collect();
    let mut rows: Vec<Vec<(usize, Breadth)>> = Vec::new();
    while let Some(first) = free.pop() {
        let mut row = vec![(first, breadths[first])];
        let mut looked_at = 0;
        while let Some(&(_, own)) = row.get(looked_at) {
            let beside = |k: &usize| !(own.gap(breadths[*k]) > needed);
            row.extend(free.iter().copied().filter(beside).map(|k| (k, breadths[k].near(own.middle))));
            free.retain(|k| !beside(k));
            looked_at += 1;
        }
        rows.push(row);
    }
    // On one sheet, from the first row on.
    let start = bounds(&rows[0])[0];
    for row in &mut rows {
        let turns = -TAU * ((bounds(row)[0] - start) / TAU).floor();
        for (_, breadth) in row {
            breadth.turn += turns;
            breadth.middle += turns;
        }
    }
    rows.sort_by(|a, b| bounds(a)[0].total_cmp(&bounds(b)[0]));
    rows
}

/// The lowest and the highest angle of a row.
fn bounds(row: &[(usize, Breadth)]) -> [f64; 2] {
    row.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], (_, breadth)| {
        [low.min(breadth.middle - breadth.half), high.max(breadth.middle + breadth.half)]
    })
}
