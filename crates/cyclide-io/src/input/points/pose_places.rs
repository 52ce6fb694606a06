//! Places in a table of poses in other words than x, y, z: heights, coordinates of maps, numbered ones (`position[0]`).

use super::globe::{on_the_globe, refused_on_the_globe};
use super::names::{Role, words_of};
use super::pose_names::{Meaning, POSITION};
use super::sampled::Sampled;
use super::table::Table;
use crate::text::place::{Diagnostic, quoted};

/// Words before the number of a coordinate; those of one letter mean it where they count from 0.
const COUNTED: [&str; 8] = ["position", "pos", "translation", "trans", "location", "tvec", "p", "t"];

/// True if a column has a coordinate.
fn has(meanings: &[Option<Meaning>], axis: usize) -> bool {
    meanings.contains(&Some(Meaning::Position(axis)))
}

/// True if a matrix has the place.
fn in_matrix(meanings: &[Option<Meaning>]) -> bool {
    meanings.iter().any(|meaning| matches!(meaning, Some(Meaning::Matrix(0..=2, 3))))
}

/// Takes columns for coordinates where no column is named x, y or z, and says so.
pub(super) fn take_places(table: &Table<'_>, meanings: &mut [Option<Meaning>], notes: &mut Vec<String>) {
    if in_matrix(meanings) {
        return;
    }
    if !(0..3).any(|axis| has(meanings, axis)) {
        take_counted(table, meanings);
    }
    let mut taken = Vec::new();
    if !has(meanings, 0) && !has(meanings, 1) {
        let found = [Role::East { clear: true }, Role::North { clear: true }].map(|role| only(table, meanings, role));
        if let [Some(east), Some(north)] = found {
            taken.extend([(east, 0), (north, 1)]);
        }
    }
    taken.iter().for_each(|(column, axis)| meanings[*column] = Some(Meaning::Position(*axis)));
    if has(meanings, 0)
        && has(meanings, 1)
        && !has(meanings, 2)
        && let Some(height) = only(table, meanings, Role::Height { clear: true })
    {
        meanings[height] = Some(Meaning::Position(2));
        taken.push((height, 2));
    }
    if !taken.is_empty() {
        let said = |(column, axis): &(usize, usize)| {
            format!("`{}` is {}", quoted(table.header[*column].text), POSITION[*axis])
        };
        notes.push(format!("by their names {}", taken.iter().map(said).collect::<Vec<_>>().join(", ")));
    }
}

/// The only column of a role that is nothing else; a single letter may mean anything.
fn only(table: &Table<'_>, meanings: &[Option<Meaning>], role: Role) -> Option<usize> {
    let is_it = |i: &usize| {
        let field = &table.header[*i];
        meanings[*i].is_none()
            && field.text.chars().count() > 1
            && Role::of(field) == role
            && !is_one_letter(field.text)
    };
    let mut all = (0..table.header.len()).filter(is_it);
    all.next().filter(|_| all.next().is_none())
}

/// True for a letter with a unit: `H [m]`.
fn is_one_letter(name: &str) -> bool {
    let (words, unit) = words_of(name);
    words.first().is_some_and(|first| first.chars().count() == 1 && words.len() == 1 + usize::from(unit))
}

/// The name and the number of a column: `position[0]`, `pose.pos_1`, `tvec2`.
fn counted(name: &str) -> Option<(Vec<String>, usize)> {
    let (mut words, _) = words_of(name);
    let last = words.pop()?;
    let digit = last.chars().next_back()?.to_digit(10)?;
    let rest = &last[..last.len() - 1];
    if !rest.is_empty() {
        words.push(rest.to_owned());
    }
    words.last().is_some_and(|word| COUNTED.contains(&word.as_str())).then_some((words, digit as usize))
}

/// Takes three columns that are counted from 0 or 1 for the coordinates, where there are no more of them.
fn take_counted(table: &Table<'_>, meanings: &mut [Option<Meaning>]) {
    let all: Vec<(usize, Vec<String>, usize)> = (0..table.header.len())
        .filter(|i| meanings[*i].is_none())
        .filter_map(|i| counted(table.header[i].text).map(|(words, number)| (i, words, number)))
        .collect();
    let Some((_, name, _)) = all.first() else { return };
    let mut own: Vec<(usize, usize)> =
        all.iter().filter(|(_, words, _)| words == name).map(|(i, _, number)| (*number, *i)).collect();
    own.sort_unstable();
    let numbers: Vec<usize> = own.iter().map(|(number, _)| *number).collect();
    let is_letter = name.last().is_some_and(|word| word.len() == 1);
    if own.len() == all.len() && (numbers == [0, 1, 2] || numbers == [1, 2, 3] && !is_letter) {
        own.into_iter().zip(0..).for_each(|((_, column), axis)| meanings[column] = Some(Meaning::Position(axis)));
    }
}

/// Refuses angles on the globe where no other place is.
///
/// # Errors
/// The remedy: to project them first.
pub(super) fn refuse_globe(table: &Table<'_>, meanings: &[Option<Meaning>]) -> Result<(), Box<Diagnostic>> {
    if in_matrix(meanings) || has(meanings, 0) || has(meanings, 1) {
        return Ok(());
    }
    let globe = on_the_globe(table, &Sampled::of(table));
    globe.map_or(Ok(()), |globe| Err(refused_on_the_globe(table, globe, &globe)))
}
