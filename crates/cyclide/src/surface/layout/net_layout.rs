//! Nets over the grids of a mesh that are one smooth surface.

use super::lengths::lengths;
use super::{LayoutPiece, QuadLayout, RoundClosing};
use crate::base::svd3;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{Error, GridError, PartError, PatchError, Result};
use crate::surface::CyclidicNet;
use crate::surface::net::closing_limit;
use crate::surface::net::{apply, carried_back, first_vertex, preferred, signs, stretches};
use std::collections::{HashMap, VecDeque};

/// Nets of principal patches over the grids of a [`QuadLayout`]: neighboring nets share their border arcs with their parameters, and have one
/// tangent plane along them. Round each extraordinary vertex an opening is left.
///
/// ```
/// use cyclide::{Point3, surface::{NetLayout, QuadLayout}};
/// let points: Vec<_> = (0..6).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
/// let net = NetLayout::new(QuadLayout::new(points, &[[0, 1, 4, 3], [1, 2, 5, 4]])?)?;
/// assert!((net.to_shell()?.area() - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct NetLayout {
    layout: QuadLayout,
    /// The net of each piece.
    nets: Vec<CyclidicNet>,
}

/// How the frame of a piece follows from that at the base: its k-th vector is `sign_k map(v_role_k)`.
#[derive(Debug, Clone, Copy)]
struct Carried {
    /// Images of the axes.
    map: [Vec3; 3],
    role: [usize; 3],
    sign: [f64; 3],
}

impl NetLayout {
    /// The nets over a layout whose quads are embedded and concircular and which closes round its extraordinary vertices, as
    /// `make_layout_circular` of the crate `cyclide-grids` makes it. Of the frames with which it closes it takes the one nearest to the edges.
    ///
    /// # Errors
    /// Those of [`CyclidicNet::new`] with an automatic frame, quads counted in the mesh; `ring-does-not-close` with an extraordinary vertex round
    /// which the frame comes back turned.
    pub fn new(layout: QuadLayout) -> Result<Self> {
        layout.check_place()?;
        let carried = carried(&layout)?;
        let mut kappa = Vec::new();
        for piece in layout.pieces() {
            let all = stretches(&piece.grid).map_err(|e| of_mesh(piece, e))?;
            kappa.extend(piece.grid.all_quads().map(|[i, j]| all[i + j * piece.grid.quads()[0]]));
        }
        let closing = RoundClosing::new(&layout);
        let (angle, at) = closing.angle(layout.points());
        let limit = layout.pieces().iter().map(|piece| closing_limit(&piece.grid)).fold(0.0, f64::max);
        if !(angle <= limit) {
            return Err(GridError::RingDoesNotClose { vertex: layout.round()[at].vertex, angle, limit }.into());
        }
        let frame = frame(&layout, &carried, closing.normal(layout.points()))?;
        let lengths = lengths(&layout, &kappa);
        let net = |(piece, carried): (&LayoutPiece, &Carried)| {
            let vector = |k: usize| apply(carried.map, frame[carried.role[k]]) * carried.sign[k];
            let of_piece: Vec<f64> = piece.vertices.iter().map(|v| v.map_or(0.0, |v| lengths[v])).collect();
            let net = CyclidicNet::with_lengths(piece.grid.clone(), [vector(0), vector(1)], &of_piece);
            net.map_err(|e| of_mesh(piece, e))
        };
        let nets = layout.pieces().iter().zip(&carried).map(net).collect::<Result<_>>()?;
        Ok(Self { layout, nets })
    }

    /// The mesh and its grids.
    #[must_use]
    pub fn layout(&self) -> &QuadLayout {
        &self.layout
    }

    /// The nets of its pieces.
    #[must_use]
    pub fn nets(&self) -> &[CyclidicNet] {
        &self.nets
    }

