//! Circular surfaces: arcs between two rails, with a tangent at the first one, exact (`000`, section 7;
//! `docs/math/circular-surfaces.md#arcs-between-rails`).
//!
//! The arc from `q0` to `q1` with the derivative `v` at its start has, with the chord `c = q1 - q0`, the homogeneous rows
//!
//! ```text
//! |c|² [q0, 1],   ⟨c, v⟩ [q0, 1] + |c|² [v/2, 0],   |v|² [q1, 1]
//! ```
//!
//! With rails and tangent rational in s these are polynomials in s after multiplication with the denominators. The derivative
//! keeps its length along s: unit weights would take the square root of a polynomial. With `q0 = A/α`, `q1 = B/β`, polynomial
//! `v` and `C = α B - β A` they are
//!
//! ```text
//! |C|² [A, α],   αβ⟨C, v⟩ [A, α] + α |C|² [v/2, 0],   α³β |v|² [B, β]
//! ```
//!
//! and with a common denominator `α = β = D`, `C = B - A`, of lower degree
//!
//! ```text
//! |C|² [A, D],   D⟨C, v⟩ [A, D] + D |C|² [v/2, 0],   D² |v|² [B, D]
//! ```
//!
//! Weights may be negative where arcs turn by more than half a turn: such surfaces are cut across the arcs, and along them where the Bernstein
//! coefficients of positive weights are not positive.

use super::bands::{Bands, rows_of};
use super::crossing_arcs::crossing_arcs;
use super::kinks::kinks;
use super::planar_folds::{PlanarSide, planar_side};
use super::rail_surface::RailSurface;
use super::rails::{RailPiece, rail_pieces};
use crate::base::vector::Vec3;
use crate::curve::Arc;
use crate::error::{ArcError, BridgeError, Error, ErrorItem, NumberError, NurbsError, PointError, Result};
use crate::rational::{Polynomial, PolynomialRow, RationalBezier, RationalBezierSurface};
use crate::topology::{Body, EdgeCurve};
use crate::warning::{BodyWarning, Warning};

/// Largest degree made: that of the surfaces of OpenCASCADE.
const LARGEST_DEGREE: usize = 25;
/// Rails nearer to each other than this part of their size meet.
const SEPARATION: f64 = 1e-12;
/// An arc whose tangent is against its chord but for this angle is nearly a full circle of fifty chords' radius; nearer to it
/// weights spread so far that files lose the edges that faces share.
const OPPOSED: f64 = 1e-2;
/// Below this angle, of ten chords' radius, it is said: OpenCASCADE finds edges off their faces from 0.02 on.
const NEARLY_OPPOSED: f64 = 0.05;
/// Tangents of neighboring joints oppose each other if less than this part of the longer one is left between them.
const OPPOSITE_TANGENTS: f64 = 1e-6;
/// Places of a piece at which chord and tangent are looked at.
const PLACES: u32 = 32;
/// A piece is halved along the rails so many times at most.
const MOST_HALVINGS: u32 = 5;
/// Cosine of the angle from which planes of neighbors are one, seen from both sides.
const OPPOSITE: f64 = 1.0 - 1e-9;
/// The arcs of a surface are cut into so many parts at most.
const MOST_PARTS: usize = 8;

impl RationalBezierSurface {
    /// The surface of the arcs from `first` to `second` at equal parameters s that leave `first` with the derivative
    /// `tangent[0] (1-s) + tangent[1] s`. Its weights may be of any sign;
    /// the largest is 1.
    ///
    /// # Errors
    /// `degree-too-high`; `not-finite`.
    pub fn circular(first: &RationalBezier, second: &RationalBezier, tangent: [Vec3; 2]) -> Result<Self> {
        Self::circular_evened(first, second, tangent, None)
    }

