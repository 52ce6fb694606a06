//! Which columns of a table of poses are what, by their names: units stand beside them as in tables of points.

use super::columns::{Chosen, axis_kind, words_of};
use super::table::{Field, Table};
use crate::text::place::{Diagnostic, Source, quoted};
use crate::text::suggest::did_you_mean;

/// The columns of a table of poses.
pub(super) struct PoseColumns {
    /// Those of the position, as the coordinates of points are.
    pub(super) position: Chosen,
    /// That of the time, and the seconds of its unit.
    pub(super) time: Option<(usize, f64)>,
    pub(super) rotation: RotationColumns,
    /// Names of coordinates and angles that no column has: they are 0.
    pub(super) absent: Vec<&'static str>,
}

/// How a table says rotations.
pub(super) enum RotationColumns {
    /// Columns of the quaternion.
    Quaternion([usize; 4]),
    /// Columns of roll, pitch and yaw, one at least, and what they are multiplied by.
    Angles([Option<usize>; 3], f64),
    /// Columns of the entries of a matrix: the rotation row by row, and the last row `0 0 0 1`, where it is given.
    Matrix([[usize; 3]; 3], [Option<usize>; 4]),
    /// No column: not turned.
    None,
}

/// What a column is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Meaning {
    /// The time, with the seconds of its unit.
    Time(f64),
    /// A coordinate of the position.
    Position(usize),
    /// A coordinate of the quaternion.
    Quaternion(usize),
    /// Roll, pitch or yaw, with the radians of its unit.
    Angle(usize, f64),
    /// An entry of the matrix, by row and column from 0; our own tables have it beside the quaternion.
    Matrix(usize, usize),
    /// What people call the pose, or say of it.
    Label,
}

const POSITION: [&str; 3] = ["x", "y", "z"];
const QUATERNION: [&str; 4] = ["qw", "qx", "qy", "qz"];
const ANGLES: [&str; 3] = ["roll", "pitch", "yaw"];
const DEGREES: [&str; 3] = ["roll_deg", "pitch_deg", "yaw_deg"];

/// The names, for messages.
pub(super) const NAMES: &str = "t, time or timestamp, x, y, z, and qw, qx, qy, qz or roll, pitch, yaw (radians), or m11 to m34 (a matrix, row by row), with a unit as in `x_mm`, `time [s]`, `roll_deg`";

/// What columns are called that say something about a pose and not where it is.
const LABELS: [&str; 8] = ["name", "label", "id", "comment", "remark", "note", "pose", "index"];
/// What our own tables of curves have beside points and frames, and those of motions beside poses.
const MEASURES: [&str; 7] =
    ["station", "curvature", "signed_curvature", "torsion", "speed", "angular_speed", "acceleration"];
const AXES: [&str; 3] = ["tangent", "normal", "binormal"];
/// The first axis of frames that look at a point, which have a tangent beside it.
const LOOK: &str = "look";
/// Names of angles that controllers mean different things by.
const AMBIGUOUS: [&str; 6] = ["rx", "ry", "rz", "a", "b", "c"];
const MEANT: &str = "; controllers mean different angles by `rx, ry, rz` and by `A, B, C`: name them roll, pitch, yaw if the body is turned about the fixed axes x, y, z \
                     in this order (then `A, B, C` of the order z, y, x are yaw, pitch, roll), with _deg for degrees, or give quaternions";

const DEGREE: f64 = std::f64::consts::PI / 180.0;

