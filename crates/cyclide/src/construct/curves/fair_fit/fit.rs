//! One fit: the fairest curve in the tube for a fixed number of nodes, by steps of the linear model that are taken
//! back as far as the exact spline asks (`docs/math/fair-fits.md#one-fit`).

use super::feet::{Foot, Place, WARM, farthest, squares};
use super::linear_model::LinearModel;
use super::tube_curve::TubeCurve;
use crate::base::vector::{Point3, Vec3};

/// The steps aim at this part of the tolerance, so that what the linear model neglects stays inside.
const AIM: f64 = 0.999;
/// Price of a violation at first, and the largest.
const FIRST_PRICE: f64 = 5.0;
const LARGEST_PRICE: f64 = 1e5;
/// Part of the floor of `J` below which a curve is straight or a circle: nothing is left to gain.
const NOTHING: f64 = 1e-12;
/// Halvings of a step.
const HALVINGS: usize = 6;

/// The data of a smooth piece, in the working frame.
#[derive(Clone, Copy)]
pub(super) struct Data<'a> {
    pub points: &'a [Point3],
    pub closed: bool,
    pub planar: bool,
    /// The curve starts and ends exactly at the first and the last datum.
    pub fixed: [bool; 2],
    pub tolerance: f64,
    /// Weight of the mean square of the distances (`docs/math/fair-fits.md#center`).
    pub centre: f64,
    /// `J` below which a curve counts as straight: the floor of the scale (`docs/math/fair-fits.md#interior-point`).
    pub floor: f64,
}

/// Nodes of the smallest curve: the linear model of a ring needs four that differ.
pub(super) fn fewest_nodes(closed: bool) -> usize {
    if closed { 4 } else { 2 }
}

/// A curve with its feet and what they say.
#[derive(Debug, Clone)]
pub(super) struct Fit {
    pub curve: TubeCurve,
    pub feet: Vec<Foot>,
    pub fairness: f64,
    pub farthest: f64,
}

/// When a fit ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Patience {
    pub steps: usize,
    /// Relative change of `J` that ends it once all data are inside.
    pub change: f64,
    /// The price of violations may grow: for fits that must succeed.
    pub grow: bool,
}

impl Fit {
    pub fn new(data: &Data<'_>, curve: TubeCurve, near: impl Iterator<Item = Place>, steps: usize) -> Self {
        let feet = curve.feet(data.points, near, steps);
        Self { fairness: curve.fairness(), farthest: farthest(&feet), curve, feet }
    }

    pub fn feasible(&self, data: &Data<'_>) -> bool {
        self.farthest <= data.tolerance
    }

    /// The data outside the tolerance.
    pub fn outside(&self, data: &Data<'_>) -> impl Iterator<Item = (usize, &Foot)> {
        let square = data.tolerance * data.tolerance;
        self.feet.iter().enumerate().filter(move |(_, f)| f.error.length_squared() > square)
    }

    /// What is minimized: `J`, and with a `centre` the mean square of the distances, in units of `scale`.
    pub fn objective(&self, data: &Data<'_>, scale: f64) -> f64 {
        let mean = squares(&self.feet) / (self.feet.len() as f64 * data.tolerance * data.tolerance);
        self.fairness / scale + data.centre * mean
    }

    /// Objective and price of the data outside a radius.
    fn merit(&self, data: &Data<'_>, scale: f64, radius: f64, price: f64) -> f64 {
        let outside = |f: &Foot| (0.5 * (f.error.length_squared() / (radius * radius) - 1.0)).max(0.0);
        self.objective(data, scale) + price * self.feet.iter().map(outside).sum::<f64>()
    }

    /// The fairest curve near this one with its number of nodes. Feasible if that was found, else as near as it came.
    pub fn fairest(self, data: &Data<'_>, patience: Patience) -> Self {
        if data.planar { self.fairest_in::<1, 4>(data, patience) } else { self.fairest_in::<2, 8>(data, patience) }
    }

