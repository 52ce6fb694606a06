//! Colors in linear light, and how a surface shines.

use crate::formats::png::eye::UP;
use cyclide::Vec3;

/// Brightness of the three primaries, linear.
pub(super) type Rgb = [f64; 3];

/// Directions to the lights: a broad one from behind the left shoulder, a weak one from the right, and the sky.
pub(super) struct Lights {
    pub(super) key: Vec3,
    fill: Vec3,
}

const KEY: f64 = 0.70;
const FILL: f64 = 0.14;
const SKY: f64 = 0.42;
const EARTH: f64 = 0.24;
/// How far the broad light reaches round an edge.
const WRAP: f64 = 0.12;
/// The least part of a color that stands for a value which reaches the eye.
const TONE: f64 = 0.66;
/// Two lobes of reflection: strength and exponent.
const GLOSS: [(f64, i32); 2] = [(0.16, 64), (0.05, 12)];
/// Light that a surface reflects when seen along it.
const GRAZING: f64 = 0.16;

impl Lights {
    /// The lights that go with a view: right, up and toward the eye.
    pub(super) fn new([right, up, toward]: [Vec3; 3]) -> Self {
        // In the view from above, which has no horizontal direction to the eye, up takes its place.
        let flat = Vec3::new(toward.x, toward.y, 0.0);
        let front = if flat.length() > 0.1 { flat.unit().unwrap_or(up) } else { -up };
        let unit = |v: Vec3| v.unit().unwrap_or(UP);
        Self { key: unit(-right * 0.55 + front * 0.25 + UP), fill: unit(right * 0.9 + front * 0.5 + UP * 0.2) }
    }

    /// What a matt surface sends whose color stands for a value: no gloss, and little shade.
    pub(super) fn tone(&self, tint: Rgb, normal: Vec3) -> Rgb {
        let key = ((normal.dot(self.key) + WRAP) / (1.0 + WRAP)).max(0.0);
        let sky = 0.5 + 0.5 * normal.z;
        let light = (KEY * key + FILL * normal.dot(self.fill).max(0.0) + SKY * sky) / (KEY + SKY);
        tint.map(|c| c * (TONE + (1.0 - TONE) * light.min(1.0)))
    }

    /// What a matt surface with a little gloss sends to the eye: `normal` and `to_eye` are unit vectors, on one side.
    pub(super) fn shade(&self, tint: Rgb, normal: Vec3, to_eye: Vec3) -> Rgb {
        let key = ((normal.dot(self.key) + WRAP) / (1.0 + WRAP)).max(0.0);
        let fill = normal.dot(self.fill).max(0.0);
        let sky = 0.5 + 0.5 * normal.z;
        let matt = KEY * key + FILL * fill + EARTH + (SKY - EARTH) * sky;
        let half = (self.key + to_eye).unit().unwrap_or(normal).dot(normal).max(0.0);
        let lit = if normal.dot(self.key) > 0.0 { 1.0 } else { 0.0 };
        let gloss: f64 = GLOSS.iter().map(|(strength, exponent)| strength * half.powi(*exponent)).sum();
        let away = 1.0 - normal.dot(to_eye).clamp(0.0, 1.0);
        let shine = lit * gloss + GRAZING * sky * away.powi(4);
        tint.map(|c| c * matt + shine)
    }
}

/// To a color of the screen, 0 to 1.
pub(super) fn screen(v: f64) -> f64 {
    let v = v.clamp(0.0, 1.0);
    if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 }
}

pub(super) fn mix(a: Rgb, b: Rgb, part: f64) -> Rgb {
    std::array::from_fn(|k| a[k] + (b[k] - a[k]) * part)
}
