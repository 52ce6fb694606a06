//! Bodies: vertices, edges, loops and faces, all shared, in open and closed shells.

use super::curves;
use super::data::{Data, logical, push_list, push_reference, references, string};
use super::integration::Integration;
use super::layout::{
    ChainCurve, EdgeForm, Layout, LayoutEdge, LayoutFace, LoopEdge, Merging, is_parameter_line, is_straight,
};
use super::parameter_curves::ParameterCurve;
use super::polar_curves::PolarCurve;
use super::surfaces;
use crate::export::face_plan::{FacePlan, ShellPlan};
use crate::export::options::{StepEdges, StepFaces};
use cyclide::{
    Point3, Result,
    curve::Arc,
    rational::NurbsCurve,
    surface::PatchKind,
    topology::{Body, CutShell, EdgeCurve, FaceSurface, Shell, ShellFace, Side},
};
use std::fmt::Write as _;

/// A body in the file.
#[derive(Debug, Clone, Copy)]
pub(super) enum Entity {
    /// `MANIFOLD_SOLID_BREP` or `BREP_WITH_VOIDS`.
    Solid(usize),
    /// `SHELL_BASED_SURFACE_MODEL`.
    Surface(usize),
}

/// How a body was written, and what the user should know about it.
pub(super) struct Written {
    pub(super) entity: Entity,
    /// What its faces stand for, shell by shell.
    pub(super) shells: Vec<ShellPlan>,
    /// Length of the shortest edge; infinite without edges.
    pub(super) shortest: f64,
    /// True if a closed body touches itself in single points, so that it is no solid.
    pub(super) touches_itself: bool,
}

/// Writes a body; `size` is the model's diagonal.
pub(super) fn body(
    data: &mut Data,
    name: &str,
    body: &Body,
    size: f64,
    (edges, faces): (StepEdges, StepFaces),
) -> Result<Written> {
    let shells = body.shells().map(|shell| cut(shell, size, edges)).collect::<Result<Vec<CutShell>>>()?;
    let parts: Vec<Vec<Vec<usize>>> = shells.iter().map(|cut| cut.shell().parts()).collect();
    let closed: Vec<bool> = shells.iter().map(|cut| cut.shell().is_closed()).collect();
    let solid = closed.iter().all(|&c| c) && parts.iter().all(|p| p.len() == 1);
    let touches_itself = closed[0] && parts[0].len() > 1;
    let (mut written, mut plans, mut shortest) = (Vec::new(), Vec::new(), f64::INFINITY);
    for (index, (cut, parts)) in shells.iter().zip(&parts).enumerate() {
        // A void is written as the boundary of the hollow, whose outer side is the other one.
        let flip = solid && index > 0;
        let mut writer = Writer::new(data, cut.shell(), size, (edges, faces));
        shortest = shortest.min(writer.shortest_edge());
        let mut part_of = vec![0; cut.shell().faces().len()];
        for (index, part) in parts.iter().enumerate() {
            part.iter().for_each(|&face| part_of[face] = index);
        }
        for part in 0..parts.len() {
            let is_own = |face: &&usize| part_of[writer.layout.faces[**face].faces[0]] == part;
            let own: Vec<usize> =
                (0..writer.layout.faces.len()).collect::<Vec<_>>().iter().filter(is_own).copied().collect();
            let faces = own.iter().map(|&f| writer.face(f, flip)).collect::<Result<Vec<_>>>()?;
            let kind = if closed[index] { "CLOSED_SHELL" } else { "OPEN_SHELL" };
            written.push(writer.data.add(&format!("{kind}('',{})", references(&faces))));
            let plan = |&face: &usize| face_plan(&writer.layout.faces[face], cut, flip);
            plans.push(ShellPlan { shell: index, faces: own.iter().map(plan).collect() });
        }
    }
    let entity = entity(data, name, solid, &written);
    Ok(Written { entity, shells: plans, shortest, touches_itself })
}

/// What a face of the file stands for: its parts of faces, and which of their sides are its edges, loop by loop.
fn face_plan(face: &LayoutFace, cut: &CutShell, flip: bool) -> FacePlan {
    let sides = |edge: &LoopEdge| {
        let part = |face_of_shell: usize| face.faces.iter().position(|&own| own == face_of_shell).unwrap_or(usize::MAX);
        let mut sides: Vec<(usize, Side)> = edge.sides.iter().map(|&(of, side)| (part(of), side)).collect();
        if flip {
            sides.reverse();
        }
        sides
    };
    let one = |bound: &Vec<LoopEdge>| {
        let mut edges: Vec<Vec<(usize, Side)>> = bound.iter().map(sides).collect();
        if flip {
            edges.reverse();
        }
        edges
    };
    FacePlan {
        parts: face.faces.iter().map(|&own| cut.parts()[own]).collect(),
        loops: face.bounds.iter().map(one).collect(),
    }
}

