//! DXF text: pairs of a group code and a value, one line each.

use crate::check::read_error::ReadError;
use crate::text::number::push_dxf;
use cyclide::Point3;
use std::fmt::Write as _;

/// A growing DXF text.
#[derive(Default)]
pub(super) struct Tags {
    text: String,
}

impl Tags {
    pub(super) fn append(&mut self, other: Self) {
        self.text.push_str(&other.text);
    }

    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.text.into_bytes()
    }

    fn code(&mut self, code: u16) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "{code:>3}");
    }

    /// Text as it is: ASCII without line breaks.
    pub(super) fn text(&mut self, code: u16, value: &str) -> &mut Self {
        self.code(code);
        self.text.push_str(value);
        self.text.push('\n');
        self
    }

    pub(super) fn int(&mut self, code: u16, value: usize) -> &mut Self {
        self.code(code);
        let _ = writeln!(self.text, "{value}");
        self
    }

    pub(super) fn real(&mut self, code: u16, value: f64) -> &mut Self {
        self.code(code);
        push_dxf(&mut self.text, value);
        self.text.push('\n');
        self
    }

    pub(super) fn reals(&mut self, code: u16, values: &[f64]) -> &mut Self {
        for &v in values {
            self.real(code, v);
        }
        self
    }

    /// A point: codes `code`, `code + 10`, `code + 20`.
    pub(super) fn point(&mut self, code: u16, p: Point3) -> &mut Self {
        self.real(code, p.x).real(code + 10, p.y).real(code + 20, p.z)
    }

    pub(super) fn handle(&mut self, code: u16, value: usize) -> &mut Self {
        self.code(code);
        let _ = writeln!(self.text, "{value:X}");
        self
    }

    /// Several pairs, written as `code value` separated by blanks or line breaks; `_` is the empty text.
    pub(super) fn raw(&mut self, pairs: &str) -> &mut Self {
        let mut words = pairs.split_whitespace();
        while let (Some(code), Some(value)) = (words.next(), words.next()) {
            let value = if value == "_" { "" } else { value };
            let _ = writeln!(self.text, "{code:>3}\n{value}");
        }
        self
    }

    /// The start of a section, table, record or entity, or an end: `0 NAME`.
    pub(super) fn begin(&mut self, name: &str) -> &mut Self {
        self.text(0, name)
    }
}

/// One pair read from a file.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tag<'a> {
    pub(super) code: u16,
    pub(super) value: &'a str,
    /// Line of the code, from 1.
    pub(super) line: usize,
}

impl Tag<'_> {
    pub(super) fn place(&self) -> String {
        format!("line {}", self.line)
    }

    pub(super) fn real(&self) -> Result<f64, ReadError> {
        let v: Option<f64> = self.value.parse().ok().filter(|v: &f64| v.is_finite());
        v.ok_or_else(|| ReadError::syntax(self.place(), format!("'{}' is not a number", self.value)))
    }

    pub(super) fn int(&self) -> Result<usize, ReadError> {
        let v = self.value.parse();
        v.map_err(|_| ReadError::syntax(self.place(), format!("'{}' is not a non-negative integer", self.value)))
    }
}

/// The pairs of a file.
pub(super) fn parse(bytes: &[u8]) -> Result<Vec<Tag<'_>>, ReadError> {
    let text = std::str::from_utf8(bytes).map_err(|e| ReadError::syntax("the text", e.to_string()))?;
    let mut lines = text.lines().enumerate();
    let mut tags = Vec::new();
    while let Some((i, code)) = lines.next() {
        let place = || format!("line {}", i + 1);
        let code = code.trim().parse();
        let code = code.map_err(|_| ReadError::syntax(place(), "expected a group code"))?;
        let (_, value) = lines.next().ok_or_else(|| ReadError::syntax(place(), "a group code without a value"))?;
        tags.push(Tag { code, value: value.trim(), line: i + 1 });
    }
    Ok(tags)
}
