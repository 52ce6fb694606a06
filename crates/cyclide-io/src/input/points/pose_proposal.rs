//! What a refusal proposes for the columns of a table of poses: the words that make them poses, `?` where nobody can tell.

use std::fmt;

use super::civil_time::CivilTime;
use super::fields::Field;
use super::globe::GLOBE;
use super::names::{Role, speaks_of, words_of};
use super::pose_clocks::speaks_of_clocks;
use super::pose_names::{ANGLES, Meaning, POSITION, QUATERNION, TimeUnit, meaning as own_meaning};
use super::table::Table;
use crate::text::place::quoted;

/// A column that is left out, and one whose meaning is unknown.
const ASIDE: &str = "-";
const UNTOLD: &str = "?";

/// A coordinate of a quaternion as large is its w, where the others may be any: the body is turned by less than 40 degrees.
const NEAR_ONE: f64 = 0.94;

/// Words of depths, which are heights of the other sign: nobody may leave such a column out unasked.
const DEPTHS: [&str; 7] = ["d", "u", "down", "depth", "tiefe", "profondeur", "profundidad"];

/// What the columns are, as a document says it.
pub(super) struct Proposal {
    words: Vec<String>,
    /// True if a column may be the time since it rises.
    rises: bool,
}

impl Proposal {
    pub(super) fn new(table: &Table<'_>, meanings: &[Option<Meaning>]) -> Self {
        let mut words: Vec<Option<String>> =
            table.header.iter().zip(meanings).map(|(field, meaning)| meaning.map(|own| known(field, own))).collect();
        let turned = |m: &Option<Meaning>| {
            matches!(
                m,
                Some(Meaning::Quaternion(_) | Meaning::Angle(..) | Meaning::Vector(..) | Meaning::Matrix(0..=2, 0..=2))
            )
        };
        let mut rotation = meanings.iter().any(turned);
        for column in euler_angles(table) {
            words[column] = Some(UNTOLD.to_owned());
            rotation = true;
        }
        for guess in [quaternion, named_vector, robot_angles, copied_names] {
            if let Some(found) = guess(table, meanings).filter(|_| !rotation) {
                rotation = true;
                found.into_iter().for_each(|(column, word)| words[column] = Some(word.to_owned()));
            }
        }
        for (column, word) in map_letters(table, meanings) {
            words[column].get_or_insert(word);
        }
        let timed = meanings.iter().any(|m| matches!(m, Some(Meaning::Time(_))));
        let high = meanings.iter().any(|m| matches!(m, Some(Meaning::Position(2) | Meaning::Matrix(2, 3))))
            || words.iter().flatten().any(|word| word.starts_with(POSITION[2]));
        let clocks = if timed { Vec::new() } else { rising(table) };
        let mut rises = false;
        let mut rest = |i: usize| {
            let number = table.first.get(i).is_some_and(|field| number(field).is_some());
            let name = table.header[i].text;
            let is_time = speaks_of_clocks(name);
            let may_rise = clocks.contains(&i) && !is_no_time(&table.header[i]);
            rises |= may_rise || is_time && !timed;
            let aside = match is_time {
                true => timed,
                false => (rotation || !number) && !may_rise && (high || !may_be_height(&table.header[i])),
            };
            if aside { ASIDE } else { UNTOLD }
        };
        let words = words.into_iter().enumerate().map(|(i, word)| word.unwrap_or_else(|| rest(i).to_owned())).collect();
        Self { words, rises }
    }

    /// The table if somebody types the columns, where nothing in them is left open.
    pub(super) fn typed<'a>(&'a self, table: &Table<'a>) -> Option<Table<'a>> {
        let same = || self.words.iter().zip(&table.header).all(|(word, field)| word == field.text);
        if self.words.iter().any(|word| word == UNTOLD) || same() {
            return None;
        }
        let mut typed = table.clone();
        typed.header = self.words.iter().zip(&table.header).map(|(text, f)| Field { text, start: f.start }).collect();
        Some(typed)
    }
}

impl fmt::Display for Proposal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = self.words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
        write!(f, "`\"columns\": [{list}]`")?;
        if self.words.iter().any(|word| word == UNTOLD) {
            write!(f, ", with the right word for each `?`")?;
        }
        if self.rises {
            write!(f, " (`t` for the time)")?;
        }
        Ok(())
    }
}

