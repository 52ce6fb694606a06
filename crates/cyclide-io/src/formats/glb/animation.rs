//! Motions in a file: a node that stands at the center of the motion, below it the body with an animation of its place and turn.

use super::buffer::Buffer;
use super::material::Look;
use super::reader;
use super::track::{Carried, TrackFault};
use super::{LINES, TRIANGLES};
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::Promise;
use crate::export::mesh::single;
use crate::export::moving::MovingRoom;
use crate::export::ready::ReadyModel;
use cyclide::{
    Point3, ShortNumber, Vec3,
    model::{Item, Model},
    motion::{BodyMesh, MovingBody, Schedule, TimeLaw},
};
use serde_json::{Value, json};

/// Seconds that a motion may last, so that its times and speeds are numbers of single precision, whose exponents end at 38.
const DURATIONS: [f64; 2] = [1e-20, 1e20];

/// The name of the animation of several bodies.
const ALL: &str = "all motions";

/// What an animated body adds to a file.
pub(super) struct Animated {
    pub(super) center: Point3,
    pub(super) first: Value,
    pub(super) primitives: Vec<Value>,
    pub(super) materials: Vec<Look>,
    pub(super) promise: Promise,
}

/// The animation of a file: viewers play one of them, so all bodies are in it, and one that has arrived waits for the others.
#[derive(Default)]
pub(super) struct Clip {
    samplers: Vec<Value>,
    channels: Vec<Value>,
    /// The objects that move.
    names: Vec<String>,
}

impl Clip {
    /// Adds what moves another node.
    pub(super) fn add(&mut self, node: usize, name: &str, [input, translation, rotation]: [usize; 3]) {
        for (output, path) in [(translation, "translation"), (rotation, "rotation")] {
            self.channels.push(json!({"sampler": self.samplers.len(), "target": {"node": node, "path": path}}));
            self.samplers.push(json!({"input": input, "output": output, "interpolation": "CUBICSPLINE"}));
        }
        self.names.push(name.to_owned());
    }

    /// The animations of the document, if there are any.
    pub(super) fn to_json(&self) -> Option<Value> {
        let name = match self.names.as_slice() {
            [] => return None,
            [only] => only,
            _ => ALL,
        };
        Some(json!([{"name": name, "samplers": self.samplers, "channels": self.channels}]))
    }
}

/// The parts of a body in motion; what moves the node with this number is added to the clip.
///
/// # Errors
/// [`ExportError`] if it lasts longer or shorter than single precision tells, or no keys keep the tolerance.
pub(super) fn animated(
    item: &Item,
    (body, room): (&MovingBody, MovingRoom),
    node: usize,
    first_material: usize,
    tolerance: f64,
    (buffer, clip): (&mut Buffer, &mut Clip),
) -> Result<Animated, ExportError> {
    let (object, seconds) = (|| item.name.clone(), body.duration());
    let [min, max] = DURATIONS;
    if !(min..=max).contains(&seconds) {
        return Err(ExportError::Duration { object: object(), seconds, min, max });
    }
    let center = room.way.min.midpoint(room.way.max);
    let schedule = body.schedule().map_err(|source| ExportError::Lowering { object: object(), contour: 0, source })?;
    let carried = carried(room, &schedule, body.duration(), center);
    let (track, off) = carried.track(tolerance).map_err(|TrackFault::Off { keys, off, seconds }| {
        ExportError::Keyframes { object: object(), off, tolerance, seconds, keys, hint: slower(body) }
    })?;
    let promise = Promise::sampled(off.max(tolerance));
    let (primitives, materials) = match body.mesh() {
        Some(mesh) => shape(mesh, first_material, item, buffer),
        None => axes(room.reach, first_material, item, buffer),
    };
    let input = buffer.times(&track.times);
    let translation = buffer.free_vectors(track.translations.as_flattened());
    let rotation = buffer.free_vectors(track.rotations.as_flattened());
    let first = json!({"translation": track.translations[0][1], "rotation": track.rotations[0][1]});
    clip.add(node, &item.name, [input, translation, rotation]);
    Ok(Animated { center, first, primitives, materials, promise })
}

