//! A structured grid from a mesh of quads: the rows and columns are found from the connections alone.

use std::collections::HashMap;

use cyclide::{
    Error, ShortNumber,
    error::{GridError, LayoutFault},
    surface::{QuadGrid, QuadLayout},
};

use super::polygons::{Normals, Polygon, Polygons, parse};
use crate::input::exported_faces::{Doubled, turned_over};
use crate::input::triangle_mesh::distinct;
use crate::text::lines::LineStarts;
use crate::text::place::{Diagnostic, Source, decode};

/// Vertices nearer to each other than this part of the edges beside them are probably meant to be one.
const NEARLY: f64 = 0.01;

/// A quad grid read from a file.
///
/// ```
/// let quads = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
/// let read = cyclide_io::formats::read_quad_grid("a.obj", quads)?;
/// assert_eq!(read.grid.size(), [2, 2]);
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ObjGrid {
    /// The grid: a rectangle, a part of a rectangle with a stepped border, a tube (closed in one direction) or a torus
    /// (closed in both).
    pub grid: QuadGrid,
    /// Number in the file, from 1, of each point of the grid; 0 for points missing at a stepped border.
    pub numbers: Vec<usize>,
    /// Numbers of the points that no face uses, which are ignored.
    pub unused: Vec<usize>,
    /// The repairs.
    pub mended: MendedQuads,
}

/// A mesh of quads with extraordinary vertices, read from a file.
///
/// ```
/// use cyclide_io::formats::{ObjQuads, read_quads};
/// let quads = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
/// assert!(matches!(read_quads("a.obj", quads)?, ObjQuads::Grid(_))); // it has none
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ObjLayout {
    /// Its regular grids; vertices and quads are numbered as in the file, from 0.
    pub layout: QuadLayout,
    /// Numbers in the file, from 1, of the points that no face uses.
    pub unused: Vec<usize>,
    /// The repairs.
    pub mended: MendedQuads,
}

/// Repairs of the quads as exported by a program.
///
/// ```
/// // Two quads, each with vertices of its own; the second is seen from below.
/// let quads = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 1 2 3 4\nf 8 7 6 5\n";
/// let read = cyclide_io::formats::read_quad_grid("a.obj", quads)?;
/// assert_eq!((read.grid.size(), read.mended.merged, read.mended.turned), ([3, 2], 2, vec![10]));
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct MendedQuads {
    /// Vertices that coincide with another one and were merged.
    pub merged: usize,
    /// Lines of the quads with the opposite orientation to most of their neighbors, which were reversed.
    pub turned: Vec<usize>,
}

/// The structure of the quads of a file.
///
/// ```
/// let triangle = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
/// let message = cyclide_io::formats::read_quads("a.obj", triangle).unwrap_err().to_string();
/// assert!(message.contains("not a quad: a `principal-grid` computes a grid of quads"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum ObjQuads {
    /// A regular grid.
    Grid(ObjGrid),
    /// Several regular grids that join around extraordinary vertices.
    Layout(ObjLayout),
}

/// Reads a grid of quads from the bytes of an OBJ file; `name` is used in messages.
///
/// s runs along the first side of the first face (from its first to its second corner) and t along its last side (from
/// the first to the fourth corner), so that `s × t` is the side from which that face is counter-clockwise. Vertex (0, 0)
/// is reached from the first corner by walking back along s and then along t; in a closed direction it stays there.
///
/// ```
/// let quads = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
/// let read = cyclide_io::formats::read_quad_grid("a.obj", quads)?;
/// assert_eq!(read.grid.size(), [2, 2]);
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
///
/// # Errors
/// Those of [`read_quads`], and `extraordinary-vertex` (an inner vertex without four quads).
pub fn read_quad_grid(name: &str, bytes: &[u8]) -> Result<ObjGrid, Box<Diagnostic>> {
    read(name, bytes, |mesh| match mesh.check_vertices()? {
        Some((vertex, quads)) => {
            let message =
                format!("point {} is an inner vertex of {quads} quads: inner vertices of a grid have 4", vertex + 1);
            Err(mesh.refused_at_vertex(vertex, "extraordinary-vertex", message))
        }
        None => mesh.grid(),
    })
}

