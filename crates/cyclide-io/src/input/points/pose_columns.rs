//! Which columns of a table of poses are what, by their names: units stand beside them as in tables of points.

use super::columns::Chosen;
use super::fields::Field;
use super::names::words_of;
use super::pose_clocks::{seconds_and_parts, take_clocks};
use super::pose_entries::{is_entry, take_entries};
use super::pose_names::{
    AMBIGUOUS, ANGLES, AXES, DEGREES, LOOK, MEANT, Meaning, NAMES, POSITION, QUATERNION, TimeUnit, meaning_with_unit,
};
use super::pose_places::{refuse_globe, take_places};
use super::pose_proposal::Proposal;
use super::table::Table;
use crate::text::place::{Diagnostic, Source, quoted};
use crate::text::suggest::did_you_mean;

/// The columns of a table of poses.
pub(super) struct PoseColumns {
    /// Those of the position, as the coordinates of points are.
    pub(super) position: Chosen,
    /// That of the time, with its unit.
    pub(super) time: Option<(usize, TimeUnit)>,
    /// That of whole nanoseconds beside seconds.
    pub(super) nanoseconds: Option<usize>,
    pub(super) rotation: RotationColumns,
    /// Names of coordinates and angles that no column has: they are 0.
    pub(super) absent: Vec<&'static str>,
    /// What columns in other words were taken for.
    pub(super) notes: Vec<String>,
}

/// How a table says rotations.
pub(super) enum RotationColumns {
    /// Columns of the quaternion.
    Quaternion([usize; 4]),
    /// Columns of roll, pitch and yaw, one at least, and what they are multiplied by.
    Angles([Option<usize>; 3], f64),
    /// Columns of the axis times the angle, and the radians of its unit.
    Vector([usize; 3], f64),
    /// Columns of the entries of a matrix: the rotation row by row, and the last row `0 0 0 1`, where it is given.
    Matrix([[usize; 3]; 3], [Option<usize>; 4]),
    /// No column: not turned.
    None,
}

