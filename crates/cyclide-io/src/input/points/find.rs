//! The coordinates of a table whose columns nobody chose: by their names, else the only numbers.

use super::decimals::is_number;
use super::height_words::is_over_ellipsoid;
use super::names::{GLOBE, Role, axis_kind, is_letter, speaks_of, words_of};
use super::northing::{Order, northing_first};
use super::sampled::Sampled;
use super::table::Table;
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
    let globe = on_the_globe(table);
    for i in globe.into_iter().flatten() {
        roles[i] = Role::Other;
    }
    if let Some(found) = by_names(table, sampled, &roles)? {
        return Ok(found);
    }
    if let Some(globe) = globe {
        return Err(refused_on_the_globe(table, globe));
    }
    only_numbers(table, sampled, &roles, &free().collect::<Vec<_>>())
}

/// The columns of longitudes and latitudes.
pub(super) fn on_the_globe(table: &Table<'_>) -> Option<[usize; 2]> {
    match GLOBE.map(|words| table.header.iter().position(|f| speaks_of(words, f))) {
        [Some(lon), Some(lat)] => Some([lon, lat]),
        _ => None,
    }
}

/// The refusal of angles on the globe, with the remedy.
pub(super) fn refused_on_the_globe(table: &Table<'_>, globe: [usize; 2]) -> Box<Diagnostic> {
    let message = format!(
        "{} are angles on the globe: project them to a plane grid first (UTM or the national one; GIS programs and \
         `cs2cs` do it), and name the columns x_m, y_m",
        table.names(globe)
    );
    table.header_refused(message)
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
            let choices = choices(&xs, &ys, &zs);
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
        let (height, remark) = height(table, sampled, roles, z);
        let height = height.or_else(|| letter_column(table, "u").filter(|i| sampled.is_of_numbers(*i)));
        let all: Vec<usize> = [x, y].into_iter().chain(height.filter(|z| *z != y)).collect();
        let is_letter = |i: &usize| words_of(table.header[*i].text).0[0].len() == 1 && roles[*i] != Role::Axis;
        let chosen = all.iter().any(is_letter) || [x, y].iter().any(|i| !of_words(roles[*i]));
        let remark = if chosen { Some(taken_columns(table, &all)) } else { remark };
        return Ok(Some((all, remark)));
    }
    let pair = [Role::Abscissa, Role::Ordinate].map(|role| candidates(table, roles, |own| own == role));
    let [x, y] = [one_of(table, &pair[0], &pair, &[])?, one_of(table, &pair[1], &pair, &[])?];
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
    let map = [one_of(table, &pair[0], &pair, &heights)?, one_of(table, &pair[1], &pair, &heights)?];
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
            let choices = choices(&easts, &norths, &heights);
            Err(table.header_refused(format!("several columns may be one coordinate: {names}; choose{choices}")))
        }
    }
}

