//! Fields of comma-separated tables.

use std::borrow::Cow;

/// A text as a field in quotes, on one line.
pub(crate) fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\"").replace(['\n', '\r'], " "))
}

/// A text as a field, in quotes where it needs them.
pub(crate) fn field(text: &str) -> Cow<'_, str> {
    let plain = !text.contains([',', '"', '\n', '\r']) && text.trim() == text;
    if plain { Cow::Borrowed(text) } else { Cow::Owned(quoted(text)) }
}

/// The fields of a line that [`field`] and numbers were written into.
pub(crate) fn fields(line: &str) -> Vec<String> {
    let (mut found, mut quotes) = (vec![String::new()], false);
    let mut letters = line.chars().peekable();
    while let Some(c) = letters.next() {
        let Some(last) = found.last_mut() else { break };
        match c {
            '"' if quotes && letters.peek() == Some(&'"') => {
                letters.next();
                last.push('"');
            }
            '"' => quotes = !quotes,
            ',' if !quotes => found.push(String::new()),
            c => last.push(c),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_read_as_they_were_written() {
        let texts = ["roof", "a,b", "say \"x\"", "", " blank", "ü"];
        let line = texts.map(|text| field(text).into_owned()).join(",");
        assert_eq!(line, "roof,\"a,b\",\"say \"\"x\"\"\",,\" blank\",ü");
        assert_eq!(fields(&line), texts);
    }
}
