//! A net, or nets that join, measured as they are built: panels, the edges between them, and the nodes where these meet.

use std::collections::HashMap;

use cyclide::{
    Point3, Result, Vec3,
    curve::{Arc, CORNER_ANGLE},
    panel::PanelMeasures,
    surface::{CyclidePatch, NormalStrip, PatchKind},
    topology::{FaceEdge, Shell, Side, surface_joints},
};

use super::skin::Skin;

/// Angle from the direction of growing s at which the edges round a node begin: that along s is the first, and rounding
/// does not turn it to the end.
const FIRST: f64 = -0.25 * std::f64::consts::PI;

/// A net, or nets that join, with what belongs to each of its parts. What two pieces share is that of the first.
#[derive(Debug)]
pub(super) struct Net {
    /// What it is called in the schedule.
    pub(super) name: String,
    /// The nets that it is made of.
    pub(super) pieces: Vec<Piece>,
    pub(super) panels: Vec<Panel>,
    pub(super) edges: Vec<Edge>,
    pub(super) nodes: Vec<Node>,
    /// Distance of the other side of its panels along the normals.
    pub(super) thickness: Option<f64>,
    /// Distance along the normals to which beams reach from the edges.
    pub(super) beam_depth: Option<f64>,
    /// The area by the whole shell: what reports say.
    pub(super) area: f64,
}

/// What one of its nets is called, and how large it is.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    /// What the names of its parts begin with.
    pub(super) name: String,
    /// Panels along s and along t.
    pub(super) size: [usize; 2],
    /// Vertices along s and along t.
    vertices: [usize; 2],
}

/// A patch of a net.
#[derive(Debug)]
pub(super) struct Panel {
    /// The number of its net.
    pub(super) piece: usize,
    /// Column and row.
    pub(super) place: [usize; 2],
    pub(super) patch: CyclidePatch,
    pub(super) kind: PatchKind,
    pub(super) measures: PanelMeasures,
    /// Area of the other side.
    pub(super) offset_area: Option<f64>,
    /// The nodes at its corners, binary order.
    pub(super) nodes: [usize; 4],
    /// The edges on its sides.
    pub(super) sides: [Option<FaceEdge>; 4],
}

/// An arc between two nodes.
#[derive(Debug)]
pub(super) struct Edge {
    /// The net of its first panel.
    pub(super) piece: usize,
    /// Column and row of the vertex where it starts.
    pub(super) place: [usize; 2],
    /// 0 along s, 1 along t.
    pub(super) direction: usize,
    pub(super) arc: Arc,
    pub(super) nodes: [usize; 2],
    /// The panels along it; the second is missing at a border.
    pub(super) panels: [Option<usize>; 2],
    /// Angle between the normals of both panels, 0 where reports count no crease.
    pub(super) crease: Option<f64>,
    /// The same edge on the other side of the panels.
    pub(super) offset: Option<Arc>,
    pub(super) strip: Option<NormalStrip>,
}

/// A vertex of a net.
#[derive(Debug)]
pub(super) struct Node {
    /// The first net that has it.
    pub(super) piece: usize,
    /// Column and row.
    pub(super) place: [usize; 2],
    pub(super) point: Point3,
    pub(super) normal: Vec3,
    pub(super) offset: Option<Point3>,
    /// The edges that meet there, counter-clockwise seen against the normal.
    pub(super) beams: Vec<Beam>,
}

/// An edge as it leaves a node.
#[derive(Debug)]
pub(super) struct Beam {
    pub(super) edge: usize,
    /// Unit tangent away from the node.
    pub(super) direction: Vec3,
    /// Angle to the next one, counter-clockwise.
    pub(super) to_next: f64,
    /// Angle out of the plane across the normal.
    pub(super) tilt: f64,
}

impl Net {
    /// Measures a net, or nets that join.
    pub(super) fn new(name: String, skin: &Skin, thickness: Option<f64>, depth: Option<f64>) -> Result<Self> {
        let shell = skin.to_shell()?;
        let other = thickness.map(|h| skin.other_side(h)).transpose()?;
        let pieces = skin.nets().iter().zip(skin.piece_names(&name));
        let pieces = pieces.map(|(net, name)| Piece { name, size: net.size(), vertices: net.grid().size() }).collect();
        let patches = skin.nets().iter().enumerate();
        let patches = patches.flat_map(|(piece, net)| net.patches_with_quads().map(move |found| (piece, found)));
        let mut panels = Vec::with_capacity(shell.faces().len());
        let corners: Vec<[usize; 4]> = shell.faces().iter().map(|face| corner_vertices(&shell, &face.sides)).collect();
        // Faces stand in the order of the patches.
        for (index, (face, (piece, (place, patch)))) in shell.faces().iter().zip(patches).enumerate() {
            let other = other.as_ref().map(|other| &other.nets()[piece]);
            let offset_area = other.map(|other| area(other.patch(place[0], place[1]))).transpose()?;
            let (kind, measures) = (patch.recognize(), PanelMeasures::new(&patch)?);
            let (nodes, sides) = (corners[index], face.sides);
            panels.push(Panel { piece, place, patch, kind, measures, offset_area, nodes, sides });
        }
        let mut made = Self {
            name,
            pieces,
            panels,
            edges: Vec::new(),
            nodes: Vec::new(),
            thickness,
            beam_depth: depth,
            area: shell.known_area()?,
        };
        made.take_nodes(skin, other.as_ref());
        made.take_edges(&shell, other.as_ref())?;
        made.take_beams(skin);
        Ok(made)
    }

