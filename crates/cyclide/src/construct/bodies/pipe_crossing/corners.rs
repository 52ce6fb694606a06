//! The corners of the holes of a crossing: where the contacts run at 45 degrees to their pipes.

use super::ball_loop::Balls;
use crate::error::Result;
use std::f64::consts::{PI, TAU};

/// Angles at which a corner is looked for first, and steps in which it is then narrowed down.
const PLACES: u32 = 128;
const STEPS: u32 = 60;
/// Corners of both holes nearer to each other than this, in angles of balls, are one node.
const NEAR: f64 = 0.1;

/// Where half of a loop of balls is parted.
pub(super) struct Corners {
    /// Angles from the start of the half to its end, half a turn on.
    pub(super) bounds: Vec<f64>,
    /// For both pipes the corners towards its end, at low and at high angles: the number of the bound, and whether it is that half a turn on.
    pub(super) of_pipes: [[(usize, bool); 2]; 2],
}

/// A corner: the angle of its ball in the half turn, and whether it is in the other half.
#[derive(Debug, Clone, Copy)]
struct Mark {
    pipe: usize,
    high: usize,
    at: f64,
    turned: bool,
}

impl Corners {
    /// # Errors
    /// As [`SkewCylinders::ball`](crate::SkewCylinders::ball).
    pub(super) fn new(balls: &Balls<'_>) -> Result<Self> {
        let mut marks = Vec::with_capacity(4);
        for (pipe, high) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let angle = corner(balls, pipe, high)?;
            marks.push(Mark { pipe, high, at: angle % PI, turned: angle >= PI });
        }
        marks.sort_by(|a, b| a.at.total_cmp(&b.at));
        // Half of the loop starts in the middle of the widest gap, which may be that round the end of the half turn.
        let gap = |k: usize| if k == 0 { marks[0].at + PI - marks[3].at } else { marks[k].at - marks[k - 1].at };
        let widest = (0..4).max_by(|&a, &b| gap(a).total_cmp(&gap(b))).unwrap_or(0);
        let start = marks[widest].at - 0.5 * gap(widest);
        marks.rotate_left(widest);
        for (k, mark) in marks.iter_mut().enumerate() {
            if k >= 4 - widest {
                // Half a turn on it is the opposite corner.
                (mark.at, mark.turned) = (mark.at + PI, !mark.turned);
            }
        }
        let mut corners = Self { bounds: vec![start], of_pipes: [[(0, false); 2]; 2] };
        let mut nodes: Vec<Vec<Mark>> = Vec::new();
        for mark in marks {
            match nodes.last_mut() {
                Some(node) if node.len() == 1 && node[0].pipe != mark.pipe && mark.at - node[0].at < NEAR => {
                    node.push(mark);
                }
                _ => nodes.push(vec![mark]),
            }
        }
        for node in nodes {
            for mark in &node {
                corners.of_pipes[mark.pipe][mark.high] = (corners.bounds.len(), mark.turned);
            }
            corners.bounds.push(node.iter().map(|mark| mark.at).sum::<f64>() / node.len() as f64);
        }
        corners.bounds.push(start + PI);
        Ok(corners)
    }
}

/// The angle of the ball whose contact is farthest towards the end of a pipe and, at 45 degrees to that, towards low or high angles.
fn corner(balls: &Balls<'_>, pipe: usize, high: usize) -> Result<f64> {
    let pair = balls.pair();
    let [way, across] = pair.second_axis();
    let round = pair.radii()[pipe] * if high == 0 { -1.0 } else { 1.0 };
    let lead = |theta: f64| {
        let ball = balls.ball(theta)?;
        let (center, normal) = (ball.center.to_vec(), ball.normals[pipe]);
        Ok(if pipe == 0 {
            center.x + round * normal.y.atan2(normal.z)
        } else {
            center.dot(way) + round * normal.dot(across).atan2(-normal.z)
        })
    };
    let step = TAU / f64::from(PLACES);
    let mut best = (0.0, f64::NEG_INFINITY);
    for k in 0..PLACES {
        let theta = step * f64::from(k);
        let value = lead(theta)?;
        if value > best.1 {
            best = (theta, value);
        }
    }
    let (mut low, mut high) = (best.0 - step, best.0 + step);
    for _ in 0..STEPS {
        let thirds = [low + (high - low) / 3.0, high - (high - low) / 3.0];
        if lead(thirds[0])? < lead(thirds[1])? { low = thirds[0] } else { high = thirds[1] }
    }
    Ok((0.5 * (low + high)).rem_euclid(TAU) % TAU)
}
