//! A proof of distance for one smooth piece: rational Bézier parts at equal parameters, and how far they are from it.
//!
//! With homogeneous rows `(w p, w)` over a parameter interval, `v_i = w_i (p_i - a)` for a chord from `a` and `n` across
//! it, the function `f = n·v` is `w` times the distance from the chord's line. A polynomial of degree `d` is within
//! `M s(1-s)/2` of the straight line between its ends, `M` the largest of `d(d-1) |v_i - 2 v_(i+1) + v_(i+2)|` (the hull
//! of its second derivative), so over positive weights
//!
//! ```text
//! distance from the line <= max over s of ((1-s) |f_0| + s |f_d| + M s(1-s)/2) / min w_i
//! ```
//! which tends to the sagitta itself as the interval shrinks; and the curve lies in the hull of its control points,
//! which bounds the distance from the line again and tells how far it reaches beyond the ends of the chord. Along a
//! direction `e` with `f = e·v` the derivative of the point is `(w f' - f w')/w²`: it never turns back where that
//! polynomial has no negative coefficient. (Own derivations from the convex hull property.)

use crate::base::bernstein;
use crate::base::vector::{Point3, Vec3};
use crate::rational::RationalBezier;

/// A rational Bézier curve that stands for the part `[from, to]` of a piece, point for point at equal parameters.
#[derive(Debug, Clone, PartialEq)]
struct HullPart {
    rows: Vec<[f64; 4]>,
    from: f64,
    to: f64,
}

/// Rational parts of one smooth piece, in order, and a proved bound on their distance from it at equal parameters.
///
/// ```
/// use cyclide::{curve::ParamCurve, rational::RationalBezier};
/// let parabola = RationalBezier::new(vec![[0.0, 0.0, 0.0, 1.0], [1.0, 2.0, 0.0, 1.0], [2.0, 0.0, 0.0, 1.0]])?;
/// let mut hull = parabola.piece_hull(0, 1e-6)?;
/// let chord = [parabola.point(0.0), parabola.point(1.0)];
/// assert!((1.0..1.1).contains(&hull.deviation([0.0, 1.0], chord))); // its height is 1
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PieceHull {
    parts: Vec<HullPart>,
    bound: f64,
    scratch: Vec<[f64; 4]>,
}

impl PieceHull {
    /// Of a piece that is an arc or a circle by its [`PieceForm`](crate::curve::PieceForm): its distances are known in closed
    /// form. Any other piece with this hull is refused by whatever needs a proof.
    #[must_use]
    pub fn closed_form() -> Self {
        Self::default()
    }

    /// Of a piece that is this rational curve at equal parameters.
    #[must_use]
    pub fn exact(curve: &RationalBezier) -> Self {
        let mut hull = Self::default();
        hull.push(curve, 0.0, 1.0);
        hull
    }

    /// Of a piece within `bound` of parts to be [pushed](Self::push).
    #[must_use]
    pub fn within(bound: f64) -> Self {
        Self { bound, ..Self::default() }
    }

    /// Adds the curve that stands for the part `[from, to]` of the piece's parameter; parts follow one another.
    pub fn push(&mut self, curve: &RationalBezier, from: f64, to: f64) {
        self.parts.push(HullPart { rows: curve.rows().to_vec(), from, to });
    }

    /// Bound on the distance of the parts from the piece.
    #[must_use]
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// The point of the parts at a parameter of the piece; `None` in closed form.
    #[must_use]
    pub fn point(&self, s: f64) -> Option<Point3> {
        let part = self.parts.iter().find(|p| s <= p.to).or(self.parts.last())?;
        let [x, y, z, w] = bernstein::eval(&part.rows, (s - part.from) / (part.to - part.from));
        Some(Point3::new(x / w, y / w, z / w))
    }

    /// A proved bound on the distance of the points of the piece over `[a, b]` from the segment `chord`; infinite where
    /// the hull proves nothing (closed form, or weights that are not positive there).
    pub fn deviation(&mut self, [a, b]: [f64; 2], chord: [Point3; 2]) -> f64 {
        let line = Chord::new(chord);
        let mut largest = if self.parts.is_empty() { f64::INFINITY } else { 0.0 };
        for part in self.parts.iter().filter(|p| p.from < b && a < p.to) {
            part.restrict_to([a, b], &mut self.scratch);
            largest = f64::max(largest, line.deviation(&self.scratch));
        }
        largest + self.bound
    }

