//! The coordinates of a table whose columns nobody chose: by their names, else the only numbers.

use super::compass::{has_direction, in_right_order, mirrored_by_figures, mirrored_by_words, proposed};
use super::fields::is_number;
use super::globe::{Degrees, on_the_globe, refused_on_the_globe};
use super::height_words::is_over_ellipsoid;
use super::names::{Role, axis_kind, is_letter, is_of_system, words_of};
use super::northing::{Order, northing_first};
use super::sampled::Sampled;
use super::table::{Table, numbers_of};
use crate::text::place::Diagnostic;

/// Coordinate columns that were found, with the sentence about a choice that could have been another one.
pub(super) type Found = (Vec<usize>, Option<String>);

/// Choices that a message offers at most.
const OFFERED: usize = 4;

/// Letters of eastings and northings that stand alone: Rechtswert and Hochwert, meridiana and perpendicular.
const LETTERS: [[&str; 2]; 2] = [["r", "h"], ["m", "p"]];

/// Words beside the letters of a map that make them something else than coordinates.
const NO_COORDINATES: &str = "delta d diff difference differenz abweichung v vel a acc sd s sigma m my rms std dev shift korrektur correction res";

/// Coordinates by their names, else the only numbers.
pub(super) fn found(table: &Table<'_>, sampled: &Sampled, taken: &[Option<usize>]) -> Result<Found, Box<Diagnostic>> {
    let free = || (0..table.width).filter(|i| !taken.contains(&Some(*i)));
    if table.header.is_empty() {
        let numeric = |i: &usize| table.first.get(*i).is_some_and(is_number);
        return found_without_names(table, sampled, &free().filter(numeric).collect::<Vec<_>>(), free());
    }
    let mut roles: Vec<Role> = table.header.iter().map(Role::of).collect();
    let globe = on_the_globe(table, sampled);
    for i in globe.into_iter().flatten() {
        roles[i] = Role::Other;
    }
    if let Some(found) = by_names(table, sampled, &roles)? {
        return Ok(found);
    }
    if let Some(globe) = globe {
        let mut lengths = globe.to_vec();
        lengths.sort_unstable();
        lengths.extend(height(table, sampled, &roles, None).0);
        return Err(refused_on_the_globe(table, globe, &lengths));
    }
    only_numbers(table, sampled, &roles, &free().collect::<Vec<_>>())
}

/// Coordinates by their names.
fn by_names(table: &Table<'_>, sampled: &Sampled, roles: &[Role]) -> Result<Option<Found>, Box<Diagnostic>> {
    let mut map = of_map(table, sampled, roles)?;
    if let ([None, None], Some(pair)) = (map, LETTERS.iter().find_map(|pair| letters(table, sampled, pair))) {
        map = pair.map(Some);
    }
    let [xs, ys, zs] = ["x", "y", "z"].map(|letter| axis(table, roles, letter));
    for (letter, columns) in [("z", &zs), ("x", &xs), ("y", &ys)] {
        if columns.len() > 1 {
            let names = table.names(columns.iter().copied());
            let choices = choices(table, sampled, &xs, &ys, &zs);
            return Err(table.header_refused(format!("several columns may be {letter}: {names}; choose{choices}")));
        }
    }
    let z = zs.first().copied();
    if let (Some(&x), Some(&y)) = (xs.first(), ys.first()) {
        let all: Vec<usize> = [x, y].into_iter().chain(z).collect();
        // `x_acc` may be anything, and is no coordinate beside an easting.
        let guessed = |i: &usize| ["x", "y", "z"].iter().any(|letter| axis_kind(letter, &table.header[*i]) == Some(2));
        let guess = all.iter().any(guessed);
        if !(guess && map.iter().all(Option::is_some)) {
            return of_axes(table, sampled, roles, &all, guess).map(Some);
        }
    }
    if let [Some(x), Some(y)] = map {
        // The `H` of a Hochwert is no height.
        let beside: Vec<Role> =
            roles.iter().enumerate().map(|(i, role)| if i == x || i == y { Role::Other } else { *role }).collect();
        let (height, remark) = height(table, sampled, &beside, z);
        let height = height.or_else(|| letter_column(table, "u").filter(|i| sampled.is_of_numbers(*i)));
        let all: Vec<usize> = [x, y].into_iter().chain(height.filter(|z| *z != y)).collect();
        let degrees = Degrees::of(table, sampled, [x, y]);
        if degrees == Degrees::Certain {
            return Err(refused_on_the_globe(table, [x, y], &all));
        }
        let is_letter = |i: &usize| words_of(table.header[*i].text).0[0].len() == 1 && roles[*i] != Role::Axis;
        let chosen = all.iter().any(is_letter) || [x, y].iter().any(|i| !of_words(roles[*i]));
        let remark = if chosen { Some(taken_columns(table, &all)) } else { remark };
        let remark = match degrees {
            Degrees::Possible => Some(Degrees::remark(remark.unwrap_or_else(|| taken_columns(table, &all)))),
            _ => remark,
        };
        return Ok(Some((all, remark)));
    }
    let pair = [Role::Abscissa, Role::Ordinate].map(|role| candidates(table, roles, |own| own == role));
    let [x, y] = [one_of(table, sampled, &pair[0], &pair, &[])?, one_of(table, sampled, &pair[1], &pair, &[])?];
    let (Some(x), Some(y)) = (x, y) else { return Ok(None) };
    let (height, remark) = height(table, sampled, roles, z);
    in_order(table, sampled, [x, y].into_iter().chain(height).collect(), None, remark).map(Some)
}

