//! Encodings in which tables come: UTF-8, UTF-16, and Windows-1252, which Latin-1 is a part of.

use std::borrow::Cow;

use crate::text::place::{Diagnostic, Source, decode};

/// A text, and its encoding where that is not UTF-8.
#[derive(Debug)]
pub(crate) struct Decoded<'a> {
    pub(crate) text: Cow<'a, str>,
    /// What the encoding is called.
    pub(crate) encoding: Option<&'static str>,
}

/// The characters of Windows-1252 from 0x80 to 0x9f; 0 where it has none. The others are those of Latin-1.
const WINDOWS: [u16; 32] = [
    0x20AC, 0, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0, 0x017D, 0, 0,
    0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0, 0x017E, 0x0178,
];

/// The text of a table, without a byte-order mark. Bytes that are not UTF-8 are read as Windows-1252: that can only touch names
/// and remarks, since the characters of numbers are the same in all of these.
///
/// # Errors
/// A message with the place of a byte that no such encoding has, or about zero bytes.
pub(crate) fn decode_table<'a>(name: &str, mut bytes: &'a [u8]) -> Result<Decoded<'a>, Box<Diagnostic>> {
    // The mark of DOS at the end of a file.
    while let [rest @ .., 0x1A] = bytes {
        bytes = rest;
    }
    let utf16 = |little: bool, from: usize| {
        let unit = |pair: &[u8]| match pair {
            [a, b] if little => u16::from_le_bytes([*a, *b]),
            [a, b] => u16::from_be_bytes([*a, *b]),
            // A head that was cut in the middle of a character.
            _ => u16::from(b'\n'),
        };
        let units = bytes[from..].chunks(2).map(unit);
        let text = char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect();
        Ok(Decoded { text: Cow::Owned(text), encoding: Some("UTF-16") })
    };
    match bytes {
        [0xFF, 0xFE, ..] => return utf16(true, 2),
        [0xFE, 0xFF, ..] => return utf16(false, 2),
        // Latin letters and digits have zeros between them.
        [first, 0, third, 0, ..] if *first != 0 && *third != 0 => return utf16(true, 0),
        [0, second, 0, fourth, ..] if *second != 0 && *fourth != 0 => return utf16(false, 0),
        _ => {}
    }
    let as_utf8 = decode(name, bytes);
    if as_utf8.is_ok() || bytes.contains(&0) {
        return as_utf8.map(|text| Decoded { text: Cow::Borrowed(text), encoding: None });
    }
    let mut text = String::with_capacity(bytes.len() + bytes.len() / 8);
    for byte in bytes {
        let code = match byte {
            0x80..=0x9F => u32::from(WINDOWS[usize::from(byte - 0x80)]),
            other => u32::from(*other),
        };
        match char::from_u32(code).filter(|_| code != 0) {
            Some(c) => text.push(c),
            None => {
                let at = text.len();
                let message =
                    format!("byte {byte:#04x} is no character of UTF-8 nor of Windows-1252: save the file as UTF-8");
                return Err(Source { name, text: &text }.diagnostic(at..at, "", message));
            }
        }
    }
    Ok(Decoded { text: Cow::Owned(text), encoding: Some("Windows-1252 (Latin-1)") })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(bytes: &[u8]) -> (String, Option<&'static str>) {
        decode_table("t.csv", bytes).map(|found| (found.text.into_owned(), found.encoding)).unwrap()
    }

    #[test]
    fn each_encoding_gives_the_same_text() {
        let text = "N°;Höhe\n1;2,5\n";
        let latin: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        assert_eq!(decoded(text.as_bytes()), (text.to_owned(), None));
        assert_eq!(decoded(&latin).0, text);
        assert_eq!(decoded(b"\x80 \x96").0, "€ –");
        for (mark, units) in [(&[0xFF, 0xFE][..], &little), (&[], &little), (&[0xFE, 0xFF], &big), (&[], &big)] {
            // Without a mark the first two characters have to be ASCII.
            let units = if mark.is_empty() { [&units[4..]].concat() } else { [mark, &units[..]].concat() };
            assert!(text.ends_with(&decoded(&units).0) && decoded(&units).0.len() > 10, "{mark:?}");
        }
        assert_eq!(decoded(b"\xef\xbb\xbfx,y").0, "x,y");
    }

    #[test]
    fn what_is_no_text_is_refused() {
        let error = decode_table("t.csv", b"x,y\n1,\x81\n").unwrap_err();
        assert_eq!((error.line, error.column), (2, 3));
        assert!(decode_table("t.csv", b"\xff\x00\x00\x00\x01").is_err());
    }
}