    /// True if it is proved that the parts never turn back along a direction over `[a, b]`: their derivative has no
    /// component against it anywhere. A loop is found out so, however short its range of the parameter is. False where the hull
    /// proves nothing (closed form, or weights that are not positive there).
    ///
    /// ```
    /// use cyclide::{Vec3, curve::ParamCurve, rational::RationalBezier};
    /// let parabola = RationalBezier::new(vec![[0.0, 0.0, 0.0, 1.0], [1.0, 2.0, 0.0, 1.0], [2.0, 0.0, 0.0, 1.0]])?;
    /// let mut hull = parabola.piece_hull(0, 1e-6)?;
    /// assert!(hull.advances([0.0, 1.0], Vec3::X));
    /// assert!(hull.advances([0.0, 0.5], Vec3::Y) && !hull.advances([0.0, 0.6], Vec3::Y)); // it rises, then falls
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    pub fn advances(&mut self, [a, b]: [f64; 2], direction: Vec3) -> bool {
        let mut parts = self.parts.iter().filter(|p| p.from < b && a < p.to).peekable();
        let scratch = &mut self.scratch;
        parts.peek().is_some()
            && parts.all(|part| {
                part.restrict_to([a, b], scratch);
                never_turns_back(scratch, direction)
            })
    }
}

impl HullPart {
    /// The rows over what of `[a, b]` is in this part.
    fn restrict_to(&self, [a, b]: [f64; 2], rows: &mut Vec<[f64; 4]>) {
        let place = |s: f64| ((s - self.from) / (self.to - self.from)).clamp(0.0, 1.0);
        rows.clear();
        rows.extend_from_slice(&self.rows);
        bernstein::restrict(rows, [place(a), place(b)]);
    }
}

/// True if the derivative of the curve with these rows has a proof that it has no component against a direction.
fn never_turns_back(rows: &[[f64; 4]], direction: Vec3) -> bool {
    if rows.len() < 2 {
        return false;
    }
    let [x, y, z, w] = rows[0];
    let start = Vec3::new(x, y, z) * (1.0 / w);
    let along = |row: &[f64; 4]| (Vec3::new(row[0], row[1], row[2]) - start * row[3]).dot(direction);
    let (f, w): (Vec<f64>, Vec<f64>) = rows.iter().map(|row| (along(row), row[3])).unzip();
    let difference = |c: &[f64]| -> Vec<f64> { c.windows(2).map(|pair| pair[1] - pair[0]).collect() };
    let up = bernstein::product(&w, &difference(&f));
    let down = bernstein::product(&f, &difference(&w));
    w.iter().all(|w| *w > 0.0) && up.iter().zip(&down).all(|(up, down)| up - down >= 0.0)
}

/// A chord: start, unit direction (zero for a chord of no length) and length.
struct Chord {
    start: Point3,
    along: Vec3,
    length: f64,
}

impl Chord {
    fn new([start, end]: [Point3; 2]) -> Self {
        let chord = end - start;
        match chord.unit() {
            Some(along) => Self { start, along, length: chord.length() },
            None => Self { start, along: Vec3::ZERO, length: 0.0 },
        }
    }

    /// Bound on the distance from the chord of the curve with these rows.
    fn deviation(&self, rows: &[[f64; 4]]) -> f64 {
        let degree = rows.len() - 1;
        let seen = |row: &[f64; 4]| {
            let v = Vec3::new(row[0], row[1], row[2]) - self.start.to_vec() * row[3];
            let along = v.dot(self.along);
            (along, v - self.along * along)
        };
        let (mut least, mut beyond, mut hull, mut bend) = (f64::INFINITY, 0.0_f64, 0.0_f64, 0.0_f64);
        let (mut before, mut last) = (Vec3::ZERO, Vec3::ZERO);
        let mut ends = [0.0; 2];
        for (i, row) in rows.iter().enumerate() {
            let w = row[3];
            if !(w > 0.0) {
                return f64::INFINITY;
            }
            let (along, across) = seen(row);
            least = least.min(w);
            beyond = beyond.max(-along / w).max(along / w - self.length);
            let distance = across.length();
            hull = hull.max(distance / w);
            if i >= 2 {
                bend = bend.max((before - last * 2.0 + across).length());
            }
            if i == 0 {
                ends[0] = distance;
            }
            ends[1] = distance;
            (before, last) = (last, across);
        }
        let bend = (degree * (degree - 1)) as f64 * bend;
        let across = hull.min(highest(ends, bend) / least);
        let deviation = across.hypot(beyond);
        if deviation.is_nan() { f64::INFINITY } else { deviation }
    }
}

/// The largest of `(1-s) a + s b + m s(1-s)/2` over `[0, 1]`.
fn highest([a, b]: [f64; 2], m: f64) -> f64 {
    let s = (0.5 + (b - a) / m).clamp(0.0, 1.0);
    if m > 0.0 { (1.0 - s) * a + s * b + 0.5 * m * s * (1.0 - s) } else { a.max(b) }
}
