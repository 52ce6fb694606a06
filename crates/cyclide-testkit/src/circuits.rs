//! Closed curves as point lists, in the shapes that tempt an arc fit: circuits of several kilometers sampled every five
//! meters, with survey noise, hairpins, chicanes and corners; the same thinned; outlines. The same set at every call.

use cyclide::{Point2, Point3, Vec2};
use std::f64::consts::TAU;

/// Distance of neighboring samples of a circuit, meters.
const SPACING: f64 = 5.0;

/// A named closed point list; the first point is not repeated.
#[derive(Debug, Clone)]
pub struct Circuit {
    /// Name for messages.
    pub name: String,
    /// The points, in the plane `z = 0`.
    pub points: Vec<Point3>,
}

/// The whole set: 42 closed curves.
#[must_use]
pub fn circuits() -> Vec<Circuit> {
    let mut set = Vec::new();
    let mut add = |name: String, points: Vec<Point3>| set.push(Circuit { name, points });
    for seed in 0..5 {
        let smooth = wave(seed);
        for centimetres in [0, 1, 5] {
            add(format!("wave {seed}, {centimetres} cm"), noisy(&smooth, 0.01 * f64::from(centimetres), seed));
        }
    }
    for seed in 0..5 {
        let road = road(seed, 0);
        for centimetres in [0, 2] {
            add(format!("road {seed}, {centimetres} cm"), noisy(&road, 0.01 * f64::from(centimetres), seed));
        }
    }
    for seed in 0..2 {
        add(format!("wave {seed}, every 3rd"), thinned(&wave(seed), 3));
        add(format!("road {seed}, every 2nd"), thinned(&road(seed, 0), 2));
        add(format!("road {seed} with corners"), noisy(&road(seed, 3), 0.01, seed));
    }
    for seed in 0..6 {
        add(format!("polygon {seed}"), polygon(seed));
    }
    add("gear".to_owned(), gear());
    add("star".to_owned(), outline(&star(), 1.5));
    add(
        "L".to_owned(),
        outline(&[[0.0, 0.0], [60.0, 0.0], [60.0, 20.0], [20.0, 20.0], [20.0, 80.0], [0.0, 80.0]], 1.0),
    );
    add("track".to_owned(), file(include_str!("../../../examples/track.csv")));
    add("survey".to_owned(), file(include_str!("../../../examples/survey.csv")));
    set
}

/// Random numbers that are the same everywhere: splitmix64.
struct Random(u64);

impl Random {
    fn new(stream: u64, seed: u64) -> Self {
        Self(stream.wrapping_mul(0xd6e8_feb8_6659_fd93).wrapping_add(seed))
    }

    /// Uniform in `[-1, 1)`.
    fn signed(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + 0.5 * (self.signed() + 1.0) * (hi - lo)
    }
}

/// A smooth closed curve of 4 to 8 km: a circle with random waves up to the eighth harmonic.
fn wave(seed: u64) -> Vec<Point3> {
    let mut random = Random::new(1, seed);
    let size = random.between(500.0, 900.0);
    let waves: Vec<[f64; 3]> =
        (2..=8).map(|n| [f64::from(n), 0.35 / f64::from(n) * random.signed(), TAU * random.signed()]).collect();
    let at = |i: usize| {
        let a = TAU * i as f64 / 20_000.0;
        let r = size * waves.iter().fold(1.0, |r, [n, depth, phase]| r + depth * (n * a + phase).cos());
        Point2::new(r * a.cos(), 0.7 * r * a.sin())
    };
    sampled(&(0..20_000).map(at).collect::<Vec<_>>(), SPACING)
}

/// Straights joined by arcs of 15 to 150 m: a polygon round the origin with its vertices filleted, with hairpins and
/// chicanes where the polygon has spikes and steps. Every `sharp`-th vertex stays a corner (0: none).
fn road(seed: u64, sharp: usize) -> Vec<Point3> {
    let mut random = Random::new(2, seed);
    let count = 14 + (seed as usize % 4) * 2;
    let mut polygon = Vec::new();
    for i in 0..count {
        let a = TAU * (i as f64 + 0.3 * random.signed()) / count as f64;
        let r = if i % 3 == 0 { random.between(300.0, 500.0) } else { random.between(600.0, 1000.0) };
        let p = Point2::new(r * a.cos(), 0.8 * r * a.sin());
        if i % 5 == 2 {
            // A chicane: a step of 12 m to the side and back.
            let (along, across) = (Vec2::new(-a.sin(), a.cos()), Vec2::new(a.cos(), a.sin()));
            polygon.extend([p, p + along * 30.0 + across * 12.0, p + along * 60.0]);
        } else {
            polygon.push(p);
        }
    }
    let n = polygon.len();
    let mut path = Vec::new();
    for i in 0..n {
        let radius = if sharp > 0 && i % sharp == 0 { 0.0 } else { random.between(15.0, 150.0) };
        fillet([polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]], radius, &mut path);
    }
    sampled(&path, SPACING)
}

