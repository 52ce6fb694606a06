//! The page of a kind as plain text.

use super::entries::{Entry, Need};
use super::wrap::wrapped;
use super::{Group, KindPage};

/// Widest line.
const WIDTH: usize = 100;

/// Columns by which what is inside is indented.
const STEP: usize = 4;

pub(super) fn page(page: &KindPage) -> String {
    let intro = format!("{}: {}", page.word, page.text.join("\n\n"));
    let rules = page.rules.iter().map(|rule| paragraph(rule, 0)).collect::<String>();
    let mut text = intro.split("\n\n").map(|text| paragraph(text, 0)).collect::<Vec<_>>().join("\n");
    text += "\nFields\n";
    text += &rules;
    text += &entries(&page.fields, STEP / 2);
    if !page.types.is_empty() {
        text += "\nTypes\n";
        text += &entries(&page.types, STEP / 2);
    }
    if !page.formats.is_empty() {
        text += "\nFormats\n";
        text += &paragraph(&page.formats.join(" "), STEP / 2);
    }
    text += &format!("\nDocument ('cyclide new {}' prints it with comments)\n", page.word);
    text += &page.starter.lines().map(|line| format!("  {line}\n")).collect::<String>();
    text
}

/// The kinds by group.
pub(super) fn list(groups: &[Group]) -> String {
    let width = groups.iter().flat_map(|(_, kinds)| kinds).map(|(word, _)| word.len()).max().unwrap_or(0);
    let kind = |(word, sentence): &(&str, String)| {
        wrapped(sentence, &format!("  {word:width$}  "), &" ".repeat(width + 4), WIDTH)
    };
    let group = |(name, kinds): &Group| format!("{name}:\n{}", kinds.iter().map(kind).collect::<String>());
    groups.iter().map(group).collect::<Vec<_>>().join("\n")
}

fn entries(entries: &[Entry], indent: usize) -> String {
    entries.iter().map(|entry| one(entry, indent)).collect()
}

/// An entry: its name, need and type on a line, what is said of it below. Words have all on one line.
fn one(entry: &Entry, indent: usize) -> String {
    let inside = entries_of(entry, indent);
    let label = entry.label.replace('`', "");
    if entry.kind.is_empty() {
        let (first, rest) = (" ".repeat(indent), " ".repeat(indent + STEP));
        return wrapped(&format!("{label}: {}", entry.text), &first, &rest, WIDTH) + &inside;
    }
    let need = match &entry.need {
        Need::Required => " (required)".to_owned(),
        Need::Optional => " (optional)".to_owned(),
        Need::AsSaid => String::new(),
        Need::Default(value) => format!(" (default {value})"),
    };
    let head = format!("{label}{need}: {}", entry.kind.replace('`', ""));
    wrapped(&head, &" ".repeat(indent), &" ".repeat(indent + STEP), WIDTH)
        + &paragraph(&entry.text, indent + STEP)
        + &inside
}

fn entries_of(entry: &Entry, indent: usize) -> String {
    entries(&entry.entries, indent + STEP)
}

fn paragraph(text: &str, indent: usize) -> String {
    let indent = " ".repeat(indent);
    if text.is_empty() { String::new() } else { wrapped(text, &indent, &indent, WIDTH) }
}
