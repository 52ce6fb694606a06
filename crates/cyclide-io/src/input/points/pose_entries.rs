//! Entries of matrices by their numbers: `m11` to `m34`, or from 0, `m00` to `m23`; `r11`, `T[0][1]`.

use super::names::words_of;
use super::pose_names::Meaning;
use super::table::Table;

/// What stands before the numbers.
const MATRICES: [&str; 6] = ["m", "r", "t", "rot", "mat", "matrix"];

/// The name of a matrix and the numbers of an entry of it.
fn entry(name: &str) -> Option<(String, [usize; 2])> {
    let mut word = words_of(name).0.concat();
    let mut digit = || word.pop().and_then(|c| c.to_digit(10)).map(|digit| digit as usize);
    let (column, row) = (digit()?, digit()?);
    MATRICES.contains(&word.as_str()).then_some((word, [row, column]))
}

/// True for the name of an entry of a matrix.
pub(super) fn is_entry(name: &str) -> bool {
    entry(name).is_some()
}

/// Takes columns for entries of a matrix, where all nine of the rotation are there, or its numbers begin at 0; returns true where they do: `m11` is the middle
/// entry then.
pub(super) fn take_entries(table: &Table<'_>, meanings: &mut [Option<Meaning>]) -> bool {
    let all: Vec<(usize, String, [usize; 2])> = (0..table.header.len())
        .filter(|i| meanings[*i].is_none_or(|meaning| matches!(meaning, Meaning::Matrix(..))))
        .filter_map(|i| entry(table.header[i].text).map(|(name, numbers)| (i, name, numbers)))
        .collect();
    let mut any = false;
    for matrix in MATRICES {
        let own: Vec<(usize, [usize; 2])> =
            all.iter().filter(|(_, name, _)| name == matrix).map(|(i, _, numbers)| (*i, *numbers)).collect();
        let from_zero = own.iter().any(|(_, numbers)| numbers.contains(&0));
        let from = usize::from(!from_zero);
        let is_there = |k: usize| own.iter().any(|(_, numbers)| *numbers == [k / 3 + from, k % 3 + from]);
        if (0..9).all(is_there) || from_zero && matrix == "m" {
            any |= from_zero;
            for (i, [row, column]) in own {
                let inside = row < 4 + from && column < 4 + from;
                meanings[i] = inside.then(|| Meaning::Matrix(row - from, column - from));
            }
        }
    }
    any
}