    /// The same surface with the derivatives times a factor that is linear between two values: its rows times 1, the factor and its square, another
    /// parameter of the arcs.
    fn circular_evened(
        first: &RationalBezier,
        second: &RationalBezier,
        tangent: [Vec3; 2],
        factors: Option<[f64; 2]>,
    ) -> Result<Self> {
        let [a, b] = [first, second].map(|curve| PolynomialRow::of_rows(curve.rows()));
        let v = [0, 1, 2].map(|d| linear(tangent.map(|v| [v.x, v.y, v.z][d])));
        let rows = if let Some(b) = over_same_denominator(&a, &b) {
            let one = a.weight();
            let c = [0, 1, 2].map(|d| (&b.0[d] + &(&a.0[d] * -1.0)).settled());
            arc_rows([&a, &b], &c, &v, [one, one, &(one * one)])
        } else {
            let (alpha, beta) = (a.weight(), b.weight());
            let c = [0, 1, 2].map(|d| &(&b.0[d] * alpha) + &(&(&a.0[d] * beta) * -1.0));
            let both = alpha * beta;
            arc_rows([&a, &b], &c, &v, [&both, alpha, &(&(alpha * alpha) * &both)])
        };
        let rows = match factors {
            Some(factors) => {
                let (one, factor) = (Polynomial::new(vec![1.0; 2]), Polynomial::new(factors.to_vec()));
                let [first, middle, last] = rows;
                [&first * &(&one * &one), &middle * &(&one * &factor), &last * &(&factor * &factor)]
            }
            None => rows,
        };
        let degree = rows.iter().flat_map(|row| &row.0).map(Polynomial::degree).max().unwrap_or(0);
        if degree > LARGEST_DEGREE {
            return Err(NurbsError::DegreeTooHigh { degree, limit: LARGEST_DEGREE }.into());
        }
        let weights = || rows.iter().flat_map(|row| row.weight().coefficients());
        let largest = weights().fold(0.0, |largest: f64, w| largest.max(w.abs()));
        Self::from_polynomial_rows(&rows.map(|row| &row * (1.0 / largest)))
    }
}

impl Body {
    /// The surface of arcs between two rails, open or (`closed`) round: piece by piece, at equal parameters. The arcs leave the first rail
    /// in the direction of the tangent: one for all, or one for each joint, linear in between. Lengths of tangents do not matter against each other only
    /// where there is one.
    ///
    /// # Errors
    /// `piece-counts-differ`, `too-few-points`, `disconnected`, `weight-not-positive` (of the rails, or where no parts of the surface have
    /// positive weights: arcs that turn nearly round); `count-differs`, `not-finite`, `zero-tangent`, `opposite-tangents` (at joints that follow each other), `coincident-points` (the rails meet),
    /// `tangent-opposes-chord`, `degree-too-high`, `arcs-cross` (neighboring arcs cross, as where one rail runs the other way).
    pub fn circular(rails: [&[EdgeCurve]; 2], tangents: &[Vec3], closed: bool) -> Result<Self> {
        RailSurface::circular(rails, tangents, closed).map(RailSurface::into_body)
    }
}

impl RailSurface {
    /// The surface of arcs between two rails: see [`Body::circular`].
    ///
    /// # Errors
    /// As [`Body::circular`].
    pub fn circular(rails: [&[EdgeCurve]; 2], tangents: &[Vec3], closed: bool) -> Result<Self> {
        let tangents = tangents_of_joints(tangents, rails[0].len(), closed)?;
        let pieces: Vec<ArcPiece> =
            rail_pieces(rails, closed)?.into_iter().map(|rails| ArcPiece::new(rails, &tangents)).collect();
        let one = Speed::One(speed(&pieces)?);
        let parts_of_arcs = || std::iter::successors(Some(1), |&n| (n < MOST_PARTS).then_some(2 * n));
        // Even arcs have a higher degree: only where chords differ so much that others do not do.
        let tries = parts_of_arcs().map(|n| (one, n)).chain(parts_of_arcs().map(|n| (Speed::Even, n)));
        let mut negative = Error::Nurbs(NurbsError::WeightNotPositive { index: 0, weight: 0.0 });
        for (speed, count) in tries {
            match cut(&pieces, speed, count) {
                Ok(made) => {
                    check_all_arcs(&made, closed)?;
                    let body = sewn(&made, speed, count, closed)?;
                    let starts: Vec<Option<usize>> = made.iter().map(|(piece, _)| piece.rails.joint()).collect();
                    let warnings =
                        kinks(rails, closed, &body, &starts).into_iter().chain(nearly_full(&pieces)).collect();
                    return Ok(Self { body, warnings });
                }
                Err(error @ Error::Nurbs(NurbsError::WeightNotPositive { .. })) => negative = error,
                Err(error) => return Err(error),
            }
        }
        Err(negative)
    }
}

