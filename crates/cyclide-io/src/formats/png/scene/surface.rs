//! A face as the picture sees it: its color, and its parameter circles as lines of constant width.

use super::camera::Camera;
use super::light::{Lights, Rgb, mix};
use crate::drawing::palette;
use crate::drawing::parameter_circles::{Planes, halvings};
use crate::drawing::plane_regions::drawn_edges;
use cyclide::{
    Vec3,
    surface::ParamSurface as _,
    topology::{FaceSurface, Shell, Side},
};

/// Distance that the inner parameter circles have, about, pixels.
const SPACING: f64 = 30.0;
/// Half widths of lines, pixels: inner circles, edges between two patches, and the visible side of a border.
pub(super) const CIRCLE: f64 = 0.45;
pub(super) const EDGE: f64 = 0.75;
pub(super) const BORDER: f64 = 1.8;
/// Strength of the ink: inner circles, edges.
pub(super) const CIRCLE_INK: f64 = 0.36;
/// The same of lines at given places.
pub(super) const PLACE_INK: f64 = 0.5;
pub(super) const EDGE_INK: f64 = 0.78;
/// Lines closer together than the first are gone, farther apart than the second they have their full strength, pixels.
const FADE: (f64, f64) = (3.5, 9.0);
/// A step of Newton's method after which no other is needed, relative to the facet's parameters.
const SMALL_STEP: f64 = 0.03;
/// How much of a color that stands for a value is left in the lines on it.
const LINE_ON_TINT: f64 = 0.16;
/// How much darker the inner side of an open shell is.
pub(super) const INNER: f64 = 0.78;

/// A face with what is drawn on it.
pub(super) struct Surface<'a> {
    pub(super) surface: &'a FaceSurface,
    /// The inner lines across s and across t.
    pub(super) lines: [Lines; 2],
    /// Half widths and ink of the sides t=0, t=1, s=0, s=1; 0 for a side of one point, and between parts of one plane.
    pub(super) sides: [(f64, f64); 4],
    pub(super) outer: f64,
    /// What turns the signs of curvatures to the outer side.
    pub(super) bend: f64,
    pub(super) tint: Rgb,
    pub(super) inner_tint: Rgb,
    pub(super) ink: Rgb,
    /// Widths of lines are multiplied by this.
    pub(super) scale: f64,
}

/// The inner lines on which a parameter is constant.
pub(super) enum Lines {
    /// Of so many twofold divisions; finer ones fade where they stand close.
    Halvings(u32),
    /// At these parameters, rising: as dense as they are.
    Places(Vec<f64>),
}

/// The faces of a shell for the picture; `unit` is the size of a pixel, `scale` multiplies widths and distances of lines.
pub(super) fn surfaces(shell: &Shell, object: usize, unit: f64, scale: f64) -> impl Iterator<Item = Surface<'_>> {
    let uses = shell.edge_uses();
    let levels = halvings(shell, SPACING * scale * unit, Planes::Plain);
    let closed = uses.iter().all(|n| *n == 2);
    let drawn = drawn_edges(shell);
    let (ink, tint) = (palette::linear(object), palette::surface(object));
    shell.faces().iter().zip(levels).map(move |(face, levels)| {
        let width = |edge: usize| match uses[edge] {
            1 => scale * BORDER,
            _ if !drawn[edge] => 0.0,
            _ => scale * EDGE,
        };
        Surface {
            surface: &face.surface,
            lines: levels.map(Lines::Halvings),
            sides: face.sides.map(|side| (side.map_or(0.0, |s| width(s.edge)), EDGE_INK)),
            outer: face.outer_sign(),
            bend: face.outer_sign_of_unit_normal(),
            tint,
            inner_tint: if closed { tint } else { tint.map(|c| c * INNER) },
            ink,
            scale,
        }
    })
}

