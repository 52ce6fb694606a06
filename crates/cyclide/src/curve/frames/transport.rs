//! A normal carried along a curve without turning about the tangent, by double reflection.
//!
//! From one place to the next the frame is reflected in the plane halfway between the points, then in the one that takes the
//! reflected tangent to the tangent there (W. Wang, B. Jüttler, D. Zheng, Y. Liu, *Computation of rotation minimizing frames*,
//! ACM Transactions on Graphics 27, 2008): exact in a plane, on circles and lines, and of the fourth order elsewhere. Steps are halved
//! until one step and two halves agree within their share of the tolerance, by length; the halves are kept. At a kink the
//! frame turns by the smallest rotation that takes one tangent to the other.

use super::{across, no_frame};
use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve;
use crate::error::{Error, NumberError, Result};

/// Halvings of a piece.
const DEPTH: u32 = 40;
/// Most places kept.
const MOST_PLACES: usize = 4_000_000;
/// Turns of the tangent within a rounding of half a turn have no smallest rotation, radians.
const TURNED_BACK: f64 = 1e-7;
/// Roundings of a direction, and of points over their distance, by which steps may differ.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// Chords over coordinates whose direction may be off by a hundred thousandth by rounding: its square is what frames are then off by.
const SHORT_CHORD: f64 = 1e5 * f64::EPSILON;

/// A place with its normal.
#[derive(Debug, Clone, Copy)]
struct Carried {
    piece: usize,
    s: f64,
    point: Point3,
    tangent: Vec3,
    normal: Vec3,
}

/// The normal at places along the whole curve.
#[derive(Debug)]
pub(super) struct Transport<'a> {
    curve: &'a dyn ParamCurve,
    places: Vec<Carried>,
    holonomy: Option<f64>,
    error: f64,
}

impl<'a> Transport<'a> {
    pub(super) fn new(curve: &'a dyn ParamCurve, total: f64, start: Option<Vec3>, tolerance: f64) -> Result<Self> {
        let mut made = Self { curve, places: Vec::new(), holonomy: None, error: 0.0 };
        for piece in 0..curve.piece_count() {
            // A piece without extent has no tangent: the frame stays.
            let (Some(first), Some(_)) = (made.tangent(piece, 0.0, 1.0), made.tangent(piece, 1.0, -1.0)) else {
                continue;
            };
            let normal = match made.places.last() {
                Some(last) => turned(last.tangent, first, last.normal).ok_or_else(|| made.turned_back(piece, 0.0))?,
                None => first_normal(start, first)?,
            };
            made.places.push(Carried { piece, s: 0.0, point: curve.piece_point(piece, 0.0), tangent: first, normal });
            made.carry(piece, tolerance / total)?;
        }
        if let (true, Some(first), Some(last)) = (curve.is_closed(), made.places.first(), made.places.last()) {
            let arrived = turned(last.tangent, first.tangent, last.normal);
            let arrived = arrived.ok_or_else(|| made.turned_back(curve.piece_count() - 1, 1.0))?;
            made.holonomy = Some(first.tangent.dot(first.normal.cross(arrived)).atan2(first.normal.dot(arrived)));
        }
        Ok(made)
    }

    pub(super) fn holonomy(&self) -> Option<f64> {
        self.holonomy
    }

    pub(super) fn measured_error(&self) -> f64 {
        self.error
    }

    /// The normal at a place: one step from the place before that was kept. `None` before the first.
    pub(super) fn normal(&self, (piece, s): (usize, f64), point: Point3, tangent: Vec3) -> Option<Vec3> {
        let index = self.places.partition_point(|place| (place.piece, place.s) <= (piece, s)).checked_sub(1)?;
        Some(step(&self.places[index], point, tangent))
    }

    fn tangent(&self, piece: usize, s: f64, side: f64) -> Option<Vec3> {
        self.curve.piece_jet(piece, s).limit_tangent(side)
    }

