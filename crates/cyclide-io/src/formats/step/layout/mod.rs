//! What the faces and edges of a file are: faces of a shell that lie side by side on one plane, cylinder, cone, sphere or torus are one face of
//! the file, and arcs of one circle between the same two faces one edge.
//!
//! A face of the file has one outer loop in the parameters of its surface and any number of inner ones; where it goes all the way round, its loop
//! runs along a seam and back, as ISO 10303-42 has it. Where that cannot be had - no line of edges for the seam, a loop that winds otherwise - the
//! faces of the shell stay as they are. Each face is developed into the parameters of its surface before it is taken: its loops have
//! to close there, one of them round the others, and the areas of the faces of the shell have to add up to that of the whole.

mod bridgeheads;
mod bridges;
mod chains;
mod file_edges;
mod half_edges;
mod parameters;
mod regions;
mod seams;
mod spheres;

use super::polar_curves::PolarCurve;
use bridgeheads::Bridgeheads;
use bridges::Bridge;
use chains::as_arc;
use cyclide::{
    Frame, Point3,
    curve::Arc,
    surface::PatchKind,
    topology::{EdgeCurve, Shell, Side},
};
use file_edges::{Chains, edges_at, go_on};
use half_edges::{HalfEdge, HalfEdges};
use parameters::{Developed, periodic};
use regions::{Region, regions};
use seams::{Seam, seams};
use std::collections::{HashSet, VecDeque};
use std::f64::consts::{PI, TAU};

pub(super) use chains::{ChainCurve, is_straight};
pub(super) use parameters::{outward, place};
pub(super) use spheres::is_parameter_line;

/// The areas in parameters of a face and of what it is made of are the same to this part.
const SAME_AREA: f64 = 1e-6;
/// Angles of a face that goes all the way round are a full turn to this.
const FULL_TURN: f64 = 1e-6;
/// So many seams are tried for each face.
const MOST_TRIED: usize = 64;

/// A face of the file.
pub(super) struct LayoutFace {
    /// Its surface; a rational one is that of its only face.
    pub(super) kind: PatchKind,
    /// True if the shell's outer side is that of the surface's own normal.
    pub(super) outward: bool,
    /// The faces of the shell that it is, ascending.
    pub(super) faces: Vec<usize>,
    /// Its loops seen from the shell's outer side, the outer one, counter-clockwise, first.
    pub(super) bounds: Vec<Vec<LoopEdge>>,
}

/// An edge of the file as a loop uses it.
pub(super) struct LoopEdge {
    pub(super) edge: usize,
    /// Whether the loop runs along it.
    pub(super) forward: bool,
    /// The sides of faces of the shell that it is, in the order of the loop; none for a seam across them.
    pub(super) sides: Vec<(usize, Side)>,
}

/// An edge of the file.
pub(super) struct LayoutEdge {
    /// The vertices at its ends: of the shell, or behind them.
    pub(super) ends: [usize; 2],
    /// The edge of the shell that it is, with its curve, or the curve of several.
    pub(super) form: EdgeForm,
}

/// The curve of an edge of the file.
pub(super) enum EdgeForm {
    /// That of an edge of the shell.
    Own(usize),
    /// A line, an arc or a whole circle.
    Joined(ChainCurve),
}

/// The faces and edges of a shell as the file has them.
pub(super) struct Layout {
    pub(super) faces: Vec<LayoutFace>,
    pub(super) edges: Vec<LayoutEdge>,
    /// Vertices behind those of the shell.
    pub(super) points: Vec<Point3>,
}

/// What faces are made one by.
pub(super) struct Merging<'a> {
    /// The surface of each face, if it may become part of a larger one.
    pub(super) kinds: &'a [PatchKind],
    /// Size of the model.
    pub(super) size: f64,
    /// Whether edges are circles and lines.
    pub(super) circles: bool,
}

impl Layout {
    /// Every face and edge of the shell for itself, on these surfaces.
    pub(super) fn split(shell: &Shell, kinds: &[PatchKind]) -> Self {
        Self::new(shell, kinds, None)
    }

