//! Tables of poses: columns by their names.

use cyclide::{model::Units, motion::Pose};
use std::f64::consts::{PI, TAU};

use super::clock::Clock;
use super::fields::Field;
use super::headless::Headless;
use super::pose_columns::{PoseColumns, RotationColumns};
use super::pose_names::{LEFT_ASIDE, NAMES, is_of_pose};
use super::pose_rows::PoseRows;
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
pub(super) const TURN_DIGITS: f64 = 2e-6;

/// Angles that differ by less than this either come round or go the longer way, which nobody can tell: the shorter way is a right angle or more.
const LONGER_WAY: f64 = 1.5 * PI;

/// Which of three angles, in radians, differs by more than half a turn from that of the pose before, and by how much: turns that no pose can say. Angles within
/// half a turn of 0 that do so come round there, as headings do, and so do those that differ by almost a turn.
pub(crate) fn whole_turns(before: [f64; 3], angles: [f64; 3]) -> Option<(usize, f64)> {
    let differs = |k: &usize| {
        let change = (angles[*k] - before[*k]).abs();
        let is_longer = change > PI + TURN_DIGITS && change < LONGER_WAY || change >= TAU - TURN_DIGITS;
        angles[*k].abs() > PI + TURN_DIGITS && is_longer
    };
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
    let mut columns_read = PoseColumns::new(source, &table)?;
    notes.append(&mut columns_read.notes);
    let mut rows = PoseRows::new(source, &table, &columns_read, limit)?;
    let mut poses: Vec<TablePose> = Vec::new();
    table.for_each_row(|row| {
        if poses.len() == MOST_POSES {
            return Err(row.fields[0].refused(source, format!("the file has more than {MOST_POSES} poses")));
        }
        let before = if rising { poses.last().and_then(|pose| pose.time) } else { None };
        let time = rows.time(row, before)?;
        let pose = rows.pose(row, poses.len())?;
        poses.push(TablePose { time, pose });
        Ok(())
    })?;
    let PoseRows { clock, more_than_a_turn, whole_turns, rounded, .. } = rows;
    let PoseColumns { position, rotation, absent, .. } = columns_read;
    let (unit_hints, unit_not_applied) = (position.unit_hints(&table), position.unit_not_applied(&table));
    let seconds_assumed = clock.as_ref().and_then(Clock::seconds_assumed);
    notes.extend(clock.and_then(|clock| clock.note));
    let not_turned = columns.is_some_and(|columns| columns.iter().any(|name| name == LEFT_ASIDE))
        && matches!(rotation, RotationColumns::None);
    let rounded_matrices = rounded.map(|found| (found.count, source.line_of(found.start), found.off));
    Ok(PoseTable {
        poses,
        more_than_a_turn,
        whole_turns,
        rounded_matrices,
        taken_as_zero: zeros(&absent, not_turned),
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
