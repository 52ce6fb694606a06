//! Which vertices of a grid are the same point.

/// Which vertices of a grid are the same point: chains of vertices lead to their first.
#[derive(Debug)]
pub(crate) struct SameVertices(Vec<usize>);

impl SameVertices {
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.first(a), self.first(b));
        self.0[a.max(b)] = a.min(b);
    }

    /// The first vertex that is the same.
    pub(crate) fn first(&self, mut k: usize) -> usize {
        while self.0[k] != k {
            k = self.0[k];
        }
        k
    }
}
