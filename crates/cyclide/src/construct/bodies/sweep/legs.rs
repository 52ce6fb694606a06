//! The legs of a path, the stations between them, and how the section is turned about the path over each.

use super::{SweepFrame, SweepOptions};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::LARGEST_ARC;
use crate::construct::bodies::smooth_joint::largest_smooth_turn;
use crate::curve::{Arc, ArcPath, ParamCurve as _};
use crate::error::{CurveError, Error, NumberError, PipeError, PointError, Result, TubeError};
use std::f64::consts::{PI, TAU};

/// Largest turn of a corner that is mitered: as of pipes, the miter is ten times as long as the section is wide.
const LARGEST_TURN: f64 = 2.942;
/// The width that a section has left at the inner side of a bend, and a segment between its miters, as part of their own.
const LEAST_LEFT: f64 = 1e-7;
/// Turns about the path that are less are none.
const NO_TURN: f64 = 1e-9;
/// An up vector nearer to the path than this, radians, has no direction across it.
const ALONG: f64 = 1e-3;
/// Legs at most.
const MOST_LEGS: usize = 8192;
/// Places of a leg at which its turn is compared with the law.
const PLACES: usize = 8;

/// A part of the path over which faces are made.
pub(super) struct Leg {
    /// With even weights, at most a third of a turn.
    pub(super) arc: Arc,
    /// Turn about the path from its start to its end.
    pub(super) roll: f64,
}

/// A place between legs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station {
    pub(super) center: Point3,
    /// Along the path behind it, unit.
    pub(super) axis: Vec3,
    /// Along the path before it.
    before: Vec3,
    /// The x axis of the section, as seen from behind.
    x: Vec3,
    mitred: bool,
}

/// A path made ready.
pub(super) struct Legs {
    pub(super) legs: Vec<Leg>,
    /// Before each leg, and behind the last one of an open path.
    pub(super) stations: Vec<Station>,
    pub(super) closed: bool,
    pub(super) bound: f64,
}

impl Station {
    pub(super) fn is_mitred(&self) -> bool {
        self.mitred
    }

    /// The axes of the section.
    pub(super) fn directions(&self) -> [Vec3; 2] {
        [self.x, self.axis.cross(self.x)]
    }

    /// The plane of the miter, its normal along the path.
    pub(super) fn mitre(&self) -> Option<Vec3> {
        if self.mitred { (self.before + self.axis).unit() } else { None }
    }

    /// From the center to where the line along the path meets the miter, for a way across the path as it is behind.
    pub(super) fn slanted(&self, v: Vec3) -> Vec3 {
        if !self.mitred {
            return v;
        }
        v - self.axis * (v.dot(self.before) / (1.0 + self.before.dot(self.axis)))
    }
}

/// A piece of the path as it is given.
struct Piece {
    arc: Arc,
    source: usize,
    along: Vec3,
    end: Vec3,
    /// By how much the corners at its ends turn; 0 where there is none.
    mitred_turns: [f64; 2],
}

impl Piece {
    /// A vector across its start, carried to a parameter.
    fn carried(&self, v: Vec3, t: f64) -> Vec3 {
        if self.arc.is_straight() {
            return v;
        }
        Quat::from_axis_angle(self.arc.normal().unwrap_or(self.along), self.arc.angle_to(t)).rotate(v)
    }

    fn tangent(&self, t: f64) -> Vec3 {
        self.carried(self.along, t)
    }
}

