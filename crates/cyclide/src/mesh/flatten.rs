//! Flattening: the polyline of few vertices within a chordal tolerance of a curve.
//!
//! An arc of radius `R` is within `R(1 - cos(delta/2)) <= tolerance` of chords of equal angles `delta`. On other
//! pieces vertices are spread with density `sqrt(k)` (`k` the curvature), the ideal for a small tolerance, and each
//! chord is then proved by the hull of the piece ([`PieceHull`]). Chords without proof are halved; what has none at the
//! depth limit is refused. Nothing is sampled, so nothing is missed.

use super::MOST_PIECES;
use crate::base::vector::Point3;
use crate::curve::{CurvePlace, ParamCurve, PieceForm, PieceHull};
use crate::error::{CurveError, NumberError, Result, check_tolerance};

/// Intervals on which the density of vertices of a piece is sampled.
const DENSITY_SCAN: usize = 24;
/// Intervals that ask for more chords than this are looked at in the middle, and halved where the density there is less than a quarter of the
/// mean of the ends, or more than four times that: next to a sharp bend, or the turn of a swing, an interval has all of its chords in a
/// tiny part.
const CHORDS_UNSEEN: f64 = 64.0;
const UNEVEN: f64 = 4.0;
const SCAN_DEPTH: u32 = 48;
/// More chords than the scan asks for, so that its errors do not make every other chord fail its check by a hair.
const MARGIN: f64 = 1.03;
/// Halvings of one chord without proof; beyond, the part is shorter than rounding.
const DEPTH: u32 = 48;
/// How often a part is halved to prove one chord, and the excess of a hull over the tolerance up to which it is worth
/// while.
const PROOF_DEPTH: u32 = 3;
const HULL_EXCESS: f64 = 3.0;
/// The part of the tolerance that curves without an exact rational form may use for their approximation.
const APPROXIMATION: f64 = 1.0 / 32.0;

/// Parameters and points of a polyline within `tolerance` of the curve, in both directions (largest distance of a
/// curve point from its chord): proved, not sampled. The ends of all pieces are vertices; a closed curve ends with the bits of its start.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// let vertices = cyclide::mesh::flatten(&arc, 0.01)?;
/// // The middle of each chord is within the tolerance of the circle.
/// assert!(vertices.windows(2).all(|w| w[0].1.lerp(w[1].1, 0.5).to_vec().length() > 0.99));
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// `tolerance-not-positive`, `not-finite` (infinite tolerance); `too-many-pieces` if more than [`MOST_PIECES`] vertices would be
/// needed; `not-within-tolerance` if the rounding of the curve's numbers leaves no proof.
///
/// What is proved is about the curve in exact arithmetic; the vertices carry the rounding of evaluation besides.
pub fn flatten(curve: &dyn ParamCurve, tolerance: f64) -> Result<Vec<(f64, Point3)>> {
    let mut vertices = Vec::new();
    flatten_into(curve, tolerance, &mut vertices)?;
    Ok(vertices)
}

/// As [`flatten`], into a vector that is cleared first and keeps its capacity for the next call.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// let mut vertices = Vec::new();
/// cyclide::mesh::flatten_into(&arc, 0.01, &mut vertices)?;
/// assert_eq!(vertices, cyclide::mesh::flatten(&arc, 0.01)?);
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// As [`flatten`].
pub fn flatten_into(curve: &dyn ParamCurve, tolerance: f64, vertices: &mut Vec<(f64, Point3)>) -> Result<()> {
    let n = curve.piece_count() as f64;
    vertices.clear();
    each_vertex(curve, tolerance, MOST_PIECES, &mut |place, point| {
        vertices.push(((place.piece as f64 + place.s) / n, point))
    })
}

/// As [`flatten`], with the places of the vertices as piece and parameter, to the last digit however many pieces there
/// are.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// let places = cyclide::mesh::flatten_places(&arc, 0.01)?;
/// assert!(places.iter().all(|(place, _)| place.piece == 0));
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// As [`flatten`].
pub fn flatten_places(curve: &dyn ParamCurve, tolerance: f64) -> Result<Vec<(CurvePlace, Point3)>> {
    flatten_within(curve, tolerance, MOST_PIECES)
}

/// As [`flatten_places`], with `most` vertices at most.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// assert_eq!(cyclide::mesh::flatten_within(&arc, 1e-9, 100).unwrap_err().reason(), "too-many-pieces");
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// As [`flatten`].
pub fn flatten_within(curve: &dyn ParamCurve, tolerance: f64, most: usize) -> Result<Vec<(CurvePlace, Point3)>> {
    let mut vertices = Vec::new();
    each_vertex(curve, tolerance, most, &mut |place, point| vertices.push((place, point)))?;
    Ok(vertices)
}

