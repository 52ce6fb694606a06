//! Surfaces of revolution, exact (`docs/math/revolution-and-pipes.md#revolution`; source: `000`, section 7, where the
//! weights are those of a half turn).
//!
//! With the rotor `w = (cos Φ/2, sin Φ/2 h)` of the whole angle and the axis through `o`, the point that a profile point `P`
//! of weight `g` has turned to is `x (P - o) x^-1 + o`, `x(t) = (1-t) + w t`: in the parameter t quadratic, with the rows
//!
//! ```text
//! [g P, g],   g [r o + r y + p × y, r],   g [o + y + 2 p × (r y + p × y), 1],     y = P - o, r = cos Φ/2, p = sin Φ/2 h
//! ```
//!
//! So a rational profile of degree n gives a rational surface of degree (n, 2). An arc that lies in a plane with the axis
//! gives more: multiplying a quaternion form `N D^-1` by `x` from the left keeps it one, `(x N)(x D)^-1`, whose corners have
//! the weights `1, u, w, w u`: a principal patch of a torus, sphere, cone, cylinder or plane.

mod meridian;

use crate::base::bounds::Aabb;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::curve::Arc;
use crate::error::{Error, Result};
use crate::rational::{RationalBezier, RationalBezierSurface};
use crate::surface::CyclidePatch;
use crate::topology::{Body, EdgeCurve, FaceEdge, FaceSurface, Shell, ShellEdge, ShellFace};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Points of a profile nearer to the axis than this part of its size are on it.
const ON_AXIS: f64 = 1e-12;
/// Arcs and the axis are in one plane if their cosines with its normal are below this.
const COPLANAR: f64 = 1e-12;
/// A profile is in a plane across the axis if its heights differ by less than this part of its size.
const FLAT: f64 = 1e-6;
/// Rational pieces are straight if their control points leave the chord by less than this part of it.
const STRAIGHT: f64 = 1e-14;
/// Largest angle of an arc of a profile in one face.
const LARGEST_ARC: f64 = TAU / 3.0;
/// Places of a piece at which its side of the axis is looked at.
const PLACES: u32 = 64;

/// Sections for the place nearest to the axis: half of the digits, as a least value has them.
const SECTIONS: usize = 40;

/// A turn about an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Revolution {
    origin: Point3,
    axis: Vec3,
    angle: f64,
}

impl Revolution {
    /// A turn by `angle` radians about the axis through a point along a direction of any length, right-handed for positive
    /// angles; up to a whole turn, which is closed.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates), `zero-axis`, `angle-out-of-range` (beyond a whole turn).
    pub fn new(origin: Point3, axis: Vec3, angle: f64) -> Result<Self> {
        range::check_point(0, origin.to_vec())?;
        if !axis.is_finite() {
            return Err(Error::NotFinite { what: "axis", index: 0 });
        }
        let axis = axis.unit().ok_or(Error::ZeroAxis)?;
        if !(angle.abs() <= TAU * (1.0 + f64::EPSILON)) {
            return Err(Error::AngleOutOfRange { angle, min: -TAU, max: TAU });
        }
        Ok(Self { origin, axis, angle })
    }

