//! Seams across faces: a line on a cylinder or a cone between the two loops that go round it, where no edges of the shell lie along one, as
//! where a hole has faces of its own round it. It ends at vertices, or anywhere on a whole circle, whose vertex is then there.

use super::bridgeheads::Bridgeheads;
use super::chains::{ChainCurve, joined};
use super::file_edges::Chains;
use super::half_edges::HalfEdge;
use super::parameters::{Developed, angle_between, place};
use super::regions::Region;
use super::{Draft, Drafts, EdgeForm, LayoutEdge, LoopEdge, turned};
use cyclide::{
    Point3,
    curve::{Arc, Circle},
    surface::PatchKind,
};
use std::collections::HashSet;

/// Angles nearer than this are one.
const SAME_ANGLE: f64 = 1e-10;
/// A seam is at least this far from the holes, radians.
const CLEARANCE: f64 = 1e-6;
/// How much the areas in parameters may differ, of the whole.
const SAME_AREA: f64 = 1e-6;

/// A seam between the first two loops of a face.
pub(super) struct Bridge {
    line: Arc,
    /// Its vertices.
    ends: [usize; 2],
}

/// A loop round the surface.
struct Rim {
    developed: Developed,
    /// Where a seam may end: angles, points and vertices.
    places: Vec<(f64, Point3, usize)>,
    /// The circle, if its vertex may be anywhere.
    free: Option<Circle>,
    edges: Vec<usize>,
}

impl Drafts<'_> {
    /// The face of a region on a cylinder or cone with a seam across its faces.
    pub(super) fn bridged(
        &self,
        region: &Region,
        is_kept: &[bool],
        anchors: &mut HashSet<usize>,
        heads: &mut Bridgeheads,
    ) -> Option<Draft> {
        if !matches!(region.kind, PatchKind::Cylinder { .. } | PatchKind::Cone { .. }) {
            return None;
        }
        let (mut rims, mut holes) = (Vec::new(), Vec::new());
        for own in self.half_edges.loops(&region.faces, |edge| is_kept[edge]) {
            let developed = self.developed(region, &own)?;
            match developed.turns()? {
                [0, 0] => holes.push((developed, own)),
                [1 | -1, 0] => rims.push((developed, own)),
                _ => return None,
            }
        }
        let sum =
            |loops: &[(Developed, Vec<HalfEdge>)]| loops.iter().map(|(d, _)| region.signed(d.area())).sum::<f64>();
        let (outer, of_holes) = (sum(&rims), sum(&holes));
        let is_whole = (outer + of_holes - self.area_of_faces(region)?).abs() <= SAME_AREA * outer;
        if rims.len() != 2 || !is_whole || holes.iter().any(|(hole, _)| !(region.signed(hole.area()) < 0.0)) {
            return None;
        }
        let loops: Vec<Vec<HalfEdge>> = rims.iter().chain(&holes).map(|(_, own)| own.clone()).collect();
        let mut rims = rims.into_iter().map(|(developed, own)| self.rim(region, developed, &own, (anchors, heads)));
        let (from, to) = (rims.next()??, rims.next()??);
        let (angle, ends) = self.seam(region, [&from, &to], holes.iter().map(|(hole, _)| hole), anchors)?;
        let kind = turned(&region.kind, angle)?;
        let single_edges = self.followed(&kind, &loops)?;
        let mut vertices = [0; 2];
        for ((end, rim), vertex) in ends.into_iter().zip([&from, &to]).zip(&mut vertices) {
            *vertex = match end {
                (_, Some(vertex)) => vertex,
                (point, None) => {
                    heads.points.push(point);
                    let vertex = heads.count + heads.points.len() - 1;
                    heads.on_edge.extend(rim.edges.iter().map(|&edge| (edge, vertex)));
                    vertex
                }
            };
        }
        heads.vertices.extend(vertices);
        anchors.extend(vertices);
        let line = Arc::segment(ends[0].0, ends[1].0).ok()?;
        let bridge = Some(Bridge { line, ends: vertices });
        Some(Draft { region: Region { kind, ..region.clone() }, loops, single_edges, bridge })
    }

    fn rim(
        &self,
        region: &Region,
        developed: Developed,
        own: &[HalfEdge],
        (anchors, heads): (&HashSet<usize>, &Bridgeheads),
    ) -> Option<Rim> {
        let ends = |half: &HalfEdge| {
            let edge = &self.shell.edges()[half.edge];
            if half.forward { edge.start } else { edge.end }
        };
        let edges: Vec<usize> = own.iter().map(|half| half.edge).collect();
        let at = |p: Point3, vertex: usize| Some((place(&region.kind, p)?[0], p, vertex));
        if let Some(&head) = edges.iter().find_map(|edge| heads.on_edge.get(edge)) {
            return Some(Rim { developed, places: vec![at(heads.point(head), head)?], free: None, edges });
        }
        let vertices: Vec<usize> = own.iter().map(ends).collect();
        let places = vertices.iter().map(|&v| at(self.shell.vertices()[v], v)).collect::<Option<Vec<_>>>()?;
        let arcs = own.iter().map(|half| {
            let arc = self.arcs[half.edge]?;
            Some(if half.forward { arc } else { arc.reversed() })
        });
        let is_free = vertices.iter().all(|vertex| !anchors.contains(vertex));
        let free = arcs.collect::<Option<Vec<Arc>>>().filter(|_| is_free);
        let free = free.and_then(|arcs| match joined(&arcs, true, self.merging.size)? {
            ChainCurve::Circle(circle) => Some(circle),
            ChainCurve::Arc(_) => None,
        });
        Some(Rim { developed, places, free, edges })
    }

    /// The angle of a seam between two rims, far from holes, with its ends and their vertices where they have some.
    #[allow(clippy::type_complexity, reason = "used in one place")]
    fn seam<'b>(
        &self,
        region: &Region,
        rims: [&Rim; 2],
        holes: impl Iterator<Item = &'b Developed>,
        anchors: &HashSet<usize>,
    ) -> Option<(f64, [(Point3, Option<usize>); 2])> {
        let holes: Vec<&Developed> = holes.collect();
        let mut best: Option<((usize, f64), f64, [(Point3, Option<usize>); 2])> = None;
        for (own, other) in [(0, 1), (1, 0)] {
            for &(angle, point, vertex) in &rims[own].places {
                let same = |(at, ..): &&(f64, Point3, usize)| angle_between(angle, *at).abs() <= SAME_ANGLE;
                let end = match (rims[other].places.iter().find(same), &rims[other].free) {
                    (Some(&(_, p, v)), _) => (p, Some(v)),
                    (None, Some(circle)) => (on_circle(&region.kind, circle, angle)?, None),
                    (None, None) => continue,
                };
                let clearance = holes.iter().map(|hole| hole.clearance(angle)).fold(f64::INFINITY, f64::min);
                let once =
                    |rim: &Rim| [-CLEARANCE, CLEARANCE].iter().all(|by| rim.developed.crossings(angle + by) == 1);
                if !(clearance > CLEARANCE) || !rims.into_iter().all(once) {
                    continue;
                }
                // As many vertices as there are anyway, then far from holes.
                let known = [Some(vertex), end.1].into_iter().flatten().filter(|v| anchors.contains(v)).count();
                let ends = if own == 0 { [(point, Some(vertex)), end] } else { [end, (point, Some(vertex))] };
                let rank = (known, clearance);
                if best.as_ref().is_none_or(|(other, ..)| rank.0 > other.0 || (rank.0 == other.0 && rank.1 > other.1)) {
                    best = Some((rank, angle, ends));
                }
            }
        }
        best.map(|(_, angle, ends)| (angle, ends))
    }
}