/// Reads a mesh of quads from the bytes of an OBJ file, regular or with extraordinary vertices, as [`read_quad_grid`].
///
/// ```
/// use cyclide_io::formats::{ObjQuads, read_quads};
/// let quads = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
/// assert!(matches!(read_quads("a.obj", quads)?, ObjQuads::Grid(_)));
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
///
/// # Errors
/// A message with file, line and column, and a reason: `not-a-quad`, `non-manifold-edge`, `non-manifold-vertex`,
/// `several-components`, `extraordinary-vertex` (a vertex of the border with more than three quads, or an inner one without four whose quads reach the border or those
/// of another one, or of a mesh with holes),
/// `not-a-grid` (one-sided, closed with a shift, or over itself), `cells-unfit` (a hole: fill it, and leave its quads open), and the kernel's for points out of range and closed directions of
/// fewer than three quads.
pub fn read_quads(name: &str, bytes: &[u8]) -> Result<ObjQuads, Box<Diagnostic>> {
    read(name, bytes, |mesh| {
        if mesh.check_vertices()?.is_none() {
            return mesh.grid().map(ObjQuads::Grid);
        }
        let layout = mesh.layout_of_pieces()?;
        Ok(ObjQuads::Layout(ObjLayout { layout, unused: mesh.unused(), mended: mesh.mended.clone() }))
    })
}

/// What a mesh is taken for.
type Taken<T> = Result<T, Box<Diagnostic>>;

/// Reads quads as they are in the file where that makes a mesh: sheets may touch, and a seam may be cut on purpose. Elsewhere vertices at
/// one position are one vertex.
fn read<T>(name: &str, bytes: &[u8], take: impl Fn(&Mesh<'_>) -> Taken<T>) -> Taken<T> {
    let source = Source { name, text: decode(name, bytes)? };
    let polygons = parse(source, Normals::PassOver)?;
    let (points, same) = distinct(&polygons.points);
    let of_mesh = |vertex_of: &[usize], merged| {
        let mesh = Mesh::new(source, &polygons, vertex_of, merged)?;
        mesh.check_connected()?;
        take(&mesh)
    };
    let own: Vec<usize> = (0..same.len()).collect();
    let mut first_of = vec![usize::MAX; points.len()];
    same.iter().enumerate().rev().for_each(|(given, &point)| first_of[point] = given);
    let welded: Vec<usize> = same.iter().map(|point| first_of[*point]).collect();
    let merged = polygons.points.len() - points.len();
    match of_mesh(&own, 0) {
        Err(_) if merged > 0 => of_mesh(&welded, merged),
        taken => taken,
    }
}

/// The vertices of a grid, s fastest.
struct Layout {
    vertices: Vec<usize>,
    size: [usize; 2],
    closed: [bool; 2],
}

/// A face with its corners named as the grid names them: a0 (0,0), a1 (1,0), a2 (0,1), a3 (1,1).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Cell {
    face: usize,
    corners: [usize; 4],
}

/// A way across a side of a cell.
#[derive(Debug, Clone, Copy)]
enum Way {
    ForwardS,
    BackS,
    ForwardT,
    BackT,
}

/// Quads that meet two by two along their sides.
struct Mesh<'a> {
    source: Source<'a>,
    polygons: &'a Polygons,
    quads: Vec<[usize; 4]>,
    /// The one or two faces at each side.
    sides: HashMap<[usize; 2], (usize, Option<usize>)>,
    mended: MendedQuads,
}

fn side(a: usize, b: usize) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

fn sides_of(quad: [usize; 4]) -> [[usize; 2]; 4] {
    [0, 1, 2, 3].map(|k| side(quad[k], quad[(k + 1) % 4]))
}

