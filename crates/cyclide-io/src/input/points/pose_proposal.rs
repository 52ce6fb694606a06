//! What a refusal proposes for the columns of a table of poses: the words that make them poses, `?` where nobody can tell.

use super::names::words_of;
use super::pose_names::{Meaning, POSITION, QUATERNION};
use super::table::{Field, Table};
use crate::text::place::quoted;

/// A column that is left out, and one whose meaning is unknown.
const ASIDE: &str = "-";
const UNTOLD: &str = "?";

/// A coordinate of a quaternion as large is its w, where the others may be any: the body is turned by less than 40 degrees.
const NEAR_ONE: f64 = 0.94;

/// What the columns are, as a document says it.
pub(super) fn proposed(table: &Table<'_>, meanings: &[Option<Meaning>]) -> String {
    let mut words: Vec<Option<String>> = table.header.iter().zip(meanings).map(known).collect();
    let turned = |m: &Option<Meaning>| {
        matches!(
            m,
            Some(Meaning::Quaternion(_) | Meaning::Angle(..) | Meaning::Vector(..) | Meaning::Matrix(0..=2, 0..=2))
        )
    };
    let mut rotation = meanings.iter().any(turned);
    for guess in [quaternion, named_vector, robot_angles, copied_names] {
        if let Some(found) = guess(table, meanings).filter(|_| !rotation) {
            rotation = true;
            found.into_iter().for_each(|(column, word)| words[column] = Some(word.to_owned()));
        }
    }
    let timed = meanings.iter().any(|m| matches!(m, Some(Meaning::Time(_))));
    let rest = |i: usize| {
        let number = table.first.get(i).is_some_and(|field| number(field).is_some());
        let names = words_of(table.header[i].text).0;
        let is_time = names.iter().any(|word| matches!(word.as_str(), "secs" | "nsecs" | "sec" | "nanosec"));
        let aside = if is_time { timed } else { rotation || !number };
        if aside { ASIDE } else { UNTOLD }
    };
    let words: Vec<String> =
        words.into_iter().enumerate().map(|(i, word)| word.unwrap_or_else(|| rest(i).to_owned())).collect();
    let list = words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
    let untold = if words.iter().any(|word| word == UNTOLD) { ", with the right word for each `?`" } else { "" };
    format!("`\"columns\": [{list}]`{untold}")
}

/// The name of a column that is known.
fn known((field, meaning): (&Field<'_>, &Option<Meaning>)) -> Option<String> {
    let name = || quoted(field.text).replace(['"', '\\'], " ");
    meaning.map(|meaning| if meaning == Meaning::Label { ASIDE.to_owned() } else { name() })
}

/// The number of a field of the first line.
fn number(field: &Field<'_>) -> Option<f64> {
    field.text.replace(',', ".").parse().ok()
}

/// The column whose only word, or whose words without what stands between them, are these.
fn column(table: &Table<'_>, name: &str) -> Option<usize> {
    table.header.iter().position(|field| words_of(field.text).0.concat() == name)
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
        proposed(&table, &meanings)
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