/// The point of a circle about the axis of a cylinder or cone at an angle.
fn on_circle(kind: &PatchKind, circle: &Circle, angle: f64) -> Option<Point3> {
    let (PatchKind::Cylinder { frame, .. } | PatchKind::Cone { frame, .. }) = kind else { return None };
    let (sin, cos) = angle.sin_cos();
    Some(circle.closest_point(circle.center() + (frame.x() * cos + frame.y() * sin) * circle.radius()).point)
}

impl Chains {
    /// The two loops that a seam joins, as one: round the first one, along the seam, round the other one and back.
    pub(super) fn add_bridge(&mut self, bridge: &Bridge, bounds: &mut Vec<Vec<LoopEdge>>) {
        let seam = self.edges.len();
        self.edges.push(LayoutEdge { ends: bridge.ends, form: EdgeForm::Joined(ChainCurve::Arc(bridge.line)) });
        let mut others = bounds.split_off(2.min(bounds.len()));
        let mut outer = Vec::new();
        for ((mut rim, vertex), forward) in bounds.drain(..).zip(bridge.ends).zip([true, false]) {
            let start = |edge: &LoopEdge| self.edges[edge.edge].ends[usize::from(!edge.forward)];
            let first = rim.iter().position(|edge| start(edge) == vertex).unwrap_or(0);
            rim.rotate_left(first);
            outer.append(&mut rim);
            outer.push(LoopEdge { edge: seam, forward, sides: Vec::new() });
        }
        bounds.push(outer);
        bounds.append(&mut others);
    }
}