    /// How far the normals of the nets are from those of the mesh, the mean directions of its quads: the root mean square over the vertices, radians.
    /// A few hundredths where the nets follow the mesh; a mesh whose quads have circles but bend round no extraordinary vertex, as the
    /// corner of a box, gets patches that bulge.
    #[must_use]
    pub fn tilt(&self) -> f64 {
        let normals = self.layout.normals(self.layout.points());
        let (mut squares, mut count) = (0.0, 0usize);
        for (piece, net) in self.layout.pieces().iter().zip(&self.nets) {
            let columns = net.grid().size()[0];
            for (place, v) in piece.vertices.iter().enumerate() {
                let Some(normal) = v.and_then(|v| normals[v]) else { continue };
                squares += normal.angle(net.vertex_frame(place % columns, place / columns)[2]).powi(2);
                count += 1;
            }
        }
        (squares / count.max(1) as f64).sqrt()
    }

    /// The nets at the signed distance `h` along the normals: see [`CyclidicNet::offset`].
    ///
    /// # Errors
    /// As [`CyclidicNet::offset`].
    pub fn offset(&self, h: f64) -> Result<Self> {
        let nets = self.layout.pieces().iter().zip(&self.nets);
        self.of_nets(nets.map(|(piece, net)| net.offset(h).map_err(|e| of_mesh(piece, e))).collect::<Result<_>>()?)
    }

    /// Nets of the same pieces: vertices that two of them share are those of the first, bit for bit.
    fn of_nets(&self, nets: Vec<CyclidicNet>) -> Result<Self> {
        let mut points: Vec<Option<Point3>> = vec![None; self.layout.points().len()];
        for (piece, net) in self.layout.pieces().iter().zip(&nets) {
            for (v, p) in piece.vertices.iter().zip(net.grid().points()) {
                if let Some(v) = v {
                    points[*v].get_or_insert(*p);
                }
            }
        }
        // The extraordinary vertices themselves stay: nothing hangs on them.
        let points = points.into_iter().zip(self.layout.points()).map(|(moved, old)| moved.unwrap_or(*old)).collect();
        let layout = self.layout.with_points(points)?;
        let pieces = layout.pieces().iter().zip(nets);
        let nets = pieces.map(|(piece, net)| net.over(piece.grid.clone())).collect();
        Ok(Self { layout, nets })
    }
}

impl Conformal for NetLayout {
    /// The images of the nets.
    ///
    /// # Errors
    /// Those of nets.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let nets = self.layout.pieces().iter().zip(&self.nets);
        let image = |(piece, net): (&LayoutPiece, &CyclidicNet)| net.transformed(map).map_err(|e| of_mesh(piece, e));
        self.of_nets(nets.map(image).collect::<Result<_>>()?)
    }
}

/// An error about a quad of a piece, as one about that of the mesh.
fn of_mesh(piece: &LayoutPiece, error: Error) -> Error {
    match error {
        Error::Part(PartError::InQuad { quad, cause }) => {
            cause.in_quad(piece.quads.get(quad).copied().flatten().unwrap_or(quad))
        }
        other => other,
    }
}

/// The frame at the base: that with the normal, if there is one, which suits the edges best.
fn frame(layout: &QuadLayout, carried: &[Carried], normal: Option<Vec3>) -> Result<[Vec3; 3]> {
    let mut sum = [Vec3::ZERO; 3];
    for (piece, carried) in layout.pieces().iter().zip(carried) {
        let wanted = preferred(&piece.grid, &carried_back(&piece.grid));
        for k in 0..3 {
            // Back through the map, which is orthogonal.
            let back = Vec3::from(carried.map.map(|image| image.dot(wanted[k])));
            sum[carried.role[k]] += back * carried.sign[k];
        }
    }
    let Some(normal) = normal else {
        return svd3::nearest_rotation(sum)
            .map_err(|measured| Error::Patch(PatchError::AmbiguousFrame { measured, limit: svd3::UNIQUE }));
    };
    // v1 · g1 + v2 · g2 with v2 = N × v1.
    let along = sum[0] + sum[1].cross(normal);
    let v1 = (along - normal * along.dot(normal)).unit();
    let v1 = v1.ok_or(PatchError::AmbiguousFrame { measured: 0.0, limit: svd3::UNIQUE })?;
    Ok([v1, normal.cross(v1), normal])
}

