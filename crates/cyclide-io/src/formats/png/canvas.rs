//! Strokes, fills and text in pixels.

use super::lettering;
use crate::export::error::ExportError;
use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};

/// A place in the picture, pixels to the right and down.
pub(super) type Pixel = (f32, f32);

/// A color with its opacity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ink {
    red: f64,
    green: f64,
    blue: f64,
    alpha: f64,
}

/// Paper, as a color of the screen.
pub(super) const PAPER: u32 = 0xFBFBF9;

impl Ink {
    const PAPER: Self = Self::new(PAPER, 1.0);
    pub(super) const COMB: Self = Self::new(0xE2803F, 0.42);
    pub(super) const COMB_EDGE: Self = Self::new(0xD9722E, 0.85);
    pub(super) const COMB_AREA: Self = Self::new(0xF2A46B, 0.13);
    pub(super) const FLOOR: Self = Self::new(0xF1F2F0, 1.0);
    pub(super) const FLOOR_LINE: Self = Self::new(0xDFE2E0, 1.0);
    /// Data points of a fit, below its curve.
    const DATA: Self = Self::new(0x9CC0E4, 1.0);
    pub(super) const SHADOW: Self = Self::new(0xB9C0C4, 0.8);
    /// A place where a surface bends alike in all directions.
    pub(super) const UMBILIC: Self = Self::new(0xC62A6B, 1.0);
    /// Text, and what is said beside it.
    pub(super) const TEXT: Self = Self::new(0x1D242B, 1.0);
    pub(super) const SOFT: Self = Self::new(0x5D6974, 1.0);

    const fn new(rgb: u32, alpha: f64) -> Self {
        Self {
            red: (rgb >> 16) as f64 / 255.0,
            green: (rgb >> 8 & 0xFF) as f64 / 255.0,
            blue: (rgb & 0xFF) as f64 / 255.0,
            alpha,
        }
    }

    /// A color of the screen.
    pub(super) const fn of_screen(rgb: u32) -> Self {
        Self::new(rgb, 1.0)
    }

    /// The color of an object.
    pub(super) fn object(index: usize) -> Self {
        Self::new(crate::drawing::palette::object(index), 1.0)
    }

    /// The color of an object's surfaces.
    pub(super) fn surface(index: usize) -> Self {
        Self::new(crate::drawing::palette::surface_on_screen(index), 1.0)
    }

    /// The color moved towards the paper; 1 is far away, which is still well visible.
    pub(super) fn faded(self, far: f64) -> Self {
        let mix = |a: f64, b: f64| a + (b - a) * 0.55 * far;
        Self {
            red: mix(self.red, Ink::PAPER.red),
            green: mix(self.green, Ink::PAPER.green),
            blue: mix(self.blue, Ink::PAPER.blue),
            ..self
        }
    }

    fn color(self) -> Color {
        let channel = |v: f64| v.clamp(0.0, 1.0) as f32;
        Color::from_rgba(channel(self.red), channel(self.green), channel(self.blue), channel(self.alpha))
            .unwrap_or(Color::BLACK)
    }

    fn paint(self) -> Paint<'static> {
        let mut paint = Paint { anti_alias: true, ..Paint::default() };
        paint.set_color(self.color());
        paint
    }
}

/// The picture as it is drawn.
pub(super) struct Canvas {
    pixels: Pixmap,
}

impl Canvas {
    /// An empty sheet; `None` if it has no size.
    pub(super) fn new(width: u32, height: u32) -> Option<Self> {
        let mut pixels = Pixmap::new(width, height)?;
        pixels.fill(Ink::PAPER.color());
        Some(Self { pixels })
    }

    /// A line with round ends and corners.
    pub(super) fn stroke(&mut self, points: &[Pixel], closed: bool, width: f64, ink: Ink) {
        self.line(path([points], closed), width, ink, LineCap::Round);
    }

    /// A line in dashes and gaps of the same length.
    pub(super) fn dashes(&mut self, points: &[Pixel], closed: bool, width: f64, length: f64, ink: Ink) {
        let Some(path) = path([points], closed) else {
            return;
        };
        let dash = StrokeDash::new(vec![length as f32, length as f32], 0.0);
        let stroke = Stroke { width: width as f32, line_join: LineJoin::Round, dash, ..Stroke::default() };
        self.pixels.stroke_path(&path, &ink.paint(), &stroke, Transform::identity(), None);
    }

