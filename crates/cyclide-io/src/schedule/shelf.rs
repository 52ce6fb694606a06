//! Boxes in rows on a sheet, in their order.

use cyclide::{Aabb, Vec3};

/// Width over height of the sheet, nearly.
const ASPECT: f64 = 1.6;
/// Room between boxes, as part of the mean box.
const ROOM: f64 = 0.05;
/// Rows get longer by this until the sheet is no higher than it should be; so often at most, which is ten times as long.
const LONGER: f64 = 1.1;
const TRIALS: usize = 24;

/// Rows of boxes.
pub(super) struct Shelf;

impl Shelf {
    /// How far each box is moved so that they stand in rows from the left to the right, the rows from above to below, from
    /// the origin on.
    pub(super) fn of(boxes: &[Aabb]) -> Vec<Vec3> {
        let size = |b: &Aabb| (b.max.x - b.min.x, b.max.y - b.min.y);
        let count = boxes.len().max(1) as f64;
        let mean = boxes.iter().map(size).map(|(w, h)| 0.5 * (w + h)).sum::<f64>() / count;
        let room = ROOM * mean;
        let area: f64 = boxes.iter().map(size).map(|(w, h)| (w + room) * (h + room)).sum();
        let widest = boxes.iter().map(size).map(|(w, _)| w).fold(0.0, f64::max);
        let mut width = (ASPECT * area).sqrt().max(widest);
        // Boxes of other heights leave room in their rows: then rows are longer.
        for _ in 0..TRIALS {
            let (shifts, height) = rows(boxes, width, room);
            if ASPECT * height <= width {
                return shifts;
            }
            width *= LONGER;
        }
        rows(boxes, width, room).0
    }
}

/// The boxes in rows of a width, and how high all rows are.
fn rows(boxes: &[Aabb], width: f64, room: f64) -> (Vec<Vec3>, f64) {
    let (mut x, mut top, mut high) = (0.0, 0.0, 0.0_f64);
    let place = |b: &Aabb| {
        let (w, h) = (b.max.x - b.min.x, b.max.y - b.min.y);
        if x > 0.0 && x + w > width {
            (x, top, high) = (0.0, top - high - room, 0.0);
        }
        let shift = Vec3::new(x - b.min.x, top - b.max.y, 0.0);
        (x, high) = (x + w + room, high.max(h));
        shift
    };
    let shifts = boxes.iter().map(place).collect();
    (shifts, high - top)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::Point3;

    #[test]
    fn boxes_do_not_overlap() {
        let sizes = (0..60).map(|k| (1.0 + f64::from(k * 7 % 11), 0.5 + f64::from(k * 5 % 3)));
        let boxes: Vec<Aabb> = sizes
            .map(|(w, h)| Aabb { min: Point3::new(-3.0, 2.0, 0.0), max: Point3::new(w - 3.0, h + 2.0, 0.0) })
            .collect();
        let moved: Vec<Aabb> = boxes
            .iter()
            .zip(Shelf::of(&boxes))
            .map(|(b, shift)| Aabb { min: b.min + shift, max: b.max + shift })
            .collect();
        for (i, a) in moved.iter().enumerate() {
            for b in &moved[..i] {
                let apart = a.min.x >= b.max.x || b.min.x >= a.max.x || a.min.y >= b.max.y || b.min.y >= a.max.y;
                assert!(apart, "{a:?} {b:?}");
            }
        }
        let all = moved.into_iter().reduce(Aabb::union).unwrap();
        let aspect = (all.max.x - all.min.x) / (all.max.y - all.min.y);
        assert!(aspect > 0.75 * ASPECT && aspect < 1.5 * ASPECT, "nearly as wide as a sheet: {aspect}");
    }
}
