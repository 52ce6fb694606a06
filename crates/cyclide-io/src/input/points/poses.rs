//! Tables of poses: columns by their names.

use cyclide::{Error, Quat, Vec3, error::PoseError, model::Units, motion::Pose};
use std::f64::consts::{PI, TAU};

use super::clock::Clock;
use super::decimals::Decimals;
use super::fields::Field;
use super::headless::Headless;
use super::pose_columns::{PoseColumns, RotationColumns};
use super::pose_names::{LEFT_ASIDE, NAMES, is_of_pose};
use super::table::Table;
use crate::text::encoding::decode_table;
use crate::text::place::{Diagnostic, Source};

/// Matrices may be off those of rotations by this much without a word: six decimals.
pub(crate) const SIX_DECIMALS: f64 = 1e-5;
/// Most poses that are read.
const MOST_POSES: usize = 1_000_000;

/// A pose of a table, with its time, if there is a column of it.
pub(crate) struct TablePose {
    pub(crate) time: Option<f64>,
    pub(crate) pose: Pose,
}

/// The poses of a table.
pub(crate) struct PoseTable {
    pub(crate) poses: Vec<TablePose>,
    /// The first angle in radians of more than a turn, with its line: degrees may be meant.
    pub(crate) more_than_a_turn: Option<(usize, f64)>,
    /// The first angle that differs by a turn or more from that of the pose before, with its line and the difference.
    pub(crate) whole_turns: Option<(usize, f64)>,
    /// How many matrices are off a rotation by more than six decimals leave, with the line of the worst and how much that is.
    pub(crate) rounded_matrices: Option<(usize, usize, f64)>,
    /// The sentence about columns that are not there.
    pub(crate) taken_as_zero: Option<String>,
    /// The sentence about columns that may be in another order.
    pub(crate) columns_taken: Option<String>,
    /// The sentence about times without a unit that are far apart.
    pub(crate) seconds_assumed: Option<String>,
    /// Units that the names of the coordinates speak of.
    pub(crate) unit_hints: Vec<(String, Units)>,
    /// The sentence about names that speak of a unit which no model has.
    pub(crate) unit_not_applied: Option<String>,
    /// What was chosen with certainty and is not plain.
    pub(crate) notes: Vec<String>,
}

/// What six decimals leave unknown of the difference of two angles, radians: as much as for half a turn.
const TURN_DIGITS: f64 = 2e-6;

/// Which of three angles, in radians, differs by a turn or more from that of the pose before, and by how much: turns that no pose can say. Angles within half
/// a turn of 0 that do so come round there, as headings do.
pub(crate) fn whole_turns(before: [f64; 3], angles: [f64; 3]) -> Option<(usize, f64)> {
    let differs =
        |k: &usize| angles[*k].abs() > PI + TURN_DIGITS && (angles[*k] - before[*k]).abs() >= TAU - TURN_DIGITS;
    (0..3).find(differs).map(|k| (k, angles[k] - before[k]))
}

