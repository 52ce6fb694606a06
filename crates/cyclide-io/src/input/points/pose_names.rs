//! What the columns of a table of poses are by their names: our own, those of robots, of ROS messages and of data sets.

use super::fields::Field;
use super::names::{axis_kind, words_of};

/// What a column is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Meaning {
    /// The time.
    Time(TimeUnit),
    /// A coordinate of the position.
    Position(usize),
    /// A coordinate of the quaternion.
    Quaternion(usize),
    /// Roll, pitch or yaw, with the radians of its unit.
    Angle(usize, f64),
    /// A coordinate of the rotation vector, axis times angle, with the radians of its unit.
    Vector(usize, f64),
    /// An entry of the matrix, by row and column from 0; our own tables have it beside the quaternion.
    Matrix(usize, usize),
    /// What people call the pose, or say of it.
    Label,
}

/// How a column says times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TimeUnit {
    /// So many in a second.
    PerSecond(f64),
    /// No unit is named: seconds, or what the number of figures of a date in them says.
    Unsaid,
}

pub(super) const POSITION: [&str; 3] = ["x", "y", "z"];
pub(super) const QUATERNION: [&str; 4] = ["qw", "qx", "qy", "qz"];
pub(super) const ANGLES: [&str; 3] = ["roll", "pitch", "yaw"];
const GERMAN_ANGLES: [&str; 3] = ["wank", "nick", "gier"];
pub(super) const DEGREES: [&str; 3] = ["roll_deg", "pitch_deg", "yaw_deg"];

/// The names, for messages.
pub(super) const NAMES: &str = "t, time or timestamp, x, y, z, and qw, qx, qy, qz or roll, pitch, yaw (radians), or m11 to m34 (a matrix, row by row), or rotvec_x, rotvec_y, rotvec_z (axis times angle), with a unit as in `x_mm`, `time [s]`, `roll_deg`";

/// What columns are called that say something about a pose and not where it is.
const LABELS: [&str; 13] =
    ["name", "label", "id", "comment", "remark", "note", "pose", "index", "seq", "no", "nr", "row", "frame"];
/// What our own tables of curves have beside points and frames, and those of motions beside poses.
const MEASURES: [&str; 7] =
    ["station", "curvature", "signed_curvature", "torsion", "speed", "angular_speed", "acceleration"];
pub(super) const AXES: [&str; 3] = ["tangent", "normal", "binormal"];
/// The first axis of frames that look at a point, which have a tangent beside it.
pub(super) const LOOK: &str = "look";
/// Names of angles that controllers mean different things by.
pub(super) const AMBIGUOUS: [&str; 6] = ["rx", "ry", "rz", "a", "b", "c"];
pub(super) const MEANT: &str = "; controllers mean different angles by `rx, ry, rz` and by `A, B, C`: name them rotvec_x, rotvec_y, rotvec_z if they are a rotation vector (axis times angle, as Universal Robots have it), or roll, pitch, yaw if the body is turned about the fixed axes x, y, z \
                     in this order (then `A, B, C` of the order z, y, x are yaw, pitch, roll), with _deg for degrees, or give quaternions";

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// What stands for a column that is left aside.
pub(super) const LEFT_ASIDE: &str = "-";
/// Words of messages beside `x`, `y`, `z` that make them a place, a rotation, or neither.
const PLACES: [&str; 10] = ["position", "pos", "p", "translation", "trans", "location", "tvec", "tcp", "pose", "field"];
const ROTATIONS: [&str; 6] = ["orientation", "quaternion", "quat", "q", "rotation", "rot"];
const NEITHER: [&str; 13] = [
    "v",
    "vel",
    "velocity",
    "twist",
    "linear",
    "angular",
    "b",
    "bias",
    "acc",
    "accel",
    "acceleration",
    "omega",
    "covariance",
];