/// True for what is an easting or a northing by its own name.
const fn of_words(role: Role) -> bool {
    matches!(role, Role::East { .. } | Role::North { .. })
}

/// The easting and the northing.
fn of_map(table: &Table<'_>, sampled: &Sampled, roles: &[Role]) -> Result<[Option<usize>; 2], Box<Diagnostic>> {
    let easts = candidates(table, roles, |role| matches!(role, Role::East { .. }));
    let norths = candidates(table, roles, |role| matches!(role, Role::North { .. }));
    let pair = [easts, norths];
    let heights = candidates(table, roles, |role| matches!(role, Role::Height { .. }));
    let map = [one_of(table, sampled, &pair[0], &pair, &heights)?, one_of(table, sampled, &pair[1], &pair, &heights)?];
    if map != [None, None] {
        return Ok(map);
    }
    let pairs = lettered(table, sampled, roles);
    match pairs[..] {
        [] => Ok(map),
        [[east, north]] => Ok([Some(east), Some(north)]),
        _ => {
            let [easts, norths] = [0, 1].map(|k| pairs.iter().map(|pair| pair[k]).collect::<Vec<_>>());
            let names = table.names(easts.iter().copied());
            let choices = choices(table, sampled, &easts, &norths, &heights);
            Err(table.header_refused(format!("several columns may be one coordinate: {names}; choose{choices}")))
        }
    }
}

/// Columns whose names are the letters of a map with the same words beside them: `MTM_E`, `MTM_N`; `GK_R`, `GK_H`.
fn lettered(table: &Table<'_>, sampled: &Sampled, roles: &[Role]) -> Vec<[usize; 2]> {
    let rest = |i: usize, letter: &str| beside_letter(table, i, letter).filter(|_| sampled.are_numbers(i));
    let unknown = |i: usize| roles[i] == Role::Unknown;
    // A radius and a height have the same letters: only the name of a system tells.
    let may_be_height = |i: usize| unknown(i) || matches!(roles[i], Role::Height { .. });
    let all = 0..table.header.len();
    let partner = |i: usize| {
        let of_map = |letter: &str, k: usize, own: &[String]| rest(k, letter).is_some_and(|other| other == own);
        let own = rest(i, "e").filter(|_| unknown(i));
        let by_directions = own.and_then(|own| all.clone().find(|k| unknown(*k) && of_map("n", *k, &own)));
        let own = || rest(i, "r").filter(|own| unknown(i) && own.iter().all(|word| is_of_system(word)));
        let by_values = || own().and_then(|own| all.clone().find(|k| may_be_height(*k) && of_map("h", *k, &own)));
        by_directions.or_else(by_values).map(|k| [i, k])
    };
    all.clone().filter_map(partner).collect()
}

