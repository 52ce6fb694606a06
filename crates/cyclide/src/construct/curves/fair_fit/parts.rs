//! The smooth pieces of a fair fit put together: each fitted in the working frame, back in the user's coordinates with its
//! proof sheet, then the whole curve with its certificate and warnings.

use super::certificate::{PieceSheet, certify};
use super::doubts::{Doubts, Swing, swing};
use super::feet::COLD;
use super::fit::Data;
use super::measured::Measured;
use super::removal::{RemovalLimits, Stop};
use super::run::{Outcome, Reached, floor, run};
use super::working_frame::WorkingFrame;
use super::{FairFit, FairFitCertificate, FairFitOptions};
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::input::Distinct;
use crate::construct::curves::outline::kept_corners;
use crate::curve::{BlendSegment, CircleSpline};
use crate::error::{FitError, Result};
use crate::rational::RationalBezier;
use crate::warning::Warning;
use std::f64::consts::PI;

/// Measured points are farther from their curve than this many times what they are as a rule if they are outliers.
const MOST_OF_NOISE: f64 = 4.0;

/// The smooth pieces of a fit so far.
pub(super) struct Parts<'a> {
    data: &'a [Point3],
    /// What the curve keeps to: the tolerance asked for, or less.
    tolerance: f64,
    frame: &'a WorkingFrame,
    options: &'a FairFitOptions,
    /// What the data were before their noise was taken off: it is what the proof sheet is about.
    measured: Option<Measured<'a>>,
    /// Places on the edge after each point that are bound too.
    on_edges: Vec<usize>,
    spline: Vec<BlendSegment>,
    kinks: Vec<usize>,
    pieces: Vec<PieceFit>,
}

/// What is known about one piece.
pub(super) struct PieceFit {
    pub sheet: PieceSheet,
    /// Where the curve swings out between the points.
    pub swing: Option<Swing>,
    /// The number of each of its points among the distinct ones.
    pub numbers: Vec<usize>,
    /// `J`, and the length of its points, smoothed as the start of the fit was.
    pub fairness: f64,
    pub length: f64,
    /// Nodes of the curve, and of the first fit.
    pub nodes: usize,
    pub first_nodes: usize,
    /// Why there are no fewer.
    pub stop: Stop,
}

impl<'a> Parts<'a> {
    pub fn new(
        data: &'a [Point3],
        tolerance: f64,
        frame: &'a WorkingFrame,
        options: &'a FairFitOptions,
        measured: Option<Measured<'a>>,
        on_edges: Vec<usize>,
    ) -> Self {
        Self {
            data,
            tolerance,
            frame,
            options,
            measured,
            on_edges,
            spline: Vec::new(),
            kinks: Vec::new(),
            pieces: Vec::new(),
        }
    }

    /// Fits one smooth piece: the points with these numbers, closed or with ends that may be fixed.
    pub fn add(&mut self, numbers: &[usize], closed: bool, fixed: [bool; 2]) -> Result<()> {
        let (frame, options) = (self.frame, self.options);
        let points: Vec<Point3> = numbers.iter().map(|i| self.data[*i]).collect();
        // The edge to the next point begins at that one where the data run backwards.
        let count = self.data.len();
        let edge = |k: usize| {
            let (i, next) = (numbers[k], numbers[(k + 1) % numbers.len()]);
            if next == (i + 1) % count { i } else { next }
        };
        let on_edges: Vec<usize> = (0..numbers.len()).map(|k| self.on_edges[edge(k)]).collect();
        let (bound, own) = with_edge_points(&points, closed, &on_edges);
        let local: Vec<Point3> = bound.iter().map(|p| frame.to_local(*p)).collect();
        let fixed = if closed { [false; 2] } else { fixed };
        let tolerance = frame.length(self.tolerance);
        let FairFitOptions { centre, max_fits, nodes, budget, .. } = *options;
        let (planar, floor) = (frame.planar(), floor(&local, closed, tolerance));
        let data = Data { points: &local, closed, planar, fixed, tolerance, centre, floor };
        let limits = RemovalLimits { fits: max_fits, nodes: nodes.unwrap_or(0), budget };
        let Reached { fit, stop, first: first_nodes, length } = match run(&data, &limits) {
            Outcome::Reached(reached) => reached,
            Outcome::Missed { outside, farthest } => {
                let mut points: Vec<usize> =
                    outside.iter().map(|i| numbers[own.partition_point(|k| k <= i) - 1]).collect();
                points.dedup();
                let deviation = farthest / frame.length(1.0);
                return Err(FitError::ToleranceNotReached { points, deviation, tolerance: options.tolerance }.into());
            }
        };
        let nodes = &fit.curve.nodes;
        let ends = [(0, 0), (nodes.len() - 1, points.len() - 1)];
        let mut world: Vec<Point3> = nodes.iter().map(|x| frame.to_world(*x)).collect();
        for (fixed, (node, point)) in fixed.into_iter().zip(ends) {
            if fixed {
                world[node] = points[point];
            }
        }
        let tangents: Vec<_> = fit.curve.tangents.iter().map(|t| frame.direction_to_world(*t)).collect();
        if !self.spline.is_empty() || (options.closed && !closed) {
            self.kinks.push(self.spline.len());
        }
        let first = self.spline.len();
        for i in 0..fit.curve.segments.len() {
            let j = (i + 1) % nodes.len();
            self.spline.push(BlendSegment::fair(world[i], tangents[i], world[j], tangents[j], 1.0)?);
        }
        let mut points = points;
        let places: Vec<_> = own.iter().map(|i| fit.feet[*i].place).collect();
        let mut feet: Vec<f64> = places.iter().map(|place| place.position()).collect();
        if let Some(measured) = self.measured {
            points = numbers.iter().map(|i| measured.points[*i]).collect();
            let local: Vec<Point3> = points.iter().map(|p| frame.to_local(*p)).collect();
            feet = fit.curve.feet(&local, places.into_iter(), COLD).iter().map(|f| f.place.position()).collect();
        }
        let quartics: Vec<RationalBezier> = self.spline[first..].iter().filter_map(BlendSegment::to_bezier).collect();
        let sheet = certify(&quartics, closed, &points, &feet);
        // The curve is as far from the edges of measured points as from these.
        let rms = (sheet.squares / points.len() as f64).sqrt();
        let kept_to = if self.measured.is_some() { sheet.vertex.0.min(MOST_OF_NOISE * rms) } else { self.tolerance };
        self.pieces.push(PieceFit {
            swing: swing(&quartics, closed, &points, &feet, kept_to, self.measured.is_some()),
            sheet,
            numbers: numbers.to_vec(),
            fairness: fit.fairness * frame.length(1.0).powi(3),
            length: length / frame.length(1.0),
            nodes: nodes.len(),
            first_nodes,
            stop,
        });
        Ok(())
    }

