//! Strips: the parameter directions of faces that must be cut at the same places.
//!
//! The two sides of a patch along s are cut where the patch is, and the patch beyond a side is cut where the side is: a
//! strip runs across opposite sides through the whole shell, as on a quad mesh. Within it parameters may run either way.

use crate::topology::{FaceEdge, FaceGeometry as _, Shell, ShellFace};

/// A direction of a face in its strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Member {
    /// The face.
    pub(super) face: usize,
    /// 0 for its s, 1 for its t.
    pub(super) direction: usize,
    /// True if the face's parameter runs against that of the strip.
    pub(super) flipped: bool,
}

/// Where a parameter belongs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Place {
    /// The strip.
    pub(super) strip: usize,
    /// True if the parameter runs against that of the strip.
    pub(super) flipped: bool,
}

/// Directions of faces that are cut at the same places.
#[derive(Debug, Clone, Default)]
pub(super) struct Strip {
    /// Its directions of faces.
    pub(super) members: Vec<Member>,
    /// True if it meets itself the other way round (a Möbius band): its cuts are symmetric.
    pub(super) symmetric: bool,
    /// True if the parameter of a face or an edge runs against it.
    pub(super) reversed: bool,
    /// Places that must be cuts, ascending, with the ends 0 and 1: parameter lines of a member that are one point, and one
    /// between two of these.
    pub(super) fixed: Vec<f64>,
}

/// The strips of a shell.
pub(super) struct Strips {
    /// All strips, in the order of their first face.
    pub(super) strips: Vec<Strip>,
    /// The strips of each face's s and t.
    pub(super) faces: Vec<[Place; 2]>,
    /// The strip of each edge.
    pub(super) edges: Vec<Place>,
}

/// Singular lines of one strip closer than this are cut at one place.
pub(super) const SAME_CUT: f64 = 1e-9;

impl Strips {
    pub(super) fn new(shell: &Shell) -> Self {
        let (faces, edges) = (shell.faces(), shell.edges().len());
        // Nodes: s and t of the faces, then the edges.
        let mut links = Links::new(2 * faces.len() + edges);
        for (f, face) in faces.iter().enumerate() {
            for (direction, side) in sides(face) {
                links.link(2 * f + direction, 2 * faces.len() + side.edge, !side.forward);
            }
        }
        let mut strips: Vec<Strip> = Vec::new();
        let mut of_root = vec![None; links.parent.len()];
        let mut places = Vec::with_capacity(links.parent.len());
        for node in 0..links.parent.len() {
            let (root, flipped) = links.root(node);
            let strip = *of_root[root].get_or_insert_with(|| {
                strips.push(Strip { symmetric: links.symmetric[root], fixed: vec![0.0, 1.0], ..Strip::default() });
                strips.len() - 1
            });
            strips[strip].reversed |= flipped || links.symmetric[root];
            places.push(Place { strip, flipped });
            if node < 2 * faces.len() {
                strips[strip].members.push(Member { face: node / 2, direction: node % 2, flipped });
            }
        }
        for strip in &mut strips {
            strip.fix(faces);
        }
        let edges = places.split_off(2 * faces.len());
        Self { strips, faces: places.chunks(2).map(|p| [p[0], p[1]]).collect(), edges }
    }
}

impl Strip {
    /// Whether two places in this order are so far apart that no parameter of a member takes them for one.
    pub(super) fn apart(&self, a: f64, b: f64) -> bool {
        a < b && (!self.reversed || 1.0 - b < 1.0 - a)
    }

    /// Collects the places that must be cuts.
    fn fix(&mut self, faces: &[ShellFace]) {
        for member in &self.members {
            let points = point_lines(&faces[member.face], member.direction);
            // A cell from one point to another has no area: between them go two at least. Points nearer to each other
            // share a cut.
            let apart = points.windows(2).filter(|w| w[1] - w[0] > 4.0 * SAME_CUT);
            let between = apart.map(|w| 0.5 * (w[0] + w[1]));
            let places = points.iter().copied().chain(between);
            self.fixed.extend(places.map(|u| if member.flipped { 1.0 - u } else { u }));
        }
        if self.symmetric {
            let mirrored: Vec<f64> = self.fixed.iter().map(|&u| 1.0 - u).collect();
            self.fixed.extend(mirrored);
            self.fixed.push(0.5);
        }
        self.fixed.sort_by(f64::total_cmp);
        self.fixed.dedup_by(|b, a| *b - *a <= SAME_CUT);
        // The last one kept may be just below the end.
        if let Some(last) = self.fixed.last_mut() {
            *last = 1.0;
        }
    }
}

/// The lines across a direction of a face that are one point, sides included, ascending.
pub(super) fn point_lines(face: &ShellFace, direction: usize) -> Vec<f64> {
    let [first, last] = [2 - 2 * direction, 3 - 2 * direction].map(|side| face.sides[side].is_none());
    let inside = if direction == 0 { face.surface.singular_s() } else { face.surface.singular_t() };
    first.then_some(0.0).into_iter().chain(inside).chain(last.then_some(1.0)).collect()
}

/// The edges along s, then those along t, with the direction.
fn sides(face: &ShellFace) -> impl Iterator<Item = (usize, FaceEdge)> + '_ {
    face.sides.iter().enumerate().filter_map(|(k, side)| side.map(|side| (k / 2, side)))
}

/// Sets of nodes joined by links that keep or reverse the parameter.
struct Links {
    parent: Vec<usize>,
    /// Whether a node runs against its parent.
    flipped: Vec<bool>,
    /// Whether the set of a root was joined to itself in reverse.
    symmetric: Vec<bool>,
}

impl Links {
    fn new(n: usize) -> Self {
        Self { parent: (0..n).collect(), flipped: vec![false; n], symmetric: vec![false; n] }
    }

    /// The root of a node, and whether the node runs against it.
    fn root(&mut self, node: usize) -> (usize, bool) {
        let (mut root, mut flipped) = (node, false);
        while self.parent[root] != root {
            flipped ^= self.flipped[root];
            root = self.parent[root];
        }
        // Shortens the way for the next call.
        let (mut at, mut against) = (node, flipped);
        while self.parent[at] != root && at != root {
            let (next, step) = (self.parent[at], self.flipped[at]);
            (self.parent[at], self.flipped[at]) = (root, against);
            against ^= step;
            at = next;
        }
        (root, flipped)
    }

    fn link(&mut self, a: usize, b: usize, reversed: bool) {
        let ((a, fa), (b, fb)) = (self.root(a), self.root(b));
        let flipped = fa ^ fb ^ reversed;
        if a == b {
            self.symmetric[a] |= flipped;
        } else {
            let (low, high) = (a.min(b), a.max(b));
            self.parent[high] = low;
            self.flipped[high] = flipped;
            self.symmetric[low] |= self.symmetric[high];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reversals_add_up_along_the_way() {
        let mut links = Links::new(5);
        links.link(3, 4, true);
        links.link(2, 3, true);
        links.link(1, 2, false);
        assert_eq!(links.root(4), (1, false));
        assert_eq!(links.root(3), (1, true));
        assert!(!links.symmetric[1]);
        links.link(4, 3, false);
        assert!(links.symmetric[1], "joined to itself in reverse");
        assert_eq!(links.root(0), (0, false));
    }
}