impl Legs {
    pub(super) fn new(path: &ArcPath, section: &[Point3], options: &SweepOptions) -> Result<Self> {
        let pieces = pieces(path)?;
        let closed = path.is_closed();
        let first = &pieces[0];
        let x = start(first.along, options.up);
        let (mut turned, mut whole) = (x, 0.0);
        for piece in &pieces {
            turned = behind_joint(piece.carried(turned, 1.0), piece.end, piece.end);
            whole += piece.arc.length();
            let next = next_along(&pieces, piece, closed);
            turned = behind_joint(turned, piece.end, next);
        }
        let twist = match (closed, options.frame) {
            (true, SweepFrame::RotationMinimizing) => {
                let back = angle_about(first.along, turned, x);
                back + TAU * (options.twist / TAU).round()
            }
            (true, SweepFrame::Up) => TAU * (options.twist / TAU).round(),
            (false, _) => options.twist,
        };
        let rate = if twist.abs() <= NO_TURN { 0.0 } else { twist / whole };
        let mut made = Self { legs: Vec::new(), stations: Vec::new(), closed, bound: 0.0 };
        let extent = section.iter().map(|p| p.to_vec().length()).fold(0.0, f64::max);
        let mut maker = Maker { options, section, extent, rate, made: &mut made, passed: 0.0 };
        let mut frame = x;
        for (k, piece) in pieces.iter().enumerate() {
            let before = match k {
                0 if closed => pieces[pieces.len() - 1].end,
                0 => piece.along,
                _ => pieces[k - 1].end,
            };
            frame = behind_joint(frame, before, piece.along);
            frame = maker.piece(piece, before, frame)?;
        }
        if let (false, Some(last)) = (closed, pieces.last()) {
            let (center, axis) = (last.arc.end(), last.end);
            made.stations.push(Station { center, axis, before: axis, x: frame, mitred: false });
        }
        made.check_mitres(&pieces, section)?;
        Ok(made)
    }

    /// Refuses legs that are shorter than what their miters take.
    fn check_mitres(&self, pieces: &[Piece], section: &[Point3]) -> Result<()> {
        let n = self.stations.len();
        for (k, leg) in self.legs.iter().enumerate() {
            let [from, to] = [&self.stations[k], &self.stations[(k + 1) % n]];
            if !(from.mitred || to.mitred) {
                continue;
            }
            let length = leg.arc.chord().length();
            let ends = [from, to];
            let short = |p: &Point3| {
                let [a, b] = ends.map(|station| {
                    let [u, v] = station.directions();
                    station.slanted(u * p.x + v * p.y).dot(from.axis)
                });
                a - b
            };
            let needed = section.iter().map(short).fold(0.0, f64::max);
            if needed >= length * (1.0 - LEAST_LEFT) {
                let piece = pieces.iter().find(|piece| piece.arc.start().distance(from.center) <= length);
                return Err(PipeError::MitreDoesNotFit {
                    piece: piece.map_or(k, |piece| piece.source),
                    needed,
                    length,
                }
                .into());
            }
        }
        Ok(())
    }
}

/// The pieces of a path with their directions.
fn pieces(path: &ArcPath) -> Result<Vec<Piece>> {
    let mut pieces = Vec::new();
    for (source, arc) in path.arcs().iter().enumerate() {
        for part in arc.in_parts(LARGEST_ARC)? {
            let arc = part.evened();
            let ends = [arc.start_tangent(), arc.end_tangent()];
            let [Some(along), Some(end)] = ends else { return Err(PointError::ZeroTangent { index: source }.into()) };
            pieces.push(Piece { arc, source, along, end, mitred_turns: [0.0; 2] });
        }
    }
    let n = pieces.len();
    for k in usize::from(!path.is_closed())..n {
        let (before, behind) = ((k + n - 1) % n, k);
        let smooth = largest_smooth_turn(&pieces[before].arc, &pieces[behind].arc);
        let turn = pieces[before].end.angle(pieces[behind].along);
        if turn <= smooth {
            continue;
        }
        if turn > LARGEST_TURN || [before, behind].iter().any(|&piece| !pieces[piece].arc.is_straight()) {
            return Err(
                PipeError::CornerNotMitred { joint: pieces[behind].source, turn, smooth, limit: LARGEST_TURN }.into()
            );
        }
        pieces[before].mitred_turns[1] = turn;
        pieces[behind].mitred_turns[0] = turn;
    }
    Ok(pieces)
}

fn next_along(pieces: &[Piece], piece: &Piece, closed: bool) -> Vec3 {
    let k = pieces.iter().position(|other| std::ptr::eq(other, piece)).unwrap_or(0);
    match pieces.get(k + 1) {
        Some(next) => next.along,
        None if closed => pieces[0].along,
        None => piece.end,
    }
}

/// The x axis at the start: y up as far as the direction allows.
pub(super) fn start(along: Vec3, up: Vec3) -> Vec3 {
    let up = up.unit().unwrap_or(Vec3::Z);
    let level = up.cross(along);
    if level.length() > ALONG {
        return level.unit().unwrap_or(level);
    }
    let x = Vec3::X - along * Vec3::X.dot(along);
    x.unit().unwrap_or_else(|| along.any_perpendicular())
}

