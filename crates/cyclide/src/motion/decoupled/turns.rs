//! A spline of rotations that runs beyond no pose: C1, of cubics in the quaternions.
//!
//! Its angular velocities at the poses are harmonic means of those from pose to pose, `(|w_1| w_0 + |w_0| w_1)/(|w_0| + |w_1|)`: for turns about one
//! axis the slopes with which piecewise cubics are monotone (F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984), 300-304), zero where the body rests or
//! turns round. They are vectors of the world that turn with it and do not know the frame of the body (`docs/math/motions.md#place-and-turn-apart`).

use super::Given;
use super::span::{TurnSpan, rotation_vector};
use crate::base::vector::Vec3;

/// The turns from each pose to the next.
pub(super) fn smooth_turns(given: &Given) -> Vec<TurnSpan> {
    let pair = |i: usize| [given.rotations[i], given.rotations[i + 1]];
    let averages: Vec<Vec3> = (0..given.spans()).map(|i| rotation_vector(pair(i)) / given.step(i)).collect();
    let nodes = node_velocities(&averages, given.closed);
    (0..given.spans())
        .map(|i| TurnSpan::hermite(pair(i), [nodes[i], nodes[i + 1]].map(|v| v * given.step(i))))
        .collect()
}

/// Velocities at all nodes from those between them; at the ends without acceleration.
pub(super) fn node_velocities(averages: &[Vec3], closed: bool) -> Vec<Vec3> {
    let last = averages.len();
    if closed {
        let at = |i: usize| harmonic(averages[(i + last - 1) % last], averages[i % last]);
        return (0..=last).map(at).collect();
    }
    if last == 1 {
        return vec![averages[0]; 2];
    }
    let inner = |i: usize| harmonic(averages[i - 1], averages[i]);
    let end = |average: Vec3, inner: Vec3| average * 1.5 - inner * 0.5;
    (0..=last)
        .map(|i| match i {
            0 => end(averages[0], inner(1)),
            i if i == last => end(averages[last - 1], inner(last - 1)),
            i => inner(i),
        })
        .collect()
}

/// The harmonic mean of two velocities: that of the numbers where they have one direction, zero where they are opposite or one of them vanishes.
pub(super) fn harmonic(a: Vec3, b: Vec3) -> Vec3 {
    let [x, y] = [a.length(), b.length()];
    if x + y > 0.0 { a * (y / (x + y)) + b * (x / (x + y)) } else { Vec3::ZERO }
}
