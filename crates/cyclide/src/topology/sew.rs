//! Nets and whole cyclides as shells: every vertex and every edge once.

use super::{Body, FaceEdge, Sewing, Shell};
use crate::base::range;
use crate::curve::Arc;
use crate::error::{ArcError, ErrorItem, Result, ShellError};
use crate::surface::{CyclideKind, CyclidicNet, DupinCyclide, LayoutPiece, NetLayout, SameVertices};
use std::collections::HashMap;

/// Segments of a whole turn by default, in both directions.
const DEFAULT_SEGMENTS: [usize; 2] = [4, 4];

/// Where the parts of a net are in a [`Sewing`].
#[derive(Debug)]
pub(super) struct Skin {
    /// Vertex of each grid vertex (0 where it has none); those of a side of one point are the same.
    pub(super) vertices: Vec<usize>,
    /// Edge along s from each grid vertex, `None` where it is one point or outside.
    pub(super) along_s: Vec<Option<FaceEdge>>,
    /// Edge along t from each grid vertex.
    pub(super) along_t: Vec<Option<FaceEdge>>,
}

/// What nets that join have sewn already: the vertex at each vertex of their mesh, and the edge between two, from the first.
#[derive(Debug, Default)]
pub(super) struct Joined {
    vertices: HashMap<usize, usize>,
    edges: HashMap<[usize; 2], usize>,
}

impl Joined {
    /// The vertex at one of the mesh.
    fn vertex(&mut self, of_mesh: Option<usize>, make: impl FnOnce() -> usize) -> usize {
        of_mesh.map_or_else(|| 0, |v| *self.vertices.entry(v).or_insert_with(make))
    }

    fn edge(&mut self, of_mesh: [usize; 2], make: impl FnOnce() -> Result<usize>) -> Result<FaceEdge> {
        let [from, to] = of_mesh;
        if let Some(edge) = self.edges.get(&[to, from]) {
            return Ok(FaceEdge { edge: *edge, forward: false });
        }
        let edge = match self.edges.get(&of_mesh) {
            Some(edge) => *edge,
            None => make()?,
        };
        self.edges.insert(of_mesh, edge);
        Ok(FaceEdge { edge, forward: true })
    }
}

impl Sewing {
    /// Adds all of a net.
    pub(super) fn skin(&mut self, net: &CyclidicNet, same_sense: bool) -> Result<Skin> {
        let skin = self.frame_of(net)?;
        self.faces_of(net, &skin, same_sense)?;
        Ok(skin)
    }

    /// Adds all nets of a layout.
    pub(super) fn skins(&mut self, layout: &NetLayout, same_sense: bool) -> Result<Vec<Skin>> {
        let mut joined = Joined::default();
        let pieces = layout.layout().pieces().iter().zip(layout.nets());
        let skin = |(piece, net): (&LayoutPiece, &CyclidicNet)| {
            let skin = self.joined_frame(net, &piece.vertices, &mut joined)?;
            self.faces_of(net, &skin, same_sense)?;
            Ok(skin)
        };
        pieces.map(skin).collect()
    }

    fn faces_of(&mut self, net: &CyclidicNet, skin: &Skin, same_sense: bool) -> Result<()> {
        let grid = net.grid();
        let [m, n] = net.size();
        self.faces.reserve_exact(m * n);
        for ([i, j], patch) in net.patches_with_quads() {
            let [k0, k1, k2, k3] = grid.corners(i, j);
            // A part of a larger surface: it may be small, but not a point.
            let corners = [k0, k1, k2, k3].map(|k| grid.points()[k]);
            let size = corners.iter().map(|p| p.distance(corners[0])).fold(0.0, f64::max);
            let place = corners[0].to_vec().max_abs();
            range::check_size_in_place(ErrorItem::Patch, size, place, f64::EPSILON)
                .map_err(|e| e.in_quad(i + j * m))?;
            let edges = [skin.along_s[k0], skin.along_s[k2], skin.along_t[k0], skin.along_t[k1]];
            self.face_along(patch, edges, same_sense);
        }
        Ok(())
    }