/// A body of these shells.
fn entity(data: &mut Data, name: &str, solid: bool, shells: &[usize]) -> Entity {
    let name = string(name);
    if !solid {
        Entity::Surface(data.add(&format!("SHELL_BASED_SURFACE_MODEL({name},{})", references(shells))))
    } else if let [outer] = shells {
        Entity::Solid(data.add(&format!("MANIFOLD_SOLID_BREP({name},#{outer})")))
    } else {
        let voids: Vec<usize> =
            shells[1..].iter().map(|v| data.add(&format!("ORIENTED_CLOSED_SHELL('',*,#{v},.F.)"))).collect();
        let (outer, voids) = (shells[0], references(&voids));
        Entity::Solid(data.add(&format!("BREP_WITH_VOIDS({name},#{outer},{voids})")))
    }
}

/// Strips are halved this often at most for the sake of integration, which sharpens the rule more than enough.
const MOST_HALVINGS: usize = 8;
/// Faces that are made of one for that on the average, at most: where a surface all but folds, its area element all but has a corner, and no part is integrated.
const MOST_PARTS: usize = 3;

/// The faces as they are written: regular inside, with positive weights; rational ones such that readers integrate them.
/// `size` is the model's diagonal.
fn cut(shell: &Shell, size: f64, edges: StepEdges) -> Result<CutShell> {
    let good = CutShell::from(shell.clone()).with_regular_faces()?.with_positive_weights()?;
    let is_rational = |shell: &Shell, face: &ShellFace| surfaces::kind(shell, face, size, edges) == PatchKind::Cyclide;
    let integration = Integration::default();
    let is_bad = |shell: &Shell, face: &ShellFace| !integration.is_good(&face.surface) && is_rational(shell, face);
    good.halved_while_few(|shell, face| [is_bad(shell, face), false], MOST_HALVINGS, MOST_PARTS)
}

/// Weights of a face are far from each other beyond this factor.
const UNEVEN: f64 = 4.0;

/// The curve of an edge in space, with its number.
enum SpaceCurve {
    Line(usize, Arc),
    Circle(usize, Arc),
    /// In the parameter of its faces, so that readers find the curves in their parameters, where weights are even.
    Rational(usize),
    /// Along several edges of the shell, on faces of which it is a parameter line.
    Joined(usize),
}

/// One shell as it is written: the numbers of what is shared already.
struct Writer<'a> {
    data: &'a mut Data,
    shell: &'a Shell,
    size: f64,
    edges: StepEdges,
    /// The faces and edges of the file.
    layout: Layout,
    /// Of each edge of the file the faces along it, with the side of each.
    users: Vec<Vec<(usize, (usize, Side))>>,
    /// Surfaces, `VERTEX_POINT`s and `EDGE_CURVE`s already written.
    surface: Vec<Option<usize>>,
    vertex: Vec<Option<usize>>,
    edge: Vec<Option<usize>>,
}

impl<'a> Writer<'a> {
    fn new(data: &'a mut Data, shell: &'a Shell, size: f64, (edges, faces): (StepEdges, StepFaces)) -> Self {
        let kinds: Vec<PatchKind> = shell.faces().iter().map(|face| surfaces::kind(shell, face, size, edges)).collect();
        let layout = match faces {
            StepFaces::Split => Layout::split(shell, &kinds),
            StepFaces::Auto | StepFaces::Merged => {
                let pairs = shell.faces().iter().zip(&kinds);
                let whole: Vec<PatchKind> =
                    pairs.map(|(face, kind)| surfaces::whole_kind(face, kind, size, edges)).collect();
                let merging = Merging { kinds: &whole, size, circles: edges == StepEdges::Circles };
                Layout::merged(shell, &kinds, &merging)
            }
        };
        let mut users = vec![Vec::new(); layout.edges.len()];
        for (index, face) in layout.faces.iter().enumerate() {
            for edge in face.bounds.iter().flatten() {
                users[edge.edge].extend(edge.sides.first().map(|&side| (index, side)));
            }
        }
        let (vertices, edge) = (shell.vertices().len() + layout.points.len(), vec![None; layout.edges.len()]);
        let vertex = vec![None; vertices];
        let surface = vec![None; layout.faces.len()];
        Self { data, shell, size, edges, layout, users, surface, vertex, edge }
    }

    /// Length of the shortest edge of the file.
    fn shortest_edge(&self) -> f64 {
        let length = |edge: &LayoutEdge| match &edge.form {
            EdgeForm::Own(own) => self.shell.edges()[*own].curve.length(),
            EdgeForm::Joined(ChainCurve::Arc(arc)) => arc.length(),
            EdgeForm::Joined(ChainCurve::Circle(circle)) => std::f64::consts::TAU * circle.radius(),
        };
        self.layout.edges.iter().map(length).fold(f64::INFINITY, f64::min)
    }

