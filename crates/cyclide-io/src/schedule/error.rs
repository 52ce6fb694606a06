//! Why there is no schedule.

/// Why a model has no schedule.
///
/// ```
/// use cyclide_io::{Document, ScheduleError, ScheduleOptions, WorkshopSchedule};
/// let text = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#;
/// let document: Document = text.parse()?;
/// let error = WorkshopSchedule::new(document.units, &document.build()?, &ScheduleOptions::default()).unwrap_err();
/// assert!(matches!(error, ScheduleError::NoNet { .. }) && error.to_string().ends_with("[no-net]"));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ScheduleError {
    /// No object is a net of panels, or none that was asked for.
    #[error(
        "there is no net of panels to schedule: {why}; nets are `cyclidic-net`, `cyclide`, `cyclide-patch`, and an `offset` or `transform` of these [no-net]"
    )]
    NoNet {
        /// What the objects are instead.
        why: String,
    },
    /// Parts of two objects would have the same names.
    #[error(
        "`{first}` and `{second}` would both have panels named `{name}-r00-c00`, …, as nets of several pieces count them: another name for one of them helps [name-taken]"
    )]
    NameTaken {
        /// What the names would begin with.
        name: String,
        /// The object that comes first.
        first: String,
        /// The other one.
        second: String,
    },
    /// The kernel refused a thickness, the depth of beams, or a measure.
    #[error("{object}: {source} [{}]", source.reason())]
    Geometry {
        /// The object.
        object: String,
        /// What the kernel said.
        source: cyclide::Error,
    },
    /// A file that was made does not hold what it should: a fault of the program.
    #[error("{file}: {fault}")]
    Check {
        /// The file.
        file: String,
        /// What is wrong with it.
        fault: String,
    },
}
