//! End faces of a part of a turn, where the profile lies in one half plane of the axis and a point inside sees all of it: ruled faces
//! run from there to the pieces, planar, exact along them, with three sides.
//!
//! A point `c` sees the whole of a closed curve, strictly, if it is on the inner side of all its tangents; the rulings to it cross the curve nowhere else
//! then and follow each other round.

use super::profile::Profile;
use super::{PLACES, Revolution};
use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve as _;
use crate::error::Result;
use crate::rational::RationalBezierSurface;
use crate::topology::{EdgeCurve, FaceEdge, Sewing};

/// A profile is in one half plane of the axis if its places leave it by less than this part of its size.
const PLANAR: f64 = 1e-12;
/// The point is farther from all tangents than this part of the size: nearer to them faces would be needles.
const INSIDE: f64 = 1e-3;
/// Steps in which it is looked for, and by what part each is shorter than the one before.
const STEPS: u32 = 1000;
const SHORTER: f64 = 0.99;

/// A place of a profile in its half plane (distance from the axis, height) and the direction there.
struct Place {
    at: [f64; 2],
    along: [f64; 2],
}

impl Place {
    /// How far a point is to the left of the tangent.
    fn left(&self, c: [f64; 2]) -> f64 {
        self.along[0] * (c[1] - self.at[1]) - self.along[1] * (c[0] - self.at[0])
    }
}

/// The point in the half plane of a profile that goes round an area, from which the whole of it is seen, if there is one.
pub(super) fn centre(turn: &Revolution, profile: &Profile) -> Option<Point3> {
    let places = places(turn, profile)?;
    let next = |k: usize| places[(k + 1) % places.len()].at;
    let area: f64 = (0..places.len()).map(|k| places[k].at[0] * next(k)[1] - places[k].at[1] * next(k)[0]).sum();
    let sign = if area > 0.0 { 1.0 } else { -1.0 };
    let count = places.len() as f64;
    let mut c = [0, 1].map(|d: usize| places.iter().map(|place| place.at[d]).sum::<f64>() / count);
    let mut best = (f64::NEG_INFINITY, c);
    let mut step = 0.5 * profile.size;
    for _ in 0..STEPS {
        // Away from the tangent that is nearest, or that it is farthest outside of.
        let worst = places.iter().min_by(|a, b| (sign * a.left(c)).total_cmp(&(sign * b.left(c))))?;
        let inside = sign * worst.left(c);
        if inside > best.0 {
            best = (inside, c);
        }
        c = [c[0] - sign * step * worst.along[1], c[1] + sign * step * worst.along[0]];
        step *= SHORTER;
    }
    let (inside, [distance, height]) = best;
    let outwards = outwards(turn, profile)?;
    (inside > INSIDE * profile.size).then(|| turn.origin + outwards * distance + turn.axis * height)
}

/// The direction off the axis of the place farthest from it.
fn outwards(turn: &Revolution, profile: &Profile) -> Option<Vec3> {
    let middles =
        profile.pieces.iter().flat_map(|piece| [0.0, 0.5, 1.0].map(|x| turn.way_off_axis(piece.curve.point(x))));
    middles.max_by(|a, b| a.length().total_cmp(&b.length()))?.unit()
}

/// Places all along a profile, the side along the axis among them; `None` unless it lies in one half plane.
fn places(turn: &Revolution, profile: &Profile) -> Option<Vec<Place>> {
    let outwards = outwards(turn, profile)?;
    let mut places = Vec::new();
    for piece in &profile.pieces {
        for k in 0..=PLACES {
            let jet = piece.curve.piece_jet(0, f64::from(k) / f64::from(PLACES));
            let way = turn.way_off_axis(jet.point);
            let off = (way - outwards * way.dot(outwards)).length();
            if off > PLANAR * (profile.size + way.length() + jet.point.to_vec().max_abs()) {
                return None;
            }
            let at = [way.dot(outwards), turn.height(jet.point)];
            let Some(along) = jet.d1.unit() else { continue };
            places.push(Place { at, along: [along.dot(outwards), along.dot(turn.axis)] });
        }
    }
    if !profile.closed {
        let [from, to] = [places.last()?.at, places.first()?.at];
        let along = [0.0, if to[1] > from[1] { 1.0 } else { -1.0 }];
        places.extend([from, to].map(|at| Place { at, along }));
    }
    Some(places)
}

/// One end: the vertices of the joints round the profile, the edges between them, the point that sees them.
pub(super) struct End {
    pub(super) vertices: Vec<usize>,
    pub(super) edges: Vec<usize>,
    pub(super) centre: Point3,
    /// True where the turn ends: its faces have their outside ahead.
    pub(super) last: bool,
}

/// Adds the faces of an end.
///
/// # Errors
/// As [`RationalBezierSurface::new`], [`Arc::segment`](crate::Arc::segment).
pub(super) fn add(sewing: &mut Sewing, end: &End) -> Result<()> {
    let centre = sewing.vertex(end.centre);
    let spokes = end.vertices.iter().map(|&from| sewing.segment(from, centre)).collect::<Result<Vec<_>>>()?;
    let count = end.edges.len();
    for (k, &edge) in end.edges.iter().enumerate() {
        let next = (k + 1) % count;
        let curve: &EdgeCurve = &sewing.edges[edge].curve;
        let c = end.centre;
        let rows: Vec<[f64; 4]> = curve
            .bezier_rows()
            .into_iter()
            .flat_map(|row| [row, [c.x * row[3], c.y * row[3], c.z * row[3], row[3]]])
            .collect();
        let [from, to] = [k, next].map(|k| sewing.vertices[end.vertices[k]]);
        let surface = RationalBezierSurface::new([rows.len() / 2 - 1, 1], rows)?.with_corners([from, to, c, c]);
        let side = |edge: usize| Some(FaceEdge { edge, forward: true });
        sewing.face_along(surface, [side(edge), None, side(spokes[k]), side(spokes[next])], end.last);
    }
    Ok(())
}
