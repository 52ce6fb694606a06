//! Where the rulings between two curves `a` and `b` cross.
//!
//! Along a ruling with the direction `d = b - a` the normal `(1-t) a' × d + t b' × d` is linear in t. It vanishes between its ends
//! where both are opposite: all along a piece where the curves run against each other in a plane, at single
//! rulings elsewhere. There the volume `d · (a' × b')` of the three directions is zero, and changes its sign in general. At an end it may vanish: in a tip.

use super::rails::RailPiece;
use crate::base::vector::Vec3;
use crate::error::{BridgeError, Error, Result};

/// Places of a piece at which rulings are looked at, less one.
const PLACES: u32 = 64;
/// Normals and rulings below this part of what they could be are zero.
const ZERO: f64 = 1e-9;
/// How far from an end at which both curves stand still they are looked at instead.
const BESIDE: f64 = 1e-3;
/// Steps in which a place between two others is found.
const STEPS: u32 = 60;

/// A ruling, with the normals at its ends. Directions and derivatives are taken in units of their own lengths, so that neither
/// size nor place of the rails is seen, and no product of them leaves the numbers.
#[derive(Debug, Clone, Copy)]
struct Ruling {
    s: f64,
    length: f64,
    /// In units of `speed`; their directions and lengths are compared with one.
    normals: [Vec3; 2],
    /// The larger of the derivatives at its ends.
    speed: f64,
    volume: f64,
}

impl Ruling {
    fn of(piece: &RailPiece, s: f64) -> Self {
        let [a, b] = piece.curves.each_ref().map(|curve| curve.as_curve().piece_jet(0, s));
        let ruling = b.point - a.point;
        let way = ruling.unit().unwrap_or(Vec3::ZERO);
        let speed = a.d1.length().max(b.d1.length());
        let [a, b] = [a.d1, b.d1].map(|d1| if speed > 0.0 { d1 / speed } else { Vec3::ZERO });
        Self { s, length: ruling.length(), normals: [a.cross(way), b.cross(way)], speed, volume: way.dot(a.cross(b)) }
    }

    /// The place along it where its normal is shortest, with the part of the longer end that is left of it.
    fn least_normal(&self) -> (f64, f64) {
        let [from, to] = self.normals;
        let (longer, turn) = (from.length().max(to.length()), from - to);
        if longer <= ZERO {
            return (0.5, 0.0);
        }
        let t = from.dot(turn) / turn.dot(turn).max(f64::MIN_POSITIVE);
        (t, (from - turn * t).length() / longer)
    }

    /// Beyond the rounding of a normal that vanishes at an end, as those of a curve's tangents do.
    fn has_opposite_normals(&self) -> bool {
        self.normals[0].dot(self.normals[1]) < 0.0 && is_inside(self.least_normal().0)
    }

    /// Refuses one whose normal vanishes inside, or all along.
    fn check(&self, piece: &RailPiece) -> Result<()> {
        let (t, normal) = self.least_normal();
        if is_inside(t) && normal <= ZERO { Err(self.crossed(piece, t, normal)) } else { Ok(()) }
    }

    fn crossed(&self, piece: &RailPiece, t: f64, normal: f64) -> Error {
        let [from, to] = piece.part;
        Error::Bridge(BridgeError::RulingsCross {
            piece: piece.piece,
            at: [from + (to - from) * self.s, t],
            normal,
            limit: ZERO,
        })
    }
}

/// Whether a parameter is between the ends, and at none of them.
fn is_inside(t: f64) -> bool {
    t > ZERO && t < 1.0 - ZERO
}

