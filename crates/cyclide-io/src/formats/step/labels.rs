//! What a model's objects are called in STEP.

use super::data::string;
use crate::check::labels::{FileLabels, FileName, Named};
use crate::export::parts::{BodyOf, contours_of};

/// What the names are those of.
pub(super) const SET: &str = "curve set";
pub(super) const CURVE: &str = "curve";
pub(super) const BODY: &str = "body";
pub(super) const LAYER: &str = "layer";
pub(super) const PRODUCT: &str = "product";
pub(super) const OCCURRENCE: &str = "occurrence";
pub(super) const ASSEMBLY: &str = "assembly";

/// The labels of a file of the model: those of an assembly if it has occurrences of products, else those of one product.
pub(crate) fn labels(named: Named<'_>, bodies: &[BodyOf<'_>], read: &FileLabels) -> FileLabels {
    let assembly = read.names.iter().any(|name| name.of == OCCURRENCE);
    let items = || named.model.items.iter().enumerate();
    let product = |item: usize| if assembly { named.model.items[item].name.as_str() } else { named.title };
    let whole = |item: usize| [(LAYER, named.model.items[item].name.as_str()), (PRODUCT, product(item))];
    let mut names = Vec::new();
    let mut push = |of: &'static str, name: &str, count: usize| names.push(FileName::new(of, escaped(name), count));
    for (index, item) in items().filter(|(_, item)| !item.curves().is_empty()) {
        push(SET, &item.name, item.curves().len());
        whole(index).iter().for_each(|(of, name)| push(of, name, 1));
    }
    for body in bodies {
        push(BODY, &body.label(), 1);
        whole(body.item).iter().for_each(|(of, name)| push(of, name, 1));
    }
    for contour in items().flat_map(|(index, item)| contours_of(index, item)) {
        push(CURVE, &contour.label(), 1);
    }
    let mut with_bodies = vec![false; named.model.items.len()];
    bodies.iter().for_each(|body| with_bodies[body.item] = true);
    let written = items().filter(|(index, item)| !item.curves().is_empty() || with_bodies[*index]);
    for (_, item) in written.filter(|_| assembly) {
        [(OCCURRENCE, item.name.as_str()), (ASSEMBLY, named.title), (PRODUCT, item.name.as_str())]
            .iter()
            .for_each(|(of, name)| push(of, name, 1));
    }
    FileLabels::new(named.model.units, names)
}

/// A name as it stands between its quotes.
fn escaped(name: &str) -> String {
    let quoted = string(name);
    quoted[1..quoted.len() - 1].to_owned()
}
