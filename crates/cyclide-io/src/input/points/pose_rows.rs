//! The lines of a table of poses, one by one: the time and the pose of each.

use std::f64::consts::TAU;

use cyclide::{Error, Quat, Vec3, error::PoseError, motion::Pose};

use super::clock::Clock;
use super::decimals::Decimals;
use super::pose_columns::{PoseColumns, RotationColumns};
use super::poses::{SIX_DECIMALS, TURN_DIGITS, whole_turns};
use super::table::{Row, Table};
use crate::text::place::{Diagnostic, Source};

/// Reads lines, and remembers what is to be said of them.
pub(super) struct PoseRows<'a> {
    source: Source<'a>,
    columns: &'a PoseColumns,
    /// How far a matrix may be from a rotation.
    limit: f64,
    decimals: Decimals,
    pub(super) clock: Option<Clock>,
    /// The line of the first angle in radians that is more than a turn, and the angle.
    pub(super) more_than_a_turn: Option<(usize, f64)>,
    /// The angles of the line before.
    turned: Option<[f64; 3]>,
    /// The line of the first angle that may have gone the longer way, and its change.
    pub(super) whole_turns: Option<(usize, f64)>,
    pub(super) rounded: Option<Rounded>,
}

/// Matrices with few decimals: how many, where the worst one is, and how far it is off.
pub(super) struct Rounded {
    pub(super) count: usize,
    pub(super) start: usize,
    pub(super) off: f64,
}

impl<'a> PoseRows<'a> {
    pub(super) fn new(
        source: Source<'a>,
        table: &Table<'_>,
        columns: &'a PoseColumns,
        limit: f64,
    ) -> Result<Self, Box<Diagnostic>> {
        Ok(Self {
            source,
            columns,
            limit,
            decimals: Decimals::of(source, table, None)?,
            clock: columns.time.map(|(_, unit)| Clock::new(unit)),
            more_than_a_turn: None,
            turned: None,
            whole_turns: None,
            rounded: None,
        })
    }

    /// The time of a line, which has to be after another one.
    pub(super) fn time(&mut self, row: &Row<'_, '_>, before: Option<f64>) -> Result<Option<f64>, Box<Diagnostic>> {
        let (Some((column, _)), Some(clock)) = (self.columns.time, &mut self.clock) else { return Ok(None) };
        let field = |column| row.field(self.source, column, "number");
        let parts = self.columns.nanoseconds.map(field).transpose()?;
        let time = clock.read(self.source, &mut self.decimals, &field(column)?, parts.as_ref())?;
        if let Some(before) = before.filter(|before| time <= *before) {
            let message = format!("the times do not increase: {time} seconds, after {before}{}", clock.past_midnight());
            return Err(row.fields[column].refused(self.source, message).with_reason("parameters-not-increasing"));
        }
        Ok(Some(time))
    }

    fn value(&mut self, row: &Row<'_, '_>, column: usize) -> Result<f64, Box<Diagnostic>> {
        self.decimals.read(self.source, &row.field(self.source, column, "number")?)
    }

    fn values<const N: usize>(&mut self, row: &Row<'_, '_>, columns: [usize; N]) -> Result<[f64; N], Box<Diagnostic>> {
        let mut values = [0.0; N];
        for (value, column) in values.iter_mut().zip(columns) {
            *value = self.value(row, column)?;
        }
        Ok(values)
    }

    /// The pose of a line; `index` is its number.
    pub(super) fn pose(&mut self, row: &Row<'_, '_>, index: usize) -> Result<Pose, Box<Diagnostic>> {
        let coordinates = &self.columns.position.coordinates;
        let mut place = [0.0; 3];
        for (coordinate, column) in place.iter_mut().zip(coordinates) {
            *coordinate = self.value(row, *column)?;
        }
        let of_row = |error| match error {
            Error::Pose(PoseError::ZeroRotation { .. }) => Error::Pose(PoseError::ZeroRotation { index }),
            other => other,
        };
        let (pose, off) = self.turned(row, Vec3::from(place))?.map_err(|error| {
            let error = of_row(error);
            row.fields[0].refused(self.source, error.to_string()).with_reason(error.reason())
        })?;
        if off > SIX_DECIMALS {
            let start = row.fields[0].start;
            let rounded = self.rounded.get_or_insert(Rounded { count: 0, start, off });
            rounded.count += 1;
            if off > rounded.off {
                (rounded.start, rounded.off) = (start, off);
            }
        }
        Ok(pose)
    }

    /// The pose at a place, turned as a line says, and how far its matrix is off.
    fn turned(&mut self, row: &Row<'_, '_>, place: Vec3) -> Result<cyclide::Result<(Pose, f64)>, Box<Diagnostic>> {
        let exact = |made: cyclide::Result<Pose>| made.map(|pose| (pose, 0.0));
        Ok(match &self.columns.rotation {
            RotationColumns::Quaternion(columns) => {
                let [w, x, y, z] = self.values(row, *columns)?;
                exact(Pose::new(Quat::new(w, x, y, z), place))
            }
            RotationColumns::Angles(columns, unit) => {
                let mut angles = [0.0; 3];
                for (angle, column) in angles.iter_mut().zip(columns) {
                    if let Some(column) = column {
                        *angle = self.value(row, *column)?;
                    }
                }
                let wide = angles.into_iter().find(|angle| *unit >= 1.0 && angle.abs() > TAU);
                self.note_angle(row, wide);
                let angles = angles.map(|angle| angle * unit);
                let change = self.turned.and_then(|before| whole_turns(before, angles));
                if let (Some((_, change)), None) = (change, self.whole_turns) {
                    self.whole_turns = Some((self.source.line_of(row.fields[0].start), change));
                }
                self.turned = Some(angles);
                exact(Pose::from_roll_pitch_yaw(place, angles))
            }
            RotationColumns::Vector(columns, unit) => {
                let vector = Vec3::from(self.values(row, *columns)?) * *unit;
                let angle = vector.length();
                self.note_angle(row, (*unit >= 1.0 && angle > TAU + TURN_DIGITS).then_some(angle));
                let rotation = if angle > 0.0 { Quat::from_axis_angle(vector / angle, angle) } else { Quat::ONE };
                exact(Pose::new(rotation, place))
            }
            RotationColumns::Matrix(rows, last) => {
                let mut matrix = [[0.0, 0.0, 0.0, 1.0]; 4];
                for ((to, columns), at) in matrix.iter_mut().zip(rows).zip(place.to_array()) {
                    let [a, b, c] = self.values(row, *columns)?;
                    *to = [a, b, c, at];
                }
                for (to, column) in matrix[3].iter_mut().zip(last) {
                    if let Some(column) = column {
                        *to = self.value(row, *column)?;
                    }
                }
                Pose::nearest_to_matrix(matrix, self.limit)
            }
            RotationColumns::None => exact(Pose::new(Quat::ONE, place)),
        })
    }

    /// Remembers the first angle of more than a turn, with its line.
    fn note_angle(&mut self, row: &Row<'_, '_>, angle: Option<f64>) {
        if let (Some(angle), None) = (angle, self.more_than_a_turn) {
            self.more_than_a_turn = Some((self.source.line_of(row.fields[0].start), angle));
        }
    }
}