/// True for the `H` of a Hochwert, `GK_H` beside `GK_R`: it is no height.
fn is_beside_rechtswert(table: &Table<'_>, sampled: &Sampled, column: usize) -> bool {
    let Some(own) = beside_letter(table, column, "h").filter(|own| own.iter().all(|word| is_of_system(word))) else {
        return false;
    };
    let is_partner =
        |i: usize| sampled.are_numbers(i) && beside_letter(table, i, "r").is_some_and(|words| words == own);
    (0..table.header.len()).any(is_partner)
}

/// The words of a name beside a letter at its beginning or end, if they may be those of a coordinate.
fn beside_letter(table: &Table<'_>, column: usize, letter: &str) -> Option<Vec<String>> {
    let no_coordinates = |word: &String| NO_COORDINATES.split_whitespace().any(|own| own == word);
    let (mut words, unit) = words_of(table.header[column].text);
    words.truncate(words.len() - usize::from(unit));
    let at = [0, words.len().checked_sub(1)?].into_iter().find(|at| words[*at] == letter)?;
    words.remove(at);
    (!words.is_empty() && !words.iter().any(no_coordinates)).then_some(words)
}

/// The columns of x and y, and z where there is one.
fn of_axes(
    table: &Table<'_>,
    sampled: &Sampled,
    roles: &[Role],
    all: &[usize],
    guess: bool,
) -> Result<Found, Box<Diagnostic>> {
    let (x, y, z) = (all[0], all[1], all.get(2).copied());
    // Who chooses by a command may want the height that is not read without one.
    let offered = height(table, sampled, roles, z).0;
    let swapped = || [y, x].into_iter().chain(offered);
    let as_they_stand = || [x, y].into_iter().chain(offered);
    // `X(N)`, `Y(E)`: the letter of the map counts.
    let is_of_map = |i: usize, letter: &str| words_of(table.header[i].text).0.iter().any(|word| word == letter);
    if is_of_map(x, "n") && is_of_map(y, "e") {
        let turned: Vec<usize> = [y, x].into_iter().chain(z).collect();
        let remark = taken_columns(table, &turned);
        return Ok((turned, Some(remark)));
    }
    let is_plain = is_of_map(x, "e") && is_of_map(y, "n");
    // As in Gauss-Krüger coordinates, where x is the northing.
    let is_of_grid = || northing_first(table, sampled, [x, y]) == Order::Certain;
    if y < x && !is_plain && (sampled.are_on_a_grid([x, y]) || is_of_grid()) {
        let by_figures = mirrored_by_figures(table, sampled, [x, y]);
        let [swapped, as_they_stand] = [numbers_of(swapped()), numbers_of(as_they_stand())];
        let which = match by_figures {
            Some(true) => format!(
                "`--columns {swapped}`, since x is the northing by its values; `--columns {as_they_stand}` if it is the easting nevertheless"
            ),
            Some(false) => format!(
                "`--columns {as_they_stand}`, since x is the easting by its values; `--columns {swapped}` if it is the northing nevertheless"
            ),
            None => {
                format!("`--columns {swapped}` if x is the northing, `--columns {as_they_stand}` if it is the easting")
            }
        };
        return Err(table.header_refused(format!(
            "y comes before x, and the coordinates are those of a map grid: in German and many other surveys x is the northing. Choose the easting first, the northing second: {which} (in a document `columns`)"
        )));
    }
    let turned = y + 1 == x && !is_plain && z.is_none_or(|z| z > x);
    if turned {
        let remark = format!(
            "{}; y comes before x: if x is the northing, as in Gauss-Krüger coordinates, the curve is mirrored, and `--columns {}` is right",
            taken_columns(table, all),
            numbers_of(swapped())
        );
        return Ok((all.to_vec(), Some(remark)));
    }
    let clear = |role: Role| role == Role::East { clear: true } || role == Role::North { clear: true };
    let both = roles.iter().filter(|role| clear(**role)).count() == 2;
    let remark = (guess || both).then(|| taken_columns(table, all));
    in_order(table, sampled, all.to_vec(), offered, remark)
}

