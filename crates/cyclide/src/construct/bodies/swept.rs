//! Swept surfaces: what a curve of a body runs over when the body moves, exact.
//!
//! A rational motion takes a point with homogeneous coordinates `[w x, w]` to `[2 w Im(r p̄) + p (w x) p̄, w |p|²]`, linear in them. So the
//! control points of a curve of degree m run on rational curves of degree 2n that are the control rows of a tensor-product
//! surface of degrees (m, 2n), whose weights are products: positive where those of the curve and `|p|²` are
//! (`docs/math/motions.md#swept-surfaces`).

use super::bands::{Bands, Ring, rows_of};
use super::planar_area::Cover;
use super::rails::{RailPiece, rail_pieces};
use super::section::covered;
use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::{ErrorItem, MotionError, NurbsError, Result, ShellError};
use crate::motion::{Pose, RationalMotion};
use crate::rational::{RationalBezier, RationalBezierSurface};
use crate::topology::{Body, EdgeCurve};
use crate::warning::{NetWarning, Warning};

/// Largest degree made: that of the surfaces of OpenCASCADE.
const LARGEST_DEGREE: usize = 25;
/// Poses that differ by less than this part of the coordinates are one: the motion comes back to where it began.
const SAME: f64 = 1e-12;
/// Parts of a face in each direction whose normals are looked at.
const PLACES: usize = 12;
/// Besides, so far inside its borders: where the curve comes to a stand at a border it has no normal, and next to it one.
const INSIDE: f64 = 1e-6;
/// Normals on both sides of a border that are this near to being opposite, as the cosine of their angle, fold: a sharper corner of 10 degrees is
/// no less a fold than it.
const BACK: f64 = -0.985;
/// Paths of points up to this part of their coordinates are points: roundings of the products with the rotation and their sums.
const AT_REST: f64 = 64.0 * f64::EPSILON;
/// A closed surface with less than this part of its area to the power 3/2 as volume lies on itself: integrals are known to more digits, and a tube a
/// millionth as thick as it is long has 1e-4.
const NO_VOLUME: f64 = 1e-9;
/// A face is a curve where the product of its derivatives is below this part of that of their lengths, everywhere.
const FLAT: f64 = 1e-9;

