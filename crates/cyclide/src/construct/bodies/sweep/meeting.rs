//! Whether a sweep runs into itself: boxes about the section at places along the path (`docs/math/sweeps.md#meeting`).

use super::legs::{Leg, Station};
use crate::base::bounds::Aabb;
use crate::base::box_tree::BoxTree;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use std::f64::consts::PI;

/// Places are this part of the reach of the section apart, if they are not too many.
const APART: f64 = 0.25;
const MOST_PLACES: f64 = 20_000.0;
/// Boxes that overlap by less than this part of the reach touch.
const TOUCHING: f64 = 1e-6;

/// The section at a place of the path, with what lies halfway to its neighbors.
struct Place {
    center: Point3,
    axes: [Vec3; 3],
    half: [f64; 3],
    /// Length before it.
    at: f64,
}

/// The first two places, by the length before them, of which the boxes about the section overlap, with a point between: those more than half a turn of the reach of the section
/// apart along the path.
pub(super) fn meeting(
    legs: &[Leg],
    stations: &[Station],
    closed: bool,
    section: &[Point3],
) -> Option<([f64; 2], Point3)> {
    let reach = section.iter().map(|p| p.to_vec().length()).fold(0.0, f64::max);
    let whole: f64 = legs.iter().map(|leg| leg.arc.length()).sum();
    let step = (APART * reach).max(whole / MOST_PLACES);
    let range = |of: fn(&Point3) -> f64| {
        section.iter().map(of).fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    };
    let [x, y] = [range(|p| p.x), range(|p| p.y)];
    let (mut places, mut before) = (Vec::new(), 0.0);
    for (leg, station) in legs.iter().zip(stations) {
        let length = leg.arc.length();
        let count = (length / step).ceil().max(1.0);
        for k in 0..count as usize {
            let t = leg.arc.parameter_at_length((k as f64 + 0.5) / count);
            let turn = |v: Vec3| match leg.arc.normal() {
                Some(normal) => Quat::from_axis_angle(normal, leg.arc.angle_to(t)).rotate(v),
                None => v,
            };
            let rolled = Quat::from_axis_angle(station.axis, leg.roll * (k as f64 + 0.5) / count);
            let [u, v] = station.directions().map(|v| turn(rolled.rotate(v)));
            let middle = leg.arc.point(t) + u * (0.5 * (x[0] + x[1])) + v * (0.5 * (y[0] + y[1]));
            let half = [0.5 * (x[1] - x[0]), 0.5 * (y[1] - y[0]), 0.5 * length / count];
            places.push(Place {
                center: middle,
                axes: [u, v, turn(station.axis)],
                half,
                at: before + length * (k as f64 + 0.5) / count,
            });
        }
        before += length;
    }
    let boxes: Vec<Aabb> = places.iter().map(Place::bounds).collect();
    let near = |i: usize, j: usize| {
        let along = (places[j].at - places[i].at).abs();
        along.min(if closed { whole - along } else { f64::INFINITY }) <= PI * reach
    };
    BoxTree::new(&boxes).find_within(
        |_, _| false,
        |i, j| {
            let (a, b) = (&places[i], &places[j]);
            (i != j && !near(i, j) && a.overlaps(b, TOUCHING * reach))
                .then(|| ([a.at.min(b.at), a.at.max(b.at)], a.center.midpoint(b.center)))
        },
    )
}

impl Place {
    fn bounds(&self) -> Aabb {
        let reach =
            |unit: Vec3| self.axes.iter().zip(self.half).map(|(axis, half)| axis.dot(unit).abs() * half).sum::<f64>();
        let far = Vec3::new(reach(Vec3::X), reach(Vec3::Y), reach(Vec3::Z));
        Aabb::of_point(self.center + far).including(self.center - far)
    }

    /// Separating axes: those of both boxes, and across one of each.
    fn overlaps(&self, other: &Self, touching: f64) -> bool {
        let between = other.center - self.center;
        let crosses = self.axes.iter().flat_map(|a| other.axes.iter().filter_map(|b| a.cross(*b).unit()));
        let mut all = self.axes.iter().chain(&other.axes).copied().chain(crosses);
        let reach = |place: &Self, axis: Vec3| {
            place.axes.iter().zip(place.half).map(|(a, half)| a.dot(axis).abs() * half).sum::<f64>()
        };
        all.all(|axis| between.dot(axis).abs() < reach(self, axis) + reach(other, axis) - touching)
    }
}
