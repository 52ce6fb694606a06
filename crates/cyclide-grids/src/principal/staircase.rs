//! A grid of all whole cells: its border runs in steps, and what it goes round is an opening.

use super::continuation::continued;
use super::rectangles::largest;
use cyclide::Point3;
use cyclide::Result;
use cyclide::surface::{GridCell, QuadGrid};
use cyclide::workspace::{beside, flooded};

/// The cells of the piece round the largest rectangle of valid ones, without those that meet the rest in a corner alone; `None` if there
/// is no rectangle of `least` cells along each side.
pub(super) fn piece(valid: &[bool], size: [usize; 2], least: usize) -> Option<Vec<GridCell>> {
    let [m, n] = size;
    let from = largest(valid, m, least)?.from;
    let seed = from[0] + from[1] * m;
    let mut kept = flooded(valid, size, seed);
    // Each round takes cells away.
    while drop_corners(&mut kept, size) {
        let seed = if kept[seed] { seed } else { largest(&kept, m, least).map(|r| r.from[0] + r.from[1] * m)? };
        kept = flooded(&kept, size, seed);
    }
    let free: Vec<bool> = kept.iter().map(|kept| !kept).collect();
    let mut outside = vec![false; m * n];
    for k in (0..m * n).filter(|k| k.is_multiple_of(m) || k % m == m - 1 || k / m == 0 || k / m == n - 1) {
        if free[k] && !outside[k] {
            outside.iter_mut().zip(flooded(&free, size, k)).for_each(|(outside, reached)| *outside |= reached);
        }
    }
    let cell = |k: usize| match (kept[k], outside[k]) {
        (true, _) => GridCell::Patch,
        (false, true) => GridCell::Outside,
        (false, false) => GridCell::Opening,
    };
    Some((0..m * n).map(cell).collect())
}

/// Takes one of each two cells away that meet in a corner alone: that with fewer neighbors. True if there were any.
fn drop_corners(kept: &mut [bool], [m, n]: [usize; 2]) -> bool {
    let neighbors = |kept: &[bool], k: usize| beside(k, [m, n]).filter(|k| kept[*k]).count();
    let mut any = false;
    for k in (1..n).flat_map(|j| (1..m).map(move |i| i + j * m)) {
        let around = [k - m - 1, k - m, k - 1, k];
        let pair = match around.map(|k| kept[k]) {
            [true, false, false, true] => [around[0], around[3]],
            [false, true, true, false] => [around[1], around[2]],
            _ => continue,
        };
        let [a, b] = pair.map(|k| neighbors(kept, k));
        kept[if a < b { pair[0] } else { pair[1] }] = false;
        any = true;
    }
    any
}

/// The grid of cells whose patches have all corners: points of openings continue these smoothly. `None` if the openings are too large.
///
/// # Errors
/// As of `QuadGrid::new`.
pub(super) fn grid(mut points: Vec<Option<Point3>>, size: [usize; 2], cells: &[GridCell]) -> Option<Result<QuadGrid>> {
    let columns = size[0] - 1;
    let corners = |k: usize| {
        let first = k % columns + k / columns * size[0];
        [first, first + 1, first + size[0], first + size[0] + 1]
    };
    let mut wanted = vec![false; points.len()];
    for k in (0..cells.len()).filter(|k| cells[*k] != GridCell::Outside) {
        corners(k).into_iter().for_each(|v| wanted[v] = true);
    }
    points.iter_mut().zip(&wanted).filter(|(_, wanted)| !**wanted).for_each(|(point, _)| *point = None);
    continued(&mut points, &wanted, size, false)?;
    Some(QuadGrid::of_cells(&points, size, |i, j| cells[i + j * columns]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(rows: &[&str]) -> Option<String> {
        let size = [rows[0].len(), rows.len()];
        let valid: Vec<bool> = rows.iter().flat_map(|row| row.bytes().map(|b| b == b'#')).collect();
        let cells = piece(&valid, size, 2)?;
        let letter = |cell: &GridCell| match cell {
            GridCell::Patch => '#',
            GridCell::Opening => 'o',
            GridCell::Outside => '.',
        };
        Some(cells.chunks(size[0]).map(|row| row.iter().map(letter).collect::<String>()).collect::<Vec<_>>().join(" "))
    }

    #[test]
    fn one_piece_with_openings_and_without_loose_corners() {
        assert_eq!(drawn(&["##..#", "###.#", "###.."]).unwrap(), "##... ###.. ###..");
        assert_eq!(drawn(&["####", "#..#", "####", "####"]).unwrap(), "#### #oo# #### ####");
        // The cell that hangs on a corner, and then what it held.
        assert_eq!(drawn(&["##...", "##...", "..###", "...#."]).unwrap(), "##... ##... ..... .....");
        assert_eq!(drawn(&["#.#", ".#.", "#.#"]), None);
    }
}
