//! Why there is no schedule.

/// Why a model has no schedule.
///
/// ```
/// use cyclide_io::{Document, schedule::{ScheduleError, ScheduleOptions, WorkshopSchedule}};
/// let text = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#;
/// let document: Document = text.parse()?;
/// let error = WorkshopSchedule::new(document.units, &document.build()?, &ScheduleOptions::default()).unwrap_err();
/// assert!(matches!(error, ScheduleError::NoNet { .. }) && error.to_string().ends_with("[no-net]"));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ScheduleError {
    /// No object is a net of panels, or none of the selected ones.
    #[error(
        "there is no net of panels to schedule: {why}; nets are `cyclidic-net`, `cyclide`, `cyclide-patch`, and `offset` or `transform` of these [no-net]"
    )]
    NoNet {
        /// What the objects are instead.
        why: String,
    },
    /// Parts of two objects would have the same names.
    #[error(
        "`{first}` and `{second}` would both have panels named `{name}-r00-c00`, …, since nets with several pieces number their panels that way: rename one of them [name-taken]"
    )]
    NameTaken {
        /// The beginning of the names.
        name: String,
        /// The object that comes first.
        first: String,
        /// The other one.
        second: String,
    },
    /// The kernel rejected a thickness, the depth of beams, or a measure.
    #[error("{object}: {source} [{}]", source.reason())]
    Geometry {
        /// The object.
        object: String,
        /// What the kernel said.
        source: cyclide::Error,
    },
    /// A file does not contain what it should: a bug in the program.
    #[error("{file}: {fault}")]
    Check {
        /// The file.
        file: String,
        /// What is wrong with it.
        fault: String,
    },
}
