//! A motion as a track of keys: cubic pieces between them, as animations of glTF (`CUBICSPLINE`) have them.
//!
//! Translation and quaternion are Hermite cubics between keys, the quaternion made of length 1 afterwards. That is no rational motion of
//! ours, so keys are set closer until the body is within the tolerance; how far it is, is measured on the rounded numbers.
//!
//! Keys stand at times that single precision has, and poses are taken at these: a body that runs fast is not off by the rounding of a time.
//! Between two keys the body is looked at in places evenly apart, and where the motion has its cells (`Schedule::breaks`), which lie close where it
//! does much in a moment.

use crate::export::mesh::single;
use cyclide::{
    Point3, Quat, Vec3,
    motion::{Pose, Schedule},
};

/// Part of the tolerance that is used between the places looked at.
const SHARE: f64 = 0.5;
/// Places looked at between two keys while they are chosen.
const PLACES: u32 = 5;
/// The same when the track is made, and when a file is read.
const CHECKED: u32 = 9;
/// Most keys of a track: 18 MB of them.
const MOST_KEYS: usize = 200_000;
/// Tangents at a key are those this part of the interval inside: at a joint they jump.
const INSIDE: f64 = 1e-9;
/// What rounding to single precision may move a point by, in parts of its distance: of the place and the tangents of two keys, and of the turn.
const ROUNDING: f64 = 6e-7;

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
    /// Times of single precision.
    times: [f32; 2],
    /// The parts of the duration there.
    ends: [f64; 2],
    from: Moving,
    to: Moving,
}

/// The body of a motion, as far as keys go: where its origin is relative to a center, and how far its points are from it.
pub(super) struct Carried<'a> {
    pub(super) schedule: &'a Schedule<'a>,
    pub(super) duration: f64,
    pub(super) center: Point3,
    pub(super) reach: f64,
    /// How far its origin gets from the center.
    pub(super) radius: f64,
    /// Where the motion has its cells.
    pub(super) breaks: Vec<f64>,
}

/// Why there is no track within a tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TrackFault {
    /// So many keys are too few, or single precision has no times between two of them: at these seconds the body is that far off.
    Off { keys: usize, off: f64, seconds: f64 },
}

impl Carried<'_> {
    /// The track within a tolerance and the rounding of single precision, with keys where spans start.
    ///
    /// # Errors
    /// [`TrackFault`].
    pub(super) fn track(&self, tolerance: f64) -> Result<(Track, f64), TrackFault> {
        let joints = self.schedule.timing().joints();
        let mut intervals = Vec::new();
        let mut start = 0.0_f32;
        for (k, span) in joints.windows(2).enumerate() {
            let end = single(span[1] * self.duration);
            // A span that is shorter than single precision tells is passed over; the next one is held against what is left out.
            if end > start || (k + 2 == joints.len() && intervals.is_empty()) {
                self.cut([start, end], [span[0], span[1]], SHARE * tolerance, &mut intervals)?;
                start = end;
            }
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
            track.push(interval.times[1], to, Some(to), None, self.duration);
            before = Some(to.rotation);
        }
        let (off, seconds) = self.deviation(&track);
        let limit = tolerance + ROUNDING * (self.radius + self.reach);
        if off <= limit { Ok((track, off)) } else { Err(TrackFault::Off { keys: track.times.len(), off, seconds }) }
    }

    fn cut(&self, times: [f32; 2], span: [f64; 2], tolerance: f64, out: &mut Vec<Interval>) -> Result<(), TrackFault> {
        let interval = self.interval(times, span);
        let [a, b] = interval.ends;
        let off = |x: f64| {
            let (translation, rotation) = interval.at((x - a) / (b - a));
            self.off(x, translation, rotation)
        };
        let even = (1..=PLACES).map(|k| a + (b - a) * f64::from(k) / f64::from(PLACES + 1));
        let worst = even.chain(self.cells_between([a, b])).map(|x| (off(x), x)).find(|(off, _)| !(*off <= tolerance));
        let Some((off, place)) = worst else {
            out.push(interval);
            return Ok(());
        };
        let middle = single(0.5 * (f64::from(times[0]) + f64::from(times[1])));
        if middle <= times[0] || middle >= times[1] {
            // Nearer than this no keys are told apart; the whole track is measured in the end.
            out.push(interval);
            return Ok(());
        }
        if out.len() >= MOST_KEYS {
            return Err(TrackFault::Off { keys: out.len(), off, seconds: place * self.duration });
        }
        self.cut([times[0], middle], span, tolerance, out)?;
        self.cut([middle, times[1]], span, tolerance, out)
    }

    /// Where cells of the motion meet within an interval, and the middles between these.
    fn cells_between(&self, [a, b]: [f64; 2]) -> impl Iterator<Item = f64> {
        let first = self.breaks.partition_point(|x| *x <= a).saturating_sub(1);
        let near = self.breaks[first..].windows(2).take_while(move |pair| pair[0] < b);
        near.flat_map(|pair| [pair[0], 0.5 * (pair[0] + pair[1])]).filter(move |x| *x > a && *x < b)
    }

    /// Two keys at times within a span with these ends, or next to them but for rounding.
    fn interval(&self, times: [f32; 2], span: [f64; 2]) -> Interval {
        let ends = times.map(|time| (f64::from(time) / self.duration).min(1.0));
        let step = INSIDE * (ends[1] - ends[0]);
        let from = self.moving(ends[0], ends[0].max(span[0]) + step);
        let to = self.moving(ends[1], ends[1].min(span[1]) - step).beside(Some(from.rotation));
        Interval { times, ends, from, to }
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

    /// How far the body of a track is off at most, and when, in seconds.
    pub(super) fn deviation(&self, track: &Track) -> (f64, f64) {
        let mut most = (0.0_f64, 0.0_f64);
        for k in 1..track.times.len() {
            let [a, b] = [track.times[k - 1], track.times[k]].map(f64::from);
            let even = (0..=CHECKED).map(|place| f64::from(place) / f64::from(CHECKED));
            let cells = self.cells_between([a / self.duration, b / self.duration]);
            for s in even.chain(cells.map(|x| (x * self.duration - a) / (b - a))) {
                let (translation, rotation) = track.at(k, s);
                let seconds = a + (b - a) * s;
                let off = self.off(seconds / self.duration, translation, rotation);
                if !(off <= most.0) {
                    most = (if off.is_nan() { f64::INFINITY } else { off }, seconds);
                }
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
    fn push(&mut self, time: f32, key: Moving, before: Option<Moving>, after: Option<Moving>, duration: f64) {
        let by_second =
            |moving: Option<Moving>| moving.map_or(([0.0; 3], [0.0; 4]), |moving| derivatives(moving, duration));
        let ((v0, q0), (v1, q1)) = (by_second(before), by_second(after));
        self.times.push(time);
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
