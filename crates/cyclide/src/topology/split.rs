//! Cutting the faces of a shell along whole strips, so that neighbours keep sharing their edges.
//!
//! A cut of one edge cuts every face along it, hence the opposite edge of each such face, and so on: the faces linked
//! through opposite sides are a strip, and a strip is cut as a whole. Faces that share an edge agree on its parameter,
//! so the cut has one parameter per edge and its vertex is computed once.

use super::{EdgeCurve, FaceEdge, FaceGeometry as _, FaceSurface, Shell, ShellEdge, ShellFace, Side};
use crate::base::bounds::Aabb;
use crate::base::vector::Point3;
use crate::error::{Error, Result};
use crate::surface::ParamSurface as _;

/// Smallest cosine of half an edge's angle: edges stay below 150 degrees.
const SMALLEST_COSINE: f64 = 0.25;
/// Smallest weight of the middle of a patch, relative to the geometric mean of its corners' weights.
const SMALLEST_MIDDLE: f64 = 0.0625;
/// A strip is halved this often at most: sixteen halvings leave 3e-5 of an edge.
const MOST_PASSES: usize = 16;
/// Faces of a cut shell at most, or so many times those given: they take two kilobytes each with what belongs to them.
const MOST_FACES: usize = 500_000;
const MOST_GROWTH: usize = 8;
/// Shortest edge that other programs tell from a point, relative to the box of the vertices.
const SHORTEST_EDGE: f64 = 1e-13;
/// Speeds below this part of the largest one are zero: the parameter line is one point.
const ZERO_SPEED: f64 = 1e-9;

/// Where edges are cut, in their own parameter, and where faces are cut across a direction in which both sides are one
/// point, in the parameter of the face.
struct Cuts {
    edges: Vec<Option<f64>>,
    lunes: Vec<[Option<f64>; 2]>,
}

impl Cuts {
    fn none(shell: &Shell) -> Self {
        Self { edges: vec![None; shell.edges.len()], lunes: vec![[None; 2]; shell.faces.len()] }
    }

    fn is_empty(&self) -> bool {
        self.edges.iter().all(Option::is_none) && self.lunes.iter().flatten().all(Option::is_none)
    }

    /// Where a face is cut in a direction.
    fn of(&self, index: usize, face: &ShellFace, direction: usize) -> Option<f64> {
        match face.side_along(direction) {
            Some(side) => self.edges[side.edge].map(|at| side.turned(at)),
            None => self.lunes[index][direction],
        }
    }
}

impl ShellFace {
    /// An edge of the face that runs in this direction.
    fn side_along(&self, direction: usize) -> Option<FaceEdge> {
        Side::along(direction).into_iter().find_map(|side| self.side(side))
    }
}

impl Shell {
    /// The same surface in faces whose nine real weights are all positive and whose edges are below 150 degrees:
    /// strips of faces are halved until all are. Edges and vertices stay shared bit for bit, sides of one point stay so.
    ///
    /// # Errors
    /// `patch-through-infinity` where sixteen halvings do not suffice; `too-many-pieces` (faces); `short-edge` if an edge is shorter than 1e-13 of
    /// the shell, as in cyclides that are nearly singular.
    pub fn with_positive_weights(&self) -> Result<Self> {
        let shell = self.halved(|_, face| too_wide(&face.surface), MOST_PASSES)?;
        if !shell.faces.iter().all(|face| too_wide(&face.surface) == [false, false]) {
            return Err(Error::PatchThroughInfinity { s: 0.5, t: 0.5 });
        }
        shell.check_long_edges()?;
        Ok(shell)
    }

    /// The same surface with strips of faces halved, at the middle of their widest side, until `wide` names no direction
    /// (s, t) of a face of the shell so far that is to be halved, `most` times at most. Edges and vertices stay shared bit for bit, sides of
    /// one point stay so.
    ///
    /// # Errors
    /// `parameter-out-of-range` beyond the range of the kernel's numbers; `too-many-pieces` beyond half a million faces and
    /// eight times those given; `short-edge` where a part of a face would be a point.
    pub fn halved(&self, wide: impl Fn(&Self, &ShellFace) -> [bool; 2], most: usize) -> Result<Self> {
        let mut shell = self.clone();
        let cap = self.most_faces();
        for _ in 0..most {
            let mut found: Vec<(usize, usize, WidestSide)> = Vec::new();
            for (index, face) in shell.faces.iter().enumerate() {
                let wide = wide(&shell, face);
                if wide != [false, false] {
                    let sides = widest_sides(&face.surface);
                    found.extend([0, 1].into_iter().filter(|&d| wide[d]).map(|d| (index, d, sides[d])));
                }
            }
            if found.is_empty() {
                break;
            }
            // The widest side decides where its strip is cut.
            found.sort_by(|a, b| a.2.cosine.total_cmp(&b.2.cosine));
            let (mut cuts, along) = (Cuts::none(&shell), shell.faces_along_edges());
            for (face, direction, side) in found {
                shell.mark(&along, &mut cuts, face, direction, side.middle);
            }
            shell = shell.cut(&cuts, cap)?;
        }
        Ok(shell)
    }

