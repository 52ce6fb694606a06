//! The spine of a pipe with a direction across it that is carried along: stations between pieces that turn by a third of a
//! turn at most.

use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::LARGEST_ARC;
use crate::construct::bodies::smooth_joint::{largest_smooth_turn, rounding_of_direction};
use crate::curve::{Arc, ArcPath, ParamCurve as _};
use crate::error::{PipeError, PointError, Result};
use std::f64::consts::FRAC_PI_2;

/// A closed spine that comes back turned about itself by less is not twisted.
const NOT_TWISTED: f64 = 1e-10;
/// Largest turn of a corner that is mitered: the miter is ten times as long as the radius.
const LARGEST_TURN: f64 = 2.942;
/// The radius of a pipe is below that of its arcs by at least this part.
const NARROWER: f64 = 1e-9;

/// A spine made ready.
pub(super) struct Spine {
    pub(super) pieces: Vec<Piece>,
    /// Before each piece, and behind the last one of an open spine.
    pub(super) stations: Vec<Station>,
    pub(super) closed: bool,
    /// The piece that is twisted, by which angle, and by how many quarters it is renumbered: of a closed spine.
    pub(super) twist: Option<Twist>,
}

pub(super) struct Piece {
    /// With weights of equal length.
    pub(super) arc: Arc,
    /// Which arc of the path it is of.
    pub(super) source: usize,
    /// Tangent at the start.
    pub(super) along: Vec3,
    /// The rotation along it as the weight ratio of its arcs.
    pub(super) rotor: Quat,
}

/// A place between pieces.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station {
    pub(super) point: Point3,
    /// Tangents before and behind.
    pub(super) ways: [Vec3; 2],
    /// The first of the directions across, as seen from behind.
    pub(super) across: Vec3,
    /// True at a corner.
    pub(super) mitred: bool,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Twist {
    pub(super) piece: usize,
    pub(super) angle: f64,
    pub(super) quarters: usize,
}

impl Station {
    /// From the point to where the line along the spine meets the miter, for a way across the spine as it is behind.
    pub(super) fn slanted(&self, v: Vec3) -> Vec3 {
        if !self.mitred {
            return v;
        }
        let [before, behind] = self.ways;
        v - behind * (v.dot(before) / (1.0 + before.dot(behind)))
    }

    /// The directions to the ends of the quarters, as seen from behind.
    pub(super) fn directions(&self) -> [Vec3; 4] {
        let (u, v) = (self.across, self.ways[1].cross(self.across));
        [u, v, -u, -v]
    }
}

impl Spine {
    pub(super) fn new(path: &ArcPath, radius: f64) -> Result<Self> {
        let mut pieces = Vec::new();
        for (source, arc) in path.arcs().iter().enumerate() {
            if let Some(limit) = arc.radius().filter(|own| radius > own * (1.0 - NARROWER)) {
                return Err(PipeError::TooWide { piece: source, radius, limit }.into());
            }
            for part in arc.in_parts(LARGEST_ARC)? {
                let arc = part.evened();
                let along = arc.start_tangent().ok_or(PointError::ZeroTangent { index: source })?;
                pieces.push(Piece { arc, source, along, rotor: arc.weight_ratio() });
            }
        }
        let closed = path.is_closed();
        let mut spine = Self { pieces, stations: Vec::new(), closed, twist: None };
        spine.carry()?;
        spine.check_corners(radius)?;
        Ok(spine)
    }

    /// Carries a direction across the spine from the first station to the last.
    fn carry(&mut self) -> Result<()> {
        let n = self.pieces.len();
        // The normal of the first arc: the seams of a plane run lie in its plane and across it.
        let bent = self.pieces.iter().find_map(|piece| piece.arc.normal());
        let first = self.pieces[0].along;
        let level = bent.map(|normal| normal - first * normal.dot(first)).filter(|v| v.length() > 0.5);
        let mut across = level.and_then(Vec3::unit).unwrap_or_else(|| first.any_perpendicular());
        for k in 0..=n {
            let piece = |k: usize| &self.pieces[(k + n) % n];
            let end = |k: usize| piece(k).rotor.rotate(piece(k).along);
            let (before, behind) = match k {
                0 if !self.closed => (piece(0).along, piece(0).along),
                _ if k == n && !self.closed => (end(n - 1), end(n - 1)),
                _ => (end(k + n - 1), piece(k).along),
            };
            if k > 0 {
                across = piece(k - 1).rotor.rotate(across);
                across = across - (before + behind) * (across.dot(behind) / (1.0 + before.dot(behind)));
            }
            across = (across - behind * across.dot(behind)).unit().unwrap_or(across);
            let point = if k < n { piece(k).arc.start() } else { piece(n - 1).arc.end() };
            let smooth = largest_smooth_turn(&piece(k + n - 1).arc, &piece(k).arc);
            let mitred = before.angle(behind) > smooth;
            self.stations.push(Station { point, ways: [before, behind], across, mitred });
        }
        if self.closed {
            self.close();
        }
        Ok(())
    }

