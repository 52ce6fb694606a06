//! Chains of arcs through given balls: exact (`docs/math/tubes.md#through-balls`).

use super::ball::{Ball, Way};
use super::ball_arc::BallArc;
use crate::base::range;
use crate::error::{Error, ErrorItem, PointError, Result, TubeError};

/// Refuses balls that are none.
///
/// # Errors
/// `not-finite`, `parameter-out-of-range`, `radius-not-positive`.
pub(super) fn check(balls: &[Ball]) -> Result<()> {
    for (index, ball) in balls.iter().enumerate() {
        range::check_point(index, ball.center.to_vec())?;
        range::check_radius(ErrorItem::Ball, index, ball.radius)?;
    }
    Ok(())
}

/// The biarcs through balls, with the tangent at each ball of the arc through it and both its neighbors, and at the ends of the arc
/// through the last three.
///
/// # Errors
/// `too-few-points`, `balls-nested`, `tube-turns-back`.
pub(super) fn through(balls: &[Ball], closed: bool) -> Result<Vec<BallArc>> {
    let needed = if closed { 3 } else { 2 };
    if balls.len() < needed {
        return Err(PointError::TooFewPoints { given: balls.len(), needed }.into());
    }
    check(balls)?;
    let n = balls.len();
    let spans = if closed { n } else { n - 1 };
    let ways: Vec<Way> = (0..spans).map(|k| way(balls, k, (k + 1) % n)).collect::<Result<_>>()?;
    if let [only] = ways[..] {
        let ends = [balls[0], balls[1]];
        let nested =
            Error::Tube(TubeError::BallsNested { first: 0, second: 1, distance: only.v.length(), limit: only.r.abs() });
        return Ok(vec![BallArc::straight(ends, 0).ok_or(nested)?]);
    }
    let tangents: Vec<Way> = (0..n).map(|k| tangent(&ways, k, closed)).collect::<Result<_>>()?;
    let mut arcs = Vec::with_capacity(2 * spans);
    for k in 0..spans {
        let next = (k + 1) % n;
        let pair = BallArc::biarc([balls[k], balls[next]], [tangents[k], tangents[next]], k);
        arcs.extend(pair.ok_or(TubeError::TurnsBack { ball: k })?);
    }
    Ok(arcs)
}

fn way(balls: &[Ball], first: usize, second: usize) -> Result<Way> {
    let way = balls[first].to(balls[second]);
    let (distance, limit) = (way.v.length(), way.r.abs());
    if way.square() > 0.0 { Ok(way) } else { Err(TubeError::BallsNested { first, second, distance, limit }.into()) }
}

/// `a/<a,a> + b/<b,b>` of both ways; at an end that of the next ball, mirrored.
fn tangent(ways: &[Way], k: usize, closed: bool) -> Result<Way> {
    let n = ways.len();
    let middle = |before: usize, behind: usize| {
        let sum = [before, behind].map(|i| ways[i] * (1.0 / ways[i].square()));
        (sum[0] + sum[1]).unit().filter(|tangent| [before, behind].iter().all(|&i| tangent.dot(ways[i]) > 0.0))
    };
    let mirrored = |along: usize, tangent: Way| {
        let chord = ways[along];
        let mirrored = chord * (2.0 * tangent.dot(chord) / chord.square()) - tangent;
        mirrored.unit()
    };
    let found = match k {
        _ if closed => middle((k + n - 1) % n, k % n),
        0 => middle(0, 1).and_then(|next| mirrored(0, next)),
        _ if k == n => middle(n - 2, n - 1).and_then(|before| mirrored(n - 1, before)),
        _ => middle(k - 1, k),
    };
    // At an end it is the next ball that has no tangent.
    found.ok_or(Error::Tube(TubeError::TurnsBack { ball: if closed { k } else { k.clamp(1, n - 1) } }))
}