/// The coordinates, x first, but where they are those of a map with the northing first by their figures. `offered` is a height that is not read and may be asked
/// for.
fn in_order(
    table: &Table<'_>,
    sampled: &Sampled,
    all: Vec<usize>,
    offered: Option<usize>,
    remark: Option<String>,
) -> Result<Found, Box<Diagnostic>> {
    let height = || all.get(2).copied().or(offered);
    let swapped = || numbers_of([all[1], all[0]].into_iter().chain(height()));
    match northing_first(table, sampled, [all[0], all[1]]) {
        Order::Certain => {
            let names = table.names([all[0], all[1]]);
            let columns = if table.header.is_empty() { "of the columns " } else { "of " };
            let message = format!(
                "{columns}{names}, the first is a northing of a map grid by its values, and the second an easting: as x and y they would mirror the curve. Choose the easting first: `--columns {}`; `--columns {}` takes them in this order (in a document `columns`)",
                swapped(),
                numbers_of([all[0], all[1]].into_iter().chain(height()))
            );
            Err(if table.header.is_empty() { table.refused(message) } else { table.header_refused(message) })
        }
        Order::Possible => {
            let before = remark.unwrap_or_else(|| taken_columns(table, &all));
            let remark = format!(
                "{before}; by its values the first may be a northing: then the curve is mirrored, and `--columns {}` is right",
                swapped()
            );
            Ok((all, Some(remark)))
        }
        Order::Plain if Degrees::of(table, sampled, [all[0], all[1]]) != Degrees::No => {
            let before = remark.unwrap_or_else(|| taken_columns(table, &all));
            Ok((all, Some(Degrees::remark(before))))
        }
        Order::Plain => Ok((all, remark)),
    }
}

/// The height beside an easting and a northing, with the sentence about one that may be that of something else. Of several the one over the sea counts.
fn height(table: &Table<'_>, sampled: &Sampled, roles: &[Role], z: Option<usize>) -> (Option<usize>, Option<String>) {
    if z.is_some() {
        return (z, None);
    }
    let clear = candidates(table, roles, |role| role == Role::Height { clear: true });
    let clear: Vec<usize> =
        clear.into_iter().filter(|i| !sampled.is_empty(*i) && !is_beside_rechtswert(table, sampled, *i)).collect();
    if let [only] = clear[..] {
        return (Some(only), None);
    }
    if !clear.is_empty() {
        let mut over_sea = clear.iter().filter(|i| !is_over_ellipsoid(&words_of(table.header[**i].text).0));
        return (over_sea.next().copied().filter(|_| over_sea.next().is_none()), None);
    }
    let unclear = candidates(table, roles, |role| role == Role::Height { clear: false });
    let unclear: Vec<usize> = unclear.into_iter().filter(|i| sampled.is_of_numbers(*i)).collect();
    let [only] = unclear[..] else { return (None, None) };
    let remark = format!("`{}` is taken as z, the height of each point; `columns` chooses others", table.names([only]));
    (Some(only), Some(remark))
}

