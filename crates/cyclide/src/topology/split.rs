//! Cutting the faces of a shell along whole strips, so that neighbors keep sharing their edges.
//!
//! A cut of one edge cuts every face along it, hence the opposite edge of each such face, and so on: the faces linked
//! through opposite sides are a strip, and a strip is cut as a whole. Faces that share an edge agree on its parameter,
//! so the cut has one parameter per edge and its vertex is computed once.

use super::{EdgeCurve, FaceEdge, FaceGeometry as _, FacePart, FaceSurface, Shell, ShellEdge, ShellFace, Side};
use crate::base::vector::Point3;
use crate::error::{Error, NumberError, Result, ShellError};
use crate::surface::ParamSurface as _;

/// Speeds below this part of the largest one are zero: the parameter line is one point.
const ZERO_SPEED: f64 = 1e-9;

/// Where edges are cut, in their own parameter, and where faces are cut across a direction in which both sides are one
/// point, in the parameter of the face.
pub(super) struct Cuts {
    edges: Vec<Option<f64>>,
    lunes: Vec<[Option<f64>; 2]>,
}

impl Cuts {
    pub(super) fn none(shell: &Shell) -> Self {
        Self { edges: vec![None; shell.edges.len()], lunes: vec![[None; 2]; shell.faces.len()] }
    }

    pub(super) fn is_empty(&self) -> bool {
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
    /// Marks a face, and the strip through it, for a cut at the face's parameter `at` of a direction.
    pub(super) fn mark(&self, along: &[Vec<(usize, Side)>], cuts: &mut Cuts, face: usize, direction: usize, at: f64) {
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

    /// The shell with the marked edges cut, of `most` faces at most, and which part of which face each of its faces is;
    /// every strip must be marked as a whole.
    pub(super) fn cut(&self, cuts: &Cuts, most: usize) -> Result<(Self, Vec<FacePart>)> {
        let parts = |(index, face): (usize, &ShellFace)| -> usize {
            [0, 1].map(|d| 1 + usize::from(cuts.of(index, face, d).is_some())).iter().product()
        };
        let faces: usize = self.faces.iter().enumerate().map(parts).sum();
        if faces > most {
            return Err(NumberError::TooManyPieces {
                what: "the shell, cut for files,",
                segment: None,
                needed: faces as f64,
                cap: most,
                remedy: "its patches are singular or nearly so at too many locations",
            }
            .into());
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
        let mut of_faces = Vec::with_capacity(faces);
        for index in 0..self.faces.len() {
            of_faces.extend(self.cut_face(index, cuts, &middles, &parts, &mut new)?);
        }
        Ok((new, of_faces))
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

    /// Adds the one, two or four parts of a face, with their inner edges; gives which parts they are.
    fn cut_face(
        &self,
        index: usize,
        cuts: &Cuts,
        middles: &[usize],
        parts: &[usize],
        new: &mut Self,
    ) -> Result<Vec<FacePart>> {
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
        let between = |direction: usize, i: usize| [breaks[direction][i], breaks[direction][i + 1]];
        let own: Vec<FacePart> =
            (0..ns * nt).map(|k| FacePart { face: index, s: between(0, k % ns), t: between(1, k / ns) }).collect();
        let surface = |k: usize| {
            let (i, j) = (k % ns, k / ns);
            let points = [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)].map(|(i, j)| new.vertices[vertex[i][j]]);
            if points.iter().all(|p| *p == points[0]) {
                return Err(no_part(face, points[0]));
            }
            Ok(face.surface.part_between(own[k].s, own[k].t, points))
        };
        let surfaces: Vec<FaceSurface> =
            if ns * nt == 1 { vec![face.surface.clone()] } else { (0..ns * nt).map(surface).collect::<Result<_>>()? };
        // The part of a side between two breaks, or the side as a own.
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
        Ok(own)
    }
}

/// The error of a cut so near to a singular point that a part of the face is that point.
fn no_part(face: &ShellFace, at: Point3) -> Error {
    let edge = face.sides.iter().flatten().next().map_or(0, |side| side.edge);
    Error::Shell(ShellError::ShortEdge { edge, length: 0.0, limit: f64::EPSILON * at.to_vec().max_abs() })
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
