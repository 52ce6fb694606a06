//! On which side of the axis a profile lies.

use super::{PLACES, Revolution};
use crate::base::golden_section::GoldenSection;
use crate::base::vector::Vec3;
use crate::curve::ParamCurve as _;
use crate::error::{Error, ProfileError, Result};
use crate::topology::EdgeCurve;

/// Sections for the place nearest to the axis: half of the digits, as a least value has them.
const SECTIONS: u32 = 40;
/// Directions off the axis are in one plane with it if the sine between them is below this.
const ONE_PLANE: f64 = 1e-9;

/// Refuses a piece that meets the axis inside, or lies on another side of it than those before, as far as they are in one plane
/// with it.
///
/// # Errors
/// `crosses-axis`.
pub(super) fn check_side(
    turn: &Revolution,
    (curve, on_axis): (&EdgeCurve, [bool; 2]),
    piece: usize,
    limit: f64,
    side: &mut Option<Vec3>,
) -> Result<()> {
    let way = |k: u32| turn.way_off_axis(curve.point(f64::from(k) / f64::from(PLACES)));
    let crosses = |distance: f64| Error::Profile(ProfileError::CrossesAxis { piece, distance, limit });
    let [first, last] = [u32::from(on_axis[0]), PLACES - u32::from(on_axis[1])];
    for k in first..=last {
        let v = way(k);
        let radius = v.length();
        let before = side.get_or_insert(v);
        // Within its plane it changes its side where the direction turns round.
        let turned = v.dot(*before) < 0.0 && v.cross(*before).length() <= ONE_PLANE * radius * before.length();
        let inside = k > 0 && k < PLACES;
        let nearest = inside && way(k - 1).length() >= radius && way(k + 1).length() >= radius;
        let least = if nearest { least_along(turn, curve, k, v) } else { radius };
        if radius.min(least) <= limit || turned {
            return Err(crosses(radius.min(least.abs())));
        }
    }
    // Beside a pole it is away from the axis at the first place, but may come there from the other side.
    for (pole, k) in
        [(0.0, 1), (1.0, PLACES - 1)].into_iter().zip(on_axis).filter_map(|(end, pole)| pole.then_some(end))
    {
        let v = way(k);
        if leaves_backwards(turn, curve, pole, v) {
            return Err(crosses(least_along(turn, curve, k, v).abs()));
        }
    }
    Ok(())
}

/// Whether a curve leaves the axis, with its end at `pole`, away from a way off the axis that it has near it.
fn leaves_backwards(turn: &Revolution, curve: &EdgeCurve, pole: f64, way: Vec3) -> bool {
    let jet = curve.piece_jet(0, pole);
    let off = |v: Vec3| v - turn.axis * v.dot(turn.axis);
    let inwards = if pole > 0.5 { -jet.d1 } else { jet.d1 };
    // Where it leaves along the axis, the second derivative says where to.
    let leaving =
        Some(off(inwards)).filter(|v| v.length() > ONE_PLANE * jet.d1.length()).unwrap_or_else(|| off(jet.d2));
    leaving.dot(way) < 0.0 && leaving.cross(way).length() <= ONE_PLANE.sqrt() * leaving.length() * way.length()
}

/// The least part of the way off the axis along the one at place `k`, between its neighbors, where the curve stays in a plane with
/// the axis there: it is negative where the curve crosses the axis between two places. By sections in the golden ratio.
fn least_along(turn: &Revolution, curve: &EdgeCurve, k: u32, way: Vec3) -> f64 {
    let Some(along) = way.unit() else { return 0.0 };
    let off = |x: f64| turn.way_off_axis(curve.point(x));
    let ends = [k - 1, k + 1].map(|k| f64::from(k) / f64::from(PLACES));
    let least = off(GoldenSection::lowest(|x| off(x).dot(along), ends, SECTIONS));
    if least.cross(along).length() <= ONE_PLANE * way.length() { least.dot(along) } else { least.length() }
}
