//! What a user should know about a fair fit: each doubt with what was measured (`docs/math/fair-fits.md#limits`).

use super::FairFitCertificate;
use super::certificate::{at, projection};
use super::options::FairFitOptions;
use super::parts::PieceFit;
use super::removal::Stop;
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::arc_fit::corners::sagitta_quantile;
use crate::construct::curves::outline::SAMPLE_SAGITTA;
use crate::curve::{CircleSpline, length};
use crate::rational::RationalBezier;
use crate::warning::{CurveWarning, FitWarning, NoiseWarning, Warning};

/// Above this part of the tolerance the root mean square of the distances says that the curve leans on its bounds.
const LEANING: f64 = 0.55;
/// More nodes than this part of the points follow each of them.
const MANY: f64 = 1.0 / 3.0;
/// Fewer points to a node than this do not tell noise from the way the curve swings between its bounds.
const POINTS_TO_A_NODE: usize = 6;
/// Fewer points than this say nothing about noise.
const FEW_POINTS: usize = 24;
/// A curve shorter than this part of the length of the smoothed points has lost shape.
const LENGTH_KEPT: f64 = 0.8;
/// Feet step back by less than this part of a closed curve.
const BACK: f64 = 0.25;
/// Steps in which the curve over an edge is looked at.
const SWING_PLACES: u32 = 8;

/// What is asked about.
pub(super) struct Doubts<'a> {
    /// The distinct points, and the number of each in the user's list.
    pub data: &'a [Point3],
    pub source: &'a [usize],
    pub pieces: &'a [PieceFit],
    pub spline: &'a CircleSpline,
    pub sheet: &'a FairFitCertificate,
    pub options: &'a FairFitOptions,
    /// What the curve keeps to.
    pub kept_to: f64,
    /// The data have had noise, which the certificate tells.
    pub measured: bool,
}

impl Doubts<'_> {
    pub fn all(&self) -> Vec<Warning> {
        let found = [
            self.ends_without_effect(),
            self.shape_smoothed_away(),
            self.feet_not_monotone(),
            self.samples_too_coarse(),
            self.nodes_not_reached(),
            self.many_nodes(),
            self.leans_on_walls(),
        ];
        found.into_iter().flatten().collect()
    }

    fn ends_without_effect(&self) -> Option<Warning> {
        (self.options.closed && self.options.fix_ends).then_some(Warning::Curve(CurveWarning::EndsWithoutEffect))
    }

    fn shape_smoothed_away(&self) -> Option<Warning> {
        let data = self.pieces.iter().map(|piece| piece.length).sum::<f64>();
        let curve = length(self.spline);
        (curve < LENGTH_KEPT * data).then_some(Warning::Fit(FitWarning::ShapeSmoothedAway { curve, data }))
    }

    fn feet_not_monotone(&self) -> Option<Warning> {
        if self.measured {
            // Noisy points step back as their noise wills.
            return None;
        }
        let back = |piece: &PieceFit| piece.sheet.back.map(|(point, count)| (self.source[piece.numbers[point]], count));
        let mut backs = self.pieces.iter().filter_map(back);
        let (point, first) = backs.next()?;
        Some(Warning::Noise(NoiseWarning::FeetNotMonotone {
            point,
            count: first + backs.map(|(_, count)| count).sum::<usize>(),
        }))
    }

    fn samples_too_coarse(&self) -> Option<Warning> {
        if self.options.edge_points == 0 {
            return None;
        }
        let (sagitta, limit) = (sagitta_quantile(self.data, self.options.closed, 0.5), self.options.tolerance);
        (sagitta > limit).then_some(Warning::Fit(FitWarning::EdgesTooCoarse { sagitta, limit }))
    }

    /// The piece that is farthest from the number of nodes asked for, and why.
    fn nodes_not_reached(&self) -> Option<Warning> {
        let asked = self.options.nodes?;
        let off = |piece: &&PieceFit| piece.nodes.abs_diff(asked);
        let piece = self.pieces.iter().filter(|piece| piece.nodes != asked).max_by_key(off)?;
        let reached = piece.nodes;
        let why = match piece.stop {
            _ if reached < asked && piece.first_nodes < asked => "first-fit",
            _ if reached < asked => return None,
            Stop::Fewest => "fewest",
            Stop::Data => "tolerance",
            Stop::Budget => "budget",
            Stop::Fits => "max-fits",
        };
        Some(Warning::Fit(FitWarning::NodesNotReached { asked, reached, why }))
    }

    fn many_nodes(&self) -> Option<Warning> {
        let (nodes, points) = (self.sheet.nodes, self.data.len());
        let many = !self.measured && points >= FEW_POINTS && nodes as f64 > MANY * points as f64;
        let changes = || changes(self.data, self.options.closed, self.kept_to);
        many.then(|| FitWarning::of_many_nodes(nodes, points, changes()))
    }

    fn leans_on_walls(&self) -> Option<Warning> {
        let (rms, limit) = (self.sheet.rms, LEANING * self.kept_to);
        if self.measured || self.options.centre > 0.0 || rms <= limit {
            return None;
        }
        let (sum, count) = self.pieces.iter().fold((0.0, 0), |(sum, count), piece| {
            let (more, terms) = piece.sheet.roughness;
            (sum + more, count + terms)
        });
        // Fourth differences of independent errors have 1 + 16 + 36 + 16 + 1 times their variance. With few points to a
        // node, what is left is as rough without any noise.
        let told = count >= POINTS_TO_A_NODE * self.sheet.nodes;
        let scatter = told.then(|| (sum / (70 * count.max(1)) as f64).sqrt());
        Some(Warning::Noise(NoiseWarning::LeansOnWalls { rms, limit, scatter }))
    }
}