    /// Faces and edges made one where they are; `kinds` are the surfaces of faces that stay as they are.
    pub(super) fn merged(shell: &Shell, kinds: &[PatchKind], merging: &Merging<'_>) -> Self {
        Self::new(shell, kinds, Some(merging))
    }

    fn new(shell: &Shell, kinds: &[PatchKind], merging: Option<&Merging<'_>>) -> Self {
        let half_edges = HalfEdges::new(shell);
        let mut is_kept = vec![true; shell.edges().len()];
        let mut arcs: Vec<Option<Arc>> = vec![None; shell.edges().len()];
        let (mut drafts, mut bridgeheads) = (Vec::new(), Bridgeheads::default());
        if let Some(merging) = merging {
            arcs = shell.edges().iter().map(|edge| as_arc(&edge.curve, merging.size)).collect();
            let room = Drafts { shell, half_edges: &half_edges, arcs: &arcs, merging };
            (drafts, bridgeheads) = room.all(&mut is_kept);
        }
        let mut is_taken = vec![false; shell.faces().len()];
        for &face in drafts.iter().flat_map(|draft| &draft.region.faces) {
            is_taken[face] = true;
        }
        for (face, &kind) in kinds.iter().enumerate().filter(|(face, _)| !is_taken[*face]) {
            let outward = match kind {
                PatchKind::Cyclide => shell.faces()[face].same_sense,
                _ => shell.faces()[face].same_sense == kind_outward(&kind),
            };
            let region = Region { kind, outward, faces: vec![face] };
            drafts.push(Draft {
                region,
                loops: vec![half_edges.of_face(face).to_vec()],
                single_edges: Vec::new(),
                bridge: None,
            });
        }
        drafts.sort_by_key(|draft| draft.region.faces[0]);
        let mut edges = Chains::new(shell, &drafts, &is_kept, (&arcs, merging), &bridgeheads);
        let mut face = |draft: &Draft| {
            let mut bounds: Vec<Vec<LoopEdge>> = draft.loops.iter().map(|own| edges.of_loop(shell, own)).collect();
            if let Some(bridge) = &draft.bridge {
                edges.add_bridge(bridge, &mut bounds);
            }
            let Region { kind, outward, faces } = draft.region.clone();
            LayoutFace { kind, outward, faces, bounds }
        };
        let faces = drafts.iter().map(&mut face).collect();
        Self { faces, edges: edges.edges, points: bridgeheads.points }
    }
}

/// Whether the normal of a patch of this kind is that of its surface.
fn kind_outward(kind: &PatchKind) -> bool {
    match kind {
        PatchKind::Sphere { outward, .. }
        | PatchKind::Cylinder { outward, .. }
        | PatchKind::Cone { outward, .. }
        | PatchKind::Torus { outward, .. } => *outward,
        PatchKind::Plane { .. } | PatchKind::Cyclide => true,
    }
}

/// A face of the file before its edges are made one.
struct Draft {
    region: Region,
    loops: Vec<Vec<HalfEdge>>,
    /// Edges that are not made one with others: they have a curve of their own in the parameters.
    single_edges: Vec<usize>,
    /// A seam across the faces, between the first two loops.
    bridge: Option<Bridge>,
}

/// What faces of the file are found in.
struct Drafts<'a> {
    shell: &'a Shell,
    half_edges: &'a HalfEdges,
    arcs: &'a [Option<Arc>],
    merging: &'a Merging<'a>,
}

