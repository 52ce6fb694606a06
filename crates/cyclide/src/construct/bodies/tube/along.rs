//! Chains of arcs of balls along a spine of arcs with a law of the radius, and how far they are from it
//! (`docs/math/tubes.md#along-a-spine`).

use super::ball::{Ball, Way};
use super::ball_arc::BallArc;
use super::radius_law::RadiusLaw;
use crate::construct::bodies::LARGEST_ARC;
use crate::construct::bodies::smooth_joint::largest_smooth_turn;
use crate::curve::{Arc, ArcPath, ParamCurve as _};
use crate::error::{Error, NumberError, PipeError, PointError, Result, TubeError};

/// A radius that grows by less than this, for each length, away from linear is linear: rounding.
pub(super) const LINEAR: f64 = 1e-13;
/// Halvings of a part of the spine at most.
pub(super) const MOST_HALVINGS: u32 = 24;
/// Arcs of balls at most, and for each arc of the spine besides: a hundred megabytes of STEP.
pub(super) const MOST_ARCS: usize = 4096;
const MOST_ARCS_EACH: usize = 4;
/// Places of an arc at which its distance is measured, at first and at most.
const PLACES: [usize; 2] = [8, 512];

/// The arcs, and a proved bound of the distance of any of their balls from those of the law.
pub(super) struct Along {
    pub(super) arcs: Vec<BallArc>,
    pub(super) bound: f64,
    /// Most arcs.
    cap: usize,
}

/// A part of a spine within one of its arcs and one cubic of the law.
#[derive(Clone)]
pub(super) struct Part<'a> {
    pub(super) arc: Arc,
    /// Fractions of the length of the spine at its ends.
    pub(super) at: [f64; 2],
    pub(super) source: usize,
    law: &'a RadiusLaw,
    /// Length of the whole spine.
    whole: f64,
}

/// The chain along a path, within a tolerance of its law.
///
/// # Errors
/// `corner-not-mitred`, `radius-grows-too-fast`, `radius-not-closed`, `too-many-pieces`.
pub(super) fn along(path: &ArcPath, law: &RadiusLaw, tolerance: f64) -> Result<Along> {
    let law = if path.is_closed() { law.clone().closed()? } else { law.clone() };
    let mut made = Along { arcs: Vec::new(), bound: 0.0, cap: most_arcs(path) };
    for part in parts(path, &law)? {
        part.add(tolerance, MOST_HALVINGS, &mut made)?;
    }
    Ok(made)
}

/// Most pieces of a tube along a path.
pub(super) fn most_arcs(path: &ArcPath) -> usize {
    MOST_ARCS + MOST_ARCS_EACH * path.arcs().len()
}

/// The parts of a path within one of its arcs, at most a third of a turn, and within one cubic of the law.
///
/// # Errors
/// `corner-not-mitred`.
pub(super) fn parts<'a>(path: &ArcPath, law: &'a RadiusLaw) -> Result<Vec<Part<'a>>> {
    check_joints(path)?;
    let whole = path.length();
    let (mut parts, mut before) = (Vec::new(), 0.0);
    for (source, arc) in path.arcs().iter().enumerate() {
        for arc in arc.in_parts(LARGEST_ARC)? {
            let length = arc.length();
            let at = [before / whole, ((before + length) / whole).min(1.0)];
            parts.extend((Part { arc: arc.evened(), at, source, law, whole }).at_knots()?);
            before += length;
        }
    }
    Ok(parts)
}

pub(super) fn too_many(source: usize, cap: usize) -> Error {
    let (needed, remedy) = ((cap + 1) as f64, "use a larger tolerance");
    Error::Number(NumberError::TooManyPieces {
        what: "the tube up to piece",
        segment: Some(source),
        needed,
        cap,
        remedy,
    })
}

fn check_joints(path: &ArcPath) -> Result<()> {
    let arcs = path.arcs();
    let n = arcs.len();
    for joint in 0..n {
        if joint == 0 && !path.is_closed() {
            continue;
        }
        let (arc_before, arc_behind) = (&arcs[(joint + n - 1) % n], &arcs[joint]);
        let (Some(before), Some(behind)) = (arc_before.end_tangent(), arc_behind.start_tangent()) else {
            return Err(PointError::ZeroTangent { index: joint }.into());
        };
        let (turn, smooth) = (before.angle(behind), largest_smooth_turn(arc_before, arc_behind));
        if turn > smooth {
            return Err(PipeError::CornerNotMitred { joint, turn, smooth, limit: smooth }.into());
        }
    }
    Ok(())
}

impl<'a> Part<'a> {
    /// Its parts between the places of the law.
    fn at_knots(self) -> Result<Vec<Self>> {
        let [from, to] = self.at;
        let mut parts = vec![self];
        let law = parts[0].law;
        // What is nearer than rounding to an end is it.
        let inside = |at: &f64| *at > from + 1e-12 && *at < to - 1e-12;
        for place in law.places().filter(inside) {
            if let Some(last) = parts.pop() {
                parts.extend(last.split_at(place)?);
            }
        }
        Ok(parts)
    }

