//! Texts broken into lines.

/// A text in lines of at most `width` characters; the first begins with `first`, the others with `rest`. Words in backquotes
/// stay whole, and so do words that are longer than a line.
pub(super) fn wrapped(text: &str, first: &str, rest: &str, width: usize) -> String {
    let mut lines = String::from(first);
    let mut used = first.chars().count();
    let mut empty = true;
    for word in words(text) {
        let long = word.chars().count();
        if !empty && used + 1 + long > width {
            lines.push('\n');
            lines.push_str(rest);
            (used, empty) = (rest.chars().count(), true);
        }
        if !empty {
            lines.push(' ');
            used += 1;
        }
        lines.push_str(word);
        (used, empty) = (used + long, false);
    }
    lines.truncate(lines.trim_end().len());
    lines + "\n"
}

/// The words between blanks that are not in backquotes.
fn words(text: &str) -> Vec<&str> {
    let (mut quoted, mut start, mut found) = (false, 0, Vec::new());
    for (at, c) in text.char_indices() {
        quoted ^= c == '`';
        if c.is_whitespace() && !quoted {
            found.push(&text[start..at]);
            start = at + c.len_utf8();
        }
    }
    found.push(&text[start..]);
    found.retain(|word| !word.is_empty());
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_between_words_and_not_in_code() {
        assert_eq!(wrapped("one two three", "- ", "  ", 9), "- one two\n  three\n");
        assert_eq!(wrapped("of `[a, b, c]` it", "", "", 8), "of\n`[a, b, c]`\nit\n");
        assert_eq!(wrapped("", "  ", "", 9), "\n");
    }
}
