//! Tables of poses: columns by their names.

use cyclide::{Pose, Quat, Vec3};

use super::decimals::Decimals;
use super::table::Table;
use crate::text::place::{Diagnostic, Source, decode, quoted};

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
}

/// How a table says rotations.
enum RotationColumns {
    /// Columns of the quaternion.
    Quaternion([usize; 4]),
    /// Columns of roll, pitch and yaw, and what they are multiplied by.
    Angles([usize; 3], f64),
    /// No column: not turned.
    None,
}

/// Reads a table of poses.
///
/// # Errors
/// A message with file, line and column: no header, a missing column, a field that is no finite number, a rotation of zero.
pub(crate) fn read_poses(name: &str, bytes: &[u8]) -> Result<PoseTable, Box<Diagnostic>> {
    let source = Source { name, text: decode(name, bytes)? };
    let table = Table::parse(source, &["qw".to_owned(), "yaw".to_owned(), "t".to_owned()])?;
    if table.header.is_empty() {
        return Err(table.refused(
            "a table of poses needs a header line with the names of its columns: t, x, y, z, and qw, qx, qy, qz or roll, pitch, yaw \
             (roll_deg, pitch_deg, yaw_deg in degrees)",
        ));
    }
    let column = |name: &str| table.header.iter().position(|field| field.text.eq_ignore_ascii_case(name));
    let needed = |name: &str| column(name).ok_or_else(|| table.no_column(name));
    let position = [needed("x")?, needed("y")?, needed("z")?];
    let time = column("t").or_else(|| column("time"));
    let rotation = if column("qw").is_some() {
        RotationColumns::Quaternion([needed("qw")?, needed("qx")?, needed("qy")?, needed("qz")?])
    } else if column("roll_deg").is_some() {
        let degrees = std::f64::consts::PI / 180.0;
        RotationColumns::Angles([needed("roll_deg")?, needed("pitch_deg")?, needed("yaw_deg")?], degrees)
    } else if column("roll").is_some() {
        RotationColumns::Angles([needed("roll")?, needed("pitch")?, needed("yaw")?], 1.0)
    } else {
        RotationColumns::None
    };
    let mut read = position.to_vec();
    read.extend(time);
    match &rotation {
        RotationColumns::Quaternion(columns) => {
            read.extend(columns);
            // Our own tables have the matrix of the pose beside it.
            let is_entry =
                |name: &str| (1..=3).any(|i| (1..=4).any(|j| name.eq_ignore_ascii_case(&format!("m{i}{j}"))));
            read.extend((0..table.header.len()).filter(|&column| is_entry(table.header[column].text)));
        }
        RotationColumns::Angles(columns, _) => read.extend(columns),
        RotationColumns::None => {}
    }
    // What is not read could be what was meant.
    if let Some(other) = (0..table.header.len()).find(|column| !read.contains(column)) {
        let name = quoted(table.header[other].text);
        return Err(table.header[other].refused(
            source,
            format!("`{name}` is no column of poses: t or time, x, y, z, and qw, qx, qy, qz or roll, pitch, yaw (with _deg in degrees)"),
        ));
    }
    let mut decimals = Decimals::default();
    let (mut poses, mut more_than_a_turn) = (Vec::new(), None);
    table.for_each_row(|row| {
        if poses.len() == MOST_POSES {
            return Err(row.fields[0].refused(source, format!("the file has more than {MOST_POSES} poses")));
        }
        let mut value = |column: usize| decimals.read(source, &row.field(source, column, "number")?);
        let translation = Vec3::new(value(position[0])?, value(position[1])?, value(position[2])?);
        let time = time.map(&mut value).transpose()?;
        let made = match &rotation {
            RotationColumns::Quaternion([w, x, y, z]) => {
                Pose::new(Quat::new(value(*w)?, value(*x)?, value(*y)?, value(*z)?), translation)
            }
            RotationColumns::Angles([roll, pitch, yaw], unit) => {
                let angles = [value(*roll)?, value(*pitch)?, value(*yaw)?];
                let wide = angles.into_iter().find(|angle| *unit >= 1.0 && angle.abs() > std::f64::consts::TAU);
                if let (Some(angle), None) = (wide, more_than_a_turn) {
                    more_than_a_turn = Some((source.line_of(row.fields[0].start), angle));
                }
                Pose::from_roll_pitch_yaw(translation, angles.map(|angle| angle * unit))
            }
            RotationColumns::None => Pose::new(Quat::ONE, translation),
        };
        let pose = made.map_err(|e| row.fields[0].refused(source, e.to_string()).with_reason(e.reason()))?;
        poses.push(TablePose { time, pose });
        Ok(())
    })?;
    Ok(PoseTable { poses, more_than_a_turn })
}
