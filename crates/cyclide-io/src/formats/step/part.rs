//! The objects of a file before their products.

/// An object of the model: what its shape consists of.
pub(super) struct Part {
    pub(super) name: String,
    /// Index of the object in the model, which decides about its colors.
    pub(super) index: usize,
    pub(super) curve_sets: Vec<usize>,
    pub(super) surfaces: Vec<usize>,
    pub(super) solids: Vec<usize>,
}

impl Part {
    pub(super) fn new(name: &str, index: usize) -> Self {
        let (curve_sets, surfaces, solids) = (Vec::new(), Vec::new(), Vec::new());
        Self { name: name.to_owned(), index, curve_sets, surfaces, solids }
    }

    /// All items, in the order of the kinds.
    pub(super) fn items(&self) -> Vec<usize> {
        [&self.solids[..], &self.surfaces, &self.curve_sets].concat()
    }

    /// True if there is a solid or a surface.
    pub(super) fn has_faces(&self) -> bool {
        !(self.solids.is_empty() && self.surfaces.is_empty())
    }
}