/// A vector across one direction, turned to be across the next by the least rotation.
fn behind_joint(v: Vec3, before: Vec3, behind: Vec3) -> Vec3 {
    let v = v - (before + behind) * (v.dot(behind) / (1.0 + before.dot(behind)));
    let v = v - behind * v.dot(behind);
    v.unit().unwrap_or(v)
}

/// The angle from one vector across an axis to another, right-handed, in (-pi, pi].
fn angle_about(axis: Vec3, from: Vec3, to: Vec3) -> f64 {
    from.cross(to).dot(axis).atan2(from.dot(to))
}

struct Maker<'a> {
    options: &'a SweepOptions,
    section: &'a [Point3],
    /// The largest distance of the section from the path.
    extent: f64,
    /// Turn about the path by its length.
    rate: f64,
    made: &'a mut Legs,
    /// Length before.
    passed: f64,
}

impl Maker<'_> {
    /// Adds the legs of a piece, the x axis of the section behind its start given; gives that at its end.
    fn piece(&mut self, piece: &Piece, before: Vec3, frame: Vec3) -> Result<Vec3> {
        let length = piece.arc.length();
        if self.rate == 0.0 && self.options.frame == SweepFrame::RotationMinimizing {
            let end = self.leg(piece, [0.0, 1.0], before, frame, 0.0)?;
            self.passed += length;
            return Ok(end);
        }
        // Nothing turns beside a miter.
        let stubs = piece.mitred_turns.map(|turn| self.extent * (0.5 * turn).tan() / length * (1.0 + LEAST_LEFT));
        let roll_end = self.law(piece, 1.0, frame)?;
        if roll_end.abs() <= NO_TURN && (piece.arc.is_straight() || self.is_still(piece, frame)?) {
            let end = self.leg(piece, [0.0, 1.0], before, frame, 0.0)?;
            self.passed += length;
            return Ok(end);
        }
        if stubs[0] + stubs[1] >= 1.0 {
            return Err(PipeError::MitreDoesNotFit {
                piece: piece.source,
                needed: (stubs[0] + stubs[1]) * length,
                length,
            }
            .into());
        }
        let [from, to] = [stubs[0], 1.0 - stubs[1]];
        let mut frame_now = frame;
        let mut arrived = before;
        if from > 0.0 {
            frame_now = self.leg(piece, [0.0, from], arrived, frame_now, 0.0)?;
            arrived = piece.along;
        }
        let mut waiting = vec![[from, to]];
        let squeezed = |t: f64| (t - from) / (to - from);
        let mut rolled = 0.0;
        while let Some([a, b]) = waiting.pop() {
            let [at_a, at_b] = [self.law(piece, squeezed(a), frame)?, self.law(piece, squeezed(b), frame)?];
            let off = self.off_law(piece, [a, b], [at_a, at_b], &squeezed, frame)?;
            if self.extent * off > self.options.tolerance || (at_b - at_a).abs() > 0.5 * PI {
                if self.made.legs.len() + waiting.len() > MOST_LEGS {
                    let (needed, remedy) = ((MOST_LEGS + 1) as f64, "use a larger tolerance");
                    let what = "the sweep up to piece";
                    return Err(NumberError::TooManyPieces {
                        what,
                        segment: Some(piece.source),
                        needed,
                        cap: MOST_LEGS,
                        remedy,
                    }
                    .into());
                }
                let middle = 0.5 * (a + b);
                waiting.extend([[middle, b], [a, middle]]);
                continue;
            }
            self.made.bound = self.made.bound.max(self.extent * off);
            frame_now = self.leg(piece, [a, b], arrived, frame_now, at_b - rolled)?;
            rolled = at_b;
            arrived = piece.tangent(b);
        }
        if to < 1.0 {
            frame_now = self.leg(piece, [to, 1.0], arrived, frame_now, 0.0)?;
        }
        self.passed += length;
        Ok(frame_now)
    }

    /// The turn about the path from the start of a piece to a part of it, by length on segments.
    fn law(&self, piece: &Piece, t: f64, frame: Vec3) -> Result<f64> {
        let length = piece.arc.length_to(t);
        let twisted = self.rate * length;
        if self.options.frame == SweepFrame::RotationMinimizing {
            return Ok(twisted);
        }
        let up = self.options.up.unit().unwrap_or(Vec3::Z);
        let level = |along: Vec3| {
            let level = up.cross(along);
            let measured = level.length();
            let what = "the sine of the angle between the path and the up vector";
            level.unit().filter(|_| measured > ALONG).ok_or(Error::Curve(CurveError::NoFrame {
                what,
                t,
                measured,
                limit: ALONG,
            }))
        };
        let [start, now] = [level(piece.along)?, level(piece.tangent(t))?];
        let twist_before = self.rate * self.passed;
        let wanted = Quat::from_axis_angle(piece.along, twist_before).rotate(start);
        let off = angle_about(piece.along, frame, wanted);
        if off.abs() > 1e-6 {
            let what = "the angle by which a corner turns the section about the path, its y axis up on both sides,";
            return Err(CurveError::NoFrame { what, t, measured: off.abs(), limit: 1e-6 }.into());
        }
        Ok(angle_about(piece.tangent(t), piece.carried(start, t), now) + twisted)
    }

    /// Whether the section does not turn about a piece anywhere.
    fn is_still(&self, piece: &Piece, frame: Vec3) -> Result<bool> {
        for k in 1..PLACES {
            if self.law(piece, k as f64 / PLACES as f64, frame)?.abs() > NO_TURN {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// How far the rational turn over a leg is from the law at places.
    fn off_law(
        &self,
        piece: &Piece,
        [a, b]: [f64; 2],
        [at_a, at_b]: [f64; 2],
        squeezed: &dyn Fn(f64) -> f64,
        frame: Vec3,
    ) -> Result<f64> {
        let half = 0.5 * (at_b - at_a);
        let part = piece.arc.restricted(a, b)?.evened();
        let (start, whole) = (piece.arc.length_to(a), piece.arc.length());
        let mut most = 0.0_f64;
        for k in 1..PLACES {
            let s = k as f64 / PLACES as f64;
            let turned = 2.0 * (s * half.sin()).atan2(1.0 - s + s * half.cos());
            let t = piece.arc.parameter_at_length((start + part.length_to(s)) / whole);
            most = most.max((self.law(piece, squeezed(t), frame)? - at_a - turned).abs());
        }
        Ok(1.1 * most)
    }

    /// Adds a leg with the station before it.
    fn leg(&mut self, piece: &Piece, [from, to]: [f64; 2], before: Vec3, frame: Vec3, roll: f64) -> Result<Vec3> {
        let whole = from <= 0.0 && to >= 1.0;
        let arc = if whole { piece.arc } else { piece.arc.restricted(from, to)?.evened() };
        let axis = piece.tangent(from);
        let x = (frame - axis * frame.dot(axis)).unit().unwrap_or(frame);
        let mitred = piece.mitred_turns[0] > 0.0 && from == 0.0;
        self.made.stations.push(Station {
            center: arc.start(),
            axis,
            before: if mitred { before } else { axis },
            x,
            mitred,
        });
        self.check_width(piece, &arc, [axis, x], roll)?;
        self.made.legs.push(Leg { arc, roll });
        let end = if arc.is_straight() { x } else { arc.weight_ratio().rotate(x) };
        let axis = piece.tangent(to);
        let end = Quat::from_axis_angle(axis, roll).rotate(end);
        Ok((end - axis * end.dot(axis)).unit().unwrap_or(end))
    }

    /// Refuses a bend that is narrower than the section.
    fn check_width(&self, piece: &Piece, arc: &Arc, [axis, x]: [Vec3; 2], roll: f64) -> Result<()> {
        let curvature = arc.curvature();
        let Some(normal) = arc.normal().filter(|_| curvature > 0.0) else { return Ok(()) };
        let inwards = normal.cross(axis);
        for k in 0..=PLACES {
            let at = k as f64 / PLACES as f64;
            let u = Quat::from_axis_angle(axis, roll * at).rotate(x);
            let v = axis.cross(u);
            let most = self.section.iter().map(|p| (u * p.x + v * p.y).dot(inwards)).fold(0.0, f64::max);
            let left = 1.0 - curvature * most;
            if !(left > LEAST_LEFT) {
                return Err(TubeError::Folds { piece: piece.source, at, left }.into());
            }
            if roll == 0.0 {
                break;
            }
        }
        Ok(())
    }
}
