//! The objects that an object is made from.

use crate::document::locate::Step;
use crate::document::objects::{Builder, BuiltObject};
use crate::error::{Error, Result};

impl Builder<'_> {
    /// The source, which must have surfaces.
    pub(in crate::document) fn surface_source(&self, needed: &str) -> Result<&BuiltObject> {
        match self.sources.first() {
            Some(source) if !source.item.surfaces().is_empty() => Ok(source),
            _ => Err(self.wrong_source(needed)),
        }
    }

    /// Whether what it is made from is curves.
    pub(in crate::document) fn is_of_curves(&self) -> bool {
        self.sources.first().is_some_and(|source| !source.item.curves().is_empty())
    }

    /// The message that the source is of the wrong kind.
    pub(in crate::document) fn wrong_source(&self, needed: &str) -> Error {
        self.wrong_source_at([Step::from("of")], needed)
    }

    /// The same, at what asks for another kind.
    pub(in crate::document) fn wrong_source_at(&self, place: impl IntoIterator<Item = Step>, needed: &str) -> Error {
        let source = self.sources.first().map(|s| format!("`{}` is of type `{}`", s.item.name, s.provenance.kind));
        let message = format!("{}: {needed}", source.unwrap_or_default());
        Error::Input(self.diagnostic(place, &message))
    }
}