/// Refuses a piece in which rulings cross, or curves that meet other than in its ends.
///
/// # Errors
/// `rulings-cross`.
pub(super) fn check_rulings(piece: &RailPiece) -> Result<()> {
    let mut rulings: Vec<Ruling> = (0..=PLACES).map(|k| Ruling::of(piece, f64::from(k) / f64::from(PLACES))).collect();
    let fastest = rulings.iter().map(|ruling| ruling.speed).fold(0.0, f64::max);
    // Where both curves come to a stand at an end they have their directions next to it.
    for ruling in &mut rulings {
        let at_end = ruling.s <= 0.0 || ruling.s >= 1.0;
        if at_end && ruling.speed <= ZERO * fastest {
            *ruling = Ruling::of(piece, ruling.s.clamp(BESIDE, 1.0 - BESIDE));
        }
    }
    let longest = rulings.iter().map(|ruling| ruling.length).fold(0.0, f64::max);
    let is_point = |ruling: &Ruling| ruling.length <= ZERO * longest;
    for around in rulings.windows(3) {
        if may_meet(around) {
            let nearest = shortest_between(piece, around[0].s, around[2].s);
            if is_point(&nearest) && is_inside(nearest.s) {
                return Err(nearest.crossed(piece, 0.5, 0.0));
            }
        }
    }
    rulings.iter().filter(|ruling| !is_point(ruling)).try_for_each(|ruling| ruling.check(piece))?;
    rulings.windows(2).try_for_each(|pair| check_between(piece, [pair[0], pair[1]]))
}

/// Whether the middle one is the shortest of three, and short enough for the curves to meet near it at their speed.
fn may_meet(around: &[Ruling]) -> bool {
    let [before, middle, after] = [0, 1, 2].map(|k: usize| around[k].length);
    let speed = around.iter().map(|ruling| ruling.speed).fold(0.0, f64::max);
    middle <= before && middle <= after && middle <= 4.0 * speed / f64::from(PLACES)
}

/// Refuses a ruling between two whose volumes have different signs, or between the places at which the normals of both ends turn round: in a
/// plane rulings cross between these, however near they are, and volumes say nothing.
fn check_between(piece: &RailPiece, [from, to]: [Ruling; 2]) -> Result<()> {
    let turns = [0, 1].map(|end: usize| {
        let ahead = |ruling: &Ruling| from.normals[end].dot(ruling.normals[end]) >= 0.0;
        (!ahead(&to)).then(|| change(piece, [from, to], ahead).s)
    });
    let [Some(first), Some(second)] = turns else { return check_volumes(piece, [from, to]) };
    let middle = Ruling::of(piece, 0.5 * (first + second));
    middle.check(piece)?;
    check_volumes(piece, [from, middle])?;
    check_volumes(piece, [middle, to])
}

fn check_volumes(piece: &RailPiece, [from, to]: [Ruling; 2]) -> Result<()> {
    let opposite = from.has_opposite_normals() && to.has_opposite_normals();
    if !opposite || from.volume * to.volume >= 0.0 {
        return Ok(());
    }
    let found = change(piece, [from, to], |ruling| (ruling.volume < 0.0) == (from.volume < 0.0));
    let (t, normal) = found.least_normal();
    if found.has_opposite_normals() { Err(found.crossed(piece, t, normal)) } else { Ok(()) }
}

/// The first ruling found between two of which something ceases to hold.
fn change(piece: &RailPiece, [mut from, mut to]: [Ruling; 2], holds: impl Fn(&Ruling) -> bool) -> Ruling {
    for _ in 0..STEPS {
        let middle = Ruling::of(piece, 0.5 * (from.s + to.s));
        if holds(&middle) { from = middle } else { to = middle }
    }
    to
}

/// The shortest ruling between two places, if their lengths have one minimum there.
fn shortest_between(piece: &RailPiece, mut from: f64, mut to: f64) -> Ruling {
    let length = |s: f64| Ruling::of(piece, s).length;
    for _ in 0..2 * STEPS {
        let third = (to - from) / 3.0;
        let [s0, s1] = [from + third, to - third];
        if length(s0) <= length(s1) { to = s1 } else { from = s0 }
    }
    Ruling::of(piece, 0.5 * (from + to))
}
