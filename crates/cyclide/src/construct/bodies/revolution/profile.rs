//! A profile made ready to turn: its ends on the axis, what lies along the axis left out, arcs cut to what one face holds.

use super::Revolution;
use super::flat::is_flat;
use super::side::check_side;
use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::LARGEST_ARC;
use crate::construct::bodies::input_chain::{check_connected, check_weights};
use crate::curve::Arc;
use crate::error::{Error, PointError, ProfileError, Result};
use crate::topology::EdgeCurve;

/// Points nearer to the axis than this part of the profile's size are on it, and nothing is said.
const ON_AXIS: f64 = 1e-12;
/// Rounding of coordinates, and of the axis between them, by so many units in the last place.
const ROUNDING: f64 = 16.0;
/// Ends nearer to the axis than this part of the profile's size are meant to be on it: coordinates written with six digits or
/// more. They are moved, and it is said how far.
const NEAR_AXIS: f64 = 1e-6;
/// Arcs and the axis are in one plane if their cosines with its normal are below this.
const COPLANAR: f64 = 1e-12;
/// Rational pieces are straight if their control points leave the chord by less than this part of it.
const STRAIGHT: f64 = 1e-14;

/// A profile on its way to a body.
pub(super) struct Profile {
    pub(super) pieces: Vec<Piece>,
    /// Joints: the start of each piece, and the end of the last one if it is open.
    pub(super) joints: Vec<Joint>,
    pub(super) closed: bool,
    /// Diagonal of its box.
    pub(super) size: f64,
    /// How far ends were moved onto the axis, beyond rounding, and the limit of that.
    pub(super) moved: Option<[f64; 2]>,
    /// True in a plane across the axis.
    pub(super) flat: bool,
    /// The last piece as given that starts on the axis where others end, with the limit of that.
    pub(super) touch: Option<(usize, f64)>,
}

/// A piece that sweeps something.
pub(super) struct Piece {
    pub(super) curve: EdgeCurve,
    /// The direction of its turn at the start, where it lies in a plane with the axis.
    pub(super) across: Option<Vec3>,
}

#[derive(Clone, Copy)]
pub(super) struct Joint {
    pub(super) point: Point3,
    pub(super) on_axis: bool,
}

/// What counts as on the axis, by the size of the profile and the digits of its coordinates.
struct Limits {
    /// Of rounding.
    on_axis: f64,
    /// Of ends that are meant to be there.
    near: f64,
    /// Between pieces that follow each other.
    gap: f64,
}

impl Limits {
    fn new(turn: &Revolution, given: &[EdgeCurve]) -> Self {
        let places = given.iter().flat_map(|piece| [0.0, 0.5, 1.0].map(|x| piece.point(x)));
        let with_feet = places.flat_map(|p| [p, turn.foot(p)]);
        let Some(bounds) = Aabb::of_points(with_feet) else { return Self { on_axis: 0.0, near: 0.0, gap: 0.0 } };
        let size = bounds.diagonal();
        let on_axis = ON_AXIS * size + ROUNDING * f64::EPSILON * bounds.including(turn.given).max_abs();
        Self { on_axis, near: on_axis.max(NEAR_AXIS * size), gap: ON_AXIS * (size + bounds.max_abs()) }
    }
}

/// What is said of a profile of which no piece is off the axis.
fn on_axis(turn: &Revolution, given: &[EdgeCurve], limit: f64) -> Error {
    if given.is_empty() {
        return Error::Point(PointError::TooFewPoints { given: 0, needed: 1 });
    }
    let places = given.iter().flat_map(|piece| [0.0, 0.25, 0.5, 0.75, 1.0].map(|x| piece.point(x)));
    let distance = places.map(|p| p.distance(turn.foot(p))).fold(0.0, f64::max);
    Error::Profile(ProfileError::OnAxis { distance, limit })
}

