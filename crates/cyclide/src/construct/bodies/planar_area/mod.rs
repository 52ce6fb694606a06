//! Faces that cover the area between closed contours of a plane, exact along them: a curvilinear triangulation
//! (`docs/math/revolution-and-pipes.md#end-faces`).
//!
//! The chords of the contours are triangulated. A triangle whose boundary sides bend becomes the ruled face between the curve and
//! the opposite corner, between two such curves from their common corner, or, with the triangle beside it, between two opposite
//! curves. Each is proved to keep its sense everywhere ([`sense`]); curves of faces that do not are halved, and all is done again.
//! Faces that keep their sense and hang together round contours that do not meet cover the area between these once: the number of
//! times that a point is covered is the number of times that the contours go round it.

mod contours;
mod cover;
mod sense;
mod triangles;

use crate::base::planar::Point2;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::bands::rows_of;
use crate::construct::bodies::rails::evened;
use crate::error::Result;
use crate::rational::{PolynomialRow, RationalBezierSurface};
use crate::topology::{EdgeCurve, FaceEdge, Sewing};
use std::collections::BTreeMap;

/// Sides of all contours at most: time grows with the square of their number.
const MOST_SIDES: usize = 2000;
/// Rounds of halving at most.
const ROUNDS: usize = 40;

/// A plane in space with two unit vectors across each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    pub(super) origin: Point3,
    pub(super) axes: [Vec3; 2],
}

impl Plane {
    pub(super) fn locate(&self, p: Point3) -> Point2 {
        let way = p - self.origin;
        Point2::new(way.dot(self.axes[0]), way.dot(self.axes[1]))
    }

    fn point(&self, p: Point2) -> Point3 {
        self.origin + self.axes[0] * p.x + self.axes[1] * p.y
    }

    /// Homogeneous rows in the plane.
    fn rows(&self, curve: &EdgeCurve) -> Vec<[f64; 3]> {
        let row = |[x, y, z, w]: [f64; 4]| {
            let way = Vec3::new(x, y, z) - self.origin.to_vec() * w;
            [way.dot(self.axes[0]), way.dot(self.axes[1]), w]
        };
        ruled_rows(curve).into_iter().map(row).collect()
    }
}

/// One side of a contour: a part of the curve with this number.
#[derive(Debug, Clone)]
pub(super) struct Side {
    pub(super) source: usize,
    pub(super) curve: EdgeCurve,
}

/// Faces that cover an area. Vertices are the starts of all sides, contour by contour, and then the points inside.
#[derive(Debug)]
pub(super) struct Cover {
    /// The contours as given, their curves cut where faces needed it.
    pub(super) contours: Vec<Vec<Side>>,
    inside: Vec<Point3>,
    /// Corners: the side at t = 0 from the first to the second, that at t = 1 from the third to the fourth. Equal ones are a point.
    faces: Vec<[usize; 4]>,
}

impl Cover {
    /// The faces of the area between contours, which go round it with the area to their left and do not meet. Curves are cut as far
    /// as faces need it, straight ones never. `None` beyond 2,000 sides.
    ///
    /// # Errors
    /// As [`EdgeCurve::split`].
    pub(super) fn of_contours(plane: &Plane, contours: Vec<Vec<EdgeCurve>>) -> Result<Option<Self>> {
        let mut source = 0..;
        let mut side = |curve: EdgeCurve| Side { source: source.next().unwrap_or(usize::MAX), curve: even_arc(curve) };
        let contours = contours.into_iter().map(|curves| curves.into_iter().map(&mut side).collect()).collect();
        let mut contours = contours::Contours::new(plane, contours);
        for _ in 0..ROUNDS {
            contours.even_cusps()?;
            let halved = match contours.chords_in_the_way() {
                Some(sides) => sides,
                None => match cover::cover(&contours) {
                    Ok((inside, faces)) => {
                        let inside = inside.into_iter().map(|p| plane.point(p)).collect();
                        return Ok(Some(Self { contours: contours.into_sides(), inside, faces }));
                    }
                    Err(sides) => sides,
                },
            };
            if !contours.halve(&halved)? || contours.count() > MOST_SIDES {
                break;
            }
        }
        Ok(None)
    }

