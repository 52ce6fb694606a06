//! Single points that jump ahead along the way, or back, and return: off the curve by little, and yet far from where they belong
//! (`docs/math/fair-fits.md#outliers`).

use super::beside::around;
use super::chords::median;
use crate::base::vector::{Point3, Vec3};

/// Both edges at such a point are this many times as long as those around it usually are,
const LONG: f64 = 5.0;
/// it turns back by more than this, 150 degrees,
const BACK: f64 = 5.0 / 6.0 * std::f64::consts::PI;
/// and it goes along the way of the points around it, to this cosine: the tip of a tooth goes across.
const ALONG: f64 = 0.8;
/// The way is that between points so many before and after.
const WAY: isize = 4;
/// Edges on either side that are compared.
const AROUND: isize = 10;
/// One in so many points may be one.
const FEW: usize = 20;

/// The positions of such points, rising; `protected` ones are none.
pub(super) fn jumps(points: &[Point3], closed: bool, protected: &dyn Fn(usize) -> bool) -> Vec<usize> {
    let jumps = |i: &usize| !protected(*i) && is_jump(points, closed, *i as isize).unwrap_or(false);
    let found: Vec<usize> = (0..points.len()).filter(jumps).collect();
    if found.len() * FEW > points.len() { Vec::new() } else { found }
}

fn is_jump(points: &[Point3], closed: bool, i: isize) -> Option<bool> {
    let at = |offset: isize| around(points, i + offset, closed);
    let [ahead, back] = [at(0)? - at(-1)?, at(1)? - at(0)?];
    let edge = |offset: isize| Some(at(offset)?.distance(at(offset + 1)?));
    let mut usual: Vec<f64> = (-AROUND..AROUND).filter(|offset| ![-1, 0].contains(offset)).filter_map(edge).collect();
    let long = LONG * median(&mut usual);
    let way = at(WAY)? - at(-WAY)?;
    let is_along = |edge: Vec3| edge.dot(way).abs() > ALONG * edge.length() * way.length();
    Some(
        ahead.length().min(back.length()) > long
            && ahead.angle(back) > BACK
            && way.length() > 0.0
            && is_along(ahead)
            && is_along(back),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A way with noise above its steps; a tooth across it, and a point that jumps along it.
    #[test]
    fn jumps_along_the_way_are_found_and_teeth_across_it_are_not() {
        let noise = |i: u32| 2.0 * (f64::from(i * i) * 0.7).sin();
        let place = |i: u32| {
            let s = 2.0 * f64::from(i);
            Point3::new(100.0 * (0.01 * s).cos() + noise(i), 100.0 * (0.01 * s).sin() + noise(i + 50), 0.0)
        };
        let points: Vec<Point3> = (0..200).map(place).collect();
        assert_eq!(jumps(&points, false, &|_| false), [0; 0]);
        for by in [40.0, -40.0, 120.0] {
            for at in [30, 120] {
                let mut wrong = points.clone();
                let way = (points[at + 4] - points[at - 4]).unit().unwrap();
                wrong[at] += way * by;
                assert_eq!(jumps(&wrong, false, &|_| false), [at], "{by}");
                assert_eq!(jumps(&wrong, false, &|i| i == at), [0; 0]);
                let mut tooth = points.clone();
                tooth[at] += Point3::ORIGIN - points[at];
                assert_eq!(jumps(&tooth, false, &|_| false), [0; 0]);
            }
        }
    }
}
