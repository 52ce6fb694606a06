//! The curvature along one smooth piece, in units of the curve's length.

use super::super::cusps::{may_have_cusp, place_of_cusp};
use super::super::rest::{limit_curvature, place_of_curvature};
use super::{NOISE, Swing};
use crate::base::jet::CurveJet;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{ParamCurve, PieceForm};

/// Intervals of the samples of a cell.
const SAMPLES: usize = 8;
/// Halvings of a piece.
const DEPTH: u32 = 12;
/// Relative mismatch with the cubic at the middle of an interval that still counts as a cubic.
const CUBIC_LIMIT: f64 = 0.02;
/// Disagreement of two rules for the variation, relative to the piece's own or the mean one.
const AGREEMENT: f64 = 1e-4;
/// Curvatures at a stand are those of a place beside: off by up to this part of themselves, or of one over the length of the curve.
const KNOWN_AT_REST: f64 = 1e-5;
/// Rounding of a node by this part of the coordinates.
pub(super) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A place on a piece: curvature, its derivative by the arc length, and the speed. The unit of length is that of the
/// whole curve, so that nothing overflows.
#[derive(Debug, Clone, Copy, Default)]
struct Bend {
    k: f64,
    slope: f64,
    speed: f64,
    /// What rounding of the second derivative makes of the curvature: much where a piece is slow against the rest of it.
    noise: f64,
}

/// What a curve is measured with.
pub(super) struct Measure<'a> {
    pub(super) curve: &'a dyn ParamCurve,
    pub(super) length: f64,
    /// Of the curve's plane; `None` in space.
    pub(super) normal: Option<Vec3>,
}

/// An end of a piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct End {
    pub(super) point: Point3,
    pub(super) tangent: Vec3,
    /// Curvature vector.
    pub(super) curvature: Vec3,
    /// What the curvature may be off by where the piece stands.
    pub(super) noise: f64,
}

/// A piece with the samples of its curvature.
pub(super) struct Piece {
    index: usize,
    ends: [End; 2],
    chord: f64,
    rounding: f64,
    form: Form,
}

enum Form {
    /// An arc, a circle or a segment.
    Constant(f64),
    Free(Vec<Cell>),
    /// The curvature has no bound.
    Cusp,
}

/// A part of a piece on which the curvature between every second sample looks like a cubic.
#[derive(Debug, Clone, Copy)]
struct Cell {
    start: f64,
    width: f64,
    /// Roundings are so many times those of the piece about its own middle.
    off: f64,
    samples: [Bend; SAMPLES + 1],
}

impl Piece {
    pub(super) fn start(&self) -> End {
        self.ends[0]
    }

    pub(super) fn end(&self) -> End {
        self.ends[1]
    }

    /// Length of the chord, or to the middle where that is farther.
    pub(super) fn chord(&self) -> f64 {
        self.chord
    }

    /// What rounding of the coordinates makes of the curvature.
    pub(super) fn rounding(&self) -> f64 {
        self.rounding
    }

    pub(super) fn is_cusp(&self) -> bool {
        matches!(self.form, Form::Cusp)
    }

    pub(super) fn largest(&self) -> f64 {
        match &self.form {
            Form::Constant(k) => k.abs(),
            Form::Free(cells) => cells.iter().flat_map(|c| &c.samples).map(|b| b.k.abs()).fold(0.0, f64::max),
            Form::Cusp => 0.0,
        }
    }

    /// Hands over the values at the ends of the piece and where its curvature turns.
    pub(super) fn each_swing(&self, least: f64, push: &mut dyn FnMut(Swing)) {
        let floor = self.rounding.max(least);
        match &self.form {
            Form::Constant(value) => push(Swing { value: *value, floor }),
            Form::Free(cells) => {
                for cell in cells {
                    let floor = floor.max(cell.noise());
                    push(Swing { value: cell.samples[0].k, floor });
                    for pair in cell.samples.windows(2) {
                        for value in turning_values(pair[0], pair[1], cell.step()) {
                            push(Swing { value, floor });
                        }
                        push(Swing { value: pair[1].k, floor });
                    }
                }
            }
            Form::Cusp => {}
        }
    }
}