/// The columns of messages and data sets, by the path to a number: `field.pose.position.x` (ROS), `p_RS_R_x` (EuRoC),
/// `actual_TCP_pose_0` (Universal Robots).
fn of_messages(words: &[&str]) -> Option<Meaning> {
    let (last, before) = words.split_last()?;
    let speaks = |list: &[&str]| before.iter().any(|word| list.contains(word));
    if words.contains(&"covariance") || words.ends_with(&["frame", "id"]) || !before.is_empty() && *last == "seq" {
        return Some(Meaning::Label);
    }
    if let Some(stamp) = before.iter().position(|word| *word == "header").filter(|_| words.contains(&"stamp")) {
        return unit_of_time(&words[stamp + 2..]).map(Meaning::Time);
    }
    // The heading of messages in the plane.
    if let ["theta", unit @ ..] | ["field" | "pose", "theta", unit @ ..] = words {
        return unit_of_angle(unit).map(|unit| Meaning::Angle(2, unit));
    }
    if let ["rotvec" | "rv" | "rvec", letter, unit @ ..] | ["rot" | "rotation", "vec" | "vector", letter, unit @ ..] =
        words
    {
        let axis = POSITION.iter().position(|axis| axis == letter)?;
        return unit_of_angle(unit).map(|unit| Meaning::Vector(axis, unit));
    }
    if before.ends_with(&["tcp", "pose"]) {
        let number = last.parse::<usize>().ok().filter(|number| *number < 6)?;
        return Some(if number < 3 { Meaning::Position(number) } else { Meaning::Vector(number - 3, 1.0) });
    }
    // Joints, forces and speeds beside the pose, as controllers of Universal Robots record them.
    if let ["actual" | "target", ..] = words {
        return Some(Meaning::Label);
    }
    let letter = ["w", "x", "y", "z"].iter().position(|letter| letter == last).filter(|_| !before.is_empty())?;
    if speaks(&NEITHER) {
        Some(Meaning::Label)
    } else if speaks(&ROTATIONS) {
        Some(Meaning::Quaternion(letter))
    } else if speaks(&PLACES) && letter > 0 {
        Some(Meaning::Position(letter - 1))
    } else {
        None
    }
}

/// True for a column of a place or a rotation.
pub(super) fn is_of_pose(field: &Field<'_>) -> bool {
    matches!(
        meaning(field),
        Some(
            Meaning::Position(_)
                | Meaning::Quaternion(_)
                | Meaning::Angle(..)
                | Meaning::Vector(..)
                | Meaning::Matrix(..)
        )
    )
}

/// The radians of the unit of an angle, by the words beside its name.
fn unit_of_angle(words: &[&str]) -> Option<f64> {
    match words {
        ["deg" | "degs" | "degree" | "degrees" | "grad" | "altgrad" | "\u{ba}"] => Some(DEGREE),
        [] | ["rad" | "rads" | "radian" | "radians"] => Some(1.0),
        _ => None,
    }
}

/// What a column is, by its name and the word for it in a line of units.
pub(super) fn meaning_with_unit(field: &Field<'_>, unit: &str) -> Option<Meaning> {
    let plain = meaning(field);
    let unit = unit.trim_matches(['[', ']', '(', ')', ' ']);
    let has_unit_of_its_own =
        !matches!(plain, Some(Meaning::Angle(..) | Meaning::Vector(..) | Meaning::Time(TimeUnit::Unsaid)));
    if has_unit_of_its_own || matches!(unit, "" | "-" | "--" | "1") {
        return plain;
    }
    let named = format!("{} [{unit}]", field.text);
    // `yaw [rad]` over `rad` says it twice.
    meaning(&Field { text: &named, start: field.start })
        .or_else(|| plain.filter(|_| field.text.contains(['[', '(', '_'])))
}

/// Units of time, and how many of them a second has.
const TIME_UNITS: [(&str, f64); 5] = [
    ("s sec secs second seconds sek sekunde sekunden seconde secondes secondo secondi segundo segundos", 1.0),
    (
        "ms msec msecs millis millisecond milliseconds millisekunde millisekunden milliseconde millisecondes millisecondi milisegundos",
        1e3,
    ),
    (
        "us usec usecs micros microsecond microseconds mikrosekunden microsecondes microsecondi microsegundos \u{b5}s \u{3bc}s",
        1e6,
    ),
    (
        "ns nsec nsecs nanos nanosec nanosecs nanosecond nanoseconds nanosekunden nanosecondes nanosecondi nanosegundos",
        1e9,
    ),
    ("min minute minutes minuten", 1.0 / 60.0),
];

/// How many of a unit of time a second has.
fn per_second(word: &str) -> Option<f64> {
    let is_of = |words: &str| words.split(' ').any(|own| own == word);
    TIME_UNITS.iter().find(|(words, _)| is_of(words)).map(|(_, count)| *count)
}

