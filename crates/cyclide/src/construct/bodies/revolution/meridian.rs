//! The meridian of a profile, its points as distance from the axis and height, and whether it meets itself: then what it sweeps
//! in a whole turn does, and is no solid.
//!
//! Chords find the candidates: two pieces of curves can meet where their chords are nearer than both leave theirs by, of which there is
//! a bound. They do if Newton's method leads there, from the ends and the middles, so that walls as thin as a sagitta are not taken for
//! crossings. Chords are sorted by height: time grows with their number times those beside each other.

use super::Revolution;
use super::profile::Piece;
use crate::base::vector::Point3;
use crate::curve::ParamCurve as _;
use crate::error::{ProfileError, Result};
use crate::topology::EdgeCurve;

/// Chords of a piece that bends.
const CHORDS: usize = 32;
/// Places nearer than this part of the size are one.
const ONE_PLACE: f64 = 1e-12;
/// Chords turn back if the sine between them is below this.
const BACK: f64 = 1e-9;
/// Steps of Newton's method.
const STEPS: usize = 24;
/// Places of a chord from which it starts.
const STARTS: [f64; 3] = [0.0, 0.5, 1.0];
/// Rounding of a place on a curve.
const PLACE: f64 = 1e-9;
/// Steps in which the height of a curve over a place is found.
const HALVINGS: u32 = 60;

/// Distance from the axis and height.
type Plane = [f64; 2];

struct Chord<'a> {
    curve: &'a EdgeCurve,
    /// The number of the profile, and that of the piece through all profiles; the part of it.
    profile: usize,
    piece: usize,
    part: [f64; 2],
    ends: [Plane; 2],
    /// The curve leaves its chord by no more than this.
    leaves: f64,
    /// Place in the order of the profile.
    order: usize,
}

/// Refuses a meridian that meets itself other than in its joints; `size` is that of the profile.
///
/// # Errors
/// `profile-meets-itself`.
pub(super) fn check(turn: &Revolution, pieces: &[Piece], size: f64) -> Result<()> {
    let chords = chords(turn, 0, 0, pieces);
    let count = chords.len();
    let ring =
        chords.first().zip(chords.last()).is_some_and(|(a, b)| distance(a.ends[0], b.ends[1]) <= ONE_PLACE * size);
    find_meeting(turn, chords, size, |a, b| {
        let (first, second) = if a.order < b.order { (a, b) } else { (b, a) };
        let follows = second.order - first.order == 1;
        let closes = ring && first.order == 0 && second.order == count - 1;
        match (follows, closes) {
            (true, _) => turns_back(turn, first, second),
            (_, true) => turns_back(turn, second, first),
            _ => cross(turn, first, second, size),
        }
    })
}

/// Refuses profiles that meet each other; pieces are counted through all of them.
///
/// # Errors
/// `profile-meets-itself`.
pub(super) fn check_apart(turn: &Revolution, profiles: &[&[Piece]], size: f64) -> Result<()> {
    if profiles.len() < 2 {
        return Ok(());
    }
    let mut all = Vec::new();
    let mut count = 0;
    for (profile, pieces) in profiles.iter().enumerate() {
        all.extend(chords(turn, profile, count, pieces));
        count += pieces.len();
    }
    find_meeting(turn, all, size, |a, b| a.profile != b.profile && cross(turn, a, b, size))
}

/// True if the meridian of a solid goes round that of another, from which it is apart: a ray along the axis from a place of the other
/// meets it an odd number of times. Along the axis it is closed by the axis.
fn is_around(turn: &Revolution, outer: &[Piece], inner: &[Piece]) -> bool {
    let Some(place) = inner.first().map(|piece| meridian(turn, piece.curve.point(0.5))) else { return false };
    let crosses = |chord: &Chord<'_>| {
        let [from, to] = chord.ends.map(|p| minus(p, place));
        // One end belongs to the chord, the other to the next one.
        (from[0] > 0.0) != (to[0] > 0.0) && {
            let height = from[1] - from[0] * (to[1] - from[1]) / (to[0] - from[0]);
            // A curve that leaves its chord may be on the other side of a place near it.
            if height.abs() > 2.0 * chord.leaves { height > 0.0 } else { chord.height_over(turn, place[0]) > place[1] }
        }
    };
    chords(turn, 0, 0, outer).iter().filter(|chord| crosses(chord)).count() % 2 == 1
}

/// Of each of several profiles that are apart, none where there are no pieces, all that go round it.
pub(super) fn all_around(turn: &Revolution, profiles: &[&[Piece]]) -> Vec<Vec<usize>> {
    let around =
        |k: usize| (0..profiles.len()).filter(|&j| j != k && is_around(turn, profiles[j], profiles[k])).collect();
    (0..profiles.len()).map(around).collect()
}

