//! Where a rational surface in a plane folds back over itself (`docs/math/circular-surfaces.md#lines-between-rails`, *Folds in a plane*).
//!
//! With rows `(X, Y, W)` in a frame of the plane the determinant of `(X, Y, W)` and its two derivatives is `W³` times that of the
//! derivatives of the point, a polynomial: as long as its Bernstein coefficients over a cell have one sign the surface lies there on one side of itself
//! only, and where its values at corners of cells have both it folds. Cells are halved until one or the other is so.

use crate::base::bernstein;
use crate::base::vector::Vec3;
use crate::rational::RationalBezierSurface;

/// Rows are in a plane if they are off it by no more than this part of their size, and of the coordinates.
const PLANAR: f64 = 1e-12;
/// Coefficients below this part of the largest ones in their cell are zero: as on a rail that arcs touch.
const ZERO: f64 = 1e-9;
/// Rounding of coefficients, as a part of the products that they are made of.
const ROUNDING: f64 = 1e-13;
/// A cell is halved so many times at most, along s and along t in turn.
const MOST_HALVINGS: u32 = 14;

/// How a surface lies in its plane.
#[derive(Debug, Clone, Copy)]
pub(super) enum PlanarSide {
    /// On one side of itself, with the normal `f_s × f_t`.
    One(Vec3),
    /// Near these parameters it folds back; also where it is no more than a line.
    Folds([f64; 2]),
}

/// How the surface lies in its plane; `None` where it does not lie in one. Its weights are positive as a function.
pub(super) fn planar_side(surface: &RationalBezierSurface) -> Option<PlanarSide> {
    let origin = surface.corners()[0];
    let local = surface.seen_from(origin);
    let vectors = || local.rows().iter().map(|&[x, y, z, _]| Vec3::new(x, y, z));
    let longest = |v: &Vec3, w: &Vec3| v.length().total_cmp(&w.length());
    let along = vectors().max_by(longest)?;
    let x = along.unit()?;
    let across = vectors().map(|v| x.cross(v)).max_by(longest)?;
    if across.length() <= PLANAR * along.length() {
        return Some(PlanarSide::Folds([0.5; 2]));
    }
    let normal = across.unit()?;
    let weight = local.rows().iter().fold(0.0, |largest: f64, row| largest.max(row[3].abs()));
    let limit = PLANAR * (along.length() + weight * origin.to_vec().max_abs());
    if vectors().any(|v| v.dot(normal).abs() > limit) {
        return None;
    }
    let (size, y) = (along.length(), normal.cross(x));
    let row = |axis: Vec3| vectors().map(|v| v.dot(axis) / size).collect();
    let weights = local.rows().iter().map(|row| row[3] / weight).collect();
    Some(side([row(x), row(y), weights], local.degrees(), normal))
}

fn side(rows: [Vec<f64>; 3], degrees: [usize; 2], normal: Vec3) -> PlanarSide {
    let determinant = Determinant::of(rows, degrees);
    let sum: f64 = determinant.whole.values.iter().sum();
    let sign = if sum < 0.0 { -1.0 } else { 1.0 };
    match determinant.opposite(sign) {
        Some(at) => PlanarSide::Folds(at),
        None => PlanarSide::One(normal * sign),
    }
}

/// A polynomial in two parameters over a cell of them.
struct Cell {
    values: Vec<f64>,
    /// How far rounding may have each of them off: those next to a tiny arc are tiny, and so is their rounding.
    rounding: Vec<f64>,
    from: [f64; 2],
    size: [f64; 2],
}

/// The determinant of the module.
struct Determinant {
    whole: Cell,
    degrees: [usize; 2],
}

impl Determinant {
    fn of(rows: [Vec<f64>; 3], degrees: [usize; 2]) -> Self {
        let [by_s, by_t] = [0, 1].map(|along| rows.each_ref().map(|row| derivative(row, degrees, along)));
        let absolute = |row: &[f64]| row.iter().map(|x| x.abs()).collect::<Vec<_>>();
        let (mut values, mut sizes, mut made) = (Vec::new(), Vec::new(), [0; 2]);
        for (k, row) in rows.iter().enumerate() {
            let [i, j] = [(k + 1) % 3, (k + 2) % 3];
            for (i, j, sign) in [(i, j, 1.0), (j, i, -1.0)] {
                let ((a, of_a), (b, of_b)) = (&by_s[i], &by_t[j]);
                let product = |a: &[f64], b: &[f64], row: &[f64]| {
                    let (minor, at) = bernstein::product_of_two((a, *of_a), (b, *of_b));
                    bernstein::product_of_two((row, degrees), (&minor, at))
                };
                let (term, at) = product(a, b, row);
                let (size, _) = product(&absolute(a), &absolute(b), &absolute(row));
                made = at;
                values.resize(term.len(), 0.0);
                sizes.resize(term.len(), 0.0);
                values.iter_mut().zip(&term).for_each(|(sum, value)| *sum += sign * value);
                sizes.iter_mut().zip(&size).for_each(|(sum, value)| *sum += value);
            }
        }
        let rounding = sizes.iter().map(|size| ROUNDING * size).collect();
        Self { whole: Cell { values, rounding, from: [0.0; 2], size: [1.0; 2] }, degrees: made }
    }

