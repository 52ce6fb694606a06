//! The page of a kind as Markdown.

use super::entries::{Entry, Need};
use super::wrap::wrapped;
use super::{Group, KindPage};

/// Widest line.
const WIDTH: usize = 160;

/// What the pages begin with: they are not written by hand.
const MADE: &str =
    "<!-- Made by `cargo xtask pages` from the doc comments in crates/cyclide-io/src/document/kinds. -->\n";

pub(super) fn page(page: &KindPage, picture: &str) -> String {
    let mut text = format!("# {}\n\n{MADE}\n", page.word)
        + &page.text.iter().map(|text| paragraph(text)).collect::<Vec<_>>().join("\n");
    if !picture.is_empty() {
        text += &format!("\n![the object built from the document below]({picture})\n");
    }
    text += "\n## Fields\n\n";
    if !page.rules.is_empty() {
        text += &paragraph(&page.rules.join(" "));
        text += "\n";
    }
    text += &entries(&page.fields, 0);
    if !page.types.is_empty() {
        text += "\n## Types\n\n";
        text += &entries(&page.types, 0);
    }
    if !page.formats.is_empty() {
        text += "\n## Formats\n\n";
        text += &paragraph(&format!("`{}`: see [what each format carries](../formats.md).", page.formats.join("`, `")));
    }
    text += &format!(
        "\n## Document\n\n`cyclide new {}` prints it with comments.\n\n```json\n{}```\n",
        page.word, page.starter
    );
    text
}

/// The kinds by group, each with a link to its page.
pub(super) fn index(groups: &[Group]) -> String {
    let kind = |(word, sentence): &(&str, String)| item(&format!("[`{word}`]({word}.md): {sentence}"), 0);
    let group = |(name, kinds): &Group| format!("\n## {name}\n\n{}", kinds.iter().map(kind).collect::<String>());
    let intro = "Each page lists the fields and has a document to start from, with a picture of the result. `cyclide help KIND` prints \
                 the same page in a terminal. [The model document](../document.md) describes what all documents share.";
    let head = format!("# Kinds of object\n\n{MADE}\n") + &paragraph(intro);
    head + &groups.iter().map(group).collect::<String>()
}

fn entries(entries: &[Entry], level: usize) -> String {
    entries.iter().map(|entry| one(entry, level)).collect()
}

fn one(entry: &Entry, level: usize) -> String {
    let code = |text: &str| if text.contains('`') { text.to_owned() } else { format!("`{text}`") };
    // Fields are code, types are named in words.
    let is_field = !entry.label.contains(' ');
    let label = if is_field { code(&entry.label) } else { entry.label.clone() };
    let need = match &entry.need {
        Need::Required => ", required".to_owned(),
        Need::Optional => ", optional".to_owned(),
        Need::AsSaid => String::new(),
        Need::Default(value) => format!(", default `{value}`"),
    };
    let kind = if entry.kind.is_empty() { String::new() } else { format!(" ({}{need})", entry.kind) };
    let said = if entry.text.is_empty() { String::new() } else { format!(": {}", entry.text) };
    item(&format!("{label}{kind}{said}"), level) + &entries(&entry.entries, level + 1)
}

/// An item of a list.
fn item(text: &str, level: usize) -> String {
    let indent = "  ".repeat(level);
    wrapped(text, &format!("{indent}- "), &format!("{indent}  "), WIDTH)
}

fn paragraph(text: &str) -> String {
    wrapped(text, "", "", WIDTH)
}
