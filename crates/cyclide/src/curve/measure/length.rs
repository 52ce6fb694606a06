//! Arc length: the total, and the constant-speed parameter.

use crate::base::quadrature::{self, gauss8};
use crate::base::vector::Point3;
use crate::curve::{ParamCurve, PieceForm};

/// Length of the whole curve: closed form for arcs and circles, else each piece to 1e-12 of itself.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// assert!((cyclide::curve::length(&arc) - std::f64::consts::PI).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn length(curve: &dyn ParamCurve) -> f64 {
    (0..curve.piece_count()).map(|piece| curve.piece_length(piece, 0.0, 1.0)).sum()
}

/// `count` points at equal steps of arc length with their parameters, both ends included (on a closed curve the last
/// is the first again).
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// let places = cyclide::curve::resample(&arc, 3);
/// assert!((places[1].0 - 0.5).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn resample(curve: &dyn ParamCurve, count: usize) -> Vec<(f64, Point3)> {
    ArcLength::new(curve).uniform(count).into_iter().map(|t| (t, curve.point(t))).collect()
}

/// A table of the arc length of a curve, made once and inverted as often as wanted.
///
/// Pieces that are arcs or circles are inverted in closed form, others by Newton steps inside cells on which one
/// 8-point quadrature gives the length to rounding. Pieces of length zero are passed over.
///
/// ```
/// use cyclide::{Point3, curve::{ArcLength, CircleSpline, CircleSplineOptions, ParamCurve}};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 1.0]].map(Point3::from);
/// let spline = CircleSpline::from_points(&points, &CircleSplineOptions::default())?;
/// let index = ArcLength::new(&spline);
/// let middle = index.parameter_at(0.5);
/// assert!((cyclide::curve::length(&spline.restricted(0.0, middle)?) - 0.5 * index.total()).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug)]
pub struct ArcLength<'a> {
    curve: &'a dyn ParamCurve,
    cells: Vec<Cell>,
    total: f64,
}

/// The part `[s0, s1]` of a piece.
#[derive(Debug)]
struct Cell {
    piece: usize,
    s0: f64,
    s1: f64,
    length: f64,
    /// Length of the curve up to the end of the cell.
    end: f64,
    form: PieceForm,
}

impl<'a> ArcLength<'a> {
    /// Measures the curve.
    #[must_use]
    pub fn new(curve: &'a dyn ParamCurve) -> Self {
        let mut cells = Vec::with_capacity(curve.piece_count());
        for piece in 0..curve.piece_count() {
            match curve.piece_form(piece) {
                PieceForm::Free => cut(curve, piece, &mut cells),
                form => {
                    let length = curve.piece_length(piece, 0.0, 1.0);
                    cells.push(Cell { piece, s0: 0.0, s1: 1.0, length, end: 0.0, form });
                }
            }
        }
        let mut total = 0.0;
        for cell in &mut cells {
            total += cell.length;
            cell.end = total;
        }
        Self { curve, cells, total }
    }

    /// Length of the whole curve.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.total
    }

    /// Arc length from the start to a global parameter (clamped to `[0, 1]`): the *station* of the point, to about 1e-13
    /// of the length.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, curve::{ArcLength, Circle}};
    /// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0)?;
    /// assert!((ArcLength::new(&circle).station(0.25) - std::f64::consts::PI).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn station(&self, t: f64) -> f64 {
        if t >= 1.0 {
            return self.total;
        }
        let (piece, s) = self.curve.locate(t);
        let index = self.cells.partition_point(|cell| (cell.piece, cell.s1) <= (piece, s)).min(self.cells.len() - 1);
        let cell = &self.cells[index];
        if cell.piece != piece {
            // Between the last cell of its piece and the next one.
            return cell.end - cell.length;
        }
        let part = match cell.form {
            PieceForm::Arc(arc) => arc.length_to(s),
            PieceForm::Circle(_) => s * cell.length,
            PieceForm::Free => gauss8(&mut |s: f64| self.curve.piece_speed(piece, s), cell.s0, s),
        };
        // Not `clamp`, which panics where a length is NaN.
        cell.end - cell.length + part.max(0.0).min(cell.length)
    }

    /// The global parameter of the point at the fraction `fraction` of the length (clamped to `[0, 1]`), to about
    /// 1e-12 of the length. Ends are exact. On a curve of length zero it is the fraction itself.
    #[must_use]
    pub fn parameter_at(&self, fraction: f64) -> f64 {
        let fraction = fraction.clamp(0.0, 1.0);
        if self.total == 0.0 || fraction == 0.0 || fraction >= 1.0 {
            return fraction;
        }
        let goal = fraction * self.total;
        let index = self.cells.partition_point(|cell| cell.end < goal).min(self.cells.len() - 1);
        let cell = &self.cells[index];
        let rest = (goal - (cell.end - cell.length)).max(0.0).min(cell.length);
        let s = match cell.form {
            PieceForm::Arc(arc) => arc.parameter_at_length(rest / cell.length),
            PieceForm::Circle(_) => rest / cell.length,
            PieceForm::Free => {
                let mut speed = |s: f64| self.curve.piece_speed(cell.piece, s);
                quadrature::invert(&mut speed, [cell.s0, cell.s1], cell.length, rest)
            }
        };
        (cell.piece as f64 + s) / self.curve.piece_count() as f64
    }

    /// `count` parameters at equal steps of arc length from 0 to 1, both included; `[0]` for `count` 1.
    #[must_use]
    pub fn uniform(&self, count: usize) -> Vec<f64> {
        let last = count.saturating_sub(1).max(1) as f64;
        (0..count).map(|i| self.parameter_at(i as f64 / last)).collect()
    }
}

/// Appends the cells of a piece, in order.
fn cut(curve: &dyn ParamCurve, piece: usize, cells: &mut Vec<Cell>) {
    let parts = quadrature::cells(&mut |s: f64| curve.piece_speed(piece, s), 0.0, 1.0);
    let form = PieceForm::Free;
    cells.extend(parts.into_iter().map(|c| Cell { piece, s0: c.a, s1: c.b, length: c.integral, end: 0.0, form }));
}
