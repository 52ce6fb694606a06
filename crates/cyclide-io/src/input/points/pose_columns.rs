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
        let read = Meanings { table, of: &meanings, from: usize::from(!from_zero) };
        read.refuse_contradictions()?;
        let mut absent = Vec::new();
        let position = read.position(&mut absent)?;
        let (time, nanoseconds) = Self::time(table, &meanings)?;
        if time.is_none() {
            notes.extend(uneven_count(table, &meanings));
        }
        let rotation = read.rotation(&mut absent)?;
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

/// What the columns of a table are.
struct Meanings<'a> {
    table: &'a Table<'a>,
    of: &'a [Option<Meaning>],
    /// The number of the first row and column of matrices.
    from: usize,
}

impl Meanings<'_> {
    fn any(&self, fits: impl Fn(Meaning) -> bool) -> bool {
        self.of.iter().flatten().any(|meaning| fits(*meaning))
    }

    /// The only column of a meaning, if there is one.
    fn only(&self, what: &str, fits: impl Fn(Meaning) -> bool) -> Result<Option<usize>, Box<Diagnostic>> {
        let all: Vec<usize> = (0..self.of.len()).filter(|&i| self.of[i].is_some_and(&fits)).collect();
        match all.as_slice() {
            [] => Ok(None),
            [column] => Ok(Some(*column)),
            several => {
                let names = self.table.names(several.iter().copied());
                Err(self.table.header_refused(format!("several columns are {what}: {names}: keep only one of them")))
            }
        }
    }

    fn needed(&self, name: &str, meaning: Meaning) -> Result<usize, Box<Diagnostic>> {
        self.only(name, |own| own == meaning)?.ok_or_else(|| self.table.no_column(name))
    }

    fn entry(&self, row: usize, column: usize) -> Result<usize, Box<Diagnostic>> {
        let name = format!("m{}{}", row + self.from, column + self.from);
        self.needed(&name, Meaning::Matrix(row, column))
    }

    fn has_quaternion(&self) -> bool {
        self.any(|m| matches!(m, Meaning::Quaternion(_)))
    }

    fn has_angles(&self) -> bool {
        self.any(|m| matches!(m, Meaning::Angle(..)))
    }

    fn has_vector(&self) -> bool {
        self.any(|m| matches!(m, Meaning::Vector(..)))
    }

    /// Beside a quaternion a matrix says the same again.
    fn is_by_matrix(&self) -> bool {
        self.any(|m| matches!(m, Meaning::Matrix(..))) && !self.has_quaternion()
    }

    fn is_placed(&self) -> bool {
        self.any(|m| matches!(m, Meaning::Position(_)))
    }

    /// Refuses what is given twice, and what is no pose.
    fn refuse_contradictions(&self) -> Result<(), Box<Diagnostic>> {
        let is_of = |axis: &str| self.table.header.iter().any(|field| is_of(field, axis));
        let by_matrix = self.is_by_matrix();
        let fault = if by_matrix && is_of(AXES[0]) && !is_of(AXES[1]) {
            "these are points of a curve with tangents, but poses need frames: `cyclide sample --frames KIND` writes them, and `along` moves a body along the curve itself"
        } else if by_matrix && self.is_placed() && self.any(|m| matches!(m, Meaning::Matrix(0..=2, 3))) {
            "the positions are given twice, as x, y, z and as m14, m24, m34: keep the columns of one form"
        } else if self.has_vector() && (self.has_quaternion() || self.has_angles() || by_matrix) {
            "the rotations are given twice, as rotation vectors and in another form: keep the columns of one form"
        } else if self.has_quaternion() && self.has_angles() {
            "the rotations are given twice, as quaternions and as angles: keep the columns of one form"
        } else if self.has_angles() && by_matrix {
            "the rotations are given twice, as angles and as a matrix: keep the columns of one form"
        } else {
            return Ok(());
        };
        Err(self.table.header_refused(fault))
    }

    /// The columns of the place; in the plane without a height.
    fn position(&self, absent: &mut Vec<&'static str>) -> Result<Chosen, Box<Diagnostic>> {
        let coordinates = if self.is_by_matrix() && !self.is_placed() {
            vec![self.entry(0, 3)?, self.entry(1, 3)?, self.entry(2, 3)?]
        } else {
            let in_plane = [0, 1].map(|axis| self.needed(POSITION[axis], Meaning::Position(axis)));
            let [x, y] = in_plane;
            let height = self.only(POSITION[2], |m| m == Meaning::Position(2))?;
            if height.is_none() {
                absent.push(POSITION[2]);
            }
            [x?, y?].into_iter().chain(height).collect()
        };
        let position = Chosen { coordinates, contour: None, corner: None, label: None, remark: None };
        position.refuse_several_units(self.table)?;
        Ok(position)
    }

    /// The columns of the rotation.
    fn rotation(&self, absent: &mut Vec<&'static str>) -> Result<RotationColumns, Box<Diagnostic>> {
        if self.has_quaternion() {
            let column = |i: usize| self.needed(QUATERNION[i], Meaning::Quaternion(i));
            return Ok(RotationColumns::Quaternion([column(0)?, column(1)?, column(2)?, column(3)?]));
        }
        if self.has_angles() {
            let column = |i: usize| self.only(ANGLES[i], |m| matches!(m, Meaning::Angle(own, _) if own == i));
            let columns = [column(0)?, column(1)?, column(2)?];
            absent.extend((0..3).filter(|i| columns[*i].is_none()).map(|i| ANGLES[i]));
            let given: Vec<usize> = columns.into_iter().flatten().collect();
            return Ok(RotationColumns::Angles(columns, common_unit(self.table, self.of, &given)?));
        }
        if self.has_vector() {
            let column = |i: usize| {
                let name = ["rotvec_x", "rotvec_y", "rotvec_z"][i];
                let found = self.only(name, |m| matches!(m, Meaning::Vector(own, _) if own == i))?;
                found.ok_or_else(|| self.table.no_column(name))
            };
            let columns = [column(0)?, column(1)?, column(2)?];
            return Ok(RotationColumns::Vector(columns, common_unit(self.table, self.of, &columns)?));
        }
        if self.is_by_matrix() {
            let row = |i: usize| Ok::<_, Box<Diagnostic>>([self.entry(i, 0)?, self.entry(i, 1)?, self.entry(i, 2)?]);
            let last = |j: usize| self.only(&format!("m4{}", j + 1), |m| m == Meaning::Matrix(3, j));
            return Ok(RotationColumns::Matrix([row(0)?, row(1)?, row(2)?], [last(0)?, last(1)?, last(2)?, last(3)?]));
        }
        Ok(RotationColumns::None)
    }
}

