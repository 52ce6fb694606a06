//! Tables of poses without a header that are certain all the same: matrices (KITTI), and times with places and quaternions (TUM).

use cyclide::Vec3;

use super::fields::{Delimiter, Field, has_decimal_comma};
use super::table::Table;

/// Rotations may be off by this much: three decimals.
const FEW_DECIMALS: f64 = 5e-3;
/// Lines that are looked at.
const LOOKED_AT: usize = 1000;

const MATRIX: [&str; 12] = ["m11", "m12", "m13", "m14", "m21", "m22", "m23", "m24", "m31", "m32", "m33", "m34"];
const LAST_ROW: [&str; 4] = ["m41", "m42", "m43", "m44"];
const TUM: [&str; 8] = ["t", "x", "y", "z", "qx", "qy", "qz", "qw"];
const WITH_W_FIRST: [&str; 8] = ["t", "x", "y", "z", "qw", "qx", "qy", "qz"];
/// The w of a pose that is turned by less than 50 degrees.
const HARDLY_TURNED: f64 = 0.9;
/// Six decimals of a number that is 0.
const ROUNDED: f64 = 2e-6;
/// How alike the directions of a body are that goes ahead, how much less those of one that is read wrongly, and how many tell.
const AHEAD: f64 = 0.95;
const LESS: f64 = 0.1;
const ENOUGH: i32 = 5;

/// What is known of a table without a header.
pub(super) enum Headless {
    /// What its columns are, and the sentence that says so.
    Certain(Vec<&'static str>, &'static str),
    /// Eight numbers that may be in one order or the other.
    QuaternionFirstOrLast,
    /// The same as TUM has them, where by the figures w may be first all the same: with the sentence that asks.
    PerhapsFirst(Vec<&'static str>, &'static str, String),
    Unknown,
}

impl Headless {
    pub(super) fn of(table: &Table<'_>) -> Self {
        let mut rows: Vec<Vec<f64>> = Vec::new();
        let mut sound = true;
        table.for_first_rows(|fields| {
            let row: Option<Vec<f64>> = fields.iter().filter(|field| !field.text.is_empty()).map(number).collect();
            sound &= row.as_ref().is_some_and(|row| row.len() == table.first.len());
            rows.extend(row);
            sound && rows.len() < LOOKED_AT
        });
        if !sound || rows.is_empty() {
            return Self::Unknown;
        }
        let rises = || rows.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        let matrices = |from: usize| rows.iter().all(|row| is_displacement(&row[from..]));
        match table.first.len() {
            12 if matrices(0) => {
                Self::Certain(MATRIX.to_vec(), "each line is a matrix, row by row (as KITTI has them)")
            }
            16 if matrices(0) => {
                Self::Certain([&MATRIX[..], &LAST_ROW].concat(), "each line is a matrix of four rows, row by row")
            }
            13 if matrices(1) && rises() => {
                Self::Certain([&["t"], &MATRIX[..]].concat(), "each line is a time and a matrix, row by row")
            }
            8 if rises() && rows.iter().all(|row| is_one(row[4..].iter().map(|q| q * q).sum())) => {
                let begins_at_rest = rows.first().is_some_and(|row| row[5..].iter().all(|q| q.abs() <= ROUNDED));
                if table.delimiter != Delimiter::Blanks || begins_at_rest {
                    return Self::QuaternionFirstOrLast;
                }
                let note = "each line is t x y z qx qy qz qw (as TUM has them)";
                match may_be_first(&rows) {
                    true => Self::PerhapsFirst(TUM.to_vec(), note, perhaps_first()),
                    false => Self::Certain(TUM.to_vec(), note),
                }
            }
            _ => Self::Unknown,
        }
    }
}