/// The arc of at most this radius that rounds a vertex, as dense points; the vertex itself if there is no room.
fn fillet([before, at, after]: [Point2; 3], radius: f64, path: &mut Vec<Point2>) {
    let (Some(u), Some(v)) = ((at - before).unit(), (after - at).unit()) else { return };
    let turn = u.cross(v).atan2(u.dot(v));
    let room = 0.45 * at.distance(before).min(at.distance(after));
    let radius = radius.min(room / (0.5 * turn.abs()).tan());
    if radius < 1.0 {
        path.push(at);
        return;
    }
    let start = at + u * (-radius * (0.5 * turn.abs()).tan());
    for i in 0..=200 {
        let a = turn.abs() * f64::from(i) / 200.0;
        path.push(start + u * (radius * a.sin()) + u.left() * (turn.signum() * radius * (1.0 - a.cos())));
    }
}

/// Points at equal steps of about `spacing` along a dense closed polyline.
fn sampled(dense: &[Point2], spacing: f64) -> Vec<Point3> {
    let n = dense.len();
    let mut lengths = vec![0.0];
    for i in 0..n {
        lengths.push(lengths[i] + dense[i].distance(dense[(i + 1) % n]));
    }
    let count = (lengths[n] / spacing).round().max(3.0) as usize;
    let mut edge = 0;
    let at = |i: usize| {
        let goal = lengths[n] * i as f64 / count as f64;
        while edge + 1 < n && lengths[edge + 1] <= goal {
            edge += 1;
        }
        let (a, b) = (dense[edge], dense[(edge + 1) % n]);
        let p = a + (b - a) * ((goal - lengths[edge]) / (lengths[edge + 1] - lengths[edge]).max(f64::MIN_POSITIVE));
        Point3::new(p.x, p.y, 0.0)
    };
    (0..count).map(at).collect()
}

/// The points moved at random by up to `size` in each coordinate.
fn noisy(points: &[Point3], size: f64, seed: u64) -> Vec<Point3> {
    let mut random = Random::new(3, seed);
    points.iter().map(|p| Point3::new(p.x + size * random.signed(), p.y + size * random.signed(), 0.0)).collect()
}

fn thinned(points: &[Point3], step: usize) -> Vec<Point3> {
    points.iter().copied().step_by(step).collect()
}

/// A polygon's edges, sampled.
fn outline(corners: &[[f64; 2]], spacing: f64) -> Vec<Point3> {
    let n = corners.len();
    let at = |i: usize| Point3::new(corners[i % n][0], corners[i % n][1], 0.0);
    let edge = |i: usize| {
        let steps = (at(i).distance(at(i + 1)) / spacing).ceil();
        (0..steps as usize).map(move |j| at(i).lerp(at(i + 1), j as f64 / steps))
    };
    (0..n).flat_map(edge).collect()
}

/// Straight sides of forty points each between corners of a few to some thirty degrees.
fn polygon(seed: u64) -> Vec<Point3> {
    let mut random = Random::new(4, seed);
    let count = 9 + 4 * seed as usize;
    let corner = |i: usize| {
        let (s, c) = (TAU * (i as f64 + 0.3 * random.signed()) / count as f64).sin_cos();
        let r = 400.0 * (1.0 + 0.04 * random.signed());
        Point3::new(1.3 * r * c, r * s, 0.0)
    };
    let corners: Vec<Point3> = (0..count).map(corner).collect();
    let side = |i: usize| {
        let (from, to) = (corners[i], corners[(i + 1) % count]);
        (0..40).map(move |k| from.lerp(to, f64::from(k) / 40.0))
    };
    (0..count).flat_map(side).collect()
}

fn star() -> Vec<[f64; 2]> {
    let at = |i: u32| {
        let (s, c) = (TAU * f64::from(i) / 10.0).sin_cos();
        let r = if i.is_multiple_of(2) { 50.0 } else { 20.0 };
        [r * c, r * s]
    };
    (0..10).map(at).collect()
}

/// A gear of twelve rounded teeth.
fn gear() -> Vec<Point3> {
    let at = |i: u32| {
        let a = TAU * f64::from(i) / 480.0;
        let r = 40.0 + 4.0 * (3.0 * (12.0 * a).sin()).tanh();
        Point3::new(r * a.cos(), r * a.sin(), 0.0)
    };
    (0..480).map(at).collect()
}

/// The first two numbers of every line that has them.
fn file(text: &str) -> Vec<Point3> {
    let point = |line: &str| {
        let mut numbers = line.split(',').map(|v| v.trim().parse::<f64>());
        Some(Point3::new(numbers.next()?.ok()?, numbers.next()?.ok()?, 0.0))
    };
    text.lines().filter_map(point).collect()
}