/// Reads a table of poses; `columns` says what its columns are, in place of a header.
///
/// # Errors
/// A message with file, line and column: no header, a missing column, a field that is no finite number, a rotation of zero, a matrix that is off by more than a
/// limit, times that do not rise where they have to.
pub(crate) fn read_poses(
    name: &str,
    bytes: &[u8],
    columns: Option<&[String]>,
    rising: bool,
    limit: f64,
) -> Result<PoseTable, Box<Diagnostic>> {
    let decoded = decode_table(name, bytes)?;
    let source = Source { name, text: &decoded.text };
    let mut table = Table::parse_with(source, &["qw".to_owned(), "yaw".to_owned(), "t".to_owned()], is_of_pose)?;
    let mut notes: Vec<String> =
        decoded.encoding.map(|name| format!("the text is read as {name}")).into_iter().collect();
    let columns_taken = name_columns(&mut table, columns, &mut notes)?;
    let PoseColumns { position, time, nanoseconds, rotation, absent, notes: names } = PoseColumns::new(source, &table)?;
    notes.extend(names);
    let mut decimals = Decimals::of(source, &table, None)?;
    let mut clock = time.map(|(_, unit)| Clock::new(unit));
    let (mut poses, mut more_than_a_turn) = (Vec::new(), None);
    let (mut turned, mut turns): (Option<[f64; 3]>, Option<(usize, f64)>) = (None, None);
    let mut rounded: Option<(usize, usize, f64)> = None;
    let [x, y] = [0, 1].map(|axis| position.coordinates[axis]);
    let z = position.coordinates.get(2).copied();
    let exact = |made: cyclide::Result<Pose>| made.map(|pose| (pose, 0.0));
    table.for_each_row(|row| {
        if poses.len() == MOST_POSES {
            return Err(row.fields[0].refused(source, format!("the file has more than {MOST_POSES} poses")));
        }
        let at = time;
        let time = match (time, &mut clock) {
            (Some((column, _)), Some(clock)) => {
                let parts = nanoseconds.map(|column| row.field(source, column, "number")).transpose()?;
                Some(clock.read(source, &mut decimals, &row.field(source, column, "number")?, parts.as_ref())?)
            }
            _ => None,
        };
        let mut value = |column: usize| decimals.read(source, &row.field(source, column, "number")?);
        let translation = Vec3::new(value(x)?, value(y)?, z.map_or(Ok(0.0), &mut value)?);
        let before = poses.last().and_then(|pose: &TablePose| pose.time);
        if let (Some(time), Some(before), Some((column, _)), true) = (time, before, at, rising)
            && time <= before
        {
            let hint = clock.as_ref().map_or("", Clock::past_midnight);
            let message = format!("the times do not increase: {time} seconds, after {before}{hint}");
            return Err(row.fields[column].refused(source, message).with_reason("parameters-not-increasing"));
        }
        // Lines are counted where they are told.
        let line = || source.line_of(row.fields[0].start);
        let made = match &rotation {
            RotationColumns::Quaternion([w, x, y, z]) => {
                exact(Pose::new(Quat::new(value(*w)?, value(*x)?, value(*y)?, value(*z)?), translation))
            }
            RotationColumns::Angles([roll, pitch, yaw], unit) => {
                let mut angle = |column: Option<usize>| column.map_or(Ok(0.0), &mut value);
                let angles = [angle(*roll)?, angle(*pitch)?, angle(*yaw)?];
                let wide = angles.into_iter().find(|angle| *unit >= 1.0 && angle.abs() > TAU);
                if let (Some(angle), None) = (wide, more_than_a_turn) {
                    more_than_a_turn = Some((line(), angle));
                }
                let angles = angles.map(|angle| angle * unit);
                if let (Some((_, change)), None) = (turned.and_then(|before| whole_turns(before, angles)), turns) {
                    turns = Some((line(), change));
                }
                turned = Some(angles);
                exact(Pose::from_roll_pitch_yaw(translation, angles))
            }
            RotationColumns::Vector(columns, unit) => {
                let vector = Vec3::new(value(columns[0])?, value(columns[1])?, value(columns[2])?) * *unit;
                let angle = vector.length();
                if *unit >= 1.0 && angle > TAU + TURN_DIGITS && more_than_a_turn.is_none() {
                    more_than_a_turn = Some((line(), angle));
                }
                let rotation = if angle > 0.0 { Quat::from_axis_angle(vector / angle, angle) } else { Quat::ONE };
                exact(Pose::new(rotation, translation))
            }
            RotationColumns::Matrix(rows, last) => {
                let mut matrix = [[0.0, 0.0, 0.0, 1.0]; 4];
                for ((to, columns), at) in matrix.iter_mut().zip(rows).zip(translation.to_array()) {
                    *to = [value(columns[0])?, value(columns[1])?, value(columns[2])?, at];
                }
                for (to, column) in matrix[3].iter_mut().zip(last) {
                    if let Some(column) = column {
                        *to = value(*column)?;
                    }
                }
                Pose::nearest_to_matrix(matrix, limit)
            }
            RotationColumns::None => exact(Pose::new(Quat::ONE, translation)),
        };
        let index = poses.len();
        let of_row = |e| {
            if let Error::Pose(PoseError::ZeroRotation { .. }) = e {
                Error::Pose(PoseError::ZeroRotation { index })
            } else {
                e
            }
        };
        let (pose, off) = made
            .map_err(of_row)
            .map_err(|e: Error| row.fields[0].refused(source, e.to_string()).with_reason(e.reason()))?;
        if off > SIX_DECIMALS {
            let (count, start, most) = rounded.unwrap_or((0, row.fields[0].start, off));
            let worst = if off > most { (row.fields[0].start, off) } else { (start, most) };
            rounded = Some((count + 1, worst.0, worst.1));
        }
        poses.push(TablePose { time, pose });
        Ok(())
    })?;
    let (unit_hints, unit_not_applied) = (position.unit_hints(&table), position.unit_not_applied(&table));
    let seconds_assumed = clock.as_ref().and_then(Clock::seconds_assumed);
    notes.extend(clock.and_then(|clock| clock.note));
    let not_turned = columns.is_some_and(|columns| columns.iter().any(|name| name == LEFT_ASIDE))
        && matches!(rotation, RotationColumns::None);
    let taken_as_zero = zeros(&absent, not_turned);
    let rounded_matrices = rounded.map(|(count, start, off)| (count, source.line_of(start), off));
    Ok(PoseTable {
        poses,
        more_than_a_turn,
        whole_turns: turns,
        rounded_matrices,
        taken_as_zero,
        columns_taken,
        seconds_assumed,
        unit_hints,
        unit_not_applied,
        notes,
    })
}

