//! The shell of a tube of circles: four faces over each piece, and those that close its ends.

use super::piece::Piece;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::PipeEnds;
use crate::construct::bodies::bands::{Bands, Ring};
use crate::construct::bodies::carried::{Carrier, surface_of};
use crate::construct::bodies::smooth_joint::rounding_of_direction;
use crate::curve::Arc;
use crate::error::{Error, PointError, Result};
use crate::rational::{Polynomial, PolynomialRow, RationalBezier, RationalBezierSurface};
use crate::topology::{EdgeCurve, Shell};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

/// A closed spine that comes back turned about itself by less is not twisted.
const NOT_TWISTED: f64 = 1e-10;

/// A place between pieces.
#[derive(Debug, Clone, Copy)]
struct Station {
    center: Point3,
    /// Along the spine, unit.
    axis: Vec3,
    /// To the first end of the quarters, unit.
    across: Vec3,
    radius: f64,
}

/// The circles between the pieces.
pub(super) struct Stations {
    /// Before each piece, and behind the last one of an open spine.
    list: Vec<Station>,
    closed: bool,
    /// Of a closed spine: the piece that is twisted, and by which angle; by how many quarters the last ring is renumbered.
    twist: Option<(usize, f64)>,
    quarters: usize,
}

impl Station {
    fn directions(&self) -> [Vec3; 4] {
        let (u, v) = (self.across, self.axis.cross(self.across));
        [u, v, -u, -v]
    }

    fn ring(&self, bands: &mut Bands, depth: f64) -> Result<Ring> {
        let points = self.directions().map(|d| self.center + d * (self.radius - depth));
        let ratio = Quat::from_parts(FRAC_1_SQRT_2, self.axis * FRAC_1_SQRT_2);
        let quarter = |k: usize| Arc::from_ratio_across(points[k], points[(k + 1) % 4], ratio).map(EdgeCurve::from);
        Ok(bands.ring((0..4).map(quarter).collect::<Result<_>>()?, true))
    }
}

impl Stations {
    pub(super) fn new(pieces: &[Piece], closed: bool) -> Result<Self> {
        // The normal of the first arc: the seams of a plane tube lie in its plane and across it.
        let along = |piece: &Piece| {
            piece.arc.start_tangent().ok_or(Error::Point(PointError::ZeroTangent { index: piece.source }))
        };
        let first = along(&pieces[0])?;
        let bent = pieces.iter().find_map(|piece| piece.arc.normal());
        let level = bent.map(|normal| normal - first * normal.dot(first)).filter(|v| v.length() > 0.5);
        let mut across = level.and_then(Vec3::unit).unwrap_or_else(|| first.any_perpendicular());
        let mut list = Vec::with_capacity(pieces.len() + 1);
        for piece in pieces {
            let axis = along(piece)?;
            across = (across - axis * across.dot(axis)).unit().unwrap_or(across);
            list.push(Station { center: piece.arc.start(), axis, across, radius: piece.radius.value(0.0) });
            across = piece.arc.weight_ratio().rotate(across);
        }
        let mut made = Self { list, closed, twist: None, quarters: 0 };
        if let (false, Some(last)) = (closed, pieces.last()) {
            let axis = last.arc.end_tangent().ok_or(PointError::ZeroTangent { index: last.source })?;
            let across = (across - axis * across.dot(axis)).unit().unwrap_or(across);
            made.list.push(Station { center: last.arc.end(), axis, across, radius: last.radius.value(1.0) });
        } else {
            made.close(pieces, across);
        }
        Ok(made)
    }

    /// Leads the direction that a closed spine comes back with to the nearest one of the first station: the longest piece is twisted.
    fn close(&mut self, pieces: &[Piece], back: Vec3) {
        let first = self.list[0];
        let angle = first.across.dot(first.axis.cross(back)).atan2(first.across.dot(back));
        let quarters = (angle / FRAC_PI_2).round();
        let angle = angle - quarters * FRAC_PI_2;
        self.quarters = (-quarters).rem_euclid(4.0) as usize;
        let rounding: f64 = pieces.iter().map(|piece| rounding_of_direction(&piece.arc)).sum();
        if angle.abs() <= NOT_TWISTED + rounding {
            return;
        }
        let longest = pieces.iter().enumerate().max_by(|a, b| a.1.arc.length().total_cmp(&b.1.arc.length()));
        let piece = longest.map_or(0, |(k, _)| k);
        self.twist = Some((piece, angle));
        for station in self.list.iter_mut().skip(piece + 1) {
            station.across = Quat::from_axis_angle(station.axis, angle).rotate(station.across);
        }
    }

