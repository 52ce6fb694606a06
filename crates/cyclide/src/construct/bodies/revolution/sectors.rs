//! The faces of a profile that turns, in sectors of a quarter turn at most, sewn.

use super::Revolution;
use super::ends::{EndSide, Ends};
use super::profile::Profile;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::{PointError, Result};
use crate::rational::RationalBezierSurface;
use crate::surface::CyclidePatch;
use crate::topology::{EdgeCurve, FaceEdge, FaceSurface, Sewing, Shell};
use std::f64::consts::FRAC_PI_2;

/// What a profile sweeps, in what is sewn: its vertices and meridians at every boundary between sectors.
struct Walls {
    /// By joint; one vertex alone on the axis.
    vertices: Vec<Vec<usize>>,
    /// By boundary.
    meridians: Vec<Vec<usize>>,
}

/// The sectors of a turn: their number and the angle of each.
fn sectors(turn: &Revolution) -> (usize, f64) {
    let count = (turn.angle.abs() / FRAC_PI_2 * (1.0 - 1e-12)).ceil().max(1.0) as usize;
    (count, turn.angle / count as f64)
}

/// The shell of all sectors of a profile.
pub(super) fn open_shell(turn: &Revolution, profile: &Profile) -> Result<Shell> {
    let mut sewing = Sewing::default();
    profile.sweep(turn, &mut sewing)?;
    sewing.finish()
}

/// The shell of all sectors of profiles, and of the faces at both ends.
pub(super) fn closed_shell(turn: &Revolution, ends: &Ends) -> Result<Shell> {
    let mut sewing = Sewing::default();
    let walls = ends.profiles.iter().map(|profile| profile.sweep(turn, &mut sewing)).collect::<Result<Vec<_>>>()?;
    let mut on_axis = vec![None; ends.sides.len()];
    for k in [0, sectors(turn).0] {
        let (mut vertices, mut edges) = (Vec::new(), Vec::new());
        for (number, side) in ends.sides.iter().enumerate() {
            match *side {
                EndSide::Piece { profile, piece } => {
                    vertices.push(walls[profile].vertex(piece, k));
                    edges.push(walls[profile].meridians[k][piece]);
                }
                EndSide::Axis { from, to } => {
                    let [start, end] =
                        [walls[from].vertex(ends.profiles[from].joints.len() - 1, k), walls[to].vertex(0, k)];
                    let edge = on_axis[number].map_or_else(|| sewing.segment(start, end), Ok)?;
                    on_axis[number] = Some(edge);
                    vertices.push(start);
                    edges.push(edge);
                }
            }
        }
        let edges: Vec<FaceEdge> = edges.into_iter().map(|edge| FaceEdge { edge, forward: true }).collect();
        let image = |p| if k == 0 { p } else { turn.turned(p, turn.angle) };
        // The outside of the last faces is ahead.
        ends.cover.sew(&mut sewing, vertices, &edges, image, k > 0)?;
    }
    sewing.finish()
}

impl Walls {
    fn vertex(&self, joint: usize, boundary: usize) -> usize {
        let vertices = &self.vertices[joint];
        vertices[boundary % vertices.len()]
    }
}

