//! From a path inside a document to its place in the text, and back.
//!
//! The text is parsed again, one level per step and without building values: this happens only when a message is
//! about to be shown.

use std::borrow::Cow;
use std::fmt::{self, Write as _};
use std::ops::Range;

use serde::Deserialize;
use serde::de::{Deserializer, Error as _, MapAccess, Visitor};
use serde_json::value::RawValue;

use crate::text::place::quoted;

/// One step of a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Step {
    Key(String),
    Index(usize),
}

impl From<&str> for Step {
    fn from(key: &str) -> Self {
        Self::Key(key.to_owned())
    }
}

impl From<usize> for Step {
    fn from(index: usize) -> Self {
        Self::Index(index)
    }
}

/// A path as messages show it: `objects.track.points[3]`, names that are no plain words in brackets and quotes.
pub(super) fn path_text(steps: &[Step]) -> String {
    let mut out = String::new();
    for step in steps {
        let _never_fails = match step {
            Step::Index(i) => write!(out, "[{i}]"),
            Step::Key(k) if !k.is_empty() && k.chars().all(|c| c.is_alphanumeric() || "_-$".contains(c)) => {
                write!(out, "{}{}", if out.is_empty() { "" } else { "." }, quoted(k))
            }
            Step::Key(k) => write!(out, "[{:?}]", quoted(k)),
        };
    }
    out
}

/// The entries of a JSON object in their order, as raw text; a repeated name is an error.
#[derive(Debug, Default)]
pub(super) struct Entries<'a>(pub(super) Vec<(Cow<'a, str>, &'a RawValue)>);

impl<'de: 'a, 'a> Deserialize<'de> for Entries<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct EntriesVisitor;
        impl<'de> Visitor<'de> for EntriesVisitor {
            type Value = Entries<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object `{…}`")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut entries: Vec<(Cow<'de, str>, &'de RawValue)> = Vec::new();
                let mut names = std::collections::HashSet::new();
                while let Some(Name(name)) = map.next_key()? {
                    if !names.insert(name.clone()) {
                        return Err(A::Error::custom(format!("the name `{name}` is used twice")));
                    }
                    entries.push((name, map.next_value()?));
                }
                Ok(Entries(entries))
            }
        }
        deserializer.deserialize_map(EntriesVisitor)
    }
}

/// A key, borrowed where it holds no escapes.
#[derive(Deserialize)]
struct Name<'a>(#[serde(borrow)] Cow<'a, str>);

/// The members of a JSON object or array with their steps; `None` for anything else.
fn members(text: &str) -> Option<Vec<(Step, &str)>> {
    match text.as_bytes().first() {
        Some(b'{') => {
            let Entries(entries) = serde_json::from_str(text).ok()?;
            Some(entries.into_iter().map(|(name, raw)| (Step::Key(name.into_owned()), raw.get())).collect())
        }
        Some(b'[') => {
            let items: Vec<&RawValue> = serde_json::from_str(text).ok()?;
            Some(items.into_iter().enumerate().map(|(i, raw)| (Step::Index(i), raw.get())).collect())
        }
        _ => None,
    }
}

/// Byte offset of a part of a text in that text.
pub(super) fn offset_in(text: &str, part: &str) -> usize {
    (part.as_ptr() as usize).saturating_sub(text.as_ptr() as usize).min(text.len())
}

/// Byte range of the value at a path; `None` if the text has no such value.
pub(super) fn span_of(text: &str, steps: &[Step]) -> Option<Range<usize>> {
    let mut value = text.trim();
    for step in steps {
        value = members(value)?.into_iter().find(|(s, _)| s == step)?.1;
    }
    let start = offset_in(text, value);
    Some(start..start + value.len())
}

/// The innermost value around a byte offset and its path, searched from the value at `from`.
pub(super) fn value_at(text: &str, from: &[Step], offset: usize) -> (Vec<Step>, Range<usize>) {
    let mut steps = from.to_vec();
    let mut span = span_of(text, from).unwrap_or(0..text.len());
    let around = |part: &str| {
        let start = offset_in(text, part);
        start <= offset && offset <= start + part.len()
    };
    while let Some((step, part)) =
        members(&text[span.clone()]).and_then(|all| all.into_iter().find(|(_, part)| around(part)))
    {
        steps.push(step);
        let start = offset_in(text, part);
        span = start..start + part.len();
    }
    (steps, span)
}

/// The innermost list or object around a byte offset that is behind one of its members, or behind the first byte of the
/// member that follows (the parser has looked at it); searched from the value at `from`.
pub(super) fn members_around(text: &str, from: &[Step], offset: usize) -> Option<Members> {
    let mut steps = from.to_vec();
    let mut span = span_of(text, from)?;
    loop {
        let members = members(&text[span.clone()])?;
        let start = |part: &str| offset_in(text, part);
        match members.iter().find(|(_, part)| start(part) + 1 < offset && offset < start(part) + part.len()) {
            Some((step, part)) => {
                steps.push(step.clone());
                span = start(part)..start(part) + part.len();
            }
            None => {
                let before = members.iter().filter(|(_, part)| start(part) + part.len() < offset).count();
                let is_list = text[span.clone()].starts_with('[');
                return Some(Members { steps, span, before, count: members.len(), is_list });
            }
        }
    }
}

/// What [`members_around`] finds.
pub(super) struct Members {
    pub(super) steps: Vec<Step>,
    pub(super) span: Range<usize>,
    /// Members that end before the offset.
    pub(super) before: usize,
    /// All members.
    pub(super) count: usize,
    pub(super) is_list: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#" { "objects": { "a b": { "points": [ [0, 1], [2, 3.5] ] }, "é\n": 7 } }"#;

    fn at(steps: &[Step]) -> Option<&'static str> {
        span_of(TEXT, steps).map(|s| &TEXT[s])
    }

    #[test]
    fn paths_lead_to_their_text_and_back() {
        let path = ["objects".into(), "a b".into(), "points".into(), 1.into(), 1.into()];
        assert_eq!(at(&path), Some("3.5"));
        assert_eq!(path_text(&path), "objects[\"a b\"].points[1][1]");
        let offset = TEXT.find("3.5").unwrap() + 2;
        assert_eq!(value_at(TEXT, &[], offset).0, path);
        assert_eq!(at(&["objects".into(), "é\n".into()]), Some("7"));
        assert_eq!(at(&["objects".into(), "b".into()]), None);
        assert_eq!(at(&[0.into()]), None);
        assert_eq!(value_at(TEXT, &[], 3).0, []);
    }

    #[test]
    fn repeated_names_are_refused() {
        let error = serde_json::from_str::<Entries<'_>>("{\"a\":1,\n\"a\":2}").unwrap_err().to_string();
        assert_eq!(error, "the name `a` is used twice at line 2 column 3");
    }
}