    /// The nodes, by the first place in which each is met; those that sides of one point join are one.
    fn take_nodes(&mut self, skin: &Skin, other: Option<&Skin>) {
        // Piece, row and column.
        let mut first: HashMap<usize, [usize; 3]> = HashMap::new();
        for panel in &self.panels {
            for (corner, &vertex) in panel.nodes.iter().enumerate() {
                let at = [panel.place[0] + corner % 2, panel.place[1] + corner / 2];
                let [i, j] = self.pieces[panel.piece].vertex_at(at);
                let place = [panel.piece, j, i];
                let known = first.entry(vertex).or_insert(place);
                *known = place.min(*known);
            }
        }
        let mut order: Vec<(usize, [usize; 3])> = first.into_iter().collect();
        order.sort_by_key(|(_, place)| *place);
        let numbers: HashMap<usize, usize> = order.iter().enumerate().map(|(number, (v, _))| (*v, number)).collect();
        for panel in &mut self.panels {
            panel.nodes = panel.nodes.map(|vertex| numbers[&vertex]);
        }
        let node = |(_, [piece, j, i]): (usize, [usize; 3])| Node {
            piece,
            place: [i, j],
            point: skin.nets()[piece].grid().point(i, j),
            normal: skin.nets()[piece].vertex_frame(i, j)[2],
            offset: other.map(|other| other.nets()[piece].grid().point(i, j)),
            beams: Vec::new(),
        };
        self.nodes = order.into_iter().map(node).collect();
    }

    /// The edges, piece by piece: those along s first, then those along t, each by rows.
    fn take_edges(&mut self, shell: &Shell, other: Option<&Skin>) -> Result<()> {
        let creases: HashMap<usize, f64> =
            surface_joints(shell).into_iter().map(|joint| (joint.edge, joint.angle)).collect();
        let mut order: Vec<(usize, Edge)> = Vec::with_capacity(shell.edges().len());
        for (index, users) in shell.faces_along_edges().iter().enumerate() {
            let (Some(&(face, side)), Some(arc)) = (users.first(), shell.edges()[index].curve.arc()) else { continue };
            let panel = &self.panels[face];
            let forward = panel.sides[side as usize].is_none_or(|use_of| use_of.forward);
            let (piece, [i, j]) = (panel.piece, panel.place);
            let place = self.pieces[piece].vertex_at(match side {
                Side::Bottom | Side::Left => [i, j],
                Side::Top => [i, j + 1],
                Side::Right => [i + 1, j],
            });
            let offset = other.map(|other| side_arc(&other.nets()[piece].patch(i, j), side)).transpose()?;
            let offset = offset.map(|arc| if forward { arc } else { arc.reversed() });
            let (s, t) = side.place(if forward { 0.0 } else { 1.0 });
            let normal = panel.patch.unit_normal(s, t);
            let corners = side.corners().map(|corner| panel.nodes[corner]);
            let nodes = if forward { corners } else { [corners[1], corners[0]] };
            let strip = self.beam_depth.map(|depth| NormalStrip::new(arc, normal, [depth.min(0.0), depth.max(0.0)]));
            let crease = creases.get(&index).map(|angle| if *angle > CORNER_ANGLE { *angle } else { 0.0 });
            let edge = Edge {
                piece,
                place,
                direction: side.direction(),
                arc: *arc,
                nodes,
                panels: [Some(face), users.get(1).map(|user| user.0)],
                crease,
                offset,
                strip: strip.transpose()?,
            };
            order.push((index, edge));
        }
        order.sort_by_key(|(_, edge)| (edge.piece, edge.direction, edge.place[1], edge.place[0]));
        let numbers: HashMap<usize, usize> = order.iter().enumerate().map(|(number, (k, _))| (*k, number)).collect();
        let renumbered = |side: FaceEdge| Some(FaceEdge { edge: *numbers.get(&side.edge)?, ..side });
        for panel in &mut self.panels {
            panel.sides = panel.sides.map(|side| side.and_then(renumbered));
        }
        self.edges = order.into_iter().map(|(_, edge)| edge).collect();
        Ok(())
    }

