//! Damaged copies of right files.

use cyclide::model::Model;
use cyclide_io::{
    ExportOptions, Format,
    check::ReadError,
    export::Exported,
    formats::{export, file_deviation},
};

/// A right file of a model, of which damaged copies are checked.
pub struct Damage {
    model: Model,
    format: Format,
    pub file: Exported,
}

impl Damage {
    pub fn new(model: Model, format: Format) -> Self {
        Self::with(model, format, &ExportOptions { tolerance: Some(0.1), ..ExportOptions::default() })
    }

    pub fn with(model: Model, format: Format, options: &ExportOptions) -> Self {
        let file = export(&model, format, options).unwrap();
        let deviation = file_deviation(&model, format, &file).unwrap();
        assert!(deviation <= file.bound + 1e-12, "{format:?}: {deviation:e}"); // rounding
        Self { model, format, file }
    }

    pub fn bytes(&self, change: impl FnOnce(&mut Vec<u8>)) -> Result<f64, ReadError> {
        let mut wrong = self.file.clone();
        change(&mut wrong.bytes);
        assert!(wrong.bytes != self.file.bytes, "{:?}: nothing was changed", self.format);
        file_deviation(&self.model, self.format, &wrong)
    }

    /// The message about a text in which some words are exchanged for others, all at once.
    #[track_caller]
    pub fn refused(&self, changes: &[(&str, &str)]) -> String {
        let changed = self.bytes(|bytes| {
            let mut text = String::from_utf8(std::mem::take(bytes)).unwrap();
            for (k, (from, _)) in changes.iter().enumerate() {
                assert!(text.contains(from), "{:?}: there is no {from}", self.format);
                text = text.replace(from, &format!("\u{1}{k}\u{1}"));
            }
            for (k, (_, to)) in changes.iter().enumerate() {
                text = text.replace(&format!("\u{1}{k}\u{1}"), to);
            }
            *bytes = text.into_bytes();
        });
        changed.unwrap_err().to_string()
    }

    /// As [`refused`](Self::refused), in the JSON chunk of GLB.
    #[track_caller]
    pub fn refused_glb(&self, change: impl FnOnce(&mut serde_json::Value)) -> String {
        let changed = self.bytes(|bytes| {
            let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
            let mut json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
            change(&mut json);
            let mut text = json.to_string().into_bytes();
            text.resize(text.len().next_multiple_of(4), b' ');
            let size = |n: usize| u32::try_from(n).unwrap().to_le_bytes();
            let total = bytes.len() - length + text.len();
            let head = [&b"glTF"[..], &2_u32.to_le_bytes(), &size(total), &size(text.len()), b"JSON"].concat();
            *bytes = [&head[..], &text, &bytes[20 + length..]].concat();
        });
        changed.unwrap_err().to_string()
    }

    /// As [`refused`](Self::refused), in a JSON document.
    #[track_caller]
    pub fn refused_json(&self, change: impl FnOnce(&mut serde_json::Value)) -> String {
        let changed = self.bytes(|bytes| {
            let mut json: serde_json::Value = serde_json::from_slice(bytes).unwrap();
            change(&mut json);
            *bytes = json.to_string().into_bytes();
        });
        changed.unwrap_err().to_string()
    }
}
