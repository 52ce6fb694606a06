//! Bodies in motion: the room that they take, and the axes that stand for those without a shape.

use cyclide::{Aabb, Point3, motion::MovingBody};

/// The axes of a body without a shape are this part of the box of its way; of one that turns in place 1.
const AXES: f64 = 0.1;

/// The room that a body in motion takes, measured once for all files.
#[derive(Clone, Copy)]
pub(crate) struct MovingRoom {
    /// The box of the way of its origin.
    pub(crate) way: Aabb,
    /// How far its points are from its origin: of a body without a shape the length of its axes.
    pub(crate) reach: f64,
}

impl MovingRoom {
    pub(crate) fn of(body: &MovingBody) -> Self {
        let way = way(body);
        Self { way, reach: reach(body, way) }
    }
}

/// The box of the way of the origin of a body.
fn way(body: &MovingBody) -> Aabb {
    let motion = body.motion();
    let times = motion.times();
    let places =
        times.windows(2).flat_map(|ends| (0..=32).map(move |k| ends[0] + (ends[1] - ends[0]) * f64::from(k) / 32.0));
    // Where it does much in a moment the motion has cells.
    let cells =
        body.schedule().map(|schedule| schedule.breaks().into_iter().map(|x| schedule.timing().time_at(x)).collect());
    let cells: Vec<f64> = cells.unwrap_or_default();
    let points = places.chain(cells).map(|time| Point3::ORIGIN + motion.pose(time).translation());
    points.fold(Aabb::of_point(Point3::ORIGIN + motion.pose(times[0]).translation()), Aabb::including)
}

fn reach(body: &MovingBody, way: Aabb) -> f64 {
    match body.mesh() {
        Some(mesh) => mesh.points().iter().map(|p| p.to_vec().length()).fold(0.0, f64::max),
        None => match AXES * way.diagonal() {
            axes if axes > 0.0 => axes,
            _ => 1.0,
        },
    }
}