impl Profile {
    pub(super) fn new(turn: &Revolution, given: &[EdgeCurve], closed: bool) -> Result<Self> {
        let limits = Limits::new(turn, given);
        check_connected(given, closed, limits.gap)?;
        given.iter().enumerate().try_for_each(|(index, piece)| check_weights(piece, index))?;
        let along_axis: Vec<bool> = given.iter().map(|piece| is_along_axis(turn, piece, limits.near)).collect();
        let (joints, moved) = joints(turn, given, closed, &along_axis, &limits);
        let ends_on_axis = joints.first().zip(joints.last()).is_some_and(|(a, b)| a.on_axis && b.on_axis);
        let flat = is_flat(turn, given, (closed || ends_on_axis).then_some(limits.on_axis))?;
        let moved = (moved > 0.0).then_some([moved, limits.near]);
        let mut new = Self { pieces: Vec::new(), joints: Vec::new(), closed, size: 0.0, moved, flat, touch: None };
        let mut side: Option<Vec3> = None;
        let order = in_order(&along_axis, closed);
        for (index, piece) in order.map(|index| (index, &given[index])).filter(|(index, _)| !along_axis[*index]) {
            let ends = [joints[index], joints[(index + 1) % joints.len()]];
            let [start, end] = ends.map(|joint| Some(joint.point));
            let curve = segment(piece).unwrap_or_else(|| piece.clone()).with_ends(start, end);
            check_side(turn, (&curve, ends.map(|joint| joint.on_axis)), index, limits.on_axis, &mut side)?;
            if ends[0].on_axis && !new.pieces.is_empty() {
                new.touch = Some((index, limits.on_axis));
            }
            new.add(turn, &curve, ends)?;
        }
        if new.pieces.is_empty() {
            return Err(on_axis(turn, given, limits.near));
        }
        let places = new.pieces.iter().flat_map(|piece| [0.0, 0.25, 0.5, 0.75, 1.0].map(|x| piece.curve.point(x)));
        new.size = Aabb::of_points(places).map_or(0.0, |b| b.diagonal());
        new.close();
        match new.touching() {
            // Of two cones tip to tip nothing is one shell.
            Some(error) if !new.is_ring() => Err(error),
            _ => Ok(new),
        }
    }

    /// What is said of a profile that touches the axis between its ends.
    pub(super) fn touching(&self) -> Option<Error> {
        self.touch.map(|(piece, limit)| Error::Profile(ProfileError::CrossesAxis { piece, distance: 0.0, limit }))
    }

    /// Whether it ends where it starts.
    fn is_ring(&self) -> bool {
        self.closed || self.first_point() == self.last_point()
    }

    /// Adds the parts of a curve between two joints.
    fn add(&mut self, turn: &Revolution, curve: &EdgeCurve, [start, end]: [Joint; 2]) -> Result<()> {
        for part in parts(curve)? {
            if self.joints.last().is_none_or(|last| last.point != part.start()) {
                self.joints.push(Joint { point: part.start(), on_axis: start.on_axis && part.start() == start.point });
            }
            let across = across(turn, &part);
            self.joints.push(Joint { point: part.end(), on_axis: end.on_axis && part.end() == end.point });
            self.pieces.push(Piece { curve: part, across });
        }
        Ok(())
    }

    /// With a piece left out on the axis it is open, from pole to pole.
    fn close(&mut self) {
        let [first, last] = [self.joints[0], self.joints[self.joints.len() - 1]];
        let ring = self.joints.len() == self.pieces.len() + 1 && first.point == last.point && !first.on_axis;
        self.closed = self.closed && ring;
        if self.closed {
            self.joints.pop();
        }
    }

    /// The curves of the pieces.
    pub(super) fn curves(&self) -> Vec<EdgeCurve> {
        self.pieces.iter().map(|piece| piece.curve.clone()).collect()
    }

