//! Which objects are made from which others: names found, circles refused, the order of building.

use std::collections::HashMap;

use crate::document::Document;
use crate::document::locate::{Step, path_text, span_of};
use crate::error::{Error, Result};
use crate::text::suggest::did_you_mean;

/// The objects that each object is made from.
pub(in crate::document) struct References {
    of: Vec<Vec<usize>>,
    /// Whether another object is made from each.
    sources: Vec<bool>,
}

/// How far the walk over an object's references has come.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::document) enum State {
    New,
    Begun,
    Done,
}

impl References {
    /// Finds every name.
    ///
    /// # Errors
    /// [`Error::Input`] at a name that no object has, or that leads back to the object itself.
    pub(in crate::document) fn new(document: &Document) -> Result<Self> {
        let names = document.objects.iter().enumerate();
        let indices: HashMap<&str, usize> = names.map(|(i, (name, _))| (name.as_str(), i)).collect();
        let mut of = Vec::with_capacity(document.objects.len());
        for (index, (_, spec)) in document.objects.iter().enumerate() {
            let find = |(place, (_, name)): (usize, (Vec<Step>, &str))| {
                let missing = || {
                    let others = document.objects.iter().map(|(other, _)| other.as_str());
                    let others = others.enumerate().filter(|(i, _)| *i != index).map(|(_, other)| other);
                    let hint = did_you_mean(name, others);
                    refused(document, index, place, &format!("there is no object `{name}`{hint}"))
                };
                indices.get(name).copied().ok_or_else(missing)
            };
            of.push(spec.kind().references().into_iter().enumerate().map(find).collect::<Result<Vec<_>>>()?);
        }
        let mut sources = vec![false; of.len()];
        of.iter().flatten().for_each(|&index: &usize| sources[index] = true);
        let references = Self { of, sources };
        let mut state = vec![State::New; references.of.len()];
        for index in 0..references.of.len() {
            references.walk(index, &mut state, &mut |_| {}).map_err(|(index, place)| {
                let message = format!("`{}` refers to itself", document.objects[index].0);
                refused(document, index, place, &message)
            })?;
        }
        Ok(references)
    }

    /// The objects that an object is made from, in the order of [`Kind::references`](crate::document::kinds::Kind::references).
    pub(in crate::document) fn of(&self, index: usize) -> &[usize] {
        &self.of[index]
    }

    /// True if another object is made from this one.
    pub(in crate::document) fn is_source(&self, index: usize) -> bool {
        self.sources[index]
    }

    /// No object is made.
    pub(in crate::document) fn nothing_made(&self) -> Vec<State> {
        vec![State::New; self.of.len()]
    }

    /// Objects that were not made after all are visited again.
    pub(in crate::document) fn forget(made: &mut [State], is_missing: impl Fn(usize) -> bool) {
        for (index, state) in made.iter_mut().enumerate() {
            if is_missing(index) {
                *state = State::New;
            }
        }
    }

    /// The object and all it needs that is not made yet, each after what it is made from: these count as made then. The
    /// state is that of all objects from call to call, so that a long chain is walked once.
    pub(in crate::document) fn needed_for(&self, index: usize, made: &mut [State]) -> Vec<usize> {
        let mut order = Vec::new();
        made[index] = State::New;
        // Circles were refused by `new`.
        let _no_circle = self.walk(index, made, &mut |i| order.push(i));
        order
    }

    /// Visits what is not done yet, each object after those it is made from; or gives the object and reference that
    /// close a circle. Without recursion: documents may have chains of any length.
    fn walk(
        &self,
        start: usize,
        state: &mut [State],
        visit: &mut dyn FnMut(usize),
    ) -> std::result::Result<(), (usize, usize)> {
        let mut way = vec![(start, 0)];
        while let Some((index, next)) = way.pop() {
            if next == 0 && state[index] == State::Done {
                continue;
            }
            state[index] = State::Begun;
            let Some(&base) = self.of[index].get(next) else {
                state[index] = State::Done;
                visit(index);
                continue;
            };
            if state[base] == State::Begun {
                return Err((index, next));
            }
            way.extend([(index, next + 1), (base, 0)]);
        }
        Ok(())
    }
}

/// The message at the reference of an object with this number.
fn refused(document: &Document, index: usize, place: usize, message: &str) -> Error {
    let (name, spec) = &document.objects[index];
    let steps = spec.kind().references().swap_remove(place).0;
    let path: Vec<Step> = [Step::from("objects"), Step::from(name.as_str())].into_iter().chain(steps).collect();
    let span = span_of(&document.text, &path).unwrap_or(0..0);
    Error::Input(document.source().diagnostic(span, &path_text(&path), message))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each is walked to once, however long the way to it is.
    #[test]
    fn a_chain_is_walked_once() {
        let count = 500;
        let references =
            References { of: (0..count).map(|k| (0..k).last().into_iter().collect()).collect(), sources: Vec::new() };
        let mut made = references.nothing_made();
        let walked: Vec<usize> = (0..count).flat_map(|k| references.needed_for(k, &mut made)).collect();
        assert_eq!(walked, (0..count).collect::<Vec<_>>());
        // From its end: all of it, in order; then nothing but the object itself.
        let mut made = references.nothing_made();
        assert_eq!(references.needed_for(count - 1, &mut made), (0..count).collect::<Vec<_>>());
        assert_eq!(references.needed_for(7, &mut made), [7]);
    }
}