/// The only numbers there are, if nothing says that they are something else, or the partner of one is missing.
fn only_numbers(
    table: &Table<'_>,
    sampled: &Sampled,
    roles: &[Role],
    free: &[usize],
) -> Result<Found, Box<Diagnostic>> {
    let numeric = |i: &usize| table.first.get(*i).is_some_and(is_number);
    let possible = |i: &usize| !matches!(roles[*i], Role::Label | Role::Other);
    let is_height = |i: &usize| matches!(roles[*i], Role::Height { .. });
    let numbers: Vec<usize> = free.iter().copied().filter(numeric).filter(possible).collect();
    let heights = numbers.iter().filter(|i| is_height(i)).count();
    let mirrored = || {
        let in_order = matches!(numbers[..], [x, y, ..] if mirrored_by_words(table, [x, y]) == Some(false));
        !in_order && numbers.iter().any(|i| has_direction(table, *i))
    };
    let partner_missing = heights > 1 || numbers.iter().any(|i| roles[*i].is_of_a_pair()) || mirrored();
    if (2..=3).contains(&numbers.len()) && !partner_missing && !sampled.numbers_points(&numbers) {
        let remark = taken_columns(table, &numbers);
        return in_order(table, sampled, numbers, None, Some(remark));
    }
    let names = table.names(0..table.header.len());
    let all: Vec<usize> = free.iter().copied().filter(numeric).collect();
    let which = match numbers.len() {
        // A profile, of stations and heights, is a curve too.
        0 | 1 if all.len() == 2 => in_right_order(table, sampled, &all),
        0 | 1 => Vec::new(),
        _ => proposed(table, sampled, &sampled.without_numbers(&numbers)),
    };
    let way = match which.len() {
        0 | 1 => "by their names or numbers (`--columns`, in a document `columns`)".to_owned(),
        _ => format!("x first (`--columns {}`, in a document `columns`)", example(table, &which)),
    };
    Err(table.header_refused(format!(
        "no column is named x or y; the columns are {names}: choose two or three of them, {way}"
    )))
}

/// The columns of a file without names.
fn found_without_names(
    table: &Table<'_>,
    sampled: &Sampled,
    numbers: &[usize],
    free: impl Iterator<Item = usize>,
) -> Result<Found, Box<Diagnostic>> {
    if table.first.first().is_some_and(|field| is_sentence(field.text)) {
        return Err(table.refused(
            "these are sentences of a GPS receiver (NMEA), with latitudes and longitudes: convert them to a table of coordinates in a plane first",
        ));
    }
    let numbers_points = sampled.numbers_points(numbers);
    if numbers.len() > 2 && (numbers_points || sampled.may_be_times(numbers)) {
        let stand = sampled.without_numbers(numbers);
        let others = in_right_order(table, sampled, &stand);
        let both = if others == stand && others.len() > 1 {
            format!(
                "; in the order number, northing, easting `--columns {}`",
                numbers_of([others[1], others[0]].into_iter().chain(others.get(2).copied()))
            )
        } else {
            String::new()
        };
        return Err(table.refused(format!(
            "column {} seems to hold {}, and the file has no header line: choose the coordinates, x first \
             (`--columns {}`, in a document `columns`){both}; if it is x, `--columns {}`",
            numbers[0] + 1,
            if numbers_points { "point numbers" } else { "times or stations" },
            example(table, &others),
            numbers_of(numbers.iter().copied().take(3)),
        )));
    }
    let (all, remark) = match numbers.len() {
        2 | 3 if numbers.len() == table.width => (numbers.to_vec(), None),
        0 | 1 => return Ok((free.take(2).collect(), None)),
        2 | 3 => (numbers.to_vec(), Some(taken_columns(table, numbers))),
        _ => {
            let taken = taken_columns(table, &numbers[..2]);
            let space = numbers_of(numbers[..3].iter().copied());
            (numbers[..2].to_vec(), Some(format!("{taken}, and `--columns {space}` takes the third as z")))
        }
    };
    in_order(table, sampled, all, None, remark)
}

/// `$GPGGA` and the like.
fn is_sentence(text: &str) -> bool {
    text.strip_prefix('$').is_some_and(|rest| rest.len() == 5 && rest.bytes().all(|byte| byte.is_ascii_uppercase()))
}

/// Two or three columns of those that may be meant, as `--columns` takes them: of more than three the first two, with the height. Without names
/// that is the third, since codes come after it.
fn example(table: &Table<'_>, columns: &[usize]) -> String {
    let (plan, rest) = columns.split_at(columns.len().min(2));
    let is_height = |i: &&usize| {
        let own = table.header.get(**i).map(Role::of);
        own.is_none_or(|role| rest.len() == 1 || matches!(role, Role::Height { .. }))
    };
    numbers_of(plan.iter().chain(rest.iter().find(is_height)).copied())
}