/// The name of a column that is known; in our own words where it cannot be typed as it is shown.
fn known(field: &Field<'_>, meaning: Meaning) -> String {
    let degrees = |unit: f64| if unit < 1.0 { "_deg" } else { "" };
    let own = match meaning {
        Meaning::Label => return ASIDE.to_owned(),
        Meaning::Matrix(row, column) => format!("m{}{}", row + 1, column + 1),
        Meaning::Time(TimeUnit::Unsaid) => "t".to_owned(),
        Meaning::Time(TimeUnit::PerSecond(count)) => {
            let units: [(&str, f64); 4] = [("s", 1.0), ("ms", 1e3), ("us", 1e6), ("ns", 1e9)];
            format!("t_{}", units.iter().find(|(_, own)| own.total_cmp(&count).is_eq()).map_or("min", |(unit, _)| unit))
        }
        Meaning::Position(axis) => POSITION[axis].to_owned(),
        Meaning::Quaternion(coordinate) => QUATERNION[coordinate].to_owned(),
        Meaning::Angle(angle, unit) => format!("{}{}", ANGLES[angle], degrees(unit)),
        Meaning::Vector(axis, unit) => format!("rotvec_{}{}", POSITION[axis], degrees(unit)),
    };
    let shown = quoted(field.text);
    // Entries that count from 0, or have another letter, are such only beside each other.
    let alone = !matches!(meaning, Meaning::Matrix(..)) || own_meaning(field) == Some(meaning);
    let typed = alone && shown == field.text && !shown.contains(|c: char| matches!(c, '"' | '\\') || c.is_control());
    if typed { shown.into_owned() } else { own }
}

/// True for a name that says something else than the time.
fn is_no_time(field: &Field<'_>) -> bool {
    !matches!(Role::of(field), Role::Unknown | Role::Other | Role::Label)
        || GLOBE.iter().any(|words| speaks_of(words, field))
}

/// True for a name of what may be the height of the place.
fn may_be_height(field: &Field<'_>) -> bool {
    let depth = || words_of(field.text).0.first().is_some_and(|word| DEPTHS.contains(&word.as_str()));
    matches!(Role::of(field), Role::Height { .. }) || depth()
}

/// The columns that rise from each line to the next as times do, and do not count the lines from 0 or 1; dates are such too.
fn rising(table: &Table<'_>) -> Vec<usize> {
    let mut last: Vec<Option<f64>> = table.first.iter().map(value).collect();
    let mut rises = vec![true; last.len()];
    let mut counts: Vec<bool> = last.iter().map(|value| matches!(value, Some(0.0 | 1.0))).collect();
    let mut lines = 0_usize;
    table.for_first_rows(|fields| {
        for (i, field) in fields.iter().take(last.len()).enumerate().filter(|_| lines > 0) {
            let (before, now) = (last[i], value(field));
            rises[i] &= before.zip(now).is_some_and(|(before, now)| now > before);
            counts[i] &= before.zip(now).is_some_and(|(before, now)| now.total_cmp(&(before + 1.0)).is_eq());
            last[i] = now;
        }
        lines += 1;
        true
    });
    (0..rises.len()).filter(|i| lines > 1 && rises[*i] && !counts[*i]).collect()
}

/// The number of a field, or the seconds of a date or of a time of the day.
fn value(field: &Field<'_>) -> Option<f64> {
    number(field).or_else(|| Some(CivilTime::parse(field.text)?.nanoseconds as f64))
}

/// Letters of maps beside each other, `E, N, H`: their words are those of coordinates, with their units.
fn map_letters(table: &Table<'_>, meanings: &[Option<Meaning>]) -> Vec<(usize, String)> {
    let only = |fits: fn(Role) -> bool| {
        let mut all = (0..table.header.len()).filter(|i| meanings[*i].is_none() && fits(Role::of(&table.header[*i])));
        all.next().filter(|_| all.next().is_none())
    };
    let placed = meanings.iter().any(|m| matches!(m, Some(Meaning::Position(_) | Meaning::Matrix(0..=2, 3))));
    let pair = [only(|role| matches!(role, Role::East { .. })), only(|role| matches!(role, Role::North { .. }))];
    let ([Some(east), Some(north)], false) = (pair, placed) else { return Vec::new() };
    let word = |column: usize, axis: usize| {
        let unit = words_of(table.header[column].text);
        let unit = unit.0.last().filter(|_| unit.1).map(|unit| format!("_{unit}")).unwrap_or_default();
        (column, format!("{}{unit}", POSITION[axis]))
    };
    let height = only(|role| matches!(role, Role::Height { .. }));
    [Some(word(east, 0)), Some(word(north, 1)), height.map(|column| word(column, 2))].into_iter().flatten().collect()
}

