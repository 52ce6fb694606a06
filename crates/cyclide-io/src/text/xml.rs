//! Texts in XML.

/// Text of an element or an attribute: markup escaped, characters that XML does not allow replaced.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\u{FFFE}' | '\u{FFFF}' => out.push('\u{FFFD}'),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// The same between double quotes.
pub(crate) fn escaped_in_quotes(text: &str) -> String {
    escaped(text).replace('"', "&quot;")
}

/// The same in a comment, where two dashes cannot follow each other.
pub(crate) fn escaped_in_comment(text: &str) -> String {
    escaped(text).replace("--", "-&#45;")
}

/// The value of an attribute in what stands between the name of a tag and its end.
pub(crate) fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let mut rest = tag;
    loop {
        let (before, after) = rest.split_once("=\"")?;
        let (value, next) = after.split_once('"')?;
        if before.trim_start() == name {
            return Some(value);
        }
        rest = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_is_escaped_where_it_stands() {
        assert_eq!(escaped("<&>\u{1}\""), "&lt;&amp;&gt; \"");
        assert_eq!(escaped_in_quotes("a \"b\" <c>"), "a &quot;b&quot; &lt;c&gt;");
        assert!(!escaped_in_comment("a---b--").contains("--"));
    }

    #[test]
    fn attributes_are_found_by_their_whole_name() {
        let tag = " type=\"b\" id=\"7\" geoid=\"8\"";
        assert_eq!(
            ["id", "geoid", "type", "d"].map(|name| attribute(tag, name)),
            [Some("7"), Some("8"), Some("b"), None]
        );
    }
}
