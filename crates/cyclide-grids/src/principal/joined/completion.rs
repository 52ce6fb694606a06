//! The quads between an umbilic and the loop that walks leave round it, by counting: near an umbilic coordinates may be folded.

use std::collections::{HashMap, HashSet};

/// Quads round an umbilic at most.
const MOST_QUADS: usize = 400;

/// A point of the lattice round an umbilic of `n` quarter turns: which quarter it is in, from the axis on its right, and how far along
/// that axis (at least 1) and to the left of it. The umbilic itself is `None`.
type Key = Option<(usize, usize, usize)>;

/// The point of a quarter; that on its left axis is the next one's.
fn key(n: usize, quarter: usize, i: usize, j: usize) -> Key {
    match (i, j) {
        (0, 0) => None,
        (0, j) => Some(((quarter + 1) % n, j, 0)),
        (i, j) => Some((quarter, i, j)),
    }
}

/// What fills a loop: quads counter-clockwise, by vertices of the loop and new ones numbered from `first` on; the umbilic is the first
/// of those.
pub(super) struct Filling {
    pub(super) quads: Vec<[usize; 4]>,
    pub(super) new: usize,
}

/// The filling of a loop that runs clockwise round the umbilic, with quads on its left: `counts` of them at each of its vertices. `None`
/// if the loop does not go round a point of `n` quarter turns (two or six) once, through none of the lattice twice.
pub(super) fn filling(border: &[usize], counts: &[usize], n: usize, first: usize) -> Option<Filling> {
    let keys = keys(border, counts, n)?;
    let mut number: HashMap<Key, usize> = HashMap::new();
    for (at, vertex) in keys.iter().zip(border.iter().rev()) {
        if number.insert(*at, *vertex).is_some() {
            return None;
        }
    }
    let side = |a: Key, b: Key| if a < b { (a, b) } else { (b, a) };
    let edge: HashSet<(Key, Key)> = (0..keys.len()).map(|k| side(keys[k], keys[(k + 1) % keys.len()])).collect();
    number.insert(None, first);
    let mut filling = Filling { quads: Vec::new(), new: 1 };
    let mut stack: Vec<(usize, usize, usize)> = (0..n).map(|quarter| (quarter, 0, 0)).collect();
    let mut known: HashSet<(usize, usize, usize)> = stack.iter().copied().collect();
    while let Some((quarter, i, j)) = stack.pop() {
        if filling.quads.len() >= MOST_QUADS {
            return None;
        }
        let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| key(n, quarter, i, j));
        filling.quads.push(corners.map(|at| {
            *number.entry(at).or_insert_with(|| {
                filling.new += 1;
                first + filling.new - 1
            })
        }));
        let below = if j > 0 { (quarter, i, j - 1) } else { ((quarter + n - 1) % n, 0, i) };
        let left = if i > 0 { (quarter, i - 1, j) } else { ((quarter + 1) % n, j, 0) };
        for (k, next) in [below, (quarter, i + 1, j), (quarter, i, j + 1), left].into_iter().enumerate() {
            if !edge.contains(&side(corners[k], corners[(k + 1) % 4])) && known.insert(next) {
                stack.push(next);
            }
        }
    }
    Some(filling)
}

/// The points of the lattice along a loop, counter-clockwise: it is unrolled, and the umbilic is what its turn keeps in place.
fn keys(border: &[usize], counts: &[usize], n: usize) -> Option<Vec<Key>> {
    let count = border.len();
    let around: Vec<usize> = border.iter().rev().map(|v| counts[*v]).collect();
    let turns: i64 = around.iter().map(|quads| *quads as i64 - 2).sum();
    // After two or six quarter turns places are opposite.
    if turns != n as i64 || n % 4 != 2 {
        return None;
    }
    let (mut places, mut at, mut heading) = (Vec::with_capacity(count), [0_i64; 2], 0_i64);
    for k in 0..count {
        places.push(at);
        let step = [[1, 0], [0, 1], [-1, 0], [0, -1]][heading.rem_euclid(4) as usize];
        at = [at[0] + step[0], at[1] + step[1]];
        heading += around[(k + 1) % count] as i64 - 2;
    }
    if at.iter().any(|x| x % 2 != 0) {
        return None;
    }
    let centre = at.map(|x| x / 2);
    let quarter_of = |[x, y]: [i64; 2]| match (x, y) {
        (0, 0) => None,
        _ if x > 0 && y >= 0 => Some(0),
        _ if x <= 0 && y > 0 => Some(1),
        _ if x < 0 => Some(2),
        _ => Some(3),
    };
    let mut keys = Vec::with_capacity(count);
    let (mut before, mut passed) = (None, 0_i64);
    for place in places.into_iter().chain([at]) {
        let from = [place[0] - centre[0], place[1] - centre[1]];
        let quarter: i64 = quarter_of(from)?;
        passed += match (quarter - before.unwrap_or(quarter)).rem_euclid(4) {
            0 => 0,
            1 => 1,
            3 => -1,
            _ => return None,
        };
        before = Some(quarter);
        let [x, y] = from;
        let [i, j] = [[x, y], [y, -x], [-x, -y], [-y, x]][quarter as usize];
        keys.push(Some((passed.rem_euclid(n as i64) as usize, i.unsigned_abs() as usize, j.unsigned_abs() as usize)));
    }
    // Back where it started, after a whole round.
    (passed == n as i64 && keys.pop() == keys.first().copied()).then_some(keys)
}
