//! What no document holds: refused before it is parsed, in one pass over its bytes.

use crate::text::number::{NEARER_TO_ZERO, vanishes};
use crate::text::place::{Diagnostic, Source, quoted};

/// Longest number that is read, in bytes; 1,100 digits hold any double exactly.
const LONGEST_NUMBER: usize = 2048;

/// Longest string that is read, in bytes: names, paths, paragraphs of comments.
const LONGEST_STRING: usize = 65_536;

/// Lists and objects stand in each other this deep at most; what is made of them has a tenth.
const DEEPEST: usize = 64;

/// Refuses numbers and strings that are too long, and lists that are too deep. Texts that are no JSON may pass.
pub(super) fn check_limits(source: Source<'_>) -> Result<(), Box<Diagnostic>> {
    let bytes = source.text.as_bytes();
    let refused = |at: usize, message: String| Err(source.diagnostic(at..at + 1, "", message));
    let (mut at, mut depth) = (0, 0_usize);
    while let Some(byte) = bytes.get(at) {
        let start = at;
        match byte {
            b'"' => {
                at = end_of_string(bytes, start);
                if at - start > LONGEST_STRING {
                    return refused(start, format!("the string is longer than {LONGEST_STRING} bytes"));
                }
            }
            b'[' | b'{' => {
                depth += 1;
                at += 1;
                if depth > DEEPEST {
                    return refused(start, format!("lists and objects are nested more than {DEEPEST} levels deep"));
                }
            }
            b']' | b'}' => {
                depth = depth.saturating_sub(1);
                at += 1;
            }
            b',' | b':' | b' ' | b'\t' | b'\n' | b'\r' => at += 1,
            _ => {
                at = start + word_length(&bytes[start..]);
                if at - start > LONGEST_NUMBER {
                    return refused(start, format!("the number or word is longer than {LONGEST_NUMBER} bytes"));
                }
                let word = &source.text[start..at];
                // Only these can: the others need not be parsed twice.
                let small = at - start > f64::DIGITS as usize && word.starts_with(['0', '-'])
                    || word.contains("e-")
                    || word.contains("E-");
                if small && word.parse().is_ok_and(|value| vanishes(word, value)) {
                    return Err(source.diagnostic(start..at, "", format!("`{}` {NEARER_TO_ZERO}", quoted(word))));
                }
            }
        }
    }
    Ok(())
}

/// The place behind the quote that ends a string, or where it is too long.
fn end_of_string(bytes: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while at <= start + LONGEST_STRING {
        match bytes.get(at) {
            None => return bytes.len(),
            Some(b'"') => return at + 1,
            Some(b'\\') => at += 2,
            Some(_) => at += 1,
        }
    }
    at
}

/// Length of what is neither string nor punctuation.
fn word_length(bytes: &[u8]) -> usize {
    let ends = |byte: &u8| b"\"[]{},: \t\n\r".contains(byte);
    bytes.iter().take(LONGEST_NUMBER + 1).position(ends).unwrap_or(bytes.len().min(LONGEST_NUMBER + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str) -> Result<(), String> {
        check_limits(Source { name: "m.json", text }).map_err(|d| d.to_string())
    }

    #[test]
    fn what_a_document_holds_passes() {
        for text in [
            String::new(),
            r#"{"a \" [[[": [1, -2.5e-3, true], "b": "\\"}"#.to_owned(),
            format!("[\"{}\"]", "x".repeat(LONGEST_STRING - 2)),
            format!("[0.{}]", "1".repeat(LONGEST_NUMBER - 2)),
            format!("{}{}", "[".repeat(DEEPEST), "]".repeat(DEEPEST)),
            "[[0,1],[2,3]]".repeat(10_000),
            "[0e-400, -0.0, 5e-324, \"1e-400\", 0.00000000000000000000000001]".to_owned(),
            // No JSON, which the parser says.
            "\"".to_owned(),
            "]]]\"\\".to_owned(),
        ] {
            assert_eq!(check(&text), Ok(()), "{:.60}", text);
        }
    }

    #[test]
    fn what_none_holds_is_refused_at_its_place() {
        for (text, message) in [
            ("7".repeat(30_000_000), "m.json:1:1: the number or word is longer than 2048 bytes"),
            (format!("[\n \"{}\"]", "x y".repeat(10_000_000)), "m.json:2:2: the string is longer than 65536 bytes"),
            ("[0, 1e-400]".to_owned(), "m.json:1:5: `1e-400` is nearer to 0 than any number that can be read"),
            (format!("[-0.{}1]", "0".repeat(400)), "m.json:1:2: `-0.0000"),
            (format!("[\"{}", "\\".repeat(10_000_000)), "m.json:1:2: the string is longer"),
            ("[".repeat(10_000_000), "m.json:1:65: lists and objects are nested more than 64 levels deep"),
            ("{\"a\":".repeat(1_000_000), "m.json:1:321: lists and objects"),
        ] {
            let error = check(&text).unwrap_err();
            assert!(error.starts_with(message) && error.len() < 400, "{error}");
        }
    }
}