    /// Refuses edges that are points for other programs.
    fn check_long_edges(&self) -> Result<()> {
        let limit = SHORTEST_EDGE * Aabb::of_points(self.vertices.iter().copied()).map_or(0.0, Aabb::diagonal);
        for (edge, ShellEdge { curve, .. }) in self.edges.iter().enumerate() {
            let length = curve.start().distance(curve.end());
            if length < limit {
                return Err(Error::ShortEdge { edge, length, limit });
            }
        }
        Ok(())
    }

    /// The same surface in faces without a parameter line of one point inside: strips of faces are cut there, and the
    /// parts of a singular face meet in that point, which is a side of each. Neighbours of a singular face are cut
    /// with it.
    ///
    /// # Errors
    /// As [`halved`](Self::halved).
    pub fn with_regular_faces(&self) -> Result<Self> {
        let mut shell = self.clone();
        let cap = self.most_faces();
        // Every pass cuts each strip once; a patch has two such lines at most in each direction.
        for _ in 0..MOST_PASSES {
            let (mut cuts, along) = (Cuts::none(&shell), shell.faces_along_edges());
            for (index, face) in shell.faces.iter().enumerate() {
                for (direction, places) in [face.surface.singular_s(), face.surface.singular_t()].iter().enumerate() {
                    if let Some(&at) = places.first() {
                        shell.mark(&along, &mut cuts, index, direction, at);
                    }
                }
            }
            if cuts.is_empty() {
                break;
            }
            shell = shell.cut(&cuts, cap)?;
        }
        Ok(shell)
    }

    /// Marks a face, and the strip through it, for a cut at the face's parameter `at` of a direction.
    fn mark(&self, along: &[Vec<(usize, Side)>], cuts: &mut Cuts, face: usize, direction: usize, at: f64) {
        match self.faces[face].side_along(direction) {
            Some(side) => self.mark_strip(along, &mut cuts.edges, side.edge, side.turned(at)),
            None => cuts.lunes[face][direction] = Some(at),
        }
    }

    /// Marks the strip through an edge for a cut at the edge's parameter `at`, unless it is marked already. A strip
    /// that comes back to itself the other way round is cut in the middle.
    fn mark_strip(&self, along: &[Vec<(usize, Side)>], cuts: &mut [Option<f64>], edge: usize, at: f64) {
        if cuts[edge].is_some() {
            return;
        }
        let mut strip = vec![edge];
        let mut turned_over = false;
        cuts[edge] = Some(at);
        let mut next = 0;
        while let Some(&e) = strip.get(next) {
            next += 1;
            for &(f, side) in &along[e] {
                let face = &self.faces[f];
                let (Some(side), Some(other)) = (face.side(side), face.side(side.opposite())) else { continue };
                // The same parameter if both edges run the same way along the face.
                let here = cuts[e].unwrap_or(at);
                let there = if side.forward == other.forward { here } else { 1.0 - here };
                match cuts[other.edge] {
                    None => {
                        cuts[other.edge] = Some(there);
                        strip.push(other.edge);
                    }
                    Some(found) => turned_over |= (found - there).abs() > ZERO_SPEED,
                }
            }
        }
        if turned_over {
            for e in strip {
                cuts[e] = Some(0.5);
            }
        }
    }

    /// Vertices of the corners of a face.
    fn corner_vertices(&self, face: &ShellFace) -> [usize; 4] {
        let mut corners = [usize::MAX; 4];
        for (side, edge) in face.edges() {
            let ShellEdge { start, end, .. } = self.edges[edge.edge];
            let [from, to] = side.corners();
            (corners[from], corners[to]) = if edge.forward { (start, end) } else { (end, start) };
        }
        corners
    }

    /// How many faces a shell may have that is cut from this one.
    fn most_faces(&self) -> usize {
        MOST_FACES.max(MOST_GROWTH.saturating_mul(self.faces.len()))
    }

