//! A side of a triangle: its curve, and the normal of the surface along it.

use super::SMOOTH_LAW;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{BlendSegment, BlendTangents, BlendVariation, Chord};
use crate::error::{PointError, Result, TriangleError};

/// A line is along a normal if less than this part of it is across.
const ALONG: f64 = 1e-9;
/// A blended normal across its edge that is shorter has no direction.
const OPPOSITE: f64 = 1e-9;

/// The unit vector of what a unit direction has across a unit normal, and its length before.
///
/// # Errors
/// `normal-along-edge`.
pub(super) fn tangent_across(direction: Vec3, normal: Vec3, corner: usize) -> Result<(Vec3, f64)> {
    let across = direction - normal * direction.dot(normal);
    // Of unit vectors: no square leaves the range of doubles.
    let length = across.length_squared().sqrt();
    if length > ALONG {
        Ok((across / length, length))
    } else {
        Err(TriangleError::NormalAlongEdge { corner, across: length, limit: ALONG }.into())
    }
}

/// The blend of order 2 between two points with unit tangents at both.
///
/// # Errors
/// `coincident-points`, `arc-through-infinity`, `ambiguous-half-turn`.
pub(super) fn blend(ends: [Point3; 2], chord: &Chord, tangents: [Vec3; 2]) -> Result<BlendSegment> {
    if !(chord.length > 0.0) {
        return Err(PointError::CoincidentPoints { first: 0, second: 1, distance: chord.length, limit: 0.0 }.into());
    }
    let [start, end] = tangents;
    let tangents = BlendTangents { start, end: end.reflect(chord.unit), magnification: 0.0 };
    BlendSegment::from_tangents(ends, chord, &tangents, SMOOTH_LAW, 0)
}

/// The curve of a side and the unit normals at its ends. It runs from the corner that comes first, so that both triangles
/// beside it compute the same bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Side {
    pub(super) curve: BlendSegment,
    pub(super) normals: [Vec3; 2],
}

/// A place of a side with its derivatives along it.
#[derive(Debug, Clone, Copy)]
pub(super) struct SidePlace {
    pub(super) point: Point3,
    pub(super) velocity: Vec3,
    /// Unit normal of the surface.
    pub(super) normal: Vec3,
    pub(super) normal_change: Vec3,
}

impl Side {
    /// Point and normal at `mu` on the side opposite to `corner`: the normal is what the mean of those at the ends has
    /// across the curve.
    ///
    /// # Errors
    /// `opposite-normals`.
    pub(super) fn at(&self, mu: f64, corner: usize) -> Result<SidePlace> {
        let jet = self.curve.jet(mu);
        let [first, second] = self.normals;
        let (mean, change) = (first * (1.0 - mu) + second * mu, second - first);
        let along = jet.tangent().unwrap_or(Vec3::ZERO);
        let turn = (jet.d2 - along * along.dot(jet.d2)) / along.dot(jet.d1);
        let across = mean - along * mean.dot(along);
        let length = across.length_squared().sqrt();
        if !(length > OPPOSITE) {
            return Err(TriangleError::OppositeNormals { corner, length, limit: OPPOSITE }.into());
        }
        let normal = across / length;
        let across_change = change - along * (change.dot(along) + mean.dot(turn)) - turn * mean.dot(along);
        let normal_change = (across_change - normal * normal.dot(across_change)) / length;
        Ok(SidePlace { point: jet.point, velocity: jet.d1, normal, normal_change })
    }
}

/// The arc from a corner to a place of the opposite side, with what it was made from.
pub(super) struct SpokeArc {
    arc: BlendSegment,
    chord: Chord,
    /// Normal at the corner.
    normal: Vec3,
    to: SidePlace,
    /// Tangents at both ends, and the parts of the chord across the normals.
    tangents: [(Vec3, f64); 2],
}

impl SpokeArc {
    /// # Errors
    /// `normal-along-edge`, and as [`blend`].
    pub(super) fn new(corner: usize, vertex: Point3, normal: Vec3, to: &SidePlace) -> Result<Self> {
        let chord = Chord::new(vertex, to.point);
        let tangents = [tangent_across(chord.unit, normal, corner)?, tangent_across(chord.unit, to.normal, corner)?];
        let arc = blend([vertex, to.point], &chord, tangents.map(|(tangent, _)| tangent))?;
        Ok(Self { arc, chord, normal, to: *to, tangents })
    }

    /// The point at `l`, from 0 at the corner to 1 on the side.
    pub(super) fn point(&self, l: f64) -> Point3 {
        self.arc.point(l)
    }

    /// Derivatives at `l`: along the arc, and by the parameter of the side.
    pub(super) fn derivatives(&self, l: f64) -> [Vec3; 2] {
        self.arc.first_derivatives(l, &self.by_place())
    }

    /// How the arc moves with its place on the side.
    fn by_place(&self) -> BlendVariation {
        let Self { chord, normal, to, tangents, .. } = self;
        let [(start, start_length), (end, end_length)] = *tangents;
        let u = chord.unit;
        let du = (to.velocity - u * u.dot(to.velocity)) / chord.length;
        let unit_change = |unit: Vec3, change: Vec3, length: f64| (change - unit * unit.dot(change)) / length;
        let start_tangent = unit_change(start, du - *normal * du.dot(*normal), start_length);
        let (m, dm) = (to.normal, to.normal_change);
        let end_change = unit_change(end, du - m * (du.dot(m) + u.dot(dm)) - dm * u.dot(m), end_length);
        // The derivative of its reflection 2 (u·t) u - t.
        let end_tangent = (u * (du.dot(end) + u.dot(end_change)) + du * u.dot(end)) * 2.0 - end_change;
        BlendVariation { end: to.velocity, start_tangent, end_tangent }
    }
}