/// How fast arcs start.
#[derive(Debug, Clone, Copy)]
enum Speed {
    /// A factor of all tangents.
    One(f64),
    /// As fast as they end, by factors of the tangents that are linear over a piece.
    Even,
}

/// A piece of the rails with the tangents at its ends.
#[derive(Clone)]
struct ArcPiece {
    rails: RailPiece,
    tangents: [Vec3; 2],
}

impl ArcPiece {
    fn new(rails: RailPiece, tangents: &[Vec3]) -> Self {
        let ends = [tangents[rails.piece], tangents[rails.piece + 1]];
        let tangents = rails.part.map(|x| if ends[0] == ends[1] { ends[0] } else { ends[0] * (1.0 - x) + ends[1] * x });
        Self { rails, tangents }
    }

    fn tangent(&self, s: f64) -> Vec3 {
        self.tangents[0] * (1.0 - s) + self.tangents[1] * s
    }

    fn chord(&self, s: f64) -> Vec3 {
        self.rails.curves[1].point(s) - self.rails.curves[0].point(s)
    }

    /// The angle between the tangent and the way back along the chord.
    fn opening(&self, s: f64) -> f64 {
        let (c, v) = (self.chord(s), self.tangent(s));
        c.cross(v).length().atan2(-c.dot(v))
    }

    /// The arc at its start, or (`x` = 1) at its end.
    fn arc(&self, x: f64, speed: Speed) -> Result<Arc> {
        let [from, to] = self.rails.curves.each_ref().map(|curve| curve.point(x));
        Arc::from_start_tangent(from, to, self.tangent(x) * self.factor(x, speed))
    }

    /// The factor of the tangent at an end.
    fn factor(&self, x: f64, speed: Speed) -> f64 {
        match speed {
            Speed::One(speed) => speed,
            Speed::Even => self.chord(x).length() / self.tangent(x).length(),
        }
    }

    fn surface(&self, speed: Speed) -> Result<RationalBezierSurface> {
        let [first, second] = self.rails.curves.each_ref().map(|curve| RationalBezier::new(rows_of(curve)));
        let (first, second) = (first?, second?);
        match speed {
            Speed::One(speed) => RationalBezierSurface::circular(&first, &second, self.tangents.map(|v| v * speed)),
            Speed::Even => {
                let factors = [0.0, 1.0].map(|x| self.factor(x, speed));
                RationalBezierSurface::circular_evened(&first, &second, self.tangents, Some(factors))
            }
        }
    }

    /// Refuses arcs that cross their neighbors. Gives the normal of a surface in a plane.
    fn check_arcs(&self, surface: &RationalBezierSurface) -> Result<Option<Vec3>> {
        match planar_side(surface) {
            Some(PlanarSide::One(normal)) => return Ok(Some(normal)),
            Some(PlanarSide::Folds([s, t])) => return Err(self.crossing_at(s, t)),
            None => {}
        }
        let plane = |s: f64| {
            let (chord, tangent) = (self.chord(s), self.tangent(s));
            chord.cross(tangent) / (chord.length() * tangent.length())
        };
        match crossing_arcs(surface, plane) {
            Some([s, t]) => Err(self.crossing_at(s, t)),
            None => Ok(None),
        }
    }

    fn crossing_at(&self, s: f64, t: f64) -> Error {
        let [from, to] = self.rails.part;
        Error::Bridge(BridgeError::ArcsCross { piece: self.rails.piece, at: [from + (to - from) * s, t] })
    }

    /// Both halves along the rails.
    fn halved(&self) -> Result<[Self; 2]> {
        let middle = self.tangent(0.5);
        let [first, second] = self.rails.halved()?;
        let [from, to] = self.tangents;
        Ok([Self { rails: first, tangents: [from, middle] }, Self { rails: second, tangents: [middle, to] }])
    }
}