    /// Adds the vertices and edges of a net's patches.
    fn frame_of(&mut self, net: &CyclidicNet) -> Result<Skin> {
        let grid = net.grid();
        let [m, n] = grid.size();
        let places = || (0..n).flat_map(|j| (0..m).map(move |i| (i, j)));
        let has_edge = |at: [usize; 2], d: usize| grid.patches_beside(at, d).contains(&true);
        let next =
            |i: usize, j: usize| [has_edge([i, j], 0).then_some((i + 1, j)), has_edge([i, j], 1).then_some((i, j + 1))];
        let mut used = vec![grid.is_whole(); m * n];
        if !grid.is_whole() {
            net.patches_with_quads()
                .for_each(|([i, j], _)| grid.corners(i, j).into_iter().for_each(|k| used[k] = true));
        }
        // A side of one point is one vertex: that of its first corner.
        let mut same = SameVertices::new(m * n);
        for (i, j) in places() {
            let here = grid.index(i, j);
            for (i1, j1) in next(i, j).into_iter().flatten() {
                let there = grid.index(i1, j1);
                if grid.points()[here] == grid.points()[there] {
                    same.join(here, there);
                }
            }
        }
        let mut vertices = vec![0; m * n];
        for k in (0..m * n).filter(|k| used[*k]) {
            vertices[k] = match same.first(k) {
                first if first < k => vertices[first],
                _ => self.vertex(grid.points()[k]),
            };
        }
        self.edges.reserve_exact(places().map(|(i, j)| next(i, j).into_iter().flatten().count()).sum());
        let mut skin = Skin { vertices, along_s: vec![None; m * n], along_t: vec![None; m * n] };
        for (i, j) in places() {
            let here = grid.index(i, j);
            for (d, place) in next(i, j).into_iter().enumerate() {
                let Some((i1, j1)) = place else { continue };
                let (start, end) = (skin.vertices[here], skin.vertices[grid.index(i1, j1)]);
                if start == end {
                    continue;
                }
                let edge = self.edge(start, end, net.edge((i, j), (i1, j1))?);
                let edge = Some(FaceEdge { edge, forward: true });
                if d == 0 {
                    skin.along_s[here] = edge;
                } else {
                    skin.along_t[here] = edge;
                }
            }
        }
        Ok(skin)
    }

    /// Adds the vertices and edges of the patches of one of several nets, whose vertices have these numbers in their mesh.
    fn joined_frame(&mut self, net: &CyclidicNet, of_mesh: &[Option<usize>], joined: &mut Joined) -> Result<Skin> {
        let grid = net.grid();
        let [m, n] = grid.size();
        let mut skin = Skin { vertices: vec![0; m * n], along_s: vec![None; m * n], along_t: vec![None; m * n] };
        for ([i, j], _) in net.patches_with_quads() {
            for k in grid.corners(i, j) {
                skin.vertices[k] = joined.vertex(of_mesh[k], || self.vertex(grid.points()[k]));
            }
        }
        for (i, j) in (0..n).flat_map(|j| (0..m).map(move |i| (i, j))) {
            let here = grid.index(i, j);
            for (d, (i1, j1)) in [(i + 1, j), (i, j + 1)].into_iter().enumerate() {
                if !grid.patches_beside([i, j], d).contains(&true) {
                    continue;
                }
                let there = grid.index(i1, j1);
                let (Some(from), Some(to)) = (of_mesh[here], of_mesh[there]) else { continue };
                let ends = [skin.vertices[here], skin.vertices[there]];
                let edge = joined.edge([from, to], || Ok(self.edge(ends[0], ends[1], net.edge((i, j), (i1, j1))?)))?;
                if d == 0 {
                    skin.along_s[here] = Some(edge);
                } else {
                    skin.along_t[here] = Some(edge);
                }
            }
        }
        Ok(skin)
    }
}

impl NetLayout {
    /// The nets as one shell: nets that join share their edges. The outer side is that of `f_s × f_t`; of a shell that is closed it is
    /// the outside, but one with extraordinary vertices has openings.
    ///
    /// # Errors
    /// As [`CyclidicNet::to_shell`].
    pub fn to_shell(&self) -> Result<Shell> {
        let mut sewing = Sewing::default();
        sewing.skins(self, true)?;
        sewing.finish()
    }

