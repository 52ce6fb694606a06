//! The arrays of a VTU file, as numbers in digits or appended as base64.

use crate::export::options::VtuEncoding;
use crate::text::number::push_plain;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

/// Length of a point with its weight in digits, about: a text that grows is twice there while it moves.
const POINT: usize = 110;

/// The type of the numbers of an array.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Number {
    Float64,
    Int64,
    Int32,
    UInt8,
}

impl Number {
    const ALL: [Self; 4] = [Self::Float64, Self::Int64, Self::Int32, Self::UInt8];

    pub(super) const fn word(self) -> &'static str {
        match self {
            Self::Float64 => "Float64",
            Self::Int64 => "Int64",
            Self::Int32 => "Int32",
            Self::UInt8 => "UInt8",
        }
    }

    pub(super) fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|number| number.word() == word)
    }

    const fn bytes(self) -> usize {
        match self {
            Self::Float64 | Self::Int64 => 8,
            Self::Int32 => 4,
            Self::UInt8 => 1,
        }
    }

    fn push(self, bytes: &mut Vec<u8>, value: f64) {
        match self {
            Self::Float64 => bytes.extend(value.to_le_bytes()),
            Self::Int64 => bytes.extend((value as i64).to_le_bytes()),
            Self::Int32 => bytes.extend((value as i32).to_le_bytes()),
            Self::UInt8 => bytes.push(value as u8),
        }
    }

    /// The numbers of these bytes; `None` where some are left over.
    pub(super) fn values(self, bytes: &[u8]) -> Option<Vec<f64>> {
        let one = |own: &[u8]| {
            Some(match self {
                Self::Float64 => f64::from_le_bytes(own.try_into().ok()?),
                Self::Int64 => i64::from_le_bytes(own.try_into().ok()?) as f64,
                Self::Int32 => f64::from(i32::from_le_bytes(own.try_into().ok()?)),
                Self::UInt8 => f64::from(*own.first()?),
            })
        };
        bytes.chunks(self.bytes()).map(one).collect()
    }
}

/// The arrays that are being written.
pub(super) struct Arrays {
    encoding: VtuEncoding,
    /// What is appended so far.
    appended: String,
}

impl Arrays {
    pub(super) fn new(encoding: VtuEncoding) -> Self {
        Self { encoding, appended: String::new() }
    }

    /// Length of the text before what is appended, for so many nodes, about.
    pub(super) fn text_of(&self, points: usize) -> usize {
        if self.encoding == VtuEncoding::Ascii { points * POINT } else { 0 }
    }

    /// Adds an array.
    pub(super) fn push(
        &mut self,
        out: &mut String,
        number: Number,
        name: &str,
        components: usize,
        values: impl Iterator<Item = f64>,
    ) {
        let kind = number.word();
        out.push_str(&format!("<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" "));
        match self.encoding {
            VtuEncoding::Ascii => {
                out.push_str("format=\"ascii\">");
                for (k, value) in values.enumerate() {
                    out.push(if k % (4 * components.max(3)) == 0 { '\n' } else { ' ' });
                    push_plain(out, value);
                }
                out.push_str("\n</DataArray>\n");
            }
            VtuEncoding::Base64 => {
                out.push_str(&format!("format=\"appended\" offset=\"{}\"/>\n", self.appended.len()));
                // The number of bytes, then these, in one text.
                let mut bytes = vec![0; HEADER];
                values.for_each(|value| number.push(&mut bytes, value));
                let count = (bytes.len() - HEADER) as u64;
                bytes[..HEADER].copy_from_slice(&count.to_le_bytes());
                STANDARD.encode_string(&bytes, &mut self.appended);
            }
        }
    }

    /// The bytes of the file.
    pub(super) fn finish(self, mut out: String) -> Vec<u8> {
        if self.encoding == VtuEncoding::Base64 {
            out.push_str("<AppendedData encoding=\"base64\">\n_");
            out.push_str(&self.appended);
            out.push_str("\n</AppendedData>\n");
        }
        out.push_str("</VTKFile>\n");
        out.into_bytes()
    }
}

/// Bytes of the number of bytes.
const HEADER: usize = 8;

/// The bytes of an array that begins a text; `None` if it is none.
pub(super) fn appended(text: &str) -> Option<Vec<u8>> {
    // Twelve letters have the number of bytes.
    let head = STANDARD.decode(text.get(..base64::encoded_len(HEADER, true)?)?).ok()?;
    let count = u64::from_le_bytes(*head.first_chunk()?);
    let bytes = usize::try_from(count).ok()?.checked_add(HEADER).filter(|bytes| *bytes <= text.len())?;
    let whole = base64::encoded_len(bytes, true)?;
    let bytes = STANDARD.decode(text.get(..whole)?).ok()?;
    let (_, own) = bytes.split_at_checked(HEADER)?;
    (own.len() as u64 == count).then(|| own.to_vec())
}

/// Strings are lists of their bytes, each with a zero at its end.
pub(super) fn push_strings(out: &mut String, name: &str, strings: &[&str]) {
    out.push_str(&format!(
        "<DataArray type=\"String\" Name=\"{name}\" NumberOfTuples=\"{}\" format=\"ascii\">",
        strings.len()
    ));
    for string in strings {
        out.push('\n');
        string.bytes().for_each(|byte| out.push_str(&format!("{byte} ")));
        out.push('0');
    }
    out.push_str("\n</DataArray>\n");
}