    /// True for a whole turn.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.angle.abs() >= TAU * (1.0 - 4.0 * f64::EPSILON)
    }

    /// The point that a point has turned to after an angle.
    #[must_use]
    pub fn turned(&self, p: Point3, angle: f64) -> Point3 {
        let (sin, cos) = (0.5 * angle).sin_cos();
        let (y, h) = (p - self.origin, self.axis * sin);
        self.origin + y + h.cross(y * cos + h.cross(y)) * 2.0
    }

    /// The surface that a rational profile sweeps in one piece, of degree (n, 2). Beyond half a turn weights are negative.
    ///
    /// # Errors
    /// `angle-out-of-range` for a whole turn. An angle of 0 gives a surface that is constant in t.
    pub fn surface(&self, profile: &RationalBezier) -> Result<RationalBezierSurface> {
        if self.is_whole() {
            return Err(Error::AngleOutOfRange { angle: self.angle, min: -TAU, max: TAU });
        }
        let (sin, r) = (0.5 * self.angle).sin_cos();
        let (o, p) = (self.origin.to_vec(), self.axis * sin);
        let rows = profile.rows().iter().flat_map(|&[x, y, z, g]| {
            let from_axis = Vec3::new(x, y, z) - o * g;
            let half = from_axis * r + p.cross(from_axis);
            let (middle, last) = (o * (r * g) + half, o * g + from_axis + p.cross(half) * 2.0);
            [[x, y, z, g], [middle.x, middle.y, middle.z, r * g], [last.x, last.y, last.z, g]]
        });
        RationalBezierSurface::new([profile.degree(), 2], rows.collect())
    }

    /// The body that a profile sweeps, sewn: pieces that follow each other, each from the end of the last one, `closed` if
    /// the end is the start. Arcs in a plane with the axis become patches, all else rational faces, in sectors of a quarter
    /// turn at most. It is a solid, outside outwards, if the turn is whole and the profile is closed or ends on the axis on both
    /// sides. Pieces along the axis sweep nothing.
    ///
    /// # Errors
    /// `angle-out-of-range` (0), `too-few-points` (no piece off the axis), `disconnected`, `crosses-axis` (a piece meets the axis inside, or two lie on
    /// different sides of it), `folded-profile` (in a plane across the axis, away from it and back), `profile-meets-itself` (of what
    /// would be a solid), `weight-not-positive`; `not-a-shell` for a profile that meets the axis more than at its ends;
    /// as [`CyclidePatch::from_weights`].
    pub fn body(&self, profile: &[EdgeCurve], closed: bool) -> Result<Body> {
        if self.angle == 0.0 {
            return Err(Error::AngleOutOfRange { angle: 0.0, min: -TAU, max: TAU });
        }
        let profile = Profile::new(self, profile, closed)?;
        let shell = profile.swept(self)?;
        if shell.is_closed() {
            meridian::check(self, &profile.pieces, profile.size)?;
        }
        Ok(Body { outer: if shell.is_closed() { shell.outside_out() } else { shell }, voids: Vec::new() })
    }

    /// The way of a point from the axis.
    fn way_off_axis(&self, p: Point3) -> Vec3 {
        let v = p - self.origin;
        v - self.axis * v.dot(self.axis)
    }

    fn foot(&self, p: Point3) -> Point3 {
        p - self.way_off_axis(p)
    }
}

/// A profile on its way to a body.
struct Profile {
    pieces: Vec<Piece>,
    /// Joints: the start of each piece, and the end of the last one if it is open.
    joints: Vec<Joint>,
    closed: bool,
    /// Diagonal of its box.
    size: f64,
}

/// A piece that sweeps something.
struct Piece {
    curve: EdgeCurve,
    /// The direction of its turn at the start, where it lies in a plane with the axis.
    across: Option<Vec3>,
}

#[derive(Clone, Copy)]
struct Joint {
    point: Point3,
    on_axis: bool,
}