/// Refuses chords of which two meet; those beside each other in height are looked at.
fn find_meeting(
    turn: &Revolution,
    mut chords: Vec<Chord<'_>>,
    size: f64,
    meet: impl Fn(&Chord<'_>, &Chord<'_>) -> bool,
) -> Result<()> {
    let low = |chord: &Chord<'_>| chord.ends[0][1].min(chord.ends[1][1]) - chord.leaves;
    let high = |chord: &Chord<'_>| chord.ends[0][1].max(chord.ends[1][1]) + chord.leaves;
    chords.sort_by(|a, b| low(a).total_cmp(&low(b)));
    for (i, a) in chords.iter().enumerate() {
        for b in chords[i + 1..].iter().take_while(|b| low(b) <= high(a) + ONE_PLACE * size) {
            if meet(a, b) {
                let (first, second) = if (a.piece, a.order) < (b.piece, b.order) { (a, b) } else { (b, a) };
                let [radius, height] = meeting_place(turn, first, second);
                return Err(
                    ProfileError::MeetsItself { first: first.piece, second: second.piece, radius, height }.into()
                );
            }
        }
    }
    Ok(())
}

/// Where two curves meet, by their chords: where these cross, or the end of the first where they run along each other.
fn meeting_place(turn: &Revolution, first: &Chord<'_>, second: &Chord<'_>) -> Plane {
    let [u, v] = [first, second].map(|chord| minus(chord.ends[1], chord.ends[0]));
    let sine = cross_product(u, v);
    if sine.abs() <= BACK * u[0].hypot(u[1]) * v[0].hypot(v[1]) {
        return first.ends[1];
    }
    let along = (cross_product(minus(second.ends[0], first.ends[0]), v) / sine).clamp(0.0, 1.0);
    meridian(turn, first.curve.point(first.part[0] + along * (first.part[1] - first.part[0])))
}

/// The chords of a profile, whose pieces are counted from a number on.
fn chords<'a>(turn: &Revolution, profile: usize, from: usize, pieces: &'a [Piece]) -> Vec<Chord<'a>> {
    let mut chords = Vec::new();
    for (piece, Piece { curve, across }) in pieces.iter().enumerate() {
        // A segment in a plane with the axis is its chord.
        let straight = across.is_some() && matches!(curve, EdgeCurve::Arc(arc) if arc.is_straight());
        let count = if straight { 1 } else { CHORDS };
        let mut rest = Some(curve.clone());
        for k in 0..count {
            let part = [k, k + 1].map(|k| k as f64 / count as f64);
            let places = part.map(|x| curve.point(x));
            let ends = places.map(|p| meridian(turn, p));
            let leaves = if straight {
                0.0
            } else {
                leaves(next_part(&mut rest, count - k).as_ref(), turn, places, across.is_some())
            };
            chords.push(Chord { curve, profile, piece: from + piece, part, ends, leaves, order: chords.len() });
        }
    }
    chords
}

/// The first of so many parts of what is left of a curve, which it is cut from.
fn next_part(rest: &mut Option<EdgeCurve>, parts: usize) -> Option<EdgeCurve> {
    let whole = rest.take()?;
    if parts == 1 {
        return Some(whole);
    }
    let (first, left) = whole.split(1.0 / parts as f64).ok()?;
    *rest = Some(left);
    Some(first)
}

/// A bound of the distance of the meridian of a part of a curve from its chord. Distances of points grow in no meridian, so the curve is
/// as near to the meridian of its chord in space as to that chord; which leaves the straight line where the chord is in no plane with the
/// axis: its distance from the axis has the second derivative `|w0 × w1|² / r³`, w its ways off the axis.
fn leaves(part: Option<&EdgeCurve>, turn: &Revolution, ends: [Point3; 2], planar: bool) -> f64 {
    let sagitta = match part {
        None => f64::INFINITY,
        Some(EdgeCurve::Arc(arc)) => 0.5 * arc.chord().length() * (0.25 * arc.angle()).tan(),
        Some(EdgeCurve::Rational(curve)) => curve
            .rows()
            .iter()
            .map(|&[x, y, z, w]| from_segment(Point3::new(x / w, y / w, z / w), ends))
            .fold(0.0, f64::max),
    };
    if planar {
        return sagitta;
    }
    let [from, to] = ends.map(|p| turn.way_off_axis(p));
    let (area, way) = (from.cross(to).length(), to - from);
    let foot = (-from.dot(way) / way.dot(way).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    let nearest = (from + way * foot).length();
    let bent = area * area / (8.0 * nearest.powi(3));
    let most = from.length().max(to.length());
    sagitta + if bent <= most { bent } else { most }
}

/// Distance of a point from a segment.
fn from_segment(p: Point3, [from, to]: [Point3; 2]) -> f64 {
    let (along, way) = (to - from, p - from);
    let part = (way.dot(along) / along.dot(along).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (way - along * part).length()
}

impl Chord<'_> {
    /// The height of the curve at a distance from the axis between those of its ends.
    fn height_over(&self, turn: &Revolution, radius: f64) -> f64 {
        let [mut low, mut high] = self.part;
        let rises = self.ends[0][0] < self.ends[1][0];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let [at, _] = meridian(turn, self.curve.point(middle));
            if (at < radius) == rises { low = middle } else { high = middle }
        }
        meridian(turn, self.curve.point(low))[1]
    }
}