    /// The shell with the marked edges cut, of `most` faces at most; every strip must be marked as a whole.
    fn cut(&self, cuts: &Cuts, most: usize) -> Result<Self> {
        let parts = |(index, face): (usize, &ShellFace)| -> usize {
            [0, 1].map(|d| 1 + usize::from(cuts.of(index, face, d).is_some())).iter().product()
        };
        let faces: usize = self.faces.iter().enumerate().map(parts).sum();
        if faces > most {
            return Err(Error::TooManyPieces {
                what: "the shell, cut for files,",
                segment: None,
                needed: faces as f64,
                cap: most,
                remedy: "its patches are singular or nearly so in too many places",
            });
        }
        let mut new = Self { vertices: self.vertices.clone(), edges: Vec::new(), faces: Vec::new() };
        let middles = self.cut_vertices(&cuts.edges, &mut new.vertices);
        // The one or two parts of each edge, in its direction.
        let mut parts = Vec::with_capacity(self.edges.len());
        for (e, edge) in self.edges.iter().enumerate() {
            let first = new.edges.len();
            parts.push(first);
            if let Some(at) = cuts.edges[e] {
                let (left, right) = edge.curve.split(at)?;
                let (middle, point) = (middles[e], new.vertices[middles[e]]);
                new.edges.push(ShellEdge { start: edge.start, end: middle, curve: left.with_ends(None, Some(point)) });
                new.edges.push(ShellEdge { start: middle, end: edge.end, curve: right.with_ends(Some(point), None) });
            } else {
                new.edges.push(edge.clone());
            }
        }
        for index in 0..self.faces.len() {
            self.cut_face(index, cuts, &middles, &parts, &mut new)?;
        }
        Ok(new)
    }

    /// The vertices of the cuts, one per cut edge; edges that meet in a line of one point share it.
    fn cut_vertices(&self, cuts: &[Option<f64>], vertices: &mut Vec<Point3>) -> Vec<usize> {
        let mut same: Vec<usize> = (0..self.edges.len()).collect();
        for face in &self.faces {
            for direction in [0, 1] {
                if let [Some(a), Some(b)] = Side::along(direction).map(|side| face.side(side))
                    && let Some(at) = cuts[a.edge]
                    && is_one_point(&face.surface, direction, a.turned(at))
                {
                    let (ra, rb) = (root(&same, a.edge), root(&same, b.edge));
                    same[ra.max(rb)] = ra.min(rb);
                }
            }
        }
        let mut middles = vec![usize::MAX; self.edges.len()];
        for (e, edge) in self.edges.iter().enumerate() {
            if let Some(at) = cuts[e] {
                // The representative has the smallest number of its set.
                middles[e] = match root(&same, e) {
                    r if r < e => middles[r],
                    _ => {
                        vertices.push(edge.curve.point(at));
                        vertices.len() - 1
                    }
                };
            }
        }
        middles
    }

    /// The one, two or four parts of a face, with their inner edges.
    fn cut_face(&self, index: usize, cuts: &Cuts, middles: &[usize], parts: &[usize], new: &mut Self) -> Result<()> {
        let face = &self.faces[index];
        let breaks = [0, 1].map(|d| cuts.of(index, face, d).map_or(vec![0.0, 1.0], |at| vec![0.0, at, 1.0]));
        let [ns, nt] = [breaks[0].len() - 1, breaks[1].len() - 1];
        let corners = self.corner_vertices(face);
        // The middle of side k: of its edge, or the corner that it is.
        let middle = |k: usize| face.sides[k].map_or(corners[Side::ALL[k].corners()[0]], |side| middles[side.edge]);
        let end = |i: usize, n: usize| if i == 0 { Some(0) } else { (i == n).then_some(1) };
        let mut vertex = [[0; 3]; 3];
        for (i, &s) in breaks[0].iter().enumerate() {
            for (j, &t) in breaks[1].iter().enumerate() {
                vertex[i][j] = match (end(i, ns), end(j, nt)) {
                    (Some(a), Some(b)) => corners[a + 2 * b],
                    (None, Some(b)) => middle(b),
                    (Some(a), None) => middle(2 + a),
                    (None, None) => {
                        new.vertices.push(face.surface.point(s, t));
                        new.vertices.len() - 1
                    }
                };
            }
        }
        let part = |i: usize, j: usize| {
            let points = [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)].map(|(i, j)| new.vertices[vertex[i][j]]);
            if points.iter().all(|p| *p == points[0]) {
                return Err(no_part(face, points[0]));
            }
            Ok(face.surface.part_between([breaks[0][i], breaks[0][i + 1]], [breaks[1][j], breaks[1][j + 1]], points))
        };
        let surfaces: Vec<FaceSurface> = if ns * nt == 1 {
            vec![face.surface.clone()]
        } else {
            (0..ns * nt).map(|k| part(k % ns, k / ns)).collect::<Result<_>>()?
        };
        // The part of a side between two breaks, or the side as a whole.
        let part_of_side = |k: usize, i: usize| {
            face.sides[k].map(|side| {
                let i = if side.forward { i } else { 1 - i };
                let i = if cuts.edges[side.edge].is_some() { i } else { 0 };
                FaceEdge { edge: parts[side.edge] + i, forward: side.forward }
            })
        };
        let mut inner = |start: usize, end: usize, curve: EdgeCurve| {
            (start != end).then(|| {
                new.edges.push(ShellEdge { start, end, curve });
                FaceEdge { edge: new.edges.len() - 1, forward: true }
            })
        };
        let (mut along_s, mut along_t) = ([[None; 3]; 2], [[None; 2]; 3]);
        for i in 0..ns {
            for j in 0..=nt {
                along_s[i][j] = match end(j, nt) {
                    Some(k) => part_of_side(k, i),
                    None => inner(vertex[i][j], vertex[i + 1][j], surfaces[i + ns * j].s_line(0.0)?),
                };
            }
        }
        for i in 0..=ns {
            for j in 0..nt {
                along_t[i][j] = match end(i, ns) {
                    Some(k) => part_of_side(2 + k, j),
                    None => inner(vertex[i][j], vertex[i][j + 1], surfaces[i + ns * j].t_line(0.0)?),
                };
            }
        }
        for (k, surface) in surfaces.into_iter().enumerate() {
            let (i, j) = (k % ns, k / ns);
            let sides = [along_s[i][j], along_s[i][j + 1], along_t[i][j], along_t[i + 1][j]];
            new.faces.push(ShellFace { surface, sides, same_sense: face.same_sense });
        }
        Ok(())
    }
}

