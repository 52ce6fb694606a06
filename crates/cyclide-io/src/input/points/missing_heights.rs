//! Heights that stand for none: -9999 and the like, as programs write them where nothing was measured.

/// What is written for no height, and for hardly anything else,
const NONE: [f64; 14] = [
    -999.0, -999.25, -9999.0, -9999.99, -99_999.0, -999_999.0, 9999.0, 9999.99, 99_999.0, 999_999.0, 32_767.0,
    -32_767.0, -32_768.0, 65_535.0,
];
/// and heights above this, such as the largest number of single precision.
const NO_HEIGHT: f64 = 1e15;
/// What may be a height as well.
const PERHAPS: [f64; 3] = [0.0, 999.0, 999.9];
/// It is farther from the others than this many times their range,
const APART: f64 = 3.0;
/// of which there are at least so many, and at most this part of all stands for none.
const OTHERS: usize = 3;
const PART: f64 = 0.5;

/// Heights that stand for none.
pub(super) struct MissingHeights {
    value: f64,
    /// How many there are, and the number of the first among all heights.
    count: usize,
    pub(super) first: usize,
    /// Least and largest of the others.
    others: [f64; 2],
    /// They are no heights: else they may be.
    pub(super) is_certain: bool,
}

impl MissingHeights {
    /// Finds them among heights that were measured: others, equal to each other, may be levels.
    pub(super) fn of(heights: impl Iterator<Item = f64> + Clone) -> Option<Self> {
        let huge = heights.clone().find(|z| z.abs() > NO_HEIGHT);
        let values = huge.into_iter().chain(NONE).chain(PERHAPS);
        values.into_iter().find_map(|value| {
            let is_value = |z: &f64| z.total_cmp(&value).is_eq();
            let first = heights.clone().position(|z| is_value(&z))?;
            let others = || heights.clone().filter(|z| !is_value(z));
            let (total, left) = (heights.clone().count(), others().count());
            let [low, high] = others().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], z| [a.min(z), b.max(z)]);
            let apart = (low - value).max(value - high);
            let are_measured = left >= OTHERS && high > low && apart > APART * (high - low);
            let count = total - left;
            let are_few = count as f64 <= PART * total as f64;
            let is_certain = !PERHAPS.contains(&value);
            (are_measured && are_few).then_some(Self { value, count, first, others: [low, high], is_certain })
        })
    }

    /// What is said of them, without the remedy.
    pub(super) fn sentence(&self) -> String {
        let Self { value, count, others: [low, high], is_certain, .. } = self;
        let heights = if *count == 1 { "height is" } else { "heights are" };
        let verb = if *is_certain { "marks" } else { "may mark" };
        let value = if value.abs() > NO_HEIGHT { format!("{value:e}") } else { value.to_string() };
        format!("{count} {heights} {value}, which {verb} a missing value: the others lie from {low} to {high}")
    }

    /// What is said of points, with the columns that leave heights out and that take these as they are.
    pub(super) fn of_points(&self, plane: &str, space: &str) -> String {
        let points = if self.count == 1 { "point" } else { "points" };
        format!(
            "{}; leave the {points} out, or take all points in the plane (`--columns {plane}`, in a document `columns`); `--columns {space}` reads all \
             heights unchanged",
            self.sentence()
        )
    }
}
