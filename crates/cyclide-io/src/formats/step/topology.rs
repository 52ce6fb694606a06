//! Bodies: vertices, edges, loops and faces, all shared, in open and closed shells.

use super::curves;
use super::data::{Data, logical, push_list, push_reference, references, string};
use super::integration::Integration;
use super::parameter_curves::ParameterCurve;
use super::polar_curves::PolarCurve;
use super::surfaces;
use crate::export::face_plan::ShellPlan;
use crate::export::options::StepEdges;
use cyclide::{
    Arc, Body, CutShell, EdgeCurve, FaceSurface, NurbsCurve, PatchKind, Point3, Result, Shell, ShellFace, Side,
};
use std::fmt::Write as _;

/// An edge that departs from its chord by no more than this part of the model's size is a line: its curvature is
/// rounding.
const STRAIGHT: f64 = 1e-15;

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
pub(super) fn body(data: &mut Data, name: &str, body: &Body, size: f64, edges: StepEdges) -> Result<Written> {
    let shells = body.shells().map(|shell| cut(shell, size, edges)).collect::<Result<Vec<CutShell>>>()?;
    let lengths = shells.iter().flat_map(|cut| cut.shell().edges()).map(|edge| edge.curve.length());
    let shortest = lengths.fold(f64::INFINITY, f64::min);
    let parts: Vec<Vec<Vec<usize>>> = shells.iter().map(|cut| cut.shell().parts()).collect();
    let closed: Vec<bool> = shells.iter().map(|cut| cut.shell().is_closed()).collect();
    let solid = closed.iter().all(|&c| c) && parts.iter().all(|p| p.len() == 1);
    let touches_itself = closed[0] && parts[0].len() > 1;
    let (mut written, mut plans) = (Vec::new(), Vec::new());
    for (index, (cut, parts)) in shells.iter().zip(&parts).enumerate() {
        // A void is written as the boundary of the hollow, whose outer side is the other one.
        let flip = solid && index > 0;
        let mut writer = Writer::new(data, cut.shell(), size, edges);
        for part in parts {
            let faces = part.iter().map(|&f| writer.face(f, flip)).collect::<Result<Vec<_>>>()?;
            let kind = if closed[index] { "CLOSED_SHELL" } else { "OPEN_SHELL" };
            written.push(writer.data.add(&format!("{kind}('',{})", references(&faces))));
            plans.push(ShellPlan { shell: index, faces: part.iter().map(|&f| cut.parts()[f]).collect() });
        }
    }
    let entity = entity(data, name, solid, &written);
    Ok(Written { entity, shells: plans, shortest, touches_itself })
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
}

/// One shell as it is written: the numbers of what is shared already.
struct Writer<'a> {
    data: &'a mut Data,
    shell: &'a Shell,
    size: f64,
    edges: StepEdges,
    /// The surface of each face.
    kinds: Vec<PatchKind>,
    /// Of each edge the faces along it, with the side of each.
    users: Vec<Vec<(usize, Side)>>,
    /// Surfaces, `VERTEX_POINT`s and `EDGE_CURVE`s already written; of a surface also whether its normal is the patch's.
    surface: Vec<Option<(usize, bool)>>,
    vertex: Vec<Option<usize>>,
    edge: Vec<Option<usize>>,
}

impl<'a> Writer<'a> {
    fn new(data: &'a mut Data, shell: &'a Shell, size: f64, edges: StepEdges) -> Self {
        let kinds = shell.faces().iter().map(|face| surfaces::kind(shell, face, size, edges)).collect();
        let users = shell.faces_along_edges();
        let (vertex, edge) = (vec![None; shell.vertices().len()], vec![None; shell.edges().len()]);
        let surface = vec![None; shell.faces().len()];
        Self { data, shell, size, edges, kinds, users, surface, vertex, edge }
    }

    fn face(&mut self, index: usize, flip: bool) -> Result<usize> {
        let face = &self.shell.faces()[index];
        let (surface, outward) = self.surface(index)?;
        let outer_side = face.same_sense != flip;
        let bound = self.bound(face, outer_side)?;
        let same_sense = logical(outer_side == outward);
        Ok(self.data.write(|out| {
            let _ = write!(out, "ADVANCED_FACE('',(#{bound}),#{surface},{same_sense})");
        }))
    }

    /// The surface of a face, and whether its own normal is that of the patch.
    fn surface(&mut self, index: usize) -> Result<(usize, bool)> {
        if let Some(found) = self.surface[index] {
            return Ok(found);
        }
        let found = match surfaces::analytic(self.data, &self.kinds[index]) {
            Some(found) => found,
            None => (self.rational(&self.shell.faces()[index])?, true),
        };
        self.surface[index] = Some(found);
        Ok(found)
    }

