//! Two quartic pieces of two types that share one coordinate, each coordinate of each piece a single linear complex function or a
//! half of the biarc of the shared one (`docs/math/torus-splines.md#two-types`).
//!
//! The shared coordinate `f` runs by its biarc. With `p` the other coordinate of the first type, `q = e p + g f` that of the second,
//! all counted from the start, single pieces need `p_m' = sin² p_m/(h0² p0')` and `q_m' = sin²(q1 - q_m)/(h1² q1')`, hence
//! ```text
//! al = 1/(h1² q1'),  be = e/(h0² p0'),  c = g f_m',  P = e (q1 - g f_m):   al sin²(p_m - P) = be sin² p_m + c
//! (al cos² P - be - c) tan² p_m - 2 al sin P cos P tan p_m + (al sin² P - c) = 0
//! ```
//! a quadratic whose discriminant is `al be sin² P + c (al - be - c)`: of small angles nothing is near 1 that has to be subtracted.

use super::projective_biarc::ProjectiveBiarc;
use crate::base::complex::Complex;
use crate::base::planar::{Point2, Vec2};
use crate::error::{ErrorItem, NumberError, Result, TorusError};
use crate::surface::{Course, QuarticType, TorusPiece};
use std::f64::consts::PI;

/// Two quartic pieces of two types that share a coordinate, C1, from a place and speed to another.
///
/// ```
/// use cyclide::{Point2, Vec2, construct::TwoTypeBiarc, surface::{CircleFamily, QuarticType}};
/// use CircleFamily::{Meridian, Parallel, Villarceau};
/// let kinds = [(Villarceau, Meridian), (Parallel, Villarceau)];
/// let kinds = kinds.map(|(one, other)| QuarticType::between(one, other).expect("they differ"));
/// // A quarter that starts along a parallel and ends along a meridian.
/// let rates = [Vec2::new(0.6, 0.0), Vec2::new(0.0, -0.4)];
/// let all = TwoTypeBiarc::all(kinds, Point2::new(0.0, 0.0), Vec2::new(0.4, -0.3), rates, [0.5, 0.5])?;
/// assert!(all.iter().all(|biarc| biarc.pieces()[1].quartic_type() == kinds[1]));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoTypeBiarc {
    pieces: [TorusPiece; 2],
    middle: Vec2,
    middle_rate: Vec2,
}

impl TwoTypeBiarc {
    /// All biarcs of these types, in this order, from a place by a step, with the given speeds at both ends, over two lengths of
    /// the parameter: two at most.
    ///
    /// # Errors
    /// `not-finite`; `not-monotone`, `span-too-large`, `empty-interval`, `parameter-out-of-range` of the shared coordinate;
    /// `no-two-type-solution` (none, also if the types share no coordinate).
    pub fn all(
        kinds: [QuarticType; 2],
        start: Point2,
        step: Vec2,
        rates: [Vec2; 2],
        lengths: [f64; 2],
    ) -> Result<Vec<Self>> {
        if !(start.is_finite() && step.length().is_finite() && rates.iter().all(|r| r.length().is_finite())) {
            return Err(NumberError::NotFinite { what: ErrorItem::Tangent, index: 0 }.into());
        }
        let Some(shared) = Shared::of(kinds) else {
            return Err(TorusError::NoTwoTypeSolution { segment: 0, cosine: f64::INFINITY }.into());
        };
        shared.solve(kinds, start, step, rates, lengths)
    }

    /// Both pieces, each over `[0, 1]` of its own parameter.
    #[must_use]
    pub fn pieces(&self) -> [TorusPiece; 2] {
        self.pieces
    }

    /// The place where they meet, and the speed there by the parameter.
    #[must_use]
    pub fn middle(&self) -> (Point2, Vec2) {
        (self.pieces[0].start() + self.middle, self.middle_rate)
    }

    /// How far the middle is from the middle of the step.
    pub(super) fn detour(&self, step: Vec2) -> f64 {
        (self.middle - step * 0.5).length()
    }
}

/// Which coordinates of two types are the same, and how the others hang together.
struct Shared {
    /// The shared coordinate of each type.
    places: [usize; 2],
    /// That of the second type is this sign times that of the first.
    sign: f64,
    /// The other coordinate of the second type is `e` times that of the first plus `g` times the shared one.
    e: f64,
    g: f64,
}

