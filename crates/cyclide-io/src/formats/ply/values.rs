//! The values of a PLY file, one after the other.

use super::header::Kind;
use crate::text::place::quoted;

/// Values in the order of the file.
pub(super) trait Values {
    /// The next number.
    fn number(&mut self, kind: Kind) -> Result<f64, String>;

    /// The next number, which is a count or an index.
    fn count(&mut self, kind: Kind) -> Result<usize, String>;

    /// Bytes that have not been read.
    fn left(&self) -> usize;

    /// The byte at which the last value begins.
    fn place(&self) -> usize;
}

const END: &str = "the file ends before its last value";

/// Words between white space.
pub(super) struct Text<'a> {
    text: &'a str,
    at: usize,
    last: usize,
}

impl<'a> Text<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, at: 0, last: 0 }
    }

    fn word(&mut self) -> Result<&'a str, String> {
        let rest = &self.text[self.at..];
        let begin = rest.find(|c: char| !c.is_ascii_whitespace()).ok_or(END)?;
        let word = &rest[begin..];
        let word = &word[..word.find(|c: char| c.is_ascii_whitespace()).unwrap_or(word.len())];
        self.last = self.at + begin;
        self.at = self.last + word.len();
        Ok(word)
    }
}

impl Values for Text<'_> {
    fn number(&mut self, _kind: Kind) -> Result<f64, String> {
        let word = self.word()?;
        word.parse().map_err(|_| format!("`{}` is not a number", quoted(word)))
    }

    fn count(&mut self, _kind: Kind) -> Result<usize, String> {
        let word = self.word()?;
        word.parse().map_err(|_| format!("`{}` is not a non-negative integer", quoted(word)))
    }

    fn left(&self) -> usize {
        self.text.len() - self.at
    }

    fn place(&self) -> usize {
        self.last
    }
}

/// Bytes of the types that the head names.
pub(super) struct Binary<'a> {
    bytes: &'a [u8],
    big_endian: bool,
    at: usize,
    last: usize,
}

impl<'a> Binary<'a> {
    pub(super) fn new(bytes: &'a [u8], big_endian: bool) -> Self {
        Self { bytes, big_endian, at: 0, last: 0 }
    }

    /// The next bytes, the lowest first.
    fn take<const N: usize>(&mut self) -> Result<[u8; N], String> {
        let mut bytes: [u8; N] = *self.bytes[self.at..].first_chunk().ok_or(END)?;
        self.last = self.at;
        self.at += N;
        if self.big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

impl Values for Binary<'_> {
    fn number(&mut self, kind: Kind) -> Result<f64, String> {
        Ok(match kind {
            Kind::I8 => i8::from_le_bytes(self.take()?).into(),
            Kind::U8 => u8::from_le_bytes(self.take()?).into(),
            Kind::I16 => i16::from_le_bytes(self.take()?).into(),
            Kind::U16 => u16::from_le_bytes(self.take()?).into(),
            Kind::I32 => i32::from_le_bytes(self.take()?).into(),
            Kind::U32 => u32::from_le_bytes(self.take()?).into(),
            Kind::F32 => f32::from_le_bytes(self.take()?).into(),
            Kind::F64 => f64::from_le_bytes(self.take()?),
        })
    }

    fn count(&mut self, kind: Kind) -> Result<usize, String> {
        let number = self.number(kind)?;
        // Of 32 bits: every whole one is exact.
        if kind.is_whole() && number >= 0.0 {
            return Ok(number as usize);
        }
        Err(format!("`{number}` is not a non-negative integer"))
    }

    fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    fn place(&self) -> usize {
        self.last
    }
}