/// The surface that a curve of a moving body runs over, with what should be known of it.
///
/// ```
/// use cyclide::{Point3, Quat, Vec3, construct::SweptSurface, curve::Arc, motion::{Pose, RationalMotion, TimedPose}};
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
    /// or part of one; a rest makes none. It closes round where the motion comes back to its first pose; a closed curve then makes a body. One that goes
    /// back the way it came encloses nothing and stays open. Arcs of more than a third of a turn are cut.
    ///
    /// # Errors
    /// `too-few-points` (no piece), `disconnected`, `weight-not-positive`; `degree-too-high`; `motion-at-rest`; `not-a-shell` (a piece runs along itself, or
    /// stands still).
    pub fn new(profile: &[EdgeCurve], closed: bool, motion: &RationalMotion) -> Result<Self> {
        Self::made(profile, closed, motion, false)
    }

    /// The solid over which the area inside a closed curve runs: as [`new`](Self::new), and closed by plane faces at the first and the last pose. A curve that is open, not in a plane,
    /// or meets itself, and a motion that comes back, make what [`new`](Self::new) makes.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn solid(profile: &[EdgeCurve], closed: bool, motion: &RationalMotion) -> Result<Self> {
        Self::made(profile, closed, motion, true)
    }

    fn made(profile: &[EdgeCurve], closed: bool, motion: &RationalMotion, capped: bool) -> Result<Self> {
        let mut pieces: Vec<EdgeCurve> =
            rail_pieces([profile, profile], closed)?.into_iter().map(first_curve).collect();
        let motion = motion.without_rests().with_positive_weights();
        let ends = if closed && capped && !comes_back(&pieces, &motion) { covered(&pieces)? } else { None };
        let ends = ends.map(|(_, cover)| cover);
        if let Some(cover) = &ends {
            pieces = cover.contours.iter().flatten().map(|side| side.curve.clone()).collect();
        }
        check_moves(&pieces, &motion)?;
        let degree = pieces.iter().map(|piece| rows_of(piece).len() - 1).max().unwrap_or(0).max(2 * motion.degree());
        if degree > LARGEST_DEGREE {
            return Err(NurbsError::DegreeTooHigh { degree, limit: LARGEST_DEGREE }.into());
        }
        let faces: Vec<Vec<RationalBezierSurface>> =
            pieces.iter().map(|piece| surfaces(piece, &motion)).collect::<Result<_>>()?;
        let comes_back = comes_back(&pieces, &motion);
        let folds = folds(&faces, closed, comes_back)?;
        let closes = comes_back && (closed || !folds_at_seam(&faces));
        let mut body = sewn((&pieces, closed), &motion, &faces, closes, ends.as_ref())?;
        if closes && closed && folds.is_some() && encloses_nothing(&body) {
            body = sewn((&pieces, closed), &motion, &faces, false, None)?;
        }
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
    (pieces, closed): (&[EdgeCurve], bool),
    motion: &RationalMotion,
    faces: &[Vec<RationalBezierSurface>],
    comes_back: bool,
    ends: Option<&Cover>,
) -> Result<Body> {
    let times = motion.times();
    let poses: Vec<Pose> = times.iter().map(|time| motion.pose(*time)).collect();
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
    if let (Some(cover), [first, .., last]) = (ends, &poses[..]) {
        bands.cover(cover, &[&rings[0]], |p| first.apply(p), false)?;
        bands.cover(cover, &[&rings[rings.len() - 1]], |p| last.apply(p), true)?;
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

/// Whether the motion brings the pieces back to where they began.
fn comes_back(pieces: &[EdgeCurve], motion: &RationalMotion) -> bool {
    let times = motion.times();
    let [first, last] = [times[0], times[times.len() - 1]].map(|time| motion.pose(time));
    is_same(first, last, pieces) && times.len() > 2
}

/// Refuses a motion that moves no point of the pieces.
///
/// # Errors
/// `motion-at-rest`.
fn check_moves(pieces: &[EdgeCurve], motion: &RationalMotion) -> Result<()> {
    let points = || pieces.iter().flat_map(|piece| [piece.start(), piece.point(0.3), piece.point(0.5), piece.end()]);
    let first = motion.pose(motion.times()[0]);
    let places =
        || motion.times().windows(2).flat_map(|ends| [0.3, 0.6, 1.0].map(|s| ends[0] + (ends[1] - ends[0]) * s));
    let moved = |pose: Pose| points().map(move |p| (pose.apply(p).distance(first.apply(p)), pose.apply(p)));
    let all = || places().flat_map(|time| moved(motion.pose(time)));
    let length = all().map(|(length, _)| length).fold(0.0, f64::max);
    let limit = AT_REST * all().map(|(_, p)| p.to_vec().max_abs()).fold(0.0, f64::max);
    if length > limit { Ok(()) } else { Err(MotionError::AtRest { length, limit, still: false }.into()) }
}

/// The warning of faces whose normals turn back from one place to the next, or over the border to the face before.
///
/// # Errors
/// `not-a-shell` for a face that is a curve.
fn folds(faces: &[Vec<RationalBezierSurface>], closed: bool, comes_back: bool) -> Result<Option<Warning>> {
    let (mut count, mut borders, mut first) = (0, 0, None);
    let (pieces, spans) = (faces.len(), faces.first().map_or(0, Vec::len));
    let before = |index: usize, count: usize, round: bool| match index {
        0 if round && count > 1 => Some(count - 1),
        0 => None,
        _ => Some(index - 1),
    };
    let turns_back = |face: usize| {
        let (k, i) = (face / pieces, face % pieces);
        let own = &faces[i][k];
        let over_span = before(k, spans, comes_back).map(|k| &faces[i][k]);
        let over_piece = before(i, pieces, closed).map(|i| &faces[i][k]);
        over_span.is_some_and(|other| fold_at_border(|s, off| other.jet(s, 1.0 - off), |s, off| own.jet(s, off)))
            || over_piece
                .is_some_and(|other| fold_at_border(|t, off| other.jet(1.0 - off, t), |t, off| own.jet(off, t)))
    };
    for (face, surface) in (0..spans).flat_map(|k| faces.iter().map(move |of_piece| &of_piece[k])).enumerate() {
        match shape(surface) {
            FaceShape::Curve => {
                let detail = "the curve moves along itself or stops there, so it sweeps no surface";
                return Err(ShellError::NotAShell { item: ErrorItem::Face, index: face, detail }.into());
            }
            FaceShape::Folded => {
                count += 1;
                first = first.or(Some(face));
            }
            FaceShape::Regular if turns_back(face) => {
                count += 1;
                borders += 1;
                first = first.or(Some(face));
            }
            FaceShape::Regular => {}
        }
    }
    Ok(first.map(|face| Warning::Net(NetWarning::SweptSurfaceFolds { count, face, borders })))
}

/// Whether the surface turns back where its end meets its beginning.
fn folds_at_seam(faces: &[Vec<RationalBezierSurface>]) -> bool {
    faces.iter().any(|of_piece| match (of_piece.last(), of_piece.first()) {
        (Some(last), Some(first)) => fold_at_border(|s, off| last.jet(s, 1.0 - off), |s, off| first.jet(s, off)),
        _ => false,
    })
}

/// Whether a body is a surface that lies on itself all over.
fn encloses_nothing(body: &Body) -> bool {
    body.outer.is_closed() && body.outer.volume().abs() <= NO_VOLUME * body.outer.area().powf(1.5)
}

/// Whether two faces lie on each other beside a common border: their normals there, a little inside, point against each other.
fn fold_at_border(before: impl Fn(f64, f64) -> SurfaceJet, after: impl Fn(f64, f64) -> SurfaceJet) -> bool {
    (0..PLACES).map(place).any(|along| {
        let [a, b] = [before(along, INSIDE), after(along, INSIDE)].map(|jet| Normal::of(&jet));
        a.counts() && b.counts() && a.product.dot(b.product) <= BACK * a.product.length() * b.product.length()
    })
}

/// The middle of a part of a face.
fn place(k: usize) -> f64 {
    (k as f64 + 0.5) / PLACES as f64
}

/// The product of the derivatives at a place, and that of their lengths.
struct Normal {
    product: Vec3,
    lengths: f64,
}

impl Normal {
    fn of(jet: &SurfaceJet) -> Self {
        Self { product: jet.ds.cross(jet.dt), lengths: jet.ds.length() * jet.dt.length() }
    }

    /// False where the derivatives have one direction but for rounding: then the product has none.
    fn counts(&self) -> bool {
        self.product.length() > FLAT * self.lengths
    }
}

/// What the normals of a face say.
enum FaceShape {
    Regular,
    Folded,
    Curve,
}

fn shape(surface: &RationalBezierSurface) -> FaceShape {
    let places: Vec<f64> = [INSIDE].into_iter().chain((0..PLACES).map(place)).chain([1.0 - INSIDE]).collect();
    let rows: Vec<Vec<Normal>> =
        places.iter().map(|s| places.iter().map(|t| Normal::of(&surface.jet(*s, *t))).collect()).collect();
    let most = rows.iter().flatten().map(|normal| normal.lengths).fold(0.0, f64::max);
    if rows.iter().flatten().all(|normal| normal.product.length() <= FLAT * most) {
        return FaceShape::Curve;
    }
    // A place without a normal may be the very place where it turns: those beside it are compared.
    let turns = |line: &mut dyn Iterator<Item = &Normal>| {
        let told: Vec<&Normal> = line.filter(|normal| normal.counts()).collect();
        told.windows(2).any(|pair| pair[0].product.dot(pair[1].product) < 0.0)
    };
    let along = rows.iter().any(|row| turns(&mut row.iter()));
    let across = (0..places.len()).any(|j| turns(&mut rows.iter().map(|row| &row[j])));
    if across || along { FaceShape::Folded } else { FaceShape::Regular }
}