fn meridian(turn: &Revolution, p: Point3) -> Plane {
    [turn.way_off_axis(p).length(), turn.height(p)]
}

fn distance(a: Plane, b: Plane) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn minus(a: Plane, b: Plane) -> Plane {
    [a[0] - b[0], a[1] - b[1]]
}

fn cross_product(a: Plane, b: Plane) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// True if a curve runs back along the one before it. Chords of arcs that touch in a point may do so though the arcs do not: as far as
/// the shorter one reaches, the longer one has a place equally far from the joint.
fn turns_back(turn: &Revolution, first: &Chord<'_>, second: &Chord<'_>) -> bool {
    let [u, v] = [first, second].map(|chord| minus(chord.ends[1], chord.ends[0]));
    let lengths = [u, v].map(|way| way[0].hypot(way[1]));
    if u[0] * v[0] + u[1] * v[1] >= 0.0 || cross_product(u, v).abs() > BACK * lengths[0] * lengths[1] {
        return false;
    }
    if first.leaves + second.leaves == 0.0 {
        return true;
    }
    let [ending, starting] = [[first.part[1], first.part[0]], second.part];
    let (short, long, joint) = if lengths[0] < lengths[1] {
        (first.ends[0], (second.curve, starting), first.ends[1])
    } else {
        (second.ends[1], (first.curve, ending), first.ends[1])
    };
    let reach = distance(short, joint);
    let (curve, [mut near, mut far]) = long;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (near + far);
        if distance(meridian(turn, curve.point(middle)), joint) < reach { near = middle } else { far = middle }
    }
    distance(meridian(turn, curve.point(near)), short) <= BACK * reach
}

/// True if the curves over two chords that do not follow each other meet.
fn cross(turn: &Revolution, a: &Chord<'_>, b: &Chord<'_>, size: f64) -> bool {
    let apart = between_segments(a.ends, b.ends);
    if apart > a.leaves + b.leaves + ONE_PLACE * size {
        return false;
    }
    // Two segments meet if they touch.
    if a.leaves + b.leaves == 0.0 {
        return true;
    }
    let starts = |chord: &Chord<'_>| STARTS.map(|x| chord.part[0] + x * (chord.part[1] - chord.part[0]));
    starts(a).into_iter().any(|x| starts(b).into_iter().any(|y| meet_near(turn, [a, b], [x, y], size)))
}

/// Distance of two segments.
fn between_segments(a: [Plane; 2], b: [Plane; 2]) -> f64 {
    let beside = |[from, to]: [Plane; 2], p: Plane| cross_product(minus(to, from), minus(p, from));
    let split = |chord: [Plane; 2], other: [Plane; 2]| beside(chord, other[0]) * beside(chord, other[1]) < 0.0;
    if split(a, b) && split(b, a) {
        return 0.0;
    }
    let nearest =
        |of: [Plane; 2], to: [Plane; 2]| of.map(|p| to_segment(p, to)).into_iter().fold(f64::INFINITY, f64::min);
    nearest(a, b).min(nearest(b, a))
}

fn to_segment(p: Plane, [from, to]: [Plane; 2]) -> f64 {
    let (along, way) = (minus(to, from), minus(p, from));
    let squared = along[0] * along[0] + along[1] * along[1];
    let part = if squared > 0.0 { ((way[0] * along[0] + way[1] * along[1]) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (way[0] - part * along[0]).hypot(way[1] - part * along[1])
}

/// True if Newton's method leads from two places to a place on both curves, over their chords.
fn meet_near(turn: &Revolution, chords: [&Chord<'_>; 2], mut at: [f64; 2], size: f64) -> bool {
    // Of arcs far smaller than the whole places are told apart by their own size.
    let shortest = chords.iter().map(|chord| distance(chord.ends[0], chord.ends[1])).fold(f64::INFINITY, f64::min);
    let one = (1e3 * ONE_PLACE * size).min(1e-3 * shortest).max(ONE_PLACE * size);
    let over = |k: usize, x: f64| chords[k].part[0] - PLACE <= x && x <= chords[k].part[1] + PLACE;
    for _ in 0..STEPS {
        let jets = [0, 1].map(|k: usize| chords[k].curve.piece_jet(0, at[k]));
        let [p, q] = jets.map(|jet| meridian(turn, jet.point));
        let slopes = jets.map(|jet| {
            let way = turn.way_off_axis(jet.point);
            [way.dot(jet.d1) / way.length(), jet.d1.dot(turn.axis)]
        });
        let off = minus(q, p);
        if off[0].hypot(off[1]) <= one {
            return over(0, at[0]) && over(1, at[1]);
        }
        let determinant = cross_product(slopes[0], slopes[1]);
        // Not `==`: nothing is known where it is no number either.
        if !(determinant.abs() > 0.0) {
            return false;
        }
        at = [at[0] + cross_product(off, slopes[1]) / determinant, at[1] + cross_product(off, slopes[0]) / determinant];
        if at.iter().any(|x| !(-0.5..=1.5).contains(x)) {
            return false;
        }
    }
    false
}