/// The sentence about a column that counts with gaps, where no other is a time.
fn uneven_count(table: &Table<'_>, meanings: &[Option<Meaning>]) -> Option<String> {
    let counts = |i: &usize| meanings[*i] == Some(Meaning::Label) && has_gaps(table, *i);
    let column = (0..table.header.len()).find(counts)?;
    let name = quoted(table.header[column].text);
    Some(format!(
        "the poses have no time and are spaced evenly, but `{name}` rises in unequal steps: if it counts the time, give its column the name `t` (in the document `columns`)"
    ))
}

/// True if the numbers of a column rise, and not by equal steps.
fn has_gaps(table: &Table<'_>, column: usize) -> bool {
    let mut numbers: Vec<Option<f64>> = Vec::new();
    table.for_first_rows(|fields| {
        numbers.push(fields.get(column).and_then(|field| field.text.parse().ok()));
        numbers.len() < LOOKED_AT
    });
    let Some(numbers) = numbers.into_iter().collect::<Option<Vec<f64>>>() else { return false };
    let steps: Vec<f64> = numbers.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let is_uneven = steps.windows(2).any(|pair| (pair[1] - pair[0]).abs() > 1e-9 * pair[0].abs());
    is_uneven && steps.iter().all(|step| *step > 0.0)
}

/// Lines that are looked at for gaps.
const LOOKED_AT: usize = 1000;

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
