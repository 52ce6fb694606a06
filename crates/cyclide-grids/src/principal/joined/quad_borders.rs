//! The borders of a mesh of quads that are all turned alike.

use std::collections::{BTreeMap, HashMap, HashSet};

fn sides(quads: &[[usize; 4]]) -> HashMap<[usize; 2], usize> {
    let of_quad = |(q, quad): (usize, &[usize; 4])| {
        let [a, b, c, d] = *quad;
        [[a, b], [b, c], [c, d], [d, a]].map(|side| (side, q))
    };
    quads.iter().enumerate().flat_map(of_quad).collect()
}

/// The loops of the border, with the quads on their left; no vertex may be on two of them.
pub(super) fn loops(quads: &[[usize; 4]]) -> Vec<Vec<usize>> {
    let sides = sides(quads);
    let mut next: BTreeMap<usize, usize> =
        sides.keys().filter(|[a, b]| !sides.contains_key(&[*b, *a])).map(|[a, b]| (*a, *b)).collect();
    let mut loops = Vec::new();
    while let Some((&start, _)) = next.first_key_value() {
        let (mut border, mut at) = (Vec::new(), start);
        while let Some(to) = next.remove(&at) {
            border.push(at);
            at = to;
        }
        loops.push(border);
    }
    loops
}

/// How many quads each vertex has.
pub(super) fn counts(quads: &[[usize; 4]], vertices: usize) -> Vec<usize> {
    let mut counts = vec![0; vertices];
    quads.iter().flatten().for_each(|v| counts[*v] += 1);
    counts
}

/// Takes quads away until no two meet in a corner alone; of what then hangs together by sides the largest part stays.
pub(super) fn drop_loose(quads: &mut Vec<[usize; 4]>) {
    // Each round takes quads away.
    loop {
        *quads = largest_part(quads);
        let sides = sides(quads);
        let mut starts: BTreeMap<usize, usize> = BTreeMap::new();
        for [a, _] in sides.keys().filter(|[a, b]| !sides.contains_key(&[*b, *a])) {
            *starts.entry(*a).or_default() += 1;
        }
        let loose: HashSet<usize> = starts.into_iter().filter(|(_, n)| *n > 1).map(|(v, _)| v).collect();
        if loose.is_empty() {
            return;
        }
        let neighbors =
            |quad: &[usize; 4]| (0..4).filter(|k| sides.contains_key(&[quad[(k + 1) % 4], quad[*k]])).count();
        let mut worst: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
        for (q, quad) in quads.iter().enumerate() {
            for v in quad.iter().filter(|v| loose.contains(v)) {
                let found = (neighbors(quad), q);
                worst.entry(*v).and_modify(|worst| *worst = found.min(*worst)).or_insert(found);
            }
        }
        let gone: HashSet<usize> = worst.into_values().map(|(_, q)| q).collect();
        *quads = quads.iter().enumerate().filter(|(q, _)| !gone.contains(q)).map(|(_, quad)| *quad).collect();
    }
}

fn largest_part(quads: &[[usize; 4]]) -> Vec<[usize; 4]> {
    let sides = sides(quads);
    let mut part = vec![None; quads.len()];
    let mut sizes = Vec::new();
    for start in 0..quads.len() {
        if part[start].is_some() {
            continue;
        }
        let (mut stack, mut size) = (vec![start], 0);
        part[start] = Some(sizes.len());
        while let Some(q) = stack.pop() {
            size += 1;
            for k in 0..4 {
                if let Some(&other) = sides.get(&[quads[q][(k + 1) % 4], quads[q][k]])
                    && part[other].is_none()
                {
                    part[other] = Some(sizes.len());
                    stack.push(other);
                }
            }
        }
        sizes.push(size);
    }
    // Of several the first.
    let largest = (0..sizes.len()).max_by(|a, b| sizes[*a].cmp(&sizes[*b]).then(b.cmp(a)));
    quads.iter().zip(part).filter(|(_, part)| *part == largest).map(|(quad, _)| *quad).collect()
}