impl Shared {
    fn of(kinds: [QuarticType; 2]) -> Option<Self> {
        let rows = kinds.map(|kind| {
            let [a, b] = [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)].map(|v| kind.local(v));
            [Vec2::new(a[0], b[0]), Vec2::new(a[1], b[1])]
        });
        let pairs = [(0, 0), (0, 1), (1, 0), (1, 1)];
        pairs.into_iter().flat_map(|pair| [(pair, 1.0), (pair, -1.0)]).find_map(|((i, j), sign)| {
            let (f, same) = (rows[0][i], rows[1][j] * sign);
            if f != same {
                return None;
            }
            let (p, q) = (rows[0][1 - i], rows[1][1 - j]);
            let det = p.cross(f);
            Some(Self { places: [i, j], sign, e: q.cross(f) / det, g: p.cross(q) / det })
        })
    }

    fn solve(
        &self,
        kinds: [QuarticType; 2],
        start: Point2,
        step: Vec2,
        rates: [Vec2; 2],
        lengths: [f64; 2],
    ) -> Result<Vec<TwoTypeBiarc>> {
        let ([i, j], [h0, h1]) = (self.places, lengths);
        let (first, last) = (kinds[0].local(rates[0]), kinds[1].local(rates[1]));
        let slopes = [first[i], self.sign * last[j]];
        let f = ProjectiveBiarc::of_coordinate(i, 0.0, kinds[0].local(step)[i], slopes, lengths)?;
        let (p_rate, q_rate, q1) = (first[1 - i], last[1 - j], kinds[1].local(step)[1 - j]);
        let (al, be, c) = (1.0 / (h1 * h1 * q_rate), self.e / (h0 * h0 * p_rate), self.g * f.mid_slope());
        if !(al.is_finite() && be.is_finite()) {
            return Err(TorusError::NoTwoTypeSolution { segment: 0, cosine: f64::INFINITY }.into());
        }
        let (sin, cos) = (self.e * (q1 - self.g * f.mid_offset())).sin_cos();
        let root_squared = al * be * sin * sin + c * (al - be - c);
        let r = 2.0 * c - al + be;
        let cosine = r / (r * r + 4.0 * root_squared).max(0.0).sqrt();
        if !(root_squared >= 0.0) {
            return Err(TorusError::NoTwoTypeSolution { segment: 0, cosine }.into());
        }
        let middle = al * sin * cos;
        let sum = middle + root_squared.sqrt().copysign(middle);
        let tangents = [[sum, al * cos * cos - be - c], [al * sin * sin - c, sum]];
        // Between a quarter turn back and one ahead: tiny steps keep their digits.
        let angles = tangents.map(|[y, x]| (y * 1_f64.copysign(x)).atan2(x.abs()));
        let steps = angles.map(|p| self.candidate(p, f.mid_offset(), p_rate, [q1, q_rate]));
        let found: Vec<TwoTypeBiarc> = steps
            .into_iter()
            .flatten()
            .map(|[p_step, q_step]| {
                let courses = [single([h0 * p_rate, p_step]), single_to_end([h1 * q_rate, q_step])];
                self.biarc(kinds, start, &f, courses, (p_step.sin() / h0).powi(2) / p_rate)
            })
            .collect();
        if found.is_empty() { Err(TorusError::NoTwoTypeSolution { segment: 0, cosine }.into()) } else { Ok(found) }
    }

    /// From the biarc of the shared coordinate and the courses of the others.
    fn biarc(
        &self,
        kinds: [QuarticType; 2],
        start: Point2,
        f: &ProjectiveBiarc,
        [p, q]: [Course; 2],
        p_rate: f64,
    ) -> TwoTypeBiarc {
        let ([i, j], [first, rest]) = (self.places, f.courses());
        let signed = if self.sign < 0.0 { Course { step: -rest.step, ratio: rest.ratio.conj() } } else { rest };
        let middle = kinds[0].back(ordered(i, f.mid_offset(), p.step));
        let pieces = [
            TorusPiece::new(kinds[0], start, ordered(i, first, p)),
            TorusPiece::new(kinds[1], start + middle, ordered(j, signed, q)),
        ];
        TwoTypeBiarc { pieces, middle, middle_rate: kinds[0].back(ordered(i, f.mid_slope(), p_rate)) }
    }

    /// The step of `p` and that of `q` of a solution modulo pi, if both run in the directions of the speeds.
    fn candidate(&self, p: f64, f: f64, p_rate: f64, [q1, q_rate]: [f64; 2]) -> Option<[f64; 2]> {
        let p_step = (p * p_rate.signum()).rem_euclid(PI) * p_rate.signum();
        let q_step = q1 - (self.e * p_step + self.g * f);
        (p_step.abs() > 0.0 && q_step * q_rate.signum() > 0.0 && q_step.abs() < PI).then_some([p_step, q_step])
    }
}

/// The shared one at its place, the other one at the other place.
fn ordered<T>(place: usize, shared: T, other: T) -> [T; 2] {
    if place == 0 { [shared, other] } else { [other, shared] }
}

/// A single linear function by a step, with the slope at the start times the length.
fn single([slope, step]: [f64; 2]) -> Course {
    let (sin, cos) = step.sin_cos();
    Course { step, ratio: Complex::new(slope * cos / sin, slope) }
}

/// The same with the slope at the end.
fn single_to_end([slope, step]: [f64; 2]) -> Course {
    let (sin, cos) = step.sin_cos();
    let length = sin / slope;
    Course { step, ratio: Complex::new(length * cos, length * sin) }
}