    /// The same profile run backwards, or in other parts.
    pub(super) fn with_curves(&self, turn: &Revolution, curves: Vec<EdgeCurve>) -> Self {
        let poles: Vec<Point3> = self.joints.iter().filter(|joint| joint.on_axis).map(|joint| joint.point).collect();
        let end = curves.last().filter(|_| !self.closed).map(EdgeCurve::end);
        let points = curves.iter().map(EdgeCurve::start).chain(end);
        let joints = points.map(|point| Joint { point, on_axis: poles.contains(&point) }).collect();
        let pieces = curves.into_iter().map(|curve| Piece { across: across(turn, &curve), curve }).collect();
        Self { pieces, joints, ..*self }
    }

    /// Where it starts.
    pub(super) fn first_point(&self) -> Point3 {
        self.joints.first().map_or(Point3::ORIGIN, |joint| joint.point)
    }

    /// Where it ends: a closed one where it starts.
    pub(super) fn last_point(&self) -> Point3 {
        let last = if self.closed { self.joints.first() } else { self.joints.last() };
        last.map_or(Point3::ORIGIN, |joint| joint.point)
    }

    /// The places on the axis at which a profile that ends where it starts goes on.
    pub(super) fn pinches(&self) -> Vec<Point3> {
        if !self.is_ring() {
            return Vec::new();
        }
        let starts = &self.joints[..self.pieces.len()];
        starts.iter().filter(|joint| joint.on_axis).map(|joint| joint.point).collect()
    }

    /// True if it goes round an area, by itself or with the axis: in a whole turn it sweeps a solid.
    pub(super) fn encloses(&self) -> bool {
        self.closed || self.joints.first().zip(self.joints.last()).is_some_and(|(a, b)| a.on_axis && b.on_axis)
    }

    /// The distances of both ends from the axis.
    pub(super) fn ends_off_axis(&self, turn: &Revolution) -> [f64; 2] {
        let off = |joint: Option<&Joint>| joint.map_or(0.0, |joint| turn.way_off_axis(joint.point).length());
        [off(self.joints.first()), off(self.joints.last())]
    }
}

/// The pieces in the order in which they are turned: with pieces along the axis a closed profile starts after one of them.
fn in_order(along_axis: &[bool], closed: bool) -> impl Iterator<Item = usize> + use<> {
    let count = along_axis.len();
    let after_axis = |k: &usize| along_axis[(k + count - 1) % count] && !along_axis[*k];
    let first = (0..count).find(after_axis).filter(|_| closed).unwrap_or(0);
    (0..count).map(move |k| (first + k) % count)
}

/// Whether a piece runs along the axis, where it sweeps nothing.
fn is_along_axis(turn: &Revolution, piece: &EdgeCurve, limit: f64) -> bool {
    [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().all(|x| turn.way_off_axis(piece.point(x)).length() <= limit)
}

/// The joints of the pieces: ends of an open profile and of pieces along the axis are moved onto it from near it, all others if they are
/// there but for rounding. Also the farthest move that is more than rounding.
fn joints(
    turn: &Revolution,
    given: &[EdgeCurve],
    closed: bool,
    along_axis: &[bool],
    limits: &Limits,
) -> (Vec<Joint>, f64) {
    let count = given.len() + usize::from(!closed);
    let mut farthest = 0.0_f64;
    let joint = |k: usize| {
        let point = given.get(k).map_or_else(|| given[k - 1].end(), EdgeCurve::start);
        let before = if k > 0 { Some(k - 1) } else { closed.then(|| given.len() - 1) };
        let meant = (!closed && (k == 0 || k == given.len()))
            || along_axis.get(k) == Some(&true)
            || before.is_some_and(|k| along_axis[k]);
        let distance = turn.way_off_axis(point).length();
        let on_axis = distance <= if meant { limits.near } else { limits.on_axis };
        if on_axis && distance > limits.on_axis {
            farthest = farthest.max(distance);
        }
        Joint { point: if on_axis { turn.foot(point) } else { point }, on_axis }
    };
    let joints = if given.is_empty() { Vec::new() } else { (0..count).map(joint).collect() };
    (joints, farthest)
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