impl Surface<'_> {
    /// Where the ray from the eye meets the patch itself, with the growth of both parameters per pixel.
    ///
    /// On a large facet the parameters grow unevenly, so those of the facet are only near: two steps of Newton's method
    /// follow, `f + a f_s + b f_t` on the ray (`d` from the eye, `r` along the ray: `a = -d·(f_t × r)/D`,
    /// `b = d·(f_s × r)/D`, `D = r·(f_s × f_t)`). Steps larger than the facet's `corners` are apart are refused: beside an
    /// outline the ray may miss the patch.
    pub(super) fn settle(
        &self,
        (rough, slope): ([f64; 2], [f64; 2]),
        corners: &[[f64; 2]; 3],
        ray: Vec3,
        camera: &Camera,
    ) -> ([f64; 2], [f64; 2]) {
        let extent = |k: usize| {
            let [a, b, c] = corners.map(|corner| corner[k]);
            a.max(b).max(c) - a.min(b).min(c)
        };
        let extent = [extent(0), extent(1)];
        let (mut at, mut best) = (rough, (rough, slope));
        for _ in 0..2 {
            let jet = self.surface.jet(at[0], at[1]);
            let (across_s, across_t) = (jet.dt.cross(ray), jet.ds.cross(ray));
            let area = jet.ds.dot(across_s);
            let step = |d: Vec3| [-d.dot(across_s) / area, d.dot(across_t) / area];
            let from_eye = jet.point - camera.eye();
            let [a, b] = step(from_eye);
            // Also refuses NaN.
            if !(a.abs() <= extent[0] && b.abs() <= extent[1]) {
                return best;
            }
            at = [(at[0] + a).clamp(0.0, 1.0), (at[1] + b).clamp(0.0, 1.0)];
            let [right, up] = camera.steps(from_eye).map(step);
            best = (at, [growth(right[0], up[0]), growth(right[1], up[1])]);
            // The square of this is out of sight.
            if a.abs() <= SMALL_STEP * extent[0] && b.abs() <= SMALL_STEP * extent[1] {
                break;
            }
        }
        best
    }

    /// The same where a quantity has the color `tint`: the light leaves it to be read.
    pub(super) fn tinted(&self, (at, slope): ([f64; 2], [f64; 2]), to_eye: Vec3, lights: &Lights, tint: Rgb) -> Rgb {
        let outward = self.surface.normal(at[0], at[1]).unwrap_or(to_eye);
        let normal = if outward.dot(to_eye) >= 0.0 { outward } else { -outward };
        let [s, t] = [0, 1].map(|k| self.lines(at[k], slope[k], k));
        mix(lights.tone(tint, normal), tint.map(|c| LINE_ON_TINT * c), s.max(t))
    }

    /// What is seen at parameters `at`, which change by `slope` from pixel to pixel (each along both axes).
    pub(super) fn colour(&self, at: [f64; 2], slope: [f64; 2], to_eye: Vec3, lights: &Lights) -> Rgb {
        let outward = self.surface.normal(at[0], at[1]).unwrap_or(to_eye) * self.outer;
        let front = outward.dot(to_eye) >= 0.0;
        let (normal, tint) = if front { (outward, self.tint) } else { (-outward, self.inner_tint) };
        let lit = lights.shade(tint, normal, to_eye);
        let [s, t] = [0, 1].map(|k| self.lines(at[k], slope[k], k));
        mix(lit, self.ink, s.max(t))
    }

    /// Strength of the ink of the lines on which parameter `k` is constant; `slope` is its growth per pixel.
    fn lines(&self, at: f64, slope: f64, k: usize) -> f64 {
        if !(slope > 0.0) {
            return 0.0;
        }
        let [first, last] = if k == 0 { [Side::Left, Side::Right] } else { [Side::Bottom, Side::Top] };
        let (side, ink) = self.sides[if at < 0.5 { first } else { last } as usize];
        let edge = ink * cover(at.min(1.0 - at).max(0.0) / slope, side) * fade(1.0 / slope);
        let width = CIRCLE * self.scale;
        let inner = match &self.lines[k] {
            Lines::Halvings(levels) => CIRCLE_INK * halved(at, slope, *levels, width),
            Lines::Places(places) => PLACE_INK * dense(at, slope, places, width),
        };
        edge.max(inner)
    }
}

/// How much of a pixel lines of twofold divisions cover, those that stand close faded.
fn halved(at: f64, slope: f64, levels: u32, width: f64) -> f64 {
    let (mut strength, mut count): (f64, f64) = (0.0, 1.0);
    for _ in 0..levels {
        count *= 2.0;
        let spacing = 1.0 / (count * slope);
        if spacing <= FADE.0 {
            break;
        }
        let place = at * count;
        let nearest = f64::from((place + 0.5) as u32);
        if nearest <= 0.0 || nearest >= count {
            continue;
        }
        strength = strength.max(cover((place - nearest).abs() * spacing, width) * fade(spacing));
    }
    strength
}

/// How much of a pixel lines at given places cover, however close they stand: where there are many it is their mean tone.
fn dense(at: f64, slope: f64, places: &[f64], width: f64) -> f64 {
    let reach = (0.5 + width) * slope;
    let first = places.partition_point(|x| *x < at - reach);
    let near = &places[first..first + places[first..].partition_point(|x| *x <= at + reach)];
    let covered = match near.len() {
        0..=8 => near.iter().map(|x| cover((at - x).abs() / slope, width)).sum(),
        // Of lines that pass by anywhere within reach.
        count => count as f64 * width / (0.5 + width),
    };
    f64::min(covered, 1.0)
}

/// Length of a gradient; `hypot` guards against overflow that pixels do not have, at ten times the cost.
pub(super) fn growth(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// How much of a pixel a line covers whose middle is so many pixels away.
pub(super) fn cover(distance: f64, half_width: f64) -> f64 {
    // A pixel from distance - 1/2 to distance + 1/2 against the line from -w to w.
    ((distance + 0.5).min(half_width) - (distance - 0.5).max(-half_width)).clamp(0.0, 1.0)
}

pub(super) fn fade(spacing: f64) -> f64 {
    ((spacing - FADE.0) / (FADE.1 - FADE.0)).clamp(0.0, 1.0)
}