    fn face(&mut self, index: usize, flip: bool) -> Result<usize> {
        let surface = self.surface(index)?;
        let bounds = (0..self.layout.faces[index].bounds.len())
            .map(|bound| self.bound(index, bound, flip))
            .collect::<Result<Vec<_>>>()?;
        let same_sense = logical(self.layout.faces[index].outward != flip);
        Ok(self.data.write(|out| {
            out.push_str("ADVANCED_FACE('',");
            push_list(out, bounds, push_reference);
            let _ = write!(out, ",#{surface},{same_sense})");
        }))
    }

    /// The surface of a face.
    fn surface(&mut self, index: usize) -> Result<usize> {
        if let Some(found) = self.surface[index] {
            return Ok(found);
        }
        let face = &self.layout.faces[index];
        let found = match surfaces::analytic(self.data, &face.kind) {
            Some((found, _)) => found,
            None => self.rational(face.faces[0])?,
        };
        self.surface[index] = Some(found);
        Ok(found)
    }

    /// The rational surface of a face of the shell; neighbors get the same control points along their common edge.
    fn rational(&mut self, index: usize) -> Result<usize> {
        let face = &self.shell.faces()[index];
        let patch = match &face.surface {
            FaceSurface::Cyclide(patch) => patch,
            FaceSurface::Rational(surface) => return surfaces::rational(self.data, surface),
        };
        let corners = patch.corners();
        let arc = |side: Side| self.shell.edges()[face.side(side)?.edge].curve.arc();
        let middles: [Point3; 4] =
            Side::ALL.map(|side| arc(side).map_or(corners[side.corners()[0]], surfaces::middle_point));
        surfaces::biquadratic(self.data, patch, middles)
    }

    /// A loop of a face, counter-clockwise against its outer side if it is the first one; a side of one point is no edge.
    fn bound(&mut self, face: usize, bound: usize, flip: bool) -> Result<usize> {
        let mut own: Vec<(usize, bool)> =
            self.layout.faces[face].bounds[bound].iter().map(|edge| (edge.edge, edge.forward != flip)).collect();
        if flip {
            own.reverse();
        }
        let mut oriented = Vec::with_capacity(own.len());
        for (edge, forward) in own {
            let edge = self.edge(edge)?;
            oriented.push(self.data.write(|out| {
                let _ = write!(out, "ORIENTED_EDGE('',*,*,#{edge},{})", logical(forward));
            }));
        }
        let edges = self.data.write(|out| {
            out.push_str("EDGE_LOOP('',");
            push_list(out, oriented, push_reference);
            out.push(')');
        });
        let kind = if bound == 0 { "FACE_OUTER_BOUND" } else { "FACE_BOUND" };
        Ok(self.data.write(|out| {
            let _ = write!(out, "{kind}('',#{edges},.T.)");
        }))
    }

    fn edge(&mut self, index: usize) -> Result<usize> {
        if let Some(number) = self.edge[index] {
            return Ok(number);
        }
        let ends = self.layout.edges[index].ends;
        let [start, end] = ends.map(|vertex| self.vertex(vertex));
        let curve = match self.space_curve(index)? {
            SpaceCurve::Rational(curve) => {
                let along = self.has_uneven_face(index).then(ParameterCurve::proportional);
                self.on_faces(index, curve, along.as_ref(), 1.0)?
            }
            SpaceCurve::Line(curve, arc) => {
                let along = ParameterCurve::along_line(&arc);
                self.on_faces(index, curve, along.as_ref(), arc.chord().length())?
            }
            SpaceCurve::Circle(curve, arc) => {
                let along = ParameterCurve::along_circle(&arc);
                self.on_faces(index, curve, along.as_ref(), arc.angle())?
            }
            SpaceCurve::Joined(curve) => curve,
        };
        let number = self.data.write(|out| {
            let _ = write!(out, "EDGE_CURVE('',#{start},#{end},#{curve},.T.)");
        });
        self.edge[index] = Some(number);
        Ok(number)
    }

    fn vertex(&mut self, index: usize) -> usize {
        *self.vertex[index].get_or_insert_with(|| {
            let own = self.shell.vertices();
            let point =
                self.data.point(own.get(index).copied().unwrap_or_else(|| self.layout.points[index - own.len()]));
            self.data.write(|out| {
                let _ = write!(out, "VERTEX_POINT('',#{point})");
            })
        })
    }