/// The sentence about what no column says; `not_turned` where columns are left aside, and none of the others is a rotation.
fn zeros(absent: &[&str], not_turned: bool) -> Option<String> {
    let place = (!absent.is_empty()).then(|| format!("no column is named {}: taken as 0", absent.join(", ")));
    let turn = not_turned.then(|| {
        "`columns` ignores columns (`-`), and none of the others is a rotation: the poses are not rotated".to_owned()
    });
    let sentences: Vec<String> = place.into_iter().chain(turn).collect();
    (!sentences.is_empty()).then(|| sentences.join("; "))
}

/// Gives the columns of a table their names, where it has none or a document says them.
fn name_columns<'a>(
    table: &mut Table<'a>,
    columns: Option<&'a [String]>,
    notes: &mut Vec<String>,
) -> Result<Option<String>, Box<Diagnostic>> {
    let mut asked = None;
    let names: Vec<&'a str> = match columns {
        Some(columns) if columns.len() == table.width => columns.iter().map(String::as_str).collect(),
        Some(columns) => {
            let message = format!(
                "`columns` names {} columns, but the table has {}: write `-` for those that are not part of the pose",
                columns.len(),
                table.width
            );
            return Err(table.refused(message));
        }
        None if !table.header.is_empty() => return Ok(None),
        None => match Headless::of(table) {
            Headless::Certain(names, sentence) => {
                notes.push(format!("there is no header line, and {sentence}"));
                names
            }
            Headless::PerhapsFirst(names, sentence, question) => {
                notes.push(format!("there is no header line, and {sentence}"));
                asked = Some(question);
                names
            }
            Headless::QuaternionFirstOrLast => {
                return Err(table.refused(
                    "the table has no header line; its eight columns are a time, a position and a quaternion, whose w may be first or last: write in the document `\"columns\": [\"t\", \"x\", \"y\", \"z\", \"qx\", \"qy\", \
                     \"qz\", \"qw\"]` or `[\"t\", \"x\", \"y\", \"z\", \"qw\", \"qx\", \"qy\", \"qz\"]`",
                ));
            }
            Headless::Unknown => {
                return Err(table.refused(format!(
                    "a table of poses needs a header line with the names of its columns, or `\"columns\": […]` in the document, with a name for each column: {NAMES}"
                )));
            }
        },
    };
    let places: Vec<usize> = match table.header.is_empty() {
        true => table.first.iter().map(|field| field.start).collect(),
        false => table.header.iter().map(|field| field.start).collect(),
    };
    table.header = names.into_iter().zip(places).map(|(text, start)| Field { text, start }).collect();
    Ok(asked)
}