    /// The whole curve with its certificate and warnings.
    pub fn finished(self, distinct: &Distinct, corners: &[(usize, f64)]) -> Result<FairFit> {
        let (options, source) = (self.options, &distinct.source);
        let sheet = self.certificate(distinct);
        if self.measured.is_none() && sheet.deviation > options.tolerance {
            // Only the rounding of coordinates far larger than the tolerance can do that.
            let points = vec![sheet.worst];
            return Err(FitError::ToleranceNotReached {
                points,
                deviation: sheet.deviation,
                tolerance: options.tolerance,
            }
            .into());
        }
        let mut warnings: Vec<Warning> = distinct.warnings.clone();
        warnings.extend(kept_corners(corners, source));
        let spline = CircleSpline::from_segments(self.spline, options.closed, self.kinks, Vec::new());
        let doubts = Doubts {
            data: &distinct.points,
            source,
            pieces: &self.pieces,
            spline: &spline,
            sheet: &sheet,
            options,
            kept_to: self.tolerance,
            measured: self.measured.is_some(),
        };
        warnings.extend(doubts.all());
        let in_users_numbers =
            |piece: &PieceFit| piece.swing.map(|swing| Swing { point: source[piece.numbers[swing.point]], ..swing });
        let swing = Swing::largest(self.pieces.iter().filter_map(in_users_numbers));
        let beside = |piece: &PieceFit| (piece.sheet.beside.0, source[piece.numbers[piece.sheet.beside.1]]);
        let beside = self.pieces.iter().map(beside).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default();
        Ok(FairFit { spline, certificate: sheet, warnings, swing, beside, corners: Vec::new() })
    }

    fn certificate(&self, distinct: &Distinct) -> FairFitCertificate {
        let mut sheet = FairFitCertificate {
            deviation: 0.0,
            rms: 0.0,
            polyline_deviation: 0.0,
            monotone: true,
            worst: 0,
            nodes: self.spline.len() + usize::from(!self.options.closed),
            deviation_z: None,
            noise: None,
            noise_z: None,
            fairness: 0.0,
        };
        let mut squares = 0.0;
        for PieceFit { sheet: piece, numbers, fairness, .. } in &self.pieces {
            if piece.vertex.0 > sheet.deviation {
                sheet.deviation = piece.vertex.0;
                sheet.worst = distinct.source[numbers[piece.vertex.1]];
            }
            squares += piece.squares;
            sheet.polyline_deviation = sheet.polyline_deviation.max(piece.polyline);
            sheet.monotone &= piece.back.is_none();
            sheet.fairness += fairness;
        }
        sheet.deviation += distinct.moved;
        sheet.polyline_deviation += distinct.moved;
        sheet.rms = (squares / distinct.points.len() as f64).sqrt();
        sheet
    }
}

/// The points with so many places on the edges between them, and which of all are points.
fn with_edge_points(points: &[Point3], closed: bool, on_edges: &[usize]) -> (Vec<Point3>, Vec<usize>) {
    let n = points.len();
    let (mut all, mut own) = (Vec::with_capacity(n), Vec::with_capacity(n));
    for (i, p) in points.iter().enumerate() {
        own.push(all.len());
        all.push(*p);
        if closed || i + 1 < n {
            let (next, steps) = (points[(i + 1) % n], on_edges[i] + 1);
            // Denser towards the ends, where samples may be far closer together.
            let part = |k: usize| 0.5 * (1.0 - (PI * k as f64 / steps as f64).cos());
            all.extend((1..steps).map(|k| p.lerp(next, part(k))));
        }
    }
    (all, own)
}
