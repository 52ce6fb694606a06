//! `curve` without a kind draws a smooth curve through the points: the warning where they are corners of an outline.

use cyclide::{Point3, ShortNumber, construct::outline_corners, curve::ParamCurve, model::Model};

/// Places on a piece at which it is compared with its edge.
const PLACES: u32 = 8;
/// A corner turns by more than samples of a curve do.
const SHARP: f64 = 65.0 * std::f64::consts::PI / 180.0;
/// Fewer corners make no outline, but a closed one of few points or by a long edge: one closed by that, or in a point, has one or two.
const FEWEST: usize = 3;
const FEW_POINTS: usize = 64;
/// A long edge is this many times as long as they usually are.
const LONG: f64 = 3.0;
/// A curve that leaves an edge by this part of its length bulges: its corners may turn by less.
const BULGE: f64 = 0.12;
/// Farther from the edges than this part of their lengths, a curve is another figure.
const FAR: f64 = 0.02;

/// A warning for each curve whose points read as an outline.
pub fn warnings(model: &Model) -> Vec<String> {
    let curves = model.items.iter().flat_map(|item| item.curves().iter().map(|curve| (&item.name, curve.as_curve())));
    let said = |(name, curve): (&String, &dyn ParamCurve)| {
        let points: Vec<Point3> = nodes(curve);
        let (corners, sides) = outline_corners(&points, curve.is_closed());
        let (distance, edge) = farthest(curve);
        // Smooth curves through few points turn by less.
        let n = points.len();
        let turn = |i: &usize| (points[*i] - points[(i + n - 1) % n]).angle(points[(i + 1) % n] - points[*i]);
        let is_outline = if corners.iter().any(|i| turn(i) > SHARP) {
            let is_simple = points.len() <= FEW_POINTS || edge > LONG * usual_edge(&points);
            corners.len() >= FEWEST || (curve.is_closed() && is_simple)
        } else {
            corners.len() >= FEWEST && distance > BULGE * edge
        };
        if sides.is_empty() && !is_outline {
            return None;
        }
        let what = match (corners.len(), sides.len()) {
            (0, 0) => return None,
            (0, count) => format!("straight sides of an outline ({count})"),
            (count, _) => format!("corners of an outline ({count} of {})", points.len()),
        };
        (distance > FAR * edge).then(|| {
            format!(
                "{name}: the points look like {what}, but the smooth curve through them deviates from their edges by \
                 up to {} {}; use `--kind arc-fit --tolerance T` for an outline, or `--kind fair-spline` if a smooth \
                 curve is intended [read-as-curve]",
                ShortNumber(distance),
                model.units.symbol()
            )
        })
    };
    curves.filter_map(said).collect()
}

/// The points between the pieces.
fn nodes(curve: &dyn ParamCurve) -> Vec<Point3> {
    let count = curve.piece_count();
    let mut points: Vec<Point3> = (0..count).map(|piece| curve.piece_point(piece, 0.0)).collect();
    if !curve.is_closed() && count > 0 {
        points.push(curve.piece_point(count - 1, 1.0));
    }
    points
}

/// The median edge between points.
fn usual_edge(points: &[Point3]) -> f64 {
    let mut edges: Vec<f64> = points.windows(2).map(|w| w[0].distance(w[1])).collect();
    edges.sort_by(f64::total_cmp);
    edges.get(edges.len() / 2).copied().unwrap_or(0.0)
}

/// How far the curve is from the edges between its points, and how long that edge is.
fn farthest(curve: &dyn ParamCurve) -> (f64, f64) {
    let of = |piece: usize| {
        let [start, end] = [0.0, 1.0].map(|s| curve.piece_point(piece, s));
        let edge = end - start;
        let off = |k: u32| {
            let v = curve.piece_point(piece, f64::from(k) / f64::from(PLACES)) - start;
            let t = (v.dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
            (v - edge * t).length()
        };
        ((1..PLACES).map(off).fold(0.0, f64::max), edge.length())
    };
    (0..curve.piece_count()).map(of).fold((0.0, 0.0), |most, at| if at.0 > most.0 { at } else { most })
}
