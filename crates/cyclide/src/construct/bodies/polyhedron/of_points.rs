//! Convex hulls of points: within which distance their triangles are made one (`docs/math/polyhedron-offsets.md#one-plane`).

use super::distinct::Distinct;
use super::{ConvexPolyhedron, PLANAR, TOGETHER, check_points, plane};
use crate::base::bounds::Aabb;
use crate::base::vector::Point3;
use crate::error::{Error, NumberError, PolyhedronError, Result};
use crate::warning::{PolyhedronWarning, Warning};

/// Of points whose hull has no planes within the flatness, it is raised so often by a factor: up to 6.6e-5 of the diameter.
const RAISES: i32 = 8;
const RAISE: f64 = 4.0;
/// So often where it has planes, but edges that hardly bend: up to 1e-6, six digits.
const RAISES_OF_DIGITS: i32 = 5;
/// So many more are tried where the first one leaves shallow edges.
const TRIED_ON: usize = 2;
/// So often it is lowered by the factor where no larger one does: of 1e-9 of the diameter down to the rounding of its coordinates.
const LOWERS: i32 = 8;

impl ConvexPolyhedron {
    /// The convex hull of points, each side one face. Points that are no corners of it stay in the list of vertices, without faces.
    /// Sides are planar within 1e-9 of the diameter, and points within half of that of each other are one. Of points of which no faces
    /// in planes are that near, as of rounded ones, within the first of 4, 16, ... times that (at most 6.6e-5) at which they are, with a
    /// [warning](Self::warnings); so too, up to 1e-6, where there are edges that hardly bend and a larger flatness has none. Where none of
    /// these gives a convex body, as of points hardly farther from a plane, the first of 1/4, 1/16, ... of it, with a warning too.
    ///
    /// # Errors
    /// `too-few-points`, `not-finite`, `parameter-out-of-range`, `below-rounding-of-place`, `flat-polyhedron`; as
    /// [`hull_with_flatness`](Self::hull_with_flatness) where no multiple does.
    pub fn hull(points: &[Point3]) -> Result<Self> {
        check_points(points)?;
        let diameter = Aabb::of_points(points.iter().copied()).map_or(0.0, Aabb::diagonal);
        let asked = PLANAR * diameter;
        let distinct = Distinct::new(points, TOGETHER * asked);
        let triangles = distinct.hull(points)?;
        let made = |flatness| Self::of_hull(points, &triangles, flatness, &distinct.dropped);
        match made(asked) {
            Err(error) if !is_flat(&error) => {
                Self::raised(made, asked, RAISES).or_else(|| Self::lowered(points, asked)).ok_or(error)
            }
            // Edges that hardly bend speak of rounded points, unless no flatness of their digits is rid of them.
            Ok(first) if first.shallow_edges().is_some() => {
                let raised = Self::raised(made, asked, RAISES_OF_DIGITS);
                Ok(raised.filter(|raised| raised.shallow_edges().is_none()).unwrap_or(first))
            }
            first => first,
        }
    }

    /// From triangles over points; of others, `dropped` for one of these, it is measured how far they are outside.
    fn of_hull(points: &[Point3], triangles: &[Vec<usize>], flatness: f64, dropped: &[[usize; 2]]) -> Result<Self> {
        let made = Self::of_faces(points, triangles, flatness)?;
        let off = dropped.iter().map(|&[vertex, kept]| (vertex, made.off_outside(points[vertex], kept)));
        let (vertex, distance) = off.fold((0, made.deviation), |far, at| if at.1 > far.1 { at } else { far });
        let limit = flatness.max(plane::rounding(points));
        if !(distance <= limit) {
            return Err(PolyhedronError::PlanesMissPoint { vertex, distance, limit }.into());
        }
        Ok(Self { deviation: distance, ..made })
    }

    /// How far a point outside is from the surface, at most: from its face, or from the vertex beside it. 0 inside.
    fn off_outside(&self, p: Point3, beside: usize) -> f64 {
        let planes = self.faces().iter().zip(&self.normals);
        let heights = planes.map(|(corners, n)| corners.first().map_or(0.0, |&v| (p - self.vertices[v]).dot(*n)));
        let outside = heights.fold(0.0, f64::max);
        if outside > 0.0 && !self.fans[beside].is_empty() { p.distance(self.vertices[beside]) } else { outside }
    }

    /// With the first larger flatness that gives a polyhedron, or with one a little larger still that leaves no edges of rounding.
    fn raised(made: impl Fn(f64) -> Result<Self>, asked: f64, raises: i32) -> Option<Self> {
        let flatness = (1..=raises).map(|k| asked * RAISE.powi(k));
        let mut made = flatness.filter_map(|used| {
            Some(Self {
                remarked: Some(Warning::Polyhedron(PolyhedronWarning::FlatnessRaised { asked, used })),
                ..made(used).ok()?
            })
        });
        let first = made.next()?;
        if first.shallow_edges().is_none() {
            return Some(first);
        }
        Some(made.take(TRIED_ON).find(|more| more.shallow_edges().is_none()).unwrap_or(first))
    }

    /// With the first smaller flatness that gives a polyhedron: of a body that is hardly thicker than the one asked for, planes that are
    /// nearly one meet far from the points.
    fn lowered(points: &[Point3], asked: f64) -> Option<Self> {
        let mut flatness = (1..=LOWERS).map(|k| asked * RAISE.powi(-k));
        flatness.find_map(|used| {
            let distinct = Distinct::new(points, TOGETHER * used);
            let made = Self::of_hull(points, &distinct.hull(points).ok()?, used, &distinct.dropped).ok()?;
            Some(Self {
                remarked: Some(Warning::Polyhedron(PolyhedronWarning::FlatnessLowered { asked, used })),
                ..made
            })
        })
    }

    /// As [`hull`](Self::hull), with the distance within which corners are in one plane, which is not raised. Where the faces in planes
    /// within it make no convex body, the first of 1/4, 1/16, ... of it is taken with which they do, with a
    /// [warning](Self::warnings).
    ///
    /// # Errors
    /// As [`hull`](Self::hull); as [`with_flatness`](Self::with_flatness) where no faces in planes are that near.
    pub fn hull_with_flatness(points: &[Point3], flatness: f64) -> Result<Self> {
        check_points(points)?;
        let distinct = Distinct::new(points, TOGETHER * flatness);
        match Self::of_hull(points, &distinct.hull(points)?, flatness, &distinct.dropped) {
            // A hull is convex: only the planes made of its faces are not.
            Err(error) if flatness > 0.0 && is_of_planes(&error) => Self::lowered(points, flatness).ok_or(error),
            made => made,
        }
    }
}

/// What goes wrong when planes are made of the faces of a hull, other than that they leave points far off, which is for the user to judge.
fn is_of_planes(error: &Error) -> bool {
    !is_flat(error)
        && !matches!(
            error,
            Error::Polyhedron(PolyhedronError::PlanesMissPoint { .. })
                | Error::Number(NumberError::ParameterOutOfRange { .. })
        )
}

/// Whether all points are within the flatness of one plane. Few planes may be left of somewhat thicker bodies.
fn is_flat(error: &Error) -> bool {
    matches!(error, Error::Polyhedron(PolyhedronError::Flat { thickness, limit }) if thickness <= limit)
}