/// The error of a cut so near to a singular point that a part of the face is that point.
fn no_part(face: &ShellFace, at: Point3) -> Error {
    let edge = face.sides.iter().flatten().next().map_or(0, |side| side.edge);
    Error::ShortEdge { edge, length: 0.0, limit: f64::EPSILON * at.to_vec().max_abs() }
}

/// The representative of a set of edges.
fn root(same: &[usize], mut e: usize) -> usize {
    while same[e] != e {
        e = same[e];
    }
    e
}

/// True if the parameter line at `at`, across the sides of this direction, is one point; of rational surfaces only sides are.
fn is_one_point(surface: &FaceSurface, direction: usize, at: f64) -> bool {
    let Some(patch) = surface.patch() else { return false };
    let speeds = if direction == 0 { patch.q2() } else { patch.q1() };
    let largest = speeds.iter().fold(0.0, |m: f64, q| m.max(q.abs()));
    let [a, b, c] = speeds;
    let u = 1.0 - at;
    (u * (u * a + 2.0 * at * b) + at * at * c).abs() <= ZERO_SPEED * largest
}

/// The widest of the two sides of a patch in a direction.
#[derive(Debug, Clone, Copy)]
struct WidestSide {
    /// Cosine of half its angle; for a side of one point, of its weights.
    cosine: f64,
    /// The face's parameter in its middle.
    middle: f64,
}

/// The widest sides of a surface along s and along t; rational ones are halved where others ask for it only, in the middle.
fn widest_sides(surface: &FaceSurface) -> [WidestSide; 2] {
    let Some(patch) = surface.patch() else { return [WidestSide { cosine: 1.0, middle: 0.5 }; 2] };
    let w = patch.real_weights();
    let corner = |k: usize| w[2 * (k & 1)][k & 2].sqrt();
    let side = |side: Side| {
        let [a, b] = side.corners().map(corner);
        let middle = match side {
            Side::Bottom => w[1][0],
            Side::Top => w[1][2],
            Side::Left => w[0][1],
            Side::Right => w[2][1],
        };
        // Where both ends weigh the same is the middle of the arc.
        WidestSide { cosine: middle / (a * b), middle: a / (a + b) }
    };
    [0, 1].map(|direction| {
        let [k, l] = Side::along(direction).map(side);
        if k.cosine <= l.cosine { k } else { l }
    })
}

/// The directions in which a surface has to be halved for positive weights, which rational ones have.
fn too_wide(surface: &FaceSurface) -> [bool; 2] {
    let Some(patch) = surface.patch() else { return [false; 2] };
    let widest = widest_sides(surface);
    let wide = widest.map(|side| !(side.cosine >= SMALLEST_COSINE));
    let w = patch.real_weights();
    let middle = w[1][1] / (w[0][0] * w[2][0] * w[0][2] * w[2][2]).powf(0.25);
    if wide == [false, false] && !(middle >= SMALLEST_MIDDLE) {
        let wider = usize::from(widest[1].cosine < widest[0].cosine);
        return [0, 1].map(|direction| direction == wider);
    }
    wide
}