impl Measure<'_> {
    /// Measures a piece; `None` if all its points are one.
    pub(super) fn piece(&self, index: usize) -> Option<Piece> {
        let [first, last] = [0.0, 1.0].map(|s| self.curve.piece_jet(index, s));
        let middle = self.curve.piece_point(index, 0.5);
        let chord = first.point.distance(last.point).max(first.point.distance(middle));
        if !(chord > 0.0) {
            return None;
        }
        let size = first.point.to_vec().max_abs().max(last.point.to_vec().max_abs());
        let off = 1.0 + size / chord;
        let rounding = ROUNDING * off * (self.length / chord);
        let end = |jet: &CurveJet, end: f64| {
            let curvature = limit_curvature(self.curve, index, end).filter(|k| k.is_finite())? * self.length;
            let rests = jet.tangent().is_none();
            let noise = if rests { KNOWN_AT_REST * (1.0 + curvature.length()) } else { 0.0 };
            Some(End { point: jet.point, tangent: jet.limit_tangent(1.0 - 2.0 * end)?, curvature, noise })
        };
        let (Some(start), Some(stop)) = (end(&first, 0.0), end(&last, 1.0)) else {
            let end = |jet: &CurveJet| End { point: jet.point, tangent: Vec3::ZERO, curvature: Vec3::ZERO, noise: 0.0 };
            return Some(Piece { index, ends: [end(&first), end(&last)], chord, rounding, form: Form::Cusp });
        };
        let form = match self.curve.piece_form(index) {
            PieceForm::Arc(_) | PieceForm::Circle(_) => Form::Constant(self.bend(&first).k),
            PieceForm::Free => self.cells(index, rounding, off).map_or(Form::Cusp, Form::Free),
        };
        Some(Piece { index, ends: [start, stop], chord, rounding, form })
    }

    /// Cuts a piece until the curvature looks like a cubic everywhere; `None` if it has no bound.
    fn cells(&self, index: usize, rounding: f64, off: f64) -> Option<Vec<Cell>> {
        let mut cells = Vec::with_capacity(1);
        let whole = self.cell(index, 0.0, 1.0, off);
        if may_have_cusp(whole.samples.iter().map(|b| b.speed)) && place_of_cusp(self.curve, index).is_some() {
            return None;
        }
        let mut open = vec![(whole, DEPTH)];
        while let Some((cell, depth)) = open.pop() {
            if !cell.samples.iter().all(|b| b.k.is_finite() && b.slope.is_finite()) {
                return None;
            }
            if depth == 0 || cell.is_cubic(rounding) {
                cells.push(cell);
                continue;
            }
            // The right half first: the left one is popped before it.
            let [left, right] = self.halves(index, &cell);
            open.extend([(right, depth - 1), (left, depth - 1)]);
        }
        // Long curves keep them all for a while.
        cells.shrink_to_fit();
        Some(cells)
    }

    fn cell(&self, index: usize, start: f64, width: f64, off: f64) -> Cell {
        let at = |i: usize| self.at(index, start + width * i as f64 / SAMPLES as f64);
        Cell { start, width, off, samples: std::array::from_fn(at) }
    }

    fn halves(&self, index: usize, cell: &Cell) -> [Cell; 2] {
        let width = 0.5 * cell.width;
        [0, 1].map(|half| {
            let start = cell.start + width * half as f64;
            let sample = |i: usize| match i % 2 {
                0 => cell.samples[half * SAMPLES / 2 + i / 2],
                _ => self.at(index, start + width * i as f64 / SAMPLES as f64),
            };
            Cell { start, width, off: cell.off, samples: std::array::from_fn(sample) }
        })
    }

    fn at(&self, index: usize, s: f64) -> Bend {
        self.bend(&self.curve.piece_jet(index, place_of_curvature(self.curve, index, s)))
    }

    /// Curvature and its derivative from a jet. With `a = n·(x' × x'')`, `b = n·(x' × x''')` and `v = |x'|`:
    /// `k = a/v³`, `dk/ds = (b/v³ - 3 k (x'·x'')/v²)/v`. In space `n` is the binormal, so that `a = |x' × x''|`.
    fn bend(&self, jet: &CurveJet) -> Bend {
        let [d1, d2, d3] = [jet.d1, jet.d2, jet.d3].map(|d| d / self.length);
        let speed = d1.length();
        let binormal = d1.cross(d2);
        let normal = self.normal.or_else(|| binormal.unit()).unwrap_or(Vec3::ZERO);
        let cube = speed * speed * speed;
        let k = binormal.dot(normal) / cube;
        let slope = (d1.cross(d3).dot(normal) / cube - 3.0 * k * d1.dot(d2) / (speed * speed)) / speed;
        Bend { k, slope, speed, noise: ROUNDING * d2.length() / (speed * speed) }
    }

    /// `∫ k'² ds` over all pieces, which without jumps is the variation of the whole curve. Swings that do not count
    /// add nothing.
    pub(super) fn variation(&self, pieces: &[Piece], largest: f64) -> f64 {
        let cells = || {
            pieces.iter().flat_map(|piece| {
                let floor = piece.rounding.max(NOISE * largest);
                let cells: &[Cell] = if let Form::Free(cells) = &piece.form { cells } else { &[] };
                cells
                    .iter()
                    .filter(move |cell| cell.swing() > floor.max(cell.noise()))
                    .map(move |cell| (piece.index, cell))
            })
        };
        let mean = cells().map(|(_, cell)| cell.boole().0).sum::<f64>() / pieces.len().max(1) as f64;
        cells().map(|(index, cell)| self.refined(index, cell, mean)).sum()
    }

    fn refined(&self, index: usize, cell: &Cell, mean: f64) -> f64 {
        let mut sum = 0.0;
        let mut open = vec![(*cell, DEPTH)];
        while let Some((cell, depth)) = open.pop() {
            let (value, error) = cell.boole();
            if depth == 0 || !(error > AGREEMENT * value.max(mean * cell.width)) {
                sum += value;
            } else {
                open.extend(self.halves(index, &cell).map(|half| (half, depth - 1)));
            }
        }
        sum
    }
}

