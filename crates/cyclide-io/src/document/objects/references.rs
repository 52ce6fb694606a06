//! Which objects are made from which others: names found, circles refused, the order of building.

use std::collections::HashMap;

use crate::document::Document;
use crate::document::locate::{Step, path_text, span_of};
use crate::document::spec::{BorderCurves, GridSource, ObjectSpec, TorusSource};
use crate::error::{Error, Result};
use crate::text::suggest::did_you_mean;

/// The objects that each object is made from.
pub(super) struct References {
    of: Vec<Vec<usize>>,
    /// Whether another object is made from each.
    sources: Vec<bool>,
}

/// How far the walk over an object's references has come.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum State {
    New,
    Begun,
    Done,
}

impl References {
    /// Finds every name.
    ///
    /// # Errors
    /// [`Error::Input`] at a name that no object has, or that leads back to the object itself.
    pub(super) fn new(document: &Document) -> Result<Self> {
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
            of.push(spec.references().into_iter().enumerate().map(find).collect::<Result<Vec<_>>>()?);
        }
        let mut sources = vec![false; of.len()];
        of.iter().flatten().for_each(|&index: &usize| sources[index] = true);
        let references = Self { of, sources };
        let mut state = vec![State::New; references.of.len()];
        for index in 0..references.of.len() {
            references.walk(index, &mut state, &mut |_| {}).map_err(|(index, place)| {
                let message = format!("`{}` is made from itself", document.objects[index].0);
                refused(document, index, place, &message)
            })?;
        }
        Ok(references)
    }

    /// The objects that an object is made from, in the order of [`ObjectSpec::references`].
    pub(super) fn of(&self, index: usize) -> &[usize] {
        &self.of[index]
    }

    /// True if another object is made from this one.
    pub(super) fn is_source(&self, index: usize) -> bool {
        self.sources[index]
    }

    /// No object is made.
    pub(super) fn nothing_made(&self) -> Vec<State> {
        vec![State::New; self.of.len()]
    }

    /// Objects that were not made after all are visited again.
    pub(super) fn forget(made: &mut [State], is_missing: impl Fn(usize) -> bool) {
        for (index, state) in made.iter_mut().enumerate() {
            if is_missing(index) {
                *state = State::New;
            }
        }
    }

    /// The object and all it needs that is not made yet, each after what it is made from: these count as made then. The
    /// state is that of all objects from call to call, so that a long chain is walked once.
    pub(super) fn needed_for(&self, index: usize, made: &mut [State]) -> Vec<usize> {
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
    let steps = spec.references().swap_remove(place).0;
    let path: Vec<Step> = [Step::from("objects"), Step::from(name.as_str())].into_iter().chain(steps).collect();
    let span = span_of(&document.text, &path).unwrap_or(0..0);
    Error::Input(document.source().diagnostic(span, &path_text(&path), message))
}

/// The names of two curves, with their paths.
fn rails(names: &[String; 2]) -> Vec<(Vec<Step>, &str)> {
    names.iter().enumerate().map(|(k, name)| (vec![Step::from("rails"), Step::from(k)], name.as_str())).collect()
}

/// The name of a torus, if it is one.
fn torus(source: &TorusSource) -> Vec<(Vec<Step>, &str)> {
    source.name().map(|name| (vec![Step::from("torus")], name)).into_iter().collect()
}

impl ObjectSpec {
    /// The names of the objects it is made from, with their paths below the object.
    pub(super) fn references(&self) -> Vec<(Vec<Step>, &str)> {
        let of = |name| vec![(vec![Step::from("of")], name)];
        match self {
            Self::Offset(s) => of(s.of.as_str()),
            Self::Layers(s) => of(s.of.as_str()),
            Self::CoordinateSurfaces(s) => of(s.of.as_str()),
            Self::Transform(s) => of(s.of.as_str()),
            Self::Revolution(s) => of(s.of.as_str()),
            Self::Pipe(s) => of(s.of.as_str()),
            Self::Tube(s) => s.of.as_deref().map(of).unwrap_or_default(),
            Self::Unrolled(s) => of(s.of.as_str()),
            Self::TorusSeam(s) => of(s.of.as_str()),
            Self::TorusSpline(s) => torus(&s.torus),
            Self::TorusKnot(s) => torus(&s.torus),
            Self::TorusQuartic(s) => torus(&s.torus),
            Self::TorusCircle(s) => torus(&s.torus),
            Self::SupportStructure(s) => of(s.of.as_str()),
            Self::Motion(s) => s.along.iter().map(|name| (vec![Step::from("along")], name.as_str())).collect(),
            Self::ArcFit(s) => s.of.as_deref().map(of).unwrap_or_default(),
            Self::BallCenters(s) => of(s.of.as_str()),
            Self::CenterSurface(s) => of(s.of.as_str()),
            Self::Trajectory(s) => of(s.of.as_str()),
            Self::SweptSurface(s) => {
                vec![(vec![Step::from("of")], s.of.as_str()), (vec![Step::from("profile")], s.profile.as_str())]
            }
            Self::Sweep(s) => {
                vec![(vec![Step::from("of")], s.of.as_str()), (vec![Step::from("section")], s.section.as_str())]
            }
            Self::CircularSurface(s) => rails(&s.rails),
            Self::Ruled(s) => rails(&s.rails),
            Self::CyclidicNet(s) => {
                let sides = s.make_circular.border_curves().map(BorderCurves::sides).into_iter().flatten();
                let path = |field| vec![Step::from("make_circular"), Step::from("border"), Step::from(field)];
                let sides = sides.filter_map(|(field, name)| name.map(|name| (path(field), name)));
                // After the curves of the sides, which are counted.
                let grid = match &s.grid {
                    GridSource::Laid(laid) => Some((vec![Step::from("grid"), Step::from("of")], laid.of.as_str())),
                    _ => None,
                };
                sides.chain(grid).collect()
            }
            _ => Vec::new(),
        }
    }
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
