//! Tables of poses without a header that are certain all the same: matrices (KITTI), and times with places and quaternions (TUM).

use super::decimals::has_decimal_comma;
use super::table::{Delimiter, Field, Table};

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

/// What is known of a table without a header.
pub(super) enum Headless {
    /// What its columns are, and the sentence that says so.
    Certain(Vec<&'static str>, &'static str),
    /// Eight numbers that may be in one order or the other.
    QuaternionFirstOrLast,
    /// The same as TUM has them, where the first coordinate of the quaternion is large as w is: with the sentence that asks.
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
                let begins_at_rest = rows.first().is_some_and(|row| row[4].abs() == 1.0);
                if table.delimiter != Delimiter::Blanks || begins_at_rest {
                    return Self::QuaternionFirstOrLast;
                }
                let note = "each line is t x y z qx qy qz qw (as TUM has them)";
                match is_large_first(&rows) {
                    true => Self::PerhapsFirst(TUM.to_vec(), note, perhaps_first()),
                    false => Self::Certain(TUM.to_vec(), note),
                }
            }
            _ => Self::Unknown,
        }
    }
}

/// True if the first pose is hardly turned where w stands first, and almost turned over where it stands last, which cameras that look down are too.
fn is_large_first(rows: &[Vec<f64>]) -> bool {
    rows.first().is_some_and(|row| row[4].abs() > HARDLY_TURNED && row[7].abs() < row[4].abs())
}

/// The question whether w stands first.
fn perhaps_first() -> String {
    let first = WITH_W_FIRST.map(|name| format!("\"{name}\"")).join(", ");
    format!(
        "the last four of the eight columns are taken as qx qy qz qw, and the first of them is large, as w is in most tables: if it is w, say so, in the \
         document `\"columns\": [{first}]`"
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