    /// Faces from a point that sees all of one contour.
    pub(super) fn from_centre(centre: Point3, contour: Vec<EdgeCurve>) -> Self {
        let count = contour.len();
        let faces = (0..count).map(|k| [k, (k + 1) % count, count, count]).collect();
        let sides = contour.into_iter().enumerate().map(|(source, curve)| Side { source, curve: even_arc(curve) });
        Self { contours: vec![sides.collect()], inside: vec![centre], faces }
    }

    /// Adds the faces to what is sewn, over an image of the plane: `vertices` and `edges` of all sides, contour by contour, and where the
    /// points inside are. `same_sense` if the outside is where the contours are seen to run counter-clockwise.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`], [`Arc::segment`](crate::curve::Arc::segment).
    pub(super) fn sew(
        &self,
        sewing: &mut Sewing,
        mut vertices: Vec<usize>,
        edges: &[FaceEdge],
        image: impl Fn(Point3) -> Point3,
        same_sense: bool,
    ) -> Result<()> {
        let mut between = BTreeMap::new();
        let mut first = 0;
        for contour in &self.contours {
            let count = contour.len();
            between.extend((0..count).map(|k| ((first + k, first + (k + 1) % count), edges[first + k])));
            first += count;
        }
        vertices.extend(self.inside.iter().map(|&p| sewing.vertex(image(p))));
        for &[a0, a1, b0, b1] in &self.faces {
            let mut side = |from: usize, to: usize| -> Result<Option<FaceEdge>> {
                if from == to {
                    return Ok(None);
                }
                if let Some(&edge) = between.get(&(from, to)) {
                    return Ok(Some(edge));
                }
                if let Some(&FaceEdge { edge, forward }) = between.get(&(to, from)) {
                    return Ok(Some(FaceEdge { edge, forward: !forward }));
                }
                let edge = sewing.segment(vertices[from], vertices[to])?;
                between.insert((from, to), FaceEdge { edge, forward: true });
                Ok(Some(FaceEdge { edge, forward: true }))
            };
            let sides = [side(a0, a1)?, side(b0, b1)?, side(a0, b0)?, side(a1, b1)?];
            let corners = [a0, a1, b0, b1].map(|k| sewing.vertices[vertices[k]]);
            let surface = ruled(sewing, [sides[0], sides[1]], corners)?;
            sewing.face_along(surface, sides, same_sense);
        }
        Ok(())
    }
}

/// The ruled surface between two edges, or an edge and a point.
fn ruled(sewing: &Sewing, sides: [Option<FaceEdge>; 2], corners: [Point3; 4]) -> Result<RationalBezierSurface> {
    let rows = |side: FaceEdge| {
        let curve = &sewing.edges[side.edge].curve;
        if side.forward { ruled_rows(curve) } else { ruled_rows(&curve.reversed()) }
    };
    let gathered = |rows: &[[f64; 4]], p: Point3| -> Vec<[f64; 4]> {
        rows.iter().map(|&[.., w]| [p.x * w, p.y * w, p.z * w, w]).collect()
    };
    let [low, high] = sides.map(|side| side.map(rows).unwrap_or_default());
    let [low, high] = match (low.is_empty(), high.is_empty()) {
        (true, _) => [gathered(&high, corners[0]), high],
        (_, true) => [low.clone(), gathered(&low, corners[2])],
        _ => [low, high],
    };
    let rows = [low, high].map(|rows| PolynomialRow::of_rows(&rows));
    Ok(RationalBezierSurface::from_polynomial_rows(&rows)?.with_corners(corners))
}

/// The rows of a curve with weights of 1 at both ends: rulings there run at uniform speed, and neighbors share them.
fn ruled_rows(curve: &EdgeCurve) -> Vec<[f64; 4]> {
    rows_of(&evened(curve))
}

/// An arc with the parameter of [`ruled_rows`]; that of rational curves is theirs already.
fn even_arc(curve: EdgeCurve) -> EdgeCurve {
    if let EdgeCurve::Arc(arc) = &curve { EdgeCurve::Arc(arc.evened()) } else { curve }
}
