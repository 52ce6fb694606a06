//! Lines of a text: `\n`, `\r\n` and a lone `\r` end one.

/// The lines of a text, without their ends, with their byte offsets.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let bytes = text.as_bytes();
    let mut at = 0;
    std::iter::from_fn(move || {
        if at >= bytes.len() {
            return None;
        }
        let start = at;
        let ends = |byte: &u8| matches!(byte, b'\n' | b'\r');
        let end = bytes[start..].iter().position(ends).map_or(bytes.len(), |i| start + i);
        let pair = bytes.get(end) == Some(&b'\r') && bytes.get(end + 1) == Some(&b'\n');
        at = end + if pair { 2 } else { 1 };
        Some((start, &text[start..end]))
    })
}

/// A name as it stands on a line of its own: nothing in it ends the line.
pub(crate) fn on_a_line(name: &str) -> String {
    let name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    name.trim().to_owned()
}

/// Printable ASCII, a `?` for every other byte.
pub(crate) fn printable(text: &str) -> String {
    text.bytes().map(|b| if (0x20..0x7F).contains(&b) { char::from(b) } else { '?' }).collect()
}

/// Number of line ends in a text. A `\r` at its end counts.
pub(crate) fn line_ends(text: &str) -> usize {
    let bytes = text.as_bytes();
    let feeds = bytes.iter().filter(|byte| **byte == b'\n').count();
    let lone = |(at, byte): (usize, &u8)| *byte == b'\r' && bytes.get(at + 1) != Some(&b'\n');
    feeds + bytes.iter().enumerate().filter(|&entry| lone(entry)).count()
}

/// Where the lines of a text start, so that the line of many places is found without reading the text again each time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct LineStarts(Vec<usize>);

impl LineStarts {
    pub(crate) fn new(text: &str) -> Self {
        Self(lines(text).map(|(start, _)| start).collect())
    }

    /// Line of a byte offset, from 1.
    pub(crate) fn line_of(&self, offset: usize) -> usize {
        self.0.partition_point(|start| *start <= offset).max(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_line_end() {
        let text = "a\nb\r\nc\rd\n\n\re";
        let all: Vec<_> = lines(text).collect();
        assert_eq!(all, [(0, "a"), (2, "b"), (5, "c"), (7, "d"), (9, ""), (10, ""), (11, "e")]);
        assert_eq!(line_ends(text), 6);
        assert_eq!((lines("").count(), lines("a\n").count(), line_ends("a\r")), (0, 1, 1));
        let starts = LineStarts::new(text);
        for (number, (start, line)) in lines(text).enumerate() {
            assert_eq!(starts.line_of(start), number + 1);
            assert_eq!(starts.line_of(start + line.len()), number + 1);
        }
        assert_eq!(LineStarts::new("").line_of(7), 1);
    }
}