/// The number of a field of the first line.
fn number(field: &Field<'_>) -> Option<f64> {
    field.text.replace(',', ".").parse().ok()
}

/// The column whose only word, or whose words without what stands between them, are these; else the only one whose path ends so.
fn column(table: &Table<'_>, name: &str) -> Option<usize> {
    let words: Vec<Vec<String>> = table.header.iter().map(|field| words_of(field.text).0).collect();
    let ends = |i: &usize| (1..words[*i].len()).any(|from| words[*i][from..].concat() == name);
    let mut ending = (0..words.len()).filter(ends);
    words.iter().position(|words| words.concat() == name).or_else(|| ending.next().filter(|_| ending.next().is_none()))
}

/// Columns and what they may be.
type Guess = Option<Vec<(usize, &'static str)>>;

/// The columns of these names, in this order, as these words.
fn columns<const N: usize>(table: &Table<'_>, names: [&str; N], words: [&'static str; N]) -> Guess {
    names.into_iter().zip(words).map(|(name, word)| column(table, name).map(|i| (i, word))).collect()
}

/// Four columns that count the coordinates of a quaternion: `q1` to `q4`, whose first is w (as ABB has them), or `q[0]` to `q[3]`, whose first or last is
/// w. The first pose says which, if it is turned little.
fn quaternion(table: &Table<'_>, _: &[Option<Meaning>]) -> Guess {
    let last = ["qx", "qy", "qz", "qw"];
    ["q", "quat", "quaternion", "orientation", "rot", "rotation"].iter().find_map(|name| {
        [0, 1].iter().find_map(|from| {
            let found: Vec<usize> =
                (0..4).map(|k| column(table, &format!("{name}{}", k + from))).collect::<Option<_>>()?;
            let is_large = |k: usize| number(table.first.get(found[k])?).map(|value| value.abs() > NEAR_ONE);
            let words = match (is_large(0)?, is_large(3)?, *from) {
                (true, false, _) => QUATERNION,
                (false, true, 0) => last,
                // Neither of them tells.
                (false, false, 1) if *name == "q" => QUATERNION,
                _ => [UNTOLD; 4],
            };
            Some(found.into_iter().zip(words).collect())
        })
    })
}

/// Universal Robots call rotation vectors `rx, ry, rz`, in radians and of less than a turn; others mean angles, which nobody can tell apart.
fn named_vector(table: &Table<'_>, _: &[Option<Meaning>]) -> Guess {
    let names = ["rx", "ry", "rz"];
    let of_axis = |name: &&str| table.header.iter().position(|f| words_of(f.text).0.first().is_some_and(|w| w == name));
    let found: Vec<usize> = names.iter().filter_map(of_axis).collect();
    let is_vector = |i: &usize| {
        let value = table.first.get(*i).and_then(number);
        words_of(table.header[*i].text).0.len() == 1 && value.is_none_or(|value| value.abs() < std::f64::consts::TAU)
    };
    let may_be = found.len() == names.len() && found.iter().all(is_vector);
    let words = if may_be { ["rotvec_x", "rotvec_y", "rotvec_z"] } else { [UNTOLD; 3] };
    (!found.is_empty()).then(|| found.into_iter().zip(words).collect())
}

/// Angles of robots by their letters: `W, P, R` about the fixed axes x, y, z in degrees (Fanuc); `A, B, C`, by which controllers mean different angles.
fn robot_angles(table: &Table<'_>, _: &[Option<Meaning>]) -> Guess {
    columns(table, ["w", "p", "r"], ["roll_deg", "pitch_deg", "yaw_deg"])
        .or_else(|| columns(table, ["a", "b", "c"], [UNTOLD; 3]))
}