    /// Lines that are one shape: where they cross they are not darker.
    pub(super) fn strokes<'a>(&mut self, lines: impl IntoIterator<Item = &'a [Pixel]>, width: f64, ink: Ink) {
        self.line(path(lines, false), width, ink, LineCap::Butt);
    }

    /// A line in the color of the paper that ends where it ends.
    pub(super) fn rim(&mut self, points: &[Pixel], width: f64) {
        self.line(path([points], false), width, Ink { alpha: 0.85, ..Ink::PAPER }, LineCap::Butt);
    }

    fn line(&mut self, path: Option<Path>, width: f64, ink: Ink, line_cap: LineCap) {
        let Some(path) = path else {
            return;
        };
        let stroke = Stroke { width: width as f32, line_cap, line_join: LineJoin::Round, ..Stroke::default() };
        self.pixels.stroke_path(&path, &ink.paint(), &stroke, Transform::identity(), None);
    }

    pub(super) fn fill(&mut self, points: &[Pixel], ink: Ink) {
        if let Some(path) = path([points], true) {
            self.pixels.fill_path(&path, &ink.paint(), FillRule::EvenOdd, Transform::identity(), None);
        }
    }

    /// A joint: a pale dot with a dark ring.
    pub(super) fn dot(&mut self, at: Pixel, radius: f64) {
        self.disc(at, radius, 0.38 * radius, Ink::object(0));
    }

    /// A disc of paper with a ring.
    pub(super) fn disc(&mut self, (x, y): Pixel, radius: f64, ring: f64, ink: Ink) {
        let Some(circle) = PathBuilder::from_circle(x, y, radius as f32) else {
            return;
        };
        let stroke = Stroke { width: ring as f32, ..Stroke::default() };
        self.pixels.fill_path(&circle, &Ink::PAPER.paint(), FillRule::Winding, Transform::identity(), None);
        self.pixels.stroke_path(&circle, &ink.paint(), &stroke, Transform::identity(), None);
    }

    /// A data point: a small dot.
    pub(super) fn spot(&mut self, (x, y): Pixel, radius: f64) {
        if let Some(circle) = PathBuilder::from_circle(x, y, radius as f32) {
            self.pixels.fill_path(&circle, &Ink::DATA.paint(), FillRule::Winding, Transform::identity(), None);
        }
    }

    /// A line of text from the left end of its base line, capitals `size` high.
    pub(super) fn text(&mut self, text: &str, at: (f64, f64), size: f64, ink: Ink) {
        self.line(lettering::path(text, at, size), lettering::stroke_width(size), ink, LineCap::Round);
    }

    /// Text over a drawing: with a rim of paper round its strokes.
    pub(super) fn label(&mut self, text: &str, at: (f64, f64), size: f64, ink: Ink) {
        let rim = Ink { alpha: 0.9, ..Ink::PAPER };
        self.line(lettering::path(text, at, size), 4.5 * lettering::stroke_width(size), rim, LineCap::Round);
        self.text(text, at, size, ink);
    }

    /// Sets a pixel to a color of the screen.
    pub(super) fn set(&mut self, x: usize, y: usize, [red, green, blue]: [u8; 3]) {
        let start = 4 * (y * self.pixels.width() as usize + x);
        self.pixels.data_mut()[start..start + 4].copy_from_slice(&[red, green, blue, u8::MAX]);
    }

    pub(super) fn encode(&self) -> Result<Vec<u8>, String> {
        self.pixels.encode_png().map_err(|e| e.to_string())
    }
}

/// Why there is no picture.
pub(super) fn picture(detail: &str) -> ExportError {
    ExportError::Picture { detail: detail.to_owned() }
}

fn path<'a>(lines: impl IntoIterator<Item = &'a [Pixel]>, closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for points in lines {
        let Some((&(x, y), rest)) = points.split_first() else {
            continue;
        };
        builder.move_to(x, y);
        for &(x, y) in rest {
            builder.line_to(x, y);
        }
        if closed {
            builder.close();
        }
    }
    builder.finish()
}