impl<'a> Mesh<'a> {
    /// `vertex_of` is the vertex that each point counts as.
    fn new(source: Source<'a>, polygons: &'a Polygons, vertex_of: &[usize], merged: usize) -> Taken<Self> {
        let refused = |face: &Polygon, reason, message: String| {
            Err(source.diagnostic(face.span.clone(), "", message).with_reason(reason))
        };
        if polygons.faces.is_empty() {
            return Err(source.diagnostic(0..0, "", "the file contains no faces"));
        }
        let mut quads: Vec<[usize; 4]> = Vec::with_capacity(polygons.faces.len());
        let mut sides: HashMap<[usize; 2], (usize, Option<usize>)> = HashMap::new();
        for face in &polygons.faces {
            let Ok(quad) = <[usize; 4]>::try_from(face.corners.as_slice()) else {
                let remedy = "a `principal-grid` computes a grid of quads on a mesh of any polygons";
                let message = format!("a face of {} corners, not a quad: {remedy}", face.corners.len());
                return refused(face, "not-a-quad", message);
            };
            let quad = quad.map(|v| vertex_of[v]);
            if (0..4).any(|i| (0..i).any(|j| quad[i] == quad[j])) {
                return refused(face, "not-a-quad", "the face contains a point twice".to_owned());
            }
            quads.push(quad);
        }
        if let Some(doubled) = Doubled::among(&quads) {
            let [first, second] = doubled.faces;
            let line = source.line_of(polygons.faces[first].span.start);
            let message = format!("this face has the same vertices as the one in line {line}{}", doubled.remedy());
            return refused(&polygons.faces[second], "doubled-face", message);
        }
        for (index, (face, quad)) in polygons.faces.iter().zip(&quads).enumerate() {
            for [a, b] in sides_of(*quad) {
                let faces = sides.entry([a, b]).or_insert((index, None));
                match faces {
                    (first, None) if *first == index => {}
                    (_, second @ None) => *second = Some(index),
                    _ => {
                        let message =
                            format!("the edge between points {} and {} belongs to a third face", a + 1, b + 1);
                        return refused(face, "non-manifold-edge", message);
                    }
                }
            }
        }
        let mut mended = MendedQuads { merged, ..MendedQuads::default() };
        let starts = LineStarts::new(source.text);
        let turned = turned_over(&quads).into_iter().zip(&mut quads).zip(&polygons.faces);
        for ((_, quad), face) in turned.filter(|((turned, _), _)| *turned) {
            quad.swap(1, 3);
            mended.turned.push(starts.line_of(face.span.start));
        }
        Ok(Self { source, polygons, quads, sides, mended })
    }

    fn refused(&self, face: usize, reason: &'static str, message: impl Into<String>) -> Box<Diagnostic> {
        self.source.diagnostic(self.polygons.faces[face].span.clone(), "", message).with_reason(reason)
    }

    fn refused_at_vertex(&self, vertex: usize, reason: &'static str, message: String) -> Box<Diagnostic> {
        self.source.diagnostic(self.polygons.spans[vertex].clone(), "", message).with_reason(reason)
    }

    /// The kernel's refusal, at the point it speaks of.
    fn refused_by_kernel(&self, error: &Error, corners: &[usize]) -> Box<Diagnostic> {
        let span = error.index().and_then(|k| corners.get(k)).map(|&v| self.polygons.spans[v].clone());
        self.source.diagnostic(span.unwrap_or(0..0), "", error.to_string()).with_reason(error.reason())
    }

    /// The face on the other side.
    fn across(&self, face: usize, side: [usize; 2]) -> Option<usize> {
        match *self.sides.get(&side)? {
            (first, Some(second)) => Some(if first == face { second } else { first }),
            (_, None) => None,
        }
    }

    /// How far the corners of a face are from the nearest vertices of others, if that is next to nothing beside its edges.
    fn gap_beside(&self, face: usize) -> Option<f64> {
        let (points, corners) = (&self.polygons.points, self.quads[face]);
        let shortest =
            sides_of(corners).into_iter().map(|[a, b]| points[a].distance(points[b])).fold(f64::INFINITY, f64::min);
        let others = || self.quads.iter().flatten().filter(|vertex| !corners.contains(vertex));
        let nearest =
            |corner: usize| others().map(|v| points[*v].distance(points[corner])).fold(f64::INFINITY, f64::min);
        let near: Vec<f64> = corners.map(nearest).into_iter().filter(|gap| *gap < NEARLY * shortest).collect();
        // An edge at least.
        (near.len() > 1).then(|| near.into_iter().fold(0.0, f64::max))
    }

    fn check_connected(&self) -> Result<(), Box<Diagnostic>> {
        let mut reached = vec![false; self.quads.len()];
        let mut open = vec![0];
        reached[0] = true;
        while let Some(face) = open.pop() {
            for next in sides_of(self.quads[face]).into_iter().filter_map(|side| self.across(face, side)) {
                if !std::mem::replace(&mut reached[next], true) {
                    open.push(next);
                }
            }
        }
        match reached.iter().position(|reached| !reached) {
            Some(face) => {
                let message = match self.gap_beside(face) {
                    Some(gap) => format!(
                        "this face is not connected to the first one through edges, but its corners are within {} of those of other faces: they are probably the same points; merge vertices within {} of each other in the program that has written the mesh (only coincident vertices count as one here)",
                        ShortNumber(gap),
                        ShortNumber(2.0 * gap)
                    ),
                    None => "this face is not connected to the first one through edges: join the components, or use a separate file and net for each (coincident vertices count as one)".to_owned(),
                };
                Err(self.refused(face, "several-components", message))
            }
            None => Ok(()),
        }
    }