impl PoseColumns {
    pub(super) fn new(source: Source<'_>, table: &Table<'_>) -> Result<Self, Box<Diagnostic>> {
        let mut meanings: Vec<Option<Meaning>> = table.header.iter().map(meaning).collect();
        leave_tangents(table, &mut meanings);
        // What is not read could be what was meant.
        if let Some(other) = meanings.iter().position(Option::is_none) {
            let field = &table.header[other];
            let known = ["t", "time"].into_iter().chain(POSITION).chain(QUATERNION).chain(ANGLES).chain(DEGREES);
            let (words, _) = words_of(field.text);
            let ambiguous = words.first().is_some_and(|word| AMBIGUOUS.contains(&word.as_str()));
            let hint = if ambiguous { MEANT.to_owned() } else { did_you_mean(field.text, known) };
            let message = format!("`{}` is no column of poses, which are {NAMES}{hint}", quoted(field.text));
            return Err(field.refused(source, message));
        }
        let only = |what: &str, fits: &dyn Fn(Meaning) -> bool| -> Result<Option<usize>, Box<Diagnostic>> {
            let all: Vec<usize> = (0..meanings.len()).filter(|&i| meanings[i].is_some_and(fits)).collect();
            match all.as_slice() {
                [] => Ok(None),
                [column] => Ok(Some(*column)),
                several => {
                    let names = table.names(several.iter().copied());
                    Err(table.header_refused(format!("several columns are {what}: {names}: leave one of them")))
                }
            }
        };
        let needed = |name: &str, m: &dyn Fn(Meaning) -> bool| only(name, m)?.ok_or_else(|| table.no_column(name));
        let any = |fits: &dyn Fn(Meaning) -> bool| meanings.iter().flatten().any(|m| fits(*m));
        let is_quaternion = |m| matches!(m, Meaning::Quaternion(_));
        let is_angle = |m| matches!(m, Meaning::Angle(..));
        let is_matrix = |m| matches!(m, Meaning::Matrix(..));
        let entry = |i: usize, j: usize| needed(&format!("m{}{}", i + 1, j + 1), &|m| m == Meaning::Matrix(i, j));
        // Beside a quaternion a matrix says the same again.
        let by_matrix = any(&is_matrix) && !any(&is_quaternion);
        let placed = any(&|m| matches!(m, Meaning::Position(_)));
        let is_of = |axis: &str| table.header.iter().any(|field| is_of(field, axis));
        if by_matrix && is_of(AXES[0]) && !is_of(AXES[1]) {
            return Err(table.header_refused(
                "these are points of a curve with its tangents, and poses need frames: `cyclide sample --frames KIND` writes them, and `along` runs on the curve itself",
            ));
        }
        if by_matrix && placed && any(&|m| matches!(m, Meaning::Matrix(0..=2, 3))) {
            return Err(table.header_refused(
                "the positions are there twice, as x, y, z and as m14, m24, m34: leave the columns of one of them",
            ));
        }
        let mut absent = Vec::new();
        let is_coordinate = |i: usize| move |m: Meaning| m == Meaning::Position(i);
        let coordinates = match by_matrix && !placed {
            true => vec![entry(0, 3)?, entry(1, 3)?, entry(2, 3)?],
            // In the plane.
            false => {
                let in_plane = [needed(POSITION[0], &is_coordinate(0))?, needed(POSITION[1], &is_coordinate(1))?];
                let height = only(POSITION[2], &is_coordinate(2))?;
                if height.is_none() {
                    absent.push(POSITION[2]);
                }
                in_plane.into_iter().chain(height).collect()
            }
        };
        let position = Chosen { coordinates, contour: None, corner: None, remark: None };
        position.refuse_several_units(table)?;
        let time = only("the time", &|m| matches!(m, Meaning::Time(_)))?;
        let time = time.and_then(|column| match meanings[column] {
            Some(Meaning::Time(seconds)) => Some((column, seconds)),
            _ => None,
        });
        let rotation = match (any(&is_quaternion), any(&is_angle)) {
            (true, true) => {
                return Err(table.header_refused(
                    "the rotations are there twice, as quaternions and as angles: leave the columns of one of them",
                ));
            }
            (false, true) if by_matrix => {
                return Err(table.header_refused(
                    "the rotations are there twice, as angles and as a matrix: leave the columns of one of them",
                ));
            }
            (true, false) => {
                let column = |i: usize| needed(QUATERNION[i], &|m| m == Meaning::Quaternion(i));
                RotationColumns::Quaternion([column(0)?, column(1)?, column(2)?, column(3)?])
            }
            (false, true) => {
                let column = |i: usize| only(ANGLES[i], &|m| matches!(m, Meaning::Angle(own, _) if own == i));
                let columns = [column(0)?, column(1)?, column(2)?];
                absent.extend((0..3).filter(|i| columns[*i].is_none()).map(|i| ANGLES[i]));
                let given = columns.into_iter().flatten();
                let units: Vec<f64> = given.clone().filter_map(|column| unit_of_angle(meanings[column])).collect();
                if units.iter().any(|unit| unit.total_cmp(&units[0]).is_ne()) {
                    let names = table.names(given);
                    let message =
                        format!("the columns {names} speak of different units (without one they are radians)");
                    return Err(table.header_refused(message));
                }
                RotationColumns::Angles(columns, units.first().copied().unwrap_or(1.0))
            }
            (false, false) if by_matrix => {
                let row = |i: usize| Ok::<_, Box<Diagnostic>>([entry(i, 0)?, entry(i, 1)?, entry(i, 2)?]);
                let last = |j: usize| only(&format!("m4{}", j + 1), &|m| m == Meaning::Matrix(3, j));
                RotationColumns::Matrix([row(0)?, row(1)?, row(2)?], [last(0)?, last(1)?, last(2)?, last(3)?])
            }
            (false, false) => RotationColumns::None,
        };
        Ok(Self { position, time, rotation, absent })
    }
}

