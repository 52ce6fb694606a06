//! The order of two columns in which they are x and y of a map, and not its mirror image: by the directions that their names speak of, else by
//! their figures.

use super::fields::Field;
use super::names::Role;
use super::northing::{Order, northing_first};
use super::sampled::Sampled;
use super::table::{Table, numbers_of};
use super::words::folded;

/// A direction of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Direction {
    East,
    North,
    West,
    South,
}

/// Words that are directions, in small letters without accents, and beginnings of words that are.
const WEST: &str = "west westing westings westlich westen oeste ovest ouest";
const SOUTH: &str = "south southing southings sud sued suden sudlich suedlich sur sul";
const EAST_BEGINS: [&str; 8] = ["east", "ost", "oost", "leste", "este", "rechtsw", "oestl", "oestw"];
const NORTH_BEGINS: [&str; 6] = ["north", "nord", "noord", "norte", "noerd", "hochw"];

impl Direction {
    /// That of a name, if it speaks of one.
    fn of(field: &Field<'_>) -> Option<Self> {
        match Role::of(field) {
            Role::East { .. } => return Some(Self::East),
            Role::North { .. } => return Some(Self::North),
            Role::Label | Role::Axis | Role::Height { .. } => return None,
            _ => {}
        }
        let mut found = folded(field.text).into_iter().filter_map(|word| Self::of_word(&word));
        found.next().filter(|_| found.next().is_none())
    }

    fn of_word(word: &str) -> Option<Self> {
        let is = |list: &str| list.split(' ').any(|own| own == word);
        let begins = |list: &[&str]| list.iter().any(|start| word.starts_with(start));
        match word {
            _ if is(WEST) => Some(Self::West),
            _ if is(SOUTH) => Some(Self::South),
            _ if word == "est" || begins(&EAST_BEGINS) => Some(Self::East),
            _ if begins(&NORTH_BEGINS) => Some(Self::North),
            _ => None,
        }
    }

    /// Along east and north.
    const fn vector(self) -> [i32; 2] {
        match self {
            Self::East => [1, 0],
            Self::North => [0, 1],
            Self::West => [-1, 0],
            Self::South => [0, -1],
        }
    }
}

/// True if a name speaks of a direction.
pub(super) fn has_direction(table: &Table<'_>, column: usize) -> bool {
    table.header.get(column).and_then(Direction::of).is_some()
}

/// Whether two columns taken as x and y are a mirror image of the map, if their names say so; where only one speaks of a direction the other
/// one is its partner.
pub(super) fn mirrored_by_words(table: &Table<'_>, [first, second]: [usize; 2]) -> Option<bool> {
    let direction = |i: usize| table.header.get(i).and_then(Direction::of);
    let turn = |a: Direction, b: Direction| {
        let ([ax, ay], [bx, by]) = (a.vector(), b.vector());
        ax * by - ay * bx
    };
    match (direction(first), direction(second)) {
        (Some(a), Some(b)) => Some(turn(a, b) < 0).filter(|_| turn(a, b) != 0),
        (Some(Direction::North), None) | (None, Some(Direction::East)) => Some(true),
        (Some(Direction::East), None) | (None, Some(Direction::North)) => Some(false),
        _ => None,
    }
}

/// The same by their figures.
pub(super) fn mirrored_by_figures(table: &Table<'_>, sampled: &Sampled, [first, second]: [usize; 2]) -> Option<bool> {
    let turned = |columns| northing_first(table, sampled, columns);
    match (turned([first, second]), turned([second, first])) {
        (Order::Certain, _) => Some(true),
        (_, Order::Certain) => Some(false),
        (Order::Possible, _) => Some(true),
        (_, Order::Possible) => Some(false),
        _ => None,
    }
}

/// Columns with the first two in the order of x and y, as far as names and figures say it.
pub(super) fn in_right_order(table: &Table<'_>, sampled: &Sampled, columns: &[usize]) -> Vec<usize> {
    let mut columns = columns.to_vec();
    if let [first, second, ..] = columns[..] {
        let pair = [first, second];
        if mirrored_by_words(table, pair).or_else(|| mirrored_by_figures(table, sampled, pair)) == Some(true) {
            columns.swap(0, 1);
        }
    }
    columns
}

/// Columns that may be meant, x first: one that speaks of a direction stands beside its partner, which is the other one that does, else the next.
pub(super) fn proposed(table: &Table<'_>, sampled: &Sampled, columns: &[usize]) -> Vec<usize> {
    let is_height =
        |i: &usize| table.header.get(*i).is_some_and(|field| matches!(Role::of(field), Role::Height { .. }));
    let (heights, plan): (Vec<usize>, Vec<usize>) = columns.iter().copied().partition(is_height);
    let speaks = |i: &&usize| has_direction(table, **i);
    let partner = |own: usize| {
        let others = || plan.iter().filter(move |i| **i != own);
        others().find(speaks).or_else(|| others().find(|i| **i > own)).or_else(|| others().next_back()).copied()
    };
    let all = match plan.iter().find(speaks) {
        Some(&own) => [Some(own), partner(own)].into_iter().flatten().chain(heights).collect(),
        None => [plan, heights].concat(),
    };
    in_right_order(table, sampled, &all)
}

/// The sentence about columns that were asked for, if by their names or figures they are the mirror image of a map.
pub(super) fn asked_for_mirrored(table: &Table<'_>, coordinates: &[usize]) -> Option<String> {
    let [first, second, ..] = coordinates[..] else { return None };
    let both = has_direction(table, first) && has_direction(table, second);
    let why = match mirrored_by_words(table, [first, second]).filter(|_| both) {
        Some(true) => "names",
        None if northing_first(table, &Sampled::of(table), [first, second]) == Order::Certain => "figures",
        _ => return None,
    };
    let turned = [second, first].into_iter().chain(coordinates.get(2).copied());
    Some(format!(
        "of {}, the first is a northing by their {why}, and the second an easting: as x and y, as requested, they mirror the curve; `--columns {}` keeps the orientation of the map (in a document `columns`)",
        table.names([first, second]),
        numbers_of(turned)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::place::Source;

    fn order(text: &str) -> Vec<usize> {
        let table = Table::parse(Source { name: "t", text }, &[]).unwrap();
        proposed(&table, &Sampled::of(&table), &(0..table.width).collect::<Vec<_>>())
    }

    #[test]
    fn no_order_mirrors_that_names_or_figures_know() {
        for (header, found) in [
            ("Norte;foo", vec![1, 0]),
            ("foo;Leste", vec![1, 0]),
            ("foo;Norte", vec![0, 1]),
            ("Nordrichtung;Ostrichtung", vec![1, 0]),
            ("Westing;Northing", vec![1, 0]),
            ("Southing;Westing", vec![1, 0]),
            ("Westing;Southing", vec![0, 1]),
            ("H\u{f6}he;Nordkoord;foo", vec![2, 1, 0]),
            ("foo;Norte;bar;baz", vec![2, 1]),
            ("foo;bar;Norte", vec![1, 2]),
        ] {
            let row = vec!["1.5"; header.split(';').count()].join(";");
            assert_eq!(order(&format!("{header}\n{row}\n")), found, "{header}");
        }
        assert_eq!(order("foo;bar\n5432000;456000\n"), [1, 0]);
        assert_eq!(order("foo;bar\n456000;5432000\n"), [0, 1]);
        // Names say more than figures.
        assert_eq!(order("Nordw.;foo\n456000;5432000\n"), [1, 0]);
    }
}