    /// The rational surface of a face; neighbours get the same control points along their common edge.
    fn rational(&mut self, face: &ShellFace) -> Result<usize> {
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

    /// The loop of a face, counter-clockwise against its outer side; a side of one point is no edge.
    fn bound(&mut self, face: &ShellFace, outer_side: bool) -> Result<usize> {
        let mut oriented = Vec::with_capacity(4);
        for (_, edge, forward) in face.edge_loop(outer_side) {
            let edge = self.edge(edge.edge)?;
            oriented.push(self.data.write(|out| {
                let _ = write!(out, "ORIENTED_EDGE('',*,*,#{edge},{})", logical(forward));
            }));
        }
        let edges = self.data.write(|out| {
            out.push_str("EDGE_LOOP('',");
            push_list(out, oriented, push_reference);
            out.push(')');
        });
        Ok(self.data.write(|out| {
            let _ = write!(out, "FACE_OUTER_BOUND('',#{edges},.T.)");
        }))
    }

    fn edge(&mut self, index: usize) -> Result<usize> {
        if let Some(number) = self.edge[index] {
            return Ok(number);
        }
        let edge = &self.shell.edges()[index];
        let (start, end) = (self.vertex(edge.start), self.vertex(edge.end));
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
        };
        let number = self.data.write(|out| {
            let _ = write!(out, "EDGE_CURVE('',#{start},#{end},#{curve},.T.)");
        });
        self.edge[index] = Some(number);
        Ok(number)
    }

    fn vertex(&mut self, index: usize) -> usize {
        *self.vertex[index].get_or_insert_with(|| {
            let point = self.data.point(self.shell.vertices()[index]);
            self.data.write(|out| {
                let _ = write!(out, "VERTEX_POINT('',#{point})");
            })
        })
    }

    /// Whether a face along an edge has weights far from each other. From these OpenCASCADE takes its surface for so fast that it
    /// holds the rounding of curves in the parameters, where it has to find them itself, for gaps, and closes these with edges
    /// that are points: loops which it reads as crossing themselves.
    fn has_uneven_face(&self, index: usize) -> bool {
        let uneven = |&(face, _): &(usize, Side)| match &self.shell.faces()[face].surface {
            FaceSurface::Rational(surface) if self.kinds[face] == PatchKind::Cyclide => {
                let weights = || surface.rows().iter().map(|row| row[3]);
                weights().fold(0.0, f64::max) > UNEVEN * weights().fold(f64::INFINITY, f64::min)
            }
            _ => false,
        };
        self.users[index].iter().any(uneven)
    }

    /// A curve over `[0, range]` with the curves in the parameters of its faces that readers cannot find exactly: on rational
    /// surfaces `along`, and of rational edges on cylinders and cones. Circles and lines are parameter lines of analytic surfaces, which they
    /// can.
    fn on_faces(&mut self, index: usize, curve: usize, along: Option<&ParameterCurve>, range: f64) -> Result<usize> {
        let mut found = Vec::with_capacity(2);
        for (face, side) in self.users[index].clone() {
            let Some(edge) = self.shell.faces()[face].side(side) else { continue };
            let along = along.filter(|_| self.kinds[face] == PatchKind::Cyclide);
            let round_axis = self.round_axis(index, face);
            if along.is_none() && round_axis.is_none() {
                continue;
            }
            // Before what refers to it.
            let (surface, _) = self.surface(face)?;
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

    /// The curve of a rational edge in the parameters of a face that is written as a cylinder or a cone.
    fn round_axis(&self, edge: usize, face: usize) -> Option<PolarCurve> {
        match &self.shell.edges()[edge].curve {
            EdgeCurve::Rational(edge) => PolarCurve::of(edge, &self.kinds[face], self.size),
            EdgeCurve::Arc(_) => None,
        }
    }

    /// A circle or a line; the rational quadratic in the parameter of the faces where the circle would lose digits, and
    /// where that is asked for, but for lines at constant speed.
    fn space_curve(&mut self, index: usize) -> Result<SpaceCurve> {
        let arc = match &self.shell.edges()[index].curve {
            EdgeCurve::Arc(arc) => arc,
            EdgeCurve::Rational(curve) => {
                return Ok(SpaceCurve::Rational(curves::b_spline(self.data, curve.to_nurbs()?)));
            }
        };
        let sagitta = 0.5 * arc.chord().length() * arc.bulge_vector().length();
        let straight = sagitta <= STRAIGHT * self.size;
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