    fn fairest_in<const R: usize, const N: usize>(self, data: &Data<'_>, patience: Patience) -> Self {
        let tolerance = data.tolerance;
        let (mut radius, mut price) = (AIM * tolerance, FIRST_PRICE);
        let mut smallest = self.fairness;
        let mut best: Option<Self> = None;
        let mut at = self;
        for step in 0..patience.steps {
            if at.feasible(data) && at.fairness <= NOTHING * data.floor && data.centre == 0.0 {
                return at;
            }
            smallest = smallest.min(at.fairness);
            let scale = smallest.max(data.floor);
            let model = LinearModel::<R, N>::new(&at.curve, &at.feet, data.fixed, radius);
            // The model's distances are in units of its radius.
            let centre = data.centre * (radius / tolerance).powi(2);
            let Some(solved) = model.solve(&model.objective(scale, centre, &at.feet), price) else { break };
            let moves = at.moves(data, &model.displacements(&solved.y));
            let Some(next) = at.moved(data, &moves, |fit| fit.merit(data, scale, radius, price)) else {
                if at.feasible(data) {
                    break;
                }
                // Nothing gained at this price.
                if !patience.grow || price >= LARGEST_PRICE {
                    break;
                }
                price *= 10.0;
                continue;
            };
            let hopeless = !patience.grow && step > 0 && solved.violation > 0.05 && next.farthest > tolerance;
            let change = (next.fairness - at.fairness).abs() / scale;
            at = next;
            let farthest = at.farthest;
            if hopeless {
                break;
            }
            if at.feasible(data) {
                if best.as_ref().is_none_or(|b| at.objective(data, scale) <= b.objective(data, scale)) {
                    best = Some(at.clone());
                }
                if change < patience.change {
                    break;
                }
            } else if patience.grow && change < 0.02 && price < LARGEST_PRICE {
                price *= 10.0;
            }
            if step > 0 && solved.violation < 1e-3 && farthest > tolerance && farthest < 1.2 * tolerance {
                radius = (radius - 1.2 * (farthest - tolerance) - 1e-4 * tolerance).max(0.8 * tolerance);
            } else if farthest < 0.995 * tolerance {
                radius = (radius + 0.7 * (AIM * tolerance - farthest)).min(AIM * tolerance);
            }
        }
        best.unwrap_or(at)
    }

    /// Displacements of the nodes, shortened so that no node moves farther than its shorter chord. Free open ends
    /// also slide along the curve to stand over the first and the last datum.
    fn moves(&self, data: &Data<'_>, displacements: &[Vec3]) -> Vec<Vec3> {
        let (curve, m) = (&self.curve, self.curve.segments.len());
        let chord = |j: usize| curve.segments.get(j).map_or(f64::INFINITY, |s| s.chord);
        let mut moves = displacements.to_vec();
        if !curve.closed {
            for (end, node, foot, tangent) in
                [(0, 0, &self.feet[0], curve.tangents[0]), (1, m, &self.feet[self.feet.len() - 1], curve.tangents[m])]
            {
                if !data.fixed[end] {
                    let datum = curve.segments[foot.place.segment].point(foot.place.u).point + foot.error;
                    let slide = (datum - curve.nodes[node]).dot(tangent);
                    moves[node] += tangent * slide;
                }
            }
        }
        let share = |(i, v): (usize, &Vec3)| {
            let before = if i > 0 {
                chord(i - 1)
            } else if curve.closed {
                chord(m - 1)
            } else {
                f64::INFINITY
            };
            v.length() / before.min(chord(i))
        };
        let longest = moves.iter().enumerate().map(share).fold(0.0, f64::max);
        if longest > 1.0 {
            moves.iter_mut().for_each(|v| *v /= longest);
        }
        moves
    }

    /// The curve with its nodes moved, by half as much as long as the merit does not fall.
    fn moved(&self, data: &Data<'_>, moves: &[Vec3], merit: impl Fn(&Self) -> f64) -> Option<Self> {
        let before = merit(self);
        let mut part = 1.0;
        for _ in 0..=HALVINGS {
            let nodes = self.curve.nodes.iter().zip(moves).map(|(x, v)| *x + *v * part).collect();
            let curve = TubeCurve::new(nodes, data.closed, Some(&self.curve.tangents));
            if let Some(curve) = curve {
                let next = Self::new(data, curve, self.feet.iter().map(|f| f.place), WARM);
                if merit(&next) < before {
                    return Some(next);
                }
            }
            part *= 0.5;
        }
        None
    }
}
