//! A motion as a track of keys: cubic pieces between them, as animations of glTF (`CUBICSPLINE`) have them.
//!
//! Translation and quaternion are Hermite cubics between keys, the quaternion made of length 1 afterwards. That is no rational motion of
//! ours, so keys are set closer until the body is within the tolerance; how far it is, is measured on the rounded numbers.

use crate::export::mesh::single;
use cyclide::{Point3, Pose, Quat, Schedule, Vec3};

/// Part of the tolerance that is used between the places looked at.
const SHARE: f64 = 0.5;
/// Places looked at between two keys while they are chosen.
const PLACES: u32 = 5;
/// Halvings of a part of the motion.
const HALVINGS: u32 = 12;
/// Tangents at a key are those this part of the interval inside: at a joint they jump.
const INSIDE: f64 = 1e-9;

/// Keys with what a file says of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Track {
    /// Rising, from 0.
    pub(super) times: Vec<f32>,
    /// In-tangent, value and out-tangent of each key, per second.
    pub(super) translations: Vec<[[f32; 3]; 3]>,
    /// The same as `x, y, z, w`.
    pub(super) rotations: Vec<[[f32; 4]; 3]>,
}

/// A pose with its derivatives by the fraction of the duration.
#[derive(Clone, Copy)]
struct Moving {
    translation: Vec3,
    rotation: Quat,
    velocity: Vec3,
    turning: Quat,
}

/// Two keys with one-sided derivatives.
struct Interval {
    ends: [f64; 2],
    from: Moving,
    to: Moving,
}

/// The body of a motion, as far as keys go: where its origin is relative to a centre, and how far its points are from it.
pub(super) struct Carried<'a> {
    pub(super) schedule: &'a Schedule<'a>,
    pub(super) duration: f64,
    pub(super) center: Point3,
    pub(super) reach: f64,
}

impl Carried<'_> {
    /// The track within a tolerance, where that can be had, with keys at these fractions of the duration among others; `None` if the keys come closer
    /// than single precision tells.
    pub(super) fn track(&self, fractions: &[f64], tolerance: f64) -> Option<Track> {
        let mut intervals = Vec::new();
        for ends in fractions.windows(2) {
            self.cut([ends[0], ends[1]], SHARE * tolerance, HALVINGS, &mut intervals);
        }
        let mut track = Track::default();
        let mut before: Option<Quat> = None;
        for (k, interval) in intervals.iter().enumerate() {
            let from = interval.from.beside(before);
            // Both ends of an interval are on one side.
            let sign = if from.rotation.dot(interval.from.rotation) < 0.0 { -1.0 } else { 1.0 };
            let to = interval.to.signed(sign);
            if k == 0 {
                track.push(0.0, from, None, Some(from), self.duration);
            } else {
                track.set_out(from, self.duration);
            }
            track.push(interval.ends[1] * self.duration, to, Some(to), None, self.duration);
            before = Some(to.rotation);
        }
        track.times.windows(2).all(|pair| pair[0] < pair[1]).then_some(track)
    }

    fn cut(&self, ends: [f64; 2], tolerance: f64, halvings: u32, out: &mut Vec<Interval>) {
        let interval = self.interval(ends);
        let within = (1..=PLACES).all(|k| {
            let s = f64::from(k) / f64::from(PLACES + 1);
            let (translation, rotation) = interval.at(s);
            self.off(ends[0] + (ends[1] - ends[0]) * s, translation, rotation) <= tolerance
        });
        if within || halvings == 0 {
            return out.push(interval);
        }
        let middle = 0.5 * (ends[0] + ends[1]);
        self.cut([ends[0], middle], tolerance, halvings - 1, out);
        self.cut([middle, ends[1]], tolerance, halvings - 1, out);
    }

    fn interval(&self, ends: [f64; 2]) -> Interval {
        let step = INSIDE * (ends[1] - ends[0]);
        let from = self.moving(ends[0], ends[0] + step);
        let to = self.moving(ends[1], ends[1] - step).beside(Some(from.rotation));
        Interval { ends, from, to }
    }

    /// The pose at a fraction with the derivatives at another one next to it; those that are not finite are 0.
    fn moving(&self, fraction: f64, beside: f64) -> Moving {
        let (pose, jet) = (self.schedule.pose(fraction), self.schedule.jet(beside));
        // Of the origin of the body, by the tool and the turn.
        let arm = jet.point.point - (Point3::ORIGIN + jet.pose.translation());
        let velocity = (jet.point.d1 - jet.angular_velocity.cross(arm)) * self.duration;
        let turning = Quat::from(jet.angular_velocity * (0.5 * self.duration)) * pose.rotation();
        Moving {
            translation: pose.translation() - self.center.to_vec(),
            rotation: pose.rotation(),
            velocity: if velocity.is_finite() { velocity } else { Vec3::ZERO },
            turning: if turning.is_finite() { turning } else { Quat::ZERO },
        }
    }

    /// How far a point of the body is off, at most, if its pose is this one.
    pub(super) fn off(&self, fraction: f64, translation: Vec3, rotation: Quat) -> f64 {
        let exact = self.schedule.pose(fraction);
        let length = rotation.norm();
        let turned = match Pose::new(rotation, translation) {
            Ok(pose) if length > 0.0 => 2.0 * (0.5 * pose.angle_to(exact)).sin(),
            _ => 2.0,
        };
        (exact.translation() - self.center.to_vec() - translation).length() + turned * self.reach
    }

    /// How far the body of a track is off, at so many places between two keys.
    pub(super) fn deviation(&self, track: &Track, places: u32) -> f64 {
        let mut most = 0.0_f64;
        for k in 1..track.times.len() {
            let [a, b] = [track.times[k - 1], track.times[k]].map(f64::from);
            for place in 0..=places {
                let s = f64::from(place) / f64::from(places);
                let (translation, rotation) = track.at(k, s);
                let off = self.off((a + (b - a) * s) / self.duration, translation, rotation);
                most = if off.is_nan() { f64::INFINITY } else { most.max(off) };
            }
        }
        most
    }
}

