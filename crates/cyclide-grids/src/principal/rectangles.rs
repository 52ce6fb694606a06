//! The largest rectangle of cells.

/// A rectangle of cells: its first cell and its size.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Rectangle {
    pub(super) from: [usize; 2],
    pub(super) size: [usize; 2],
}

impl Rectangle {
    pub(super) fn cells(self) -> usize {
        self.size[0] * self.size[1]
    }
}

/// The largest rectangle of valid cells with at least `least` cells along each side (of several the first): heights of columns and a
/// stack, linear in the cells.
pub(super) fn largest(valid: &[bool], columns: usize, least: usize) -> Option<Rectangle> {
    let mut best: Option<Rectangle> = None;
    let mut heights = vec![0_usize; columns];
    for (row, cells) in valid.chunks_exact(columns.max(1)).enumerate() {
        heights.iter_mut().zip(cells).for_each(|(height, valid)| *height = if *valid { *height + 1 } else { 0 });
        // Columns from which on at least this height is free.
        let mut stack: Vec<(usize, usize)> = Vec::new();
        for column in 0..=columns {
            let height = heights.get(column).copied().unwrap_or(0);
            let mut from = column;
            while let Some((start, top)) = stack.pop_if(|(_, top)| *top >= height) {
                from = start;
                let found = Rectangle { from: [start, row + 1 - top], size: [column - start, top] };
                let large = found.size.iter().all(|side| *side >= least);
                if large && best.is_none_or(|best| found.cells() > best.cells()) {
                    best = Some(found);
                }
            }
            stack.push((from, height));
        }
    }
    best
}

/// The longest run of rows in which every cell is valid, at least `least` of them.
pub(super) fn longest_band(valid: &[bool], columns: usize, least: usize) -> Option<Rectangle> {
    let full: Vec<bool> = valid.chunks_exact(columns.max(1)).map(|row| row.iter().all(|cell| *cell)).collect();
    let run = largest(&full, 1, 1)?;
    (run.size[1] >= least).then_some(Rectangle { from: [0, run.from[1]], size: [columns, run.size[1]] })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(rows: &[&str]) -> (Vec<bool>, usize) {
        (rows.iter().flat_map(|row| row.bytes().map(|b| b == b'#')).collect(), rows[0].len())
    }

    #[test]
    fn the_largest_is_found() {
        let (valid, columns) = cells(&["#..###", "######", ".#####", "##.###"]);
        let found = largest(&valid, columns, 1).unwrap();
        assert_eq!(found, Rectangle { from: [3, 0], size: [3, 4] });
        assert_eq!(largest(&valid, columns, 4), None);
        assert_eq!(longest_band(&valid, columns, 1), Some(Rectangle { from: [0, 1], size: [6, 1] }));
        assert_eq!(largest(&[], 0, 1), None);
    }

    /// Against all rectangles, on cells that a multiplication scatters.
    #[test]
    fn as_large_as_the_largest_of_all() {
        for seed in 1..40_usize {
            let (columns, rows) = (3 + seed % 5, 2 + seed % 7);
            let valid: Vec<bool> =
                (0..columns * rows).map(|k| (k * k + seed * k + seed) * 2_654_435 % 11 > 2).collect();
            let mut most = 0;
            for from in 0..columns * rows {
                let (x, y) = (from % columns, from / columns);
                for (w, h) in (1..=columns - x).flat_map(|w| (1..=rows - y).map(move |h| (w, h))) {
                    if (0..h).all(|j| (0..w).all(|i| valid[(y + j) * columns + x + i])) {
                        most = most.max(w * h);
                    }
                }
            }
            assert_eq!(largest(&valid, columns, 1).map_or(0, Rectangle::cells), most);
        }
    }
}
