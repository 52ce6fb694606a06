//! Sentences of warnings that depend on what was measured.

use crate::short_number::ShortNumber;

pub(super) fn write_nodes_not_reached(
    f: &mut std::fmt::Formatter<'_>,
    asked: usize,
    reached: usize,
    why: &str,
) -> std::fmt::Result {
    let because = match why {
        "tolerance" => "the points need them within the tolerance",
        "budget" => "fewer would cost more fairness than the budget allows: raise it",
        "max-fits" => "the fits for taking nodes out are spent: allow more",
        "first-fit" => "the tolerance is reached with as few",
        _ => "a curve cannot have fewer",
    };
    write!(f, "{asked} nodes were asked for, {reached} it has: {because}")
}

/// Which ends are off the axis, and how to get a solid.
pub(super) fn write_open_profile(f: &mut std::fmt::Formatter<'_>, start: f64, end: f64) -> std::fmt::Result {
    match (start > 0.0, end > 0.0) {
        (true, true) => write!(
            f,
            "the surface is open: its profile starts {} and ends {} off the axis",
            ShortNumber(start),
            ShortNumber(end)
        ),
        (true, false) => write!(f, "the surface is open: its profile starts {} off the axis", ShortNumber(start)),
        _ => write!(f, "the surface is open: its profile ends {} off the axis", ShortNumber(end)),
    }?;
    f.write_str("; a solid needs a closed profile, or both ends on the axis")
}

pub(super) fn times(count: usize) -> String {
    if count == 1 { "once".to_owned() } else { format!("{count} times") }
}

/// The relaxed segments by the points they join, with the range of their blends.
pub(super) fn write_relaxed(f: &mut std::fmt::Formatter<'_>, segments: &[(usize, f64)]) -> std::fmt::Result {
    let least = segments.iter().map(|(_, e)| *e).fold(1.0, f64::min);
    let largest = segments.iter().map(|(_, e)| *e).fold(0.0, f64::max);
    match segments {
        [] => return f.write_str("no segment is relaxed"),
        [(one, _)] => write!(f, "behind point {one} the fairest curve would swing out, so it is less fair there"),
        [(first, _), .., (last, _)] => write!(
            f,
            "on {} segments, behind the points {first} to {last}, the fairest curve would swing out, so it is less fair there",
            segments.len()
        ),
    }?;
    let (least, largest) = (ShortNumber(least), ShortNumber(largest));
    write!(f, " (blend {least}")?;
    if least != largest {
        write!(f, " to {largest}")?;
    }
    f.write_str(" where 1 is the fairest); if the points turn sharply on purpose, mark them as corners")
}

/// Four digits of a positive value, not more than it is: a limit that is kept by what is said.
pub(super) fn rounded_down(value: f64) -> f64 {
    let unit = 10.0_f64.powf(value.log10().floor() - 3.0);
    let down = (value / unit).floor() * unit;
    if down.is_finite() && down > 0.0 { down } else { value }
}