    /// A corner of a cell at which the sign is the other one, or the middle where all is zero.
    fn opposite(&self, sign: f64) -> Option<[f64; 2]> {
        let largest = |cell: &Cell| cell.values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let is_zero = |(value, rounding): (&f64, &f64)| value.abs() <= *rounding;
        if self.whole.values.iter().zip(&self.whole.rounding).all(is_zero) {
            return Some([0.5; 2]);
        }
        let mut waiting = vec![(self.halves(&self.whole, 0), 1)];
        while let Some((cells, depth)) = waiting.pop() {
            for cell in cells {
                // A fold that is small beside the rest of its cell is seen in a part of the cell.
                if cell.values.iter().zip(&cell.rounding).all(|(value, rounding)| sign * value >= -rounding) {
                    continue;
                }
                let zero = ZERO * largest(&cell);
                let folds = |(k, at): (usize, _)| (sign * cell.values[k] < -cell.rounding[k].max(zero)).then_some(at);
                if let Some(at) = self.corners(&cell).find_map(folds) {
                    return Some(at);
                }
                if depth < MOST_HALVINGS {
                    waiting.push((self.halves(&cell, depth as usize % 2), depth + 1));
                }
            }
        }
        None
    }

    /// The places of the values at the corners, with the parameters there.
    fn corners<'a>(&self, cell: &'a Cell) -> impl Iterator<Item = (usize, [f64; 2])> + 'a {
        let [p, q] = self.degrees;
        let corner = move |[i, j]: [usize; 2]| {
            let place = [0, 1].map(|d: usize| cell.from[d] + cell.size[d] * [i, j][d] as f64);
            (i * p * (q + 1) + j * q, place)
        };
        [[0, 0], [0, 1], [1, 0], [1, 1]].into_iter().map(corner)
    }

    /// Both halves along one parameter.
    fn halves(&self, cell: &Cell, along: usize) -> [Cell; 2] {
        let mut size = cell.size;
        size[along] *= 0.5;
        let mut second = cell.from;
        second[along] += size[along];
        let [a, b] = halved(&cell.values, self.degrees, along);
        let [of_a, of_b] = halved(&cell.rounding, self.degrees, along);
        let made = |values, rounding, from| Cell { values, rounding, from, size };
        [made(a, of_a, cell.from), made(b, of_b, second)]
    }
}

/// The places of coefficients in lines along one parameter.
fn lines([p, q]: [usize; 2], along: usize) -> Vec<Vec<usize>> {
    match along {
        0 => (0..=q).map(|j| (0..=p).map(|i| i * (q + 1) + j).collect()).collect(),
        _ => (0..=p).map(|i| (0..=q).map(|j| i * (q + 1) + j).collect()).collect(),
    }
}

fn halved(values: &[f64], degrees: [usize; 2], along: usize) -> [Vec<f64>; 2] {
    let mut halves = [values.to_vec(), values.to_vec()];
    for line in lines(degrees, along) {
        let row: Vec<[f64; 1]> = line.iter().map(|&k| [values[k]]).collect();
        let (left, right) = bernstein::split(&row, 0.5);
        for (&k, (left, right)) in line.iter().zip(left.iter().zip(&right)) {
            [halves[0][k], halves[1][k]] = [left[0], right[0]];
        }
    }
    halves
}

/// The derivative along one parameter, of a degree less there.
fn derivative(values: &[f64], degrees: [usize; 2], along: usize) -> (Vec<f64>, [usize; 2]) {
    let mut lower = degrees;
    lower[along] -= 1;
    let mut out = vec![0.0; (lower[0] + 1) * (lower[1] + 1)];
    for (from, to) in lines(degrees, along).iter().zip(lines(lower, along)) {
        for (pair, &k) in from.windows(2).zip(&to) {
            out[k] = (values[pair[1]] - values[pair[0]]) * degrees[along] as f64;
        }
    }
    (out, lower)
}
