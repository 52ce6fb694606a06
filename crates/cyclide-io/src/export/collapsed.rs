//! What rounding leaves no triangle of.
//!
//! A triangle of which two corners round to one place is a line, or a point, and is not written. Mostly its neighbors
//! close the gap: the line is a side of one of them. Where a whole tube is thinner than the steps of single precision,
//! no triangle is left beside the line, and what was round it is as far from the file as the line's places are from
//! the triangles that are written.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap, HashSet};

/// Corners in single precision; equal places have equal bits.
pub(crate) type Triangle = [[f32; 3]; 3];
type Key = [u32; 3];

/// True if the triangle is neither a line nor a point; of zeros there is one only, the positive.
pub(crate) fn is_whole(triangle: &Triangle) -> bool {
    let [a, b, c] = triangle.map(key);
    a != b && b != c && c != a
}

/// A distance that no point of the collapsed triangles is farther from the whole ones than, along their sides: 0 where
/// these close the gaps, infinite where a part has no whole triangle at all.
pub(crate) fn reach(whole: &[Triangle], collapsed: &[Triangle]) -> f64 {
    let lines: HashSet<[Key; 2]> = collapsed.iter().flat_map(sides).filter(|[a, b]| a != b).collect();
    let mut ways: HashMap<Key, Vec<Key>> = HashMap::new();
    for &[a, b] in &lines {
        ways.entry(a).or_default().push(b);
        ways.entry(b).or_default().push(a);
    }
    // A collapsed point without a line counts as well.
    for triangle in collapsed {
        ways.entry(key(triangle[0])).or_default();
    }
    let mut closed: HashSet<[Key; 2]> = HashSet::new();
    let mut distances: HashMap<Key, f64> = HashMap::new();
    for triangle in whole {
        closed.extend(sides(triangle).into_iter().filter(|side| lines.contains(side)));
        distances.extend(triangle.iter().copied().map(key).filter(|key| ways.contains_key(key)).map(|key| (key, 0.0)));
    }
    // Shortest ways from the whole triangles (Dijkstra); the bits of positive numbers are in their order.
    let mut queue: BinaryHeap<Reverse<(u64, Key)>> = distances.keys().map(|key| Reverse((0, *key))).collect();
    while let Some(Reverse((bits, from))) = queue.pop() {
        let so_far = f64::from_bits(bits);
        if distances.get(&from).is_some_and(|known| *known < so_far) {
            continue;
        }
        for &to in ways.get(&from).into_iter().flatten() {
            let distance = so_far + length(from, to);
            if distances.get(&to).is_none_or(|known| distance < *known) {
                distances.insert(to, distance);
                queue.push(Reverse((distance.to_bits(), to)));
            }
        }
    }
    let of = |key: &Key| distances.get(key).copied().unwrap_or(f64::INFINITY);
    // From somewhere on a line to the nearer end and on.
    let along = lines.difference(&closed).map(|[a, b]| 0.5 * (of(a) + of(b) + length(*a, *b)));
    along.chain(ways.keys().map(of)).fold(0.0, f64::max)
}

fn key(place: [f32; 3]) -> Key {
    place.map(f32::to_bits)
}

/// The sides, each with its ends in one order.
fn sides(triangle: &Triangle) -> [[Key; 2]; 3] {
    let [a, b, c] = triangle.map(key);
    [[a, b], [b, c], [c, a]].map(|[a, b]| if a <= b { [a, b] } else { [b, a] })
}

fn length(a: Key, b: Key) -> f64 {
    let squares =
        a.into_iter().zip(b).map(|(a, b)| (f64::from(f32::from_bits(a)) - f64::from(f32::from_bits(b))).powi(2));
    squares.sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lengths of whole numbers are exact.
    fn is_reached(whole: &[Triangle], collapsed: &[Triangle], expected: f64) -> bool {
        reach(whole, collapsed).to_bits() == expected.to_bits()
    }

    const A: [f32; 3] = [0.0, 0.0, 0.0];
    const B: [f32; 3] = [3.0, 4.0, 0.0];
    const C: [f32; 3] = [3.0, 0.0, 0.0];
    const D: [f32; 3] = [3.0, 4.0, 2.0];
    const E: [f32; 3] = [0.0, 0.0, 9.0];

    #[test]
    fn neighbors_close_gaps_and_spikes_are_measured() {
        let whole = [[A, B, C]];
        assert!(is_whole(&whole[0]) && !is_whole(&[A, B, B]) && !is_whole(&[A, A, A]));
        assert!(is_reached(&whole, &[], 0.0));
        let on_sides = [[A, B, B], [B, C, C], [C, C, C]];
        assert!(is_reached(&whole, &on_sides, 0.0));
        // A spike from B to D, and on to E: the way to its end.
        assert!(is_reached(&whole, &[[B, D, D]], 2.0));
        let on = length(key(D), key(E));
        assert!(is_reached(&whole, &[[B, D, D], [E, D, E]], 2.0 + on));
    }

    #[test]
    fn between_two_triangles_it_is_half_the_way() {
        let whole = [[A, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [E, [1.0, 0.0, 9.0], [0.0, 1.0, 9.0]]];
        assert!(is_reached(&whole, &[[A, E, E]], 4.5));
    }

    #[test]
    fn what_hangs_on_nothing_is_lost() {
        let whole = [[A, B, C]];
        assert!(is_reached(&whole, &[[D, E, E]], f64::INFINITY));
        assert!(is_reached(&whole, &[[D, D, D]], f64::INFINITY));
        assert!(is_reached(&[], &[[A, B, B]], f64::INFINITY));
    }
}