    /// Whether a face along an edge has weights far from each other. From these OpenCASCADE takes its surface for so fast that it
    /// holds the rounding of curves in the parameters, where it has to find them itself, for gaps, and closes these with edges
    /// that are points: loops which it reads as crossing themselves.
    fn has_uneven_face(&self, index: usize) -> bool {
        let uneven = |&(face, (of_shell, _)): &(usize, (usize, Side))| match &self.shell.faces()[of_shell].surface {
            FaceSurface::Rational(surface) if self.layout.faces[face].kind == PatchKind::Cyclide => {
                let weights = || surface.rows().iter().map(|row| row[3]);
                weights().fold(0.0, f64::max) > UNEVEN * weights().fold(f64::INFINITY, f64::min)
            }
            _ => false,
        };
        self.users[index].iter().any(uneven)
    }

    /// A curve over `[0, range]` with the curves in the parameters of its faces that readers cannot find exactly: on rational
    /// surfaces `along`, of rational edges on cylinders and cones, and of circles on spheres that are no parameter lines. Other circles and
    /// lines are parameter lines of analytic surfaces, which they can.
    fn on_faces(&mut self, index: usize, curve: usize, along: Option<&ParameterCurve>, range: f64) -> Result<usize> {
        let mut found = Vec::with_capacity(2);
        for (face, (of_shell, side)) in self.users[index].clone() {
            let Some(edge) = self.shell.faces()[of_shell].side(side) else { continue };
            let along = along.filter(|_| self.layout.faces[face].kind == PatchKind::Cyclide);
            let round_axis = self.round_axis(index, face);
            if along.is_none() && round_axis.is_none() {
                continue;
            }
            // Before what refers to it.
            let surface = self.surface(face)?;
            let on_face = match (along, round_axis) {
                (Some(along), _) => along.write(self.data, side, edge, range),
                (None, Some(round_axis)) => round_axis.write(self.data),
                (None, None) => continue,
            };
            found.push(self.data.parameter_curve(surface, on_face));
        }
        if found.is_empty() {
            return Ok(curve);
        }
        Ok(self.data.write(|out| {
            let _ = write!(out, "SURFACE_CURVE('',#{curve},");
            push_list(out, found, push_reference);
            out.push_str(",.CURVE_3D.)");
        }))
    }

    /// The curve of a rational edge in the parameters of a face that is written as a cylinder or a cone, and of a circle on a sphere that is
    /// no parameter line.
    fn round_axis(&self, edge: usize, face: usize) -> Option<PolarCurve> {
        let EdgeForm::Own(own) = self.layout.edges[edge].form else { return None };
        let face = &self.layout.faces[face];
        match &self.shell.edges()[own].curve {
            EdgeCurve::Rational(edge) => PolarCurve::of(edge, &face.kind, self.size),
            EdgeCurve::Arc(arc) if face.faces.len() > 1 && !is_parameter_line(&face.kind, arc) => {
                PolarCurve::of_arc(arc, &face.kind, self.size)
            }
            EdgeCurve::Arc(_) => None,
        }
    }

    /// A circle or a line; the rational quadratic in the parameter of the faces where the circle would lose digits, and
    /// where that is asked for, but for lines at constant speed.
    fn space_curve(&mut self, index: usize) -> Result<SpaceCurve> {
        let own = match &self.layout.edges[index].form {
            EdgeForm::Own(own) => *own,
            EdgeForm::Joined(ChainCurve::Circle(circle)) => {
                return Ok(SpaceCurve::Joined(curves::circle_from(self.data, circle)));
            }
            EdgeForm::Joined(ChainCurve::Arc(arc)) => {
                let arc = *arc;
                if is_straight(&arc, self.size) {
                    return Ok(SpaceCurve::Joined(curves::line(self.data, &arc)));
                }
                if let Some(circle) = curves::circle(self.data, &arc, self.size) {
                    return Ok(SpaceCurve::Joined(circle));
                }
                return Ok(SpaceCurve::Joined(curves::b_spline(
                    self.data,
                    arc.to_nurbs(cyclide::curve::DEFAULT_PIECE_ANGLE)?,
                )));
            }
        };
        let arc = match &self.shell.edges()[own].curve {
            EdgeCurve::Arc(arc) => arc,
            EdgeCurve::Rational(curve) => {
                return Ok(SpaceCurve::Rational(curves::b_spline(self.data, curve.to_nurbs()?)));
            }
        };
        let straight = is_straight(arc, self.size);
        let circles = self.edges == StepEdges::Circles;
        if straight && (circles || ParameterCurve::along_line(arc).is_none()) {
            return Ok(SpaceCurve::Line(curves::line(self.data, arc), *arc));
        }
        if circles && let Some(circle) = curves::circle(self.data, arc, self.size) {
            return Ok(SpaceCurve::Circle(circle, *arc));
        }
        let weights = arc.bezier_rows().map(|row| row[3]).to_vec();
        let points = vec![arc.start(), surfaces::middle_point(arc), arc.end()];
        let curve = NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points, weights)?;
        Ok(SpaceCurve::Rational(curves::b_spline(self.data, curve)))
    }
}