/// The unit of a time, by the words beside its name.
pub(super) fn unit_of_time(words: &[&str]) -> Option<TimeUnit> {
    let per_second = match words {
        [] => return Some(TimeUnit::Unsaid),
        [word] => per_second(word)?,
        _ => return None,
    };
    Some(TimeUnit::PerSecond(per_second))
}

/// What a column is, by its name.
pub(super) fn meaning(field: &Field<'_>) -> Option<Meaning> {
    // `x_left` may be anything.
    let is_axis = |letter: &str| axis_kind(letter, field).is_some_and(|kind| kind != 2);
    if let Some(axis) = POSITION.iter().position(|letter| is_axis(letter)) {
        return Some(Meaning::Position(axis));
    }
    // Left aside by who says what the columns are.
    if field.text == LEFT_ASIDE {
        return Some(Meaning::Label);
    }
    // Units there are like `[m s^-1]`, and often empty.
    let (path, _) = words_of(field.text.split(['[', '(']).next().unwrap_or_default());
    let (words, _) = words_of(field.text);
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    // The sign is no letter, and not among the words.
    let degrees = field.text.contains('\u{b0}');
    let in_brackets = |unit: f64| match (words.get(path.len()..).unwrap_or_default(), degrees) {
        ([], false) => Some(unit),
        (beside, _) => {
            let beside = if degrees { Some(DEGREE) } else { unit_of_angle(beside) };
            // `theta_deg [deg]` says it twice.
            beside.filter(|beside| unit.total_cmp(&1.0).is_eq() || unit.total_cmp(beside).is_eq())
        }
    };
    match of_messages(&path.iter().map(String::as_str).collect::<Vec<_>>()) {
        // Their unit may stand in brackets.
        Some(Meaning::Vector(axis, unit)) => return in_brackets(unit).map(|unit| Meaning::Vector(axis, unit)),
        Some(Meaning::Angle(angle, unit)) => return in_brackets(unit).map(|unit| Meaning::Angle(angle, unit)),
        Some(found) => return Some(found),
        None => {}
    }
    let (first, beside) = words.split_first()?;
    if let Some(angle) = [ANGLES, GERMAN_ANGLES].iter().find_map(|names| names.iter().position(|name| name == first)) {
        let unit = if degrees && beside.is_empty() { Some(DEGREE) } else { unit_of_angle(beside) };
        return unit.map(|unit| Meaning::Angle(angle, unit));
    }
    if ["t", "time", "timestamp", "stamp", "rosbagtimestamp", "zeit"].contains(first) {
        return unit_of_time(beside).map(Meaning::Time);
    }
    if let ["rosbag", "timestamp", unit @ ..] = words.as_slice() {
        return unit_of_time(unit).map(Meaning::Time);
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
    fn a_line_of_units_counts_as_units_in_the_names_do() {
        let of = |text: &'static str, unit: &str| meaning_with_unit(&Field { text, start: 0 }, unit);
        assert_eq!(of("yaw", "deg"), Some(Meaning::Angle(2, DEGREE)));
        assert_eq!(of("roll", "[\u{b0}]"), Some(Meaning::Angle(0, DEGREE)));
        assert_eq!(of("rotvec_y", "deg"), Some(Meaning::Vector(1, DEGREE)));
        assert_eq!(of("yaw [rad]", "rad"), Some(Meaning::Angle(2, 1.0)));
        assert_eq!(of("pitch", ""), Some(Meaning::Angle(1, 1.0)));
        assert_eq!(of("t", "ms"), Some(Meaning::Time(TimeUnit::PerSecond(1e3))));
        assert_eq!(of("x", "mm"), Some(Meaning::Position(0)));
        assert_eq!((of("roll", "gon"), of("t", "h")), (None, None));
    }

    #[test]
    fn columns_are_known_by_their_names() {
        let meaning_of = |text: &'static str| meaning(&Field { text, start: 0 });
        for (name, expected) in [
            ("x_mm", Some(Meaning::Position(0))),
            ("Y [m]", Some(Meaning::Position(1))),
            ("pos_z", Some(Meaning::Position(2))),
            ("position.x", Some(Meaning::Position(0))),
            ("px", Some(Meaning::Position(0))),
            ("time [s]", Some(Meaning::Time(TimeUnit::PerSecond(1.0)))),
            ("t", Some(Meaning::Time(TimeUnit::Unsaid))),
            ("T_ms", Some(Meaning::Time(TimeUnit::PerSecond(1e3)))),
            ("time (h)", None),
            ("timestamp", Some(Meaning::Time(TimeUnit::Unsaid))),
            ("rosbagTimestamp", Some(Meaning::Time(TimeUnit::Unsaid))),
            ("ty", Some(Meaning::Position(1))),
            ("time_ns", Some(Meaning::Time(TimeUnit::PerSecond(1e9)))),
            ("timestamp [us]", Some(Meaning::Time(TimeUnit::PerSecond(1e6)))),
            ("t (µs)", Some(Meaning::Time(TimeUnit::PerSecond(1e6)))),
            ("time [min]", Some(Meaning::Time(TimeUnit::PerSecond(1.0 / 60.0)))),
            ("q_w", Some(Meaning::Quaternion(0))),
            ("quat.x", Some(Meaning::Quaternion(1))),
            ("QZ", Some(Meaning::Quaternion(3))),
            ("roll", Some(Meaning::Angle(0, 1.0))),
            ("pitch [rad]", Some(Meaning::Angle(1, 1.0))),
            ("yaw_deg", Some(Meaning::Angle(2, DEGREE))),
            ("yaw (°)", Some(Meaning::Angle(2, DEGREE))),
            ("yaw [º]", Some(Meaning::Angle(2, DEGREE))),
            ("Roll [Grad]", Some(Meaning::Angle(0, DEGREE))),
            ("Nick [Grad]", Some(Meaning::Angle(1, DEGREE))),
            ("Gier (°)", Some(Meaning::Angle(2, DEGREE))),
            ("yaw [gon]", None),
            ("m34", Some(Meaning::Matrix(2, 3))),
            ("m44", Some(Meaning::Matrix(3, 3))),
            ("m54", None),
            ("Name", Some(Meaning::Label)),
            ("rx", None),
            ("signed_curvature", Some(Meaning::Label)),
            ("normal_y", Some(Meaning::Matrix(1, 1))),
            ("binormal_x", Some(Meaning::Matrix(0, 2))),
            ("look_y", Some(Meaning::Matrix(1, 0))),
            ("field.pose.position.x", Some(Meaning::Position(0))),
            ("field.pose.pose.orientation.w", Some(Meaning::Quaternion(0))),
            ("/robot/pose/orientation/z", Some(Meaning::Quaternion(3))),
            ("transform.translation.y", Some(Meaning::Position(1))),
            ("transform.rotation.x", Some(Meaning::Quaternion(1))),
            ("field.twist.twist.linear.x", Some(Meaning::Label)),
            ("field.pose.covariance", Some(Meaning::Label)),
            ("field.theta", Some(Meaning::Angle(2, 1.0))),
            ("theta_deg", Some(Meaning::Angle(2, DEGREE))),
            ("theta [deg]", Some(Meaning::Angle(2, DEGREE))),
            ("theta_deg [deg]", Some(Meaning::Angle(2, DEGREE))),
            ("pose.theta (\u{b0})", Some(Meaning::Angle(2, DEGREE))),
            ("theta_deg [rad]", None),
            ("theta_dot", None),
            ("field.pose.covariance0", None),
            ("field.header.stamp", Some(Meaning::Time(TimeUnit::Unsaid))),
            ("field.header.frame_id", Some(Meaning::Label)),
            ("%time", Some(Meaning::Time(TimeUnit::Unsaid))),
            ("p_RS_R_x [m]", Some(Meaning::Position(0))),
            ("q_RS_w []", Some(Meaning::Quaternion(0))),
            ("v_RS_R_x [m s^-1]", Some(Meaning::Label)),
            ("b_w_RS_S_z [rad s^-1]", Some(Meaning::Label)),
            ("actual_TCP_pose_4", Some(Meaning::Vector(1, 1.0))),
            ("rotvec_z", Some(Meaning::Vector(2, 1.0))),
            ("rotvec_x_deg", Some(Meaning::Vector(0, DEGREE))),
            ("rotvec_x [deg]", Some(Meaning::Vector(0, DEGREE))),
            ("rotvec_x [gon]", None),
            ("-", Some(Meaning::Label)),
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
