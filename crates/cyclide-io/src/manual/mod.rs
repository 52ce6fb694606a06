//! The page of each kind of object, made of the published schema and the starter document: there is no second text.
//!
//! The schema says the fields, their types and what they mean; `ObjectSpec` the groups, the sentence of each kind and the
//! document to start from; the formats say what they hold. Nothing here knows any kind by its name.

mod entries;
mod markdown;
mod phrases;
mod starter;
mod terminal;
mod wrap;

use serde_json::Value;

use crate::document::{ObjectSpec, document_schema};
use entries::{Definitions, Entry};

/// The page of a kind of object.
///
/// ```
/// use cyclide_io::manual::KindPage;
/// let page = KindPage::of("pipe-tee").expect("there is such a kind");
/// assert_eq!((page.word(), page.group()), ("pipe-tee", "Pipes and blends"));
/// assert!(page.to_text().contains("branches (required): list of 1 or more objects"));
/// assert!(page.to_markdown("pipe-tee.png").starts_with("# pipe-tee\n"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct KindPage {
    word: &'static str,
    group: &'static str,
    text: Vec<String>,
    rules: Vec<String>,
    fields: Vec<Entry>,
    types: Vec<Entry>,
    starter: String,
    formats: Vec<String>,
}

impl KindPage {
    /// The page of a kind; `None` if there is no such kind. The starter document is built, to know what formats hold it.
    #[must_use]
    pub fn of(word: &str) -> Option<Self> {
        let (group, word) = group_and_word(word)?;
        let schema: Value = serde_json::from_str(&document_schema()).ok()?;
        let definitions = Definitions::of(&schema)?;
        let (object, _) = definitions.object(word)?;
        let page = definitions.page(object);
        let document = ObjectSpec::starter(word)?;
        Some(Self {
            word,
            group,
            text: page.text,
            rules: page.rules,
            fields: page.entries,
            types: page.types,
            starter: starter::shortened(document),
            formats: starter::formats(word, document),
        })
    }

    /// The word of the kind.
    #[must_use]
    pub const fn word(&self) -> &'static str {
        self.word
    }

    /// The group of kinds that it belongs to.
    #[must_use]
    pub const fn group(&self) -> &'static str {
        self.group
    }

    /// The page as plain text for a terminal, at most 100 characters wide.
    #[must_use]
    pub fn to_text(&self) -> String {
        terminal::page(self)
    }

    /// The page as Markdown, with lines of at most 160 characters; `picture` is the path of its picture from the page, empty if
    /// there is none.
    #[must_use]
    pub fn to_markdown(&self, picture: &str) -> String {
        markdown::page(self, picture)
    }

    /// A list of all kinds by group, a sentence each, as plain text for a terminal.
    ///
    /// ```
    /// assert!(cyclide_io::manual::KindPage::list().contains("\n  circle "));
    /// ```
    #[must_use]
    pub fn list() -> String {
        terminal::list(&groups())
    }

    /// The list as Markdown, each kind with a link to its page `KIND.md`.
    ///
    /// ```
    /// assert!(cyclide_io::manual::KindPage::index().contains("- [`circle`](circle.md): A full circle.\n"));
    /// ```
    #[must_use]
    pub fn index() -> String {
        markdown::index(&groups())
    }
}

/// A group of kinds: its name, and the words of its kinds with their sentences.
type Group = (&'static str, Vec<(&'static str, String)>);

/// All kinds with their sentences.
fn groups() -> Vec<Group> {
    let schema: Value = serde_json::from_str(&document_schema()).unwrap_or_default();
    let definitions = Definitions::of(&schema);
    let sentence = |word: &str| definitions.as_ref().and_then(|all| all.object(word)).map_or(String::new(), |it| it.1);
    let kinds = |words: &[&'static str]| words.iter().map(|word| (*word, sentence(word))).collect();
    ObjectSpec::GROUPS.iter().map(|(name, words)| (*name, kinds(words))).collect()
}

/// The group of a kind, and the kind's word.
fn group_and_word(word: &str) -> Option<(&'static str, &'static str)> {
    ObjectSpec::GROUPS.iter().find_map(|(group, words)| Some((*group, *words.iter().find(|own| **own == word)?)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_a_page_of_short_lines() {
        assert_eq!(KindPage::of("teapot"), None);
        for word in ObjectSpec::TYPES {
            let page = KindPage::of(word).unwrap();
            assert!(!page.text.is_empty() && !page.fields.is_empty(), "{word}");
            let (text, markdown) = (page.to_text(), page.to_markdown("a.png"));
            for (limit, line) in text.lines().map(|line| (100, line)).chain(markdown.lines().map(|line| (160, line))) {
                assert!(line.chars().count() <= limit, "{word}: {line}");
            }
            let said: Vec<&Entry> = page.fields.iter().chain(&page.types).collect();
            assert!(said.iter().all(|entry| !entry.label.is_empty() && !entry.text.is_empty()), "{word}: {said:?}");
        }
    }

    #[test]
    fn formats_are_those_that_hold_what_the_starter_makes() {
        let formats = |word| KindPage::of(word).unwrap().formats;
        assert!(
            formats("circle").iter().any(|suffix| suffix == ".dxf")
                && !formats("circle").iter().any(|suffix| suffix == ".stl")
        );
        assert!(
            formats("pipe").iter().any(|suffix| suffix == ".stl")
                && !formats("pipe").iter().any(|suffix| suffix == ".dxf")
        );
        assert!(
            formats("sphere-blend").iter().any(|suffix| suffix == ".glb")
                && !formats("sphere-blend").iter().any(|suffix| suffix == ".step")
        );
        assert_eq!(formats("motion"), [".glb"]);
    }
}
