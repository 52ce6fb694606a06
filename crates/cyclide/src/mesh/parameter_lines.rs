//! Parameter lines as polylines: what pictures of a body draw on its faces.

use super::flatten::flatten;
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::topology::{Body, EdgeCurve, FaceGeometry as _, Shell, ShellFace, Side};

/// Which parameter lines a polyline follows.
///
/// ```
/// use cyclide::{mesh::{LineKind, parameter_lines}, surface::DupinCyclide};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.to_bodies([4, 4])?;
/// let lines = parameter_lines(&torus[0], 2, 0.01)?;
/// assert!(lines.iter().any(|line| line.kind == LineKind::Edge) && lines.iter().any(|line| line.kind == LineKind::Inner));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// The common edge of patches, or a side without neighbor.
    Edge,
    /// A parameter line inside a face.
    Inner,
}

/// A parameter line of a body as a polyline.
///
/// ```
/// use cyclide::{mesh::parameter_lines, surface::DupinCyclide};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.to_bodies([4, 4])?;
/// let lines = parameter_lines(&torus[0], 0, 0.01)?;
/// assert!(lines.iter().all(|line| line.points.len() == line.normals.len() && line.shell == 0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterLine {
    /// Edge or inner line.
    pub kind: LineKind,
    /// Index of the shell, the outer one first.
    pub shell: usize,
    /// Points on the line, ends included.
    pub points: Vec<Point3>,
    /// The outer unit normal of the surface at each point; on an edge the mean of its faces'.
    pub normals: Vec<Vec3>,
}

/// Every edge of the body once, then `inner` parameter lines (circles on cyclides) of each face in each direction, at equal steps of the
/// parameter, so that they continue from face to face. No point of a line is farther than `tolerance` from its polyline.
///
/// ```
/// use cyclide::{surface::DupinCyclide, topology::Body};
/// let ring = Body { outer: DupinCyclide::new(3.0, 0.0, 1.0)?.to_shell()?, voids: Vec::new() };
/// let lines = cyclide::mesh::parameter_lines(&ring, 0, 0.1)?;
/// assert_eq!(lines.len(), ring.outer.edges().len());
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// As [`flatten`]; as [`CyclidePatch::s_line`](crate::surface::CyclidePatch::s_line).
pub fn parameter_lines(body: &Body, inner: usize, tolerance: f64) -> Result<Vec<ParameterLine>> {
    let mut lines = Vec::new();
    for (index, shell) in body.shells().enumerate() {
        edge_lines(shell, index, tolerance, &mut lines)?;
        for face in shell.faces() {
            for k in 1..=inner {
                let u = k as f64 / (inner + 1) as f64;
                let along_s = (face.surface.s_line(u)?, &(|v| (v, u)) as &dyn Fn(f64) -> (f64, f64));
                for (curve, place) in [along_s, (face.surface.t_line(u)?, &|v| (u, v))] {
                    // A line that is one point is no line.
                    if !is_point(&curve) {
                        let normal = |v: f64| outer_normal(face, place(v));
                        lines.push(line(&curve, LineKind::Inner, index, tolerance, normal)?);
                    }
                }
            }
        }
    }
    Ok(lines)
}

/// Appends the edges of a shell.
fn edge_lines(shell: &Shell, index: usize, tolerance: f64, lines: &mut Vec<ParameterLine>) -> Result<()> {
    for (edge, faces) in shell.edges().iter().zip(shell.faces_along_edges()) {
        let normal = |u: f64| {
            let of_face = |&(face, side): &(usize, Side)| {
                let face = &shell.faces()[face];
                outer_normal(face, side.place(face.side(side).map_or(u, |edge| edge.turned(u))))
            };
            let first = faces.first().map_or(Vec3::ZERO, of_face);
            // Faces folded back on each other have no mean.
            faces.iter().skip(1).map(of_face).fold(first, |a, b| a + b).unit().unwrap_or(first)
        };
        lines.push(line(&edge.curve, LineKind::Edge, index, tolerance, normal)?);
    }
    Ok(())
}

fn line(
    curve: &EdgeCurve,
    kind: LineKind,
    shell: usize,
    tolerance: f64,
    normal: impl Fn(f64) -> Vec3,
) -> Result<ParameterLine> {
    let (normals, points) = flatten(curve, tolerance)?.into_iter().map(|(u, p)| (normal(u), p)).unzip();
    Ok(ParameterLine { kind, shell, points, normals })
}

/// True for a parameter line that is one point. Of rational surfaces only sides are.
fn is_point(curve: &EdgeCurve) -> bool {
    curve.arc().is_some_and(|arc| arc.chord().max_abs() == 0.0)
}

fn outer_normal(face: &ShellFace, (s, t): (f64, f64)) -> Vec3 {
    face.outer_normal(s, t).unwrap_or_default()
}
