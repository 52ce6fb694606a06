//! Where two segments are nearest to each other.

use super::vector::Point3;

/// The distance of two segments, either of which may be a point, and where on each it is, from 0 to 1.
pub(crate) fn nearest_of_segments([[a, b], [c, d]]: [[Point3; 2]; 2]) -> (f64, [f64; 2]) {
    let (u, v, w) = (b - a, d - c, a - c);
    let (uu, uv, vv, uw, vw) = (u.dot(u), u.dot(v), v.dot(v), u.dot(w), v.dot(w));
    let inside = |x: f64| if x.is_finite() { x.clamp(0.0, 1.0) } else { 0.0 };
    let to_second = |s: f64| inside((uv * s + vw) / vv);
    let to_first = |t: f64| inside((uv * t - uw) / uu);
    // The least is inside both or at an end of one.
    let starts = [inside((uv * vw - vv * uw) / (uu * vv - uv * uv)), 0.0, 1.0];
    let starts = starts.map(|s| [to_first(to_second(s)), to_second(s)]);
    let ends = [0.0, 1.0].map(|t| [to_first(t), t]);
    let all = starts.into_iter().chain(ends).map(|[s, t]| ((a + u * s).distance(c + v * t), [s, t]));
    all.min_by(|x, y| x.0.total_cmp(&y.0)).unwrap_or((0.0, [0.0; 2]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_pair_of_places_is_nearer() {
        let point = |x: f64, y: f64, z: f64| Point3::new(x, y, z);
        let one = [point(0.0, 0.0, 0.0), point(4.0, 0.0, 0.0)];
        for (other, expected) in [
            ([point(1.0, -1.0, 2.0), point(1.0, 3.0, 2.0)], 2.0),
            ([point(5.0, 0.0, 0.0), point(9.0, 0.0, 0.0)], 1.0),
            ([point(-3.0, 1.0, 0.0), point(9.0, 1.0, 0.0)], 1.0),
            ([point(7.0, 4.0, 0.0), point(7.0, 4.0, 0.0)], 5.0),
            ([point(6.0, -1.0, 0.0), point(3.0, 2.0, 0.0)], 0.5_f64.sqrt()),
        ] {
            let (distance, [s, t]) = nearest_of_segments([one, other]);
            let at = |[a, b]: [Point3; 2], x: f64| a + (b - a) * x;
            assert!((at(one, s).distance(at(other, t)) - distance).abs() < 1e-15);
            assert!((distance - expected).abs() < 1e-14, "{distance} {expected}");
            for k in 0..=20 {
                for l in 0..=20 {
                    let pair = [at(one, f64::from(k) / 20.0), at(other, f64::from(l) / 20.0)];
                    assert!(pair[0].distance(pair[1]) >= distance - 1e-14);
                }
            }
        }
    }
}