    fn twist_of(&self, piece: usize) -> f64 {
        self.twist.filter(|(twisted, _)| *twisted == piece).map_or(0.0, |(_, angle)| angle)
    }

    /// The skin of a tube thinner by a depth, closed by its ends.
    pub(super) fn skin(&self, pieces: &[Piece], depth: f64, ends: PipeEnds) -> Result<Shell> {
        let mut bands = Bands::default();
        let rings = self.rings(&mut bands, pieces.len(), depth)?;
        if !self.closed && ends != PipeEnds::Open {
            self.end(&mut bands, pieces, &rings, depth, (false, ends))?;
            self.end(&mut bands, pieces, &rings, depth, (true, ends))?;
        }
        self.sides(&mut bands, pieces, &rings, depth, false)?;
        Ok(bands.finish()?.outer)
    }

    /// The skin of an open tube with a bore, plane rings between their ends.
    pub(super) fn with_bore(&self, pieces: &[Piece], wall: f64) -> Result<Shell> {
        let mut bands = Bands::default();
        let outer = self.rings(&mut bands, pieces.len(), 0.0)?;
        let inner = self.rings(&mut bands, pieces.len(), wall)?;
        let last = outer.len() - 1;
        bands.ruled([&inner[0], &outer[0]])?;
        self.sides(&mut bands, pieces, &outer, 0.0, false)?;
        bands.ruled([&outer[last], &inner[last]])?;
        self.sides(&mut bands, pieces, &inner, wall, true)?;
        Ok(bands.finish()?.outer)
    }

    /// The ring before each piece, and that behind the last one.
    fn rings(&self, bands: &mut Bands, pieces: usize, depth: f64) -> Result<Vec<Ring>> {
        let mut rings: Vec<Ring> = self.list.iter().map(|station| station.ring(bands, depth)).collect::<Result<_>>()?;
        if rings.len() == pieces {
            rings.push(rings[0].turned(self.quarters));
        }
        Ok(rings)
    }

    /// The faces over all pieces, from each ring to the next, or back for a bore.
    fn sides(&self, bands: &mut Bands, pieces: &[Piece], rings: &[Ring], depth: f64, back: bool) -> Result<()> {
        for (k, piece) in pieces.iter().enumerate() {
            let tube = Over::new(piece, self.list[k].axis, self.twist_of(k), depth);
            let directions = self.list[k].directions();
            let across = |i: usize, [start, end]: [Point3; 2]| tube.line(directions[i % 4], [start, end], back);
            let surface = |_: &Bands, i: usize| tube.face([directions[i], directions[(i + 1) % 4]], back);
            let pair = if back { [&rings[k + 1], &rings[k]] } else { [&rings[k], &rings[k + 1]] };
            bands.band(pair, across, surface)?;
        }
        Ok(())
    }

    /// A disk or a part of a ball on an end.
    fn end(
        &self,
        bands: &mut Bands,
        pieces: &[Piece],
        rings: &[Ring],
        depth: f64,
        (last, ends): (bool, PipeEnds),
    ) -> Result<()> {
        let (station, ring) =
            if last { (self.list[self.list.len() - 1], &rings[rings.len() - 1]) } else { (self.list[0], &rings[0]) };
        if ends == PipeEnds::Flat {
            let center = bands.pole(station.center, ring);
            return bands.ruled(if last { [ring, &center] } else { [&center, ring] });
        }
        let slope = if last { pieces[pieces.len() - 1].slopes[1] } else { -pieces[0].slopes[0] };
        let outwards = if last { station.axis } else { -station.axis };
        let cap = Cap::new(station.radius - depth, slope);
        let pole = bands.pole(station.center + outwards * cap.apex(), ring);
        let directions = station.directions();
        let across = |i: usize, [start, end]: [Point3; 2]| {
            let axis = directions[i % 4].cross(if last { outwards } else { -outwards });
            let half = (0.5 * cap.angle).sin_cos();
            Arc::from_ratio_across(start, end, Quat::from_parts(half.1, axis * half.0)).map(EdgeCurve::from)
        };
        let surface =
            |_: &Bands, i: usize| cap.face(station.center, outwards, [directions[i], directions[(i + 1) % 4]], !last);
        bands.band(if last { [ring, &pole] } else { [&pole, ring] }, across, surface)
    }
}

