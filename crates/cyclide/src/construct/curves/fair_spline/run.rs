//! One run of a fair spline, between two cuts or all round: its chords, its ends, and the tangents that solve it.

use super::ends::run_ends;
use super::newton::{Equations, Geometry, RunEnd, Search};
use super::options::FairEnd;
use super::planar::PlanarChords;
use super::plane::common_plane;
use super::space::{SpaceChords, SpaceNode};
use crate::base::frame::Frame;
use crate::base::planar::Vec2;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Chord;

/// Segments whose arcs differ by less are one arc, whatever its angle.
const ARC_ANGLE: f64 = 1e-9;

/// Points in order with their chords: `n` of a closed run, `n - 1` of an open one.
pub(super) struct Run<'a> {
    pub(super) chords: &'a [Chord],
    pub(super) closed: bool,
    /// Ends of an open run, with unit tangents.
    pub(super) ends: [RunEnd<Vec3>; 2],
    /// The plane of the data, if they have one.
    pub(super) plane: Option<Frame>,
}

/// Tangents at the nodes of a run, and the smallest cosine between them and the chords of its segments (arcs aside).
pub(super) struct Tangents {
    pub(super) units: Vec<Vec3>,
    pub(super) least_cosine: f64,
}

impl<'a> Run<'a> {
    /// The run through some points, whose `ends` have unit tangents.
    pub(super) fn new(points: &[Point3], chords: &'a [Chord], closed: bool, ends: [FairEnd; 2]) -> Self {
        let given = |end: FairEnd| if let FairEnd::Clamped(t) = end { Some(t) } else { None };
        let tangents: Vec<Vec3> = if closed { Vec::new() } else { ends.into_iter().filter_map(given).collect() };
        let plane = common_plane(points, &tangents);
        Self { chords, closed, ends: run_ends(chords, closed, ends, plane.is_some()), plane }
    }

    /// True if no tangent is unknown.
    pub(super) fn is_given(&self) -> bool {
        !self.closed && self.chords.len() == 1 && !self.ends.iter().any(|end| matches!(end, RunEnd::Free))
    }

    /// The tangents the search starts from.
    pub(super) fn start(&self) -> Vec<Vec3> {
        self.with_geometry(
            |equations, frame| equations.start().iter().map(|t| in_space(&frame, *t)).collect(),
            |equations| equations.start().iter().map(|node| node.tangent).collect(),
        )
    }

    /// The tangents that solve the run with these blends, from given ones or its own start; `None` if not found.
    pub(super) fn solve(&self, blends: &[f64], warm: Option<&[Vec3]>, search: Search) -> Option<Tangents> {
        self.with_geometry(
            |equations, frame| {
                let warm = warm.map(|warm| warm.iter().map(|t| in_plane(&frame, *t)).collect());
                let (nodes, least_cosine) = solved(&equations, warm, blends, search)?;
                Some(Tangents { units: nodes.iter().map(|t| in_space(&frame, *t)).collect(), least_cosine })
            },
            |equations| {
                let warm = warm.map(|warm| warm.iter().map(|t| SpaceNode::new(*t)).collect());
                let (nodes, least_cosine) = solved(&equations, warm, blends, search)?;
                Some(Tangents { units: nodes.iter().map(|node| node.tangent).collect(), least_cosine })
            },
        )
    }

    fn with_geometry<T>(
        &self,
        planar: impl FnOnce(Equations<'_, PlanarChords, 1>, Frame) -> T,
        space: impl FnOnce(Equations<'_, SpaceChords, 2>) -> T,
    ) -> T {
        let longest = self.chords.iter().map(|c| c.length).fold(0.0, f64::max);
        let lengths = self.chords.iter().map(|c| c.length / longest).collect();
        if let Some(frame) = self.plane {
            let units = self.chords.iter().map(|c| in_plane(&frame, c.unit)).collect();
            let geometry = PlanarChords { units, lengths };
            let ends = self.ends.map(|end| mapped(end, |t| in_plane(&frame, t)));
            planar(Equations { geometry: &geometry, closed: self.closed, ends }, frame)
        } else {
            let geometry = SpaceChords { units: self.chords.iter().map(|c| c.unit).collect(), lengths };
            let ends = self.ends.map(|end| mapped(end, SpaceNode::new));
            space(Equations { geometry: &geometry, closed: self.closed, ends })
        }
    }
}

fn solved<G: Geometry<R>, const R: usize>(
    equations: &Equations<'_, G, R>,
    warm: Option<Vec<G::Node>>,
    blends: &[f64],
    search: Search,
) -> Option<(Vec<G::Node>, f64)> {
    let mut nodes = warm.unwrap_or_else(|| equations.start());
    equations.set_ends(&mut nodes);
    if !equations.solve(&mut nodes, blends, search) {
        return None;
    }
    let least = least_cosine(equations.geometry, &nodes);
    Some((nodes, least))
}

/// The smallest cosine between a chord and the tangents at its ends, segments that are arcs aside.
fn least_cosine<G: Geometry<R>, const R: usize>(geometry: &G, nodes: &[G::Node]) -> f64 {
    let mut least: f64 = 1.0;
    for i in 0..geometry.lengths().len() {
        let (from, to) = (&nodes[i], &nodes[if i + 1 == nodes.len() { 0 } else { i + 1 }]);
        let cosine = geometry.cosine(i, from).min(geometry.cosine(i, to));
        if cosine < least && (cosine > 0.0 || geometry.blend_angle(i, from, to) > ARC_ANGLE) {
            least = cosine;
        }
    }
    least
}

fn mapped<D, E>(end: RunEnd<D>, map: impl FnOnce(D) -> E) -> RunEnd<E> {
    match end {
        RunEnd::Arc => RunEnd::Arc,
        RunEnd::Free => RunEnd::Free,
        RunEnd::Clamped(t) => RunEnd::Clamped(map(t)),
    }
}

/// Components in the plane of a frame, normalized: what leans out of it is rounding.
fn in_plane(frame: &Frame, v: Vec3) -> [f64; 2] {
    let (x, y) = (v.dot(frame.x()), v.dot(frame.y()));
    let r = (x * x + y * y).sqrt();
    [x / r, y / r]
}

fn in_space(frame: &Frame, [x, y]: [f64; 2]) -> Vec3 {
    frame.vector_to_world(Vec2::new(x, y))
}
