//! The part of a surface that coordinates are laid on: triangles left out, edges that are cut, directions that agree.

use super::cross_field::CrossField;
use super::mesh_table::{MeshTable, NONE};
use cyclide::Vec3;

/// Triangles that hang together but over cuts.
pub(super) struct Sheet<'a> {
    pub(super) table: &'a MeshTable,
    /// Triangles that are not left out.
    pub(super) active: Vec<bool>,
    /// Half edges that nothing runs over.
    cut: Vec<bool>,
    /// The two principal directions of each triangle, the second a quarter turn left of the first.
    pub(super) directions: Vec<[Vec3; 2]>,
}

impl<'a> Sheet<'a> {
    /// The surface without some triangles and along some edges (half edges) cut. Directions are turned round so that neighbors agree,
    /// the surest first; where they cannot, it is cut too.
    pub(super) fn new(table: &'a MeshTable, field: &CrossField, active: Vec<bool>, cuts: &[usize]) -> Self {
        let mut sheet = Self { table, active, cut: vec![false; 3 * table.triangles.len()], directions: Vec::new() };
        cuts.iter().for_each(|half| sheet.cut_at(*half));
        let field = sheet.combed(field);
        let against: Vec<usize> = table.inner_edges().filter(|half| !field.agrees(table, *half)).collect();
        against.into_iter().for_each(|half| sheet.cut_at(half));
        sheet.directions = field.along.iter().zip(&table.normals).map(|(d, n)| [*d, n.cross(*d)]).collect();
        sheet
    }

    fn cut_at(&mut self, half: usize) {
        self.cut[half] = true;
        let twin = self.table.twin(half);
        if twin != NONE {
            self.cut[twin] = true;
        }
    }

    /// Opens the way over edges that were cut.
    pub(super) fn glue(&mut self, cuts: &[usize]) {
        for half in cuts {
            self.cut[*half] = false;
            self.cut[self.table.twin(*half)] = false;
        }
    }

    /// The half edge on the other side, if there is a way over.
    pub(super) fn across(&self, half: usize) -> Option<usize> {
        let twin = self.table.twin(half);
        let open = twin != NONE && !self.cut[half] && self.active[half / 3] && self.active[twin / 3];
        open.then_some(twin)
    }

    /// The field with signs along a spanning forest of greatest confidence.
    fn combed(&self, field: &CrossField) -> CrossField {
        let mut edges: Vec<(f64, usize)> = self
            .table
            .inner_edges()
            .filter(|half| self.across(*half).is_some())
            .map(|half| {
                let sides = [half / 3, self.table.twin(half) / 3].map(|f| field.confidence[f]);
                (sides[0].min(sides[1]), half)
            })
            .collect();
        edges.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut roots = SignedForest::new(self.table.triangles.len());
        for (_, half) in edges {
            roots.unite(half / 3, self.table.twin(half) / 3, !field.agrees(self.table, half));
        }
        let mut combed = field.clone();
        for f in 0..combed.along.len() {
            if roots.find(f).1 {
                combed.along[f] = -combed.along[f];
            }
        }
        // One sense for all: that of growing coordinates on the whole.
        let (areas, along) = (&self.table.areas, &combed.along);
        let mean = areas.iter().zip(along).fold(Vec3::ZERO, |sum, (area, d)| sum + *d * *area);
        let largest = mean.to_array().into_iter().max_by(|a, b| a.abs().total_cmp(&b.abs()));
        if largest.is_some_and(|x| x < 0.0) {
            combed.along.iter_mut().for_each(|d| *d = -*d);
        }
        combed
    }

    /// The number of the place of each corner: corners at one vertex are at one place if there is a way between their triangles round
    /// the vertex. Corners of triangles left out have numbers of their own; the count is the second result.
    pub(super) fn places(&self) -> (Vec<usize>, usize) {
        let mut roots = SignedForest::new(3 * self.table.triangles.len());
        for half in self.table.inner_edges() {
            if let Some(twin) = self.across(half) {
                let next = |half: usize| half - half % 3 + (half + 1) % 3;
                roots.unite(half, next(twin), false);
                roots.unite(next(half), twin, false);
            }
        }
        let mut number = vec![NONE; 3 * self.table.triangles.len()];
        let mut count = 0;
        let places = (0..number.len()).map(|corner| {
            let root = roots.find(corner).0;
            if number[root] == NONE {
                number[root] = count;
                count += 1;
            }
            number[root]
        });
        let places: Vec<usize> = places.collect();
        (places, count)
    }

    /// The number of the connected part of each triangle, and how many there are.
    pub(super) fn parts(&self) -> (Vec<usize>, usize) {
        let mut part = vec![NONE; self.active.len()];
        let mut count = 0;
        for start in 0..part.len() {
            if part[start] != NONE {
                continue;
            }
            let mut stack = vec![start];
            part[start] = count;
            while let Some(f) = stack.pop() {
                for other in (3 * f..3 * f + 3).filter_map(|half| self.across(half)) {
                    if part[other / 3] == NONE {
                        part[other / 3] = count;
                        stack.push(other / 3);
                    }
                }
            }
            count += 1;
        }
        (part, count)
    }
}

/// Sets that are united, with a sign of each member against its root.
struct SignedForest {
    parent: Vec<(usize, bool)>,
    size: Vec<usize>,
}

impl SignedForest {
    fn new(count: usize) -> Self {
        Self { parent: (0..count).map(|k| (k, false)).collect(), size: vec![1; count] }
    }

    /// The root, and whether the member is turned against it.
    fn find(&self, mut k: usize) -> (usize, bool) {
        let mut turned = false;
        // Sets are hung below larger ones: the way is short.
        while self.parent[k].0 != k {
            turned ^= self.parent[k].1;
            k = self.parent[k].0;
        }
        (k, turned)
    }

    fn unite(&mut self, a: usize, b: usize, turned: bool) {
        let ((a, a_turned), (b, b_turned)) = (self.find(a), self.find(b));
        if a != b {
            let (small, large) = if self.size[a] < self.size[b] { (a, b) } else { (b, a) };
            self.parent[small] = (large, turned ^ a_turned ^ b_turned);
            self.size[large] += self.size[small];
        }
    }
}
