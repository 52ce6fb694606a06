//! Swept surfaces: what a curve of a body runs over when the body moves, exact.
//!
//! A rational motion takes a point with homogeneous coordinates `[w x, w]` to `[2 w Im(r p̄) + p (w x) p̄, w |p|²]`, linear in them. So the
//! control points of a curve of degree m run on rational curves of degree 2n that are the control rows of a tensor-product
//! surface of degrees (m, 2n), whose weights are products: positive where those of the curve and `|p|²` are
//! (`docs/math/motions.md#swept-surfaces`).

use super::bands::{Bands, Ring, rows_of};
use super::rails::{RailPiece, rail_pieces};
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::{Error, ErrorItem, Result};
use crate::motion::{Pose, RationalMotion};
use crate::rational::{RationalBezier, RationalBezierSurface};
use crate::topology::{Body, EdgeCurve};
use crate::warning::Warning;

/// Largest degree made: that of the surfaces of OpenCASCADE.
const LARGEST_DEGREE: usize = 25;
/// Poses that differ by less than this part of the coordinates are one: the motion comes back to where it began.
const SAME: f64 = 1e-12;
/// Parts of a face in each direction whose normals are looked at.
const PLACES: usize = 12;
/// A face is a curve where the product of its derivatives is below this part of that of their lengths, everywhere.
const FLAT: f64 = 1e-9;

/// The surface that a curve of a moving body runs over, with what should be known of it.
///
/// ```
/// use cyclide::{Arc, Point3, Pose, Quat, RationalMotion, SweptSurface, TimedPose, Vec3};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let slide = RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 5.0)])?;
/// let blade = Arc::segment(Point3::ORIGIN, Point3::new(0.0, 2.0, 0.0))?;
/// let swept = SweptSurface::new(&[blade.into()], false, &slide)?;
/// assert!((swept.body().outer.area() - 10.0).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SweptSurface {
    body: Body,
    warnings: Vec<Warning>,
}

impl SweptSurface {
    /// The surface over which the pieces of a curve of the body, open or `closed`, run: one face for each piece and span of the motion,
    /// or part of one. It closes round where the motion comes back to its first pose; a closed curve then makes a body. Arcs of more
    /// than a third of a turn are cut.
    ///
    /// # Errors
    /// `too-few-points` (no piece), `disconnected`, `weight-not-positive`; `degree-too-high`; `not-a-shell` (a piece runs along itself, or
    /// stands still).
    pub fn new(profile: &[EdgeCurve], closed: bool, motion: &RationalMotion) -> Result<Self> {
        let pieces: Vec<EdgeCurve> = rail_pieces([profile, profile], closed)?.into_iter().map(first_curve).collect();
        let motion = motion.with_positive_weights();
        let degree = pieces.iter().map(|piece| rows_of(piece).len() - 1).max().unwrap_or(0).max(2 * motion.degree());
        if degree > LARGEST_DEGREE {
            return Err(Error::DegreeTooHigh { degree, limit: LARGEST_DEGREE });
        }
        let faces: Vec<Vec<RationalBezierSurface>> =
            pieces.iter().map(|piece| surfaces(piece, &motion)).collect::<Result<_>>()?;
        let folds = folds(&faces)?;
        let body = sewn(&pieces, closed, &motion, &faces)?;
        Ok(Self { body, warnings: folds.into_iter().collect() })
    }

    /// The body.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// The body, without a copy.
    #[must_use]
    pub fn into_body(self) -> Body {
        self.body
    }