impl Profile {
    fn new(turn: &Revolution, given: &[EdgeCurve], closed: bool) -> Result<Self> {
        let ends = given.iter().flat_map(|piece| [piece.start(), piece.end()]);
        let size = Aabb::of_points(ends.chain([turn.origin])).map_or(0.0, |b| b.diagonal() + b.max_abs());
        let joint = |p: Point3| {
            let on_axis = turn.way_off_axis(p).length() <= ON_AXIS * size;
            Joint { point: if on_axis { turn.foot(p) } else { p }, on_axis }
        };
        let n = given.len();
        for next in usize::from(!closed)..n {
            let piece = (next + n - 1) % n;
            let (gap, limit) = (given[piece].end().distance(given[next].start()), ON_AXIS * size);
            if gap > limit {
                return Err(Error::Disconnected { piece, next, gap, limit });
            }
        }
        let mut joints: Vec<Joint> = given.iter().map(|piece| joint(piece.start())).collect();
        joints.extend(given.last().filter(|_| !closed).map(|piece| joint(piece.end())));
        let mut new = Self { pieces: Vec::new(), joints: Vec::new(), closed, size: 0.0 };
        let mut side: Option<Vec3> = None;
        for (index, piece) in given.iter().enumerate() {
            if let EdgeCurve::Rational(curve) = piece
                && let Some(row) = curve.rows().iter().find(|row| !(row[3] > 0.0))
            {
                return Err(Error::WeightNotPositive { index, weight: row[3] });
            }
            let (start, end) = (joints[index], joints[(index + 1) % joints.len()]);
            let curve = segment(piece).unwrap_or_else(|| piece.clone()).with_ends(Some(start.point), Some(end.point));
            let along_axis =
                start.on_axis && end.on_axis && turn.way_off_axis(curve.point(0.5)).length() <= ON_AXIS * size;
            if along_axis {
                // Both neighbours end on the axis: the profile goes on there without it.
                continue;
            }
            check_side(turn, (&curve, [start.on_axis, end.on_axis]), index, size, &mut side)?;
            for part in parts(&curve)? {
                let first = new.joints.last().is_none_or(|last: &Joint| last.point != part.start());
                if first {
                    new.joints
                        .push(Joint { point: part.start(), on_axis: start.on_axis && part.start() == start.point });
                }
                let across = across(turn, &part);
                let on_axis = end.on_axis && part.end() == end.point;
                new.joints.push(Joint { point: part.end(), on_axis });
                new.pieces.push(Piece { curve: part, across });
            }
        }
        if new.pieces.is_empty() {
            return Err(Error::TooFewPoints { given: 0, needed: 1 });
        }
        let places = new.pieces.iter().flat_map(|piece| [0.0, 0.25, 0.5, 0.75, 1.0].map(|x| piece.curve.point(x)));
        new.size = Aabb::of_points(places).map_or(0.0, |b| b.diagonal());
        check_not_folded(turn, &new.pieces, new.size)?;
        // With a piece left out on the axis it is open, from pole to pole.
        new.closed = closed && new.joints.len() == new.pieces.len() + 1 && {
            let [first, last] = [new.joints[0], new.joints[new.joints.len() - 1]];
            first.point == last.point && !first.on_axis
        };
        if new.closed {
            new.joints.pop();
        }
        Ok(new)
    }

    /// The shell of all sectors.
    fn swept(&self, turn: &Revolution) -> Result<Shell> {
        let sectors = (turn.angle.abs() / FRAC_PI_2 * (1.0 - 1e-12)).ceil().max(1.0) as usize;
        let step = turn.angle / sectors as f64;
        let whole = turn.is_whole();
        let boundaries = if whole { sectors } else { sectors + 1 };
        let (pieces, joints) = (self.pieces.len(), self.joints.len());
        let next = |j: usize| (j + 1) % joints;
        let (sin, cos) = (0.5 * step).sin_cos();
        let rotor = Quat::new(cos, turn.axis.x * sin, turn.axis.y * sin, turn.axis.z * sin);
        // Joints on the axis are one vertex each, before those that turn.
        let mut vertices: Vec<Point3> = Vec::new();
        let mut of_joint = vec![Vec::new(); joints];
        for (j, joint) in self.joints.iter().enumerate() {
            for k in 0..if joint.on_axis { 1 } else { boundaries } {
                of_joint[j].push(vertices.len());
                let point = if k == 0 { joint.point } else { turn.turned(joint.point, step * k as f64) };
                vertices.push(point);
            }
        }
        let vertex = |j: usize, k: usize| of_joint[j][if self.joints[j].on_axis { 0 } else { k % boundaries }];
        let mut edges = Vec::new();
        let mut meridians = vec![Vec::with_capacity(pieces); boundaries];
        for (k, of_boundary) in meridians.iter_mut().enumerate() {
            let map = rotation(turn, step * k as f64)?;
            for (j, piece) in self.pieces.iter().enumerate() {
                let (start, end) = (vertex(j, k), vertex(next(j), k));
                let curve = match k {
                    0 => piece.curve.clone(),
                    _ => piece.curve.image(&map, vertices[start], vertices[end])?,
                };
                of_boundary.push(edges.len());
                edges.push(ShellEdge { start, end, curve });
            }
        }
        let mut parallels = vec![vec![None; joints]; sectors];
        for (k, of_sector) in parallels.iter_mut().enumerate() {
            for (j, _) in self.joints.iter().enumerate().filter(|(_, joint)| !joint.on_axis) {
                let (start, end) = (vertex(j, k), vertex(j, k + 1));
                let arc = Arc::from_ratio_across(vertices[start], vertices[end], rotor)?;
                of_sector[j] = Some(edges.len());
                edges.push(ShellEdge { start, end, curve: arc.into() });
            }
        }
        let mut faces = Vec::with_capacity(sectors * pieces);
        for k in 0..sectors {
            for (j, piece) in self.pieces.iter().enumerate() {
                let [low, high] = [meridians[k][j], meridians[(k + 1) % boundaries][j]];
                let sides = [Some(low), Some(high), parallels[k][j], parallels[k][next(j)]];
                let sides = sides.map(|edge| edge.map(|edge| FaceEdge { edge, forward: true }));
                let corners = [vertex(j, k), vertex(next(j), k), vertex(j, k + 1), vertex(next(j), k + 1)];
                let corners = corners.map(|v| vertices[v]);
                let across = piece.across.map(|across| rotated(turn, across, step * k as f64));
                let surface = face(turn, &edges[low].curve, &edges[high].curve, across, corners, rotor)?;
                faces.push(ShellFace { surface, sides, same_sense: true });
            }
        }
        Shell::new(vertices, edges, faces)
    }
}