impl Drafts<'_> {
    /// The faces of the file that are several faces of the shell; with the edges that are kept, and where seams across faces end.
    fn all(&self, is_kept: &mut [bool]) -> (Vec<Draft>, Bridgeheads) {
        let Self { shell, half_edges, merging, .. } = *self;
        let regions = regions(shell, half_edges, merging.kinds, merging.size);
        let mut region_of = vec![0; shell.faces().len()];
        for (index, region) in regions.iter().enumerate() {
            for &face in &region.faces {
                region_of[face] = index;
            }
        }
        // First only what lies between two regions is kept.
        for (edge, is_kept) in is_kept.iter_mut().enumerate() {
            let mut along = half_edges.faces_along(edge);
            let pair = (along.next(), along.next());
            *is_kept = match pair {
                (Some(a), Some(b)) => region_of[a] != region_of[b] || regions[region_of[a]].faces.len() == 1,
                _ => true,
            };
        }
        let mut anchors = self.fixed_vertices(is_kept);
        let (mut drafts, mut heads, mut left) = (Vec::new(), Bridgeheads::new(shell), Vec::new());
        for index in self.in_order(&regions, &region_of) {
            let region = &regions[index];
            if region.faces.len() == 1 {
                continue;
            }
            if let Some((draft, seam)) = self.draft(region, is_kept, &anchors) {
                anchors.extend(&seam.ends);
                for edge in seam.edges {
                    is_kept[edge] = true;
                }
                drafts.push(draft);
            } else {
                left.push(region);
            }
        }
        // Where all other seams end is known now.
        for region in left {
            if let Some(draft) = self.bridged(region, is_kept, &mut anchors, &mut heads) {
                drafts.push(draft);
            } else {
                for half in region.faces.iter().flat_map(|&face| half_edges.of_face(face)) {
                    is_kept[half.edge] = true;
                }
            }
        }
        (drafts, heads)
    }

    /// The regions from neighbor to neighbor, so that seams go on.
    fn in_order(&self, regions: &[Region], region_of: &[usize]) -> Vec<usize> {
        let (mut is_seen, mut order) = (vec![false; regions.len()], Vec::with_capacity(regions.len()));
        for first in 0..regions.len() {
            let mut queue = VecDeque::from([first]);
            while let Some(index) = queue.pop_front() {
                if std::mem::replace(&mut is_seen[index], true) {
                    continue;
                }
                order.push(index);
                for half in regions[index].faces.iter().flat_map(|&face| self.half_edges.of_face(face)) {
                    queue.extend(
                        self.half_edges.faces_along(half.edge).map(|face| region_of[face]).filter(|&r| !is_seen[r]),
                    );
                }
            }
        }
        order
    }

    /// The vertices at which edges of the file end whatever seams there are.
    fn fixed_vertices(&self, is_kept: &[bool]) -> HashSet<usize> {
        let at = edges_at(self.shell, is_kept);
        let size = self.merging.size;
        let goes_on = |edges: &[usize], vertex: usize| match edges {
            &[a, b] => go_on(self.shell, self.arcs, (a, b), vertex, (size, self.merging.circles)),
            _ => false,
        };
        at.iter().filter(|(vertex, edges)| !goes_on(edges, **vertex)).map(|(vertex, _)| *vertex).collect()
    }

    /// A face of the file of a region, with its seam; `None` where there is none.
    fn draft(&self, region: &Region, is_kept: &[bool], anchors: &HashSet<usize>) -> Option<(Draft, Seam)> {
        let borders = self.half_edges.loops(&region.faces, |edge| is_kept[edge]);
        for kind in spheres::framings(self.shell, region, &borders, self.arcs) {
            let mut region = region.clone();
            region.kind = kind;
            let Some(of_faces) = self.area_of_faces(&region) else { continue };
            let mut found = seams(self.shell, self.half_edges, &region, &borders, self.arcs);
            let free = |seam: &Seam| seam.ends.iter().filter(|vertex| !anchors.contains(vertex)).count();
            found.sort_by_key(free);
            for seam in found.into_iter().take(MOST_TRIED) {
                let loops = self.half_edges.loops(&region.faces, |edge| is_kept[edge] || seam.edges.contains(&edge));
                if let Some(draft) = self.checked(&region, loops, (of_faces, !seam.edges.is_empty())) {
                    return Some((draft, seam));
                }
            }
        }
        None
    }

    /// A loop of the faces of a region, in the parameters of its surface.
    fn developed(&self, region: &Region, own: &[HalfEdge]) -> Option<Developed> {
        let edges = own.iter().map(|half| (&self.shell.edges()[half.edge].curve, half.forward));
        Developed::new(&region.kind, edges, region.outward)
    }

    /// The area of all faces of a region in the parameters.
    fn area_of_faces(&self, region: &Region) -> Option<f64> {
        let area = |&face: &usize| {
            let own = self.developed(region, self.half_edges.of_face(face))?;
            (own.turns()? == [0, 0]).then(|| region.signed(own.area()))
        };
        region.faces.iter().map(area).sum()
    }

    /// The face with these loops, if it is one: with the outer loop first and the first axis of its placement away from it.
    fn checked(&self, region: &Region, loops: Vec<Vec<HalfEdge>>, (of_faces, has_seam): (f64, bool)) -> Option<Draft> {
        let developed = |own: Vec<HalfEdge>| {
            let found = self.developed(region, &own)?;
            (found.turns()? == [0, 0]).then(|| (region.signed(found.area()), found, own))
        };
        let mut bounds: Vec<(f64, Developed, Vec<HalfEdge>)> =
            loops.into_iter().map(developed).collect::<Option<_>>()?;
        bounds.sort_by(|a, b| b.0.total_cmp(&a.0));
        let ((of_outer, outer, _), holes) = bounds.split_first()?;
        if !(*of_outer > 0.0) || holes.iter().any(|(hole, ..)| !(*hole < 0.0)) {
            return None;
        }
        let whole = of_outer + holes.iter().map(|(hole, ..)| hole).sum::<f64>();
        if !((whole - of_faces).abs() <= SAME_AREA * of_outer) {
            return None;
        }
        let periodic = periodic(&region.kind);
        for parameter in [0, 1].into_iter().filter(|&k| periodic[k]) {
            let [from, to] = outer.range(parameter);
            let most = if has_seam { TAU + FULL_TURN } else { TAU - FULL_TURN };
            if !(to - from <= most) {
                return None;
            }
        }
        let [from, to] = outer.range(0);
        let kind = if periodic[0] { turned(&region.kind, 0.5 * (from + to) + PI)? } else { region.kind };
        let loops: Vec<Vec<HalfEdge>> = bounds.into_iter().map(|(_, _, own)| own).collect();
        let single_edges = self.followed(&kind, &loops)?;
        Some(Draft { region: Region { kind, ..region.clone() }, loops, single_edges, bridge: None })
    }

    /// The edges that are no parameter lines, which need curves in the parameters; `None` where one has none.
    fn followed(&self, kind: &PatchKind, loops: &[Vec<HalfEdge>]) -> Option<Vec<usize>> {
        let mut found = Vec::new();
        if matches!(kind, PatchKind::Plane { .. }) {
            return Some(found);
        }
        for half in loops.iter().flatten() {
            let curve = &self.shell.edges()[half.edge].curve;
            match (curve, &self.arcs[half.edge], kind) {
                (_, Some(arc), PatchKind::Sphere { .. }) if !is_parameter_line(kind, arc) => {
                    PolarCurve::of_arc(arc, kind, self.merging.size)?;
                    found.push(half.edge);
                }
                (_, Some(_), _) => {}
                (EdgeCurve::Rational(curve), None, _) => {
                    PolarCurve::of(curve, kind, self.merging.size)?;
                    found.push(half.edge);
                }
                (EdgeCurve::Arc(_), None, _) => return None,
            }
        }
        Some(found)
    }
}

/// The surface with the first axis of its placement turned by an angle.
fn turned(kind: &PatchKind, angle: f64) -> Option<PatchKind> {
    let mut kind = *kind;
    match &mut kind {
        PatchKind::Sphere { frame, .. }
        | PatchKind::Cylinder { frame, .. }
        | PatchKind::Cone { frame, .. }
        | PatchKind::Torus { frame, .. } => {
            let (sin, cos) = angle.sin_cos();
            *frame = Frame::from_normal(frame.origin(), frame.z(), frame.x() * cos + frame.y() * sin).ok()?;
        }
        PatchKind::Plane { .. } | PatchKind::Cyclide => {}
    }
    Some(kind)
}