/// The columns that may be meant, each x with its y and z, as a message offers them.
fn choices(table: &Table<'_>, sampled: &Sampled, x: &[usize], y: &[usize], z: &[usize]) -> String {
    let count = x.len().max(y.len());
    let of = |list: &[usize], k: usize| list.get(k).or(list.first()).copied();
    let choice = |k: usize| {
        let height = if z.len() == count || z.len() == 1 { of(z, k) } else { None };
        let pair = in_right_order(table, sampled, &[of(x, k)?, of(y, k)?]);
        Some(format!("`--columns {}`", numbers_of(pair.into_iter().chain(height))))
    };
    match (0..count).take(OFFERED).map(choice).collect::<Option<Vec<_>>>() {
        Some(choices) if !choices.is_empty() => format!(": {} (in a document `columns`)", choices.join(" or ")),
        _ => " by names or numbers (`--columns`, in a document `columns`)".to_owned(),
    }
}

/// The columns of a role: those named by words before letters that may mean something else.
fn candidates(table: &Table<'_>, roles: &[Role], fits: impl Fn(Role) -> bool) -> Vec<usize> {
    let all: Vec<usize> = (0..roles.len()).filter(|i| fits(roles[*i])).collect();
    let letter = |i: &usize| words_of(table.header[*i].text).0.first().is_some_and(|word| word.len() == 1);
    let clear: Vec<usize> = all.iter().copied().filter(|i| !letter(i)).collect();
    if clear.is_empty() { all } else { clear }
}

/// The only candidate; two are refused, with what there is to choose from.
fn one_of(
    table: &Table<'_>,
    sampled: &Sampled,
    columns: &[usize],
    pair: &[Vec<usize>; 2],
    heights: &[usize],
) -> Result<Option<usize>, Box<Diagnostic>> {
    match columns {
        [] => Ok(None),
        [only] => Ok(Some(*only)),
        several => {
            let names = table.names(several.iter().copied());
            let choices = choices(table, sampled, &pair[0], &pair[1], heights);
            Err(table.header_refused(format!("several columns may be one coordinate: {names}; choose{choices}")))
        }
    }
}

/// The only columns whose names are these letters, if both have numbers.
fn letters(table: &Table<'_>, sampled: &Sampled, pair: &[&str; 2]) -> Option<[usize; 2]> {
    let [east, north] = pair.map(|letter| letter_column(table, letter).filter(|i| sampled.are_numbers(*i)));
    Some([east?, north?])
}

/// The only column whose name is this letter.
fn letter_column(table: &Table<'_>, letter: &str) -> Option<usize> {
    let mut all = (0..table.header.len()).filter(|i| is_letter(letter, &table.header[*i]));
    all.next().filter(|_| all.next().is_none())
}

fn taken_columns(table: &Table<'_>, columns: &[usize]) -> String {
    let names = table.names(columns.iter().copied());
    let all = if table.header.is_empty() {
        format!(" of {} (the file has no header line)", table.width)
    } else {
        String::new()
    };
    format!("the columns {names}{all} are taken as coordinates; `columns` chooses others")
}

/// The columns of an axis, of the best kind there is: `x` before `x_m` before `x_left` before `point_x`.
fn axis(table: &Table<'_>, roles: &[Role], letter: &str) -> Vec<usize> {
    // `Z (Kote)` is both.
    let fits = |role: Role| role == Role::Axis || letter == "z" && matches!(role, Role::Height { .. });
    let all = table.header.iter().enumerate().filter(|(i, _)| fits(roles[*i]));
    let kinds: Vec<(usize, usize)> = all.filter_map(|(i, f)| axis_kind(letter, f).map(|kind| (kind, i))).collect();
    let best = kinds.iter().map(|(kind, _)| *kind).min();
    kinds.iter().filter(|(kind, _)| Some(*kind) == best).map(|(_, i)| *i).collect()
}

#[cfg(test)]
mod tests;