impl Cell {
    fn step(&self) -> f64 {
        self.width / SAMPLES as f64
    }

    /// True if every second sample lies where the cubic through its neighbors has it.
    fn is_cubic(&self, rounding: f64) -> bool {
        let step = 2.0 * self.step();
        (0..SAMPLES / 2).all(|i| {
            let [a, m, b] = [0, 1, 2].map(|j| self.samples[2 * i + j]);
            let (da, db) = (a.slope * a.speed * step, b.slope * b.speed * step);
            let middle = 0.5 * (a.k + b.k) + 0.125 * (da - db);
            let range = (b.k - a.k).abs().max(da.abs()).max(db.abs());
            (m.k - middle).abs() <= CUBIC_LIMIT * range + rounding + self.off * a.noise.max(m.noise).max(b.noise)
        })
    }

    /// What rounding makes of its curvatures.
    fn noise(&self) -> f64 {
        self.off * self.samples.iter().map(|b| b.noise).fold(0.0, f64::max)
    }

    /// Difference of the largest and the smallest sample.
    fn swing(&self) -> f64 {
        let (low, high) = self.samples.iter().fold((f64::MAX, f64::MIN), |(l, h), b| (l.min(b.k), h.max(b.k)));
        high - low
    }

    /// `∫ k'² ds` by Boole's rule, and its difference from Simpson's.
    fn boole(&self) -> (f64, f64) {
        let f = |i: usize| {
            let b = self.samples[i];
            b.slope * b.slope * b.speed
        };
        let simpson = |stride: usize| {
            let inner = |first: usize| (first..SAMPLES / stride).step_by(2).map(|i| f(i * stride)).sum::<f64>();
            self.step() * stride as f64 / 3.0 * (f(0) + 4.0 * inner(1) + 2.0 * inner(2) + f(SAMPLES))
        };
        let (fine, coarse) = (simpson(1), simpson(2));
        let correction = (fine - coarse) / 15.0;
        ((fine + correction).max(0.0), correction.abs())
    }
}

/// The values at which the cubic through two samples turns inside.
fn turning_values(a: Bend, b: Bend, step: f64) -> impl Iterator<Item = f64> {
    let (da, db) = (a.slope * a.speed * step, b.slope * b.speed * step);
    let rise = b.k - a.k;
    // k(x) = a + da x + c x² + d x³ on [0, 1]; k'(x) = 0 by the form of the quadratic without cancellation.
    let (c, d) = (3.0 * rise - 2.0 * da - db, da + db - 2.0 * rise);
    let discriminant = c * c - 3.0 * d * da;
    let q = -(c + discriminant.max(0.0).sqrt().copysign(c));
    let inside = |x: f64| (discriminant > 0.0 && x > 0.0 && x < 1.0).then_some(x);
    let mut places = [inside(q / (3.0 * d)), inside(da / q)];
    places.sort_by(|x, y| x.partial_cmp(y).unwrap_or(std::cmp::Ordering::Equal));
    places.into_iter().flatten().map(move |x| a.k + x * (da + x * (c + x * d)))
}
