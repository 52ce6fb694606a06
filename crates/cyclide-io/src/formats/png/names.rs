//! What pictures call the objects of a model.

use super::lettering::{self, Drawable};
use crate::export::job::Job;

/// The names of the objects as pictures show them.
pub(super) struct Names {
    /// Empty for what is no part of pictures.
    pub(super) drawn: Vec<String>,
    /// Which objects are shown by other names, as notes of the file.
    pub(super) notes: Vec<String>,
}

impl Names {
    /// Names in letters that can be drawn, else `object 3`, the third of the model.
    pub(super) fn new(job: &Job<'_>) -> Self {
        let mut notes = Vec::new();
        let mut shown = |(index, item): (usize, &cyclide::model::Item)| {
            if item.motion().is_some() {
                return String::new();
            }
            let Some(Drawable { text, lost }) = lettering::drawable(&item.name) else {
                let other = format!("object {}", index + 1);
                notes.push(format!(
                    "the font of the picture has no glyphs for '{}', which is labeled {other}",
                    item.name
                ));
                return other;
            };
            if !lost.is_empty() {
                notes.push(format!(
                    "the font of the picture has no glyph for '{lost}' in '{}', which is labeled {text}",
                    item.name
                ));
            }
            text
        };
        let drawn = job.model.items.iter().enumerate().map(&mut shown).collect();
        Self { drawn, notes: if job.options.png_plain { Vec::new() } else { notes } }
    }
}