/// The tangent at each joint, the last one that of the first again if the rails are closed.
fn tangents_of_joints(given: &[Vec3], pieces: usize, closed: bool) -> Result<Vec<Vec3>> {
    let needed = pieces + usize::from(!closed);
    if given.len() != 1 && given.len() != needed {
        return Err(NumberError::CountDiffers { what: ErrorItem::Tangent, given: given.len(), needed }.into());
    }
    for (index, v) in given.iter().enumerate() {
        if !v.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Tangent, index }.into());
        }
        if v.max_abs() == 0.0 {
            return Err(PointError::ZeroTangent { index }.into());
        }
    }
    let tangents: Vec<Vec3> = (0..=pieces).map(|k| given[k % given.len()]).collect();
    for (first, pair) in tangents.windows(2).enumerate() {
        let length = least_between([pair[0], pair[1]]);
        if !(length > OPPOSITE_TANGENTS) {
            let second = (first + 1) % given.len();
            return Err(BridgeError::OppositeTangents { first, second, length, limit: OPPOSITE_TANGENTS }.into());
        }
    }
    Ok(tangents)
}

/// The length of the shortest vector on the way from one to another, as a part of the longer one.
fn least_between([from, to]: [Vec3; 2]) -> f64 {
    let longer = from.max_abs().max(to.max_abs());
    let [from, to] = [from / longer, to / longer];
    let turn = to - from;
    let nearest = (-from.dot(turn) / turn.dot(turn).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (from + turn * nearest).length() / from.length().max(to.length())
}

/// The places of a piece.
fn places() -> impl Iterator<Item = f64> {
    (0..=PLACES).map(|k| f64::from(k) / f64::from(PLACES))
}

/// What is said of arcs that turn nearly all round.
fn nearly_full(pieces: &[ArcPiece]) -> Option<Warning> {
    let angles = pieces.iter().flat_map(|piece| places().map(|s| (piece.rails.piece, piece.opening(s))));
    let (piece, angle) = angles.min_by(|a, b| a.1.total_cmp(&b.1))?;
    (angle < NEARLY_OPPOSED).then_some(Warning::Body(BodyWarning::NearlyFullArcs {
        piece,
        angle,
        limit: NEARLY_OPPOSED,
    }))
}

/// The factor of all tangents for which the arcs run about as fast at both ends; refuses rails that meet and arcs
/// through infinity.
fn speed(pieces: &[ArcPiece]) -> Result<f64> {
    let ends = pieces.iter().flat_map(|piece| [0.0, 1.0].map(|s| piece.chord(s).length()));
    let limit = SEPARATION * ends.fold(0.0, f64::max);
    let mut sum = 0.0;
    for piece in pieces {
        for s in places() {
            let (distance, length) = (piece.chord(s).length(), piece.tangent(s).length());
            if !(distance > limit) {
                return Err(PointError::CoincidentPoints { first: 0, second: 1, distance, limit }.into());
            }
            let angle = piece.opening(s);
            if angle < OPPOSED {
                return Err(ArcError::TangentOpposesChord { index: piece.rails.piece, angle, limit: OPPOSED }.into());
            }
            sum += (distance / length).ln();
        }
    }
    Ok((sum / (pieces.len() * (PLACES as usize + 1)) as f64).exp())
}

/// The pieces with their surfaces, halved along the rails until all parts of the arcs have positive weights.
///
/// # Errors
/// `weight-not-positive` where they do not get them, with the piece; as [`RationalBezierSurface::circular`].
fn cut(pieces: &[ArcPiece], speed: Speed, count: usize) -> Result<Vec<(ArcPiece, RationalBezierSurface)>> {
    let mut made = Vec::with_capacity(pieces.len());
    let mut waiting: Vec<(ArcPiece, u32)> = pieces.iter().rev().map(|piece| (piece.clone(), 0)).collect();
    while let Some((piece, halvings)) = waiting.pop() {
        let surface = piece.surface(speed)?;
        let least = (0..count).map(|k| least_weight(&surface.part([0.0, 1.0], part(k, count)))).fold(1.0, f64::min);
        if least > 0.0 {
            made.push((piece, surface));
        } else if halvings == MOST_HALVINGS {
            return Err(NurbsError::WeightNotPositive { index: piece.rails.piece, weight: least }.into());
        } else {
            let [first, second] = piece.halved()?;
            waiting.extend([(second, halvings + 1), (first, halvings + 1)]);
        }
    }
    Ok(made)
}

/// Refuses arcs that cross their neighbors, in a piece or, in a plane, where the next one turns back.
fn check_all_arcs(made: &[(ArcPiece, RationalBezierSurface)], closed: bool) -> Result<()> {
    let normals = made.iter().map(|(piece, surface)| piece.check_arcs(surface)).collect::<Result<Vec<_>>>()?;
    for (k, pair) in (1..).zip(normals.iter().zip(normals.iter().cycle().skip(1))) {
        let (Some(normal), Some(next)) = pair else { continue };
        if normal.dot(*next) < -OPPOSITE && (closed || k < made.len()) {
            return Err(made[k % made.len()].0.crossing_at(0.0, 0.5));
        }
    }
    Ok(())
}

/// The smallest weight.
fn least_weight(surface: &RationalBezierSurface) -> f64 {
    surface.rows().iter().map(|row| row[3]).fold(f64::INFINITY, f64::min)
}

/// Part k of the arcs.
fn part(k: usize, count: usize) -> [f64; 2] {
    [k as f64 / count as f64, (k + 1) as f64 / count as f64]
}

fn sewn(made: &[(ArcPiece, RationalBezierSurface)], speed: Speed, count: usize, closed: bool) -> Result<Body> {
    let mut bands = Bands::default();
    let mut from: Option<super::bands::Ring> = None;
    for k in 0..=count {
        let t = k as f64 / count as f64;
        let line = |(piece, surface): &(ArcPiece, RationalBezierSurface)| match k {
            0 => piece.rails.curves[0].clone(),
            _ if k == count => piece.rails.curves[1].clone(),
            _ => surface.s_line(t).into(),
        };
        let to = bands.ring(made.iter().map(line).collect(), closed);
        if let Some(from) = from {
            let t = part(k - 1, count);
            let arc = |i: usize, _| {
                let arc = match made.get(i) {
                    Some((piece, _)) => piece.arc(0.0, speed)?,
                    None => made[i - 1].0.arc(1.0, speed)?,
                };
                Ok(EdgeCurve::Arc(if count == 1 { arc } else { arc.restricted(t[0], t[1])? }))
            };
            bands.band([&from, &to], arc, |_, i| Ok(made[i].1.part([0.0, 1.0], t)))?;
        }
        from = Some(to);
    }
    bands.finish()
}

/// The rows at the module: `factors` stand beside `⟨C, v⟩ [A, α]`, `|C|² [v/2, 0]` and `|v|² [B, β]`.
fn arc_rows(
    [a, b]: [&PolynomialRow; 2],
    c: &[Polynomial; 3],
    v: &[Polynomial; 3],
    factors: [&Polynomial; 3],
) -> [PolynomialRow; 3] {
    let chord = dot(c, c);
    let half = &(&chord * factors[1]) * 0.5;
    let middle = &(a * &(&dot(c, v) * factors[0])) + &PolynomialRow::direction(v.each_ref().map(|v| v * &half));
    [a * &chord, middle, b * &(&dot(v, v) * factors[2])]
}

fn dot(a: &[Polynomial; 3], b: &[Polynomial; 3]) -> Polynomial {
    let [x, y, z] = [0, 1, 2].map(|d| &a[d] * &b[d]);
    (&(&x + &y) + &z).settled()
}

fn linear([from, to]: [f64; 2]) -> Polynomial {
    Polynomial::new(vec![from, to]).settled()
}

/// The second row over the denominator of the first, if both are the same up to a factor and rounding.
fn over_same_denominator(a: &PolynomialRow, b: &PolynomialRow) -> Option<PolynomialRow> {
    let (alpha, beta) = (a.weight().coefficients(), b.weight().coefficients());
    let factor = alpha[0] / beta[0];
    let near = |(x, y): (&f64, &f64)| (x - y * factor).abs() <= 4.0 * f64::EPSILON * x.abs();
    let same = alpha.len() == beta.len() && alpha.iter().zip(beta).all(near);
    same.then(|| {
        let PolynomialRow([x, y, z, _]) = b * factor;
        PolynomialRow([x, y, z, a.weight().clone()])
    })
}