    /// Refuses vertices at which parts of the mesh touch, and those of the border of more than three quads; the first inner one without
    /// four, with the number of its quads.
    fn check_vertices(&self) -> Result<Option<(usize, usize)>, Box<Diagnostic>> {
        let mut quads = vec![0usize; self.polygons.points.len()];
        let mut border_edges = vec![0usize; quads.len()];
        for (face, quad) in self.quads.iter().enumerate() {
            quad.iter().for_each(|&v| quads[v] += 1);
            for [a, b] in sides_of(*quad) {
                if self.across(face, [a, b]).is_none() {
                    border_edges[a] += 1;
                    border_edges[b] += 1;
                }
            }
        }
        for (v, (&quads, &border)) in quads.iter().zip(&border_edges).enumerate() {
            let number = v + 1;
            if border > 2 {
                let message = format!("parts of the mesh touch only at point {number}");
                return Err(self.refused_at_vertex(v, "non-manifold-vertex", message));
            }
            if border == 2 && quads > 3 {
                let message = format!(
                    "point {number} is a border vertex of {quads} quads: border vertices of a grid have 1 to 3"
                );
                return Err(self.refused_at_vertex(v, "extraordinary-vertex", message));
            }
        }
        let mut inner = quads.into_iter().zip(border_edges).enumerate();
        Ok(inner.find(|(_, (quads, border))| *border == 0 && ![0, 4].contains(quads)).map(|(v, (quads, _))| (v, quads)))
    }

    /// Numbers of the points that no face uses.
    fn unused(&self) -> Vec<usize> {
        let mut used = vec![false; self.polygons.points.len()];
        self.polygons.faces.iter().flat_map(|face| &face.corners).for_each(|v| used[*v] = true);
        (0..used.len()).filter(|v| !used[*v]).map(|v| v + 1).collect()
    }

    /// A mesh without extraordinary vertices.
    fn grid(&self) -> Result<ObjGrid, Box<Diagnostic>> {
        if self.is_in_steps() {
            let layout = self.layout_of_pieces()?;
            // Without extraordinary vertices nothing cuts it.
            let piece = &layout.pieces()[0];
            let numbers = piece.vertices.iter().map(|v| v.map_or(0, |v| v + 1)).collect();
            return Ok(ObjGrid {
                grid: piece.grid.clone(),
                numbers,
                unused: self.unused(),
                mended: self.mended.clone(),
            });
        }
        let Layout { vertices, size, closed } = self.layout()?;
        let points = vertices.iter().map(|&v| self.polygons.points[v]).collect();
        let grid = QuadGrid::new(points, size, closed).map_err(|error| self.refused_by_kernel(&error, &vertices))?;
        Ok(ObjGrid {
            grid,
            numbers: vertices.into_iter().map(|v| v + 1).collect(),
            unused: self.unused(),
            mended: self.mended.clone(),
        })
    }

    /// The regular grids of the mesh.
    fn layout_of_pieces(&self) -> Result<QuadLayout, Box<Diagnostic>> {
        QuadLayout::new(self.polygons.points.clone(), &self.quads).map_err(|error| match error {
            Error::Grid(GridError::NotAQuadLayout { fault: fault @ (LayoutFault::Crowded | LayoutFault::Holes), index }) => {
                let what = match fault {
                    LayoutFault::Holes => "of a mesh with holes or of a tube: fill the holes with quads or extend them to the border, or cut the tube open",
                    _ => "whose quads reach the border or the quads of another such vertex: divide every quad into four or nine",
                };
                let message = format!("point {} is an extraordinary vertex (an inner vertex without four quads) {what}", index + 1);
                self.refused_at_vertex(index, "extraordinary-vertex", message)
            }
            Error::Grid(GridError::NotAQuadLayout { index, .. }) => self.not_a_grid(index.min(self.quads.len() - 1)),
            Error::Grid(GridError::CellsUnfit { .. }) => self.refused_in_steps(&error),
            other => self.refused_by_kernel(&other, &(0..self.polygons.points.len()).collect::<Vec<_>>()),
        })
    }