/// Gives the vertices one after the other.
fn each_vertex(
    curve: &dyn ParamCurve,
    tolerance: f64,
    most: usize,
    vertex: &mut dyn FnMut(CurvePlace, Point3),
) -> Result<()> {
    check_tolerance(tolerance)?;
    let n = curve.piece_count();
    let start = curve.piece_point(0, 0.0);
    let mut made = 0;
    let mut vertex = |place, point| {
        made += 1;
        vertex(place, point);
        made
    };
    let mut have = vertex(CurvePlace::new(0, 0.0), start);
    for piece in 0..n {
        match curve.piece_form(piece) {
            PieceForm::Arc(arc) => {
                let chords = chords_of_arc(arc.radius().unwrap_or(f64::INFINITY), arc.angle(), tolerance);
                let m = count(chords, have, most, piece)?;
                for j in 1..m {
                    let l = j as f64 / m as f64;
                    vertex(CurvePlace::new(piece, arc.parameter_at_length(l)), arc.point_at_length(l));
                }
            }
            PieceForm::Circle(circle) => {
                // Three chords at least: two would be one segment, there and back.
                let chords = chords_of_arc(circle.radius(), std::f64::consts::TAU, tolerance).max(3.0);
                let m = count(chords, have, most, piece)?;
                for j in 1..m {
                    let s = j as f64 / m as f64;
                    vertex(CurvePlace::new(piece, s), curve.piece_point(piece, s));
                }
            }
            PieceForm::Free => {
                let hull = curve.piece_hull(piece, APPROXIMATION * tolerance)?;
                Free { curve, piece, tolerance, most, hull, have }.flatten(&mut vertex)?;
            }
        }
        // Closed curves end with the bits of their start.
        let closing = curve.is_closed() && piece + 1 == n;
        let end = if closing { start } else { curve.piece_point(piece, 1.0) };
        have = vertex(CurvePlace::new(piece, 1.0), end);
    }
    Ok(())
}

/// Number of equal chords of an arc: `R(1 - cos(delta/2)) = 2R sin²(delta/4) <= tolerance`. Not rounded to `usize`
/// yet: it may be anything up to infinity.
fn chords_of_arc(radius: f64, angle: f64, tolerance: f64) -> f64 {
    if angle == 0.0 || radius.is_infinite() {
        return 1.0;
    }
    let sine = (0.5 * tolerance / radius).sqrt();
    if sine >= 1.0 {
        return 1.0;
    }
    // Rounding of the quotient must not add a chord.
    (angle / (4.0 * sine.asin()) * (1.0 - 1e-12)).ceil().max(1.0)
}

/// The number of chords as an integer, refused if the vertices would exceed the cap.
fn count(chords: f64, have: usize, most: usize, piece: usize) -> Result<usize> {
    // Not `>`: what is no number is not allowed either.
    if !(chords <= most.saturating_sub(have) as f64) {
        return Err(NumberError::TooManyPieces {
            what: "the polyline of piece",
            segment: Some(piece),
            needed: have as f64 + chords,
            cap: most,
            remedy: "use a larger tolerance or allow more",
        }
        .into());
    }
    Ok(chords as usize)
}

/// One piece that is known by its jets only.
struct Free<'a> {
    curve: &'a dyn ParamCurve,
    piece: usize,
    tolerance: f64,
    most: usize,
    hull: PieceHull,
    /// Vertices made before.
    have: usize,
}