/// The face between a meridian and the next one.
fn face(
    turn: &Revolution,
    low: &EdgeCurve,
    high: &EdgeCurve,
    across: Option<Vec3>,
    corners: [Point3; 4],
    rotor: Quat,
) -> Result<FaceSurface> {
    if let (EdgeCurve::Arc(arc), Some(across)) = (low, across) {
        let along = arc.start_tangent().ok_or(Error::ZeroTangent { index: 0 })?;
        let ratio = arc.weight_ratio();
        let weights = [Quat::ONE, ratio, rotor, rotor * ratio];
        let patch = CyclidePatch::from_weights(corners, weights, along, across)?;
        return Ok(patch.into());
    }
    let (r, p, o) = (rotor.w, rotor.vector(), turn.origin.to_vec());
    let rows = low.bezier_rows().into_iter().zip(high.bezier_rows()).flat_map(|(a, b)| {
        let [x, y, z, g] = a;
        let from_axis = Vec3::new(x, y, z) - o * g;
        let middle = o * (r * g) + from_axis * r + p.cross(from_axis);
        [a, [middle.x, middle.y, middle.z, r * g], b]
    });
    let rows: Vec<[f64; 4]> = rows.collect();
    let degree = rows.len() / 3 - 1;
    Ok(RationalBezierSurface::new([degree, 2], rows)?.with_corners(corners).into())
}

/// The straight segment that a rational curve runs along to rounding, once and forwards: it sweeps a part of a plane, cylinder or
/// cone.
fn segment(piece: &EdgeCurve) -> Option<EdgeCurve> {
    let EdgeCurve::Rational(curve) = piece else { return None };
    let (start, end) = (piece.start(), piece.end());
    let along = (end - start).unit()?;
    let length = start.distance(end);
    let mut before = 0.0;
    for [x, y, z, w] in curve.rows() {
        let way = Point3::new(x / w, y / w, z / w) - start;
        let at = way.dot(along);
        if way.cross(along).length() > STRAIGHT * length || at < before || at > length * (1.0 + STRAIGHT) {
            return None;
        }
        before = at;
    }
    Arc::segment(start, end).ok().map(EdgeCurve::Arc)
}

/// The pieces of a curve that become one face each: arcs of a third of a turn at most.
fn parts(curve: &EdgeCurve) -> Result<Vec<EdgeCurve>> {
    let EdgeCurve::Arc(arc) = curve else { return Ok(vec![curve.clone()]) };
    Ok(arc.in_parts(LARGEST_ARC)?.into_iter().map(EdgeCurve::from).collect())
}

/// The direction in which the start of an arc turns, if it lies in a plane with the axis.
fn across(turn: &Revolution, piece: &EdgeCurve) -> Option<Vec3> {
    let arc = piece.arc()?;
    let farthest = [arc.start(), arc.point_at_length(0.5), arc.end()].map(|p| turn.way_off_axis(p));
    let radial = farthest.into_iter().max_by(|a, b| a.length().total_cmp(&b.length()))?;
    let across = turn.axis.cross(radial.unit()?);
    let within = |v: Vec3| v.unit().is_none_or(|u| u.dot(across).abs() <= COPLANAR);
    let size = radial.length();
    let flat = farthest.into_iter().all(|v| v.dot(across).abs() <= COPLANAR * size);
    (flat && within(arc.chord()) && arc.start_tangent().is_none_or(within)).then_some(across)
}

