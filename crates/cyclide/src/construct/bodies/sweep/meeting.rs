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

/// Normals whose cosine is above this are one.
const ALIGNED: f64 = 1.0 - 1e-12;

/// The section at a place of the path, with what lies halfway to its neighbors.
struct Place {
    center: Point3,
    axes: [Vec3; 3],
    half: [f64; 3],
    /// Length before it.
    at: f64,
    /// Miters at the ends of its leg: what is beyond their planes is not there. Their normals point out of the leg.
    mitres: [Option<Mitre>; 2],
}

#[derive(Clone, Copy)]
struct Mitre {
    normal: Vec3,
    through: Point3,
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
    for (number, (leg, station)) in legs.iter().zip(stations).enumerate() {
        let next = &stations[(number + 1) % stations.len()];
        let mitre =
            |at: &Station, side: f64| at.mitre().map(|normal| Mitre { normal: normal * side, through: at.center });
        let mitres = [mitre(station, -1.0), mitre(next, 1.0)];
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
                mitres,
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

    /// Separating axes: those of both boxes, and across one of each; and the normals of miters, which cut the boxes off.
    fn overlaps(&self, other: &Self, touching: f64) -> bool {
        let between = other.center - self.center;
        let crosses = self.axes.iter().flat_map(|a| other.axes.iter().filter_map(|b| a.cross(*b).unit()));
        let mut all = self.axes.iter().chain(&other.axes).copied().chain(crosses);
        let reach = |place: &Self, axis: Vec3| {
            place.axes.iter().zip(place.half).map(|(a, half)| a.dot(axis).abs() * half).sum::<f64>()
        };
        // How far a box reaches along an axis from a point, as far as it is there.
        let end = |place: &Self, from: Point3, axis: Vec3| {
            let whole = (place.center - from).dot(axis) + reach(place, axis);
            let cut = |mitre: &Mitre| (mitre.normal.dot(axis) > ALIGNED).then(|| (mitre.through - from).dot(axis));
            place.mitres.iter().flatten().filter_map(cut).fold(whole, f64::min)
        };
        let mitres = self.mitres.iter().chain(&other.mitres).flatten();
        let are_apart = |mitre: &Mitre| {
            let [along, back] = [mitre.normal, -mitre.normal];
            let gap = |a: &Self, b: &Self| -end(b, mitre.through, back) - end(a, mitre.through, along);
            gap(self, other) > -touching || gap(other, self) > -touching
        };
        all.all(|axis| between.dot(axis).abs() < reach(self, axis) + reach(other, axis) - touching)
            && !{ mitres }.any(are_apart)
    }
}