/// Phi, theta and psi, by which people mean roll, pitch and yaw, or Euler angles of any order: theta alone is a heading, beside one of the others it is not.
fn euler_angles(table: &Table<'_>) -> Vec<usize> {
    let named =
        |name: &str| table.header.iter().position(|f| words_of(f.text).0.first().is_some_and(|word| word == name));
    match [named("theta"), named("phi"), named("psi")] {
        [Some(theta), phi, psi] if phi.or(psi).is_some() => [Some(theta), phi, psi].into_iter().flatten().collect(),
        _ => Vec::new(),
    }
}

/// A second x, y, z with a w, as tables have them that lost the path before their names: `x.1, y.1, z.1, w`.
fn copied_names(table: &Table<'_>, meanings: &[Option<Meaning>]) -> Guess {
    let w = column(table, "w")?;
    let second = |axis: &str| {
        let is_second =
            |i: &usize| meanings[*i].is_none() && words_of(table.header[*i].text).0.first().is_some_and(|w| w == axis);
        let mut all = (0..table.header.len()).filter(is_second);
        all.next().filter(|_| all.next().is_none())
    };
    let [x, y, z] = POSITION.map(second);
    Some(vec![(x?, "qx"), (y?, "qy"), (z?, "qz"), (w, "qw")])
}

#[cfg(test)]
mod tests {
    use super::super::pose_names::meaning;
    use super::*;
    use crate::text::place::Source;

    fn of(text: &str) -> String {
        let table = Table::parse(Source { name: "t", text }, &[]).unwrap();
        let meanings: Vec<_> = table.header.iter().map(meaning).collect();
        Proposal::new(&table, &meanings).to_string()
    }

    #[test]
    fn no_proposal_drops_the_rotation() {
        for (text, words) in [
            ("t;x;y;z;q1;q2;q3;q4\n0;1;2;3;0.8;0;0.6;0\n", r#"["t", "x", "y", "z", "qw", "qx", "qy", "qz"]"#),
            ("t;x;y;z;q1;q2;q3;q4\n0;1;2;3;0;0;0;1\n", r#"["t", "x", "y", "z", "?", "?", "?", "?"]"#),
            ("t,x,y,z,q[0],q[1],q[2],q[3]\n0,1,2,3,0.99,0,0.13,0\n", r#"["t", "x", "y", "z", "qw", "qx", "qy", "qz"]"#),
            (
                "t,x,y,z,quat_0,quat_1,quat_2,quat_3\n0,1,2,3,0,0.1,0,0.99\n",
                r#"["t", "x", "y", "z", "qx", "qy", "qz", "qw"]"#,
            ),
            (
                "t,x,y,z,quat_0,quat_1,quat_2,quat_3\n0,1,2,3,0.7,0.1,0,0.7\n",
                r#"["t", "x", "y", "z", "?", "?", "?", "?"]"#,
            ),
            ("X,Y,Z,W,P,R\n1,2,3,0,15,0\n", r#"["X", "Y", "Z", "roll_deg", "pitch_deg", "yaw_deg"]"#),
            ("t,x,y,z,phi,theta,psi\n0,1,2,3,0,0.1,1\n", r#"["t", "x", "y", "z", "?", "?", "?"]"#),
            ("X,Y,Z,A,B,C\n1,2,3,0,15,0\n", r#"["X", "Y", "Z", "?", "?", "?"]"#),
            ("x,y,z,rx,ry,rz\n1,2,3,0,15,0\n", r#"["x", "y", "z", "?", "?", "?"]"#),
            ("x,y,z,rx,ry,rz\n1,2,3,0,1.5,0\n", r#"["x", "y", "z", "rotvec_x", "rotvec_y", "rotvec_z"]"#),
            (
                "rosbagTimestamp,secs,nsecs,x,y,z,x.1,y.1,z.1,w\n17,1,0,1,2,3,0,0.1,0,0.99\n",
                r#"["rosbagTimestamp", "-", "-", "x", "y", "z", "qx", "qy", "qz", "qw"]"#,
            ),
            ("t,x,y,z,heading,note\n0,1,2,3,90,a\n", r#"["t", "x", "y", "z", "?", "-"]"#),
            ("t,x,y,z,qw,qx,qy,qz,force\n0,1,2,3,1,0,0,0,7\n", r#"["t", "x", "y", "z", "qw", "qx", "qy", "qz", "-"]"#),
        ] {
            let found = of(text);
            assert!(found.contains(words), "{text}: {found}");
            assert_eq!(found.contains("for each `?`"), words.contains('?'), "{text}");
        }
    }
}