/// The ends of a quarter as homogeneous control directions of the circle, with their weights.
fn quarter([from, to]: [Vec3; 2]) -> [(Vec3, f64); 3] {
    [(from, 1.0), ((from + to) * FRAC_1_SQRT_2, FRAC_1_SQRT_2), (to, 1.0)]
}

/// The tube over a piece.
struct Over {
    carrier: Carrier,
    radius: Polynomial,
}

impl Over {
    fn new(piece: &Piece, axis: Vec3, twist: f64, depth: f64) -> Self {
        let radius = &piece.radius + &Polynomial::constant(-depth);
        Self { carrier: Carrier::new(piece.arc, axis, twist), radius }
    }

    fn face(&self, ways: [Vec3; 2], back: bool) -> Result<RationalBezierSurface> {
        surface_of(quarter(ways).map(|way| self.carrier.row(way, &self.radius)).to_vec(), back)
    }

    fn line(&self, way: Vec3, [start, end]: [Point3; 2], back: bool) -> Result<EdgeCurve> {
        let degree = self.radius.degree();
        if self.carrier.is_straight() && degree <= 1 {
            return Ok(Arc::segment(start, end)?.into());
        }
        if let (0, Some(ratio)) = (degree, self.carrier.ratio()) {
            let ratio = if back { Quat::from_parts(ratio.w, -ratio.vector()) } else { ratio };
            return Ok(Arc::from_ratio_across(start, end, ratio)?.into());
        }
        let line = RationalBezier::from_polynomial_row(&self.carrier.row((way, 1.0), &self.radius));
        Ok(EdgeCurve::Rational(if back { line.reversed() } else { line }))
    }
}

/// The part of a ball beyond a circle of it, which goes on with a slope: by `(r', 1)` from the circle outwards.
struct Cap {
    /// Radius of the ball, and of the circle.
    ball: f64,
    circle: f64,
    /// Height of the center above the circle.
    center: f64,
    /// From the circle to the apex, seen from the center.
    angle: f64,
}

impl Cap {
    fn new(circle: f64, slope: f64) -> Self {
        let (ball, center) = (circle * 1.0_f64.hypot(slope), circle * slope);
        Self { ball, circle, center, angle: circle.atan2(-center).min(std::f64::consts::PI) }
    }

    fn apex(&self) -> f64 {
        self.center + self.ball
    }

    fn face(&self, base: Point3, outwards: Vec3, ways: [Vec3; 2], back: bool) -> Result<RationalBezierSurface> {
        let (sin, cos) = (0.5 * self.angle).sin_cos();
        let radii = Polynomial::new(vec![self.circle, self.ball * sin, 0.0]);
        let heights = Polynomial::new(vec![0.0, self.apex() * cos, self.apex()]);
        let weights = Polynomial::new(vec![1.0, cos, 1.0]);
        let axis = base.to_vec().to_array().map(|x| &weights * x);
        let up = outwards.to_array().map(|x| &heights * x);
        let meridian = PolynomialRow([&axis[0] + &up[0], &axis[1] + &up[1], &axis[2] + &up[2], weights]);
        let row = |(way, weight): (Vec3, f64)| {
            let out = PolynomialRow::direction(way.to_array().map(|x| &radii * x));
            &(&meridian * weight) + &out
        };
        surface_of(quarter(ways).map(row).to_vec(), back)
    }
}