impl Profile {
    /// Adds the faces of all sectors.
    fn sweep(&self, turn: &Revolution, sewing: &mut Sewing) -> Result<Walls> {
        let (sectors, step) = sectors(turn);
        let boundaries = if turn.is_whole() { sectors } else { sectors + 1 };
        let (pieces, joints) = (self.pieces.len(), self.joints.len());
        let next = |j: usize| (j + 1) % joints;
        let (sin, cos) = (0.5 * step).sin_cos();
        let rotor = Quat::new(cos, turn.axis.x * sin, turn.axis.y * sin, turn.axis.z * sin);
        // Joints on the axis are one vertex each, before those that turn.
        let mut vertices: Vec<Vec<usize>> = vec![Vec::new(); joints];
        for (j, joint) in self.joints.iter().enumerate() {
            // From a place of the axis back to it: in a part of a turn one vertex.
            let same = |&i: &usize| !turn.is_whole() && joint.on_axis && self.joints[i].point == joint.point;
            if let Some(i) = (0..j.min(1)).find(same) {
                vertices[j] = vertices[i].clone();
                continue;
            }
            for k in 0..if joint.on_axis { 1 } else { boundaries } {
                let point = if k == 0 { joint.point } else { turn.turned(joint.point, step * k as f64) };
                vertices[j].push(sewing.vertex(point));
            }
        }
        let mut walls = Walls { vertices, meridians: vec![Vec::with_capacity(pieces); boundaries] };
        for k in 0..boundaries {
            let map = rotation(turn, step * k as f64)?;
            for (j, piece) in self.pieces.iter().enumerate() {
                let (start, end) = (walls.vertex(j, k), walls.vertex(next(j), k));
                let curve = match k {
                    0 => piece.curve.clone(),
                    _ => piece.curve.image(&map, sewing.vertices[start], sewing.vertices[end])?,
                };
                walls.meridians[k].push(sewing.edge(start, end, curve));
            }
        }
        let mut parallels = vec![vec![None; joints]; sectors];
        for (k, of_sector) in parallels.iter_mut().enumerate() {
            for (j, _) in self.joints.iter().enumerate().filter(|(_, joint)| !joint.on_axis) {
                of_sector[j] = Some(sewing.arc(walls.vertex(j, k), walls.vertex(j, k + 1), rotor)?);
            }
        }
        for (k, parallels) in parallels.iter().enumerate() {
            for (j, piece) in self.pieces.iter().enumerate() {
                let [low, high] = [walls.meridians[k][j], walls.meridians[(k + 1) % boundaries][j]];
                let sides = [Some(low), Some(high), parallels[j], parallels[next(j)]];
                let corners = [(j, k), (next(j), k), (j, k + 1), (next(j), k + 1)];
                let corners = corners.map(|(j, k)| sewing.vertices[walls.vertex(j, k)]);
                let across = piece.across.map(|across| rotated(turn, across, step * k as f64));
                let [low, high] = [low, high].map(|edge| &sewing.edges[edge].curve);
                let surface = face(turn, [low, high], across, corners, rotor)?;
                sewing.face(surface, sides, true);
            }
        }
        Ok(walls)
    }
}

/// The face between a meridian and the next one.
fn face(
    turn: &Revolution,
    [low, high]: [&EdgeCurve; 2],
    across: Option<Vec3>,
    corners: [Point3; 4],
    rotor: Quat,
) -> Result<FaceSurface> {
    if let (EdgeCurve::Arc(arc), Some(across)) = (low, across) {
        // Far from the axis for its size the direction has the rounding of its place: that of the turn is known better.
        let along = arc.start_tangent().ok_or(PointError::ZeroTangent { index: 0 })?;
        let along = along - across * along.dot(across);
        let ratio = arc.weight_ratio();
        let weights = [Quat::ONE, ratio, rotor, rotor * ratio];
        let patch = CyclidePatch::from_weights(corners, weights, along, across)?;
        return Ok(patch.into());
    }
    let (r, p, o) = (rotor.w, rotor.vector(), turn.origin.to_vec());
    let rows = low.bezier_rows().into_iter().zip(high.bezier_rows()).flat_map(|(a, b)| {
        let [x, y, z, g] = a;
        let from_axis = Vec3::new(x, y, z) - o * g;
        let middle = o * (r * g) + from_axis * r + p.cross(from_axis);
        [a, [middle.x, middle.y, middle.z, r * g], b]
    });
    let rows: Vec<[f64; 4]> = rows.collect();
    let degree = rows.len() / 3 - 1;
    Ok(RationalBezierSurface::new([degree, 2], rows)?.with_corners(corners).into())
}

fn rotation(turn: &Revolution, angle: f64) -> Result<Mobius> {
    Mobius::rotation_about_unit(turn.origin, turn.axis, angle)
}

fn rotated(turn: &Revolution, v: Vec3, angle: f64) -> Vec3 {
    Quat::from_axis_angle(turn.axis, angle).rotate(v)
}