    /// What meets at each node.
    fn take_beams(&mut self, skin: &Skin) {
        for (index, edge) in self.edges.iter().enumerate() {
            let ends = [edge.arc.start_tangent(), edge.arc.end_tangent().map(|tangent| -tangent)];
            for (node, direction) in edge.nodes.into_iter().zip(ends) {
                let Some(direction) = direction else { continue };
                let node = &mut self.nodes[node];
                let out = direction.dot(node.normal);
                let tilt = out.atan2((direction - node.normal * out).length());
                node.beams.push(Beam { edge: index, direction, to_next: 0.0, tilt });
            }
        }
        for node in &mut self.nodes {
            let [e1, e2, _] = skin.nets()[node.piece].vertex_frame(node.place[0], node.place[1]);
            let angle = |beam: &Beam| {
                let angle = beam.direction.dot(e2).atan2(beam.direction.dot(e1));
                if angle < FIRST { angle + std::f64::consts::TAU } else { angle }
            };
            node.beams.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
            let angles: Vec<f64> = node.beams.iter().map(angle).collect();
            let count = angles.len();
            for (k, beam) in node.beams.iter_mut().enumerate() {
                let turn = angles[(k + 1) % count] - angles[k];
                beam.to_next = if turn > 0.0 { turn } else { turn + std::f64::consts::TAU };
            }
        }
    }

    /// What a piece is called.
    pub(super) fn piece_name(&self, piece: usize) -> &str {
        &self.pieces[piece].name
    }

    /// Row and column of a panel, after the number of its piece, if there are several.
    pub(super) fn panel_number(&self, panel: usize) -> String {
        let Panel { piece, place, .. } = self.panels[panel];
        let number = self.pieces[piece].numbered(place);
        if self.pieces.len() > 1 { format!("{piece}-{number}") } else { number }
    }

    pub(super) fn panel_id(&self, panel: usize) -> String {
        let Panel { piece, place, .. } = self.panels[panel];
        format!("{}-{}", self.piece_name(piece), self.pieces[piece].numbered(place))
    }

    pub(super) fn edge_id(&self, edge: usize) -> String {
        let Edge { piece, place, direction, .. } = self.edges[edge];
        format!("{}-{}-{}", self.piece_name(piece), ["s", "t"][direction], self.pieces[piece].numbered(place))
    }

    pub(super) fn node_id(&self, node: usize) -> String {
        let Node { piece, place, .. } = self.nodes[node];
        format!("{}-n-{}", self.piece_name(piece), self.pieces[piece].numbered(place))
    }

    /// Length of all edges, each once.
    pub(super) fn edge_length(&self) -> f64 {
        self.edges.iter().map(|edge| edge.arc.length()).sum()
    }
}

impl Piece {
    /// A vertex, counted round in closed directions.
    fn vertex_at(&self, place: [usize; 2]) -> [usize; 2] {
        [place[0] % self.vertices[0], place[1] % self.vertices[1]]
    }

    /// Row and column as in all names, with as many digits as the largest needs.
    fn numbered(&self, [column, row]: [usize; 2]) -> String {
        let digits = |count: usize| count.saturating_sub(1).to_string().len().max(2);
        let [columns, rows] = self.vertices.map(digits);
        format!("r{row:0rows$}-c{column:0columns$}")
    }
}

impl Edge {
    pub(super) fn is_border(&self) -> bool {
        self.panels[1].is_none()
    }
}

/// The word for what a panel lies on.
pub(super) fn kind_word(kind: &PatchKind) -> &'static str {
    match kind {
        PatchKind::Plane { .. } => "plane",
        PatchKind::Sphere { .. } => "sphere",
        PatchKind::Cylinder { .. } => "cylinder",
        PatchKind::Cone { .. } => "cone",
        PatchKind::Torus { .. } => "torus",
        PatchKind::Cyclide => "cyclide",
    }
}

fn area(patch: CyclidePatch) -> Result<f64> {
    Shell::from_surface(patch)?.known_area()
}

fn side_arc(patch: &CyclidePatch, side: Side) -> Result<Arc> {
    match side {
        Side::Bottom => patch.s_line(0.0),
        Side::Top => patch.s_line(1.0),
        Side::Left => patch.t_line(0.0),
        Side::Right => patch.t_line(1.0),
    }
}

/// The vertices of a face at its corners; both ends of a side of one point are one.
fn corner_vertices(shell: &Shell, sides: &[Option<FaceEdge>; 4]) -> [usize; 4] {
    let mut found = [None; 4];
    for side in Side::ALL {
        if let Some(edge) = sides[side as usize] {
            let it = &shell.edges()[edge.edge];
            let ends = if edge.forward { [it.start, it.end] } else { [it.end, it.start] };
            for (corner, vertex) in side.corners().into_iter().zip(ends) {
                found[corner] = Some(vertex);
            }
        }
    }
    for side in Side::ALL {
        let [a, b] = side.corners();
        if sides[side as usize].is_none() {
            let vertex = found[a].or(found[b]);
            (found[a], found[b]) = (vertex, vertex);
        }
    }
    found.map(Option::unwrap_or_default)
}