/// True if w may stand first: where the first pose is hardly turned then, but almost turned over where w stands last, as cameras that look down are too; where
/// the body turns about the vertical then, and about x else; where it goes ahead on its way then, and not else.
fn may_be_first(rows: &[Vec<f64>]) -> bool {
    let hardly_turned = rows.first().is_some_and(|row| row[4].abs() > HARDLY_TURNED && row[7].abs() < row[4].abs());
    let about_one_axis = rows.iter().all(|row| row[5].abs() + row[6].abs() <= ROUNDED)
        && rows.iter().any(|row| row[4].abs() > ROUNDED && row[7].abs() > ROUNDED);
    let [first, last] = [[4, 5, 6, 7], [7, 4, 5, 6]].map(|order| goes_ahead(rows, order));
    hardly_turned || about_one_axis || first > AHEAD && last < first - LESS
}

/// How alike the directions are, in the frame of the body, in which it goes from row to row: 1 if all are the same, near 0 if they are any. `order` is that of w, x,
/// y, z of the quaternion.
fn goes_ahead(rows: &[Vec<f64>], order: [usize; 4]) -> f64 {
    let (mut sum, mut count) = (Vec3::ZERO, 0);
    for pair in rows.windows(2) {
        let place = |row: &[f64]| Vec3::new(row[1], row[2], row[3]);
        let way = place(&pair[1]) - place(&pair[0]);
        let [w, x, y, z] = order.map(|k| pair[0][k]);
        let axis = Vec3::new(-x, -y, -z);
        if way.length() > 0.0 {
            let turned = way + (axis.cross(way) * w + axis.cross(axis.cross(way))) * 2.0;
            sum += turned / way.length();
            count += 1;
        }
    }
    if count < ENOUGH { 0.0 } else { sum.length() / f64::from(count) }
}

/// The question whether w stands first.
fn perhaps_first() -> String {
    let first = WITH_W_FIRST.map(|name| format!("\"{name}\"")).join(", ");
    format!(
        "the last four of the eight columns are taken as qx qy qz qw, but by their values the first of them may be w: if so, write in the document `\"columns\": [{first}]`"
    )
}

fn number(field: &Field<'_>) -> Option<f64> {
    let text = field.text;
    if has_decimal_comma(text) { text.replacen(',', ".", 1).parse() } else { text.parse() }.ok()
}

fn is_one(value: f64) -> bool {
    (value - 1.0).abs() < FEW_DECIMALS
}

/// True for the rows of a rotation with a place beside it, and `0 0 0 1` where there are four.
fn is_displacement(row: &[f64]) -> bool {
    let axis = |i: usize| [row[4 * i], row[4 * i + 1], row[4 * i + 2]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let [a, b, c] = [axis(0), axis(1), axis(2)];
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let last = row.get(12..).is_none_or(|last| {
        last.is_empty() || last.iter().zip([0.0, 0.0, 0.0, 1.0]).all(|(v, w)| (v - w).abs() < FEW_DECIMALS)
    });
    [a, b, c].iter().all(|axis| is_one(dot(*axis, *axis)))
        && [dot(a, b), dot(a, c), dot(b, c)].iter().all(|dot| dot.abs() < FEW_DECIMALS)
        && is_one(dot(cross, c))
        && last
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Poses of a body that runs round a circle, its x along the way, from a heading on: t, the place, then w and z of the turn about the vertical, with a tilt.
    fn rows(tilt: f64, first: bool) -> Vec<Vec<f64>> {
        let row = |k: i32| {
            let angle = 1.9 + 0.05 * f64::from(k);
            let (half, lean) = ((angle / 2.0).sin_cos(), (tilt / 2.0).sin_cos());
            // The turn about the vertical after the lean about x.
            let [w, x, y, z] = [half.1 * lean.1, half.1 * lean.0, half.0 * lean.0, half.0 * lean.1];
            let place = [5.0 * angle.sin(), -5.0 * angle.cos(), 1.0];
            let turn = if first { [w, x, y, z] } else { [x, y, z, w] };
            [f64::from(k)].into_iter().chain(place).chain(turn).collect()
        };
        (0..40).map(row).collect()
    }

    #[test]
    fn w_that_stands_first_is_asked_about_and_the_order_of_tum_is_not() {
        for tilt in [0.0, 0.2, 1.0] {
            assert!(may_be_first(&rows(tilt, true)), "{tilt}");
            assert!(!may_be_first(&rows(tilt, false)), "{tilt}");
        }
    }
}