/// What is said of motions that start at different times: all of them play from the start.
pub(super) fn other_clocks(model: &Model) -> Option<String> {
    let starts = || model.items.iter().filter_map(|item| Some((&item.name, item.motion()?.motion().domain()[0])));
    let (first, start) = starts().next()?;
    let (other, later) = starts().find(|(_, other)| (other - start).abs() > 0.0)?;
    // Times since a year long ago differ in digits that are not short.
    let [mut one, mut two] = [start, later].map(|time| ShortNumber(time).to_string());
    if one == two {
        [one, two] = [start, later].map(|time| format!("{:#}", ShortNumber(time)));
    }
    Some(format!(
        "all motions play from the start of the animation, but the times of {first} begin at {one} and those of \
         {other} at {two}: to make a body wait for the other, repeat its first pose at both times [clocks-differ]"
    ))
}

/// What makes a body slower that is too fast for its keys.
fn slower(body: &MovingBody) -> &'static str {
    match body.law() {
        TimeLaw::AsGiven => "use other times, or a `law` by path length, with an `arm` if the rotation is too fast",
        _ => {
            "set or increase `arm`, the characteristic length that weights rotation against translation, or use other poses"
        }
    }
}

/// What keys of a body are held against.
fn carried<'a>(room: MovingRoom, schedule: &'a Schedule<'a>, duration: f64, center: Point3) -> Carried<'a> {
    let (reach, radius) = (room.reach, room.way.diagonal());
    Carried { schedule, duration, center, reach, radius, breaks: schedule.breaks() }
}

/// Three lines along the axes of the body: red, green and blue.
fn axes(length: f64, first_material: usize, item: &Item, buffer: &mut Buffer) -> (Vec<Value>, Vec<Look>) {
    let mut primitives = Vec::new();
    for (k, axis) in [Vec3::X, Vec3::Y, Vec3::Z].into_iter().enumerate() {
        let points = [Vec3::ZERO, axis * length].map(|v| v.to_array().map(single));
        let attributes = json!({"POSITION": buffer.positions(&points)});
        let indices = buffer.indices(&[0, 1]);
        primitives
            .push(json!({"attributes": attributes, "indices": indices, "material": first_material + k, "mode": LINES}));
    }
    (primitives, (0..3).map(|k| Look::axis(item, k)).collect())
}

/// The triangles of a shape, each with its own normal; those without area have none and are left out.
fn shape(mesh: &BodyMesh, material: usize, item: &Item, buffer: &mut Buffer) -> (Vec<Value>, Vec<Look>) {
    let (mut points, mut normals) = (Vec::new(), Vec::new());
    for corners in mesh.triangles() {
        let corners = corners.map(|i| mesh.points()[i]);
        if let Some(normal) = (corners[1] - corners[0]).cross(corners[2] - corners[0]).unit() {
            points.extend(corners.map(|p| p.to_array().map(single)));
            normals.extend([normal.to_array().map(single); 3]);
        }
    }
    let attributes = json!({"POSITION": buffer.positions(&points), "NORMAL": buffer.vectors(normals.into_iter())});
    let indices = buffer.indices(&(0..points.len() as u32).collect::<Vec<_>>());
    let primitive = json!({"attributes": attributes, "indices": indices, "material": material, "mode": TRIANGLES});
    (vec![primitive], vec![Look::surface(item, 0)])
}

/// How far the motions read are from those of the model.
///
/// # Errors
/// [`ReadError`] if a motion is not in the file, or something else is.
pub(super) fn deviations(bytes: &[u8], ready: &ReadyModel<'_>) -> Result<Vec<f64>, ReadError> {
    let wrong = |detail: &str| ReadError::syntax("animations", detail.to_owned());
    let bodies: Vec<(&Item, &MovingBody)> =
        ready.model.items.iter().filter_map(|item| item.motion().map(|body| (item, body))).collect();
    let tracks = reader::tracks(bytes)?;
    if tracks.len() != bodies.len() {
        return Err(wrong("the number of moving bodies differs from the number of motions"));
    }
    bodies
        .into_iter()
        .zip(&ready.moving)
        .zip(tracks)
        .map(|(((item, body), room), read)| {
            if read.name != item.name {
                return Err(wrong("a moving body is not named after its motion"));
            }
            let schedule =
                body.schedule().map_err(|source| ReadError::Geometry { place: item.name.clone(), source })?;
            let (duration, carried) = (body.duration(), carried(*room, &schedule, body.duration(), read.center));
            let last = f64::from(read.track.times.last().copied().unwrap_or_default());
            if !((last - duration).abs() <= 1e-6 * duration) {
                return Err(wrong("the duration of an animation differs from that of its motion"));
            }
            Ok(carried.deviation(&read.track).0)
        })
        .collect()
}