impl Moving {
    /// With the rotation that is nearer to another one.
    fn beside(self, other: Option<Quat>) -> Self {
        self.signed(if other.is_some_and(|other| other.dot(self.rotation) < 0.0) { -1.0 } else { 1.0 })
    }

    fn signed(self, sign: f64) -> Self {
        Self { rotation: self.rotation * sign, turning: self.turning * sign, ..self }
    }
}

impl Interval {
    fn at(&self, s: f64) -> (Vec3, Quat) {
        let [a, b, c, d] = hermite(s);
        let (from, to, h) = (&self.from, &self.to, self.ends[1] - self.ends[0]);
        let translation = from.translation * a + from.velocity * (b * h) + to.translation * c + to.velocity * (d * h);
        let rotation = from.rotation * a + from.turning * (b * h) + to.rotation * c + to.turning * (d * h);
        (translation, rotation)
    }
}

/// The cubics of value and derivative at the start, and at the end.
fn hermite(s: f64) -> [f64; 4] {
    let t = 1.0 - s;
    [(1.0 + 2.0 * s) * t * t, s * t * t, s * s * (3.0 - 2.0 * s), -s * s * t]
}

impl Track {
    fn push(&mut self, time: f64, key: Moving, before: Option<Moving>, after: Option<Moving>, duration: f64) {
        let by_second =
            |moving: Option<Moving>| moving.map_or(([0.0; 3], [0.0; 4]), |moving| derivatives(moving, duration));
        let ((v0, q0), (v1, q1)) = (by_second(before), by_second(after));
        self.times.push(single(time));
        self.translations.push([v0, key.translation.to_array().map(single), v1]);
        self.rotations.push([q0, xyzw(key.rotation), q1]);
    }

    /// The out-tangents of the last key.
    fn set_out(&mut self, key: Moving, duration: f64) {
        let (velocity, turning) = derivatives(key, duration);
        if let (Some(translation), Some(rotation)) = (self.translations.last_mut(), self.rotations.last_mut()) {
            translation[2] = velocity;
            rotation[2] = turning;
        }
    }

    /// What a reader shows at the part `s` of the way from key `k - 1` to key `k`; the quaternion is of any length.
    pub(super) fn at(&self, k: usize, s: f64) -> (Vec3, Quat) {
        let [a, b, c, d] = hermite(s);
        let h = f64::from(self.times[k]) - f64::from(self.times[k - 1]);
        let factors = [a, b * h, c, d * h];
        let rows = [
            self.translations[k - 1][1],
            self.translations[k - 1][2],
            self.translations[k][1],
            self.translations[k][0],
        ];
        let translation = mixed(rows, factors);
        let rows = [self.rotations[k - 1][1], self.rotations[k - 1][2], self.rotations[k][1], self.rotations[k][0]];
        let [x, y, z, w] = mixed(rows, factors);
        (Vec3::from(translation), Quat::new(w, x, y, z))
    }
}

fn mixed<const D: usize>(rows: [[f32; D]; 4], factors: [f64; 4]) -> [f64; D] {
    std::array::from_fn(|d| rows.iter().zip(factors).map(|(row, factor)| f64::from(row[d]) * factor).sum())
}

fn derivatives(moving: Moving, duration: f64) -> ([f32; 3], [f32; 4]) {
    let by_second = 1.0 / duration;
    ((moving.velocity * by_second).to_array().map(single), xyzw(moving.turning * by_second))
}

fn xyzw(q: Quat) -> [f32; 4] {
    [q.x, q.y, q.z, q.w].map(single)
}