impl PoseColumns {
    pub(super) fn new(source: Source<'_>, table: &Table<'_>) -> Result<Self, Box<Diagnostic>> {
        let unit = |i: usize| table.unit_words.get(i).map_or("", |field| field.text);
        let of = |(i, field): (usize, &Field<'_>)| meaning_with_unit(field, unit(i));
        let mut meanings: Vec<Option<Meaning>> = table.header.iter().enumerate().map(of).collect();
        leave_tangents(table, &mut meanings);
        let from_zero = take_entries(table, &mut meanings);
        take_bare_quaternion(table, &mut meanings);
        let mut notes = Vec::new();
        take_places(table, &mut meanings, &mut notes);
        refuse_globe(table, &meanings)?;
        take_clocks(table, &mut meanings);
        // What is not read could be what was meant.
        if let Some(other) = meanings.iter().position(Option::is_none) {
            let field = &table.header[other];
            if from_zero && is_entry(field.text) {
                let name = quoted(field.text);
                let message = format!(
                    "`{name}` is numbered from 1, and other entries from 0: name all entries m00 to m23, or all m11 to m34"
                );
                return Err(field.refused(source, message));
            }
            return Err(unknown(source, table, &meanings, other));
        }
        let only = |what: &str, fits: &dyn Fn(Meaning) -> bool| -> Result<Option<usize>, Box<Diagnostic>> {
            let all: Vec<usize> = (0..meanings.len()).filter(|&i| meanings[i].is_some_and(fits)).collect();
            match all.as_slice() {
                [] => Ok(None),
                [column] => Ok(Some(*column)),
                several => {
                    let names = table.names(several.iter().copied());
                    Err(table.header_refused(format!("several columns are {what}: {names}: keep only one of them")))
                }
            }
        };
        let needed = |name: &str, m: &dyn Fn(Meaning) -> bool| only(name, m)?.ok_or_else(|| table.no_column(name));
        let any = |fits: &dyn Fn(Meaning) -> bool| meanings.iter().flatten().any(|m| fits(*m));
        let is_quaternion = |m| matches!(m, Meaning::Quaternion(_));
        let is_angle = |m| matches!(m, Meaning::Angle(..));
        let is_vector = |m| matches!(m, Meaning::Vector(..));
        let is_matrix = |m| matches!(m, Meaning::Matrix(..));
        let from = usize::from(!from_zero);
        let entry = |i: usize, j: usize| needed(&format!("m{}{}", i + from, j + from), &|m| m == Meaning::Matrix(i, j));
        // Beside a quaternion a matrix says the same again.
        let by_matrix = any(&is_matrix) && !any(&is_quaternion);
        let placed = any(&|m| matches!(m, Meaning::Position(_)));
        let is_of = |axis: &str| table.header.iter().any(|field| is_of(field, axis));
        if by_matrix && is_of(AXES[0]) && !is_of(AXES[1]) {
            return Err(table.header_refused(
                "these are points of a curve with tangents, but poses need frames: `cyclide sample --frames KIND` writes them, and `along` moves a body along the curve itself",
            ));
        }
        if by_matrix && placed && any(&|m| matches!(m, Meaning::Matrix(0..=2, 3))) {
            return Err(table.header_refused(
                "the positions are given twice, as x, y, z and as m14, m24, m34: keep the columns of one form",
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
        let position = Chosen { coordinates, contour: None, corner: None, label: None, remark: None };
        position.refuse_several_units(table)?;
        let (time, nanoseconds) = Self::time(table, &meanings)?;
        if any(&is_vector) && (any(&is_quaternion) || any(&is_angle) || by_matrix) {
            return Err(table.header_refused(
                "the rotations are given twice, as rotation vectors and in another form: keep the columns of one form",
            ));
        }
        let rotation = match (any(&is_quaternion), any(&is_angle)) {
            (true, true) => {
                return Err(table.header_refused(
                    "the rotations are given twice, as quaternions and as angles: keep the columns of one form",
                ));
            }
            (false, true) if by_matrix => {
                return Err(table.header_refused(
                    "the rotations are given twice, as angles and as a matrix: keep the columns of one form",
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
                let given: Vec<usize> = columns.into_iter().flatten().collect();
                RotationColumns::Angles(columns, common_unit(table, &meanings, &given)?)
            }
            (false, false) if any(&is_vector) => {
                let column = |i: usize| {
                    needed(
                        ["rotvec_x", "rotvec_y", "rotvec_z"][i],
                        &|m| matches!(m, Meaning::Vector(own, _) if own == i),
                    )
                };
                let columns = [column(0)?, column(1)?, column(2)?];
                RotationColumns::Vector(columns, common_unit(table, &meanings, &columns)?)
            }
            (false, false) if by_matrix => {
                let row = |i: usize| Ok::<_, Box<Diagnostic>>([entry(i, 0)?, entry(i, 1)?, entry(i, 2)?]);
                let last = |j: usize| only(&format!("m4{}", j + 1), &|m| m == Meaning::Matrix(3, j));
                RotationColumns::Matrix([row(0)?, row(1)?, row(2)?], [last(0)?, last(1)?, last(2)?, last(3)?])
            }
            (false, false) => RotationColumns::None,
        };
        Ok(Self { position, time, nanoseconds, rotation, absent, notes })
    }

    /// The time, and whole nanoseconds beside seconds. Of several the stamp of the message counts, not when it was recorded.
    fn time(
        table: &Table<'_>,
        meanings: &[Option<Meaning>],
    ) -> Result<(Option<TimeColumn>, Option<usize>), Box<Diagnostic>> {
        let mut times: Vec<TimeColumn> = Vec::new();
        for (column, meaning) in meanings.iter().enumerate() {
            if let Some(Meaning::Time(unit)) = meaning {
                times.push((column, *unit));
            }
        }
        let of_message =
            |(column, _): &TimeColumn| words_of(table.header[*column].text).0.contains(&"stamp".to_owned());
        if times.len() > 1 && times.iter().any(of_message) {
            times.retain(of_message);
        }
        match times.as_slice() {
            [] => Ok((None, None)),
            [only] => Ok((Some(*only), None)),
            several => {
                if let Some([seconds, parts]) = seconds_and_parts(several) {
                    return Ok((Some((seconds, TimeUnit::PerSecond(1.0))), Some(parts)));
                }
                let names = table.names(several.iter().map(|(column, _)| *column));
                Err(table.header_refused(format!("several columns are the time: {names}: keep only one of them")))
            }
        }
    }
}

/// A column of times and its unit.
type TimeColumn = (usize, TimeUnit);

/// The refusal of a column that is nothing known, with the columns to type instead; where those would be refused too, with that refusal, which says what
/// to do.
fn unknown(source: Source<'_>, table: &Table<'_>, meanings: &[Option<Meaning>], other: usize) -> Box<Diagnostic> {
    let field = &table.header[other];
    let known = ["t", "time"].into_iter().chain(POSITION).chain(QUATERNION).chain(ANGLES).chain(DEGREES);
    let (words, _) = words_of(field.text);
    let ambiguous = words.first().is_some_and(|word| AMBIGUOUS.contains(&word.as_str()));
    let hint = if ambiguous { MEANT.to_owned() } else { did_you_mean(field.text, known) };
    let proposal = Proposal::new(table, meanings);
    let refusal = proposal.typed(table).and_then(|typed| PoseColumns::new(source, &typed).err());
    let remedy = match refusal {
        Some(refusal) => format!("; besides, the other columns are not a table of poses: {}", refusal.message),
        None => {
            format!("; or name every column (`-` for one that is not part of the pose), in the document {proposal}")
        }
    };
    field.refused(source, format!("`{}` is not a column of poses, which are {NAMES}{hint}{remedy}", quoted(field.text)))
}

/// The radians of the unit of some angles.
///
/// # Errors
/// Of angles in several units.
fn common_unit(table: &Table<'_>, meanings: &[Option<Meaning>], columns: &[usize]) -> Result<f64, Box<Diagnostic>> {
    let unit = |column: &usize| match meanings[*column] {
        Some(Meaning::Angle(_, unit) | Meaning::Vector(_, unit)) => Some(unit),
        _ => None,
    };
    let units: Vec<f64> = columns.iter().filter_map(unit).collect();
    if units.iter().any(|unit| unit.total_cmp(&units[0]).is_ne()) {
        let names = table.names(columns.iter().copied());
        let message = format!("the columns {names} have different units (without a unit angles are in radians)");
        return Err(table.header_refused(message));
    }
    Ok(units.first().copied().unwrap_or(1.0))
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

/// Where places have other names, `px, py, pz`, a bare `x, y, z, w` is the quaternion.
fn take_bare_quaternion(table: &Table<'_>, meanings: &mut [Option<Meaning>]) {
    let is_bare = |column: usize, letter: &str| matches!(words_of(table.header[column].text).0.as_slice(), [only] if only == letter);
    let only = |fits: &dyn Fn(usize) -> bool| {
        let mut all = (0..table.header.len()).filter(|column| fits(*column));
        all.next().filter(|_| all.next().is_none())
    };
    let bare = ["w", "x", "y", "z"].map(|letter| only(&|column| is_bare(column, letter)));
    let is_placed = |axis: usize| {
        let other = |column: usize| meanings[column] == Some(Meaning::Position(axis)) && bare[axis + 1] != Some(column);
        only(&other).is_some()
    };
    let is_turned = meanings.iter().any(|meaning| matches!(meaning, Some(Meaning::Quaternion(_))));
    if let [Some(w), Some(x), Some(y), Some(z)] = bare
        && (0..3).all(is_placed)
        && meanings[w].is_none()
        && !is_turned
    {
        [w, x, y, z].into_iter().zip(0..).for_each(|(column, k)| meanings[column] = Some(Meaning::Quaternion(k)));
    }
}