    /// The last station is the first one again, up to a turn about the spine.
    fn close(&mut self) {
        let Some(last) = self.stations.pop() else { return };
        let first = self.stations[0];
        let [u, v, ..] = last.directions();
        // By this the first station is ahead of the last one.
        let ahead = first.across.dot(v).atan2(first.across.dot(u));
        let quarters = (ahead / FRAC_PI_2).round();
        let angle = ahead - quarters * FRAC_PI_2;
        let straight = |piece: &Piece| piece.arc.is_straight();
        let longest = |straight_only: bool| {
            let fit = self.pieces.iter().enumerate().filter(|(_, piece)| !straight_only || straight(piece));
            fit.max_by(|a, b| a.1.arc.length().total_cmp(&b.1.arc.length())).map(|(k, _)| k)
        };
        let piece = longest(true).or_else(|| longest(false)).unwrap_or(0);
        // Quarter k at the end of the last piece is the quarter k - quarters at the first station.
        let quarters = (-quarters).rem_euclid(4.0) as usize;
        let rounding: f64 = self.pieces.iter().map(|piece| rounding_of_direction(&piece.arc)).sum();
        let twisted = angle.abs() > NOT_TWISTED + rounding;
        self.twist = Some(Twist { piece, angle: if twisted { angle } else { 0.0 }, quarters });
        if twisted {
            for k in piece + 1..self.stations.len() {
                let station = &mut self.stations[k];
                station.across = Quat::from_axis_angle(station.ways[1], angle).rotate(station.across);
            }
        }
    }

    fn check_corners(&self, radius: f64) -> Result<()> {
        let n = self.pieces.len();
        for (k, station) in self.stations.iter().enumerate().filter(|(_, station)| station.mitred) {
            let [before, behind] = station.ways;
            let turn = before.angle(behind);
            let neighbors = [&self.pieces[(k + n - 1) % n], &self.pieces[k % n]];
            if turn > LARGEST_TURN || neighbors.iter().any(|piece| !piece.arc.is_straight()) {
                let (joint, smooth) = (neighbors[1].source, largest_smooth_turn(&neighbors[0].arc, &neighbors[1].arc));
                return Err(PipeError::CornerNotMitred { joint, turn, smooth, limit: LARGEST_TURN }.into());
            }
        }
        for (k, piece) in self.pieces.iter().enumerate() {
            let (from, to) = (&self.stations[k], &self.stations[(k + 1) % self.stations.len()]);
            // How far a line of the tube ends behind the station, for a way v across: v·slope.
            let [before, behind] = from.ways;
            let start = if from.mitred { before * (-1.0 / (1.0 + before.dot(behind))) } else { Vec3::ZERO };
            let [before, behind] = to.ways;
            let end = if to.mitred { behind * (-1.0 / (1.0 + before.dot(behind))) } else { Vec3::ZERO };
            let slope = end - start;
            let needed = radius * (slope - piece.along * slope.dot(piece.along)).length();
            let length = piece.arc.chord().length();
            if needed >= length * (1.0 - NARROWER) {
                return Err(PipeError::MitreDoesNotFit { piece: piece.source, needed, length }.into());
            }
        }
        Ok(())
    }

    /// The station behind a piece, and by how many quarters it is renumbered there.
    pub(super) fn behind(&self, piece: usize) -> (usize, usize) {
        let next = (piece + 1) % self.stations.len();
        let renumbered = if next == 0 { self.twist.map_or(0, |twist| twist.quarters) } else { 0 };
        (next, renumbered)
    }
}