    /// What should be known of it: where the curve comes to move along itself, the surface folds back (`swept-surface-folds`).
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

fn first_curve(piece: RailPiece) -> EdgeCurve {
    let [curve, _] = piece.curves;
    curve
}

/// The surfaces that a piece runs over, span by span: s along the piece, t along the motion.
fn surfaces(piece: &EdgeCurve, motion: &RationalMotion) -> Result<Vec<RationalBezierSurface>> {
    let profile = rows_of(piece);
    let mut spans: Vec<Vec<[f64; 4]>> = vec![Vec::new(); motion.times().len() - 1];
    for row in &profile {
        for (span, path) in spans.iter_mut().zip(motion.homogeneous_paths(*row)) {
            span.extend(RationalBezier::from_polynomial_row(&path).rows());
        }
    }
    let m = profile.len();
    spans.into_iter().map(|rows| RationalBezierSurface::new([m - 1, rows.len() / m - 1], rows)).collect()
}

/// The faces with edges between them.
fn sewn(
    pieces: &[EdgeCurve],
    closed: bool,
    motion: &RationalMotion,
    faces: &[Vec<RationalBezierSurface>],
) -> Result<Body> {
    let times = motion.times();
    let poses: Vec<Pose> = times.iter().map(|time| motion.pose(*time)).collect();
    let comes_back = is_same(poses[0], poses[times.len() - 1], pieces) && times.len() > 2;
    let mut bands = Bands::default();
    let mut rings: Vec<Ring> = Vec::with_capacity(times.len());
    for (k, pose) in poses.iter().enumerate() {
        let ring = match rings.last() {
            None => bands.ring(moved(pieces, *pose)?, closed),
            Some(_) if comes_back && k + 1 == times.len() => rings[0].clone(),
            Some(before) => bands.ring_beside(moved(pieces, *pose)?, closed, before),
        };
        rings.push(ring);
    }
    let starts = pieces.iter().map(EdgeCurve::start).chain(pieces.last().filter(|_| !closed).map(EdgeCurve::end));
    let paths: Vec<Vec<RationalBezier>> = starts.map(|vertex| paths(vertex, motion)).collect::<Result<_>>()?;
    for (k, pair) in rings.windows(2).enumerate() {
        let across = |i: usize, _: [Point3; 2]| Ok(EdgeCurve::Rational(paths[i][k].clone()));
        bands.band([&pair[0], &pair[1]], across, |_, i| Ok(faces[i][k].clone()))?;
    }
    bands.finish()
}

/// The pieces as they lie in a pose.
fn moved(pieces: &[EdgeCurve], pose: Pose) -> Result<Vec<EdgeCurve>> {
    let map = Mobius::similarity(pose.rotation(), 1.0, pose.translation())?;
    pieces.iter().map(|piece| piece.image(&map, pose.apply(piece.start()), pose.apply(piece.end()))).collect()
}

/// The path of a vertex over each span.
fn paths(vertex: Point3, motion: &RationalMotion) -> Result<Vec<RationalBezier>> {
    let rows = motion.homogeneous_paths([vertex.x, vertex.y, vertex.z, 1.0]);
    rows.map(|row| RationalBezier::new(RationalBezier::from_polynomial_row(&row).rows().to_vec())).collect()
}

/// Whether two poses bring the pieces to the same place.
fn is_same(first: Pose, last: Pose, pieces: &[EdgeCurve]) -> bool {
    pieces.iter().flat_map(|piece| [piece.start(), piece.point(0.5), piece.end()]).all(|p| {
        let (a, b) = (first.apply(p), last.apply(p));
        a.distance(b) <= SAME * a.to_vec().max_abs().max(b.to_vec().max_abs())
    })
}

/// The warning of faces whose normals turn back from one place to the next.
///
/// # Errors
/// `not-a-shell` for a face that is a curve.
fn folds(faces: &[Vec<RationalBezierSurface>]) -> Result<Option<Warning>> {
    let (mut count, mut first) = (0, None);
    let spans = faces.first().map_or(0, Vec::len);
    for (face, surface) in (0..spans).flat_map(|k| faces.iter().map(move |of_piece| &of_piece[k])).enumerate() {
        match shape(surface) {
            FaceShape::Curve => {
                let detail = "the curve moves along itself there, or stands still: it runs over no surface";
                return Err(Error::NotAShell { item: ErrorItem::Face, index: face, detail });
            }
            FaceShape::Folded => {
                count += 1;
                first = first.or(Some(face));
            }
            FaceShape::Regular => {}
        }
    }
    Ok(first.map(|face| Warning::SweptSurfaceFolds { count, face }))
}

/// What the normals of a face say.
enum FaceShape {
    Regular,
    Folded,
    Curve,
}

fn shape(surface: &RationalBezierSurface) -> FaceShape {
    let place = |k: usize| (k as f64 + 0.5) / PLACES as f64;
    let products: Vec<Vec<(Vec3, f64)>> = (0..PLACES)
        .map(|i| {
            (0..PLACES)
                .map(|j| {
                    let jet = surface.jet(place(i), place(j));
                    (jet.ds.cross(jet.dt), jet.ds.length() * jet.dt.length())
                })
                .collect()
        })
        .collect();
    let most = products.iter().flatten().map(|(_, size)| *size).fold(0.0, f64::max);
    if products.iter().flatten().all(|(product, _)| product.length() <= FLAT * most) {
        return FaceShape::Curve;
    }
    let turned = |a: &(Vec3, f64), b: &(Vec3, f64)| a.0.dot(b.0) < 0.0;
    let across = (1..PLACES).any(|i| (0..PLACES).any(|j| turned(&products[i - 1][j], &products[i][j])));
    let along = products.iter().any(|row| row.windows(2).any(|pair| turned(&pair[0], &pair[1])));
    if across || along { FaceShape::Folded } else { FaceShape::Regular }
}
