//! The ends of an open run: what the words of the options mean for its equations (`docs/math/fair-splines.md#ends`).

use super::newton::RunEnd;
use super::options::FairEnd;
use crate::base::vector::Vec3;
use crate::curve::Chord;

/// The ends of a run as its equations know them.
///
/// A run of one chord has no third point: `circle` is an arc there, so that it is straight, or the arc of the tangent
/// given at its other end.
pub(super) fn run_ends(chords: &[Chord], closed: bool, ends: [FairEnd; 2], planar: bool) -> [RunEnd<Vec3>; 2] {
    let [start, end] = ends;
    if closed || chords.len() < 2 {
        return [start, end].map(|end| match end {
            FairEnd::Circle | FairEnd::Arc => RunEnd::Arc,
            FairEnd::Free => RunEnd::Free,
            FairEnd::Clamped(t) => RunEnd::Clamped(t),
        });
    }
    let last = chords.len() - 1;
    let circle = |outer: &Chord, inner: Option<Vec3>| {
        inner.map_or(RunEnd::Arc, |tau| RunEnd::Clamped(circle_tangent(outer.unit, tau, planar)))
    };
    let one = |end: FairEnd, outer: &Chord, pair: [&Chord; 2]| match end {
        FairEnd::Circle => circle(outer, pair[0].tangent_to(pair[1])),
        FairEnd::Arc => RunEnd::Arc,
        FairEnd::Free => RunEnd::Free,
        FairEnd::Clamped(t) => RunEnd::Clamped(t),
    };
    [one(start, &chords[0], [&chords[0], &chords[1]]), one(end, &chords[last], [&chords[last - 1], &chords[last]])]
}

/// The tangent at the end of the circle through the last three points, from its tangent at the inner node. In the plane
/// it never points away from the chord, so that the equations keep their one solution; in space it would leave its
/// sphere by that.
fn circle_tangent(u: Vec3, inner: Vec3, planar: bool) -> Vec3 {
    let t = inner.reflect(u);
    let along = u.dot(t);
    if planar && along < 0.0 { (t - u * along).unit().unwrap_or(u) } else { t.unit().unwrap_or(u) }
}
