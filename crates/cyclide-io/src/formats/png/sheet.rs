//! The sheet of a picture: how large it is, and the sizes of what stands on it.

use crate::export::error::ExportError;
use crate::export::job::Job;

/// Width of a picture, pixels: if none is asked for, and least and most.
const WIDTH: f64 = 1600.0;
const WIDTHS: (u32, u32) = (200, 10_000);
const HEIGHTS: (u32, u32) = (150, 10_000);
/// Height over width at most.
const TALLEST: f64 = 0.75;
/// Heights of capitals and distances, pixels of a picture of the usual width.
pub(super) const TEXT: f64 = 15.0;
const MARGIN: f64 = 44.0;
pub(super) const ROW: f64 = 34.0;
/// Part of the footer that belongs to the scale bar.
pub(super) const BAR_ROOM: f64 = 400.0;
/// Objects of a legend of colors. More are named where they stand, or numbered.
pub(super) const MOST_ENTRIES: usize = 6;

/// Sizes on a picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sheet {
    /// Pixels.
    pub(super) width: f64,
    /// Pixels, at most.
    pub(super) height: f64,
    /// True if the height was asked for: then the picture is as high.
    pub(super) fixed: bool,
    /// Pixels of this picture for one of the usual width: widths of lines and heights of letters are multiplied by it.
    pub(super) scale: f64,
}

impl Sheet {
    /// # Errors
    /// A width that makes no picture.
    pub(super) fn new(job: &Job<'_>) -> Result<Self, ExportError> {
        let width = job.options.png_width.unwrap_or(WIDTH as u32);
        if width < WIDTHS.0 || width > WIDTHS.1 {
            let detail = format!("a width of {width} pixels ({} to {} are possible)", WIDTHS.0, WIDTHS.1);
            return Err(ExportError::Picture { detail });
        }
        if let Some(height) = job.options.png_height.filter(|h| *h < HEIGHTS.0 || *h > HEIGHTS.1) {
            let detail = format!("a height of {height} pixels ({} to {} are possible)", HEIGHTS.0, HEIGHTS.1);
            return Err(ExportError::Picture { detail });
        }
        let part = f64::from(width) / WIDTH;
        // Lines and letters of small pictures shrink less, or they could not be read.
        let height = job.options.png_height.map_or((TALLEST * f64::from(width)).round(), f64::from);
        let fixed = job.options.png_height.is_some();
        Ok(Self { width: f64::from(width), height, fixed, scale: if part < 1.0 { part.sqrt() } else { part } })
    }

    pub(super) fn text_size(self) -> f64 {
        TEXT * self.scale
    }

    pub(super) fn margin(self) -> f64 {
        MARGIN * self.scale
    }

    /// Height of the tallest picture.
    pub(super) fn tallest(self) -> f64 {
        self.height
    }
}