/// Refuses a piece that meets the axis inside, or lies on another side of it than those before, as far as they are in one plane
/// with it.
fn check_side(
    turn: &Revolution,
    (curve, on_axis): (&EdgeCurve, [bool; 2]),
    piece: usize,
    size: f64,
    side: &mut Option<Vec3>,
) -> Result<()> {
    let way = |k: u32| turn.way_off_axis(curve.point(f64::from(k) / f64::from(PLACES)));
    let [first, last] = [u32::from(on_axis[0]), PLACES - u32::from(on_axis[1])];
    for k in first..=last {
        let v = way(k);
        let radius = v.length();
        let before = side.get_or_insert(v);
        // Within its plane it changes its side where the direction turns round.
        let turned = v.dot(*before) < 0.0 && v.cross(*before).length() <= 1e-9 * radius * before.length();
        let inside = k > 0 && k < PLACES;
        let nearest = inside && way(k - 1).length() >= radius && way(k + 1).length() >= radius;
        let least = if nearest { least_along(turn, curve, k, v, size) } else { radius };
        if radius.min(least) <= ON_AXIS * size || turned {
            return Err(Error::CrossesAxis { piece, distance: radius.min(least.abs()) });
        }
    }
    Ok(())
}

/// The least part of the way off the axis along the one at place `k`, between its neighbours, where the curve stays in a plane with
/// the axis there: it is negative where the curve crosses the axis between two places. By sections in the golden ratio.
fn least_along(turn: &Revolution, curve: &EdgeCurve, k: u32, way: Vec3, size: f64) -> f64 {
    let Some(along) = way.unit() else { return 0.0 };
    let off = |x: f64| turn.way_off_axis(curve.point(x));
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let [mut low, mut high] = [k - 1, k + 1].map(|k| f64::from(k) / f64::from(PLACES));
    for _ in 0..SECTIONS {
        let (x, y) = (high - ratio * (high - low), low + ratio * (high - low));
        if off(x).dot(along) < off(y).dot(along) { high = y } else { low = x }
    }
    let least = off(0.5 * (low + high));
    if least.cross(along).length() <= 1e-9 * size { least.dot(along) } else { least.length() }
}

/// Refuses a profile in a plane across the axis that goes away from it and comes back: what it sweeps is a part of the
/// plane, twice.
fn check_not_folded(turn: &Revolution, pieces: &[Piece], size: f64) -> Result<()> {
    let places = || (0..=PLACES).map(|k| f64::from(k) / f64::from(PLACES));
    let points = || pieces.iter().enumerate().flat_map(|(i, piece)| places().map(move |x| (i, piece.curve.point(x))));
    let height = |p: Point3| (p - turn.origin).dot(turn.axis);
    let heights =
        points().map(|(_, p)| height(p)).fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], z| [lo.min(z), hi.max(z)]);
    if heights[1] - heights[0] > FLAT * size {
        return Ok(());
    }
    let radii: Vec<(usize, f64)> = points().map(|(i, p)| (i, turn.way_off_axis(p).length())).collect();
    let grows = radii.last().zip(radii.first()).is_some_and(|(last, first)| last.1 > first.1);
    let back = radii.windows(2).find(|w| if grows { w[1].1 < w[0].1 } else { w[1].1 > w[0].1 });
    match back {
        Some(&[(piece, distance), _]) => Err(Error::FoldedProfile { piece, distance }),
        _ => Ok(()),
    }
}

fn rotation(turn: &Revolution, angle: f64) -> Result<Mobius> {
    let rotor = Quat::from_axis_angle(turn.axis, angle);
    let o = turn.origin.to_vec();
    Mobius::similarity(rotor, 1.0, o - rotor.rotate(o))
}

fn rotated(turn: &Revolution, v: Vec3, angle: f64) -> Vec3 {
    Quat::from_axis_angle(turn.axis, angle).rotate(v)
}