impl Free<'_> {
    /// Appends the inner vertices of the piece.
    fn flatten(&mut self, vertex: &mut impl FnMut(CurvePlace, Point3) -> usize) -> Result<()> {
        // Chords by the integral of sqrt(k) by arc length, its density taken as linear between the places of the scan.
        let scan = self.scan();
        let inside = |interval: usize| {
            let [[a, da], [b, db]] = [scan[interval], scan[interval + 1]];
            0.5 * (da + db) * (b - a)
        };
        let intervals = scan.len() - 1;
        let total: f64 = (0..intervals).map(inside).sum();
        let chords = MARGIN * total * self.chords_per_density();
        let m = count(chords.ceil().max(1.0), self.have, self.most, self.piece)?;
        let (mut s, mut point) = (0.0, self.curve.piece_point(self.piece, 0.0));
        // The interval of the scan and the integral up to its start.
        let (mut interval, mut before) = (0, 0.0);
        for j in 1..=m {
            let goal = total * j as f64 / m as f64;
            while interval + 1 < intervals && before + inside(interval) < goal {
                before += inside(interval);
                interval += 1;
            }
            let [[from, d0], [to, d1]] = [scan[interval], scan[interval + 1]];
            let next =
                if j == m { 1.0 } else { from + (to - from) * fraction([d0, d1], (goal - before) / (to - from)) };
            let next_point = self.curve.piece_point(self.piece, next);
            self.check(s, point, next, next_point, DEPTH, vertex)?;
            if j < m {
                self.have = vertex(CurvePlace::new(self.piece, next), next_point);
            }
            (s, point) = (next, next_point);
        }
        Ok(())
    }

    /// A part of curvature `k` reaches the tolerance at the length `sqrt(8 tolerance/k)`.
    fn chords_per_density(&self) -> f64 {
        1.0 / (8.0 * self.tolerance).sqrt()
    }

    /// Places from 0 to 1 with the density at each.
    fn scan(&self) -> Vec<[f64; 2]> {
        let at = |s: f64| [s, self.density(s)];
        let mut scan = Vec::with_capacity(DENSITY_SCAN + 1);
        scan.push(at(0.0));
        for i in 1..=DENSITY_SCAN {
            self.scan_to(at(i as f64 * (1.0 / DENSITY_SCAN as f64)), SCAN_DEPTH, &mut scan);
        }
        scan
    }

    /// Adds a place to the scan, and places before it where the density is uneven.
    fn scan_to(&self, [b, db]: [f64; 2], depth: u32, scan: &mut Vec<[f64; 2]>) {
        if let Some(&[a, da]) = scan.last() {
            let (middle, mean) = (0.5 * (a + b), 0.5 * (da + db));
            if depth > 0 && mean * (b - a) * self.chords_per_density() > CHORDS_UNSEEN {
                let density = self.density(middle);
                if density * UNEVEN < mean || density > UNEVEN * mean {
                    self.scan_to([middle, density], depth - 1, scan);
                    self.scan_to([b, db], depth - 1, scan);
                    return;
                }
            }
        }
        scan.push([b, db]);
    }

    /// Vertices per parameter up to a factor: `sqrt(k) |x'|`, 0 where there is no tangent.
    fn density(&self, s: f64) -> f64 {
        let jet = self.curve.piece_jet(self.piece, s);
        let density = jet.curvature().map_or(0.0, |k| k.sqrt() * jet.speed());
        if density.is_finite() { density } else { 0.0 }
    }

    /// A bound on the distance of a part from a chord: of the hull of the part, or where that fails by little, of the
    /// hulls of its halves, which are tighter.
    fn bound(&mut self, [a, b]: [f64; 2], chord: [Point3; 2], depth: u32) -> f64 {
        let whole = self.hull.deviation([a, b], chord);
        if whole <= self.tolerance || depth == 0 || !(whole <= HULL_EXCESS * self.tolerance) {
            return whole;
        }
        let m = 0.5 * (a + b);
        let first = self.bound([a, m], chord, depth - 1);
        if first > self.tolerance { first } else { first.max(self.bound([m, b], chord, depth - 1)) }
    }

    /// Adds vertices between two parameters where the part is not within the tolerance of its chord.
    fn check(
        &mut self,
        a: f64,
        from: Point3,
        b: f64,
        to: Point3,
        depth: u32,
        vertex: &mut impl FnMut(CurvePlace, Point3) -> usize,
    ) -> Result<()> {
        let bound = self.bound([a, b], [from, to], PROOF_DEPTH);
        if bound <= self.tolerance {
            return Ok(());
        }
        let m = 0.5 * (a + b);
        if depth == 0 || m <= a || m >= b {
            return Err(CurveError::NotWithinTolerance { piece: self.piece, bound, tolerance: self.tolerance }.into());
        }
        count(1.0, self.have, self.most, self.piece)?;
        let middle = self.curve.piece_point(self.piece, m);
        self.check(a, from, m, middle, depth - 1, vertex)?;
        self.have = vertex(CurvePlace::new(self.piece, m), middle);
        self.check(m, middle, b, to, depth - 1, vertex)
    }
}

/// The `x` in `[0, 1]` at which the integral of the linear function from `d[0]` at 0 to `d[1]` at 1 is `goal`.
fn fraction(d: [f64; 2], goal: f64) -> f64 {
    let root = (d[0] * d[0] + 2.0 * (d[1] - d[0]) * goal).max(0.0).sqrt();
    let x = 2.0 * goal / (d[0] + root);
    if x >= 0.0 { x.min(1.0) } else { 1.0 }
}