    /// The cell next to one.
    fn step(&self, cell: Cell, way: Way) -> Option<Cell> {
        let [a0, a1, a2, a3] = cell.corners;
        let (p, q) = match way {
            Way::ForwardS => (a1, a3),
            Way::BackS => (a0, a2),
            Way::ForwardT => (a2, a3),
            Way::BackT => (a0, a1),
        };
        let face = self.across(cell.face, side(p, q))?;
        let quad = self.quads[face];
        let at = quad.iter().position(|v| *v == p)?;
        // The corner next to p that is not q, and the one next to q.
        let (next, before) = ((at + 1) % 4, (at + 3) % 4);
        let beside = if quad[next] == q { before } else { next };
        let (r, t) = (quad[beside], quad[(at + 2) % 4]);
        let corners = match way {
            Way::ForwardS => [p, r, q, t],
            Way::BackS => [r, p, t, q],
            Way::ForwardT => [p, q, r, t],
            Way::BackT => [r, t, p, q],
        };
        Some(Cell { face, corners })
    }

    /// The last cell on a way, or `None` if the way comes back to the start.
    fn end(&self, start: Cell, way: Way) -> Result<Option<Cell>, Box<Diagnostic>> {
        let mut cell = start;
        // A way through a grid visits a face once; one-sided or shifted ones come back in another place.
        for _ in 0..self.quads.len() {
            match self.step(cell, way) {
                None => return Ok(Some(cell)),
                Some(next) if next == start => return Ok(None),
                Some(next) => cell = next,
            }
        }
        Err(self.not_a_grid(start.face))
    }

    fn not_a_grid(&self, face: usize) -> Box<Diagnostic> {
        let message =
            "the rows through this face do not close: the mesh is one-sided, closed with a shift, or overlaps itself";
        self.refused(face, "not-a-grid", message)
    }

    /// The kernel's refusal of a part of a rectangle.
    fn refused_in_steps(&self, error: &Error) -> Box<Diagnostic> {
        let message = match error {
            Error::Grid(GridError::CellsUnfit { fault: cyclide::error::GridCellFault::Enclosed, .. }) => {
                "the mesh has a hole: fill it with quads and list them in `openings` of the net".to_owned()
            }
            _ => error.to_string(),
        };
        self.source.diagnostic(0..0, "", message).with_reason(error.reason())
    }

    /// True if the border has inward corners.
    fn is_in_steps(&self) -> bool {
        let mut quads = vec![0usize; self.polygons.points.len()];
        self.quads.iter().flatten().for_each(|v| quads[*v] += 1);
        quads.contains(&3)
    }

    /// Finds the rows and columns.
    fn layout(&self) -> Result<Layout, Box<Diagnostic>> {
        let [a0, a1, a3, a2] = self.quads[0];
        let first = Cell { face: 0, corners: [a0, a1, a2, a3] };
        let back_s = self.end(first, Way::BackS)?;
        let corner = back_s.unwrap_or(first);
        let back_t = self.end(corner, Way::BackT)?;
        let closed = [back_s.is_none(), back_t.is_none()];
        let origin = back_t.unwrap_or(corner);

        let mut vertices = Vec::new();
        let mut used = vec![false; self.polygons.points.len()];
        let mut last_row = Vec::new();
        let (mut size, mut rows, mut faces) = (None, 0, 0);
        let mut row = origin;
        loop {
            let mut line = Vec::new();
            let mut upper = Vec::new();
            let mut cell = row;
            loop {
                line.push(cell.corners[0]);
                upper.push(cell.corners[2]);
                faces += 1;
                match self.step(cell, Way::ForwardS) {
                    Some(next) if next == row && closed[0] => break,
                    // A row that goes on for ever is caught by the count of faces.
                    Some(next) if faces <= self.quads.len() => cell = next,
                    Some(_) => return Err(self.not_a_grid(row.face)),
                    None => {
                        line.push(cell.corners[1]);
                        upper.push(cell.corners[3]);
                        break;
                    }
                }
            }
            if *size.get_or_insert(line.len()) != line.len() {
                return Err(self.not_a_grid(row.face));
            }
            vertices.extend(line);
            rows += 1;
            match self.step(row, Way::ForwardT) {
                Some(next) if next == origin && closed[1] => break,
                Some(next) if faces <= self.quads.len() => row = next,
                Some(_) => return Err(self.not_a_grid(row.face)),
                None => {
                    last_row = upper;
                    break;
                }
            }
        }
        rows += usize::from(!last_row.is_empty());
        vertices.extend(last_row);
        let repeated = vertices.iter().any(|&v| std::mem::replace(&mut used[v], true));
        if repeated || faces != self.quads.len() {
            return Err(self.not_a_grid(origin.face));
        }
        Ok(Layout { vertices, size: [size.unwrap_or_default(), rows], closed })
    }
}