    pub(super) fn split_at(self, place: f64) -> Result<[Self; 2]> {
        let [from, to] = self.at;
        let t = self.arc.parameter_at_length((place - from) / (to - from));
        let (first, second) = self.arc.split(t)?;
        let part = |arc: Arc, at| Self { arc: arc.evened(), at, ..self.clone() };
        Ok([part(first, [from, place]), part(second, [place, to])])
    }

    pub(super) fn length(&self) -> f64 {
        (self.at[1] - self.at[0]) * self.whole
    }

    /// Radius, and its slope and second derivative by the length; at its end those before it.
    pub(super) fn radius(&self, at: f64, before: bool) -> [f64; 3] {
        let [r, first, second] = self.law.jet(at, before);
        [r, first / self.whole, second / (self.whole * self.whole)]
    }

    /// Adds its arcs.
    fn add(self, tolerance: f64, halvings: u32, made: &mut Along) -> Result<()> {
        let [[r0, m0, _], [r1, m1, _]] = [self.radius(self.at[0], false), self.radius(self.at[1], true)];
        let ends = [Ball::new(self.arc.start(), r0), Ball::new(self.arc.end(), r1)];
        let ways = [self.arc.start_tangent(), self.arc.end_tangent()];
        let [Some(v0), Some(v1)] = ways else { return Err(PointError::ZeroTangent { index: self.source }.into()) };
        for rate in [m0, m1] {
            if !(rate.abs() < 1.0) {
                return Err(TubeError::RadiusGrowsTooFast { piece: self.source, rate: rate.abs(), limit: 1.0 }.into());
            }
        }
        if made.arcs.len() >= made.cap {
            return Err(too_many(self.source, made.cap));
        }
        let slope = (r1 - r0) / self.length();
        let linear = (m0 - slope).abs().max((m1 - slope).abs()) <= LINEAR;
        if linear && self.arc.is_straight() {
            let arc = BallArc::straight(ends, self.source);
            made.arcs.push(arc.ok_or(TubeError::RadiusGrowsTooFast {
                piece: self.source,
                rate: slope.abs(),
                limit: 1.0,
            })?);
            return Ok(());
        }
        let unit = |v, r: f64| (Way { v, r }) * (1.0 / ((1.0 - r) * (1.0 + r)).sqrt());
        if linear && slope == 0.0 {
            let tangents = [unit(v0, 0.0), unit(v1, 0.0)];
            let reach = 0.5 * self.arc.chord().length() / (0.5 * self.arc.angle()).cos();
            made.arcs.push(BallArc::new(ends, tangents, reach, self.source));
            return Ok(());
        }
        if let Some(pair) = BallArc::biarc(ends, [unit(v0, m0), unit(v1, m1)], self.source) {
            let bound = self.distance(&pair, tolerance);
            if bound <= tolerance {
                made.bound = made.bound.max(bound);
                made.arcs.extend(pair);
                return Ok(());
            }
        }
        let middle = 0.5 * (self.at[0] + self.at[1]);
        if halvings == 0 || !(self.at[0] < middle && middle < self.at[1]) {
            return Err(too_many(self.source, made.cap));
        }
        let [first, second] = self.split_at(middle)?;
        first.add(tolerance, halvings - 1, made)?;
        second.add(tolerance, halvings - 1, made)
    }

    /// A bound of the distance from the balls of both arcs: between places that belong together, and what both bend between them.
    fn distance(&self, pair: &[BallArc; 2], tolerance: f64) -> f64 {
        let mut places = PLACES[0];
        loop {
            let [measured, between] = self.measured(pair, places);
            let enough = between <= 0.25 * tolerance || measured > tolerance || places >= PLACES[1];
            if enough {
                return measured + between;
            }
            places *= 2;
        }
    }

    fn measured(&self, pair: &[BallArc; 2], places: usize) -> [f64; 2] {
        let length = self.length();
        let bends =
            self.arc.curvature() + self.radius(self.at[0], false)[2].abs().max(self.radius(self.at[1], true)[2].abs());
        let (mut measured, mut between, mut way) = (0.0_f64, 0.0_f64, 0.0);
        for (which, arc) in pair.iter().enumerate() {
            for k in 1..=places {
                let s = [k - 1, k].map(|k| k as f64 / places as f64);
                let ball = arc.ball(s[1]);
                let at_end = which == 1 && k == places;
                let next = if at_end { length } else { self.arc.length_to(self.arc.closest_point(ball.center).t) };
                if next < way {
                    return [f64::INFINITY, 0.0];
                }
                let part = (next / length).clamp(0.0, 1.0);
                let [radius, ..] = self.radius(self.at[0] + (self.at[1] - self.at[0]) * part, true);
                let own = Ball::new(self.arc.point_at_length(part), radius);
                measured = measured.max(own.distance(ball));
                between = between.max(arc.sagitta(s) + bends * (next - way) * (next - way) / 8.0);
                way = next;
            }
        }
        [measured, between]
    }
}