/// How the frame at the first vertex of each piece follows from that of the first piece.
fn carried(layout: &QuadLayout) -> Result<Vec<Carried>> {
    let pieces = layout.pieces();
    // The pieces at each vertex of the mesh, with the place in them.
    let mut at_vertex: HashMap<usize, Vec<(usize, usize)>> = HashMap::new();
    for (k, piece) in pieces.iter().enumerate() {
        for (place, v) in piece.vertices.iter().enumerate().filter_map(|(place, v)| Some((place, (*v)?))) {
            at_vertex.entry(v).or_default().push((k, place));
        }
    }
    let back: Vec<Vec<[Vec3; 3]>> = pieces.iter().map(|piece| carried_back(&piece.grid)).collect();
    let mut carried: Vec<Option<Carried>> = vec![None; pieces.len()];
    carried[0] = Some(Carried { map: [Vec3::X, Vec3::Y, Vec3::Z], role: [0, 1, 2], sign: [1.0; 3] });
    let mut open = VecDeque::from([0]);
    while let Some(from) = open.pop_front() {
        let Some(here) = carried[from] else { continue };
        for (place, v) in pieces[from].vertices.iter().enumerate().filter_map(|(place, v)| Some((place, (*v)?))) {
            for &(to, other) in &at_vertex[&v] {
                if carried[to].is_some() {
                    continue;
                }
                let Some(turn) = turn(&pieces[from], place, &pieces[to], other) else { continue };
                carried[to] = Some(follow(here, (pieces, from, place), (to, other), &back, turn));
                open.push_back(to);
            }
        }
    }
    carried
        .into_iter()
        .collect::<Option<Vec<_>>>()
        .ok_or(Error::Patch(PatchError::AmbiguousFrame { measured: 0.0, limit: svd3::UNIQUE }))
}

/// The frame of a piece from that of one that it shares a vertex with, of which `turn` quarter turns bring the directions to its own.
fn follow(
    here: Carried,
    (pieces, from, place): (&[LayoutPiece], usize, usize),
    (to, other): (usize, usize),
    back: &[Vec<[Vec3; 3]>],
    turn: usize,
) -> Carried {
    let signs_at = |piece: usize, place: usize| {
        let grid = &pieces[piece].grid;
        signs(grid.size()[0], first_vertex(grid), place)
    };
    let (there, back_there) = (signs_at(from, place), back[from][place]);
    let (mine, back_mine) = (signs_at(to, other), back[to][other]);
    // At the shared vertex: the transpose of what carries back.
    let forth = |x: Vec3| Vec3::from(back_there.map(|image| image.dot(x)));
    let map = here.map.map(|image| apply(back_mine, forth(image)));
    // Its s is the other's s, t, -s, -t after so many quarter turns.
    let turned = [[(0, 1.0), (1, 1.0)], [(1, 1.0), (0, -1.0)], [(0, -1.0), (1, -1.0)], [(1, -1.0), (0, 1.0)]][turn];
    let (mut role, mut sign) = (here.role, here.sign);
    for k in 0..2 {
        let (old, factor) = turned[k];
        role[k] = here.role[old];
        sign[k] = here.sign[old] * there[old] * factor * mine[k];
    }
    sign[2] = here.sign[2] * there[2] * mine[2];
    Carried { map, role, sign }
}

/// The quarter turns from the directions of a piece to those of another one, by an edge that both have at a shared vertex.
fn turn(from: &LayoutPiece, place: usize, to: &LayoutPiece, other: usize) -> Option<usize> {
    let ways = |piece: &LayoutPiece, place: usize| {
        let size = piece.grid.size();
        let at = [place % size[0], place / size[0]];
        let way = |quarter: usize| {
            let (d, forward) = (quarter % 2, quarter < 2);
            let mut next = at;
            if forward {
                next[d] = at[d] + 1;
            } else {
                next[d] = at[d].checked_sub(1)?;
            }
            if next[d] >= size[d] || !piece.grid.has_edge(if forward { at } else { next }, d) {
                return None;
            }
            piece.vertices[next[0] + next[1] * size[0]]
        };
        [0, 1, 2, 3].map(way)
    };
    let (from, to) = (ways(from, place), ways(to, other));
    // The way that is number k there is number l here: s there is l - k quarter turns on.
    (0..4).find_map(|k| {
        let l = (0..4).find(|l| from[*l].is_some() && from[*l] == to[k])?;
        Some((l + 4 - k) % 4)
    })
}