/// The radians of the unit of an angle.
fn unit_of_angle(meaning: Option<Meaning>) -> Option<f64> {
    match meaning {
        Some(Meaning::Angle(_, unit)) => Some(unit),
        _ => None,
    }
}

/// The seconds of a unit of time, by the words beside a name: none is seconds.
fn seconds_of(words: &[&str]) -> Option<f64> {
    match words {
        [] | ["s" | "sec" | "secs" | "second" | "seconds"] => Some(1.0),
        ["ms" | "msec" | "millisecond" | "milliseconds"] => Some(1e-3),
        ["us" | "usec" | "microsecond" | "microseconds" | "\u{b5}s" | "\u{3bc}s"] => Some(1e-6),
        ["ns" | "nsec" | "nanosecond" | "nanoseconds"] => Some(1e-9),
        ["min" | "minute" | "minutes"] => Some(60.0),
        _ => None,
    }
}

/// Whether a column is one of the coordinates of an axis.
fn is_of(field: &Field<'_>, axis: &str) -> bool {
    words_of(field.text).0.first().is_some_and(|word| word == axis)
}

/// Where frames look at a point, their tangent is no axis of the body.
fn leave_tangents(table: &Table<'_>, meanings: &mut [Option<Meaning>]) {
    if table.header.iter().any(|field| is_of(field, LOOK)) {
        for (field, meaning) in table.header.iter().zip(meanings) {
            if is_of(field, AXES[0]) {
                *meaning = Some(Meaning::Label);
            }
        }
    }
}

