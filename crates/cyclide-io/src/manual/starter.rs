//! The document to start from, as a page shows it, and the formats that hold what it makes.

use super::wrap::wrapped;
use crate::document::Document;
use crate::document::ObjectSpec;
use crate::formats::Format;

/// Longest line.
const WIDTH: usize = 96;

/// Lines of numbers after one another that are shown.
const MOST_ROWS: usize = 2;

/// The document without its comments, which say what the page says, and of long lists the first rows.
pub(super) fn shortened(document: &str) -> String {
    let (mut text, mut in_comment, mut rows) = (String::new(), false, 0);
    for line in document.lines() {
        let inner = line.trim();
        if in_comment {
            in_comment = !matches!(inner, "]" | "],");
            continue;
        }
        if inner.starts_with("\"comment\":") {
            in_comment = inner.ends_with('[');
            continue;
        }
        rows = if inner.starts_with('[') { rows + 1 } else { 0 };
        let indent = &line[..line.len() - inner.len()];
        match rows {
            _ if rows <= MOST_ROWS => text += &row(inner, indent),
            _ if rows == MOST_ROWS + 1 => text += &format!("{indent}…\n"),
            _ => {}
        }
    }
    text
}

/// A line, broken between values that are too many for one.
fn row(line: &str, indent: &str) -> String {
    const GLUE: &str = "\u{1}";
    wrapped(&line.replace(": ", &format!(":{GLUE}")), indent, &format!("{indent}  "), WIDTH).replace(GLUE, " ")
}

/// The suffixes of the formats that hold the last object of the kind; none if it cannot be built.
pub(super) fn formats(word: &str, document: &str) -> Vec<String> {
    let document: Result<Document, _> = document.parse();
    let built = document.and_then(|document| Ok((document.build()?, document)));
    let Ok((built, document)) = built else { return Vec::new() };
    let place = document.objects.iter().rposition(|(_, spec)| spec.type_word() == word);
    let Some(object) = place.and_then(|place| built.get(place)) else { return Vec::new() };
    let exact = ObjectSpec::has_exact_form(word);
    let holds = |format: &&Format| format.holds(&object.item.geometry, exact);
    Format::ALL.iter().filter(holds).map(|format| format!(".{}", format.suffix())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_long_lists_are_left_out() {
        let rows = "      [1, 2],\n".repeat(5);
        let document = format!(
            "{{\n  \"comment\": [\n    \"a\",\n    \"b\"\n  ],\n  \"x\": {{\n    \"comment\": [\"c\"],\n    \"y\": [\n{rows}    ]\n  }}\n}}\n"
        );
        let shown = "{\n  \"x\": {\n    \"y\": [\n      [1, 2],\n      [1, 2],\n      …\n    ]\n  }\n}\n";
        assert_eq!(shortened(&document), shown);
    }
}