/// A curve leaves an edge by a quarter of its length and the turn at an end, of samples of a circle; by half as much more of others.
const BULGE: f64 = 1.5 / 4.0;

/// A curve is lost where it is farther from an edge than the length of that and this many tolerances.
pub(super) const LOST: f64 = 8.0;

/// How far a curve swings out between two points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Swing {
    /// The first of them.
    pub point: usize,
    /// From their edge.
    pub distance: f64,
    /// What samples explain: the tolerance, and [`SAMPLE_SAGITTA`] of the edge or what the turns at its ends do.
    pub limit: f64,
    /// It is farther from the edge than that is long, and than noise can have it.
    pub is_lost: bool,
}

impl Swing {
    /// The one that exceeds its limit by most.
    pub fn largest(all: impl Iterator<Item = Self>) -> Option<Self> {
        all.max_by(|a, b| (a.distance - a.limit).total_cmp(&(b.distance - b.limit)))
    }
}

/// How far the curve is from the edge that it leaves by most above what samples explain. Positions of the feet of the points are `segment + parameter`.
pub(super) fn swing(
    curve: &[RationalBezier],
    closed: bool,
    points: &[Point3],
    feet: &[f64],
    kept_to: f64,
    measured: bool,
) -> Option<Swing> {
    let (n, m) = (points.len(), curve.len() as f64);
    let edges = if closed { n } else { n - 1 };
    let turn = |k: usize| {
        let inside = closed || (k > 0 && k + 1 < n);
        inside.then(|| (points[k] - points[(k + n - 1) % n]).angle(points[(k + 1) % n] - points[k]))
    };
    let off = |k: usize| {
        let (a, b) = (points[k], points[(k + 1) % n]);
        // Over the seam of a closed curve, there and back.
        let lap = if closed { m * ((feet[k] - feet[(k + 1) % n]) / m - BACK).ceil() } else { 0.0 };
        let to = feet[(k + 1) % n] + lap;
        let length = a.distance(b);
        // A smooth curve turns as much at the ends of an edge as over half of it; at the ends of a piece nobody knows, and the turns
        // of measured points are those of their noise too.
        let most = [k, (k + 1) % n].into_iter().filter_map(turn).fold(0.0, f64::max);
        let of_turn = if measured { f64::INFINITY } else { kept_to + BULGE * most * length };
        let limit = kept_to + (SAMPLE_SAGITTA * length).min(of_turn);
        let distance = |i: u32| {
            let position = feet[k] + (to - feet[k]) * f64::from(i) / f64::from(SWING_PLACES);
            let p = at(curve, if closed { position.rem_euclid(m) } else { position });
            p.distance(a.lerp(b, projection([a, b], p, [0.0, 1.0])))
        };
        let distance = (1..SWING_PLACES).map(distance).fold(0.0, f64::max);
        Swing { point: k, distance, limit, is_lost: distance > LOST * kept_to + length }
    };
    Swing::largest((0..edges).map(off).filter(|swing| swing.distance > swing.limit))
}

/// How often the polyline changes the side it turns to, in space by more than a right angle: at points that stand out from
/// their neighbors by more than the tolerance.
fn changes(points: &[Point3], closed: bool, tolerance: f64) -> usize {
    let n = points.len();
    let turn = |i: usize| {
        let (a, b, c) = (points[i], points[(i + 1) % n], points[(i + 2) % n]);
        let turn = (b - a).cross(c - b);
        (turn.length() > tolerance * (c - a).length()).then_some(turn)
    };
    let turns = (0..if closed { n } else { n.saturating_sub(2) }).filter_map(turn);
    let mut last = Vec3::ZERO;
    turns.filter(|t| std::mem::replace(&mut last, *t).dot(*t) < 0.0).count()
}