/// Columns whose names are the letters of a map with the same words beside them: `MTM_E`, `MTM_N`.
fn lettered(table: &Table<'_>, sampled: &Sampled, roles: &[Role]) -> Vec<[usize; 2]> {
    let no_coordinates = |word: &String| NO_COORDINATES.split_whitespace().any(|own| own == word);
    let rest = |i: usize, letter: &str| -> Option<Vec<String>> {
        let (mut words, unit) = words_of(table.header[i].text);
        words.truncate(words.len() - usize::from(unit));
        let at = [0, words.len().checked_sub(1)?].into_iter().find(|at| words[*at] == letter)?;
        words.remove(at);
        let fits = roles[i] == Role::Unknown && sampled.are_numbers(i) && !words.is_empty();
        (fits && !words.iter().any(no_coordinates)).then_some(words)
    };
    let all = 0..table.header.len();
    let partner = |i: usize| {
        let own = rest(i, "e")?;
        all.clone().find(|k| rest(*k, "n").is_some_and(|other| other == own)).map(|k| [i, k])
    };
    all.clone().filter_map(partner).collect()
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
    // As in Gauss-Krüger coordinates, where x is the northing.
    let turned = y + 1 == x && z.is_none_or(|z| z > x);
    if turned && sampled.are_on_a_grid([x, y]) {
        return Err(table.header_refused(format!(
            "y stands before x, and the coordinates are those of a map grid: in German and many other surveys x is the northing. \
             Choose the easting first, the northing second: `--columns {}` if x is the northing, `--columns {}` if it is the easting (in a \
             document `columns`)",
            numbers_of(swapped()),
            numbers_of(as_they_stand())
        )));
    }
    if turned {
        let remark = format!(
            "{}; y stands before x: if x is the northing, as in Gauss-Krüger coordinates, the curve is mirrored, and `--columns {}` is right",
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
                "{columns}{names}, the first is a northing of a map grid by its figures, and the second an easting: taken as x and y the curve would \
                 be mirrored. Choose the easting first: `--columns {}`; `--columns {}` takes them as they stand (in a document `columns`)",
                swapped(),
                numbers_of([all[0], all[1]].into_iter().chain(height()))
            );
            Err(if table.header.is_empty() { table.refused(message) } else { table.header_refused(message) })
        }
        Order::Possible => {
            let before = remark.unwrap_or_else(|| taken_columns(table, &all));
            let remark = format!(
                "{before}; by its figures the first may be a northing: then the curve is mirrored, and `--columns {}` is right",
                swapped()
            );
            Ok((all, Some(remark)))
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
    let clear: Vec<usize> = clear.into_iter().filter(|i| !sampled.is_empty(*i)).collect();
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
    let partner_missing = heights > 1 || numbers.iter().any(|i| roles[*i].is_of_a_pair());
    if (2..=3).contains(&numbers.len()) && !partner_missing && !sampled.numbers_points(&numbers) {
        let remark = taken_columns(table, &numbers);
        return in_order(table, sampled, numbers, None, Some(remark));
    }
    let names = table.names(0..table.header.len());
    let all: Vec<usize> = free.iter().copied().filter(numeric).collect();
    let which = match numbers.len() {
        // A profile, of stations and heights, is a curve too.
        0 | 1 if all.len() == 2 => all,
        0 | 1 => Vec::new(),
        _ => sampled.without_numbers(&numbers),
    };
    let way = match which.len() {
        0 | 1 => "by their names or numbers (`--columns`, in a document `columns`)".to_owned(),
        _ => format!("x first (`--columns {}`, in a document `columns`)", example(&which)),
    };
    Err(table.header_refused(format!("no column is named x or y; there are {names}: name two or three of them, {way}")))
}

/// The columns of a file without names.
fn found_without_names(
    table: &Table<'_>,
    sampled: &Sampled,
    numbers: &[usize],
    free: impl Iterator<Item = usize>,
) -> Result<Found, Box<Diagnostic>> {
    if numbers.len() > 2 && sampled.numbers_points(numbers) {
        let others = sampled.without_numbers(numbers);
        let both = if others.len() > 1 {
            format!(
                "; in the order number, northing, easting `--columns {}`",
                numbers_of([others[1], others[0]].into_iter().chain(others.get(2).copied()))
            )
        } else {
            String::new()
        };
        return Err(table.refused(format!(
            "column {} seems to number the points, and the file has no header line to say so: choose the coordinates, x first \
             (`--columns {}`, in a document `columns`){both}; if it is x, `--columns {}`",
            numbers[0] + 1,
            example(&others),
            numbers_of(numbers.iter().copied().take(3)),
        )));
    }
    let (all, remark) = match numbers.len() {
        2 | 3 if numbers.len() == table.width => (numbers.to_vec(), None),
        0 | 1 => return Ok((free.take(2).collect(), None)),
        2 | 3 => (numbers.to_vec(), Some(taken_columns(table, numbers))),
        _ => (numbers[..2].to_vec(), Some(taken_columns(table, &numbers[..2]))),
    };
    in_order(table, sampled, all, None, remark)
}

/// Numbers of columns, from 1, as `--columns` takes them.
pub(super) fn numbers_of(columns: impl IntoIterator<Item = usize>) -> String {
    columns.into_iter().map(|i| (i + 1).to_string()).collect::<Vec<_>>().join(",")
}

/// Two or three columns of those that may be meant, as `--columns` takes them.
fn example(columns: &[usize]) -> String {
    let count = if columns.len() > 3 { 2 } else { columns.len() };
    numbers_of(columns[..count].iter().copied())
}

/// The columns that may be meant, each x with its y and z, as a message offers them.
fn choices(x: &[usize], y: &[usize], z: &[usize]) -> String {
    let count = x.len().max(y.len());
    let of = |list: &[usize], k: usize| list.get(k).or(list.first()).copied();
    let choice = |k: usize| {
        let height = if z.len() == count || z.len() == 1 { of(z, k) } else { None };
        Some(format!("`--columns {}`", numbers_of([of(x, k)?, of(y, k)?].into_iter().chain(height))))
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
    columns: &[usize],
    pair: &[Vec<usize>; 2],
    heights: &[usize],
) -> Result<Option<usize>, Box<Diagnostic>> {
    match columns {
        [] => Ok(None),
        [only] => Ok(Some(*only)),
        several => {
            let names = table.names(several.iter().copied());
            let choices = choices(&pair[0], &pair[1], heights);
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
mod tests {
    use super::super::{PointColumns, PointTable, read_points};

    fn read(text: &str) -> Result<PointTable, String> {
        read_points("p.csv", text.as_bytes(), &PointColumns::default()).map_err(|d| d.message)
    }

    fn first(table: &PointTable) -> [f64; 3] {
        table.contours[0].points[0].to_array()
    }

    fn remark(table: &PointTable, reason: &str) -> String {
        table.remarks.iter().find(|r| r.reason == reason).map(|r| r.message.clone()).unwrap_or_default()
    }

    /// The columns of each command that a message offers.
    fn offered(message: &str) -> Vec<Vec<String>> {
        let column = |rest: &str| rest.split('`').next().unwrap_or_default().split(',').map(str::to_owned).collect();
        message.split("--columns ").skip(1).map(column).collect()
    }

    #[test]
    fn one_height_is_read_and_of_several_none_is_lost_in_silence() {
        for name in [
            "Ell.Höhe",
            "Geländehöhe",
            "NHN",
            "DHHN2016",
            "Orthometric",
            "Kote",
            "Rzędna",
            "Wysokość",
            "GOK",
            "Hell",
            "Höhe H",
        ] {
            let table = read(&format!("Nr;East [m];North [m];{name}\n1;10;20;3\n2;11;21;3.5\n")).unwrap();
            assert_eq!((first(&table), &table.remarks[..]), ([10.0, 20.0, 3.0], &[][..]), "{name}");
        }
        // The letter of local systems, and heights that may be those of something else, are said.
        for header in ["Nr;E;N;U", "Nr;Easting;Northing;Deckenhöhe", "Nr;Easting;Northing;Soll Höhe"] {
            let table = read(&format!("{header}\n1;10;20;3\n2;11;21;3.5\n")).unwrap();
            assert_eq!(
                (first(&table), remark(&table, "columns-taken").is_empty()),
                ([10.0, 20.0, 3.0], false),
                "{header}"
            );
        }
        // Of two the one over the sea; of two alike none, and both are offered.
        let sea = read(
            "Pt,Northing,Easting,WGS84 Ellipsoidal Height (m),Elevation (m)\n1,20,10,59.7,12.5\n2,21,11,59.9,12.7\n",
        )
        .unwrap();
        assert_eq!(first(&sea).to_vec(), [10.0, 20.0, 12.5]);
        assert_eq!(offered(&remark(&sea, "columns-not-read")), [["3", "2", "4"]]);
        let two = read("Pt,Easting,Northing,Elevation,Altitude\n1,10,20,59.7,12.5\n2,11,21,59.9,12.7\n").unwrap();
        assert_eq!(first(&two).to_vec(), [10.0, 20.0, 0.0]);
        assert_eq!(offered(&remark(&two, "columns-not-read")), [["2", "3", "4"], ["2", "3", "5"]]);
        // Nothing stands in the column.
        assert_eq!(read("Nr;E [m];N [m];Höhe\n1;10;20;\n2;11;21;\n").unwrap().remarks.len(), 1);
    }

    #[test]
    fn numbers_that_may_be_of_the_shape_are_named_and_others_are_not() {
        for (header, row, named) in [
            ("x,y,Radius [m]", ["0,0,", "5,0,50"], Some("Radius [m]")),
            ("x,y,thickness", ["0,0,1.5", "5,0,2.5"], Some("thickness")),
            ("x,y,foo [mm]", ["0,0,1.5", "5,0,1.5"], Some("foo [mm]")),
            ("x,y,foo", ["0,0,0", "5,0,0"], None),
            ("Point ID,x,y,code,time", ["1,0,0,A,1.5", "2,5,0,B,2.5"], None),
            ("x,y,sx,sy,hdop,Height SD", ["0,0,1,1,1,1", "5,0,2,1,2,1"], None),
            ("x,y,w_right_m", ["0,0,5", "5,0,5"], None),
            ("x,y,w_tr_right_m,w_tr_left_m", ["0,0,7.5,7.3", "5,0,7.4,7.2"], None),
            ("x,y,z,tangent_x,curvature", ["0,0,1,1,0.1", "5,0,1,0.9,0.2"], None),
            ("x,y,remark", ["0,0,a", "5,0,b"], None),
        ] {
            let table = read(&format!("{header}\n{}\n{}\n", row[0], row[1])).unwrap();
            let message = remark(&table, "columns-not-read");
            assert_eq!(
                message.strip_prefix("not read: ").and_then(|m| m.split(';').next()),
                named,
                "{header}: {message}"
            );
        }
        // An arc is refused, and its chord has to be asked for.
        let bulges = "x,y,bulge\n0,0,0\n100,0,0.41421356\n120,20,0\n";
        let refused = read_points("p.csv", bulges.as_bytes(), &PointColumns::default()).unwrap_err().to_string();
        assert!(refused.starts_with("p.csv:3:7: an arc with the bulge 0.41421356"), "{refused}");
        let columns = PointColumns { coordinates: Some(offered(&refused).remove(0)), ..PointColumns::default() };
        assert_eq!(read_points("p.csv", bulges.as_bytes(), &columns).unwrap().contours[0].points.len(), 3);
        assert!(read("x,y,bulge\n0,0,0\n100,0,0\n").is_ok());
    }

    #[test]
    fn a_northing_that_stands_first_is_refused_with_both_commands() {
        for (text, commands) in [
            ("5432000 456000 412\n5432010 456020 413\n", [["2", "1", "3"], ["1", "2", "3"]]),
            ("Nr;X;Y\n1;5432000,5;456000,5\n2;5432010,5;456020,5\n", [["3", "2", ""], ["2", "3", ""]]),
            (
                "Nr;X;Y;Z\n1;5.432.000,5;3.456.000,5;9\n2;5.432.010,5;3.456.020,5;9\n",
                [["3", "2", "4"], ["2", "3", "4"]],
            ),
            ("a;b\n5432000,5;32456000,5\n5432010,5;32456020,5\n", [["2", "1", ""], ["1", "2", ""]]),
        ] {
            let commands = commands.map(|command| command.into_iter().filter(|c| !c.is_empty()).collect::<Vec<_>>());
            let refused = read(text).unwrap_err();
            assert_eq!(offered(&refused), commands, "{text}: {refused}");
            let coordinates = Some(offered(&refused).remove(0));
            let columns = PointColumns { coordinates, ..PointColumns::default() };
            let table = read_points("p.csv", text.as_bytes(), &columns).unwrap();
            assert!(first(&table)[1] > 5.4e6 && first(&table)[1] < 5.5e6, "{text}");
        }
        // Names say more than figures, and an easting that stands first is right.
        let named = read("N_UTM,E_UTM\n5432000,456000\n5432010,456020\n").unwrap();
        assert_eq!(first(&named).to_vec(), [456_000.0, 5_432_000.0, 0.0]);
        for text in ["456000 5432000 412\n456020 5432010 413\n", "X;Y\n3456000;5432000\n3456020;5432010\n"] {
            assert!(read(text).is_ok(), "{text}");
        }
    }

    #[test]
    fn letters_of_the_map_beside_the_name_of_a_system_are_known() {
        for header in ["MTM_N;MTM_E", "N MTM9;E MTM9", "N_LV95;E_LV95", "Northing;Easting", "P;M"] {
            let table = read(&format!("Nr.;{header};H\n1;900.5;545.5;100\n2;906.5;543.5;101\n")).unwrap();
            assert_eq!(first(&table).to_vec(), [545.5, 900.5, 100.0], "{header}");
        }
        // Accuracies and differences are no coordinates.
        let table = read("Point,Easting,Northing,Delta E,Delta N\n1,10,20,0.1,0.2\n2,11,21,0.2,0.1\n").unwrap();
        assert_eq!(first(&table).to_vec(), [10.0, 20.0, 0.0]);
    }

    #[test]
    fn what_a_refusal_offers_can_be_typed() {
        for text in [
            "Pt,Local E,Local N,Local H,Grid E,Grid N,Grid H\n1,6.5,2,3,16.5,12,3\n2,7.5,2,3,17.5,12,3\n",
            "Pt,Design E,Design N,Measured E,Measured N\n1,6.5,2,16.5,12\n2,7.5,2,17.5,12\n",
            "x_left,y_left,x_right,y_right\n1,2,3,4\n2,2,3,4\n",
            "x,x,y\n1,2,3\n2,3,4\n",
            "a,b,c,d\n1,2,3,4\n",
        ] {
            let refused = read(text).unwrap_err();
            let commands = offered(&refused);
            assert!(!commands.is_empty(), "{refused}");
            for coordinates in commands {
                let columns = PointColumns { coordinates: Some(coordinates), ..PointColumns::default() };
                assert!(read_points("p.csv", text.as_bytes(), &columns).is_ok(), "{text}: {columns:?}");
            }
        }
        let local = read("Pt,Local E,Local N,Local H,Grid E,Grid N,Grid H\n1,6.5,2,3,16.5,12,3\n").unwrap_err();
        assert_eq!(offered(&local), [["2", "3", "4"], ["5", "6", "7"]]);
        // No height is there: the points are asked for in the plane.
        let text = "Nr;Rechtswert;Hochwert;Höhe\n1;1,5;2,5;3\n2;3,5;4;\n";
        assert_eq!(offered(&read(text).unwrap_err()), [["2", "3"]]);
    }

    #[test]
    fn coordinates_beside_angles_on_the_globe_are_read() {
        for (text, expected) in [
            (
                "Point ID,Northing,Easting,Elevation,Latitude,Longitude\n1,20,10,5,49.1,8.1\n2,21,11,5,49.2,8.2\n",
                [10.0, 20.0, 5.0],
            ),
            ("id,lat,lon,x,y\n0,48.1,11.5,45.5,7\n1,48.1,11.5,43.5,8\n", [45.5, 7.0, 0.0]),
        ] {
            let table = read(text).unwrap();
            assert_eq!((first(&table), &table.remarks[..]), (expected, &[][..]), "{text}");
            assert!(
                table.notes.iter().any(|note| note.ends_with("are angles on the globe, and not read")),
                "{:?}",
                table.notes
            );
        }
        assert!(read("name,Latitude,Longitude\nA,50.2,7.1\n").unwrap_err().contains("angles on the globe"));
    }

    #[test]
    fn codes_whose_points_are_far_apart_are_named() {
        let table = |gap: f64| {
            let row = |code: &str, from: f64| {
                (0..4).map(|k| format!("{},{},{code}\n", from + f64::from(k), 2 * k)).collect::<String>()
            };
            format!("E_m,N_m,Code\n{}{}", row("KL", 0.0), row("KR", gap))
        };
        let far = remark(&read(&table(300.0)).unwrap(), "columns-not-read");
        assert!(far.starts_with("not read: Code;") && far.contains("--contour-column \"Code\""), "{far}");
        assert_eq!(remark(&read(&table(4.0)).unwrap(), "columns-not-read"), "");
    }
}
