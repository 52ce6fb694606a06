//! Where the objects of a picture are seen: places for their numbers.

use std::collections::BTreeMap;

/// The part of a picture below which an object is not seen.
const LEAST: f64 = 1e-4;

/// Cells of the picture with the objects seen in them.
pub(super) struct Visible {
    cell: f64,
    columns: usize,
    rows: usize,
    /// The object in the middle of each cell.
    objects: Vec<Option<usize>>,
    /// How many pixels of each object are seen.
    seen: BTreeMap<usize, usize>,
    /// Fewer pixels than these are no sight of an object.
    least: usize,
}

impl Visible {
    /// Of a picture of so many pixels.
    pub(super) fn new((width, height): (usize, usize), cell: f64) -> Self {
        let [columns, rows] = [width, height].map(|size| (size as f64 / cell) as usize + 1);
        Self {
            cell,
            columns,
            rows,
            objects: vec![None; columns * rows],
            seen: BTreeMap::new(),
            least: (LEAST * (width * height) as f64) as usize,
        }
    }

    /// The object that is seen in a pixel; the last pixel of a cell counts.
    pub(super) fn add(&mut self, x: usize, y: usize, object: Option<usize>) {
        let [column, row] = [x, y].map(|v| (v as f64 / self.cell) as usize);
        let index = row * self.columns + column;
        object.into_iter().for_each(|object| *self.seen.entry(object).or_default() += 1);
        // A thin curve is found in any of its pixels.
        if object.is_some() || self.objects[index].is_none() {
            self.objects[index] = object;
        }
    }

    /// A note on the objects of a model that are not seen, or not more than as a few pixels; those without a name are not drawn.
    pub(super) fn hidden_note(&self, names: &[String]) -> Option<String> {
        let hidden =
            names.iter().enumerate().filter(|(index, _)| self.seen.get(index).is_none_or(|count| *count < self.least));
        let hidden: Vec<&str> = hidden.map(|(_, name)| name.as_str()).filter(|name| !name.is_empty()).collect();
        (!hidden.is_empty()).then(|| format!("not visible from this direction: {}", hidden.join(", ")))
    }

    /// For each object the pixel that is farthest from what is not this object, `None` for those that are not seen.
    pub(super) fn places(&self, objects: usize) -> Vec<Option<(f64, f64)>> {
        let depths = self.depths();
        let mut best: Vec<Option<(u32, usize)>> = vec![None; objects];
        for (index, object) in self.objects.iter().enumerate() {
            if let Some(best) = object.and_then(|object| best.get_mut(object))
                && best.is_none_or(|(depth, _)| depths[index] > depth)
            {
                *best = Some((depths[index], index));
            }
        }
        let pixel = |index: usize| {
            let [column, row] = [index % self.columns, index / self.columns];
            ((column as f64 + 0.5) * self.cell, (row as f64 + 0.5) * self.cell)
        };
        best.into_iter().map(|best| best.map(|(_, index)| pixel(index))).collect()
    }

    /// Steps from each cell to the next one of another object, diagonal ones allowed: two sweeps.
    fn depths(&self) -> Vec<u32> {
        let (columns, rows) = (self.columns, self.rows);
        let mut depths = vec![u32::MAX - 1; columns * rows];
        let neighbors: [(i64, i64); 8] = [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)];
        for sweep in [neighbors[..4].to_vec(), neighbors[4..].to_vec()] {
            let forward = sweep[0].1 < 0;
            for k in 0..columns * rows {
                let index = if forward { k } else { columns * rows - 1 - k };
                let (column, row) = ((index % columns) as i64, (index / columns) as i64);
                for (dx, dy) in neighbors {
                    let (x, y) = (column + dx, row + dy);
                    let inside = x >= 0 && y >= 0 && x < columns as i64 && y < rows as i64;
                    let other = if inside { y as usize * columns + x as usize } else { usize::MAX };
                    let depth = match self.objects.get(other) {
                        Some(object) if *object == self.objects[index] => match sweep.contains(&(dx, dy)) {
                            true => depths[other].saturating_add(1),
                            false => u32::MAX,
                        },
                        _ => 0,
                    };
                    depths[index] = depths[index].min(depth);
                }
            }
        }
        depths
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_in_the_middle_of_what_is_seen() {
        let mut visible = Visible::new((90, 60), 3.0);
        for (x, y) in (0..90 * 60).map(|k| (k % 90, k / 90)) {
            let object = match (x, y) {
                (10..40, 10..50) => Some(0),
                (60, 5..50) => Some(2),
                _ => None,
            };
            visible.add(x, y, object);
        }
        let places = visible.places(3);
        let (x, y) = places[0].unwrap();
        // As far from the sides as the narrower way allows, to a cell.
        assert!((x - 25.0).abs() <= 3.0 && (20.0..40.0).contains(&y), "{x} {y}");
        assert_eq!(places[1], None);
        let note = visible.hidden_note(&["front", "back", "edge"].map(str::to_owned));
        assert_eq!(note.as_deref(), Some("not visible from this direction: back"));
        assert!((places[2].unwrap().0 - 60.0).abs() <= 3.0);
    }
}