/// What a column is, by its name.
fn meaning(field: &Field<'_>) -> Option<Meaning> {
    // `x_left` may be anything.
    let is_axis = |letter: &str| axis_kind(letter, field).is_some_and(|kind| kind != 2);
    if let Some(axis) = POSITION.iter().position(|letter| is_axis(letter)) {
        return Some(Meaning::Position(axis));
    }
    let (words, _) = words_of(field.text);
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    // The sign is no letter, and not among the words.
    let degrees = field.text.contains('\u{b0}');
    let (first, beside) = words.split_first()?;
    if let Some(angle) = ANGLES.iter().position(|name| name == first) {
        let unit = match beside {
            [] if degrees => DEGREE,
            ["deg" | "degs" | "degree" | "degrees" | "\u{ba}"] => DEGREE,
            [] | ["rad" | "rads" | "radian" | "radians"] => 1.0,
            _ => return None,
        };
        return Some(Meaning::Angle(angle, unit));
    }
    if ["t", "time", "timestamp"].contains(first) {
        return seconds_of(beside).map(Meaning::Time);
    }
    if words.len() == 1 && LABELS.contains(first) || MEASURES.contains(&words.join("_").as_str()) {
        return Some(Meaning::Label);
    }
    // The frames of curves in our own tables: the axes of the body, which are the columns of its matrix.
    if let [axis, letter] = words.as_slice()
        && let Some(column) = AXES.iter().position(|name| name == axis).or((*axis == LOOK).then_some(0))
        && let Some(row) = POSITION.iter().position(|name| name == letter)
    {
        return Some(Meaning::Matrix(row, column));
    }
    // As the tables of the TUM benchmark have it.
    if let ["tx" | "ty" | "tz"] = words.as_slice() {
        return POSITION.iter().position(|axis| words[0].ends_with(axis)).map(Meaning::Position);
    }
    let quaternion = match words.as_slice() {
        [only] => QUATERNION.iter().position(|name| name == only),
        ["q" | "quat" | "quaternion", letter] => ["w", "x", "y", "z"].iter().position(|name| name == letter),
        _ => None,
    };
    if let Some(coordinate) = quaternion {
        return Some(Meaning::Quaternion(coordinate));
    }
    let [only] = words.as_slice() else { return None };
    (0..4)
        .flat_map(|i| (0..4).map(move |j| (i, j)))
        .find_map(|(i, j)| (*only == format!("m{}{}", i + 1, j + 1)).then_some(Meaning::Matrix(i, j)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_known_by_their_names() {
        let meaning_of = |text: &'static str| meaning(&Field { text, start: 0 });
        for (name, expected) in [
            ("x_mm", Some(Meaning::Position(0))),
            ("Y [m]", Some(Meaning::Position(1))),
            ("pos_z", Some(Meaning::Position(2))),
            ("position.x", Some(Meaning::Position(0))),
            ("px", Some(Meaning::Position(0))),
            ("time [s]", Some(Meaning::Time(1.0))),
            ("t", Some(Meaning::Time(1.0))),
            ("T_ms", Some(Meaning::Time(1e-3))),
            ("time (h)", None),
            ("timestamp", Some(Meaning::Time(1.0))),
            ("ty", Some(Meaning::Position(1))),
            ("time_ns", Some(Meaning::Time(1e-9))),
            ("timestamp [us]", Some(Meaning::Time(1e-6))),
            ("t (µs)", Some(Meaning::Time(1e-6))),
            ("time [min]", Some(Meaning::Time(60.0))),
            ("q_w", Some(Meaning::Quaternion(0))),
            ("quat.x", Some(Meaning::Quaternion(1))),
            ("QZ", Some(Meaning::Quaternion(3))),
            ("roll", Some(Meaning::Angle(0, 1.0))),
            ("pitch [rad]", Some(Meaning::Angle(1, 1.0))),
            ("yaw_deg", Some(Meaning::Angle(2, DEGREE))),
            ("yaw (°)", Some(Meaning::Angle(2, DEGREE))),
            ("yaw [º]", Some(Meaning::Angle(2, DEGREE))),
            ("roll_grad", None),
            ("m34", Some(Meaning::Matrix(2, 3))),
            ("m44", Some(Meaning::Matrix(3, 3))),
            ("m54", None),
            ("Name", Some(Meaning::Label)),
            ("rx", None),
            ("signed_curvature", Some(Meaning::Label)),
            ("normal_y", Some(Meaning::Matrix(1, 1))),
            ("binormal_x", Some(Meaning::Matrix(0, 2))),
            ("look_y", Some(Meaning::Matrix(1, 0))),
            ("A", None),
            ("x_left", None),
            ("x_deg", None),
            ("speed", Some(Meaning::Label)),
            ("angular_speed", Some(Meaning::Label)),
            ("force", None),
            ("", None),
        ] {
            assert_eq!(meaning_of(name), expected, "{name}");
        }
    }
}
