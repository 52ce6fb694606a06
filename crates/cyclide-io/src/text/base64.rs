//! Bytes as text (RFC 4648, section 4), as XML files carry them.

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Length of the text of so many bytes.
pub(crate) const fn text_length(bytes: usize) -> usize {
    bytes.div_ceil(3) * 4
}

/// Adds the text of bytes.
pub(crate) fn push(out: &mut String, bytes: &[u8]) {
    out.reserve(text_length(bytes.len()));
    for three in bytes.chunks(3) {
        let byte = |k: usize| u32::from(three.get(k).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for k in 0..4 {
            let letter = char::from(LETTERS[(bits >> (18 - 6 * k) & 63) as usize]);
            out.push(if k <= three.len() { letter } else { '=' });
        }
    }
}

/// The bytes of a text; `None` if it is none of bytes.
pub(crate) fn bytes_of(text: &str) -> Option<Vec<u8>> {
    let text = text.as_bytes();
    if !text.len().is_multiple_of(4) {
        return None;
    }
    let whole = text.strip_suffix(b"==").or_else(|| text.strip_suffix(b"=")).unwrap_or(text);
    let mut values = [64_u8; 256];
    for (value, letter) in (0_u8..).zip(LETTERS) {
        values[usize::from(*letter)] = value;
    }
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    for four in whole.chunks(4) {
        let mut bits = 0_u32;
        for letter in four {
            let value = values[usize::from(*letter)];
            if value > 63 {
                return None;
            }
            bits = bits << 6 | u32::from(value);
        }
        bits <<= 6 * (4 - four.len());
        bytes.extend(&bits.to_be_bytes()[1..four.len()]);
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_those_of_the_standard() {
        // RFC 4648, section 10.
        for (bytes, text) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")] {
            let mut out = String::new();
            push(&mut out, bytes.as_bytes());
            assert_eq!((out.as_str(), out.len()), (text, text_length(bytes.len())));
            assert_eq!(bytes_of(text).as_deref(), Some(bytes.as_bytes()));
        }
        assert_eq!(
            [bytes_of("Zg="), bytes_of("Z*=="), bytes_of("===="), bytes_of("Z===")].map(|b| b.is_none()),
            [true; 4]
        );
        let all: Vec<u8> = (0..=255).collect();
        let mut out = String::new();
        push(&mut out, &all);
        assert_eq!(bytes_of(&out), Some(all));
    }
}
