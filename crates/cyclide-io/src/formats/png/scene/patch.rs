//! A patch over a triangle as the picture sees it: its color, and the sides of the triangle as lines of constant width.

use super::light::{Lights, Rgb, mix};
use super::surface::{BORDER, EDGE, EDGE_INK, INNER, cover, fade};
use crate::drawing::palette;
use cyclide::{
    Vec3,
    surface::{SideLine, TrianglePatch, TriangleSurface},
};

/// Half width of the lines between triangles that go on smoothly, pixels, and the strength of their ink.
const SMOOTH: f64 = 0.4;
const SMOOTH_INK: f64 = 0.3;

/// A patch with what is drawn on it.
pub(super) struct Patch {
    patch: TrianglePatch,
    /// Half width and ink of the lines along the sides, each opposite to the corner of its place.
    sides: [(f64, f64); 3],
    tint: Rgb,
    inner_tint: Rgb,
    ink: Rgb,
}

/// The patches of a surface for the picture; `scale` multiplies the widths of lines.
pub(super) fn patches(surface: &TriangleSurface, object: usize, scale: f64) -> impl Iterator<Item = Patch> {
    let (ink, tint) = (palette::linear(object), palette::surface(object));
    let inner_tint = if surface.is_closed() { tint } else { tint.map(|c| c * INNER) };
    (0..surface.triangle_count()).filter_map(move |triangle| {
        let sides = surface.lines(triangle).map(|line| match line {
            SideLine::Smooth => (SMOOTH * scale, SMOOTH_INK),
            SideLine::Crease => (EDGE * scale, EDGE_INK),
            SideLine::Free => (BORDER * scale, EDGE_INK),
        });
        Some(Patch { patch: surface.patch(triangle)?, sides, tint, inner_tint, ink })
    })
}

impl Patch {
    /// What is seen at barycentric coordinates `at`, which change by `slope` from pixel to pixel.
    /// A tint is one in place of its own.
    pub(super) fn colour(
        &self,
        (at, slope): ([f64; 3], [f64; 3]),
        to_eye: Vec3,
        lights: &Lights,
        tint: Option<Rgb>,
    ) -> Rgb {
        let outward = self.patch.point_and_normal(at).map_or(to_eye, |(_, normal)| normal);
        let front = outward.dot(to_eye) >= 0.0;
        let (normal, own) = if front { (outward, self.tint) } else { (-outward, self.inner_tint) };
        let tint = tint.unwrap_or(own);
        let lit = lights.shade(tint, normal, to_eye);
        let line = |k: usize| {
            let (width, ink) = self.sides[k];
            if slope[k] > 0.0 { ink * cover(at[k] / slope[k], width) * fade(1.0 / slope[k]) } else { 0.0 }
        };
        mix(lit, self.ink, line(0).max(line(1)).max(line(2)))
    }
}