    /// The arcs of all edges, each once.
    ///
    /// # Errors
    /// As [`to_shell`](Self::to_shell).
    pub fn support_arcs(&self) -> Result<Vec<Arc>> {
        let mut sewing = Sewing::default();
        sewing.skins(self, true)?;
        Ok(sewing.edges.iter().filter_map(|edge| edge.curve.arc().copied()).collect())
    }
}

impl CyclidicNet {
    /// The arc between two neighboring vertices.
    fn edge(&self, from: (usize, usize), to: (usize, usize)) -> Result<Arc> {
        let inverse = self.weight(from.0, from.1).inverse().ok_or(ArcError::ZeroWeight { index: 0 })?;
        let ratio = self.weight(to.0, to.1) * inverse;
        Arc::from_ratio_across(self.grid().point(from.0, from.1), self.grid().point(to.0, to.1), ratio)
    }

    /// The net as one shell: every inner edge has two faces, and a direction that is closed is sewn together. The
    /// outer side is that of `f_s × f_t`; of a shell that is closed it is the outside.
    ///
    /// # Errors
    /// As [`Arc::from_weights`], only beyond the range of the kernel's numbers; `not-a-shell` for an offset that hangs
    /// together in nodes only, which are vertices: see [`to_shells`](Self::to_shells).
    pub fn to_shell(&self) -> Result<Shell> {
        let mut sewing = Sewing::default();
        sewing.skin(self, true)?;
        sewing.finish().map(outside_out)
    }

    /// The net as shells that do not hang together: one, unless it has nodes, as offsets may. At a node, be it a vertex or
    /// inside patches, which are cut there, a closed net falls apart into [`lobes`](Shell::lobes) that touch; an open
    /// one falls apart where a node is a vertex.
    ///
    /// # Errors
    /// As [`Arc::from_weights`] and [`Shell::with_regular_faces`], only beyond the range of the kernel's numbers.
    pub fn to_shells(&self) -> Result<Vec<Shell>> {
        let mut sewing = Sewing::default();
        sewing.skin(self, true)?;
        let mut shells = Vec::new();
        for (shell, _) in sewing.finish_apart()? {
            shells.extend(outside_out(shell).into_lobes()?);
        }
        Ok(shells)
    }

    /// The arcs of all edges, each once: first those along s, then those along t, each s fastest. Sides of one point
    /// are left out.
    ///
    /// # Errors
    /// As [`to_shell`](Self::to_shell).
    pub fn support_arcs(&self) -> Result<Vec<Arc>> {
        let mut sewing = Sewing::default();
        let skin = sewing.frame_of(self)?;
        let edges = skin.along_s.iter().chain(&skin.along_t).flatten();
        Ok(edges.filter_map(|side| sewing.edges[side.edge].curve.arc().copied()).collect())
    }
}

impl DupinCyclide {
    /// The solids that the cyclide bounds: one for a ring, for a horn two that touch in the nodes, for a spindle the
    /// inner and the outer one. Each is one closed shell, outside outwards; the nodes of different solids are
    /// different vertices at the same place.
    ///
    /// # Errors
    /// As [`nets`](Self::nets).
    pub fn to_bodies(&self, segments: [usize; 2]) -> Result<Vec<Body>> {
        let body = |net: CyclidicNet| Ok(Body { outer: net.to_shell()?, voids: Vec::new() });
        self.nets(segments)?.into_iter().map(body).collect()
    }

    /// The ring cyclide as one closed shell of 4 x 4 patches.
    ///
    /// # Errors
    /// `not-a-shell` for a horn or a spindle, which is more than one: see [`to_bodies`](Self::to_bodies).
    pub fn to_shell(&self) -> Result<Shell> {
        match (self.kind(), self.nets(DEFAULT_SEGMENTS)?.as_slice()) {
            (CyclideKind::Ring, [net]) => net.to_shell(),
            _ => Err(ShellError::NotAShell {
                item: ErrorItem::Vertex,
                index: 0,
                detail: "the cyclide touches itself at its nodes",
            }
            .into()),
        }
    }
}

/// The outer side of a closed shell is the outside.
fn outside_out(shell: Shell) -> Shell {
    if shell.is_closed() { shell.outside_out() } else { shell }
}
