//! The directions of the coordinate surfaces of blocks.

/// The directions s, t, u (0, 1, 2) of the two parameters of a surface across a direction, in order.
pub(crate) const fn others(axis: usize) -> [usize; 2] {
    match axis {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    }
}
