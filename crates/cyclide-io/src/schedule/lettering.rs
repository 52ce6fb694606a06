//! How large lettering is, so that it stays where it belongs.

/// Width of a letter, as part of its height: that of the widest plain fonts of drawing programs, with the room behind it.
const LETTER: f64 = 1.0;
/// Each time that lettering is too large it gets smaller by this.
const SMALLER: f64 = 0.9;
/// Times at most: then it is a fiftieth.
const TIMES: usize = 38;

/// Width of a text of a height.
pub(super) fn width(text: &str, height: f64) -> f64 {
    LETTER * height * text.chars().count() as f64
}

/// The largest height of a text in a box.
pub(super) fn height_in_box(text: &str, wide: f64, high: f64) -> f64 {
    high.min(wide / width(text, 1.0).max(1.0))
}

/// The largest height of a text within a circle.
pub(super) fn height_in_circle(text: &str, radius: f64) -> f64 {
    2.0 * radius / width(text, 1.0).hypot(1.0)
}

/// The height, made smaller until half its width and its height fit.
pub(super) fn shrunk(text: &str, height: f64, fits: impl Fn(f64, f64) -> bool) -> f64 {
    let heights = std::iter::successors(Some(height), |height| Some(height * SMALLER)).take(TIMES);
    let mut last = height;
    for height in heights {
        last = height;
        if fits(0.5 * width(text, height), height) {
            break;
        }
    }
    last
}
