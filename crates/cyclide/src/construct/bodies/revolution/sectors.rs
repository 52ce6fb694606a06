//! The faces of a profile that turns, in sectors of a quarter turn at most, sewn.

use super::Revolution;
use super::caps::{self, End};
use super::profile::Profile;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::{Error, Result};
use crate::rational::RationalBezierSurface;
use crate::surface::CyclidePatch;
use crate::topology::{EdgeCurve, FaceSurface, Sewing, Shell};
use std::f64::consts::FRAC_PI_2;

impl Profile {
    /// The shell of all sectors, with end faces about a point of the profile's plane if there is one.
    pub(super) fn swept(&self, turn: &Revolution, centre: Option<Point3>) -> Result<Shell> {
        let sectors = (turn.angle.abs() / FRAC_PI_2 * (1.0 - 1e-12)).ceil().max(1.0) as usize;
        let step = turn.angle / sectors as f64;
        let whole = turn.is_whole();
        let boundaries = if whole { sectors } else { sectors + 1 };
        let (pieces, joints) = (self.pieces.len(), self.joints.len());
        let next = |j: usize| (j + 1) % joints;
        let (sin, cos) = (0.5 * step).sin_cos();
        let rotor = Quat::new(cos, turn.axis.x * sin, turn.axis.y * sin, turn.axis.z * sin);
        // Joints on the axis are one vertex each, before those that turn.
        let mut sewing = Sewing::default();
        let mut of_joint = vec![Vec::new(); joints];
        for (j, joint) in self.joints.iter().enumerate() {
            for k in 0..if joint.on_axis { 1 } else { boundaries } {
                let point = if k == 0 { joint.point } else { turn.turned(joint.point, step * k as f64) };
                of_joint[j].push(sewing.vertex(point));
            }
        }
        let vertex = |j: usize, k: usize| of_joint[j][if self.joints[j].on_axis { 0 } else { k % boundaries }];
        let mut meridians = vec![Vec::with_capacity(pieces); boundaries];
        for (k, of_boundary) in meridians.iter_mut().enumerate() {
            let map = rotation(turn, step * k as f64)?;
            for (j, piece) in self.pieces.iter().enumerate() {
                let (start, end) = (vertex(j, k), vertex(next(j), k));
                let curve = match k {
                    0 => piece.curve.clone(),
                    _ => piece.curve.image(&map, sewing.vertices[start], sewing.vertices[end])?,
                };
                of_boundary.push(sewing.edge(start, end, curve));
            }
        }
        let mut parallels = vec![vec![None; joints]; sectors];
        for (k, of_sector) in parallels.iter_mut().enumerate() {
            for (j, _) in self.joints.iter().enumerate().filter(|(_, joint)| !joint.on_axis) {
                of_sector[j] = Some(sewing.arc(vertex(j, k), vertex(j, k + 1), rotor)?);
            }
        }
        for k in 0..sectors {
            for (j, piece) in self.pieces.iter().enumerate() {
                let [low, high] = [meridians[k][j], meridians[(k + 1) % boundaries][j]];
                let sides = [Some(low), Some(high), parallels[k][j], parallels[k][next(j)]];
                let corners = [vertex(j, k), vertex(next(j), k), vertex(j, k + 1), vertex(next(j), k + 1)];
                let corners = corners.map(|v| sewing.vertices[v]);
                let across = piece.across.map(|across| rotated(turn, across, step * k as f64));
                let [low, high] = [low, high].map(|edge| &sewing.edges[edge].curve);
                let surface = face(turn, [low, high], across, corners, rotor)?;
                sewing.face(surface, sides, true);
            }
        }
        if let Some(centre) = centre {
            let axis = if self.closed { None } else { Some(sewing.segment(vertex(joints - 1, 0), vertex(0, 0))?) };
            for k in [0, sectors] {
                let vertices = (0..joints).map(|j| vertex(j, k)).collect();
                let edges = meridians[k].iter().copied().chain(axis).collect();
                let centre = if k == 0 { centre } else { turn.turned(centre, turn.angle) };
                caps::add(&mut sewing, &End { vertices, edges, centre, last: k > 0 })?;
            }
        }
        sewing.finish()
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
        let along = arc.start_tangent().ok_or(Error::ZeroTangent { index: 0 })?;
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