    fn turned_back(&self, piece: usize, s: f64) -> Error {
        let t = (piece as f64 + s) / self.curve.piece_count() as f64;
        no_frame("the angle that the turn of the tangent leaves of half a turn", t, 0.0, TURNED_BACK)
    }

    /// Carries the last normal over a piece; `share` is the tolerance by length.
    fn carry(&mut self, piece: usize, share: f64) -> Result<()> {
        let mut ahead = vec![(1.0, DEPTH)];
        while let Some((to, depth)) = ahead.pop() {
            let Some(&from) = self.places.last() else { return Ok(()) };
            let middle = 0.5 * (from.s + to);
            let ends =
                [middle, to].map(|s| self.tangent(piece, s, -1.0).map(|t| (self.curve.piece_point(piece, s), t)));
            let [Some((p, t)), Some((q, u))] = ends else { return Err(self.turned_back(piece, middle)) };
            let whole = step(&from, q, u);
            let half = Carried { piece, s: middle, point: p, tangent: t, normal: step(&from, p, t) };
            let both = step(&half, q, u);
            let difference = (whole - both).length();
            let (l, m) = (from.point.distance(p), p.distance(q));
            let reach = from.point.to_vec().max_abs().max(q.to_vec().max_abs());
            let rounding = ROUNDINGS * (1.0 + reach / (l + m));
            let bends_little = from.tangent.dot(t) > 0.0 && t.dot(u) > 0.0;
            if bends_little && difference <= rounding.max(share * (l + m)) {
                self.error += difference;
                self.places.extend([half, Carried { piece, s: to, point: q, tangent: u, normal: both }]);
            } else if depth == 0 {
                return Err(self.turned_back(piece, middle));
            } else if self.places.len() + ahead.len() > MOST_PLACES {
                let (needed, remedy) = ((MOST_PLACES + 1) as f64, "use a larger tolerance");
                return Err(NumberError::TooManyPieces {
                    what: "piece",
                    segment: Some(piece),
                    needed,
                    cap: MOST_PLACES,
                    remedy,
                }
                .into());
            } else {
                ahead.extend([(to, depth - 1), (middle, depth - 1)]);
            }
        }
        Ok(())
    }
}

/// The first normal of a curve.
fn first_normal(start: Option<Vec3>, tangent: Vec3) -> Result<Vec3> {
    match start {
        Some(direction) => across(direction, tangent, 0.0),
        None => Ok(across(Vec3::Z, tangent, 0.0).unwrap_or_else(|_| tangent.any_perpendicular())),
    }
}

/// The normal after one step: two reflections, and rounding taken off. Over a chord whose direction is rounding the first would be in
/// any plane: there the tangent turns by the smallest rotation.
fn step(from: &Carried, point: Point3, tangent: Vec3) -> Vec3 {
    let chord = point - from.point;
    let reach = from.point.to_vec().max_abs().max(point.to_vec().max_abs());
    if chord.length() <= SHORT_CHORD * reach {
        return turned(from.tangent, tangent, from.normal).unwrap_or(from.normal);
    }
    let (normal, reflected) = (mirrored(from.normal, chord), mirrored(from.tangent, chord));
    let normal = mirrored(normal, tangent - reflected);
    (normal - tangent * normal.dot(tangent)).unit().unwrap_or(from.normal)
}

/// The mirror image in the plane across a vector; what it is where that vanishes.
fn mirrored(v: Vec3, across: Vec3) -> Vec3 {
    match across.unit() {
        Some(n) => v - n * (2.0 * v.dot(n)),
        None => v,
    }
}

/// A normal turned by the smallest rotation that takes its tangent to another; `None` for half a turn.
fn turned(from: Vec3, to: Vec3, normal: Vec3) -> Option<Vec3> {
    let middle = (from + to).unit().filter(|_| from.angle(to) < std::f64::consts::PI - TURNED_BACK)?;
    // Reflected across the tangent and then across the mean of both: the rotation by twice the angle between these.
    let turned = mirrored(mirrored(normal, from), middle);
    (turned - to * turned.dot(to)).unit()
}
