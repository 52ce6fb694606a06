//! What documents and the command write to follow the advice of the kernel, which knows neither.

use cyclide::{
    Error, Warning,
    error::{FitError, NumberError, PatchError, PrincipalGridError},
    warning::{NoiseWarning, PoseFitWarning},
};

const PIECES: &str = "; write `\"umbilics\": \"pieces\"`";

/// The sentence of an error of the kernel, and what to write.
pub(crate) fn words_of(error: &Error) -> String {
    let hint = match error {
        Error::Fit(FitError::OutliersOutside { .. }) => {
            "; `--outliers drop` (in a document `\"outliers\": \"drop\"`) leaves them out"
        }
        Error::Fit(FitError::NoG1SplineInTube { .. }) => {
            "; `--smooth auto` (in a document a `fair-fit` with `\"tolerance\": \"auto\"`) smooths noisy points"
        }
        Error::Number(NumberError::AngleOutOfRange { angle, .. }) if *angle != 0.0 => {
            "; degrees are written `{\"degrees\": 90}`"
        }
        Error::Patch(PatchError::OffsetNotRegular { limit, .. }) if *limit != 0.0 => {
            "; `cyclide report` lists the radii of curvature"
        }
        Error::PrincipalGrid(error) => of_grids(error),
        _ => "",
    };
    format!("{error}{hint}")
}

fn of_grids(error: &PrincipalGridError) -> &'static str {
    match error {
        PrincipalGridError::UmbilicsRemain { .. } => {
            "; write `\"umbilics\": \"pieces\"`, or `\"joined\"` with `\"border\": \"inside\"` or `\"staircase\"`"
        }
        PrincipalGridError::UmbilicsNotJoined { .. } | PrincipalGridError::FieldNotOrientable { .. } => PIECES,
        PrincipalGridError::SpiralLines { .. } => "; write `\"closed\": true` or `\"closed\": false`",
        _ => "",
    }
}

/// The sentence of a warning of the kernel, and what to write.
pub(crate) fn words_of_warning(warning: &Warning) -> String {
    let hint = match warning {
        Warning::Noise(NoiseWarning::Outlier { dropped: false, .. }) => {
            "; `--outliers drop` leaves it out (in a document `\"outliers\": \"drop\"`)"
        }
        Warning::PoseFit(PoseFitWarning::Outlier { dropped: false, .. }) => "; `\"outliers\": \"drop\"` leaves it out",
        Warning::PoseFit(PoseFitWarning::Swings { .. }) => {
            "; poses without a `time` get such times from `\"times\": \"chord\"`"
        }
        Warning::Noise(NoiseWarning::BeyondNoise { .. }) => BY_NOISE,
        Warning::Noise(warning @ NoiseWarning::LeansOnWalls { .. }) if warning.is_of_noisy_points() => BY_NOISE,
        _ => "",
    };
    format!("{warning}{hint}")
}

const BY_NOISE: &str = "; `--smooth auto` (in a document `\"tolerance\": \"auto\"`) follows it";
